/* atomic_file_test.c -- files appear all together or not at all, over whatever
 * is there: nothing, files of any mode, several names of one file, links, and
 * folders that somebody makes meanwhile. Nothing else is ever left behind.
 *
 * covers: content, left_over, real_path */
#include "engine/atomic_file.h"
#include "engine/left_over.h"
#include "tests/check.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { NAMES = 6, ROUNDS = 400, TEXT = 64 };

static uint64_t state = 5;

static uint32_t
draw(uint32_t n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(state >> 33) % n;
}

static const char *const name[NAMES] = {"a", "b", "c", "d", "e", "f"};

/* What a name shows: nothing, a folder, or a file. */
typedef struct seen {
  bool there, folder, link;
  ino_t inode;
  mode_t mode;
  nlink_t links;
  char text[TEXT];
} seen;

static void
look(seen *s, const char *path)
{
  struct stat st;
  int fd;

  memset(s, 0, sizeof(*s));
  s->link = lstat(path, &st) == 0 && S_ISLNK(st.st_mode);
  if (stat(path, &st) != 0) {
    return;
  }
  s->there = true;
  s->folder = S_ISDIR(st.st_mode);
  s->inode = st.st_ino;
  s->mode = st.st_mode;
  s->links = st.st_nlink;
  if (!s->folder && (fd = open(path, O_RDONLY)) >= 0) {
    s->text[read(fd, s->text, TEXT - 1) < 0 ? 0 : TEXT - 1] = '\0';
    close(fd);
  }
}

static void
make(const char *path, const char *text, mode_t mode)
{
  int fd = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600);

  CHECK("made", fd >= 0 && write(fd, text, strlen(text)) >= 0 &&
                    fchmod(fd, mode) == 0 && close(fd) == 0);
}

/* An entry in the folder that is none of ours. */
static unsigned
strangers(void)
{
  DIR *folder = opendir(".");
  struct dirent *e;
  unsigned n = 0;

  while (folder && (e = readdir(folder))) {
    n += strlen(e->d_name) > 1 && strcmp(e->d_name, "..") != 0;
  }
  closedir(folder);
  return n;
}

static void
clear(void)
{
  for (int i = 0; i < NAMES; i++) {
    if (unlink(name[i]) != 0) {
      rmdir(name[i]);
    }
  }
}

/* Each name: nothing, a file, another name of an earlier one, a link to any. */
static void
furnish(void)
{
  static const mode_t mode[] = {0644, 0600, 0640, 0755, 0666};

  clear();
  for (uint32_t i = 0; i < NAMES; i++) {
    switch (draw(5)) {
    case 0:
      break;
    case 1:
      if (i == 0 || link(name[draw(i)], name[i]) != 0) {
        make(name[i], "other", 0644);
      }
      break;
    case 2:
      CHECK("link", symlink(name[(i + 1) % NAMES], name[i]) == 0);
      break;
    default:
      make(name[i], name[i], mode[draw(5)]);
    }
  }
}

static bool
same(const seen *a, const seen *b)
{
  return memcmp(a, b, sizeof(*a)) == 0;
}

static bool
wrote(const seen *before, const seen *after, const char *text)
{
  bool kept = !before->there ||
              (before->mode == after->mode && before->links == after->links &&
               before->link == after->link &&
               (before->links == 1 || before->inode == after->inode));

  return kept && after->there && strcmp(after->text, text) == 0;
}

/* Opens `n` names, writes a text to each. Those that refuse are left out. */
static size_t
open_some(size_t n, uint64_t *id, uint32_t *which)
{
  size_t opened = 0;

  for (size_t k = 0; k < n; k++) {
    char text[TEXT];
    uint32_t i = draw(NAMES);
    int fd, error = sg_atomic_open(name[i], &id[opened], &fd);
    CHECK("refused for a reason", !error || error == ELOOP);
    if (!error) {
      snprintf(text, sizeof(text), "new %u", i);
      CHECK("written", write(fd, text, strlen(text)) == (ssize_t)strlen(text));
      close(fd);
      which[opened++] = i;
    }
  }
  return opened;
}

