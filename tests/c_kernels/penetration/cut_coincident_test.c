/* cut_coincident_test.c -- which pairs of triangles are quiet, in random models
 * on a grid, by what the words say: in whole numbers, each triangle against
 * all.
 */
#include "penetration/cut_coincident.h"
#include "tests/c_kernels/whole_triangle.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"
#include "tests/stop_later.h"

#include <string.h>

enum { SEGMENTS = 3, BASE = 14, MOST = 2 * SEGMENTS * BASE, GRID = 3 };

typedef struct shape {
  triangle t[MOST];
  uint32_t n;
  sg_cut_model model;
  uint32_t (*pair)[2];
  size_t pairs;
  uint8_t *quiet;
} shape;

static uint32_t seed;

/* The corners of b that are corners of a; own[k]: corner k of a is none. */
static int
common(const triangle *a, const triangle *b, bool own[3])
{
  int n = 0;

  for (int i = 0; i < 3; i++) {
    own[i] = true;
    for (int k = 0; k < 3; k++) {
      own[i] = own[i] && !same_place(a->at[i], b->at[k]);
    }
    n += !own[i];
  }
  return n;
}

/* A stretch of a meets b: any; of those with a corner in common what is across
 * from it. */
static bool
reaches(const triangle *a, const triangle *b, int shared, const bool own[3])
{
  for (int i = 0; i < 3; i++) {
    if ((shared == 0 || !own[i]) &&
        meets(a->at[(i + 1) % 3], a->at[(i + 2) % 3], b)) {
      return true;
    }
  }
  return false;
}

/* Whether two have more in common than corners and the edge between them. */
static bool
have_more(const triangle *a, const triangle *b)
{
  bool own_a[3], own_b[3];
  int shared = common(a, b, own_a), i = 0, k = 0, axis = 0;

  common(b, a, own_b);
  if (shared < 2) {
    return reaches(a, b, shared, own_a) || reaches(b, a, shared, own_b);
  }
  if (shared == 3) {
    return true;
  }
  while (!own_a[i]) {
    i++;
  }
  while (!own_b[k]) {
    k++;
  }
  if (volume(a->at[0], a->at[1], a->at[2], b->at[k])) {
    return false;
  }
  while (!area(a->at[0], a->at[1], a->at[2], axis)) {
    axis++;
  }
  const int *p = a->at[(i + 1) % 3], *q = a->at[(i + 2) % 3];

  return (area(p, q, a->at[i], axis) > 0) == (area(p, q, b->at[k], axis) > 0);
}

/* ---- what the words say ---- */

static bool
has_corner(const triangle *t, const int at[3])
{
  return same_place(t->at[0], at) || same_place(t->at[1], at) ||
         same_place(t->at[2], at);
}

static bool
are_twins(const triangle *a, const triangle *b)
{
  bool own[3];

  return a->s != b->s && common(a, b, own) == 3;
}

/* Every triangle of either segment that has it has one twin in the other. */
static bool
is_quiet_at(const shape *x, const int at[3], int32_t s, int32_t other)
{
  for (uint32_t i = 0; i < x->n; i++) {
    const triangle *t = &x->t[i];
    int twins = 0;

    if ((t->s != s && t->s != other) || !has_corner(t, at)) {
      continue;
    }
    for (uint32_t k = 0; k < x->n; k++) {
      twins += (x->t[k].s == s || x->t[k].s == other) && are_twins(t, &x->t[k]);
    }
    if (twins != 1) {
      return false;
    }
  }
  return true;
}

static bool
is_quiet(const shape *x, const triangle *a, const triangle *b)
{
  bool quiet = a->s != b->s && (are_twins(a, b) || !have_more(a, b));

  for (int k = 0; k < 3 && quiet; k++) {
    quiet = is_quiet_at(x, a->at[k], a->s, b->s) &&
            is_quiet_at(x, b->at[k], a->s, b->s);
  }
  return quiet;
}

/* ---- models ---- */

