/* whole.c -- every row that is referred to is there: made sure of where
 * something was edited.
 *
 * Looks at what the marks of the current version name (mark.c) and at nothing
 * else. A row that refers to a row that is not there is a *breach*, if its
 * relation keeps what it refers to; a row of a derived relation, or any row
 * when the change cascades, is dropped, and so is then what refers to it. First
 * it is made sure that there is no breach, so a world that has one stays as it
 * is.
 *
 * References lead to relations above (relations.def), so one pass downwards
 * finds all rows: by indexes where few rows have gone, or by one look at all.
 */
#include "list.h"
#include "suspect.h"
#include "world.h"

#include <stdlib.h>

enum { ROWS_A_LOOK = 64 }; /* rows looked at in the time of one look-up */

typedef struct dropped {
  sg_relation relation;
  sg_row row;
} dropped;

typedef struct check {
  sg_world *world;
  const sg_version *version;
  bool cascade;
  bool drops; /* this pass drops rows, the one before it finds a breach */
  bool made;  /* marks of kernels are read */
  bool broken;
  sg_breach *breach;
  sg_suspects of[SG_RELATIONS];
  dropped *drop; /* [n] */
  size_t n, room;
} check;

/* ---- the schema ---------------------------------------------------------- */

/* The relation in which a column's id is looked up; SG_NONE: in none. */
static sg_relation
target_of(const sg_relation_info *info, unsigned column, int32_t id)
{
  return id < 0 && info->with_sign[column] ? info->negative[column]
                                           : info->column[column].refers;
}

static bool
column_refers(const sg_relation_info *info, unsigned column, sg_relation to)
{
  return info->column[column].refers == to ||
         (info->with_sign[column] && info->negative[column] == to);
}

bool
sg_relation_refers(sg_relation relation, sg_relation to)
{
  const sg_relation_info *info = &sg_relation_table[relation];

  for (unsigned c = 0; c < info->arity; c++) {
    if (column_refers(info, c, to)) {
      return true;
    }
  }
  return false;
}

/* ---- one row ------------------------------------------------------------- */

static bool
is_there(const check *c, sg_relation relation, int32_t s, int32_t id)
{
  sg_value key[SG_MAX_COLUMNS] = {[0].i = s};

  key[sg_relation_id_column(relation)].i = id;
  return sg_version_find(c->version, relation, key) != SG_NO_ROW;
}

/* The row (s, id), which some row refers to, is not there. */
static bool
is_missing(const check *c, sg_relation relation, int32_t s, int32_t id)
{
  const sg_suspects *x = &c->of[relation];

  return sg_has_gone(x, s, id) ||
         ((x->all || (x->ofs > 0 && sg_may_concern(x, s))) &&
          !is_there(c, relation, s, id));
}

/* A row refers to what is not there. `to`: only to rows of this relation, that
 * are suspected; SG_NONE: to any. */
static bool
row_dangles(const check *c, sg_relation relation, const sg_page *page,
            unsigned place, sg_relation to, sg_breach *out)
{
  const sg_relation_info *info = &sg_relation_table[relation];

  for (unsigned k = 0; k < info->arity; k++) {
    unsigned in = sg_relation_segment_column(relation, k);
    int32_t s = page->cells[in].i[place];
    if (info->column[k].refers == SG_NONE ||
        (to != SG_NONE &&
         (!column_refers(info, k, to) || !sg_may_concern(&c->of[to], s)))) {
      continue;
    }
    sg_value value = sg_page_value(page, info, k, place);
    bool list = info->column[k].type == SG_LIST;
    const int32_t *id = list ? value.list + 1 : &value.i;
    for (int32_t i = 0, n = list ? value.list[0] : 1; i < n; i++) {
      sg_relation of = target_of(info, k, id[i]);
      int32_t wanted = id[i] < 0 ? -id[i] : id[i];
      if ((to == SG_NONE || of == to) &&
          (is_missing(c, of, s, wanted) ||
           (to == SG_NONE && !is_there(c, of, s, wanted)))) {
        *out = (sg_breach){
            .relation = relation, .missing = of, .s = s, .id = wanted};
        return true;
      }
    }
  }
  return false;
}

/* A row is found that refers to what is not there. False: no memory. */
static bool
hit(check *c, const sg_breach *found, const sg_page *page)
{
  sg_relation relation = found->relation;
  sg_id_pair pair;

  if (!c->drops) {
    c->broken = true;
    *c->breach = *found;
    return true;
  }
  if (!sg_list_grow(&c->drop, c->n, &c->room, sizeof *c->drop)) {
    return false;
  }
  c->drop[c->n++] = (dropped){relation, found->row};
  return !sg_page_pair(page, relation, found->row % SG_PAGE_ROWS, &pair.s,
                       &pair.id) ||
         sg_suspect_gone(&c->of[relation], pair.s, pair.id);
}

