/* self_star.c -- vertices that very many triangles have: see self_join.h.
 *
 * The boxes of n triangles on one vertex all have it, and where these lie in
 * one another as seen from there, no box tells two apart (fan.h). So the few
 * vertices with most triangles, the HUBS, are looked at once for all of these
 * (star.h). Two triangles that cross nothing at a hub of both are settled: they
 * have nothing in common that is not theirs by name. Those on an edge of two
 * hubs, and on another one, are parted by planes, as far as these tell.
 */
#include "self_join_private.h"

#include "engine/list.h"
#include "number/vector.h"
#include "rows/sort.h"
#include "spine.h"
#include "star.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of a hub's triangles each two are no fewer than all triangles. */
enum { HUBS = SG_SELF_HUBS, MANY = 64 };

/* A corner, or an end of an arc beside its hub: the edge between them is one
 * only by name. */
typedef struct corner {
  double at[3];
  uint32_t name, hub; /* hub: 0 if it is a hub itself */
  uint32_t of;
} corner;

typedef SG_LIST_OF(corner) corners;

/* Corners item[begin .. begin + n - 1] are one. */
typedef struct hub {
  size_t begin, n;
} hub;

static bool
is_many(const sg_self_joiner *j, size_t n)
{
  return n >= MANY && n * n / 4 >= j->of->n;
}

static corner
corner_of(const sg_self_joiner *j, const sg_fan_triangle *t, int k, uint32_t of)
{
  uint32_t name = j->of->by_place ? sg_name_of_place(t->at[k]) : t->name[k];

  return (corner){{t->at[k][0], t->at[k][1], t->at[k][2]}, name, 0, of};
}

static int
compare(const corner *a, const corner *b)
{
  if (a->name != b->name) {
    return a->name < b->name ? -1 : 1;
  }
  for (int k = 0; k < 3; k++) {
    if (a->at[k] != b->at[k]) {
      return a->at[k] < b->at[k] ? -1 : 1;
    }
  }
  return (a->hub > b->hub) - (a->hub < b->hub);
}

static int
by_corner(const void *x, const void *y)
{
  const corner *a = x, *b = y;
  int order = compare(a, b);

  return order ? order : (a->of > b->of) - (a->of < b->of);
}

/* ---- hubs ---- */

/* All corners that may be of hubs; mostly none. False: no memory, or stopped.
 */
static bool
find_corners(const sg_self_joiner *j, const sg_cancel *cancel, corners *out)
{
  size_t mask = 63;
  bool any = false, good;
  sg_fan_triangle t;

  while (mask < j->of->n) {
    mask = 2 * mask + 1;
  }
  uint32_t *count = calloc(mask + 1, sizeof *count);

  good = count != NULL;
  for (uint32_t i = 0; good && i < j->of->n; i++) {
    good = !sg_cancel_every(cancel, i);
    j->of->read(j->of->data, i, &t);
    for (int k = 0; k < 3; k++) {
      corner c = corner_of(j, &t, k, i);
      any = is_many(j, ++count[c.name & mask]) || any;
    }
  }
  for (uint32_t i = 0; any && good && i < j->of->n; i++) {
    good = !sg_cancel_every(cancel, i);
    j->of->read(j->of->data, i, &t);
    for (int k = 0; k < 3; k++) {
      corner c = corner_of(j, &t, k, i);
      good = good && (!is_many(j, count[c.name & mask]) || SG_PUSH(*out, c));
    }
  }
  free(count);
  return good;
}

/* Those of most triangles; of more, the first ones. Returns how many. */
static int
choose_hubs(const sg_self_joiner *j, const corners *all, hub out[HUBS])
{
  int hubs = 0;

  for (size_t i = 0, end; i < all->n; i = end) {
    for (end = i + 1;
         end < all->n && compare(&all->item[i], &all->item[end]) == 0; end++) {
    }
    int k = hubs;

    if (!is_many(j, end - i)) {
      continue;
    }
    for (; k > 0 && out[k - 1].n < end - i; k--) {
      if (k < HUBS) {
        out[k] = out[k - 1];
      }
    }
    if (k < HUBS) {
      out[k] = (hub){i, end - i};
      hubs += hubs < HUBS;
    }
  }
  return hubs;
}

/* ---- arcs ---- */

/* Round one hub. */
typedef struct star {
  sg_star_arc *arc; /* [n] */
  bool *crossed;
  size_t n, ends;
} star;

