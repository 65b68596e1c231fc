/* edge_print.h -- whether directed edges are in balance, by a fingerprint.
 *
 * Layer: kernel. The sum over all edges is 0 if as many run from a to b as from
 * b to a, for all a and b; and else it is not, but once in 2^64.
 */
#ifndef SG_EDGE_PRINT_H
#define SG_EDGE_PRINT_H

#include <stdint.h>

/* Spreads 64 bits: the finaliser of a well-known generator (splitmix64). */
static inline uint64_t
sg_spread_bits(uint64_t x)
{
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}

/* What the edge from a to b adds. */
static inline uint64_t
sg_edge_print(uint32_t a, uint32_t b)
{
  uint64_t low = a < b ? a : b, high = a < b ? b : a;
  uint64_t print = sg_spread_bits(low << 32 | high);

  return a < b ? print : 0 - print;
}

#endif
