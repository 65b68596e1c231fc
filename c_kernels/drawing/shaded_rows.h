/* shaded_rows.h -- what doors of shaded pictures are told.
 *
 * Layer: rows.
 */
#ifndef SG_SHADED_ROWS_H
#define SG_SHADED_ROWS_H

#include "doors/image.h"
#include "shading/cover.h"

/* How, looks and leaves, arguments 2, 3 and 4 of the call, of *in all but the
 * scene; *opacities lasts as long as *in does. False: refused. */
bool sg_shaded_read(sg_call *call, const sg_image_how *how,
                    const sg_shading_look_list *looks,
                    const sg_list_count_list *leaves, sg_shaded *in,
                    sg_opacities *opacities);

/* Whether it is good; else the call ends, or has no memory. */
bool sg_shaded_ended(sg_call *call, sg_shading_end end);

#endif
