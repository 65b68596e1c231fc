/* simplify.c -- see simplify.h */
#include "number/vector.h"
#include "simplify_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What costs less, of the area it is measured by and the square of the size of
 * the mesh, costs nothing; and so much a length costs, so that short edges go
 * first where nothing else tells. */
#define NOTHING   1e-13
#define BY_LENGTH 1e-7

/* A triangle must not turn by more than this in one step. */
#define TURN_COSINE 0.2

/* How round triangles have to stay, from 0 to 1, or as they were. What makes
 * worse ones waits as if it cost so many times as much, and again. */
static const double roundness[] = {0.2, 0.06, 0.005};
#define WORSE 10

enum { LEVELS = sizeof roundness / sizeof *roundness };

/* ---- candidates ---- */

static bool
goes_before(const sg_simplify_edge *x, const sg_simplify_edge *y)
{
  return x->cost != y->cost ? x->cost < y->cost
         : x->a != y->a     ? x->a < y->a
                            : x->b < y->b;
}

static bool
heap_add(sg_simplify_work *w, sg_simplify_edge x)
{
  if (!SG_PUSH(w->heap, x)) {
    return false;
  }
  sg_simplify_edge *h = w->heap.item;
  size_t i = w->heap.n - 1;

  for (; i > 0 && goes_before(&x, &h[(i - 1) / 2]); i = (i - 1) / 2) {
    h[i] = h[(i - 1) / 2];
  }
  h[i] = x;
  return true;
}

static sg_simplify_edge
heap_take(sg_simplify_work *w)
{
  sg_simplify_edge *h = w->heap.item, top = h[0], x = h[--w->heap.n];
  size_t n = w->heap.n, i = 0;

  for (size_t k = 1; k < n; k = 2 * i + 1) {
    k += k + 1 < n && goes_before(&h[k + 1], &h[k]);
    if (!goes_before(&h[k], &x)) {
      break;
    }
    h[i] = h[k];
    i = k;
  }
  h[i] = x;
  return top;
}

/* True if a does not move when it is joined to b: it is held, or on a border
 * that b is not on. */
static bool
stays(const sg_simplify_work *w, int32_t a, int32_t b)
{
  return w->flag[a] & SG_HELD || (w->flag[a] & ~w->flag[b] & SG_ON_BORDER);
}

/* Where a and b go, model units; the cost of that. */
static double
best_place(const sg_simplify_work *w, int32_t a, int32_t b, double out[3])
{
  sg_quadric q = w->quadric[a];
  double p[3][3], best = INFINITY, side[3];
  bool stay[2] = {stays(w, a, b), stays(w, b, a)};

  sg_quadric_add(&q, &w->quadric[b]);
  sg_simplify_local(w, w->at[a], p[0]);
  sg_simplify_local(w, w->at[b], p[1]);
  sg_minus(p[1], p[0], side);
  for (int i = 0; i < 2; i++) {
    double value = sg_quadric_value(&q, p[i]);

    if (!stay[1 - i] && value < best) {
      best = value;
      memcpy(out, w->at[i ? b : a], sizeof p[0]);
    }
  }
  if (!stay[0] && !stay[1] && best > NOTHING * q.area) {
    double near[3] = {(p[0][0] + p[1][0]) / 2, (p[0][1] + p[1][1]) / 2,
                      (p[0][2] + p[1][2]) / 2};

    sg_quadric_least(&q, near, p[2]);
    double value = sg_quadric_value(&q, p[2]);
    if (value < best) {
      best = value;
      for (int k = 0; k < 3; k++) {
        out[k] = w->middle[k] + w->size * p[2][k];
      }
    }
  }
  return fmax(best, NOTHING * q.area) + BY_LENGTH * q.area * sg_dot(side, side);
}

static bool
add_candidate(sg_simplify_work *w, int32_t x, int32_t y)
{
  int32_t a = x < y ? x : y, b = x < y ? y : x;
  double place[3];

  if (stays(w, a, b) && stays(w, b, a)) {
    return true;
  }
  return heap_add(w, (sg_simplify_edge){best_place(w, a, b, place), a, b,
                                        w->stamp[a] + w->stamp[b], 0});
}

/* ---- contractions ---- */

static bool
has_vertex(const sg_simplify_work *w, int32_t t, int32_t v)
{
  const int32_t *c = &w->corner[3 * t];

  return c[0] == v || c[1] == v || c[2] == v;
}

/* Of a's neighbours those that are b's too, by the stamp of this round. */
static size_t
common_neighbours(sg_simplify_work *w, int32_t a, int32_t b)
{
  size_t n = 0;

  w->round += 2;
  for (int32_t c = w->first[a]; c >= 0; c = w->next[c]) {
    for (int k = 1; k < 3 && w->corner[c] == a; k++) {
      w->seen[w->corner[c - c % 3 + (c + k) % 3]] = w->round;
    }
  }
  for (int32_t c = w->first[b]; c >= 0; c = w->next[c]) {
    for (int k = 1; k < 3 && w->corner[c] == b; k++) {
      int32_t x = w->corner[c - c % 3 + (c + k) % 3];

      n += w->seen[x] == w->round;
      w->seen[x] += w->seen[x] == w->round;
    }
  }
  return n;
}

/* The link condition: what is a surface stays one of the same kind. */
static bool
keeps_fans(sg_simplify_work *w, int32_t a, int32_t b)
{
  size_t triangles = 0;

  for (int32_t c = w->first[a]; c >= 0; c = w->next[c]) {
    if (w->corner[c] != a || !has_vertex(w, c / 3, b)) {
      continue;
    }
    triangles++;
    for (int k = 0; k < 3; k++) {
      int32_t x = w->corner[c - c % 3 + k];
      size_t least = w->flag[x] & SG_ON_BORDER ? 2 : 4;

      if (x != a && x != b && sg_simplify_corners(w, x) < least) {
        return false;
      }
    }
  }
  bool border = w->flag[a] & w->flag[b] & SG_ON_BORDER;
  return triangles == (border ? 1 : 2) &&
         common_neighbours(w, a, b) == triangles;
}

