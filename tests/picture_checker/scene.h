/* scene.h -- a scene to be drawn and its drawing, for the checker of pictures.
 *
 * Text, one item a line; numbers are rationals N or N/D. The model is seen
 * along the third row of three, which are at right angles, with the first to
 * the right and the second up; they need not be unit vectors in a parallel
 * picture.
 *
 *     parallel R1 R2 R3 U1 U2 U3 A1 A2 A3
 *     central R1 R2 R3 U1 U2 U3 A1 A2 A3 RHO
 *     t X1 Y1 Z1 X2 Y2 Z2 X3 Y3 Z3       a triangle that hides
 *     l S E X1 Y1 Z1 X2 Y2 Z2            a line to be drawn
 *     d S E FROM TO visible|hidden       a part of it that was drawn
 *     end NAME
 *
 * In a central picture the eye is RHO before the origin, and what is as near
 * as the nearest corner is as large as it is in the model.
 */
#ifndef SG_CHECKER_SCENE_H
#define SG_CHECKER_SCENE_H

#include "intervals.h"

#include <stdbool.h>
#include <stdio.h>

/* A point of the picture: x right, y up, z grows away from the eye. Lines and
 * planes of the model are lines and planes here. */
typedef struct place {
  mpq_t at[3];
  double near[3];
} place;

typedef struct triangle {
  place corner[3];
} triangle;

typedef struct line {
  int s, e;
  place end[2];
  double length;    /* in the picture */
  intervals hidden; /* to be found */
  intervals shown;  /* its gaps */
} line;

typedef struct part {
  size_t line;
  mpq_t from, to;
  bool hidden;
} part;

typedef struct scene {
  mpq_t row[3][3], rho;
  bool central;
  double size;     /* the largest of the coordinates at[] */
  double scale[2]; /* a unit of at[0], at[1] in units of the picture */
  triangle *triangle;
  line *line;
  part *part;
  size_t triangles, lines, parts;
  char name[200];
} scene;

/* Reads up to the next `end`. False: there is none. Ends the program with a
 * message where the text is not as above. Owner: scene_clear(). */
bool scene_read(scene *s, FILE *in);
void scene_clear(scene *s);

#endif
