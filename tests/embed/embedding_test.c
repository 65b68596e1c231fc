/* embedding_test.c -- sanggwan.h where the library starts Prolog: worlds,
 * questions, errors, threads, signals. Run in the project's root. */
#include "../check.h"

#include "sanggwan.h"

#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool
says(const sanggwan_world *world, const char *part)
{
  bool found = strstr(sanggwan_message(world), part) != NULL;

  if (!found) {
    fprintf(stderr, "the message is: %s\n", sanggwan_message(world));
  }
  return found;
}

static bool
text_is(sanggwan_query *q, const char *column, const char *text)
{
  const char *is = sanggwan_text(q, sanggwan_column(q, column));

  return is && strcmp(is, text) == 0;
}

/* The number of answers; -1: it ended with an error. */
static int
answers(sanggwan_world *world, const char *goal)
{
  sanggwan_query *q = sanggwan_ask(world, goal);
  sanggwan_status status;
  int n = 0;

  while ((status = sanggwan_next(q)) == SANGGWAN_DONE) {
    n++;
  }
  sanggwan_query_close(q);
  return status == SANGGWAN_NO ? n : -1;
}

/* ---- before it starts, and starting ------------------------------------ */

static void
test_not_started(void)
{
  CHECK("no world before the start", sanggwan_open() == NULL);
  CHECK("and it says why", says(NULL, "sanggwan_start"));
  CHECK("no attaching either", sanggwan_attach() == SANGGWAN_USAGE);
  CHECK("null is usage",
        sanggwan_load(NULL, "facts/cube.pl") == SANGGWAN_USAGE);
}

static void
own_handler(int number)
{
  (void)number;
}

static void
test_start(void)
{
  static const int signals[] = {SIGINT, SIGTERM, SIGUSR2, SIGCHLD, SIGPIPE};
  enum { N = sizeof(signals) / sizeof(*signals) };
  struct sigaction before[N], now; /* who started us may ignore some */
  bool same = true;

  signal(SIGINT, own_handler);
  for (size_t i = 0; i < N; i++) {
    sigaction(signals[i], NULL, &before[i]);
  }
  CHECK("it starts", sanggwan_start() == SANGGWAN_DONE);
  CHECK("twice is allowed", sanggwan_start() == SANGGWAN_DONE);
  for (size_t i = 0; i < N; i++) {
    sigaction(signals[i], NULL, &now);
    same = same && now.sa_handler == before[i].sa_handler;
  }
  CHECK("signals are the host's", same);
  CHECK("numbers are written as before",
        strcmp(setlocale(LC_NUMERIC, NULL), "C") == 0);
  CHECK("attaching the first thread is nothing",
        sanggwan_attach() == SANGGWAN_DONE);
}

/* ---- questions --------------------------------------------------------- */

