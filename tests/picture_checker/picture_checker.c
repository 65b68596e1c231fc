/* picture_checker.c -- holds drawings against a definition of what is hidden.
 *
 *     picture_checker [-v] SCENES
 *
 * Written for the tests alone and shares nothing with the engine: all pairs,
 * rational numbers. For each scene (scene.h) one line:
 *
 *     NAME: lines=N triangles=N size=L visible=L hidden=L drawn_visible=L
 *           drawn_hidden=L wrong=L lost=L twice=L
 *
 * Lengths are in the picture; `size` is half of its longer side. `visible` is
 * what is seen of all lines, where several lie on one another counted once;
 * `hidden` what is hidden of all lines and not under a visible one, counted
 * once. `drawn_...` are the sums of the parts that were drawn; `wrong` the
 * longest piece of a part that is drawn as what it is not; `lost` the most of a
 * line where nothing is drawn, on it or on one in line with it; `twice` the
 * longest piece that two parts draw, closer than a ten-millionth of the
 * picture. -v: every line and part at fault.
 */
#include "hiding.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is drawn nearer than this part of the picture is drawn in one place. */
#define ONE_PLACE 1e-7

/* Shorter faults are not told. */
#define TOLD 1e-6

typedef struct verdict {
  double size, visible, hidden, drawn[2], wrong, lost, twice;
} verdict;

/* ------------------------------------------------- what should be drawn */

/* Takes the intervals of line b away from a set of line a. */
static void
take_away(intervals *set, const line *a, const line *b, const intervals *other)
{
  mpq_t from, to;

  mpq_inits(from, to, NULL);
  for (size_t i = 0; i < other->n; i++) {
    hiding_moved(a, b, other->at[i].from, from);
    hiding_moved(a, b, other->at[i].to, to);
    if (mpq_cmp(from, to) > 0) {
      mpq_swap(from, to);
    }
    intervals_subtract(set, from, to);
  }
  mpq_clears(from, to, NULL);
}

static void
copy(const intervals *from, intervals *to)
{
  intervals_init(to);
  for (size_t i = 0; i < from->n; i++) {
    intervals_add(to, from->at[i].from, from->at[i].to);
  }
}

/* Adds what line k alone, or first, has to show. */
static void
add_line(const scene *s, size_t k, verdict *v)
{
  const line *a = &s->line[k];
  intervals shown, hidden;

  copy(&a->shown, &shown);
  copy(&a->hidden, &hidden);
  for (size_t i = 0; i < s->lines; i++) {
    const line *b = &s->line[i];
    if (i == k || b->length == 0.0 || !hiding_in_line(a, b, s->size)) {
      continue;
    }
    take_away(&hidden, a, b, &b->shown);
    if (i < k) {
      take_away(&shown, a, b, &b->shown);
      take_away(&hidden, a, b, &b->hidden);
    }
  }
  v->visible += a->length * intervals_length(&shown);
  v->hidden += a->length * intervals_length(&hidden);
  intervals_clear(&shown);
  intervals_clear(&hidden);
}

/* ------------------------------------------------------ what was drawn */

static void
check_part(const scene *s, const part *p, bool tell, verdict *v)
{
  const line *l;
  double wrong;
  mpq_t size;

  l = &s->line[p->line];
  mpq_init(size);
  mpq_sub(size, p->to, p->from);
  v->drawn[p->hidden] += l->length * mpq_get_d(size);
  mpq_clear(size);
  wrong = l->length *
          intervals_common(p->hidden ? &l->shown : &l->hidden, p->from, p->to);
  v->wrong = fmax(v->wrong, wrong);
  if (tell && wrong > TOLD) {
    printf("  edge %d of %d: drawn %s from %g to %g, wrong for %g\n", l->e,
           l->s, p->hidden ? "hidden" : "visible", mpq_get_d(p->from),
           mpq_get_d(p->to), wrong);
  }
}

/* What of line k no part draws. */
static void
check_lost(const scene *s, size_t k, bool tell, verdict *v)
{
  const line *a = &s->line[k];
  intervals left, drawn = {0};
  double lost;
  mpq_t from, to;

  mpq_inits(from, to, NULL);
  mpq_set_ui(to, 1, 1);
  intervals_init(&left);
  intervals_add(&left, from, to);
  for (size_t i = 0; i < s->parts && left.n > 0; i++) {
    const part *p = &s->part[i];
    if (hiding_in_line(a, &s->line[p->line], s->size)) {
      intervals_clear(&drawn);
      intervals_add(&drawn, p->from, p->to);
      take_away(&left, a, &s->line[p->line], &drawn);
    }
  }
  lost = a->length * intervals_length(&left);
  v->lost = fmax(v->lost, lost);
  if (tell && lost > TOLD) {
    printf("  edge %d of %d: not drawn for %g, hidden for %g\n", a->e, a->s,
           lost, a->length * intervals_length(&a->hidden));
  }
  intervals_clear(&left);
  intervals_clear(&drawn);
  mpq_clears(from, to, NULL);
}

