/* dot_part.c -- see dot_part.h. */
#include "dot_part.h"

#include "engine/search.h"

#include <stdlib.h>

enum { DOT = 256 };

SG_ORDER(by_dot, sg_dot_part,
         SG_BY(x) SG_BY(leaf) SG_BY(face) SG_BY_MOST(share));

static bool
add_pieces(const sg_shaded *in, sg_shading_work *work, const sg_span *span,
           double line, sg_dot_parts *out)
{
  for (int32_t x1 = span->x1; x1 < span->x2;) {
    int32_t dot = x1 / DOT, end = (dot + 1) * DOT;

    end = end < span->x2 ? end : span->x2;
    sg_dot_part part = {.x = dot,
                        .root = span->root,
                        .leaf = span->leaf,
                        .face = span->face,
                        .share = (uint32_t)(end - x1) * span->part};
    sg_cover_light(in, work, span, (x1 + end) / (2.0 * DOT), line, part.light);
    if (!SG_PUSH(*out, part)) {
      return false;
    }
    x1 = end;
  }
  return true;
}

/* Pieces of one face in one dot become one. */
static void
join(sg_dot_parts *parts)
{
  size_t n = 0;

  for (size_t i = 0; i < parts->n; i++) {
    const sg_dot_part *part = &parts->item[i];
    sg_dot_part *last = n > 0 ? &parts->item[n - 1] : NULL;

    if (last && last->x == part->x && last->leaf == part->leaf &&
        last->face == part->face) {
      last->share += part->share;
    } else {
      parts->item[n++] = *part;
    }
  }
  parts->n = n;
}

bool
sg_dot_parts_of(const sg_shaded *in, sg_shading_work *work, sg_spans *spans,
                int32_t y, sg_dot_parts *out)
{
  out->n = 0;
  for (unsigned k = 0; k < in->lines; k++) {
    double line = y + (k + 0.5) / in->lines;

    if (!sg_shading_line(in->scene, work, line, spans)) {
      return false;
    }
    for (size_t i = 0; i < spans->n; i++) {
      if (!add_pieces(in, work, &spans->span[i], line, out)) {
        return false;
      }
    }
  }
  if (out->n > 0) {
    qsort(out->item, out->n, sizeof *out->item, by_dot);
  }
  join(out);
  return true;
}
