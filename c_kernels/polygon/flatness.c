/* flatness.c -- how far off its plane a polygon may be: see flatness.h. */
#include "flatness.h"

#include <float.h>
#include <math.h>

/* Decimals count as the source's precision from here on, relative to the
 * size: 1.5 and 0.25 are no rounded measurements. Nor are 0.28125 and 3.125,
 * however many places they have: none of such numbers is fine. Whole numbers
 * are exact, however large. */
static const double COARSEST = 1e-4;

static bool
has_places(double x, int places)
{
  static const double power[] = {1,   1e1, 1e2, 1e3, 1e4,
                                 1e5, 1e6, 1e7, 1e8, 1e9};
  double scaled = x * power[places];

  return fabs(scaled - nearbyint(scaled)) <= fabs(scaled) * 4 * DBL_EPSILON;
}

/* Whether x has a bit set below the 15 highest: 0.5, 40 and 12.375 have none.
 */
static bool
is_fine(double x)
{
  int exponent;
  double bits = ldexp(frexp(x, &exponent), 15);

  return bits != nearbyint(bits);
}

void
sg_flatness_see(sg_flatness *model, const double point[3])
{
  for (int k = 0; k < 3; k++) {
    double x = point[k];
    if (!model->any || x < model->low[k]) {
      model->low[k] = x;
    }
    if (!model->any || x > model->high[k]) {
      model->high[k] = x;
    }
    if (fabs(x) > model->largest) {
      model->largest = fabs(x);
    }
    model->single = model->single && (double)(float)x == x;
    model->fine = model->fine || is_fine(x);
    while (model->places <= SG_PLACES && !has_places(x, model->places)) {
      model->places++;
    }
  }
  model->any = true;
}

void
sg_flatness_init(sg_flatness *out)
{
  *out = (sg_flatness){.single = true};
}

void
sg_flatness_page(sg_flatness *model, const sg_view *v, size_t page)
{
  for (unsigned r = sg_live_next(v->live[page], 0); r < SG_PAGE_ROWS;
       r = sg_live_next(v->live[page], r + 1)) {
    sg_flatness_see(model, (const double[3]){v->column[2].page[page].f[r],
                                             v->column[3].page[page].f[r],
                                             v->column[4].page[page].f[r]});
  }
}

double
sg_flatness_size(const sg_flatness *model)
{
  double size = 0;

  for (int k = 0; k < 3; k++) {
    size = fmax(size, model->high[k] - model->low[k]);
  }
  return size;
}

double
sg_flatness_of_size(const sg_flatness *model)
{
  double size = sg_flatness_size(model);
  int exponent;
  bool whole = frexp(size, &exponent) == 0.5; /* a power of two itself */

  return size > 0 ? ldexp(1, exponent - whole - 33) : 0;
}

double
sg_flatness_of_source(const sg_flatness *model)
{
  double size = sg_flatness_size(model), unit = 0;

  if (model->places == 0) {
    return 0;
  }
  if (model->fine && model->places <= SG_PLACES) {
    double place = pow(10, -model->places);
    unit = place <= COARSEST * size ? place : 0;
  }
  if (model->single && model->fine) {
    unit = fmax(unit, model->largest * FLT_EPSILON);
  }
  return 4 * unit;
}

double
sg_flatness_tolerance(const sg_flatness *model)
{
  return fmax(sg_flatness_of_size(model), sg_flatness_of_source(model));
}

void
sg_flatness_enlarge(sg_flatness *model, const sg_flatness *other)
{
  for (int k = 0; k < 3 && other->any; k++) {
    model->low[k] =
        model->any ? fmin(model->low[k], other->low[k]) : other->low[k];
    model->high[k] =
        model->any ? fmax(model->high[k], other->high[k]) : other->high[k];
  }
  model->any = model->any || other->any;
}
