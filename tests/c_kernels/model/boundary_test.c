/* boundary_test.c -- boundaries on their way to files: nothing opens, what is
 * flat goes, the order is one of geometry, bodies that touch get copies. */
#include "tests/check.h"

#include "model/boundary_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- small models ----------------------------------------------------------
 */

enum { MOST = 4096 };

/* A segment under construction: polygons as loops of vertices. */
static struct model {
  double at[MOST][3];
  size_t vertices;
  int32_t from[MOST], to[MOST], list[MOST];
  uint32_t begin[MOST];
  size_t edges, polygons;
  uint32_t vertex_begin[2], edge_begin[2], polygon_begin[2];
} model;

static void
clear_model(void)
{
  memset(&model, 0, sizeof model);
}

static int32_t
point(double x, double y, double z)
{
  double *at = model.at[model.vertices];

  at[0] = x, at[1] = y, at[2] = z;
  return (int32_t)model.vertices++;
}

static void
polygon(size_t n, const int32_t *v)
{
  for (size_t i = 0; i < n; i++) {
    model.from[model.edges] = v[i];
    model.to[model.edges] = v[(i + 1) % n];
    model.list[model.edges] = (int32_t)model.edges;
    model.edges++;
  }
  model.begin[++model.polygons] = (uint32_t)model.edges;
}

#define POLYGON(...)                                                           \
  polygon(sizeof((int32_t[]){__VA_ARGS__}) / sizeof(int32_t),                  \
          (int32_t[]){__VA_ARGS__})

/* A box from lo to hi; its corners are its own. */
static void
box(double x, double y, double z, double a, double b, double c)
{
  int32_t v[8];

  for (int i = 0; i < 8; i++) {
    v[i] = point(i & 1 ? a : x, i & 2 ? b : y, i & 4 ? c : z);
  }
  POLYGON(v[0], v[2], v[3], v[1]);
  POLYGON(v[4], v[5], v[7], v[6]);
  POLYGON(v[0], v[1], v[5], v[4]);
  POLYGON(v[2], v[6], v[7], v[3]);
  POLYGON(v[0], v[4], v[6], v[2]);
  POLYGON(v[1], v[3], v[7], v[5]);
}

static void
tetrahedron(const double at[4][3])
{
  int32_t v[4];

  for (int i = 0; i < 4; i++) {
    v[i] = point(at[i][0], at[i][1], at[i][2]);
  }
  POLYGON(v[0], v[2], v[1]);
  POLYGON(v[0], v[1], v[3]);
  POLYGON(v[1], v[2], v[3]);
  POLYGON(v[2], v[0], v[3]);
}

static sg_dense
dense(void)
{
  model.vertex_begin[1] = (uint32_t)model.vertices;
  model.edge_begin[1] = (uint32_t)model.edges;
  model.polygon_begin[1] = (uint32_t)model.polygons;
  static double grain[1];

  return (sg_dense){.segments = 1,
                    .grain = grain,
                    .vertex_begin = model.vertex_begin,
                    .edge_begin = model.edge_begin,
                    .polygon_begin = model.polygon_begin,
                    .vertices = model.vertices,
                    .at = model.at,
                    .edges = model.edges,
                    .from = model.from,
                    .to = model.to,
                    .polygons = model.polygons,
                    .list_begin = model.begin,
                    .list = model.list};
}

static sg_boundary_mesh mesh;
static bool drop_turned = true;

static bool
make(double grid, bool single, bool triangles, bool copies)
{
  sg_dense d = dense();
  sg_boundary boundary;
  sg_rounding rounding = {grid, single};
  sg_form form = {.triangles = triangles, .copies = copies};

  sg_boundary_mesh_clear(&mesh);
  bool done =
      sg_boundary_make(&(sg_boundary_source){.dense = &d}, &rounding, NULL,
                       &boundary) == SG_BOUNDARY_DONE &&
      sg_boundary_drop_flat(&boundary, drop_turned) &&
      sg_boundary_mesh_make(&boundary, &form, NULL, &mesh) == SG_BOUNDARY_DONE;
  sg_boundary_clear(&boundary);
  return done;
}

