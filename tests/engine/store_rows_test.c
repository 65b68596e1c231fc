/* store_rows_test.c -- the edges of the store: many rows, narrow versions,
 * views, lists, terms, members, ids. */
#include "asked.h"
#include "engine/store.h"
#include "engine/term.h"
#include "tests/check.h"
#include "vertices.h"

#include <math.h>
#include <stdlib.h>

/* ---- many rows: sweeps, slots used again, bulk loads -------------------- */

enum { MANY = 5000 };

static void
test_sweep(void)
{
  sg_world *world = sg_world_open();
  const sg_version *old;
  sg_statistics before, after;
  bool right = fill_vertices(world, 1, 1, MANY);

  old = sg_world_version(world);
  sg_world_statistics(world, SG_V, &before);
  for (int32_t round = 0; right && round < 20; round++) {
    for (int32_t v = 1; v <= MANY; v += 2) {
      right = right && sg_world_retract(world, SG_V, find_vertex(world, 1, v));
    }
    for (int32_t v = 1; right && v <= MANY; v += 2) {
      sg_value row[SG_MAX_COLUMNS] = {{.i = 1}, {.i = v}, {.f = round}};
      right = sg_world_add(world, SG_V, row, NULL, NULL) == SG_OK;
    }
    right = right && sg_world_is_valid(world);
  }
  CHECK("rows are retracted and added again", right);
  CHECK("all are there", count(world, SG_V) == MANY);
  CHECK("the old version still has them all",
        sg_version_count(old, SG_V) == MANY);
  sg_world_statistics(world, SG_V, &after);
  CHECK("their slots are used again", after.slots < 3 * before.slots);
  {
    sg_value key[SG_MAX_COLUMNS] = {{.i = 1}, {.i = 3}};
    sg_row row = sg_version_find(old, SG_V, key);
    CHECK("the old version finds its row by key", row != SG_NO_ROW);
    CHECK("with its old value",
          row != SG_NO_ROW && sg_version_value(old, SG_V, row, 2).f == 2.0);
  }
  sg_version_drop(old);
  CHECK("valid at the end", sg_world_is_valid(world));
  sg_world_drop(world);
}

/* Pages that were emptied, side by side, are filled one after the other. */
static void
test_vacant_pages(void)
{
  enum { PAGES = 5, ALL = PAGES * SG_PAGE_ROWS };
  sg_world *world = sg_world_open();
  sg_statistics before, after;
  bool right = true;

  for (int32_t s = 1; s <= PAGES; s++) {
    right = right && fill_vertices(world, s, 1, SG_PAGE_ROWS);
  }
  sg_world_statistics(world, SG_V, &before);
  for (int32_t s = 1; s < PAGES; s++) {
    for (int32_t v = 1; v <= SG_PAGE_ROWS; v++) {
      right = right && sg_world_retract(world, SG_V, find_vertex(world, s, v));
    }
  }
  for (int32_t i = 0; right && i < ALL - SG_PAGE_ROWS; i++) {
    sg_value row[SG_MAX_COLUMNS] = {{.i = 9}, {.i = i + 1}, {.f = i}};
    right = sg_world_add(world, SG_V, row, NULL, NULL) == SG_OK;
    if (i % (SG_PAGE_ROWS / 2) == 0) {
      right = right && sg_world_is_valid(world);
    }
  }
  sg_world_statistics(world, SG_V, &after);
  CHECK("pages are emptied and filled", right && sg_world_is_valid(world));
  CHECK("all rows are there", count(world, SG_V) == ALL);
  CHECK("no page came", after.slots == before.slots);
  sg_world_drop(world);
}

/* Who looks for a segment passes pages by that cannot have it. */
static void
test_spans(void)
{
  sg_world *world = sg_world_open();
  bool right = fill_vertices(world, 1, 1, SG_PAGE_ROWS) &&
               fill_vertices(world, 7, 1, SG_PAGE_ROWS) &&
               fill_vertices(world, 3, 1, 10) &&
               fill_vertices(world, 9, 1, 8 * SG_PAGE_ROWS);
  const sg_version *version = sg_world_version(world);
  sg_view view;

  CHECK("rows of four segments, and a view",
        right && sg_version_view(version, SG_V, &view));
  CHECK("a page of one", view.span[0][0] == 1 && view.span[0][1] == 1);
  CHECK("a page of two", view.span[2][0] == 3 && view.span[2][1] == 9);
  CHECK("valid", sg_world_is_valid(world));
  sg_view_clear(&view);
  sg_version_drop(version);
  sg_world_drop(world);
}

