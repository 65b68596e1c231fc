/* regions_edge.c -- the pages round each edge, in order, and what is between
 * them (regions_private.h).
 *
 * With one or two pages no arithmetic is needed. Where pages lie on each other,
 * within rounding, see regions_order.c.
 */
#include "regions_private.h"

#include "engine/list.h"
#include "rows/disjoint.h"
#include "rows/edge_pairs.h"

#include <stdlib.h>
#include <string.h>

enum { ASKED = 1 << 12 };

typedef struct binding {
  sg_regions_maker *m;
  size_t n;
  int32_t *from, *to; /* [n] */
  uint32_t *what;     /* [n] an entry, or entries + a place of dense edges */
  sg_page_at_edge *page;
  size_t room;
  sg_regions_crowds crowds;
} binding;

/* ---- edges ---- */

static void
mark_owned(const sg_regions_maker *m, bool *owned)
{
  for (size_t i = 0; i < m->entries; i++) {
    owned[m->d->list[i]] = true;
  }
}

static void
add_edge(binding *b, uint32_t what, int32_t e)
{
  b->from[b->n] = b->m->d->from[e];
  b->to[b->n] = b->m->d->to[e];
  b->what[b->n++] = what;
}

static bool
list_edges(binding *b)
{
  sg_regions_maker *m = b->m;
  size_t most = m->entries + m->d->edges + 1;
  bool *owned = calloc(m->d->edges + 1, sizeof *owned);

  b->from = malloc(most * sizeof *b->from);
  b->to = malloc(most * sizeof *b->to);
  b->what = malloc(most * sizeof *b->what);
  if (!owned || !b->from || !b->to || !b->what) {
    free(owned);
    return sg_regions_no_memory(m);
  }
  mark_owned(m, owned);
  for (uint32_t i = 0; i < m->entries; i++) {
    if (m->is_face[m->polygon[i]]) {
      add_edge(b, i, m->d->list[i]);
    }
  }
  for (uint32_t e = 0; e < m->d->edges; e++) {
    if (!owned[e] && m->d->from[e] != m->d->to[e]) {
      add_edge(b, (uint32_t)m->entries + e, (int32_t)e);
    }
  }
  free(owned);
  return true;
}

/* ---- pages ---- */

/* The corner of a page at the lower or upper end of its edge. */
static uint32_t
corner_at(const sg_regions_maker *m, const sg_page_at_edge *page, bool low)
{
  return page->forward == low ? page->edge : m->next[page->edge];
}

/* What is between a page and the next one is one, at both ends. */
static void
join_wedge(sg_regions_maker *m, const sg_page_at_edge *a,
           const sg_page_at_edge *b)
{
  uint32_t after = sg_regions_side_of(a, true),
           before = sg_regions_side_of(b, false);
  uint32_t one = sg_regions_zone_beside(m, a, true);

  sg_disjoint_join(m->zone, one, sg_regions_zone_beside(m, b, false));
  m->euler[one]--;
  for (int low = 0; low < 2; low++) {
    sg_disjoint_join(m->cycle, 2 * corner_at(m, a, low) + after,
                     2 * corner_at(m, b, low) + before);
  }
}

void
sg_regions_join_wedges(sg_regions_maker *m, const sg_page_at_edge *page,
                       size_t n)
{
  for (size_t i = 0; i < n; i++) {
    join_wedge(m, &page[i], &page[(i + 1) % n]);
  }
}

static void
put_in_order(binding *b, size_t n, const sg_edge_group *group)
{
  sg_regions_maker *m = b->m;

  for (size_t i = 0; i < n; i++) {
    sg_page_at_edge *page = &b->page[i];
    uint32_t p = m->polygon[page->edge];
    int way = page->forward ? m->way[p] : -m->way[p];

    page->rank = way * (int64_t)p;
    memcpy(page->beside, m->d->at[m->third[page->edge]], sizeof page->beside);
  }
  sg_pages_order(m->d->at[group->low], m->d->at[group->high], b->page, n);
}

/* ---- edge by edge ---- */

