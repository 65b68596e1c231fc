/* csg_rows.c -- leaves of the CSG tree that need no looking at; what is said of
 * nodes.
 */
#include "doors/boolean.h"
#include "rows/append_rows.h"
#include "rows/live_rows.h"

#include "engine/symbol.h"
#include "engine/term.h"

#include <string.h>

enum { HEADERS = 6 };

/* What a record of rules/csg/csg_record.pl begins with:
 * leaf(made(primitive(...), ...)). */
typedef struct record_form {
  uint32_t header[HEADERS];
} record_form;

/* Of a segment: its kind, its term, and origin(S, node(S), Record); null: there
 * is none. */
typedef struct leaf_row {
  int32_t kind;
  const uint32_t *term, *record;
} leaf_row;

/* What tells leaves from others, found once a call. */
typedef struct looking {
  const sg_version *version;
  record_form form;
  int32_t other;  /* the symbol */
  leaf_row *leaf; /* [leaves], by segment; null: they are looked up */
  size_t leaves;
} looking;

static void
make_form(record_form *form)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_compound(&b, SG_SYMBOL_LEAF, 1);
  sg_term_compound(&b, SG_SYMBOL_MADE, 2);
  sg_term_compound(&b, SG_SYMBOL_PRIMITIVE, 1);
  memcpy(form->header, sg_term_words(&b) + 1, sizeof form->header);
  sg_term_close(&b);
}

static bool
look(sg_call *call, looking *out)
{
  *out = (looking){.version = sg_call_version(call),
                   .other = sg_symbol_intern("other", 5)};
  make_form(&out->form);
  return out->version && (out->other >= 0 || sg_call_no_memory(call));
}

/* The record says that rows with this stamp were made from `term`. */
static bool
says(const record_form *form, const uint32_t *record, const uint32_t *term,
     uint64_t stamp)
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
      memcmp(at, form->header, sizeof form->header) == 0 &&
      memcmp(at + HEADERS, term + 1, words * sizeof *term) == 0 &&
      memcmp(at + HEADERS + words, number + 1, digits * sizeof *number) == 0;

  sg_term_close(&b);
  return same;
}

static leaf_row
look_up(const sg_version *version, int32_t s)
{
  leaf_row leaf = {0};
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_unary(&b, SG_SYMBOL_NODE, s);
  sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.term = sg_term_words(&b)}};
  sg_row of = sg_version_find(version, SG_SEGMENT, key);
  sg_row by = of == SG_NO_ROW ? of : sg_version_find(version, SG_ORIGIN, key);

  sg_term_close(&b);
  if (by != SG_NO_ROW) {
    leaf.kind = sg_version_value(version, SG_SEGMENT, of, 1).i;
    leaf.term = sg_version_value(version, SG_SEGMENT, of, 2).term;
    leaf.record = sg_version_value(version, SG_ORIGIN, by, 2).term;
  }
  return leaf;
}

/* The symbol of its kind, or of `other`; stamp: that of its rows. */
static int32_t
kind_of(const looking *k, int32_t s, uint64_t stamp)
{
  leaf_row leaf = !k->leaf                ? look_up(k->version, s)
                  : (size_t)s < k->leaves ? k->leaf[s]
                                          : (leaf_row){0};

  return leaf.term && leaf.record &&
                 says(&k->form, leaf.record, leaf.term, stamp)
             ? leaf.kind
             : k->other;
}

/* ---- of many segments ---------------------------------------------------- */

static leaf_row *
leaf_at(const looking *k, int32_t s)
{
  return s > 0 && (size_t)s < k->leaves ? &k->leaf[s] : NULL;
}

static const uint32_t *
row_term(const sg_live_row *row, unsigned column)
{
  return (const uint32_t *)sg_row_list(row, column);
}

static void
see_segment(void *reader, const sg_live_row *row)
{
  leaf_row *leaf = leaf_at(reader, sg_row_int(row, 0));

  if (leaf) {
    leaf->kind = sg_row_int(row, 1);
    leaf->term = row_term(row, 2);
  }
}

static void
see_origin(void *reader, const sg_live_row *row)
{
  int32_t s = sg_row_int(row, 0);
  leaf_row *leaf = leaf_at(reader, s);
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_unary(&b, SG_SYMBOL_NODE, s);
  if (leaf && sg_term_equal(row_term(row, 1), sg_term_words(&b))) {
    leaf->record = row_term(row, 2);
  }
  sg_term_close(&b);
}

/* Of a good part of all segments, n of them, the last of which is `last`: two
 * walks are faster than to look each up. */
