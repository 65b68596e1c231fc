/* scene4pl.h -- what a scene is made from, read from one version of a world.
 *
 * Layer: glue. Include it before SWI-Prolog.h. The model of a world (what no
 * eye changes) is kept with it under the stamps of the rows it was made from,
 * as trees are (tree4pl.h): a picture from another eye reads screen/5 only.
 */
#ifndef SG_SCENE4PL_H
#define SG_SCENE4PL_H

#include "engine/world4pl.h"

#include "hide_search.h"
#include "known_surface4pl.h"
#include "smooth.h"

#include <SWI-Prolog.h>

#include <stdatomic.h>

/* Which segments take part: all when `all`, else the ids, ascending. */
typedef struct sg_chosen {
  bool all;
  int32_t *s;
  size_t n;
} sg_chosen;

/* The model of the chosen segments, whose polygons stand for known surfaces.
 * Null: stopped by the poll, or no memory (then *memory is false). */
sg_scene_model *sg_scene_model_read(const sg_version *version,
                                    const sg_chosen *chosen,
                                    const sg_known *known, const sg_poll *poll,
                                    bool *memory);

/* Where screen/5 says that the vertices of a model are. */
typedef struct sg_scene_screen {
  double (*at)[3]; /* [vertices] */
  bool *shown;     /* [vertices], or null: all are */
} sg_scene_screen;

/* False: stopped by the poll, or no memory (then *memory is false). The caller
 * calls sg_scene_screen_clear() in any case. */
bool sg_scene_screen_read(sg_scene_screen *screen, const sg_version *version,
                          const sg_scene_model *model, const sg_poll *poll,
                          bool *memory);
void sg_scene_screen_clear(sg_scene_screen *screen);

/* A model that is kept, or was: it lasts while somebody holds it. */
enum { SG_SCENE_STAMPS = 8 };

struct sg_kept_smooth;

typedef struct sg_kept_model {
  atomic_size_t holders;
  sg_chosen chosen; /* its ids are its own */
  uint64_t stamp[SG_SCENE_STAMPS];
  sg_scene_model *model;
  struct sg_kept_smooth *smooth; /* null: not asked for (smooth_kept4pl.c) */
} sg_kept_model;

/* The model of the chosen segments as `version` of `world` shows them, held
 * and to be dropped. Null: an exception is pending; or none is kept, and
 * `known` says nothing. */
sg_kept_model *sg_kept_model_hold_ex(sg_world *world, const sg_version *version,
                                     const sg_chosen *chosen,
                                     const sg_known *known);
void sg_kept_model_drop(sg_kept_model *kept);

/* A list of S-S2, S2 lets the lines of S be seen, sorted; free(*out). */
int sg_get_through_ex(term_t list, sg_hide_through **out, size_t *n);

/* Which surfaces are smooth. */
typedef struct sg_smoothness {
  double crease;     /* degrees */
  sg_chosen faceted; /* segments that are what their facets are */
} sg_smoothness;

/* Which segments of a model are faceted, to be freed; null: no memory. */
bool *sg_smoothness_faceted(const sg_smoothness *smoothness,
                            const sg_dense *dense);

/* smooth(Crease, Faceted); sg_smoothness_clear() in any case. */
int sg_get_smoothness_ex(term_t t, sg_smoothness *out);
void sg_smoothness_clear(sg_smoothness *smoothness);

/* The smooth sheets of a model, kept with it. */
typedef struct sg_kept_smooth {
  atomic_size_t holders;
  sg_smoothness as;
  sg_smooth smooth; /* without curved triangles in segments that are faceted */
  bool *curved;     /* [polygons] that lie in curved sheets */
} sg_kept_smooth;

/* Held, and to be dropped. Null: an exception is pending. */
sg_kept_smooth *sg_kept_smooth_hold_ex(sg_kept_model *model,
                                       const sg_smoothness *as);
void sg_kept_smooth_drop(sg_kept_smooth *kept);

/* The pieces of contour/13 as lines of a scene, and the rows of surface_turn/6.
 */
typedef struct sg_scene_pieces {
  sg_scene_added *added; /* [n] */
  sg_scene_turn *turn;   /* [turns] */
  int32_t *lies_on;      /* what they lie on, one after another */
  size_t n, turns, lies;
} sg_scene_pieces;

/* Those of the model's segments whose triangles are there. False: stopped by
 * the poll, or no memory (then *memory is false). The caller calls
 * sg_scene_pieces_clear() in any case. */
bool sg_scene_pieces_read(sg_scene_pieces *pieces, const sg_version *version,
                          const sg_scene_model *model,
                          const sg_scene_screen *screen, const sg_poll *poll,
                          bool *memory);
void sg_scene_pieces_clear(sg_scene_pieces *pieces);

/* The masks of a scene handle, and with them the scene; they last as long as
 * the term. False: an exception is pending. */
int sg_get_mask_grid_ex(term_t t, const sg_mask_grid **out);

/* The place of the line of edge (s, e), which must be one that the scene draws.
 * False: an exception is pending. */
int sg_get_scene_line_ex(const sg_scene *scene, term_t s, term_t e,
                         size_t *out);

#endif
