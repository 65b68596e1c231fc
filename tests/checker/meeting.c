#include "meeting.h"

#include "sign.h"

static const int AXES[3][2] = {{1, 2}, {2, 0}, {0, 1}};

bool
has_no_area(const double *p[3])
{
  for (int k = 0; k < 3; k++) {
    if (sign_of_area(p[0], p[1], p[2], AXES[k][0], AXES[k][1]) != 0) {
      return false;
    }
  }
  return true;
}

/* - - - in one plane - - - */

/* A triangle seen along an axis, counter-clockwise. */
typedef struct flat {
  const double *at[3];
  bool shared[3];
  int x, y;
} flat;

static flat
flat_of(const double *p[3], int shared, int axis)
{
  flat f = {{p[0], p[1], p[2]},
            {shared > 0, shared > 1, shared > 2},
            AXES[axis][0],
            AXES[axis][1]};

  if (sign_of_area(p[0], p[1], p[2], f.x, f.y) < 0) {
    f.at[1] = p[2];
    f.at[2] = p[1];
    f.shared[1] = shared > 2;
    f.shared[2] = shared > 1;
  }
  return f;
}

/* The order of two places on the line of an edge from a to b. */
static int
order(const double *a, const double *b, const double *s, const double *t)
{
  for (int k = 0; k < 3; k++) {
    if (a[k] != b[k]) {
      int sign = s[k] < t[k] ? -1 : s[k] > t[k];

      return a[k] < b[k] ? sign : -sign;
    }
  }
  return 0;
}

/* What the edge from a to b has with g, of which only the corners with side 0
 * are on its line: one or two. */
static meeting
on_line(const double *a, const double *b, const flat *g, const int *side)
{
  const double *low = a, *high = b, *first = NULL, *last = NULL;
  bool shared = false;

  for (int i = 0; i < 3; i++) {
    if (side[i] == 0) {
      const double *c = g->at[i];

      first = !first || order(a, b, c, first) < 0 ? c : first;
      last = !last || order(a, b, c, last) > 0 ? c : last;
      shared = shared || g->shared[i];
    }
  }
  low = order(a, b, first, low) > 0 ? first : low;
  high = order(a, b, last, high) < 0 ? last : high;
  switch (order(a, b, low, high)) {
  case -1:
    return IN_LINE;
  case 0:
    return shared ? APART : IN_POINT;
  default:
    return APART;
  }
}

/* True if an edge of f has all of g on its outer side or on its line; then
 * *common is what they have in common. */
static bool
is_divided(const flat *f, const flat *g, meeting *common)
{
  for (int i = 0; i < 3; i++) {
    const double *a = f->at[i], *b = f->at[(i + 1) % 3];
    int side[3], inner = 0, outer = 0;

    for (int k = 0; k < 3; k++) {
      side[k] = sign_of_area(a, b, g->at[k], f->x, f->y);
      inner += side[k] > 0;
      outer += side[k] < 0;
    }
    if (inner == 0) {
      *common = outer == 3 ? APART : on_line(a, b, g, side);
      return true;
    }
  }
  return false;
}

static meeting
in_one_plane(const double *p[3], const double *q[3], int shared)
{
  int axis = 0;
  meeting common;
  flat f, g;

  while (sign_of_area(p[0], p[1], p[2], AXES[axis][0], AXES[axis][1]) == 0) {
    axis++;
  }
  f = flat_of(p, shared, axis);
  g = flat_of(q, shared, axis);
  if (is_divided(&f, &g, &common) || is_divided(&g, &f, &common)) {
    /* A whole common edge is what they share. */
    return common == IN_LINE && shared == 2 ? APART : common;
  }
  return OVERLAP;
}

/* - - - in two planes - - - */

/* A triangle and on which sides of the other's plane its corners are. */
typedef struct sided {
  const double **at;
  int side[3];
} sided;

static sided
sided_of(const double *p[3], const double *q[3], int shared)
{
  sided s = {p, {0, 0, 0}};

  for (int i = shared; i < 3; i++) {
    s.side[i] = sign_of_volume(q[0], q[1], q[2], p[i]);
  }
  return s;
}

/* How many corners are on a side. */
static int
count(const sided *s, int side)
{
  return (s->side[0] == side) + (s->side[1] == side) + (s->side[2] == side);
}

