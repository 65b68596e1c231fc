/* resolve_rows.h -- a resolution under way, and how it is written.
 *
 * Layer: rows. Shared by resolve_rows.c (finding), resolve_body_rows.c
 * (segments that touch themselves), resolve_want_rows.c (the polygons it
 * changes), resolve_moves_rows.c (how far things move) and resolve_write_rows.c
 * (writing).
 */
#ifndef SG_RESOLVE_ROWS_H
#define SG_RESOLVE_ROWS_H

#include "cut_rows.h"
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

/* Finds the bodies of the segments that are paired with themselves. Owner:
 * sg_resolving_bodies_clear() in any case. */
bool sg_resolving_bodies(sg_call *call, sg_resolving *job);
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

/* False: it is to stop. To be asked at each step i. */
bool sg_resolving_goes_on(sg_call *call, size_t i);

/* Notes which polygons are to be made anew, when the points are there. */
bool sg_resolving_want(sg_call *call, sg_resolving *job);

/* How far things move, when segments have their names. */
bool sg_resolving_measure(sg_call *call, sg_resolving *job);

/* What cut_touch/4 says of that. */
struct sg_touch_moves;
void sg_resolving_moves(const sg_resolving *job, struct sg_touch_moves *out);

/* near(v(S, V)), or near(ll(S1-(V1, V2), S2-(V3, V4))), as sg_call_term(). */
const uint32_t *sg_resolving_origin(sg_call *call, const sg_resolve_node *node);

/* Writes all into the current world: the fused kernel of resolve.pl,
 * resolve_contacts_by_rule/2, with the same rows in the same order. False:
 * what was written by then stands (roll the transaction back). */
bool sg_resolving_write(sg_call *call, const sg_resolving *job);

#endif
