/* store4pl.c -- relations as predicates: every mode, logical update view, no
 * choice point on the last answer.
 *
 * Layer: glue. Doors in rules/store.pl.
 *
 * A call takes the version of its first call and keeps it to its last answer.
 * Bound arguments narrow the walk in C; what C cannot compare (a partial list
 * or term, a variable that stands twice) makes the call *strict*: each row is
 * then tried by unification before it counts as an answer.
 */
#include "world4pl.h"

#include "install.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- asking ------------------------------------------------------------ */

typedef struct asking {
  const sg_version *version;
  sg_relation relation;
  bool strict;
  bool retracts;
  sg_row next; /* the next answer */
  uint16_t open; /* columns to unify with */
  sg_walk walk;
  sg_value bound[SG_MAX_COLUMNS];
  void *owned[SG_MAX_COLUMNS]; /* lists and terms of `bound`, to free */
} asking;

static void
asking_close(asking *a)
{
  sg_walk_close(&a->walk);
  sg_version_drop(a->version);
  for (unsigned c = 0; c < SG_MAX_COLUMNS; c++) {
    free(a->owned[c]);
  }
}

typedef enum bound { OPEN, BOUND, PARTIAL, NOWHERE } bound;

static bound
bound_list(term_t t, const int32_t **out, void **owned)
{
  term_t tail = PL_copy_term_ref(t);
  term_t head = PL_new_term_ref();
  size_t length;
  int32_t *list;
  bound result = BOUND;

  if (!PL_is_ground(t)) {
    return PL_is_variable(t) ? OPEN : PARTIAL;
  }
  if (PL_skip_list(t, 0, &length) != PL_LIST || length > INT32_MAX) {
    return NOWHERE;
  }
  if (!(list = malloc((length + 1) * sizeof(*list)))) {
    return PARTIAL; /* slower, the same answers */
  }
  list[0] = (int32_t)length;
  for (size_t i = 1; i <= length; i++) {
    int id;
    if (!PL_get_list(tail, head, tail) || !PL_is_integer(head) ||
        !PL_get_integer(head, &id)) {
      result = NOWHERE;
      break;
    }
    list[i] = id;
  }
  *owned = list;
  *out = list;
  return result;
}

static bound
bound_term(term_t t, const uint32_t **out, void **owned)
{
  sg_term_builder builder;
  bound result = NOWHERE;

  if (!PL_is_ground(t)) {
    return PL_is_variable(t) ? OPEN : PARTIAL;
  }
  sg_term_open(&builder);
  if (sg_encode_term(t, &builder)) {
    const uint32_t *words = sg_term_words(&builder);
    size_t bytes = sg_term_length(words) * sizeof(*words);
    if ((*owned = malloc(bytes))) {
      memcpy(*owned, words, bytes);
      *out = *owned;
      result = BOUND;
    } else {
      result = PARTIAL;
    }
  }
  sg_term_close(&builder);
  return result;
}

static bound
bound_float(term_t t, double *out)
{
  if (PL_is_variable(t)) {
    return OPEN;
  }
  if (!PL_is_float(t) || !PL_get_float(t, out) ||
      (*out == 0 && signbit(*out))) {
    return NOWHERE; /* no stored float is -0.0 */
  }
  return BOUND;
}

static bound
bound_int(term_t t, int32_t *out)
{
  int i;

  if (PL_is_variable(t)) {
    return OPEN;
  }
  if (!PL_is_integer(t) || !PL_get_integer(t, &i)) {
    return NOWHERE;
  }
  *out = i;
  return BOUND;
}

static bound
bound_atom(term_t t, int32_t *out)
{
  atom_t atom;

  if (PL_is_variable(t)) {
    return OPEN;
  }
  if (!PL_get_atom(t, &atom) || (*out = sg_atom_symbol(atom)) < 0) {
    return NOWHERE;
  }
  return BOUND;
}

/* What argument t says about a column of this type. */
static bound
bound_value(term_t t, sg_type type, sg_value *out, void **owned)
{
  switch (type) {
  case SG_INT:
    return bound_int(t, &out->i);
  case SG_FLOAT:
    return bound_float(t, &out->f);
  case SG_ATOM:
    return bound_atom(t, &out->i);
  case SG_LIST:
    return bound_list(t, &out->list, owned);
  case SG_TERM:
    return bound_term(t, &out->term, owned);
  }
  return NOWHERE;
}

