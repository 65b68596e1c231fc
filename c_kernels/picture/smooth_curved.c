/* smooth_curved.c -- see smooth.h: which sheets are curved, and fine enough to
 * be drawn so.
 */
#include "number/bounds.h"
#include "number/vector.h"
#include "rows/disjoint.h"
#include "smooth_private.h"

#include <stdlib.h>

/* Two bends go on in one line if they turn by less than this, in radians. */
#define STRAIGHT 0.02

/* A bend is coarse if a smooth surface would bulge out between the middles of
 * its triangles by more than this part of the segment's longest side; a sheet,
 * if more than that part of the length of its sides is. */
#define BULGE 1e-3
#define MOST  0.25

/* Where it bulges by less than this part, the outline of the triangles is never
 * seen beside that of the surface. */
#define SLIGHT 1e-4

/* ---------------------------------------------------------------- curved */

/* How a fan bends. */
typedef struct turning {
  uint32_t corners, links; /* as many as corners: it goes all round */
  uint32_t bends;
  double sum[3];   /* of the directions of the bends from the vertex */
  int32_t surface; /* of its last corner */
  bool folded;     /* all its corners are of one tapered surface */
} turning;

static void
add_link(const sg_smooth_builder *b, turning *turn, uint32_t side,
         uint32_t from, uint32_t to)
{
  turning *t = &turn[b->out->fan[from]];
  double u[3], size;

  t->links++;
  if (b->bend[side] > SG_FLAT_BEND) {
    sg_smooth_difference(b, sg_smooth_at(b, to), sg_smooth_at(b, from), u);
    size = sg_length(u);
    t->bends++;
    for (int k = 0; k < 3 && size > 0.0; k++) {
      t->sum[k] += u[k] / size;
    }
  }
}

static bool
bends_both_ways(const turning *t)
{
  return !t->folded && t->links == t->corners &&
         (t->bends > 2 ||
          (t->bends == 2 && sg_dot(t->sum, t->sum) > STRAIGHT * STRAIGHT));
}

/* Whether a corner is of a known surface that is folded along straight lines,
 * or of one that is not. */
static bool
is_tapered(const sg_smooth_builder *b, uint32_t corner)
{
  int32_t of = sg_smooth_surface(b, corner);

  return of >= 0 && sg_known_surface_is_tapered(&b->known.surface[of]);
}

static bool
is_round(const sg_smooth_builder *b, uint32_t corner)
{
  int32_t of = sg_smooth_surface(b, corner);
  sg_known_surface_kind kind =
      of < 0 ? SG_KNOWN_FREE : b->known.surface[of].kind;

  return kind == SG_KNOWN_SPHERE || kind == SG_KNOWN_TORUS;
}

static void
add_surface(const sg_smooth_builder *b, turning *t, uint32_t corner)
{
  int32_t surface = sg_smooth_surface(b, corner);

  t->folded = t->corners == 0 ? is_tapered(b, corner)
                              : t->folded && surface == t->surface;
  t->surface = surface;
}

bool
sg_smooth_find_bent(sg_smooth_builder *b, bool *memory)
{
  sg_smooth *out = b->out;
  turning *turn = calloc(out->fans + 1, sizeof *turn);

  *memory = turn != NULL;
  bool done = *memory;
  for (uint32_t i = 0; done && i < 3 * b->in->triangles; i++) {
    done = !sg_smooth_stop(b, i);
    add_surface(b, &turn[out->fan[i]], i);
    turn[out->fan[i]].corners++;
    if ((out->side[i] & SG_SIDE_SMOOTH) && out->across[i] > i) {
      add_link(b, turn, i, i, sg_smooth_next(i));
      add_link(b, turn, i, sg_smooth_next(i), i);
    }
  }
  for (uint32_t i = 0; done && i < 3 * b->in->triangles; i++) {
    uint32_t fan = out->fan[i];
    done = !sg_smooth_stop(b, i);
    out->curved[sg_disjoint_root(b->sheet, i / 3)] |=
        is_round(b, i) || (!out->apex[fan] && bends_both_ways(&turn[fan]));
  }
  free(turn);
  return done;
}

