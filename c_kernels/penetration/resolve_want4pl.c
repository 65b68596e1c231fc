/* resolve_want4pl.c -- which polygons are to be made anew: see resolve4pl.h.
 *
 * Layer: glue.
 */
#include "resolve4pl.h"

#include "glue.h"
#include "rows/sort.h"

/* Notes that polygon p of segment s is to be made anew. */
static int
want_polygon_ex(sg_resolving *job, int32_t s, int32_t p)
{
  uint32_t *known =
      sg_key_table_put(&job->known, (uint32_t[2]){(uint32_t)s, (uint32_t)p});

  if (!known) {
    return sg_no_memory();
  }
  if (*known == SG_NO_KEY) {
    *known = 0;
    return SG_PUSH(job->polygon, (sg_resolved_polygon){.s = s, .p = p}) ||
           sg_no_memory();
  }
  return TRUE;
}

static int
want_polygons_of_ex(sg_resolving *job, int32_t s, int32_t e)
{
  sg_walk walk;
  int good = TRUE;

  if (!sg_index_ready(job->handle->version, SG_P, 0, &sg_prolog_poll)) {
    return FALSE;
  }
  if (!sg_walk_open_member(&walk, job->handle->version, SG_P,
                           sg_resolving_segment(job, s), e)) {
    return sg_no_memory();
  }
  for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    int32_t p = sg_version_value(job->handle->version, SG_P, row, 1).i;
    good = want_polygon_ex(job, s, p);
  }
  sg_walk_close(&walk);
  return good;
}

/* The polygons on both sides of a divided edge. */
static int
want_neighbours_ex(sg_resolving *job, const sg_resolve_split *split)
{
  int good = TRUE;

  for (int turn = 0; turn < 2 && good; turn++) {
    sg_value row[SG_MAX_COLUMNS] = {[0].i = sg_resolving_segment(job, split->s),
                                    [2].i = split->v[turn],
                                    [3].i = split->v[!turn]};
    sg_walk walk;

    if (!sg_index_ready(job->handle->version, SG_E, 0x0d, &sg_prolog_poll)) {
      return FALSE;
    }
    if (!sg_walk_open(&walk, job->handle->version, SG_E, 0x0d, row)) {
      return sg_no_memory();
    }
    for (sg_row found; good && (found = sg_walk_next(&walk)) != SG_NO_ROW;) {
      int32_t e = sg_version_value(job->handle->version, SG_E, found, 1).i;
      good = want_polygons_of_ex(job, split->s, e);
    }
    sg_walk_close(&walk);
  }
  return good;
}

static int
sort_ex(void *item, size_t n, size_t size, sg_sort_compare *compare)
{
  sg_sort_end end = sg_sort(item, n, size, compare, &sg_prolog_poll);

  return end == SG_SORTED || (end == SG_SORT_NO_MEMORY && sg_no_memory());
}

static int
by_polygon(const void *a, const void *b)
{
  const sg_resolve_near *x = a, *y = b;

  return x->s != y->s   ? (x->s < y->s ? -1 : 1)
         : x->p != y->p ? (x->p < y->p ? -1 : 1)
                        : (x->n > y->n) - (x->n < y->n);
}

/* Polygons with three points or more may lie on others. */
static int
want_covered_ex(sg_resolving *job)
{
  sg_resolve_near *near = job->r.near.item;
  size_t n = job->r.near.n;
  int good = sort_ex(near, n, sizeof *near, by_polygon);

  for (size_t i = 0, first = 0; i < n && good; i++) {
    if (near[i].s != near[first].s || near[i].p != near[first].p) {
      first = i;
    }
    if (i == first + 2) {
      good = want_polygon_ex(job, near[i].s, near[i].p);
    }
  }
  return good;
}

static int
compare_results(const void *a, const void *b)
{
  const sg_resolved_polygon *x = a, *y = b;

  return x->s != y->s ? (x->s < y->s ? -1 : 1) : (x->p > y->p) - (x->p < y->p);
}

int
sg_resolving_want_ex(sg_resolving *job)
{
  const sg_resolve *r = &job->r;
  int good = want_covered_ex(job);

  for (size_t i = 0; i < r->split.n && good; i++) {
    good = sg_resolving_goes_on_ex(i) &&
           want_neighbours_ex(job, &r->split.item[i]);
  }
  for (size_t i = r->first_inside; i < r->place.n && good; i++) {
    good = want_polygon_ex(job, r->place.item[i].s, r->place.item[i].p);
  }
  for (size_t i = 0; i < r->seam.n && good; i++) {
    good = want_polygon_ex(job, r->seam.item[i].s, r->seam.item[i].p);
  }
  return good && sort_ex(job->polygon.item, job->polygon.n,
                         sizeof *job->polygon.item, compare_results);
}
