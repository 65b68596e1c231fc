/* census.h -- what a model holds and what is wrong with it, in one pass.
 *
 * Layer: kernel. Joins all half-edges, polygons and vertices of each segment;
 * what a defect means is decided by rules (integrity.pl). Measures are inexact.
 */
#ifndef SG_CENSUS_H
#define SG_CENSUS_H

#include "rows/dense.h"

typedef enum sg_defect_kind {
  SG_DEFECT_BORDER,      /* half-edge a has no opposite */
  SG_DEFECT_TURNED,      /* half-edges a and b run the same way */
  SG_DEFECT_NONMANIFOLD, /* b > 2 half-edges between the ends of half-edge a,
                            not as many one way as the other */
  SG_DEFECT_CROWDED,     /* the same, as many one way as the other */
  SG_DEFECT_SHARED,      /* half-edge a is in polygons b and another */
  SG_DEFECT_OPEN,        /* polygon a: b edges lead nowhere */
  SG_DEFECT_FLAT,        /* polygon a has no area */
  SG_DEFECT_BENT,        /* polygon a is off its plane by more than allowed */
  SG_DEFECT_DUPLICATE,   /* polygons a and b have the same vertices */
  SG_DEFECT_PINCHED,     /* b separate fans of polygons meet at vertex a */
  SG_DEFECT_UNUSED,      /* vertex a has no edge */
  SG_DEFECT_TWIN,        /* vertices a and b are at the same place */
  SG_DEFECT_SHORT,       /* half-edge a is shorter than the tolerance */
  SG_DEFECT_PLANE,       /* the plane of polygon a is not through its corners,
                            or looks the other way */
  SG_DEFECT_TRIANGLES,   /* the triangles of polygon a do not cover it once, or
                            one is turned over */
  SG_DEFECT_CROSSED,     /* polygon a crosses or overlaps itself: no triangles
                            fill it */
  SG_DEFECTS
} sg_defect_kind;

typedef struct sg_defect {
  sg_defect_kind kind;
  int32_t segment; /* number */
  int32_t a, b;    /* ids; b as said above, else 0 */
} sg_defect;

/* Polygons connected by edges. */
typedef struct sg_shell {
  int32_t segment; /* number */
  int32_t polygon; /* the lowest id in it */
  size_t vertices, edges, polygons;
  int64_t euler; /* vertices - edges + faces; a face with h holes counts 1-h */
  size_t depth;  /* how many closed others of the segment go round it */
  bool closed;   /* as many half-edges one way as the other on every edge */
  bool pinched;  /* some vertex has several fans */
  double area, volume; /* volume > 0: normals point outward */
} sg_shell;

typedef struct sg_part {
  int32_t segment;
  size_t vertices, half_edges, edges, polygons, triangles, curve_edges;
  size_t first_shell, shells;
  double low[3], high[3]; /* of its vertices; 0 without any */
  double area, volume, length, tolerance;
  size_t defects[SG_DEFECTS];
} sg_part;

typedef struct sg_census {
  size_t parts, shells, defects;
  sg_part *part;     /* in the order of dense */
  sg_shell *shell;   /* by segment, then lowest polygon */
  sg_defect *defect; /* by segment, then as found */
  size_t defect_room;
} sg_census;

/* `plane`: [polygons] A, B, C, D as the model has them, NaN where it has none;
 * null: none at all.
 *
 * Returns: false: no memory, or (*stopped) stopped by the cancellation.
 * Cost:    about linear.
 * Owner:   sg_census_clear() in any case. */
bool sg_census_make(const sg_dense *dense, const double (*plane)[4],
                    const sg_cancel *cancel, sg_census *out, bool *stopped);
void sg_census_clear(sg_census *census);

#endif
