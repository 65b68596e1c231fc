/* line_role.h -- what a line is in the picture, and whether such a one is
 * drawn.
 *
 * Layer: kernel. It computes what rules/picture/role.pl defines.
 */
#ifndef SG_LINE_ROLE_H
#define SG_LINE_ROLE_H

#include "scene_model.h"

/* Of lines that lie on one another in the picture the first of these wins. */
typedef enum sg_role {
  SG_PENETRATION,
  SG_OUTLINE,
  SG_CREASE,
  SG_BORDER,
  SG_CURVE,
  SG_SECTION,
  SG_SMOOTH,
  SG_MESH,
  SG_ROLES
} sg_role;

typedef enum sg_which { SG_LINES_ALL, SG_LINES_FEATURE, SG_LINES_CUT } sg_which;

/* The role of a line; crease: the bend, in degrees, over which it is one. */
sg_role sg_look_role(const sg_look *look, double crease);
const char *sg_role_name(sg_role role);

/* Which lines a drawing has. */
typedef struct sg_lines_drawn {
  sg_which which;
  double crease; /* the bend, in degrees, over which an edge is a crease */
} sg_lines_drawn;

/* True if a line of this role is drawn. */
bool sg_role_drawn(sg_role role, sg_which which);

#endif
