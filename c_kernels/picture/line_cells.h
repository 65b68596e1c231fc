/* line_cells.h -- which cells of the picture the lines of a scene go through:
 * so what is near none of them is found by a few bits.
 *
 * Layer: kernel. Inexact, but conservative.
 */
#ifndef SG_LINE_CELLS_H
#define SG_LINE_CELLS_H

#include "grid.h"
#include "scene.h"

enum { SG_LINE_CELLS_A_SIDE = 128 };

typedef struct sg_line_cells {
  sg_grid grid;
  /* By row and column; 1: a line is there. */
  uint8_t has[SG_LINE_CELLS_A_SIDE][SG_LINE_CELLS_A_SIDE];
} sg_line_cells;

/* Of the lines of a scene, whose masks need not be there yet. */
void sg_line_cells_init(sg_line_cells *cells, const sg_scene *scene);

/* False: what lies in the box hides nothing of any line. */
bool sg_line_cells_near(const sg_line_cells *cells, const sg_grid_box *box);

#endif
