/* contact_test.c -- contacts of two triangles: every pair of features, exact
 * and nearly so, the same whichever triangle comes first; and better triangles.
 */
#include "join/contact.h"
#include "number/exact.h"
#include "polygon/delaunay.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double reach = 1e-9;

/* ---- single contacts ---- */

static const double flat[3][3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

/* The one contact of `flat` and b, or nothing. */
static bool
one(double b[3][3], sg_feature f, sg_feature g, bool exact)
{
  sg_contact c[SG_CONTACT_MAX], d[SG_CONTACT_MAX];
  int n = sg_contacts(flat, (const double(*)[3])b, reach, c);
  int m = sg_contacts((const double(*)[3])b, flat, reach, d);

  return n == 1 && m == 1 && c[0].f[0] == f && c[0].f[1] == g &&
         c[0].exact == exact && d[0].f[0] == g && d[0].f[1] == f &&
         d[0].exact == exact && c[0].distance <= reach;
}

static void
test_features(void)
{
  const double e = 1e-12;
  double on_corner[3][3] = {{0, 0, 0}, {-1, -1, 3}, {-2, -1, 5}};
  double on_edge[3][3] = {{1, 0, 0}, {1, -1, 3}, {2, -1, 5}};
  double on_face[3][3] = {{1, 1, 0}, {1, 2, 3}, {2, 1, 5}};
  double crossing[3][3] = {{1, -1, -1}, {1, 1, 1}, {1, -3, 2}};

  CHECK("corner on corner", one(on_corner, SG_CORNER_0, SG_CORNER_0, true));
  CHECK("corner on edge", one(on_edge, SG_EDGE_0, SG_CORNER_0, true));
  CHECK("corner on face", one(on_face, SG_FACE, SG_CORNER_0, true));
  CHECK("edge on edge", one(crossing, SG_EDGE_0, SG_EDGE_0, true));
  for (int k = 0; k < 3; k++) {
    on_corner[k][2] += e;
    on_edge[k][2] -= e;
    on_face[k][2] += e;
    crossing[k][2] -= e;
  }
  CHECK("corner near corner", one(on_corner, SG_CORNER_0, SG_CORNER_0, false));
  CHECK("corner near edge", one(on_edge, SG_EDGE_0, SG_CORNER_0, false));
  CHECK("corner near face", one(on_face, SG_FACE, SG_CORNER_0, false));
  CHECK("edge near edge", one(crossing, SG_EDGE_0, SG_EDGE_0, false));
}

/* The feature of a triangle whose corners are counted from corner i on. */
static sg_feature
counted_from(sg_feature f, int i)
{
  int first = f < SG_EDGE_0 ? SG_CORNER_0 : SG_EDGE_0;

  return f == SG_FACE ? f : (sg_feature)(first + ((int)f - first + 3 - i) % 3);
}

/* The contact of flat and b is found whichever corners are their first ones. */
static bool
from_all_corners(double b[3][3], sg_feature f, sg_feature g)
{
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      double a2[3][3], b2[3][3];
      sg_contact c[SG_CONTACT_MAX];
      for (int k = 0; k < 3; k++) {
        memcpy(a2[k], flat[(k + i) % 3], sizeof a2[k]);
        memcpy(b2[k], b[(k + j) % 3], sizeof b2[k]);
      }
      int n =
          sg_contacts((const double(*)[3])a2, (const double(*)[3])b2, reach, c);
      if (n != 1 || c[0].f[0] != counted_from(f, i) ||
          c[0].f[1] != counted_from(g, j)) {
        return false;
      }
    }
  }
  return true;
}

static void
test_all_corners(void)
{
  for (int near = 0; near < 2; near++) {
    const double e = near ? 1e-12 : 0;
    double on_corner[3][3] = {{0, 0, e}, {-1, -1, 3}, {-2, -1, 5}};
    double on_edge[3][3] = {{1, 0, e}, {1, -1, 3}, {2, -1, 5}};
    double on_face[3][3] = {{1, 1, e}, {1, 2, 3}, {2, 1, 5}};
    double crossing[3][3] = {{1, -1, -1 - e}, {1, 1, 1 - e}, {1, -3, 2 - e}};

    CHECK("any corner on any",
          from_all_corners(on_corner, SG_CORNER_0, SG_CORNER_0));
    CHECK("on any edge", from_all_corners(on_edge, SG_EDGE_0, SG_CORNER_0));
    CHECK("on the face", from_all_corners(on_face, SG_FACE, SG_CORNER_0));
    CHECK("any edge on any", from_all_corners(crossing, SG_EDGE_0, SG_EDGE_0));
  }
}

