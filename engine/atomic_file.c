#include "atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

enum { MOST_LINKS = 40, MOST_NAMES = 100, BLOCK = 1 << 16, ACL_BYTES = 4096 };

static const char acl[] = "system.posix_acl_access";

typedef struct entry {
  uint64_t id;
  char *path;    /* where it is to be, links followed; null: a scratch file */
  char *own;     /* what is written */
  char *old;     /* during a commit: what was at `path` before, or null */
  bool in_place; /* the content of `path` is replaced, not the file */
  bool placed;
  pid_t process; /* a fork drops none of its parent's */
  struct entry *next;
} entry;

/* All that are under way, so that the end of the process finds them. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static entry *entries;
static uint64_t last_id;
static bool ended;

/* ---- names ------------------------------------------------------------- */

/* The folder of `path` with the slash, or "". */
static size_t
folder_length(const char *path)
{
  const char *slash = strrchr(path, '/');

  return slash ? (size_t)(slash - path) + 1 : 0;
}

/* The first n bytes of a, then b and c; null: no memory. */
static char *
joined(const char *a, size_t n, const char *b, const char *c)
{
  size_t room = n + strlen(b) + strlen(c) + 1;
  char *text = malloc(room);

  if (text) {
    snprintf(text, room, "%.*s%s%s", (int)n, a, b, c);
  }
  return text;
}

/* Somebody else's link in a folder where all may make one, as in /tmp: who
 * followed it would write where another user wants it. */
static bool
is_planted(const char *path, const struct stat *link)
{
  char *folder = joined(path, folder_length(path), ".", "");
  struct stat at;
  bool planted = folder && stat(folder, &at) == 0 && (at.st_mode & S_ISVTX) &&
                 (at.st_mode & S_IWOTH) && link->st_uid != geteuid() &&
                 link->st_uid != at.st_uid;

  free(folder);
  return planted;
}

/* What the link at `path` names. */
static int
read_link(const char *path, char **out)
{
  char text[BLOCK];
  ssize_t n = readlink(path, text, sizeof(text) - 1);

  if (n < 0) {
    return errno;
  }
  text[n] = '\0';
  *out = joined(path, text[0] == '/' ? 0 : folder_length(path), text, "");
  return *out ? 0 : ENOMEM;
}

/* Follows links to what is there, or is to be. *st: with st_nlink 0 if there is
 * nothing. */
static int
resolve(const char *path, char **out, struct stat *st)
{
  char *at = strdup(path), *next;
  int error = at ? 0 : ENOMEM;

  for (int i = 0; !error; i++) {
    if (lstat(at, st) != 0) {
      error = errno == ENOENT ? 0 : errno;
      st->st_nlink = 0;
      break;
    }
    if (!S_ISLNK(st->st_mode)) {
      break;
    }
    error = i == MOST_LINKS      ? ELOOP
            : is_planted(at, st) ? EACCES
                                 : read_link(at, &next);
    if (!error) {
      free(at);
      at = next;
    }
  }
  if (error) {
    free(at);
    at = NULL;
  }
  *out = at;
  return error;
}

/* `path` with the folder's own name, from the root: it stays right wherever the
 * process goes. */
static int
settle(char **path)
{
  size_t n = folder_length(*path);
  char *folder = joined(*path, n, ".", "");
  char *real = folder ? realpath(folder, NULL) : NULL;
  int error = real ? 0 : errno;
  char *at = real ? joined(real, strlen(real), "/", *path + n) : NULL;

  free(folder);
  free(real);
  if (at) {
    free(*path);
    *path = at;
  }
  return at || error ? error : ENOMEM;
}

