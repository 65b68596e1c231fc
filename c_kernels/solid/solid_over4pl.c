/* solid_over4pl.c -- a solid over the rows of an earlier one, as a predicate.
 *
 * Layer: glue. The door is documented in rules/kernel/boolean.pl.
 */
#include "solid4pl.h"
#include "solid_region4pl.h"

#include "glue.h"
#include "solid_over.h"

#include "engine/install.h"

#include <stdlib.h>
#include <string.h>

static int
failed_ex(void)
{
  return PL_exception(0) ? FALSE : sg_no_memory();
}

/* ---- changing ----------------------------------------------------------- */

/* The rows that go, ascending. Owner: the caller. Null: no memory. */
static sg_row *
list_gone(const sg_solid_old *old, const sg_solid_over *over, int relation,
          size_t *n)
{
  size_t all = sg_old_count(old, relation);
  sg_row *list = malloc((all + 1) * sizeof *list);

  *n = 0;
  for (size_t i = 0; list && i < all; i++) {
    if (over->gone[relation][i]) {
      list[(*n)++] = old->rows[relation].row[i];
    }
  }
  return list;
}

static int
exchange_ex(sg_world *world, const sg_solid_old *old, const sg_solid_over *over,
            int relation, const void *const *column)
{
  size_t n;
  sg_row *gone = list_gone(old, over, relation, &n);
  bool good = gone && sg_world_exchange(world, sg_old_relation[relation], gone,
                                        n, over->fresh[relation].n, column);

  free(gone);
  return good ? PL_handle_signals() >= 0 : sg_no_memory();
}

/* The rows of origin/3 have terms v(V). */
static int
exchange_origins_ex(sg_world *world, const sg_solid_old *old,
                    const sg_solid_over *over)
{
  enum { ITEM_WORDS = 8 };
  const sg_over_rows *rows = &over->fresh[SG_OLD_ORIGIN];
  const int32_t *vertex = rows->column[1];
  uint32_t(*word)[ITEM_WORDS] = malloc((rows->n + 1) * sizeof *word);
  const uint32_t **item = malloc((rows->n + 1) * sizeof *item);

  for (size_t i = 0; word && item && i < rows->n; i++) {
    sg_term_builder b;
    sg_term_open(&b);
    sg_term_unary(&b, SG_SYMBOL_V, vertex[i]);
    const uint32_t *term = sg_term_words(&b); /* short: it cannot fail */
    memcpy(word[i], term, sg_term_length(term) * sizeof *term);
    item[i] = word[i];
    sg_term_close(&b);
  }
  int good = word && item
                 ? exchange_ex(world, old, over, SG_OLD_ORIGIN,
                               (const void *const[]){rows->column[0], item,
                                                     rows->column[2]})
                 : sg_no_memory();
  free(word);
  free(item);
  return good;
}

static int
exchange_all_ex(sg_world *world, const sg_solid_old *old,
                const sg_solid_over *over)
{
  for (int k = 0; k < SG_OLD_ORIGIN; k++) {
    if (!exchange_ex(world, old, over, k,
                     (const void *const *)over->fresh[k].column)) {
      return FALSE;
    }
  }
  return exchange_origins_ex(world, old, over);
}

/* ---- the door ----------------------------------------------------------- */

/* Most faces are new: then all of them may as well be. */
static bool
is_little(const sg_solid_over *over, const sg_solid *solid)
{
  return over->faces_stay * 2 < solid->faces;
}

/* Not to be written over these rows: most is new, or it does not fit. */
static bool
is_unfit(const sg_solid_rows *rows, const sg_solid_old *old,
         const sg_solid_over *over)
{
  return old->region.leaf
             ? !sg_solid_over_fits(rows, old, over, &sg_prolog_poll)
             : is_little(over, rows->solid);
}

