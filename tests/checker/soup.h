/* soup.h -- a mesh file as triangles, for the checker of results. */
#ifndef SG_CHECKER_SOUP_H
#define SG_CHECKER_SOUP_H

#include <stdbool.h>
#include <stddef.h>

typedef struct soup {
  double (*point)[3]; /* [points] */
  int (*corner)[3];   /* [triangles]: points, counter-clockwise from outside */
  size_t points, triangles;
  size_t faces;   /* of the file: polygons */
  size_t unclear; /* polygons that are no simple outline seen along an axis */
} soup;

/* Reads an OFF file (faces of any number of corners, cut into ears) or an STL
 * file, binary or text. False: *problem says why. Owner: soup_clear(). */
bool soup_read(soup *s, const char *file, const char **problem);

/* Makes points in one place one point; the others stay, unused. */
void soup_merge(soup *s);

void soup_clear(soup *s);

#endif
