/* surface_checker.c -- holds drawings against the true surfaces of what they
 * show.
 *
 *     surface_checker PICTURES
 *
 * Written for the tests alone and shares nothing with the engine: it knows
 * balls, rings, blocks and turned polygons by how far a point is from them, and
 * marches along lines of sight. What such a line goes through, one face after
 * the other, is its *view*. Lines of input:
 *
 *     leaf KIND M T N NUMBERS   0 block A B C, 1 ball R, 2 ring R TUBE,
 *                               3 turned R Z R Z ...; the own coordinates of
 *                               p are M (p - T), three rows
 *     tree HOW                  0 union, 1 intersection, 2 the first without
 *                               the others
 *     eye RIGHT UP TOWARDS      unit vectors
 *     round X Y Z R             a ball round all of it
 *     near D                    as near as a line has to be
 *     l VISIBLE OUTLINE X1 Y1 X2 Y2   a line of the drawing, y up; 0 or 1
 *     end NAME
 *
 * For each picture one line:
 *
 *     NAME: length=L false=F outline=O missing=N at=X,Y
 *
 * L: of all lines; F: of those with no reason: where what is seen, or for
 * hidden ones what lies behind that, is the same on both sides, so near; O: of
 * these, that of outlines; N: so many places, where views side by side on a
 * grid differ, have no line of that kind near, the last at X,Y.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEAVES = 16, NUMBERS = 64, FACES = 64, NAME = 200 };

#define GRID    60     /* places on the radius */
#define STEP    3e-5   /* of the radius: thinner things are not seen */
#define SPACING 0.01   /* of the radius: places along a line */
#define KINK    2.5    /* a jump is larger than so many differences beside it */
#define FLAT    0.0005 /* of the radius: and than this */

typedef struct leaf {
  int kind, n;
  double m[9], t[3], x[NUMBERS];
} leaf;

typedef struct line {
  bool visible, outline;
  double p[2][2];
} line;

typedef struct picture {
  leaf leaf[LEAVES];
  int leaves, how;
  double right[3], up[3], eye[3], middle[3], radius, near;
  line *line;
  size_t n, room;
} picture;

typedef struct view {
  int n, face[FACES];
  double depth[FACES];
} view;

typedef struct result {
  double length, wrong, outline, at[2];
  int missing;
} result;

