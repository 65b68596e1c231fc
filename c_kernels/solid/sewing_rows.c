/* sewing_rows.c -- shells of a segment that touch exactly, in its rows. */
#include "doors/boolean.h"
#include "engine/search.h"
#include "rows/append_rows.h"
#include "rows/dense_rows.h"
#include "sewing.h"

#include <string.h>

enum { MOST_INTS = 6 }; /* columns of integers: those of t/6 */

/* A segment at hand. */
typedef struct sewn {
  sg_call *call;
  sg_world *world;
  const sg_version *version;
  int32_t s;
  sg_dense dense;
  sg_sewing sewing;
  bool *kept; /* [edges]: they do not fall out with their polygons */
} sewn;

/* Rows that go, and those that come instead. */
typedef struct exchange {
  sg_row *gone;
  size_t gones, n;
  int32_t *column[MOST_INTS]; /* [n] */
} exchange;

/* ---- what becomes of a row ---- */

/* The id of the vertex that vertex v becomes. */
static int32_t
vertex_of(const sewn *s, int32_t v)
{
  const sg_dense *d = &s->dense;

  return d
      ->vertex_id[s->sewing.vertex[sg_find_id(d->vertex_id, d->vertices, v)]];
}

static bool
falls_out(const sewn *s, int32_t p)
{
  const sg_dense *d = &s->dense;

  return s->sewing.weight[sg_find_id(d->polygon_id, d->polygons, p)] == 0;
}

/* Whether a row goes, and *comes: as `row` then. Column 1 of all but t/6 is the
 * id. */
static bool
changes(const sewn *s, sg_relation relation, int32_t row[MOST_INTS],
        bool *comes)
{
  unsigned first = relation == SG_T ? 3 : 2, end = relation == SG_T ? 6 : 4;
  bool moved = false;

  *comes = relation == SG_E
               ? s->kept[sg_find_id(s->dense.edge_id, s->dense.edges, row[1])]
               : !falls_out(s, row[1]);
  if (!*comes) {
    return true;
  }
  for (unsigned c = first; (relation == SG_E || relation == SG_T) && c < end;
       c++) {
    int32_t v = vertex_of(s, row[c]);

    moved = moved || v != row[c];
    row[c] = v;
  }
  *comes = moved;
  return moved;
}

/* ---- rows ---- */

static unsigned
ints_of(sg_relation relation)
{
  return relation == SG_T ? 6 : relation == SG_E ? 5 : 2;
}

static bool
fill(const sewn *s, sg_relation relation, const sg_segment_rows *rows,
     exchange *out)
{
  size_t most = rows->begin[1] + 1;
  unsigned ints = ints_of(relation);

  out->gone = sg_call_alloc(s->call, most * sizeof *out->gone);
  for (unsigned c = 0; c < ints; c++) {
    out->column[c] = sg_call_alloc(s->call, most * sizeof(int32_t));
    if (!out->column[c] || !out->gone) {
      return false;
    }
  }
  for (size_t i = 0; i < rows->begin[1]; i++) {
    int32_t row[MOST_INTS];
    bool comes;

    for (unsigned c = 0; c < ints; c++) {
      row[c] = sg_version_value(s->version, relation, rows->row[i], c).i;
    }
    if (!changes(s, relation, row, &comes)) {
      continue;
    }
    out->gone[out->gones++] = rows->row[i];
    for (unsigned c = 0; comes && c < ints; c++) {
      out->column[c][out->n] = row[c];
    }
    out->n += comes;
  }
  return true;
}

/* The rows of a relation of integers that come, or one from which some go. */
static bool
exchange_rows(const sewn *s, sg_relation relation)
{
  sg_segment_rows rows;
  exchange x = {0};
  bool good = sg_rows_of_segment(s->call, s->version, relation, s->s, &rows) &&
              fill(s, relation, &rows, &x) &&
              (sg_world_exchange(s->world, relation, x.gone, x.gones, x.n,
                                 (const void *const *)x.column) ||
               sg_call_no_memory(s->call));

  sg_segment_rows_clear(&rows);
  return good;
}

/* The edges of polygons that fall out are not kept, or of those that stay are.
 */
