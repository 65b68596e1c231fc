#include "by_segment.h"
#include "engine/list.h"

#include "engine/search.h"

#include <stdlib.h>
#include <string.h>

/* ---- rows of segments ---- */

/* `n` live rows one after another, of wanted[which]. */
typedef struct run {
  size_t which;
  uint32_t row, n;
} run;

typedef struct walk {
  const int32_t *wanted;
  size_t segments;
  size_t which; /* of the row before; `segments`: not wanted */
  int32_t s;    /* of the row before, 0: none */
  run *run;
  size_t runs, room;
  bool failed;
  bool without; /* a view shows the other segments */
} walk;

static void
add_rows(walk *w, uint32_t row, uint32_t n)
{
  run *last = w->runs ? &w->run[w->runs - 1] : NULL;

  if (w->which == w->segments || w->failed) {
    return;
  }
  if (last && last->which == w->which && last->row + last->n == row) {
    last->n += n;
    return;
  }
  if (!sg_list_grow(&w->run, w->runs, &w->room, sizeof *w->run)) {
    w->failed = true;
    return;
  }
  w->run[w->runs++] = (run){w->which, row, n};
}

static void
see_segment(walk *w, int32_t s)
{
  if (s != w->s) {
    w->s = s;
    size_t which = sg_find_id(w->wanted, w->segments, s);

    w->which = which == SIZE_MAX ? w->segments : which;
  }
}

static bool
all_are(const int32_t *s, int32_t value)
{
  int32_t differ = 0;

  for (unsigned i = 0; i < 64; i++) {
    differ |= s[i] ^ value;
  }
  return differ == 0;
}

/* The live rows of a page, 64 at a time where all are of one segment. */
static void
walk_page(walk *w, const uint64_t *live, const int32_t *s, uint32_t first)
{
  for (unsigned word = 0; word < SG_LIVE_WORDS; word++) {
    uint64_t bits = live[word];

    if (bits == 0) {
      continue;
    }
    const int32_t *here = s + word * 64;
    uint32_t row = first + word * 64;

    if (bits == UINT64_MAX && all_are(here, here[0])) {
      see_segment(w, here[0]);
      add_rows(w, row, 64);
      continue;
    }
    for (; bits; bits &= bits - 1) {
      unsigned bit = (unsigned)__builtin_ctzll(bits);

      see_segment(w, here[bit]);
      add_rows(w, row + bit, 1);
    }
  }
}

/* The runs, put out by segment. */
static bool
spread_runs(const walk *w, sg_segment_rows *out)
{
  size_t n = w->segments;
  size_t *next;

  out->begin = calloc(n + 2, sizeof *out->begin);
  if (!out->begin) {
    return false;
  }
  next = out->begin + 1; /* next[i] ends as begin[i + 1] */
  for (size_t k = 0; k < w->runs; k++) {
    next[w->run[k].which + 1] += w->run[k].n;
  }
  for (size_t i = 0; i < n; i++) {
    next[i + 1] += next[i];
  }
  out->row = malloc((next[n] + 1) * sizeof *out->row);
  if (!out->row) {
    return false;
  }
  for (size_t k = 0; k < w->runs; k++) {
    for (uint32_t i = 0; i < w->run[k].n; i++) {
      out->row[next[w->run[k].which]++] = w->run[k].row + i;
    }
  }
  return true;
}

/* False: no row of a wanted segment is on the page. */
static bool
may_have(const sg_view *view, size_t page, const walk *w)
{
  size_t at = view->span ? sg_first_id(w->wanted, w->segments,
                                       sizeof *w->wanted, view->span[page][0])
                         : 0;

  return view->live[page] != view->none &&
         (!view->span ||
          (at < w->segments && w->wanted[at] <= view->span[page][1]));
}

bool
sg_segment_rows_find(const sg_view *view, const int32_t *wanted, size_t n,
                     const sg_cancel *cancel, sg_segment_rows *out)
{
  walk w = {.wanted = wanted, .segments = n, .which = n};
  bool good = true;

  *out = (sg_segment_rows){0};
  for (size_t page = 0; page < view->pages && good; page++) {
    if (!may_have(view, page, &w)) {
      continue;
    }
    walk_page(&w, view->live[page], view->column[0].page[page].i,
              (uint32_t)page * SG_PAGE_ROWS);
    good = !w.failed && !(page % 64 == 63 && sg_cancelled(cancel));
  }
  good = good && spread_runs(&w, out);
  free(w.run);
  return good;
}

void
sg_segment_rows_clear(sg_segment_rows *rows)
{
  free(rows->begin);
  free(rows->row);
  *rows = (sg_segment_rows){0};
}

/* ---- a view of segments ---- */

static bool
is_shown(const walk *w)
{
  return (w->which < w->segments) != w->without;
}

/* Which of 64 rows, some of which live, are of wanted segments. The others may
 * be written meanwhile. */
