/* scene4pl.c -- scenes and the hidden-line joins (documented in
 * kernel/drawing.pl).
 *
 * Layer: glue.
 */
#include "scene4pl.h"

#include "glue.h"
#include "hide_search.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <SWI-Stream.h>
#include <stdlib.h>
#include <string.h>

static functor_t FUNCTOR_look10, FUNCTOR_edges1;
static atom_t ATOM_all, ATOM_true, ATOM_false;

/* ---------------------------------------------------------- the handle */

typedef struct handle {
  sg_kept_model *model; /* held */
  sg_scene *scene;
  sg_mask_grid masks;
  sg_line_grid lines; /* of all lines, when one is asked for its overlaps */
  uint32_t *every;    /* [scene->lines] their places */
  sg_seen mask_seen, line_seen;
} handle;

static void
close_handle(handle *h)
{
  if (h) {
    sg_mask_grid_clear(&h->masks);
    sg_line_grid_clear(&h->lines);
    sg_seen_clear(&h->mask_seen);
    sg_seen_clear(&h->line_seen);
    free(h->every);
    sg_scene_close(h->scene);
    sg_kept_model_drop(h->model);
    free(h);
  }
}

static int
release_handle(atom_t atom)
{
  close_handle(PL_blob_data(atom, NULL, NULL));
  return TRUE;
}

static int
write_handle(IOSTREAM *out, atom_t atom, int flags)
{
  const handle *h = PL_blob_data(atom, NULL, NULL);

  (void)flags;
  return Sfprintf(out, "<scene>(%zu lines, %zu triangles)", h->scene->lines,
                  h->scene->masks) >= 0;
}

static PL_blob_t scene_blob = {.magic = PL_BLOB_MAGIC,
                               .flags = PL_BLOB_NOCOPY,
                               .name = "scene",
                               .release = release_handle,
                               .write = write_handle};

static int
get_scene_ex(term_t t, handle **out)
{
  PL_blob_t *type;
  void *data;

  if (PL_get_blob(t, &data, NULL, &type) && type == &scene_blob) {
    *out = data;
    return TRUE;
  }
  return PL_type_error("scene", t);
}

int
sg_get_mask_grid_ex(term_t t, const sg_mask_grid **out)
{
  handle *h = NULL;

  if (!get_scene_ex(t, &h)) {
    return FALSE;
  }
  *out = &h->masks;
  return TRUE;
}

/* ------------------------------------------------------------- opening */

static int
compare_ids(const void *a, const void *b)
{
  int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;

  return (x > y) - (x < y);
}

/* `all`, or a list of segments; free(out->s). */
static int
get_chosen_ex(term_t t, sg_chosen *out)
{
  atom_t name;

  *out = (sg_chosen){.all = PL_get_atom(t, &name) && name == ATOM_all};
  if (out->all) {
    return TRUE;
  }
  if (!sg_get_ids_ex(t, &out->s, &out->n)) {
    return FALSE;
  }
  if (out->n > 1) {
    qsort(out->s, out->n, sizeof *out->s, compare_ids);
  }
  return TRUE;
}

static int
unify_scene(term_t t, handle *h)
{
  term_t blob = PL_new_term_ref();

  PL_put_blob(blob, h, sizeof *h, &scene_blob);
  return PL_unify(t, blob);
}

/* A scene of the input, with its search structures. Null: stopped, or no
 * memory. */
static handle *
new_handle(const sg_scene_input *in, bool *memory)
{
  handle *h = calloc(1, sizeof *h);

  *memory = h != NULL;
  if (h) {
    h->scene = sg_scene_open(in, &sg_prolog_poll, memory);
    if (h->scene &&
        sg_mask_grid_init(&h->masks, h->scene, &sg_prolog_poll, memory)) {
      return h;
    }
  }
  close_handle(h);
  return NULL;
}

/* What scene_open/5 was asked for. */
typedef struct request {
  sg_chosen chosen;
  double depth, tolerance;
  bool smooth; /* curved sheets have no outlines along their edges */
  sg_smoothness as;
  sg_known known;
} request;

/* What a version shows of a model; smooth: its sheets, or null. Null: an
 * exception is pending. */