/* Reads the arguments and opens the walk. False: no row can match, or an
 * exception is pending; nothing is left to close. */
static int
asking_open(asking *a, term_t args)
{
  const sg_relation_info *info = &sg_relation_table[a->relation];
  sg_world *world = sg_current_world_ex();
  uint16_t mask = 0;
  bound b = OPEN;

  if (!world) {
    return FALSE;
  }
  memset(a->owned, 0, sizeof(a->owned));
  a->open = 0;
  a->strict = false;
  for (unsigned c = 0; c < info->arity && b != NOWHERE; c++) {
    b = bound_value(args + c, info->column[c].type, &a->bound[c],
                    &a->owned[c]);
    if (b == BOUND) {
      mask |= (uint16_t)(1U << c);
    } else {
      a->open |= (uint16_t)(1U << c);
      a->strict = a->strict || b == PARTIAL;
    }
  }
  a->version = b == NOWHERE ? NULL : sg_world_version(world);
  if (b != NOWHERE &&
      sg_walk_open(&a->walk, a->version, a->relation, mask, a->bound)) {
    return TRUE;
  }
  a->walk.rows = NULL;
  asking_close(a);
  return b == NOWHERE ? FALSE : PL_resource_error("memory");
}

/* Unifies the open arguments with a row. *shared: a variable stood twice. */
static int
unify_row(const asking *a, term_t args, sg_row row, bool *shared)
{
  const sg_relation_info *info = &sg_relation_table[a->relation];

  for (unsigned m = a->open; m; m &= m - 1) {
    unsigned c = (unsigned)__builtin_ctz(m);
    if (!PL_is_variable(args + c)) {
      *shared = true;
    }
    if (!sg_unify_value(args + c, info->column[c].type,
                        sg_version_value(a->version, a->relation, row, c))) {
      return FALSE;
    }
  }
  return TRUE;
}

/* The next row that is an answer; a strict call tries it by unification. */
static sg_row
next_answer(asking *a, term_t args)
{
  for (;;) {
    sg_row row = sg_walk_next(&a->walk);
    bool shared;
    fid_t frame;
    int fits;
    if (row == SG_NO_ROW || !a->strict) {
      return row;
    }
    if (!(frame = PL_open_foreign_frame())) {
      return SG_NO_ROW;
    }
    fits = unify_row(a, args, row, &shared);
    if (PL_exception(0)) {
      PL_close_foreign_frame(frame);
      return SG_NO_ROW;
    }
    PL_discard_foreign_frame(frame);
    if (fits) {
      return row;
    }
  }
}

static int
give(const asking *a, term_t args, sg_row row, bool *shared)
{
  return unify_row(a, args, row, shared) &&
         (!a->retracts ||
          sg_world_retract(sg_version_world(a->version), a->relation, row));
}

/* Gives the answer `a->next` or, when it is none after all, one after it.
 * False: no answer, or an exception is pending. */
static int
give_next(asking *a, term_t args)
{
  while (a->next != SG_NO_ROW) {
    sg_row row = a->next;
    bool shared = false;
    fid_t frame;
    a->next = next_answer(a, args);
    if (PL_exception(0) || !(frame = PL_open_foreign_frame())) {
      return FALSE;
    }
    if (give(a, args, row, &shared) && (a->strict || !shared)) {
      PL_close_foreign_frame(frame);
      return TRUE;
    }
    if (PL_exception(0)) {
      PL_close_foreign_frame(frame);
      return FALSE;
    }
    PL_discard_foreign_frame(frame);
    if (shared && !a->strict) { /* a variable stands twice: start again */
      a->strict = true;
      sg_walk_rewind(&a->walk);
      a->next = next_answer(a, args);
    }
  }
  return FALSE;
}

/* One answer; `a` is on the heap except at the first call. */
static foreign_t
answer(asking *a, bool first, term_t args)
{
  asking *kept = a;

  if (!give_next(a, args)) {
    asking_close(a);
    if (!first) {
      free(a);
    }
    return FALSE;
  }
  if (a->next == SG_NO_ROW) {
    asking_close(a);
    if (!first) {
      free(a);
    }
    return TRUE;
  }
  if (first) {
    if (!(kept = malloc(sizeof(*kept)))) {
      asking_close(a);
      return PL_resource_error("memory");
    }
    *kept = *a;
  }
  PL_retry_address(kept);
}

