/* append_terms_test.c -- terms in rows that are written in place: found by
 * their key, gone with their row, and given back when they are not shown. */
#include "engine/store.h"
#include "engine/term.h"
#include "tests/check.h"

#include <string.h>

enum { ROWS = 5000 }; /* more than a page */

static uint32_t word[2][ROWS][8];
static const uint32_t *term[2][ROWS];

/* Row i says v(i + 1) and value - i. */
static void
make_terms(int64_t value)
{
  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < ROWS; i++) {
      sg_term_builder b;

      sg_term_open(&b);
      if (k == 0) {
        sg_term_unary(&b, SG_SYMBOL_V, i + 1);
      } else {
        sg_term_int(&b, value - i);
      }
      memcpy(word[k][i], sg_term_words(&b),
             sg_term_length(sg_term_words(&b)) * sizeof word[k][i][0]);
      term[k][i] = word[k][i];
      sg_term_close(&b);
    }
  }
}

static bool
fill(sg_append *a, int32_t s)
{
  bool good = true;

  for (size_t k = 0; k < a->sheet.pages && good; k++) {
    const sg_sheet_page *page = &a->sheet.page[k];

    for (size_t i = 0; i < page->n; i++) {
      page->column[0].i[i] = s;
    }
    good = sg_append_terms(a, k, 1, term[0] + page->from) &&
           sg_append_terms(a, k, 2, term[1] + page->from);
  }
  return good;
}

/* How many of the rows (s, v(i + 1)) say what make_terms() says. */
static size_t
count_right(sg_world *world, int32_t s)
{
  const sg_version *version = sg_world_version(world);
  size_t right = 0;

  for (int i = 0; i < ROWS; i++) {
    sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.term = term[0][i]}};
    sg_row row = sg_version_find(version, SG_ORIGIN, key);

    right += row != SG_NO_ROW &&
             sg_term_equal(sg_version_value(version, SG_ORIGIN, row, 2).term,
                           term[1][i]);
  }
  sg_version_drop(version);
  return right;
}

static void
test_terms(bool commit)
{
  sg_world *world = sg_world_open();
  sg_append a;

  make_terms(7);
  CHECK("open", sg_append_open(&a, world, SG_ORIGIN, ROWS));
  CHECK("fill", fill(&a, 3));
  CHECK("commit", !commit || sg_append_commit(&a));
  sg_append_close(&a);
  CHECK("valid", sg_world_is_valid(world));
  CHECK("rows found", count_right(world, 3) == (commit ? ROWS : 0));
  CHECK("other segment", count_right(world, 4) == 0);
  sg_world_drop(world);
}

/* Older rows of the same keys, kept for undo, are not found. */
static void
test_again(void)
{
  sg_world *world = sg_world_open();

  for (int64_t turn = 1; turn <= 4; turn++) {
    sg_append a;

    make_terms(turn * 1000);
    CHECK("begin", sg_world_begin(world) == SG_OK);
    CHECK("retracted", sg_world_retract_with(world, SG_ORIGIN, 0, 3));
    CHECK("open again", sg_append_open(&a, world, SG_ORIGIN, ROWS));
    CHECK("filled again", fill(&a, 3) && sg_append_commit(&a));
    sg_append_close(&a);
    CHECK("committed", sg_world_commit(world) == SG_OK);
    CHECK("newest rows", count_right(world, 3) == ROWS);
  }
  CHECK("undo", sg_world_undo(world) == SG_OK);
  make_terms(3000);
  CHECK("older rows", count_right(world, 3) == ROWS);
  CHECK("valid after undo", sg_world_is_valid(world));
  sg_world_drop(world);
}

/* The ids go on where the segment changes; the keys do not. */
static void
test_two_segments(void)
{
  sg_world *world = sg_world_open();
  sg_append a;

  make_terms(7);
  CHECK("open for two", sg_append_open(&a, world, SG_ORIGIN, ROWS));
  CHECK("filled for two", fill(&a, 3));
  for (size_t k = 0; k < a.sheet.pages; k++) {
    const sg_sheet_page *page = &a.sheet.page[k];

    for (size_t i = 0; i < page->n; i++) {
      page->column[0].i[i] = page->from + i < ROWS / 2 ? 3 : 4;
    }
  }
  CHECK("committed for two", sg_append_commit(&a));
  sg_append_close(&a);
  CHECK("valid with two", sg_world_is_valid(world));
  CHECK("rows of the first", count_right(world, 3) == ROWS / 2);
  CHECK("rows of the second", count_right(world, 4) == ROWS / 2);
  sg_world_drop(world);
}

int
main(void)
{
  test_terms(true);
  test_terms(false);
  test_again();
  test_two_segments();
  return check_report();
}
