/* append4pl.c -- see append4pl.h and dense4pl.h.
 *
 * Layer: glue.
 */
#include "append4pl.h"

#include "dense4pl.h"
#include "door.h"

int
sg_segment_is_empty_ex(sg_world *world, int32_t s)
{
  sg_call call;

  sg_door_open(&call);
  return (int)sg_door_close(&call, 0, sg_segment_is_empty(&call, world, s));
}

int
sg_rows_of_segment_ex(const sg_version *version, sg_relation relation,
                      int32_t s, sg_segment_rows *out)
{
  sg_call call;

  sg_door_open(&call);
  return (int)sg_door_close(
      &call, 0, sg_rows_of_segment(&call, version, relation, s, out));
}

int
sg_append_columns_ex(sg_world *world, sg_relation relation, size_t n,
                     const void *const *column)
{
  sg_call call;

  sg_door_open(&call);
  return (int)sg_door_close(
      &call, 0, sg_append_columns(&call, world, relation, n, column));
}

int
sg_get_dense_ex(const int32_t *wanted, size_t n, sg_dense *out)
{
  sg_call call;

  sg_door_open(&call);
  return (int)sg_door_close(&call, 0, sg_dense_read(&call, wanted, n, out));
}
