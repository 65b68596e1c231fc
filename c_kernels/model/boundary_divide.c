/* boundary_divide.c -- the triangles of one face (boundary_mesh.h). */
#include "boundary_private.h"

#include "polygon/delaunay.h"
#include "polygon/flatness.h"
#include "polygon/plane.h"

#include <math.h>

static double
reach_of(sg_boundary_maker *m)
{
  if (m->reach < 0) {
    sg_flatness flatness;
    sg_flatness_init(&flatness, m->b->grain);
    for (size_t v = 0; v < m->b->vertices; v++) {
      sg_flatness_see(&flatness, m->b->at[v]);
    }
    m->reach = sg_flatness_flat(&flatness);
  }
  return m->reach;
}

static bool
fill_work(sg_boundary_maker *m, const double (*at)[3], size_t n,
          const double normal[3])
{
  if (!m->work && !(m->work = sg_work_open(normal))) {
    return false;
  }
  sg_work_clear(m->work, normal);
  for (size_t i = 0; i < n; i++) {
    sg_point ends[2];
    sg_point_set(&ends[0], at[m->from[i]]);
    sg_point_set(&ends[1], at[m->to[i]]);
    int32_t a = sg_work_vertex(m->work, m->from[i] + 1, &ends[0]);
    int32_t b = sg_work_vertex(m->work, m->to[i] + 1, &ends[1]);
    if (a < 0 || b < 0 || !sg_work_add(m->work, a, b, 1, (int64_t)i + 1)) {
      return false;
    }
  }
  return true;
}

/* Notes the edges at work that have been divided: their pieces have labels.
 * False: no memory. */
static bool
note_splits(sg_boundary_maker *m)
{
  for (int32_t e = sg_work_next(m->work, 0); e; e = sg_work_next(m->work, e)) {
    const sg_work_edge *piece = sg_work_get(m->work, e);
    int32_t start = sg_work_id(m->work, piece->start) - 1;
    int32_t end = sg_work_id(m->work, piece->end) - 1;
    size_t i = (size_t)piece->label - 1;
    if (piece->label > 0 &&
        ((start != m->from[i] && start != m->to[i] &&
          !sg_boundary_note_split(&m->splits, m->from[i], m->to[i], start)) ||
         (end != m->from[i] && end != m->to[i] &&
          !sg_boundary_note_split(&m->splits, m->from[i], m->to[i], end)))) {
      return false;
    }
  }
  return true;
}

/* How far rounding has moved the farthest vertex of the n edges at work. */
static double
moved_by(const sg_boundary_maker *m, size_t n)
{
  double farthest = 0;

  for (size_t i = 0; i < n; i++) {
    const double *at = m->b->at[m->from[i]], *was = m->b->was[m->from[i]];
    double x = at[0] - was[0], y = at[1] - was[1], z = at[2] - was[2];
    farthest = fmax(farthest, x * x + y * y + z * z);
  }
  return sqrt(farthest);
}

/* One try, with contacts taken exactly or, if reach > 0, within that. */
static sg_outcome
try_to_divide(sg_boundary_maker *m, const double (*at)[3], size_t n,
              double reach, double moved)
{
  sg_newell sum;
  sg_plane plane;
  int32_t edge;

  m->found.n = 0;
  sg_newell_init(&sum);
  for (size_t i = 0; i < n; i++) {
    sg_newell_edge(&sum, at[m->from[i]], at[m->to[i]]);
  }
  if (!sg_newell_plane(&sum, &plane)) {
    return SG_STUCK;
  }
  if (!fill_work(m, at, n, plane.n)) {
    return SG_NO_SPACE;
  }
  sg_outcome outcome = sg_work_resolve_asking(m->work, reach, m->cancel);

  if (outcome != SG_DONE) {
    return outcome;
  }
  return note_splits(m) ? sg_work_triangulate_moved(m->work, moved, &m->found,
                                                    &edge, m->cancel)
                        : SG_NO_SPACE;
}

/* True if the triangles have all vertices of the face: none was taken for
 * another one. */
static bool
have_all(sg_boundary_maker *m, size_t n)
{
  m->stamp++;
  for (size_t i = 0; i < m->found.n; i++) {
    for (int k = 0; k < 3; k++) {
      m->seen[sg_work_id(m->work, m->found.item[i].v[k]) - 1] = m->stamp;
    }
  }
  for (size_t i = 0; i < n; i++) {
    if (m->seen[m->from[i]] != m->stamp) {
      return false;
    }
  }
  return true;
}

