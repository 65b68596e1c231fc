#include "outline.h"

#include "bvh_join.h"
#include "engine/search.h"
#include "number/exact.h"

#include <math.h>
#include <stdlib.h>

typedef struct flat {
  const sg_flat_loops *loops;
  size_t *loop;     /* [points] whose point it is, and the edge from there */
  sg_box *box;      /* [points] of edges, */
  sg_box *loop_box; /* [n] of loops, */
  sg_box *ray;      /* [n] from the first point of each to the right */
  sg_bvh *edges, *rays;
  sg_bvh_hits hits;
  bool meet;
} flat;

/* ---- edges ---- */

static size_t
next_of(const flat *f, size_t i)
{
  const size_t *begin = &f->loops->begin[f->loop[i]];

  return i + 1 < begin[1] ? i + 1 : begin[0];
}

static double
low(double a, double b)
{
  return a < b ? a : b;
}

static double
high(double a, double b)
{
  return a > b ? a : b;
}

/* Whether q and r, which are in line with p, lie on one side of it. */
static bool
folds_back(const double p[2], const double q[2], const double r[2])
{
  int c = p[0] == q[0];

  return sg_orient2d(p, q, r) == 0 && (q[c] > p[c]) == (r[c] > p[c]) &&
         r[c] != p[c];
}

static bool
ranges_meet(const double a[2], const double b[2], const double c[2],
            const double d[2], int k)
{
  return high(a[k], b[k]) >= low(c[k], d[k]) &&
         high(c[k], d[k]) >= low(a[k], b[k]);
}

/* Whether edges i and j have more in common than neighbours have. */
static bool
edges_meet(const flat *f, size_t i, size_t j)
{
  size_t after_i = next_of(f, i), after_j = next_of(f, j);
  const double *a = f->loops->at[i], *b = f->loops->at[after_i];
  const double *c = f->loops->at[j], *d = f->loops->at[after_j];

  if (after_i == j) {
    return folds_back(b, a, d);
  }
  if (after_j == i) {
    return folds_back(d, c, b);
  }
  return ranges_meet(a, b, c, d, 0) && ranges_meet(a, b, c, d, 1) &&
         sg_orient2d(a, b, c) * sg_orient2d(a, b, d) <= 0 &&
         sg_orient2d(c, d, a) * sg_orient2d(c, d, b) <= 0;
}

/* Nobody need ask after the first two that meet. */
static bool
note_meeting(void *data, const sg_bvh_hit *hit)
{
  flat *f = data;

  f->meet =
      f->meet || edges_meet(f, f->edges->item[hit->a], f->edges->item[hit->b]);
  return false;
}

/* ---- rays ---- */

static bool
is_round(const sg_box *box, const double p[2])
{
  return box->lo[0] <= p[0] && p[0] <= box->hi[0] && box->lo[1] <= p[1] &&
         p[1] <= box->hi[1];
}

/* Whether the ray of a loop crosses an edge of another one that may be round
 * it. Edges are half open, so a corner counts once. */
static bool
crosses(void *data, const sg_bvh_hit *hit)
{
  const flat *f = data;
  size_t k = f->rays->item[hit->a], e = f->edges->item[hit->b];
  const double *p = f->loops->at[f->loops->begin[k]];
  const double *a = f->loops->at[e], *b = f->loops->at[next_of(f, e)];

  if (f->loop[e] == k || !is_round(&f->loop_box[f->loop[e]], p)) {
    return false;
  }
  return (a[1] <= p[1] && p[1] < b[1] && sg_orient2d(a, b, p) > 0) ||
         (b[1] <= p[1] && p[1] < a[1] && sg_orient2d(a, b, p) < 0);
}

/* The loop of the edge in place of its hit. */
SG_ORDER(compare_hits, sg_bvh_hit, SG_BY(a) SG_BY(b));

/* Every loop but the first is in the first alone: what its ray crosses oddly
 * often is round it. */
static bool
are_holes(flat *f)
{
  size_t in_first = 0;
  bool good = true;

  for (size_t i = 0; i < f->hits.n; i++) {
    sg_bvh_hit *hit = &f->hits.hit[i];

    hit->a = f->rays->item[hit->a];
    hit->b = (uint32_t)f->loop[f->edges->item[hit->b]];
  }
  if (f->hits.n > 0) {
    qsort(f->hits.hit, f->hits.n, sizeof *f->hits.hit, compare_hits);
  }
  for (size_t i = 0, end; i < f->hits.n && good; i = end) {
    const sg_bvh_hit *hit = &f->hits.hit[i];

    for (end = i; end < f->hits.n && compare_hits(hit, &f->hits.hit[end]) == 0;
         end++) {
    }
    bool inside = (end - i) % 2 == 1;

    good = !inside || (hit->b == 0 && hit->a != 0);
    in_first += inside && hit->b == 0;
  }
  return good && in_first + 1 == f->loops->n;
}

/* ---- the whole ---- */

static void
add_point(sg_box *box, const double p[2])
{
  sg_box_add(box, (double[3]){p[0], p[1], 0});
}

static bool
lay_out(flat *f, const sg_cancel *cancel)
{
  const sg_flat_loops *loops = f->loops;
  size_t points = loops->begin[loops->n];
  sg_box all = sg_box_none();

  f->loop = malloc((points + 1) * sizeof *f->loop);
  f->box = malloc((points + 1) * sizeof *f->box);
  f->loop_box = malloc((loops->n + 1) * sizeof *f->loop_box);
  f->ray = malloc((loops->n + 1) * sizeof *f->ray);
  if (!f->loop || !f->box || !f->loop_box || !f->ray) {
    return false;
  }
  for (size_t k = 0; k < loops->n; k++) {
    f->loop_box[k] = sg_box_none();
    for (size_t i = loops->begin[k]; i < loops->begin[k + 1]; i++) {
      f->loop[i] = k;
      f->box[i] = sg_box_none();
      add_point(&f->box[i], loops->at[i]);
      add_point(&f->box[i], loops->at[next_of(f, i)]);
      sg_box_join(&f->loop_box[k], &f->box[i]);
    }
    sg_box_join(&all, &f->loop_box[k]);
  }
  for (size_t k = 0; k < loops->n; k++) {
    f->ray[k] = sg_box_none();
    add_point(&f->ray[k], loops->at[loops->begin[k]]);
    f->ray[k].hi[0] = all.hi[0];
  }
  f->edges = sg_bvh_open(f->box, points, cancel);
  f->rays = sg_bvh_open(f->ray, loops->n, cancel);
  return f->edges && f->rays;
}

static void
clear(flat *f)
{
  free(f->loop);
  free(f->box);
  free(f->loop_box);
  free(f->ray);
  free(f->hits.hit);
  sg_bvh_close(f->edges);
  sg_bvh_close(f->rays);
}

bool
sg_flat_loops_are_sound(const sg_flat_loops *loops, const sg_cancel *cancel,
                        bool *sound)
{
  flat f = {.loops = loops};
  bool done = lay_out(&f, cancel) &&
              sg_bvh_join_wanted(&(sg_bvh_pair){f.edges, f.edges}, 1, 0,
                                 note_meeting, &f, NULL, cancel, &f.hits);

  free(f.hits.hit);
  f.hits = (sg_bvh_hits){0};
  done = done &&
         (f.meet || sg_bvh_join_wanted(&(sg_bvh_pair){f.rays, f.edges}, 1, 0,
                                       crosses, &f, NULL, cancel, &f.hits));
  *sound = done && !f.meet && are_holes(&f);
  clear(&f);
  return done;
}
