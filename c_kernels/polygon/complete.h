/* complete.h -- planes and triangles for whole segments.
 *
 * Layer: kernel. Reads views of v/5, e/5, p/3, plane/6 and t/6 and computes
 * the rows that are missing: for every polygon without a plane its plane, for
 * every polygon without triangles its triangles, as triangulate.h does, which
 * is as rules/polygon/triangulation.pl says.
 */
#ifndef SG_COMPLETE_H
#define SG_COMPLETE_H

#include "engine/cancel.h"
#include "engine/column.h"
#include "flatness.h"
#include "thread_pool.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Rows of plane/6, as columns. */
typedef struct sg_plane_rows {
  size_t n, room;
  int32_t *s, *p; /* [n] */
  double *c[4];   /* [n] each: Nx, Ny, Nz, D */
} sg_plane_rows;

/* Rows of t/6, as columns. `t` counts 0, 1, 2, ... in each segment: the caller
 * adds a fresh id. */
typedef struct sg_triangle_rows {
  size_t n, room;
  int32_t *s, *p, *t, *v[3]; /* [n] each */
} sg_triangle_rows;

typedef enum sg_fault_kind {
  SG_FAULT_OPEN,    /* does not close at vertex a; no plane, no triangles */
  SG_FAULT_NO_AREA, /* no plane, no triangles */
  SG_FAULT_EDGE,    /* edge a -> b has no third vertex: invalid; no triangles */
  SG_FAULT_TANGLED, /* takes too many steps: no triangles */
  SG_FAULT_BENT,    /* not flat: `size` off its plane; used as its triangles */
  SG_FAULT_FOLDED   /* bent; seen along its normal its triangles overlap */
} sg_fault_kind;

typedef struct sg_polygon_fault {
  int32_t s, p;
  sg_fault_kind kind;
  int32_t a, b; /* vertex ids */
  double size;
} sg_polygon_fault;

typedef struct sg_completion {
  sg_plane_rows planes;
  sg_triangle_rows triangles;
  sg_polygon_fault *fault; /* [faults], in the order of the polygons */
  size_t faults, fault_room;
} sg_completion;

/* What is read; of the polygons, those of `segments` segments (ascending), or
 * of all (null). */
typedef struct sg_completion_input {
  const sg_view *v, *e, *p, *plane, *t;
  const int32_t *segment;
  size_t segments;
  size_t contacts; /* steps (work.h) that all may take beyond their size's */
  /* What counts as flat in the whole model. False: stopped, or no memory. */
  bool (*see)(void *of, sg_flatness *out);
  void *of;
  sg_pool *pool; /* null: the caller alone */
} sg_completion_input;

/* False: no memory, or stopped (*stopped). Polygons in row order. Owner: the
 * caller calls sg_completion_clear() in any case. Exact except the planes and
 * sizes. Source: [PL] section 4 (PL-6). */
bool sg_complete(const sg_completion_input *in, sg_completion *out,
                 bool *stopped, const sg_cancel *cancel);
void sg_completion_clear(sg_completion *out);

#endif