/* Where things are now, or else where they were: the triangles may lie over
 * each other then, by no more than the rounding. */
static sg_outcome
divide(sg_boundary_maker *m, size_t n)
{
  const double(*at[2])[3] = {(const double(*)[3])m->b->at,
                             (const double(*)[3])m->b->was};
  sg_outcome outcome = SG_STUCK;

  for (int i = 0; i < 2 && outcome == SG_STUCK; i++) {
    size_t splits = m->splits.n;
    outcome = try_to_divide(m, at[i], n, 0, moved_by(m, n));
    if (outcome == SG_DONE && !have_all(m, n)) {
      outcome = SG_STUCK;
    }
    m->splits.n = outcome == SG_STUCK ? splits : m->splits.n;
  }
  return outcome;
}

/* As a reader of the file will divide it (complete.h): contacts are taken
 * exactly, and if that gets stuck within the tolerance. */
static sg_outcome
divide_as_reader(sg_boundary_maker *m, size_t n)
{
  const double(*at)[3] = (const double(*)[3])m->out->mesh.vertex;
  sg_outcome outcome = try_to_divide(m, at, n, 0, 0);

  return outcome == SG_STUCK ? try_to_divide(m, at, n, reach_of(m), 0)
                             : outcome;
}

/* A convex quadrilateral needs no scratch relation; the rule takes the corner
 * that follows its first edge. Not so where that makes a thin triangle. */
static bool
divide_quad(sg_boundary_maker *m, const double (*at)[3], double moved)
{
  const int32_t *v = m->from;
  sg_newell sum;
  sg_plane plane;
  int axis = 0;

  sg_newell_init(&sum);
  for (int i = 0; i < 4; i++) {
    sg_newell_edge(&sum, at[m->from[i]], at[m->to[i]]);
  }
  if (!sg_newell_plane(&sum, &plane)) {
    return false;
  }
  for (int k = 1; k < 3; k++) {
    axis = fabs(plane.n[k]) > fabs(plane.n[axis]) ? k : axis;
  }
  int x = (axis + 1) % 3, y = (axis + 2) % 3;
  for (int i = 0; i < 4; i++) {
    const double *a = at[m->from[i]], *b = at[m->from[(i + 1) % 4]],
                 *c = at[m->from[(i + 2) % 4]];
    if (sg_orient2d((double[2]){a[x], a[y]}, (double[2]){b[x], b[y]},
                    (double[2]){c[x], c[y]}) != (plane.n[axis] < 0 ? -1 : 1)) {
      return false;
    }
  }
  return !sg_triangle_is_thin(at[v[0]], at[v[1]], at[v[2]], moved) &&
         !sg_triangle_is_thin(at[v[2]], at[v[3]], at[v[0]], moved);
}

bool
sg_boundary_each_triangle(sg_boundary_maker *m, bool reader, size_t n,
                          bool ring, sg_boundary_take *take)
{
  const double(*at)[3] =
      (const double(*)[3])(reader ? m->out->mesh.vertex : m->b->at);

  if (ring && n == 4 && divide_quad(m, at, reader ? 0 : moved_by(m, n))) {
    const int32_t *v = m->from;
    return take(m, (int32_t[3]){v[0], v[1], v[2]}) &&
           take(m, (int32_t[3]){v[2], v[3], v[0]});
  }
  switch (reader ? divide_as_reader(m, n) : divide(m, n)) {
  case SG_DONE:
    break;
  case SG_STUCK:
    m->out->stuck++;
    return true;
  case SG_STOPPED:
  case SG_TOO_MUCH: /* no guard says so */
    m->end = SG_BOUNDARY_STOPPED;
    return false;
  case SG_NO_SPACE:
    return sg_boundary_no_memory(m);
  }
  for (size_t i = 0; i < m->found.n; i++) {
    int32_t v[3];
    for (int k = 0; k < 3; k++) {
      v[k] = sg_work_id(m->work, m->found.item[i].v[k]) - 1;
    }
    if (!take(m, v)) {
      return false;
    }
  }
  return true;
}
