/* arrangement_pieces4pl.c -- sealed arrangements: their components, and solids
 * of those that are chosen.
 *
 * Layer: glue. The doors are documented in rules/kernel/boolean.pl.
 */
#include "arrangement4pl.h"

#include "door.h"
#include "glue.h"

#include "engine/install.h"

#include <stdlib.h>

extern sg_handle_type sg_handle_type_solid;

static functor_t functor_component6, functor_side3, functor_point3,
    functor_minus2;
static atom_t atom_only, atom_second, atom_unknown;

/* ---- components ---- */

static int
put_sides(term_t list, const sg_component *c)
{
  term_t one = PL_new_term_ref();

  PL_put_nil(list);
  for (size_t i = c->sides; i > 0; i--) {
    const sg_side *side = &c->side[i - 1];

    PL_put_variable(one);
    if (!PL_unify_term(one, PL_FUNCTOR, functor_side3, PL_INT, side->s, PL_INT,
                       side->below, PL_INT, side->above) ||
        !PL_cons_list(list, one, list)) {
      return FALSE;
    }
  }
  return TRUE;
}

/* component(C, S, P, point(X, Y, Z), Sides, Which) */
static int
unify_component(term_t t, size_t number, const sg_component *c)
{
  term_t sides = PL_new_term_ref();

  return put_sides(sides, c) &&
         PL_unify_term(t, PL_FUNCTOR, functor_component6, PL_INT64,
                       (int64_t)number, PL_INT, c->s, PL_INT, c->p, PL_FUNCTOR,
                       functor_point3, PL_FLOAT, c->at->p[0], PL_FLOAT,
                       c->at->p[1], PL_FLOAT, c->at->p[2], PL_TERM, sides,
                       PL_ATOM,
                       c->unknown  ? atom_unknown
                       : c->second ? atom_second
                                   : atom_only);
}

/* ---- pieces: [S-Arrangement, ...] ---- */

void
sg_pieces_clear(sg_pieces *p)
{
  free(p->of);
  free(p->from);
  free(p->sense);
}

/* Segments ascend. */
static bool
has_pieces(const sg_arrangement_handle *h, int32_t s)
{
  size_t low = 0, high = h->n;

  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (h->s[middle] < s) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < h->n && h->s[low] == s && h->wanted[low];
}

static int
get_piece_ex(term_t t, sg_chosen *out, sg_arrangement_handle **from)
{
  term_t arg = PL_new_term_ref();

  if (!PL_is_functor(t, functor_minus2)) {
    return PL_type_error("pair", t);
  }
  if (!PL_get_arg(1, t, arg) || !sg_get_id_ex(arg, &out->s) ||
      !PL_get_arg(2, t, arg) || !sg_get_sealed_ex(arg, from)) {
    return FALSE;
  }
  out->a = (*from)->arrangement;
  return has_pieces(*from, out->s) || PL_existence_error("pieces", t);
}

int
sg_get_pieces_ex(term_t list, sg_pieces *out)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  size_t n;

  *out = (sg_pieces){0};
  if (PL_skip_list(list, 0, &n) != PL_LIST) {
    return PL_type_error("list", list);
  }
  out->of = calloc(n + 1, sizeof *out->of);
  out->from = calloc(n + 1, sizeof(sg_arrangement_handle *));
  if (!out->of || !out->from) {
    return sg_no_memory();
  }
  for (; out->n < n; out->n++) {
    if (!PL_get_list_ex(tail, head, tail) ||
        !get_piece_ex(head, &out->of[out->n], &out->from[out->n])) {
      return FALSE;
    }
    out->components +=
        sg_arrangement_components(out->of[out->n].a, out->of[out->n].s);
  }
  return TRUE;
}

enum { ASKED = 1 << 10 }; /* components between questions */

static bool
goes_on_ex(size_t i)
{
  return i % ASKED != ASKED - 1 || PL_handle_signals() >= 0;
}

