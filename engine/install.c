/* install.c -- every glue file's predicates, in one place.
 *
 * Layer: glue. A new X4pl.c adds its line to glue.def and its doors to
 * rules/kernel.pl (or rules/store.pl).
 */
#include "install.h"

install_t
install_sanggwan(void)
{
#define SG_GLUE(name) sg_install_##name();
#include "glue.def"
#undef SG_GLUE
}
