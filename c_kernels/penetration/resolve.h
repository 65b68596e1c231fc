/* resolve.h -- making things touch that were meant to touch.
 *
 * Layer: kernel. Before the exact arrangement, contacts that rounding has
 * opened (contact.h) are closed: what lies within `reach` becomes one SHARED
 * POINT, with the same doubles in every segment that has it. In a segment it
 * is a vertex (which moves there), or a new vertex on an edge (which is
 * divided) or inside a polygon. Pieces of edges between two shared points that
 * lie in a polygon of another segment enter it as SEAMS. Then the polygons are
 * triangulated anew, and where two of them lie on each other they get the same
 * triangles. So contacts are shared corners, edges and triangles afterwards,
 * and the exact arrangement needs no tolerance.
 *
 *   sg_resolve_init(&r, reach, is_real, data, cancel);
 *   for all pairs with boxes within reach:  sg_resolve_see(&r, &a, &b);
 *   if (sg_resolve_is_needed(&r)) {
 *     for the same pairs:                   sg_resolve_pair(&r, &a, &b);
 *     for crossings near third segments:    sg_resolve_crossing(&r, i, &c);
 *     sg_resolve_finish(&r);                places, splits, insides, seams
 *   }
 *   sg_resolve_clear(&r);
 *
 * Contacts that are exact in all segments that are connected are left alone.
 * Inexact except for the contacts' own exactness; deterministic.
 */
#ifndef SG_RESOLVE_H
#define SG_RESOLVE_H

#include "engine/cancel.h"
#include "engine/list.h"
#include "join/contact.h"
#include "rows/key_table.h"

/* Whether side `side` (from corner `side` on) of a leaf triangle is a real
 * edge, and no chord: 1 or 0; -1: no memory. */
typedef int sg_is_real_side(void *data, uint32_t triangle, int side);

/* A leaf triangle; `triangle` is the caller's number of it. */
typedef struct sg_resolve_leaf {
  uint32_t triangle;
  int32_t s, p, v[3];
  double at[3][3];
} sg_resolve_leaf;

/* A vertex, or a point where two edges of different segments pass. */
typedef struct sg_resolve_node {
  int32_t s, v;       /* v 0: two edges */
  int32_t line[2][3]; /* these: S, V1, V2, smaller segment first */
  uint32_t leaf[2];   /* triangles that have them */
  double at[3];
  double side;         /* the shortest of the triangles that touch there */
  double reach;        /* the farthest of the pairs that have it */
  double rounding;     /* of doubles, the largest of these pairs */
  double gap;          /* the widest there that no source explains */
  uint32_t root, next; /* of its cluster: union-find, ring of members */
  uint32_t point;      /* number of the shared point, when finished */
} sg_resolve_node;

/* A node on an edge (p 0) or face (v[0] 0) of segment s. */
typedef struct sg_resolve_touch {
  uint32_t node;
  int32_t s, v[2], p;
  double apart, along; /* along: 0 at v[0], 1 at v[1] */
  double step[3];      /* how along grows with the coordinates */
} sg_resolve_touch;

/* A shared point in one segment: vertex v, or still to be made on an edge or
 * in a polygon. `name` is its vertex id there; the caller names new ones. */
typedef struct sg_resolve_place {
  uint32_t point;
  int32_t s, v, edge[2], p; /* v, or edge, or p; the others 0 */
  double along;
  int32_t name;
} sg_resolve_place;

typedef struct sg_resolve_point {
  double at[3];
  uint32_t node; /* the first of its members by (s, v), or of its crossings */
} sg_resolve_point;

/* An edge of segment s, v[0] < v[1], and place[first .. first + n - 1] on it,
 * from v[0] to v[1]. */
typedef struct sg_resolve_split {
  int32_t s, v[2];
  size_t first, n;
} sg_resolve_split;

/* Points a and b bound a piece of an edge of another segment in polygon p. */
typedef struct sg_resolve_seam {
  int32_t s, p;
  uint32_t a, b;
} sg_resolve_seam;

/* Node or point n is within reach of polygon p. */
typedef struct sg_resolve_near {
  uint32_t n;
  int32_t s, p;
} sg_resolve_near;

typedef enum sg_resolved {
  SG_RESOLVED,
  SG_UNRESOLVED, /* a polygon cannot be triangulated with its points */
  SG_RESOLVE_STOPPED,
  SG_RESOLVE_NO_MEMORY
} sg_resolved;

