/* mesh_rows.h -- what reading and writing meshes share.
 *
 * Layer: rows. False: see call.h.
 */
#ifndef SG_MESH_ROWS_H
#define SG_MESH_ROWS_H

#include "doors/file.h"
#include "mesh_part.h"

/* Adds the segments of a mesh to the current world, numbered from `first`. */
bool sg_mesh_add_rows(sg_call *call, const sg_mesh *mesh, int32_t first,
                      sg_mesh_part_fact_list *parts);

/* Adds a part of a mesh as segment s of a world that is claimed: s has no rows.
 * Of the mesh only its vertices are looked at. */
bool sg_mesh_add_part(sg_call *call, sg_world *world, const sg_mesh *mesh,
                      const sg_mesh_part *part, int32_t s);

/* Writes a mesh; its segments have these names. */
bool sg_mesh_send(sg_call *call, const sg_mesh *mesh, const sg_name_list *names,
                  sg_mesh_format format, const sg_output *to,
                  sg_mesh_written *result);

/* True: the error is an answer. False: it is none, except for this call. */
bool sg_mesh_refused(sg_call *call, const sg_mesh_error *error);

#endif
