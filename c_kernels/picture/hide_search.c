/* hide_search.c -- lines that lie on one another: see hide_search.h. */
#include "hide_search_private.h"

#include "engine/list.h"
#include "engine/search.h"
#include "number/bounds.h"
#include "rows/sort.h"

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

/* So many lines are many; in more cells than so many, each, they are long. */
enum { MANY = 64, LONG = 4 };

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

static void
end_shape(const double at[2], const double way[2], sg_grid_shape *out)
{
  *out = (sg_grid_shape){1, {{at[0], at[1]}}};
  sg_turn_shape(way, out);
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

/* ---- long lines ---- */

/* An end of a stretch: of stretch of/2 of a class, its `to` if of is odd. */
typedef struct line_end {
  double at[2];
  uint32_t of;
} line_end;

SG_ORDER(end_compare, line_end, SG_BY(at[0]) SG_BY(at[1]) SG_BY(of));

static bool
same_end(const double a[2], const double b[2])
{
  return a[0] == b[0] && a[1] == b[1];
}

static bool
end_before(const double a[2], const double b[2])
{
  return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
}

static bool
sort_ends(line_end *end, size_t n, const sg_cancel *cancel, bool *memory)
{
  sg_sort_end how = sg_sort(end, n, sizeof *end, end_compare, cancel);

  *memory = how != SG_SORT_NO_MEMORY;
  return how == SG_SORTED;
}

static void
turn_stretch(sg_stretch *of)
{
  sg_stretch was = *of;

  memcpy(of->from, was.to, sizeof of->from);
  memcpy(of->to, was.from, sizeof of->to);
}

/* Turns n stretches so that their `from` is an end of no fewer than their `to`.
 * end, many: room for 2 n. */
static bool
turn_stretches(sg_stretch *stretch, size_t n, line_end *end, uint32_t *many,
               const sg_cancel *cancel, bool *memory)
{
  for (uint32_t i = 0; i < 2 * n; i++) {
    const double *at = i % 2 ? stretch[i / 2].to : stretch[i / 2].from;

    end[i] = (line_end){{at[0], at[1]}, i};
  }
  if (!sort_ends(end, 2 * n, cancel, memory)) {
    return false;
  }
  for (size_t i = 0, k; i < 2 * n; i = k) {
    for (k = i + 1; k < 2 * n && same_end(end[i].at, end[k].at); k++) {
    }
    for (size_t j = i; j < k; j++) {
      many[end[j].of] = (uint32_t)(k - i);
    }
  }
  for (size_t i = 0; i < n; i++) {
    if (many[2 * i] < many[2 * i + 1]) {
      turn_stretch(&stretch[i]);
    }
  }
  return true;
}

/* Sorts the stretches of a class by `from`. end, was and order: room for
 * them. */
static bool
sort_stretches(sg_line_grid *lines, unsigned class, line_end *end,
               sg_stretch *was, uint32_t *order, const sg_cancel *cancel,
               bool *memory)
{
  size_t begin = lines->begin[class], n = lines->begin[class + 1] - begin;
  sg_stretch *stretch = lines->stretch + begin;

  memcpy(was, stretch, n * sizeof *was);
  memcpy(order, lines->order + begin, n * sizeof *order);
  for (uint32_t i = 0; i < n; i++) {
    end[i] = (line_end){{was[i].from[0], was[i].from[1]}, i};
  }
  if (!sort_ends(end, n, cancel, memory)) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    stretch[i] = was[end[i].of];
    lines->order[begin + i] = order[end[i].of];
    lines->place[order[end[i].of]] = (uint32_t)(begin + i);
  }
  return true;
}

/* False: stopped, or no memory. */
static bool
arrange_stretches(sg_line_grid *lines, unsigned class, const sg_cancel *cancel,
                  bool *memory)
{
  size_t n = lines->begin[class + 1] - lines->begin[class];
  line_end *end = malloc(2 * n * sizeof *end);
  uint32_t *number = malloc(2 * n * sizeof *number);
  sg_stretch *was = malloc(n * sizeof *was);
  bool good = *memory = end && number && was;

  good = good &&
         turn_stretches(lines->stretch + lines->begin[class], n, end, number,
                        cancel, memory) &&
         sort_stretches(lines, class, end, was, number, cancel, memory);
  free(end);
  free(number);
  free(was);
  return good;
}

static void
shape_of_tip(const void *data, size_t i, sg_grid_shape *out)
{
  const turned *of = data;

  end_shape(of->stretch[i].to, of->way, out);
}

/* Of a class whose stretches are in its grid. */
static bool
are_long(const sg_line_grid *lines, unsigned class)
{
  size_t n = lines->begin[class + 1] - lines->begin[class];
  const sg_grid *grid = &lines->grid[class];

  return n >= MANY && grid->start[(size_t)grid->nx * grid->ny] > LONG * n;
}

/* ---- the grid ---- */

