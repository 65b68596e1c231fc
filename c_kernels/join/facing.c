#include "facing.h"

#include "number/bounds.h"
#include "number/vector.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  CELLS = 15, /* across half a side of a cube: what looks along x, y or z, up to
                rounding, is in the middle of one */
  WAYS = 3 * CELLS * CELLS,
  ALONG = 2 /* the reach is along each axis: in any other way, that many */
};

#define ROUNDED 0x1p-40
#define LARGE   1e38 /* a float holds no more */

/* ---- which ways ---- */

/* The triangles that face about one way, or the other way round. */
typedef struct way {
  size_t n, number;
  double sum[3]; /* of their normals */
} way;

/* Of length 1, to the side where its largest coordinate is positive; its
 * number. WAYS: the triangle has no area. */
static size_t
way_of(const double corner[3][3], double normal[3])
{
  double u[3], w[3];
  int side = 0;

  sg_minus(corner[1], corner[0], u);
  sg_minus(corner[2], corner[0], w);
  sg_cross(u, w, normal);
  double length = sg_any_length(normal);

  if (!(length > 0 && length < INFINITY)) {
    return WAYS;
  }
  for (int k = 1; k < 3; k++) {
    side = fabs(normal[k]) > (1 + ROUNDED) * fabs(normal[side]) ? k : side;
  }
  length = normal[side] < 0 ? -length : length;
  for (int k = 0; k < 3; k++) {
    normal[k] /= length;
  }
  size_t number = (size_t)side;

  for (int k = 1; k < 3; k++) {
    double at = normal[(side + k) % 3] / normal[side]; /* -1 to 1 */
    int cell = (int)((at + 1) * CELLS / 2);

    cell = cell < 0 ? 0 : cell >= CELLS ? CELLS - 1 : cell;
    number = number * CELLS + (size_t)cell;
  }
  return number;
}

static int
by_number_of_triangles(const void *x, const void *y)
{
  const way *a = x, *b = y;

  return a->n != b->n ? (a->n < b->n) - (a->n > b->n)
                      : (a->number > b->number) - (a->number < b->number);
}

/* Adds the triangles to their ways; false: stopped. */
static bool
add_ways(size_t n, sg_facing_read *read, const void *data,
         const sg_cancel *cancel, way *all, uint16_t *number)
{
  for (size_t i = 0; i < WAYS; i++) {
    all[i].number = i;
  }
  for (size_t i = 0; i < n; i++) {
    double corner[3][3], normal[3];

    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    read(data, i, corner);
    number[i] = (uint16_t)way_of((const double(*)[3])corner, normal);
    if (number[i] < WAYS) {
      way *of = &all[number[i]];

      of->n++;
      for (int k = 0; k < 3; k++) {
        of->sum[k] += normal[k];
      }
    }
  }
  return true;
}

/* The fullest ways are groups, the first of them the axes; what faces no such
 * way is one group. */
static void
take_ways(way *all, sg_facing *out, unsigned char *group_of)
{
  qsort(all, WAYS, sizeof *all, by_number_of_triangles);
  memset(group_of, SG_FACING_GROUPS, WAYS + 1);
  for (size_t i = 0; i < SG_FACING_GROUPS && all[i].n > 0; i++) {
    double length = sg_any_length(all[i].sum);

    group_of[all[i].number] = (unsigned char)i;
    for (int k = 0; k < 3 && i < SG_FACING_AXES; k++) {
      out->axis[i][k] = all[i].sum[k] / length;
    }
    out->axes += i < SG_FACING_AXES;
  }
}

bool
sg_facing_find(size_t n, sg_facing_read *read, const void *data,
               const sg_cancel *cancel, sg_facing *out)
{
  way all[WAYS] = {{0}};
  unsigned char group_of[WAYS + 1];
  uint16_t *number = malloc((n + 1) * sizeof *number);

  *out = (sg_facing){.group = malloc(n + 1)};
  bool good =
      number && out->group && add_ways(n, read, data, cancel, all, number);

  take_ways(all, out, group_of);
  for (size_t i = 0; i < n && good; i++) {
    out->group[i] = group_of[number[i]];
  }
  free(number);
  return good;
}
/* ---- how far nodes reach ---- */

/* Of nothing: along each axis the lowest, then along each the highest. */
static void
empty_node(float *node, size_t axes)
{
  for (size_t k = 0; k < axes; k++) {
    node[k] = INFINITY;
    node[axes + k] = -INFINITY;
  }
}

static double
largest(const double p[3])
{
  return sg_larger(fabs(p[0]), sg_larger(fabs(p[1]), fabs(p[2])));
}

static void
add_point(const sg_facing *facing, const double p[3], float *node)
{
  /* To floats they are rounded in order. */
  double size = largest(p);
  double out = ROUNDED * size + facing->reach / 2 + DBL_MIN;

  for (size_t k = 0; k < facing->axes; k++) {
    double at = sg_dot(facing->axis[k], p);
    float lo = size < LARGE ? (float)(at - out) : -INFINITY;
    float hi = size < LARGE ? (float)(at + out) : INFINITY;

    node[k] = lo < node[k] ? lo : node[k];
    node[facing->axes + k] =
        hi > node[facing->axes + k] ? hi : node[facing->axes + k];
  }
}

