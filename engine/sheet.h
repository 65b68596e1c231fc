/* sheet.h -- rows being written: where a kernel puts their cells.
 *
 * Layer: store, and kernels. Shapes only: the store makes room for n rows, glue
 * hands the sheet over, the kernel fills every cell in place, with several
 * threads if it likes (a task to a page, or to rows that are one after
 * another); the store shows them all at once. A column's cells are contiguous
 * within a page.
 *
 *   for (size_t k = 0; k < sheet.pages; k++)
 *     for (size_t i = 0; i < sheet.page[k].n; i++)
 *       sheet.page[k].column[X].f[i] = x_of_row(sheet.page[k].from + i);
 */
#ifndef SG_SHEET_H
#define SG_SHEET_H

#include "column.h"

#include <stdbool.h>
#include <stdint.h>

/* Cells of one column, of the rows of one page; a list has room for its length,
 * which is its first word, and its ids. */
typedef union sg_blank {
  int32_t *i;
  double *f;
  int32_t **list;
} sg_blank;

typedef struct sg_sheet_page {
  size_t from; /* the first of these rows, of the sheet */
  size_t n;
  uint32_t slot; /* the store's: of the first of them */
  bool refs;     /* the store's: its lists and terms are there, or null */
  sg_blank column[SG_MAX_COLUMNS];
} sg_sheet_page;

typedef struct sg_sheet {
  size_t rows;
  bool ascends;   /* the maker's word: one segment, whose ids ascend by row */
  unsigned place; /* of row 0 in page 0 of the sheet */
  size_t pages;
  sg_sheet_page *page; /* [pages], by row */
} sg_sheet;

/* A place to write at, that goes from row to row. */
typedef struct sg_sheet_place {
  const sg_sheet_page *page;
  size_t at; /* row of the page */
} sg_sheet_place;

/* At row i, or behind the last one. */
static inline sg_sheet_place
sg_sheet_at(const sg_sheet *sheet, size_t i)
{
  const sg_sheet_page *page = sheet->page + (sheet->place + i) / SG_PAGE_ROWS;

  return (sg_sheet_place){page, i < sheet->rows ? i - page->from : 0};
}

static inline void
sg_sheet_next(sg_sheet_place *place)
{
  if (++place->at == place->page->n) {
    place->page++; /* behind the last page: not to be written at */
    place->at = 0;
  }
}

#endif
