/* face_merge_sheet.h -- which triangles of a list meet.
 *
 * Layer: kernel, private to face_merge. The first triangles of the list are
 * asked about, the others are what is near them. Each has a key; what comes out
 * are pairs of keys.
 *
 *   sg_sheet sheet = {.m = m};
 *   sg_sheet_add() each triangle that is asked about
 *   sg_sheet_mark()
 *   sg_sheet_add() each other one that sg_sheet_is_near()
 *   sg_sheet_folds()
 *   sg_sheet_meet()
 *   sg_sheet_clear()
 */
#ifndef SG_FACE_MERGE_SHEET_H
#define SG_FACE_MERGE_SHEET_H

#include "face_merge_private.h"

typedef struct sg_sheet_grid sg_sheet_grid;

typedef struct sg_sheet {
  const sg_merge *m;
  int32_t (*corner)[3]; /* [n]: vertices of m->solid */
  uint32_t *key;        /* [n] */
  size_t n, room;
  size_t asked; /* the first ones */
  sg_sheet_grid *grid;
} sg_sheet;

/* low <= high. */
typedef struct sg_key_pair {
  uint32_t low, high;
} sg_key_pair;

typedef struct sg_key_pairs {
  sg_key_pair *item; /* [n], in order */
  size_t n, room;
} sg_key_pairs;

/* Keys, and an edge that triangles of both have. */
typedef struct sg_fold {
  sg_key_pair key, edge;
} sg_fold;

typedef struct sg_folds {
  sg_fold *item; /* [n], in order of keys */
  size_t n, room;
} sg_folds;

/* False: no memory. */
bool sg_sheet_add(sg_sheet *sheet, const uint32_t corner[3], uint32_t key);

/* What was added is asked about; what is added from now on is not. False: no
 * memory. */
bool sg_sheet_mark(sg_sheet *sheet);

/* False: it can have nothing in common with what is asked about. */
bool sg_sheet_is_near(const sg_sheet *sheet, const uint32_t corner[3]);

/* The keys of the triangles that fold, one of them asked about: they have an
 * edge in common, and one lies back on the other, within two tolerances. So do
 * the two sides of a wall that has become nothing, whatever chords divide them.
 * Owner of out->item: caller, free(). */
sg_merge_end sg_sheet_folds(const sg_sheet *sheet, sg_folds *out);

/* The keys of the triangles that go through each other or overlap, one of them
 * asked about. What touches is left out: bodies may. Exact, on the doubles.
 * Owner of out->item: caller, free(). Ends the life of the corners. */
sg_merge_end sg_sheet_meet(sg_sheet *sheet, sg_key_pairs *out);
void sg_sheet_clear(sg_sheet *sheet);

bool sg_key_pairs_have(const sg_key_pairs *pairs, const sg_key_pair *pair);

#endif
