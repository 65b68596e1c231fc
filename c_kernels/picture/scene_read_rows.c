/* scene_read_rows.c -- what scenes are made from, read from the relations: see
 * scene_rows.h.
 */
#include "contour.h"
#include "engine/search.h"
#include "known_surface_rows.h"
#include "rows/dense_rows.h"
#include "rows/live_rows.h"
#include "scene_rows.h"

#include "engine/symbol.h"

#include <stdlib.h>
#include <string.h>

/* ---------------------------------------------------------------- model */

/* Where the rows of each relation go. */
typedef struct reading {
  sg_dense dense;
  bool *solid;       /* [segments] of kind solid */
  sg_scene_cut *cut; /* [cuts] */
  size_t cuts;
} reading;

static void
read_segment(void *data, const sg_live_row *r)
{
  reading *reader = data;
  const sg_dense *d = &reader->dense;
  int32_t s = sg_row_int(r, 0);
  size_t at = sg_find_id(d->segment, d->segments, s);

  if (at != SIZE_MAX) {
    reader->solid[at] = sg_row_int(r, 1) == SG_SYMBOL_SOLID;
  }
}

/* A line is a cut in both its segments, a copy in the second. */
static void
read_cut(void *data, const sg_live_row *r)
{
  reading *reader = data;
  const sg_dense *d = &reader->dense;
  int32_t s1 = sg_row_int(r, 1), s2 = sg_row_int(r, 5);
  int32_t a1 = sg_dense_vertex(d, s1, sg_row_int(r, 3));
  int32_t b1 = sg_dense_vertex(d, s1, sg_row_int(r, 4));
  int32_t a2 = sg_dense_vertex(d, s2, sg_row_int(r, 7));
  int32_t b2 = sg_dense_vertex(d, s2, sg_row_int(r, 8));

  if (a1 >= 0 && b1 >= 0) {
    reader->cut[reader->cuts++] = (sg_scene_cut){a1, b1, -1, -1};
  }
  if (a2 >= 0 && b2 >= 0) {
    reader->cut[reader->cuts++] = (sg_scene_cut){a2, b2, a1, b1};
  }
}

static bool
read_model(sg_call *call, const sg_chosen_segments *chosen, reading *r)
{
  if (chosen->is == SG_CHOSEN_SEGMENTS_ALL
          ? !sg_dense_read(call, NULL, 0, &r->dense)
          : !sg_dense_read_these(call, &chosen->these, &r->dense)) {
    return false;
  }
  size_t lines = sg_version_count(sg_call_version(call), SG_LINE);

  r->solid = calloc(r->dense.segments + 1, sizeof *r->solid);
  r->cut = sg_call_alloc(call, 2 * lines * sizeof *r->cut);
  return (r->solid || sg_call_no_memory(call)) && r->cut &&
         sg_each_row(call, SG_SEGMENT, read_segment, r) &&
         sg_each_row(call, SG_LINE, read_cut, r);
}

sg_scene_model *
sg_scene_model_read(sg_call *call, const sg_chosen_segments *chosen,
                    const sg_known_segment_list *known)
{
  reading r = {.cuts = 0};
  sg_known_surfaces surfaces = {0};
  sg_scene_model *model = NULL;
  bool memory;

  if (read_model(call, chosen, &r) &&
      sg_known_surfaces_read(call, known, &r.dense, &surfaces)) {
    model = sg_scene_model_open(&r.dense, &surfaces, r.solid, r.cut, r.cuts,
                                &call->cancel, &memory);
    if (!model) {
      sg_call_ended(call);
    }
    return model;
  }
  sg_dense_clear(&r.dense);
  sg_known_surfaces_clear(&surfaces);
  free(r.solid);
  return NULL;
}

/* --------------------------------------------------------------- screen */

typedef struct placing {
  const sg_dense *dense;
  sg_scene_screen *screen;
  size_t next;   /* where the next row belongs, as a rule */
  size_t placed; /* how many vertices have a place */
} placing;

/* The place of vertex v of segment s; rows mostly come in the order of the
 * model's vertices. */
static int32_t
place_of(placing *p, int32_t s, int32_t v)
{
  const sg_dense *d = p->dense;
  size_t next = p->next;

  if (next < d->vertices && d->vertex_id[next] == v &&
      d->segment[sg_dense_segment_of(d, d->vertex_begin, (uint32_t)next)] ==
          s) {
    return (int32_t)next;
  }
  return sg_dense_vertex(d, s, v);
}

static void
read_screen(void *data, const sg_live_row *r)
{
  placing *p = data;
  int32_t at = place_of(p, sg_row_int(r, 0), sg_row_int(r, 1));

  if (at >= 0) {
    for (unsigned k = 0; k < 3; k++) {
      p->screen->at[at][k] = sg_row_number(r, k + 2);
    }
    p->screen->shown[at] = true;
    p->next = (size_t)at + 1;
    p->placed++;
  }
}

bool
sg_scene_screen_read(sg_call *call, const sg_scene_model *model,
                     sg_scene_screen *out)
{
  placing p = {.dense = &model->dense, .screen = out};
  size_t n = model->dense.vertices;

  out->at = sg_call_alloc(call, n * sizeof *out->at);
  out->shown = sg_call_alloc(call, n * sizeof *out->shown);
  if (!out->at || !out->shown) {
    return false;
  }
  memset(out->shown, 0, n * sizeof *out->shown);
  if (!sg_each_row(call, SG_SCREEN, read_screen, &p)) {
    return false;
  }
  if (p.placed == n) {
    out->shown = NULL;
  }
  return true;
}

