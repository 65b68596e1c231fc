/* intervals.h -- sets of intervals of rationals, for the checker of pictures.
 *
 * A set is a sorted list of intervals with gaps between them; single points
 * are dropped. Exact.
 */
#ifndef SG_CHECKER_INTERVALS_H
#define SG_CHECKER_INTERVALS_H

#include <gmp.h>
#include <stddef.h>

typedef struct interval {
  mpq_t from, to;
} interval;

typedef struct intervals {
  interval *at; /* sorted once intervals_join() has been called */
  size_t n, room;
} intervals;

void intervals_init(intervals *set);
void intervals_clear(intervals *set);

/* Appends from-to, if from < to. */
void intervals_add(intervals *set, const mpq_t from, const mpq_t to);

/* Sorts what was appended and joins what overlaps or touches. */
void intervals_join(intervals *set);

/* Takes from-to away from a joined set. */
void intervals_subtract(intervals *set, const mpq_t from, const mpq_t to);

/* The gaps of a joined set between 0 and 1, appended to an empty one. */
void intervals_gaps(const intervals *set, intervals *gaps);

/* The length of what a joined set and from-to have in common. */
double intervals_common(const intervals *set, const mpq_t from, const mpq_t to);

/* The length of a joined set. */
double intervals_length(const intervals *set);

#endif
