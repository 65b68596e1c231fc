/* bulk.c -- many rows at once: column by column, all or nothing. */
#include "world.h"

#include <float.h>
#include <math.h>
#include <string.h>

typedef struct load {
  sg_world *world;
  sg_relation relation;
  sg_table *table;
  const sg_relation_info *info;
  size_t n;
  const void *const *column;
  sg_map *map;  /* owned */
  sg_row first; /* the first slot; the others follow it */
  sg_fault *fault;
} load;

static sg_value
load_value(const load *l, unsigned c, size_t i)
{
  sg_value value = {0};

  switch (l->info->column[c].type) {
  case SG_INT:
  case SG_ATOM:
    value.i = ((const int32_t *)l->column[c])[i];
    break;
  case SG_FLOAT:
    value.f = ((const double *)l->column[c])[i];
    break;
  case SG_LIST:
    value.list = ((const int32_t *const *)l->column[c])[i];
    break;
  case SG_TERM:
    value.term = ((const uint32_t *const *)l->column[c])[i];
    break;
  }
  return value;
}

/* ---- checks ------------------------------------------------------------ */

static bool
ints_are_valid(const int32_t *id, size_t n, int32_t least)
{
  bool valid = true;

  for (size_t i = 0; i < n; i++) {
    valid &= id[i] >= least;
  }
  return valid;
}

static bool
floats_are_valid(const double *x, size_t n, double most)
{
  double size = most > 0 ? most : DBL_MAX;
  bool valid = true;

  for (size_t i = 0; i < n; i++) {
    valid &= fabs(x[i]) <= size; /* no NaN, not infinite */
  }
  return valid;
}

/* A whole column at once: true is certain, false must be looked at. */
static bool
column_is_valid(const load *l, unsigned c)
{
  sg_type type = l->info->column[c].type;

  return (type == SG_INT && ints_are_valid(l->column[c], l->n, 1)) ||
         (type == SG_ATOM && ints_are_valid(l->column[c], l->n, 0)) ||
         (type == SG_FLOAT &&
          floats_are_valid(l->column[c], l->n, l->info->most[c]));
}

static sg_status
check_values(const load *l)
{
  for (unsigned c = 0; c < l->info->arity; c++) {
    if (column_is_valid(l, c)) {
      continue;
    }
    for (size_t i = 0; i < l->n; i++) {
      if (!sg_value_is_valid(l->info, c, load_value(l, c, i))) {
        *l->fault = (sg_fault){.row = i, .column = c};
        return SG_INVALID;
      }
    }
  }
  return SG_OK;
}

static sg_status
check_references(const load *l)
{
  for (unsigned c = 0; c < l->info->arity; c++) {
    unsigned in = sg_relation_segment_column(l->relation, c);
    if (l->info->column[c].refers == SG_NONE) {
      continue;
    }
    for (size_t i = 0; i < l->n; i++) {
      sg_status status = sg_world_check_reference(
          l->world, l->relation, c, load_value(l, in, i).i, load_value(l, c, i),
          l->fault);
      if (status != SG_OK) {
        l->fault->row = i;
        return status;
      }
    }
  }
  return SG_OK;
}

/* ---- writing ----------------------------------------------------------- */

/* Rows of the load that lie on one page. */
typedef struct part {
  sg_page *page;
  sg_live *live;
  unsigned place, count; /* places of the page */
  size_t from;           /* rows of the load */
} part;

/* The part that begins with row `from`; false: there is none. */
static bool
part_at(const load *l, size_t from, part *out)
{
  sg_row row = l->first + (sg_row)from;

  if (from >= l->n) {
    return false;
  }
  out->page = sg_table_page(l->table, row);
  out->place = row % SG_PAGE_ROWS;
  out->count = SG_PAGE_ROWS - out->place;
  if (out->count > l->n - from) {
    out->count = (unsigned)(l->n - from);
  }
  out->from = from;
  out->live = NULL;
  return true;
}

/* Room for everything but lists and terms; after it only they can fail. */
static bool
reserve(load *l)
{
  part p;

  if (!sg_table_reserve(l->table, l->n)) {
    return false;
  }
  for (size_t i = 0; part_at(l, i, &p); i += p.count) {
    if (!sg_map_own_live(l->map, p.page, (l->first + i) / SG_PAGE_ROWS)) {
      return false;
    }
  }
  return true;
}

static void
copy_ints(const part *p, unsigned c, const int32_t *from)
{
  memcpy(p->page->cells[c].i + p->place, from + p->from,
         p->count * sizeof(*from));
}

static void
copy_floats(const part *p, unsigned c, const double *from)
{
  double *to = p->page->cells[c].f + p->place;

  for (unsigned i = 0; i < p->count; i++) {
    to[i] = from[p->from + i] + 0.0; /* no -0.0 */
  }
}

static void
forget_refs(const load *l, unsigned c, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    sg_row row = l->first + (sg_row)i;
    sg_arena_give(
        &l->table->arena,
        sg_table_page(l->table, row)->cells[c].ref[row % SG_PAGE_ROWS]);
  }
}

/* False: no memory, nothing of the column is left. */
static bool
copy_refs(const load *l, unsigned c)
{
  for (size_t i = 0; i < l->n; i++) {
    sg_row row = l->first + (sg_row)i;
    const uint32_t *copy =
        sg_table_keep(l->table, l->info->column[c].type, load_value(l, c, i));
    if (!copy) {
      forget_refs(l, c, i);
      return false;
    }
    sg_table_page(l->table, row)->cells[c].ref[row % SG_PAGE_ROWS] = copy;
  }
  return true;
}

static bool
is_ref(const load *l, unsigned c)
{
  return l->info->column[c].type == SG_LIST ||
         l->info->column[c].type == SG_TERM;
}