static void
keep_edges(sewn *s, bool kept)
{
  const sg_dense *d = &s->dense;

  for (size_t p = 0; p < d->polygons; p++) {
    for (uint32_t i = d->list_begin[p];
         (s->sewing.weight[p] != 0) == kept && i < d->list_begin[p + 1]; i++) {
      s->kept[d->list[i]] = kept;
    }
  }
}

static bool
find_kept_edges(sewn *s)
{
  if (!(s->kept = sg_call_alloc(s->call, s->dense.edges + 1))) {
    return false;
  }
  memset(s->kept, true, s->dense.edges);
  keep_edges(s, false);
  keep_edges(s, true);
  return true;
}

/* What refers to others goes before these. */
static bool
write_rows(sewn *s)
{
  static const sg_relation changed[] = {SG_T, SG_PLANE, SG_P, SG_E};
  bool good = true;

  if (!find_kept_edges(s) || !sg_call_claim(s->call)) {
    return false;
  }
  for (size_t i = 0; i < sizeof changed / sizeof *changed && good; i++) {
    good = exchange_rows(s, changed[i]);
  }
  sg_world_release(s->world);
  return good;
}

/* Vertices that have become another one. */
static bool
drop_twins(const sewn *s)
{
  const sg_dense *d = &s->dense;
  sg_segment_rows rows;
  sg_row *gone = sg_call_alloc(s->call, (d->vertices + 1) * sizeof *gone);
  size_t n = 0;
  bool good =
      gone && sg_rows_of_segment(s->call, s->version, SG_V, s->s, &rows);

  for (size_t i = 0; good && i < rows.begin[1]; i++) {
    int32_t v = sg_version_value(s->version, SG_V, rows.row[i], 1).i;

    if (vertex_of(s, v) != v) {
      gone[n++] = rows.row[i];
    }
  }
  if (good) {
    sg_segment_rows_clear(&rows);
    good = sg_call_claim(s->call) != NULL;
  }
  if (good) {
    good = sg_world_exchange(s->world, SG_V, gone, n, 0, NULL) ||
           sg_call_no_memory(s->call);
    sg_world_release(s->world);
  }
  return good;
}

/* ---- the doors ---- */

/* Those that do not count once. */
static bool
list_weights(const sewn *s, sg_polygon_weight_list *out)
{
  for (size_t p = 0; p < s->dense.polygons; p++) {
    sg_polygon_weight one = {s->dense.polygon_id[p], s->sewing.weight[p]};

    if (one.weight != 0 && one.weight != 1 &&
        !sg_polygon_weight_list_add(s->call, out, one)) {
      return false;
    }
  }
  return true;
}

/* Each polygon once, whichever way it is turned, and no vertices but those that
 * stay. */
static bool
weld(sewn *s)
{
  if (!s->sewing.any && s->sewing.doubles == 0) {
    return true;
  }
  for (size_t p = 0; p < s->dense.polygons; p++) {
    s->sewing.weight[p] = !s->sewing.again[p];
  }
  return write_rows(s) && drop_twins(s);
}

/* To be cleared in any case. */
static bool
find_sewing(sg_call *call, int32_t id, bool doubles, sewn *s)
{
  *s = (sewn){.call = call, .world = sg_call_world(call), .s = id};
  if (!s->world) {
    return false;
  }
  s->version = sg_world_version(s->world);
  return sg_dense_read(call, &id, 1, &s->dense) &&
         (sg_sewing_find(&s->dense, doubles, &call->cancel, &s->sewing) ||
          sg_call_ended(call));
}

static void
clear(sewn *s)
{
  sg_sewing_clear(&s->sewing);
  sg_dense_clear(&s->dense);
  if (s->world) {
    sg_version_drop(s->version);
  }
}

bool
sg_door_segment_welded(sg_call *call, int32_t id, size_t *doubles)
{
  sewn s = {0};
  bool good = find_sewing(call, id, true, &s) && weld(&s);

  *doubles = s.sewing.doubles;
  clear(&s);
  return good;
}

bool
sg_door_segment_sewn(sg_call *call, int32_t id, sg_polygon_weight_list *weights)
{
  sewn s = {0};
  bool good = find_sewing(call, id, false, &s) && s.sewing.any &&
              write_rows(&s) && list_weights(&s, weights);

  clear(&s);
  return good;
}
