/* arrangement_free4pl.c -- polygons whose lines meet nothing, into an
 * arrangement without a scratch relation of each.
 *
 * Layer: glue. The door is documented in rules/kernel/boolean.pl.
 */
#include "arrangement4pl.h"

#include "glue.h"

#include "engine/install.h"

static functor_t functor_minus2;

enum { ASKED = 256 }; /* polygons between questions */

/* One S-P. */
static int
get_outline_ex(sg_cut_handle *set, term_t polygon, term_t arg, sg_outlines *out)
{
  int32_t s, p;

  if (!PL_is_functor(polygon, functor_minus2)) {
    return PL_type_error("pair", polygon);
  }
  return PL_get_arg(1, polygon, arg) && sg_get_id_ex(arg, &s) &&
         PL_get_arg(2, polygon, arg) && sg_get_id_ex(arg, &p) &&
         sg_cut_outline_ex(set, s, p, arg, out);
}

static int
get_outlines_ex(sg_cut_handle *set, term_t list, sg_outlines *out)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();

  while (PL_get_list(tail, head, tail)) {
    if (!get_outline_ex(set, head, arg, out) ||
        (out->n % ASKED == 0 && PL_handle_signals() < 0)) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(tail);
}

/* Fails if they cannot be taken in freely. */
static int
take_in_ex(sg_arrangement *a, const sg_outlines *outlines, double reach)
{
  sg_crew *crew = sg_crew_open(0);
  sg_outcome outcome = crew ? sg_arrangement_free_polygons(
                                  a, outlines, reach, crew, &sg_prolog_poll)
                            : SG_NO_SPACE;

  sg_crew_close(crew);
  return outcome == SG_DONE       ? TRUE
         : outcome == SG_NO_SPACE ? sg_no_memory()
                                  : FALSE; /* stuck, or an exception */
}

/* arrangement_free_polygons(+Arrangement, +Polygons, +Reach) is semidet. */
static foreign_t
arrangement_free_polygons(term_t t, term_t polygons, term_t r)
{
  sg_arrangement_handle *h;
  sg_outlines outlines = {0};
  double reach;

  if (!sg_get_unsealed_ex(t, &h) || !sg_get_finite_ex(r, &reach)) {
    return FALSE;
  }
  int good = get_outlines_ex(h->set, polygons, &outlines) &&
             take_in_ex(h->arrangement, &outlines, reach);

  sg_outlines_clear(&outlines);
  return good;
}

static const PL_extension predicates[] = {
    {"arrangement_free_polygons", 3, arrangement_free_polygons, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_arrangement_free(void)
{
  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
