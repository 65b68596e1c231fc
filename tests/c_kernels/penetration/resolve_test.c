/* resolve_test.c -- two boxes made to touch: what they share, without memory
 * at every single allocation, and stopped; points that change their order. */
#include "penetration/resolve_polygon.h"
#include "tests/check.h"
#include "tests/memory/refusals.h"

#include <string.h>

/* ---- boxes ---- */

static const double reach = 1e-9;

/* Corner c + 1 of a box is at its lower corner plus the bits of c. */
static const int face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                               {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
static const double low[2][3] = {{0, 0, 0}, {1 + 1e-12, 0.5, 0.25}};

static void
corner(int box, int c, double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = low[box][k] + ((c >> k) & 1);
  }
}

/* Leaf number 12 box + 2 face + half. */
static void
get_leaf(uint32_t number, sg_resolve_leaf *out)
{
  int box = (int)(number / 12), f = (int)(number % 12 / 2);

  *out = (sg_resolve_leaf){.triangle = number, .s = box + 1, .p = f + 1};
  for (int k = 0; k < 3; k++) {
    int c = face[f][k == 0 ? 0 : k + (int)(number % 2)];
    out->v[k] = c + 1;
    corner(box, c, out->at[k]);
  }
}

/* A diagonal joins corners of which two bits differ. */
static int
is_real(void *data, uint32_t triangle, int side)
{
  sg_resolve_leaf leaf;
  (void)data;
  get_leaf(triangle, &leaf);
  int bits = (leaf.v[side] - 1) ^ (leaf.v[(side + 1) % 3] - 1);

  return (bits & (bits - 1)) == 0;
}

static bool
each_pair(sg_resolve *r, bool (*use)(sg_resolve *r, const sg_resolve_leaf *a,
                                     const sg_resolve_leaf *b))
{
  sg_resolve_leaf a, b;

  for (uint32_t i = 0; i < 12; i++) {
    for (uint32_t j = 12; j < 24; j++) {
      get_leaf(i, &a);
      get_leaf(j, &b);
      if (!use(r, &a, &b)) {
        return false;
      }
    }
  }
  return true;
}

static sg_resolved
make_face(const sg_resolve *r, sg_resolved_polygon *out,
          const sg_cancel *cancel)
{
  int box = out->s - 1, f = out->p - 1;
  const double normal[3] = {box == 0 ? 1 : -1, 0, 0};
  sg_polygon_row row[4];

  for (int i = 0; i < 4; i++) {
    int a = face[f][i], b = face[f][(i + 1) % 4];
    row[i] = (sg_polygon_row){.e = 4 * f + i + 1, .v = {a + 1, b + 1}, .et = 1};
    corner(box, a, row[i].at[0]);
    corner(box, b, row[i].at[1]);
  }
  sg_work *work = sg_work_open(normal);
  sg_resolved end = work ? sg_resolve_polygon(r, row, 4, work, out, cancel)
                         : SG_RESOLVE_NO_MEMORY;

  sg_work_close(work);
  return end;
}

/* What became of the two faces that touch. */
typedef struct outcome {
  sg_resolved end;
  size_t points, splits, seams, triangles[2], same;
} outcome;

/* The points of a triangle, whichever way round: their sum and product. */
static void
trace(const sg_resolve *r, const sg_resolved_polygon *polygon, size_t i,
      size_t out[2])
{
  out[0] = 0;
  out[1] = 1;
  for (int k = 0; k < 3; k++) {
    size_t point = SG_NO_KEY;
    for (size_t j = 0; j < r->place.n; j++) {
      const sg_resolve_place *place = &r->place.item[j];
      if (place->s == polygon->s &&
          place->name == polygon->triangle.item[i].v[k]) {
        point = place->point;
      }
    }
    out[0] += point;
    out[1] *= point + 7;
  }
}

static void
count(const sg_resolve *r, const sg_resolved_polygon polygon[2], outcome *out)
{
  out->points = r->point.n;
  out->splits = r->split.n;
  out->seams = r->seam.n;
  for (int k = 0; k < 2; k++) {
    out->triangles[k] = polygon[k].triangle.n;
  }
  for (size_t i = 0; i < polygon[0].triangle.n; i++) {
    for (size_t j = 0; j < polygon[1].triangle.n; j++) {
      size_t a[2], b[2];
      trace(r, &polygon[0], i, a);
      trace(r, &polygon[1], j, b);
      out->same += a[0] < SG_NO_KEY && memcmp(a, b, sizeof a) == 0;
    }
  }
}

static void
resolve_faces(sg_resolve *r, sg_resolved_polygon polygon[2],
              const sg_cancel *cancel, outcome *out)
{
  out->end = SG_RESOLVE_NO_MEMORY;
  if (!each_pair(r, sg_resolve_see) || !each_pair(r, sg_resolve_seen_pair)) {
    return;
  }
  out->end = sg_resolve_finish(r);
  for (size_t i = 0; i < r->place.n && out->end == SG_RESOLVED; i++) {
    if (r->place.item[i].name == 0) {
      r->place.item[i].name = 100 + (int32_t)i;
    }
  }
  for (int k = 0; k < 2 && out->end == SG_RESOLVED; k++) {
    out->end = make_face(r, &polygon[k], cancel);
  }
  if (out->end == SG_RESOLVED) {
    out->end = sg_resolve_match(r, polygon, 2, cancel);
  }
}

