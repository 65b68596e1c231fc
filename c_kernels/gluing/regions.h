/* regions.h -- the regions of space between the faces of one segment.
 *
 * Layer: kernel. A soup of faces, turned any way, is divided into regions: face
 * F has a side below it and one above it, behind it and where its normal
 * points. Round an edge what is after a page is before the next one; at a
 * vertex where several disks meet the sphere map says what they bound together
 * (sphere_map.h); parts that hang together by edges alone are located by an
 * exact walk (join/tour.h). Edges without a face are wires, vertices without an
 * edge are lone.
 *
 * A face is what its triangles are, with the corners where the doubles are;
 * faces have vertices in common where they meet, and meet nowhere else: but a
 * vertex may be told to lie inside a face, as a point loop of it. Faces that
 * lie on each other have a slit between them.
 *
 * Both laws hold of what is right (V vertices, E edges, F faces, L connected
 * parts of borders of faces, C parts, R regions, S shells, G their genus):
 *
 *     V - E + 2F - L = S - G         S = C + R - 1
 *
 * R is counted from sides and walks, S from sides, wedges and zones, G from
 * what each shell has of these, so neither holds by construction.
 */
#ifndef SG_REGIONS_H
#define SG_REGIONS_H

#include "rows/dense.h"

/* Vertex v (a place) lies inside polygon p. */
typedef struct sg_point_loop {
  uint32_t v, p;
} sg_point_loop;

/* A side of what is round a vertex (places): of the corner where `edge` starts
 * at it; of the wire `edge`, which has one; of `polygon`, inside of which the
 * vertex lies, if edge is UINT32_MAX. */
typedef struct sg_disk_side {
  uint32_t edge, polygon;
  bool above;
} sg_disk_side;

/* At vertex v these two sides have one zone. */
typedef struct sg_zone_meeting {
  uint32_t v;
  sg_disk_side side[2];
} sg_zone_meeting;

/* What is told of vertices of several disks, instead of the sphere map: where
 * it says nothing each cycle has a zone of its own. */
typedef struct sg_zones_told {
  const sg_zone_meeting *meeting; /* [n] by vertex */
  size_t n;
} sg_zones_told;

typedef enum sg_region_role {
  SG_REGION_OUTSIDE, /* the one without end */
  SG_REGION_CELL,
  SG_REGION_VOID, /* of operands: in none of them */
  SG_REGION_SLIT  /* between faces that lie on each other */
} sg_region_role;

typedef struct sg_space_region {
  sg_region_role role;
  size_t faces;  /* with a side, or both, in it */
  size_t behind; /* that it is behind */
  size_t shells, wires, lone;
  int64_t genus;       /* of all its shells */
  double volume, area; /* rounded; of the outside 0, and of all its sides */
} sg_space_region;

/* A connected border of a region. */
typedef struct sg_region_shell {
  uint32_t region; /* from 0 */
  int32_t polygon; /* a polygon, a place, that has a side in it, or -1: */
  int32_t edge;    /* a wire, or -1: a lone vertex */
  int64_t euler;
  uint32_t first; /* private */
} sg_region_shell;

typedef struct sg_wire {
  uint32_t edge; /* a place: of edges without a face between two vertices the
                    first */
  uint32_t region;
} sg_wire;

typedef struct sg_lone_vertex {
  uint32_t v, region;
} sg_lone_vertex;

typedef struct sg_regions {
  size_t vertices, edges, faces, loops, parts;
  int64_t genus;
  size_t twisted; /* shells whose genus is no number: not of a surface; and what
                     of a shell is in another region than the rest */
  size_t dropped; /* polygons without area, which are no faces */
  size_t doubtful; /* parts that lie on faces of others */
  size_t regions, shells, wires, lone;
  uint32_t *side; /* [2 * polygons] below, above: the region, from 0; dropped:
                     UINT32_MAX */
  sg_space_region
      *region; /* the bounded ones by the last face that they are behind, or
                   else the last one that they are before; then the outside */
  sg_region_shell *shell; /* by region, then as their sides come */
  sg_wire *wire;
  sg_lone_vertex *lone_vertex;
} sg_regions;

typedef enum sg_regions_end {
  SG_REGIONS_DONE,
  SG_REGIONS_NO_MEMORY,
  SG_REGIONS_STOPPED,
  SG_REGIONS_OPEN,     /* the loops of a polygon do not close */
  SG_REGIONS_TRIANGLES /* its triangles do not end where it does */
} sg_regions_end;

/* Of a segment that is alone in `dense`; told: NULL, or how disks lie; *bad:
 * the polygon, a place, that is no face.
 *
 * Owner: sg_regions_clear() in any case.
 * Cost:  n log n of edges and faces. */
sg_regions_end sg_regions_make(const sg_dense *dense,
                               const sg_point_loop *point_loop, size_t n,
                               const sg_zones_told *told,
                               const sg_cancel *cancel, sg_regions *out,
                               size_t *bad);
void sg_regions_clear(sg_regions *regions);

#endif
