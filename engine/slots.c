/* slots.c -- where new rows are written: see table.h.
 *
 * Layer: store, private. A sweep finds the slots that no version shows. Those
 * of a page on which rows are left are on its empty stack: single rows take
 * them from the top, rows in bulk a gap, places in a row, so that small batches
 * that come and go fill what they leave. A page without any row is vacant, and
 * for rows in bulk.
 */
#include "table.h"

#include <string.h>

/* ---- vacant pages ------------------------------------------------------ */

size_t
sg_table_vacancies(const sg_table *table)
{
  return table->rest_end - table->rest + table->vacant * SG_PAGE_ROWS;
}

/* The first slot of the first vacant page from this one on. */
static sg_row
vacant_from(const sg_table *table, size_t number)
{
  while (number < table->pages && !table->page[number]->vacant) {
    number++;
  }
  return (sg_row)(number * SG_PAGE_ROWS);
}

sg_row
sg_table_vacancy(const sg_table *table)
{
  return table->rest < table->rest_end ? table->rest
                                       : vacant_from(table, table->next_vacant);
}

sg_row
sg_table_next_vacancy(const sg_table *table, sg_row row)
{
  size_t number = row / SG_PAGE_ROWS + 1;

  return vacant_from(table,
                     number > table->next_vacant ? number : table->next_vacant);
}

/* ---- gaps -------------------------------------------------------------- */

/* The top of a page's stack is the lowest place, the next ones follow upwards.
 * Where the first n places in a row begin, by their number on the stack; below
 * 0: there are none, and page->gap says how many there are. */
static int
find_gap(sg_page *page, size_t n)
{
  unsigned most = 0, in_row = 0;

  for (unsigned k = page->empties; k-- > 0;) {
    bool on = in_row > 0 && page->empty[k] == page->empty[k + 1] + 1;
    in_row = on ? in_row + 1 : 1;
    most = in_row > most ? in_row : most;
    if (in_row == n) {
      return (int)(k + in_row) - 1;
    }
  }
  page->gap = most;
  return -1;
}

sg_row
sg_table_gap(sg_table *table, size_t n)
{
  size_t most = 0;

  if (n == 0 || n > table->gap) {
    return SG_NO_ROW;
  }
  for (size_t i = table->open; i < table->pages; i++) {
    sg_page *page = table->page[i];
    int at = n <= page->gap ? find_gap(page, n) : -1;
    if (at >= 0) {
      return (sg_row)(i * SG_PAGE_ROWS) + page->empty[at];
    }
    most = page->gap > most ? page->gap : most;
  }
  table->gap = most;
  return SG_NO_ROW;
}

/* n places from one on, which are on the page's stack, go from it. */
static void
fill_gap(sg_table *table, sg_page *page, unsigned place, size_t n)
{
  unsigned k = page->empties - 1;

  while (page->empty[k] != place) {
    k--;
  }
  memmove(&page->empty[k + 1 - n], &page->empty[k + 1],
          (page->empties - 1 - k) * sizeof(*page->empty));
  page->empties -= (unsigned)n;
  table->emptied -= n;
}

void
sg_table_fill(sg_table *table, sg_row row, size_t n)
{
  sg_page *page = sg_table_page(table, row);
  sg_row end = row + (sg_row)n;

  if (row >= table->slots) {
    table->slots = end;
  } else if (page->vacant) {
    page->vacant = false;
    table->vacant--;
    table->next_vacant = row / SG_PAGE_ROWS + 1;
    table->rest = end;
    table->rest_end = row / SG_PAGE_ROWS * SG_PAGE_ROWS + SG_PAGE_ROWS;
  } else if (row == table->rest && row < table->rest_end) {
    table->rest = end;
  } else if (n > 0) {
    fill_gap(table, page, row % SG_PAGE_ROWS, n);
  }
}

/* ---- one by one -------------------------------------------------------- */

/* A place from the empty stack of the first page that has one. */
static sg_row
slot_pop(sg_table *table)
{
  while (table->emptied > 0) {
    sg_page *page = table->page[table->open];
    if (page->empties > 0) {
      table->emptied--;
      return (sg_row)(table->open * SG_PAGE_ROWS) +
             page->empty[--page->empties];
    }
    table->open++;
  }
  return SG_NO_ROW;
}

sg_row
sg_table_slot(sg_table *table)
{
  sg_row row = slot_pop(table);

  if (row == SG_NO_ROW && sg_table_vacancies(table) > 0) {
    row = sg_table_vacancy(table);
    sg_table_fill(table, row, 1);
  } else if (row == SG_NO_ROW && sg_table_reserve(table, 1)) {
    row = table->slots++;
  }
  return row;
}
