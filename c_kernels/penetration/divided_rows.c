/* divided_rows.c -- see divided_rows.h. */
#include "divided_rows.h"

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
sg_divided_edge(sg_call *call, sg_divided *w, const int32_t row[5])
{
  return wait_row(call, w->e, row, 5);
}

bool
sg_divided_triangle(sg_call *call, sg_divided *w, const int32_t row[6])
{
  return wait_row(call, w->t, row, 6);
}

bool
sg_divided_origin(sg_call *call, sg_divided *w, int32_t s, const uint32_t *item,
                  const uint32_t *origin)
{
  return sg_int_list_add(call, &w->s, s) &&
         sg_divided_terms_add(call, &w->item, item) &&
         sg_divided_terms_add(call, &w->origin, origin);
}

bool
sg_divided_polygon(sg_call *call, sg_divided *w, int32_t s, int32_t p,
                   const int32_t *edges)
{
  return wait_row(call, w->p, (const int32_t[2]){s, p}, 2) &&
         sg_divided_lists_add(call, &w->edges, edges);
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
sg_divided_write(sg_call *call, sg_divided *w, sg_world *world)
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