static void
add(shape *x, int32_t s, const triangle *of)
{
  int turn = check_below(&seed, 3), back = check_below(&seed, 2);
  triangle *t = &x->t[x->n++];
  int32_t v[3];
  bool known = true, good = true;

  t->s = s;
  for (int k = 0; k < 3; k++) {
    double at[3];

    memcpy(t->at[k], of->at[(turn + (back ? 3 - k : k)) % 3], sizeof t->at[k]);
    v[k] = 1 + t->at[k][0] + GRID * (t->at[k][1] + GRID * t->at[k][2]);
    for (int c = 0; c < 3; c++) {
      at[c] = t->at[k][c] || check_below(&seed, 2) ? t->at[k][c] : -0.0;
    }
    if (sg_cut_model_find(&x->model, s, v[k]) == SG_NO_KEY) {
      good = good && sg_cut_model_vertex(&x->model, s, v[k], at);
    }
  }
  good =
      good && sg_cut_model_triangle(&x->model, s, 1, (int32_t)x->n, v, &known);
  if (!good || !known) {
    abort();
  }
}

static void
draw_base(triangle *base)
{
  do {
    for (int k = 0; k < 9; k++) {
      base->at[k / 3][k % 3] = check_below(&seed, GRID);
    }
  } while (!has_area(base));
}

/* Segments of the same triangles, but for a few that one has not or has twice;
 * and each pair, either one first. */
static shape *
open_shape(int n)
{
  shape *x = calloc(1, sizeof *x);
  triangle base[BASE];

  sg_cut_model_init(&x->model);
  for (int i = 0; i < n; i++) {
    draw_base(&base[i]);
  }
  for (int32_t s = 1; s <= SEGMENTS; s++) {
    for (int i = 0; i < n; i++) {
      int times = check_below(&seed, 24);

      for (int k = times == 0 ? 2 : times == 1 ? 0 : 1; k > 0; k--) {
        add(x, 10 * s, &base[i]);
      }
    }
  }
  x->pair = malloc((x->n * x->n + 1) * sizeof *x->pair);
  for (uint32_t a = 0; a < x->n; a++) {
    for (uint32_t b = 0; b < a; b++) {
      bool turned = check_below(&seed, 2);
      x->pair[x->pairs][turned] = a;
      x->pair[x->pairs++][!turned] = b;
    }
  }
  x->quiet = calloc(x->pairs + 1, 1);
  return x;
}

static void
close_shape(shape *x)
{
  sg_cut_model_clear(&x->model);
  free(x->pair);
  free(x->quiet);
  free(x);
}

static sg_sort_end
find(shape *x, const sg_cancel *cancel)
{
  return sg_cut_find_quiet(&x->model, (const uint32_t(*)[2])x->pair, x->pairs,
                           x->quiet, cancel);
}

static void
against_words(void)
{
  size_t quiet = 0, loud = 0, hard = 0, wrong = 0;

  for (uint32_t round = 0; round < 1500; round++) {
    seed = round;
    shape *x = open_shape(2 + (int)round % (BASE - 1));

    wrong += find(x, NULL) != SG_SORTED;
    for (size_t i = 0; i < x->pairs; i++) {
      const triangle *a = &x->t[x->pair[i][0]], *b = &x->t[x->pair[i][1]];
      bool is = is_quiet(x, a, b), own[3];

      if (is && !x->quiet[i] && common(a, b, own) < 2) {
        hard++;
        continue;
      }
      wrong += is != x->quiet[i];
      quiet += is;
      loud += !is && a->s != b->s && !are_twins(a, b);
    }
    close_shape(x);
  }
  CHECK("pairs are quiet as the words say", wrong == 0);
  CHECK("but for some in whose planes none shows that they are apart",
        hard < quiet / 8);
  CHECK("many are", quiet > 10000);
  CHECK("many are not", loud > 10000);
}

static void
ends(void)
{
  seed = 1;
  shape *x = open_shape(BASE);
  sg_sort_end end;

  CHECK_REFUSED("quiet",
                (end = find(x, NULL)) == SG_SORTED || end == SG_SORT_NO_MEMORY);
  size_t n = x->pairs, times = (1 << 14) / n + 1;

  x->pair = realloc(x->pair, times * n * sizeof *x->pair);
  x->quiet = realloc(x->quiet, times * n);
  for (size_t i = n; i < times * n; i++) {
    memcpy(x->pair[i], x->pair[i - n], sizeof *x->pair);
  }
  x->pairs = times * n;
  int asked = 0;

  for (int k = 0, left = -1; left < 0; k++) {
    left = k;
    end = find(x, &(sg_cancel){stop_later, &left});
    CHECK("it stops when it is told to",
          left < 0 ? end == SG_SORT_STOPPED : end == SG_SORTED);
    asked = k;
  }
  CHECK("it asks in each loop over pairs", asked == 6);
  close_shape(x);
}

int
main(void)
{
  against_words();
  ends();
  return check_report();
}
