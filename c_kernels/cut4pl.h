/* cut4pl.h -- the cut set behind a Prolog handle.
 *
 * Layer: glue. Shared by cut4pl.c (finding cuts) and seam4pl.c (putting them
 * into polygons).
 */
#ifndef SG_CUT4PL_H
#define SG_CUT4PL_H

#include "../engine/world4pl.h"

#include "cut_set.h"

/* One penetration under way. The model, and all real edges, are those of the
 * version at which it was opened. */
typedef struct sg_cut_handle {
  sg_cut_set set;
  sg_world *world;           /* held */
  const sg_version *version; /* held */
  int32_t (*pair)[2];        /* segments to be cut by each other */
  size_t pairs;
  sg_key_table next_name;  /* segment -> next id of v/5 */
  sg_key_table line_of;    /* segment, two points -> line */
  sg_key_table edge_type;  /* segment, polygon, two vertices -> Et */
  sg_key_table edges_read; /* segment, polygon: its edges are in edge_type */
  bool closed;
} sg_cut_handle;

/* The open cut set that t names: type_error, existence_error. */
int sg_get_cut_set_ex(term_t t, sg_cut_handle **out);

/* An sg_is_real for the set of this handle (cut_real4pl.c). */
int sg_cut_is_real(void *handle, uint32_t triangle, int edge);

#endif
