/* contact_places.h -- where the vertices of a leaf were made to touch: kept
 * with the pieces of the leaf.
 *
 * Layer: rows. Before solids are combined, vertices of leaves are moved, and
 * leaves get new vertices on edges and faces (resolve_rows.h). The leaves get
 * their rows back when the snapshot ends, but a result keeps these vertices:
 * its origins then name vertices, edges and faces that the leaves still have:
 *
 *   - If others were made to touch a vertex V of one leaf S, it has the origin
 *     near(on(S-V, Places)). Places are S0-v(V0), S0-e(E) and S0-p(P): the
 *     features of the others that are there.
 *   - If two edges pass each other at the vertex, it has the origin
 *     near(ll(Edge1, Edge2)).
 *   - If the cut was made with a part of an edge, or with a triangle of a face,
 *     the origin near(lpi(...)) names that edge, or that face as S-p(P).
 *
 * Origins near(_) are not exact. The rule is tests/oracle/contact_origin.pl.
 */
#ifndef SG_CONTACT_PLACES_H
#define SG_CONTACT_PLACES_H

#include "engine/list.h"
#include "rows/key_table.h"

#include <stdint.h>

/* In the order of the terms e(E), p(P), v(V). */
typedef enum sg_contact_on {
  SG_ON_LEAF_EDGE,
  SG_ON_LEAF_FACE,
  SG_ON_LEAF_VERTEX /* it was there, and was moved */
} sg_contact_on;

typedef struct sg_contact_place {
  int32_t v;
  sg_contact_on on;
  int32_t id;               /* of that edge or face of the leaf; or v */
  size_t polygon, polygons; /* those that have v; none if it was moved */
  size_t origin;            /* what is in near/1 of its origin: its words */
} sg_contact_place;

typedef struct sg_contact_places {
  SG_LIST_OF(sg_contact_place) place; /* as their origins stood */
  SG_LIST_OF(int32_t) polygon;        /* of each place, ascending */
  SG_LIST_OF(uint32_t) word;
  sg_key_table number; /* V: its place */
} sg_contact_places;

void sg_contact_places_free(sg_contact_places *places);

/* The place of vertex v; null: it was not made to touch. */
const sg_contact_place *sg_contact_places_find(const sg_contact_places *places,
                                               int32_t v);

/* Its origin, a term. */
static inline const uint32_t *
sg_contact_origin(const sg_contact_places *places,
                  const sg_contact_place *place)
{
  return places->word.item + place->origin;
}

#endif
