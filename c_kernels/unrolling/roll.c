/* roll.c -- see roll.h. */
#include "roll.h"

#include "engine/list.h"
#include "number/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HALF = 8, FEWEST = 8, MOST = 8192 };

static const double TURN = 6.283185307179586;

/* Gauss and Legendre: places and weights, of 16 points the positive ones. */
static const double gauss[HALF][2] = {
    {0.09501250983763744, 0.1894506104550685},
    {0.2816035507792589, 0.18260341504492358},
    {0.45801677765722737, 0.16915651939500254},
    {0.6178762444026438, 0.14959598881657674},
    {0.755404408355003, 0.12462897125553388},
    {0.8656312023878318, 0.09515851168249279},
    {0.9445750230732326, 0.062253523938647894},
    {0.9894009349916499, 0.027152459411754096}};

static void
combine(double f, const double a[3], double g, const double b[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = f * a[k] + g * b[k];
  }
}

/* Cone: from the apex to the point (t, 0). */
static void
generator(const sg_roll *r, double t, double out[3])
{
  combine(cos(t), r->surface.u, sin(t), r->surface.v, out);
  combine(1, out, 1, r->axis, out);
}

/* How fast x or the angle grows with t, and how fast the normal turns. */
static void
rates(const sg_roll *r, double t, double *rate, double *turning)
{
  double e[3];

  if (r->surface.kind == SG_SURFACE_CYLINDER) {
    combine(-sin(t), r->across[0], cos(t), r->across[1], e);
    double speed = sg_length(e);

    *turning = r->volume / (speed * speed);
    *rate = speed + r->layer * *turning;
  } else {
    double g[3], n[3];

    generator(r, t, g);
    combine(-sin(t), r->surface.u, cos(t), r->surface.v, e);
    sg_cross(g, e, n);
    double square = sg_dot(n, n);

    *rate = sqrt(square) / sg_dot(g, g);
    *turning = r->volume * sg_length(g) / square;
  }
}

/* The integral of the rate. */
static double
integral(const sg_roll *r, double from, double to)
{
  double middle = (from + to) / 2, half = (to - from) / 2, sum = 0;
  double rate, turning;

  for (int i = 0; i < HALF; i++) {
    for (int side = -1; side <= 1; side += 2) {
      rates(r, middle + side * half * gauss[i][0], &rate, &turning);
      sum += gauss[i][1] * rate;
    }
  }
  return half * sum;
}

/* By what the apex moves between two places; `angle` is that at `from`. */
static void
apex_way(const sg_roll *r, double from, double to, double angle, double out[2])
{
  double middle = (from + to) / 2, half = (to - from) / 2;
  double rate, turning;

  out[0] = out[1] = 0;
  for (int i = 0; i < HALF; i++) {
    for (int side = -1; side <= 1; side += 2) {
      double t = middle + side * half * gauss[i][0];
      double phi = angle + integral(r, from, t);

      rates(r, t, &rate, &turning);
      double by = half * gauss[i][1] * r->layer * turning;

      out[0] -= by * sin(phi);
      out[1] += by * cos(phi);
    }
  }
}

/* Where panel i begins. */
static double
panel_start(const sg_roll *r, size_t i)
{
  return r->start + TURN * (double)i / (double)r->panels;
}

/* Halves panels until the whole turn does not change. sum[i + 1]: of panel i
 * alone. False: no memory. */
static bool
choose_panels(sg_roll *r)
{
  double before = 0, now = 0;
  size_t room = 0;

  for (r->panels = FEWEST;; r->panels *= 2) {
    if (!sg_list_need(&r->sum, r->panels + 1, &room, sizeof *r->sum)) {
      return false;
    }
    now = 0;
    for (size_t i = 0; i < r->panels; i++) {
      r->sum[i + 1] = integral(r, panel_start(r, i), panel_start(r, i + 1));
      now += r->sum[i + 1];
    }
    if (r->panels == MOST || fabs(now - before) <= 2e-15 * now) {
      return true;
    }
    before = now;
  }
}

static bool
fill_panels(sg_roll *r)
{
  bool moves = r->surface.kind == SG_SURFACE_CONE && r->layer != 0;

  if (!choose_panels(r) ||
      (moves && !(r->apex = calloc(r->panels + 1, sizeof *r->apex)))) {
    return false;
  }
  r->sum[0] = 0;
  for (size_t i = 0; i < r->panels; i++) {
    double from = panel_start(r, i), to = panel_start(r, i + 1), by[2];

    r->sum[i + 1] += r->sum[i];
    if (moves) {
      apex_way(r, from, to, r->sum[i], by);
      r->apex[i + 1][0] = r->apex[i][0] + by[0];
      r->apex[i + 1][1] = r->apex[i][1] + by[1];
    }
  }
  return true;
}

