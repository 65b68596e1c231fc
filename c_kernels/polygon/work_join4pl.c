/* work_join4pl.c -- the scratch relation of one polygon, as predicates: its
 * edges, what meets a segment, third vertices, triangles.
 *
 * Layer: glue. Doors in rules/kernel/work.pl. Vertices are named by their ids.
 */
#include "engine/install.h"
#include "engine/world4pl.h"

#include "work4pl.h"

#include "delaunay.h"
#include "glue.h"
#include "triangulate.h"

#include <stdlib.h>
#include <string.h>

/* ---- edges -------------------------------------------------------------- */

/* work_edge(+Work, ?E, ?V1, ?V2, ?Et, ?Label) */
typedef struct edge_walk {
  sg_work *work;
  int32_t v1, v2;     /* handles, SG_WORK_NONE: any */
  int32_t at, newest; /* the next one, 0: none; later ones are not seen */
} edge_walk;

static int32_t
step(const edge_walk *w, int32_t edge)
{
  if (w->v1 != SG_WORK_NONE) {
    return sg_work_leaving(w->work, w->v1, edge);
  }
  return w->v2 != SG_WORK_NONE ? sg_work_entering(w->work, w->v2, edge)
                               : sg_work_next(w->work, edge);
}

/* The first one from `edge` on that lives and fits. */
static int32_t
fitting(const edge_walk *w, int32_t edge)
{
  for (; edge && edge <= w->newest; edge = step(w, edge)) {
    const sg_work_edge *row = sg_work_get(w->work, edge);
    if (row && (w->v2 == SG_WORK_NONE || row->end == w->v2)) {
      return edge;
    }
  }
  return 0;
}

/* The handle of V, SG_WORK_NONE for a variable; FALSE with *known false: there
 * is no such vertex, so the goal fails. */
static int
get_end_ex(sg_work *work, term_t t, int32_t *out, bool *known)
{
  int32_t id;

  *out = SG_WORK_NONE;
  if (PL_is_variable(t)) {
    return TRUE;
  }
  if (!sg_get_id_ex(t, &id)) {
    return FALSE;
  }
  *out = sg_work_find(work, id);
  *known = *known && *out != SG_WORK_NONE;
  return TRUE;
}

static int
unify_edge(term_t a0, const sg_work *work, int32_t e)
{
  const sg_work_edge *row = sg_work_get(work, e);

  return row && PL_unify_integer(a0 + 1, e) &&
         PL_unify_integer(a0 + 2, sg_work_id(work, row->start)) &&
         PL_unify_integer(a0 + 3, sg_work_id(work, row->end)) &&
         PL_unify_integer(a0 + 4, row->et) &&
         PL_unify_int64(a0 + 5, row->label);
}

/* The next solution; keeps the walk when there may be more. */
static foreign_t
next_edge(term_t a0, edge_walk *w, edge_walk *kept)
{
  for (int32_t e; (e = w->at) != 0;) {
    w->at = fitting(w, step(w, e));
    fid_t frame = PL_open_foreign_frame();
    int ok = frame && unify_edge(a0, w->work, e);
    if (!ok && frame) {
      PL_rewind_foreign_frame(frame);
    }
    PL_close_foreign_frame(frame);
    if (ok) {
      if (!w->at) {
        break;
      }
      if (!kept && !(kept = malloc(sizeof *kept))) {
        return sg_no_memory();
      }
      *kept = *w;
      PL_retry_address(kept);
    }
    if (PL_exception(0) || !w->at) {
      free(kept);
      return FALSE;
    }
  }
  free(kept);
  return TRUE;
}

static foreign_t
work_edge(term_t a0, int arity, void *context)
{
  control_t h = context;
  edge_walk w = {.newest = INT32_MAX}, *kept;
  bool known = true;

  (void)arity;
  switch (PL_foreign_control(h)) {
  case PL_FIRST_CALL:
    break;
  case PL_REDO:
    kept = PL_foreign_context_address(h);
    w = *kept;
    if (!sg_get_work_ex(a0, &w.work)) { /* closed meanwhile */
      free(kept);
      return FALSE;
    }
    return next_edge(a0, &w, kept);
  default:
    free(PL_foreign_context_address(h));
    return TRUE;
  }
  if (!sg_get_work_ex(a0, &w.work)) {
    return FALSE;
  }
  if (!PL_is_variable(a0 + 1)) {
    int32_t e;
    return sg_get_id_ex(a0 + 1, &e) && unify_edge(a0, w.work, e);
  }
  if (!get_end_ex(w.work, a0 + 2, &w.v1, &known) ||
      !get_end_ex(w.work, a0 + 3, &w.v2, &known) || !known) {
    return FALSE;
  }
  w.newest = sg_work_newest(w.work);
  w.at = w.v1 != SG_WORK_NONE && w.v2 != SG_WORK_NONE
             ? sg_work_pair(w.work, w.v1, w.v2)
             : fitting(&w, step(&w, 0));
  return w.at ? next_edge(a0, &w, NULL) : FALSE; /* no &&: not a truth value */
}

