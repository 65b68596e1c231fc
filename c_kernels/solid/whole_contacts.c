/* whole_contacts.c -- see whole_contacts.h. */
#include "whole_contacts.h"

#include "engine/search.h"
#include "join/contact.h"
#include "join/self_join.h"
#include "number/vector.h"
#include "rows/disjoint.h"
#include "rows/edge_print.h"
#include "rows/key_table.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct checker {
  const sg_solid *solid;
  uint32_t *face_of; /* [triangles] */
  double reach;
  const sg_cancel *cancel;
  bool stopped;      /* it said stop, or there is no memory */
  atomic_bool found; /* something that is not whole */
} checker;

/* Whether to stop, asked in step i. */
static bool
stops(checker *c, size_t i)
{
  c->stopped = c->stopped || sg_cancel_every(c->cancel, i);
  return c->stopped;
}

/* ---- pairs -------------------------------------------------------------- */

static void
read_triangle(const void *data, uint32_t i, sg_fan_triangle *out)
{
  const checker *c = data;

  for (int k = 0; k < 3; k++) {
    uint32_t v = c->solid->triangle[i][k];

    memcpy(out->at[k], c->solid->vertex[v].at, sizeof out->at[k]);
    out->name[k] = v;
  }
  out->polygon = (int32_t)c->face_of[i];
}

static bool
are_one_corner(const sg_fan_triangle *a, const sg_fan_triangle *b,
               const sg_feature f[2])
{
  return f[0] <= SG_CORNER_2 && f[1] <= SG_CORNER_2 &&
         a->name[f[0]] == b->name[f[1]];
}

/* Whether they have anything in common but corners that are one and the edge
 * between them. Exact. */
static bool
meet(const sg_fan_triangle *a, const sg_fan_triangle *b, sg_self_two *two)
{
  sg_cut cut[SG_CUT_MAX];
  int n = 0;

  if (!sg_self_may_meet(two)) {
    return false;
  }
  if (two->n > 1) {
    return true;
  }
  sg_cut_triangles((const double(*)[3])a->at, (const double(*)[3])b->at, cut,
                   &n);
  for (int i = 0; i < n; i++) {
    if (!sg_cut_is_point(&cut[i]) || !are_one_corner(a, b, cut[i].end[0].f)) {
      return true;
    }
  }
  return false;
}

/* ---- near, and plainly not ---------------------------------------------- */

/* Triangle x, and y that has one or two corners of it: v is one of them. */
typedef struct beside {
  const double (*x)[3], (*y)[3], *v;
  const bool *shared; /* corners of y */
  double least;       /* a square that is plainly above that of the reach */
  double height;      /* no more than the square of a height of x */
} beside;

/* Whether y but for its shared corners is before the plane through v across m
 * (way < 0: behind it; 0: on either side), on which x is not: so deep, and so
 * steep, that no features are within reach but those that have a corner in
 * common. For a point of an edge of y at v, as far as s from v, is s times its
 * sine deep, and what of x does not hang on v is a height of x from v. */
static bool
is_beyond(const beside *p, const double m[3], int way)
{
  double square = sg_dot(m, m), from[3];

  for (int i = 0; i < 3; i++) {
    if (p->shared[i]) {
      continue;
    }
    sg_minus(p->y[i], p->v, from);
    double depth = sg_dot(m, from), deep = depth * depth;

    way = way != 0 ? way : depth > 0 ? 1 : -1;
    if (!(depth * way > 0 && deep > p->least * square &&
          deep * p->height > p->least * square * sg_dot(from, from))) {
      return false;
    }
  }
  return true;
}

/* Beyond the plane of x, or that across it along a side at corner `at` of x,
 * which has all shared corners: bit 0 and 1 of `sides`, the next and the last.
 */
