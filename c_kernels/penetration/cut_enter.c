#include "cut_enter.h"
#include "engine/list.h"

#include <stdlib.h>
#include <string.h>

/* ---- outlines ---- */

bool
sg_outlines_add(sg_outlines *all, int32_t s, int32_t p, const double normal[3])
{
  bool good =
      sg_list_grow(&all->polygon, all->n, &all->room, sizeof *all->polygon);

  if (good) {
    all->polygon[all->n++] =
        (sg_outline){s, p, {normal[0], normal[1], normal[2]}, all->edges, 0};
  }
  return good;
}

bool
sg_outlines_add_edge(sg_outlines *all, const sg_outline_edge *edge)
{
  bool good =
      sg_list_grow(&all->edge, all->edges, &all->edge_room, sizeof *all->edge);

  if (good) {
    all->edge[all->edges++] = *edge;
    all->polygon[all->n - 1].n++;
  }
  return good;
}

void
sg_outlines_clear(sg_outlines *all)
{
  free(all->polygon);
  free(all->edge);
  *all = (sg_outlines){0};
}

/* ---- vertices ---- */

/* An outline on its way into a work. */
typedef struct entering {
  const sg_cut_set *set;
  sg_work *work;
  int32_t s;
  sg_outcome outcome;
} entering;

bool
sg_cut_is_in_work(const void *work, int32_t v)
{
  return sg_work_find(work, v) != SG_WORK_NONE;
}

/* The name that a point has in segment s, of several the one that `work` has;
 * 0: none. */
static int32_t
name_in_work(const sg_cut_set *set, const sg_work *work, uint32_t point,
             int32_t s)
{
  return sg_cut_points_good_name(&set->points, point, s, sg_cut_is_in_work,
                                 work);
}

static int32_t
enter_place(entering *in, int32_t name, const sg_point *at)
{
  int32_t vertex = sg_work_vertex(in->work, name, at);

  if (vertex == SG_WORK_NONE) {
    in->outcome = SG_NO_SPACE;
  }
  return vertex;
}

/* The handle of a point of the set; SG_WORK_NONE: see in->outcome. */
static int32_t
enter_point(entering *in, uint32_t point)
{
  int32_t name = name_in_work(in->set, in->work, point, in->s);

  if (name == 0) {
    in->outcome = SG_STUCK;
    return SG_WORK_NONE;
  }
  return enter_place(in, name, &in->set->points.point[point].at);
}

static bool
place_of(const sg_cut_model *model, int32_t s, int32_t v, double at[3])
{
  uint32_t number = sg_cut_model_find(model, s, v);

  if (number == SG_NO_KEY) {
    return model->fetch && model->fetch(model->fetch_data, s, v, at);
  }
  memcpy(at, model->vertex[number].at, sizeof model->vertex[number].at);
  return true;
}

/* The handle of a vertex of the model. */
static int32_t
enter_vertex(entering *in, int32_t v)
{
  double place[3];
  sg_point at;

  if (!place_of(&in->set->model, in->s, v, place)) {
    in->outcome = SG_STUCK;
    return SG_WORK_NONE;
  }
  sg_point_set(&at, place);
  return enter_place(in, v, &at);
}

/* ---- edges ---- */

const sg_split_edge *
sg_cut_split_edge(const sg_cut_set *set, int32_t s, int32_t v1, int32_t v2)
{
  uint32_t a = sg_cut_model_find(&set->model, s, v1);
  uint32_t b = sg_cut_model_find(&set->model, s, v2);
  uint32_t key[2] = {a < b ? a : b, a < b ? b : a};
  uint32_t number = sg_key_table_get(&set->edge_number, key);

  return number == SG_NO_KEY ? NULL : &set->edge[number];
}

/* The points on an edge that came last, in n + 1 pieces: they are exactly on
 * it, except for those that it has from polygons which are not quite flat. */
static void
note_points(sg_work *work, int32_t n)
{
  int32_t last = sg_work_newest(work);
  int32_t start = sg_work_get(work, last - n)->start;
  int32_t end = sg_work_get(work, last)->end;

  for (int32_t e = last - n; e < last && start != end; e++) {
    sg_work_note_along(work, sg_work_get(work, e)->end, start, end);
  }
}

