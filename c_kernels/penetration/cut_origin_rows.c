/* cut_origin_rows.c -- cut sets: what made a point, as in origin/3.
 *
 * Layer: rows.
 */
#include "cut_rows.h"

#include <string.h>

/* S-(A,B) for an edge, smaller vertex first. */
static void
build_edge(sg_term_builder *b, int32_t s, int32_t v, int32_t w)
{
  sg_term_compound(b, SG_SYMBOL_MINUS, 2);
  sg_term_int(b, s);
  sg_term_compound(b, SG_SYMBOL_COMMA, 2);
  sg_term_int(b, v < w ? v : w);
  sg_term_int(b, v < w ? w : v);
}

/* S-(A,B,C) for a leaf triangle. */
static void
build_triangle(sg_term_builder *b, const sg_cut_model *model,
               const sg_leaf_triangle *t)
{
  sg_term_compound(b, SG_SYMBOL_MINUS, 2);
  sg_term_int(b, t->s);
  sg_term_compound(b, SG_SYMBOL_COMMA, 2);
  sg_term_int(b, model->vertex[t->v[0]].v);
  sg_term_compound(b, SG_SYMBOL_COMMA, 2);
  sg_term_int(b, model->vertex[t->v[1]].v);
  sg_term_int(b, model->vertex[t->v[2]].v);
}

static void
build_place(sg_term_builder *b, const sg_cut_model *model,
            const sg_place *place)
{
  if (place->kind == SG_ON_FACE) {
    build_triangle(b, model, &model->triangle[place->a]);
  } else {
    build_edge(b, sg_place_segment(model, place), model->vertex[place->a].v,
               model->vertex[place->b].v);
  }
}

/* The vertex place among those of a point that comes first by segment and
 * vertex. */
static const sg_place *
first_vertex(const sg_cut_points *points, uint32_t point)
{
  const sg_seat *found = NULL;

  for (uint32_t i = points->point[point].seat; i != SG_NO_KEY;
       i = points->seat[i].next) {
    const sg_seat *seat = &points->seat[i];

    if (seat->place.kind == SG_AT_VERTEX &&
        (!found || seat->s < found->s ||
         (seat->s == found->s && seat->v < found->v))) {
      found = seat;
    }
  }
  return found ? &found->place : NULL;
}

/* The places in the order of the origin term: an edge before a face, then by
 * segment. */
static void
order_places(const sg_cut_model *model, sg_made *made)
{
  for (int i = 1; i < made->n; i++) {
    for (int k = i; k > 0; k--) {
      sg_place *p = &made->place[k - 1], *q = &made->place[k];
      int by_kind = (int)p->kind - (int)q->kind;
      bool swap = by_kind
                      ? by_kind > 0
                      : sg_place_segment(model, p) > sg_place_segment(model, q);
      if (swap) {
        sg_place keep = *p;
        *p = *q;
        *q = keep;
      }
    }
  }
}

void
sg_cut_build_origin(sg_term_builder *b, const sg_cut_points *points,
                    uint32_t point)
{
  const sg_cut_model *model = points->model;
  const sg_place *vertex = first_vertex(points, point);
  sg_made made = points->point[point].made;

  if (vertex) {
    sg_term_compound(b, SG_SYMBOL_V, 2);
    sg_term_int(b, model->vertex[vertex->a].s);
    sg_term_int(b, model->vertex[vertex->a].v);
    return;
  }
  order_places(model, &made);
  sg_term_compound(b,
                   made.n == 3                        ? SG_SYMBOL_TPI
                   : made.place[1].kind == SG_ON_FACE ? SG_SYMBOL_LPI
                                                      : SG_SYMBOL_LL,
                   (size_t)made.n);
  for (int i = 0; i < made.n; i++) {
    build_place(b, model, &made.place[i]);
  }
}

const uint32_t *
sg_cut_origin(sg_call *call, const sg_cut_points *points, uint32_t point)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_cut_build_origin(&b, points, point);
  return sg_call_term(call, &b);
}
