/* glue.c, layer glue: reads and checks arguments; computes nothing. */
#include <SWI-Stream.h>

#include <SWI-Prolog.h>

#include "glue.h"
#include "ids.h"

#include <math.h>
#include <stdlib.h>

int
sg_no_memory(void)
{
  return PL_resource_error("memory");
}

int
sg_get_int32_ex(term_t t, int32_t *out)
{
  int64_t i;

  if (!PL_get_int64(t, &i)) {
    if (PL_is_integer(t)) {
      return PL_representation_error("int32");
    }
    return PL_is_variable(t) ? PL_instantiation_error(t)
                             : PL_type_error("integer", t);
  }
  if (PL_is_float(t)) {
    return PL_type_error("integer", t);
  }
  if (i < INT32_MIN || i > INT32_MAX) {
    return PL_representation_error("int32");
  }
  *out = (int32_t)i;
  return TRUE;
}

int
sg_get_id_ex(term_t t, int32_t *out)
{
  if (!sg_get_int32_ex(t, out)) {
    return FALSE;
  }
  return *out > 0 || PL_type_error("not_less_than_one", t);
}

int
sg_get_finite_ex(term_t t, double *out)
{
  if (!PL_get_float_ex(t, out)) {
    return FALSE;
  }
  *out += 0.0;
  return isfinite(*out) || PL_domain_error("finite", t);
}

int
sg_list_length_ex(term_t list, size_t *n)
{
  switch (PL_skip_list(list, 0, n)) {
  case PL_LIST:
    return TRUE;
  case PL_PARTIAL_LIST:
    return PL_instantiation_error(list);
  default:
    return PL_type_error("list", list);
  }
}

int
sg_get_ids_ex(term_t list, int32_t **out, size_t *n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  int32_t *ids = NULL;

  *out = NULL;
  if (!sg_list_length_ex(list, n)) {
    return FALSE;
  }
  if (*n && !(ids = malloc(*n * sizeof *ids))) {
    return sg_no_memory();
  }
  for (size_t i = 0; i < *n; i++) {
    if (!PL_get_list_ex(tail, head, tail) || !sg_get_id_ex(head, &ids[i])) {
      free(ids);
      return FALSE;
    }
  }
  *out = ids;
  return TRUE;
}

int
sg_get_id_set_ex(term_t list, int32_t **out, size_t *n)
{
  if (!sg_get_ids_ex(list, out, n)) {
    return FALSE;
  }
  *n = sg_sort_ids(*out, *n);
  return TRUE;
}