/* Makes an empty file `folder` .sanggwan-RANDOM `ending`. */
static int
new_file(const char *folder, size_t n, const char *ending, mode_t mode,
         char **path, int *fd)
{
  static const char letter[] = "abcdefghijklmnopqrstuvwxyz234567";

  for (int i = 0; i < MOST_NAMES; i++) {
    char name[] = ".sanggwan-............";
    unsigned char random[12];
    if (getrandom(random, sizeof(random), 0) != (ssize_t)sizeof(random)) {
      return errno;
    }
    for (size_t k = 0; k < sizeof(random); k++) {
      name[sizeof(name) - 1 - sizeof(random) + k] = letter[random[k] % 32];
    }
    if (!(*path = joined(folder, n, name, ending))) {
      return ENOMEM;
    }
    *fd = open(*path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (*fd >= 0) {
      return 0;
    }
    free(*path);
    *path = NULL;
    if (errno != EEXIST) {
      return errno;
    }
  }
  return EEXIST;
}

static int
new_scratch(const char *ending, char **path, int *fd)
{
  const char *folder = getenv("TMPDIR");
  char *name;
  int error;

  name = joined("", 0, folder && *folder ? folder : "/tmp", "/");
  error = name ? new_file(name, strlen(name), ending, 0600, path, fd) : ENOMEM;
  free(name);
  return error;
}

/* ---- the list ---------------------------------------------------------- */

static entry **
find(uint64_t id)
{
  entry **at = &entries;

  while (*at && (*at)->id != id) {
    at = &(*at)->next;
  }
  return at;
}

/* Takes `e` into the list. */
static void
enter(entry *e, uint64_t *id)
{
  *id = e->id = ++last_id;
  e->process = getpid();
  e->next = entries;
  entries = e;
}

static void
free_entry(entry *e)
{
  free(e->path);
  free(e->own);
  free(e->old);
  free(e);
}

static void
drop(entry **at)
{
  entry *e = *at;

  *at = e->next;
  if (e->process == getpid()) {
    unlink(e->own);
  }
  free_entry(e);
}

/* ---- opening ----------------------------------------------------------- */

/* The new file may be read and changed by whom the old one may. */
static bool
keep_rights(int fd, const char *path, const struct stat *st)
{
  char list[ACL_BYTES];
  struct stat own;
  ssize_t n;

  if (fstat(fd, &own) != 0 ||
      ((own.st_uid != st->st_uid || own.st_gid != st->st_gid) &&
       fchown(fd, st->st_uid, st->st_gid) != 0) ||
      fchmod(fd, st->st_mode & 07777) != 0) {
    return false;
  }
  n = getxattr(path, acl, list, sizeof(list));
  return n <= 0 || fsetxattr(fd, acl, list, (size_t)n, 0) == 0;
}

/* A file of ours beside `path`; where that folder takes none, a scratch file.
 */
static int
new_beside(const char *path, mode_t mode, char **own, int *fd)
{
  int error = new_file(path, folder_length(path), "", mode, own, fd);

  return error == EACCES || error == EPERM ? new_scratch("", own, fd) : error;
}

static bool
same_folder(const char *a, const char *b)
{
  size_t n = folder_length(a);

  return n == folder_length(b) && memcmp(a, b, n) == 0;
}

/* The file that is there, `st`, is to be replaced. */
static int
open_over(entry *e, const struct stat *st, int *fd)
{
  int error;

  if (!S_ISREG(st->st_mode)) {
    return S_ISDIR(st->st_mode) ? EISDIR : EXDEV;
  }
  if (faccessat(AT_FDCWD, e->path, W_OK, AT_EACCESS) != 0) {
    return errno;
  }
  error = new_beside(e->path, 0600, &e->own, fd);
  if (!error) {
    e->in_place = st->st_nlink > 1 || !same_folder(e->own, e->path) ||
                  !keep_rights(*fd, e->path, st);
  }
  return error;
}

int
sg_atomic_open(const char *path, uint64_t *id, int *fd)
{
  entry *e = calloc(1, sizeof(*e));
  struct stat st;
  int error = e ? resolve(path, &e->path, &st) : ENOMEM;
  bool settled;

  if (!error) {
    error = settle(&e->path);
  }
  settled = !error; /* the folder is there; /proc takes no file */
  pthread_mutex_lock(&lock);
  if (!error && ended) {
    error = EINTR;
  }
  if (!error) {
    error = st.st_nlink > 0 ? open_over(e, &st, fd)
                            : new_file(e->path, folder_length(e->path), "",
                                       0666, &e->own, fd);
  }
  if (!error) {
    enter(e, id);
  } else if (e) {
    free_entry(e);
    error = error == ENOENT && settled ? EACCES : error;
  }
  pthread_mutex_unlock(&lock);
  return error;
}

int
sg_atomic_scratch(const char *ending, uint64_t *id, char **path)
{
  entry *e = calloc(1, sizeof(*e));
  int error = e && (*path = NULL, true) ? 0 : ENOMEM, fd = -1;

  pthread_mutex_lock(&lock);
  if (!error) {
    error = ended ? EINTR : new_scratch(ending, &e->own, &fd);
  }
  if (!error) {
    close(fd);
    *path = strdup(e->own);
    error = *path ? 0 : ENOMEM;
    enter(e, id);
    if (error) {
      drop(find(*id));
    }
  } else if (e) {
    free_entry(e);
  }
  pthread_mutex_unlock(&lock);
  return error;
}

/* ---- committing -------------------------------------------------------- */

static int
copy_bytes(int from, int to)
{
  char block[BLOCK];
  ssize_t n;

  while ((n = read(from, block, sizeof(block))) > 0) {
    for (ssize_t done = 0, k; done < n; done += k) {
      if ((k = write(to, block + done, (size_t)(n - done))) < 0) {
        if (errno != EINTR) {
          return errno;
        }
        k = 0;
      }
    }
  }
  return n < 0 ? errno : 0;
}

/* Makes room for all of `size` bytes before the first one is changed. */
static int
reserve(int fd, off_t size)
{
  struct stat st;
  int error;

  if (fstat(fd, &st) != 0) {
    return errno;
  }
  if (size <= st.st_size) {
    return 0;
  }
  error = posix_fallocate(fd, st.st_size, size - st.st_size);
  if (error == ENOSPC || error == EDQUOT || error == EFBIG) {
    return ftruncate(fd, st.st_size) == 0 ? error : errno;
  }
  return 0;
}

/* The file `to` gets the content of the file `own`. */
static int
replace_content(const char *own, const char *to)
{
  int from = open(own, O_RDONLY | O_CLOEXEC);
  int file = open(to, O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  int error = from < 0 || file < 0 ? errno : 0;
  struct stat st;

  if (!error && fstat(from, &st) != 0) {
    error = errno;
  }
  if (!error && !(error = reserve(file, st.st_size)) &&
      !(error = copy_bytes(from, file)) &&
      (ftruncate(file, st.st_size) != 0 || fsync(file) != 0)) {
    error = errno;
  }
  if (from >= 0) {
    close(from);
  }
  if (file >= 0 && close(file) != 0 && !error) {
    error = errno;
  }
  return error;
}

/* Gives what is at the path another name too; false: it cannot be. */
static bool
keep_file(entry *e)
{
  int fd;

  if (new_file(e->path, folder_length(e->path), "", 0600, &e->old, &fd) != 0) {
    return false;
  }
  close(fd);
  if (unlink(e->old) == 0 &&
      (link(e->path, e->old) == 0 || rename(e->path, e->old) == 0)) {
    return true;
  }
  free(e->old);
  e->old = NULL;
  return false;
}

static int
keep_content(entry *e)
{
  int fd, error = new_beside(e->path, 0600, &e->old, &fd);

  if (!error) {
    close(fd);
    error = replace_content(e->path, e->old);
  }
  return error;
}

/* Back to what was there before place(). What cannot be put back stays under
 * the name it was kept by. */
static void
undo(entry *e)
{
  bool back = true;

  if (e->old && e->in_place) {
    back = !e->placed || replace_content(e->old, e->path) == 0;
  } else if (e->old) {
    back = rename(e->old, e->path) == 0;
  } else if (e->placed) {
    unlink(e->path);
  }
  if (e->old) {
    if (back) {
      unlink(e->old);
    }
    free(e->old);
    e->old = NULL;
  }
}

/* Puts the file in its place; one that is `alone` needs no way back. */
static int
place(entry *e, bool alone)
{
  struct stat st;
  bool there = lstat(e->path, &st) == 0;
  int error;

  if (there && !S_ISREG(st.st_mode)) {
    return S_ISDIR(st.st_mode) ? EISDIR : EXDEV; /* made meanwhile */
  }
  if (!e->in_place && (alone || !there || keep_file(e)) &&
      rename(e->own, e->path) == 0) {
    e->placed = true;
    return 0;
  }
  error = errno;
  if (!there) {
    return error;
  }
  undo(e); /* the kept name */
  e->in_place = true;
  error = keep_content(e);
  if (!error) {
    e->placed = true;
    error = replace_content(e->own, e->path);
  }
  return error;
}

bool
sg_atomic_syncs(void)
{
  const char *sync = getenv("SANGGWAN_SYNC");

  return !sync || strcmp(sync, "no") != 0;
}

int
sg_atomic_sync(int fd)
{
  enum { PART = 1 << 23 };
  struct stat st;

  for (off_t at = 0; fstat(fd, &st) == 0 && at < st.st_size; at += PART) {
    if (sync_file_range(fd, at, PART, SYNC_FILE_RANGE_WRITE_AND_WAIT) != 0) {
      break; /* it may be no file of a disk */
    }
  }
  return fsync(fd) == 0 ? 0 : errno;
}

void
sg_atomic_sync_folder(const char *path)
{
  if (!sg_atomic_syncs()) {
    return;
  }
  char *folder = joined(path, folder_length(path), ".", "");
  int fd = folder ? open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;

  if (fd >= 0) {
    fsync(fd);
    close(fd);
  }
  free(folder);
}

/* All are in their places: takes them out of the list. */
static entry *
finish(const uint64_t *id, size_t n)
{
  entry *done = NULL;

  for (size_t i = n; i > 0; i--) {
    entry **at = find(id[i - 1]), *e = *at;
    if (e->old) {
      unlink(e->old);
    }
    unlink(e->own);
    *at = e->next;
    e->next = done;
    done = e;
  }
  return done;
}

/* Nobody waits for this: what ends the process need not. */
static void
sync_folders(entry *done)
{
  while (done) {
    entry *e = done;
    done = e->next;
    if (!done || !same_folder(done->path, e->path)) {
      sg_atomic_sync_folder(e->path);
    }
    free_entry(e);
  }
}

int
sg_atomic_commit(const uint64_t *id, size_t n, size_t *failed)
{
  entry *done = NULL;
  int error = 0;
  size_t i = 0;

  pthread_mutex_lock(&lock);
  while (i < n && !error) {
    entry *e = *find(id[i++]);
    error = ended || !e || !e->path ? EINTR : place(e, n == 1);
  }
  if (!error) {
    done = finish(id, n);
  } else {
    *failed = i - 1;
    while (i > 0) {
      entry *e = *find(id[--i]);
      if (e) {
        undo(e);
      }
    }
  }
  pthread_mutex_unlock(&lock);
  sync_folders(done);
  return error;
}

void
sg_atomic_drop(uint64_t id)
{
  pthread_mutex_lock(&lock);
  entry **at = find(id);
  if (*at) {
    drop(at);
  }
  pthread_mutex_unlock(&lock);
}

void
sg_atomic_end(void)
{
  pthread_mutex_lock(&lock);
  ended = true;
  while (entries) {
    drop(&entries);
  }
  pthread_mutex_unlock(&lock);
}

/* When the process ends, or the library is unloaded. */
__attribute__((destructor)) static void
drop_all(void)
{
  sg_atomic_end();
}
