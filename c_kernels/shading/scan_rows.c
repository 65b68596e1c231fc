/* scan_rows.c -- the spans of a picture, kept, and as rows of span/7. */
#include "doors/shading.h"

#include "cover.h"
#include "engine/list.h"
#include "face_look_rows.h"
#include "scan.h"

#include <stdlib.h>

bool
sg_door_shading_scan(sg_call *call, sg_shading *scene, size_t lines,
                     const sg_number_list *looks,
                     const sg_list_count_list *leaves, sg_scan **out)
{
  sg_pool *pool = sg_call_pool(call);
  sg_opacities opacities;
  bool clear;

  if (!pool || !sg_opacities_read(call, looks, leaves, &opacities, &clear)) {
    return false;
  }
  if (!(lines > 0 && lines <= SG_COVER_LINES && (lines & (lines - 1)) == 0)) {
    return sg_call_domain(call, "shading_lines", 2);
  }
  sg_shading_end end =
      sg_scan_open(scene, (unsigned)lines, clear ? &opacities : NULL, pool,
                   &call->cancel, out);
  return end == SG_SHADING_GOOD ||
         (end == SG_SHADING_NO_MEMORY ? sg_call_no_memory(call)
                                      : sg_call_ended(call));
}

/* ---- rows ---- */

typedef struct place {
  const sg_scan *scan;
  size_t line, span; /* the next line, and the next span of `rows` */
  sg_spans rows;     /* of the line before the next one, joined */
} place;

/* False: no memory. */
static bool
next_line(place *at)
{
  sg_spans line = sg_scan_line(at->scan, at->line++);

  at->span = at->rows.n = 0;
  if (!sg_list_need(&at->rows.span, line.n, &at->rows.room,
                    sizeof *at->rows.span)) {
    return false;
  }
  for (size_t i = 0; i < line.n; i++) {
    at->rows.span[at->rows.n++] = line.span[i];
  }
  sg_spans_join(&at->rows);
  return true;
}

/* The rows of one page of span/7, from a place on. False: no memory. */
static bool
write_page(const sg_sheet_page *page, const int32_t *segment, place *at)
{
  const sg_blank *to = page->column;

  for (size_t i = 0; i < page->n; i++) {
    while (at->span == at->rows.n) {
      if (!next_line(at)) {
        return false;
      }
    }
    const sg_span *s = &at->rows.span[at->span++];
    to[0].i[i] = (int32_t)((at->line - 1) / at->scan->lines);
    to[1].i[i] = (int32_t)((at->line - 1) % at->scan->lines);
    to[2].i[i] = s->x1;
    to[3].i[i] = s->x2;
    to[4].i[i] = s->root;
    to[5].i[i] = segment[s->leaf - 1];
    to[6].i[i] = s->face;
  }
  return true;
}

static bool
append_spans(sg_call *call, place *at, const int32_t *segment, size_t n)
{
  bool memory = true, stopped = false;
  sg_append a;

  if (!sg_append_open(&a, call->world, SG_SPAN, n)) {
    return sg_call_no_memory(call);
  }
  for (size_t k = 0; k < a.sheet.pages && memory && !stopped; k++) {
    memory = write_page(&a.sheet.page[k], segment, at);
    stopped = k % 16 == 15 && sg_cancelled(&call->cancel);
  }
  bool good = stopped
                  ? sg_call_ended(call)
                  : (memory && sg_append_commit(&a)) || sg_call_no_memory(call);
  sg_append_close(&a);
  return good;
}

/* How many rows there are; in *most the last leaf. False: no memory. */
static bool
count_rows(place *at, size_t *n, size_t *most)
{
  *n = *most = 0;
  while (at->line < at->scan->n) {
    if (!next_line(at)) {
      return false;
    }
    *n += at->rows.n;
    for (size_t k = 0; k < at->rows.n; k++) {
      size_t leaf = (size_t)at->rows.span[k].leaf;
      *most = leaf > *most ? leaf : *most;
    }
  }
  return true;
}

bool
sg_door_fill_spans(sg_call *call, sg_scan *scan, const sg_int_list *segments)
{
  sg_world *world = sg_call_world(call);
  place at = {.scan = scan};
  size_t n, most;
  bool good = world && (count_rows(&at, &n, &most) || sg_call_no_memory(call));

  if (good && most > segments->n) {
    good = sg_call_domain(call, "shading_segments", 2);
  }
  at.line = at.span = at.rows.n = 0;
  good = good &&
         (sg_world_retract_all(world, SG_SPAN) || sg_call_no_memory(call)) &&
         (n == 0 || append_spans(call, &at, segments->at, n));
  free(at.rows.span);
  return good;
}
