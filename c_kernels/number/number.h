/* number.h -- reals as text: read correctly rounded, printed to read back.
 *
 * Layer: kernel. The locale of the process never matters.
 */
#ifndef SG_NUMBER_H
#define SG_NUMBER_H

#include <stddef.h>

typedef enum sg_number {
  SG_NUMBER_OK,
  SG_NUMBER_BAD,       /* not the text of a real */
  SG_NUMBER_NOT_FINITE /* nan, inf, or out of the range of double */
} sg_number;

enum { SG_NUMBER_SIZE = 32 }; /* bytes that sg_number_print() may need */

/* The double nearest to text[0..n-1]: sign, digits with an optional point,
 * optional exponent, and nothing else. Too small a value becomes 0; -0 becomes
 * 0. *digits (may be null) gets the number of significant digits written. */
sg_number sg_number_read(const char *text, size_t n, double *out, int *digits);

/* The shortest decimal that reads back as `x`, such as 0.1, -12 or 1e-20;
 * its length. Requires: x is finite. -0.0 prints as 0. */
size_t sg_number_print(double x, char out[SG_NUMBER_SIZE]);

#endif
