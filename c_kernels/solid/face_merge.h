/* face_merge.h -- coplanar neighbours of a solid become one face (CB-5).
 *
 * Layer: kernel. What may lie in one face is decided within a tolerance, on
 * rounded places; that everything stays as closed as it was is decided on the
 * numbers of vertices alone.
 *
 *   - Two faces are neighbours along an edge that has two half-edges, one each
 *     way: never along an edge with more, with one, or with two the same way.
 *   - Neighbours become one face if there is ONE plane that no vertex of any
 *     face in it is farther from than the tolerance, and all of them look the
 *     same way. A face no wider than the tolerance looks any way, and begins
 *     nothing. The largest face begins.
 *   - All round such a group the surface must end or bend off by more than 16
 *     tolerances. Else it is a part of something smooth that is finer than the
 *     tolerance, and only what is flat up to rounding becomes one.
 *   - A vertex in the middle of one face vanishes; so does one that lies
 *     straight between the only two edges that end there: all such vertices of
 *     a run are within the tolerance of the edge that replaces it, and none
 *     turns back. A vertex vanishes from all faces or from none.
 *   - Faces that lose vertices are triangulated again, n + 2 h - 2 triangles
 *     for n corners and h holes (and 2 for each vertex inside that belongs to
 *     another face too). Faces that lose none keep their triangles. An edge of
 *     another face in the middle, or a vertex, is no edge or vertex of the
 *     polygon, but stays one of its triangles.
 *   - Ends of an edge no longer than the tolerance are one vertex, and so are
 *     vertices made by cuts no farther apart; what that leaves nothing of goes.
 *   - Where the polygon that would come out is invalid (parts thinner than the
 *     tolerance), its vertices stay, and if that does not help its faces stay
 *     apart. So it is where its triangles would go through others, or lie on
 *     them, that the faces did not meet before: of sheets that are nearer than
 *     the tolerance. Nor does a face become the one side of a wall that has the
 *     other side in the same place. And vertices are not put together where
 * that would come of it.
 *
 * What comes out depends on neither the number of threads nor, except for equal
 * areas in equal places, on the order of faces.
 */
#ifndef SG_FACE_MERGE_H
#define SG_FACE_MERGE_H

#include "join/bvh.h"
#include "solid.h"
#include "thread_pool.h"

/* A side of polygon p of segment s: what a face is a part of. */
typedef struct sg_merge_side {
  int32_t s, p;
  bool reversed;
} sg_merge_side;

/* one < other; see sg_merge_pair_order(). */
typedef struct sg_merge_pair {
  sg_merge_side one, other;
} sg_merge_pair;

/* The solid is a part of a larger one: faces of these segments, and others
 * round them, which are there to be looked at. */
typedef struct sg_merge_region {
  const int32_t *s; /* [n]: ascending */
  size_t n;
  sg_box box; /* round the vertices of the other faces of the larger one */
  sg_box was; /* round all vertices when these others were merged */
} sg_merge_region;

typedef struct sg_merge_source {
  double rounding, explained; /* the second no less */
} sg_merge_source;

typedef struct sg_merge_options {
  double tolerance;           /* model units, >= 0; 4 units in the last place of
                                 the largest coordinate are the least */
  bool by_size;               /* no more than 2^-13 of the solid's own size: the
                                 tolerance may be that of a far larger model */
  bool separate;              /* never faces of different segments */
  bool cells;                 /* edges of more than two half-edges stay, also
                                 in the middle of faces */
  const sg_merge_pair *apart; /* [aparts]: sorted, never these */
  size_t aparts;
  const sg_merge_region *region; /* or null: the solid is all there is */
  /* How far vertices of segment s may be off: doubles that are moved are
     rounded so, or the sources were; null: not at all. */
  sg_merge_source (*source)(void *data, int32_t s);
  /* The way that polygon p of segment s looks; false, or null: not known. Any
     thread may ask. */
  bool (*normal)(void *data, int32_t s, int32_t p, double out[3]);
  void *data;
  sg_pool *pool; /* null: the caller alone */
  const sg_cancel *cancel;
} sg_merge_options;

typedef enum sg_merge_end {
  SG_MERGE_DONE,
  SG_MERGE_APART, /* a face of the region and another might be one, or the size
                     gives another tolerance now: that cannot be said without
                     what is beyond */
  SG_MERGE_STOPPED,
  SG_MERGE_NO_MEMORY
} sg_merge_end;

/* Vertices that vanish more than a hundredth of something away from what stays:
 * of an edge of their operand there, or of the thickness of a wall of an
 * operand, or of a slot; and the one that is worst beside it. */
typedef struct sg_merge_tight {
  size_t n;
  sg_solid_vertex vertex;
  double move, feature;
  bool wall; /* or slot: that is the feature */
} sg_merge_tight;

/* What was done. */
typedef struct sg_merge_counts {
  size_t faces_before, faces_after;
  size_t vertices_before, vertices_after;
  size_t triangles_before, triangles_after;
  size_t refused; /* groups of faces that stayed apart: invalid as one */
  sg_merge_tight rounded, tight; /* its source explains it, or not */
} sg_merge_counts;

/* Merges the faces of `solid`, drops vertices, also those in no triangle, and
 * numbers the rest again, in the same order; faces come in the order of the
 * last of their parts. A merged face is named after its largest part, and the
 * others are in `part`. Of a region only its faces are left: they are as in the
 * larger solid. `counts` may be null. If not done, the solid is as it was.
 * Requires: every triangle belongs to one face, and faces stand in the order of
 * their triangles. */
sg_merge_end sg_face_merge(sg_solid *solid, const sg_merge_options *options,
                           sg_merge_counts *counts);

/* The pairs of different sides that have faces which are neighbours and might
 * become one, sorted, each once: all that sg_face_merge() would look at.
 * Owner of *out: caller, free(). */
sg_merge_end sg_face_merge_pairs(const sg_solid *solid,
                                 const sg_merge_options *options,
                                 sg_merge_pair **out, size_t *n);

/* Puts the lesser side first. */
void sg_merge_pair_order(sg_merge_pair *pair);
/* The order of pairs, for qsort(). */
int sg_merge_pair_compare(const void *a, const void *b);

#endif
