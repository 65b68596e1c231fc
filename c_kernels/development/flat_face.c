/* flat_face.c -- see flat_face.h. */
#include "flat_face.h"

#include "number/vector.h"
#include "polygon/plane.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NO_CORNER UINT32_MAX
#define NO_EDGE   UINT32_MAX

/* What is under way: the triangles of each polygon, which corner a vertex is of
 * the face that is being made, and which edges are sides already. */
typedef struct maker {
  const sg_dense *dense;
  sg_flat_faces *out;
  double tolerance;
  uint32_t *begin, *triangle; /* [polygons + 1], [triangles] */
  uint32_t *corner;           /* [vertices] or NO_CORNER */
  bool *is_side;              /* [edges] */
} maker;

/* ---- room --------------------------------------------------------------- */

/* Every array as large as it can come to be. */
static bool
take_room(sg_flat_faces *f, const sg_dense *d, size_t ends)
{
  size_t faces = d->polygons + d->triangles + 1;
  size_t corners = ends + 3 * d->triangles + 1;

  f->polygon = malloc(faces * sizeof *f->polygon);
  f->normal = malloc(faces * sizeof *f->normal);
  f->area = malloc(faces * sizeof *f->area);
  f->longest = malloc(faces * sizeof *f->longest);
  f->bent_before = malloc(faces * sizeof *f->bent_before);
  f->bent = calloc(d->polygons + 1, sizeof *f->bent);
  f->corner_begin = malloc((faces + 1) * sizeof *f->corner_begin);
  f->side_begin = malloc((faces + 1) * sizeof *f->side_begin);
  f->triangle_begin = malloc((faces + 1) * sizeof *f->triangle_begin);
  f->vertex = malloc(corners * sizeof *f->vertex);
  f->at = malloc(corners * sizeof *f->at);
  f->side = malloc(corners * sizeof *f->side);
  f->face_of = malloc(corners * sizeof *f->face_of);
  f->triangle = malloc((d->triangles + 1) * sizeof *f->triangle);
  f->triangle_place = malloc((d->triangles + 1) * sizeof *f->triangle_place);
  f->triangle_face = malloc((d->triangles + 1) * sizeof *f->triangle_face);
  return f->polygon && f->normal && f->area && f->longest && f->bent_before &&
         f->bent && f->corner_begin && f->side_begin && f->triangle_begin &&
         f->vertex && f->at && f->side && f->face_of && f->triangle &&
         f->triangle_place && f->triangle_face;
}

void
sg_flat_faces_clear(sg_flat_faces *f)
{
  free(f->polygon);
  free(f->normal);
  free(f->area);
  free(f->longest);
  free(f->bent);
  free(f->bent_before);
  free(f->corner_begin);
  free(f->side_begin);
  free(f->triangle_begin);
  free(f->vertex);
  free(f->at);
  free(f->side);
  free(f->face_of);
  free(f->side_of);
  free(f->triangle);
  free(f->triangle_place);
  free(f->triangle_face);
  *f = (sg_flat_faces){0};
}

/* ---- the frame ---------------------------------------------------------- */

/* Makes a unit vector; false: it is nothing. */
static bool
make_unit(double v[3])
{
  double size = sqrt(sg_dot(v, v));

  for (int k = 0; k < 3 && size > 0; k++) {
    v[k] /= size;
  }
  return size > 0;
}

/* A unit vector square to x, which is one or nothing. */
static void
any_square_to(const double x[3], double out[3])
{
  int least = 0;

  for (int k = 1; k < 3; k++) {
    least = fabs(x[k]) < fabs(x[least]) ? k : least;
  }
  const double axis[3] = {least == 0, least == 1, least == 2};

  sg_cross(x, axis, out);
  if (!make_unit(out)) {
    out[0] = out[1] = 0;
    out[2] = 1;
  }
}

static void
side_vector(const sg_flat_faces *f, const sg_dense *d, uint32_t side,
            double out[3])
{
  sg_minus(d->at[sg_flat_side_to(f, side)], d->at[sg_flat_side_from(f, side)],
           out);
}

static uint32_t
longest_side(const sg_flat_faces *f, const sg_dense *d, size_t face)
{
  uint32_t best = f->side_begin[face];
  double most = -1, along[3];

  for (uint32_t k = best; k < f->side_begin[face + 1]; k++) {
    side_vector(f, d, k, along);
    double square = sg_dot(along, along);
    if (square > most) {
      most = square;
      best = k;
    }
  }
  return best;
}

