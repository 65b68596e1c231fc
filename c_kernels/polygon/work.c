/* work.c -- the scratch relation's rows and lists: see work.h.
 *
 * Layer: kernel. Vertices and edges are rows of two growing arrays; edges hang
 * in three lists: the queue of all, those leaving and those entering a vertex.
 * Ids are found through a hash table.
 */
#include "engine/list.h"
#include "work_private.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  SLOTS_KEPT = 256, /* by sg_work_clear(); emptying more costs more */
  MOST_ROWS = INT32_MAX / 2
};

/* ---- life --------------------------------------------------------------- */

static void
look_along(sg_work *work, const double normal[3])
{
  work->axis = 0;
  for (int k = 1; k < 3; k++) {
    if (fabs(normal[k]) > fabs(normal[work->axis])) {
      work->axis = k;
    }
  }
  work->flip = normal[work->axis] < 0 ? -1 : 1;
}

static void
forget_proven(sg_work *work)
{
  for (int i = 0; i < 3; i++) {
    work->proven[i] = SG_WORK_NONE;
  }
}

sg_work *
sg_work_open(const double normal[3])
{
  sg_work *work = calloc(1, sizeof *work);

  if (work) {
    sg_key_table_init(&work->ids, 1);
    look_along(work, normal);
    forget_proven(work);
  }
  return work;
}

static void
clear_points(sg_work *work)
{
  for (int32_t v = 0; v < work->vertices; v++) {
    sg_point_clear(&work->vertex[v].point);
  }
}

static void
close_indexes(sg_work *work)
{
  sg_work_grid_close(&work->grid);
  sg_work_grid_close(&work->ends);
  sg_work_tips_clear(work);
  sg_work_forest_close(work);
  sg_work_places_clear(work);
}

void
sg_work_clear(sg_work *work, const double normal[3])
{
  clear_points(work);
  close_indexes(work);
  sg_work_pairs_clear(work);
  work->looked = 0;
  work->simple = SG_NOT_ASKED;
  work->crossed[0] = work->crossed[1] = 0;
  forget_proven(work);
  sg_key_table_empty(&work->ids, SLOTS_KEPT);
  work->vertices = work->edges = work->oldest = work->youngest = 0;
  work->living = 0;
  look_along(work, normal);
}

void
sg_work_close(sg_work *work)
{
  if (work) {
    clear_points(work);
    close_indexes(work);
    free(work->vertex);
    sg_key_table_clear(&work->ids);
    sg_work_pairs_clear(work);
    free(work->edge);
    free(work);
  }
}

void
sg_work_guard_by(sg_work *work, sg_work_guard *guard)
{
  work->guard = guard;
}

bool
sg_work_is_guarded(const sg_work *work)
{
  return work->guard != NULL;
}

sg_work_end
sg_work_ended(const sg_work *work)
{
  return work->guard ? work->guard->end : SG_GOES_ON;
}

enum { STEPS_AN_ASK = 1 << 14 };

bool
sg_work_guard_ask(sg_work_guard *guard)
{
  if (guard->end == SG_GOES_ON && guard->steps > guard->most) {
    guard->end = SG_TOOK_TOO_MUCH;
  } else if (guard->end == SG_GOES_ON && sg_cancelled(guard->cancel)) {
    guard->end = SG_WAS_STOPPED;
  }
  if (guard->end != SG_GOES_ON) {
    guard->next = 0; /* each one asks, and is told */
    return false;
  }
  guard->next = guard->steps + STEPS_AN_ASK;
  return true;
}

int
sg_work_axis(const sg_work *work)
{
  return work->axis;
}

bool
sg_work_expect(sg_work *work, size_t vertices, size_t edges)
{
  return sg_list_need(&work->vertex, vertices, &work->vertex_room,
                      sizeof *work->vertex) &&
         sg_list_need(&work->edge, edges + 1, &work->edge_room,
                      sizeof *work->edge);
}

/* ---- vertices ----------------------------------------------------------- */

