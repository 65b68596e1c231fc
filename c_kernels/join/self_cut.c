/* self_cut.c -- the join of a segment with itself (self_cut.h). */
#include "self_cut.h"

#include "engine/list.h"
#include "engine/search.h"
#include "polygon/flatness.h"
#include "rows/places.h"
#include "self_join.h"

#include <stdlib.h>
#include <string.h>

enum {
  BLOCK = 2048,     /* candidates in a task */
  MARKED = 1 << 15, /* triangles in one */
  FEW = 8 /* if no more than this part is changed, what is near is looked for */
};

/* A meeting, and what it says about the one across the edge. */
typedef struct found {
  sg_self_meeting meeting;
  sg_self_edge edge;
} found;

typedef struct block {
  found *item;
  size_t n, room;
  bool failed; /* no memory */
} block;

typedef struct joiner {
  sg_self_model model;
  int32_t first;    /* triangle */
  size_t triangles; /* that are asked */
  uint32_t *some;   /* [triangles]: these, from the first; null: all */
  uint32_t *place;
  const unsigned char *changed; /* [triangles], or null */
  unsigned char *own_changed;   /* the same, of some; or null */
  bool in_faces;
  sg_bvh_hits hits;
  block *block;
  size_t blocks;
} joiner;

/* ---- candidates --------------------------------------------------------- */

/* The place of what is asked as number i. */
static int32_t
triangle_at(const joiner *j, uint32_t i)
{
  return j->first + (int32_t)(j->some ? j->some[i] : i);
}

static void
read_triangle(const void *data, uint32_t i, sg_fan_triangle *out)
{
  const joiner *j = data;

  sg_self_read_triangle(&j->model, triangle_at(j, i), out);
}

/* Most boxes that overlap are those of neighbours that have nothing else in
 * common. */
static bool
may_meet(void *data, const sg_fan_triangle *a, const sg_fan_triangle *b)
{
  sg_self_two two;

  (void)data;
  sg_self_two_of(a, b, &two);
  return sg_self_may_meet(&two);
}

static bool
find_candidates(joiner *j, sg_pool *pool, const sg_cancel *cancel)
{
  const sg_self_joining joining = {.n = j->triangles,
                                   .read = read_triangle,
                                   .wants = may_meet,
                                   .data = j,
                                   .in_polygons = true,
                                   .in_faces = j->in_faces,
                                   .changed = j->changed};

  return sg_self_join(&joining, pool, cancel, &j->hits);
}

static void
keep(block *b, const found *item)
{
  if (!sg_list_grow(&b->item, b->n, &b->room, sizeof *b->item)) {
    b->failed = true;
    return;
  }
  b->item[b->n++] = *item;
}

static void
test_block(void *data, size_t task)
{
  joiner *j = data;
  size_t end = (task + 1) * BLOCK;
  block *b = &j->block[task];

  end = end < j->hits.n ? end : j->hits.n;
  for (size_t i = task * BLOCK; i < end && !b->failed; i++) {
    found item;

    item.meeting.t[0] = triangle_at(j, j->hits.hit[i].a);
    item.meeting.t[1] = triangle_at(j, j->hits.hit[i].b);
    if (sg_self_pair(&j->model, item.meeting.t[0], item.meeting.t[1],
                     &item.meeting, &item.edge)) {
      keep(b, &item);
    }
    if (i % 256 == 0 && sg_pool_stopping()) {
      return;
    }
  }
}

static bool
test_candidates(joiner *j, sg_pool *pool, const sg_cancel *cancel)
{
  j->blocks = (j->hits.n + BLOCK - 1) / BLOCK;
  j->block = calloc(j->blocks + 1, sizeof *j->block);
  if (!j->block || !sg_pool_run(pool, j->blocks, test_block, j, cancel)) {
    return false;
  }
  for (size_t i = 0; i < j->blocks; i++) {
    if (j->block[i].failed) {
      return false;
    }
  }
  return true;
}

/* ---- together ----------------------------------------------------------- */

