/* line4pl.c -- cut sets: joints, and the rows that a penetration leaves.
 *
 * Layer: glue. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut4pl.h"

#include "glue.h"

#include "engine/install.h"

#include <stdlib.h>

static functor_t functor_piece4, functor_joint3, functor_vertex6;
static atom_t atom_straight, atom_near;

/* ---- joints ---- */

static int
unify_piece(term_t t, const sg_cut_piece *piece)
{
  return PL_unify_term(t, PL_FUNCTOR, functor_piece4, PL_INT, piece->s[0],
                       PL_INT, piece->p[0], PL_INT, piece->s[1], PL_INT,
                       piece->p[1]);
}

static int
get_how_ex(term_t t, bool *straight)
{
  atom_t how;

  if (!PL_get_atom_ex(t, &how)) {
    return FALSE;
  }
  *straight = how == atom_straight;
  return how == atom_straight || how == atom_near ||
         PL_domain_error("joint", t);
}

static foreign_t
cut_joints(term_t t, term_t how, term_t list)
{
  sg_cut_handle *handle;
  bool straight;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t piece = PL_new_term_refs(2);

  if (!sg_get_cut_set_ex(t, &handle) || !get_how_ex(how, &straight)) {
    return FALSE;
  }
  const sg_cut_set *set = &handle->set;

  for (uint32_t i = 0; i < set->linked; i++) {
    uint32_t k, l;

    if (!sg_cut_set_joint(set, i, &k, &l) ||
        sg_cut_set_is_straight(set, k, l) != straight) {
      continue;
    }
    PL_put_variable(piece);
    PL_put_variable(piece + 1);
    if (!unify_piece(piece, &set->piece[k]) ||
        !unify_piece(piece + 1, &set->piece[l]) ||
        !PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR, functor_joint3, PL_INT, (int)i,
                       PL_TERM, piece, PL_TERM, piece + 1)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static int
get_point_number_ex(term_t t, const sg_cut_set *set, uint32_t *out)
{
  int32_t i;

  if (!sg_get_int32_ex(t, &i)) {
    return FALSE;
  }
  *out = (uint32_t)i;
  return (i >= 0 && (size_t)i < set->points.n) ||
         PL_existence_error("cut_point", t);
}

static foreign_t
cut_join(term_t t, term_t point)
{
  sg_cut_handle *handle;
  uint32_t number, k, l;

  if (!sg_get_cut_set_ex(t, &handle) ||
      !get_point_number_ex(point, &handle->set, &number)) {
    return FALSE;
  }
  if (!sg_cut_set_joint(&handle->set, number, &k, &l)) {
    return PL_domain_error("joint", point);
  }
  sg_cut_set_join(&handle->set, number);
  return TRUE;
}

/* After the straight joints: the points joined away are forgotten. */
static foreign_t
cut_settle(term_t t)
{
  sg_cut_handle *handle;

  return sg_get_cut_set_ex(t, &handle) &&
         (sg_cut_set_settle(&handle->set) || sg_no_memory());
}

static bool
is_gone(const sg_cut_set *set, uint32_t point)
{
  return point < set->linked && set->gone[point];
}

/* The name of a point in a segment. */
static foreign_t
cut_name(term_t t, term_t point, term_t s, term_t name)
{
  sg_cut_handle *handle;
  uint32_t number;
  int32_t segment, v;

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_id_ex(s, &segment) ||
      !get_point_number_ex(point, &handle->set, &number)) {
    return FALSE;
  }
  v = sg_cut_points_name(&handle->set.points, number, segment);
  return v != 0 && PL_unify_integer(name, v);
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

static foreign_t
cut_line(term_t t, term_t s, term_t v1, term_t v2, term_t line)
{
  sg_cut_handle *handle;
  int32_t id[3];

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_id_ex(s, &id[0]) ||
      !sg_get_id_ex(v1, &id[1]) || !sg_get_id_ex(v2, &id[2])) {
    return FALSE;
  }
  uint32_t number = sg_cut_line_of(handle, id[0], id[1], id[2]);

  return number != SG_NO_KEY && PL_unify_integer(line, number);
}

/* line(L, S1, P1, A1, B1, S2, P2, A2, B2): from point a to b. */
static int
unify_line(term_t t, sg_cut_handle *handle, int32_t number, const int32_t s[2],
           const int32_t p[2], uint32_t a, uint32_t b)
{
  return PL_unify_term(
      t, PL_FUNCTOR_CHARS, "line", 9, PL_INT, number, PL_INT, s[0], PL_INT,
      p[0], PL_INT, sg_cut_name_in(handle, a, s[0], p[0]), PL_INT,
      sg_cut_name_in(handle, b, s[0], p[0]), PL_INT, s[1], PL_INT, p[1], PL_INT,
      sg_cut_name_in(handle, a, s[1], p[1]), PL_INT,
      sg_cut_name_in(handle, b, s[1], p[1]));
}

/* All living pieces; then the contacts, from a point to itself. */
static foreign_t
cut_lines(term_t t, term_t list)
{
  sg_cut_handle *handle;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle)) {
    return FALSE;
  }
  const sg_cut_set *set = &handle->set;
  int32_t number = sg_fresh_ex(handle->world, SG_LINE, 0);

  if (number == 0) {
    return FALSE;
  }
  for (size_t i = 0; i < set->pieces; i++) {
    const sg_cut_piece *k = &set->piece[i];

    if (!k->live) {
      continue;
    }
    if (!note_line(handle, k, number)) {
      return sg_no_memory();
    }
    if (!PL_unify_list(tail, head, tail) ||
        !unify_line(head, handle, number++, k->s, k->p, k->a, k->b)) {
      return FALSE;
    }
  }
  for (size_t i = 0; i < set->contacts; i++) {
    const sg_cut_contact *k = &set->contact[i];

    if (!PL_unify_list(tail, head, tail) ||
        !unify_line(head, handle, number++, k->s, k->p, k->point, k->point)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* ---- vertices ---- */

static int
unify_vertex(term_t t, const sg_cut_points *points, uint32_t point,
             const sg_seat *seat)
{
  term_t origin = PL_new_term_ref();
  const double *p = points->point[point].at.p;

  return sg_unify_origin(origin, points, point) &&
         PL_unify_term(t, PL_FUNCTOR, functor_vertex6, PL_INT, seat->s, PL_INT,
                       seat->v, PL_DOUBLE, p[0] + 0.0, PL_DOUBLE, p[1] + 0.0,
                       PL_DOUBLE, p[2] + 0.0, PL_TERM, origin);
}

/* All vertices that are new: vertex(S, V, X, Y, Z, Origin). */
static foreign_t
cut_vertices(term_t t, term_t list)
{
  sg_cut_handle *handle;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle)) {
    return FALSE;
  }
  const sg_cut_points *points = &handle->set.points;

  for (uint32_t i = 0; i < points->n; i++) {
    if (is_gone(&handle->set, i)) {
      continue;
    }
    for (uint32_t k = points->point[i].seat; k != SG_NO_KEY;
         k = points->seat[k].next) {
      const sg_seat *seat = &points->seat[k];

      if (seat->v != 0 && seat->place.kind != SG_AT_VERTEX &&
          (!PL_unify_list(tail, head, tail) ||
           !unify_vertex(head, points, i, seat))) {
        return FALSE;
      }
    }
  }
  return PL_unify_nil(tail);
}

