/* mesh.c -- building, cleaning and choosing: what all formats share. */
#include "mesh.h"
#include "engine/list.h"
#include "mesh_private.h"
#include "polygon/flatness.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  DOUBLE_DIGITS = 15, /* a text with more has doubles */
  STEPS = 100000      /* a text that tells fewer places apart is exact */
};

const char *const sg_mesh_code_name[SG_MESH_CODES] = {
    [SG_MESH_FINE] = "fine",
    [SG_MESH_STOPPED] = "stopped",
    [SG_MESH_NO_MEMORY] = "no_memory",
    [SG_MESH_EMPTY_FILE] = "empty_file",
    [SG_MESH_NO_FACES] = "no_faces",
    [SG_MESH_UNKNOWN_FORMAT] = "unknown_format",
    [SG_MESH_UNSUPPORTED] = "unsupported",
    [SG_MESH_EXPECTED] = "expected",
    [SG_MESH_BAD_NUMBER] = "bad_number",
    [SG_MESH_NOT_FINITE] = "not_finite",
    [SG_MESH_TOO_FAR] = "too_far",
    [SG_MESH_BAD_INDEX] = "bad_index",
    [SG_MESH_BAD_COUNT] = "bad_count",
    [SG_MESH_TRUNCATED] = "truncated",
    [SG_MESH_SHORT_FACE] = "short_face",
    [SG_MESH_TOO_LARGE] = "too_large",
    [SG_MESH_NO_PROPERTY] = "no_property",
    [SG_MESH_WRITE_FAILED] = "write_failed",
};

/* Building --------------------------------------------------------------- */

bool
sg_mesh_add_vertex(sg_mesh *mesh, const double xyz[3])
{
  if (mesh->vertices >= INT32_MAX ||
      !sg_list_grow(&mesh->vertex, mesh->vertices, &mesh->vertex_room,
                    sizeof *mesh->vertex)) {
    return false;
  }
  double *p = mesh->vertex[mesh->vertices++];
  for (int i = 0; i < 3; i++) {
    p[i] = xyz[i] + 0.0; /* never -0.0 */
  }
  return true;
}

bool
sg_mesh_add_corner(sg_mesh_lists *lists, int32_t vertex)
{
  if (lists->corners >= INT32_MAX ||
      !sg_list_grow(&lists->corner, lists->corners, &lists->corner_room,
                    sizeof *lists->corner)) {
    return false;
  }
  lists->corner[lists->corners++] = vertex;
  return true;
}

bool
sg_mesh_expect(sg_mesh_lists *lists, size_t count, size_t corners)
{
  return sg_list_need(&lists->corner, corners, &lists->corner_room,
                      sizeof *lists->corner) &&
         sg_list_need(&lists->start, count + 1, &lists->start_room,
                      sizeof *lists->start) &&
         sg_list_need(&lists->segment, count, &lists->room,
                      sizeof *lists->segment);
}

bool
sg_mesh_end_list(sg_mesh_lists *lists, int32_t segment)
{
  if (!sg_list_grow(&lists->start, lists->count + 1, &lists->start_room,
                    sizeof *lists->start) ||
      !sg_list_grow(&lists->segment, lists->count, &lists->room,
                    sizeof *lists->segment)) {
    return false;
  }
  lists->start[0] = 0;
  lists->segment[lists->count] = segment;
  lists->start[++lists->count] = (uint32_t)lists->corners;
  return true;
}

int32_t
sg_mesh_add_segment(sg_mesh *mesh, const char *name, size_t n)
{
  if (mesh->segments >= INT32_MAX ||
      !sg_list_grow(&mesh->name, mesh->segments, &mesh->name_room,
                    sizeof *mesh->name)) {
    return -1;
  }
  char *copy = n ? malloc(n + 1) : NULL;
  if (n) {
    if (!copy) {
      return -1;
    }
    memcpy(copy, name, n);
    copy[n] = '\0';
  }
  mesh->name[mesh->segments] = copy;
  return (int32_t)mesh->segments++;
}

static void
clear_lists(sg_mesh_lists *lists)
{
  free(lists->start);
  free(lists->corner);
  free(lists->segment);
}

void
sg_mesh_clear(sg_mesh *mesh)
{
  free(mesh->vertex);
  clear_lists(&mesh->face);
  clear_lists(&mesh->curve);
  for (size_t i = 0; i < mesh->segments; i++) {
    free(mesh->name[i]);
  }
  free(mesh->name);
  *mesh = (sg_mesh){0};
}

