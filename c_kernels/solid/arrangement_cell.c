/* arrangement_cell.c -- the cells of polygons that are cut: see arrangement.h.
 *
 * Layer: kernel. Each polygon is a task, which only reads the arrangement; then
 * its cells are put there, in the order of polygons.
 */
#include "arrangement_private.h"

#include "engine/list.h"
#include "polygon/delaunay.h"
#include "rows/disjoint.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum {
  FEW = 12,     /* triangles of most polygons that are cut */
  OUTLINES = 16 /* of a task */
};

/* What a polygon became. */
typedef struct divided {
  sg_outcome outcome;
  int32_t stuck;
  int axis;                   /* along which it is seen */
  sg_cell_triangle *triangle; /* [triangles]: cell by cell */
  size_t triangles;
  uint32_t *end; /* [cells]: behind the triangles of a cell */
  size_t cells;
} divided;

typedef struct dividing {
  sg_arrangement *a;
  const sg_entered *polygon;   /* [n], or null: */
  const sg_outlines *outlines; /* [n], to be entered */
  double reach;
  divided *out;        /* [n] */
  atomic_bool refused; /* an outline that is not free */
} dividing;

/* A polygon that is being divided. */
typedef struct taking {
  const sg_arrangement *a;
  uint32_t leaf;
  sg_work *work;
  sg_work_edge *edge; /* [edges]: as they were */
  size_t edges;
  sg_key_table auxiliary; /* two names: an edge that is no line */
  sg_key_table border;    /* two names, the lower first: a real edge */
  sg_triangles found;
  uint32_t *cell; /* [found.n]: which of the cells, by union */
} taking;

static void
taking_clear(taking *k)
{
  free(k->edge);
  free(k->found.item);
  free(k->cell);
  sg_key_table_clear(&k->auxiliary);
  sg_key_table_clear(&k->border);
}

static void
border_key(int32_t v1, int32_t v2, uint32_t key[2])
{
  key[0] = (uint32_t)(v1 < v2 ? v1 : v2);
  key[1] = (uint32_t)(v1 < v2 ? v2 : v1);
}

static bool
copy_edges(taking *k)
{
  sg_key_table_init(&k->auxiliary, 2);
  sg_key_table_init(&k->border, 2);
  k->edge = malloc((sg_work_edges(k->work) + 1) * sizeof *k->edge);
  for (int32_t e = 0; k->edge && (e = sg_work_next(k->work, e));) {
    const sg_work_edge *edge = sg_work_get(k->work, e);
    int32_t v1 = sg_work_id(k->work, edge->start);
    int32_t v2 = sg_work_id(k->work, edge->end);
    uint32_t key[2];
    bool fold = edge->et == 0 && edge->label == 0;
    bool line = edge->et != 0 || sg_arrangement_is_line(k->a, k->leaf, v1, v2);

    k->edge[k->edges++] = *edge;
    border_key(v1, v2, key);
    if (line && (edge->et != 0 || fold) && !sg_key_table_add(&k->border, key)) {
      return false;
    }
    if (!line && !fold &&
        !sg_key_table_add(&k->auxiliary,
                          (uint32_t[2]){(uint32_t)v1, (uint32_t)v2})) {
      return false;
    }
  }
  return k->edge != NULL;
}

static bool
restore_edges(taking *k)
{
  for (int32_t e; (e = sg_work_next(k->work, 0));) {
    sg_work_delete(k->work, e);
  }
  for (size_t i = 0; i < k->edges; i++) {
    const sg_work_edge *edge = &k->edge[i];

    if (!sg_work_add(k->work, edge->start, edge->end, edge->et, edge->label)) {
      return false;
    }
  }
  k->found.n = 0;
  return true;
}

/* A polygon that touches itself is stuck until what touches is one vertex:
 * first what does so exactly, then within the reach. */
static sg_outcome
triangulate(taking *k, double reach, int32_t *edge, const sg_cancel *cancel)
{
  double reaches[2] = {0, reach};
  int32_t stuck = 0;
  sg_outcome outcome = sg_work_triangulate(k->work, &k->found, &stuck, cancel);

  for (int i = 0; i < 2 && outcome == SG_STUCK; i++) {
    outcome = restore_edges(k)
                  ? sg_work_resolve_asking(k->work, reaches[i], cancel)
                  : SG_NO_SPACE;
    if (outcome == SG_DONE) {
      outcome = sg_work_triangulate(k->work, &k->found, &stuck, cancel);
    }
  }
  *edge = stuck;
  return outcome;
}

/* ---- vertices in the middle ---- */

