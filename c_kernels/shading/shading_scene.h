/* shading_scene.h -- what a shaded picture is made from: leaves and trees.
 *
 * Layer: kernel. Axes of a picture: x to the right and y DOWN, in dots from its
 * upper left corner; z away from the eye, in units of about a dot. Both
 * projections are one 4 x 4 matrix M: a model point (p, 1) is seen at
 * M (p, 1), divided by the fourth coordinate, which must be positive. So planes
 * stay planes and quadrics stay quadrics.
 *
 * A leaf is a closed solid: flat polygons, or a convex body bounded by one
 * quadric, or by two that meet in a plane, and by planes across. Several leaves
 * may have one number: they are parts of what the user calls a leaf. A root is
 * an expression over leaves.
 *
 * Build: open, add leaves with their faces, add roots with their nodes, seal.
 * Then lines may be asked by several threads, each with a work of its own. All
 * is inexact, by square roots at most: the same on every machine.
 */
#ifndef SG_SHADING_SCENE_H
#define SG_SHADING_SCENE_H

#include "engine/cancel.h"
#include "owner.h"
#include "picture/known_surface.h"
#include "solid/expression.h"
#include "span.h"

typedef struct sg_shading sg_shading;
typedef struct sg_shading_work sg_shading_work;

typedef enum sg_shading_end {
  SG_SHADING_GOOD,
  SG_SHADING_NO_MEMORY,
  SG_SHADING_STOPPED,
  SG_SHADING_BEHIND_EYE /* a point is not in front of the eye */
} sg_shading_end;

typedef struct sg_shading_frame {
  double matrix[4][4];
  int32_t width, height; /* dots, at least 1; width at most 2^22 */
  double tolerance;      /* dots: what is nearer in depth is in one place */
  bool box;              /* nothing is wanted but sg_shading_box() */
} sg_shading_frame;

/* What a leaf has of a quadric. In coordinates x, y, h along U, V, W from C: a
 * sphere x^2 + y^2 + h^2 = 1; else tapered, x^2 + y^2 = (1 - h + h k)^2. It is
 * bounded where h = low and h = high; face 0: another piece goes on there; less
 * than 0: not bounded there. */
typedef struct sg_shading_piece {
  bool sphere;
  double frame[4][3]; /* C, U, V, W: model units */
  double k;
  double low, high;
  int32_t low_face, high_face, face;
} sg_shading_piece;

/* Null: no memory. */
sg_shading *sg_shading_open(const sg_shading_frame *frame);
void sg_shading_close(sg_shading *scene);

/* A leaf with no face yet; they count from 0. UINT32_MAX: no memory. */
uint32_t sg_shading_add_leaf(sg_shading *scene, int32_t number);
/* A corner of polygons, in model units: its number. */
sg_shading_end sg_shading_add_corner(sg_shading *scene, const double p[3],
                                     uint32_t *corner);
/* A flat polygon of the last leaf: `loops` loops, loop i of count[i] corners,
 * one after the other. */
sg_shading_end sg_shading_add_polygon(sg_shading *scene, int32_t face,
                                      const uint32_t *corner,
                                      const size_t *count, size_t loops);
/* A piece of the last leaf, which has no polygons. */
sg_shading_end sg_shading_add_piece(sg_shading *scene,
                                    const sg_shading_piece *piece);
/* A surface that facets may stand for, as sg_known_surface_init(): its number,
 * from 1; 0: no memory. */
uint32_t sg_shading_add_known(sg_shading *scene, sg_known_surface_kind kind,
                              const double frame[][3], double a, double b);
/* Polygons that are added from here on stand for this surface: they are seen
 * with its normals. 0, as at first: for themselves. */
void sg_shading_stand_for(sg_shading *scene, uint32_t known);

/* A torus (sqrt(x^2 + y^2) - 1)^2 + h^2 = k^2, as facets. */
typedef struct sg_shading_ring {
  double frame[4][3]; /* C, U, V, W: model units */
  double k;
  int32_t face;
} sg_shading_ring;

sg_shading_end sg_shading_add_ring(sg_shading *scene,
                                   const sg_shading_ring *ring);
/* A bicubic Bezier patch (picture/bezier_patch.h), a face of the last leaf. */
typedef struct sg_shading_patch {
  double control[16][3]; /* model units */
  int32_t face;
} sg_shading_patch;

/* Patches, as facets no farther from them than an eighth of a dot. What is not
 * in the picture has none. */
sg_shading_end sg_shading_add_net(sg_shading *scene,
                                  const sg_shading_patch *patch, size_t n);
