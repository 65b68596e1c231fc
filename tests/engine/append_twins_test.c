/* append_twins_test.c -- rows written in place against rows added and checked:
 * two worlds with the same history must be the same. */
#include "rows.h"

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

int
main(void)
{
  for (uint64_t start = 1; start <= 5; start++) {
    test_twins(start);
  }
  return check_report();
}
