/* stroke_rows.h -- looks, parts and strokes between terms and the kernel.
 *
 * Layer: rows. Shared by stroke_rows.c (parts as terms) and drawn_stroke_rows.c
 * (parts as rows).
 */
#ifndef SG_STROKE_ROWS_H
#define SG_STROKE_ROWS_H

#include "doors/drawing.h"
#include "stroke.h"

/* The place of a look, or looks->n; `last` is tried first. */
size_t sg_looks_find(const sg_ranked_look_list *looks, int32_t visibility,
                     int32_t role, size_t last);

/* domain_error(sheet_coordinate, X): not below 2^52. */
bool sg_sheet_point_at(sg_call *call, const sg_sheet_point *p, int64_t out[2]);

SG_CALL_LIST(sg_stroke_parts, sg_stroke_part);

/* Adds parts: domain_error(look, Argument), domain_error(sheet_coordinate, X).
 */
bool sg_parts_add(sg_call *call, const sg_sheet_part_list *parts, int argument,
                  const sg_ranked_look_list *looks, sg_stroke_parts *out);

/* The strokes of parts, which are sorted. */
bool sg_strokes_of(sg_call *call, const sg_ranked_look_list *looks,
                   sg_stroke_parts *parts, sg_sheet_stroke_list *out);

#endif
