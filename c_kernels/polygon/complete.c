/* complete.c -- planes and triangles for whole segments: see complete.h. */
#include "complete_private.h"

#include "engine/list.h"
#include "flatness.h"
#include "plane.h"
#include "ring_ears.h"
#include "rows/by_segment.h"
#include "rows/key_table.h"
#include "triangulate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is flat depends on the size of the whole model, which is at least that
 * of what is read: most often nobody needs to ask. */
static double
flat_reach(sg_completed_model *m)
{
  if (!m->asked) {
    m->asked = true;
    m->stopped = !m->in->see(m->in->of, &m->whole) || m->stopped;
  }
  return sg_flatness_flat(&m->whole);
}

/* ---- one polygon -------------------------------------------------------- */

/* A polygon with its edges' vertices, and scratch that is used again. */
typedef struct task {
  sg_completed_model *model;
  sg_completion *out;
  const sg_cancel *cancel;
  sg_key_table counts; /* triangles a segment */
  int32_t s, p;
  bool needs_plane, needs_triangles;
  size_t n, room;
  const sg_completed_edge **e;
  const sg_completed_vertex **start, **end; /* [n] */
  sg_plane plane;
  double off;     /* the farthest that a vertex is off the plane */
  double seen[3]; /* along which it is divided: the plane's normal, mostly */
  sg_work *work;
  sg_work_guard guard;
  size_t spare; /* steps that polygons may take beyond what their size gives */
  sg_triangles found;
  bool folded; /* the triangles of this polygon were found otherwise than along
                  its normal */
  bool stopped;
} task;

static bool
fault(task *t, sg_fault_kind kind, int32_t a, int32_t b, double size)
{
  return sg_complete_add_fault(
      t->out, &(sg_polygon_fault){t->s, t->p, kind, a, b, size});
}

static bool
make_room(task *t, size_t n)
{
  size_t of_e = t->room, of_start = of_e; /* the room of all three */

  return sg_list_need(&t->e, n, &of_e, sizeof *t->e) &&
         sg_list_need(&t->start, n, &of_start, sizeof *t->start) &&
         sg_list_need(&t->end, n, &t->room, sizeof *t->end);
}

/* Looks its edges and vertices up. */
static bool
look_up(task *t, const int32_t *list)
{
  sg_completed_model *m = t->model;

  t->n = (size_t)list[0];
  if (!make_room(t, t->n)) {
    return false;
  }
  sg_complete_look_up(m, &m->edges, &m->vertices, t->s, list, t->e, t->start,
                      t->end);
  return true;
}

static bool
is_ring_of_three(const task *t)
{
  return t->n == 3 && sg_complete_third(t->start, t->end) != NULL;
}

static bool
fill_work(task *t)
{
  if (!t->work && !(t->work = sg_work_open(t->seen))) {
    return false;
  }
  sg_work_guard_by(t->work, &t->guard);
  sg_work_clear(t->work, t->seen);
  for (size_t i = 0; i < t->n; i++) {
    sg_point start, end;
    if (sg_cancel_every(t->cancel, i + 1)) {
      t->stopped = true;
      return false;
    }
    sg_point_set(&start, t->start[i]->p);
    sg_point_set(&end, t->end[i]->p);
    int32_t a = sg_work_vertex(t->work, t->start[i]->id, &start);
    int32_t b = sg_work_vertex(t->work, t->end[i]->id, &end);
    if (a < 0 || b < 0 || !sg_work_add(t->work, a, b, 1, t->e[i]->id)) {
      return false;
    }
  }
  return true;
}

/* The edge that got stuck first, as ids. */
static void
name_edge(const task *t, int32_t stuck, int32_t out[2])
{
  const sg_work_edge *bad = sg_work_get(t->work, stuck);

  out[0] = sg_work_id(t->work, bad->start);
  out[1] = sg_work_id(t->work, bad->end);
}

/* With contacts taken exactly; if that gets stuck, once more with those that
 * rounding may have opened. */
