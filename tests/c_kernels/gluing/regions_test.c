/* regions_test.c -- random closed parts of a grid of cubes against counting the
 * grid: squares turned at random, wires and lone vertices, as they are and
 * under random rotations.
 *
 * The oracle fills the grid between the cells with small cubes: what is filled
 * are parts, what is not are regions, and squares between the two are shells.
 * It shares nothing with the kernel.
 *
 * covers: pages, sphere_map
 */
#include "gluing/regions.h"

#include "tests/check.h"
#include "tests/memory/refuse.h"
#include "tests/stop_later.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 3, SIDE = 2 * MOST + 3, CUBES = SIDE * SIDE * SIDE };

static uint32_t seed = 20;

static double
chance(void)
{
  seed ^= seed << 13;
  seed ^= seed >> 17;
  seed ^= seed << 5;
  return seed / 0x1p32;
}

/* ---- the grid: cell (x, y, z) of 2n + 1 along each axis, one all round ----
 */

static int n, side;
static bool filled[CUBES];

static int
at(int x, int y, int z)
{
  return ((x + 1) * side + y + 1) * side + z + 1;
}

static int
odd(const int c[3])
{
  return c[0] % 2 + c[1] % 2 + c[2] % 2;
}

static void
fill(const int c[3])
{
  filled[at(c[0], c[1], c[2])] = true;
  for (int k = 0; k < 3; k++) {
    for (int by = -1; c[k] % 2 && by <= 1; by += 2) {
      int b[3] = {c[0], c[1], c[2]};
      b[k] += by;
      fill(b);
    }
  }
}

static void
choose(void)
{
  double of[3] = {chance() * 0.3, chance() * 0.3, pow(chance(), 1.5)};

  n = 1 + (int)(chance() * MOST);
  side = 2 * n + 3;
  memset(filled, 0, sizeof filled);
  for (int x = 0; x <= 2 * n; x++) {
    for (int y = 0; y <= 2 * n; y++) {
      for (int z = 0; z <= 2 * n; z++) {
        int c[3] = {x, y, z}, d = odd(c);
        if (d < 3 && chance() < of[d]) {
          fill(c);
        }
      }
    }
  }
}

/* ---- the oracle ---- */

typedef struct counts {
  size_t v, e, f, c, r, s;
  long g;
  bool manifold; /* the squares are a surface, so that s and g are good */
} counts;

static int set[6 * CUBES];

static int
root(int i)
{
  while (set[i] != i) {
    i = set[i] = set[set[i]];
  }
  return i;
}

static int
classes(int size, bool (*in)(int i))
{
  int count = 0;

  for (int i = 0; i < size; i++) {
    count += in(i) && root(i) == i;
  }
  return count;
}

static bool
is_full(int i)
{
  return filled[i];
}

static bool
is_empty(int i)
{
  return !filled[i];
}

/* Square k of cube i is between what is full and what is not. */
static int steps[3];

static bool
is_square(int q)
{
  int i = q / 6, by = q % 2 ? steps[q % 6 / 2] : -steps[q % 6 / 2];

  return filled[i] && i + by >= 0 && i + by < side * side * side &&
         !filled[i + by];
}

static void
join_cubes(void)
{
  for (int i = 0; i < side * side * side; i++) {
    set[i] = i;
  }
  for (int x = 0; x < side; x++) {
    for (int y = 0; y < side; y++) {
      for (int z = 0; z < side; z++) {
        int i = (x * side + y) * side + z;
        const int more[3] = {x + 1 < side, y + 1 < side, z + 1 < side};
        for (int k = 0; k < 3; k++) {
          if (more[k] && filled[i] == filled[i + steps[k]]) {
            set[root(i)] = root(i + steps[k]);
          }
        }
      }
    }
  }
}

/* The edges of small cubes: by their lower end and axis. */
typedef struct border {
  int count, one, two;
} border;

static border edge[3][(SIDE + 1) * (SIDE + 1) * (SIDE + 1)];
static int corner_seen[(SIDE + 1) * (SIDE + 1) * (SIDE + 1)];

static int
point(const int p[3])
{
  return (p[0] * (side + 1) + p[1]) * (side + 1) + p[2];
}

