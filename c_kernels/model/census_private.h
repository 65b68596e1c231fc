/* census_private.h -- the work of a census, shared by its files. */
#ifndef SG_CENSUS_PRIVATE_H
#define SG_CENSUS_PRIVATE_H

#include "census.h"
#include "polygon/loops.h"
#include "rows/edge_pairs.h"

typedef struct sg_counting {
  const sg_dense *d;
  const double (*plane)[4]; /* [polygons] or null */
  sg_census *out;
  const sg_cancel *cancel;
  bool stopped;
  size_t s; /* the segment at work */
  sg_part *part;
  int32_t *owner;        /* [edges] the polygon, or -1 */
  int32_t *next;         /* [edges] the half-edge that follows in its polygon */
  int32_t *opposite;     /* [edges] in a pair, else -1 */
  uint32_t *shell_of;    /* [polygons] disjoint sets, later the shell */
  uint32_t *seen;        /* [vertices] */
  int32_t *fans;         /* [vertices] */
  uint32_t *triangles;   /* [polygons] how many */
  double *area, *volume; /* [polygons] the volume six times */
  uint64_t *sides;       /* [polygons] of triangles, the sum of sg_edge_print():
                            that of the polygon's edges if they fill it */
  int32_t *loops_of;     /* [polygons] */
  bool *bad;             /* [polygons] has an edge that is no pair */
  sg_loops loops;
  int32_t *from, *to; /* [longest polygon] */
} sg_counting;

/* Whether the work is to stop, asked in step i of a long loop. */
static inline bool
sg_census_stops(sg_counting *c, size_t i)
{
  c->stopped = c->stopped || sg_cancel_every(c->cancel, i);
  return c->stopped;
}

/* False, here and below: no memory, or stopped. Ids as the defect says. */
bool sg_census_note(sg_counting *c, sg_defect_kind kind, int32_t a, int32_t b);

/* Areas, volumes, flatness and doubles of the polygons; places of vertices. */
bool sg_census_faces(sg_counting *c);
bool sg_census_doubles(sg_counting *c);
bool sg_census_vertices(sg_counting *c);

/* How deep the shells of the segment are in each other. */
bool sg_census_depths(sg_counting *c);

#endif
