/* append_test.c -- rows written in place against rows added and checked: two
 * worlds with the same history must be the same. */
#include "../../engine/store.h"
#include "../check.h"

#include <stdlib.h>
#include <string.h>

static uint64_t seed;

static uint32_t
draw(uint32_t n)
{
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(seed >> 33) % n;
}

/* ---- columns of rows, and both ways to add them ------------------------- */

enum { MOST = 9000, LONGEST = 6 };

/* Rows of v, e, p or t of one segment, with ids from `first` on. */
typedef struct rows {
  sg_relation relation;
  size_t n;
  int32_t i[6][MOST];
  double f[MOST];
  int32_t list[MOST][1 + LONGEST];
  const int32_t *lists[MOST];
} rows;

static int32_t
id_up_to(int32_t last)
{
  return last > 0 ? 1 + (int32_t)draw((uint32_t)last) : 1;
}

/* References are to ids 1 .. vertices, edges, polygons. */
static void
make_rows(rows *r, sg_relation relation, int32_t s, int32_t first, size_t n,
          const int32_t last[3])
{
  r->relation = relation;
  r->n = n;
  for (size_t k = 0; k < n; k++) {
    r->i[0][k] = s;
    r->i[1][k] = relation == SG_T ? id_up_to(last[2]) : first + (int32_t)k;
    r->i[2][k] = relation == SG_T ? first + (int32_t)k : id_up_to(last[0]);
    for (int c = 3; c < 6; c++) {
      r->i[c][k] = id_up_to(last[0]);
    }
    r->i[4][k] = relation == SG_E ? (int32_t)draw(2) : r->i[4][k];
    r->f[k] = draw(1000) / 8.0;
    r->list[k][0] = (int32_t)draw(LONGEST + 1);
    for (int m = 1; relation == SG_P && m <= LONGEST; m++) {
      r->list[k][m] = id_up_to(last[1]);
    }
    r->lists[k] = r->list[k];
  }
}

static const void *
column_of(const rows *r, unsigned c)
{
  sg_type type = sg_relation_table[r->relation].column[c].type;

  return type == SG_FLOAT  ? (const void *)r->f
         : type == SG_LIST ? (const void *)r->lists
                           : (const void *)r->i[c];
}

static bool
add_checked(sg_world *world, const rows *r)
{
  const void *column[6] = {0};

  for (unsigned c = 0; c < sg_relation_table[r->relation].arity; c++) {
    column[c] = column_of(r, c);
  }
  return sg_world_add_many(world, r->relation, r->n, column, NULL) == SG_OK;
}

static bool
fill_lists(sg_append *a, const rows *r, size_t k, unsigned c)
{
  const sg_sheet_page *page = &a->sheet.page[k];
  int32_t length[SG_PAGE_ROWS];

  for (size_t i = 0; i < page->n; i++) {
    length[i] = r->list[page->from + i][0];
  }
  if (!sg_append_lists(a, k, c, length)) {
    return false;
  }
  for (size_t i = 0; i < page->n; i++) {
    memcpy(page->column[c].list[i], r->list[page->from + i],
           (1 + (size_t)length[i]) * sizeof(int32_t));
  }
  return true;
}

static bool
fill(sg_append *a, const rows *r)
{
  const sg_relation_info *info = &sg_relation_table[r->relation];
  bool good = true;

  for (size_t k = 0; k < a->sheet.pages; k++) {
    const sg_sheet_page *page = &a->sheet.page[k];
    for (unsigned c = 0; c < info->arity; c++) {
      if (info->column[c].type == SG_LIST) {
        good = good && fill_lists(a, r, k, c);
      } else if (info->column[c].type == SG_FLOAT) {
        memcpy(page->column[c].f, r->f + page->from, page->n * sizeof(double));
      } else {
        memcpy(page->column[c].i, r->i[c] + page->from,
               page->n * sizeof(int32_t));
      }
    }
  }
  return good;
}

