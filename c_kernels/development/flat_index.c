/* flat_index.c -- see flat_index.h. */
#include "flat_index.h"
#include "engine/list.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  BUCKET = SG_FLAT_QUARTERS, /* items of a leaf */
  PATIENCE = 16, /* items found for nothing, before outlines are asked for */
  OFTEN = 16,    /* times that an outline is asked for, before it is made */
  AT_ONCE = 4096 /* outlines made for one question */
};

/* The smallest cells are this part of the size of items, or less. */
#define SMALLEST 0x1p-40

/* ---- boxes -------------------------------------------------------------- */

sg_flat_box
sg_flat_box_round(const double (*point)[2], size_t n)
{
  sg_flat_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

  for (size_t i = 0; i < n; i++) {
    for (int k = 0; k < 2; k++) {
      double x = point[i][k];
      box.low[k] = x < box.low[k] ? x : box.low[k];
      box.high[k] = x > box.high[k] ? x : box.high[k];
    }
  }
  return box;
}

static void
enlarge(sg_flat_box *box, const sg_flat_box *by)
{
  for (int k = 0; k < 2; k++) {
    box->low[k] = by->low[k] < box->low[k] ? by->low[k] : box->low[k];
    box->high[k] = by->high[k] > box->high[k] ? by->high[k] : box->high[k];
  }
}

/* ---- the stock ---------------------------------------------------------- */

bool
sg_flat_stock_make(size_t room, double size, sg_flat_stock *out)
{
  *out = (sg_flat_stock){.least = size > 0 ? size * SMALLEST : 1,
                         .free_node = SG_NO_ITEM,
                         .free_outline = SG_NO_ITEM};
  return sg_flat_stock_reserve(out, room + 1);
}

void
sg_flat_stock_clear(sg_flat_stock *stock)
{
  free(stock->box);
  free(stock->node);
  free(stock->outline);
  *stock = (sg_flat_stock){0};
}

bool
sg_flat_stock_reserve(sg_flat_stock *stock, size_t room)
{
  return sg_list_need(&stock->box, room, &stock->room, sizeof *stock->box);
}

/* One that was given back, or another one; SG_NO_ITEM: no memory. */
static uint32_t
new_node(sg_flat_stock *stock)
{
  uint32_t n = stock->free_node;

  if (n != SG_NO_ITEM) {
    stock->free_node = stock->node[n].next;
  } else {
    if (!sg_list_grow(&stock->node, stock->nodes, &stock->node_room,
                      sizeof *stock->node)) {
      return SG_NO_ITEM;
    }
    n = (uint32_t)stock->nodes++;
  }
  stock->node[n] =
      (sg_flat_node){.box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}},
                     .next = SG_NO_ITEM,
                     .outline = SG_NO_ITEM,
                     .leaf = true};
  memset(stock->node[n].below, 0xff, sizeof stock->node[n].below);
  return n;
}

static uint32_t
new_outline(sg_flat_stock *stock)
{
  uint32_t n = stock->free_outline;

  if (n != SG_NO_ITEM) {
    stock->free_outline = (uint32_t)stock->outline[n].corners;
    return n;
  }
  if (!sg_list_grow(&stock->outline, stock->outlines, &stock->outline_room,
                    sizeof *stock->outline)) {
    return SG_NO_ITEM;
  }
  return (uint32_t)stock->outlines++;
}

static void
free_node(sg_flat_stock *stock, uint32_t n)
{
  sg_flat_node *node = &stock->node[n];

  if (node->outline != SG_NO_ITEM) {
    stock->outline[node->outline].corners = stock->free_outline;
    stock->free_outline = node->outline;
  }
  node->next = stock->free_node;
  stock->free_node = n;
}

/* A node and all below it are free again. */
static void
free_nodes(sg_flat_stock *stock, uint32_t n)
{
  for (int k = 0; k < SG_FLAT_QUARTERS && !stock->node[n].leaf; k++) {
    if (stock->node[n].below[k] != SG_NO_ITEM) {
      free_nodes(stock, stock->node[n].below[k]);
    }
  }
  while (n != SG_NO_ITEM) {
    uint32_t next = stock->node[n].leaf ? stock->node[n].next : SG_NO_ITEM;
    free_node(stock, n);
    n = next;
  }
}

