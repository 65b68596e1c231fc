/* mesh_test.c -- mesh files: what is read, what is refused, what is written. */
#include "tests/check.h"

#include "mesh_reads.h"

#include <math.h>

/* STL -------------------------------------------------------------------- */

#define FACET(a, b, c)                                                         \
  "facet normal 0 0 1\n outer loop\n  vertex " a "\n  vertex " b               \
  "\n  vertex " c "\n endloop\nendfacet\n"
#define TETRAHEDRON                                                            \
  FACET("0 0 0", "0 1 0", "1 0 0")                                             \
  FACET("0 0 0", "1 0 0", "0 0 1")                                             \
  FACET("0 0 0", "0 0 1", "0 1 0") FACET("1 0 0", "0 1 0", "0 0 1")

static void
test_stl_text(void)
{
  CHECK("reads", reads(SG_MESH_STL, "solid a b \n" TETRAHEDRON "endsolid\n"));
  CHECK("welds", mesh.vertices == 4 && mesh.welded == 8);
  CHECK("faces", mesh.face.count == 4 && mesh.face.corners == 12);
  CHECK("name", mesh.segments == 1 && !strcmp(mesh.name[0], "a b"));
  CHECK("minus zero is zero",
        reads(SG_MESH_STL, "solid\n" FACET("0 0 0", "1 0 0", "0 1 0")
                               FACET("-0 0 0", "0 1 -0", "1 0 0") "endsolid") &&
            mesh.vertices == 3);
  CHECK("crlf and tabs",
        reads(SG_MESH_STL, "solid x\r\n\tfacet normal\t0 0 1\r\nouter loop\r\n"
                           "vertex 0 0 0\r\nvertex 1 0 0\r\nvertex 0 1 0\r\n"
                           "endloop\r\nendfacet\r\nendsolid x\r\n"));
  CHECK("two solids", reads(SG_MESH_STL, "solid a\n" TETRAHEDRON
                                         "endsolid a\nsolid b\n" TETRAHEDRON
                                         "endsolid b\n") &&
                          mesh.segments == 2 && mesh.face.segment[7] == 1);
  CHECK("nan in a normal is no matter",
        reads(SG_MESH_STL, "solid\nfacet normal nan nan nan\nouter loop\n"
                           "vertex 0 0 0 vertex 1 0 0 vertex 0 1 0\n"
                           "endloop endfacet endsolid"));
  CHECK("degenerate facets go",
        reads(SG_MESH_STL, "solid\n" FACET("0 0 0", "0 0 0", "1 0 0")
                               TETRAHEDRON "endsolid") &&
            mesh.degenerate == 1 && mesh.face.count == 4);
}

static void
test_stl_text_errors(void)
{
  CHECK("empty", refuses(SG_MESH_STL, "", SG_MESH_EMPTY_FILE, 1));
  CHECK("blank", refuses(SG_MESH_STL, " \n\n", SG_MESH_EMPTY_FILE, 1));
  CHECK("no facets",
        refuses(SG_MESH_STL, "solid a\nendsolid a\n", SG_MESH_NO_FACES, 3));
  CHECK("number",
        refuses(SG_MESH_STL,
                "solid\n" FACET("0 0 0", "0 blah 0", "1 0 0") "endsolid",
                SG_MESH_BAD_NUMBER, 5) &&
            !strcmp(error.text, "blah") && error.column == 12);
  CHECK("nan", refuses(SG_MESH_STL,
                       "solid\n" FACET("0 0 0", "0 0 nan", "1 0 0") "endsolid",
                       SG_MESH_NOT_FINITE, 5));
  CHECK("four corners",
        refuses(
            SG_MESH_STL,
            "solid\n" FACET("0 0 0", "1 0 0", "0 1 0\nvertex 1 1 1") "endsolid",
            SG_MESH_EXPECTED, 7) &&
            !strcmp(error.wanted, "endloop"));
  CHECK("truncated",
        refuses(SG_MESH_STL, "solid a\n" TETRAHEDRON, SG_MESH_EXPECTED, 30) &&
            !strcmp(error.text, ""));
  CHECK("not stl", refuses(SG_MESH_STL, "hello\n", SG_MESH_EXPECTED, 1));
}

