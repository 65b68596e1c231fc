/* scene_rows.c -- a scene, and its lines. */
#include "scene_rows.h"

#include <stdlib.h>

void
sg_scene_index_close(sg_scene_index *index)
{
  if (index) {
    sg_mask_grid_clear(&index->masks);
    sg_line_grid_clear(&index->lines);
    sg_seen_clear(&index->mask_seen);
    sg_seen_clear(&index->line_seen);
    free(index->every);
    sg_scene_close(index->scene);
    sg_kept_model_drop(index->model);
    free(index);
  }
}

/* ---- opening ---- */

/* What scene_open/6 was asked for. */
typedef struct request {
  double depth, tolerance;
  bool smooth; /* curved sheets have no outlines along their edges */
  sg_smoothness as;
  const sg_lines_drawn *only; /* null: all lines */
} request;

/* The scene and its search structures. */
static bool
fill_index(sg_call *call, sg_scene_index *index, const sg_scene_input *in)
{
  bool memory;

  index->scene = sg_scene_open(in, &call->cancel, &memory);
  return (index->scene && sg_mask_grid_init(&index->masks, index->scene,
                                            &call->cancel, &memory)) ||
         sg_call_ended(call);
}

/* What the call's version shows of a model; smooth: its sheets, or null. */
static bool
view_model(sg_call *call, sg_scene_index *index, const sg_kept_smooth *smooth,
           const request *q)
{
  const sg_scene_model *model = index->model->model;
  bool *faceted = sg_segments_faceted(call, &q->as.faceted, &model->dense);
  sg_scene_screen screen = {0};
  sg_scene_pieces pieces = {0};

  if (!faceted || !sg_scene_screen_read(call, model, &screen) ||
      !sg_scene_pieces_read(call, model, &screen, &pieces)) {
    return false;
  }
  return fill_index(
      call, index,
      &(sg_scene_input){.model = model,
                        .screen = (const double(*)[3])screen.at,
                        .shown = screen.shown,
                        .added = pieces.added,
                        .addeds = pieces.n,
                        .facing = pieces.facing,
                        .facings = pieces.facings,
                        .curved = smooth ? smooth->curved : NULL,
                        .faceted = faceted,
                        .creases = smooth ? smooth->creases : NULL,
                        .crease = q->as.crease,
                        .only = q->only,
                        .depth = q->depth,
                        .tolerance = q->tolerance});
}

static bool
view_kept(sg_call *call, sg_scene_index *index, const request *q)
{
  sg_kept_smooth *smooth =
      q->smooth ? sg_kept_smooth_hold(call, index->model, &q->as) : NULL;
  bool good = (smooth || !q->smooth) && view_model(call, index, smooth, q);

  sg_kept_smooth_drop(smooth);
  return good;
}

bool
sg_door_scene_open(sg_call *call, const sg_chosen_segments *segments,
                   double depth, double tolerance,
                   const sg_drawn_outlines *smooth, const sg_scene_lines *lines,
                   const sg_known_model *known, sg_scene_index **scene)
{
  sg_lines_drawn only = {lines->drawn.which, lines->drawn.crease};
  request q = {.depth = depth,
               .tolerance = tolerance,
               .smooth = smooth->is == SG_DRAWN_OUTLINES_SMOOTH,
               .only = lines->is == SG_SCENE_LINES_DRAWN ? &only : NULL};
  sg_scene_index *index = calloc(1, sizeof *index);

  if (q.smooth) {
    q.as = smooth->smooth;
  } else {
    q.as.faceted = smooth->edges.faceted;
  }
  if (!index) {
    return sg_call_no_memory(call);
  }
  index->model = sg_kept_model_hold(call, segments, known);
  if (!index->model || !view_kept(call, index, &q)) {
    sg_scene_index_close(index);
    return false;
  }
  *scene = index;
  return true;
}

/* ---- lines ---- */

static bool
add_edge(sg_call *call, const sg_scene *scene, size_t at,
         sg_scene_edge_rows *rows)
{
  const sg_scene_line *line = &scene->line[at];

  return sg_scene_edge_rows_add(call, rows,
                                (sg_scene_edge_row){line->s, line->e,
                                                    sg_line_length(scene, line),
                                                    line->look});
}

bool
sg_door_scene_edge(sg_call *call, sg_scene_index *index, const int32_t *s,
                   const int32_t *e, sg_scene_edge_rows *rows)
{
  const sg_scene *scene = index->scene;
  bool good = true;

  if (s && e) {
    size_t at = sg_scene_find(scene, *s, *e);
    return at != SIZE_MAX && add_edge(call, scene, at, rows);
  }
  for (size_t at = 0; good && at < scene->lines; at++) {
    const sg_scene_line *line = &scene->line[at];
    good = (s && *s != line->s) || (e && *e != line->e) ||
           add_edge(call, scene, at, rows);
  }
  return good;
}

bool
sg_door_scene_near(sg_call *call, sg_scene_index *index, double *near)
{
  (void)call;
  *near = index->scene->near;
  return true;
}
