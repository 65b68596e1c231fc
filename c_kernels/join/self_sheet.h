/* self_sheet.h -- triangles of one segment that have an edge or a vertex in one
 * place, but not the same one.
 *
 * Layer: kernel, private to self_leaf.c. What has the same vertices at an edge
 * is a SHEET there. The triangles' corners have names; place[3 * t + k] is
 * equal for corners in one place.
 */
#ifndef SG_SELF_SHEET_H
#define SG_SELF_SHEET_H

#include "self_join.h"

/* Of more sheets at an edge not each two are taken. */
enum { SG_SELF_SHEETS = 8 };

/* Whether there are more sheets at an edge, or many triangles at a place of
 * several vertices. False: no memory, or stopped. */
bool sg_self_sheets_are_many(const sg_fan_triangle *triangle, size_t n,
                             const uint32_t *place, const sg_cancel *cancel,
                             bool *many);

/* Adds to the hits pairs that are wanted of those that have an edge in one
 * place, each sheet with the first ones (no chords of a polygon, if there are
 * others), and a vertex, so that all are connected. The hits are of triangles
 * a < b; they are sorted then, each once. False: no memory, or stopped. */
bool sg_self_sheets_add(const sg_fan_triangle *triangle, size_t n,
                        const uint32_t *place, sg_self_wants *wants, void *data,
                        const sg_cancel *cancel, sg_bvh_hits *hits);

#endif
