/* flat_index.h -- which convex polygons in a plane are near another one.
 *
 * Layer: kernel. Inexact. A tree of square cells, each parted into four: an
 * item lies where its middle is, whatever its size, and a node knows the box of
 * all that lies below it. Where boxes say little, as in a fan of needles, all
 * of whose boxes meet, a node is asked for its *outline* too: a convex polygon
 * of a few corners round all that lies below it. Outlines are made where
 * questions come again and again to no end, so where boxes are enough they cost
 * nothing. What is found does not depend on any of this; in which order it is
 * found does, and that depends on the items and questions before alone.
 *
 * Items are numbers below the room of a *stock*, which has their boxes. Many
 * indexes may share one; an item is in one of them at a time.
 *
 * Source: H. Samet, The quadtree and related hierarchical data structures, 1984
 * (bucket quadtree).
 */
#ifndef SG_FLAT_INDEX_H
#define SG_FLAT_INDEX_H

#include "polygon/convex.h"

#include <stdint.h>

typedef struct sg_flat_box {
  double low[2], high[2];
} sg_flat_box;

enum { SG_FLAT_QUARTERS = 4 };

typedef struct sg_flat_node { /* a line of memory */
  sg_flat_box box;
  uint32_t below[SG_FLAT_QUARTERS]; /* nodes, or of a leaf: items */
  uint32_t next;       /* of a leaf that cannot be parted: more of it; of a
                          free node: the next one */
  uint32_t outline;    /* or SG_NO_ITEM */
  unsigned char items; /* of a leaf */
  bool leaf, stale;    /* stale: the outline is not of all */
  unsigned char asked; /* how often for an outline it has not */
} sg_flat_node;

typedef struct sg_flat_outline {
  size_t corners;
  double corner[SG_CONVEX_CORNERS][2];
} sg_flat_outline;

typedef struct sg_flat_stock {
  sg_flat_box *box; /* [room] */
  size_t room;
  double least; /* private, as all that follows: smallest cell */
  sg_flat_node *node;
  size_t nodes, node_room;
  uint32_t free_node;
  sg_flat_outline *outline;
  size_t outlines, outline_room;
  uint32_t free_outline;
} sg_flat_stock;

#define SG_NO_ITEM UINT32_MAX

typedef struct sg_flat_index {
  bool used;
  uint32_t root;
  double low[2], size; /* the cell of the root */
} sg_flat_index;

/* For items of about this size, up to a million times as large or small. False:
 * no memory. Owner: sg_flat_stock_clear() in any case. */
bool sg_flat_stock_make(size_t room, double size, sg_flat_stock *out);
void sg_flat_stock_clear(sg_flat_stock *stock);

/* Room for as many items or more. False: no memory, and nothing changed. */
bool sg_flat_stock_reserve(sg_flat_stock *stock, size_t room);

/* An index begins as {0}. What it held may be in another one then. */
void sg_flat_index_clear(sg_flat_index *index, sg_flat_stock *stock);

/* Adds an item, whose box is set, finite, and stays as it is. False: no memory,
 * and it may be there or not. */
bool sg_flat_index_add(sg_flat_index *index, sg_flat_stock *stock,
                       uint32_t item);

/* The corners of an item, counter-clockwise; how many they are. */
typedef size_t sg_flat_corners(const void *data, uint32_t item,
                               double out[SG_CONVEX_CORNERS][2]);

/* What is near a convex polygon, counter-clockwise. */
typedef struct sg_flat_question {
  sg_flat_box box;
  const double (*corner)[2]; /* [corners]; null: only the box is known */
  size_t corners;
  double depth;                /* of overlaps that matter */
  sg_flat_corners *corners_of; /* items; null where `corner` is */
  const void *items;           /* its argument */
} sg_flat_question;

/* True: stop, this is what was looked for. */
typedef bool sg_flat_visit(void *data, uint32_t item);

/* Visits items whose boxes meet that of the question, until one says stop:
 * true. All those it visits that may overlap it deeper than `depth`, and, where
 * only the box is known, all whose boxes meet. */
bool sg_flat_index_near(const sg_flat_index *index, sg_flat_stock *stock,
                        const sg_flat_question *question, sg_flat_visit *visit,
                        void *data);

/* What all lies in: true: it is to be looked at more closely. */
typedef bool sg_flat_closer(void *data, const sg_flat_box *box);

/* Goes through an index from large to small, and visits the items of those
 * parts that are to be looked at, until one says stop: true. */
bool sg_flat_index_walk(const sg_flat_index *index, const sg_flat_stock *stock,
                        sg_flat_closer *closer, sg_flat_visit *visit,
                        void *data);

/* The box round n points. */
sg_flat_box sg_flat_box_round(const double (*point)[2], size_t n);

static inline bool
sg_flat_boxes_meet(const sg_flat_box *a, const sg_flat_box *b)
{
  return a->low[0] <= b->high[0] && b->low[0] <= a->high[0] &&
         a->low[1] <= b->high[1] && b->low[1] <= a->high[1];
}

#endif