static foreign_t
start(asking *a, term_t args)
{
  if (!asking_open(a, args)) {
    return FALSE;
  }
  a->next = next_answer(a, args);
  return answer(a, true, args);
}

static foreign_t
prune(asking *a)
{
  asking_close(a);
  free(a);
  return TRUE;
}

static foreign_t
relation_call(sg_relation relation, term_t args, control_t control)
{
  asking a;

  switch (PL_foreign_control(control)) {
  case PL_FIRST_CALL:
    a.relation = relation;
    a.retracts = false;
    return start(&a, args);
  case PL_REDO:
    return answer(PL_foreign_context_address(control), false, args);
  case PL_PRUNED:
    return prune(PL_foreign_context_address(control));
  default:
    return FALSE;
  }
}

#define RELATION(ID, name, arity, key, doc)                                    \
  static foreign_t call_##name(term_t args, int count, void *control)          \
  {                                                                            \
    (void)count;                                                               \
    return relation_call(SG_##ID, args, control);                              \
  }
#include "relations.def"

/* ---- facts as terms ---------------------------------------------------- */

/* The relation of a fact and its arguments. `extra` more references follow
 * the arguments. */
static int
get_fact_ex(term_t t, sg_relation *relation, term_t *args, int extra)
{
  term_t fact = PL_new_term_ref();
  module_t module = NULL;
  atom_t name;
  size_t arity;

  if (!PL_strip_module(t, &module, fact)) {
    return FALSE;
  }
  if (!PL_get_name_arity(fact, &name, &arity)) {
    return PL_is_variable(fact) ? PL_instantiation_error(fact)
                                : PL_type_error("callable", fact);
  }
  *relation = sg_relation_named(name, arity);
  if (*relation == SG_NONE) {
    term_t indicator = PL_new_term_ref();
    return PL_unify_term(indicator, PL_FUNCTOR_CHARS, "/", 2, PL_ATOM, name,
                         PL_INT64, (int64_t)arity) &&
           PL_existence_error("relation", indicator);
  }
  *args = PL_new_term_refs((int)arity + extra);
  for (size_t i = 0; i < arity; i++) {
    _PL_get_arg(i + 1, fact, *args + i);
  }
  return TRUE;
}

static foreign_t
fact_call(term_t fact, bool retracts, control_t control)
{
  asking a;
  asking *kept = PL_foreign_control(control) == PL_FIRST_CALL
                     ? NULL
                     : PL_foreign_context_address(control);
  term_t args;

  if (PL_foreign_control(control) == PL_PRUNED) {
    return prune(kept);
  }
  if (!get_fact_ex(fact, &a.relation, &args, 0)) {
    return FALSE;
  }
  if (kept) {
    return answer(kept, false, args);
  }
  a.retracts = retracts;
  return start(&a, args);
}

/* retract_fact(?Fact) is nondet. */
static foreign_t
retract_fact(term_t fact, control_t control)
{
  sg_world *world = sg_current_world_ex();
  foreign_t done;

  if (PL_foreign_control(control) == PL_PRUNED) {
    return fact_call(fact, true, control);
  }
  if (!world || !sg_claim_ex(world)) {
    return FALSE;
  }
  sg_world_hold(world);
  done = fact_call(fact, true, control);
  sg_world_release(world);
  sg_world_drop(world);
  return done;
}

/* ---- asserting --------------------------------------------------------- */

/* The next word of a domain; false: no more. */
static bool
next_word(const char **words, const char **word, size_t *length)
{
  *word = *words + strspn(*words, " ");
  *length = strcspn(*word, " ");
  *words = *word + *length;
  return *length > 0;
}

/* domain_error(oneof(Words), Culprit) */
static int
raise_domain_words(const char *words, term_t culprit)
{
  term_t list = PL_new_term_ref();
  term_t tail = PL_copy_term_ref(list);
  term_t head = PL_new_term_ref();
  term_t value = PL_new_term_ref();
  term_t ex = PL_new_term_ref();
  const char *word;
  size_t length;

  while (next_word(&words, &word, &length)) {
    char text[32];
    memcpy(text, word, length < 31 ? length : 31);
    text[length < 31 ? length : 31] = '\0';
    if (!PL_chars_to_term(text, value) || !PL_unify_list(tail, head, tail) ||
        !PL_unify(head, value)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail) &&
         PL_unify_term(ex, PL_FUNCTOR_CHARS, "error", 2, PL_FUNCTOR_CHARS,
                       "domain_error", 2, PL_FUNCTOR_CHARS, "oneof", 1,
                       PL_TERM, list, PL_TERM, culprit, PL_VARIABLE) &&
         PL_raise_exception(ex);
}

static int
check_domain_ex(const char *words, term_t t)
{
  const char *rest = words;
  const char *word;
  char *text;
  size_t length;
  size_t n;

  if (!PL_get_nchars(t, &n, &text, CVT_ATOM | CVT_INTEGER | REP_UTF8)) {
    return PL_type_error("atom", t);
  }
  while (next_word(&rest, &word, &length)) {
    if (length == n && memcmp(word, text, n) == 0) {
      return TRUE;
    }
  }
  return raise_domain_words(words, t);
}

static int
get_id_ex(term_t t, int32_t *out)
{
  int64_t i;

  if (!PL_is_integer(t)) {
    return PL_is_variable(t) ? PL_instantiation_error(t)
                             : PL_type_error("integer", t);
  }
  if (!PL_get_int64(t, &i) || i > INT32_MAX) {
    return PL_representation_error("int32");
  }
  if (i < 0) {
    return PL_type_error("nonneg", t);
  }
  *out = (int32_t)i;
  return TRUE;
}

static int
get_positive_id_ex(term_t t, int32_t *out)
{
  return get_id_ex(t, out) && (*out > 0 || PL_domain_error("positive_integer", t));
}

static int
get_finite_ex(term_t t, double *out)
{
  if (PL_is_variable(t)) {
    return PL_instantiation_error(t);
  }
  if (!PL_is_number(t) || !PL_get_float(t, out)) {
    return PL_type_error("float", t);
  }
  *out += 0.0;
  return isfinite(*out) || PL_domain_error("finite_float", t);
}

static int
get_ids_ex(term_t t, const int32_t **out, void **owned)
{
  term_t tail = PL_copy_term_ref(t);
  term_t head = PL_new_term_ref();
  size_t length;
  int32_t *list;
  int kind = PL_skip_list(t, 0, &length);

  if (kind == PL_PARTIAL_LIST) {
    return PL_instantiation_error(t);
  }
  if (kind != PL_LIST || length > INT32_MAX) {
    return PL_type_error("list", t);
  }
  if (!(list = malloc((length + 1) * sizeof(*list)))) {
    return PL_resource_error("memory");
  }
  *owned = list;
  *out = list;
  list[0] = (int32_t)length;
  for (size_t i = 1; i <= length; i++) {
    if (!PL_get_list_ex(tail, head, tail) ||
        !get_positive_id_ex(head, &list[i])) {
      return FALSE;
    }
  }
  return TRUE;
}

static int
get_symbol_ex(term_t t, int32_t *out)
{
  char *text;
  size_t length;

  if (PL_is_variable(t)) {
    return PL_instantiation_error(t);
  }
  if (!PL_get_nchars(t, &length, &text, CVT_ATOM | REP_UTF8)) {
    return PL_type_error("atom", t);
  }
  *out = sg_symbol_intern(text, length);
  return *out >= 0 || PL_resource_error("memory");
}

/* The value of argument t for column c; *owned is to be freed. */
static int
get_value_ex(term_t t, const sg_relation_info *info, unsigned c, sg_value *out,
             void **owned)
{
  const char *domain = info->domain[c];

  switch (info->column[c].type) {
  case SG_INT:
    return domain ? get_id_ex(t, &out->i) && check_domain_ex(domain, t)
                  : get_positive_id_ex(t, &out->i);
  case SG_FLOAT:
    return get_finite_ex(t, &out->f);
  case SG_LIST:
    return get_ids_ex(t, &out->list, owned);
  case SG_ATOM:
    return (!domain || PL_is_variable(t) || check_domain_ex(domain, t)) &&
           get_symbol_ex(t, &out->i);
  case SG_TERM:
    return sg_get_term_ex(t, (uint32_t **)owned) &&
           (out->term = *owned, TRUE);
  }
  return FALSE;
}

static int
raise_fact_status(sg_status status, sg_relation relation,
                  const sg_fault *fault, term_t fact)
{
  return status == SG_EXISTS ? PL_permission_error("assert", "fact", fact)
                             : sg_raise_status(status, relation, fault);
}

static int
add_row_ex(sg_world *world, sg_relation relation, const sg_value *row,
           sg_row *out, term_t fact)
{
  sg_fault fault;
  sg_status status;

  if (!sg_claim_ex(world)) {
    return FALSE;
  }
  status = sg_world_add(world, relation, row, out, &fault);
  sg_world_release(world);
  return raise_fact_status(status, relation, &fault, fact);
}

static int
assert_row(term_t fact, sg_row *out)
{
  sg_world *world = sg_current_world_ex();
  sg_relation relation;
  const sg_relation_info *info;
  sg_value row[SG_MAX_COLUMNS];
  void *owned[SG_MAX_COLUMNS] = {0};
  term_t args;
  int done;

  if (!world || !get_fact_ex(fact, &relation, &args, 0)) {
    return FALSE;
  }
  info = &sg_relation_table[relation];
  done = TRUE;
  for (unsigned c = 0; done && c < info->arity; c++) {
    done = get_value_ex(args + c, info, c, &row[c], &owned[c]);
  }
  done = done && add_row_ex(world, relation, row, out, fact);
  for (unsigned c = 0; c < info->arity; c++) {
    free(owned[c]);
  }
  return done;
}

/* assert_fact(+Fact) is det. */
static foreign_t
assert_fact(term_t fact)
{
  sg_row row;

  return assert_row(fact, &row);
}

/* assert_fact(+Fact, -Row) is det. */
static foreign_t
assert_fact_row(term_t fact, term_t out)
{
  sg_row row;

  return assert_row(fact, &row) && PL_unify_int64(out, row);
}

/* ---- retracting all ---------------------------------------------------- */

static int
retract_matching(asking *a, term_t args)
{
  sg_world *world = sg_version_world(a->version);
  sg_row row;

  while ((row = next_answer(a, args)) != SG_NO_ROW) {
    sg_world_retract(world, a->relation, row);
  }
  return !PL_exception(0);
}

/* A head of which every argument is a variable, no two the same. */
static bool
is_most_general(term_t args, unsigned arity)
{
  for (unsigned i = 0; i < arity; i++) {
    if (!PL_is_variable(args + i)) {
      return false;
    }
    for (unsigned j = 0; j < i; j++) {
      if (PL_compare(args + i, args + j) == 0) {
        return false;
      }
    }
  }
  return true;
}

/* retractall_facts(?Fact) is det. */
static foreign_t
retractall_facts(term_t fact)
{
  sg_world *world = sg_current_world_ex();
  term_t args;
  asking a;
  int done;

  if (!world || !get_fact_ex(fact, &a.relation, &args, 0) ||
      !sg_claim_ex(world)) {
    return FALSE;
  }
  if (is_most_general(args, sg_relation_table[a.relation].arity)) {
    done = sg_world_retract_all(world, a.relation) ||
           PL_resource_error("memory");
  } else if (asking_open(&a, args)) {
    a.strict = true; /* a variable may stand twice */
    done = retract_matching(&a, args);
    asking_close(&a);
  } else {
    done = !PL_exception(0);
  }
  sg_world_release(world);
  return done;
}

/* ---- installing -------------------------------------------------------- */

#define NONDET PL_FA_NONDETERMINISTIC

static const PL_extension predicates[] = {
#define RELATION(ID, name, arity, key, doc)                                    \
  {#name, arity, call_##name, NONDET | PL_FA_VARARGS},
#include "relations.def"
    {"assert_fact", 1, assert_fact, 0},
    {"assert_fact", 2, assert_fact_row, 0},
    {"retract_fact", 1, retract_fact, NONDET},
    {"retractall_facts", 1, retractall_facts, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_store(void)
{
  PL_register_extensions_in_module("sg_store", predicates);
}
