/* cut_contact_test.c -- points in common that are no ends of pieces: which are
 * left, how often, of which polygons, in which order.
 *
 * Triangles of random segments and polygons on a coarse grid touch a floor with
 * their tips, or go through it. The checker knows them by arithmetic of whole
 * numbers.
 */
#include "tests/check.h"
#include "tests/memory/refusals.h"

#include "penetration/cut_set.h"

#include <stdint.h>
#include <stdlib.h>

enum { SEGMENTS = 3, POLYGONS = 4, SIZE = 4, MOST = 24 };

/* A triangle in the plane y = y whose tip is at (x, y, z), and which is as wide
 * as it is high at z + 1. The floor is the plane z = 0. */
typedef struct spike {
  int32_t s, p;
  int x, y, z;
} spike;

typedef struct scene {
  spike floor[2], spike[MOST];
  int spikes;
} scene;

static spike
random_spike(uint32_t *seed)
{
  return (spike){1 + check_below(seed, SEGMENTS),
                 1 + check_below(seed, POLYGONS), check_below(seed, SIZE),
                 check_below(seed, SIZE), -check_below(seed, 2)};
}

/* Nothing of two floors is in one segment: floors would be doubled there. */
static void
random_scene(scene *out, uint32_t seed)
{
  out->spikes = 2 + check_below(&seed, MOST - 2);
  for (int i = 0; i < 2; i++) {
    out->floor[i] = random_spike(&seed);
  }
  out->floor[1].s = 1 + out->floor[0].s % SEGMENTS;
  for (int i = 0; i < out->spikes; i++) {
    out->spike[i] = random_spike(&seed);
    out->spike[i].p += POLYGONS; /* never a floor's */
  }
}

static int
no_real_edge(void *data, uint32_t triangle, int edge)
{
  (void)data, (void)triangle, (void)edge;
  return 0;
}

static bool
add_triangle(sg_cut_set *set, const spike *of, const double at[3][3])
{
  int32_t first = (int32_t)set->model.vertices + 1;
  int32_t v[3] = {first, first + 1, first + 2};
  bool known = true;

  for (int i = 0; i < 3; i++) {
    if (!sg_cut_model_vertex(&set->model, of->s, v[i], at[i])) {
      return false;
    }
  }
  return sg_cut_model_triangle(&set->model, of->s, of->p, first, v, &known);
}

/* Floors are triangles 0 and 1. */
static bool
add_scene(sg_cut_set *set, const scene *of)
{
  static const double wide[3][3] = {{-50, -50, 0}, {50, -50, 0}, {0, 99, 0}};
  bool good = true;

  for (int i = 0; i < 2; i++) {
    good = good && add_triangle(set, &of->floor[i], wide);
  }
  for (int i = 0; i < of->spikes && good; i++) {
    const spike *k = &of->spike[i];
    double at[3][3] = {{k->x, k->y, k->z},
                       {k->x + 1.0, k->y, k->z + 1.0},
                       {k->x, k->y, k->z + 1.0}};
    good = add_triangle(set, k, (const double(*)[3])at);
  }
  return good;
}

/* Every spike against both floors, the smaller segment first; of one segment
 * in any order. */
static bool
enter_scene(sg_cut_set *set, uint32_t seed)
{
  const sg_leaf_triangle *leaf = set->model.triangle;

  for (uint32_t i = 2; i < set->model.triangles; i++) {
    for (uint32_t f = 0; f < 2; f++) {
      bool swap = leaf[f].s == leaf[i].s ? check_below(&seed, 2) == 1
                                         : leaf[f].s > leaf[i].s;
      if (sg_cut_set_enter(set, swap ? i : f, swap ? f : i) < 0) {
        return false;
      }
    }
  }
  return sg_cut_set_seal(set, NULL);
}

/* Whether a piece of a spike and a floor ends at (x, y, 0). */
static bool
is_end(const scene *of, int32_t s, int f, int x, int y)
{
  for (int i = 0; i < of->spikes; i++) {
    const spike *k = &of->spike[i];
    if (k->s == s && k->z < 0 && k->y == y && (k->x == x || k->x + 1 == x) &&
        f < 2) {
      return true;
    }
  }
  return false;
}

/* The same of these two segments: with floor f, or the other way round with the
 * other floor. */