int32_t
sg_work_vertex(sg_work *work, int32_t id, const sg_point *point)
{
  int32_t found = sg_work_find(work, id);

  if (found != SG_WORK_NONE) {
    return found;
  }
  if (work->vertices >= MOST_ROWS ||
      !sg_list_grow(&work->vertex, (size_t)work->vertices, &work->vertex_room,
                    sizeof *work->vertex)) {
    return SG_WORK_NONE;
  }
  uint32_t *number = sg_key_table_put(&work->ids, &(uint32_t){(uint32_t)id});

  if (!number) {
    return SG_WORK_NONE;
  }
  *number = (uint32_t)work->vertices;
  sg_work_vertex_row *row = &work->vertex[work->vertices];
  *row = (sg_work_vertex_row){.id = id, .along = {SG_WORK_NONE, SG_WORK_NONE}};
  sg_point_copy(&row->point, point);
  row->at[work->flip < 0] = point->p[(work->axis + 1) % 3];
  row->at[work->flip > 0] = point->p[(work->axis + 2) % 3];
  return work->vertices++;
}

void
sg_work_note_along(sg_work *work, int32_t vertex, int32_t a, int32_t b)
{
  int32_t *along = work->vertex[vertex].along;

  if (along[0] == SG_WORK_NONE && vertex != a && vertex != b) {
    along[0] = a < b ? a : b;
    along[1] = a < b ? b : a;
  }
}

int32_t
sg_work_find(const sg_work *work, int32_t id)
{
  uint32_t found = sg_key_table_get(&work->ids, &(uint32_t){(uint32_t)id});

  return found == SG_NO_KEY ? SG_WORK_NONE : (int32_t)found;
}

int32_t
sg_work_id(const sg_work *work, int32_t vertex)
{
  return work->vertex[vertex].id;
}

const sg_point *
sg_work_point(const sg_work *work, int32_t vertex)
{
  return &work->vertex[vertex].point;
}

int32_t
sg_work_vertices(const sg_work *work)
{
  return work->vertices;
}

/* ---- edges -------------------------------------------------------------- */

static void
hang(sg_work *work, int32_t e)
{
  sg_work_edge_row *row = &work->edge[e];
  sg_work_vertex_row *start = &work->vertex[row->edge.start];
  sg_work_vertex_row *end = &work->vertex[row->edge.end];

  row->older = work->youngest;
  *(row->older ? &work->edge[row->older].younger : &work->oldest) = e;
  work->youngest = e;
  row->out_older = start->last_out;
  *(row->out_older ? &work->edge[row->out_older].out_younger
                   : &start->first_out) = e;
  start->last_out = e;
  row->in_older = end->last_in;
  *(row->in_older ? &work->edge[row->in_older].in_younger : &end->first_in) = e;
  end->last_in = e;
}

static void
unhang(sg_work *work, int32_t e)
{
  sg_work_edge_row *row = &work->edge[e], *edge = work->edge;
  sg_work_vertex_row *start = &work->vertex[row->edge.start];
  sg_work_vertex_row *end = &work->vertex[row->edge.end];

  *(row->older ? &edge[row->older].younger : &work->oldest) = row->younger;
  *(row->younger ? &edge[row->younger].older : &work->youngest) = row->older;
  *(row->out_older ? &edge[row->out_older].out_younger : &start->first_out) =
      row->out_younger;
  *(row->out_younger ? &edge[row->out_younger].out_older : &start->last_out) =
      row->out_older;
  *(row->in_older ? &edge[row->in_older].in_younger : &end->first_in) =
      row->in_younger;
  *(row->in_younger ? &edge[row->in_younger].in_older : &end->last_in) =
      row->in_older;
}

/* Room for `n` more edges, so that adding them cannot fail. */
static bool
edge_room(sg_work *work, int32_t n)
{
  return work->edges < MOST_ROWS - n &&
         sg_list_need(&work->edge, (size_t)(work->edges + n) + 1,
                      &work->edge_room, sizeof *work->edge);
}

/* Is v a corner of the last triangle in whose way nothing was? */
static bool
is_proven(const sg_work *work, int32_t v)
{
  return v == work->proven[0] || v == work->proven[1] || v == work->proven[2];
}

/* A new edge may meet others and have a new vertex, unless it is a side of
 * that triangle, and not there yet. */
static void
note_added(sg_work *work, int32_t start, int32_t end)
{
  if (!(is_proven(work, start) && is_proven(work, end)) ||
      sg_work_pair(work, start, end)) {
    forget_proven(work);
    sg_work_grid_close(&work->ends);
    sg_work_places_clear(work);
    sg_work_tips_clear(work);
    if (work->simple == SG_SIMPLE) {
      work->simple = SG_NOT_ASKED;
    }
  }
}

