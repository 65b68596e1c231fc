/* work_tree.c -- see work_tree.h. */
#include "work_tree.h"

#include "work_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEAF = 4 }; /* so few are looked at one by one */

static const double SLACK = 0x1p-46; /* far more than a sum is rounded */

static size_t
half_way(size_t low, size_t high)
{
  return low + (high - low) / 2;
}

/* ---- trees -------------------------------------------------------------- */

static void
swap(sg_work_tree *t, size_t i, size_t k)
{
  int32_t number = t->number[i];
  sg_work_box box = t->box[i];

  t->number[i] = t->number[k];
  t->box[i] = t->box[k];
  t->number[k] = number;
  t->box[k] = box;
  if (t->segment) {
    sg_work_grid_segment segment = t->segment[i];

    t->segment[i] = t->segment[k];
    t->segment[k] = segment;
  }
}

/* Where the middle of a box is in a direction. */
static double
middle_of(const sg_work_box *box, const double way[2])
{
  return way[0] * (box->low[0] / 2 + box->high[0] / 2) +
         way[1] * (box->low[1] / 2 + box->high[1] / 2);
}

/* Puts what belongs at `middle`, by the middles of boxes, there, what is less
 * before and what is more behind it. */
static void
select_middle(sg_work_tree *t, size_t low, size_t high, size_t middle,
              const double way[2])
{
  while (high - low > 1) {
    swap(t, low, low / 2 + high / 2);
    double pivot = middle_of(&t->box[low], way);
    size_t i = low, k = high;

    for (;;) { /* Hoare: equal ones go to both sides */
      do {
        k--;
      } while (middle_of(&t->box[k], way) > pivot);
      while (i < k && (i == low || middle_of(&t->box[i], way) < pivot)) {
        i++;
      }
      if (i >= k) {
        break;
      }
      swap(t, i, k);
    }
    swap(t, low, k);
    if (k == middle) {
      return;
    }
    if (k < middle) {
      low = k + 1;
    } else {
      high = k;
    }
  }
}

void
sg_work_box_join(sg_work_box *box, const sg_work_box *other)
{
  for (int k = 0; k < 2; k++) {
    box->low[k] = other->low[k] < box->low[k] ? other->low[k] : box->low[k];
    box->high[k] =
        other->high[k] > box->high[k] ? other->high[k] : box->high[k];
    box->first[k] =
        box->first[k] < other->first[k] ? box->first[k] : other->first[k];
    box->last[k] =
        box->last[k] > other->last[k] ? box->last[k] : other->last[k];
  }
}

/* ---- slabs -------------------------------------------------------------- */

enum {
  CORNERS = 4,
  SAMPLE = 64 /* so many of a part tell where it lies */
};

/* The ends of a segment, or the corners of a box; returns how many. */
static int
corners_of(const sg_work_tree *t, size_t i, double out[CORNERS][2])
{
  const sg_work_box *box = &t->box[i];

  if (t->number[i] > 0) {
    memcpy(out[0], t->segment[i].from, sizeof out[0]);
    memcpy(out[1], t->segment[i].to, sizeof out[1]);
    return 2;
  }
  for (int k = 0; k < CORNERS; k++) {
    out[k][0] = k & 1 ? box->high[0] : box->low[0];
    out[k][1] = k & 2 ? box->high[1] : box->low[1];
  }
  return CORNERS;
}

static void
place_in(const double along[2], const double at[2], double out[2])
{
  out[0] = along[0] * at[0] + along[1] * at[1];
  out[1] = along[0] * at[1] - along[1] * at[0];
}

/* The way that halves a part best: the two halves are smaller, the longer what
 * is in them is across it, and the farther apart their middles are. */
static void
choose_way(const sg_work_slab *slab, const double mean[2],
           const double spread[2], double way[2])
{
  double first = (spread[0] / 2 + mean[0]) * (spread[1] + mean[1]);
  double second = (spread[0] + mean[0]) * (spread[1] / 2 + mean[1]);

  if (first <= second) {
    memcpy(way, slab->along, sizeof slab->along);
  } else {
    way[0] = -slab->along[1];
    way[1] = slab->along[0];
  }
}

static void
widen(double value, double *low, double *high)
{
  *low = value < *low ? value : *low; /* fmin() is a call */
  *high = value > *high ? value : *high;
}

