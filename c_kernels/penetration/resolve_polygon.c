/* resolve_polygon.c -- one polygon with its shared points: see the header. */
#include "resolve_polygon.h"
#include "engine/search.h"

#include "polygon/delaunay.h"
#include "polygon/triangulate.h"

#include <stdlib.h>
#include <string.h>

void
sg_resolved_polygon_clear(sg_resolved_polygon *polygon)
{
  free(polygon->edge.item);
  free(polygon->triangle.item);
}

/* The polygon in hand. */
typedef struct maker {
  const sg_resolve *r;
  int32_t s, p;
  sg_work *work;
  int32_t own; /* the polygon's edges are those up to this one; then seams */
  const sg_cancel *cancel;
  sg_meetings met;
  bool stopped;
} maker;

enum { ASKED = 1 << 6 }; /* seams or points of a polygon between questions */

static bool
is_stopped(maker *m, size_t i)
{
  m->stopped =
      m->stopped || (i % ASKED == ASKED - 1 && sg_cancelled(m->cancel));
  return m->stopped;
}

/* ---- vertices ---- */

static int32_t
enter_point(maker *m, int32_t name, const double at[3])
{
  sg_point point;

  sg_point_set(&point, at);
  return sg_work_vertex(m->work, name, &point);
}

/* Vertex v of the segment, where it is now. */
static int32_t
enter_vertex(maker *m, int32_t v, const double at[3])
{
  uint32_t point = sg_resolve_point_of(m->r, m->s, v);

  return enter_point(m, v,
                     point == SG_NO_KEY ? at : m->r->point.item[point].at);
}

static int32_t
enter_place(maker *m, const sg_resolve_place *place)
{
  return enter_point(m, place->name, m->r->point.item[place->point].at);
}

/* ---- edges ---- */

static bool
add_edge(maker *m, int32_t a, int32_t b, const sg_polygon_row *row)
{
  return sg_work_add(m->work, a, b, row->et, row->e) != 0;
}

/* Adds a row in the parts it is divided into. */
static bool
add_row(maker *m, const sg_polygon_row *row)
{
  const sg_resolve *r = m->r;
  const sg_resolve_split *split =
      sg_resolve_split_of(r, m->s, row->v[0], row->v[1]);
  int32_t from = enter_vertex(m, row->v[0], row->at[0]);

  for (size_t k = 0; split && from >= 0 && k < split->n; k++) {
    size_t i = row->v[0] == split->v[0] ? k : split->n - 1 - k;
    int32_t to = enter_place(m, &r->place.item[split->first + i]);
    if (to < 0 || !add_edge(m, from, to, row)) {
      return false;
    }
    from = to;
  }
  int32_t last = from < 0 ? from : enter_vertex(m, row->v[1], row->at[1]);

  return last >= 0 && add_edge(m, from, last, row);
}

/* ---- seams ---- */

/* The picture's coordinates: those that are left when `axis` is dropped. */
static void
seen_from(int axis, const double at[3], double out[2])
{
  out[0] = at[(axis + 1) % 3];
  out[1] = at[(axis + 2) % 3];
}

/* How often the polygon goes round a point of the picture. */
static int
turns_round(const maker *m, const double at[2])
{
  const sg_work *work = m->work;
  int axis = sg_work_axis(work), turns = 0;

  for (int32_t e = sg_work_next(work, 0); e && e <= m->own;
       e = sg_work_next(work, e)) {
    const sg_work_edge *edge = sg_work_get(work, e);
    double a[2], b[2];

    seen_from(axis, sg_work_point(work, edge->start)->p, a);
    seen_from(axis, sg_work_point(work, edge->end)->p, b);
    if (a[1] <= at[1] && at[1] < b[1]) {
      turns += sg_orient2d(a, b, at) > 0;
    } else if (b[1] <= at[1] && at[1] < a[1]) {
      turns -= sg_orient2d(a, b, at) < 0;
    }
  }
  return turns;
}

