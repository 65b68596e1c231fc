/* mesh_ply.c -- reads PLY: text and binary of both byte orders.
 *
 * Taken: element vertex (x, y, z), element face (list vertex_indices or
 * vertex_index), element edge (vertex1, vertex2) as curves. Other properties
 * and elements are read past.
 */
#include "mesh_private.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MAX_ELEMENTS = 64, MAX_PROPERTIES = 256, MAX_TYPE = 8 };

typedef enum sg_ply_type {
  PLY_NONE,
  PLY_INT8,
  PLY_UINT8,
  PLY_INT16,
  PLY_UINT16,
  PLY_INT32,
  PLY_UINT32,
  PLY_FLOAT32,
  PLY_FLOAT64
} sg_ply_type;

typedef enum sg_ply_role {
  PLY_OTHER,
  PLY_X,
  PLY_Y,
  PLY_Z,
  PLY_CORNERS,
  PLY_VERTEX1,
  PLY_VERTEX2
} sg_ply_role;

typedef struct sg_ply_property {
  sg_ply_type type;  /* of a list: of its items */
  sg_ply_type count; /* of a list: of its length, else PLY_NONE */
  sg_ply_role role;
} sg_ply_property;

typedef enum sg_ply_kind {
  PLY_VERTEX,
  PLY_FACE,
  PLY_EDGE,
  PLY_UNKNOWN
} sg_ply_kind;

typedef struct sg_ply_element {
  sg_ply_kind kind;
  sg_word name; /* in the header */
  uint64_t count;
  size_t first, properties; /* of the table of properties */
} sg_ply_element;

typedef enum sg_ply_coding { PLY_TEXT, PLY_LITTLE, PLY_BIG } sg_ply_coding;

typedef struct sg_ply {
  sg_mesh_reader *r;
  sg_ply_coding coding;
  size_t elements, properties;
  uint64_t vertices; /* promised by the header */
  sg_ply_element element[MAX_ELEMENTS];
  sg_ply_property property[MAX_PROPERTIES];
} sg_ply;

static const size_t type_size[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};

/* Header ----------------------------------------------------------------- */

static sg_ply_type
type_named(const sg_word *w)
{
  static const struct {
    const char *name;
    sg_ply_type type;
  } types[] = {{"char", PLY_INT8},      {"int8", PLY_INT8},
               {"uchar", PLY_UINT8},    {"uint8", PLY_UINT8},
               {"short", PLY_INT16},    {"int16", PLY_INT16},
               {"ushort", PLY_UINT16},  {"uint16", PLY_UINT16},
               {"int", PLY_INT32},      {"int32", PLY_INT32},
               {"uint", PLY_UINT32},    {"uint32", PLY_UINT32},
               {"float", PLY_FLOAT32},  {"float32", PLY_FLOAT32},
               {"double", PLY_FLOAT64}, {"float64", PLY_FLOAT64}};

  for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
    if (sg_word_is(w, types[i].name)) {
      return types[i].type;
    }
  }
  return PLY_NONE;
}

static sg_ply_role
role_named(sg_ply_kind kind, bool list, const sg_word *w)
{
  switch (kind) {
  case PLY_VERTEX:
    return list                 ? PLY_OTHER
           : sg_word_is(w, "x") ? PLY_X
           : sg_word_is(w, "y") ? PLY_Y
           : sg_word_is(w, "z") ? PLY_Z
                                : PLY_OTHER;
  case PLY_FACE:
    return list && (sg_word_is(w, "vertex_indices") ||
                    sg_word_is(w, "vertex_index"))
               ? PLY_CORNERS
               : PLY_OTHER;
  case PLY_EDGE:
    return list                       ? PLY_OTHER
           : sg_word_is(w, "vertex1") ? PLY_VERTEX1
           : sg_word_is(w, "vertex2") ? PLY_VERTEX2
                                      : PLY_OTHER;
  case PLY_UNKNOWN:
    break;
  }
  return PLY_OTHER;
}

