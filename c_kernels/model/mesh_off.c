/* mesh_off.c -- reads OFF: [ST][C][N]OFF, counts, one vertex a line, then one
 * face a line; whatever follows on those lines (colours ...) is skipped.
 */
#include "mesh_private.h"

#include <string.h>

/* The shortest vertex is "0 0 0\n", the shortest face "3 0 1 2\n". */
enum { VERTEX_BYTES = 6, FACE_BYTES = 4 };

/* The keyword, which may be missing. */
static bool
read_keyword(sg_mesh_reader *r)
{
  sg_mesh_reader before = *r;
  sg_word w;

  sg_word_next(r, &w);
  if (w.n < 3 || memcmp(w.text + w.n - 3, "OFF", 3) != 0) {
    int64_t number;
    if (!sg_word_integer(&w, &number)) {
      return sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "OFF");
    }
    *r = before;
    return true;
  }
  for (size_t i = 0; i + 3 < w.n; i++) {
    if (!strchr("STCN", w.text[i])) {
      return sg_mesh_fail(r, SG_MESH_UNSUPPORTED, &w, NULL);
    }
  }
  before = *r;
  if (sg_word_here(r, &w) && sg_word_is(&w, "BINARY")) {
    return sg_mesh_fail(r, SG_MESH_UNSUPPORTED, &w, NULL);
  }
  *r = before;
  return true;
}

typedef struct sg_off_count {
  const char *what;
  sg_word word;
  int64_t count;
} sg_off_count;

static bool
read_count(sg_mesh_reader *r, sg_off_count *out)
{
  sg_word *w = &out->word;

  if (!sg_word_next(r, w) || !sg_word_integer(w, &out->count) ||
      out->count < 0) {
    return sg_mesh_fail(r, SG_MESH_BAD_COUNT, w, out->what);
  }
  return out->count <= INT32_MAX ||
         sg_mesh_fail(r, SG_MESH_TOO_LARGE, w, out->what);
}

/* False if what follows is too short for so many things of `bytes` each. */
static bool
check_count(sg_mesh_reader *r, const sg_off_count *n, size_t bytes)
{
  int64_t present = (int64_t)((size_t)(r->end - r->at) / bytes + 1);

  return n->count <= present ||
         sg_mesh_fail_numbers(r, SG_MESH_TRUNCATED, &n->word, n->what, present,
                              n->count);
}

static bool
read_vertex(sg_mesh_reader *r, int64_t done, int64_t all)
{
  double p[3];
  sg_word w;

  for (int k = 0; k < 3; k++) {
    if (!(k ? sg_word_here(r, &w) : sg_word_next(r, &w))) {
      return w.text == r->end
                 ? sg_mesh_fail_numbers(r, SG_MESH_TRUNCATED, &w, "vertices",
                                        done, all)
                 : sg_mesh_fail(r, SG_MESH_EXPECTED, &w, "a coordinate");
    }
    if (!sg_mesh_coordinate(r, &w, &p[k])) {
      return false;
    }
  }
  sg_word_skip_line(r);
  return sg_mesh_vertex(r, p);
}

/* A face; of two corners a curve, of one a point, which is passed over. */
static bool
read_face(sg_mesh_reader *r, int64_t done, int64_t all, int32_t s)
{
  sg_word w;
  int64_t n;
  size_t line;

  if (!sg_word_next(r, &w)) {
    return sg_mesh_fail_numbers(r, SG_MESH_TRUNCATED, &w, "faces", done, all);
  }
  line = w.line;
  if (!sg_word_integer(&w, &n) || n < 1 || n > INT32_MAX) {
    return sg_mesh_fail(r, SG_MESH_BAD_COUNT, &w, "corners");
  }
  sg_mesh_lists *lists = n == 2 ? &r->mesh->curve : &r->mesh->face;
  for (int64_t i = 0; i < n; i++) {
    int32_t v;
    if (!sg_word_next(r, &w)) {
      return sg_mesh_fail_numbers(r, SG_MESH_TRUNCATED, &w, "corners", i, n);
    }
    if (!sg_mesh_index(r, &w, r->mesh->vertices, &v) ||
        (n > 1 && !sg_mesh_corner(r, lists, v))) {
      return false;
    }
  }
  sg_word_skip_line(r);
  if (n == 1) {
    sg_mesh_ignore(r, line);
    return true;
  }
  return sg_mesh_end(r, lists, s);
}

bool
sg_off_read(sg_mesh_reader *r)
{
  sg_off_count vertices = {.what = "vertices"}, faces = {.what = "faces"};
  sg_word w;

  r->hash = true;
  if (!read_keyword(r) || !read_count(r, &vertices) || !read_count(r, &faces) ||
      !check_count(r, &vertices, VERTEX_BYTES) ||
      !check_count(r, &faces, FACE_BYTES)) {
    return false;
  }
  sg_word_skip_line(r); /* the count of edges, if any */
  int32_t s = sg_mesh_segment(r, NULL);
  for (int64_t i = 0; i < vertices.count; i++) {
    if (s < 0 || !read_vertex(r, i, vertices.count)) {
      return false;
    }
  }
  for (int64_t i = 0; i < faces.count; i++) {
    if (s < 0 || !read_face(r, i, faces.count, s)) {
      return false;
    }
  }
  if (sg_word_next(r, &w)) {
    r->mesh->trailing = (size_t)(r->end - w.text);
  }
  return true;
}