static bool
add_group(binding *b, const sg_edge_pairs *pairs, const sg_edge_group *group)
{
  sg_regions_maker *m = b->m;
  size_t n = 0, all = group->end - group->begin;
  uint32_t wire = SG_NOWHERE;

  if (!sg_list_need(&b->page, all, &b->room, sizeof *b->page)) {
    return sg_regions_no_memory(m);
  }
  for (size_t i = 0; i < all; i++) {
    uint32_t k = sg_edge_group_edge(pairs, group->begin + i), what = b->what[k];

    if (what < m->entries) {
      b->page[n++] =
          (sg_page_at_edge){.edge = what, .forward = i < group->forward};
      m->edge_of[what] = (uint32_t)m->edges;
    } else if (wire > what) {
      wire = what;
    }
  }
  if (n > 2) {
    put_in_order(b, n, group);
  }
  if (n < 3 || !sg_regions_are_crowded(m, group, b->page, n)) {
    sg_regions_join_wedges(m, b->page, n);
  } else if (!sg_regions_keep_crowd(&b->crowds, m, b->page, n)) {
    return false;
  }
  for (size_t i = 1; i < n; i++) {
    sg_disjoint_join(m->piece, m->polygon[b->page[0].edge],
                     m->polygon[b->page[i].edge]);
  }
  m->low[m->edges] = group->low;
  m->high[m->edges] = group->high;
  if (n == 0) {
    m->wire[m->wires] = (uint32_t)m->edges;
    m->wire_edge[m->wires++] = wire - (uint32_t)m->entries;
  }
  m->edges++;
  return m->edges % ASKED != 0 || sg_regions_asked(m);
}

/* ---- all ---- */

static bool
make_room(sg_regions_maker *m, size_t edges)
{
  size_t elements = 2 * m->d->polygons + edges + m->d->vertices + 1;

  m->edge_of = malloc((m->entries + 1) * sizeof *m->edge_of);
  m->low = malloc((edges + 1) * sizeof *m->low);
  m->high = malloc((edges + 1) * sizeof *m->high);
  m->wire = malloc((edges + 1) * sizeof *m->wire);
  m->wire_edge = malloc((edges + 1) * sizeof *m->wire_edge);
  m->cycle = malloc((2 * m->corners + 1) * sizeof *m->cycle);
  m->piece = malloc((m->d->polygons + 1) * sizeof *m->piece);
  m->zone = malloc(elements * sizeof *m->zone);
  m->euler = calloc(elements, sizeof *m->euler);
  if (!m->edge_of || !m->low || !m->high || !m->wire || !m->wire_edge ||
      !m->cycle || !m->piece || !m->zone || !m->euler) {
    return sg_regions_no_memory(m);
  }
  for (uint32_t i = 0; i < 2 * m->corners; i++) {
    m->cycle[i] = i;
  }
  for (uint32_t p = 0; p < m->d->polygons; p++) {
    m->piece[p] = p;
    m->euler[2 * p] = m->euler[2 * p + 1] = 2 - (int32_t)m->loops[p];
  }
  for (uint32_t i = 0; i < elements; i++) {
    m->zone[i] = i;
  }
  return true;
}

bool
sg_regions_edges(sg_regions_maker *m)
{
  binding b = {.m = m};
  sg_edge_pairs pairs = {0};
  sg_edge_group group = {0};
  bool stopped = false, good = list_edges(&b) && make_room(m, b.n);

  if (good && !sg_edge_pairs_make(b.n, b.from, b.to, m->d->vertices, m->cancel,
                                  &pairs, &stopped)) {
    m->end = stopped ? SG_REGIONS_STOPPED : SG_REGIONS_NO_MEMORY;
    good = false;
  }
  while (good && sg_edge_group_next(&pairs, &group)) {
    good = add_group(&b, &pairs, &group);
  }
  good = good && sg_regions_settle_crowds(&b.crowds, m);
  sg_edge_pairs_clear(&pairs);
  free(b.from);
  free(b.to);
  free(b.what);
  free(b.page);
  sg_regions_crowds_clear(&b.crowds);
  return good;
}
