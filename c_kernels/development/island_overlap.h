/* island_overlap.h -- whether an island, moved to where a joint wants it,
 * overlaps another one.
 *
 * Layer: kernel. Inexact.
 */
#ifndef SG_ISLAND_OVERLAP_H
#define SG_ISLAND_OVERLAP_H

#include "flattening.h"

/* A turn by an angle with this cosine and sine about `from`, which goes to
 * `to`. */
typedef struct sg_motion {
  double cosine, sine, from[2], to[2];
} sg_motion;

static inline void
sg_motion_move(const sg_motion *m, const double p[2], double out[2])
{
  double x = p[0] - m->from[0], y = p[1] - m->from[1];

  out[0] = m->to[0] + m->cosine * x - m->sine * y;
  out[1] = m->to[1] + m->sine * x + m->cosine * y;
}

/* What an island would be joined by: a side of it. */
typedef struct sg_island_attempt {
  const sg_island *moving, *onto;
  uint32_t side;
  sg_motion motion;
} sg_island_attempt;

/* Whether a triangle of one island, moved, overlaps one of the other deeper
 * than is allowed: then fl->overlap has their faces. An attempt that fails
 * should fail soon: what is likely to overlap is tried first. False: stopped by
 * the cancellation. */
bool sg_island_overlaps(sg_flattening *fl, const sg_island_attempt *attempt,
                        const sg_cancel *cancel, bool *overlap);

/* True: the cancellation says stop. It is asked after many triangles were
 * moved, whichever joints they were moved for (fl->moves). */
bool sg_flattening_stops(sg_flattening *fl, const sg_cancel *cancel);

#endif
