/* stroke4pl.c -- stroke_looks/2 and stroke_chains/3 (documented in
 * kernel/drawing.pl).
 *
 * Layer: glue.
 */
#include "stroke4pl.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <stdlib.h>

static functor_t FUNCTOR_part8, FUNCTOR_stroke7, FUNCTOR_look3, FUNCTOR_minus2;
static atom_t ATOM_hidden, ATOM_ends[3];

void
sg_looks_clear(sg_looks *l)
{
  free(l->name);
  free(l->look);
}

size_t
sg_looks_find(const sg_looks *l, sg_look_names name, size_t last)
{
  if (last < l->n && l->name[last].visibility == name.visibility &&
      l->name[last].role == name.role) {
    return last;
  }
  for (size_t i = 0; i < l->n; i++) {
    if (l->name[i].visibility == name.visibility &&
        l->name[i].role == name.role) {
      return i;
    }
  }
  return l->n;
}

static int
get_names_ex(term_t part, term_t t, sg_look_names *out)
{
  return (PL_is_functor(part, FUNCTOR_part8) || PL_type_error("part", part)) &&
         PL_get_arg(1, part, t) && PL_get_atom_ex(t, &out->visibility) &&
         PL_get_arg(2, part, t) && PL_get_atom_ex(t, &out->role);
}

/* ---------------------------------------------------------- stroke_looks */

static int
add_look(sg_looks *l, sg_look_names name)
{
  sg_look_names *more = realloc(l->name, (l->n + 1) * sizeof *more);

  if (!more) {
    return sg_no_memory();
  }
  l->name = more;
  l->name[l->n++] = name;
  return TRUE;
}

static int
collect_looks_ex(term_t parts, sg_looks *l)
{
  term_t tail = PL_copy_term_ref(parts), head = PL_new_term_ref();
  term_t t = PL_new_term_ref();
  size_t at = 0;

  while (PL_get_list_ex(tail, head, tail)) {
    sg_look_names name;
    if (!get_names_ex(head, t, &name)) {
      return FALSE;
    }
    at = sg_looks_find(l, name, at);
    if (at == l->n && !add_look(l, name)) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(tail);
}

static int
unify_looks(term_t list, const sg_looks *l)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < l->n; i++) {
    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR, FUNCTOR_minus2, PL_ATOM,
                       l->name[i].visibility, PL_ATOM, l->name[i].role)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* stroke_looks(+Parts, -Looks) is det. */
static foreign_t
stroke_looks(term_t parts, term_t list)
{
  sg_looks l = {0};
  int ok = collect_looks_ex(parts, &l) && unify_looks(list, &l);

  sg_looks_clear(&l);
  return ok;
}

/* --------------------------------------------------------- stroke_chains */

/* The first look with this role. */
static int
role_number(const sg_looks *l, size_t n)
{
  size_t i = 0;

  while (l->name[i].role != l->name[n].role) {
    i++;
  }
  return (int)i;
}

/* look(Visibility, Role, Rank) */
static int
get_look_ex(term_t t, term_t arg, sg_looks *l)
{
  size_t n = l->n;
  int32_t rank;

  if (!PL_is_functor(t, FUNCTOR_look3)) {
    return PL_type_error("look", t);
  }
  if (!PL_get_arg(1, t, arg) || !PL_get_atom_ex(arg, &l->name[n].visibility) ||
      !PL_get_arg(2, t, arg) || !PL_get_atom_ex(arg, &l->name[n].role) ||
      !PL_get_arg(3, t, arg) || !sg_get_int32_ex(arg, &rank)) {
    return FALSE;
  }
  l->look[n] = (sg_stroke_look){
      .rank = rank,
      .role = role_number(l, n),
      .hidden = l->name[n].visibility == ATOM_hidden,
  };
  l->n++;
  return TRUE;
}

int
sg_get_looks_ex(term_t list, sg_looks *l)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();
  size_t length;

  *l = (sg_looks){0};
  if (PL_skip_list(list, 0, &length) != PL_LIST) {
    return PL_type_error("list", list);
  }
  l->name = malloc((length + 1) * sizeof *l->name);
  l->look = malloc((length + 1) * sizeof *l->look);
  if (!l->name || !l->look) {
    return sg_no_memory();
  }
  while (PL_get_list(tail, head, tail)) {
    if (!get_look_ex(head, arg, l)) {
      return FALSE;
    }
  }
  return TRUE;
}

static int
get_coordinate_ex(term_t t, int64_t *out)
{
  const int64_t far = INT64_C(1) << 52;

  return PL_get_int64_ex(t, out) && ((*out > -far && *out < far) ||
                                     PL_domain_error("sheet_coordinate", t));
}

static int
get_point_ex(term_t t, term_t arg, int64_t out[2])
{
  return (PL_is_functor(t, FUNCTOR_minus2) || PL_type_error("pair", t)) &&
         PL_get_arg(1, t, arg) && get_coordinate_ex(arg, &out[0]) &&
         PL_get_arg(2, t, arg) && get_coordinate_ex(arg, &out[1]);
}

/* part(Visibility, Role, S, E, From, To, A, B); t: two references to use. */
static int
get_part_ex(term_t part, term_t t, const sg_looks *l, sg_stroke_part *out)
{
  size_t last = out->look;
  sg_look_names name;

  if (!get_names_ex(part, t, &name)) {
    return FALSE;
  }
  last = sg_looks_find(l, name, last);
  if (last == l->n) {
    return PL_domain_error("look", part);
  }
  out->look = (uint32_t)last;
  return PL_get_arg(3, part, t) && sg_get_int32_ex(t, &out->s) &&
         PL_get_arg(4, part, t) && sg_get_int32_ex(t, &out->e) &&
         PL_get_arg(5, part, t) && sg_get_finite_ex(t, &out->from) &&
         PL_get_arg(6, part, t) && sg_get_finite_ex(t, &out->to) &&
         PL_get_arg(7, part, t) && get_point_ex(t, t + 1, out->a) &&
         PL_get_arg(8, part, t) && get_point_ex(t, t + 1, out->b);
}

