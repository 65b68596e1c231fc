/* cut_private.h -- what cut_set.c and cut_piece.c share. */
#ifndef SG_CUT_PRIVATE_H
#define SG_CUT_PRIVATE_H

#include "cut_set.h"

/* Makes room for one more in a growing array; false: no memory. */
bool sg_cut_room(void **array, size_t n, size_t *room, size_t size);

/* Adds a piece, or finds the same one: pieces of one pair of segments between
 * the same points are one. Along an edge the smaller polygon counts. False: no
 * memory. */
bool sg_cut_add_piece(sg_cut_set *set, const sg_cut_piece *piece);

/* Drops the cuts along chords where polygons lie on each other. False: no
 * memory. */
bool sg_cut_drop_folds(sg_cut_set *set);

/* Puts a point on a split edge, in order, if it is not there yet; that makes
 * the edge late. False: no memory. */
bool sg_cut_put_late(sg_cut_set *set, uint32_t edge, uint32_t point);

#endif
