/* left_over.h -- files that a process which was killed left behind.
 *
 * Layer: engine; no Prolog. A file that is to take the place of another one has
 * a name of its own for a moment. Whoever made it holds a lock on it from
 * before it has that name: a file of such a name that can be locked is of
 * nobody any more. Any thread may call these at any time.
 */
#ifndef SG_LEFT_OVER_H
#define SG_LEFT_OVER_H

#include <stdbool.h>

/* A name: this, letters and digits, and, if the file is locked, the ending. */
#define SG_LEFT_NAME   ".sanggwan-"
#define SG_LEFT_ENDING "~"
enum { SG_LEFT_LETTERS = 12 };

/* Locks the file, which has no name yet, as long as a descriptor of it is open;
 * false: its file system has no locks. */
bool sg_left_lock(int fd);

/* Takes such files out of the folder of `path`: those of this user that have
 * one name, and that nobody holds. A process looks once, and again if the
 * folder is another one than the last. */
void sg_left_swept(const char *path);

#endif
