/* known_surface_test.c -- where surfaces are, which way they look and how high
 * they are above a point, against numbers that a pencil gives. */
#include "picture/known_surface.h"

#include "tests/check.h"

#include <math.h>
#include <string.h>

/* The centre, and axes twice as long as one. */
static const double placed[4][3] = {{1, 2, 3}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};

static sg_known_surface
surface_of(sg_known_surface_kind kind, double a, double b)
{
  sg_known_surface s;

  sg_known_surface_init(&s, kind, placed, a, b);
  return s;
}

/* The normal at x, y, h of the surface is as x, y, z, where the facet is too;
 * what lies behind it is left alone. */
static bool
looks(const sg_known_surface *s, double x, double y, double h,
      const double as[3])
{
  const double p[3] = {1 + 2 * x, 2 + 2 * y, 3 + 2 * h};
  double out[4] = {0, 0, 0, 7},
         size = sqrt(as[0] * as[0] + as[1] * as[1] + as[2] * as[2]);
  bool is = sg_known_surface_normal(s, p, as, out) && out[3] == 7;

  for (int k = 0; k < 3; k++) {
    is = is && fabs(out[k] - as[k] / size) < 1e-14;
  }
  return is;
}

#define LOOKS(s, x, y, h, ...)                                                 \
  looks((s), (x), (y), (h), (const double[3]){__VA_ARGS__})

static bool
has_none(const sg_known_surface *s, double x, double y, double h,
         double facet_x, double facet_z)
{
  const double p[3] = {1 + 2 * x, 2 + 2 * y, 3 + 2 * h};
  const double facet[3] = {facet_x, 0, facet_z};
  double out[3], height;

  return !sg_known_surface_normal(s, p, facet, out) &&
         !sg_known_surface_height(s, p, facet, &height);
}

/* What is above x, 0, 0, with a facet that looks along x. */
static double
height_at(const sg_known_surface *s, double x)
{
  double height = NAN;

  return sg_known_surface_height(s, (double[3]){1 + 2 * x, 2, 3},
                                 (double[3]){1, 0, 0}, &height)
             ? height
             : NAN;
}

static void
spheres(void)
{
  sg_known_surface s = surface_of(SG_KNOWN_SPHERE, 0, 0);
  double at[4] = {0, 0, 0, 7};

  sg_known_surface_place(&s, (double[3]){3, 3, 1}, at);
  CHECK("a place", at[0] == 1 && at[1] == 0.5 && at[2] == -1 && at[3] == 7);
  CHECK("outwards", LOOKS(&s, 1, 0, 0, 1, 0, 0));
  CHECK("inwards", LOOKS(&s, 1, 0, 0, -1, 0, 0));
  CHECK("aslant", LOOKS(&s, 0.6, 0, 0.8, 3, 0, 4));
  CHECK("across", has_none(&s, 1, 0, 0, 0, 1));
  CHECK("79 degrees off", has_none(&s, 1, 0, 0, 0.19, 1));
  CHECK("its middle", has_none(&s, 0, 0, 0, 1, 0));
  /* (1 - 0.75^2) / 2 over the length of the gradient, 0.75 / 2 */
  CHECK("above a chord", fabs(height_at(&s, 0.75) - 7.0 / 12) < 1e-14);
  CHECK("on it", height_at(&s, 1) == 0);
  CHECK("below what is outside", height_at(&s, 1.25) < 0);
  CHECK("is measured", sg_known_surface_is_measured(&s));
}

static void
tapered(void)
{
  sg_known_surface s = surface_of(SG_KNOWN_TAPERED, 0.5, 0.5);

  CHECK("a cone", LOOKS(&s, 1, 0, 0, 2, 0, 1) && LOOKS(&s, 0, -1, 0, 0, -2, 1));
  CHECK("higher", LOOKS(&s, 0.5, 0, 1, 2, 0, 1));
  CHECK("inside", LOOKS(&s, 0.9, 0, 0, 2, 0, 1));
  CHECK("its apex", has_none(&s, 0, 0, 2, 1, 0));
  CHECK("behind it", has_none(&s, 0.1, 0, 2.1, 1, 0));
  CHECK("its axis", has_none(&s, 0, 0, 0, 1, 0));
  s = surface_of(SG_KNOWN_TURNED, 1, 2);
  CHECK("an ellipse", LOOKS(&s, 0, 2, 1, 0, 1, -1));
  CHECK("on it", height_at(&s, 1) == 0);
  CHECK("both", sg_known_surface_is_tapered(&s));
}

