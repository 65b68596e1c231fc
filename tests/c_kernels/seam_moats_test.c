/* seam_moats_test.c -- moats on graphs by hand. */
#include "../check.h"

#include "../../c_kernels/seam_moats.h"

#include <math.h>

enum { MOST = 8 };

static bool
stop(void *data)
{
  return --*(int *)data < 0;
}

/* The width of all moats along a path of n + 1 vertices; NAN: it did not end
 * after many meetings. */
static double
width_along(size_t n, const double *length, double *bent)
{
  bool border[MOST + 1] = {false};
  sg_joint joint[MOST];
  int polls = 3;
  double width = NAN;
  bool stopped;

  for (size_t i = 0; i < n; i++) {
    joint[i] =
        (sg_joint){.vertex = {(int32_t)i, (int32_t)i + 1}, .length = length[i]};
  }
  sg_bent_vertices of = {n + 1, bent, border};
  sg_joints joints = {.n = n, .joint = joint};
  bool good = sg_moats_grow(&of, &joints, true, &(sg_poll){stop, &polls},
                            &width, &stopped);

  return good ? width : NAN;
}

/* Two moats fill the way between two vertices that balance. */
static void
check_pair(void)
{
  double turn = 2 * acos(-1.0), bent[2] = {turn, turn}, length[1] = {3};

  CHECK("all of the way", fabs(width_along(1, length, bent) - 3) < 1e-9);
  bent[1] = 0;
  CHECK("but one, which never ends, has no more to meet",
        fabs(width_along(1, length, bent) - 3) < 1e-9);
}

/* A short joint between vertices that are flat is met when a moat that has
 * grown for long comes there. */
static void
check_late_meetings(void)
{
  double turn = acos(-1.0);
  unsigned wrong = 0;

  for (int i = 1; i <= 1000; i++) {
    double length[4] = {1000.0 + 0.1 * i, 1e-7 * i, 1e-9 * i, 1000.0 / i};
    double bent[5] = {turn, 0, 0, 0, 3 * turn};
    double way = length[0] + length[1] + length[2] + length[3];

    wrong += !(fabs(width_along(4, length, bent) - way) < 1e-9 * way);
  }
  CHECK("the whole way is filled", wrong == 0);
}

static void
check_balance(void)
{
  double turns = 4 * acos(-1.0);

  CHECK("flat", sg_bends_balance(0));
  CHECK("a closed shell", sg_bends_balance(turns));
  CHECK("three whole turns round a vertex", sg_bends_balance(-turns));
  CHECK("a cone", !sg_bends_balance(turns / 3));
  CHECK("two whole turns less", !sg_bends_balance(turns / 2));
}

int
main(void)
{
  check_pair();
  check_late_meetings();
  check_balance();
  return check_report();
}
