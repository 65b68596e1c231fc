/* complete_triangle.c -- planes and triangles of polygons that are triangles, a
 * page of p/3 by each thread at a time. They need no scratch relation, and none
 * needs another one.
 */
#include "complete_private.h"
#include "number/exact.h"

#include <math.h>

/* What one thread looks up in. */
typedef struct looking {
  const sg_completed_model *model;
  sg_keys vertices, edges, planes, triangles;
} looking;

/* Whether the corners turn as the normal says; otherwise the long way finds out
 * what is wrong. */
static bool
turns_as_plane(const sg_completed_vertex *corner[3], const sg_plane *plane)
{
  sg_point p[3];
  int axis = 0;

  for (int k = 1; k < 3; k++) {
    axis = fabs(plane->n[k]) > fabs(plane->n[axis]) ? k : axis;
  }
  for (int k = 0; k < 3; k++) {
    sg_point_set(&p[k], corner[k]->p);
  }
  return sg_point_turn(axis, &p[0], &p[1], &p[2]) ==
         (plane->n[axis] < 0 ? -1 : 1);
}

static bool
find_triangle(looking *at, int32_t s, const int32_t *list,
              sg_found_triangle *out)
{
  const sg_completed_vertex *start[3], *end[3], *third;
  sg_newell sum;

  sg_complete_look_up(at->model, &at->edges, &at->vertices, s, list, NULL,
                      start, end);
  if (!(third = sg_complete_third(start, end))) {
    return false;
  }
  sg_newell_init(&sum);
  for (int i = 0; i < 3; i++) {
    sg_newell_edge(&sum, start[i]->p, end[i]->p);
  }
  const sg_completed_vertex *corner[3] = {start[0], end[0], third};

  for (int i = 0; i < 3; i++) {
    out->v[i] = corner[i]->id;
  }
  return sg_newell_plane(&sum, &out->plane) &&
         turns_as_plane(corner, &out->plane);
}

typedef struct pages {
  const sg_completed_model *model;
  size_t first;
  sg_found_triangle *out;
} pages;

static void
do_page(void *data, size_t task)
{
  const pages *all = data;
  const sg_completed_model *m = all->model;
  const sg_view *view = m->in->p;
  size_t i = all->first + task;
  looking at = {m, m->vertices, m->edges, m->planes, m->triangles};

  SG_EACH_ROW(view, i, r)
  {
    int32_t s = sg_int_at(view, 0, i, r), p = sg_int_at(view, 1, i, r);
    const int32_t *list = view->column[2].page[i].list[r];
    sg_found_triangle *out = &all->out[task * SG_PAGE_ROWS + r];

    out->needs_plane = sg_keys_find(&at.planes, s, p) == SG_NOWHERE;
    out->needs_triangles = sg_keys_find(&at.triangles, s, p) == SG_NOWHERE;
    out->found = (out->needs_plane || out->needs_triangles) && list[0] == 3 &&
                 find_triangle(&at, s, list, out);
  }
}

bool
sg_complete_find_triangles(const sg_completed_model *m, size_t first, size_t n,
                           sg_pool *pool, sg_found_triangle *out)
{
  pages all = {m, first, out};

  return sg_pool_run(pool, n, do_page, &all, m->cancel);
}
