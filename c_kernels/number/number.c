/* number.c -- see number.h. Most numbers take an exact short way; the others
 * go through the C library, held to the "C" locale. */
#include "number.h"

#include <ctype.h>
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum {
  MAX_TEXT = 1024,  /* longer texts are no numbers */
  EXACT_POWER = 22, /* the largest power of ten that is a double */
  MANTISSA_DIGITS = 19
};

#define EXACT_INTEGER 9007199254740992.0 /* 2^53 */

static const double power10[EXACT_POWER + 1] = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

static locale_t c_locale;
static pthread_once_t c_locale_once = PTHREAD_ONCE_INIT;

static void
open_c_locale(void)
{
  c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
}

/* A number as its text says it: mantissa * 10^exponent. */
typedef struct sg_decimal {
  bool negative;
  bool cut; /* digits beyond MANTISSA_DIGITS were left out */
  uint64_t mantissa;
  long exponent;
  int digits; /* significant ones, as written */
} sg_decimal;

/* Takes the digits at *at; `scale` is -1 behind the point, else 0. True if
 * there was any. */
static bool
scan_digits(const char **at, const char *end, int scale, sg_decimal *d)
{
  const char *p = *at;

  for (; p < end && *p >= '0' && *p <= '9'; p++) {
    if (d->digits || *p != '0') {
      d->digits++;
    }
    if (d->digits <= MANTISSA_DIGITS) {
      d->mantissa = 10 * d->mantissa + (uint64_t)(*p - '0');
      d->exponent += scale;
    } else {
      d->cut = true;
      d->exponent += scale + 1;
    }
  }
  bool any = p > *at;
  *at = p;
  return any;
}

static bool
scan_exponent(const char **at, const char *end, sg_decimal *d)
{
  const char *p = *at + 1;
  bool negative = p < end && *p == '-';
  long e = 0;

  if (p < end && (*p == '-' || *p == '+')) {
    p++;
  }
  if (p == end) {
    return false;
  }
  for (; p < end; p++) {
    if (*p < '0' || *p > '9') {
      return false;
    }
    if (e < 100000) {
      e = 10 * e + (*p - '0');
    }
  }
  d->exponent += negative ? -e : e;
  *at = p;
  return true;
}

static bool
scan(const char *at, const char *end, sg_decimal *d)
{
  *d = (sg_decimal){0};
  if (at < end && (*at == '-' || *at == '+')) {
    d->negative = *at++ == '-';
  }
  bool any = scan_digits(&at, end, 0, d);
  if (at < end && *at == '.') {
    at++;
    any = scan_digits(&at, end, -1, d) || any;
  }
  if (any && at < end && (*at == 'e' || *at == 'E')) {
    return scan_exponent(&at, end, d);
  }
  return any && at == end;
}

/* nan, inf, infinity in any case and with any sign or tail, as printf writes
 * them in one system or another. */
static bool
names_no_number(const char *text, size_t n)
{
  if (n && (*text == '-' || *text == '+')) {
    text++;
    n--;
  }
  return (n >= 3 &&
          (!strncasecmp(text, "nan", 3) || !strncasecmp(text, "inf", 3))) ||
         (n >= 4 && !strncmp(text, "1.#", 3));
}

static double
read_slowly(const char *text, size_t n)
{
  char copy[MAX_TEXT + 1];

  pthread_once(&c_locale_once, open_c_locale);
  memcpy(copy, text, n);
  copy[n] = '\0';
  return strtod_l(copy, NULL, c_locale);
}

sg_number
sg_number_read(const char *text, size_t n, double *out, int *digits)
{
  sg_decimal d;

  if (n > MAX_TEXT || !scan(text, text + n, &d)) {
    return names_no_number(text, n) ? SG_NUMBER_NOT_FINITE : SG_NUMBER_BAD;
  }
  if (digits) {
    *digits = d.digits;
  }
  double m = (double)d.mantissa;
  if (!d.cut && m <= EXACT_INTEGER && labs(d.exponent) <= EXACT_POWER) {
    /* Both operands are exact, so one rounding gives the nearest double. */
    m = d.exponent < 0 ? m / power10[-d.exponent] : m * power10[d.exponent];
    *out = (d.negative ? -m : m) + 0.0;
    return SG_NUMBER_OK;
  }
  double x = read_slowly(text, n) + 0.0;
  if (!isfinite(x)) {
    return SG_NUMBER_NOT_FINITE;
  }
  *out = x;
  return SG_NUMBER_OK;
}

/* Writes m / 10^places, m > 0; its length. */
static size_t
print_fixed(uint64_t m, int places, bool negative, char *out)
{
  char digits[24];
  int n = 0;
  size_t length = 0;

  while (m || n <= places) {
    digits[n++] = (char)('0' + m % 10);
    m /= 10;
  }
  if (negative) {
    out[length++] = '-';
  }
  while (n) {
    out[length++] = digits[--n];
    if (n == places && n) {
      out[length++] = '.';
    }
  }
  out[length] = '\0';
  return length;
}

static size_t
print_slowly(double x, char *out)
{
  pthread_once(&c_locale_once, open_c_locale);
  locale_t before = uselocale(c_locale);
  int n = 0;
  for (int precision = 15; precision <= 17; precision++) {
    n = snprintf(out, SG_NUMBER_SIZE, "%.*g", precision, x);
    if (strtod_l(out, NULL, c_locale) == x) {
      break;
    }
  }
  uselocale(before);
  return (size_t)n;
}

size_t
sg_number_print(double x, char out[SG_NUMBER_SIZE])
{
  double a = fabs(x);

  if (a == 0.0) {
    return print_fixed(0, 0, false, out);
  }
  if (a >= 1e-5 && a < 1e15) {
    for (int places = 0; places <= 15; places++) {
      double m = nearbyint(a * power10[places]);
      if (m >= 1e16) {
        break;
      }
      if (m < EXACT_INTEGER && m / power10[places] == a) {
        return print_fixed((uint64_t)m, places, x < 0, out);
      }
    }
  }
  return print_slowly(x, out);
}
