/* regions_point.c -- another point of a part whose point is on others
 * (regions_walk.h).
 *
 * Any point of a part says where it is, as parts do not go through each other.
 * Faces that rounding has bent do, by less than what rounds
 * (polygon/flatness.h); so a point is wanted that is farther from all others:
 * the middle of a triangle, or else, of a part that encloses something, a point
 * a little inside. Where all middles say the same, they are right as they are.
 */
#include "regions_walk.h"

#include "join/bvh_join.h"
#include "number/vector.h"
#include "rows/disjoint.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How far inside, in what rounds. */
static const double DEEP = 4;

struct sg_walk_middle {
  uint32_t part, triangle;
  bool on, nearly, inside;
  int64_t away, around; /* of other parts, as sg_walk has it */
  sg_point at;
};

/* ---- near a triangle ---- */

static bool
is_near_triangle(const double at[3][3], const double p[3], double near)
{
  double u[3], w[3], normal[3], from[3];

  sg_minus(at[1], at[0], u);
  sg_minus(at[2], at[0], w);
  sg_cross(u, w, normal);
  sg_minus(p, at[0], from);
  double length = sg_any_length(normal);

  if (!(length > 0) || fabs(sg_dot(normal, from)) > near * length) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    double along[3], across[3];

    sg_minus(at[(k + 1) % 3], at[k], along);
    sg_minus(p, at[k], from);
    sg_cross(along, from, across);
    if (sg_dot(across, normal) < -near * length * sg_any_length(along)) {
      return false;
    }
  }
  return true;
}

static void
say_near(sg_walk *w, const sg_tour *way, const sg_bvh *points,
         const sg_bvh_hits *hits)
{
  w->nearly = true;
  for (size_t i = 0; i < hits->n; i++) {
    uint32_t stop = points->item[hits->hit[i].a];
    uint32_t item = way->tree->item[hits->hit[i].b];
    double at[3][3];

    way->corners(w, item, at);
    if (is_near_triangle((const double(*)[3])at, w->at[stop]->p, w->m->near)) {
      way->on(w, stop, item);
    }
  }
  w->nearly = false;
}

bool
sg_walk_nearly(sg_walk *w, const sg_tour *way)
{
  sg_box *box = malloc((w->stops + 1) * sizeof *box);
  sg_bvh_hits hits = {0};

  for (size_t i = 0; box && i < w->stops; i++) {
    box[i] = sg_box_none();
    sg_box_add(&box[i], w->at[i]->p);
  }
  sg_bvh *points = box ? sg_bvh_open(box, w->stops, w->m->cancel) : NULL;
  bool good = points && sg_bvh_join(&(sg_bvh_pair){points, way->tree}, 1,
                                    w->m->near, NULL, w->m->cancel, &hits);

  if (good) {
    say_near(w, way, points, &hits);
  }
  free(hits.hit);
  free(box);
  sg_bvh_close(points);
  return good || (sg_regions_asked(w->m) && sg_regions_no_memory(w->m));
}

/* ---- middles ---- */

static void
middle_on(void *data, size_t i, uint32_t item)
{
  sg_walk *w = data;
  sg_walk_middle *at = &w->middle[w->stop[i]];

  if (sg_walk_is_between(w, item, &w->part[at->part])) {
    *(w->nearly ? &at->nearly : &at->on) = true;
  }
}

static void
middle_there(void *data, size_t i)
{
  sg_walk *w = data;
  sg_walk_middle *at = &w->middle[w->stop[i]];
  const sg_walk_part *one = &w->part[at->part];
  int64_t own = sg_walk_own_away(w, one);

  at->inside = own != 0;
  at->away = w->away - own;
  at->around = w->around - own * ((int64_t)one->element + 1);
}

/* Of each root the part that is on another one, or SG_NOWHERE. */
static void
list_doubtful(const sg_walk *w, uint32_t *of)
{
  memset(of, 0xff, w->m->d->polygons * sizeof *of);
  for (uint32_t i = 0; i < w->parts; i++) {
    const sg_walk_part *one = &w->part[i];

    if ((one->on || one->nearly) && one->piece != SG_NOWHERE) {
      of[one->piece] = i;
    }
  }
}

/* The middles of all their triangles. */
static void
list_middles(sg_walk *w, const uint32_t *of)
{
  const sg_regions_maker *m = w->m;

  for (uint32_t t = 0; t < m->d->triangles; t++) {
    uint32_t p = (uint32_t)m->d->polygon_of[t];
    sg_walk_middle *one = &w->middle[w->middles];

    if (m->is_face[p] &&
        (one->part = of[sg_disjoint_root(m->piece, p)]) != SG_NOWHERE) {
      one->triangle = t;
      sg_walk_middle_of(m, t, &one->at);
      w->middles++;
    }
  }
}

static void
take_point(sg_walk_part *one, const sg_point *at, bool inside)
{
  sg_point_clear(&one->at);
  sg_point_copy(&one->at, at);
  one->moved = true;
  one->inside = inside;
}

/* Of each part the first that is far from others, or, if `inside`, that is just
 * inside of it. */