/* ---- what a mesh must be
 * ------------------------------------------------------ */

/* True if every directed edge has its opposite, by places or by numbers, and
 * (by numbers) just one. Quadratic. */
static bool
is_closed(bool by_number)
{
  const sg_mesh_lists *face = &mesh.mesh.face;
  double(*at)[3] = mesh.mesh.vertex;
  int balance;

  for (size_t f = 0; f < face->count; f++) {
    for (uint32_t i = face->start[f]; i < face->start[f + 1]; i++) {
      int32_t a = face->corner[i];
      int32_t b =
          face->corner[i + 1 < face->start[f + 1] ? i + 1 : face->start[f]];
      int same = 0;
      balance = 0;
      for (size_t g = 0; g < face->count; g++) {
        for (uint32_t k = face->start[g]; k < face->start[g + 1]; k++) {
          int32_t c = face->corner[k];
          int32_t d =
              face->corner[k + 1 < face->start[g + 1] ? k + 1 : face->start[g]];
          bool ac = by_number ? a == c : !memcmp(at[a], at[c], sizeof *at);
          bool bd = by_number ? b == d : !memcmp(at[b], at[d], sizeof *at);
          bool ad = by_number ? a == d : !memcmp(at[a], at[d], sizeof *at);
          bool bc = by_number ? b == c : !memcmp(at[b], at[c], sizeof *at);
          balance += (ac && bd) - (ad && bc);
          same += ac && bd;
        }
      }
      if (balance != 0 || (by_number && same != 1)) {
        return false;
      }
    }
  }
  return true;
}

static bool
is_degenerate(void)
{
  for (size_t t = 0; t < mesh.triangles; t++) {
    const double *a = mesh.mesh.vertex[mesh.triangle[t][0]],
                 *b = mesh.mesh.vertex[mesh.triangle[t][1]],
                 *c = mesh.mesh.vertex[mesh.triangle[t][2]];
    bool area = false;
    for (int k = 0; k < 3; k++) {
      int x = (k + 1) % 3, y = (k + 2) % 3;
      area |= (b[x] - a[x]) * (c[y] - a[y]) != (b[y] - a[y]) * (c[x] - a[x]);
    }
    if (!area) {
      return true;
    }
  }
  return false;
}

