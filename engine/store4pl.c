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
#include "edit4pl.h"
#include "value4pl.h"

#include "install.h"

#include <stdlib.h>
#include <string.h>

enum { POLL_ROWS = 1024 }; /* tried between two questions for signals */

/* ---- a call in progress ------------------------------------------------ */

typedef struct asking {
  const sg_version *version;
  sg_relation relation;
  bool retracts; /* an answer is a row retracted */
  bool numbers;  /* the argument after the last column is the row */
  bool strict;   /* try rows by unification */
  bool plain;    /* after an answer: open arguments are just variables */
  int first;     /* where column 0 would stand among the arguments */
  uint16_t open; /* columns to unify with their arguments */
  sg_row next;   /* the next answer, SG_NO_ROW: none */
  size_t page;   /* of the row that was unified last, and its columns */
  const union sg_cell_array *cells; /* null: there was none */
  sg_walk walk;
  uint16_t owns; /* columns of which walk.row has a list or term to free */
  void *owned[SG_MAX_COLUMNS];
} asking;

static asking
asking_of(sg_relation relation)
{
  asking a;

  a.version = NULL;
  a.relation = relation;
  a.retracts = a.numbers = a.strict = a.plain = false;
  a.first = 0;
  a.open = a.owns = 0;
  a.next = SG_NO_ROW;
  a.page = 0;
  a.cells = NULL;
  return a;
}

static void
asking_close(asking *a)
{
  sg_walk_close(&a->walk);
  sg_version_drop(a->version);
  for (unsigned left = a->owns; left; left &= left - 1) {
    free(a->owned[__builtin_ctz(left)]);
  }
}

/* Reads the arguments and opens the walk. False: no row can match, or an
 * exception is pending; nothing is left to close. */
static int
asking_open(asking *a, term_t args)
{
  const sg_relation_info *info = &sg_relation_table[a->relation];
  sg_world *world = sg_edited_world_ex();
  sg_value row[SG_MAX_COLUMNS];
  uint16_t mask = 0;
  sg_bound bound = SG_OPEN;

  if (!world) {
    return FALSE;
  }
  for (unsigned c = 0; c < info->arity && bound != SG_NOWHERE; c++) {
    void *owned = NULL;

    bound = sg_bound_value(args + c, info->column[c].type, &row[c], &owned);
    if (owned) {
      a->owned[c] = owned;
      a->owns |= (uint16_t)(1U << c);
    }
    if (bound == SG_BOUND) {
      mask |= (uint16_t)(1U << c);
    } else {
      a->open |= (uint16_t)(1U << c);
      a->strict = a->strict || bound == SG_PARTIAL;
    }
  }
  if (bound != SG_NOWHERE) {
    a->version = sg_world_version(world);
    switch (sg_walk_try(&a->walk, a->version, a->relation, mask, row)) {
    case SG_WALK_OPEN:
      a->walk.cancel = &sg_prolog_cancel;
      return TRUE;
    case SG_WALK_WAITS:
      if (!sg_index_ready(a->version, a->relation, mask, &sg_prolog_cancel)) {
        break; /* an exception is pending */
      }
      if (sg_walk_open(&a->walk, a->version, a->relation, mask, row)) {
        a->walk.cancel = &sg_prolog_cancel;
        return TRUE;
      }
      PL_resource_error("memory");
      break;
    case SG_WALK_NO_MEMORY:
      PL_resource_error("memory");
    }
  }
  a->walk.rows = NULL;
  asking_close(a);
  return FALSE;
}

/* As sg_unify_value(), of a column and a place in it; most are numbers. */
static inline int
unify_cell(term_t t, sg_type type, const union sg_cell_array *cells,
           size_t place)
{
  if (type == SG_FLOAT) {
    return PL_unify_float(t, cells->f[place]);
  }
  if (type == SG_INT) {
    return PL_unify_integer(t, cells->i[place]);
  }
  sg_value value = {0};

  if (type == SG_ATOM) {
    value.i = cells->i[place];
  } else {
    value.term = cells->ref[place];
  }
  return sg_unify_value(t, type, value);
}

/* The columns of the page that a row is on. */
static inline const union sg_cell_array *
cells_of(asking *a, sg_row row)
{
  size_t page = row / SG_PAGE_ROWS;

  if (!a->cells || a->page != page) {
    a->cells = sg_version_cells(a->version, a->relation, page);
    a->page = page;
  }
  return a->cells;
}

/* Unifies the open arguments with a row. *shared, where asked for, becomes
 * true if a variable stands twice among them. */
