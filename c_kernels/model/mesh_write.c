/* mesh_write.c -- writes meshes: STL text and binary, OFF, OBJ, PLY text and
 * binary (little endian, doubles). */
#include "mesh.h"
#include "number/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BUFFER = 65536, ASK_EVERY = 4096, STL_HEADER = 80, STL_RECORD = 50 };

typedef struct sg_writer {
  const sg_mesh *mesh;
  const sg_mesh_sink *sink;
  const sg_cancel *cancel;
  sg_mesh_error *error;
  size_t used;
  unsigned ticks;
  bool failed;
  char buffer[BUFFER];
} sg_writer;

static bool
fail(sg_writer *w, sg_mesh_code code, const char *text)
{
  if (!w->failed) {
    *w->error = (sg_mesh_error){.code = code, .wanted = ""};
    snprintf(w->error->text, sizeof w->error->text, "%s", text);
    w->failed = true;
  }
  return false;
}

static bool
flush(sg_writer *w)
{
  if (!w->failed && w->used &&
      !w->sink->write(w->sink->data, w->buffer, w->used)) {
    fail(w, SG_MESH_WRITE_FAILED, "");
  }
  w->used = 0;
  return !w->failed;
}

static void
put(sg_writer *w, const void *bytes, size_t n)
{
  const char *from = bytes;

  while (n && !w->failed) {
    size_t part = BUFFER - w->used < n ? BUFFER - w->used : n;
    memcpy(w->buffer + w->used, from, part);
    w->used += part;
    from += part;
    n -= part;
    if (w->used == BUFFER) {
      flush(w);
    }
  }
}

static void
put_text(sg_writer *w, const char *text)
{
  put(w, text, strlen(text));
}

static void
put_integer(sg_writer *w, size_t i)
{
  char text[24];

  put(w, text, (size_t)snprintf(text, sizeof text, "%zu", i));
}

/* A comment that the readers know (sg_mesh_precision()). */
static void
put_precision(sg_writer *w, const char *comment)
{
  char text[SG_NUMBER_SIZE];

  put_text(w, comment);
  put_text(w, " precision ");
  put(w, text, sg_number_print(w->mesh->grain, text));
  put_text(w, "\n");
}

static void
put_point(sg_writer *w, const double p[3])
{
  char text[SG_NUMBER_SIZE];

  for (int k = 0; k < 3; k++) {
    if (k) {
      put(w, " ", 1);
    }
    put(w, text, sg_number_print(p[k], text));
  }
}

/* The low n bytes of `bits`, lowest first. */
static void
put_bits(sg_writer *w, uint64_t bits, size_t n)
{
  unsigned char bytes[8];

  for (size_t i = 0; i < n; i++) {
    bytes[i] = (unsigned char)(bits >> 8 * i & 0xff);
  }
  put(w, bytes, n);
}

static bool
tick(sg_writer *w)
{
  if (++w->ticks % ASK_EVERY == 0 && sg_cancelled(w->cancel)) {
    fail(w, SG_MESH_STOPPED, "");
  }
  return !w->failed;
}

static const int32_t *
corners(const sg_mesh_lists *lists, size_t i, size_t *n)
{
  *n = lists->start[i + 1] - lists->start[i];
  return lists->corner + lists->start[i];
}

/* A name on one line, without blanks at its ends: line ends become blanks. */
static void
put_name(sg_writer *w, size_t segment)
{
  const char *name = w->mesh->name[segment];
  size_t n = name ? strlen(name) : 0, i = 0;

  while (n > 0 && (unsigned char)name[n - 1] <= ' ') {
    n--;
  }
  while (i < n && (unsigned char)name[i] <= ' ') {
    i++;
  }
  for (; i < n; i++) {
    put(w, (unsigned char)name[i] < ' ' ? " " : name + i, 1);
  }
}

/* STL -------------------------------------------------------------------- */

