/* regions_order.c -- pages at one edge that lie on each other
 * (regions_private.h).
 *
 * Within what turning and moving rounds (polygon/flatness.h) no sign says which
 * of them comes first. A region does that is beside one of them at another edge
 * too; so these edges wait for the others. Where no region does, the order of
 * signs stays, and of what is exactly in one place that of polygons' numbers,
 * at all edges alike.
 */
#include "regions_private.h"

#include "number/vector.h"
#include "rows/disjoint.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 4 }; /* pages on each other whose orders are all tried */

/* ---- which they are ---- */

/* How far point `p` is off the plane that has the edge from u and `normal`. */
static double
off_plane(const double *u, const double normal[3], const double p[3])
{
  double way[3];

  sg_minus(p, u, way);
  return fabs(sg_dot(normal, way)) / sg_length(normal);
}

static bool
lies_on(const sg_regions_maker *m, const sg_edge_group *group,
        const sg_page_at_edge *a, const sg_page_at_edge *b)
{
  const double *u = m->d->at[group->low], *w = m->d->at[group->high];
  double along[3], one[3], other[3], n1[3], n2[3];

  sg_minus(w, u, along);
  sg_minus(a->beside, u, one);
  sg_minus(b->beside, u, other);
  sg_cross(along, one, n1);
  sg_cross(along, other, n2);
  return sg_dot(n1, n2) > 0 && (off_plane(u, n1, b->beside) <= m->near ||
                                off_plane(u, n2, a->beside) <= m->near);
}

static void
turn_round(sg_page_at_edge *page, size_t n)
{
  for (size_t i = 0; i < n / 2; i++) {
    sg_page_at_edge first = page[i];

    page[i] = page[n - 1 - i];
    page[n - 1 - i] = first;
  }
}

bool
sg_regions_are_crowded(const sg_regions_maker *m, const sg_edge_group *group,
                       sg_page_at_edge *page, size_t n)
{
  bool any = false;
  size_t first = 0;

  for (size_t i = 0; i < n; i++) {
    page[i].on_last = (i > 0 && page[i].on_last) ||
                      lies_on(m, group, &page[(i + n - 1) % n], &page[i]);
    any = any || page[i].on_last;
  }
  while (first < n && page[first].on_last) {
    first++;
  }
  if (first > 0 && first < n) {
    turn_round(page, first);
    turn_round(page + first, n - first);
    turn_round(page, n);
  }
  page[0].on_last = false;
  return any;
}

bool
sg_regions_keep_crowd(sg_regions_crowds *crowds, sg_regions_maker *m,
                      const sg_page_at_edge *page, size_t n)
{
  sg_regions_crowd one = {.begin = crowds->page.n, .n = n};

  for (size_t i = 0; i < n; i++) {
    if (!SG_PUSH(crowds->page, page[i])) {
      return sg_regions_no_memory(m);
    }
  }
  return SG_PUSH(crowds->crowd, one) || sg_regions_no_memory(m);
}

void
sg_regions_crowds_clear(sg_regions_crowds *crowds)
{
  free(crowds->crowd.item);
  free(crowds->page.item);
}

/* ---- in which order ---- */

/* Pages begin .. end - 1, of n round an edge, lie on each other. */
typedef struct run {
  const sg_regions_maker *m;
  const sg_page_at_edge *all;
  size_t n, begin, end;
} run;

/* It is known that one region is after page a and before page b. */
static bool
meet(const sg_regions_maker *m, const sg_page_at_edge *a,
     const sg_page_at_edge *b)
{
  return sg_disjoint_root(m->zone, sg_regions_zone_beside(m, a, true)) ==
         sg_disjoint_root(m->zone, sg_regions_zone_beside(m, b, false));
}

/* Beside a run is one page of the run before it, or of the next one, and which
 * of them need not be known. */
static bool
meets_last(const run *r, const sg_page_at_edge *first)
{
  size_t i = (r->begin + r->n - 1) % r->n;

  while (!meet(r->m, &r->all[i], first)) {
    if (!r->all[i].on_last) {
      return false;
    }
    i--;
  }
  return true;
}

static bool
meets_next(const run *r, const sg_page_at_edge *last)
{
  size_t i = r->end % r->n;

  while (!meet(r->m, last, &r->all[i])) {
    if (++i >= r->n || !r->all[i].on_last) {
      return false;
    }
  }
  return true;
}

/* How well pages fit in the place of a run. */
static int
fit(const run *r, const sg_page_at_edge *page)
{
  size_t n = r->end - r->begin;
  int known = 0;

  for (size_t i = 0; i + 1 < n; i++) {
    known += meet(r->m, &page[i], &page[i + 1]);
  }
  if (n == r->n) {
    return known + meet(r->m, &page[n - 1], &page[0]);
  }
  return known + meets_last(r, &page[0]) + meets_next(r, &page[n - 1]);
}

/* An order that is looked at, and the best of those that were. */
typedef struct orders {
  const run *run;
  sg_page_at_edge page[MOST], best[MOST];
  int most;
  bool one; /* none is as good */
} orders;

static void
look_at(orders *o)
{
  int known = fit(o->run, o->page);

  o->one = known == o->most ? false : o->one || known > o->most;
  if (known > o->most) {
    o->most = known;
    memcpy(o->best, o->page, sizeof o->best);
  }
}

/* Looks at all orders of the pages from k on. */
static void
look_at_all(orders *o, size_t k)
{
  size_t n = o->run->end - o->run->begin;

  if (k == n) {
    look_at(o);
  }
  for (size_t i = k; i < n; i++) {
    sg_page_at_edge first = o->page[k];

    o->page[k] = o->page[i];
    o->page[i] = first;
    look_at_all(o, k + 1);
    o->page[i] = o->page[k];
    o->page[k] = first;
  }
}

/* Puts the run in the order that fits what is known; of many pages they stay as
 * they are. False: it is not known. */
static bool
put_run(const run *r, sg_page_at_edge *page)
{
  size_t n = r->end - r->begin;
  orders o = {.run = r, .most = -1};

  if (n < 2 || n > MOST) {
    return true;
  }
  memcpy(o.page, page + r->begin, n * sizeof *page);
  look_at_all(&o, 0);
  for (size_t i = 0; i < n; i++) {
    page[r->begin + i] = o.best[i];
    page[r->begin + i].on_last = i > 0;
  }
  return o.one;
}

static bool
put_runs(const sg_regions_maker *m, sg_page_at_edge *page, size_t n)
{
  bool known = true;

  for (size_t i = 0, end; i < n; i = end) {
    for (end = i + 1; end < n && page[end].on_last;) {
      end++;
    }
    known &= put_run(&(run){m, page, n, i, end}, page);
  }
  return known;
}

/* How many were settled; `all`: also those that are not known. */
static size_t
settle(sg_regions_crowds *crowds, sg_regions_maker *m, bool all)
{
  size_t count = 0;

  for (size_t i = 0; i < crowds->crowd.n; i++) {
    sg_regions_crowd *one = &crowds->crowd.item[i];
    sg_page_at_edge *page = &crowds->page.item[one->begin];

    if (!one->settled && (put_runs(m, page, one->n) || all)) {
      sg_regions_join_wedges(m, page, one->n);
      one->settled = true;
      count++;
    }
  }
  return count;
}

bool
sg_regions_settle_crowds(sg_regions_crowds *crowds, sg_regions_maker *m)
{
  while (settle(crowds, m, false) > 0) {
    if (!sg_regions_asked(m)) {
      return false;
    }
  }
  settle(crowds, m, true);
  return true;
}
