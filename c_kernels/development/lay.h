/* lay.h -- where everything finally lies in a pattern.
 *
 * Layer: kernel. When it is known which joints are folds, every piece is laid
 * out once more, from its root along the folds, in numbers of twice the digits:
 * a corner is where it lies from the side that its face hangs on, as in the
 * solid. So rounding does not grow along a piece, and folding it back gives the
 * solid. The ends of a fold are one vertex. Where the two sides of a joint come
 * to lie on each other without having been joined (all round a flat vertex)
 * they are a fold as well.
 *
 * Pieces are numbered from 1, the largest area first; each is turned so that
 * its smallest box lies along the axes, longer side along x. They lie in rows
 * from the origin, with gaps.
 */
#ifndef SG_LAY_H
#define SG_LAY_H

#include "flattening.h"

typedef struct sg_lay_input {
  sg_flattening *flattening;
  double touch;  /* sides nearer than this lie on each other, model units */
  uint32_t root; /* a face: its piece is 1, it lies unturned, its longest side
                    going up from the origin; or SG_NO_FACE */
} sg_lay_input;

#define SG_NO_FACE UINT32_MAX

/* Sides lie on each other if they are nearer than this part of the solid's
 * size. Ends that become one vertex move by as much, so the tolerance of the
 * model would be too much for folding back to 1e-12. */
#define SG_LAY_TOUCH 5e-13

typedef struct sg_layout {
  size_t pieces;
  uint32_t *piece; /* [faces] from 0 */
  uint32_t *root;  /* [pieces] faces */
  size_t vertices;
  uint32_t *vertex; /* [corners] from 0, in the order of their first corners */
  uint32_t *first;  /* [vertices] the first corner of each */
  double (*at)[2];  /* [vertices] */
  sg_flat_box *box; /* [pieces] */
} sg_layout;

/* Lays out what is joined. Joints whose sides lie on each other become
 * SG_JOINT_CLOSED.
 *
 * Returns: false: no memory, or (*stopped) stopped by the cancellation.
 * Owner:   sg_layout_clear() in any case. */
bool sg_lay(const sg_lay_input *input, const sg_cancel *cancel, sg_layout *out,
            bool *stopped);
void sg_layout_clear(sg_layout *layout);

static inline bool
sg_joint_is_fold(sg_joint_state state)
{
  return state == SG_JOINT_JOINED || state == SG_JOINT_CLOSED;
}

#endif
