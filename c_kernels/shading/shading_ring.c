/* shading_ring.c -- a torus, seen in the picture. */
#include "number/vector.h"
#include "shading_private.h"

#include <math.h>
#include <string.h>

/* The surface ends there, in its own size, at most. */
#define MARGIN 1.0625

enum { STEPS = 64 };

/* How far the torus reaches along a vector of its frame. */
static double
support(const double n[3], double k)
{
  return sqrt(n[0] * n[0] + n[1] * n[1]) + k * sg_length(n);
}

/* How much the plane where coordinate `axis` is e, which looks along `way`, is
 * below the farthest point; in *slope how that changes with e. */
static double
beyond(const sg_seen_frame *f, double k, int axis, double way, double e,
       double *slope)
{
  double n[3], round, length;

  for (int i = 0; i < 3; i++) {
    n[i] = way * (f->column[i][axis] - e * f->column[i][3]);
  }
  round = sqrt(n[0] * n[0] + n[1] * n[1]);
  length = sg_length(n);
  *slope = -way * f->column[3][3];
  for (int i = 0; i < 3; i++) {
    double turned = k * n[i] / length;
    turned += i < 2 && round > 0 ? n[i] / round : 0.0;
    *slope -= way * f->column[i][3] * turned;
  }
  return way * (f->column[3][axis] - e * f->column[3][3]) + support(n, k);
}

/* Newton from the centre: what is looked for bends one way. */
static double
reach_of(const sg_seen_frame *f, double k, int axis, double way)
{
  double e = f->column[3][axis] / f->column[3][3];

  for (int i = 0; i < STEPS; i++) {
    double slope, next = e - beyond(f, k, axis, way, e, &slope) / slope;
    if (!(way * (next - e) > 0)) {
      break;
    }
    e = next;
  }
  return e;
}

/* False: some of it is not in front of the eye. */
static bool
fill_box(const sg_seen_frame *f, double k, sg_shading_body *body)
{
  double n[3];

  for (int i = 0; i < 3; i++) {
    n[i] = f->column[i][3];
  }
  if (!(f->column[3][3] > support(n, k))) {
    return false;
  }
  for (int axis = 0; axis < 3; axis++) {
    body->low[axis] = f->at[axis] + reach_of(f, k, axis, -1.0);
    body->high[axis] = f->at[axis] + reach_of(f, k, axis, 1.0);
  }
  body->y1 = nearbyint(body->low[1] * SG_SNAP) / SG_SNAP;
  body->y2 = nearbyint(body->high[1] * SG_SNAP) / SG_SNAP;
  return true;
}

/* A = xx + yy + hh + (1 - kk) ww, B = xx + yy, W = ww, of places in `size`. */
static void
fill_forms(const sg_seen_frame *f, double k, sg_shading_torus *torus)
{
  for (int i = 0; i < 4; i++) {
    sg_linear_form row = f->row[i];

    for (int c = 0; c < 4; c++) {
      row.c[c] *= f->column[3][3] * (c < 3 ? torus->size : 1.0);
    }
    sg_add_square(torus->form[0], &row, i < 3 ? 1.0 : 1.0 - k * k);
    if (i != 2) {
      sg_add_square(torus->form[i < 2 ? 1 : 2], &row, 1.0);
    }
  }
}

sg_shading_end
sg_shading_add_ring(sg_shading *s, const sg_shading_ring *ring)
{
  sg_shading_body body = {.leaf = (uint32_t)(s->leaf.n - 1),
                          .face = ring->face,
                          .surface = (uint32_t)s->surface.n};
  sg_shading_surface surface = {.kind = SG_IS_RING, .of = (uint32_t)s->torus.n};
  sg_seen_frame f = {0};
  sg_shading_torus torus = {.size = 0.0};

  if (!sg_shading_see_frame(s, ring->frame, &f) ||
      !fill_box(&f, ring->k, &body)) {
    return SG_SHADING_BEHIND_EYE;
  }
  for (int k = 0; k < 3; k++) {
    torus.at[k] = f.at[k];
    torus.size = fmax(torus.size, MARGIN * fmax(body.high[k] - f.at[k],
                                                f.at[k] - body.low[k]));
  }
  sg_shading_reach(s, body.low, 0);
  sg_shading_reach(s, body.high, 0);
  fill_forms(&f, ring->k, &torus);
  for (int i = 0; i < 3; i++) {
    const double *column = f.column[i < 2 ? i : 3];
    const double seen[3] = {column[0], column[1], column[3]};
    memcpy(torus.circle[i], seen, sizeof seen);
  }
  s->leaf.item[body.leaf].round = true;
  return SG_PUSH(s->torus, torus) && SG_PUSH(s->surface, surface) &&
                 SG_PUSH(s->body, body)
             ? SG_SHADING_GOOD
             : SG_SHADING_NO_MEMORY;
}
