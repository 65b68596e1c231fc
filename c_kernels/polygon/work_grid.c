/* work_grid.c -- a uniform grid over segments of a plane: see work_grid.h. */
#include "work_grid.h"
#include "engine/list.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Cells a segment, at most so many entries a segment in each direction. */
static const double CELLS = 2, ENTRIES = 1.5;
enum { MOST_CELLS = 1 << 15 }; /* in one direction */

/* fmin() and fmax() are calls. What is not a number counts as b. */
static double
lesser(double a, double b)
{
  return a < b ? a : b;
}

static double
greater(double a, double b)
{
  return a > b ? a : b;
}

/* ---- the shape ---------------------------------------------------------- */

void
sg_work_main_direction(const sg_work_grid_segment *segment, size_t n,
                       size_t step, double out[2])
{
  double c = 0, s = 0;

  for (size_t i = 0; i < n; i += step) {
    double x = segment[i].to[0] - segment[i].from[0];
    double y = segment[i].to[1] - segment[i].from[1];
    double length = sqrt(x * x + y * y);
    if (length > 0 && isfinite(length)) {
      c += (x * x - y * y) / length;
      s += 2 * x * y / length;
    }
  }
  double half = c == 0 && s == 0 ? 0 : atan2(s, c) / 2;
  out[0] = cos(half);
  out[1] = sin(half);
}

/* In the frame, before scaling. */
static void
turned(const sg_work_grid *grid, const double point[2], double out[2])
{
  double x = point[0] - grid->origin[0], y = point[1] - grid->origin[1];

  out[0] = x * grid->along[0] + y * grid->along[1];
  out[1] = y * grid->along[0] - x * grid->along[1];
}

typedef struct extent {
  double low[2], high[2], sum[2]; /* box; lengths along each axis, summed */
} extent;

static void
measure(sg_work_grid *grid, const sg_work_grid_segment *segment, size_t n,
        extent *out)
{
  *out = (extent){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}, {0, 0}};
  for (size_t i = 0; i < n; i++) {
    double from[2], to[2];
    turned(grid, segment[i].from, from);
    turned(grid, segment[i].to, to);
    for (int k = 0; k < 2; k++) {
      out->low[k] = lesser(lesser(from[k], to[k]), out->low[k]);
      out->high[k] = greater(greater(from[k], to[k]), out->high[k]);
      out->sum[k] += fabs(to[k] - from[k]);
    }
  }
}

/* A cell no larger than the box and no smaller than can be counted. */
static double
possible(double size, double width)
{
  return lesser(greater(size, width / MOST_CELLS), width);
}

/* For segments: as small as the number of entries allows. */
static void
cells_of_segments(const extent *box, const double width[2], size_t n,
                  double size[2])
{
  for (int k = 0; k < 2; k++) {
    size[k] = possible(box->sum[k] / (ENTRIES * (double)n), width[k]);
  }
}

/* For ends: as the number of cells allows; squares, unless the segments are
 * longer than those, for then what is asked for is long the same way. */
static void
cells_of_ends(const extent *box, const double width[2], size_t n,
              double size[2])
{
  double cell = width[0] * width[1] / (CELLS * (double)n), square = sqrt(cell);
  double aspect = greater(box->sum[0] / (double)n, square) /
                  greater(box->sum[1] / (double)n, square);

  if (!(aspect > 0) || !isfinite(aspect)) {
    aspect = 1;
  }
  size[0] = possible(sqrt(cell * aspect), width[0]);
  size[1] = possible(cell / size[0], width[1]);
}

/* Cells as small as their number allows; squares unless the segments lie
 * mostly one way. */
