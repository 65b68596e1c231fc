/* shell_copy_rows.c -- equal shells of a segment, in its rows. */
#include "doors/boolean.h"
#include "engine/search.h"
#include "join/shell_copy.h"
#include "rows/append_rows.h"
#include "rows/dense_rows.h"

typedef struct dropping {
  sg_call *call;
  sg_world *world;
  const sg_version *version;
  int32_t s;
  sg_dense dense;
  sg_shell_copies copies;
  bool *gone; /* [vertices] */
} dropping;

/* What may not be there: it was made from the segment, or says what it was. */
static const sg_relation derived[] = {
    SG_LEAF_V, SG_LEAF_E,  SG_LEAF_P,         SG_LEAF_T,  SG_ORIGIN, SG_FROM_V,
    SG_FROM_P, SG_REGION,  SG_SIDES,          SG_LIES_IN, SG_PIECE,  SG_JOINT,
    SG_SCREEN, SG_CONTOUR, SG_SURFACE_FACING, SG_DRAWN};

/* Whether the segment has none of them; false too: refused. */
static bool
is_alone(const dropping *d)
{
  size_t n = sizeof derived / sizeof *derived;
  bool good = sg_version_count(d->version, SG_LINE) == 0;

  for (size_t i = 0; i < n && good; i++) {
    sg_segment_rows rows = {0};

    if (sg_version_count(d->version, derived[i]) > 0) {
      good = sg_rows_of_segment(d->call, d->version, derived[i], d->s, &rows) &&
             rows.begin[1] == 0;
      sg_segment_rows_clear(&rows);
    }
  }
  return good;
}

/* Whether the row of an id in a relation goes with the shell of its vertex. */
static bool
goes(const dropping *w, sg_relation relation, int32_t id)
{
  const sg_dense *d = &w->dense;
  size_t at;

  if (relation == SG_V) {
    at = sg_find_id(d->vertex_id, d->vertices, id);
    return w->gone[at];
  }
  if (relation == SG_E) {
    at = sg_find_id(d->edge_id, d->edges, id);
    return w->gone[d->from[at]];
  }
  at = sg_find_id(d->polygon_id, d->polygons, id);
  return d->list_begin[at] < d->list_begin[at + 1] &&
         w->gone[d->from[d->list[d->list_begin[at]]]];
}

static bool
drop_rows(const dropping *w, sg_relation relation)
{
  sg_segment_rows rows = {0};
  sg_row *gone = NULL;
  size_t n = 0;
  bool good =
      sg_rows_of_segment(w->call, w->version, relation, w->s, &rows) &&
      (gone = sg_call_alloc(w->call, (rows.begin[1] + 1) * sizeof *gone));

  for (size_t i = 0; good && i < rows.begin[1]; i++) {
    sg_row row = rows.row[i];

    if (goes(w, relation, sg_version_value(w->version, relation, row, 1).i)) {
      gone[n++] = row;
    }
  }
  good = good && (sg_world_exchange(w->world, relation, gone, n, 0, NULL) ||
                  sg_call_no_memory(w->call));
  sg_segment_rows_clear(&rows);
  return good;
}

/* Notes the vertices of shells that have so many equal ones before them. */
static bool
find_gone(dropping *w, size_t most)
{
  const sg_dense *d = &w->dense;
  bool any = false;

  w->gone = sg_call_alloc(w->call, d->vertices + 1);
  for (size_t v = 0; w->gone && v < d->vertices; v++) {
    w->gone[v] = false;
  }
  for (size_t p = 0; w->gone && w->copies.any && p < d->polygons; p++) {
    for (uint32_t i = d->list_begin[p];
         w->copies.copy[p] >= most && i < d->list_begin[p + 1]; i++) {
      w->gone[d->from[d->list[i]]] = w->gone[d->to[d->list[i]]] = any = true;
    }
  }
  return any;
}

/* What refers to others goes before these. */
static bool
drop_all(const dropping *w)
{
  static const sg_relation changed[] = {SG_T, SG_PLANE, SG_P, SG_E, SG_V};
  bool good = true;

  if (!sg_call_claim(w->call)) {
    return false;
  }
  for (size_t i = 0; i < sizeof changed / sizeof *changed && good; i++) {
    good = drop_rows(w, changed[i]);
  }
  sg_world_release(w->world);
  return good;
}

bool
sg_door_segment_copies_dropped(sg_call *call, int32_t id, size_t most)
{
  dropping w = {.call = call, .world = sg_call_world(call), .s = id};

  if (!w.world) {
    return false;
  }
  w.version = sg_world_version(w.world);
  bool good = is_alone(&w) && sg_dense_read(call, &id, 1, &w.dense) &&
              w.dense.segments == 1 &&
              (sg_shell_copies_find(&w.dense, 0, &call->cancel, &w.copies) ||
               sg_call_ended(call)) &&
              find_gone(&w, most) && drop_all(&w);

  sg_shell_copies_clear(&w.copies);
  sg_dense_clear(&w.dense);
  sg_version_drop(w.version);
  return good;
}
