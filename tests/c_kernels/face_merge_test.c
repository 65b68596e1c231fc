/* face_merge_test.c -- faces that become one, counted beside an independent
 * model.
 */
#include "../../c_kernels/face_merge.h"
#include "../check.h"
#include "solid_shape.h"

static const double TOLERANCE = 1e-10;

static sg_merge_end
merge(sg_solid *solid, double tolerance)
{
  sg_merge_options options = {.tolerance = tolerance};

  return sg_face_merge(solid, &options, NULL);
}

static bool
has(const sg_solid *solid, size_t faces, size_t vertices, size_t edges)
{
  size_t loose;
  feature_counts counts = solid_counts(solid, &loose);
  bool right = counts.faces == faces && counts.vertices == vertices &&
               counts.edges == edges && loose == 0 && is_closed(solid);

  if (!right) {
    fprintf(
        stderr, "%zu faces, %zu vertices, %zu edges, %zu loose, closed %d\n",
        counts.faces, counts.vertices, counts.edges, loose, is_closed(solid));
  }
  return right;
}

static bool
is_near(double a, double b, double most)
{
  return fabs(a - b) <= most;
}

/* Merges; true if it has what it should have, and no other volume and area. */
static bool
merged_is(sg_solid *solid, double tolerance, size_t faces, size_t vertices,
          size_t edges)
{
  double volume[2], area[2];

  measure(solid, &volume[0], &area[0]);
  if (merge(solid, tolerance) != SG_MERGE_DONE) {
    return false;
  }
  measure(solid, &volume[1], &area[1]);
  return has(solid, faces, vertices, edges) &&
         is_near(volume[0], volume[1], 1e-13 + 4 * area[0] * tolerance) &&
         is_near(area[0], area[1], 1e-13 + 40 * area[0] * tolerance);
}

/* ---- shapes by name ----------------------------------------------------- */

static const struct {
  const char *name;
  int box[2][6];
  size_t faces, vertices, edges;
} pairs[] = {
    {"a cube", {{0, 0, 0, 1, 1, 1}}, 6, 8, 12},
    {"an L of two boxes", {{0, 0, 0, 3, 1, 1}, {0, 0, 1, 1, 1, 3}}, 8, 12, 18},
    {"boxes that share a part of a face",
     {{0, 0, 0, 2, 2, 2}, {2, 0, 1, 4, 2, 3}},
     10,
     16,
     24},
    {"a box in the middle of a face",
     {{0, 0, 0, 3, 3, 1}, {1, 1, 1, 2, 2, 2}},
     11,
     16,
     24},
    {"cubes that touch in an edge",
     {{0, 0, 0, 2, 2, 2}, {2, 2, 0, 4, 4, 2}},
     12,
     14,
     23},
    {"cubes that touch in a part of an edge",
     {{0, 0, 0, 2, 2, 3}, {2, 2, 1, 4, 4, 2}},
     12,
     16,
     25},
    {"cubes that touch in a vertex",
     {{0, 0, 0, 2, 2, 2}, {2, 2, 2, 4, 4, 4}},
     12,
     15,
     24},
    {"one box of two", {{0, 0, 0, 2, 2, 2}, {0, 0, 2, 2, 2, 4}}, 6, 8, 12},
};

static cube_lump
pair_lump(size_t i)
{
  cube_lump lump = {0};

  for (int k = 0; k < 2; k++) {
    const int *b = pairs[i].box[k];
    fill_box(&lump, b[0], b[1], b[2], b[3], b[4], b[5]);
  }
  return lump;
}

static void
test_pairs(void)
{
  for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
    cube_lump lump = pair_lump(i);
    for (grouping how = EACH_TRIANGLE; how <= BY_CHANCE; how++) {
      sg_solid solid = lump_solid(&lump, how);
      CHECK(pairs[i].name, merged_is(&solid, TOLERANCE, pairs[i].faces,
                                     pairs[i].vertices, pairs[i].edges));
      sg_solid_clear(&solid);
    }
  }
}

