/* walk.c -- what is seen: the first group of slices after which a root is
 * there; where that is see-through, also the groups behind it at which a root
 * begins or ends. The rules are seen_at/4 and seen_layers/4 of
 * rules/shading/seen.pl. */
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

/* The order of owners: the first root; then what makes it begin (or end) before
 * what does not; then the first leaf, the first face. */
static bool
is_before(const sg_shading_work *w, const sg_active *p, const sg_active *q,
          bool begins)
{
  const sg_shading_leaf *a = leaf_of(w, p), *b = leaf_of(w, q);

  if (a->root != b->root) {
    return a->root < b->root;
  }
  int way = begins ? 1 : -1;
  bool makes = p->slice->sense * a->sign * way > 0;
  bool made = q->slice->sense * b->sign * way > 0;

  if (makes != made) {
    return makes;
  }
  return a->number != b->number ? a->number < b->number
                                : p->slice->face < q->slice->face;
}

/* Of a group the slice that is seen of `root`, which begins or ends there, or,
 * less than 0, of any root that is there. */
static size_t
owner(const sg_shading_work *w, const sg_active *active, size_t from, size_t to,
      int32_t root, bool begins)
{
  size_t best = to;

  for (size_t i = from; i < to; i++) {
    bool may = root < 0 ? root_holds(w, &active[i])
                        : leaf_of(w, &active[i])->root == root;
    if (may &&
        (best == to || is_before(w, &active[i], &active[best], begins))) {
      best = i;
    }
  }
  return best;
}

static bool
add_layer(sg_shading_work *w, size_t slice, uint32_t part)
{
  if (part > 0 && !SG_PUSH(w->layer, ((sg_layer){slice, part}))) {
    w->failed = true;
    return false;
  }
  return true;
}

/* ---- where all is opaque ---- */

static bool
see_first(sg_shading_work *w, const sg_active *active, size_t from, size_t to,
          uint32_t *left)
{
  if (!w->expression.node[0].holds) {
    return true;
  }
  *left = 0;
  return add_layer(w, owner(w, active, from, to, -1, true), SG_OPAQUE);
}

/* ---- where it is not ---- */

/* The first root, behind `after`, that this group makes begin, or end; -1:
 * none. */
static int32_t
next_root(const sg_shading_work *w, const sg_active *active, size_t from,
          size_t to, int32_t after, bool begins)
{
  int32_t next = -1;

  for (size_t i = from; i < to; i++) {
    int32_t root = leaf_of(w, &active[i])->root;
    if (root > after && (next < 0 || root < next) &&
        root_holds(w, &active[i]) == begins && w->held[root] != begins) {
      next = root;
    }
  }
  return next;
}

static bool
see_one(sg_shading_work *w, const sg_active *active, size_t slice,
        uint32_t *left)
{
  const sg_opacities *o = w->opacities;
  uint32_t opacity =
      o->opacity[sg_face_number(&o->numbers, leaf_of(w, &active[slice])->number,
                                active[slice].slice->face)];
  uint32_t part =
      (uint32_t)(((uint64_t)*left * opacity + SG_OPAQUE / 2) / SG_OPAQUE);

  *left -= part;
  return add_layer(w, slice, part);
}

/* What ends is nearer than what begins. */
static bool
see_all(sg_shading_work *w, const sg_active *active, size_t from, size_t to,
        uint32_t *left)
{
  for (int begins = 0; begins < 2; begins++) {
    for (int32_t root = -1; *left > 0;) {
      root = next_root(w, active, from, to, root, begins == 1);
      if (root < 0) {
        break;
      }
      if (!see_one(w, active, owner(w, active, from, to, root, begins == 1),
                   left)) {
        return false;
      }
    }
  }
  for (size_t i = from; i < to; i++) {
    w->held[leaf_of(w, &active[i])->root] = root_holds(w, &active[i]);
  }
  return true;
}

/* ---- all ---- */

static void
turn_back(sg_shading_work *w, const sg_active *active, size_t to)
{
  for (size_t i = 0; i < to; i++) {
    const sg_shading_leaf *leaf = leaf_of(w, &active[i]);

    w->held[leaf->root] = false;
    if (w->expression.node[leaf->node].holds) {
      toggle(w, &active[i]);
    }
  }
}

bool
sg_walk_slices(sg_shading_work *w, const sg_active *active, size_t n,
               size_t *last)
{
  double tolerance = w->scene->frame.tolerance;
  uint32_t left = SG_OPAQUE;
  size_t to = 0;
  bool good = true;

  w->layer.n = 0;
  while (good && to < n && left > 0) {
    size_t from = to;

    while (to < n && active[to].middle - active[from].middle <= tolerance) {
      toggle(w, &active[to++]);
    }
    good = w->opacities ? see_all(w, active, from, to, &left)
                        : see_first(w, active, from, to, &left);
  }
  *last = left == 0 ? to - 1 : n;
  turn_back(w, active, to);
  return good;
}
