/* complete_private.h -- the rows that a completion writes.
 *
 * Layer: kernel, private to complete.c and complete_rows.c. What adds returns
 * false if there is no memory; sg_completion_clear() frees what was written.
 */
#ifndef SG_COMPLETE_PRIVATE_H
#define SG_COMPLETE_PRIVATE_H

#include "complete.h"
#include "plane.h"
#include "rows/key_table.h"

bool sg_complete_add_plane(sg_plane_rows *rows, int32_t s, int32_t p,
                           const sg_plane *plane);
/* It gets the next number of its segment; `counts` has how many each has. */
bool sg_complete_add_triangle(sg_triangle_rows *rows, sg_key_table *counts,
                              int32_t s, int32_t p, const int32_t v[3]);
bool sg_complete_add_fault(sg_completion *out, const sg_polygon_fault *fault);

#endif
