/* regions_rows.c -- the regions of a segment, from rows and in rows. */
#include "doors/gluing.h"
#include "engine/search.h"
#include "regions.h"
#include "rows/append_rows.h"
#include "rows/dense_rows.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Behind a handle. */
struct sg_regions_handle {
  sg_dense dense; /* of the segment alone */
  sg_regions regions;
  int32_t s;
};

void
sg_regions_handle_free(sg_regions_handle *handle)
{
  sg_regions_clear(&handle->regions);
  sg_dense_clear(&handle->dense);
  free(handle);
}

/* ---- opening ---- */

static bool
find_loops(sg_call *call, const sg_dense *d, const sg_point_loop_fact_list *in,
           sg_point_loop **out)
{
  *out = sg_call_alloc(call, (in->n + 1) * sizeof **out);
  for (size_t i = 0; *out && i < in->n; i++) {
    size_t v = sg_find_id(d->vertex_id, d->vertices, in->at[i].v);
    size_t p = sg_find_id(d->polygon_id, d->polygons, in->at[i].p);

    if (v == SIZE_MAX || p == SIZE_MAX) {
      sg_call_missing(call, v == SIZE_MAX ? "vertex" : "polygon", 2);
      return sg_call_at(call, i + 1, v == SIZE_MAX ? 1 : 2);
    }
    (*out)[i] = (sg_point_loop){(uint32_t)v, (uint32_t)p};
  }
  return *out != NULL;
}

static bool
refuse(sg_call *call, const sg_regions_handle *h, sg_regions_end end,
       size_t bad)
{
  if (end == SG_REGIONS_NO_MEMORY) {
    return sg_call_no_memory(call);
  }
  if (end == SG_REGIONS_STOPPED) {
    return sg_call_ended(call);
  }
  int32_t of[2] = {h->s, h->dense.polygon_id[bad]};
  return sg_call_geometry(
      call, end == SG_REGIONS_OPEN ? "open_polygon" : "wrong_triangles", of, 2);
}

/* False: no memory, or stopped. */
static bool
find_solid(sg_call *call, int32_t s, bool *solid)
{
  const sg_version *version = sg_call_version(call);
  sg_segment_rows rows = {0};
  bool good =
      version && sg_rows_of_segment(call, version, SG_SEGMENT, s, &rows);

  *solid = good && rows.begin[1] > 0 &&
           sg_version_value(version, SG_SEGMENT, rows.row[0], 1).i ==
               SG_SYMBOL_SOLID;
  sg_segment_rows_clear(&rows);
  return good;
}

static void
find_voids(sg_regions *regions)
{
  for (size_t r = 0; r + 1 < regions->regions; r++) {
    sg_space_region *region = &regions->region[r];

    if (region->role == SG_REGION_CELL && region->behind == 0) {
      region->role = SG_REGION_VOID;
    }
  }
}

/* e: an edge; -P of polygon P. */
static bool
find_side(sg_call *call, const sg_dense *d, int32_t e, bool above,
          sg_disk_side *side)
{
  size_t at = e < 0 ? sg_find_id(d->polygon_id, d->polygons, -e)
                    : sg_find_id(d->edge_id, d->edges, e);

  *side = (sg_disk_side){e < 0 ? UINT32_MAX : (uint32_t)at,
                         e < 0 ? (uint32_t)at : UINT32_MAX, above};
  return at != SIZE_MAX || sg_call_missing(call, e < 0 ? "polygon" : "edge", 3);
}

SG_ORDER(compare_meetings, sg_zone_meeting, SG_BY(v));

static bool
find_told(sg_call *call, const sg_dense *d, const sg_zone_meeting_fact_list *in,
          sg_zones_told *told)
{
  sg_zone_meeting *meeting = sg_call_alloc(call, (in->n + 1) * sizeof *meeting);
  bool good = meeting != NULL;

  for (size_t i = 0; good && i < in->n; i++) {
    const sg_zone_meeting_fact *m = &in->at[i];
    size_t v = sg_find_id(d->vertex_id, d->vertices, m->v);

    meeting[i].v = (uint32_t)v;
    good = (v != SIZE_MAX || sg_call_missing(call, "vertex", 3)) &&
           find_side(call, d, m->e1, m->above1, &meeting[i].side[0]) &&
           find_side(call, d, m->e2, m->above2, &meeting[i].side[1]);
  }
  if (good && in->n > 0) {
    qsort(meeting, in->n, sizeof *meeting, compare_meetings);
  }
  *told = (sg_zones_told){meeting, in->n};
  return good;
}

