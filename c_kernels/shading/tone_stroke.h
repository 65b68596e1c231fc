/* tone_stroke.h -- scan lines that a pen draws: the parts of lines on which
 * what is seen is darker than a tone.
 *
 * Layer: kernel. On a flat face all of a span is, or none; on a bent one its
 * ends are found by halving between places that are `step` apart.
 */
#ifndef SG_TONE_STROKE_H
#define SG_TONE_STROKE_H

#include "cover.h"
#include "engine/list.h"

typedef struct sg_tone_stroke {
  double y, x1, x2; /* dots */
} sg_tone_stroke;

typedef SG_LIST_OF(sg_tone_stroke) sg_tone_strokes;

/* Lines are `spacing` dots apart: one is in the middle of the first `spacing`
 * dots. Adds strokes to `out` from above and from the left. Of what is
 * see-through the front counts. GOOD, NO_MEMORY or STOPPED. */
sg_shading_end sg_tone_strokes_of(const sg_shading *scene,
                                  const sg_looks *looks, double spacing,
                                  uint32_t tone, double step,
                                  const sg_cancel *cancel,
                                  sg_tone_strokes *out);

#endif
