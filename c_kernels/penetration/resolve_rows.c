/* resolve_rows.c -- what touches up to rounding, as predicates.
 *
 * Layer: rows. The doors are documented in rules/kernel/penetration.pl.
 */
#include "resolve_rows.h"

#include "doors/penetration.h"

#include "polygon/flatness.h"
#include "polygon/plane.h"
#include "rows/grain_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  ASKED = 1 << 14, /* pairs between questions */
  FEW = 1 << 10    /* polygons, or rows looked up */
};

/* ---- pairs ---- */

static void
get_leaf(const sg_resolving *job, uint32_t triangle, sg_resolve_leaf *out)
{
  const sg_cut_model *model = &job->handle->set.model;
  const sg_leaf_triangle *t = &model->triangle[triangle];

  out->triangle = triangle;
  out->p = t->p;
  for (int k = 0; k < 3; k++) {
    out->v[k] = model->vertex[t->v[k]].v;
  }
  out->s = sg_resolving_body(job, t->s, out->v[0]);
  sg_cut_model_corners(model, triangle, out->at);
}

/* How far apart what is to touch may be in these triangles, and what was
 * rounded: the coarser one's segment says it. */
static void
set_reach(sg_resolving *job, uint32_t a, uint32_t b)
{
  const sg_cut_handle *handle = job->handle;
  const sg_leaf_triangle *t = handle->set.model.triangle;

  const sg_cut_own *x = &handle->own[sg_cut_place_of(handle, t[a].s)];
  const sg_cut_own *y = &handle->own[sg_cut_place_of(handle, t[b].s)];

  job->r.rounding = fmax(x->rounding, y->rounding);
  job->r.explained = fmax(x->explained, y->explained);
  if (handle->by_own) {
    job->r.here = fmin(job->r.reach, fmax(x->touch, y->touch));
  }
}

typedef bool use_pair(sg_resolve *r, const sg_resolve_leaf *a,
                      const sg_resolve_leaf *b);

/* Two triangles that touch exactly, and no more: see cut_coincident.h. */
static bool
use_quiet(sg_resolve *r, const sg_resolve_leaf *a, const sg_resolve_leaf *b)
{
  return sg_resolve_touch_exactly(r, a->s, b->s);
}

/* use_pair of all, but `quiet` of those that are. */
static bool
each_pair(sg_call *call, sg_resolving *job, use_pair *use, use_pair *quiet)
{
  const sg_cut_handle *handle = job->handle;
  sg_resolve_leaf leaf[2];

  for (size_t i = 0; i < handle->curve_candidates; i++) {
    if (i % ASKED == ASKED - 1 && sg_cancelled(&call->cancel)) {
      return false;
    }
    if (handle->apart[i] && !handle->quiet[i]) {
      continue;
    }
    get_leaf(job, handle->candidate[i][0], &leaf[0]);
    get_leaf(job, handle->candidate[i][1], &leaf[1]);
    if (leaf[0].s != leaf[1].s) {
      set_reach(job, leaf[0].triangle, leaf[1].triangle);
      if (!(handle->quiet[i] ? quiet : use)(&job->r, &leaf[0], &leaf[1])) {
        return sg_call_no_memory(call);
      }
    }
  }
  return true;
}

/* The crossings found on the triangles: a chain for each triangle. */
typedef struct chains {
  uint32_t *first; /* [triangles]: 2 node + side, SG_NO_KEY: none */
  uint32_t *next;  /* [2 nodes] */
} chains;

static bool
chain_crossings(const sg_resolving *job, chains *out)
{
  size_t triangles = job->handle->set.model.triangles, n = job->r.node.n;

  out->first = malloc((triangles + 1) * sizeof *out->first);
  out->next = malloc((2 * n + 1) * sizeof *out->next);
  if (!out->first || !out->next) {
    return false;
  }
  memset(out->first, 0xff, triangles * sizeof *out->first);
  for (uint32_t i = 0; i < 2 * n; i++) {
    const sg_resolve_node *node = &job->r.node.item[i / 2];
    if (node->v == 0) {
      out->next[i] = out->first[node->leaf[i % 2]];
      out->first[node->leaf[i % 2]] = i;
    }
  }
  return true;
}

/* Crossings of edges against the leaves of third segments, which lie beside
 * the leaves that have them. */