static bool
read_coding(sg_ply *ply)
{
  static const char *const names[] = {"ascii", "binary_little_endian",
                                      "binary_big_endian"};
  sg_word w;

  sg_word_here(ply->r, &w);
  for (int i = 0; i < 3; i++) {
    if (sg_word_is(&w, names[i])) {
      ply->coding = (sg_ply_coding)i;
      if (sg_word_here(ply->r, &w) && !sg_word_is(&w, "1.0")) {
        return sg_mesh_fail(ply->r, SG_MESH_UNSUPPORTED, &w, NULL);
      }
      return true;
    }
  }
  return sg_mesh_fail(ply->r, SG_MESH_EXPECTED, &w,
                      "ascii, binary_little_endian or binary_big_endian");
}

static bool
read_element(sg_ply *ply)
{
  sg_mesh_reader *r = ply->r;
  sg_word name, w;
  int64_t count;

  if (!sg_word_here(r, &name)) {
    return sg_mesh_fail(r, SG_MESH_EXPECTED, &name, "the name of an element");
  }
  if (!sg_word_here(r, &w) || !sg_word_integer(&w, &count) || count < 0) {
    return sg_mesh_fail(r, SG_MESH_BAD_COUNT, &w, "elements");
  }
  if (ply->elements == MAX_ELEMENTS) {
    return sg_mesh_fail(r, SG_MESH_UNSUPPORTED, &name, NULL);
  }
  sg_ply_kind kind = sg_word_is(&name, "vertex") ? PLY_VERTEX
                     : sg_word_is(&name, "face") ? PLY_FACE
                     : sg_word_is(&name, "edge") ? PLY_EDGE
                                                 : PLY_UNKNOWN;
  if (kind == PLY_VERTEX) {
    ply->vertices += (uint64_t)count;
  }
  ply->element[ply->elements++] =
      (sg_ply_element){kind, name, (uint64_t)count, ply->properties, 0};
  return true;
}

static bool
read_type(sg_ply *ply, sg_ply_type *out)
{
  sg_word w;

  sg_word_here(ply->r, &w);
  *out = type_named(&w);
  return *out != PLY_NONE ||
         sg_mesh_fail(ply->r, SG_MESH_EXPECTED, &w, "a type such as float");
}

static bool
read_property(sg_ply *ply)
{
  sg_mesh_reader *r = ply->r;
  sg_mesh_reader before = *r;
  sg_ply_property p = {PLY_NONE, PLY_NONE, PLY_OTHER};
  sg_word w;

  if (!ply->elements) {
    return sg_mesh_fail(r, SG_MESH_EXPECTED, NULL, "an element before this");
  }
  sg_word_here(r, &w);
  if (!sg_word_is(&w, "list")) {
    *r = before;
  } else if (!read_type(ply, &p.count)) {
    return false;
  } else if (p.count >= PLY_FLOAT32) {
    return sg_mesh_fail(r, SG_MESH_UNSUPPORTED, &w, NULL);
  }
  if (!read_type(ply, &p.type)) {
    return false;
  }
  if (!sg_word_here(r, &w)) {
    return sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "the name of a property");
  }
  if (ply->properties == MAX_PROPERTIES) {
    return sg_mesh_fail(r, SG_MESH_UNSUPPORTED, &w, NULL);
  }
  sg_ply_element *e = &ply->element[ply->elements - 1];
  p.role = role_named(e->kind, p.count != PLY_NONE, &w);
  ply->property[ply->properties++] = p;
  e->properties++;
  return true;
}

static bool
read_header_line(sg_ply *ply, const sg_word *w)
{
  if (sg_word_is(w, "format")) {
    return read_coding(ply);
  }
  if (sg_word_is(w, "element")) {
    return read_element(ply);
  }
  if (sg_word_is(w, "property")) {
    return read_property(ply);
  }
  if (sg_word_is(w, "comment")) {
    const char *text = ply->r->at;
    sg_mesh_precision(ply->r, text, text + sg_word_rest(ply->r).n + 1);
    return true;
  }
  return sg_word_is(w, "obj_info") ||
         sg_mesh_fail(ply->r, SG_MESH_EXPECTED, w, "end_header");
}

