/* mesh4pl.h -- what reading and writing meshes share in Prolog's terms.
 *
 * Layer: glue. False: an exception is pending.
 */
#ifndef SG_MESH4PL_H
#define SG_MESH4PL_H

#include "dense.h"
#include "mesh.h"

#include <SWI-Prolog.h>

/* any, stl, stl_binary, off, obj, ply, ply_binary. */
int sg_get_mesh_format_ex(term_t t, sg_mesh_format *out);
/* fault(Code, Line, Column, Byte, Text, Wanted, Got, Limit). */
int sg_unify_mesh_fault_ex(term_t result, const sg_mesh_error *error);
/* The n segments `wanted` of the current world, null: all; sg_dense_clear() in
 * any case. */
int sg_get_dense_ex(const int32_t *wanted, size_t n, sg_dense *out);

#endif
