/* resolve_want_rows.c -- which polygons are to be made anew: see
 * resolve_rows.h.
 *
 * Layer: rows.
 */
#include "resolve_rows.h"

#include "engine/search.h"
#include "rows/sort.h"

/* Notes that polygon p of segment s is to be made anew. */
static bool
want_polygon(sg_call *call, sg_resolving *job, int32_t s, int32_t p)
{
  uint32_t *known =
      sg_key_table_put(&job->known, (uint32_t[2]){(uint32_t)s, (uint32_t)p});

  if (!known) {
    return sg_call_no_memory(call);
  }
  if (*known == SG_NO_KEY) {
    *known = 0;
    return SG_PUSH(job->polygon, (sg_resolved_polygon){.s = s, .p = p}) ||
           sg_call_no_memory(call);
  }
  return true;
}

/* The polygons that have one of these edges. */
static bool
want_polygons_of(sg_call *call, sg_resolving *job, int32_t s,
                 const sg_int_list *edges)
{
  sg_walk walk;
  bool good = true;

  if (!sg_index_ready(job->handle->version, SG_P, 0, &call->cancel)) {
    return false;
  }
  if (!sg_walk_open_members(&walk, job->handle->version, SG_P,
                            sg_resolving_segment(job, s), edges->at,
                            edges->n)) {
    return sg_call_no_memory(call);
  }
  for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    int32_t p = sg_version_value(job->handle->version, SG_P, row, 1).i;
    good = want_polygon(call, job, s, p);
  }
  sg_walk_close(&walk);
  return good;
}

/* The edges from v1 to v2. */
static bool
add_edges(sg_call *call, const sg_resolving *job, int32_t s, int32_t v1,
          int32_t v2, sg_int_list *out)
{
  const sg_version *version = job->handle->version;
  const sg_value row[SG_MAX_COLUMNS] = {
      [0].i = sg_resolving_segment(job, s), [2].i = v1, [3].i = v2};
  sg_walk walk;
  bool good = true;

  if (!sg_index_ready(version, SG_E, 0x0d, &call->cancel)) {
    return false;
  }
  if (!sg_walk_open(&walk, version, SG_E, 0x0d, row)) {
    return sg_call_no_memory(call);
  }
  for (sg_row found; good && (found = sg_walk_next(&walk)) != SG_NO_ROW;) {
    good =
        sg_int_list_add(call, out, sg_version_value(version, SG_E, found, 1).i);
  }
  sg_walk_close(&walk);
  return good;
}

/* The polygons on both sides of a divided edge. */
static bool
want_neighbours(sg_call *call, sg_resolving *job, const sg_resolve_split *split)
{
  const int32_t *v = split->v;
  sg_int_list edges = {0};

  return add_edges(call, job, split->s, v[0], v[1], &edges) &&
         add_edges(call, job, split->s, v[1], v[0], &edges) &&
         (edges.n == 0 || want_polygons_of(call, job, split->s, &edges));
}

static bool
sort(sg_call *call, void *item, size_t n, size_t size, sg_sort_compare *compare)
{
  sg_sort_end end = sg_sort(item, n, size, compare, &call->cancel);

  return end == SG_SORTED ||
         (end == SG_SORT_NO_MEMORY && sg_call_no_memory(call));
}

SG_ORDER(by_polygon, sg_resolve_near, SG_BY(s) SG_BY(p) SG_BY(n));

/* Polygons with three points or more may lie on others. */
static bool
want_covered(sg_call *call, sg_resolving *job)
{
  sg_resolve_near *near = job->r.near.item;
  size_t n = job->r.near.n;
  bool good = sort(call, near, n, sizeof *near, by_polygon);

  for (size_t i = 0, first = 0; i < n && good; i++) {
    if (near[i].s != near[first].s || near[i].p != near[first].p) {
      first = i;
    }
    if (i == first + 2) {
      good = want_polygon(call, job, near[i].s, near[i].p);
    }
  }
  return good;
}

SG_ORDER(compare_results, sg_resolved_polygon, SG_BY(s) SG_BY(p));

bool
sg_resolving_want(sg_call *call, sg_resolving *job)
{
  const sg_resolve *r = &job->r;
  bool good = want_covered(call, job);

  for (size_t i = 0; i < r->split.n && good; i++) {
    good = !sg_cancelled(&call->cancel) && /* it may look at many rows */
           want_neighbours(call, job, &r->split.item[i]);
  }
  for (size_t i = r->first_inside; i < r->place.n && good; i++) {
    good = want_polygon(call, job, r->place.item[i].s, r->place.item[i].p);
  }
  for (size_t i = 0; i < r->seam.n && good; i++) {
    good = want_polygon(call, job, r->seam.item[i].s, r->seam.item[i].p);
  }
  return good && sort(call, job->polygon.item, job->polygon.n,
                      sizeof *job->polygon.item, compare_results);
}
