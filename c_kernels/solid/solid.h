/* solid.h -- a boundary under way: chosen pieces, until they are rows.
 *
 * Layer: kernel. Pieces of the polygons of some segments, as triangles. The
 * triangles of one face stand together; its polygon is what is left when the
 * edges between two triangles of the face are dropped: holes and islands need
 * no special form. Counter-clockwise seen from outside.
 *
 * Vertices are known by number: triangles that share one have the same number.
 * The first `plain` of them were vertices of a segment, the others were made
 * by cuts and have a name as in origin/3. Places are rounded once, and nothing
 * is decided by them here.
 *
 * Owner: the solid owns its arrays; sg_solid_clear() frees them.
 */
#ifndef SG_SOLID_H
#define SG_SOLID_H

#include "thread_pool.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A vertex, and the vertex v of segment s that it was (made: the first segment
 * whose cut made it, and v = 0). */
typedef struct sg_solid_vertex {
  double at[3]; /* model units */
  int32_t s, v;
} sg_solid_vertex;

/* A face: a piece, or all, of polygon p of segment s. After merging, that of
 * its largest part; the parts are then listed by the solid. */
typedef struct sg_solid_face {
  int32_t s, p;
  bool reversed;  /* it looks the other way than the polygon */
  uint32_t first; /* its triangles: first .. first + n - 1, n > 0 */
  uint32_t n;
} sg_solid_face;

typedef struct sg_solid {
  sg_solid_vertex *vertex; /* [vertices] */
  size_t vertices, plain;
  const uint32_t **origin; /* [vertices - plain]: coded terms (term.h), in
                              origin_words; or null */
  uint32_t *origin_words;
  uint32_t (*triangle)[3]; /* [triangles] */
  uint8_t *auxiliary;      /* [triangles]: bit k: if the edge from corner k to
                              the next ends its face, it is auxiliary (Et 0) */
  size_t triangles;
  bool closed;         /* each edge is known to run as often back as there */
  sg_solid_face *face; /* [faces] */
  size_t faces;
  /* What faces came from, beside face[].s and .p: sorted by face. */
  struct sg_solid_part {
    uint32_t face;
    int32_t s, p;
    bool reversed;
  } * part; /* [parts] */
  size_t parts;
} sg_solid;

void sg_solid_clear(sg_solid *solid);
/* Of one that is itself of malloc(), or null. */
void sg_solid_free(sg_solid *solid);

/* Whether each edge runs as often back as there: it bounds something. Where
 * that is not known, by a fingerprint: wrong once in 2^64. */
bool sg_solid_is_closed(const sg_solid *solid, sg_pool *pool);

#endif
