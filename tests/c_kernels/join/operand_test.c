/* operand_test.c -- balance, volume and stars; knots; and the join of a tree
 * with itself: by hand, and against plain counting on random soups of triangles
 * on a coarse grid.
 */
#include "tests/check.h"

#include "join/cut.h"
#include "join/nonmanifold.h"
#include "join/operand.h"
#include "join/self_leaf.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64, SOUPS = 400, MANY = 35 /* pages */ };

static uint32_t
draw(uint32_t n)
{
  static uint64_t state = 4;

  state = state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(state >> 33) % n;
}

/* Vertices 1 .. n, triangles that are polygons of their own, and their edges,
 * as relations of segment 1: one page each. */
typedef struct relation {
  uint64_t live[SG_LIVE_WORDS];
  const uint64_t *live_at[1];
  int32_t i[6][SG_PAGE_ROWS];
  double f[3][SG_PAGE_ROWS];
  sg_cells cells[6];
  sg_view view;
  uint32_t n;
} relation;

typedef struct mesh {
  double at[MOST + 1][3];
  int32_t vertices, triangle[MOST][3], triangles;
  relation v, e, t;
  sg_leaf_views views;
  sg_leaf_tree *tree;
} mesh;

static void
show(relation *r, unsigned floats, sg_view *out)
{
  r->live_at[0] = r->live;
  r->view = (sg_view){.pages = 1, .live = r->live_at};
  for (unsigned c = 0; c < 6; c++) {
    if (floats > 0 && c >= 2 && c < 2 + floats) {
      r->cells[c].f = r->f[c - 2];
    } else {
      r->cells[c].i = r->i[c];
    }
    r->view.column[c].page = &r->cells[c];
  }
  for (uint32_t k = 0; k < r->n; k++) {
    r->live[k / 64] |= (uint64_t)1 << k % 64;
  }
  *out = r->view;
}

static void
open_mesh(mesh *m)
{
  const int32_t one = 1;

  for (int32_t v = 1; v <= m->vertices; v++, m->v.n++) {
    m->v.i[0][m->v.n] = 1;
    m->v.i[1][m->v.n] = v;
    for (int k = 0; k < 3; k++) {
      m->v.f[k][m->v.n] = m->at[v][k];
    }
  }
  for (int32_t t = 0; t < m->triangles; t++, m->t.n++) {
    m->t.i[0][m->t.n] = 1;
    m->t.i[1][m->t.n] = m->t.i[2][m->t.n] = t + 1;
    for (int k = 0; k < 3; k++, m->e.n++) {
      m->t.i[3 + k][m->t.n] = m->triangle[t][k];
      m->e.i[0][m->e.n] = m->e.i[4][m->e.n] = 1;
      m->e.i[1][m->e.n] = (int32_t)m->e.n + 1;
      m->e.i[2][m->e.n] = m->triangle[t][k];
      m->e.i[3][m->e.n] = m->triangle[t][(k + 1) % 3];
    }
  }
  show(&m->v, 3, &m->views.v);
  show(&m->e, 0, &m->views.e);
  show(&m->t, 0, &m->views.t);
  if (!sg_leaf_trees_grow(&m->views, &one, 1, NULL, NULL, &m->tree)) {
    abort();
  }
}

static mesh *
new_mesh(void)
{
  return calloc(1, sizeof(mesh));
}

static void
close_mesh(mesh *m)
{
  sg_leaf_tree_close(m->tree);
  free(m);
}

static void
add(mesh *m, int32_t a, int32_t b, int32_t c)
{
  int32_t *t = m->triangle[m->triangles++];

  t[0] = a, t[1] = b, t[2] = c;
}

/* A tetrahedron on these vertices, at o and o + size along the axes. */
static void
add_tetrahedron(mesh *m, const int32_t v[4], const double o[3], double size)
{
  for (int i = 0; i < 4; i++) {
    for (int k = 0; k < 3; k++) {
      m->at[v[i]][k] = o[k] + (i == k + 1 ? size : 0);
    }
    m->vertices = v[i] > m->vertices ? v[i] : m->vertices;
  }
  add(m, v[0], v[2], v[1]);
  add(m, v[0], v[1], v[3]);
  add(m, v[0], v[3], v[2]);
  add(m, v[1], v[2], v[3]);
}

static sg_operand
operand_of(const mesh *m)
{
  sg_operand out;

  if (!sg_operand_see(m->tree, &m->views, NULL, NULL, &out)) {
    abort();
  }
  return out;
}

/* ---- by hand ---- */

