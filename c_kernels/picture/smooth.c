/* smooth.c -- see smooth.h */
#include "engine/search.h"
#include "smooth_private.h"

#include "number/bounds.h"
#include "number/vector.h"
#include "rows/disjoint.h"

#include <stdlib.h>

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

/* ----------------------------------------------------------------- faces */

static void
add_areas(sg_smooth_builder *b)
{
  for (size_t t = 0; t < b->in->triangles; t++) {
    const double *p = sg_smooth_at(b, (uint32_t)(3 * t));
    double u[3], w[3], n[3];
    sg_smooth_difference(b, sg_smooth_at(b, (uint32_t)(3 * t + 1)), p, u);
    sg_smooth_difference(b, sg_smooth_at(b, (uint32_t)(3 * t + 2)), p, w);
    sg_cross(u, w, n);
    for (int k = 0; k < 3; k++) {
      b->area[b->in->polygon_of[t]][k] += n[k];
    }
  }
}

static const double *
area_of(const sg_smooth_builder *b, uint32_t corner)
{
  return b->area[b->in->polygon_of[corner / 3]];
}

/* ----------------------------------------------------------------- sides */

/* A crease goes on there. */
#define CREASE_ON (SG_NO_SIDE - 1)

/* A side, a piece of a penetration line, or a crease, by its larger vertex. */
typedef struct entry {
  uint32_t high;
  uint32_t side; /* SG_NO_SIDE: a line; CREASE_ON */
} entry;

typedef struct entries {
  size_t *start; /* [vertices + 1]: those of each smaller vertex */
  entry *item;
} entries;

SG_ORDER(entry_compare, entry, SG_BY(high) SG_BY(side));

