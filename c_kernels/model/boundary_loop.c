/* boundary_loop.c -- every face as a loop that begins with its lowest vertex,
 * or as triangles (boundary_mesh.h). */
#include "boundary_private.h"
#include "engine/list.h"
#include "join/cut.h"
#include "number/exact.h"

#include <stdlib.h>
#include <string.h>

enum { ASK_EVERY = 65536 };

bool
sg_boundary_no_memory(sg_boundary_maker *m)
{
  m->end = SG_BOUNDARY_NO_MEMORY;
  return false;
}

static bool
end_loop(sg_boundary_maker *m, bool changed)
{
  if (!sg_list_grow(&m->changed, m->loop.count, &m->changed_room,
                    sizeof *m->changed)) {
    return sg_boundary_no_memory(m);
  }
  m->changed[m->loop.count] = changed;
  return sg_mesh_end_list(&m->loop, 0) || sg_boundary_no_memory(m);
}

/* The lowest corner first. */
static bool
take_loop_triangle(sg_boundary_maker *m, const int32_t v[3])
{
  int k = v[0] < v[1] ? (v[0] < v[2] ? 0 : 2) : (v[1] < v[2] ? 1 : 2);

  for (int i = 0; i < 3; i++) {
    if (!sg_mesh_add_corner(&m->loop, v[(k + i) % 3])) {
      return sg_boundary_no_memory(m);
    }
  }
  return end_loop(m, true);
}

bool
sg_boundary_room(sg_boundary_maker *m, size_t n)
{
  size_t room = m->room; /* of both */

  return (sg_list_need(&m->from, n, &room, sizeof *m->from) &&
          sg_list_need(&m->to, n, &m->room, sizeof *m->to)) ||
         sg_boundary_no_memory(m);
}

/* True if the n edges at work, joined, are one loop that passes each of its
 * vertices once. */
static bool
is_simple(sg_boundary_maker *m, size_t n)
{
  if (n < 3 || m->loops.loops != 1 || m->loops.open) {
    return false;
  }
  m->stamp++;
  for (size_t i = 0; i < n; i++) {
    uint32_t *seen = &m->seen[m->from[i]];
    if (*seen == m->stamp) {
      return false;
    }
    *seen = m->stamp;
  }
  return true;
}

/* The edges at work in the order of their loop, the lowest vertex first; `to`
 * is free to hold the starts. */
static void
follow_loop(sg_boundary_maker *m, size_t n)
{
  int32_t at = 0;

  for (size_t i = 1; i < n; i++) {
    at = m->from[i] < m->from[at] ? (int32_t)i : at;
  }
  for (size_t i = 0; i < n; i++) {
    m->to[i] = m->from[at];
    at = m->loops.next[at];
  }
  memcpy(m->from, m->to, n * sizeof *m->from);
  for (size_t i = 0; i < n; i++) {
    m->to[i] = m->from[(i + 1) % n];
  }
}

static bool
add_loop(sg_boundary_maker *m, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    if (!sg_mesh_add_corner(&m->loop, m->from[i])) {
      return sg_boundary_no_memory(m);
    }
  }
  return end_loop(m, true);
}

/* Of edges in an order of their own. */
static bool
add_knot(sg_boundary_maker *m, const int32_t (*edge)[2], size_t n)
{
  int32_t(*sorted)[2] = malloc(n * sizeof *sorted);

  if (!sorted) {
    return sg_boundary_no_memory(m);
  }
  memcpy(sorted, edge, n * sizeof *sorted);
  n = sg_edges_cancel(sorted, n);
  for (size_t i = 0; i < n; i++) {
    m->from[i] = sorted[i][0];
    m->to[i] = sorted[i][1];
  }
  free(sorted);
  return sg_boundary_each_triangle(m, false, n, false, take_loop_triangle);
}

/* Whether the n corners of m->from lie in one plane, exactly: then it does not
 * matter how who reads the face divides it. */
static bool
is_flat(const sg_boundary_maker *m, size_t n)
{
  const double(*at)[3] = (const double(*)[3])m->b->at;
  double t[3][3];
  bool area = false;

  memcpy(t[0], at[m->from[0]], sizeof t[0]);
  memcpy(t[1], at[m->from[1]], sizeof t[1]);
  for (size_t i = 2; i < n; i++) {
    if (!area) { /* the first that is not in line with those two */
      memcpy(t[2], at[m->from[i]], sizeof t[2]);
      area = sg_cut_axis((const double(*)[3])t) >= 0;
    } else if (sg_orient3d(t[0], t[1], t[2], at[m->from[i]]) != 0) {
      return false;
    }
  }
  return true;
}

static bool
add_polygon(sg_boundary_maker *m, size_t f)
{
  uint32_t begin = m->b->begin[f];
  size_t n = m->b->begin[f + 1] - begin;

  if (!sg_boundary_room(m, n)) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    m->from[i] = m->b->edge[begin + i][0];
    m->to[i] = m->b->edge[begin + i][1];
  }
  if (!sg_loops_make(&m->loops, n, m->from, m->to)) {
    return sg_boundary_no_memory(m);
  }
  if (!is_simple(m, n)) {
    return add_knot(m, (const int32_t(*)[2])m->b->edge + begin, n);
  }
  follow_loop(m, n);
  return m->form->triangles || (m->form->flat && !is_flat(m, n))
             ? sg_boundary_each_triangle(m, false, n, true, take_loop_triangle)
             : add_loop(m, n);
}

static bool
add_face(sg_boundary_maker *m, size_t f)
{
  const int32_t(*e)[2] = (const int32_t(*)[2])m->b->edge + m->b->begin[f];

  if (m->b->begin[f + 1] - m->b->begin[f] == 3) {
    int second = e[1][0] == e[0][1] ? 1 : 2, third = 3 - second;
    if (e[second][0] == e[0][1] && e[third][0] == e[second][1] &&
        e[third][1] == e[0][0]) {
      size_t face = m->loop.count;
      bool done =
          take_loop_triangle(m, (int32_t[3]){e[0][0], e[0][1], e[second][1]});

      if (done) {
        m->changed[face] = m->b->changed[f];
      }
      return done;
    }
  }
  return add_polygon(m, f);
}

bool
sg_boundary_add_faces(sg_boundary_maker *m)
{
  for (size_t f = 0; f < m->b->faces; f++) {
    if (f % ASK_EVERY == 0 && sg_cancelled(m->cancel)) {
      m->end = SG_BOUNDARY_STOPPED;
      return false;
    }
    if (!add_face(m, f)) {
      return false;
    }
  }
  return true;
}
