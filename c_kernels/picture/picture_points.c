/* picture_points.c -- see picture_points.h
 *
 * The points that stay are in a hash table of square cells, so a point is
 * compared with those of at most four cells.
 */
#include "picture_points.h"

#include "number/bounds.h"
#include "rows/key_table.h"

#include <math.h>
#include <stdlib.h>

/* The side of a cell in units of `close`: most points are farther than that
 * from its sides, and not too many stay in it. */
#define CELL 16.0

enum { ASK_EVERY = 16384 };

typedef struct merging {
  double *x, *y;
  double low[2], side, close;
  sg_key_table cell; /* the last point that stays there */
  uint32_t *before;  /* [n]: the one before it in its cell, or SG_NO_KEY */
} merging;

static void
box_of(const double *x, size_t n, double *low, double *high)
{
  *low = INFINITY;
  *high = -INFINITY;
  for (size_t i = 0; i < n; i++) {
    *low = sg_smaller(*low, x[i]);
    *high = sg_larger(*high, x[i]);
  }
}

double
sg_picture_side(const double *x, const double *y, size_t n)
{
  double low[2], high[2];

  box_of(x, n, &low[0], &high[0]);
  box_of(y, n, &low[1], &high[1]);
  return n ? sg_larger(high[0] - low[0], high[1] - low[1]) : 0.0;
}

static uint32_t
cell_at(const merging *m, int k, double x)
{
  return (uint32_t)((x - m->low[k]) / m->side);
}

/* The first point that stays near point i, not farther than m->close, in one
 * cell; or `found`, if that comes before it. */
static uint32_t
first_near(const merging *m, size_t i, const uint32_t key[2], uint32_t found)
{
  for (uint32_t k = sg_key_table_get(&m->cell, key); k != SG_NO_KEY;
       k = m->before[k]) {
    double dx = m->x[k] - m->x[i], dy = m->y[k] - m->y[i];
    if (k < found && dx * dx + dy * dy <= m->close * m->close) {
      found = k;
    }
  }
  return found;
}

/* The same in all cells that are not farther than m->close. */
static uint32_t
first_of_all(const merging *m, size_t i)
{
  uint32_t x0 = cell_at(m, 0, m->x[i] - m->close);
  uint32_t x1 = cell_at(m, 0, m->x[i] + m->close);
  uint32_t y0 = cell_at(m, 1, m->y[i] - m->close);
  uint32_t y1 = cell_at(m, 1, m->y[i] + m->close);
  uint32_t found = SG_NO_KEY;

  for (uint32_t x = x0; x <= x1; x++) {
    for (uint32_t y = y0; y <= y1; y++) {
      found = first_near(m, i, (uint32_t[2]){x, y}, found);
    }
  }
  return found;
}

static bool
stays(merging *m, size_t i)
{
  uint32_t key[2] = {cell_at(m, 0, m->x[i]), cell_at(m, 1, m->y[i])};
  uint32_t *last = sg_key_table_put(&m->cell, key);

  if (!last) {
    return false;
  }
  m->before[i] = *last;
  *last = (uint32_t)i;
  return true;
}

static bool
merge(merging *m, size_t n, const sg_cancel *cancel, bool *memory)
{
  for (size_t i = 0; i < n; i++) {
    uint32_t first = first_of_all(m, i);
    if (i % ASK_EVERY == 0 && sg_cancelled(cancel)) {
      return false;
    }
    if (first != SG_NO_KEY) {
      m->x[i] = m->x[first];
      m->y[i] = m->y[first];
    } else if (!stays(m, i)) {
      *memory = false;
      return false;
    }
  }
  return true;
}

bool
sg_picture_merge(double *x, double *y, size_t n, double close,
                 const sg_cancel *cancel, bool *memory)
{
  merging m = {.x = x, .y = y, .close = close, .side = CELL * close};
  double high;
  bool done;

  *memory = true;
  if (close == 0.0 || n == 0) {
    return true;
  }
  box_of(x, n, &m.low[0], &high);
  box_of(y, n, &m.low[1], &high);
  m.low[0] -= m.side; /* no cell has a negative number */
  m.low[1] -= m.side;
  sg_key_table_init(&m.cell, 2);
  m.before = malloc(n * sizeof *m.before);
  *memory = m.before != NULL;
  done = *memory && merge(&m, n, cancel, memory);
  sg_key_table_clear(&m.cell);
  free(m.before);
  return done;
}
