/* seam_exchange.c -- see seam_exchange.h. */
#include "seam_exchange.h"
#include "engine/search.h"

#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  ASK_EVERY = 4096, /* faces laid or moved */
  TESTS = 4         /* of two triangles take as long as laying a face */
};

/* Sides nearer than this part of the sheet lie on each other, in places that
 * are rounded again and again; sg_lay() decides in the end. */
#define TOUCH 1e-12

/* An exchange under way. What a turn changes is written down, to be undone. */
typedef struct exchange {
  const sg_exchange_input *in;
  sg_flattening *fl;
  const sg_cancel *cancel;
  double step;    /* gains that are less are none */
  uint32_t *rank; /* [joints] the place in the order */
  bool *stays;    /* [joints] a fold that is not taken back */
  bool *closes;   /* [joints] its sides lie on each other */
  /* a turn */
  uint32_t turn;                  /* from 1 */
  uint32_t *touched, *touched_in; /* [faces] of islands that changed */
  size_t touches;
  uint32_t *changed, *changed_in; /* [joints] */
  unsigned char *was;             /* [joints] their states before */
  size_t changes;
  uint32_t *again; /* [joints] ranks of what may be joined again */
  /* a walk */
  uint32_t walk;        /* from 1 */
  uint32_t *walked;     /* [faces] the last walk that came there */
  uint32_t *by, *queue; /* [faces] the joint by which it did; in order */
  size_t laid;          /* faces, in all walks */
  size_t before;        /* of the flattening: moves and tests */
  size_t asked;         /* the effort when it was last asked to stop */
} exchange;

/* ---- joints ------------------------------------------------------------- */

static bool
is_seam(const sg_flattening *fl, uint32_t j)
{
  sg_joint_state state = (sg_joint_state)fl->state[j];

  return !fl->joints->joint[j].line && state != SG_JOINT_JOINED;
}

static bool
may_join(const sg_flattening *fl, uint32_t j)
{
  return is_seam(fl, j) && fl->state[j] != SG_JOINT_FORBIDDEN;
}

static bool
is_together(const sg_flattening *fl, const sg_joint *j)
{
  return fl->island_of[j->face[0]] == fl->island_of[j->face[1]];
}

static bool
is_near(const sg_flattening *fl, uint32_t a, uint32_t b)
{
  const double *p = fl->at[a], *q = fl->at[b];

  return fabs(p[0] - q[0]) + fabs(p[1] - q[1]) <= TOUCH * fl->sheet;
}

/* Whether the sides of a seam lie on each other: all round a flat vertex. */
static bool
lies_closed(const sg_flattening *fl, uint32_t j)
{
  const sg_joint *joint = &fl->joints->joint[j];
  const uint32_t *a = joint->corner[0], *b = joint->corner[1];

  return may_join(fl, j) && is_together(fl, joint) && is_near(fl, a[0], b[1]) &&
         is_near(fl, a[1], b[0]);
}

double
sg_seam_length(const sg_flattening *fl)
{
  double sum = 0;

  for (uint32_t j = 0; j < fl->joints->n; j++) {
    sum +=
        is_seam(fl, j) && !lies_closed(fl, j) ? fl->joints->joint[j].length : 0;
  }
  return sum;
}

/* ---- effort ------------------------------------------------------------- */

static size_t
moves_and_tests(const sg_flattening *fl)
{
  return fl->placed + fl->tests / TESTS;
}

static size_t
effort(const exchange *x)
{
  return x->turn + x->laid + moves_and_tests(x->fl) - x->before;
}

static bool
is_stopped(exchange *x, bool *stopped)
{
  if (effort(x) - x->asked >= ASK_EVERY) {
    x->asked = effort(x);
    *stopped = sg_cancelled(x->cancel);
  }
  return *stopped;
}

/* ---- walks -------------------------------------------------------------- */

/* A face is reached by joint j, if it was not before. */
static size_t
reach(exchange *x, uint32_t face, uint32_t j, size_t n)
{
  if (x->walked[face] != x->walk) {
    x->walked[face] = x->walk;
    x->by[face] = j;
    x->queue[n++] = face;
  }
  return n;
}

/* Over all folds from a face: how many faces are connected, which are queued
 * behind n others. */
