/* edit4pl.h -- worlds while somebody edits them, for the glue of the store.
 *
 * Layer: glue of the store; doors of kernels get their worlds by world4pl.h.
 * All *_ex() functions: null or false means that a Prolog exception is pending.
 */
#ifndef SG_EDIT4PL_H
#define SG_EDIT4PL_H

#include "world4pl.h"

/* The current world of this thread (borrowed), which need not be whole.
 * existence_error: none. */
sg_world *sg_edited_world_ex(void);

/* The current version is whole then; the world is claimed. */
int sg_make_whole_ex(sg_world *world, bool cascade);

/* Retracts a row as a user does. 0 with an exception: it may not; without: it
 * lives no more. The world is claimed. */
int sg_retract_edit_ex(sg_world *world, sg_relation relation, sg_row row,
                       bool cascade);

#endif
