/* scene_read4pl.c -- see scene4pl.h */
#include "contour.h"
#include "rows/pattern_rows.h"
#include "scene4pl.h"

#include "engine/symbol.h"

#include <stdlib.h>

/* One live row of a view. */
typedef struct row {
  const sg_view *view;
  size_t page;
  unsigned at;
} row;

static int32_t
integer(const row *r, unsigned column)
{
  return r->view->column[column].page[r->page].i[r->at];
}

static double
number(const row *r, unsigned column)
{
  return r->view->column[column].page[r->page].f[r->at];
}

/* Where the rows of each relation go. */
typedef struct reading {
  const sg_version *version;
  const sg_poll *poll;
  bool memory;
  sg_dense dense;
  bool *solid;       /* [segments] of kind solid */
  sg_scene_cut *cut; /* [cuts] */
  size_t cuts;
} reading;

typedef void read_row(void *reader, const row *r);

/* False: stopped, or no memory (then *memory is false). */
static bool
each_row(const sg_version *version, sg_relation relation, const sg_poll *poll,
         read_row *read, void *reader, bool *memory)
{
  sg_view view;
  bool stopped = false;

  *memory = sg_version_view(version, relation, &view);
  if (!*memory) {
    return false;
  }
  for (size_t page = 0; page < view.pages && !stopped; page++) {
    for (unsigned i = sg_live_next(view.live[page], 0); i < SG_PAGE_ROWS;
         i = sg_live_next(view.live[page], i + 1)) {
      row r = {&view, page, i};
      read(reader, &r);
    }
    stopped = sg_poll_stop(poll);
  }
  sg_view_clear(&view);
  return !stopped;
}

/* ---------------------------------------------------------------- model */

static bool
read_dense(reading *reader, const sg_chosen *chosen)
{
  static const int32_t none;
  const int32_t *wanted = chosen->n ? chosen->s : &none;
  static const sg_relation relation[4] = {SG_V, SG_E, SG_P, SG_T};
  sg_model_view view[4] = {{.parted = false}};
  bool stopped = false, done = true;

  for (int k = 0; k < 4 && done; k++) {
    done = chosen->all
               ? sg_model_view_make(reader->version, relation[k], &view[k])
               : sg_version_view(reader->version, relation[k], &view[k].whole);
    view[k].shown = chosen->all ? view[k].shown : view[k].whole;
  }
  if (done) {
    const sg_dense_views views = {view[0].shown, view[1].shown, view[2].shown,
                                  view[3].shown};
    done = sg_dense_make(&views, chosen->all ? NULL : wanted, chosen->n,
                         reader->poll, &reader->dense, &stopped);
  }
  reader->memory = done || stopped;
  for (int k = 0; k < 4; k++) {
    sg_model_view_clear(&view[k]);
  }
  return done;
}

static int
compare_ids(const void *a, const void *b)
{
  int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;

  return (x > y) - (x < y);
}

static void
read_segment(void *data, const row *r)
{
  reading *reader = data;
  const sg_dense *d = &reader->dense;
  int32_t s = integer(r, 0);
  const int32_t *at =
      d->segments ? bsearch(&s, d->segment, d->segments, sizeof s, compare_ids)
                  : NULL;

  if (at) {
    reader->solid[at - d->segment] = integer(r, 1) == SG_SYMBOL_SOLID;
  }
}

/* A line is a cut in both its segments, a copy in the second. */
static void
read_cut(void *data, const row *r)
{
  reading *reader = data;
  const sg_dense *d = &reader->dense;
  int32_t s1 = integer(r, 1), s2 = integer(r, 5);
  int32_t a1 = sg_dense_vertex(d, s1, integer(r, 3));
  int32_t b1 = sg_dense_vertex(d, s1, integer(r, 4));
  int32_t a2 = sg_dense_vertex(d, s2, integer(r, 7));
  int32_t b2 = sg_dense_vertex(d, s2, integer(r, 8));

  if (a1 >= 0 && b1 >= 0) {
    reader->cut[reader->cuts++] = (sg_scene_cut){a1, b1, -1, -1};
  }
  if (a2 >= 0 && b2 >= 0) {
    reader->cut[reader->cuts++] = (sg_scene_cut){a2, b2, a1, b1};
  }
}

static bool
read_rows(reading *reader, const sg_chosen *chosen)
{
  const sg_version *version = reader->version;
  size_t lines = sg_version_count(version, SG_LINE);

  if (!read_dense(reader, chosen)) {
    return false;
  }
  reader->solid = calloc(reader->dense.segments + 1, sizeof *reader->solid);
  reader->cut = malloc((2 * lines + 1) * sizeof *reader->cut);
  reader->memory = reader->solid && reader->cut;
  return reader->memory &&
         each_row(version, SG_SEGMENT, reader->poll, read_segment, reader,
                  &reader->memory) &&
         each_row(version, SG_LINE, reader->poll, read_cut, reader,
                  &reader->memory);
}

