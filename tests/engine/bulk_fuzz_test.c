/* bulk_fuzz_test.c -- rows in bulk, appended and checked, on slots that are
 * used again, with undo and held versions, against a plain table of them.
 *
 *   bulk_fuzz_test [FIRST_SEED SEEDS]
 */
#include "engine/store.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

static uint64_t seed;

static uint32_t
draw(uint32_t n)
{
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(seed >> 33) % n;
}

/* ---- the plain table ----------------------------------------------------- */

/* Edges of segments 1 .. 3, polygons of 4 .. 6. A row has a value from 1 to
 * VALUES, of which its other columns are made; 0: there is no row. */
enum { SEGMENTS = 6, OF_EDGES = 3, IDS = 8000, VALUES = 40, LONGEST = 5 };

typedef struct plain {
  uint8_t value[SEGMENTS + 1][IDS + 1];
} plain;

static sg_relation
relation_of(int32_t s)
{
  return s <= OF_EDGES ? SG_E : SG_P;
}

/* A polygon's edges: its length first. */
static void
list_of(uint8_t value, int32_t *list)
{
  list[0] = value % (LONGEST + 1);
  for (int32_t i = 1; i <= list[0]; i++) {
    list[i] = 1 + (value + i) % VALUES;
  }
}

static bool
has_member(uint8_t value, int32_t edge)
{
  int32_t list[1 + LONGEST];
  bool has = false;

  list_of(value, list);
  for (int32_t i = 1; value && i <= list[0]; i++) {
    has = has || list[i] == edge;
  }
  return has;
}

static bool
row_is_right(const sg_version *version, sg_relation relation, sg_row row,
             uint8_t value)
{
  int32_t list[1 + LONGEST];
  sg_value there = sg_version_value(version, relation, row, 2);

  list_of(value, list);
  return value > 0 &&
         (relation == SG_E ? there.i == value
                           : memcmp(there.list, list,
                                    (1 + (size_t)list[0]) * sizeof *list) == 0);
}

/* ---- the world beside it ------------------------------------------------- */

enum { UNDO = 4, HELD = 3 };

typedef struct steps {
  plain at[UNDO + 1];
  size_t count;
} steps;

typedef struct game {
  sg_world *world;
  plain now, before;
  steps undo, redo;
  const sg_version *held[HELD];
  plain shows[HELD];
  bool changed;
} game;

static void
push(steps *stack, const plain *p)
{
  if (stack->count == UNDO) {
    memmove(stack->at, stack->at + 1, (UNDO - 1) * sizeof *stack->at);
    stack->count--;
  }
  stack->at[stack->count++] = *p;
}

/* Vertices for edges to refer to, edges for polygons. */
static bool
add_ends(sg_world *world, int32_t s)
{
  bool good = true;

  for (int32_t id = 1; good && id <= VALUES; id++) {
    sg_value vertex[SG_MAX_COLUMNS] = {{.i = s}, {.i = id}};
    sg_value edge[SG_MAX_COLUMNS] = {
        {.i = s}, {.i = id}, {.i = id}, {.i = id}, {.i = 1}};
    good =
        sg_world_add(world, SG_V, vertex, NULL, NULL) == SG_OK &&
        (s <= OF_EDGES || sg_world_add(world, SG_E, edge, NULL, NULL) == SG_OK);
  }
  return good;
}

/* ---- rows to be added ---------------------------------------------------- */

static struct batch {
  int32_t s;
  size_t n;
  int32_t cell[5][IDS]; /* by column, as of edges */
  int32_t list[IDS][1 + LONGEST];
  const int32_t *lists[IDS];
} batch;

static void
put(int32_t id)
{
  size_t k = batch.n++;
  uint8_t value = (uint8_t)(1 + draw(VALUES));

  batch.cell[0][k] = batch.s;
  batch.cell[1][k] = id;
  batch.cell[2][k] = batch.cell[3][k] = value;
  batch.cell[4][k] = 1;
  list_of(value, batch.list[k]);
  batch.lists[k] = batch.list[k];
}

/* New ids, dense or scattered; also some that there are, if wanted: the number
 * of those. */
static size_t
make_batch(const plain *now, bool also_old)
{
  static const uint32_t size[] = {40, 40, 300, 5000, IDS};
  size_t most = 1 + draw(size[draw(5)]), old = 0;
  int32_t first = 1 + (int32_t)draw(draw(2) ? 10 : IDS);
  uint32_t one_in = draw(3) ? 1 : 1 + draw(3);

  batch.s = 1 + (int32_t)draw(SEGMENTS);
  batch.n = 0;
  for (int32_t id = first; id <= IDS && batch.n < most; id++) {
    bool there = now->value[batch.s][id] > 0;
    if (draw(one_in) == 0 && (!there || (also_old && draw(2000) == 0))) {
      old += there;
      put(id);
    }
  }
  return old;
}

