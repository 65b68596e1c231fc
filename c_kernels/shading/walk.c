/* walk.c -- what is seen: the first group of slices after which a root is
 * there. The rule is seen_at/4 of rules/shading/seen.pl. */
#include "shading_private.h"

static const sg_shading_leaf *
leaf_of(const sg_shading_work *w, const sg_active *a)
{
  return &w->scene->leaf.item[a->slice->leaf];
}

static void
toggle(sg_shading_work *w, const sg_active *a)
{
  uint32_t node = leaf_of(w, a)->node;

  sg_expression_set(&w->expression, node, !w->expression.node[node].holds);
}

/* Whether the root of a slice is there now. */
static bool
root_holds(const sg_shading_work *w, const sg_active *a)
{
  uint32_t node = w->scene->root.item[leaf_of(w, a)->root].node;

  return w->expression.node[node].holds;
}

/* The order of owners: the first root; then what makes it true before what
 * does not; then the first leaf, the first face. */
static bool
is_before(const sg_shading_work *w, const sg_active *p, const sg_active *q)
{
  const sg_shading_leaf *a = leaf_of(w, p), *b = leaf_of(w, q);

  if (a->root != b->root) {
    return a->root < b->root;
  }
  bool makes = p->slice->sense * a->sign > 0;
  bool made = q->slice->sense * b->sign > 0;

  if (makes != made) {
    return makes;
  }
  return a->number != b->number ? a->number < b->number
                                : p->slice->face < q->slice->face;
}

static size_t
owner(const sg_shading_work *w, const sg_active *active, size_t from, size_t to)
{
  size_t best = to;

  for (size_t i = from; i < to; i++) {
    if (root_holds(w, &active[i]) &&
        (best == to || is_before(w, &active[i], &active[best]))) {
      best = i;
    }
  }
  return best;
}

size_t
sg_walk_slices(sg_shading_work *w, const sg_active *active, size_t n,
               size_t *last)
{
  double tolerance = w->scene->frame.tolerance;
  size_t seen = n, to = 0;

  while (to < n && seen == n) {
    size_t from = to;

    while (to < n && active[to].middle - active[from].middle <= tolerance) {
      toggle(w, &active[to++]);
    }
    if (w->expression.node[0].holds) {
      seen = owner(w, active, from, to);
    }
  }
  *last = seen < n ? to - 1 : n;
  for (size_t i = 0; i < to; i++) {
    if (w->expression.node[leaf_of(w, &active[i])->node].holds) {
      toggle(w, &active[i]);
    }
  }
  return seen;
}
