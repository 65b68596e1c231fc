/* solid_move.c -- see solid_move.h. */
#include "solid_move.h"

#include "number/exact.h"
#include "number/vector.h"

#include <math.h>

enum { ASKED = 1 << 16 }; /* vertices or faces between questions */

static const double MOST = 1e90; /* as relations.def says of v/5 */

static bool
move_vertex(sg_solid_vertex *vertex, const double row[3][4])
{
  double to[3];

  for (int k = 0; k < 3; k++) {
    const double *r = row[k];
    to[k] = r[0] * vertex->at[0] + r[1] * vertex->at[1] + r[2] * vertex->at[2] +
            r[3] + 0.0;
    if (!(fabs(to[k]) <= MOST)) {
      return false;
    }
  }
  for (int k = 0; k < 3; k++) {
    vertex->at[k] = to[k];
  }
  return true;
}

static bool
is_mirror(const double row[3][4])
{
  double normal[3];

  sg_cross(row[0], row[1], normal);
  return normal[0] * row[2][0] + normal[1] * row[2][1] + normal[2] * row[2][2] <
         0;
}

/* The last two corners change places; edge k goes from corner k on. */
static void
turn_round(sg_solid *solid, size_t i)
{
  uint32_t *v = solid->triangle[i], second = v[1];
  unsigned bits = solid->auxiliary[i];

  v[1] = v[2];
  v[2] = second;
  solid->auxiliary[i] =
      (uint8_t)((bits & 2U) | (bits & 1U) << 2 | (bits >> 2 & 1U));
}

/* The axis along which a face is seen best, and its turn from there. */
static int
view_axis(const sg_solid *solid, const sg_solid_face *face, int *turn)
{
  double sum[3] = {0, 0, 0}, u[3], v[3], normal[3];
  int axis = 0;

  for (uint32_t i = face->first; i < face->first + face->n; i++) {
    const uint32_t *t = solid->triangle[i];
    for (int k = 0; k < 3; k++) {
      u[k] = solid->vertex[t[1]].at[k] - solid->vertex[t[0]].at[k];
      v[k] = solid->vertex[t[2]].at[k] - solid->vertex[t[0]].at[k];
    }
    sg_cross(u, v, normal);
    for (int k = 0; k < 3; k++) {
      sum[k] += normal[k];
    }
  }
  for (int k = 1; k < 3; k++) {
    axis = fabs(sum[k]) > fabs(sum[axis]) ? k : axis;
  }
  *turn = sum[axis] < 0 ? -1 : 1;
  return axis;
}

/* Each of its triangles turns as the face does. */
static bool
is_covered(const sg_solid *solid, const sg_solid_face *face)
{
  int turn, axis = view_axis(solid, face, &turn);

  for (uint32_t i = face->first; i < face->first + face->n; i++) {
    sg_point p[3];
    for (int k = 0; k < 3; k++) {
      sg_point_set(&p[k], solid->vertex[solid->triangle[i][k]].at);
    }
    if (sg_point_turn(axis, &p[0], &p[1], &p[2]) != turn) {
      return false;
    }
  }
  return true;
}

sg_solid_moved
sg_solid_move(sg_solid *solid, const double row[3][4], const sg_cancel *cancel,
              bool *again)
{
  bool mirror = is_mirror(row);

  for (size_t i = 0; i < solid->vertices; i++) {
    if (!move_vertex(&solid->vertex[i], row)) {
      return SG_MOVED_TOO_FAR;
    }
    if (i % ASKED == ASKED - 1 && sg_cancelled(cancel)) {
      return SG_MOVED_STOPPED;
    }
  }
  for (size_t i = 0; i < solid->triangles && mirror; i++) {
    turn_round(solid, i);
  }
  for (size_t f = 0; f < solid->faces; f++) {
    const sg_solid_face *face = &solid->face[f];
    again[f] = face->n > 1 && !is_covered(solid, face);
    if (f % ASKED == ASKED - 1 && sg_cancelled(cancel)) {
      return SG_MOVED_STOPPED;
    }
  }
  return SG_MOVED;
}