static bool
is_end_of(const scene *of, const int32_t s[2], int x, int y)
{
  for (int f = 0; f < 2; f++) {
    int32_t own = of->floor[f].s;
    int32_t other = own == s[0] ? s[1] : s[0];
    if ((own == s[0] || own == s[1]) && is_end(of, other, f, x, y)) {
      return true;
    }
  }
  return false;
}

/* What is wanted: for each pair of segments, x and y the smallest polygons, or
 * 0 where nothing touches. */
typedef struct wanted {
  int32_t p[SEGMENTS + 1][SEGMENTS + 1][SIZE + 1][SIZE + 1][2];
} wanted;

static void
put_smaller(int32_t *known, int32_t p)
{
  *known = *known == 0 || p < *known ? p : *known;
}

static void
want(wanted *out, const scene *of)
{
  *out = (wanted){0};
  for (int i = 0; i < of->spikes; i++) {
    for (int f = 0; f < 2; f++) {
      const spike *k = &of->spike[i], *floor = &of->floor[f];
      bool first = k->s < floor->s; /* of one segment: the smaller polygon */
      int32_t s[2] = {first ? k->s : floor->s, first ? floor->s : k->s};
      int32_t *p = out->p[s[0]][s[1]][k->x][k->y];

      if (k->z == 0 && !is_end_of(of, s, k->x, k->y)) {
        put_smaller(&p[first ? 0 : 1], k->p);
        put_smaller(&p[first ? 1 : 0], floor->p);
      }
    }
  }
}

static bool
comes_before(const sg_cut_contact *a, const sg_cut_contact *b)
{
  const int64_t x[5] = {a->s[0], a->s[1], a->p[0], a->p[1], a->point};
  const int64_t y[5] = {b->s[0], b->s[1], b->p[0], b->p[1], b->point};
  int k = 0;

  while (k < 4 && x[k] == y[k]) {
    k++;
  }
  return x[k] < y[k];
}

/* Takes each contact out of what is wanted; false: it is not there. */
static bool
is_wanted(const sg_cut_set *set, wanted *list)
{
  for (size_t i = 0; i < set->contacts; i++) {
    const sg_cut_contact *k = &set->contact[i];
    const sg_point *at = &set->points.point[k->point].at;
    int32_t *p = list->p[k->s[0]][k->s[1]][(int)at->p[0]][(int)at->p[1]];

    if (p[0] == 0 || p[0] != k->p[0] || p[1] != k->p[1] || at->p[2] != 0.0 ||
        (i > 0 && !comes_before(&set->contact[i - 1], k))) {
      return false;
    }
    p[0] = p[1] = 0;
  }
  return true;
}

static bool
is_empty(const wanted *list)
{
  const int32_t *p = &list->p[0][0][0][0][0];

  for (size_t i = 0; i < sizeof *list / sizeof *p; i++) {
    if (p[i] != 0) {
      return false;
    }
  }
  return true;
}

static void
random_scenes(void)
{
  enum { SCENES = 2000 };
  size_t wrong = 0, missing = 0, many = 0;

  for (uint32_t i = 0; i < SCENES; i++) {
    scene of;
    wanted list;
    sg_cut_set set;

    random_scene(&of, i);
    want(&list, &of);
    sg_cut_set_init(&set, no_real_edge, NULL);
    wrong += !add_scene(&set, &of) || !enter_scene(&set, i);
    wrong += !is_wanted(&set, &list);
    missing += !is_empty(&list);
    many += set.contacts > 3;
    sg_cut_set_clear(&set);
  }
  CHECK("each once, in order, with the smallest polygons", wrong == 0);
  CHECK("none is missing", missing == 0);
  CHECK("most have several", many > SCENES / 2);
}

static long
refused(uint32_t seed, long n, bool *done)
{
  scene of;
  sg_cut_set set;
  long bad;

  random_scene(&of, seed);
  living = 0;
  left = n;
  counting = true;
  sg_cut_set_init(&set, no_real_edge, NULL);
  *done = add_scene(&set, &of) && enter_scene(&set, 7);
  bad = *done != (left >= 0);
  left = -1;
  sg_cut_set_clear(&set);
  counting = false;
  return bad + (living != 0);
}

int
main(void)
{
  spare_gmp();
  random_scenes();
  check_refusals(refused, 50, 500);
  return check_report();
}