static void
choose_cells(sg_work_grid *grid, sg_grid_of of, const extent *box, size_t n)
{
  double width[2], size[2];

  for (int k = 0; k < 2; k++) {
    width[k] = box->high[k] - box->low[k];
    if (!(width[k] > 0) || !isfinite(width[k])) {
      width[k] = DBL_MIN;
    }
  }
  if (of == SG_GRID_OF_ENDS) {
    cells_of_ends(box, width, n, size);
  } else {
    cells_of_segments(box, width, n, size);
  }
  double most = CELLS * (double)n;
  double cells = width[0] / size[0] * (width[1] / size[1]);
  /* Too many: widen the finer direction first, to squares, then both. */
  if (cells > most) {
    int fine = size[0] < size[1] ? 0 : 1;
    double even = lesser(size[fine] * (cells / most), size[!fine]);
    cells /= even / size[fine];
    size[fine] = even;
  }
  double both = cells > most ? sqrt(cells / most) : 1;
  for (int k = 0; k < 2; k++) {
    double count = floor(width[k] / (size[k] * both));
    grid->cells[k] = (int32_t)lesser(greater(count, 1), MOST_CELLS);
    grid->per[k] = grid->cells[k] / width[k];
    if (!isfinite(grid->per[k])) {
      grid->per[k] = 0;
    }
  }
}

bool
sg_work_grid_open(sg_work_grid *grid, sg_grid_of of,
                  const sg_work_grid_segment *segment, size_t n, double error)
{
  extent box;
  double low[2];

  *grid = (sg_work_grid){.expected = n};
  grid->origin[0] = n ? segment[0].from[0] : 0;
  grid->origin[1] = n ? segment[0].from[1] : 0;
  sg_work_main_direction(segment, n, 1, grid->along);
  measure(grid, segment, n, &box);
  choose_cells(grid, of, &box, n);
  /* The box's corner becomes the origin. */
  low[0] = box.low[0] * grid->along[0] - box.low[1] * grid->along[1];
  low[1] = box.low[0] * grid->along[1] + box.low[1] * grid->along[0];
  if (n) {
    grid->origin[0] += low[0];
    grid->origin[1] += low[1];
  }
  grid->margin = 1e-6 + 16 * error * greater(grid->per[0], grid->per[1]);
  size_t cells = (size_t)grid->cells[0] * (size_t)grid->cells[1];
  grid->first = calloc(cells, sizeof *grid->first);
  grid->open = grid->first != NULL;
  return grid->open;
}

void
sg_work_grid_close(sg_work_grid *grid)
{
  free(grid->first);
  free(grid->entry);
  *grid = (sg_work_grid){0};
}

/* ---- where things are --------------------------------------------------- */

static int32_t
clamp(double cell, int32_t cells)
{
  if (!(cell > 0)) { /* not a number, too */
    return 0;
  }
  return cell < cells ? (int32_t)cell : cells - 1;
}

static void
to_cells(const sg_work_grid *grid, const double point[2], double out[2])
{
  turned(grid, point, out);
  out[0] *= grid->per[0];
  out[1] *= grid->per[1];
}

void
sg_work_grid_cell(const sg_work_grid *grid, const double point[2],
                  int32_t out[2])
{
  double at[2];

  to_cells(grid, point, at);
  out[0] = clamp(at[0], grid->cells[0]);
  out[1] = clamp(at[1], grid->cells[1]);
}

/* Widens low..high by the part of a-b with `bottom` <= y <= `top`. */
static void
cover(const double a[2], const double b[2], double bottom, double top,
      double *low, double *high)
{
  double end[2][2] = {{a[0], a[1]}, {b[0], b[1]}};

  if ((a[1] < bottom && b[1] < bottom) || (a[1] > top && b[1] > top)) {
    return;
  }
  for (int i = 0; i < 2; i++) {
    double y = lesser(greater(end[i][1], bottom), top), x = end[i][0];
    if (y != end[i][1]) {
      x = a[0] + (b[0] - a[0]) * ((y - a[1]) / (b[1] - a[1]));
      x = lesser(greater(x, lesser(a[0], b[0])), greater(a[0], b[0]));
    }
    *low = lesser(x, *low);
    *high = greater(x, *high);
  }
}

