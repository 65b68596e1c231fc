/* stamp_test.c -- equal stamps mean the same rows in the same slots, whatever
 * was done between: changes, transactions, undo and redo, held versions. */
#include "engine/store.h"
#include "tests/check.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 4000, SEGMENTS = 3, MOST = 200, SEEN = 4 * STEPS };

static uint64_t state = 5;

static uint32_t
draw(uint32_t n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(state >> 33) % n;
}

/* What a stamp stood for when it was first seen. */
typedef struct seen {
  int32_t s;
  uint64_t stamp, rows;
} seen;

static seen known[SEEN];
static size_t knowns;

/* The rows of a segment of v/5 as one number: slots, ids, values. */
static uint64_t
rows_of(const sg_version *version, int32_t s)
{
  sg_value row[SG_MAX_COLUMNS] = {{.i = s}};
  uint64_t sum = 0;
  sg_walk walk;

  if (!sg_walk_open(&walk, version, SG_V, 1, row)) {
    return 0;
  }
  for (sg_row r; (r = sg_walk_next(&walk)) != SG_NO_ROW;) {
    int32_t id = sg_version_value(version, SG_V, r, 1).i;
    double x = sg_version_value(version, SG_V, r, 2).f;
    sum += (r + 1) * UINT64_C(0x9e3779b97f4a7c15) +
           (uint64_t)id * UINT64_C(0xc2b2ae3d27d4eb4f) + (uint64_t)x;
    sum ^= sum >> 29;
  }
  sg_walk_close(&walk);
  return sum;
}

/* Notes the stamps of a version, and compares with what they stood for;
 * segment 0 is all of them. */
static bool
agrees(const sg_version *version)
{
  uint64_t all = 0;

  for (int32_t s = SEGMENTS; s >= 0; s--) {
    uint64_t stamp = s == 0 ? sg_version_last_stamp(version, SG_V)
                            : sg_version_stamp(version, SG_V, s);
    uint64_t rows = s == 0 ? all : rows_of(version, s);
    size_t i = 0;

    all = 3 * all + rows;

    while (i < knowns && (known[i].s != s || known[i].stamp != stamp)) {
      i++;
    }
    if (i == knowns && knowns < SEEN) {
      known[knowns++] = (seen){s, stamp, rows};
    }
    if (i < SEEN && known[i].rows != rows) {
      return false;
    }
  }
  return true;
}

static void
add_one(sg_world *world)
{
  sg_value row[SG_MAX_COLUMNS] = {{.i = 1 + (int32_t)draw(SEGMENTS)},
                                  {.i = 1 + (int32_t)draw(MOST)},
                                  {.f = draw(1000)}};

  sg_world_add(world, SG_V, row, NULL, NULL);
}

static void
add_some(sg_world *world)
{
  int32_t s[4], id[4];
  double x[3][4] = {{0}};

  for (int i = 0; i < 4; i++) {
    s[i] = 1 + (int32_t)draw(SEGMENTS);
    id[i] = 1 + (int32_t)draw(MOST);
    x[0][i] = draw(1000);
  }
  sg_world_add_many(world, SG_V, 4, (const void *[]){s, id, x[0], x[1], x[2]},
                    NULL);
}

static void
change(sg_world *world)
{
  switch (draw(12)) {
  case 0:
    sg_world_begin(world);
    break;
  case 1:
    sg_world_commit(world);
    break;
  case 2:
    sg_world_rollback(world);
    break;
  case 3:
    sg_world_undo(world);
    break;
  case 4:
    sg_world_redo(world);
    break;
  case 5:
    if (draw(40) == 0) {
      sg_world_retract_all(world, SG_V);
    } else if (draw(8) == 0) {
      sg_world_retract_with(world, SG_V, 0, 1 + (int32_t)draw(SEGMENTS));
    }
    break;
  case 6:
  case 7:
    sg_world_retract(world, SG_V, draw(2 * MOST));
    break;
  case 8:
    add_some(world);
    break;
  default:
    add_one(world);
  }
}

static bool
play(sg_world *world)
{
  const sg_version *held = sg_world_version(world);
  bool good = true;

  for (int step = 0; step < STEPS && good; step++) {
    const sg_version *now;

    change(world);
    now = sg_world_version(world);
    good = agrees(now) && agrees(held);
    if (draw(20) == 0) {
      sg_version_drop(held);
      held = now;
    } else {
      sg_version_drop(now);
    }
  }
  sg_version_drop(held);
  return good;
}

/* A change gives a new stamp to its own segment only; undo the old one. */
static void
test_change(void)
{
  sg_world *world = sg_world_open();
  sg_value one[SG_MAX_COLUMNS] = {{.i = 1}, {.i = 1}};
  sg_value two[SG_MAX_COLUMNS] = {{.i = 2}, {.i = 1}};
  uint64_t first, second;

  CHECK("two rows", sg_world_add(world, SG_V, one, NULL, NULL) == SG_OK &&
                        sg_world_add(world, SG_V, two, NULL, NULL) == SG_OK);
  const sg_version *version = sg_world_version(world);
  first = sg_version_stamp(version, SG_V, 1);
  second = sg_version_stamp(version, SG_V, 2);
  sg_version_drop(version);
  CHECK("a stamp each", first && second && first != second);
  CHECK("begun", sg_world_begin(world) == SG_OK);
  CHECK("retracted", sg_world_retract(world, SG_V, 0));
  CHECK("done", sg_world_commit(world) == SG_OK);
  version = sg_world_version(world);
  CHECK("a new stamp", sg_version_stamp(version, SG_V, 1) != first);
  CHECK("not for the other", sg_version_stamp(version, SG_V, 2) == second);
  CHECK("none for nobody", sg_version_stamp(version, SG_V, 9) == 0);
  sg_version_drop(version);
  CHECK("undone", sg_world_undo(world) == SG_OK);
  version = sg_world_version(world);
  CHECK("the old one", sg_version_stamp(version, SG_V, 1) == first);
  sg_version_drop(version);
  sg_world_drop(world);
}

static int dropped;

typedef struct counted {
  pthread_mutex_t lock;
  int n;
} counted;

static void
drop_note(void *note)
{
  counted *c = note;

  dropped += c->n;
  pthread_mutex_destroy(&c->lock);
  free(c);
}

static void
drop_number(void *note)
{
  dropped += *(int *)note;
}

static void
test_notes(void)
{
  sg_world *world = sg_world_open();
  int ten = 10;

  CHECK("none at first", !sg_world_note(world, SG_NOTE_TREES));
  counted *made =
      sg_world_add_note(world, SG_NOTE_TREES, sizeof *made, drop_note);

  CHECK("made", made && made->n == 0 && pthread_mutex_lock(&made->lock) == 0);
  made->n = 1;
  pthread_mutex_unlock(&made->lock);
  CHECK("once", sg_world_add_note(world, SG_NOTE_TREES, sizeof *made,
                                  drop_note) == made);
  sg_world_set_note(world, SG_NOTE_RULES, &ten, drop_number);
  CHECK("another sort", sg_world_note(world, SG_NOTE_RULES) == &ten);
  sg_world_drop(world);
  CHECK("both dropped with the world", dropped == 11);
}

int
main(void)
{
  sg_world *world = sg_world_open();

  CHECK("a stamp stands for the same rows always", play(world));
  CHECK("many stamps", knowns > STEPS / 4);
  CHECK("valid at the end", sg_world_is_valid(world));
  sg_world_drop(world);
  test_change();
  test_notes();
  return check_report();
}