/* Adds one edge in the pieces it is split into. False: see in->outcome. */
static bool
add_split_edge(entering *in, const sg_outline_edge *edge)
{
  const sg_split_edge *split =
      sg_cut_split_edge(in->set, in->s, edge->v1, edge->v2);
  size_t n = split ? split->n : 0;
  bool forward = n > 0 && in->set->model.vertex[split->place.a].v == edge->v1;
  int32_t from = enter_vertex(in, edge->v1), added = 0;

  for (size_t i = 0; i <= n && from != SG_WORK_NONE; i++) {
    int32_t to = i == n
                     ? enter_vertex(in, edge->v2)
                     : enter_point(in, split->point[forward ? i : n - 1 - i]);
    if (to == SG_WORK_NONE) {
      return false;
    }
    if (!sg_work_add(in->work, from, to, edge->et, edge->e)) {
      in->outcome = SG_NO_SPACE;
      return false;
    }
    added += from != to;
    from = to;
  }
  if (added > 1 && !split->late && from != SG_WORK_NONE) {
    note_points(in->work, added - 1);
  }
  return from != SG_WORK_NONE;
}

/* The ends of its pieces. */
static bool
enter_ends(entering *in, const sg_cut_polygon *polygon)
{
  const sg_cut_set *set = in->set;

  for (size_t i = 0; polygon && i < polygon->n; i++) {
    const sg_cut_piece *piece = &set->piece[set->entering[polygon->first + i]];

    if (enter_point(in, piece->a) == SG_WORK_NONE ||
        enter_point(in, piece->b) == SG_WORK_NONE) {
      return false;
    }
  }
  return true;
}

sg_outcome
sg_cut_enter_outline(const sg_cut_set *set, const sg_outlines *all, size_t i,
                     sg_work *work)
{
  const sg_outline *polygon = &all->polygon[i];
  const sg_cut_polygon *cut = sg_cut_set_polygon(set, polygon->s, polygon->p);
  size_t ends = cut ? 2 * cut->n : 0;
  entering in = {set, work, polygon->s, SG_DONE};

  if (!sg_work_expect(work, polygon->n + ends, polygon->n + 2 * ends)) {
    return SG_NO_SPACE;
  }
  for (size_t k = 0; k < polygon->n; k++) {
    if (!add_split_edge(&in, &all->edge[polygon->first + k])) {
      return in.outcome;
    }
  }
  (void)enter_ends(&in, cut);
  return in.outcome;
}

/* ---- pieces ---- */

/* Enters piece k of segment s into `work`: 1; 0 if it meets anything there, or
 * has been divided elsewhere; -1: no memory. */
static int
enter_piece(const sg_cut_set *set, sg_work *work, int32_t s, uint32_t k,
            sg_meetings *met)
{
  const sg_cut_piece *piece = &set->piece[k];
  int32_t v = sg_work_find(work, name_in_work(set, work, piece->a, s));
  int32_t w = sg_work_find(work, name_in_work(set, work, piece->b, s));

  if (v == SG_WORK_NONE || w == SG_WORK_NONE || v == w ||
      sg_cut_set_between(set, piece->a, piece->b) != SG_NO_KEY) {
    return 0;
  }
  if (!sg_work_meeting(work, v, w, met)) {
    return -1;
  }
  if (met->n > 0) {
    return 0;
  }
  return sg_work_add(work, v, w, 1, -1 - (int64_t)k) &&
                 sg_work_add(work, w, v, 1, -1 - (int64_t)k)
             ? 1
             : -1;
}

/* Takes out what was added after edge `last`. */
static void
take_out_after(sg_work *work, int32_t last)
{
  for (int32_t e = sg_work_newest(work); e > last; e--) {
    if (sg_work_get(work, e)) {
      sg_work_delete(work, e);
    }
  }
}

int
sg_cut_enter_free(const sg_cut_set *set, sg_work *work, int32_t s, int32_t p,
                  sg_meetings *met)
{
  const sg_cut_polygon *polygon = sg_cut_set_polygon(set, s, p);
  int32_t last = sg_work_newest(work);
  int entered = 1;

  for (size_t i = 0; polygon && i < polygon->n && entered > 0; i++) {
    entered = enter_piece(set, work, s, set->entering[polygon->first + i], met);
  }
  if (entered <= 0) {
    take_out_after(work, last);
  }
  return entered;
}