static handle *
view_model_ex(const sg_version *version, const sg_scene_model *model,
              const sg_kept_smooth *smooth, const request *q)
{
  sg_scene_screen screen = {0};
  sg_scene_pieces pieces = {0};
  bool *faceted = sg_smoothness_faceted(&q->as, &model->dense);
  handle *h = NULL;
  bool memory = faceted != NULL;

  if (memory &&
      sg_scene_screen_read(&screen, version, model, &sg_prolog_poll, &memory) &&
      sg_scene_pieces_read(&pieces, version, model, &screen, &sg_prolog_poll,
                           &memory)) {
    sg_scene_input in = {.model = model,
                         .screen = (const double(*)[3])screen.at,
                         .shown = screen.shown,
                         .added = pieces.added,
                         .addeds = pieces.n,
                         .turn = pieces.turn,
                         .turns = pieces.turns,
                         .curved = smooth ? smooth->curved : NULL,
                         .faceted = faceted,
                         .crease = q->as.crease,
                         .depth = q->depth,
                         .tolerance = q->tolerance};
    h = new_handle(&in, &memory);
  }
  sg_scene_pieces_clear(&pieces);
  sg_scene_screen_clear(&screen);
  free(faceted);
  if (!memory) {
    sg_no_memory();
  }
  return h;
}

/* What the current world shows of a kept model. Null: an exception. */
static handle *
view_kept_ex(const sg_version *version, sg_kept_model *kept, const request *q)
{
  sg_kept_smooth *smooth =
      q->smooth ? sg_kept_smooth_hold_ex(kept, &q->as) : NULL;
  handle *h = NULL;

  if (smooth || !q->smooth) {
    h = view_model_ex(version, kept->model, smooth, q);
  }
  sg_kept_smooth_drop(smooth);
  return h;
}

/* What the current world shows of the chosen segments. Null: an exception. */
static handle *
open_handle_ex(const request *q)
{
  sg_world *world = sg_current_world_ex();
  const sg_version *version = world ? sg_world_version(world) : NULL;
  sg_kept_model *kept;
  handle *h = NULL;

  if (!version) {
    if (world) {
      sg_no_memory();
    }
    return NULL;
  }
  kept = sg_kept_model_hold_ex(world, version, &q->chosen, &q->known);
  if (kept) {
    h = view_kept_ex(version, kept, q);
  }
  if (h) {
    h->model = kept;
  } else {
    sg_kept_model_drop(kept);
  }
  sg_version_drop(version);
  return h;
}

/* smooth(Crease, Faceted), or edges(Faceted). */
static int
get_smooth_ex(term_t t, request *out)
{
  term_t faceted = PL_new_term_ref();

  out->smooth = !PL_is_functor(t, FUNCTOR_edges1);
  if (out->smooth) {
    return sg_get_smoothness_ex(t, &out->as);
  }
  return PL_get_arg(1, t, faceted) &&
         sg_get_id_set_ex(faceted, &out->as.faceted.s, &out->as.faceted.n);
}

/* scene_open(+Segments, +Depth, +Tolerance, +Smooth, +Known, -Scene) is
 * semidet. */
static foreign_t
scene_open(term_t a0, int arity, void *context)
{
  request q = {0};
  handle *h = NULL;

  (void)arity, (void)context;
  if (sg_get_finite_ex(a0 + 1, &q.depth) &&
      sg_get_finite_ex(a0 + 2, &q.tolerance) && get_smooth_ex(a0 + 3, &q) &&
      get_chosen_ex(a0, &q.chosen) && sg_get_known_ex(a0 + 4, &q.known)) {
    h = open_handle_ex(&q);
  }
  free(q.chosen.s);
  sg_known_clear(&q.known);
  sg_smoothness_clear(&q.as);
  return h && unify_scene(a0 + 5, h);
}

/* ---------------------------------------------------------------- edges */

static int
unify_bool(term_t t, bool value)
{
  return PL_unify_atom(t, value ? ATOM_true : ATOM_false);
}

static int
unify_look(term_t t, const sg_look *look)
{
  term_t a = PL_new_term_refs(10);
  const unsigned count[5] = {look->faces, look->towards, look->away, look->left,
                             look->right};

  for (int i = 0; i < 5; i++) {
    if (!PL_unify_uint64(a + i, count[i])) {
      return FALSE;
    }
  }
  return sg_unify_double(a + 5, look->bend) && unify_bool(a + 6, look->edge) &&
         unify_bool(a + 7, look->solid) && unify_bool(a + 8, look->cut) &&
         unify_bool(a + 9, look->inside) &&
         PL_unify_term(t, PL_FUNCTOR, FUNCTOR_look10, PL_TERM, a, PL_TERM,
                       a + 1, PL_TERM, a + 2, PL_TERM, a + 3, PL_TERM, a + 4,
                       PL_TERM, a + 5, PL_TERM, a + 6, PL_TERM, a + 7, PL_TERM,
                       a + 8, PL_TERM, a + 9);
}

int
sg_get_scene_line_ex(const sg_scene *scene, term_t s, term_t e, size_t *out)
{
  int32_t id[2];

  if (!sg_get_id_ex(s, &id[0]) || !sg_get_int32_ex(e, &id[1])) {
    return FALSE;
  }
  *out = sg_scene_find(scene, id[0], id[1]);
  return *out != SIZE_MAX || PL_existence_error("drawn_edge", e);
}

