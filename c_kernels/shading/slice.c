/* slice.c -- what the plane of a scan line cuts out of the faces of leaves. */
#include "shading_private.h"

#include "engine/search.h"
#include "number/bounds.h"

#include <math.h>
#include <string.h>

/* Faces this near to edge-on bound a body in the picture, not in depth. */
#define ACROSS 1e-9

/* A quadric with less of z^2 than this has as much: what lies along the line of
 * sight leaves the body far away, where planes bound it. */
#define LEAST_DEEP 1e-8

/* Ends of slices in 1/256 dot. Halves that are rounded otherwise in two faces
 * are no halves: what is a little less counts as one. */
int32_t
sg_slice_end(const sg_shading_work *w, double x)
{
  int32_t width = w->scene->frame.width;

  return !(x > 0)    ? 0
         : x < width ? (int32_t)(x * 256.0 + (0.5 + 1e-6))
                     : width * 256;
}

static bool
add_slice(sg_shading_work *w, const sg_slice *slice)
{
  if (slice->x1 >= slice->x2) {
    return true;
  }
  if (!SG_PUSH(w->slice, *slice)) {
    w->failed = true;
    return false;
  }
  return true;
}

/* The line of a plane at y. */
static void
slice_plane(const sg_shading *scene, const sg_shading_surface *plane, double y,
            sg_slice *out)
{
  const double *q = plane->q, *at = scene->middle;

  out->arc = 0;
  out->x0 = at[0];
  out->a = at[2] - (q[1] * (y - at[1]) + q[3]) / q[2];
  out->b = -q[0] / q[2];
}

/* ---- polygons ---- */

typedef sg_slice_corner corner;

/* A plane that is seen edge-on: between its edges. */
static void
slice_between(const corner *from, const corner *to, sg_slice *out)
{
  out->arc = 0;
  out->x0 = from->x;
  out->a = from->z;
  out->b = to->x > from->x ? (to->z - from->z) / (to->x - from->x) : 0.0;
}

static void
sort_corners(corner *all, size_t n)
{
  SG_SORT_FEW(corner, all, n, x->x > y->x);
}

/* Where an edge meets the line, which is above `low` or at it. */
static corner
meet_edge(const double low[3], const double high[3], double y)
{
  double part = (y - low[1]) / (high[1] - low[1]);

  return (corner){low[0] + part * (high[0] - low[0]),
                  low[2] + part * (high[2] - low[2])};
}

/* Where edges cross the line, from left to right. False: no memory. */
static bool
find_corners(sg_shading_work *w, const sg_shading_polygon *p, double y)
{
  const sg_shading *s = w->scene;
  const uint32_t *of = s->corner_of.item + p->corner;
  const double *before = NULL;
  bool was_low = false;

  w->crossing.n = 0;
  if (!sg_list_need(&w->crossing.item, p->corners, &w->crossing.room,
                    sizeof *w->crossing.item)) {
    w->failed = true;
    return false;
  }
  for (uint32_t i = 0; i < p->corners; i++) {
    if (of[i] == SG_NO_CORNER) {
      before = NULL;
      continue;
    }
    const double *at = s->corner.item[of[i]].at;
    bool is_low = at[1] <= y;
    if (before && is_low != was_low) {
      w->crossing.item[w->crossing.n++] =
          meet_edge(is_low ? at : before, is_low ? before : at, y);
    }
    before = at;
    was_low = is_low;
  }
  corner *c = w->crossing.item;
  if (w->crossing.n != 2) {
    sort_corners(c, w->crossing.n);
  } else if (c[0].x > c[1].x) { /* as it mostly is */
    corner right = c[0];
    c[0] = c[1];
    c[1] = right;
  }
  return true;
}

/* A slice from x1 to x2; null: it is too narrow for one. */
static sg_slice *
next_slice(sg_shading_work *w, const sg_shading_polygon *p, double x1,
           double x2)
{
  int32_t from = sg_slice_end(w, x1), to = sg_slice_end(w, x2);

  if (from >= to) {
    return NULL;
  }
  sg_slice *out = &w->slice.item[w->slice.n++];
  *out = (sg_slice){.x1 = from,
                    .x2 = to,
                    .leaf = p->leaf,
                    .surface = p->surface,
                    .face = p->face,
                    .sense = p->sense};
  return out;
}

/* A triangle, which is met in two places: most polygons of what is large. Its
 * edges to the corner that is alone on its side of the line cross it, and
 * nothing is asked on which the processor would have to guess. */