/* The unit normal of a triangle, 0 0 0 if it has none. */
static void
normal_of(const sg_mesh *mesh, const int32_t *v, double out[3])
{
  const double *a = mesh->vertex[v[0]], *b = mesh->vertex[v[1]],
               *c = mesh->vertex[v[2]];
  double u[3], t[3], size = 0;

  for (int k = 0; k < 3; k++) {
    u[k] = b[k] - a[k];
    t[k] = c[k] - a[k];
    size = fmax(size, fmax(fabs(u[k]), fabs(t[k])));
  }
  for (int k = 0; k < 3; k++) {
    u[k] = size > 0 ? u[k] / size : 0;
    t[k] = size > 0 ? t[k] / size : 0;
  }
  double n[3] = {u[1] * t[2] - u[2] * t[1], u[2] * t[0] - u[0] * t[2],
                 u[0] * t[1] - u[1] * t[0]};
  double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int k = 0; k < 3; k++) {
    out[k] = length > 0 && isfinite(length) ? n[k] / length + 0.0 : 0.0;
  }
}

static bool
check_triangles(sg_writer *w)
{
  if (w->mesh->curve.count) {
    return fail(w, SG_MESH_UNSUPPORTED, "a curve");
  }
  for (size_t i = 0; i < w->mesh->face.count; i++) {
    size_t n;
    corners(&w->mesh->face, i, &n);
    if (n != 3) {
      return fail(w, SG_MESH_UNSUPPORTED, "a polygon that is no triangle");
    }
  }
  return true;
}

static void
put_facet(sg_writer *w, const int32_t *v)
{
  float rounded[3];
  double n[3];

  normal_of(w->mesh, v, n);
  put_text(w, "  facet normal ");
  for (int k = 0; k < 3; k++) {
    rounded[k] = (float)n[k];
    n[k] = nearbyint((double)rounded[k] * 1e6) / 1e6 + 0.0;
  }
  put_point(w, n);
  put_text(w, "\n    outer loop\n");
  for (int i = 0; i < 3; i++) {
    put_text(w, "      vertex ");
    put_point(w, w->mesh->vertex[v[i]]);
    put_text(w, "\n");
  }
  put_text(w, "    endloop\n  endfacet\n");
}

/* The faces of segment s are face[begin[s]] .. face[begin[s + 1] - 1], in their
 * order; they come in any. Null: no memory. free() both. */
static bool
sort_by_segment(const sg_mesh *mesh, size_t **begin, size_t **face)
{
  const int32_t *segment = mesh->face.segment;
  size_t n = mesh->face.count;
  size_t *at = calloc(mesh->segments + 2, sizeof *at);

  *begin = at;
  *face = malloc((n + 1) * sizeof **face);
  if (!at || !*face) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    at[segment[i] + 2]++;
  }
  for (size_t s = 2; s < mesh->segments + 2; s++) {
    at[s] += at[s - 1];
  }
  for (size_t i = 0; i < n; i++) {
    (*face)[at[segment[i] + 1]++] = i;
  }
  return true;
}

/* Segments one after the other. */
static bool
write_stl(sg_writer *w)
{
  size_t *begin, *face, n;

  if (!sort_by_segment(w->mesh, &begin, &face)) {
    fail(w, SG_MESH_NO_MEMORY, "");
  }
  for (size_t s = 0; !w->failed && s < w->mesh->segments; s++) {
    put_text(w, "solid ");
    put_name(w, s);
    put_text(w, "\n");
    for (size_t i = begin[s]; i < begin[s + 1] && tick(w); i++) {
      put_facet(w, corners(&w->mesh->face, face[i], &n));
    }
    put_text(w, "endsolid ");
    put_name(w, s);
    put_precision(w, "");
  }
  free(begin);
  free(face);
  return !w->failed;
}

/* As a float32, little endian. */
static void
set_float(sg_writer *w, double x, unsigned char *out)
{
  float f = (float)x;
  uint32_t bits;

  if (!isfinite(f)) {
    fail(w, SG_MESH_UNSUPPORTED, "a coordinate too large for binary STL");
  }
  memcpy(&bits, &f, sizeof bits);
  for (int i = 0; i < 4; i++) {
    out[i] = (unsigned char)(bits >> 8 * i & 0xff);
  }
}

