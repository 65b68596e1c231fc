/* face_edge.c -- see face_edge.h. */
#include "face_edge.h"

#include "engine/search.h"
#include "number/vector.h"
#include "shading_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DOT = 256, HALF = DOT / 2 };

/* Facets of a mesh whose normals have so much in common go on in each other:
 * the cosine of 20 degrees. */
#define GOES_ON 0.9396926207859084

/* What is as much deeper, in dots, is behind. */
#define BEHIND 1.0

enum { LINES = 3 * SG_COVER_LINES + 2 };

/* The spans of a line, layer by layer, the nearest first; those of layer k,
 * from left to right, begin at first[k]. */
typedef struct layers {
  sg_spans span;
  SG_LIST_OF(size_t) first; /* [layers + 1] */
  double y;
} layers;

/* Where a line is, and how much of the light it has. */
typedef struct strip {
  int32_t x1, x2;
  uint32_t part;
} strip;

/* The spans of the lines about one row. */
typedef struct lines {
  const sg_shaded *in;
  sg_shading_work *work;
  layers line[LINES];
  SG_LIST_OF(strip) strip;
  SG_LIST_OF(strip) over; /* those at one place */
  bool failed;
} lines;

static size_t
layers_of(const layers *line)
{
  return line->first.n > 0 ? line->first.n - 1 : 0;
}

static sg_spans
layer_at(const layers *line, size_t k)
{
  if (k >= layers_of(line)) {
    return (sg_spans){0};
  }
  size_t first = line->first.item[k];
  return (sg_spans){.span = line->span.span + first,
                    .n = line->first.item[k + 1] - first};
}

/* Of the light at x what comes to layer k. */
static uint32_t
comes_to(const layers *line, size_t k, int32_t x)
{
  uint32_t rest = SG_OPAQUE;

  for (size_t j = 0; j < k; j++) {
    sg_spans spans = layer_at(line, j);
    size_t at = 0;

    SG_SEARCH(at, 0, spans.n, spans.span[at].x2 <= x);
    if (at < spans.n && spans.span[at].x1 <= x) {
      rest -= spans.span[at].part;
    }
  }
  return rest;
}

static bool
is_plane(const sg_shading *s, const sg_span *span)
{
  return s->surface.item[span->surface].kind == SG_IS_PLANE;
}

static bool
goes_on(const sg_shading *s, const sg_span *p, const sg_span *q)
{
  const sg_shading_surface *a = &s->surface.item[p->surface];
  const sg_shading_surface *b = &s->surface.item[q->surface];

  if (p->root != q->root || !is_plane(s, p) || !is_plane(s, q)) {
    return p->root == q->root && p->surface == q->surface &&
           (a->kind == SG_IS_RING
                ? sg_quartic_enters(p->sense) == sg_quartic_enters(q->sense)
                : p->sense == q->sense);
  }
  return p->surface == q->surface ||
         (p->leaf == q->leaf &&
          (p->face == q->face || sg_dot(a->normal, b->normal) > GOES_ON));
}

/* Whether two spans show one torus, by other roots. */
static bool
may_be_behind(const lines *l, const sg_span *p, const sg_span *q)
{
  return p && q && p->surface == q->surface && p->sense != q->sense &&
         l->in->scene->surface.item[p->surface].kind == SG_IS_RING;
}

/* Whether a line is between what is seen at p_at and at q_at, in dots. Null:
 * nothing is. */
static bool
differs(const lines *l, const sg_span *p, const double p_at[2],
        const sg_span *q, const double q_at[2])
{
  const sg_shading *s = l->in->scene;
  double depth[2], normal[2][3];

  if (!p || !q) {
    return p != q;
  }
  if (!goes_on(s, p, q)) {
    return true;
  }
  if (p->surface == q->surface) {
    return may_be_behind(l, p, q) &&
           sg_ring_gap(s, p->surface, p->sense, p_at, q->sense, q_at) > BEHIND;
  }
  double x = (p_at[0] + q_at[0]) / 2, y = (p_at[1] + q_at[1]) / 2;
  sg_shading_point(s, p, x, y, &depth[0], normal[0]);
  sg_shading_point(s, q, x, y, &depth[1], normal[1]);
  return fabs(depth[0] - depth[1]) > BEHIND;
}