/* Makes vertex v of the leaf a corner, unless it is one. */
static bool
insert_corner(taking *k, sg_key_table *corners, uint32_t number)
{
  const sg_leaf_vertex *vertex = &k->a->leaves.set->model.vertex[number];
  uint32_t key = (uint32_t)vertex->v;
  sg_point at;

  if (sg_key_table_get(corners, &key) != SG_NO_KEY) {
    return true;
  }
  sg_point_set(&at, vertex->at);
  int32_t handle = sg_work_vertex(k->work, vertex->v, &at);

  return handle != SG_WORK_NONE && sg_key_table_add(corners, &key) &&
         sg_triangles_insert(k->work, &k->found, handle);
}

/* The corners there are: those of the edges as they came, too. */
static bool
list_corners(const taking *k, sg_key_table *corners)
{
  for (size_t i = 0; i < 2 * k->edges; i++) {
    const sg_work_edge *edge = &k->edge[i / 2];
    uint32_t key =
        (uint32_t)sg_work_id(k->work, i % 2 ? edge->end : edge->start);

    if (!sg_key_table_add(corners, &key)) {
      return false;
    }
  }
  for (size_t i = 0; i < 3 * k->found.n; i++) {
    uint32_t key = (uint32_t)sg_work_id(k->work, k->found.item[i / 3].v[i % 3]);

    if (!sg_key_table_add(corners, &key)) {
      return false;
    }
  }
  return true;
}

static bool
insert_corners(taking *k, sg_key_table *corners, uint32_t last)
{
  const sg_cut_model *model = &k->a->leaves.set->model;

  if (!list_corners(k, corners)) {
    return false;
  }
  for (uint32_t i = last; i != SG_NO_KEY; i = k->a->next_of_polygon[i]) {
    for (int c = 0; c < 3; c++) {
      if (!insert_corner(k, corners, model->triangle[i].v[c])) {
        return false;
      }
    }
  }
  return true;
}

/* A vertex in the middle of the polygon, where another leaf was made to touch
 * it, is a corner of three triangles or more, all of which were asked: it stays
 * one. */
static bool
insert_inside(taking *k, uint32_t last)
{
  const uint32_t *next = k->a->next_of_polygon;
  sg_key_table corners;

  if (next[last] == SG_NO_KEY || next[next[last]] == SG_NO_KEY) {
    return true;
  }
  sg_key_table_init(&corners, 1);
  bool good = insert_corners(k, &corners, last);

  sg_key_table_clear(&corners);
  return good;
}

/* ---- cells ---- */

/* Whether cells end at edge c of triangle i: at a line, or at a real edge,
 * there and back, as others may have where they were made to touch. */
static bool
ends_after(const taking *k, uint32_t i, int c)
{
  const int32_t *v = k->found.item[i].v;
  int32_t v1 = sg_work_id(k->work, v[c]);
  int32_t v2 = sg_work_id(k->work, v[(c + 1) % 3]);
  uint32_t own[2] = {(uint32_t)v1, (uint32_t)v2}, key[2];

  border_key(v1, v2, key);
  return sg_key_table_get(&k->auxiliary, own) != SG_NO_KEY ||
         sg_key_table_get(&k->border, key) != SG_NO_KEY ||
         sg_arrangement_is_line(k->a, k->leaf, v1, v2);
}

/* Of few triangles each is held against each. */
static void
join_few(taking *k)
{
  const sg_triangle *t = k->found.item;

  for (uint32_t i = 0; i < k->found.n; i++) {
    for (uint32_t other = i + 1; other < k->found.n; other++) {
      for (int c = 0; c < 9; c++) {
        int from = c / 3, to = c % 3;

        if (t[i].v[from] == t[other].v[(to + 1) % 3] &&
            t[i].v[(from + 1) % 3] == t[other].v[to] &&
            !ends_after(k, i, from)) {
          sg_disjoint_join(k->cell, i, other);
        }
      }
    }
  }
}

static bool
join_many(taking *k)
{
  sg_key_table at; /* two vertices of an edge -> triangle */
  bool good = true;

  sg_key_table_init(&at, 2);
  for (uint32_t i = 0; i < k->found.n && good; i++) {
    for (int c = 0; c < 3 && good; c++) {
      uint32_t v1 = (uint32_t)k->found.item[i].v[c];
      uint32_t v2 = (uint32_t)k->found.item[i].v[(c + 1) % 3];
      uint32_t key[2] = {v1 < v2 ? v1 : v2, v1 < v2 ? v2 : v1};

      if (ends_after(k, i, c)) {
        continue;
      }
      uint32_t *other = sg_key_table_put(&at, key);

      good = other != NULL;
      if (good && *other == SG_NO_KEY) {
        *other = i;
      } else if (good) {
        sg_disjoint_join(k->cell, i, *other);
      }
    }
  }
  sg_key_table_clear(&at);
  return good;
}

