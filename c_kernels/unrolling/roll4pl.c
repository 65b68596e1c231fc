/* roll4pl.c -- surface_place/4, surface_value/4, surfaces_meet/4,
 * roll_points/3, roll_curves/5 (documented in kernel/pattern.pl).
 *
 * Layer: glue: converts, checks, raises; computes nothing. Angles are degrees
 * in Prolog and radians in C.
 */
#include "glue.h"
#include "roll_curve.h"

#include "engine/install.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static functor_t FUNCTOR_minus2, FUNCTOR_point3, FUNCTOR_vector3,
    FUNCTOR_plane4, FUNCTOR_roll3, FUNCTOR_place4, FUNCTOR_curve4,
    FUNCTOR_parallel2;

static const double DEGREE = 0.017453292519943295;

enum { FORMS = 6 };

/* The terms of primitive_face.pl: a point, then vectors, then numbers. */
static const struct {
  const char *name;
  sg_surface_kind kind;
  int vectors, numbers;
} form[FORMS] = {{"cylinder", SG_SURFACE_CYLINDER, 3, 0},
                 {"cone", SG_SURFACE_CONE, 3, 1},
                 {"ruled", SG_SURFACE_RULED, 5, 0},
                 {"sphere", SG_SURFACE_SPHERE, 3, 0},
                 {"torus", SG_SURFACE_TORUS, 3, 1},
                 {"fan", SG_SURFACE_FAN, 2, 1}};

static functor_t form_functor[FORMS];

static int
get_numbers_ex(term_t t, int n, double *out)
{
  term_t arg = PL_new_term_ref();

  for (int i = 0; i < n; i++) {
    if (!PL_get_arg(i + 1, t, arg) || !sg_get_finite_ex(arg, &out[i])) {
      return FALSE;
    }
  }
  return TRUE;
}

static int
get_three_ex(functor_t functor, const char *type, term_t t, double out[3])
{
  if (!PL_is_functor(t, functor)) {
    return PL_type_error(type, t);
  }
  return get_numbers_ex(t, 3, out);
}

static int
get_point_ex(term_t t, double out[3])
{
  return get_three_ex(FUNCTOR_point3, "point", t, out);
}

static double
ratio(const double a[3], const double b[3])
{
  return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) /
         (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
}

static int
get_curved_ex(term_t t, int i, sg_surface *out)
{
  double more[2][3] = {{0}};
  double *vector[5] = {out->u, out->v, out->w, more[0], more[1]};
  term_t arg = PL_new_term_ref();
  int at = 1;

  out->kind = form[i].kind;
  if (!PL_get_arg(at++, t, arg) || !get_point_ex(arg, out->c)) {
    return FALSE;
  }
  for (int k = 0; k < form[i].vectors; k++) {
    if (!PL_get_arg(at++, t, arg) ||
        !get_three_ex(FUNCTOR_vector3, "vector", arg, vector[k])) {
      return FALSE;
    }
  }
  if (form[i].numbers > 0 &&
      (!PL_get_arg(at, t, arg) || !sg_get_finite_ex(arg, &out->k))) {
    return FALSE;
  }
  if (out->kind == SG_SURFACE_RULED) {
    out->k = ratio(more[0], out->u);
    out->k2 = ratio(more[1], out->v);
  }
  return TRUE;
}

static int get_surface_ex(term_t t, sg_surface *out);

/* parallel(Surface, Distance) */
static int
get_parallel_ex(term_t t, sg_surface *out)
{
  term_t arg = PL_new_term_ref();
  double distance;

  _PL_get_arg(1, t, arg);
  if (!get_surface_ex(arg, out)) {
    return FALSE;
  }
  if (out->kind != SG_SURFACE_CYLINDER && out->kind != SG_SURFACE_CONE) {
    return PL_domain_error("developable_surface", arg);
  }
  _PL_get_arg(2, t, arg);
  if (!sg_get_finite_ex(arg, &distance)) {
    return FALSE;
  }
  out->offset += distance;
  return TRUE;
}

static int
get_surface_ex(term_t t, sg_surface *out)
{
  if (PL_is_functor(t, FUNCTOR_parallel2)) {
    return get_parallel_ex(t, out);
  }
  int found = PL_is_functor(t, FUNCTOR_plane4);

  memset(out, 0, sizeof *out);
  if (found) {
    out->kind = SG_SURFACE_PLANE;
    if (!get_numbers_ex(t, 4, out->plane)) {
      return FALSE;
    }
  }
  for (int i = 0; i < FORMS && !found; i++) {
    if (PL_is_functor(t, form_functor[i])) {
      found = 1;
      if (!get_curved_ex(t, i, out)) {
        return FALSE;
      }
    }
  }
  if (!found) {
    return PL_type_error("surface", t);
  }
  return sg_surface_init(out) || PL_domain_error("surface", t);
}

