/* known_surface4pl.h -- the smooth surfaces that the polygons of a world stand
 * for, and the named faces they are of.
 *
 * Layer: glue. Include it before SWI-Prolog.h.
 */
#ifndef SG_KNOWN_SURFACE4PL_H
#define SG_KNOWN_SURFACE4PL_H

#include "engine/world4pl.h"

#include "known_surface.h"
#include "rows/dense.h"

#include <SWI-Prolog.h>

/* What Prolog calls them. */
extern const char *const sg_known_kind_name[];

/* Polygons first to last of segment s are facets of a surface (a place in
 * sg_known.surfaces); or, if that is SG_NOT_KNOWN, of face `face` (less than
 * 0), or each one a face (0). */
typedef struct sg_known_run {
  int32_t s, first, last; /* first > last: it says only that s is known */
  int32_t surface, face;
} sg_known_run;

/* Segment s has its polygons from others (from_p/5), moved as a whole: the new
 * x is A*x + B*y + C*z + D, with the first row A, B, C, D. */
typedef struct sg_known_map {
  int32_t s;
  double row[3][4];
} sg_known_map;

/* What known_surfaces/1 says (rules/csg/known_surface.pl). */
typedef struct sg_known {
  bool kept;                  /* nothing is said: what was said before counts */
  sg_known_surfaces surfaces; /* of no polygons */
  sg_known_run *run; /* by segment and first; a segment that has none here got
                        its polygons from others (from_p/5) */
  sg_known_map *map; /* by segment */
  size_t runs, maps;
  size_t surface_room, run_room, map_room;
} sg_known;

/* `kept`, or a list of known(S, Surfaces, Runs) and moved(S, Map) in the order
 * of S; false: an exception is pending. sg_known_clear() in any case. */
int sg_get_known_ex(term_t t, sg_known *out);
void sg_known_clear(sg_known *known);

/* The surfaces of the polygons of a model of `version`. False: stopped by the
 * poll, or no memory (then *memory is false). The caller calls
 * sg_known_surfaces_clear() in any case. */
bool sg_known_surfaces_read(const sg_known *known, const sg_version *version,
                            const sg_dense *dense, const sg_poll *poll,
                            sg_known_surfaces *out, bool *memory);

#endif