static bool
each_crossing(sg_call *call, sg_resolving *job)
{
  const sg_cut_handle *handle = job->handle;
  chains chain = {0};
  bool good = chain_crossings(job, &chain), stopped = false;

  for (size_t i = 0; i < 2 * handle->curve_candidates && good; i++) {
    if (i % ASKED == ASKED - 1 && sg_cancelled(&call->cancel)) {
      stopped = true;
      break;
    }
    const uint32_t *pair = handle->candidate[i / 2];
    uint32_t k = handle->apart[i / 2] ? SG_NO_KEY : chain.first[pair[i % 2]];
    sg_resolve_leaf leaf;

    if (k != SG_NO_KEY) {
      get_leaf(job, pair[!(i % 2)], &leaf);
      set_reach(job, pair[0], pair[1]);
    }
    for (; k != SG_NO_KEY && good; k = chain.next[k]) {
      good = sg_resolve_crossing(&job->r, k / 2, &leaf);
    }
  }
  free(chain.first);
  free(chain.next);
  return !stopped && (good || sg_call_no_memory(call));
}

/* ---- polygons ---- */

bool
sg_resolving_goes_on(sg_call *call, size_t i)
{
  return i % FEW != FEW - 1 || !sg_cancelled(&call->cancel);
}

static void
get_position(const sg_version *version, int32_t s, int32_t v, double out[3])
{
  sg_row row = sg_version_find(version, SG_V,
                               (sg_value[SG_MAX_COLUMNS]){{.i = s}, {.i = v}});

  for (unsigned c = 0; c < 3; c++) {
    out[c] = sg_version_value(version, SG_V, row, c + 2).f;
  }
}

/* The rows of a polygon's edges: free() them. Null: no memory. */
static sg_polygon_row *
get_rows(const sg_version *version, int32_t s, int32_t p, size_t *n)
{
  sg_row row = sg_version_find(version, SG_P,
                               (sg_value[SG_MAX_COLUMNS]){{.i = s}, {.i = p}});
  const int32_t *list = sg_version_value(version, SG_P, row, 2).list;
  sg_polygon_row *rows = calloc((size_t)list[0] + 1, sizeof *rows);

  *n = (size_t)list[0];
  for (size_t i = 0; rows && i < *n; i++) {
    int32_t e = list[i + 1];
    row = sg_version_find(version, SG_E,
                          (sg_value[SG_MAX_COLUMNS]){{.i = s}, {.i = e}});
    rows[i].e = e;
    rows[i].v[0] = sg_version_value(version, SG_E, row, 2).i;
    rows[i].v[1] = sg_version_value(version, SG_E, row, 3).i;
    rows[i].et = sg_version_value(version, SG_E, row, 4).i;
    for (int k = 0; k < 2; k++) {
      get_position(version, s, rows[i].v[k], rows[i].at[k]);
    }
  }
  return rows;
}

/* False: the polygon has no area, and so no plane. */
static bool
get_normal(const sg_version *version, int32_t s, int32_t p, double out[3])
{
  sg_row plane = sg_version_find(
      version, SG_PLANE, (sg_value[SG_MAX_COLUMNS]){{.i = s}, {.i = p}});

  out[0] = out[1] = 0;
  out[2] = 1;
  for (unsigned c = 0; c < 3 && plane != SG_NO_ROW; c++) {
    out[c] = sg_version_value(version, SG_PLANE, plane, c + 2).f;
  }
  return plane != SG_NO_ROW;
}

/* Makes the polygons. *stuck: the one that cannot be triangulated so. */
static bool
make_polygons(sg_call *call, sg_resolving *job,
              const sg_resolved_polygon **stuck)
{
  const sg_version *version = job->handle->version;
  sg_resolved end = SG_RESOLVED;
  sg_work *work = sg_work_open((const double[3]){0, 0, 1});
  bool goes_on = true;

  for (size_t i = 0; i < job->polygon.n && end == SG_RESOLVED; i++) {
    sg_resolved_polygon *polygon = &job->polygon.item[i];
    double normal[3];
    size_t n;

    if (!(goes_on = sg_resolving_goes_on(call, i))) {
      break;
    }
    int32_t s = sg_resolving_segment(job, polygon->s);
    sg_polygon_row *rows = get_rows(version, s, polygon->p, &n);

    bool area = get_normal(version, s, polygon->p, normal);
    polygon->no_area = !area;
    end = SG_RESOLVE_NO_MEMORY;
    if (rows && work) {
      sg_work_clear(work, normal);
      end = sg_resolve_polygon(&job->r, rows, n, work, polygon, &call->cancel);
    }
    free(rows);
    *stuck = end == SG_UNRESOLVED ? polygon : NULL;
  }
  sg_work_close(work);
  if (!goes_on) {
    return false;
  }
  if (end == SG_RESOLVED) {
    end = sg_resolve_match(&job->r, job->polygon.item, job->polygon.n,
                           &call->cancel);
  }
  return end == SG_RESOLVE_NO_MEMORY ? sg_call_no_memory(call)
                                     : end != SG_RESOLVE_STOPPED;
}

