/* real_path.c -- see real_path.h. */
#include "real_path.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_LINKS = 40, BLOCK = 1 << 16 };

/* The folder of `path` with the slash, or "". */
size_t
sg_folder_length(const char *path)
{
  const char *slash = strrchr(path, '/');

  return slash ? (size_t)(slash - path) + 1 : 0;
}

/* The first n bytes of a, then b and c; null: no memory. */
char *
sg_path_joined(const char *a, size_t n, const char *b, const char *c)
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
  char *folder = sg_path_joined(path, sg_folder_length(path), ".", "");
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
  *out = sg_path_joined(path, text[0] == '/' ? 0 : sg_folder_length(path), text,
                        "");
  return *out ? 0 : ENOMEM;
}

/* Follows links to what is there, or is to be. *st: with st_nlink 0 if there is
 * nothing. */
int
sg_real_path(const char *path, char **out, struct stat *st)
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
int
sg_path_settled(char **path)
{
  size_t n = sg_folder_length(*path);
  char *folder = sg_path_joined(*path, n, ".", "");
  char *real = folder ? realpath(folder, NULL) : NULL;
  int error = real ? 0 : errno;
  char *at = real ? sg_path_joined(real, strlen(real), "/", *path + n) : NULL;

  free(folder);
  free(real);
  if (at) {
    free(*path);
    *path = at;
  }
  return at || error ? error : ENOMEM;
}