/* ---------------------------------------------------------------- coarse */

/* Of a sheet: the length of its smooth sides, and of those that are coarse. */
typedef struct lengths {
  double all, coarse;
} lengths;

/* The longest side of the box round the triangles of segment s. */
static double
size_of(const sg_smooth_builder *b, size_t s)
{
  const sg_dense *d = b->in;
  double size = 0.0;

  for (int k = 0; k < 3; k++) {
    double low = INFINITY, high = -INFINITY;
    for (uint32_t i = 3 * d->triangle_begin[s];
         i < 3 * d->triangle_begin[s + 1]; i++) {
      low = sg_smaller(low, sg_smooth_at(b, i)[k]);
      high = sg_larger(high, sg_smooth_at(b, i)[k]);
    }
    size = sg_larger(size, (high - low) * b->unit);
  }
  return size;
}

/* How high the triangle of a side is over it, times the side's length. */
static double
height_over(const sg_smooth_builder *b, uint32_t side)
{
  const double *p = sg_smooth_at(b, side);
  uint32_t next = sg_smooth_next(side);
  double u[3], w[3], n[3];

  sg_smooth_difference(b, sg_smooth_at(b, next), p, u);
  sg_smooth_difference(b, sg_smooth_at(b, sg_smooth_next(next)), p, w);
  sg_cross(u, w, n);
  return sg_length(n);
}

/* An arc from middle to middle of two chords that turn by an angle is a quarter
 * of their lengths times the tangent of half the angle's half high. */
static void
add_length(const sg_smooth_builder *b, uint32_t side, double size, lengths *out)
{
  double u[3], length, width, bulge;

  sg_smooth_difference(b, sg_smooth_at(b, sg_smooth_next(side)),
                       sg_smooth_at(b, side), u);
  length = sg_length(u);
  if (length > 0.0) {
    width = height_over(b, side) + height_over(b, b->out->across[side]);
    bulge = width / length / 4.0 * tan(b->bend[side] / SG_DEGREES / 4.0);
    out->all += length;
    bulge = sg_smooth_surface(b, side) < 0 ? bulge : 0.0;
    out->coarse += bulge > BULGE * size ? length : 0.0;
    if (bulge > SLIGHT * size) {
      b->out->side[side] |= SG_SIDE_BULGES;
      b->out->side[b->out->across[side]] |= SG_SIDE_BULGES;
    }
  }
}

/* Which sheets are coarse, of their roots alone. */
static bool
find_coarse(sg_smooth_builder *b, lengths *sheet)
{
  const sg_dense *d = b->in;

  for (size_t s = 0; s < d->segments; s++) {
    double size = size_of(b, s);
    for (uint32_t i = 3 * d->triangle_begin[s];
         i < 3 * d->triangle_begin[s + 1]; i++) {
      uint32_t root = sg_disjoint_root(b->sheet, i / 3);
      if (sg_smooth_stop(b, i)) {
        return false;
      }
      if (b->out->curved[root] && (b->out->side[i] & SG_SIDE_SMOOTH) &&
          b->out->across[i] > i) {
        add_length(b, i, size, &sheet[root]);
      }
    }
  }
  for (size_t t = 0; t < d->triangles; t++) {
    b->out->coarse[t] = sheet[t].coarse > MOST * sheet[t].all;
  }
  return true;
}

bool
sg_smooth_find_coarse(sg_smooth_builder *b, bool *memory)
{
  lengths *sheet = calloc(b->in->triangles + 1, sizeof *sheet);
  bool done = (*memory = sheet != NULL) && find_coarse(b, sheet);

  free(sheet);
  for (uint32_t t = 0; done && t < b->in->triangles; t++) {
    uint32_t root = sg_disjoint_root(b->sheet, t);
    b->out->curved[t] = b->out->curved[root];
    b->out->coarse[t] = b->out->coarse[root];
  }
  return done;
}