static int
contacts(double b[3][3], double within)
{
  sg_contact c[SG_CONTACT_MAX];

  return sg_contacts(flat, (const double(*)[3])b, within, c);
}

static void
test_none(void)
{
  double above[3][3] = {{1, 1, 1e-6}, {1, 2, 3}, {2, 1, 5}};
  double through[3][3] = {{1, 1, -1}, {1, 2, 3}, {2, 1, 5}};
  double huge[3][3] = {{1e300, 0, 0}, {-1e300, 1, 0}, {0, 1e300, 1e300}};

  CHECK("beyond the reach", contacts(above, reach) == 0);
  CHECK("within a wider one", contacts(above, 1e-5) == 1);
  CHECK("what goes through touches nothing", contacts(through, reach) == 0);
  CHECK("smaller than the reach", contacts(above, 10) == 0);
  CHECK("huge", contacts(huge, reach) >= 0);
}

/* ---- nothing has to move where all contacts are exact ---- */

/* The part of `t` where plane[0] x + plane[1] y <= plane[2], seen along z. */
static int
clip(double (*t)[2], int n, const double plane[3])
{
  double out[16][2];
  int m = 0;

  for (int i = 0; i < n; i++) {
    const double *a = t[i], *b = t[(i + 1) % n];
    double x = plane[0] * a[0] + plane[1] * a[1] - plane[2];
    double y = plane[0] * b[0] + plane[1] * b[1] - plane[2];

    if (x <= 0) {
      memcpy(out[m++], a, sizeof *out);
    }
    if (x * y < 0) {
      for (int k = 0; k < 2; k++) {
        out[m][k] = a[k] + (b[k] - a[k]) * (x / (x - y));
      }
      m++;
    }
  }
  memcpy(t, out, (size_t)m * sizeof *out);
  return m;
}

/* What two triangles have in common, seen along z. */
static double
common_area(const double a[3][3], const double b[3][3])
{
  double t[16][2], area = 0;
  int n = 3;
  double turn = (a[1][0] - a[0][0]) * (a[2][1] - a[0][1]) -
                (a[1][1] - a[0][1]) * (a[2][0] - a[0][0]);

  for (int i = 0; i < 3; i++) {
    t[i][0] = b[i][0];
    t[i][1] = b[i][1];
  }
  for (int i = 0; i < 3 && n > 0; i++) {
    const double *p = a[i], *q = a[(i + 1) % 3];
    double plane[3] = {q[1] - p[1], p[0] - q[0], 0};
    for (int k = 0; k < 3; k++) {
      plane[k] = turn < 0 ? -plane[k] : plane[k];
    }
    plane[2] = plane[0] * p[0] + plane[1] * p[1];
    n = clip(t, n, plane);
  }
  for (int i = 0; i < n; i++) {
    const double *p = t[i], *q = t[(i + 1) % n];
    area += p[0] * q[1] - p[1] * q[0];
  }
  return fabs(area) / 2;
}

/* Triangles on a grid, with corners lifted by less than the reach or not at
 * all: those that lie on each other without being in one plane have a contact
 * that is not exact. Counts those, and those side by side with exact contacts.
 * False: a fault. */
static bool
lifted(int *on, int *beside)
{
  double t[2][3][3];
  sg_contact c[SG_CONTACT_MAX];
  bool exact = true, plane = true;

  for (int i = 0; i < 18; i++) {
    t[i / 9][i / 3 % 3][i % 3] =
        i % 3 < 2 ? rand() % 4 : rand() % 3 * 0.125 * reach;
  }
  if (rand() % 2) { /* two corners of the first */
    memcpy(t[1], t[0], 6 * sizeof(double));
  }
  const double(*a)[3] = (const double(*)[3])t[0];
  const double(*b)[3] = (const double(*)[3])t[1];
  int n = sg_contacts(a, b, reach, c);

  for (int i = 0; i < n; i++) {
    exact = exact && c[i].exact;
  }
  for (int i = 0; i < 3; i++) {
    plane = plane && sg_orient3d(a[0], a[1], a[2], b[i]) == 0;
  }
  bool over = common_area(a, b) > 1e-6;

  *on += over && !plane;
  *beside += !over && !plane && n >= 2 && exact;
  return !over || plane || !exact;
}

static void
test_exact(void)
{
  double beside[3][3] = {{4, 0, 0}, {4, 4, 1e-13}, {0, 4, 0}};
  int on = 0, near = 0;
  bool good = true;

  CHECK("a side in common", contacts(beside, reach) == 2);
  for (int i = 0; i < 200000; i++) {
    good = lifted(&on, &near) && good;
  }
  CHECK("what lies on each other has a contact that is not exact", good);
  CHECK("many do", on > 10000);
  CHECK("what is side by side need not", near > 1000);
}

