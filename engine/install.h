/* install.h -- registers all foreign predicates (called by boot.c, start.c and
 * by use_foreign_library/1). */
#ifndef SG_INSTALL_H
#define SG_INSTALL_H

#include <SWI-Prolog.h>

install_t install_sanggwan(void);

#endif
