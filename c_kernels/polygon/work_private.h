/* work_private.h -- inside the scratch relation: for work*.c only. */
#ifndef SG_WORK_PRIVATE_H
#define SG_WORK_PRIVATE_H

#include "work.h"

#include "rows/key_table.h"
#include "work_grid.h"
#include "work_tree.h"

/* `at` is the picture: seen from outside, counter-clockwise is left. Rounded
 * for derived points; rounding keeps order, so a strict < of two is exact. */
typedef struct sg_work_vertex_row {
  double at[2];
  sg_point point;
  int32_t id;
  int32_t along[2]; /* it lies on the line through these, or SG_WORK_NONE */
  int32_t first_out, last_out, first_in, last_in; /* edges, 0 none */
} sg_work_vertex_row;

typedef struct sg_work_edge_row {
  sg_work_edge edge;
  int32_t older, younger;           /* in the queue of all */
  int32_t out_older, out_younger;   /* among those leaving `start` */
  int32_t in_older, in_younger;     /* among those entering `end` */
  int32_t pair_older, pair_younger; /* in its ring, when pairs are open */
  uint32_t seen;                    /* by the search of this number */
  bool living;
} sg_work_edge_row;

/* Edges with the same two ends, the same way round, in a ring that the oldest
 * begins. `first` has those rings, by start and end. */
typedef struct sg_work_pairs {
  bool open;
  sg_key_table first; /* the oldest one's handle; 0: none is left */
} sg_work_pairs;

struct sg_work {
  int axis; /* dropped */
  int flip; /* +1: the normal points along the axis, -1: against it */
  sg_work_vertex_row *vertex; /* [vertices] */
  int32_t vertices;
  size_t vertex_room;
  sg_key_table ids; /* to their vertices */
  sg_work_pairs pairs;
  sg_work_guard *guard;   /* or null */
  int32_t crossed[2];     /* edges that cross, or 0 */
  sg_work_edge_row *edge; /* [edges], [0] unused */
  int32_t edges;
  size_t edge_room;
  int32_t oldest, youngest;
  size_t living;
  uint32_t search;   /* the number of the last one */
  sg_work_grid grid; /* of living edges, when grid.open */
  sg_work_grid ends; /* of vertices that have edges, + 1, when ends.open */
  size_t looked;     /* at edges, vertices and rings, by sg_candidates_next() */
  sg_work_forest *forest; /* of living edges; null: none */
  sg_work_tree tips;      /* of the vertices that can be in an ear, when */
  size_t tipped;          /* > 0: the edges that there were then */
  sg_work_tree places;    /* of the vertices in `ends`, when planted */
  bool planted, rounded;  /* the second: a vertex there is */
  enum { SG_NOT_ASKED, SG_SIMPLE, SG_NOT_SIMPLE } simple;
  bool orderly;      /* and if simple: the inside is left of every edge */
  int32_t proven[3]; /* the last triangle in whose way nothing was */
};

enum { SG_WORK_FEW = 48 }; /* so few edges are searched without a grid */

static inline bool
sg_work_has_edges(const sg_work *work, int32_t v)
{
  return work->vertex[v].first_out || work->vertex[v].first_in;
}

bool sg_work_guard_ask(sg_work_guard *guard);

/* n steps more. False: it has ended. */
static inline bool
sg_work_step(const sg_work *work, size_t n)
{
  sg_work_guard *guard = work->guard;

  return !guard || (guard->steps += n) < guard->next ||
         sg_work_guard_ask(guard);
}

void sg_work_pairs_clear(sg_work *work);
/* A new edge, a living one that goes. The first is false: no memory. */
bool sg_work_pairs_add(sg_work *work, int32_t e);
void sg_work_pairs_drop(sg_work *work, int32_t e);

/* All living edges as segments [living]; null: no memory. Owner: caller. */
sg_work_grid_segment *sg_work_segments(const sg_work *work);

/* Bounds the rounding errors of the picture's coordinates. */
double sg_work_error(const sg_work *work);

/* v strictly between a and b, where it is known to be on their line. Exact. */
bool sg_work_inside(const sg_work *work, int32_t a, int32_t b, int32_t v);

/* The order of places: along the picture's first axis, then the second. Exact;
 * 0: one place. */
int sg_work_place(const sg_work *work, int32_t v, int32_t w);

/* Fills `out` (room for all vertices) with those that have edges, by place,
 * then by handle. Returns how many. */
int32_t sg_work_by_place(sg_work *work, int32_t *out);

/* Does edge e meet the segment v1-v2 other than in a shared end? Exact. */
bool sg_work_meets(const sg_work *work, int32_t v1, int32_t v2, int32_t e);

/* work_simple.c: the relation is simple if edges meet in shared vertices only;
 * opposite edges may lie on each other. It is orderly if there are none of
 * these and every edge has the inside on its left. sg_work_note_simple() finds
 * out, given what sg_work_by_place() gave (vertices without edges may be among
 * them). sg_work_is_simple() finds out when it is not known. No memory counts
 * as not simple: then the other way is gone, which can tell. */
