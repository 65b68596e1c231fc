/* boundary_mesh.c -- see boundary_mesh.h: the loops of a boundary in order. */
#include "boundary_private.h"
#include "engine/search.h"

#include <stdlib.h>
#include <string.h>

enum { ASK_EVERY = 65536, SMALL = 12, MOST_SPLITS = 5 };

/* ---- in order ---------------------------------------------------------------
 */

static const int32_t *
corners(const sg_boundary_maker *m, uint32_t face, size_t *n)
{
  *n = m->loop.start[face + 1] - m->loop.start[face];
  return m->loop.corner + m->loop.start[face];
}

static int
compare_loops(const void *x, const void *y, void *data)
{
  const sg_boundary_maker *m = data;
  size_t na, nb;
  const int32_t *a = corners(m, *(const uint32_t *)x, &na);
  const int32_t *b = corners(m, *(const uint32_t *)y, &nb);

  for (size_t i = 0; i < na && i < nb; i++) {
    if (a[i] != b[i]) {
      return a[i] < b[i] ? -1 : 1;
    }
  }
  return na != nb ? (na < nb ? -1 : 1) : 0;
}

static void
sort_some(sg_boundary_maker *m, uint32_t *order, size_t n)
{
  if (n > SMALL) {
    qsort_r(order, n, sizeof *order, compare_loops, m);
    return;
  }
  SG_SORT_FEW(uint32_t, order, n, compare_loops(x, y, m) > 0);
}

/* Buckets by the first vertex, each sorted by itself. */
static bool
order_loops(sg_boundary_maker *m)
{
  size_t vertices = m->b->vertices, n = m->loop.count;

  m->order = malloc((n + 1) * sizeof *m->order);
  m->begin = calloc(vertices + 2, sizeof *m->begin);
  if (!m->order || !m->begin) {
    return sg_boundary_no_memory(m);
  }
  for (size_t f = 0; f < n; f++) {
    m->begin[m->loop.corner[m->loop.start[f]] + 2]++;
  }
  for (size_t v = 0; v < vertices; v++) {
    m->begin[v + 2] += m->begin[v + 1];
  }
  for (size_t f = 0; f < n; f++) {
    m->order[m->begin[m->loop.corner[m->loop.start[f]] + 1]++] = (uint32_t)f;
  }
  for (size_t v = 0; v < vertices; v++) {
    if (v % ASK_EVERY == 0 && sg_cancelled(m->cancel)) {
      m->end = SG_BOUNDARY_STOPPED;
      return false;
    }
    sort_some(m, m->order + m->begin[v], m->begin[v + 1] - m->begin[v]);
  }
  return true;
}

static bool
is_reverse(const sg_boundary_maker *m, uint32_t f, uint32_t g)
{
  size_t n, k;
  const int32_t *a = corners(m, f, &n), *b = corners(m, g, &k);

  for (size_t i = 1; n == k && i < n; i++) {
    if (a[i] != b[n - i]) {
      return false;
    }
  }
  return n == k;
}

/* The first place in order[low .. high - 1] of a loop whose second vertex is
 * not below v. */
static size_t
second_from(const sg_boundary_maker *m, size_t begin, size_t end, int32_t v)
{
  while (begin < end) {
    size_t middle = begin + (end - begin) / 2, n;
    if (corners(m, m->order[middle], &n)[1] < v) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin;
}

/* Drops loop i of the order and one that is its reverse. */
static void
cancel(sg_boundary_maker *m, size_t i)
{
  size_t n, k;
  const int32_t *v = corners(m, m->order[i], &n);
  int32_t last = v[n - 1];
  size_t end = m->begin[v[0] + 1];

  if (m->dropped[m->order[i]] || v[1] > last) {
    return;
  }
  for (size_t j = second_from(m, m->begin[v[0]], end, last);
       j < end && corners(m, m->order[j], &k)[1] == last; j++) {
    if (!m->dropped[m->order[j]] && is_reverse(m, m->order[i], m->order[j])) {
      m->dropped[m->order[i]] = m->dropped[m->order[j]] = 1;
      m->out->cancelled += 2;
      return;
    }
  }
}

static bool
cancel_all(sg_boundary_maker *m)
{
  m->dropped = calloc(m->loop.count + 1, 1);
  for (size_t i = 0; m->dropped && i < m->loop.count; i++) {
    cancel(m, i);
  }
  return m->dropped || sg_boundary_no_memory(m);
}

/* ---- the mesh
 * ---------------------------------------------------------------- */

/* The vertices that are used, in the order they have. */
static bool
put_vertices(sg_boundary_maker *m)
{
  m->number = malloc((m->b->vertices + 1) * sizeof *m->number);
  if (!m->number) {
    return sg_boundary_no_memory(m);
  }
  memset(m->number, -1, m->b->vertices * sizeof *m->number);
  for (size_t f = 0; f < m->loop.count; f++) {
    size_t n;
    const int32_t *v = corners(m, (uint32_t)f, &n);
    for (size_t i = 0; i < n && !m->dropped[f]; i++) {
      m->number[v[i]] = 0;
    }
  }
  for (size_t v = 0; v < m->b->vertices; v++) {
    if (m->number[v] == 0) {
      m->number[v] = (int32_t)m->out->mesh.vertices;
      if (!sg_mesh_add_vertex(&m->out->mesh, m->b->at[v])) {
        return sg_boundary_no_memory(m);
      }
    }
  }
  return true;
}

/* Puts the loops into the mesh; changed[f] becomes that of face f there. */
static bool
put_faces(sg_boundary_maker *m)
{
  sg_mesh *mesh = &m->out->mesh;
  unsigned char *changed = malloc(m->loop.count + 1);

  if (!changed || sg_mesh_add_segment(mesh, NULL, 0) < 0) {
    free(changed);
    return sg_boundary_no_memory(m);
  }
  for (size_t i = 0; i < m->loop.count; i++) {
    uint32_t f = m->order[i];
    size_t n;
    const int32_t *v = corners(m, f, &n);
    bool done = true;
    for (size_t k = 0; k < n && done && !m->dropped[f]; k++) {
      done = sg_mesh_add_corner(&mesh->face, m->number[v[k]]);
    }
    changed[mesh->face.count] = m->changed[f];
    if (!done || (!m->dropped[f] && !sg_mesh_end_list(&mesh->face, 0))) {
      free(changed);
      return sg_boundary_no_memory(m);
    }
  }
  free(m->changed);
  m->changed = changed;
  return true;
}

static bool
take_triangle_of_face(sg_boundary_maker *m, const int32_t v[3])
{
  memcpy(m->out->triangle[m->out->triangles++], v, 3 * sizeof *v);
  return true;
}

/* A polygon of n corners has n - 2 triangles, or one more for each corner that
 * lies on another of its edges. */
static bool
put_triangles_of(sg_boundary_maker *m, const int32_t *v, size_t n)
{
  if (n == 3) {
    return take_triangle_of_face(m, v);
  }
  if (!sg_boundary_room(m, n)) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    m->from[i] = v[i];
    m->to[i] = v[(i + 1) % n];
  }
  return sg_boundary_each_triangle(m, true, n, true, take_triangle_of_face);
}