static void
choose_middles(sg_walk *w, bool inside)
{
  for (size_t i = 0; i < w->middles; i++) {
    const sg_walk_middle *at = &w->middle[i];
    sg_walk_part *one = &w->part[at->part];

    if (!one->moved && (inside ? at->inside : !at->on && !at->nearly)) {
      take_point(one, &at->at, inside);
    }
  }
}

/* ---- a little inside ---- */

/* Of each part that has no better point: bent[i], its middles are near others,
 * on none, and do not all say the same. */
static void
find_bent(const sg_walk *w, bool *bent, uint32_t *first)
{
  memset(first, 0xff, w->parts * sizeof *first);
  for (uint32_t i = 0; i < w->middles; i++) {
    const sg_walk_middle *at = &w->middle[i];

    if (first[at->part] == SG_NOWHERE) {
      first[at->part] = i;
    }
    const sg_walk_middle *other = &w->middle[first[at->part]];
    if (!w->part[at->part].moved &&
        (at->away != other->away || at->around != other->around)) {
      bent[at->part] = true;
    }
  }
}

/* `by`: 1 above the triangle, -1 below it. */
static void
point_beside(const sg_walk *w, const sg_walk_middle *at, double by,
             sg_point *out)
{
  const sg_dense *d = w->m->d;
  const int32_t *c = d->corner[at->triangle];
  double u[3], v[3], normal[3], p[3];

  sg_minus(d->at[c[1]], d->at[c[0]], u);
  sg_minus(d->at[c[2]], d->at[c[0]], v);
  sg_cross(u, v, normal);
  double length = sg_any_length(normal);

  for (int k = 0; k < 3; k++) {
    p[k] = at->at.p[k];
    p[k] += length > 0 ? by * DEEP * w->m->near * normal[k] / length : 0;
  }
  sg_point_set(out, p);
}

/* Moves all middles of bent parts to one side of their triangles; those of
 * other parts are where they were. */
static bool
go_beside(sg_walk *w, const sg_tour *way, const bool *bent, double by)
{
  w->stops = 0;
  for (uint32_t i = 0; i < w->middles; i++) {
    sg_walk_middle *at = &w->middle[i];

    if (bent[at->part] && !w->part[at->part].moved) {
      sg_point_clear(&at->at);
      sg_walk_middle_of(w->m, at->triangle, &at->at);
      sg_point beside;
      point_beside(w, at, by, &beside);
      sg_point_clear(&at->at);
      at->at = beside;
      at->on = at->nearly = at->inside = false;
      sg_walk_stop(w, i, &at->at);
    }
  }
  return sg_walk_over(w, way) && sg_walk_nearly(w, way);
}

static bool
move_inside(sg_walk *w, const sg_tour *way)
{
  bool *bent = calloc(w->parts + 1, sizeof *bent);
  uint32_t *first = malloc((w->parts + 1) * sizeof *first);
  bool good = (bent && first) || sg_regions_no_memory(w->m);

  if (good) {
    find_bent(w, bent, first);
  }
  for (int by = -1; by <= 1 && good; by += 2) {
    good = go_beside(w, way, bent, by);
    for (size_t i = 0; good && i < w->middles; i++) {
      const sg_walk_middle *at = &w->middle[i];
      sg_walk_part *one = &w->part[at->part];

      if (bent[at->part] && !one->moved && at->inside && !at->on &&
          !at->nearly) {
        take_point(one, &at->at, true);
      }
    }
  }
  free(bent);
  free(first);
  return good;
}

/* ---- together ---- */

static bool
make_room(sg_walk *w)
{
  size_t n = w->m->d->triangles + w->parts + 1;

  free(w->stop);
  free(w->at);
  w->stop = malloc(n * sizeof *w->stop);
  w->at = malloc(n * sizeof *w->at);
  w->middle = calloc(n, sizeof *w->middle);
  return (w->stop && w->at && w->middle) || sg_regions_no_memory(w->m);
}

bool
sg_walk_move_points(sg_walk *w, const sg_bvh *tree)
{
  const sg_tour way = {tree,         w,         sg_walk_corners,
                       sg_walk_pass, middle_on, middle_there};
  uint32_t *of = malloc((w->m->d->polygons + 1) * sizeof *of);

  if (!make_room(w) || !of) {
    free(of);
    return sg_regions_no_memory(w->m);
  }
  list_doubtful(w, of);
  list_middles(w, of);
  free(of);
  w->stops = 0;
  for (uint32_t i = 0; i < w->middles; i++) {
    sg_walk_stop(w, i, &w->middle[i].at);
  }
  if (!sg_walk_over(w, &way) || !sg_walk_nearly(w, &way)) {
    return false;
  }
  choose_middles(w, false);
  if (!move_inside(w, &way)) {
    return false;
  }
  choose_middles(w, true);
  return true;
}

void
sg_walk_clear_middles(sg_walk *w)
{
  for (size_t i = 0; i < w->middles; i++) {
    sg_point_clear(&w->middle[i].at);
  }
  free(w->middle);
}
