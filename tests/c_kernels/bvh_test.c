/* bvh_test.c -- the pairs of two trees against all pairs tried one by one. */
#include "../check.h"

#include "../../c_kernels/bvh.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 300 };

static uint64_t state = 88;

static double
random_grid(unsigned n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (double)((unsigned)(state >> 33) % n);
}

static void
random_boxes(sg_box *box, size_t n, unsigned size)
{
  for (size_t i = 0; i < n; i++) {
    box[i] = sg_box_none();
    for (int k = 0; k < 2; k++) {
      sg_box_add(&box[i], (double[3]){random_grid(size), random_grid(size),
                                      random_grid(size)});
    }
  }
}

static bool
overlap(const sg_box *a, const sg_box *b)
{
  for (int c = 0; c < 3; c++) {
    if (a->lo[c] > b->hi[c] || b->lo[c] > a->hi[c]) {
      return false;
    }
  }
  return true;
}

static bool
same_pairs(const sg_box *a, size_t na, const sg_box *b, size_t nb)
{
  static unsigned char seen[MOST][MOST];
  sg_bvh *ta = sg_bvh_open(a, na, NULL), *tb = sg_bvh_open(b, nb, NULL);
  sg_bvh_pairs pairs;
  size_t i, j;
  bool good = ta && tb;

  memset(seen, 0, sizeof seen);
  sg_bvh_pairs_init(&pairs, ta, tb);
  while (sg_bvh_pairs_next(&pairs, &i, &j)) {
    good = good && i < na && j < nb && !seen[i][j];
    seen[i][j] = 1;
  }
  for (i = 0; i < na; i++) {
    for (j = 0; j < nb; j++) {
      good = good && seen[i][j] == overlap(&a[i], &b[j]);
    }
  }
  sg_bvh_close(ta);
  sg_bvh_close(tb);
  return good;
}

static bool
random_joins(int n)
{
  static sg_box a[MOST], b[MOST];

  for (int k = 0; k < n; k++) {
    size_t na = (size_t)random_grid(MOST), nb = (size_t)random_grid(60);
    random_boxes(a, na, 4 + (unsigned)k);
    random_boxes(b, nb, 4 + (unsigned)k);
    if (!same_pairs(a, na, b, nb) || !same_pairs(b, nb, a, na)) {
      return false;
    }
  }
  return true;
}

static bool
stop_at_once(void *data)
{
  (void)data;
  return true;
}

/* Asked on the way, too. */
static bool
walk_stops(void)
{
  enum { MANY = 20000 };
  sg_box *box = malloc(MANY * sizeof *box);
  sg_poll stop = {stop_at_once, NULL};
  sg_bvh_pairs pairs;
  size_t i, j, n = 0;

  for (i = 0; i < MANY; i++) {
    double at[3] = {random_grid(100000), random_grid(100000), 0};
    box[i] = (sg_box){{at[0], at[1], at[2]}, {at[0], at[1], at[2]}};
  }
  sg_bvh *tree = sg_bvh_open(box, MANY, NULL);

  sg_bvh_pairs_init(&pairs, tree, tree);
  pairs.poll = &stop;
  while (sg_bvh_pairs_next(&pairs, &i, &j)) {
    n++;
  }
  sg_bvh_close(tree);
  free(box);
  return pairs.stopped && n < MANY;
}

int
main(void)
{
  sg_box one = {{0, 0, 0}, {1, 1, 1}}, beside = {{1, 0, 0}, {2, 1, 1}},
         far = {{1e300, -1e300, 0}, {1.5e308, 1e300, 0}};
  sg_box mixed[3] = {one, beside, far};
  sg_poll stop = {stop_at_once, NULL};

  CHECK("nothing meets nothing", same_pairs(NULL, 0, NULL, 0));
  CHECK("touching boxes meet", same_pairs(&one, 1, &beside, 1));
  CHECK("huge coordinates", same_pairs(mixed, 3, mixed, 3));
  CHECK("random boxes", random_joins(60));
  CHECK("a poll stops it", sg_bvh_open(mixed, 3, &stop) == NULL);
  CHECK("a poll stops a walk", walk_stops());
  return check_report();
}
