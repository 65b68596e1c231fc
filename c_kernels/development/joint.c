/* joint.c -- see joint.h. */
#include "joint.h"

#include "engine/search.h"
#include "number/vector.h"
#include "rows/edge_pairs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 64 }; /* bytes of memory that come together */

static sg_joint *
new_joints(size_t n)
{
  _Static_assert(sizeof(sg_joint) == LINE, "a joint is a line of memory");
  return aligned_alloc(LINE, (n + 1) * LINE);
}

/* ---- pairing ------------------------------------------------------------ */

/* A side at an edge with many faces. */
typedef struct spoke {
  double
      angle; /* of the face, about the edge from the low vertex to the high */
  uint32_t side;
  bool forward; /* runs from the low vertex */
  bool taken;
} spoke;

typedef struct pairing {
  const sg_flat_faces *faces;
  const sg_dense *dense;
  sg_joints *out;
  spoke *spoke; /* for one edge */
  size_t room;
} pairing;

static bool
is_real(const pairing *p, uint32_t side)
{
  uint32_t e = p->faces->side[side].edge;

  return e >= p->dense->edges || p->dense->real[e];
}

static void
add_joint(pairing *p, uint32_t a, uint32_t b)
{
  const sg_flat_faces *f = p->faces;
  bool swap = f->side[b].edge < f->side[a].edge;
  sg_joint *j = &p->out->joint[p->out->n++];
  const uint32_t side[2] = {swap ? b : a, swap ? a : b};

  *j = (sg_joint){.line = f->face_of[a] == f->face_of[b]};
  for (int k = 0; k < 2; k++) {
    j->side[k] = side[k];
    j->face[k] = f->face_of[side[k]];
    j->corner[k][0] = f->side[side[k]].from;
    j->corner[k][1] = f->side[side[k]].to;
    j->vertex[k] = f->vertex[j->corner[0][k]];
  }
  p->out->of_side[a] = p->out->of_side[b] = (uint32_t)p->out->n - 1;
}

/* An edge and two directions square to it. */
typedef struct axis {
  double along[3], u[3], w[3];
} axis;

/* Into the face of a side, square to the side: normal x direction. */
static void
inward(const pairing *p, uint32_t side, double out[3])
{
  const double *a = p->dense->at[sg_flat_side_from(p->faces, side)];
  const double *b = p->dense->at[sg_flat_side_to(p->faces, side)];
  const double along[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};

  sg_cross(p->faces->normal[p->faces->face_of[side]], along, out);
}

/* Measured from the face of the first spoke. */
static void
measure_angles(pairing *p, size_t n)
{
  axis x;
  double into[3];
  const spoke *first = &p->spoke[0];
  const double *a = p->dense->at[sg_flat_side_from(p->faces, first->side)];
  const double *b = p->dense->at[sg_flat_side_to(p->faces, first->side)];

  for (int k = 0; k < 3; k++) {
    x.along[k] = first->forward ? b[k] - a[k] : a[k] - b[k];
  }
  double size = sqrt(sg_dot(x.along, x.along));

  inward(p, first->side, x.u);
  sg_cross(x.along, x.u, x.w);
  for (size_t i = 1; i < n; i++) {
    inward(p, p->spoke[i].side, into);
    p->spoke[i].angle =
        atan2(sg_dot(into, x.w) / (size > 0 ? size : 1), sg_dot(into, x.u));
    if (p->spoke[i].angle < 0) {
      p->spoke[i].angle += 2 * acos(-1.0);
    }
  }
  p->spoke[0].angle = 0;
}

/* Falling angles: the way from a forward face to its inside. */
SG_ORDER(compare_spokes, spoke,
         SG_BY_MOST(angle) SG_BY_MOST(forward) SG_BY(side));

/* Sides in one face first, which are a penetration line. */
static void
pair_lines(pairing *p, size_t n)
{
  const uint32_t *face = p->faces->face_of;

  for (size_t i = 0; i < n; i++) {
    for (size_t k = i + 1; k < n && !p->spoke[i].taken; k++) {
      if (!p->spoke[k].taken && p->spoke[i].forward != p->spoke[k].forward &&
          face[p->spoke[i].side] == face[p->spoke[k].side]) {
        add_joint(p, p->spoke[i].side, p->spoke[k].side);
        p->spoke[i].taken = p->spoke[k].taken = true;
      }
    }
  }
}

