/* solid_old_region.c -- the rows of some leaves' faces: see solid_old.h.
 *
 * Layer: kernel. One walk over each relation. The ids that a walk marks tell
 * the next one what is of the region: polygons by the leaves that they come
 * from, edges by polygons, vertices by triangles.
 */
#include "solid_old_private.h"

#include <stdlib.h>
#include <string.h>

/* Bits of an id: it is in the region; something outside has it; there is such a
 * row; a polygon has a plane; it is said where it comes from. */
enum { INSIDE = 1, OUTSIDE = 2, THERE = 4, FLAT = 8, SAID = 16 };

typedef struct narrowing {
  sg_solid_old *old;
  const sg_cancel *cancel;
  int32_t (*item_vertex)(const uint32_t *item);
  uint8_t *leaf;     /* [most_leaf + 1] by segment: 1: one of them */
  int32_t most_leaf; /* of all that faces come from */
  uint8_t *polygon, *edge, *vertex; /* by id: bits */
} narrowing;

/* ---- which leaves ------------------------------------------------------- */

/* Faces that come from a leaf that is one of them, and the leaves that these
 * come from: *more if there were others. */
static sg_old_end
spread(narrowing *w, bool *more)
{
  const sg_solid_old *old = w->old;
  size_t n = sg_old_count(old, SG_OLD_FROM_P);

  *more = false;
  for (uint32_t i = 0; i < n; i++) {
    int32_t p = sg_old_int(old, SG_OLD_FROM_P, 1, i);
    if (sg_cancel_every(w->cancel, i)) {
      return SG_OLD_FAILED;
    }
    if (p > old->polygon.most) {
      return SG_OLD_UNFIT;
    }
    if (w->leaf[sg_old_int(old, SG_OLD_FROM_P, 2, i)]) {
      w->polygon[p] = INSIDE;
    }
  }
  for (uint32_t i = 0; i < n; i++) {
    int32_t s = sg_old_int(old, SG_OLD_FROM_P, 2, i);
    if (!w->leaf[s] && w->polygon[sg_old_int(old, SG_OLD_FROM_P, 1, i)]) {
      w->leaf[s] = 1;
      *more = true;
    }
  }
  return SG_OLD_READ;
}

/* The leaves as a list. False: no memory. */
static bool
list_leaves(const narrowing *w, const int32_t *leaf, size_t n)
{
  sg_old_region *out = &w->old->region;
  size_t room = n;

  for (int32_t s = 1; s <= w->most_leaf; s++) {
    room += w->leaf[s];
  }
  out->leaf = malloc((room + 1) * sizeof *out->leaf);
  for (int32_t s = 1; out->leaf && s <= w->most_leaf; s++) {
    if (w->leaf[s]) {
      out->leaf[out->leaves++] = s;
    }
  }
  for (size_t i = 0; out->leaf && i < n; i++) { /* of no face */
    if (leaf[i] > w->most_leaf) {
      out->leaf[out->leaves++] = leaf[i];
    }
  }
  return out->leaf;
}

static sg_old_end
find_leaves(narrowing *w, const int32_t *leaf, size_t n)
{
  sg_old_end end =
      sg_old_find_most(w->old, SG_OLD_FROM_P, 2, w->cancel, &w->most_leaf);
  bool more = true;

  if (end == SG_OLD_READ) {
    w->leaf = calloc((size_t)w->most_leaf + 1, 1);
    end = w->leaf ? SG_OLD_READ : SG_OLD_FAILED;
  }
  for (size_t i = 0; end == SG_OLD_READ && i < n; i++) {
    if (leaf[i] <= w->most_leaf) {
      w->leaf[leaf[i]] = 1;
    }
  }
  while (end == SG_OLD_READ && more) {
    end = spread(w, &more);
  }
  return end == SG_OLD_READ && !list_leaves(w, leaf, n) ? SG_OLD_FAILED : end;
}

/* ---- rows --------------------------------------------------------------- */

