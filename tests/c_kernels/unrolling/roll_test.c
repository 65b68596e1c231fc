/* roll_test.c -- cylinders and cones unrolled: against closed forms, and
 * against what their facets come to when they get finer.
 *
 * covers: surface
 */
#include "tests/check.h"
#include "unrolling/roll_curve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.141592653589793;

static sg_roll
opened(sg_surface_kind kind, double of[4][3], double k, double layer,
       double start)
{
  sg_roll roll;

  memset(&roll, 0, sizeof roll);
  roll.surface.kind = kind;
  memcpy(roll.surface.c, of[0], sizeof roll.surface.c);
  memcpy(roll.surface.u, of[1], sizeof roll.surface.u);
  memcpy(roll.surface.v, of[2], sizeof roll.surface.v);
  memcpy(roll.surface.w, of[3], sizeof roll.surface.w);
  roll.surface.k = k;
  roll.layer = layer;
  roll.start = start;
  CHECK("a surface", sg_surface_init(&roll.surface));
  CHECK("opens", sg_roll_open(&roll));
  return roll;
}

static bool
near(double a, double b, double off)
{
  return fabs(a - b) <= off * (1 + fabs(b));
}

static void
right_cylinder(void)
{
  double of[4][3] = {{1, 2, 3}, {50, 0, 0}, {0, 50, 0}, {0, 0, 80}};
  sg_roll roll = opened(SG_SURFACE_CYLINDER, of, 0, 0, 0);
  double at[2];

  sg_roll_at(&roll, 2 * PI, 1, at);
  CHECK("as wide as pi times the diameter", near(at[0], 100 * PI, 1e-13));
  CHECK("as high as it is", near(at[1], 80, 1e-13));
  for (int i = 0; i <= 360; i++) {
    sg_roll_at(&roll, i * PI / 180, 0.25, at);
    CHECK("arc", near(at[0], 50 * i * PI / 180, 2e-13));
    CHECK("height", near(at[1], 20, 1e-13));
  }
  sg_roll_clear(&roll);
}

/* A cylinder given by an oblique base: its section is what counts. */
static void
sheared_cylinder(void)
{
  double of[4][3] = {{0, 0, 0}, {3, 0, 1.5}, {0, 3, -4}, {0, 0, 7}};
  sg_roll roll = opened(SG_SURFACE_CYLINDER, of, 0, 0, 0.3);
  double at[2];

  for (int i = 0; i < 40; i++) {
    double t = 0.3 + i * 0.15;

    sg_roll_at(&roll, t, 0.5, at);
    CHECK("arc of the section", near(at[0], 3 * (t - 0.3), 1e-13));
    CHECK("the base is no straight line",
          near(at[1], 3.5 + 1.5 * cos(t) - 4 * sin(t), 1e-13));
  }
  sg_roll_clear(&roll);
}

/* The circumference of an ellipse, by the arithmetic and geometric mean. */
static double
ellipse_length(double a, double b)
{
  double sum = (a * a + b * b) / 2, power = 0.5, x = a, y = b;

  for (int i = 0; i < 40; i++) {
    double mean = (x + y) / 2, off = (x - y) / 2;

    y = sqrt(x * y);
    x = mean;
    power *= 2;
    sum -= power * off * off;
    if (off == 0) {
      break;
    }
  }
  return 2 * PI * sum / x;
}

static void
elliptic_cylinder(void)
{
  static const double flat[] = {1, 0.5, 0.1, 0.02, 0.002};

  for (size_t i = 0; i < sizeof flat / sizeof *flat; i++) {
    double of[4][3] = {{0, 0, 0}, {10, 0, 0}, {0, 10 * flat[i], 0}, {0, 0, 1}};
    sg_roll roll = opened(SG_SURFACE_CYLINDER, of, 0, 0, 1);
    double at[2];

    sg_roll_at(&roll, 1 + 2 * PI, 0, at);
    CHECK("the circumference of an ellipse",
          near(at[0], ellipse_length(10, 10 * flat[i]), 2e-13));
    sg_roll_clear(&roll);
  }
}

