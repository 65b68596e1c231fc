/* census_test.c -- random squares of a grid, their polygons and half-edges in
 * any order, counted by the census and by looking at the grid.
 */
#include "model/census.h"

#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <math.h>
#include <string.h>

enum { SIDE = 6, POINTS = (SIDE + 1) * (SIDE + 1), SQUARES = SIDE * SIDE };

static uint32_t seed;
static bool there[SIDE + 2][SIDE + 2]; /* squares from 1 on */
static int shell_of[SIDE + 2][SIDE + 2];

static struct {
  sg_dense d;
  double at[POINTS][3];
  int32_t id[4 * SQUARES], from[4 * SQUARES], to[4 * SQUARES],
      list[4 * SQUARES], polygon_of[2 * SQUARES], corner[2 * SQUARES][3];
  unsigned char real[4 * SQUARES];
  uint32_t list_begin[SQUARES + 1], vertex_begin[2], edge_begin[2],
      polygon_begin[2], triangle_begin[2];
  int square_of[SQUARES][2]; /* of each polygon */
} m;

static void
mix(int32_t *x, int n)
{
  for (int i = n; i > 1; i--) {
    int k = check_below(&seed, i);
    int32_t moved = x[i - 1];
    x[i - 1] = x[k];
    x[k] = moved;
  }
}

/* ---- the model ---- */

static int32_t
point_at(int x, int y)
{
  return y * (SIDE + 1) + x;
}

static void
put_square(int x, int y, const int32_t *edge, const int32_t *name)
{
  const int32_t v[4] = {name[point_at(x, y)], name[point_at(x + 1, y)],
                        name[point_at(x + 1, y + 1)], name[point_at(x, y + 1)]};
  size_t p = m.d.polygons++;
  int start = check_below(&seed, 4);

  for (int k = 0; k < 4; k++) {
    int32_t e = edge[4 * p + (size_t)k];
    m.from[e] = v[k];
    m.to[e] = v[(k + 1) % 4];
    m.list[4 * p + (size_t)((k + start) % 4)] = e;
  }
  m.list_begin[p + 1] = (uint32_t)(4 * p + 4);
  for (int t = 0; t < 2; t++) {
    int32_t *corner = m.corner[m.d.triangles];
    for (int k = 0; k < 3; k++) {
      corner[k] = v[(start + (k == 0 ? 0 : k + t)) % 4];
    }
    m.polygon_of[m.d.triangles++] = (int32_t)p;
  }
  m.square_of[p][0] = x;
  m.square_of[p][1] = y;
}

static void
open_model(void)
{
  static int32_t segment = 7;
  static double grain;
  int32_t edge[4 * SQUARES], name[POINTS], square[SQUARES], n = 0;

  memset(&m, 0, sizeof m);
  for (int32_t i = 0; i < SQUARES; i++) {
    square[i] = i;
    n += there[i % SIDE + 1][i / SIDE + 1];
  }
  for (int32_t i = 0; i < 4 * SQUARES; i++) {
    m.id[i] = i + 1;
    m.real[i] = 1;
    edge[i] = i;
  }
  for (int32_t i = 0; i < POINTS; i++) {
    name[i] = i;
  }
  mix(square, SQUARES);
  mix(edge, 4 * n);
  mix(name, POINTS);
  m.d = (sg_dense){.segments = 1,
                   .segment = &segment,
                   .grain = &grain,
                   .vertex_id = m.id,
                   .at = m.at,
                   .edge_id = m.id,
                   .from = m.from,
                   .to = m.to,
                   .real = m.real,
                   .polygon_id = m.id,
                   .list_begin = m.list_begin,
                   .list = m.list,
                   .triangle_id = m.id,
                   .polygon_of = m.polygon_of,
                   .corner = m.corner,
                   .vertex_begin = m.vertex_begin,
                   .edge_begin = m.edge_begin,
                   .polygon_begin = m.polygon_begin,
                   .triangle_begin = m.triangle_begin,
                   .vertices = POINTS};
  for (int32_t i = 0; i < POINTS; i++) {
    m.at[name[i]][0] = i % (SIDE + 1);
    m.at[name[i]][1] = i / (SIDE + 1);
  }
  for (int i = 0; i < SQUARES; i++) {
    int x = square[i] % SIDE, y = square[i] / SIDE;
    if (there[x + 1][y + 1]) {
      put_square(x, y, edge, name);
    }
  }
  m.d.edges = 4 * m.d.polygons;
  m.vertex_begin[1] = POINTS;
  m.edge_begin[1] = (uint32_t)m.d.edges;
  m.polygon_begin[1] = (uint32_t)m.d.polygons;
  m.triangle_begin[1] = (uint32_t)m.d.triangles;
}

/* ---- the grid ---- */

static void
spread(int x, int y, int shell)
{
  if (there[x][y] && shell_of[x][y] == 0) {
    shell_of[x][y] = shell;
    spread(x + 1, y, shell);
    spread(x - 1, y, shell);
    spread(x, y + 1, shell);
    spread(x, y - 1, shell);
  }
}

static bool
is_in(int x, int y, int shell)
{
  return there[x][y] && (shell == 0 || shell_of[x][y] == shell);
}

/* Of squares of a shell, or (0) of all. */
typedef struct grid_counts {
  size_t points, edges, borders, squares, pinched, unused;
} grid_counts;

