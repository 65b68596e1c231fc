/* flat_index.h -- which convex polygons in a plane are near another one.
 *
 * Layer: kernel. A grid of grids: an item lies in the cell, of the grid whose
 * cells are just larger than its box, that has its lower left corner. So items
 * of any size may be together. Cells are found by hashing; what a caller sees
 * does not depend on that, as candidates are sifted by their boxes.
 *
 * Items are numbers below the room of a *stock*, which has their boxes. Many
 * indexes may share one; an item is in one of them at a time.
 */
#ifndef SG_FLAT_INDEX_H
#define SG_FLAT_INDEX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_flat_box {
  double low[2], high[2];
} sg_flat_box;

typedef struct sg_flat_stock {
  sg_flat_box *box; /* [room] */
  uint32_t *next;   /* private: the next item in the same cell */
  int least;        /* private: exponent of the smallest cells */
} sg_flat_stock;

#define SG_NO_ITEM UINT32_MAX

typedef struct sg_flat_cell {
  uint64_t key;
  uint32_t first; /* item, or SG_NO_ITEM: no cell */
} sg_flat_cell;

typedef struct sg_flat_index {
  sg_flat_cell *cell; /* [1 << bits] or null: empty */
  unsigned bits;
  size_t cells;    /* in use */
  uint64_t levels; /* bit l: some item is in grid l */
} sg_flat_index;

/* For items of about this size, up to a million times as large or small. False:
 * no memory. Owner: sg_flat_stock_clear() in any case. */
bool sg_flat_stock_make(size_t room, double size, sg_flat_stock *out);
void sg_flat_stock_clear(sg_flat_stock *stock);

/* An index begins as {0}. */
void sg_flat_index_clear(sg_flat_index *index);

/* Adds an item, whose box is set and stays as it is. False: no memory. */
bool sg_flat_index_add(sg_flat_index *index, const sg_flat_stock *stock,
                       uint32_t item);

/* True: stop, this is what was looked for. */
typedef bool sg_flat_visit(void *data, uint32_t item);

/* Visits the items whose boxes meet `box`, until one says stop: true. */
bool sg_flat_index_near(const sg_flat_index *index, const sg_flat_stock *stock,
                        const sg_flat_box *box, sg_flat_visit *visit,
                        void *data);

/* The box round n points. */
sg_flat_box sg_flat_box_round(const double (*point)[2], size_t n);

static inline bool
sg_flat_boxes_meet(const sg_flat_box *a, const sg_flat_box *b)
{
  return a->low[0] <= b->high[0] && b->low[0] <= a->high[0] &&
         a->low[1] <= b->high[1] && b->low[1] <= a->high[1];
}

/* Whether two convex polygons, counter-clockwise, overlap deeper than `depth`:
 * no side of either has all of the other outside, or inside by no more. A
 * sliver across another polygon overlaps it, however thin it is. Inexact. */
bool sg_convex_overlap(const double (*a)[2], size_t na, const double (*b)[2],
                       size_t nb, double depth);

#endif
