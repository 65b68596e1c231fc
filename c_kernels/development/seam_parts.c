/* seam_parts.c -- see seam_parts.h */
#include "seam_parts.h"

#include "seam_moats.h"

#include <math.h>
#include <stdlib.h>

/* Which of n sorted bends have another one so that the sum is as wanted. */
static void
mark_pairs(const double *bend, size_t n, double wanted, bool *paired)
{
  for (size_t i = 0, k = n; i < n; i++) {
    while (k > 0 && bend[i] + bend[k - 1] > wanted + SG_BENT_LEAST) {
      k--;
    }
    for (size_t m = k; m > 0 && bend[i] + bend[m - 1] >= wanted - SG_BENT_LEAST;
         m--) {
      if (m - 1 != i) {
        paired[i] = paired[m - 1] = true;
      }
    }
  }
}

/* The same for two others. */
static bool
mark_triples(const double *bend, size_t n, double wanted,
             const sg_cancel *cancel, bool *tripled, bool *stopped)
{
  for (size_t i = 0; i < n && !*stopped; i++) {
    size_t a = i + 1, b = n;
    *stopped = i % 64 == 0 && sg_cancelled(cancel);
    while (a + 1 < b) {
      double sum = bend[i] + bend[a] + bend[b - 1] - wanted;
      if (fabs(sum) <= 4 * SG_BENT_LEAST) {
        tripled[i] = tripled[a] = tripled[b - 1] = true;
      }
      if (sum > 0) {
        b--;
      } else {
        a++;
      }
    }
  }
  return !*stopped;
}

/* What is as bent as one that is marked is marked. */
static void
mark_equal(const double *bend, size_t n, bool *mark)
{
  const double near = 4 * SG_BENT_LEAST;

  for (size_t i = 1; i < n; i++) {
    mark[i] |= mark[i - 1] && bend[i] - bend[i - 1] <= near;
  }
  for (size_t i = n; i-- > 1;) {
    mark[i - 1] |= mark[i] && bend[i] - bend[i - 1] <= near;
  }
}

bool
sg_seam_parts_most(const double *bend, size_t n, const sg_cancel *cancel,
                   size_t *parts, bool *stopped)
{
  const double turns = 4 * acos(-1.0);
  bool *paired = calloc(n + 1, 1), *tripled = calloc(n + 1, 1);
  bool good = paired && tripled;
  size_t twelfths = 0;

  /* Three bends sum to less than three whole turns, and to no less than this.
   */
  double least = n > 0 ? fmin(0, floor(3 * bend[0] / turns)) : 0;

  *stopped = false;
  for (double k = least; good && k <= 1; k++) {
    mark_pairs(bend, n, k * turns, paired);
    good = n > SG_TRIPLES ||
           mark_triples(bend, n, k * turns, cancel, tripled, stopped);
  }
  if (good) {
    mark_equal(bend, n, tripled);
  }
  for (size_t i = 0; good && i < n; i++) {
    twelfths += paired[i] ? 6 : tripled[i] || n > SG_TRIPLES ? 4 : 3;
  }
  *parts = twelfths / 12;
  free(paired);
  free(tripled);
  return good;
}