/* A version of some segments: it keeps their rows, and lets others go. */
static void
test_narrow(void)
{
  sg_world *world = sg_world_open();
  const int32_t wanted[2] = {1, 3};
  const sg_version *all, *some;
  sg_statistics before, after;
  bool right = fill_vertices(world, 1, 1, 100) &&
               fill_vertices(world, 2, 1, 12 * SG_PAGE_ROWS) &&
               fill_vertices(world, 3, 1, 100);
  sg_row first = find_vertex(world, 1, 1), last = find_vertex(world, 3, 100);

  all = sg_world_version(world);
  some = sg_version_narrow(all, UINT64_C(1) << SG_V, wanted, 2);
  sg_version_drop(all);
  CHECK("a version of two segments", right && some && sg_world_is_valid(world));
  CHECK("has their rows", sg_version_count(some, SG_V) == 200);
  CHECK("the first and the last", sg_version_live(some, SG_V, first) &&
                                      sg_version_live(some, SG_V, last));
  CHECK("no others", !sg_version_live(some, SG_V, first + 100) &&
                         !sg_version_live(some, SG_V, last - 100));
  CHECK("it has the stamps",
        sg_version_stamp(some, SG_V, 3) != 0 &&
            sg_version_stamp(some, SG_V, 3) > sg_version_stamp(some, SG_V, 1));
  sg_world_statistics(world, SG_V, &before);
  for (int round = 0; right && round < 20; round++) {
    right = sg_world_retract_all(world, SG_V) &&
            fill_vertices(world, 2, 1, 12 * SG_PAGE_ROWS);
  }
  sg_world_statistics(world, SG_V, &after);
  CHECK("what it does not show is used again",
        right && after.slots < 2 * before.slots);
  CHECK("what it shows is still there",
        sg_version_value(some, SG_V, last, 1).i == 100 &&
            sg_version_value(some, SG_V, last, 0).i == 3);
  CHECK("valid", sg_world_is_valid(world));
  sg_version_drop(some);
  sg_world_drop(world);
}

static void
test_bulk(void)
{
  sg_world *world = sg_world_open();
  int32_t s[3] = {2, 2, 2}, v[3] = {7, 8, 7};
  double x[3] = {0, -0.0, 1}, wrong[3] = {0, NAN, 0};
  const void *twice[5] = {s, v, x, x, x};
  const void *nan[5] = {s, v, x, wrong, x};
  sg_fault fault = {0};

  CHECK("100,000 rows", fill_vertices(world, 1, 1, 100000));
  CHECK("a key twice in a buffer",
        sg_world_add_many(world, SG_V, 3, twice, &fault) == SG_EXISTS);
  CHECK("the row at fault", fault.row == 2);
  CHECK("nothing was added", count(world, SG_V) == 100000);
  CHECK("a NaN", sg_world_add_many(world, SG_V, 2, nan, &fault) == SG_INVALID);
  CHECK("its place", fault.row == 1 && fault.column == 3);
  CHECK("two rows", sg_world_add_many(world, SG_V, 2, twice, NULL) == SG_OK);
  CHECK("both are there", count(world, SG_V) == 100002);
  {
    const sg_version *version = sg_world_version(world);
    double stored = sg_version_value(version, SG_V, 100001, 2).f;
    CHECK("-0.0 becomes 0.0", stored == 0 && !signbit(stored));
    sg_version_drop(version);
  }
  CHECK("valid", sg_world_is_valid(world));
  sg_world_drop(world);
}

static void
test_view(void)
{
  sg_world *world = sg_world_open();
  const sg_version *version;
  sg_view view;
  double sum = 0;
  size_t n = 0;

  CHECK("rows over three pages", fill_vertices(world, 1, 1, 10000));
  CHECK("one less", sg_world_retract(world, SG_V, 5000));
  version = sg_world_version(world);
  CHECK("a view", sg_version_view(version, SG_V, &view));
  for (size_t p = 0; p < view.pages; p++) {
    for (unsigned r = sg_live_next(view.live[p], 0); r < SG_PAGE_ROWS;
         r = sg_live_next(view.live[p], r + 1), n++) {
      sum += view.column[2].page[p].f[r];
    }
  }
  CHECK("every live row once", n == 9999);
  CHECK("and its value", sum == 9999.0 * 10000 / 2 - 5000);
  sg_view_clear(&view);
  CHECK("an empty view", sg_version_view(version, SG_T, &view));
  CHECK("has no pages", view.pages == 0);
  sg_view_clear(&view);
  sg_version_drop(version);
  sg_world_drop(world);
}

/* ---- lists, terms, members ---------------------------------------------- */

