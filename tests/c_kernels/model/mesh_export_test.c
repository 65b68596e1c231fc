/* mesh_export_test.c -- random polygons of two segments as a mesh: loops stay,
 * without their seams, holes become triangles, loose edges curves.
 */
#include "model/mesh_export.h"

#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <string.h>

enum { MOST = 64, ROOM = 4000, SEGMENTS = 2 };

/* What is wanted of the mesh: lists, one after another. */
typedef struct lists {
  int32_t corner[ROOM], segment[ROOM];
  uint32_t start[ROOM + 2];
  size_t n;
} lists;

static struct {
  sg_dense d;
  double at[ROOM][3];
  int32_t from[ROOM], to[ROOM], list[ROOM], corner[ROOM][3], polygon_of[ROOM];
  unsigned char real[ROOM];
  uint32_t list_begin[ROOM], vertex_begin[SEGMENTS + 1],
      edge_begin[SEGMENTS + 1], polygon_begin[SEGMENTS + 1],
      triangle_begin[SEGMENTS + 1];
  lists faces, thirds, curves; /* thirds: if all are to be triangles */
} m;

static uint32_t seed;

static void
put(lists *to, int32_t v)
{
  to->corner[to->start[to->n + 1]++] = v;
}

static void
end_list(lists *to, int32_t s)
{
  to->segment[to->n++] = s;
  to->start[to->n + 1] = to->start[to->n];
}

static int32_t
new_vertices(int n)
{
  int32_t first = (int32_t)m.d.vertices;

  for (int i = 0; i < n; i++) {
    for (int k = 0; k < 3; k++) {
      m.at[m.d.vertices][k] = check_below(&seed, 1000) / 8.0;
    }
    m.d.vertices++;
  }
  return first;
}

static void
put_edge(int32_t a, int32_t b, bool real)
{
  m.from[m.d.edges] = a;
  m.to[m.d.edges] = b;
  m.real[m.d.edges++] = real;
}

/* In the list of the polygon at hand. */
static void
list_edge(int32_t a, int32_t b)
{
  m.list[m.list_begin[m.d.polygons + 1]++] = (int32_t)m.d.edges;
  put_edge(a, b, check_below(&seed, 2));
}

static void
mix(int32_t *x, size_t n)
{
  for (size_t i = n; i > 1; i--) {
    size_t k = (size_t)check_below(&seed, (int)i);
    int32_t moved = x[i - 1];
    x[i - 1] = x[k];
    x[k] = moved;
  }
}

/* Triangles of the polygon at hand, any; wanted in these lists. */
static void
put_triangles(int n, int32_t first, int32_t s, lists *one, lists *two)
{
  for (int i = 0; i < n; i++) {
    int32_t *v = m.corner[m.d.triangles];

    for (int k = 0; k < 3; k++) {
      v[k] = first + check_below(&seed, 3);
      if (one) {
        put(one, v[k]);
      }
      put(two, v[k]);
    }
    if (one) {
      end_list(one, s);
    }
    end_list(two, s);
    m.polygon_of[m.d.triangles++] = (int32_t)m.d.polygons;
  }
}

/* A loop of n corners, or two, edges in any order, and pairs there and back, to
 * vertices within. */
static void
put_polygon(int32_t s)
{
  int n = 3 + check_below(&seed, 5), kind = check_below(&seed, 4);
  int pairs = kind == 1 ? 1 + check_below(&seed, 3) : 0,
      loops = 1 + (kind == 2);
  int32_t first = new_vertices(n * loops + pairs);
  uint32_t begin = m.list_begin[m.d.polygons];
  int32_t next[ROOM];

  m.list_begin[m.d.polygons + 1] = begin;
  for (int i = 0; i < n * loops; i++) {
    int32_t a = first + i, b = first + i / n * n + (i + 1) % n;
    list_edge(a, b);
    next[a] = b;
  }
  for (int i = 0; i < pairs; i++) { /* from a corner, and on from there */
    int32_t within = first + n + i;
    int32_t out = i == 0 ? first + check_below(&seed, n) : within - 1;
    list_edge(out, within);
    list_edge(within, out);
  }
  size_t edges = m.list_begin[m.d.polygons + 1] - begin;

  mix(m.list + begin, edges);
  bool whole = loops == 1;
  if (whole) {
    size_t k = begin;
    while (m.from[m.list[k]] >= first + n || m.to[m.list[k]] >= first + n) {
      k++;
    }
    int32_t v = m.from[m.list[k]];
    for (int i = 0; i < n; i++, v = next[v]) {
      put(&m.faces, v);
    }
    end_list(&m.faces, s);
  }
  if (whole && edges == 3) {
    uint32_t last = m.faces.start[m.faces.n - 1];
    for (uint32_t k = 0; k < 3; k++) {
      put(&m.thirds, m.faces.corner[last + k]);
    }
    end_list(&m.thirds, s);
    put_triangles(check_below(&seed, 2), first, s, NULL, &(lists){.n = 0});
  } else {
    put_triangles(1 + check_below(&seed, 4), first, s, whole ? NULL : &m.faces,
                  &m.thirds);
  }
  m.d.polygons++;
}

