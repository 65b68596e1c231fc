/* left_over.c -- see left_over.h. */
#include "left_over.h"

#include "real_path.h"

#include <dirent.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static dev_t last_device;
static ino_t last_inode; /* 0: none yet */

bool
sg_left_lock(int fd)
{
  return flock(fd, LOCK_EX | LOCK_NB) == 0;
}

static bool
is_name(const char *name)
{
  size_t n = strlen(SG_LEFT_NAME);

  return strncmp(name, SG_LEFT_NAME, n) == 0 &&
         strspn(name + n, "abcdefghijklmnopqrstuvwxyz234567") ==
             SG_LEFT_LETTERS &&
         strcmp(name + n + SG_LEFT_LETTERS, SG_LEFT_ENDING) == 0;
}

/* Whoever held it does not any more: it is in its place, and this name is gone,
 * or that process has ended. */
static void
sweep(int folder, const char *name)
{
  int fd = openat(folder, name,
                  O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  struct stat st;

  if (fd >= 0 && fstat(fd, &st) == 0 && S_ISREG(st.st_mode) &&
      st.st_nlink == 1 && st.st_uid == geteuid() && sg_left_lock(fd)) {
    unlinkat(folder, name, 0);
  }
  if (fd >= 0) {
    close(fd);
  }
}

/* Is the open folder another one than the last? */
static bool
is_another(int fd)
{
  struct stat st;

  if (fstat(fd, &st) != 0) {
    return false;
  }
  pthread_mutex_lock(&lock);
  bool other = st.st_dev != last_device || st.st_ino != last_inode;
  last_device = st.st_dev;
  last_inode = st.st_ino;
  pthread_mutex_unlock(&lock);
  return other;
}

void
sg_left_swept(const char *path)
{
  char *name = sg_path_joined(path, sg_folder_length(path), ".", "");
  DIR *folder = name ? opendir(name) : NULL;
  struct dirent *e;

  free(name);
  if (folder && is_another(dirfd(folder))) {
    while ((e = readdir(folder))) {
      if (is_name(e->d_name)) {
        sweep(dirfd(folder), e->d_name);
      }
    }
  }
  if (folder) {
    closedir(folder);
  }
}