static bool
write_stl_binary(sg_writer *w)
{
  static const char header[STL_HEADER] = "binary STL by Sanggwan";
  const sg_mesh_lists *face = &w->mesh->face;

  put(w, header, sizeof header);
  put_bits(w, face->count, 4);
  for (size_t i = 0; i < face->count && tick(w); i++) {
    size_t size;
    const int32_t *v = corners(face, i, &size);
    unsigned char record[STL_RECORD] = {0};
    double n[3];

    normal_of(w->mesh, v, n);
    for (int k = 0; k < 3; k++) {
      set_float(w, n[k], record + 4 * k);
      for (int c = 0; c < 3; c++) {
        set_float(w, w->mesh->vertex[v[c]][k], record + 12 * (c + 1) + 4 * k);
      }
    }
    put(w, record, sizeof record);
  }
  return !w->failed;
}

/* OFF and OBJ ------------------------------------------------------------ */

static void
put_list(sg_writer *w, const sg_mesh_lists *lists, size_t i, bool counted,
         size_t base)
{
  size_t n;
  const int32_t *v = corners(lists, i, &n);

  if (counted) {
    put_integer(w, n);
  }
  for (size_t k = 0; k < n; k++) {
    if (k || counted) {
      put(w, " ", 1);
    }
    put_integer(w, (size_t)v[k] + base);
  }
  put_text(w, "\n");
}

/* OFF knows no curves: each of their edges is a face of two corners. */
static void
put_off_curve(sg_writer *w, size_t i)
{
  size_t n;
  const int32_t *v = corners(&w->mesh->curve, i, &n);

  for (size_t k = 0; k + 1 < n; k++) {
    put_text(w, "2 ");
    put_integer(w, (size_t)v[k]);
    put_text(w, " ");
    put_integer(w, (size_t)v[k + 1]);
    put_text(w, "\n");
  }
}

/* As OFF and PLY have them: a point a line, then a face a line. */
static void
put_points_and_faces(sg_writer *w)
{
  const sg_mesh *mesh = w->mesh;

  for (size_t i = 0; i < mesh->vertices && tick(w); i++) {
    put_point(w, mesh->vertex[i]);
    put_text(w, "\n");
  }
  for (size_t i = 0; i < mesh->face.count && tick(w); i++) {
    put_list(w, &mesh->face, i, true, 0);
  }
}

static bool
write_off(sg_writer *w)
{
  const sg_mesh *mesh = w->mesh;

  put_text(w, "OFF\n");
  put_precision(w, "#");
  put_integer(w, mesh->vertices);
  put_text(w, " ");
  put_integer(w, mesh->face.count + mesh->curve.corners - mesh->curve.count);
  put_text(w, " 0\n");
  put_points_and_faces(w);
  for (size_t i = 0; i < mesh->curve.count && tick(w); i++) {
    put_off_curve(w, i);
  }
  return !w->failed;
}

static void
put_obj_lists(sg_writer *w, const sg_mesh_lists *lists, const char *keyword,
              int32_t *segment)
{
  for (size_t i = 0; i < lists->count && tick(w); i++) {
    if (lists->segment[i] != *segment) {
      *segment = lists->segment[i];
      put_text(w, "o ");
      put_name(w, (size_t)*segment);
      put_text(w, "\n");
    }
    put_text(w, keyword);
    put_list(w, lists, i, false, 1);
  }
}

static bool
write_obj(sg_writer *w)
{
  const sg_mesh *mesh = w->mesh;
  int32_t segment = mesh->segments == 1 && !mesh->name[0] ? 0 : -1;

  put_precision(w, "#");
  for (size_t i = 0; i < mesh->vertices && tick(w); i++) {
    put_text(w, "v ");
    put_point(w, mesh->vertex[i]);
    put_text(w, "\n");
  }
  put_obj_lists(w, &mesh->face, "f ", &segment);
  put_obj_lists(w, &mesh->curve, "l ", &segment);
  return !w->failed;
}