/* work_oldest(+Work, -E, -V1, -V2) is semidet. */
static foreign_t
work_oldest(term_t work_term, term_t e, term_t v1, term_t v2)
{
  sg_work *work;

  if (!sg_get_work_ex(work_term, &work)) {
    return FALSE;
  }
  int32_t edge = sg_work_next(work, 0);
  if (!edge) {
    return FALSE;
  }
  const sg_work_edge *row = sg_work_get(work, edge);
  return PL_unify_integer(e, edge) &&
         PL_unify_integer(v1, sg_work_id(work, row->start)) &&
         PL_unify_integer(v2, sg_work_id(work, row->end));
}

/* ---- the joins ---------------------------------------------------------- */

enum { INSIDES = 8 };

static atom_t atom_how[4], atom_inside[INSIDES];

static int
unify_inside(term_t t, unsigned inside)
{
  term_t tail = PL_copy_term_ref(t), head = PL_new_term_ref();

  for (int i = 0; i < INSIDES; i++) {
    if (inside & (1u << i) && (!PL_unify_list(tail, head, tail) ||
                               !PL_unify_atom(head, atom_inside[i]))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

typedef struct meeting_walk {
  sg_meetings met;
  size_t next;
} meeting_walk;

static void
meeting_walk_close(meeting_walk *w)
{
  sg_meetings_clear(&w->met);
  free(w);
}

static foreign_t
next_meeting(term_t a0, meeting_walk *w)
{
  while (w->next < w->met.n) {
    const sg_meeting *m = &w->met.item[w->next++];
    fid_t frame = PL_open_foreign_frame();
    int ok = frame && PL_unify_integer(a0 + 3, m->edge) &&
             PL_unify_atom(a0 + 4, atom_how[m->how]) &&
             unify_inside(a0 + 5, m->inside);
    if (!ok && frame) {
      PL_rewind_foreign_frame(frame);
    }
    PL_close_foreign_frame(frame);
    if (ok && w->next < w->met.n) {
      PL_retry_address(w);
    }
    if (ok || PL_exception(0)) {
      meeting_walk_close(w);
      return ok;
    }
  }
  meeting_walk_close(w);
  return FALSE;
}

/* work_meeting(+Work, +V1, +V2, ?E, ?How, ?Inside) is nondet. */
static foreign_t
work_meeting(term_t a0, int arity, void *context)
{
  control_t h = context;
  sg_work *work;
  int32_t v[2];

  (void)arity;
  switch (PL_foreign_control(h)) {
  case PL_FIRST_CALL:
    break;
  case PL_REDO:
    return next_meeting(a0, PL_foreign_context_address(h));
  default:
    meeting_walk_close(PL_foreign_context_address(h));
    return TRUE;
  }
  if (!sg_get_work_ex(a0, &work) ||
      !sg_get_work_vertex_ex(work, a0 + 1, &v[0]) ||
      !sg_get_work_vertex_ex(work, a0 + 2, &v[1])) {
    return FALSE;
  }
  if (v[0] == v[1]) {
    return PL_domain_error("another_vertex", a0 + 2);
  }
  meeting_walk *w = calloc(1, sizeof *w);
  if (!w || !sg_work_meeting(work, v[0], v[1], &w->met)) {
    if (w) {
      meeting_walk_close(w);
    }
    return sg_no_memory();
  }
  return next_meeting(a0, w);
}

static void
candidates_free(sg_candidates *walk)
{
  sg_candidates_close(walk);
  free(walk);
}

/* Whether one more comes is not known before it is asked for: a choice point
 * stays. */
static foreign_t
next_candidate(term_t v3, sg_candidates *walk)
{
  for (int32_t v; (v = sg_candidates_next(walk)) != SG_WORK_NONE;) {
    if (PL_unify_integer(v3, sg_work_id(walk->work, v))) {
      PL_retry_address(walk);
    }
    if (PL_exception(0)) {
      break;
    }
  }
  bool no_memory = walk->no_memory;
  candidates_free(walk);
  return no_memory ? sg_no_memory() : FALSE;
}

/* work_candidate(+Work, +V1, +V2, ?V3) is nondet. */
static foreign_t
work_candidate(term_t a0, int arity, void *context)
{
  control_t h = context;
  sg_candidates *walk;
  sg_work *work;
  int32_t v[2];

  (void)arity;
  switch (PL_foreign_control(h)) {
  case PL_FIRST_CALL:
    break;
  case PL_REDO:
    walk = PL_foreign_context_address(h);
    if (!sg_get_work_ex(a0, &work)) {
      candidates_free(walk);
      return FALSE;
    }
    return next_candidate(a0 + 3, walk);
  default:
    candidates_free(PL_foreign_context_address(h));
    return TRUE;
  }
  if (!sg_get_work_ex(a0, &work) ||
      !sg_get_work_vertex_ex(work, a0 + 1, &v[0]) ||
      !sg_get_work_vertex_ex(work, a0 + 2, &v[1])) {
    return FALSE;
  }
  if (!(walk = malloc(sizeof *walk))) {
    return sg_no_memory();
  }
  sg_candidates_open(walk, work, v[0], v[1]);
  return next_candidate(a0 + 3, walk);
}

/* ---- the fused kernel --------------------------------------------------- */

static functor_t functor_t3, functor_minus2;

static int
unify_triangles(term_t list, const sg_work *work, const sg_triangles *found)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < found->n; i++) {
    const int32_t *v = found->item[i].v;
    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR, functor_t3, PL_INT,
                       sg_work_id(work, v[0]), PL_INT, sg_work_id(work, v[1]),
                       PL_INT, sg_work_id(work, v[2]))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* work_triangulate(+Work, -Triangles) is det. */
static foreign_t
work_triangulate(term_t work_term, term_t triangles)
{
  sg_triangles found = {0};
  sg_work *work;
  int32_t edge;
  int ok = FALSE;

  if (!sg_get_work_ex(work_term, &work)) {
    return FALSE;
  }
  switch (sg_work_triangulate(work, &found, &edge, &sg_prolog_poll)) {
  case SG_DONE:
  case SG_STUCK: /* the edges that are left tell */
    ok = unify_triangles(triangles, work, &found);
    break;
  case SG_STOPPED:
    break;
  case SG_NO_SPACE:
    ok = sg_no_memory();
    break;
  }
  free(found.item);
  return ok;
}

/* ---- thin triangles ---- */

/* Reads [V1-V2, ...], or [t(V1, V2, V3), ...], as handles; n numbers a term. */
static int
get_corners_ex(sg_work *work, term_t list, functor_t functor, int n,
               int32_t **out, size_t *count)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();

  if (PL_skip_list(list, 0, count) != PL_LIST) {
    return PL_type_error("list", list);
  }
  if (!(*out = malloc((*count + 1) * (size_t)n * sizeof **out))) {
    return sg_no_memory();
  }
  for (size_t i = 0; PL_get_list(tail, head, tail); i++) {
    if (!PL_is_functor(head, functor)) {
      return PL_type_error(n == 2 ? "pair" : "triangle", head);
    }
    for (int k = 0; k < n; k++) {
      if (!PL_get_arg(k + 1, head, arg) ||
          !sg_get_work_vertex_ex(work, arg,
                                 &(*out)[i * (size_t)n + (size_t)k])) {
        return FALSE;
      }
    }
  }
  return TRUE;
}

/* work_thicken(+Work, +Edges, +Triangles0, -Triangles) is det. */
static foreign_t
work_thicken(term_t work_term, term_t edges, term_t before, term_t after)
{
  sg_work *work;
  int32_t *edge = NULL, *corner = NULL;
  size_t n = 0;
  sg_triangles all = {0};
  int good = sg_get_work_ex(work_term, &work) &&
             get_corners_ex(work, edges, functor_minus2, 2, &edge, &n) &&
             get_corners_ex(work, before, functor_t3, 3, &corner, &all.n);

  if (good) {
    all.item = malloc((all.n + 1) * sizeof *all.item);
    good = all.item || sg_no_memory();
  }
  for (size_t i = 0; good && i < all.n; i++) {
    memcpy(all.item[i].v, corner + 3 * i, sizeof all.item[i].v);
  }
  if (good) {
    switch (sg_triangles_thicken(work, (const int32_t(*)[2])(void *)edge, n, 0,
                                 &all, &sg_prolog_poll)) {
    case SG_DONE:
      good = unify_triangles(after, work, &all);
      break;
    case SG_STUCK:
    case SG_STOPPED:
      good = FALSE;
      break;
    case SG_NO_SPACE:
      good = sg_no_memory();
      break;
    }
  }
  free(edge);
  free(corner);
  free(all.item);
  return good;
}

/* ---- registration ------------------------------------------------------- */

void
sg_install_work_join(void)
{
  static const char *const inside[INSIDES] = {
      "v1",          "v2",        "start",       "end",
      "v1_at_start", "v1_at_end", "v2_at_start", "v2_at_end"};
  static const int nondet = PL_FA_VARARGS | PL_FA_NONDETERMINISTIC;
  const PL_extension doors[] = {
      {"work_edge", 6, (pl_function_t)work_edge, nondet},
      {"work_oldest", 4, (pl_function_t)work_oldest, 0},
      {"work_meeting", 6, (pl_function_t)work_meeting, nondet},
      {"work_candidate", 4, (pl_function_t)work_candidate, nondet},
      {"work_triangulate", 2, (pl_function_t)work_triangulate, 0},
      {"work_thicken", 4, (pl_function_t)work_thicken, 0},
      {NULL, 0, NULL, 0}};

  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  functor_t3 = PL_new_functor(PL_new_atom("t"), 3);
  atom_how[SG_CROSSES] = PL_new_atom("crosses");
  atom_how[SG_TOUCHES] = PL_new_atom("touches");
  atom_how[SG_CONTAINED] = PL_new_atom("contained");
  atom_how[SG_OVERLAPS] = PL_new_atom("overlaps");
  for (int i = 0; i < INSIDES; i++) {
    atom_inside[i] = PL_new_atom(inside[i]);
  }
  PL_register_extensions_in_module("sg_kernel_work", doors);
}