static size_t
spread(exchange *x, uint32_t root, size_t n)
{
  const sg_flattening *fl = x->fl;
  const sg_flat_faces *f = fl->faces;
  size_t next = n;

  n = reach(x, root, SG_NO_JOINT, n);
  for (; next < n; next++) {
    uint32_t face = x->queue[next];
    for (uint32_t k = f->side_begin[face]; k < f->side_begin[face + 1]; k++) {
      uint32_t j = fl->joints->of_side[k];
      if (j != SG_NO_JOINT && fl->state[j] == SG_JOINT_JOINED) {
        const uint32_t *two = fl->joints->joint[j].face;
        n = reach(x, two[two[0] == face], j, n);
      }
    }
  }
  x->laid += n;
  return n;
}

/* Faces become islands anew: joined faces are connected. False: no memory,
 * or stopped. */
static bool
regroup(exchange *x, const uint32_t *face, size_t faces, bool *stopped)
{
  x->walk++;
  for (size_t i = 0; i < faces; i++) {
    sg_flattening_loosen(x->fl, face[i]);
  }
  for (size_t i = 0; i < faces; i++) {
    if (x->walked[face[i]] == x->walk) {
      continue;
    }
    size_t n = spread(x, face[i], 0);
    for (size_t k = 1; k < n; k++) {
      if ((k % ASK_EVERY == 0 && is_stopped(x, stopped)) ||
          !sg_flattening_rejoin(x->fl, x->by[x->queue[k]])) {
        return false;
      }
    }
  }
  return true;
}

/* Of the folds on the way from a face back to where the walk began, and of
 * `last`, the one that comes last. */
static uint32_t
last_on_way(const exchange *x, uint32_t face, uint32_t last)
{
  for (uint32_t j; (j = x->by[face]) != SG_NO_JOINT;) {
    const uint32_t *two = x->fl->joints->joint[j].face;
    if (!x->stays[j] && (last == SG_NO_JOINT || x->rank[j] > x->rank[last])) {
      last = j;
    }
    face = two[two[0] == face];
  }
  return last;
}

/* ---- what a turn changes ------------------------------------------------ */

static void
begin_turn(exchange *x)
{
  x->turn++;
  x->touches = x->changes = 0;
}

static void
note_state(exchange *x, uint32_t j)
{
  if (x->changed_in[j] != x->turn) {
    x->changed_in[j] = x->turn;
    x->was[j] = x->fl->state[j];
    x->changed[x->changes++] = j;
  }
}

/* The faces of an island, before it is taken apart or after it was joined. */
static void
note_island(exchange *x, uint32_t face)
{
  const sg_flattening *fl = x->fl;

  for (face = fl->island[fl->island_of[face]].head; face != UINT32_MAX;
       face = fl->next_face[face]) {
    if (x->touched_in[face] != x->turn) {
      x->touched_in[face] = x->turn;
      x->touched[x->touches++] = face;
    }
    x->laid++;
  }
}

static bool
undo_turn(exchange *x, bool *stopped)
{
  for (size_t i = 0; i < x->changes; i++) {
    x->fl->state[x->changed[i]] = x->was[x->changed[i]];
  }
  return regroup(x, x->touched, x->touches, stopped);
}

/* A fold is taken back. Its island is among those that are touched by then. */
static bool
take_back(exchange *x, uint32_t j, bool *stopped)
{
  sg_flattening *fl = x->fl;
  uint32_t face = fl->joints->joint[j].face[0], n = 0;
  uint32_t *faces = x->again;

  note_island(x, face);
  note_state(x, j);
  fl->state[j] = SG_JOINT_OPEN;
  for (face = fl->island[fl->island_of[face]].head; face != UINT32_MAX;
       face = fl->next_face[face]) {
    faces[n++] = face;
  }
  return regroup(x, faces, n, stopped);
}

static bool
try_joint(exchange *x, uint32_t j, sg_joint_state *state, bool *stopped)
{
  note_state(x, j);
  if (!sg_flattening_join(x->fl, j, x->cancel, state, stopped)) {
    return false;
  }
  if (*state == SG_JOINT_JOINED) {
    note_island(x, x->fl->joints->joint[j].face[0]);
  }
  return true;
}

/* ---- a turn ------------------------------------------------------------- */

/* The fold that has to go so that the faces of a seam, which are connected, may
 * be joined there; none, if all on the way come before it. */
static uint32_t
fold_for(exchange *x, uint32_t j)
{
  const uint32_t *face = x->fl->joints->joint[j].face;
  uint32_t last;

  x->walk++;
  spread(x, face[0], 0);
  last = last_on_way(x, face[1], SG_NO_JOINT);
  return last != SG_NO_JOINT && x->rank[last] > x->rank[j] ? last : SG_NO_JOINT;
}

