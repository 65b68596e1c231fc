/* world4pl.h -- the current world, for every *4pl.c file.
 *
 * Layer: glue. All *_ex() functions: null or false means that a Prolog
 * exception is pending.
 */
#ifndef SG_WORLD4PL_H
#define SG_WORLD4PL_H

#include "store.h"

#include "../c_kernels/poll.h"

#include <SWI-Prolog.h>

/* The current world of this thread (borrowed). */
sg_world *sg_current_world_ex(void);

/* Raises what `status` means; returns FALSE, or TRUE for SG_OK. */
int sg_raise_status(sg_status status, sg_relation relation,
                    const sg_fault *fault);

/* The poll that asks Prolog for signals; after a stop return FALSE from the
 * foreign predicate, the exception is pending. */
extern const sg_poll sg_prolog_poll;

/* Symbols and terms between Prolog and the store. */
int sg_get_term_ex(term_t t, uint32_t **out); /* free() it */
int sg_put_term(term_t t, const uint32_t *term);

#endif
