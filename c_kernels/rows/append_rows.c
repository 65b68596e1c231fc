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

static bool
copy_lists(sg_append *a, size_t k, unsigned c, const int32_t *const *from)
{
  const sg_sheet_page *page = &a->sheet.page[k];
  int32_t length[SG_PAGE_ROWS];

  for (size_t i = 0; i < page->n; i++) {
    length[i] = from[i][0];
  }
  if (!sg_append_lists(a, k, c, length)) {
    return false;
  }
  for (size_t i = 0; i < page->n; i++) {
    memcpy(page->column[c].list[i] + 1, from[i] + 1,
           (size_t)length[i] * sizeof(int32_t));
  }
  return true;
}

/* Page k of the sheet. False: no memory. */
static bool
copy_page(sg_append *a, size_t k, const void *const *column)
{
  const sg_relation_info *info = &sg_relation_table[a->relation];
  const sg_sheet_page *page = &a->sheet.page[k];
  bool good = true;

  for (unsigned c = 0; good && c < info->arity; c++) {
    switch (info->column[c].type) {
    case SG_FLOAT:
      copy_floats(page->column[c].f, (const double *)column[c] + page->from,
                  page->n);
      break;
    case SG_INT:
    case SG_ATOM:
      memcpy(page->column[c].i, (const int32_t *)column[c] + page->from,
             page->n * sizeof(int32_t));
      break;
    case SG_LIST:
      good =
          copy_lists(a, k, c, (const int32_t *const *)column[c] + page->from);
      break;
    case SG_TERM:
      good = sg_append_terms(a, k, c,
                             (const uint32_t *const *)column[c] + page->from);
      break;
    }
  }
  return good;
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
    good = copy_page(&a, k, column) || sg_call_no_memory(call);
    good = good && (k % 64 != 63 || !sg_cancelled(&call->cancel));
  }
  good = good && (sg_append_commit(&a) || sg_call_no_memory(call));
  sg_append_close(&a);
  return good;
}
