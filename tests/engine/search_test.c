/* search_test.c -- the binary search, and numbers in order. */
#include "engine/search.h"

#include "tests/check.h"

#include <stdbool.h>

enum { MOST = 40 };

/* Every place of every length, against a look at each. */
static void
searches(void)
{
  int32_t id[MOST];
  bool good = true, first = true, found = true;

  for (size_t n = 0; n <= MOST; n++) {
    for (size_t i = 0; i < n; i++) {
      id[i] = (int32_t)(i / 3 * 2); /* each three times, none odd */
    }
    for (int32_t wanted = -1; wanted <= MOST; wanted++) {
      size_t slow = 0, at, where = sg_find_id(id, n, wanted);

      while (slow < n && id[slow] < wanted) {
        slow++;
      }
      SG_SEARCH(at, 0, n, id[at] < wanted);
      good = good && at == slow;
      first = first && sg_first_id(id, n, sizeof *id, wanted) == slow;
      found =
          found && where == (slow < n && id[slow] == wanted ? slow : SIZE_MAX);
    }
  }
  CHECK("search", good);
  CHECK("first id", first);
  CHECK("find id", found);
}

static void
parts(void)
{
  int32_t id[] = {5, 1, 2, 3, 0};
  size_t at;

  SG_SEARCH(at, 1, 4, id[at] < 3);
  CHECK("what is outside is not looked at", at == 3);
  SG_SEARCH(at, 1, 4, id[at] < 9);
  CHECK("true of all: the end", at == 4);
  SG_SEARCH(at, 4, 1, id[at] < 9);
  CHECK("an empty range", at == 4);
}

static void
sorts(void)
{
  int32_t id[] = {3, -1, 3, INT32_MIN, INT32_MAX, -1};
  size_t n = sg_sort_ids(id, 6);

  CHECK("sorted, each once", n == 4 && id[0] == INT32_MIN && id[1] == -1 &&
                                 id[2] == 3 && id[3] == INT32_MAX);
  CHECK("none", sg_sort_ids(id, 0) == 0);
  CHECK("ids have signs",
        sg_compare_ids(&(int32_t){-1}, &(int32_t){1}) < 0 &&
            sg_compare_ids(&(int32_t){7}, &(int32_t){7}) == 0);
  CHECK("numbers have none",
        sg_compare_numbers(&(uint32_t){UINT32_MAX}, &(uint32_t){1}) > 0);
  CHECK("keys are long",
        sg_compare_keys(&(uint64_t){UINT64_C(1) << 40}, &(uint64_t){7}) > 0);
}

/* Items of the same number stay as they stood. */
static void
sorts_few(void)
{
  typedef struct item {
    int number, at;
  } item;
  uint32_t seed = 7;
  bool good = true;

  for (size_t n = 0; n < 30; n++) {
    item all[30];

    for (size_t i = 0; i < n; i++) {
      all[i] = (item){check_below(&seed, 6), (int)i};
    }
    SG_SORT_FEW(item, all, n, x->number > y->number);
    for (size_t i = 1; i < n; i++) {
      good =
          good &&
          (all[i - 1].number < all[i].number ||
           (all[i - 1].number == all[i].number && all[i - 1].at < all[i].at));
    }
  }
  CHECK("a few, stable", good);
}

int
main(void)
{
  sorts_few();
  searches();
  parts();
  sorts();
  return check_report();
}
