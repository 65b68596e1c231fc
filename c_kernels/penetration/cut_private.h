/* cut_private.h -- what cut_set.c and cut_piece.c share. */
#ifndef SG_CUT_PRIVATE_H
#define SG_CUT_PRIVATE_H

#include "cut_set.h"

/* Makes room for one more in a growing array; false: no memory. */
bool sg_cut_room(void **array, size_t n, size_t *room, size_t size);

/* Adds a piece, or finds the same one. Along an edge the smaller polygon
 * counts. False: no memory. */
bool sg_cut_add_piece(sg_cut_set *set, const sg_cut_piece *piece);

/* Drops the cuts along chords where polygons lie on each other. False: no
 * memory. */
bool sg_cut_drop_folds(sg_cut_set *set);

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
 * ones; orders the others. False: no memory. */
bool sg_cut_settle_contacts(sg_cut_set *set);

#endif