static void
test_columns(void)
{
  sanggwan_world *world = sanggwan_open();
  sanggwan_query *q =
      sanggwan_ask(world, "I = 7, F = 0.5, A = 'a b', S = \"s\\u00e9\", "
                          "L = [1,x,'Y'], B is 2**70, R is 1r4, _Hidden = 1");
  int64_t i = -1;
  double f = -1.0;

  CHECK("variables are columns, hidden ones not", sanggwan_columns(q) == 7);
  CHECK("their names", strcmp(sanggwan_column_name(q, 6), "R") == 0);
  CHECK("no such column", sanggwan_column(q, "_Hidden") == -1 &&
                              !sanggwan_column_name(q, 7) &&
                              !sanggwan_column_name(q, -1));
  CHECK("no value before the first answer",
        !sanggwan_int(q, 0, &i) && !sanggwan_text(q, 0));
  CHECK("an answer", sanggwan_next(q) == SANGGWAN_DONE);
  CHECK("an integer", sanggwan_int(q, 0, &i) && i == 7);
  CHECK("as a double", sanggwan_double(q, 0, &f) && f == 7.0);
  CHECK("as text", text_is(q, "I", "7"));
  CHECK("a double is no integer", !sanggwan_int(q, 1, &i) && i == 7);
  CHECK("a double", sanggwan_double(q, 1, &f) && f == 0.5);
  CHECK("text of a double", text_is(q, "F", "0.5"));
  CHECK("an atom is plain text", text_is(q, "A", "a b"));
  CHECK("an atom is no number",
        !sanggwan_double(q, sanggwan_column(q, "A"), &f));
  CHECK("a string is UTF-8", text_is(q, "S", "s\xc3\xa9"));
  CHECK("a term reads back", text_is(q, "L", "[1,x,'Y']"));
  CHECK("the same text again", text_is(q, "L", "[1,x,'Y']"));
  CHECK("a large integer is text", text_is(q, "B", "1180591620717411303424"));
  CHECK("and a double, but no int64",
        sanggwan_double(q, sanggwan_column(q, "B"), &f) &&
            f == ldexp(1.0, 70) &&
            !sanggwan_int(q, sanggwan_column(q, "B"), &i));
  CHECK("a rational", sanggwan_double(q, sanggwan_column(q, "R"), &f) &&
                          f == 0.25 && text_is(q, "R", "1r4"));
  CHECK("no more", sanggwan_next(q) == SANGGWAN_NO);
  CHECK("and no values", !sanggwan_text(q, 0) && !sanggwan_double(q, 0, &f));
  CHECK("still no more", sanggwan_next(q) == SANGGWAN_NO);
  sanggwan_query_close(q);
  sanggwan_close(world);
}

static void
test_interleaved(void)
{
  sanggwan_world *world = sanggwan_open();
  sanggwan_query *a, *b;
  int64_t x = 0, y = 0;

  CHECK("a model", sanggwan_load(world, "facts/cube.pl") == SANGGWAN_DONE);
  a = sanggwan_ask(world, "v(1, V, _, _, _)");
  b = sanggwan_ask(world, "e(1, E, _, _, _)");
  for (int n = 0; n < 3; n++) {
    sanggwan_next(a);
    sanggwan_next(b);
    sanggwan_next(b);
  }
  CHECK("two questions go on side by side",
        sanggwan_int(a, 0, &x) && sanggwan_int(b, 0, &y) && x == 3 && y == 6);
  CHECK("a question keeps what it sees",
        sanggwan_run(world,
                     "facts_transaction(retractall_facts(v(1,_,_,_,_)),"
                     "                  [cascade(true)])") == SANGGWAN_DONE &&
            sanggwan_next(a) == SANGGWAN_DONE);
  sanggwan_query_close(a);
  CHECK("the other one goes on", sanggwan_next(b) == SANGGWAN_DONE);
  sanggwan_close(world); /* closes b */
  CHECK("a ground question has one answer and no columns",
        (world = sanggwan_open()) && answers(world, "true") == 1 &&
            answers(world, "fail") == 0);
  sanggwan_close(world);
}

/* ---- errors ------------------------------------------------------------ */

