/* shell_copy_test.c -- equal shells of a segment: the first ones stay, and what
 * differs in a corner, a triangle, the way round or a kind of edge does too.
 * The same of polygons.
 */
#include "join/shell_copy.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 64, CORNERS = 4, SIDES = 4, EDGES = 12 };

/* Tetrahedra with vertices of their own. */
typedef struct model {
  sg_dense d;
  double at[MOST * CORNERS][3];
  int32_t from[MOST * EDGES + 1], to[MOST * EDGES + 1];
  unsigned char real[MOST * EDGES + 1];
  uint32_t list_begin[MOST * SIDES + 1];
  int32_t list[MOST * EDGES], polygon_of[MOST * SIDES];
  int32_t corner[MOST * SIDES][3];
} model;

static const int side[2][SIDES][3] = {
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
    {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};

static model *
model_new(void)
{
  model *m = calloc(1, sizeof *m);

  m->d = (sg_dense){.segments = 1,
                    .at = m->at,
                    .from = m->from,
                    .to = m->to,
                    .real = m->real,
                    .list_begin = m->list_begin,
                    .list = m->list,
                    .polygon_of = m->polygon_of,
                    .corner = m->corner};
  return m;
}

/* Its sides begin with side `first`. */
static void
add(model *m, double x, bool turned, int first)
{
  sg_dense *d = &m->d;
  int32_t v = (int32_t)d->vertices;

  for (int k = 0; k < CORNERS; k++) {
    m->at[d->vertices][0] = x + (k == 1);
    m->at[d->vertices][1] = k == 2;
    m->at[d->vertices++][2] = k == 3;
  }
  for (int i = 0; i < SIDES; i++) {
    const int *of = side[turned][(i + first) % SIDES];

    for (int k = 0; k < 3; k++) {
      m->corner[d->triangles][k] = v + of[k];
      m->from[d->edges] = v + of[k];
      m->to[d->edges] = v + of[(k + 1) % 3];
      m->real[d->edges] = 1;
      m->list[m->list_begin[d->polygons] + (uint32_t)k] = (int32_t)d->edges++;
    }
    m->polygon_of[d->triangles++] = (int32_t)d->polygons++;
    m->list_begin[d->polygons] = m->list_begin[d->polygons - 1] + 3;
  }
}

/* Finds copies in all that was added. */
typedef bool finder(const sg_dense *dense, size_t s, const sg_cancel *cancel,
                    sg_shell_copies *out);

static bool
find(model *m, finder *by, sg_shell_copies *out)
{
  uint32_t begin[4][2] = {{0, (uint32_t)m->d.vertices},
                          {0, (uint32_t)m->d.edges},
                          {0, (uint32_t)m->d.polygons},
                          {0, (uint32_t)m->d.triangles}};

  m->d.vertex_begin = begin[0];
  m->d.edge_begin = begin[1];
  m->d.polygon_begin = begin[2];
  m->d.triangle_begin = begin[3];
  return by(&m->d, 0, NULL, out);
}

/* Whether exactly the shells of the string have so many equal ones before them:
 * '-' of those added, as they were. */
static bool
goes(model *m, size_t most, const char *which)
{
  static const uint32_t none = 0;
  sg_shell_copies copies;
  bool good = find(m, sg_shell_copies_find, &copies);

  for (size_t p = 0; good && p < m->d.polygons && p / SIDES < strlen(which);
       p++) {
    uint32_t copy = copies.any ? copies.copy[p] : none;

    good = (copy >= most) == (which[p / SIDES] == '-') &&
           (!copies.any || copies.copies[p] > copy);
  }
  sg_shell_copies_clear(&copies);
  return good;
}

static void
copies(void)
{
  model *m = model_new();

  for (int i = 0; i < 5; i++) {
    add(m, 0, false, i);
  }
  CHECK("the first stay, in whatever order their polygons are",
        goes(m, 2, "++---") && goes(m, 4, "++++-") && goes(m, 5, "+++++"));
  add(m, 3, false, 0);
  add(m, 0, true, 0);
  add(m, 0, false, 0);
  CHECK("one that is elsewhere, and one that is turned round",
        goes(m, 1, "+----++-"));
  m->at[4 * CORNERS + 3][2] = 2;
  CHECK("another corner", goes(m, 1, "+---+++-"));
  m->real[3 * EDGES + 5] = 0;
  CHECK("an auxiliary edge", goes(m, 1, "+--++++-"));
  m->from[m->d.edges] = 2 * CORNERS;
  m->to[m->d.edges++] = 2 * CORNERS + 1;
  CHECK("an edge of no polygon", goes(m, 1, "+-+++++-"));
  memcpy(m->corner[SIDES], (int32_t[3]){4, 5, 4}, sizeof m->corner[0]);
  CHECK("other triangles", goes(m, 1, "+++++++-"));
  free(m);
}

/* Shells joined by an edge are one, and one of two parts equals none of one. */
static void
joined(void)
{
  model *m = model_new();

  for (int i = 0; i < 6; i++) {
    add(m, i % 2 == 0 ? 0 : 5, false, 0);
  }
  CHECK("by pairs", goes(m, 2, "++++--"));
  m->from[m->d.edges] = 0;
  m->to[m->d.edges] = CORNERS;
  m->real[m->d.edges] = 1;
  m->list[m->list_begin[m->d.polygons]] = (int32_t)m->d.edges++;
  m->d.polygons++;
  m->list_begin[m->d.polygons] = m->list_begin[m->d.polygons - 1] + 1;
  CHECK("the first two are one shell", goes(m, 1, "++++--"));
  free(m);
}

/* Whether each polygon has as many equal ones before it as the digits say. */
static bool
polygons_are(model *m, const char *copy)
{
  sg_shell_copies copies;
  bool good = find(m, sg_polygon_copies_find, &copies);

  for (size_t p = 0; good && p < m->d.polygons; p++) {
    good = copies.any
               ? copies.copy[p] == (uint32_t)(copy[p] - '0') &&
                     copies.copies[p] > copies.copy[p] && copies.kind[p] <= p
               : copy[p] == '0';
  }
  sg_shell_copies_clear(&copies);
  return good;
}

/* Tetrahedra with another apex each have one side in common. */
static void
polygons(void)
{
  model *m = model_new();

  add(m, 0, false, 0);
  CHECK("no polygon is equal to another one", polygons_are(m, "0000"));
  add(m, 0, false, 0);
  add(m, 0, false, 1);
  m->at[1 * CORNERS + 3][2] = 2;
  m->at[2 * CORNERS + 3][2] = 3;
  CHECK("one side is there three times", polygons_are(m, "000010000002"));
  m->at[2 * CORNERS + 3][2] = 2;
  CHECK("a shell that is there twice", polygons_are(m, "000010001112"));
  add(m, 0, true, 0);
  CHECK("the other way round is another one",
        polygons_are(m, "0000100011120000"));
  m->real[1 * EDGES] = 0;
  CHECK("an auxiliary edge", polygons_are(m, "0000000011110000"));
  m->real[1 * EDGES] = 1;
  memcpy(m->corner[SIDES], (int32_t[3]){4, 5, 4}, sizeof m->corner[0]);
  CHECK("other triangles", polygons_are(m, "0000000011110000"));
  free(m);
}

int
main(void)
{
  copies();
  joined();
  polygons();
  return check_report();
}
