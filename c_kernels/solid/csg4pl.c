/* csg4pl.c -- leaves of the CSG tree that need no looking at; what is said of
 * nodes.
 *
 * Layer: glue. The doors are documented in rules/kernel/boolean.pl.
 */
#include "rows/append4pl.h"

#include "glue.h"

#include "engine/install.h"

#include <string.h>

enum { HEADERS = 6 };

/* What a record of rules/csg/csg_record.pl begins with:
 * leaf(made(primitive(...), ...)). */
typedef struct record_form {
  uint32_t header[HEADERS];
} record_form;

static record_form form;
static uint32_t node_form[2]; /* node(_) begins with this */
static functor_t functor_minus2;
static atom_t atom_other;

static void
make_form(void)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_compound(&b, SG_SYMBOL_LEAF, 1);
  sg_term_compound(&b, SG_SYMBOL_MADE, 2);
  sg_term_compound(&b, SG_SYMBOL_PRIMITIVE, 1);
  memcpy(form.header, sg_term_words(&b) + 1, sizeof form.header);
  sg_term_close(&b);
  sg_term_open(&b);
  sg_term_unary(&b, SG_SYMBOL_NODE, 1);
  memcpy(node_form, sg_term_words(&b) + 1, sizeof node_form);
  sg_term_close(&b);
}

/* The record says that rows with this stamp were made from `term`. */
static bool
says(const uint32_t *record, const uint32_t *term, uint64_t stamp)
{
  size_t words = sg_term_length(term) - 1; /* without the count */
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_int(&b, (int64_t)stamp);
  const uint32_t *number = sg_term_words(&b); /* short: it cannot fail */
  size_t digits = sg_term_length(number) - 1;
  const uint32_t *at = record + 1;
  bool same =
      sg_term_length(record) - 1 == HEADERS + words + digits &&
      memcmp(at, form.header, sizeof form.header) == 0 &&
      memcmp(at + HEADERS, term + 1, words * sizeof *term) == 0 &&
      memcmp(at + HEADERS + words, number + 1, digits * sizeof *number) == 0;

  sg_term_close(&b);
  return same;
}

/* origin(S, node(S), Record): null, there is none. */
static const uint32_t *
record_of(const sg_version *version, int32_t s)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_unary(&b, SG_SYMBOL_NODE, s);
  sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.term = sg_term_words(&b)}};
  sg_row row = sg_version_find(version, SG_ORIGIN, key);

  sg_term_close(&b);
  return row == SG_NO_ROW ? NULL
                          : sg_version_value(version, SG_ORIGIN, row, 2).term;
}

static atom_t
kind_of(const sg_version *version, int32_t s)
{
  sg_row row = sg_version_find(version, SG_SEGMENT,
                               (sg_value[SG_MAX_COLUMNS]){{.i = s}});
  const uint32_t *record = row == SG_NO_ROW ? NULL : record_of(version, s);

  return record && says(record,
                        sg_version_value(version, SG_SEGMENT, row, 2).term,
                        sg_segment_stamp(version, s))
             ? sg_symbol_atom(sg_version_value(version, SG_SEGMENT, row, 1).i)
             : atom_other;
}

static int
unify_kinds_ex(const sg_version *version, term_t list, term_t kinds)
{
  term_t rest = PL_copy_term_ref(list), tail = PL_copy_term_ref(kinds),
         s = PL_new_term_ref(), head = PL_new_term_ref();
  int n;

  while (PL_get_list_ex(rest, s, rest)) {
    atom_t kind = PL_get_integer(s, &n) ? kind_of(version, n) : atom_other;

    if (!PL_unify_list(tail, head, tail) || !PL_unify_atom(head, kind)) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(rest) && PL_unify_nil(tail);
}

/* kept_leaves(+Ss, -Kinds) is det. */
static foreign_t
kept_leaves(term_t list, term_t kinds)
{
  sg_world *world = sg_current_world_ex();

  if (!world) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  int good = unify_kinds_ex(version, list, kinds);

  sg_version_drop(version);
  return good;
}

/* other_segments(-Ss) is det. */
static foreign_t
other_segments(term_t list)
{
  sg_world *world = sg_current_world_ex();
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  sg_walk walk;

  if (!world) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  int good =
      sg_walk_open(&walk, version, SG_SEGMENT, 0, NULL) || sg_no_memory();

  for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    int32_t s = sg_version_value(version, SG_SEGMENT, row, 0).i;

    good = kind_of(version, s) != atom_other ||
           (PL_unify_list(tail, head, tail) && PL_unify_integer(head, s));
  }
  sg_walk_close(&walk);
  sg_version_drop(version);
  return good && PL_unify_nil(tail);
}

/* The item is node(_). */
static bool
is_of_node(const uint32_t *item)
{
  return sg_term_length(item) > 2 &&
         memcmp(item + 1, node_form, sizeof node_form) == 0;
}

static int
unify_origin(term_t list, const sg_version *version, sg_row row)
{
  term_t head = PL_new_term_ref(), item = PL_new_term_ref();
  term_t origin = PL_new_term_ref();

  return PL_unify_list(list, head, list) &&
         sg_put_term(item, sg_version_value(version, SG_ORIGIN, row, 1).term) &&
         sg_put_term(origin,
                     sg_version_value(version, SG_ORIGIN, row, 2).term) &&
         PL_unify_term(head, PL_FUNCTOR, functor_minus2, PL_TERM, item, PL_TERM,
                       origin);
}

/* node_origins(+S, -Origins) is det. */
static foreign_t
node_origins(term_t s_term, term_t list)
{
  sg_world *world = sg_current_world_ex();
  term_t tail = PL_copy_term_ref(list);
  sg_segment_rows rows;
  int32_t s;

  if (!world || !sg_get_id_ex(s_term, &s)) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  int good = sg_rows_of_segment_ex(version, SG_ORIGIN, s, &rows);
  size_t n = good ? rows.begin[1] : 0;

  for (size_t i = 0; good && i < n; i++) {
    sg_row row = rows.row[i];

    good = !is_of_node(sg_version_value(version, SG_ORIGIN, row, 1).term) ||
           unify_origin(tail, version, row);
  }
  sg_segment_rows_clear(&rows);
  sg_version_drop(version);
  return good && PL_unify_nil(tail);
}

static const PL_extension predicates[] = {
    {"node_origins", 2, node_origins, 0},
    {"kept_leaves", 2, kept_leaves, 0},
    {"other_segments", 1, other_segments, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_csg(void)
{
  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  atom_other = PL_new_atom("other");
  make_form();
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
