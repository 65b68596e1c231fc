/* complete4pl.c -- planes and triangles of whole segments, as a predicate.
 *
 * Layer: glue. Doors in rules/kernel/world.pl.
 */
#include "rows/append4pl.h"
#include "rows/grain_rows.h"
#include "rows/pattern_rows.h"

#include "engine/install.h"

#include "complete.h"
#include "crew.h"
#include "flatness.h"
#include "glue.h"
#include "rows/by_segment.h"

#include <math.h>
#include <pthread.h>
#include <stdlib.h>

static atom_t atom_not_closed, atom_no_area, atom_not_simple, atom_not_flat;
static functor_t functor_fault3, functor_not_closed1, functor_not_simple2,
    functor_not_flat1;

/* Views of the five relations, of one version. */
typedef struct views {
  const sg_version *version;
  sg_view view[5];
} views;

static const sg_relation READ[5] = {SG_V, SG_E, SG_P, SG_PLANE, SG_T};

static void
views_close(views *v)
{
  for (int i = 0; i < 5; i++) {
    sg_view_clear(&v->view[i]);
  }
  sg_version_drop(v->version);
}

static int
views_open_ex(views *v, sg_world *world)
{
  *v = (views){.version = sg_world_version(world)};
  for (int i = 0; i < 5; i++) {
    if (!sg_version_view(v->version, READ[i], &v->view[i])) {
      views_close(v);
      return sg_no_memory();
    }
  }
  return TRUE;
}

/* t counts from 0 in each segment: from its next fresh id instead. */
static int
number_triangles_ex(sg_world *world, sg_triangle_rows *rows)
{
  for (size_t i = 0; i < rows->n; i++) {
    int32_t s = rows->s[i];
    size_t last = i;
    if (rows->t[i] == 0) { /* its segment's first */
      if ((rows->t[i] = sg_fresh_ex(world, SG_T, s)) == 0) {
        return FALSE;
      }
      continue;
    }
    while (rows->s[--last] != s) {
    }
    rows->t[i] = rows->t[last] + 1;
  }
  return TRUE;
}

static int
add_rows_ex(sg_world *world, sg_completion *found)
{
  sg_plane_rows *p = &found->planes;
  sg_triangle_rows *t = &found->triangles;
  const void *const plane[] = {p->s, p->p, p->c[0], p->c[1], p->c[2], p->c[3]};
  const void *const triangle[] = {t->s, t->p, t->t, t->v[0], t->v[1], t->v[2]};

  return sg_append_columns_ex(world, SG_PLANE, p->n, plane) &&
         number_triangles_ex(world, t) &&
         sg_append_columns_ex(world, SG_T, t->n, triangle);
}

static int
put_what(term_t what, const sg_polygon_fault *f)
{
  switch (f->kind) {
  case SG_FAULT_OPEN:
    return PL_unify_term(what, PL_FUNCTOR, functor_not_closed1, PL_INT, f->a);
  case SG_FAULT_NO_AREA:
    return PL_unify_atom(what, atom_no_area);
  case SG_FAULT_EDGE:
    return PL_unify_term(what, PL_FUNCTOR, functor_not_simple2, PL_INT, f->a,
                         PL_INT, f->b);
  case SG_FAULT_BENT:
    return PL_unify_term(what, PL_FUNCTOR, functor_not_flat1, PL_FLOAT,
                         f->size);
  }
  return FALSE;
}

