/* glue.h -- argument readers shared by the *4pl.c files.
 *
 * Layer: glue. Every *_ex() function returns FALSE only with a Prolog
 * exception pending: return it.
 */
#ifndef SG_GLUE_H
#define SG_GLUE_H

#include <SWI-Prolog.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A positive id of 32 bits: type_error(integer), type_error(
 * not_less_than_one), representation_error(int32). */
int sg_get_id_ex(term_t t, int32_t *out);
/* Any integer of 32 bits. */
int sg_get_int32_ex(term_t t, int32_t *out);
/* A finite number as a double, never -0.0: type_error(number),
 * domain_error(finite). */
int sg_get_finite_ex(term_t t, double *out);
/* The length of a proper list: instantiation_error, type_error(list). */
int sg_list_length_ex(term_t list, size_t *n);
/* A proper list of ids into a fresh array (*out null when empty); free() it. */
int sg_get_ids_ex(term_t list, int32_t **out, size_t *n);
/* The same for a set of ids: ascending, each once. */
int sg_get_id_set_ex(term_t list, int32_t **out, size_t *n);

/* resource_error(memory). */
int sg_no_memory(void);

#endif
