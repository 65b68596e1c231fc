/* line_rows.c -- cut sets: joints, and the rows that a penetration leaves.
 *
 * Layer: rows. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut_rows.h"
#include "polygon_rows.h"

#include "doors/penetration.h"
#include "engine/symbol.h"

#include <string.h>

/* ---- joints ---- */

bool
sg_door_cut_joints(sg_call *call, sg_cut_handle *handle, int how,
                   sg_piece_joint_list *joints)
{
  const sg_cut_set *set = &handle->set;
  bool straight = how == SG_JOINT_HOW_STRAIGHT;

  for (uint32_t i = 0; i < set->linked; i++) {
    uint32_t k, l;

    if (sg_cancel_every(&call->cancel, i)) {
      return false;
    }
    if (sg_cut_set_joint(set, i, &k, &l) &&
        sg_cut_set_is_straight(set, k, l) == straight &&
        !sg_piece_joint_list_add(
            call, joints, (sg_piece_joint){i, set->piece[k], set->piece[l]})) {
      return false;
    }
  }
  return true;
}

static bool
has_point(sg_call *call, const sg_cut_set *set, size_t point)
{
  return point < set->points.n || sg_call_missing(call, "cut_point", 2);
}

bool
sg_door_cut_join(sg_call *call, sg_cut_handle *handle, size_t point)
{
  uint32_t k, l;

  if (!has_point(call, &handle->set, point)) {
    return false;
  }
  if (!sg_cut_set_joint(&handle->set, (uint32_t)point, &k, &l)) {
    return sg_call_domain(call, "joint", 2);
  }
  sg_cut_set_join(&handle->set, (uint32_t)point);
  return true;
}

bool
sg_door_cut_settle(sg_call *call, sg_cut_handle *handle)
{
  return sg_cut_set_settle(&handle->set, &call->cancel) || sg_call_ended(call);
}

bool
sg_door_cut_name(sg_call *call, sg_cut_handle *handle, size_t point, int32_t s,
                 int32_t *v)
{
  if (!has_point(call, &handle->set, point)) {
    return false;
  }
  *v = sg_cut_points_name(&handle->set.points, (uint32_t)point, s);
  return *v != 0;
}

/* ---- lines ---- */

/* Notes that the piece between the points is line `number`: found by either
 * segment and both ends; the first one counts. */
static bool
note_line(sg_cut_handle *handle, const sg_cut_piece *piece, int32_t number)
{
  for (int k = 0; k < 2; k++) {
    uint32_t key[3] = {(uint32_t)piece->s[k],
                       piece->a < piece->b ? piece->a : piece->b,
                       piece->a < piece->b ? piece->b : piece->a};
    uint32_t *line = sg_key_table_put(&handle->line_of, key);

    if (!line) {
      return false;
    }
    if (*line == SG_NO_KEY) {
      *line = (uint32_t)number;
    }
  }
  return true;
}

uint32_t
sg_cut_line_of(const sg_cut_handle *handle, int32_t s, int32_t v1, int32_t v2)
{
  uint32_t a = sg_cut_points_named(&handle->set.points, s, v1);
  uint32_t b = sg_cut_points_named(&handle->set.points, s, v2);
  uint32_t key[3] = {(uint32_t)s, a < b ? a : b, a < b ? b : a};

  return sg_key_table_get(&handle->line_of, key);
}

bool
sg_door_cut_line(sg_call *call, sg_cut_handle *handle, int32_t s, int32_t v1,
                 int32_t v2, int32_t *l)
{
  uint32_t number = sg_cut_line_of(handle, s, v1, v2);

  (void)call;
  *l = (int32_t)number;
  return number != SG_NO_KEY;
}

/* From point a to b. */
static bool
add_line(sg_call *call, sg_cut_handle *handle, int32_t l, const int32_t s[2],
         const int32_t p[2], uint32_t a, uint32_t b, sg_line_fact_list *out)
{
  const sg_line_fact line = {.l = l,
                             .s1 = s[0],
                             .p1 = p[0],
                             .a1 = sg_cut_name_in(handle, a, s[0], p[0]),
                             .b1 = sg_cut_name_in(handle, b, s[0], p[0]),
                             .s2 = s[1],
                             .p2 = p[1],
                             .a2 = sg_cut_name_in(handle, a, s[1], p[1]),
                             .b2 = sg_cut_name_in(handle, b, s[1], p[1])};

  return sg_line_fact_list_add(call, out, line);
}

/* All living pieces; then the contacts, from a point to itself. */
bool
sg_door_cut_lines(sg_call *call, sg_cut_handle *handle,
                  sg_line_fact_list *lines)
{
  const sg_cut_set *set = &handle->set;
  int32_t number = sg_call_fresh(call, handle->world, SG_LINE, 0);
  bool good = number != 0;

  for (size_t i = 0; good && i < set->pieces; i++) {
    const sg_cut_piece *k = &set->piece[i];

    if (sg_cancel_every(&call->cancel, i)) {
      return false;
    }
    if (k->live) {
      good = (note_line(handle, k, number) || sg_call_no_memory(call)) &&
             add_line(call, handle, number++, k->s, k->p, k->a, k->b, lines);
    }
  }
  for (size_t i = 0; good && i < set->contacts; i++) {
    const sg_cut_contact *k = &set->contact[i];

    good =
        !sg_cancel_every(&call->cancel, i) &&
        add_line(call, handle, number++, k->s, k->p, k->point, k->point, lines);
  }
  return good;
}

