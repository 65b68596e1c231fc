/* tree4pl.h -- tree_rows.h for glue that has no sg_call.
 *
 * Layer: glue. False: an exception is pending. Include it before SWI-Prolog.h.
 */
#ifndef SG_TREE4PL_H
#define SG_TREE4PL_H

#include "tree_rows.h"

#include "engine/world4pl.h"

int sg_trees_hold_ex(sg_world *world, const sg_version *version,
                     const sg_leaf_views *views, const int32_t *s, size_t n,
                     sg_crew *crew, sg_kept_tree **out);
int sg_kept_knots_ex(sg_kept_tree *kept, const sg_version *version,
                     const sg_leaf_views *views, sg_crew *crew,
                     const sg_knots **out);
int sg_leaf_views_ex(const sg_version *version, sg_leaf_views *out);

#endif
