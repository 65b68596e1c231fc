/* roll_rows_test.c -- a cylinder unrolled through the functions of the doors,
 * without Prolog.
 */
#include "doors/pattern.h"

#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <math.h>
#include <string.h>

static const double PI = 3.141592653589793;

/* Of radius r round the z axis. */
static sg_offset_surface
cylinder(double r)
{
  sg_offset_surface s = {.is = SG_OFFSET_SURFACE_PLAIN};

  s.plain.is = SG_SURFACE_TERM_CYLINDER;
  s.plain.cylinder.c = (sg_xyz){{0, 0, 0}};
  s.plain.cylinder.u = (sg_xyz){{r, 0, 0}};
  s.plain.cylinder.v = (sg_xyz){{0, r, 0}};
  s.plain.cylinder.w = (sg_xyz){{0, 0, 1}};
  return s;
}

static sg_offset_surface
plane(double nz, double d)
{
  sg_offset_surface s = {.is = SG_OFFSET_SURFACE_PLAIN};

  s.plain.is = SG_SURFACE_TERM_PLANE;
  s.plain.plane.nx = s.plain.plane.ny = 0;
  s.plain.plane.nz = nz;
  s.plain.plane.d = d;
  return s;
}

static sg_offset_surface
parallel(const sg_offset_surface *of, double distance)
{
  sg_offset_surface s = {.is = SG_OFFSET_SURFACE_PARALLEL};

  s.parallel.surface = of->plain;
  s.parallel.distance = distance;
  return s;
}

static void
surfaces(void)
{
  sg_offset_surface around = cylinder(2), floor = plane(1, -3);
  sg_offset_surface wider = parallel(&around, 1), none = plane(0, 1);
  sg_offset_surface off = parallel(&floor, 1), both[] = {wider, floor};
  const sg_xyz at = {{0, 5, 1}};
  sg_xyz point = {{0}};
  double t, h, value;

  CHECK_DOOR("place", sg_door_surface_place(&call, &around, &at, &t, &h) &&
                          fabs(t - 90) < 1e-12 && fabs(h - 1) < 1e-12);
  CHECK("of a plane", !sg_door_surface_place(&call, &floor, &at, &t, &h) &&
                          is_domain("ruled_surface", 1));
  CHECK_DOOR("value",
             sg_door_surface_value(&call, &wider, &at, &value, &point) &&
                 fabs(value - 2) < 1e-12 && fabs(point.at[1] - 1) < 1e-12);
  CHECK("no surface",
        !sg_door_surface_value(&call, &none, &at, &value, &point) &&
            is_domain("surface", 1));
  CHECK("parallel to a plane",
        !sg_door_surface_value(&call, &off, &at, &value, &point) &&
            is_domain("developable_surface", 1));
  CHECK_DOOR("they meet",
             sg_door_surfaces_meet(&call, &(sg_offset_surface_list){both, 2, 2},
                                   9, &at, &point) &&
                 fabs(point.at[1] - 3) < 1e-12 &&
                 fabs(point.at[2] - 3) < 1e-12);
  CHECK("of nothing",
        !sg_door_surfaces_meet(&call, &(sg_offset_surface_list){0}, 9, &at,
                               &point) &&
            is_domain("few_surfaces", 1));
}

static void
rolls(void)
{
  sg_roll_fact roll = {cylinder(2), 0, 0};
  sg_offset_surface both[] = {cylinder(2), plane(1, -3)};
  sg_roll_curve_fact rim = {0, {both, 2, 2}, {{2, 0, 3}}, {{-2, 0, 3}}};
  sg_paper_point place = {180, 3};
  sg_paper_point_list points = {0};
  sg_list_roll_place_fact_list lists = {0};

  CHECK_DOOR("points", sg_door_roll_points(&call, &roll,
                                           &(sg_paper_point_list){&place, 1, 1},
                                           &points));
  CHECK("half way round", points.n == 1 &&
                              fabs(fabs(points.at[0].x) - 2 * PI) < 1e-9 &&
                              fabs(points.at[0].y - 3) < 1e-9);
  CHECK_DOOR("curves", sg_door_roll_curves(
                           &call, &roll, 9, 1e-3,
                           &(sg_roll_curve_fact_list){&rim, 1, 1}, &lists));
  CHECK("a rim is straight", lists.n == 1);
  for (size_t i = 0; i < lists.at[0].n; i++) {
    CHECK("on it", fabs(lists.at[0].at[i].y - 3) < 1e-9);
  }
  roll.surface = both[1];
  CHECK("no plane", !sg_door_roll_points(&call, &roll,
                                         &(sg_paper_point_list){0}, &points) &&
                        is_domain("developable_surface", 1));
}

int
main(void)
{
  sg_call_open(&call, NULL, NULL);
  surfaces();
  rolls();
  sg_call_close(&call);
  return check_report();
}
