/* scene_standard.c -- see scene_standard.h */
#include "scene_standard.h"

#include "number/bounds.h"

#include <float.h>
#include <math.h>

typedef struct extent {
  double low[3], high[3];
  double largest;
} extent;

static void
extent_add(extent *x, const double at[3], double depth)
{
  for (int k = 0; k < 3; k++) {
    double c = at[k] * (k == 2 ? depth : 1.0);
    x->low[k] = sg_smaller(x->low[k], c);
    x->high[k] = sg_larger(x->high[k], c);
    x->largest = sg_larger(x->largest, fabs(c));
  }
}

static extent
extent_of(const sg_scene_input *in)
{
  extent x = {{DBL_MAX, DBL_MAX, DBL_MAX}, {-DBL_MAX, -DBL_MAX, -DBL_MAX}, 0};

  for (size_t i = 0; i < in->model->dense.vertices; i++) {
    if (!in->shown || in->shown[i]) {
      extent_add(&x, in->screen[i], in->depth);
    }
  }
  for (size_t i = 0; i < in->addeds; i++) {
    extent_add(&x, in->added[i].screen[0], in->depth);
    extent_add(&x, in->added[i].screen[1], in->depth);
  }
  return x;
}

sg_scene_standard
sg_scene_standard_of(const sg_scene_input *in)
{
  extent x = extent_of(in);
  sg_scene_standard out = {.scale = 1.0, .largest = x.largest};
  bool some = x.low[0] <= x.high[0];
  int power;

  for (int k = 0; k < 3 && some; k++) {
    out.centre[k] = x.low[k] + (x.high[k] - x.low[k]) / 2;
  }
  if (some) {
    out.side = sg_larger(x.high[0] - x.low[0], x.high[1] - x.low[1]);
  }
  if (out.side > 0.0) {
    frexp(out.side / 2, &power);
    out.scale = ldexp(1.0, power);
  }
  return out;
}
