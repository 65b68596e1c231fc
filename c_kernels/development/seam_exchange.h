/* seam_exchange.h -- folds taken back for better ones, so that a seam is
 * shorter.
 *
 * Layer: kernel. Inexact, as flattening.h is. Joining in the order of the least
 * seam makes the shortest one only where nothing is refused: a joint that was
 * refused might be worth more than a fold that is in its way. So seams are
 * tried once more, in that order. A *turn* for one of them:
 *
 * - If its faces are connected, the fold on the way between them that comes
 * last in the order is taken back, if it comes after the seam.
 * - The seam is joined. As long as two faces would overlap, the fold on the way
 *   between them that comes last is taken back: SG_EXCHANGE_CUTS at most.
 * - What came off is joined again where it can be, in the order.
 *
 * If the seam of the whole is shorter after that, all stays so; if not, it
 * becomes what it was. Turns go round and round until none of a whole round has
 * helped, or the effort is spent. Folds that are flat or to be kept are never
 * taken back. Nothing ever overlaps, and the seam never gets longer.
 *
 * Source: exchange along cycles, as in minimum spanning trees (R. E. Tarjan,
 * Data Structures and Network Algorithms, 1983, chapter 6), with more than one
 * edge leaving where an overlap asks for it.
 */
#ifndef SG_SEAM_EXCHANGE_H
#define SG_SEAM_EXCHANGE_H

#include "flattening.h"

#define SG_EXCHANGE_CUTS 4

typedef struct sg_exchange_input {
  sg_flattening *flattening; /* joined as far as it goes */
  const uint32_t *order;     /* [joints] all of them, as they were joined */
  const bool *kept;          /* [joints] folds that stay; null: none */
  bool pieces;               /* fewer of them is worth any seam */
  size_t effort; /* faces laid or moved, about: 20 million a second */
} sg_exchange_input;

typedef struct sg_exchange_end {
  size_t turns, exchanges; /* all, and those that helped */
  bool settled;            /* no turn is left that would help */
} sg_exchange_end;

/* Exchanges what can be; joints that are not joined become
 * SG_JOINT_SAME, SG_JOINT_OVERLAP or SG_JOINT_SHORT, as they are in the end.
 *
 * Returns: false: no memory, or (*stopped) stopped by the cancellation; then
 * the flattening is to be restarted. */
bool sg_seam_exchange(const sg_exchange_input *in, const sg_cancel *cancel,
                      sg_exchange_end *out, bool *stopped);

/* The length of all joints that are neither folds nor have sides that lie on
 * each other all the same; model units. */
double sg_seam_length(const sg_flattening *flattening);

#endif