static size_t
polygons_of_edges(sg_world *world, const int32_t *e, size_t edges)
{
  const sg_version *version = sg_world_version(world);
  sg_walk walk;
  size_t n = 0;

  if (sg_walk_open_members(&walk, version, SG_P, 1, e, edges)) {
    while (sg_walk_next(&walk) != SG_NO_ROW) {
      n++;
    }
    sg_walk_close(&walk);
  }
  sg_version_drop(version);
  return n;
}

static size_t
polygons_of_edge(sg_world *world, int32_t e)
{
  return polygons_of_edges(world, &e, 1);
}

static void
add_edge(sg_world *world, int32_t e, int32_t v1, int32_t v2)
{
  sg_value row[SG_MAX_COLUMNS] = {
      {.i = 1}, {.i = e}, {.i = v1}, {.i = v2}, {.i = 1}};

  CHECK("an edge", sg_world_add(world, SG_E, row, NULL, NULL) == SG_OK);
}

static void
test_members(void)
{
  sg_world *world = sg_world_open();
  const int32_t es[4] = {3, 1, 2, 3}, missing[3] = {2, 1, 99};
  sg_value p[SG_MAX_COLUMNS] = {{.i = 1}, {.i = 1}, {.list = es}};
  sg_fault fault;
  sg_row row;

  CHECK("vertices", fill_vertices(world, 1, 1, 10));
  for (int32_t e = 1; e <= 5; e++) {
    add_edge(world, e, e, e + 1);
  }
  CHECK("a polygon", sg_world_add(world, SG_P, p, &row, NULL) == SG_OK);
  CHECK("found by its edge", polygons_of_edge(world, 2) == 1);
  for (int32_t i = 2; i <= 300; i++) {
    p[1].i = i;
    sg_world_add(world, SG_P, p, NULL, NULL);
  }
  CHECK("300 polygons", polygons_of_edge(world, 3) == 300);
  CHECK("none on edge 4", polygons_of_edge(world, 4) == 0);
  CHECK("each once", polygons_of_edges(world, es + 1, 3) == 300 &&
                         polygons_of_edges(world, es, 0) == 0);
  CHECK("one less", sg_world_retract(world, SG_P, row) &&
                        polygons_of_edge(world, 3) == 299);
  p[1].i = 999;
  p[2].list = missing;
  CHECK("an edge that is not there",
        sg_world_add(world, SG_P, p, NULL, &fault) == SG_DANGLING);
  CHECK("which", fault.column == 2 && fault.id == 99 && fault.s == 1);
  CHECK("valid", sg_world_is_valid(world));
  sg_world_retract_all(world, SG_P);
  CHECK("all gone", polygons_of_edge(world, 3) == 0);
  CHECK("valid without", sg_world_is_valid(world));
  sg_world_drop(world);
}

enum { LOTS = 1 << 17 }; /* rows that are looked through a few times */

/* LOTS rows of edge i, from vertex 1 to 2, some to 1, and of polygon i with
 * edges i and i + 1, or with i alone. */
static void
fill_many(sg_world *world)
{
  static int32_t s[LOTS], id[LOTS], one[LOTS], two[LOTS], list[LOTS][3];
  static const int32_t *lists[LOTS];
  const void *const edge[] = {s, id, one, two, one};
  const void *const polygon[] = {s, id, lists};

  for (int32_t i = 0; i < LOTS; i++) {
    s[i] = one[i] = 1;
    two[i] = i % 1000 == 7 ? 1 : 2;
    id[i] = i + 1;
    list[i][0] = i + 1 < LOTS ? 2 : 1;
    list[i][1] = i + 1;
    list[i][2] = i + 2;
    lists[i] = list[i];
  }
  CHECK("vertices", fill_vertices(world, 1, 1, 2));
  CHECK("many edges",
        sg_world_add_many(world, SG_E, LOTS, edge, NULL) == SG_OK);
  CHECK("many polygons",
        sg_world_add_many(world, SG_P, LOTS, polygon, NULL) == SG_OK);
}

/* How many edges are from vertex 1 to v. */
static size_t
edges_to(sg_world *world, int32_t v)
{
  const sg_version *version = sg_world_version(world);
  const sg_value row[SG_MAX_COLUMNS] = {{.i = 1}, {0}, {.i = 1}, {.i = v}};
  sg_walk walk;
  size_t n = 0;

  if (sg_walk_open(&walk, version, SG_E, 0x0d, row)) {
    while (sg_walk_next(&walk) != SG_NO_ROW) {
      n++;
    }
    sg_walk_close(&walk);
  }
  sg_version_drop(version);
  return n;
}

