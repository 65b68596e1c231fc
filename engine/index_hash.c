/* index_hash.c -- hashes of the values of a row. */
#include "index_hash.h"

#include "table.h"

#include <string.h>

#define MIX UINT64_C(0x9e3779b97f4a7c15)

/* A hash in the making. The low bits of the last id are kept apart: they
 * become the low bits of the head's number, unmixed. */
typedef struct mixer {
  uint64_t h;
  uint64_t near;
} mixer;

static void
mix(mixer *m, uint64_t value)
{
  m->h = ((m->h + m->near * MIX) ^ (value >> SG_NEAR_BITS)) * MIX;
  m->h ^= m->h >> 32;
  m->near = value & ((1U << SG_NEAR_BITS) - 1);
}

/* High bits mixed, low SG_NEAR_BITS those of the last id. */
static uint64_t
mixed(const mixer *m)
{
  return (m->h * MIX & ~(uint64_t)((1U << SG_NEAR_BITS) - 1)) | m->near;
}

static uint64_t
list_hash(const int32_t *list)
{
  mixer m = {0};

  for (int32_t i = 0; i <= list[0]; i++) {
    mix(&m, (uint32_t)list[i]);
  }
  return mixed(&m);
}

static uint64_t
value_hash(sg_type type, sg_value value)
{
  uint64_t bits;

  switch (type) {
  case SG_INT:
  case SG_ATOM:
    return (uint32_t)value.i;
  case SG_FLOAT:
    memcpy(&bits, &value.f, sizeof(bits));
    return bits;
  case SG_LIST:
    return list_hash(value.list);
  case SG_TERM:
    return sg_term_hash(value.term);
  }
  return 0;
}

uint64_t
sg_index_hash(const sg_relation_info *info, uint16_t mask, const sg_value *row)
{
  mixer m = {0};

  for (unsigned left = mask; left; left &= left - 1) {
    unsigned c = (unsigned)__builtin_ctz(left);
    mix(&m, value_hash(info->column[c].type, row[c]));
  }
  return mixed(&m);
}

uint64_t
sg_index_hash_member(int32_t s, int32_t member)
{
  mixer m = {0};

  mix(&m, (uint32_t)s);
  mix(&m, (uint32_t)member);
  return mixed(&m);
}

/* The row's ids, without the way through values: most indexes have only
 * ids. */
static uint64_t
id_hash(const sg_page *page, unsigned mask, unsigned place)
{
  mixer m = {0};

  for (; mask; mask &= mask - 1) {
    mix(&m, (uint32_t)page->cells[__builtin_ctz(mask)].i[place]);
  }
  return mixed(&m);
}

static bool
only_ids(const sg_relation_info *info, unsigned mask)
{
  for (; mask; mask &= mask - 1) {
    sg_type type = info->column[__builtin_ctz(mask)].type;
    if (type != SG_INT && type != SG_ATOM) {
      return false;
    }
  }
  return true;
}

uint64_t
sg_index_hash_row(const sg_index *index, const sg_table *table, sg_row row)
{
  const sg_page *page = sg_table_page(table, row);
  sg_value value[SG_MAX_COLUMNS];

  if (only_ids(table->info, index->mask)) {
    return id_hash(page, index->mask, row % SG_PAGE_ROWS);
  }
  sg_page_row(page, table->info, index->mask, row % SG_PAGE_ROWS, value);
  return sg_index_hash(table->info, index->mask, value);
}
