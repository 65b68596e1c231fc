/* region_content.h -- which solids each region of space is inside.
 *
 * Layer: kernel. The outside is inside none; who crosses a face goes in or out
 * of the solids that it is a part of. Where a solid lies on itself one goes out
 * of it and in again.
 */
#ifndef SG_REGION_CONTENT_H
#define SG_REGION_CONTENT_H

#include "engine/cancel.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_content_faces {
  size_t faces;
  const uint32_t *side;  /* [2 * faces] below, above: the region, from 0 */
  const uint32_t *begin; /* [faces + 1] in `solid` */
  const int32_t *solid;  /* what a face is a part of, ascending; twice: it is
                            there on both sides */
} sg_content_faces;

/* Region r is inside solid[begin[r]] .. solid[begin[r + 1] - 1], ascending. */
typedef struct sg_region_content {
  size_t *begin; /* [regions + 1] */
  int32_t *solid;
} sg_region_content;

/* A region that no way leads to from `outside` is inside none. All ways to a
 * region say the same of it, unless faces are missing, or a region is beside a
 * face that it does not end at: *wrong is the number of faces where they do
 * not.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Owner:   sg_region_content_clear() in any case.
 * Cost:    of faces, and what is listed. */
bool sg_region_content_make(const sg_content_faces *faces, size_t regions,
                            uint32_t outside, const sg_cancel *cancel,
                            sg_region_content *out, size_t *wrong);
void sg_region_content_clear(sg_region_content *content);

#endif
