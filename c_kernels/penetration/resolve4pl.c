/* resolve4pl.c -- what touches but for rounding, as predicates.
 *
 * Layer: glue. The doors are documented in rules/kernel/penetration.pl.
 */
#include "resolve4pl.h"

#include "glue.h"
#include "polygon/flatness.h"
#include "polygon/plane.h"
#include "rows/grain_rows.h"

#include "engine/install.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  ASKED = 1 << 14, /* pairs between questions */
  FEW = 1 << 10    /* polygons, or rows looked up */
};

static functor_t functor_minus2, functor_w4, functor_t3, functor_near1;

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

  double x = handle->own[sg_cut_place_of(handle, t[a].s)];
  double y = handle->own[sg_cut_place_of(handle, t[b].s)];

  job->r.rounded = fmax(x, y);
  if (handle->by_own) {
    job->r.here = fmin(job->r.reach, job->r.rounded);
  }
}

typedef bool use_pair(sg_resolve *r, const sg_resolve_leaf *a,
                      const sg_resolve_leaf *b);

/* Two triangles that touch exactly, and no more: see cut_twin.h. */
static bool
use_quiet(sg_resolve *r, const sg_resolve_leaf *a, const sg_resolve_leaf *b)
{
  return sg_resolve_touch_exactly(r, a->s, b->s);
}

