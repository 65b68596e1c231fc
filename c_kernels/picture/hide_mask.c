/* hide_mask.c -- triangles that hide a part of a line: see hide_search.h. */
#include "hide_search_private.h"

#include "engine/list.h"
#include "engine/search.h"
#include "number/bounds.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* Up to so many are sorted by insertion. The masks of a cell with more than
 * MANY are sorted. */
enum { FEW = 16, MANY = 64, ASKED = 4096 };

/* ---- the grid ---- */

static void
shape_of_mask(const void *data, size_t i, sg_grid_shape *out)
{
  const sg_mask_grid *masks = data;
  const sg_scene *scene = masks->scene;

  out->corners = 3;
  for (int k = 0; k < 3; k++) {
    const double *at = scene->at[scene->mask[i].v[k]];
    out->at[k][0] = at[0];
    out->at[k][1] = at[1];
  }
  sg_turn_shape(masks->way, out);
}

/* Where x of the grid is that of the picture. */
static void
box_of_mask(const void *data, size_t i, sg_grid_box *out)
{
  const sg_mask_grid *masks = data;
  const sg_scene_mask *mask = &masks->scene->mask[i];

  memcpy(out->low, mask->low, sizeof out->low);
  memcpy(out->high, mask->high, sizeof out->high);
}

/* Whether sides of masks mostly run one way: by the sum of their doubled
 * angles, the longer the more. Of many masks so many are asked. */
static bool
find_mask_way(sg_mask_grid *masks)
{
  const sg_scene *scene = masks->scene;
  double sum[2] = {0, 0}, all = 0;
  size_t step = 3 * (scene->masks / ASKED) + 1; /* all three sides, by turns */

  for (size_t i = 0; i < 3 * scene->masks; i += step) {
    const double *p = scene->at[scene->mask[i / 3].v[i % 3]];
    const double *q = scene->at[scene->mask[i / 3].v[(i + 1) % 3]];
    double x = q[0] - p[0], y = q[1] - p[1], size = sqrt(x * x + y * y);

    if (size > 0) {
      sum[0] += (x * x - y * y) / size;
      sum[1] += 2 * x * y / size;
      all += size;
    }
  }
  double size = sqrt(sum[0] * sum[0] + sum[1] * sum[1]);
  bool one = isfinite(all) && size > 0.5 * all;
  double half = one ? atan2(sum[1], sum[0]) / 2 : 0;

  masks->way[0] = one ? cos(half) : 1;
  masks->way[1] = one ? sin(half) : 0;
  return one;
}

static void
make_boxes(sg_mask_grid *masks)
{
  const sg_scene *scene = masks->scene;
  double e = 2 * scene->close;

  for (size_t i = 0; i < scene->masks; i++) {
    const sg_scene_mask *mask = &scene->mask[i];
    sg_mask_box *box = &masks->box[i];
    for (int k = 0; k < 2; k++) {
      box->low[k] = sg_float_below(mask->low[k] - e);
      box->high[k] = -sg_float_below(-mask->high[k] - e);
    }
    box->low[2] = sg_float_below(mask->low[2]); /* what masks are sorted by */
  }
}

bool
sg_mask_grid_init(sg_mask_grid *masks, const sg_scene *scene,
                  const sg_cancel *cancel, bool *memory)
{
  *masks = (sg_mask_grid){
      .scene = scene, .box = sg_list_room(scene->masks, sizeof *masks->box)};
  *memory = masks->box != NULL;
  if (!*memory) {
    return false;
  }
  make_boxes(masks);
  bool along = find_mask_way(masks);

  if (!sg_grid_init(&masks->grid, scene->masks, shape_of_mask,
                    along ? NULL : box_of_mask, masks, scene->close, along,
                    cancel, memory)) {
    return false;
  }
  masks->near =
      calloc((size_t)masks->grid.nx * masks->grid.ny, sizeof *masks->near);
  *memory = masks->near != NULL;
  return *memory;
}

