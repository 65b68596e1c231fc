/* grain_rows.h -- how fine the source of a segment was.
 *
 * Layer: rows. origin(S, s(S), source(Grain)) says one unit in the last place
 * of its coordinates, in model units. Without it they are doubles.
 */
#ifndef SG_GRAIN_ROWS_H
#define SG_GRAIN_ROWS_H

#include "engine/store.h"
#include "engine/symbol.h"
#include "engine/term.h"

/* Of segment s; 0: doubles. */
double sg_grain_of(const sg_version *version, int32_t s);

/* Of the coarsest of all segments that have a row of segment/3. False: no
 * memory. */
bool sg_grain_of_all(const sg_version *version, double *out);

#endif
