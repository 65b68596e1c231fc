/* stdio4pl.c -- what a process was started with: the streams of a session, the
 * socket of a front (documented in kernel/file.pl).
 *
 * Layer: glue.
 */
#include "install.h"

#include <SWI-Stream.h>

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

enum { FIRST_FREE = 3, PASSED = 3 };

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

/* The number that variable `name` of the environment says, or -1. */
static long
environment_number(const char *name)
{
  const char *text = getenv(name);
  char *end;
  long n = text ? strtol(text, &end, 10) : -1;

  return text && *text && !*end ? n : -1;
}

/* Whether `fd` is a Unix socket with a name at which it listens. */
static bool
listens_at(int fd, struct sockaddr_un *address)
{
  socklen_t size = sizeof *address;
  int on = 0;
  socklen_t on_size = sizeof on;

  memset(address, 0, sizeof *address);
  return getsockname(fd, (struct sockaddr *)address, &size) == 0 &&
         address->sun_family == AF_UNIX &&
         getsockopt(fd, SOL_SOCKET, SO_ACCEPTCONN, &on, &on_size) == 0 && on;
}

/* passed_socket(-Path) is semidet. */
static foreign_t
passed_socket(term_t path)
{
  struct sockaddr_un address;
  char name[sizeof address.sun_path + 1] = "";
  long passed = environment_number("LISTEN_FDS");

  if (environment_number("LISTEN_PID") != (long)getpid() || passed < 1) {
    return FALSE;
  }
  if (passed == 1 && listens_at(PASSED, &address)) {
    memcpy(name, address.sun_path, sizeof address.sun_path);
  }
  return PL_unify_chars(path, PL_ATOM | REP_FN, (size_t)-1, name);
}

/* passed_taken(+Fd) is det. */
static foreign_t
passed_taken(term_t t)
{
  int fd;

  if (!PL_get_integer_ex(t, &fd)) {
    return FALSE;
  }
  if (dup3(PASSED, fd, O_CLOEXEC) < 0) {
    return raise_errno("socket");
  }
  close(PASSED);
  unsetenv("LISTEN_PID");
  unsetenv("LISTEN_FDS");
  return TRUE;
}

static const PL_extension predicates[] = {
    {"stdio_apart", 2, stdio_apart, 0},
    {"reader_gone", 1, reader_gone, 0},
    {"passed_socket", 1, passed_socket, 0},
    {"passed_taken", 1, passed_taken, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_stdio(void)
{
  PL_register_extensions_in_module("sg_kernel_file", predicates);
}