SG_ORDER(by_edge, found, SG_BY(edge.face) SG_BY(edge.u) SG_BY(edge.w));

SG_ORDER(by_triangles, found, SG_BY(meeting.t[0]) SG_BY(meeting.t[1]));

/* An edge that lies in a face, its triangles on both sides, goes through. The
 * items are in the order of by_edge(). */
static void
go_through(found *item, size_t n)
{
  for (size_t i = 0, end; i < n; i = end) {
    bool above = false, below = false;

    for (end = i; end < n && by_edge(&item[i], &item[end]) == 0; end++) {
      above |= item[end].edge.side > 0;
      below |= item[end].edge.side < 0;
    }
    for (size_t k = i; k < end && above && below; k++) {
      item[k].meeting.kind = SG_SELF_PENETRATION;
    }
  }
}

static void
name_polygons(const sg_dense *d, sg_self_meeting *m)
{
  int32_t p = d->polygon_id[d->polygon_of[m->t[0]]];
  int32_t q = d->polygon_id[d->polygon_of[m->t[1]]];

  m->p[0] = p < q ? p : q;
  m->p[1] = p < q ? q : p;
}

static bool
gather(joiner *j, sg_self_meetings *out)
{
  size_t n = 0;

  for (size_t i = 0; i < j->blocks; i++) {
    n += j->block[i].n;
  }
  found *all = malloc((n + 1) * sizeof *all);

  out->item = malloc((n + 1) * sizeof *out->item);
  if (!all || !out->item) {
    free(all);
    free(out->item);
    out->item = NULL;
    return false;
  }
  n = 0;
  for (size_t i = 0; i < j->blocks; i++) {
    if (j->block[i].n > 0) {
      memcpy(all + n, j->block[i].item, j->block[i].n * sizeof *all);
      n += j->block[i].n;
    }
  }
  qsort(all, n, sizeof *all, by_edge);
  go_through(all, n);
  qsort(all, n, sizeof *all, by_triangles);
  for (size_t i = 0; i < n; i++) {
    out->item[i] = all[i].meeting;
    name_polygons(j->model.d, &out->item[i]);
  }
  out->n = n;
  free(all);
  return true;
}

static void
clear(joiner *j)
{
  for (size_t i = 0; j->block && i < j->blocks; i++) {
    free(j->block[i].item);
  }
  free(j->block);
  free(j->hits.hit);
  free(j->place);
  free(j->some);
  free(j->own_changed);
}

/* ---- places ---- */

/* The vertices of some triangles, ascending. Null: no memory. */
static int32_t *
vertices_of_some(const joiner *j, size_t *n)
{
  int32_t *v = malloc((3 * j->triangles + 1) * sizeof *v);

  for (size_t i = 0; v && i < j->triangles; i++) {
    memcpy(v + 3 * i, j->model.d->corner[triangle_at(j, (uint32_t)i)],
           3 * sizeof *v);
  }
  *n = v ? sg_sort_ids(v, 3 * j->triangles) : 0;
  return v;
}

/* The places of these; those of others are not there. */
static uint32_t *
places_of_some(const joiner *j, size_t vertices, const sg_cancel *cancel)
{
  size_t n;
  int32_t *v = vertices_of_some(j, &n);
  double(*at)[3] = malloc((n + 1) * sizeof *at);
  uint32_t *place = malloc((vertices + 1) * sizeof *place), *first = NULL;

  if (v && at && place) {
    for (size_t i = 0; i < n; i++) {
      memcpy(at[i], j->model.d->at[v[i]], sizeof *at);
    }
    first = sg_places_of((const double(*)[3])at, n, cancel);
  }
  for (size_t i = 0; first && i < n; i++) {
    place[(uint32_t)v[i] - j->model.first] =
        (uint32_t)v[first[i]] - j->model.first;
  }
  if (!first) {
    free(place);
    place = NULL;
  }
  free(first);
  free(at);
  free(v);
  return place;
}

