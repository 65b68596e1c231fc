/* sweep.c -- the spans of a scan line, from left to right. Ends of slices cut
 * the line; between two of them the slices are in order of depth in the middle,
 * and where two may change their order as far as it matters, that is cut again.
 */
#include "shading_private.h"

#include "engine/search.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

sg_shading_work *
sg_shading_work_open(const sg_shading *scene, const sg_opacities *opacities)
{
  sg_shading_work *w = calloc(1, sizeof *w);
  const sg_expression *e = &scene->expression;

  if (w) {
    w->scene = scene;
    w->opacities = opacities;
    w->expression = *e;
    w->expression.leaf = NULL;
    w->expression.node = malloc(e->n * sizeof *e->node);
    w->held = calloc(scene->root.n + 1, sizeof *w->held);
    w->noted = calloc(e->n, sizeof *w->noted);
    w->line = calloc(scene->torus.n + 1, sizeof *w->line);
    if (w->expression.node && w->held && w->noted && w->line) {
      memcpy(w->expression.node, e->node, e->n * sizeof *e->node);
      return w;
    }
    sg_shading_work_close(w);
  }
  return NULL;
}

sg_shading_work *
sg_shading_work_of_light(sg_shading_work *w, unsigned i,
                         const sg_shading *scene)
{
  if (!w->light[i]) {
    w->light[i] = sg_shading_work_open(scene, w->opacities);
    w->failed = w->failed || !w->light[i];
  }
  return w->light[i];
}

bool
sg_shading_work_failed(const sg_shading_work *w)
{
  return w->failed;
}

void
sg_shading_work_close(sg_shading_work *w)
{
  if (w) {
    for (unsigned i = 0; i < SG_SHADOWS; i++) {
      sg_shading_work_close(w->light[i]);
    }
    free(w->slice.item);
    free(w->over.item);
    free(w->start.item);
    free(w->active.item);
    free(w->crossing.item);
    free(w->met.item);
    free(w->layer.item);
    free(w->open.item);
    free(w->held);
    free(w->noted);
    free(w->line);
    sg_expression_clear(&w->expression);
    free(w);
  }
}

/* ---- spans ---- */

static bool
continues(const sg_shading *s, const sg_span *last, const sg_span *next)
{
  return sg_span_goes_on(last, next) &&
         (s->surface.item[last->surface].kind == SG_IS_PLANE ||
          last->sense == next->sense);
}

void
sg_spans_join(sg_spans *line)
{
  size_t n = 0;

  for (size_t i = 0; i < line->n; i++) {
    sg_span span = line->span[i];
    size_t k = span.sheet > 0 ? n : 0;

    while (k > 0 && !sg_span_goes_on(&line->span[k - 1], &span)) {
      k--;
    }
    if (k > 0) {
      line->span[k - 1].x2 = span.x2;
    } else {
      line->span[n++] = span;
    }
  }
  line->n = n;
}

/* Of the layer `depth`, 0 the nearest. */
static bool
add_span(sg_shading_work *w, size_t depth, int32_t x1, int32_t x2,
         sg_spans *out)
{
  const sg_shading *s = w->scene;
  const sg_layer *layer = &w->layer.item[depth];
  const sg_slice *slice = w->active.item[layer->slice].slice;
  const sg_shading_leaf *leaf = &s->leaf.item[slice->leaf];
  sg_span span = {.x1 = x1,
                  .x2 = x2,
                  .root = s->root.item[leaf->root].segment,
                  .leaf = leaf->number,
                  .face = slice->face,
                  .surface = slice->surface,
                  .sense = (int16_t)(slice->arc == 0           ? slice->sense
                                     : sg_slice_is_ring(slice) ? slice->arc
                                                               : -slice->arc),
                  .sheet = slice->sheet,
                  .part = layer->part};

  if (depth < w->open.n) {
    sg_span *last = &out->span[w->open.item[depth]];
    if (continues(s, last, &span)) {
      last->x2 = x2;
      return true;
    }
    w->open.item[depth] = out->n;
  } else if (!SG_PUSH(w->open, out->n)) {
    w->failed = true;
    return false;
  }
  if (!sg_list_grow(&out->span, out->n, &out->room, sizeof *out->span)) {
    w->failed = true;
    return false;
  }
  out->span[out->n++] = span;
  return true;
}

static bool
add_spans(sg_shading_work *w, int32_t x1, int32_t x2, sg_spans *out)
{
  for (size_t i = 0; i < w->layer.n; i++) {
    if (!add_span(w, i, x1, x2, out)) {
      return false;
    }
  }
  return true;
}

/* ---- between two ends ---- */