/* The other ends of a triangle at a hub. */
static void
find_ends(const sg_self_joiner *j, const corner *at, uint32_t arc,
          corner out[2])
{
  sg_fan_triangle t;
  int h = 0;

  j->of->read(j->of->data, at->of, &t);
  for (int k = 2; k > 0; k--) {
    corner c = corner_of(j, &t, k, 0);
    h = compare(&c, at) == 0 ? k : h;
  }
  for (int k = 0; k < 2; k++) {
    int other = (h + 1 + k) % 3;

    memcpy(out[k].at, t.at[other], sizeof out[k].at);
    out[k].name = t.name[other];
    out[k].hub = t.name[h];
    out[k].of = 2 * arc + (uint32_t)k;
  }
}

/* The arcs of the triangles at a hub. False: no memory, or stopped. */
static bool
make_star(const sg_self_joiner *j, const corner *at, star *s,
          const sg_cancel *cancel)
{
  corner *end = malloc((2 * s->n + 1) * sizeof *end);

  s->arc = malloc((s->n + 1) * sizeof *s->arc);
  s->crossed = malloc((s->n + 1) * sizeof *s->crossed);
  bool good = end && s->arc && s->crossed;

  for (uint32_t i = 0; good && i < s->n; i++) {
    find_ends(j, &at[i], i, &end[2 * i]);
    good = !sg_cancel_every(cancel, i);
  }
  good = good &&
         sg_sort(end, 2 * s->n, sizeof *end, by_corner, cancel) == SG_SORTED;

  for (size_t i = 0; good && i < 2 * s->n; i++) {
    sg_star_arc *arc = &s->arc[end[i].of / 2];

    s->ends += i == 0 || compare(&end[i - 1], &end[i]) != 0;
    arc->end[end[i].of % 2] = (uint32_t)s->ends - 1;
    memcpy(arc->at[end[i].of % 2], end[i].at, sizeof end[i].at);
  }
  free(end);
  return good;
}

static void
star_clear(star *s)
{
  free(s->arc);
  free(s->crossed);
}

/* Settles the triangles at hub h. False: no memory, or stopped. */
static bool
settle(sg_self_joiner *j, const corner *at, size_t n, int h,
       const sg_cancel *cancel)
{
  star s = {.n = n};
  bool good = make_star(j, at, &s, cancel) &&
              sg_star_cross(at->at, s.arc, n, s.ends, j->of->but_equal, cancel,
                            s.crossed);

  for (size_t i = 0; good && i < n; i++) {
    if (!s.crossed[i]) {
      j->star[at[i].of] |= (unsigned char)(1 << h);
    }
  }
  memcpy(j->hub[h], at->at, sizeof at->at);
  star_clear(&s);
  return good;
}

bool
sg_self_find_stars(sg_self_joiner *j, const sg_cancel *cancel)
{
  corners all = {0};
  hub chosen[HUBS];
  int hubs = 0;

  if (j->of->reach > 0) {
    return true;
  }
  bool good = find_corners(j, cancel, &all) &&
              sg_sort(all.item, all.n, sizeof *all.item, by_corner, cancel) ==
                  SG_SORTED;

  if (good && (hubs = choose_hubs(j, &all, chosen)) > 0) {
    j->star = calloc(j->of->n + 1, 1);
    good = j->star != NULL;
  }
  for (int h = 0; good && h < hubs; h++) {
    good = settle(j, &all.item[chosen[h].begin], chosen[h].n, h, cancel);
  }
  free(all.item);
  return good;
}

/* ---- in a tree ---- */

/* Whether all that is below a node has an edge between two hubs. */
static bool
has_edge(unsigned char bits)
{
  return __builtin_popcount(bits) == 2;
}

/* The box round the corners of a triangle that are not at these two hubs. */
static sg_box
rest_of_triangle(const sg_self_joiner *j, uint32_t i, unsigned char hubs)
{
  sg_box box = sg_box_none();
  sg_fan_triangle t;

  j->of->read(j->of->data, i, &t);
  for (int k = 0; k < 3; k++) {
    bool is_hub = false;

    for (unsigned bits = hubs; bits; bits &= bits - 1) {
      const double *h = j->hub[__builtin_ctz(bits)];
      is_hub = is_hub ||
               (t.at[k][0] == h[0] && t.at[k][1] == h[1] && t.at[k][2] == h[2]);
    }
    if (!is_hub) {
      sg_box_add(&box, t.at[k]);
    }
  }
  return box;
}

/* The same of a node that has these bits and `rest`, or a third bit. */
static sg_box
rest_of_node(const sg_self_joiner *j, unsigned char bits, const sg_box *rest,
             unsigned char hubs)
{
  sg_box box = sg_box_none();

  if (bits == hubs) {
    return *rest;
  }
  sg_box_add(&box, j->hub[__builtin_ctz(bits & ~(unsigned)hubs)]);
  return box;
}

