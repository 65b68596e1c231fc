/* places.h -- which points are in one place.
 *
 * Layer: kernel. Exact: equal coordinates, and -0.0 is 0.0.
 */
#ifndef SG_PLACES_H
#define SG_PLACES_H

#include "engine/cancel.h"

#include <stddef.h>
#include <stdint.h>

/* For each of n points, the first that is where it is.
 *
 * Returns: null: no memory, or the cancellation said stop.
 * Owner:   the caller, to free(). */
uint32_t *sg_places_of(const double (*at)[3], size_t n,
                       const sg_cancel *cancel);

#endif
