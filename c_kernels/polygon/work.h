/* work.h -- the scratch relation: the directed edges of ONE polygon.
 *
 * Layer: kernel. While a polygon is triangulated (PL-6) or takes in the cuts
 * of a penetration (PL-8, PL-9), its edges live here: added, deleted, found by
 * vertex or by pair, oldest first, and indexed by a grid over the polygon's
 * plane. Loops, holes and islands need no special form; a cut inside the
 * polygon (a seam) is a pair of opposite edges.
 *
 * The polygon is seen from outside and along the axis of the largest
 * component of its normal (the two other coordinates remain). In that picture
 * every decision is EXACT, on doubles and on derived points alike; it is the
 * truth also for a polygon that is not quite flat.
 *
 * Vertices are handles 0, 1, 2, ... in the order of entering, edges are
 * handles 1, 2, 3, ...; an edge's handle is never used again. A vertex has an
 * id (the store's V) and a point. Nothing here is safe for two threads.
 *
 *   sg_work *work = sg_work_open(normal);
 *   int32_t a = sg_work_vertex(work, 7, &point7);
 *   ...
 *   int32_t e = sg_work_add(work, a, b, 1, 0);
 *   sg_meetings met = {0};
 *   if (!sg_work_meeting(work, u, v, &met)) no_memory();
 *   for (size_t i = 0; i < met.n; i++) use(met.item[i]);
 *   sg_meetings_clear(&met);
 *   sg_work_close(work);
 */
#ifndef SG_WORK_H
#define SG_WORK_H

#include "engine/cancel.h"
#include "number/exact.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_work sg_work;

enum { SG_WORK_NONE = -1 }; /* no such vertex, or no memory */

/* An edge. `label` is the caller's (0: none; > 0: the row of e/5 it came from)
 * and goes with the pieces when an edge is split. */
typedef struct sg_work_edge {
  int32_t start, end; /* vertex handles */
  int32_t et;         /* 1 real, 0 auxiliary */
  int64_t label;
} sg_work_edge;

/* Null: no memory. `normal` is finite and not (0,0,0); its length does not
 * matter. */
sg_work *sg_work_open(const double normal[3]);
void sg_work_close(sg_work *work);
/* Empties it for another polygon: as closing and opening, without the cost. */
void sg_work_clear(sg_work *work, const double normal[3]);

/* Room for so many of them in all, at once. False: no memory. */
bool sg_work_expect(sg_work *work, size_t vertices, size_t edges);

/* How far the work on polygons may go, and how far it went. A step is a look at
 * an edge or a vertex. It asks `cancel`, too. Once it has ended, searches find
 * nothing, and nothing that they answered means anything. */
typedef enum sg_work_end {
  SG_GOES_ON,
  SG_WAS_STOPPED,
  SG_TOOK_TOO_MUCH /* more than `most` steps */
} sg_work_end;

typedef struct sg_work_guard {
  const sg_cancel *cancel;
  size_t most, steps, next; /* next: when it asks again; begins with 0 */
  size_t polled;            /* how often what is no step might have asked */
  sg_work_end end;
} sg_work_guard;

/* Borrows a guard, until the work is closed or has another; null: none. */
void sg_work_guard_by(sg_work *work, sg_work_guard *guard);
bool sg_work_is_guarded(const sg_work *work);
sg_work_end sg_work_ended(const sg_work *work); /* without one it goes on */

/* The axis that is dropped (0 x, 1 y, 2 z), for sg_point_ll(). */
int sg_work_axis(const sg_work *work);

/* Enters a vertex, copying its point (derived coordinates too), or returns the
 * handle that already has this id (`point` is then not looked at).
 * SG_WORK_NONE: no memory. id > 0. */
int32_t sg_work_vertex(sg_work *work, int32_t id, const sg_point *point);
/* Says that a vertex lies exactly on the line through a and b, a != b: turns of
 * points on that line then need no arithmetic. The first word counts. */
void sg_work_note_along(sg_work *work, int32_t vertex, int32_t a, int32_t b);
int32_t sg_work_find(const sg_work *work, int32_t id); /* or SG_WORK_NONE */
int32_t sg_work_id(const sg_work *work, int32_t vertex);
const sg_point *sg_work_point(const sg_work *work, int32_t vertex);
int32_t sg_work_vertices(const sg_work *work); /* how many handles */

/* Adds edge start -> end as the youngest; returns its handle, 0: no memory.
 * From a vertex to itself there is no edge: SG_WORK_NONE. The same edge may be
 * added twice (a bad polygon). */
int32_t sg_work_add(sg_work *work, int32_t start, int32_t end, int32_t et,
                    int64_t label);
/* Deletes a living edge. */
void sg_work_delete(sg_work *work, int32_t edge);
/* Replaces an edge by its two pieces through `vertex`, which the caller knows
 * to lie on it. Returns the handle of the first piece (start -> vertex), the
 * second has the next one; 0: no memory, and nothing changed. */
int32_t sg_work_split(sg_work *work, int32_t edge, int32_t vertex);

/* Null if no living edge has this handle. Valid until the next change. */
const sg_work_edge *sg_work_get(const sg_work *work, int32_t edge);
size_t sg_work_edges(const sg_work *work); /* how many are living */

/* The handle given out last, 0: none yet. */
int32_t sg_work_newest(const sg_work *work);

/* The next living edge, oldest first, after `edge` (0: the oldest of all);
 * 0: there is none. `edge` itself must be living or 0. */
