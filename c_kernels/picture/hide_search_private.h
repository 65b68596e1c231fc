/* hide_search_private.h -- what the two joins of hide_search.h share.
 *
 * Layer: kernel.
 */
#ifndef SG_HIDE_SEARCH_PRIVATE_H
#define SG_HIDE_SEARCH_PRIVATE_H

#include "hide_search.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Rounding is far below this part of what is compared. */
#define SG_SLACK 1.000001

/* True at the first time in this question. */
static inline bool
sg_is_new(sg_seen *seen, uint32_t thing)
{
  bool fresh = seen->by[thing] != seen->question;

  seen->by[thing] = seen->question;
  return fresh;
}

static inline void
sg_line_shape(const double a[2], const double b[2], sg_grid_shape *out)
{
  *out = (sg_grid_shape){2, {{a[0], a[1]}, {b[0], b[1]}}};
}

/* The largest float that is not above x. */
static inline float
sg_float_below(double x)
{
  float f = (float)x;
  int32_t bits;

  if (!((double)f > x)) {
    return f;
  }
  if (f == 0.0F) {
    return -FLT_TRUE_MIN;
  }
  memcpy(&bits, &f, sizeof bits); /* in the order of the floats of its sign */
  bits -= f > 0.0F ? 1 : -1;
  memcpy(&f, &bits, sizeof f);
  return f;
}

/* And far below this of a depth, and as much more as it rises. */
#define SG_DEPTH_SLACK 1e-12

/* What a mask hides may reach beyond it at a sharp corner: by so many margins
 * of the grid. */
enum { SG_REACH = 64 };

static inline double
sg_plane_depth(const sg_near_plane *plane, const double at[2])
{
  return plane->depth + plane->rise[0] * at[0] + plane->rise[1] * at[1];
}

/* Unsigned integers in the order of the floats. */
static inline uint32_t
sg_depth_order(float x)
{
  uint32_t bits;

  x += 0.0F; /* no -0.0 */
  memcpy(&bits, &x, sizeof bits);
  return bits >> 31 ? ~bits : bits | UINT32_C(1) << 31;
}

/* Of the grid. Null: no memory. */
const sg_mask_near *sg_mask_grid_near(const sg_mask_grid *masks, size_t cell);

/* Makes `way` its x. */
static inline void
sg_turn_shape(const double way[2], sg_grid_shape *shape)
{
  for (unsigned i = 0; i < shape->corners; i++) {
    double x = shape->at[i][0], y = shape->at[i][1];

    shape->at[i][0] = x * way[0] + y * way[1];
    shape->at[i][1] = y * way[0] - x * way[1];
  }
}

#endif
