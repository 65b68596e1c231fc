/* edge_pairs_test.c -- groups of edges against a search through all of them. */
#include "tests/check.h"

#include "rows/edge_pairs.h"

#include <stdlib.h>

static uint64_t seed = 3;

static uint32_t
random_below(uint32_t n)
{
  seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (uint32_t)((seed >> 33) % n);
}

/* How many edges run from v to w. */
static size_t
count_edges(size_t n, const int32_t *from, const int32_t *to, uint32_t v,
            uint32_t w)
{
  size_t count = 0;

  for (size_t i = 0; i < n; i++) {
    count += (uint32_t)from[i] == v && (uint32_t)to[i] == w;
  }
  return count;
}

/* Whether a group has the edges between its vertices, forward ones first, each
 * kind by number. */
static bool
is_right(const sg_edge_pairs *pairs, const sg_edge_group *g,
         const int32_t *from, const int32_t *to)
{
  size_t there = count_edges(pairs->n, from, to, g->low, g->high);
  size_t back =
      g->low == g->high ? 0 : count_edges(pairs->n, from, to, g->high, g->low);

  if (g->forward != there || g->end - g->begin != there + back) {
    return false;
  }
  for (size_t k = g->begin; k < g->end; k++) {
    uint32_t e = sg_edge_group_edge(pairs, k);
    bool forward = k < g->begin + g->forward;

    if ((uint32_t)from[e] != (forward ? g->low : g->high) ||
        (uint32_t)to[e] != (forward ? g->high : g->low) ||
        (k > g->begin && k != g->begin + g->forward &&
         sg_edge_group_edge(pairs, k - 1) >= e)) {
      return false;
    }
  }
  return true;
}

/* Few vertices with many edges each, or many with few. */
static void
check_random(uint32_t vertices)
{
  enum { EDGES = 400 };
  int32_t from[EDGES], to[EDGES];
  sg_edge_pairs pairs;
  sg_edge_group group = {0}, found;
  size_t edges = 0, wrong = 0;
  bool stopped;

  for (int i = 0; i < EDGES; i++) {
    from[i] = (int32_t)random_below(vertices);
    to[i] = (int32_t)random_below(vertices);
  }
  CHECK("made",
        sg_edge_pairs_make(EDGES, from, to, vertices, NULL, &pairs, &stopped));
  while (sg_edge_group_next(&pairs, &group)) {
    edges += group.end - group.begin;
    wrong += !is_right(&pairs, &group, from, to);
    wrong += !sg_edge_group_find(&pairs, group.high, group.low, &found) ||
             found.begin != group.begin || found.end != group.end;
  }
  CHECK("each edge once", edges == EDGES);
  CHECK("groups", wrong == 0);
  for (uint32_t v = 0; v < vertices; v++) {
    wrong += sg_edge_group_find(&pairs, v, 0, &found) !=
             (count_edges(EDGES, from, to, v, 0) +
                  count_edges(EDGES, from, to, 0, v) >
              0);
  }
  CHECK("found if it is there", wrong == 0);
  sg_edge_pairs_clear(&pairs);
}

static void
check_closed(void)
{
  int32_t from[3] = {0, 1, 2}, to[3] = {1, 0, 0};
  sg_edge_pairs pairs;
  bool stopped;

  CHECK("made", sg_edge_pairs_make(2, from, to, 3, NULL, &pairs, &stopped));
  CHECK("closed", sg_edge_pairs_closed(&pairs));
  sg_edge_pairs_clear(&pairs);
  CHECK("made", sg_edge_pairs_make(3, from, to, 3, NULL, &pairs, &stopped));
  CHECK("not closed", !sg_edge_pairs_closed(&pairs));
  sg_edge_pairs_clear(&pairs);
}

static bool
count_down(void *data)
{
  return --*(int *)data < 0;
}

/* All edges at one vertex: what takes long is sorting them. */
static void
check_fan(void)
{
  enum { EDGES = 200000 };
  int32_t *from = calloc(EDGES, sizeof *from);
  int32_t *to = malloc(EDGES * sizeof *to);
  int most = 1000000, asks = most;
  sg_edge_pairs pairs;
  bool stopped;

  for (int32_t i = 0; i < EDGES; i++) {
    to[i] = EDGES - i;
  }
  CHECK("made",
        sg_edge_pairs_make(EDGES, from, to, EDGES + 1,
                           &(sg_cancel){count_down, &asks}, &pairs, &stopped));
  sg_edge_pairs_clear(&pairs);
  int asked = most - asks;

  CHECK("the poll is asked while they are sorted, too",
        asked > 4 * (EDGES / 4096));
  asks = asked / 2;
  CHECK("it can be stopped there",
        !sg_edge_pairs_make(EDGES, from, to, EDGES + 1,
                            &(sg_cancel){count_down, &asks}, &pairs,
                            &stopped) &&
            stopped);
  sg_edge_pairs_clear(&pairs);
  free(from);
  free(to);
}

int
main(void)
{
  check_random(5);
  check_random(20);
  check_random(500);
  check_closed();
  check_fan();
  return check_report();
}
