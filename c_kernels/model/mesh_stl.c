/* mesh_stl.c -- reads STL, text and binary.
 *
 * A binary file: 80 bytes of anything, the number of triangles (uint32), and
 * for each 12 float32 (normal, three corners) and 2 bytes; little endian. Many
 * begin with the word "solid" all the same, so that word decides nothing.
 */
#include "mesh_private.h"
#include "rows/key_table.h"

#include <math.h>
#include <string.h>

enum {
  HEADER = 84,
  RECORD = 50,
  COUNT_AT = 80,
  NORMAL = 12,
  AHEAD = 3 /* records */
};

#define MINUS_ZERO 0x80000000u /* as a float32 */

static uint32_t
get_uint32(const char *p)
{
  const unsigned char *b = (const unsigned char *)p;

  return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 |
         (uint32_t)b[3] << 24;
}

static float
get_float32(const char *p)
{
  uint32_t bits = get_uint32(p);
  float x;

  memcpy(&x, &bits, sizeof x);
  return x;
}

/* True if the bytes start like text: "solid", then a line that begins with
 * facet or endsolid, or at least no control characters early on. */
static bool
starts_as_text(const char *bytes, size_t n)
{
  sg_mesh_reader r = {.start = bytes, .at = bytes, .end = bytes + n, .line = 1};
  sg_word w;

  if (n >= 3 && !memcmp(bytes, "\xef\xbb\xbf", 3)) {
    r.at += 3;
  }
  if (!sg_word_next(&r, &w) || !sg_word_is(&w, "solid")) {
    return false;
  }
  sg_word_skip_line(&r);
  if (sg_word_next(&r, &w) &&
      (sg_word_is(&w, "facet") || sg_word_is(&w, "endsolid"))) {
    return true;
  }
  for (size_t i = 0; i < n && i < 2 * HEADER; i++) {
    if ((unsigned char)bytes[i] < ' ' && !strchr("\t\n\v\f\r", bytes[i])) {
      return false;
    }
  }
  return true;
}

/* True if the length is just what the count says, or if there is room for a
 * header and the bytes are no text. */
bool
sg_stl_is_binary(const char *bytes, size_t n)
{
  if (n < HEADER) {
    return false;
  }
  uint64_t count = get_uint32(bytes + COUNT_AT);
  if (HEADER + count * RECORD == n) {
    return true;
  }
  return !starts_as_text(bytes, n) && memchr(bytes, '\0', HEADER) != NULL;
}

/* Corner i of a record, at 3 float32. */
static const char *
corner_at(const char *record, int i)
{
  return record + NORMAL + 12 * i;
}

static bool
read_vertex(sg_mesh_reader *r, const char *corner)
{
  double p[3];

  for (int k = 0; k < 3; k++) {
    const char *at = corner + 4 * k;
    p[k] = (double)get_float32(at);
    if (!isfinite(p[k])) {
      sg_mesh_fail_byte(r, SG_MESH_NOT_FINITE, (size_t)(at - r->start), NULL, 0,
                        0);
      strcpy(r->error->text, isnan(p[k]) ? "nan" : p[k] < 0 ? "-inf" : "inf");
      return false;
    }
    r->single = fmax(r->single, fabs(p[k]));
  }
  return sg_mesh_vertex(r, p);
}

/* The bits of a place: of equal ones the same, as 0.0 is for -0.0. */
static void
get_key(const char *corner, uint32_t key[3])
{
  for (int k = 0; k < 3; k++) {
    uint32_t bits = get_uint32(corner + 4 * k);

    key[k] = bits == MINUS_ZERO ? 0 : bits;
  }
}

/* The vertex at a corner: that of a place that is known, or a new one. */
static bool
find_vertex(sg_mesh_reader *r, sg_key_table *places, const char *corner,
            int32_t *v)
{
  uint32_t key[3], *place;

  get_key(corner, key);
  if (!(place = sg_key_table_put(places, key))) {
    return sg_mesh_fail_byte(r, SG_MESH_NO_MEMORY, 0, NULL, 0, 0);
  }
  if (*place == SG_NO_KEY) {
    *place = (uint32_t)r->mesh->vertices;
    if (!read_vertex(r, corner)) {
      return false;
    }
  }
  *v = (int32_t)*place;
  return true;
}

static bool
read_record(sg_mesh_reader *r, sg_key_table *places, const char *record,
            int32_t s)
{
  for (int i = 0; i < 3; i++) {
    const char *corner = corner_at(record, i);
    int32_t v = (int32_t)r->mesh->vertices;

    if (!(r->weld == SG_WELD_NONE ? read_vertex(r, corner)
                                  : find_vertex(r, places, corner, &v)) ||
        !sg_mesh_corner(r, &r->mesh->face, v)) {
      return false;
    }
  }
  return sg_mesh_end(r, &r->mesh->face, s);
}

/* What will be looked up soon is read from memory meanwhile. */
static void
fetch_places(const sg_key_table *places, const char *record)
{
  for (int i = 0; i < 3; i++) {
    uint32_t key[3];

    get_key(corner_at(record, i), key);
    sg_key_table_fetch(places, key);
  }
}

/* Room for so many triangles, which mostly are a closed surface: of half as
 * many vertices. */
