/* install.h -- registers all foreign predicates (called by boot.c, start.c and
 * by use_foreign_library/1). A glue file includes this too: it declares its
 * sg_install_NAME(). */
#ifndef SG_INSTALL_H
#define SG_INSTALL_H

#include <SWI-Prolog.h>

install_t install_sanggwan(void);

#define SG_GLUE(name) void sg_install_##name(void);
#include "glue.def"
#undef SG_GLUE

#endif
