/* intervals.c -- see intervals.h */
#include "intervals.h"

#include <stdlib.h>

void
intervals_init(intervals *set)
{
  *set = (intervals){0};
}

static void
shorten(intervals *set, size_t n)
{
  while (set->n > n) {
    set->n--;
    mpq_clear(set->at[set->n].from);
    mpq_clear(set->at[set->n].to);
  }
}

void
intervals_clear(intervals *set)
{
  shorten(set, 0);
  free(set->at);
  *set = (intervals){0};
}

void
intervals_add(intervals *set, const mpq_t from, const mpq_t to)
{
  if (mpq_cmp(from, to) >= 0) {
    return;
  }
  if (set->n == set->room) {
    set->room = set->room ? 2 * set->room : 8;
    set->at = realloc(set->at, set->room * sizeof *set->at);
    if (!set->at) {
      abort();
    }
  }
  mpq_init(set->at[set->n].from);
  mpq_init(set->at[set->n].to);
  mpq_set(set->at[set->n].from, from);
  mpq_set(set->at[set->n].to, to);
  set->n++;
}

static int
compare(const void *a, const void *b)
{
  const interval *x = a, *y = b;

  return mpq_cmp(x->from, y->from);
}

void
intervals_join(intervals *set)
{
  size_t last = 0;

  if (set->n == 0) {
    return;
  }
  qsort(set->at, set->n, sizeof *set->at, compare);
  for (size_t i = 1; i < set->n; i++) {
    if (mpq_cmp(set->at[i].from, set->at[last].to) > 0) {
      last++;
      mpq_swap(set->at[last].from, set->at[i].from);
      mpq_swap(set->at[last].to, set->at[i].to);
    } else if (mpq_cmp(set->at[i].to, set->at[last].to) > 0) {
      mpq_set(set->at[last].to, set->at[i].to);
    }
  }
  shorten(set, last + 1);
}

void
intervals_subtract(intervals *set, const mpq_t from, const mpq_t to)
{
  intervals left = {0};

  for (size_t i = 0; i < set->n; i++) {
    const interval *x = &set->at[i];
    if (mpq_cmp(x->to, from) <= 0 || mpq_cmp(x->from, to) >= 0) {
      intervals_add(&left, x->from, x->to);
    } else {
      intervals_add(&left, x->from, from);
      intervals_add(&left, to, x->to);
    }
  }
  intervals_clear(set);
  *set = left;
}

void
intervals_gaps(const intervals *set, intervals *gaps)
{
  mpq_t at, one;

  mpq_inits(at, one, NULL);
  mpq_set_ui(one, 1, 1);
  for (size_t i = 0; i < set->n; i++) {
    intervals_add(gaps, at, set->at[i].from);
    mpq_set(at, set->at[i].to);
  }
  intervals_add(gaps, at, one);
  mpq_clears(at, one, NULL);
}

double
intervals_common(const intervals *set, const mpq_t from, const mpq_t to)
{
  double sum = 0.0;
  mpq_t low, high;

  mpq_inits(low, high, NULL);
  for (size_t i = 0; i < set->n; i++) {
    const interval *x = &set->at[i];
    mpq_set(low, mpq_cmp(x->from, from) > 0 ? x->from : from);
    mpq_set(high, mpq_cmp(x->to, to) < 0 ? x->to : to);
    if (mpq_cmp(low, high) < 0) {
      mpq_sub(high, high, low);
      sum += mpq_get_d(high);
    }
  }
  mpq_clears(low, high, NULL);
  return sum;
}

double
intervals_length(const intervals *set)
{
  double sum = 0.0;
  mpq_t part;

  mpq_init(part);
  for (size_t i = 0; i < set->n; i++) {
    mpq_sub(part, set->at[i].to, set->at[i].from);
    sum += mpq_get_d(part);
  }
  mpq_clear(part);
  return sum;
}