/* Whether the seam v-w would lie inside and meet nothing. -1: no memory. */
static int
is_free(maker *m, int32_t v, int32_t w)
{
  double a[2], b[2], middle[2];

  if (sg_work_pair(m->work, v, w) || sg_work_pair(m->work, w, v)) {
    return 0;
  }
  if (!sg_work_meeting(m->work, v, w, &m->met)) {
    return -1;
  }
  seen_from(sg_work_axis(m->work), sg_work_point(m->work, v)->p, a);
  seen_from(sg_work_axis(m->work), sg_work_point(m->work, w)->p, b);
  for (int k = 0; k < 2; k++) {
    middle[k] = 0.5 * a[k] + 0.5 * b[k];
  }
  return m->met.n == 0 && turns_round(m, middle) != 0;
}

static bool
add_seam(maker *m, const sg_resolve_seam *seam)
{
  const sg_resolve_place *a = sg_resolve_place_of(m->r, seam->a, m->s);
  const sg_resolve_place *b = sg_resolve_place_of(m->r, seam->b, m->s);
  int32_t v = sg_work_find(m->work, a->name);
  int32_t w = sg_work_find(m->work, b->name);

  if (v == SG_WORK_NONE || w == SG_WORK_NONE) {
    return true; /* one of them is beside this polygon */
  }
  int free = is_free(m, v, w);

  return free == 0 || (free > 0 && sg_work_add(m->work, v, w, 0, 0) &&
                       sg_work_add(m->work, w, v, 0, 0));
}

static int
compare_polygons(int32_t s, int32_t p, int32_t s2, int32_t p2)
{
  return s != s2 ? (s < s2 ? -1 : 1) : (p > p2) - (p < p2);
}

static bool
add_seams(maker *m)
{
  const sg_resolve *r = m->r;
  const sg_resolve_seam *seam = r->seam.item;
  size_t a;

  SG_SEARCH(a, 0, r->seam.n,
            compare_polygons(seam[a].s, seam[a].p, m->s, m->p) < 0);
  for (; a < r->seam.n && seam[a].s == m->s && seam[a].p == m->p; a++) {
    if (is_stopped(m, a) || !add_seam(m, &seam[a])) {
      return false;
    }
  }
  return true;
}

/* ---- points inside ---- */

static size_t
first_inside(const sg_resolve *r, int32_t s, int32_t p)
{
  const sg_resolve_place *place = r->place.item;
  size_t at;

  SG_SEARCH(at, r->first_inside, r->place.n,
            compare_polygons(place[at].s, place[at].p, s, p) < 0);
  return at;
}

static bool
is_inside_place(const maker *m, size_t i)
{
  const sg_resolve_place *place = &m->r->place.item[i];

  return i < m->r->place.n && place->s == m->s && place->p == m->p;
}

static bool
enter_inside(maker *m)
{
  for (size_t i = first_inside(m->r, m->s, m->p); is_inside_place(m, i); i++) {
    if (enter_place(m, &m->r->place.item[i]) < 0) {
      return false;
    }
  }
  return true;
}

/* The points that no seam reaches become corners of triangles. */
static bool
add_inside(maker *m, const bool *used, sg_triangles *out)
{
  for (size_t i = first_inside(m->r, m->s, m->p); is_inside_place(m, i); i++) {
    int32_t v = sg_work_find(m->work, m->r->place.item[i].name);
    if (is_stopped(m, i) ||
        (!used[v] && !sg_triangles_insert(m->work, out, v))) {
      return false;
    }
  }
  return true;
}

/* ---- the whole ---- */

static bool
keep_edges(maker *m, sg_resolved_polygon *out, bool *used)
{
  for (int32_t e = sg_work_next(m->work, 0); e; e = sg_work_next(m->work, e)) {
    const sg_work_edge *edge = sg_work_get(m->work, e);
    sg_resolved_edge kept = {
        {sg_work_id(m->work, edge->start), sg_work_id(m->work, edge->end)},
        edge->et,
        (int32_t)edge->label};
    used[edge->start] = used[edge->end] = true;
    if (!SG_PUSH(out->edge, kept)) {
      return false;
    }
  }
  return true;
}