/* False: stopped, or no memory. */
static bool
class_init(sg_line_grid *lines, unsigned class, const sg_cancel *cancel,
           bool *memory)
{
  const turned of = {lines->stretch + lines->begin[class], lines->way[class]};
  size_t n = lines->begin[class + 1] - lines->begin[class];
  double close = lines->scene->close;
  sg_grid *grid = &lines->grid[class];

  find_way(lines, class);
  if (!sg_grid_init(grid, n, shape_of_stretch, NULL, &of, close, true, cancel,
                    memory)) {
    return false;
  }
  if (!are_long(lines, class)) {
    return true;
  }
  sg_grid_clear(grid);
  return arrange_stretches(lines, class, cancel, memory) &&
         sg_grid_init(grid, n, shape_of_stretch, NULL, &of, close, true, cancel,
                      memory) &&
         sg_grid_init(&lines->tip[class], n, shape_of_tip, NULL, &of, close,
                      false, cancel, memory);
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
    good = class_init(lines, c, cancel, memory);
  }
  return good;
}

void
sg_line_grid_clear(sg_line_grid *lines)
{
  for (unsigned c = 0; c < SG_LINE_CLASSES; c++) {
    sg_grid_clear(&lines->grid[c]);
    sg_grid_clear(&lines->tip[c]);
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

static bool
try_items(const crossing *q, unsigned class, const uint32_t *item, size_t n)
{
  const sg_line_grid *lines = q->lines;
  uint32_t begin = (uint32_t)lines->begin[class];

  for (size_t i = 0; i < n; i++) {
    if ((q->substitute_outline ||
         may_lie_on(&lines->stretch[q->place], &lines->stretch[begin + item[i]],
                    lines->scene->close)) &&
        !try_line(q, begin + item[i])) {
      return false;
    }
  }
  return true;
}

/* The items of a class, in a grid of it, along a shape. */
static bool
ask_along(const crossing *q, unsigned class, const sg_grid *grid,
          const sg_grid_shape *shape)
{
  sg_grid_rows rows = sg_grid_rows_of(grid, shape);

  for (unsigned y = rows.y0; y < rows.y1; y++) {
    sg_grid_columns columns = sg_grid_row(grid, shape, rows, y);
    const uint32_t *start = grid->start + (size_t)y * grid->nx;
    uint32_t first = start[columns.x0];

    if (!try_items(q, class, grid->item + first, start[columns.x1] - first)) {
      return false;
    }
  }
  return true;
}

/* What comes to an end of the stretch, but first .. last - 1 of the class. */
static bool
ask_end(const crossing *q, unsigned class, const double at[2], size_t first,
        size_t last)
{
  const sg_grid *grid = &q->lines->grid[class];
  sg_grid_shape shape;

  end_shape(at, q->lines->way[class], &shape);
  sg_grid_rows rows = sg_grid_rows_of(grid, &shape);

  for (unsigned y = rows.y0; y < rows.y1; y++) {
    for (unsigned x = rows.x0; x < rows.x1; x++) {
      const uint32_t *start = grid->start + (size_t)y * grid->nx + x;
      const uint32_t *item = grid->item + start[0];
      size_t n = start[1] - start[0], low, high;

      SG_SEARCH(low, 0, n, item[low] < first);
      SG_SEARCH(high, low, n, item[high] < last);
      if (!try_items(q, class, item, low) ||
          !try_items(q, class, item + high, n - high)) {
        return false;
      }
    }
  }
  return true;
}

/* The lines of a class of long ones that have a part in common with it. */
static bool
ask_ends(const crossing *q, unsigned class, const sg_grid_shape *shape)
{
  const sg_line_grid *lines = q->lines;
  const sg_stretch *of = lines->stretch + lines->begin[class];
  const sg_stretch *s = &lines->stretch[q->place];
  size_t n = lines->begin[class + 1] - lines->begin[class], first, last;

  SG_SEARCH(first, 0, n, end_before(of[first].from, s->from));
  SG_SEARCH(last, first, n, !end_before(s->from, of[last].from));
  return ask_end(q, class, s->to, 0, 0) &&
         ask_end(q, class, s->from, first, last) &&
         ask_along(q, class, &lines->tip[class], shape);
}

static bool
in_few_cells(const sg_grid *grid, const sg_grid_shape *shape)
{
  sg_grid_rows rows = sg_grid_rows_of(grid, shape);

  return (size_t)(rows.y1 - rows.y0) * (rows.x1 - rows.x0) <= LONG;
}

/* The lines of a class along the stretch. */
static bool
ask_class(const crossing *q, unsigned class)
{
  const sg_line_grid *lines = q->lines;
  sg_grid grid = lines->grid[class];
  sg_grid_shape shape;

  sg_line_shape(lines->stretch[q->place].from, lines->stretch[q->place].to,
                &shape);
  sg_turn_shape(lines->way[class], &shape);
  if (q->substitute_outline) {
    grid.margin += lines->scene->near;
  } else if (lines->tip[class].start && !in_few_cells(&grid, &shape)) {
    return ask_ends(q, class, &shape);
  }
  return ask_along(q, class, &grid, &shape);
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
