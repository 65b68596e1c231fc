/* solid_rows.c -- a solid under way: taken from segments, moved, listed. */
#include "coincident_faces.h"
#include "doors/boolean.h"
#include "solid_move.h"
#include "solid_take.h"
#include "whole_contacts.h"

#include <stdlib.h>
#include <string.h>

enum { MANY = 1 << 15 }; /* triangles, for which threads are worth it */

/* ---- taking ---- */

static bool
take(sg_call *call, const sg_version *version, const sg_int_list *segments,
     sg_solid *out)
{
  static const sg_relation read[3] = {SG_V, SG_E, SG_T};
  sg_view view[3] = {{0}};
  bool good = true;

  for (int i = 0; i < 3 && good; i++) {
    good = sg_version_view(version, read[i], &view[i]);
  }
  good = good && sg_solid_take(&(sg_solid_input){&view[0], &view[1], &view[2]},
                               segments->at, segments->n, &call->cancel, out);
  for (int i = 0; i < 3; i++) {
    sg_view_clear(&view[i]);
  }
  return good || sg_call_ended(call);
}

bool
sg_door_solid_take(sg_call *call, const sg_int_list *segments, sg_solid **solid)
{
  const sg_version *version = sg_call_version(call);

  if (!version) {
    return false;
  }
  if (!(*solid = calloc(1, sizeof **solid))) {
    return sg_call_no_memory(call);
  }
  if (!take(call, version, segments, *solid)) {
    sg_solid_free(*solid);
    return false;
  }
  return true;
}

/* ---- moving ---- */

bool
sg_door_solid_move(sg_call *call, sg_solid *solid,
                   const sg_list_number_list *matrix, sg_count_list *again)
{
  double row[3][4];
  bool *marked = sg_call_alloc(call, solid->faces + 1);

  for (size_t k = 0; k < 3; k++) {
    if (matrix->n != 3 || matrix->at[k].n != 4) {
      return sg_call_domain(call, "matrix", 2);
    }
    memcpy(row[k], matrix->at[k].at, sizeof row[k]);
  }
  if (!marked || sg_solid_move(solid, (const double(*)[4])row, &call->cancel,
                               marked) != SG_MOVED) {
    return false;
  }
  for (size_t f = 0; f < solid->faces; f++) {
    if (marked[f] && !sg_count_list_add(call, again, f + 1)) {
      return false;
    }
  }
  return true;
}

/* ---- what is in it ---- */

bool
sg_door_solid_is_closed(sg_call *call, sg_solid *solid)
{
  bool alone = solid->closed || solid->triangles < MANY;
  sg_pool *pool = alone ? NULL : sg_call_pool(call);

  return (alone || pool) && sg_solid_is_closed(solid, pool);
}

bool
sg_door_solid_vertices(sg_call *call, sg_solid *solid,
                       sg_solid_vertex_fact_list *vertices)
{
  for (size_t i = 0; i < solid->vertices; i++) {
    const sg_solid_vertex *v = &solid->vertex[i];
    sg_solid_vertex_fact fact = {
        .number = i + 1,
        .x = v->at[0],
        .y = v->at[1],
        .z = v->at[2],
        .from = {.is = SG_SOLID_VERTEX_FROM_OF, .of = {v->s, v->v}}};

    if (i >= solid->plain) {
      fact.from.is = SG_SOLID_VERTEX_FROM_MADE;
      fact.from.made.origin = solid->origin[i - solid->plain];
    }
    if (sg_cancel_every(&call->cancel, i) ||
        !sg_solid_vertex_fact_list_add(call, vertices, fact)) {
      return false;
    }
  }
  return true;
}

bool
sg_door_solid_faces(sg_call *call, sg_solid *solid,
                    sg_solid_face_fact_list *faces)
{
  for (size_t i = 0; i < solid->faces; i++) {
    const sg_solid_face *face = &solid->face[i];
    sg_solid_face_fact fact = {face->s, face->p, face->reversed, {0}};

    for (size_t t = face->first; t < face->first + face->n; t++) {
      const uint32_t *v = solid->triangle[t];
      const sg_solid_triangle_fact triangle = {v[0] + 1, v[1] + 1, v[2] + 1,
                                               solid->auxiliary[t]};

      if (!sg_solid_triangle_fact_list_add(call, &fact.triangles, triangle)) {
        return false;
      }
    }
    if (sg_cancel_every(&call->cancel, i) ||
        !sg_solid_face_fact_list_add(call, faces, fact)) {
      return false;
    }
  }
  return true;
}

bool
sg_door_solid_parts(sg_call *call, sg_solid *solid,
                    sg_solid_part_fact_list *parts)
{
  for (size_t i = 0; i < solid->parts; i++) {
    const struct sg_solid_part *part = &solid->part[i];

    if (!sg_solid_part_fact_list_add(call, parts,
                                     (sg_solid_part_fact){part->face + 1,
                                                          part->s, part->p,
                                                          part->reversed})) {
      return false;
    }
  }
  return true;
}

bool
sg_door_solid_coincident_faces(sg_call *call, sg_solid *solid, double tolerance,
                               size_t *doubles)
{
  return sg_coincident_faces(solid, tolerance, &call->cancel, doubles) ||
         sg_call_ended(call);
}

bool
sg_door_solid_is_whole(sg_call *call, sg_solid *solid,
                       const sg_int_list *solids, double reach)
{
  sg_pool *pool = sg_call_pool(call);
  bool whole = false;

  return pool &&
         (sg_whole_contacts(solid, solids->at, solids->n, reach, pool,
                            &call->cancel, &whole) ||
          sg_call_ended(call)) &&
         whole;
}