/* Starts a root: its nodes follow, each before its operands. */
bool sg_shading_add_root(sg_shading *scene, int32_t root);
/* As sg_expression_add(), of the last root: `parent` counts from 0 in it, and
 * is 0 for the first; a leaf by its place. SIZE_MAX: no memory. */
size_t sg_shading_add_node(sg_shading *scene, size_t parent,
                           sg_operation operation, uint32_t leaf);
/* When all is there. Surfaces nearer than the tolerance become one. */
sg_shading_end sg_shading_seal(sg_shading *scene, const sg_cancel *cancel);

/* From here on which one of faces that lie in one another is seen is asked of
 * its owners (owner.h); else, and until there is an answer, it is that of the
 * first leaf that makes its root begin there, or end. False: no memory. */
bool sg_shading_ask_owners(sg_shading *scene);
/* From here on the root with the segment `front` does not hide the other one:
 * where the other one is met next behind it, that counts as nearer. Roots that
 * are not there are left out. False: no memory. */
bool sg_shading_let_through(sg_shading *scene, int32_t front, int32_t behind);

/* Null: they are not asked. Borrowed. */
sg_owners *sg_shading_owners(const sg_shading *scene);

/* Numbers for faces: that of face F of the leaf with number L is the entry
 * first[L] + F of `of`, if it is before first[L + 1], else entry first[L].
 * Borrowed. */
typedef struct sg_face_numbers {
  const uint32_t *first; /* [numbers of leaves + 2] */
  const uint32_t *of;    /* [first[numbers of leaves + 1]] */
} sg_face_numbers;

static inline uint32_t
sg_face_number(const sg_face_numbers *numbers, int32_t leaf, int32_t face)
{
  uint32_t first = numbers->first[leaf], at = first + (uint32_t)face;

  return numbers->of[at < numbers->first[leaf + 1] ? at : first];
}

/* How opaque faces are: opacity[number], 0 .. SG_OPAQUE. Borrowed. */
typedef struct sg_opacities {
  const uint32_t *opacity;
  sg_face_numbers numbers;
} sg_opacities;

/* Null: no memory. Owner: one thread. `opacities` null: all is opaque. Else the
 * line of sight goes on behind a face that is not: at each face where its root
 * begins or ends, as much of the light is its own as it is opaque, and the rest
 * comes from behind. */
sg_shading_work *sg_shading_work_open(const sg_shading *scene,
                                      const sg_opacities *opacities);
void sg_shading_work_close(sg_shading_work *work);
/* The same of the scene of light i, for the same thread: `work` keeps it. Null:
 * no memory. */
sg_shading_work *sg_shading_work_of_light(sg_shading_work *work, unsigned i,
                                          const sg_shading *scene);
/* Whether memory was wanting since it was opened. */
bool sg_shading_work_failed(const sg_shading_work *work);

/* The spans of the line y, 0 <= y < height. False: no memory. */
bool sg_shading_line(const sg_shading *scene, sg_shading_work *work, double y,
                     sg_spans *spans);

/* A part of a line, in 1/256 dot: what is between `from` and `to`, or what is
 * not. */
typedef struct sg_line_part {
  int32_t from, to;
  bool beyond;
} sg_line_part;

/* The same of a part; spans may reach out of it. */
bool sg_shading_line_part(const sg_shading *scene, sg_shading_work *work,
                          double y, const sg_line_part *part, sg_spans *spans);

/* What is seen at (x, y) of a span, x in dots: how deep, and which way the
 * seen side looks, a unit vector of the model's axes. */
void sg_shading_point(const sg_shading *scene, const sg_span *span, double x,
                      double y, double *depth, double normal[3]);

/* Whether what of a span is seen at `own`, a place of it, and by its root at
 * `at`, near to it, is one sheet; of what is no torus it is. */
bool sg_shading_sees_same(const sg_shading *scene, const sg_span *span,
                          const double own[2], const double at[2]);

/* The point of the model that is seen at a point of the picture. */
void sg_shading_place(const sg_shading *scene, const double seen[3],
                      double out[3]);

/* Of one normal, by sg_shading_point(). */
bool sg_shading_is_flat(const sg_shading *scene, const sg_span *span);

/* Of a facet that stands for a known surface. */
bool sg_shading_is_faceted(const sg_shading *scene, const sg_span *span);

/* The box round all faces, in the picture. False: there are none. */
bool sg_shading_box(const sg_shading *scene, double low[3], double high[3]);

const sg_shading_frame *sg_shading_frame_of(const sg_shading *scene);

#endif
