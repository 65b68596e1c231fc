/* known_surface4pl.h -- the smooth surfaces that the polygons of a world stand
 * for.
 *
 * Layer: glue. Include it before SWI-Prolog.h.
 */
#ifndef SG_KNOWN_SURFACE4PL_H
#define SG_KNOWN_SURFACE4PL_H

#include "../engine/world4pl.h"

#include "dense.h"
#include "known_surface.h"

#include <SWI-Prolog.h>

/* Polygons first to last of segment s are facets of a surface (a place in
 * sg_known.surface, -1: of none). */
typedef struct sg_known_run {
  int32_t s, first, last;
  int32_t surface;
} sg_known_run;

/* What known_surfaces/1 says (rules/known_surface.pl). */
typedef struct sg_known {
  bool kept; /* nothing is said: what was said before counts */
  sg_known_surface *surface;
  sg_known_run *run; /* by segment and first; a segment that has none here got
                        its polygons from others (from_p/5) */
  size_t surfaces, runs;
  size_t surface_room, run_room;
} sg_known;

/* `kept`, or a list of known(S, Surfaces, Runs) in the order of S; false: an
 * exception is pending. sg_known_clear() in any case. */
int sg_get_known_ex(term_t t, sg_known *out);
void sg_known_clear(sg_known *known);

/* The surfaces of the polygons of a model of `version`. False: stopped by the
 * poll, or no memory (then *memory is false). The caller calls
 * sg_known_surfaces_clear() in any case. */
bool sg_known_surfaces_read(const sg_known *known, const sg_version *version,
                            const sg_dense *dense, const sg_poll *poll,
                            sg_known_surfaces *out, bool *memory);

#endif
