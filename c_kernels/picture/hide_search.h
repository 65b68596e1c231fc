/* hide_search.h -- the hidden-line joins: all triangles that hide a part of a
 * line, and all lines that lie on one in the picture.
 *
 * Layer: kernel. Both walk the cells of a grid along the line and leave out by
 * a few comparisons what certainly does not matter; the tests of hide.h decide.
 * Any number of threads may ask, each with what it has seen. What a question
 * finds out of a cell, the grid keeps for the next one; no answer depends on
 * it.
 */
#ifndef SG_HIDE_SEARCH_H
#define SG_HIDE_SEARCH_H

#include "grid.h"
#include "hide.h"

/* Growing arrays, used again by every question. */
typedef struct sg_hiddens {
  sg_hidden *part;
  size_t n, room;
  sg_hidden *span; /* if some are enough: the union so far */
  size_t spans, span_room;
} sg_hiddens;

void sg_hiddens_clear(sg_hiddens *hiddens);

/* The same; free(part) at the end. */
typedef struct sg_overlaps {
  sg_overlap *part;
  size_t n, room;
} sg_overlaps;

/* Which things a question has met already: they stand in several cells. */
typedef struct sg_seen {
  uint32_t *by; /* by which question */
  uint32_t question;
} sg_seen;

/* For n things. False: no memory. */
bool sg_seen_init(sg_seen *seen, size_t n);
void sg_seen_clear(sg_seen *seen);

/* ---- masks ---- */

/* Segment s2 lets the lines of segment s be seen. */
typedef struct sg_hide_through {
  int32_t s, s2;
} sg_hide_through;

/* Which segments let which be seen: sorted, of the caller. */
typedef struct sg_hide_throughs {
  const sg_hide_through *pair;
  size_t n;
} sg_hide_throughs;

/* True if segment s2 lets the lines of segment s be seen: then none of its
 * masks hides them, nor does step 2 if they are one (sg_look_is_back()). */
bool sg_hide_sees_through(const sg_hide_throughs *through, int32_t s,
                          int32_t s2);

/* The box of a mask, widened by what is close in x and y, and rounded
 * outwards to floats. */
typedef struct sg_mask_box {
  float low[3], high[2];
} sg_mask_box;

/* The masks of one cell by how near they come there: a depth that no point of
 * the mask in this cell is nearer than, by sg_depth_order(), then the mask. */
typedef uint64_t sg_mask_order;

/* Depths along the x and y of the grid. */
typedef struct sg_near_plane {
  double depth, rise[2]; /* in the origin */
} sg_near_plane;

/* A cell of many masks. `seen` are those that are in front in some places of
 * it, so they hide much; SG_NO_MASK: nothing is there. Depths there are those
 * behind the plane of one that most of the others are behind. `cover` is one
 * that covers all of the cell, before and behind which there are few;
 * SG_NO_MASK: there is none. What it does not hide there, the masks after the
 * first `front` do not hide, if it may. */
#define SG_NO_MASK UINT32_MAX
enum { SG_SEEN_PLACES = 5 };
typedef struct sg_mask_near {
  sg_near_plane plane;
  uint32_t seen[SG_SEEN_PLACES], cover;
  uint32_t front, n;
  sg_mask_order order[]; /* [n] all of the cell; the first `front` are sorted */
} sg_mask_near;

typedef struct sg_mask_grid {
  const sg_scene *scene;
  double way[2]; /* x of the grid: that of most sides, if they have one */
  sg_grid grid;
  sg_mask_box *box;              /* [masks] */
  _Atomic(sg_mask_near *) *near; /* [cells of the grid] null: not asked yet */
} sg_mask_grid;

/* Requires: the scene stays open as long. False: stopped by the cancellation,
 * or no memory (then *memory is false). Owner: the caller, in any case. */
bool sg_mask_grid_init(sg_mask_grid *masks, const sg_scene *scene,
                       const sg_cancel *cancel, bool *memory);
void sg_mask_grid_clear(sg_mask_grid *masks);

/* All masks that hide a part of line `at` and do not let it be seen, sorted by
 * from, to and mask. through: null for none. `enough`: some are enough that
 * together hide what all of them hide. seen: of the masks. False: no memory. */
bool sg_mask_grid_ask(const sg_mask_grid *masks, size_t at,
                      const sg_hide_throughs *through, bool enough,
                      sg_seen *seen, sg_hiddens *out);

/* ---- lines ---- */

/* Where a line is in the picture. */
typedef struct sg_stretch {
  double from[2], to[2];
  double length;
} sg_stretch;

/* Lines that lie on one another have nearly one direction: each class of
 * directions has a grid of its own.
 *
 * The part that two lines have in common ends, both ways, at an end of one of
 * them. So of a class of long lines, each in many cells, only those cells are
 * looked at where an end is: `from`, the end that more of them have, or `to`.
 * Where `from` is one place for two, the other end of what they have in common
 * is elsewhere: however many lines leave one point, they are not asked there.
 */
enum { SG_LINE_CLASSES = 32 };

typedef struct sg_line_grid {
  const sg_scene *scene;
  const uint32_t *line; /* [n] the lines that are in it, ascending */
  size_t n;
  size_t begin[SG_LINE_CLASSES + 1]; /* of each class in order[] */
  uint32_t *order;                   /* [n] places in line[], class by class */
  uint32_t *place;                   /* [n] of line[i] in order[] */
  sg_stretch *stretch;               /* [n] as order[] */
  double way[SG_LINE_CLASSES][2];    /* along most of a class: the x of, */
  sg_grid grid[SG_LINE_CLASSES];     /* of its stretches */
  sg_grid tip[SG_LINE_CLASSES];      /* of a class of long ones, which are
                                        sorted by `from`: of each `to` */
} sg_line_grid;

/* As sg_mask_grid_init(), of some lines; line[] stays the caller's. */
bool sg_line_grid_init(sg_line_grid *lines, const sg_scene *scene,
                       const uint32_t *line, size_t n, const sg_cancel *cancel,
                       bool *memory);
void sg_line_grid_clear(sg_line_grid *lines);

/* All lines of the grid that overlap line[i], sorted by line. seen: of the n.
 * False: no memory. */
bool sg_line_grid_ask(const sg_line_grid *lines, size_t i, sg_seen *seen,
                      sg_overlaps *out);

#endif
