/* roll_curve.c -- see roll_curve.h. */
#include "roll_curve.h"
#include "engine/list.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 10 };

static const double TURN = 6.283185307179586;

typedef struct end {
  double x[3];
  sg_roll_place place;
} end;

typedef struct growing {
  sg_roll_place *place;
  size_t n, room;
} growing;

static bool
append(growing *out, const sg_roll_place *place)
{
  if (!sg_list_grow(&out->place, out->n, &out->room, sizeof *out->place)) {
    return false;
  }
  out->place[out->n++] = *place;
  return true;
}

static void
set_place(const sg_roll_curve *c, end *e)
{
  sg_roll_place *p = &e->place;

  sg_surface_place(&c->roll->surface, e->x, &p->t, &p->h);
  if (c->roll->surface.kind != SG_SURFACE_FAN) {
    p->t += TURN * nearbyint((c->near_t - p->t) / TURN);
  }
  sg_roll_at(c->roll, p->t, p->h, p->at);
}

/* The point of the curve nearest to that at `part` of the chord a-b. */
static void
between(const sg_roll_curve *c, const end *a, const end *b, double part,
        end *out)
{
  for (int k = 0; k < 3; k++) {
    out->x[k] = a->x[k] + part * (b->x[k] - a->x[k]);
  }
  sg_surfaces_meet(c->surface, c->surfaces, c->reach, out->x);
  set_place(c, out);
}

/* How far p is from the chord a-b, unrolled. */
static double
off_chord(const end *a, const end *b, const end *p)
{
  const double *o = a->place.at, *q = p->place.at;
  double d[2] = {b->place.at[0] - o[0], b->place.at[1] - o[1]};
  double e[2] = {q[0] - o[0], q[1] - o[1]};
  double square = d[0] * d[0] + d[1] * d[1];
  double part = square > 0 ? (d[0] * e[0] + d[1] * e[1]) / square : 0;

  part = part < 0 ? 0 : part > 1 ? 1 : part;
  return hypot(e[0] - part * d[0], e[1] - part * d[1]);
}

/* Whether the curve leaves the chord a-b by more than the tolerance at this
 * part of it, where it is at p. */
static bool
is_off(const sg_roll_curve *c, const end *a, const end *b, double part, end *p)
{
  between(c, a, b, part, p);
  return off_chord(a, b, p) > c->tolerance;
}

static bool
divide(const sg_roll_curve *c, const end *a, const end *b, int depth,
       growing *out)
{
  end middle, quarter;

  return depth == DEEPEST ||
         (!is_off(c, a, b, 0.5, &middle) && !is_off(c, a, b, 0.25, &quarter) &&
          !is_off(c, a, b, 0.75, &quarter)) ||
         (divide(c, a, &middle, depth + 1, out) && append(out, &middle.place) &&
          divide(c, &middle, b, depth + 1, out));
}

bool
sg_roll_curve_points(const sg_roll_curve *curve, sg_roll_place **out, size_t *n)
{
  growing points = {NULL, 0, 0};
  end a, b;

  memcpy(a.x, curve->from, sizeof a.x);
  memcpy(b.x, curve->to, sizeof b.x);
  set_place(curve, &a);
  set_place(curve, &b);
  if (!divide(curve, &a, &b, 0, &points)) {
    free(points.place);
    return false;
  }
  *out = points.place;
  *n = points.n;
  return true;
}
