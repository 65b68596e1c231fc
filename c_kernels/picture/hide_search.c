/* hide_search.c -- lines that lie on one another: see hide_search.h. */
#include "hide_search_private.h"

#include "engine/list.h"
#include "engine/search.h"
#include "number/bounds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* Room for one more in a growing array; false: no memory. */
static bool
add_overlap(sg_overlaps *out, const sg_overlap *part)
{
  bool ok = sg_list_grow(&out->part, out->n, &out->room, sizeof *part);

  if (ok) {
    out->part[out->n++] = *part;
  }
  return ok;
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

  sg_line_shape(of->stretch[i].from, of->stretch[i].to, out);
  sg_turn_shape(of->way, out);
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
  double far = SG_SLACK * close * a->length;
  double along, advance, low, high;

  if (fabs(across) > fabs(turn) + far) {
    return false; /* nearly always */
  }
  along = x * p + y * q;
  advance = x * u + y * v;
  low = sg_larger(0.0, sg_smaller(along, along + advance));
  high = sg_smaller(x * x + y * y, sg_larger(along, along + advance));
  return fabs(turn) <= SG_SLACK * SG_OVERLAP_TURN * fabs(advance) &&
         high > low && fabs(turn) * (high - low) <= 2 * far * fabs(advance);
}

SG_ORDER(overlap_compare, sg_overlap, SG_BY(line));

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

  if (place == q->place || !sg_is_new(q->seen, place) ||
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

  sg_line_shape(lines->stretch[q->place].from, lines->stretch[q->place].to,
                &shape);
  sg_turn_shape(lines->way[class], &shape);
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
  double spread = SG_SLACK * turn; /* the angle is less */
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