static void
test_tetrahedra(void)
{
  static const double origin[3] = {0}, far[3] = {9, 0, 0};
  mesh *m = new_mesh();

  add_tetrahedron(m, (int32_t[4]){1, 2, 3, 4}, origin, 6);
  open_mesh(m);
  sg_operand o = operand_of(m);
  CHECK("balanced", o.balanced && o.triangles == 4 && o.half_edges == 12);
  CHECK("volume", fabs(o.volume - 36) <= o.error && o.error < 1e-12);
  CHECK("no star: its middle is not inside", !o.star);
  close_mesh(m);

  m = new_mesh();
  add_tetrahedron(m, (int32_t[4]){1, 2, 3, 4}, origin, 6);
  add_tetrahedron(m, (int32_t[4]){5, 6, 7, 8}, far, 6);
  m->triangles--;
  open_mesh(m);
  o = operand_of(m);
  CHECK("not balanced", !o.balanced);
  close_mesh(m);
}

/* Shows each page of a relation so often. */
static void
repeat(const sg_view *view, sg_cells cells[6][MANY], const uint64_t *live[MANY],
       sg_view *out)
{
  *out = *view;
  out->pages = MANY;
  out->live = live;
  for (int i = 0; i < MANY; i++) {
    live[i] = view->live[0];
    for (int c = 0; c < 6; c++) {
      cells[c][i] = view->column[c].page[0];
      out->column[c].page = cells[c];
    }
  }
}

/* Many pages are shared among tasks: each is counted once. */
static void
test_pages(void)
{
  static const double origin[3] = {0};
  static sg_cells edges[6][MANY], triangles[6][MANY];
  static const uint64_t *live[2][MANY];
  mesh *m = new_mesh();

  add_tetrahedron(m, (int32_t[4]){1, 2, 3, 4}, origin, 6);
  open_mesh(m);
  repeat(&m->e.view, edges, live[0], &m->views.e);
  repeat(&m->t.view, triangles, live[1], &m->views.t);
  m->tree->end = MANY * SG_PAGE_ROWS;
  sg_operand o = operand_of(m);
  CHECK("half-edges of all pages", o.balanced && o.half_edges == MANY * 12);
  CHECK("the volume of all", fabs(o.volume - MANY * 36) <= o.error);
  close_mesh(m);
}

/* An octahedron is seen from its middle. Turned inside out it is not. */
static void
test_star(void)
{
  for (int inward = 0; inward < 2; inward++) {
    mesh *m = new_mesh();

    for (int k = 0; k < 6; k++) {
      m->at[k + 1][k / 2] = k % 2 ? -1 : 1;
    }
    m->vertices = 6;
    for (int i = 0; i < 8; i++) {
      int32_t x = i & 1 ? 2 : 1, y = i & 2 ? 4 : 3, z = i & 4 ? 6 : 5;
      bool odd = ((i & 1) + (i >> 1 & 1) + (i >> 2 & 1)) % 2 != inward;

      add(m, x, odd ? z : y, odd ? y : z);
    }
    open_mesh(m);
    sg_operand o = operand_of(m);
    CHECK("octahedron", o.balanced && o.star == !inward);
    CHECK("its volume", fabs(fabs(o.volume) - 4.0 / 3) < 1e-12);
    close_mesh(m);
  }
}

static void
test_knots(void)
{
  static const double origin[3] = {0}, other[3] = {0, 0, -6};
  /* Two tetrahedra: apart, with a vertex in common, with an edge. */
  static const int32_t second[3][4] = {
      {5, 6, 7, 8}, {1, 5, 6, 7}, {1, 5, 2, 6}};

  for (size_t i = 0; i < 3; i++) {
    mesh *m = new_mesh();
    sg_nonmanifold nonmanifold;

    add_tetrahedron(m, (int32_t[4]){1, 2, 3, 4}, origin, 6);
    add_tetrahedron(m, second[i], other, 3);
    open_mesh(m);
    CHECK("knots", sg_nonmanifold_find(m->tree, &m->views, NULL, &nonmanifold));
    CHECK("as many vertices as are shared", nonmanifold.vertices == i);
    CHECK("their names", (i < 1 || nonmanifold.vertex[0] == 1) &&
                             (i < 2 || nonmanifold.vertex[1] == 2));
    CHECK("edges from both ends", nonmanifold.edges == (i == 2 ? 2 : 0));
    sg_nonmanifold_clear(&nonmanifold);
    close_mesh(m);
  }
}

/* ---- soups ---- */

static void
soup(mesh *m)
{
  m->vertices = 5 + (int32_t)draw(6);
  for (int32_t v = 1; v <= m->vertices; v++) {
    for (int k = 0; k < 3; k++) {
      m->at[v][k] = draw(4);
    }
  }
  for (uint32_t n = 3 + draw(10); n > 0; n--) {
    int32_t v[3];

    for (int k = 0; k < 3; k++) {
      v[k] = 1 + (int32_t)draw((uint32_t)m->vertices);
    }
    if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0]) {
      add(m, v[0], v[1], v[2]);
    }
  }
  if (draw(2)) { /* as many turned round: balanced */
    for (int32_t t = 0, n = m->triangles; t < n; t++) {
      add(m, m->triangle[t][0], m->triangle[t][2], m->triangle[t][1]);
    }
  }
}

