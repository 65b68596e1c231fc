/* engine.c -- the public interface for C programs: sanggwan.h says it all.
 *
 * Layer: engine, beside main.c. It calls one rule, sg_embedding:embedded/5, and
 * turns what comes back into C values.
 */
#include "sanggwan.h"

#include "start.h"

#include <SWI-Prolog.h>

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

struct sanggwan_world {
  atom_t handle;
  char *message, *warnings; /* by PL_malloc(), or null: "" */
  sanggwan_query *queries;  /* those open, a list */
};

struct sanggwan_query {
  sanggwan_world *world;
  sanggwan_query *next; /* in the world's list */
  atom_t engine;        /* 0: no more answers */
  int columns;
  char **name; /* [columns] */
  value *row;  /* [columns] */
};

/* ---- messages ---------------------------------------------------------- */

static _Thread_local const char *world_less = "";

static sanggwan_status
refuse(sanggwan_status status, const char *why)
{
  world_less = why;
  return status;
}

static void
set_text(char **to, const char *text)
{
  char *copy = NULL;
  size_t n = strlen(text);

  if (n > 0 && (copy = PL_malloc(n + 1))) {
    memcpy(copy, text, n + 1);
  }
  PL_free(*to);
  *to = copy;
}

static sanggwan_status
complain(sanggwan_world *world, sanggwan_status status, const char *why)
{
  set_text(&world->message, why);
  set_text(&world->warnings, "");
  return status;
}

const char *
sanggwan_message(const sanggwan_world *world)
{
  if (!world) {
    return world_less;
  }
  return world->message ? world->message : "";
}

const char *
sanggwan_warnings(const sanggwan_world *world)
{
  return world && world->warnings ? world->warnings : "";
}

/* ---- the process and its threads --------------------------------------- */

/* Messages in the language of the environment, not that of the machine where
 * the state was made. */
static void
choose_language(void)
{
  fid_t frame = PL_open_foreign_frame();

  if (frame) {
    term_t none = PL_new_term_ref();
    if (none && PL_put_nil(none)) {
      (void)PL_call_predicate(NULL, PL_Q_CATCH_EXCEPTION,
                              PL_predicate("language", 1, "sg_cli"), none);
    }
    PL_discard_foreign_frame(frame);
  }
}

static sanggwan_status
start_prolog(void)
{
  static char name[] = "sanggwan", quiet[] = "-q", file[] = "-f",
              none[] = "none", no_signals[] = "--no-signals", end[] = "--";
  static char *arguments[] = {name, quiet, file, none, no_signals, end, NULL};

  if (!sg_start(sizeof(arguments) / sizeof(*arguments) - 1, arguments)) {
    return refuse(SANGGWAN_IMPOSSIBLE, "SWI-Prolog cannot be started");
  }
  choose_language();
  return SANGGWAN_DONE;
}

static sanggwan_status
join_prolog(void)
{
  if (PL_thread_self() < 0) {
    return refuse(SANGGWAN_USAGE, "Prolog runs, but not in this thread: attach "
                                  "the thread first");
  }
  if (!sg_start_inside()) {
    return refuse(SANGGWAN_IMPOSSIBLE,
                  "the rules cannot be loaded into the SWI-Prolog that runs: "
                  "another version of it, or no folder for temporary files");
  }
  return SANGGWAN_DONE;
}

sanggwan_status
sanggwan_start(void)
{
  static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
  static bool started;
  sanggwan_status status = SANGGWAN_DONE;

  pthread_mutex_lock(&lock);
  if (!started) {
    status = PL_is_initialised(NULL, NULL) ? join_prolog() : start_prolog();
    started = status == SANGGWAN_DONE;
  }
  pthread_mutex_unlock(&lock);
  return status;
}

sanggwan_status
sanggwan_attach(void)
{
  if (!PL_is_initialised(NULL, NULL)) {
    return refuse(SANGGWAN_USAGE, "sanggwan_start() comes first");
  }
  if (PL_thread_self() < 0 && PL_thread_attach_engine(NULL) < 0) {
    return refuse(SANGGWAN_IMPOSSIBLE, "this thread cannot be attached");
  }
  return SANGGWAN_DONE;
}

void
sanggwan_detach(void)
{
  if (PL_is_initialised(NULL, NULL) && PL_thread_self() > 1) {
    PL_thread_destroy_engine();
  }
}

/* Null: this thread may call Prolog; otherwise why not. */
static const char *
obstacle(void)
{
  if (!PL_is_initialised(NULL, NULL)) {
    return "sanggwan_start() comes first";
  }
  return PL_thread_self() < 0
             ? "this thread is not attached: sanggwan_attach() comes first"
             : NULL;
}

