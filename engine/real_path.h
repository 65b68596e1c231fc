/* real_path.h -- where a file is, or is to be.
 *
 * Layer: engine; no Prolog. Errors are values of errno, 0 is success.
 */
#ifndef SG_REAL_PATH_H
#define SG_REAL_PATH_H

#include <stddef.h>
#include <sys/stat.h>

/* The folder of `path` with the slash, or nothing of it. */
size_t sg_folder_length(const char *path);

/* The first n bytes of a, then b and c, to free(); null: no memory. */
char *sg_path_joined(const char *a, size_t n, const char *b, const char *c);

/* Follows links to what is there, or is to be: *out, to free(). *st: with
 * st_nlink 0 if there is nothing. ELOOP: they go round; EACCES: somebody else's
 * link in a folder where all may make one. */
int sg_real_path(const char *path, char **out, struct stat *st);

/* *path, which is replaced, with the folder's own name, from the root: it stays
 * right wherever the process goes. */
int sg_path_settled(char **path);

#endif
