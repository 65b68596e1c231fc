/* complete_test.c -- planes and triangles of many polygons, by one thread and
 * by several: triangles, some without area and some that do not close, and
 * quadrangles between them.
 *
 * covers: complete, complete_model, complete_rows, complete_triangle
 */
#include "polygon/complete.h"

#include "engine/store.h"

#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

enum { S = 3, POLYGONS = 20000, CORNERS = 4 };

enum kind { GOOD, NO_AREA, OPEN, QUADRANGLE, KINDS };

static const int32_t SIDES[KINDS] = {3, 3, 3, 4};

static enum kind
kind_of(int32_t p)
{
  return p % 7 == 3    ? NO_AREA
         : p % 11 == 5 ? OPEN
         : p % 13 == 6 ? QUADRANGLE
                       : GOOD;
}

/* Corner k of polygon p: a square; without area, its diagonal. */
static bool
add_corner(sg_world *world, int32_t p, int32_t k)
{
  double x = p % 100 + (k == 1 || k == 2 ? 0.5 : 0), y = p / 100;

  y += k >= 2 ? 0.5 : 0;
  if (kind_of(p) == NO_AREA) {
    x = y = p + k;
  }
  return sg_world_add(world, SG_V,
                      (sg_value[]){{.i = S},
                                   {.i = CORNERS * p + k + 1},
                                   {.f = x},
                                   {.f = y},
                                   {.f = 0}},
                      NULL, NULL) == SG_OK;
}

/* The last edge of one that is open ends in its second corner. */
static int32_t
end_of(int32_t p, int32_t k, int32_t n)
{
  int32_t next = (k + 1) % n;

  return next == 0 && kind_of(p) == OPEN ? 1 : next;
}

static bool
add_polygon(sg_world *world, int32_t p)
{
  int32_t n = SIDES[kind_of(p)], list[CORNERS + 1] = {n};
  bool good = true;

  for (int32_t k = 0; k < n; k++) {
    list[1 + k] = CORNERS * p + k + 1;
    good = good && add_corner(world, p, k);
  }
  for (int32_t k = 0; k < n; k++) {
    good = good && sg_world_add(world, SG_E,
                                (sg_value[]){{.i = S},
                                             {.i = list[1 + k]},
                                             {.i = list[1 + k]},
                                             {.i = list[1 + end_of(p, k, n)]},
                                             {.i = 1}},
                                NULL, NULL) == SG_OK;
  }
  return good &&
         sg_world_add(world, SG_P,
                      (sg_value[]){{.i = S}, {.i = p + 1}, {.list = list}},
                      NULL, NULL) == SG_OK;
}

static bool
see_none(void *of, sg_flatness *out)
{
  (void)of;
  sg_flatness_init(out, 0);
  return true;
}

static bool
completes(sg_world *world, sg_pool *pool, sg_completion *out)
{
  static const sg_relation READ[5] = {SG_V, SG_E, SG_P, SG_PLANE, SG_T};
  const sg_version *version = sg_world_version(world);
  sg_view view[5] = {{0}};
  bool good = true, stopped;

  for (int i = 0; i < 5; i++) {
    good = good && sg_version_view(version, READ[i], &view[i]);
  }
  const sg_completion_input in = {
      .v = &view[0],
      .e = &view[1],
      .p = &view[2],
      .plane = &view[3],
      .t = &view[4],
      .contacts = SIZE_MAX / 2,
      .see = see_none,
      .pool = pool,
  };

  good = good && sg_complete(&in, out, &stopped, NULL) && !stopped;
  for (int i = 0; i < 5; i++) {
    sg_view_clear(&view[i]);
  }
  sg_version_drop(version);
  return good;
}

static bool
same_triangles(const sg_triangle_rows *a, const sg_triangle_rows *b)
{
  bool same = a->n == b->n;

  for (int k = 0; k < 3 && same; k++) {
    same = !memcmp(a->v[k], b->v[k], a->n * sizeof *a->v[k]);
  }
  return same && !memcmp(a->p, b->p, a->n * sizeof *a->p) &&
         !memcmp(a->t, b->t, a->n * sizeof *a->t);
}

static bool
same_planes(const sg_plane_rows *a, const sg_plane_rows *b)
{
  bool same = a->n == b->n && !memcmp(a->p, b->p, a->n * sizeof *a->p);

  for (int k = 0; k < 4 && same; k++) {
    same = !memcmp(a->c[k], b->c[k], a->n * sizeof *a->c[k]);
  }
  return same;
}

static bool
are_in_order(const sg_triangle_rows *t)
{
  bool good = true;

  for (size_t i = 0; i < t->n; i++) {
    good = good && t->t[i] == (int32_t)i && (i == 0 || t->p[i - 1] <= t->p[i]);
  }
  return good;
}

static size_t
faults_of(const sg_completion *c, sg_fault_kind kind)
{
  size_t n = 0;

  for (size_t i = 0; i < c->faults; i++) {
    n += c->fault[i].kind == kind;
  }
  return n;
}

int
main(void)
{
  sg_world *world = sg_world_open();
  sg_pool *pool = sg_pool_open(4);
  sg_completion alone = {0}, together = {0};
  size_t of[KINDS] = {0};
  bool good = world && pool;

  for (int32_t p = 0; p < POLYGONS && good; p++) {
    good = add_polygon(world, p);
    of[kind_of(p)]++;
  }
  CHECK("a world", good);
  CHECK("by one", good && completes(world, NULL, &alone));
  CHECK("by several", good && completes(world, pool, &together));
  CHECK("planes", alone.planes.n == of[GOOD] + of[QUADRANGLE]);
  CHECK("triangles", alone.triangles.n == of[GOOD] + 2 * of[QUADRANGLE]);
  CHECK("in the order of the polygons", are_in_order(&alone.triangles));
  CHECK("without area", faults_of(&alone, SG_FAULT_NO_AREA) == of[NO_AREA]);
  CHECK("open", faults_of(&alone, SG_FAULT_OPEN) == of[OPEN]);
  CHECK("the same planes", same_planes(&alone.planes, &together.planes));
  CHECK("the same triangles",
        same_triangles(&alone.triangles, &together.triangles));
  CHECK("the same faults", alone.faults == together.faults);
  sg_completion_clear(&alone);
  sg_completion_clear(&together);
  sg_pool_close(pool);
  sg_world_drop(world);
  return check_report();
}
