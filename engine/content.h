/* content.h -- the content of one file becomes that of another.
 *
 * Layer: engine; no Prolog. Errors are values of errno, 0 is success.
 */
#ifndef SG_CONTENT_H
#define SG_CONTENT_H

/* The file `to`, which is there, gets the content of the file `own`, and lasts
 * through a loss of power. Without room for all of it nothing is changed. */
int sg_content_replace(const char *own, const char *to);

#endif