/* ---- asking the rules -------------------------------------------------- */

static void
take_text(term_t t, char **to)
{
  char *text;
  size_t n;

  PL_free(*to);
  *to = NULL;
  if (PL_get_nchars(t, &n, &text,
                    CVT_ATOM | CVT_STRING | BUF_MALLOC | REP_UTF8)) {
    *to = text;
  }
}

/* Calls embedded(World, What, Status, Text, Warnings). What keeps its
 * bindings; the caller has a frame open. */
static sanggwan_status
embedded(sanggwan_world *world, term_t what)
{
  predicate_t embedded_5 = PL_predicate("embedded", 5, "sg_embedding");
  term_t args = PL_new_term_refs(5);
  int status;

  if (!args || !PL_put_atom(args, world->handle) ||
      !PL_put_term(args + 1, what) ||
      !PL_call_predicate(NULL, PL_Q_CATCH_EXCEPTION, embedded_5, args) ||
      !PL_get_integer(args + 2, &status)) {
    return complain(world, SANGGWAN_IMPOSSIBLE, "Prolog has no memory left");
  }
  take_text(args + 3, &world->message);
  take_text(args + 4, &world->warnings);
  return (sanggwan_status)status;
}

/* Opens a frame for a call with this world, 0: not possible, *status says. */
static fid_t
enter_call(sanggwan_world *world, sanggwan_status *status)
{
  const char *why;
  fid_t frame = 0;

  if (!world) {
    *status = refuse(SANGGWAN_USAGE, "no world");
  } else if ((why = obstacle())) {
    *status = complain(world, SANGGWAN_USAGE, why);
  } else if (!(frame = PL_open_foreign_frame())) {
    *status = complain(world, SANGGWAN_IMPOSSIBLE, "Prolog has no memory left");
  }
  return frame;
}

/* What = Name(Text1, Text2), Text2 left out where it is null; an atom if
 * both are. File names are atoms, other text strings. */
static int
put_request(term_t what, const char *name, int kind, const char *text1,
            const char *text2)
{
  term_t args = PL_new_term_refs(2);
  int arity = text2 ? 2 : 1;

  if (!text1) {
    return PL_put_atom_chars(what, name);
  }
  return args &&
         PL_put_chars(args, kind | (kind == PL_ATOM ? REP_FN : REP_UTF8),
                      (size_t)-1, text1) &&
         (!text2 ||
          PL_put_chars(args + 1, PL_STRING | REP_UTF8, (size_t)-1, text2)) &&
         PL_cons_functor_v(
             what, PL_new_functor(PL_new_atom(name), (size_t)arity), args);
}

static sanggwan_status
request(sanggwan_world *world, const char *name, int kind, const char *text1,
        const char *text2)
{
  sanggwan_status status = SANGGWAN_DONE;
  fid_t frame = enter_call(world, &status);
  term_t what;

  if (!frame) {
    return status;
  }
  what = PL_new_term_ref();
  if (what && put_request(what, name, kind, text1, text2)) {
    status = embedded(world, what);
  } else {
    PL_clear_exception();
    status = complain(world, SANGGWAN_USAGE, "the text is not UTF-8");
  }
  PL_discard_foreign_frame(frame);
  return status;
}

/* The same where the first text must be there. */
static sanggwan_status
request_with(sanggwan_world *world, const char *name, int kind,
             const char *text1, const char *text2)
{
  if (world && !text1) {
    return complain(world, SANGGWAN_USAGE,
                    kind == PL_ATOM ? "no file name" : "no goal");
  }
  return request(world, name, kind, text1, text2);
}

/* ---- worlds ------------------------------------------------------------ */

/* The world's atom, held; 0: there is no memory. */
static atom_t
new_world(void)
{
  fid_t frame = PL_open_foreign_frame();
  term_t t;
  atom_t handle = 0;

  if (frame) {
    t = PL_new_term_ref();
    if (t &&
        PL_call_predicate(NULL, PL_Q_CATCH_EXCEPTION,
                          PL_predicate("new_world", 1, "sg_store"), t) &&
        PL_get_atom(t, &handle)) {
      PL_register_atom(handle);
    }
    PL_discard_foreign_frame(frame);
  }
  return handle;
}

static sanggwan_world *
with_handle(atom_t handle)
{
  sanggwan_world *world = handle ? calloc(1, sizeof(*world)) : NULL;

  if (world) {
    world->handle = handle;
  } else {
    if (handle) {
      PL_unregister_atom(handle);
    }
    (void)refuse(SANGGWAN_IMPOSSIBLE, "there is no memory");
  }
  return world;
}

