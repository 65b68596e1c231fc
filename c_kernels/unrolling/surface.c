/* surface.c -- see surface.h. */
#include "surface.h"

#include "number/vector.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { STEPS_MOST = 60 };

static const double TURN = 6.283185307179586;
static const double TREMBLING_MOST = 1e-10;

/* out += f * a */
static void
add(double out[3], double f, const double a[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] += f * a[k];
  }
}

static bool
plane_init(double plane[4])
{
  double length = sqrt(sg_dot(plane, plane));

  for (int k = 0; k < 4; k++) {
    plane[k] /= length;
  }
  return length > 0;
}

/* The plane of a fan, and the rows that tell how far along u and v it is. */
static bool
fan_init(sg_surface *s)
{
  double n[3];

  sg_cross(s->u, s->v, n);
  double square = sg_dot(n, n);

  if (!(square > 1e-24 * sg_dot(s->u, s->u) * sg_dot(s->v, s->v))) {
    return false;
  }
  sg_cross(s->v, n, s->inverse[0]);
  sg_cross(n, s->u, s->inverse[1]);
  for (int k = 0; k < 3; k++) {
    s->inverse[0][k] /= square;
    s->inverse[1][k] /= square;
  }
  memcpy(s->plane, n, sizeof n);
  s->plane[3] = -sg_dot(n, s->c);
  return plane_init(s->plane);
}

bool
sg_surface_init(sg_surface *s)
{
  if (s->kind == SG_SURFACE_PLANE) {
    return plane_init(s->plane);
  }
  if (s->kind == SG_SURFACE_FAN) {
    return fan_init(s);
  }
  sg_cross(s->v, s->w, s->inverse[0]);
  sg_cross(s->w, s->u, s->inverse[1]);
  sg_cross(s->u, s->v, s->inverse[2]);
  double volume = sg_dot(s->u, s->inverse[0]);
  double size =
      sqrt(sg_dot(s->u, s->u) * sg_dot(s->v, s->v) * sg_dot(s->w, s->w));

  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      s->inverse[i][k] /= volume;
    }
  }
  return fabs(volume) > 1e-12 * size;
}

/* The coordinates of x along u, v, w. */
static void
coordinates(const sg_surface *s, const double x[3], double out[3])
{
  double d[3] = {x[0] - s->c[0], x[1] - s->c[1], x[2] - s->c[2]};

  for (int i = 0; i < 3; i++) {
    out[i] = sg_dot(s->inverse[i], d);
  }
}

/* The equation in coordinates a along u, v, w, 0 on the surface, and its
 * slopes. False where it has none. */
static bool
equation(const sg_surface *s, const double a[3], double *value, double slope[3])
{
  double p = 1, q = 1; /* what a[0] and a[1] are divided by */
  double fall = 0;     /* of the cone, with a[2] */

  if (s->kind == SG_SURFACE_RULED) {
    p = 1 - a[2] + a[2] * s->k;
    q = 1 - a[2] + a[2] * s->k2;
  } else if (s->kind == SG_SURFACE_CONE) {
    fall = 1 - s->k;
  }
  double b[2] = {a[0] / p, a[1] / q}, z = 0;
  double r = sqrt(b[0] * b[0] + b[1] * b[1]), far = r;

  slope[2] = fall;
  if (s->kind == SG_SURFACE_SPHERE) {
    z = a[2];
    far = sqrt(r * r + z * z);
    slope[2] = z / far;
  } else if (s->kind == SG_SURFACE_TORUS) {
    z = a[2];
    far = sqrt((r - 1) * (r - 1) + z * z);
    slope[2] = z / far;
  }
  if (!(r > 0) || !(far > 0)) {
    return false;
  }
  double along = s->kind == SG_SURFACE_TORUS ? (r - 1) / far : r / far;

  slope[0] = along * b[0] / r / p;
  slope[1] = along * b[1] / r / q;
  if (s->kind == SG_SURFACE_RULED) {
    slope[2] = (1 - s->k) * slope[0] * b[0] + (1 - s->k2) * slope[1] * b[1];
  }
  *value = far - (s->kind == SG_SURFACE_TORUS ? s->k : 1) + fall * a[2];
  return true;
}

/* ---- parallel to a cylinder or cone ---- */

/* The generator at t: a point of it (h = 0), its direction (h grows by 1), the
 * normal (outward, not a unit), and what is at right angles to both. */
typedef struct generator {
  double at[3], along[3], normal[3], across[3];
} generator;