/* use_pair of all, but `quiet` of those that are. */
static int
each_pair_ex(sg_resolving *job, use_pair *use, use_pair *quiet)
{
  const sg_cut_handle *handle = job->handle;
  sg_resolve_leaf leaf[2];

  for (size_t i = 0; i < handle->curve_candidates; i++) {
    if (i % ASKED == ASKED - 1 && PL_handle_signals() < 0) {
      return FALSE;
    }
    get_leaf(job, handle->candidate[i][0], &leaf[0]);
    get_leaf(job, handle->candidate[i][1], &leaf[1]);
    if (leaf[0].s != leaf[1].s) {
      set_reach(job, leaf[0].triangle, leaf[1].triangle);
      if (!(handle->quiet[i] ? quiet : use)(&job->r, &leaf[0], &leaf[1])) {
        return sg_no_memory();
      }
    }
  }
  return TRUE;
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
static int
each_crossing_ex(sg_resolving *job)
{
  const sg_cut_handle *handle = job->handle;
  chains chain = {0};
  bool good = chain_crossings(job, &chain), stopped = false;

  for (size_t i = 0; i < 2 * handle->curve_candidates && good; i++) {
    if (i % ASKED == ASKED - 1 && PL_handle_signals() < 0) {
      stopped = true;
      break;
    }
    const uint32_t *pair = handle->candidate[i / 2];
    uint32_t k = chain.first[pair[i % 2]];
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
  return !stopped && (good || sg_no_memory());
}

/* ---- polygons ---- */

int
sg_resolving_goes_on_ex(size_t i)
{
  return i % FEW != FEW - 1 || PL_handle_signals() >= 0;
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
static int
make_polygons_ex(sg_resolving *job, const sg_resolved_polygon **stuck)
{
  const sg_version *version = job->handle->version;
  sg_resolved end = SG_RESOLVED;

  for (size_t i = 0; i < job->polygon.n && end == SG_RESOLVED; i++) {
    sg_resolved_polygon *polygon = &job->polygon.item[i];
    double normal[3];
    size_t n;

    if (!sg_resolving_goes_on_ex(i)) {
      return FALSE;
    }
    int32_t s = sg_resolving_segment(job, polygon->s);
    sg_polygon_row *rows = get_rows(version, s, polygon->p, &n);

    bool area = get_normal(version, s, polygon->p, normal);
    polygon->no_area = !area;
    end = rows ? sg_resolve_polygon(&job->r, normal, rows, n, polygon,
                                    &sg_prolog_poll)
               : SG_RESOLVE_NO_MEMORY;
    free(rows);
    *stuck = end == SG_UNRESOLVED ? polygon : NULL;
  }
  if (end == SG_RESOLVED) {
    end = sg_resolve_match(&job->r, job->polygon.item, job->polygon.n,
                           &sg_prolog_poll);
  }
  return end == SG_RESOLVE_NO_MEMORY ? sg_no_memory()
                                     : end != SG_RESOLVE_STOPPED;
}

static int
name_places_ex(sg_resolving *job)
{
  for (size_t i = 0; i < job->r.place.n; i++) {
    sg_resolve_place *place = &job->r.place.item[i];
    uint32_t key = (uint32_t)sg_resolving_segment(job, place->s);

    if (place->name == 0) {
      uint32_t *next = sg_key_table_put(&job->handle->next_name, &key);
      if (!next || *next == SG_NO_KEY) {
        return sg_no_memory();
      }
      place->name = (int32_t)(*next)++;
    }
  }
  return TRUE;
}

/* ---- as terms ---- */

/* near(v(S, V)) or near(ll(S1-(A,B), S2-(C,D))). */
static int
put_origin(term_t t, const sg_resolve_node *node)
{
  if (node->v) {
    return PL_unify_term(t, PL_FUNCTOR, functor_near1, PL_FUNCTOR_CHARS, "v", 2,
                         PL_INT, node->s, PL_INT, node->v);
  }
  return PL_unify_term(t, PL_FUNCTOR, functor_near1, PL_FUNCTOR_CHARS, "ll", 2,
                       PL_FUNCTOR, functor_minus2, PL_INT, node->line[0][0],
                       PL_FUNCTOR_CHARS, ",", 2, PL_INT, node->line[0][1],
                       PL_INT, node->line[0][2], PL_FUNCTOR, functor_minus2,
                       PL_INT, node->line[1][0], PL_FUNCTOR_CHARS, ",", 2,
                       PL_INT, node->line[1][1], PL_INT, node->line[1][2]);
}

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

static int
unify_vertices(sg_resolving *job, term_t list)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t origin = PL_new_term_ref();

  for (size_t i = 0; i < job->r.place.n; i++) {
    const sg_resolve_place *place = &job->r.place.item[i];
    const sg_resolve_point *point = &job->r.point.item[place->point];

    if (!sg_resolving_goes_on_ex(i)) {
      return FALSE;
    }
    if (!sg_resolving_changes(job, place)) {
      continue;
    }
    PL_put_variable(origin);
    if (!put_origin(origin, &job->r.node.item[point->node]) ||
        !PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR_CHARS, "vertex", 6, PL_INT, place->s,
                       PL_INT, place->name, PL_FLOAT, point->at[0] + 0.0,
                       PL_FLOAT, point->at[1] + 0.0, PL_FLOAT,
                       point->at[2] + 0.0, PL_TERM, origin)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static int
unify_edges(const sg_resolved_polygon *polygon, term_t list)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < polygon->edge.n; i++) {
    const sg_resolved_edge *edge = &polygon->edge.item[i];
    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR, functor_w4, PL_INT, edge->v[0], PL_INT,
                       edge->v[1], PL_INT, edge->et, PL_INT, edge->label)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static int
unify_triangles(const sg_resolved_polygon *polygon, term_t list)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < polygon->triangle.n; i++) {
    const int32_t *v = polygon->triangle.item[i].v;
    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR, functor_t3, PL_INT, v[0], PL_INT, v[1],
                       PL_INT, v[2])) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static int
unify_polygons(sg_resolving *job, term_t list)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < job->polygon.n; i++) {
    const sg_resolved_polygon *polygon = &job->polygon.item[i];
    if (!sg_resolving_goes_on_ex(i)) {
      return FALSE;
    }
    fid_t frame = PL_open_foreign_frame();
    term_t edges = PL_new_term_ref(), triangles = PL_new_term_ref();
    int good =
        unify_edges(polygon, edges) && unify_triangles(polygon, triangles) &&
        PL_unify_list(tail, head, tail) &&
        PL_unify_term(head, PL_FUNCTOR_CHARS, "polygon", 4, PL_INT, polygon->s,
                      PL_INT, polygon->p, PL_TERM, edges, PL_TERM, triangles);
    PL_close_foreign_frame(frame);
    if (!good) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* Name(S, Id) */
static int
unify_place(term_t t, const char *name, int32_t s, int32_t id)
{
  return PL_unify_term(t, PL_FUNCTOR_CHARS, name, 2, PL_INT, s, PL_INT, id);
}

/* ---- the door ---- */

static int
finish_ex(sg_resolving *job)
{
  sg_resolved end = sg_resolve_finish(&job->r);

  return end == SG_RESOLVED || (end == SG_RESOLVE_NO_MEMORY && sg_no_memory());
}

/* All that must change; nothing if everything touches exactly. *wide, *stuck:
 * why it cannot be done. */
static int
resolve_ex(sg_resolving *job, const sg_resolved_polygon **stuck)
{
  if (!sg_cut_join_ex(job->handle) || !sg_cut_quiet_ex(job->handle) ||
      !sg_resolving_bodies_ex(job) ||
      !each_pair_ex(job, sg_resolve_see, use_quiet)) {
    return FALSE;
  }
  if (!sg_resolve_is_needed(&job->r)) {
    return TRUE;
  }
  int done = each_pair_ex(job, sg_resolve_pair, sg_resolve_pair) &&
             each_crossing_ex(job) && finish_ex(job) && name_places_ex(job) &&
             (job->r.wide ||
              (sg_resolving_want_ex(job) && make_polygons_ex(job, stuck)));

  sg_resolving_name_segments(job);
  return done && (job->r.wide || *stuck || sg_resolving_measure_ex(job));
}

/* vertices, polygons: lists, or why not, as cut_resolve/4 says. */
static int
unify_result(sg_resolving *job, const sg_resolved_polygon *stuck,
             term_t vertices, term_t polygons)
{
  const sg_resolve_node *wide = job->r.wide;

  return wide ? unify_place(vertices, "wide", wide->s, wide->v)
         : stuck
             ? unify_place(vertices, "stuck", stuck->s, stuck->p)
             : unify_vertices(job, vertices) && unify_polygons(job, polygons);
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

/* Writes what changes; what: `changed` or `same`, or why not. */
static int
write_result_ex(sg_resolving *job, const sg_resolved_polygon *stuck,
                term_t what)
{
  const sg_resolve_node *wide = job->r.wide;

  if (wide || stuck) {
    return wide ? unify_place(what, "wide", wide->s, wide->v)
                : unify_place(what, "stuck", stuck->s, stuck->p);
  }
  if (!changes_any(job)) {
    return PL_unify_atom_chars(what, "same");
  }
  return sg_resolving_write_ex(job) && PL_unify_atom_chars(what, "changed");
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
    handle->own[i] = sg_flatness_touch(&flatness);
  }
  return handle->own != NULL;
}

static int
open_ex(sg_resolving *job, term_t set, term_t reach)
{
  double r;

  if (!sg_get_cut_set_ex(set, &job->handle) || !sg_get_finite_ex(reach, &r)) {
    return FALSE;
  }
  if (!(r > 0)) {
    return PL_domain_error("positive", reach);
  }
  if (!find_own(job->handle)) {
    return sg_no_memory();
  }
  if (!job->handle->joined) {
    job->handle->reach = r;
  }
  sg_resolve_init(&job->r, r, sg_cut_is_real, job->handle, &sg_prolog_poll);
  sg_key_table_init(&job->known, 2);
  return TRUE;
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

/* cut_resolve(+Set, +Reach, -Vertices, -Polygons) is det. */
static foreign_t
cut_resolve(term_t set, term_t reach, term_t vertices, term_t polygons)
{
  sg_resolving job = {0};
  const sg_resolved_polygon *stuck = NULL;

  if (!open_ex(&job, set, reach)) {
    return FALSE;
  }
  int done =
      resolve_ex(&job, &stuck) && unify_result(&job, stuck, vertices, polygons);

  clear(&job);
  return done;
}

/* cut_touch(+Set, +Reach, -What, -Moves) is det. */
static foreign_t
cut_touch(term_t set, term_t reach, term_t what, term_t moves)
{
  sg_resolving job = {0};
  const sg_resolved_polygon *stuck = NULL;

  if (!open_ex(&job, set, reach)) {
    return FALSE;
  }
  int done = resolve_ex(&job, &stuck) && write_result_ex(&job, stuck, what) &&
             sg_resolving_unify_moves(&job, moves);

  clear(&job);
  return done;
}

/* cut_own_tolerances(+Set) is det. */
static foreign_t
cut_own_tolerances(term_t set)
{
  sg_cut_handle *handle;

  if (!sg_get_cut_set_ex(set, &handle)) {
    return FALSE;
  }
  handle->by_own = true;
  return TRUE;
}

void
sg_install_resolve(void)
{
  static const PL_extension doors[] = {
      {"cut_resolve", 4, (pl_function_t)cut_resolve, 0},
      {"cut_own_tolerances", 1, (pl_function_t)cut_own_tolerances, 0},
      {"cut_touch", 4, (pl_function_t)cut_touch, 0},
      {NULL, 0, NULL, 0}};

  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  functor_w4 = PL_new_functor(PL_new_atom("w"), 4);
  functor_t3 = PL_new_functor(PL_new_atom("t"), 3);
  functor_near1 = PL_new_functor(PL_new_atom("near"), 1);
  PL_register_extensions_in_module("sg_kernel_penetration", doors);
}