static bool
append(sg_world *world, const rows *r)
{
  sg_append a;
  bool good = sg_append_open(&a, world, r->relation, r->n);

  if (good) {
    good = fill(&a, r) && sg_append_commit(&a);
    sg_append_close(&a);
  }
  return good;
}

/* ---- what a version shows ----------------------------------------------- */

static void
mix(uint64_t *h, uint64_t value)
{
  *h = (*h ^ value) * UINT64_C(0x9e3779b97f4a7c15);
  *h ^= *h >> 29;
}

static void
mix_value(uint64_t *h, sg_type type, sg_value value)
{
  uint64_t bits;

  if (type == SG_FLOAT) {
    memcpy(&bits, &value.f, sizeof(bits));
    mix(h, bits);
  } else if (type == SG_LIST) {
    for (int32_t i = 0; i <= value.list[0]; i++) {
      mix(h, (uint32_t)value.list[i]);
    }
  } else {
    mix(h, (uint32_t)value.i);
  }
}

/* The rows that a walk gives, in its order. */
static uint64_t
walked(const sg_version *version, sg_relation relation, sg_walk *walk)
{
  const sg_relation_info *info = &sg_relation_table[relation];
  uint64_t h = 1;

  for (sg_row row; (row = sg_walk_next(walk)) != SG_NO_ROW;) {
    mix(&h, row);
    for (unsigned c = 0; c < info->arity; c++) {
      mix_value(&h, info->column[c].type,
                sg_version_value(version, relation, row, c));
    }
  }
  sg_walk_close(walk);
  return h;
}

static uint64_t
found(const sg_version *version, sg_relation relation, uint16_t mask,
      const sg_value *key)
{
  sg_walk walk;

  return sg_walk_open(&walk, version, relation, mask, key)
             ? walked(version, relation, &walk)
             : 0;
}

static uint64_t
found_member(const sg_version *version, sg_relation relation, int32_t s,
             int32_t member)
{
  sg_walk walk;

  return sg_walk_open_member(&walk, version, relation, s, member)
             ? walked(version, relation, &walk)
             : 0;
}

static const sg_relation FILLED[] = {SG_V, SG_E, SG_P, SG_T};

static uint64_t
all_rows(const sg_version *version)
{
  uint64_t h = 1;

  for (int k = 0; k < 4; k++) {
    mix(&h, found(version, FILLED[k], 0, NULL));
    mix(&h, sg_version_count(version, FILLED[k]));
  }
  return h;
}

/* By keys, by the other indexes, by members. */
static uint64_t
look_ups(const sg_version *version, int32_t s, const sg_value *key)
{
  static const uint16_t masks[] = {0x03, 0x05, 0x09, 0x0d};
  uint64_t h = 1;

  for (int k = 0; k < 4; k++) {
    mix(&h, found(version, SG_E, masks[k], key));
    mix(&h, found(version, FILLED[k], 0x03, key));
  }
  mix(&h, found_member(version, SG_P, s, key[1].i));
  mix(&h, found_member(version, SG_T, s, key[2].i));
  return h;
}

/* ---- the same history twice --------------------------------------------- */

enum { SEGMENTS = 3, STEPS = 300 };

typedef struct twins {
  sg_world *world[2]; /* appended to; added to, checked */
  const sg_version *held[2];
  uint64_t shows;
  rows rows;
} twins;

static int32_t
count_of(const sg_world *world, sg_relation relation, int32_t s)
{
  const sg_version *version = sg_world_version((sg_world *)world);
  sg_value key[SG_MAX_COLUMNS] = {{.i = s}};
  sg_walk walk;
  int32_t n = 0;

  if (sg_walk_open(&walk, version, relation, 0x01, key)) {
    while (sg_walk_next(&walk) != SG_NO_ROW) {
      n++;
    }
    sg_walk_close(&walk);
  }
  sg_version_drop(version);
  return n;
}

