/* outline_rows.c -- loops of points as a kernel takes them.
 *
 * Layer: rows.
 */
#include "doors/work.h"
#include "outline.h"

/* All points, one after the other; each loop has three at least. */
static bool
join_loops(sg_call *call, const sg_list_paper_point_list *loops,
           double (*at)[2], size_t *begin)
{
  size_t n = 0;

  for (size_t i = 0; i < loops->n; i++) {
    const sg_paper_point_list *loop = &loops->at[i];

    if (loop->n < 3) {
      sg_call_domain(call, "loop", 1);
      return sg_call_at(call, i + 1, 0);
    }
    for (size_t k = 0; k < loop->n; k++) {
      at[n][0] = loop->at[k].x;
      at[n++][1] = loop->at[k].y;
    }
    begin[i + 1] = n;
  }
  return true;
}

bool
sg_door_loops_are_sound(sg_call *call, const sg_list_paper_point_list *loops)
{
  size_t points = 0;
  bool sound = false;

  for (size_t i = 0; i < loops->n; i++) {
    points += loops->at[i].n;
  }
  double(*at)[2] = sg_call_alloc(call, points * sizeof *at);
  size_t *begin = sg_call_alloc(call, (loops->n + 1) * sizeof *begin);

  if (!at || !begin) {
    return false;
  }
  begin[0] = 0;
  if (loops->n == 0) {
    return sg_call_domain(call, "loops", 1);
  }
  const sg_flat_loops flat = {loops->n, (const double(*)[2])at, begin};

  return join_loops(call, loops, at, begin) &&
         (sg_flat_loops_are_sound(&flat, &call->cancel, &sound) ||
          sg_call_ended(call)) &&
         sound;
}