static void
slice_triangle(sg_shading_work *w, const sg_shading_polygon *p,
               const sg_shading_surface *plane, double y)
{
  static const uint8_t alone[8] = {0, 0, 1, 2, 2, 1, 0, 0};
  const sg_shading *s = w->scene;
  const uint32_t *of = s->corner_of.item + p->corner;
  const double *at[3];
  unsigned low = 0;

  for (unsigned i = 0; i < 3; i++) {
    at[i] = s->corner.item[of[i]].at;
    low |= (unsigned)(at[i][1] <= y) << i;
  }
  unsigned one = alone[low];
  const double *a = at[one], *b = at[one == 2 ? 0 : one + 1];
  const double *c = at[one == 0 ? 2 : one - 1];
  bool is_low = low >> one & 1;
  double xb = meet_edge(is_low ? a : b, is_low ? b : a, y).x;
  double xc = meet_edge(is_low ? a : c, is_low ? c : a, y).x;
  sg_slice *out = next_slice(w, p, sg_smaller(xb, xc), sg_larger(xb, xc));

  if (out) {
    slice_plane(s, plane, y, out);
  }
}

static bool
slice_polygon(sg_shading_work *w, const sg_shading_polygon *p, double y)
{
  const sg_shading_surface *plane = &w->scene->surface.item[p->surface];
  bool edge_on = fabs(plane->q[2]) < SG_EDGE_ON;

  if (!sg_list_need(&w->slice.item, w->slice.n + p->corners / 2, &w->slice.room,
                    sizeof *w->slice.item)) {
    w->failed = true;
    return false;
  }
  if (p->corners == 4 && !edge_on) {
    slice_triangle(w, p, plane, y);
    return true;
  }
  if (!find_corners(w, p, y)) {
    return false;
  }
  const corner *at = w->crossing.item;

  for (size_t i = 0; i + 1 < w->crossing.n; i += 2, at += 2) {
    sg_slice *out = next_slice(w, p, at[0].x, at[1].x);
    if (out && edge_on) {
      slice_between(&at[0], &at[1], out);
    } else if (out) {
      slice_plane(w->scene, plane, y, out);
    }
  }
  return true;
}

/* ---- bodies ---- */

enum {
  LOW,   /* the nearer side of the quadric */
  HIGH,  /* the other one */
  BOUND, /* its planes, from here on */
  SIDES = BOUND + 2,
  PIECES = 4,
  BREAKS = 2 + PIECES * 8
};

/* A piece at y: its quadric is A zz + 2 (B t + C) z + e tt + f t + g there,
 * with t and z from `at`; side[] are its slices, of which x1 and x2 are
 * unknown. */
typedef struct cut {
  const sg_shading_body *body;
  double deep;                /* A */
  sg_slice side[SIDES];       /* depth and face */
  double across[2], along[2]; /* of bounds: z and t, and the rest: */
  double rest[2];             /* sense * plane = across z + along x + rest */
  int32_t from[SIDES];        /* where a slice began, -1: it has not */
} cut;

typedef struct breaks {
  double x[BREAKS];
  int n;
} breaks;

static void
add_break(breaks *all, double x)
{
  if (isfinite(x) && all->n < BREAKS) {
    all->x[all->n++] = x;
  }
}

static void
sort_breaks(breaks *all)
{
  SG_SORT_FEW(double, all->x, (size_t)all->n, *x > *y);
}

/* Adds x0 + the roots of a t^2 + 2 b t + c. */
static void
add_roots(breaks *all, double x0, double a, double b, double c)
{
  double square = b * b - a * c;

  if (square >= 0) {
    double big = -(b + (b < 0 ? -sqrt(square) : sqrt(square)));
    add_break(all, x0 + big / a);
    add_break(all, x0 + c / big);
  }
}

static const sg_shading_quadric *
quadric_of(const sg_shading *s, const sg_shading_body *body)
{
  return &s->quadric.item[s->surface.item[body->surface].of];
}

