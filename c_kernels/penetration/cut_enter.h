/* cut_enter.h -- a polygon, and the lines that run in it, as a scratch
 * relation.
 *
 * Layer: kernel. A polygon comes as its outline, rows of e/5; where ends of
 * cuts lie on an edge it is divided. Pieces of lines that meet nothing there
 * enter as edge pairs: that is all that happens to most polygons. The cut set,
 * which is sealed and whose points have names, is only read, and each thread
 * has a scratch relation of its own.
 *
 * Source: row PL-8, steps 4 and 5.
 */
#ifndef SG_CUT_ENTER_H
#define SG_CUT_ENTER_H

#include "cut_set.h"
#include "polygon/triangulate.h"
#include "polygon/work.h"

/* An edge of a polygon: a row of e/5 except for the segment; a fold
 * (cut_fold_rows.c) has the number 0. */
typedef struct sg_outline_edge {
  int32_t e, v1, v2, et;
} sg_outline_edge;

typedef struct sg_outline {
  int32_t s, p;
  double normal[3]; /* finite, not (0,0,0) */
  size_t first, n;  /* edge[first .. first + n - 1] of all */
} sg_outline;

/* Owner: sg_outlines_clear(). All zero: none. */
typedef struct sg_outlines {
  sg_outline *polygon;   /* [n] */
  sg_outline_edge *edge; /* [edges] */
  size_t n, edges, room, edge_room;
} sg_outlines;

/* A polygon that lines have entered, as it stands in its scratch relation. */
typedef struct sg_entered {
  int32_t s, p;
  sg_work *work;
} sg_entered;

/* A new outline, the last one; and an edge of it. False: no memory. */
bool sg_outlines_add(sg_outlines *all, int32_t s, int32_t p,
                     const double normal[3]);
bool sg_outlines_add_edge(sg_outlines *all, const sg_outline_edge *edge);
void sg_outlines_clear(sg_outlines *all);

/* The points on edge v1-v2 of segment s; null: there are none. */
const sg_split_edge *sg_cut_split_edge(const sg_cut_set *set, int32_t s,
                                       int32_t v1, int32_t v2);

/* Whether a work has a vertex of this name (an sg_is_good_name). */
bool sg_cut_is_in_work(const void *work, int32_t v);

/* The edges of outline i go into an empty work, opened with its normal, in
 * pieces, labelled with their numbers; and so do the ends of its lines. An edge
 * of a vertex that is nowhere, or of a point without a name: SG_STUCK. */
sg_outcome sg_cut_enter_outline(const sg_cut_set *set, const sg_outlines *all,
                                size_t i, sg_work *work);

/* All pieces of polygon p enter its work, labelled -1 less their numbers: 1. If
 * one meets anything but in shared vertices, or was divided elsewhere: 0, and
 * the work is as it was. No memory: -1. `met` is scratch. Exact. */
int sg_cut_enter_free(const sg_cut_set *set, sg_work *work, int32_t s,
                      int32_t p, sg_meetings *met);

#endif