/* True if edge i of p has a point of q. */
static bool
edge_hits(const sided *p, int i, const double *q[3])
{
  const double *a = p->at[i], *b = p->at[(i + 1) % 3];
  int up = 0, down = 0, sa = p->side[i], sb = p->side[(i + 1) % 3];

  if (sa * sb > 0 || (sa == 0 && sb == 0)) {
    return false; /* an edge in the plane: its ends are seen from the others */
  }
  for (int k = 0; k < 3; k++) {
    int sign = sign_of_volume(a, b, q[k], q[(k + 1) % 3]);

    up += sign > 0;
    down += sign < 0;
  }
  return up == 0 || down == 0;
}

/* The ends on coordinate k of what p has of the line of both planes, in
 * low and high. */
static void
interval(mpq_t low, mpq_t high, const sided *p, const double *q[3],
         const double *const *all, int k)
{
  int lowest = lowest_bit(all, 6), found = 0;
  mpz_t from, to, a, b;
  mpq_t x;

  mpz_inits(from, to, a, b, NULL);
  mpq_init(x);
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;

    if (p->side[i] * p->side[j] > 0 || (p->side[i] != 0 && p->side[j] == 0)) {
      continue;
    }
    /* (from b - to a) / (b - a), the volumes a and b of both ends */
    integer_of(from, p->at[i][k], lowest);
    integer_of(to, p->at[j][k], lowest);
    volume_of(a, q[0], q[1], q[2], p->at[i], all, 6);
    volume_of(b, q[0], q[1], q[2], p->at[j], all, 6);
    if (p->side[i] == 0) {
      mpq_set_z(x, from);
    } else {
      mpz_mul(mpq_numref(x), from, b);
      mpz_submul(mpq_numref(x), to, a);
      mpz_sub(mpq_denref(x), b, a);
      mpq_canonicalize(x);
    }
    if (found == 0 || mpq_cmp(x, low) < 0) {
      mpq_set(low, x);
    }
    if (found == 0 || mpq_cmp(x, high) > 0) {
      mpq_set(high, x);
    }
    found++;
  }
  mpz_clears(from, to, a, b, NULL);
  mpq_clear(x);
}

/* How far two triangles that straddle each other's planes are in common on
 * coordinate k: -1 not at all, 0 a point, 1 more. */
static int
common_length(const sided *p, const sided *q, int k)
{
  const double *all[6] = {p->at[0], p->at[1], p->at[2],
                          q->at[0], q->at[1], q->at[2]};
  int from, to;
  mpq_t end[4];

  for (int i = 0; i < 4; i++) {
    mpq_init(end[i]);
  }
  interval(end[0], end[1], p, q->at, all, k);
  interval(end[2], end[3], q, p->at, all, k);
  from = mpq_cmp(end[0], end[2]) > 0 ? 0 : 2;
  to = mpq_cmp(end[1], end[3]) < 0 ? 1 : 3;
  to = mpq_cmp(end[to], end[from]);
  for (int i = 0; i < 4; i++) {
    mpq_clear(end[i]);
  }
  return to < 0 ? -1 : to > 0;
}

/* What the triangles have, which straddle each other's planes or touch them.
 * Their line is not perpendicular to every axis: the longest coordinate says
 * whether it is a point. */
static meeting
on_common_line(const sided *p, const sided *q)
{
  bool inside = count(p, 1) > 0 && count(p, -1) > 0 && count(q, 1) > 0 &&
                count(q, -1) > 0;
  int length = 0;

  for (int k = 0; k < 3; k++) {
    int along = common_length(p, q, k);

    if (along < 0) {
      return APART;
    }
    length |= along;
  }
  return length == 0 ? IN_POINT : inside ? CROSSING : IN_LINE;
}

/* True if an edge that has no shared corner hits the other triangle: without
 * that nothing but shared corners is common. */
static bool
some_edge_hits(const sided *p, const sided *q, int shared)
{
  if (shared == 1) {
    return edge_hits(p, 1, q->at) || edge_hits(q, 1, p->at);
  }
  for (int i = 0; i < 3; i++) {
    if (edge_hits(p, i, q->at) || edge_hits(q, i, p->at)) {
      return true;
    }
  }
  return false;
}

meeting
meeting_of(const double *p[3], const double *q[3], int shared)
{
  sided s, t;
  int rest = 3 - shared;

  if (shared == 3) {
    return OVERLAP;
  }
  s = sided_of(p, q, shared);
  if (count(&s, 1) == rest || count(&s, -1) == rest) {
    return APART;
  }
  if (count(&s, 0) == 3) {
    return in_one_plane(p, q, shared);
  }
  t = sided_of(q, p, shared);
  if (count(&t, 1) == rest || count(&t, -1) == rest ||
      !some_edge_hits(&s, &t, shared)) {
    return APART;
  }
  return on_common_line(&s, &t);
}
