/* store_private.h -- what stands on callers' stacks; use sg_walk_*() only. */
#ifndef SG_STORE_PRIVATE_H
#define SG_STORE_PRIVATE_H

struct sg_live;

enum { SG_WALK_FEW = 8 };

struct sg_walk {
  const sg_version *version;
  const struct sg_relation_info *info;
  sg_relation relation;
  uint16_t mask;                /* columns to compare */
  sg_value row[SG_MAX_COLUMNS]; /* what they must be */
  /* A scan: the page at hand and the row to look at next. */
  const struct sg_live *live;
  sg_row at;
  const sg_cancel *cancel; /* null, or the caller's: it is asked on the way */
  bool stopped;            /* it said stop: there are no more rows */
  /* A look-up: the rows found, ascending; `rows` null: they are in `few`. */
  bool gathered;
  sg_row few[SG_WALK_FEW];
  sg_row *rows;
  size_t count, room, given;
};

#endif
