/* schema4pl.c -- relations.def as Prolog sees it, ids, rows, statistics.
 *
 * Layer: glue. Doors in rules/store.pl.
 */
#include "edit4pl.h"

#include "install.h"

#include <string.h>

/* ---- relations --------------------------------------------------------- */

static atom_t
relation_atom(sg_relation relation)
{
  static atom_t atom[SG_RELATIONS];

  if (!atom[relation]) {
    atom[relation] = PL_new_atom(sg_relation_table[relation].name);
  }
  return atom[relation];
}

sg_relation
sg_relation_named(atom_t name, size_t arity)
{
  for (int r = 0; r < SG_RELATIONS; r++) {
    if (relation_atom((sg_relation)r) == name &&
        sg_relation_table[r].arity == arity) {
      return (sg_relation)r;
    }
  }
  return SG_NONE;
}

int
sg_get_relation_ex(term_t t, sg_relation *out)
{
  term_t arg = PL_new_term_ref();
  atom_t name;
  size_t arity = 0;

  if (PL_is_functor(t, PL_new_functor(PL_new_atom("/"), 2))) {
    _PL_get_arg(1, t, arg);
    if (!PL_get_atom_ex(arg, &name)) {
      return FALSE;
    }
    _PL_get_arg(2, t, arg);
    if (!PL_get_size_ex(arg, &arity)) {
      return FALSE;
    }
  } else if (!PL_get_atom_ex(t, &name)) {
    return FALSE;
  }
  for (int r = 0; r < SG_RELATIONS; r++) {
    if (relation_atom((sg_relation)r) == name &&
        (arity == 0 || sg_relation_table[r].arity == arity)) {
      *out = (sg_relation)r;
      return TRUE;
    }
  }
  return PL_existence_error("relation", t);
}

/* '$relation_count'(-Count) is det. */
static foreign_t
relation_count(term_t count)
{
  return PL_unify_integer(count, SG_RELATIONS);
}

/* '$relation_number'(+Name, -Number) is semidet. */
static foreign_t
relation_number(term_t name, term_t number)
{
  atom_t atom;

  if (!PL_get_atom(name, &atom)) {
    return FALSE;
  }
  for (int r = 0; r < SG_RELATIONS; r++) {
    if (relation_atom((sg_relation)r) == atom) {
      return PL_unify_integer(number, r);
    }
  }
  return FALSE;
}

/* '$relation'(+Number, -Name, -Arity, -KeyMask, -Doc) is semidet. */
static foreign_t
relation(term_t number, term_t name, term_t arity, term_t key, term_t doc)
{
  int r;

  if (!PL_get_integer(number, &r) || r < 0 || r >= SG_RELATIONS) {
    return FALSE;
  }
  return PL_unify_atom(name, relation_atom((sg_relation)r)) &&
         PL_unify_integer(arity, sg_relation_table[r].arity) &&
         PL_unify_integer(key, sg_relation_table[r].key) &&
         PL_unify_chars(doc, PL_STRING | REP_UTF8, (size_t)-1,
                        sg_relation_table[r].doc);
}

static const char *
type_name(sg_type type)
{
  switch (type) {
  case SG_INT:
    return "int";
  case SG_FLOAT:
    return "float";
  case SG_LIST:
    return "list";
  case SG_ATOM:
    return "atom";
  case SG_TERM:
    return "term";
  }
  return "";
}

static int
unify_text(term_t t, const char *text)
{
  return PL_unify_chars(t, PL_STRING | REP_UTF8, (size_t)-1, text ? text : "");
}

/* '$column'(+Relation, +Position, -Name, -Type, -Refers, -Domain, -Doc). */
static foreign_t
column(term_t args, int count, void *control)
{
  int r;
  int c;
  const sg_relation_info *info;
  const sg_column_info *col;

  (void)count;
  (void)control;
  if (!PL_get_integer(args, &r) || !PL_get_integer(args + 1, &c) || r < 0 ||
      r >= SG_RELATIONS) {
    return FALSE;
  }
  info = &sg_relation_table[r];
  if (c < 0 || c >= (int)info->arity) {
    return FALSE;
  }
  col = &info->column[c];
  return PL_unify_atom_chars(args + 2, col->name) &&
         PL_unify_atom_chars(args + 3, type_name(col->type)) &&
         PL_unify_atom_chars(args + 4,
                             col->refers == SG_NONE
                                 ? "none"
                                 : sg_relation_table[col->refers].name) &&
         unify_text(args + 5, info->domain[c]) &&
         unify_text(args + 6, col->doc);
}

/* ---- ids --------------------------------------------------------------- */

/* fresh_id(+Relation, +S, -Id) is det. */
static foreign_t
fresh_id(term_t name, term_t segment, term_t id)
{
  sg_world *world = sg_edited_world_ex();
  sg_relation relation;
  int32_t fresh;
  int s;

  if (!world || !sg_get_relation_ex(name, &relation) ||
      !PL_get_integer_ex(segment, &s)) {
    return FALSE;
  }
  if (sg_relation_id_column(relation) == SG_MAX_COLUMNS) {
    return PL_domain_error("relation_with_ids", name);
  }
  if (!sg_claim_ex(world)) {
    return FALSE;
  }
  fresh = sg_fresh_ex(world, relation,
                      sg_relation_id_column(relation) == 0 ? 0 : s);
  sg_world_release(world);
  return fresh > 0 && PL_unify_integer(id, fresh);
}

/* ---- statistics -------------------------------------------------------- */

/* '$statistics'(+Relation, -Rows, -Slots, -Bytes, -IndexBytes, -VersionBytes,
 * -Versions, -Scans, -Lookups) is det. */
static foreign_t
statistics(term_t args, int count, void *control)
{
  sg_world *world = sg_edited_world_ex();
  sg_relation relation;
  sg_statistics s;

  (void)count;
  (void)control;
  if (!world || !sg_get_relation_ex(args, &relation)) {
    return FALSE;
  }
  sg_world_statistics(world, relation, &s);
  return PL_unify_uint64(args + 1, s.rows) &&
         PL_unify_uint64(args + 2, s.slots) &&
         PL_unify_uint64(args + 3, s.bytes) &&
         PL_unify_uint64(args + 4, s.index_bytes) &&
         PL_unify_uint64(args + 5, s.version_bytes) &&
         PL_unify_uint64(args + 6, s.versions) &&
         PL_unify_uint64(args + 7, s.scans) &&
         PL_unify_uint64(args + 8, s.lookups);
}

/* ---- installing -------------------------------------------------------- */

static const PL_extension predicates[] = {
    {"$relation_count", 1, relation_count, 0},
    {"$relation_number", 2, relation_number, 0},
    {"$relation", 5, relation, 0},
    {"$column", 7, column, PL_FA_VARARGS},
    {"fresh_id", 3, fresh_id, 0},
    {"$statistics", 9, statistics, PL_FA_VARARGS},
    {NULL, 0, NULL, 0},
};

void
sg_install_schema(void)
{
  PL_register_extensions_in_module("sg_store", predicates);
}
