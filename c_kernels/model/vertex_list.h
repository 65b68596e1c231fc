/* vertex_list.h -- polygons as they are typed in, lists of vertices, and what
 * is wrong with one: rules/polygon/polygon_list.pl says the same.
 *
 * Layer: kernel. Exact.
 */
#ifndef SG_VERTEX_LIST_H
#define SG_VERTEX_LIST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_list_edge {
  int32_t from, to;
} sg_list_edge;

typedef enum sg_border_fault {
  SG_BORDER_GOOD,
  SG_BORDER_EDGES,   /* fewer than three */
  SG_BORDER_NO_EDGE, /* one from a vertex to itself: the first */
  SG_BORDER_TWICE,   /* one stands twice: the least */
  SG_BORDER_OPEN     /* not as many end at a vertex as start there */
} sg_border_fault;

/* The edges of a list of n vertices, n at most, in its order; a negative one
 * is a jump. False: it is empty, begins or ends with a jump, or jumps twice. */
bool sg_vertex_list_edges(const int32_t *v, size_t n, sg_list_edge *out,
                          size_t *edges);

/* The first of these faults that n edges have; what[0..1]: the vertices, if it
 * names some. Sorts the edges; `scratch` has room for n. */
sg_border_fault sg_border_find_fault(sg_list_edge *edge, size_t n,
                                     int32_t *scratch, int32_t what[2]);

#endif