int
sg_get_parts_ex(term_t list, const sg_looks *l, sg_stroke_part **out, size_t *n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t t = PL_new_term_refs(2);
  sg_stroke_part part = {0};
  size_t length;

  if (PL_skip_list(list, 0, &length) != PL_LIST) {
    return PL_type_error("list", list);
  }
  sg_stroke_part *grown = realloc(*out, (*n + length + 1) * sizeof *grown);

  if (!grown) {
    return sg_no_memory();
  }
  *out = grown;
  while (PL_get_list(tail, head, tail)) {
    if (!get_part_ex(head, t, l, &part)) {
      return FALSE;
    }
    grown[(*n)++] = part;
  }
  return TRUE;
}

/* X-Y into t; arg: two references to use. */
static int
put_point(term_t t, term_t arg, const int64_t at[2])
{
  return PL_put_int64(arg, at[0]) && PL_put_int64(arg + 1, at[1]) &&
         PL_cons_functor_v(t, FUNCTOR_minus2, arg);
}

/* The point that a step begins at (`end` false) or ends at. */
static const int64_t *
step_point(const sg_strokes *strokes, int64_t step, bool end)
{
  const sg_stroke_part *p = &strokes->part[(step < 0 ? -step : step) - 1];

  return (step > 0) == end ? p->b : p->a;
}

/* stroke(Visibility, Role, S, Edges, Points, Start, End) into t[0]; t[1] to
 * t[7] are its arguments, t[8] to t[10] to use. */
static int
put_stroke(term_t t, const sg_looks *l, const sg_strokes *strokes,
           const sg_stroke *stroke)
{
  const int64_t *step = &strokes->step[stroke->first];
  const sg_stroke_part *first =
      &strokes->part[(*step < 0 ? -*step : *step) - 1];

  PL_put_nil(t + 4);
  PL_put_nil(t + 5);
  for (size_t i = stroke->n; i > 0; i--) {
    int64_t k = step[i - 1];
    int32_t e = strokes->part[(k < 0 ? -k : k) - 1].e;
    if (!PL_put_integer(t + 8, e) || !PL_cons_list(t + 4, t + 8, t + 4) ||
        !put_point(t + 8, t + 9, step_point(strokes, k, true)) ||
        !PL_cons_list(t + 5, t + 8, t + 5)) {
      return FALSE;
    }
  }
  return put_point(t + 8, t + 9, step_point(strokes, *step, false)) &&
         PL_cons_list(t + 5, t + 8, t + 5) &&
         PL_put_atom(t + 1, l->name[first->look].visibility) &&
         PL_put_atom(t + 2, l->name[first->look].role) &&
         PL_put_integer(t + 3, first->s) &&
         PL_put_atom(t + 6, ATOM_ends[stroke->start]) &&
         PL_put_atom(t + 7, ATOM_ends[stroke->end]) &&
         PL_cons_functor_v(t, FUNCTOR_stroke7, t + 1);
}

static int
unify_strokes(term_t list, const sg_looks *l, const sg_strokes *strokes)
{
  term_t all = PL_new_term_ref(), t = PL_new_term_refs(11);

  PL_put_nil(all);
  for (size_t i = strokes->n; i > 0; i--) {
    if (!put_stroke(t, l, strokes, &strokes->item[i - 1]) ||
        !PL_cons_list(all, t, all)) {
      return FALSE;
    }
  }
  return PL_unify(list, all);
}

int
sg_unify_strokes_of(term_t list, const sg_looks *l, sg_stroke_part *part,
                    size_t n)
{
  sg_strokes strokes;
  bool memory;

  if (!sg_strokes_make(part, n, l->look, &sg_prolog_poll, &strokes, &memory)) {
    return memory ? FALSE : sg_no_memory();
  }
  int done = unify_strokes(list, l, &strokes);

  sg_strokes_clear(&strokes);
  return done;
}

/* stroke_chains(+Parts, +Looks, -Strokes) is det. */
static foreign_t
stroke_chains(term_t parts, term_t look_list, term_t list)
{
  sg_looks l;
  sg_stroke_part *part = NULL;
  size_t n = 0;
  int ok = sg_get_looks_ex(look_list, &l) &&
           sg_get_parts_ex(parts, &l, &part, &n) &&
           sg_unify_strokes_of(list, &l, part, n);

  free(part);
  sg_looks_clear(&l);
  return ok;
}

void
sg_install_stroke(void)
{
  static const PL_extension doors[] = {
      {"stroke_looks", 2, (pl_function_t)stroke_looks, 0},
      {"stroke_chains", 3, (pl_function_t)stroke_chains, 0},
      {NULL, 0, NULL, 0}};

  FUNCTOR_part8 = PL_new_functor(PL_new_atom("part"), 8);
  FUNCTOR_stroke7 = PL_new_functor(PL_new_atom("stroke"), 7);
  FUNCTOR_look3 = PL_new_functor(PL_new_atom("look"), 3);
  FUNCTOR_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  ATOM_hidden = PL_new_atom("hidden");
  ATOM_ends[SG_END_JOINT] = PL_new_atom("joint");
  ATOM_ends[SG_END_CUT] = PL_new_atom("cut");
  ATOM_ends[SG_END_RING] = PL_new_atom("ring");
  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
