/* solid_region4pl.h -- the region of some leaves in a boundary, behind a Prolog
 * handle.
 *
 * Layer: glue. Include it before SWI-Prolog.h.
 */
#ifndef SG_SOLID_REGION4PL_H
#define SG_SOLID_REGION4PL_H

#include "rows/append4pl.h"
#include "solid_old.h"

/* The relations of solid_old.h. */
extern const sg_relation sg_old_relation[SG_OLD_RELATIONS];

typedef struct sg_region_handle {
  int32_t s;
  uint64_t stamp;                 /* of the segment, when it was read */
  const sg_version *version;      /* held; null: closed */
  sg_view view[SG_OLD_RELATIONS]; /* of that */
  sg_solid_old old;
} sg_region_handle;

/* The open region that t names: type_error, existence_error. */
int sg_get_region_ex(term_t t, sg_region_handle **out);

#endif
