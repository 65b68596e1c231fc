/* append_test.c -- rows written in place: stamps, transactions, runs, slots
 * that are used again. */
#include "asked.h"
#include "rows.h"

static rows some; /* of 5000 vertices, or polygons */

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

/* Rows of two segments on one page, the ids of the second go on from those of
 * the first: whatever lies where, each is found in its own segment alone. */
static void
test_two_segments(void)
{
  bool good = true;

  for (size_t n = 20; n <= 260; n += 20) {
    for (size_t from = 1; from < n; from += 7) {
      sg_world *world = sg_world_open();
      make_rows(&some, SG_V, 1, 1, n, (const int32_t[3]){1, 1, 1});
      for (size_t k = from; k < n; k++) {
        some.i[0][k] = 2;
      }
      good = good && append(world, &some);
      for (int32_t v = 1; good && v <= (int32_t)n; v++) {
        bool first = v <= (int32_t)from;
        good = (find_vertex(world, 1, v) != SG_NO_ROW) == first &&
               (find_vertex(world, 2, v) != SG_NO_ROW) == !first;
      }
      good = good && sg_world_is_valid(world);
      sg_world_drop(world);
    }
  }
  CHECK("two segments on a page", good);
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

/* All rows go in a transaction, which holds the version before, and others
 * come: their slots are used again. */
static void
test_all_gone(void)
{
  enum { ROWS = 50000 };
  static int32_t of[ROWS], id[ROWS];
  static double at[ROWS];
  const void *column[5] = {of, id, at, at, at};
  sg_world *world = sg_world_open();
  size_t most = 0;
  bool good = true;

  for (int32_t i = 0; i < ROWS; i++) {
    of[i] = 1;
    id[i] = i + 1;
  }
  sg_world_undo_limit(world, 0);
  for (int step = 0; good && step < 4; step++) {
    good = sg_world_add_many(world, SG_V, ROWS, column, NULL) == SG_OK &&
           sg_world_is_valid(world);
    most = slots(world, SG_V) > most ? slots(world, SG_V) : most;
    good = good && sg_world_begin(world) == SG_OK &&
           sg_world_retract_all(world, SG_V) &&
           sg_world_commit_change(world) == SG_OK;
  }
  CHECK("rows come and go", good);
  CHECK("on the same slots", most == ROWS);
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
  test_two_segments();
  test_runs();
  test_used_again();
  test_late_twice();
  test_swept_while_loading();
  test_all_gone();
  test_a_broken_promise();
  return check_report();
}
