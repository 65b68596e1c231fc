/* flattening.c -- see flattening.h. */
#include "flattening.h"

#include "island_overlap.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  LINE = 64,       /* bytes of memory that come together */
  FEW = 6,         /* triangles that are looked at one by one */
  ISLANDS = 16384, /* begun from one cancel to the next */
  AHEAD = 8        /* joints from one step of fetching to the next */
};

/* ---- beginning ---------------------------------------------------------- */

static void
close_index(sg_flattening *fl, sg_island *island)
{
  if (island->index) {
    sg_flat_index_clear(island->index, &fl->stock);
    free(island->index);
    island->index = NULL;
  }
}

static void
begin_island(sg_flattening *fl, uint32_t face)
{
  const sg_flat_faces *f = fl->faces;
  uint32_t first = f->corner_begin[face], end = f->corner_begin[face + 1];
  sg_island *island = &fl->island[face];

  close_index(fl, island);
  *island = (sg_island){.head = face,
                        .tail = face,
                        .faces = 1,
                        .triangles = f->triangle_begin[face + 1] -
                                     f->triangle_begin[face],
                        .suspect = UINT32_MAX,
                        .unindexed = UINT32_MAX};
  fl->island_of[face] = face;
  fl->next_face[face] = UINT32_MAX;
  memcpy(fl->at + first, f->at + first, (end - first) * sizeof *fl->at);
  island->box =
      sg_flat_box_round((const double(*)[2])fl->at + first, end - first);
}

void
sg_flattening_loosen(sg_flattening *fl, uint32_t face)
{
  begin_island(fl, face);
}

static bool
begin_islands(sg_flattening *fl, const sg_cancel *cancel)
{
  for (uint32_t face = 0; face < fl->faces->faces; face++) {
    if (face % ISLANDS == 0 && sg_cancelled(cancel)) {
      return false;
    }
    begin_island(fl, face);
  }
  return true;
}

bool
sg_flattening_restart(sg_flattening *fl, const sg_cancel *cancel)
{
  if (!fl->tried) {
    return true;
  }
  for (size_t j = 0; j < fl->joints->n; j++) {
    if (sg_cancel_every(cancel, j)) {
      return false;
    }
    if (fl->state[j] != SG_JOINT_FORBIDDEN) {
      fl->state[j] = SG_JOINT_OPEN;
    }
  }
  fl->tests = fl->refused = fl->joins = fl->placed = 0;
  fl->tried = !begin_islands(fl, cancel);
  return !fl->tried;
}

/* Each on one line of memory. */
static sg_island *
new_islands(size_t n)
{
  sg_island *island = aligned_alloc(LINE, n * sizeof *island);

  _Static_assert(sizeof(sg_island) == LINE, "an island is a line of memory");
  if (island) {
    memset(island, 0, n * sizeof *island);
  }
  return island;
}

static double
longest_side_in_solid(const sg_dense *dense, const sg_flat_faces *faces)
{
  double longest = 0;

  for (int k = 0; k < 3; k++) {
    double low = INFINITY, high = -INFINITY;
    for (size_t c = 0; c < faces->corners; c++) {
      low = fmin(low, dense->at[faces->vertex[c]][k]);
      high = fmax(high, dense->at[faces->vertex[c]][k]);
    }
    longest = fmax(longest, high - low);
  }
  return longest;
}

bool
sg_flattening_make(const sg_dense *dense, const sg_flat_faces *faces,
                   const sg_joints *joints, const sg_cancel *cancel,
                   sg_flattening *out, bool *stopped)
{
  double area = 0;

  *stopped = false;
  for (size_t i = 0; i < faces->faces; i++) {
    area += faces->area[i];
  }
  *out = (sg_flattening){
      .dense = dense,
      .faces = faces,
      .joints = joints,
      .size = longest_side_in_solid(dense, faces),
      .sheet = sqrt(area),
      .depth = SG_FLAT_DEPTH * sqrt(area),
      .state = calloc(joints->n + 1, sizeof *out->state),
      .island_of = malloc((faces->faces + 1) * sizeof *out->island_of),
      .next_face = malloc((faces->faces + 1) * sizeof *out->next_face),
      .island = new_islands(faces->faces + 1),
      .at = malloc((faces->corners + 1) * sizeof *out->at)};
  if (!sg_flat_stock_make(faces->triangles, out->sheet, &out->stock) ||
      !out->state || !out->island_of || !out->next_face || !out->island ||
      !out->at) {
    return false;
  }
  *stopped = !begin_islands(out, cancel);
  return !*stopped;
}

void
sg_flattening_clear(sg_flattening *fl)
{
  for (size_t i = 0; fl->island && i < fl->faces->faces; i++) {
    free(fl->island[i].index);
  }
  free(fl->state);
  free(fl->island_of);
  free(fl->next_face);
  free(fl->island);
  free(fl->at);
  sg_flat_stock_clear(&fl->stock);
  *fl = (sg_flattening){0};
}

/* ---- moving ------------------------------------------------------------ */

