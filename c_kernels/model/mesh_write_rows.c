/* mesh_write_rows.c -- segments of the current world as mesh files.
 *
 * Layer: rows.
 */
#include "mesh_export.h"
#include "mesh_rows.h"
#include "rows/dense_rows.h"

bool
sg_mesh_send(sg_call *call, const sg_mesh *mesh, const sg_name_list *names,
             sg_mesh_format format, const sg_output *to,
             sg_mesh_written *result)
{
  const sg_mesh_sink sink = {to->write, to->data};
  sg_mesh named = *mesh;

  if (names->n != mesh->segments) {
    return sg_call_domain(call, "names_of_segments", 4);
  }
  if (!(named.name = sg_call_alloc(call, names->n * sizeof *named.name))) {
    return sg_call_no_memory(call);
  }
  for (size_t i = 0; i < names->n; i++) {
    named.name[i] = *names->at[i] ? (char *)names->at[i] : NULL;
  }
  if (sg_mesh_write(format, &named, &sink, &call->cancel, &result->fault)) {
    result->is = SG_MESH_WRITTEN_OK;
    return true;
  }
  result->is = SG_MESH_WRITTEN_FAULT;
  return sg_mesh_refused(call, &result->fault);
}

static bool
answer_missing(const sg_dense *d, size_t polygon, sg_mesh_written *result)
{
  size_t s = sg_dense_segment_of(d, d->polygon_begin, (uint32_t)polygon);

  *result = (sg_mesh_written){.is = SG_MESH_WRITTEN_NO_TRIANGLES};
  result->no_triangles.s = d->segment[s];
  result->no_triangles.p = d->polygon_id[polygon];
  return true;
}

bool
sg_door_mesh_write(sg_call *call, const sg_output *stream,
                   sg_mesh_format format, const sg_int_list *segments,
                   const sg_name_list *names, sg_mesh_written *result)
{
  bool triangles = format == SG_MESH_STL || format == SG_MESH_STL_BINARY;
  size_t polygon = 0;
  sg_dense dense;
  sg_mesh mesh = {0};
  bool good = sg_dense_read_these(call, segments, &dense);

  if (good) {
    switch (sg_mesh_export(&dense, triangles, &mesh, &polygon)) {
    case SG_EXPORT_DONE:
      good = sg_mesh_send(call, &mesh, names, format, stream, result);
      break;
    case SG_EXPORT_NO_MEMORY:
      good = sg_call_no_memory(call);
      break;
    case SG_EXPORT_NO_TRIANGLES:
      good = answer_missing(&dense, polygon, result);
      break;
    }
  }
  sg_mesh_clear(&mesh);
  sg_dense_clear(&dense);
  return good;
}