static void
order(sg_shading_work *w, int32_t x1, int32_t x2)
{
  double left = x1 / 256.0, right = x2 / 256.0, middle = (left + right) / 2.0;
  sg_active *active = w->active.item;

  for (size_t i = 0; i < w->active.n; i++) {
    sg_active *a = &active[i];
    a->left = sg_slice_depth(a->slice, left);
    a->right = sg_slice_depth(a->slice, right);
    a->middle = a->slice->arc == 0 ? (a->left + a->right) / 2.0
                                   : sg_slice_depth(a->slice, middle);
  }
  SG_SORT_FEW(sg_active, active, w->active.n, x->middle > y->middle);
}

/* Whether straight slices are in order all the way. */
static bool
are_apart(const sg_active *a, const sg_active *b, double t)
{
  return a->slice->arc == 0 && b->slice->arc == 0 && b->left - a->left > t &&
         b->right - a->right > t && b->middle - a->middle > t;
}

/* The first place between x1 and x2 where the order may change down to the
 * last slice of the group that is seen; x1: nowhere. */
static int32_t
find_change(const sg_shading_work *w, int32_t x1, int32_t x2, size_t last)
{
  const sg_active *a = w->active.item;
  double t = w->scene->frame.tolerance;
  int32_t first = x1;

  for (size_t i = 1; i < w->active.n; i++) {
    const sg_active *front = i <= last ? &a[i - 1] : &a[last];
    int32_t x = are_apart(front, &a[i], t)
                    ? x1
                    : sg_slices_cross(front, &a[i], x1, x2, t);
    if (x != x1 && (first == x1 || x < first)) {
      first = x;
    }
  }
  return first;
}

static bool
sweep_between(sg_shading_work *w, int32_t x1, int32_t x2, sg_spans *out)
{
  while (x1 < x2) {
    int32_t to = x2;
    size_t last;

    for (;;) {
      order(w, x1, to);
      if (!sg_walk_slices(w, w->active.item, w->active.n, &last)) {
        return false;
      }
      int32_t cut = to - x1 > 1 ? find_change(w, x1, to, last) : x1;
      if (cut == x1) {
        break;
      }
      to = cut;
    }
    if (!add_spans(w, x1, to, out)) {
      return false;
    }
    x1 = to;
  }
  return true;
}

/* ---- ends ---- */

/* So many are sorted by comparing. */
#define FEW_STARTS 512

/* Where slices begin, from left to right; of one place in their order. */
static bool
list_starts(sg_shading_work *w)
{
  w->start.n = 0;
  for (size_t i = 0; i < w->slice.n; i++) {
    if (!SG_PUSH(w->start, (uint64_t)(uint32_t)w->slice.item[i].x1 << 32 | i)) {
      w->failed = true;
      return false;
    }
  }
  if (w->start.n > FEW_STARTS) {
    w->failed = !sg_sort_upper(w->start.item, w->start.n);
    w->start.room = w->start.n;
  } else if (w->start.n > 0) {
    qsort(w->start.item, w->start.n, sizeof *w->start.item, sg_compare_keys);
  }
  return !w->failed;
}

static int32_t
start_at(const sg_shading_work *w, size_t i)
{
  return i < w->start.n ? (int32_t)(w->start.item[i] >> 32) : INT32_MAX;
}

static const sg_slice *
slice_of_start(const sg_shading_work *w, size_t i)
{
  return &w->slice.item[(uint32_t)(w->start.item[i] & UINT32_MAX)];
}

/* Lets go what ends at x, and takes in what begins up to there. In *to the next
 * place where a slice begins or ends. */
static bool
change_active(sg_shading_work *w, int32_t x, size_t *next, int32_t *to)
{
  size_t kept = 0;
  int32_t end = INT32_MAX;

  w->looked += w->active.n;
  for (size_t i = 0; i < w->active.n; i++) {
    int32_t x2 = w->active.item[i].slice->x2;
    if (x2 > x) {
      w->active.item[kept++] = w->active.item[i];
      end = x2 < end ? x2 : end;
    }
  }
  w->active.n = kept;
  for (; start_at(w, *next) <= x; ++*next) {
    const sg_slice *slice = slice_of_start(w, *next);
    if (slice->x2 <= x) {
      continue; /* it was passed over */
    }
    if (!SG_PUSH(w->active, (sg_active){.slice = slice})) {
      w->failed = true;
      return false;
    }
    end = slice->x2 < end ? slice->x2 : end;
  }
  *to = start_at(w, *next) < end ? start_at(w, *next) : end;
  return true;
}

/* ---- where one slice is in front of all others ---- */