/* The fold that has to go so that what overlapped at joint j does not. */
static uint32_t
fold_in_way(exchange *x, uint32_t j)
{
  const sg_flattening *fl = x->fl;
  const uint32_t *face = fl->joints->joint[j].face;
  size_t n;

  x->walk++;
  n = spread(x, face[0], 0);
  spread(x, face[1], n);
  return last_on_way(x, fl->overlap[1],
                     last_on_way(x, fl->overlap[0], SG_NO_JOINT));
}

/* Joins seam j, whatever has to be taken back for it. */
static bool
join_seam(exchange *x, uint32_t j, bool *joined, bool *stopped)
{
  sg_joint_state state = SG_JOINT_OPEN;

  *joined = false;
  if (is_together(x->fl, &x->fl->joints->joint[j])) {
    uint32_t fold = fold_for(x, j);
    if (fold == SG_NO_JOINT) {
      return true;
    }
    if (!take_back(x, fold, stopped)) {
      return false;
    }
  }
  for (int cuts = 0; cuts <= SG_EXCHANGE_CUTS; cuts++) {
    if (!try_joint(x, j, &state, stopped)) {
      return false;
    }
    *joined = state == SG_JOINT_JOINED;
    if (state != SG_JOINT_OVERLAP || cuts == SG_EXCHANGE_CUTS) {
      return true;
    }
    uint32_t fold = fold_in_way(x, j);
    if (fold == SG_NO_JOINT) {
      return true;
    }
    if (!take_back(x, fold, stopped)) {
      return false;
    }
  }
  return true;
}

/* The joints between islands that were touched and others, in order, each once
 * or twice. False: no memory, or stopped. */
static bool
find_again(exchange *x, size_t *count, bool *stopped)
{
  const sg_flattening *fl = x->fl;
  const sg_flat_faces *f = fl->faces;
  size_t n = 0;

  for (size_t i = 0; i < x->touches; i++) {
    uint32_t face = x->touched[i];
    for (uint32_t k = f->side_begin[face]; k < f->side_begin[face + 1]; k++) {
      uint32_t j = fl->joints->of_side[k];
      if (j != SG_NO_JOINT && may_join(fl, j) &&
          !is_together(fl, &fl->joints->joint[j])) {
        x->again[n++] = x->rank[j];
      }
    }
  }
  sg_sort_end end =
      sg_sort(x->again, n, sizeof *x->again, sg_compare_numbers, x->cancel);

  *count = n;
  *stopped = end == SG_SORT_STOPPED;
  return end == SG_SORTED;
}

/* What came off is joined where it can be. */
static bool
join_again(exchange *x, bool *stopped)
{
  sg_joint_state state;
  size_t n;

  if (!find_again(x, &n, stopped)) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    uint32_t j = x->in->order[x->again[i]];
    bool twice = i > 0 && x->again[i] == x->again[i - 1];
    if (!twice && !is_together(x->fl, &x->fl->joints->joint[j]) &&
        (is_stopped(x, stopped) || !try_joint(x, j, &state, stopped))) {
      return false;
    }
  }
  return true;
}

/* ---- what it was worth -------------------------------------------------- */

/* Pieces and seam that are less than before. */
typedef struct gain {
  int pieces;
  double seam;
} gain;

static void
count_folds(const exchange *x, gain *g)
{
  for (size_t i = 0; i < x->changes; i++) {
    uint32_t j = x->changed[i];
    int more =
        (x->fl->state[j] == SG_JOINT_JOINED) - (x->was[j] == SG_JOINT_JOINED);
    g->pieces += more;
    g->seam += more * x->fl->joints->joint[j].length;
  }
}

/* Seams of the faces that were touched whose sides lie on each other now, or do
 * no more. `keep`: it stays so. */
static void
count_closed(exchange *x, bool keep, gain *g)
{
  const sg_flattening *fl = x->fl;
  const sg_flat_faces *f = fl->faces;

  for (size_t i = 0; i < x->touches; i++) {
    uint32_t face = x->touched[i];
    for (uint32_t k = f->side_begin[face]; k < f->side_begin[face + 1]; k++) {
      uint32_t j = fl->joints->of_side[k];
      const sg_joint *joint = j == SG_NO_JOINT ? NULL : &fl->joints->joint[j];
      bool counted = joint && (joint->side[0] == k ||
                               x->touched_in[joint->face[0]] != x->turn);
      bool closes = counted && lies_closed(fl, j);
      if (counted && closes != x->closes[j]) {
        g->seam += closes ? joint->length : -joint->length;
        x->closes[j] = keep ? closes : x->closes[j];
      }
    }
  }
}

static bool
is_gain(const exchange *x, const gain *g)
{
  return x->in->pieces && g->pieces != 0 ? g->pieces > 0 : g->seam > x->step;
}