/* The whole, with only so many allocations; *leaked: those not freed. */
static outcome
resolve_boxes(long allocations, const sg_cancel *cancel, long *leaked)
{
  sg_resolved_polygon polygon[2] = {{.s = 1, .p = 6}, {.s = 2, .p = 5}};
  outcome out = {0};
  sg_resolve r;

  living = 0;
  left = allocations;
  counting = true;
  sg_resolve_init(&r, reach, is_real, NULL, cancel);
  resolve_faces(&r, polygon, cancel, &out);
  left = -1;
  if (out.end == SG_RESOLVED) {
    count(&r, polygon, &out);
  }
  sg_resolved_polygon_clear(&polygon[0]);
  sg_resolved_polygon_clear(&polygon[1]);
  sg_resolve_clear(&r);
  counting = false;
  *leaked = living;
  return out;
}

/* The faces overlap in a rectangle: two crossings of edges, one corner of each
 * inside the other face. */
static void
test_boxes(void)
{
  long leaked;
  outcome out = resolve_boxes(-1, NULL, &leaked);

  CHECK("resolved", out.end == SG_RESOLVED);
  CHECK("four points", out.points == 4);
  CHECK("two edges of each are divided", out.splits == 4);
  CHECK("two seams in each face", out.seams == 4);
  CHECK("triangles of the first", out.triangles[0] == 6);
  CHECK("triangles of the second", out.triangles[1] == 6);
  CHECK("the rectangle has the same two", out.same == 2);
  CHECK("everything is freed", leaked == 0);
}

static void
test_no_memory(void)
{
  enum { MOST = 100000 };
  long leaked, n = 0, bad = 0;
  outcome out = {.end = SG_RESOLVE_NO_MEMORY};

  if (!is_counted()) {
    printf("skipped: allocations that fail: the checker has its own\n");
    return;
  }
  for (; n < MOST && out.end != SG_RESOLVED; n++) {
    out = resolve_boxes(n, NULL, &leaked);
    bad += leaked != 0;
    bad += out.end != SG_RESOLVED && out.end != SG_RESOLVE_NO_MEMORY;
  }
  CHECK("no allocation that fails is lost or leaks", bad == 0);
  CHECK("there were many", n > 30 && n < MOST);
  CHECK("the last is as ever", out.same == 2 && out.triangles[0] == 6);
}

static bool
stop_later(void *data)
{
  long *more = data;

  return (*more)-- <= 0;
}

static void
test_stopped(void)
{
  long bad = 0, stops = 0, leaked;
  outcome out = {.end = SG_RESOLVE_STOPPED};

  for (long n = 0; n < 1000 && out.end != SG_RESOLVED; n++) {
    long more = n;
    sg_cancel cancel = {stop_later, &more};
    out = resolve_boxes(-1, &cancel, &leaked);
    stops += out.end == SG_RESOLVE_STOPPED;
    bad += leaked != 0 ||
           (out.end != SG_RESOLVED && out.end != SG_RESOLVE_STOPPED);
  }
  CHECK("stopped wherever it asks", stops > 3 && bad == 0);
  CHECK("not stopped: as ever", out.same == 2);
}

/* ---- order along an edge ---- */

static int
all_real(void *data, uint32_t triangle, int side)
{
  (void)data;
  (void)triangle;
  (void)side;
  return 1;
}

/* Triangle s, corner 1 at (x, y, 0) in units of the reach, off the edge. */
static sg_resolve_leaf
spike(int32_t s, double x, double y)
{
  const double r = 1e-3;

  return (sg_resolve_leaf){.triangle = (uint32_t)s,
                           .s = s,
                           .p = 1,
                           .v = {1, 2, 3},
                           .at = {{0.5 + x * r, y * r, 0},
                                  {0.5 + x * r, 1 + y * r, 1},
                                  {0.6 + x * r, 2 + y * r, 1}}};
}

/* Corners near an edge, of which three become one that lies beyond the fourth:
 * the edge is divided in the order in which they are then. */
static void
test_order(void)
{
  sg_resolve_leaf leaf[5] = {{.triangle = 1,
                              .s = 1,
                              .p = 1,
                              .v = {1, 2, 3},
                              .at = {{0, 0, 0}, {1, 0, 0}, {0, -1, -1}}},
                             spike(2, 1.36, 1.36),
                             spike(3, 0, 0),
                             spike(4, 0.58, 0.78),
                             spike(5, 1.3, 0)};
  sg_resolve r;
  bool good = true;

  sg_resolve_init(&r, 1e-3, all_real, NULL, NULL);
  for (int pass = 0; pass < 2; pass++) {
    for (int i = 0; i < 5; i++) {
      for (int j = i + 1; j < 5; j++) {
        good = good && (pass == 0 ? sg_resolve_see(&r, &leaf[i], &leaf[j])
                                  : sg_resolve_pair(&r, &leaf[i], &leaf[j]));
      }
    }
  }
  CHECK("resolved", good && sg_resolve_finish(&r) == SG_RESOLVED && !r.wide);
  const sg_resolve_split *split = sg_resolve_split_of(&r, 1, 1, 2);

  CHECK("the edge gets two points", split && split->n == 2);
  if (split && split->n == 2) {
    const double *a = r.point.item[r.place.item[split->first].point].at;
    const double *b = r.point.item[r.place.item[split->first + 1].point].at;
    CHECK("in order", a[0] < b[0]);
  }
  sg_resolve_clear(&r);
}

int
main(void)
{
  spare_gmp();
  test_boxes();
  test_no_memory();
  test_stopped();
  test_order();
  return check_report();
}