static void
add_strip(lines *l, int32_t x1, int32_t x2, uint32_t part)
{
  int32_t most = sg_shading_frame_of(l->in->scene)->width * DOT;
  strip own = {x1 > 0 ? x1 : 0, x2 < most ? x2 : most, part};

  if (own.x1 < own.x2 && part > 0 && !SG_PUSH(l->strip, own)) {
    l->failed = true;
  }
}

/* The ends of spans of a layer of a line. */
static void
strips_of_ends(lines *l, const layers *all, size_t layer)
{
  const sg_spans here = layer_at(all, layer), *line = &here;

  for (size_t i = 0; i <= line->n && line->n > 0; i++) {
    const sg_span *p = i > 0 ? &line->span[i - 1] : NULL;
    const sg_span *q = i < line->n ? &line->span[i] : NULL;

    if (p && q && p->x2 < q->x1) {
      add_strip(l, p->x2 - HALF, p->x2 + HALF, comes_to(all, layer, p->x2 - 1));
      p = NULL;
    }
    int32_t x = q ? q->x1 : p->x2;
    const double left[2] = {(x - 1) / (double)DOT, all->y};
    const double right[2] = {(x + 1) / (double)DOT, all->y};
    if (differs(l, p, left, q, right)) {
      add_strip(l, x - HALF, x + HALF, comes_to(all, layer, q ? x : x - 1));
    }
  }
}

/* Where a layer of two lines shows other things. */
static void
strips_between(lines *l, const layers *upper, const layers *lower, size_t layer)
{
  const sg_spans above = layer_at(upper, layer), *a = &above;
  const sg_spans below = layer_at(lower, layer), *b = &below;
  int32_t end = sg_shading_frame_of(l->in->scene)->width * DOT;
  size_t i = 0, j = 0;

  for (int32_t x1 = 0, x2; x1 < end; x1 = x2) {
    while (i < a->n && a->span[i].x2 <= x1) {
      i++;
    }
    while (j < b->n && b->span[j].x2 <= x1) {
      j++;
    }
    const sg_span *p = i < a->n ? &a->span[i] : NULL;
    const sg_span *q = j < b->n ? &b->span[j] : NULL;
    int32_t next_p = !p ? end : p->x1 > x1 ? p->x1 : p->x2;
    int32_t next_q = !q ? end : q->x1 > x1 ? q->x1 : q->x2;

    x2 = next_p < next_q ? next_p : next_q;
    p = p && p->x1 <= x1 ? p : NULL;
    q = q && q->x1 <= x1 ? q : NULL;
    if (may_be_behind(l, p, q) && x2 - x1 > DOT) {
      x2 = x1 + DOT;
    }
    double x = ((double)x1 + x2) / 2 / DOT;
    if (differs(l, p, (double[]){x, upper->y}, q, (double[]){x, lower->y})) {
      add_strip(l, x1, x2, comes_to(p ? upper : lower, layer, x1));
    }
  }
}

SG_ORDER(compare_strips, strip, SG_BY(x1) SG_BY(x2));

static void
add_dots(uint32_t *line, int32_t x1, int32_t x2, uint32_t part)
{
  while (x1 < x2) {
    int32_t to = (x1 / DOT + 1) * DOT;

    to = to < x2 ? to : x2;
    line[x1 / DOT] += (uint32_t)(to - x1) * part;
    x1 = to;
  }
}

/* The strips that go on at x stay in `over`. To the first end of one; the most
 * of their parts. */
static int32_t
strips_over(lines *l, int32_t x, uint32_t *part)
{
  int32_t end = INT32_MAX;
  size_t kept = 0;

  *part = 0;
  for (size_t i = 0; i < l->over.n; i++) {
    strip own = l->over.item[i];

    if (own.x2 > x) {
      l->over.item[kept++] = own;
      end = own.x2 < end ? own.x2 : end;
      *part = own.part > *part ? own.part : *part;
    }
  }
  l->over.n = kept;
  return end;
}

