/* solid_old.c -- the rows of a solid, read: see solid_old.h. */
#include "solid_old_private.h"

#include <stdlib.h>
#include <string.h>

uint32_t *
sg_old_new_places(size_t n)
{
  uint32_t *place = malloc((n + 1) * sizeof *place);

  if (place) {
    memset(place, 0xff, (n + 1) * sizeof *place);
  }
  return place;
}

/* ---- by id -------------------------------------------------------------- */

sg_old_end
sg_old_find_most(const sg_solid_old *old, int relation, unsigned column,
                 const sg_cancel *cancel, int32_t *most)
{
  size_t n = sg_old_count(old, relation);

  *most = 0;
  for (uint32_t i = 0; i < n; i++) {
    int32_t id = sg_old_int(old, relation, column, i);
    if (sg_cancel_every(cancel, i)) {
      return SG_OLD_FAILED;
    }
    *most = id > *most ? id : *most;
  }
  return (size_t)*most > 4 * n + SPREAD ? SG_OLD_UNFIT : SG_OLD_READ;
}

static sg_old_end
read_ids(const sg_solid_old *old, int relation, unsigned column,
         const sg_cancel *cancel, sg_old_ids *out)
{
  size_t n = sg_old_count(old, relation);

  if (!out->held) { /* else it is known */
    sg_old_end end =
        sg_old_find_most(old, relation, column, cancel, &out->most);
    if (end != SG_OLD_READ) {
      return end;
    }
  }
  out->place = sg_old_new_places((size_t)out->most);
  for (uint32_t i = 0; out->place && i < n; i++) {
    if (sg_cancel_every(cancel, i)) {
      return SG_OLD_FAILED;
    }
    out->place[sg_old_int(old, relation, column, i)] = i;
  }
  return out->place ? SG_OLD_READ : SG_OLD_FAILED;
}

static sg_old_end
read_all_ids(sg_solid_old *old, const sg_cancel *cancel)
{
  sg_old_end end = read_ids(old, SG_OLD_V, 1, cancel, &old->vertex);

  end =
      end == SG_OLD_READ ? read_ids(old, SG_OLD_E, 1, cancel, &old->edge) : end;
  end = end == SG_OLD_READ ? read_ids(old, SG_OLD_P, 1, cancel, &old->polygon)
                           : end;
  return end == SG_OLD_READ ? read_ids(old, SG_OLD_T, 2, cancel, &old->triangle)
                            : end;
}

/* ---- what belongs to one ------------------------------------------------ */

/* Row i of a relation says something of the one thing with id column 1. */
static sg_old_end
read_one_each(const sg_solid_old *old, int relation, const sg_old_ids *of,
              size_t n, const sg_cancel *cancel, uint32_t **out)
{
  uint32_t *list = *out = sg_old_new_places(n);

  for (uint32_t i = 0; list && i < sg_old_count(old, relation); i++) {
    uint32_t at = sg_old_place(of, sg_old_int(old, relation, 1, i));
    if (sg_cancel_every(cancel, i)) {
      return SG_OLD_FAILED;
    }
    if (at == SG_NO_PLACE || list[at] != SG_NO_PLACE) {
      return SG_OLD_UNFIT;
    }
    list[at] = i;
  }
  return list ? SG_OLD_READ : SG_OLD_FAILED;
}

static sg_old_end
read_origins(sg_solid_old *old, int32_t (*item_vertex)(const uint32_t *item),
             const sg_cancel *cancel)
{
  uint32_t *list = old->origin = sg_old_new_places(sg_old_count(old, SG_OLD_V));

  for (uint32_t i = 0; list && i < sg_old_count(old, SG_OLD_ORIGIN); i++) {
    int32_t v =
        item_vertex((const uint32_t *)sg_old_list(old, SG_OLD_ORIGIN, 1, i));
    uint32_t at = v > 0 ? sg_old_place(&old->vertex, v) : SG_NO_PLACE;
    if (sg_cancel_every(cancel, i)) {
      return SG_OLD_FAILED;
    }
    if (v > 0 && at == SG_NO_PLACE) {
      return SG_OLD_UNFIT;
    }
    if (v > 0) {
      list[at] = i;
    }
  }
  return list ? SG_OLD_READ : SG_OLD_FAILED;
}

/* ---- what belongs to polygons ------------------------------------------- */

/* The polygon that row i of a relation belongs to, by its place. */
static uint32_t
polygon_of(const sg_solid_old *old, int relation, uint32_t i)
{
  return sg_old_place(&old->polygon, sg_old_int(old, relation, 1, i));
}

/* Counts the rows of each polygon: begin[g + 1] is where those of g begin, and,
 * when they are put there, where they end. */
static sg_old_end
begin_groups(const sg_solid_old *old, int relation, const sg_cancel *cancel,
             sg_old_groups *out)
{
  size_t n = sg_old_count(old, relation), groups = sg_old_count(old, SG_OLD_P);

  out->begin = calloc(groups + 2, sizeof *out->begin);
  out->place = malloc((n + 1) * sizeof *out->place);
  if (!out->begin || !out->place) {
    return SG_OLD_FAILED;
  }
  for (uint32_t i = 0; i < n; i++) {
    uint32_t g = polygon_of(old, relation, i);
    if (sg_cancel_every(cancel, i)) {
      return SG_OLD_FAILED;
    }
    if (g == SG_NO_PLACE) {
      return SG_OLD_UNFIT;
    }
    out->begin[g + 2]++;
  }
  for (size_t g = 2; g <= groups + 1; g++) {
    out->begin[g] += out->begin[g - 1];
  }
  return SG_OLD_READ;
}

