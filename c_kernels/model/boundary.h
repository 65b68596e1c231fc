/* boundary.h -- the boundary of a segment as a file will hold it: rounded,
 * without what rounding has collapsed, and as closed as it was.
 *
 * Layer: kernel. A face is a set of directed edges, as a polygon is in p/3, so
 * holes and islands need no special form. Vertices that are in one place after
 * rounding are one vertex. That cannot open anything: where every directed edge
 * had its opposite it still has, whichever vertices are put together; edges of
 * no length and pairs of opposite edges in one face can go, since they add
 * nothing to that sum, and with them the faces that have no others.
 *
 * Vertices are numbered by their coordinates, so what is made from a boundary
 * does not depend on ids, nor on how the segment was made.
 */
#ifndef SG_BOUNDARY_H
#define SG_BOUNDARY_H

#include "rows/dense.h"

/* Where coordinates are rounded to: multiples of `grid` (a power of two; 0: as
 * they are), then to float32 if `single`. */
typedef struct sg_rounding {
  double grid;
  bool single;
} sg_rounding;

/* Whether a face looks to the side it did. Inexact. */
enum sg_facing {
  SG_UPRIGHT,
  SG_TURNED, /* turned over, so it is thinner than the rounding */
  SG_NO_AREA /* none that doubles can tell */
};

typedef struct sg_boundary {
  double grain; /* of the source, or what it is rounded to (flatness.h) */
  size_t vertices;
  double (*at)[3];      /* [vertices] ascending by x, y, z; all different */
  double (*was)[3];     /* [vertices] before rounding; of several the lowest */
  unsigned char *moved; /* [vertices] not where the vertex was, or it was
                           made by a cut and so rounded before */
  size_t faces;
  uint32_t *begin;        /* [faces + 1] */
  int32_t (*edge)[2];     /* [begin[faces]] from, to; never equal, and no face
                             has an edge and its opposite */
  unsigned char *changed; /* [faces] it has a moved vertex, other edges than
                             before, or more than three: not the triangle that
                             the segment has */
  unsigned char *turned;  /* [faces] what rounding did to it: sg_facing */
} sg_boundary;

typedef enum sg_boundary_end {
  SG_BOUNDARY_DONE,
  SG_BOUNDARY_NO_MEMORY,
  SG_BOUNDARY_STOPPED,
  SG_BOUNDARY_TOO_FAR /* a coordinate is out of the range of float32 */
} sg_boundary_end;

/* The polygons of segment s (a place of dense), and what else is known. */
typedef struct sg_boundary_source {
  const sg_dense *dense;
  size_t s;
  const unsigned char *made;   /* [vertices] made by a cut, so its coordinates
                                  are rounded; or null */
  const double (*normal)[3];   /* [polygons] which side is out; 0 0 0: as its
                                  vertices say; or null */
  const unsigned char *coarse; /* [vertices] only these go to the grid; or
                                  null: all */
  bool divided;                /* every polygon goes as its triangles */
} sg_boundary_source;

/* Cost:  n log n for the vertices, else linear.
 * Owner: sg_boundary_clear() in any case. */
sg_boundary_end sg_boundary_make(const sg_boundary_source *source,
                                 const sg_rounding *rounding,
                                 const sg_cancel *cancel, sg_boundary *out);
void sg_boundary_clear(sg_boundary *boundary);

/* Takes out the faces whose vertices are all on one line (exact), those of
 * SG_NO_AREA and, if `turned`, of SG_TURNED. What lay along a long edge of such
 * a face gets the vertices in between: the edge is turned. Other faces keep
 * their places in space, except what was thinner than the rounding, and edges
 * their opposites. False: no memory. */
bool sg_boundary_drop_flat(sg_boundary *boundary, bool turned);

/* Puts n edges in an order of their own without those that are opposite in
 * pairs; returns how many are left. */
size_t sg_edges_cancel(int32_t (*edge)[2], size_t n);

#endif
