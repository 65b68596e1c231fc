/* mesh_private.h -- what the mesh readers share: words of a text, errors.
 *
 * Layer: kernel. Every reader returns false with *r->error filled.
 */
#ifndef SG_MESH_PRIVATE_H
#define SG_MESH_PRIVATE_H

#include "mesh.h"

/* A word of a text file, and where it stands. */
typedef struct sg_word {
  const char *text;
  size_t n;
  size_t line;
} sg_word;

typedef struct sg_mesh_reader {
  const char *start, *at, *end;
  size_t line; /* of `at`, from 1 */
  const char *line_start;
  bool hash;      /* # starts a comment */
  bool backslash; /* \ at the end of a line continues it */
  int digits;     /* the most significant digits seen in a coordinate */
  double widest;  /* the largest coordinate that has so many */
  double single;  /* the largest coordinate of float32 */
  double stated;  /* a unit in the last place, as a comment says; or -1 */
  bool one_segment;
  sg_mesh_weld weld; /* what is asked */
  bool joined;       /* the reader has joined equal vertices */
  sg_mesh *mesh;
  sg_mesh_error *error;
  const sg_cancel *cancel;
  unsigned ticks;
} sg_mesh_reader;

/* Words. _next crosses lines, _here stays in this line; false: there is none.
 * A byte order mark at the start, blanks, tabs, CR and CRLF are all blank. */
bool sg_word_next(sg_mesh_reader *r, sg_word *out);
bool sg_word_here(sg_mesh_reader *r, sg_word *out);
void sg_word_skip_line(sg_mesh_reader *r);
/* The rest of this line without blanks at its ends. */
sg_word sg_word_rest(sg_mesh_reader *r);
/* True if the word is `text`, without regard to case. */
bool sg_word_is(const sg_word *w, const char *text);
/* The whole number that the word is, or false. */
bool sg_word_integer(const sg_word *w, int64_t *out);

/* Errors: all return false. */
bool sg_mesh_fail(sg_mesh_reader *r, sg_mesh_code code, const sg_word *at,
                  const char *wanted);
bool sg_mesh_fail_numbers(sg_mesh_reader *r, sg_mesh_code code,
                          const sg_word *at, const char *wanted, int64_t got,
                          int64_t limit);
bool sg_mesh_fail_byte(sg_mesh_reader *r, sg_mesh_code code, size_t byte,
                       const char *wanted, int64_t got, int64_t limit);
/* False if the cancellation wants to stop; call it once an item. */
bool sg_mesh_tick(sg_mesh_reader *r);

/* Notes how fine the source was, if the text of a comment says that. */
void sg_mesh_precision(sg_mesh_reader *r, const char *text, const char *end);

/* A coordinate (counted in r->digits), and an index that must be in
 * 0 .. limit - 1 after `base` is taken off. */
bool sg_mesh_coordinate(sg_mesh_reader *r, const sg_word *w, double *out);
bool sg_mesh_index(sg_mesh_reader *r, const sg_word *w, size_t limit,
                   int32_t *out);
bool sg_mesh_vertex(sg_mesh_reader *r, const double xyz[3]);
bool sg_mesh_corner(sg_mesh_reader *r, sg_mesh_lists *lists, int32_t vertex);
bool sg_mesh_end(sg_mesh_reader *r, sg_mesh_lists *lists, int32_t segment);
/* Room for so many lists and corners in all. False: no memory. */
bool sg_mesh_expect(sg_mesh_lists *lists, size_t count, size_t corners);
/* The new segment's number, -1 after a failure. */
int32_t sg_mesh_segment(sg_mesh_reader *r, const sg_word *name);
void sg_mesh_ignore(sg_mesh_reader *r, size_t line);

bool sg_stl_read(sg_mesh_reader *r);
bool sg_stl_is_binary(const char *bytes, size_t n);
bool sg_off_read(sg_mesh_reader *r);
bool sg_obj_read(sg_mesh_reader *r);
bool sg_ply_read(sg_mesh_reader *r);

/* Joins vertices of equal coordinates; `mesh->welded` counts them. */
bool sg_mesh_weld_vertices(sg_mesh *mesh, const sg_cancel *cancel,
                           bool *stopped);

#endif