static bool
name_places(sg_call *call, sg_resolving *job)
{
  for (size_t i = 0; i < job->r.place.n; i++) {
    sg_resolve_place *place = &job->r.place.item[i];
    uint32_t key = (uint32_t)sg_resolving_segment(job, place->s);

    if (place->name == 0) {
      uint32_t *next = sg_key_table_put(&job->handle->next_name, &key);
      if (!next || *next == SG_NO_KEY) {
        return sg_call_no_memory(call);
      }
      place->name = (int32_t)(*next)++;
    }
  }
  return true;
}

/* ---- what changes ---- */

bool
sg_resolving_changes(const sg_resolving *job, const sg_resolve_place *place)
{
  const double *to = job->r.point.item[place->point].at;
  double from[3];

  if (place->v == 0) {
    return true;
  }
  get_position(job->handle->version, place->s, place->v, from);
  return memcmp(from, to, sizeof from) != 0;
}

static bool
give_vertices(sg_call *call, const sg_resolving *job, sg_vertex_fact_list *out)
{
  for (size_t i = 0; i < job->r.place.n; i++) {
    const sg_resolve_place *place = &job->r.place.item[i];
    const sg_resolve_point *point = &job->r.point.item[place->point];

    if (!sg_resolving_goes_on(call, i)) {
      return false;
    }
    if (!sg_resolving_changes(job, place)) {
      continue;
    }
    const sg_vertex_fact vertex = {
        .s = place->s,
        .v = place->name,
        .x = point->at[0],
        .y = point->at[1],
        .z = point->at[2],
        .origin = sg_resolving_origin(call, &job->r.node.item[point->node])};

    if (!vertex.origin || !sg_vertex_fact_list_add(call, out, vertex)) {
      return false;
    }
  }
  return true;
}

static bool
give_polygons(sg_call *call, const sg_resolving *job,
              sg_resolved_fact_list *out)
{
  for (size_t i = 0; i < job->polygon.n; i++) {
    const sg_resolved_polygon *polygon = &job->polygon.item[i];
    sg_resolved_fact one = {.s = polygon->s, .p = polygon->p};

    for (size_t k = 0; k < polygon->edge.n; k++) {
      if (!sg_resolved_edge_fact_list_add(call, &one.edges,
                                          polygon->edge.item[k])) {
        return false;
      }
    }
    for (size_t k = 0; k < polygon->triangle.n; k++) {
      if (!sg_corners_list_add(call, &one.triangles,
                               polygon->triangle.item[k])) {
        return false;
      }
    }
    if (!sg_resolving_goes_on(call, i) ||
        !sg_resolved_fact_list_add(call, out, one)) {
      return false;
    }
  }
  return true;
}

/* ---- the door ---- */

static bool
finish(sg_call *call, sg_resolving *job)
{
  sg_resolved end = sg_resolve_finish(&job->r);

  return end == SG_RESOLVED ||
         (end == SG_RESOLVE_NO_MEMORY && sg_call_no_memory(call));
}

/* All that must change; nothing if everything touches exactly. *wide, *stuck:
 * why it cannot be done. */
static bool
resolve(sg_call *call, sg_resolving *job, const sg_resolved_polygon **stuck)
{
  if (!sg_cut_join(call, job->handle) || !sg_cut_quiet(call, job->handle) ||
      !sg_resolving_bodies(call, job) ||
      !each_pair(call, job, sg_resolve_see, use_quiet)) {
    return false;
  }
  if (!sg_resolve_is_needed(&job->r)) {
    return true;
  }
  bool done =
      each_pair(call, job, sg_resolve_seen_pair, sg_resolve_pair) &&
      each_crossing(call, job) && finish(call, job) && name_places(call, job) &&
      (job->r.wide ||
       (sg_resolving_want(call, job) && make_polygons(call, job, stuck)));

  sg_resolving_name_segments(job);
  return done && (job->r.wide || *stuck || sg_resolving_measure(call, job));
}