static int
unify_point(term_t t, const double x[3])
{
  return PL_unify_term(t, PL_FUNCTOR, FUNCTOR_point3, PL_FLOAT, x[0] + 0.0,
                       PL_FLOAT, x[1] + 0.0, PL_FLOAT, x[2] + 0.0);
}

/* surface_place(+Surface, +Point, -T, -H) is det. */
static foreign_t
surface_place(term_t surface_term, term_t point, term_t t, term_t h)
{
  sg_surface surface;
  double x[3], angle, height;

  if (!get_surface_ex(surface_term, &surface) || !get_point_ex(point, x)) {
    return FALSE;
  }
  if (surface.kind == SG_SURFACE_PLANE || surface.kind == SG_SURFACE_SPHERE ||
      surface.kind == SG_SURFACE_TORUS) {
    return PL_domain_error("ruled_surface", surface_term);
  }
  sg_surface_place(&surface, x, &angle, &height);
  return sg_unify_double(t, angle / DEGREE) && sg_unify_double(h, height);
}

/* surface_value(+Surface, +Point, -Value, -Normal) is semidet. */
static foreign_t
surface_value(term_t surface_term, term_t point, term_t value_term,
              term_t normal_term)
{
  sg_surface surface;
  double x[3], value, normal[3];

  if (!get_surface_ex(surface_term, &surface) || !get_point_ex(point, x)) {
    return FALSE;
  }
  return sg_surface_value(&surface, x, &value, normal) &&
         sg_unify_double(value_term, value) &&
         PL_unify_term(normal_term, PL_FUNCTOR, FUNCTOR_vector3, PL_FLOAT,
                       normal[0] + 0.0, PL_FLOAT, normal[1] + 0.0, PL_FLOAT,
                       normal[2] + 0.0);
}

