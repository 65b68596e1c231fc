/* main.c -- the command line: the only file that knows every layer.
 *
 * Layer: engine. Thin: everything that a verb does is a rule (rules/cli.pl);
 * here Prolog is started on the saved rules and its answer becomes the exit
 * status (DESIGN 6).
 */
#include "start.h"

#include <SWI-Prolog.h>

#include <stdio.h>
#include <stdlib.h>

enum { PROLOG_WORDS = 5, CANNOT_START = 4 };

/* argv with the options that make Prolog leave our words alone. */
static char **
prolog_arguments(int argc, char **argv)
{
  static char quiet[] = "-q", file[] = "-f", none[] = "none", end[] = "--";
  char **out = malloc(sizeof *out * (size_t)(argc + PROLOG_WORDS));

  if (out) {
    char **to = out;
    *to++ = argv[0];
    *to++ = quiet;
    *to++ = file;
    *to++ = none;
    *to++ = end;
    for (int i = 1; i < argc; i++) {
      *to++ = argv[i];
    }
    *to = NULL;
  }
  return out;
}

/* sg_cli:main/1 gives the exit status; it reports its own errors. */
static int
run_cli(void)
{
  predicate_t main_1 = PL_predicate("main", 1, "sg_cli");
  term_t status = PL_new_term_ref();
  int code = CANNOT_START;

  if (!PL_call_predicate(NULL, PL_Q_NORMAL, main_1, status) ||
      !PL_get_integer(status, &code)) {
    code = CANNOT_START;
  }
  return code;
}

int
main(int argc, char **argv)
{
  char **arguments = prolog_arguments(argc, argv);

  if (!arguments || !sg_start(argc + PROLOG_WORDS - 1, arguments)) {
    fprintf(stderr, "sanggwan: cannot start SWI-Prolog\n");
    return CANNOT_START;
  }
  PL_halt(run_cli());
}
