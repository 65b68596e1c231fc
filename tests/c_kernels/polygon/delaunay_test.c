/* delaunay_test.c -- vertices that are put into triangles, wherever they lie.
 */
#include "engine/list.h"
#include "polygon/delaunay.h"

#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 64, CORNERS = 4 };

/* Points of a grid: integers, so that areas are exact here. */
typedef struct sheet {
  sg_work *work;
  sg_triangles list;
  int at[CORNERS + MOST][2];
  int32_t n;
} sheet;

static int32_t
enter(sheet *s, int x, int y)
{
  sg_point p;

  sg_point_set(&p, (const double[3]){x, y, 0});
  s->at[s->n][0] = x;
  s->at[s->n][1] = y;
  s->n++;
  return sg_work_vertex(s->work, s->n, &p);
}

static bool
put(sheet *s, int32_t a, int32_t b, int32_t c)
{
  return SG_PUSH(s->list, ((sg_triangle){{a, b, c}}));
}

static void
close_sheet(sheet *s)
{
  free(s->list.item);
  sg_work_close(s->work);
}

/* A square of so many steps, in two triangles. */
static sheet
open_sheet(int size)
{
  sheet s = {.work = sg_work_open((const double[3]){0, 0, 1})};

  enter(&s, 0, 0);
  enter(&s, size, 0);
  enter(&s, size, size);
  enter(&s, 0, size);
  CHECK("two triangles", put(&s, 0, 1, 2) && put(&s, 0, 2, 3));
  return s;
}

/* Twice the area of a, b, c. */
static int
area(const sheet *s, int32_t a, int32_t b, int32_t c)
{
  const int *p = s->at[a], *q = s->at[b], *r = s->at[c];

  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

static bool
same_place(const sheet *s, int32_t a, int32_t b)
{
  return memcmp(s->at[a], s->at[b], sizeof s->at[a]) == 0;
}

/* Whether vertex v lies in triangle t or on its border, and at no corner. */
static bool
is_in(const sheet *s, const sg_triangle *t, int32_t v)
{
  for (int k = 0; k < 3; k++) {
    if (same_place(s, t->v[k], v) ||
        area(s, t->v[k], t->v[(k + 1) % 3], v) < 0) {
      return false;
    }
  }
  return true;
}

/* How many triangles have the side a -> b. */
static int
sides(const sheet *s, int32_t a, int32_t b)
{
  int n = 0;

  for (size_t i = 0; i < s->list.n; i++) {
    const int32_t *v = s->list.item[i].v;
    for (int k = 0; k < 3; k++) {
      n += v[k] == a && v[(k + 1) % 3] == b;
    }
  }
  return n;
}

static bool
on_border(const sheet *s, int size, int32_t a, int32_t b)
{
  for (int axis = 0; axis < 2; axis++) {
    int x = s->at[a][axis];
    if (x == s->at[b][axis] && (x == 0 || x == size)) {
      return true;
    }
  }
  return false;
}

/* The triangles cover the square once, and every place in it is a corner. */
static bool
is_whole(const sheet *s, int size)
{
  int sum = 0;

  for (size_t i = 0; i < s->list.n; i++) {
    const sg_triangle *t = &s->list.item[i];
    int one = area(s, t->v[0], t->v[1], t->v[2]);
    sum += one;
    for (int32_t v = 0; v < s->n; v++) {
      if (one <= 0 || is_in(s, t, v)) {
        return false;
      }
    }
    for (int k = 0; k < 3; k++) {
      int32_t a = t->v[k], b = t->v[(k + 1) % 3];
      if (sides(s, a, b) != 1 || sides(s, b, a) != !on_border(s, size, a, b)) {
        return false;
      }
    }
  }
  return sum == 2 * size * size;
}

/* Points inside, on sides, on corners, beside the square, and again. */
static void
test_random(void)
{
  bool whole = true;

  srand(16);
  for (int round = 0; round < 2000; round++) {
    int size = 1 + rand() % 8;
    sheet s = open_sheet(size);
    for (int i = rand() % MOST; i > 0; i--) {
      int x = rand() % (size + 3) - 1, y = rand() % (size + 3) - 1;
      int32_t v = enter(&s, x, y);
      whole = whole && sg_triangles_insert(s.work, &s.list, v);
    }
    whole = whole && is_whole(&s, size);
    close_sheet(&s);
  }
  CHECK("each place becomes a corner once", whole);
}

/* Many vertices in one place add triangles once: they doubled them before. */
static void
test_one_place(void)
{
  static const int place[][2] = {{0, 0}, {4, 4}, {2, 2}, {1, 0}, {3, 1}};

  for (int k = 0; k < 5; k++) {
    sheet s = open_sheet(4);
    size_t first = 0;
    for (int i = 0; i < MOST; i++) {
      sg_triangles_insert(s.work, &s.list, enter(&s, place[k][0], place[k][1]));
      first = i == 0 ? s.list.n : first;
      if (s.list.n > first) {
        break;
      }
    }
    CHECK("once", s.list.n == first && is_whole(&s, 4));
    close_sheet(&s);
  }
}

/* A triangle without area between two others, its middle corner third: what is
 * put on it divides all three so that their sides still meet. */
static void
test_no_area(void)
{
  static const struct {
    int x;
    size_t n;
  } on[] = {{1, 6}, {3, 6}, {2, 6}, {0, 4}, {4, 4}, {5, 4}, {-1, 4}};

  for (size_t k = 0; k < sizeof on / sizeof *on; k++) {
    sheet s = open_sheet(4);
    int32_t up, down, middle;
    bool met = true;
    s.list.n = 0;
    up = enter(&s, 2, 4);
    down = enter(&s, 2, -4);
    middle = enter(&s, 2, 0);
    put(&s, 0, middle, up);
    put(&s, middle, 1, up);
    put(&s, 1, 0, down);
    put(&s, 0, 1, middle);
    sg_triangles_insert(s.work, &s.list, enter(&s, on[k].x, 0));
    for (size_t i = 0; i < s.list.n; i++) {
      const int32_t *v = s.list.item[i].v;
      for (int j = 0; j < 3; j++) {
        int32_t a = v[j], b = v[(j + 1) % 3];
        bool rim = a == up || b == up ? a < 2 || b < 2 : false;
        rim = rim || ((a == down || b == down) && (a < 2 || b < 2));
        met = met && sides(&s, a, b) == 1 && (rim || sides(&s, b, a) == 1);
      }
    }
    CHECK("sides meet", met);
    CHECK("so many", s.list.n == on[k].n);
    close_sheet(&s);
  }
}

int
main(void)
{
  test_random();
  test_one_place();
  test_no_area();
  return check_report();
}