/* Two names of one file get what was written last, so texts are compared only
 * where no other was written. */
static bool
shares(uint32_t i, const seen *now, const uint32_t *which, size_t n)
{
  for (size_t k = 0; k < n; k++) {
    if (which[k] != i && now[which[k]].inode == now[i].inode) {
      return true;
    }
  }
  return false;
}

/* Something in the way: it may have been written by a link that is no more. */
static bool
through(uint32_t broken, const seen *after)
{
  return broken < NAMES && strncmp(after->text, "new ", 4) == 0;
}

static void
one_round(void)
{
  seen before[NAMES], after[NAMES];
  uint64_t id[NAMES];
  uint32_t which[NAMES], broken = NAMES;
  size_t failed = 0, n;
  char text[TEXT];

  furnish();
  n = open_some(1 + draw(NAMES), id, which);
  if (n > 0 && draw(3) == 0) { /* what cannot be replaced */
    broken = which[draw((uint32_t)n)];
    unlink(name[broken]);
    CHECK("folder", mkdir(name[broken], 0755) == 0);
  }
  for (int i = 0; i < NAMES; i++) {
    look(&before[i], name[i]);
  }
  int error = sg_atomic_commit(id, n, &failed);
  for (int i = 0; i < NAMES; i++) {
    look(&after[i], name[i]);
  }
  CHECK("an error only where something is in the way",
        !error || broken < NAMES);
  for (uint32_t i = 0; error && i < NAMES; i++) {
    CHECK("after an error all is as it was", same(&before[i], &after[i]));
  }
  /* Where a link names the folder now, what it named before was written. */
  for (size_t k = 0; !error && k < n; k++) {
    snprintf(text, sizeof(text), "new %u", which[k]);
    CHECK("written, with its rights and names",
          after[which[k]].folder || shares(which[k], after, which, n) ||
              through(broken, &after[which[k]]) ||
              wrote(&before[which[k]], &after[which[k]], text));
  }
  for (size_t k = 0; k < n; k++) {
    sg_atomic_drop(id[k]);
  }
  CHECK("nothing is left behind", strangers() == 0);
}

static void
dropped(void)
{
  char *path;
  uint64_t id, other;
  size_t failed;
  int fd;

  clear();
  make("a", "old", 0604);
  CHECK("opens", sg_atomic_open("a", &id, &fd) == 0 && close(fd) == 0);
  CHECK("scratch", sg_atomic_scratch(".svg", &other, &path) == 0);
  CHECK("its ending", strcmp(path + strlen(path) - 4, ".svg") == 0);
  CHECK("there", access(path, W_OK) == 0);
  sg_atomic_drop(id);
  sg_atomic_drop(other);
  CHECK("gone", access(path, F_OK) != 0 && strangers() == 0);
  CHECK("what was dropped is not put", sg_atomic_commit(&id, 1, &failed) != 0);
  free(path);
}

/* The new file of a new name has the mode that umask leaves. */
static void
masked(void)
{
  uint64_t id;
  size_t failed;
  struct stat st;
  int fd;
  mode_t old = umask(027);

  clear();
  CHECK("opens", sg_atomic_open("a", &id, &fd) == 0 && close(fd) == 0);
  CHECK("put", sg_atomic_commit(&id, 1, &failed) == 0);
  CHECK("umask", stat("a", &st) == 0 && (st.st_mode & 07777) == 0640);
  umask(old);
}

/* Where the working directory is later does not matter. */
static void
moved(void)
{
  uint64_t id;
  size_t failed;
  int fd;

  clear();
  CHECK("opens", sg_atomic_open("./a", &id, &fd) == 0 && close(fd) == 0);
  CHECK("elsewhere", mkdir("b", 0755) == 0 && chdir("b") == 0);
  CHECK("put", sg_atomic_commit(&id, 1, &failed) == 0);
  CHECK("in its place", chdir("..") == 0 && access("a", F_OK) == 0);
}