/* An oblique circular cylinder is an elliptic one. */
static void
oblique_cylinder(void)
{
  double of[4][3] = {{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {4, 0, 3}};
  sg_roll roll = opened(SG_SURFACE_CYLINDER, of, 0, 0, 0);
  double at[2];

  sg_roll_at(&roll, 2 * PI, 0, at);
  CHECK("section of 3/5", near(at[0], ellipse_length(5, 3), 2e-13));
  sg_roll_at(&roll, PI, 1, at);
  CHECK("along the axis", near(at[1], 5 - 4, 1e-13));
  sg_roll_clear(&roll);
}

static void
right_cone(void)
{
  double of[4][3] = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 2}};
  sg_roll roll = opened(SG_SURFACE_CONE, of, 0.5, 0, 0);
  double at[2];

  /* The apex is at height 4, generators are 5 long to it. */
  for (int i = 0; i <= 24; i++) {
    double t = i * PI / 12, angle = t * 3 / 5;

    sg_roll_at(&roll, t, 0, at);
    CHECK("base x", near(at[0], 5 * cos(angle), 1e-13));
    CHECK("base y", near(at[1], 5 * sin(angle), 1e-13));
    sg_roll_at(&roll, t, 1, at);
    CHECK("top", near(hypot(at[0], at[1]), 2.5, 1e-13));
  }
  sg_roll_clear(&roll);
}

/* A layer d outside a right cone is a cone with another apex. */
static void
cone_layer(void)
{
  double of[4][3] = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 4}};
  const double d = 0.2;
  sg_roll roll = opened(SG_SURFACE_CONE, of, 0, d, 0);
  double at[2], centre = -d * 4 / 3, far = 5 + d * 4 / 3;

  /* n = (4/5, 3/5): from the layer's apex it is d*4/3 farther. */
  for (int i = 0; i <= 24; i++) {
    double t = i * PI / 12, angle = t * 3 / 5;

    sg_roll_at(&roll, t, 0, at);
    CHECK("layer x", near(at[0], centre + far * cos(angle), 1e-12));
    CHECK("layer y", near(at[1], far * sin(angle), 1e-12));
  }
  sg_roll_clear(&roll);
}

/* Rolled of sheet: a layer d outside is 2*pi*d wider, whatever the section. */
static void
cylinder_layer(void)
{
  double of[4][3] = {{0, 0, 0}, {9, 1, 2}, {0, 4, 0}, {1, 0, 6}};
  sg_roll plain = opened(SG_SURFACE_CYLINDER, of, 0, 0, 0);
  sg_roll layer = opened(SG_SURFACE_CYLINDER, of, 0, 0.5, 0);
  double a[2], b[2];

  sg_roll_at(&plain, 2 * PI, 0, a);
  sg_roll_at(&layer, 2 * PI, 0, b);
  CHECK("wider by 2 pi d", near(b[0], a[0] + PI, 1e-12));
  CHECK("no higher", near(b[1], a[1], 1e-13));
  sg_roll_clear(&plain);
  sg_roll_clear(&layer);
}

static double
distance(const double a[3], const double b[3])
{
  double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};

  return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

/* The angles at the apex of n facets. */
static double
facet_angles(const sg_surface *s, int n)
{
  double apex[3], p[3], q[3], sum = 0;

  sg_surface_point(s, 0, 1 / (1 - s->k), apex);
  for (int i = 0; i < n; i++) {
    sg_surface_point(s, 2 * PI * i / n, 0, p);
    sg_surface_point(s, 2 * PI * (i + 1) / n, 0, q);
    double a = distance(apex, p), b = distance(apex, q), c = distance(p, q);

    sum += 2 * asin(sqrt((c - a + b) * (c + a - b) / (4 * a * b)));
  }
  return sum;
}

/* Facets of an oblique elliptic cone come to it, four times nearer when there
 * are twice as many. */
static void
facets_come_near(void)
{
  double of[4][3] = {{1, 2, 3}, {6, 1, 0}, {-1, 2, 1}, {5, 4, 9}};
  sg_roll roll = opened(SG_SURFACE_CONE, of, 0.25, 0, 0);
  double angle = roll.sum[roll.panels], off = 0;

  for (int n = 64; n <= 1024; n *= 2) {
    double now = fabs(facet_angles(&roll.surface, n) - angle);

    CHECK("four times nearer", n == 64 || fabs(off / now - 4) < 0.1);
    off = now;
  }
  CHECK("near", off < 1e-5);
  sg_roll_clear(&roll);
}

/* Unrolling keeps lengths: short ways on the surface are as long in the plane,
 * for placings of every kind, mirrored ones too. */
static double
some(void)
{
  return rand() / (RAND_MAX + 1.0) * 2 - 1;
}