/* The ends of a part in the picture. */
static void
ends_of(const scene *s, const part *p, double out[2][2])
{
  const line *l = &s->line[p->line];
  double t[2] = {mpq_get_d(p->from), mpq_get_d(p->to)};

  for (int i = 0; i < 2; i++) {
    for (int k = 0; k < 2; k++) {
      double a = l->end[0].near[k], b = l->end[1].near[k];
      out[i][k] = (a + t[i] * (b - a)) * s->scale[k];
    }
  }
}

/* How much of a is also on b, nearer than `close`. */
static double
common(double a[2][2], double b[2][2], double close)
{
  double x = a[1][0] - a[0][0], y = a[1][1] - a[0][1];
  double length = hypot(x, y), at[2], off[2], low, high, f, g;

  if (fmax(b[0][0], b[1][0]) < fmin(a[0][0], a[1][0]) ||
      fmin(b[0][0], b[1][0]) > fmax(a[0][0], a[1][0])) {
    return 0.0;
  }
  for (int i = 0; i < 2; i++) {
    double u = b[i][0] - a[0][0], v = b[i][1] - a[0][1];
    at[i] = (x * u + y * v) / length;
    off[i] = (x * v - y * u) / length;
  }
  if (at[0] == at[1]) {
    return 0.0;
  }
  low = fmax(0.0, fmin(at[0], at[1]));
  high = fmin(length, fmax(at[0], at[1]));
  f = off[0] + (off[1] - off[0]) * (low - at[0]) / (at[1] - at[0]);
  g = off[0] + (off[1] - off[0]) * (high - at[0]) / (at[1] - at[0]);
  return high > low && fabs(f) < close && fabs(g) < close ? high - low : 0.0;
}

static void
check_twice(const scene *s, bool tell, verdict *v)
{
  double(*end)[2][2] = malloc((s->parts + 1) * sizeof *end);

  if (!end) {
    abort();
  }
  for (size_t i = 0; i < s->parts; i++) {
    ends_of(s, &s->part[i], end[i]);
    for (size_t k = 0; k < i; k++) {
      double twice = common(end[i], end[k], ONE_PLACE * v->size);
      v->twice = fmax(v->twice, twice);
      if (tell && twice > 10 * TOLD * v->size) {
        const line *a = &s->line[s->part[i].line],
                   *b = &s->line[s->part[k].line];
        printf("  edges %d of %d and %d of %d: drawn twice for %g\n", a->e,
               a->s, b->e, b->s, twice);
      }
    }
  }
  free(end);
}

/* The half of the longer side of the picture. */
static double
size_of(const scene *s)
{
  double size = 0.0;

  for (int k = 0; k < 2; k++) {
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < s->lines; i++) {
      const place *end = s->line[i].end;
      low = fmin(low, fmin(end[0].near[k], end[1].near[k]));
      high = fmax(high, fmax(end[0].near[k], end[1].near[k]));
    }
    size = fmax(size, (high - low) / 2 * s->scale[k]);
  }
  return size;
}

static verdict
judge(scene *s, bool tell)
{
  verdict v = {.size = size_of(s)};

  hiding_find(s);
  for (size_t k = 0; k < s->lines; k++) {
    if (s->line[k].length > 0.0) {
      add_line(s, k, &v);
      check_lost(s, k, tell, &v);
    }
  }
  for (size_t i = 0; i < s->parts; i++) {
    check_part(s, &s->part[i], tell, &v);
  }
  check_twice(s, tell, &v);
  return v;
}

int
main(int argc, char **argv)
{
  bool tell = argc > 2 && strcmp(argv[1], "-v") == 0;
  FILE *in = argc > 1 ? fopen(argv[argc - 1], "r") : NULL;
  scene s;

  if (!in) {
    fprintf(stderr, "usage: picture_checker [-v] SCENES\n");
    return 2;
  }
  while (scene_read(&s, in)) {
    verdict v = judge(&s, tell);
    printf("%s: lines=%zu triangles=%zu size=%.3g visible=%.12g hidden=%.12g "
           "drawn_visible=%.12g drawn_hidden=%.12g wrong=%.3g lost=%.3g "
           "twice=%.3g\n",
           s.name, s.lines, s.triangles, v.size, v.visible, v.hidden,
           v.drawn[0], v.drawn[1], v.wrong, v.lost, v.twice);
    scene_clear(&s);
  }
  fclose(in);
  return 0;
}
