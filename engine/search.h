/* search.h -- THE binary search, and items in order.
 *
 * Layer: shared by the store and the kernels.
 */
#ifndef SG_SEARCH_H
#define SG_SEARCH_H

#include <stddef.h>
#include <stdint.h>

/* Sets `at`, a size_t, to the first place in from .. to - 1 for which `before`
 * is false, to `to` if it is true of all. `before` is an expression of `at`: it
 * is true of the first places and false of all that follow them.
 *
 *   SG_SEARCH(at, 0, n, row[at].id < id);
 *   found = at < n && row[at].id == id;
 */
#define SG_SEARCH(at, from, to, before)                                        \
  do {                                                                         \
    size_t sg_low_ = (from), sg_high_ = (to);                                  \
    while (sg_low_ < sg_high_) {                                               \
      (at) = sg_low_ + (sg_high_ - sg_low_) / 2;                               \
      if (before) {                                                            \
        sg_low_ = (at) + 1;                                                    \
      } else {                                                                 \
        sg_high_ = (at);                                                       \
      }                                                                        \
    }                                                                          \
    (at) = sg_low_;                                                            \
  } while (0)

/* Sorts n items of a type by insertion, equal ones as they stood: for a few.
 * `after` says of pointers `x` and `y` to two items whether *x stands after *y.
 *
 *   SG_SORT_FEW(row, all, n, x->id > y->id);
 */
#define SG_SORT_FEW(type, items, n, after)                                     \
  do {                                                                         \
    type *sg_item_ = (items);                                                  \
    for (size_t sg_i_ = 1; sg_i_ < (n); sg_i_++) {                             \
      type sg_kept_ = sg_item_[sg_i_];                                         \
      size_t sg_k_ = sg_i_;                                                    \
      for (; sg_k_ > 0; sg_k_--) {                                             \
        const type *x = &sg_item_[sg_k_ - 1], *y = &sg_kept_;                  \
        if (!(after)) {                                                        \
          break;                                                               \
        }                                                                      \
        sg_item_[sg_k_] = *x;                                                  \
      }                                                                        \
      sg_item_[sg_k_] = sg_kept_;                                              \
    }                                                                          \
  } while (0)

/* The place of the first of n records of `size` bytes whose id, with which each
 * begins, is not less than this one. The records ascend by it. */
static inline size_t
sg_first_id(const void *record, size_t n, size_t size, int32_t id)
{
  const char *first = record;
  size_t at;

  SG_SEARCH(at, 0, n, *(const int32_t *)(const void *)(first + at * size) < id);
  return at;
}

/* Defines an order for qsort() and bsearch(): int name(const void *, const void
 * *). Two items, *x and *y of a type, are ordered by the first of `by` in which
 * they differ: SG_BY() one after another.
 *
 *   SG_ORDER(compare_shells, shell, SG_BY(region) SG_BY(first));
 */
#define SG_ORDER(name, type, by)                                               \
  static int name(const void *sg_one_, const void *sg_other_)                  \
  {                                                                            \
    const type *x = sg_one_, *y = sg_other_;                                   \
    by return 0;                                                               \
  }                                                                            \
  _Static_assert(sizeof(type) > 0, "a type of items")

/* By a member, by the largest first, by an item of arrays, or by values. */
#define SG_BY(member)      SG_BY_FIRST(x->member, y->member)
#define SG_BY_MOST(member) SG_BY_FIRST(y->member, x->member)
#define SG_BY_AT(i)        SG_BY_FIRST(x[i], y[i])
#define SG_BY_FIRST(one, other)                                                \
  if ((one) != (other)) {                                                      \
    return (one) < (other) ? -1 : 1;                                           \
  }

/* Ascending, for qsort() and bsearch(): of int32_t, uint32_t, uint64_t. */
int sg_compare_ids(const void *a, const void *b);
int sg_compare_numbers(const void *a, const void *b);
int sg_compare_keys(const void *a, const void *b);
/* Sorts n ids and keeps each once; how many are left. */
size_t sg_sort_ids(int32_t *id, size_t n);
/* The place of an id among n ascending ones; SIZE_MAX: it has none. */
size_t sg_find_id(const int32_t *id, size_t n, int32_t wanted);

#endif
