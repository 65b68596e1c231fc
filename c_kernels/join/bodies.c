/* bodies.c -- see bodies.h: union-find over vertices; the root of each is the
 * lowest. */
#include "bodies.h"
#include "rows/disjoint.h"

#include <stdlib.h>

enum { ASKED = 1 << 15 }; /* triangles between questions */

/* From roots to numbers: a root comes before all that it stands for. */
static size_t
number_roots(uint32_t *of, size_t places)
{
  size_t n = 0;

  for (uint32_t i = 0; i < places; i++) {
    of[i] = of[i] == i ? (uint32_t)n++ : of[of[i]];
  }
  return n;
}

bool
sg_bodies_find(const sg_leaf_tree *tree, const sg_leaf_views *views,
               const sg_cancel *cancel, sg_bodies *out)
{
  const sg_id_rows *vertex = &tree->vertex;
  uint32_t *of = malloc((vertex->places + 1) * sizeof *of);

  *out = (sg_bodies){.vertex = vertex, .of = of};
  for (uint32_t i = 0; of && i < vertex->places; i++) {
    of[i] = i;
  }
  for (size_t i = 0; of && !tree->curve && i < tree->boxes->n; i++) {
    sg_leaf leaf = sg_leaf_at(tree, views, tree->boxes->item[i]);
    uint32_t at[3];

    if (i % ASKED == ASKED - 1 && sg_cancelled(cancel)) {
      return false;
    }
    for (int k = 0; k < 3; k++) {
      at[k] = (uint32_t)sg_id_rows_place(vertex, leaf.v[k]);
    }
    sg_disjoint_join(of, at[0], at[1]);
    sg_disjoint_join(of, at[0], at[2]);
  }
  out->n = of ? number_roots(of, vertex->places) : 0;
  return of != NULL;
}

void
sg_bodies_clear(sg_bodies *bodies)
{
  free(bodies->of);
  *bodies = (sg_bodies){0};
}