/* Looks at one row that lives. */
static bool
look(check *c, sg_relation relation, sg_row row, sg_relation to)
{
  const sg_page *page = sg_table_page(&c->world->table[relation], row);
  sg_breach found;

  if (!row_dangles(c, relation, page, row % SG_PAGE_ROWS, to, &found)) {
    return true;
  }
  found.row = row;
  return hit(c, &found, page);
}

/* ---- the rows that refer to one relation --------------------------------- */

/* The columns by which rows of one relation refer to another. */
typedef struct links {
  unsigned n;
  unsigned column[SG_MAX_COLUMNS], in[SG_MAX_COLUMNS];
} links;

static links
links_of(sg_relation relation, sg_relation to)
{
  links out = {0};

  for (unsigned k = 0; k < sg_relation_table[relation].arity; k++) {
    if (column_refers(&sg_relation_table[relation], k, to)) {
      out.column[out.n] = k;
      out.in[out.n++] = sg_relation_segment_column(relation, k);
    }
  }
  return out;
}

/* False: none of the suspects is meant by a row. */
static bool
may_be_meant(const sg_relation_info *info, const links *by,
             const sg_suspects *x, const sg_page *page, unsigned place)
{
  for (unsigned i = 0; i < by->n; i++) {
    unsigned k = by->column[i];
    int32_t s = page->cells[by->in[i]].i[place];
    if (s < x->first_s || s > x->last_s) {
      continue;
    }
    if (info->column[k].type == SG_LIST) {
      return true;
    }
    int32_t id = page->cells[k].i[place];
    if ((id >= x->first_id && id <= x->last_id) || id < 0) {
      return true;
    }
  }
  return false;
}

/* False: no row of a page does. */
static bool
page_may_mean(const links *by, const sg_suspects *x, const sg_page *page)
{
  for (unsigned i = 0; i < by->n; i++) {
    if (by->in[i] != 0) {
      return true;
    }
  }
  return sg_page_first(page) <= x->last_s && sg_page_last(page) >= x->first_s;
}

static bool
scan(check *c, sg_relation relation, sg_relation to)
{
  const sg_map *map = c->version->map[relation];
  const sg_relation_info *info = &sg_relation_table[relation];
  size_t pages = map ? map->chunks * SG_CHUNK_PAGES : 0;
  links by = {0};

  if (to != SG_NONE) {
    by = links_of(relation, to);
  }
  for (size_t i = 0; i < pages; i++) {
    const sg_live *live = sg_map_live(map, i);
    if (!live ||
        (to != SG_NONE && !page_may_mean(&by, &c->of[to], live->page))) {
      continue;
    }
    for (unsigned r = sg_live_next(live->word, 0); r < SG_PAGE_ROWS;
         r = sg_live_next(live->word, r + 1)) {
      if (to != SG_NONE &&
          !may_be_meant(info, &by, &c->of[to], live->page, r)) {
        continue;
      }
      if (!look(c, relation, (sg_row)(i * SG_PAGE_ROWS) + r, to)) {
        return false;
      }
      if (c->broken) {
        return true;
      }
    }
  }
  return true;
}

/* The mask that a walk by a column's ids is asked with; 0: by members. */
enum { NO_MASK = 0xffff };

static uint16_t
mask_of(sg_table *table, unsigned column)
{
  unsigned in = sg_relation_segment_column(table->relation, column);
  uint16_t mask = (uint16_t)(1U << in | 1U << column);

  if (table->info->column[column].type != SG_LIST &&
      sg_table_index(table, mask, false)) {
    return mask;
  }
  for (unsigned i = 0; i < table->indexes; i++) {
    if (table->index[i].members && (table->index[i].mask >> column & 1)) {
      return 0;
    }
  }
  return NO_MASK;
}

/* The index that serves such a walk. */
static sg_index *
index_of(sg_table *table, uint16_t mask)
{
  sg_index *index = NULL;

  if (mask != 0) {
    return sg_table_index(table, mask, false);
  }
  for (unsigned i = 0; i < table->indexes; i++) {
    index = table->index[i].members ? &table->index[i] : index;
  }
  return index;
}

/* Whether look-ups are quicker than a look at all rows. */
static bool
by_index(check *c, sg_relation relation, sg_relation to)
{
  const sg_suspects *x = &c->of[to];
  sg_table *table = &c->world->table[relation];
  bool whole = true;

  if (x->all || x->ofs > 0 ||
      x->n * ROWS_A_LOOK > c->version->map[relation]->rows + ROWS_A_LOOK) {
    return false;
  }
  pthread_mutex_lock(&c->world->lock);
  for (unsigned k = 0; k < table->info->arity && whole; k++) {
    if (column_refers(table->info, k, to)) {
      uint16_t mask = mask_of(table, k);
      sg_index *index = mask == NO_MASK ? NULL : index_of(table, mask);
      whole = index && (sg_index_is_whole(index, table) ||
                        index->searches++ >= SG_FEW_SEARCHES);
    }
  }
  pthread_mutex_unlock(&c->world->lock);
  return whole;
}

