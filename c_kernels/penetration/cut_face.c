/* cut_face.c -- what lies inside a face is no line: see cut_set.h.
 *
 * A face is a connected flat part, of one polygon or many: a mesh's
 * triangles are polygons of their own. Where the faces of two segments lie on
 * each other, their borders are lines, and the edges between polygons of one
 * face are none; nor is a vertex inside a face a contact. Vertices of a segment
 * in one place are one here, so that triangles need not share any.
 *
 * All triangles at an edge along which something lies are in the model, as
 * their boxes have that in common, too. So an edge is asked about only where
 * something lies on it.
 */
#include "cut_private.h"

#include "number/bounds.h"
#include "number/vector.h"

#include <math.h>
#include <string.h>

/* ---- vertices by their places ---- */

/* Numbers the places of the vertices that came since. False: no memory. */
static bool
number_places(sg_cut_set *set)
{
  const sg_cut_model *model = &set->model;

  while (set->placed < model->vertices) {
    const sg_leaf_vertex *vertex = &model->vertex[set->placed];
    uint32_t key[6];

    if (!sg_list_grow(&set->place_of, set->placed, &set->place_room,
                      sizeof *set->place_of)) {
      return false;
    }
    for (int k = 0; k < 3; k++) {
      double x = vertex->at[k] + 0.0; /* no -0.0 */
      memcpy(&key[2 * k], &x, sizeof x);
    }
    uint32_t *first = sg_key_table_put(&set->at_place, key);
    if (!first) {
      return false;
    }
    if (*first == SG_NO_KEY) {
      *first = (uint32_t)set->placed;
    }
    set->place_of[set->placed++] = *first;
  }
  return true;
}

/* ---- triangles by their edges ---- */

/* Side k of a triangle, as its places: the smaller one first. */
static void
side_key(const sg_cut_set *set, uint32_t triangle, uint32_t k, uint32_t out[2])
{
  const uint32_t *v = set->model.triangle[triangle].v;
  uint32_t a = set->place_of[v[k]], b = set->place_of[v[(k + 1) % 3]];

  out[0] = a < b ? a : b;
  out[1] = a < b ? b : a;
}

/* Files the triangles that came since. False: no memory. */
static bool
file_sides(sg_cut_set *set)
{
  const sg_cut_model *model = &set->model;

  if (!number_places(set)) {
    return false;
  }
  while (set->sided < model->triangles) {
    size_t room = set->side_room;

    if (!sg_list_grow(&set->next_side, 3 * set->sided + 2, &room,
                      sizeof *set->next_side)) {
      return false;
    }
    set->side_room = room;
    for (uint32_t k = 0; k < 3; k++) {
      uint32_t key[2], side = 3 * (uint32_t)set->sided + k;

      side_key(set, (uint32_t)set->sided, k, key);
      uint32_t *last = sg_key_table_put(&set->side_of, key);
      if (!last) {
        return false;
      }
      set->next_side[side] = *last;
      *last = side;
    }
    set->sided++;
  }
  return true;
}

/* The only other triangle side of the segment between the ends of side k of a
 * triangle, if it runs the other way; SG_NO_KEY: there is none, or several. */
static uint32_t
other_side(const sg_cut_set *set, uint32_t triangle, uint32_t k)
{
  const sg_leaf_triangle *leaf = set->model.triangle;
  uint32_t other = SG_NO_KEY, key[2];

  side_key(set, triangle, k, key);
  uint32_t side = sg_key_table_get(&set->side_of, key);

  for (; side != SG_NO_KEY; side = set->next_side[side]) {
    if (leaf[side / 3].s == leaf[triangle].s && side != 3 * triangle + k) {
      if (other != SG_NO_KEY) {
        return SG_NO_KEY;
      }
      other = side;
    }
  }
  return other != SG_NO_KEY && set->place_of[leaf[other / 3].v[other % 3]] ==
                                   set->place_of[leaf[triangle].v[(k + 1) % 3]]
             ? other
             : SG_NO_KEY;
}

/* ---- flat ---- */

