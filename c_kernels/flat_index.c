/* flat_index.c -- see flat_index.h. */
#include "flat_index.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  FIRST_BITS = 4,
  LEVELS = 64,
  LEVEL_BITS = 6,
  PLACE_BITS = 29,
  BELOW = 32 /* grids for items smaller than usual */
};

/* ---- boxes -------------------------------------------------------------- */

bool
sg_flat_stock_make(size_t room, double size, sg_flat_stock *out)
{
  *out = (sg_flat_stock){.box = malloc((room + 1) * sizeof *out->box),
                         .next = malloc((room + 1) * sizeof *out->next)};
  frexp(size, &out->least);
  out->least -= BELOW;
  return out->box && out->next;
}

void
sg_flat_stock_clear(sg_flat_stock *stock)
{
  free(stock->box);
  free(stock->next);
  *stock = (sg_flat_stock){0};
}

sg_flat_box
sg_flat_box_round(const double (*point)[2], size_t n)
{
  sg_flat_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

  for (size_t i = 0; i < n; i++) {
    for (int k = 0; k < 2; k++) {
      double x = point[i][k];
      box.low[k] = x < box.low[k] ? x : box.low[k];
      box.high[k] = x > box.high[k] ? x : box.high[k];
    }
  }
  return box;
}

/* ---- cells -------------------------------------------------------------- */

/* The grid whose cells are at least as large as the box. */
static int
level_of(const sg_flat_stock *stock, const sg_flat_box *box)
{
  int exponent;
  double size = fmax(box->high[0] - box->low[0], box->high[1] - box->low[1]);

  frexp(size, &exponent);
  exponent -= stock->least;
  return size <= 0 || exponent < 0 ? 0
         : exponent >= LEVELS      ? LEVELS - 1
                                   : exponent;
}

/* Places that are too far for their bits share a cell with others; the boxes
 * tell them apart. */
static uint64_t
key_of(int level, int64_t x, int64_t y)
{
  const uint64_t mask = (UINT64_C(1) << PLACE_BITS) - 1;

  return (uint64_t)level << (2 * PLACE_BITS) |
         ((uint64_t)x & mask) << PLACE_BITS | ((uint64_t)y & mask);
}

static size_t
slot_of(const sg_flat_index *index, uint64_t key)
{
  return (size_t)((key * UINT64_C(0x9e3779b97f4a7c15)) >> (64 - index->bits));
}

/* The cell with this key, or where it would be. */
static sg_flat_cell *
find_cell(const sg_flat_index *index, uint64_t key)
{
  size_t mask = ((size_t)1 << index->bits) - 1, i = slot_of(index, key);

  while (index->cell[i].first != SG_NO_ITEM && index->cell[i].key != key) {
    i = (i + 1) & mask;
  }
  return &index->cell[i];
}

static bool
grow(sg_flat_index *index)
{
  sg_flat_index more = {.bits = index->cell ? index->bits + 1 : FIRST_BITS,
                        .cells = index->cells,
                        .levels = index->levels};
  size_t room = (size_t)1 << more.bits;

  more.cell = malloc(room * sizeof *more.cell);
  if (!more.cell) {
    return false;
  }
  for (size_t i = 0; i < room; i++) {
    more.cell[i].first = SG_NO_ITEM;
  }
  for (size_t i = 0; index->cell && i < room / 2; i++) {
    if (index->cell[i].first != SG_NO_ITEM) {
      *find_cell(&more, index->cell[i].key) = index->cell[i];
    }
  }
  free(index->cell);
  *index = more;
  return true;
}

void
sg_flat_index_clear(sg_flat_index *index)
{
  free(index->cell);
  *index = (sg_flat_index){0};
}

static double
cells_per_unit(const sg_flat_stock *stock, int level)
{
  return ldexp(1, -(level + stock->least));
}

/* Far outside all that has a place, places need not differ. */
static int64_t
place_of(double x, double per_cell)
{
  double place = floor(x * per_cell);

  return place > 1e15    ? (int64_t)1e15
         : place < -1e15 ? -(int64_t)1e15
                         : (int64_t)place;
}