/* Some rows; triangles may be retracted, to which nothing refers. */
static bool
twins_add(twins *t)
{
  int32_t s = 1 + (int32_t)draw(SEGMENTS);
  sg_relation relation = FILLED[draw(4)];
  size_t n = draw(30) == 0 ? 1 + draw(MOST) : 1 + draw(40);
  int32_t last[3] = {0};

  for (int k = 0; k < 3; k++) {
    last[k] = count_of(t->world[0], FILLED[k], s);
  }
  if ((relation != SG_V && last[0] == 0) || (relation == SG_P && !last[1]) ||
      (relation == SG_T && !last[2])) {
    return true;
  }
  int32_t first = sg_world_fresh(t->world[0], relation, s);
  if (first != sg_world_fresh(t->world[1], relation, s)) {
    return false;
  }
  make_rows(&t->rows, relation, s, first, n, last);
  return append(t->world[0], &t->rows) && add_checked(t->world[1], &t->rows);
}

/* A triangle, if there is one with this id. */
static bool
twins_retract(twins *t)
{
  sg_value key[SG_MAX_COLUMNS] = {
      [0].i = 1 + (int32_t)draw(SEGMENTS), [2].i = 1 + (int32_t)draw(200)};
  bool done[2];

  for (int k = 0; k < 2; k++) {
    const sg_version *version = sg_world_version(t->world[k]);
    sg_row row = sg_version_find(version, SG_T, key);
    sg_version_drop(version);
    done[k] = row != SG_NO_ROW && sg_world_retract(t->world[k], SG_T, row);
  }
  return done[0] == done[1];
}

static bool
twins_all(twins *t)
{
  return sg_world_retract_all(t->world[0], SG_T) &&
         sg_world_retract_all(t->world[1], SG_T);
}

static bool
twins_hold(twins *t)
{
  bool same = true;

  for (int k = 0; k < 2; k++) {
    same = same && (!t->held[k] || all_rows(t->held[k]) == t->shows);
    sg_version_drop(t->held[k]);
    t->held[k] = sg_world_version(t->world[k]);
  }
  t->shows = all_rows(t->held[0]);
  return same;
}

static bool
twins_do(twins *t, sg_status (*what)(sg_world *))
{
  return what(t->world[0]) == what(t->world[1]);
}

static bool
twins_step(twins *t)
{
  uint32_t what = draw(100);

  return what < 50   ? twins_add(t)
         : what < 75 ? twins_retract(t)
         : what < 76 ? twins_all(t)
         : what < 80 ? twins_hold(t)
         : what < 85 ? twins_do(t, sg_world_begin)
         : what < 89 ? twins_do(t, sg_world_commit)
         : what < 92 ? twins_do(t, sg_world_rollback)
         : what < 96 ? twins_do(t, sg_world_undo)
                     : twins_do(t, sg_world_redo);
}

static bool
twins_are_same(const twins *t)
{
  sg_value key[SG_MAX_COLUMNS] = {{.i = 1 + (int32_t)draw(SEGMENTS)}};
  uint64_t rows_of[2], found_in[2];
  bool asks[2] = {draw(3) > 0, draw(3) > 0}; /* so indexes lag differently */

  for (int c = 1; c < 4; c++) {
    key[c].i = 1 + (int32_t)draw(60);
  }
  for (int k = 0; k < 2; k++) {
    const sg_version *version = sg_world_version(t->world[k]);
    rows_of[k] = all_rows(version);
    found_in[k] = asks[k] ? look_ups(version, key[0].i, key) : 0;
    sg_version_drop(version);
  }
  return rows_of[0] == rows_of[1] &&
         (!asks[0] || !asks[1] || found_in[0] == found_in[1]);
}

