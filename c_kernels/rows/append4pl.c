/* append4pl.c -- rows that glue writes in place: see append4pl.h. */
#include "append4pl.h"

#include "glue.h"

#include <string.h>

/* ---- a segment without rows --------------------------------------------- */

int
sg_rows_of_segment_ex(const sg_version *version, sg_relation relation,
                      int32_t s, sg_segment_rows *out)
{
  sg_view view;

  *out = (sg_segment_rows){0};
  if (!sg_version_view(version, relation, &view)) {
    return sg_no_memory();
  }
  int good = sg_segment_rows_find(&view, &s, 1, &sg_prolog_poll, out) ||
             (PL_exception(0) ? FALSE : sg_no_memory());

  sg_view_clear(&view);
  return good;
}

/* 1: a row of this relation is of segment s; 0: none; -1: an exception. */
static int
has_rows_ex(const sg_version *version, sg_relation relation, int32_t s)
{
  sg_segment_rows rows;
  int has = sg_rows_of_segment_ex(version, relation, s, &rows)
                ? rows.begin[1] > 0
                : -1;

  sg_segment_rows_clear(&rows);
  return has;
}

int
sg_segment_is_empty_ex(sg_world *world, int32_t s)
{
  static const sg_relation filled[] = {SG_V, SG_E,      SG_P,     SG_PLANE,
                                       SG_T, SG_FROM_V, SG_FROM_P};
  const sg_version *version = sg_world_version(world);
  bool fresh = sg_version_stamp(version, SG_V, s) == 0;
  term_t culprit = PL_new_term_ref();
  int has = 0;

  for (size_t k = 0; !fresh && has == 0 && k < sizeof filled / sizeof *filled;
       k++) {
    has = has_rows_ex(version, filled[k], s);
  }
  sg_version_drop(version);
  return has == 0 || (has > 0 && PL_put_integer(culprit, s) &&
                      PL_permission_error("write", "segment", culprit));
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

int
sg_append_columns_ex(sg_world *world, sg_relation relation, size_t n,
                     const void *const *column)
{
  sg_append a;
  int good = TRUE;

  if (!sg_append_open(&a, world, relation, n)) {
    return sg_no_memory();
  }
  for (size_t k = 0; k < a.sheet.pages && good; k++) {
    copy_page(&sg_relation_table[relation], column, &a.sheet.page[k]);
    good = k % 64 != 63 || PL_handle_signals() >= 0;
  }
  good = good && (sg_append_commit(&a) || sg_no_memory());
  sg_append_close(&a);
  return good;
}
