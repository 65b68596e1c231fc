/* sort.c -- see sort.h. Runs by qsort(), then merged two by two; numbers by
 * their digits, the last one first. */
#include "sort.h"

#include <stdlib.h>
#include <string.h>

enum { RUN = 4096 };

typedef struct job {
  char *from, *to; /* merging goes from one array to the other */
  size_t n, size;
  sg_sort_compare *compare;
} job;

static bool
is_sorted(const char *base, size_t n, size_t size, sg_sort_compare *compare)
{
  for (size_t i = 1; i < n; i++) {
    if (compare(base + (i - 1) * size, base + i * size) > 0) {
      return false;
    }
  }
  return true;
}

static size_t
least(size_t a, size_t b)
{
  return a < b ? a : b;
}

/* Merges the two runs of `run` records that begin at `at`. */
static void
merge(const job *j, size_t at, size_t run)
{
  size_t middle = least(at + run, j->n), end = least(at + 2 * run, j->n);
  size_t a = at, b = middle;

  for (size_t k = at; k < end; k++) {
    bool first =
        a < middle && (b == end || j->compare(j->from + a * j->size,
                                              j->from + b * j->size) <= 0);
    memcpy(j->to + k * j->size, j->from + (first ? a++ : b++) * j->size,
           j->size);
  }
}

/* False: stopped, with every record in j->from. */
static bool
merge_all(job *j, const sg_cancel *cancel)
{
  for (size_t run = RUN; run < j->n; run *= 2) {
    char *swap = j->from;
    for (size_t at = 0; at < j->n; at += 2 * run) {
      if (sg_cancelled(cancel)) {
        return false;
      }
      merge(j, at, run);
    }
    j->from = j->to;
    j->to = swap;
  }
  return true;
}

sg_sort_end
sg_sort(void *base, size_t n, size_t size, sg_sort_compare *compare,
        const sg_cancel *cancel)
{
  job j = {base, NULL, n, size, compare};
  bool done;

  if (n < 2 || is_sorted(base, n, size, compare)) {
    return SG_SORTED;
  }
  for (size_t at = 0; at < n; at += RUN) {
    if (sg_cancelled(cancel)) {
      return SG_SORT_STOPPED;
    }
    qsort(j.from + at * size, least(RUN, n - at), size, compare);
  }
  if (n <= RUN) {
    return SG_SORTED;
  }
  j.to = malloc(n * size);
  if (!j.to) {
    return SG_SORT_NO_MEMORY;
  }
  done = merge_all(&j, cancel);
  if (j.from != base) {
    memcpy(base, j.from, n * size);
  }
  free(j.from == base ? j.to : j.from);
  return done ? SG_SORTED : SG_SORT_STOPPED;
}

/* ---- numbers ---- */

enum { DIGIT_BITS = 8, DIGITS = 8, VALUES = 1 << DIGIT_BITS };

/* Unsigned integers in the order of the doubles. */
static uint64_t
ordered_bits(double value)
{
  const uint64_t sign = UINT64_C(1) << 63;
  uint64_t bits;

  memcpy(&bits, &value, sizeof bits);
  return bits & sign ? ~bits : bits | sign;
}

static unsigned
digit_of(const sg_measured *item, unsigned digit)
{
  return (unsigned)(ordered_bits(item->value) >> digit * DIGIT_BITS) &
         (VALUES - 1);
}

/* From `item` to `out`, in the order of one digit. False: all have the same,
 * and nothing was moved. */
static bool
spread_digit(const sg_measured *item, size_t n, unsigned digit,
             sg_measured *out)
{
  size_t first[VALUES] = {0}, next = 0;

  for (size_t i = 0; i < n; i++) {
    first[digit_of(&item[i], digit)]++;
  }
  if (first[digit_of(&item[0], digit)] == n) {
    return false;
  }
  for (size_t k = 0; k < VALUES; k++) {
    size_t count = first[k];
    first[k] = next;
    next += count;
  }
  for (size_t i = 0; i < n; i++) {
    out[first[digit_of(&item[i], digit)]++] = item[i];
  }
  return true;
}

sg_sort_end
sg_sort_measured(sg_measured *item, size_t n, const sg_cancel *cancel)
{
  bool stopped = false;
  sg_measured *spare = malloc((n + 1) * sizeof *spare);
  sg_measured *from = item, *to = spare;

  if (!spare) {
    return SG_SORT_NO_MEMORY;
  }
  for (size_t i = 0; i < n; i++) {
    item[i].value += 0.0; /* no -0.0 */
  }
  for (unsigned digit = 0; n > 0 && digit < DIGITS && !stopped; digit++) {
    if (spread_digit(from, n, digit, to)) {
      sg_measured *full = to;
      to = from;
      from = full;
    }
    stopped = sg_cancelled(cancel);
  }
  if (from != item) {
    memcpy(item, from, n * sizeof *item);
  }
  free(spare);
  return stopped ? SG_SORT_STOPPED : SG_SORTED;
}

/* --------------------------------------------------------------- keys */

enum { UPPER_BITS = 11, UPPER_DIGITS = 1 << UPPER_BITS };

bool
sg_sort_upper(uint64_t *key, size_t n)
{
  uint64_t *spare = malloc((n + 1) * sizeof *spare), *from = key, *to = spare;
  size_t(*begin)[UPPER_DIGITS + 1] = calloc(3, sizeof *begin);
  bool good = spare && begin;

  for (size_t i = 0; good && i < n; i++) {
    for (unsigned k = 0; k < 3; k++) {
      begin[k][(from[i] >> (32 + k * UPPER_BITS) & (UPPER_DIGITS - 1)) + 1]++;
    }
  }
  for (unsigned k = 0; good && k < 3; k++) {
    uint64_t *swap = from;
    unsigned any = n > 0 ? (unsigned)(from[0] >> (32 + k * UPPER_BITS)) : 0;
    if (begin[k][(any & (UPPER_DIGITS - 1)) + 1] == n) {
      continue; /* all have the same */
    }
    for (size_t d = 0; d < UPPER_DIGITS; d++) {
      begin[k][d + 1] += begin[k][d];
    }
    for (size_t i = 0; i < n; i++) {
      to[begin[k][from[i] >> (32 + k * UPPER_BITS) & (UPPER_DIGITS - 1)]++] =
          from[i];
    }
    from = to;
    to = swap;
  }
  if (from != key) {
    memcpy(key, from, n * sizeof *key);
  }
  free(spare);
  free(begin);
  return good;
}