static void
test_twins(uint64_t start)
{
  static twins t;
  char name[64];
  bool right = true;

  memset(&t, 0, sizeof(t));
  seed = start;
  for (int k = 0; k < 2; k++) {
    t.world[k] = sg_world_open();
    sg_world_undo_limit(t.world[k], 5);
  }
  snprintf(name, sizeof(name), "the same history, seed %u", (unsigned)start);
  for (int i = 0; i < STEPS && right; i++) {
    right = twins_step(&t) && (i % 4 || twins_are_same(&t));
    right = right && (i % 32 || (sg_world_is_valid(t.world[0]) &&
                                 sg_world_is_valid(t.world[1])));
  }
  CHECK(name, right);
  for (int k = 0; k < 2; k++) {
    sg_version_drop(t.held[k]);
    sg_world_drop(t.world[k]);
  }
}

/* ---- one by one --------------------------------------------------------- */

static rows some; /* of 5000 vertices, or polygons */

static size_t
count(sg_world *world, sg_relation relation)
{
  const sg_version *version = sg_world_version(world);
  size_t n = sg_version_count(version, relation);

  sg_version_drop(version);
  return n;
}

static size_t
bytes(sg_world *world, sg_relation relation)
{
  sg_statistics statistics;

  sg_world_statistics(world, relation, &statistics);
  return statistics.bytes;
}

static void
test_stamps(void)
{
  sg_world *world = sg_world_open();
  const sg_version *before, *after;

  make_rows(&some, SG_V, 1, 1, 10, (const int32_t[3]){1, 1, 1});
  CHECK("ten", append(world, &some));
  before = sg_world_version(world);
  make_rows(&some, SG_V, 2, 1, 5000, (const int32_t[3]){1, 1, 1});
  CHECK("more, of another segment", append(world, &some));
  after = sg_world_version(world);
  CHECK("a stamp", sg_version_stamp(after, SG_V, 2) > 0);
  CHECK("a new one", sg_version_stamp(before, SG_V, 2) == 0);
  CHECK("others keep theirs",
        sg_version_stamp(before, SG_V, 1) == sg_version_stamp(after, SG_V, 1));
  CHECK("a version stays as it was", sg_version_count(before, SG_V) == 10);
  CHECK("the next id", sg_world_fresh(world, SG_V, 2) == 5001);
  sg_version_drop(before);
  sg_version_drop(after);
  sg_world_drop(world);
}

static void
test_transactions(void)
{
  sg_world *world = sg_world_open();

  make_rows(&some, SG_V, 1, 1, 5000, (const int32_t[3]){1, 1, 1});
  sg_world_begin(world);
  CHECK("in a transaction", append(world, &some));
  CHECK("they are seen in it", count(world, SG_V) == 5000);
  sg_world_rollback(world);
  CHECK("rolled back", count(world, SG_V) == 0 && sg_world_is_valid(world));
  CHECK("with the ids", sg_world_fresh(world, SG_V, 1) == 1);
  sg_world_begin(world);
  append(world, &some);
  sg_world_commit(world);
  CHECK("undo", sg_world_undo(world) == SG_OK && count(world, SG_V) == 0);
  CHECK("redo", sg_world_redo(world) == SG_OK && count(world, SG_V) == 5000);
  CHECK("valid", sg_world_is_valid(world));
  sg_world_drop(world);
}

static void
test_closed_without_commit(void)
{
  sg_world *world = sg_world_open();
  sg_append a;
  size_t before;

  make_rows(&some, SG_V, 1, 1, 10, (const int32_t[3]){1, 1, 1});
  append(world, &some);
  make_rows(&some, SG_E, 1, 1, 10, (const int32_t[3]){10, 1, 1});
  append(world, &some);
  make_rows(&some, SG_P, 1, 1, 5000, (const int32_t[3]){10, 10, 1});
  before = bytes(world, SG_P);
  CHECK("opened", sg_append_open(&a, world, SG_P, some.n) && fill(&a, &some));
  CHECK("not shown", count(world, SG_P) == 0);
  sg_append_close(&a);
  CHECK("nothing is left", count(world, SG_P) == 0);
  CHECK("valid", sg_world_is_valid(world));
  CHECK("the lists are given back", bytes(world, SG_P) < before + 400000);
  CHECK("once more", append(world, &some) && count(world, SG_P) == 5000);
  sg_world_drop(world);
}

