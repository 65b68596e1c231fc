/* stdio4pl.c -- the streams of a session (documented in kernel/file.pl).
 *
 * Layer: glue.
 */
#include "install.h"

#include <SWI-Stream.h>

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <string.h>
#include <sys/poll.h>
#include <unistd.h>

enum { FIRST_FREE = 3 };

static int
raise_errno(const char *what)
{
  term_t t = PL_new_term_ref();

  return t &&
         PL_unify_term(t, PL_FUNCTOR_CHARS, "error", 2, PL_FUNCTOR_CHARS,
                       "system_error", 2, PL_CHARS, what, PL_CHARS,
                       strerror(errno), PL_VARIABLE) &&
         PL_raise_exception(t);
}

/* A copy of descriptor `fd` as a stream, which children do not inherit. */
static int
unify_copy(term_t t, int fd, const char *mode)
{
  int copy = fcntl(fd, F_DUPFD_CLOEXEC, FIRST_FREE);
  IOSTREAM *stream;

  if (copy < 0) {
    return raise_errno("stdio");
  }
  if (!(stream = Sfdopen(copy, mode))) {
    close(copy);
    return PL_resource_error("memory");
  }
  if (PL_unify_stream(t, stream)) {
    return TRUE;
  }
  Sclose(stream);
  return FALSE;
}

/* stdio_apart(-In, -Out) is det. */
static foreign_t
stdio_apart(term_t in, term_t out)
{
  int nothing;
  bool done;

  if (!unify_copy(in, STDIN_FILENO, "rb") ||
      !unify_copy(out, STDOUT_FILENO, "wb")) {
    return FALSE;
  }
  if ((nothing = open("/dev/null", O_RDONLY | O_CLOEXEC)) < 0) {
    return raise_errno("/dev/null");
  }
  done = dup2(nothing, STDIN_FILENO) >= 0 &&
         dup2(STDERR_FILENO, STDOUT_FILENO) >= 0;
  close(nothing);
  return done || raise_errno("stdio");
}

/* reader_gone(+Stream) is semidet. */
static foreign_t
reader_gone(term_t stream)
{
  struct pollfd asked = {-1, 0, 0};
  IOSTREAM *out;

  if (!PL_get_stream(stream, &out, SIO_OUTPUT)) {
    return FALSE;
  }
  asked.fd = Sfileno(out);
  return PL_release_stream(out) && poll(&asked, 1, 0) > 0 &&
         (asked.revents & (POLLERR | POLLNVAL)) != 0;
}

static const PL_extension predicates[] = {
    {"stdio_apart", 2, stdio_apart, 0},
    {"reader_gone", 1, reader_gone, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_stdio(void)
{
  PL_register_extensions_in_module("sg_kernel_file", predicates);
}
