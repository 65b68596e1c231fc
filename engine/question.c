/* question.c -- questions and the columns of their answers, for sanggwan.h.
 *
 * Layer: engine, beside engine.c. A question is a Prolog engine of its own; the
 * values of an answer are copied out of it.
 */
#include "host.h"
#include "install.h"

#include <limits.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

typedef struct value {
  enum { NOTHING, INTEGER, REAL, OTHER } kind;
  bool has_real; /* also a number where kind is OTHER: a large integer */
  int64_t integer;
  double real;
  record_t other;
  char *text; /* by PL_malloc(), made when asked for; or null */
} value;

struct sanggwan_query {
  sanggwan_world *world;
  sanggwan_query *next; /* in the world's list */
  atom_t engine;        /* 0: no more answers */
  int columns;
  char **name; /* [columns] */
  value *row;  /* [columns] */
};

/* ---- questions --------------------------------------------------------- */

static void
clear_row(sanggwan_query *query)
{
  for (int c = 0; c < query->columns; c++) {
    value *v = &query->row[c];
    if (v->other) {
      PL_erase(v->other);
    }
    PL_free(v->text);
    memset(v, 0, sizeof(*v));
  }
}

static void
free_query(sanggwan_query *query)
{
  if (query->engine) {
    PL_unregister_atom(query->engine);
  }
  for (int c = 0; query->name && c < query->columns; c++) {
    PL_free(query->name[c]);
  }
  free(query->name);
  free(query->row);
  free(query);
}

/* The columns' names from names(Name, ...). */
static bool
take_names(sanggwan_query *query, term_t names)
{
  term_t t = PL_new_term_ref();
  size_t n = 0;
  atom_t atom;

  if (!t || (!PL_get_name_arity(names, &atom, &n) || n > INT_MAX)) {
    return false;
  }
  query->columns = (int)n;
  query->name = calloc(n + 1, sizeof(*query->name));
  query->row = calloc(n + 1, sizeof(*query->row));
  if (!query->name || !query->row) {
    return false;
  }
  for (size_t c = 0; c < n; c++) {
    if (!PL_get_arg(c + 1, names, t)) {
      return false;
    }
    sg_host_take_text(t, &query->name[c]);
    if (!query->name[c]) {
      return false;
    }
  }
  return true;
}

/* A query from what ask(Text, Names, Engine) left in its arguments. */
static sanggwan_query *
new_query(sanggwan_world *world, term_t names, term_t engine)
{
  sanggwan_query *query = calloc(1, sizeof(*query));
  atom_t atom;

  if (!query || !take_names(query, names) || !PL_get_atom(engine, &atom)) {
    if (query) {
      free_query(query);
    }
    sg_host_complain(world, SANGGWAN_IMPOSSIBLE, "there is no memory");
    return NULL;
  }
  PL_register_atom(atom);
  query->engine = atom;
  query->world = world;
  query->next = world->queries;
  world->queries = query;
  return query;
}

sanggwan_query *
sanggwan_ask(sanggwan_world *world, const char *goal)
{
  sanggwan_status status;
  fid_t frame = sg_host_enter(world, &status);
  sanggwan_query *query = NULL;
  term_t args, what;

  if (!frame) {
    return NULL;
  }
  args = PL_new_term_refs(3);
  what = PL_new_term_ref();
  if (!goal) {
    sg_host_complain(world, SANGGWAN_USAGE, "no goal");
  } else if (!args || !what ||
             !PL_put_chars(args, PL_STRING | REP_UTF8, (size_t)-1, goal) ||
             !PL_cons_functor_v(what, PL_new_functor(PL_new_atom("ask"), 3),
                                args)) {
    PL_clear_exception();
    sg_host_complain(world, SANGGWAN_USAGE, "the text is not UTF-8");
  } else if (sg_host_ask(world, what) == SANGGWAN_DONE) {
    query = new_query(world, args + 1, args + 2);
  }
  PL_discard_foreign_frame(frame);
  return query;
}

static bool
take_value(term_t t, value *v)
{
  if (PL_get_int64(t, &v->integer) && PL_is_integer(t)) {
    v->kind = INTEGER;
  } else if (PL_is_float(t) && PL_get_float(t, &v->real)) {
    v->kind = REAL;
  } else {
    v->kind = OTHER;
    v->has_real = PL_is_number(t) && PL_get_float(t, &v->real);
    v->other = PL_record(t);
  }
  return v->kind != OTHER || v->other;
}

static bool
take_row(sanggwan_query *query, term_t row)
{
  term_t t = PL_new_term_ref();

  for (int c = 0; c < query->columns; c++) {
    if (!PL_get_arg((size_t)c + 1, row, t) || !take_value(t, &query->row[c])) {
      return false;
    }
  }
  return true;
}

/* No more answers: the engine has gone, or goes with its atom. */
static void
end_answers(sanggwan_query *query)
{
  PL_unregister_atom(query->engine);
  query->engine = 0;
}

/* Puts Name(Engine) or Name(Engine, Row) into `what`, Row a new variable. */
static int
put_engine_request(term_t what, const char *name, atom_t engine, term_t *row)
{
  term_t args = PL_new_term_refs(2);

  if (row) {
    *row = args + 1;
  }
  return args && PL_put_atom(args, engine) &&
         PL_cons_functor_v(what, PL_new_functor(PL_new_atom(name), row ? 2 : 1),
                           args);
}