void sg_work_note_simple(sg_work *work, const int32_t *vertex, int32_t n);
bool sg_work_is_simple(sg_work *work);

/* Of vertices as sg_work_by_place() gave them: notes in work->crossed two edges
 * that cross where no vertex is, if the first edges met by a line that sweeps
 * over them do. */
void sg_work_note_crossed(sg_work *work, const int32_t *vertex, int32_t n);

/* The same vertices. around[e]: how often the edges go round what is beyond e,
 * of one edge for each two ends; the others are left alone. On this side of a
 * pair of opposite edges it is as often. Pairs are open. False: edges meet not
 * in ends alone, or no memory. */
bool sg_work_windings(sg_work *work, const int32_t *vertex, int32_t n,
                      int32_t *around);

/* An edge of a vertex that has one: what is asked for there mostly lies along
 * it, so trees of vertices are halved across it. */
sg_work_grid_segment sg_work_side_of(const sg_work *work, int32_t v);

/* Builds the grid of the vertices that have edges, if it is missing or most of
 * them are gone. False: no memory. */
bool sg_work_ends_ready(sg_work *work);

/* Of a simple relation and a triangle, counter-clockwise, that has edge v1-v2
 * and another edge for sides: is anything in its way? No edge can cross it, so
 * something is only if a vertex is in it, or if an edge goes into it from one
 * of its corners. If the relation is also orderly, then one of these vertices
 * is reflex. *no_memory is set, or left alone. */
bool sg_work_occupied(sg_work *work, const int32_t corner[3], bool *no_memory);

/* The edges that may meet a convex piece of the picture (a point, a segment, a
 * triangle), each once: all of them when there are few. */
typedef struct sg_work_scan {
  sg_work *work;
  bool served;
  sg_work_grid_walk walk;
  int32_t edge;
} sg_work_scan;

bool sg_work_scan_open(sg_work_scan *scan, sg_work *work, const int32_t *corner,
                       int corners);
int32_t sg_work_scan_next(sg_work_scan *scan); /* 0: no more */

/* Whether so much was looked at that trees are worth while (work_tree.h). */
static inline bool
sg_work_looked_far(const sg_work *work)
{
  return work->looked > 16 * (size_t)work->edges + 1024;
}

/* Does so much hang on a vertex that trees have it by angle? */
bool sg_work_is_hub(const sg_work *work, int32_t v);

/* Whether an edge is in the way. */
typedef bool sg_work_in_way(void *data, int32_t edge);

sg_work_corners sg_work_corners_of(const sg_work *work,
                                   const int32_t corner[3]);
void sg_work_forest_close(sg_work *work);
/* *found: a living edge that is in the way, of those near the triangle, which
 * is counter-clockwise; 0: none is. False: no memory. */
bool sg_work_forest_find(sg_work *work, const int32_t corner[3],
                         sg_work_in_way *in_way, void *data, int32_t *found);

/* The vertices that are asked for as third ones of v1-v2: round a cell of
 * `ends`. */
enum { SG_WORK_BLOCKERS = 12 };

typedef struct sg_work_ring {
  int32_t v1, v2, centre[2];
  int32_t blocker[SG_WORK_BLOCKERS]; /* [blockers]: living edges */
  int blockers;
  /* Given a vertex; nearer: what it was given before is no more in the ring.
   * False: an end of the search. */
  bool (*found)(void *data, int32_t v, bool nearer);
  void *data;
} sg_work_ring;

/* *ring: the first from *ring on, of rings of cells round the centre, that may
 * have such a vertex, with those that it may have given to found(); INT32_MAX:
 * there is none. `ends` are ready. False: no memory. */
bool sg_work_next_ring(sg_work *work, const sg_work_ring *of, int32_t *ring);
/* When `ends` are closed, when a new vertex may be there. */
void sg_work_places_clear(sg_work *work);
void sg_work_tips_clear(sg_work *work);

/* False if v is certainly not on the edge: a cheap question first. */
bool sg_work_near(const sg_work *work, int32_t edge, int32_t v);

/* Hangs the edges of `from` on `to`, in the same place; one that becomes a
 * point vanishes. False: no memory. */
bool sg_work_move_edges(sg_work *work, int32_t from, int32_t to);

/* Vertices nearer than `reach` become one, edges are split at vertices nearer
 * than that. False: no memory. */
bool sg_work_join_near(sg_work *work, double reach);

/* Do two edges cross in one point inside both, which is no vertex that has
 * edges? Exact. */
bool sg_work_crosses(const sg_work *work, int32_t e, int32_t other);

bool sg_meetings_push(sg_meetings *out, const sg_meeting *met);
void sg_meetings_sort(sg_meetings *met); /* by edge */

#endif
