/* roll_rows.c -- surfaces, and what is unrolled, as terms say them. Angles are
 * degrees there and radians in the kernels.
 */
#include "doors/pattern.h"
#include "roll_curve.h"

#include <string.h>

static const double DEGREE = 0.017453292519943295;

/* ---- surfaces ---- */

static double
ratio(const sg_xyz *a, const double b[3])
{
  return (a->at[0] * b[0] + a->at[1] * b[1] + a->at[2] * b[2]) /
         (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
}

static sg_surface
curved(sg_surface_kind kind, sg_xyz c, sg_xyz u, sg_xyz v, sg_xyz w, double k)
{
  sg_surface out = {.kind = kind, .k = k};

  memcpy(out.c, c.at, sizeof out.c);
  memcpy(out.u, u.at, sizeof out.u);
  memcpy(out.v, v.at, sizeof out.v);
  memcpy(out.w, w.at, sizeof out.w);
  return out;
}

static sg_surface
surface_of(const sg_surface_term *t)
{
  sg_surface s = {0};

  switch (t->is) {
  case SG_SURFACE_TERM_PLANE:
    return (sg_surface){
        .kind = SG_SURFACE_PLANE,
        .plane = {t->plane.nx, t->plane.ny, t->plane.nz, t->plane.d}};
  case SG_SURFACE_TERM_CYLINDER:
    return curved(SG_SURFACE_CYLINDER, t->cylinder.c, t->cylinder.u,
                  t->cylinder.v, t->cylinder.w, 0);
  case SG_SURFACE_TERM_CONE:
    return curved(SG_SURFACE_CONE, t->cone.c, t->cone.u, t->cone.v, t->cone.w,
                  t->cone.k);
  case SG_SURFACE_TERM_SPHERE:
    return curved(SG_SURFACE_SPHERE, t->sphere.c, t->sphere.u, t->sphere.v,
                  t->sphere.w, 0);
  case SG_SURFACE_TERM_TORUS:
    return curved(SG_SURFACE_TORUS, t->torus.c, t->torus.u, t->torus.v,
                  t->torus.w, t->torus.k);
  case SG_SURFACE_TERM_FAN:
    return curved(SG_SURFACE_FAN, t->fan.c, t->fan.u, t->fan.v, (sg_xyz){{0}},
                  t->fan.k);
  case SG_SURFACE_TERM_RULED:
    s = curved(SG_SURFACE_RULED, t->ruled.c, t->ruled.u, t->ruled.v, t->ruled.w,
               0);
    s.k = ratio(&t->ruled.u1, s.u);
    s.k2 = ratio(&t->ruled.v1, s.v);
  }
  return s;
}

/* Argument `argument` is it, or the item of a list there, from 1. */
static bool
read_surface(sg_call *call, const sg_offset_surface *t, int argument,
             sg_surface *out)
{
  bool is_parallel = t->is == SG_OFFSET_SURFACE_PARALLEL;

  *out = surface_of(is_parallel ? &t->parallel.surface : &t->plain);
  if (is_parallel && out->kind != SG_SURFACE_CYLINDER &&
      out->kind != SG_SURFACE_CONE) {
    return sg_call_domain(call, "developable_surface", argument);
  }
  out->offset = is_parallel ? t->parallel.distance : 0;
  return sg_surface_init(out) || sg_call_domain(call, "surface", argument);
}

/* 1 to SG_SURFACES_MOST surfaces. */
static bool
read_surfaces(sg_call *call, const sg_offset_surface_list *list, int argument,
              sg_surface *out, const sg_surface **each)
{
  if (list->n == 0 || list->n > SG_SURFACES_MOST) {
    return sg_call_domain(call, "few_surfaces", argument);
  }
  for (size_t i = 0; i < list->n; i++) {
    if (!read_surface(call, &list->at[i], argument, &out[i])) {
      return false;
    }
    each[i] = &out[i];
  }
  return true;
}

bool
sg_door_surface_place(sg_call *call, const sg_offset_surface *surface,
                      const sg_xyz *point, double *t, double *h)
{
  sg_surface s;

  if (!read_surface(call, surface, 1, &s)) {
    return false;
  }
  if (s.kind == SG_SURFACE_PLANE || s.kind == SG_SURFACE_SPHERE ||
      s.kind == SG_SURFACE_TORUS) {
    return sg_call_domain(call, "ruled_surface", 1);
  }
  sg_surface_place(&s, point->at, t, h);
  *t /= DEGREE;
  return true;
}

bool
sg_door_surface_value(sg_call *call, const sg_offset_surface *surface,
                      const sg_xyz *point, double *value, sg_xyz *normal)
{
  sg_surface s;

  return read_surface(call, surface, 1, &s) &&
         sg_surface_value(&s, point->at, value, normal->at);
}

bool
sg_door_surfaces_meet(sg_call *call, const sg_offset_surface_list *surfaces,
                      double reach, const sg_xyz *point0, sg_xyz *point)
{
  sg_surface surface[SG_SURFACES_MOST];
  const sg_surface *each[SG_SURFACES_MOST];

  *point = *point0;
  return read_surfaces(call, surfaces, 1, surface, each) &&
         sg_surfaces_meet(each, surfaces->n, reach, point->at);
}

/* ---- rolls ---- */

/* sg_roll_clear() in any case. */
static bool
open_roll(sg_call *call, const sg_roll_fact *t, sg_roll *out)
{
  *out = (sg_roll){.layer = t->layer, .start = t->start * DEGREE};
  if (!read_surface(call, &t->surface, 1, &out->surface)) {
    return false;
  }
  if (out->surface.kind != SG_SURFACE_CYLINDER &&
      out->surface.kind != SG_SURFACE_FAN &&
      (out->surface.kind != SG_SURFACE_CONE || out->surface.k == 1)) {
    return sg_call_domain(call, "developable_surface", 1);
  }
  return sg_roll_open(out) || sg_call_no_memory(call);
}

bool
sg_door_roll_points(sg_call *call, const sg_roll_fact *fact,
                    const sg_paper_point_list *places,
                    sg_paper_point_list *points)
{
  sg_roll roll;
  bool good = open_roll(call, fact, &roll);

  for (size_t i = 0; good && i < places->n; i++) {
    double at[2];

    sg_roll_at(&roll, places->at[i].x * DEGREE, places->at[i].y, at);
    good =
        !sg_cancel_every(&call->cancel, i) &&
        sg_paper_point_list_add(call, points, (sg_paper_point){at[0], at[1]});
  }
  sg_roll_clear(&roll);
  return good;
}

/* The points between the ends of a curve. */
static bool
add_curve(sg_call *call, const sg_roll_curve *curve,
          sg_list_roll_place_fact_list *lists)
{
  sg_roll_place_fact_list list = {0};
  sg_roll_place *place = NULL;
  size_t n = 0;

  if (!sg_roll_curve_points(curve, &place, &n)) {
    return sg_call_no_memory(call);
  }
  bool good = sg_call_adopt(call, place);

  for (size_t i = 0; good && i < n; i++) {
    good = sg_roll_place_fact_list_add(
        call, &list,
        (sg_roll_place_fact){place[i].t / DEGREE, place[i].h, place[i].at[0],
                             place[i].at[1]});
  }
  return good && !sg_cancelled(&call->cancel) &&
         sg_list_roll_place_fact_list_add(call, lists, list);
}

bool
sg_door_roll_curves(sg_call *call, const sg_roll_fact *fact, double reach,
                    double tolerance, const sg_roll_curve_fact_list *curves,
                    sg_list_roll_place_fact_list *lists)
{
  sg_surface surface[SG_SURFACES_MOST];
  sg_roll roll;
  bool good = open_roll(call, fact, &roll);

  for (size_t i = 0; good && i < curves->n; i++) {
    const sg_roll_curve_fact *c = &curves->at[i];
    sg_roll_curve curve = {.roll = &roll,
                           .near_t = c->near * DEGREE,
                           .surfaces = c->surfaces.n,
                           .reach = reach,
                           .tolerance = tolerance};

    memcpy(curve.from, c->from.at, sizeof curve.from);
    memcpy(curve.to, c->to.at, sizeof curve.to);
    good = read_surfaces(call, &c->surfaces, 4, surface, curve.surface) &&
           add_curve(call, &curve, lists);
  }
  sg_roll_clear(&roll);
  return good;
}
