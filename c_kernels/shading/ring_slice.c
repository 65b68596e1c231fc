/* ring_slice.c -- what the plane of a scan line cuts out of a torus: a curve
 * A^2 = 4 B W. The line of sight at t meets it where a quartic is 0. How often
 * can change only where the discriminant of the quartic, of degree 12 in t, is
 * 0: such places are told apart by the signs of its Bernstein coefficients, and
 * between two of them the middle says what is there. A place too many does no
 * harm.
 */
#include "shading_private.h"

#include "engine/search.h"

#include <math.h>

/* Parts of a dot: places nearer to one another are one. */
#define ONE_PLACE 2048.0

/* Parts of a dot: a place is found no better. */
#define PLACED 1e9

enum { PLACES = 64, STEPS = 256, CHORDS = 4 };

/* Of what is between two places the parts at whose ends roots are counted; how
 * often their number may change in one of them. */
enum { PARTS = 8, COUNTS = 3 };

sg_ring_line
sg_ring_line_of(const sg_shading_torus *torus, double y)
{
  sg_ring_line out = {
      .x = torus->at[0], .z = torus->at[2], .size = torus->size};
  double v = (y - torus->at[1]) / torus->size;

  for (int i = 0; i < 3; i++) {
    const double *q = torus->form[i];
    double *f = out.form[i];

    f[0] = q[0];
    f[1] = q[4];
    f[2] = q[2];
    f[3] = q[3] * v + q[6];
    f[4] = q[5] * v + q[8];
    f[5] = (q[1] * v + q[7]) * v + q[9];
  }
  return out;
}

/* A^2 - 4 B W of polynomials of degree 2. */
static void
quartic_of(double r[3][3], double c[5])
{
  const double *a = r[0], *b = r[1], *w = r[2];

  c[0] = a[0] * a[0] - 4.0 * b[0] * w[0];
  c[1] = 2.0 * a[0] * a[1] - 4.0 * (b[0] * w[1] + b[1] * w[0]);
  c[2] = 2.0 * a[0] * a[2] + a[1] * a[1] -
         4.0 * (b[0] * w[2] + b[1] * w[1] + b[2] * w[0]);
  c[3] = 2.0 * a[1] * a[2] - 4.0 * (b[1] * w[2] + b[2] * w[1]);
  c[4] = a[2] * a[2] - 4.0 * b[2] * w[2];
}

void
sg_ring_quartic(const sg_ring_line *line, double t, double c[5])
{
  double r[3][3];

  for (int i = 0; i < 3; i++) {
    const double *f = line->form[i];

    r[i][0] = (f[0] * t + f[3]) * t + f[5];
    r[i][1] = f[1] * t + f[4];
    r[i][2] = f[2];
  }
  quartic_of(r, c);
}

/* A form at two places, and between them: coefficients of u^0, u^1 and u^2. */
static void
form_along(const double f[6], const double p[2], const double q[2],
           double out[3])
{
  out[0] = (f[0] * p[0] + f[1] * p[1] + f[3]) * p[0] +
           (f[2] * p[1] + f[4]) * p[1] + f[5];
  out[2] = (f[0] * q[0] + f[1] * q[1] + f[3]) * q[0] +
           (f[2] * q[1] + f[4]) * q[1] + f[5];
  out[1] = 2.0 * (f[0] * p[0] * q[0] + f[2] * p[1] * q[1] + f[5]) +
           f[1] * (p[0] * q[1] + p[1] * q[0]) + f[3] * (p[0] + q[0]) +
           f[4] * (p[1] + q[1]);
}

void
sg_ring_along(const sg_ring_line *line, const double from[2],
              const double to[2], double c[5])
{
  double r[3][3], p[2], q[2];

  p[0] = (from[0] - line->x) / line->size;
  p[1] = (from[1] - line->z) / line->size;
  q[0] = (to[0] - line->x) / line->size;
  q[1] = (to[1] - line->z) / line->size;
  for (int i = 0; i < 3; i++) {
    form_along(line->form[i], p, q, r[i]);
  }
  quartic_of(r, c);
}

double
sg_ring_depth(const sg_slice *s, double x)
{
  const sg_ring_line *line = s->line;
  double t = (x - line->x) / line->size, c[5];

  sg_ring_quartic(line, t < s->e ? s->e : t > s->f ? s->f : t, c);
  return line->z + line->size * sg_quartic_place(c, (sg_quartic_root)s->arc);
}

/* ---- where it changes ---- */

typedef struct places {
  const sg_ring_line *line;
  double at[PLACES], noise;
  int n;
  bool unclear; /* somewhere the discriminant may be 0 or not */
} places;

static void
add_place(places *all, double t)
{
  if (all->n < PLACES) {
    all->at[all->n++] = t;
  }
}

static void
sort_places(places *all)
{
  SG_SORT_FEW(double, all->at, (size_t)all->n, *x > *y);
}

static double
discriminant_at(const sg_ring_line *line, double t)
{
  double c[5];

  sg_ring_quartic(line, t, c);
  return sg_quartic_discriminant(c);
}