sanggwan_status
sanggwan_next(sanggwan_query *query)
{
  sanggwan_status status = SANGGWAN_NO;
  fid_t frame;
  term_t what, row;

  if (!query) {
    return sg_host_refuse(SANGGWAN_USAGE, "no query");
  }
  clear_row(query);
  if (!query->engine) {
    return sg_host_complain(query->world, SANGGWAN_NO, "");
  }
  frame = sg_host_enter(query->world, &status);
  if (!frame) {
    return status;
  }
  what = PL_new_term_ref();
  if (!what || !put_engine_request(what, "next", query->engine, &row)) {
    status = sg_host_complain(query->world, SANGGWAN_IMPOSSIBLE,
                              "there is no memory");
  } else {
    status = sg_host_ask(query->world, what);
    if (status == SANGGWAN_DONE && !take_row(query, row)) {
      status = sg_host_complain(query->world, SANGGWAN_IMPOSSIBLE,
                                "there is no memory");
    }
  }
  if (status != SANGGWAN_DONE) {
    end_answers(query);
  }
  PL_discard_foreign_frame(frame);
  return status;
}

static void
unlink_query(sanggwan_query *query)
{
  sanggwan_query **at = &query->world->queries;

  while (*at && *at != query) {
    at = &(*at)->next;
  }
  if (*at) {
    *at = query->next;
  }
}

/* Ends an engine that has more answers; keeps the world's message. */
static void
destroy_engine(sanggwan_query *query)
{
  sanggwan_world own = {.handle = query->world->handle};
  sanggwan_status status;
  fid_t frame = sg_host_enter(&own, &status);
  term_t what;

  if (frame) {
    what = PL_new_term_ref();
    if (what && put_engine_request(what, "close", query->engine, NULL)) {
      (void)sg_host_ask(&own, what);
    }
    PL_discard_foreign_frame(frame);
  }
  PL_free(own.message);
  PL_free(own.warnings);
}

void
sanggwan_query_close(sanggwan_query *query)
{
  if (!query) {
    return;
  }
  if (query->engine) {
    destroy_engine(query);
  }
  clear_row(query);
  unlink_query(query);
  free_query(query);
}

/* ---- columns of an answer ---------------------------------------------- */

int
sanggwan_columns(const sanggwan_query *query)
{
  return query ? query->columns : 0;
}

const char *
sanggwan_column_name(const sanggwan_query *query, int column)
{
  return query && column >= 0 && column < query->columns ? query->name[column]
                                                         : NULL;
}

int
sanggwan_column(const sanggwan_query *query, const char *name)
{
  for (int c = 0; query && name && c < query->columns; c++) {
    if (strcmp(query->name[c], name) == 0) {
      return c;
    }
  }
  return -1;
}

/* Null: no such column, or no answer. */
static value *
value_at(const sanggwan_query *query, int column)
{
  value *v;

  if (!query || column < 0 || column >= query->columns) {
    return NULL;
  }
  v = &query->row[column];
  return v->kind == NOTHING ? NULL : v;
}

bool
sanggwan_int(const sanggwan_query *query, int column, int64_t *out)
{
  const value *v = value_at(query, column);

  if (!v || v->kind != INTEGER) {
    return false;
  }
  *out = v->integer;
  return true;
}

bool
sanggwan_double(const sanggwan_query *query, int column, double *out)
{
  const value *v = value_at(query, column);

  if (!v || (v->kind == OTHER && !v->has_real)) {
    return false;
  }
  *out = v->kind == INTEGER ? (double)v->integer : v->real;
  return true;
}

static int
put_value(term_t t, const value *v)
{
  switch (v->kind) {
  case INTEGER:
    return PL_put_int64(t, v->integer);
  case REAL:
    return PL_put_float(t, v->real);
  case OTHER:
    return PL_recorded(v->other, t);
  case NOTHING:
  default:
    return FALSE;
  }
}

/* What writes a term goes down the C stack of this thread. */
enum { SHALLOW = 100, STACK_OF_LEVEL = 2048 };

static size_t
stack_left(void)
{
  pthread_attr_t attributes;
  void *low = NULL;
  size_t size = 0;
  char here;

  if (pthread_getattr_np(pthread_self(), &attributes) != 0) {
    return 0;
  }
  pthread_attr_getstack(&attributes, &low, &size);
  pthread_attr_destroy(&attributes);
  return (size_t)(&here - (char *)low);
}

static bool
is_too_deep(term_t t)
{
  return sg_is_deeper(t, SHALLOW) &&
         sg_is_deeper(t, stack_left() / STACK_OF_LEVEL);
}

const char *
sanggwan_text(sanggwan_query *query, int column)
{
  value *v = value_at(query, column);
  fid_t frame;

  if (!v || v->text || sg_host_obstacle() ||
      !(frame = PL_open_foreign_frame())) {
    return v ? v->text : NULL;
  }
  term_t t = PL_new_term_ref();
  if (!t || !put_value(t, v) || is_too_deep(t) ||
      !sg_host_text(t, CVT_ATOM | CVT_STRING | CVT_WRITEQ, &v->text)) {
    v->text = NULL;
    PL_clear_exception();
  }
  PL_discard_foreign_frame(frame);
  return v->text;
}