static void
see_square(int q)
{
  int i = q / 6, axis = q % 6 / 2, u = (axis + 1) % 3, w = (axis + 2) % 3;
  int low[3] = {i / side / side, i / side % side, i % side};

  low[axis] += q % 2;
  for (int k = 0; k < 4; k++) {
    int p[3] = {low[0], low[1], low[2]}, along = k < 2 ? u : w;
    p[k < 2 ? w : u] += k % 2;
    border *b = &edge[along][point(p)];
    *(b->count++ ? &b->two : &b->one) = q;
  }
}

static void
join_squares(counts *out)
{
  int points = (side + 1) * (side + 1) * (side + 1);

  memset(edge, 0, sizeof edge);
  for (int q = 0; q < 6 * side * side * side; q++) {
    set[q] = q;
    if (is_square(q)) {
      see_square(q);
    }
  }
  out->manifold = true;
  for (int k = 0; k < 3; k++) {
    for (int p = 0; p < points; p++) {
      const border *b = &edge[k][p];
      out->manifold = out->manifold && (b->count == 0 || b->count == 2);
      if (b->count == 2) {
        set[root(b->one)] = root(b->two);
      }
    }
  }
}

/* Corners, edges and squares of each shell: 2 - 2g in all. A corner counts for
 * each shell that has it. */
static long
sum_of_euler(void)
{
  static const int no = -1;
  long sum = 0;
  int points = (side + 1) * (side + 1) * (side + 1);

  for (int s = 0; s < 6 * side * side * side; s++) {
    if (!is_square(s) || root(s) != s) {
      continue;
    }
    memset(corner_seen, no, sizeof corner_seen);
    for (int k = 0; k < 3; k++) {
      for (int p = 0; p < points; p++) {
        const border *b = &edge[k][p];
        int step = k == 0 ? (side + 1) * (side + 1) : k == 1 ? side + 1 : 1;
        if (b->count == 2 && root(b->one) == s) {
          sum -= 1;
          sum += (corner_seen[p] != s) + (corner_seen[p + step] != s);
          corner_seen[p] = corner_seen[p + step] = s;
        }
      }
    }
    for (int q = 0; q < 6 * side * side * side; q++) {
      sum += is_square(q) && root(q) == s;
    }
  }
  return sum;
}

static counts
count_grid(void)
{
  counts out = {0};
  int all = side * side * side;

  steps[0] = side * side;
  steps[1] = side;
  steps[2] = 1;
  for (int i = 0; i < all; i++) {
    int c[3] = {i / side / side - 1, i / side % side - 1, i % side - 1};
    if (filled[i]) {
      size_t *to[] = {&out.v, &out.e, &out.f};
      ++*to[odd(c)];
    }
  }
  join_cubes();
  out.c = (size_t)classes(all, is_full);
  out.r = (size_t)classes(all, is_empty);
  join_squares(&out);
  out.s = (size_t)classes(6 * all, is_square);
  out.g = out.manifold ? (2 * (long)out.s - sum_of_euler()) / 2 : 0;
  return out;
}

/* ---- the same as a segment ---- */

static int32_t vertex_of[CUBES];
static double place[CUBES][3], turned[3][3];
static int32_t id[6 * CUBES], from[6 * CUBES], to[6 * CUBES], list[6 * CUBES];
static int32_t corner[2 * CUBES][3], polygon_of[2 * CUBES];
static unsigned char real[6 * CUBES];
static uint32_t list_begin[CUBES + 1], ends[4][2];
/* The cell of each, and whether a square looks down its axis. */
static int cell_of_vertex[CUBES][3], cell_of_edge[6 * CUBES][3];
static int cell_of_square[CUBES][3];
static bool looks_down[CUBES];
static int32_t segment = 1;
static double grain;

static void
turn_round(bool any)
{
  double q[4], length = 0;

  for (int k = 0; k < 4; k++) {
    q[k] = any ? chance() - 0.5 : k == 0;
    length += q[k] * q[k];
  }
  for (int i = 0; i < 3; i++) {
    int u = (i + 1) % 3, w = (i + 2) % 3;
    double x = q[i + 1], y = q[u + 1], z = q[w + 1];
    turned[i][i] = 1 - 2 * (y * y + z * z) / length;
    turned[i][u] = 2 * (x * y - z * q[0]) / length;
    turned[i][w] = 2 * (x * z + y * q[0]) / length;
  }
}

