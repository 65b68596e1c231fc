/* leaf4pl.c -- polygons as they are before a cut, kept.
 *
 * Layer: glue. The fused kernel of leaf.pl, leaves_kept_by_rule/1: the same
 * rows in the same order; a test holds the two together. The door is documented
 * in rules/kernel/world.pl.
 */
#include "engine/world4pl.h"

#include "glue.h"
#include "rows/key_table.h"

#include "engine/install.h"

#include <stdlib.h>

enum { ASKED = 512, COLUMNS = 6 }; /* polygons between questions */

/* Rows of leaf_e/5, leaf_p/3 or leaf_t/6, as columns. */
typedef struct leaf_rows {
  size_t n, room;
  int32_t *i[COLUMNS];
  const int32_t **list; /* of leaf_p/3: the version's */
} leaf_rows;

typedef struct keeping {
  const sg_version *version;
  sg_key_table seen; /* segment, edge: in `e`, or kept before */
  leaf_rows e, p, t;
} keeping;

static void
rows_clear(leaf_rows *rows)
{
  for (int c = 0; c < COLUMNS; c++) {
    free(rows->i[c]);
  }
  free(rows->list);
}

static bool
make_room(leaf_rows *rows)
{
  size_t room = rows->room ? 2 * rows->room : 256;
  const int32_t **list;

  if (rows->n < rows->room) {
    return true;
  }
  for (int c = 0; c < COLUMNS; c++) {
    int32_t *more = realloc(rows->i[c], room * sizeof *more);
    if (!more) {
      return false;
    }
    rows->i[c] = more;
  }
  if (!(list = realloc(rows->list, room * sizeof(int32_t *)))) {
    return false;
  }
  rows->list = list;
  rows->room = room;
  return true;
}

/* A row of a relation once more, lists by reference. */
static bool
copy_row(const keeping *k, sg_relation from, sg_row row, leaf_rows *to)
{
  const sg_relation_info *info = &sg_relation_table[from];

  if (!make_room(to)) {
    return false;
  }
  for (unsigned c = 0; c < info->arity; c++) {
    sg_value value = sg_version_value(k->version, from, row, c);
    if (info->column[c].type == SG_LIST) {
      to->list[to->n] = value.list;
    } else {
      to->i[c][to->n] = value.i;
    }
  }
  to->n++;
  return true;
}

static sg_row
find(const keeping *k, sg_relation relation, int32_t s, int32_t id)
{
  return sg_version_find(k->version, relation,
                         (sg_value[SG_MAX_COLUMNS]){{.i = s}, {.i = id}});
}

/* FALSE without an exception: there is no such edge. */
static int
keep_edge_ex(keeping *k, int32_t s, int32_t e)
{
  uint32_t *seen =
      sg_key_table_put(&k->seen, (uint32_t[2]){(uint32_t)s, (uint32_t)e});
  sg_row row;

  if (!seen || *seen == 1) {
    return seen || sg_no_memory();
  }
  *seen = 1;
  if (find(k, SG_LEAF_E, s, e) != SG_NO_ROW) {
    return TRUE;
  }
  row = find(k, SG_E, s, e);
  return row != SG_NO_ROW && (copy_row(k, SG_E, row, &k->e) || sg_no_memory());
}

static bool
keep_triangles(keeping *k, int32_t s, int32_t p)
{
  const sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.i = p}};
  sg_walk walk;
  bool good = sg_walk_open(&walk, k->version, SG_T, 0x03, key);

  if (!good) {
    return false;
  }
  for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    good = copy_row(k, SG_T, row, &k->t);
  }
  sg_walk_close(&walk);
  return good;
}

/* FALSE without an exception: there is no such polygon, or an edge of it is
 * not there. */
static int
keep_polygon_ex(keeping *k, int32_t s, int32_t p)
{
  sg_row row;
  int good = TRUE;

  if (find(k, SG_LEAF_P, s, p) != SG_NO_ROW) {
    return TRUE;
  }
  if ((row = find(k, SG_P, s, p)) == SG_NO_ROW) {
    return FALSE;
  }
  const int32_t *list = sg_version_value(k->version, SG_P, row, 2).list;

  for (int32_t i = 1; i <= list[0] && good; i++) {
    good = keep_edge_ex(k, s, list[i]);
  }
  return good && ((copy_row(k, SG_P, row, &k->p) && keep_triangles(k, s, p)) ||
                  sg_no_memory());
}

static int
keep_all_ex(keeping *k, term_t polygons)
{
  term_t tail = PL_copy_term_ref(polygons), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();
  sg_key_table known; /* polygons of this list */
  int good = TRUE;

  sg_key_table_init(&known, 2);
  for (size_t n = 1; good && PL_get_list_ex(tail, head, tail); n++) {
    int32_t id[2] = {0};
    for (int i = 0; i < 2 && good; i++) {
      good = PL_get_arg(i + 1, head, arg) ? sg_get_id_ex(arg, &id[i])
                                          : PL_type_error("polygon", head);
    }
    uint32_t *there =
        good ? sg_key_table_put(&known,
                                (uint32_t[2]){(uint32_t)id[0], (uint32_t)id[1]})
             : NULL;
    good = good && (there || sg_no_memory());
    if (good && *there == SG_NO_KEY) {
      *there = 1;
      good = keep_polygon_ex(k, id[0], id[1]);
    }
    good = good && (n % ASKED != 0 || PL_handle_signals() >= 0);
  }
  sg_key_table_clear(&known);
  return good && !PL_exception(0) && PL_get_nil_ex(tail);
}

static int
add_rows_ex(sg_world *world, sg_relation relation, const leaf_rows *rows)
{
  const void *column[COLUMNS] = {0};
  sg_fault fault = {0};

  for (unsigned c = 0; c < sg_relation_table[relation].arity; c++) {
    bool list = sg_relation_table[relation].column[c].type == SG_LIST;
    column[c] = list ? (const void *)rows->list : (const void *)rows->i[c];
  }
  return sg_raise_status(
      sg_world_add_many(world, relation, rows->n, column, &fault), relation,
      &fault);
}

/* leaves_keep(+Polygons) is semidet. */
static foreign_t
leaves_keep(term_t polygons)
{
  sg_world *world = sg_current_world_ex();

  if (!world || !sg_claim_ex(world)) {
    return FALSE;
  }
  keeping k = {.version = sg_world_version(world)};

  sg_key_table_init(&k.seen, 2);
  int good = keep_all_ex(&k, polygons) && add_rows_ex(world, SG_LEAF_E, &k.e) &&
             add_rows_ex(world, SG_LEAF_P, &k.p) &&
             add_rows_ex(world, SG_LEAF_T, &k.t);

  sg_key_table_clear(&k.seen);
  rows_clear(&k.e);
  rows_clear(&k.p);
  rows_clear(&k.t);
  sg_version_drop(k.version);
  sg_world_release(world);
  return good;
}

static const PL_extension predicates[] = {
    {"leaves_keep", 1, leaves_keep, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_leaf(void)
{
  PL_register_extensions_in_module("sg_kernel_world", predicates);
}