static bool
make_room(sg_mesh_reader *r, sg_key_table *places, size_t triangles)
{
  return (sg_mesh_expect(&r->mesh->face, triangles, 3 * triangles) &&
          (r->weld == SG_WELD_NONE ||
           sg_key_table_reserve(places, triangles / 2))) ||
         sg_mesh_fail_byte(r, SG_MESH_NO_MEMORY, 0, NULL, 0, 0);
}

static bool
read_records(sg_mesh_reader *r, sg_key_table *places, uint64_t count)
{
  int32_t s = sg_mesh_segment(r, NULL);
  bool good = s >= 0 && make_room(r, places, count);

  for (uint64_t i = 0; i < count && good; i++) {
    const char *record = r->start + HEADER + i * RECORD;

    if (r->weld != SG_WELD_NONE && i + AHEAD < count) {
      fetch_places(places, record + AHEAD * RECORD);
    }
    good = read_record(r, places, record, s);
  }
  return good;
}

static bool
read_binary(sg_mesh_reader *r)
{
  size_t n = (size_t)(r->end - r->start);
  uint64_t count = get_uint32(r->start + COUNT_AT);
  uint64_t present = (n - HEADER) / RECORD;
  sg_key_table places;

  if (count > present) {
    return sg_mesh_fail_byte(r, SG_MESH_TRUNCATED, n, "triangles",
                             (int64_t)present, (int64_t)count);
  }
  sg_key_table_init(&places, 3);
  bool good = read_records(r, &places, count);

  sg_key_table_clear(&places);
  r->joined = r->weld != SG_WELD_NONE;
  r->mesh->welded = r->mesh->face.corners - r->mesh->vertices;
  r->mesh->trailing = n - HEADER - (size_t)count * RECORD;
  return good;
}

/* Text ------------------------------------------------------------------- */

/* The next word must be `wanted`. */
static bool
take(sg_mesh_reader *r, const char *wanted)
{
  sg_word w;

  sg_word_next(r, &w);
  return sg_word_is(&w, wanted) ||
         sg_mesh_fail(r, SG_MESH_EXPECTED, &w, wanted);
}

static bool
take_point(sg_mesh_reader *r, double p[3])
{
  for (int k = 0; k < 3; k++) {
    sg_word w;
    if (!sg_word_next(r, &w)) {
      return sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "a coordinate");
    }
    if (!sg_mesh_coordinate(r, &w, &p[k])) {
      return false;
    }
  }
  return true;
}

/* The three words of a normal, whatever they are: it is not used, and nan is
 * common there. */
static bool
skip_normal(sg_mesh_reader *r)
{
  sg_word w;

  for (int k = 0; k < 3; k++) {
    if (!sg_word_here(r, &w)) {
      return sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "three numbers of a normal");
    }
  }
  return true;
}

static bool
read_facet(sg_mesh_reader *r, int32_t s)
{
  double p[3];

  if (!take(r, "normal") || !skip_normal(r) || !take(r, "outer") ||
      !take(r, "loop")) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    if (!take(r, "vertex") || !take_point(r, p) || !sg_mesh_vertex(r, p) ||
        !sg_mesh_corner(r, &r->mesh->face, (int32_t)r->mesh->vertices - 1)) {
      return false;
    }
  }
  return take(r, "endloop") && take(r, "endfacet") &&
         sg_mesh_end(r, &r->mesh->face, s);
}

/* What follows the solid's own name in the line of its end may be the comment
 * that other formats have (put_precision()). */
static void
read_end(sg_mesh_reader *r, const sg_word *name)
{
  sg_word rest = sg_word_rest(r);
  const char *after = rest.text + name->n, *end = rest.text + rest.n;

  if (rest.n > name->n && !memcmp(rest.text, name->text, name->n)) {
    sg_mesh_precision(r, name->n > 0 ? after : after - 1, end);
  }
}

static bool
read_solid(sg_mesh_reader *r)
{
  sg_word name = sg_word_rest(r), w;
  int32_t s = sg_mesh_segment(r, &name);

  while (s >= 0) {
    if (!sg_word_next(r, &w)) {
      return sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "facet or endsolid");
    }
    if (sg_word_is(&w, "endsolid")) {
      read_end(r, &name);
      return true;
    }
    if (!sg_word_is(&w, "facet")) {
      return sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "facet or endsolid");
    }
    if (!read_facet(r, s)) {
      return false;
    }
  }
  return false;
}

static bool
read_text(sg_mesh_reader *r)
{
  sg_word w;

  while (sg_word_next(r, &w)) {
    if (!sg_word_is(&w, "solid")) {
      return sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "solid");
    }
    if (!read_solid(r)) {
      return false;
    }
  }
  return true;
}

bool
sg_stl_read(sg_mesh_reader *r)
{
  size_t n = (size_t)(r->end - r->start);

  if (sg_stl_is_binary(r->start, n)) {
    return read_binary(r);
  }
  if (!starts_as_text(r->start, n) && memchr(r->start, '\0', n)) {
    return sg_mesh_fail_byte(r, SG_MESH_TRUNCATED, n, "bytes of header",
                             (int64_t)n, HEADER);
  }
  return read_text(r);
}