/* ---- turned pairs of a grid ---- */

/* The contacts of two triangles with corners on a small grid that are exact;
 * and those of the same two, turned, must be the same features. */
static void
turn(const double rotation[3][3], double t[3][3])
{
  for (int i = 0; i < 3; i++) {
    double at[3] = {t[i][0], t[i][1], t[i][2]};
    for (int k = 0; k < 3; k++) {
      t[i][k] = rotation[k][0] * at[0] + rotation[k][1] * at[1] +
                rotation[k][2] * at[2];
    }
  }
}

static bool
same_turned(void)
{
  static const double rotation[3][3] = {{2.0 / 3, -1.0 / 3, 2.0 / 3},
                                        {2.0 / 3, 2.0 / 3, -1.0 / 3},
                                        {-1.0 / 3, 2.0 / 3, 2.0 / 3}};
  double t[2][3][3];
  sg_contact before[SG_CONTACT_MAX], after[SG_CONTACT_MAX];

  for (int i = 0; i < 18; i++) {
    t[i / 9][i / 3 % 3][i % 3] = rand() % 3;
  }
  int n = sg_contacts((const double(*)[3])t[0], (const double(*)[3])t[1], reach,
                      before);
  turn(rotation, t[0]);
  turn(rotation, t[1]);
  int m = sg_contacts((const double(*)[3])t[0], (const double(*)[3])t[1], reach,
                      after);
  bool same = n == m;

  for (int i = 0; i < n && same; i++) {
    same = before[i].exact && before[i].f[0] == after[i].f[0] &&
           before[i].f[1] == after[i].f[1];
  }
  return same;
}

/* ---- whether they are exact is not asked ---- */

/* The same contacts, and none of them is said to be exact but where corners
 * are in one place. */
static bool
same_near(unsigned *exact)
{
  const double within = 0x1p-10;
  double t[2][3][3];
  sg_contact all[SG_CONTACT_MAX], near[SG_CONTACT_MAX];

  for (int i = 0; i < 18; i++) {
    t[i / 9][i / 3 % 3][i % 3] = rand() % 3 + (rand() % 4 == 0) * within / 2;
  }
  int n = sg_contacts((const double(*)[3])t[0], (const double(*)[3])t[1],
                      within, all);
  int m = sg_contacts_near((const double(*)[3])t[0], (const double(*)[3])t[1],
                           within, near);
  bool same = n == m;

  for (int i = 0; i < n && same; i++) {
    bool corners = all[i].f[0] <= SG_CORNER_2 && all[i].f[1] <= SG_CORNER_2;

    *exact += all[i].exact && !corners;
    same = near[i].f[0] == all[i].f[0] && near[i].f[1] == all[i].f[1] &&
           near[i].distance == all[i].distance &&
           memcmp(near[i].at, all[i].at, sizeof near[i].at) == 0 &&
           near[i].exact == (corners && all[i].exact);
  }
  return same;
}

/* ---- scales ---- */

/* Triangles on a grid, one lifted by less or more than the reach, have the same
 * contacts in every unit: times a power of two, to the last bit. */
static bool
same_scaled(void)
{
  const double within = 0x1p-10;
  double t[2][3][3], u[2][3][3];
  sg_contact before[SG_CONTACT_MAX], after[SG_CONTACT_MAX];
  bool same = true;
  double lift = (rand() % 3) * 0.75 * within;

  for (int i = 0; i < 18; i++) {
    t[i / 9][i / 3 % 3][i % 3] = rand() % 4;
  }
  for (int i = 0; i < 3; i++) {
    t[1][i][2] += lift;
  }
  int n = sg_contacts((const double(*)[3])t[0], (const double(*)[3])t[1],
                      within, before);

  for (int k = -40; k <= 40 && same; k += 5) {
    for (int i = 0; i < 18; i++) {
      u[i / 9][i / 3 % 3][i % 3] = ldexp(t[i / 9][i / 3 % 3][i % 3], k);
    }
    int m = sg_contacts((const double(*)[3])u[0], (const double(*)[3])u[1],
                        ldexp(within, k), after);
    same = m == n;
    for (int i = 0; i < n && same; i++) {
      same = before[i].f[0] == after[i].f[0] &&
             before[i].f[1] == after[i].f[1] &&
             before[i].exact == after[i].exact &&
             ldexp(before[i].distance, k) == after[i].distance;
    }
  }
  return same;
}

