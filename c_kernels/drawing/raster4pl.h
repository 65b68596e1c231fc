/* raster4pl.h -- arguments that the doors of rasters and canvases share.
 *
 * Layer: glue.
 */
#ifndef SG_RASTER4PL_H
#define SG_RASTER4PL_H

#include "glue.h"
#include "png.h"

/* Reads rgb(R,G,B), bytes. False: an exception is pending. */
int sg_get_colour_ex(term_t rgb, sg_colour out);

/* Unifies with the bytes as a string of codes. */
int sg_unify_bytes(term_t t, const uint8_t *bytes, size_t n);

/* Raises domain_error(raster_size, Width-Height); false. */
int sg_raster_size_error(term_t width, term_t height);

#endif
