/* face_merge_hold.h -- where other bodies touch a face along an edge.
 *
 * Layer: kernel, private to face_merge. Such an edge is a chord of the face and
 * no edge of its polygon; but the chord has to stay, so that both have it.
 */
#ifndef SG_FACE_MERGE_HOLD_H
#define SG_FACE_MERGE_HOLD_H

#include "face_merge_private.h"

typedef struct sg_holds {
  uint32_t (*pair)[2]; /* [n]: from and to, each both ways, in order */
  size_t n, room;
} sg_holds;

/* The chords of a group along which a face of another label has a border; what
 * was there before goes. False: no memory.
 * Owner of out->pair: caller, free(). Requires: fate is known. */
bool sg_holds_find(const sg_merge *m, const sg_group *group, sg_holds *out);

bool sg_holds_have(const sg_holds *holds, uint32_t from, uint32_t to);
/* One of them ends at v. */
bool sg_holds_reach(const sg_holds *holds, uint32_t v);

#endif