/* Leaves the rows that keep() says are of the region. */
static sg_old_end
narrow(narrowing *w, int relation, bool (*keep)(narrowing *w, uint32_t place))
{
  sg_segment_rows *rows = &w->old->rows[relation];
  size_t n = rows->begin[1], left = 0;

  for (uint32_t i = 0; i < n; i++) {
    if (sg_cancel_every(w->cancel, i)) {
      return SG_OLD_FAILED;
    }
    if (keep(w, i)) {
      rows->row[left++] = rows->row[i];
    }
  }
  rows->begin[1] = left;
  return SG_OLD_READ;
}

static bool
keep_p(narrowing *w, uint32_t i)
{
  sg_solid_old *old = w->old;
  int32_t p = sg_old_int(old, SG_OLD_P, 1, i);

  w->polygon[p] |= THERE;
  if (!(w->polygon[p] & INSIDE)) {
    old->polygon.held[p] = 1;
    return false;
  }
  const int32_t *list = sg_old_list(old, SG_OLD_P, 2, i);

  for (int32_t k = 1; k <= list[0]; k++) {
    if (list[k] <= old->edge.most) {
      w->edge[list[k]] = INSIDE;
    }
  }
  return true;
}

static bool
keep_e(narrowing *w, uint32_t i)
{
  int32_t e = sg_old_int(w->old, SG_OLD_E, 1, i);

  w->old->edge.held[e] = !w->edge[e];
  return w->edge[e];
}

/* The row says something of a polygon of the region. */
static bool
is_inside(narrowing *w, int relation, uint32_t i, uint8_t bit)
{
  int32_t p = sg_old_int(w->old, relation, 1, i);

  if (p > w->old->polygon.most) {
    return false;
  }
  w->polygon[p] |= bit;
  return w->polygon[p] & INSIDE;
}

static bool
keep_t(narrowing *w, uint32_t i)
{
  sg_solid_old *old = w->old;
  bool inside = is_inside(w, SG_OLD_T, i, 0);

  for (unsigned k = 3; k < 6; k++) {
    int32_t v = sg_old_int(old, SG_OLD_T, k, i);
    if (v <= old->vertex.most) {
      w->vertex[v] |= inside ? INSIDE : OUTSIDE;
    }
  }
  old->triangle.held[sg_old_int(old, SG_OLD_T, 2, i)] = !inside;
  return inside;
}

static bool
keep_plane(narrowing *w, uint32_t i)
{
  return is_inside(w, SG_OLD_PLANE, i, FLAT);
}

static bool
keep_from_p(narrowing *w, uint32_t i)
{
  return is_inside(w, SG_OLD_FROM_P, i, SAID);
}

static bool
keep_v(narrowing *w, uint32_t i)
{
  sg_solid_old *old = w->old;
  int32_t v = sg_old_int(old, SG_OLD_V, 1, i);
  const double at[3] = {sg_old_float(old, SG_OLD_V, 2, i),
                        sg_old_float(old, SG_OLD_V, 3, i),
                        sg_old_float(old, SG_OLD_V, 4, i)};

  old->vertex.held[v] = w->vertex[v] != INSIDE;
  w->vertex[v] |= THERE;
  sg_box_add(&old->region.whole, at);
  if (w->vertex[v] & OUTSIDE) {
    sg_box_add(&old->region.box, at);
  }
  if (!(w->vertex[v] & INSIDE)) {
    old->region.row[old->region.rows++] = old->rows[SG_OLD_V].row[i];
    return false;
  }
  return true;
}

/* The row says where vertex v comes from, which is of the region. */
static bool
has_vertex_inside(narrowing *w, int32_t v)
{
  if (v <= 0 || v > w->old->vertex.most) {
    return false;
  }
  w->vertex[v] |= SAID;
  return w->vertex[v] & INSIDE;
}

static bool
keep_from_v(narrowing *w, uint32_t i)
{
  return has_vertex_inside(w, sg_old_int(w->old, SG_OLD_FROM_V, 1, i));
}

