/* stroke_crossing_test.c -- crossings by hand, and of random strokes, found
 * again by looking at all pairs of pieces. */
#include "tests/check.h"

#include "drawing/stroke_crossing.h"

#include <math.h>
#include <stdlib.h>

enum { STROKES = 40, POINTS = 6 };

static uint64_t state = 11;

static int64_t
draw(int64_t n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (int64_t)(state >> 33) % n;
}

/* The marks of two strokes of two points. */
static sg_stroke_marks
marks_of(const int64_t a[2][2], const int64_t b[2][2])
{
  sg_crossing_stroke stroke[] = {{a, 2}, {b, 2}};
  sg_stroke_marks marks = {0};

  CHECK("found", sg_stroke_crossings(stroke, 2, NULL, &marks));
  return marks;
}

static void
test_two(void)
{
  const int64_t along[2][2] = {{0, 0}, {10000, 0}};
  const int64_t up[2][2] = {{3000, -4000}, {3000, 4000}};
  const int64_t ends[2][2] = {{5000, 15}, {5000, 900}};
  const int64_t off[2][2] = {{5000, 25}, {5000, 900}};
  const int64_t flat[2][2] = {{0, -500}, {10000, 500}};
  const int64_t corner[2][2] = {{10000, 0}, {10000, 800}};
  sg_stroke_marks m = marks_of(along, up);

  CHECK("each is crossed", m.n == 2 && m.item[0].stroke == 1 &&
                               m.item[0].way == 3000 && m.item[1].stroke == 2 &&
                               m.item[1].way == 4000);
  free(m.item);
  m = marks_of(along, ends);
  CHECK("an end nearby",
        m.n == 2 && m.item[0].way == 5000 && m.item[1].way == 0);
  free(m.item);
  m = marks_of(along, off);
  CHECK("too far", m.n == 0);
  free(m.item);
  m = marks_of(along, flat);
  CHECK("at 6 degrees", m.n == 0);
  free(m.item);
  m = marks_of(along, corner);
  CHECK("at both ends", m.n == 2 && m.item[0].way == 10000);
  free(m.item);
}

/* A zigzag crosses itself, not at its corners; near marks are one. */
static void
test_itself(void)
{
  const int64_t loop[4][2] = {{0, 0}, {4000, 4000}, {4000, 0}, {0, 4000}};
  const int64_t comb[4][2] = {{100, -50}, {100, 50}, {150, 50}, {150, -50}};
  const int64_t along[2][2] = {{0, 0}, {1000, 0}};
  sg_crossing_stroke stroke[] = {{along, 2}, {comb, 4}};
  sg_stroke_marks m = {0};

  CHECK("itself",
        sg_stroke_crossings(&(sg_crossing_stroke){loop, 4}, 1, NULL, &m));
  CHECK("twice at one place",
        m.n == 2 && fabs(m.item[0].way - 2000 * sqrt(2)) < 1e-9 &&
            fabs(m.item[1].way - m.item[0].way - 4000 - 4000 * sqrt(2)) < 1e-9);
  m.n = 0;
  CHECK("two teeth", sg_stroke_crossings(stroke, 2, NULL, &m));
  CHECK("as one", m.n == 2 && m.item[0].way == 100 && m.item[1].way == 50);
  free(m.item);
}

/* How many pieces of other strokes the piece crosses, well inside both. */
static bool
crossed_at(const int64_t a[2], const int64_t b[2], const int64_t c[2],
           const int64_t d[2], double *part)
{
  double ux = (double)(b[0] - a[0]), uy = (double)(b[1] - a[1]);
  double vx = (double)(d[0] - c[0]), vy = (double)(d[1] - c[1]);
  double wx = (double)(c[0] - a[0]), wy = (double)(c[1] - a[1]);
  double det = ux * vy - uy * vx;

  if (fabs(det) < 0.2 * hypot(ux, uy) * hypot(vx, vy)) {
    return false;
  }
  *part = (wx * vy - wy * vx) / det;
  double other = (wx * uy - wy * ux) / det;
  return *part > 0 && *part < 1 && other > 0 && other < 1;
}

static void
test_random(void)
{
  static int64_t at[STROKES][POINTS][2];
  sg_crossing_stroke stroke[STROKES];
  sg_stroke_marks m = {0};
  size_t wanted = 0, found = 0;

  for (int s = 0; s < STROKES; s++) {
    for (int i = 0; i < POINTS; i++) {
      at[s][i][0] = draw(400000);
      at[s][i][1] = draw(300000);
    }
    stroke[s] = (sg_crossing_stroke){(const int64_t(*)[2])at[s], POINTS};
  }
  CHECK("random", sg_stroke_crossings(stroke, STROKES, NULL, &m));
  for (int s = 0; s < STROKES; s++) {
    double before = 0;
    for (int i = 1; i < POINTS; i++) {
      const int64_t *a = at[s][i - 1], *b = at[s][i];
      double length = hypot((double)(b[0] - a[0]), (double)(b[1] - a[1]));
      for (int t = 0; t < STROKES; t++) {
        double part;
        for (int j = 1; t != s && j < POINTS; j++) {
          if (!crossed_at(a, b, at[t][j - 1], at[t][j], &part)) {
            continue;
          }
          bool seen = false;
          for (size_t k = 0; k < m.n && !seen; k++) {
            double off = before + part * length - m.item[k].way;
            seen = m.item[k].stroke == s + 1 && off > -1e-6 &&
                   off < SG_CROSSING_APART;
          }
          wanted++;
          found += seen;
        }
      }
      before += length;
    }
  }
  CHECK("many cross", wanted > 1000);
  CHECK("all are found", found == wanted);
  for (size_t k = 1; k < m.n; k++) {
    CHECK("in order, apart",
          m.item[k].stroke > m.item[k - 1].stroke ||
              (m.item[k].stroke == m.item[k - 1].stroke &&
               m.item[k].way >= m.item[k - 1].way + SG_CROSSING_APART));
  }
  free(m.item);
}

int
main(void)
{
  test_two();
  test_itself();
  test_random();
  return check_report();
}
