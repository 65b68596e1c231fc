/* face_look_rows.h -- which look each face has, and how opaque looks are, from
 * terms.
 *
 * Layer: rows.
 */
#ifndef SG_FACE_LOOK_ROWS_H
#define SG_FACE_LOOK_ROWS_H

#include "doors/shading.h"
#include "shading_scene.h"

/* For leaf 1, 2, ... the places of looks, each less than `looks`: its own, and
 * those of its faces. Owner: the call. False: refused, argument `argument`. */
bool sg_face_numbers_read(sg_call *call, const sg_list_count_list *leaves,
                          size_t looks, int argument, sg_face_numbers *out);

/* An opacity of 0 .. 1. False: refused. */
bool sg_opacity_read(sg_call *call, double fact, int argument, uint32_t *out);

/* How opaque looks are, argument 3, and the looks of leaves, argument 4;
 * *clear: something is not opaque. Refused: false. */
bool sg_opacities_read(sg_call *call, const sg_number_list *looks,
                       const sg_list_count_list *leaves, sg_opacities *out,
                       bool *clear);

#endif