static sg_outcome
find_triangles(task *t, int32_t bad[2])
{
  sg_outcome outcome = SG_STUCK;
  int32_t stuck;

  for (int i = 0; i < 2 && outcome == SG_STUCK; i++) {
    if ((i > 0 && !fill_work(t)) ||
        !sg_work_resolve(t->work, i > 0 ? flat_reach(t->model) : 0) ||
        sg_work_ended(t->work) != SG_GOES_ON) {
      return sg_work_outcome(t->work);
    }
    if (sg_work_all_apart(t->work)) {
      t->guard.most = SIZE_MAX; /* it is a shape as others are */
    }
    t->found.n = 0;
    outcome = sg_work_triangulate(t->work, &t->found, &stuck, t->cancel);
    if (outcome == SG_STUCK && i == 0) {
      name_edge(t, stuck, bad);
      i += sg_work_crossed_by_far(t->work, flat_reach(t->model));
    }
  }
  return outcome;
}

/* Whether it is off its plane by more than counts as flat. */
static bool
is_bent(const task *t)
{
  return t->n > 3 && t->off > sg_flatness_flat(&t->model->own) &&
         t->off > flat_reach(t->model);
}

/* Looks along the axis of which the normal has the largest part, the next, and
 * the least (0, 1, 2); 3: along the normal. False: it has no such part. */
static bool
look_along(task *t, int rank)
{
  const double *n = t->plane.n;
  int axis[3] = {0, 1, 2};

  for (int i = 0; i < 3; i++) {
    for (int j = i + 1; j < 3; j++) {
      if (fabs(n[axis[j]]) > fabs(n[axis[i]])) {
        int swap = axis[i];
        axis[i] = axis[j];
        axis[j] = swap;
      }
    }
  }
  for (int k = 0; k < 3; k++) {
    t->seen[k] = rank == 3 || axis[rank] == k ? n[k] : 0;
  }
  return rank == 3 || n[axis[rank]] != 0;
}

/* A ring of n edges has n - 2 triangles. A bent one may have fewer, or get
 * stuck, where parts of it are seen edge-on: then along another axis. */
static sg_outcome
find_all_triangles(task *t, int32_t bad[2])
{
  sg_outcome outcome = find_triangles(t, bad);
  bool bent = is_bent(t);

  for (int rank = 1; bent && rank <= 3; rank++) {
    bool missing = outcome == SG_DONE && t->found.n + 2 < t->n;
    if (!missing && outcome != SG_STUCK) {
      break;
    }
    if (!look_along(t, rank)) {
      continue;
    }
    if (!fill_work(t)) {
      return SG_NO_SPACE;
    }
    t->folded = true;
    outcome = find_triangles(t, bad);
  }
  return outcome;
}

static bool
is_missing_some(const task *t)
{
  return t->found.n + 2 < t->n && is_bent(t);
}

/* Whether it is a quadrangle that is not flat: it is two triangles, also where
 * these fold over, so that it crosses itself however it is seen. */
static bool
is_bent_quadrangle(const task *t)
{
  return t->n == 4 && is_bent(t);
}

/* A ring that is seen edge-on along each axis, or crosses itself; *done tells
 * if it is one. */
static bool
triangulate_in_space(task *t, bool *done)
{
  sg_ring_edge *ring = malloc(t->n * sizeof *ring);
  int32_t(*triangle)[3] = malloc(t->n * sizeof *triangle);
  bool ok = ring && triangle;

  for (size_t i = 0; ok && i < t->n; i++) {
    ring[i] = (sg_ring_edge){t->start[i]->id, t->end[i]->id, t->start[i]->p};
  }
  *done = false;
  ok = ok && sg_ring_ears(ring, t->n, triangle, done);
  for (size_t i = 0; ok && *done && i < t->n - 2; i++) {
    ok = sg_complete_add_triangle(&t->out->triangles, &t->counts, t->s, t->p,
                                  triangle[i]);
  }
  t->folded = t->folded || *done;
  free(ring);
  free(triangle);
  return ok;
}

