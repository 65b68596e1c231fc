/* column.h -- what a kernel sees of a relation: pages of typed columns.
 *
 * Layer: store, and kernels. Shapes only: the store fills a view of ONE
 * version, glue hands it over, the kernel loops page by page and skips dead
 * rows.
 *
 *   for (size_t i = 0; i < view.pages; i++)
 *     for (unsigned r = sg_live_next(view.live[i], 0); r < SG_PAGE_ROWS;
 *          r = sg_live_next(view.live[i], r + 1))
 *       use(view.column[X].page[i].f[r]);
 */
#ifndef SG_COLUMN_H
#define SG_COLUMN_H

#include <stddef.h>
#include <stdint.h>

enum {
  SG_PAGE_ROWS = 4096,
  SG_LIVE_WORDS = SG_PAGE_ROWS / 64,
  SG_MAX_COLUMNS = 13
};

/* One page of one column. A list cell points at its length, then its ids. */
typedef union sg_cells {
  const int32_t *i;
  const double *f;
  const int32_t *const *list;
} sg_cells;

typedef struct sg_column {
  const sg_cells *page; /* [pages] */
} sg_column;

typedef struct sg_view {
  size_t pages;
  const uint64_t *const *live; /* [pages][SG_LIVE_WORDS], bit = row lives */
  const uint64_t *none; /* live[i] of pages without a live row, or null */
  int32_t (*span)[2];   /* [pages]: column 0 of live rows is from span[i][0] to
                           span[i][1]; null: nobody knows */
  sg_column column[SG_MAX_COLUMNS];
} sg_view;

/* The first live row of a page at or after `row`; SG_PAGE_ROWS: no more. */
static inline unsigned
sg_live_next(const uint64_t *live, unsigned row)
{
  while (row < SG_PAGE_ROWS) {
    uint64_t word = live[row / 64] >> (row % 64);
    if (word) {
      return row + (unsigned)__builtin_ctzll(word);
    }
    row = (row | 63) + 1;
  }
  return SG_PAGE_ROWS;
}

/* What a row has in a column, by its type. */
static inline int32_t
sg_view_int(const sg_view *view, unsigned column, uint32_t row)
{
  return view->column[column].page[row / SG_PAGE_ROWS].i[row % SG_PAGE_ROWS];
}

static inline double
sg_view_float(const sg_view *view, unsigned column, uint32_t row)
{
  return view->column[column].page[row / SG_PAGE_ROWS].f[row % SG_PAGE_ROWS];
}

static inline const int32_t *
sg_view_list(const sg_view *view, unsigned column, uint32_t row)
{
  return view->column[column].page[row / SG_PAGE_ROWS].list[row % SG_PAGE_ROWS];
}

/* Where the vertex of a row of v/5 is. */
static inline void
sg_view_point(const sg_view *v, uint32_t row, double out[3])
{
  for (unsigned k = 0; k < 3; k++) {
    out[k] = sg_view_float(v, 2 + k, row);
  }
}

#endif