static void
test_bad_goals(void)
{
  sanggwan_world *world = sanggwan_open();
  sanggwan_query *q;

  CHECK("a goal that fails", sanggwan_run(world, "fail") == SANGGWAN_NO);
  CHECK("says nothing", *sanggwan_message(world) == '\0');
  CHECK("bad syntax", sanggwan_run(world, "v(1,") == SANGGWAN_USAGE);
  CHECK("is told", says(world, "v(1,"));
  CHECK("no goal", sanggwan_run(world, "17") == SANGGWAN_USAGE);
  CHECK("null", sanggwan_run(world, NULL) == SANGGWAN_USAGE);
  CHECK("an unknown predicate",
        sanggwan_run(world, "no_such(1)") == SANGGWAN_USAGE);
  CHECK("is named", says(world, "no_such/1"));
  CHECK("an exception that is no error",
        sanggwan_run(world, "throw(ball(1))") == SANGGWAN_USAGE &&
            says(world, "ball(1)"));
  CHECK("an abort is an interrupt",
        sanggwan_run(world, "throw('$aborted')") == SANGGWAN_INTERRUPTED);
  CHECK("and so is one in a question", answers(world, "abort") == -1);
  CHECK("deep recursion ends with the stack",
        sanggwan_run(world, "length(L, 100000000), sum_list(L, _)") ==
            SANGGWAN_IMPOSSIBLE);
  CHECK("stacks may be small",
        sanggwan_run(world, "current_prolog_flag(stack_limit, N), "
                            "nb_setval(usual_stacks, N), "
                            "set_prolog_flag(stack_limit, 50000000)") ==
            SANGGWAN_DONE);
  q = sanggwan_ask(world, "numlist(1, 1000000000000000000000, L)");
  CHECK("a question ends with them",
        sanggwan_next(q) == SANGGWAN_IMPOSSIBLE && says(world, "stacks"));
  sanggwan_query_close(q);
  CHECK("and may be large again",
        sanggwan_run(world,
                     "nb_getval(usual_stacks, N), "
                     "set_prolog_flag(stack_limit, N)") == SANGGWAN_DONE);
  CHECK("a goal ends with its time",
        sanggwan_run(world, "call_with_time_limit(0.1, (repeat, fail))") ==
                SANGGWAN_USAGE &&
            says(world, "ime"));
  CHECK("a good goal clears the message",
        sanggwan_run(world, "true") == SANGGWAN_DONE &&
            *sanggwan_message(world) == '\0');
  CHECK("a bad question is none", sanggwan_ask(world, "v(") == NULL);
  CHECK("with a message", *sanggwan_message(world) != '\0');
  q = sanggwan_ask(world, "member(X, [2,1,0]), Y is 2 rdiv X");
  CHECK("an error in the third answer", sanggwan_next(q) == SANGGWAN_DONE &&
                                            sanggwan_next(q) == SANGGWAN_DONE &&
                                            sanggwan_next(q) == SANGGWAN_USAGE);
  CHECK("is told", *sanggwan_message(world) != '\0');
  CHECK("and is the end", sanggwan_next(q) == SANGGWAN_NO);
  sanggwan_query_close(q);
  CHECK("null query", sanggwan_next(NULL) == SANGGWAN_USAGE &&
                          sanggwan_columns(NULL) == 0 &&
                          !sanggwan_text(NULL, 0));
  sanggwan_query_close(NULL);
  sanggwan_close(NULL);
  sanggwan_close(world);
}

static const char *
written(const char *folder, const char *name, const char *text)
{
  static char path[4096];
  FILE *file;

  snprintf(path, sizeof(path), "%s/%s", folder, name);
  if (text && (file = fopen(path, "w"))) {
    fputs(text, file);
    fclose(file);
  }
  return path;
}

