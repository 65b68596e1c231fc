/* smooth_test.c -- sheets of random triangles, however badly they hang
 * together, against a search of all pairs of sides; cut anywhere, stopped
 * anywhere, and with each allocation refused.
 */
#include "picture/smooth.h"
#include "tests/memory/refusals.h"

#include <string.h>

enum { MOST_VERTICES = 12, MOST_TRIANGLES = 60, MOST_CUTS = 30 };

/* Triangles of a few vertices: many on one edge, some twice, turned over or on
 * one vertex. */
typedef struct soup {
  sg_dense dense;
  double at[MOST_VERTICES][3];
  int32_t corner[MOST_TRIANGLES][3], polygon_of[MOST_TRIANGLES];
  int32_t surface_of[MOST_TRIANGLES];
  uint32_t vertex_begin[2], triangle_begin[2];
  uint32_t cut[MOST_CUTS][2];
  sg_known_surface known[2];
  sg_smooth_input in;
} soup;

/* A cylinder and a ball round the origin. */
static void
know_surfaces(soup *s)
{
  const double frame[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 3}};

  sg_known_surface_init(&s->known[0], SG_KNOWN_TAPERED, frame, 1, 1);
  sg_known_surface_init(&s->known[1], SG_KNOWN_SPHERE, frame, 0, 0);
}

static void
make_soup(soup *s, uint32_t seed)
{
  sg_dense *d = &s->dense;
  int vertices = 1 + check_below(&seed, MOST_VERTICES);

  memset(s, 0, sizeof *s);
  *d = (sg_dense){.segments = 1,
                  .vertices = (size_t)vertices,
                  .triangles = (size_t)check_below(&seed, MOST_TRIANGLES + 1),
                  .at = s->at,
                  .corner = s->corner,
                  .polygon_of = s->polygon_of,
                  .vertex_begin = s->vertex_begin,
                  .triangle_begin = s->triangle_begin};
  d->polygons = d->triangles / 2 + 1;
  s->vertex_begin[1] = (uint32_t)d->vertices;
  s->triangle_begin[1] = (uint32_t)d->triangles;
  for (int i = 0; i < 3 * vertices; i++) {
    s->at[i / 3][i % 3] = check_below(&seed, 5) - 2;
  }
  for (size_t i = 0; i < 3 * d->triangles; i++) {
    s->corner[i / 3][i % 3] = check_below(&seed, vertices);
    s->polygon_of[i / 3] = (int32_t)(i / 6);
  }
  for (size_t p = 0; p < d->polygons; p++) {
    s->surface_of[p] = check_below(&seed, 5) - 3;
  }
  s->in = (sg_smooth_input){
      .dense = d,
      .cut = (const uint32_t(*)[2])s->cut,
      .cuts = (size_t)check_below(&seed, MOST_CUTS),
      .surfaces = {.surface = s->known, .n = 2, .of = s->surface_of},
      .crease = check_below(&seed, 100)};
  for (size_t i = 0; i < 2 * s->in.cuts; i++) {
    s->cut[i / 2][i % 2] = (uint32_t)check_below(&seed, vertices);
  }
  know_surfaces(s);
}

static int32_t
vertex_of(const soup *s, size_t side)
{
  return s->corner[side / 3][side % 3];
}

static int32_t
end_of(const soup *s, size_t side)
{
  return s->corner[side / 3][(side % 3 + 1) % 3];
}

/* The only other side between the same vertices, if it runs the other way. */
static uint32_t
across(const soup *s, size_t i)
{
  uint32_t found = SG_NO_SIDE;
  int n = 0;

  for (size_t j = 0; j < 3 * s->dense.triangles; j++) {
    bool same =
        vertex_of(s, i) == vertex_of(s, j) && end_of(s, i) == end_of(s, j);
    bool back =
        vertex_of(s, i) == end_of(s, j) && end_of(s, i) == vertex_of(s, j);

    if (j != i && (same || back)) {
      n++;
      found = back && !same ? (uint32_t)j : SG_NO_SIDE;
    }
  }
  return n == 1 ? found : SG_NO_SIDE;
}

static bool
is_cut(const soup *s, size_t i)
{
  for (size_t k = 0; k < s->in.cuts; k++) {
    int32_t a = (int32_t)s->cut[k][0], b = (int32_t)s->cut[k][1];

    if ((a == vertex_of(s, i) && b == end_of(s, i)) ||
        (b == vertex_of(s, i) && a == end_of(s, i))) {
      return true;
    }
  }
  return false;
}

/* How many sides are not as a search of all pairs has them. */
static long
wrong_sides(const soup *s, const sg_smooth *smooth)
{
  long wrong = 0;

  for (size_t i = 0; i < 3 * s->dense.triangles; i++) {
    uint32_t j = across(s, i);

    wrong += smooth->across[i] != j;
    wrong += (smooth->side[i] & SG_SIDE_CUT) != 0 &&
             (j == SG_NO_SIDE || !is_cut(s, i));
    wrong +=
        j != SG_NO_SIDE && is_cut(s, i) && !(smooth->side[i] & SG_SIDE_CUT);
    wrong += smooth->fan[i] >= smooth->fans;
  }
  return wrong;
}

static void
test_soups(void)
{
  enum { CASES = 3000 };
  long wrong = 0, pairs = 0, cuts = 0;

  for (uint32_t seed = 1; seed <= CASES; seed++) {
    sg_smooth smooth;
    bool memory;
    soup s;

    make_soup(&s, seed * 2654435761u);
    if (!sg_smooth_init(&smooth, &s.in, NULL, &memory) || !memory) {
      wrong++;
      continue;
    }
    wrong += wrong_sides(&s, &smooth);
    for (size_t i = 0; i < 3 * s.dense.triangles; i++) {
      pairs += smooth.across[i] != SG_NO_SIDE;
      cuts += (smooth.side[i] & SG_SIDE_CUT) != 0;
    }
    sg_smooth_clear(&smooth);
  }
  CHECK("sides as a search of all pairs has them", wrong == 0);
  CHECK("there were pairs, and cuts", pairs > CASES && cuts > CASES / 10);
}

/* ---- stopped and refused ---- */

static bool
says_stop(void *data)
{
  return --*(long *)data < 0;
}

static void
test_stopped(void)
{
  long at = 0, bad = 0;
  bool done = false;
  soup s;

  make_soup(&s, 77);
  for (; !done; at++) {
    long asked = at;
    const sg_cancel cancel = {says_stop, &asked};
    sg_smooth smooth;
    bool memory;

    done = sg_smooth_init(&smooth, &s.in, &cancel, &memory);
    bad += !memory || (!done && (smooth.across || smooth.fan || smooth.apex));
    sg_smooth_clear(&smooth);
  }
  CHECK("stopped at every question", bad == 0 && at > 3);
}

static long
refused(uint32_t seed, long n, bool *done)
{
  sg_smooth smooth;
  bool memory;
  long bad = 0;
  soup s;

  make_soup(&s, seed + 1000);
  living = 0;
  left = n;
  counting = true;
  bool good = sg_smooth_init(&smooth, &s.in, NULL, &memory);
  *done = left >= 0;
  left = -1;
  /* qsort() of the C library asks too, and does without. */
  bad += (*done && !good) || memory != good;
  sg_smooth_clear(&smooth);
  counting = false;
  return bad + (living != 0);
}

int
main(void)
{
  spare_gmp();
  test_soups();
  test_stopped();
  check_refusals(refused, 30, 300);
  return check_report();
}