static double
dot(const double *a, const double *b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ------------------------------------------------------------- distances */

static double
from_segment(const double p[2], const double a[2], const double b[2])
{
  double u = b[0] - a[0], w = b[1] - a[1], square = u * u + w * w;
  double t =
      square > 0.0 ? ((p[0] - a[0]) * u + (p[1] - a[1]) * w) / square : 0.0;

  t = fmin(fmax(t, 0.0), 1.0);
  return hypot(a[0] + t * u - p[0], a[1] + t * w - p[1]);
}

static double
from_block(const leaf *l, const double p[3], int *face)
{
  double at[3] = {p[0], p[1], p[2] - l->x[2] / 2.0}, most = -INFINITY,
         square = 0.0;

  for (int k = 0; k < 3; k++) {
    double off = fabs(at[k]) - l->x[k] / 2.0;
    if (off > most) {
      most = off;
      *face = 2 * k + (at[k] > 0.0);
    }
    square += off > 0.0 ? off * off : 0.0;
  }
  return square > 0.0 ? sqrt(square) : most;
}

static double
from_turned(const leaf *l, const double p[3], int *face)
{
  double at[2] = {hypot(p[0], p[1]), p[2]}, least = INFINITY;
  bool inside = false;

  for (int i = 0, j = l->n - 2; i < l->n; j = i, i += 2) {
    const double *a = l->x + j, *b = l->x + i;
    double off = from_segment(at, a, b);
    if ((a[0] > 0.0 || b[0] > 0.0) && off < least) {
      least = off;
      *face = j / 2;
    }
    if ((a[1] > at[1]) != (b[1] > at[1]) &&
        at[0] < (b[0] - a[0]) * (at[1] - a[1]) / (b[1] - a[1]) + a[0]) {
      inside = !inside;
    }
  }
  return inside ? -least : least;
}

/* How far p is outside of it; less than 0: inside. */
static double
from_leaf(const leaf *l, const double p[3], int *face)
{
  double off[3], at[3];

  for (int k = 0; k < 3; k++) {
    off[k] = p[k] - l->t[k];
  }
  for (int k = 0; k < 3; k++) {
    at[k] = dot(l->m + 3 * k, off);
  }
  *face = 0;
  return l->kind == 0   ? from_block(l, at, face)
         : l->kind == 1 ? sqrt(dot(at, at)) - l->x[0]
         : l->kind == 2 ? hypot(hypot(at[0], at[1]) - l->x[0], at[2]) - l->x[1]
                        : from_turned(l, at, face);
}

static double
from_all(const picture *pic, const double p[3], int *face)
{
  double far = 0.0;

  for (int i = 0; i < pic->leaves; i++) {
    int of;
    double d = from_leaf(&pic->leaf[i], p, &of);
    d = pic->how == 2 && i > 0 ? -d : d;
    if (i == 0 || (pic->how == 0 ? d < far : d > far)) {
      far = d;
      *face = i * FACES + of;
    }
  }
  return far;
}

/* ---------------------------------------------------------------- views */

static double
at_depth(const picture *pic, const double xy[2], double depth, int *face)
{
  double p[3];

  for (int k = 0; k < 3; k++) {
    p[k] = xy[0] * pic->right[k] + xy[1] * pic->up[k] + depth * pic->eye[k];
  }
  return from_all(pic, p, face);
}

/* Between two depths of which one is inside. */
static void
push_face(const picture *pic, const double xy[2], double from, double to,
          view *out)
{
  int face, first;
  bool inside = at_depth(pic, xy, from, &first) < 0.0;

  for (int i = 0; i < 40; i++) {
    double middle = (from + to) / 2.0;
    if ((at_depth(pic, xy, middle, &face) < 0.0) == inside) {
      from = middle;
    } else {
      to = middle;
    }
  }
  at_depth(pic, xy, (from + to) / 2.0, &face);
  if (out->n < FACES) {
    out->depth[out->n] = from;
    out->face[out->n++] = face;
  }
}

static view
view_at(const picture *pic, double x, double y)
{
  const double xy[2] = {x, y};
  double depth = dot(pic->middle, pic->eye) + pic->radius,
         last = depth - 2.0 * pic->radius;
  int face;
  double far = at_depth(pic, xy, depth, &face);
  view out = {.n = 0};

  while (depth > last) {
    double next = depth - fmax(0.95 * fabs(far), STEP * pic->radius);
    double off = at_depth(pic, xy, next, &face);
    if ((off < 0.0) != (far < 0.0)) {
      push_face(pic, xy, depth, next, &out);
    }
    depth = next;
    far = off;
  }
  return out;
}

static bool
same_seen(const view *a, const view *b)
{
  return a->n == 0 || b->n == 0 ? a->n == b->n : a->face[0] == b->face[0];
}

/* From the face `from` on. */
static bool
same_behind(const view *a, const view *b, int from)
{
  for (int i = from; i < a->n && i < b->n; i++) {
    if (a->face[i] != b->face[i]) {
      return false;
    }
  }
  return a->n == b->n;
}

/* ---------------------------------------------------------------- lines */

/* Where the same face is seen on both sides of x, y, at D along `across`: if
 * its depth jumps there. */
static bool
jumps(const picture *pic, const double at[2], const double across[2], double d,
      const view side[2])
{
  double beside = INFINITY;

  for (int k = 0; k < 2; k++) {
    double s = k ? -2.0 * d : 2.0 * d;
    view v = view_at(pic, at[0] + s * across[0], at[1] + s * across[1]);
    beside = fmin(beside, v.n && same_seen(&v, &side[k])
                              ? fabs(v.depth[0] - side[k].depth[0])
                              : 0.0);
  }
  return fabs(side[0].depth[0] - side[1].depth[0]) >
         KINK * beside + FLAT * pic->radius;
}

/* Whether there is a reason for a line at a place, so near. */
static bool
has_reason(const picture *pic, const line *l, const double at[2],
           const double across[2], double d)
{
  view side[2];

  for (int k = 0; k < 2; k++) {
    double s = k ? -d : d;
    side[k] = view_at(pic, at[0] + s * across[0], at[1] + s * across[1]);
  }
  if (!l->visible) {
    return (side[0].n > 0 || side[1].n > 0) &&
           !(side[0].n == side[1].n && same_behind(&side[0], &side[1], 1));
  }
  return !same_seen(&side[0], &side[1]) ||
         (side[0].n > 0 && jumps(pic, at, across, d, side));
}

/* What is near along the line may be another line: nearer is asked, too. */
static bool
is_true(const picture *pic, const line *l, const double at[2],
        const double across[2])
{
  for (double d = pic->near; d > pic->near / 12.0; d /= 2.2) {
    if (has_reason(pic, l, at, across, d)) {
      return true;
    }
  }
  return false;
}

static double
nearest(const picture *pic, const double at[2], bool visible)
{
  double least = INFINITY;

  for (size_t i = 0; i < pic->n; i++) {
    const line *l = &pic->line[i];
    if (l->visible || !visible) {
      least = fmin(least, from_segment(at, l->p[0], l->p[1]));
    }
  }
  return least;
}

static void
check_line(const picture *pic, const line *l, result *out)
{
  double u = l->p[1][0] - l->p[0][0], w = l->p[1][1] - l->p[0][1];
  double length = hypot(u, w);
  const double across[2] = {-w / length, u / length};
  int n = (int)ceil(length / (SPACING * pic->radius));

  for (int i = 0; i < n; i++) {
    double s = (i + 0.5) / n;
    const double at[2] = {l->p[0][0] + s * u, l->p[0][1] + s * w};
    out->length += length / n;
    if (!is_true(pic, l, at, across) &&
        (l->visible || nearest(pic, at, true) > pic->near)) {
      out->wrong += length / n;
      out->outline += l->outline ? length / n : 0.0;
    }
  }
}

/* ----------------------------------------------------------------- grid */

/* Halves the way between two places whose views differ. */
static void
check_between(const picture *pic, const double from[2], const double to[2],
              const view *of, result *out)
{
  double a[2] = {from[0], from[1]}, b[2] = {to[0], to[1]};
  view end = view_at(pic, b[0], b[1]);
  bool seen = !same_seen(of, &end);

  for (int i = 0; i < 10; i++) {
    double m[2] = {(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0};
    view v = view_at(pic, m[0], m[1]);
    memcpy((seen ? same_seen(&v, of) : same_behind(&v, of, 0)) ? a : b, m,
           sizeof m);
  }
  if (nearest(pic, a, seen) > 3.0 * pic->near) {
    out->missing++;
    memcpy(out->at, a, sizeof a);
  }
}

static void
check_grid(const picture *pic, result *out)
{
  double step = pic->radius / GRID;
  double x0 = dot(pic->middle, pic->right), y0 = dot(pic->middle, pic->up);
  view *row = calloc(2 * GRID + 1, sizeof *row);

  for (int j = -GRID; row && j <= GRID; j++) {
    view last = {.n = 0};
    for (int i = -GRID; i <= GRID; i++) {
      const double at[2] = {x0 + (i + 0.01) * step, y0 + (j + 0.02) * step};
      const double beside[2][2] = {{at[0] - step, at[1]},
                                   {at[0], at[1] - step}};
      view v = view_at(pic, at[0], at[1]);
      if (!same_behind(&v, &last, 0)) {
        check_between(pic, at, beside[0], &v, out);
      }
      if (!same_behind(&v, &row[i + GRID], 0)) {
        check_between(pic, at, beside[1], &v, out);
      }
      last = row[i + GRID] = v;
    }
  }
  free(row);
}

/* -------------------------------------------------------------- reading */

static void
fail(const char *why)
{
  fprintf(stderr, "surface_checker: %s\n", why);
  exit(2);
}

static void
numbers(FILE *in, double *x, int n)
{
  for (int i = 0; i < n; i++) {
    if (fscanf(in, "%lf", &x[i]) != 1) {
      fail("a number is missing");
    }
  }
}

static void
read_leaf(FILE *in, picture *pic)
{
  leaf *l = &pic->leaf[pic->leaves++];
  double head[14];

  numbers(in, head, 14);
  l->kind = (int)head[0];
  memcpy(l->m, head + 1, sizeof l->m);
  memcpy(l->t, head + 10, sizeof l->t);
  l->n = (int)head[13];
  if (pic->leaves == LEAVES || l->n > NUMBERS) {
    fail("too many leaves or numbers");
  }
  numbers(in, l->x, l->n);
}

static void
read_line(FILE *in, picture *pic)
{
  double x[6];
  line *l;

  if (pic->n == pic->room) {
    pic->room = 2 * pic->room + 64;
    pic->line = realloc(pic->line, pic->room * sizeof *pic->line);
    if (!pic->line) {
      fail("no memory");
    }
  }
  numbers(in, x, 6);
  l = &pic->line[pic->n++];
  l->visible = x[0] > 0.0;
  l->outline = x[1] > 0.0;
  memcpy(l->p, x + 2, sizeof l->p);
}

static void
read_eye(FILE *in, picture *pic)
{
  numbers(in, pic->right, 3);
  numbers(in, pic->up, 3);
  numbers(in, pic->eye, 3);
}

static void
tell(picture *pic, const char *name)
{
  result out = {.length = 0.0};

  for (size_t i = 0; i < pic->n; i++) {
    if (hypot(pic->line[i].p[1][0] - pic->line[i].p[0][0],
              pic->line[i].p[1][1] - pic->line[i].p[0][1]) > 0.0) {
      check_line(pic, &pic->line[i], &out);
    }
  }
  check_grid(pic, &out);
  printf("%s: length=%.4f false=%.4f outline=%.4f missing=%d at=%.4f,%.4f\n",
         name, out.length, out.wrong, out.outline, out.missing, out.at[0],
         out.at[1]);
  pic->n = 0;
  pic->leaves = 0;
}

int
main(int argc, char **argv)
{
  picture pic = {.leaves = 0};
  char word[NAME];
  FILE *in = argc == 2 ? fopen(argv[1], "r") : NULL;
  double how;

  if (!in) {
    fail("which pictures?");
  }
  while (fscanf(in, "%199s", word) == 1) {
    if (strcmp(word, "leaf") == 0) {
      read_leaf(in, &pic);
    } else if (strcmp(word, "tree") == 0) {
      numbers(in, &how, 1);
      pic.how = (int)how;
    } else if (strcmp(word, "eye") == 0) {
      read_eye(in, &pic);
    } else if (strcmp(word, "round") == 0) {
      numbers(in, pic.middle, 3);
      numbers(in, &pic.radius, 1);
    } else if (strcmp(word, "near") == 0) {
      numbers(in, &pic.near, 1);
    } else if (strcmp(word, "l") == 0) {
      read_line(in, &pic);
    } else if (fscanf(in, "%199s", word) == 1) {
      tell(&pic, word);
    }
  }
  free(pic.line);
  fclose(in);
  return 0;
}