/* The way in which items low..high-1 are to be halved, by a sample of them. */
static void
find_way(const sg_work_tree *t, size_t low, size_t high,
         const sg_work_slab *slab, double way[2])
{
  double mean[2] = {0, 0}, first[2] = {INFINITY, INFINITY},
         last[2] = {-INFINITY, -INFINITY};
  size_t step = (high - low) / SAMPLE + 1, n = 0;

  for (size_t i = low; i < high; i += step, n++) {
    const sg_work_grid_segment *of = &t->segment[i];
    double from[2], to[2];

    place_in(slab->along, of->from, from);
    place_in(slab->along, of->to, to);
    for (int k = 0; k < 2; k++) {
      mean[k] += fabs(to[k] - from[k]);
      widen(from[k] / 2 + to[k] / 2, &first[k], &last[k]);
    }
  }
  for (int k = 0; k < 2; k++) {
    mean[k] /= (double)n;
    last[k] -= first[k];
  }
  choose_way(slab, mean, last, way);
}

/* The slab of items low..high-1. Its frame is that of a sample of them. */
static void
find_slab(const sg_work_tree *t, size_t low, size_t high, sg_work_slab *out)
{
  double far = 0, none = 0;

  sg_work_main_direction(t->segment + low, high - low,
                         (high - low) / SAMPLE + 1, out->along);
  for (int k = 0; k < 2; k++) {
    out->low[k] = INFINITY;
    out->high[k] = -INFINITY;
  }
  for (size_t i = low; i < high; i++) {
    double corner[CORNERS][2], at[2];
    int n = corners_of(t, i, corner);

    for (int c = 0; c < n; c++) {
      place_in(out->along, corner[c], at);
      widen(fabs(corner[c][0]) + fabs(corner[c][1]), &none, &far);
      widen(at[0], &out->low[0], &out->high[0]);
      widen(at[1], &out->low[1], &out->high[1]);
    }
  }
  for (int k = 0; k < 2; k++) {
    out->low[k] -= SLACK * far;
    out->high[k] += SLACK * far;
  }
}

/* How far a slab reaches to the left of a-b, times its length. */
static double
reach_left(const double a[2], const double b[2], const sg_work_slab *slab,
           double *slack)
{
  double half[2], middle[2], way[2];
  const double line[2] = {b[0] - a[0], b[1] - a[1]};

  for (int k = 0; k < 2; k++) {
    half[k] = slab->high[k] / 2 - slab->low[k] / 2;
    middle[k] = slab->high[k] / 2 + slab->low[k] / 2;
  }
  place_in(slab->along, line, way);
  double x = slab->along[0] * middle[0] - slab->along[1] * middle[1] - a[0];
  double y = slab->along[1] * middle[0] + slab->along[0] * middle[1] - a[1];
  double far = fabs(a[0]) + fabs(a[1]);

  *slack = SLACK * (far + fabs(b[0]) + fabs(b[1])) *
           (2 * far + fabs(x) + fabs(y) + half[0] + half[1]);
  return line[0] * y - line[1] * x + half[0] * fabs(way[1]) +
         half[1] * fabs(way[0]);
}

bool
sg_work_slab_right_of(const double a[2], const double b[2],
                      const sg_work_slab *slab)
{
  double slack, left = reach_left(a, b, slab, &slack);

  return left < -slack;
}

bool
sg_work_slab_apart(const sg_work_corners *t, const sg_work_slab *slab)
{
  bool before[2] = {true, true}, after[2] = {true, true};

  for (int i = 0; i < 3; i++) {
    const double *a = t->at[i];
    double at[2], slack = SLACK * (fabs(a[0]) + fabs(a[1]));

    if (sg_work_slab_right_of(a, t->at[(i + 1) % 3], slab)) {
      return true;
    }
    place_in(slab->along, a, at);
    for (int k = 0; k < 2; k++) {
      before[k] = before[k] && at[k] < slab->low[k] - slack;
      after[k] = after[k] && at[k] > slab->high[k] + slack;
    }
  }
  return before[0] || before[1] || after[0] || after[1];
}

/* ---- boxes -------------------------------------------------------------- */

