/* region_content_rows.c -- from_r/4 of a glue, from its other rows. */
#include "doors/gluing.h"
#include "engine/list.h"
#include "engine/search.h"
#include "region_content.h"
#include "rows/append_rows.h"
#include "rows/sort.h"

#include <stdlib.h>

/* A polygon and the regions beside it; or one, a solid that it is a part of,
 * and in which sense. */
typedef struct triple {
  int32_t p, a, b;
} triple;

typedef SG_LIST_OF(triple) triples;

SG_ORDER(compare_triples, triple, SG_BY(p) SG_BY(a) SG_BY(b));

/* The polygons of s with the second and the `last` column, by polygon;
 * `wanted`: of these in the second alone, or all. */
static bool
list_rows(sg_call *call, const sg_version *version, sg_relation relation,
          unsigned last, int32_t s, const sg_int_list *wanted, triples *out)
{
  sg_view view = {0};
  sg_segment_rows rows = {0};
  bool good =
      sg_version_view(version, relation, &view) &&
      sg_segment_rows_find(&view, &s, 1, &call->cancel, &rows) &&
      sg_list_need(&out->item, rows.begin[1] + 1, &out->room, sizeof(triple));

  for (size_t i = 0; good && i < rows.begin[1]; i++) {
    uint32_t row = rows.row[i];
    triple one = {sg_view_int(&view, 1, row), sg_view_int(&view, 2, row),
                  sg_view_int(&view, last, row)};

    if (!wanted || sg_find_id(wanted->at, wanted->n, one.a) != SIZE_MAX) {
      out->item[out->n++] = one;
    }
  }
  good = good && sg_sort(out->item, out->n, sizeof(triple), compare_triples,
                         &call->cancel) == SG_SORTED;
  sg_segment_rows_clear(&rows);
  sg_view_clear(&view);
  return good;
}

typedef struct reading {
  triples sides, from;
  uint32_t *side, *begin;
  int32_t *solid;
  size_t regions;
  uint32_t outside;
} reading;

/* The outside is the last of them. */
static bool
find_outside(sg_call *call, const sg_version *version, int32_t s, reading *r)
{
  sg_segment_rows rows;
  bool good = sg_rows_of_segment(call, version, SG_REGION, s, &rows);

  for (size_t i = 0; good && i < rows.begin[1]; i++) {
    int32_t id = sg_version_value(version, SG_REGION, rows.row[i], 1).i;

    r->regions = (size_t)id > r->regions ? (size_t)id : r->regions;
  }
  r->outside = (uint32_t)r->regions - 1;
  sg_segment_rows_clear(&rows);
  return good && r->regions > 0;
}

/* Several polygons of a solid may be parts of one: each sense counts once. */
static void
keep_different(triples *list)
{
  size_t n = 0;

  for (size_t i = 0; i < list->n; i++) {
    if (n == 0 || compare_triples(&list->item[n - 1], &list->item[i]) != 0) {
      list->item[n++] = list->item[i];
    }
  }
  list->n = n;
}

static void
arrange(reading *r)
{
  size_t from = 0;

  keep_different(&r->from);

  for (size_t f = 0; f < r->sides.n; f++) {
    const triple *sides = &r->sides.item[f];

    r->side[2 * f] = (uint32_t)sides->a - 1;
    r->side[2 * f + 1] = (uint32_t)sides->b - 1;
    while (from < r->from.n && r->from.item[from].p < sides->p) {
      from++;
    }
    r->begin[f] = (uint32_t)from;
    while (from < r->from.n && r->from.item[from].p == sides->p) {
      from++;
    }
  }
  r->begin[r->sides.n] = (uint32_t)r->from.n;
  for (size_t i = 0; i < r->from.n; i++) {
    r->solid[i] = r->from.item[i].a;
  }
}

static bool
read_all(sg_call *call, const sg_version *version, int32_t s,
         const sg_int_list *solids, reading *r)
{
  if (!find_outside(call, version, s, r)) {
    return false;
  }
  if (!list_rows(call, version, SG_SIDES, 3, s, NULL, &r->sides) ||
      !list_rows(call, version, SG_FROM_P, 4, s, solids, &r->from)) {
    return sg_call_ended(call);
  }
  r->side = malloc((2 * r->sides.n + 1) * sizeof *r->side);
  r->begin = malloc((r->sides.n + 1) * sizeof *r->begin);
  r->solid = malloc((r->from.n + 1) * sizeof *r->solid);
  if (!r->side || !r->begin || !r->solid) {
    return sg_call_no_memory(call);
  }
  arrange(r);
  return true;
}

static void
clear_reading(reading *r)
{
  free(r->sides.item);
  free(r->from.item);
  free(r->side);
  free(r->begin);
  free(r->solid);
}

static bool
write_content(sg_call *call, int32_t s, const sg_region_content *content,
              size_t regions)
{
  size_t n = content->begin[regions];
  int32_t *column[4];

  for (int k = 0; k < 4; k++) {
    column[k] = sg_call_alloc(call, (n + 1) * sizeof(int32_t));
    if (!column[k]) {
      return false;
    }
  }
  for (size_t r = 0; r < regions; r++) {
    for (size_t i = content->begin[r]; i < content->begin[r + 1]; i++) {
      column[0][i] = s;
      column[1][i] = (int32_t)r + 1;
      column[2][i] = content->solid[i];
      column[3][i] = 1;
    }
  }
  sg_world *world = sg_call_claim(call);
  bool good = world && sg_append_columns(call, world, SG_FROM_R, n,
                                         (const void *const *)column);

  if (world) {
    sg_world_release(world);
  }
  return good;
}

bool
sg_door_contents_written(sg_call *call, int32_t s, const sg_int_list *solids,
                         sg_int_list *nothing, size_t *wrong)
{
  const sg_version *version = sg_call_version(call);
  sg_region_content content = {0};
  reading r = {0};
  bool good = version && read_all(call, version, s, solids, &r);

  if (good) {
    const sg_content_faces faces = {r.sides.n, r.side, r.begin, r.solid};

    good = sg_region_content_make(&faces, r.regions, r.outside, &call->cancel,
                                  &content, wrong) ||
           sg_call_ended(call);
  }
  for (size_t i = 0; good && i < r.regions; i++) {
    good = content.begin[i] < content.begin[i + 1] ||
           sg_int_list_add(call, nothing, (int32_t)i + 1);
  }
  good = good && write_content(call, s, &content, r.regions);
  sg_region_content_clear(&content);
  clear_reading(&r);
  return good;
}