static void
open_node(const sg_self_joiner *j, sg_self_stars *s, unsigned level, size_t i)
{
  size_t below = s->tree->count[level - 1], begin = i * SG_BVH_WIDTH;
  size_t end = begin + SG_BVH_WIDTH < below ? begin + SG_BVH_WIDTH : below;
  unsigned char all = UINT8_MAX;

  for (size_t k = begin; k < end; k++) {
    all &= level > 1 ? s->level[level - 1][k]
                     : j->star[sg_self_triangle_at(j, s->tree, (uint32_t)k)];
  }
  s->level[level][i] = all;
  s->rest[level][i] = sg_box_none();
  for (size_t k = begin; has_edge(all) && k < end; k++) {
    sg_box box =
        level > 1 ? rest_of_node(j, s->level[level - 1][k],
                                 &s->rest[level - 1][k], all)
                  : rest_of_triangle(
                        j, sg_self_triangle_at(j, s->tree, (uint32_t)k), all);
    sg_box_join(&s->rest[level][i], &box);
  }
}

bool
sg_self_stars_open(const sg_self_joiner *j, const sg_bvh *tree,
                   const sg_cancel *cancel, sg_self_stars *out)
{
  *out = (sg_self_stars){.tree = tree};
  for (unsigned level = 1; j->star && level < tree->levels; level++) {
    out->level[level] = malloc(tree->count[level]);
    out->rest[level] = malloc(tree->count[level] * sizeof(sg_box));
    if (!out->level[level] || !out->rest[level]) {
      return false;
    }
    for (size_t i = 0; i < tree->count[level]; i++) {
      open_node(j, out, level, i);
      if (sg_cancel_every(cancel, i)) {
        return false;
      }
    }
  }
  return true;
}

void
sg_self_stars_close(sg_self_stars *stars)
{
  for (unsigned level = 0; level < SG_BVH_LEVELS; level++) {
    free(stars->level[level]);
    free(stars->rest[level]);
  }
}

/* ---- a plane between ---- */

/* What lies round all that is below a node: its two hubs, and a box. */
enum { CORNERS = 10 };

typedef struct hull {
  double at[CORNERS][3];
} hull;

static hull
hull_of(const sg_self_joiner *j, unsigned char hubs, const sg_box *rest)
{
  hull out = {{{0}}};
  int n = 0;

  for (unsigned bits = hubs; bits; bits &= bits - 1) {
    memcpy(out.at[n++], j->hub[__builtin_ctz(bits)], sizeof out.at[0]);
  }
  for (int i = 0; n < CORNERS; i++, n++) {
    for (int k = 0; k < 3; k++) {
      out.at[n][k] = i >> k & 1 ? rest->hi[k] : rest->lo[k];
    }
  }
  return out;
}

/* How far along m from o it reaches, let out by more than rounding. */
static void
reach_along(const hull *h, const double m[3], const double o[3], double to[2])
{
  to[0] = INFINITY;
  to[1] = -INFINITY;
  for (int i = 0; i < CORNERS; i++) {
    double sum = 0, size = 0;

    for (int k = 0; k < 3; k++) {
      double term = m[k] * (h->at[i][k] - o[k]);
      sum += term;
      size += fabs(term);
    }
    to[0] = fmin(to[0], sum - 1e-14 * size - 1e-290);
    to[1] = fmax(to[1], sum + 1e-14 * size + 1e-290);
  }
}

/* Whether a plane through both hubs of a and a corner of its box, moved a
 * little, is between. */
static bool
is_between(const hull *a, const hull *b)
{
  for (int i = 2; i < CORNERS; i++) {
    double u[3], v[3], m[3], to_a[2], to_b[2];

    sg_minus(a->at[1], a->at[0], u);
    sg_minus(a->at[i], a->at[0], v);
    sg_cross(u, v, m);
    reach_along(a, m, a->at[0], to_a);
    reach_along(b, m, a->at[0], to_b);
    if (to_a[1] < to_b[0] || to_b[1] < to_a[0]) {
      return true;
    }
  }
  return false;
}

bool
sg_self_stars_apart(const sg_self_joiner *j, const sg_self_stars *stars,
                    unsigned level, size_t a, size_t b)
{
  unsigned char x = stars->level[level][a], y = stars->level[level][b];

  if ((x & y) || !has_edge(x) || !has_edge(y)) {
    return x & y;
  }
  hull p = hull_of(j, x, &stars->rest[level][a]);
  hull q = hull_of(j, y, &stars->rest[level][b]);

  return is_between(&p, &q) || is_between(&q, &p);
}