/* Tries a turn for seam j. *helped: it stays. */
static bool
take_turn(exchange *x, uint32_t j, bool *helped, bool *stopped)
{
  gain g = {0, 0};
  bool joined;

  *helped = false;
  begin_turn(x);
  if (!join_seam(x, j, &joined, stopped) ||
      (joined && !join_again(x, stopped))) {
    return false;
  }
  if (joined) {
    count_folds(x, &g);
    count_closed(x, false, &g);
    *helped = is_gain(x, &g);
  }
  if (*helped) {
    count_closed(x, true, &g);
    return true;
  }
  return undo_turn(x, stopped);
}

/* Round and round, until a whole round has not helped. */
static bool
take_turns(exchange *x, sg_exchange_end *out, bool *stopped)
{
  size_t n = x->fl->joints->n, in_vain = 0;

  for (size_t i = 0; in_vain < n && effort(x) < x->in->effort;
       i = i + 1 < n ? i + 1 : 0) {
    uint32_t j = x->in->order[i];
    bool helped = false;
    if (may_join(x->fl, j) && !x->closes[j]) {
      if (is_stopped(x, stopped) || !take_turn(x, j, &helped, stopped)) {
        return false;
      }
      out->turns++;
      out->exchanges += helped;
    }
    in_vain = helped ? 0 : in_vain + 1;
  }
  out->settled = in_vain == n;
  return true;
}

/* ---- all ---------------------------------------------------------------- */

static bool
make(exchange *x)
{
  size_t joints = x->fl->joints->n + 1, faces = x->fl->faces->faces + 1;
  size_t both = 2 * joints > faces ? 2 * joints : faces;

  x->rank = malloc(joints * sizeof *x->rank);
  x->stays = calloc(joints, sizeof *x->stays);
  x->closes = calloc(joints, sizeof *x->closes);
  x->touched = malloc(faces * sizeof *x->touched);
  x->touched_in = calloc(faces, sizeof *x->touched_in);
  x->changed = malloc(joints * sizeof *x->changed);
  x->changed_in = calloc(joints, sizeof *x->changed_in);
  x->was = malloc(joints * sizeof *x->was);
  x->again = malloc(both * sizeof *x->again);
  x->walked = calloc(faces, sizeof *x->walked);
  x->by = malloc(faces * sizeof *x->by);
  x->queue = malloc(faces * sizeof *x->queue);
  return x->rank && x->stays && x->closes && x->touched && x->touched_in &&
         x->changed && x->changed_in && x->was && x->again && x->walked &&
         x->by && x->queue;
}

static void
clear(exchange *x)
{
  free(x->rank);
  free(x->stays);
  free(x->closes);
  free(x->touched);
  free(x->touched_in);
  free(x->changed);
  free(x->changed_in);
  free(x->was);
  free(x->again);
  free(x->walked);
  free(x->by);
  free(x->queue);
}

static void
begin(exchange *x)
{
  const sg_flattening *fl = x->fl;

  for (uint32_t i = 0; i < fl->joints->n; i++) {
    x->rank[x->in->order[i]] = i;
  }
  for (uint32_t j = 0; j < fl->joints->n; j++) {
    x->stays[j] = fl->joints->joint[j].flat || (x->in->kept && x->in->kept[j]);
    x->closes[j] = lies_closed(fl, j);
  }
}

static void
end(exchange *x)
{
  sg_flattening *fl = x->fl;

  for (uint32_t j = 0; j < fl->joints->n; j++) {
    if (may_join(fl, j) && is_together(fl, &fl->joints->joint[j])) {
      fl->state[j] = SG_JOINT_SAME;
    } else if (may_join(fl, j) && fl->state[j] != SG_JOINT_SHORT) {
      fl->state[j] = SG_JOINT_OVERLAP;
    }
  }
}

bool
sg_seam_exchange(const sg_exchange_input *in, const sg_cancel *cancel,
                 sg_exchange_end *out, bool *stopped)
{
  sg_flattening *fl = in->flattening;
  size_t refused = fl->refused;
  exchange x = {.in = in,
                .fl = fl,
                .cancel = cancel,
                .step = sg_joint_step(fl),
                .before = moves_and_tests(fl)};

  *out = (sg_exchange_end){.settled = refused == 0};
  *stopped = false;
  if (refused == 0) {
    return true;
  }
  bool good = make(&x);

  if (good) {
    begin(&x);
    good = take_turns(&x, out, stopped);
  }
  if (good && out->exchanges > 0) {
    end(&x);
  }
  fl->refused = refused;
  clear(&x);
  return good;
}
