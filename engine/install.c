/* install.c -- every glue file's predicates, in one place.
 *
 * Layer: glue. A new X4pl.c adds its line here and its doors to
 * rules/kernel.pl (or rules/store.pl).
 */
#include "install.h"

#define SG_GLUE(name) void sg_install_##name(void);
#include "glue.def"
#undef SG_GLUE

install_t
install_sanggwan(void)
{
#define SG_GLUE(name) sg_install_##name();
#include "glue.def"
#undef SG_GLUE
}