static void
test_shortened(void)
{
  sg_world *world = sg_world_open();
  sg_append a;

  make_rows(&some, SG_V, 1, 1, 10, (const int32_t[3]){1, 1, 1});
  append(world, &some);
  make_rows(&some, SG_E, 1, 1, 10, (const int32_t[3]){10, 1, 1});
  append(world, &some);
  make_rows(&some, SG_P, 1, 1, 9000, (const int32_t[3]){10, 10, 1});
  CHECK("opened", sg_append_open(&a, world, SG_P, some.n) && fill(&a, &some));
  sg_append_shorten(&a, 5000);
  CHECK("5000 are left", a.sheet.rows == 5000 && a.sheet.pages == 2);
  CHECK("committed", sg_append_commit(&a));
  sg_append_close(&a);
  CHECK("they are there", count(world, SG_P) == 5000);
  CHECK("the next id", sg_world_fresh(world, SG_P, 1) == 5001);
  CHECK("valid", sg_world_is_valid(world));
  CHECK("opened for none", sg_append_open(&a, world, SG_V, 0));
  CHECK("none", sg_append_commit(&a));
  sg_append_close(&a);
  CHECK("valid still", sg_world_is_valid(world));
  sg_world_drop(world);
}

static sg_row
find_vertex(sg_world *world, int32_t s, int32_t v)
{
  const sg_version *version = sg_world_version(world);
  sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.i = v}};
  sg_row row = sg_version_find(version, SG_V, key);

  sg_version_drop(version);
  return row;
}

static size_t
index_bytes(sg_world *world, sg_relation relation)
{
  sg_statistics statistics;

  sg_world_statistics(world, relation, &statistics);
  return statistics.index_bytes;
}

/* A long stretch, and every other one of some. */
static bool
goes(int32_t v)
{
  return (v >= 100 && v < 3100) || (v >= 5000 && v < 5100 && v % 2);
}

/* Rows with dense ids are found without an index; also after some of them went
 * and their slots are used again. */
static void
test_runs(void)
{
  enum { ROWS = 2 * SG_PAGE_ROWS };
  sg_world *world = sg_world_open();
  sg_value row[SG_MAX_COLUMNS] = {{.i = 1}, {.i = 7}, {.f = 0.5}};
  sg_row again = SG_NO_ROW;
  bool right = true;

  make_rows(&some, SG_V, 1, 1, ROWS, (const int32_t[3]){1, 1, 1});
  append(world, &some);
  for (int32_t v = 1; v <= ROWS; v++) {
    right = right && find_vertex(world, 1, v) == (sg_row)v - 1;
  }
  CHECK("all are found", right);
  CHECK("without an index", index_bytes(world, SG_V) == 0);
  CHECK("no others", find_vertex(world, 1, ROWS + 1) == SG_NO_ROW);
  for (int32_t v = 1; right && v <= ROWS; v++) {
    right = !goes(v) || sg_world_retract(world, SG_V, find_vertex(world, 1, v));
  }
  CHECK("some are retracted", right && sg_world_is_valid(world));
  CHECK("a key twice", sg_world_add(world, SG_V, row, NULL, NULL) == SG_EXISTS);
  row[1].i = 150;
  CHECK("one is added again",
        sg_world_add(world, SG_V, row, &again, NULL) == SG_OK);
  CHECK("in a slot that was used", again < ROWS);
  CHECK("it is found", find_vertex(world, 1, 150) == again);
  for (int32_t v = 1; v <= ROWS; v++) {
    bool there = !goes(v) || v == 150;
    right = right && (find_vertex(world, 1, v) != SG_NO_ROW) == there;
  }
  CHECK("the others are, and those gone are not", right);
  CHECK("valid", sg_world_is_valid(world));
  sg_world_drop(world);
}

