/* contour_private.h -- what the files of contour.h share.
 *
 * Layer: kernel.
 */
#ifndef SG_CONTOUR_PRIVATE_H
#define SG_CONTOUR_PRIVATE_H

#include "contour.h"
#include "number/vector.h"

/* How a triangle and its corners lie to the eye. */
typedef enum sg_contour_kind {
  SG_CONTOUR_TOWARDS, /* it is turned to the eye, and so are its corners */
  SG_CONTOUR_AWAY,    /* it is turned away, and so are they */
  SG_CONTOUR_MIXED    /* neither: an outline is near */
} sg_contour_kind;

typedef struct sg_contour_finder {
  const sg_contour_input *in;
  sg_contours *out;
  double *g;      /* [fans] towards the eye: not negative */
  int8_t *face;   /* [triangles] turned to the eye: 1, away: -1, edge-on: 0 */
  uint8_t *kind;  /* [triangles] */
  int8_t *sense;  /* [triangles] of the piece across it: 1 the half that is
                     turned to the eye is the nearer one, -1 the other; 0: no
                     piece */
  uint32_t *seen; /* [triangles] the last walk that was there */
  uint32_t walk;
  uint32_t *queue; /* [queued], of room queue_room */
  size_t queued, queue_room;
} sg_contour_finder;

static inline uint32_t
sg_contour_next(uint32_t corner)
{
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/* The vertex of a corner. */
static inline uint32_t
sg_contour_vertex(const sg_contour_finder *f, uint32_t corner)
{
  return (uint32_t)f->in->dense->corner[corner / 3][corner % 3];
}

static inline double
sg_contour_g(const sg_contour_finder *f, uint32_t corner)
{
  return f->g[f->in->smooth->fan[corner]];
}

static inline bool
sg_contour_is_apex(const sg_contour_finder *f, uint32_t corner)
{
  return f->in->smooth->apex[f->in->smooth->fan[corner]];
}

/* Zero counts as turned to the eye. */
static inline bool
sg_contour_is_towards(const sg_contour_finder *f, uint32_t corner)
{
  return sg_contour_g(f, corner) >= 0.0;
}

/* How far from the eye a point is, along the line of sight; the same for all
 * in a parallel picture. */
static inline double
sg_contour_distance(const sg_contour_input *in, const double p[3])
{
  return in->central ? sg_dot(p, in->eye.row[2]) + in->eye.rho : 1.0;
}

/* Where g is zero on a side of the model, counted from its corner a. */
static inline double
sg_contour_model_zero(const sg_contour_finder *f, uint32_t a, uint32_t b)
{
  return sg_contour_g(f, a) / (sg_contour_g(f, a) - sg_contour_g(f, b));
}

/* The direction from a point of the model to the eye, unit. */
void sg_contour_to_eye(const sg_contour_input *in, const double p[3],
                       double out[3]);

/* Where g is zero on a side whose corners differ: 0 at its smaller vertex, 1 at
 * the other, in the picture. */
double sg_contour_zero(const sg_contour_finder *f, uint32_t side);

/* From the zero of a side to the smooth surface, in the picture. */
void sg_contour_rise(const sg_contour_finder *f, uint32_t side, double rise[2]);

/* The two pieces by way of the corner that a piece leaves outside. False: it
 * leaves none. */
bool sg_contour_outermost(const sg_contour_finder *f, const sg_contour *piece,
                          sg_contour half[2]);

/* Where a piece begins or ends in the picture. */
void sg_contour_point(const sg_contour_finder *f, const sg_contour *piece,
                      int end, double out[3]);

/* True if triangle t is of no known surface, and a smooth one would bulge at a
 * side of it (SG_SIDE_BULGES). */
bool sg_contour_bulges(const sg_contour_finder *f, uint32_t t);

/* False: there, the line is turned to the eye as the triangle is, or none runs
 * there on a smooth surface. Its adjacent triangles are left open. */
bool sg_contour_facing(const sg_contour_finder *f, uint32_t side,
                       sg_facing *out);

/* Appends the triangles adjacent to the piece, and counts them. False: no
 * memory. */
bool sg_contour_find_adjacent(sg_contour_finder *f, sg_contour *piece);

#endif