static void
tori(void)
{
  sg_known_surface s = surface_of(SG_KNOWN_TORUS, 0.25, 0);

  CHECK("outside", LOOKS(&s, 1.25, 0, 0, 1, 0, 0));
  CHECK("along y", LOOKS(&s, 0, 1.25, 0, 0, 1, 0));
  CHECK("in the hole", LOOKS(&s, 0.75, 0, 0, -1, 0, 0));
  CHECK("above", LOOKS(&s, 0, -1, 0.25, 0, 0, 1));
  CHECK("its axis", has_none(&s, 0, 0, 0.25, 1, 1));
  /* (0.25^2 - 0.2^2) / 2 over 0.2 / 2 */
  CHECK("above a chord", fabs(height_at(&s, 1.2) - 0.1125) < 1e-13);
  CHECK("is measured", sg_known_surface_is_measured(&s));
}

static void
others(void)
{
  static const double bent[5][3] = {
      {1, 2, 3}, {0, 0, 1}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  static const double flat[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  sg_known_surface s;

  sg_known_surface_init(&s, SG_KNOWN_BENT, bent, 0, 0);
  CHECK("bent: at its point", LOOKS(&s, 0, 0, 0, 0, 0, 1));
  CHECK("and farther", LOOKS(&s, 0.5, 0.5, 0.5, 1, 2, 4));
  CHECK("has no height", isnan(height_at(&s, 1)));
  CHECK("is not measured",
        !sg_known_surface_is_measured(&s) && !sg_known_surface_is_tapered(&s));
  sg_known_surface_init(&s, SG_KNOWN_SPHERE, flat, 0, 0);
  CHECK("without a volume it is free", s.kind == SG_KNOWN_FREE);
  CHECK("and has no normal", has_none(&s, 1, 0, 0, 1, 0));
  CHECK("rows of frames", sg_known_surface_rows(SG_KNOWN_BEZIER) == 16 &&
                              sg_known_surface_rows(SG_KNOWN_BENT) == 5 &&
                              sg_known_surface_rows(SG_KNOWN_TORUS) == 4);
}

/* Twice as wide along x, and aside. */
static void
moves(void)
{
  static const double map[3][4] = {{2, 0, 0, 10}, {0, 1, 0, 20}, {0, 0, 1, 30}};
  sg_known_surface s = surface_of(SG_KNOWN_SPHERE, 0, 0), to;
  double out[3], part = sqrt(0.5);

  sg_known_surface_move(&s, map, &to);
  CHECK("its centre",
        to.frame[0][0] == 12 && to.frame[0][1] == 22 && to.frame[0][2] == 33);
  CHECK("its axes",
        to.frame[1][0] == 4 && to.frame[2][1] == 2 && to.frame[3][2] == 2);
  CHECK("a normal", sg_known_surface_normal(
                        &to, (double[3]){12 + 4 * part, 22 + 2 * part, 33},
                        (double[3]){1, 1, 0}, out));
  CHECK("is across", fabs(out[0] - 1 / sqrt(5)) < 1e-14 &&
                         fabs(out[1] - 2 / sqrt(5)) < 1e-14 && out[2] == 0);
  s.kind = SG_KNOWN_BEZIER; /* all of whose frame are points */
  memset(s.frame, 0, sizeof s.frame);
  sg_known_surface_move(&s, map, &to);
  CHECK("points of a patch", to.frame[1][0] == 10 && to.frame[15][2] == 30);
}

int
main(void)
{
  spheres();
  tapered();
  tori();
  others();
  moves();
  return check_report();
}