static void
sort_entries(entry *item, size_t n)
{
  if (n > 24) {
    qsort(item, n, sizeof *item, entry_compare);
    return;
  }
  SG_SORT_FEW(entry, item, n, entry_compare(x, y) > 0);
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
put_entries(const sg_smooth_builder *b, entries *e, bool count)
{
  for (size_t i = 0; i < 3 * b->in->triangles; i++) {
    uint32_t side = (uint32_t)i;
    put_entry(e, sg_smooth_vertex(b, side),
              sg_smooth_vertex(b, sg_smooth_next(side)), side, count);
  }
  for (size_t i = 0; i < b->input->cuts; i++) {
    const uint32_t *cut = b->input->cut[i];
    put_entry(e, cut[0], cut[1], SG_NO_SIDE, count);
  }
  for (size_t i = 0; i < b->input->creases_on; i++) {
    const uint32_t *crease = b->input->crease_on[i];
    put_entry(e, crease[0], crease[1], CREASE_ON, count);
  }
}

/* Degrees by which two faces bend; a face without area does not. */
static double
bend_between(const double a[3], const double b[3])
{
  return sg_dot(a, a) > 0.0 && sg_dot(b, b) > 0.0 ? sg_angle(a, b) * SG_DEGREES
                                                  : 0.0;
}

static bool
is_convex(const sg_smooth_builder *b, uint32_t side, uint32_t other)
{
  double u[3];

  sg_smooth_difference(b,
                       sg_smooth_at(b, sg_smooth_next(sg_smooth_next(other))),
                       sg_smooth_at(b, side), u);
  return sg_dot(u, area_of(b, side)) <= 0.0;
}

/* How the surfaces bend whose faces bend by so many degrees. */
static sg_bend
surface_bend(const sg_smooth_builder *b, uint32_t i, uint32_t j, double bend)
{
  const sg_facets_meeting meeting = {
      .dense = b->in,
      .polygon = {b->in->polygon_of[i / 3], b->in->polygon_of[j / 3]},
      .normal = {area_of(b, i), area_of(b, j)},
      .ends = {sg_smooth_at(b, i), sg_smooth_at(b, sg_smooth_next(i))},
      .bend = bend};

  return sg_known_surfaces_bend(&b->known, &meeting);
}

/* What runs along a side. */
typedef struct along {
  bool cut, crease;
} along;

/* Whether the sheet goes on across the side of triangles i and j. */
static bool
hangs_together(const sg_smooth_builder *b, uint32_t i, uint32_t j, double bend,
               along runs)
{
  if (runs.crease) {
    return false;
  }
  if (runs.cut && (sg_smooth_surface(b, i) < 0 ||
                   sg_smooth_surface(b, i) != sg_smooth_surface(b, j))) {
    return bend <= SG_FLAT_BEND;
  }
  sg_bend known = surface_bend(b, i, j, bend);
  return !known.edge && known.degrees <= b->input->crease + SG_SMOOTH_OVER;
}

/* The normal of the triangle of a corner, as long as twice its area. */
static void
triangle_normal(const sg_smooth_builder *b, uint32_t corner, double out[3])
{
  const double *p = sg_smooth_at(b, corner);
  uint32_t next = sg_smooth_next(corner);
  double u[3], w[3];

  sg_smooth_difference(b, sg_smooth_at(b, next), p, u);
  sg_smooth_difference(b, sg_smooth_at(b, sg_smooth_next(next)), p, w);
  sg_cross(u, w, out);
}

/* Whether the polygon that two triangles are of is folded between them. */
static bool
is_fold(const sg_smooth_builder *b, uint32_t i, uint32_t j)
{
  double m[3], n[3];

  if (b->in->polygon_of[i / 3] != b->in->polygon_of[j / 3]) {
    return false;
  }
  triangle_normal(b, i, m);
  triangle_normal(b, j, n);
  return bend_between(m, n) > SG_FACET_BEND;
}

static uint8_t
convex_flag(const sg_smooth_builder *b, uint32_t i, uint32_t j)
{
  return is_convex(b, i, j) ? SG_SIDE_CONVEX : 0;
}

static void
join_sides(sg_smooth_builder *b, uint32_t i, uint32_t j, along runs)
{
  sg_smooth *out = b->out;
  double bend = bend_between(area_of(b, i), area_of(b, j));
  bool smooth = hangs_together(b, i, j, bend, runs);

  if (sg_smooth_vertex(b, i) == sg_smooth_vertex(b, j)) {
    return; /* one of them is turned over */
  }
  out->across[i] = j;
  out->across[j] = i;
  b->bend[i] = b->bend[j] = bend;
  uint8_t both =
      (uint8_t)((smooth ? SG_SIDE_SMOOTH : 0) | (runs.cut ? SG_SIDE_CUT : 0) |
                (is_fold(b, i, j) ? SG_SIDE_FOLD : 0));
  out->side[i] = both | convex_flag(b, i, j);
  out->side[j] = both | convex_flag(b, j, i);
}

/* The sides between two vertices, sorted: creases and lines come last. */
static void
join_group(sg_smooth_builder *b, const entry *item, size_t n)
{
  along runs = {.cut = n > 0 && item[n - 1].side == SG_NO_SIDE};
  size_t sides = n;

  while (sides > 0 && item[sides - 1].side >= CREASE_ON) {
    runs.crease |= item[--sides].side == CREASE_ON;
  }
  if (sides == 2) {
    join_sides(b, item[0].side, item[1].side, runs);
  }
}

static bool
join_all(sg_smooth_builder *b, entries *e)
{
  size_t from = 0;

  for (size_t v = 0; v < b->in->vertices; v++) {
    size_t to = e->start[v]; /* where the next vertex's begin, by now */
    if (sg_smooth_stop(b, v)) {
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
find_sides(sg_smooth_builder *b, bool *memory)
{
  entries e = {.start = calloc(b->in->vertices + 2, sizeof *e.start),
               .item = malloc((3 * b->in->triangles + b->input->cuts +
                               b->input->creases_on + 1) *
                              sizeof *e.item)};
  bool done = false;

  *memory = e.start && e.item;
  if (*memory) {
    put_entries(b, &e, true);
    for (size_t v = 0; v < b->in->vertices; v++) {
      e.start[v + 1] += e.start[v];
    }
    put_entries(b, &e, false);
    done = !sg_cancelled(b->cancel) && join_all(b, &e);
  }
  free(e.start);
  free(e.item);
  return done;
}

/* ------------------------------------------------------ sheets and fans */

static void
find_sheets(sg_smooth_builder *b)
{
  size_t sides = 3 * b->in->triangles;

  for (size_t i = 0; i < sides; i++) {
    b->root[i] = (uint32_t)i;
    b->sheet[i / 3] = (uint32_t)(i / 3);
  }
  for (size_t i = 0; i < sides; i++) {
    uint32_t j = b->out->across[i];
    if (j > i && (b->out->side[i] & SG_SIDE_SMOOTH)) {
      sg_disjoint_join(b->sheet, (uint32_t)i / 3, j / 3);
      sg_disjoint_join(b->root, (uint32_t)i, sg_smooth_next(j));
      sg_disjoint_join(b->root, sg_smooth_next((uint32_t)i), j);
    }
  }
}

static void
number_fans(sg_smooth_builder *b)
{
  uint32_t *fan = b->out->fan;

  for (size_t i = 0; i < 3 * b->in->triangles; i++) {
    uint32_t root =
        sg_disjoint_root(b->root, (uint32_t)i); /* the smallest of them */
    fan[i] = root == i ? (uint32_t)b->out->fans++ : fan[root];
  }
}

/* --------------------------------------------------------------- normals */

/* The way the surface looks at a corner, as long as the area of its face. */
static void
find_look(const sg_smooth_builder *b, uint32_t i, double out[3])
{
  const sg_known_surfaces *known = &b->known;
  const double *area = area_of(b, i);
  int32_t of = sg_smooth_surface(b, i);
  double size = 1.0;

  if (of >= 0 && sg_known_surface_normal(&known->surface[of],
                                         sg_smooth_at(b, i), area, out)) {
    size = sg_length(area);
    area = out;
  }
  for (int k = 0; k < 3; k++) {
    out[k] = size * area[k];
  }
}

static void
add_corner(const sg_smooth_builder *b, uint32_t i)
{
  const double *p = sg_smooth_at(b, i);
  double *normal = b->out->normal[b->out->fan[i]], *look = b->look[i];
  double u[3], w[3], weight;

  find_look(b, i, look);
  sg_smooth_difference(b, sg_smooth_at(b, sg_smooth_next(i)), p, u);
  sg_smooth_difference(b, sg_smooth_at(b, sg_smooth_next(sg_smooth_next(i))), p,
                       w);
  weight = sg_angle(u, w);
  for (int k = 0; k < 3; k++) {
    normal[k] += weight * look[k];
  }
}

/* False: stopped. */
static bool
find_normals(sg_smooth_builder *b)
{
  sg_smooth *out = b->out;
  double most = cos(sg_smaller(b->input->crease, 90.0) / SG_DEGREES);

  for (size_t i = 0; i < 3 * b->in->triangles; i++) {
    if (sg_smooth_stop(b, i)) {
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
    const double *look = b->look[i];
    if (sg_smooth_stop(b, i)) {
      return false;
    }
    out->apex[out->fan[i]] |=
        sg_dot(look, out->normal[out->fan[i]]) < most * sg_length(look);
  }
  return !sg_cancelled(b->cancel);
}

/* --------------------------------------------------------- known surfaces */

/* How far the surface of a corner is above it. */
static void
sink(const sg_smooth_builder *b, uint32_t i)
{
  int32_t of = sg_smooth_surface(b, i);
  double *sunk = &b->out->sunk[b->out->fan[i]], height;

  if (of >= 0 &&
      sg_known_surface_height(&b->known.surface[of], sg_smooth_at(b, i),
                              area_of(b, i), &height) &&
      fabs(height) > fabs(*sunk)) {
    *sunk = height;
  }
}

/* Of each fan: a penetration line ends there; one runs through its sheet. */
typedef struct line_at {
  bool end, through;
} line_at;

/* Whether a triangle stands on a known surface, with all corners or by as much
 * as they are sunk. Where a line runs through the sheet, outline and line meet
 * in the facets, or the other surface would part them. */
static bool
stands(const sg_smooth_builder *b, const line_at *line, uint32_t t)
{
  int32_t of = sg_smooth_surface(b, 3 * t);
  bool measured =
      of >= 0 && sg_known_surface_is_measured(&b->known.surface[of]);

  for (uint32_t i = 3 * t; i < 3 * t + 3; i++) {
    const line_at *at = &line[b->out->fan[i]];
    if (at->through || (at->end && !measured)) {
      return false;
    }
  }
  return of >= 0;
}

/* cut: the vertices at which penetration lines end. */
static void
find_lines(sg_smooth_builder *b, const bool *cut, line_at *line)
{
  const sg_smooth *out = b->out;

  for (uint32_t i = 0; i < 3 * b->in->triangles; i++) {
    line[out->fan[i]].end |= cut[sg_smooth_vertex(b, i)];
    if ((out->side[i] & SG_SIDE_SMOOTH) && (out->side[i] & SG_SIDE_CUT)) {
      line[out->fan[i]].through = true;
      line[out->fan[sg_smooth_next(i)]].through = true;
    }
  }
}

static void
mark_known(sg_smooth_builder *b, const line_at *line)
{
  sg_smooth *out = b->out;

  for (uint32_t i = 0; i < 3 * b->in->triangles; i++) {
    if (out->curved[i / 3] && line[out->fan[i]].end) {
      sink(b, i);
    }
    if (out->curved[i / 3] && (out->side[i] & SG_SIDE_SMOOTH) &&
        stands(b, line, i / 3) && stands(b, line, out->across[i] / 3)) {
      out->side[i] |= SG_SIDE_KNOWN;
    }
  }
}

/* False: no memory. */
static bool
find_known(sg_smooth_builder *b)
{
  bool *cut;
  line_at *line;

  if (b->known.n == 0) {
    return true;
  }
  cut = calloc(b->in->vertices + 1, sizeof *cut);
  line = calloc(b->out->fans + 1, sizeof *line);
  if (cut && line) {
    for (size_t i = 0; i < b->input->cuts; i++) {
      cut[b->input->cut[i][0]] = cut[b->input->cut[i][1]] = true;
    }
    find_lines(b, cut, line);
    mark_known(b, line);
  }
  free(cut);
  free(line);
  return cut && line;
}

/* -------------------------------------------------------------- building */

static bool
make_room(sg_smooth_builder *b)
{
  size_t triangles = b->in->triangles, sides = 3 * triangles;
  sg_smooth *out = b->out;

  b->area = calloc(b->in->polygons + 1, sizeof *b->area);
  b->bend = calloc(sides + 1, sizeof *b->bend);
  b->look = malloc((sides + 1) * sizeof *b->look);
  b->sheet = malloc((triangles + 1) * sizeof *b->sheet);
  b->root = malloc((sides + 1) * sizeof *b->root);
  out->across = malloc((sides + 1) * sizeof *out->across);
  out->side = calloc(sides + 1, sizeof *out->side);
  out->fan = malloc((sides + 1) * sizeof *out->fan);
  out->curved = calloc(triangles + 1, sizeof *out->curved);
  out->coarse = calloc(triangles + 1, sizeof *out->coarse);
  return b->area && b->bend && b->look && b->sheet && b->root && out->across &&
         out->side && out->fan && out->curved && out->coarse;
}

/* False: stopped, or no memory. */
static bool
make_fans(sg_smooth_builder *b, bool *memory)
{
  sg_smooth *out = b->out;

  find_sheets(b);
  number_fans(b);
  out->normal = calloc(out->fans + 1, sizeof *out->normal);
  out->apex = calloc(out->fans + 1, sizeof *out->apex);
  out->sunk = calloc(out->fans + 1, sizeof *out->sunk);
  *memory = out->normal && out->apex && out->sunk;
  return *memory && !sg_cancelled(b->cancel) && find_normals(b) &&
         sg_smooth_find_bent(b, memory) && sg_smooth_find_coarse(b, memory) &&
         (*memory = find_known(b)) && !sg_cancelled(b->cancel);
}

bool
sg_smooth_init(sg_smooth *smooth, const sg_smooth_input *input,
               const sg_cancel *cancel, bool *memory)
{
  sg_smooth_builder b = {
      .in = input->dense, .input = input, .out = smooth, .cancel = cancel};
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
    done = !sg_cancelled(cancel) && find_sides(&b, memory) &&
           !sg_cancelled(cancel) && make_fans(&b, memory);
  }
  free(b.area);
  free(b.bend);
  free(b.look);
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
  free(smooth->coarse);
  free(smooth->normal);
  free(smooth->apex);
  free(smooth->sunk);
  *smooth = (sg_smooth){0};
}
