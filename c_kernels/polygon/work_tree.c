/* work_tree.c -- see work_tree.h. */
#include "work_tree.h"

#include "work_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEAF = 4 }; /* so few are looked at one by one */

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
}

static double
middle_of(const sg_work_box *box, int axis)
{
  return box->low[axis] / 2 + box->high[axis] / 2;
}

/* Puts what belongs at `middle`, by the middles of boxes, there, what is less
 * before and what is more behind it. */
static void
select_middle(sg_work_tree *t, size_t low, size_t high, size_t middle, int axis)
{
  while (high - low > 1) {
    swap(t, low, low / 2 + high / 2);
    double pivot = middle_of(&t->box[low], axis);
    size_t i = low, k = high;

    for (;;) { /* Hoare: equal ones go to both sides */
      do {
        k--;
      } while (middle_of(&t->box[k], axis) > pivot);
      while (i < k && (i == low || middle_of(&t->box[i], axis) < pivot)) {
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
    box->low[k] = fmin(box->low[k], other->low[k]);
    box->high[k] = fmax(box->high[k], other->high[k]);
    box->first[k] =
        box->first[k] < other->first[k] ? box->first[k] : other->first[k];
    box->last[k] =
        box->last[k] > other->last[k] ? box->last[k] : other->last[k];
  }
}

static void
grow(sg_work_tree *t, size_t low, size_t high)
{
  size_t middle = half_way(low, high);
  sg_work_box all = t->box[low];

  for (size_t i = low + 1; i < high; i++) {
    sg_work_box_join(&all, &t->box[i]);
  }
  t->part[middle] = all;
  if (high - low > LEAF) {
    int axis = all.high[1] - all.low[1] > all.high[0] - all.low[0];

    if (!t->ordered) {
      select_middle(t, low, high, middle, axis);
    }
    grow(t, low, middle);
    /* The part at the middle is that of the whole: the box of the half that
     * begins there stands at the middle of that half. */
    grow(t, middle, high);
  }
}

bool
sg_work_tree_open(sg_work_tree *tree, int32_t *number, sg_work_box *box,
                  size_t n, bool ordered)
{
  *tree =
      (sg_work_tree){.n = n, .ordered = ordered, .number = number, .box = box};
  tree->part = malloc((n + 1) * sizeof *tree->part);
  if (tree->part && n > 0) {
    grow(tree, 0, n);
  }
  return tree->part != NULL;
}

void
sg_work_tree_close(sg_work_tree *tree)
{
  free(tree->number);
  free(tree->box);
  free(tree->part);
  *tree = (sg_work_tree){0};
}

static int32_t
go(const sg_work_tree_walk *walk, size_t low, size_t high)
{
  const sg_work_tree *t = walk->tree;
  size_t middle = half_way(low, high);

  if (walk->skips(walk->data, &t->part[middle]) ||
      (walk->passes &&
       walk->passes(walk->data, t->number[low], t->number[high - 1]))) {
    return walk->none;
  }
  if (high - low > LEAF) {
    int32_t found = go(walk, low, middle);

    return found != walk->none ? found : go(walk, middle, high);
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
