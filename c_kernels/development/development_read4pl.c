/* development_read4pl.c -- what there is of a segment being laid flat
 * (documented in kernel/pattern.pl).
 *
 * Layer: glue.
 */
#include "development4pl.h"

#include "glue.h"

#include "engine/install.h"

#include <stdlib.h>

static atom_t atom_line, atom_flat, atom_bent;

/* ---- all ---------------------------------------------------------------- */

/* flattening_counts(+Flattening, -Faces, -Joints, -Step) is det. */
static foreign_t
flattening_counts(term_t handle, term_t faces, term_t joints, term_t step)
{
  sg_development *d;

  return sg_get_development_ex(handle, &d) &&
         PL_unify_int64(faces, (int64_t)d->faces.faces) &&
         PL_unify_int64(joints, (int64_t)d->joints.n) &&
         sg_unify_double(step, sg_joint_step(&d->flattening));
}

/* flattening_bent(+Flattening, -Polygons) is det. */
static foreign_t
flattening_bent(term_t handle, term_t list)
{
  sg_development *d;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_development_ex(handle, &d)) {
    return FALSE;
  }
  for (size_t p = 0; d->faces.bents > 0 && p < d->dense.polygons; p++) {
    if (sg_poll_every(&sg_prolog_poll, p) ||
        (d->faces.bent[p] &&
         (!PL_unify_list(tail, head, tail) ||
          !PL_unify_integer(head, d->dense.polygon_id[p])))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* flattening_invalid(+Flattening, -Polygons) is det. */
static foreign_t
flattening_invalid(term_t handle, term_t list)
{
  sg_development *d;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_development_ex(handle, &d)) {
    return FALSE;
  }
  const sg_flat_faces *f = &d->faces;

  for (uint32_t face = 0; face < f->faces; face++) {
    bool invalid = f->area[face] > 0 &&
                   f->triangle_begin[face] == f->triangle_begin[face + 1];
    if (sg_poll_every(&sg_prolog_poll, face) ||
        (invalid &&
         (!PL_unify_list(tail, head, tail) ||
          !PL_unify_integer(head, sg_development_polygon(d, face))))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* Side k, of a real edge, is joined to no other. */
static bool
is_border(const sg_development *d, uint32_t k)
{
  uint32_t e = d->faces.side[k].edge;

  return e < d->dense.edges && d->dense.real[e] &&
         d->joints.of_side[k] == SG_NO_JOINT;
}

/* flattening_borders(+Flattening, -Edges) is det. */
static foreign_t
flattening_borders(term_t handle, term_t list)
{
  sg_development *d;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_development_ex(handle, &d)) {
    return FALSE;
  }
  for (uint32_t k = 0; k < d->faces.sides; k++) {
    if (sg_poll_every(&sg_prolog_poll, k) ||
        (is_border(d, k) &&
         (!PL_unify_list(tail, head, tail) ||
          !PL_unify_integer(head, sg_development_edge(d, k))))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* ---- a joint ------------------------------------------------------------- */

/* flattening_joint(+Flattening, +J, -Joint) is det. */
static foreign_t
flattening_joint(term_t handle, term_t number, term_t out)
{
  sg_development *d;
  uint32_t j;

  if (!sg_get_development_ex(handle, &d) || !sg_get_joint_ex(number, d, &j)) {
    return FALSE;
  }
  const sg_joint *joint = &d->joints.joint[j];
  const uint32_t *face_of = d->faces.face_of;

  double middle[3];

  sg_joint_middle(&d->flattening, j, middle);
  return PL_unify_term(
      out, PL_FUNCTOR_CHARS, "joint", 9, PL_INT,
      (int)sg_development_edge(d, joint->side[0]), PL_INT,
      (int)sg_development_edge(d, joint->side[1]), PL_INT,
      (int)sg_development_polygon(d, face_of[joint->side[0]]), PL_INT,
      (int)sg_development_polygon(d, face_of[joint->side[1]]), PL_FLOAT,
      joint->length + 0.0, PL_FUNCTOR_CHARS, "p", 3, PL_FLOAT, middle[0] + 0.0,
      PL_FLOAT, middle[1] + 0.0, PL_FLOAT, middle[2] + 0.0, PL_FLOAT,
      joint->angle + 0.0, PL_ATOM,
      joint->line   ? atom_line
      : joint->flat ? atom_flat
                    : atom_bent,
      PL_ATOM, sg_joint_state_atom((sg_joint_state)d->flattening.state[j]));
}

static int
compare_ids(const void *a, const void *b)
{
  int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;

  return (x > y) - (x < y);
}

/* The place of an edge with this id, SIZE_MAX: none. */
static size_t
place_of_edge(const sg_development *d, int32_t e)
{
  const sg_dense *of = &d->dense;
  const int32_t *at =
      of->edges ? bsearch(&e, of->edge_id, of->edges, sizeof e, compare_ids)
                : NULL;
  size_t chord =
      (size_t)e - 1 - (of->edges ? (size_t)of->edge_id[of->edges - 1] : 0);

  return at                        ? (size_t)(at - of->edge_id)
         : chord < d->faces.chords ? of->edges + chord
                                   : SIZE_MAX;
}

/* edge_joint(+Flattening, +E, -J) is semidet. */
static foreign_t
edge_joint(term_t handle, term_t edge, term_t number)
{
  sg_development *d;
  int32_t e;

  if (!sg_get_development_ex(handle, &d) || !sg_get_id_ex(edge, &e)) {
    return FALSE;
  }
  size_t place = place_of_edge(d, e);
  uint32_t side = place == SIZE_MAX ? SG_NO_SIDE_OF : d->faces.side_of[place];
  uint32_t j = side == SG_NO_SIDE_OF ? SG_NO_JOINT : d->joints.of_side[side];

  return j != SG_NO_JOINT && PL_unify_int64(number, (int64_t)j + 1);
}

void
sg_install_development_read(void)
{
  static const PL_extension doors[] = {
      {"flattening_counts", 4, (pl_function_t)flattening_counts, 0},
      {"flattening_bent", 2, (pl_function_t)flattening_bent, 0},
      {"flattening_invalid", 2, (pl_function_t)flattening_invalid, 0},
      {"flattening_borders", 2, (pl_function_t)flattening_borders, 0},
      {"flattening_joint", 3, (pl_function_t)flattening_joint, 0},
      {"edge_joint", 3, (pl_function_t)edge_joint, 0},
      {NULL, 0, NULL, 0}};

  atom_line = PL_new_atom("line");
  atom_flat = PL_new_atom("flat");
  atom_bent = PL_new_atom("bent");
  PL_register_extensions_in_module("sg_kernel_pattern", doors);
}
