/* store_test.c -- the store against a naive model. */
#include "engine/store.h"
#include "tests/check.h"

#include <string.h>

/* ---- the naive model: rows of v and e as plain arrays ------------------- */

enum { MOST = 256, STEPS = 6000, HELD = 4, DEEP = 4, LIMIT = 5 };

typedef struct plain_row {
  int32_t s, id, a, b;
  double x;
} plain_row;

typedef struct plain {
  size_t n[2];
  plain_row row[2][MOST]; /* v: a, b unused; e: a -> b */
} plain;

static uint64_t seed;

static uint32_t
draw(uint32_t n)
{
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(seed >> 33) % n;
}

static size_t
plain_find(const plain *p, int r, int32_t s, int32_t id)
{
  for (size_t i = 0; i < p->n[r]; i++) {
    if (p->row[r][i].s == s && p->row[r][i].id == id) {
      return i;
    }
  }
  return MOST;
}

static void
plain_delete(plain *p, int r, size_t i)
{
  p->row[r][i] = p->row[r][--p->n[r]];
}

static void
to_values(int r, const plain_row *row, sg_value *out)
{
  memset(out, 0, SG_MAX_COLUMNS * sizeof(*out));
  out[0].i = row->s;
  out[1].i = row->id;
  if (r == 0) {
    out[2].f = row->x;
    out[3].f = -0.0;
    out[4].f = 1.5;
  } else {
    out[2].i = row->a;
    out[3].i = row->b;
    out[4].i = 1;
  }
}

static const sg_relation relation_of[2] = {SG_V, SG_E};

/* Every row of the version is in the model, and as many. */
static bool
same(const sg_version *version, const plain *p)
{
  for (int r = 0; r < 2; r++) {
    sg_walk walk;
    size_t n = 0;
    if (!sg_walk_open(&walk, version, relation_of[r], 0, NULL)) {
      return false;
    }
    for (sg_row row; (row = sg_walk_next(&walk)) != SG_NO_ROW; n++) {
      sg_value s = sg_version_value(version, relation_of[r], row, 0);
      sg_value id = sg_version_value(version, relation_of[r], row, 1);
      sg_value third = sg_version_value(version, relation_of[r], row, 2);
      size_t i = plain_find(p, r, s.i, id.i);
      if (i == MOST ||
          (r == 0 ? third.f != p->row[r][i].x : third.i != p->row[r][i].a)) {
        return false;
      }
    }
    sg_walk_close(&walk);
    if (n != p->n[r] || n != sg_version_count(version, relation_of[r])) {
      return false;
    }
  }
  return true;
}

/* Look-ups by each index give what a count in the model gives. */
static bool
lookups_agree(const sg_version *version, const plain *p)
{
  static const uint16_t masks[] = {0x03, 0x05, 0x09, 0x0d, 0x01, 0x0c};
  uint16_t mask = masks[draw(6)];
  sg_value key[SG_MAX_COLUMNS] = {0};
  size_t n = 0;
  size_t expected = 0;
  sg_row last = 0;
  sg_walk walk;

  key[0].i = (int32_t)draw(3) + 1;
  for (int c = 1; c < 4; c++) {
    key[c].i = (int32_t)draw(12) + 1;
  }
  for (size_t i = 0; i < p->n[1]; i++) {
    const plain_row *row = &p->row[1][i];
    expected += (!(mask & 1) || row->s == key[0].i) &&
                (!(mask & 2) || row->id == key[1].i) &&
                (!(mask & 4) || row->a == key[2].i) &&
                (!(mask & 8) || row->b == key[3].i);
  }
  if (!sg_walk_open(&walk, version, SG_E, mask, key)) {
    return false;
  }
  for (sg_row row; (row = sg_walk_next(&walk)) != SG_NO_ROW; n++) {
    if (n > 0 && row <= last) {
      return false;
    }
    last = row;
  }
  sg_walk_close(&walk);
  return n == expected;
}

/* ---- random operations ------------------------------------------------- */

typedef struct held {
  const sg_version *version;
  plain shows;
} held;

typedef struct play {
  sg_world *world;
  plain now;
  plain before[DEEP]; /* of open transactions */
  size_t depth;
  unsigned changes, changes_at[DEEP]; /* when each began */
  plain undo[LIMIT], redo[LIMIT];
  size_t undos, redos;
  held held[HELD];
} play;

static void
note_change(play *g)
{
  g->changes++;
  if (g->depth == 0) {
    g->redos = 0;
  }
}

static void
push(plain *stack, size_t *count, const plain *p)
{
  if (*count == LIMIT) {
    memmove(stack, stack + 1, (LIMIT - 1) * sizeof(*stack));
    --*count;
  }
  stack[(*count)++] = *p;
}

static bool
play_add(play *g)
{
  int r = draw(3) == 0 ? 0 : 1;
  plain_row row = {.s = (int32_t)draw(3) + 1,
                   .id = (int32_t)draw(r == 0 ? 12 : 60) + 1,
                   .a = (int32_t)draw(12) + 1,
                   .b = (int32_t)draw(12) + 1,
                   .x = draw(100) / 8.0};
  bool exists = plain_find(&g->now, r, row.s, row.id) != MOST;
  bool dangling = r == 1 && (plain_find(&g->now, 0, row.s, row.a) == MOST ||
                             plain_find(&g->now, 0, row.s, row.b) == MOST);
  sg_status expected = dangling ? SG_DANGLING : exists ? SG_EXISTS : SG_OK;
  sg_value value[SG_MAX_COLUMNS];
  sg_fault fault;

  to_values(r, &row, value);
  if (expected == SG_OK) {
    g->now.row[r][g->now.n[r]++] = row;
    note_change(g);
  }
  return sg_world_add(g->world, relation_of[r], value, NULL, &fault) ==
         expected;
}

