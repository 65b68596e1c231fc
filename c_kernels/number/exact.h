/* exact.h -- exact signs and exact points.
 *
 * Layer: kernel. Compiled with its own flags (no contraction, no fast-math):
 * a double filter decides almost always, GMP decides the rest and is counted.
 * Every function that returns a sign returns -1, 0 or +1 and is EXACT.
 * Coordinates are finite doubles (the caller checks).
 */
#ifndef SG_EXACT_H
#define SG_EXACT_H

#include <gmp.h>
#include <stdbool.h>
#include <stdint.h>

/* What a point is exactly, where doubles are not enough: its rationals, or what
 * made it until somebody asks for them. */
typedef struct sg_exactly sg_exactly;

/* A point: its nearest double position, and, only where that is not the point
 * itself, what it is. `exactly` null: the doubles ARE the point.
 * Owner: whoever made it calls sg_point_clear(), also of a copy. Copies share
 * `exactly`; any threads may ask them at once, and any may clear its own. */
typedef struct sg_point {
  double p[3];
  sg_exactly *exactly;
} sg_point;

/* The double nearest to q, which need not be canonical, ties to even; infinite
 * when out of range. */
double sg_nearest_double(mpq_srcptr q);

void sg_point_set(sg_point *out, const double p[3]);
/* False: out of the range of doubles, or no memory. */
bool sg_point_set_q(sg_point *out, mpq_srcptr x, mpq_srcptr y, mpq_srcptr z);
void sg_point_copy(sg_point *out, const sg_point *from);
void sg_point_clear(sg_point *point);

/* The three rationals of a point, made at the first call; null: the doubles are
 * the point. They live as long as a copy of it, and are not to be written. */
mpq_t *sg_point_q(const sg_point *point);

/* > 0 when d lies BELOW the plane abc, below being where a, b, c look
 * clockwise from: a=(0,0,0) b=(1,0,0) c=(0,1,0) d=(0,0,-1) gives +1. So for a
 * triangle counter-clockwise from outside, +1 is inside. */
int sg_orient3d(const double a[3], const double b[3], const double c[3],
                const double d[3]);

/* > 0 when a, b, c turn left: (0,0) (1,0) (0,1) gives +1. */
int sg_orient2d(const double a[2], const double b[2], const double c[2]);

/* The same for points, derived ones among them. */
int sg_point_orient3d(const sg_point *a, const sg_point *b, const sg_point *c,
                      const sg_point *d);

/* The turn a, b, c seen along coordinate axis `axis` (0 x, 1 y, 2 z) from its
 * positive end: axis 2 sees (x,y), 0 sees (y,z), 1 sees (z,x). */
int sg_point_turn(int axis, const sg_point *a, const sg_point *b,
                  const sg_point *c);

/* The order of a and b along the direction from -> to: -1 when a is first.
 * Compares (a - b) . (to - from). */
int sg_point_along(const sg_point *from, const sg_point *to, const sg_point *a,
                   const sg_point *b);

/* Sign of a's coordinate `axis` less b's. Equality of points: all three 0. */
int sg_point_compare(int axis, const sg_point *a, const sg_point *b);
bool sg_point_equal(const sg_point *a, const sg_point *b);

/* The point in which line a-b meets plane c,d,e. False: parallel, or no
 * memory. Exact (rational), its doubles correctly rounded. */
bool sg_point_lpi(sg_point *out, const sg_point *a, const sg_point *b,
                  const sg_point *c, const sg_point *d, const sg_point *e);

/* The point common to lines a-b and c-d, which lie in one plane whose dropped
 * axis is `axis`: found in that projection, carried on a-b. False: parallel. */
bool sg_point_ll(sg_point *out, int axis, const sg_point *a, const sg_point *b,
                 const sg_point *c, const sg_point *d);

/* The point common to three planes, each given by three points. */
bool sg_point_tpi(sg_point *out, const sg_point *const plane[3][3]);

/* The predicates whose falls back are counted. */
typedef enum sg_exact_question {
  SG_ASKED_ORIENT2D, /* sg_orient2d() */
  SG_ASKED_ORIENT3D, /* sg_orient3d() */
  SG_ASKED_TURN,     /* sg_point_turn() */
  SG_ASKED_SIDE,     /* sg_point_orient3d() */
  SG_ASKED_ALONG,    /* sg_point_along() */
  SG_ASKED_COMPARE,  /* sg_point_compare() */
  SG_EXACT_QUESTIONS
} sg_exact_question;

/* How often the filters of a predicate did not suffice and integers decided,
 * since the process started; of all of them. */
uint64_t sg_exact_fallbacks_of(sg_exact_question question);
uint64_t sg_exact_fallbacks(void);

#endif
