/* block_test.c -- blocks and spans come, go, and are had again; what is given
 * back in full returns to the system.
 */
#include "engine/block.h"
#include "tests/check.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

enum { SLABS = 5, EACH = 63, MANY = SLABS * EACH, MOST = 1 << 12 };

static unsigned char *blocks[MANY];

/* Whether the process has the page at a place. */
static bool
is_mapped(void *at)
{
  unsigned char in;
  uintptr_t page = (uintptr_t)at - (uintptr_t)at % (uintptr_t)getpagesize();

  return mincore((void *)page, 1, &in) == 0;
}

static bool
all_taken(void)
{
  bool right = true;

  for (int i = 0; i < MANY; i++) {
    blocks[i] = sg_block_take();
    right = right && blocks[i] && (uintptr_t)blocks[i] % SG_BLOCK_BYTES == 0;
    if (right) {
      blocks[i][0] = blocks[i][SG_BLOCK_BYTES - 1] = (unsigned char)i;
    }
  }
  return right;
}

/* Each has what was written into it, so no two have a place in common. */
static bool
all_apart(void)
{
  bool right = true;

  for (int i = 0; i < MANY; i++) {
    right = right && blocks[i][0] == (unsigned char)i &&
            blocks[i][SG_BLOCK_BYTES - 1] == (unsigned char)i;
  }
  return right;
}

static int
by_place(const void *a, const void *b)
{
  const unsigned char *x = *(unsigned char *const *)a;
  const unsigned char *y = *(unsigned char *const *)b;

  return x < y ? -1 : x > y;
}

/* One of a slab that is full is the next to be had, wherever it stands. */
static bool
one_is_had_again(int i)
{
  unsigned char *block = blocks[i];

  sg_block_give(block);
  blocks[i] = sg_block_take();
  return blocks[i] == block;
}

/* Every other one of all slabs, which are full: the same are had again. */
static bool
half_is_had_again(void)
{
  static unsigned char *was[MANY];
  bool right = true;

  for (int i = 0; i < MANY; i++) {
    was[i] = blocks[i];
  }
  for (int i = 0; i < MANY; i += 2) {
    sg_block_give(blocks[i]);
  }
  for (int i = 0; i < MANY; i += 2) {
    blocks[i] = sg_block_take();
  }
  qsort(was, MANY, sizeof *was, by_place);
  qsort(blocks, MANY, sizeof *blocks, by_place);
  for (int i = 0; i < MANY; i++) {
    right = right && was[i] == blocks[i];
  }
  return right;
}

/* All but one slab return to the system with their last block. */
static void
all_given(void)
{
  int mapped = 0;

  for (int i = 0; i < MANY; i++) {
    sg_block_give(blocks[i]);
  }
  for (int i = 0; i < MANY; i++) {
    mapped += is_mapped(blocks[i]);
  }
  CHECK("slabs return to the system", mapped <= EACH);
}

/* Spans that were closed are opened again, by their length; of many, those
 * that were closed last. */
static void
spans(void)
{
  static unsigned char *of[MOST];
  size_t page = (size_t)getpagesize();
  int kept = 0;

  for (int i = 0; i < MOST; i++) {
    of[i] = sg_span_open(page);
    of[i][0] = of[i][page - 1] = 1;
  }
  for (int i = 0; i < MOST; i++) {
    sg_span_close(of[i], page);
  }
  for (int i = 0; i < MOST; i++) {
    kept += is_mapped(of[i]);
  }
  CHECK("a few spans are kept", kept > 0 && kept <= 64);
  CHECK("the last one is", is_mapped(of[MOST - 1]));

  unsigned char *longer = sg_span_open(2 * page);

  CHECK("a longer one is none of them", longer);
  longer[0] = longer[2 * page - 1] = 1;
  sg_span_close(longer, 2 * page);

  bool right = true;

  for (int i = 0; i < 8; i++) {
    unsigned char *again = sg_span_open(page);

    again[page - 1] = 2;
    right = right && again != longer && is_mapped(again);
    of[i] = again;
  }
  CHECK("of this length they are had again", right);
  CHECK("the longer one, too", sg_span_open(2 * page) == longer);
  sg_span_close(longer, 2 * page);
  for (int i = 0; i < 8; i++) {
    sg_span_close(of[i], page);
  }
}

int
main(void)
{
  CHECK("blocks begin at multiples of their size", all_taken());
  CHECK("each is apart", all_apart());
  CHECK("one of a full slab is had again", one_is_had_again(3) &&
                                               one_is_had_again(EACH + 5) &&
                                               one_is_had_again(MANY - 1));
  CHECK("half of them, too", half_is_had_again());
  all_given();
  CHECK("they come again", all_taken() && all_apart());
  all_given();
  spans();
  return check_report();
}
