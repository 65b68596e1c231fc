/* schema.c -- relations.def as a table. */
#include "store.h"

const sg_relation_info sg_relation_table[SG_RELATIONS] = {
#define RELATION(ID, NAME, ARITY, KEY, DOC)                                    \
  [SG_##ID].name = #NAME, [SG_##ID].arity = (ARITY), [SG_##ID].key = (KEY),    \
  [SG_##ID].doc = (DOC),
#define COLUMN(ID, POSITION, NAME, TYPE, REFERS, DOC)                          \
  [SG_##ID].column[POSITION] = {#NAME, SG_##TYPE, SG_##REFERS, DOC},
#define DOMAIN(ID, POSITION, WORDS) [SG_##ID].domain[POSITION] = (WORDS),
#define MOST(ID, POSITION, SIZE)    [SG_##ID].most[POSITION] = (SIZE),
#define SIGNED(ID, POSITION, REFERS)                                           \
  [SG_##ID].with_sign[POSITION] = true,                                        \
  [SG_##ID].negative[POSITION] = SG_##REFERS,
#define DERIVED(ID) [SG_##ID].derived = true,
#include "relations.def"
};

/* The column that a relation's ids are in: the last of its key, an id or a
 * segment and an id, when nothing else gives it its values. SG_MAX_COLUMNS: the
 * relation has no ids. */
unsigned
sg_relation_id_column(sg_relation relation)
{
  const sg_relation_info *info = &sg_relation_table[relation];
  uint32_t others = info->key & (info->key - 1); /* without the lowest */
  unsigned last;

  if (info->key == 0 || (others & (others - 1)) != 0) {
    return SG_MAX_COLUMNS;
  }
  last = 31 - (unsigned)__builtin_clz(info->key);
  return info->column[last].type == SG_INT &&
                 info->column[last].refers == SG_NONE
             ? last
             : SG_MAX_COLUMNS;
}

/* The column that says in which segment column `column`'s ids are: the S
 * nearest before it. */
unsigned
sg_relation_segment_column(sg_relation relation, unsigned column)
{
  const sg_relation_info *info = &sg_relation_table[relation];

  while (column > 0 && info->column[column].name[0] != 'S') {
    column--;
  }
  return column;
}