static void
set_generator(const sg_surface *s, double t, generator *out)
{
  double c = cos(t), d = sin(t), turn[3] = {0, 0, 0};
  double k = s->kind == SG_SURFACE_CONE ? s->k : 1;

  memcpy(out->at, s->c, sizeof out->at);
  add(out->at, c, s->u);
  add(out->at, d, s->v);
  memcpy(out->along, s->w, sizeof out->along);
  add(out->along, (k - 1) * c, s->u);
  add(out->along, (k - 1) * d, s->v);
  add(turn, -d, s->u);
  add(turn, c, s->v);
  sg_cross(turn, out->along, out->normal);
  double way[3] = {out->at[0] - s->c[0], out->at[1] - s->c[1],
                   out->at[2] - s->c[2]};

  if (sg_dot(out->normal, way) < 0) {
    for (int i = 0; i < 3; i++) {
      out->normal[i] = -out->normal[i];
    }
  }
  sg_cross(out->normal, out->along, out->across);
}

/* How far x is from the plane that holds the generator at t and its normal,
 * and from the tangent plane. */
static void
offs(const sg_surface *s, const double x[3], double t, double *across,
     double *above)
{
  generator g;

  set_generator(s, t, &g);
  double from[3] = {x[0] - g.at[0], x[1] - g.at[1], x[2] - g.at[2]};

  *across = sg_dot(from, g.across) / sqrt(sg_dot(g.across, g.across));
  *above = sg_dot(from, g.normal) / sqrt(sg_dot(g.normal, g.normal));
}

/* The t of the generator that x is nearest to. Its surface is convex: so that
 * is where x is farthest above the tangent plane, or least below it, of all t;
 * and there x goes from one side of the plane of generator and normal to the
 * other. Found among `places`, then by the secant between two that have x on
 * different sides. */
static double
foot(const sg_surface *s, const double x[3])
{
  enum { places = 72 };
  const double wide = TURN / places;
  double t = 0, most = -INFINITY, fa, fb, above;

  for (int i = 0; i < places; i++) {
    offs(s, x, i * wide, &fa, &above);
    if (above > most) {
      most = above;
      t = i * wide;
    }
  }
  double a = t - wide, b = t + wide;

  offs(s, x, a, &fa, &above);
  offs(s, x, b, &fb, &above);
  for (int i = 0; i < 100 && fa != 0; i++) {
    double m = a - fa * (b - a) / (fb - fa), fm;

    if (!(fabs(m - a) < fabs(b - a) && fabs(m - b) < fabs(b - a))) {
      m = (a + b) / 2;
    }
    offs(s, x, m, &fm, &above);
    bool other = (fm < 0) != (fa < 0);

    if (m == a || m == b) {
      break;
    }
    if (other) {
      b = a;
      fb = fa;
    } else {
      fb /= 2; /* the Illinois rule: the other end comes nearer too */
    }
    a = m;
    fa = fm;
  }
  return a;
}

/* As sg_surface_value(): the distance itself. */
static void
parallel_value(const sg_surface *s, const double x[3], double *value,
               double normal[3])
{
  double across, t = foot(s, x);
  generator g;

  offs(s, x, t, &across, value);
  *value -= s->offset;
  set_generator(s, t, &g);
  double length = sqrt(sg_dot(g.normal, g.normal));

  for (int k = 0; k < 3; k++) {
    normal[k] = g.normal[k] / length;
  }
}

/* What a generator at t gains along w when it is moved. */
static double
gained(const sg_surface *s, double t)
{
  generator g;

  if (s->offset == 0) {
    return 0;
  }
  set_generator(s, t, &g);
  return s->offset * sg_dot(s->inverse[2], g.normal) /
         sqrt(sg_dot(g.normal, g.normal));
}

double
sg_surface_before(const sg_surface *s, double t, double h)
{
  return h - gained(s, t);
}

bool
sg_surface_value(const sg_surface *s, const double x[3], double *value,
                 double normal[3])
{
  double a[3], slope[3];

  if (s->kind == SG_SURFACE_PLANE || s->kind == SG_SURFACE_FAN) {
    memcpy(normal, s->plane, 3 * sizeof *normal);
    *value = sg_dot(s->plane, x) + s->plane[3];
    return true;
  }
  if (s->offset != 0) {
    parallel_value(s, x, value, normal);
    return true;
  }
  coordinates(s, x, a);
  if (!equation(s, a, value, slope)) {
    return false;
  }
  normal[0] = normal[1] = normal[2] = 0;
  for (int i = 0; i < 3; i++) {
    add(normal, slope[i], s->inverse[i]);
  }
  double length = sqrt(sg_dot(normal, normal));

  *value /= length;
  for (int k = 0; k < 3; k++) {
    normal[k] /= length;
  }
  return length > 0;
}

void
sg_surface_place(const sg_surface *s, const double x[3], double *t, double *h)
{
  double a[3];

  coordinates(s, x, a);
  if (s->kind == SG_SURFACE_FAN) {
    double width = 1 - a[1] + a[1] * s->k;

    *t = fabs(width) > 1e-12 ? a[0] / width : 0;
    *h = a[1];
    return;
  }
  if (s->kind == SG_SURFACE_RULED) {
    a[0] /= 1 - a[2] + a[2] * s->k;
    a[1] /= 1 - a[2] + a[2] * s->k2;
  }
  *t = atan2(a[1], a[0]);
  *h = a[2];
  if (s->offset != 0) {
    *t = remainder(foot(s, x), TURN);
  }
}

