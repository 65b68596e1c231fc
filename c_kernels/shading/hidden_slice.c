/* hidden_slice.c -- which slices of a line are hidden where. A part of the line
 * is halved at ends of slices. Of the slices that are there all the way one
 * that is near hides what is behind it as far as the part goes; what is left is
 * looked at in both halves. So n slices of which few are seen in one place take
 * time by n log n.
 */
#include "shading_private.h"

#include "engine/search.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>

/* So few are not looked at again, and so many looks a slice are enough: where
 * more would be needed they hide little. */
enum { FEW = 3, LOOKS = 128 };

typedef struct hiding {
  sg_shading_work *work;
  double margin;
  int32_t *end;                /* ends of slices, in order, each once */
  uint32_t *piece;             /* [slices]: its last piece, from 1 */
  size_t looks;                /* that are left */
  SG_LIST_OF(uint32_t) list;   /* slices of the parts that are open */
  SG_LIST_OF(sg_slice) pieces; /* of slices: where they may be seen */
  SG_LIST_OF(uint64_t) of;     /* the slice of each, then the piece */
} hiding;

static int32_t
later(int32_t a, int32_t b)
{
  return a > b ? a : b;
}

static int32_t
sooner(int32_t a, int32_t b)
{
  return a < b ? a : b;
}

static const sg_slice *
slice_at(const hiding *h, uint32_t i)
{
  return &h->work->slice.item[i];
}

/* ---- one slice hides others ---- */

/* Whether f and s are in no group together from `a` to `b` by which their leaf
 * would begin and end at once. Places that are looked at are in the middle of
 * 1/256 dot or more. */
static bool
parts_from(const hiding *h, const sg_slice *f, const sg_slice *s, int32_t a,
           int32_t b)
{
  double left = (later(a, s->x1) + 0.5) / 256.0;
  double right = (sooner(b, s->x2) - 0.5) / 256.0;

  return s == f || s->leaf != f->leaf ||
         sg_slice_is_behind(f, s, left, right, h->margin) ||
         sg_slice_is_behind(s, f, left, right, h->margin);
}

/* From `a` to `b` the nearest one in the middle of those that are there all the
 * way and are seen as soon as they are met; null: there is none. */
static const sg_slice *
find_front(const hiding *h, size_t from, int32_t a, int32_t b)
{
  double middle = ((double)a + b) / 512.0, least = INFINITY;
  const sg_slice *front = NULL;

  for (size_t i = from; i < h->list.n; i++) {
    const sg_slice *s = slice_at(h, h->list.item[i]);
    if (s->x1 <= a && s->x2 >= b && h->work->scene->leaf.item[s->leaf].united &&
        !sg_slice_is_ring(s)) {
      double depth = sg_slice_depth(s, middle);
      if (depth < least) {
        least = depth;
        front = s;
      }
    }
  }
  for (size_t i = from; front && i < h->list.n; i++) {
    if (!parts_from(h, front, slice_at(h, h->list.item[i]), a, b)) {
      return NULL;
    }
  }
  return front;
}

/* Takes what is hidden from `a` to `b` off the list. */
static void
drop_hidden(hiding *h, size_t from, int32_t a, int32_t b)
{
  const sg_slice *front = find_front(h, from, a, b);
  size_t kept = from;

  for (size_t i = from; front && i < h->list.n; i++) {
    const sg_slice *s = slice_at(h, h->list.item[i]);
    double left = later(a, s->x1) / 256.0, right = sooner(b, s->x2) / 256.0;
    if (s == front || !sg_slice_is_behind(front, s, left, right, h->margin)) {
      h->list.item[kept++] = h->list.item[i];
    }
  }
  h->list.n = front ? kept : h->list.n;
}

/* ---- parts of the line ---- */

/* What is left from `a` to `b` may be seen there. Parts come from left to
 * right. */