static bool
triangulate(task *t)
{
  int32_t bad[2] = {0, 0};
  bool done = false;

  switch (find_all_triangles(t, bad)) {
  case SG_DONE:
    if (is_missing_some(t)) {
      bool ok = triangulate_in_space(t, &done);
      if (!ok || done) {
        return ok;
      }
    }
    break;
  case SG_STUCK:
    if (is_bent_quadrangle(t)) {
      bool ok = triangulate_in_space(t, &done);
      if (!ok || done) {
        return ok;
      }
    }
    return fault(t, SG_FAULT_EDGE, bad[0], bad[1], 0);
  case SG_TOO_MUCH:
    return fault(t, SG_FAULT_TANGLED, 0, 0, 0);
  case SG_STOPPED:
    t->stopped = true;
    return false;
  case SG_NO_SPACE:
    return false;
  }
  for (size_t i = 0; i < t->found.n; i++) {
    int32_t v[3];
    for (int k = 0; k < 3; k++) {
      v[k] = sg_work_id(t->work, t->found.item[i].v[k]);
    }
    if (!sg_complete_add_triangle(&t->out->triangles, &t->counts, t->s, t->p,
                                  v)) {
      return false;
    }
  }
  return true;
}

static bool
note_bent(task *t)
{
  return !is_bent(t) || fault(t, SG_FAULT_BENT, 0, 0, t->off);
}

/* Its plane: false if it has none. */
static bool
find_plane(task *t)
{
  sg_newell sum;

  sg_newell_init(&sum);
  for (size_t i = 0; i < t->n; i++) {
    sg_newell_edge(&sum, t->start[i]->p, t->end[i]->p);
  }
  bool flat = sg_newell_plane(&sum, &t->plane);
  if (!flat) {
    t->plane = (sg_plane){{0, 0, 1}, 0};
  }
  t->off = 0;
  for (size_t i = 0; flat && t->n > 3 && i < t->n; i++) {
    t->off = fmax(t->off, fabs(sg_plane_distance(&t->plane, t->start[i]->p)));
  }
  return look_along(t, 3) && flat;
}

/* One vertex at which it does not close, an id, or 0. */
static bool
find_gap(task *t, int32_t *gap)
{
  *gap = 0;
  if (is_ring_of_three(t)) {
    return true;
  }
  if (!fill_work(t)) {
    return false;
  }
  int32_t open = sg_work_unbalanced(t->work);
  *gap = open == SG_WORK_NONE ? 0 : sg_work_id(t->work, open);
  return true;
}

/* Where few contacts are to be resolved. */
static size_t
steps_of(size_t corners)
{
  return 16 * corners * (size_t)(1 + ilogb((double)corners + 1));
}

static void
begin_steps(task *t)
{
  t->guard =
      (sg_work_guard){.cancel = t->cancel, .most = t->spare + steps_of(t->n)};
}

static void
end_steps(task *t)
{
  size_t of_size = steps_of(t->n), steps = t->guard.steps;
  size_t beyond = steps > of_size ? steps - of_size : 0;

  t->spare -= beyond < t->spare ? beyond : t->spare;
}

static bool
do_polygon(task *t)
{
  int32_t gap;
  bool flat = find_plane(t);

  if (!find_gap(t, &gap)) {
    return false;
  }
  if (gap) {
    return fault(t, SG_FAULT_OPEN, gap, 0, 0);
  }
  if (!flat) {
    return fault(t, SG_FAULT_NO_AREA, 0, 0, 0);
  }
  if (t->needs_plane &&
      (!sg_complete_add_plane(&t->out->planes, t->s, t->p, &t->plane) ||
       !note_bent(t))) {
    return false;
  }
  if (!t->needs_triangles) {
    return true;
  }
  t->folded = false;
  begin_steps(t);
  bool good = (t->n > 3 || fill_work(t)) && triangulate(t) &&
              (!t->folded || fault(t, SG_FAULT_FOLDED, 0, 0, 0));

  end_steps(t);
  return good;
}