static void
cylinder_frame(sg_roll *r)
{
  const sg_surface *s = &r->surface;
  double high = sg_length(s->w), n[3];

  combine(1 / high, s->w, 0, s->w, r->axis);
  combine(1, s->u, -sg_dot(s->u, r->axis), r->axis, r->across[0]);
  combine(1, s->v, -sg_dot(s->v, r->axis), r->axis, r->across[1]);
  sg_cross(r->across[0], r->across[1], n);
  r->volume = sg_length(n);
}

static void
cone_frame(sg_roll *r)
{
  const sg_surface *s = &r->surface;
  double n[3], f = -1 / (1 - s->k);

  combine(f, s->w, 0, s->w, r->axis);
  sg_cross(s->u, s->v, n);
  r->volume = fabs(sg_dot(n, r->axis));
}

static void
fan_frame(sg_roll *r)
{
  const sg_surface *s = &r->surface;
  double *along = r->across[0];

  combine(1 / sg_length(s->u), s->u, 0, s->u, along);
  combine(1, s->v, -sg_dot(s->v, along), along, r->axis);
  combine(1 / sg_length(r->axis), r->axis, 0, r->axis, r->axis);
}

/* What is rounded to a multiple of the grid is at most about `size`. */
static void
choose_grid(sg_roll *r, double size)
{
  int power;

  frexp(size, &power);
  r->grid = ldexp(1, power - 47);
}

bool
sg_roll_open(sg_roll *r)
{
  const sg_surface *s = &r->surface;

  r->sum = NULL;
  r->apex = NULL;
  r->layer += s->offset;
  if (s->kind == SG_SURFACE_FAN) {
    fan_frame(r);
    choose_grid(r, sg_length(s->u) + sg_length(s->v));
    return true;
  }
  if (s->kind == SG_SURFACE_CYLINDER) {
    cylinder_frame(r);
  } else if (s->kind == SG_SURFACE_CONE && s->k != 1) {
    cone_frame(r);
  } else {
    return false;
  }
  choose_grid(r, sg_length(s->u) + sg_length(s->v) + sg_length(r->axis));
  if (!fill_panels(r)) {
    sg_roll_clear(r);
    return false;
  }
  return true;
}

void
sg_roll_clear(sg_roll *r)
{
  free(r->sum);
  free(r->apex);
  r->sum = NULL;
  r->apex = NULL;
}

/* x or the angle at t; *apex, if there is one, where the apex is then. */
static double
sum_at(const sg_roll *r, double t, double apex[2])
{
  double place = (t - r->start) / TURN * (double)r->panels;
  size_t i = place <= 0 ? 0 : (size_t)place;

  i = i < r->panels ? i : r->panels - 1;
  double from = panel_start(r, i);

  apex[0] = apex[1] = 0;
  if (r->apex) {
    apex_way(r, from, t, r->sum[i], apex);
    apex[0] += r->apex[i][0];
    apex[1] += r->apex[i][1];
  }
  return r->sum[i] + integral(r, from, t);
}

static double
rounded(const sg_roll *r, double value)
{
  return nearbyint(value / r->grid) * r->grid + 0.0;
}

void
sg_roll_at(const sg_roll *r, double t, double h, double out[2])
{
  const sg_surface *s = &r->surface;

  if (s->kind == SG_SURFACE_FAN) {
    double along = (1 - h + h * s->k) * t;

    out[0] =
        rounded(r, along * sg_length(s->u) + h * sg_dot(s->v, r->across[0]));
    out[1] = rounded(r, h * sg_dot(s->v, r->axis));
    return;
  }
  double apex[2], sum = sum_at(r, t, apex), x, y;

  h = sg_surface_before(s, t, h);
  if (s->kind == SG_SURFACE_CYLINDER) {
    x = sum;
    y = h * sg_length(s->w) + cos(t) * sg_dot(s->u, r->axis) +
        sin(t) * sg_dot(s->v, r->axis);
  } else {
    double g[3];

    generator(r, t, g);
    double far = (1 - h * (1 - s->k)) * sg_length(g);

    x = apex[0] + far * cos(sum);
    y = apex[1] + far * sin(sum);
  }
  out[0] = rounded(r, x);
  out[1] = rounded(r, y);
}
