/* flatness.c -- how far off a place may be that is meant to be there: see
 * flatness.h. */
#include "flatness.h"

#include <float.h>
#include <math.h>

enum { TOUCH_BITS = 44, ROUNDING_BITS = 48, FLAT_BITS = 33 };

/* In grains. */
static const double TOUCH = 0.875, FLAT = 2;

void
sg_flatness_init(sg_flatness *out, double grain)
{
  *out = (sg_flatness){.grain = grain};
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
    model->largest = fmax(model->largest, fabs(x));
  }
  model->any = true;
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
sg_flatness_single(double largest)
{
  int exponent;

  frexp(largest, &exponent);
  return largest > 0 ? ldexp(1, exponent - FLT_MANT_DIG) : 0;
}

/* The power of two that is not below x, 2^bits times smaller; 0 of 0. */
static double
part_of(double x, int bits)
{
  int exponent;
  bool whole = frexp(x, &exponent) == 0.5;

  return x > 0 ? ldexp(1, exponent - whole - bits) : 0;
}

double
sg_flatness_touch(const sg_flatness *model)
{
  return fmax(part_of(model->largest, TOUCH_BITS), TOUCH * model->grain);
}

double
sg_flatness_rounding(const sg_flatness *model)
{
  return part_of(model->largest, ROUNDING_BITS);
}

double
sg_flatness_explained(const sg_flatness *model)
{
  return fmax(sg_flatness_rounding(model), TOUCH * model->grain);
}

double
sg_flatness_touch_of(const double (*at)[3], size_t n, double grain)
{
  sg_flatness model;

  sg_flatness_init(&model, grain);
  for (size_t i = 0; i < n; i++) {
    sg_flatness_see(&model, at[i]);
  }
  return sg_flatness_touch(&model);
}

double
sg_flatness_flat(const sg_flatness *model)
{
  return fmax(
      sg_flatness_touch(model),
      fmax(part_of(sg_flatness_size(model), FLAT_BITS), FLAT * model->grain));
}

void
sg_flatness_join(sg_flatness *model, const sg_flatness *other)
{
  if (other->any) {
    sg_flatness_see(model, other->low);
    sg_flatness_see(model, other->high);
  }
  model->grain = fmax(model->grain, other->grain);
}
