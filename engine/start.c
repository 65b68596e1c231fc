/* start.c -- Prolog with the rules that are in this library, once a process. */
#include "start.h"

#include "install.h"

#include <SWI-Prolog.h>
#include <SWI-Stream.h>

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

extern const unsigned char sg_core[], sg_core_end[];
extern const unsigned char sg_rules[], sg_rules_end[];

/* Glue makes atoms, so it is installed when Prolog has a heap and no rule is
 * loaded yet. */
static void
install_glue(int argc, char **argv)
{
  (void)argc;
  (void)argv;
  install_sanggwan();
}

/* Prolog loads compiled code from a stream, here of the library's bytes. */
static bool
load_core(void)
{
  fid_t frame = PL_open_foreign_frame();
  term_t t = frame ? PL_new_term_refs(3) : 0;
  IOSTREAM *in =
      Sopen_string(NULL, (char *)sg_core, (size_t)(sg_core_end - sg_core), "r");
  bool loaded = false;

  if (t && in && PL_unify_stream(t + 2, in)) {
    Ssetenc(in, ENC_OCTET, NULL);
    loaded = PL_unify_term(t, PL_FUNCTOR_CHARS, ":", 2, PL_CHARS, "user",
                           PL_TERM, t + 2) &&
             PL_call_predicate(NULL, PL_Q_NORMAL,
                               PL_predicate("$qlf_load", 2, "system"), t);
  }
  if (in) {
    Sclose(in);
  }
  if (frame) {
    PL_discard_foreign_frame(frame);
  }
  return loaded;
}

bool
sg_start(int argc, char **argv)
{
  PL_initialise_hook(install_glue);
  return PL_initialise(argc, argv) && load_core();
}

/* ---- inside a Prolog that runs ------------------------------------------ */

enum { NAME_BYTES = 4096 };

/* True if the goal, text in Prolog's syntax, succeeds. */
static bool
holds(const char *goal)
{
  fid_t frame = PL_open_foreign_frame();
  term_t t;
  bool yes;

  if (!frame) {
    return false;
  }
  t = PL_new_term_ref();
  yes = t && PL_chars_to_term(goal, t) &&
        PL_call_predicate(NULL, PL_Q_CATCH_EXCEPTION,
                          PL_predicate("call", 1, "user"), t);
  PL_discard_foreign_frame(frame);
  return yes;
}

/* Calls system:load_files(user:Name, [silent(true)]). */
static bool
load_compiled(const char *name)
{
  fid_t frame = PL_open_foreign_frame();
  term_t t = PL_new_term_refs(2);
  bool loaded = frame && t &&
                PL_unify_term(t, PL_FUNCTOR_CHARS, ":", 2, PL_CHARS, "user",
                              PL_MBCHARS, name) &&
                PL_chars_to_term("[silent(true)]", t + 1) &&
                PL_call_predicate(NULL, PL_Q_CATCH_EXCEPTION,
                                  PL_predicate("load_files", 2, "system"), t);

  if (frame) {
    PL_discard_foreign_frame(frame);
  }
  return loaded;
}

static bool
write_all(int file, const unsigned char *bytes, size_t n)
{
  while (n > 0) {
    ssize_t done = write(file, bytes, n);
    if (done <= 0) {
      return false;
    }
    bytes += done;
    n -= (size_t)done;
  }
  return true;
}

/* Prolog loads compiled rules from files only, so they become one. */
static bool
load_rules(void)
{
  static const char ending[] = ".qlf";
  const char *folder = getenv("TMPDIR");
  char name[NAME_BYTES];
  bool loaded;
  int file;

  if (!folder || !*folder) {
    folder = "/tmp";
  }
  if (snprintf(name, sizeof(name), "%s/sanggwan_XXXXXX%s", folder, ending) >=
          NAME_BYTES ||
      (file = mkstemps(name, sizeof(ending) - 1)) < 0) {
    return false;
  }
  loaded = write_all(file, sg_rules, (size_t)(sg_rules_end - sg_rules));
  loaded = close(file) == 0 && loaded && load_compiled(name);
  unlink(name);
  return loaded;
}

bool
sg_start_inside(void)
{
  static const char loaded[] = "current_predicate(sg_embedding:embedded/5)";
  static const char glued[] = "predicate_property(sg_store:v(_,_,_,_,_),"
                              "foreign)";

  if (holds(loaded)) {
    return true;
  }
  if (!holds(glued)) {
    install_sanggwan();
  }
  return load_rules() && holds(loaded);
}
