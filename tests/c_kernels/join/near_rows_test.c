/* near_rows_test.c -- which segments are near each other, in crowds: of blocks
 * in each other, side by side and askew, with rods among them. All that meet
 * are there, and none whose boxes are apart.
 *
 * covers: near_leaf
 */
#include "doors/world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/c_kernels/whole_triangle.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include "engine/symbol.h"

#include <stdlib.h>

enum { MOST = 120 };

/* A block spanned by three vectors, or a rod along the first. */
typedef struct block {
  int32_t s;
  bool rod;
  int o[3], way[3][3], low[3], high[3];
  triangle face[12];
} block;

static struct {
  block at[MOST];
  size_t n;
} crowd;

static uint32_t seed;

static int
between(int low, int high)
{
  return low + check_below(&seed, high - low + 1);
}

static void
corner_of(const block *b, int c, int at[3])
{
  for (int k = 0; k < 3; k++) {
    at[k] = b->o[k];
    for (int i = 0; i < 3; i++) {
      at[k] += c >> i & 1 ? b->way[i][k] : 0;
    }
  }
}

/* Its triangles in whole numbers; a rod is one that has no area. */
static void
find_faces(block *b)
{
  static const int quad[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

  for (int f = 0; f < 12; f++) {
    const int *q = quad[f / 2];
    corner_of(b, q[0], b->face[f].at[0]);
    corner_of(b, q[1 + f % 2], b->face[f].at[1]);
    corner_of(b, q[2 + f % 2], b->face[f].at[2]);
  }
  for (int c = 0; c < (b->rod ? 2 : 8); c++) {
    int at[3];

    corner_of(b, c, at);
    for (int k = 0; k < 3; k++) {
      b->low[k] = c == 0 || at[k] < b->low[k] ? at[k] : b->low[k];
      b->high[k] = c == 0 || at[k] > b->high[k] ? at[k] : b->high[k];
    }
  }
}

static bool
add_row(sg_relation relation, const sg_value *row)
{
  return sg_world_add(call.world, relation, row, NULL, NULL) == SG_OK;
}

static bool
add_named(int32_t s, int32_t kind)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_int(&b, s);
  bool good =
      add_row(SG_SEGMENT,
              (sg_value[]){{.i = s}, {.i = kind}, {.term = sg_term_words(&b)}});

  sg_term_close(&b);
  return good;
}

/* Polygons are triangles; edges are those of rods. */
static bool
write_block(const block *b)
{
  bool good = add_named(b->s, b->rod ? SG_SYMBOL_CURVE : SG_SYMBOL_SOLID);

  for (int32_t c = 0; c < (b->rod ? 2 : 8) && good; c++) {
    int at[3];

    corner_of(b, c, at);
    good = add_row(SG_V, (sg_value[]){{.i = b->s},
                                      {.i = c + 1},
                                      {.f = at[0]},
                                      {.f = at[1]},
                                      {.f = at[2]}});
  }
  if (b->rod) {
    return good &&
           add_row(SG_E,
                   (sg_value[]){
                       {.i = b->s}, {.i = 1}, {.i = 1}, {.i = 2}, {.i = 1}});
  }
  for (int32_t f = 0; f < 12 && good; f++) {
    int32_t v[3] = {0, 0, 0};

    for (int k = 0; k < 3; k++) {
      for (int c = 0; c < 8; c++) {
        int at[3];

        corner_of(b, c, at);
        v[k] = same_place(at, b->face[f].at[k]) ? c + 1 : v[k];
      }
    }
    good = add_row(SG_P, (sg_value[]){{.i = b->s},
                                      {.i = f + 1},
                                      {.list = (int32_t[]){0}}}) &&
           add_row(SG_T, (sg_value[]){{.i = b->s},
                                      {.i = f + 1},
                                      {.i = f + 1},
                                      {.i = v[0]},
                                      {.i = v[1]},
                                      {.i = v[2]}});
  }
  return good;
}

static void
add(const int o[3], const int way[3][3], bool rod)
{
  block *b = &crowd.at[crowd.n];

  *b = (block){.s = 3 + 2 * (int32_t)crowd.n, .rod = rod};
  memcpy(b->o, o, sizeof b->o);
  memcpy(b->way, way, sizeof b->way);
  find_faces(b);
  crowd.n++;
  CHECK("a block", write_block(b));
}

/* ---- what is near ---- */

/* Along each axis. */
static bool
boxes_near(const block *a, const block *b, double reach)
{
  for (int k = 0; k < 3; k++) {
    if (a->low[k] - b->high[k] > reach || b->low[k] - a->high[k] > reach) {
      return false;
    }
  }
  return true;
}