static void
test_files(const char *folder)
{
  sanggwan_world *world = sanggwan_open();
  const char *path;

  CHECK("a missing model",
        sanggwan_load(world, "no/such.stl") == SANGGWAN_INPUT &&
            says(world, "no/such.stl"));
  CHECK("null is usage", sanggwan_load(world, NULL) == SANGGWAN_USAGE);
  path = written(folder, "rule.pl", "v(1, 1, 0, 0, 0).\n:- halt.\n");
  CHECK("a directive is refused",
        sanggwan_load(world, path) == SANGGWAN_INPUT && says(world, ":2:"));
  CHECK("and nothing is loaded", answers(world, "v(S, V, _, _, _)") == 0);
  path = written(folder, "warped.pl",
                 "v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,1,1,0.3). v(1,4,0,1,0).\n"
                 "p(1,1,[1,2,3,4]).\n");
  CHECK("a warning does not fail", sanggwan_load(world, path) == SANGGWAN_DONE);
  CHECK("but is kept", *sanggwan_warnings(world) != '\0');
  CHECK("for one call", sanggwan_run(world, "true") == SANGGWAN_DONE &&
                            *sanggwan_warnings(world) == '\0');
  sanggwan_close(world);

  world = sanggwan_open();
  CHECK("two cubes",
        sanggwan_load(world, "facts/two_cubes.pl") == SANGGWAN_DONE);
  path = written(folder, "cubes.svg", NULL);
  CHECK("drawn", sanggwan_draw(world, path, "view(iso), hidden(removed)") ==
                         SANGGWAN_DONE &&
                     access(path, R_OK) == 0);
  CHECK("with the penetration lines",
        answers(world, "line(L,_,_,_,_,_,_,_,_)") > 0);
  CHECK("again, without options",
        sanggwan_draw(world, path, NULL) == SANGGWAN_DONE);
  CHECK("options that are none",
        sanggwan_draw(world, path, "view(") == SANGGWAN_USAGE);
  CHECK("a view that is none",
        sanggwan_draw(world, path, "view(above)") == SANGGWAN_USAGE);
  CHECK("an ending that is none",
        sanggwan_draw(world, "cubes.doc", NULL) == SANGGWAN_USAGE);
  CHECK("a folder that is none",
        sanggwan_save(world, "/no/such/folder/cubes.stl") > SANGGWAN_NO);
  path = written(folder, "cubes.pl", NULL);
  CHECK("saved", sanggwan_save(world, path) == SANGGWAN_DONE);
  sanggwan_close(world);
  world = sanggwan_open();
  CHECK("and read again", sanggwan_load(world, path) == SANGGWAN_DONE &&
                              answers(world, "segment(S, _, _)") == 2);
  sanggwan_close(world);
}

/* ---- what is deep, in a thread with little of a stack -------------------- */

static const char *
deep_file(const char *name, const char *before, const char *open, size_t n,
          const char *close, const char *after)
{
  FILE *f = fopen(name, "w");

  fputs(before, f);
  for (size_t i = 0; i < n; i++) {
    fputs(open, f);
  }
  fputs("1", f);
  for (size_t i = 0; i < n; i++) {
    fputs(close, f);
  }
  fputs(after, f);
  fclose(f);
  return name;
}

static void *
small_thread(void *argument)
{
  static const char *const unit[][2] = {
      {"[", "]"}, {"f(", ")"}, {"{", "}"}, {"(", ")"}, {"- ", ""}};
  bool *good = argument;
  size_t deep[] = {100, 2000, 30000};
  sanggwan_attach();
  sanggwan_world *w = sanggwan_open();

  *good = w != NULL;
  for (size_t k = 0; k < sizeof unit / sizeof *unit; k++) {
    for (size_t d = 0; d < 3; d++) {
      const char *file = deep_file("build/tests/deep.pl", "segment(1, solid, ",
                                   unit[k][0], deep[d], unit[k][1], ").\n");
      *good &= sanggwan_load(w, file) == SANGGWAN_INPUT;
      *good &= strlen(sanggwan_message(w)) < 1000;
      *good &= deep[d] == 100 || strstr(sanggwan_message(w), "depth=N");
    }
  }
  const char *csg = deep_file("build/tests/deep.csg", "polyhedron(points=", "[",
                              20000, "]", ",faces=[]);\n");
  *good &= sanggwan_load(w, csg) == SANGGWAN_INPUT;
  const char *goal =
      deep_file("build/tests/deep.goal", "X = ", "f(", 2000, ")", "");
  char text[8000] = "";
  FILE *f = fopen(goal, "r");
  *good &= fread(text, 1, sizeof text - 1, f) > 2000;
  fclose(f);
  *good &= sanggwan_run(w, text) == SANGGWAN_USAGE;
  *good &= strstr(sanggwan_message(w), "depth=N") != NULL;
  *good &= sanggwan_load(w, "facts/cube.pl") == SANGGWAN_DONE;
  sanggwan_close(w);
  sanggwan_detach();
  return NULL;
}