static uint64_t
wanted_bits(walk *w, uint64_t live, const int32_t *s)
{
  int32_t first = s[__builtin_ctzll(live)];
  uint64_t bits = 0;

  if (all_are(s, first)) {
    see_segment(w, first);
    return is_shown(w) ? live : 0;
  }
  for (uint64_t left = live; left; left &= left - 1) {
    unsigned bit = (unsigned)__builtin_ctzll(left);

    see_segment(w, s[bit]);
    bits |= (uint64_t)is_shown(w) << bit;
  }
  return bits;
}

/* Of the live rows of a page those of wanted segments. */
static void
want_page(walk *w, const sg_view *view, size_t page, uint64_t *out)
{
  for (size_t k = 0; k < SG_LIVE_WORDS; k++) {
    uint64_t bits = view->live[page][k];

    out[k] =
        bits ? wanted_bits(w, bits, view->column[0].page[page].i + k * 64) : 0;
  }
}

static bool
make_view(const sg_view *view, walk w, sg_view *out)
{
  const uint64_t **live = malloc((view->pages + 1) * sizeof *live);
  size_t lived = 0; /* pages with rows that are looked at */

  for (size_t page = 0; page < view->pages; page++) {
    lived += may_have(view, page, &w);
  }
  uint64_t *word = malloc((lived + 1) * SG_LIVE_WORDS * sizeof *word);

  *out = *view;
  out->live = live;
  if (!live || !word) {
    free(live);
    free(word);
    out->live = NULL;
    return false;
  }
  live[view->pages] = word; /* so that it can be freed */
  for (size_t page = 0; page < view->pages; page++) {
    live[page] = w.without ? view->live[page] : view->none;
    if (may_have(view, page, &w)) {
      want_page(&w, view, page, word);
      live[page] = word;
      word += SG_LIVE_WORDS;
    }
  }
  return true;
}

bool
sg_segment_view_make(const sg_view *view, const int32_t *wanted, size_t n,
                     sg_view *out)
{
  walk w = {.wanted = wanted, .segments = n, .which = n};

  return make_view(view, w, out);
}

bool
sg_segment_view_without(const sg_view *view, const int32_t *unwanted, size_t n,
                        sg_view *out)
{
  walk w = {.wanted = unwanted, .segments = n, .which = n, .without = true};

  return make_view(view, w, out);
}

void
sg_segment_view_clear(sg_view *view)
{
  if (view->live) {
    free((uint64_t *)view->live[view->pages]);
    free((const uint64_t **)view->live);
  }
  *view = (sg_view){0};
}

/* ---- rows by id ---- */

typedef struct id_row {
  int32_t id; /* the first: sg_compare_ids() */
  uint32_t row;
} id_row;

static bool
make_flat(const sg_view *view, const uint32_t *row, size_t n, sg_id_rows *out)
{
  out->row = malloc((out->places + 1) * sizeof *out->row);
  if (!out->row) {
    return false;
  }
  memset(out->row, 0xff, out->places * sizeof *out->row);
  for (size_t i = 0; i < n; i++) {
    out->row[sg_view_int(view, 1, row[i]) - out->first] = row[i];
  }
  return true;
}

static bool
make_sorted(const sg_view *view, const uint32_t *row, size_t n, sg_id_rows *out)
{
  id_row *pair = malloc(n * sizeof *pair);

  out->places = n;
  out->row = malloc(n * sizeof *out->row);
  out->id = malloc(n * sizeof *out->id);
  if (!pair || !out->row || !out->id) {
    free(pair);
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    pair[i] = (id_row){sg_view_int(view, 1, row[i]), row[i]};
  }
  qsort(pair, n, sizeof *pair, sg_compare_ids);
  for (size_t i = 0; i < n; i++) {
    out->id[i] = pair[i].id;
    out->row[i] = pair[i].row;
  }
  free(pair);
  return true;
}

bool
sg_id_rows_make(const sg_view *view, const uint32_t *row, size_t n,
                sg_id_rows *out)
{
  int32_t last = 0;

  *out = (sg_id_rows){0};
  if (n == 0) {
    return true;
  }
  out->first = last = sg_view_int(view, 1, row[0]);
  for (size_t i = 1; i < n; i++) {
    int32_t id = sg_view_int(view, 1, row[i]);
    out->first = id < out->first ? id : out->first;
    last = id > last ? id : last;
  }
  out->places = (size_t)(last - out->first) + 1;
  return out->places <= 4 * n + 64 ? make_flat(view, row, n, out)
                                   : make_sorted(view, row, n, out);
}

void
sg_id_rows_clear(sg_id_rows *table)
{
  free(table->row);
  free(table->id);
  *table = (sg_id_rows){0};
}

size_t
sg_id_rows_bytes(const sg_id_rows *table)
{
  return table->places *
         (sizeof *table->row + (table->id ? sizeof *table->id : 0));
}

size_t
sg_id_rows_search(const sg_id_rows *table, int32_t id)
{
  size_t place = sg_find_id(table->id, table->places, id);

  return place < table->places ? place : SG_NO_ID_PLACE;
}
