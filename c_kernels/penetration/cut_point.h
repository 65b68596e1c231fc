/* cut_point.h -- the points of a penetration, each one once.
 *
 * Layer: kernel. A point is first known by what made it: the pair of places
 * (vertex, edge or triangle of a segment) that hold it, or three triangles.
 * The same pair is the same point, without arithmetic. Points made in
 * different ways are one point when they are EXACTLY in one place: their
 * doubles are correctly rounded, so equal points meet in one bucket and are
 * compared as rationals there.
 *
 * A point has a name (the store's V) in every segment that it belongs to;
 * several where vertices of the segment are in its place.
 */
#ifndef SG_CUT_POINT_H
#define SG_CUT_POINT_H

#include "cut_model.h"
#include "number/exact.h"

typedef enum sg_place_kind {
  SG_AT_VERTEX, /* a: vertex number */
  SG_ON_EDGE,   /* a < b: vertex numbers */
  SG_ON_FACE    /* a: triangle number */
} sg_place_kind;

typedef struct sg_place {
  sg_place_kind kind;
  uint32_t a, b;
} sg_place;

/* What made a point: n places (1: a vertex; 2: where they meet; 3 triangles:
 * where their planes meet), by segment. */
typedef struct sg_made {
  int n;
  sg_place place[3];
} sg_made;

/* That a point belongs to segment s. */
typedef struct sg_seat {
  int32_t s;
  int32_t v; /* its name there, 0: none yet */
  bool edge; /* it is on a real edge there, and splits it */
  sg_place place;
  uint32_t next; /* seat of the same point, SG_NO_KEY: no more */
} sg_seat;

typedef struct sg_cut_point {
  sg_point at;
  sg_made made;
  uint32_t seat;       /* the first, SG_NO_KEY: none */
  uint32_t seats;      /* how many */
  uint32_t same_place; /* another point with the same doubles, SG_NO_KEY */
} sg_cut_point;

typedef struct sg_cut_points {
  const sg_cut_model *model;
  sg_cut_point *point;
  sg_seat *seat;
  size_t n, room, seats, seat_room;
  sg_key_table of_made;  /* pairs of places -> point */
  sg_key_table of_place; /* three doubles -> first point there */
  sg_key_table of_name;  /* (s, v) -> point */
  uint32_t *of_vertex;   /* [vertex_room]: its point + 1; 0: none */
  size_t vertex_room;
  sg_key_table of_seat;   /* (point, place) -> seat, of points with many */
  sg_key_table least;     /* (point, s) -> its smallest name, of the same */
  sg_key_table by_itself; /* the segments that are cut by themselves */
} sg_cut_points;

void sg_cut_points_init(sg_cut_points *points, const sg_cut_model *model);
void sg_cut_points_clear(sg_cut_points *points);

/* Says that segment s is cut by itself, before any point is made. False: no
 * memory. */
bool sg_cut_points_set_by_itself(sg_cut_points *points, int32_t s);
bool sg_cut_points_is_by_itself(const sg_cut_points *points, int32_t s);

/* The segment of a place. */
int32_t sg_place_segment(const sg_cut_model *model, const sg_place *place);

/* The place of feature f of a triangle. */
sg_place sg_place_of(const sg_cut_model *model, uint32_t triangle, int f);

/* The point made so, found or new; SG_NO_KEY: no memory, or there is no such
 * single point (parallel). Exact. */
uint32_t sg_cut_points_find(sg_cut_points *points, const sg_made *made);

/* The point in this place that is already known, or a new one that was made
 * as `made` says; SG_NO_KEY: no memory. */
uint32_t sg_cut_points_at(sg_cut_points *points, const sg_point *at,
                          const sg_made *made);

/* The name of a point in segment s, 0: none; the smallest, if it has several.
 */
int32_t sg_cut_points_name(const sg_cut_points *points, uint32_t point,
                           int32_t s);
/* The smallest of its names in segment s for which `is_good` says so; if there
 * is none, the smallest; 0: it has none. A name is asked about once at most. */
typedef bool sg_is_good_name(const void *data, int32_t v);
int32_t sg_cut_points_good_name(const sg_cut_points *points, uint32_t point,
                                int32_t s, sg_is_good_name *is_good,
                                const void *data);
/* Gives it one; it must have none. False: no memory. */
bool sg_cut_points_set_name(sg_cut_points *points, uint32_t point, int32_t s,
                            int32_t v);
/* The point of this name, SG_NO_KEY: none. */
uint32_t sg_cut_points_named(const sg_cut_points *points, int32_t s, int32_t v);

/* Notes that `point` splits the real edge `place`. */
void sg_cut_points_on_edge(sg_cut_points *points, uint32_t point,
                           const sg_place *place);

#endif
