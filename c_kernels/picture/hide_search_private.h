/* hide_search_private.h -- what the two joins of hide_search.h share.
 *
 * Layer: kernel.
 */
#ifndef SG_HIDE_SEARCH_PRIVATE_H
#define SG_HIDE_SEARCH_PRIVATE_H

#include "hide_search.h"

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