/* The other side of a joint onto side `onto`: its end to the start. */
static sg_motion
motion_onto(const sg_flattening *fl, const sg_joint *j, int onto)
{
  const uint32_t *a = j->corner[onto], *b = j->corner[!onto];
  const double *a0 = fl->at[a[0]], *a1 = fl->at[a[1]];
  const double *b0 = fl->at[b[1]], *b1 = fl->at[b[0]];
  double wx = a1[0] - a0[0], wy = a1[1] - a0[1];
  double ux = b1[0] - b0[0], uy = b1[1] - b0[1];
  double c = ux * wx + uy * wy, s = ux * wy - uy * wx, size = hypot(c, s);

  return (sg_motion){.cosine = size > 0 ? c / size : 1,
                     .sine = size > 0 ? s / size : 0,
                     .from = {b0[0], b0[1]},
                     .to = {a0[0], a0[1]}};
}

/* ---- merging ------------------------------------------------------------ */

static sg_flat_box
box_of_triangle(const sg_flattening *fl, uint32_t t)
{
  double p[3][2];

  for (int k = 0; k < 3; k++) {
    memcpy(p[k], fl->at[fl->faces->triangle[t][k]], sizeof p[k]);
  }
  return sg_flat_box_round((const double(*)[2])p, 3);
}

static bool
add_to_index(sg_flattening *fl, sg_island *island, uint32_t face)
{
  const sg_flat_faces *f = fl->faces;

  for (uint32_t t = f->triangle_begin[face]; t < f->triangle_begin[face + 1];
       t++) {
    fl->stock.box[t] = box_of_triangle(fl, t);
    if (!sg_flat_index_add(island->index, &fl->stock, t)) {
      return false;
    }
  }
  return true;
}

/* Before more triangles come: an island that gets many has an index. It is
 * filled when somebody asks: most islands are taken apart again before. */
static bool
begin_index(sg_island *island, size_t more)
{
  if (!island->index && island->triangles + more > FEW) {
    island->index = calloc(1, sizeof *island->index);
    island->unindexed = island->head;
    return island->index != NULL;
  }
  return true;
}

/* Adds what came since. False: no memory. */
static bool
fill_index(sg_flattening *fl, sg_island *island)
{
  for (uint32_t *face = &island->unindexed;
       island->index && *face != UINT32_MAX; *face = fl->next_face[*face]) {
    if (!add_to_index(fl, island, *face)) {
      return false;
    }
  }
  return true;
}

static void
enlarge(sg_flat_box *box, const sg_flat_box *by)
{
  for (int k = 0; k < 2; k++) {
    box->low[k] = fmin(box->low[k], by->low[k]);
    box->high[k] = fmax(box->high[k], by->high[k]);
  }
}

/* A face of an island goes where the motion takes it and becomes another one's.
 */
static void
move_face(sg_flattening *fl, const sg_motion *m, uint32_t face, uint32_t into)
{
  const sg_flat_faces *f = fl->faces;
  uint32_t first = f->corner_begin[face], end = f->corner_begin[face + 1];
  sg_island *onto = &fl->island[into];

  for (uint32_t c = first; c < end; c++) {
    const double from[2] = {fl->at[c][0], fl->at[c][1]};
    sg_motion_move(m, from, fl->at[c]);
  }
  sg_flat_box box =
      sg_flat_box_round((const double(*)[2])fl->at + first, end - first);

  enlarge(&onto->box, &box);
  fl->island_of[face] = into;
}

/* The faces of one island become another one's. False: no memory, or stopped;
 * then everything is as it was at first. */
static bool
merge(sg_flattening *fl, const sg_motion *m, sg_island *moving, sg_island *onto,
      const sg_cancel *cancel, bool *stopped)
{
  uint32_t into = fl->island_of[onto->head];
  bool good = begin_index(onto, moving->triangles);
  size_t n = 0;

  for (uint32_t face = moving->head; good && face != UINT32_MAX;
       face = fl->next_face[face]) {
    *stopped = sg_cancel_every(cancel, ++n);
    good = !*stopped;
    if (good) {
      move_face(fl, m, face, into);
    }
  }
  if (!good) {
    sg_flattening_restart(fl, NULL);
    return false;
  }
  if (onto->index && onto->unindexed == UINT32_MAX) {
    onto->unindexed = moving->head;
  }
  fl->next_face[onto->tail] = moving->head;
  onto->tail = moving->tail;
  onto->faces += moving->faces;
  onto->triangles += moving->triangles;
  close_index(fl, moving);
  moving->head = UINT32_MAX;
  moving->faces = moving->triangles = 0;
  return true;
}

/* ---- joining ------------------------------------------------------------ */

static bool
is_larger(const sg_island *a, const sg_island *b)
{
  return a->triangles != b->triangles ? a->triangles > b->triangles
                                      : a->faces > b->faces;
}

static double
longest_side(const sg_flat_box *box)
{
  return fmax(box->high[0] - box->low[0], box->high[1] - box->low[1]);
}