static bool
look_up(check *c, sg_relation relation, sg_relation to, unsigned column,
        sg_id_pair gone)
{
  sg_table *table = &c->world->table[relation];
  const sg_relation_info *info = table->info;
  bool negative = info->with_sign[column] && info->negative[column] == to;
  unsigned in = sg_relation_segment_column(relation, column);
  uint16_t mask = mask_of(table, column);
  sg_value key[SG_MAX_COLUMNS] = {0};
  bool good = true;
  sg_walk walk;

  key[in].i = gone.s;
  key[column].i = negative ? -gone.id : gone.id;
  if (!(mask ? sg_walk_open(&walk, c->version, relation, mask, key)
             : sg_walk_open_member(&walk, c->version, relation, gone.s,
                                   gone.id))) {
    return false;
  }
  good = true;
  for (sg_row row;
       good && !c->broken && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    good = look(c, relation, row, to);
  }
  sg_walk_close(&walk);
  return good;
}

static bool
search(check *c, sg_relation relation, sg_relation to)
{
  const sg_relation_info *info = &sg_relation_table[relation];
  const sg_suspects *x = &c->of[to];
  bool good = true;

  if (!by_index(c, relation, to)) {
    return scan(c, relation, to);
  }
  for (size_t i = 0; i < x->n && good && !c->broken; i++) {
    for (unsigned k = 0; k < info->arity && good && !c->broken; k++) {
      good = !column_refers(info, k, to) ||
             look_up(c, relation, to, k, x->gone[i]);
    }
  }
  return good;
}

/* ---- the whole ----------------------------------------------------------- */

/* This pass looks at rows of the relation. */
static bool
concerns(const check *c, sg_relation relation)
{
  const sg_map *map = c->version->map[relation];
  bool goes = c->cascade || sg_relation_table[relation].derived;

  return map && map->rows > 0 && goes == c->drops;
}

/* Rows that were added before what they refer to. */
static bool
look_at_rows(check *c, sg_relation relation)
{
  const sg_suspects *x = &c->of[relation];
  bool good = true;

  if (!concerns(c, relation)) {
    return true;
  }
  if (x->all_rows) {
    return scan(c, relation, SG_NONE);
  }
  for (size_t i = 0; i < x->rows && good && !c->broken; i++) {
    good = !sg_version_live(c->version, relation, x->row[i]) ||
           look(c, relation, x->row[i], SG_NONE);
  }
  return good;
}

static bool
pass(check *c)
{
  bool good = true;

  for (int r = 0; r < SG_RELATIONS && good && !c->broken; r++) {
    sg_suspects *x = &c->of[r];
    good = look_at_rows(c, (sg_relation)r);
    sg_suspects_order(x);
    for (int q = r + 1; good && !c->broken && q < SG_RELATIONS &&
                        (x->n > 0 || x->ofs > 0 || x->all);
         q++) {
      if (concerns(c, (sg_relation)q) &&
          sg_relation_refers((sg_relation)q, (sg_relation)r)) {
        good = search(c, (sg_relation)q, (sg_relation)r);
      }
    }
  }
  return good;
}

static bool
read_mark(void *data, sg_mark_kind kind, sg_relation relation, int32_t s,
          int32_t id, sg_row row)
{
  check *c = data;
  sg_suspects *x = &c->of[relation];

  if (c->made != (kind == SG_MARK_MADE || kind == SG_MARK_MADE_ALL)) {
    return true;
  }
  switch (kind) {
  case SG_MARK_GONE:
  case SG_MARK_MADE:
    return is_there(c, relation, s, id) || sg_suspect_gone(x, s, id);
  case SG_MARK_GONE_OF:
    if (!sg_list_grow(&x->of, x->ofs, &x->of_room, sizeof *x->of)) {
      return false;
    }
    x->of[x->ofs++] = s;
    return true;
  case SG_MARK_GONE_ALL:
  case SG_MARK_MADE_ALL:
    x->all = true;
    return true;
  case SG_MARK_ROW:
    if (!sg_list_grow(&x->row, x->rows, &x->row_room, sizeof *x->row)) {
      return false;
    }
    x->row[x->rows++] = row;
    return true;
  case SG_MARK_ROWS:
    x->all_rows = true;
    return true;
  }
  return false;
}

static void
clear_suspects(check *c)
{
  for (int r = 0; r < SG_RELATIONS; r++) {
    sg_suspects_clear(&c->of[r]);
  }
}

/* Looks for a breach, and if there is none for rows to drop: because of what
 * users did, then of what kernels did, who know what they do. */
