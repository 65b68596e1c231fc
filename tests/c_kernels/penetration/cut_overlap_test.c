/* cut_overlap_test.c -- bent quads on each other and through each other: what
 * runs along their chord.
 *
 * Quads a, q, b, p of two triangles, a-b-p and b-a-q, in random segments and
 * polygons; several have the chord a-b in common, and some both other corners,
 * too. No three of the corners are in one plane with another chord. Two of the
 * same corners lie on each other: nothing runs along their chord. Two others
 * go through each other there, or touch: it does.
 */
#include "tests/check.h"
#include "tests/memory/refusals.h"

#include "penetration/cut_set.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 10, CHORDS = 3, CORNERS = 4, SEGMENTS = 3 };

/* Corners: 2 * chord and 2 * chord + 1 its ends, then the others. */
typedef struct quad {
  int32_t s, p;
  int chord, corner[2];
  bool turned; /* b-a-q comes first, and its chord is not its first side */
} quad;

typedef struct scene {
  double at[2 * CHORDS + CORNERS][3];
  quad quad[MOST];
  int quads;
  bool of_triangles; /* two quads, each triangle a polygon of its own */
} scene;

/* Chords along a line, the last two with an end in common; corners on both
 * sides of it, some above each other. */
static void
random_scene(scene *out, uint32_t seed)
{
  for (int i = 0; i < 2 * CHORDS; i++) {
    out->at[i][0] = 100.0 * (i / 2) + (i % 2 ? 10 : -10);
    out->at[i][1] = check_below(&seed, 1000) / 1000.0;
    out->at[i][2] = check_below(&seed, 1000) / 1000.0;
  }
  memcpy(out->at[2 * CHORDS - 1], out->at[2 * CHORDS - 3], sizeof *out->at);
  for (int i = 2 * CHORDS; i < 2 * CHORDS + CORNERS; i++) {
    out->at[i][0] = 200.0 * check_below(&seed, 2);
    out->at[i][1] = (300.0 + 200.0 * check_below(&seed, 2)) * (i % 2 ? -1 : 1);
    out->at[i][2] = check_below(&seed, 1000) / 1000.0;
  }
  out->of_triangles = check_below(&seed, 2) == 1;
  out->quads = out->of_triangles ? 2 : 2 + check_below(&seed, MOST - 2);
  for (int i = 0; i < out->quads; i++) {
    out->quad[i] = (quad){1 + check_below(&seed, SEGMENTS),
                          2 * i + 2,
                          check_below(&seed, CHORDS),
                          {2 * CHORDS + 2 * check_below(&seed, 2),
                           2 * CHORDS + 1 + 2 * check_below(&seed, 2)},
                          check_below(&seed, 2) == 1};
  }
}

/* The side of the triangle that is a chord; -1 as if memory were out. */
typedef struct asked {
  const scene *of;
  long left;
} asked;

static int
is_real(void *data, uint32_t triangle, int edge)
{
  asked *a = data;
  const quad *q = &a->of->quad[triangle / 2];

  if (a->left >= 0 && a->left-- == 0) {
    return -1;
  }
  return a->of->of_triangles || edge != (q->turned ? 2 : 0);
}

/* Vertices are the quad's own, so that places are what is compared. */
static bool
add_quad(sg_cut_set *set, const scene *of, int i)
{
  const quad *q = &of->quad[i];
  int a = 2 * q->chord, b = a + 1;
  int corner[2][3] = {{a, b, q->corner[0]}, {b, a, q->corner[1]}};
  bool known = true;

  for (int k = 0; k < 2; k++) {
    int32_t v[3], p = of->of_triangles ? q->p + k : q->p;
    for (int j = 0; j < 3; j++) {
      int c = corner[q->turned ? !k : k][(j + q->turned) % 3];
      v[j] = 100 * (i + 1) + c;
      if (!sg_cut_model_vertex(&set->model, q->s, v[j], of->at[c])) {
        return false;
      }
    }
    if (!sg_cut_model_triangle(&set->model, q->s, p, 2 * i + k + 1, v,
                               &known)) {
      return false;
    }
  }
  return true;
}