/* As brackets: each forward face with the next one that runs back, round and
 * round until nothing is left to pair. */
static void
pair_round(pairing *p, size_t n)
{
  for (bool found = true; found;) {
    found = false;
    for (size_t i = 0; i < n; i++) {
      size_t k = (i + 1) % n;
      while (p->spoke[k].taken && k != i) {
        k = (k + 1) % n;
      }
      if (k != i && !p->spoke[i].taken && p->spoke[i].forward &&
          !p->spoke[k].forward) {
        add_joint(p, p->spoke[i].side, p->spoke[k].side);
        p->spoke[i].taken = p->spoke[k].taken = found = true;
      }
    }
  }
}

static bool
pair_many(pairing *p, size_t n)
{
  measure_angles(p, n);
  pair_lines(p, n);
  qsort(p->spoke, n, sizeof *p->spoke, compare_spokes);
  pair_round(p, n);
  return true;
}

/* The sides of one edge. False: no memory. */
static bool
pair_group(pairing *p, const sg_edge_pairs *pairs, const sg_edge_group *group,
           const uint32_t *side)
{
  size_t n = group->end - group->begin;

  if (n == 2 && group->forward == 1) {
    add_joint(p, side[sg_edge_group_edge(pairs, group->begin)],
              side[sg_edge_group_edge(pairs, group->begin + 1)]);
    return true;
  }
  if (n < 3 || group->forward == 0 || group->forward == n) {
    return true;
  }
  if (n > p->room) {
    free(p->spoke);
    p->room = 2 * n;
    p->spoke = malloc(p->room * sizeof *p->spoke);
  }
  for (size_t i = 0; p->spoke && i < n; i++) {
    p->spoke[i] =
        (spoke){.side = side[sg_edge_group_edge(pairs, group->begin + i)],
                .forward = i < group->forward};
  }
  return p->spoke && pair_many(p, n);
}

/* The real sides as edges between vertices. */
typedef struct ends {
  size_t n;
  uint32_t *side;
  int32_t *from, *to;
} ends;

static bool
take_ends(const pairing *p, const sg_cancel *cancel, ends *out, bool *stopped)
{
  const sg_flat_faces *f = p->faces;

  *out = (ends){.side = malloc((f->sides + 1) * sizeof *out->side),
                .from = malloc((f->sides + 1) * sizeof *out->from),
                .to = malloc((f->sides + 1) * sizeof *out->to)};
  if (!out->side || !out->from || !out->to) {
    return false;
  }
  for (uint32_t k = 0; k < f->sides && !*stopped; k++) {
    *stopped = sg_cancel_every(cancel, k);
    if (is_real(p, k)) {
      out->side[out->n] = k;
      out->from[out->n] = sg_flat_side_from(f, k);
      out->to[out->n++] = sg_flat_side_to(f, k);
    }
  }
  return !*stopped;
}

/* Joints in the order of their first edges. False: no memory, or stopped. */
static bool
sort_joints(const pairing *p, const sg_cancel *cancel, bool *stopped)
{
  const sg_flat_faces *f = p->faces;
  uint32_t *of_side = p->out->of_side;
  sg_joint *sorted = new_joints(p->out->n);
  size_t n = 0;

  if (!sorted) {
    return false;
  }
  for (size_t e = 0; e < p->dense->edges + f->chords && !*stopped; e++) {
    *stopped = sg_cancel_every(cancel, e);
    uint32_t side = f->side_of[e];
    uint32_t j = side == SG_NO_SIDE_OF ? SG_NO_JOINT : of_side[side];
    if (j != SG_NO_JOINT && p->out->joint[j].side[0] == side) {
      sorted[n++] = p->out->joint[j];
    }
  }
  memset(of_side, 0xff, f->sides * sizeof *of_side);
  for (uint32_t j = 0; j < n; j++) {
    of_side[sorted[j].side[0]] = of_side[sorted[j].side[1]] = j;
  }
  free(p->out->joint);
  p->out->joint = sorted;
  p->out->n = n;
  return !*stopped;
}