/* Cleaning --------------------------------------------------------------- */

/* Drops corners that repeat the one before, of a face also those at its end
 * that repeat its first; then lists shorter than `least`. The number of lists
 * dropped. */
static size_t
drop_repeats(sg_mesh_lists *lists, bool closed, size_t least, size_t *repeated)
{
  size_t kept = 0, from = 0, to = 0;

  for (size_t i = 0; i < lists->count; i++) {
    size_t first = from, begin = to, end = lists->start[i + 1];
    for (; from < end; from++) {
      if (to == begin || lists->corner[from] != lists->corner[to - 1]) {
        lists->corner[to++] = lists->corner[from];
      }
    }
    while (closed && to > begin + 1 &&
           lists->corner[to - 1] == lists->corner[begin]) {
      to--;
    }
    if (to - begin < least) {
      to = begin;
      continue;
    }
    *repeated += (end - first) - (to - begin);
    lists->segment[kept] = lists->segment[i];
    lists->start[++kept] = (uint32_t)to;
  }
  size_t dropped = lists->count - kept;
  lists->count = kept;
  lists->corners = to;
  return dropped;
}

/* True if there are several faces and no vertex is a corner twice. */
static bool
is_soup(const sg_mesh *mesh)
{
  if (mesh->face.count < 2 || mesh->face.corners > mesh->vertices ||
      mesh->curve.count) {
    return false;
  }
  unsigned char *seen = calloc(mesh->vertices / 8 + 1, 1);
  bool once = seen != NULL;
  for (size_t i = 0; once && i < mesh->face.corners; i++) {
    size_t v = (size_t)mesh->face.corner[i];
    once = !(seen[v / 8] & 1 << v % 8);
    seen[v / 8] = (unsigned char)(seen[v / 8] | 1 << v % 8);
  }
  free(seen);
  return once;
}

/* Numbers the segments of `lists` in `number` (-1: not met yet). */
static void
number_segments(sg_mesh_lists *lists, int32_t *number, int32_t *count)
{
  for (size_t i = 0; i < lists->count; i++) {
    int32_t *s = &lists->segment[i];
    if (number[*s] < 0) {
      number[*s] = (*count)++;
    }
    *s = number[*s];
  }
}

/* Keeps the segments that have something, in the order of first use. */
static bool
drop_empty_segments(sg_mesh *mesh)
{
  size_t n = mesh->segments;
  int32_t *number = malloc(n * sizeof *number + 1);
  char **name = malloc(n * sizeof *name + 1);
  int32_t count = 0;

  if (!number || !name) {
    free(number);
    free(name);
    return false;
  }
  memset(number, -1, n * sizeof *number);
  number_segments(&mesh->face, number, &count);
  number_segments(&mesh->curve, number, &count);
  for (size_t i = 0; i < n; i++) {
    if (number[i] < 0) {
      free(mesh->name[i]);
    } else {
      name[number[i]] = mesh->name[i];
    }
  }
  free(number);
  free(mesh->name);
  mesh->name = name;
  mesh->segments = (size_t)count;
  return true;
}

/* How fine the source is: as it says, or as its numbers were written. Decimals
 * are rounded ones only if they tell many places apart along the longest side:
 * 1000.5 in a box of 10 is exact. */
static double
source_grain(const sg_mesh_reader *r)
{
  double single = sg_flatness_single(r->single);
  sg_flatness all;

  if (r->stated >= 0) {
    return r->stated;
  }
  if (r->digits > DOUBLE_DIGITS || r->widest == 0) {
    return single;
  }
  sg_flatness_init(&all, 0);
  for (size_t i = 0; i < r->mesh->vertices; i++) {
    sg_flatness_see(&all, r->mesh->vertex[i]);
  }
  double unit = pow(10, floor(log10(r->widest)) + 1 - r->digits);

  return sg_flatness_size(&all) >= STEPS * unit ? fmax(single, unit) : single;
}

