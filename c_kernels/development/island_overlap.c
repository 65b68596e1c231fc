/* island_overlap.c -- see island_overlap.h. */
#include "island_overlap.h"

enum {
  SOME = 8,        /* faces, of which those near the joint are tried first */
  FAN = 16,        /* faces round a vertex that are */
  NEAR = 12,       /* faces round one that overlapped before */
  ASK_EVERY = 2048 /* triangles moved and joints tried */
};

/* An attempt under way: triangles are moved one by one, and what they may
 * overlap in the other island is asked for. */
typedef struct trial {
  sg_flattening *fl;
  const sg_island *onto;
  sg_motion motion;
  double corner[3][2];       /* of the triangle that is tried, moved */
  sg_flat_question question; /* what is near it */
  uint32_t hit;              /* the triangle that it overlaps */
  const sg_cancel *cancel;
  bool stopped;
} trial;

/* ---- a triangle --------------------------------------------------------- */

static size_t
corners_of(const void *data, uint32_t triangle, double out[][2])
{
  const sg_flattening *fl = data;

  for (int k = 0; k < 3; k++) {
    const double *p = fl->at[fl->faces->triangle[triangle][k]];
    out[k][0] = p[0];
    out[k][1] = p[1];
  }
  return 3;
}

static bool
overlaps(void *data, uint32_t triangle)
{
  trial *t = data;
  double p[3][2];

  corners_of(t->fl, triangle, p);
  t->fl->tests++;
  t->hit = triangle;
  return sg_convex_overlap((const double(*)[2])t->corner, 3,
                           (const double(*)[2])p, 3, t->fl->depth);
}

/* Whether the triangle that is tried overlaps some of the island. */
static bool
overlaps_some(trial *t)
{
  const sg_flat_faces *f = t->fl->faces;

  if (t->onto->index) {
    return sg_flat_index_near(t->onto->index, &t->fl->stock, &t->question,
                              overlaps, t);
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

/* Whether a triangle overlaps the other island once it is moved. */
static bool
triangle_overlaps(trial *t, uint32_t triangle)
{
  sg_flattening *fl = t->fl;

  fl->moves++;
  fl->placed++;
  for (int k = 0; k < 3; k++) {
    sg_motion_move(&t->motion, fl->at[fl->faces->triangle[triangle][k]],
                   t->corner[k]);
  }
  t->question.box = sg_flat_box_round((const double(*)[2])t->corner, 3);
  if (!sg_flat_boxes_meet(&t->question.box, &t->onto->box) ||
      !overlaps_some(t)) {
    return false;
  }
  fl->overlap[0] = fl->faces->triangle_face[t->hit];
  fl->overlap[1] = fl->faces->triangle_face[triangle];
  return true;
}

static bool
face_overlaps(trial *t, uint32_t face)
{
  const sg_flat_faces *f = t->fl->faces;

  for (uint32_t k = f->triangle_begin[face]; k < f->triangle_begin[face + 1];
       k++) {
    t->stopped = sg_flattening_stops(t->fl, t->cancel);
    if (t->stopped || triangle_overlaps(t, k)) {
      return true;
    }
  }
  return false;
}

/* ---- likely ones -------------------------------------------------------- */

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

/* The side beyond a fold; SG_NO_JOINT: it is none. */
static uint32_t
beyond(const sg_flattening *fl, uint32_t side)
{
  uint32_t j = side == SG_NO_JOINT ? side : fl->joints->of_side[side];

  if (j == SG_NO_JOINT || fl->state[j] != SG_JOINT_JOINED) {
    return SG_NO_JOINT;
  }
  const sg_joint *joint = &fl->joints->joint[j];

  return joint->side[joint->side[0] == side];
}

/* The faces round an end of the side at which an island would be joined: where
 * the angles sum to more than a whole turn, these overlap first. */
static bool
fan_overlaps(trial *t, uint32_t side, bool before)
{
  const sg_flat_faces *f = t->fl->faces;

  for (int n = 0; n < FAN; n++) {
    side = beyond(t->fl, next_side(f, side, before));
    if (side == SG_NO_JOINT) {
      return false;
    }
    if (face_overlaps(t, f->face_of[side])) {
      return true;
    }
  }
  return false;
}

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
suspects_overlap(trial *t, uint32_t suspect)
{
  const sg_flat_faces *f = t->fl->faces;
  uint32_t near[NEAR + 1] = {suspect};
  int n = suspect != UINT32_MAX;

  for (int i = 0; i < n; i++) {
    if (face_overlaps(t, near[i])) {
      return true;
    }
    for (uint32_t k = f->side_begin[near[i]];
         n < NEAR && k < f->side_begin[near[i] + 1]; k++) {
      uint32_t side = beyond(t->fl, k);
      if (side != SG_NO_JOINT) {
        near[n] = f->face_of[side];
        n += !is_among(near, n, near[n]);
      }
    }
  }
  return false;
}

/* ---- all ---------------------------------------------------------------- */

static bool
is_something(void *data, uint32_t triangle)
{
  (void)data;
  (void)triangle;
  return true;
}

/* Whether what lies in this box, once it is moved, may overlap something: by
 * the box round it alone. */
static bool
may_overlap(void *data, const sg_flat_box *box)
{
  const trial *t = data;
  double corner[4][2];

  for (int k = 0; k < 4; k++) {
    const double at[2] = {k == 1 || k == 2 ? box->high[0] : box->low[0],
                          k > 1 ? box->high[1] : box->low[1]};
    sg_motion_move(&t->motion, at, corner[k]);
  }
  const sg_flat_question q = {
      .box = sg_flat_box_round((const double(*)[2])corner, 4)};

  return sg_flat_boxes_meet(&q.box, &t->onto->box) &&
         (!t->onto->index || sg_flat_index_near(t->onto->index, &t->fl->stock,
                                                &q, is_something, NULL));
}

static bool
overlaps_or_stops(void *data, uint32_t triangle)
{
  trial *t = data;

  t->stopped = sg_flattening_stops(t->fl, t->cancel);
  return t->stopped || triangle_overlaps(t, triangle);
}

/* All triangles of an island; parts of it that are far from the other one are
 * passed by. */
static bool
all_overlap(trial *t, const sg_island *moving)
{
  if (moving->index) {
    return sg_flat_index_walk(moving->index, &t->fl->stock, may_overlap,
                              overlaps_or_stops, t);
  }
  for (uint32_t face = moving->head; face != UINT32_MAX;
       face = t->fl->next_face[face]) {
    if (face_overlaps(t, face)) {
      return true;
    }
  }
  return false;
}

bool
sg_island_overlaps(sg_flattening *fl, const sg_island_attempt *of,
                   const sg_cancel *cancel, bool *overlap)
{
  trial t = {
      .fl = fl, .onto = of->onto, .motion = of->motion, .cancel = cancel};

  t.question = (sg_flat_question){.corner = (const double(*)[2])t.corner,
                                  .corners = 3,
                                  .depth = fl->depth,
                                  .corners_of = corners_of,
                                  .items = fl};
  *overlap = (of->moving->faces > SOME &&
              (suspects_overlap(&t, of->moving->suspect) ||
               (!t.stopped && fan_overlaps(&t, of->side, false)) ||
               (!t.stopped && fan_overlaps(&t, of->side, true)))) ||
             (!t.stopped && all_overlap(&t, of->moving));
  return !t.stopped;
}

bool
sg_flattening_stops(sg_flattening *fl, const sg_cancel *cancel)
{
  if (fl->moves < ASK_EVERY) {
    return false;
  }
  fl->moves = 0;
  return sg_cancelled(cancel);
}
