#include "fan.h"

#include "number/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WORTH = 2 }; /* a node of this level has 16 triangles */

/* What rounding may take from a direction of length 1, and far more. */
#define LET_OUT 0x1p-40

/* A corner that all triangles of a node have. */
typedef struct hub {
  double at[3];
  uint32_t name;
} hub;

typedef struct node {
  hub hub[3]; /* [hubs]; when all is known, one at most */
  int hubs;
  int32_t polygon; /* of all triangles; -1: they have several */
  sg_box way;      /* round the directions from the hub */
} node;

struct sg_fans {
  const sg_bvh *tree;
  sg_fan_read *read;
  const void *data;
  bool by_place;
  bool worth;
  node *level[SG_BVH_LEVELS]; /* from 1 on */
};

static bool
same_hub(const sg_fans *f, const hub *a, const hub *b)
{
  return f->by_place ? a->at[0] == b->at[0] && a->at[1] == b->at[1] &&
                           a->at[2] == b->at[2]
                     : a->name == b->name;
}

/* ---- what all have ---- */

static node
node_of_triangle(const sg_fans *f, size_t place)
{
  sg_fan_triangle t;
  node out = {.hubs = 3};

  f->read(f->data, place, &t);
  out.polygon = t.polygon;
  for (int k = 0; k < 3; k++) {
    memcpy(out.hub[k].at, t.at[k], sizeof t.at[k]);
    out.hub[k].name = t.name[k];
  }
  return out;
}

/* Box `at` of a level, 0: a triangle. */
static node
node_at(const sg_fans *f, unsigned level, size_t at)
{
  return level == 0 ? node_of_triangle(f, at) : f->level[level][at];
}

static void
keep_common(const sg_fans *f, node *all, const node *one)
{
  int kept = 0;

  for (int i = 0; i < all->hubs; i++) {
    bool has = false;
    for (int k = 0; k < one->hubs; k++) {
      has = has || same_hub(f, &all->hub[i], &one->hub[k]);
    }
    if (has) {
      all->hub[kept++] = all->hub[i];
    }
  }
  all->hubs = kept;
  all->polygon = all->polygon == one->polygon ? all->polygon : -1;
}

/* False: no memory, or stopped. */
static bool
find_level(sg_fans *f, unsigned level, const sg_cancel *cancel)
{
  size_t below = f->tree->count[level - 1];

  if (!(f->level[level] = malloc(f->tree->count[level] * sizeof(node)))) {
    return false;
  }
  for (size_t i = 0; i < f->tree->count[level]; i++) {
    node all = node_at(f, level - 1, i * SG_BVH_WIDTH);

    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    for (size_t k = i * SG_BVH_WIDTH + 1;
         k < (i + 1) * SG_BVH_WIDTH && k < below; k++) {
      node one = node_at(f, level - 1, k);
      keep_common(f, &all, &one);
    }
    f->level[level][i] = all;
    f->worth =
        f->worth || (level == WORTH && (all.hubs > 0 || all.polygon >= 0));
  }
  return true;
}

/* Where a node above has a hub, what is below has the same. False: stopped. */
static bool
choose_hubs(sg_fans *f, const sg_cancel *cancel)
{
  for (unsigned level = f->tree->levels - 1; level >= 1; level--) {
    for (size_t i = 0; i < f->tree->count[level]; i++) {
      node *below = &f->level[level][i];
      if (level + 1 < f->tree->levels) {
        const node *above = &f->level[level + 1][i / SG_BVH_WIDTH];
        below->hub[0] = above->hubs > 0 ? above->hub[0] : below->hub[0];
      }
      below->hubs = below->hubs > 0;
      if (sg_cancel_every(cancel, i)) {
        return false;
      }
    }
  }
  return true;
}

/* ---- directions ---- */

/* False: `to` is in the same place, or too far away. */
static bool
direction(const double from[3], const double to[3], double out[3])
{
  double size = 0;

  sg_minus(to, from, out);
  for (int k = 0; k < 3; k++) {
    size = fmax(size, fabs(out[k]));
  }
  if (!(size > 0x1p-1000 && size < 0x1p1000)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    out[k] /= size;
  }
  size = sg_length(out);
  for (int k = 0; k < 3; k++) {
    out[k] /= size;
  }
  return true;
}

/* The box round the arc that a triangle is, seen from the hub; round the whole
 * sphere, if that is more than a sixth of a turn. */
static sg_box
way_of_triangle(const sg_fans *f, size_t place, const hub *from)
{
  node t = node_of_triangle(f, place);
  double way[2][3];
  int n = 0;
  sg_box box = sg_box_none();

  for (int k = 0; k < 3; k++) {
    if (!same_hub(f, &t.hub[k], from) && n < 2 &&
        direction(from->at, t.hub[k].at, way[n])) {
      sg_box_add(&box, way[n++]);
    }
  }
  double close = n == 2 ? sg_dot(way[0], way[1]) : -1;
  double out = close > 0.5 ? 1 - sqrt((1 + close) / 2) + LET_OUT : 3;

  for (int k = 0; k < 3; k++) {
    box.lo[k] = (out < 3 ? box.lo[k] : 0) - out;
    box.hi[k] = (out < 3 ? box.hi[k] : 0) + out;
  }
  return box;
}

/* False: stopped. */
static bool
find_ways(sg_fans *f, const sg_cancel *cancel)
{
  for (unsigned level = 1; level < f->tree->levels; level++) {
    size_t below = f->tree->count[level - 1];

    for (size_t i = 0; i < f->tree->count[level]; i++) {
      node *n = &f->level[level][i];
      n->way = sg_box_none();
      for (size_t k = i * SG_BVH_WIDTH;
           n->hubs > 0 && k < (i + 1) * SG_BVH_WIDTH && k < below; k++) {
        sg_box way = level == 1 ? way_of_triangle(f, k, &n->hub[0])
                                : f->level[level - 1][k].way;
        sg_box_join(&n->way, &way);
      }
      if (sg_cancel_every(cancel, i)) {
        return false;
      }
    }
  }
  return true;
}

/* ---- the whole ---- */

bool
sg_fans_open(const sg_bvh *tree, sg_fan_read *read, const void *data,
             bool by_place, const sg_cancel *cancel, sg_fans **out)
{
  sg_fans *f = calloc(1, sizeof *f);
  bool good = f != NULL;

  *out = f;
  if (!good) {
    return false;
  }
  *f =
      (sg_fans){.tree = tree, .read = read, .data = data, .by_place = by_place};
  for (unsigned level = 1;
       level < tree->levels && good && (level <= WORTH || f->worth); level++) {
    good = find_level(f, level, cancel);
  }
  if (good && f->worth) {
    good = choose_hubs(f, cancel) && find_ways(f, cancel);
  } else if (good) {
    sg_fans_close(f);
    *out = NULL;
  }
  return good;
}

void
sg_fans_close(sg_fans *fans)
{
  for (unsigned level = 0; fans && level < SG_BVH_LEVELS; level++) {
    free(fans->level[level]);
  }
  free(fans);
}

bool
sg_fans_apart(const void *fans, unsigned level, size_t a, size_t b)
{
  const sg_fans *f = fans;
  const node *x = &f->level[level][a], *y = &f->level[level][b];

  return (x->polygon >= 0 && x->polygon == y->polygon) ||
         (x->hubs > 0 && y->hubs > 0 && same_hub(f, &x->hub[0], &y->hub[0]) &&
          !sg_box_overlap(&x->way, &y->way, 0));
}