/* PLY -------------------------------------------------------------------- */

static void
put_ply_header(sg_writer *w, const char *format)
{
  put_text(w, "ply\nformat ");
  put_text(w, format);
  put_text(w, " 1.0\n");
  put_precision(w, "comment");
  put_text(w, "element vertex ");
  put_integer(w, w->mesh->vertices);
  put_text(w, "\nproperty double x\nproperty double y\nproperty double z\n");
  put_text(w, "element face ");
  put_integer(w, w->mesh->face.count);
  put_text(w, "\nproperty list uint int vertex_indices\n");
  if (w->mesh->curve.count) {
    put_text(w, "element edge ");
    put_integer(w, w->mesh->curve.corners - w->mesh->curve.count);
    put_text(w, "\nproperty int vertex1\nproperty int vertex2\n");
  }
  put_text(w, "end_header\n");
}

static bool
write_ply(sg_writer *w)
{
  const sg_mesh *mesh = w->mesh;

  put_ply_header(w, "ascii");
  put_points_and_faces(w);
  for (size_t i = 0; i < mesh->curve.count && tick(w); i++) {
    size_t n;
    const int32_t *v = corners(&mesh->curve, i, &n);
    for (size_t k = 0; k + 1 < n; k++) {
      put_integer(w, (size_t)v[k]);
      put_text(w, " ");
      put_integer(w, (size_t)v[k + 1]);
      put_text(w, "\n");
    }
  }
  return !w->failed;
}

static void
put_binary_list(sg_writer *w, const int32_t *v, size_t n)
{
  put_bits(w, n, 4);
  for (size_t k = 0; k < n; k++) {
    put_bits(w, (uint64_t)v[k], 4);
  }
}

static bool
write_ply_binary(sg_writer *w)
{
  const sg_mesh *mesh = w->mesh;
  size_t n;

  put_ply_header(w, "binary_little_endian");
  for (size_t i = 0; i < mesh->vertices && tick(w); i++) {
    for (int k = 0; k < 3; k++) {
      uint64_t bits;
      memcpy(&bits, &mesh->vertex[i][k], sizeof bits);
      put_bits(w, bits, sizeof bits);
    }
  }
  for (size_t i = 0; i < mesh->face.count && tick(w); i++) {
    const int32_t *v = corners(&mesh->face, i, &n);
    put_binary_list(w, v, n);
  }
  for (size_t i = 0; i < mesh->curve.count && tick(w); i++) {
    const int32_t *v = corners(&mesh->curve, i, &n);
    for (size_t k = 0; k + 1 < n; k++) {
      put_bits(w, (uint64_t)v[k], 4);
      put_bits(w, (uint64_t)v[k + 1], 4);
    }
  }
  return !w->failed;
}

static bool
write_format(sg_writer *w, sg_mesh_format format)
{
  switch (format) {
  case SG_MESH_STL:
    return check_triangles(w) && write_stl(w);
  case SG_MESH_STL_BINARY:
    return check_triangles(w) && write_stl_binary(w);
  case SG_MESH_OFF:
    return write_off(w);
  case SG_MESH_OBJ:
    return write_obj(w);
  case SG_MESH_PLY:
    return write_ply(w);
  case SG_MESH_PLY_BINARY:
    return write_ply_binary(w);
  case SG_MESH_UNKNOWN:
    break;
  }
  return fail(w, SG_MESH_UNKNOWN_FORMAT, "");
}

bool
sg_mesh_write(sg_mesh_format format, const sg_mesh *mesh,
              const sg_mesh_sink *sink, const sg_cancel *cancel,
              sg_mesh_error *error)
{
  sg_writer w;

  w.mesh = mesh;
  w.sink = sink;
  w.cancel = cancel;
  w.error = error;
  w.used = 0;
  w.ticks = 0;
  w.failed = false;
  *error = (sg_mesh_error){.wanted = ""};
  return write_format(&w, format) && flush(&w);
}
