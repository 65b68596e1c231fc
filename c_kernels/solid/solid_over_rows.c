/* solid_over_rows.c -- a solid over the rows of an earlier one, or over those
 * of a region of it.
 */
#include "doors/boolean.h"
#include "solid_over.h"
#include "solid_region_rows.h"

#include "engine/symbol.h"
#include "engine/term.h"

#include <stdlib.h>
#include <string.h>

/* The relations of solid_old.h. */
static const sg_relation relation_of[SG_OLD_RELATIONS] = {
    [SG_OLD_V] = SG_V,           [SG_OLD_E] = SG_E,
    [SG_OLD_P] = SG_P,           [SG_OLD_PLANE] = SG_PLANE,
    [SG_OLD_T] = SG_T,           [SG_OLD_FROM_V] = SG_FROM_V,
    [SG_OLD_FROM_P] = SG_FROM_P, [SG_OLD_ORIGIN] = SG_ORIGIN};

/* ---- changing ----------------------------------------------------------- */

/* The rows that go, ascending. Null: refused. */
static sg_row *
list_gone(sg_call *call, const sg_solid_old *old, const sg_solid_over *over,
          int relation, size_t *n)
{
  size_t all = sg_old_count(old, relation);
  sg_row *list = sg_call_alloc(call, (all + 1) * sizeof *list);

  *n = 0;
  for (size_t i = 0; list && i < all; i++) {
    if (over->gone[relation][i]) {
      list[(*n)++] = old->rows[relation].row[i];
    }
  }
  return list;
}

static bool
exchange(sg_call *call, sg_world *world, const sg_solid_old *old,
         const sg_solid_over *over, int relation, const void *const *column)
{
  size_t n;
  sg_row *gone = list_gone(call, old, over, relation, &n);

  if (!gone || !sg_world_exchange(world, relation_of[relation], gone, n,
                                  over->fresh[relation].n, column)) {
    return sg_call_no_memory(call);
  }
  return !sg_cancelled(&call->cancel);
}

/* The rows of origin/3 have terms v(V). */
static bool
exchange_origins(sg_call *call, sg_world *world, const sg_solid_old *old,
                 const sg_solid_over *over)
{
  enum { ITEM_WORDS = 8 };
  const sg_over_rows *rows = &over->fresh[SG_OLD_ORIGIN];
  const int32_t *vertex = rows->column[1];
  uint32_t(*word)[ITEM_WORDS] =
      sg_call_alloc(call, (rows->n + 1) * sizeof *word);
  const uint32_t **item = sg_call_alloc(call, (rows->n + 1) * sizeof *item);

  for (size_t i = 0; word && item && i < rows->n; i++) {
    sg_term_builder b;
    sg_term_open(&b);
    sg_term_unary(&b, SG_SYMBOL_V, vertex[i]);
    const uint32_t *term = sg_term_words(&b); /* short: it cannot fail */
    memcpy(word[i], term, sg_term_length(term) * sizeof *term);
    item[i] = word[i];
    sg_term_close(&b);
  }
  return word && item &&
         exchange(
             call, world, old, over, SG_OLD_ORIGIN,
             (const void *const[]){rows->column[0], item, rows->column[2]});
}

static bool
exchange_all(sg_call *call, sg_world *world, const sg_solid_old *old,
             const sg_solid_over *over)
{
  for (int k = 0; k < SG_OLD_ORIGIN; k++) {
    if (!exchange(call, world, old, over, k,
                  (const void *const *)over->fresh[k].column)) {
      return false;
    }
  }
  return exchange_origins(call, world, old, over);
}

/* Most faces are new: then all of them may as well be. */
static bool
is_little(const sg_solid_over *over, const sg_solid *solid)
{
  return over->faces_stay * 2 < solid->faces;
}

/* Not to be written over these rows: most is new, or it does not fit. */
static bool
is_unfit(sg_call *call, const sg_solid_rows *rows, const sg_solid_old *old,
         const sg_solid_over *over)
{
  return old->region.leaf ? !sg_solid_over_fits(rows, old, over, &call->cancel)
                          : is_little(over, rows->solid);
}