/* Somebody else's link in a folder that all may write; and a file of another
 * owner, which stays his. Needs to be root. */
static void
of_others(void)
{
  uint64_t id;
  size_t failed;
  struct stat st;
  int fd;

  clear();
  CHECK("open to all", chmod(".", 01777) == 0);
  make("a", "mine", 0644);
  CHECK("link", symlink("a", "b") == 0 && lchown("b", 65534, 65534) == 0);
  CHECK("refused", sg_atomic_open("b", &id, &fd) == EACCES);
  CHECK("own link", symlink("a", "c") == 0);
  CHECK("followed", sg_atomic_open("c", &id, &fd) == 0 && close(fd) == 0);
  sg_atomic_drop(id);
  make("d", "his", 0640);
  CHECK("his", chown("d", 65534, 65533) == 0);
  CHECK("opens", sg_atomic_open("d", &id, &fd) == 0 && close(fd) == 0);
  CHECK("put", sg_atomic_commit(&id, 1, &failed) == 0);
  CHECK("still his", stat("d", &st) == 0 && st.st_uid == 65534 &&
                         st.st_gid == 65533 && (st.st_mode & 07777) == 0640);
  CHECK("as before", chmod(".", 0755) == 0);
}

/* As nobody: a file that may be written in a folder that may not, and one of
 * another owner, keep their inodes. Everything in a child, with its status. */
static int
as_nobody(void)
{
  static const char *const file[] = {"a", "b"};
  uint64_t id[2];
  size_t failed;
  int fd;

  for (int i = 0; i < 2; i++) {
    if (sg_atomic_open(file[i], &id[i], &fd) != 0 || write(fd, "new", 3) != 3 ||
        close(fd) != 0) {
      return 2;
    }
  }
  return sg_atomic_commit(id, 2, &failed) != 0;
}

static void
in_place(void)
{
  struct stat a, b;
  seen s;
  pid_t child;
  int status = -1;

  clear();
  make("a", "old and longer", 0666);
  make("b", "old", 0666);
  CHECK("owner", chown("b", 65534, 65534) == 0);
  CHECK("inodes", stat("a", &a) == 0 && stat("b", &b) == 0);
  CHECK("closed", chmod(".", 0755) == 0);
  fflush(NULL);
  if ((child = fork()) == 0) {
    unsetenv("TMPDIR");
    _exit(setgid(65534) != 0 || setuid(65534) != 0 ? 3 : as_nobody());
  }
  waitpid(child, &status, 0);
  CHECK("written", WIFEXITED(status) && WEXITSTATUS(status) == 0);
  look(&s, "a");
  CHECK("a in place", s.inode == a.st_ino && strcmp(s.text, "new") == 0);
  look(&s, "b");
  CHECK("b in place", s.inode == b.st_ino && strcmp(s.text, "new") == 0);
}

static void
ended(void)
{
  uint64_t id, other;
  size_t failed;
  char *path;
  int fd;

  clear();
  CHECK("opens", sg_atomic_open("a", &id, &fd) == 0 && close(fd) == 0);
  CHECK("scratch", sg_atomic_scratch("", &other, &path) == 0);
  sg_atomic_end();
  CHECK("all gone", strangers() == 0 && access(path, F_OK) != 0);
  CHECK("too late", sg_atomic_commit(&id, 1, &failed) != 0 &&
                        sg_atomic_open("a", &id, &fd) != 0 &&
                        access("a", F_OK) != 0);
  free(path);
}

/* While a file is written there is nothing to be left behind; but of very many
 * at once. */
