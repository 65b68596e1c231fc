/* regions_walk.h -- a walk over points of parts, to find which of them lie in
 * which (regions_where.c, regions_point.c).
 *
 * Layer: kernel.
 */
#ifndef SG_REGIONS_WALK_H
#define SG_REGIONS_WALK_H

#include "regions_private.h"

#include "join/tour.h"

typedef struct sg_walk_part {
  uint32_t element; /* of its outer zone */
  uint32_t piece;   /* its root, or SG_NOWHERE */
  uint32_t number;  /* of the piece's triangles; the wire; the vertex */
  uint32_t depth;
  bool on;     /* on another one */
  bool nearly; /* on one within what rounds */
  bool moved;  /* it has another point */
  bool inside; /* the point, shifted, is inside it: then it may be on others */
  sg_point at;
} sg_walk_part;

typedef struct sg_walk_middle sg_walk_middle; /* regions_point.c */

typedef struct sg_walk {
  sg_regions_maker *m;
  sg_walk_part *part;
  size_t parts;
  uint32_t *stop; /* [stops] parts, or middles */
  const sg_point **at;
  size_t stops;
  uint32_t *item; /* [items] triangles of the tree */
  size_t items;
  sg_box all;
  int *count;             /* [2 * polygons] of outer zones */
  int64_t away;           /* of how many parts it is not outside */
  int64_t around;         /* the sum of their outer zones, from 1 */
  uint32_t *depth;        /* [polygons] of the piece */
  int64_t *sum;           /* [parts + 1] by depth; null: depths are not known */
  uint32_t *parent;       /* [parts] the zone, SG_NOWHERE: outside of all */
  sg_walk_middle *middle; /* [middles] of parts whose own point is on others */
  size_t middles;
  bool nearly; /* what is said to be on a triangle is near it */
} sg_walk;

/* Whether a triangle is of another part, and has that in two zones. */
bool sg_walk_is_between(const sg_walk *w, uint32_t item,
                        const sg_walk_part *one);
/* How many of its own outer zone the walk is not in. */
int64_t sg_walk_own_away(const sg_walk *w, const sg_walk_part *one);

/* Adds a point to go to, if it is where triangles are. */
void sg_walk_stop(sg_walk *w, uint32_t number, const sg_point *at);
/* Goes to the points. False: m->end says why. */
bool sg_walk_over(sg_walk *w, const sg_tour *way);
/* Calls way->on, while w->nearly, for each triangle that one of the points is
 * on within what rounds. False: m->end says why. */
bool sg_walk_nearly(sg_walk *w, const sg_tour *way);

void sg_walk_corners(const void *data, uint32_t item, double out[3][3]);
void sg_walk_pass(void *data, uint32_t item, int turns);
/* The middle of a triangle. */
void sg_walk_middle_of(const sg_regions_maker *m, uint32_t t, sg_point *out);

/* Gives parts whose point is on another one a better point, if there is one.
 * False: m->end says why. */
bool sg_walk_move_points(sg_walk *w, const sg_bvh *tree);
void sg_walk_clear_middles(sg_walk *w);

#endif
