/* shadow.c -- see shadow.h. */
#include "shadow.h"

#include "engine/search.h"

#include "number/vector.h"
#include "shading_private.h"

#include <math.h>
#include <stdlib.h>

/* ---- the tree ---- */

static void
add_corners(const sg_shading *s, const sg_shading_polygon *p, sg_box *box)
{
  for (uint32_t i = 0; i < p->corners; i++) {
    uint32_t corner = s->corner_of.item[p->corner + i];
    if (corner != SG_NO_CORNER) {
      sg_box_add(box, s->corner.item[corner].at);
    }
  }
}

static sg_box
box_of(const sg_shading *s, const sg_shading_item *item)
{
  sg_box box = sg_box_none();

  if (!item->round) {
    add_corners(s, &s->polygon.item[item->at], &box);
    return box;
  }
  const sg_shading_body *body = &s->body.item[item->at];
  for (bool more = true; more; body++) {
    more = body->more;
    sg_box_add(&box, body->low);
    sg_box_add(&box, body->high);
  }
  return box;
}

/* What is in a root, each once. */
static size_t
list_items(const sg_shading *s, sg_shading_item *item)
{
  size_t n = 0;

  for (uint32_t i = 0; i < s->polygon.n; i++) {
    if (s->leaf.item[s->polygon.item[i].leaf].root >= 0) {
      item[n++] = (sg_shading_item){i, false};
    }
  }
  for (uint32_t i = 0; i < s->body.n; i++) {
    if (s->leaf.item[s->body.item[i].leaf].root >= 0) {
      item[n++] = (sg_shading_item){i, true};
    }
    while (s->body.item[i].more) {
      i++;
    }
  }
  return n;
}

sg_shading_end
sg_shadow_open(const sg_shading *s, const sg_cancel *cancel, sg_shadow *out)
{
  size_t room = s->polygon.n + s->body.n;
  sg_box *box = malloc((room + 1) * sizeof *box);
  bool good = box != NULL;

  *out =
      (sg_shadow){.scene = s, .item = malloc((room + 1) * sizeof *out->item)};
  if (good && out->item) {
    size_t n = list_items(s, out->item);
    for (size_t i = 0; i < n; i++) {
      box[i] = box_of(s, &out->item[i]);
    }
    if (n > 0) {
      out->tree = sg_bvh_open(box, n, cancel);
      good = out->tree != NULL;
    }
  }
  free(box);
  if (good && out->item) {
    return SG_SHADING_GOOD;
  }
  sg_shadow_close(out);
  return sg_cancelled(cancel) ? SG_SHADING_STOPPED : SG_SHADING_NO_MEMORY;
}

void
sg_shadow_close(sg_shadow *shadow)
{
  sg_bvh_close(shadow->tree);
  free(shadow->item);
  *shadow = (sg_shadow){0};
}

double
sg_shadow_scale(const sg_shadow *shadow)
{
  return sg_any_length(shadow->scene->frame.matrix[0]);
}

/* ---- a point ---- */

typedef struct asking {
  const sg_shadow *shadow;
  sg_shading_work *work;
  double p[3]; /* in the picture of the light */
  float at[3]; /* in the frame of the tree */
} asking;

static bool
find_slices(asking *a, const sg_shading_item *item)
{
  const sg_shading *s = a->shadow->scene;
  const sg_shading_body *body = item->round ? &s->body.item[item->at] : NULL;

  a->work->slice.n = 0;
  return body && s->surface.item[body->surface].kind == SG_IS_RING
             ? sg_ring_over(a->work, body, a->p[0], a->p[1])
             : sg_slices_of_item(a->work, item, a->p[1]);
}

/* Adds what a thing has over the point. */
static bool
add_slices(asking *a, const sg_shading_item *item)
{
  sg_shading_work *w = a->work;
  double x = a->p[0] * 256.0;

  if (!find_slices(a, item)) {
    return false;
  }
  for (size_t i = 0; i < w->slice.n; i++) {
    const sg_slice *s = &w->slice.item[i];
    double depth = sg_slice_depth(s, a->p[0]);
    if (s->x1 <= x && x < s->x2 && depth < a->p[2] &&
        !(SG_PUSH(w->over, *s) &&
          SG_PUSH(w->active, ((sg_active){.middle = depth})))) {
      w->failed = true;
      return false;
    }
  }
  return true;
}

/* What is below box i of a level, as far as it is over the point. */
static bool
add_below(asking *a, unsigned level, size_t i)
{
  const sg_bvh *t = a->shadow->tree;
  const sg_box4 *four = &t->level[level][i / SG_BVH_WIDTH];
  size_t k = i % SG_BVH_WIDTH;

  if (!(four->lo[0][k] <= a->at[0] && a->at[0] <= four->hi[0][k] &&
        four->lo[1][k] <= a->at[1] && a->at[1] <= four->hi[1][k] &&
        four->lo[2][k] <= a->at[2])) {
    return true;
  }
  if (level == 0) {
    return add_slices(a, &a->shadow->item[t->item[i]]);
  }
  size_t end = (i + 1) * SG_BVH_WIDTH;
  end = end < t->count[level - 1] ? end : t->count[level - 1];
  for (size_t j = i * SG_BVH_WIDTH; j < end; j++) {
    if (!add_below(a, level - 1, j)) {
      return false;
    }
  }
  return true;
}

/* In the order of depth, each with its slice. */
static void
order(sg_shading_work *w)
{
  for (size_t i = 0; i < w->active.n; i++) {
    w->active.item[i].slice = &w->over.item[i];
  }
  SG_SORT_FEW(sg_active, w->active.item, w->active.n, x->middle > y->middle);
}

bool
sg_shadow_part(const sg_shadow *shadow, sg_shading_work *w, const double p[3],
               uint32_t *part)
{
  const sg_shading_frame *f = &shadow->scene->frame;
  asking a = {.shadow = shadow, .work = w};
  const sg_bvh *t = shadow->tree;
  size_t last;

  *part = SG_OPAQUE;
  if (!t || t->levels == 0) {
    return true;
  }
  for (int i = 0; i < 3; i++) {
    const double *m = f->matrix[i];
    a.p[i] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
    a.at[i] = (float)((a.p[i] - t->origin[i]) / t->unit);
  }
  w->over.n = 0;
  w->active.n = 0;
  if (!add_below(&a, t->levels - 1, 0)) {
    return false;
  }
  if (w->active.n > 0) {
    order(w);
    if (!sg_walk_slices(w, w->active.item, w->active.n, &last)) {
      return false;
    }
    for (size_t i = 0; i < w->layer.n; i++) {
      *part -= w->layer.item[i].part;
    }
  }
  return true;
}
