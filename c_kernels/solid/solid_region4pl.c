/* solid_region4pl.c -- see solid_region4pl.h.
 *
 * Layer: glue. The doors are documented in rules/kernel.pl.
 */
#include "solid_region4pl.h"

#include "glue.h"

#include "engine/install.h"

#include <SWI-Stream.h>
#include <stdlib.h>

const sg_relation sg_old_relation[SG_OLD_RELATIONS] = {
    [SG_OLD_V] = SG_V,           [SG_OLD_E] = SG_E,
    [SG_OLD_P] = SG_P,           [SG_OLD_PLANE] = SG_PLANE,
    [SG_OLD_T] = SG_T,           [SG_OLD_FROM_V] = SG_FROM_V,
    [SG_OLD_FROM_P] = SG_FROM_P, [SG_OLD_ORIGIN] = SG_ORIGIN};

/* ---- the handle --------------------------------------------------------- */

static void
close_region(sg_region_handle *h)
{
  sg_solid_old_clear(&h->old);
  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    sg_view_clear(&h->view[k]);
  }
  if (h->version) {
    sg_version_drop(h->version);
    h->version = NULL;
  }
}

static int
release_handle(atom_t atom)
{
  sg_region_handle *h = PL_blob_data(atom, NULL, NULL);

  close_region(h);
  free(h);
  return TRUE;
}

static int
write_handle(IOSTREAM *out, atom_t atom, int flags)
{
  const sg_region_handle *h = PL_blob_data(atom, NULL, NULL);

  (void)flags;
  if (h->version) {
    Sfprintf(out, "<sg_region>(%d,%zu)", (int)h->s, h->old.region.leaves);
  } else {
    Sfprintf(out, "<sg_region>(closed)");
  }
  return TRUE;
}

static PL_blob_t region_blob = {.magic = PL_BLOB_MAGIC,
                                .flags = PL_BLOB_UNIQUE | PL_BLOB_NOCOPY,
                                .name = "sg_region",
                                .release = release_handle,
                                .write = write_handle};

int
sg_get_region_ex(term_t t, sg_region_handle **out)
{
  PL_blob_t *type;
  void *data;

  if (!PL_get_blob(t, &data, NULL, &type) || type != &region_blob) {
    return PL_is_variable(t) ? PL_instantiation_error(t)
                             : PL_type_error("region", t);
  }
  *out = data;
  return (*out)->version || PL_existence_error("region", t);
}

/* ---- reading ------------------------------------------------------------ */

/* Fails if the rows are no solid's. */
static int
read_region_ex(sg_region_handle *h, const int32_t *leaf, size_t n)
{
  const sg_view *of[SG_OLD_RELATIONS];

  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    of[k] = &h->view[k];
    if (!sg_version_view(h->version, sg_old_relation[k], &h->view[k])) {
      return sg_no_memory();
    }
  }
  switch (sg_solid_old_read_region(of, h->s, leaf, n, sg_term_vertex,
                                   &sg_prolog_poll, &h->old)) {
  case SG_OLD_READ:
    return TRUE;
  case SG_OLD_UNFIT:
    return FALSE;
  case SG_OLD_FAILED:
    break;
  }
  return PL_exception(0) ? FALSE : sg_no_memory();
}

/* solid_region(+S, +Leaves, -Region) is semidet. */
static foreign_t
solid_region(term_t s_term, term_t leaves, term_t region)
{
  sg_world *world = sg_current_world_ex();
  int32_t s, *leaf = NULL;
  size_t n;

  if (!world || !sg_get_id_ex(s_term, &s) ||
      !sg_get_id_set_ex(leaves, &leaf, &n)) {
    return FALSE;
  }
  sg_region_handle *h = calloc(1, sizeof *h);

  if (!h) {
    free(leaf);
    return sg_no_memory();
  }
  h->s = s;
  h->version = sg_world_version(world);
  h->stamp = sg_segment_stamp(h->version, s);
  int good = read_region_ex(h, leaf, n);

  free(leaf);
  if (!good) {
    close_region(h);
    free(h);
    return FALSE;
  }
  return PL_unify_blob(region, h, sizeof *h, &region_blob);
}

/* region_leaves(+Region, -Leaves) is det. */
static foreign_t
region_leaves(term_t region, term_t leaves)
{
  sg_region_handle *h;

  return sg_get_region_ex(region, &h) &&
         sg_unify_ids(leaves, h->old.region.leaf, h->old.region.leaves);
}

/* region_close(+Region) is det. */
static foreign_t
region_close(term_t region)
{
  sg_region_handle *h;

  if (!sg_get_region_ex(region, &h)) {
    return FALSE;
  }
  close_region(h);
  return TRUE;
}

static const PL_extension predicates[] = {
    {"solid_region", 3, solid_region, 0},
    {"region_leaves", 2, region_leaves, 0},
    {"region_close", 1, region_close, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_solid_region(void)
{
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
