/* face_merge_shape_test.c -- faces that become one: curved solids, open ones,
 * what touches a face inside, and what is hardly there.
 *
 * covers: face_merge_hold, face_merge_sheet, face_merge_near,
 * face_merge_tight, places
 */
#include "merged.h"
#include "tests/check.h"

/* ---- curved ones -------------------------------------------------------- */

/* The vertex between two, on the unit sphere; `known` is a table of them. */
static uint32_t
middle(sg_solid *solid, uint32_t a, uint32_t b, uint32_t (*known)[3])
{
  uint32_t low = a < b ? a : b, high = a < b ? b : a, i = low * 31 + high;
  double at[3], length = 0;

  for (i %= 1u << 18; known[i][2]; i = (i + 1) % (1u << 18)) {
    if (known[i][0] == low && known[i][1] == high) {
      return known[i][2] - 1;
    }
  }
  for (int k = 0; k < 3; k++) {
    at[k] = solid->vertex[a].at[k] + solid->vertex[b].at[k];
    length += at[k] * at[k];
  }
  length = sqrt(length);
  known[i][0] = low;
  known[i][1] = high;
  known[i][2] =
      add_vertex(solid, at[0] / length, at[1] / length, at[2] / length) + 1;
  return known[i][2] - 1;
}

static sg_solid
octahedron(void)
{
  static const double at[6][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                  {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  sg_solid out = {0};

  for (int i = 0; i < 6; i++) {
    add_vertex(&out, at[i][0], at[i][1], at[i][2]);
  }
  for (uint32_t i = 0; i < 8; i++) {
    uint32_t x = i & 1 ? 3 : 0, y = i & 2 ? 4 : 1, z = i & 4 ? 5 : 2;
    bool odd = (i & 1) ^ (i >> 1 & 1) ^ (i >> 2 & 1);
    add_face(&out, 1, (int32_t)i + 1);
    add_triangle(&out, x, odd ? z : y, odd ? y : z);
  }
  return out;
}

/* Each triangle becomes four. */
static sg_solid
divided(const sg_solid *from)
{
  uint32_t(*known)[3] = calloc(1u << 18, sizeof *known);
  sg_solid to = {0};

  if (!known) {
    abort();
  }
  for (size_t v = 0; v < from->vertices; v++) {
    const double *p = from->vertex[v].at;
    add_vertex(&to, p[0], p[1], p[2]);
  }
  for (size_t t = 0; t < from->triangles; t++) {
    const uint32_t *c = from->triangle[t];
    uint32_t m[3];
    for (int k = 0; k < 3; k++) {
      m[k] = middle(&to, c[k], c[(k + 1) % 3], known);
    }
    for (int k = 0; k < 3; k++) {
      add_face(&to, 1, (int32_t)to.faces + 1);
      add_triangle(&to, c[k], m[k], m[(k + 2) % 3]);
    }
    add_face(&to, 1, (int32_t)to.faces + 1);
    add_triangle(&to, m[0], m[1], m[2]);
  }
  free(known);
  return to;
}

static sg_solid
sphere(int times)
{
  sg_solid out = octahedron();

  for (; times > 0; times--) {
    sg_solid next = divided(&out);
    sg_solid_clear(&out);
    out = next;
  }
  return out;
}

static void
test_sphere(void)
{
  sg_solid solid = sphere(6); /* 32768 triangles */
  sg_solid before = copy_of(&solid);

  CHECK("a sphere is merged", merge(&solid, TOLERANCE) == SG_MERGE_DONE);
  CHECK("it stays as it is, byte for byte", same_solid(&solid, &before));
  CHECK("so it does if it bends by little more than the tolerance",
        merge(&solid, 1e-4) == SG_MERGE_DONE && same_solid(&solid, &before));
  CHECK("or by less",
        merge(&solid, 1e-3) == SG_MERGE_DONE && same_solid(&solid, &before));
  sg_solid_clear(&solid);
  sg_solid_clear(&before);
}

/* n facets of two triangles, and two caps of n corners. */
static sg_solid
cylinder(uint32_t n)
{
  sg_solid solid = {0};

  for (uint32_t i = 0; i < n; i++) {
    double angle = 6.283185307179586 * i / n;
    add_vertex(&solid, cos(angle), sin(angle), 0);
    add_vertex(&solid, cos(angle), sin(angle), 2);
  }
  for (uint32_t i = 0; i < n; i++) {
    uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
    add_face(&solid, 1, (int32_t)i + 1);
    add_triangle(&solid, a, b, b + 1);
    add_triangle(&solid, a, b + 1, a + 1);
  }
  for (uint32_t top = 0; top < 2; top++) {
    add_face(&solid, 1, (int32_t)(n + top) + 1);
    for (uint32_t i = 1; i + 1 < n; i++) {
      uint32_t a = 2 * i, b = 2 * i + 2;
      add_triangle(&solid, top, (top ? a : b) + top, (top ? b : a) + top);
    }
  }
  return solid;
}

static void
test_cylinder(void)
{
  sg_solid solid = cylinder(100000);
  sg_solid before = copy_of(&solid);

  CHECK("a cylinder of many facets",
        merge(&solid, TOLERANCE) == SG_MERGE_DONE &&
            same_solid(&solid, &before));
  sg_solid_clear(&solid);
  sg_solid_clear(&before);
  solid = cylinder(10000);
  before = copy_of(&solid);
  CHECK("one of facets finer than the tolerance",
        merge(&solid, 1e-6) == SG_MERGE_DONE && same_solid(&solid, &before));
  sg_solid_clear(&before);
  sg_solid_clear(&solid);
}

/* ---- what touches a face inside ----------------------------------------- */

static uint32_t
vertex_near(const sg_solid *solid, double x, double y, double z)
{
  for (uint32_t v = 0; v < solid->vertices; v++) {
    const double *p = solid->vertex[v].at;
    if (fabs(p[0] - x) + fabs(p[1] - y) + fabs(p[2] - z) < 1e-9) {
      return v;
    }
  }
  return UINT32_MAX;
}

static void
add_own_triangle(sg_solid *solid, uint32_t a, uint32_t b, uint32_t c)
{
  add_face(solid, 2, (int32_t)solid->faces + 1);
  add_triangle(solid, a, b, c);
}

/* A tetrahedron; d lies below abc. */
static void
add_tetrahedron(sg_solid *solid, uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
  add_own_triangle(solid, a, b, c);
  add_own_triangle(solid, a, d, b);
  add_own_triangle(solid, b, d, c);
  add_own_triangle(solid, c, d, a);
}

static void
test_touching(void)
{
  cube_lump lump = {0};

  fill_box(&lump, 0, 0, 0, 3, 3, 1);
  sg_solid solid = lump_solid(&lump, EACH_SQUARE);
  uint32_t at = vertex_near(&solid, 1, 1, 1), to = vertex_near(&solid, 2, 1, 1);
  uint32_t a = add_vertex(&solid, 0, 0, 2), b = add_vertex(&solid, 2, 0, 2);
  uint32_t c = add_vertex(&solid, 0, 2, 2);

  add_tetrahedron(&solid, a, b, c, at);
  CHECK("an apex that touches a face",
        merged_is(&solid, TOLERANCE, 10, 12, 18));
  CHECK("it stays a corner of the face's triangles",
        solid.triangles == 5 * 2 + 4 + 4);
  sg_solid_clear(&solid);

  solid = lump_solid(&lump, EACH_SQUARE);
  a = add_vertex(&solid, 1.5, 0.5, 2);
  b = add_vertex(&solid, 1.5, 1.5, 2);
  add_tetrahedron(&solid, a, to, b, at);
  CHECK("an edge that touches a face",
        merged_is(&solid, TOLERANCE, 10, 12, 18));
  CHECK("it stays an edge of the face's triangles",
        solid.triangles == 5 * 2 + 4 + 6);
  sg_solid_clear(&solid);
}

/* ---- what is no closed solid, or not flat ------------------------------- */

static void
test_sheet(void)
{
  sg_solid solid = {0};
  uint32_t v[5][5];

  for (int i = 0; i < 5; i++) {
    for (int j = 0; j < 5; j++) {
      v[i][j] = add_vertex(&solid, i, j, 0);
    }
  }
  for (int i = 0; i < 4; i++) {
    for (int j = 0; j < 4; j++) {
      if (i == 1 && j == 1) { /* a hole */
        continue;
      }
      add_face(&solid, 1, 4 * i + j + 1);
      add_triangle(&solid, v[i][j], v[i + 1][j], v[i + 1][j + 1]);
      add_triangle(&solid, v[i][j], v[i + 1][j + 1], v[i][j + 1]);
    }
  }
  place_at_random(&solid, 1);
  CHECK("a sheet is merged", merge(&solid, TOLERANCE) == SG_MERGE_DONE);
  CHECK("it is one face with a hole",
        solid.faces == 1 && solid.vertices == 8 && solid.triangles == 8);
  sg_solid_clear(&solid);
}

/* A box whose top is bent along a diagonal and has a vertex in the middle of
 * one edge: it keeps its triangles and that vertex. */
static void
test_bent(void)
{
  cube_lump lump = {0};

  fill_box(&lump, 0, 0, 0, 2, 1, 1);
  sg_solid solid = lump_solid(&lump, EACH_SQUARE);
  uint32_t corner = vertex_near(&solid, 0, 0, 1);
  uint32_t kept = vertex_near(&solid, 0, 1, 1);
  solid.vertex[corner].at[2] += 0.01;
  solid.vertex[kept].at[2] += 0.02;
  CHECK("a bent box is merged", merge(&solid, TOLERANCE) == SG_MERGE_DONE);
  CHECK("nothing is opened", is_closed(&solid));
  CHECK("what is flat is one face", solid.faces == 7);
  CHECK("what is bent keeps its corners",
        vertex_near(&solid, 1, 0, 1) != UINT32_MAX &&
            vertex_near(&solid, 1, 1, 1) != UINT32_MAX &&
            vertex_near(&solid, 1, 0, 0) == UINT32_MAX);
  sg_solid_clear(&solid);
}

/* A cone with very many sides under a tip. */
static void
test_fan(void)
{
  const uint32_t n = 100000;
  sg_solid solid = {0};
  uint32_t tip = add_vertex(&solid, 0, 0, 1),
           foot = add_vertex(&solid, 0, 0, 0);

  for (uint32_t i = 0; i < n; i++) {
    double angle = 6.283185307179586 * i / n;
    add_vertex(&solid, cos(angle), sin(angle), 0);
  }
  for (uint32_t i = 0; i < n; i++) {
    uint32_t a = 2 + i, b = 2 + (i + 1) % n;
    add_face(&solid, 1, (int32_t)i + 1);
    add_triangle(&solid, a, b, tip);
    add_face(&solid, 1, (int32_t)(n + i) + 1);
    add_triangle(&solid, b, a, foot);
  }
  CHECK("a cone of many sides", merge(&solid, TOLERANCE) == SG_MERGE_DONE);
  CHECK("its base is one face",
        solid.faces == n + 1 && solid.vertices == n + 1 && is_closed(&solid));
  sg_solid_clear(&solid);
}

/* A box with a vertex in the middle of an edge, whose two faces there have a
 * triangle without area each, in the same place: the chords are no edge. */
static void
test_slivers(void)
{
  static const uint32_t quad[4][4] = {
      {0, 2, 3, 1}, {0, 4, 6, 2}, {1, 3, 7, 5}, {2, 6, 7, 3}};
  sg_solid solid = {0};

  for (uint32_t i = 0; i < 8; i++) {
    add_vertex(&solid, i & 1, i >> 1 & 1, i >> 2);
  }
  uint32_t m = add_vertex(&solid, 0.5, 0, 1); /* between 4 and 5 */
  for (int i = 0; i < 4; i++) {
    add_face(&solid, 1, i + 1);
    add_triangle(&solid, quad[i][0], quad[i][1], quad[i][2]);
    add_triangle(&solid, quad[i][0], quad[i][2], quad[i][3]);
  }
  add_face(&solid, 1, 5); /* below in the picture: y = 0 */
  add_triangle(&solid, 0, 1, 5);
  add_triangle(&solid, 0, 5, 4);
  add_triangle(&solid, 5, m, 4);
  add_face(&solid, 1, 6); /* z = 1 */
  add_triangle(&solid, 4, m, 5);
  add_triangle(&solid, 4, 5, 7);
  add_triangle(&solid, 4, 7, 6);
  CHECK("slivers in one place", is_closed(&solid));
  CHECK("they vanish with their vertex",
        merged_is(&solid, TOLERANCE, 6, 8, 12) && solid.triangles == 12);
  sg_solid_clear(&solid);
}

/* A cube one of whose vertices is there twice, a hair apart: as an edge of no
 * length, with the triangle on either side of it. */
static void
test_brief_edge(void)
{
  cube_lump lump = {0};

  fill_box(&lump, 0, 0, 0, 1, 1, 1);
  sg_solid solid = lump_solid(&lump, EACH_TRIANGLE);
  uint32_t v = solid.triangle[0][0], a = solid.triangle[0][1];
  const double *at = solid.vertex[v].at;
  uint32_t twin = add_vertex(&solid, at[0], at[1] + 1e-15, at[2]);
  uint32_t third = solid.triangle[0][2];

  /* the first triangle gets the twin; two slivers fill the gaps */
  solid.triangle[0][0] = twin;
  add_face(&solid, 1, 100);
  add_triangle(&solid, v, a, twin);
  add_face(&solid, 1, 101);
  add_triangle(&solid, v, twin, third);
  CHECK("a cube with a vertex twice", is_closed(&solid));
  CHECK("it has it once", merged_is(&solid, TOLERANCE, 6, 8, 12));
  sg_solid_clear(&solid);
}

/* Two cubes side by side that share no vertex: those made by cuts are in one
 * place, so they are one. */
static void
test_made_twice(void)
{
  cube_lump lump = {0};

  fill_box(&lump, 0, 0, 0, 1, 1, 1);
  sg_solid solid = lump_solid(&lump, EACH_SQUARE), other = copy_of(&solid);
  size_t n = solid.vertices;

  for (size_t i = 0; i < n; i++) {
    const double *at = other.vertex[i].at;
    add_vertex(&solid, at[0] + 1, at[1], at[2]);
  }
  for (size_t f = 0; f < other.faces; f++) {
    add_face(&solid, 2, (int32_t)f + 1);
    for (size_t t = 0; t < other.triangles; t++) {
      const uint32_t *c = other.triangle[t];
      if (t >= other.face[f].first && t < other.face[f].first + 2) {
        add_triangle(&solid, c[0] + (uint32_t)n, c[1] + (uint32_t)n,
                     c[2] + (uint32_t)n);
      }
    }
  }
  solid.plain = 0;
  solid.origin = calloc(solid.vertices, sizeof *solid.origin);
  CHECK("two cubes with vertices of their own",
        merge(&solid, TOLERANCE) == SG_MERGE_DONE);
  CHECK("they share four", solid.vertices == 12 && is_closed(&solid));
  sg_solid_clear(&solid);
  sg_solid_clear(&other);
}

/* ---- what is told ---- */

enum { OUTLINE = 5, RIDGE = 3 };

/* A plate of segment s, 4 x 4 and `thick`, whose upper side has a ridge `high`
 * along its middle; void if it is reversed, a slot in something. */
static void
add_plate(sg_solid *solid, int32_t s, double thick, double high, bool reversed)
{
  const double at[OUTLINE][2] = {
      {0, 0}, {4, 0}, {4, thick}, {2, thick + high}, {0, thick}};
  uint32_t first = (uint32_t)solid->vertices;

  for (int i = 0; i < 2 * OUTLINE; i++) {
    add_vertex(solid, at[i % OUTLINE][0], i < OUTLINE ? 0 : 4,
               at[i % OUTLINE][1]);
    solid->vertex[solid->vertices - 1].s = s;
  }
  for (uint32_t f = 0; f < OUTLINE + 2; f++) {
    uint32_t a = first + f, b = first + (f + 1) % OUTLINE, c = OUTLINE;
    uint32_t cap = first + (f == OUTLINE ? 0 : OUTLINE);
    uint32_t side[2][3] = {{a, b + c, b}, {a, a + c, b + c}};
    size_t n = f < OUTLINE ? 2 : OUTLINE - 2;
    add_face(solid, s, (int32_t)f + 1);
    solid->face[solid->faces - 1].reversed = reversed;
    for (uint32_t t = 0; t < n; t++) {
      uint32_t tip[3] = {cap, cap + t + 1, cap + t + 2};
      const uint32_t *of = f < OUTLINE ? side[t] : tip;
      bool turned = reversed != (f == OUTLINE + 1);
      add_triangle(solid, of[0], of[turned ? 2 : 1], of[turned ? 1 : 2]);
    }
  }
}

static bool
not_known(void *data, int32_t s, int32_t p, double out[3])
{
  (void)data, (void)s, (void)p, (void)out;
  return false;
}

/* What is told of a plate that loses its ridge. */
static sg_merge_tight
told_of_plate(double thick, double high, bool reversed, bool cells)
{
  sg_solid solid = {0};
  sg_merge_options options = {
      .tolerance = 0.02, .cells = cells, .normal = not_known};
  sg_merge_counts counts;

  if (reversed) {
    add_plate(&solid, 1, 3, 0, false);
    for (size_t v = 0; v < solid.vertices; v++) { /* round the other */
      for (int k = 0; k < 3; k++) {
        solid.vertex[v].at[k] = 2 * solid.vertex[v].at[k] - 2;
      }
    }
  }
  add_plate(&solid, 2, thick, high, reversed);
  CHECK("a plate", is_closed(&solid));
  CHECK("merged", sg_face_merge(&solid, &options, &counts) == SG_MERGE_DONE &&
                      counts.faces_after == (reversed ? 12 : 6));
  sg_solid_clear(&solid);
  return counts.tight;
}

/* A ridge that goes is told beside a wall, or a slot, that is less than a
 * hundred times as thick as it moves, and not beside a thicker one. */
static void
test_told(void)
{
  for (int reversed = 0; reversed <= 1; reversed++) {
    sg_merge_tight thin = told_of_plate(0.2, 0.01, reversed, false);
    sg_merge_tight thick = told_of_plate(0.6, 0.01, reversed, false);
    sg_merge_tight cells = told_of_plate(0.2, 0.01, reversed, true);

    CHECK("two ends of a ridge are told",
          thin.n == 2 && thin.wall && thin.vertex.s == 2);
    CHECK("how far it moves", is_near(thin.move, 0.005, 1e-4));
    CHECK("how thick that is", is_near(thin.feature, 0.21, 1e-3));
    CHECK("a thick one is not told", thick.n == 0);
    CHECK("nor are cells", cells.n == 0);
  }
}

int
main(void)
{
  test_told();
  test_sphere();
  test_cylinder();
  test_touching();
  test_sheet();
  test_bent();
  test_fan();
  test_slivers();
  test_brief_edge();
  test_made_twice();
  return check_report();
}
