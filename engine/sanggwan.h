/* sanggwan.h -- Sanggwan in a C or C++ program: load a model, ask questions.
 *
 *   #include <sanggwan.h>
 *
 *   if (sanggwan_start() == SANGGWAN_DONE) {
 *     sanggwan_world *world = sanggwan_open();
 *     sanggwan_load(world, "two_cubes.pl");
 *     sanggwan_run(world, "penetrate");
 *     sanggwan_query *q = sanggwan_ask(world, "v(1, V, X, _, _), X > 0.5");
 *     while (sanggwan_next(q) == SANGGWAN_DONE) {
 *       int64_t vertex;
 *       double x;
 *       sanggwan_int(q, sanggwan_column(q, "V"), &vertex);
 *       sanggwan_double(q, sanggwan_column(q, "X"), &x);
 *     }
 *     sanggwan_query_close(q);
 *     sanggwan_close(world);
 *   }
 *
 *   cc program.c $(pkg-config --cflags --libs sanggwan)
 *
 * docs/example.c is a complete program.
 *
 * Everything that can be asked is a Prolog goal, given as text: the relations
 * (v/5, e/5, p/3, t/6, segment/3, line/9, origin/3, ...), the operations
 * (penetrate, draw/2, ...) and all of Prolog. `sanggwan repl` and then `help.`
 * lists them.
 *
 * STATUS. A function that can fail gives a sanggwan_status: the exit statuses
 * of the program. After one that is not SANGGWAN_DONE, sanggwan_message() says
 * what was wrong. No function prints anything or ends the process (a goal may,
 * when it is told to write or to halt/0). A null world or query is allowed
 * everywhere and is SANGGWAN_USAGE.
 *
 * LIMITS. A text that is too long or too deep is refused before anything of it
 * runs (docs/model_files.md). A goal that runs has the limits of Prolog alone:
 * in each thread its stacks hold 1 GB, after which it is SANGGWAN_IMPOSSIBLE,
 * and it takes what time it takes. For goals of others give less, by goals of
 * yours: "set_prolog_flag(stack_limit, 50000000)", octets, holds for the
 * calling thread from then on; "call_with_time_limit(2.5, (GOAL))", seconds,
 * ends in SANGGWAN_USAGE.
 *
 * TEXT is UTF-8 and ends with a zero byte, both ways; names of files are as the
 * system's.
 *
 * OWNERSHIP. What _open, _share and _ask return is yours until you close it.
 * Every `const char *` belongs to the world or query it came from; how long it
 * stays is said with each function. Nothing is to be freed with free().
 *
 * THREADS. The thread that calls sanggwan_start() may call everything; another
 * thread first calls sanggwan_attach() and, before it ends, sanggwan_detach().
 * Different worlds may be used in different threads at the same time. One
 * sanggwan_world, with its queries, belongs to one thread at a time: to use the
 * facts of one world in two threads, give the other thread its own handle with
 * sanggwan_share(). Changes to one world wait for one another; a transaction of
 * one thread is not seen by others before it is done.
 *
 * SIGNALS belong to you: where sanggwan_start() starts Prolog, Prolog handles
 * none, and leaves the terminal alone.
 *
 * LOCALE. Starting Prolog sets LC_CTYPE, which says how names of files are
 * written, from the environment; the rest of the locale stays as it is.
 *
 * UNITS. Coordinates are model units, right-handed; angles degrees; the size of
 * a drawing millimetres. Ids are positive and fit in 32 bits.
 */
#ifndef SANGGWAN_H
#define SANGGWAN_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sanggwan_status {
  SANGGWAN_DONE = 0,
  SANGGWAN_NO = 1,    /* the answer is no: a goal failed, no more answers */
  SANGGWAN_USAGE = 2, /* wrong call, bad goal, an error of a program */
  SANGGWAN_INPUT = 3, /* a file is unreadable or invalid */
  SANGGWAN_IMPOSSIBLE = 4, /* the geometry, or the memory, does not allow it */
  SANGGWAN_INTERRUPTED = 130
} sanggwan_status;

typedef struct sanggwan_world sanggwan_world; /* a handle on a world of facts */
typedef struct sanggwan_query sanggwan_query; /* a question being answered */

/* ---- the process and its threads --------------------------------------- */

/* Starts Prolog with the rules that are in this library. If Prolog already runs
 * in the process, the rules are loaded into it (about 0.1 s) and nothing else
 * of it changes; the calling thread must be one of Prolog's. Starting twice is
 * allowed and does nothing; Prolog stays to the end of the process.
 * SANGGWAN_IMPOSSIBLE: it could not start; sanggwan_message(NULL) says why. */
sanggwan_status sanggwan_start(void);

/* Makes the calling thread one that may use the library, and undoes that: the
 * worlds it opened stay. Attaching a thread twice does nothing. */
sanggwan_status sanggwan_attach(void);
void sanggwan_detach(void);

/* ---- worlds ------------------------------------------------------------ */

/* A new, empty world. Null: no memory, not started, or a thread that is not
 * attached; sanggwan_message(NULL) says which. */