static bool
open_regions(sg_call *call, int32_t s, const sg_point_loop_fact_list *loops,
             const sg_zone_meeting_fact_list *meetings, sg_regions_handle **out)
{
  sg_regions_handle *h = calloc(1, sizeof *h);
  sg_point_loop *loop = NULL;
  sg_zones_told told = {0};
  size_t bad = 0;
  bool solid = false;

  if (!h) {
    return sg_call_no_memory(call);
  }
  h->s = s;
  if (!find_solid(call, s, &solid) || !sg_dense_read(call, &s, 1, &h->dense) ||
      !find_loops(call, &h->dense, loops, &loop) ||
      (meetings && !find_told(call, &h->dense, meetings, &told))) {
    sg_regions_handle_free(h);
    return false;
  }
  sg_regions_end end =
      sg_regions_make(&h->dense, loop, loops->n, meetings ? &told : NULL,
                      &call->cancel, &h->regions, &bad);
  if (end != SG_REGIONS_DONE) {
    refuse(call, h, end, bad);
    sg_regions_handle_free(h);
    return false;
  }
  if (solid) {
    find_voids(&h->regions);
  }
  *out = h;
  return true;
}

bool
sg_door_regions_open(sg_call *call, int32_t s,
                     const sg_point_loop_fact_list *loops,
                     sg_regions_handle **out)
{
  return open_regions(call, s, loops, NULL, out);
}

bool
sg_door_regions_told(sg_call *call, int32_t s,
                     const sg_point_loop_fact_list *loops,
                     const sg_zone_meeting_fact_list *meetings,
                     sg_regions_handle **out)
{
  return open_regions(call, s, loops, meetings, out);
}

/* ---- asking ---- */

bool
sg_door_regions_counted(sg_call *call, sg_regions_handle *regions,
                        sg_regions *counts)
{
  (void)call;
  *counts = regions->regions;
  return true;
}

bool
sg_door_regions_listed(sg_call *call, sg_regions_handle *regions,
                       sg_region_fact_list *list)
{
  const sg_regions *all = &regions->regions;
  bool good = true;

  for (size_t r = 0; r < all->regions && good; r++) {
    good = sg_region_fact_list_add(call, list, all->region[r]);
  }
  return good;
}

bool
sg_door_regions_items(sg_call *call, sg_regions_handle *regions,
                      sg_region_item_list *wires, sg_region_item_list *lone)
{
  const sg_regions *all = &regions->regions;
  const sg_dense *d = &regions->dense;
  bool good = true;

  for (size_t i = 0; i < all->wires && good; i++) {
    sg_region_item one = {d->edge_id[all->wire[i].edge],
                          (int32_t)all->wire[i].region + 1};
    good = sg_region_item_list_add(call, wires, one);
  }
  for (size_t i = 0; i < all->lone && good; i++) {
    sg_region_item one = {d->vertex_id[all->lone_vertex[i].v],
                          (int32_t)all->lone_vertex[i].region + 1};
    good = sg_region_item_list_add(call, lone, one);
  }
  return good;
}

/* ---- neighbours ---- */

/* A face between two regions, the lower one in the upper half. */
typedef struct between {
  uint64_t regions;
  double area;
} between;

SG_ORDER(compare_between, between, SG_BY(regions));

