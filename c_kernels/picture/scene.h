/* scene.h -- a picture's lines and triangles, ready for the hidden-line join.
 *
 * Layer: kernel. A scene is what one view shows of a model (scene_model.h), and
 * does not change after that. It answers three questions:
 *   how do the faces at each line lie to the eye (sg_scene_line);  which
 *   triangles can hide something (sg_scene_mask);
 *   where is everything, standardised to [-1,1] (PL-5).
 *
 * Picture coordinates as in view.h: x right, y up, z away from the eye.
 * Source: [PL] section 6.3, steps 1 to 3 (PL-13).
 */
#ifndef SG_SCENE_H
#define SG_SCENE_H

#include "line_role.h"
#include "scene_model.h"

/* Lines nearer than this part of the picture's longer side tell of one another:
 * where one is seen, nobody misses the other. */
#define SG_NEAR 2.5e-3

/* A line that is no edge, such as a piece of an outline inside triangles. */
typedef struct sg_scene_added {
  int32_t s, e;           /* e < 0; no two have the same s and e */
  double screen[2][3];    /* where it begins and ends in the picture */
  const int32_t *lies_on; /* [triangles] places in the model: they never hide
                             it */
  size_t triangles;
  int32_t divides; /* a place in the model: this triangle hides as its parts do
                      (scene_divided.h) */
  uint8_t side[2]; /* of it, 0 to 2, where the line begins and ends; one side:
                      it divides nothing */
  double
      folded; /* its last part, 0 to 1, is hidden by the surface it lies on */
  sg_look look;
} sg_scene_added;

/* A line along a side of a triangle that is turned to the eye otherwise than
 * the triangle is (contour.h). */
typedef struct sg_scene_facing {
  int32_t s;
  int32_t triangle;       /* its place in the model */
  uint32_t v[2];          /* where the side begins and ends: places */
  double from, to;        /* the part that the surface hides; equal: none */
  const int32_t *lies_on; /* [triangles] as of an added line */
  size_t triangles;
} sg_scene_facing;

/* What a scene is made from; the arrays belong to the caller. */
typedef struct sg_scene_input {
  const sg_scene_model *model;
  const double (*screen)[3];   /* [vertices] of the model */
  const bool *shown;           /* [vertices] that have a place; null: all */
  const sg_scene_added *added; /* [addeds] */
  size_t addeds;
  const sg_scene_facing *facing; /* [facings] */
  size_t facings;
  const bool *curved;  /* [polygons] that lie in curved sheets (smooth.h), whose
                          outlines are among `added`; null: none */
  const bool *faceted; /* [segments] that are what their facets are; null:
                          none */
  const uint8_t *creases; /* [lines] of the model, as sg_creases_find(); null:
                             all are as they are bent */
  double crease;          /* degrees: sheets end at edges that bend more */
  const sg_lines_drawn *only; /* null: all lines */
  double depth;     /* model units in one unit of screen z: 1 if parallel */
  double tolerance; /* what counts as equal, for a model of size [-1,1] */
} sg_scene_input;

/* A triangle that can hide lines, or a part of one that an outline divides. */
typedef struct sg_scene_mask {
  int32_t s, t;
  int32_t triangle; /* the place of the triangle in the model */
  uint32_t v[3];    /* counter-clockwise in the picture; the first is no vertex
                       of the model if it is a part */
  double normal[3]; /* unit; [2] > 0: away from the eye */
  double low[3], high[3];
} sg_scene_mask;

/* A part of a line that a smooth surface it lies on hides. */
typedef struct sg_scene_fold {
  int32_t s;       /* the segment of the surface */
  double from, to; /* 0 <= from < to <= 1 */
} sg_scene_fold;

typedef struct sg_scene {
  const sg_scene_model *model; /* what it was made from */
  double (*at)[3];      /* [vertices], standardised; the model's come first */
  sg_scene_line *line;  /* sorted by (s, e) */
  sg_scene_fold *fold;  /* line by line */
  uint32_t *fold_begin; /* [lines + 1] null: no line has any */
  uint32_t *lies_begin; /* [lines + 1] null: no line says what it lies on */
  int32_t *lies_on; /* the triangles that added lines, and those with facings,
                       lie on: places in the model */
  sg_scene_mask *mask; /* nearest first: sorted by low[2], rounded down to a
                          float, then by triangle */
  size_t vertices, lines, masks;
  double tolerance; /* what is nearer to a plane than this lies in it */
  double close;     /* what is nearer than this is in one place of the picture:
                       SG_ONE_PLACE of its longer side */
  double near;  /* what is nearer than this tells of one another: SG_NEAR of the
                   picture's longer side */
  double scale; /* picture units in one standardised unit, a power of 2: x and y
                   are from -1 to 1 */
} sg_scene;

/* Lines and triangles that have a vertex without a place are left out. If only
 * the lines of a drawing are wanted, the others are left out, and so are
 * triangles that come near none of them in the picture. Vertices
 * that penetration lines say are one point have one place. The scene needs the
 * model as long as it is used, and nothing else of its input.
 *
 * Returns: null: stopped by the cancellation, or no memory (then *memory is
 * false). Owner:   the caller, sg_scene_close(). */
sg_scene *sg_scene_open(const sg_scene_input *input, const sg_cancel *cancel,
                        bool *memory);
void sg_scene_close(sg_scene *scene);

/* The folds of a line. */
typedef struct sg_scene_folds {
  const sg_scene_fold *at;
  size_t n;
} sg_scene_folds;

sg_scene_folds sg_scene_folds_of(const sg_scene *scene, uint32_t line);

/* The place of edge (s, e) in scene->line; SIZE_MAX: not there. */
size_t sg_scene_find(const sg_scene *scene, int32_t s, int32_t e);

/* True if the paper's step 2 makes the line hidden at once: all its faces that
 * are not edge-on are back faces of a solid. */
bool sg_look_is_back(const sg_look *look);

#endif