static bool
is_beside(beside *p, int at, int sides)
{
  double u[3], w[3], n[3], m[3], o[3], longest;

  p->v = p->x[at];
  sg_minus(p->x[(at + 1) % 3], p->v, u);
  sg_minus(p->x[(at + 2) % 3], p->v, w);
  sg_minus(w, u, o);
  sg_cross(u, w, n);
  longest = fmax(fmax(sg_dot(u, u), sg_dot(w, w)), sg_dot(o, o));
  p->height = sg_dot(n, n) / longest;
  if (!(p->height > p->least)) {
    return false;
  }
  if (is_beyond(p, n, 0)) {
    return true;
  }
  sg_cross(n, u, m);
  if ((sides & 1) && is_beyond(p, m, -1)) {
    return true;
  }
  sg_cross(n, w, m);
  return (sides & 2) && is_beyond(p, m, 1);
}

/* Beyond the plane through corner `at` of x and corner `with` of y, one place,
 * that is across the way from the middle of one to that of the other. */
static bool
is_opposite(beside *p, int at, int with)
{
  double m[3] = {0}, from[2][3], of[3];

  p->v = p->x[at];
  for (int i = 1; i < 3; i++) {
    sg_minus(p->x[(at + i) % 3], p->v, from[i - 1]);
    sg_minus(p->y[(with + i) % 3], p->v, of);
    double a = 1 / sg_length(from[i - 1]), b = 1 / sg_length(of);

    for (int k = 0; k < 3; k++) {
      m[k] += b * of[k] - a * from[i - 1][k];
    }
  }
  return sg_dot(m, from[0]) <= 0 && sg_dot(m, from[1]) <= 0 &&
         is_beyond(p, m, 1);
}

/* Triangle x beside y: for each corner they share. */
static bool
plainly_beside(const double x[3][3], const double y[3][3], const int *of_x,
               const int *of_y, int n, double reach)
{
  bool shared[3] = {false};
  beside p = {.x = x, .y = y, .shared = shared, .least = 64 * reach * reach};

  for (int i = 0; i < n; i++) {
    shared[of_y[i]] = true;
  }
  for (int i = 0; i < n; i++) {
    int other = n == 2 ? of_x[1 - i] : -1;
    int sides = n == 1 ? 3 : other == (of_x[i] + 1) % 3 ? 1 : 2;

    if (!is_beside(&p, of_x[i], sides) &&
        !(n == 1 && p.height > p.least && is_opposite(&p, of_x[i], of_y[i]))) {
      return false;
    }
  }
  return true;
}

/* Nothing in common, and a plane between them across the way from the middle of
 * one to that of the other, plainly farther than the reach from both. */
static bool
plainly_apart(const double x[3][3], const double y[3][3], double reach)
{
  double m[3], highest = -INFINITY, lowest = INFINITY;

  for (int k = 0; k < 3; k++) {
    m[k] = y[0][k] + y[1][k] + y[2][k] - x[0][k] - x[1][k] - x[2][k];
  }
  for (int i = 0; i < 3; i++) {
    double of_x[3], of_y[3];

    sg_minus(x[i], x[0], of_x);
    sg_minus(y[i], x[0], of_y);
    highest = fmax(highest, sg_dot(m, of_x));
    lowest = fmin(lowest, sg_dot(m, of_y));
  }
  double gap = lowest - highest;

  return gap > 0 && gap * gap > 256 * reach * reach * sg_dot(m, m);
}

/* Whether two features within reach are not one corner. */
static bool
come_near(const sg_fan_triangle *a, const sg_fan_triangle *b,
          const sg_self_two *two, double reach)
{
  sg_contact contact[SG_CONTACT_MAX];

  if (two->n == 0 && plainly_apart(two->a, two->b, reach)) {
    return false;
  }
  if ((two->n == 1 || two->n == 2) &&
      (plainly_beside(two->a, two->b, two->shared, two->same, two->n, reach) ||
       plainly_beside(two->b, two->a, two->same, two->shared, two->n, reach))) {
    return false;
  }
  int n = sg_contacts((const double(*)[3])a->at, (const double(*)[3])b->at,
                      reach, contact);

  for (int i = 0; i < n; i++) {
    if (!are_one_corner(a, b, contact[i].f)) {
      return true;
    }
  }
  return false;
}