/* The quadric at y, its two arcs, and where they end. */
static void
cut_quadric(const sg_shading_quadric *s, double y, cut *out, breaks *all)
{
  const double *q = s->q, v = y - s->at[1];
  double a = fabs(q[2]) < LEAST_DEEP ? copysign(LEAST_DEEP, q[2]) : q[2];
  double b = q[4] / 2, c = (q[5] * v + q[8]) / 2;
  double e = q[0], f = (q[3] * v + q[6]) / 2, g = (q[1] * v + q[7]) * v + q[9];
  double square = a * a;

  out->deep = a;
  for (int i = LOW; i <= HIGH; i++) {
    out->side[i] = (sg_slice){.surface = out->body->surface,
                              .leaf = out->body->leaf,
                              .face = out->body->face,
                              .sense = i == LOW ? 1 : -1,
                              .arc = i == LOW ? -1 : 1,
                              .round = true,
                              .x0 = s->at[0],
                              .a = s->at[2] - c / a,
                              .b = -b / a,
                              .e = (b * b - a * e) / square,
                              .f = 2 * (b * c - a * f) / square,
                              .g = (c * c - a * g) / square};
  }
  const sg_slice *arc = &out->side[LOW];
  add_roots(all, s->at[0], arc->e, arc->f / 2, arc->g);
}

/* Where a plane across the body meets its quadric. */
static void
break_bound(const sg_slice *arc, const sg_slice *bound, breaks *all)
{
  double u = bound->a + bound->b * (arc->x0 - bound->x0) - arc->a;
  double v = bound->b - arc->b;

  add_roots(all, arc->x0, arc->e - v * v, arc->f / 2 - u * v, arc->g - u * u);
}

static void
cut_bound(const sg_shading *scene, double y, int i, cut *out, breaks *all)
{
  const sg_shading_bound *bound = &out->body->bound[i];
  const sg_shading_surface *plane = &scene->surface.item[bound->surface];
  const double *q = plane->q, *at = scene->middle;
  sg_slice *side = &out->side[BOUND + i];

  out->across[i] = bound->sense * q[2];
  out->along[i] = bound->sense * q[0];
  out->rest[i] =
      bound->sense * (q[1] * (y - at[1]) + q[3] - q[2] * at[2] - q[0] * at[0]);
  *side = (sg_slice){.surface = bound->surface,
                     .leaf = out->body->leaf,
                     .face = bound->face,
                     .round = true,
                     .sense = out->across[i] > 0 ? 1 : -1};
  if (fabs(q[2]) > ACROSS) {
    slice_plane(scene, plane, y, side);
    break_bound(&out->side[LOW], side, all);
  } else {
    add_break(all, -out->rest[i] / out->along[i]);
  }
}

/* Depths between which a body is; which sides are there. */
typedef struct stretch {
  double from, to;
  int enter, leave; /* less than 0: none */
} stretch;

/* What the planes leave of a line of sight. False: nothing. */
static bool
between_bounds(const cut *c, double x, stretch *out)
{
  *out = (stretch){-INFINITY, INFINITY, -1, -1};
  for (int i = 0; i < (int)c->body->bounds; i++) {
    double rest = c->along[i] * x + c->rest[i];

    if (fabs(c->across[i]) <= ACROSS) {
      if (rest < 0) {
        return false;
      }
      continue;
    }
    double z = sg_slice_depth(&c->side[BOUND + i], x);
    if (c->across[i] > 0 && z > out->from) {
      out->from = z;
      out->enter = BOUND + i;
    } else if (c->across[i] < 0 && z < out->to) {
      out->to = z;
      out->leave = BOUND + i;
    }
  }
  return out->from < out->to;
}

/* What is in the body at x of a line of sight. False: nothing. */
static bool
stretch_at(const cut *c, double x, stretch *out)
{
  const sg_slice *arc = &c->side[LOW];
  double t = x - arc->x0;

  if (!between_bounds(c, x, out)) {
    return false;
  }
  if (!((arc->e * t + arc->f) * t + arc->g > 0)) {
    return c->deep < 0 && out->enter >= 0 && out->leave >= 0;
  }
  double low = sg_slice_depth(arc, x), high = sg_slice_depth(arc + HIGH, x);

  if (c->deep > 0) { /* between its sides */
    if (low > out->from) {
      out->from = low;
      out->enter = LOW;
    }
    if (high < out->to) {
      out->to = high;
      out->leave = HIGH;
    }
  } else if (fmin(out->to, low) - out->from >
             out->to - fmax(out->from, high)) { /* outside: one of two */
    if (low < out->to) {
      out->to = low;
      out->leave = LOW;
    }
  } else if (high > out->from) {
    out->from = high;
    out->enter = HIGH;
  }
  return out->from < out->to && out->enter >= 0 && out->leave >= 0;
}

