/* travel_rows.c -- travel_open/7, travel_numbers/4. */
#include "stroke_rows.h"
#include "travel.h"

#include <stdlib.h>
#include <string.h>

/* The object of a handle: line numbers in their order, below zero backwards. */
struct sg_travel {
  int32_t *order;
  size_t n;
};

void
sg_travel_close(sg_travel *travel)
{
  free(travel->order);
  free(travel);
}

/* Lines that a pen has to draw. */
typedef struct lines {
  sg_travel_line *at;
  size_t n;
} lines;

static size_t
count_lines(const sg_travelled_strokes_list *strokes)
{
  size_t n = 0;

  for (size_t i = 0; i < strokes->n; i++) {
    const sg_travelled_strokes *k = &strokes->at[i];

    n += k->is == SG_TRAVELLED_STROKES_STROKES
             ? k->strokes.to - k->strokes.from + 1
             : 1;
  }
  return n;
}

static bool
add_stroke(sg_call *call, const sg_sheet_point_list *points, lines *out)
{
  sg_travel_line *line = &out->at[out->n++];

  return points->n == 0
             ? sg_call_domain(call, "stroke", 3)
             : sg_sheet_point_at(call, &points->at[0], line->at[0]) &&
                   sg_sheet_point_at(call, &points->at[points->n - 1],
                                     line->at[1]);
}

static void
add_chains(const sg_chains *chains, size_t from, size_t to, lines *out)
{
  for (size_t k = from; k <= to; k++) {
    sg_travel_line *line = &out->at[out->n++];

    for (int end = 0; end < 2; end++) {
      memcpy(line->at[end], sg_chain_end(chains, k, end), sizeof line->at[end]);
    }
  }
}

static bool
chains_good(sg_call *call, const sg_travelled_strokes_list *strokes)
{
  for (size_t i = 0; i < strokes->n; i++) {
    const sg_travelled_strokes *k = &strokes->at[i];

    if (k->is == SG_TRAVELLED_STROKES_STROKES &&
        !sg_chains_have(call, k->strokes.chains, k->strokes.from, k->strokes.to,
                        3)) {
      return false;
    }
  }
  return true;
}

static bool
read_lines(sg_call *call, const sg_travelled_strokes_list *strokes, lines *out)
{
  bool good = true;

  if (!chains_good(call, strokes)) {
    return false;
  }
  out->at = sg_call_alloc(call, (count_lines(strokes) + 1) * sizeof *out->at);
  for (size_t i = 0; out->at && good && i < strokes->n; i++) {
    const sg_travelled_strokes *k = &strokes->at[i];

    if (k->is == SG_TRAVELLED_STROKES_STROKES) {
      add_chains(k->strokes.chains, k->strokes.from, k->strokes.to, out);
    } else {
      good = add_stroke(call, &k->stroke.points, out);
    }
  }
  return out->at && good;
}

/* Of n lines as they are; null: refused. */
static sg_travel *
travel_kept(sg_call *call, size_t n)
{
  sg_travel *travel = calloc(1, sizeof *travel);

  if (!travel || !(travel->order = malloc((n + 1) * sizeof *travel->order))) {
    free(travel);
    sg_call_no_memory(call);
    return NULL;
  }
  travel->n = n;
  for (size_t i = 0; i < n; i++) {
    travel->order[i] = (int32_t)i + 1;
  }
  return travel;
}

/* In the order of nearest ends, if that is shorter than *way, which it sets
 * then. */
static bool
travel_shorten(sg_call *call, const lines *all, const int32_t from[2],
               sg_travel *travel, double *way)
{
  int32_t *order = sg_call_alloc(call, (all->n + 1) * sizeof *order);
  bool memory;
  double length;

  if (!order) {
    return false;
  }
  if (!sg_travel_order(all->at, all->n, from, order, &call->cancel, &memory)) {
    return sg_call_ended(call);
  }
  length = sg_travel_length(all->at, all->n, from, order);
  if (length < *way) {
    *way = length;
    memcpy(travel->order, order, all->n * sizeof *order);
  }
  return true;
}

bool
sg_door_travel_open(sg_call *call, const sg_sheet_point *start,
                    sg_travel_how how, const sg_travelled_strokes_list *strokes,
                    sg_travel **out, size_t *n, double *way, double *unsorted)
{
  lines all = {0};
  int32_t from[2];

  if (!sg_sheet_point_at(call, start, from) ||
      !read_lines(call, strokes, &all) || !(*out = travel_kept(call, all.n))) {
    return false;
  }
  *n = all.n;
  *way = *unsorted = sg_travel_length(all.at, all.n, from, NULL);
  if (how == SG_TRAVEL_SHORT && !travel_shorten(call, &all, from, *out, way)) {
    sg_travel_close(*out);
    *out = NULL;
    return false;
  }
  return true;
}

bool
sg_door_travel_numbers(sg_call *call, sg_travel *travel, size_t from, size_t to,
                       sg_int_list *numbers)
{
  if (from == 0 || to > travel->n) {
    return sg_call_domain(call, "place", 2);
  }
  for (size_t i = from; i <= to; i++) {
    if (!sg_int_list_add(call, numbers, travel->order[i - 1])) {
      return false;
    }
  }
  return true;
}
