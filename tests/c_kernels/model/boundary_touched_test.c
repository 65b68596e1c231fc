/* boundary_touched_test.c -- polygons that other faces touch inside. */
#include "tests/check.h"

#include "model/boundary_touched.h"

/* A square 0 1 2 3 of two or four triangles, and a triangle beside it: what
 * else there is does not matter. */
static int32_t from[7] = {0, 1, 2, 3, 0, 0, 0};
static int32_t to[7] = {1, 2, 3, 0, 0, 0, 0};
static int32_t list[7] = {0, 1, 2, 3, 4, 5, 6};
static uint32_t list_begin[3] = {0, 4, 7};
static uint32_t vertex_begin[2] = {0, 7}, polygon_begin[2] = {0, 2};
static uint32_t triangle_begin[2];
static int32_t polygon_of[5];
static int32_t corner[5][3];

static void
put(int32_t polygon, int32_t a, int32_t b, int32_t c)
{
  uint32_t t = triangle_begin[1]++;

  polygon_of[t] = polygon;
  corner[t][0] = a, corner[t][1] = b, corner[t][2] = c;
}

static void
beside(int32_t a, int32_t b, int32_t c)
{
  const int32_t v[3] = {a, b, c};

  for (int k = 0; k < 3; k++) {
    from[4 + k] = v[k];
    to[4 + k] = v[(k + 1) % 3];
  }
  put(1, a, b, c);
}

/* How many triangles the square goes out as, 0: it stays one; the other
 * polygon never has any. -1: no memory. */
static int
parts_of_square(const uint32_t number[7])
{
  sg_dense d = {.segments = 1,
                .vertex_begin = vertex_begin,
                .polygon_begin = polygon_begin,
                .triangle_begin = triangle_begin,
                .vertices = 7,
                .edges = 7,
                .from = from,
                .to = to,
                .polygons = 2,
                .list_begin = list_begin,
                .list = list,
                .triangles = triangle_begin[1],
                .polygon_of = polygon_of,
                .corner = corner};
  sg_touched touched;
  bool stopped;
  int parts = -1;

  if (sg_touched_find(&d, 0, number, false, NULL, &touched, &stopped)) {
    parts = touched.begin ? (int)touched.begin[1] : 0;
    CHECK("the triangle stays one",
          !touched.begin || touched.begin[2] == touched.begin[1]);
  }
  sg_touched_clear(&touched);
  return parts;
}

static void
halves(void)
{
  triangle_begin[1] = 0;
  put(0, 0, 1, 2);
  put(0, 2, 3, 0);
}

static bool
never(void *data)
{
  (void)data;
  return true;
}

int
main(void)
{
  const uint32_t own[7] = {0, 1, 2, 3, 4, 5, 6};
  const uint32_t same[7] = {0, 1, 2, 3, 0, 2, 6};

  halves();
  beside(1, 0, 4);
  CHECK("an edge of both polygons is at the border", parts_of_square(own) == 0);
  halves();
  beside(2, 0, 4);
  CHECK("a chord that is an edge elsewhere", parts_of_square(own) == 2);
  halves();
  beside(4, 5, 6);
  CHECK("another place", parts_of_square(own) == 0);
  CHECK("another number for the same place", parts_of_square(same) == 2);
  triangle_begin[1] = 0;
  put(0, 0, 1, 4);
  put(0, 1, 2, 4);
  put(0, 2, 3, 4);
  put(0, 3, 0, 4);
  beside(4, 5, 6);
  CHECK("a vertex inside", parts_of_square(own) == 4);

  sg_cancel stop = {never, NULL};
  sg_dense d = {.segments = 1,
                .vertex_begin = vertex_begin,
                .polygon_begin = polygon_begin,
                .triangle_begin = triangle_begin,
                .list_begin = list_begin,
                .list = list,
                .from = from,
                .to = to,
                .polygon_of = polygon_of,
                .corner = corner};
  sg_touched touched;
  bool stopped;
  CHECK("it can be stopped",
        !sg_touched_find(&d, 0, own, false, &stop, &touched, &stopped) &&
            stopped);
  return check_report();
}