static void
keeps_lengths(void)
{
  srand(7);
  for (int i = 0; i < 200; i++) {
    double of[4][3];

    for (int k = 0; k < 12; k++) {
      of[k / 3][k % 3] = some() + (k == 3 || k == 7 || k == 11 ? 3 : 0);
    }
    sg_roll roll = opened(i % 2 ? SG_SURFACE_CONE : SG_SURFACE_CYLINDER, of,
                          0.7 * some(), 0, some());

    for (int j = 0; j < 20; j++) {
      double t = roll.start + 3 * (1 + some()), h = some(), d = 1e-4 * some();
      double e = 1e-4 * some(), p[3], q[3], a[2], b[2];

      sg_surface_point(&roll.surface, t - d, h - e, p);
      sg_surface_point(&roll.surface, t + d, h + e, q);
      sg_roll_at(&roll, t - d, h - e, a);
      sg_roll_at(&roll, t + d, h + e, b);
      double on = distance(p, q), laid = hypot(b[0] - a[0], b[1] - a[1]);

      CHECK("as long as on the surface", fabs(laid - on) < 1e-7 * on + 1e-12);
    }
    sg_roll_clear(&roll);
  }
}

/* place and point undo each other. */
static void
places(void)
{
  srand(8);
  for (int i = 0; i < 3; i++) {
    sg_surface s = {.kind = i == 0   ? SG_SURFACE_CYLINDER
                            : i == 1 ? SG_SURFACE_CONE
                                     : SG_SURFACE_RULED,
                    .c = {1, 2, 3},
                    .u = {2, 1, 0},
                    .v = {0, 3, 1},
                    .w = {1, 0, 4},
                    .k = 0.3,
                    .k2 = 0.8};

    CHECK("a surface", sg_surface_init(&s));
    for (int j = 0; j < 100; j++) {
      double t = 3 * some(), h = some(), p[3], t2, h2, value, n[3];

      sg_surface_point(&s, t, h, p);
      sg_surface_place(&s, p, &t2, &h2);
      CHECK("place", near(t2, t, 1e-12) && near(h2, h, 1e-12));
      CHECK("on it", sg_surface_value(&s, p, &value, n) && fabs(value) < 1e-13);
    }
  }
}

/* Slopes are those of the values. */
static void
normals(void)
{
  static const sg_surface_kind kind[] = {SG_SURFACE_CYLINDER, SG_SURFACE_CONE,
                                         SG_SURFACE_RULED, SG_SURFACE_SPHERE,
                                         SG_SURFACE_TORUS};

  srand(9);
  for (int i = 0; i < 500; i++) {
    sg_surface s = {.kind = kind[i % 5],
                    .u = {2, 0.5, 0},
                    .v = {0, 3, 1},
                    .w = {1, 0, 4},
                    .k = 0.4,
                    .k2 = 0.9};
    double p[3], x[3], value, n[3], up, down, other[3];

    CHECK("a surface", sg_surface_init(&s));
    sg_surface_point(&s, 3 * some(), some(), p);
    CHECK("value", sg_surface_value(&s, p, &value, n));
    double way[3] = {1e-6 * some(), 1e-6 * some(), 1e-6 * some()};

    for (int k = 0; k < 3; k++) {
      x[k] = p[k] + way[k];
      p[k] -= way[k];
    }
    sg_surface_value(&s, x, &up, other);
    sg_surface_value(&s, p, &down, other);
    double rise = 2 * (way[0] * n[0] + way[1] * n[1] + way[2] * n[2]);

    CHECK("slope", fabs(up - down - rise) < 1e-11);
  }
}

/* Two cylinders meet where the closed form says. */
static void
cylinders_meet(void)
{
  sg_surface a = {.kind = SG_SURFACE_CYLINDER,
                  .u = {1, 0, 0},
                  .v = {0, 1, 0},
                  .w = {0, 0, 1}};
  sg_surface b = {.kind = SG_SURFACE_CYLINDER,
                  .u = {0, 2, 0},
                  .v = {0, 0, 2},
                  .w = {1, 0, 0}};
  const sg_surface *both[2] = {&a, &b};

  CHECK("surfaces", sg_surface_init(&a) && sg_surface_init(&b));
  for (int i = 0; i < 360; i++) {
    double t = i * PI / 180, x[3] = {0.98 * cos(t), 0.98 * sin(t), 1.8};

    CHECK("meet", sg_surfaces_meet(both, 2, 1, x));
    CHECK("on both", near(hypot(x[0], x[1]), 1, 1e-15) &&
                         near(hypot(x[1], x[2]), 2, 1e-15));
  }
  double far[3] = {1, 0, 30};

  CHECK("not so far", !sg_surfaces_meet(both, 2, 1, far) && far[2] == 30);
}