/* The one place between two where the sign changes, by chords (Illinois); where
 * some of these have left more than half, by half. */
static double
place_between(places *all, double low, double high)
{
  const sg_ring_line *line = all->line;
  double f = discriminant_at(line, low), g = discriminant_at(line, high);
  double near = 1.0 / (line->size * PLACED);
  double left = high - low;
  int side = 0;

  if ((f < 0) == (g < 0)) {
    all->unclear = true;
    return fabs(f) < fabs(g) ? low : high;
  }
  for (int i = 0; i < STEPS && high - low > near; i++) {
    double t = low + (high - low) * (f / (f - g));
    if (i % CHORDS == CHORDS - 1) {
      t = high - low > left / 2 ? (low + high) / 2 : t;
      left = high - low;
    }
    t = t > low && t < high ? t : (low + high) / 2;
    double h = discriminant_at(line, t);

    if ((h < 0) == (f < 0)) {
      low = t;
      f = h;
      g = side == 1 ? g / 2 : g;
      side = 1;
    } else {
      high = t;
      g = h;
      f = side == -1 ? f / 2 : f;
      side = -1;
    }
  }
  return low + (high - low) * (f / (f - g));
}

/* How often the signs of the coefficients change, 2: at least; -1: all are
 * noise. */
static int
changes_of(places *all, const sg_polynomial *p)
{
  double noise = all->noise;
  int changes = -1, last = 0;

  for (int k = 0; k <= p->n; k++) {
    int sign = (p->c[k] > noise) - (p->c[k] < -noise);
    if (sign == 0) {
      all->unclear = true;
    } else {
      changes += last == -sign || changes < 0;
      last = sign;
    }
  }
  return changes < 2 ? changes : 2;
}

/* The two halves of what a polynomial is between 0 and 1 (de Casteljau). */
static void
halve(const sg_polynomial *p, sg_polynomial half[2])
{
  half[0] = half[1] = *p;
  for (int k = 1; k <= p->n; k++) {
    for (int i = p->n; i >= k; i--) {
      half[0].c[i] = (half[0].c[i] + half[0].c[i - 1]) / 2;
    }
    half[1].c[p->n - k] = half[0].c[p->n];
  }
}

static void
find_places(places *all, const sg_polynomial *p, double low, double high)
{
  int changes = changes_of(all, p);
  double middle = (low + high) / 2;

  if (changes <= 0) {
    return;
  }
  if (changes == 1) {
    add_place(all, place_between(all, low, high));
  } else if ((high - low) * all->line->size * ONE_PLACE < 1.0) {
    add_place(all, middle);
  } else {
    sg_polynomial half[2];

    halve(p, half);
    find_places(all, &half[0], low, middle);
    if (fabs(half[1].c[0]) <= all->noise) {
      add_place(all, middle);
    }
    find_places(all, &half[1], middle, high);
  }
}

/* The coefficients of A, B and W by powers of z, along t. */
static void
forms_between(const sg_ring_line *line, double low, double high,
              sg_polynomial r[3][3])
{
  for (int i = 0; i < 3; i++) {
    const double *f = line->form[i];

    r[i][2] = (sg_polynomial){.n = 0, .c = {f[2]}};
    r[i][1] =
        (sg_polynomial){.n = 1, .c = {f[1] * low + f[4], f[1] * high + f[4]}};
    r[i][0] = (sg_polynomial){
        .n = 2,
        .c = {(f[0] * low + f[3]) * low + f[5],
              2.0 * (f[0] * low * high + f[5]) + f[3] * (low + high),
              (f[0] * high + f[3]) * high + f[5]}};
  }
}

/* The discriminant between two places. */
static void
discriminant_between(places *all, double low, double high, sg_polynomial *out)
{
  sg_polynomial r[3][3], c[5], product;

  forms_between(all->line, low, high, r);
  for (int k = 0; k < 5; k++) {
    c[k] = (sg_polynomial){.n = 4 - k};
  }
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      sg_polynomial_times(&r[0][i], &r[0][k], &product);
      sg_polynomial_add(&c[i + k], 1.0, &product);
      sg_polynomial_times(&r[1][i], &r[2][k], &product);
      sg_polynomial_add(&c[i + k], -4.0, &product);
    }
  }
  sg_discriminant_along(c, out, &all->noise);
}

/* ---- where it is counted ---- */

static int
count_at(const sg_ring_line *line, double t)
{
  double c[5];

  sg_ring_quartic(line, t, c);
  return sg_quartic_count(c);
}

/* Between two places with other counts one where the count of the first one
 * ends. */
static double
count_ends(const sg_ring_line *line, double low, double high)
{
  double near = 1.0 / (line->size * PLACED);
  int count = count_at(line, low);

  for (int i = 0; i < STEPS && high - low > near; i++) {
    double middle = (low + high) / 2;
    *(count_at(line, middle) == count ? &low : &high) = middle;
  }
  return high;
}

