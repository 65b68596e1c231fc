/* bezier_grid.h -- a bicubic Bezier patch in n * n cells, as models have it.
 *
 * Layer: kernel. A patch has 16 control points, four rows of four: u goes along
 * a row, v from row to row. Points are exact, and rounded once: so a border
 * that two patches have in common has the same points in both, whichever way it
 * runs. What a picture needs is in picture/bezier_patch.h.
 */
#ifndef SG_BEZIER_GRID_H
#define SG_BEZIER_GRID_H

#include <stdbool.h>
#include <stddef.h>

enum { SG_BEZIER_MOST = 1000 }; /* cells of a side */

/* The points at u = i / n, v = j / n, 0 <= i, j <= n, are at[j * (n + 1) + i],
 * rounded once. turned[j * n + i]: in the cell from (i, j) on the diagonal from
 * (i, j) to (i + 1, j + 1) is longer than the other one; exact.
 * Requires: control points finite, 1 <= n <= SG_BEZIER_MOST. False: no memory.
 */
bool sg_bezier_grid(const double control[16][3], size_t n, double (*at)[3],
                    bool *turned);

#endif