/* The points on edges of a segment: split(V1, V2, [V, ...]), V1 < V2 by the
 * set's own order, the list from V1 to V2. */
static foreign_t
cut_split_edges(term_t t, term_t s, term_t list)
{
  sg_cut_handle *handle;
  int32_t segment;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_id_ex(s, &segment)) {
    return FALSE;
  }
  const sg_cut_set *set = &handle->set;

  for (size_t i = 0; i < set->edges; i++) {
    const sg_split_edge *edge = &set->edge[i];
    term_t names = PL_new_term_ref(), name = PL_new_term_ref();
    term_t end;

    if (edge->s != segment || edge->n == 0) {
      continue;
    }
    end = PL_copy_term_ref(names);
    for (size_t k = 0; k < edge->n; k++) {
      if (!PL_unify_list(end, name, end) ||
          !PL_unify_integer(name, sg_cut_points_name(
                                      &set->points, edge->point[k], segment))) {
        return FALSE;
      }
    }
    if (!PL_unify_nil(end) || !PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR_CHARS, "split", 3, PL_INT,
                       set->model.vertex[edge->place.a].v, PL_INT,
                       set->model.vertex[edge->place.b].v, PL_TERM, names)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static const PL_extension predicates[] = {
    {"cut_joints", 3, cut_joints, 0},
    {"cut_join", 2, cut_join, 0},
    {"cut_settle", 1, cut_settle, 0},
    {"cut_name", 4, cut_name, 0},
    {"cut_lines", 2, cut_lines, 0},
    {"cut_line", 5, cut_line, 0},
    {"cut_vertices", 2, cut_vertices, 0},
    {"cut_split_edges", 3, cut_split_edges, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_line(void)
{
  functor_piece4 = PL_new_functor(PL_new_atom("piece"), 4);
  functor_joint3 = PL_new_functor(PL_new_atom("joint"), 3);
  functor_vertex6 = PL_new_functor(PL_new_atom("vertex"), 6);
  atom_straight = PL_new_atom("straight");
  atom_near = PL_new_atom("near");
  PL_register_extensions_in_module("sg_kernel_penetration", predicates);
}
