/* solid_over.h -- a solid written over the rows of an earlier one.
 *
 * Layer: kernel. A boundary that is made again mostly differs in few faces from
 * what its segment has already. What is the same stays, row for row, with its
 * ids; so an edit changes few rows, and whoever keeps the version before it
 * (undo) keeps little more than these.
 *
 *   - A vertex stays if it is in the same place, was the same vertex of an
 *     operand, and has the same origin.
 *   - A face stays if its triangles, its edges and what it comes from are the
 *     same, in the same order, on vertices that stay, and if it has a plane.
 *   - All other rows go. What is new has the least ids that are free, in the
 *     order of the solid.
 *
 * So except for the ids the segment has the rows that solid_out.h would write.
 *
 * Of a REGION (solid_old.h) nothing else is looked at: its new faces have to go
 * in where the old ones were.
 */
#ifndef SG_SOLID_OVER_H
#define SG_SOLID_OVER_H

#include "engine/sheet.h"
#include "solid_old.h"
#include "solid_out.h"

#include <string.h>

/* The key of a place, for a key table: of equal coordinates, be one -0.0. */
static inline void
sg_place_key(const double at[3], uint32_t key[6])
{
  double p[3] = {at[0] + 0.0, at[1] + 0.0, at[2] + 0.0}; /* never -0.0 */

  memcpy(key, p, sizeof p);
}

/* Rows of one relation that are new: column[c] is an array by its type. */
typedef struct sg_over_rows {
  size_t n;
  void *column[SG_MAX_COLUMNS];
} sg_over_rows;

typedef struct sg_solid_over {
  /* The solid's vertices and faces as places among the old ones: SG_NO_PLACE:
   * it is new. */
  uint32_t *vertex, *face;
  size_t faces_stay;
  uint8_t *gone[SG_OLD_RELATIONS]; /* [rows] by place: 1: it goes */
  /* What is new. */
  sg_solid rest;             /* its faces; all vertices, borrowed */
  sg_solid_rows rest_rows;   /* the rows of rest, ids dense */
  int32_t *id[SG_OLD_T + 1]; /* V, E, P, T: those that ids of rest become */
  sg_over_rows fresh[SG_OLD_RELATIONS]; /* of ORIGIN: column 1 has vertices, 2
                                           their origins, borrowed */
  int32_t *list;                        /* all lists of p */
} sg_solid_over;

/* What of `old` stays when `rows` are written over it: vertex, face,
 * faces_stay, gone. False: no memory, or stopped. Owner: sg_solid_over_clear()
 * in any case. Exact. */
bool sg_solid_over_match(const sg_solid_rows *rows, const sg_solid_old *old,
                         const sg_cancel *cancel, sg_solid_over *out);
/* Of a region: the new faces are bounded by the edges that bounded the old
 * ones, once in 2^64 by chance, and of the new vertices none is where another
 * of the segment is. False also without memory, or stopped. */
bool sg_solid_over_fits(const sg_solid_rows *rows, const sg_solid_old *old,
                        const sg_solid_over *over, const sg_cancel *cancel);
/* Then the rows that are new, of segment s: the rest. The same. */
bool sg_solid_over_write(const sg_solid_rows *rows, const sg_solid_old *old,
                         int32_t s, sg_pool *pool, const sg_cancel *cancel,
                         sg_solid_over *out);
void sg_solid_over_clear(sg_solid_over *over);

#endif
