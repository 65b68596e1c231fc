/* flattening.c -- see flattening.h. */
#include "flattening.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  LINE = 64,         /* bytes of memory that come together */
  FEW = 6,           /* triangles that are looked at one by one */
  SOME = 8,          /* faces, of which those near the joint are tried first */
  FAN = 16,          /* faces round a vertex that are */
  NEAR = 12,         /* faces round one that overlapped before */
  POLL_EVERY = 2048, /* faces moved and joints tried */
  ISLANDS = 16384,   /* begun from one poll to the next */
  AHEAD = 8          /* joints from one step of fetching to the next */
};

/* ---- beginning ---------------------------------------------------------- */

static void
corners_of(const uint32_t triangle[3], const double (*at)[2], double out[3][2])
{
  for (int k = 0; k < 3; k++) {
    out[k][0] = at[triangle[k]][0];
    out[k][1] = at[triangle[k]][1];
  }
}

static sg_flat_box
box_of_triangle(const sg_flat_faces *f, const double (*at)[2], uint32_t t)
{
  double p[3][2];

  corners_of(f->triangle[t], at, p);
  return sg_flat_box_round((const double(*)[2])p, 3);
}

static void
close_index(sg_island *island)
{
  if (island->index) {
    sg_flat_index_clear(island->index);
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

  close_index(island);
  *island = (sg_island){.head = face,
                        .tail = face,
                        .faces = 1,
                        .triangles = f->triangle_begin[face + 1] -
                                     f->triangle_begin[face],
                        .suspect = UINT32_MAX};
  fl->island_of[face] = face;
  fl->next_face[face] = UINT32_MAX;
  memcpy(fl->at + first, f->at + first, (end - first) * sizeof *fl->at);
  island->box =
      sg_flat_box_round((const double(*)[2])fl->at + first, end - first);
}

static bool
begin_islands(sg_flattening *fl, const sg_poll *poll)
{
  for (uint32_t face = 0; face < fl->faces->faces; face++) {
    if (face % ISLANDS == 0 && sg_poll_stop(poll)) {
      return false;
    }
    begin_island(fl, face);
  }
  return true;
}

bool
sg_flattening_restart(sg_flattening *fl, const sg_poll *poll)
{
  if (!fl->tried) {
    return true;
  }
  for (size_t j = 0; j < fl->joints->n; j++) {
    if (fl->state[j] != SG_JOINT_FORBIDDEN) {
      fl->state[j] = SG_JOINT_OPEN;
    }
  }
  fl->tests = fl->refused = fl->joins = 0;
  fl->tried = !begin_islands(fl, poll);
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

static size_t
most_corners(const sg_flat_faces *f)
{
  size_t most = 0;

  for (size_t i = 0; i < f->faces; i++) {
    size_t n = f->corner_begin[i + 1] - f->corner_begin[i];
    most = n > most ? n : most;
  }
  return most;
}

bool
sg_flattening_make(const sg_dense *dense, const sg_flat_faces *faces,
                   const sg_joints *joints, const sg_poll *poll,
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
      .sheet = sqrt(area),
      .depth = SG_FLAT_DEPTH * sqrt(area),
      .state = calloc(joints->n + 1, sizeof *out->state),
      .island_of = malloc((faces->faces + 1) * sizeof *out->island_of),
      .next_face = malloc((faces->faces + 1) * sizeof *out->next_face),
      .island = new_islands(faces->faces + 1),
      .at = malloc((faces->corners + 1) * sizeof *out->at),
      .moved = malloc((most_corners(faces) + 1) * sizeof *out->moved)};
  if (!sg_flat_stock_make(faces->triangles, out->sheet, &out->stock) ||
      !out->state || !out->island_of || !out->next_face || !out->island ||
      !out->at || !out->moved) {
    return false;
  }
  *stopped = !begin_islands(out, poll);
  return !*stopped;
}

void
sg_flattening_clear(sg_flattening *fl)
{
  for (size_t i = 0; fl->island && i < fl->faces->faces; i++) {
    close_index(&fl->island[i]);
  }
  free(fl->state);
  free(fl->island_of);
  free(fl->next_face);
  free(fl->island);
  free(fl->at);
  free(fl->moved);
  sg_flat_stock_clear(&fl->stock);
  *fl = (sg_flattening){0};
}

/* ---- moving ------------------------------------------------------------- */

/* A turn by an angle with this cosine and sine about `from`, which goes to
 * `to`. */
typedef struct motion {
  double cosine, sine, from[2], to[2];
} motion;

/* The other side of a joint onto side `onto`: its end to the start. */
static motion
motion_onto(const sg_flattening *fl, const sg_joint *j, int onto)
{
  const uint32_t *a = j->corner[onto], *b = j->corner[!onto];
  const double *a0 = fl->at[a[0]], *a1 = fl->at[a[1]];
  const double *b0 = fl->at[b[1]], *b1 = fl->at[b[0]];
  double wx = a1[0] - a0[0], wy = a1[1] - a0[1];
  double ux = b1[0] - b0[0], uy = b1[1] - b0[1];
  double c = ux * wx + uy * wy, s = ux * wy - uy * wx, size = hypot(c, s);

  return (motion){.cosine = size > 0 ? c / size : 1,
                  .sine = size > 0 ? s / size : 0,
                  .from = {b0[0], b0[1]},
                  .to = {a0[0], a0[1]}};
}

static void
move(const motion *m, const double p[2], double out[2])
{
  double x = p[0] - m->from[0], y = p[1] - m->from[1];

  out[0] = m->to[0] + m->cosine * x - m->sine * y;
  out[1] = m->to[1] + m->sine * x + m->cosine * y;
}

static void
move_face(sg_flattening *fl, const motion *m, uint32_t face)
{
  const sg_flat_faces *f = fl->faces;
  uint32_t first = f->corner_begin[face];

  for (uint32_t c = first; c < f->corner_begin[face + 1]; c++) {
    move(m, fl->at[c], fl->moved[c - first]);
  }
}

/* ---- testing ------------------------------------------------------------ */

typedef struct trial {
  sg_flattening *fl;
  const sg_island *onto;
  double corner[3][2]; /* of the triangle that is tried */
  sg_flat_box box;
  uint32_t hit; /* triangle */
} trial;

static bool
overlaps(void *data, uint32_t item)
{
  trial *t = data;
  double p[3][2];

  corners_of(t->fl->faces->triangle[item], (const double(*)[2])t->fl->at, p);
  t->fl->tests++;
  t->hit = item;
  return sg_convex_overlap((const double(*)[2])t->corner, 3,
                           (const double(*)[2])p, 3, t->fl->depth);
}

static bool
overlaps_some(trial *t)
{
  const sg_flat_faces *f = t->fl->faces;

  if (t->onto->index) {
    return sg_flat_index_near(t->onto->index, &t->fl->stock, &t->box, overlaps,
                              t);
  }
  for (uint32_t face = t->onto->head; face != UINT32_MAX;
       face = t->fl->next_face[face]) {
    for (uint32_t k = f->triangle_begin[face]; k < f->triangle_begin[face + 1];
         k++) {
      if (overlaps(t, k)) {
        return true;
      }
    }
  }
  return false;
}

/* Whether a face where it was moved to overlaps the island. */
static bool
face_overlaps(trial *t, uint32_t face)
{
  const sg_flat_faces *f = t->fl->faces;
  const double(*moved)[2] = (const double(*)[2])t->fl->moved;

  for (uint32_t k = f->triangle_begin[face]; k < f->triangle_begin[face + 1];
       k++) {
    for (int c = 0; c < 3; c++) {
      const double *p = moved[f->triangle[k][c] - f->corner_begin[face]];
      memcpy(t->corner[c], p, sizeof t->corner[c]);
    }
    t->box = sg_flat_box_round((const double(*)[2])t->corner, 3);
    if (sg_flat_boxes_meet(&t->box, &t->onto->box) && overlaps_some(t)) {
      return true;
    }
  }
  return false;
}

/* Whether a face overlaps the other island once it is moved. */
static bool
moved_overlaps(trial *t, const motion *m, uint32_t face)
{
  t->fl->moves++;
  move_face(t->fl, m, face);
  if (!face_overlaps(t, face)) {
    return false;
  }
  t->fl->overlap[0] = t->fl->faces->triangle_face[t->hit];
  t->fl->overlap[1] = face;
  return true;
}

/* The side of a face that follows another one, or comes before it, at a vertex;
 * SG_NO_JOINT: none. */
static uint32_t
next_side(const sg_flat_faces *f, uint32_t side, bool before)
{
  uint32_t face = f->face_of[side];
  uint32_t corner = before ? f->side[side].from : f->side[side].to;

  for (uint32_t k = f->side_begin[face]; k < f->side_begin[face + 1]; k++) {
    if (corner == (before ? f->side[k].to : f->side[k].from) && k != side) {
      return k;
    }
  }
  return SG_NO_JOINT;
}

/* The faces round an end of the side at which an island would be joined: where
 * the angles sum to more than a whole turn, these overlap first. */
static bool
fan_overlaps(trial *t, const motion *m, uint32_t side, bool before)
{
  const sg_flat_faces *f = t->fl->faces;

  for (int n = 0; n < FAN; n++) {
    side = next_side(f, side, before);
    uint32_t j = side == SG_NO_JOINT ? side : t->fl->joints->of_side[side];
    if (j == SG_NO_JOINT || t->fl->state[j] != SG_JOINT_JOINED) {
      return false;
    }
    const sg_joint *joint = &t->fl->joints->joint[j];
    side = joint->side[joint->side[0] == side];
    if (moved_overlaps(t, m, f->face_of[side])) {
      return true;
    }
  }
  return false;
}

/* What an island would be joined by: a side of it. */
typedef struct attempt {
  const sg_island *moving, *onto;
  uint32_t side;
  motion motion;
} attempt;

static bool
is_among(const uint32_t *list, int n, uint32_t item)
{
  for (int i = 0; i < n; i++) {
    if (list[i] == item) {
      return true;
    }
  }
  return false;
}

/* A face that overlapped when the island was tried before, mostly at the next
 * edge, and those round it. */
static bool
suspects_overlap(trial *t, const attempt *of)
{
  const sg_flat_faces *f = t->fl->faces;
  uint32_t near[NEAR + 1] = {of->moving->suspect};
  int n = of->moving->suspect != UINT32_MAX;

  for (int i = 0; i < n; i++) {
    if (moved_overlaps(t, &of->motion, near[i])) {
      return true;
    }
    for (uint32_t k = f->side_begin[near[i]];
         n < NEAR && k < f->side_begin[near[i] + 1]; k++) {
      uint32_t j = t->fl->joints->of_side[k];
      if (j != SG_NO_JOINT && t->fl->state[j] == SG_JOINT_JOINED) {
        const sg_joint *joint = &t->fl->joints->joint[j];
        uint32_t other = f->face_of[joint->side[joint->side[0] == k]];
        near[n] = other;
        n += !is_among(near, n, other);
      }
    }
  }
  return false;
}

/* After many faces, whichever joints they were moved for. */
static bool
is_stopped(sg_flattening *fl, const sg_poll *poll)
{
  if (fl->moves < POLL_EVERY) {
    return false;
  }
  fl->moves = 0;
  return sg_poll_stop(poll);
}

/* Moves the faces of an island and sees whether they overlap the other one. */
static bool
try_motion(sg_flattening *fl, const attempt *of, const sg_poll *poll,
           bool *stopped, bool *overlap)
{
  trial t = {.fl = fl, .onto = of->onto};

  *overlap = of->moving->faces > SOME &&
             (suspects_overlap(&t, of) ||
              fan_overlaps(&t, &of->motion, of->side, false) ||
              fan_overlaps(&t, &of->motion, of->side, true));
  for (uint32_t face = of->moving->head; !*overlap && face != UINT32_MAX;
       face = fl->next_face[face]) {
    if (is_stopped(fl, poll)) {
      *stopped = true;
      return false;
    }
    *overlap = moved_overlaps(&t, &of->motion, face);
  }
  return true;
}

/* ---- merging ------------------------------------------------------------ */

static bool
add_to_index(sg_flattening *fl, sg_island *island, uint32_t face)
{
  const sg_flat_faces *f = fl->faces;

  for (uint32_t t = f->triangle_begin[face]; t < f->triangle_begin[face + 1];
       t++) {
    fl->stock.box[t] = box_of_triangle(f, (const double(*)[2])fl->at, t);
    if (!sg_flat_index_add(island->index, &fl->stock, t)) {
      return false;
    }
  }
  return true;
}

/* Before more triangles come: an island that gets many has an index. */
static bool
index_island(sg_flattening *fl, sg_island *island, size_t more)
{
  bool good = true;

  if (!island->index && island->triangles + more > FEW) {
    island->index = calloc(1, sizeof *island->index);
    good = island->index != NULL;
    for (uint32_t face = island->head; good && face != UINT32_MAX;
         face = fl->next_face[face]) {
      good = add_to_index(fl, island, face);
    }
  }
  return good;
}

static void
enlarge(sg_flat_box *box, const sg_flat_box *by)
{
  for (int k = 0; k < 2; k++) {
    box->low[k] = fmin(box->low[k], by->low[k]);
    box->high[k] = fmax(box->high[k], by->high[k]);
  }
}

/* The faces of one island go where the motion takes them and become the
 * other's. */
static bool
merge(sg_flattening *fl, const motion *m, sg_island *moving, sg_island *onto)
{
  const sg_flat_faces *f = fl->faces;
  uint32_t into = fl->island_of[onto->head];

  if (!index_island(fl, onto, moving->triangles)) {
    return false;
  }
  for (uint32_t face = moving->head; face != UINT32_MAX;
       face = fl->next_face[face]) {
    uint32_t first = f->corner_begin[face], end = f->corner_begin[face + 1];
    for (uint32_t c = first; c < end; c++) {
      const double from[2] = {fl->at[c][0], fl->at[c][1]};
      move(m, from, fl->at[c]);
    }
    sg_flat_box box =
        sg_flat_box_round((const double(*)[2])fl->at + first, end - first);
    enlarge(&onto->box, &box);
    fl->island_of[face] = into;
    if (onto->index && !add_to_index(fl, onto, face)) {
      return false;
    }
  }
  fl->next_face[onto->tail] = moving->head;
  onto->tail = moving->tail;
  onto->faces += moving->faces;
  onto->triangles += moving->triangles;
  close_index(moving);
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

static bool
is_point(const sg_flat_box *box)
{
  return box->low[0] == box->high[0] && box->low[1] == box->high[1];
}

/* Faces of two islands. */
static bool
join_islands(sg_flattening *fl, const sg_joint *j, const sg_poll *poll,
             sg_joint_state *state, bool *stopped)
{
  sg_island *a = &fl->island[fl->island_of[j->face[0]]];
  sg_island *b = &fl->island[fl->island_of[j->face[1]]];
  bool second = is_larger(b, a), overlap;
  sg_island *onto = second ? b : a, *moving = second ? a : b;

  if (j->length <= 0 && !is_point(&moving->box)) {
    *state = SG_JOINT_POINT;
    return true;
  }
  const attempt of = {moving, onto, j->side[!second],
                      motion_onto(fl, j, second)};

  if (!try_motion(fl, &of, poll, stopped, &overlap)) {
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
  return overlap || merge(fl, &of.motion, moving, onto);
}

bool
sg_flattening_join(sg_flattening *fl, uint32_t j, const sg_poll *poll,
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
  } else if (!join_islands(fl, joint, poll, state, stopped)) {
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
                       const sg_poll *poll, bool *stopped)
{
  sg_joint_state state;

  for (size_t i = 0; i < n; i++) {
    fl->moves++;
    if (is_stopped(fl, poll)) {
      *stopped = true;
      return false;
    }
    fetch_ahead(fl, order, i, n);
    if (fl->state[order[i]] == SG_JOINT_OPEN &&
        !sg_flattening_join(fl, order[i], poll, &state, stopped)) {
      return false;
    }
  }
  return true;
}