/* Many at a time, where all of them live. */
static void
test_many_edges(sg_world *world)
{
  sg_value row[SG_MAX_COLUMNS] = {{.i = 1}, {.i = 1008}};
  const sg_version *version = sg_world_version(world);
  sg_row gone = sg_version_find(version, SG_E, row);

  sg_version_drop(version);
  CHECK("few of many", edges_to(world, 1) == (LOTS + 992) / 1000);
  CHECK("most", edges_to(world, 2) == LOTS - (LOTS + 992) / 1000);
  CHECK("none", edges_to(world, 3) == 0);
  sg_world_retract_all(world, SG_P);
  CHECK("one less", sg_world_retract(world, SG_E, gone) &&
                        edges_to(world, 1) == (LOTS + 992) / 1000 - 1);
}

/* Asked seldom, all rows are looked at; asked often, an index is made. */
static void
test_many_members(void)
{
  sg_world *world = sg_world_open();
  const int32_t es[] = {9, 8, 500, LOTS, 9};
  size_t before, after;
  sg_statistics of;
  bool right = true;

  fill_many(world);
  sg_world_statistics(world, SG_P, &of);
  before = of.index_bytes;
  CHECK("several at once", polygons_of_edges(world, es, 5) == 7);
  sg_world_statistics(world, SG_P, &of);
  CHECK("no index", of.index_bytes == before);
  for (int i = 0; i < 50; i++) {
    right = right && polygons_of_edges(world, es, 5) == 7;
  }
  sg_world_statistics(world, SG_P, &of);
  after = of.index_bytes;
  CHECK("the same by an index", right && after > before);
  test_many_edges(world);
  sg_world_drop(world);
}

static void
put_origin(sg_term_builder *b, int32_t t)
{
  sg_term_open(b);
  sg_term_compound(b, SG_SYMBOL_LPI, 2);
  sg_term_compound(b, SG_SYMBOL_MINUS, 2);
  sg_term_int(b, 1);
  sg_term_pair(b, 3, 4);
  sg_term_pair(b, 2, t);
}

static void
test_terms(void)
{
  sg_world *world = sg_world_open();
  sg_term_builder item, origin, again;
  sg_value row[SG_MAX_COLUMNS] = {{.i = 1}};
  const sg_version *version;
  sg_walk walk;

  sg_term_open(&item);
  sg_term_unary(&item, SG_SYMBOL_V, 12);
  put_origin(&origin, 7);
  put_origin(&again, 7);
  row[1].term = sg_term_words(&item);
  row[2].term = sg_term_words(&origin);
  CHECK("equal terms, equal words",
        sg_term_equal(row[2].term, sg_term_words(&again)));
  CHECK("equal hash",
        sg_term_hash(row[2].term) == sg_term_hash(sg_term_words(&again)));
  CHECK("an origin", sg_world_add(world, SG_ORIGIN, row, NULL, NULL) == SG_OK);
  CHECK("its key is taken",
        sg_world_add(world, SG_ORIGIN, row, NULL, NULL) == SG_EXISTS);
  version = sg_world_version(world);
  row[2].term = sg_term_words(&again);
  CHECK("found by its term",
        sg_walk_open(&walk, version, SG_ORIGIN, 0x04, row) &&
            sg_walk_next(&walk) != SG_NO_ROW &&
            sg_walk_next(&walk) == SG_NO_ROW);
  sg_walk_close(&walk);
  sg_version_drop(version);
  sg_term_close(&item);
  sg_term_close(&origin);
  sg_term_close(&again);
  sg_term_open(&item);
  for (int i = 0; i < 1000; i++) {
    sg_term_float(&item, i);
  }
  CHECK("a long term",
        sg_term_words(&item) && sg_term_length(sg_term_words(&item)) == 3001);
  sg_term_close(&item);
  sg_world_drop(world);
}

/* ---- ids ---------------------------------------------------------------- */

static void
test_fresh(void)
{
  sg_world *world = sg_world_open();

  CHECK("the first id", sg_world_fresh(world, SG_V, 1) == 1);
  CHECK("the next", sg_world_fresh(world, SG_V, 1) == 2);
  CHECK("another segment", sg_world_fresh(world, SG_V, 2) == 1);
  CHECK("rows use ids too",
        fill_vertices(world, 1, 10, 5) && sg_world_fresh(world, SG_V, 1) == 15);
  sg_world_begin(world);
  CHECK("in a transaction", sg_world_fresh(world, SG_V, 1) == 16);
  sg_world_rollback(world);
  CHECK("the same again", sg_world_fresh(world, SG_V, 1) == 16);
  sg_world_retract_all(world, SG_V);
  CHECK("never one twice", sg_world_fresh(world, SG_V, 1) == 17);
  CHECK("segments themselves", sg_world_fresh(world, SG_SEGMENT, 0) == 1);
  CHECK("views have no ids", sg_world_fresh(world, SG_VIEW, 0) == 0);
  for (int32_t s = 100; s > 2; s--) {
    CHECK("many segments", sg_world_fresh(world, SG_E, s) == 1);
  }
  CHECK("each its own", sg_world_fresh(world, SG_E, 50) == 2);
  sg_world_drop(world);
}

