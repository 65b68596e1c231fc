/* stroke_crossing.c -- see stroke_crossing.h */
#include "stroke_crossing.h"

#include "engine/list.h"
#include "engine/search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LEAST_SINE 0.17 /* 10 degrees */

enum { ASK_EVERY = 1 << 12 };

typedef struct piece {
  int32_t stroke;      /* from 1 */
  uint32_t number;     /* in its stroke */
  double at[2], by[2]; /* from here, so far */
  double low[2], high[2];
  double length, before; /* its own, and that of the pieces before it */
} piece;

typedef struct pieces {
  piece *item;
  size_t n;
} pieces;

SG_ORDER(compare_pieces, piece, SG_BY(low[0]));

SG_ORDER(compare_marks, sg_stroke_mark, SG_BY(stroke) SG_BY(way));

/* Pieces of no length are left out. */
static bool
make_pieces(const sg_crossing_stroke *stroke, size_t n, pieces *out)
{
  size_t most = 0;

  for (size_t s = 0; s < n; s++) {
    most += stroke[s].n;
  }
  out->item = malloc((most + 1) * sizeof *out->item);
  for (size_t s = 0; out->item && s < n; s++) {
    double before = 0.0;
    for (size_t i = 1; i < stroke[s].n; i++) {
      const int64_t *from = stroke[s].at[i - 1], *to = stroke[s].at[i];
      piece p = {.stroke = (int32_t)(s + 1), .number = (uint32_t)i};
      for (int k = 0; k < 2; k++) {
        p.at[k] = (double)from[k];
        p.by[k] = (double)(to[k] - from[k]);
        p.low[k] = (double)(from[k] < to[k] ? from[k] : to[k]);
        p.high[k] = (double)(from[k] < to[k] ? to[k] : from[k]);
      }
      p.length = sqrt(p.by[0] * p.by[0] + p.by[1] * p.by[1]);
      p.before = before;
      before += p.length;
      if (p.length > 0) {
        out->item[out->n++] = p;
      }
    }
  }
  return out->item != NULL;
}

static bool
may_cross(const piece *a, const piece *b)
{
  return a->high[1] + SG_CROSSING_NEAR >= b->low[1] &&
         b->high[1] + SG_CROSSING_NEAR >= a->low[1] &&
         (a->stroke != b->stroke ||
          (a->number > b->number + 1 || b->number > a->number + 1));
}

/* At which part of each they cross; false: they do not. */
static bool
cross(const piece *a, const piece *b, double part[2])
{
  double sine = a->by[0] * b->by[1] - a->by[1] * b->by[0];
  double x = b->at[0] - a->at[0], y = b->at[1] - a->at[1];

  if (fabs(sine) < LEAST_SINE * a->length * b->length) {
    return false;
  }
  part[0] = (x * b->by[1] - y * b->by[0]) / sine;
  part[1] = (x * a->by[1] - y * a->by[0]) / sine;
  return part[0] * a->length >= -SG_CROSSING_NEAR &&
         (part[0] - 1) * a->length <= SG_CROSSING_NEAR &&
         part[1] * b->length >= -SG_CROSSING_NEAR &&
         (part[1] - 1) * b->length <= SG_CROSSING_NEAR;
}

static bool
add_mark(sg_stroke_marks *out, const piece *p, double part)
{
  double inside = part < 0 ? 0.0 : part > 1 ? 1.0 : part;

  return SG_PUSH(*out, (sg_stroke_mark){.stroke = p->stroke,
                                        .way = p->before + inside * p->length});
}

/* Those that follow within SG_CROSSING_APART of one that stays go. */
static void
keep_apart(sg_stroke_marks *marks)
{
  size_t n = 0;

  for (size_t i = 0; i < marks->n; i++) {
    if (n == 0 || marks->item[n - 1].stroke != marks->item[i].stroke ||
        marks->item[i].way - marks->item[n - 1].way >= SG_CROSSING_APART) {
      marks->item[n++] = marks->item[i];
    }
  }
  marks->n = n;
}

bool
sg_stroke_crossings(const sg_crossing_stroke *stroke, size_t n,
                    const sg_cancel *cancel, sg_stroke_marks *out)
{
  pieces all = {0};
  size_t ticks = 0;
  bool good = make_pieces(stroke, n, &all);

  if (good) {
    qsort(all.item, all.n, sizeof *all.item, compare_pieces);
  }
  for (size_t i = 0; i < all.n && good; i++) {
    const piece *a = &all.item[i];
    for (size_t j = i + 1; j < all.n && good &&
                           all.item[j].low[0] <= a->high[0] + SG_CROSSING_NEAR;
         j++) {
      const piece *b = &all.item[j];
      double part[2];
      if (++ticks % ASK_EVERY == 0 && sg_cancelled(cancel)) {
        good = false;
      } else if (may_cross(a, b) && cross(a, b, part)) {
        good = add_mark(out, a, part[0]) && add_mark(out, b, part[1]);
      }
    }
  }
  free(all.item);
  if (good && out->n > 0) {
    qsort(out->item, out->n, sizeof *out->item, compare_marks);
    keep_apart(out);
  }
  return good;
}