/* Places the corners of a face whose normal is known. */
static void
place_corners(sg_flat_faces *f, const sg_dense *d, size_t face)
{
  const double *normal = f->normal[face];
  uint32_t first = f->corner_begin[face];
  double x[3] = {0}, y[3], off;

  if (f->side_begin[face] < f->side_begin[face + 1]) {
    side_vector(f, d, f->longest[face], x);
  }
  off = sg_dot(x, normal);
  for (int k = 0; k < 3; k++) {
    x[k] -= off * normal[k];
  }
  if (!make_unit(x)) {
    any_square_to(normal, x);
  }
  sg_cross(normal, x, y);
  for (uint32_t c = first; c < f->corner_begin[face + 1]; c++) {
    double v[3];
    sg_minus(d->at[f->vertex[c]], d->at[f->vertex[first]], v);
    f->at[c][0] = sg_dot(v, x);
    f->at[c][1] = sg_dot(v, y);
  }
}

void
sg_flat_face_lean(sg_flat_faces *f, const sg_dense *dense, uint32_t face,
                  const double normal[3])
{
  double x[3], n[3];

  memcpy(n, normal, sizeof n);
  side_vector(f, dense, f->longest[face], x);
  if (make_unit(x)) {
    double off = sg_dot(n, x);
    for (int k = 0; k < 3; k++) {
      n[k] -= off * x[k];
    }
    if (!make_unit(n)) {
      any_square_to(x, n);
    }
  }
  memcpy(f->normal[face], n, sizeof n);
  place_corners(f, dense, face);
}

/* ---- one face ----------------------------------------------------------- */

static uint32_t
corner_of(maker *m, int32_t v)
{
  if (m->corner[v] == NO_CORNER) {
    m->corner[v] = (uint32_t)m->out->corners;
    m->out->vertex[m->out->corners++] = v;
  }
  return m->corner[v];
}

/* The number of the next side along an edge: that edge, if no side is it yet;
 * else, and along NO_EDGE, that of a new chord. */
static uint32_t
side_number(maker *m, uint32_t edge)
{
  if (edge == NO_EDGE || m->is_side[edge]) {
    return (uint32_t)(m->dense->edges + m->out->chords++);
  }
  m->is_side[edge] = true;
  return edge;
}

static void
add_side(maker *m, uint32_t edge, int32_t from, int32_t to)
{
  sg_flat_faces *f = m->out;

  f->face_of[f->sides] = (uint32_t)f->faces;
  f->side[f->sides].edge = side_number(m, edge);
  f->side[f->sides].from = corner_of(m, from);
  f->side[f->sides++].to = corner_of(m, to);
}

static void
add_triangle(maker *m, uint32_t t)
{
  sg_flat_faces *f = m->out;

  for (int k = 0; k < 3; k++) {
    f->triangle[f->triangles][k] = corner_of(m, m->dense->corner[t][k]);
  }
  f->triangle_face[f->triangles] = (uint32_t)f->faces;
  f->triangle_place[f->triangles++] = t;
}

/* The plane of the face under way, from its sides. */
static bool
find_plane(const sg_flat_faces *f, const sg_dense *d, size_t face,
           sg_plane *plane, double *area)
{
  sg_newell sum;

  sg_newell_init(&sum);
  for (uint32_t k = f->side_begin[face]; k < f->sides; k++) {
    sg_newell_edge(&sum, d->at[sg_flat_side_from(f, k)],
                   d->at[sg_flat_side_to(f, k)]);
  }
  *area = sg_newell_area(&sum);
  return sg_newell_plane(&sum, plane);
}

static void
begin_face(maker *m)
{
  sg_flat_faces *f = m->out;

  f->corner_begin[f->faces] = (uint32_t)f->corners;
  f->side_begin[f->faces] = (uint32_t)f->sides;
  f->triangle_begin[f->faces] = (uint32_t)f->triangles;
}

/* The vertices of the face are free for the next one. */
static void
forget_corners(maker *m)
{
  sg_flat_faces *f = m->out;

  for (size_t c = f->corner_begin[f->faces]; c < f->corners; c++) {
    m->corner[f->vertex[c]] = NO_CORNER;
  }
}

/* Takes the sides of the face under way back. */
static void
drop_sides(maker *m)
{
  sg_flat_faces *f = m->out;

  forget_corners(m);
  while (f->sides > f->side_begin[f->faces]) {
    uint32_t edge = f->side[--f->sides].edge;
    if (edge < m->dense->edges) {
      m->is_side[edge] = false;
    } else {
      f->chords--;
    }
  }
  f->corners = f->corner_begin[f->faces];
}

