/* suspect.c -- sorted lists of what may be missing. */
#include "suspect.h"

#include "engine/search.h"
#include "list.h"
#include "search.h"

#include <stdlib.h>
#include <string.h>

bool
sg_suspect_gone(sg_suspects *x, int32_t s, int32_t id)
{
  if (!sg_list_grow(&x->gone, x->n, &x->room, sizeof *x->gone)) {
    return false;
  }
  x->gone[x->n++] = (sg_id_pair){s, id};
  return true;
}

SG_ORDER(compare_pairs, sg_id_pair, SG_BY(s) SG_BY(id));

static int32_t
least(int32_t a, int32_t b)
{
  return a < b ? a : b;
}

static int32_t
most(int32_t a, int32_t b)
{
  return a > b ? a : b;
}

static void
find_range(sg_suspects *x)
{
  bool any = x->all || x->ofs > 0;

  x->first_s = x->all ? INT32_MIN : INT32_MAX;
  x->last_s = x->all ? INT32_MAX : INT32_MIN;
  x->first_id = any ? INT32_MIN : INT32_MAX;
  x->last_id = any ? INT32_MAX : INT32_MIN;
  for (size_t i = 0; i < x->ofs; i++) {
    x->first_s = least(x->first_s, x->of[i]);
    x->last_s = most(x->last_s, x->of[i]);
  }
  for (size_t i = 0; i < x->n; i++) {
    x->first_s = least(x->first_s, x->gone[i].s);
    x->last_s = most(x->last_s, x->gone[i].s);
    x->first_id = least(x->first_id, x->gone[i].id);
    x->last_id = most(x->last_id, x->gone[i].id);
  }
}

void
sg_suspects_order(sg_suspects *x)
{
  size_t n = 0;

  if (x->n > 1) {
    qsort(x->gone, x->n, sizeof *x->gone, compare_pairs);
  }
  for (size_t i = 0; i < x->n; i++) {
    if (n == 0 || compare_pairs(&x->gone[n - 1], &x->gone[i]) != 0) {
      x->gone[n++] = x->gone[i];
    }
  }
  x->n = n;
  if (x->ofs > 1) {
    qsort(x->of, x->ofs, sizeof *x->of, sg_compare_ids);
  }
  find_range(x);
}

bool
sg_has_gone(const sg_suspects *x, int32_t s, int32_t id)
{
  sg_id_pair key = {s, id};

  return x->n > 0 && s >= x->gone[0].s && s <= x->gone[x->n - 1].s &&
         bsearch(&key, x->gone, x->n, sizeof key, compare_pairs);
}

bool
sg_may_concern(const sg_suspects *x, int32_t s)
{
  return x->all ||
         (x->n > 0 && s >= x->gone[0].s && s <= x->gone[x->n - 1].s) ||
         (x->ofs > 0 && bsearch(&s, x->of, x->ofs, sizeof s, sg_compare_ids));
}

void
sg_suspects_clear(sg_suspects *x)
{
  free(x->gone);
  free(x->of);
  free(x->row);
  *x = (sg_suspects){0};
}