int32_t
sg_work_add(sg_work *work, int32_t start, int32_t end, int32_t et,
            int64_t label)
{
  if (start == end) {
    return SG_WORK_NONE;
  }
  if (!edge_room(work, 1)) {
    return 0;
  }
  int32_t e = work->edges + 1;
  work->edge[e] =
      (sg_work_edge_row){.edge = {start, end, et, label}, .living = true};
  if (work->grid.open &&
      !sg_work_grid_add(&work->grid, e, work->vertex[start].at,
                        work->vertex[end].at)) {
    return 0;
  }
  note_added(work, start, end);
  if (work->pairs.open && !sg_work_pairs_add(work, e)) {
    return 0;
  }
  work->edges = e;
  work->living++;
  hang(work, e);
  return e;
}

void
sg_work_delete(sg_work *work, int32_t edge)
{
  unhang(work, edge);
  if (work->pairs.open) {
    sg_work_pairs_drop(work, edge);
  }
  work->edge[edge].living = false; /* the grid drops it when it comes by */
  work->living--;
}

int32_t
sg_work_split(sg_work *work, int32_t edge, int32_t vertex)
{
  sg_work_edge old = work->edge[edge].edge;
  int32_t first = sg_work_add(work, old.start, vertex, old.et, old.label);

  if (!first) {
    return 0;
  }
  if (!sg_work_add(work, vertex, old.end, old.et, old.label)) {
    sg_work_delete(work, first);
    return 0;
  }
  sg_work_delete(work, edge);
  return first;
}

const sg_work_edge *
sg_work_get(const sg_work *work, int32_t edge)
{
  return edge > 0 && edge <= work->edges && work->edge[edge].living
             ? &work->edge[edge].edge
             : NULL;
}

size_t
sg_work_edges(const sg_work *work)
{
  return work->living;
}

int32_t
sg_work_newest(const sg_work *work)
{
  return work->edges;
}

int32_t
sg_work_next(const sg_work *work, int32_t edge)
{
  return edge ? work->edge[edge].younger : work->oldest;
}

int32_t
sg_work_leaving(const sg_work *work, int32_t vertex, int32_t edge)
{
  return edge ? work->edge[edge].out_younger : work->vertex[vertex].first_out;
}

int32_t
sg_work_entering(const sg_work *work, int32_t vertex, int32_t edge)
{
  return edge ? work->edge[edge].in_younger : work->vertex[vertex].first_in;
}

/* ---- signs -------------------------------------------------------------- */

/* Is v known to be on the line of this vertex? */
static bool
is_along(const sg_work *work, const sg_work_vertex_row *of, int32_t v)
{
  const int32_t *other = work->vertex[v].along;

  return v == of->along[0] || v == of->along[1] ||
         (other[0] == of->along[0] && other[1] == of->along[1]);
}

/* Are they known to be in line? Points on an edge are, however they were
 * made. */
static bool
are_in_line(const sg_work *work, int32_t a, int32_t b, int32_t c)
{
  const int32_t of[3] = {a, b, c};

  for (int i = 0; i < 3; i++) {
    const sg_work_vertex_row *row = &work->vertex[of[i]];

    if (row->along[0] != SG_WORK_NONE) {
      return is_along(work, row, of[(i + 1) % 3]) &&
             is_along(work, row, of[(i + 2) % 3]);
    }
  }
  return false;
}

int
sg_work_turn(const sg_work *work, int32_t a, int32_t b, int32_t c)
{
  const sg_work_vertex_row *v = work->vertex;

  if (!v[a].point.exactly && !v[b].point.exactly && !v[c].point.exactly) {
    return sg_orient2d(v[a].at, v[b].at, v[c].at);
  }
  if (are_in_line(work, a, b, c)) {
    return 0;
  }
  return work->flip *
         sg_point_turn(work->axis, &v[a].point, &v[b].point, &v[c].point);
}

/* v strictly between a and b in coordinate axis k of the picture: -1, 0, +1
 * for outside, at one of them, inside. */
static int
between_on_axis(const sg_work *work, int k, int32_t a, int32_t b, int32_t v)
{
  int axis = (work->axis + 1 + (k ^ (work->flip < 0))) % 3;
  const sg_work_vertex_row *row = work->vertex;
  int low = sg_point_compare(axis, &row[a].point, &row[v].point);
  int high = sg_point_compare(axis, &row[v].point, &row[b].point);

  return low == 0 || high == 0 ? 0 : (low == high ? 1 : -1);
}

