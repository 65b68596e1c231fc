/* term_test.c -- nodes of coded terms: copies, and Prolog's standard order. */
#include "engine/term.h"

#include "tests/check.h"

#include <string.h>

enum { TERMS = 15 };

/* Terms in standard order, each less than the next one. */
static void
build(int i, sg_term_builder *b)
{
  sg_term_open(b);
  switch (i) {
  case 0:
    sg_term_int(b, -(INT64_C(1) << 40));
    break;
  case 1:
    sg_term_int(b, -3);
    break;
  case 2:
    sg_term_float(b, 7.0);
    break;
  case 3:
    sg_term_int(b, 7);
    break;
  case 4:
    sg_term_float(b, 7.5);
    break;
  case 5:
    sg_term_int(b, INT64_C(1) << 40);
    break;
  case 6:
    sg_term_string(b, "z", 1);
    break;
  case 7:
    sg_term_nil(b);
    break;
  case 8:
    sg_term_atom(b, "near", 4);
    break;
  case 9:
    sg_term_atom(b, "nearer", 6);
    break;
  case 10:
    sg_term_unary(b, SG_SYMBOL_V, 2);
    break;
  case 11:
    sg_term_pair(b, 9, 9);
    break;
  case 12: /* ll(1-2, 3-4), ll(1-3, 0-0) */
  case 13:
    sg_term_compound(b, SG_SYMBOL_LL, 2);
    sg_term_pair(b, 1, i == 12 ? 2 : 3);
    sg_term_pair(b, i == 12 ? 3 : 0, i == 12 ? 4 : 0);
    break;
  default:
    sg_term_compound(b, SG_SYMBOL_V, 2);
    sg_term_int(b, 1);
    sg_term_int(b, 1);
    break;
  }
}

static int
sign(int n)
{
  return (n > 0) - (n < 0);
}

static void
ordered(void)
{
  sg_term_builder b[TERMS];
  bool good = true, ends = true;

  for (int i = 0; i < TERMS; i++) {
    build(i, &b[i]);
  }
  for (int i = 0; i < TERMS; i++) {
    const uint32_t *x = sg_term_words(&b[i]);

    ends = ends && sg_node_after(x + 1) == x + sg_term_length(x);
    for (int k = 0; k < TERMS; k++) {
      int by = sg_node_order(x + 1, sg_term_words(&b[k]) + 1);
      good = good && sign(by) == sign(i - k);
    }
  }
  CHECK("the order of terms", good);
  CHECK("where a term ends", ends);
  for (int i = 0; i < TERMS; i++) {
    sg_term_close(&b[i]);
  }
}

static void
copied(void)
{
  bool good = true;

  for (int i = 0; i < TERMS; i++) {
    sg_term_builder one, other;

    build(i, &one);
    sg_term_open(&other);
    sg_term_node(&other, sg_term_words(&one) + 1);
    good = good && sg_term_equal(sg_term_words(&one), sg_term_words(&other));
    sg_term_close(&one);
    sg_term_close(&other);
  }
  CHECK("a copy of a node", good);
}

static void
read(void)
{
  static const int64_t number[] = {0,         -1,        5,
                                   INT32_MIN, INT32_MAX, INT64_C(1) << 31};
  bool good = true;

  for (size_t i = 0; i < sizeof number / sizeof *number; i++) {
    sg_term_builder b;
    int32_t n;

    sg_term_open(&b);
    sg_term_int(&b, number[i]);
    bool is = sg_node_int(sg_term_words(&b) + 1, &n);
    good = good && is == (number[i] <= INT32_MAX) && (!is || n == number[i]);
    sg_term_close(&b);
  }
  CHECK("integers of 32 bits", good);
}

int
main(void)
{
  ordered();
  copied();
  read();
  return check_report();
}
