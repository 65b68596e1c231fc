/* contour4pl.c -- outlines of smooth surfaces (documented in
 * kernel/drawing.pl).
 *
 * Layer: glue.
 */
#include "scene4pl.h"

#include "contour.h"
#include "glue.h"

#include "engine/install.h"

#include <stdlib.h>

static atom_t ATOM_all, ATOM_central, ATOM_parallel;

/* What fill_contour/6 was asked for. */
typedef struct question {
  sg_chosen chosen;
  sg_eye eye;
  bool central;
  sg_smoothness as;
  sg_known known;
} question;

/* ------------------------------------------------------------- arguments */

static int
get_chosen_ex(term_t t, sg_chosen *out)
{
  atom_t name;

  *out = (sg_chosen){.all = PL_get_atom(t, &name) && name == ATOM_all};
  return out->all || sg_get_id_set_ex(t, &out->s, &out->n);
}

static int
get_question_ex(term_t a0, question *out)
{
  double x[3];
  atom_t kind;

  if (!sg_get_finites_ex(a0 + 1, 3, x) || !PL_get_atom_ex(a0 + 4, &kind)) {
    return FALSE;
  }
  if (kind != ATOM_central && kind != ATOM_parallel) {
    return PL_domain_error("projection", a0 + 4);
  }
  out->central = kind == ATOM_central;
  sg_eye_init(&out->eye, x[0], x[1], x[2]);
  return sg_get_smoothness_ex(a0 + 5, &out->as) &&
         get_chosen_ex(a0, &out->chosen) &&
         sg_get_known_ex(a0 + 6, &out->known);
}

/* ------------------------------------------------------------------ rows */

/* The pieces as rows. */
typedef struct rows {
  const sg_contours *contours;
  const sg_dense *dense;
  int32_t s, k; /* of the row written last */
} rows;

/* A relation whose rows are made of the outlines; its last column is what lies
 * beside them. */
typedef struct kind {
  sg_relation relation;
  unsigned last;
  const sg_contour *(*piece)(const sg_contours *contours, size_t i);
  void (*write)(rows *r, const sg_sheet_page *page, size_t i);
} kind;

static const sg_contour *
piece_at(const sg_contours *contours, size_t i)
{
  return &contours->piece[i];
}

static const sg_contour *
seen_at(const sg_contours *contours, size_t i)
{
  return &contours->turn[i].seen;
}

static bool
make_lists(const rows *r, const kind *of, sg_append *a)
{
  int32_t length[SG_PAGE_ROWS];

  for (size_t k = 0; k < a->sheet.pages; k++) {
    const sg_sheet_page *page = &a->sheet.page[k];
    for (size_t i = 0; i < page->n; i++) {
      length[i] = (int32_t)of->piece(r->contours, page->from + i)->besides;
    }
    if (!sg_append_lists(a, k, of->last, length)) {
      return false;
    }
  }
  return true;
}

/* What lies beside a piece, after its length. */
static void
write_beside(const rows *r, const sg_contour *piece, int32_t *list)
{
  list[0] = (int32_t)piece->besides;
  for (size_t j = 0; j < piece->besides; j++) {
    uint32_t t = r->contours->beside[piece->beside + j];
    list[j + 1] = r->dense->triangle_id[t];
  }
}

static void
write_row(rows *r, const sg_sheet_page *page, size_t i)
{
  const sg_contour *piece = &r->contours->piece[page->from + i];
  const sg_dense *d = r->dense;
  const sg_blank *c = page->column;
  int32_t s = d->segment[sg_dense_segment_of(d, d->triangle_begin, piece->t)];

  r->k = s == r->s ? r->k + 1 : 1;
  r->s = s;
  c[0].i[i] = s;
  c[1].i[i] = r->k;
  c[2].i[i] = d->triangle_id[piece->t];
  c[3].i[i] = piece->side[0] + 1;
  c[4].f[i] = piece->at[0] + 0.0;
  c[5].i[i] = piece->side[1] + 1;
  c[6].f[i] = piece->at[1] + 0.0;
  c[7].f[i] = piece->to + 0.0;
  for (size_t k = 0; k < 4; k++) {
    c[9 + k].f[i] = piece->rise[k / 2][k % 2] + 0.0;
  }
  write_beside(r, piece, c[8].list[i]);
}