static bool
changes_any(const sg_resolving *job)
{
  for (size_t i = 0; i < job->r.place.n; i++) {
    if (sg_resolving_changes(job, &job->r.place.item[i])) {
      return true;
    }
  }
  return job->polygon.n > 0;
}

/* What is to be done, or why it cannot be. */
static void
give_result(const sg_resolving *job, const sg_resolved_polygon *stuck,
            sg_resolution *out)
{
  const sg_resolve_node *wide = job->r.wide;

  if (wide) {
    out->is = SG_RESOLUTION_WIDE;
    out->wide.s = wide->s;
    out->wide.v = wide->v;
  } else if (stuck) {
    out->is = SG_RESOLUTION_STUCK;
    out->stuck.s = stuck->s;
    out->stuck.p = stuck->p;
  } else {
    out->is = changes_any(job) ? SG_RESOLUTION_CHANGED : SG_RESOLUTION_SAME;
  }
}

/* How far apart what was one place may be in each segment, by its source. */
static bool
find_own(sg_cut_handle *handle)
{
  if (handle->own) {
    return true;
  }
  handle->own = calloc(handle->segments + 1, sizeof *handle->own);
  for (size_t i = 0; handle->own && i < handle->segments; i++) {
    const sg_box *box = &handle->tree[i]->tree->box;
    sg_flatness flatness;

    sg_flatness_init(&flatness,
                     sg_grain_of(handle->version, handle->segment[i]));
    if (box->lo[0] <= box->hi[0]) {
      sg_flatness_see(&flatness, box->lo);
      sg_flatness_see(&flatness, box->hi);
    }
    handle->own[i] =
        (sg_cut_own){.touch = sg_flatness_touch(&flatness),
                     .rounding = sg_flatness_rounding(&flatness),
                     .explained = sg_flatness_explained(&flatness)};
  }
  return handle->own != NULL;
}

static bool
begin(sg_call *call, sg_resolving *job, sg_cut_handle *handle, double reach)
{
  job->handle = handle;
  if (!(reach > 0)) {
    return sg_call_domain(call, "positive", 2);
  }
  if (!find_own(handle)) {
    return sg_call_no_memory(call);
  }
  if (!handle->joined) {
    handle->reach = reach;
  }
  sg_resolve_init(&job->r, reach, sg_cut_is_real, handle, &call->cancel);
  sg_key_table_init(&job->known, 2);
  return true;
}

static void
clear(sg_resolving *job)
{
  for (size_t i = 0; i < job->polygon.n; i++) {
    sg_resolved_polygon_clear(&job->polygon.item[i]);
  }
  free(job->polygon.item);
  sg_key_table_clear(&job->known);
  sg_resolving_bodies_clear(job);
  sg_resolve_clear(&job->r);
}

bool
sg_door_cut_resolve(sg_call *call, sg_cut_handle *handle, double reach,
                    sg_resolution *what, sg_vertex_fact_list *vertices,
                    sg_resolved_fact_list *polygons)
{
  sg_resolving job = {0};
  const sg_resolved_polygon *stuck = NULL;

  if (!begin(call, &job, handle, reach)) {
    return false;
  }
  bool good = resolve(call, &job, &stuck);

  if (good) {
    give_result(&job, stuck, what);
    good = what->is != SG_RESOLUTION_CHANGED ||
           (give_vertices(call, &job, vertices) &&
            give_polygons(call, &job, polygons));
  }
  clear(&job);
  return good;
}

bool
sg_door_cut_touch(sg_call *call, sg_cut_handle *handle, double reach,
                  sg_resolution *what, sg_touch_moves *moves)
{
  sg_resolving job = {0};
  const sg_resolved_polygon *stuck = NULL;

  if (!begin(call, &job, handle, reach)) {
    return false;
  }
  bool good = resolve(call, &job, &stuck);

  if (good) {
    give_result(&job, stuck, what);
    sg_resolving_moves(&job, moves);
    good = what->is != SG_RESOLUTION_CHANGED || sg_resolving_write(call, &job);
  }
  clear(&job);
  return good;
}

bool
sg_door_cut_own_tolerances(sg_call *call, sg_cut_handle *handle)
{
  (void)call;
  handle->by_own = true;
  return true;
}