bool
sg_flat_index_add(sg_flat_index *index, const sg_flat_stock *stock,
                  uint32_t item)
{
  const sg_flat_box *box = &stock->box[item];
  int level = level_of(stock, box);
  double per_cell = cells_per_unit(stock, level);
  uint64_t key = key_of(level, place_of(box->low[0], per_cell),
                        place_of(box->low[1], per_cell));
  sg_flat_cell *cell;

  if (!index->cell || 2 * (index->cells + 1) > (size_t)1 << index->bits) {
    if (!grow(index)) {
      return false;
    }
  }
  cell = find_cell(index, key);
  index->cells += cell->first == SG_NO_ITEM;
  stock->next[item] = cell->first;
  *cell = (sg_flat_cell){key, item};
  index->levels |= UINT64_C(1) << level;
  return true;
}

/* ---- asking ------------------------------------------------------------- */

typedef struct question {
  const sg_flat_index *index;
  const sg_flat_stock *stock;
  const sg_flat_box *box;
  sg_flat_visit *visit;
  void *data;
} question;

static bool
ask_cell(const question *q, const sg_flat_cell *cell)
{
  for (uint32_t i = cell->first; i != SG_NO_ITEM; i = q->stock->next[i]) {
    if (sg_flat_boxes_meet(&q->stock->box[i], q->box) && q->visit(q->data, i)) {
      return true;
    }
  }
  return false;
}

/* All cells of a grid: cheaper than looking for more than there are. */
static bool
ask_grid(const question *q, int level)
{
  size_t room = (size_t)1 << q->index->bits;

  for (size_t i = 0; i < room; i++) {
    const sg_flat_cell *cell = &q->index->cell[i];
    if (cell->first != SG_NO_ITEM &&
        cell->key >> (2 * PLACE_BITS) == (uint64_t)level && ask_cell(q, cell)) {
      return true;
    }
  }
  return false;
}

/* An item that meets the box begins in a cell of it, or in one before. */
static bool
ask_level(const question *q, int level)
{
  double per_cell = cells_per_unit(q->stock, level);
  int64_t from[2], to[2];

  for (int k = 0; k < 2; k++) {
    from[k] = place_of(q->box->low[k], per_cell) - 1;
    to[k] = place_of(q->box->high[k], per_cell);
  }
  if ((double)(to[0] - from[0] + 1) * (double)(to[1] - from[1] + 1) >
      (double)q->index->cells) {
    return ask_grid(q, level);
  }
  for (int64_t x = from[0]; x <= to[0]; x++) {
    for (int64_t y = from[1]; y <= to[1]; y++) {
      if (ask_cell(q, find_cell(q->index, key_of(level, x, y)))) {
        return true;
      }
    }
  }
  return false;
}

bool
sg_flat_index_near(const sg_flat_index *index, const sg_flat_stock *stock,
                   const sg_flat_box *box, sg_flat_visit *visit, void *data)
{
  const question q = {index, stock, box, visit, data};

  for (uint64_t left = index->levels; left; left &= left - 1) {
    if (ask_level(&q, __builtin_ctzll(left))) {
      return true;
    }
  }
  return false;
}

/* ---- overlap ------------------------------------------------------------ */

/* Whether a side of a has all of b outside, or inside by no more than depth. */
static bool
side_parts(const double (*a)[2], size_t na, const double (*b)[2], size_t nb,
           double depth)
{
  for (size_t i = 0; i < na; i++) {
    const double *p = a[i], *q = a[i + 1 < na ? i + 1 : 0];
    double nx = p[1] - q[1], ny = q[0] - p[0], most = -INFINITY;
    for (size_t k = 0; k < nb; k++) {
      double in = nx * (b[k][0] - p[0]) + ny * (b[k][1] - p[1]);
      most = in > most ? in : most;
    }
    if ((nx != 0 || ny != 0) &&
        (most <= 0 || most * most <= depth * depth * (nx * nx + ny * ny))) {
      return true;
    }
  }
  return false;
}

bool
sg_convex_overlap(const double (*a)[2], size_t na, const double (*b)[2],
                  size_t nb, double depth)
{
  return !side_parts(a, na, b, nb, depth) && !side_parts(b, nb, a, na, depth);
}
