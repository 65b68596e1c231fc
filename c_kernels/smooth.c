/* smooth.c -- see smooth.h */
#include "smooth.h"

#include "bounds.h"
#include "vector.h"

#include <math.h>
#include <stdlib.h>

/* Degrees: what counts as flat (as in parts.c). */
#define FLAT    0.01
#define DEGREES (180.0 / acos(-1.0))

/* Two bends go on in one line if they turn by less than this, in radians. */
#define STRAIGHT 0.02

enum { POLL_EVERY = 4096 };

typedef struct builder {
  const sg_dense *in;
  const sg_smooth_input *input;
  sg_smooth *out;
  const sg_poll *poll;
  sg_known_surfaces known; /* none, if all facets are to be seen */
  double unit;       /* what differences are multiplied by: see unit_of() */
  double (*area)[3]; /* [polygons]: normals, as long as twice the area */
  double *bend;      /* [3 * triangles]: degrees at smooth sides */
  uint32_t *sheet;   /* [triangles]: another one of it, in the end its root */
  uint32_t *root;    /* [3 * triangles]: the same of corners and fans */
} builder;

static uint32_t
next_corner(uint32_t corner)
{
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

static uint32_t
vertex_of(const builder *b, uint32_t corner)
{
  return (uint32_t)b->in->corner[corner / 3][corner % 3];
}

static const double *
at_corner(const builder *b, uint32_t corner)
{
  return b->in->at[vertex_of(b, corner)];
}

/* A power of two that makes the coordinates of the model at most 1: products
 * of areas neither overflow nor vanish, however large or small the model is. */
static double
unit_of(const sg_dense *d)
{
  double most = 0.0;
  int exponent;

  for (size_t i = 0; i < d->vertices; i++) {
    for (int k = 0; k < 3; k++) {
      most = sg_larger(most, fabs(d->at[i][k]));
    }
  }
  frexp(most, &exponent);
  return ldexp(1.0, exponent < -1022 ? 1022 : -exponent);
}

/* From q to p, times the unit. */
static void
difference(const builder *b, const double p[3], const double q[3],
           double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = (p[k] - q[k]) * b->unit;
  }
}

static bool
stop(const builder *b, size_t i)
{
  return i % POLL_EVERY == 0 && sg_poll_stop(b->poll);
}

/* ----------------------------------------------------------------- faces */

static void
add_areas(builder *b)
{
  for (size_t t = 0; t < b->in->triangles; t++) {
    const double *p = at_corner(b, (uint32_t)(3 * t));
    double u[3], w[3], n[3];
    difference(b, at_corner(b, (uint32_t)(3 * t + 1)), p, u);
    difference(b, at_corner(b, (uint32_t)(3 * t + 2)), p, w);
    sg_cross(u, w, n);
    for (int k = 0; k < 3; k++) {
      b->area[b->in->polygon_of[t]][k] += n[k];
    }
  }
}

static const double *
area_of(const builder *b, uint32_t corner)
{
  return b->area[b->in->polygon_of[corner / 3]];
}

/* ----------------------------------------------------------------- sides */

/* A side, or a piece of a penetration line, by its larger vertex. */
typedef struct entry {
  uint32_t high;
  uint32_t side; /* SG_NO_SIDE: a line */
} entry;

typedef struct entries {
  size_t *start; /* [vertices + 1]: those of each smaller vertex */
  entry *item;
} entries;

static int
entry_compare(const void *a, const void *b)
{
  const entry *x = a, *y = b;

  return x->high != y->high ? (x->high > y->high) - (x->high < y->high)
                            : (x->side > y->side) - (x->side < y->side);
}

static void
sort_entries(entry *item, size_t n)
{
  if (n > 24) {
    qsort(item, n, sizeof *item, entry_compare);
    return;
  }
  for (size_t i = 1; i < n; i++) {
    entry x = item[i];
    size_t j = i;
    for (; j > 0 && entry_compare(&x, &item[j - 1]) < 0; j--) {
      item[j] = item[j - 1];
    }
    item[j] = x;
  }
}

static void
put_entry(entries *e, uint32_t v, uint32_t w, uint32_t side, bool count)
{
  uint32_t low = v < w ? v : w;

  if (count) {
    e->start[low + 1]++;
  } else {
    e->item[e->start[low]++] = (entry){v < w ? w : v, side};
  }
}

