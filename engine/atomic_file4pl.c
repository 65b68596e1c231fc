/* atomic_file4pl.c -- files that appear whole (documented in kernel/file.pl).
 *
 * Layer: glue.
 */
#include "atomic_file.h"
#include "install.h"

#include <SWI-Stream.h>

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

/* Why a file cannot be written, as messages name it. */
static const char *
reason(int error)
{
  switch (error) {
  case EACCES:
  case EPERM:
  case EROFS:
    return "permission";
  case ENOENT:
    return "no_folder";
  case EISDIR:
    return "directory";
  case ENOSPC:
  case EDQUOT:
    return "full";
  case EFBIG:
    return "too_large";
  case ENAMETOOLONG:
    return "long_name";
  case ELOOP:
    return "links";
  default:
    return strerror(error);
  }
}

/* error(cannot_write(File, Why), _) */
static int
cannot_write(term_t file, int error)
{
  term_t t = PL_new_term_ref();

  return error == ENOMEM
             ? PL_resource_error("memory")
             : PL_unify_term(t, PL_FUNCTOR_CHARS, "error", 2, PL_FUNCTOR_CHARS,
                             "cannot_write", 2, PL_TERM, file, PL_CHARS,
                             reason(error), PL_VARIABLE) &&
                   PL_raise_exception(t);
}

/* A stream to the file `fd`, which is closed if there is none. */
static int
unify_stream(term_t t, int fd)
{
  IOSTREAM *out = Sfdopen(fd, "wb");

  if (!out) {
    close(fd);
    return PL_resource_error("memory");
  }
  if (PL_unify_stream(t, out)) {
    return TRUE;
  }
  Sclose(out);
  return FALSE;
}

/* atomic_open(+File, -Id, -Stream) is det. */
static foreign_t
atomic_open(term_t file, term_t id_term, term_t stream)
{
  uint64_t id;
  char *name;
  int fd, error;

  if (!PL_get_nchars(file, NULL, &name,
                     CVT_ATOM | CVT_STRING | CVT_EXCEPTION | BUF_MALLOC |
                         REP_FN)) {
    return FALSE;
  }
  error = sg_atomic_open(name, &id, &fd);
  PL_free(name);
  if (error) {
    return cannot_write(file, error);
  }
  if (unify_stream(stream, fd) && PL_unify_uint64(id_term, id)) {
    return TRUE;
  }
  sg_atomic_drop(id);
  return FALSE;
}

/* atomic_scratch(+Ending, -Id, -File) is det. */
static foreign_t
atomic_scratch(term_t ending, term_t id_term, term_t file)
{
  char *text, *path;
  uint64_t id;
  int error, done;

  if (!PL_get_nchars(ending, NULL, &text,
                     CVT_ATOM | CVT_STRING | CVT_EXCEPTION | REP_FN)) {
    return FALSE;
  }
  error = sg_atomic_scratch(text, &id, &path);
  if (error) {
    return cannot_write(ending, error);
  }
  done = PL_unify_chars(file, PL_ATOM | REP_FN, (size_t)-1, path) &&
         PL_unify_uint64(id_term, id);
  free(path);
  if (!done) {
    sg_atomic_drop(id);
  }
  return done;
}

/* atomic_sync(+Stream) is det. What has no disk needs none. */
static foreign_t
atomic_sync(term_t stream)
{
  IOSTREAM *out;

  if (!PL_get_stream(stream, &out, SIO_OUTPUT)) {
    return FALSE;
  }
  if (Sflush(out) == 0 && sg_atomic_syncs()) {
    int error = sg_atomic_sync(Sfileno(out));
    if (error && error != EINVAL && error != ENOTSUP && error != EROFS) {
      Sseterr(out, SIO_FERR, strerror(error));
    }
  }
  return PL_release_stream(out);
}

/* atomic_sync_folder(+File) is det. */
static foreign_t
atomic_sync_folder(term_t file)
{
  char *name;

  if (!PL_get_nchars(file, NULL, &name,
                     CVT_ATOM | CVT_STRING | CVT_EXCEPTION | REP_FN)) {
    return FALSE;
  }
  sg_atomic_sync_folder(name);
  return TRUE;
}

/* atomic_commit(+Ids, -Result) is det. */
static foreign_t
atomic_commit(term_t ids, term_t result)
{
  term_t tail = PL_copy_term_ref(ids), head = PL_new_term_ref();
  uint64_t *id;
  size_t n, failed = 0;
  int error = 0, done = TRUE;

  if (PL_skip_list(ids, 0, &n) != PL_LIST) {
    return PL_type_error("list", ids);
  }
  if (!(id = malloc((n + 1) * sizeof(*id)))) {
    return PL_resource_error("memory");
  }
  for (size_t i = 0; done && i < n; i++) {
    done = PL_get_list_ex(tail, head, tail) && PL_get_uint64_ex(head, &id[i]);
  }
  if (done) {
    error = sg_atomic_commit(id, n, &failed);
    done = error
               ? PL_unify_term(result, PL_FUNCTOR_CHARS, "failed", 2, PL_INT64,
                               (int64_t)failed, PL_CHARS, reason(error))
               : PL_unify_atom_chars(result, "done");
  }
  free(id);
  return done;
}

/* atomic_drop(+Id) is det. */
static foreign_t
atomic_drop(term_t id_term)
{
  uint64_t id;

  if (!PL_get_uint64_ex(id_term, &id)) {
    return FALSE;
  }
  sg_atomic_drop(id);
  return TRUE;
}

/* device_file(+File) is semidet. */
static foreign_t
device_file(term_t file)
{
  struct stat st;
  char *name;

  return PL_get_nchars(file, NULL, &name,
                       CVT_ATOM | CVT_STRING | CVT_EXCEPTION | REP_FN) &&
         stat(name, &st) == 0 && !S_ISREG(st.st_mode) && !S_ISDIR(st.st_mode);
}

enum { MEMORY_DEVICES = 1, NULL_DEVICE = 3 }; /* major, minor number */

/* endless_file(+File) is semidet. */
static foreign_t
endless_file(term_t file)
{
  struct stat st;
  char *name;

  if (!PL_get_nchars(file, NULL, &name,
                     CVT_ATOM | CVT_STRING | CVT_EXCEPTION | REP_FN) ||
      stat(name, &st) != 0) {
    return FALSE;
  }
  return S_ISBLK(st.st_mode) ||
         (S_ISCHR(st.st_mode) && major(st.st_rdev) == MEMORY_DEVICES &&
          minor(st.st_rdev) != NULL_DEVICE);
}

static const PL_extension predicates[] = {
    {"endless_file", 1, endless_file, 0},
    {"device_file", 1, device_file, 0},
    {"atomic_open", 3, atomic_open, 0},
    {"atomic_scratch", 3, atomic_scratch, 0},
    {"atomic_sync", 1, atomic_sync, 0},
    {"atomic_sync_folder", 1, atomic_sync_folder, 0},
    {"atomic_commit", 2, atomic_commit, 0},
    {"atomic_drop", 1, atomic_drop, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_atomic_file(void)
{
  PL_register_extensions_in_module("sg_kernel_file", predicates);
}