static void
normal_of(const double *const p[4], int i, int j, int k, double out[3])
{
  double u[3], w[3];

  for (int c = 0; c < 3; c++) {
    u[c] = p[j][c] - p[i][c];
    w[c] = p[k][c] - p[i][c];
  }
  sg_cross(u, w, out);
}

/* How much the four points span, from the first, and the square of the longest
 * way from there. */
static double
volume_of(const double *const p[4], double *square)
{
  double way[3][3], n[3];

  *square = 0.0;
  for (int i = 0; i < 3; i++) {
    sg_minus(p[i + 1], p[0], way[i]);
    *square = sg_larger(*square, sg_dot(way[i], way[i]));
  }
  sg_cross(way[0], way[1], n);
  return fabs(sg_dot(n, way[2]));
}

/* Most are, which takes no root to see: no face of what they span is larger
 * than the square of the longest side, and that is at most twice the longest
 * way from a corner. Rounding takes no 2^-40 of all this. */
static bool
are_far_from_flat(const sg_cut_set *set, const double *const p[4])
{
  double square, volume = volume_of(p, &square);
  double least = volume * 0x1p-3;

  return square > 1e-100 && square < 1e100 &&
         least > square * set->flat_within &&
         least * least > 0x1p-80 * square * square * square;
}

/* Whether four points are in one plane: exactly, or the least height of what
 * they span is within the tolerance. No normal of a sliver is asked. */
static bool
are_flat(const sg_cut_set *set, const double *const p[4])
{
  double n[3], way[3], area = 0.0, volume;

  if (are_far_from_flat(set, p)) {
    return false;
  }
  if (sg_orient3d(p[0], p[1], p[2], p[3]) == 0) {
    return true;
  }
  for (int i = 0; i < 4; i++) {
    normal_of(p, i, (i + 1) % 4, (i + 2) % 4, n);
    area = sg_larger(area, sg_length(n));
  }
  normal_of(p, 0, 1, 2, n);
  for (int c = 0; c < 3; c++) {
    way[c] = p[3][c] - p[0][c];
  }
  volume = fabs(sg_dot(n, way));
  return volume <= area * set->flat_within;
}

/* Whether triangles a, b, c and b, a, d lie on the two sides of a-b, as they
 * are seen along the axis that shows most of the first. Exact. */
static bool
is_opposite(const double *const p[4])
{
  double n[3], flat[4][2];
  int axis = 0, first, second;

  normal_of(p, 0, 1, 2, n);
  for (int c = 1; c < 3; c++) {
    axis = fabs(n[c]) > fabs(n[axis]) ? c : axis;
  }
  for (int i = 0; i < 4; i++) {
    flat[i][0] = p[i][(axis + 1) % 3];
    flat[i][1] = p[i][(axis + 2) % 3];
  }
  first = sg_orient2d(flat[0], flat[1], flat[2]);
  second = sg_orient2d(flat[1], flat[0], flat[3]);
  return first * second > 0;
}

int
sg_cut_is_inside(sg_cut_set *set, uint32_t triangle, int k, int32_t *face)
{
  const sg_leaf_triangle *leaf = set->model.triangle;
  const sg_leaf_vertex *vertex = set->model.vertex;
  int real = set->is_real(set->data, triangle, k);
  uint32_t other;

  *face = leaf[triangle].p;
  if (real <= 0) {
    return real < 0 ? -1 : 1;
  }
  if (!set->of_faces) {
    return 0;
  }
  if (!file_sides(set)) {
    return -1;
  }
  other = other_side(set, triangle, (uint32_t)k);
  if (other == SG_NO_KEY) {
    return 0;
  }
  const double *const p[4] = {vertex[leaf[triangle].v[k]].at,
                              vertex[leaf[triangle].v[(k + 1) % 3]].at,
                              vertex[leaf[triangle].v[(k + 2) % 3]].at,
                              vertex[leaf[other / 3].v[(other + 2) % 3]].at};
  if (leaf[other / 3].p < *face) {
    *face = leaf[other / 3].p;
  }
  return are_flat(set, p) && is_opposite(p);
}

