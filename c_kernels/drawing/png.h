/* png.h -- a raster, or a canvas, as a PNG file in memory, by zlib.
 *
 * Layer: kernel. No time and no name in the file: same dots, same bytes.
 * Source: PNG specification (third edition), sections 5, 9 and 11.
 */
#ifndef SG_PNG_H
#define SG_PNG_H

#include "canvas.h"
#include "raster.h"

typedef enum sg_png_status {
  SG_PNG_OK,
  SG_PNG_NO_MEMORY,
  SG_PNG_NO_COLOUR, /* a dot has an ink that the palette has not */
  SG_PNG_STOPPED    /* `cancel` said so */
} sg_png_status;

/* Writes the raster with colours palette[ink]; 1, 2, 4 or 8 bits a dot, as
 * few as the palette needs. Requires 1 .. 256 colours.
 * Owner: free(*bytes) when SG_PNG_OK, else *bytes is null. */
sg_png_status sg_png_write(const sg_raster *raster, size_t colours,
                           const sg_colour *palette, const sg_cancel *cancel,
                           uint8_t **bytes, size_t *n);

/* The same of a canvas: three bytes a dot. `per_metre` dots are a metre; 0:
 * the file does not say how large it is. */
sg_png_status sg_png_write_canvas(const sg_canvas *canvas, uint32_t per_metre,
                                  const sg_cancel *cancel, uint8_t **bytes,
                                  size_t *n);

#endif
