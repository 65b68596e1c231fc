/* work4pl.h -- scratch relations, for doors that are still by hand.
 *
 * Layer: glue.
 */
#ifndef SG_WORK4PL_H
#define SG_WORK4PL_H

#include "door.h"
#include "work.h"

extern sg_handle_type sg_handle_type_work;

/* The work behind a handle, borrowed: nobody closes it in another thread. */
static inline int
sg_get_work_ex(term_t t, sg_work **out)
{
  sg_handle *handle;

  if (!sg_handle_get(t, &sg_handle_type_work, &handle)) {
    return FALSE;
  }
  *out = handle->object;
  sg_handle_done(handle);
  return TRUE;
}

static inline int
sg_unify_work(term_t t, sg_work *work)
{
  return sg_handle_unify(t, &sg_handle_type_work, work);
}

static inline int
sg_get_work_vertex_ex(sg_work *work, term_t t, int32_t *out)
{
  int32_t id;

  if (!sg_get_id_ex(t, &id)) {
    return FALSE;
  }
  *out = sg_work_find(work, id);
  return *out != SG_WORK_NONE || PL_existence_error("work_vertex", t);
}

#endif
