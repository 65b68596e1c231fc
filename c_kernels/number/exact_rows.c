/* exact_rows.c -- what exact decisions cost.
 *
 * Layer: rows.
 */
#include "doors/world.h"
#include "exact.h"

bool
sg_door_exact_fallbacks(sg_call *call, size_t *count)
{
  (void)call;
  *count = sg_exact_fallbacks();
  return true;
}

bool
sg_door_exact_statistics(sg_call *call, sg_exact_counts *out)
{
  (void)call;
  *out = (sg_exact_counts){.orient2d = sg_exact_fallbacks_of(SG_ASKED_ORIENT2D),
                           .orient3d = sg_exact_fallbacks_of(SG_ASKED_ORIENT3D),
                           .turn = sg_exact_fallbacks_of(SG_ASKED_TURN),
                           .side = sg_exact_fallbacks_of(SG_ASKED_SIDE),
                           .along = sg_exact_fallbacks_of(SG_ASKED_ALONG),
                           .compare = sg_exact_fallbacks_of(SG_ASKED_COMPARE)};
  return true;
}