static bool
find_places(joiner *j, size_t vertices, const sg_cancel *cancel)
{
  const double(*at)[3] = (const double(*)[3])j->model.d->at + j->model.first;

  j->model.place = j->place = j->own_changed
                                  ? places_of_some(j, vertices, cancel)
                                  : sg_places_of(at, vertices, cancel);
  return j->place != NULL;
}

/* ---- what is asked ---- */

/* How many triangles are changed. */
static size_t
changed_of(const joiner *j)
{
  size_t n = 0;

  for (size_t i = 0; i < j->triangles; i++) {
    n += !j->changed || j->changed[i];
  }
  return n;
}

/* Leaves triangles of some polygons out. False: no memory. */
static bool
leave_out(joiner *j, size_t s, const unsigned char *left_out)
{
  const sg_dense *d = j->model.d;
  size_t n = 0;

  if (!left_out) {
    return true;
  }
  if (!(j->some = malloc((j->triangles + 1) * sizeof *j->some))) {
    return false;
  }
  for (uint32_t i = 0; i < j->triangles; i++) {
    uint32_t p = (uint32_t)d->polygon_of[(uint32_t)j->first + i];

    if (!left_out[p - d->polygon_begin[s]]) {
      j->some[n++] = i;
    }
  }
  j->triangles = n;
  return true;
}

static sg_box
box_of(const joiner *j, uint32_t i)
{
  const sg_dense *d = j->model.d;
  const int32_t *corner = d->corner[j->first + (int32_t)i];
  sg_box box = sg_box_none();

  for (int k = 0; k < 3; k++) {
    sg_box_add(&box, d->at[corner[k]]);
  }
  return box;
}

/* A tree of the boxes of the n changed ones. Null: no memory, or stopped. */
static sg_bvh *
tree_of_changed(const joiner *j, size_t n, const sg_cancel *cancel)
{
  sg_box *box = malloc((n + 1) * sizeof *box);
  size_t k = 0;

  for (uint32_t i = 0; box && i < j->triangles; i++) {
    if (j->changed[i]) {
      box[k++] = box_of(j, i);
    }
  }
  sg_bvh *tree = box ? sg_bvh_open(box, n, cancel) : NULL;

  free(box);
  return tree;
}

typedef struct marking {
  const joiner *j;
  const sg_bvh *changed;
  unsigned char *near; /* [triangles] */
} marking;

static void
mark_block(void *data, size_t task)
{
  marking *m = data;
  size_t end = (task + 1) * MARKED;

  end = end < m->j->triangles ? end : m->j->triangles;
  for (size_t i = task * MARKED; i < end; i++) {
    sg_box box = box_of(m->j, (uint32_t)i);

    m->near[i] = sg_bvh_meets(m->changed, &box);
  }
}

/* Only these are asked, with what is changed of them. False: no memory. */
static bool
ask_near(joiner *j, const unsigned char *near)
{
  size_t n = 0;

  j->some = malloc((j->triangles + 1) * sizeof *j->some);
  j->own_changed = malloc(j->triangles + 1);
  if (!j->some || !j->own_changed) {
    return false;
  }
  for (uint32_t i = 0; i < j->triangles; i++) {
    if (near[i]) {
      j->own_changed[n] = j->changed[i];
      j->some[n++] = i;
    }
  }
  j->changed = j->own_changed;
  j->triangles = n;
  return true;
}

/* Whole polygons: whether one is flat is asked of all its triangles. False: no
 * memory. */
static bool
mark_polygons(const joiner *j, unsigned char *near)
{
  const int32_t *of = j->model.d->polygon_of + j->first;
  unsigned char *marked = calloc(j->model.d->polygons + 1, 1);

  for (size_t i = 0; marked && i < j->triangles; i++) {
    marked[of[i]] |= near[i];
  }
  for (size_t i = 0; marked && i < j->triangles; i++) {
    near[i] = marked[of[i]];
  }
  free(marked);
  return marked != NULL;
}