/* In axis k of the picture: a strict < of roundings is exact. */
static int
place_on_axis(const sg_work *work, int k, int32_t v, int32_t w)
{
  int axis = (work->axis + 1 + (k ^ (work->flip < 0))) % 3;
  const sg_work_vertex_row *a = &work->vertex[v], *b = &work->vertex[w];

  if (a->at[k] != b->at[k]) {
    return a->at[k] < b->at[k] ? -1 : 1;
  }
  return sg_point_compare(axis, &a->point, &b->point);
}

int
sg_work_place(const sg_work *work, int32_t v, int32_t w)
{
  int order = place_on_axis(work, 0, v, w);

  return order ? order : place_on_axis(work, 1, v, w);
}

bool
sg_work_inside(const sg_work *work, int32_t a, int32_t b, int32_t v)
{
  int along = between_on_axis(work, 0, a, b, v);

  return along ? along > 0 : between_on_axis(work, 1, a, b, v) > 0;
}

bool
sg_work_between(const sg_work *work, int32_t a, int32_t b, int32_t v)
{
  return sg_work_turn(work, a, b, v) == 0 && sg_work_inside(work, a, b, v);
}

/* ---- searching by place ------------------------------------------------- */

sg_work_grid_segment *
sg_work_segments(const sg_work *work)
{
  sg_work_grid_segment *out = malloc(work->living * sizeof *out);
  size_t n = 0;

  for (int32_t e = work->oldest; out && e; e = work->edge[e].younger) {
    const sg_work_edge *edge = &work->edge[e].edge;
    memcpy(out[n].from, work->vertex[edge->start].at, sizeof out[n].from);
    memcpy(out[n].to, work->vertex[edge->end].at, sizeof out[n].to);
    n++;
  }
  return out;
}

double
sg_work_error(const sg_work *work)
{
  double largest = 0;

  for (int32_t v = 0; v < work->vertices; v++) {
    largest = fmax(largest, fmax(fabs(work->vertex[v].at[0]),
                                 fabs(work->vertex[v].at[1])));
  }
  return largest * DBL_EPSILON;
}

static bool
build_grid(sg_work *work)
{
  sg_work_grid_segment *segment = sg_work_segments(work);

  sg_work_grid_close(&work->grid);
  if (!segment || !sg_work_grid_open(&work->grid, SG_GRID_OF_SEGMENTS, segment,
                                     work->living, sg_work_error(work))) {
    free(segment);
    return false;
  }
  size_t n = 0;
  for (int32_t e = work->oldest; e; e = work->edge[e].younger, n++) {
    if (!sg_work_grid_add(&work->grid, e, segment[n].from, segment[n].to)) {
      sg_work_grid_close(&work->grid);
      break;
    }
  }
  free(segment);
  sg_work_grid_filled(&work->grid);
  return work->grid.open;
}

/* Are there so many edges that the grid serves? Builds it or builds it anew
 * when it is missing or stale. *served tells; false: no memory. */
static bool
make_ready(sg_work *work, bool *served)
{
  const sg_work_grid *grid = &work->grid;
  size_t living = work->living;

  *served = living > SG_WORK_FEW;
  if (!*served || (grid->open && grid->held <= 2 * living + SG_WORK_FEW &&
                   !sg_work_grid_is_stale(grid))) {
    return true;
  }
  return build_grid(work);
}

bool
sg_work_scan_open(sg_work_scan *scan, sg_work *work, const int32_t *corner,
                  int corners)
{
  *scan = (sg_work_scan){.work = work};
  if (!make_ready(work, &scan->served)) {
    return false;
  }
  if (scan->served) {
    double at[3][2];
    for (int i = 0; i < corners; i++) {
      memcpy(at[i], work->vertex[corner[i]].at, sizeof at[i]);
    }
    sg_work_grid_walk_open(&scan->walk, &work->grid, (const double(*)[2])at,
                           corners);
    work->search++;
  }
  return true;
}

int32_t
sg_work_scan_next(sg_work_scan *scan)
{
  if (!scan->served) {
    scan->edge = sg_work_next(scan->work, scan->edge);
    return scan->edge;
  }
  for (int32_t e; (e = sg_work_grid_walk_next(&scan->walk)) != 0 &&
                  sg_work_step(scan->work, 1);) {
    sg_work_edge_row *row = &scan->work->edge[e];
    if (!row->living) {
      sg_work_grid_walk_drop(&scan->walk);
    } else if (row->seen != scan->work->search) {
      row->seen = scan->work->search;
      return e;
    }
  }
  return 0;
}
