/* scan_rows.c -- the spans of a picture, kept, and as rows of span/7. */
#include "doors/shading.h"

#include "cover.h"
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
  size_t line, span;
} place;

/* The rows of one page of span/7, from a place on. */
static void
write_page(const sg_sheet_page *page, const sg_scan *scan,
           const int32_t *segment, place *at)
{
  const sg_blank *to = page->column;

  for (size_t i = 0; i < page->n; i++) {
    while (at->span == scan->line[at->line].n) {
      *at = (place){at->line + 1, 0};
    }
    const sg_span *s = &scan->line[at->line].span[at->span++];
    to[0].i[i] = (int32_t)(at->line / scan->lines);
    to[1].i[i] = (int32_t)(at->line % scan->lines);
    to[2].i[i] = s->x1;
    to[3].i[i] = s->x2;
    to[4].i[i] = s->root;
    to[5].i[i] = segment[s->leaf - 1];
    to[6].i[i] = s->face;
  }
}

static bool
append_spans(sg_call *call, const sg_scan *scan, const int32_t *segment,
             size_t n)
{
  place at = {0, 0};
  bool good = true;
  sg_append a;

  if (!sg_append_open(&a, call->world, SG_SPAN, n)) {
    return sg_call_no_memory(call);
  }
  for (size_t k = 0; k < a.sheet.pages && good; k++) {
    write_page(&a.sheet.page[k], scan, segment, &at);
    good = k % 16 != 15 || !sg_cancelled(&call->cancel);
  }
  good = good ? sg_append_commit(&a) || sg_call_no_memory(call)
              : sg_call_ended(call);
  sg_append_close(&a);
  return good;
}

bool
sg_door_fill_spans(sg_call *call, sg_scan *scan, const sg_int_list *segments)
{
  sg_world *world = sg_call_world(call);
  size_t n = 0;

  for (size_t i = 0; i < scan->n; i++) {
    n += scan->line[i].n;
    for (size_t k = 0; k < scan->line[i].n; k++) {
      if ((size_t)scan->line[i].span[k].leaf > segments->n) {
        return sg_call_domain(call, "shading_segments", 2);
      }
    }
  }
  return world &&
         (sg_world_retract_all(world, SG_SPAN) || sg_call_no_memory(call)) &&
         (n == 0 || append_spans(call, scan, segments->at, n));
}
