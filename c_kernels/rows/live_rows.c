/* live_rows.c -- see live_rows.h. */
#include "live_rows.h"

bool
sg_each_row(sg_call *call, sg_relation relation, sg_read_row *read,
            void *reader)
{
  const sg_version *version = sg_call_version(call);
  bool stopped = false;
  sg_view view;

  if (!version) {
    return false;
  }
  if (!sg_version_view(version, relation, &view)) {
    return sg_call_no_memory(call);
  }
  for (size_t page = 0; page < view.pages && !stopped; page++) {
    for (unsigned i = sg_live_next(view.live[page], 0); i < SG_PAGE_ROWS;
         i = sg_live_next(view.live[page], i + 1)) {
      read(reader, &(sg_live_row){&view, page, i});
    }
    stopped = sg_cancelled(&call->cancel);
  }
  sg_view_clear(&view);
  return !stopped;
}
