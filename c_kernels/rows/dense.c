/* dense.c -- see dense.h. Rows are gathered as keys (segment place, id), sorted
 * if they are not so already, then copied in that order. */
#include "dense.h"
#include "engine/list.h"
#include "engine/search.h"
#include "sort.h"

#include <stdlib.h>
#include <string.h>

enum { ID_BITS = 32 };

/* A row and its key. */
typedef struct row_key {
  uint64_t key; /* place of the segment, id */
  uint32_t page, row;
} row_key;

typedef struct rows {
  row_key *row;
  size_t n, room;
  uint32_t *begin; /* [segments + 1] */
  const sg_cancel *cancel;
  bool stopped; /* it said stop */
} rows;

SG_ORDER(compare_keys, row_key, SG_BY(key));

/* Whether to stop, asked in step i. */
static bool
stops(rows *r, size_t i)
{
  r->stopped = r->stopped || sg_cancel_every(r->cancel, i);
  return r->stopped;
}

/* The place of segment s, or -1. Rows of a segment come together, so the last
 * place is tried first. */
static int64_t
segment_place(const sg_dense *d, int32_t s, size_t *last)
{
  if (*last < d->segments && d->segment[*last] == s) {
    return (int64_t)*last;
  }
  size_t found = sg_find_id(d->segment, d->segments, s);
  if (found == SIZE_MAX) {
    return -1;
  }
  *last = found;
  return (int64_t)*last;
}

/* Segments ---------------------------------------------------------------- */

typedef struct id_list {
  int32_t *id;
  size_t n, room;
} id_list;

static bool
add_id(id_list *list, int32_t id)
{
  if (!sg_list_grow(&list->id, list->n, &list->room, sizeof *list->id)) {
    return false;
  }
  list->id[list->n++] = id;
  return true;
}

/* Whether rows of one segment alone can be on the page. */
static bool
has_one_segment(const sg_view *view, size_t page)
{
  return view->span && view->span[page][0] == view->span[page][1];
}

/* Adds the segments in a view; runs of one segment count once. */
static bool
add_segments(const sg_view *view, id_list *list)
{
  int32_t last = 0;

  for (size_t i = 0; i < view->pages; i++) {
    const int32_t *s = view->column[0].page[i].i;
    unsigned r = sg_live_next(view->live[i], 0);
    while (r < SG_PAGE_ROWS) {
      if (s[r] != last && !add_id(list, last = s[r])) {
        return false;
      }
      r = has_one_segment(view, i) ? SG_PAGE_ROWS
                                   : sg_live_next(view->live[i], r + 1);
    }
  }
  return true;
}

static bool
find_segments(const sg_dense_views *views, const int32_t *wanted, size_t n,
              sg_dense *d)
{
  id_list list = {0};

  if (wanted) {
    for (size_t i = 0; i < n; i++) {
      if (!add_id(&list, wanted[i])) {
        free(list.id);
        return false;
      }
    }
  } else if (!add_segments(&views->v, &list) ||
             !add_segments(&views->e, &list) ||
             !add_segments(&views->p, &list)) {
    free(list.id);
    return false;
  }
  d->segment = list.id;
  d->segments = sg_sort_ids(list.id, list.n);
  return true;
}

/* Rows -------------------------------------------------------------------- */

static bool
set_begins(const sg_dense *d, rows *out)
{
  out->begin = calloc(d->segments + 1, sizeof *out->begin);
  if (!out->begin) {
    return false;
  }
  for (size_t i = 0; i < out->n; i++) {
    out->begin[(out->row[i].key >> ID_BITS) + 1]++;
  }
  for (size_t s = 0; s < d->segments; s++) {
    out->begin[s + 1] += out->begin[s];
  }
  return true;
}

/* False: no row of a segment of d is on the page. */
static bool
may_have(const sg_dense *d, const sg_view *view, size_t page)
{
  size_t at;

  if (!view->span) {
    return true;
  }
  SG_SEARCH(at, 0, d->segments, d->segment[at] < view->span[page][0]);
  return at < d->segments && d->segment[at] <= view->span[page][1];
}

/* Room for all rows that there may be: as memory, nothing before it is used. */
static bool
rows_room(const sg_dense *d, const sg_view *view, rows *out)
{
  size_t most = 0;

  for (size_t i = 0; i < view->pages; i++) {
    most += may_have(d, view, i) ? SG_PAGE_ROWS : 0;
  }
  return sg_list_need(&out->row, most, &out->room, sizeof *out->row);
}

/* The rows of `view` in the segments of `d`, by segment and the id in this
 * column. */
