/* append_rows.c -- see append_rows.h. */
#include "append_rows.h"

#include <string.h>

/* ---- a segment without rows --------------------------------------------- */

bool
sg_rows_of_segment(sg_call *call, const sg_version *version,
                   sg_relation relation, int32_t s, sg_segment_rows *out)
{
  sg_view view;

  *out = (sg_segment_rows){0};
  if (!sg_version_view(version, relation, &view)) {
    return sg_call_no_memory(call);
  }
  bool good = sg_segment_rows_find(&view, &s, 1, &call->cancel, out);

  sg_view_clear(&view);
  return good || sg_call_ended(call);
}

/* 1: a row of this relation is of segment s; 0: none; -1: refused. */
static int
has_rows(sg_call *call, const sg_version *version, sg_relation relation,
         int32_t s)
{
  sg_segment_rows rows;
  int has = sg_rows_of_segment(call, version, relation, s, &rows)
                ? rows.begin[1] > 0
                : -1;

  sg_segment_rows_clear(&rows);
  return has;
}

bool
sg_segment_is_empty(sg_call *call, sg_world *world, int32_t s)
{
  static const sg_relation filled[] = {SG_V, SG_E,      SG_P,     SG_PLANE,
                                       SG_T, SG_FROM_V, SG_FROM_P};
  const sg_version *version = sg_world_version(world);
  bool fresh = sg_version_stamp(version, SG_V, s) == 0;
  int has = 0;

  for (size_t k = 0; !fresh && has == 0 && k < sizeof filled / sizeof *filled;
       k++) {
    has = has_rows(call, version, filled[k], s);
  }
  sg_version_drop(version);
  return has == 0 ||
         (has > 0 && sg_call_forbidden_id(call, "write", "segment", s));
}

/* ---- columns ------------------------------------------------------------ */

static void
copy_floats(double *to, const double *from, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    to[i] = from[i] + 0.0; /* no -0.0 */
  }
}

static void
copy_page(const sg_relation_info *info, const void *const *column,
          const sg_sheet_page *page)
{
  for (unsigned c = 0; c < info->arity; c++) {
    if (info->column[c].type == SG_FLOAT) {
      copy_floats(page->column[c].f, (const double *)column[c] + page->from,
                  page->n);
    } else {
      memcpy(page->column[c].i, (const int32_t *)column[c] + page->from,
             page->n * sizeof(int32_t));
    }
  }
}

bool
sg_append_columns(sg_call *call, sg_world *world, sg_relation relation,
                  size_t n, const void *const *column)
{
  sg_append a;
  bool good = true;

  if (!sg_append_open(&a, world, relation, n)) {
    return sg_call_no_memory(call);
  }
  for (size_t k = 0; k < a.sheet.pages && good; k++) {
    copy_page(&sg_relation_table[relation], column, &a.sheet.page[k]);
    good = k % 64 != 63 || !sg_cancelled(&call->cancel);
  }
  good = good && (sg_append_commit(&a) || sg_call_no_memory(call));
  sg_append_close(&a);
  return good;
}
