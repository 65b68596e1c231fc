/* outline_checker.c -- holds drawings against the silhouette of what they show.
 *
 *     outline_checker PICTURES [DOTS]
 *
 * Written for the tests alone and shares nothing with the engine: dots. Lines
 * of input, numbers in any unit, y up:
 *
 *     t X1 Y1 X2 Y2 X3 Y3     a triangle of the model, as seen
 *     l X1 Y1 X2 Y2           a part of a line that is drawn as visible
 *     end NAME
 *
 * The triangles are filled on a picture of DOTS (1000) on its longer side. Its
 * silhouette are the filled dots beside a background of at least SMALLEST dots
 * together, outside or in a hole. For each picture one line:
 *
 *     NAME: silhouette=N bare=N run=N farthest=D at=X,Y
 *
 * bare: dots of the silhouette that have no drawn line within NEAR dots; run:
 * of these the most that are connected, which begin at X,Y of the input;
 * farthest: how far from a line one of them is, in dots, at most FAR.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NEAR 2.5
#define FAR  30

enum { EDGE = 4, SMALLEST = 16, NAME = 200 };

typedef struct list {
  double *x; /* [n] numbers, 6 or 4 for each */
  size_t n, room;
} list;

/* Each field: [width * height]. */
typedef struct dots {
  int width, height;
  unsigned char *filled, *drawn, *bare;
  int *region; /* of the background; 0: none yet */
} dots;

static void *
some(size_t n, size_t size)
{
  void *p = calloc(n + 1, size);

  if (!p) {
    fputs("outline_checker: no memory\n", stderr);
    exit(2);
  }
  return p;
}

static void
push(list *l, const double *x, size_t n)
{
  if (l->n + n > l->room) {
    l->room = 2 * l->room + 1024;
    l->x = realloc(l->x, l->room * sizeof *l->x);
    if (!l->x) {
      exit(2);
    }
  }
  memcpy(l->x + l->n, x, n * sizeof *x);
  l->n += n;
}

/* --------------------------------------------------------------- filling */

static size_t
at(const dots *d, int x, int y)
{
  return (size_t)y * (size_t)d->width + (size_t)x;
}

static int
clamp(double x, int most)
{
  return x < 0 ? 0 : x > most ? most : (int)x;
}

/* True if the dot's centre is in the triangle, or on its border. */
static bool
is_in(const double *t, double x, double y)
{
  int left = 0, right = 0;

  for (int i = 0; i < 3; i++) {
    const double *a = t + 2 * i, *b = t + 2 * ((i + 1) % 3);
    double side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    left += side > 0;
    right += side < 0;
  }
  return left == 0 || right == 0;
}

static void
fill(dots *d, const double *t)
{
  double low[2], high[2];

  for (int k = 0; k < 2; k++) {
    low[k] = fmin(t[k], fmin(t[2 + k], t[4 + k]));
    high[k] = fmax(t[k], fmax(t[2 + k], t[4 + k]));
  }
  for (int y = clamp(ceil(low[1]), d->height - 1);
       y <= clamp(high[1], d->height - 1); y++) {
    for (int x = clamp(ceil(low[0]), d->width - 1);
         x <= clamp(high[0], d->width - 1); x++) {
      d->filled[at(d, x, y)] |= is_in(t, x, y);
    }
  }
}

static void
draw(dots *d, const double *l)
{
  double length = hypot(l[2] - l[0], l[3] - l[1]);
  int steps = 1 + (int)(2 * length);

  for (int i = 0; i <= steps; i++) {
    double x = l[0] + (l[2] - l[0]) * i / steps;
    double y = l[1] + (l[3] - l[1]) * i / steps;
    d->drawn[at(d, clamp(x + 0.5, d->width - 1),
                clamp(y + 0.5, d->height - 1))] = 1;
  }
}

/* --------------------------------------------------------------- regions */

/* Gives the dots that are connected with `start` over dots for which `of` is
 * `value` the number `name` in `out`, and counts them. Eight neighbours, or
 * four. */
static size_t
flood(const dots *d, const unsigned char *of, int value, int *out, size_t start,
      int name, bool eight, size_t *queue)
{
  size_t n = 1;

  queue[0] = start;
  out[start] = name;
  for (size_t i = 0; i < n; i++) {
    int x = (int)(queue[i] % (size_t)d->width);
    int y = (int)(queue[i] / (size_t)d->width);
    for (int k = 0; k < 9; k++) {
      int u = x + k % 3 - 1, v = y + k / 3 - 1;
      bool beside = eight || k % 2 == 1;
      if (beside && u >= 0 && v >= 0 && u < d->width && v < d->height &&
          of[at(d, u, v)] == value && out[at(d, u, v)] == 0) {
        out[at(d, u, v)] = name;
        queue[n++] = at(d, u, v);
      }
    }
  }
  return n;
}

/* The regions of the background; small ones count as filled. */
static void
find_background(dots *d, size_t *queue)
{
  size_t all = (size_t)d->width * (size_t)d->height;
  int name = 0;

  for (size_t i = 0; i < all; i++) {
    if (!d->filled[i] && d->region[i] == 0) {
      size_t n = flood(d, d->filled, 0, d->region, i, ++name, false, queue);
      for (size_t k = 0; n < SMALLEST && k < n; k++) {
        d->filled[queue[k]] = 1;
      }
    }
  }
}