void
sg_flat_index_clear(sg_flat_index *index, sg_flat_stock *stock)
{
  if (index->used) {
    free_nodes(stock, index->root);
  }
  *index = (sg_flat_index){0};
}

/* ---- adding ------------------------------------------------------------- */

static void
middle_of(const sg_flat_box *box, double out[2])
{
  out[0] = box->low[0] + (box->high[0] - box->low[0]) / 2;
  out[1] = box->low[1] + (box->high[1] - box->low[1]) / 2;
}

/* The first cell has room for the first item, and for some like it. */
static bool
plant(sg_flat_index *index, sg_flat_stock *stock, const sg_flat_box *box)
{
  double size = fmax(box->high[0] - box->low[0], box->high[1] - box->low[1]);
  double middle[2];

  middle_of(box, middle);
  index->root = new_node(stock);
  index->used = index->root != SG_NO_ITEM;
  index->size = 8 * fmax(size, stock->least);
  for (int k = 0; k < 2; k++) {
    index->low[k] = middle[k] - index->size / 2;
  }
  return index->used;
}

/* The root becomes a quarter of one that reaches farther towards a place. */
static bool
grow(sg_flat_index *index, sg_flat_stock *stock, const double to[2])
{
  uint32_t root = new_node(stock);
  int quarter = 0;

  if (root == SG_NO_ITEM) {
    return false;
  }
  for (int k = 0; k < 2; k++) {
    if (to[k] < index->low[k]) {
      index->low[k] -= index->size;
      quarter |= 1 << k;
    }
  }
  index->size *= 2;
  stock->node[root].leaf = false;
  stock->node[root].box = stock->node[index->root].box;
  stock->node[root].below[quarter] = index->root;
  index->root = root;
  return true;
}

static bool
holds(const sg_flat_index *index, const double at[2])
{
  for (int k = 0; k < 2; k++) {
    if (!(at[k] >= index->low[k] && at[k] <= index->low[k] + index->size)) {
      return false;
    }
  }
  return true;
}

/* A cell on the way down. */
typedef struct cell {
  double low[2], size;
} cell;

static int
quarter_of(const cell *c, const double at[2])
{
  return (at[0] >= c->low[0] + c->size / 2) | (at[1] >= c->low[1] + c->size / 2)
                                                  << 1;
}

static void
go_to_quarter(cell *c, int quarter)
{
  c->size /= 2;
  c->low[0] += quarter & 1 ? c->size : 0;
  c->low[1] += quarter & 2 ? c->size : 0;
}

static void
put(sg_flat_stock *stock, uint32_t leaf, uint32_t item)
{
  sg_flat_node *node = &stock->node[leaf];

  enlarge(&node->box, &stock->box[item]);
  node->below[node->items++] = item;
  node->stale = true;
}

/* The quarter of a node, a new leaf if there is none; SG_NO_ITEM: no memory. */
static uint32_t
quarter_node(sg_flat_stock *stock, uint32_t n, int quarter)
{
  if (stock->node[n].below[quarter] == SG_NO_ITEM) {
    uint32_t leaf = new_node(stock);
    stock->node[n].below[quarter] = leaf;
  }
  return stock->node[n].below[quarter];
}

/* A full leaf becomes a node, its items go to its quarters. */
static bool
part(sg_flat_stock *stock, uint32_t n, const cell *c)
{
  uint32_t item[BUCKET];
  double at[2];

  memcpy(item, stock->node[n].below, sizeof item);
  memset(stock->node[n].below, 0xff, sizeof item);
  stock->node[n].leaf = false;
  stock->node[n].items = 0;
  for (int k = 0; k < BUCKET; k++) {
    middle_of(&stock->box[item[k]], at);
    uint32_t quarter = quarter_node(stock, n, quarter_of(c, at));
    if (quarter == SG_NO_ITEM) {
      return false;
    }
    put(stock, quarter, item[k]);
  }
  return true;
}