static bool
gather(const sg_dense *d, const sg_view *view, unsigned column, rows *out)
{
  size_t last = 0;
  bool sorted = true;

  if (!rows_room(d, view, out)) {
    return false;
  }
  for (size_t i = 0; i < view->pages; i++) {
    if (stops(out, i * SG_PAGE_ROWS)) {
      return false;
    }
    if (!may_have(d, view, i)) {
      continue;
    }
    for (unsigned r = sg_live_next(view->live[i], 0); r < SG_PAGE_ROWS;
         r = sg_live_next(view->live[i], r + 1)) {
      int64_t s = segment_place(d, view->column[0].page[i].i[r], &last);
      if (s < 0) {
        continue;
      }
      uint64_t key =
          (uint64_t)s << ID_BITS | (uint32_t)view->column[column].page[i].i[r];
      sorted = sorted && (out->n == 0 || out->row[out->n - 1].key < key);
      out->row[out->n++] = (row_key){key, (uint32_t)i, r};
    }
  }
  sg_sort_end end = sorted ? SG_SORTED
                           : sg_sort(out->row, out->n, sizeof *out->row,
                                     compare_keys, out->cancel);

  out->stopped = end == SG_SORT_STOPPED;
  return end == SG_SORTED && set_begins(d, out);
}

/* The place of the thing with this id in the segment of place s: as a rule ids
 * have no gaps, so none need be looked at; else a guess mostly finds it. */
static inline int32_t
place_of(const int32_t *id, const uint32_t *begin, uint64_t s, int32_t wanted)
{
  const int32_t *first = id + begin[s];
  size_t n = begin[s + 1] - begin[s];
  size_t guess = n ? (size_t)((int64_t)wanted - first[0]) : 0;

  if (guess < n && ((int64_t)first[n - 1] - first[0] < (int64_t)n ||
                    first[guess] == wanted)) {
    return (int32_t)(begin[s] + guess);
  }
  size_t found = sg_find_id(first, n, wanted);
  return found == SIZE_MAX ? -1 : (int32_t)(begin[s] + found);
}

static int32_t
id_of(const row_key *row)
{
  return (int32_t)(uint32_t)row->key;
}

static int32_t
cell(const sg_view *view, unsigned column, const row_key *row)
{
  return view->column[column].page[row->page].i[row->row];
}

/* Filling ------------------------------------------------------------------ */

static bool
fill_vertices(sg_dense *d, const sg_view *view, rows *from)
{
  d->vertices = from->n;
  d->vertex_begin = from->begin;
  d->vertex_id = sg_list_room(from->n, sizeof *d->vertex_id);
  d->at = sg_list_room(from->n, sizeof *d->at);
  if (!d->vertex_id || !d->at) {
    return false;
  }
  for (size_t i = 0; i < from->n && !stops(from, i); i++) {
    const row_key *row = &from->row[i];
    d->vertex_id[i] = id_of(row);
    for (unsigned k = 0; k < 3; k++) {
      d->at[i][k] = view->column[2 + k].page[row->page].f[row->row];
    }
  }
  return !from->stopped;
}

static bool
fill_edges(sg_dense *d, const sg_view *view, rows *from)
{
  d->edges = from->n;
  d->edge_begin = from->begin;
  d->edge_id = sg_list_room(from->n, sizeof *d->edge_id);
  d->from = sg_list_room(from->n, sizeof *d->from);
  d->to = sg_list_room(from->n, sizeof *d->to);
  d->real = sg_list_room(from->n, sizeof *d->real);
  if (!d->edge_id || !d->from || !d->to || !d->real) {
    return false;
  }
  for (size_t i = 0; i < from->n && !stops(from, i); i++) {
    const row_key *row = &from->row[i];
    uint64_t s = row->key >> ID_BITS;
    d->edge_id[i] = id_of(row);
    d->from[i] = place_of(d->vertex_id, d->vertex_begin, s, cell(view, 2, row));
    d->to[i] = place_of(d->vertex_id, d->vertex_begin, s, cell(view, 3, row));
    d->real[i] = cell(view, 4, row) != 0;
  }
  return !from->stopped;
}

static const int32_t *
list_of(const sg_view *view, const row_key *row)
{
  return view->column[2].page[row->page].list[row->row];
}

static bool
fill_polygons(sg_dense *d, const sg_view *view, rows *from)
{
  size_t items = 0;

  for (size_t i = 0; i < from->n; i++) {
    items += (size_t)list_of(view, &from->row[i])[0];
  }
  d->polygons = from->n;
  d->polygon_begin = from->begin;
  d->polygon_id = sg_list_room(from->n, sizeof *d->polygon_id);
  d->list_begin = sg_list_room(from->n, sizeof *d->list_begin);
  d->list = sg_list_room(items, sizeof *d->list);
  if (!d->polygon_id || !d->list_begin || !d->list) {
    return false;
  }
  items = 0;
  for (size_t i = 0; i < from->n && !stops(from, i); i++) {
    const row_key *row = &from->row[i];
    const int32_t *list = list_of(view, row);
    d->polygon_id[i] = id_of(row);
    d->list_begin[i] = (uint32_t)items;
    for (int32_t k = 1; k <= list[0]; k++) {
      d->list[items++] =
          place_of(d->edge_id, d->edge_begin, row->key >> ID_BITS, list[k]);
    }
  }
  d->list_begin[from->n] = (uint32_t)items;
  return !from->stopped;
}