static void
put_entries(const builder *b, entries *e, bool count)
{
  for (size_t i = 0; i < 3 * b->in->triangles; i++) {
    uint32_t side = (uint32_t)i;
    put_entry(e, vertex_of(b, side), vertex_of(b, next_corner(side)), side,
              count);
  }
  for (size_t i = 0; i < b->input->cuts; i++) {
    const uint32_t *cut = b->input->cut[i];
    put_entry(e, cut[0], cut[1], SG_NO_SIDE, count);
  }
}

/* Degrees by which two faces bend; a face without area does not. */
static double
bend_between(const double a[3], const double b[3])
{
  return sg_dot(a, a) > 0.0 && sg_dot(b, b) > 0.0 ? sg_angle(a, b) * DEGREES
                                                  : 0.0;
}

static bool
is_convex(const builder *b, uint32_t side, uint32_t other)
{
  double u[3];

  difference(b, at_corner(b, next_corner(next_corner(other))),
             at_corner(b, side), u);
  return sg_dot(u, area_of(b, side)) <= 0.0;
}

/* Degrees by which the surfaces bend whose faces bend by so many. */
static double
surface_bend(const builder *b, uint32_t i, uint32_t j, double bend)
{
  const sg_meeting meeting = {
      .polygon = {b->in->polygon_of[i / 3], b->in->polygon_of[j / 3]},
      .normal = {area_of(b, i), area_of(b, j)},
      .ends = {at_corner(b, i), at_corner(b, next_corner(i))},
      .bend = bend};

  return sg_known_surfaces_bend(&b->known, &meeting);
}

static int32_t
surface_of(const builder *b, uint32_t corner)
{
  return sg_known_surface_of(&b->known, b->in->polygon_of[corner / 3]);
}

/* Whether the sheet goes on across the side of triangles i and j. */
static bool
hangs_together(const builder *b, uint32_t i, uint32_t j, double bend, bool cut)
{
  if (cut && (surface_of(b, i) < 0 || surface_of(b, i) != surface_of(b, j))) {
    return bend <= FLAT;
  }
  return surface_bend(b, i, j, bend) <= b->input->crease + SG_SMOOTH_OVER;
}

static void
join_sides(builder *b, uint32_t i, uint32_t j, bool cut)
{
  sg_smooth *out = b->out;
  double bend = bend_between(area_of(b, i), area_of(b, j));
  bool smooth = hangs_together(b, i, j, bend, cut);

  if (vertex_of(b, i) == vertex_of(b, j)) {
    return; /* one of them is turned over */
  }
  out->across[i] = j;
  out->across[j] = i;
  b->bend[i] = b->bend[j] = bend;
  out->side[i] = (uint8_t)((smooth ? SG_SIDE_SMOOTH : 0) |
                           (is_convex(b, i, j) ? SG_SIDE_CONVEX : 0));
  out->side[j] = (uint8_t)((smooth ? SG_SIDE_SMOOTH : 0) |
                           (is_convex(b, j, i) ? SG_SIDE_CONVEX : 0));
}

/* The sides between two vertices, sorted: lines come last. */
static void
join_group(builder *b, const entry *item, size_t n)
{
  size_t sides = n;

  while (sides > 0 && item[sides - 1].side == SG_NO_SIDE) {
    sides--;
  }
  if (sides == 2) {
    join_sides(b, item[0].side, item[1].side, sides < n);
  }
}

static bool
join_all(builder *b, entries *e)
{
  size_t from = 0;

  for (size_t v = 0; v < b->in->vertices; v++) {
    size_t to = e->start[v]; /* where the next vertex's begin, by now */
    if (stop(b, v)) {
      return false;
    }
    sort_entries(e->item + from, to - from);
    for (size_t i = from, j; i < to; i = j) {
      for (j = i + 1; j < to && e->item[j].high == e->item[i].high; j++) {
      }
      join_group(b, e->item + i, j - i);
    }
    from = to;
  }
  return true;
}

static bool
find_sides(builder *b, bool *memory)
{
  entries e = {.start = calloc(b->in->vertices + 2, sizeof *e.start),
               .item = malloc((3 * b->in->triangles + b->input->cuts + 1) *
                              sizeof *e.item)};
  bool done = false;

  *memory = e.start && e.item;
  if (*memory) {
    put_entries(b, &e, true);
    for (size_t v = 0; v < b->in->vertices; v++) {
      e.start[v + 1] += e.start[v];
    }
    put_entries(b, &e, false);
    done = join_all(b, &e);
  }
  free(e.start);
  free(e.item);
  return done;
}

/* ------------------------------------------------------ sheets and fans */