static void
put_in_group(const sg_solid_old *old, int relation, uint32_t i,
             sg_old_groups *out)
{
  out->place[out->begin[polygon_of(old, relation, i) + 1]++] = i;
}

static sg_old_end
group_triangles(sg_solid_old *old, const sg_cancel *cancel)
{
  sg_old_end end = begin_groups(old, SG_OLD_T, cancel, &old->triangles);

  for (int32_t id = 1; end == SG_OLD_READ && id <= old->triangle.most; id++) {
    if (sg_cancel_every(cancel, (size_t)id)) {
      return SG_OLD_FAILED;
    }
    if (old->triangle.place[id] != SG_NO_PLACE) {
      put_in_group(old, SG_OLD_T, old->triangle.place[id], &old->triangles);
    }
  }
  return end;
}

static sg_old_end
group_sources(sg_solid_old *old, const sg_cancel *cancel)
{
  sg_old_end end = begin_groups(old, SG_OLD_FROM_P, cancel, &old->sources);

  for (uint32_t i = 0;
       end == SG_OLD_READ && i < sg_old_count(old, SG_OLD_FROM_P); i++) {
    put_in_group(old, SG_OLD_FROM_P, i, &old->sources);
  }
  return end;
}

/* Every edge is in just one list, and every edge of a list is there. */
static bool
edges_are_used(const sg_solid_old *old)
{
  size_t used = 0;

  for (uint32_t i = 0; i < sg_old_count(old, SG_OLD_P); i++) {
    const int32_t *list = sg_old_list(old, SG_OLD_P, 2, i);
    for (int32_t k = 1; k <= list[0]; k++) {
      if (sg_old_place(&old->edge, list[k]) == SG_NO_PLACE) {
        return false;
      }
    }
    used += (size_t)list[0];
  }
  return used == sg_old_count(old, SG_OLD_E);
}

/* ---- all of it ---------------------------------------------------------- */

static bool
find_rows(sg_solid_old *old, int32_t s, const sg_cancel *cancel)
{
  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    if (!sg_segment_rows_find(old->view[k], &s, 1, cancel, &old->rows[k])) {
      return false;
    }
  }
  return true;
}

/* What there is to know of the rows that were found. */
static sg_old_end
look_at_all(sg_solid_old *old, int32_t (*item_vertex)(const uint32_t *item),
            const sg_cancel *cancel)
{
  sg_old_end end = read_all_ids(old, cancel);

  end = end == SG_OLD_READ
            ? read_one_each(old, SG_OLD_FROM_V, &old->vertex,
                            sg_old_count(old, SG_OLD_V), cancel, &old->from)
            : end;
  end = end == SG_OLD_READ
            ? read_one_each(old, SG_OLD_PLANE, &old->polygon,
                            sg_old_count(old, SG_OLD_P), cancel, &old->plane)
            : end;
  end = end == SG_OLD_READ ? read_origins(old, item_vertex, cancel) : end;
  end = end == SG_OLD_READ ? group_triangles(old, cancel) : end;
  end = end == SG_OLD_READ ? group_sources(old, cancel) : end;
  return end == SG_OLD_READ && !edges_are_used(old) ? SG_OLD_UNFIT : end;
}

sg_old_end
sg_solid_old_read(const sg_view *const view[SG_OLD_RELATIONS], int32_t s,
                  int32_t (*item_vertex)(const uint32_t *item),
                  const sg_cancel *cancel, sg_solid_old *out)
{
  *out = (sg_solid_old){0};
  memcpy(out->view, view, sizeof out->view);
  return find_rows(out, s, cancel) ? look_at_all(out, item_vertex, cancel)
                                   : SG_OLD_FAILED;
}

sg_old_end
sg_solid_old_read_region(const sg_view *const view[SG_OLD_RELATIONS], int32_t s,
                         const int32_t *leaf, size_t n,
                         int32_t (*item_vertex)(const uint32_t *item),
                         const sg_cancel *cancel, sg_solid_old *out)
{
  *out = (sg_solid_old){0};
  memcpy(out->view, view, sizeof out->view);
  if (!find_rows(out, s, cancel)) {
    return SG_OLD_FAILED;
  }
  sg_old_end end = sg_old_narrow(out, leaf, n, item_vertex, cancel);

  return end == SG_OLD_READ ? look_at_all(out, item_vertex, cancel) : end;
}

void
sg_solid_old_clear(sg_solid_old *old)
{
  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    sg_segment_rows_clear(&old->rows[k]);
  }
  sg_old_ids *const ids[] = {&old->vertex, &old->edge, &old->polygon,
                             &old->triangle};

  for (size_t k = 0; k < sizeof ids / sizeof *ids; k++) {
    free(ids[k]->place);
    free(ids[k]->held);
  }
  free(old->region.leaf);
  free(old->region.row);
  free(old->from);
  free(old->origin);
  free(old->plane);
  free(old->triangles.begin);
  free(old->triangles.place);
  free(old->sources.begin);
  free(old->sources.place);
  *old = (sg_solid_old){0};
}
