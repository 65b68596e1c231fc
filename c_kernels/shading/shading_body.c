/* shading_body.c -- pieces of quadrics, seen in the picture. */
#include "number/vector.h"
#include "shading_private.h"

#include <math.h>
#include <string.h>

/* What a plane has less of along both axes of a scan line is level. */
#define LEVEL 1e-9

static void
see_column(const sg_shading *s, const double p[3], double one, double out[4])
{
  for (int i = 0; i < 4; i++) {
    const double *m = s->frame.matrix[i];
    out[i] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3] * one;
  }
}

/* Gauss and Jordan, the largest pivot first. */
bool
sg_shading_invert(double a[4][8])
{
  for (int c = 0; c < 4; c++) {
    int best = c;

    for (int r = c + 1; r < 4; r++) {
      best = fabs(a[r][c]) > fabs(a[best][c]) ? r : best;
    }
    if (!(fabs(a[best][c]) > 0)) {
      return false;
    }
    for (int k = 0; k < 8; k++) {
      double other = a[c][k];
      a[c][k] = a[best][k];
      a[best][k] = other;
    }
    for (int r = 0; r < 4; r++) {
      double part = a[r][c] / a[c][c];
      for (int k = 0; k < 8 && r != c; k++) {
        a[r][k] -= part * a[c][k];
      }
    }
  }
  for (int r = 0; r < 4; r++) {
    for (int k = 4; k < 8; k++) {
      a[r][k] /= a[r][r];
    }
  }
  return true;
}

bool
sg_shading_see_frame(const sg_shading *s, const double frame[4][3],
                     sg_seen_frame *out)
{
  double a[4][8] = {{0}};

  for (int i = 0; i < 4; i++) {
    see_column(s, frame[(i + 1) % 4], i == 3 ? 1.0 : 0.0, out->column[i]);
  }
  if (!(out->column[3][3] > 0)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    out->at[k] = out->column[3][k] / out->column[3][3];
  }
  for (int i = 0; i < 4; i++) {
    for (int k = 0; k < 3; k++) {
      out->column[i][k] -= out->at[k] * out->column[i][3];
    }
    for (int k = 0; k < 4; k++) {
      a[k][i] = out->column[i][k];
    }
    a[i][4 + i] = 1.0;
  }
  for (int k = 0; k < 3; k++) { /* where it is by definition */
    out->column[3][k] = a[k][3] = 0.0;
  }
  if (!sg_shading_invert(a)) {
    return false;
  }
  for (int i = 0; i < 4; i++) {
    memcpy(out->row[i].c, &a[i][4], sizeof out->row[i].c);
  }
  return true;
}

/* ---- the quadric ---- */

void
sg_add_square(double q[10], const sg_linear_form *f, double part)
{
  const double *c = f->c;

  for (int k = 0; k < 3; k++) {
    q[k] += part * c[k] * c[k];
    q[6 + k] += part * 2 * c[k] * c[3];
  }
  q[3] += part * 2 * c[0] * c[1];
  q[4] += part * 2 * c[0] * c[2];
  q[5] += part * 2 * c[1] * c[2];
  q[9] += part * c[3] * c[3];
}

static sg_linear_form
combined(const sg_linear_form *a, double part, const sg_linear_form *b)
{
  sg_linear_form out;

  for (int k = 0; k < 4; k++) {
    out.c[k] = a->c[k] + part * b->c[k];
  }
  return out;
}

static uint32_t
add_quadric(sg_shading *s, const sg_shading_piece *piece,
            const sg_seen_frame *f)
{
  sg_shading_surface surface = {.kind = SG_IS_QUADRIC,
                                .of = (uint32_t)s->quadric.n};
  sg_shading_quadric out = {.at = {0}};
  sg_linear_form radius = combined(&f->row[3], piece->k - 1.0, &f->row[2]);
  double size = 0.0;

  memcpy(out.at, f->at, sizeof out.at);
  sg_add_square(out.q, &f->row[0], 1.0);
  sg_add_square(out.q, &f->row[1], 1.0);
  if (piece->sphere) {
    sg_add_square(out.q, &f->row[2], 1.0);
    sg_add_square(out.q, &f->row[3], -1.0);
  } else {
    sg_add_square(out.q, &radius, -1.0);
  }
  for (int k = 0; k < 6; k++) {
    size += fabs(out.q[k]);
  }
  for (int k = 0; k < 10 && size > 0; k++) {
    out.q[k] /= size;
  }
  return SG_PUSH(s->quadric, out) && SG_PUSH(s->surface, surface)
             ? (uint32_t)(s->surface.n - 1)
             : UINT32_MAX;
}

/* ---- its planes ---- */

/* Adds the plane of a form, which is 0 or more inside; a level one bounds the
 * lines instead. False: no memory. */
static bool
add_bound(sg_shading *s, const sg_seen_frame *f, const sg_linear_form *bound,
          int32_t face, sg_shading_body *body)
{
  double length = sg_any_length(bound->c), from[3], q[4];
  const double *c = bound->c;
  bool turned = c[2] < 0 || (c[2] == 0 && (c[0] < 0));

  for (int k = 0; k < 3; k++) {
    q[k] = c[k] / length * (turned ? -1 : 1);
  }
  sg_minus(s->middle, f->at, from);
  q[3] = sg_dot(q, from) + c[3] / length * (turned ? -1 : 1);
  if (fabs(q[0]) < LEVEL && fabs(q[2]) < LEVEL) {
    double y = nearbyint((f->at[1] - c[3] / c[1]) * SG_SNAP) / SG_SNAP;
    *(c[1] > 0 ? &body->y1 : &body->y2) =
        c[1] > 0 ? fmax(body->y1, y) : fmin(body->y2, y);
    return true;
  }
  uint32_t plane = sg_shading_add_plane(s, q);
  if (plane == UINT32_MAX) {
    return false;
  }
  body->bound[body->bounds++] = (sg_shading_bound){
      .surface = plane, .face = face, .sense = turned ? -1.0 : 1.0};
  return true;
}