static bool
is_silhouette(const dots *d, int x, int y)
{
  return d->filled[at(d, x, y)] &&
         (!d->filled[at(d, x - 1, y)] || !d->filled[at(d, x + 1, y)] ||
          !d->filled[at(d, x, y - 1)] || !d->filled[at(d, x, y + 1)]);
}

/* How far the nearest drawn dot is. */
static double
distance(const dots *d, int x, int y)
{
  double least = FAR;

  for (int v = -FAR; v <= FAR; v++) {
    for (int u = -FAR; u <= FAR; u++) {
      if (x + u >= 0 && y + v >= 0 && x + u < d->width && y + v < d->height &&
          d->drawn[at(d, x + u, y + v)] && hypot(u, v) < least) {
        least = hypot(u, v);
      }
    }
  }
  return least;
}

/* -------------------------------------------------------------- pictures */

typedef struct frame {
  double low[2], high[2], scale;
} frame;

static frame
frame_of(const list *triangles, int most)
{
  frame f = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}, 1.0};

  for (size_t i = 0; i < triangles->n; i++) {
    f.low[i % 2] = fmin(f.low[i % 2], triangles->x[i]);
    f.high[i % 2] = fmax(f.high[i % 2], triangles->x[i]);
  }
  f.scale = most / fmax(f.high[0] - f.low[0], f.high[1] - f.low[1]);
  return f;
}

static void
place(const frame *f, list *l)
{
  for (size_t i = 0; i < l->n; i++) {
    l->x[i] = EDGE + (l->x[i] - f->low[i % 2]) * f->scale;
  }
}

static void
report(dots *d, const frame *f, const char *name, size_t *queue)
{
  size_t silhouette = 0, bare = 0, run = 0, first = 0;
  size_t all = (size_t)d->width * (size_t)d->height;
  double farthest = 0.0;

  for (int y = 1; y < d->height - 1; y++) {
    for (int x = 1; x < d->width - 1; x++) {
      if (is_silhouette(d, x, y)) {
        double far = distance(d, x, y);
        silhouette++;
        bare += far > NEAR;
        d->bare[at(d, x, y)] = far > NEAR;
        farthest = fmax(farthest, far);
      }
    }
  }
  memset(d->region, 0, all * sizeof *d->region);
  for (size_t i = 0; i < all; i++) {
    if (d->bare[i] && d->region[i] == 0) {
      size_t n = flood(d, d->bare, 1, d->region, i, 1, true, queue);
      first = n > run ? i : first;
      run = n > run ? n : run;
    }
  }
  printf("%s: silhouette=%zu bare=%zu run=%zu farthest=%.1f at=%.9g,%.9g\n",
         name, silhouette, bare, run, farthest,
         f->low[0] + ((double)(first % (size_t)d->width) - EDGE) / f->scale,
         f->low[1] + ((double)(first / (size_t)d->width) - EDGE) / f->scale);
}

static void
check(list *triangles, list *lines, int most, const char *name)
{
  frame f = frame_of(triangles, most);
  dots d = {.width = 2 * EDGE + 1 + (int)((f.high[0] - f.low[0]) * f.scale),
            .height = 2 * EDGE + 1 + (int)((f.high[1] - f.low[1]) * f.scale)};
  size_t all = (size_t)d.width * (size_t)d.height;
  size_t *queue = some(all, sizeof *queue);

  d.filled = some(all, 1);
  d.drawn = some(all, 1);
  d.bare = some(all, 1);
  d.region = some(all, sizeof *d.region);
  place(&f, triangles);
  place(&f, lines);
  for (size_t i = 0; i < triangles->n; i += 6) {
    fill(&d, triangles->x + i);
  }
  for (size_t i = 0; i < lines->n; i += 4) {
    draw(&d, lines->x + i);
  }
  find_background(&d, queue);
  report(&d, &f, name, queue);
  free(queue);
  free(d.filled);
  free(d.drawn);
  free(d.bare);
  free(d.region);
}

int
main(int argc, char **argv)
{
  FILE *in = argc > 1 ? fopen(argv[1], "r") : NULL;
  int most = argc > 2 ? atoi(argv[2]) : 1000;
  list triangles = {0}, lines = {0};
  char line[400], name[NAME];
  double x[6];

  if (!in) {
    fputs("usage: outline_checker PICTURES [DOTS]\n", stderr);
    return 2;
  }
  while (fgets(line, sizeof line, in)) {
    if (sscanf(line, "t %lf %lf %lf %lf %lf %lf", x, x + 1, x + 2, x + 3, x + 4,
               x + 5) == 6) {
      push(&triangles, x, 6);
    } else if (sscanf(line, "l %lf %lf %lf %lf", x, x + 1, x + 2, x + 3) == 4) {
      push(&lines, x, 4);
    } else if (sscanf(line, "end %199s", name) == 1 && triangles.n > 0) {
      check(&triangles, &lines, most, name);
      triangles.n = lines.n = 0;
    } else {
      fprintf(stderr, "outline_checker: bad line: %s", line);
      return 2;
    }
  }
  fclose(in);
  free(triangles.x);
  free(lines.x);
  return 0;
}
