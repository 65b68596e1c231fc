/* work_tree.h -- trees over the scratch relation, for what its grids are slow
 * at: see work.h.
 *
 * Layer: kernel, private to work*.c. A long thin triangle covers many cells of
 * a grid, and the vertices on one side of a long edge stand in most of its
 * rings. Boxes of boxes are left out at once. So these are made only when
 * much was looked at in vain; what they answer is what the grids do.
 */
#ifndef SG_WORK_TREE_H
#define SG_WORK_TREE_H

#include "work_grid.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Of a part of the picture, and of the cells that it has in a grid. */
typedef struct sg_work_box {
  double low[2], high[2];
  int32_t first[2], last[2];
} sg_work_box;

/* Makes a box hold another one, too. */
void sg_work_box_join(sg_work_box *box, const sg_work_box *other);

/* The same in a frame of its own, which lies along what is in the part: long
 * segments askew have thin ones. As much wider as anything is rounded. */
typedef struct sg_work_slab {
  double along[2];        /* a unit vector; across is to its left */
  double low[2], high[2]; /* along it, across it */
} sg_work_slab;

typedef struct sg_work_tree {
  size_t n;
  bool ordered;                  /* numbers stay as they came */
  int32_t *number;               /* [n] in the order of the tree */
  sg_work_box *box;              /* [n] of each */
  sg_work_grid_segment *segment; /* [n] of each, or null: then no slabs */
  sg_work_box *part;             /* [n] of a part, at its middle */
  sg_work_slab *slab;            /* [n] the same, or null */
} sg_work_tree;

/* Takes the arrays over: [n] numbers, their boxes, and segments, or null. Slabs
 * have the segments, of a number < 0 its box. False: no memory. */
bool sg_work_tree_open(sg_work_tree *tree, int32_t *number, sg_work_box *box,
                       sg_work_grid_segment *segment, size_t n, bool ordered);
void sg_work_tree_close(sg_work_tree *tree);

/* A triangle, counter-clockwise, that is asked about. */
typedef struct sg_work_corners {
  double at[3][2];
  double low[2], high[2];
} sg_work_corners;

/* Whether a box, a slab, is plainly on the right of a-b: far more than anything
 * is rounded. */
bool sg_work_right_of(const double a[2], const double b[2],
                      const sg_work_box *box);
bool sg_work_slab_right_of(const double a[2], const double b[2],
                           const sg_work_slab *slab);
/* Whether a box, a slab, is plainly apart from a triangle. */
bool sg_work_box_apart(const sg_work_corners *t, const sg_work_box *box);
bool sg_work_slab_apart(const sg_work_corners *t, const sg_work_slab *slab);

/* A walk goes down where `skips`, `skips_slab` and `passes` (null: nowhere) are
 * false, of two halves first to the one that is less far (null: the first), and
 * ends where `ends` is true of a number. A part has the numbers from the first
 * to the last that passes() is given. Returns that number, or `none`. */
typedef struct sg_work_tree_walk {
  const sg_work_tree *tree;
  bool (*skips)(const void *data, const sg_work_box *box);
  bool (*skips_slab)(const void *data, const sg_work_slab *slab);
  bool (*passes)(const void *data, int32_t first, int32_t last);
  int32_t (*far)(const void *data, const sg_work_box *box);
  bool (*ends)(void *data, int32_t number);
  void *data;
  int32_t none;
} sg_work_tree_walk;

int32_t sg_work_tree_go(const sg_work_tree_walk *walk);

/* Numbers that come one after another: in trees each of which is more than
 * twice as large as all after it, except for the last few. */
enum { SG_WORK_TREES = 32, SG_WORK_FRESH = 32 };

/* Edges of one vertex, in half a turn round it, in the order of that. */
typedef struct sg_work_fan {
  int32_t hub;
  sg_work_tree tree;
} sg_work_fan;

/* A tree of edges and, as ~i, of fans. */
typedef struct sg_work_plant {
  sg_work_tree tree;
  sg_work_fan *fan; /* [fans] */
  size_t fans;
  size_t edges; /* with those of the fans */
} sg_work_plant;

typedef struct sg_work_forest {
  sg_work_plant tree[SG_WORK_TREES];
  int trees;
  int32_t fresh[SG_WORK_FRESH];
  int n;
  int32_t upto; /* the numbers to this one have been put in */
  size_t held;  /* in trees */
} sg_work_forest;

#endif