/* A list of 1 to SG_SURFACES_MOST surfaces. */
static int
get_surfaces_ex(term_t list, sg_surface *out, size_t *n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  *n = 0;
  while (PL_get_list_ex(tail, head, tail)) {
    if (*n == SG_SURFACES_MOST) {
      return PL_domain_error("few_surfaces", list);
    }
    if (!get_surface_ex(head, &out[(*n)++])) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(tail) &&
         (*n > 0 || PL_domain_error("few_surfaces", list));
}

/* surfaces_meet(+Surfaces, +Reach, +Point0, -Point) is semidet. */
static foreign_t
surfaces_meet(term_t list, term_t reach_term, term_t point0, term_t point)
{
  sg_surface surface[SG_SURFACES_MOST];
  const sg_surface *each[SG_SURFACES_MOST];
  double x[3], reach;
  size_t n;

  if (!get_surfaces_ex(list, surface, &n) ||
      !sg_get_finite_ex(reach_term, &reach) || !get_point_ex(point0, x)) {
    return FALSE;
  }
  for (size_t i = 0; i < n; i++) {
    each[i] = &surface[i];
  }
  return sg_surfaces_meet(each, n, reach, x) && unify_point(point, x);
}

/* roll(Surface, Layer, Start). The caller clears it. */
static int
get_roll_ex(term_t t, sg_roll *out)
{
  term_t arg = PL_new_term_ref();

  if (!PL_is_functor(t, FUNCTOR_roll3)) {
    return PL_type_error("roll", t);
  }
  _PL_get_arg(1, t, arg);
  if (!get_surface_ex(arg, &out->surface)) {
    return FALSE;
  }
  if (out->surface.kind != SG_SURFACE_CYLINDER &&
      out->surface.kind != SG_SURFACE_FAN &&
      (out->surface.kind != SG_SURFACE_CONE || out->surface.k == 1)) {
    return PL_domain_error("developable_surface", arg);
  }
  _PL_get_arg(2, t, arg);
  if (!sg_get_finite_ex(arg, &out->layer)) {
    return FALSE;
  }
  _PL_get_arg(3, t, arg);
  if (!sg_get_finite_ex(arg, &out->start)) {
    return FALSE;
  }
  out->start *= DEGREE;
  return sg_roll_open(out) || sg_no_memory();
}

/* What is done with each item of a list. */
typedef int (*each_item)(const sg_roll *roll, const void *given, term_t item,
                         term_t result);

static int
one_item(const sg_roll *roll, const void *given, each_item each, term_t item,
         term_t result)
{
  fid_t frame = PL_open_foreign_frame();
  int ok = frame && each(roll, given, item, result);

  if (frame) {
    PL_close_foreign_frame(frame);
  }
  return ok && PL_handle_signals() >= 0;
}

/* Unifies `results` with a list of what `each` makes of the items. */
static int
map_list(const sg_roll *roll, const void *given, each_item each, term_t items,
         term_t results)
{
  term_t tail = PL_copy_term_ref(items), head = PL_new_term_ref();
  term_t list = PL_copy_term_ref(results), item = PL_new_term_ref();

  while (PL_get_list_ex(tail, head, tail)) {
    if (!PL_unify_list(list, item, list) ||
        !one_item(roll, given, each, head, item)) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(tail) && PL_unify_nil(list);
}

static int
laid_point(const sg_roll *roll, const void *given, term_t item, term_t result)
{
  double place[2], at[2];

  (void)given;
  if (!PL_is_functor(item, FUNCTOR_minus2)) {
    return PL_type_error("pair", item);
  }
  if (!get_numbers_ex(item, 2, place)) {
    return FALSE;
  }
  sg_roll_at(roll, place[0] * DEGREE, place[1], at);
  return PL_unify_term(result, PL_FUNCTOR, FUNCTOR_minus2, PL_FLOAT, at[0],
                       PL_FLOAT, at[1]);
}

/* roll_points(+Roll, +Places, -Points) is det. */
static foreign_t
roll_points(term_t roll_term, term_t places, term_t points)
{
  sg_roll roll;

  if (!get_roll_ex(roll_term, &roll)) {
    return FALSE;
  }
  int ok = map_list(&roll, NULL, laid_point, places, points);

  sg_roll_clear(&roll);
  return ok;
}

static int
unify_place(term_t t, const sg_roll_place *place)
{
  return PL_unify_term(t, PL_FUNCTOR, FUNCTOR_place4, PL_FLOAT,
                       place->t / DEGREE + 0.0, PL_FLOAT, place->h + 0.0,
                       PL_FLOAT, place->at[0], PL_FLOAT, place->at[1]);
}

/* The list of the points between the ends of a curve. */
static int
unify_curve(term_t result, const sg_roll_curve *curve)
{
  term_t list = PL_copy_term_ref(result), head = PL_new_term_ref();
  sg_roll_place *place = NULL;
  size_t n = 0;
  int ok = TRUE;

  if (!sg_roll_curve_points(curve, &place, &n)) {
    return sg_no_memory();
  }
  for (size_t i = 0; i < n && ok; i++) {
    ok = PL_unify_list(list, head, list) && unify_place(head, &place[i]);
  }
  free(place);
  return ok && PL_unify_nil(list);
}

/* curve(Near, Surfaces, From, To) */
static int
curve_points(const sg_roll *roll, const void *given, term_t item, term_t result)
{
  term_t arg = PL_new_term_ref();
  sg_surface surface[SG_SURFACES_MOST];
  sg_roll_curve curve = *(const sg_roll_curve *)given;

  curve.roll = roll;
  if (!PL_is_functor(item, FUNCTOR_curve4)) {
    return PL_type_error("curve", item);
  }
  if (!get_numbers_ex(item, 1, &curve.near_t) || !PL_get_arg(2, item, arg) ||
      !get_surfaces_ex(arg, surface, &curve.surfaces) ||
      !PL_get_arg(3, item, arg) || !get_point_ex(arg, curve.from) ||
      !PL_get_arg(4, item, arg) || !get_point_ex(arg, curve.to)) {
    return FALSE;
  }
  curve.near_t *= DEGREE;
  for (size_t i = 0; i < curve.surfaces; i++) {
    curve.surface[i] = &surface[i];
  }
  return unify_curve(result, &curve);
}

/* roll_curves(+Roll, +Reach, +Tolerance, +Curves, -Lists) is det. */
static foreign_t
roll_curves(term_t roll_term, term_t reach, term_t tolerance, term_t curves,
            term_t lists)
{
  sg_roll_curve given = {0};
  sg_roll roll;

  if (!sg_get_finite_ex(reach, &given.reach) ||
      !sg_get_finite_ex(tolerance, &given.tolerance)) {
    return FALSE;
  }
  if (!get_roll_ex(roll_term, &roll)) {
    return FALSE;
  }
  int ok = map_list(&roll, &given, curve_points, curves, lists);

  sg_roll_clear(&roll);
  return ok;
}

static functor_t
functor(const char *name, size_t arity)
{
  return PL_new_functor(PL_new_atom(name), arity);
}

void
sg_install_roll(void)
{
  static const PL_extension doors[] = {
      {"surface_place", 4, (pl_function_t)surface_place, 0},
      {"surface_value", 4, (pl_function_t)surface_value, 0},
      {"surfaces_meet", 4, (pl_function_t)surfaces_meet, 0},
      {"roll_points", 3, (pl_function_t)roll_points, 0},
      {"roll_curves", 5, (pl_function_t)roll_curves, 0},
      {NULL, 0, NULL, 0}};

  for (int i = 0; i < FORMS; i++) {
    form_functor[i] =
        functor(form[i].name, (size_t)(1 + form[i].vectors + form[i].numbers));
  }
  FUNCTOR_minus2 = functor("-", 2);
  FUNCTOR_point3 = functor("point", 3);
  FUNCTOR_vector3 = functor("vector", 3);
  FUNCTOR_plane4 = functor("plane", 4);
  FUNCTOR_roll3 = functor("roll", 3);
  FUNCTOR_place4 = functor("place", 4);
  FUNCTOR_curve4 = functor("curve", 4);
  FUNCTOR_parallel2 = functor("parallel", 2);
  PL_register_extensions_in_module("sg_kernel_pattern", doors);
}