sg_scene_model *
sg_scene_model_read(const sg_version *version, const sg_chosen *chosen,
                    const sg_known *known, const sg_poll *poll, bool *memory)
{
  reading r = {.version = version, .poll = poll};
  sg_known_surfaces surfaces = {0};
  sg_scene_model *model = NULL;

  if (read_rows(&r, chosen) &&
      sg_known_surfaces_read(known, version, &r.dense, poll, &surfaces,
                             &r.memory)) {
    model = sg_scene_model_open(&r.dense, &surfaces, r.solid, r.cut, r.cuts,
                                poll, &r.memory);
  } else {
    sg_dense_clear(&r.dense);
    sg_known_surfaces_clear(&surfaces);
    free(r.solid);
  }
  free(r.cut);
  *memory = r.memory;
  return model;
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
read_screen(void *data, const row *r)
{
  placing *p = data;
  int32_t at = place_of(p, integer(r, 0), integer(r, 1));

  if (at >= 0) {
    for (unsigned k = 0; k < 3; k++) {
      p->screen->at[at][k] = number(r, k + 2);
    }
    p->screen->shown[at] = true;
    p->next = (size_t)at + 1;
    p->placed++;
  }
}

bool
sg_scene_screen_read(sg_scene_screen *screen, const sg_version *version,
                     const sg_scene_model *model, const sg_poll *poll,
                     bool *memory)
{
  placing p = {.dense = &model->dense, .screen = screen};
  size_t n = model->dense.vertices;
  bool done;

  screen->at = malloc((n + 1) * sizeof *screen->at);
  screen->shown = calloc(n + 1, sizeof *screen->shown);
  *memory = screen->at && screen->shown;
  done = *memory && each_row(version, SG_SCREEN, poll, read_screen, &p, memory);
  if (done && p.placed == n) {
    free(screen->shown);
    screen->shown = NULL;
  }
  return done;
}

void
sg_scene_screen_clear(sg_scene_screen *screen)
{
  free(screen->at);
  free(screen->shown);
  *screen = (sg_scene_screen){0};
}

/* --------------------------------------------------------------- pieces */

typedef struct piecing {
  const sg_scene_model *model;
  const sg_scene_screen *screen;
  sg_scene_pieces *out;
} piecing;

static void
count_piece(void *data, const row *r)
{
  piecing *p = data;

  p->out->n++;
  p->out->lies += (size_t)r->view->column[8].page[r->page].list[r->at][0];
}

static void
count_turn(void *data, const row *r)
{
  piecing *p = data;

  p->out->turns++;
  p->out->lies += (size_t)r->view->column[5].page[r->page].list[r->at][0];
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
read_lies(piecing *p, const row *r, unsigned column, int32_t s,
          const int32_t **lies_on)
{
  const int32_t *list = r->view->column[column].page[r->page].list[r->at];
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
read_turn(void *data, const row *r)
{
  piecing *p = data;
  sg_scene_turn *turn = &p->out->turn[p->out->turns];
  int32_t s = integer(r, 0), i = integer(r, 2);
  int32_t t = sg_dense_triangle(&p->model->dense, s, integer(r, 1));

  if (t >= 0) {
    const int32_t *v = p->model->dense.corner[t];
    uint32_t a = (uint32_t)v[i - 1], b = (uint32_t)v[i % 3];
    *turn = (sg_scene_turn){.s = s,
                            .triangle = t,
                            .v = {a < b ? a : b, a < b ? b : a},
                            .from = number(r, 3),
                            .to = number(r, 4)};
    turn->triangles = read_lies(p, r, 5, s, &turn->lies_on);
    p->out->turns++;
  }
}

/* From the sides of its triangle to the surface; if that is another place, the
 * triangle hides as its parts do. */
static void
rise(sg_scene_added *added, const row *r, int32_t triangle)
{
  bool rises = false;

  for (unsigned k = 0; k < 4; k++) {
    added->screen[k / 2][k % 2] += number(r, 9 + k);
    rises |= number(r, 9 + k) != 0.0;
  }
  if (rises) {
    added->divides = triangle;
    added->side[0] = (uint8_t)(integer(r, 3) - 1);
    added->side[1] = (uint8_t)(integer(r, 5) - 1);
  }
}

/* Seen from the eye it has a face on one side only: an outline. */
static void
read_piece(void *data, const row *r)
{
  piecing *p = data;
  sg_scene_added *added = &p->out->added[p->out->n];
  int32_t t = sg_dense_triangle(&p->model->dense, integer(r, 0), integer(r, 2));

  *added = (sg_scene_added){
      .s = integer(r, 0),
      .e = -integer(r, 1),
      .look = {.faces = 2, .towards = 1, .away = 1, .left = 2}};
  added->look.stands_in = number(r, 7) == SG_STANDS_IN;
  added->folded = added->look.stands_in ? 0.0 : 1.0 - number(r, 7);
  if (t >= 0 &&
      side_point(p, t, integer(r, 3), number(r, 4), added->screen[0]) &&
      side_point(p, t, integer(r, 5), number(r, 6), added->screen[1])) {
    rise(added, r, t);
    added->triangles = read_lies(p, r, 8, added->s, &added->lies_on);
    p->out->n++;
  }
}

bool
sg_scene_pieces_read(sg_scene_pieces *pieces, const sg_version *version,
                     const sg_scene_model *model, const sg_scene_screen *screen,
                     const sg_poll *poll, bool *memory)
{
  piecing p = {.model = model, .screen = screen, .out = pieces};

  *pieces = (sg_scene_pieces){0};
  if (!each_row(version, SG_CONTOUR, poll, count_piece, &p, memory) ||
      !each_row(version, SG_SURFACE_TURN, poll, count_turn, &p, memory)) {
    return false;
  }
  pieces->added = malloc((pieces->n + 1) * sizeof *pieces->added);
  pieces->turn = malloc((pieces->turns + 1) * sizeof *pieces->turn);
  pieces->lies_on = malloc((pieces->lies + 1) * sizeof *pieces->lies_on);
  pieces->n = pieces->turns = pieces->lies = 0;
  *memory = pieces->added && pieces->turn && pieces->lies_on;
  return *memory &&
         each_row(version, SG_CONTOUR, poll, read_piece, &p, memory) &&
         each_row(version, SG_SURFACE_TURN, poll, read_turn, &p, memory);
}

void
sg_scene_pieces_clear(sg_scene_pieces *pieces)
{
  free(pieces->added);
  free(pieces->turn);
  free(pieces->lies_on);
  *pieces = (sg_scene_pieces){0};
}
