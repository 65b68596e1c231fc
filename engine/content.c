/* content.c -- see content.h. */
#include "content.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

enum { BLOCK = 1 << 16 };

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

int
sg_content_replace(const char *own, const char *to)
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
