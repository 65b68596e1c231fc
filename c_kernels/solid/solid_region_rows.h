/* solid_region_rows.h -- the region of some leaves in a boundary: what a handle
 * of solid_region/3 owns.
 *
 * Layer: rows.
 */
#ifndef SG_SOLID_REGION_ROWS_H
#define SG_SOLID_REGION_ROWS_H

#include "engine/store.h"
#include "solid_old.h"

typedef struct sg_region {
  int32_t s;
  uint64_t stamp;                 /* of the segment, when it was read */
  const sg_version *version;      /* held */
  sg_view view[SG_OLD_RELATIONS]; /* of that */
  sg_solid_old old;
} sg_region;

/* Null: nothing. */
void sg_region_free(sg_region *region);

#endif