static bool
rod_meets(const block *rod, const block *b)
{
  int p[3], q[3];

  corner_of(rod, 0, p);
  corner_of(rod, 1, q);
  for (int f = 0; f < 12; f++) {
    if (meets(p, q, &b->face[f])) {
      return true;
    }
  }
  return false;
}

static bool
blocks_meet(const block *a, const block *b)
{
  if (a->rod || b->rod) {
    return a->rod ? rod_meets(a, b) : rod_meets(b, a);
  }
  for (int f = 0; f < 12; f++) {
    for (int g = 0; g < 12; g++) {
      if (triangles_meet(&a->face[f], &b->face[g])) {
        return true;
      }
    }
  }
  return false;
}

/* Whether corners are within the reach. */
static bool
corners_near(const block *a, const block *b, int reach)
{
  for (int i = 0; i < (a->rod ? 2 : 8); i++) {
    for (int j = 0; j < (b->rod ? 2 : 8); j++) {
      int p[3], q[3];

      corner_of(a, i, p);
      corner_of(b, j, q);
      if (abs(p[0] - q[0]) <= reach && abs(p[1] - q[1]) <= reach &&
          abs(p[2] - q[2]) <= reach) {
        return true;
      }
    }
  }
  return false;
}

typedef struct counts {
  size_t found, wrong, boxes;
} counts;

static bool
is_listed(const sg_id_pair_list *pairs, int32_t s1, int32_t s2)
{
  for (size_t i = 0; i < pairs->n; i++) {
    if (pairs->at[i].a == s1 && pairs->at[i].b == s2) {
      return true;
    }
  }
  return false;
}

static bool
in_order(const sg_id_pair_list *pairs)
{
  for (size_t i = 1; i < pairs->n; i++) {
    const sg_id_pair *p = &pairs->at[i - 1], *q = &pairs->at[i];

    if (p->a > q->a || (p->a == q->a && p->b >= q->b)) {
      return false;
    }
  }
  return true;
}

/* Those that meet are among them, and all are near; not two rods if `to_cut`.
 */
static counts
judge(const sg_id_pair_list *pairs, int reach, bool to_cut)
{
  counts out = {pairs->n, !in_order(pairs), 0};

  for (size_t j = 0; j < crowd.n; j++) {
    for (size_t i = 0; i < j; i++) {
      const block *a = &crowd.at[i], *b = &crowd.at[j];
      bool rods = a->rod && b->rod, listed = is_listed(pairs, a->s, b->s);
      bool boxes = boxes_near(a, b, reach) && !(to_cut && rods);

      out.boxes += boxes;
      out.wrong += listed && !boxes;
      out.wrong += !listed && boxes &&
                   ((!rods && blocks_meet(a, b)) || corners_near(a, b, reach));
    }
  }
  return out;
}

static sg_id_pair_list
asked(int reach)
{
  sg_int_list ss = {0};
  sg_id_pair_list pairs = {0};

  for (size_t i = 0; i < crowd.n; i++) {
    CHECK("listed", sg_int_list_add(&call, &ss, crowd.at[i].s));
  }
  CHECK("near", sg_door_near_pairs(&call, reach, &ss, &pairs));
  return pairs;
}

/* As pairs of the door for some; each pair is told of by both. */
static sg_id_pair_list
asked_of(int reach, size_t *wrong)
{
  sg_int_list ss = {0};
  sg_near_others_list of = {0};
  sg_id_pair_list pairs = {0}, back = {0};

  for (size_t i = 0; i < crowd.n; i++) {
    CHECK("listed", sg_int_list_add(&call, &ss, crowd.at[i].s));
  }
  CHECK("others", sg_door_near_segments_of(&call, reach, &ss, &of));
  *wrong += of.n != crowd.n;
  for (size_t i = 0; i < of.n; i++) {
    for (size_t k = 0; k < of.at[i].others.n; k++) {
      int32_t s = of.at[i].s, s2 = of.at[i].others.at[k];
      sg_id_pair one = s < s2 ? (sg_id_pair){s, s2} : (sg_id_pair){s2, s};

      CHECK("a pair", sg_id_pair_list_add(&call, s < s2 ? &pairs : &back, one));
    }
  }
  *wrong += back.n != pairs.n;
  for (size_t i = 0; i < back.n; i++) {
    *wrong += !is_listed(&pairs, back.at[i].a, back.at[i].b);
  }
  return pairs;
}

/* The pairs to cut, and those of boxes; what is kept for the second question
 * changes no answer. */
