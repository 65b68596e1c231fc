/* cut4pl.h -- cut sets, for doors that are still by hand.
 *
 * Layer: glue. Include it before SWI-Prolog.h.
 */
#ifndef SG_CUT4PL_H
#define SG_CUT4PL_H

#include "cut_rows.h"
#include "door.h"
#include "join/tree4pl.h"

#include "engine/world4pl.h"

extern sg_handle_type sg_handle_type_cut_set;

/* The open cut set that t names, borrowed: nobody closes it in another thread.
 */
static inline int
sg_get_cut_set_ex(term_t t, sg_cut_handle **out)
{
  sg_handle *handle;

  if (!sg_handle_get(t, &sg_handle_type_cut_set, &handle)) {
    return FALSE;
  }
  *out = handle->object;
  sg_handle_done(handle);
  return TRUE;
}

static inline int
sg_cut_outline_ex(sg_cut_handle *handle, int32_t s, int32_t p, term_t p_term,
                  sg_outlines *out)
{
  sg_call call;

  (void)p_term;
  sg_door_open(&call);
  return (int)sg_door_close(&call, 0, sg_cut_outline(&call, handle, s, p, out));
}

#endif