/* If few triangles, n, are changed, only these meet others, and what their
 * boxes do not overlap meets none of them. False: no memory, or stopped. */
static bool
leave_far_out(joiner *j, size_t n, sg_pool *pool, const sg_cancel *cancel)
{
  if (n > j->triangles / FEW) {
    return true;
  }
  sg_bvh *changed = tree_of_changed(j, n, cancel);
  marking m = {j, changed, malloc(j->triangles + 1)};
  bool good = changed && m.near &&
              sg_pool_run(pool, (j->triangles + MARKED - 1) / MARKED,
                          mark_block, &m, cancel) &&
              mark_polygons(j, m.near) && ask_near(j, m.near);

  free(m.near);
  sg_bvh_close(changed);
  return good;
}

static bool
cut(joiner *j, size_t s, sg_pool *pool, const sg_cancel *cancel,
    sg_self_meetings *out)
{
  const sg_dense *d = j->model.d;
  size_t vertices = d->vertex_begin[s + 1] - d->vertex_begin[s];

  *out = (sg_self_meetings){0};
  size_t changed = changed_of(j);
  bool done =
      changed == 0 ||
      (leave_far_out(j, changed, pool, cancel) &&
       find_places(j, vertices, cancel) && find_candidates(j, pool, cancel) &&
       test_candidates(j, pool, cancel) && gather(j, out));

  clear(j);
  return done;
}

static joiner
joiner_of(const sg_dense *d, size_t s, double tolerance)
{
  return (joiner){.model = {d, d->vertex_begin[s], NULL, tolerance},
                  .first = (int32_t)d->triangle_begin[s],
                  .triangles = d->triangle_begin[s + 1] - d->triangle_begin[s]};
}

bool
sg_self_cut(const sg_dense *dense, size_t s, double tolerance, sg_pool *pool,
            const sg_cancel *cancel, sg_self_meetings *out)
{
  return sg_self_cut_some(dense, s, NULL, tolerance, pool, cancel, out);
}

bool
sg_self_cut_changed(const sg_dense *dense, size_t s,
                    const unsigned char *changed, bool in_faces,
                    double tolerance, sg_pool *pool, const sg_cancel *cancel,
                    sg_self_meetings *out)
{
  joiner j = joiner_of(dense, s, tolerance);

  j.changed = changed;
  j.in_faces = in_faces;
  return cut(&j, s, pool, cancel, out);
}

bool
sg_self_cut_some(const sg_dense *dense, size_t s, const unsigned char *left_out,
                 double tolerance, sg_pool *pool, const sg_cancel *cancel,
                 sg_self_meetings *out)
{
  joiner j = joiner_of(dense, s, tolerance);

  *out = (sg_self_meetings){0};
  return leave_out(&j, s, left_out) && cut(&j, s, pool, cancel, out);
}

/* ---- of polygons -------------------------------------------------------- */

SG_ORDER(by_polygons, sg_self_meeting,
         SG_BY(p[0]) SG_BY(p[1]) SG_BY(kind) SG_BY(t[0]) SG_BY(t[1]));

void
sg_self_by_polygon(sg_self_meetings *meetings)
{
  sg_self_meeting *item = meetings->item;
  size_t kept = 0;

  if (meetings->n > 0) {
    qsort(item, meetings->n, sizeof *item, by_polygons);
  }
  for (size_t i = 0; i < meetings->n; i++) {
    if (kept == 0 || item[i].p[0] != item[kept - 1].p[0] ||
        item[i].p[1] != item[kept - 1].p[1]) {
      item[kept++] = item[i];
    }
  }
  meetings->n = kept;
}

double
sg_self_tolerance(const sg_dense *dense, size_t s)
{
  sg_flatness flatness;

  sg_flatness_init(&flatness, dense->grain[s]);
  for (size_t v = dense->vertex_begin[s]; v < dense->vertex_begin[s + 1]; v++) {
    sg_flatness_see(&flatness, dense->at[v]);
  }
  return flatness.any ? sg_flatness_flat(&flatness) : 0;
}
