/* hide_search.c -- see hide_search.h */
#include "hide_search.h"
#include "engine/search.h"

#include "engine/list.h"
#include "number/bounds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Up to so many are sorted by insertion. */
enum { FEW = 16 };

/* Rounding is far below this part of what is compared. */
#define SLACK 1.000001

/* ---- what questions share ---- */

bool
sg_seen_init(sg_seen *seen, size_t n)
{
  *seen = (sg_seen){.by = calloc(n + 1, sizeof *seen->by)};
  return seen->by != NULL;
}

void
sg_seen_clear(sg_seen *seen)
{
  free(seen->by);
  *seen = (sg_seen){0};
}

/* True at the first time in this question. */
static bool
is_new(sg_seen *seen, uint32_t thing)
{
  bool fresh = seen->by[thing] != seen->question;

  seen->by[thing] = seen->question;
  return fresh;
}

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

static bool
add_overlap(sg_overlaps *out, const sg_overlap *part)
{
  bool ok = sg_list_grow(&out->part, out->n, &out->room, sizeof *part);

  if (ok) {
    out->part[out->n++] = *part;
  }
  return ok;
}

/* ---- masks ---- */

static void
line_shape(const double a[2], const double b[2], sg_grid_shape *out)
{
  *out = (sg_grid_shape){2, {{a[0], a[1]}, {b[0], b[1]}}};
}

/* Makes `way` its x. */
static void
turn_shape(const double way[2], sg_grid_shape *shape)
{
  for (unsigned i = 0; i < shape->corners; i++) {
    double x = shape->at[i][0], y = shape->at[i][1];

    shape->at[i][0] = x * way[0] + y * way[1];
    shape->at[i][1] = y * way[0] - x * way[1];
  }
}

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
  turn_shape(masks->way, out);
}

/* Whether sides of masks mostly run one way: by the sum of their doubled
 * angles, the longer the more. */
static bool
find_mask_way(sg_mask_grid *masks)
{
  const sg_scene *scene = masks->scene;
  double sum[2] = {0, 0}, all = 0;

  for (size_t i = 0; i < 3 * scene->masks; i++) {
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

/* The largest float that is not above x. */
static float
float_below(double x)
{
  float f = (float)x;

  return (double)f > x ? nextafterf(f, -INFINITY) : f;
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
      box->low[k] = float_below(mask->low[k] - e);
      box->high[k] = -float_below(-mask->high[k] - e);
    }
    box->low[2] = float_below(mask->low[2]); /* what masks are sorted by */
  }
}

bool
sg_mask_grid_init(sg_mask_grid *masks, const sg_scene *scene,
                  const sg_cancel *cancel, bool *memory)
{
  *masks = (sg_mask_grid){
      .scene = scene, .box = malloc((scene->masks + 1) * sizeof *masks->box)};
  *memory = masks->box != NULL;
  if (!*memory) {
    return false;
  }
  make_boxes(masks);
  bool along = find_mask_way(masks);

  return sg_grid_init(&masks->grid, scene->masks, shape_of_mask, masks,
                      scene->close, along, cancel, memory);
}

void
sg_mask_grid_clear(sg_mask_grid *masks)
{
  sg_grid_clear(&masks->grid);
  free(masks->box);
  *masks = (sg_mask_grid){0};
}

static int
hidden_compare(const void *a, const void *b)
{
  const sg_hidden *x = a, *y = b;

  if (x->from != y->from) {
    return x->from < y->from ? -1 : 1;
  }
  if (x->to != y->to) {
    return x->to < y->to ? -1 : 1;
  }
  return (x->mask > y->mask) - (x->mask < y->mask);
}

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

/* True if both ends are certainly outside of one side of the mask, as
 * sg_mask_hides() would find with a root and two divisions. */