static void
test_small_stacks(void)
{
  size_t size[] = {128, 256};

  for (size_t k = 0; k < 2; k++) {
    pthread_attr_t attributes;
    pthread_t thread;
    bool good = false;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, size[k] * 1024);
    pthread_create(&thread, &attributes, small_thread, &good);
    pthread_join(thread, NULL);
    pthread_attr_destroy(&attributes);
    CHECK("what is deep is refused in a small stack", good);
  }
}

/* ---- several worlds, several threads ----------------------------------- */

static void
test_two_worlds(const char *folder)
{
  sanggwan_world *a = sanggwan_open(), *b = sanggwan_open(), *c;
  const char *rules = written(folder, "apart.pl", "may_cut(_, _) :- fail.\n");

  sanggwan_load(a, "facts/two_cubes.pl");
  sanggwan_load(b, "facts/two_cubes.pl");
  CHECK("rules of one world", sanggwan_use_rules(b, rules) == SANGGWAN_DONE);
  CHECK("both penetrate", sanggwan_run(a, "penetrate") == SANGGWAN_DONE &&
                              sanggwan_run(b, "penetrate") == SANGGWAN_DONE);
  CHECK("rules are not the other world's",
        answers(a, "line(L,_,_,_,_,_,_,_,_)") == 6 &&
            answers(b, "line(L,_,_,_,_,_,_,_,_)") == 0);
  rules = written(folder, "wrong.pl", "may_kut(_, _) :- fail.\n");
  CHECK("rules that are none",
        sanggwan_use_rules(b, rules) == SANGGWAN_INPUT && says(b, "may_kut"));
  CHECK("facts of one world", sanggwan_run(a, "retractall_facts(line(_,_,_,_,_,"
                                              "_,_,_,_))") == SANGGWAN_DONE);
  c = sanggwan_share(a);
  CHECK("a second handle sees the same",
        answers(c, "v(S, V, _, _, _)") == answers(a, "v(S, V, _, _, _)"));
  CHECK("messages are the handle's",
        sanggwan_run(c, "nope") == SANGGWAN_USAGE &&
            *sanggwan_message(a) == '\0');
  sanggwan_close(a);
  CHECK("it outlives the first", answers(c, "segment(S, _, _)") == 2);
  sanggwan_close(c);
  sanggwan_close(b);
}

enum { THREADS = 4, ROUNDS = 20 };

static sanggwan_world *shared;

static void *
in_thread(void *argument)
{
  int *good = argument;
  sanggwan_world *own, *same;

  *good = sanggwan_open() == NULL && says(NULL, "sanggwan_attach") &&
          sanggwan_run(shared, "true") == SANGGWAN_USAGE;
  *good = *good && sanggwan_attach() == SANGGWAN_DONE;
  own = sanggwan_open();
  same = sanggwan_share(shared);
  for (int i = 0; i < ROUNDS && *good; i++) {
    *good = sanggwan_load(own, "facts/cube.pl") == SANGGWAN_DONE &&
            answers(own, "segment(S, _, _)") == i + 1 &&
            answers(own, "v(1, V, _, _, _)") == 8 &&
            answers(same, "segment(S, _, _)") >= 2 &&
            sanggwan_run(same, "fresh_id(segment, 0, S), "
                               "assert_fact(segment(S, solid, thread))") ==
                SANGGWAN_DONE;
  }
  sanggwan_close(same);
  sanggwan_close(own);
  sanggwan_detach();
  return NULL;
}