static foreign_t
arrangement_components(term_t t, term_t list)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  sg_pieces p;
  size_t number = 0;
  int good = sg_get_pieces_ex(t, &p);

  for (size_t i = 0; good && i < p.n; i++) {
    size_t n = sg_arrangement_components(p.of[i].a, p.of[i].s);

    for (size_t k = 0; good && k < n; k++) {
      sg_component c = sg_arrangement_component(p.of[i].a, p.of[i].s, k);
      fid_t frame = PL_open_foreign_frame();

      good = frame && goes_on_ex(number) && PL_unify_list(tail, head, tail) &&
             unify_component(head, number++, &c);
      PL_close_foreign_frame(frame);
    }
  }
  sg_pieces_clear(&p);
  return good && PL_unify_nil(tail);
}

/* arrangement_numbers(+Pieces, -Numbers) is det. */
static foreign_t
arrangement_numbers(term_t t, term_t list)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  sg_pieces p;
  int good = sg_get_pieces_ex(t, &p);

  for (size_t i = 0; good && i < p.n; i++) {
    good = PL_unify_list(tail, head, tail) &&
           PL_unify_uint64(head, p.from[i]->number);
  }
  sg_pieces_clear(&p);
  return good && PL_unify_nil(tail);
}

/* ---- choosing ---- */

/* Reads [C-Sense, ...]. */
static int
get_senses_ex(term_t list, sg_pieces *p)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();

  p->sense = calloc(p->components + 1, 1);
  if (!p->sense) {
    return sg_no_memory();
  }
  while (PL_get_list(tail, head, tail)) {
    int64_t c;
    int turn;

    if (!PL_is_functor(head, functor_minus2)) {
      return PL_type_error("pair", head);
    }
    if (!PL_get_arg(1, head, arg) || !PL_get_int64_ex(arg, &c)) {
      return FALSE;
    }
    if (c < 0 || (uint64_t)c >= p->components) {
      return PL_existence_error("component", arg);
    }
    if (!PL_get_arg(2, head, arg) || !PL_get_integer_ex(arg, &turn)) {
      return FALSE;
    }
    if (turn != 1 && turn != -1) {
      return PL_domain_error("sense", arg);
    }
    p->sense[c] = (int8_t)turn;
  }
  for (size_t i = 0, at = 0; i < p->n; i++) {
    p->of[i].sense = p->sense + at;
    at += sg_arrangement_components(p->of[i].a, p->of[i].s);
  }
  return PL_get_nil_ex(tail);
}

static foreign_t
arrangement_select(term_t t, term_t senses, term_t out)
{
  sg_pieces p;
  sg_solid solid = {0};
  sg_made_by *made_by = NULL;
  int good = sg_get_pieces_ex(t, &p) && get_senses_ex(senses, &p);

  sg_crew *crew = good ? sg_crew_open(0) : NULL;

  if (good && (!crew || !sg_arrangement_select(p.of, p.n, crew, &sg_prolog_poll,
                                               &solid, &made_by))) {
    good = PL_exception(0) ? FALSE : sg_no_memory();
  }
  sg_crew_close(crew);
  good = good && sg_give_origins_ex(&p, &solid, made_by);
  free(made_by);
  sg_pieces_clear(&p);
  if (!good) {
    sg_solid_clear(&solid);
    return FALSE;
  }
  sg_solid *object = malloc(sizeof *object);

  if (!object) {
    sg_solid_clear(&solid);
    return sg_no_memory();
  }
  *object = solid;
  return sg_handle_unify(out, &sg_handle_type_solid, object);
}

static const PL_extension predicates[] = {
    {"arrangement_components", 2, arrangement_components, 0},
    {"arrangement_numbers", 2, arrangement_numbers, 0},
    {"arrangement_select", 3, arrangement_select, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_arrangement_pieces(void)
{
  functor_component6 = PL_new_functor(PL_new_atom("component"), 6);
  functor_side3 = PL_new_functor(PL_new_atom("side"), 3);
  functor_point3 = PL_new_functor(PL_new_atom("point"), 3);
  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  atom_only = PL_new_atom("only");
  atom_second = PL_new_atom("second");
  atom_unknown = PL_new_atom("unknown");
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
