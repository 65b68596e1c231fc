/* solid_shape.h -- solids for tests: of unit cubes, and what is counted of
 * them independently.
 *
 * A lump is a set of cells of a small grid. Its surface is unit squares, and
 * each of them two triangles; their corners are shared by place.
 */
#ifndef SG_TEST_SOLID_SHAPE_H
#define SG_TEST_SOLID_SHAPE_H

#include "solid/solid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 8, NODES = (SIDE + 1) * (SIDE + 1) * (SIDE + 1) };

/* ---- random numbers ----------------------------------------------------- */

static uint64_t random_state = 1;

static inline uint64_t
random_bits(void)
{
  uint64_t x = (random_state += 0x9e3779b97f4a7c15u);

  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

static inline int
pick(int n)
{
  return (int)(random_bits() % (uint64_t)n);
}

static inline double
random_in(double low, double high)
{
  return low + (high - low) * (double)(random_bits() >> 11) * 0x1p-53;
}

/* ---- solids ------------------------------------------------------------- */

static inline void *
enough(void *base, size_t n, size_t size)
{
  if ((n & (n - 1)) == 0) { /* full: n is 0 or a power of two */
    base = realloc(base, (n ? 2 * n : 1) * size);
    if (!base) {
      abort();
    }
  }
  return base;
}

static inline uint32_t
add_vertex(sg_solid *solid, double x, double y, double z)
{
  solid->vertex = enough(solid->vertex, solid->vertices, sizeof *solid->vertex);
  solid->vertex[solid->vertices] =
      (sg_solid_vertex){{x, y, z}, 1, (int32_t)solid->vertices + 1};
  solid->plain = ++solid->vertices;
  return (uint32_t)solid->vertices - 1;
}

/* The face gets its triangles with add_triangle(). */
static inline void
add_face(sg_solid *solid, int32_t s, int32_t p)
{
  solid->face = enough(solid->face, solid->faces, sizeof *solid->face);
  solid->face[solid->faces++] =
      (sg_solid_face){s, p, false, (uint32_t)solid->triangles, 0};
}

static inline void
add_triangle(sg_solid *solid, uint32_t a, uint32_t b, uint32_t c)
{
  solid->auxiliary =
      enough(solid->auxiliary, solid->triangles, sizeof *solid->auxiliary);
  solid->triangle =
      enough(solid->triangle, solid->triangles, sizeof *solid->triangle);
  solid->auxiliary[solid->triangles] = 0;
  uint32_t *corner = solid->triangle[solid->triangles++];
  corner[0] = a;
  corner[1] = b;
  corner[2] = c;
  solid->face[solid->faces - 1].n++;
}

static inline sg_solid
copy_of(const sg_solid *from)
{
  sg_solid out = {.vertices = from->vertices,
                  .plain = from->plain,
                  .triangles = from->triangles,
                  .faces = from->faces};
  out.vertex = malloc((from->vertices + 1) * sizeof *out.vertex);
  out.triangle = malloc((from->triangles + 1) * sizeof *out.triangle);
  out.auxiliary = malloc(from->triangles + 1);
  out.face = malloc((from->faces + 1) * sizeof *out.face);
  if (!out.vertex || !out.triangle || !out.auxiliary || !out.face) {
    abort();
  }
  memcpy(out.vertex, from->vertex, from->vertices * sizeof *out.vertex);
  memcpy(out.triangle, from->triangle, from->triangles * sizeof *out.triangle);
  memcpy(out.auxiliary, from->auxiliary, from->triangles);
  memcpy(out.face, from->face, from->faces * sizeof *out.face);
  return out;
}

static inline bool
same_faces(const sg_solid *a, const sg_solid *b)
{
  for (size_t i = 0; i < a->faces; i++) {
    const sg_solid_face *f = &a->face[i], *g = &b->face[i];
    if (f->s != g->s || f->p != g->p || f->reversed != g->reversed ||
        f->first != g->first || f->n != g->n) {
      return false;
    }
  }
  return true;
}

static inline bool
same_solid(const sg_solid *a, const sg_solid *b)
{
  return a->vertices == b->vertices && a->plain == b->plain &&
         a->triangles == b->triangles && a->faces == b->faces &&
         a->parts == b->parts &&
         memcmp(a->vertex, b->vertex, a->vertices * sizeof *a->vertex) == 0 &&
         memcmp(a->triangle, b->triangle, a->triangles * sizeof *a->triangle) ==
             0 &&
         memcmp(a->auxiliary, b->auxiliary, a->triangles) == 0 &&
         same_faces(a, b);
}

/* ---- lumps -------------------------------------------------------------- */

typedef struct cube_lump {
  bool cell[SIDE][SIDE][SIDE]; /* x, y, z */
} cube_lump;

/* A unit square: normal along axis k, to the side of `up`, least corner at. */
typedef struct square {
  int k, up, at[3];
} square;

static inline bool
is_full(const cube_lump *lump, const int at[3])
{
  for (int k = 0; k < 3; k++) {
    if (at[k] < 0 || at[k] >= SIDE) {
      return false;
    }
  }
  return lump->cell[at[0]][at[1]][at[2]];
}

static inline void
fill_box(cube_lump *lump, int x0, int y0, int z0, int x1, int y1, int z1)
{
  for (int x = x0; x < x1; x++) {
    for (int y = y0; y < y1; y++) {
      for (int z = z0; z < z1; z++) {
        lump->cell[x][y][z] = true;
      }
    }
  }
}

/* The squares of the surface; returns how many. out[6 * SIDE^3] */
static inline int
lump_squares(const cube_lump *lump, square *out)
{
  int n = 0;

  for (int i = 0; i < SIDE * SIDE * SIDE; i++) {
    int at[3] = {i / SIDE / SIDE, i / SIDE % SIDE, i % SIDE};
    for (int side = 0; is_full(lump, at) && side < 6; side++) {
      int k = side / 2, up = side % 2;
      int next[3] = {at[0], at[1], at[2]};
      next[k] += up ? 1 : -1;
      if (!is_full(lump, next)) {
        out[n] = (square){k, up, {at[0], at[1], at[2]}};
        out[n++].at[k] += up;
      }
    }
  }
  return n;
}

static inline int
node_of(const int at[3])
{
  return (at[0] * (SIDE + 1) + at[1]) * (SIDE + 1) + at[2];
}

/* Its corners, counter-clockwise from outside. */
static inline void
square_nodes(const square *sq, int out[4])
{
  static const int step[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

  for (int i = 0; i < 4; i++) {
    int j = sq->up ? i : 3 - i;
    int at[3] = {sq->at[0], sq->at[1], sq->at[2]};
    at[(sq->k + 1) % 3] += step[j][0];
    at[(sq->k + 2) % 3] += step[j][1];
    out[i] = node_of(at);
  }
}

/* How a lump is made a solid. */
typedef enum grouping {
  EACH_TRIANGLE, /* is a face */
  EACH_SQUARE,
  BY_CHANCE /* squares or triangles */
} grouping;

static inline uint32_t
vertex_at(sg_solid *solid, uint32_t number[NODES], int node)
{
  if (number[node] == UINT32_MAX) {
    number[node] =
        add_vertex(solid, node / (SIDE + 1) / (SIDE + 1),
                   node / (SIDE + 1) % (SIDE + 1), node % (SIDE + 1));
  }
  return number[node];
}

/* Face i is a part of polygon i + 1 of segment 1. */
static inline sg_solid
lump_solid(const cube_lump *lump, grouping how)
{
  static square sq[6 * SIDE * SIDE * SIDE];
  static uint32_t number[NODES];
  sg_solid solid = {0};
  int n = lump_squares(lump, sq);

  memset(number, 0xff, sizeof number);
  for (int i = 0; i < n; i++) {
    int node[4], turn = how == BY_CHANCE ? pick(2) : 0;
    uint32_t v[4];
    bool two = how == EACH_TRIANGLE || (how == BY_CHANCE && pick(2));
    square_nodes(&sq[i], node);
    for (int k = 0; k < 4; k++) {
      v[k] = vertex_at(&solid, number, node[(k + turn) % 4]);
    }
    add_face(&solid, 1, (int32_t)solid.faces + 1);
    add_triangle(&solid, v[0], v[1], v[2]);
    if (two) {
      add_face(&solid, 1, (int32_t)solid.faces + 1);
    }
    add_triangle(&solid, v[0], v[2], v[3]);
  }
  return solid;
}

/* ---- what is counted independently -------------------------------------- */

typedef struct feature_counts {
  size_t faces, vertices, edges;
} feature_counts;

/* Squares at an edge between two nodes: up to 4. */
typedef struct unit_edge {
  int n, square[4];
} unit_edge;

static inline int
root_of(int *up, int i)
{
  while (up[i] != i) {
    i = up[i] = up[up[i]];
  }
  return i;
}

/* Two squares on an edge that make it vanish. */
static inline bool
is_smooth(const unit_edge *edge, const square *sq)
{
  const square *a = &sq[edge->square[0]], *b = &sq[edge->square[1]];

  return edge->n == 2 && a->k == b->k && a->up == b->up;
}

/* The squares of a lump, and those at each edge from a node along an axis. */
typedef struct unit_edges {
  square square[6 * SIDE * SIDE * SIDE];
  int up[6 * SIDE * SIDE * SIDE]; /* the squares of one face */
  int n;
  unit_edge edge[NODES][3];
} unit_edges;

static const int stride[3] = {(SIDE + 1) * (SIDE + 1), SIDE + 1, 1};

static inline void
find_edges(const cube_lump *lump, unit_edges *all)
{
  memset(all, 0, sizeof *all);
  all->n = lump_squares(lump, all->square);
  for (int i = 0; i < all->n; i++) {
    int node[4];
    all->up[i] = i;
    square_nodes(&all->square[i], node);
    for (int c = 0; c < 4; c++) {
      int a = node[c], b = node[(c + 1) % 4], k = 0;
      while (abs(a - b) != stride[k]) {
        k++;
      }
      unit_edge *edge = &all->edge[a < b ? a : b][k];
      edge->square[edge->n++] = i;
    }
  }
}

/* What the edges at a node tell: whether it is a vertex, how many of the edges
 * from here on are some. */
static inline void
count_node(unit_edges *all, int i, feature_counts *out)
{
  const unit_edge none = {0};
  int real = 0;
  bool straight = false;

  for (int k = 0; k < 3; k++) {
    const unit_edge *ahead = &all->edge[i][k];
    const unit_edge *behind =
        i >= stride[k] ? &all->edge[i - stride[k]][k] : &none;
    bool smooth = is_smooth(ahead, all->square);
    int on = ahead->n && !smooth;
    int back = behind->n && !is_smooth(behind, all->square);
    if (smooth) {
      all->up[root_of(all->up, ahead->square[0])] =
          root_of(all->up, ahead->square[1]);
    }
    straight = straight || (on && back);
    real += on + back;
    out->edges += (size_t)on;
  }
  straight = straight && real == 2;
  out->vertices += real > 0 && !straight;
  out->edges -= straight;
}

/* By flood over squares and by looking at the edges at each node. */
static inline feature_counts
lump_counts(const cube_lump *lump)
{
  static unit_edges all;
  feature_counts out = {0, 0, 0};

  find_edges(lump, &all);
  for (int i = 0; i < NODES; i++) {
    count_node(&all, i, &out);
  }
  for (int i = 0; i < all.n; i++) {
    out.faces += root_of(all.up, i) == i;
  }
  return out;
}

/* ---- what a solid has --------------------------------------------------- */

typedef struct half_row {
  uint32_t low, high, way, face;
} half_row;

static inline int
compare_half_rows(const void *a, const void *b)
{
  return memcmp(a, b, sizeof(half_row)); /* equal edges stand together */
}

/* Its half-edges, the same edge's together. Owner: caller. */
static inline half_row *
half_rows(const sg_solid *solid)
{
  half_row *row = malloc((3 * solid->triangles + 1) * sizeof *row);
  size_t n = 0;

  for (uint32_t f = 0; row && f < solid->faces; f++) {
    const sg_solid_face *face = &solid->face[f];
    for (uint32_t t = face->first; t < face->first + face->n; t++) {
      for (int k = 0; k < 3; k++) {
        uint32_t a = solid->triangle[t][k], b = solid->triangle[t][(k + 1) % 3];
        row[n++] = (half_row){a < b ? a : b, a < b ? b : a, a < b, f};
      }
    }
  }
  if (!row || n != 3 * solid->triangles) {
    abort();
  }
  qsort(row, n, sizeof *row, compare_half_rows);
  return row;
}

/* As many half-edges one way as the other, at each edge. */
static inline bool
is_closed(const sg_solid *solid)
{
  half_row *row = half_rows(solid);
  size_t n = 3 * solid->triangles;
  bool closed = true;

  for (size_t i = 0, j; i < n; i = j) {
    long balance = 0;
    for (j = i; j < n && row[j].low == row[i].low && row[j].high == row[i].high;
         j++) {
      balance += row[j].way ? 1 : -1;
    }
    closed = closed && balance == 0 && row[i].low != row[i].high;
  }
  free(row);
  return closed;
}

/* Rows from..to are of one edge, and one face has it more often one way than
 * the other: it is not just a chord. */
static inline bool
is_edge(const half_row *row, size_t from, size_t to)
{
  for (size_t i = from; i < to; i++) {
    int balance = 0;
    for (size_t j = from; j < to; j++) {
      balance += row[j].face == row[i].face ? (row[j].way ? 1 : -1) : 0;
    }
    if (balance != 0) {
      return true;
    }
  }
  return false;
}

/* Edges are those that are no chords. Vertices on no edge are counted in
 * *loose. */
static inline feature_counts
solid_counts(const sg_solid *solid, size_t *loose)
{
  half_row *row = half_rows(solid);
  size_t n = 3 * solid->triangles;
  bool *on_edge = calloc(solid->vertices + 1, sizeof *on_edge);
  feature_counts out = {solid->faces, solid->vertices, 0};

  if (!on_edge) {
    abort();
  }
  for (size_t i = 0, j; i < n; i = j) {
    for (j = i;
         j < n && row[j].low == row[i].low && row[j].high == row[i].high;) {
      j++;
    }
    if (is_edge(row, i, j)) {
      out.edges++;
      on_edge[row[i].low] = on_edge[row[i].high] = true;
    }
  }
  *loose = 0;
  for (size_t v = 0; v < solid->vertices; v++) {
    *loose += !on_edge[v];
  }
  free(on_edge);
  free(row);
  return out;
}

/* Volume and area. */
static inline void
measure(const sg_solid *solid, double *volume, double *area)
{
  *volume = *area = 0;
  for (size_t t = 0; t < solid->triangles; t++) {
    const double *p[3];
    double u[3], v[3], n[3];
    for (int k = 0; k < 3; k++) {
      p[k] = solid->vertex[solid->triangle[t][k]].at;
    }
    for (int k = 0; k < 3; k++) {
      u[k] = p[1][k] - p[0][k];
      v[k] = p[2][k] - p[0][k];
    }
    for (int k = 0; k < 3; k++) {
      n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
      *volume += (p[0][k] - solid->vertex[0].at[k]) * n[k] / 6;
    }
    *area += sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
  }
}

/* ---- placing ------------------------------------------------------------ */

/* Turns by a random rotation and shifts by up to `far`. */
static inline void
place_at_random(sg_solid *solid, double far)
{
  double q[4], length = 0, shift[3], r[3][3];

  do {
    length = 0;
    for (int i = 0; i < 4; i++) {
      q[i] = random_in(-1, 1);
      length += q[i] * q[i];
    }
  } while (length > 1 || length < 0.01);
  for (int i = 0; i < 4; i++) {
    q[i] /= sqrt(length);
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    r[i][i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]);
    r[i][j] = 2 * (q[i] * q[j] - q[k] * q[3]);
    r[i][k] = 2 * (q[i] * q[k] + q[j] * q[3]);
    shift[i] = random_in(-far, far);
  }
  for (size_t v = 0; v < solid->vertices; v++) {
    double *at = solid->vertex[v].at, p[3] = {at[0], at[1], at[2]};
    for (int i = 0; i < 3; i++) {
      at[i] = shift[i] + r[i][0] * p[0] + r[i][1] * p[1] + r[i][2] * p[2];
    }
  }
}

/* Moves each vertex by up to `most`. */
static inline void
shake(sg_solid *solid, double most)
{
  for (size_t v = 0; v < solid->vertices; v++) {
    double by[3], length;
    do {
      length = 0;
      for (int k = 0; k < 3; k++) {
        by[k] = random_in(-1, 1);
        length += by[k] * by[k];
      }
    } while (length > 1);
    for (int k = 0; k < 3; k++) {
      solid->vertex[v].at[k] += most * by[k];
    }
  }
}

#endif