static bool
finish(sg_mesh_reader *r, sg_mesh_format format)
{
  sg_mesh *mesh = r->mesh;
  sg_mesh_weld weld = r->joined ? SG_WELD_NONE : r->weld;
  bool stopped = false;

  if (weld == SG_WELD_AUTO && format != SG_MESH_STL) {
    weld = is_soup(mesh) ? SG_WELD_ALL : SG_WELD_NONE;
  }
  if (weld != SG_WELD_NONE &&
      !sg_mesh_weld_vertices(mesh, r->cancel, &stopped)) {
    return sg_mesh_fail_byte(r, stopped ? SG_MESH_STOPPED : SG_MESH_NO_MEMORY,
                             0, NULL, 0, 0);
  }
  mesh->degenerate = drop_repeats(&mesh->face, true, 3, &mesh->repeated);
  mesh->degenerate += drop_repeats(&mesh->curve, false, 2, &mesh->repeated);
  if (!mesh->face.count && !mesh->curve.count) {
    return sg_mesh_fail(r, SG_MESH_NO_FACES, NULL, NULL);
  }
  if (!drop_empty_segments(mesh)) {
    return sg_mesh_fail_byte(r, SG_MESH_NO_MEMORY, 0, NULL, 0, 0);
  }
  mesh->grain = source_grain(r);
  return true;
}

/* Choosing --------------------------------------------------------------- */

static sg_mesh_reader
open_reader(const char *bytes, size_t n)
{
  size_t bom = n >= 3 && !memcmp(bytes, "\xef\xbb\xbf", 3) ? 3 : 0;

  return (sg_mesh_reader){.start = bytes,
                          .at = bytes + bom,
                          .end = bytes + n,
                          .line = 1,
                          .stated = -1,
                          .line_start = bytes + bom};
}

static bool
is_obj_word(const sg_word *w)
{
  static const char *const words[] = {"v", "vn", "vt", "f",      "l",
                                      "o", "g",  "s",  "mtllib", "usemtl"};

  for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
    if (sg_word_is(w, words[i])) {
      return true;
    }
  }
  return false;
}

sg_mesh_format
sg_mesh_detect(const char *bytes, size_t n)
{
  sg_mesh_reader r = open_reader(bytes, n);
  sg_word w;

  if (sg_stl_is_binary(bytes, n)) {
    return SG_MESH_STL;
  }
  r.hash = true;
  if (!sg_word_next(&r, &w)) {
    return SG_MESH_UNKNOWN;
  }
  if (sg_word_is(&w, "ply")) {
    return SG_MESH_PLY;
  }
  if (sg_word_is(&w, "solid")) {
    return SG_MESH_STL;
  }
  if (w.n >= 3 && w.n <= 9 && !memcmp(w.text + w.n - 3, "OFF", 3)) {
    return SG_MESH_OFF;
  }
  return is_obj_word(&w) ? SG_MESH_OBJ : SG_MESH_UNKNOWN;
}

static bool
is_blank_file(const char *bytes, size_t n)
{
  sg_mesh_reader r = open_reader(bytes, n);
  sg_word w;

  return !sg_word_next(&r, &w);
}

static bool
read_format(sg_mesh_reader *r, sg_mesh_format format)
{
  switch (format) {
  case SG_MESH_STL:
  case SG_MESH_STL_BINARY:
    return sg_stl_read(r);
  case SG_MESH_OFF:
    return sg_off_read(r);
  case SG_MESH_OBJ:
    return sg_obj_read(r);
  case SG_MESH_PLY:
  case SG_MESH_PLY_BINARY:
    return sg_ply_read(r);
  case SG_MESH_UNKNOWN:
    break;
  }
  return sg_mesh_fail(r, SG_MESH_UNKNOWN_FORMAT, NULL, NULL);
}

bool
sg_mesh_read(sg_mesh_format format, const char *bytes, size_t n,
             const sg_mesh_options *options, sg_mesh *out, sg_mesh_error *error)
{
  sg_mesh_reader r = open_reader(bytes, n);

  *out = (sg_mesh){0};
  *error = (sg_mesh_error){.wanted = ""};
  r.mesh = out;
  r.error = error;
  r.cancel = options->cancel;
  r.one_segment = options->one_segment;
  r.weld = options->weld;
  if (is_blank_file(bytes, n)) {
    return sg_mesh_fail(&r, SG_MESH_EMPTY_FILE, NULL, NULL);
  }
  if (format == SG_MESH_UNKNOWN) {
    format = sg_mesh_detect(bytes, n);
  }
  if (read_format(&r, format) && finish(&r, format)) {
    return true;
  }
  sg_mesh_clear(out);
  return false;
}
