/* work4pl.h -- scratch relations as Prolog handles.
 *
 * Layer: glue.
 */
#ifndef SG_WORK4PL_H
#define SG_WORK4PL_H

#include "work.h"

#include <SWI-Prolog.h>

/* The work behind a handle, borrowed. type_error(work), existence_error(work):
 * it was closed. */
int sg_get_work_ex(term_t t, sg_work **out);

/* A fresh handle for `work`, which it owns from now on, also when this fails.
 * Freed by work_close/1 or with the last reference. */
int sg_unify_work(term_t t, sg_work *work);

/* The handle of the vertex with this id. existence_error(work_vertex). */
int sg_get_work_vertex_ex(sg_work *work, term_t t, int32_t *out);

#endif