static void
add_areas(const sg_dense *d, double *area)
{
  for (size_t t = 0; t < d->triangles; t++) {
    const int32_t *c = d->corner[t];
    double n[3];

    for (int k = 0; k < 3; k++) {
      int u = (k + 1) % 3, w = (k + 2) % 3;
      n[k] =
          (d->at[c[1]][u] - d->at[c[0]][u]) *
              (d->at[c[2]][w] - d->at[c[0]][w]) -
          (d->at[c[1]][w] - d->at[c[0]][w]) * (d->at[c[2]][u] - d->at[c[0]][u]);
    }
    area[d->polygon_of[t]] += hypot(hypot(n[0], n[1]), n[2]) / 2;
  }
}

static bool
list_between(sg_call *call, const between *face, size_t n,
             sg_region_neighbours_fact_list *list)
{
  bool good = true;

  for (size_t i = 0, end; i < n && good; i = end) {
    double area = 0;
    for (end = i; end < n && face[end].regions == face[i].regions; end++) {
      area += face[end].area;
    }
    sg_region_neighbours_fact one = {(int32_t)(face[i].regions >> 32) + 1,
                                     (int32_t)(uint32_t)face[i].regions + 1,
                                     end - i, area};
    good = sg_region_neighbours_fact_list_add(call, list, one);
  }
  return good;
}

bool
sg_door_regions_neighbours(sg_call *call, sg_regions_handle *regions,
                           sg_region_neighbours_fact_list *list)
{
  const sg_dense *d = &regions->dense;
  const uint32_t *side = regions->regions.side;
  between *face = sg_call_alloc(call, (d->polygons + 1) * sizeof *face);
  double *area = sg_call_alloc(call, (d->polygons + 1) * sizeof *area);
  size_t n = 0;

  if (!face || !area) {
    return false;
  }
  memset(area, 0, d->polygons * sizeof *area);
  add_areas(d, area);
  for (size_t p = 0; p < d->polygons; p++) {
    uint32_t a = side[2 * p], b = side[2 * p + 1];
    if (a != b) {
      face[n++] =
          (between){(uint64_t)(a < b ? a : b) << 32 | (a < b ? b : a), area[p]};
    }
  }
  return (sg_sort(face, n, sizeof *face, compare_between, &call->cancel) ==
              SG_SORTED ||
          sg_call_ended(call)) &&
         list_between(call, face, n, list);
}

/* ---- writing ---- */

static int32_t
symbol_of(sg_region_role role)
{
  static const int32_t symbol[] = {SG_SYMBOL_OUTSIDE, SG_SYMBOL_CELL,
                                   SG_SYMBOL_VOID, SG_SYMBOL_SLIT};

  return symbol[role];
}

static bool
write_regions(sg_call *call, const sg_regions_handle *h, int32_t *column[4])
{
  size_t n = h->regions.regions;

  for (size_t r = 0; r < n; r++) {
    column[0][r] = h->s;
    column[1][r] = (int32_t)r + 1;
    column[2][r] = symbol_of(h->regions.region[r].role);
  }
  return sg_append_columns(call, call->world, SG_REGION, n,
                           (const void *const *)column);
}

static bool
write_sides(sg_call *call, const sg_regions_handle *h, int32_t *column[4])
{
  size_t n = 0;

  for (size_t p = 0; p < h->dense.polygons; p++) {
    if (h->regions.side[2 * p] != UINT32_MAX) {
      column[0][n] = h->s;
      column[1][n] = h->dense.polygon_id[p];
      column[2][n] = (int32_t)h->regions.side[2 * p] + 1;
      column[3][n++] = (int32_t)h->regions.side[2 * p + 1] + 1;
    }
  }
  return sg_append_columns(call, call->world, SG_SIDES, n,
                           (const void *const *)column);
}

bool
sg_door_regions_written(sg_call *call, sg_regions_handle *regions)
{
  size_t n = regions->dense.polygons + regions->regions.regions + 1;
  int32_t *column[4];

  for (int k = 0; k < 4; k++) {
    column[k] = sg_call_alloc(call, n * sizeof(int32_t));
    if (!column[k]) {
      return false;
    }
  }
  sg_world *world = sg_call_claim(call);
  if (!world) {
    return false;
  }
  bool good = write_regions(call, regions, column) &&
              write_sides(call, regions, column);
  sg_world_release(world);
  return good;
}
