/* hide.c -- see hide.h */
#include "hide.h"

#include "number/bounds.h"

#include <math.h>
#include <stdlib.h>

/* ---------------------------------------------------------- one triangle */

/* How far p is to the left of side a-b. */
static double
left_of(const double a[3], const double b[3], const double p[3])
{
  double x = b[0] - a[0], y = b[1] - a[1];

  return (x * (p[1] - a[1]) - y * (p[0] - a[0])) / sqrt(x * x + y * y);
}

static double
snap(double x, double tolerance)
{
  return fabs(x) <= tolerance ? 0.0 : x;
}

/* Keeps the part from t[0] to t[1] where a value that runs linearly from f0 at
 * 0 to f1 at 1 is not negative. False: nothing, or a point only. */
static bool
keep(double f0, double f1, double t[2])
{
  if ((f0 < 0.0 && f1 <= 0.0) || (f0 <= 0.0 && f1 < 0.0)) {
    return false;
  }
  if (f0 < 0.0) {
    t[0] = sg_larger(t[0], f0 / (f0 - f1));
  }
  if (f1 < 0.0) {
    t[1] = sg_smaller(t[1], f0 / (f0 - f1));
  }
  return t[0] < t[1];
}

/* How far behind the mask's plane the line's point at t is. */
static double
behind(const sg_scene *scene, const sg_scene_mask *mask, const double a[3],
       const double b[3], double t)
{
  const double *corner = scene->at[mask->v[0]];
  double sum = 0.0;

  for (int k = 0; k < 3; k++) {
    sum += mask->normal[k] * (a[k] + t * (b[k] - a[k]) - corner[k]);
  }
  return sum;
}

/* The paper's four cases at once: the overlap P-Q, then the depths there. */
static bool
depth_test(double tolerance, double at_p, double at_q, double t[2])
{
  if (at_p <= tolerance && at_q <= tolerance) {
    return false; /* in front, or equal at both */
  }
  if (at_p < -tolerance) {
    t[0] += (t[1] - t[0]) * (at_p / (at_p - at_q));
  } else if (at_q < -tolerance) {
    t[1] = t[0] + (t[1] - t[0]) * (at_p / (at_p - at_q));
  }
  return t[0] < t[1];
}

static bool
has_corner(const uint32_t corner[3], uint32_t v)
{
  return corner[0] == v || corner[1] == v || corner[2] == v;
}

/* Whether the line runs between two corners of the mask, or of the triangle
 * that it is a part of. */
static bool
is_side(const sg_scene *scene, const sg_scene_line *line,
        const sg_scene_mask *mask)
{
  const sg_scene_model *m = scene->model;
  const int32_t *c = m->dense.corner[mask->triangle];

  if (mask->v[0] < m->dense.vertices) {
    return has_corner(mask->v, line->a) && has_corner(mask->v, line->b);
  }
  const uint32_t corner[3] = {m->same[c[0]], m->same[c[1]], m->same[c[2]]};
  return (has_corner(mask->v, line->a) && has_corner(mask->v, line->b)) ||
         (has_corner(corner, line->a) && has_corner(corner, line->b));
}

/* Whether the line lies on the triangle, as the model has it: as its side, as
 * an edge of its polygon, or as is said of it. */
static bool
lies_on(const sg_scene *scene, const sg_scene_line *line,
        const sg_scene_mask *mask)
{
  size_t k = (size_t)(line - scene->line);

  if (is_side(scene, line, mask)) {
    return true;
  }
  if (scene->lies_begin) {
    for (uint32_t i = scene->lies_begin[k]; i < scene->lies_begin[k + 1]; i++) {
      if (scene->lies_on[i] == mask->triangle) {
        return true;
      }
    }
  }
  return line->number != UINT32_MAX &&
         sg_scene_lies_on(scene->model, line->number,
                          scene->model->dense.polygon_of[mask->triangle]);
}

static bool
apart(const sg_scene *scene, const sg_scene_mask *mask, const double a[3],
      const double b[3])
{
  double e = scene->close;

  return sg_larger(a[0], b[0]) < mask->low[0] - e ||
         sg_smaller(a[0], b[0]) > mask->high[0] + e ||
         sg_larger(a[1], b[1]) < mask->low[1] - e ||
         sg_smaller(a[1], b[1]) > mask->high[1] + e;
}

/* The part of line a-b that the mask's three sides keep. */
static bool
covered(const sg_scene *scene, const sg_scene_mask *mask, const double a[3],
        const double b[3], double t[2])
{
  double(*at)[3] = scene->at;
  double e = scene->close;

  t[0] = 0.0;
  t[1] = 1.0;
  for (int k = 0; k < 3; k++) {
    const double *p = at[mask->v[k]], *q = at[mask->v[(k + 1) % 3]];
    if (!keep(snap(left_of(p, q, a), e), snap(left_of(p, q, b), e), t)) {
      return false;
    }
  }
  return true;
}

