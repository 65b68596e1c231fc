/* hide.h -- the hidden-line joins: which triangles hide which part of a line,
 * and which lines lie on one another in the picture.
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

#include "grid.h"
#include "scene.h"

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

typedef struct sg_hiddens {
  sg_hidden *part;
  size_t n, room;
} sg_hiddens;

typedef struct sg_overlaps {
  sg_overlap *part;
  size_t n, room;
} sg_overlaps;

/* Segment s2 lets the lines of segment s be seen. */
typedef struct sg_hide_through {
  int32_t s, s2;
} sg_hide_through;

/* The search structures of a scene. One thread at a time. */
typedef struct sg_hide {
  const sg_scene *scene;
  sg_grid masks, lines;
  uint32_t *mask_seen, *line_seen; /* [masks], [lines]: by which question */
  uint32_t question;
  const sg_hide_through *through; /* [throughs], sorted; of the caller */
  size_t throughs;
} sg_hide;

/* Requires: the scene stays open as long. False: stopped by the poll, or no
 * memory (then *memory is false). */
bool sg_hide_init(sg_hide *hide, const sg_scene *scene, const sg_poll *poll,
                  bool *memory);
void sg_hide_clear(sg_hide *hide);

/* True if segment s2 lets the lines of segment s be seen: then none of its
 * masks hides them, nor does step 2 if they are one (sg_look_is_back()). */
bool sg_hide_sees_through(const sg_hide *hide, int32_t s, int32_t s2);

/* The part of the line that the mask hides; false: none. The line is one of
 * scene->line. The mask never hides a line that lies on it: between two of its
 * corners, an edge of its polygon (or a copy of one, by a penetration line), or
 * added as lying on it; nor one in its plane. */
bool sg_mask_hides(const sg_scene *scene, const sg_scene_mask *mask,
                   const sg_scene_line *line, sg_hidden *out);

/* The part of the line that the mask lies on in the picture, whichever of them
 * is in front; false: none. It is what sg_mask_hides() asks the depth of. */
bool sg_mask_covers(const sg_scene *scene, const sg_scene_mask *mask,
                    const sg_scene_line *line, sg_cover *out);

/* All masks that hide a part of line `at` and do not let it be seen, sorted by
 * from, to and mask. `enough`: stop at the first that hides all of it. False:
 * no memory. `out` is used again; its array belongs to the caller, who frees
 * it. */
bool sg_hide_masks(sg_hide *hide, size_t at, bool enough, sg_hiddens *out);

/* The part of line a that lies on line b in the picture; false: none longer
 * than what is close. */
bool sg_lines_overlap(const sg_scene *scene, const sg_scene_line *a,
                      const sg_scene_line *b, sg_overlap *out);

/* All lines that overlap line `at`, sorted by line. As sg_hide_masks(). */
bool sg_hide_overlaps(sg_hide *hide, size_t at, sg_overlaps *out);

/* The length of a line in the picture, standardised. */
double sg_line_length(const sg_scene *scene, const sg_scene_line *line);

#endif
