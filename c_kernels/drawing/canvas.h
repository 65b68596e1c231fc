/* canvas.h -- lines with smooth edges: a dot is covered as far as it is.
 *
 * Layer: kernel. Inexact, but the same everywhere: sums, products and square
 * roots of doubles, no fused ones.
 *
 * A dot is a square; across a line it is covered by as much of its breadth as
 * lies within half the width from the middle of the line, as if the dot was
 * turned to face the line. That is exact for lines along rows and columns, and
 * within a few hundredths for others; also for lines thinner than a dot.
 */
#ifndef SG_CANVAS_H
#define SG_CANVAS_H

#include "engine/cancel.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* One colour: red, green, blue. */
typedef uint8_t sg_colour[3];

/* Dots by rows from the top, x to the right, y DOWN; the middle of the first
 * is at 0.5, 0.5. Owner: sg_canvas_clear(). */
typedef struct sg_canvas {
  int32_t width, height;
  sg_colour *dot; /* [height][width] */
  uint8_t *cover; /* [height][width]: of the line being drawn, else 0 */
} sg_canvas;

/* The brush of a line: its width in dots, > 0, its colour, and whether its
 * ends are round (half the width longer) or end where the line does. */
typedef struct sg_brush {
  double width;
  sg_colour colour;
  bool round;
} sg_brush;

/* A canvas of blank paper. Requires: sg_raster_size_is_valid(). False: no
 * memory. */
bool sg_canvas_open(sg_canvas *out, int32_t width, int32_t height,
                    const sg_colour paper);
void sg_canvas_clear(sg_canvas *canvas);

/* Draws the line point[0], point[1], ... point[n - 1], in dots, over what is
 * there; joints are round, and a dot covered by several pieces counts once.
 * What is outside is left out. Requires: finite coordinates; n >= 1.
 * Returns false if `cancel` said stop: then the canvas is of no use. */
bool sg_canvas_line(sg_canvas *canvas, const sg_brush *brush, size_t n,
                    const double (*point)[2], const sg_cancel *cancel);

#endif
