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

typedef struct sg_work_tree {
  size_t n;
  bool ordered;      /* numbers stay as they came */
  int32_t *number;   /* [n] in the order of the tree */
  sg_work_box *box;  /* [n] of each */
  sg_work_box *part; /* [n] of a part, at its middle */
} sg_work_tree;

/* Takes both arrays over: [n] numbers and their boxes. False: no memory. */
bool sg_work_tree_open(sg_work_tree *tree, int32_t *number, sg_work_box *box,
                       size_t n, bool ordered);
void sg_work_tree_close(sg_work_tree *tree);

/* A walk goes down where `skips` and `passes` (null: nowhere) are false, and
 * ends where `ends` is true of a number. A part has the numbers from the first
 * to the last that passes() is given. Returns that number, or `none`. */
typedef struct sg_work_tree_walk {
  const sg_work_tree *tree;
  bool (*skips)(const void *data, const sg_work_box *box);
  bool (*passes)(const void *data, int32_t first, int32_t last);
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
  bool open;
  sg_work_plant tree[SG_WORK_TREES];
  int trees;
  int32_t fresh[SG_WORK_FRESH];
  int n;
  int32_t upto; /* the numbers to this one have been put in */
  size_t held;  /* in trees */
} sg_work_forest;

void sg_work_forest_clear(sg_work_forest *forest);

#endif
