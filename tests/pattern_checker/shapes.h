/* shapes.h -- is every polygon laid flat as it was, and is nothing missing? */
#ifndef SG_PATTERN_CHECKER_SHAPES_H
#define SG_PATTERN_CHECKER_SHAPES_H

#include "pattern.h"

typedef long double real;

typedef struct shape_faults {
  real shape;     /* the most a corner is off, next to the model's size */
  real bend;      /* the most a corner is off the plane of its polygon */
  real area;      /* the most an area is off, next to the size's square */
  real total;     /* the whole area's difference, next to the area */
  size_t turned;  /* polygons of the pattern seen from the inside */
  size_t missing; /* polygons that are not there or not all there */
} shape_faults;

/* The longest side of the box of the solid's points. */
real size_of_solid(const pattern *p);

/* The side of a square that is as large as all polygons of the pattern. */
real sheet_of(const pattern *p);

/* Twice the area of a polygon of the pattern, with its sign; and as a vector,
 * from the places in the solid. */
real flat_area(const pattern *p, const flat *f);
void solid_area(const pattern *p, const flat *f, real out[3]);

void check_shapes(const pattern *p, shape_faults *out);

/* Vectors. */
real dot(const real a[3], const real b[3]);
void cross(const real a[3], const real b[3], real out[3]);
real length(const real a[3]);

#endif
