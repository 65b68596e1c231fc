/* engine.c -- the public interface for C programs: sanggwan.h says it all.
 *
 * Layer: engine, beside main.c. It calls one rule, sg_embedding:embedded/5, and
 * turns what comes back into C values.
 */
#include "host.h"

#include "start.h"

#include <locale.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

/* ---- messages ---------------------------------------------------------- */

enum { KEPT = 5 }; /* kinds of locale */

static const char no_memory[] = "Prolog has no memory left";

static _Thread_local const char *world_less = "";

sanggwan_status
sg_host_refuse(sanggwan_status status, const char *why)
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

sanggwan_status
sg_host_complain(sanggwan_world *world, sanggwan_status status, const char *why)
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

/* Prolog's collection of atoms walks over the data of all threads. While a
 * thread of the host begins or ends, none that we start is under way. A hook at
 * the end of a thread may close a world: the lock is recursive. */
static pthread_mutex_t ends = PTHREAD_RECURSIVE_MUTEX_INITIALIZER_NP;

/* Messages and reports in the language of the environment. */
static bool
choose_language(void)
{
  return PL_call_predicate(
      NULL, PL_Q_CATCH_EXCEPTION,
      PL_predicate("language_of_environment", 0, "sg_language"), 0);
}

/* Threads of the host run the rules, so none is loaded later. */
static bool
load_rules(void)
{
  return PL_call_predicate(NULL, PL_Q_CATCH_EXCEPTION,
                           PL_predicate("whole_program", 0, "sg_part"), 0);
}

/* Starts Prolog, which takes the whole locale from the environment; of that
 * only the letters (LC_CTYPE) stay. */
static bool
start_keeping_locale(int argc, char **argv)
{
  static const int kind[KEPT] = {LC_NUMERIC, LC_TIME, LC_COLLATE, LC_MONETARY,
                                 LC_MESSAGES};
  char *old[KEPT];
  bool started;

  for (int i = 0; i < KEPT; i++) {
    const char *name = setlocale(kind[i], NULL);
    old[i] = name ? strdup(name) : NULL;
  }
  started = sg_start(argc, argv);
  for (int i = 0; i < KEPT; i++) {
    if (old[i]) {
      setlocale(kind[i], old[i]);
    }
    free(old[i]);
  }
  return started;
}

static sanggwan_status
start_prolog(void)
{
  static char name[] = "sanggwan", quiet[] = "-q", file[] = "-f",
              none[] = "none", no_signals[] = "--no-signals",
              no_alerts[] = "--sigalert=0", no_tty[] = "--no-tty", end[] = "--";
  static char *arguments[] = {name,      quiet,  file, none, no_signals,
                              no_alerts, no_tty, end,  NULL};

  if (!start_keeping_locale(sizeof(arguments) / sizeof(*arguments) - 1,
                            arguments) ||
      !load_rules() || !choose_language()) {
    return sg_host_refuse(SANGGWAN_IMPOSSIBLE, "SWI-Prolog cannot be started");
  }
  return SANGGWAN_DONE;
}