/* Joins triangles of the polygon that have an edge in common at which cells do
 * not end. */
static bool
join_cells(taking *k)
{
  k->cell = malloc((k->found.n + 1) * sizeof *k->cell);
  for (uint32_t i = 0; k->cell && i < k->found.n; i++) {
    k->cell[i] = i;
  }
  if (!k->cell || k->found.n > FEW) {
    return k->cell && join_many(k);
  }
  join_few(k);
  return true;
}

static void
add_triangle(const taking *k, const sg_triangle *found, divided *to)
{
  sg_cell_triangle *out = &to->triangle[to->triangles++];

  *out = (sg_cell_triangle){0};
  for (int c = 0; c < 3; c++) {
    out->v[c] = sg_work_id(k->work, found->v[c]);
  }
  for (int c = 0; c < 3; c++) {
    uint32_t key[2] = {(uint32_t)out->v[c], (uint32_t)out->v[(c + 1) % 3]};

    if (sg_key_table_get(&k->auxiliary, key) != SG_NO_KEY) {
      out->auxiliary |= (uint8_t)(1 << c);
    }
    border_key(out->v[c], out->v[(c + 1) % 3], key);
    if (sg_key_table_get(&k->border, key) == SG_NO_KEY) {
      out->chord |= (uint8_t)(1 << c);
    }
  }
}

/* The cells in the order of their first triangles. */
static bool
list_cells(const taking *k, divided *out)
{
  out->triangle = malloc((k->found.n + 1) * sizeof *out->triangle);
  out->end = malloc((k->found.n + 1) * sizeof *out->end);
  for (uint32_t i = 0; out->triangle && out->end && i < k->found.n; i++) {
    if (k->cell[i] != i) {
      continue;
    }
    for (uint32_t j = i; j < k->found.n; j++) {
      if (sg_disjoint_root(k->cell, j) == i) {
        add_triangle(k, &k->found.item[j], out);
      }
    }
    out->end[out->cells++] = (uint32_t)out->triangles;
  }
  return out->triangle && out->end;
}

static bool
stopping(void *data)
{
  (void)data;
  return sg_pool_stopping();
}

/* Divides polygon p of segment s, as it stands in `work`. */
static void
divide_polygon(const dividing *d, int32_t s, int32_t p, sg_work *work,
               divided *out)
{
  const sg_cancel cancel = {stopping, NULL};
  taking k = {.a = d->a, .leaf = sg_arrangement_leaf(d->a, s), .work = work};
  uint32_t key[2] = {k.leaf, (uint32_t)p};
  uint32_t last = sg_key_table_get(&d->a->has_triangles, key);

  out->axis = sg_work_axis(work);
  if (k.leaf == SG_NO_KEY || !d->a->leaf[k.leaf].wanted || last == SG_NO_KEY) {
    return;
  }
  out->outcome = copy_edges(&k)
                     ? triangulate(&k, d->reach, &out->stuck, &cancel)
                     : SG_NO_SPACE;
  if (out->outcome == SG_DONE &&
      (!insert_inside(&k, last) || !join_cells(&k) || !list_cells(&k, out))) {
    out->outcome = SG_NO_SPACE;
  }
  taking_clear(&k);
}

static void
divide(void *data, size_t task)
{
  const dividing *d = data;
  const sg_entered *polygon = &d->polygon[task];

  divide_polygon(d, polygon->s, polygon->p, polygon->work, &d->out[task]);
}

/* ---- polygons whose lines meet nothing ---- */

/* Enters outline i into `work` and divides it; false: it is not free. */
static bool
enter_and_divide(const dividing *d, size_t i, sg_work *work, sg_meetings *met)
{
  const sg_cut_set *set = d->a->leaves.set;
  const sg_outline *polygon = &d->outlines->polygon[i];
  divided *out = &d->out[i];

  out->outcome = sg_cut_enter_outline(set, d->outlines, i, work);
  if (out->outcome == SG_DONE) {
    int free_of = sg_cut_enter_free(set, work, polygon->s, polygon->p, met);

    out->outcome = free_of < 0    ? SG_NO_SPACE
                   : free_of == 0 ? SG_STUCK
                                  : SG_DONE;
  }
  if (out->outcome == SG_DONE) {
    divide_polygon(d, polygon->s, polygon->p, work, out);
  }
  return out->outcome != SG_STUCK;
}

