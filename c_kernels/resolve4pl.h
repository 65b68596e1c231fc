/* resolve4pl.h -- a resolution under way, and how it is written.
 *
 * Layer: glue. Shared by resolve4pl.c (finding), resolve_want4pl.c (the
 * polygons it changes) and resolve_write4pl.c (writing).
 */
#ifndef SG_RESOLVE4PL_H
#define SG_RESOLVE4PL_H

#include "cut4pl.h"
#include "resolve_polygon.h"

typedef struct sg_resolving {
  sg_cut_handle *handle; /* borrowed; what is read is in its version */
  sg_resolve r;
  SG_LIST_OF(sg_resolved_polygon) polygon; /* by (s, p) */
  sg_key_table known;                      /* S, P: in `polygon` */
} sg_resolving;

/* Whether a place changes anything: a new vertex, or one that moves. */
bool sg_resolving_changes(const sg_resolving *job,
                          const sg_resolve_place *place);

/* False, with an exception: a signal stops it. To be asked at each step i. */
int sg_resolving_goes_on_ex(size_t i);

/* Notes which polygons are to be made anew, when the points are there. False:
 * an exception. */
int sg_resolving_want_ex(sg_resolving *job);

/* Writes all into the current world: the fused kernel of resolve.pl,
 * resolve_contacts_by_rule/2, with the same rows in the same order. False: an
 * exception; what was written by then stands (roll the transaction back). */
int sg_resolving_write_ex(const sg_resolving *job);

#endif
