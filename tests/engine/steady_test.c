/* steady_test.c -- a world in which one segment after another is made anew, as
 * when leaves of a CSG tree are moved and its root is evaluated again, needs no
 * more memory after 1,500 changes than after 500; and it is right.
 *
 * A change is a transaction: the rows of a leaf go and come, its record is
 * exchanged, and that of the root, which names all leaves. Narrow versions hold
 * the rows of the last 200 leaves. Undo keeps 64 steps.
 */
#include "engine/store.h"
#include "engine/term.h"
#include "tests/check.h"

#include <stdlib.h>

enum {
  LEAVES = 1000,
  ROOT = LEAVES + 1,
  MOST_ROWS = 80,
  EARLY = 500,
  HELD = 200
};

static uint64_t state = 7;

static uint32_t
draw(uint32_t n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(state >> 33) % n;
}

/* ---- changes ------------------------------------------------------------- */

static bool
add_vertices(sg_world *world, int32_t s, int32_t n, double x)
{
  int32_t of[MOST_ROWS], id[MOST_ROWS];
  double at[MOST_ROWS];
  const void *column[5] = {of, id, at, at, at};

  for (int32_t i = 0; i < n; i++) {
    of[i] = s;
    id[i] = i + 1;
    at[i] = x;
  }
  return sg_world_add_many(world, SG_V, (size_t)n, column, NULL) == SG_OK;
}

/* origin(S, v(1), [Stamp, ...]), with n stamps. */
static bool
add_record(sg_world *world, int32_t s, int32_t n)
{
  sg_term_builder item, record;
  sg_value row[SG_MAX_COLUMNS] = {{.i = s}};
  bool good;

  sg_term_open(&item);
  sg_term_open(&record);
  sg_term_unary(&item, SG_SYMBOL_V, 1);
  sg_term_compound(&record, SG_SYMBOL_MINUS, (size_t)n);
  for (int32_t i = 0; i < n; i++) {
    sg_term_pair(&record, i + 1, 1000000 + (int64_t)draw(1000000));
  }
  row[1].term = sg_term_words(&item);
  row[2].term = sg_term_words(&record);
  good = row[1].term && row[2].term &&
         sg_world_add(world, SG_ORIGIN, row, NULL, NULL) == SG_OK;
  sg_term_close(&item);
  sg_term_close(&record);
  return good;
}

static bool
retract_record(sg_world *world, int32_t s)
{
  return sg_world_retract_with(world, SG_ORIGIN, 0, s);
}

static bool
change(sg_world *world, int32_t leaf, double x)
{
  return sg_world_begin(world) == SG_OK &&
         sg_world_retract_with(world, SG_V, 0, leaf) &&
         add_vertices(world, leaf, 40 + (int32_t)draw(MOST_ROWS - 40), x) &&
         retract_record(world, leaf) &&
         add_record(world, leaf, 1 + (int32_t)draw(20)) &&
         retract_record(world, ROOT) && add_record(world, ROOT, LEAVES) &&
         sg_world_commit(world) == SG_OK;
}

/* ---- what is held -------------------------------------------------------- */

typedef struct held {
  const sg_version *version;
  int32_t leaf;
  double x; /* of its vertices */
} held;

static bool
hold(sg_world *world, held *h, int32_t leaf, double x)
{
  const sg_version *all = sg_world_version(world);

  sg_version_drop(h->version);
  *h = (held){sg_version_narrow(all, UINT64_C(1) << SG_V, &leaf, 1), leaf, x};
  sg_version_drop(all);
  return h->version != NULL;
}

/* It shows the vertices of its leaf, and no others. */
static bool
is_right(const held *h)
{
  sg_value row[SG_MAX_COLUMNS] = {{.i = h->leaf}};
  size_t n = 0;
  sg_walk walk;
  bool right = true;

  if (!sg_walk_open(&walk, h->version, SG_V, 1, row)) {
    return false;
  }
  for (sg_row r; (r = sg_walk_next(&walk)) != SG_NO_ROW; n++) {
    right = right && sg_version_value(h->version, SG_V, r, 2).f == h->x;
  }
  sg_walk_close(&walk);
  return right && n >= 40 && n == sg_version_count(h->version, SG_V);
}

/* ---- together ------------------------------------------------------------ */

static size_t
bytes_of(sg_world *world, sg_relation relation)
{
  sg_statistics s;

  sg_world_statistics(world, relation, &s);
  return s.bytes + s.index_bytes + s.version_bytes;
}

static bool
fill(sg_world *world)
{
  bool good = true;

  for (int32_t s = 1; good && s <= LEAVES; s++) {
    good = add_vertices(world, s, 60, 0) && add_record(world, s, 4);
  }
  return good && add_record(world, ROOT, LEAVES);
}

/* The most that a relation took. */
static void
note_most(sg_world *world, sg_relation relation, size_t *most)
{
  size_t bytes = bytes_of(world, relation);

  *most = bytes > *most ? bytes : *most;
}

/* Of vertices and of records. */
typedef struct peaks {
  size_t vertices, records;
} peaks;

static bool
changes(sg_world *world, held *h, int number, peaks *most)
{
  bool good = true;

  for (int i = 0; good && i < number; i++) {
    int32_t leaf = 1 + (int32_t)draw(LEAVES);
    double x = draw(1000);
    good = change(world, leaf, x) && hold(world, &h[i % HELD], leaf, x);
    note_most(world, SG_V, &most->vertices);
    note_most(world, SG_ORIGIN, &most->records);
  }
  return good;
}

int
main(void)
{
  static held h[HELD];
  sg_world *world = sg_world_open();
  bool good = fill(world), right = true;
  peaks early = {0}, late = {0};

  good = good && changes(world, h, EARLY, &early) &&
         changes(world, h, 2 * EARLY, &late);
  CHECK("all changes were made", good);
  for (unsigned i = 0; i < HELD; i++) {
    right = right && is_right(&h[i]);
  }
  CHECK("what is held shows what it did", right);
  CHECK("valid", sg_world_is_valid(world));
  CHECK("vertices need no more room",
        late.vertices < early.vertices + early.vertices / 10);
  CHECK("records need no more room",
        late.records < early.records + early.records / 10);
  while (sg_world_undo(world) == SG_OK) {
  }
  CHECK("valid after undoing", sg_world_is_valid(world));
  for (unsigned i = 0; i < HELD; i++) {
    sg_version_drop(h[i].version);
  }
  sg_world_drop(world);
  return check_report();
}