/* False without a refusal: it is not to be written over these rows. */
static bool
write_over(sg_call *call, sg_world *world, const sg_solid_rows *rows,
           const sg_solid_old *old, int32_t s, sg_pool *pool)
{
  sg_solid_over over;
  bool good = (sg_solid_over_match(rows, old, &call->cancel, &over) ||
               sg_call_ended(call)) &&
              !is_unfit(call, rows, old, &over) &&
              (sg_solid_over_write(rows, old, s, pool, &call->cancel, &over) ||
               sg_call_ended(call)) &&
              exchange_all(call, world, old, &over);

  sg_solid_over_clear(&over);
  return good;
}

/* The same, of a solid. */
static bool
write_solid(sg_call *call, sg_world *world, const sg_solid *solid,
            const sg_solid_old *old, int32_t s)
{
  sg_pool *pool = sg_call_pool(call);
  sg_solid_rows rows = {0};
  bool good = pool &&
              (sg_solid_rows_make(solid, pool, &call->cancel, &rows) ||
               sg_call_ended(call)) &&
              write_over(call, world, &rows, old, s, pool);

  sg_solid_rows_clear(&rows);
  return good;
}

/* ---- reading ------------------------------------------------------------ */

void
sg_region_free(sg_region *region)
{
  if (region) {
    sg_solid_old_clear(&region->old);
    for (int k = 0; k < SG_OLD_RELATIONS; k++) {
      sg_view_clear(&region->view[k]);
    }
    sg_version_drop(region->version);
    free(region);
  }
}

/* The rows of segment s, or the region of some leaves in it; false without a
 * refusal: they are no solid's. */
static bool
read_region(sg_call *call, int32_t s, const sg_int_list *leaves, sg_region *out)
{
  const sg_view *of[SG_OLD_RELATIONS];
  sg_old_end end = SG_OLD_FAILED;

  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    of[k] = &out->view[k];
    if (!sg_version_view(out->version, relation_of[k], &out->view[k])) {
      return sg_call_no_memory(call);
    }
  }
  end =
      leaves
          ? sg_solid_old_read_region(of, s, leaves->at, leaves->n,
                                     sg_term_vertex, &call->cancel, &out->old)
          : sg_solid_old_read(of, s, sg_term_vertex, &call->cancel, &out->old);
  return end == SG_OLD_READ || (end == SG_OLD_FAILED && sg_call_ended(call));
}

/* As read_region(), of the current version. Null: false. */
static sg_region *
open_region(sg_call *call, int32_t s, const sg_int_list *leaves)
{
  sg_world *world = sg_call_world(call);
  sg_region *region = world ? calloc(1, sizeof *region) : NULL;

  if (!region) {
    if (world) {
      sg_call_no_memory(call);
    }
    return NULL;
  }
  region->s = s;
  region->version = sg_world_version(world);
  region->stamp = sg_segment_stamp(region->version, s);
  if (!read_region(call, s, leaves, region)) {
    sg_region_free(region);
    return NULL;
  }
  return region;
}

/* ---- the doors ---------------------------------------------------------- */

bool
sg_door_solid_write_over(sg_call *call, sg_solid *solid, int32_t s)
{
  sg_world *world = sg_call_claim(call);
  sg_region *all = world ? open_region(call, s, NULL) : NULL;
  bool good = all && write_solid(call, world, solid, &all->old, s);

  sg_region_free(all);
  if (world) {
    sg_world_release(world);
  }
  return good;
}

bool
sg_door_solid_write_region(sg_call *call, sg_solid *solid, int32_t s,
                           sg_region *region)
{
  sg_world *world = sg_call_claim(call);

  if (!world) {
    return false;
  }
  const sg_version *version = sg_call_version(call);
  bool good = version && s == region->s &&
              sg_segment_stamp(version, s) == region->stamp &&
              write_solid(call, world, solid, &region->old, s);

  sg_world_release(world);
  return good;
}

bool
sg_door_solid_region(sg_call *call, int32_t s, const sg_int_list *leaves,
                     sg_region **region)
{
  *region = open_region(call, s, leaves);
  return *region != NULL;
}

bool
sg_door_region_leaves(sg_call *call, sg_region *region, sg_int_list *leaves)
{
  size_t n = region->old.region.leaves;

  (void)call;
  *leaves = (sg_int_list){region->old.region.leaf, n, 0};
  return true;
}
