/* shading_bezier.c -- a net of Bezier patches as facets made for the picture:
 * none is farther from it than an eighth of a dot, and each is seen with its
 * true normals. All patches are divided alike, so those that meet have the same
 * corners.
 */
#include "number/bounds.h"
#include "number/vector.h"
#include "picture/bezier_patch.h"
#include "shading_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Dots. */
#define FARTHEST 0.125

/* Where nothing is wanted but a box: that part of the size of the net. */
#define BOX_PART (1.0 / 2048.0)

/* What is near the eye is divided as if it were so many times as large as the
 * rest, at most. */
#define MOST_LARGER 16.0

enum {
  BLOCK = 16,          /* cells of a side of what is added at once */
  SAMPLES = 8,         /* of a side, where sizes are asked */
  MOST_SIDE = 1 << 20, /* cells of a side */
  MOST_CELLS = 1 << 21 /* of what is in the picture */
};

typedef struct net {
  sg_shading *scene;
  const sg_shading_patch *patch;
  size_t patches, n; /* cells of a side */
  double bend;       /* of the patch that bends most, in dots */
} net;

/* Cells of a patch. */
typedef struct block {
  size_t u, v, wide, high;
} block;

static void
point_at(const net *t, const sg_shading_patch *patch, size_t u, size_t v,
         double out[3])
{
  double weight[4], row[4][3];

  sg_bezier_weights(v, t->n, weight);
  sg_bezier_row(patch->control, weight, row);
  sg_bezier_weights(u, t->n, weight);
  sg_bezier_point((const double(*)[3])row, weight, out);
}

/* ---- how many ---- */

/* By how much a vector is longer in the picture, at most: by the point that is
 * nearest to the eye. */
static double
nearness(const net *t)
{
  const sg_shading *s = t->scene;
  double least = INFINITY, sum = 0.0;
  net coarse = {.n = SAMPLES};

  for (size_t k = 0; k < t->patches; k++) {
    for (size_t i = 0; i < (SAMPLES + 1) * (SAMPLES + 1); i++) {
      double p[3];
      point_at(&coarse, &t->patch[k], i % (SAMPLES + 1), i / (SAMPLES + 1), p);
      double away = sg_dot(s->frame.matrix[3], p) + s->frame.matrix[3][3];
      least = sg_smaller(least, away);
      sum += away;
    }
  }
  double mean =
      sum / (double)(t->patches * (SAMPLES + 1) * (SAMPLES + 1)) / MOST_LARGER;
  return mean > 0 ? sg_larger(least, mean) : 1.0;
}

static void
measure(net *t, double *size)
{
  const sg_shading_frame *frame = &t->scene->frame;
  double map[3][3], near = nearness(t), from[3], to[3];

  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      map[i][k] = frame->matrix[i][k] / near;
    }
  }
  *size = 0.0;
  for (size_t k = 0; k < t->patches; k++) {
    const double(*control)[3] = t->patch[k].control;
    t->bend =
        sg_larger(t->bend, sg_bezier_bend(control, (const double(*)[3])map));
    for (int i = 0; i < 16; i++) {
      sg_minus(control[i], t->patch[0].control[0], from);
      for (int c = 0; c < 3; c++) {
        to[c] = sg_dot(map[c], from);
      }
      *size = sg_larger(*size, sg_any_length(to));
    }
  }
}

static size_t
side_for(const net *t, double farthest)
{
  double n = farthest > 0 ? ceil(sqrt(t->bend / (8.0 * farthest))) : 1.0;

  return n > MOST_SIDE ? MOST_SIDE : n > 1.0 ? (size_t)n : 1;
}

/* How far a block is from the plane through its corners, in dots. */
static double
off_of(const net *t, const block *b)
{
  double part = (double)(b->wide > b->high ? b->wide : b->high) / (double)t->n;

  return t->bend * part * part / 8.0;
}

/* ---- blocks ---- */

static bool
may_be_seen(const net *t, const sg_shading_patch *patch, const block *b)
{
  const sg_shading_frame *frame = &t->scene->frame;
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  double off = off_of(t, b) + 1.0, p[3], at[3];

  for (size_t i = 0; i < 4; i++) {
    point_at(t, patch, b->u + i % 2 * b->wide, b->v + i / 2 * b->high, p);
    if (!sg_shading_seen(t->scene, p, at)) {
      return true; /* which is told when it is added */
    }
    for (int k = 0; k < 2; k++) {
      low[k] = sg_smaller(low[k], at[k]);
      high[k] = sg_larger(high[k], at[k]);
    }
  }
  return low[0] - off < frame->width && high[0] + off > 0 &&
         low[1] - off < frame->height && high[1] + off > 0;
}

typedef struct grid {
  uint32_t corner[(BLOCK + 1) * (BLOCK + 1)];
  double at[(BLOCK + 1) * (BLOCK + 1)][3]; /* in the model */
} grid;

