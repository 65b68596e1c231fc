/* triangulate.h -- a whole polygon into triangles: the rule of
 * rules/polygon/triangulation.pl (PL-6) fused.
 *
 * Layer: kernel. The same steps over the same scratch relation, so the same
 * triangles in the same order as the rule; a test holds them together.
 */
#ifndef SG_TRIANGULATE_H
#define SG_TRIANGULATE_H

#include "engine/cancel.h"
#include "work.h"

typedef struct sg_triangle {
  int32_t v[3]; /* vertex handles, counter-clockwise from outside */
} sg_triangle;

typedef struct sg_triangles {
  sg_triangle *item; /* [n]; free(item) */
  size_t n, room;
  bool settled; /* turning chords again would change nothing: delaunay.h */
} sg_triangles;

typedef enum sg_outcome {
  SG_DONE,
  SG_STUCK,    /* an edge has no third vertex: the polygon is invalid */
  SG_STOPPED,  /* the cancellation, or that of the work's guard, said so */
  SG_TOO_MUCH, /* its guard said so */
  SG_NO_SPACE  /* no memory */
} sg_outcome;

/* Why something of the work had no memory: or its guard has ended it. */
sg_outcome sg_work_outcome(const sg_work *work);

/* sg_work_resolve(), which asks: SG_DONE, SG_STOPPED, SG_TOO_MUCH, SG_NO_SPACE.
 */
sg_outcome sg_work_resolve_asking(sg_work *work, double reach,
                                  const sg_cancel *cancel);

/* Takes triangles off until no edge is left, appending them to `out`. Stuck:
 * *edge is the edge that proves the polygon invalid (still living), and the
 * triangles found before it stay in `out`. The edges are used up. */
sg_outcome sg_work_triangulate(sg_work *work, sg_triangles *out, int32_t *edge,
                               const sg_cancel *cancel);
/* The same of vertices that rounding has moved by up to `moved`: a triangle no
 * wider than that was flat, so chords are turned, as delaunay.h says. */
sg_outcome sg_work_triangulate_moved(sg_work *work, double moved,
                                     sg_triangles *out, int32_t *edge,
                                     const sg_cancel *cancel);

#endif
