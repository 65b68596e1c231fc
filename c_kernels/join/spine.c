#include "spine.h"

#include "engine/list.h"
#include "engine/search.h"
#include "number/vector.h"
#include "rows/key_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  MANY = 32, /* triangles of an edge that is worth it */
  MOST = 4   /* spines of a tree */
};

/* What rounding may take from a direction of length 1, and far more; of one
 * that is R from the spine, and D from its end, D/R as much. */
#define LET_OUT 1e-13

/* Round the directions from the spine, across it. */
typedef struct arc {
  double lo[2], hi[2];
} arc;

typedef struct edge {
  uint32_t name[2]; /* ascending */
  double at[2][3];
  size_t triangles;
} edge;

typedef struct spine {
  edge edge;
  double across[2][3];
  arc *level[SG_BVH_LEVELS]; /* from 1 on */
} spine;

struct sg_spines {
  const sg_bvh *tree;
  sg_fan_read *read;
  const void *data;
  bool by_place;
  spine spine[MOST];
  size_t n;
};

uint32_t
sg_name_of_place(const double at[3])
{
  uint64_t h = 0;

  for (int k = 0; k < 3; k++) {
    double x = at[k] + 0.0; /* -0.0 is 0.0 */
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    h = (h ^ bits) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return (uint32_t)h;
}

static void
read_at(const sg_spines *s, size_t place, sg_fan_triangle *out)
{
  s->read(s->data, place, out);
  for (int k = 0; s->by_place && k < 3; k++) {
    out->name[k] = sg_name_of_place(out->at[k]);
  }
}

/* ---- which edges ---- */

typedef struct edges {
  unsigned char *corners; /* [mask + 1] triangles at a vertex, up to MANY */
  size_t mask;
  sg_key_table number;
  edge *item;
  size_t n, room;
} edges;

/* False: no memory, or stopped. *any: some vertex has many. */
static bool
count_corners(const sg_spines *s, const sg_cancel *cancel, edges *e, bool *any)
{
  size_t places = 64;

  while (places < s->tree->n) {
    places *= 2;
  }
  e->mask = places - 1;
  e->corners = calloc(places, 1);
  for (size_t i = 0; e->corners && i < s->tree->n; i++) {
    sg_fan_triangle t;

    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    read_at(s, i, &t);
    for (int k = 0; k < 3; k++) {
      unsigned char *here = &e->corners[t.name[k] & e->mask];
      *here = (unsigned char)(*here < MANY ? *here + 1 : MANY);
      *any = *any || *here == MANY;
    }
  }
  return e->corners != NULL;
}

static bool
has_many(const edges *e, uint32_t name)
{
  return e->corners[name & e->mask] == MANY;
}

/* False: no memory. */
static bool
count_edge(edges *e, const sg_fan_triangle *t, int k)
{
  int a = k, b = (k + 1) % 3;

  if (t->name[b] < t->name[a]) {
    a = b;
    b = k;
  }
  uint32_t key[2] = {t->name[a], t->name[b]};
  uint32_t *number = sg_key_table_put(&e->number, key);

  if (!number) {
    return false;
  }
  if (*number == SG_NO_KEY) {
    if (!sg_list_grow(&e->item, e->n, &e->room, sizeof *e->item)) {
      return false;
    }
    *number = (uint32_t)e->n;
    edge *fresh = &e->item[e->n++];
    *fresh = (edge){.name = {key[0], key[1]}};
    memcpy(fresh->at[0], t->at[a], sizeof t->at[a]);
    memcpy(fresh->at[1], t->at[b], sizeof t->at[b]);
  }
  e->item[*number].triangles++;
  return true;
}

static bool
count_edges(const sg_spines *s, const sg_cancel *cancel, edges *e)
{
  for (size_t i = 0; i < s->tree->n; i++) {
    sg_fan_triangle t;

    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    read_at(s, i, &t);
    for (int k = 0; k < 3; k++) {
      if (has_many(e, t.name[k]) && has_many(e, t.name[(k + 1) % 3]) &&
          !count_edge(e, &t, k)) {
        return false;
      }
    }
  }
  return true;
}

SG_ORDER(by_triangles, edge,
         SG_BY_MOST(triangles) SG_BY(name[0]) SG_BY(name[1]));

/* False: it has no direction that could be told. */
static bool
set_across(spine *s)
{
  double way[3], size = 0;
  int least = 0;

  sg_minus(s->edge.at[1], s->edge.at[0], way);
  for (int k = 0; k < 3; k++) {
    size = fmax(size, fabs(way[k]));
  }
  if (!(size > 0x1p-300 && size < 0x1p300)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    way[k] /= size;
    least = fabs(way[k]) < fabs(way[least]) ? k : least;
  }
  double along[3] = {least == 0, least == 1, least == 2};

  sg_cross(way, along, s->across[0]);
  sg_cross(way, s->across[0], s->across[1]);
  for (int i = 0; i < 2; i++) {
    size = sg_length(s->across[i]);
    for (int k = 0; k < 3; k++) {
      s->across[i][k] /= size;
    }
  }
  return true;
}

/* False: no memory, or stopped. */
static bool
choose_spines(sg_spines *s, const sg_cancel *cancel)
{
  edges e = {0};
  bool any = false;

  sg_key_table_init(&e.number, 2);
  bool good = count_corners(s, cancel, &e, &any) &&
              (!any || count_edges(s, cancel, &e));

  if (good && e.n > 0) {
    qsort(e.item, e.n, sizeof *e.item, by_triangles);
  }
  for (size_t i = 0;
       good && i < e.n && s->n < MOST && e.item[i].triangles >= MANY; i++) {
    s->spine[s->n].edge = e.item[i];
    s->n += set_across(&s->spine[s->n]);
  }
  free(e.corners);
  free(e.item);
  sg_key_table_clear(&e.number);
  return good;
}

/* ---- arcs ---- */

static const arc whole = {{-2, -2}, {2, 2}};

/* Which way x is; *out: how far that may be off. */
static void
look_at(const spine *s, const double x[3], double way[2], double *out)
{
  double d[3];

  sg_minus(x, s->edge.at[0], d);
  way[0] = sg_dot(d, s->across[0]);
  way[1] = sg_dot(d, s->across[1]);
  double far = sg_length(d), near = hypot(way[0], way[1]);

  way[0] /= near;
  way[1] /= near;
  *out = fmax(*out, LET_OUT * (1 + far / near)); /* not if it is no number */
  *out = near > 0x1p-300 && far < 0x1p300 ? *out : 1;
}

/* Whether a corner is an end of the spine. */
static bool
is_end(const spine *s, bool by_place, const sg_fan_triangle *t, int k)
{
  const edge *e = &s->edge;

  for (int i = 0; i < 2; i++) {
    if (t->name[k] == e->name[i] &&
        (!by_place ||
         (t->at[k][0] == e->at[i][0] && t->at[k][1] == e->at[i][1] &&
          t->at[k][2] == e->at[i][2]))) {
      return true;
    }
  }
  return false;
}

/* The arc of a triangle; all of the circle, if that is more than a sixth. */
static arc
arc_of(const spine *s, bool by_place, const sg_fan_triangle *t)
{
  arc box = {{2, 2}, {-2, -2}};
  double way[3][2], out = 0, close = 1;
  int n = 0;

  for (int k = 0; k < 3; k++) {
    if (!is_end(s, by_place, t, k)) {
      look_at(s, t->at[k], way[n++], &out);
    }
  }
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < 2; k++) {
      box.lo[k] = fmin(box.lo[k], way[i][k]);
      box.hi[k] = fmax(box.hi[k], way[i][k]);
    }
    for (int k = 0; k < i; k++) {
      close = fmin(close, way[i][0] * way[k][0] + way[i][1] * way[k][1]);
    }
  }
  if (n == 0 || !(close > 0.5 && out < 0.1)) {
    return whole;
  }
  out += 1 - sqrt((1 + close) / 2);
  for (int k = 0; k < 2; k++) {
    box.lo[k] -= out;
    box.hi[k] += out;
  }
  return box;
}

