/* complete_model.c -- the rows that a completion reads, sorted by their keys.
 */
#include "complete_private.h"
#include "rows/sort.h"

#include <stdlib.h>

static size_t
count_rows(const sg_view *view)
{
  size_t n = 0;

  for (size_t i = 0; i < view->pages; i++) {
    for (size_t k = 0; k < SG_LIVE_WORDS; k++) {
      n += (size_t)__builtin_popcountll(view->live[i][k]);
    }
  }
  return n;
}

static bool
stops(sg_completed_model *m)
{
  m->stopped = m->stopped || sg_cancelled(m->cancel);
  return m->stopped;
}

/* False: no memory, or stopped. */
static bool
sort_keys(sg_completed_model *m, void *base, size_t size, size_t n,
          sg_keys *out)
{
  *out = (sg_keys){base, size, n, 0};
  if (m->stopped) {
    return false;
  }
  sg_sort_end end = sg_sort(base, n, size, sg_key_compare, m->cancel);
  m->stopped = end == SG_SORT_STOPPED;
  return end == SG_SORTED;
}

static bool
read_vertices(const sg_view *view, sg_completed_model *out)
{
  size_t n = 0;

  out->v = malloc((count_rows(view) + 1) * sizeof *out->v);
  if (!out->v) {
    return false;
  }
  for (size_t i = 0; i < view->pages && !stops(out); i++) {
    SG_EACH_ROW(view, i, r)
    {
      sg_completed_vertex *v = &out->v[n++];
      v->s = sg_int_at(view, 0, i, r);
      v->id = sg_int_at(view, 1, i, r);
      for (int k = 0; k < 3; k++) {
        v->p[k] = view->column[2 + k].page[i].f[r];
      }
      sg_flatness_see(&out->own, v->p);
    }
  }
  return sort_keys(out, out->v, sizeof *out->v, n, &out->vertices);
}

static bool
read_edges(const sg_view *view, sg_completed_model *out)
{
  size_t n = 0;

  out->e = malloc((count_rows(view) + 1) * sizeof *out->e);
  if (!out->e) {
    return false;
  }
  for (size_t i = 0; i < view->pages && !stops(out); i++) {
    SG_EACH_ROW(view, i, r)
    {
      out->e[n++] = (sg_completed_edge){
          sg_int_at(view, 0, i, r), sg_int_at(view, 1, i, r),
          sg_int_at(view, 2, i, r), sg_int_at(view, 3, i, r)};
    }
  }
  return sort_keys(out, out->e, sizeof *out->e, n, &out->edges);
}

/* The polygons that have a row in plane/6 or t/6. */
static bool
read_polygons(const sg_view *view, sg_completed_model *m,
              sg_completed_polygon **out, sg_keys *keys)
{
  size_t n = 0;

  *out = malloc((count_rows(view) + 1) * sizeof **out);
  if (!*out) {
    return false;
  }
  for (size_t i = 0; i < view->pages && !stops(m); i++) {
    SG_EACH_ROW(view, i, r)
    {
      (*out)[n++] = (sg_completed_polygon){sg_int_at(view, 0, i, r),
                                           sg_int_at(view, 1, i, r)};
    }
  }
  return sort_keys(m, *out, sizeof **out, n, keys);
}

bool
sg_complete_read(const sg_completion_input *in, sg_completed_model *out)
{
  out->in = in;
  return read_vertices(in->v, out) && read_edges(in->e, out) &&
         read_polygons(in->plane, out, &out->with_plane, &out->planes) &&
         read_polygons(in->t, out, &out->with_triangles, &out->triangles);
}

void
sg_complete_forget(sg_completed_model *m)
{
  free(m->v);
  free(m->e);
  free(m->with_plane);
  free(m->with_triangles);
}

void
sg_complete_look_up(const sg_completed_model *m, sg_keys *edges,
                    sg_keys *vertices, int32_t s, const int32_t *list,
                    const sg_completed_edge **e,
                    const sg_completed_vertex **start,
                    const sg_completed_vertex **end)
{
  for (int32_t i = 0; i < list[0]; i++) {
    const sg_completed_edge *one = &m->e[sg_keys_find(edges, s, list[1 + i])];

    start[i] = &m->v[sg_keys_find(vertices, s, one->v1)];
    end[i] = &m->v[sg_keys_find(vertices, s, one->v2)];
    if (e) {
      e[i] = one;
    }
  }
}

const sg_completed_vertex *
sg_complete_third(const sg_completed_vertex *const *start,
                  const sg_completed_vertex *const *end)
{
  int second = start[1] == end[0] ? 1 : 2, third = 3 - second;
  bool ring = start[second] == end[0] && start[third] == end[second] &&
              end[third] == start[0];

  return ring ? end[second] : NULL;
}