static bool
is_behind(const sg_slice *s, const sg_slice *front, int32_t x, double margin)
{
  double at = x / 256.0;

  return sg_slice_depth(s, at) - sg_slice_depth(front, at) > margin;
}

/* Of what is there at x one that is nearest. */
static size_t
nearest(const sg_shading_work *w, int32_t x)
{
  double least = INFINITY;
  size_t best = 0;

  for (size_t i = 0; i < w->active.n; i++) {
    double depth = sg_slice_depth(w->active.item[i].slice, x / 256.0);
    if (depth < least) {
      least = depth;
      best = i;
    }
  }
  return best;
}

/* So far from x on one straight slice, of a leaf that is seen as soon as it is
 * entered, is in front of all that is there or begins: it is seen, whatever
 * else begins or ends behind it. x: not at all. In *front its place. */
static int32_t
front_ends(sg_shading_work *w, int32_t x, size_t next, size_t *front)
{
  double margin = SG_SLICE_MARGIN(w->scene->frame.tolerance);

  *front = nearest(w, x);
  const sg_slice *f = w->active.item[*front].slice;
  int32_t to = f->x2;

  if (w->opacities || w->scene->through || f->arc != 0 ||
      !w->scene->leaf.item[f->leaf].united) {
    return x;
  }
  for (size_t i = 0; i < w->active.n; i++) {
    const sg_slice *s = w->active.item[i].slice;
    if (s != f && (s->arc != 0 || !is_behind(s, f, x, margin) ||
                   !is_behind(s, f, s->x2 < to ? s->x2 : to, margin))) {
      return x;
    }
  }
  for (; start_at(w, next) < to; next++, w->looked++) {
    const sg_slice *s = slice_of_start(w, next);
    if (s->arc != 0 || !is_behind(s, f, s->x1, margin) ||
        !is_behind(s, f, s->x2 < to ? s->x2 : to, margin)) {
      return s->x1;
    }
  }
  return to;
}

/* What is seen from x1 up to where a slice begins or ends, or farther; to
 * there. */
static bool
sweep_on(sg_shading_work *w, int32_t x1, size_t next, int32_t *x2,
         sg_spans *out)
{
  size_t front;
  int32_t to = front_ends(w, x1, next, &front);

  if (to == x1) {
    return sweep_between(w, x1, *x2, out);
  }
  *x2 = to;
  w->layer.n = 0;
  w->failed = w->failed || !SG_PUSH(w->layer, ((sg_layer){front, SG_OPAQUE}));
  return !w->failed && add_spans(w, x1, to, out);
}

static const sg_line_part all_of_it = {INT32_MIN, INT32_MAX, false};

/* Whether something between two ends is of the part. */
static bool
is_wanted(const sg_line_part *part, int32_t x1, int32_t x2)
{
  return part->beyond ? x1 < part->from || x2 > part->to
                      : x1 < part->to && x2 > part->from;
}

/* Looks so many times at each slice before it is asked which of them are
 * hidden. */
enum { CROWD = 16 };

/* What is seen of the slices from left to right. In *crowded whether it was
 * given up, as there are many in one place; null: it is not. */
static bool
sweep_line(sg_shading_work *w, const sg_line_part *part, bool *crowded,
           sg_spans *out)
{
  size_t next = 0;

  out->n = 0;
  w->open.n = 0;
  w->active.n = 0;
  w->looked = 0;
  if (!list_starts(w)) {
    return false;
  }
  for (int32_t x1 = start_at(w, 0), x2; x1 < INT32_MAX; x1 = x2) {
    if (!change_active(w, x1, &next, &x2) ||
        (w->active.n > 0 && is_wanted(part, x1, x2) &&
         !sweep_on(w, x1, next, &x2, out))) {
      return false;
    }
    if (crowded && w->looked > CROWD * w->slice.n) {
      *crowded = true;
      break;
    }
  }
  return true;
}

bool
sg_shading_line_part(const sg_shading *scene, sg_shading_work *w, double y,
                     const sg_line_part *part, sg_spans *out)
{
  bool opaque = !w->opacities && !scene->through, crowded = false;

  w->scene = scene;
  w->searched = 0;
  w->between[0] = part->beyond ? part->from / 256.0 : INFINITY;
  w->between[1] = part->beyond ? part->to / 256.0 : -INFINITY;
  return sg_slices_of_line(w, y) &&
         sweep_line(w, part, opaque ? &crowded : NULL, out) &&
         (!crowded ||
          (sg_drop_hidden_slices(w) && sweep_line(w, part, NULL, out)));
}

bool
sg_shading_line(const sg_shading *scene, sg_shading_work *w, double y,
                sg_spans *out)
{
  return sg_shading_line_part(scene, w, y, &all_of_it, out);
}