static int
unify_row(asking *a, term_t args, sg_row row, bool *shared)
{
  const sg_relation_info *info = &sg_relation_table[a->relation];
  const union sg_cell_array *cells = cells_of(a, row);
  term_t first = args + (term_t)a->first;

  for (unsigned left = a->open; left; left &= left - 1) {
    unsigned c = (unsigned)__builtin_ctz(left);
    if (shared && !PL_is_variable(first + c)) {
      *shared = true;
    }
    if (!unify_cell(first + c, info->column[c].type, &cells[c],
                    row % SG_PAGE_ROWS)) {
      return FALSE;
    }
  }
  return !a->numbers || PL_unify_int64(args + (int)info->arity, row);
}

/* The next row that is an answer; a strict call tries it by unification.
 * SG_NO_ROW: there is none, or an exception is pending. */
static sg_row
next_answer(asking *a, term_t args)
{
  sg_row row;

  while ((row = sg_walk_next(&a->walk)) != SG_NO_ROW && a->strict) {
    fid_t frame;
    int fits;
    if ((row % POLL_ROWS == 0 && PL_handle_signals() < 0) ||
        !(frame = PL_open_foreign_frame())) {
      return SG_NO_ROW;
    }
    fits = unify_row(a, args, row, NULL);
    if (PL_exception(0)) {
      PL_close_foreign_frame(frame);
      return SG_NO_ROW;
    }
    PL_discard_foreign_frame(frame);
    if (fits) {
      return row;
    }
  }
  return row;
}

/* Retracts an answer. With the last one the version is let go first: nobody
 * then holds what the change is to write, and nothing need be copied. */
static int
retract_answer(asking *a, sg_row row)
{
  sg_world *world = sg_version_world(a->version);
  int done = FALSE;

  if (!sg_claim_ex(world)) {
    return FALSE;
  }
  sg_world_keep(world);
  if (a->next == SG_NO_ROW) {
    sg_version_drop(a->version);
    a->version = NULL;
  }
  done = sg_retract_edit_ex(world, a->relation, row, false);
  sg_world_release(world);
  sg_world_let_go(world);
  return done;
}

static int
give(asking *a, term_t args, sg_row row, bool *shared)
{
  return unify_row(a, args, row, shared) && (a->strict || !*shared) &&
         (!a->retracts || retract_answer(a, row));
}

/* Whether a row is given by unification alone: what it left where that fails is
 * undone by the failure. So it is where no variable stands twice, or the row is
 * the only one, and nothing is tried and nothing retracted. */
static bool
is_plain(const asking *a)
{
  return a->plain || (a->next == SG_NO_ROW && !a->strict && !a->retracts);
}

/* Gives `row`, which comes before a->next, or, when that is none after all, one
 * after it. False: no answer, or an exception is pending. */