static bool
is_edge(void *data, int32_t a, int32_t b)
{
  const sg_key_table *edges = data;
  uint32_t key[2] = {(uint32_t)(a < b ? a : b), (uint32_t)(a < b ? b : a)};

  return sg_key_table_get(edges, key) != SG_NO_KEY;
}

static bool
note_edges(const maker *m, sg_key_table *edges)
{
  for (int32_t e = sg_work_next(m->work, 0); e; e = sg_work_next(m->work, e)) {
    const sg_work_edge *edge = sg_work_get(m->work, e);
    int32_t a = edge->start, b = edge->end;
    uint32_t *known =
        sg_key_table_put(edges, (uint32_t[2]){(uint32_t)(a < b ? a : b),
                                              (uint32_t)(a < b ? b : a)});
    if (!known) {
      return false;
    }
    *known = 0;
  }
  return true;
}

static sg_resolved
failed(const maker *m)
{
  return m->stopped ? SG_RESOLVE_STOPPED : SG_RESOLVE_NO_MEMORY;
}

static sg_resolved
triangulate(maker *m, const bool *used, sg_key_table *edges,
            sg_resolved_polygon *out)
{
  sg_triangles triangles = {0};
  int32_t stuck;

  if (!note_edges(m, edges)) {
    return SG_RESOLVE_NO_MEMORY;
  }
  sg_outcome end = sg_work_triangulate(m->work, &triangles, &stuck, m->cancel);
  bool done = end == SG_DONE && add_inside(m, used, &triangles);

  if (done && !triangles.settled) {
    end = sg_triangles_delaunay(m->work, &triangles, is_edge, edges, m->cancel);
    done = end == SG_DONE;
  }

  for (size_t i = 0; i < triangles.n && done; i++) {
    sg_triangle corners;
    for (int k = 0; k < 3; k++) {
      corners.v[k] = sg_work_id(m->work, triangles.item[i].v[k]);
    }
    done = SG_PUSH(out->triangle, corners);
  }
  free(triangles.item);
  return done                ? SG_RESOLVED
         : end == SG_STUCK   ? SG_UNRESOLVED
         : end == SG_STOPPED ? SG_RESOLVE_STOPPED
                             : failed(m);
}

static sg_resolved
make(maker *m, const sg_polygon_row *row, size_t rows, sg_resolved_polygon *out)
{
  bool done = true;

  for (size_t i = 0; i < rows && done; i++) {
    done = add_row(m, &row[i]);
  }
  for (int32_t e = 0; (e = sg_work_next(m->work, e));) {
    m->own = e;
  }
  if (!done || (!out->no_area && (!enter_inside(m) || !add_seams(m)))) {
    return failed(m);
  }
  bool *used = calloc((size_t)sg_work_vertices(m->work) + 1, sizeof *used);
  sg_key_table edges;

  if (!used) {
    return SG_RESOLVE_NO_MEMORY;
  }
  sg_key_table_init(&edges, 2);
  sg_resolved end = !keep_edges(m, out, used) ? SG_RESOLVE_NO_MEMORY
                    : out->no_area            ? SG_RESOLVED
                                   : triangulate(m, used, &edges, out);

  sg_key_table_clear(&edges);
  free(used);
  return end;
}

sg_resolved
sg_resolve_polygon(const sg_resolve *r, const sg_polygon_row *row, size_t rows,
                   sg_work *work, sg_resolved_polygon *out,
                   const sg_cancel *cancel)
{
  maker m = {.r = r, .s = out->s, .p = out->p, .work = work, .cancel = cancel};
  sg_resolved end = make(&m, row, rows, out);

  sg_meetings_clear(&m.met);
  return end;
}
