/* parts.h -- the fused kernel of the hidden-line rule: the drawn parts of all
 * lines of a scene at once.
 *
 * Layer: kernel. It computes what rules/picture/hidden_lines.pl and
 * rules/picture/role.pl define, as long as no decision in them is replaced; a
 * test holds the two against each other.
 */
#ifndef SG_PARTS_H
#define SG_PARTS_H

#include "hide_search.h"
#include "line_role.h"
#include "thread_pool.h"

/* A part of a line that is longer than this is the whole line. */
#define SG_WHOLE 0.999

typedef struct sg_drawn_part {
  uint32_t line;   /* place in scene->line */
  double from, to; /* 0 <= from < to <= 1 */
  bool hidden;
  sg_role role;
} sg_drawn_part;

/* What is drawn of a scene. */
typedef struct sg_drawing {
  sg_which which;
  double crease; /* the bend, in degrees, over which an edge is a crease */
  sg_hide_throughs through;
} sg_drawing;

/* The drawn parts, sorted by line and from, the same for any thread pool (null:
 * the caller alone). *out is to be freed by the caller. False: stopped by the
 * cancellation, or no memory (then *memory is false). */
bool sg_parts_of(const sg_mask_grid *masks, const sg_drawing *drawing,
                 sg_pool *pool, const sg_cancel *cancel, sg_drawn_part **out,
                 size_t *n, bool *memory);

#endif
