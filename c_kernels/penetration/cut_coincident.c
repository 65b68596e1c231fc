#include "cut_coincident.h"

#include "join/self_pair.h"

#include <stdlib.h>
#include <string.h>

enum { ASKED = 1 << 13 }; /* steps between questions */

/* Whether the corners of a triangle are quiet, asked for one other segment. */
typedef struct asked {
  uint32_t other; /* SG_NO_KEY: not asked yet */
  bool quiet;
} asked;

typedef struct finder {
  const sg_cut_model *model;
  const uint32_t (*pair)[2];
  size_t n;
  uint32_t *place;      /* [vertices]: equal where they are in one place */
  sg_key_table twin;    /* triangle, S of the other: it, or SEVERAL */
  sg_key_table valence; /* S, place -> its triangles there */
  sg_key_table twins;   /* S, S of the other, place -> those with a twin */
  asked *asked;         /* [triangles]: what was asked last */
  uint8_t *quiet;       /* [n]: first, whether a pair are twins */
  const sg_cancel *cancel;
  bool stopped;
} finder;

#define SEVERAL (UINT32_MAX - 1)

static bool
goes_on(finder *f, size_t i)
{
  f->stopped =
      f->stopped || (i % ASKED == ASKED - 1 && sg_cancelled(f->cancel));
  return !f->stopped;
}

static bool
number_places(finder *f)
{
  const sg_cut_model *m = f->model;
  sg_key_table known;
  bool good = (f->place = malloc((m->vertices + 1) * sizeof *f->place)) != NULL;

  sg_key_table_init(&known, 6);
  for (uint32_t v = 0; v < m->vertices && good && goes_on(f, v); v++) {
    double at[3];
    uint32_t key[6], *number;

    for (int k = 0; k < 3; k++) {
      at[k] = m->vertex[v].at[k] + 0.0; /* no -0.0 */
    }
    memcpy(key, at, sizeof key);
    if ((number = sg_key_table_put(&known, key))) {
      *number = *number == SG_NO_KEY ? v : *number;
      f->place[v] = *number;
    }
    good = number != NULL;
  }
  sg_key_table_clear(&known);
  return good && !f->stopped;
}

static uint32_t
place_of(const finder *f, uint32_t triangle, int k)
{
  return f->place[f->model->triangle[triangle].v[k]];
}

static bool
is_twin(const finder *f, uint32_t a, uint32_t b)
{
  for (int i = 0; i < 3; i++) {
    uint32_t at = place_of(f, a, i);
    if (at != place_of(f, b, 0) && at != place_of(f, b, 1) &&
        at != place_of(f, b, 2)) {
      return false;
    }
  }
  return true;
}

/* ---- twins ---- */

static bool
note_twin(finder *f, uint32_t a, uint32_t b)
{
  uint32_t key[2] = {a, (uint32_t)f->model->triangle[b].s};
  uint32_t *twin = sg_key_table_put(&f->twin, key);

  if (twin) {
    *twin = *twin == SG_NO_KEY || *twin == b ? b : SEVERAL;
  }
  return twin != NULL;
}

/* *any: there are some. */
static bool
find_twins(finder *f, bool *any)
{
  *any = false;
  for (size_t i = 0; i < f->n && goes_on(f, i); i++) {
    uint32_t a = f->pair[i][0], b = f->pair[i][1];

    f->quiet[i] =
        f->model->triangle[a].s != f->model->triangle[b].s && is_twin(f, a, b);
    if (!f->quiet[i]) {
      continue;
    }
    if (!note_twin(f, a, b) || !note_twin(f, b, a)) {
      return false;
    }
    *any = true;
  }
  return !f->stopped;
}

static uint32_t
twin_of(const finder *f, uint32_t a, int32_t s)
{
  return sg_key_table_get(&f->twin, (uint32_t[2]){a, (uint32_t)s});
}

/* ---- vertices ---- */

static bool
count(sg_key_table *table, const uint32_t *key)
{
  uint32_t *number = sg_key_table_put(table, key);

  if (number) {
    *number = *number == SG_NO_KEY ? 1 : *number + 1;
  }
  return number != NULL;
}

static bool
count_valences(finder *f)
{
  for (uint32_t t = 0; t < f->model->triangles && goes_on(f, t); t++) {
    for (int k = 0; k < 3; k++) {
      if (!count(&f->valence, (uint32_t[2]){(uint32_t)f->model->triangle[t].s,
                                            place_of(f, t, k)})) {
        return false;
      }
    }
  }
  return !f->stopped;
}

