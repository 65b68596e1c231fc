/* disjoint.h -- disjoint sets of numbers, joined two at a time (union-find).
 *
 * Layer: kernel. `of[i]` is a number of the same set, on the way to its root:
 * the lowest number of the set, whatever the order of joining. At first
 * `of[i] == i` for all i.
 */
#ifndef SG_DISJOINT_H
#define SG_DISJOINT_H

#include <stdint.h>

/* The root of the set of i; halves the way there. */
static inline uint32_t
sg_disjoint_root(uint32_t *of, uint32_t i)
{
  while (of[i] != i) {
    i = of[i] = of[of[i]];
  }
  return i;
}

/* The sets of i and k are one. */
static inline void
sg_disjoint_join(uint32_t *of, uint32_t i, uint32_t k)
{
  uint32_t a = sg_disjoint_root(of, i), b = sg_disjoint_root(of, k);

  of[a < b ? b : a] = a < b ? a : b;
}

#endif