void
sg_mask_grid_clear(sg_mask_grid *masks)
{
  size_t cells = (size_t)masks->grid.nx * masks->grid.ny;

  for (size_t i = 0; masks->near && i < cells; i++) {
    free(atomic_load(&masks->near[i]));
  }
  free(masks->near);
  sg_grid_clear(&masks->grid);
  free(masks->box);
  *masks = (sg_mask_grid){0};
}

/* ---- what was found ---- */

/* Room for one more in a growing array; false: no memory. */
static bool
add_hidden(sg_hiddens *out, const sg_hidden *part)
{
  bool ok = sg_list_grow(&out->part, out->n, &out->room, sizeof *part);

  if (ok) {
    out->part[out->n++] = *part;
  }
  return ok;
}

SG_ORDER(hidden_compare, sg_hidden, SG_BY(from) SG_BY(to) SG_BY(mask));

static void
sort_hidden(sg_hidden *part, size_t n)
{
  if (n > FEW) {
    qsort(part, n, sizeof *part, hidden_compare);
    return;
  }
  for (size_t i = 1; i < n; i++) {
    sg_hidden x = part[i];
    size_t k = i;
    for (; k > 0 && hidden_compare(&part[k - 1], &x) > 0; k--) {
      part[k] = part[k - 1];
    }
    part[k] = x;
  }
}

/* True if one side of the mask certainly keeps nothing of the line, as
 * sg_mask_hides() would find with a root and two divisions: one end is outside
 * of it, and the other is not inside. */
static bool
is_beside(const sg_scene *scene, const sg_scene_mask *mask, const double a[3],
          const double b[3])
{
  double e = scene->close;

  for (int k = 0; k < 3; k++) {
    const double *p = scene->at[mask->v[k]];
    const double *q = scene->at[mask->v[(k + 1) % 3]];
    double x = q[0] - p[0], y = q[1] - p[1];
    double at_a = x * (a[1] - p[1]) - y * (a[0] - p[0]);
    double at_b = x * (b[1] - p[1]) - y * (b[0] - p[0]);
    double outside = -SG_SLACK * e * (fabs(x) + fabs(y));
    double inside = e / SG_SLACK * sg_larger(fabs(x), fabs(y));
    if (sg_smaller(at_a, at_b) < outside && sg_larger(at_a, at_b) < inside) {
      return true;
    }
  }
  return false;
}

bool
sg_hide_sees_through(const sg_hide_throughs *through, int32_t s, int32_t s2)
{
  const sg_hide_through *pair = through ? through->pair : NULL;
  size_t n = through ? through->n : 0, at;

  SG_SEARCH(at, 0, n, pair[at].s < s || (pair[at].s == s && pair[at].s2 < s2));
  return at < n && pair[at].s == s && pair[at].s2 == s2;
}

/* A question: a line, its box, and what was found. */
typedef struct asking {
  const sg_mask_grid *masks;
  const sg_scene_line *line;
  const double *a, *b;
  double low[2], high[2], far;
  const sg_hide_throughs *through;
  sg_seen *seen;
  sg_hiddens *out;
  bool enough;
  double in[2]; /* where the line is in the cell at hand */
  size_t known; /* so many were found when it was last looked whether they hide
                   all of the line there, */
  bool done;    /* which they do */
} asking;

/* Whether what was found hides all of the line that is in the cell. */
static bool
cell_is_hidden(const asking *q)
{
  const sg_hidden *span = q->out->span;
  size_t i;

  SG_SEARCH(i, 0, q->out->spans, span[i].to < q->in[0]);
  return i < q->out->spans && q->in[0] <= q->in[1] &&
         span[i].from <= q->in[0] && span[i].to >= q->in[1];
}

/* Whether all of the line is known to be hidden, and that is enough. */
static bool
is_hidden(const asking *q)
{
  const sg_hiddens *out = q->out;

  return out->spans == 1 && out->span[0].from == 0.0 && out->span[0].to == 1.0;
}

void
sg_hiddens_clear(sg_hiddens *hiddens)
{
  free(hiddens->part);
  free(hiddens->span);
  *hiddens = (sg_hiddens){0};
}