/* ---- slots that are used again ------------------------------------------ */

static size_t
slots(sg_world *world, sg_relation relation)
{
  sg_statistics statistics;

  sg_world_statistics(world, relation, &statistics);
  return statistics.slots;
}

/* The edges of a segment that start in vertex v, by an index. */
static size_t
edges_from(sg_world *world, int32_t s, int32_t v)
{
  const sg_version *version = sg_world_version(world);
  sg_value row[SG_MAX_COLUMNS] = {{.i = s}, {0}, {.i = v}};
  sg_walk walk;
  size_t n = 0;

  if (sg_walk_open(&walk, version, SG_E, 0x05, row)) {
    while (sg_walk_next(&walk) != SG_NO_ROW) {
      n++;
    }
    sg_walk_close(&walk);
  }
  sg_version_drop(version);
  return n;
}

/* One step: segment 2 has n vertices and edges, all of them new; segment 3 gets
 * one vertex more, which stays. */
static bool
renew(sg_world *world, int32_t step, size_t n)
{
  sg_value one[SG_MAX_COLUMNS] = {{.i = 3}, {.i = step}, {.f = 0.5}};
  const int32_t last[3] = {(int32_t)n, 1, 1};
  bool good = sg_world_begin(world) == SG_OK;

  good = good && sg_world_retract_with(world, SG_E, 0, 2) &&
         sg_world_retract_with(world, SG_V, 0, 2);
  make_rows(&some, SG_V, 2, 1, n, last);
  good = good && append(world, &some);
  make_rows(&some, SG_E, 2, 1, n, last);
  good = good &&
         (step % 5 == 0 ? add_checked(world, &some) : append(world, &some));
  return good && sg_world_add(world, SG_V, one, NULL, NULL) == SG_OK &&
         sg_world_commit(world) == SG_OK;
}

static size_t
edges_by_looking(const rows *r, int32_t v)
{
  size_t n = 0;

  for (size_t i = 0; i < r->n; i++) {
    n += r->i[2][i] == v;
  }
  return n;
}

/* What is written again and again does not grow, whatever is kept for undo:
 * rows of many steps stand on pages whose rows went, also where an index had
 * seen those. */
static void
test_used_again(void)
{
  enum { TIMES = 60, MOST_ROWS = 9000, UNDO = 4 };
  sg_world *world = sg_world_open();
  size_t most = 0;
  bool right = true;

  sg_world_undo_limit(world, UNDO);
  for (int32_t step = 1; right && step <= TIMES; step++) {
    size_t n = MOST_ROWS - draw(900);
    right = renew(world, step, n) && sg_world_is_valid(world) &&
            find_vertex(world, 2, (int32_t)n) != SG_NO_ROW &&
            find_vertex(world, 2, (int32_t)n + 1) == SG_NO_ROW &&
            find_vertex(world, 3, step) != SG_NO_ROW;
    if (right && step % 3 == 0) {
      right = edges_from(world, 2, 7) == edges_by_looking(&some, 7) &&
              sg_world_is_valid(world);
    }
    most = slots(world, SG_E) > most ? slots(world, SG_E) : most;
  }
  CHECK("rows are right in every step", right);
  CHECK("slots are used again", most < (UNDO + 1 + 5) * MOST_ROWS);
  right = true;
  for (int k = 0; right && k < UNDO; k++) {
    right = sg_world_undo(world) == SG_OK && sg_world_is_valid(world);
  }
  CHECK("steps that are kept come back", right);
  CHECK("with their rows", find_vertex(world, 3, TIMES - UNDO) != SG_NO_ROW);
  CHECK("and no others", find_vertex(world, 3, TIMES - UNDO + 1) == SG_NO_ROW);
  sg_world_drop(world);
}