/* An element that is used must have what is used of it, exactly once. */
static bool
check_roles(sg_ply *ply, const sg_ply_element *e)
{
  static const struct {
    sg_ply_kind kind;
    sg_ply_role role;
    const char *name;
  } needed[] = {{PLY_VERTEX, PLY_X, "x"},
                {PLY_VERTEX, PLY_Y, "y"},
                {PLY_VERTEX, PLY_Z, "z"},
                {PLY_FACE, PLY_CORNERS, "vertex_indices"},
                {PLY_EDGE, PLY_VERTEX1, "vertex1"},
                {PLY_EDGE, PLY_VERTEX2, "vertex2"}};

  for (size_t i = 0; i < sizeof needed / sizeof *needed; i++) {
    int found = 0;
    for (size_t k = 0; k < e->properties; k++) {
      found += ply->property[e->first + k].role == needed[i].role;
    }
    if (needed[i].kind == e->kind && found != 1 && e->count) {
      return sg_mesh_fail(ply->r, SG_MESH_NO_PROPERTY, &e->name,
                          needed[i].name);
    }
  }
  return true;
}

static bool
read_header(sg_ply *ply)
{
  sg_mesh_reader *r = ply->r;
  sg_word w;

  if (!sg_word_next(r, &w) || !sg_word_is(&w, "ply")) {
    return sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "ply");
  }
  for (;;) {
    if (!sg_word_next(r, &w)) {
      return sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "end_header");
    }
    if (sg_word_is(&w, "end_header")) {
      break;
    }
    if (!read_header_line(ply, &w)) {
      return false;
    }
    sg_word_skip_line(r);
  }
  sg_word_skip_line(r);
  for (size_t i = 0; i < ply->elements; i++) {
    if (!check_roles(ply, &ply->element[i])) {
      return false;
    }
  }
  return ply->vertices <= INT32_MAX ||
         sg_mesh_fail(r, SG_MESH_TOO_LARGE, NULL, "vertices");
}

/* Data ------------------------------------------------------------------- */

static uint64_t
get_bits(const char *at, size_t n, bool big)
{
  uint64_t bits = 0;

  for (size_t i = 0; i < n; i++) {
    size_t place = big ? n - 1 - i : i;
    bits |= (uint64_t)(unsigned char)at[i] << 8 * place;
  }
  return bits;
}

static double
to_double(sg_ply_type type, uint64_t bits)
{
  double d;
  float f;
  uint32_t low = (uint32_t)bits;

  switch (type) {
  case PLY_INT8:
    return (double)(int8_t)bits;
  case PLY_INT16:
    return (double)(int16_t)bits;
  case PLY_INT32:
    return (double)(int32_t)bits;
  case PLY_UINT8:
  case PLY_UINT16:
  case PLY_UINT32:
    return (double)low;
  case PLY_FLOAT32:
    memcpy(&f, &low, sizeof f);
    return (double)f;
  case PLY_FLOAT64:
    memcpy(&d, &bits, sizeof d);
    return d;
  case PLY_NONE:
    break;
  }
  return 0;
}

/* Where a scalar of the data stands, for messages. */
static bool
fail_at(sg_ply *ply, sg_mesh_code code, const sg_word *w, const char *wanted,
        int64_t got, int64_t limit)
{
  sg_mesh_fail_numbers(ply->r, code, w, wanted, got, limit);
  if (ply->coding != PLY_TEXT) {
    ply->r->error->line = ply->r->error->column = 0;
    ply->r->error->text[0] = '\0';
  }
  return false;
}

