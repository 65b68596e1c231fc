/* spine.h -- how triangles lie round edges that many of them have.
 *
 * Layer: kernel. The boxes of n triangles on one edge all have it, so a join of
 * a tree with itself finds each two of them. Such an edge is a SPINE. Seen
 * along its line every triangle is an arc of a circle round it; where those of
 * two nodes are apart, the triangles have nothing in common but the spine or an
 * end of it, if it is theirs. That holds for triangles that are nowhere near
 * it, too. Inexact, and let out: what is said to be apart is.
 */
#ifndef SG_SPINE_H
#define SG_SPINE_H

#include "fan.h"

/* A name for a place: mostly no other has it. */
uint32_t sg_name_of_place(const double at[3]);

typedef struct sg_spines sg_spines;

/* *out is null if no edge is one. Corners are one where their names are equal,
 * or if `by_place`, where they are. False: no memory, or stopped. Owner:
 * sg_spines_close() in any case. Cost: linear. */
bool sg_spines_open(const sg_bvh *tree, sg_fan_read *read, const void *data,
                    bool by_place, const sg_cancel *cancel, sg_spines **out);
void sg_spines_close(sg_spines *spines);

/* Whether no triangle below box a of a level (1 or more) has more in common
 * with one below box b than corners of one name, and the edge between these. */
bool sg_spines_apart(const sg_spines *spines, unsigned level, size_t a,
                     size_t b);

#endif