static bool
look_at_all(sg_call *call, looking *k, size_t n, int64_t last)
{
  size_t leaves = (size_t)last + 1;

  if (n < 64 || n < sg_version_count(k->version, SG_SEGMENT) / 8 ||
      leaves > 8 * n) {
    return true;
  }
  if (!(k->leaf = sg_call_alloc(call, leaves * sizeof *k->leaf))) {
    return false;
  }
  memset(k->leaf, 0, leaves * sizeof *k->leaf);
  k->leaves = leaves;
  return sg_each_row(call, SG_SEGMENT, see_segment, k) &&
         sg_each_row(call, SG_ORIGIN, see_origin, k);
}

bool
sg_door_newer_segments(sg_call *call, const sg_int_list *ss, int64_t stamp,
                       sg_int_list *newer)
{
  const sg_version *version = sg_call_version(call);
  bool good = version != NULL;

  for (size_t i = 0; good && i < ss->n; i++) {
    good = (int64_t)sg_segment_stamp(version, ss->at[i]) <= stamp ||
           sg_int_list_add(call, newer, ss->at[i]);
  }
  return good;
}

bool
sg_door_changed_leaves(sg_call *call, const sg_int_list *ss, int64_t since,
                       sg_int_list *changed)
{
  looking k;
  int64_t last = 0;

  for (size_t i = 0; i < ss->n; i++) {
    last = ss->at[i] > last ? ss->at[i] : last;
  }
  bool good = look(call, &k) && look_at_all(call, &k, ss->n, last);

  for (size_t i = 0; good && i < ss->n; i++) {
    uint64_t stamp = sg_segment_stamp(k.version, ss->at[i]);

    good =
        ((int64_t)stamp <= since && kind_of(&k, ss->at[i], stamp) != k.other) ||
        sg_int_list_add(call, changed, ss->at[i]);
  }
  return good;
}

bool
sg_door_kept_leaves(sg_call *call, const sg_integer_list *ss,
                    sg_int_list *kinds)
{
  looking k;
  int64_t last = 0;

  for (size_t i = 0; i < ss->n; i++) {
    last = ss->at[i] > last ? ss->at[i] : last;
  }
  bool good = look(call, &k) && look_at_all(call, &k, ss->n, last);

  for (size_t i = 0; good && i < ss->n; i++) {
    int64_t s = ss->at[i];

    good =
        !sg_cancel_every(&call->cancel, i) &&
        sg_int_list_add(call, kinds,
                        s > 0 && s <= INT32_MAX
                            ? kind_of(&k, (int32_t)s,
                                      sg_segment_stamp(k.version, (int32_t)s))
                            : k.other);
  }
  return good;
}

bool
sg_door_other_segments(sg_call *call, sg_int_list *ss)
{
  looking k;
  sg_walk walk = {0};
  bool good =
      look(call, &k) && (sg_walk_open(&walk, k.version, SG_SEGMENT, 0, NULL) ||
                         sg_call_no_memory(call));

  for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    int32_t s = sg_version_value(k.version, SG_SEGMENT, row, 0).i;

    good = kind_of(&k, s, sg_segment_stamp(k.version, s)) != k.other ||
           sg_int_list_add(call, ss, s);
  }
  sg_walk_close(&walk);
  return good;
}

/* The item is node(_). */
static bool
is_of_node(const uint32_t *item)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_unary(&b, SG_SYMBOL_NODE, 1);
  bool is = sg_term_length(item) > 2 &&
            memcmp(item + 1, sg_term_words(&b) + 1, 2 * sizeof *item) == 0;

  sg_term_close(&b);
  return is;
}

/* A copy for as long as the call lasts. */
static const uint32_t *
copied(sg_call *call, const uint32_t *term)
{
  size_t bytes = sg_term_length(term) * sizeof *term;
  uint32_t *copy = sg_call_alloc(call, bytes);

  return copy ? memcpy(copy, term, bytes) : NULL;
}

static bool
add_origin(sg_call *call, const sg_version *version, sg_row row,
           sg_node_origin_list *out)
{
  const uint32_t *item = sg_version_value(version, SG_ORIGIN, row, 1).term;

  if (!is_of_node(item)) {
    return true;
  }
  sg_node_origin origin = {
      copied(call, item),
      copied(call, sg_version_value(version, SG_ORIGIN, row, 2).term)};

  return origin.item && origin.origin &&
         sg_node_origin_list_add(call, out, origin);
}

bool
sg_door_node_origins(sg_call *call, int32_t s, sg_node_origin_list *origins)
{
  const sg_version *version = sg_call_version(call);
  sg_segment_rows rows = {0};
  bool good = version && sg_rows_of_segment(call, version, SG_ORIGIN, s, &rows);
  size_t n = good ? rows.begin[1] : 0;

  for (size_t i = 0; good && i < n; i++) {
    good = add_origin(call, version, rows.row[i], origins);
  }
  sg_segment_rows_clear(&rows);
  return good;
}
