/* added_rows.c -- see added_rows.h. */
#include "added_rows.h"

#include <string.h>

bool
sg_added_rows_put(sg_call *call, sg_added_rows *rows, const sg_value *row)
{
  unsigned arity = sg_relation_table[rows->relation].arity;

  if (rows->n == rows->room) {
    size_t room = rows->room ? 2 * rows->room : 64;
    sg_value *value =
        sg_call_realloc(call, rows->value, room * arity * sizeof *value);

    if (!value) {
      return false;
    }
    rows->value = value;
    rows->room = room;
  }
  memcpy(rows->value + rows->n++ * arity, row, arity * sizeof *row);
  return true;
}

/* Column c, as sg_world_add_many() wants it; null: refused. */
static const void *
column_of(sg_call *call, const sg_added_rows *rows, unsigned c)
{
  const sg_relation_info *info = &sg_relation_table[rows->relation];
  const sg_value *value = rows->value + c;
  size_t n = rows->n;
  union {
    void *any;
    int32_t *i;
    double *f;
    const int32_t **list;
    const uint32_t **term;
  } to = {sg_call_alloc(call, n * sizeof(sg_value))};

  for (size_t k = 0; to.any && k < n; k++, value += info->arity) {
    switch (info->column[c].type) {
    case SG_INT:
    case SG_ATOM:
      to.i[k] = value->i;
      break;
    case SG_FLOAT:
      to.f[k] = value->f;
      break;
    case SG_LIST:
      to.list[k] = value->list;
      break;
    case SG_TERM:
      to.term[k] = value->term;
      break;
    }
  }
  return to.any;
}

bool
sg_added_rows_write(sg_call *call, sg_world *world, sg_added_rows *rows)
{
  const void *column[SG_MAX_COLUMNS];
  size_t n = rows->n;

  for (unsigned c = 0; n > 0 && c < sg_relation_table[rows->relation].arity;
       c++) {
    if (!(column[c] = column_of(call, rows, c))) {
      return false;
    }
  }
  rows->n = 0;
  return n == 0 || sg_call_add_rows(call, world, rows->relation, n, column);
}
