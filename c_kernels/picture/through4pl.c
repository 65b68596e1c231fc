/* through4pl.c -- which segments let lines be seen: see scene4pl.h.
 *
 * Layer: glue.
 */
#include "scene4pl.h"

#include "glue.h"

#include <stdlib.h>

static int
compare_pairs(const void *a, const void *b)
{
  const sg_hide_through *x = a, *y = b;

  if (x->s != y->s) {
    return x->s < y->s ? -1 : 1;
  }
  return (x->s2 > y->s2) - (x->s2 < y->s2);
}

/* S-S2; arg: a reference to use. */
static int
get_pair_ex(term_t t, functor_t minus, term_t arg, sg_hide_through *out)
{
  return (PL_is_functor(t, minus) || PL_type_error("pair", t)) &&
         PL_get_arg(1, t, arg) && sg_get_id_ex(arg, &out->s) &&
         PL_get_arg(2, t, arg) && sg_get_id_ex(arg, &out->s2);
}

int
sg_get_through_ex(term_t list, sg_hide_through **out, size_t *n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();
  functor_t minus = PL_new_functor(PL_new_atom("-"), 2);
  size_t length;

  *n = 0;
  *out = NULL;
  if (PL_skip_list(list, 0, &length) != PL_LIST) {
    return PL_type_error("list", list);
  }
  *out = malloc((length + 1) * sizeof **out);
  if (!*out) {
    return sg_no_memory();
  }
  while (PL_get_list(tail, head, tail)) {
    if (!get_pair_ex(head, minus, arg, &(*out)[*n])) {
      free(*out);
      *n = 0;
      return FALSE;
    }
    (*n)++;
  }
  if (*n > 1) {
    qsort(*out, *n, sizeof **out, compare_pairs);
  }
  return TRUE;
}
