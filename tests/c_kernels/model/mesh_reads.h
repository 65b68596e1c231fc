/* mesh_reads.h -- meshes read from texts, for tests. */
#ifndef MESH_READS_H
#define MESH_READS_H

#include "mesh_valid.h"
#include "model/mesh.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static sg_mesh mesh;
static sg_mesh_error error;

static inline bool
read_bytes(sg_mesh_format format, const char *bytes, size_t n)
{
  sg_mesh_options options = {SG_WELD_AUTO, false, NULL};

  sg_mesh_clear(&mesh);
  /* A copy of just this size, so that sanitizers see reads beyond it. */
  char *copy = malloc(n ? n : 1);
  memcpy(copy, bytes, n);
  bool done = sg_mesh_read(format, copy, n, &options, &mesh, &error);
  free(copy);
  return done && mesh_is_valid(&mesh);
}

static inline bool
reads(sg_mesh_format format, const char *text)
{
  return read_bytes(format, text, strlen(text));
}

/* True if `text` is refused with `code` at this line. */
static inline bool
refuses(sg_mesh_format format, const char *text, sg_mesh_code code, size_t line)
{
  if (reads(format, text)) {
    return false;
  }
  if (error.code != code || error.line != line) {
    fprintf(stderr, "got %s, line %zu, column %zu: %s (%s)\n",
            sg_mesh_code_name[error.code], error.line, error.column, error.text,
            error.wanted);
    return false;
  }
  return mesh.vertices == 0 && mesh.vertex == NULL;
}

#endif