/* Whether the smaller of two islands can hang on the joint. */
static bool
holds(const sg_joint *j, const sg_island *a, const sg_island *b)
{
  double hanging = fmin(longest_side(&a->box), longest_side(&b->box));

  return hanging <= j->length * SG_FLAT_HOLDS || (j->flat && j->length > 0);
}

/* Faces of two islands. */
static bool
join_islands(sg_flattening *fl, const sg_joint *j, const sg_cancel *cancel,
             sg_joint_state *state, bool *stopped)
{
  sg_island *a = &fl->island[fl->island_of[j->face[0]]];
  sg_island *b = &fl->island[fl->island_of[j->face[1]]];
  bool second = is_larger(b, a), overlap;
  sg_island *onto = second ? b : a, *moving = second ? a : b;

  if (!holds(j, a, b)) {
    *state = SG_JOINT_SHORT;
    return true;
  }
  const sg_island_attempt of = {moving, onto, j->side[!second],
                                motion_onto(fl, j, second)};

  if (!fill_index(fl, onto) || !fill_index(fl, moving)) {
    sg_flattening_restart(fl, NULL);
    return false;
  }
  if (!sg_island_overlaps(fl, &of, cancel, &overlap)) {
    *stopped = true;
    return false;
  }
  *state = overlap ? SG_JOINT_OVERLAP : SG_JOINT_JOINED;
  if (overlap) {
    onto->suspect = fl->overlap[0];
    moving->suspect = fl->overlap[1];
  }
  fl->refused += overlap;
  fl->joins += !overlap;
  fl->moves += overlap ? 0 : moving->faces;
  return overlap || merge(fl, &of.motion, moving, onto, cancel, stopped);
}

bool
sg_flattening_rejoin(sg_flattening *fl, uint32_t j)
{
  const sg_joint *joint = &fl->joints->joint[j];
  sg_island *a = &fl->island[fl->island_of[joint->face[0]]];
  sg_island *b = &fl->island[fl->island_of[joint->face[1]]];
  bool second = is_larger(b, a);
  sg_motion m = motion_onto(fl, joint, second);
  bool stopped;

  return merge(fl, &m, second ? a : b, second ? b : a, NULL, &stopped);
}

bool
sg_flattening_join(sg_flattening *fl, uint32_t j, const sg_cancel *cancel,
                   sg_joint_state *state, bool *stopped)
{
  const sg_joint *joint = &fl->joints->joint[j];

  *stopped = false;
  *state = (sg_joint_state)fl->state[j];
  if (*state == SG_JOINT_FORBIDDEN || *state == SG_JOINT_JOINED) {
    return true;
  }
  fl->tried = true;
  if (fl->island_of[joint->face[0]] == fl->island_of[joint->face[1]]) {
    *state = SG_JOINT_SAME;
  } else if (!join_islands(fl, joint, cancel, state, stopped)) {
    return false;
  }
  fl->state[j] = (unsigned char)*state;
  return true;
}

/* Joints in order are anywhere in memory: what they refer to is asked for
 * ahead, step by step as it becomes known where it is. */
static void
fetch_ahead(const sg_flattening *fl, const uint32_t *order, size_t i, size_t n)
{
  if (i + 3 * AHEAD < n) {
    __builtin_prefetch(&fl->joints->joint[order[i + 3 * AHEAD]]);
    __builtin_prefetch(&fl->state[order[i + 3 * AHEAD]]);
  }
  for (int k = 0; k < 2 && i + 2 * AHEAD < n; k++) {
    const sg_joint *j = &fl->joints->joint[order[i + 2 * AHEAD]];
    __builtin_prefetch(&fl->island_of[j->face[k]]);
    __builtin_prefetch(&fl->at[j->corner[k][0]]);
    __builtin_prefetch(&fl->at[j->corner[k][1]]);
    __builtin_prefetch(&fl->faces->triangle_begin[j->face[k]]);
    __builtin_prefetch(&fl->faces->corner_begin[j->face[k]]);
  }
  for (int k = 0; k < 2 && i + AHEAD < n; k++) {
    const sg_joint *j = &fl->joints->joint[order[i + AHEAD]];
    __builtin_prefetch(&fl->island[fl->island_of[j->face[k]]]);
    __builtin_prefetch(
        &fl->faces->triangle[fl->faces->triangle_begin[j->face[k]]]);
  }
}

bool
sg_flattening_join_all(sg_flattening *fl, const uint32_t *order, size_t n,
                       const sg_cancel *cancel, bool *stopped)
{
  sg_joint_state state;

  for (size_t i = 0; i < n; i++) {
    fl->moves++;
    if (sg_flattening_stops(fl, cancel)) {
      *stopped = true;
      return false;
    }
    fetch_ahead(fl, order, i, n);
    if (fl->state[order[i]] == SG_JOINT_OPEN &&
        !sg_flattening_join(fl, order[i], cancel, &state, stopped)) {
      return false;
    }
  }
  return true;
}
