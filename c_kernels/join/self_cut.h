/* self_cut.h -- where a segment goes through itself.
 *
 * Layer: kernel. The join of the triangles of one segment with themselves.
 * Triangles are neighbours where they have corners in one place, whatever the
 * vertices are called; neighbours must have more in common than those corners
 * and the edge between them. Whether two triangles have something in common is
 * exact (cut.h). What it is called is not: what reaches no farther than the
 * tolerance through the other is TOUCHING, and neighbours that meet only so
 * close to what their polygons share do not meet.
 *
 * Triangles without area have nothing in common with others. Sheets that cross
 * exactly along edges they share are for the census (edges of more than two
 * polygons, vertices in one place).
 */
#ifndef SG_SELF_CUT_H
#define SG_SELF_CUT_H

#include "rows/dense.h"
#include "thread_pool.h"

typedef enum sg_self_kind {
  SG_SELF_PENETRATION, /* they go through each other */
  SG_SELF_OVERLAP,     /* they lie in one plane and share some area */
  SG_SELF_TOUCHING,    /* a point or an edge of one is on the other */
  SG_SELF_KINDS
} sg_self_kind;

typedef struct sg_self_meeting {
  sg_self_kind kind;
  int32_t t[2]; /* places of triangles, t[0] < t[1] */
  int32_t p[2]; /* ids of their polygons, p[0] <= p[1] */
  double at[3]; /* a point of what they have in common; inexact */
  bool line;    /* that is more than points */
} sg_self_meeting;

typedef struct sg_self_meetings {
  size_t n;
  sg_self_meeting *item; /* by t[0], t[1] */
} sg_self_meetings;

/* The meetings of the triangles of segment s (a place). A tolerance of 0 makes
 * the kinds exact too.
 *
 * Returns: false: no memory, or the cancellation said stop; *out is empty.
 * Owner:   out->item is the caller's, to free().
 * Cost:    about linear, plus the meetings; the same for any thread pool. */
bool sg_self_cut(const sg_dense *dense, size_t s, double tolerance,
                 sg_pool *pool, const sg_cancel *cancel, sg_self_meetings *out);

/* Those of them that a triangle has part in that is `changed` (of the triangles
 * of s): for a segment whose other triangles are known not to meet. in_faces:
 * also of two triangles of one polygon that is exactly flat and looks one way
 * everywhere; else those are known not to. */
bool sg_self_cut_changed(const sg_dense *dense, size_t s,
                         const unsigned char *changed, bool in_faces,
                         double tolerance, sg_pool *pool,
                         const sg_cancel *cancel, sg_self_meetings *out);

/* Those of triangles of polygons that are not left out: [polygons] of s, or
 * null: of all. */
bool sg_self_cut_some(const sg_dense *dense, size_t s,
                      const unsigned char *left_out, double tolerance,
                      sg_pool *pool, const sg_cancel *cancel,
                      sg_self_meetings *out);

/* Keeps one meeting of each two polygons, of the first kind there is, in the
 * order of the polygons. */
void sg_self_by_polygon(sg_self_meetings *meetings);

/* The tolerance of the segment's source (flatness.h). */
double sg_self_tolerance(const sg_dense *dense, size_t s);

#endif
