/* solid_list4pl.c -- what is in a solid, as lists.
 *
 * Layer: glue. The doors are documented in rules/kernel/boolean.pl.
 */
#include "glue.h"
#include "solid4pl.h"

#include "engine/install.h"

static functor_t functor_vertex5, functor_face4, functor_t4, functor_minus2;

/* S-V, or made(Origin). */
static int
put_from(term_t out, const sg_solid *solid, size_t i)
{
  const sg_solid_vertex *v = &solid->vertex[i];

  PL_put_variable(out);
  if (i < solid->plain) {
    return PL_unify_term(out, PL_FUNCTOR, functor_minus2, PL_INT, v->s, PL_INT,
                         v->v);
  }
  term_t origin = PL_new_term_ref();

  return sg_put_term(origin, solid->origin[i - solid->plain]) &&
         PL_unify_term(out, PL_FUNCTOR_CHARS, "made", 1, PL_TERM, origin);
}

/* vertex(V, X, Y, Z, From) of all vertices, V from 1. */
static foreign_t
solid_vertices(term_t t, term_t list)
{
  sg_solid *solid;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_solid_ex(t, &solid)) {
    return FALSE;
  }
  for (size_t i = 0; i < solid->vertices; i++) {
    fid_t frame = PL_open_foreign_frame();
    term_t from = PL_new_term_ref();
    const double *at = solid->vertex[i].at;
    int good = frame && put_from(from, solid, i) &&
               PL_unify_list(tail, head, tail) &&
               PL_unify_term(head, PL_FUNCTOR, functor_vertex5, PL_INT64,
                             (int64_t)i + 1, PL_FLOAT, at[0], PL_FLOAT, at[1],
                             PL_FLOAT, at[2], PL_TERM, from);

    PL_close_foreign_frame(frame);
    if (!good) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* t(V1, V2, V3, Auxiliary), a bit for each edge. */
static int
put_triangles(term_t list, const sg_solid *solid, const sg_solid_face *face)
{
  term_t one = PL_new_term_ref();

  PL_put_nil(list);
  for (size_t i = face->first + face->n; i > face->first; i--) {
    const uint32_t *v = solid->triangle[i - 1];

    PL_put_variable(one);
    if (!PL_unify_term(one, PL_FUNCTOR, functor_t4, PL_INT64, (int64_t)v[0] + 1,
                       PL_INT64, (int64_t)v[1] + 1, PL_INT64, (int64_t)v[2] + 1,
                       PL_INT, solid->auxiliary[i - 1]) ||
        !PL_cons_list(list, one, list)) {
      return FALSE;
    }
  }
  return TRUE;
}

/* face(S, P, Sense, Triangles) of all faces. */
static foreign_t
solid_faces(term_t t, term_t list)
{
  sg_solid *solid;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_solid_ex(t, &solid)) {
    return FALSE;
  }
  for (size_t i = 0; i < solid->faces; i++) {
    const sg_solid_face *face = &solid->face[i];
    fid_t frame = PL_open_foreign_frame();
    term_t triangles = PL_new_term_ref();
    int good = frame && put_triangles(triangles, solid, face) &&
               PL_unify_list(tail, head, tail) &&
               PL_unify_term(head, PL_FUNCTOR, functor_face4, PL_INT, face->s,
                             PL_INT, face->p, PL_INT, face->reversed ? -1 : 1,
                             PL_TERM, triangles);

    PL_close_foreign_frame(frame);
    if (!good) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* part(Face, S, P, Sense), faces from 1; none before merging. */
static foreign_t
solid_parts(term_t t, term_t list)
{
  sg_solid *solid;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_solid_ex(t, &solid)) {
    return FALSE;
  }
  for (size_t i = 0; i < solid->parts; i++) {
    const struct sg_solid_part *part = &solid->part[i];

    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR_CHARS, "part", 4, PL_INT64,
                       (int64_t)part->face + 1, PL_INT, part->s, PL_INT,
                       part->p, PL_INT, part->reversed ? -1 : 1)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static const PL_extension predicates[] = {
    {"solid_vertices", 2, solid_vertices, 0},
    {"solid_faces", 2, solid_faces, 0},
    {"solid_parts", 2, solid_parts, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_solid_list(void)
{
  functor_vertex5 = PL_new_functor(PL_new_atom("vertex"), 5);
  functor_face4 = PL_new_functor(PL_new_atom("face"), 4);
  functor_t4 = PL_new_functor(PL_new_atom("t"), 4);
  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