/* An sg_self_wants: it wants no pair, but that the join ends. */
static bool
note_pair(void *data, const sg_fan_triangle *a, const sg_fan_triangle *b)
{
  checker *c = data;
  sg_self_two two;

  if (!atomic_load_explicit(&c->found, memory_order_relaxed)) {
    sg_self_two_of(a, b, &two);
    if (meet(a, b, &two) || (c->reach > 0 && come_near(a, b, &two, c->reach))) {
      atomic_store(&c->found, true);
    }
  }
  return false;
}

/* ---- each by itself ----------------------------------------------------- */

/* Its corners are three, with an area, and far apart. */
static bool
is_sound(const checker *c, size_t t)
{
  double at[3][3], least = 4 * c->reach;

  for (int k = 0; k < 3; k++) {
    memcpy(at[k], c->solid->vertex[c->solid->triangle[t][k]].at, sizeof at[k]);
  }
  for (int k = 0; k < 3; k++) {
    if (!(sg_distance(at[k], at[(k + 1) % 3]) > least)) {
      return false;
    }
  }
  return sg_cut_axis((const double(*)[3])at) >= 0;
}

static bool
sound_triangles(checker *c)
{
  for (uint32_t f = 0; f < c->solid->faces; f++) {
    const sg_solid_face *face = &c->solid->face[f];

    for (uint32_t t = face->first; t < face->first + face->n; t++) {
      c->face_of[t] = f;
      if (stops(c, t) || !is_sound(c, t)) {
        return false;
      }
    }
  }
  return true;
}

/* No face has two of one segment. Parts are in the order of their segments. */
static bool
single_faces(const sg_solid *solid)
{
  for (size_t i = 0; i < solid->parts; i++) {
    const struct sg_solid_part *a = &solid->part[i];

    if (a->s == solid->face[a->face].s ||
        (i > 0 && a[-1].face == a->face && a[-1].s == a->s)) {
      return false;
    }
  }
  return true;
}

/* What a key was first put with. Null: no memory. */
static const uint32_t *
put_first(sg_key_table *table, const uint32_t *key, uint32_t value)
{
  uint32_t *is = sg_key_table_put(table, key);

  if (is && *is == SG_NO_KEY) {
    *is = value;
  }
  return is;
}

/* No segment has two vertices in one place. */
static bool
single_vertices(checker *c)
{
  const sg_solid *solid = c->solid;
  sg_key_table at, seen;
  bool good = true;

  sg_key_table_init(&at, 6);
  sg_key_table_init(&seen, 2);
  for (uint32_t v = 0; good && v < solid->vertices && !stops(c, v); v++) {
    uint32_t place[6];

    memcpy(place, solid->vertex[v].at, sizeof place);
    const uint32_t *here = put_first(&at, place, v);
    const uint32_t key[2] = {here ? *here : 0, (uint32_t)solid->vertex[v].s};
    const uint32_t *only = here ? put_first(&seen, key, v) : NULL;

    c->stopped = !only;
    good = only && *only == v;
  }
  sg_key_table_clear(&at);
  sg_key_table_clear(&seen);
  return good;
}

/* ---- solids ------------------------------------------------------------- */

/* A face of a segment. */
typedef struct use {
  int32_t s;
  uint32_t face;
  bool reversed; /* the segment has it the other way round */
} use;

SG_ORDER(by_segment, use, SG_BY(s) SG_BY(face));

/* How many there are; SIZE_MAX: no memory, or stopped. */
static size_t
list_uses(checker *c, use *out)
{
  const sg_solid *solid = c->solid;
  size_t n = 0;

  for (uint32_t f = 0; f < solid->faces; f++) {
    out[n++] = (use){solid->face[f].s, f, false};
  }
  for (size_t i = 0; i < solid->parts; i++) {
    const struct sg_solid_part *part = &solid->part[i];

    out[n++] = (use){part->s, part->face, part->reversed};
  }
  sg_sort_end end = sg_sort(out, n, sizeof *out, by_segment, c->cancel);

  c->stopped = end == SG_SORT_STOPPED;
  return end == SG_SORTED ? n : SIZE_MAX;
}

