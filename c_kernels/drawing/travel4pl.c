/* travel4pl.c -- travel_order/3 (documented in kernel/drawing.pl).
 *
 * Layer: glue.
 */
#include "glue.h"
#include "travel.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <stdlib.h>

static functor_t FUNCTOR_stroke7, FUNCTOR_minus2;

/* X-Y; arg: a reference to use. */
static int
get_point_ex(term_t t, term_t arg, int64_t out[2])
{
  const int64_t far = INT64_C(1) << 52;

  if (!PL_is_functor(t, FUNCTOR_minus2)) {
    return PL_type_error("pair", t);
  }
  for (int k = 0; k < 2; k++) {
    if (!PL_get_arg(k + 1, t, arg) || !PL_get_int64_ex(arg, &out[k])) {
      return FALSE;
    }
    if (out[k] <= -far || out[k] >= far) {
      return PL_domain_error("sheet_coordinate", arg);
    }
  }
  return TRUE;
}

/* The first and the last of the points of stroke t; refs: four to use. */
static int
get_line_ex(term_t t, term_t refs, sg_travel_line *out)
{
  term_t tail = refs, head = refs + 1, last = refs + 2, arg = refs + 3;

  if (!PL_is_functor(t, FUNCTOR_stroke7) || !PL_get_arg(5, t, tail) ||
      !PL_get_list(tail, last, tail)) {
    return PL_type_error("stroke", t);
  }
  if (!get_point_ex(last, arg, out->at[0])) {
    return FALSE;
  }
  while (PL_get_list(tail, head, tail)) {
    if (!PL_put_term(last, head)) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(tail) && get_point_ex(last, arg, out->at[1]);
}

/* free(*out) in any case. */
static int
get_lines_ex(term_t strokes, sg_travel_line **out, size_t *n)
{
  term_t tail = PL_copy_term_ref(strokes), head = PL_new_term_ref();
  term_t refs = PL_new_term_refs(4);
  size_t length;

  *n = 0;
  *out = NULL;
  if (PL_skip_list(strokes, 0, &length) != PL_LIST) {
    return PL_type_error("list", strokes);
  }
  *out = malloc((length + 1) * sizeof **out);
  if (!*out) {
    return sg_no_memory();
  }
  while (PL_get_list(tail, head, tail)) {
    if (!get_line_ex(head, refs, &(*out)[(*n)++])) {
      return FALSE;
    }
  }
  return TRUE;
}

static int
unify_order(term_t list, const int64_t *order, size_t n)
{
  term_t all = PL_new_term_ref(), head = PL_new_term_ref();

  PL_put_nil(all);
  for (size_t i = n; i > 0; i--) {
    if (!PL_put_int64(head, order[i - 1]) || !PL_cons_list(all, head, all)) {
      return FALSE;
    }
  }
  return PL_unify(list, all);
}

/* travel_order(+Start, +Strokes, -Order) is det. */
static foreign_t
travel_order(term_t start, term_t strokes, term_t list)
{
  sg_travel_line *line = NULL;
  int64_t *order = NULL, from[2];
  size_t n;
  int ok = get_point_ex(start, PL_new_term_ref(), from) &&
           get_lines_ex(strokes, &line, &n);

  if (ok && !(order = malloc((n + 1) * sizeof *order))) {
    ok = sg_no_memory();
  }
  if (ok) {
    bool memory;

    if (sg_travel_order(line, n, from, order, &sg_prolog_poll, &memory)) {
      ok = unify_order(list, order, n);
    } else {
      ok = memory ? FALSE : sg_no_memory();
    }
  }
  free(order);
  free(line);
  return ok;
}

void
sg_install_travel(void)
{
  static const PL_extension doors[] = {
      {"travel_order", 3, (pl_function_t)travel_order, 0}, {NULL, 0, NULL, 0}};

  FUNCTOR_stroke7 = PL_new_functor(PL_new_atom("stroke"), 7);
  FUNCTOR_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