/* Half-edges from a to b. */
static int
count(const mesh *m, int32_t a, int32_t b)
{
  int n = 0;

  for (int32_t t = 0; t < m->triangles; t++) {
    for (int k = 0; k < 3; k++) {
      n += m->triangle[t][k] == a && m->triangle[t][(k + 1) % 3] == b;
    }
  }
  return n;
}

static void
check_edges(const mesh *m)
{
  size_t open = 0, unbalanced = 0, crowded = 0;
  sg_operand_edges edges;

  for (int32_t a = 1; a <= m->vertices; a++) {
    for (int32_t b = a + 1; b <= m->vertices; b++) {
      int forward = count(m, a, b), backward = count(m, b, a);

      open += forward + backward == 1;
      unbalanced += forward + backward > 1 && forward != backward;
      crowded += forward + backward > 2 && forward == backward;
    }
  }
  CHECK("edges", sg_operand_edges_find(&m->views, 1, 1000, NULL, &edges));
  CHECK("as counted", edges.open == open && edges.unbalanced == unbalanced &&
                          edges.crowded == crowded);
  CHECK("listed", edges.firsts == open + unbalanced);
  for (size_t i = 0; i < edges.firsts; i++) {
    const sg_operand_edge *e = &edges.first[i];
    CHECK("an edge", e->forward == (size_t)count(m, e->v[0], e->v[1]) &&
                         e->backward == (size_t)count(m, e->v[1], e->v[0]));
  }
  CHECK("the fingerprint says the same",
        operand_of(m).balanced == (open + unbalanced == 0));
  free(edges.first);
}

static void
corners(const mesh *m, int32_t t, double out[3][3])
{
  for (int k = 0; k < 3; k++) {
    memcpy(out[k], m->at[m->triangle[t][k]], sizeof out[k]);
  }
}

/* Whether an end is a corner that both have. */
static bool
is_shared(const mesh *m, int32_t t, int32_t u, const sg_cut_end *end)
{
  return end->f[0] <= SG_CORNER_2 && end->f[1] <= SG_CORNER_2 &&
         m->triangle[t][end->f[0]] == m->triangle[u][end->f[1]];
}

/* Whether two triangles have more in common than what they share. */
static bool
meet(const mesh *m, int32_t t, int32_t u)
{
  double a[3][3], b[3][3];
  sg_cut cut[SG_CUT_MAX];
  int n;

  corners(m, t, a);
  corners(m, u, b);
  sg_cut_triangles((const double(*)[3])a, (const double(*)[3])b, cut, &n);
  for (int i = 0; i < n; i++) {
    if (!is_shared(m, t, u, &cut[i].end[0]) ||
        !is_shared(m, t, u, &cut[i].end[1])) {
      return true;
    }
  }
  return false;
}

/* Every pair that meets is kept. Those that do not are mostly left out. */
static void
check_join(const mesh *m, size_t *kept, size_t *met)
{
  bool found[MOST][MOST] = {0};
  sg_bvh_hits hits;

  CHECK("joined", sg_self_leaf_join(m->tree, &m->views, 0, NULL, NULL, &hits));
  for (size_t i = 0; i < hits.n; i++) {
    uint32_t a = m->tree->boxes->item[hits.hit[i].a];
    uint32_t b = m->tree->boxes->item[hits.hit[i].b];
    CHECK("once", !found[a][b]);
    found[a][b] = found[b][a] = true;
  }
  *kept += hits.n;
  for (int32_t t = 0; t < m->triangles; t++) {
    for (int32_t u = t + 1; u < m->triangles; u++) {
      if (meet(m, t, u)) {
        ++*met;
        CHECK("a pair that meets", found[t][u]);
      }
    }
  }
  free(hits.hit);
}

int
main(void)
{
  size_t kept = 0, met = 0;

  test_tetrahedra();
  test_pages();
  test_star();
  test_knots();
  for (int i = 0; i < SOUPS; i++) {
    mesh *m = new_mesh();

    soup(m);
    if (m->triangles > 0) {
      open_mesh(m);
      check_edges(m);
      check_join(m, &kept, &met);
      close_mesh(m);
    } else {
      free(m);
    }
  }
  CHECK("many pairs meet", met > 1000);
  CHECK("others are kept where they touch in a plane", kept < 3 * met);
  printf("counted: %zu pairs that meet, of %zu kept\n", met, kept);
  return check_report();
}
