/* scene_rows.h -- what a scene is made from, read from the current world, and
 * the scene with what answers questions of it.
 *
 * Layer: rows. The model of a world (what no eye changes) is kept with it under
 * the stamps of the rows it was made from, as trees are (join/tree_rows.h): a
 * picture from another eye reads screen/5 only. False or null: see call.h.
 */
#ifndef SG_SCENE_ROWS_H
#define SG_SCENE_ROWS_H

#include "call.h"
#include "crease.h"
#include "doors/drawing.h"
#include "hide_search.h"
#include "smooth.h"

#include <stdatomic.h>

/* ---- the model ---- */

/* The model of the chosen segments, whose polygons stand for known surfaces. */
sg_scene_model *sg_scene_model_read(sg_call *call,
                                    const sg_chosen_segments *chosen,
                                    const sg_known_segment_list *known);

enum { SG_SCENE_STAMPS = 8 };

struct sg_kept_smooth;

/* A model that is kept, or was: it lasts while somebody holds it. */
typedef struct sg_kept_model {
  atomic_size_t holders;
  sg_chosen_segments chosen; /* its ids are its own */
  uint64_t stamp[SG_SCENE_STAMPS];
  sg_scene_model *model;
  struct sg_kept_smooth *smooth; /* null: not asked for (smooth_kept_rows.c) */
} sg_kept_model;

/* The model of the chosen segments as the call's version shows them, held and
 * to be dropped. Null also: none is kept, and `known` is `kept`. */
sg_kept_model *sg_kept_model_hold(sg_call *call,
                                  const sg_chosen_segments *chosen,
                                  const sg_known_model *known);
void sg_kept_model_drop(sg_kept_model *kept);

/* The smooth sheets of a model, kept with it. */
typedef struct sg_kept_smooth {
  atomic_size_t holders;
  sg_smoothness as; /* its ids are its own */
  sg_smooth smooth; /* without curved triangles in segments that are faceted */
  bool *curved;     /* [polygons] that lie in curved sheets */
  uint8_t *creases; /* [lines] crease.h; null: as they are bent */
} sg_kept_smooth;

/* Held, and to be dropped. */
sg_kept_smooth *sg_kept_smooth_hold(sg_call *call, sg_kept_model *model,
                                    const sg_smoothness *as);
void sg_kept_smooth_drop(sg_kept_smooth *kept);

/* Which segments of a model are faceted. */
bool *sg_segments_faceted(sg_call *call, const sg_int_list *faceted,
                          const sg_dense *dense);

/* ---- what an eye sees: memory of the call ---- */

/* Where screen/5 says that the vertices of a model are. */
typedef struct sg_scene_screen {
  double (*at)[3]; /* [vertices] */
  bool *shown;     /* [vertices], or null: all are */
} sg_scene_screen;

bool sg_scene_screen_read(sg_call *call, const sg_scene_model *model,
                          sg_scene_screen *out);

/* The pieces of contour/13 as lines of a scene, and the rows of
 * surface_facing/6: those of the model's segments whose triangles are there. */
typedef struct sg_scene_pieces {
  sg_scene_added *added;   /* [n] */
  sg_scene_facing *facing; /* [facings] */
  int32_t *lies_on;        /* what they lie on, one after another */
  size_t n, facings, lies;
} sg_scene_pieces;

bool sg_scene_pieces_read(sg_call *call, const sg_scene_model *model,
                          const sg_scene_screen *screen, sg_scene_pieces *out);

/* ---- the handle `scene` ---- */

/* A scene, and what its lines are searched with. */
typedef struct sg_scene_index {
  sg_kept_model *model; /* held */
  sg_scene *scene;
  sg_mask_grid masks;
  sg_line_grid lines; /* of all lines, when one is asked for its overlaps */
  uint32_t *every;    /* [scene->lines] their places */
  sg_seen mask_seen, line_seen;
} sg_scene_index;

#endif