static bool
pair_sides(pairing *p, const sg_cancel *cancel, bool *stopped)
{
  sg_edge_pairs pairs = {0};
  sg_edge_group group = {0};
  ends e;
  bool good = take_ends(p, cancel, &e, stopped) &&
              sg_edge_pairs_make(e.n, e.from, e.to, p->dense->vertices, cancel,
                                 &pairs, stopped);

  for (size_t n = 1; good && sg_edge_group_next(&pairs, &group); n++) {
    *stopped = sg_cancel_every(cancel, n);
    good = !*stopped && pair_group(p, &pairs, &group, e.side);
  }
  sg_edge_pairs_clear(&pairs);
  free(e.side);
  free(e.from);
  free(e.to);
  free(p->spoke);
  return good;
}

/* ---- how they meet ------------------------------------------------------ */

/* Whether the corners of face b are no farther than the tolerance from the
 * plane of a, which goes through `at`. */
static bool
lies_in_plane(const pairing *p, uint32_t a, uint32_t b, const double at[3],
              double tolerance)
{
  const sg_flat_faces *f = p->faces;
  const double *n = f->normal[a];

  for (uint32_t c = f->corner_begin[b]; c < f->corner_begin[b + 1]; c++) {
    const double *q = p->dense->at[f->vertex[c]];
    const double v[3] = {q[0] - at[0], q[1] - at[1], q[2] - at[2]};
    if (fabs(sg_dot(v, n)) > tolerance) {
      return false;
    }
  }
  return true;
}

static void
measure(const pairing *p, sg_joint *j, double tolerance)
{
  const sg_flat_faces *f = p->faces;
  uint32_t a = j->face[0], b = j->face[1];
  const double *from = p->dense->at[j->vertex[0]];
  const double *to = p->dense->at[j->vertex[1]];
  const double along[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  double turn[3];

  j->length = sqrt(sg_dot(along, along));
  if (j->line) {
    return;
  }
  sg_cross(f->normal[a], f->normal[b], turn);
  double sine = j->length > 0 ? sg_dot(turn, along) / j->length : 0;
  double cosine = sg_dot(f->normal[a], f->normal[b]);

  j->angle = atan2(sine, cosine) * (180 / acos(-1.0)) + 0.0;
  bool first = f->area[a] >= f->area[b];
  j->flat = cosine > 0 &&
            lies_in_plane(p, first ? a : b, first ? b : a, from, tolerance);
}

/* A face without area folds flat on its neighbour. False: stopped. */
static bool
lean(pairing *p, sg_flat_faces *faces, const sg_cancel *cancel)
{
  for (uint32_t a = 0; a < faces->faces; a++) {
    if (sg_cancel_every(cancel, a)) {
      return false;
    }
    uint32_t j =
        faces->area[a] > 0 ? SG_NO_JOINT : p->out->of_side[faces->longest[a]];
    if (j != SG_NO_JOINT) {
      const sg_joint *joint = &p->out->joint[j];
      uint32_t other = joint->side[joint->side[0] == faces->longest[a]];
      sg_flat_face_lean(faces, p->dense, a,
                        faces->normal[faces->face_of[other]]);
    }
  }
  return true;
}

bool
sg_joints_make(sg_flat_faces *faces, const sg_dense *dense, double tolerance,
               const sg_cancel *cancel, sg_joints *out, bool *stopped)
{
  pairing p = {.faces = faces, .dense = dense, .out = out};

  *stopped = false;
  *out =
      (sg_joints){.joint = new_joints(faces->sides / 2),
                  .of_side = malloc((faces->sides + 1) * sizeof *out->of_side)};
  if (!out->joint || !out->of_side) {
    return false;
  }
  memset(out->of_side, 0xff, (faces->sides + 1) * sizeof *out->of_side);
  if (!pair_sides(&p, cancel, stopped) || !sort_joints(&p, cancel, stopped)) {
    return false;
  }
  *stopped = !lean(&p, faces, cancel);
  for (size_t j = 0; j < out->n && !*stopped; j++) {
    *stopped = sg_cancel_every(cancel, j);
    measure(&p, &out->joint[j], tolerance);
  }
  return !*stopped;
}

void
sg_joints_clear(sg_joints *joints)
{
  free(joints->joint);
  free(joints->of_side);
  *joints = (sg_joints){0};
}