static int
give_next(asking *a, term_t args, sg_row row)
{
  while (row != SG_NO_ROW) {
    bool shared = false;
    fid_t frame = PL_exception(0) ? 0 : PL_open_foreign_frame();

    if (!frame) {
      return FALSE;
    }
    if (give(a, args, row, &shared)) {
      PL_close_foreign_frame(frame);
      a->plain = !a->strict && !a->retracts;
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
    row = a->next;
    a->next = row == SG_NO_ROW ? SG_NO_ROW : next_answer(a, args);
  }
  return FALSE;
}

static foreign_t
asking_end(asking *a, bool kept, foreign_t result)
{
  asking_close(a);
  if (kept) {
    free(a);
  }
  return result;
}

/* One answer. `kept`: the asking is on the heap, from an earlier answer. */
static foreign_t
answer(asking *a, bool kept, term_t args)
{
  asking *keep = a;
  sg_row row = a->next;

  a->next = row == SG_NO_ROW ? SG_NO_ROW : next_answer(a, args);
  if (a->next == SG_NO_ROW && PL_exception(0)) { /* it was stopped */
    return asking_end(a, kept, FALSE);
  }
  if (!(row != SG_NO_ROW && is_plain(a) ? unify_row(a, args, row, NULL)
                                        : give_next(a, args, row))) {
    return asking_end(a, kept, FALSE);
  }
  if (a->next == SG_NO_ROW) {
    return asking_end(a, kept, TRUE);
  }
  if (!kept) {
    if (!(keep = malloc(sizeof(*keep)))) {
      return asking_end(a, false, (foreign_t)PL_resource_error("memory"));
    }
    *keep = *a;
  }
  PL_retry_address(keep);
}

static foreign_t
first_answer(asking *a, term_t args)
{
  a->next = next_answer(a, args);
  return PL_exception(0) ? asking_end(a, false, FALSE) : answer(a, false, args);
}

static foreign_t
prune(control_t control)
{
  return asking_end(PL_foreign_context_address(control), true, TRUE);
}

/* ---- relations --------------------------------------------------------- */

static foreign_t
relation_call(sg_relation relation, term_t args, control_t control)
{
  asking a;

  switch (PL_foreign_control(control)) {
  case PL_FIRST_CALL:
    a = asking_of(relation);
    return asking_open(&a, args) ? first_answer(&a, args) : FALSE;
  case PL_REDO:
    return answer(PL_foreign_context_address(control), true, args);
  case PL_PRUNED:
    return prune(control);
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

/* Answers of a fact; `row` is unified with their row numbers, 0: it is not. */
static foreign_t
fact_call(term_t fact, term_t row, bool retracts, control_t control)
{
  sg_relation relation;
  asking a;
  term_t args;

  if (PL_foreign_control(control) == PL_PRUNED) {
    return prune(control);
  }
  if (!sg_get_fact_ex(fact, row, &relation, &args)) {
    return FALSE;
  }
  if (PL_foreign_control(control) == PL_REDO) {
    return answer(PL_foreign_context_address(control), true, args);
  }
  a = asking_of(relation);
  a.retracts = retracts;
  a.numbers = row != 0;
  return asking_open(&a, args) ? first_answer(&a, args) : FALSE;
}

/* retract_fact(?Fact) is nondet. */
static foreign_t
retract_fact(term_t fact, control_t control)
{
  return fact_call(fact, 0, true, control);
}

/* Answers with a row number given: at most one. */
static int
numbered_fact(term_t fact, term_t row_term)
{
  sg_world *world = sg_edited_world_ex();
  sg_relation relation;
  int64_t number;
  asking a;
  term_t args;
  int done;

  if (!world || !sg_get_fact_ex(fact, 0, &relation, &args)) {
    return FALSE;
  }
  if (!PL_get_int64(row_term, &number)) {
    return PL_type_error("integer", row_term);
  }
  a = asking_of(relation);
  a.open = (uint16_t)((1U << sg_relation_table[relation].arity) - 1);
  a.version = sg_world_version(world);
  done = number >= 0 && number < SG_NO_ROW &&
         sg_version_live(a.version, relation, (sg_row)number) &&
         unify_row(&a, args, (sg_row)number, NULL);
  sg_version_drop(a.version);
  return done;
}

/* fact_row(?Fact, ?Row) is nondet. */
static foreign_t
fact_row(term_t fact, term_t row, control_t control)
{
  bool given =
      PL_foreign_control(control) == PL_FIRST_CALL && !PL_is_variable(row);

  return given ? (foreign_t)numbered_fact(fact, row)
               : fact_call(fact, row, false, control);
}

/* The arguments from `from` on are variables, none of them twice. */
static bool
are_free(term_t args, unsigned from, unsigned to)
{
  for (unsigned i = from; i < to; i++) {
    if (!PL_is_variable(args + i)) {
      return false;
    }
    for (unsigned j = from; j < i; j++) {
      if (PL_compare(args + i, args + j) == 0) {
        return false;
      }
    }
  }
  return true;
}

/* A fact of which the first argument alone is given: a segment, and its rows
 * are many. */
static bool
is_of_segment(sg_relation relation, term_t args, int32_t *s)
{
  const sg_relation_info *info = &sg_relation_table[relation];
  int64_t number;

  if (info->key == 1 || info->column[0].type != SG_INT || info->domain[0] ||
      !PL_is_integer(args) || !PL_get_int64(args, &number) || number < 1 ||
      number > INT32_MAX) {
    return false;
  }
  *s = (int32_t)number;
  return are_free(args, 1, info->arity);
}

enum { RETRACTED = 1 << 14 }; /* rows between questions for signals */

static int
retract_answers_ex(asking *a, term_t args)
{
  sg_world *world = sg_version_world(a->version);
  sg_row row;

  a->strict = a->strict || a->open; /* a variable may stand twice */
  for (size_t n = 1; (row = next_answer(a, args)) != SG_NO_ROW; n++) {
    if ((!sg_retract_edit_ex(world, a->relation, row, false) &&
         PL_exception(0)) ||
        (n % RETRACTED == 0 && PL_handle_signals() < 0)) {
      return FALSE;
    }
  }
  return !PL_exception(0);
}

static int
retract_all_ex(sg_world *world, sg_relation relation, term_t args)
{
  asking a = asking_of(relation);
  int32_t s;
  int done;

  if (are_free(args, 0, sg_relation_table[relation].arity)) {
    return sg_world_retract_all_edit(world, relation) ||
           PL_resource_error("memory");
  }
  if (is_of_segment(relation, args, &s)) {
    return sg_world_retract_of_edit(world, relation, s) ||
           PL_resource_error("memory");
  }
  if (!asking_open(&a, args)) {
    return !PL_exception(0);
  }
  done = retract_answers_ex(&a, args);
  asking_close(&a);
  return done;
}

/* Outside a transaction it is one of its own, but no step to undo. */
static int
retract_alone_ex(sg_world *world, sg_relation relation, term_t args)
{
  if (!sg_raise_status(sg_world_begin(world), SG_NONE, NULL)) {
    return FALSE;
  }
  if (retract_all_ex(world, relation, args) && sg_make_whole_ex(world, false)) {
    sg_world_commit_change(world);
    return TRUE;
  }
  sg_world_rollback(world);
  return FALSE;
}

/* retractall_facts(?Fact) is det. */
static foreign_t
retractall_facts(term_t fact)
{
  sg_world *world = sg_edited_world_ex();
  sg_relation relation;
  term_t args;
  int done;

  if (!world || !sg_get_fact_ex(fact, 0, &relation, &args) ||
      !sg_claim_ex(world)) {
    return FALSE;
  }
  done = sg_world_depth(world) > 0 ? retract_all_ex(world, relation, args)
                                   : retract_alone_ex(world, relation, args);
  sg_world_release(world);
  return done;
}

/* ---- members ----------------------------------------------------------- */

/* Opens a walk over the rows that hold an id; args: S, the id, and the
 * argument to unify with `column`. Nothing is left to close when it fails. */
static int
member_open(asking *a, term_t args, unsigned column)
{
  sg_world *world = sg_edited_world_ex();
  sg_value s;
  sg_value id;
  void *none;

  if (!world || sg_bound_value(args, SG_INT, &s, &none) != SG_BOUND ||
      sg_bound_value(args + 1, SG_INT, &id, &none) != SG_BOUND) {
    return FALSE;
  }
  a->open = (uint16_t)(1U << column);
  a->first = 2 - (int)column;
  a->strict = !PL_is_variable(args + 2);
  a->version = sg_world_version(world);
  bool ready = sg_index_ready(a->version, a->relation, 0, &sg_prolog_cancel);

  if (ready &&
      sg_walk_open_member(&a->walk, a->version, a->relation, s.i, id.i)) {
    return TRUE;
  }
  a->walk.rows = NULL;
  asking_close(a);
  return ready && PL_resource_error("memory");
}

static foreign_t
member_call(sg_relation relation, unsigned column, term_t args,
            control_t control)
{
  asking a;

  switch (PL_foreign_control(control)) {
  case PL_FIRST_CALL:
    a = asking_of(relation);
    return member_open(&a, args, column) ? first_answer(&a, args) : FALSE;
  case PL_REDO:
    return answer(PL_foreign_context_address(control), true, args);
  case PL_PRUNED:
    return prune(control);
  default:
    return FALSE;
  }
}

/* '$edge_polygon'(+S, +E, ?P) is nondet. */
static foreign_t
edge_polygon(term_t args, int count, void *control)
{
  (void)count;
  return member_call(SG_P, 1, args, control);
}

/* '$vertex_triangle'(+S, +V, ?T) is nondet. */
static foreign_t
vertex_triangle(term_t args, int count, void *control)
{
  (void)count;
  return member_call(SG_T, 2, args, control);
}

/* ---- installing -------------------------------------------------------- */

#define NONDET PL_FA_NONDETERMINISTIC

static const PL_extension predicates[] = {
#define RELATION(ID, name, arity, key, doc)                                    \
  {#name, arity, call_##name, NONDET | PL_FA_VARARGS},
#include "relations.def"
    {"retract_fact", 1, retract_fact, NONDET},
    {"retractall_facts", 1, retractall_facts, 0},
    {"fact_row", 2, fact_row, NONDET},
    {"$edge_polygon", 3, edge_polygon, NONDET | PL_FA_VARARGS},
    {"$vertex_triangle", 3, vertex_triangle, NONDET | PL_FA_VARARGS},
    {NULL, 0, NULL, 0},
};

void
sg_install_store(void)
{
  PL_register_extensions_in_module("sg_store", predicates);
}
