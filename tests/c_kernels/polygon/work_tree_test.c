/* work_tree_test.c -- a tree of boxes finds what looking at
 * each one finds, whatever their places; and no slab is apart from what is in
 * it.
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

static int32_t
far(const void *data, const sg_work_box *box)
{
  return (int32_t)(box->low[0] - ((const asked *)data)->at[0]);
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
  if (!sg_work_tree_open(&tree, number, box, NULL, (size_t)n, false)) {
    abort();
  }
  for (int turn = 0; turn < 20; turn++) {
    asked a = {.at = {rand() % most, rand() % most}};

    good = good &&
           sg_work_tree_go(&(sg_work_tree_walk){.tree = &tree,
                                                .skips = has_not,
                                                .far = turn % 2 ? far : NULL,
                                                .ends = note,
                                                .data = &a,
                                                .none = -1}) == -1;
    for (int i = 0; i < n; i++) {
      good = good && a.found[i] == !has_not(&a, &all[i]);
    }
  }
  sg_work_tree_close(&tree);
  return good;
}

/* ---- slabs -------------------------------------------------------------- */

typedef struct crossing {
  sg_work_corners t;
  const sg_work_grid_segment *segment; /* of the tree, by number - 1 */
  size_t seen;
  int found[400];
} crossing;

static bool
is_apart(const void *data, const sg_work_box *box)
{
  return sg_work_box_apart(&((const crossing *)data)->t, box);
}

static bool
is_slab_apart(const void *data, const sg_work_slab *slab)
{
  return sg_work_slab_apart(&((const crossing *)data)->t, slab);
}

static double
side(const double a[2], const double b[2], const double c[2])
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* In integers, so exact. */
static bool
meets(const sg_work_corners *t, const sg_work_grid_segment *of)
{
  int left = 0, right = 0;

  for (int i = 0; i < 3; i++) {
    const double *a = t->at[i], *b = t->at[(i + 1) % 3];
    double turn = side(of->from, of->to, a);

    if (side(a, b, of->from) < 0 && side(a, b, of->to) < 0) {
      return false;
    }
    left += turn > 0;
    right += turn < 0;
  }
  return left < 3 && right < 3;
}

static bool
note_crossing(void *data, int32_t number)
{
  crossing *c = data;

  c->seen++;
  c->found[number - 1] += meets(&c->t, &c->segment[number - 1]);
  return false;
}

static void
pick_corners(sg_work_corners *t)
{
  do {
    for (int i = 0; i < 3; i++) {
      t->at[i][0] = rand() % 1000;
      t->at[i][1] = rand() % 1000;
    }
  } while (side(t->at[0], t->at[1], t->at[2]) <= 0);
  for (int k = 0; k < 2; k++) {
    t->low[k] = t->high[k] = t->at[0][k];
    for (int i = 1; i < 3; i++) {
      t->low[k] = t->at[i][k] < t->low[k] ? t->at[i][k] : t->low[k];
      t->high[k] = t->at[i][k] > t->high[k] ? t->at[i][k] : t->high[k];
    }
  }
}

/* n segments askew, side by side, and triangles; *seen counts those that were
 * looked at. */
static bool
finds_crossing(int n, size_t *seen)
{
  int32_t *number = malloc(400 * sizeof *number);
  sg_work_box *box = calloc(400, sizeof *box);
  sg_work_grid_segment *segment = calloc(400, sizeof *segment), all[400];
  sg_work_tree tree;
  bool good = true;

  for (int i = 0; i < n; i++) {
    double x = rand() % 500, y = rand() % 500, length = rand() % 500;

    segment[i] = (sg_work_grid_segment){{x, y}, {x + length, y + length}};
    box[i] = (sg_work_box){{x, y}, {x + length, y + length}, {0}, {0}};
    number[i] = i + 1;
  }
  memcpy(all, segment, sizeof all);
  if (!sg_work_tree_open(&tree, number, box, segment, (size_t)n, false)) {
    abort();
  }
  for (int turn = 0; turn < 20; turn++) {
    crossing c = {.segment = all};

    pick_corners(&c.t);
    sg_work_tree_go(&(sg_work_tree_walk){.tree = &tree,
                                         .skips = is_apart,
                                         .skips_slab = is_slab_apart,
                                         .ends = note_crossing,
                                         .data = &c});
    for (int i = 0; i < n; i++) {
      good = good && c.found[i] == meets(&c.t, &all[i]);
    }
    *seen += c.seen;
  }
  sg_work_tree_close(&tree);
  return good;
}

int
main(void)
{
  size_t seen = 0;

  for (int n = 0; n < 400; n++) {
    CHECK("all that a triangle meets", finds_crossing(n, &seen));
  }
  CHECK("most others are not looked at", seen < 400 * 200 * 20 / 2);
  for (int n = 0; n < 400; n++) {
    CHECK("each once", finds_all(n, 1 + n % 30));
  }
  return check_report();
}
