/* bvh_test.c -- the hits of trees against all pairs of boxes tried one by one,
 * and the same bytes from any number of threads. */
#include "tests/check.h"
#include "tests/stop_later.h"

#include "join/bvh_join.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 300 };

static uint64_t state = 88;

static unsigned
random_below(unsigned n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (unsigned)(state >> 33) % n;
}

/* Boxes between points of a grid, times `scale` and away by `away`. */
static void
random_boxes(sg_box *box, size_t n, unsigned size, double scale, double away)
{
  for (size_t i = 0; i < n; i++) {
    box[i] = sg_box_none();
    for (int k = 0; k < 2; k++) {
      double p[3];
      for (int c = 0; c < 3; c++) {
        p[c] = away + scale * random_below(size);
      }
      sg_box_add(&box[i], p);
    }
  }
}

typedef unsigned char seen_pairs[MOST][MOST];

/* Every pair that overlaps is found, none twice; what is found overlaps when
 * boxes are let out by `more`. */
static bool
is_right(const sg_box *a, size_t na, const sg_box *b, size_t nb, double reach,
         double more)
{
  static seen_pairs seen;
  sg_bvh *ta = sg_bvh_open(a, na, NULL);
  sg_bvh *tb = a == b ? ta : sg_bvh_open(b, nb, NULL);
  sg_bvh_hits hits = {0};
  bool good = ta && tb &&
              sg_bvh_join(&(sg_bvh_pair){ta, tb}, 1, reach, NULL, NULL, &hits);

  memset(seen, 0, sizeof seen);
  for (size_t k = 0; k < hits.n && good; k++) {
    uint32_t i = ta->item[hits.hit[k].a], j = tb->item[hits.hit[k].b];

    good = i < na && j < nb && !seen[i][j] && (a != b || !seen[j][i]) &&
           (a != b || i != j) && sg_box_overlap(&a[i], &b[j], reach + more);
    seen[i][j] = 1;
  }
  for (size_t i = 0; i < na; i++) {
    for (size_t j = 0; j < nb; j++) {
      bool found = seen[i][j] || (a == b && (seen[j][i] || i == j));
      good = good && (found || !sg_box_overlap(&a[i], &b[j], reach));
    }
  }
  for (size_t j = 0; good && reach == 0 && j < nb; j++) {
    size_t near = 0, met = 0;

    for (size_t i = 0; i < na; i++) {
      near += sg_box_overlap(&a[i], &b[j], more);
      met += sg_box_overlap(&a[i], &b[j], 0);
    }
    good = sg_bvh_meets(ta, &b[j]) ? near > 0 : met == 0;
  }
  free(hits.hit);
  sg_bvh_close(ta);
  if (tb != ta) {
    sg_bvh_close(tb);
  }
  return good;
}

