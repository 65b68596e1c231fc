/* flat_shapes.c -- see flat_shapes.h */
#include "flat_shapes.h"

#include <math.h>
#include <stdlib.h>

/* So many cells a shape may be away from the origin. */
#define FAR_CELLS 1e9

/* ---- two shapes ---- */

static void
project(const sg_flat_shape *shape, const double axis[2], double range[2])
{
  range[0] = INFINITY;
  range[1] = -INFINITY;
  for (unsigned i = 0; i < shape->corners; i++) {
    double x = axis[0] * shape->at[i][0] + axis[1] * shape->at[i][1];

    range[0] = x < range[0] ? x : range[0];
    range[1] = x > range[1] ? x : range[1];
  }
}

/* The least way along a normal of one of a's sides that parts a and b. */
static double
depth_by_sides_of(const sg_flat_shape *a, const sg_flat_shape *b)
{
  double least = INFINITY;

  for (unsigned i = 0; i < a->corners; i++) {
    const double *p = a->at[i], *q = a->at[(i + 1) % a->corners];
    double axis[2] = {q[1] - p[1], p[0] - q[0]};
    double length = hypot(axis[0], axis[1]);
    double ra[2], rb[2];

    if (!(length > 0.0)) {
      continue;
    }
    axis[0] /= length;
    axis[1] /= length;
    project(a, axis, ra);
    project(b, axis, rb);
    least = fmin(least, fmin(ra[1] - rb[0], rb[1] - ra[0]));
  }
  return least;
}

double
sg_flat_shape_depth(const sg_flat_shape *a, const sg_flat_shape *b)
{
  return fmin(depth_by_sides_of(a, b), depth_by_sides_of(b, a));
}

bool
sg_flat_shape_is_valid(const sg_flat_shape *shape, double cell)
{
  if (shape->corners < 2 || shape->corners > SG_FLAT_SHAPE_CORNERS) {
    return false;
  }
  for (unsigned i = 0; i < shape->corners; i++) {
    for (int k = 0; k < 2; k++) {
      if (!(fabs(shape->at[i][k]) <= FAR_CELLS * cell)) {
        return false;
      }
    }
  }
  return true;
}

/* ---- the grid ---- */

/* Where a row of cells, y0 <= y <= y1, cuts the side from p to q. */
static void
widen(const double *p, const double *q, double y0, double y1, double range[2])
{
  double low = fmin(p[1], q[1]), high = fmax(p[1], q[1]);

  if (high < y0 || low > y1) {
    return;
  }
  for (int end = 0; end < 2; end++) {
    double y = end ? fmin(high, y1) : fmax(low, y0), x;

    if (p[1] == q[1]) {
      x = end ? p[0] : q[0];
    } else {
      x = p[0] + (q[0] - p[0]) * ((y - p[1]) / (q[1] - p[1]));
    }
    range[0] = fmin(range[0], x);
    range[1] = fmax(range[1], x);
  }
}

typedef struct cells {
  int64_t y, y1; /* the rows that are left */
  int64_t x, x1; /* the cells that are left in row y */
} cells;

static int64_t
cell_of(const sg_flat_shapes *shapes, double x)
{
  return (int64_t)floor(x / shapes->cell);
}

static void
enter_row(const sg_flat_shapes *shapes, const sg_flat_shape *shape, cells *c)
{
  double side = shapes->cell, slack = 1e-6 * side;
  double y0 = (double)c->y * side - slack;
  double y1 = (double)(c->y + 1) * side + slack;
  double range[2] = {INFINITY, -INFINITY};

  for (unsigned i = 0; i < shape->corners; i++) {
    widen(shape->at[i], shape->at[(i + 1) % shape->corners], y0, y1, range);
  }
  if (range[0] > range[1]) { /* between two rows, rounded */
    c->x = 0;
    c->x1 = -1;
    return;
  }
  c->x = cell_of(shapes, range[0] - slack);
  c->x1 = cell_of(shapes, range[1] + slack);
}

static cells
cells_of(const sg_flat_shapes *shapes, const sg_flat_shape *shape)
{
  double range[2];
  cells c;

  project(shape, (const double[2]){0.0, 1.0}, range);
  c.y = cell_of(shapes, range[0]);
  c.y1 = cell_of(shapes, range[1]);
  enter_row(shapes, shape, &c);
  return c;
}

/* The next cell of the shape; false: there is none. */
static bool
next_cell(const sg_flat_shapes *shapes, const sg_flat_shape *shape, cells *c,
          int64_t cell[2])
{
  while (c->x > c->x1) {
    if (++c->y > c->y1) {
      return false;
    }
    enter_row(shapes, shape, c);
  }
  cell[0] = c->x++;
  cell[1] = c->y;
  return true;
}

