/* mesh_obj.c -- reads OBJ: v, f (v, v/vt, v//vn, v/vt/vn, negative numbers
 * count from the last vertex back), l as curves, o and g as segments.
 *
 * If the file has an `o`, objects part the segments and groups inside them do
 * not; else groups do. A name met again goes on with its segment. Vertices are
 * common to all segments and may be used before the line that gives them.
 * Lines of materials, normals, textures and free-form surfaces are skipped.
 */
#include "mesh_private.h"
#include "rows/key_table.h"

#include <stdlib.h>
#include <string.h>

typedef struct sg_obj {
  sg_mesh_reader *r;
  size_t vertices;    /* in the whole file */
  bool by_object;     /* there is an `o` */
  int32_t segment;    /* the current one, -1 before the first */
  sg_key_table names; /* hashes of names, to segments */
} sg_obj;

/* Names ------------------------------------------------------------------ */

static uint64_t
hash_name(const char *text, size_t n)
{
  uint64_t h = 14695981039346656037u;

  for (size_t i = 0; i < n; i++) {
    h = (h ^ (unsigned char)text[i]) * 1099511628211u;
  }
  return h ^ h >> 29;
}

/* Where the segment of a name stands; null: no memory. Names that have the same
 * hash differ in the last word of their keys. */
static uint32_t *
place_of_name(sg_obj *obj, const char *text, size_t n)
{
  uint64_t h = hash_name(text, n);
  uint32_t key[3] = {(uint32_t)h, (uint32_t)(h >> 32), 0};

  for (;; key[2]++) {
    uint32_t *at = sg_key_table_put(&obj->names, key);

    if (!at || *at == SG_NO_KEY) {
      return at;
    }
    const char *name = obj->r->mesh->name[*at];

    if (name ? strlen(name) == n && !memcmp(name, text, n) : n == 0) {
      return at;
    }
  }
}

static bool
start_segment(sg_obj *obj, const sg_word *name)
{
  /* A name with a zero byte is cut there, as C strings are. */
  size_t n = strnlen(name->text, name->n);
  sg_word cut = {name->text, n, name->line};

  uint32_t *place = place_of_name(obj, cut.text, n);

  if (!place) {
    return sg_mesh_fail(obj->r, SG_MESH_NO_MEMORY, NULL, NULL);
  }
  if (*place == SG_NO_KEY) {
    int32_t s = sg_mesh_segment(obj->r, &cut);
    if (s < 0) {
      return false;
    }
    *place = (uint32_t)s;
  }
  obj->segment = (int32_t)*place;
  return true;
}

/* Lines ------------------------------------------------------------------ */

static bool
read_v(sg_obj *obj)
{
  sg_mesh_reader *r = obj->r;
  double p[3];
  sg_word w;

  for (int k = 0; k < 3; k++) {
    if (!sg_word_here(r, &w)) {
      return sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "a coordinate");
    }
    if (!sg_mesh_coordinate(r, &w, &p[k])) {
      return false;
    }
  }
  return sg_mesh_vertex(r, p);
}

/* True if the rest of a corner, from its first slash, is well formed. */
static bool
is_tail(const char *at, const char *end)
{
  for (int slashes = 0; at < end; at++) {
    if (*at == '/') {
      if (++slashes > 2) {
        return false;
      }
    } else if (*at != '-' && (*at < '0' || *at > '9')) {
      return false;
    }
  }
  return true;
}

static bool
read_corner(sg_obj *obj, const sg_word *w, int32_t *out)
{
  const char *slash = memchr(w->text, '/', w->n);
  sg_word number = {w->text, slash ? (size_t)(slash - w->text) : w->n, w->line};
  int64_t i, last = (int64_t)obj->r->mesh->vertices;

  if (!sg_word_integer(&number, &i) ||
      (slash && !is_tail(slash, w->text + w->n))) {
    return sg_mesh_fail(obj->r, SG_MESH_EXPECTED, w, "a vertex number");
  }
  int64_t at = i < 0 ? last + i : i - 1;
  if (i == 0 || at < 0 || at >= (int64_t)obj->vertices) {
    return sg_mesh_fail_numbers(obj->r, SG_MESH_BAD_INDEX, w, "1", i,
                                i < 0 ? last : (int64_t)obj->vertices);
  }
  *out = (int32_t)at;
  return true;
}

static bool
read_list(sg_obj *obj, sg_mesh_lists *lists, int64_t least)
{
  static const sg_word unnamed = {"", 0, 0};
  int64_t n = 0;
  sg_word w;

  if (obj->segment < 0 && !start_segment(obj, &unnamed)) {
    return false;
  }
  for (; sg_word_here(obj->r, &w); n++) {
    int32_t v = 0;
    if (!read_corner(obj, &w, &v) || !sg_mesh_corner(obj->r, lists, v)) {
      return false;
    }
  }
  if (n < least) {
    return sg_mesh_fail_numbers(obj->r, SG_MESH_SHORT_FACE, &w, NULL, n, least);
  }
  return sg_mesh_end(obj->r, lists, obj->segment);
}

/* What is known and passed over in silence. */
static bool
is_skipped(const sg_word *w)
{
  static const char *const words[] = {
      "vn",       "vt",         "vp",        "s",   "usemtl", "mtllib",
      "usemap",   "maplib",     "mg",        "lod", "bevel",  "c_interp",
      "d_interp", "shadow_obj", "trace_obj", "g",   "p"};

  for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
    if (sg_word_is(w, words[i])) {
      return true;
    }
  }
  return false;
}

static bool
read_line(sg_obj *obj, const sg_word *w)
{
  sg_mesh_reader *r = obj->r;

  if (sg_word_is(w, "v")) {
    return read_v(obj);
  }
  if (sg_word_is(w, "f") || sg_word_is(w, "fo")) {
    return read_list(obj, &r->mesh->face, 3);
  }
  if (sg_word_is(w, "l")) {
    return read_list(obj, &r->mesh->curve, 2);
  }
  if (sg_word_is(w, obj->by_object ? "o" : "g")) {
    sg_word name = sg_word_rest(r);
    return start_segment(obj, &name);
  }
  if (!is_skipped(w)) {
    sg_mesh_ignore(r, w->line);
  }
  return true;
}

/* How many vertices there are, and whether there are objects. */
static bool
survey(sg_obj *obj)
{
  sg_mesh_reader r = *obj->r;
  sg_word w;

  while (sg_word_next(&r, &w)) {
    if (!sg_mesh_tick(&r)) {
      return false;
    }
    obj->vertices += sg_word_is(&w, "v");
    obj->by_object |= sg_word_is(&w, "o");
    sg_word_skip_line(&r);
  }
  return obj->vertices <= INT32_MAX ||
         sg_mesh_fail(obj->r, SG_MESH_TOO_LARGE, NULL, "vertices");
}

bool
sg_obj_read(sg_mesh_reader *r)
{
  sg_obj obj = {.names = {.words = 3}, .r = r, .segment = -1};
  sg_word w;

  r->hash = r->backslash = true;
  bool good = survey(&obj);
  while (good && sg_word_next(r, &w)) {
    good = sg_mesh_tick(r) && read_line(&obj, &w);
    sg_word_skip_line(r);
  }
  sg_key_table_clear(&obj.names);
  return good;
}