/* A task is a few outlines, one after another in the same work. */
static void
divide_outlines(void *data, size_t task)
{
  dividing *d = data;
  const sg_outline *polygon = d->outlines->polygon;
  size_t from = task * OUTLINES, to = from + OUTLINES;
  sg_work *work = sg_work_open(polygon[from].normal);
  sg_meetings met = {0};

  for (size_t i = from; i < to && i < d->outlines->n; i++) {
    if (atomic_load(&d->refused) || sg_pool_stopping()) {
      break;
    }
    if (!work) {
      d->out[i].outcome = SG_NO_SPACE;
      continue;
    }
    sg_work_clear(work, polygon[i].normal);
    if (!enter_and_divide(d, i, work, &met)) {
      atomic_store(&d->refused, true);
    }
  }
  sg_meetings_clear(&met);
  sg_work_close(work);
}

/* ---- putting them into the arrangement ---- */

static bool
room_for(sg_arrangement *a, size_t cells, size_t triangles)
{
  return sg_list_need(&a->cell, a->cells + cells, &a->cell_room,
                      sizeof *a->cell) &&
         sg_list_need(&a->triangle, a->triangles + triangles, &a->triangle_room,
                      sizeof *a->triangle);
}

static bool
put_cells(sg_arrangement *a, int32_t s, int32_t p, const divided *from)
{
  if (!room_for(a, from->cells, from->triangles)) {
    return false;
  }
  for (size_t i = 0, begin = 0; i < from->cells; begin = from->end[i++]) {
    uint32_t node = sg_arrangement_new_node(a);

    if (node == SG_NO_KEY) {
      return false;
    }
    a->cell[a->cells++] = (sg_cell){.leaf = sg_arrangement_leaf(a, s),
                                    .p = p,
                                    .axis = from->axis,
                                    .first = a->triangles + begin,
                                    .n = from->end[i] - begin,
                                    .node = node};
  }
  if (from->triangles > 0) {
    memcpy(a->triangle + a->triangles, from->triangle,
           from->triangles * sizeof *from->triangle);
  }
  a->triangles += from->triangles;
  return true;
}

static sg_outcome
put_all(const dividing *d, size_t n, size_t *stuck, int32_t *edge)
{
  for (size_t i = 0; i < n; i++) {
    const divided *one = &d->out[i];
    const sg_outline *outline = d->polygon ? NULL : &d->outlines->polygon[i];

    if (one->outcome != SG_DONE) {
      *stuck = i;
      *edge = one->stuck;
      return one->outcome;
    }
    if (!put_cells(d->a, outline ? outline->s : d->polygon[i].s,
                   outline ? outline->p : d->polygon[i].p, one)) {
      return SG_NO_SPACE;
    }
  }
  return SG_DONE;
}

static void
clear_divided(divided *out, size_t n)
{
  for (size_t i = 0; out && i < n; i++) {
    free(out[i].triangle);
    free(out[i].end);
  }
  free(out);
}

sg_outcome
sg_arrangement_polygons(sg_arrangement *a, const sg_entered *polygon, size_t n,
                        double reach, sg_pool *pool, const sg_cancel *cancel,
                        size_t *stuck, int32_t *edge)
{
  dividing d = {.a = a,
                .polygon = polygon,
                .reach = reach,
                .out = calloc(n + 1, sizeof *d.out)};
  sg_outcome outcome = SG_NO_SPACE;

  if (d.out) {
    outcome = sg_pool_run(pool, n, divide, &d, cancel)
                  ? put_all(&d, n, stuck, edge)
                  : SG_STOPPED;
  }
  clear_divided(d.out, n);
  return outcome;
}

/* Whether all could be divided. */
static bool
all_done(const dividing *d)
{
  for (size_t i = 0; i < d->outlines->n; i++) {
    if (d->out[i].outcome == SG_STUCK) {
      return false;
    }
  }
  return !atomic_load(&d->refused);
}

sg_outcome
sg_arrangement_free_polygons(sg_arrangement *a, const sg_outlines *outlines,
                             double reach, sg_pool *pool,
                             const sg_cancel *cancel)
{
  size_t n = outlines->n, stuck;
  int32_t edge;
  dividing d = {.a = a,
                .outlines = outlines,
                .reach = reach,
                .out = calloc(n + 1, sizeof *d.out)};
  sg_outcome outcome = SG_NO_SPACE;

  if (d.out) {
    outcome = !sg_pool_run(pool, (n + OUTLINES - 1) / OUTLINES, divide_outlines,
                           &d, cancel)
                  ? SG_STOPPED
              : all_done(&d) ? put_all(&d, n, &stuck, &edge)
                             : SG_STUCK;
  }
  clear_divided(d.out, n);
  return outcome;
}