void
sg_surface_point(const sg_surface *s, double t, double h, double out[3])
{
  double p = 1, q, z = h;

  if (s->offset != 0) {
    generator g;

    set_generator(s, t, &g);
    memcpy(out, g.at, sizeof g.at);
    add(out, s->offset / sqrt(sg_dot(g.normal, g.normal)), g.normal);
    add(out, sg_surface_before(s, t, h), g.along);
    return;
  }
  if (s->kind == SG_SURFACE_FAN) {
    memcpy(out, s->c, 3 * sizeof *out);
    add(out, (1 - h + h * s->k) * t, s->u);
    add(out, h, s->v);
    return;
  }
  switch (s->kind) {
  case SG_SURFACE_CONE:
  case SG_SURFACE_RULED:
    p = 1 - h + h * s->k;
    break;
  case SG_SURFACE_SPHERE:
    p = cos(h);
    z = sin(h);
    break;
  case SG_SURFACE_TORUS:
    p = 1 + s->k * cos(h);
    z = s->k * sin(h);
    break;
  case SG_SURFACE_PLANE:
  case SG_SURFACE_CYLINDER:
  case SG_SURFACE_FAN:
    break;
  }
  q = s->kind == SG_SURFACE_RULED ? 1 - h + h * s->k2 : p;
  memcpy(out, s->c, 3 * sizeof *out);
  add(out, p * cos(t), s->u);
  add(out, q * sin(t), s->v);
  add(out, z, s->w);
}

/* Solves a (n by n, symmetric, diagonal 1) times x = b in place of b. False if
 * two of its rows are nearly the same. */
static bool
solve(size_t n, double a[SG_SURFACES_MOST][SG_SURFACES_MOST],
      double b[SG_SURFACES_MOST])
{
  for (size_t i = 0; i < n; i++) {
    if (!(a[i][i] > 1e-13)) {
      return false;
    }
    for (size_t j = i + 1; j < n; j++) {
      double f = a[j][i] / a[i][i];

      for (size_t k = i; k < n; k++) {
        a[j][k] -= f * a[i][k];
      }
      b[j] -= f * b[i];
    }
  }
  for (size_t i = n; i-- > 0;) {
    for (size_t k = i + 1; k < n; k++) {
      b[i] -= a[i][k] * b[k];
    }
    b[i] /= a[i][i];
  }
  return true;
}

/* One step: moves x, *moved is how far, *off how far x was from the farthest
 * surface. */
static bool
step(const sg_surface *const *surface, size_t n, double x[3], double *moved,
     double *off)
{
  double value[SG_SURFACES_MOST], normal[SG_SURFACES_MOST][3];
  double a[SG_SURFACES_MOST][SG_SURFACES_MOST], by[3] = {0, 0, 0};

  *off = 0;
  for (size_t i = 0; i < n; i++) {
    if (!sg_surface_value(surface[i], x, &value[i], normal[i])) {
      return false;
    }
    *off = fmax(*off, fabs(value[i]));
  }
  for (size_t i = 0; i < n; i++) {
    for (size_t j = 0; j < n; j++) {
      a[i][j] = sg_dot(normal[i], normal[j]);
    }
  }
  if (!solve(n, a, value)) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    add(by, -value[i], normal[i]);
  }
  add(x, 1, by);
  *moved = sqrt(sg_dot(by, by));
  return isfinite(*moved);
}

bool
sg_surfaces_meet(const sg_surface *const *surface, size_t n, double reach,
                 double x[3])
{
  double at[3] = {x[0], x[1], x[2]}, moved, off;
  double size = fabs(x[0]) + fabs(x[1]) + fabs(x[2]) + reach;
  double smallest = 4 * DBL_EPSILON * size;

  for (int i = 0; i < STEPS_MOST; i++) {
    double before[3] = {at[0], at[1], at[2]};

    if (!step(surface, n, at, &moved, &off)) {
      /* Two that touch, or an axis: at rest if they already meet. */
      if (!(off <= smallest)) {
        return false;
      }
      memcpy(at, before, sizeof at);
      moved = 0;
    }
    double way[3] = {at[0] - x[0], at[1] - x[1], at[2] - x[2]};

    if (!(sqrt(sg_dot(way, way)) <= reach)) {
      return false;
    }
    /* Where they are nearly tangent rounding never lets it rest. */
    if (moved <= smallest || (i == STEPS_MOST - 1 && off <= smallest &&
                              moved <= TREMBLING_MOST * size)) {
      memcpy(x, at, sizeof at);
      return true;
    }
  }
  return false;
}