/* --------------------------------------------------------------- pieces */

typedef struct piecing {
  const sg_scene_model *model;
  const sg_scene_screen *screen;
  sg_scene_pieces *out;
} piecing;

static void
count_piece(void *data, const sg_live_row *r)
{
  piecing *p = data;

  p->out->n++;
  p->out->lies += (size_t)sg_row_list(r, 8)[0];
}

static void
count_facing(void *data, const sg_live_row *r)
{
  piecing *p = data;

  p->out->facings++;
  p->out->lies += (size_t)sg_row_list(r, 5)[0];
}

/* The point at f of side i (from 1) of a triangle. False: it has no place. */
static bool
side_point(const piecing *p, int32_t triangle, int32_t i, double f,
           double out[3])
{
  const int32_t *v = p->model->dense.corner[triangle];
  int32_t a = v[i - 1], b = v[i % 3];
  int32_t low = a < b ? a : b, high = a < b ? b : a;

  if (p->screen->shown && !(p->screen->shown[a] && p->screen->shown[b])) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    double x = p->screen->at[low][k], y = p->screen->at[high][k];
    out[k] = f == 1.0 ? y : x + f * (y - x);
  }
  return true;
}

/* The triangles of a row's list, of segment s. Gives how many. */
static size_t
read_lies(piecing *p, const sg_live_row *r, unsigned column, int32_t s,
          const int32_t **lies_on)
{
  const int32_t *list = sg_row_list(r, column);
  int32_t *on = p->out->lies_on + p->out->lies;
  size_t n = 0;

  for (int32_t i = 1; i <= list[0]; i++) {
    int32_t at = sg_dense_triangle(&p->model->dense, s, list[i]);
    if (at >= 0) {
      on[n++] = at;
    }
  }
  *lies_on = on;
  p->out->lies += n;
  return n;
}

static void
read_facing(void *data, const sg_live_row *r)
{
  piecing *p = data;
  sg_scene_facing *facing = &p->out->facing[p->out->facings];
  int32_t s = sg_row_int(r, 0), i = sg_row_int(r, 2);
  int32_t t = sg_dense_triangle(&p->model->dense, s, sg_row_int(r, 1));

  if (t >= 0) {
    const int32_t *v = p->model->dense.corner[t];
    uint32_t a = (uint32_t)v[i - 1], b = (uint32_t)v[i % 3];
    *facing = (sg_scene_facing){.s = s,
                                .triangle = t,
                                .v = {a < b ? a : b, a < b ? b : a},
                                .from = sg_row_number(r, 3),
                                .to = sg_row_number(r, 4)};
    facing->triangles = read_lies(p, r, 5, s, &facing->lies_on);
    p->out->facings++;
  }
}

/* From the sides of its triangle to the surface; if that is another place, the
 * triangle hides as its parts do. */
static void
rise(sg_scene_added *added, const sg_live_row *r, int32_t triangle)
{
  bool rises = false;

  for (unsigned k = 0; k < 4; k++) {
    added->screen[k / 2][k % 2] += sg_row_number(r, 9 + k);
    rises |= sg_row_number(r, 9 + k) != 0.0;
  }
  if (rises) {
    added->divides = triangle;
    added->side[0] = (uint8_t)(sg_row_int(r, 3) - 1);
    added->side[1] = (uint8_t)(sg_row_int(r, 5) - 1);
  }
}

/* Seen from the eye it has a face on one side only: an outline. */
static void
read_piece(void *data, const sg_live_row *r)
{
  piecing *p = data;
  sg_scene_added *added = &p->out->added[p->out->n];
  int32_t t =
      sg_dense_triangle(&p->model->dense, sg_row_int(r, 0), sg_row_int(r, 2));

  *added = (sg_scene_added){
      .s = sg_row_int(r, 0),
      .e = -sg_row_int(r, 1),
      .look = {.faces = 2, .towards = 1, .away = 1, .left = 2}};
  added->look.substitute_outline = sg_row_int(r, 7) == SG_SYMBOL_SUBSTITUTE;
  added->folded = sg_row_int(r, 7) == SG_SYMBOL_HIDDEN ? 1.0 : 0.0;
  if (t >= 0 &&
      side_point(p, t, sg_row_int(r, 3), sg_row_number(r, 4),
                 added->screen[0]) &&
      side_point(p, t, sg_row_int(r, 5), sg_row_number(r, 6),
                 added->screen[1])) {
    rise(added, r, t);
    added->triangles = read_lies(p, r, 8, added->s, &added->lies_on);
    p->out->n++;
  }
}

bool
sg_scene_pieces_read(sg_call *call, const sg_scene_model *model,
                     const sg_scene_screen *screen, sg_scene_pieces *out)
{
  piecing p = {.model = model, .screen = screen, .out = out};

  *out = (sg_scene_pieces){0};
  if (!sg_each_row(call, SG_CONTOUR, count_piece, &p) ||
      !sg_each_row(call, SG_SURFACE_FACING, count_facing, &p)) {
    return false;
  }
  out->added = sg_call_alloc(call, out->n * sizeof *out->added);
  out->facing = sg_call_alloc(call, out->facings * sizeof *out->facing);
  out->lies_on = sg_call_alloc(call, out->lies * sizeof *out->lies_on);
  out->n = out->facings = out->lies = 0;
  return out->added && out->facing && out->lies_on &&
         sg_each_row(call, SG_CONTOUR, read_piece, &p) &&
         sg_each_row(call, SG_SURFACE_FACING, read_facing, &p);
}