static void
count_between(places *all, double low, double high)
{
  const sg_ring_line *line = all->line;
  double apart = 1.0 / (line->size * ONE_PLACE);
  double from = low + apart, part = (high - low - 2 * apart) / PARTS;
  int count = part > 0 ? count_at(line, from) : 0;

  for (int i = 1; i <= PARTS && part > 0; i++) {
    double to = low + apart + i * part;
    int next = count_at(line, to);
    for (int k = 0; k < COUNTS && count != next; k++) {
      from = count_ends(line, from, to);
      add_place(all, from);
      from = fmin(from + apart, to);
      count = count_at(line, from);
    }
    from = to;
    count = next;
  }
}

/* Where the circle in the middle of the tube goes through the plane of the line
 * at y, or comes nearest to it, it is inside. */
static void
add_inside(places *all, const sg_shading_torus *torus, double y)
{
  double form[3], square = 0.0;

  for (int i = 0; i < 3; i++) {
    const double *p = torus->circle[i];
    form[i] = p[1] - (y - torus->at[1]) * p[2];
  }
  square = form[0] * form[0] + form[1] * form[1];
  if (square > 0) {
    double half = -form[2] / sqrt(square);
    double other = sqrt(fmax(0.0, 1.0 - half * half));
    half = fmax(-1.0, fmin(1.0, half));
    for (int way = -1; way <= 1; way += 2) {
      double c = (half * form[0] - way * other * form[1]) / sqrt(square);
      double s = (half * form[1] + way * other * form[0]) / sqrt(square);
      double x[2];
      for (int k = 0; k < 2; k++) {
        x[k] = c * torus->circle[0][2 * k] + s * torus->circle[1][2 * k] +
               torus->circle[2][2 * k];
      }
      add_place(all, x[0] / x[1] / torus->size);
    }
  }
}

static void
count_places(places *all, const sg_shading_torus *torus, double y)
{
  add_inside(all, torus, y);
  sort_places(all);
  for (int i = 0, n = all->n; i + 1 < n; i++) {
    count_between(all, all->at[i], all->at[i + 1]);
  }
}

/* ---- slices ---- */

static bool
add_roots(sg_shading_work *w, sg_slice *slice, const sg_ring_sheets *sheets)
{
  for (int i = 0; i < sheets->count; i++) {
    slice->arc = (int8_t)sg_ring_root(i, sheets->count);
    slice->sense = i % 2 == 0 ? 1 : -1;
    slice->sheet = sheets->of[i];
    if (!SG_PUSH(w->slice, *slice)) {
      w->failed = true;
      return false;
    }
  }
  return true;
}

bool
sg_ring_over(sg_shading_work *w, const sg_shading_body *body, double x,
             double y)
{
  const sg_shading *s = w->scene;
  sg_ring_line line =
      sg_ring_line_of(&s->torus.item[s->surface.item[body->surface].of], y);
  sg_slice slice = {.x1 = (int32_t)(x * 256.0),
                    .leaf = body->leaf,
                    .surface = body->surface,
                    .face = body->face,
                    .x0 = x};
  double c[5];

  slice.x2 = slice.x1 + 1;
  sg_ring_quartic(&line, (x - line.x) / line.size, c);
  for (int i = 0, count = sg_quartic_count(c); i < count; i++) {
    slice.sense = i % 2 == 0 ? 1 : -1;
    slice.a = line.z + line.size * sg_quartic_place(c, sg_ring_root(i, count));
    if (!SG_PUSH(w->slice, slice)) {
      w->failed = true;
      return false;
    }
  }
  return true;
}

bool
sg_ring_slices(sg_shading_work *w, const sg_shading_body *body, double y)
{
  const sg_shading *s = w->scene;
  uint32_t torus = s->surface.item[body->surface].of;
  sg_ring_line *line = &w->line[torus];
  places all = {.line = line};
  sg_ring_sheets sheets = {0};
  sg_polynomial p;

  *line = sg_ring_line_of(&s->torus.item[torus], y);
  double low = (body->low[0] - line->x) / line->size;
  double high = (body->high[0] - line->x) / line->size;
  discriminant_between(&all, low, high, &p);
  add_place(&all, low);
  find_places(&all, &p, low, high);
  add_place(&all, high);
  if (all.unclear) {
    count_places(&all, &s->torus.item[torus], y);
  }
  sort_places(&all);
  for (int i = 0; i + 1 < all.n; i++) {
    sg_slice slice = {.x1 = sg_slice_end(w, line->x + line->size * all.at[i]),
                      .x2 =
                          sg_slice_end(w, line->x + line->size * all.at[i + 1]),
                      .leaf = body->leaf,
                      .surface = body->surface,
                      .face = body->face,
                      .round = true,
                      .line = line,
                      .e = all.at[i],
                      .f = all.at[i + 1]};
    double from[5], c[5];

    sg_ring_quartic(line, slice.e, from);
    sg_ring_quartic(line, (slice.e + slice.f) / 2, c);
    sg_ring_sheets_change(&sheets, from, sg_quartic_count(c));
    if (slice.x1 < slice.x2 && !add_roots(w, &slice, &sheets)) {
      return false;
    }
  }
  return true;
}