/* ---- where it is ---- */

/* Widens a range by where planes of coordinate `axis` touch what the vectors
 * v[n], turned round c, make, a circle or a sphere: at k, where the sum of
 * (v - k v')^2 is (c - k c')^2, v' and c' being their fourth coordinates. */
typedef struct round_shape {
  double v[3][4], c[4];
  int n;
} round_shape;

/* False: it reaches the plane of the eye. */
static bool
touched(const round_shape *shape, int axis, double end[2])
{
  const double *c = shape->c;
  double a = -c[3] * c[3], b = -c[axis] * c[3], d = -c[axis] * c[axis];

  for (int i = 0; i < shape->n; i++) {
    const double *v = shape->v[i];
    a += v[3] * v[3];
    b += v[axis] * v[3];
    d += v[axis] * v[axis];
  }
  double root = sqrt(fmax(b * b - a * d, 0.0));
  end[0] = (b + root) / a;
  end[1] = (b - root) / a;
  return a < 0;
}

/* The circle of a piece at h. */
static round_shape
ring(const sg_seen_frame *f, const sg_shading_piece *piece, double h)
{
  double r =
      piece->sphere ? sqrt(fmax(1.0 - h * h, 0.0)) : 1.0 - h + h * piece->k;
  round_shape out = {.n = 2};

  for (int k = 0; k < 4; k++) {
    out.v[0][k] = r * f->column[0][k];
    out.v[1][k] = r * f->column[1][k];
    out.c[k] = f->column[3][k] + h * f->column[2][k];
  }
  return out;
}

/* Where the plane that touches the sphere at `end` does so, along its axis. */
static double
height_of_touch(const sg_seen_frame *f, int axis, double end)
{
  return -(f->column[2][axis] - end * f->column[2][3]) /
         (f->column[3][axis] - end * f->column[3][3]);
}

static bool
reach_of_sphere(const sg_seen_frame *f, const sg_shading_piece *piece, int axis,
                double end[2])
{
  round_shape sphere = {.n = 3};
  double rim[2];

  memcpy(sphere.v, f->column, sizeof sphere.v);
  memcpy(sphere.c, f->column[3], sizeof sphere.c);
  if (!touched(&sphere, axis, end)) {
    return false;
  }
  for (int i = 0; i < 2; i++) {
    double h = height_of_touch(f, axis, end[i]);
    bool low = piece->low_face >= 0 && h < piece->low;
    if (low || (piece->high_face >= 0 && h > piece->high)) {
      round_shape edge = ring(f, piece, low ? piece->low : piece->high);
      (void)touched(&edge, axis, rim); /* it is in the sphere */
      end[i] = rim[i];
    }
  }
  return true;
}

/* From end[0] to end[1] in the picture. False: it reaches the eye's plane. */
static bool
reach_of(const sg_seen_frame *f, const sg_shading_piece *piece, int axis,
         double end[2])
{
  double other[2];

  if (piece->sphere) {
    if (!reach_of_sphere(f, piece, axis, end)) {
      return false;
    }
  } else {
    round_shape low = ring(f, piece, piece->low);
    round_shape high = ring(f, piece, piece->high);
    if (!touched(&low, axis, end) || !touched(&high, axis, other)) {
      return false;
    }
    end[0] = fmin(end[0], other[0]);
    end[1] = fmax(end[1], other[1]);
  }
  end[0] += f->at[axis];
  end[1] += f->at[axis];
  return true;
}

/* ---- pieces ---- */

sg_shading_end
sg_shading_add_piece(sg_shading *s, const sg_shading_piece *piece)
{
  sg_shading_body body = {.leaf = (uint32_t)(s->leaf.n - 1),
                          .face = piece->face};
  sg_seen_frame f = {0};
  double end[2];

  if (!sg_shading_see_frame(s, piece->frame, &f)) {
    return SG_SHADING_BEHIND_EYE;
  }
  for (int k = 0; k < 3; k++) {
    if (!reach_of(&f, piece, k, end)) {
      return SG_SHADING_BEHIND_EYE;
    }
    s->low[k] = fmin(s->low[k], end[0]);
    s->high[k] = fmax(s->high[k], end[1]);
    body.low[k] = end[0];
    body.high[k] = end[1];
    body.y1 = k == 1 ? nearbyint(end[0] * SG_SNAP) / SG_SNAP : body.y1;
    body.y2 = k == 1 ? nearbyint(end[1] * SG_SNAP) / SG_SNAP : body.y2;
  }
  sg_linear_form low = combined(&f.row[2], -piece->low, &f.row[3]);
  sg_linear_form high = combined(&f.row[2], -piece->high, &f.row[3]);
  for (int k = 0; k < 4; k++) {
    high.c[k] = -high.c[k];
  }
  body.surface = add_quadric(s, piece, &f);
  if (body.surface == UINT32_MAX ||
      (piece->low_face >= 0 &&
       !add_bound(s, &f, &low, piece->low_face, &body)) ||
      (piece->high_face >= 0 &&
       !add_bound(s, &f, &high, piece->high_face, &body))) {
    return SG_SHADING_NO_MEMORY;
  }
  if (s->body.n > 0 && s->body.item[s->body.n - 1].leaf == body.leaf) {
    s->body.item[s->body.n - 1].more = true;
  }
  s->leaf.item[body.leaf].round = true;
  return SG_PUSH(s->body, body) ? SG_SHADING_GOOD : SG_SHADING_NO_MEMORY;
}
