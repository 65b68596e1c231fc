/* live_rows.h -- the rows of a relation that live, one after another.
 *
 * Layer: rows.
 */
#ifndef SG_LIVE_ROWS_H
#define SG_LIVE_ROWS_H

#include "call.h"

/* One live row of a view. */
typedef struct sg_live_row {
  const sg_view *view;
  size_t page;
  unsigned at;
} sg_live_row;

static inline int32_t
sg_row_int(const sg_live_row *row, unsigned column)
{
  return row->view->column[column].page[row->page].i[row->at];
}

static inline double
sg_row_number(const sg_live_row *row, unsigned column)
{
  return row->view->column[column].page[row->page].f[row->at];
}

/* Its length, then its ids. */
static inline const int32_t *
sg_row_list(const sg_live_row *row, unsigned column)
{
  return row->view->column[column].page[row->page].list[row->at];
}

typedef void sg_read_row(void *reader, const sg_live_row *row);

/* Those of the version of the call; it is asked for a stop after each page. */
bool sg_each_row(sg_call *call, sg_relation relation, sg_read_row *read,
                 void *reader);

#endif
