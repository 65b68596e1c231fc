/* rows.h -- columns of rows for the tests of the store, and both ways to add
 * them: checked, and written in place.
 */
#ifndef SG_TEST_ROWS_H
#define SG_TEST_ROWS_H

#include "engine/store.h"
#include "tests/check.h"

#include <string.h>

static uint64_t seed;

static uint32_t
draw(uint32_t n)
{
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(seed >> 33) % n;
}

/* ---- columns of rows, and both ways to add them ------------------------- */

enum { MOST = 9000, LONGEST = 6 };

/* Rows of v, e, p or t of one segment, with ids from `first` on. */
typedef struct rows {
  sg_relation relation;
  size_t n;
  int32_t i[6][MOST];
  double f[MOST];
  int32_t list[MOST][1 + LONGEST];
  const int32_t *lists[MOST];
} rows;

static int32_t
id_up_to(int32_t last)
{
  return last > 0 ? 1 + (int32_t)draw((uint32_t)last) : 1;
}

/* References are to ids 1 .. vertices, edges, polygons. */
static inline void
make_rows(rows *r, sg_relation relation, int32_t s, int32_t first, size_t n,
          const int32_t last[3])
{
  r->relation = relation;
  r->n = n;
  for (size_t k = 0; k < n; k++) {
    r->i[0][k] = s;
    r->i[1][k] = relation == SG_T ? id_up_to(last[2]) : first + (int32_t)k;
    r->i[2][k] = relation == SG_T ? first + (int32_t)k : id_up_to(last[0]);
    for (int c = 3; c < 6; c++) {
      r->i[c][k] = id_up_to(last[0]);
    }
    r->i[4][k] = relation == SG_E ? (int32_t)draw(2) : r->i[4][k];
    r->f[k] = draw(1000) / 8.0;
    r->list[k][0] = (int32_t)draw(LONGEST + 1);
    for (int m = 1; relation == SG_P && m <= LONGEST; m++) {
      r->list[k][m] = id_up_to(last[1]);
    }
    r->lists[k] = r->list[k];
  }
}

static inline const void *
column_of(const rows *r, unsigned c)
{
  sg_type type = sg_relation_table[r->relation].column[c].type;

  return type == SG_FLOAT  ? (const void *)r->f
         : type == SG_LIST ? (const void *)r->lists
                           : (const void *)r->i[c];
}

static inline bool
add_checked(sg_world *world, const rows *r)
{
  const void *column[6] = {0};

  for (unsigned c = 0; c < sg_relation_table[r->relation].arity; c++) {
    column[c] = column_of(r, c);
  }
  return sg_world_add_many(world, r->relation, r->n, column, NULL) == SG_OK;
}

static inline bool
fill_lists(sg_append *a, const rows *r, size_t k, unsigned c)
{
  const sg_sheet_page *page = &a->sheet.page[k];
  int32_t length[SG_PAGE_ROWS];

  for (size_t i = 0; i < page->n; i++) {
    length[i] = r->list[page->from + i][0];
  }
  if (!sg_append_lists(a, k, c, length)) {
    return false;
  }
  for (size_t i = 0; i < page->n; i++) {
    memcpy(page->column[c].list[i], r->list[page->from + i],
           (1 + (size_t)length[i]) * sizeof(int32_t));
  }
  return true;
}

static inline bool
fill(sg_append *a, const rows *r)
{
  const sg_relation_info *info = &sg_relation_table[r->relation];
  bool good = true;

  for (size_t k = 0; k < a->sheet.pages; k++) {
    const sg_sheet_page *page = &a->sheet.page[k];
    for (unsigned c = 0; c < info->arity; c++) {
      if (info->column[c].type == SG_LIST) {
        good = good && fill_lists(a, r, k, c);
      } else if (info->column[c].type == SG_FLOAT) {
        memcpy(page->column[c].f, r->f + page->from, page->n * sizeof(double));
      } else {
        memcpy(page->column[c].i, r->i[c] + page->from,
               page->n * sizeof(int32_t));
      }
    }
  }
  return good;
}

static inline bool
append(sg_world *world, const rows *r)
{
  sg_append a;
  bool good = sg_append_open(&a, world, r->relation, r->n);

  if (good) {
    good = fill(&a, r) && sg_append_commit(&a);
    sg_append_close(&a);
  }
  return good;
}

#endif
