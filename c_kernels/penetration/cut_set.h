/* cut_set.h -- all cuts of one penetration, until they are in the polygons.
 *
 * Layer: kernel. The way of a cut:
 *
 *   sg_cut_set_enter()   a pair of leaf triangles leaves its cut, with points
 *                        known by their features and the real edges they split
 *   sg_cut_set_seal()    real edges are ordered, cuts that run along them are
 *                        divided where they are, equal ones become one PIECE
 *   sg_cut_set_joint(), sg_cut_set_join()   straight runs become one piece
 *   sg_cut_set_settle()  now the pieces are the lines, if polygons are flat
 *   sg_cut_set_group()   the polygons that they enter, and whose edges split
 *   sg_cut_set_split()   while pieces enter polygons, some meet others
 *   sg_cut_set_agree()   what was split in one polygon is split everywhere
 *
 * A piece belongs to two segments, smaller number first. In each it runs
 * through the face of a polygon (it will be a seam there) or along a real
 * edge (it is there already). A segment may be cut by itself: then a piece
 * belongs twice to it, in different polygons, an edge first, else the smaller
 * polygon. What its triangles share as neighbours is no cut. A contact is a
 * point that two segments have in common and no piece: it splits the real edges
 * it lies on and enters nothing else.
 *
 * Faces, not polygons, make lines: where two polygons lie on each other, what
 * is inside the face of both is none (cut_face.c).
 */
#ifndef SG_CUT_SET_H
#define SG_CUT_SET_H

#include "cut_point.h"
#include "engine/cancel.h"
#include "join/cut.h"

typedef struct sg_cut_piece {
  int32_t s[2], p[2];   /* where along an edge: the smaller polygon met */
  uint32_t edge[2];     /* the split edge it runs along; SG_NO_KEY: none */
  uint32_t triangle[2]; /* leaf triangles that made it */
  uint32_t a, b;        /* points, a != b */
  bool live;
} sg_cut_piece;

/* A contact in a point alone: no piece of the two segments ends there. */
typedef struct sg_cut_contact {
  int32_t s[2], p[2]; /* the smallest polygons that have the point */
  uint32_t point;
} sg_cut_contact;

/* A point that two triangles in one plane have in common, and no more. */
typedef struct sg_cut_flat_touch {
  uint32_t t[2];
  sg_cut_end end;
} sg_cut_flat_touch;

/* A real edge and the points on it, in order from place.a to place.b once
 * sealed. Of a curve: place.a, place.b by number, not by direction. */
typedef struct sg_split_edge {
  sg_place place;
  int32_t s;
  bool late; /* got a point by sg_cut_set_agree() */
  size_t n, room;
  uint32_t *point;
} sg_split_edge;

/* A polygon that pieces enter, or whose edges are split. */
typedef struct sg_cut_polygon {
  int32_t s, p;
  size_t first, n; /* its pieces: entering[first .. first + n - 1] */
} sg_cut_polygon;

/* Whether edge 0..2 of a leaf triangle is an edge of its polygon, of real
 * type, or a fold, a chord of a polygon that is not flat; and no other chord.
 * 1, 0, or -1: no memory. What is said of real edges here goes for folds, too.
 */
typedef int sg_is_real(void *data, uint32_t triangle, int edge);

typedef struct sg_cut_set {
  sg_cut_model model;
  sg_cut_points points;
  sg_is_real *is_real;
  void *data;
  sg_cut_piece *cut;   /* as entered */
  sg_cut_piece *piece; /* as sealed, split, joined */
  size_t cuts, cut_room, pieces, piece_room;
  sg_cut_contact *contact; /* as entered; once sealed those alone, by s, p */
  size_t contacts, contact_room;
  sg_cut_flat_touch *flat_touch; /* as entered; none once sealed */
  size_t flat_touches, flat_touch_room;
  bool of_faces;             /* else an edge inside a face is as any other */
  double flat_within;        /* what is off by no more is one face */
  sg_key_table at_place;     /* coordinates: the first vertex there */
  uint32_t *place_of;        /* [placed]: of a vertex, this one */
  size_t placed, place_room; /* vertices that are numbered so */
  sg_key_table side_of;      /* (a, b), a < b, of these: the last side there */
  sg_key_table inside;       /* cut_face.c says of what */
  uint32_t *next_side;       /* [3 * sided]: the one before; SG_NO_KEY */
  size_t sided, side_room;   /* triangles whose sides are filed */
  sg_key_table piece_number; /* cut_set.c says of what */
  sg_split_edge *edge;
  size_t edges, edge_room;
  sg_key_table edge_number; /* of (place.a, place.b) */
  sg_key_table late;        /* (a, b), a < b: a point between them */
  sg_cut_polygon *polygon;  /* sorted */
  uint32_t *entering;       /* pieces */
  size_t polygons, polygon_room;
  uint32_t (*at)[2]; /* [points.n]: two pieces there */
  uint32_t *degree;  /* [points.n] */
  bool *gone;        /* [points.n]: joined away */
  size_t linked;     /* how many points these three know */
} sg_cut_set;