static bool
copy_cells(const load *l)
{
  for (unsigned c = 0; c < l->info->arity; c++) {
    part p;
    if (is_ref(l, c)) {
      if (!copy_refs(l, c)) {
        while (c-- > 0) {
          if (is_ref(l, c)) {
            forget_refs(l, c, l->n);
          }
        }
        return false;
      }
      continue;
    }
    for (size_t i = 0; part_at(l, i, &p); i += p.count) {
      if (l->info->column[c].type == SG_FLOAT) {
        copy_floats(&p, c, l->column[c]);
      } else {
        copy_ints(&p, c, l->column[c]);
      }
    }
  }
  return true;
}

/* Makes `count` bits from `place` on 1. */
static void
set_bits(uint64_t *word, unsigned place, unsigned count)
{
  while (count > 0) {
    unsigned bit = place % 64;
    unsigned n = 64 - bit < count ? 64 - bit : count;
    uint64_t ones = n == 64 ? ~UINT64_C(0) : (UINT64_C(1) << n) - 1;
    word[place / 64] |= ones << bit;
    place += n;
    count -= n;
  }
}

/* The rows are taken and live. */
static void
show(const load *l)
{
  part p;

  for (size_t i = 0; part_at(l, i, &p); i += p.count) {
    sg_live *live =
        sg_map_own_live(l->map, p.page, (l->first + i) / SG_PAGE_ROWS);
    set_bits(p.page->taken, p.place, p.count);
    set_bits(live->word, p.place, p.count);
  }
  l->map->rows += l->n;
  l->table->slots += (sg_row)l->n;
  l->table->written += l->n;
  l->table->changes += l->n;
}

/* Takes the rows back; `linked` of them are in the key's index. */
static void
hide(const load *l, size_t linked)
{
  for (size_t i = l->n; i-- > 0;) {
    sg_row row = l->first + (sg_row)i;
    sg_live *live = sg_map_own_live(l->map, sg_table_page(l->table, row),
                                    row / SG_PAGE_ROWS);
    live->word[row % SG_PAGE_ROWS / 64] &= ~(UINT64_C(1) << row % 64);
    if (i < linked) {
      sg_index_remove(&l->table->index[0], l->table, row);
    }
    sg_table_vacate(l->table, row);
  }
  l->map->rows -= l->n;
  l->table->slots = l->first;
}

/* ---- keys, indexes, ids ------------------------------------------------ */

/* Enters the rows in the key's index, each with a key of its own. */
static sg_status
link_keys(const load *l)
{
  sg_index *index = &l->table->index[0];

  if (l->info->key == 0) {
    return SG_OK;
  }
  if (!sg_index_reserve(index, l->table, l->n)) {
    hide(l, 0);
    return SG_NO_MEMORY;
  }
  for (size_t i = 0; i < l->n; i++) {
    if (!sg_table_link_key(l->table, l->map, l->first + (sg_row)i)) {
      hide(l, i);
      *l->fault = (sg_fault){.row = i};
      return SG_EXISTS;
    }
  }
  return SG_OK;
}

/* The other indexes; one for which there is no memory is built again when it
 * is used. */
static void
link_others(const load *l)
{
  for (unsigned k = l->info->key ? 1 : 0; k < l->table->indexes; k++) {
    sg_index *index = &l->table->index[k];
    for (size_t i = 0; index->built && i < l->n; i++) {
      if (!sg_index_add(index, l->table, l->first + (sg_row)i)) {
        sg_index_clear(index);
      }
    }
  }
}

/* Stamps, and notes the largest id of, each run of rows of one segment. */
static bool
note_ids(const load *l)
{
  unsigned column = sg_relation_id_column(l->relation);
  const int32_t *id;
  const int32_t *s;

  if (column == SG_MAX_COLUMNS) {
    return true;
  }
  id = l->column[column];
  s = column == 0 ? NULL : l->column[0];
  for (size_t i = 0; i < l->n;) {
    int32_t of = s ? s[i] : 0;
    int32_t last = id[i];
    for (i++; i < l->n && (!s || s[i] == of); i++) {
      last = id[i] > last ? id[i] : last;
    }
    if (!sg_map_used_id(l->map, of, last) ||
        !sg_world_stamp(l->world, l->map, l->relation, of)) {
      return false;
    }
  }
  return true;
}

/* ---- together ---------------------------------------------------------- */

static sg_status
add_many(load *l)
{
  sg_status status = check_values(l);

  status = status == SG_OK ? check_references(l) : status;
  if (status != SG_OK) {
    return status;
  }
  if (!(l->map = sg_world_own_map(l->world, l->relation)) ||
      !sg_world_key_ready(l->world, l->relation)) {
    return SG_NO_MEMORY;
  }
  sg_world_sweep_if_worth(l->world, l->relation);
  l->first = l->table->slots;
  if (!reserve(l) || !note_ids(l) || !copy_cells(l)) {
    return SG_NO_MEMORY;
  }
  show(l);
  status = link_keys(l);
  if (status == SG_OK) {
    link_others(l);
  }
  return status;
}

sg_status
sg_world_add_many(sg_world *world, sg_relation relation, size_t n,
                  const void *const *column, sg_fault *fault)
{
  sg_fault unused;
  sg_status status;

  sg_world_enter(world);
  status = add_many(&(load){.world = world,
                            .relation = relation,
                            .table = &world->table[relation],
                            .info = &sg_relation_table[relation],
                            .n = n,
                            .column = column,
                            .fault = fault ? fault : &unused});
  if (status == SG_OK && n > 0) {
    sg_world_changed(world);
  }
  sg_world_leave(world);
  return status;
}
