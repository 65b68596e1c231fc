/* work_tree_test.c -- a tree of boxes finds what looking at
 * each one finds, whatever their places.
 */
#include "polygon/work_tree.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

typedef struct asked {
  double at[2];
  int found[400];
} asked;

static bool
has_not(const void *data, const sg_work_box *box)
{
  const asked *a = data;

  return a->at[0] < box->low[0] || a->at[0] > box->high[0] ||
         a->at[1] < box->low[1] || a->at[1] > box->high[1];
}

static bool
note(void *data, int32_t number)
{
  ((asked *)data)->found[number]++;
  return false;
}

/* n boxes on a grid of `most` places; some are equal. */
static bool
finds_all(int n, int most)
{
  int32_t *number = malloc(400 * sizeof *number);
  sg_work_box *box = calloc(400, sizeof *box), all[400];
  sg_work_tree tree;
  bool good = true;

  for (int i = 0; i < n; i++) {
    number[i] = i;
    for (int k = 0; k < 2; k++) {
      box[i].low[k] = rand() % most;
      box[i].high[k] = box[i].low[k] + rand() % 3;
    }
  }
  memcpy(all, box, sizeof all);
  if (!sg_work_tree_open(&tree, number, box, (size_t)n, false)) {
    abort();
  }
  for (int turn = 0; turn < 20; turn++) {
    asked a = {.at = {rand() % most, rand() % most}};

    good = good && sg_work_tree_go(&(sg_work_tree_walk){&tree, has_not, NULL,
                                                        note, &a, -1}) == -1;
    for (int i = 0; i < n; i++) {
      good = good && a.found[i] == !has_not(&a, &all[i]);
    }
  }
  sg_work_tree_close(&tree);
  return good;
}

int
main(void)
{
  for (int n = 0; n < 400; n++) {
    CHECK("each once", finds_all(n, 1 + n % 30));
  }
  return check_report();
}
