/* split4pl.c -- cut sets: where pieces cross while they enter, and what is
 * divided by that.
 *
 * Layer: glue. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut4pl.h"

#include "glue.h"
#include "polygon/work4pl.h"

#include "engine/install.h"

/* ---- crossings ---- */

/* Whether a point lies inside both segments (of work handles). */
static bool
is_inside_both(sg_work *work, int32_t x, const int32_t a[2], const int32_t b[2])
{
  return x != SG_WORK_NONE && sg_work_between(work, a[0], a[1], x) &&
         sg_work_between(work, b[0], b[1], x);
}

/* The point in which the work's two segments cross, in its own plane. */
static uint32_t
cross_in_work(sg_cut_handle *handle, sg_work *work, const int32_t a[2],
              const int32_t b[2])
{
  sg_made none = {0};
  sg_point at;

  if (!sg_point_ll(&at, sg_work_axis(work), sg_work_point(work, a[0]),
                   sg_work_point(work, a[1]), sg_work_point(work, b[0]),
                   sg_work_point(work, b[1]))) {
    return SG_NO_KEY;
  }
  uint32_t point = sg_cut_points_at(&handle->set.points, &at, &none);

  sg_point_clear(&at);
  return point;
}

/* Where the triangles that carry piece k and the edge's own piece meet, if the
 * edge is one. */
static uint32_t
cross_by_carriers(sg_cut_handle *handle, int32_t k, const sg_work_edge *edge)
{
  const sg_cut_set *set = &handle->set;
  int64_t l = -edge->label - 1;

  if (l < 0 || (size_t)l >= set->pieces) {
    return SG_NO_KEY;
  }
  sg_made made = sg_cut_set_crossing(set, &set->piece[k], &set->piece[l]);

  return sg_cut_points_find(&handle->set.points, &made);
}

/* The point in which piece k, from a[0] to a[1], crosses an edge of the work:
 * by what carries them if that point is on both, else as the work sees it.
 * SG_WORK_NONE: an exception. */
static int32_t
cross_ex(sg_cut_handle *handle, sg_work *work, int32_t s, int32_t k,
         const int32_t a[2], const sg_work_edge *edge)
{
  int32_t b[2] = {edge->start, edge->end}, x = SG_WORK_NONE;
  uint32_t point = cross_by_carriers(handle, k, edge);

  if (point != SG_NO_KEY) {
    x = sg_cut_enter_point_ex(handle, work, point, s);
  }
  if (!is_inside_both(work, x, a, b)) {
    point = cross_in_work(handle, work, a, b);
    x = point == SG_NO_KEY ? SG_WORK_NONE
                           : sg_cut_enter_point_ex(handle, work, point, s);
  }
  if (x == SG_WORK_NONE && !PL_exception(0)) {
    sg_no_memory();
  }
  return x;
}

static foreign_t
cut_crossing(term_t t, term_t work_term, term_t s, term_t piece, term_t edge,
             term_t v1, term_t v2, term_t out)
{
  sg_cut_handle *handle;
  sg_work *work;
  int32_t id[3], a[2];
  term_t arg[3] = {s, piece, edge};

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_work_ex(work_term, &work) ||
      !sg_get_work_vertex_ex(work, v1, &a[0]) ||
      !sg_get_work_vertex_ex(work, v2, &a[1])) {
    return FALSE;
  }
  for (int i = 0; i < 3; i++) {
    if (!sg_get_int32_ex(arg[i], &id[i])) {
      return FALSE;
    }
  }
  const sg_work_edge *crossed = sg_work_get(work, id[2]);

  if (!crossed) {
    return PL_existence_error("work_edge", edge);
  }
  if (id[1] < 0 || (size_t)id[1] >= handle->set.pieces) {
    return PL_existence_error("cut_piece", piece);
  }
  sg_work_edge copy = *crossed; /* entering a vertex may move it */
  int32_t x = cross_ex(handle, work, id[0], id[1], a, &copy);

  return x != SG_WORK_NONE && PL_unify_integer(out, sg_work_id(work, x));
}

/* ---- splits found while entering ---- */

/* The point of a name; model vertices become points when they are asked for.
 * SG_NO_KEY: an exception. */
