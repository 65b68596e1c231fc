/* hide.h -- the tests of the hidden-line joins (hide_search.h): which part of a
 * line a triangle hides, and which part lies on another line in the picture.
 *
 * Layer: kernel. Parts of a line are intervals of its parameter in the
 * picture: 0 at its start, 1 at its end.
 *
 * Source: [PL] section 6.3 step 4 (PL-13). Three deviations: depths are
 * compared across the triangle's plane, not along z, so that steep triangles
 * are judged like others; a line that goes through a triangle is hidden from
 * there on; ends of lines snap to the triangle's sides where they are close,
 * so that a line behind a border is hidden, and one beside it is not.
 */
#ifndef SG_HIDE_H
#define SG_HIDE_H

#include "number/bounds.h"
#include "scene.h"

#include <math.h>

/* Parts that are not longer than this are not drawn (standardised units). */
#define SG_SHORTEST 1e-7

typedef struct sg_hidden {
  double from, to; /* 0 <= from < to <= 1 */
  uint32_t mask;   /* place in scene->mask */
} sg_hidden;

/* A mask and a line that lie on one another in the picture. */
typedef struct sg_cover {
  double from, to;  /* of the line */
  double behind[2]; /* there: how far the line is behind the mask, along z */
} sg_cover;

typedef struct sg_overlap {
  double from, to;   /* of the line asked for */
  double from2, to2; /* the same points on the other line, from2 at from */
  uint32_t line;     /* the other line: place in scene->line */
} sg_overlap;

/* The part of the line that the mask hides; false: none. The line is one of
 * scene->line. The mask never hides a line that lies on it: between two of its
 * corners, an edge of its polygon (or a copy of one, by a penetration line), or
 * said to lie on it; nor one in its plane. A mask also hides a substitute
 * outline that lies before it, if it is near: there the surface goes on. */
bool sg_mask_hides(const sg_scene *scene, const sg_scene_mask *mask,
                   const sg_scene_line *line, sg_hidden *out);

/* The part of the line that the mask lies on in the picture, whichever of them
 * is in front; false: none. It is what sg_mask_hides() asks the depth of. */
bool sg_mask_covers(const sg_scene *scene, const sg_scene_mask *mask,
                    const sg_scene_line *line, sg_cover *out);

/* Lines that turn by more than this (a tangent) do not lie on one another:
 * where they are close they are so for a few places only. */
#define SG_OVERLAP_TURN 0.03125

/* The same of lines that are near one another. */
#define SG_NEAR_TURN 1.0

/* The part of line a that lies on line b in the picture; false: none longer
 * than what is close. If a stands in and b does not: the part that is near b,
 * across b, where a runs along b more than across. */
bool sg_lines_overlap(const sg_scene *scene, const sg_scene_line *a,
                      const sg_scene_line *b, sg_overlap *out);

/* Masks that begin farther from the eye hide nothing of the line. */
static inline double
sg_line_far_end(const sg_scene *scene, const sg_scene_line *line)
{
  return line->look.substitute_outline
             ? INFINITY
             : sg_larger(scene->at[line->a][2], scene->at[line->b][2]);
}

/* True if line a is a substitute outline and b is not: then a yields to b
 * where b is near, not only where b lies on it. */
static inline bool
sg_line_yields_near(const sg_scene_line *a, const sg_scene_line *b)
{
  return a->look.substitute_outline && !b->look.substitute_outline;
}

/* The length of a line in the picture, standardised. */
double sg_line_length(const sg_scene *scene, const sg_scene_line *line);

#endif
