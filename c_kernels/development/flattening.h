/* flattening.h -- laying faces flat, joint by joint, so that nothing overlaps.
 *
 * Layer: kernel. Inexact. Faces that are joined form an *island*; at first each
 * is one of its own. A joint is joined by moving the smaller island so that its
 * side lies on the partner in the larger one, if it is long enough to hold it
 * (SG_FLAT_HOLDS) and then no triangle of it overlaps one there deeper than
 * `depth`. Whatever the order of the joints,
 * nothing ever overlaps.
 *
 * Source: rows DV-4 to DV-6; J. B. Kruskal, On the shortest spanning subtree of
 * a graph, 1956.
 */
#ifndef SG_FLATTENING_H
#define SG_FLATTENING_H

#include "flat_index.h"
#include "joint.h"

typedef enum sg_joint_state {
  SG_JOINT_OPEN,      /* not tried */
  SG_JOINT_JOINED,    /* a fold */
  SG_JOINT_SAME,      /* its faces are connected already */
  SG_JOINT_OVERLAP,   /* refused: something would overlap */
  SG_JOINT_FORBIDDEN, /* not to be joined */
  SG_JOINT_SHORT,     /* refused: its edge is too short to hold what hangs */
  SG_JOINT_CLOSED     /* its sides lie on each other all the same: a fold */
} sg_joint_state;

typedef struct sg_island { /* at first one for each face: a line of memory */
  uint32_t head, tail;     /* faces, linked by next_face */
  uint32_t faces, triangles;
  sg_flat_box box;
  sg_flat_index *index; /* of its triangles, once they are many */
  uint32_t suspect;     /* private: a face that overlapped lately */
  uint32_t unindexed;   /* private: the first face that is not in the index */
} sg_island;

typedef struct sg_flattening {
  const sg_dense *dense; /* borrowed, as are these */
  const sg_flat_faces *faces;
  const sg_joints *joints;
  double size;  /* the longest side of the faces' box in the solid */
  double sheet; /* the side of a square as large as all faces */
  double depth;
  unsigned char *state;            /* [joints] sg_joint_state */
  uint32_t *island_of, *next_face; /* [faces] */
  sg_island *island;               /* [faces] */
  double (*at)[2];                 /* [corners] in the island */
  sg_flat_stock stock;             /* items are triangles */
  size_t tests, refused, joins;    /* overlap tests of two triangles, ... */
  size_t placed;                   /* triangles moved, to see if they overlap */
  size_t moves;                    /* private: since it was asked to stop */
  uint32_t overlap[2];             /* faces that did, after SG_JOINT_OVERLAP */
  bool tried;                      /* private: not as it was at first */
} sg_flattening;

/* Overlaps are refused that are deeper than this part of the sheet. */
#define SG_FLAT_DEPTH 1e-9

/* A fold holds what is up to so many times as long as it is. A shorter one
 * would tear; and since its ends are doubles, what hangs on it would be turned,
 * when folded back, by more than 1e-12. What is flat is not turned. */
#define SG_FLAT_HOLDS 2048

/* Every face an island. False: no memory, or (*stopped) stopped by the
 * cancellation. Owner: sg_flattening_clear() in any case. */
bool sg_flattening_make(const sg_dense *dense, const sg_flat_faces *faces,
                        const sg_joints *joints, const sg_cancel *cancel,
                        sg_flattening *out, bool *stopped);
void sg_flattening_clear(sg_flattening *flattening);

/* As it was at first, except for what is forbidden. False: stopped by the
 * cancellation, to be called again. */
bool sg_flattening_restart(sg_flattening *flattening, const sg_cancel *cancel);

/* Tries joint j, whose new state is *state: JOINED, SAME, OVERLAP (or
 * FORBIDDEN, as it was). False: no memory, or (*stopped) stopped by the
 * cancellation; then everything may be as it was at first. */
bool sg_flattening_join(sg_flattening *flattening, uint32_t j,
                        const sg_cancel *cancel, sg_joint_state *state,
                        bool *stopped);

/* Makes a face an island of its own again, in its own frame. To be done with
 * all faces of an island; the states of its joints stay. */
void sg_flattening_loosen(sg_flattening *flattening, uint32_t face);

/* Joins j, whose faces are of two islands, and does not ask what overlaps: it
 * was joined before. Its state stays. False: no memory. */
bool sg_flattening_rejoin(sg_flattening *flattening, uint32_t j);

/* All joints that are open, in this order. The fused kernel of the rule in
 * rules/development/development.pl. */
bool sg_flattening_join_all(sg_flattening *flattening, const uint32_t *order,
                            size_t n, const sg_cancel *cancel, bool *stopped);

/* Orders in which joints are tried; flat joints always come first. */
typedef enum sg_order {
  SG_ORDER_LONGEST,  /* the default of the decision join_order/3 (DV-6) */
  SG_ORDER_FLATTEST, /* the least angle first */
  SG_ORDER_STEEPEST, /* those that run up and down */
  SG_ORDER_SHUFFLED, /* the longest, but lengths are stretched by up to a tenth,
                        by chance; each number from here on another chance */
} sg_order;

/* The joints in an order (a number from SG_ORDER_SHUFFLED on is another
 * chance). Equal ones by the middle of the edge (the higher z, y, x first),
 * then by edge. Lengths and places are rounded to steps, so that what is equal
 * up to rounding is equal. Null: no memory, or (*stopped) stopped by the
 * cancel. Owner: the caller, free(). */
uint32_t *sg_joint_order(const sg_flattening *flattening, unsigned order,
                         const sg_cancel *cancel, bool *stopped);

/* The joints that were joined on the way from one face to another, in order; *n
 * is 0 if there is no way. Null: no memory, or (*stopped) stopped by the
 * cancellation. Owner: the caller, free(). */
uint32_t *sg_flattening_path(const sg_flattening *flattening, uint32_t from,
                             uint32_t to, const sg_cancel *cancel, size_t *n,
                             bool *stopped);

/* Starts anew and joins just these joints, as they were joined before: what
 * overlaps is not asked. False: no memory, or (*stopped) stopped by the
 * cancellation.
 */
bool sg_flattening_join_folds(sg_flattening *flattening, const uint32_t *joint,
                              size_t n, const sg_cancel *cancel, bool *stopped);

/* A step: 2^-32 of the sheet, as a power of two; model units. */
double sg_joint_step(const sg_flattening *flattening);

/* The middle of the edge of joint j in the segment. */
void sg_joint_middle(const sg_flattening *flattening, uint32_t j,
                     double out[3]);

#endif