static uint32_t
get_point_ex(sg_cut_handle *handle, int32_t s, term_t v)
{
  int32_t name;

  if (!sg_get_id_ex(v, &name)) {
    return SG_NO_KEY;
  }
  uint32_t point = sg_cut_points_named(&handle->set.points, s, name);
  uint32_t number = sg_cut_model_fetch(&handle->set.model, s, name);

  if (point == SG_NO_KEY && number != SG_NO_KEY) {
    sg_made made = {1, {{SG_AT_VERTEX, number, 0}}};
    point = sg_cut_points_find(&handle->set.points, &made);
  }
  if (point == SG_NO_KEY) {
    PL_existence_error("vertex", v);
  }
  return point;
}

static int
get_points_ex(term_t t, term_t s, term_t v1, term_t v2, sg_cut_handle **handle,
              int32_t *segment, uint32_t point[2])
{
  if (!sg_get_cut_set_ex(t, handle) || !sg_get_id_ex(s, segment)) {
    return FALSE;
  }
  point[0] = get_point_ex(*handle, *segment, v1);
  if (point[0] == SG_NO_KEY) {
    return FALSE;
  }
  point[1] = get_point_ex(*handle, *segment, v2);
  return point[1] != SG_NO_KEY;
}

static foreign_t
cut_note(term_t t, term_t s, term_t v1, term_t v2, term_t x)
{
  sg_cut_handle *handle;
  int32_t segment;
  uint32_t point[2];

  if (!get_points_ex(t, s, v1, v2, &handle, &segment, point)) {
    return FALSE;
  }
  uint32_t middle = get_point_ex(handle, segment, x);

  return middle != SG_NO_KEY &&
         (sg_cut_set_split(&handle->set, point[0], point[1], middle) ||
          sg_no_memory());
}

static foreign_t
cut_between(term_t t, term_t work_term, term_t s, term_t v1, term_t v2,
            term_t out)
{
  sg_cut_handle *handle;
  sg_work *work;
  int32_t segment;
  uint32_t point[2];

  if (!get_points_ex(t, s, v1, v2, &handle, &segment, point) ||
      !sg_get_work_ex(work_term, &work)) {
    return FALSE;
  }
  uint32_t middle = sg_cut_set_between(&handle->set, point[0], point[1]);

  if (middle == SG_NO_KEY) {
    return FALSE;
  }
  int32_t x = sg_cut_enter_point_ex(handle, work, middle, segment);

  return x != SG_WORK_NONE && PL_unify_integer(out, sg_work_id(work, x));
}

/* The point of an edge's end, SG_NO_KEY: it is none. */
static uint32_t
end_of(const sg_cut_handle *handle, const sg_work *work, int32_t s,
       int32_t vertex)
{
  return sg_cut_points_named(&handle->set.points, s, sg_work_id(work, vertex));
}

static foreign_t
cut_divided(term_t t, term_t work_term, term_t s, term_t list)
{
  sg_cut_handle *handle;
  sg_work *work;
  int32_t segment;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_id_ex(s, &segment) ||
      !sg_get_work_ex(work_term, &work)) {
    return FALSE;
  }
  if (handle->set.late.n == 0) { /* mostly nothing was divided anywhere */
    return PL_unify_nil(tail);
  }
  for (int32_t e = sg_work_next(work, 0); e; e = sg_work_next(work, e)) {
    const sg_work_edge *edge = sg_work_get(work, e);
    uint32_t a = end_of(handle, work, segment, edge->start);
    uint32_t b = end_of(handle, work, segment, edge->end);
    uint32_t middle = a == SG_NO_KEY || b == SG_NO_KEY
                          ? SG_NO_KEY
                          : sg_cut_set_between(&handle->set, a, b);

    if (middle == SG_NO_KEY) {
      continue;
    }
    int32_t x = sg_cut_enter_point_ex(handle, work, middle, segment);

    if (x == SG_WORK_NONE || !PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR_CHARS, "-", 2, PL_INT, e, PL_INT,
                       sg_work_id(work, x))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static const PL_extension predicates[] = {
    {"cut_crossing", 8, cut_crossing, 0},
    {"cut_note", 5, cut_note, 0},
    {"cut_between", 6, cut_between, 0},
    {"cut_divided", 4, cut_divided, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_split(void)
{
  PL_register_extensions_in_module("sg_kernel_penetration", predicates);
}