bool
sg_work_right_of(const double a[2], const double b[2], const sg_work_box *box)
{
  double x = b[0] - a[0], y = b[1] - a[1];
  double cx = y > 0 ? box->low[0] : box->high[0];
  double cy = x > 0 ? box->high[1] : box->low[1];
  double slack = SLACK * ((fabs(a[0]) + fabs(b[0])) * (fabs(cy) + fabs(a[1])) +
                          (fabs(a[1]) + fabs(b[1])) * (fabs(cx) + fabs(a[0])));

  return x * (cy - a[1]) - y * (cx - a[0]) < -slack;
}

bool
sg_work_box_apart(const sg_work_corners *t, const sg_work_box *box)
{
  for (int k = 0; k < 2; k++) {
    if (box->high[k] < t->low[k] || box->low[k] > t->high[k]) {
      return true;
    }
  }
  for (int i = 0; i < 3; i++) {
    if (sg_work_right_of(t->at[i], t->at[(i + 1) % 3], box)) {
      return true;
    }
  }
  return false;
}

/* ---- making one --------------------------------------------------------- */

static void
grow(sg_work_tree *t, size_t low, size_t high)
{
  size_t middle = half_way(low, high);
  sg_work_box all = t->box[low];
  double way[2];

  for (size_t i = low + 1; i < high; i++) {
    sg_work_box_join(&all, &t->box[i]);
  }
  t->part[middle] = all;
  way[0] = all.high[1] - all.low[1] > all.high[0] - all.low[0] ? 0 : 1;
  way[1] = 1 - way[0];
  if (t->segment) {
    find_slab(t, low, high, &t->slab[middle]);
    find_way(t, low, high, &t->slab[middle], way);
  }
  if (high - low > LEAF) {
    if (!t->ordered) {
      select_middle(t, low, high, middle, way);
    }
    grow(t, low, middle);
    /* The part at the middle is that of the whole: the box of the half that
     * begins there stands at the middle of that half. */
    grow(t, middle, high);
  }
}

bool
sg_work_tree_open(sg_work_tree *tree, int32_t *number, sg_work_box *box,
                  sg_work_grid_segment *segment, size_t n, bool ordered)
{
  *tree = (sg_work_tree){.n = n,
                         .ordered = ordered,
                         .number = number,
                         .box = box,
                         .segment = segment};
  tree->part = malloc((n + 1) * sizeof *tree->part);
  tree->slab = segment ? malloc((n + 1) * sizeof *tree->slab) : NULL;
  if (!tree->part || (segment && !tree->slab)) {
    return false;
  }
  if (n > 0) {
    grow(tree, 0, n);
  }
  return true;
}

void
sg_work_tree_close(sg_work_tree *tree)
{
  free(tree->number);
  free(tree->box);
  free(tree->segment);
  free(tree->part);
  free(tree->slab);
  *tree = (sg_work_tree){0};
}

static bool
is_second_nearer(const sg_work_tree_walk *walk, size_t low, size_t middle,
                 size_t high)
{
  const sg_work_box *part = walk->tree->part;

  return walk->far && walk->far(walk->data, &part[half_way(middle, high)]) <
                          walk->far(walk->data, &part[half_way(low, middle)]);
}

static int32_t
go(const sg_work_tree_walk *walk, size_t low, size_t high)
{
  const sg_work_tree *t = walk->tree;
  size_t middle = half_way(low, high);

  if (walk->skips(walk->data, &t->part[middle]) ||
      (t->slab && walk->skips_slab &&
       walk->skips_slab(walk->data, &t->slab[middle])) ||
      (walk->passes &&
       walk->passes(walk->data, t->number[low], t->number[high - 1]))) {
    return walk->none;
  }
  if (high - low > LEAF) {
    bool second = is_second_nearer(walk, low, middle, high);
    int32_t found = second ? go(walk, middle, high) : go(walk, low, middle);

    return found != walk->none ? found
           : second            ? go(walk, low, middle)
                               : go(walk, middle, high);
  }
  for (size_t i = low; i < high; i++) {
    if (!walk->skips(walk->data, &t->box[i]) &&
        walk->ends(walk->data, t->number[i])) {
      return t->number[i];
    }
  }
  return walk->none;
}

int32_t
sg_work_tree_go(const sg_work_tree_walk *walk)
{
  return walk->tree->n > 0 ? go(walk, 0, walk->tree->n) : walk->none;
}