static void
nameless(void)
{
  enum { MANY = 200 };
  uint64_t id[MANY];
  size_t failed;
  int fd, few = open(".", O_WRONLY | O_TMPFILE | O_CLOEXEC, 0600);

  if (few < 0) {
    printf("skipped: this file system has no files without a name\n");
    return;
  }
  close(few);
  CHECK("opened", sg_atomic_open("a", &id[0], &fd) == 0);
  CHECK("it has no name", write(fd, "x", 1) == 1 && strangers() == 0);
  close(fd);
  CHECK("it has its name", sg_atomic_commit(id, 1, &failed) == 0 &&
                               access("a", R_OK) == 0 && strangers() == 0);
  for (int i = 0; i < MANY; i++) {
    CHECK("one of many", sg_atomic_open(i % 2 ? "a" : "b", &id[i], &fd) == 0);
    close(fd);
  }
  CHECK("not all are held open", strangers() > 0 && strangers() < MANY);
  for (int i = 0; i < MANY; i++) {
    sg_atomic_drop(id[i]);
  }
  CHECK("nor left", strangers() == 0);
  clear();
}

/* Whether there is a file of that name; it is taken away. */
static bool
taken(const char *path)
{
  return unlink(path) == 0;
}

static void
save(const char *path)
{
  uint64_t id;
  size_t failed;
  int fd;

  CHECK("saved", sg_atomic_open(path, &id, &fd) == 0 &&
                     write(fd, "new", 3) == 3 && close(fd) == 0 &&
                     sg_atomic_commit(&id, 1, &failed) == 0);
}

/* What a killed process left is taken away, and nothing else. */
static void
left_over(void)
{
  static const char *const other[] = {
      ".sanggwan-aaaaaaaaaaaa",  ".sanggwan-aaaaaaaaaaa~",
      ".sanggwan-aaaaaaaaaaa1~", ".sanggwan-aaaaaaaaaaaa~~",
      "sanggwan-aaaaaaaaaaaa~",  ".sanggwan-cccccccccccc~",
      ".sanggwan-dddddddddddd~"};
  const char *left = ".sanggwan-bbbbbbbbbbbb~";
  pid_t child;
  int status, fd;

  clear();
  CHECK("folders", mkdir("y", 0700) == 0 && mkdir("z", 0700) == 0);
  for (unsigned i = 0; i < 7; i++) {
    make(other[i], "theirs", 0600);
  }
  CHECK("another name", link(other[5], "z/link") == 0);
  fd = open(other[6], O_RDONLY);
  CHECK("held", fd >= 0 && sg_left_lock(fd));
  make(left, "ours", 0600);
  save("z/a"); /* another folder; then this one */
  CHECK("there", access(left, F_OK) == 0);
  save("a");
  CHECK("gone", !taken(left));
  for (unsigned i = 0; i < 7; i++) {
    CHECK("theirs", taken(other[i]));
  }
  close(fd);
  CHECK("tidy", taken("z/a") && taken("z/link") && rmdir("z") == 0);

  /* Killed at any moment. */
  for (int i = 0; i < 60; i++) {
    if ((child = fork()) == 0) {
      for (;;) {
        save("a");
        save("y/b");
      }
    }
    usleep(500 + draw(3000));
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
  }
  save("y/b");
  save("a");
  CHECK("nothing is left in one", strangers() == 0);
  CHECK("nor in the other", chdir("y") == 0 && strangers() == 0 && taken("b") &&
                                chdir("..") == 0 && rmdir("y") == 0);
  clear();
}

int
main(void)
{
  char folder[] = "/dev/shm/sanggwan_atomic_XXXXXX"; /* fsync is quick there */

  if (!mkdtemp(strcpy(folder, access("/dev/shm", W_OK) == 0
                                  ? "/dev/shm/sanggwan_atomic_XXXXXX"
                                  : "/tmp/sanggwan_atomic_XXXXXX")) ||
      chdir(folder) != 0) {
    CHECK("a folder", false);
    return check_report();
  }
  for (int i = 0; i < ROUNDS; i++) {
    one_round();
  }
  dropped();
  nameless();
  left_over();
  masked();
  moved();
  if (geteuid() == 0) {
    of_others();
    in_place();
  } else {
    printf("skipped: files of other owners: only root can make them\n");
  }
  ended();
  clear();
  CHECK("folder gone", rmdir(folder) == 0);
  return check_report();
}