static int
unify_line(const handle *h, size_t at, term_t s, term_t e)
{
  return PL_unify_integer(s, h->scene->line[at].s) &&
         PL_unify_integer(e, h->scene->line[at].e);
}

static int
unify_edge(const handle *h, size_t at, term_t s)
{
  const sg_scene_line *line = &h->scene->line[at];

  return unify_line(h, at, s, s + 1) &&
         sg_unify_double(s + 2, sg_line_length(h->scene, line)) &&
         unify_look(s + 3, &line->look);
}

/* The next line at or after `at` whose ids can be those asked for. */
static size_t
next_edge(const handle *h, size_t at, term_t s, term_t e)
{
  int64_t want[2]; /* 0: any */

  if (!PL_get_int64(s, &want[0])) {
    want[0] = 0;
  }
  if (!PL_get_int64(e, &want[1])) {
    want[1] = 0;
  }
  for (; at < h->scene->lines; at++) {
    const sg_scene_line *line = &h->scene->line[at];
    if ((!want[0] || want[0] == line->s) && (!want[1] || want[1] == line->e)) {
      break;
    }
  }
  return at;
}

static int
scene_edge_first(const handle *h, term_t a1, size_t *at)
{
  int32_t id[2];

  if (PL_is_variable(a1) || PL_is_variable(a1 + 1)) {
    *at = next_edge(h, 0, a1, a1 + 1);
    return TRUE;
  }
  if (!sg_get_id_ex(a1, &id[0]) || !sg_get_int32_ex(a1 + 1, &id[1])) {
    return FALSE;
  }
  *at = sg_scene_find(h->scene, id[0], id[1]);
  return TRUE;
}

/* scene_edge(+Scene, ?S, ?E, -Length, -Look) is nondet. */
static foreign_t
scene_edge(term_t a0, int arity, control_t control)
{
  handle *h = NULL;
  size_t at, next;

  (void)arity;
  if (PL_foreign_control(control) == PL_PRUNED) {
    return TRUE;
  }
  if (!get_scene_ex(a0, &h)) {
    return FALSE;
  }
  if (PL_foreign_control(control) == PL_REDO) {
    at = (size_t)PL_foreign_context(control);
  } else if (!scene_edge_first(h, a0 + 1, &at)) {
    return FALSE;
  }
  if (at >= h->scene->lines) {
    return FALSE;
  }
  next = PL_is_variable(a0 + 1) || PL_is_variable(a0 + 2)
             ? next_edge(h, at + 1, a0 + 1, a0 + 2)
             : h->scene->lines;
  if (!unify_edge(h, at, a0 + 1)) {
    return FALSE;
  }
  if (next >= h->scene->lines) {
    return TRUE;
  }
  PL_retry((intptr_t)next);
}

/* scene_near(+Scene, -Near) is det. */
static foreign_t
scene_near(term_t a0, int arity, void *context)
{
  handle *h = NULL;

  (void)arity, (void)context;
  return get_scene_ex(a0, &h) && sg_unify_double(a0 + 1, h->scene->near);
}

/* ---------------------------------------------------------------- joins */

/* The answers of one call of occluder/7 or overlap/9. */
typedef struct answers {
  sg_hiddens hidden;
  sg_overlaps overlap;
  size_t next;
} answers;

static void
answers_free(answers *a)
{
  if (a) {
    free(a->hidden.part);
    free(a->overlap.part);
    free(a);
  }
}

static int
unify_hidden(const handle *h, const sg_hidden *part, term_t a3)
{
  const sg_scene_mask *mask = &h->scene->mask[part->mask];

  return PL_unify_integer(a3, mask->s) && PL_unify_integer(a3 + 1, mask->t) &&
         sg_unify_double(a3 + 2, part->from) &&
         sg_unify_double(a3 + 3, part->to);
}

static int
unify_overlap(const handle *h, const sg_overlap *part, term_t a3)
{
  return unify_line(h, part->line, a3, a3 + 1) &&
         sg_unify_double(a3 + 2, part->from) &&
         sg_unify_double(a3 + 3, part->to) &&
         sg_unify_double(a3 + 4, part->from2) &&
         sg_unify_double(a3 + 5, part->to2);
}

/* The first answer at or after a->next that unifies; the last one leaves no
 * choice point. */