static int32_t
put_vertex(size_t *count, const int c[3])
{
  int32_t *v = &vertex_of[at(c[0], c[1], c[2])];

  if (*v < 0) {
    *v = (int32_t)(*count)++;
    memcpy(cell_of_vertex[*v], c, sizeof cell_of_vertex[*v]);
    for (int k = 0; k < 3; k++) {
      place[*v][k] = turned[k][0] * c[0] / 2 + turned[k][1] * c[1] / 2 +
                     turned[k][2] * c[2] / 2;
    }
  }
  return *v;
}

static int32_t
put_edge(sg_dense *d, int32_t a, int32_t b)
{
  from[d->edges] = a;
  to[d->edges] = b;
  return (int32_t)d->edges++;
}

static void
put_square(sg_dense *d, const int c[3])
{
  int axis = c[0] % 2 == 0 ? 0 : c[1] % 2 == 0 ? 1 : 2;
  int u = (axis + 1) % 3, w = (axis + 2) % 3, start = (int)(chance() * 4);
  bool back = chance() < 0.5;
  int32_t v[4];

  memcpy(cell_of_square[d->polygons], c, sizeof cell_of_square[0]);
  looks_down[d->polygons] = back;
  for (int k = 0; k < 4; k++) {
    int i = ((back ? 4 - k : k) + start) % 4, p[3] = {c[0], c[1], c[2]};
    p[u] += i == 1 || i == 2 ? 1 : -1;
    p[w] += i >= 2 ? 1 : -1;
    v[k] = put_vertex(&d->vertices, p);
  }
  for (int k = 0; k < 4; k++) {
    list[list_begin[d->polygons] + (uint32_t)k] =
        put_edge(d, v[k], v[(k + 1) % 4]);
  }
  for (int k = 0; k < 2; k++) {
    memcpy(corner[d->triangles], ((int32_t[3]){v[0], v[1 + k], v[2 + k]}),
           sizeof corner[0]);
    polygon_of[d->triangles++] = (int32_t)d->polygons;
  }
  d->polygons++;
  list_begin[d->polygons] = list_begin[d->polygons - 1] + 4;
}

static void
put_cell(sg_dense *d, const int c[3])
{
  int axis = c[0] % 2 ? 0 : c[1] % 2 ? 1 : 2;
  int a[3] = {c[0], c[1], c[2]}, b[3] = {c[0], c[1], c[2]};

  if (odd(c) == 2) {
    put_square(d, c);
  } else if (odd(c) == 1) { /* a wire, or an edge of squares once more */
    a[axis]--;
    b[axis]++;
    memcpy(cell_of_edge[d->edges], c, sizeof cell_of_edge[0]);
    put_edge(d, put_vertex(&d->vertices, a), put_vertex(&d->vertices, b));
  } else {
    put_vertex(&d->vertices, c);
  }
}

static sg_dense
make_segment(bool any)
{
  sg_dense d = {.segments = 1,
                .segment = &segment,
                .grain = &grain,
                .vertex_id = id,
                .at = place,
                .edge_id = id,
                .from = from,
                .to = to,
                .real = real,
                .polygon_id = id,
                .list_begin = list_begin,
                .list = list,
                .triangle_id = id,
                .polygon_of = polygon_of,
                .corner = corner};

  turn_round(any);
  memset(vertex_of, -1, sizeof vertex_of);
  for (int i = 0; i < side * side * side; i++) {
    int c[3] = {i / side / side - 1, i / side % side - 1, i % side - 1};
    if (filled[i]) {
      put_cell(&d, c);
    }
  }
  d.vertex_begin = ends[0];
  d.edge_begin = ends[1];
  d.polygon_begin = ends[2];
  d.triangle_begin = ends[3];
  ends[0][1] = (uint32_t)d.vertices;
  ends[1][1] = (uint32_t)d.edges;
  ends[2][1] = (uint32_t)d.polygons;
  ends[3][1] = (uint32_t)d.triangles;
  return d;
}

/* ---- the two ---- */

static bool
stop(void *data)
{
  (void)data;
  return true;
}

