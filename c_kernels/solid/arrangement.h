/* arrangement.h -- leaves in pieces, and on which side of the others each is.
 *
 * Layer: kernel. After a penetration is found (cut_set.h) and has entered the
 * polygons (work.h), the leaves are cut along all their lines. What hangs
 * together without a line between is a COMPONENT: the same holds for all of
 * it. One exact question, how often each segment goes round a point of it,
 * says on which side it is of every other leaf, and of its own. Just below the
 * piece (inside, as it looks) and just above it, since these differ in the
 * leaves it lies on.
 *
 * What stays is not decided here: sg_arrangement_select() is told. The pieces
 * of a leaf depend on that leaf and on those near it, and on nothing else; so
 * an arrangement may be of some leaves only, and a solid be selected from
 * several.
 *
 * Source: rows CB-3 and CB-4; the winding numbers of winding.h.
 */
#ifndef SG_ARRANGEMENT_H
#define SG_ARRANGEMENT_H

#include "join/leaf_tree.h"
#include "join/nonmanifold.h"
#include "penetration/cut_enter.h"
#include "penetration/cut_set.h"
#include "polygon/triangulate.h"
#include "solid.h"

typedef struct sg_arrangement sg_arrangement;

/* How often a segment goes round the points just below and just above a
 * component. A surface goes round nothing: 0, 0. */
typedef struct sg_side {
  int32_t s;
  int below, above;
} sg_side;

/* A component, and the point of it that was asked for. */
typedef struct sg_component {
  int32_t s, p;        /* a polygon of it */
  const sg_point *at;  /* inside a piece of that polygon, exact */
  const sg_side *side; /* [sides]: of the segments that go round it, and of
                          those it lies on, by segment. All others: 0, 0 */
  size_t sides;
  bool second;  /* it lies on a piece of a segment with a smaller number, or of
                   its own in a smaller polygon: one of the two is enough.
                   A solid's is never second to a surface's */
  bool unknown; /* it has no area: nobody could say */
} sg_component;

/* A polygon of a leaf that counts for several (sewing.h). */
typedef struct sg_weight {
  int32_t s, p;
  int weight;
} sg_weight;

/* What the leaves are taken from: all borrowed, until the arrangement closes.
 * Segments ascending. The set has cut all that a wanted leaf is near. The
 * others are there to be looked at. */
typedef struct sg_leaves {
  const sg_cut_set *set;
  const sg_leaf_views *views;
  const int32_t *s;                /* [n] */
  const sg_leaf_tree *const *tree; /* [n] */
  const bool *wanted;              /* [n]: in pieces */
  const bool *surface;             /* [n]: it has no inside */
  size_t n;
  const sg_nonmanifold *const *nonmanifold; /* [n]: of the trees */
  const sg_weight *weight; /* [weights]: by s, p; all others count once */
  size_t weights;
} sg_leaves;

/* Null: no memory, or stopped. The set is sealed, and nothing enters it any
 * more. */
sg_arrangement *sg_arrangement_open(const sg_leaves *leaves,
                                    const sg_cancel *cancel);
void sg_arrangement_close(sg_arrangement *a);

/* Takes in n polygons, whose works are used up; before sealing. `reach`: how
 * far apart may be what touches, for polygons that can be triangulated only
 * then (sg_work_resolve). SG_STUCK: polygon *stuck cannot be, and *edge is an
 * edge, still living, that proves it. */
sg_outcome sg_arrangement_polygons(sg_arrangement *a, const sg_entered *polygon,
                                   size_t n, double reach, sg_pool *pool,
                                   const sg_cancel *cancel, size_t *stuck,
                                   int32_t *edge);

/* Takes in polygons by their outlines, which it enters itself: all of them, or
 * none (SG_STUCK), if a line meets anything in one, or one needs more than that
 * to be divided. Nothing in the set may have been divided while lines were
 * entered. */
sg_outcome sg_arrangement_free_polygons(sg_arrangement *a,
                                        const sg_outlines *outlines,
                                        double reach, sg_pool *pool,
                                        const sg_cancel *cancel);

/* Finds the components, and their sides. False: no memory, or stopped. */
bool sg_arrangement_seal(sg_arrangement *a, sg_pool *pool,
                         const sg_cancel *cancel);

/* Frees what only sealing needs, for who keeps an arrangement for long: from
 * here on it looks into the trees of wanted leaves, and into `views`, alone. */
void sg_arrangement_compact(sg_arrangement *a, const sg_leaf_views *views);

/* How many components a wanted leaf has; and one of them. */
size_t sg_arrangement_components(const sg_arrangement *a, int32_t s);
sg_component sg_arrangement_component(const sg_arrangement *a, int32_t s,
                                      size_t c);

/* A vertex that a cut made in a leaf: where it is, rounded, and the point of
 * the set; SG_NO_KEY: no piece has a vertex of this name. */
typedef struct sg_made_vertex {
  double at[3];
  uint32_t point;
} sg_made_vertex;

/* Those of the leaf in this place, n of them, of a sealed arrangement; none of
 * a leaf that is not wanted. Owner: the arrangement. */
const sg_made_vertex *sg_arrangement_made(const sg_arrangement *a, size_t leaf,
                                          size_t *n);

/* What is chosen of one leaf: its components with sense[c] 1, and turned over
 * those with -1. */
typedef struct sg_chosen {
  const sg_arrangement *a;
  int32_t s;
  const int8_t *sense;
} sg_chosen;

/* Point `point` of the set of the arrangement of choice `chosen`. */
typedef struct sg_made_by {
  uint32_t chosen, point;
} sg_made_by;

/* A solid from what is chosen of n leaves, each once. What made its made
 * vertices is (*made_by)[vertex - plain]; origins are not filled in. False: no
 * memory, or stopped. Owner: the caller, also of *made_by (free()). */
bool sg_arrangement_select(const sg_chosen *chosen, size_t n, sg_pool *pool,
                           const sg_cancel *cancel, sg_solid *out,
                           sg_made_by **made_by);

#endif