/* Each pair of twins, at the corners that both have, from either side. */
static bool
count_twins(finder *f)
{
  for (size_t i = 0; i < f->n && goes_on(f, i); i++) {
    uint32_t a = f->pair[i][0], b = f->pair[i][1];
    uint32_t s = (uint32_t)f->model->triangle[a].s;
    uint32_t other = (uint32_t)f->model->triangle[b].s;

    if (!f->quiet[i] || twin_of(f, a, (int32_t)other) != b ||
        twin_of(f, b, (int32_t)s) != a) {
      continue;
    }
    for (int k = 0; k < 3; k++) {
      uint32_t at = place_of(f, a, k);
      if (!count(&f->twins, (uint32_t[3]){s < other ? s : other,
                                          s < other ? other : s, at})) {
        return false;
      }
    }
  }
  return !f->stopped;
}

static bool
find_all_quiet(const finder *f, uint32_t triangle, uint32_t s, uint32_t other)
{
  for (int k = 0; k < 3; k++) {
    uint32_t at = place_of(f, triangle, k);
    uint32_t twins =
        sg_key_table_get(&f->twins, (uint32_t[3]){s < other ? s : other,
                                                  s < other ? other : s, at});

    if (twins == SG_NO_KEY ||
        twins != sg_key_table_get(&f->valence, (uint32_t[2]){s, at}) ||
        twins != sg_key_table_get(&f->valence, (uint32_t[2]){other, at})) {
      return false;
    }
  }
  return true;
}

/* The pairs of a triangle are mostly with one other segment. */
static bool
all_quiet(const finder *f, uint32_t triangle, uint32_t s, uint32_t other)
{
  asked *of = &f->asked[triangle];

  if (of->other != other) {
    *of = (asked){other, find_all_quiet(f, triangle, s, other)};
  }
  return of->quiet;
}

/* ---- pairs ---- */

/* Whether two have more in common than corners in one place and an edge. */
static bool
may_meet(const finder *f, uint32_t a, uint32_t b)
{
  sg_self_two two;

  sg_cut_model_corners(f->model, a, two.a);
  sg_cut_model_corners(f->model, b, two.b);
  for (int k = 0; k < 3; k++) {
    two.a_at[k] = place_of(f, a, k);
    two.b_at[k] = place_of(f, b, k);
  }
  return sg_self_may_meet(&two);
}

static bool
is_quiet(const finder *f, size_t i)
{
  uint32_t a = f->pair[i][0], b = f->pair[i][1];
  uint32_t s = (uint32_t)f->model->triangle[a].s;
  uint32_t other = (uint32_t)f->model->triangle[b].s;

  return s != other && all_quiet(f, a, s, other) && all_quiet(f, b, other, s) &&
         ((f->quiet[i] && twin_of(f, a, (int32_t)other) == b) ||
          !may_meet(f, a, b));
}

sg_sort_end
sg_cut_find_quiet(const sg_cut_model *model, const uint32_t (*pair)[2],
                  size_t n, uint8_t *quiet, const sg_cancel *cancel)
{
  finder f = {.model = model,
              .pair = pair,
              .n = n,
              .quiet = quiet,
              .asked = malloc((model->triangles + 1) * sizeof *f.asked),
              .cancel = cancel};
  bool any = false;

  sg_key_table_init(&f.twin, 2);
  sg_key_table_init(&f.valence, 2);
  sg_key_table_init(&f.twins, 3);
  for (size_t t = 0; f.asked && t < model->triangles; t++) {
    f.asked[t] = (asked){SG_NO_KEY, false};
  }
  bool good = f.asked && number_places(&f) && find_twins(&f, &any) &&
              (!any || (count_valences(&f) && count_twins(&f)));

  for (size_t i = 0; i < n && good && any && goes_on(&f, i); i++) {
    quiet[i] = is_quiet(&f, i);
  }
  free(f.place);
  free(f.asked);
  sg_key_table_clear(&f.twin);
  sg_key_table_clear(&f.valence);
  sg_key_table_clear(&f.twins);
  return good && !f.stopped ? SG_SORTED
         : f.stopped        ? SG_SORT_STOPPED
                            : SG_SORT_NO_MEMORY;
}