/* All quads of different segments. */
static bool
cut_scene(sg_cut_set *set, const scene *of)
{
  if (of->of_triangles) {
    set->of_faces = true;
    set->flat_within = 1000.0;
  }
  for (int i = 0; i < of->quads; i++) {
    if (!add_quad(set, of, i)) {
      return false;
    }
  }
  for (uint32_t i = 0; i < set->model.triangles; i++) {
    for (uint32_t k = 0; k < set->model.triangles; k++) {
      if (set->model.triangle[i].s < set->model.triangle[k].s &&
          sg_cut_set_enter(set, i, k) < 0) {
        return false;
      }
    }
  }
  return sg_cut_set_seal(set, NULL);
}

static bool
is_corner(const sg_cut_set *set, const scene *of, uint32_t point, int corner)
{
  const sg_point *at = &set->points.point[point].at;

  return !at->exactly && at->p[0] == of->at[corner][0] &&
         at->p[1] == of->at[corner][1] && at->p[2] == of->at[corner][2];
}

/* Whether a piece of the two quads' polygons runs along their chord. */
static bool
runs_along(const sg_cut_set *set, const scene *of, const quad *x, const quad *y)
{
  for (size_t i = 0; i < set->pieces; i++) {
    const sg_cut_piece *k = &set->piece[i];
    bool ahead = is_corner(set, of, k->a, 2 * x->chord) &&
                 is_corner(set, of, k->b, 2 * x->chord + 1);
    bool back = is_corner(set, of, k->b, 2 * x->chord) &&
                is_corner(set, of, k->a, 2 * x->chord + 1);
    if ((ahead || back) && k->s[0] == x->s && k->s[1] == y->s &&
        k->p[0] / 2 == x->p / 2 && k->p[1] / 2 == y->p / 2) {
      return true;
    }
  }
  return false;
}

/* The pairs of a scene for which something else is true than wanted. */
static size_t
wrong_in(const sg_cut_set *set, const scene *of, size_t *pairs)
{
  size_t wrong = 0;

  for (int i = 0; i < of->quads; i++) {
    for (int k = 0; k < of->quads; k++) {
      const quad *x = &of->quad[i], *y = &of->quad[k];
      if (x->s < y->s && x->chord == y->chord) {
        bool same =
            x->corner[0] == y->corner[0] && x->corner[1] == y->corner[1];
        pairs[same]++;
        wrong += runs_along(set, of, x, y) == same;
      }
    }
  }
  return wrong;
}

static void
random_scenes(void)
{
  enum { SCENES = 1000 };
  size_t wrong = 0, pairs[2] = {0, 0};

  for (uint32_t seed = 0; seed < SCENES; seed++) {
    scene of;
    sg_cut_set set;
    asked a = {&of, -1};

    random_scene(&of, seed);
    sg_cut_set_init(&set, is_real, &a);
    wrong += !cut_scene(&set, &of);
    wrong += wrong_in(&set, &of, pairs);
    sg_cut_set_clear(&set);
  }
  CHECK("a line along the chord of other quads, none of the same", wrong == 0);
  CHECK("both were tried", pairs[0] > SCENES / 5 && pairs[1] > SCENES / 5);
}

/* One scene with an allocation refused, or an answer about an edge; below 0:
 * none of them. */
static long
try_scene(uint32_t seed, long allocation, long answer, bool *done)
{
  scene of;
  sg_cut_set set;
  asked a = {&of, answer};
  long bad;

  random_scene(&of, seed);
  living = 0;
  left = allocation;
  counting = true;
  sg_cut_set_init(&set, is_real, &a);
  *done = cut_scene(&set, &of);
  bad = *done != (answer >= 0 ? a.left >= 0 : left >= 0);
  left = -1;
  sg_cut_set_clear(&set);
  counting = false;
  return bad + (living != 0);
}

static long
refused(uint32_t seed, long n, bool *done)
{
  return try_scene(seed, n, -1, done);
}

static long
unanswered(uint32_t seed, long n, bool *done)
{
  return try_scene(seed, -1, n, done);
}

int
main(void)
{
  spare_gmp();
  random_scenes();
  check_refusals(refused, 30, 500);
  check_refusals(unanswered, 30, 500);
  return check_report();
}
