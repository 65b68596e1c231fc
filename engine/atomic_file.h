/* atomic_file.h -- files that appear whole, several at once, or not at all.
 *
 * Layer: engine; no Prolog. A file is written without a name, so that nothing
 * of it stays whatever ends the process. When it is complete, it gets its own
 * if that is free, else one that nobody can guess, beside it, and the two
 * change places in one step. What a process that is killed just then leaves
 * there, the next commit in this folder takes away (left_over.h). Where the
 * file system has no files without a name (NFS), or there are many, it has the
 * first of these names while it is written, too. Errors are values of errno, 0
 * is success. Any thread may call any of these at any time.
 */
#ifndef SG_ATOMIC_FILE_H
#define SG_ATOMIC_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Opens for writing what `path` will be when sg_atomic_commit() has been given
 * *id; *fd is the caller's to close. The new file gets the owner, the mode and
 * the access list of the file that is there. Links are followed as open() does.
 * EISDIR: a folder; EACCES, EROFS, EPERM: it may not be written; ELOOP: links
 * in a circle, or somebody else's link in a folder that all may write;
 * ENOENT: there is no such
 * folder; EXDEV: neither a regular file nor a new one. */
int sg_atomic_open(const char *path, uint64_t *id, int *fd);

/* The same for a file that only this process reads, in the folder for temporary
 * files; it ends in `ending` and vanishes with sg_atomic_drop(). *path is its
 * name, to free(). */
int sg_atomic_scratch(const char *ending, uint64_t *id, char **path);

/* fsync() in parts: a process that is ended meanwhile waits for one of them. */
int sg_atomic_sync(int fd);

/* The names in the folder of a file last through a loss of power. */
void sg_atomic_sync_folder(const char *path);

/* Puts the n files, which are complete, in their places: all of them, and then
 * they are gone from here, or none. After an error (*failed is the number of
 * the file) what was there before is there again. A file with several hard
 * links, or whose owner cannot be kept, keeps its inode: its content is
 * replaced. */
int sg_atomic_commit(const uint64_t *id, size_t n, size_t *failed);

/* Forgets the file; what was written of it vanishes. */
void sg_atomic_drop(uint64_t id);

/* The same for all there are, and nothing is committed from now on: the process
 * is about to be ended from outside. Waits for a commit that is under way. */
void sg_atomic_end(void);

/* False where SANGGWAN_SYNC=no is in the environment: files need not last
 * through a loss of power, for who asked for them finds out (a batch). */
bool sg_atomic_syncs(void);

#endif
