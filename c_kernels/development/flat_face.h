/* flat_face.h -- the faces that a development lays flat, each in a frame of its
 * own.
 *
 * Layer: kernel. Places only, inexact. A *face* is a polygon that is flat
 * within the tolerance, or a triangle of one that is not. Its *corners* are the
 * vertices it has, each once; its *sides* are its directed edges, or, in a
 * triangle of a polygon that is not flat, a *chord*: numbered on from the edges
 * of the segment. So is a side along an edge that another side has already,
 * which is a fault of the model: each side has a number of its own.
 *
 * The frame of a face: its first corner is the origin, x runs along its longest
 * side, the normal looks to the reader, who sees the outside. This is R1 and Rk
 * of the paper's transform at once.
 *
 * Source: H.-C. Chae and I.-S. Chung 1989, section 5.1 (DV-4).
 */
#ifndef SG_FLAT_FACE_H
#define SG_FLAT_FACE_H

#include "rows/dense.h"

typedef struct sg_flat_side {
  uint32_t edge;     /* place in the segment; from dense.edges on: a chord */
  uint32_t from, to; /* corners */
} sg_flat_side;

typedef struct sg_flat_faces {
  size_t faces;
  uint32_t *polygon;     /* [faces] places of polygons, ascending */
  double (*normal)[3];   /* [faces] unit, outward */
  double *area;          /* [faces] model units squared */
  uint32_t *longest;     /* [faces] the longest side */
  bool *bent;            /* [polygons] not flat: in triangles */
  size_t bents;          /* how many */
  size_t bent_faces;     /* their triangles */
  uint32_t *bent_before; /* [faces] faces before it that are of such */
  size_t corners;
  uint32_t *corner_begin; /* [faces + 1] */
  int32_t *vertex;        /* [corners] places of vertices */
  double (*at)[2];        /* [corners] in the frame of the face */
  size_t sides, chords;
  uint32_t *side_begin; /* [faces + 1] */
  sg_flat_side *side;   /* [sides] */
  uint32_t *face_of;    /* [sides] */
  uint32_t *side_of;    /* [edges + chords] or SG_NO_SIDE_OF: in no face */
  size_t triangles;
  uint32_t *triangle_begin; /* [faces + 1] */
  uint32_t (*triangle)[3];  /* [triangles] corners */
  uint32_t *triangle_place; /* [triangles] in the segment */
  uint32_t *triangle_face;  /* [triangles] */
} sg_flat_faces;

#define SG_NO_SIDE_OF UINT32_MAX

/* Where a side begins and ends in the segment: places of vertices. */
static inline int32_t
sg_flat_side_from(const sg_flat_faces *f, uint32_t side)
{
  return f->vertex[f->side[side].from];
}

static inline int32_t
sg_flat_side_to(const sg_flat_faces *f, uint32_t side)
{
  return f->vertex[f->side[side].to];
}

/* The faces of a segment with triangles, but of those polygons that are
 * `removed` ([polygons]; null: none). A polygon is flat if no vertex is farther
 * from its plane than `tolerance`. One that has no triangles (it has no area)
 * is a face without any.
 *
 * Returns: false: no memory, or (*stopped) stopped by the cancellation.
 * Owner:   sg_flat_faces_clear() in any case. */
bool sg_flat_faces_make(const sg_dense *dense, const bool *removed,
                        double tolerance, const sg_cancel *cancel,
                        sg_flat_faces *out, bool *stopped);
void sg_flat_faces_clear(sg_flat_faces *faces);

/* Gives a face without area the normal of a face that it leans on, made square
 * to its longest side, and its corners their places. */
void sg_flat_face_lean(sg_flat_faces *faces, const sg_dense *dense,
                       uint32_t face, const double normal[3]);

#endif
