/* self_rows.c -- where segments go through themselves.
 *
 * Layer: rows.
 */
#include "doors/boolean.h"
#include "rows/dense_rows.h"

#include <stdlib.h>

/* Counts what was found by kind, and lists of each kind the first `most`. */
static bool
list_meetings(sg_call *call, const sg_self_meetings *found, int64_t most,
              sg_self_segment *out)
{
  size_t count[SG_SELF_KINDS] = {0};
  bool good = true;

  for (size_t i = 0; i < found->n && good; i++) {
    const sg_self_meeting *m = &found->item[i];

    good = (int64_t)count[m->kind]++ >= most ||
           sg_self_meeting_fact_list_add(call, &out->meetings, *m);
  }
  for (int k = 0; k < SG_SELF_KINDS && good; k++) {
    const sg_self_count of = {(sg_self_kind)k, count[k]};

    good = of.n == 0 || sg_self_count_list_add(call, &out->counts, of);
  }
  return good;
}

static bool
add_segment(sg_call *call, const sg_dense *dense, size_t s, int64_t most,
            sg_self_segment_list *out)
{
  sg_self_segment segment = {.s = dense->segment[s]};
  sg_pool *pool = sg_call_pool(call);
  sg_self_meetings found = {0};

  if (!pool || !sg_self_cut(dense, s, sg_self_tolerance(dense, s), pool,
                            &call->cancel, &found)) {
    return sg_call_ended(call);
  }
  sg_self_by_polygon(&found);
  bool good = list_meetings(call, &found, most, &segment) &&
              sg_self_segment_list_add(call, out, segment);

  free(found.item);
  return good;
}

bool
sg_door_self_meetings(sg_call *call, int64_t most,
                      sg_self_segment_list *segments)
{
  sg_dense dense;
  bool good = sg_dense_read(call, NULL, 0, &dense);

  for (size_t s = 0; s < dense.segments && good; s++) {
    good = add_segment(call, &dense, s, most, segments);
  }
  sg_dense_clear(&dense);
  return good;
}