/* Whether it is a face, not where two pieces meet. */
static bool
is_face(const cut *c, int side)
{
  return side < BOUND || c->body->bound[side - BOUND].face > 0;
}

static bool
end_sides(sg_shading_work *w, cut *c, const bool *goes_on, int32_t x)
{
  for (int i = 0; i < SIDES; i++) {
    if (c->from[i] >= 0 && !goes_on[i]) {
      sg_slice slice = c->side[i];
      slice.x1 = c->from[i];
      slice.x2 = x;
      if (!add_slice(w, &slice)) {
        return false;
      }
    }
    c->from[i] = !goes_on[i] ? -1 : c->from[i] >= 0 ? c->from[i] : x;
  }
  return true;
}

/* The sides that are there from x1 to the next break. */
static bool
go_on(sg_shading_work *w, cut *cuts, int n, int32_t x1, int32_t x2)
{
  bool there[PIECES][SIDES] = {{false}};
  int balance = 0;

  for (int i = 0; i < n && x2 > x1; i++) {
    stretch s;
    if (stretch_at(&cuts[i], ((double)x1 + x2) / 512.0, &s)) {
      balance += is_face(&cuts[i], s.enter) - is_face(&cuts[i], s.leave);
      there[i][s.enter] = is_face(&cuts[i], s.enter);
      there[i][s.leave] = is_face(&cuts[i], s.leave);
      cuts[i].side[s.enter].sense = 1;
      cuts[i].side[s.leave].sense = -1;
    }
  }
  if (balance != 0) {
    memset(there, 0, sizeof there);
  }
  for (int i = 0; i < n; i++) {
    if (!end_sides(w, &cuts[i], there[i], x1)) {
      return false;
    }
  }
  return true;
}

/* Whether all pieces of a leaf lie where nothing is looked at. */
static bool
is_left_out(const sg_shading_work *w, const sg_shading_body *body)
{
  bool out = true;

  for (bool more = true; more && out; body++) {
    more = body->more;
    out = w->between[0] <= body->low[0] && body->high[0] <= w->between[1];
  }
  return out;
}

/* The slices of the pieces of a leaf: from break to break the same sides are
 * there, and the middle tells which. */
static bool
slice_body(sg_shading_work *w, const sg_shading_body *body, double y)
{
  cut cuts[PIECES];
  breaks all = {.n = 0};
  int n = 0;

  for (bool more = true; more && n < PIECES; body++) {
    more = body->more;
    if (!(body->y1 <= y && y < body->y2)) {
      continue;
    }
    cut *c = &cuts[n++];
    c->body = body;
    for (int i = 0; i < SIDES; i++) {
      c->from[i] = -1;
    }
    cut_quadric(quadric_of(w->scene, body), y, c, &all);
    for (int i = 0; i < (int)body->bounds; i++) {
      cut_bound(w->scene, y, i, c, &all);
    }
  }
  add_break(&all, 0);
  add_break(&all, w->scene->frame.width);
  sort_breaks(&all);
  for (int i = 0; i < all.n; i++) {
    int32_t x1 = sg_slice_end(w, all.x[i]);
    int32_t x2 = i + 1 < all.n ? sg_slice_end(w, all.x[i + 1]) : x1;
    if ((x2 > x1 || i + 1 == all.n) && !go_on(w, cuts, n, x1, x2)) {
      return false;
    }
  }
  return true;
}

/* ---- a line ---- */

bool
sg_slices_of_item(sg_shading_work *w, const sg_shading_item *item, double y)
{
  const sg_shading *s = w->scene;

  if (item->round) {
    const sg_shading_body *body = &s->body.item[item->at];
    bool ring = s->surface.item[body->surface].kind == SG_IS_RING;

    return is_left_out(w, body) ||
           (!ring                           ? slice_body(w, body, y)
            : body->y1 <= y && y < body->y2 ? sg_ring_slices(w, body, y)
                                            : true);
  }
  const sg_shading_polygon *p = &s->polygon.item[item->at];
  return !(p->y1 <= y && y < p->y2) || slice_polygon(w, p, y);
}

bool
sg_slices_of_line(sg_shading_work *w, double y)
{
  const sg_shading *s = w->scene;
  uint32_t band = (uint32_t)y / s->band;

  w->slice.n = 0;
  for (uint32_t i = s->band_first[band]; i < s->band_first[band + 1]; i++) {
    if (!sg_slices_of_item(w, &s->item[i], y)) {
      return false;
    }
  }
  return true;
}