/* ---- all polygons ------------------------------------------------------- */

enum { POLYGONS_AN_ASK = 256, MANY = 1 << 14 /* worth several threads */ };

/* The polygon of one row, if something of it is missing. */
static bool
do_row(task *t, const sg_found_triangle *triangle, const int32_t *list)
{
  t->needs_plane = triangle->needs_plane;
  t->needs_triangles = triangle->needs_triangles;
  if (triangle->found) {
    return (!t->needs_plane || sg_complete_add_plane(&t->out->planes, t->s,
                                                     t->p, &triangle->plane)) &&
           (!t->needs_triangles ||
            sg_complete_add_triangle(&t->out->triangles, &t->counts, t->s, t->p,
                                     triangle->v));
  }
  return (!t->needs_plane && !t->needs_triangles) ||
         (look_up(t, list) && do_polygon(t) && !t->model->stopped);
}

static bool
do_page(task *t, const sg_view *view, size_t i,
        const sg_found_triangle *triangle)
{
  size_t n = 0;

  SG_EACH_ROW(view, i, r)
  {
    if (++n % POLYGONS_AN_ASK == 0 && sg_cancelled(t->cancel)) {
      t->stopped = true;
      return false;
    }
    t->s = sg_int_at(view, 0, i, r);
    t->p = sg_int_at(view, 1, i, r);
    if (!do_row(t, &triangle[r], view->column[2].page[i].list[r])) {
      return false;
    }
  }
  return true;
}

static bool
do_polygons(task *t, const sg_view *view, sg_pool *pool)
{
  size_t some = view->pages < SG_FIND_PAGES ? view->pages : SG_FIND_PAGES;
  sg_found_triangle *triangle =
      malloc((some * SG_PAGE_ROWS + 1) * sizeof *triangle);
  bool good = triangle != NULL;

  for (size_t i = 0; i < view->pages && good; i += some) {
    size_t n = view->pages - i < some ? view->pages - i : some;

    good = sg_complete_find_triangles(t->model, i, n, pool, triangle);
    t->stopped = !good;
    for (size_t k = 0; k < n && good; k++) {
      good = do_page(t, view, i + k, triangle + k * SG_PAGE_ROWS);
    }
  }
  free(triangle);
  return good;
}

static bool
complete(const sg_completion_input *in, task *t)
{
  sg_completed_model *m = t->model;
  bool done = sg_complete_read(in, m) &&
              do_polygons(t, in->p, m->edges.n < MANY ? NULL : in->pool);

  sg_complete_forget(m);
  return done;
}

/* The rows of the segments that are to be completed. */
static bool
complete_some(const sg_completion_input *in, task *t)
{
  const sg_view *const all[] = {in->v, in->e, in->p, in->plane, in->t};
  sg_view some[5] = {{0}};
  sg_completion_input of = {&some[0], &some[1], &some[2], &some[3],
                            &some[4], NULL,     0,        in->contacts,
                            in->see,  in->of,   in->pool};
  bool good = true;

  for (int k = 0; k < 5 && good; k++) {
    good = sg_segment_view_make(all[k], in->segment, in->segments, &some[k]);
  }
  good = good && complete(&of, t);
  for (int k = 0; k < 5; k++) {
    sg_segment_view_clear(&some[k]);
  }
  return good;
}

bool
sg_complete(const sg_completion_input *in, sg_completion *out, bool *stopped,
            const sg_cancel *cancel)
{
  sg_completed_model m = {.cancel = cancel};
  task t = {.model = &m, .out = out, .cancel = cancel, .spare = in->contacts};

  *out = (sg_completion){0};
  sg_key_table_init(&t.counts, 1);
  bool done = in->segment ? complete_some(in, &t) : complete(in, &t);
  *stopped = t.stopped || m.stopped;
  sg_key_table_clear(&t.counts);
  sg_work_close(t.work);
  free(t.found.item);
  free(t.e);
  free(t.start);
  free(t.end);
  return done;
}
