/* face_edge.c -- see face_edge.h. */
#include "face_edge.h"

#include "engine/search.h"
#include "number/vector.h"
#include "shading_private.h"

#include <math.h>
#include <stdlib.h>

enum { DOT = 256, HALF = DOT / 2 };

/* Facets of a mesh whose normals have so much in common go on in each other:
 * the cosine of 20 degrees. */
#define GOES_ON 0.9396926207859084

/* What is as much deeper, in dots, is behind. */
#define BEHIND 1.0

/* The spans of the lines about one row. */
typedef struct lines {
  const sg_shaded *in;
  sg_shading_work *work;
  sg_spans line[3 * SG_COVER_LINES + 2];
  double y[3 * SG_COVER_LINES + 2];
  SG_LIST_OF(int64_t) strip; /* x1, and x2 in the lower half */
  bool failed;
} lines;

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
add_strip(lines *l, int32_t x1, int32_t x2)
{
  int32_t most = sg_shading_frame_of(l->in->scene)->width * DOT;

  x1 = x1 > 0 ? x1 : 0;
  x2 = x2 < most ? x2 : most;
  if (x1 < x2 && !SG_PUSH(l->strip, (int64_t)x1 << 32 | x2)) {
    l->failed = true;
  }
}

/* The ends of spans of a line. */
static void
strips_of_ends(lines *l, const sg_spans *line, double y)
{
  for (size_t i = 0; i <= line->n && line->n > 0; i++) {
    const sg_span *p = i > 0 ? &line->span[i - 1] : NULL;
    const sg_span *q = i < line->n ? &line->span[i] : NULL;

    if (p && q && p->x2 < q->x1) {
      add_strip(l, p->x2 - HALF, p->x2 + HALF);
      p = NULL;
    }
    int32_t x = q ? q->x1 : p->x2;
    const double left[2] = {(x - 1) / (double)DOT, y};
    const double right[2] = {(x + 1) / (double)DOT, y};
    if (differs(l, p, left, q, right)) {
      add_strip(l, x - HALF, x + HALF);
    }
  }
}

/* Where two lines show other things. */
static void
strips_between(lines *l, int upper, int lower)
{
  const sg_spans *a = &l->line[upper], *b = &l->line[lower];
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
    if (differs(l, p, (double[]){x, l->y[upper]}, q,
                (double[]){x, l->y[lower]})) {
      add_strip(l, x1, x2);
    }
  }
}

SG_ORDER(compare_strips, int64_t, SG_BY_AT(0));

/* Each place once. */
static void
add_strips(lines *l, uint32_t *line)
{
  int32_t done = 0;

  if (l->strip.n > 1) {
    qsort(l->strip.item, l->strip.n, sizeof *l->strip.item, compare_strips);
  }
  for (size_t i = 0; i < l->strip.n; i++) {
    int32_t x1 = (int32_t)(l->strip.item[i] >> 32);
    int32_t x2 = (int32_t)(l->strip.item[i] & INT32_MAX);

    for (x1 = x1 > done ? x1 : done; x1 < x2;) {
      int32_t to = (x1 / DOT + 1) * DOT;
      to = to < x2 ? to : x2;
      line[x1 / DOT] += (uint32_t)(to - x1);
      x1 = to;
    }
    done = x2 > done ? x2 : done;
  }
  l->strip.n = 0;
}

/* The line is black, and opaque. */
static void
put_over(sg_dot_row *cover, uint32_t all)
{
  for (int32_t x = 0; x < cover->width; x++) {
    uint64_t rest = all - cover->line[x];
    uint32_t *sum = cover->sum[x];

    for (int c = 0; c < 3; c++) {
      sum[c] = (uint32_t)(sum[c] * rest / all);
    }
    sum[3] =
        (uint32_t)(sum[3] * rest / all + (uint64_t)cover->line[x] * SG_OPAQUE);
    cover->line[x] = 0;
  }
}

/* The spans of line i, counted from `far` lines above the row; beyond the
 * picture those of its border. */
static void
fill_line(lines *l, int32_t y, int i, int far)
{
  int n = (int)l->in->lines;
  double most = sg_shading_frame_of(l->in->scene)->height - 0.5 / n;
  double at = y + (i - far + 0.5) / n;

  l->y[i] = at < 0 ? 0.5 / n : at > most ? most : at;
  l->failed = l->failed ||
              !sg_shading_line(l->in->scene, l->work, l->y[i], &l->line[i]);
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
    strips_of_ends(&l, &l.line[i], l.y[i]);
    strips_between(&l, i - far, i);
    if (n > 1) {
      strips_between(&l, i, i + far);
    }
    add_strips(&l, cover->line);
  }
  put_over(cover, (uint32_t)(DOT * n));
  for (int i = 0; i < n + 2 * far; i++) {
    free(l.line[i].span);
  }
  free(l.strip.item);
  return !l.failed;
}