int
sg_cut_along_inside(sg_cut_set *set, const uint32_t t[2], const sg_cut *cut)
{
  for (int i = 0; i < 2; i++) {
    int32_t face;
    int k = sg_cut_along(cut, i);
    int inside = k < 0 ? 1 : sg_cut_is_inside(set, t[i], k, &face);

    if (inside <= 0) {
      return inside;
    }
  }
  return 1;
}

bool
sg_cut_is_flat_pair(const sg_cut_set *set, const uint32_t t[2])
{
  const uint32_t *v = set->model.triangle[t[0]].v;
  const uint32_t *w = set->model.triangle[t[1]].v;
  const sg_leaf_vertex *vertex = set->model.vertex;
  const double *p[4] = {vertex[v[0]].at, vertex[v[1]].at, vertex[v[2]].at};

  if (!(set->flat_within > 0.0)) {
    return false;
  }
  for (int i = 0; i < 3; i++) { /* most end here: corners in common are flat */
    p[3] = vertex[w[i]].at;
    if (are_far_from_flat(set, p)) {
      return false;
    }
  }
  for (int i = 0; i < 3; i++) {
    p[3] = vertex[w[i]].at;
    if (!are_flat(set, p)) {
      return false;
    }
  }
  return true;
}

/* ---- contacts ---- */

/* Where vertex v of the model stands among those that lie in a common part of
 * faces of these segments. Null: no memory. */
static uint32_t *
vertex_inside(sg_cut_set *set, const uint32_t t[2], uint32_t v)
{
  const sg_leaf_triangle *leaf = set->model.triangle;
  int32_t s = leaf[t[0]].s, other = leaf[t[1]].s;

  if (!number_places(set)) {
    return NULL;
  }
  uint32_t key[3] = {(uint32_t)(s < other ? s : other),
                     (uint32_t)(s < other ? other : s), set->place_of[v]};

  return sg_key_table_put(&set->inside, key);
}

bool
sg_cut_note_inside(sg_cut_set *set, const uint32_t t[2], const sg_cut *cut)
{
  for (int end = 0; end < 2; end++) {
    for (int i = 0; i < 2; i++) {
      sg_feature f = cut->end[end].f[i];
      uint32_t *known =
          f > SG_CORNER_2
              ? NULL
              : vertex_inside(set, t, set->model.triangle[t[i]].v[f]);
      if (f <= SG_CORNER_2 && !known) {
        return false;
      }
      if (known) {
        *known = 1;
      }
    }
  }
  return true;
}

bool
sg_cut_put_off(sg_cut_set *set, const uint32_t t[2], const sg_cut_end *end)
{
  if (!sg_list_grow(&set->flat_touch, set->flat_touches, &set->flat_touch_room,
                    sizeof *set->flat_touch)) {
    return false;
  }
  set->flat_touch[set->flat_touches++] =
      (sg_cut_flat_touch){{t[0], t[1]}, *end};
  return true;
}

/* Whether a corner that touches is inside a face there. -1: no memory. */
static int
touches_inside(sg_cut_set *set, const sg_cut_flat_touch *touch)
{
  for (int i = 0; i < 2; i++) {
    sg_feature f = touch->end.f[i];
    if (f <= SG_CORNER_2) {
      uint32_t *known =
          vertex_inside(set, touch->t, set->model.triangle[touch->t[i]].v[f]);
      if (!known) {
        return -1;
      }
      if (*known == 1) {
        return 1;
      }
      *known = 0;
    }
  }
  return 0;
}

bool
sg_cut_touch_flat(sg_cut_set *set, const sg_cancel *cancel)
{
  for (size_t i = 0; i < set->flat_touches; i++) {
    const sg_cut_flat_touch *touch = &set->flat_touch[i];
    int inside = touches_inside(set, touch);

    if ((i % 256 == 0 && sg_cancelled(cancel)) || inside < 0 ||
        (!inside && sg_cut_touch(set, touch->t, &touch->end) < 0)) {
      return false;
    }
  }
  set->flat_touches = 0;
  return true;
}
