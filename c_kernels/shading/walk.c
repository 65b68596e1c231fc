/* walk.c -- what is seen: the first group of slices after which a root is
 * there; where that is see-through, also the groups behind it at which a root
 * begins or ends. The rules are seen_at/4 and seen_layers/4 of
 * rules/shading/seen.pl. */
#include "shading_private.h"

#include <string.h>

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

/* In the order of owners, each face once. */
static bool
add_met(sg_shading_work *w, const sg_active *active, size_t slice)
{
  const sg_met_face new = {.leaf = leaf_of(w, &active[slice])->number,
                           .face = active[slice].slice->face,
                           .slice = slice};
  size_t k = w->met.n;

  while (k > 0 && sg_met_compare(&new, &w->met.item[k - 1]) < 0) {
    k--;
  }
  if (k > 0 && sg_met_compare(&new, &w->met.item[k - 1]) == 0) {
    return true;
  }
  if (!SG_PUSH(w->met, new)) {
    return false;
  }
  memmove(&w->met.item[k + 1], &w->met.item[k],
          (w->met.n - 1 - k) * sizeof *w->met.item);
  w->met.item[k] = new;
  return true;
}

static void
toggle_group(sg_shading_work *w, const sg_active *active, size_t from,
             size_t to)
{
  for (size_t i = from; i < to; i++) {
    toggle(w, &active[i]);
  }
}

/* Notes what a leaf and the nodes above it are. */
static void
note_way(sg_shading_work *w, const sg_active *a)
{
  const sg_expression_node *node = w->expression.node;

  for (uint32_t at = leaf_of(w, a)->node; at != 0; at = node[at].parent) {
    w->noted[at] = node[at].holds;
  }
}

/* Whether all from the leaf up to its root was noted the other way. */
static bool
changes_root(const sg_shading_work *w, const sg_active *a)
{
  const sg_expression_node *node = w->expression.node;
  const sg_shading_leaf *leaf = leaf_of(w, a);
  uint32_t root = w->scene->root.item[leaf->root].node, at = leaf->node;

  while (at != root && w->noted[at] != node[at].holds) {
    at = node[at].parent;
  }
  return at == root && w->noted[at] != node[at].holds;
}

/* The faces of a group at which a root begins or ends go to w->met: those of
 * leaves whose change goes up to the root. Where a leaf is entered that is
 * taken away there, its face is none of the root. */
static bool
list_met(sg_shading_work *w, const sg_active *active, size_t from, size_t to,
         int32_t root)
{
  bool good = true;

  w->met.n = 0;
  for (size_t i = from; i < to; i++) {
    if (leaf_of(w, &active[i])->root == root) {
      note_way(w, &active[i]);
    }
  }
  toggle_group(w, active, from, to);
  for (size_t i = from; i < to && good; i++) {
    if (leaf_of(w, &active[i])->root == root && changes_root(w, &active[i])) {
      good = add_met(w, active, i);
    }
  }
  toggle_group(w, active, from, to);
  return good;
}

/* Of a group the slice that is seen of `root`, which begins or ends there. */
static size_t
owner(sg_shading_work *w, const sg_active *active, size_t from, size_t to,
      int32_t root, bool begins)
{
  size_t said = 0;

  if (to - from == 1) {
    return from;
  }
  bool good = list_met(w, active, from, to, root);
  if (good && w->scene->owners && w->met.n > 1) {
    good =
        sg_owner_of(w->scene->owners,
                    &(sg_met_group){.root = w->scene->root.item[root].segment,
                                    .begins = begins,
                                    .face = w->met.item,
                                    .n = w->met.n},
                    &said);
  }
  w->failed = w->failed || !good;
  return w->met.n > 0 ? w->met.item[said].slice : from;
}

/* The first root of a group that is there. */
static int32_t
first_root(const sg_shading_work *w, const sg_active *active, size_t from,
           size_t to)
{
  int32_t first = -1;

  for (size_t i = from; i < to; i++) {
    int32_t root = leaf_of(w, &active[i])->root;
    if ((first < 0 || root < first) && root_holds(w, &active[i])) {
      first = root;
    }
  }
  return first;
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
  int32_t root = first_root(w, active, from, to);
  return add_layer(w, owner(w, active, from, to, root, true), SG_OPAQUE);
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
  uint32_t opacity = !o ? SG_OPAQUE
                        : o->opacity[sg_face_number(
                              &o->numbers, leaf_of(w, &active[slice])->number,
                              active[slice].slice->face)];

  if (w->scene->through) { /* who hides whom is not known yet */
    return add_layer(w, slice, opacity);
  }
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

/* ---- where some roots do not hide others ---- */

/* Each layer goes before those directly before it whose roots do not hide its
 * own; then each has its part of what those before it leave. */
static void
let_through(sg_shading_work *w, const sg_active *active)
{
  size_t roots = w->scene->root.n, kept = 0;
  sg_layer *layer = w->layer.item;
  uint32_t left = SG_OPAQUE;

  for (size_t i = 1; i < w->layer.n; i++) {
    sg_layer own = layer[i];
    int32_t root = leaf_of(w, &active[own.slice])->root;
    size_t k = i;

    for (; k > 0; k--) {
      int32_t front = leaf_of(w, &active[layer[k - 1].slice])->root;
      if (!w->scene->through[(size_t)front * roots + (size_t)root]) {
        break;
      }
      layer[k] = layer[k - 1];
    }
    layer[k] = own;
  }
  for (size_t i = 0; i < w->layer.n; i++) {
    uint32_t part =
        (uint32_t)(((uint64_t)left * layer[i].part + SG_OPAQUE / 2) /
                   SG_OPAQUE);
    left -= part;
    if (part > 0) {
      layer[kept++] = (sg_layer){layer[i].slice, part};
    }
  }
  w->layer.n = kept;
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
    good = w->opacities || w->scene->through
               ? see_all(w, active, from, to, &left)
               : see_first(w, active, from, to, &left);
  }
  if (w->scene->through) {
    let_through(w, active);
  }
  *last = left == 0 ? to - 1 : n;
  turn_back(w, active, to);
  return good;
}