/* Turned, and shaken by up to `most` tolerances. */
static void
test_turned(const char *name, double far, double most)
{
  unsigned bad = 0;

  for (int round = 0; round < 1000; round++) {
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
      cube_lump lump = pair_lump(i);
      sg_solid solid = lump_solid(&lump, BY_CHANCE);
      place_at_random(&solid, far);
      shake(&solid, most * TOLERANCE);
      bad += !merged_is(&solid, TOLERANCE, pairs[i].faces, pairs[i].vertices,
                        pairs[i].edges);
      sg_solid_clear(&solid);
    }
  }
  CHECK(name, bad == 0);
}

/* Moves what the first box does not have by up to the tolerance. */
static void
move_second(sg_solid *solid, const int first[6])
{
  double by[3];

  for (int k = 0; k < 3; k++) {
    by[k] = random_in(-1, 1) * TOLERANCE;
  }
  for (size_t v = 0; v < solid->vertices; v++) {
    double *at = solid->vertex[v].at;
    bool shared = true;
    for (int k = 0; k < 3; k++) {
      shared = shared && at[k] >= first[k] && at[k] <= first[k + 3];
    }
    for (int k = 0; k < 3 && !shared; k++) {
      at[k] += by[k];
    }
  }
}

static void
test_contacts_off(void)
{
  unsigned bad = 0;

  for (int round = 0; round < 1000; round++) {
    for (size_t i = 1; i < 4; i++) {
      cube_lump lump = pair_lump(i);
      sg_solid solid = lump_solid(&lump, BY_CHANCE);
      move_second(&solid, pairs[i].box[0]);
      place_at_random(&solid, 1);
      bad += !merged_is(&solid, TOLERANCE, pairs[i].faces, pairs[i].vertices,
                        pairs[i].edges);
      sg_solid_clear(&solid);
    }
  }
  CHECK("contacts off by up to the tolerance", bad == 0);
}

static void
test_frame(void)
{
  cube_lump lump = {0};
  sg_solid solid;
  size_t corners = 0;

  fill_box(&lump, 0, 0, 0, 5, 5, 1);
  for (int x = 1; x < 4; x++) {
    for (int y = 1; y < 4; y++) {
      lump.cell[x][y][0] = false;
    }
  }
  solid = lump_solid(&lump, EACH_SQUARE);
  CHECK("a frame", merged_is(&solid, TOLERANCE, 10, 16, 24));
  for (size_t f = 0; f < solid.faces; f++) {
    corners += solid.face[f].n == 8; /* 8 + 2 - 2 */
  }
  CHECK("the two with a hole have the least triangles", corners == 2);
  CHECK("the others too", solid.triangles == 16 + 8 * 2);
  sg_solid_clear(&solid);
}

/* ---- lumps at random ---------------------------------------------------- */

static cube_lump
random_lump(void)
{
  cube_lump lump = {0};
  int side = 2 + pick(3), chance = 1 + pick(6);

  if (pick(2)) {
    for (int boxes = 1 + pick(5); boxes > 0; boxes--) {
      int x = pick(side), y = pick(side), z = pick(side);
      fill_box(&lump, x, y, z, x + 1 + pick(side), y + 1 + pick(side),
               z + 1 + pick(side));
    }
    return lump;
  }
  for (int i = 0; i < side * side * side; i++) {
    lump.cell[i / side / side][i / side % side][i % side] = pick(7) < chance;
  }
  lump.cell[0][0][0] = true;
  return lump;
}

static void
test_lumps(int rounds, bool turned, double most)
{
  unsigned bad = 0;

  for (int round = 0; round < rounds; round++) {
    cube_lump lump = random_lump();
    feature_counts want = lump_counts(&lump);
    sg_solid solid = lump_solid(&lump, (grouping)pick(3));
    if (turned) {
      place_at_random(&solid, 10);
    }
    shake(&solid, most * TOLERANCE);
    if (!merged_is(&solid, TOLERANCE, want.faces, want.vertices, want.edges)) {
      bad++;
      fprintf(stderr, "round %d: %zu faces, %zu vertices, %zu edges wanted\n",
              round, want.faces, want.vertices, want.edges);
    }
    sg_solid_clear(&solid);
  }
  CHECK("lumps have the faces, vertices and edges counted", bad == 0);
}