int32_t sg_work_next(const sg_work *work, int32_t edge);
/* The same among those leaving, and those entering, a vertex. */
int32_t sg_work_leaving(const sg_work *work, int32_t vertex, int32_t edge);
int32_t sg_work_entering(const sg_work *work, int32_t vertex, int32_t edge);
/* The oldest living edge start -> end, 0: none. */
int32_t sg_work_pair(const sg_work *work, int32_t start, int32_t end);

/* Makes that quick where edges are many. False: no memory. */
bool sg_work_pairs_ready(sg_work *work);

/* The turn a, b, c seen from outside: +1 left. Exact. */
int sg_work_turn(const sg_work *work, int32_t a, int32_t b, int32_t c);
/* True if vertex v lies on the open segment a-b. Exact. */
bool sg_work_between(const sg_work *work, int32_t a, int32_t b, int32_t v);

/* How an edge meets the segment v1-v2. */
typedef enum sg_how {
  SG_CROSSES,   /* in one point inside both */
  SG_TOUCHES,   /* in one point, an end of at least one of them */
  SG_CONTAINED, /* the whole segment lies on the edge */
  SG_OVERLAPS   /* on one line, with some length but not the whole segment
                   in common */
} sg_how;

enum {                      /* sg_meeting.inside: bits */
       SG_V1_INSIDE = 1,    /* v1 lies inside the edge: split the edge there */
       SG_V2_INSIDE = 2,    /* v2 does */
       SG_START_INSIDE = 4, /* the edge's start lies inside v1-v2: split that */
       SG_END_INSIDE = 8,   /* the edge's end does */
       /* An end of each in the same place, but with another id (not shared): */
       SG_V1_AT_START = 16,
       SG_V1_AT_END = 32,
       SG_V2_AT_START = 64,
       SG_V2_AT_END = 128
};

typedef struct sg_meeting {
  int32_t edge;
  sg_how how;
  unsigned inside;
} sg_meeting;

typedef struct sg_meetings {
  sg_meeting *item; /* [n], by edge handle */
  size_t n, room;
} sg_meetings;

/* The edges that meet segment v1-v2 other than in a shared end vertex, oldest
 * first. Both edges of a pair are listed. Exact. Replaces the content of
 * `out`; false: no memory. Owner of out->item: caller, sg_meetings_clear(). */
bool sg_work_meeting(sg_work *work, int32_t v1, int32_t v2, sg_meetings *out);
void sg_meetings_clear(sg_meetings *met);
/* Is there one, other than those that end in vertex `but`? 1: there is, 0:
 * there is none; -1: no memory. Exact. */
int sg_work_meeting_but(sg_work *work, int32_t v1, int32_t v2, int32_t but);

/* PL-6 steps 3, 4 (I) and 4 (II) as one join: the third vertices V3 of edge
 * v1 -> v2, each once. Ends of edges leaving v2 first, then starts of edges
 * entering v1, then all other vertices of edges, nearest first. (I): V3 lies
 * to the left of v1 -> v2. (II): no edge meets the CLOSED triangle except in
 * its corners, save those along its three sides (either way). Exact.
 *
 *   sg_candidates walk;
 *   sg_candidates_open(&walk, work, v1, v2);
 *   while ((v3 = sg_candidates_next(&walk)) >= 0) ...
 *   sg_candidates_close(&walk);
 *
 * The work must not change while a walk goes on. sg_candidates_next() returns
 * SG_WORK_NONE at the end; walk.no_memory tells if that was the reason. */
enum { SG_BLOCKERS = 4 };

typedef struct sg_candidates {
  sg_work *work;
  int32_t v1, v2;
  int phase;
  bool no_memory;
  int32_t edge;         /* the last one looked at in the phase */
  int32_t ring;         /* the next one of the last phase */
  struct sg_near *near; /* [n] of the ring, `next` to come */
  size_t next, n, room;
  int32_t blocker[SG_BLOCKERS]; /* edges in the way of earlier vertices */
  unsigned blocked;
} sg_candidates;

void sg_candidates_open(sg_candidates *walk, sg_work *work, int32_t v1,
                        int32_t v2);
int32_t sg_candidates_next(sg_candidates *walk);
void sg_candidates_close(sg_candidates *walk);

/* PL-6 step 4 (3) for the triangle v1, v2, v3 of the living edge `edge`
 * (v1 -> v2): deletes and adds edges; added ones are auxiliary, label 0.
 * Returns 1 done, 0 refused (3-5) with nothing changed, -1 no memory. */
int sg_work_take(sg_work *work, int32_t edge, int32_t v3);

/* Makes things that touch exactly meet in one vertex: vertices in one place
 * become the oldest of them, edges with a vertex inside are split there, and
 * pairs of opposite edges that came together so with no face on either side
 * vanish. Not needed (and does nothing) where all contacts are shared
 * vertices already. With reach > 0 (model units) also what is nearer than that
 * is made to touch first: this is for contacts that rounding has opened, when
 * the exact way got stuck. False: no memory. */
bool sg_work_resolve(sg_work *work, double reach);

/* After sg_work_resolve(): an edge that another one crosses, or 0. Then none of
 * the two is ever a side of a triangle. 0 may also mean that nobody looked. */
int32_t sg_work_crossed(const sg_work *work);
/* Whether edges meet in shared vertices only, and none is there twice, but for
 * edges in opposite directions. Exact; false also where there is no memory. */
bool sg_work_all_apart(sg_work *work);
/* Whether these two miss the ends of each other, and their crossing misses all
 * vertices, by more than 64 * reach: what is joined within reach leaves them
 * so.
 */
bool sg_work_crossed_by_far(const sg_work *work, double reach);

/* A vertex where as many edges enter as leave is in balance; returns the first
 * one that is not (the polygon does not close there), or SG_WORK_NONE. */
int32_t sg_work_unbalanced(const sg_work *work);

#endif
