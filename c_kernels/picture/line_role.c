/* line_role.c -- see line_role.h */
#include "line_role.h"

#include "smooth.h"

sg_role
sg_look_role(const sg_look *look, double crease)
{
  if (look->cut) {
    return SG_PENETRATION;
  }
  if (look->faces < 2) {
    return look->faces ? SG_BORDER : SG_CURVE;
  }
  if ((look->left == 0) != (look->right == 0) && !look->inside) {
    return SG_OUTLINE;
  }
  if (look->edge || (look->bend > crease + SG_SMOOTH_OVER && !look->speck)) {
    return SG_CREASE;
  }
  return look->bend > SG_FLAT_BEND ? SG_SMOOTH : SG_MESH;
}

const char *
sg_role_name(sg_role role)
{
  static const char *const name[SG_ROLES] = {[SG_PENETRATION] = "penetration",
                                             [SG_OUTLINE] = "outline",
                                             [SG_CREASE] = "crease",
                                             [SG_BORDER] = "border",
                                             [SG_CURVE] = "curve",
                                             [SG_SECTION] = "section",
                                             [SG_SMOOTH] = "smooth",
                                             [SG_MESH] = "mesh"};

  return name[role];
}

bool
sg_role_drawn(sg_role role, sg_which which)
{
  return which == SG_LINES_ALL || role == SG_PENETRATION ||
         (which == SG_LINES_FEATURE && role != SG_SMOOTH && role != SG_MESH);
}
