/* scene_model.h -- what a scene knows of a model whatever the eye: its lines,
 * one for the directed edges between two vertices, the polygons that use them
 * and how they bend there, and which segments are solid.
 *
 * Layer: kernel. Made once and kept (scene_kept_rows.c); every picture takes
 * its places and sides from the screen and the rest from here.
 */
#ifndef SG_SCENE_MODEL_H
#define SG_SCENE_MODEL_H

#include "engine/cancel.h"
#include "known_surface.h"
#include "rows/dense.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* How the faces at an edge lie to the eye. A face is on the edge's left or
 * right in the picture; seen edge-on it is on neither side. */
typedef struct sg_look {
  unsigned faces;          /* how often polygons use the edge, both ways */
  unsigned towards, away;  /* faces turned to the eye, turned from it */
  unsigned left, right;    /* of the line from a to b */
  double bend;             /* degrees from flat, the largest; 0 to 180; where
                              faces stand for known surfaces, of these
                              (known_surface.h) */
  bool edge;               /* different surfaces or named faces meet there, not
                              tangent; in a scene also where a crease of a
                              mesh goes on (crease.h) */
  bool solid;              /* nobody sees the backs of its segment's faces */
  bool cut;                /* it is (part of) a penetration line, but for one
                              along which operands are tangent */
  bool inside;             /* it lies inside a curved sheet (smooth.h), whose
                              outline does not run along its edges */
  bool speck;              /* it bends, but is a speck (crease.h) */
  bool substitute_outline; /* an added line that is drawn only where no other
                     line is near (contour.h) */
} sg_look;

/* One real edge, drawn for all its directed ones; or, with a negative id, a
 * line that was added (scene.h). */
typedef struct sg_scene_line {
  int32_t s, e;    /* the smallest id of the real directed edges */
  uint32_t a, b;   /* its start and end: places in sg_scene.at */
  uint32_t number; /* its place in the model; UINT32_MAX: an added one */
  sg_look look;
} sg_scene_line;

/* The same whatever the eye: one of a model, which are many. */
typedef struct sg_model_line {
  int32_t s, e;
  uint32_t a, b;  /* places of vertices */
  double bend;    /* as in sg_look */
  uint32_t faces; /* and so are these */
  bool edge, solid, cut;
} sg_model_line;

/* A polygon uses a line: from a to b (along 1) or from b to a (-1). */
typedef struct sg_scene_use {
  int32_t polygon; /* a place */
  int32_t along;
} sg_scene_use;

typedef struct sg_scene_model {
  sg_dense dense;
  bool *solid;    /* [segments] nobody sees the backs of its faces */
  bool *flat;     /* [polygons] its triangles lie in one plane */
  uint32_t *same; /* [vertices] the first of those that penetration lines say
                     are one point */
  sg_known_surfaces surfaces; /* that its polygons stand for */
  uint32_t (*cut)[2];         /* [cuts] places of the ends of all such pieces of
                                 penetration lines, copies too */
  size_t cuts;
  size_t lines;
  double *facet_bend;    /* [lines] of the faces, whatever they stand for; null:
                            no surface is known */
  sg_model_line *line;   /* sorted by (s, e) */
  uint32_t *use_begin;   /* [lines + 1] */
  sg_scene_use *use;     /* line by line, in the order of the polygons */
  int32_t *use_triangle; /* [uses] of a polygon that is not flat, the triangle
                            (a place) that has the line; else -1; null: all
                            polygons are flat */
  uint32_t *copy_begin;  /* [lines + 1]; null: no line has copies */
  sg_scene_use *copy;    /* the same for polygons that use copies of a line */
} sg_scene_model;

/* A penetration line runs from vertex a to b. Where it is the second copy of a
 * line, a2 and b2 are that one's ends, the same ones if it is an edge of what a
 * Boolean made of its operands; else -1. Places. */
typedef struct sg_scene_cut {
  int32_t a, b;
  int32_t a2, b2;
} sg_scene_cut;

/* The model of some segments; solid[]: which of them are of kind solid. Of the
 * copies of a penetration line all but the first are left out, and edges
 * without a real one.
 *
 * surfaces: of the polygons of `dense`; null: none is known.
 *
 * Returns: null: stopped by the cancellation, or no memory (then *memory is
 * false). Owner:   takes the arrays of `dense`, `surfaces` and `solid` over, in
 * any case; the model is the caller's, sg_scene_model_close(). */
sg_scene_model *sg_scene_model_open(sg_dense *dense,
                                    sg_known_surfaces *surfaces, bool *solid,
                                    const sg_scene_cut *cut, size_t cuts,
                                    const sg_cancel *cancel, bool *memory);
/* How much line k bends, in degrees: its surfaces, or its faces if its segment
 * is one of those (null: none) that are what their facets are. */
double sg_scene_bend(const sg_scene_model *model, const bool *faceted,
                     size_t k);

/* The half of the longest side of the model's box. */
double sg_scene_size(const sg_scene_model *model);

/* True if the polygon (a place) is flat and uses the line or a copy of it: then
 * the line lies on all of its triangles. */
bool sg_scene_lies_on(const sg_scene_model *model, uint32_t line,
                      int32_t polygon);

void sg_scene_model_close(sg_scene_model *model);

#endif