static arc
arc_at(const sg_spines *s, const spine *one, unsigned level, size_t at)
{
  sg_fan_triangle t;

  if (level == 0) {
    read_at(s, at, &t);
    return arc_of(one, s->by_place, &t);
  }
  return one->level[level][at];
}

/* False: no memory, or stopped. */
static bool
find_level(const sg_spines *s, spine *one, unsigned level,
           const sg_cancel *cancel)
{
  size_t n = s->tree->count[level], below = s->tree->count[level - 1];

  if (!(one->level[level] = malloc(n * sizeof(arc)))) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    arc all = arc_at(s, one, level - 1, i * SG_BVH_WIDTH);

    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    for (size_t k = i * SG_BVH_WIDTH + 1;
         k < (i + 1) * SG_BVH_WIDTH && k < below; k++) {
      arc next = arc_at(s, one, level - 1, k);

      for (int c = 0; c < 2; c++) {
        all.lo[c] = fmin(all.lo[c], next.lo[c]);
        all.hi[c] = fmax(all.hi[c], next.hi[c]);
      }
    }
    one->level[level][i] = all;
  }
  return true;
}

/* ---- the whole ---- */

bool
sg_spines_open(const sg_bvh *tree, sg_fan_read *read, const void *data,
               bool by_place, const sg_cancel *cancel, sg_spines **out)
{
  sg_spines *s = calloc(1, sizeof *s);
  bool good = s != NULL;

  *out = s;
  if (!good) {
    return false;
  }
  *s = (sg_spines){
      .tree = tree, .read = read, .data = data, .by_place = by_place};
  good = choose_spines(s, cancel);
  for (size_t i = 0; good && i < s->n; i++) {
    for (unsigned level = 1; level < tree->levels && good; level++) {
      good = find_level(s, &s->spine[i], level, cancel);
    }
  }
  if (good && s->n == 0) {
    sg_spines_close(s);
    *out = NULL;
  }
  return good;
}

void
sg_spines_close(sg_spines *spines)
{
  for (size_t i = 0; spines && i < spines->n; i++) {
    for (unsigned level = 0; level < SG_BVH_LEVELS; level++) {
      free(spines->spine[i].level[level]);
    }
  }
  free(spines);
}

bool
sg_spines_apart(const sg_spines *spines, unsigned level, size_t a, size_t b)
{
  for (size_t i = 0; i < spines->n; i++) {
    const arc *x = &spines->spine[i].level[level][a];
    const arc *y = &spines->spine[i].level[level][b];

    for (int k = 0; k < 2; k++) {
      if (x->lo[k] > y->hi[k] || y->lo[k] > x->hi[k]) {
        return true;
      }
    }
  }
  return false;
}
