#include "oriented_box.h"

#include "number/vector.h"

#include <float.h>
#include <math.h>

/* Of the size of numbers, what rounding may take: far more than it does. */
#define ROUNDED 0x1p-40
/* Beyond this nothing is said: products would overflow. */
#define FAR 0x1p+400

/* ---- the axes ---- */

/* Turns the symmetric matrix m so that m[p][q] is 0, and the axes with it. */
static void
turn_away(double m[3][3], double axis[3][3], int p, int q)
{
  double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  double t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
  double c = 1 / sqrt(t * t + 1), s = t * c;
  int r = 3 - p - q;
  double pr = m[p][r], qr = m[q][r], pq = m[p][q];

  m[p][p] -= t * pq;
  m[q][q] += t * pq;
  m[p][q] = m[q][p] = 0;
  m[p][r] = m[r][p] = c * pr - s * qr;
  m[q][r] = m[r][q] = s * pr + c * qr;
  for (int k = 0; k < 3; k++) {
    double u = axis[p][k], w = axis[q][k];

    axis[p][k] = c * u - s * w;
    axis[q][k] = s * u + c * w;
  }
}

/* The principal axes of a symmetric matrix (Jacobi), the largest first. */
static void
find_axes(double m[3][3], double axis[3][3])
{
  enum { SWEEPS = 12 };

  for (int k = 0; k < 3; k++) {
    for (int l = 0; l < 3; l++) {
      axis[k][l] = k == l;
    }
  }
  for (int sweep = 0; sweep < SWEEPS; sweep++) {
    for (int k = 0; k < 3; k++) {
      int p = k == 2, q = k == 0 ? 1 : 2;

      if (fabs(m[p][q]) > DBL_MIN) {
        turn_away(m, axis, p, q);
      }
    }
  }
  int first = m[1][1] > m[0][0] ? 1 : 0;

  first = m[2][2] > m[first][first] ? 2 : first;
  for (int k = 0; k < 3; k++) {
    double was = axis[0][k];

    axis[0][k] = axis[first][k];
    axis[first][k] = was;
  }
}

/* How the points lie about their middle, in units of their size. */
static void
spread(size_t n, sg_oriented_point *at, const void *data,
       const double middle[3], double m[3][3])
{
  double size = 0;

  for (int pass = 0; pass < 2; pass++) {
    for (size_t i = 0; i < n; i++) {
      double p[3], d[3];

      at(data, i, p);
      sg_minus(p, middle, d);
      for (int k = 0; k < 3; k++) {
        size = pass == 0 && fabs(d[k]) > size ? fabs(d[k]) : size;
        for (int l = 0; pass == 1 && size > 0 && l < 3; l++) {
          m[k][l] += d[k] / size * (d[l] / size);
        }
      }
    }
  }
}

void
sg_oriented_box_make(size_t n, sg_oriented_point *at, const void *data,
                     sg_oriented_box *out)
{
  double m[3][3] = {{0}}, middle[3] = {0}, p[3];
  double lo[3] = {INFINITY, INFINITY, INFINITY};
  double hi[3] = {-INFINITY, -INFINITY, -INFINITY};

  for (size_t i = 0; i < n; i++) {
    at(data, i, p);
    for (int k = 0; k < 3; k++) {
      middle[k] += p[k] / (double)n;
    }
  }
  spread(n, at, data, middle, m);
  find_axes(m, out->axis);
  for (size_t i = 0; i < n; i++) {
    double d[3];

    at(data, i, p);
    sg_minus(p, middle, d);
    for (int k = 0; k < 3; k++) {
      double along = sg_dot(out->axis[k], d);
      lo[k] = along < lo[k] ? along : lo[k];
      hi[k] = along > hi[k] ? along : hi[k];
    }
  }
  for (int c = 0; c < 8; c++) {
    for (int k = 0; k < 3; k++) {
      out->corner[c][k] = middle[k];
      for (int l = 0; l < 3; l++) {
        out->corner[c][k] += out->axis[l][k] * (c >> l & 1 ? hi[l] : lo[l]);
      }
    }
  }
}

/* ---- apart ---- */

/* The largest coordinate; infinite: there is one beyond FAR, or no number. */
static double
size_of(const sg_oriented_box *box)
{
  double most = 0;

  for (int i = 0; i < 24; i++) {
    double p = box->corner[i / 3][i % 3];
    double size = fabs(p) < FAR ? fabs(p) : INFINITY; /* NaN too */

    most = size > most ? size : most;
  }
  return most;
}

static void
range_along(const double axis[3], const sg_oriented_box *box, double range[2])
{
  range[0] = INFINITY;
  range[1] = -INFINITY;
  for (int c = 0; c < 8; c++) {
    double along = sg_dot(axis, box->corner[c]);

    range[0] = along < range[0] ? along : range[0];
    range[1] = along > range[1] ? along : range[1];
  }
}

static bool
apart_along(const double axis[3], const sg_oriented_box *a,
            const sg_oriented_box *b, double gap)
{
  double x[2], y[2];

  range_along(axis, a, x);
  range_along(axis, b, y);
  return x[0] - y[1] > gap || y[0] - x[1] > gap;
}

bool
sg_oriented_boxes_apart(const sg_oriented_box *a, const sg_oriented_box *b,
                        double reach)
{
  double gap = reach + ROUNDED * (size_of(a) + size_of(b));

  if (!(gap < FAR)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    if (apart_along(a->axis[k], a, b, gap) ||
        apart_along(b->axis[k], a, b, gap)) {
      return true;
    }
  }
  for (int k = 0; k < 9; k++) { /* across an axis of each */
    double across[3];

    sg_cross(a->axis[k / 3], b->axis[k % 3], across);
    double length = sg_length(across);

    for (int c = 0; c < 3 && length > 0x1p-10; c++) {
      across[c] /= length;
    }
    if (length > 0x1p-10 && apart_along(across, a, b, gap)) {
      return true;
    }
  }
  return false;
}

/* ---- which way triangles run ---- */

void
sg_run_add(sg_run *run, const double t[3][3])
{
  for (int i = 0; i < 3; i++) {
    double e[3];

    sg_minus(t[(i + 1) % 3], t[i], e);
    for (int k = 0; k < 3; k++) {
      for (int l = 0; l < 3; l++) {
        run->sum[k][l] += e[k] * e[l];
      }
    }
  }
}

void
sg_run_end(sg_run *run)
{
  double m[3][3], most = 0;

  for (int k = 0; k < 3; k++) {
    for (int l = 0; l < 3; l++) {
      m[k][l] = run->sum[k][l];
    }
  }
  double all = m[0][0] + m[1][1] + m[2][2];

  find_axes(m, run->axis);
  for (int k = 0; k < 3; k++) {
    most = m[k][k] > most ? m[k][k] : most;
  }
  double straight =
      run->sum[0][0] > run->sum[1][1] ? run->sum[0][0] : run->sum[1][1];

  straight = run->sum[2][2] > straight ? run->sum[2][2] : straight;
  run->askew =
      all < FAR && all - most < all / 64 && straight < most - most / 256;
}