static void
test_threads(void)
{
  pthread_t thread[THREADS];
  int good[THREADS];
  bool all = true;

  shared = sanggwan_open();
  sanggwan_load(shared, "facts/two_cubes.pl");
  for (int i = 0; i < THREADS; i++) {
    pthread_create(&thread[i], NULL, in_thread, &good[i]);
  }
  for (int i = 0; i < THREADS; i++) {
    pthread_join(thread[i], NULL);
    all = all && good[i];
  }
  CHECK("threads have worlds of their own, and share one", all);
  CHECK("what they added is there",
        answers(shared, "segment(S, _, thread)") == THREADS * ROUNDS);
  sanggwan_close(shared);
}

/* No word that was left on a stack of Prolog keeps a closed world. */
enum { CLOSED = 100 };

static void
test_closing(void)
{
  sanggwan_world *world = sanggwan_open();
  const char *count = "aggregate_all(count, current_blob(_, sg_world), N)";
  int64_t before = 0, after = -1;
  sanggwan_query *q = sanggwan_ask(world, count);

  CHECK("worlds that there are",
        sanggwan_next(q) == SANGGWAN_DONE && sanggwan_int(q, 0, &before));
  sanggwan_query_close(q);
  for (int i = 0; i < CLOSED; i++) {
    sanggwan_world *other = sanggwan_open();
    sanggwan_query *left;
    sanggwan_load(other, "facts/cube.pl");
    left = sanggwan_ask(other, "v(S, V, _, _, _)");
    CHECK("a question on its way", sanggwan_next(left) == SANGGWAN_DONE);
    sanggwan_close(other);
  }
  q = sanggwan_ask(world, count);
  CHECK("closed worlds are gone at once, their questions too",
        sanggwan_next(q) == SANGGWAN_DONE && sanggwan_int(q, 0, &after) &&
            after == before);
  sanggwan_close(world);
}

/* Kilobytes in memory. */
static long
memory(void)
{
  FILE *file = fopen("/proc/self/statm", "r");
  long all = 0, resident = 0;

  if (file) {
    if (fscanf(file, "%ld %ld", &all, &resident) != 2) {
      resident = 0;
    }
    fclose(file);
  }
  return resident * sysconf(_SC_PAGESIZE) / 1024;
}

/* Kilobytes that n questions added. */
static long
growth(sanggwan_world *world, int n)
{
  long before = memory();

  for (int i = 0; i < n; i++) {
    answers(world, "member(X, [a, f(b), \"c\"])");
  }
  return memory() - before;
}

/* Prolog's collectors run beside us and may need room once; what is left
 * behind is left each time. */
static void
test_memory(void)
{
  sanggwan_world *world = sanggwan_open();
  long first, second;

  (void)growth(world, 1000);
  first = growth(world, 1500);
  second = growth(world, 1500);
  CHECK("questions leave nothing behind", first < 1024 || second < 1024);
  sanggwan_close(world);
}

static void
test_enter(void)
{
  sanggwan_world *a = sanggwan_open(), *b = sanggwan_open();

  CHECK("the current world may be chosen", sanggwan_enter(a) == SANGGWAN_DONE);
  CHECK("calls with another put it back",
        sanggwan_run(b, "current_world(W), nb_setval(b, W)") == SANGGWAN_DONE &&
            sanggwan_run(a, "current_world(W), nb_getval(b, B), W \\== B") ==
                SANGGWAN_DONE);
  sanggwan_close(a);
  sanggwan_close(b);
}

int
main(void)
{
  char folder[] = "/tmp/sanggwan_embedding_XXXXXX";
  char remove[sizeof(folder) + 16];

  if (!mkdtemp(folder)) {
    return 1;
  }
  test_not_started();
  test_start();
  test_columns();
  test_interleaved();
  test_bad_goals();
  test_files(folder);
  test_two_worlds(folder);
  test_small_stacks();
  test_threads();
  test_closing();
  test_memory();
  test_enter();
  snprintf(remove, sizeof(remove), "rm -rf %s", folder);
  return check_report() | (system(remove) != 0);
}