static bool
add_edges(sg_world *world, int32_t s, size_t n, bool checked)
{
  make_rows(&some, SG_E, s, 1, n, (const int32_t[3]){10, 1, 1});
  return checked ? add_checked(world, &some) : append(world, &some);
}

/* Of four segments, all of whose edges are on pages of their own or nearly, and
 * ten vertices of a fifth. */
static sg_world *
world_of_edges(void)
{
  sg_world *world = sg_world_open();
  bool good = true;

  for (int32_t s = 1; s <= 4; s++) {
    good = good && add_edges(world, s, MOST, false);
  }
  make_rows(&some, SG_V, 5, 1, 10, (const int32_t[3]){1, 1, 1});
  CHECK("edges of four segments", good && append(world, &some));
  return world;
}

/* Rows that an index has not seen yet go, and others come in their slots. */
static void
test_late_twice(void)
{
  sg_world *world = world_of_edges();
  size_t before = slots(world, SG_E);
  bool good = edges_from(world, 1, 7) > 0;

  good = good && sg_world_retract_with(world, SG_E, 0, 3);
  for (int k = 0; k < 3; k++) {
    good = good && sg_world_retract_with(world, SG_E, 0, 2) &&
           add_edges(world, 2, MOST, false);
  }
  CHECK("slots are used again", good && slots(world, SG_E) == before);
  CHECK("rows are found",
        edges_from(world, 2, 7) == edges_by_looking(&some, 7));
  CHECK("valid", sg_world_is_valid(world));
  sg_world_drop(world);
}

/* Runs that are cut to pieces leave the rest of their rows to the key's index,
 * in the midst of a checked load. */
static void
test_swept_while_loading(void)
{
  sg_world *world = world_of_edges();
  sg_value row[SG_MAX_COLUMNS] = {
      {.i = 5}, {.i = 2}, {.i = 1}, {.i = 1}, {.i = 1}};
  bool good = true;

  for (sg_row k = MOST; good && k < 2 * MOST; k += 2) {
    good = sg_world_retract(world, SG_E, k);
  }
  CHECK("half of the edges of a segment go", good);
  make_rows(&some, SG_V, 2, 1, 10, (const int32_t[3]){1, 1, 1});
  CHECK("vertices", append(world, &some));
  CHECK("those of two others go", sg_world_retract_with(world, SG_E, 0, 3) &&
                                      sg_world_retract_with(world, SG_E, 0, 4));
  size_t before = slots(world, SG_E);
  CHECK("a checked load", add_edges(world, 5, MOST, true));
  CHECK("slots are used again", slots(world, SG_E) <= before);
  CHECK("valid", sg_world_is_valid(world));
  CHECK("a key of the load",
        sg_world_add(world, SG_E, row, NULL, NULL) == SG_EXISTS);
  row[0].i = 2;
  CHECK("a key that was in a run",
        sg_world_add(world, SG_E, row, NULL, NULL) == SG_EXISTS);
  row[1].i = 1;
  CHECK("one that went", sg_world_add(world, SG_E, row, NULL, NULL) == SG_OK);
  CHECK("valid still", sg_world_is_valid(world));
  sg_world_drop(world);
}

/* A key that is not right by construction: the audit finds it. */
static void
test_a_broken_promise(void)
{
  sg_world *world = sg_world_open();

  make_rows(&some, SG_V, 1, 1, 10, (const int32_t[3]){1, 1, 1});
  append(world, &some);
  CHECK("valid", sg_world_is_valid(world));
  append(world, &some);
  CHECK("the same keys again", !sg_world_is_valid(world));
  sg_world_drop(world);
}

int
main(void)
{
  test_stamps();
  test_transactions();
  test_closed_without_commit();
  test_shortened();
  test_runs();
  test_used_again();
  test_late_twice();
  test_swept_while_loading();
  test_a_broken_promise();
  for (uint64_t start = 1; start <= 5; start++) {
    test_twins(start);
  }
  return check_report();
}
