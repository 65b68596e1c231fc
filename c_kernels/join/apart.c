#include "apart.h"

#include "number/bounds.h"
#include "number/vector.h"

#include <float.h>
#include <math.h>

static const double FAR = 4; /* reaches */

/* Of a height: its rounding errors are below 2^-47 of the product of the
 * largest coordinates of three vectors, two sides and the way to a corner: 42
 * times 2^-53. */
static const double ERROR = 0x1p-46;

static double
largest(const double v[3])
{
  return sg_larger(fabs(v[0]), sg_larger(fabs(v[1]), fabs(v[2])));
}

void
sg_apart_make(const double corner[3][3], double reach, sg_apart *out)
{
  double u[3], w[3];

  out->box = sg_box_none();
  for (int i = 0; i < 3; i++) {
    sg_box_add(&out->box, corner[i]);
    out->from[i] = corner[0][i];
  }
  sg_minus(corner[1], corner[0], u);
  sg_minus(corner[2], corner[0], w);
  sg_cross(u, w, out->n);

  /* The length of n is off by less. DBL_MIN is what underflow takes. */
  double error = ERROR * largest(u) * largest(w);

  out->limit = FAR * reach * (1 + ERROR) * (sg_length(out->n) + error);
  out->limit += 4 * DBL_MIN;
  out->slack = error + 4 * DBL_MIN;
}

bool
sg_apart_by_plane(const sg_apart *of, const double *const other[3])
{
  bool above = false;

  for (int i = 0; i < 3; i++) {
    double way[3];

    sg_minus(other[i], of->from, way);
    double height = sg_dot(of->n, way);
    double beyond = of->limit + of->slack * largest(way);

    if (!(fabs(height) > beyond && fabs(height) <= DBL_MAX) ||
        (i > 0 && above != (height > 0))) {
      return false;
    }
    above = height > 0;
  }
  return true;
}