static bool
fill_triangles(sg_dense *d, const sg_view *view, rows *from)
{
  d->triangles = from->n;
  d->triangle_begin = from->begin;
  d->triangle_id = sg_list_room(from->n, sizeof *d->triangle_id);
  d->polygon_of = sg_list_room(from->n, sizeof *d->polygon_of);
  d->corner = sg_list_room(from->n, sizeof *d->corner);
  if (!d->triangle_id || !d->polygon_of || !d->corner) {
    return false;
  }
  for (size_t i = 0; i < from->n && !stops(from, i); i++) {
    const row_key *row = &from->row[i];
    uint64_t s = row->key >> ID_BITS;
    d->triangle_id[i] = id_of(row);
    d->polygon_of[i] =
        place_of(d->polygon_id, d->polygon_begin, s, cell(view, 1, row));
    for (unsigned k = 0; k < 3; k++) {
      d->corner[i][k] =
          place_of(d->vertex_id, d->vertex_begin, s, cell(view, 3 + k, row));
    }
  }
  return !from->stopped;
}

bool
sg_dense_make(const sg_dense_views *views, const int32_t *wanted, size_t n,
              const sg_cancel *cancel, sg_dense *out, bool *stopped)
{
  const struct {
    const sg_view *view;
    unsigned id_column;
    bool (*fill)(sg_dense *, const sg_view *, rows *);
  } part[] = {{&views->v, 1, fill_vertices},
              {&views->e, 1, fill_edges},
              {&views->p, 1, fill_polygons},
              {&views->t, 2, fill_triangles}};

  *out = (sg_dense){0};
  *stopped = false;
  if (!find_segments(views, wanted, n, out) ||
      !(out->grain = calloc(out->segments + 1, sizeof *out->grain))) {
    return false;
  }
  /* Of one relation after the other, in the same memory. */
  rows from = {.cancel = cancel};
  bool good = true;

  for (size_t i = 0; good && i < sizeof part / sizeof *part; i++) {
    from.n = 0;
    from.begin = NULL;
    good = gather(out, part[i].view, part[i].id_column, &from);
    if (!good) {
      free(from.begin);
    }
    good = good && part[i].fill(out, part[i].view, &from);
  }
  *stopped = from.stopped;
  free(from.row);
  return good;
}

void
sg_dense_clear(sg_dense *d)
{
  void *const owned[] = {
      d->segment,        d->vertex_begin, d->edge_begin,  d->polygon_begin,
      d->triangle_begin, d->vertex_id,    d->at,          d->edge_id,
      d->from,           d->to,           d->real,        d->polygon_id,
      d->list_begin,     d->list,         d->triangle_id, d->polygon_of,
      d->corner,         d->grain};

  for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) {
    free(owned[i]);
  }
  *d = (sg_dense){0};
}

static int32_t
find_place(const sg_dense *d, const int32_t *ids, const uint32_t *begin,
           int32_t s, int32_t id)
{
  size_t last = 0;
  int64_t place = segment_place(d, s, &last);

  return place < 0 ? -1 : place_of(ids, begin, (uint64_t)place, id);
}

int32_t
sg_dense_vertex(const sg_dense *d, int32_t s, int32_t v)
{
  return find_place(d, d->vertex_id, d->vertex_begin, s, v);
}

int32_t
sg_dense_polygon(const sg_dense *d, int32_t s, int32_t p)
{
  return find_place(d, d->polygon_id, d->polygon_begin, s, p);
}

int32_t
sg_dense_triangle(const sg_dense *d, int32_t s, int32_t t)
{
  return find_place(d, d->triangle_id, d->triangle_begin, s, t);
}

size_t
sg_dense_segment_of(const sg_dense *d, const uint32_t *begin, uint32_t place)
{
  size_t next;

  SG_SEARCH(next, 1, d->segments, begin[next] <= place);
  return next - 1;
}

bool
sg_dense_by_polygon(const sg_dense *dense, uint32_t **begin,
                    uint32_t **triangle)
{
  uint32_t *first = *begin = calloc(dense->polygons + 2, sizeof *first);

  *triangle = malloc((dense->triangles + 1) * sizeof **triangle);
  if (!first || !*triangle) {
    return false;
  }
  for (size_t t = 0; t < dense->triangles; t++) {
    first[dense->polygon_of[t] + 2]++;
  }
  for (size_t p = 2; p < dense->polygons + 2; p++) {
    first[p] += first[p - 1];
  }
  for (uint32_t t = 0; t < dense->triangles; t++) {
    (*triangle)[first[dense->polygon_of[t] + 1]++] = t;
  }
  return true;
}
