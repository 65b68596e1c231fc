/* self_cut_test.c -- where a segment meets itself: of triangles that are
 * changed, the same as of all of them, where one of the two is changed; corners
 * in one place are one corner.
 *
 * covers: self_cut
 */
#include "join/self_cut.h"

#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

enum { TRIANGLES = 3000, VERTICES = 3 * TRIANGLES, GRID = 12 };

static uint64_t state = 5;

static unsigned
random_below(unsigned n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (unsigned)(state >> 33) % n;
}

static double at[VERTICES][3];
static int32_t corner[TRIANGLES][3], polygon_of[TRIANGLES],
    polygon_id[TRIANGLES];
static unsigned char changed[TRIANGLES];

/* Triangles each of its own polygon, all about one size, so that each meets a
 * few others. Some have the corners of the one before, in vertices of their
 * own. */
static void
make(void)
{
  for (int32_t t = 0; t < TRIANGLES; t++) {
    double middle[3];

    for (int c = 0; c < 3; c++) {
      middle[c] = random_below(GRID << 10) / 1024.0;
    }
    for (int k = 0; k < 3; k++) {
      for (int c = 0; c < 3; c++) {
        at[3 * t + k][c] = t % 10 == 9 && k < 2
                               ? at[3 * (t - 1) + k][c]
                               : middle[c] + random_below(1 << 20) / 0x1p20;
      }
      corner[t][k] = 3 * t + k;
    }
    polygon_of[t] = t;
    polygon_id[t] = t + 1;
  }
}

static sg_dense
dense_of(uint32_t vertices[2], uint32_t polygons[2], uint32_t triangles[2])
{
  static double grain[1];

  vertices[0] = polygons[0] = triangles[0] = 0;
  vertices[1] = VERTICES;
  polygons[1] = triangles[1] = TRIANGLES;
  return (sg_dense){.segments = 1,
                    .grain = grain,
                    .vertex_begin = vertices,
                    .polygon_begin = polygons,
                    .triangle_begin = triangles,
                    .vertices = VERTICES,
                    .at = at,
                    .polygons = TRIANGLES,
                    .polygon_id = polygon_id,
                    .triangles = TRIANGLES,
                    .polygon_of = polygon_of,
                    .corner = corner};
}

/* Whether `some` are those of `all` that have a changed triangle. */
static bool
are_those_changed(const sg_self_meetings *all, const sg_self_meetings *some)
{
  size_t n = 0;
  bool same = true;

  for (size_t i = 0; i < all->n; i++) {
    const sg_self_meeting *m = &all->item[i];

    if (changed[m->t[0]] || changed[m->t[1]]) {
      same = same && n < some->n &&
             !memcmp(m->t, some->item[n].t, sizeof m->t) &&
             !memcmp(m->p, some->item[n].p, sizeof m->p) &&
             m->kind == some->item[n].kind;
      n++;
    }
  }
  return same && n == some->n;
}

/* Every so many are changed. */
static void
of_each(int32_t step, const sg_dense *d, const sg_self_meetings *all,
        sg_pool *pool)
{
  sg_self_meetings some;

  for (int32_t t = 0; t < TRIANGLES; t++) {
    changed[t] = step > 0 && t % step == step - 1;
  }
  CHECK("changed",
        sg_self_cut_changed(d, 0, changed, true, 0, pool, NULL, &some));
  CHECK("the same, of the changed", are_those_changed(all, &some));
  free(some.item);
}

/* A polygon of triangles that lie on each other in one plane, and of one that
 * does not and is far away: it is not flat. */
static void
not_flat(sg_dense d, sg_pool *pool)
{
  enum { ON = 40, ALL = ON + 1 };

  sg_self_meetings all, some;

  for (int32_t t = 0; t < ALL; t++) {
    double x = t < ON ? t / 1024.0 : 1000;

    for (int k = 0; k < 3; k++) {
      at[3 * t + k][0] = x + (k == 1);
      at[3 * t + k][1] = k == 2;
      at[3 * t + k][2] = t < ON ? 0 : k;
    }
    polygon_of[t] = 0;
    changed[t] = t == 0;
  }
  d.triangle_begin = (uint32_t[2]){0, ALL};
  d.triangles = ALL;
  CHECK("one polygon", sg_self_cut(&d, 0, 0, pool, NULL, &all));
  CHECK("a part of it is changed",
        sg_self_cut_changed(&d, 0, changed, false, 0, pool, NULL, &some));
  CHECK("they lie on each other", all.n == ON * (ON - 1) / 2);
  CHECK("the whole of it is not flat", are_those_changed(&all, &some));
  free(all.item);
  free(some.item);
}

int
main(void)
{
  uint32_t begin[3][2];
  sg_dense d = dense_of(begin[0], begin[1], begin[2]);
  sg_pool *pool = sg_pool_open(3);
  sg_self_meetings all;

  make();
  CHECK("all", sg_self_cut(&d, 0, 0, pool, NULL, &all));
  CHECK("several meet", all.n > TRIANGLES / 4);
  for (int32_t step = 0; step <= 3000; step = 3 * step + 1) {
    of_each(step, &d, &all, pool);
    of_each(step, &d, &all, NULL);
  }
  of_each(10, &d, &all, pool); /* those with a corner in another's place */
  free(all.item);
  not_flat(d, pool);
  sg_pool_close(pool);
  return check_report();
}
