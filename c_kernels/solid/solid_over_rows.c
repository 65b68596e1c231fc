/* solid_over_rows.c -- a solid over the rows of an earlier one. */
#include "doors/boolean.h"
#include "solid_over.h"

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

/* False without a refusal: it is not to be written over these rows. */
static bool
write_over(sg_call *call, sg_world *world, const sg_solid_rows *rows,
           const sg_solid_old *old, int32_t s, sg_pool *pool)
{
  sg_solid_over over;
  bool good = (sg_solid_over_match(rows, old, &call->cancel, &over) ||
               sg_call_ended(call)) &&
              !is_little(&over, rows->solid) &&
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

/* ---- the door ----------------------------------------------------------- */

/* Views of the relations that a solid is written to. */
static bool
open_views(sg_call *call, const sg_version *version,
           sg_view view[SG_OLD_RELATIONS])
{
  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    if (!sg_version_view(version, relation_of[k], &view[k])) {
      return sg_call_no_memory(call);
    }
  }
  return true;
}

/* As the door; false without a refusal: the rows are no solid's. */
static bool
read_and_write(sg_call *call, sg_world *world, const sg_solid *solid, int32_t s,
               const sg_view view[SG_OLD_RELATIONS])
{
  const sg_view *of[SG_OLD_RELATIONS];
  sg_solid_old old;

  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    of[k] = &view[k];
  }
  sg_old_end end =
      sg_solid_old_read(of, s, sg_term_vertex, &call->cancel, &old);
  bool good = end == SG_OLD_READ ? write_solid(call, world, solid, &old, s)
                                 : end == SG_OLD_FAILED && sg_call_ended(call);

  sg_solid_old_clear(&old);
  return good;
}

bool
sg_door_solid_write_over(sg_call *call, sg_solid *solid, int32_t s)
{
  sg_world *world = sg_call_claim(call);

  if (!world) {
    return false;
  }
  const sg_version *version = sg_world_version(world);
  sg_view view[SG_OLD_RELATIONS] = {{0}};
  bool good = open_views(call, version, view) &&
              read_and_write(call, world, solid, s, view);

  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    sg_view_clear(&view[k]);
  }
  sg_version_drop(version);
  sg_world_release(world);
  return good;
}