/* Edges of no polygon: what goes on where the one before ends is one curve. */
static void
put_curves(int32_t s)
{
  int32_t first = new_vertices(9), end = -1;

  for (int i = check_below(&seed, 8); i > 0; i--) {
    int32_t a =
        end >= 0 && check_below(&seed, 2) ? end : first + check_below(&seed, 9);
    int32_t b = first + check_below(&seed, 9);
    bool real = check_below(&seed, 4) > 0;

    put_edge(a, b, real);
    if (!real) {
      continue;
    }
    if (a != end) {
      if (end >= 0) {
        end_list(&m.curves, s);
      }
      put(&m.curves, a);
    }
    put(&m.curves, b);
    end = b;
  }
  if (end >= 0) {
    end_list(&m.curves, s);
  }
}

static void
draw(void)
{
  static int32_t names[SEGMENTS] = {4, 9};
  static double grain[SEGMENTS] = {0.5, 0.25};

  memset(&m, 0, sizeof m);
  m.d = (sg_dense){.segments = SEGMENTS,
                   .segment = names,
                   .grain = grain,
                   .vertex_begin = m.vertex_begin,
                   .edge_begin = m.edge_begin,
                   .polygon_begin = m.polygon_begin,
                   .triangle_begin = m.triangle_begin,
                   .at = m.at,
                   .from = m.from,
                   .to = m.to,
                   .real = m.real,
                   .list_begin = m.list_begin,
                   .list = m.list,
                   .corner = m.corner,
                   .polygon_of = m.polygon_of};
  for (int32_t s = 0; s < SEGMENTS; s++) {
    for (int i = check_below(&seed, 6); i > 0; i--) {
      put_polygon(s);
    }
    put_curves(s);
    m.vertex_begin[s + 1] = (uint32_t)m.d.vertices;
    m.edge_begin[s + 1] = (uint32_t)m.d.edges;
    m.polygon_begin[s + 1] = (uint32_t)m.d.polygons;
    m.triangle_begin[s + 1] = (uint32_t)m.d.triangles;
  }
}

static bool
are_lists(const sg_mesh_lists *x, const lists *wanted)
{
  size_t corners = wanted->start[wanted->n];

  return x->count == wanted->n && x->corners == corners &&
         (x->count == 0 || (memcmp(x->start, wanted->start,
                                   (x->count + 1) * sizeof *x->start) == 0 &&
                            memcmp(x->corner, wanted->corner,
                                   corners * sizeof *x->corner) == 0 &&
                            memcmp(x->segment, wanted->segment,
                                   x->count * sizeof *x->segment) == 0));
}

static bool
exports(bool triangles, bool *done)
{
  static const lists none;
  sg_mesh mesh;
  size_t polygon;
  sg_export_status status = sg_mesh_export(&m.d, triangles, &mesh, &polygon);
  bool good = status == SG_EXPORT_NO_MEMORY ||
              (status == SG_EXPORT_DONE && mesh.segments == SEGMENTS &&
               mesh.grain == 0.5 && mesh.vertices == m.d.vertices &&
               memcmp(mesh.vertex, m.at, m.d.vertices * sizeof *m.at) == 0 &&
               are_lists(&mesh.face, triangles ? &m.thirds : &m.faces) &&
               are_lists(&mesh.curve, triangles ? &none : &m.curves));

  *done = status == SG_EXPORT_DONE;
  sg_mesh_clear(&mesh);
  return good;
}

/* A polygon of two loops that has no triangles is told of. */
static void
without_triangles(void)
{
  size_t polygon = 0;
  sg_mesh mesh;

  seed = 4;
  draw();
  m.d.triangles = 0;
  m.d.polygons = 0;
  m.list_begin[1] = 0;
  size_t edges = m.d.edges;
  do {
    m.d.edges = edges;
    m.d.polygons = 1;
    m.list_begin[1] = m.list_begin[2] = 0;
    put_polygon(0);
  } while (m.list_begin[2] < 6 || m.d.triangles == 0);
  m.polygon_begin[1] = m.polygon_begin[2] = 2;
  m.d.triangles = 0;
  m.triangle_begin[1] = m.triangle_begin[2] = 0;
  CHECK("it needs them",
        sg_mesh_export(&m.d, true, &mesh, &polygon) == SG_EXPORT_NO_TRIANGLES);
  sg_mesh_clear(&mesh);
}

int
main(void)
{
  size_t bad = 0;
  bool done;

  for (uint32_t round = 0; round < 4000; round++) {
    seed = round;
    draw();
    bad += !exports(false, &done) || !done;
    bad += !exports(true, &done) || !done;
  }
  CHECK("as it was drawn", bad == 0);
  for (uint32_t round = 0; round < 20; round++) {
    seed = round;
    draw();
    CHECK_REFUSED("a mesh", exports(round % 2, &done));
    CHECK("with memory", done);
  }
  without_triangles();
  return check_report();
}