static uint8_t
value_at(size_t k)
{
  return (uint8_t)batch.cell[2][k];
}

static void
note_batch(game *g, size_t n)
{
  for (size_t k = 0; k < n; k++) {
    g->now.value[batch.s][batch.cell[1][k]] = value_at(k);
  }
  g->changed = g->changed || n > 0;
}

/* ---- what is done -------------------------------------------------------- */

static bool
do_add_many(game *g)
{
  bool exists = make_batch(&g->now, draw(3) == 0) > 0;
  const void *column[5] = {batch.cell[0], batch.cell[1], batch.cell[2],
                           batch.cell[3], batch.cell[4]};

  if (relation_of(batch.s) == SG_P) {
    column[2] = batch.lists;
  }
  if (!exists) {
    note_batch(g, batch.n);
  }
  return sg_world_add_many(g->world, relation_of(batch.s), batch.n, column,
                           NULL) == (exists ? SG_EXISTS : SG_OK);
}

static bool
fill_lists(sg_append *a, size_t k)
{
  const sg_sheet_page *page = &a->sheet.page[k];
  int32_t length[SG_PAGE_ROWS];

  for (size_t i = 0; i < page->n; i++) {
    length[i] = batch.list[page->from + i][0];
  }
  if (!sg_append_lists(a, k, 2, length)) {
    return false;
  }
  for (size_t i = 0; i < page->n; i++) {
    memcpy(page->column[2].list[i], batch.list[page->from + i],
           (1 + (size_t)length[i]) * sizeof(int32_t));
  }
  return true;
}

static bool
fill(sg_append *a)
{
  bool good = true;

  for (size_t k = 0; k < a->sheet.pages; k++) {
    const sg_sheet_page *page = &a->sheet.page[k];
    for (unsigned c = 0; c < (a->relation == SG_E ? 5 : 2); c++) {
      memcpy(page->column[c].i, batch.cell[c] + page->from,
             page->n * sizeof(int32_t));
    }
    good = good && (a->relation == SG_E || fill_lists(a, k));
  }
  return good;
}

/* All of them, the first ones, or, closed without a commit, none. */
static bool
do_append(game *g)
{
  sg_append a;
  bool good, commits = draw(10) > 0;
  size_t n;

  make_batch(&g->now, false);
  n = draw(6) == 0 ? draw((uint32_t)batch.n + 1) : batch.n;
  if (!sg_append_open(&a, g->world, relation_of(batch.s), batch.n)) {
    return false;
  }
  good = fill(&a);
  if (n < batch.n) {
    sg_append_shorten(&a, n);
  }
  if (commits) {
    good = good && sg_append_commit(&a);
    note_batch(g, n);
  }
  sg_append_close(&a);
  return good;
}

static sg_row
find_row(game *g, int32_t s, int32_t id)
{
  const sg_version *version = sg_world_version(g->world);
  sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.i = id}};
  sg_row row = sg_version_find(version, relation_of(s), key);

  sg_version_drop(version);
  return row;
}

static bool
retract_one(game *g, int32_t s, int32_t id)
{
  bool there = g->now.value[s][id] > 0;
  sg_row row = find_row(g, s, id);

  g->now.value[s][id] = 0;
  g->changed = g->changed || there;
  return there ? row != SG_NO_ROW &&
                     sg_world_retract(g->world, relation_of(s), row)
               : row == SG_NO_ROW;
}

/* One after the other: most of some ids. */
static bool
do_retract(game *g)
{
  int32_t s = 1 + (int32_t)draw(SEGMENTS), id = 1 + (int32_t)draw(IDS);
  int32_t end = id + (int32_t)draw(draw(4) ? 30 : 3000);
  bool good = true;

  for (; good && id < end && id <= IDS; id++) {
    good = draw(8) == 0 || retract_one(g, s, id);
  }
  return good;
}

static int
compare_rows(const void *a, const void *b)
{
  sg_row x = *(const sg_row *)a, y = *(const sg_row *)b;

  return (x > y) - (x < y);
}

/* Some ids, most of a stretch or few of all, lose their rows, and these and
 * others get new ones. */