/* -1: it is not to be written over these rows. */
static int
write_over_ex(sg_world *world, const sg_solid_rows *rows,
              const sg_solid_old *old, int32_t s, sg_crew *crew)
{
  sg_solid_over over;
  int good = sg_solid_over_match(rows, old, &sg_prolog_poll, &over)
                 ? TRUE
                 : failed_ex();

  if (good && is_unfit(rows, old, &over)) {
    good = PL_exception(0) ? FALSE : -1;
  } else if (good) {
    good = sg_solid_over_write(rows, old, s, crew, &sg_prolog_poll, &over)
               ? exchange_all_ex(world, old, &over)
               : failed_ex();
  }
  sg_solid_over_clear(&over);
  return good;
}

/* The same, of a solid. */
static int
write_solid_ex(sg_world *world, const sg_solid *solid, const sg_solid_old *old,
               int32_t s, sg_crew *crew)
{
  sg_solid_rows rows = {0};
  int good = sg_solid_rows_make(solid, crew, &sg_prolog_poll, &rows)
                 ? write_over_ex(world, &rows, old, s, crew)
                 : failed_ex();

  sg_solid_rows_clear(&rows);
  return good;
}

/* The same, from the rows of a version. */
static int
read_and_write_ex(sg_world *world, const sg_view view[SG_OLD_RELATIONS],
                  const sg_solid *solid, int32_t s, sg_crew *crew)
{
  const sg_view *of[SG_OLD_RELATIONS];
  sg_solid_old old;
  int good = FALSE;

  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    of[k] = &view[k];
  }
  switch (sg_solid_old_read(of, s, sg_term_vertex, &sg_prolog_poll, &old)) {
  case SG_OLD_READ:
    good = write_solid_ex(world, solid, &old, s, crew);
    break;
  case SG_OLD_UNFIT:
    good = -1;
    break;
  case SG_OLD_FAILED:
    good = failed_ex();
    break;
  }
  sg_solid_old_clear(&old);
  return good;
}

static int
with_views_ex(sg_world *world, const sg_version *version, const sg_solid *solid,
              int32_t s)
{
  sg_view view[SG_OLD_RELATIONS] = {{0}};
  sg_crew *crew = sg_crew_open(0);
  bool good = crew;

  for (int k = 0; good && k < SG_OLD_RELATIONS; k++) {
    good = sg_version_view(version, sg_old_relation[k], &view[k]);
  }
  int end =
      good ? read_and_write_ex(world, view, solid, s, crew) : sg_no_memory();

  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    sg_view_clear(&view[k]);
  }
  sg_crew_close(crew);
  return end;
}

/* solid_write_over(+Solid, +S) is semidet. */
static foreign_t
solid_write_over(term_t solid_term, term_t s_term)
{
  sg_world *world = sg_current_world_ex();
  sg_solid *solid;
  int32_t s;

  if (!world || !sg_get_solid_ex(solid_term, &solid) ||
      !sg_get_id_ex(s_term, &s) || !sg_claim_ex(world)) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  int good = with_views_ex(world, version, solid, s);

  sg_version_drop(version);
  sg_world_release(world);
  return good == TRUE;
}

/* solid_write_region(+Solid, +S, +Region) is semidet. */
static foreign_t
solid_write_region(term_t solid_term, term_t s_term, term_t region)
{
  sg_world *world = sg_current_world_ex();
  sg_region_handle *h;
  sg_solid *solid;
  int32_t s;

  if (!world || !sg_get_solid_ex(solid_term, &solid) ||
      !sg_get_id_ex(s_term, &s) || !sg_get_region_ex(region, &h) ||
      !sg_claim_ex(world)) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  sg_crew *crew = sg_crew_open(0);
  int good = !crew ? sg_no_memory()
             : s == h->s && sg_segment_stamp(version, s) == h->stamp
                 ? write_solid_ex(world, solid, &h->old, s, crew)
                 : -1;

  sg_crew_close(crew);
  sg_version_drop(version);
  sg_world_release(world);
  return good == TRUE;
}

static const PL_extension predicates[] = {
    {"solid_write_region", 3, solid_write_region, 0},
    {"solid_write_over", 2, solid_write_over, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_solid_over(void)
{
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