static bool
keep_pieces(hiding *h, size_t from, int32_t a, int32_t b)
{
  for (size_t i = from; i < h->list.n; i++) {
    uint32_t at = h->list.item[i];
    const sg_slice *s = slice_at(h, at);
    int32_t x1 = later(a, s->x1), x2 = sooner(b, s->x2);

    if (h->piece[at] > 0 && h->pieces.item[h->piece[at] - 1].x2 == x1) {
      h->pieces.item[h->piece[at] - 1].x2 = x2;
      continue;
    }
    sg_slice piece = *s;
    piece.x1 = x1;
    piece.x2 = x2;
    if (!SG_PUSH(h->of, (uint64_t)at << 32 | h->pieces.n) ||
        !SG_PUSH(h->pieces, piece)) {
      return false;
    }
    h->piece[at] = (uint32_t)h->pieces.n;
  }
  return true;
}

/* Looks from end `low` to end `high` at the slices of the list from `from` on,
 * all of which are there somewhere, and takes them off. False: no memory. */
static bool
look_between(hiding *h, size_t from, size_t low, size_t high)
{
  int32_t a = h->end[low], b = h->end[high];
  size_t middle = low + (high - low) / 2, n = h->list.n - from;
  bool good = true;

  h->looks -= n < h->looks ? n : h->looks;
  drop_hidden(h, from, a, b);
  size_t to = h->list.n;
  if (middle == low || h->looks == 0 || to - from <= FEW) {
    good = keep_pieces(h, from, a, b);
  } else {
    for (int half = 0; half < 2 && good; half++) {
      size_t first = half == 0 ? low : middle, last = half == 0 ? middle : high;
      for (size_t i = from; i < to && good; i++) {
        const sg_slice *s = slice_at(h, h->list.item[i]);
        good = s->x2 <= h->end[first] || s->x1 >= h->end[last] ||
               SG_PUSH(h->list, h->list.item[i]);
      }
      good = good && look_between(h, to, first, last);
    }
  }
  h->list.n = from;
  return good;
}

SG_ORDER(compare_ends, int32_t, SG_BY_AT(0));

/* How many there are. */
static size_t
list_ends(hiding *h)
{
  size_t n = 0, kept = 0;

  for (size_t i = 0; i < h->work->slice.n; i++) {
    h->end[n++] = slice_at(h, (uint32_t)i)->x1;
    h->end[n++] = slice_at(h, (uint32_t)i)->x2;
  }
  qsort(h->end, n, sizeof *h->end, compare_ends);
  for (size_t i = 0; i < n; i++) {
    if (i == 0 || h->end[i] != h->end[i - 1]) {
      h->end[kept++] = h->end[i];
    }
  }
  return kept;
}

/* The slices of tori are seen anywhere. False: no memory. */
static bool
list_slices(hiding *h)
{
  for (size_t i = 0; i < h->work->slice.n; i++) {
    const sg_slice *s = slice_at(h, (uint32_t)i);
    if (!sg_slice_is_ring(s)
            ? !SG_PUSH(h->list, (uint32_t)i)
            : !SG_PUSH(h->of, (uint64_t)i << 32 | h->pieces.n) ||
                  !SG_PUSH(h->pieces, *s)) {
      return false;
    }
  }
  return true;
}

/* The pieces become the slices, in their order. False: no memory. */
static bool
take_pieces(hiding *h)
{
  sg_shading_work *w = h->work;

  if (!sg_sort_upper(h->of.item, h->of.n) ||
      !sg_list_need(&w->slice.item, h->of.n, &w->slice.room,
                    sizeof *w->slice.item)) {
    return false;
  }
  for (size_t i = 0; i < h->of.n; i++) {
    w->slice.item[i] = h->pieces.item[(uint32_t)(h->of.item[i] & UINT32_MAX)];
  }
  w->slice.n = h->of.n;
  return true;
}

bool
sg_drop_hidden_slices(sg_shading_work *w)
{
  size_t n = w->slice.n;
  hiding h = {.work = w,
              .margin = SG_SLICE_MARGIN(w->scene->frame.tolerance),
              .end = malloc((2 * n + 1) * sizeof *h.end),
              .piece = calloc(n + 1, sizeof *h.piece),
              .looks = LOOKS * n};
  size_t ends = h.end ? list_ends(&h) : 0;
  bool good = h.end && h.piece && list_slices(&h) &&
              (ends < 2 || look_between(&h, 0, 0, ends - 1)) && take_pieces(&h);

  w->searched += LOOKS * n - h.looks;
  free(h.end);
  free(h.piece);
  free(h.list.item);
  free(h.pieces.item);
  free(h.of.item);
  w->failed = w->failed || !good;
  return good;
}