/* With features as small as the tolerance nothing is promised but this. */
static void
test_coarse(void)
{
  unsigned open = 0, failed = 0;

  for (int round = 0; round < 3000; round++) {
    cube_lump lump = random_lump();
    sg_solid solid = lump_solid(&lump, (grouping)pick(3));
    place_at_random(&solid, 10);
    shake(&solid, random_in(0, 0.6));
    failed += merge(&solid, random_in(0, 1)) != SG_MERGE_DONE;
    open += !is_closed(&solid);
    sg_solid_clear(&solid);
  }
  CHECK("coarse tolerances do not fail", failed == 0);
  CHECK("coarse tolerances open nothing", open == 0);
}

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

/* How far the corners of a face are off the plane of its largest triangle. */
static double
off_plane(const sg_solid *solid, const sg_solid_face *face)
{
  double normal[3] = {0, 0, 0}, length = 0, most = 0;
  const double *o = solid->vertex[solid->triangle[face->first][0]].at;

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    double u[3], v[3];
    const uint32_t *c = solid->triangle[t];
    for (int k = 0; k < 3; k++) {
      u[k] = solid->vertex[c[1]].at[k] - solid->vertex[c[0]].at[k];
      v[k] = solid->vertex[c[2]].at[k] - solid->vertex[c[0]].at[k];
    }
    for (int k = 0; k < 3; k++) {
      int i = (k + 1) % 3, j = (k + 2) % 3;
      normal[k] += u[i] * v[j] - u[j] * v[i];
    }
  }
  for (int k = 0; k < 3; k++) {
    length += normal[k] * normal[k];
  }
  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int i = 0; i < 3; i++) {
      double off = 0;
      for (int k = 0; k < 3; k++) {
        off += (solid->vertex[solid->triangle[t][i]].at[k] - o[k]) * normal[k];
      }
      most = fmax(most, fabs(off) / sqrt(length));
    }
  }
  return most;
}