/* The columns that the piece covers in the walk's row. */
static void
cover_row(sg_work_grid_walk *walk)
{
  const sg_work_grid *grid = walk->grid;
  double low = INFINITY, high = -INFINITY, m = grid->margin;
  double bottom = walk->row == 0 ? -INFINITY : walk->row - m;
  double top = walk->row == grid->cells[1] - 1 ? INFINITY : walk->row + 1 + m;

  if (walk->corners == 1) {
    low = high = walk->corner[0][0];
  }
  for (int i = 0; i < walk->corners && walk->corners > 1; i++) {
    cover(walk->corner[i], walk->corner[(i + 1) % walk->corners], bottom, top,
          &low, &high);
  }
  walk->cell = clamp(low - m, grid->cells[0]);
  walk->last_cell = low <= high ? clamp(high + m, grid->cells[0]) : -1;
}

void
sg_work_grid_walk_open(sg_work_grid_walk *walk, sg_work_grid *grid,
                       const double corner[][2], int corners)
{
  double low = INFINITY, high = -INFINITY;

  walk->grid = grid;
  walk->corners = corners;
  for (int i = 0; i < corners; i++) {
    to_cells(grid, corner[i], walk->corner[i]);
    low = lesser(walk->corner[i][1], low);
    high = greater(walk->corner[i][1], high);
  }
  walk->row = clamp(low - grid->margin, grid->cells[1]);
  walk->last_row = clamp(high + grid->margin, grid->cells[1]);
  cover_row(walk);
  walk->cell--;
  walk->none = 0;
  walk->link = walk->taken = &walk->none;
}

/* On to the next cell; false: there is none. */
static bool
next_cell(sg_work_grid_walk *walk)
{
  while (++walk->cell > walk->last_cell) {
    if (++walk->row > walk->last_row) {
      return false;
    }
    cover_row(walk);
    walk->cell--;
  }
  return true;
}

static size_t
cell_index(const sg_work_grid_walk *walk)
{
  return (size_t)walk->row * (size_t)walk->grid->cells[0] + (size_t)walk->cell;
}

int32_t
sg_work_grid_walk_next(sg_work_grid_walk *walk)
{
  while (*walk->link == 0) {
    if (!next_cell(walk)) {
      return 0;
    }
    walk->link = &walk->grid->first[cell_index(walk)];
  }
  sg_work_grid_entry *entry = &walk->grid->entry[*walk->link - 1];
  walk->taken = walk->link;
  walk->link = &entry->next;
  return entry->number;
}

void
sg_work_grid_walk_drop(sg_work_grid_walk *walk)
{
  *walk->taken = *walk->link;
  walk->link = walk->taken;
}

/* ---- filling ------------------------------------------------------------ */

static bool
push(sg_work_grid *grid, size_t cell, int32_t number)
{
  if (grid->entries == INT32_MAX ||
      !sg_list_grow(&grid->entry, (size_t)grid->entries, &grid->room,
                    sizeof *grid->entry)) {
    return false;
  }
  grid->entry[grid->entries] = (sg_work_grid_entry){number, grid->first[cell]};
  grid->first[cell] = ++grid->entries;
  return true;
}

bool
sg_work_grid_add(sg_work_grid *grid, int32_t number, const double from[2],
                 const double to[2])
{
  double corner[2][2] = {{from[0], from[1]}, {to[0], to[1]}};
  sg_work_grid_walk walk;

  sg_work_grid_walk_open(&walk, grid, (const double(*)[2])corner, 2);
  while (next_cell(&walk)) {
    if (!push(grid, cell_index(&walk), number)) {
      return false;
    }
  }
  grid->held++;
  return true;
}

bool
sg_work_grid_add_point(sg_work_grid *grid, int32_t number, const double at[2])
{
  int32_t cell[2];

  sg_work_grid_cell(grid, at, cell);
  grid->held++;
  return push(grid, (size_t)cell[1] * (size_t)grid->cells[0] + (size_t)cell[0],
              number);
}

void
sg_work_grid_filled(sg_work_grid *grid)
{
  grid->filled = grid->entries;
}

bool
sg_work_grid_is_stale(const sg_work_grid *grid)
{
  return grid->held > 2 * grid->expected + 64 ||
         grid->entries / 8 > grid->filled + 4096;
}
