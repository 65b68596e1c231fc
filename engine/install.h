/* install.h -- registers all foreign predicates (called by boot.c, start.c and
 * by use_foreign_library/1). A glue file includes this too: it declares its
 * sg_install_NAME(). */
#ifndef SG_INSTALL_H
#define SG_INSTALL_H

#include <stdbool.h>

#include <SWI-Prolog.h>

install_t install_sanggwan(void);

#define SG_GLUE(name) void sg_install_##name(void);
#include "glue.def"
#undef SG_GLUE

/* Whether a term has more levels of compounds in one another, of which a list
 * is one; true of a term that is in itself, and if an exception is pending. */
bool sg_is_deeper(term_t t, size_t depth);

#endif
