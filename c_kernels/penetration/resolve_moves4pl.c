/* resolve_moves4pl.c -- how far things move that are made to touch: see
 * resolve4pl.h.
 *
 * Layer: glue.
 */
#include "resolve4pl.h"

#include "glue.h"

#include <math.h>
#include <stdlib.h>

/* Of moves no larger nothing is said: 2^-UNSAID of the coordinates, a few
 * thousand units in the last place of doubles. */
enum { UNSAID = 40 };

/* Of an sg_resolve_trees. */
static const sg_leaf_tree *
tree_of(const void *data, int32_t s, bool *itself)
{
  const sg_resolving *job = data;
  const sg_cut_handle *handle = job->handle;
  *itself = false;
  for (size_t i = 0; i < job->part.n; i++) {
    *itself = *itself || job->part.item[i].s == s;
  }
  return handle->tree[sg_cut_place_of(handle, s)]->tree;
}

int
sg_resolving_measure_ex(sg_resolving *job)
{
  const sg_cut_handle *handle = job->handle;
  const sg_resolve_trees trees = {handle->segment, handle->segments, tree_of,
                                  job};
  sg_crew *crew = sg_crew_open(0);
  int done = crew && sg_resolve_measure(&job->r, &trees, &handle->views, crew,
                                        &sg_prolog_poll, &job->moves);

  sg_crew_close(crew);
  return done || (!PL_exception(0) && sg_no_memory());
}

/* The first two segments that have the point; the second is 0 if there is no
 * other. */
static void
segments_at(const sg_resolve *r, uint32_t point, int32_t out[2])
{
  out[0] = out[1] = 0;
  for (size_t i = 0; i < r->place.n && out[1] == 0; i++) {
    if (r->place.item[i].point == point && r->place.item[i].s != out[0]) {
      out[out[0] != 0] = r->place.item[i].s;
    }
  }
}

/* Name(S1, S2, X, Y, Z, Move, Feature, Count) */
static int
unify_move(term_t t, const sg_resolving *job, const char *name, uint32_t point,
           double move, double feature, size_t count)
{
  const double *at = job->r.point.item[point].at;
  int32_t s[2];

  segments_at(&job->r, point, s);
  return PL_unify_term(t, PL_FUNCTOR_CHARS, name, 8, PL_INT, s[0], PL_INT, s[1],
                       PL_FLOAT, at[0] + 0.0, PL_FLOAT, at[1] + 0.0, PL_FLOAT,
                       at[2] + 0.0, PL_FLOAT, move, PL_FLOAT, feature, PL_INT64,
                       (int64_t)count);
}

int
sg_resolving_unify_moves(const sg_resolving *job, term_t t)
{
  const sg_resolve_moves *moves = &job->moves;
  double largest = 0;

  if (moves->tight > 0) {
    return unify_move(t, job, "tight", moves->tight_point, moves->move,
                      moves->feature, moves->tight);
  }
  for (size_t i = 0; i < 3 * job->r.point.n; i++) {
    largest = fmax(largest, fabs(job->r.point.item[i / 3].at[i % 3]));
  }
  return moves->farthest > ldexp(largest, -UNSAID)
             ? unify_move(t, job, "moved", moves->point, moves->farthest, 0,
                          job->r.point.n)
             : PL_unify_atom_chars(t, "little");
}
