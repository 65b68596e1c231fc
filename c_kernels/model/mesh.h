/* mesh.h -- mesh files in memory: STL, OFF, OBJ and PLY, in and out.
 *
 * Layer: kernel. Buffers in, buffers out: no files, no store, no Prolog.
 *
 * Coordinates are doubles, exactly what the file says. Polygons stay polygons.
 * A face is a list of vertex numbers counter-clockwise from outside, its last
 * vertex joined to its first; a curve is a list that is not closed.
 *
 * Policy, the same for all formats:
 *  - NaN and infinite coordinates are refused; normals, colours and textures
 *    are skipped (the normal comes from the loop).
 *  - Vertices with equal coordinates become one where the format repeats them:
 *    always in STL, elsewhere if no two faces share any vertex ("soup").
 *  - Corners that repeat their neighbour in a face are dropped; a face left
 *    with fewer than three corners is dropped whole and counted. (What it
 *    joined stays joined: its edges would have paired with each other.) Faces
 *    of three different corners stay, even without area.
 *  - Counts in headers are checked against the bytes that are there before
 *    anything is allocated.
 */
#ifndef SG_MESH_H
#define SG_MESH_H

#include "engine/cancel.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum sg_mesh_format {
  SG_MESH_UNKNOWN,
  SG_MESH_STL,        /* read: text or binary, by content; written: text */
  SG_MESH_STL_BINARY, /* write only */
  SG_MESH_OFF,
  SG_MESH_OBJ,
  SG_MESH_PLY,       /* read: as the header says; written: text */
  SG_MESH_PLY_BINARY /* write only: little endian, doubles */
} sg_mesh_format;

/* What can be wrong. The text names what was found, `wanted` what should have
 * been there; got and limit are numbers as said here. */
typedef enum sg_mesh_code {
  SG_MESH_FINE,
  SG_MESH_STOPPED, /* the cancellation said so */
  SG_MESH_NO_MEMORY,
  SG_MESH_EMPTY_FILE,
  SG_MESH_NO_FACES, /* neither a polygon nor a curve */
  SG_MESH_UNKNOWN_FORMAT,
  SG_MESH_UNSUPPORTED,  /* text: a kind of the format that is not read */
  SG_MESH_EXPECTED,     /* wanted, text ("" at the end of the file) */
  SG_MESH_BAD_NUMBER,   /* text */
  SG_MESH_NOT_FINITE,   /* text */
  SG_MESH_TOO_FAR,      /* text: beyond SG_MESH_FARTHEST */
  SG_MESH_BAD_INDEX,    /* got; allowed are 1 or 0 .. limit, see wanted */
  SG_MESH_BAD_COUNT,    /* text; wanted says of what */
  SG_MESH_TRUNCATED,    /* wanted: what was promised; got bytes or items are
                           there, limit are needed */
  SG_MESH_SHORT_FACE,   /* got corners, 3 are needed */
  SG_MESH_TOO_LARGE,    /* more than 2^31 - 1 vertices or edges */
  SG_MESH_NO_PROPERTY,  /* PLY: wanted is missing in element text */
  SG_MESH_WRITE_FAILED, /* the sink said so */
  SG_MESH_CODES
} sg_mesh_code;

/* The name of a code as Prolog knows it, such as "bad_number". */
extern const char *const sg_mesh_code_name[SG_MESH_CODES];

enum { SG_MESH_TEXT = 48 };

/* No coordinate is greater: products of three still fit a double. */
#define SG_MESH_FARTHEST 1e90

typedef struct sg_mesh_error {
  sg_mesh_code code;
  size_t line;   /* from 1; 0 in binary data */
  size_t column; /* from 1, in bytes */
  size_t byte;   /* from 0 */
  int64_t got, limit;
  const char *wanted;      /* static text, "" if there is none */
  char text[SG_MESH_TEXT]; /* printable ASCII, cut if long */
} sg_mesh_error;

/* Lists of vertex numbers (from 0): list i is
 * corner[start[i]] .. corner[start[i + 1] - 1], in part segment[i]. */
typedef struct sg_mesh_lists {
  size_t count;
  size_t corners;   /* start[count], while no list is open */
  uint32_t *start;  /* [count + 1], null if there is no list */
  int32_t *corner;  /* [corners] */
  int32_t *segment; /* [count] */
  size_t start_room, corner_room, room; /* private */
} sg_mesh_lists;

typedef struct sg_mesh {
  size_t vertices;
  double (*vertex)[3];
  sg_mesh_lists face, curve;
  size_t segments; /* each has a face or a curve */
  char **name;     /* [segments], UTF-8 as in the file, null if unnamed */

  double grain; /* a unit in the last place of the source, model units; 0
                   if it is exact (doubles, or fewer than 6 digits) */
  /* What was passed over. */
  size_t degenerate;   /* faces dropped */
  size_t repeated;     /* corners dropped from faces that stayed */
  size_t welded;       /* vertices joined to an equal one */
  size_t ignored;      /* lines or elements of unknown kind, points */
  size_t ignored_line; /* the first of them, 0 if there is none */
  size_t trailing;     /* bytes behind the data */

  size_t vertex_room, name_room; /* private */
} sg_mesh;

typedef enum sg_mesh_weld {
  SG_WELD_AUTO,
  SG_WELD_ALL,
  SG_WELD_NONE
} sg_mesh_weld;

typedef struct sg_mesh_options {
  sg_mesh_weld weld;       /* AUTO: the policy above */
  bool one_segment;        /* do not part by names */
  const sg_cancel *cancel; /* null: never stops */
} sg_mesh_options;

/* The format that the bytes are in, UNKNOWN if they look like none. */
sg_mesh_format sg_mesh_detect(const char *bytes, size_t n);

/* Reads n bytes as `format` (UNKNOWN: what they look like).
 *
 * Returns: true, *out filled; sg_mesh_clear() it. False: *error says why and
 *          *out is empty.
 * Cost:    linear; memory at most a constant times n.
 */
bool sg_mesh_read(sg_mesh_format format, const char *bytes, size_t n,
                  const sg_mesh_options *options, sg_mesh *out,
                  sg_mesh_error *error);

void sg_mesh_clear(sg_mesh *mesh);

/* Where a writer puts its bytes; false: it could not. */
typedef struct sg_mesh_sink {
  bool (*write)(void *data, const char *bytes, size_t n);
  void *data;
} sg_mesh_sink;

/* Writes `mesh`. Text gives every coordinate the shortest decimal that reads
 * back to it; binary STL rounds to float32. STL takes triangles only (others:
 * SG_MESH_UNSUPPORTED) and has no curves; neither has OFF, whose faces of two
 * corners stand for them. Segments are kept by STL text and OBJ. */
bool sg_mesh_write(sg_mesh_format format, const sg_mesh *mesh,
                   const sg_mesh_sink *sink, const sg_cancel *cancel,
                   sg_mesh_error *error);

/* Building a mesh by hand. All false: no memory, or too large. */
bool sg_mesh_add_vertex(sg_mesh *mesh, const double xyz[3]);
bool sg_mesh_add_corner(sg_mesh_lists *lists, int32_t vertex);
bool sg_mesh_end_list(sg_mesh_lists *lists, int32_t segment);
/* The number of a new segment, or -1. `name` may be null. */
int32_t sg_mesh_add_segment(sg_mesh *mesh, const char *name, size_t n);

#endif
