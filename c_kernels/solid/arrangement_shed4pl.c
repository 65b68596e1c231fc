/* arrangement_shed4pl.c -- of all that pieces were made from only what is
 * theirs is kept: see arrangement4pl.h.
 *
 * Layer: glue; no predicates of its own.
 */
#include "arrangement4pl.h"

#include "glue.h"

#include <stdlib.h>

/* The rows of the wanted leaves, and of nothing else. Null: no memory. */
static const sg_version *
own_rows(const sg_arrangement_handle *h)
{
  uint64_t relations = UINT64_C(1) << SG_V | UINT64_C(1) << SG_T;
  int32_t *s = malloc((h->n + 1) * sizeof *s);
  const sg_version *own = NULL;
  size_t n = 0;

  for (size_t i = 0; s && i < h->n; i++) {
    if (h->wanted[i]) {
      s[n++] = h->s[i];
      relations |= (uint64_t)h->own[i]->curve << SG_E;
    }
  }
  if (s) {
    own = sg_version_narrow(h->set->version, relations, s, n);
  }
  free(s);
  return own;
}

static void
drop_unwanted_trees(sg_arrangement_handle *h)
{
  for (size_t i = 0; i < h->n; i++) {
    if (!h->wanted[i]) {
      sg_kept_tree_drop(h->tree[i]);
      h->tree[i] = NULL;
    }
  }
}

int
sg_shed_arrangement_ex(sg_arrangement_handle *h)
{
  const sg_version *own = own_rows(h);

  if (!own) {
    return sg_no_memory();
  }
  if (!sg_leaf_views_ex(own, &h->views)) {
    sg_version_drop(own);
    return FALSE;
  }
  h->version = own;
  h->world = sg_world_keep(h->set->world);
  sg_arrangement_shed(h->arrangement, &h->views);
  sg_cut_set_let_go(h->set);
  h->set = NULL;
  drop_unwanted_trees(h);
  return TRUE;
}
