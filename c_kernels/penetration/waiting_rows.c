/* waiting_rows.c -- see waiting_rows.h. */
#include "waiting_rows.h"

#include "rows/append_rows.h"

static bool
wait_row(sg_call *call, sg_int_list *column, const int32_t *row, unsigned n)
{
  for (unsigned c = 0; c < n; c++) {
    if (!sg_int_list_add(call, &column[c], row[c])) {
      return false;
    }
  }
  return true;
}

bool
sg_wait_edge(sg_call *call, sg_waiting *w, const int32_t row[5])
{
  return wait_row(call, w->e, row, 5);
}

bool
sg_wait_triangle(sg_call *call, sg_waiting *w, const int32_t row[6])
{
  return wait_row(call, w->t, row, 6);
}

bool
sg_wait_origin(sg_call *call, sg_waiting *w, int32_t s, const uint32_t *item,
               const uint32_t *origin)
{
  return sg_int_list_add(call, &w->s, s) &&
         sg_waiting_terms_add(call, &w->item, item) &&
         sg_waiting_terms_add(call, &w->origin, origin);
}

bool
sg_wait_polygon(sg_call *call, sg_waiting *w, int32_t s, int32_t p,
                const int32_t *edges)
{
  return wait_row(call, w->p, (const int32_t[2]){s, p}, 2) &&
         sg_waiting_lists_add(call, &w->edges, edges);
}

/* The first n of columns are integers, the others are there already. */
static bool
write_columns(sg_call *call, sg_world *world, sg_relation relation,
              sg_int_list *from, unsigned n, const void **column)
{
  size_t rows = from[0].n;

  for (unsigned c = 0; c < n; c++) {
    column[c] = from[c].at;
    from[c].n = 0;
  }
  return rows == 0 || sg_append_columns(call, world, relation, rows, column);
}

bool
sg_waiting_write(sg_call *call, sg_waiting *w, sg_world *world)
{
  const void *column[6];
  bool good = write_columns(call, world, SG_E, w->e, 5, column);

  column[1] = w->item.at;
  column[2] = w->origin.at;
  good = good && write_columns(call, world, SG_ORIGIN, &w->s, 1, column);
  column[2] = w->edges.at;
  good = good && write_columns(call, world, SG_P, w->p, 2, column) &&
         write_columns(call, world, SG_T, w->t, 6, column);
  w->item.n = w->origin.n = w->edges.n = 0;
  return good;
}