static sg_shading_end
add_corners(const net *t, const sg_shading_patch *patch, const block *b,
            grid *g)
{
  sg_shading_end end = SG_SHADING_GOOD;
  double weight[4], row[4][3];

  for (size_t j = 0, k = 0; j <= b->high; j++) {
    sg_bezier_weights(b->v + j, t->n, weight);
    sg_bezier_row(patch->control, weight, row);
    for (size_t i = 0; i <= b->wide && end == SG_SHADING_GOOD; i++, k++) {
      sg_bezier_weights(b->u + i, t->n, weight);
      sg_bezier_point((const double(*)[3])row, weight, g->at[k]);
      end = sg_shading_add_corner(t->scene, g->at[k], &g->corner[k]);
    }
  }
  return end;
}

/* Counter-clockwise seen from where u x v points, by the shorter diagonal. */
static sg_shading_end
add_cell(const net *t, int32_t face, const grid *g, size_t at, size_t line)
{
  const size_t of[4] = {at, at + 1, at + line + 1, at + line};
  const size_t three = 3;
  size_t turn = sg_distance(g->at[of[0]], g->at[of[2]]) <=
                        sg_distance(g->at[of[1]], g->at[of[3]])
                    ? 0
                    : 1;
  sg_shading_end end = SG_SHADING_GOOD;

  for (size_t i = 0; i < 2 && end == SG_SHADING_GOOD; i++) {
    uint32_t corner[3];
    for (size_t k = 0; k < 3; k++) {
      corner[k] = g->corner[of[(turn + 2 * i + k) % 4]];
    }
    end = sg_shading_add_polygon(t->scene, face, corner, &three, 1);
  }
  return end;
}

static sg_shading_end
add_block(const net *t, const sg_shading_patch *patch, const block *b)
{
  grid g;
  sg_shading_end end = add_corners(t, patch, b, &g);

  for (size_t k = 0; k < b->wide * b->high && end == SG_SHADING_GOOD; k++) {
    end = add_cell(t, patch->face, &g,
                   k / b->wide * (b->wide + 1) + k % b->wide, b->wide + 1);
  }
  return end;
}

/* Adds what may be seen of a block, or only counts its cells, up to the most.
 */
static sg_shading_end
take_block(const net *t, const sg_shading_patch *patch, const block *b,
           size_t *count)
{
  if ((count && *count > MOST_CELLS) || !may_be_seen(t, patch, b)) {
    return SG_SHADING_GOOD;
  }
  if (b->wide <= BLOCK && b->high <= BLOCK) {
    if (count) {
      *count += b->wide * b->high;
      return SG_SHADING_GOOD;
    }
    return add_block(t, patch, b);
  }
  block half[2] = {*b, *b};
  if (b->wide > b->high) {
    half[0].wide = b->wide / 2;
    half[1].u += half[0].wide;
    half[1].wide -= half[0].wide;
  } else {
    half[0].high = b->high / 2;
    half[1].v += half[0].high;
    half[1].high -= half[0].high;
  }
  sg_shading_end end = take_block(t, patch, &half[0], count);
  return end != SG_SHADING_GOOD ? end : take_block(t, patch, &half[1], count);
}

/* Fewer cells, if there are too many in the picture. */
static void
limit_cells(net *t)
{
  for (size_t count = MOST_CELLS + 1; count > MOST_CELLS && t->n > 1;) {
    const block all = {0, 0, t->n, t->n};
    count = 0;
    for (size_t k = 0; k < t->patches; k++) {
      (void)take_block(t, &t->patch[k], &all, &count);
    }
    t->n = count > MOST_CELLS ? t->n / 2 : t->n;
  }
}

/* ---- nets ---- */

static sg_shading_end
reach_net(net *t, double size)
{
  t->n = side_for(t, size * BOX_PART);
  double off = off_of(t, &(block){0, 0, 1, 1});

  for (size_t k = 0; k < t->patches; k++) {
    for (size_t i = 0; i < (t->n + 1) * (t->n + 1); i++) {
      double p[3], at[3];
      point_at(t, &t->patch[k], i % (t->n + 1), i / (t->n + 1), p);
      if (!sg_shading_seen(t->scene, p, at)) {
        return SG_SHADING_BEHIND_EYE;
      }
      sg_shading_reach(t->scene, at, off);
    }
  }
  return SG_SHADING_GOOD;
}

sg_shading_end
sg_shading_add_net(sg_shading *s, const sg_shading_patch *patch, size_t n)
{
  net t = {.scene = s, .patch = patch, .patches = n};
  sg_shading_end end = SG_SHADING_GOOD;
  double size;

  if (n == 0) {
    return end;
  }
  measure(&t, &size);
  if (s->frame.box) {
    return reach_net(&t, size);
  }
  t.n = side_for(&t, FARTHEST);
  limit_cells(&t);
  for (size_t k = 0; k < n && end == SG_SHADING_GOOD; k++) {
    const block all = {0, 0, t.n, t.n};
    uint32_t known =
        sg_shading_add_known(s, SG_KNOWN_BEZIER, patch[k].control, 0.0, 0.0);
    sg_shading_stand_for(s, known);
    end = known > 0 ? take_block(&t, &patch[k], &all, NULL)
                    : SG_SHADING_NO_MEMORY;
  }
  sg_shading_stand_for(s, 0);
  return end;
}