static uint32_t
root_of(uint32_t *parent, uint32_t i)
{
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

static void
unite(uint32_t *parent, uint32_t i, uint32_t j)
{
  i = root_of(parent, i);
  j = root_of(parent, j);
  if (i < j) {
    parent[j] = i;
  } else {
    parent[i] = j;
  }
}

static void
find_sheets(builder *b)
{
  size_t sides = 3 * b->in->triangles;

  for (size_t i = 0; i < sides; i++) {
    b->root[i] = (uint32_t)i;
    b->sheet[i / 3] = (uint32_t)(i / 3);
  }
  for (size_t i = 0; i < sides; i++) {
    uint32_t j = b->out->across[i];
    if (j > i && (b->out->side[i] & SG_SIDE_SMOOTH)) {
      unite(b->sheet, (uint32_t)i / 3, j / 3);
      unite(b->root, (uint32_t)i, next_corner(j));
      unite(b->root, next_corner((uint32_t)i), j);
    }
  }
}

static void
number_fans(builder *b)
{
  uint32_t *fan = b->out->fan;

  for (size_t i = 0; i < 3 * b->in->triangles; i++) {
    uint32_t root = root_of(b->root, (uint32_t)i); /* the smallest of them */
    fan[i] = root == i ? (uint32_t)b->out->fans++ : fan[root];
  }
}

/* --------------------------------------------------------------- normals */

/* The way the surface looks at a corner, as long as the area of its face. */
static void
look_at_corner(const builder *b, uint32_t i, double out[3])
{
  const sg_known_surfaces *known = &b->known;
  const double *area = area_of(b, i);
  int32_t of = surface_of(b, i);
  double size = 1.0;

  if (of >= 0 && sg_known_surface_normal(&known->surface[of], at_corner(b, i),
                                         area, out)) {
    size = sg_length(area);
    area = out;
  }
  for (int k = 0; k < 3; k++) {
    out[k] = size * area[k];
  }
}

static void
add_corner(const builder *b, uint32_t i)
{
  const double *p = at_corner(b, i);
  double *normal = b->out->normal[b->out->fan[i]];
  double area[3], u[3], w[3], weight;

  look_at_corner(b, i, area);
  difference(b, at_corner(b, next_corner(i)), p, u);
  difference(b, at_corner(b, next_corner(next_corner(i))), p, w);
  weight = sg_angle(u, w);
  for (int k = 0; k < 3; k++) {
    normal[k] += weight * area[k];
  }
}

/* False: stopped. */
static bool
find_normals(builder *b)
{
  sg_smooth *out = b->out;
  double most = cos(sg_smaller(b->input->crease, 90.0) / DEGREES);

  for (size_t i = 0; i < 3 * b->in->triangles; i++) {
    if (stop(b, i)) {
      return false;
    }
    add_corner(b, (uint32_t)i);
  }
  for (size_t f = 0; f < out->fans; f++) {
    double size = sqrt(sg_dot(out->normal[f], out->normal[f]));
    for (int k = 0; k < 3 && size > 0.0; k++) {
      out->normal[f][k] /= size;
    }
  }
  for (size_t i = 0; i < 3 * b->in->triangles; i++) {
    double area[3], size;
    look_at_corner(b, (uint32_t)i, area);
    size = sg_length(area);
    out->apex[out->fan[i]] |=
        sg_dot(area, out->normal[out->fan[i]]) < most * size;
  }
  return !sg_poll_stop(b->poll);
}

/* ---------------------------------------------------------------- curved */

/* How a fan bends. */
typedef struct turning {
  uint32_t corners, links; /* as many as corners: it goes all round */
  uint32_t bends;
  double sum[3];   /* of the directions of the bends from the vertex */
  int32_t surface; /* of its last corner */
  bool folded;     /* all its corners are of one tapered surface */
} turning;

static void
add_link(const builder *b, turning *turn, uint32_t side, uint32_t from,
         uint32_t to)
{
  turning *t = &turn[b->out->fan[from]];
  double u[3], size;

  t->links++;
  if (b->bend[side] > FLAT) {
    difference(b, at_corner(b, to), at_corner(b, from), u);
    size = sg_length(u);
    t->bends++;
    for (int k = 0; k < 3 && size > 0.0; k++) {
      t->sum[k] += u[k] / size;
    }
  }
}

static bool
bends_both_ways(const turning *t)
{
  return !t->folded && t->links == t->corners &&
         (t->bends > 2 ||
          (t->bends == 2 && sg_dot(t->sum, t->sum) > STRAIGHT * STRAIGHT));
}

/* Whether a corner is of a known surface that is folded along straight lines,
 * or of one that is not. */
static bool
is_tapered(const builder *b, uint32_t corner)
{
  int32_t of = surface_of(b, corner);

  return of >= 0 && b->known.surface[of].kind == SG_KNOWN_TAPERED;
}

static bool
is_round(const builder *b, uint32_t corner)
{
  int32_t of = surface_of(b, corner);
  sg_known_surface_kind kind =
      of < 0 ? SG_KNOWN_FREE : b->known.surface[of].kind;

  return kind == SG_KNOWN_SPHERE || kind == SG_KNOWN_TORUS;
}

static void
add_surface(const builder *b, turning *t, uint32_t corner)
{
  int32_t surface = surface_of(b, corner);

  t->folded = t->corners == 0 ? is_tapered(b, corner)
                              : t->folded && surface == t->surface;
  t->surface = surface;
}

static bool
find_curved(builder *b)
{
  sg_smooth *out = b->out;
  turning *turn = calloc(out->fans + 1, sizeof *turn);

  if (!turn) {
    return false;
  }
  for (uint32_t i = 0; i < 3 * b->in->triangles; i++) {
    add_surface(b, &turn[out->fan[i]], i);
    turn[out->fan[i]].corners++;
    if ((out->side[i] & SG_SIDE_SMOOTH) && out->across[i] > i) {
      add_link(b, turn, i, i, next_corner(i));
      add_link(b, turn, i, next_corner(i), i);
    }
  }
  for (uint32_t i = 0; i < 3 * b->in->triangles; i++) {
    uint32_t fan = out->fan[i];
    out->curved[root_of(b->sheet, i / 3)] |=
        is_round(b, i) || (!out->apex[fan] && bends_both_ways(&turn[fan]));
  }
  for (uint32_t t = 0; t < b->in->triangles; t++) {
    out->curved[t] = out->curved[root_of(b->sheet, t)];
  }
  free(turn);
  return true;
}

/* -------------------------------------------------------------- building */

static bool
make_room(builder *b)
{
  size_t triangles = b->in->triangles, sides = 3 * triangles;
  sg_smooth *out = b->out;

  b->area = calloc(b->in->polygons + 1, sizeof *b->area);
  b->bend = calloc(sides + 1, sizeof *b->bend);
  b->sheet = malloc((triangles + 1) * sizeof *b->sheet);
  b->root = malloc((sides + 1) * sizeof *b->root);
  out->across = malloc((sides + 1) * sizeof *out->across);
  out->side = calloc(sides + 1, sizeof *out->side);
  out->fan = malloc((sides + 1) * sizeof *out->fan);
  out->curved = calloc(triangles + 1, sizeof *out->curved);
  return b->area && b->bend && b->sheet && b->root && out->across &&
         out->side && out->fan && out->curved;
}

/* False: stopped, or no memory. */
static bool
make_fans(builder *b, bool *memory)
{
  sg_smooth *out = b->out;

  find_sheets(b);
  number_fans(b);
  out->normal = calloc(out->fans + 1, sizeof *out->normal);
  out->apex = calloc(out->fans + 1, sizeof *out->apex);
  *memory = out->normal && out->apex;
  return *memory && !sg_poll_stop(b->poll) && find_normals(b) &&
         (*memory = find_curved(b));
}

bool
sg_smooth_init(sg_smooth *smooth, const sg_smooth_input *input,
               const sg_poll *poll, bool *memory)
{
  builder b = {.in = input->dense, .input = input, .out = smooth, .poll = poll};
  bool done = false;

  *smooth = (sg_smooth){0};
  if (input->crease >= SG_FACET_BEND) {
    b.known = input->surfaces;
  }
  b.unit = unit_of(input->dense);
  *memory = make_room(&b);
  if (*memory) {
    for (size_t i = 0; i < 3 * input->dense->triangles; i++) {
      smooth->across[i] = SG_NO_SIDE;
    }
    add_areas(&b);
    done = !sg_poll_stop(poll) && find_sides(&b, memory) &&
           !sg_poll_stop(poll) && make_fans(&b, memory);
  }
  free(b.area);
  free(b.bend);
  free(b.sheet);
  free(b.root);
  if (!done) {
    sg_smooth_clear(smooth);
  }
  return done;
}

void
sg_smooth_clear(sg_smooth *smooth)
{
  free(smooth->across);
  free(smooth->side);
  free(smooth->fan);
  free(smooth->curved);
  free(smooth->normal);
  free(smooth->apex);
  *smooth = (sg_smooth){0};
}