static int
unify_faults(term_t list, const sg_completion *found)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref(),
         what = PL_new_term_ref();

  for (size_t i = 0; i < found->faults; i++) {
    const sg_polygon_fault *f = &found->fault[i];
    PL_put_variable(what);
    if (!put_what(what, f) || !PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR, functor_fault3, PL_INT, f->s, PL_INT,
                       f->p, PL_TERM, what)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* In a world that is claimed: what is missing stays so until it is added. */
static int
complete_ex(sg_world *world, const int32_t *segment, size_t segments,
            term_t faults)
{
  sg_completion found;
  views v;
  double grain;
  bool stopped;

  if (!views_open_ex(&v, world)) {
    return FALSE;
  }
  if (!sg_grain_of_all(v.version, &grain)) {
    views_close(&v);
    return sg_no_memory();
  }
  const sg_completion_input in = {&v.view[0], &v.view[1], &v.view[2],
                                  &v.view[3], &v.view[4], segment,
                                  segments,   grain};
  int ok = sg_complete(&in, &found, &stopped, &sg_prolog_poll);
  views_close(&v);
  ok = ok ? add_rows_ex(world, &found) && unify_faults(faults, &found)
          : !stopped && sg_no_memory();
  sg_completion_clear(&found);
  return ok;
}

static int
fill_ex(const int32_t *segment, size_t segments, term_t faults)
{
  sg_world *world = sg_current_world_ex();

  if (!world || !sg_claim_ex(world)) {
    return FALSE;
  }
  int ok = complete_ex(world, segment, segments, faults);
  sg_world_release(world);
  return ok;
}

/* fill_triangles(-Faults) is det. */
static foreign_t
fill_triangles(term_t faults)
{
  return fill_ex(NULL, 0, faults);
}

/* fill_triangles(+Ss, -Faults) is det. */
static foreign_t
fill_triangles_of(term_t list, term_t faults)
{
  int32_t *segment;
  size_t n;

  if (!sg_get_id_set_ex(list, &segment, &n)) {
    return FALSE;
  }
  int ok = n > 0 ? fill_ex(segment, n, faults) : PL_unify_nil(faults);

  free(segment);
  return ok;
}

/* ---- the tolerance ---- */

enum { ASKED = 64 }; /* pages between questions */

/* The last tolerance of a world, and the vertices it is of: its note
 * SG_NOTE_TOLERANCE. */
typedef struct kept_tolerance {
  pthread_mutex_t lock;
  uint64_t stamp; /* 0: none yet */
  double tolerance;
} kept_tolerance;

static void
drop_tolerance(void *note)
{
  kept_tolerance *kept = note;

  pthread_mutex_destroy(&kept->lock);
  free(kept);
}

/* Null: no memory, and nothing is kept. */
static kept_tolerance *
tolerance_of(sg_world *world)
{
  kept_tolerance *kept = sg_world_note(world, SG_NOTE_TOLERANCE);
  kept_tolerance *there;

  if (kept || !(kept = calloc(1, sizeof *kept))) {
    return kept;
  }
  pthread_mutex_init(&kept->lock, NULL);
  there = sg_world_add_note(world, SG_NOTE_TOLERANCE, kept, drop_tolerance);
  if (there != kept) {
    drop_tolerance(kept);
  }
  return there;
}

/* Looks at every vertex but those of patterns. */
static int
see_tolerance_ex(const sg_version *version, double *out)
{
  sg_flatness flatness;
  sg_model_view view;
  double grain;

  if (!sg_model_view_make(version, SG_V, &view) ||
      !sg_grain_of_all(version, &grain)) {
    sg_model_view_clear(&view);
    return sg_no_memory();
  }
  sg_flatness_init(&flatness, grain);
  for (size_t i = 0; i < view.shown.pages; i++) {
    sg_flatness_page(&flatness, &view.shown, i);
    if (i % ASKED == ASKED - 1 && PL_handle_signals() < 0) {
      sg_model_view_clear(&view);
      return FALSE;
    }
  }
  sg_model_view_clear(&view);
  *out = sg_flatness_touch(&flatness);
  return TRUE;
}

/* model_tolerance(-Tolerance) is det. */
static foreign_t
model_tolerance(term_t tolerance)
{
  sg_world *world = sg_current_world_ex();

  if (!world) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  kept_tolerance *kept = tolerance_of(world);
  uint64_t stamp = sg_version_last_stamp(version, SG_V);
  double value = 0;
  bool known = false;

  if (kept) {
    pthread_mutex_lock(&kept->lock);
    known = stamp != 0 && kept->stamp == stamp;
    value = kept->tolerance;
    pthread_mutex_unlock(&kept->lock);
  }
  int ok = known || see_tolerance_ex(version, &value);

  if (ok && kept) {
    pthread_mutex_lock(&kept->lock);
    kept->stamp = stamp;
    kept->tolerance = value;
    pthread_mutex_unlock(&kept->lock);
  }
  sg_version_drop(version);
  return ok && sg_unify_double(tolerance, value);
}

enum { SEEN = 1 << 16 }; /* vertices between questions */

/* Segments that are seen, each a task. */
typedef struct seeing {
  const sg_view *view;
  const sg_segment_rows *rows;
  sg_flatness *of; /* [segments] */
} seeing;

static void
see_segment(void *data, size_t i)
{
  const seeing *all = data;
  const sg_column *column = all->view->column;

  for (size_t k = all->rows->begin[i]; k < all->rows->begin[i + 1]; k++) {
    size_t page = all->rows->row[k] / SG_PAGE_ROWS;
    size_t r = all->rows->row[k] % SG_PAGE_ROWS;

    if (k % SEEN == SEEN - 1 && sg_crew_stopping()) {
      return;
    }
    sg_flatness_see(&all->of[i], (const double[3]){column[2].page[page].f[r],
                                                   column[3].page[page].f[r],
                                                   column[4].page[page].f[r]});
  }
}

/* Of the n segments' own vertices, those of `rows`. */
static int
see_rows_ex(const sg_view *view, const sg_segment_rows *rows, size_t n,
            sg_flatness *of)
{
  seeing all = {view, rows, of};
  sg_crew *crew = rows->begin[n] < SEEN ? NULL : sg_crew_open(0);
  int good = sg_crew_run(crew, n, see_segment, &all, &sg_prolog_poll) ||
             (!PL_exception(0) && sg_no_memory());

  sg_crew_close(crew);
  return good;
}

/* One for each segment of the list: *out, [*n], to be freed. */
static int
see_segments_ex(term_t segments, sg_flatness **out, size_t *n)
{
  sg_world *world = sg_current_world_ex();
  sg_segment_rows rows = {0};
  sg_view view = {0};
  int32_t *s = NULL;

  *out = NULL;
  if (!world || !sg_get_id_set_ex(segments, &s, n)) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  *out = malloc((*n + 1) * sizeof **out);
  int good = (*out && sg_version_view(version, SG_V, &view)) || sg_no_memory();

  for (size_t i = 0; good && i < *n; i++) {
    sg_flatness_init(&(*out)[i], sg_grain_of(version, s[i]));
  }
  if (good && !sg_segment_rows_find(&view, s, *n, &sg_prolog_poll, &rows)) {
    good = PL_exception(0) ? FALSE : sg_no_memory();
  }
  good = good && see_rows_ex(&view, &rows, *n, *out);
  sg_segment_rows_clear(&rows);
  sg_view_clear(&view);
  sg_version_drop(version);
  free(s);
  return good;
}

/* segments_tolerance(+Segments, -Tolerance, -Smallest) is det. */
static foreign_t
segments_tolerance(term_t segments, term_t tolerance, term_t smallest)
{
  sg_flatness *of, all;
  size_t n;
  int good = see_segments_ex(segments, &of, &n);
  double least = HUGE_VAL;

  sg_flatness_init(&all, 0);
  for (size_t i = 0; good && i < n; i++) {
    least = fmin(least, sg_flatness_size(&of[i]));
    sg_flatness_join(&all, &of[i]);
  }
  free(of);
  return good && sg_unify_double(tolerance, sg_flatness_touch(&all)) &&
         sg_unify_double(smallest, n > 0 ? least : 0);
}

/* segment_grain(+S, -Grain) is det. */
static foreign_t
segment_grain(term_t segment, term_t grain)
{
  sg_world *world = sg_current_world_ex();
  int32_t s;

  if (!world || !sg_get_id_ex(segment, &s)) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  double found = sg_grain_of(version, s);

  sg_version_drop(version);
  return sg_unify_double(grain, found);
}

void
sg_install_complete(void)
{
  static const PL_extension doors[] = {
      {"fill_triangles", 1, (pl_function_t)fill_triangles, 0},
      {"fill_triangles", 2, (pl_function_t)fill_triangles_of, 0},
      {"model_tolerance", 1, (pl_function_t)model_tolerance, 0},
      {"segments_tolerance", 3, (pl_function_t)segments_tolerance, 0},
      {"segment_grain", 2, (pl_function_t)segment_grain, 0},
      {NULL, 0, NULL, 0}};

  atom_not_closed = PL_new_atom("not_closed");
  atom_no_area = PL_new_atom("no_area");
  atom_not_simple = PL_new_atom("not_simple");
  atom_not_flat = PL_new_atom("not_flat");
  functor_fault3 = PL_new_functor(PL_new_atom("fault"), 3);
  functor_not_closed1 = PL_new_functor(atom_not_closed, 1);
  functor_not_simple2 = PL_new_functor(atom_not_simple, 2);
  functor_not_flat1 = PL_new_functor(atom_not_flat, 1);
  PL_register_extensions_in_module("sg_kernel_world", doors);
}