static sanggwan_status
join_prolog(void)
{
  if (PL_thread_self() < 0) {
    return sg_host_refuse(SANGGWAN_USAGE,
                          "Prolog runs, but not in this thread: attach "
                          "the thread first");
  }
  if (!sg_start_inside()) {
    return sg_host_refuse(
        SANGGWAN_IMPOSSIBLE,
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
    return sg_host_refuse(SANGGWAN_USAGE, "sanggwan_start() comes first");
  }
  if (PL_thread_self() < 0) {
    pthread_mutex_lock(&ends);
    int id = PL_thread_attach_engine(NULL);
    pthread_mutex_unlock(&ends);
    if (id < 0) {
      return sg_host_refuse(SANGGWAN_IMPOSSIBLE,
                            "this thread cannot be attached");
    }
  }
  return SANGGWAN_DONE;
}

void
sanggwan_detach(void)
{
  if (PL_is_initialised(NULL, NULL) && PL_thread_self() > 1) {
    pthread_mutex_lock(&ends);
    PL_thread_destroy_engine();
    pthread_mutex_unlock(&ends);
  }
}

const char *
sg_host_obstacle(void)
{
  if (!PL_is_initialised(NULL, NULL)) {
    return "sanggwan_start() comes first";
  }
  return PL_thread_self() < 0
             ? "this thread is not attached: sanggwan_attach() comes first"
             : NULL;
}

/* ---- asking the rules -------------------------------------------------- */

bool
sg_host_text(term_t t, unsigned flags, char **out)
{
  size_t n;
  char *text;
  int done;

  /* BUF_MALLOC would give what Prolog frees, too, of a term that is written in
   * more than 4 kB (SWI-Prolog 9.0). */
  PL_STRINGS_MARK();
  done = PL_get_nchars(t, &n, &text, flags | BUF_STACK | REP_UTF8);
  if (done) {
    *out = PL_malloc(n + 1);
    memcpy(*out, text, n + 1);
  }
  PL_STRINGS_RELEASE();
  return done;
}

void
sg_host_take_text(term_t t, char **to)
{
  PL_free(*to);
  if (!sg_host_text(t, CVT_ATOM | CVT_STRING, to)) {
    *to = NULL;
  }
}

/* What escaped from embedded/5, which catches all that can be caught. */
static sanggwan_status
escaped(sanggwan_world *world, term_t error)
{
  bool memory =
      error && PL_is_functor(error, PL_new_functor(PL_new_atom("error"), 2));

  return memory ? sg_host_complain(world, SANGGWAN_IMPOSSIBLE, no_memory)
                : sg_host_complain(world, SANGGWAN_INTERRUPTED, "interrupted");
}

sanggwan_status
sg_host_ask(sanggwan_world *world, term_t what)
{
  predicate_t embedded_5 = PL_predicate("embedded", 5, "sg_embedding");
  term_t args = PL_new_term_refs(5);
  int answer = SANGGWAN_IMPOSSIBLE;
  sanggwan_status status;
  qid_t query;

  if (!args || !PL_put_atom(args, world->handle) ||
      !PL_put_term(args + 1, what) ||
      !(query = PL_open_query(NULL, PL_Q_CATCH_EXCEPTION, embedded_5, args))) {
    return sg_host_complain(world, SANGGWAN_IMPOSSIBLE, no_memory);
  }
  if (PL_next_solution(query) && PL_get_integer(args + 2, &answer)) {
    status = (sanggwan_status)answer;
    sg_host_take_text(args + 3, &world->message);
    sg_host_take_text(args + 4, &world->warnings);
  } else {
    status = escaped(world, PL_exception(query));
  }
  PL_cut_query(query);
  return status;
}

fid_t
sg_host_enter(sanggwan_world *world, sanggwan_status *status)
{
  const char *why;
  fid_t frame = 0;

  if (!world) {
    *status = sg_host_refuse(SANGGWAN_USAGE, "no world");
  } else if ((why = sg_host_obstacle())) {
    *status = sg_host_complain(world, SANGGWAN_USAGE, why);
  } else if (!(frame = PL_open_foreign_frame())) {
    *status = sg_host_complain(world, SANGGWAN_IMPOSSIBLE, no_memory);
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
  fid_t frame = sg_host_enter(world, &status);
  term_t what;

  if (!frame) {
    return status;
  }
  what = PL_new_term_ref();
  if (what && put_request(what, name, kind, text1, text2)) {
    status = sg_host_ask(world, what);
  } else {
    PL_clear_exception();
    status = sg_host_complain(world, SANGGWAN_USAGE, "the text is not UTF-8");
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
    return sg_host_complain(world, SANGGWAN_USAGE,
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
    (void)sg_host_refuse(SANGGWAN_IMPOSSIBLE, "there is no memory");
  }
  return world;
}

sanggwan_world *
sanggwan_open(void)
{
  const char *why = sg_host_obstacle();

  if (why) {
    (void)sg_host_refuse(SANGGWAN_USAGE, why);
    return NULL;
  }
  return with_handle(new_world());
}

sanggwan_world *
sanggwan_share(const sanggwan_world *world)
{
  const char *why = world ? sg_host_obstacle() : "no world";

  if (why) {
    (void)sg_host_refuse(SANGGWAN_USAGE, why);
    return NULL;
  }
  PL_register_atom(world->handle);
  return with_handle(world->handle);
}

static void
call_system(const char *name)
{
  (void)PL_call_predicate(NULL, PL_Q_CATCH_EXCEPTION,
                          PL_predicate(name, 0, "system"), 0);
}

/* A world goes when Prolog collects its handle: at once, not some day, since
 * Prolog does not know how much memory is in it. A word that a call has left on
 * the stacks may still name it: they are tidied first. */
static void
collect_handles(void)
{
  if (!sg_host_obstacle()) {
    pthread_mutex_lock(&ends);
    call_system("garbage_collect");
    call_system("garbage_collect_atoms");
    pthread_mutex_unlock(&ends);
  }
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
  collect_handles();
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
