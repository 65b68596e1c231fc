/* scene.h -- a picture's lines and triangles, ready for the hidden-line join.
 *
 * Layer: kernel. A scene is built from the rows of one version of a world and
 * does not change after that. It answers three questions:
 *   which edges are there, one of each pair, and how do their faces lie to the
 *   eye (sg_scene_line);  which triangles can hide something (sg_scene_mask);
 *   where is everything, standardised to [-1,1] (PL-5).
 *
 * Picture coordinates as in view.h: x right, y up, z away from the eye.
 * Source: [PL] section 6.3, steps 1 to 3 (PL-13).
 */
#ifndef SG_SCENE_H
#define SG_SCENE_H

#include "poll.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a scene is made from. Each begins with segment and id. */
typedef struct sg_scene_segment {
  int32_t s, unused;
  bool solid; /* its back faces hide nothing and their edges are hidden;
                 cleared for one that has a border or is inside out */
} sg_scene_segment;

typedef struct sg_scene_vertex {
  int32_t s, v;
  double model[3];
  double screen[3];
} sg_scene_vertex;

typedef struct sg_scene_triangle {
  int32_t s, p, t;
  int32_t v[3]; /* counter-clockwise from outside */
} sg_scene_triangle;

typedef struct sg_scene_edge {
  int32_t s, e;
  int32_t v1, v2;
  bool real;
} sg_scene_edge;

/* Polygon p has edge e in its set. */
typedef struct sg_scene_use {
  int32_t s, e;
  int32_t p;
} sg_scene_use;

/* A penetration line runs from vertex a to b of segment s. Where it is the
 * second copy of a line of another segment, that one's ends; else s2 = 0. */
typedef struct sg_scene_cut {
  int32_t s, a, b;
  int32_t s2, a2, b2;
} sg_scene_cut;

/* The arrays belong to the caller; opening a scene sorts them in place. */
typedef struct sg_scene_input {
  sg_scene_segment *segment;
  sg_scene_vertex *vertex;
  sg_scene_triangle *triangle;
  sg_scene_edge *edge;
  sg_scene_use *use;
  sg_scene_cut *cut;
  size_t segments, vertices, triangles, edges, uses, cuts;
  double depth;     /* model units in one unit of screen z: 1 if parallel */
  double tolerance; /* what counts as equal, for a model of size [-1,1] */
} sg_scene_input;

/* How the faces at an edge lie to the eye. A face is on the edge's left or
 * right in the picture; seen edge-on it is on neither side. */
typedef struct sg_look {
  unsigned faces;         /* how often polygons use the edge, both ways */
  unsigned towards, away; /* faces turned to the eye, turned from it */
  unsigned left, right;   /* of the line from a to b */
  double bend;            /* degrees from flat, the largest; 0 to 180 */
  bool solid;             /* its segment is one, closed and not inside out */
  bool cut;               /* it is (part of) a penetration line */
} sg_look;

/* One real edge, drawn for all its directed ones. */
typedef struct sg_scene_line {
  int32_t s, e;  /* the smallest id of the real directed edges */
  uint32_t a, b; /* its start and end: places in sg_scene.at */
  sg_look look;
} sg_scene_line;

/* A triangle that can hide lines. */
typedef struct sg_scene_mask {
  int32_t s, t;
  uint32_t v[3];    /* counter-clockwise in the picture */
  double normal[3]; /* unit; [2] > 0: away from the eye */
  double low[3], high[3];
} sg_scene_mask;

typedef struct sg_scene {
  double (*at)[3];     /* [vertices], standardised */
  sg_scene_line *line; /* sorted by (s, e) */
  sg_scene_mask *mask; /* sorted by low[2], nearest first */
  size_t vertices, lines, masks;
  double tolerance;
  double scale; /* picture units in one standardised unit, a power of 2 */
} sg_scene;

/* Null: stopped by the poll, or no memory (then *memory is false). Second
 * copies of penetration lines and edges without a real one are left out.
 * Owner: the caller, sg_scene_close(). */
sg_scene *sg_scene_open(sg_scene_input *input, const sg_poll *poll,
                        bool *memory);
void sg_scene_close(sg_scene *scene);

/* The place of edge (s, e) in scene->line; SIZE_MAX: not there. */
size_t sg_scene_find(const sg_scene *scene, int32_t s, int32_t e);

/* True if the paper's step 2 makes the line hidden at once: all its faces that
 * are not edge-on are back faces of a solid. */
bool sg_look_is_back(const sg_look *look);

#endif