typedef struct sg_resolve {
  double reach;     /* the farthest */
  double here;      /* of the pair in hand, no farther: the caller's to set */
  double rounding;  /* of the doubles of this pair: the caller's to set, too */
  double explained; /* its sources were rounded so, no less than rounding: the
                       caller's to set, too */
  double side;      /* the shortest of the pair in hand */
  const sg_cancel *cancel;
  unsigned steps; /* since cancel was asked */
  bool stopped;   /* by cancel */
  sg_is_real_side *is_real;
  void *data;
  sg_key_table segment;           /* s -> number */
  SG_LIST_OF(uint32_t) group;     /* [segments]: those in contact: union-find */
  SG_LIST_OF(bool) inexact;       /* [segments], at the root: to be resolved */
  SG_LIST_OF(uint8_t) contacts;   /* [pairs seen]: how many each has */
  SG_LIST_OF(sg_contact) contact; /* theirs */
  size_t pairs_kept, contacts_kept; /* of those, by sg_resolve_seen_pair() */
  SG_LIST_OF(sg_resolve_node) node;
  SG_LIST_OF(sg_resolve_touch) touch;
  SG_LIST_OF(sg_resolve_near) near;
  struct {
    struct sg_resolve_join {
      uint32_t a, b;
      double apart;
    } * item;
    size_t n, room;
  } join;                            /* vertices within reach */
  SG_LIST_OF(sg_resolve_split) edge; /* real edges of what touches; n = 0 */
  sg_key_table known;                /* S, V1, V2 -> real 1, chord 0 */
  uint8_t *sided; /* [side_room]: all sides of a triangle are known */
  size_t side_room;
  sg_key_table node_number; /* S, V, 0, 0, 0, 0; or both lines */
  sg_key_table seen;        /* node, S, V1, V2 or P: touched */
  /* when finished */
  SG_LIST_OF(sg_resolve_point) point;
  SG_LIST_OF(sg_resolve_place) place; /* vertices first, edges, insides */
  sg_key_table place_number;          /* point, S */
  SG_LIST_OF(sg_resolve_split) split; /* by (s, v) */
  SG_LIST_OF(sg_resolve_seam) seam;   /* by (s, p, a, b) */
  size_t first_inside;                /* place[..] from here: by (s, p) */
  const sg_resolve_node *wide; /* a vertex too far from its point, or null */
} sg_resolve;

/* `cancel` may be null; it is asked in sg_resolve_finish() only. */
void sg_resolve_init(sg_resolve *r, double reach, sg_is_real_side *is_real,
                     void *data, const sg_cancel *cancel);
void sg_resolve_clear(sg_resolve *r);

/* Notes that two segments touch exactly somewhere. False: no memory. */
bool sg_resolve_touch_exactly(sg_resolve *r, int32_t s, int32_t other);
/* Looks whether a pair touches inexactly. False: no memory. */
bool sg_resolve_see(sg_resolve *r, const sg_resolve_leaf *a,
                    const sg_resolve_leaf *b);
/* Whether any pair seen did. */
bool sg_resolve_is_needed(const sg_resolve *r);
/* Keeps the contacts of a pair. False: no memory. */
bool sg_resolve_pair(sg_resolve *r, const sg_resolve_leaf *a,
                     const sg_resolve_leaf *b);
/* The same for a pair that was seen, all of them in the same order: its
 * contacts need not be found again. */
bool sg_resolve_seen_pair(sg_resolve *r, const sg_resolve_leaf *a,
                          const sg_resolve_leaf *b);
/* Keeps the contact of node i, where two edges pass, with a leaf of a third
 * segment (of any other segment: nothing is kept). False: no memory. */
bool sg_resolve_crossing(sg_resolve *r, uint32_t i,
                         const sg_resolve_leaf *leaf);
/* Makes the points and what follows from them; never SG_UNRESOLVED. With
 * r->wide, nothing should be changed. */
sg_resolved sg_resolve_finish(sg_resolve *r);

/* Where a point is in segment s; null: nowhere. */
sg_resolve_place *sg_resolve_place_of(const sg_resolve *r, uint32_t point,
                                      int32_t s);
/* The point that vertex v of segment s is, SG_NO_KEY: none. */
uint32_t sg_resolve_point_of(const sg_resolve *r, int32_t s, int32_t v);
/* The points on an edge (either way round); null: none. */
const sg_resolve_split *sg_resolve_split_of(const sg_resolve *r, int32_t s,
                                            int32_t v1, int32_t v2);

#endif
