/* inside_test.c -- sanggwan.h in a host that runs a Prolog of its own. */
#include "../check.h"

#include "sanggwan.h"

#include <SWI-Prolog.h>

#include <pthread.h>
#include <string.h>
#include <unistd.h>

static int
holds(const char *goal)
{
  fid_t frame = PL_open_foreign_frame();
  term_t t = PL_new_term_ref();
  int yes = PL_chars_to_term(goal, t) &&
            PL_call_predicate(NULL, PL_Q_CATCH_EXCEPTION,
                              PL_predicate("call", 1, "user"), t);

  PL_discard_foreign_frame(frame);
  return yes;
}

static void *
start_unattached(void *status)
{
  *(sanggwan_status *)status = sanggwan_start();
  return NULL;
}

static void
test_start(void)
{
  pthread_t thread;
  sanggwan_status status = SANGGWAN_DONE;

  pthread_create(&thread, NULL, start_unattached, &status);
  pthread_join(thread, NULL);
  CHECK("a thread that is not Prolog's cannot start it",
        status == SANGGWAN_USAGE);
  CHECK("the thread of Prolog can", sanggwan_start() == SANGGWAN_DONE);
  CHECK("twice", sanggwan_start() == SANGGWAN_DONE);
  CHECK("the host's facts are as they were", holds("mine(1)"));
  CHECK("the host's names are its own",
        !holds("predicate_property(user:v(_,_,_,_,_), imported_from(_))"));
}

/* Lines of the two cubes with the decision may_cut/2 replaced or not. */
static void
test_model(const char *model)
{
  sanggwan_world *world = sanggwan_open();
  sanggwan_query *q;
  int64_t pieces = 0;

  CHECK("a model is loaded", sanggwan_load(world, model) == SANGGWAN_DONE);
  CHECK("and penetrates", sanggwan_run(world, "penetrate") == SANGGWAN_DONE);
  q = sanggwan_ask(world, "aggregate_all(count, line(_,_,_,_,_,_,_,_,_), N), "
                          "mine(M)");
  CHECK("questions see the host's predicates",
        sanggwan_next(q) == SANGGWAN_DONE);
  CHECK("the answer", sanggwan_int(q, 0, &pieces) && pieces == 6);
  sanggwan_query_close(q);
  CHECK("errors are told", sanggwan_run(world, "nope(1)") == SANGGWAN_USAGE &&
                               strstr(sanggwan_message(world), "nope/1"));
  CHECK("a bad model is told with its line",
        sanggwan_load(world, "Makefile.pl") == SANGGWAN_INPUT &&
            strstr(sanggwan_message(world), "Makefile.pl"));
  sanggwan_close(world);
}

static void
test_rules(const char *model)
{
  char path[] = "/tmp/sanggwan_rules_XXXXXX";
  static const char text[] = "may_cut(_, _) :- fail.\n";
  int file = mkstemp(path);
  sanggwan_world *world = sanggwan_open();

  CHECK("a rule file", file >= 0 && write(file, text, sizeof(text) - 1) > 0);
  close(file);
  CHECK("is followed", sanggwan_use_rules(world, path) == SANGGWAN_DONE);
  sanggwan_load(world, model);
  CHECK("nothing is cut",
        sanggwan_run(world, "penetrate, \\+ line(_,_,_,_,_,_,_,_,_)") ==
            SANGGWAN_DONE);
  sanggwan_close(world);
  unlink(path);
}

int
main(void)
{
  char model[4096];
  char name[] = "host", quiet[] = "-q", file[] = "-f", none[] = "none";
  char *arguments[] = {name, quiet, file, none, NULL};

  if (!getcwd(model, sizeof(model) - 64) || !PL_initialise(4, arguments)) {
    return 1;
  }
  strcat(model, "/facts/two_cubes.pl");
  CHECK("the host's own fact", holds("assertz(mine(1))"));
  CHECK("away from the source tree", chdir("/") == 0);
  test_start();
  test_model(model);
  test_rules(model);
  CHECK("the host goes on", holds("mine(1)"));
  return check_report();
}
