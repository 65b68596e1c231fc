#include "node_box.h"

#include "oriented_box.h"

#include <stdlib.h>
#include <string.h>

enum {
  CROWD = 64, /* other boxes */
  SOME = 64,  /* boxes that are asked how many others there are */
  ALONG = 2,  /* the reach is along each axis: in any other way, that many */
  ASKED = 256 /* nodes between questions */
};

typedef struct triangle {
  double corner[3][3];
} triangle;

struct sg_node_boxes {
  double reach;
  sg_oriented_box *level[SG_BVH_LEVELS]; /* from 1 on */
};

/* ---- whether it is worth it ---- */

/* How many boxes below box i of a level overlap `box`, up to `most`. */
static size_t
count_met(const sg_bvh *tree, unsigned level, size_t i, const sg_box32 *box,
          size_t most)
{
  sg_box32 own = sg_bvh_box(tree, level, i);
  size_t met = 0;

  for (int c = 0; c < 3; c++) {
    if (!(own.lo[c] <= box->hi[c] && box->lo[c] <= own.hi[c])) {
      return 0;
    }
  }
  if (level == 0) {
    return 1;
  }
  for (size_t k = i * SG_BVH_WIDTH;
       k < (i + 1) * SG_BVH_WIDTH && k < tree->count[level - 1] && met < most;
       k++) {
    met += count_met(tree, level - 1, k, box, most - met);
  }
  return met;
}

/* Whether boxes overlap more than CROWD others, on average of some. */
static bool
is_crowded(const sg_bvh *tree)
{
  size_t step = tree->n / SOME + 1, asked = 0, met = 0;

  for (size_t i = 0; i < tree->n; i += step) {
    sg_box32 box = sg_bvh_box(tree, 0, i);

    asked++;
    for (size_t k = 0; k < tree->count[tree->levels - 1]; k++) {
      met += count_met(tree, tree->levels - 1, k, &box, SOME * CROWD);
    }
  }
  return met > CROWD * asked;
}

/* ---- boxes ---- */

/* An sg_oriented_point: corner i of triangles one after another. */
static void
corner_at(const void *data, size_t i, double out[3])
{
  const triangle *t = data;

  memcpy(out, t[i / 3].corner[i % 3], sizeof t->corner[0]);
}

static bool
fill_level(sg_node_boxes *b, const sg_bvh *tree, unsigned level,
           const triangle *at, const sg_cancel *cancel)
{
  size_t width = (size_t)1 << (2 * level);

  b->level[level] = malloc(tree->count[level] * sizeof *b->level[level]);
  for (size_t i = 0; b->level[level] && i < tree->count[level]; i++) {
    size_t begin = i * width, n = tree->n - begin;

    if (i % ASKED == ASKED - 1 && sg_cancelled(cancel)) {
      return false;
    }
    sg_oriented_box_make(3 * (n < width ? n : width), corner_at, at + begin,
                         &b->level[level][i]);
  }
  return b->level[level] != NULL;
}

bool
sg_node_boxes_open(const sg_bvh *tree, double reach, sg_fan_read *read,
                   const void *data, const sg_cancel *cancel,
                   sg_node_boxes **out)
{
  *out = NULL;
  if (tree->levels < 2 || !is_crowded(tree)) {
    return true;
  }
  triangle *at = malloc(tree->n * sizeof *at);
  bool good = at && (*out = calloc(1, sizeof **out));

  for (size_t i = 0; good && i < tree->n; i++) {
    sg_fan_triangle t;

    read(data, i, &t);
    memcpy(at[i].corner, t.at, sizeof at[i].corner);
  }
  for (unsigned level = 1; good && level < tree->levels; level++) {
    (*out)->reach = ALONG * reach;
    good = fill_level(*out, tree, level, at, cancel);
  }
  free(at);
  return good;
}

void
sg_node_boxes_close(sg_node_boxes *boxes)
{
  for (unsigned level = 0; boxes && level < SG_BVH_LEVELS; level++) {
    free(boxes->level[level]);
  }
  free(boxes);
}

bool
sg_node_boxes_apart(const void *boxes, unsigned level, size_t a, size_t b)
{
  const sg_node_boxes *of = boxes;

  return a != b && sg_oriented_boxes_apart(&of->level[level][a],
                                           &of->level[level][b], of->reach);
}
