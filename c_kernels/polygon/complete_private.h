/* complete_private.h -- what a completion reads, and the rows that it writes.
 *
 * Layer: kernel, private to complete*.c. What adds returns false if there is no
 * memory; sg_completion_clear() frees what was written.
 */
#ifndef SG_COMPLETE_PRIVATE_H
#define SG_COMPLETE_PRIVATE_H

#include "complete.h"
#include "plane.h"
#include "rows/key_table.h"
#include "rows/keys.h"

/* ---- what is read (complete_model.c) ---- */

typedef struct sg_completed_vertex {
  int32_t s, id;
  double p[3];
} sg_completed_vertex;

typedef struct sg_completed_edge {
  int32_t s, id, v1, v2;
} sg_completed_edge;

typedef struct sg_completed_polygon {
  int32_t s, id;
} sg_completed_polygon;

typedef struct sg_completed_model {
  sg_completed_vertex *v;
  sg_completed_edge *e;
  sg_completed_polygon *with_plane, *with_triangles;
  sg_keys vertices, edges, planes, triangles;
  const sg_completion_input *in;
  sg_flatness own, whole; /* of what is read; of the model, once it is asked */
  bool asked;
  const sg_cancel *cancel;
  bool stopped;
} sg_completed_model;

/* For every live row r of page i of a view. */
#define SG_EACH_ROW(view, i, r)                                                \
  for (unsigned r = sg_live_next((view)->live[i], 0); r < SG_PAGE_ROWS;        \
       r = sg_live_next((view)->live[i], r + 1))

static inline int32_t
sg_int_at(const sg_view *view, int column, size_t i, unsigned r)
{
  return view->column[column].page[i].i[r];
}

/* False: no memory, or stopped; sg_complete_forget() in any case. */
bool sg_complete_read(const sg_completion_input *in, sg_completed_model *out);
void sg_complete_forget(sg_completed_model *m);

/* The edges in a list of p/3 (`e` may be null) and their ends. The store keeps
 * references whole, so that none is missing. `edges` and `vertices` are m's, or
 * a thread's own copies. */
void sg_complete_look_up(const sg_completed_model *m, sg_keys *edges,
                         sg_keys *vertices, int32_t s, const int32_t *list,
                         const sg_completed_edge **e,
                         const sg_completed_vertex **start,
                         const sg_completed_vertex **end);

/* Of three edges in a ring: the third corner of the first one, else null. */
const sg_completed_vertex *
sg_complete_third(const sg_completed_vertex *const *start,
                  const sg_completed_vertex *const *end);

/* ---- polygons that are triangles (complete_triangle.c) ---- */

/* What is missing of a polygon; of a triangle that has an area, whose edges are
 * a ring, it is found. */
typedef struct sg_found_triangle {
  bool needs_plane, needs_triangles, found;
  int32_t v[3];
  sg_plane plane;
} sg_found_triangle;

enum { SG_FIND_PAGES = 16 };

/* Of the live rows of pages first .. first + n - 1 of p/3, n at most
 * SG_FIND_PAGES: out[(page - first) * SG_PAGE_ROWS + row]. False: stopped. */
bool sg_complete_find_triangles(const sg_completed_model *m, size_t first,
                                size_t n, sg_pool *pool,
                                sg_found_triangle *out);

/* ---- rows (complete_rows.c) ---- */

bool sg_complete_add_plane(sg_plane_rows *rows, int32_t s, int32_t p,
                           const sg_plane *plane);
/* It gets the next number of its segment; `counts` has how many each has. */
bool sg_complete_add_triangle(sg_triangle_rows *rows, sg_key_table *counts,
                              int32_t s, int32_t p, const int32_t v[3]);
bool sg_complete_add_fault(sg_completion *out, const sg_polygon_fault *fault);

#endif