static bool
do_exchange(game *g)
{
  static sg_row gone[IDS];
  const void *column[5] = {batch.cell[0], batch.cell[1], batch.cell[2],
                           batch.cell[3], batch.cell[4]};
  int32_t s = 1 + (int32_t)draw(SEGMENTS), id = 1 + (int32_t)draw(IDS);
  int32_t end = id + (int32_t)draw(draw(4) ? 30 : 3000);
  uint32_t one_in = 1 + draw(4);
  size_t gones = 0;

  batch.s = s;
  batch.n = 0;
  for (; id < end && id <= IDS; id++) {
    uint8_t *there = &g->now.value[s][id];
    if (*there && draw(one_in) == 0) {
      gone[gones++] = find_row(g, s, id);
      *there = 0;
    }
    if (!*there && draw(one_in) == 0) {
      put(id);
    }
  }
  qsort(gone, gones, sizeof *gone, compare_rows);
  column[2] = relation_of(s) == SG_P ? (const void *)batch.lists : column[2];
  g->changed = g->changed || gones > 0;
  note_batch(g, batch.n);
  return sg_world_exchange(g->world, relation_of(s), gone, gones, batch.n,
                           column);
}

static void
forget(game *g, int32_t s)
{
  for (int32_t id = 1; id <= IDS; id++) {
    g->changed = g->changed || g->now.value[s][id] > 0;
    g->now.value[s][id] = 0;
  }
}

/* All rows of a segment, or all polygons. */
static bool
do_retract_with(game *g)
{
  int32_t s = 1 + (int32_t)draw(SEGMENTS);

  if (draw(8) == 0) {
    for (s = OF_EDGES + 1; s <= SEGMENTS; s++) {
      forget(g, s);
    }
    return sg_world_retract_all(g->world, SG_P);
  }
  forget(g, s);
  return sg_world_retract_with(g->world, relation_of(s), 0, s);
}

static bool
do_hold(game *g)
{
  size_t k = draw(HELD);

  sg_version_drop(g->held[k]);
  g->held[k] = draw(3) ? sg_world_version(g->world) : NULL;
  g->shows[k] = g->now;
  return true;
}

static bool
do_single(game *g)
{
  bool good = true;

  for (uint32_t left = 1 + draw(200); good && left > 0; left--) {
    int32_t s = 1 + (int32_t)draw(SEGMENTS), id = 1 + (int32_t)draw(IDS);
    uint8_t value = (uint8_t)(1 + draw(VALUES)), *there = &g->now.value[s][id];
    int32_t list[1 + LONGEST];
    sg_value row[SG_MAX_COLUMNS] = {
        {.i = s}, {.i = id}, {.i = value}, {.i = value}, {.i = 1}};
    list_of(value, list);
    if (relation_of(s) == SG_P) {
      row[2].list = list;
    }
    good = sg_world_add(g->world, relation_of(s), row, NULL, NULL) ==
           (*there ? SG_EXISTS : SG_OK);
    g->changed = g->changed || !*there;
    *there = *there ? *there : value;
  }
  return good;
}

static bool
do_one(game *g)
{
  uint32_t what = draw(100);

  return what < 30   ? do_append(g)
         : what < 50 ? do_add_many(g)
         : what < 57 ? do_retract(g)
         : what < 65 ? do_exchange(g)
         : what < 85 ? do_retract_with(g)
         : what < 90 ? do_single(g)
                     : do_hold(g);
}

/* Some of that as one step, which may be rolled back, or outside of any. */
static bool
do_step(game *g)
{
  bool step = draw(5) > 0, back = step && draw(6) == 0, good = true;

  g->before = g->now;
  g->changed = false;
  good = !step || sg_world_begin(g->world) == SG_OK;
  for (uint32_t left = 1 + draw(4); good && left > 0; left--) {
    good = do_one(g);
  }
  if (back) {
    for (size_t k = 0; k < HELD; k++) {
      sg_version_drop(g->held[k]);
      g->held[k] = NULL;
    }
    g->now = g->before;
    return good && sg_world_rollback(g->world) == SG_OK;
  }
  if (step && g->changed) {
    push(&g->undo, &g->before);
  }
  g->redo.count = g->changed ? 0 : g->redo.count;
  return good && (!step || sg_world_commit(g->world) == SG_OK);
}

static bool
do_undo(game *g)
{
  bool redo = draw(3) == 0;
  steps *from = redo ? &g->redo : &g->undo, *to = redo ? &g->undo : &g->redo;
  sg_status status = from->count > 0 ? SG_OK : SG_NO_STEP;

  if (status == SG_OK) {
    push(to, &g->now);
    g->now = from->at[--from->count];
  }
  return (redo ? sg_world_redo : sg_world_undo)(g->world) == status;
}

/* ---- are they the same --------------------------------------------------- */