/* How round the worst triangles of v are, from 0 to 1: *before; and *after,
 * with v at `to` and those of `other` gone. -1: one would turn over. */
static void
see_shapes(const sg_simplify_work *w, int32_t v, int32_t other,
           const double to[3], double *before, double *after)
{
  for (int32_t c = w->first[v]; c >= 0; c = w->next[c]) {
    double n[3], m[3], squares;

    if (w->corner[c] != v) {
      continue;
    }
    sg_simplify_area(w, c / 3, -1, NULL, n, &squares);
    double old = sqrt(sg_dot(n, n));
    *before = fmin(*before, 2 * sqrt(3) * old / squares);
    if (has_vertex(w, c / 3, other)) {
      continue;
    }
    sg_simplify_area(w, c / 3, v, to, m, &squares);
    double new = sqrt(sg_dot(m, m));
    bool turns = sg_dot(n, m) < TURN_COSINE * old * new;
    *after = turns || !(new > 1e-12 * squares)
                 ? -1
                 : fmin(*after, 2 * sqrt(3) * new / squares);
  }
}

/* b goes into a, which goes to `to`. */
static void
contract(sg_simplify_work *w, int32_t a, int32_t b, const double to[3])
{
  for (int32_t c = w->first[b]; c >= 0; c = w->next[c]) {
    if (w->corner[c] != b) {
      continue;
    }
    if (has_vertex(w, c / 3, a)) {
      int32_t *gone = &w->corner[c - c % 3];
      gone[0] = gone[1] = gone[2] = -1;
      w->left--;
    } else {
      w->corner[c] = a;
    }
  }
  w->next[w->last[a]] = w->first[b];
  w->last[a] = w->last[b];
  w->first[b] = w->last[b] = -1;
  w->into[b] = a;
  w->flag[a] |= w->flag[b];
  memcpy(w->at[a], to, sizeof w->at[a]);
  sg_quadric_add(&w->quadric[a], &w->quadric[b]);
  w->stamp[a] += w->stamp[b] + 1;
}

/* Takes what is gone out of the corners of v, and adds its edges. */
static bool
renew(sg_simplify_work *w, int32_t v)
{
  int32_t *hook = &w->first[v], last = -1;
  bool good = true;

  for (int32_t c = w->first[v]; c >= 0; c = w->next[c]) {
    if (w->corner[c] == v) {
      *hook = last = c;
      hook = &w->next[c];
    }
  }
  *hook = -1;
  w->last[v] = last;
  w->round += 2;
  for (int32_t c = w->first[v]; c >= 0 && good; c = w->next[c]) {
    for (int k = 1; k < 3 && good; k++) {
      int32_t x = w->corner[c - c % 3 + (c + k) % 3];

      good = w->seen[x] == w->round || add_candidate(w, v, x);
      w->seen[x] = w->round;
    }
  }
  return good;
}

static bool
take_candidate(sg_simplify_work *w, const sg_simplify_edge *x)
{
  int32_t a = x->a, b = x->b;
  double to[3], before = 1, after = 1;

  if (w->into[a] != a || w->into[b] != b ||
      x->stamp != w->stamp[a] + w->stamp[b]) {
    return true;
  }
  if (!keeps_fans(w, a, b)) {
    return true;
  }
  best_place(w, a, b, to);
  see_shapes(w, a, b, to, &before, &after);
  see_shapes(w, b, a, to, &before, &after);
  if (after < 0) {
    return true;
  }
  if (after < fmin(before, roundness[x->level])) {
    sg_simplify_edge later = *x;

    later.cost *= WORSE;
    return ++later.level == LEVELS || heap_add(w, later);
  }
  if (stays(w, b, a)) {
    a = x->b;
    b = x->a;
  }
  contract(w, a, b, to);
  return renew(w, a);
}

static bool
all_candidates(sg_simplify_work *w)
{
  w->heap.n = 0;
  for (uint32_t c = 0; c < 3 * w->triangles; c++) {
    int32_t a, b;

    if (w->corner[c] < 0) {
      continue;
    }
    sg_simplify_ends(w, c, &a, &b);
    if ((a < b || (w->flag[a] & w->flag[b] & SG_ON_BORDER)) &&
        !add_candidate(w, a, b)) {
      return false;
    }
  }
  return true;
}

static bool
contract_all(sg_simplify_work *w, size_t most)
{
  size_t steps = 0;

  for (size_t before = 0; before != w->left && w->left > most;) {
    before = w->left;
    if (!all_candidates(w)) {
      return false;
    }
    while (w->heap.n > 0 && w->left > most) {
      sg_simplify_edge x = heap_take(w);

      if (sg_cancel_every(w->cancel, steps++) || !take_candidate(w, &x)) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_simplify(const sg_simplify_mesh *mesh, size_t most, const sg_cancel *cancel,
            sg_simplified *out, bool *stopped)
{
  sg_simplify_work w = {.cancel = cancel};

  *out = (sg_simplified){0};
  bool good = sg_simplify_open(&w, mesh) && contract_all(&w, most) &&
              sg_simplify_result(&w, out);
  *stopped = !good && sg_cancelled(cancel);
  sg_simplify_close(&w, out);
  return good;
}

void
sg_simplified_clear(sg_simplified *simplified)
{
  free(simplified->at);
  free(simplified->into);
  free(simplified->corner);
  free(simplified->triangle_of);
  *simplified = (sg_simplified){0};
}