sanggwan_world *sanggwan_open(void);

/* Another handle on the same world, for another thread; null as above. */
sanggwan_world *sanggwan_share(const sanggwan_world *world);

/* Closes a handle and the queries that are still open on it. The facts go with
 * the last handle. Null is allowed. */
void sanggwan_close(sanggwan_world *world);

/* What was wrong with the last call that took this world, or one of its
 * queries, and was not SANGGWAN_DONE: one or several lines, without a newline
 * at the end; with the file and line where that is known; "" if there was
 * nothing (a goal that failed). In English or Korean, as LANG says, or as the
 * message_language of a Prolog that already ran. Stays until the next call with
 * this world. For null: the same for the calling thread's last call without a
 * world; stays for ever. */
const char *sanggwan_message(const sanggwan_world *world);

/* The warnings of the last call (a polygon that is not flat, ...), one a line;
 * "" if there were none. Stays as above. */
const char *sanggwan_warnings(const sanggwan_world *world);

/* For programs that call Prolog themselves: this world is now the one that
 * foreign and Prolog code of the calling thread sees. The functions of this
 * header need no such thing, and put back what they find. */
sanggwan_status sanggwan_enter(sanggwan_world *world);

/* ---- files ------------------------------------------------------------- */

/* Adds a model file to the world, as more segments: .pl facts, .stl, .off, .obj
 * or .ply. All of it or, on any error, nothing. A model file is data: a rule or
 * directive in it is refused and never run.
 * SANGGWAN_INPUT: the file is missing, malformed, or describes no model. */
sanggwan_status sanggwan_load(sanggwan_world *world, const char *file);

/* Makes this world follow a file of rules: decisions as `sanggwan repl`, goal
 * `rules.`, lists them. Rules are programs and run as your process: trusted
 * files only. On an error nothing has changed. */
sanggwan_status sanggwan_use_rules(sanggwan_world *world, const char *file);

/* Writes the facts (.pl) or the polygons (.stl .off .obj .ply) of the world.
 * The file appears when it is complete, or not at all. */
sanggwan_status sanggwan_save(sanggwan_world *world, const char *file);

/* Draws the world, hidden lines and all; the segments cut each other first. The
 * ending of the file is the format: .svg, .png, .dxf, .hpgl, .json. `options`
 * is a list of Prolog terms without its brackets, or null:
 *
 *   "view(iso), hidden(removed), size(120x90)"   or   "view(30, 60)"
 *
 * as `draw/2` describes them. */
sanggwan_status sanggwan_draw(sanggwan_world *world, const char *file,
                              const char *options);

/* ---- goals ------------------------------------------------------------- */

/* Runs a goal once, for what it does. SANGGWAN_NO: it failed. Each operation
 * in it is all or nothing; to make several so, "facts_transaction((A, B))". */
sanggwan_status sanggwan_run(sanggwan_world *world, const char *goal);

/* Begins a question: a goal whose variables are the columns of the answers, in
 * the order in which the text first has them; those whose name begins with _
 * are no columns. Null: the text is no goal, or no memory; sanggwan_message()
 * says why. No answer has been looked for yet. Any number of questions may be
 * open at a time, and may be asked for their next answers in any order. */
sanggwan_query *sanggwan_ask(sanggwan_world *world, const char *goal);

/* Looks for the next answer. SANGGWAN_DONE: there is one, read its columns.
 * SANGGWAN_NO: there are no more. Anything else: the question ended with an
 * error; further calls are SANGGWAN_NO. Facts that change while a question is
 * open do not concern the parts of it that are under way. */
sanggwan_status sanggwan_next(sanggwan_query *query);

/* Ends a question, answered to the end or not. Null is allowed. Not after its
 * world was closed: that has closed it. */
void sanggwan_query_close(sanggwan_query *query);

/* ---- columns of an answer ---------------------------------------------- */

/* How many columns there are; their names (null: no such column), which stay
 * until the query is closed; the column of a name, -1: there is none. Columns
 * count from 0. */
int sanggwan_columns(const sanggwan_query *query);
const char *sanggwan_column_name(const sanggwan_query *query, int column);
int sanggwan_column(const sanggwan_query *query, const char *name);

/* The value in a column as an integer: false, and *out unchanged, if it is no
 * integer of 64 bits, or there is no such column or no answer. */
bool sanggwan_int(const sanggwan_query *query, int column, int64_t *out);

/* As a double: of any number, the nearest; otherwise false. */
bool sanggwan_double(const sanggwan_query *query, int column, double *out);

/* As text: an atom or string as it is, every other term as Prolog writes it so
 * that it reads back ("0.5", "[1,2,3]", "lpi(1-(1-2),2-7)"). Stays until the
 * next answer is looked for. Null: no such column, no answer, no memory, or a
 * term in itself, or one so deep that the stack of this thread could not hold
 * what writes it: 100 levels are always written, else 2 kB are needed for
 * each. */
const char *sanggwan_text(sanggwan_query *query, int column);

#ifdef __cplusplus
}
#endif

#endif