/* More of a leaf that is full and too small to be parted: what it has goes to a
 * node after it. */
static bool
lengthen(sg_flat_stock *stock, uint32_t n)
{
  uint32_t more = new_node(stock);

  if (more == SG_NO_ITEM) {
    return false;
  }
  sg_flat_node *leaf = &stock->node[n], *after = &stock->node[more];

  memcpy(after->below, leaf->below, sizeof after->below);
  after->items = leaf->items;
  after->next = leaf->next;
  leaf->next = more;
  leaf->items = 0;
  return true;
}

bool
sg_flat_index_add(sg_flat_index *index, sg_flat_stock *stock, uint32_t item)
{
  const sg_flat_box *box = &stock->box[item];
  double at[2];

  middle_of(box, at);
  if (!index->used && !plant(index, stock, box)) {
    return false;
  }
  while (!holds(index, at) && index->size < INFINITY) {
    if (!grow(index, stock, at)) {
      return false;
    }
  }
  cell c = {{index->low[0], index->low[1]}, index->size};
  uint32_t n = index->root;

  for (;;) {
    sg_flat_node *node = &stock->node[n];
    if (node->leaf && node->items == BUCKET) {
      bool parts = c.size > stock->least && isfinite(c.size);
      if (!(parts ? part(stock, n, &c) : lengthen(stock, n))) {
        return false;
      }
      node = &stock->node[n];
    }
    if (node->leaf) {
      put(stock, n, item);
      return true;
    }
    enlarge(&node->box, box);
    node->stale = true;
    int quarter = quarter_of(&c, at);
    n = quarter_node(stock, n, quarter);
    if (n == SG_NO_ITEM) {
      return false;
    }
    go_to_quarter(&c, quarter);
  }
}

/* ---- outlines ----------------------------------------------------------- */

/* A question under way. */
typedef struct search {
  sg_flat_stock *stock;
  const sg_flat_question *question;
  sg_flat_visit *visit;
  void *data;
  bool shaped;   /* outlines may be asked for */
  unsigned vain; /* items that were not what was looked for */
  int left;      /* outlines that may be made */
} search;

static bool
has_outline(const sg_flat_stock *stock, uint32_t n)
{
  return stock->node[n].outline != SG_NO_ITEM && !stock->node[n].stale;
}

static bool make_outline(search *s, uint32_t n);

/* The corners of all that lies in a leaf; 0: too many. */
static size_t
corners_of_leaf(const sg_flat_question *q, const sg_flat_node *leaf,
                double (*out)[2])
{
  size_t corners = 0;

  for (unsigned k = 0; k < leaf->items; k++) {
    corners += q->corners_of(q->items, leaf->below[k], out + corners);
  }
  return leaf->next == SG_NO_ITEM ? corners : 0;
}

/* The corners of the outlines of the quarters; 0: one has none. */
static size_t
corners_of_quarters(search *s, uint32_t n, double (*out)[2])
{
  const sg_flat_stock *stock = s->stock;
  size_t corners = 0;

  for (int k = 0; k < SG_FLAT_QUARTERS; k++) {
    uint32_t quarter = stock->node[n].below[k];
    if (quarter == SG_NO_ITEM) {
      continue;
    }
    if (!has_outline(stock, quarter) && !make_outline(s, quarter)) {
      return 0;
    }
    const sg_flat_outline *o = &stock->outline[stock->node[quarter].outline];
    memcpy(out + corners, o->corner, o->corners * sizeof *out);
    corners += o->corners;
  }
  return corners;
}

/* False: there is none. */
static bool
make_outline(search *s, uint32_t n)
{
  double point[SG_CONVEX_MOST][2], hull[SG_CONVEX_MOST + 1][2];
  sg_flat_node *node = &s->stock->node[n];
  size_t corners = 0;

  if (--s->left > 0) {
    corners = node->leaf ? corners_of_leaf(s->question, node, point)
                         : corners_of_quarters(s, n, point);
  }
  corners = sg_convex_outline(hull, sg_convex_hull(point, corners, hull));
  if (corners > 0 && node->outline == SG_NO_ITEM) {
    node->outline = new_outline(s->stock);
  }
  if (corners == 0 || node->outline == SG_NO_ITEM) {
    return false;
  }
  sg_flat_outline *out = &s->stock->outline[node->outline];

  out->corners = corners;
  memcpy(out->corner, hull, corners * sizeof *hull);
  node->stale = false;
  return true;
}