/* What lies within the reach is found whether that is above one or below. */
static void
test_reach(void)
{
  for (int k = -30; k <= 30; k += 3) {
    double a[3][3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    double b[3][3] = {{1, 1, 0.001}, {1, 2, 3}, {2, 1, 5}};
    sg_contact c[SG_CONTACT_MAX];

    for (int i = 0; i < 9; i++) {
      a[i / 3][i % 3] = ldexp(a[i / 3][i % 3], k);
      b[i / 3][i % 3] = ldexp(b[i / 3][i % 3], k);
    }
    int n = sg_contacts((const double(*)[3])a, (const double(*)[3])b,
                        ldexp(0.002, k), c);
    CHECK("within the reach", n == 1 && c[0].f[0] == SG_FACE && !c[0].exact);
    CHECK("beyond it", sg_contacts((const double(*)[3])a, (const double(*)[3])b,
                                   ldexp(0.0009, k), c) == 0);
  }
}

/* ---- better triangles ---- */

static bool
is_side(void *data, int32_t a, int32_t b)
{
  int32_t n = *(int32_t *)data;

  return (a + 1) % n == b || (b + 1) % n == a;
}

/* Turning once more changes no triangle. */
static bool
stays(const sg_work *work, sg_triangles *list, int32_t *n)
{
  size_t bytes = list->n * sizeof *list->item;
  sg_triangle *before = malloc(bytes);
  bool same = before;

  if (same) {
    memcpy(before, list->item, bytes);
    same = sg_triangles_delaunay(work, list, is_side, n, NULL) == SG_DONE &&
           memcmp(before, list->item, bytes) == 0;
  }
  free(before);
  return same;
}

/* A long thin fan over a flat arc becomes a strip; a point inside and one on a
 * chord become corners; the area stays. */
static void
test_delaunay(void)
{
  enum { N = 12 };
  sg_work *work = sg_work_open((const double[3]){0, 0, 1});
  sg_triangles list = {0};
  int32_t n = N, edge, least = 0;
  double area = 0, low = INFINITY;

  for (int32_t i = 0; i < N + 2; i++) {
    double angle = 2 * 3.14159265358979 * i / N;
    sg_point p;
    double at[3] = {cos(angle), sin(angle), 0};
    if (i >= N) {
      at[0] = at[1] = i == N ? 0.1 : 0;
    }
    sg_point_set(&p, at);
    sg_work_vertex(work, i + 1, &p);
  }
  for (int32_t i = 0; i < N; i++) {
    sg_work_add(work, i, (i + 1) % N, 1, 0);
  }
  CHECK("triangulated",
        sg_work_triangulate(work, &list, &edge, NULL) == SG_DONE &&
            list.n == N - 2);
  CHECK("not settled before", !list.settled);
  CHECK("a point inside", sg_triangles_insert(work, &list, N) && list.n == N);
  CHECK("one in the middle",
        sg_triangles_insert(work, &list, N + 1) && list.n == N + 2);
  CHECK("better",
        sg_triangles_delaunay(work, &list, is_side, &n, NULL) == SG_DONE);
  CHECK("settled", list.settled && stays(work, &list, &n));
  for (size_t i = 0; i < list.n; i++) {
    const int32_t *v = list.item[i].v;
    const double *a = sg_work_point(work, v[0])->p;
    const double *b = sg_work_point(work, v[1])->p;
    const double *c = sg_work_point(work, v[2])->p;
    double one = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

    area += one / 2;
    low = fmin(low, one);
    least += v[0] >= N || v[1] >= N || v[2] >= N;
  }
  CHECK("the area stays",
        fabs(area - N / 2 * sin(3.14159265358979 / 6)) < 1e-12);
  CHECK("none is turned over", low > 0);
  CHECK("all reach the middle", least == (int32_t)list.n);
  list.item[1] = list.item[0];
  CHECK("a side twice: not settled",
        sg_triangles_delaunay(work, &list, is_side, &n, NULL) == SG_DONE &&
            !list.settled);
  free(list.item);
  sg_work_close(work);
}

int
main(void)
{
  bool same = true;

  test_features();
  test_all_corners();
  test_none();
  test_exact();
  srand(1988);
  for (int i = 0; i < 100000; i++) {
    same = same_turned() && same;
  }
  CHECK("turned contacts are the same", same);
  same = true;
  unsigned exact = 0;
  for (int i = 0; i < 20000; i++) {
    same = same_near(&exact) && same;
  }
  CHECK("near contacts are the same", same && exact > 1000);
  same = true;
  for (int i = 0; i < 5000; i++) {
    same = same_scaled() && same;
  }
  CHECK("scaled contacts are the same", same);
  test_reach();
  test_delaunay();
  return check_report();
}