static bool
play_retract(play *g)
{
  int r = draw(4) == 0 ? 0 : 1;
  const sg_version *version = sg_world_version(g->world);
  sg_value key[SG_MAX_COLUMNS] = {0};
  sg_row row;
  size_t i;
  bool done;

  key[0].i = (int32_t)draw(3) + 1;
  key[1].i = (int32_t)draw(r == 0 ? 12 : 60) + 1;
  row = sg_version_find(version, relation_of[r], key);
  i = plain_find(&g->now, r, key[0].i, key[1].i);
  done = row != SG_NO_ROW && sg_world_retract(g->world, relation_of[r], row);
  if (row != SG_NO_ROW && sg_world_retract(g->world, relation_of[r], row)) {
    done = false; /* twice is wrong */
  }
  sg_version_drop(version);
  if (i != MOST) {
    plain_delete(&g->now, r, i);
    note_change(g);
  }
  return done == (i != MOST);
}

static bool
play_begin(play *g)
{
  if (g->depth == DEEP) {
    return true;
  }
  g->changes_at[g->depth] = g->changes;
  g->before[g->depth++] = g->now;
  return sg_world_begin(g->world) == SG_OK;
}

static bool
play_commit(play *g)
{
  if (g->depth == 0) {
    return sg_world_commit(g->world) == SG_NO_STEP;
  }
  if (--g->depth == 0 && g->changes != g->changes_at[0]) {
    push(g->undo, &g->undos, &g->before[0]);
    g->redos = 0;
  }
  return sg_world_commit(g->world) == SG_OK;
}

static bool
play_rollback(play *g)
{
  if (g->depth == 0) {
    return sg_world_rollback(g->world) == SG_NO_STEP;
  }
  g->now = g->before[--g->depth];
  g->changes = g->changes_at[g->depth];
  return sg_world_rollback(g->world) == SG_OK;
}

static bool
play_undo(play *g)
{
  if (g->depth > 0 || g->undos == 0) {
    return sg_world_undo(g->world) == SG_NO_STEP;
  }
  push(g->redo, &g->redos, &g->now);
  g->now = g->undo[--g->undos];
  return sg_world_undo(g->world) == SG_OK;
}

static bool
play_redo(play *g)
{
  if (g->depth > 0 || g->redos == 0) {
    return sg_world_redo(g->world) == SG_NO_STEP;
  }
  push(g->undo, &g->undos, &g->now);
  g->now = g->redo[--g->redos];
  return sg_world_redo(g->world) == SG_OK;
}

static bool
play_hold(play *g)
{
  held *h = &g->held[draw(HELD)];
  bool valid = true;

  if (h->version) {
    valid = same(h->version, &h->shows);
    sg_version_drop(h->version);
    h->version = NULL;
  } else {
    h->version = sg_world_version(g->world);
    h->shows = g->now;
  }
  return valid;
}

static bool
play_all(play *g)
{
  int r = draw(20) == 0 ? 0 : 1;

  if (g->now.n[r] > 0) {
    note_change(g);
  }
  g->now.n[r] = 0;
  return sg_world_retract_all(g->world, relation_of[r]);
}

/* All rows of a segment, or all edges from a vertex. */
static bool
play_with(play *g)
{
  int r = draw(3) == 0 ? 0 : 1;
  bool start = r == 1 && draw(2) == 0;
  int32_t id = (int32_t)draw(start ? 12 : 3) + 1;
  size_t n = g->now.n[r];

  for (size_t i = n; i-- > 0;) {
    const plain_row *row = &g->now.row[r][i];
    if ((start ? row->a : row->s) == id) {
      plain_delete(&g->now, r, i);
    }
  }
  if (g->now.n[r] < n) {
    note_change(g);
  }
  return sg_world_retract_with(g->world, relation_of[r], start ? 2 : 0, id);
}

static bool
play_step(play *g)
{
  uint32_t what = draw(100);

  return what < 55   ? play_add(g)
         : what < 80 ? play_retract(g)
         : what < 84 ? play_begin(g)
         : what < 87 ? play_commit(g)
         : what < 89 ? play_rollback(g)
         : what < 91 ? play_undo(g)
         : what < 92 ? play_redo(g)
         : what < 97 ? play_hold(g)
         : what < 99 ? play_with(g)
                     : play_all(g);
}

static void
test_random(uint64_t start)
{
  static play g;
  char name[64];
  bool right = true;

  memset(&g, 0, sizeof(g));
  g.world = sg_world_open();
  sg_world_undo_limit(g.world, LIMIT);
  seed = start;
  snprintf(name, sizeof(name), "random operations, seed %u", (unsigned)start);
  for (int i = 0; i < STEPS && right; i++) {
    const sg_version *version;
    right = play_step(&g);
    version = sg_world_version(g.world);
    right = right && same(version, &g.now) && lookups_agree(version, &g.now);
    sg_version_drop(version);
    right = right && (i % 16 || sg_world_is_valid(g.world));
  }
  CHECK(name, right);
  for (int i = 0; i < HELD; i++) {
    CHECK("a held version stays as it was",
          !g.held[i].version || same(g.held[i].version, &g.held[i].shows));
    sg_version_drop(g.held[i].version);
  }
  sg_world_drop(g.world);
}

int
main(void)
{
  for (uint64_t s = 1; s <= 12; s++) {
    test_random(s);
  }
  return check_report();
}