static double
volume(void)
{
  double sum = 0;

  for (size_t t = 0; t < mesh.triangles; t++) {
    const double *a = mesh.mesh.vertex[mesh.triangle[t][0]],
                 *b = mesh.mesh.vertex[mesh.triangle[t][1]],
                 *c = mesh.mesh.vertex[mesh.triangle[t][2]];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) +
           a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

static bool
is_clean(void)
{
  return mesh.open == 0 && mesh.stuck == 0 && is_closed(false) &&
         !is_degenerate();
}

/* ---- rounding
 * ------------------------------------------------------------------ */

static void
test_rounding(void)
{
  clear_model();
  box(0, 0, 0, 1, 2, 3);
  CHECK("a box stays", make(0, false, false, true) && is_clean() &&
                           mesh.mesh.vertices == 8 &&
                           mesh.mesh.face.count == 6);
  CHECK("a box as triangles",
        make(0, true, true, false) && is_clean() && mesh.triangles == 12);
  CHECK("its volume", volume() == 6);
  CHECK("a box collapsed to a plate goes wholly",
        make(8, false, true, false) && mesh.mesh.face.count == 0);

  clear_model();
  box(0, 0, 0, 1, 1, 1e-9);
  box(5, 5, 5, 6, 6, 6);
  CHECK("a thin plate in float32 stays",
        make(0, true, true, false) && is_clean() && mesh.triangles == 24);
  CHECK("on a coarser grid it goes, and closes what it leaves",
        make(0.25, true, true, false) && is_clean() && mesh.triangles == 12);
  CHECK("and so it does as polygons", make(0.25, false, false, true) &&
                                          is_clean() &&
                                          mesh.mesh.face.count == 6);
  CHECK("back to back faces were cancelled", mesh.cancelled == 2);

  clear_model();
  box(1e8, 0, 0, 1e8 + 1, 1, 1);
  CHECK("in float32 nothing is left of a box far out",
        make(0, true, true, false) && mesh.triangles == 0);
  clear_model();
  box(1e300, 0, 0, 2e300, 1, 1);
  CHECK("too far", !make(0, true, true, false));
}

/* A triangle a b c that rounds to a line, b between the others. */
static void
test_slivers(void)
{
  clear_model();
  /* A tetrahedron, one face divided by a vertex on (nearly) its edge. */
  int32_t a = point(0, 0, 0), c = point(4, 0, 0), d = point(0, 4, 0),
          e = point(0, 0, 4), b = point(2, 1e-3, 1e-3);
  POLYGON(a, d, c);
  POLYGON(a, c, b);
  POLYGON(a, b, e);
  POLYGON(b, c, e);
  POLYGON(c, d, e);
  POLYGON(d, a, e);
  CHECK("before",
        make(0, false, true, false) && is_clean() && mesh.triangles == 6);
  CHECK("the sliver's edge is turned over",
        make(0.5, false, true, false) && is_clean() && mesh.triangles == 6);
  CHECK("polygons get the corner", make(0.5, false, false, true) &&
                                       is_clean() && mesh.mesh.face.count == 5);
  CHECK("the volume is that of the tetrahedron",
        fabs(volume() - 32.0 / 3) < 1e-12);
}

/* A thin triangle in a face that rounding turns over: without care it lies on
 * its neighbour. */
static void
test_turned(void)
{
  sg_self_meetings met;

  clear_model();
  /* The square below is divided round b, a hair from the diagonal a-c, which
   * rounds to the other side of it. */
  int32_t a = point(0, 0, 0), c = point(8, 7, 0), d = point(0, 7, 0),
          f = point(8, 0, 0), e = point(4, 4, 8), b = point(1.45, 1.2, 0);
  POLYGON(a, d, c);
  POLYGON(a, c, b);
  POLYGON(a, b, f);
  POLYGON(b, c, f);
  POLYGON(d, e, c);
  POLYGON(c, e, f);
  POLYGON(f, e, a);
  POLYGON(a, e, d);
  CHECK("before", make(0, false, true, false) && is_clean());
  double was = volume();
  CHECK("turned over", make(1, false, true, false) && is_clean());
  CHECK("nothing lies on anything",
        sg_boundary_mesh_meetings(&mesh, true, NULL, NULL, &met) && met.n == 0);
  CHECK("the volume", fabs(volume() - was) < 1e-12);
  free(met.item);
  drop_turned = false;
  CHECK("it may stay, and then it lies on another",
        make(1, false, true, false) && is_clean() &&
            sg_boundary_mesh_meetings(&mesh, true, NULL, NULL, &met) &&
            met.n > 0);
  drop_turned = true;
  free(met.item);
}

/* A fan of slivers on one edge, each the neighbour of the next. */
static void
test_rows_of_slivers(void)
{
  for (int n = 1; n <= 6; n++) {
    clear_model();
    int32_t a = point(0, 0, 0), c = point(16, 0, 0), d = point(0, 16, 0),
            e = point(0, 0, 16), last = c;
    POLYGON(a, d, c);
    POLYGON(c, d, e);
    POLYGON(d, a, e);
    for (int i = 1; i <= n; i++) {
      int32_t b = point(16 - 2 * i, 1e-3 * i, 1e-3 * i);
      POLYGON(a, last, b);
      POLYGON(b, last, e);
      last = b;
    }
    POLYGON(a, last, e);
    CHECK("a row of slivers", make(0.5, false, true, false) && is_clean() &&
                                  mesh.triangles == (size_t)(4 + 2 * n));
  }
}

/* ---- the order
 * ------------------------------------------------------------------ */

/* The model with its vertices, polygons and their edges in another order. */
static void
shuffle(unsigned seed)
{
  static struct model old;
  int32_t number[MOST] = {0};
  size_t order[MOST];

  srand(seed);
  old = model;
  clear_model();
  for (size_t i = 0; i < old.vertices; i++) {
    order[i] = i;
  }
  for (size_t i = old.vertices; i > 1; i--) {
    size_t k = (size_t)rand() % i, swap = order[i - 1];
    order[i - 1] = order[k];
    order[k] = swap;
  }
  for (size_t i = 0; i < old.vertices; i++) {
    const double *at = old.at[order[i]];
    number[order[i]] = point(at[0], at[1], at[2]);
  }
  for (size_t f = old.polygons; f > 0; f--) {
    int32_t v[MOST];
    size_t n = old.begin[f] - old.begin[f - 1], shift = (size_t)rand() % n;
    for (size_t i = 0; i < n; i++) {
      v[i] = number[old.from[old.begin[f - 1] + (i + shift) % n]];
    }
    polygon(n, v);
  }
}

static bool
same_mesh(const sg_mesh *a, const sg_mesh *b)
{
  return a->vertices == b->vertices && a->face.count == b->face.count &&
         a->face.corners == b->face.corners &&
         !memcmp(a->vertex, b->vertex, a->vertices * sizeof *a->vertex) &&
         !memcmp(a->face.corner, b->face.corner,
                 a->face.corners * sizeof *a->face.corner);
}

static void
test_order(void)
{
  clear_model();
  box(0, 0, 0, 1, 1, 1);
  box(1, 1, 0, 2, 2, 1);
  box(2, 2, 1, 3, 3, 2);
  tetrahedron((const double[4][3]){
      {5, 5, 5}, {6, 5, 5}, {5.3, 5.0000001, 5.0000001}, {5, 5, 6}});
  int32_t ring[12];
  for (int i = 0; i < 12; i++) {
    ring[i] = point(9 + (i % 2 ? 1 : 2) * cos(i * 0.5236),
                    9 + (i % 2 ? 1 : 2) * sin(i * 0.5236), 9);
  }
  int32_t apex = point(9, 9, 12), back[12];
  for (int i = 0; i < 12; i++) {
    POLYGON(ring[i], ring[(i + 1) % 12], apex);
    back[i] = ring[11 - i];
  }
  polygon(12, back);
  for (int how = 0; how < 8; how++) {
    double grid = how & 4 ? 0x1p-10 : 0;
    make(grid, how & 1, how & 2, !(how & 2));
    sg_boundary_mesh first = mesh;
    bool same = is_clean();
    mesh = (sg_boundary_mesh){0};
    for (unsigned seed = 1; seed <= 20; seed++) {
      shuffle(seed);
      same = same && make(grid, how & 1, how & 2, !(how & 2)) &&
             same_mesh(&first.mesh, &mesh.mesh);
    }
    CHECK("the same mesh in any order", same);
    sg_boundary_mesh_clear(&first);
  }
}

/* ---- touching
 * --------------------------------------------------------------------- */

static void
test_touching(void)
{
  clear_model();
  box(0, 0, 0, 1, 1, 1);
  box(1, 1, 1, 2, 2, 2);
  CHECK("in a point: two vertices", make(0, false, false, true) &&
                                        mesh.mesh.vertices == 16 &&
                                        mesh.copies == 1 && is_closed(true));
  CHECK("in a point, shared",
        make(0, false, false, false) && mesh.mesh.vertices == 15);

  clear_model();
  box(0, 0, 0, 1, 1, 1);
  box(1, 1, 0, 2, 2, 1);
  CHECK("along an edge: two edges",
        make(0, false, false, true) && mesh.mesh.vertices == 16 &&
            mesh.touching == 1 && mesh.crossing == 0 && is_closed(true));

  /* Three boxes, each two along an edge, and all in a point. */
  clear_model();
  box(0, 0, 0, 1, 1, 1);
  box(1, 1, 0, 2, 2, 1);
  box(0, 1, 1, 1, 2, 2);
  CHECK("edges and points at once", make(0, false, true, true) &&
                                        mesh.touching == 3 && is_closed(true) &&
                                        mesh.mesh.vertices == 24);
}

/* Unit cells; walls between two of them are left out. */
typedef struct cells {
  bool full[5][4][4]; /* z, y, x; a rim of empty ones */
  int32_t v[4][3][3];
} cells;

/* The wall of cell `at` across an axis, below it or above it. */
static void
wall(const cells *c, const int at[3], int axis, bool above)
{
  int next[3] = {at[0], at[1], at[2]};

  next[axis] += above ? 1 : -1;
  if (c->full[next[2] + 1][next[1] + 1][next[0] + 1]) {
    return;
  }
  int32_t ring[4];
  for (int i = 0; i < 4; i++) {
    int k[3] = {at[0], at[1], at[2]};
    k[axis] += above;
    k[(axis + 1) % 3] += i == 1 || i == 2;
    k[(axis + 2) % 3] += i >= 2;
    ring[above ? i : 3 - i] = c->v[k[2]][k[1]][k[0]];
  }
  polygon(4, ring);
}

/* One body that touches itself along an edge, both ends inside it: copies of
 * the ends cannot part it by matter, so they part it by what is between. */
static void
test_one_body_touches_itself(void)
{
  /* Layers of 2 x 2 cells, full except for two in the middle. */
  cells c = {0};

  clear_model();
  for (int i = 0; i < 36; i++) {
    c.v[i / 9][i / 3 % 3][i % 3] = point(i % 3, i / 3 % 3, i / 9);
  }
  for (int i = 0; i < 12; i++) {
    c.full[i / 4 + 1][i / 2 % 2 + 1][i % 2 + 1] = i != 5 && i != 6;
  }
  for (int i = 0; i < 12; i++) {
    const int at[3] = {i % 2, i / 2 % 2, i / 4};
    for (int k = 0; k < 6 && i != 5 && i != 6; k++) {
      wall(&c, at, k / 2, k % 2);
    }
  }
  CHECK("it touches itself along one edge",
        make(0, false, false, false) && mesh.touching == 1 && is_closed(false));
  CHECK("with copies every edge has two faces",
        make(0, false, false, true) && is_closed(true));
  CHECK("also as triangles", make(0, true, true, true) && is_closed(true));
}

static void
test_crossing(void)
{
  /* Two wedges through each other along an edge they share. */
  clear_model();
  int32_t u = point(0, 0, 0), w = point(0, 0, 1), a = point(2, -1, 0),
          b = point(2, 1, 0), c = point(2, 0, 0), d = point(2, 2, 0);
  POLYGON(u, a, w);
  POLYGON(u, w, b);
  POLYGON(a, b, w);
  POLYGON(u, b, a);
  POLYGON(u, c, w);
  POLYGON(u, w, d);
  POLYGON(c, d, w);
  POLYGON(u, d, c);
  CHECK("sheets cross along an edge",
        make(0, false, true, false) && mesh.open == 0 && mesh.crossing > 0);
}

/* ---- faces that are no simple loop
 * ------------------------------------------------------------------------ */

/* A loop of four that belongs to the polygon begun. */
static void
loop_of_four(int32_t a, int32_t b, int32_t c, int32_t d)
{
  model.polygons--;
  POLYGON(a, b, c, d);
}

/* A square tube: its top and bottom are faces of two loops. */
static void
test_face_with_hole(void)
{
  int32_t o[8], h[8];

  clear_model();
  for (int i = 0; i < 8; i++) {
    o[i] = point(i & 1 ? 4 : 0, i & 2 ? 4 : 0, i & 4 ? 2 : 0);
    h[i] = point(i & 1 ? 3 : 1, i & 2 ? 3 : 1, i & 4 ? 2 : 0);
  }
  POLYGON(o[0], o[2], o[3], o[1]);
  loop_of_four(h[0], h[1], h[3], h[2]);
  POLYGON(o[4], o[5], o[7], o[6]);
  loop_of_four(h[4], h[6], h[7], h[5]);
  POLYGON(o[0], o[1], o[5], o[4]);
  POLYGON(o[2], o[6], o[7], o[3]);
  POLYGON(o[0], o[4], o[6], o[2]);
  POLYGON(o[1], o[3], o[7], o[5]);
  POLYGON(h[0], h[4], h[5], h[1]);
  POLYGON(h[2], h[3], h[7], h[6]);
  POLYGON(h[0], h[2], h[6], h[4]);
  POLYGON(h[1], h[5], h[7], h[3]);
  CHECK("made", make(0, false, false, false));
  CHECK("a hole stays one", is_clean() && volume() == 24);
}

/* Two columns that have an edge in common: their tops are one face, whose loop
 * passes a vertex twice. */
static void
test_face_with_pinch(void)
{
  int32_t v[2][3][3];

  clear_model();
  for (int z = 0; z < 2; z++) {
    for (int y = 0; y < 3; y++) {
      for (int x = 0; x < 3; x++) {
        bool used = (x < 2 && y < 2) || (x > 0 && y > 0);
        v[z][y][x] = used ? point(x, y, z) : -1;
      }
    }
  }
  POLYGON(v[0][0][0], v[0][1][0], v[0][1][1], v[0][2][1], v[0][2][2],
          v[0][1][2], v[0][1][1], v[0][0][1]);
  POLYGON(v[1][0][0], v[1][0][1], v[1][1][1], v[1][1][2], v[1][2][2],
          v[1][2][1], v[1][1][1], v[1][1][0]);
  for (int k = 0; k < 2; k++) {
    POLYGON(v[0][k][k], v[0][k][k + 1], v[1][k][k + 1], v[1][k][k]);
    POLYGON(v[0][k + 1][k + 1], v[0][k + 1][k], v[1][k + 1][k],
            v[1][k + 1][k + 1]);
    POLYGON(v[0][k + 1][k], v[0][k][k], v[1][k][k], v[1][k + 1][k]);
    POLYGON(v[0][k][k + 1], v[0][k + 1][k + 1], v[1][k + 1][k + 1],
            v[1][k][k + 1]);
  }
  CHECK("made", make(0, false, false, false));
  CHECK("a pinched face is whole", mesh.open == 0 && is_closed(false) &&
                                       !is_degenerate() && volume() == 2);
  for (size_t f = 0; f < mesh.mesh.face.count; f++) {
    const int32_t *c = mesh.mesh.face.corner;
    uint32_t from = mesh.mesh.face.start[f], to = mesh.mesh.face.start[f + 1];
    bool once = true;
    for (uint32_t i = from; i < to; i++) {
      for (uint32_t k = i + 1; k < to; k++) {
        once &= c[i] != c[k];
      }
    }
    CHECK("a written face passes a vertex once", once);
  }
}

int
main(void)
{
  test_rounding();
  test_slivers();
  test_turned();
  test_rows_of_slivers();
  test_order();
  test_touching();
  test_one_body_touches_itself();
  test_crossing();
  test_face_with_hole();
  test_face_with_pinch();
  sg_boundary_mesh_clear(&mesh);
  return check_report();
}