static void
test_cylinder(void)
{
  sg_solid solid = cylinder(100000);
  sg_solid before = copy_of(&solid);
  double tolerance = 1e-6, most = 0;

  CHECK("a cylinder of many facets",
        merge(&solid, TOLERANCE) == SG_MERGE_DONE &&
            same_solid(&solid, &before));
  sg_solid_clear(&solid);
  sg_solid_clear(&before);
  solid = cylinder(10000);
  CHECK("one of facets finer than the tolerance",
        merge(&solid, tolerance) == SG_MERGE_DONE && is_closed(&solid));
  CHECK("some became one, not all", solid.faces > 1000 && solid.faces < 8000);
  for (size_t f = 0; f < solid.faces; f++) {
    most = fmax(most, off_plane(&solid, &solid.face[f]));
  }
  CHECK("none bends by more than the tolerance", most <= 2.1 * tolerance);
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
  cube_lump lump = pair_lump(0);
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
  cube_lump lump = pair_lump(0);
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

/* ---- what may be said ---------------------------------------------------- */

/* Two boxes side by side, of segments 1 and 2: flush all round. */
static sg_solid
two_segments(void)
{
  cube_lump lump = {0};

  fill_box(&lump, 0, 0, 0, 2, 1, 1);
  sg_solid solid = lump_solid(&lump, EACH_SQUARE);
  for (size_t f = 0; f < solid.faces; f++) {
    const uint32_t *c = solid.triangle[solid.face[f].first];
    double x = 0;
    for (int k = 0; k < 3; k++) {
      x += solid.vertex[c[k]].at[0] / 3;
    }
    solid.face[f].s = x > 1 ? 2 : 1;
    solid.face[f].reversed = x > 1;
  }
  return solid;
}

static void
test_options(void)
{
  sg_solid solid = two_segments();
  sg_merge_options options = {.tolerance = TOLERANCE};
  sg_merge_pair *pair;
  size_t n;

  CHECK("pairs",
        sg_face_merge_pairs(&solid, &options, &pair, &n) == SG_MERGE_DONE &&
            n == 4 && pair[0].one.s == 1 && pair[0].other.s == 2 &&
            pair[0].other.reversed);
  options.apart = pair + 1;
  options.aparts = 2;
  sg_merge_counts counts;
  CHECK("pairs that stay apart",
        sg_face_merge(&solid, &options, &counts) == SG_MERGE_DONE &&
            counts.faces_before == 10 && counts.faces_after == 8 &&
            counts.refused == 0 && is_closed(&solid));
  CHECK("what they came from", solid.parts == 2 && solid.part[0].s == 2 &&
                                   solid.part[0].reversed &&
                                   solid.face[solid.part[0].face].s == 1);
  free(pair);
  sg_solid_clear(&solid);
  solid = two_segments();
  options = (sg_merge_options){.tolerance = TOLERANCE, .separate = true};
  CHECK("segments that stay apart",
        sg_face_merge(&solid, &options, NULL) == SG_MERGE_DONE &&
            solid.faces == 10 && solid.vertices == 12);
  sg_solid_clear(&solid);
}

/* Vertices made by cuts keep their names. */
static void
test_names(void)
{
  cube_lump lump = pair_lump(1);
  sg_solid solid = lump_solid(&lump, EACH_TRIANGLE);
  size_t made = solid.vertices - 5;
  double at[5000][3];
  bool right = true;

  solid.plain = 5;
  solid.origin = malloc(made * sizeof *solid.origin);
  for (size_t i = 0; solid.origin && i < made; i++) {
    solid.origin[i] = malloc(sizeof **solid.origin);
    if (!solid.origin[i]) {
      abort();
    }
    *solid.origin[i] = (uint32_t)i + 5;
  }
  for (size_t v = 0; v < solid.vertices; v++) {
    memcpy(at[v], solid.vertex[v].at, sizeof at[v]);
  }
  add_vertex(&solid, 9, 9, 9); /* in no triangle */
  solid.vertices--;
  solid.plain = 5;
  merge(&solid, TOLERANCE);
  CHECK("some vertices vanished", has(&solid, 8, 12, 18) && solid.plain < 6);
  for (size_t v = solid.plain; v < solid.vertices; v++) {
    uint32_t was = *solid.origin[v - solid.plain];
    right = right && memcmp(at[was], solid.vertex[v].at, sizeof *at) == 0;
  }
  CHECK("the others have their names", right);
  sg_solid_clear(&solid);
}

static void
test_threads(void)
{
  unsigned different = 0;

  for (int round = 0; round < 60; round++) {
    cube_lump lump = random_lump();
    sg_solid solid = lump_solid(&lump, BY_CHANCE);
    place_at_random(&solid, 10);
    sg_solid other = copy_of(&solid);
    sg_merge_options options = {.tolerance = TOLERANCE,
                                .crew = sg_crew_open(2 + (unsigned)round % 3)};
    merge(&solid, TOLERANCE);
    sg_face_merge(&other, &options, NULL);
    different += !same_solid(&solid, &other);
    sg_crew_close(options.crew);
    sg_solid_clear(&solid);
    sg_solid_clear(&other);
  }
  CHECK("any number of threads gives the same", different == 0);
}

static bool
ask(void *data)
{
  return --*(int *)data < 0;
}

static void
test_stopped(void)
{
  unsigned changed = 0, stopped = 0;

  for (int after = 0; after < 60; after++) {
    cube_lump lump = pair_lump(1);
    sg_solid solid = lump_solid(&lump, EACH_TRIANGLE);
    sg_solid before = copy_of(&solid);
    int left = after;
    sg_poll poll = {ask, &left};
    sg_merge_options options = {.tolerance = TOLERANCE, .poll = &poll};
    if (sg_face_merge(&solid, &options, NULL) == SG_MERGE_STOPPED) {
      stopped++;
      changed += !same_solid(&solid, &before);
    }
    sg_solid_clear(&solid);
    sg_solid_clear(&before);
  }
  CHECK("stopped in between", stopped > 5);
  CHECK("stopped: as it was", changed == 0);
}

int
main(void)
{
  test_pairs();
  test_turned("turned pairs", 10, 0);
  test_turned("turned pairs with places off by half a tolerance", 1, 0.5);
  test_contacts_off();
  test_frame();
  test_lumps(5000, false, 0);
  test_lumps(5000, true, 0);
  test_lumps(1000, true, 0.4);
  test_coarse();
  test_sphere();
  test_cylinder();
  test_touching();
  test_sheet();
  test_bent();
  test_fan();
  test_slivers();
  test_brief_edge();
  test_made_twice();
  test_options();
  test_names();
  test_threads();
  test_stopped();
  return check_report();
}