sanggwan_world *
sanggwan_open(void)
{
  const char *why = obstacle();

  if (why) {
    (void)refuse(SANGGWAN_USAGE, why);
    return NULL;
  }
  return with_handle(new_world());
}

sanggwan_world *
sanggwan_share(const sanggwan_world *world)
{
  const char *why = world ? obstacle() : "no world";

  if (why) {
    (void)refuse(SANGGWAN_USAGE, why);
    return NULL;
  }
  PL_register_atom(world->handle);
  return with_handle(world->handle);
}

void
sanggwan_close(sanggwan_world *world)
{
  if (!world) {
    return;
  }
  while (world->queries) {
    sanggwan_query_close(world->queries);
  }
  PL_unregister_atom(world->handle);
  PL_free(world->message);
  PL_free(world->warnings);
  free(world);
}

sanggwan_status
sanggwan_enter(sanggwan_world *world)
{
  return request(world, "enter", PL_ATOM, NULL, NULL);
}

/* ---- files and goals --------------------------------------------------- */

sanggwan_status
sanggwan_load(sanggwan_world *world, const char *file)
{
  return request_with(world, "load", PL_ATOM, file, NULL);
}

sanggwan_status
sanggwan_use_rules(sanggwan_world *world, const char *file)
{
  return request_with(world, "use_rules", PL_ATOM, file, NULL);
}

sanggwan_status
sanggwan_save(sanggwan_world *world, const char *file)
{
  return request_with(world, "save", PL_ATOM, file, NULL);
}

sanggwan_status
sanggwan_draw(sanggwan_world *world, const char *file, const char *options)
{
  return request_with(world, "draw", PL_ATOM, file, options ? options : "");
}

sanggwan_status
sanggwan_run(sanggwan_world *world, const char *goal)
{
  return request_with(world, "run", PL_STRING, goal, NULL);
}

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

  if (!t || (!PL_get_name_arity(names, &atom, &n) || n > INT32_MAX)) {
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
    take_text(t, &query->name[c]);
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
    complain(world, SANGGWAN_IMPOSSIBLE, "there is no memory");
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
  fid_t frame = enter_call(world, &status);
  sanggwan_query *query = NULL;
  term_t args, what;

  if (!frame) {
    return NULL;
  }
  args = PL_new_term_refs(3);
  what = PL_new_term_ref();
  if (!goal) {
    complain(world, SANGGWAN_USAGE, "no goal");
  } else if (!args || !what ||
             !PL_put_chars(args, PL_STRING | REP_UTF8, (size_t)-1, goal) ||
             !PL_cons_functor_v(what, PL_new_functor(PL_new_atom("ask"), 3),
                                args)) {
    PL_clear_exception();
    complain(world, SANGGWAN_USAGE, "the text is not UTF-8");
  } else if (embedded(world, what) == SANGGWAN_DONE) {
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
    return refuse(SANGGWAN_USAGE, "no query");
  }
  clear_row(query);
  if (!query->engine) {
    return complain(query->world, SANGGWAN_NO, "");
  }
  frame = enter_call(query->world, &status);
  if (!frame) {
    return status;
  }
  what = PL_new_term_ref();
  if (!what || !put_engine_request(what, "next", query->engine, &row)) {
    status = complain(query->world, SANGGWAN_IMPOSSIBLE, "there is no memory");
  } else {
    status = embedded(query->world, what);
    if (status == SANGGWAN_DONE && !take_row(query, row)) {
      status =
          complain(query->world, SANGGWAN_IMPOSSIBLE, "there is no memory");
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
  fid_t frame = enter_call(&own, &status);
  term_t what;

  if (frame) {
    what = PL_new_term_ref();
    if (what && put_engine_request(what, "close", query->engine, NULL)) {
      (void)embedded(&own, what);
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

const char *
sanggwan_text(sanggwan_query *query, int column)
{
  value *v = value_at(query, column);
  fid_t frame;
  size_t n;

  if (!v || v->text || obstacle() || !(frame = PL_open_foreign_frame())) {
    return v ? v->text : NULL;
  }
  term_t t = PL_new_term_ref();
  if (!t || !put_value(t, v) ||
      !PL_get_nchars(t, &n, &v->text,
                     CVT_ATOM | CVT_STRING | CVT_WRITEQ | BUF_MALLOC |
                         REP_UTF8)) {
    v->text = NULL;
    PL_clear_exception();
  }
  PL_discard_foreign_frame(frame);
  return v->text;
}