static void
end_face(maker *m, uint32_t polygon)
{
  sg_flat_faces *f = m->out;
  size_t face = f->faces;
  sg_plane plane;
  double x[3] = {0};

  forget_corners(m);
  f->polygon[face] = polygon;
  f->bent_before[face] = (uint32_t)f->bent_faces;
  f->bent_faces += f->bent[polygon];
  f->faces++;
  begin_face(m);
  f->longest[face] = longest_side(f, m->dense, face);
  if (find_plane(f, m->dense, face, &plane, &f->area[face])) {
    memcpy(f->normal[face], plane.n, sizeof plane.n);
  } else {
    if (f->side_begin[face] < f->sides) {
      side_vector(f, m->dense, f->longest[face], x);
    }
    make_unit(x);
    any_square_to(x, f->normal[face]);
  }
  place_corners(f, m->dense, face);
}

/* ---- polygons ----------------------------------------------------------- */

/* Whether the face under way, of more than three sides, is flat. */
static bool
is_flat(maker *m)
{
  const sg_flat_faces *f = m->out;
  sg_plane plane;
  double area;

  if (f->sides - f->side_begin[f->faces] <= 3 ||
      !find_plane(f, m->dense, f->faces, &plane, &area)) {
    return true;
  }
  for (size_t c = f->corner_begin[f->faces]; c < f->corners; c++) {
    if (fabs(sg_plane_distance(&plane, m->dense->at[f->vertex[c]])) >
        m->tolerance) {
      return false;
    }
  }
  return true;
}

/* The edge of polygon p between two vertices, or NO_EDGE. */
static uint32_t
edge_between(const sg_dense *d, size_t p, int32_t from, int32_t to)
{
  for (uint32_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    int32_t e = d->list[k];
    if (d->from[e] == from && d->to[e] == to) {
      return (uint32_t)e;
    }
  }
  return NO_EDGE;
}

static void
add_bent(maker *m, size_t p)
{
  const sg_dense *d = m->dense;

  m->out->bent[p] = true;
  m->out->bents++;
  for (uint32_t i = m->begin[p]; i < m->begin[p + 1]; i++) {
    uint32_t t = m->triangle[i];
    begin_face(m);
    for (int k = 0; k < 3; k++) {
      int32_t from = d->corner[t][k], to = d->corner[t][(k + 1) % 3];
      add_side(m, edge_between(d, p, from, to), from, to);
    }
    add_triangle(m, t);
    end_face(m, (uint32_t)p);
  }
}

static void
add_polygon(maker *m, size_t p)
{
  const sg_dense *d = m->dense;

  begin_face(m);
  for (uint32_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    int32_t e = d->list[k];
    add_side(m, (uint32_t)e, d->from[e], d->to[e]);
  }
  if (!is_flat(m) && m->begin[p] < m->begin[p + 1]) {
    drop_sides(m);
    add_bent(m, p);
    return;
  }
  for (uint32_t i = m->begin[p]; i < m->begin[p + 1]; i++) {
    add_triangle(m, m->triangle[i]);
  }
  end_face(m, (uint32_t)p);
}

static bool
make_all(maker *m, const bool *removed, const sg_cancel *cancel, bool *stopped)
{
  for (size_t p = 0; p < m->dense->polygons; p++) {
    if (sg_cancel_every(cancel, p)) {
      *stopped = true;
      return false;
    }
    if (!removed || !removed[p]) {
      add_polygon(m, p);
    }
  }
  return true;
}

static bool
find_sides_of_edges(sg_flat_faces *f, const sg_dense *d,
                    const sg_cancel *cancel, bool *stopped)
{
  size_t edges = d->edges + f->chords + 1;

  f->side_of = malloc(edges * sizeof *f->side_of);
  if (!f->side_of) {
    return false;
  }
  memset(f->side_of, 0xff, edges * sizeof *f->side_of);
  for (uint32_t k = 0; k < f->sides && !*stopped; k++) {
    *stopped = sg_cancel_every(cancel, k);
    f->side_of[f->side[k].edge] = k;
  }
  return !*stopped;
}

bool
sg_flat_faces_make(const sg_dense *dense, const bool *removed, double tolerance,
                   const sg_cancel *cancel, sg_flat_faces *out, bool *stopped)
{
  maker m = {.dense = dense, .out = out, .tolerance = tolerance};
  bool made;

  *out = (sg_flat_faces){0};
  *stopped = false;
  m.corner = malloc((dense->vertices + 1) * sizeof *m.corner);
  m.is_side = calloc(dense->edges + 1, sizeof *m.is_side);
  made = sg_dense_by_polygon(dense, &m.begin, &m.triangle) && m.corner &&
         m.is_side &&
         take_room(out, dense, 2 * dense->list_begin[dense->polygons]);
  if (made) {
    memset(m.corner, 0xff, (dense->vertices + 1) * sizeof *m.corner);
    begin_face(&m);
    made = make_all(&m, removed, cancel, stopped) &&
           find_sides_of_edges(out, dense, cancel, stopped);
  }
  free(m.begin);
  free(m.triangle);
  free(m.corner);
  free(m.is_side);
  return made;
}
