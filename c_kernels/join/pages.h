/* pages.h -- faces in order round an edge that they have in common.
 *
 * Layer: kernel. Exact, of doubles: orient3d and turns alone. Looking along the
 * edge from `u` to `w` they come counter-clockwise: behind a page that runs
 * this way is what is below it.
 */
#ifndef SG_PAGES_H
#define SG_PAGES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The directed edge `edge` of a face that has a point beside it at `beside`;
 * where pages lie on each other the lower `rank` comes first. */
typedef struct sg_page_at_edge {
  uint32_t edge;
  bool forward; /* from u to w */
  int64_t rank;
  double beside[3];
  bool on_last; /* out: it lies on the page before it */
  int quarter;  /* private */
} sg_page_at_edge;

/* Puts n pages in order round the edge, beginning with the first, or what lies
 * on it, so that matter is behind the page of a forward edge. True: forward
 * and backward alternate; if not, sheets cross, or end there. */
bool sg_pages_order(const double u[3], const double w[3], sg_page_at_edge *page,
                    size_t n);

#endif
