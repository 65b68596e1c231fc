/* resolve4pl.h -- a resolution under way, and how it is written.
 *
 * Layer: glue. Shared by resolve4pl.c (finding), resolve_body4pl.c (segments
 * that touch themselves), resolve_want4pl.c (the polygons it changes),
 * resolve_moves4pl.c (how far things move) and resolve_write4pl.c (writing).
 */
#ifndef SG_RESOLVE4PL_H
#define SG_RESOLVE4PL_H

#include "cut4pl.h"
#include "join/bodies.h"
#include "resolve_feature.h"
#include "resolve_polygon.h"

/* A segment that is paired with itself. Its bodies have the numbers below - 1,
 * below - 2, ... */
typedef struct sg_resolving_part {
  int32_t s, below;
  sg_bodies bodies;
} sg_resolving_part;

typedef struct sg_resolving {
  sg_cut_handle *handle; /* borrowed; what is read is in its version */
  sg_resolve r;          /* a segment in it may be a body, until all is found */
  SG_LIST_OF(sg_resolving_part) part;
  SG_LIST_OF(sg_resolved_polygon) polygon; /* by (s, p) */
  sg_key_table known;                      /* S, P: in `polygon` */
  sg_resolve_moves moves;
} sg_resolving;

/* Finds the bodies of the segments that are paired with themselves. False: an
 * exception. Owner: sg_resolving_bodies_clear() in any case. */
int sg_resolving_bodies_ex(sg_resolving *job);
void sg_resolving_bodies_clear(sg_resolving *job);

/* What stands for segment s where vertex v of it is: a body, or s. */
int32_t sg_resolving_body(const sg_resolving *job, int32_t s, int32_t v);
/* The segment of a body; of a segment, itself. */
int32_t sg_resolving_segment(const sg_resolving *job, int32_t body);

/* When all is found: puts segments for bodies in nodes, places and polygons. */
void sg_resolving_name_segments(sg_resolving *job);

/* Whether a place changes anything: a new vertex, or one that moves. */
bool sg_resolving_changes(const sg_resolving *job,
                          const sg_resolve_place *place);

/* False, with an exception: a signal stops it. To be asked at each step i. */
int sg_resolving_goes_on_ex(size_t i);

/* Notes which polygons are to be made anew, when the points are there. False:
 * an exception. */
int sg_resolving_want_ex(sg_resolving *job);

/* How far things move, when segments have their names. */
int sg_resolving_measure_ex(sg_resolving *job);

/* What cut_touch/4 says of that. */
int sg_resolving_unify_moves(const sg_resolving *job, term_t moves);

/* Writes all into the current world: the fused kernel of resolve.pl,
 * resolve_contacts_by_rule/2, with the same rows in the same order. False: an
 * exception; what was written by then stands (roll the transaction back). */
int sg_resolving_write_ex(const sg_resolving *job);

#endif