/* Each place once, with the most that a strip has there. */
static void
add_strips(lines *l, uint32_t *line)
{
  size_t next = 0, n = l->strip.n;

  if (n > 1) {
    qsort(l->strip.item, n, sizeof *l->strip.item, compare_strips);
  }
  for (int32_t x = 0, to; next < n || l->over.n > 0; x = to) {
    for (; next < n && l->strip.item[next].x1 <= x; next++) {
      l->failed = l->failed || !SG_PUSH(l->over, l->strip.item[next]);
    }
    uint32_t part;
    int32_t begin = next < n ? l->strip.item[next].x1 : INT32_MAX;

    to = strips_over(l, x, &part);
    to = begin < to ? begin : to;
    if (part > 0) {
      add_dots(line, x, to, part);
    }
  }
  l->strip.n = 0;
}

/* The line is black, and opaque as far as light comes to it; `all` is what a
 * dot has. */
static void
put_over(sg_dot_row *cover, uint64_t all)
{
  for (int32_t x = 0; x < cover->width; x++) {
    uint64_t rest = all - cover->line[x];
    uint32_t *sum = cover->sum[x];

    for (int c = 0; c < 3; c++) {
      sum[c] = (uint32_t)(sum[c] * rest / all);
    }
    sum[3] = (uint32_t)(sum[3] * rest / all + cover->line[x]);
    cover->line[x] = 0;
  }
}

/* The spans of a line in the order of their layers. */
static bool
sort_layers(const sg_shading_work *work, layers *line)
{
  sg_spans *span = &line->span;
  size_t count = 0, n = 0;

  for (size_t i = 0; i < span->n; i++) {
    size_t layer = work->layer_of.item[i];
    count = layer >= count ? layer + 1 : count;
  }
  line->first.n = 0;
  if (!SG_PUSH(line->first, 0) ||
      !(count < 2 || sg_list_grow(&span->span, 2 * span->n, &span->room,
                                  sizeof *span->span))) {
    return false;
  }
  for (size_t k = 0; k < count; k++) {
    for (size_t i = 0; i < span->n && count > 1; i++) {
      if (work->layer_of.item[i] == k) {
        span->span[span->n + n++] = span->span[i];
      }
    }
    if (!SG_PUSH(line->first, count > 1 ? n : span->n)) {
      return false;
    }
  }
  if (n > 0) {
    memcpy(span->span, span->span + n, n * sizeof *span->span);
  }
  return true;
}

/* The spans of line i, counted from `far` lines above the row; beyond the
 * picture those of its border. */
static void
fill_line(lines *l, int32_t y, int i, int far)
{
  int n = (int)l->in->lines;
  double most = sg_shading_frame_of(l->in->scene)->height - 0.5 / n;
  double at = y + (i - far + 0.5) / n;
  layers *line = &l->line[i];

  line->y = at < 0 ? 0.5 / n : at > most ? most : at;
  l->failed = l->failed ||
              !sg_shading_line(l->in->scene, l->work, line->y, &line->span) ||
              !sort_layers(l->work, line);
}

/* Layers of three lines, i in the middle. */
static void
strips_of(lines *l, int i, int far)
{
  const layers *here = &l->line[i], *upper = here - far, *lower = here + far;
  bool both = l->in->lines > 1;
  size_t most = layers_of(here), above = layers_of(upper);
  size_t below = both ? layers_of(lower) : 0;

  most = above > most ? above : most;
  most = below > most ? below : most;
  for (size_t k = 0; k < most && !l->failed; k++) {
    strips_of_ends(l, here, k);
    strips_between(l, upper, here, k);
    if (both) {
      strips_between(l, here, lower, k);
    }
  }
}

bool
sg_face_edges(sg_dot_row *cover, const sg_shaded *in, sg_shading_work *work,
              int32_t y)
{
  int n = (int)in->lines, far = n > 1 ? n / 2 : 1;
  lines l = {.in = in, .work = work};

  for (int i = 0; i < n + 2 * far && !l.failed; i++) {
    fill_line(&l, y, i, far);
  }
  for (int i = far; i < far + n && !l.failed; i++) {
    strips_of(&l, i, far);
    add_strips(&l, cover->line);
  }
  put_over(cover, (uint64_t)DOT * (uint64_t)n * SG_OPAQUE);
  for (int i = 0; i < n + 2 * far; i++) {
    free(l.line[i].span.span);
    free(l.line[i].first.item);
  }
  free(l.strip.item);
  free(l.over.item);
  return !l.failed;
}