/* The next scalar; `w` says where it is. */
static bool
read_scalar(sg_ply *ply, sg_ply_type type, sg_word *w, double *out)
{
  sg_mesh_reader *r = ply->r;

  if (ply->coding == PLY_TEXT) {
    if (!sg_word_next(r, w)) {
      return sg_mesh_fail(r, SG_MESH_EXPECTED, w, "a number");
    }
    return sg_mesh_coordinate(r, w, out);
  }
  size_t n = type_size[type];
  *w = (sg_word){r->at, 0, 0};
  if ((size_t)(r->end - r->at) < n) {
    return fail_at(ply, SG_MESH_TRUNCATED, w, "bytes", r->end - r->start,
                   r->at - r->start + (int64_t)n);
  }
  *out = to_double(type, get_bits(r->at, n, ply->coding == PLY_BIG));
  r->at += n;
  return true;
}

/* Reads past a scalar that nobody needs. */
static bool
skip_scalar(sg_ply *ply, sg_ply_type type)
{
  sg_mesh_reader *r = ply->r;
  sg_word w;
  double ignored;

  if (ply->coding == PLY_TEXT) {
    return sg_word_next(r, &w) ||
           sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "a number");
  }
  return read_scalar(ply, type, &w, &ignored);
}

static bool
read_coordinate(sg_ply *ply, sg_ply_type type, double *out)
{
  sg_word w;

  if (!read_scalar(ply, type, &w, out)) {
    return false;
  }
  if (!isfinite(*out)) {
    fail_at(ply, SG_MESH_NOT_FINITE, &w, NULL, 0, 0);
    strcpy(ply->r->error->text, isnan(*out) ? "nan"
                                : *out < 0  ? "-inf"
                                            : "inf");
    return false;
  }
  if (fabs(*out) > SG_MESH_FARTHEST) {
    fail_at(ply, SG_MESH_TOO_FAR, &w, NULL, 0, 0);
    snprintf(ply->r->error->text, SG_MESH_TEXT, "%.6g", *out);
    return false;
  }
  if (type == PLY_FLOAT32) {
    ply->r->single = fmax(ply->r->single, fabs(*out));
  }
  return true;
}

static bool
read_index(sg_ply *ply, sg_ply_type type, int32_t *out)
{
  const sg_mesh_reader before = *ply->r;
  sg_word w;
  double i;

  if (!read_scalar(ply, type, &w, &i)) {
    return false;
  }
  ply->r->digits = before.digits;
  ply->r->widest = before.widest;
  if (i != floor(i)) {
    return fail_at(ply, SG_MESH_EXPECTED, &w, "a vertex number", 0, 0);
  }
  if (!(i >= 0 && i < (double)ply->vertices)) {
    return fail_at(ply, SG_MESH_BAD_INDEX, &w, "0",
                   fabs(i) < 1e15 ? (int64_t)i : INT64_MAX,
                   (int64_t)ply->vertices - 1);
  }
  *out = (int32_t)i;
  return true;
}

static bool
read_length(sg_ply *ply, sg_ply_type type, sg_word *w, uint64_t *out)
{
  const sg_mesh_reader before = *ply->r;
  double n;

  if (!read_scalar(ply, type, w, &n)) {
    return false;
  }
  ply->r->digits = before.digits;
  ply->r->widest = before.widest;
  if (!(n >= 0 && n <= UINT32_MAX && n == floor(n))) {
    return fail_at(ply, SG_MESH_BAD_COUNT, w, "items of a list", 0, 0);
  }
  *out = (uint64_t)n;
  return true;
}

static bool
read_corners(sg_ply *ply, const sg_ply_property *p)
{
  uint64_t n;
  int32_t v;
  sg_word at;

  if (!read_length(ply, p->count, &at, &n)) {
    return false;
  }
  if (n < 3) {
    return fail_at(ply, SG_MESH_SHORT_FACE, &at, NULL, (int64_t)n, 3);
  }
  for (uint64_t i = 0; i < n; i++) {
    if (!read_index(ply, p->type, &v) ||
        !sg_mesh_corner(ply->r, &ply->r->mesh->face, v)) {
      return false;
    }
  }
  return sg_mesh_end(ply->r, &ply->r->mesh->face, 0);
}