void sg_cut_set_init(sg_cut_set *set, sg_is_real *is_real, void *data);
void sg_cut_set_clear(sg_cut_set *set);

/* Cuts triangle t1 by t2 (the smaller segment first; of one segment that is cut
 * by itself in any order) and keeps the pieces of positive length, and single
 * points as contacts. Triangles of one polygon do not cut each other: they
 * cover it, seen along its normal. Returns how many pieces, -1: no memory. */
int sg_cut_set_enter(sg_cut_set *set, uint32_t t1, uint32_t t2);

/* Cuts curve edge e by triangle t: the points are noted on the edge. Returns
 * how many, -1: no memory. PL-7. */
int sg_cut_set_enter_curve(sg_cut_set *set, uint32_t e, uint32_t t);

/* Orders the edges, makes the pieces and finds the contacts that are alone.
 * False, here and below where there is a cancellation: no memory, or stopped.
 * The set is then half done, and good for sg_cut_set_clear() alone. */
bool sg_cut_set_seal(sg_cut_set *set, const sg_cancel *cancel);

/* Notes a polygon whose edges are split (before sg_cut_set_group()). */
bool sg_cut_set_add_polygon(sg_cut_set *set, int32_t s, int32_t p);
/* Lists the polygons, each once, by (s, p), with the pieces entering it. */
bool sg_cut_set_group(sg_cut_set *set, const sg_cancel *cancel);
/* The listed polygon, null: it is not among them. */
sg_cut_polygon *sg_cut_set_polygon(const sg_cut_set *set, int32_t s, int32_t p);

/* Notes that point x lies between points a and b. False: no memory. */
bool sg_cut_set_split(sg_cut_set *set, uint32_t a, uint32_t b, uint32_t x);
/* A point that was noted between a and b; SG_NO_KEY: none. */
uint32_t sg_cut_set_between(const sg_cut_set *set, uint32_t a, uint32_t b);
/* Divides all pieces at the points noted between their ends. Real edges that
 * a divided piece runs along get the point, and are `late`: polygons that have
 * one of these may not be among those listed. */
bool sg_cut_set_agree(sg_cut_set *set, const sg_cancel *cancel);

/* Where two pieces cross in polygons of a third segment, or of one of their
 * own: the triangles or edges that carry them make the point. */
sg_made sg_cut_set_crossing(const sg_cut_set *set, const sg_cut_piece *k,
                            const sg_cut_piece *l);

/* Makes ready for joints, after sg_cut_set_seal() and sg_cut_set_agree(). */
bool sg_cut_set_link(sg_cut_set *set, const sg_cancel *cancel);
/* True if exactly two pieces end in `point`, both carried by the same two
 * polygons or edges (so they are in line), and no other real edge is there:
 * PL-9. k ends or starts there, and so does l. */
bool sg_cut_set_joint(const sg_cut_set *set, uint32_t point, uint32_t *k,
                      uint32_t *l);
/* True if the two pieces at a joint lie on one line exactly: along an edge, or
 * in triangles that are coplanar on both sides. A polygon that is flat only
 * within the tolerance has joints that are nearly straight. */
bool sg_cut_set_is_straight(const sg_cut_set *set, uint32_t k, uint32_t l);
/* Makes one piece of the two at a joint: k grows, l is no longer live. */
void sg_cut_set_join(sg_cut_set *set, uint32_t point);
/* After joints, before polygons: only living pieces are left, numbered anew in
 * the same order, and points that were joined away are no longer on edges.
 * Makes ready for joints. */
bool sg_cut_set_settle(sg_cut_set *set, const sg_cancel *cancel);

#endif