static bool
passes(check *c, const sg_mark *marks)
{
  bool good = sg_marks_each(marks, read_mark, c) && (c->cascade || pass(c));

  c->drops = true;
  if (!good || c->broken || !pass(c)) {
    return c->broken;
  }
  clear_suspects(c);
  c->cascade = c->made = true;
  return sg_marks_each(marks, read_mark, c) && pass(c);
}

static bool
drop_rows(check *c)
{
  bool good = true;

  for (size_t i = 0; i < c->n && good; i++) {
    good = sg_world_hide(c->world, c->drop[i].relation, c->drop[i].row) ||
           !sg_version_live(c->world->current, c->drop[i].relation,
                            c->drop[i].row);
  }
  return good;
}

static void
clear(check *c)
{
  clear_suspects(c);
  free(c->drop);
}

/* The current version is whole, and is known to be. */
static void
forget_marks(sg_world *world)
{
  pthread_mutex_lock(&world->lock);
  sg_marks_drop(world->current->marks);
  world->current->marks = NULL;
  pthread_mutex_unlock(&world->lock);
}

bool
sg_world_is_whole(sg_world *world)
{
  bool whole;

  pthread_mutex_lock(&world->lock);
  whole = !sg_world_visible(world)->marks;
  pthread_mutex_unlock(&world->lock);
  return whole;
}

sg_status
sg_world_make_whole(sg_world *world, bool cascade, sg_breach *breach)
{
  check c = {.world = world, .cascade = cascade, .breach = breach};
  bool good;

  if (sg_world_is_whole(world)) {
    return SG_OK;
  }
  c.version = sg_world_version(world);
  good = passes(&c, c.version->marks);
  sg_version_drop(c.version);
  good = good && (c.broken || drop_rows(&c));
  clear(&c);
  if (good && !c.broken) {
    forget_marks(world);
  }
  return !good ? SG_NO_MEMORY : c.broken ? SG_DANGLING : SG_OK;
}

/* The segment and id of a row, which lives. */
static bool
row_pair(const sg_world *world, sg_relation relation, sg_row row,
         sg_id_pair *out)
{
  return sg_page_pair(sg_table_page(&world->table[relation], row), relation,
                      row % SG_PAGE_ROWS, &out->s, &out->id);
}

/* Retracts a row of which nobody may be left that refers to it. */
static sg_status
retract_now(sg_world *world, sg_relation relation, sg_row row, bool cascade,
            sg_breach *breach)
{
  check c = {.world = world, .cascade = cascade, .breach = breach};
  sg_id_pair gone;
  bool good = true;

  c.version = sg_world_version(world);
  if (!sg_version_live(c.version, relation, row)) {
    sg_version_drop(c.version);
    return SG_NO_STEP;
  }
  if (row_pair(world, relation, row, &gone)) {
    good =
        sg_suspect_gone(&c.of[relation], gone.s, gone.id) && passes(&c, NULL);
  }
  sg_version_drop(c.version);
  good = good &&
         (c.broken || (sg_world_hide(world, relation, row) && drop_rows(&c)));
  clear(&c);
  return !good ? SG_NO_MEMORY : c.broken ? SG_DANGLING : SG_OK;
}

sg_status
sg_world_retract_edit(sg_world *world, sg_relation relation, sg_row row,
                      bool cascade, sg_breach *breach)
{
  sg_status status = SG_NO_STEP;
  sg_id_pair gone;

  if (cascade || sg_world_depth(world) == 0) {
    return retract_now(world, relation, row, cascade, breach);
  }
  sg_world_enter(world);
  if (sg_version_live(world->current, relation, row)) {
    status = !row_pair(world, relation, row, &gone) ||
                     sg_world_mark_gone(world, relation, SG_MARK_GONE, false,
                                        gone.s, gone.id)
                 ? SG_OK
                 : SG_NO_MEMORY;
  }
  sg_world_leave(world);
  return status != SG_OK                       ? status
         : sg_world_hide(world, relation, row) ? SG_OK
                                               : SG_NO_MEMORY;
}

static bool
mark_many(sg_world *world, sg_relation relation, sg_mark_kind kind, int32_t s)
{
  bool good;

  sg_world_enter(world);
  good = sg_world_mark_gone(world, relation, kind, false, s, 0);
  sg_world_leave(world);
  return good;
}

bool
sg_world_retract_all_edit(sg_world *world, sg_relation relation)
{
  return mark_many(world, relation, SG_MARK_GONE_ALL, 0) &&
         sg_world_retract_all_again(world, relation);
}

bool
sg_world_retract_of_edit(sg_world *world, sg_relation relation, int32_t s)
{
  return !sg_world_has_of(world, relation, s) ||
         (mark_many(world, relation, SG_MARK_GONE_OF, s) &&
          sg_world_retract_with(world, relation, 0, s));
}
