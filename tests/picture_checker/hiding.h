/* hiding.h -- which part of a line is hidden, by definition.
 *
 * A point of a line is hidden if some triangle is there in the picture, its
 * border included, and truly nearer to the eye (by more than 1e-12
 * of the size, across its plane). Triangles seen edge-on hide
 * nothing. Every line against every triangle; exact.
 */
#ifndef SG_CHECKER_HIDING_H
#define SG_CHECKER_HIDING_H

#include "scene.h"

/* Finds what is hidden and what is shown of every line of the scene. */
void hiding_find(scene *s);

/* True if the two lines are on one line of the picture; size: of the scene. */
bool hiding_in_line(const line *a, const line *b, double size);

/* Where the point at t of line b, which is in line with a, is on a. */
void hiding_moved(const line *a, const line *b, const mpq_t t, mpq_t out);

#endif