static bool
put_triangles(sg_boundary_maker *m)
{
  sg_boundary_mesh *out = m->out;
  const sg_mesh_lists *face = &out->mesh.face;
  size_t room = 2 * face->corners + 1;

  out->triangle = malloc(room * sizeof *out->triangle);
  out->face_of = malloc(room * sizeof *out->face_of);
  out->changed = malloc(room);
  if (!out->triangle || !out->face_of || !out->changed) {
    return sg_boundary_no_memory(m);
  }
  for (size_t f = 0; f < face->count; f++) {
    size_t first = out->triangles;
    if (!put_triangles_of(m, face->corner + face->start[f],
                          face->start[f + 1] - face->start[f])) {
      return false;
    }
    for (size_t t = first; t < out->triangles; t++) {
      out->face_of[t] = (int32_t)f;
      out->changed[t] = m->changed[f];
    }
  }
  return true;
}

/* ---- together
 * ----------------------------------------------------------------- */

static bool
open_maker(sg_boundary_maker *m)
{
  m->seen = calloc(m->b->vertices + 1, sizeof *m->seen);
  return m->seen || sg_boundary_no_memory(m);
}

/* Divided edges are edges of other faces, in which they may need dividing
 * again. */
static bool
add_and_split(sg_boundary_maker *m)
{
  for (int round = 0;; round++) {
    if (!sg_boundary_add_faces(m)) {
      return false;
    }
    if (m->splits.n == 0 || round == MOST_SPLITS) {
      return true;
    }
    if (!sg_boundary_split(m->b, &m->splits)) {
      return sg_boundary_no_memory(m);
    }
    m->splits.n = 0;
    m->loop.count = m->loop.corners = 0;
    m->out->stuck = 0;
  }
}

static void
close_maker(sg_boundary_maker *m)
{
  free(m->loop.start);
  free(m->loop.corner);
  free(m->loop.segment);
  free(m->changed);
  free(m->order);
  free(m->begin);
  free(m->dropped);
  free(m->number);
  free(m->from);
  free(m->to);
  free(m->seen);
  free(m->found.item);
  free(m->splits.item);
  sg_loops_clear(&m->loops);
  sg_work_close(m->work);
}

sg_boundary_end
sg_boundary_mesh_make(sg_boundary *boundary, const sg_form *form,
                      const sg_cancel *cancel, sg_boundary_mesh *out)
{
  sg_boundary_maker m = {
      .b = boundary, .form = form, .cancel = cancel, .out = out, .reach = -1};

  *out = (sg_boundary_mesh){.mesh.grain = boundary->grain};
  bool done = open_maker(&m) && add_and_split(&m) && order_loops(&m) &&
              cancel_all(&m) && put_vertices(&m) && put_faces(&m) &&
              put_triangles(&m);
  close_maker(&m);
  sg_boundary_clear(
      boundary); /* most memory is in use while edges are paired */
  return done ? sg_boundary_mesh_pair(out, form->copies, cancel) : m.end;
}

void
sg_boundary_mesh_clear(sg_boundary_mesh *mesh)
{
  sg_mesh_clear(&mesh->mesh);
  free(mesh->triangle);
  free(mesh->face_of);
  free(mesh->changed);
  free(mesh->crossed);
  *mesh = (sg_boundary_mesh){0};
}
