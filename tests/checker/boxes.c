#include "boxes.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FEW = 24, DEEPEST = 60 };

/* Boxes in a cell of space, which is open at its high sides. A pair belongs to
 * the cell that has the lowest corner of what both have in common. */
typedef struct cell {
  double low[3], high[3];
  box_visit *visit;
  void *data;
} cell;

static bool
meet_here(const cell *c, const box *a, const box *b)
{
  for (int k = 0; k < 3; k++) {
    double low = a->low[k] > b->low[k] ? a->low[k] : b->low[k];

    if (low > a->high[k] || low > b->high[k] || low < c->low[k] ||
        low >= c->high[k]) {
      return false;
    }
  }
  return true;
}

static void
each_pair(const cell *c, const box *boxes, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    for (size_t j = i + 1; j < n; j++) {
      if (meet_here(c, &boxes[i], &boxes[j])) {
        c->visit(c->data, boxes[i].item, boxes[j].item);
      }
    }
  }
}

static int
by_value(const void *a, const void *b)
{
  const double *x = a, *y = b;

  return *x < *y ? -1 : *x > *y;
}

/* A place that parts the boxes on coordinate k well: the median of the low
 * sides of some of them. */
static double
middle(const box *boxes, size_t n, int k)
{
  enum { SOME = 101 };
  double low[SOME] = {0};
  size_t m = n < SOME ? n : SOME;

  for (size_t i = 0; i < m; i++) {
    low[i] = boxes[i * n / m].low[k];
  }
  qsort(low, m, sizeof *low, by_value);
  return low[m / 2];
}

/* Copies the boxes of one half of the cell. */
static size_t
half(box *out, const box *boxes, size_t n, int k, double at, bool upper)
{
  size_t m = 0;

  for (size_t i = 0; i < n; i++) {
    if (upper ? boxes[i].high[k] >= at : boxes[i].low[k] < at) {
      out[m++] = boxes[i];
    }
  }
  return m;
}

/* The coordinate on which parting leaves the larger half smallest. */
static int
best_axis(const box *boxes, size_t n, double *at)
{
  size_t least = n;
  int best = -1;

  for (int k = 0; k < 3; k++) {
    double place = middle(boxes, n, k);
    size_t lower = 0, upper = 0;

    for (size_t i = 0; i < n; i++) {
      lower += boxes[i].low[k] < place;
      upper += boxes[i].high[k] >= place;
    }
    lower = lower > upper ? lower : upper;
    if (lower < least) {
      least = lower;
      best = k;
      *at = place;
    }
  }
  return least < n - n / 8 ? best : -1;
}

/* Parts the boxes until they are few or cannot be parted. */
static void
visit_cell(const cell *c, const box *boxes, size_t n, int depth)
{
  double at = 0;
  int k = n > FEW && depth < DEEPEST ? best_axis(boxes, n, &at) : -1;
  box *part;

  if (k < 0) {
    each_pair(c, boxes, n);
    return;
  }
  if (!(part = malloc(n * sizeof *part))) {
    fputs("no memory\n", stderr);
    exit(2);
  }
  for (int upper = 0; upper < 2; upper++) {
    cell inner = *c;
    size_t m = half(part, boxes, n, k, at, upper);

    (upper ? inner.low : inner.high)[k] = at;
    visit_cell(&inner, part, m, depth + 1);
  }
  free(part);
}

void
boxes_meeting(box *boxes, size_t n, box_visit *visit, void *data)
{
  cell all = {{-INFINITY, -INFINITY, -INFINITY},
              {INFINITY, INFINITY, INFINITY},
              visit,
              data};

  visit_cell(&all, boxes, n, 0);
}
