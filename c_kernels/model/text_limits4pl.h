/* text_limits4pl.h -- limits of texts in Prolog's terms.
 *
 * Layer: glue. False: an exception is pending.
 */
#ifndef SG_TEXT_LIMITS4PL_H
#define SG_TEXT_LIMITS4PL_H

#include "text_limits.h"

#include <SWI-Prolog.h>

/* limits(Depth, Blocks, Digits, Name, Fact, File). */
int sg_get_text_limits_ex(term_t t, sg_text_limits *out);

#endif
