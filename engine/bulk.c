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
  sg_append append; /* of them */
  const sg_cancel *cancel;
  sg_fault *fault;
} load;

enum { ROWS_ASKED = 1024 }; /* rows that are checked between questions */

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

/* Rows refer to the same as the row before, as often as not. */
static bool
refers_as_before(const load *l, unsigned in, unsigned c, size_t i)
{
  const int32_t *s = l->column[in], *id = l->column[c];

  return i > 0 && l->info->column[c].type == SG_INT && s[i] == s[i - 1] &&
         id[i] == id[i - 1];
}

/* Rows that were found to be there: as many rows refer to one, they are not
 * looked for again while they are remembered. */
enum { FOUND = 128 };
typedef struct found {
  sg_relation in;
  int32_t row[FOUND][2]; /* segment, id; 0: none */
} found;

/* Whether the row is remembered, which it is from now on. Only ids that are all
 * positive are. */
static bool
is_found(found *known, sg_relation in, int32_t s, int32_t id)
{
  int32_t *row = known->row[((uint32_t)id + 31 * (uint32_t)s) % FOUND];

  if (known->in != in) {
    *known = (found){.in = in};
  }
  bool is = row[0] == s && row[1] == id;

  row[0] = s;
  row[1] = id;
  return is;
}

/* Whether the cancellation says stop: it is asked without the lock. */
static bool
is_stopped(const load *l, size_t i)
{
  if (!l->cancel || i % ROWS_ASKED != 0) {
    return false;
  }
  sg_world_leave(l->world);
  bool stopped = sg_cancelled(l->cancel);

  sg_world_enter(l->world);
  return stopped;
}

static sg_status
check_references(const load *l)
{
  found known = {.in = SG_NONE};

  for (unsigned c = 0; c < l->info->arity; c++) {
    unsigned in = sg_relation_segment_column(l->relation, c);
    bool plain = l->info->column[c].type == SG_INT && !l->info->with_sign[c];
    if (l->info->column[c].refers == SG_NONE) {
      continue;
    }
    for (size_t i = 0; i < l->n; i++) {
      if (is_stopped(l, i)) {
        return SG_HALTED;
      }
      if (refers_as_before(l, in, c, i) ||
          (plain && is_found(&known, l->info->column[c].refers,
                             load_value(l, in, i).i, load_value(l, c, i).i))) {
        continue;
      }
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

static void
copy_floats(double *to, const double *from, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    to[i] = from[i] + 0.0; /* no -0.0 */
  }
}

/* False: no memory; the append knows what it has. */
static bool
copy_refs(const load *l, unsigned c, const sg_sheet_page *page)
{
  for (size_t i = 0; i < page->n; i++) {
    const uint32_t *copy = sg_table_keep(l->table, l->info->column[c].type,
                                         load_value(l, c, page->from + i));
    if (!copy) {
      return false;
    }
    page->column[c].list[i] = (int32_t *)copy;
  }
  return true;
}

static bool
copy_page(const load *l, const sg_sheet_page *page)
{
  for (unsigned c = 0; c < l->info->arity; c++) {
    switch (l->info->column[c].type) {
    case SG_INT:
    case SG_ATOM:
      memcpy(page->column[c].i, (const int32_t *)l->column[c] + page->from,
             page->n * sizeof(int32_t));
      break;
    case SG_FLOAT:
      copy_floats(page->column[c].f, (const double *)l->column[c] + page->from,
                  page->n);
      break;
    case SG_LIST:
    case SG_TERM:
      if (!copy_refs(l, c, page)) {
        return false;
      }
    }
  }
  return true;
}

/* The rows are there and live, but in no index; that of keys has all others,
 * also after the sweep that may make room. */
static sg_status
write_rows(load *l)
{
  sg_append *a = &l->append;
  bool good = sg_append_begin(a, l->world, l->relation, l->n) &&
              sg_world_key_ready(l->world, l->relation);

  a->keyed = true;
  for (size_t k = 0; good && k < a->sheet.pages; k++) {
    sg_append_want_refs(a, k);
    good = copy_page(l, &a->sheet.page[k]);
  }
  return good && sg_append_show(a) ? SG_OK : SG_NO_MEMORY;
}

static sg_row
slot_of(const load *l, size_t i)
{
  sg_sheet_place at = sg_sheet_at(&l->append.sheet, i);

  return at.page->slot + (sg_row)at.at;
}

/* Slots at the end are free again at once; a sweep finds the others. */
static void
give_back(const load *l)
{
  sg_table *table = l->table;

  for (size_t k = l->append.sheet.pages; k-- > 0;) {
    const sg_sheet_page *page = &l->append.sheet.page[k];
    if (page->slot + page->n == table->slots) {
      table->slots = page->slot;
    }
  }
  for (unsigned i = 0; i < table->indexes; i++) {
    sg_index_wait(&table->index[i], table->slots);
  }
}

/* Takes the rows back. */
static void
hide(const load *l)
{
  sg_map *map = sg_world_own_map(l->world, l->relation); /* it is owned */

  for (size_t i = l->n; i-- > 0;) {
    sg_row row = slot_of(l, i);
    sg_live *live =
        sg_map_own_live(map, sg_table_page(l->table, row), row / SG_PAGE_ROWS);
    live->word[row % SG_PAGE_ROWS / 64] &= ~(UINT64_C(1) << row % 64);
    sg_index_unlink(&l->table->index[0], l->table, row);
    sg_table_vacate(l->table, row);
  }
  map->rows -= l->n;
  give_back(l);
}

/* Enters the rows in the key's index, each with a key of its own. The other
 * indexes take them in when they are used. */
static sg_status
link_keys(const load *l)
{
  sg_index *index = &l->table->index[0];
  const sg_map *map = l->world->current->map[l->relation];

  if (l->info->key == 0) {
    return SG_OK;
  }
  if (!sg_index_reserve(index, l->table, l->n)) {
    hide(l);
    return SG_NO_MEMORY;
  }
  sg_index_catch_up(index, l->table);
  for (size_t i = 0; i < l->n; i++) {
    if (!sg_table_link_key(l->table, map, slot_of(l, i))) {
      hide(l);
      *l->fault = (sg_fault){.row = i};
      return SG_EXISTS;
    }
  }
  return SG_OK;
}

/* ---- together ---------------------------------------------------------- */

static sg_status
add_many(load *l)
{
  sg_status status = check_values(l);

  status = status == SG_OK ? check_references(l) : status;
  if (status != SG_OK || l->n == 0) {
    return status;
  }
  status = write_rows(l);
  status = status == SG_OK ? link_keys(l) : status;
  sg_append_end(&l->append);
  return status;
}

sg_status
sg_world_add_many(sg_world *world, sg_relation relation, size_t n,
                  const void *const *column, sg_fault *fault)
{
  return sg_world_add_many_or_stop(world, relation, n, column, NULL, fault);
}

sg_status
sg_world_add_many_or_stop(sg_world *world, sg_relation relation, size_t n,
                          const void *const *column, const sg_cancel *cancel,
                          sg_fault *fault)
{
  sg_fault unused;
  sg_status status;

  if (!sg_world_claim(world, cancel)) {
    return SG_HALTED;
  }
  sg_world_enter(world);
  status = add_many(&(load){.world = world,
                            .relation = relation,
                            .table = &world->table[relation],
                            .info = &sg_relation_table[relation],
                            .n = n,
                            .column = column,
                            .cancel = cancel,
                            .fault = fault ? fault : &unused});
  if (status == SG_OK && n > 0) {
    sg_world_changed(world);
  }
  sg_world_leave(world);
  sg_world_release(world);
  return status;
}