static bool
is_beside(const sg_scene *scene, const sg_scene_mask *mask, const double a[3],
          const double b[3])
{
  double e = SLACK * scene->close;

  for (int k = 0; k < 3; k++) {
    const double *p = scene->at[mask->v[k]];
    const double *q = scene->at[mask->v[(k + 1) % 3]];
    double x = q[0] - p[0], y = q[1] - p[1];
    double far = -e * (fabs(x) + fabs(y));
    if (x * (a[1] - p[1]) - y * (a[0] - p[0]) < far &&
        x * (b[1] - p[1]) - y * (b[0] - p[0]) < far) {
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
  bool whole; /* one mask hides all of the line */
} asking;

static bool
try_mask(asking *q, uint32_t m)
{
  const sg_scene *scene = q->masks->scene;
  const sg_scene_mask *mask = &scene->mask[m];
  sg_hidden part = {.mask = m};

  if (!is_new(q->seen, m) || is_beside(scene, mask, q->a, q->b) ||
      !sg_mask_hides(scene, mask, q->line, &part) ||
      sg_hide_sees_through(q->through, q->line->s, mask->s)) {
    return true;
  }
  q->whole |= part.from == 0.0 && part.to == 1.0;
  return add_hidden(q->out, &part);
}

/* The masks of one cell, nearest first, up to the line's far end. */
static bool
ask_cell(asking *q, size_t cell)
{
  const sg_grid *grid = &q->masks->grid;

  for (uint32_t i = grid->start[cell]; i < grid->start[cell + 1]; i++) {
    const sg_mask_box *box = &q->masks->box[grid->item[i]];
    if (box->low[2] >= q->far) {
      return true;
    }
    if (q->low[0] <= box->high[0] && q->high[0] >= box->low[0] &&
        q->low[1] <= box->high[1] && q->high[1] >= box->low[1] &&
        !try_mask(q, grid->item[i])) {
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
              .out = out};
  sg_grid_shape shape;
  sg_grid_rows rows;

  out->n = 0;
  seen->question++;
  line_shape(a, b, &shape);
  turn_shape(masks->way, &shape);
  rows = sg_grid_rows_of(&masks->grid, &shape);
  for (unsigned y = rows.y0; y < rows.y1 && !(q.whole && enough); y++) {
    sg_grid_columns columns = sg_grid_row(&masks->grid, &shape, rows, y);
    for (unsigned x = columns.x0; x < columns.x1 && !(q.whole && enough); x++) {
      if (!ask_cell(&q, (size_t)y * masks->grid.nx + x)) {
        return false;
      }
    }
  }
  sort_hidden(out->part, out->n);
  return true;
}

/* ---- lines ---- */

/* The stretches of a class. */
typedef struct turned {
  const sg_stretch *stretch;
  const double *way;
} turned;

static void
shape_of_stretch(const void *data, size_t i, sg_grid_shape *out)
{
  const turned *of = data;

  line_shape(of->stretch[i].from, of->stretch[i].to, out);
  turn_shape(of->way, out);
}

/* The way of a class: of all its stretches, the longer the more. */
static void
find_way(sg_line_grid *lines, unsigned class)
{
  double sum[2] = {0, 0};

  for (size_t i = lines->begin[class]; i < lines->begin[class + 1]; i++) {
    const sg_stretch *s = &lines->stretch[i];
    double x = s->to[0] - s->from[0], y = s->to[1] - s->from[1];
    double back = x * sum[0] + y * sum[1] < 0 ? -1 : 1;

    sum[0] += back * x;
    sum[1] += back * y;
  }
  double size = sqrt(sum[0] * sum[0] + sum[1] * sum[1]);
  bool known = size > 0 && isfinite(size);

  lines->way[class][0] = known ? sum[0] / size : 1;
  lines->way[class][1] = known ? sum[1] / size : 0;
}

/* The direction of a line as a number in 0 to 2 that changes by no more than
 * the angle; both ways of a line are one direction, and 2 is 0 again. */
static double
direction_of(const double a[2], const double b[2])
{
  double x = b[0] - a[0], y = b[1] - a[1];
  double sum = fabs(x) + fabs(y);

  return sum > 0.0 ? 1.0 - (y < 0.0 ? -x : x) / sum : 0.0;
}

/* The class of a direction, from 0; it may be any whole number. */
static int
class_of(double direction)
{
  return (int)floor(direction * (SG_LINE_CLASSES / 2.0));
}

static unsigned
class_of_line(const sg_line_grid *lines, size_t i)
{
  const sg_scene *scene = lines->scene;
  const sg_scene_line *line = &scene->line[lines->line[i]];

  return (unsigned)class_of(
             direction_of(scene->at[line->a], scene->at[line->b])) %
         SG_LINE_CLASSES;
}

/* order[], place[] and begin[]: a counting sort by class. */
static void
order_lines(sg_line_grid *lines)
{
  size_t at[SG_LINE_CLASSES + 1] = {0};

  for (size_t i = 0; i < lines->n; i++) {
    unsigned c = class_of_line(lines, i);
    lines->place[i] = c; /* until it is known */
    at[c + 1]++;
  }
  for (unsigned c = 0; c < SG_LINE_CLASSES; c++) {
    at[c + 1] += at[c];
  }
  memcpy(lines->begin, at, sizeof at);
  for (size_t i = 0; i < lines->n; i++) {
    size_t place = at[lines->place[i]]++;
    lines->place[i] = (uint32_t)place;
    lines->order[place] = (uint32_t)i;
  }
}

static void
make_stretches(sg_line_grid *lines)
{
  const sg_scene *scene = lines->scene;

  for (size_t k = 0; k < lines->n; k++) {
    const sg_scene_line *line = &scene->line[lines->line[lines->order[k]]];
    sg_stretch *stretch = &lines->stretch[k];
    memcpy(stretch->from, scene->at[line->a], sizeof stretch->from);
    memcpy(stretch->to, scene->at[line->b], sizeof stretch->to);
    stretch->length = sg_line_length(scene, line);
  }
}

bool
sg_line_grid_init(sg_line_grid *lines, const sg_scene *scene,
                  const uint32_t *line, size_t n, const sg_cancel *cancel,
                  bool *memory)
{
  bool good;

  *lines = (sg_line_grid){.scene = scene,
                          .line = line,
                          .n = n,
                          .order = malloc((n + 1) * sizeof *lines->order),
                          .place = malloc((n + 1) * sizeof *lines->place),
                          .stretch = malloc((n + 1) * sizeof *lines->stretch)};
  good = *memory = lines->order && lines->place && lines->stretch;
  if (good) {
    order_lines(lines);
    make_stretches(lines);
  }
  for (unsigned c = 0; good && c < SG_LINE_CLASSES; c++) {
    const turned of = {lines->stretch + lines->begin[c], lines->way[c]};

    find_way(lines, c);
    good =
        sg_grid_init(&lines->grid[c], lines->begin[c + 1] - lines->begin[c],
                     shape_of_stretch, &of, scene->close, true, cancel, memory);
  }
  return good;
}

void
sg_line_grid_clear(sg_line_grid *lines)
{
  for (unsigned c = 0; c < SG_LINE_CLASSES; c++) {
    sg_grid_clear(&lines->grid[c]);
  }
  free(lines->order);
  free(lines->place);
  free(lines->stretch);
  *lines = (sg_line_grid){0};
}

/* False if b certainly does not lie on a: what sg_lines_overlap() asks, every
 * condition multiplied by what it divides by. across and along: of the first
 * point of b, times the length of a. */
static bool
may_lie_on(const sg_stretch *a, const sg_stretch *b, double close)
{
  double x = a->to[0] - a->from[0], y = a->to[1] - a->from[1];
  double u = b->to[0] - b->from[0], v = b->to[1] - b->from[1];
  double p = b->from[0] - a->from[0], q = b->from[1] - a->from[1];
  double across = x * q - y * p, turn = x * v - y * u;
  double far = SLACK * close * a->length;
  double along, advance, low, high;

  if (fabs(across) > fabs(turn) + far) {
    return false; /* nearly always */
  }
  along = x * p + y * q;
  advance = x * u + y * v;
  low = sg_larger(0.0, sg_smaller(along, along + advance));
  high = sg_smaller(x * x + y * y, sg_larger(along, along + advance));
  return fabs(turn) <= SLACK * SG_OVERLAP_TURN * fabs(advance) && high > low &&
         fabs(turn) * (high - low) <= 2 * far * fabs(advance);
}

static int
overlap_compare(const void *a, const void *b)
{
  const sg_overlap *x = a, *y = b;

  return (x->line > y->line) - (x->line < y->line);
}

/* A question: a stretch, and what was found. */
typedef struct crossing {
  const sg_line_grid *lines;
  uint32_t place;          /* of the stretch */
  bool substitute_outline; /* what is near it counts too */
  sg_seen *seen;
  sg_overlaps *out;
} crossing;

static bool
try_line(const crossing *q, uint32_t place)
{
  const sg_line_grid *lines = q->lines;
  const sg_scene *scene = lines->scene;
  size_t line = lines->line[lines->order[q->place]];
  sg_overlap part = {.line = lines->line[lines->order[place]]};

  if (place == q->place || !is_new(q->seen, place) ||
      !sg_lines_overlap(scene, &scene->line[line], &scene->line[part.line],
                        &part)) {
    return true;
  }
  return add_overlap(q->out, &part);
}

/* The lines of a class along the stretch. */
static bool
ask_class(const crossing *q, unsigned class)
{
  const sg_line_grid *lines = q->lines;
  const sg_grid *grid = &lines->grid[class];
  const sg_stretch *of = lines->stretch + lines->begin[class];
  sg_grid_shape shape;
  sg_grid_rows rows;
  sg_grid wide;

  line_shape(lines->stretch[q->place].from, lines->stretch[q->place].to,
             &shape);
  turn_shape(lines->way[class], &shape);
  if (q->substitute_outline) {
    wide = *grid;
    wide.margin += lines->scene->near;
    grid = &wide;
  }
  rows = sg_grid_rows_of(grid, &shape);
  for (unsigned y = rows.y0; y < rows.y1; y++) {
    sg_grid_columns columns = sg_grid_row(grid, &shape, rows, y);
    size_t row = (size_t)y * grid->nx;
    for (uint32_t k = grid->start[row + columns.x0];
         k < grid->start[row + columns.x1]; k++) {
      if ((q->substitute_outline ||
           may_lie_on(&lines->stretch[q->place], &of[grid->item[k]],
                      lines->scene->close)) &&
          !try_line(q, (uint32_t)lines->begin[class] + grid->item[k])) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_line_grid_ask(const sg_line_grid *lines, size_t i, sg_seen *seen,
                 sg_overlaps *out)
{
  const sg_stretch *stretch = &lines->stretch[lines->place[i]];
  double direction = direction_of(stretch->from, stretch->to);
  bool substitute_outline =
      lines->scene->line[lines->line[i]].look.substitute_outline;
  double turn = substitute_outline ? SG_NEAR_TURN : SG_OVERLAP_TURN;
  double spread = SLACK * turn; /* the angle is less */
  int first = class_of(direction - spread), last = class_of(direction + spread);
  crossing q = {lines, lines->place[i], substitute_outline, seen, out};

  out->n = 0;
  seen->question++;
  for (int c = first; c <= last && c < first + SG_LINE_CLASSES; c++) {
    unsigned class = (unsigned)(c + SG_LINE_CLASSES) % SG_LINE_CLASSES;
    if (lines->begin[class] < lines->begin[class + 1] &&
        !ask_class(&q, class)) {
      return false;
    }
  }
  if (out->n > 1) {
    qsort(out->part, out->n, sizeof *out->part, overlap_compare);
  }
  return true;
}
