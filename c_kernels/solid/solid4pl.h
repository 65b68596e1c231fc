/* solid4pl.h -- a solid under way behind a Prolog handle.
 *
 * Layer: glue. Include it before SWI-Prolog.h.
 */
#ifndef SG_SOLID4PL_H
#define SG_SOLID4PL_H

#include "engine/world4pl.h"

#include "solid.h"

/* Unifies t with a new handle that owns what *moved_in owned; *moved_in is
 * empty afterwards, also after a failure. */
int sg_unify_solid(term_t t, sg_solid *moved_in);

/* The open solid that t names, the handle's: type_error(solid, t),
 * existence_error(solid, t) if it is closed. */
int sg_get_solid_ex(term_t t, sg_solid **out);

#endif
