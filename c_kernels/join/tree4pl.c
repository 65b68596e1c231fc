/* tree4pl.c -- see tree4pl.h.
 *
 * Layer: glue.
 */
#include "tree4pl.h"

#include "door.h"

int
sg_trees_hold_ex(sg_world *world, const sg_version *version,
                 const sg_leaf_views *views, const int32_t *s, size_t n,
                 sg_crew *crew, sg_kept_tree **out)
{
  sg_call call;

  (void)world;
  (void)crew;
  sg_door_open(&call);
  return (int)sg_door_close(&call, 0,
                            sg_trees_hold(&call, version, views, s, n, out));
}

int
sg_kept_knots_ex(sg_kept_tree *kept, const sg_version *version,
                 const sg_leaf_views *views, sg_crew *crew,
                 const sg_knots **out)
{
  sg_call call;

  (void)crew;
  sg_door_open(&call);
  return (int)sg_door_close(&call, 0,
                            sg_kept_knots(&call, kept, version, views, out));
}

int
sg_leaf_views_ex(const sg_version *version, sg_leaf_views *out)
{
  sg_call call;

  sg_door_open(&call);
  return (int)sg_door_close(&call, 0, sg_leaf_views_open(&call, version, out));
}