/* Adds a part to the spans. False: no memory. */
static bool
add_span(sg_hiddens *out, sg_hidden part)
{
  size_t i, k, n = out->spans;

  if (!sg_list_grow(&out->span, n, &out->span_room, sizeof *out->span)) {
    return false;
  }
  SG_SEARCH(i, 0, n, out->span[i].to < part.from);
  for (k = i; k < n && out->span[k].from <= part.to; k++) {
    part.from = sg_smaller(part.from, out->span[k].from);
    part.to = sg_larger(part.to, out->span[k].to);
  }
  memmove(&out->span[i + 1], &out->span[k], (n - k) * sizeof *out->span);
  out->span[i] = part;
  out->spans = n + 1 - (k - i);
  return true;
}

static bool
try_mask(asking *q, uint32_t m)
{
  const sg_scene *scene = q->masks->scene;
  const sg_scene_mask *mask = &scene->mask[m];
  sg_hidden part = {.mask = m};

  if (!sg_is_new(q->seen, m) || is_beside(scene, mask, q->a, q->b) ||
      !sg_mask_hides(scene, mask, q->line, &part) ||
      sg_hide_sees_through(q->through, q->line->s, mask->s)) {
    return true;
  }
  return add_hidden(q->out, &part) && (!q->enough || add_span(q->out, part));
}

/* Where in 0 to 1 the line is in a cell and what counts as that; all of it at
 * the border of the grid, which has all that is beyond. */
static void
find_in(asking *q, const sg_grid_shape *shape, unsigned x, unsigned y)
{
  const sg_grid *grid = &q->masks->grid;
  const unsigned cell[2] = {x, y}, cells[2] = {grid->nx, grid->ny};

  q->in[0] = 0.0;
  q->in[1] = 1.0;
  for (int k = 0; k < 2; k++) {
    double low = grid->low[k] + cell[k] * grid->wide[k] - grid->margin;
    double high = low + grid->wide[k] + 2 * grid->margin;
    double from = shape->at[0][k], way = shape->at[1][k] - from;

    low = cell[k] == 0 ? -INFINITY : low;
    high = cell[k] + 1 == cells[k] ? INFINITY : high;
    if (way != 0.0) {
      q->in[0] = sg_larger(q->in[0], ((way > 0.0 ? low : high) - from) / way);
      q->in[1] = sg_smaller(q->in[1], ((way > 0.0 ? high : low) - from) / way);
    }
  }
}

/* How far the line goes away from the eye in the cell at hand and near it: what
 * comes no nearer there does not hide it by more than the tolerance. */
static uint32_t
far_end_in(const asking *q, const sg_near_plane *plane,
           const sg_grid_shape *shape)
{
  const double *p = shape->at[0], *r = shape->at[1];
  double x = r[0] - p[0], y = r[1] - p[1];
  double more = SG_REACH * q->masks->grid.margin / sqrt(x * x + y * y);
  double from = q->a[2] - sg_plane_depth(plane, p);
  double way = q->b[2] - sg_plane_depth(plane, r) - from;
  double t[2] = {sg_larger(0.0, q->in[0] - more),
                 sg_smaller(1.0, q->in[1] + more)};
  double far = more < 1.0 ? sg_larger(from + t[0] * way, from + t[1] * way)
                          : sg_larger(from, from + way);
  double slack =
      SG_DEPTH_SLACK * (1.0 + fabs(plane->rise[0]) + fabs(plane->rise[1]));

  far += slack - q->masks->scene->tolerance;
  return sg_depth_order(-sg_float_below(-far));
}

/* Whether nothing more is wanted of the cell at hand: some are enough, and
 * these hide all of the line there. Masks that hide more of it are in other
 * cells too. */
static bool
is_done(asking *q)
{
  if (q->enough && !q->done && q->out->n > 0 && q->out->n != q->known) {
    q->known = q->out->n;
    q->done = cell_is_hidden(q);
  }
  return q->done;
}

static bool
ask_mask(asking *q, uint32_t m)
{
  const sg_mask_box *box = &q->masks->box[m];

  return q->low[0] > box->high[0] || q->high[0] < box->low[0] ||
         q->low[1] > box->high[1] || q->high[1] < box->low[1] || try_mask(q, m);
}