static bool
random_joins(int n, double scale, double away)
{
  static sg_box a[MOST], b[MOST];

  for (int k = 0; k < n; k++) {
    size_t na = random_below(MOST), nb = random_below(60);
    double more = scale * (5 + k) * 1e-6 + fabs(away) * 1e-14;
    random_boxes(a, na, 4 + (unsigned)k, scale, away);
    random_boxes(b, nb, 4 + (unsigned)k, scale, away);
    if (!is_right(a, na, b, nb, 0, more) || !is_right(b, nb, a, na, 0, more) ||
        !is_right(a, na, a, na, 0, more) ||
        !is_right(a, na, b, nb, 2 * scale, more) ||
        !is_right(a, na, b, nb, 1e300, more)) {
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

/* ---- many boxes ---- */

enum { MANY = 100000 };

typedef struct soup {
  sg_box *box;
  sg_box all;
} soup;

static soup
make_soup(void)
{
  soup s = {malloc(MANY * sizeof *s.box), sg_box_none()};

  for (size_t i = 0; i < MANY; i++) {
    double p[3] = {random_below(100000), random_below(100000),
                   random_below(3000)};

    s.box[i] = sg_box_none();
    sg_box_add(&s.box[i], p);
    for (int c = 0; c < 3; c++) {
      p[c] += random_below(300);
    }
    sg_box_add(&s.box[i], p);
    sg_box_join(&s.all, &s.box[i]);
  }
  return s;
}

static void
give_boxes(const void *data, size_t begin, size_t end, sg_box *out)
{
  const soup *s = data;

  memcpy(out, s->box + begin, (end - begin) * sizeof *out);
}

static bool
same_tree(const sg_bvh *a, const sg_bvh *b)
{
  bool same = a->n == b->n && a->levels == b->levels &&
              memcmp(a->item, b->item, a->n * sizeof *a->item) == 0;

  for (unsigned k = 0; same && k < a->levels; k++) {
    same = memcmp(a->level[k], b->level[k],
                  (a->count[k] + SG_BVH_WIDTH - 1) / SG_BVH_WIDTH *
                      sizeof *a->level[k]) == 0;
  }
  return same;
}

/* One, two and four threads make the same tree and find the same hits. */
static bool
threads_agree(const soup *s)
{
  sg_bvh *first = NULL;
  sg_bvh_hits hits = {0};
  bool good = true;

  for (unsigned threads = 1; threads <= 4; threads *= 2) {
    sg_pool *pool = sg_pool_open(threads);
    sg_bvh *tree = sg_bvh_grow(MANY, give_boxes, s, NULL, &s->all, pool, NULL);
    sg_bvh_hits more;

    good = good && tree &&
           sg_bvh_join(&(sg_bvh_pair){tree, tree}, 1, 0, pool, NULL, &more);
    if (!first) {
      first = tree;
      hits = more;
    } else {
      good = good && same_tree(first, tree) && hits.n == more.n &&
             memcmp(hits.hit, more.hit, hits.n * sizeof *hits.hit) == 0;
      sg_bvh_close(tree);
      free(more.hit);
    }
    sg_pool_close(pool);
  }
  sg_bvh_close(first);
  free(hits.hit);
  return good && hits.n > 1000;
}

/* A cancel that says stop at its k-th question ends the work, with nothing left
 * behind (the leak check sees to that), until it is not asked so often. */
static bool
stops_anywhere(const soup *s)
{
  bool through = false;

  for (int k = 0; k < 2000 && !through; k = 2 * k + 1) {
    int left = k;
    sg_cancel cancel = {stop_later, &left};
    sg_pool *pool = sg_pool_open(2);
    sg_bvh *tree =
        sg_bvh_grow(MANY, give_boxes, s, NULL, &s->all, pool, &cancel);
    sg_bvh_hits hits = {0};

    through = tree && sg_bvh_join(&(sg_bvh_pair){tree, tree}, 1, 0, pool,
                                  &cancel, &hits);
    if (through != (left >= 0) || (k == 0 && tree)) {
      return false;
    }
    free(hits.hit);
    sg_bvh_close(tree);
    sg_pool_close(pool);
  }
  return through;
}

enum { ALIKE = 700 };

/* The same where each box meets each one: hits are copied for long. */
static bool
stops_among_hits(void)
{
  static sg_box box[ALIKE];
  int copying = 0;

  for (size_t i = 0; i < ALIKE; i++) {
    box[i] = (sg_box){{0, 0, 0}, {1, 1, 1}};
  }
  sg_bvh *a = sg_bvh_open(box, ALIKE, NULL), *b = sg_bvh_open(box, ALIKE, NULL);
  bool through = false, good = a && b;

  for (int k = 0; good && !through; k++) {
    int left = k;
    sg_cancel cancel = {stop_later, &left};
    sg_bvh_hits hits = {0};

    through = sg_bvh_join(&(sg_bvh_pair){a, b}, 1, 0, NULL, &cancel, &hits);
    good = through == (left >= 0) && hits.n == (through ? ALIKE * ALIKE : 0) &&
           (through || !hits.hit);
    copying = k;
    free(hits.hit);
  }
  sg_bvh_close(a);
  sg_bvh_close(b);
  return good && copying > ALIKE * ALIKE / 1024; /* after all that were found */
}

int
main(void)
{
  sg_box one = {{0, 0, 0}, {1, 1, 1}}, beside = {{1, 0, 0}, {2, 1, 1}},
         point = {{3, 3, 3}, {3, 3, 3}},
         far = {{1e300, -1e300, 0}, {1.5e308, 1e300, 0}};
  sg_box mixed[3] = {one, beside, far};
  sg_cancel stop = {stop_at_once, NULL};
  soup s = make_soup();

  CHECK("nothing meets nothing", is_right(NULL, 0, mixed, 0, 0, 0));
  CHECK("touching boxes meet", is_right(&one, 1, &beside, 1, 0, 0));
  CHECK("a point meets itself", is_right(&point, 1, &point, 1, 0, 0));
  CHECK("huge coordinates", is_right(mixed, 3, mixed, 3, 0, 1e301));
  CHECK("a reach beyond all floats", is_right(&one, 1, &beside, 1, 0, 1e60));
  CHECK("random boxes", random_joins(60, 1, 0));
  CHECK("tiny ones", random_joins(10, 1e-290, 0));
  CHECK("huge ones", random_joins(10, 1e290, 0));
  CHECK("far from the origin", random_joins(20, 0.001, 4e6));
  CHECK("a poll stops it", sg_bvh_open(mixed, 3, &stop) == NULL);
  CHECK("any number of threads", threads_agree(&s));
  CHECK("a poll stops it anywhere", stops_anywhere(&s));
  CHECK("a poll stops it among hits", stops_among_hits());
  free(s.box);
  return check_report();
}