/* ---- asking ------------------------------------------------------------- */

/* Whether the outline of a node tells that nothing below it overlaps. Outlines
 * are rounded, depths are not: half of it leaves enough. */
static bool
is_outside(search *s, uint32_t n)
{
  const sg_flat_question *q = s->question;
  sg_flat_node *node = &s->stock->node[n];

  if (!has_outline(s->stock, n)) {
    if (++node->asked < OFTEN) {
      return false;
    }
    node->asked = 0;
    if (!make_outline(s, n)) {
      return false;
    }
  }
  const sg_flat_outline *o = &s->stock->outline[node->outline];

  return !sg_convex_overlap(q->corner, q->corners,
                            (const double(*)[2])o->corner, o->corners,
                            q->depth / 2);
}

static bool
find_in_leaf(search *s, uint32_t n)
{
  for (; n != SG_NO_ITEM; n = s->stock->node[n].next) {
    const sg_flat_node *leaf = &s->stock->node[n];
    for (unsigned k = 0; k < leaf->items; k++) {
      const sg_flat_box *box = &s->stock->box[leaf->below[k]];
      if (sg_flat_boxes_meet(box, &s->question->box)) {
        if (s->visit(s->data, leaf->below[k])) {
          return true;
        }
        s->vain++;
      }
    }
  }
  return false;
}

static bool
find_below(search *s, uint32_t n)
{
  const sg_flat_node *node = &s->stock->node[n];

  if (!sg_flat_boxes_meet(&node->box, &s->question->box) ||
      (s->shaped && s->vain >= PATIENCE && is_outside(s, n))) {
    return false;
  }
  if (node->leaf) {
    return find_in_leaf(s, n);
  }
  for (int k = 0; k < SG_FLAT_QUARTERS; k++) {
    if (node->below[k] != SG_NO_ITEM && find_below(s, node->below[k])) {
      return true;
    }
  }
  return false;
}

bool
sg_flat_index_near(const sg_flat_index *index, sg_flat_stock *stock,
                   const sg_flat_question *question, sg_flat_visit *visit,
                   void *data)
{
  search s = {.stock = stock,
              .question = question,
              .visit = visit,
              .data = data,
              .shaped = question->corner != NULL,
              .left = AT_ONCE};

  return index->used && find_below(&s, index->root);
}

/* ---- walking ------------------------------------------------------------ */

typedef struct walk {
  const sg_flat_stock *stock;
  sg_flat_closer *closer;
  sg_flat_visit *visit;
  void *data;
} walk;

static bool
visit_leaf(const walk *w, uint32_t n)
{
  for (; n != SG_NO_ITEM; n = w->stock->node[n].next) {
    const sg_flat_node *leaf = &w->stock->node[n];
    for (unsigned k = 0; k < leaf->items; k++) {
      if (w->visit(w->data, leaf->below[k])) {
        return true;
      }
    }
  }
  return false;
}

static bool
walk_below(const walk *w, uint32_t n)
{
  const sg_flat_node *node = &w->stock->node[n];

  if (node->leaf) {
    return visit_leaf(w, n);
  }
  bool closer = w->closer(w->data, &node->box);

  for (int k = 0; closer && k < SG_FLAT_QUARTERS; k++) {
    if (node->below[k] != SG_NO_ITEM && walk_below(w, node->below[k])) {
      return true;
    }
  }
  return false;
}

bool
sg_flat_index_walk(const sg_flat_index *index, const sg_flat_stock *stock,
                   sg_flat_closer *closer, sg_flat_visit *visit, void *data)
{
  const walk w = {stock, closer, visit, data};

  return index->used && walk_below(&w, index->root);
}
