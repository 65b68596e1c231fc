/* cut_private.h -- what cut_set.c and cut_piece.c share. */
#ifndef SG_CUT_PRIVATE_H
#define SG_CUT_PRIVATE_H

#include "cut_set.h"
#include "engine/list.h"

/* Adds a piece, or finds the same one. Along an edge the smaller polygon
 * counts. False: no memory. */
bool sg_cut_add_piece(sg_cut_set *set, const sg_cut_piece *piece);

/* Whether side 0..2 of a leaf triangle is inside a face: a chord of its
 * polygon, or an edge that only one other triangle has, which goes on in the
 * same plane: exactly, or within set->flat_within. 1, 0, or -1: no memory. Only
 * asked where a cut lies on it. *face: the smaller polygon of the face there.
 */
int sg_cut_is_inside(sg_cut_set *set, uint32_t triangle, int side,
                     int32_t *face);

/* Whether a cut of two triangles is inside the faces of both. */
int sg_cut_along_inside(sg_cut_set *set, const uint32_t t[2],
                        const sg_cut *cut);

/* Notes that corners at the ends of a cut are inside a common part of two
 * faces. False: no memory. */
bool sg_cut_note_inside(sg_cut_set *set, const uint32_t t[2],
                        const sg_cut *cut);

/* Whether two triangles are in one plane within set->flat_within, as those are
 * that were made to touch; false if it is 0. */
bool sg_cut_is_flat_pair(const sg_cut_set *set, const uint32_t t[2]);

/* Keeps a point in common of two triangles in one plane until all cuts are
 * entered; then those that are inside no common part become contacts. False: no
 * memory, or stopped. */
bool sg_cut_put_off(sg_cut_set *set, const uint32_t t[2],
                    const sg_cut_end *end);
bool sg_cut_touch_flat(sg_cut_set *set, const sg_cancel *cancel);

/* Drops the cuts inside faces where these lie on each other. False: no
 * memory, or stopped. */
bool sg_cut_drop_folds(sg_cut_set *set, const sg_cancel *cancel);

/* Puts a point on a split edge, in order, if it is not there yet; that makes
 * the edge late. False: no memory. */
bool sg_cut_put_late(sg_cut_set *set, uint32_t edge, uint32_t point);

/* The point of one end of a cut of triangles t[0], t[1]; notes it on the real
 * edges it lies on. SG_NO_KEY: no memory. */
uint32_t sg_cut_end_point(sg_cut_set *set, const uint32_t t[2],
                          const sg_cut_end *end);

/* Keeps a point that the triangles have in common: 0, or -1: no memory. */
int sg_cut_touch(sg_cut_set *set, const uint32_t t[2], const sg_cut_end *end);

/* Drops the contacts at which a piece of their segments ends, and repeated
 * ones; orders the others. False: no memory, or stopped. */
bool sg_cut_settle_contacts(sg_cut_set *set, const sg_cancel *cancel);

#endif
