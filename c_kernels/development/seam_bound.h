/* seam_bound.h -- a length that no seam of a development can be less than.
 *
 * Layer: kernel. Inexact: angles and lengths are rounded.
 *
 * What is bent at a vertex is how much the angles round it are short of a whole
 * turn. Go round a connected part of a seam, in the pieces beside it:
 * in the plane each such way turns once, to the left if it is the outside of a
 * piece and to the right if it is a hole. So, by Gauss and Bonnet, what the
 * part has at its vertices sums to a multiple of two whole turns (4 pi), if it
 * does not reach a border. A set of vertices whose sum is no such multiple is
 * *unbalanced*: some seam leaves it. From that follow three bounds:
 *
 * - tree: if every vertex is pointed (bent by more than nothing), no set of
 *   some vertices of a closed shell is balanced, but all are: the seam is a
 * tree over all of them. The shortest one is the minimum spanning tree. So it
 * is where there is a border, if all vertices inside are bent by less than two
 *   whole turns together: else some of them may be balanced, and no seam needs
 * to reach the border (a box with a hole in a face).
 * - forest: if no vertex is flat, all are on the seam. It has no more parts
 * than balanced sets can be found; pairs and triples of vertices are counted,
 * all others have four or more. A minimum spanning tree less so many of its
 *   longest edges.
 * - moats: round each unbalanced set of vertices a moat that no other one
 *   overlaps. Each is crossed by a seam, so their widths add up to a bound.
 *   They grow as in the method of Goemans and Williamson.
 *
 * A border is one vertex, which balances everything; so are the vertices of
 * faces without area.
 *
 * Source: M. X. Goemans, D. P. Williamson, A general approximation technique
 * for constrained forest problems, 1995 (the dual); the first is folklore.
 */
#ifndef SG_SEAM_BOUND_H
#define SG_SEAM_BOUND_H

#include "flattening.h"

typedef enum sg_bound_by {
  SG_BOUND_TREE,
  SG_BOUND_FOREST,
  SG_BOUND_MOATS
} sg_bound_by;

typedef struct sg_seam_bound {
  double tree;    /* the minimum spanning tree of the vertices, model units */
  double bound;   /* the largest that is proven */
  sg_bound_by by; /* how */
} sg_seam_bound;

/* Models with more joints have moats as wide as half the shortest edge at each
 * vertex. */
#define SG_BOUND_JOINTS 10000

/* False: no memory, or (*stopped) stopped by the cancellation. */
bool sg_seam_bound_find(const sg_flattening *flattening,
                        const sg_cancel *cancel, sg_seam_bound *out,
                        bool *stopped);

#endif
