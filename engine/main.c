/* main.c -- the command line: the only file that knows every layer.
 *
 * Layer: engine. Thin: everything that a verb does is a rule
 * (rules/command/cli.pl); here Prolog is started on the saved rules and its
 * answer becomes the exit status.
 */
#include "signals.h"
#include "start.h"

#include <SWI-Prolog.h>

#include <langinfo.h>
#include <locale.h>
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PROLOG_WORDS = 5, WRONG_USAGE = 2, MOST_SHOWN = 200, CANNOT_START = 4 };
enum { FROM_SYSTEM = 16 << 20, KEPT_FREE = 256 << 20 };

/* Kernels take and free arrays of megabytes one after another. Pages that went
 * back to the system between two of them would be cleared again for the next:
 * arrays below FROM_SYSTEM bytes are taken from what was freed, of which up to
 * KEPT_FREE bytes are kept. (Elsewhere than in glibc: as it is there.) */
static void
keep_freed_memory(void)
{
#ifdef M_MMAP_THRESHOLD
  mallopt(M_MMAP_THRESHOLD, FROM_SYSTEM);
  mallopt(M_TRIM_THRESHOLD, KEPT_FREE);
#endif
}

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

/* The environment's locale has ASCII alone: it is C, or not installed. */
static bool
locale_is_ascii(void)
{
  return !setlocale(LC_CTYPE, "") ||
         strcmp(nl_langinfo(CODESET), "ANSI_X3.4-1968") == 0;
}

/* A word that is no text in the locale's letters, or NULL. */
static const char *
unreadable_word(char **words)
{
  while (*words && mbstowcs(NULL, *words, 0) != (size_t)-1) {
    words++;
  }
  return *words;
}

/* Says so and ends. What is no ASCII that is seen may be anything: a ?. */
static _Noreturn void
refuse_word(const char *word)
{
  fputs("sanggwan: this is no text in UTF-8: ", stderr);
  for (int i = 0; i < MOST_SHOWN && word[i]; i++) {
    fputc(word[i] >= ' ' && word[i] <= '~' ? word[i] : '?', stderr);
  }
  fputs(strlen(word) > MOST_SHOWN ? "...\n" : "\n", stderr);
  exit(WRONG_USAGE);
}

/* As sg_start. Prolog reads words and file names in the letters of the locale
 * and dies of others, so where those are ASCII alone they are UTF-8 here. The
 * environment is as before afterwards: it also says the language. */
static bool
start(int argc, char **argv)
{
  const char *locale = getenv("LC_ALL");
  char *old = locale ? strdup(locale) : NULL;
  bool changed = locale_is_ascii() && setenv("LC_ALL", "C.UTF-8", 1) == 0;
  const char *word;
  bool started;

  setlocale(LC_CTYPE, "");
  word = unreadable_word(argv);
  if (word) {
    refuse_word(word);
  }
  started = sg_start(argc, argv);
  if (changed && old) {
    setenv("LC_ALL", old, 1);
  } else if (changed) {
    unsetenv("LC_ALL");
  }
  free(old);
  return started;
}

/* From now on signals end the program. What is said then is in the user's
 * language, and what they do depends on the verb. */
static bool
start_signals(void)
{
  predicate_t words_2 = PL_predicate("interrupted_words", 2, "sg_cli");
  term_t text_verb = PL_new_term_refs(2);
  char *text, *verb;

  if (!PL_call_predicate(NULL, PL_Q_NORMAL, words_2, text_verb) ||
      !PL_get_nchars(text_verb, NULL, &text,
                     CVT_STRING | REP_UTF8 | BUF_MALLOC) ||
      !PL_get_atom_chars(text_verb + 1, &verb)) {
    return sg_signals_start("", SG_SIGNALS_OF_VERB);
  }
  return sg_signals_start(text, strcmp(verb, "repl") == 0 ? SG_SIGNALS_OF_REPL
                                : strcmp(verb, "batch") == 0
                                    ? SG_SIGNALS_OF_BATCH
                                    : SG_SIGNALS_OF_VERB);
}

/* sg_cli:main/1 gives the exit status; it reports its own errors. Only a signal
 * that comes when it is done makes an exception. */
static int
run_cli(void)
{
  predicate_t main_1 = PL_predicate("main", 1, "sg_cli");
  term_t status = PL_new_term_ref();
  int code = CANNOT_START;
  bool done = PL_call_predicate(NULL, PL_Q_CATCH_EXCEPTION, main_1, status) &&
              PL_get_integer(status, &code);

  code = sg_signals_end(code, done);
  if (!done && code == CANNOT_START) {
    fprintf(stderr, "sanggwan: the command ended without a status\n");
  }
  return code;
}

int
main(int argc, char **argv)
{
  char **arguments = prolog_arguments(argc, argv);

  keep_freed_memory();
  sg_signals_note();
  if (!arguments || !start(argc + PROLOG_WORDS - 1, arguments) ||
      !start_signals()) {
    fprintf(stderr, "sanggwan: cannot start SWI-Prolog\n");
    return CANNOT_START;
  }
  PL_halt(run_cli());
}