/* ---- vertices ---- */

static bool
add_vertex(sg_call *call, const sg_cut_points *points, uint32_t point,
           const sg_seat *seat, sg_vertex_fact_list *out)
{
  const double *at = points->point[point].at.p;
  const sg_vertex_fact vertex = {.s = seat->s,
                                 .v = seat->v,
                                 .x = at[0],
                                 .y = at[1],
                                 .z = at[2],
                                 .origin = sg_cut_origin(call, points, point)};

  return vertex.origin && sg_vertex_fact_list_add(call, out, vertex);
}

static bool
is_gone(const sg_cut_set *set, uint32_t point)
{
  return point < set->linked && set->gone[point];
}

bool
sg_door_cut_vertices(sg_call *call, sg_cut_handle *handle,
                     sg_vertex_fact_list *vertices)
{
  const sg_cut_points *points = &handle->set.points;

  for (uint32_t i = 0; i < points->n; i++) {
    uint32_t k = is_gone(&handle->set, i) ? SG_NO_KEY : points->point[i].seat;

    if (sg_cancel_every(&call->cancel, i)) {
      return false;
    }
    for (; k != SG_NO_KEY; k = points->seat[k].next) {
      const sg_seat *seat = &points->seat[k];

      if (seat->v != 0 && seat->place.kind != SG_AT_VERTEX &&
          !add_vertex(call, points, i, seat, vertices)) {
        return false;
      }
    }
  }
  return true;
}

/* ---- rows ---- */

static bool
write_lines(sg_call *call, sg_world *world, const sg_line_fact_list *lines)
{
  enum { COLUMNS = 9 };
  size_t n = lines->n;
  int32_t row[COLUMNS], *to = sg_call_alloc(call, n * sizeof row);
  const void *column[COLUMNS];

  _Static_assert(sizeof row == sizeof *lines->at, "line/9 has integers alone");
  for (size_t i = 0; to && i < n; i++) {
    memcpy(row, &lines->at[i], sizeof row);
    for (size_t c = 0; c < COLUMNS; c++) {
      to[c * n + i] = row[c];
    }
  }
  for (size_t c = 0; to && c < COLUMNS; c++) {
    column[c] = to + c * n;
  }
  return to && sg_call_add_rows(call, world, SG_LINE, n, column);
}

static bool
write_vertices(sg_call *call, sg_world *world,
               const sg_vertex_fact_list *vertices)
{
  size_t n = vertices->n;
  int32_t *s = sg_call_alloc(call, n * sizeof *s);
  int32_t *v = sg_call_alloc(call, n * sizeof *v);
  double *at = sg_call_alloc(call, 3 * n * sizeof *at);
  const uint32_t **item = sg_call_alloc(call, n * sizeof *item);
  const uint32_t **origin = sg_call_alloc(call, n * sizeof *origin);
  bool good = s && v && at && item && origin;

  for (size_t i = 0; i < n && good; i++) {
    const sg_vertex_fact *vertex = &vertices->at[i];

    s[i] = vertex->s;
    v[i] = vertex->v;
    at[i] = vertex->x;
    at[n + i] = vertex->y;
    at[2 * n + i] = vertex->z;
    item[i] = sg_unary_term(call, SG_SYMBOL_V, vertex->v);
    origin[i] = vertex->origin;
    good = item[i] != NULL && !sg_cancel_every(&call->cancel, i);
  }
  return good &&
         sg_call_add_rows(
             call, world, SG_V, n,
             (const void *const[]){s, v, at, at + n, at + 2 * n}) &&
         sg_call_add_rows(call, world, SG_ORIGIN, n,
                          (const void *const[]){s, item, origin});
}

bool
sg_door_cut_write_lines(sg_call *call, sg_cut_handle *handle)
{
  sg_vertex_fact_list vertices = {0};
  sg_line_fact_list lines = {0};

  if (!sg_door_cut_vertices(call, handle, &vertices) ||
      !sg_door_cut_lines(call, handle, &lines)) {
    return false;
  }
  sg_world *world = sg_call_claim(call);
  bool good = world && write_vertices(call, world, &vertices) &&
              write_lines(call, world, &lines);

  if (world) {
    sg_world_release(world);
  }
  return good;
}

/* ---- curves ---- */

bool
sg_door_cut_split_edges(sg_call *call, sg_cut_handle *handle, int32_t s,
                        sg_edge_split_list *splits)
{
  const sg_cut_set *set = &handle->set;

  for (size_t i = 0; i < set->edges; i++) {
    const sg_split_edge *edge = &set->edge[i];
    sg_edge_split split = {.v1 = set->model.vertex[edge->place.a].v,
                           .v2 = set->model.vertex[edge->place.b].v};

    if (edge->s != s || edge->n == 0) {
      continue;
    }
    for (size_t k = 0; k < edge->n; k++) {
      if (!sg_int_list_add(
              call, &split.on,
              sg_cut_points_name(&set->points, edge->point[k], s))) {
        return false;
      }
    }
    if (!sg_edge_split_list_add(call, splits, split)) {
      return false;
    }
  }
  return true;
}
