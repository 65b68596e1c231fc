/* census_kept_rows.h -- what a pass over all of a world found wrong, kept with
 * the world: asked for one after another, defects are looked up.
 *
 * Layer: rows. It is kept under the stamps of the rows it was found in, the
 * last of each sort. False or null: see call.h.
 */
#ifndef SG_CENSUS_KEPT_ROWS_H
#define SG_CENSUS_KEPT_ROWS_H

#include "call.h"

#include <stdatomic.h>

enum { SG_DEFECT_STAMPS = 7 };

/* What looks for it. */
typedef enum sg_defects_of {
  SG_DEFECTS_OF_CENSUS, /* model/census.h */
  SG_DEFECTS_OF_JOIN,   /* join/self_cut.h */
  SG_DEFECTS_SORTS
} sg_defects_of;

typedef struct sg_found_defect {
  int kind;
  int32_t s, a, b;
} sg_found_defect;

SG_CALL_LIST(sg_found_defect_list, sg_found_defect);

/* It lasts while somebody holds it. */
typedef struct sg_kept_defects {
  atomic_size_t holders;
  uint64_t stamp[SG_DEFECT_STAMPS];
  void *more;                /* what else was found, or null */
  void (*clear)(void *more); /* null: nothing to clear */
  sg_found_defect *found;    /* [n] as found */
  uint32_t *order;           /* [n] places in found[], by kind, s, a, place */
  size_t n;
} sg_kept_defects;

/* Adds to the list, which is the call's, and may set `more` and `clear`, also
 * if it fails. */
typedef bool sg_defect_maker(sg_call *call, sg_kept_defects *kept,
                             sg_found_defect_list *found);

/* What `make` finds, or found when the rows were the same; held, and to be
 * dropped. */
sg_kept_defects *sg_kept_defects_hold(sg_call *call, sg_defects_of by,
                                      sg_defect_maker *make);
void sg_kept_defects_drop(sg_kept_defects *kept);

/* The places of those of a kind, a segment and an A, null for any; ascending.
 * Cost: log n and those found if kind, or kind and s, or all three are given;
 * else n. */
bool sg_kept_defects_ask(sg_call *call, const sg_kept_defects *kept,
                         const int *kind, const int32_t *s, const int32_t *a,
                         sg_count_list *places);

#endif