static counts
near_within(int reach)
{
  counts out = {0};

  for (int turn = 0; turn < 2; turn++) {
    sg_id_pair_list pairs = asked(reach);
    size_t wrong = 0;

    out = judge(&pairs, reach, true);
    pairs = asked_of(reach, &wrong);
    wrong += judge(&pairs, reach, false).wrong;
    CHECK("what meets is near, what is near has boxes that are",
          out.wrong + wrong == 0);
    sg_call_rest(&call);
  }
  return out;
}

static void
open_crowd(void)
{
  crowd.n = 0;
  sg_call_open(&call, NULL, NULL);
  CHECK("a world", (call.world = sg_world_open()));
}

static void
close_crowd(void)
{
  sg_world *world = call.world;

  sg_call_close(&call);
  sg_world_drop(world);
}

/* ---- crowds ---- */

static const int along[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
static const int askew[3][3] = {{2, 2, 1}, {-2, 1, 2}, {1, -2, 2}};

/* Each in the next one: the middle of all is one. */
static void
add_nested(int n, const int axis[3][3])
{
  for (int i = 1; i <= n; i++) {
    int o[3] = {0, 0, 0}, way[3][3];

    for (int k = 0; k < 9; k++) {
      way[k / 3][k % 3] = 2 * (i + 1) * axis[k / 3][k % 3];
      o[k % 3] -= (i + 1) * axis[k / 3][k % 3];
    }
    add(o, (const int(*)[3])way, false);
  }
}

static void
add_rods(int n, int size)
{
  for (int i = 0; i < n; i++) {
    int o[3], way[3][3] = {{0}};

    for (int k = 0; k < 3; k++) {
      o[k] = between(-size, size);
      way[0][k] = between(-size, size);
    }
    way[0][0] += way[0][0] == 0;
    add(o, (const int(*)[3])way, true);
  }
}

/* Blocks of this form anywhere. */
static void
add_scattered(int n, const int axis[3][3], const int times[3], int size)
{
  for (int i = 0; i < n; i++) {
    int o[3], way[3][3];

    for (int k = 0; k < 3; k++) {
      o[k] = between(-size, size);
      for (int c = 0; c < 3; c++) {
        way[k][c] = times[k] * axis[k][c];
      }
    }
    add(o, (const int(*)[3])way, false);
  }
}

static void
nested(const int axis[3][3])
{
  open_crowd();
  add_nested(40, axis);
  counts c = near_within(0);
  CHECK("what is in each other is not near", c.boxes == 780 && c.found == 0);
  c = near_within(1);
  CHECK("within a reach it is", c.found == 780);
  add_rods(1, 30);
  c = near_within(0);
  CHECK("a rod goes through some", c.found > 0 && c.found <= 40);
  close_crowd();
}

static void
rods_in_nested(void)
{
  open_crowd();
  add_nested(30, askew);
  add_rods(30, 60);
  counts c = near_within(0);
  CHECK("of so many rods boxes are taken", c.found > 0);
  close_crowd();
}

static void
scattered(uint32_t round)
{
  static const int cube[3] = {2, 2, 2}, needle[3] = {14, 1, 1};
  const int size = 6 + check_below(&seed, 30);

  seed = round;
  open_crowd();
  add_scattered(40, round % 2 ? along : askew, round % 4 < 2 ? cube : needle,
                size);
  add_rods(round % 3 ? 3 : 20, size);
  near_within(0);
  near_within((int)(round % 3));
  close_crowd();
}

/* Long thin ones side by side: boxes along the axes overlap, they are apart. */
static void
needles(void)
{
  static const int thin[3] = {30, 1, 1};

  open_crowd();
  seed = 3;
  add_scattered(60, askew, thin, 30);
  counts c = near_within(0);
  CHECK("few of many boxes", c.boxes > 600 && c.found < c.boxes / 4);
  close_crowd();
}

static void
without_memory(void)
{
  int32_t ids[MOST];
  const sg_int_list ss = {ids, 33, 33};

  open_crowd();
  seed = 9;
  add_nested(30, askew);
  add_rods(3, 20);
  for (size_t i = 0; i < crowd.n; i++) {
    ids[i] = crowd.at[i].s;
  }
  sg_id_pair_list pairs = {0};
  sg_near_others_list of = {0};

  CHECK_DOOR("crowd", sg_door_near_pairs(&call, 0, &ss, &pairs) &&
                          judge(&pairs, 0, true).wrong == 0);
  CHECK_DOOR("others", sg_door_near_segments_of(&call, 0, &ss, &of));
  close_crowd();
}

int
main(void)
{
  nested(along);
  nested(askew);
  rods_in_nested();
  for (uint32_t round = 0; round < 60; round++) {
    scattered(round);
  }
  needles();
  without_memory();
  return check_report();
}
