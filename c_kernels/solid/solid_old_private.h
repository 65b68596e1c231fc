/* solid_old_private.h -- what the files of solid_old.h share.
 *
 * Layer: kernel.
 */
#ifndef SG_SOLID_OLD_PRIVATE_H
#define SG_SOLID_OLD_PRIVATE_H

#include "solid_old.h"

enum { SPREAD = 1 << 16 }; /* ids beyond four times as many as rows */

/* The largest id in a column; unfit if it is far beyond the number of rows. */
sg_old_end sg_old_find_most(const sg_solid_old *old, int relation,
                            unsigned column, const sg_cancel *cancel,
                            int32_t *most);

/* Of all rows of the segment those of the region are left; held[] and most of
 * all ids, and region (solid_old_region.c). */
sg_old_end sg_old_narrow(sg_solid_old *old, const int32_t *leaf, size_t n,
                         int32_t (*item_vertex)(const uint32_t *item),
                         const sg_cancel *cancel);

#endif
