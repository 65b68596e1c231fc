/* quadric.h -- how far a point is from many planes: a sum of squares.
 *
 * Layer: kernel. Garland and Heckbert, Surface Simplification Using Quadric
 * Error Metrics, SIGGRAPH 1997. Rounded; best in coordinates of size one.
 */
#ifndef SG_QUADRIC_H
#define SG_QUADRIC_H

enum { SG_QUADRIC = 10 };

/* The symmetric 4 x 4 matrix of a sum of planes, by rows; and the area that it
 * is of, which its user counts. Starts as zeros. */
typedef struct sg_quadric {
  double at[SG_QUADRIC], area;
} sg_quadric;

/* The plane through p with the normal n, of length one. */
void sg_quadric_add_plane(sg_quadric *q, const double n[3], const double p[3],
                          double weight);
/* Also its area. */
void sg_quadric_add(sg_quadric *to, const sg_quadric *q);

/* The weights times the squares of the distances of p, summed; 0 or more. */
double sg_quadric_value(const sg_quadric *q, const double p[3]);

/* The place of the least value, drawn a little to `near`, so that there is one
 * on a plane or a line too. */
void sg_quadric_least(const sg_quadric *q, const double near[3], double out[3]);

#endif
