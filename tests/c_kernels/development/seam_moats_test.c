/* seam_moats_test.c -- moats on graphs by hand. */
#include "tests/check.h"

#include "development/seam_moats.h"

#include <math.h>

enum { MOST = 8 };

static bool
stop(void *data)
{
  return --*(int *)data < 0;
}

/* The width of all moats along a path of n + 1 vertices; NAN: it did not end
 * after many meetings. */
static double
width_along(size_t n, const double *length, double *bent)
{
  bool border[MOST + 1] = {false};
  sg_joint joint[MOST];
  int asks = 3;
  double width = NAN;
  bool stopped;

  for (size_t i = 0; i < n; i++) {
    joint[i] =
        (sg_joint){.vertex = {(int32_t)i, (int32_t)i + 1}, .length = length[i]};
  }
  sg_bent_vertices of = {n + 1, bent, border};
  sg_joints joints = {.n = n, .joint = joint};
  bool good = sg_moats_grow(&of, &joints, true, &(sg_cancel){stop, &asks},
                            &width, &stopped);

  return good ? width : NAN;
}

/* Two moats fill the way between two vertices that balance. */
static void
check_pair(void)
{
  double turn = 2 * acos(-1.0), bent[2] = {turn, turn}, length[1] = {3};

  CHECK("all of the way", fabs(width_along(1, length, bent) - 3) < 1e-9);
  bent[1] = 0;
  CHECK("but one, which never ends, has no more to meet",
        fabs(width_along(1, length, bent) - 3) < 1e-9);
}

/* A short joint between vertices that are flat is met when a moat that has
 * grown for long comes there. */
static void
check_late_meetings(void)
{
  double turn = acos(-1.0);
  unsigned wrong = 0;

  for (int i = 1; i <= 1000; i++) {
    double length[4] = {1000.0 + 0.1 * i, 1e-7 * i, 1e-9 * i, 1000.0 / i};
    double bent[5] = {turn, 0, 0, 0, 3 * turn};
    double way = length[0] + length[1] + length[2] + length[3];

    wrong += !(fabs(width_along(4, length, bent) - way) < 1e-9 * way);
  }
  CHECK("the whole way is filled", wrong == 0);
}

/* ---- a slow way --------------------------------------------------------- */

enum { VERTICES = 9, EDGES = 16 };

typedef struct graph {
  double bent[VERTICES], length[EDGES];
  bool border[VERTICES];
  int end[EDGES][2];
} graph;

static uint64_t seed = 7;

static double
random_below(double most)
{
  seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return most * (double)(seed >> 33) / 2147483648.0;
}

/* Bends are quarters of turns, so that sets often balance. */
static void
make_graph(graph *g)
{
  for (int v = 0; v < VERTICES; v++) {
    g->bent[v] = acos(-1.0) / 2 * floor(random_below(9) - 4);
    g->border[v] = random_below(1) < 0.15;
  }
  for (int e = 0; e < EDGES; e++) {
    g->length[e] = 0.1 + random_below(5);
    g->end[e][0] = (int)random_below(VERTICES);
    g->end[e][1] = (int)random_below(VERTICES);
  }
}

/* Which of the sets grow; a set is the vertices v with set[v] == its number. */
static void
find_growing(const graph *g, const int *set, bool *grows)
{
  for (int s = 0; s < VERTICES; s++) {
    double sum = 0;
    bool border = false, there = false;

    for (int v = 0; v < VERTICES; v++) {
      sum += set[v] == s ? g->bent[v] : 0;
      border |= set[v] == s && g->border[v];
      there |= set[v] == s;
    }
    grows[s] = there && !border && !sg_bends_balance(sum);
  }
}

/* The next edge whose moats meet, and when; -1: none ever will. */
static int
next_meeting(const graph *g, const int *set, const bool *grows,
             const double *reach, double *wait)
{
  int next = -1;

  for (int e = 0; e < EDGES; e++) {
    int a = g->end[e][0], b = g->end[e][1];
    int speed = grows[set[a]] + grows[set[b]];

    if (set[a] != set[b] && speed > 0) {
      double t = fmax(0, g->length[e] - reach[a] - reach[b]) / speed;
      if (next < 0 || t < *wait) {
        next = e;
        *wait = t;
      }
    }
  }
  return next;
}

/* The sum of the widths, meeting by meeting; sets that nothing meets any more
 * do not count, as in sg_moats_grow(): what grows on is not bounded. */
static double
slow_width(const graph *g)
{
  int set[VERTICES];
  bool grows[VERTICES];
  double reach[VERTICES] = {0}, width[VERTICES] = {0}, sum = 0, wait = 0;

  for (int v = 0; v < VERTICES; v++) {
    set[v] = v;
  }
  for (int e;;) {
    find_growing(g, set, grows);
    e = next_meeting(g, set, grows, reach, &wait);
    if (e < 0) {
      break;
    }
    for (int v = 0; v < VERTICES; v++) {
      reach[v] += grows[set[v]] ? wait : 0;
      width[v] += grows[v] ? wait : 0;
    }
    int from = set[g->end[e][0]], to = set[g->end[e][1]];

    sum += width[from] + width[to];
    width[from] = width[to] = 0;
    for (int v = 0; v < VERTICES; v++) {
      set[v] = set[v] == from ? to : set[v];
    }
  }
  return sum;
}

static double
fast_width(graph *g, bool on)
{
  sg_joint joint[EDGES];
  double width = NAN;
  bool stopped;

  for (int e = 0; e < EDGES; e++) {
    joint[e] = (sg_joint){.vertex = {g->end[e][0], g->end[e][1]},
                          .length = g->length[e]};
  }
  sg_bent_vertices of = {VERTICES, g->bent, g->border};
  sg_joints joints = {.n = EDGES, .joint = joint};

  CHECK("grown", sg_moats_grow(&of, &joints, on, NULL, &width, &stopped));
  return width;
}

static void
check_random(void)
{
  unsigned wrong = 0;
  graph g;

  for (int i = 0; i < 2000; i++) {
    make_graph(&g);
    double slow = slow_width(&g), fast = fast_width(&g, true);
    wrong += !(fabs(slow - fast) <= 1e-9 * (1 + slow));
  }
  CHECK("as wide as meeting by meeting", wrong == 0);
}

/* Half of the shortest edge, where a vertex alone does not balance. */
static void
check_alone(void)
{
  graph g = {.bent = {1, 1, 1, 0}, .border = {false, false, true}};

  for (int e = 0; e < EDGES; e++) {
    g.length[e] = 10 - 0.5 * (e / 4);
    g.end[e][0] = e % 4;
    g.end[e][1] = e % 4;
  }
  CHECK("half as wide", fabs(fast_width(&g, false) - 2 * 8.5 / 2) < 1e-9);
}

static void
check_balance(void)
{
  double turns = 4 * acos(-1.0);

  CHECK("flat", sg_bends_balance(0));
  CHECK("a closed shell", sg_bends_balance(turns));
  CHECK("three whole turns round a vertex", sg_bends_balance(-turns));
  CHECK("a cone", !sg_bends_balance(turns / 3));
  CHECK("two whole turns less", !sg_bends_balance(turns / 2));
}

int
main(void)
{
  check_pair();
  check_late_meetings();
  check_random();
  check_alone();
  check_balance();
  return check_report();
}
