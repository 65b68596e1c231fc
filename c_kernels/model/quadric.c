/* quadric.c -- see quadric.h */
#include "quadric.h"
#include "number/vector.h"

#include <math.h>

void
sg_quadric_add_plane(sg_quadric *q, const double n[3], const double p[3],
                     double weight)
{
  double d = -sg_dot(n, p);
  const double h[4] = {n[0], n[1], n[2], d};
  int m = 0;

  for (int i = 0; i < 4; i++) {
    for (int k = i; k < 4; k++) {
      q->at[m++] += weight * h[i] * h[k];
    }
  }
}

void
sg_quadric_add(sg_quadric *to, const sg_quadric *q)
{
  for (int m = 0; m < SG_QUADRIC; m++) {
    to->at[m] += q->at[m];
  }
  to->area += q->area;
}

double
sg_quadric_value(const sg_quadric *q, const double p[3])
{
  const double *m = q->at, x = p[0], y = p[1], z = p[2];

  return fabs(x * (m[0] * x + 2 * (m[1] * y + m[2] * z + m[3])) +
              y * (m[4] * y + 2 * (m[5] * z + m[6])) +
              z * (m[7] * z + 2 * m[8]) + m[9]);
}

void
sg_quadric_least(const sg_quadric *q, const double near[3], double out[3])
{
  const double *m = q->at;
  double e = 1e-3 * (m[0] + m[4] + m[7]) + 1e-300;
  double a[3][3] = {
      {m[0] + e, m[1], m[2]}, {m[1], m[4] + e, m[5]}, {m[2], m[5], m[7] + e}};
  double b[3] = {e * near[0] - m[3], e * near[1] - m[6], e * near[2] - m[8]};

  for (int i = 0; i < 3; i++) { /* positive definite: no pivots */
    for (int r = i + 1; r < 3; r++) {
      double f = a[r][i] / a[i][i];
      for (int k = i; k < 3; k++) {
        a[r][k] -= f * a[i][k];
      }
      b[r] -= f * b[i];
    }
  }
  for (int i = 2; i >= 0; i--) {
    for (int k = i + 1; k < 3; k++) {
      b[i] -= a[i][k] * out[k];
    }
    out[i] = b[i] / a[i][i];
  }
}