bool
sg_mask_hides(const sg_scene *scene, const sg_scene_mask *mask,
              const sg_scene_line *line, sg_hidden *out)
{
  const double *a = scene->at[line->a], *b = scene->at[line->b];
  double near = line->look.substitute_outline ? scene->near : 0.0;
  double t[2];

  if (sg_line_far_end(scene, line) <= mask->low[2] ||
      apart(scene, mask, a, b) || lies_on(scene, line, mask) ||
      !covered(scene, mask, a, b, t) ||
      !depth_test(scene->tolerance, near + behind(scene, mask, a, b, t[0]),
                  near + behind(scene, mask, a, b, t[1]), t)) {
    return false;
  }
  out->from = t[0];
  out->to = t[1];
  return true;
}

bool
sg_mask_covers(const sg_scene *scene, const sg_scene_mask *mask,
               const sg_scene_line *line, sg_cover *out)
{
  const double *a = scene->at[line->a], *b = scene->at[line->b];
  double t[2];

  if (!covered(scene, mask, a, b, t)) {
    return false;
  }
  *out = (sg_cover){.from = t[0], .to = t[1]};
  for (int k = 0; k < 2; k++) {
    out->behind[k] = behind(scene, mask, a, b, t[k]) / mask->normal[2];
  }
  return true;
}

/* ------------------------------------------------------------- two lines */

double
sg_line_length(const sg_scene *scene, const sg_scene_line *line)
{
  const double *a = scene->at[line->a], *b = scene->at[line->b];
  double x = b[0] - a[0], y = b[1] - a[1];

  return sqrt(x * x + y * y);
}

static double
between(double x, double y, double t)
{
  return x + t * (y - x);
}

/* The part of line p-q that is nearer than what is near to line r-s, across
 * it, if it runs along it more than across. */
static bool
near_part(const sg_scene *scene, const double p[3], const double q[3],
          const double r[3], const double s[3], sg_overlap *out)
{
  double x = s[0] - r[0], y = s[1] - r[1];
  double square = x * x + y * y, far = scene->near * sqrt(square);
  double off_p = x * (p[1] - r[1]) - y * (p[0] - r[0]);
  double off_q = x * (q[1] - r[1]) - y * (q[0] - r[0]);
  double at_p = x * (p[0] - r[0]) + y * (p[1] - r[1]);
  double at_q = x * (q[0] - r[0]) + y * (q[1] - r[1]);
  double t[2] = {0.0, 1.0};

  if (square <= scene->close * scene->close ||
      fabs(off_q - off_p) > SG_NEAR_TURN * fabs(at_q - at_p) ||
      !keep(at_p, at_q, t) || !keep(square - at_p, square - at_q, t) ||
      !keep(far - off_p, far - off_q, t) ||
      !keep(far + off_p, far + off_q, t)) {
    return false;
  }
  out->from = t[0];
  out->to = t[1];
  out->from2 = between(at_p, at_q, t[0]) / square;
  out->to2 = between(at_p, at_q, t[1]) / square;
  return out->from2 != out->to2;
}

static bool
overlapping_part(const sg_scene *scene, const sg_scene_line *a,
                 const sg_scene_line *b, sg_overlap *out)
{
  const double *p = scene->at[a->a], *q = scene->at[a->b];
  const double *r = scene->at[b->a], *s = scene->at[b->b];
  double x = q[0] - p[0], y = q[1] - p[1];
  double square = x * x + y * y, size = sqrt(square);
  double off_r = x * (r[1] - p[1]) - y * (r[0] - p[0]);
  double off_s = x * (s[1] - p[1]) - y * (s[0] - p[0]);
  double far = scene->close * size; /* off: distance times size */
  double at_r, at_s;

  if ((off_r > far && off_s > far) || (off_r < -far && off_s < -far) ||
      size <= scene->close) {
    return false;
  }
  at_r = (x * (r[0] - p[0]) + y * (r[1] - p[1])) / square;
  at_s = (x * (s[0] - p[0]) + y * (s[1] - p[1])) / square;
  if (fabs(off_s - off_r) > SG_OVERLAP_TURN * fabs(at_s - at_r) * square) {
    return false;
  }
  out->from = sg_larger(0.0, sg_smaller(at_r, at_s));
  out->to = sg_smaller(1.0, sg_larger(at_r, at_s));
  if ((out->to - out->from) * size <= scene->close) {
    return false;
  }
  out->from2 = (out->from - at_r) / (at_s - at_r);
  out->to2 = (out->to - at_r) / (at_s - at_r);
  return fabs(between(off_r, off_s, out->from2)) <= far &&
         fabs(between(off_r, off_s, out->to2)) <= far;
}

bool
sg_lines_overlap(const sg_scene *scene, const sg_scene_line *a,
                 const sg_scene_line *b, sg_overlap *out)
{
  double(*at)[3] = scene->at;

  return sg_line_yields_near(a, b)
             ? near_part(scene, at[a->a], at[a->b], at[b->a], at[b->b], out)
             : overlapping_part(scene, a, b, out);
}