static bool
skip_property(sg_ply *ply, const sg_ply_property *p)
{
  uint64_t n = 1;
  sg_word at;

  if (p->count != PLY_NONE && !read_length(ply, p->count, &at, &n)) {
    return false;
  }
  for (uint64_t i = 0; i < n; i++) {
    if (!skip_scalar(ply, p->type)) {
      return false;
    }
  }
  return true;
}

static bool
read_item(sg_ply *ply, const sg_ply_element *e)
{
  sg_mesh *mesh = ply->r->mesh;
  double xyz[3] = {0, 0, 0};
  int32_t end[2] = {0, 0};

  for (size_t k = 0; k < e->properties; k++) {
    const sg_ply_property *p = &ply->property[e->first + k];
    bool good = false;
    switch (p->role) {
    case PLY_X:
    case PLY_Y:
    case PLY_Z:
      good = read_coordinate(ply, p->type, &xyz[p->role - PLY_X]);
      break;
    case PLY_CORNERS:
      good = read_corners(ply, p);
      break;
    case PLY_VERTEX1:
    case PLY_VERTEX2:
      good = read_index(ply, p->type, &end[p->role - PLY_VERTEX1]);
      break;
    case PLY_OTHER:
      good = skip_property(ply, p);
      break;
    }
    if (!good) {
      return false;
    }
  }
  if (e->kind == PLY_VERTEX) {
    return sg_mesh_vertex(ply->r, xyz);
  }
  if (e->kind == PLY_EDGE) {
    return sg_mesh_corner(ply->r, &mesh->curve, end[0]) &&
           sg_mesh_corner(ply->r, &mesh->curve, end[1]) &&
           sg_mesh_end(ply->r, &mesh->curve, 0);
  }
  return sg_mesh_tick(ply->r);
}

/* The least number of bytes that one item takes. */
static size_t
least_bytes(const sg_ply *ply, const sg_ply_element *e)
{
  size_t least = 0;

  for (size_t k = 0; k < e->properties; k++) {
    const sg_ply_property *p = &ply->property[e->first + k];
    least += ply->coding == PLY_TEXT ? 2
             : p->count != PLY_NONE  ? type_size[p->count]
                                     : type_size[p->type];
  }
  return least;
}

static bool
read_items(sg_ply *ply, const sg_ply_element *e)
{
  size_t least = least_bytes(ply, e);
  size_t left = (size_t)(ply->r->end - ply->r->at);

  if (least == 0) {
    return true; /* nothing is stored for them */
  }
  if (e->count > (left + 1) / least) {
    sg_word at = {ply->r->at, 0, ply->r->line};
    return fail_at(ply, SG_MESH_TRUNCATED, &at,
                   e->kind == PLY_VERTEX ? "vertices"
                   : e->kind == PLY_FACE ? "faces"
                                         : "items",
                   (int64_t)((left + 1) / least), (int64_t)e->count);
  }
  for (uint64_t i = 0; i < e->count; i++) {
    if (!read_item(ply, e)) {
      return false;
    }
  }
  if (e->kind == PLY_UNKNOWN && e->count) {
    sg_mesh_ignore(ply->r, e->name.line);
  }
  return true;
}

bool
sg_ply_read(sg_mesh_reader *r)
{
  sg_ply ply = {.r = r};

  if (!read_header(&ply) || sg_mesh_segment(r, NULL) < 0) {
    return false;
  }
  for (size_t i = 0; i < ply.elements; i++) {
    if (!read_items(&ply, &ply.element[i])) {
      return false;
    }
  }
  sg_word w;
  if (ply.coding != PLY_TEXT || sg_word_next(r, &w)) {
    r->mesh->trailing =
        (size_t)(r->end - (ply.coding == PLY_TEXT ? w.text : r->at));
  }
  return true;
}