/* How many fans the squares round a point are. */
static int
fans_at(int x, int y, int shell)
{
  const bool round[4] = {is_in(x, y, shell), is_in(x + 1, y, shell),
                         is_in(x + 1, y + 1, shell), is_in(x, y + 1, shell)};
  int begins = 0, all = 0;

  for (int k = 0; k < 4; k++) {
    begins += round[k] && !round[(k + 3) % 4];
    all += round[k];
  }
  return all == 4 ? 1 : begins;
}

static grid_counts
look_at_grid(int shell)
{
  grid_counts out = {0};

  for (int x = 0; x <= SIDE; x++) {
    for (int y = 0; y <= SIDE; y++) {
      bool up = is_in(x, y + 1, shell), here = is_in(x + 1, y + 1, shell),
           right = is_in(x + 1, y, shell);
      int fans = fans_at(x, y, shell);

      out.points += fans > 0;
      out.unused += fans == 0;
      out.pinched += fans > 1;
      out.squares += here;
      out.edges += (size_t)(up || here) + (here || right);
      out.borders += (size_t)(up != here) + (here != right);
    }
  }
  return out;
}

/* ---- the two ---- */

static bool
is_shell(const sg_shell *s, int shell)
{
  grid_counts of = look_at_grid(shell);
  bool pinched = false;

  for (int x = 0; x <= SIDE; x++) {
    for (int y = 0; y <= SIDE; y++) {
      pinched = pinched || (fans_at(x, y, shell) > 0 && fans_at(x, y, 0) > 1);
    }
  }
  return s->segment == 7 && s->vertices == of.points && s->edges == of.edges &&
         s->polygons == of.squares && !s->closed && s->pinched == pinched &&
         s->euler ==
             (int64_t)of.points - (int64_t)of.edges + (int64_t)of.squares &&
         fabs(s->area - (double)of.squares) < 1e-12;
}

static bool
are_shells(const sg_census *c, int shells)
{
  int32_t before = 0;
  bool good = c->shells == (size_t)shells;

  for (size_t i = 0; i < c->shells && good; i++) {
    const sg_shell *s = &c->shell[i];
    const int *at = m.square_of[s->polygon - 1];

    good = s->polygon > before && is_shell(s, shell_of[at[0] + 1][at[1] + 1]);
    for (int32_t p = 0; p < s->polygon - 1; p++) { /* it is the lowest */
      const int *other = m.square_of[p];
      good = good && shell_of[other[0] + 1][other[1] + 1] !=
                         shell_of[at[0] + 1][at[1] + 1];
    }
    before = s->polygon;
  }
  return good;
}

static bool
are_defects(const sg_census *c, const grid_counts *of)
{
  size_t number[SG_DEFECTS] = {0};
  bool good = true;

  for (size_t i = 0; i < c->defects; i++) {
    const sg_defect *d = &c->defect[i];

    number[d->kind]++;
    good =
        good && d->segment == 7 && (d->kind != SG_DEFECT_PINCHED || d->b == 2);
  }
  for (int k = 0; k < SG_DEFECTS; k++) {
    size_t wanted = k == SG_DEFECT_BORDER    ? of->borders
                    : k == SG_DEFECT_PINCHED ? of->pinched
                    : k == SG_DEFECT_UNUSED  ? of->unused
                                             : 0;
    good = good && number[k] == wanted && c->part[0].defects[k] == wanted;
  }
  return good;
}

static bool
is_counted(int shells, bool *done)
{
  grid_counts of = look_at_grid(0);
  sg_census c;
  bool stopped;

  *done = sg_census_make(&m.d, NULL, NULL, &c, &stopped);
  const sg_part *p = c.part;
  bool good =
      !*done || (c.parts == 1 && p->segment == 7 && p->vertices == POINTS &&
                 p->half_edges == m.d.edges && p->edges == of.edges &&
                 p->polygons == of.squares && p->triangles == 2 * of.squares &&
                 fabs(p->area - (double)of.squares) < 1e-12 &&
                 are_shells(&c, shells) && are_defects(&c, &of));

  sg_census_clear(&c);
  return good;
}

static int
draw(void)
{
  int odds = 1 + check_below(&seed, 9), shells = 0;

  memset(there, 0, sizeof there);
  memset(shell_of, 0, sizeof shell_of);
  for (int i = 0; i < SQUARES; i++) {
    there[i % SIDE + 1][i / SIDE + 1] = check_below(&seed, 10) < odds;
  }
  for (int i = 0; i < SQUARES; i++) {
    int x = i % SIDE + 1, y = i / SIDE + 1;
    if (there[x][y] && shell_of[x][y] == 0) {
      spread(x, y, ++shells);
    }
  }
  open_model();
  return shells;
}

int
main(void)
{
  size_t bad = 0;
  bool done;

  for (uint32_t round = 0; round < 3000; round++) {
    seed = round;
    int shells = draw();
    bad += !is_counted(shells, &done) || !done;
  }
  CHECK("the census is that of the grid", bad == 0);
  for (uint32_t round = 0; round < 20; round++) {
    seed = round;
    int shells = draw();
    CHECK_REFUSED("a census", is_counted(shells, &done));
    CHECK("with memory", done);
  }
  return check_report();
}
