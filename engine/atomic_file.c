#include "atomic_file.h"

#include "content.h"
#include "left_over.h"
#include "real_path.h"

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

enum { MOST_NAMES = 100, MOST_HELD = 64, ACL_BYTES = 4096 };

static const char acl[] = "system.posix_acl_access";

typedef struct entry {
  uint64_t id;
  char *path;    /* where it is to be, links followed; null: a scratch file */
  char *own;     /* what is written; null: it is `held`, and has no name */
  int held;      /* or -1 */
  char *old;     /* during a commit: what was at `path` before, or null */
  bool locked;   /* what is held is, so that it is known for ours */
  bool in_place; /* the content of `path` is replaced, not the file */
  bool placed;
  pid_t process; /* a fork drops none of its parent's */
  struct entry *next;
} entry;

/* All that are under way, so that the end of the process finds them. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static entry *entries;
static uint64_t last_id;
static int held; /* files without a name */
static bool ended;

/* ---- names ------------------------------------------------------------- */

/* Makes a file `folder` .sanggwan-RANDOM `ending`: an empty one, or, if *fd is
 * one without a name, that. */
static int
new_file(const char *folder, size_t n, const char *ending, mode_t mode,
         char **path, int *fd)
{
  static const char letter[] = "abcdefghijklmnopqrstuvwxyz234567";
  char old[32];

  snprintf(old, sizeof(old), "/proc/self/fd/%d", *fd);
  for (int i = 0; i < MOST_NAMES; i++) {
    char name[] = SG_LEFT_NAME "............";
    unsigned char random[SG_LEFT_LETTERS];
    if (getrandom(random, sizeof(random), 0) != (ssize_t)sizeof(random)) {
      return errno;
    }
    for (size_t k = 0; k < sizeof(random); k++) {
      name[sizeof(name) - 1 - sizeof(random) + k] = letter[random[k] % 32];
    }
    if (!(*path = sg_path_joined(folder, n, name, ending))) {
      return ENOMEM;
    }
    if (*fd >= 0) {
      if (linkat(AT_FDCWD, old, AT_FDCWD, *path, AT_SYMLINK_FOLLOW) == 0) {
        return 0;
      }
    } else {
      *fd = open(*path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (*fd >= 0) {
        return 0;
      }
    }
    free(*path);
    *path = NULL;
    if (errno != EEXIST) {
      return errno;
    }
  }
  return EEXIST;
}

/* The same without a name, if the file system has such files: whatever ends the
 * process, nothing of it stays. e->held is it too. */
static bool
new_nameless(entry *e, mode_t mode, int *fd)
{
  char *folder = sg_path_joined(e->path, sg_folder_length(e->path), ".", "");
  int file = -1;

  if (folder && held < MOST_HELD && access("/proc/self/fd", X_OK) == 0) {
    file = open(folder, O_WRONLY | O_TMPFILE | O_CLOEXEC, mode);
  }
  free(folder);
  if (file < 0) {
    return false;
  }
  e->held = fcntl(file, F_DUPFD_CLOEXEC, 0);
  if (e->held < 0) {
    close(file);
    return false;
  }
  held++;
  e->locked = sg_left_lock(file);
  *fd = file;
  return true;
}

/* Gives a file without one a name: its own, if nothing is there yet. */
static int
name_held(entry *e)
{
  char fd[32];
  int held_fd = e->held;

  if (e->own) {
    return 0;
  }
  snprintf(fd, sizeof(fd), "/proc/self/fd/%d", e->held);
  e->placed = linkat(AT_FDCWD, fd, AT_FDCWD, e->path, AT_SYMLINK_FOLLOW) == 0;
  return e->placed
             ? 0
             : new_file(e->path, sg_folder_length(e->path),
                        e->locked ? SG_LEFT_ENDING : "", 0, &e->own, &held_fd);
}

static int
new_scratch(const char *ending, char **path, int *fd)
{
  *fd = -1;

  const char *folder = getenv("TMPDIR");
  char *name;
  int error;

  name = sg_path_joined("", 0, folder && *folder ? folder : "/tmp", "/");
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

static entry *
new_entry(void)
{
  entry *e = calloc(1, sizeof(*e));

  if (e) {
    e->held = -1;
  }
  return e;
}

static void
release(entry *e)
{
  if (e->held >= 0) {
    close(e->held);
    e->held = -1;
    held--;
  }
}

static void
free_entry(entry *e)
{
  release(e);
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
  if (e->own && e->process == getpid()) {
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
  *fd = -1;
  int error = new_file(path, sg_folder_length(path), "", mode, own, fd);

  return error == EACCES || error == EPERM ? new_scratch("", own, fd) : error;
}

static bool
same_folder(const char *a, const char *b)
{
  size_t n = sg_folder_length(a);

  return n == sg_folder_length(b) && memcmp(a, b, n) == 0;
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
  error =
      new_nameless(e, 0600, fd) ? 0 : new_beside(e->path, 0600, &e->own, fd);
  if (!error) {
    e->in_place = st->st_nlink > 1 ||
                  (e->own && !same_folder(e->own, e->path)) ||
                  !keep_rights(*fd, e->path, st);
  }
  return error;
}

int
sg_atomic_open(const char *path, uint64_t *id, int *fd)
{
  entry *e = new_entry();
  struct stat st;
  int error = e ? sg_real_path(path, &e->path, &st) : ENOMEM;
  bool settled;

  if (!error) {
    error = sg_path_settled(&e->path);
  }
  settled = !error; /* the folder is there; /proc takes no file */
  pthread_mutex_lock(&lock);
  if (!error && ended) {
    error = EINTR;
  }
  if (!error) {
    *fd = -1;
    error = st.st_nlink > 0 ? open_over(e, &st, fd)
            : new_nameless(e, 0666, fd)
                ? 0
                : new_file(e->path, sg_folder_length(e->path), "", 0666,
                           &e->own, fd);
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
  entry *e = new_entry();
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

/* Gives what is at the path another name too; false: it cannot be. */
static bool
keep_file(entry *e)
{
  int fd = -1;

  if (new_file(e->path, sg_folder_length(e->path), "", 0600, &e->old, &fd) !=
      0) {
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
    error = sg_content_replace(e->path, e->old);
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
    back = !e->placed || sg_content_replace(e->old, e->path) == 0;
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

  if (e->placed) {
    return 0;
  }
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
    error = sg_content_replace(e->own, e->path);
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
  char *folder = sg_path_joined(path, sg_folder_length(path), ".", "");
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
    if (e->own) {
      unlink(e->own);
    }
    release(e);
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
      sg_left_swept(e->path);
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
    error = ended || !e || !e->path ? EINTR : name_held(e);
    error = error ? error : place(e, n == 1);
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