static foreign_t
answer(const handle *h, answers *a, term_t a3)
{
  size_t n = a->hidden.n + a->overlap.n;
  fid_t frame = PL_open_foreign_frame();

  while (a->next < n) {
    size_t i = a->next++;
    int ok = a->hidden.n ? unify_hidden(h, &a->hidden.part[i], a3)
                         : unify_overlap(h, &a->overlap.part[i], a3);
    if (ok || PL_exception(0)) {
      PL_close_foreign_frame(frame);
      if (ok && a->next < n) {
        PL_retry_address(a);
      }
      answers_free(a);
      return ok;
    }
    PL_rewind_foreign_frame(frame);
  }
  PL_close_foreign_frame(frame);
  answers_free(a);
  return FALSE;
}

/* All masks that hide a part of a line. */
static int
find_masks_ex(handle *h, size_t line, sg_hiddens *out)
{
  if (!h->mask_seen.by && !sg_seen_init(&h->mask_seen, h->scene->masks)) {
    return sg_no_memory();
  }
  return sg_mask_grid_ask(&h->masks, line, NULL, false, &h->mask_seen, out) ||
         sg_no_memory();
}

/* The grid of all lines, made when it is asked first. */
static int
make_lines_ex(handle *h)
{
  size_t n = h->scene->lines;
  bool memory = true;

  if (h->lines.grid[SG_LINE_CLASSES - 1].item) {
    return TRUE;
  }
  sg_line_grid_clear(&h->lines);
  sg_seen_clear(&h->line_seen);
  free(h->every);
  h->every = malloc((n + 1) * sizeof *h->every);
  for (size_t i = 0; h->every && i < n; i++) {
    h->every[i] = (uint32_t)i;
  }
  if (h->every && sg_seen_init(&h->line_seen, n) &&
      sg_line_grid_init(&h->lines, h->scene, h->every, n, &sg_prolog_poll,
                        &memory)) {
    return TRUE;
  }
  return memory && PL_exception(0) ? FALSE : sg_no_memory();
}

/* All lines that a line lies on. */
static int
find_overlaps_ex(handle *h, size_t line, sg_overlaps *out)
{
  return make_lines_ex(h) &&
         (sg_line_grid_ask(&h->lines, line, &h->line_seen, out) ||
          sg_no_memory());
}

static answers *
find_answers_ex(handle *h, term_t a0, bool overlaps)
{
  answers *a = calloc(1, sizeof *a);
  size_t line;

  if (!a) {
    sg_no_memory();
    return NULL;
  }
  if (sg_get_scene_line_ex(h->scene, a0 + 1, a0 + 2, &line) &&
      (overlaps ? find_overlaps_ex(h, line, &a->overlap)
                : find_masks_ex(h, line, &a->hidden))) {
    return a;
  }
  answers_free(a);
  return NULL;
}

/* No && round answer(): what it returns is not only true or false. */
static foreign_t
join(term_t a0, bool overlaps, control_t control)
{
  handle *h = NULL;
  answers *a = NULL;

  switch (PL_foreign_control(control)) {
  case PL_PRUNED:
    answers_free(PL_foreign_context_address(control));
    return TRUE;
  case PL_REDO:
    a = PL_foreign_context_address(control);
    break;
  default:
    break;
  }
  if (!get_scene_ex(a0, &h) ||
      (!a && !(a = find_answers_ex(h, a0, overlaps)))) {
    return FALSE;
  }
  return answer(h, a, a0 + 3);
}

/* occluder(+Scene, +S, +E, ?S2, ?T, -From, -To) is nondet. */
static foreign_t
occluder(term_t a0, int arity, control_t control)
{
  (void)arity;
  return join(a0, false, control);
}

/* overlap(+Scene, +S, +E, ?S2, ?E2, -From, -To, -From2, -To2) is nondet. */
static foreign_t
overlap(term_t a0, int arity, control_t control)
{
  (void)arity;
  return join(a0, true, control);
}

void
sg_install_scene(void)
{
  static const PL_extension doors[] = {
      {"scene_open", 6, (pl_function_t)scene_open, PL_FA_VARARGS},
      {"scene_edge", 5, (pl_function_t)scene_edge,
       PL_FA_NONDETERMINISTIC | PL_FA_VARARGS},
      {"scene_near", 2, (pl_function_t)scene_near, PL_FA_VARARGS},
      {"occluder", 7, (pl_function_t)occluder,
       PL_FA_NONDETERMINISTIC | PL_FA_VARARGS},
      {"overlap", 9, (pl_function_t)overlap,
       PL_FA_NONDETERMINISTIC | PL_FA_VARARGS},
      {NULL, 0, NULL, 0}};

  FUNCTOR_look10 = PL_new_functor(PL_new_atom("look"), 10);
  FUNCTOR_edges1 = PL_new_functor(PL_new_atom("edges"), 1);
  ATOM_all = PL_new_atom("all");
  ATOM_true = PL_new_atom("true");
  ATOM_false = PL_new_atom("false");
  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