/* A cut slanting across a cylinder unrolls to a sine. */
static void
sine(void)
{
  double of[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  sg_roll roll = opened(SG_SURFACE_CYLINDER, of, 0, 0, 0);
  sg_surface cut = {.kind = SG_SURFACE_PLANE, .plane = {1, 0, -1, 0}};
  sg_roll_curve curve = {.roll = &roll,
                         .surface = {&roll.surface, &cut},
                         .surfaces = 2,
                         .near_t = PI / 2,
                         .from = {1, 0, 1},
                         .to = {cos(2), sin(2), cos(2)},
                         .reach = 1,
                         .tolerance = 1e-4};
  sg_roll_place *place;
  size_t n;
  double before[2] = {0, 1}, worst = 0;

  CHECK("a plane", sg_surface_init(&cut));
  CHECK("points", sg_roll_curve_points(&curve, &place, &n) && n > 10);
  for (size_t i = 0; i < n; i++) {
    const double *at = place[i].at;
    double x = (before[0] + at[0]) / 2, y = (before[1] + at[1]) / 2;

    CHECK("on the sine", near(at[1], cos(at[0]), 1e-13));
    CHECK("in order", at[0] > before[0]);
    worst = fmax(worst, fabs(cos(x) - y));
    memcpy(before, at, sizeof before);
  }
  CHECK("within the tolerance", worst < 1.5e-4);
  CHECK("no more than needed", worst > 1e-5);
  free(place);
  sg_roll_clear(&roll);
}

/* A trapezoid: parallel edges 6 and 3 long, 4 apart, in a plane that leans. */
static void
fan(void)
{
  double of[4][3] = {{1, 2, 3}, {6, 0, 0}, {1, 2.4, 3.2}, {0, 0, 0}};
  sg_roll roll = opened(SG_SURFACE_FAN, of, 0.5, 0, 0);
  double at[2], x[3], t, h, value, normal[3];

  sg_roll_at(&roll, 1, 0, at);
  CHECK("along the edge", near(at[0], 6, 1e-13) && near(at[1], 0, 1e-13));
  sg_roll_at(&roll, 0, 1, at);
  CHECK("across", near(at[0], 1, 1e-13) && near(at[1], 4, 1e-13));
  sg_roll_at(&roll, 1, 1, at);
  CHECK("the other edge", near(at[0], 4, 1e-13) && near(at[1], 4, 1e-13));
  sg_surface_point(&roll.surface, 0.3, 0.7, x);
  sg_surface_place(&roll.surface, x, &t, &h);
  CHECK("place of a point", near(t, 0.3, 1e-13) && near(h, 0.7, 1e-13));
  CHECK("on its plane", sg_surface_value(&roll.surface, x, &value, normal) &&
                            fabs(value) < 1e-14);
  CHECK("unit normal", near(normal[0], 0, 1e-14) &&
                           near(normal[1], -0.8, 1e-14) &&
                           near(normal[2], 0.6, 1e-14));
  sg_roll_clear(&roll);
  memset(&roll.surface, 0, sizeof roll.surface);
  roll.surface.kind = SG_SURFACE_FAN;
  roll.surface.u[0] = roll.surface.v[0] = 1;
  CHECK("none without width", !sg_surface_init(&roll.surface));
}

/* What lies within an oblique cone is far from its axis near the tip, so the
 * direction from there says nothing of which generator is the nearest. */
static void
within_oblique_cones(void)
{
  static const double shift[3][2] = {{47, 45}, {-60, 10}, {0, 75}};
  static const double top[3] = {0.0965, 0.095, 0.095}; /* a tenth of it */

  for (int i = 0; i < 3; i++) {
    double of[4][3] = {
        {0, 0, 0}, {51, 0, 0}, {0, 51, 0}, {shift[i][0], shift[i][1], 200}};
    sg_roll roll = opened(SG_SURFACE_CONE, of, 0, 0, 0);
    sg_surface inner = roll.surface;

    inner.offset = -1.5;
    for (int j = -180; j < 180; j++) {
      for (int k = 0; k <= 10; k++) {
        double x[3], t, h, value, normal[3];

        sg_surface_point(&inner, j * PI / 180, k * top[i], x);
        sg_surface_place(&inner, x, &t, &h);
        CHECK("the generator it was moved from",
              fabs(remainder(t - j * PI / 180, 2 * PI)) < 1e-9 &&
                  fabs(h - k * top[i]) < 1e-12);
        CHECK("it lies on it", sg_surface_value(&inner, x, &value, normal) &&
                                   fabs(value) < 1e-11);
      }
    }
    sg_roll_clear(&roll);
  }
}

int
main(void)
{
  right_cylinder();
  sheared_cylinder();
  elliptic_cylinder();
  oblique_cylinder();
  right_cone();
  cone_layer();
  cylinder_layer();
  facets_come_near();
  keeps_lengths();
  places();
  normals();
  cylinders_meet();
  sine();
  fan();
  within_oblique_cones();
  return check_report();
}