static double
volume_of(const sg_regions *r)
{
  double sum = 0;

  for (size_t i = 0; i < r->regions; i++) {
    sum += r->region[i].volume;
  }
  return sum;
}

/* ---- which region is where: classes of cells that are not filled ---- */

static int class_of_region[CUBES];

/* The class beside a cell, one step along each axis that it is no middle of;
 * `sign` is that of the steps. */
static int
class_beside(const int c[3], int sign)
{
  int b[3];

  for (int k = 0; k < 3; k++) {
    b[k] = c[k] % 2 ? c[k] : c[k] + sign;
  }
  return root(at(b[0], b[1], b[2]));
}

/* One class for each region and one region for each class. */
static bool
is_class(const sg_regions *r, uint32_t region, int class)
{
  if (region >= r->regions) {
    return false;
  }
  for (size_t i = 0; i < r->regions; i++) {
    if ((class_of_region[i] == class) != (i == region) &&
        class_of_region[i] >= 0 &&
        (i == region || class_of_region[i] == class)) {
      return false;
    }
  }
  class_of_region[region] = class;
  return true;
}

/* What the list of a region says of its size, against cubes and sides. */
static bool
is_sized(const sg_regions *r, size_t region, size_t faces, size_t sides)
{
  const sg_space_region *of = &r->region[region];
  size_t cubes = 0;

  for (int i = 0; i < side * side * side; i++) {
    int c[3] = {i / side / side - 1, i / side % side - 1, i % side - 1};
    cubes += c[0] % 2 && c[1] % 2 && c[2] % 2 && c[0] > 0 && c[1] > 0 &&
             c[2] > 0 && c[0] < 2 * n && c[1] < 2 * n && c[2] < 2 * n &&
             root(i) == class_of_region[region];
  }
  bool bounded = region + 1 < r->regions;

  return of->faces == faces &&
         (of->role == SG_REGION_OUTSIDE) == (region + 1 == r->regions) &&
         fabs(of->volume - (bounded ? (double)cubes : 0)) < 1e-9 &&
         fabs(of->area - (double)sides) < 1e-9;
}

static bool
regions_are_sized(const sg_dense *d, const sg_regions *r)
{
  bool good = true;

  for (size_t i = 0; i < r->regions; i++) {
    size_t faces = 0, sides = 0, behind = 0;

    for (size_t p = 0; p < d->polygons; p++) {
      bool below = r->side[2 * p] == i, above = r->side[2 * p + 1] == i;
      faces += below || above;
      sides += (size_t)below + above;
      behind += below;
    }
    good =
        good && is_sized(r, i, faces, sides) && r->region[i].behind == behind;
  }
  return good;
}

/* Sides, wires and lone vertices are in the regions in which their cells are.
 */
static bool
regions_are_where(const sg_dense *d, const sg_regions *r)
{
  bool good = true;

  join_cubes();
  memset(class_of_region, -1, sizeof class_of_region);
  good = is_class(r, (uint32_t)r->regions - 1, root(at(-1, -1, -1)));
  for (size_t p = 0; p < d->polygons; p++) {
    for (int k = 0; k < 2; k++) { /* below, above */
      int up = (k == 1) != looks_down[p] ? 1 : -1;
      good = good && is_class(r, r->side[2 * p + (size_t)k],
                              class_beside(cell_of_square[p], up));
    }
  }
  for (size_t i = 0; i < r->wires; i++) {
    good = good && is_class(r, r->wire[i].region,
                            class_beside(cell_of_edge[r->wire[i].edge], 1));
  }
  for (size_t i = 0; i < r->lone; i++) {
    const sg_lone_vertex *one = &r->lone_vertex[i];
    good = good &&
           is_class(r, one->region, class_beside(cell_of_vertex[one->v], 1));
  }
  return good && regions_are_sized(d, r);
}