static size_t
rows_of(const plain *p, int32_t s, bool (*is)(uint8_t, int32_t), int32_t of)
{
  size_t n = 0;

  for (int32_t id = 1; id <= IDS; id++) {
    n += is ? is(p->value[s][id], of) : p->value[s][id] > 0;
  }
  return n;
}

static bool
is_value(uint8_t value, int32_t of)
{
  return value == of;
}

/* The rows that a walk gives are right, and as many as expected. */
static bool
walk_is_right(const sg_version *version, const plain *p, sg_relation relation,
              sg_walk *walk, size_t expected)
{
  bool right = true;

  for (sg_row row; (row = sg_walk_next(walk)) != SG_NO_ROW;) {
    int32_t s = sg_version_value(version, relation, row, 0).i;
    int32_t id = sg_version_value(version, relation, row, 1).i;
    if (relation == SG_P || s <= OF_EDGES) {
      right = right && id <= IDS && expected > 0 &&
              row_is_right(version, relation, row, p->value[s][id]);
      expected--;
    }
  }
  sg_walk_close(walk);
  return right && expected == 0;
}

static bool
same_rows(const sg_version *version, const plain *p)
{
  size_t n[2] = {0};
  sg_walk walk;

  for (int32_t s = 1; s <= SEGMENTS; s++) {
    n[s > OF_EDGES] += rows_of(p, s, NULL, 0);
  }
  return sg_walk_open(&walk, version, SG_E, 0, NULL) &&
         walk_is_right(version, p, SG_E, &walk, n[0]) &&
         sg_walk_open(&walk, version, SG_P, 0, NULL) &&
         walk_is_right(version, p, SG_P, &walk, n[1]);
}

static bool
same_keys(const sg_version *version, const plain *p)
{
  bool right = true;

  for (int k = 0; right && k < 100; k++) {
    int32_t s = 1 + (int32_t)draw(SEGMENTS), id = 1 + (int32_t)draw(IDS);
    sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.i = id}};
    sg_row row = sg_version_find(version, relation_of(s), key);
    right = row == SG_NO_ROW
                ? p->value[s][id] == 0
                : row_is_right(version, relation_of(s), row, p->value[s][id]);
  }
  return right;
}

/* By the index of edges, and that of members. */
static bool
same_found(const sg_version *version, const plain *p)
{
  int32_t s = 1 + (int32_t)draw(OF_EDGES), of = 1 + (int32_t)draw(VALUES);
  int32_t s2 = OF_EDGES + 1 + (int32_t)draw(SEGMENTS - OF_EDGES);
  sg_value row[SG_MAX_COLUMNS] = {{.i = s}, {0}, {.i = of}};
  sg_walk walk;

  return sg_walk_open(&walk, version, SG_E, 0x05, row) &&
         walk_is_right(version, p, SG_E, &walk, rows_of(p, s, is_value, of)) &&
         sg_walk_open_member(&walk, version, SG_P, s2, of) &&
         walk_is_right(version, p, SG_P, &walk, rows_of(p, s2, has_member, of));
}

/* Not everything is asked each time: so indexes lag behind. */
static bool
is_same(const sg_version *version, const plain *p)
{
  return same_rows(version, p) && (draw(3) || same_keys(version, p)) &&
         (draw(6) || same_found(version, p));
}

static bool
all_is_same(game *g, int step)
{
  const sg_version *version = sg_world_version(g->world);
  size_t k = draw(HELD);
  bool right = is_same(version, &g->now) &&
               (!g->held[k] || is_same(g->held[k], &g->shows[k]));

  sg_version_drop(version);
  return right && (step % 8 || sg_world_is_valid(g->world));
}

static void
play(uint64_t start, int count)
{
  static game g;
  char name[64];
  bool right = true;

  memset(&g, 0, sizeof g);
  seed = start;
  g.world = sg_world_open();
  sg_world_undo_limit(g.world, UNDO);
  for (int32_t s = 1; right && s <= SEGMENTS; s++) {
    right = add_ends(g.world, s);
  }
  snprintf(name, sizeof name, "rows in bulk, seed %u", (unsigned)start);
  for (int step = 0; right && step < count; step++) {
    right = (draw(6) ? do_step(&g) : do_undo(&g)) && all_is_same(&g, step);
  }
  CHECK(name, right);
  for (size_t k = 0; k < HELD; k++) {
    sg_version_drop(g.held[k]);
  }
  sg_world_drop(g.world);
}

int
main(int argc, char **argv)
{
  uint64_t first = argc > 2 ? strtoull(argv[1], NULL, 10) : 1;
  uint64_t seeds = argc > 2 ? strtoull(argv[2], NULL, 10) : 4;

  for (uint64_t k = 0; k < seeds; k++) {
    play(first + k, 100);
  }
  return check_report();
}