static bool
keep_origin(narrowing *w, uint32_t i)
{
  return has_vertex_inside(w, w->item_vertex((const uint32_t *)sg_old_list(
                                  w->old, SG_OLD_ORIGIN, 1, i)));
}

/* ---- all of it ---------------------------------------------------------- */

/* Room for the marks of the ids in a column. */
static sg_old_end
open_ids(narrowing *w, int relation, unsigned column, sg_old_ids *ids,
         uint8_t **mark)
{
  sg_old_end end =
      sg_old_find_most(w->old, relation, column, w->cancel, &ids->most);

  if (end != SG_OLD_READ) {
    return end;
  }
  ids->held = calloc((size_t)ids->most + 1, 1);
  if (mark) {
    *mark = calloc((size_t)ids->most + 1, 1);
  }
  return ids->held && (!mark || *mark) ? SG_OLD_READ : SG_OLD_FAILED;
}

static sg_old_end
open_all(narrowing *w)
{
  sg_solid_old *old = w->old;
  size_t vertices = sg_old_count(old, SG_OLD_V);
  sg_old_end end = open_ids(w, SG_OLD_V, 1, &old->vertex, &w->vertex);

  old->region.box = old->region.whole = sg_box_none();
  old->region.row = malloc((vertices + 1) * sizeof *old->region.row);
  if (!old->region.row) {
    return SG_OLD_FAILED;
  }
  end =
      end == SG_OLD_READ ? open_ids(w, SG_OLD_E, 1, &old->edge, &w->edge) : end;
  end = end == SG_OLD_READ
            ? open_ids(w, SG_OLD_P, 1, &old->polygon, &w->polygon)
            : end;
  return end == SG_OLD_READ ? open_ids(w, SG_OLD_T, 2, &old->triangle, NULL)
                            : end;
}

/* What is there has all of these bits. */
static bool
all_have(const uint8_t *mark, int32_t most, uint8_t bits)
{
  for (int32_t id = 1; id <= most; id++) {
    if ((mark[id] & THERE) && (mark[id] & bits) != bits) {
      return false;
    }
  }
  return true;
}

/* Nothing is missing that all of a solid's rows have, be it outside of the
 * region: nobody else would look for it. */
static bool
is_whole(const narrowing *w)
{
  return all_have(w->polygon, w->old->polygon.most, FLAT | SAID) &&
         all_have(w->vertex, w->old->vertex.most, SAID);
}

/* In this order: each walk goes by the marks of those before. */
static sg_old_end
narrow_all(narrowing *w)
{
  static const struct {
    int relation;
    bool (*keep)(narrowing *w, uint32_t place);
  } walk[SG_OLD_RELATIONS] = {
      {SG_OLD_P, keep_p},           {SG_OLD_E, keep_e},
      {SG_OLD_T, keep_t},           {SG_OLD_PLANE, keep_plane},
      {SG_OLD_FROM_P, keep_from_p}, {SG_OLD_V, keep_v},
      {SG_OLD_FROM_V, keep_from_v}, {SG_OLD_ORIGIN, keep_origin}};
  sg_old_end end = SG_OLD_READ;

  for (int k = 0; end == SG_OLD_READ && k < SG_OLD_RELATIONS; k++) {
    end = narrow(w, walk[k].relation, walk[k].keep);
  }
  return end == SG_OLD_READ && !is_whole(w) ? SG_OLD_UNFIT : end;
}

sg_old_end
sg_old_narrow(sg_solid_old *old, const int32_t *leaf, size_t n,
              int32_t (*item_vertex)(const uint32_t *item),
              const sg_cancel *cancel)
{
  narrowing w = {.old = old, .cancel = cancel, .item_vertex = item_vertex};
  sg_old_end end = open_all(&w);

  end = end == SG_OLD_READ ? find_leaves(&w, leaf, n) : end;
  end = end == SG_OLD_READ ? narrow_all(&w) : end;
  free(w.leaf);
  free(w.polygon);
  free(w.edge);
  free(w.vertex);
  return end;
}