/* ---- questions before an index pays -------------------------------------- */

enum { MANY_EDGES = 70000, FAN = 7 };

/* Edges 1 .. MANY_EDGES of segment 1, edge k from vertex k / FAN + 1. */
static bool
fill_edges(sg_world *world)
{
  int32_t(*column)[MANY_EDGES] = calloc(5, sizeof *column);
  const void *columns[5];
  bool good = column != NULL;

  for (int c = 0; c < 5 && good; c++) {
    columns[c] = column[c];
    for (int32_t k = 0; k < MANY_EDGES; k++) {
      column[c][k] = (int32_t[]){1, k + 1, k / FAN + 1, k % FAN + 1, 0}[c];
    }
  }
  good = good && fill_vertices(world, 1, 1, MANY_EDGES / FAN + 1) &&
         sg_world_add_many(world, SG_E, MANY_EDGES, columns, NULL) == SG_OK;
  free(column);
  return good;
}

/* Polygon k has edge k, every FAN-th edge 1 too. */
static bool
fill_polygons(sg_world *world)
{
  int32_t(*id)[MANY_EDGES] = calloc(5, sizeof *id);
  const int32_t **list = calloc(MANY_EDGES, sizeof *list);
  const void *columns[3] = {id, id + 1, list};
  bool good = id && list;

  for (int32_t k = 0; k < MANY_EDGES && good; k++) {
    int32_t *edges = id[2] + 3 * (size_t)k;
    id[0][k] = 1;
    id[1][k] = k + 1;
    edges[0] = 1 + (k % FAN == 1);
    edges[1] = k + 1;
    edges[2] = 1;
    list[k] = edges;
  }
  good = good &&
         sg_world_add_many(world, SG_P, MANY_EDGES, columns, NULL) == SG_OK;
  free(id);
  free(list);
  return good;
}

/* What edges leave vertex v, as a sum that depends on their order. */
static uint64_t
edges_from(sg_world *world, int32_t v)
{
  const sg_version *version = sg_world_version(world);
  sg_value row[SG_MAX_COLUMNS] = {{.i = 1}, [2] = {.i = v}};
  uint64_t sum = 0;
  sg_walk walk;

  if (sg_walk_open(&walk, version, SG_E, 0x05, row)) {
    for (sg_row r; (r = sg_walk_next(&walk)) != SG_NO_ROW;) {
      sum = sum * 31 + (uint64_t)sg_version_value(version, SG_E, r, 1).i;
    }
    sg_walk_close(&walk);
  }
  sg_version_drop(version);
  return sum;
}

/* The first questions look at all rows, the others use an index. */
static void
test_questions(void)
{
  sg_world *world = sg_world_open();
  sg_statistics before, after;

  CHECK("many edges", fill_edges(world));
  sg_world_statistics(world, SG_E, &before);
  for (int32_t v = 1; v <= 40; v++) {
    uint64_t sum = 0;
    for (int32_t k = 1; k <= FAN; k++) {
      sum = sum * 31 + (uint64_t)((v - 1) * FAN + k);
    }
    CHECK("the edges of a vertex", edges_from(world, v) == sum);
  }
  sg_world_statistics(world, SG_E, &after);
  CHECK("few looks at all rows", after.scans - before.scans == 32);
  CHECK("then an index", after.lookups - before.lookups == 8);
  CHECK("many polygons", fill_polygons(world));
  for (int32_t e = 2; e <= 50; e++) {
    CHECK("the polygon of an edge", polygons_of_edge(world, e) == 1);
    CHECK("those of the first",
          e % 6 || polygons_of_edge(world, 1) == MANY_EDGES / FAN + 1);
  }
  CHECK("valid", sg_world_is_valid(world));
  sg_world_drop(world);
}

int
main(void)
{
  test_sweep();
  test_vacant_pages();
  test_spans();
  test_narrow();
  test_bulk();
  test_view();
  test_members();
  test_many_members();
  test_terms();
  test_fresh();
  test_questions();
  return check_report();
}