static size_t
bucket_of(const sg_flat_shapes *shapes, const int64_t cell[2])
{
  uint64_t h = (uint64_t)cell[0] * UINT64_C(0x9e3779b97f4a7c15) ^
               (uint64_t)cell[1] * UINT64_C(0xc2b2ae3d27d4eb4f);

  return (size_t)((h ^ h >> 29) & (shapes->buckets - 1));
}

static void
chain_entry(sg_flat_shapes *shapes, uint32_t i)
{
  sg_flat_shape_entry *entry = &shapes->entry[i];
  uint32_t *bucket = &shapes->bucket[bucket_of(shapes, entry->cell)];

  entry->next = *bucket;
  *bucket = i + 1;
}

static bool
more_buckets(sg_flat_shapes *shapes)
{
  size_t n = shapes->buckets ? 2 * shapes->buckets : 256;
  uint32_t *bucket = calloc(n, sizeof *bucket);

  if (!bucket) {
    return false;
  }
  free(shapes->bucket);
  shapes->bucket = bucket;
  shapes->buckets = n;
  for (size_t i = 0; i < shapes->entries; i++) {
    chain_entry(shapes, (uint32_t)i);
  }
  return true;
}

static bool
add_entry(sg_flat_shapes *shapes, uint32_t shape, const int64_t cell[2])
{
  if (shapes->entries == shapes->entry_room) {
    size_t room = shapes->entry_room ? 2 * shapes->entry_room : 256;
    sg_flat_shape_entry *entry =
        room < UINT32_MAX ? realloc(shapes->entry, room * sizeof *entry) : NULL;

    if (!entry) {
      return false;
    }
    shapes->entry = entry;
    shapes->entry_room = room;
  }
  if (shapes->entries >= shapes->buckets && !more_buckets(shapes)) {
    return false;
  }
  shapes->entry[shapes->entries] =
      (sg_flat_shape_entry){{cell[0], cell[1]}, shape, 0};
  chain_entry(shapes, (uint32_t)shapes->entries++);
  return true;
}

/* ---- doors ---- */

void
sg_flat_shapes_init(sg_flat_shapes *shapes, double cell)
{
  *shapes = (sg_flat_shapes){.cell = cell};
}

void
sg_flat_shapes_clear(sg_flat_shapes *shapes)
{
  free(shapes->shape);
  free(shapes->entry);
  free(shapes->bucket);
  *shapes = (sg_flat_shapes){.cell = shapes->cell};
}

/* Takes the entries from n on out again: the newest are first in their
 * buckets. */
static void
drop_entries(sg_flat_shapes *shapes, size_t n)
{
  while (shapes->entries > n) {
    sg_flat_shape_entry *entry = &shapes->entry[--shapes->entries];

    shapes->bucket[bucket_of(shapes, entry->cell)] = entry->next;
  }
}

bool
sg_flat_shapes_add(sg_flat_shapes *shapes, const sg_flat_shape *shape)
{
  size_t before = shapes->entries;
  int64_t cell[2];

  if (shapes->n == shapes->room) {
    size_t room = shapes->room ? 2 * shapes->room : 64;
    sg_flat_shape *more = realloc(shapes->shape, room * sizeof *more);

    if (!more) {
      return false;
    }
    shapes->shape = more;
    shapes->room = room;
  }
  shapes->shape[shapes->n] = *shape;
  for (cells c = cells_of(shapes, shape); next_cell(shapes, shape, &c, cell);) {
    if (!add_entry(shapes, (uint32_t)shapes->n, cell)) {
      drop_entries(shapes, before);
      return false;
    }
  }
  shapes->n++;
  return true;
}

static bool
cell_free(const sg_flat_shapes *shapes, const int64_t cell[2],
          const sg_flat_shape *shape, double tolerance)
{
  uint32_t i = shapes->bucket[bucket_of(shapes, cell)];

  while (i) {
    const sg_flat_shape_entry *entry = &shapes->entry[i - 1];

    if (entry->cell[0] == cell[0] && entry->cell[1] == cell[1] &&
        sg_flat_shape_depth(shape, &shapes->shape[entry->shape]) > tolerance) {
      return false;
    }
    i = entry->next;
  }
  return true;
}

bool
sg_flat_shapes_free(const sg_flat_shapes *shapes, const sg_flat_shape *shape,
                    double tolerance)
{
  int64_t cell[2];

  if (shapes->entries == 0) {
    return true;
  }
  for (cells c = cells_of(shapes, shape); next_cell(shapes, shape, &c, cell);) {
    if (!cell_free(shapes, cell, shape, tolerance)) {
      return false;
    }
  }
  return true;
}
