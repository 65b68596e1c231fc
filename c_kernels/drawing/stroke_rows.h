/* stroke_rows.h -- looks, parts and strokes between terms and the kernel.
 *
 * Layer: rows. Shared by stroke_rows.c (parts as terms) and drawn_stroke_rows.c
 * (parts as rows).
 */
#ifndef SG_STROKE_ROWS_H
#define SG_STROKE_ROWS_H

#include "doors/drawing.h"
#include "engine/list.h"
#include "stroke.h"

/* The place of a look, or looks->n; `last` is tried first. */
size_t sg_looks_find(const sg_ranked_look_list *looks, int32_t visibility,
                     int32_t role, size_t last);

/* domain_error(sheet_coordinate, X): not below 2^31. */
bool sg_sheet_point_at(sg_call *call, const sg_sheet_point *p, int32_t out[2]);

/* Owner: the caller, free(item), or sg_chains_of(). */
typedef SG_LIST_OF(sg_stroke_part) sg_stroke_parts;

bool sg_part_add(sg_call *call, sg_stroke_parts *parts, sg_stroke_part part);

/* Adds parts: domain_error(look, Argument), domain_error(sheet_coordinate, X).
 */
bool sg_parts_add(sg_call *call, const sg_sheet_part_list *parts, int argument,
                  const sg_ranked_look_list *looks, sg_stroke_parts *out);

/* Strokes that stay: the object of a handle. */
struct sg_chains {
  sg_strokes strokes;
  sg_stroke_part *part;
  sg_ranked_look *look;
};

/* The strokes of the parts, which it takes; null: refused, or `good` is false.
 */
sg_chains *sg_chains_of(sg_call *call, bool good,
                        const sg_ranked_look_list *looks,
                        sg_stroke_parts *parts);

/* Whether chains has strokes from..to, counted from 1; else domain_error(chain,
 * Argument). */
bool sg_chains_have(sg_call *call, const sg_chains *chains, size_t from,
                    size_t to, int argument);

/* Where stroke k starts, or ends. */
const int32_t *sg_chain_end(const sg_chains *chains, size_t k, bool end);

#endif