static uint64_t
edge_print(uint32_t a, uint32_t b, bool reversed)
{
  uint32_t low = a < b ? a : b;
  uint64_t bits = sg_spread_bits((uint64_t)low << 32 | (a ^ b ^ low));

  return (a > b) != reversed ? 0 - bits : bits;
}

/* Joins the vertices of a face, and adds the prints of its edges: edges that
 * run as often back as there add up to nothing. */
static void
take_face(const sg_solid *solid, const use *of, uint32_t *set, uint64_t *print)
{
  const sg_solid_face *face = &solid->face[of->face];

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    const uint32_t *v = solid->triangle[t];

    for (int k = 0; k < 3; k++) {
      sg_disjoint_join(set, v[k], v[(k + 1) % 3]);
      *print += edge_print(v[k], v[(k + 1) % 3], of->reversed);
    }
  }
}

/* Whether the n faces of a segment are one part, and closed: wrong once in
 * 2^64. `set`: of vertices, each alone before and after. */
static bool
bounds_one(checker *c, const use *of, size_t n, uint32_t *set)
{
  const sg_solid *solid = c->solid;
  uint64_t print = 0;
  bool one = true;

  for (size_t i = 0; i < n && !stops(c, i); i++) {
    take_face(solid, &of[i], set, &print);
  }
  uint32_t first = solid->triangle[solid->face[of->face].first][0];
  uint32_t root = sg_disjoint_root(set, first);

  for (size_t i = 0; i < n; i++) {
    const sg_solid_face *face = &solid->face[of[i].face];
    uint32_t v = solid->triangle[face->first][0];

    one = one && sg_disjoint_root(set, v) == root;
  }
  for (size_t i = 0; i < n; i++) {
    const sg_solid_face *face = &solid->face[of[i].face];

    for (uint32_t t = face->first; t < face->first + face->n; t++) {
      const uint32_t *v = solid->triangle[t];

      set[v[0]] = v[0], set[v[1]] = v[1], set[v[2]] = v[2];
    }
  }
  return one && print == 0 && !stops(c, 0);
}

/* *sound: each of the solids has faces, is one part, and is closed. */
static bool
sound_solids(checker *c, const int32_t *solids, size_t n, bool *sound)
{
  const sg_solid *solid = c->solid;
  use *of = malloc((solid->faces + solid->parts + 1) * sizeof *of);
  uint32_t *set = malloc((solid->vertices + 1) * sizeof *set);
  bool good = of && set;
  size_t seen = 0;

  for (uint32_t v = 0; good && v < solid->vertices; v++) {
    set[v] = v;
  }
  size_t all = good ? list_uses(c, of) : SIZE_MAX;

  *sound = good = all != SIZE_MAX;

  for (size_t i = 0, end; *sound && i < all; i = end) {
    for (end = i; end < all && of[end].s == of[i].s; end++) {
    }
    if (sg_find_id(solids, n, of[i].s) != SIZE_MAX) {
      *sound = bounds_one(c, of + i, end - i, set);
      seen++;
    }
  }
  *sound = *sound && seen == n;
  free(of);
  free(set);
  return good;
}

/* ---- together ----------------------------------------------------------- */

bool
sg_whole_contacts(const sg_solid *solid, const int32_t *solids, size_t n,
                  double reach, sg_pool *pool, const sg_cancel *cancel,
                  bool *whole)
{
  checker c = {.solid = solid,
               .face_of = malloc((solid->triangles + 1) * sizeof *c.face_of),
               .reach = reach,
               .cancel = cancel};
  sg_bvh_hits none = {0};
  bool good = c.face_of && sound_solids(&c, solids, n, whole);

  *whole = good && *whole && single_faces(solid) && single_vertices(&c) &&
           sound_triangles(&c);
  good = good && !c.stopped;
  if (*whole) {
    const sg_self_joining joining = {.n = solid->triangles,
                                     .read = read_triangle,
                                     .wants = note_pair,
                                     .data = &c,
                                     .reach = reach,
                                     .done = &c.found};

    good = sg_self_join(&joining, pool, cancel, &none);
    *whole = good && !atomic_load(&c.found);
  }
  free(none.hit);
  free(c.face_of);
  return good;
}