/* Each shell is in its region, and they come region by region. */
static bool
shells_are_where(const sg_regions *r)
{
  bool good = true;

  for (size_t i = 0; i < r->shells; i++) {
    const sg_region_shell *s = &r->shell[i];
    size_t p = (size_t)s->polygon;

    good = good && s->region < r->regions &&
           (i == 0 || r->shell[i - 1].region <= s->region) &&
           (s->polygon < 0 || r->side[2 * p] == s->region ||
            r->side[2 * p + 1] == s->region);
  }
  for (size_t i = 0; i < r->regions; i++) {
    size_t shells = 0, wires = 0, lone = 0;

    for (size_t k = 0; k < r->shells; k++) {
      shells += r->shell[k].region == i;
    }
    for (size_t k = 0; k < r->wires; k++) {
      wires += r->wire[k].region == i;
    }
    for (size_t k = 0; k < r->lone; k++) {
      lone += r->lone_vertex[k].region == i;
    }
    good = good && r->region[i].shells == shells &&
           r->region[i].wires == wires && r->region[i].lone == lone;
  }
  return good;
}

static bool
same_regions(const sg_regions *a, const sg_regions *b, size_t polygons)
{
  return a->regions == b->regions && a->shells == b->shells &&
         a->parts == b->parts && a->edges == b->edges && a->genus == b->genus &&
         a->wires == b->wires && a->lone == b->lone &&
         memcmp(a->side, b->side, 2 * polygons * sizeof *a->side) == 0;
}

/* Without memory, or stopped: the same regions, or none and why not. */
static bool
ends_well(const sg_dense *d, const sg_regions *with, const sg_cancel *cancel,
          sg_regions_end why)
{
  sg_regions r;
  size_t bad;
  sg_regions_end end = sg_regions_make(d, NULL, 0, NULL, cancel, &r, &bad);
  bool good = end == why ||
              (end == SG_REGIONS_DONE && same_regions(&r, with, d->polygons));

  sg_regions_clear(&r);
  return good;
}

static void
ends_otherwise(void)
{
  sg_dense d = make_segment(true);
  sg_regions r;
  size_t bad;

  CHECK("with memory",
        sg_regions_make(&d, NULL, 0, NULL, NULL, &r, &bad) == SG_REGIONS_DONE);
  CHECK_REFUSED("regions", ends_well(&d, &r, NULL, SG_REGIONS_NO_MEMORY));
  for (int k = 0, left = -1; left < 0; k++) {
    left = k;
    bool good =
        ends_well(&d, &r, &(sg_cancel){stop_later, &left}, SG_REGIONS_STOPPED);
    CHECK("stopped at a question", good);
  }
  sg_regions_clear(&r);
}

static void
compare(bool any)
{
  counts c = count_grid();
  sg_dense d = make_segment(any);
  sg_regions r;
  size_t bad;
  sg_regions_end end = sg_regions_make(&d, NULL, 0, NULL, NULL, &r, &bad);

  CHECK("regions are found", end == SG_REGIONS_DONE);
  CHECK("features", r.vertices == c.v && r.edges == c.e && r.faces == c.f &&
                        r.loops == c.f);
  CHECK("parts", r.parts == c.c);
  CHECK("regions", r.regions == c.r);
  CHECK("nothing doubtful", r.doubtful == 0 && r.twisted == 0);
  CHECK("shells", !c.manifold || r.shells == c.s);
  CHECK("genus", !c.manifold || r.genus == c.g);
  CHECK("first law",
        (int64_t)(r.vertices + 2 * r.faces) - (int64_t)(r.edges + r.loops) ==
            (int64_t)r.shells - r.genus);
  CHECK("second law", r.shells + 1 == r.parts + r.regions);
  CHECK("cells have the volume of cubes",
        fabs(volume_of(&r) - round(volume_of(&r))) < 1e-9);
  CHECK("regions are where cells are", regions_are_where(&d, &r));
  CHECK("shells are in them", shells_are_where(&r));
  sg_regions_clear(&r);
}

int
main(void)
{
  const char *cases = getenv("GLUING_CASES");
  int most = cases ? atoi(cases) : 400;
  static const sg_cancel now = {stop, NULL};
  sg_regions r;
  size_t bad;

  for (int i = 0; i < most; i++) {
    choose();
    compare(false);
    compare(true);
    if (i % 20 == 0) {
      ends_otherwise();
    }
  }
  sg_dense d = make_segment(false);
  CHECK("stopped", sg_regions_make(&d, NULL, 0, NULL, &now, &r, &bad) ==
                       SG_REGIONS_STOPPED);
  sg_regions_clear(&r);
  return check_report();
}
