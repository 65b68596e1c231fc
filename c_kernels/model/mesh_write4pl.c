/* mesh_write4pl.c -- segments of the current world as mesh files (documented
 * in kernel/file.pl).
 *
 * Layer: glue.
 */
#include "glue.h"
#include "mesh4pl.h"
#include "mesh_export.h"
#include "rows/dense4pl.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <SWI-Stream.h>

#include <stdlib.h>
#include <string.h>

static bool
write_bytes(void *data, const char *bytes, size_t n)
{
  return Sfwrite(bytes, 1, n, data) == n;
}

int
sg_name_segments_ex(term_t names, sg_mesh *mesh)
{
  term_t tail = PL_copy_term_ref(names), head = PL_new_term_ref();
  char *text;
  size_t n;

  for (size_t i = 0; i < mesh->segments; i++) {
    int good = PL_get_list_ex(tail, head, tail);
    PL_STRINGS_MARK();
    good = good && PL_get_nchars(head, &n, &text,
                                 CVT_ATOM | CVT_STRING | CVT_WRITEQ |
                                     CVT_EXCEPTION | REP_UTF8);
    if (good && n && !(mesh->name[i] = strndup(text, n))) {
      good = sg_no_memory();
    }
    PL_STRINGS_RELEASE();
    if (!good) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(tail);
}

static int
unify_missing(term_t result, const sg_dense *dense, size_t polygon)
{
  size_t s =
      sg_dense_segment_of(dense, dense->polygon_begin, (uint32_t)polygon);

  return PL_unify_term(result, PL_FUNCTOR_CHARS, "no_triangles", 2, PL_INT,
                       (int)dense->segment[s], PL_INT,
                       (int)dense->polygon_id[polygon]);
}

int
sg_write_mesh_ex(term_t stream, sg_mesh_format format, const sg_mesh *mesh,
                 term_t result)
{
  sg_mesh_error error;
  IOSTREAM *out;

  if (!PL_get_stream(stream, &out, SIO_OUTPUT)) {
    return FALSE;
  }
  sg_mesh_sink sink = {write_bytes, out};
  bool done = sg_mesh_write(format, mesh, &sink, &sg_prolog_poll, &error);
  if (done || error.code == SG_MESH_WRITE_FAILED) {
    /* PL_release_stream() raises what went wrong with the stream. */
    return PL_release_stream(out) && done && PL_unify_atom_chars(result, "ok");
  }
  PL_release_stream_noerror(out);
  return sg_unify_mesh_fault_ex(result, &error);
}

/* mesh_write(+Stream, +Format, +Segments, +Names, -Result) is det. */
static foreign_t
mesh_write(term_t stream, term_t format_term, term_t segments, term_t names,
           term_t result)
{
  sg_mesh_format format;
  int32_t *wanted = NULL;
  size_t n, polygon = 0;
  sg_dense dense;
  sg_mesh mesh = {0};

  if (!sg_get_mesh_format_ex(format_term, &format) ||
      !sg_get_ids_ex(segments, &wanted, &n)) {
    return FALSE;
  }
  int32_t none = 0;
  int done = sg_get_dense_ex(wanted ? wanted : &none, n, &dense);
  free(wanted);
  if (done) {
    bool triangles = format == SG_MESH_STL || format == SG_MESH_STL_BINARY;
    switch (sg_mesh_export(&dense, triangles, &mesh, &polygon)) {
    case SG_EXPORT_DONE:
      done = sg_name_segments_ex(names, &mesh) &&
             sg_write_mesh_ex(stream, format, &mesh, result);
      break;
    case SG_EXPORT_NO_MEMORY:
      done = sg_no_memory();
      break;
    case SG_EXPORT_NO_TRIANGLES:
      done = unify_missing(result, &dense, polygon);
      break;
    }
  }
  sg_mesh_clear(&mesh);
  sg_dense_clear(&dense);
  return done;
}

static const PL_extension predicates[] = {
    {"mesh_write", 5, mesh_write, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_mesh_write(void)
{
  PL_register_extensions_in_module("sg_kernel_file", predicates);
}
