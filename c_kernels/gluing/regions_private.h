/* regions_private.h -- the steps of regions.h, in files of their own.
 *
 * Layer: kernel.
 *
 * A CORNER is an entry of the polygons' lists, a half-edge, at the vertex where
 * it starts; after these come the point loops. Corner k has the sides 2k, below
 * its polygon, and 2k + 1, above.
 */
#ifndef SG_REGIONS_PRIVATE_H
#define SG_REGIONS_PRIVATE_H

#include "regions.h"

#include "engine/list.h"
#include "join/pages.h"
#include "rows/edge_pairs.h"

#define SG_NOWHERE UINT32_MAX

/* Elements of `zone` and `shell`: the sides of polygons, then wires, then lone
 * vertices. */
typedef struct sg_regions_maker {
  const sg_dense *d;
  const sg_point_loop *point_loop;
  size_t point_loops;
  const sg_zones_told *told; /* NULL: sphere maps say it */
  const sg_cancel *cancel;
  double near; /* what is no farther apart may be meant to be in one place */
  sg_regions *out;
  sg_regions_end end; /* what went wrong */
  size_t bad;

  /* Corners (regions_corner.c). */
  size_t corners, entries;             /* entries: without point loops */
  uint32_t *triangle_begin, *triangle; /* those of polygon p */
  uint32_t *polygon;                   /* [corners] */
  uint32_t *next, *before;             /* [entries] in the loop */
  int32_t *third;   /* [entries] the third corner of the triangle there */
  signed char *way; /* [polygons] 1 or -1: as its lowest vertex has it */
  size_t *loops;    /* [polygons] */
  bool *is_face;    /* [polygons] */

  /* Edges (regions_edge.c). */
  size_t edges, wires;
  uint32_t *edge_of;    /* [entries] */
  uint32_t *wire;       /* [wires] the edge that it is */
  uint32_t *low, *high; /* [edges] */
  uint32_t *wire_edge;  /* [wires] a place of dense edges */
  uint32_t *cycle;      /* [2 * corners] sides of corners, disjoint sets */
  uint32_t *piece;      /* [polygons] hang together by edges, disjoint sets */
  uint32_t *zone;       /* [elements] disjoint sets: without vertices */
  int32_t *euler;       /* [elements] */

  /* Pieces (regions_outer.c). */
  uint32_t *outer;   /* [polygons] of the root of a piece: its outer zone */
  uint32_t *classes; /* [polygons] of the root of a piece: how many zones */
  bool *slit;        /* [2 * polygons] a zone that has no volume */

  /* Vertices (regions_vertex.c). */
  size_t lone;
  uint32_t *lone_at; /* [lone] */
  uint32_t *shell;   /* [elements] disjoint sets: zones, and vertices */
  size_t elements;
} sg_regions_maker;

static inline uint32_t
sg_corner_vertex(const sg_regions_maker *m, uint32_t corner)
{
  return corner < m->entries ? (uint32_t)m->d->from[m->d->list[corner]]
                             : m->point_loop[corner - m->entries].v;
}

static inline uint32_t
sg_element_of_wire(const sg_regions_maker *m, size_t i)
{
  return (uint32_t)(2 * m->d->polygons + i);
}

static inline uint32_t
sg_element_of_lone(const sg_regions_maker *m, size_t i)
{
  return (uint32_t)(2 * m->d->polygons + m->wires + i);
}

/* All of these: false: m->end says why. */
bool sg_regions_no_memory(sg_regions_maker *m);
bool sg_regions_asked(sg_regions_maker *m); /* the cancellation */

/* Pages at one edge, some of which lie on each other. */
typedef struct sg_regions_crowd {
  size_t begin, n;
  bool settled;
} sg_regions_crowd;

typedef struct sg_regions_crowds {
  SG_LIST_OF(sg_regions_crowd) crowd;
  SG_LIST_OF(sg_page_at_edge) page;
} sg_regions_crowds;

/* Marks which of n > 2 pages, in order, lie on the page before them; one that
 * does not comes first, if there is one. Are there any? */
bool sg_regions_are_crowded(const sg_regions_maker *m,
                            const sg_edge_group *group, sg_page_at_edge *page,
                            size_t n);
bool sg_regions_keep_crowd(sg_regions_crowds *crowds, sg_regions_maker *m,
                           const sg_page_at_edge *page, size_t n);
bool sg_regions_settle_crowds(sg_regions_crowds *crowds, sg_regions_maker *m);
void sg_regions_crowds_clear(sg_regions_crowds *crowds);
/* What is between each page and the next one is one. */
void sg_regions_join_wedges(sg_regions_maker *m, const sg_page_at_edge *page,
                            size_t n);

/* The side of a page that is after it, or before it, round the edge. */
static inline uint32_t
sg_regions_side_of(const sg_page_at_edge *page, bool after)
{
  return page->forward != after;
}

static inline uint32_t
sg_regions_zone_beside(const sg_regions_maker *m, const sg_page_at_edge *page,
                       bool after)
{
  return 2 * m->polygon[page->edge] + sg_regions_side_of(page, after);
}

bool sg_regions_corners(sg_regions_maker *m);
bool sg_regions_edges(sg_regions_maker *m);
/* Disks, and zones where there are several; counts lone vertices. */
bool sg_regions_vertices(sg_regions_maker *m);
/* Joins in m->zone the zones of parts that lie in each other. *outside: an
 * element of the outside, SG_NOWHERE if there is nothing at all. */
bool sg_regions_locate(sg_regions_maker *m, uint32_t *outside);
/* What is counted of the result. */
bool sg_regions_count(sg_regions_maker *m, uint32_t outside);

/* The third corner of the triangle of polygon p that has the side from -> to,
 * or -1. */
int32_t sg_regions_third(const sg_regions_maker *m, size_t p, int32_t from,
                         int32_t to);

/* Finds m->outer, m->classes and m->slit, of the classes of m->zone. */
bool sg_regions_outer(sg_regions_maker *m);

#endif
