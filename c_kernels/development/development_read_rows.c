/* development_read_rows.c -- what there is of a segment being laid flat. */
#include "development_rows.h"

#include "doors/pattern.h"
#include "rows/sort.h"

#include <stdlib.h>

/* ---- all ---------------------------------------------------------------- */

bool
sg_door_flattening_counts(sg_call *call, sg_development *d, size_t *faces,
                          size_t *joints, double *step)
{
  (void)call;
  *faces = d->faces.faces;
  *joints = d->joints.n;
  *step = sg_joint_step(&d->flattening);
  return true;
}

bool
sg_door_flattening_bent(sg_call *call, sg_development *d, sg_int_list *out)
{
  for (size_t p = 0; d->faces.bents > 0 && p < d->dense.polygons; p++) {
    if (sg_cancel_every(&call->cancel, p) ||
        (d->faces.bent[p] &&
         !sg_int_list_add(call, out, d->dense.polygon_id[p]))) {
      return false;
    }
  }
  return true;
}

bool
sg_door_flattening_invalid(sg_call *call, sg_development *d, sg_int_list *out)
{
  const sg_flat_faces *f = &d->faces;

  for (uint32_t face = 0; face < f->faces; face++) {
    bool invalid = f->area[face] > 0 &&
                   f->triangle_begin[face] == f->triangle_begin[face + 1];
    if (sg_cancel_every(&call->cancel, face) ||
        (invalid &&
         !sg_int_list_add(call, out, sg_development_polygon(d, face)))) {
      return false;
    }
  }
  return true;
}

/* Side k, of a real edge, is joined to no other. */
static bool
is_border(const sg_development *d, uint32_t k)
{
  uint32_t e = d->faces.side[k].edge;

  return e < d->dense.edges && d->dense.real[e] &&
         d->joints.of_side[k] == SG_NO_JOINT;
}

bool
sg_door_flattening_borders(sg_call *call, sg_development *d, sg_int_list *out)
{
  for (uint32_t k = 0; k < d->faces.sides; k++) {
    if (sg_cancel_every(&call->cancel, k) ||
        (is_border(d, k) &&
         !sg_int_list_add(call, out, sg_development_edge(d, k)))) {
      return false;
    }
  }
  return true;
}

/* ---- a joint ------------------------------------------------------------- */

bool
sg_door_flattening_joint(sg_call *call, sg_development *d, int32_t number,
                         sg_joint_fact *out)
{
  uint32_t j;
  double middle[3];

  if (!sg_development_joint(call, d, number, 2, &j)) {
    return false;
  }
  const sg_joint *joint = &d->joints.joint[j];
  const uint32_t *face_of = d->faces.face_of;

  sg_joint_middle(&d->flattening, j, middle);
  *out = (sg_joint_fact){
      .edge1 = sg_development_edge(d, joint->side[0]),
      .edge2 = sg_development_edge(d, joint->side[1]),
      .polygon1 = sg_development_polygon(d, face_of[joint->side[0]]),
      .polygon2 = sg_development_polygon(d, face_of[joint->side[1]]),
      .length = joint->length,
      .middle = {middle[0], middle[1], middle[2]},
      .angle = joint->angle,
      .kind = joint->line   ? SG_JOINT_KIND_LINE
              : joint->flat ? SG_JOINT_KIND_FLAT
                            : SG_JOINT_KIND_BENT,
      .state = (sg_joint_state)d->flattening.state[j]};
  return true;
}

/* The place of an edge with this id, SIZE_MAX: none. */
static size_t
place_of_edge(const sg_development *d, int32_t e)
{
  const sg_dense *of = &d->dense;
  size_t place = sg_find_id(of->edge_id, of->edges, e);
  size_t chord =
      (size_t)e - 1 - (of->edges ? (size_t)of->edge_id[of->edges - 1] : 0);

  return place != SIZE_MAX         ? place
         : chord < d->faces.chords ? of->edges + chord
                                   : SIZE_MAX;
}

bool
sg_door_edge_joint(sg_call *call, sg_development *d, int32_t e, int32_t *number)
{
  (void)call;
  size_t place = place_of_edge(d, e);
  uint32_t side = place == SIZE_MAX ? SG_NO_SIDE_OF : d->faces.side_of[place];
  uint32_t j = side == SG_NO_SIDE_OF ? SG_NO_JOINT : d->joints.of_side[side];

  if (j == SG_NO_JOINT) {
    return false;
  }
  *number = (int32_t)(j + 1);
  return true;
}
