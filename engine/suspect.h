/* suspect.h -- rows that others may refer to though they are not there.
 *
 * Layer: store, private to whole.c.
 */
#ifndef SG_SUSPECT_H
#define SG_SUSPECT_H

#include "store.h"

typedef struct sg_id_pair {
  int32_t s, id;
} sg_id_pair;

/* Of one relation: what may be missing, and rows that may refer to what is not
 * there. */
typedef struct sg_suspects {
  sg_id_pair *gone; /* [n], these rows are not there */
  int32_t *of;      /* [ofs], of these segments any row may not be there */
  sg_row *row;      /* [rows] */
  size_t n, room, ofs, of_room, rows, row_room;
  bool all;      /* any row may not be there */
  bool all_rows; /* any row may refer to what is not there */
  /* When they are in order: none is of another segment, none has another id. */
  int32_t first_s, last_s, first_id, last_id;
} sg_suspects;

bool sg_suspect_gone(sg_suspects *x, int32_t s, int32_t id);
/* Before one is looked for. */
void sg_suspects_order(sg_suspects *x);
bool sg_has_gone(const sg_suspects *x, int32_t s, int32_t id);
/* False: nothing of the segment is suspected. */
bool sg_may_concern(const sg_suspects *x, int32_t s);
void sg_suspects_clear(sg_suspects *x);

#endif
