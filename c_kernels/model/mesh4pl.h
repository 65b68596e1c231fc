/* mesh4pl.h -- what reading and writing meshes share in Prolog's terms.
 *
 * Layer: glue. False: an exception is pending.
 */
#ifndef SG_MESH4PL_H
#define SG_MESH4PL_H

#include "mesh.h"

#include <SWI-Prolog.h>

/* any, stl, stl_binary, off, obj, ply, ply_binary. */
int sg_get_mesh_format_ex(term_t t, sg_mesh_format *out);
/* fault(Code, Line, Column, Byte, Text, Wanted, Got, Limit). */
int sg_unify_mesh_fault_ex(term_t result, const sg_mesh_error *error);
/* Adds the segments of a mesh to the current world, numbered from `first`, and
 * unifies `parts` with [part(S, Kind, Name), ...]. */
int sg_add_mesh_ex(const sg_mesh *mesh, int32_t first, term_t parts);
/* The name of each segment of a mesh, from a list of as many atoms or texts. */
int sg_name_segments_ex(term_t names, sg_mesh *mesh);
/* Writes to a stream; `result` is ok or a fault. */
int sg_write_mesh_ex(term_t stream, sg_mesh_format format, const sg_mesh *mesh,
                     term_t result);

#endif
