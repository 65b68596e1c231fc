/* bvh.h -- a tree of boxes.
 *
 * Layer: kernel. The boxes are put in Morton order of their centres (radix
 * sort: linear time) and a pyramid is laid over them: each box of a level is
 * round SG_BVH_WIDTH of the level below. Several threads may build it; the
 * result is the same for any number of them. bvh_join.h finds what overlaps.
 *
 * Boxes are kept as float32, in units of a power of two and from an origin of
 * the tree's own, let OUT by 2^-24 units: what overlaps is found, and now and
 * then what misses by a few 2^-24 of the tree's size is found too. Boxes are
 * CLOSED: touching ones overlap. 36 bytes for each box.
 */
#ifndef SG_BVH_H
#define SG_BVH_H

#include "thread_pool.h"

#include <stdint.h>

typedef struct sg_box {
  double lo[3], hi[3]; /* lo <= hi in each axis, or the box is empty */
} sg_box;

/* The box of nothing: joining anything to it gives that thing. */
sg_box sg_box_none(void);

/* Grows `box` so that it holds `point`, or another box. */
static inline void
sg_box_add(sg_box *box, const double point[3])
{
  for (int c = 0; c < 3; c++) {
    box->lo[c] = point[c] < box->lo[c] ? point[c] : box->lo[c];
    box->hi[c] = point[c] > box->hi[c] ? point[c] : box->hi[c];
  }
}
void sg_box_join(sg_box *box, const sg_box *other);

/* True if they have a point in common, or are not farther apart than `reach`
 * along each axis. */
bool sg_box_overlap(const sg_box *a, const sg_box *b, double reach);

enum { SG_BVH_WIDTH = 4, SG_BVH_LEVELS = 17 };

typedef float sg_float4 __attribute__((vector_size(16)));

/* A box from a tree's origin, in its unit, let out. */
typedef struct sg_box32 {
  float lo[3], hi[3];
} sg_box32;

/* Boxes 4g .. 4g + 3 of a level, from the tree's origin, in its unit; those
 * that are not there are empty. They are what is below box g of the level
 * above. */
typedef struct sg_box4 {
  sg_float4 lo[3], hi[3];
} sg_box4;

/* Where a tree's boxes are counted from. */
typedef struct sg_bvh_frame {
  double origin[3], unit;
} sg_bvh_frame;

typedef struct sg_bvh {
  size_t n;
  unsigned levels;               /* 0: no box at all */
  size_t count[SG_BVH_LEVELS];   /* boxes of a level; 1 in the highest */
  sg_box4 *level[SG_BVH_LEVELS]; /* level[0]: the boxes, in Morton order */
  uint32_t *item;                /* [n], in Morton order: whose box it is */
  sg_box all;                    /* round everything */
  double origin[3], unit;
} sg_bvh;

/* Box i of a level. */
static inline sg_box32
sg_bvh_box(const sg_bvh *tree, unsigned level, size_t i)
{
  const sg_box4 *four = &tree->level[level][i / SG_BVH_WIDTH];
  sg_box32 box;

  for (int c = 0; c < 3; c++) {
    box.lo[c] = four->lo[c][i % SG_BVH_WIDTH];
    box.hi[c] = four->hi[c][i % SG_BVH_WIDTH];
  }
  return box;
}

/* The frame of a tree over boxes inside `all`, and a box in it. The box round
 * several, let out, is that round each of them, let out. */
sg_bvh_frame sg_bvh_frame_of(const sg_box *all);
sg_box32 sg_box_let_out(const sg_bvh_frame *frame, const sg_box *box);

/* Fills out[0 .. end - begin - 1] with boxes begin .. end - 1. Called by any
 * thread of the thread pool, several at a time. An empty box overlaps nothing.
 */
typedef void sg_bvh_boxes(const void *data, size_t begin, size_t end,
                          sg_box *out);
typedef void sg_bvh_boxes32(const void *data, size_t begin, size_t end,
                            sg_box32 *out);

/* A tree over n boxes, all inside `all` (which need not be tight). Item i is
 * called name[i], or i if `name` is null. Null: no memory, or the cancellation
 * said stop. Owner: the caller, until sg_bvh_close(). Requires n < 2^32. */
sg_bvh *sg_bvh_grow(size_t n, sg_bvh_boxes *boxes, const void *data,
                    const uint32_t *name, const sg_box *all, sg_pool *pool,
                    const sg_cancel *cancel);

/* The same; the boxes of items of one group, a byte for each name, are
 * together. `group` may be null. */
sg_bvh *sg_bvh_grow_grouped(size_t n, sg_bvh_boxes *boxes, const void *data,
                            const uint32_t *name, const unsigned char *group,
                            const sg_box *all, sg_pool *pool,
                            const sg_cancel *cancel);

/* The same of boxes that are already in sg_bvh_frame_of(all), let out. */
sg_bvh *sg_bvh_grow_let_out(size_t n, sg_bvh_boxes32 *boxes, const void *data,
                            const uint32_t *name, const sg_box *all,
                            sg_pool *pool, const sg_cancel *cancel);

/* The same over an array, by the caller alone. */
sg_bvh *sg_bvh_open(const sg_box *box, size_t n, const sg_cancel *cancel);

void sg_bvh_close(sg_bvh *tree);

size_t sg_bvh_bytes(const sg_bvh *tree);

#endif