static void
write_turn(rows *r, const sg_sheet_page *page, size_t i)
{
  const sg_turn *turn = &r->contours->turn[page->from + i];
  const sg_dense *d = r->dense;
  const sg_blank *c = page->column;
  uint32_t t = turn->seen.t;

  c[0].i[i] = d->segment[sg_dense_segment_of(d, d->triangle_begin, t)];
  c[1].i[i] = d->triangle_id[t];
  c[2].i[i] = turn->seen.side[0] + 1;
  c[3].f[i] = turn->from + 0.0;
  c[4].f[i] = turn->to + 0.0;
  write_beside(r, &turn->seen, c[5].list[i]);
}

static int
replace_relation_ex(sg_world *world, rows *r, const kind *of, size_t n)
{
  sg_append a;
  bool good;

  if (!sg_world_retract_all(world, of->relation) ||
      !sg_append_open(&a, world, of->relation, n)) {
    return sg_no_memory();
  }
  good = make_lists(r, of, &a);
  for (size_t k = 0; good && k < a.sheet.pages; k++) {
    for (size_t i = 0; i < a.sheet.page[k].n; i++) {
      of->write(r, &a.sheet.page[k], i);
    }
  }
  good = good && sg_append_commit(&a);
  sg_append_close(&a);
  return good || sg_no_memory();
}

static int
replace_rows_ex(sg_world *world, rows *r)
{
  static const kind pieces = {SG_CONTOUR, 8, piece_at, write_row};
  static const kind turns = {SG_SURFACE_TURN, 5, seen_at, write_turn};

  return replace_relation_ex(world, r, &pieces, r->contours->n) &&
         replace_relation_ex(world, r, &turns, r->contours->turns);
}

/* --------------------------------------------------------------- finding */

/* The outlines of a model, as screen/5 of this version shows it. Null contours:
 * a vertex has no place. False: stopped, or no memory. */
static bool
find_contours(const question *q, const sg_version *version,
              const sg_scene_model *model, const sg_smooth *smooth,
              sg_contours *out, bool *memory)
{
  sg_scene_screen screen = {0};
  bool done =
      sg_scene_screen_read(&screen, version, model, &sg_prolog_poll, memory);

  if (done && !screen.shown) {
    sg_contour_input in = {.dense = &model->dense,
                           .smooth = smooth,
                           .screen = (const double(*)[3])screen.at,
                           .solid = model->solid,
                           .eye = q->eye,
                           .central = q->central};
    done = sg_contours_find(&in, &sg_prolog_poll, out, memory);
  }
  sg_scene_screen_clear(&screen);
  return done;
}

static int
fill_model_ex(sg_world *world, const sg_version *version, sg_kept_model *kept,
              const question *q)
{
  sg_kept_smooth *smooth = sg_kept_smooth_hold_ex(kept, &q->as);
  sg_contours contours = {0};
  bool memory = true;
  int ok = FALSE;

  if (smooth && find_contours(q, version, kept->model, &smooth->smooth,
                              &contours, &memory)) {
    rows r = {.contours = &contours, .dense = &kept->model->dense};
    ok = replace_rows_ex(world, &r);
  } else if (!memory) {
    ok = sg_no_memory();
  }
  sg_contours_clear(&contours);
  sg_kept_smooth_drop(smooth);
  return ok;
}

static int
fill_ex(sg_world *world, const question *q)
{
  const sg_version *version = sg_world_version(world);
  sg_kept_model *kept;
  int ok;

  if (!version) {
    return sg_no_memory();
  }
  kept = sg_kept_model_hold_ex(world, version, &q->chosen, &q->known);
  ok = kept && fill_model_ex(world, version, kept, q);
  sg_kept_model_drop(kept);
  sg_version_drop(version);
  return ok;
}

/* fill_contour(+Segments, +Theta, +Phi, +Rho, +Kind, +Smooth, +Known) is
 * semidet. */
static foreign_t
fill_contour(term_t a0, int arity, void *context)
{
  sg_world *world = sg_current_world_ex();
  question q = {0};
  int ok;

  (void)arity, (void)context;
  ok = world && get_question_ex(a0, &q) && fill_ex(world, &q);
  free(q.chosen.s);
  sg_known_clear(&q.known);
  sg_smoothness_clear(&q.as);
  return ok;
}

void
sg_install_contour(void)
{
  static const PL_extension doors[] = {
      {"fill_contour", 7, (pl_function_t)fill_contour, PL_FA_VARARGS},
      {NULL, 0, NULL, 0}};

  ATOM_all = PL_new_atom("all");
  ATOM_central = PL_new_atom("central");
  ATOM_parallel = PL_new_atom("parallel");
  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