static void
add_node(const float *below, size_t axes, float *node)
{
  for (size_t k = 0; k < axes; k++) {
    node[k] = below[k] < node[k] ? below[k] : node[k];
    node[axes + k] =
        below[axes + k] > node[axes + k] ? below[axes + k] : node[axes + k];
  }
}

/* False: no memory, or stopped. */
static bool
fill_level(sg_facing *facing, unsigned level, const sg_cancel *cancel)
{
  const sg_bvh *tree = facing->tree;
  size_t size = 2 * facing->axes, below = tree->count[level - 1];
  float *out = malloc((tree->count[level] * size + 1) * sizeof *out);

  facing->level[level] = out;
  for (size_t i = 0; out && i < tree->count[level]; i++) {
    empty_node(out + i * size, facing->axes);
  }
  for (size_t i = 0; out && i < below; i++) {
    float *node = out + i / SG_BVH_WIDTH * size;
    double corner[3][3];

    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    if (level > 1) {
      add_node(facing->level[level - 1] + i * size, facing->axes, node);
      continue;
    }
    facing->read(facing->data, tree->item[i], corner);
    for (int k = 0; k < 3; k++) {
      add_point(facing, corner[k], node);
    }
  }
  return out != NULL;
}

/* How far the triangles below a node reach along an axis. */
static void
range_along(const sg_facing *facing, const double axis[3], unsigned level,
            size_t node, double *lo, double *hi)
{
  const sg_bvh *tree = facing->tree;
  size_t width = (size_t)1 << (2 * level), end = (node + 1) * width;

  *lo = INFINITY;
  *hi = -INFINITY;
  for (size_t i = node * width; i < end && i < tree->n; i++) {
    double corner[3][3];

    facing->read(facing->data, tree->item[i], corner);
    for (int c = 0; c < 3; c++) {
      double at = sg_dot(axis, corner[c]);
      double out = ROUNDED * largest(corner[c]) + facing->reach / 2 + DBL_MIN;

      *lo = sg_smaller(*lo, at - out);
      *hi = sg_larger(*hi, at + out);
    }
  }
}

/* False: no memory, or stopped. */
static bool
fill_own(sg_facing *facing, unsigned level, const sg_cancel *cancel)
{
  const sg_bvh *tree = facing->tree;
  sg_facing_own *own = malloc(tree->count[level] * sizeof *own);

  facing->own[level] = own;
  for (size_t i = 0; own && i < tree->count[level]; i++) {
    double corner[3][3];

    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    facing->read(facing->data, tree->item[i << (2 * level)], corner);
    if (way_of((const double(*)[3])corner, own[i].axis) == WAYS) {
      memset(own[i].axis, 0, sizeof own[i].axis);
    }
    range_along(facing, own[i].axis, level, i, &own[i].lo, &own[i].hi);
  }
  return own != NULL;
}

/* Whether they do not overlap along the way the first faces. */
static bool
are_apart_along(const sg_facing *facing, unsigned level, size_t a, size_t b)
{
  const sg_facing_own *own = &facing->own[level][a];
  double lo, hi;

  if (facing->reads) {
    atomic_fetch_add_explicit(facing->reads, (size_t)1 << (2 * level),
                              memory_order_relaxed);
  }
  range_along(facing, own->axis, level, b, &lo, &hi);
  return lo > own->hi || own->lo > hi;
}

bool
sg_facing_measure(sg_facing *facing, const sg_bvh *tree, double reach,
                  sg_facing_read *read, const void *data,
                  const sg_cancel *cancel)
{
  bool good = true;

  facing->reach = ALONG * reach;
  facing->tree = tree;
  facing->read = read;
  facing->data = data;
  for (unsigned level = 1; good && level < tree->levels; level++) {
    good = fill_level(facing, level, cancel) &&
           (level > SG_FACING_LOW || fill_own(facing, level, cancel));
  }
  return good;
}

void
sg_facing_clear(sg_facing *facing)
{
  for (unsigned level = 0; level < SG_BVH_LEVELS; level++) {
    free(facing->level[level]);
  }
  for (unsigned level = 0; level <= SG_FACING_LOW; level++) {
    free(facing->own[level]);
  }
  free(facing->group);
  *facing = (sg_facing){0};
}

bool
sg_facing_apart(const void *facing, unsigned level, size_t a, size_t b)
{
  const sg_facing *of = facing;
  size_t axes = of->axes;
  const float *x = of->level[level] + a * 2 * axes;
  const float *y = of->level[level] + b * 2 * axes;
  int apart = 0;

  for (size_t k = 0; k < axes; k++) {
    apart |= (x[k] > y[axes + k]) | (y[k] > x[axes + k]);
  }
  return apart != 0 || (level <= SG_FACING_LOW && a != b &&
                        (are_apart_along(of, level, a, b) ||
                         are_apart_along(of, level, b, a)));
}
