/* chain.h -- lines end to end: the rule of rules/penetration/chain.pl fused.
 *
 * Layer: kernel. Lines of one group (a pair of segments) form a graph on their
 * vertices. A chain runs through vertices that have exactly two lines of the
 * group: from end to end, or round to where it began. Linear time; the order
 * is that of the rule, and a test holds the two together.
 *
 *   sg_chains chains;
 *   if (!sg_chains_make(line, n, &chains)) no_memory();
 *   for (size_t i = 0; i < chains.n; i++)
 *     use(&chains.step[chains.item[i].first], chains.item[i].n);
 *   sg_chains_clear(&chains);
 */
#ifndef SG_CHAIN_H
#define SG_CHAIN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A vertex: any two numbers (its names in two segments). */
typedef struct sg_chain_vertex {
  uint32_t name[2];
} sg_chain_vertex;

/* A line from vertex a to vertex b. */
typedef struct sg_chain_line {
  uint32_t group;
  sg_chain_vertex a, b;
} sg_chain_line;

/* A step is the number of a line, counted from 1; below zero: from b to a. */
typedef struct sg_chain {
  uint32_t group;
  bool closed;     /* it ends where it begins */
  bool point;      /* it is one line, from a vertex to itself */
  size_t first, n; /* its steps: step[first .. first + n - 1] */
} sg_chain;

typedef struct sg_chains {
  sg_chain *item; /* [n] */
  int32_t *step;  /* [lines]: every line is in one chain */
  size_t n;
} sg_chains;

/* The chains of all groups. Requires line[0 .. lines - 1] by group, ascending,
 * and lines < 2^31. In each group chains with ends come first, each from the
 * smaller line at one; then the others, from their smallest line in its own
 * direction. False: no memory. Owner: caller, sg_chains_clear(). */
bool sg_chains_make(const sg_chain_line *line, size_t lines, sg_chains *out);
void sg_chains_clear(sg_chains *chains);

#endif