static size_t
binary_stl(char *out, const char *header, uint32_t says, uint32_t holds)
{
  static const float corner[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

  memset(out, 0, 84 + 50 * holds);
  memcpy(out, header, strlen(header));
  for (int i = 0; i < 4; i++) {
    out[80 + i] = (char)(says >> 8 * i & 0xff);
  }
  for (uint32_t i = 0; i < holds; i++) {
    for (int c = 0; c < 3; c++) {
      float p[3] = {corner[c][0], corner[c][1], (float)i};
      memcpy(out + 84 + 50 * i + 12 + 12 * c, p, sizeof p);
    }
  }
  return 84 + 50 * holds;
}

static void
test_stl_binary(void)
{
  char bytes[1024] = {0};
  size_t n = binary_stl(bytes, "solid in name only", 3, 3);

  CHECK("solid is no proof", read_bytes(SG_MESH_STL, bytes, n));
  CHECK("counts", mesh.face.count == 3 && mesh.vertices == 9);
  CHECK("grain of float32", mesh.grain == ldexp(1, 2 - 24));
  CHECK("detected", sg_mesh_detect(bytes, n) == SG_MESH_STL);
  CHECK("trailing bytes",
        read_bytes(SG_MESH_STL, bytes, n + 7) && mesh.trailing == 7);
  n = binary_stl(bytes, "truncated", 5, 3);
  CHECK("truncated", !read_bytes(SG_MESH_STL, bytes, n) &&
                         error.code == SG_MESH_TRUNCATED && error.got == 3 &&
                         error.limit == 5);
  n = binary_stl(bytes, "huge", 0xffffffffu, 3);
  CHECK("a huge count allocates nothing",
        !read_bytes(SG_MESH_STL, bytes, n) && error.code == SG_MESH_TRUNCATED);
  n = binary_stl(bytes, "none", 0, 0);
  CHECK("no triangles",
        !read_bytes(SG_MESH_STL, bytes, n) && error.code == SG_MESH_NO_FACES);
  n = binary_stl(bytes, "nan", 1, 1);
  float nan = NAN;
  memcpy(bytes + 84 + 16, &nan, 4);
  CHECK("nan", !read_bytes(SG_MESH_STL, bytes, n) &&
                   error.code == SG_MESH_NOT_FINITE && error.byte == 100);
  n = binary_stl(bytes, "joined", 2, 2);
  for (int k = 0; k < 9; k++) { /* the first triangle again; its 0 are -0.0 */
    float x;
    memcpy(&x, bytes + 84 + 12 + 4 * k, 4);
    x = x == 0 ? -0.0f : x;
    memcpy(bytes + 84 + 50 + 12 + 4 * k, &x, 4);
  }
  CHECK("equal corners are joined, -0.0 too",
        read_bytes(SG_MESH_STL, bytes, n) && mesh.vertices == 3 &&
            mesh.welded == 3 && mesh.face.count == 2);
  memcpy(bytes + 84 + 50 + 12 + 32, &nan, 4);
  CHECK("nan in the last corner", !read_bytes(SG_MESH_STL, bytes, n) &&
                                      error.code == SG_MESH_NOT_FINITE &&
                                      error.byte == 84 + 50 + 12 + 32);
  CHECK("short header", !read_bytes(SG_MESH_STL, "solid\0\1\2", 8) &&
                            error.code == SG_MESH_TRUNCATED);
}

/* Sources ---------------------------------------------------------------- */

/* The grain of a triangle of these coordinates as OFF. */
static double
grain_of(const char *comment, const char *coordinates)
{
  char text[256];

  snprintf(text, sizeof text, "OFF\n%s\n3 1 0\n%s\n3 0 1 2\n", comment,
           coordinates);
  return read_bytes(SG_MESH_OFF, text, strlen(text)) ? mesh.grain : -1;
}

static void
test_sources(void)
{
  CHECK("few digits are exact", grain_of("", "0 0 0\n1.25 0 0\n0 0.5 0") == 0);
  CHECK("so are many of something far away",
        grain_of("", "12345.5 0 0\n12355.5 0 0\n12345.5 10 0") == 0);
  CHECK("the last place of the largest number of most digits",
        fabs(grain_of("", "0 0 0\n7.12345 1 0\n0.123456 0.5 0") - 1e-5) <
            1e-20);
  CHECK("whatever the others",
        fabs(grain_of("", "0 0 0\n1234.567890 1 0\n0.5 1e-9 0") - 1e-6) <
            1e-20);
  CHECK("17 digits are doubles",
        grain_of("", "0 0 0\n0.12345678901234567 1 0\n1 0.123456 0") == 0);
  CHECK("a comment says it",
        grain_of("# precision 0.25", "0 0 0\n1 0 0\n0 1 0") == 0.25);
  CHECK("or that these are doubles",
        grain_of("# precision 0", "0 0 0\n1.234567 0 0\n0 1 0") == 0);
  CHECK("a comment that does not say it",
        grain_of("# precision -1", "0 0 0\n1 0 0\n0 1 0") == 0 &&
            grain_of("# precision", "0 0 0\n1 0 0\n0 1 0") == 0 &&
            grain_of("# precision nan", "0 0 0\n1 0 0\n0 1 0") == 0 &&
            grain_of("# precisions 5", "0 0 0\n1 0 0\n0 1 0") == 0);
}

/* Of a solid of this name whose end has these words. */
static double
grain_of_solid(const char *name, const char *end)
{
  char text[512];

  snprintf(text, sizeof text, "solid %s\n%sendsolid %s\n", name,
           FACET("0 0 0", "1 0 0", "0 1 0"), end);
  return read_bytes(SG_MESH_STL, text, strlen(text)) ? mesh.grain : -1;
}

static void
test_sources_of_stl(void)
{
  CHECK("after the name", grain_of_solid("a b", "a b precision 0.25") == 0.25);
  CHECK("of no name", grain_of_solid("", "precision 0.25") == 0.25 &&
                          grain_of_solid("", " precision 0.25") == 0.25);
  CHECK("blanks at the ends of a name",
        grain_of_solid(" a ", " a  precision 0.25") == 0 &&
            grain_of_solid(" a ", " a precision 0.25") == 0.25);
  CHECK("a name that looks so",
        grain_of_solid("a precision 0.25", "a precision 0.25") == 0 &&
            grain_of_solid("a precision 0.25",
                           "a precision 0.25 precision 2") == 2);
  CHECK("another name", grain_of_solid("a", "b precision 0.25") == 0 &&
                            grain_of_solid("a", "ab precision 0.25") == 0 &&
                            grain_of_solid("a", "") == 0);
}

/* OFF -------------------------------------------------------------------- */

static void
test_off(void)
{
  CHECK("reads", reads(SG_MESH_OFF, "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                                    "3 0 1 2\n4 0 1 2 3 0.1 0.2 0.3\n") &&
                     mesh.face.count == 2 && mesh.face.corners == 7);
  CHECK("comments and counts behind the keyword",
        reads(SG_MESH_OFF, "OFF 3 1 0 # counts\n\n#x\n0 0 0 # a\n1 0 0\n"
                           "0 1 0\n3 0 1 2\n"));
  CHECK("colours and normals",
        reads(SG_MESH_OFF, "CNOFF\n3 1 0\n0 0 0 0 0 1 9 9 9 9\n"
                           "1 0 0 0 0 1 9 9 9 9\n0 1 0 0 0 1 9 9 9 9\n"
                           "3 0 1 2\n"));
  CHECK("no keyword", reads(SG_MESH_OFF, "3 1 0\n0 0 0\n1 0 0\n0 1 0\n"
                                         "3 0 1 2\n"));
  CHECK("curves", reads(SG_MESH_OFF, "OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 1\n") &&
                      mesh.curve.count == 1);
  CHECK("soup is welded",
        reads(SG_MESH_OFF, "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n0 1 0\n1 0 0\n"
                           "1 1 0\n3 0 1 2\n3 3 4 5\n") &&
            mesh.vertices == 4);
  CHECK("repeated corners",
        reads(SG_MESH_OFF, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"
                           "5 0 0 1 2 0\n") &&
            mesh.face.corners == 3 && mesh.repeated == 2);
}

static void
test_off_errors(void)
{
  CHECK("counts", refuses(SG_MESH_OFF, "OFF\n3 x 0\n", SG_MESH_BAD_COUNT, 2));
  CHECK("negative",
        refuses(SG_MESH_OFF, "OFF\n-3 1 0\n", SG_MESH_BAD_COUNT, 2));
  CHECK("huge", refuses(SG_MESH_OFF, "OFF\n2000000000 1 0\n0 0 0\n",
                        SG_MESH_TRUNCATED, 2));
  CHECK("index",
        refuses(SG_MESH_OFF, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
                SG_MESH_BAD_INDEX, 6) &&
            error.got == 3 && error.limit == 2);
  CHECK("few faces",
        refuses(SG_MESH_OFF, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                SG_MESH_TRUNCATED, 7));
  CHECK("short line", refuses(SG_MESH_OFF,
                              "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n"
                              "3 0 1 2\n",
                              SG_MESH_EXPECTED, 4));
  CHECK("binary", refuses(SG_MESH_OFF, "OFF BINARY\n", SG_MESH_UNSUPPORTED, 1));
  CHECK("4OFF", refuses(SG_MESH_OFF, "4OFF\n", SG_MESH_UNSUPPORTED, 1));
}

/* OBJ -------------------------------------------------------------------- */

static void
test_obj(void)
{
  CHECK("corners of all kinds",
        reads(SG_MESH_OBJ, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\n"
                           "vn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 3//1 4//1\n"
                           "f 1/1/1 2/1/1 3/1/1 4/1/1\nf -4 -3 -2 -1\n") &&
            mesh.face.count == 4 && mesh.face.corners == 14 &&
            mesh.face.corner[10] == 0 && mesh.face.corner[13] == 3);
  CHECK("objects part, groups in them do not",
        reads(SG_MESH_OBJ, "v 0 0 0\nv 1 0 0\nv 0 1 0\no a\ng x\nf 1 2 3\n"
                           "o b\nf 3 2 1\ng y\nf 1 2 3\no a\nl 1 2\n") &&
            mesh.segments == 2 && !strcmp(mesh.name[1], "b") &&
            mesh.face.segment[2] == 1 && mesh.curve.segment[0] == 0);
  CHECK("groups part without objects",
        reads(SG_MESH_OBJ, "v 0 0 0\nv 1 0 0\nv 0 1 0\ng empty\ng x y\n"
                           "f 1 2 3\ng\nf 3 2 1\n") &&
            mesh.segments == 2 && !strcmp(mesh.name[0], "x y") &&
            mesh.name[1] == NULL);
  CHECK("used before it is given",
        reads(SG_MESH_OBJ, "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"));
  CHECK("continued lines, comments, colours, unknown lines",
        reads(SG_MESH_OBJ, "# c\nv 0 0 0 1 0 0\nv 1 0 \\\n 0\nv 0 1 0 # d\n"
                           "f 1 2\\\n3\nfoo 1\n") &&
            mesh.face.corners == 3 && mesh.ignored == 1 &&
            mesh.ignored_line == 8);
  CHECK("only a curve", reads(SG_MESH_OBJ, "v 0 0 0\nv 1 0 0\nl 1 2\n") &&
                            mesh.curve.count == 1);
}

static void
test_obj_errors(void)
{
#define V3 "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
  CHECK("zero", refuses(SG_MESH_OBJ, V3 "f 0 1 2\n", SG_MESH_BAD_INDEX, 4));
  CHECK("beyond", refuses(SG_MESH_OBJ, V3 "f 1 2 4\n", SG_MESH_BAD_INDEX, 4) &&
                      error.column == 7);
  CHECK("before", refuses(SG_MESH_OBJ, V3 "f 1 2 -4\n", SG_MESH_BAD_INDEX, 4));
  CHECK("word", refuses(SG_MESH_OBJ, V3 "f 1 2 x\n", SG_MESH_EXPECTED, 4));
  CHECK("slashes",
        refuses(SG_MESH_OBJ, V3 "f 1/2/3/4 2 3\n", SG_MESH_EXPECTED, 4));
  CHECK("two corners",
        refuses(SG_MESH_OBJ, V3 "f 1 2\n", SG_MESH_SHORT_FACE, 4));
  CHECK("short vertex", refuses(SG_MESH_OBJ, "v 1 2\n", SG_MESH_EXPECTED, 1));
  CHECK("infinite",
        refuses(SG_MESH_OBJ, "v 1 2 1e999\n", SG_MESH_NOT_FINITE, 1));
  CHECK("no faces", refuses(SG_MESH_OBJ, V3, SG_MESH_NO_FACES, 4));
}

/* PLY -------------------------------------------------------------------- */

static void
test_ply_text(void)
{
  CHECK("reads",
        reads(SG_MESH_PLY,
              "ply\nformat ascii 1.0\ncomment made by hand\n"
              "element vertex 4\nproperty float x\nproperty uchar red\n"
              "property float y\nproperty float z\n"
              "element thing 2\nproperty list uchar int a\nproperty int b\n"
              "element face 1\nproperty list uchar int vertex_indices\n"
              "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
              "end_header\n0 9 0 0\n1 9 0 0\n1 9 1 0\n0 9 1 0\n"
              "2 7 7 7\n0 7\n4 0 1 2 3\n0 2\n") &&
            mesh.face.corners == 4 && mesh.curve.count == 1 &&
            mesh.vertex[2][1] == 1 && mesh.ignored == 1);
  CHECK("y is missing",
        refuses(SG_MESH_PLY,
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                "property float z\nend_header\n0 0\n",
                SG_MESH_NO_PROPERTY, 3) &&
            !strcmp(error.wanted, "y"));
  CHECK("type", refuses(SG_MESH_PLY,
                        "ply\nformat ascii 1.0\nelement vertex 1\n"
                        "property quad x\n",
                        SG_MESH_EXPECTED, 4));
  CHECK("format",
        refuses(SG_MESH_PLY, "ply\nformat ebcdic 1.0\n", SG_MESH_EXPECTED, 2));
  CHECK("no end",
        refuses(SG_MESH_PLY, "ply\nformat ascii 1.0\n", SG_MESH_EXPECTED, 3));
#define PLY(data)                                                              \
  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"                \
  "property float y\nproperty float z\nelement face 1\n"                       \
  "property list uchar int vertex_index\nend_header\n"                         \
  "0 0 0\n1 0 0\n0 1 0\n" data
  CHECK("index", refuses(SG_MESH_PLY, PLY("3 0 1 3\n"), SG_MESH_BAD_INDEX, 13));
  CHECK("half an index",
        refuses(SG_MESH_PLY, PLY("3 0 1 1.5\n"), SG_MESH_EXPECTED, 13));
  CHECK("two corners",
        refuses(SG_MESH_PLY, PLY("2 0 1\n"), SG_MESH_SHORT_FACE, 13));
  CHECK("length", refuses(SG_MESH_PLY, PLY("-1 0 1\n"), SG_MESH_BAD_COUNT, 13));
  CHECK("cut off", refuses(SG_MESH_PLY, PLY("3 0 1\n"), SG_MESH_EXPECTED, 14));
  CHECK("huge", refuses(SG_MESH_PLY,
                        "ply\nformat ascii 1.0\nelement vertex 2000000000\n"
                        "property float x\nproperty float y\n"
                        "property float z\nend_header\n0 0 0\n",
                        SG_MESH_TRUNCATED, 8));
}

/* Writing and reading back ----------------------------------------------- */

typedef struct buffer {
  char *bytes;
  size_t n;
} buffer;

static bool
append(void *data, const char *bytes, size_t n)
{
  buffer *b = data;

  b->bytes = realloc(b->bytes, b->n + n);
  memcpy(b->bytes + b->n, bytes, n);
  b->n += n;
  return true;
}

static bool
refuse_bytes(void *data, const char *bytes, size_t n)
{
  (void)data;
  (void)bytes;
  (void)n;
  return false;
}

static bool
same_mesh(const sg_mesh *a, const sg_mesh *b)
{
  return a->vertices == b->vertices && a->face.count == b->face.count &&
         a->face.corners == b->face.corners &&
         a->curve.corners == b->curve.corners &&
         !memcmp(a->vertex, b->vertex, a->vertices * sizeof *a->vertex) &&
         !memcmp(a->face.corner, b->face.corner,
                 a->face.corners * sizeof *a->face.corner);
}

/* Writes `mesh` in this format and reads it again into `mesh`. */
static bool
goes_round(sg_mesh_format format, sg_mesh_format read_as)
{
  buffer b = {NULL, 0};
  sg_mesh_sink sink = {append, &b};
  sg_mesh before = mesh;

  if (!sg_mesh_write(format, &mesh, &sink, NULL, &error)) {
    fprintf(stderr, "not written: %s\n", error.text);
    free(b.bytes);
    return false;
  }
  mesh = (sg_mesh){0};
  bool same = sg_mesh_detect(b.bytes, b.n) == read_as &&
              read_bytes(read_as, b.bytes, b.n) && same_mesh(&before, &mesh);
  sg_mesh_clear(&before);
  free(b.bytes);
  return same;
}

static void
test_round(void)
{
  sg_mesh_sink no = {refuse_bytes, NULL};

  reads(SG_MESH_OBJ, "v 0.1 0.30000000000000004 1e-20\nv 1 0 0\n"
                     "v 1 1 -0.3333333333333333\nv 0 1 1e89\nv 7 7 7\n"
                     "o first one\nf 1 2 3 4\no second\nf 1 3 2\nl 4 5 1\n");
  CHECK("obj", goes_round(SG_MESH_OBJ, SG_MESH_OBJ));
  CHECK("names", mesh.segments == 2 && !strcmp(mesh.name[0], "first one"));
  reads(SG_MESH_OBJ, "v 0.1 0.30000000000000004 1e-20\nv 1 0 0\n"
                     "v 1 1 -0.3333333333333333\nv 0 1 1e89\nv 7 7 7\n"
                     "f 1 2 3 4\nf 1 3 2\nl 4 5\n");
  CHECK("off", goes_round(SG_MESH_OFF, SG_MESH_OFF));
  CHECK("ply", goes_round(SG_MESH_PLY, SG_MESH_PLY));
  CHECK("binary ply", goes_round(SG_MESH_PLY_BINARY, SG_MESH_PLY));
  CHECK("stl has no curves",
        !sg_mesh_write(SG_MESH_STL, &mesh, &no, NULL, &error) &&
            error.code == SG_MESH_UNSUPPORTED);
  CHECK("a sink that fails",
        !sg_mesh_write(SG_MESH_PLY, &mesh, &no, NULL, &error) &&
            error.code == SG_MESH_WRITE_FAILED);
  reads(SG_MESH_STL, "solid a\n" TETRAHEDRON "endsolid a\nsolid b\n" FACET(
                         "0 0 0.1", "5 0 0", "0 5 0") "endsolid b\n");
  CHECK("stl", goes_round(SG_MESH_STL, SG_MESH_STL));
  CHECK("both solids", mesh.segments == 2 && !strcmp(mesh.name[1], "b"));
  reads(SG_MESH_STL, "solid a\n" TETRAHEDRON "endsolid a\n");
  CHECK("binary stl", goes_round(SG_MESH_STL_BINARY, SG_MESH_STL));
}

/* Big endian: the little endian file with each scalar turned round. */
static void
test_big_endian(void)
{
  static const unsigned char data[] = {
      0, 0, 0, 0, 0, 0, 0,    0,    0, 0, 0, 0,       /* 0 0 0 */
      0, 0, 0, 1, 0, 0, 0,    0,    0, 0, 0, 0,       /* 1 0 0 */
      0, 0, 0, 0, 0, 1, 0,    0,    0, 0, 0, 0,       /* 0 1 0 */
      0, 0, 0, 0, 0, 0, 0x3f, 0xf8, 0, 0, 0, 0, 0, 0, /* 0 0 1.5 */
      3, 0, 0, 0, 1, 0, 2};
  char file[512];
  const char *header = "ply\nformat binary_big_endian 1.0\nelement vertex 3\n"
                       "property int x\nproperty short y\nproperty ushort q\n"
                       "property float z\nelement face 1\n"
                       "property list uchar short vertex_indices\nend_header\n";
  size_t n = strlen(header);

  memcpy(file, header, n);
  memcpy(file + n, data, 36);
  memcpy(file + n + 36, data + 50, 7);
  CHECK("big endian", read_bytes(SG_MESH_PLY, file, n + 43) &&
                          mesh.vertex[1][0] == 1 && mesh.vertex[2][1] == 1 &&
                          mesh.face.corner[2] == 2);
  CHECK("cut off", !read_bytes(SG_MESH_PLY, file, n + 40) &&
                       error.code == SG_MESH_TRUNCATED);
}

static bool
stop(void *data)
{
  (void)data;
  return true;
}

static void
test_stop(void)
{
  sg_cancel cancel = {stop, NULL};
  sg_mesh_options options = {SG_WELD_AUTO, false, &cancel};
  char text[9 * 5000 + 1];

  text[0] = '\0';
  for (int i = 0; i < 5000; i++) {
    memcpy(text + 8 * i, "v 1 2 3\n", 9);
  }
  CHECK("stops", !sg_mesh_read(SG_MESH_OBJ, text, strlen(text), &options, &mesh,
                               &error) &&
                     error.code == SG_MESH_STOPPED);
}

/* A mesh with so many vertices, triangles and curves; of each, one. */
static void
many_of(int vertices, int faces, int curves)
{
  sg_mesh_clear(&mesh);
  for (int i = 0; i < vertices; i++) {
    sg_mesh_add_vertex(&mesh, (double[3]){i % 2, i % 3, i});
  }
  for (int i = 0; i < faces + curves; i++) {
    sg_mesh_lists *to = i < faces ? &mesh.face : &mesh.curve;
    for (int32_t v = 0; v < (i < faces ? 3 : 2); v++) {
      sg_mesh_add_corner(to, v);
    }
    sg_mesh_end_list(to, 0);
  }
  CHECK("there is room", sg_mesh_add_segment(&mesh, NULL, 0) == 0 &&
                             mesh.vertices == (size_t)vertices &&
                             mesh.face.count == (size_t)faces &&
                             mesh.curve.count == (size_t)curves);
}

static bool
stops_writing(sg_mesh_format format)
{
  buffer b = {NULL, 0};
  sg_mesh_sink sink = {append, &b};
  sg_cancel cancel = {stop, NULL};
  bool stops = !sg_mesh_write(format, &mesh, &sink, &cancel, &error) &&
               error.code == SG_MESH_STOPPED;

  free(b.bytes);
  return stops;
}

/* Whatever there is many of, a writer asks meanwhile. */
static void
test_stop_writing(void)
{
  enum { MANY = 5000 };
  static const sg_mesh_format format[] = {SG_MESH_OFF, SG_MESH_OBJ, SG_MESH_PLY,
                                          SG_MESH_PLY_BINARY};

  for (int i = 0; i < 4; i++) {
    many_of(MANY, 1, 1);
    CHECK("at vertices", stops_writing(format[i]));
    many_of(3, MANY, 1);
    CHECK("at faces", stops_writing(format[i]));
    many_of(3, 1, MANY);
    CHECK("at curves", stops_writing(format[i]));
    many_of(3, 1, 1);
    CHECK("few are written at once", !stops_writing(format[i]));
  }
  many_of(3, MANY, 0);
  CHECK("at facets", stops_writing(SG_MESH_STL));
  CHECK("in binary", stops_writing(SG_MESH_STL_BINARY));
  sg_mesh_clear(&mesh);
}

/* What is valid: each fault alone makes a mesh invalid. */
static void
test_valid(void)
{
  const char *text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n";

  CHECK("a triangle and a line", reads(SG_MESH_OBJ, text));
  CHECK("of three vertices", mesh.vertices == 3 && mesh.face.corners == 3 &&
                                 mesh.curve.corners == 2);
  mesh.face.corner[2] = 3;
  CHECK("a corner beyond the vertices", !mesh_is_valid(&mesh));
  mesh.face.corner[2] = -1;
  CHECK("a corner before them", !mesh_is_valid(&mesh));
  mesh.face.corner[2] = 2;
  CHECK("the last one", mesh_is_valid(&mesh));
  mesh.curve.corner[1] = 3;
  CHECK("of a curve", !mesh_is_valid(&mesh));
  mesh.curve.corner[1] = 1;
  mesh.face.segment[0] = (int32_t)mesh.segments;
  CHECK("a segment beyond them", !mesh_is_valid(&mesh));
  mesh.face.segment[0] = 0;
  mesh.face.start[1] = 2;
  CHECK("two corners", !mesh_is_valid(&mesh));
  mesh.face.start[1] = 3;
  mesh.vertex[2][1] = NAN;
  CHECK("no number", !mesh_is_valid(&mesh));
  mesh.vertex[2][1] = 1;
  CHECK("valid again", mesh_is_valid(&mesh));
}

int
main(void)
{
  test_valid();
  test_stl_text();
  test_stl_text_errors();
  test_stl_binary();
  test_sources();
  test_sources_of_stl();
  test_off();
  test_off_errors();
  test_obj();
  test_obj_errors();
  test_ply_text();
  test_round();
  test_big_endian();
  test_stop();
  test_stop_writing();
  sg_mesh_clear(&mesh);
  return check_report();
}
