/* dot_part.h -- what the dots of a row show, face by face.
 *
 * Layer: kernel. What cover.h adds up, for a rule that decides of each dot.
 */
#ifndef SG_DOT_PART_H
#define SG_DOT_PART_H

#include "cover.h"
#include "engine/list.h"

typedef struct sg_dot_part {
  int32_t x; /* the dot */
  int32_t root, leaf, face;
  uint32_t share;    /* of lines * 256 * SG_OPAQUE */
  uint32_t light[3]; /* of that face there, linear */
} sg_dot_part;

typedef SG_LIST_OF(sg_dot_part) sg_dot_parts;

/* The parts of the dots of row y: by dot, leaf and face, each once. The light
 * is that in the middle of the widest piece of it. False: no memory. */
bool sg_dot_parts_of(const sg_shaded *in, sg_shading_work *work,
                     sg_spans *spans, int32_t y, sg_dot_parts *out);

#endif
