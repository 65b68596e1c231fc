/* sort.c -- see sort.h. Runs by qsort(), then merged two by two. */
#include "sort.h"

#include <stdlib.h>
#include <string.h>

enum { RUN = 4096 };

typedef struct job {
  char *from, *to; /* merging goes from one array to the other */
  size_t n, size;
  sg_sort_compare *compare;
} job;

static bool
is_sorted(const char *base, size_t n, size_t size, sg_sort_compare *compare)
{
  for (size_t i = 1; i < n; i++) {
    if (compare(base + (i - 1) * size, base + i * size) > 0) {
      return false;
    }
  }
  return true;
}

static size_t
least(size_t a, size_t b)
{
  return a < b ? a : b;
}

/* Merges the two runs of `run` records that begin at `at`. */
static void
merge(const job *j, size_t at, size_t run)
{
  size_t middle = least(at + run, j->n), end = least(at + 2 * run, j->n);
  size_t a = at, b = middle;

  for (size_t k = at; k < end; k++) {
    bool first =
        a < middle && (b == end || j->compare(j->from + a * j->size,
                                              j->from + b * j->size) <= 0);
    memcpy(j->to + k * j->size, j->from + (first ? a++ : b++) * j->size,
           j->size);
  }
}

/* False: stopped, with every record in j->from. */
static bool
merge_all(job *j, const sg_poll *poll)
{
  for (size_t run = RUN; run < j->n; run *= 2) {
    char *swap = j->from;
    for (size_t at = 0; at < j->n; at += 2 * run) {
      if (sg_poll_stop(poll)) {
        return false;
      }
      merge(j, at, run);
    }
    j->from = j->to;
    j->to = swap;
  }
  return true;
}

sg_sort_end
sg_sort(void *base, size_t n, size_t size, sg_sort_compare *compare,
        const sg_poll *poll)
{
  job j = {base, NULL, n, size, compare};
  bool done;

  if (n < 2 || is_sorted(base, n, size, compare)) {
    return SG_SORTED;
  }
  for (size_t at = 0; at < n; at += RUN) {
    if (sg_poll_stop(poll)) {
      return SG_SORT_STOPPED;
    }
    qsort(j.from + at * size, least(RUN, n - at), size, compare);
  }
  if (n <= RUN) {
    return SG_SORTED;
  }
  j.to = malloc(n * size);
  if (!j.to) {
    return SG_SORT_NO_MEMORY;
  }
  done = merge_all(&j, poll);
  if (j.from != base) {
    memcpy(base, j.from, n * size);
  }
  free(j.from == base ? j.to : j.from);
  return done ? SG_SORTED : SG_SORT_STOPPED;
}