/* A mask that hides much of a cell, or none. */
static bool
ask_first(asking *q, uint32_t m)
{
  return m == SG_NO_MASK || is_done(q) || ask_mask(q, m);
}

/* Whether a mask was found to hide a part of the line. */
static bool
was_found(const asking *q, uint32_t m)
{
  size_t i = 0;

  for (; i < q->out->n && q->out->part[i].mask != m; i++) {
  }
  return i < q->out->n;
}

/* Of a cell of many masks those that hide much of it; those that come nearer
 * there than the line's far end there; and the others if the one that covers it
 * hides nothing. */
static bool
ask_near(asking *q, const sg_grid_shape *shape, size_t cell)
{
  const sg_mask_near *near = sg_mask_grid_near(q->masks, cell);
  uint32_t far = near ? far_end_in(q, &near->plane, shape) : 0, i = 0;
  bool good = near && ask_first(q, near->cover);

  for (int k = 0; good && k < SG_SEEN_PLACES; k++) {
    good = ask_first(q, near->seen[k]);
  }
  for (; good && i < near->front && near->order[i] >> 32 < far && !is_done(q);
       i++) {
    good = ask_mask(q, (uint32_t)near->order[i]);
  }
  if (good && i == near->front && !is_done(q) && !was_found(q, near->cover)) {
    for (; good && i < near->n && !is_done(q); i++) {
      good =
          near->order[i] >> 32 >= far || ask_mask(q, (uint32_t)near->order[i]);
    }
  }
  return good;
}

/* The masks of one cell up to the line's far end, by their nearest corner; if
 * these are many and some are enough, by how near they come in this cell. */
static bool
ask_cell(asking *q, const sg_grid_shape *shape, unsigned x, unsigned y)
{
  const sg_grid *grid = &q->masks->grid;
  size_t cell = (size_t)y * grid->nx + x;
  uint32_t begin = grid->start[cell], end = grid->start[cell + 1];

  q->known = SIZE_MAX;
  q->done = false;
  if (begin < end && q->enough) {
    find_in(q, shape, x, y);
    if (end - begin > MANY && isfinite(q->far)) {
      return ask_near(q, shape, cell);
    }
  }
  for (uint32_t i = begin; i < end && !is_done(q); i++) {
    uint32_t m = grid->item[i];
    if (q->masks->box[m].low[2] >= q->far) {
      return true;
    }
    if (!ask_mask(q, m)) {
      return false;
    }
  }
  return true;
}

bool
sg_mask_grid_ask(const sg_mask_grid *masks, size_t at,
                 const sg_hide_throughs *through, bool enough, sg_seen *seen,
                 sg_hiddens *out)
{
  const sg_scene *scene = masks->scene;
  const sg_scene_line *line = &scene->line[at];
  const double *a = scene->at[line->a], *b = scene->at[line->b];
  asking q = {.masks = masks,
              .line = line,
              .a = a,
              .b = b,
              .low = {sg_smaller(a[0], b[0]), sg_smaller(a[1], b[1])},
              .high = {sg_larger(a[0], b[0]), sg_larger(a[1], b[1])},
              .far = sg_line_far_end(scene, line),
              .through = through,
              .seen = seen,
              .out = out,
              .enough = enough};
  sg_grid_shape shape;
  sg_grid_rows rows;

  out->n = out->spans = 0;
  seen->question++;
  sg_line_shape(a, b, &shape);
  sg_turn_shape(masks->way, &shape);
  rows = sg_grid_rows_of(&masks->grid, &shape);
  for (unsigned y = rows.y0; y < rows.y1 && !is_hidden(&q); y++) {
    sg_grid_columns columns = sg_grid_row(&masks->grid, &shape, rows, y);
    for (unsigned x = columns.x0; x < columns.x1 && !is_hidden(&q); x++) {
      if (!ask_cell(&q, &shape, x, y)) {
        return false;
      }
    }
  }
  sort_hidden(out->part, out->n);
  return true;
}
