/* plain_facts_rows.c -- plain facts of a model file become rows; see
 * rules/model/model_plain.pl.
 *
 * Layer: rows.
 */
#include "plain_facts_rows.h"

#include "doors/file.h"
#include "engine/search.h"
#include "engine/symbol.h"

#include <stdlib.h>
#include <string.h>

enum { AT_ONCE = 1 << 16 }; /* facts between questions for a stop */

bool
sg_door_plain_facts_open(sg_call *call, const sg_input *source,
                         sg_plain_facts **out)
{
  sg_plain_facts *facts = calloc(1, sizeof *facts);

  if (!facts) {
    return sg_call_no_memory(call);
  }
  if (!sg_call_read_all(call, source, SIZE_MAX / 2, &facts->text,
                        &facts->size)) {
    sg_plain_facts_free(facts);
    return false;
  }
  *out = facts;
  return true;
}

bool
sg_door_plain_facts_take(sg_call *call, sg_plain_facts *facts, int32_t shift,
                         const sg_text_place *from, sg_text_place *to)
{
  int64_t before;

  *to = *from;
  if (from->octet < 0 || (size_t)from->octet > facts->size) {
    return sg_call_domain(call, "place", 3);
  }
  do {
    before = to->octet;
    if (!sg_plain_facts_take(facts, shift, AT_ONCE, to)) {
      return sg_call_no_memory(call);
    }
  } while (to->octet > before && !sg_cancelled(&call->cancel));
  return !call->stopped;
}

/* ---- rows --------------------------------------------------------------- */

bool
sg_plain_rows_add(sg_world *world, const sg_plain_facts *facts,
                  sg_relation relation, const int32_t *const *list)
{
  const sg_plain_rows *rows = &facts->of[relation];
  const sg_relation_info *info = &sg_relation_table[relation];
  const void *column[SG_MAX_COLUMNS];
  sg_fault fault;

  for (unsigned c = 0; c < info->arity; c++) {
    const sg_plain_column *from = &rows->column[c];
    sg_type type = info->column[c].type;

    column[c] = type == SG_FLOAT  ? (const void *)from->f
                : type == SG_LIST ? (const void *)list
                                  : (const void *)from->i;
  }
  return rows->n == 0 ||
         sg_world_add_many(world, relation, rows->n, column, &fault) == SG_OK;
}

/* The lists of a relation, where they stand; null: no memory. */
static const int32_t **
lists_of(sg_call *call, const sg_plain_facts *facts, sg_relation relation)
{
  const sg_plain_rows *rows = &facts->of[relation];
  const int32_t **list = sg_call_alloc(call, (rows->n + 1) * sizeof *list);

  for (size_t i = 0; list && i < rows->n; i++) {
    list[i] = facts->word + rows->column[2].at[i];
  }
  return list;
}

static bool
find_relation(const char *name, sg_relation *out)
{
  for (int r = 0; r < SG_RELATIONS; r++) {
    if (strcmp(sg_relation_table[r].name, name) == 0) {
      *out = (sg_relation)r;
      return true;
    }
  }
  return false;
}

bool
sg_door_plain_facts_add(sg_call *call, sg_plain_facts *facts, const char *name)
{
  sg_relation relation;
  const int32_t **list = NULL;

  if (!find_relation(name, &relation)) {
    return sg_call_domain(call, "relation", 2);
  }
  if (facts->of[relation].n == 0) {
    return true;
  }
  if (relation == SG_P || relation == SG_LEAF_P) {
    list = lists_of(call, facts, relation);
    if (!list) {
      return false;
    }
  }
  sg_world *world = sg_call_claim(call);
  bool good = world && (relation != SG_P ||
                        sg_plain_polygons_ready(call, world, facts, list));

  good = good && sg_plain_rows_add(world, facts, relation, list);
  if (world) {
    sg_world_release(world);
  }
  return good;
}

/* ---- segments ----------------------------------------------------------- */

bool
sg_door_plain_facts_segments(sg_call *call, sg_plain_facts *facts,
                             sg_int_list *ss)
{
  static const sg_relation relation[] = {SG_V, SG_E, SG_P};

  for (size_t k = 0; k < 3; k++) {
    const sg_plain_rows *rows = &facts->of[relation[k]];

    for (size_t i = 0; i < rows->n; i++) {
      int32_t s = rows->column[0].i[i];

      if ((ss->n == 0 || ss->at[ss->n - 1] != s) &&
          !sg_int_list_add(call, ss, s)) {
        return false;
      }
    }
  }
  ss->n = sg_sort_ids(ss->at, ss->n);
  return true;
}
