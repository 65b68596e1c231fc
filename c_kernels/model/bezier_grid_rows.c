/* bezier_grid_rows.c -- bezier_grid/4. */
#include "bezier_grid.h"

#include "doors/world.h"

#include <math.h>
#include <string.h>

bool
sg_door_bezier_grid(sg_call *call, const sg_number_list *controls, size_t n,
                    sg_space_point_list *points, sg_int_list *turned)
{
  double control[16][3];
  bool good = controls->n == 48;

  for (size_t i = 0; good && i < controls->n; i++) {
    good = isfinite(controls->at[i]);
  }
  if (!good) {
    return sg_call_domain(call, "patch", 1);
  }
  if (n < 1 || n > SG_BEZIER_MOST) {
    return sg_call_domain(call, "facets", 2);
  }
  memcpy(control, controls->at, sizeof control);
  size_t corners = (n + 1) * (n + 1), cells = n * n;
  double(*at)[3] = sg_call_alloc(call, corners * sizeof *at);
  bool *is = sg_call_alloc(call, cells * sizeof *is);

  if (!at || !is) {
    return false;
  }
  if (!sg_bezier_grid((const double(*)[3])control, n, at, is)) {
    return sg_call_no_memory(call);
  }
  for (size_t i = 0; good && i < corners; i++) {
    good = sg_space_point_list_add(
        call, points, (sg_space_point){at[i][0], at[i][1], at[i][2]});
  }
  for (size_t i = 0; good && i < cells; i++) {
    good = sg_int_list_add(call, turned, is[i]);
  }
  return good;
}
