/* letter_rows.c -- letter_lines/5 and laid_letters/8. */
#include "doors/drawing.h"

#include <math.h>

enum { CURVE = 4 }; /* straight pieces that a curve becomes */

/* A glyph in its place. */
typedef struct letter_place {
  double start, base, scale, at;
} letter_place;

static sg_sheet_point
on_paper(const letter_place *place, double x, double y)
{
  return (sg_sheet_point){
      llround(place->start + (place->at + x) * place->scale),
      llround(place->base - y * place->scale)};
}

static bool
stroke_line(sg_call *call, const letter_place *place,
            const sg_pen_point_list *stroke, sg_sheet_point_list *out)
{
  sg_sheet_point *line = sg_call_alloc(call, stroke->n * CURVE * sizeof *line);
  sg_paper_point a = {0, 0};
  size_t n = 0;

  for (size_t i = 0; line && i < stroke->n; i++) {
    const sg_pen_point *p = &stroke->at[i];

    if (p->is == SG_PEN_POINT_CORNER) {
      a = p->corner;
      line[n++] = on_paper(place, a.x, a.y);
      continue;
    }
    if (i == 0 || ++i == stroke->n || stroke->at[i].is != SG_PEN_POINT_CORNER) {
      return sg_call_domain(call, "stroke", 1);
    }
    sg_paper_point b = stroke->at[i].corner;

    for (int k = 1; k <= CURVE; k++) {
      double t = (double)k / CURVE, s = 1 - t;
      double x = s * s * a.x + 2 * s * t * p->c.x + t * t * b.x;
      double y = s * s * a.y + 2 * s * t * p->c.y + t * t * b.y;
      line[n++] = on_paper(place, x, y);
    }
    a = b;
  }
  *out = (sg_sheet_point_list){line, n, n};
  return line != NULL;
}

bool
sg_door_letter_lines(sg_call *call, const sg_pen_glyph_list *glyphs,
                     double start, double base, double scale,
                     sg_list_sheet_point_list *out)
{
  size_t strokes = 0;

  for (size_t i = 0; i < glyphs->n; i++) {
    strokes += glyphs->at[i].strokes.n;
  }
  sg_sheet_point_list *line = sg_call_alloc(call, strokes * sizeof *line);
  size_t n = 0;

  for (size_t i = 0; line && i < glyphs->n; i++) {
    const letter_place place = {start, base, scale, glyphs->at[i].at};

    for (size_t k = 0; k < glyphs->at[i].strokes.n; k++) {
      if (!stroke_line(call, &place, &glyphs->at[i].strokes.at[k],
                       &line[n++])) {
        return false;
      }
    }
  }
  *out = (sg_list_sheet_point_list){line, n, n};
  return line != NULL;
}

static sg_sheet_point
laid_point(const sg_sheet_point *p, const sg_paper_point *at,
           const sg_paper_point *way, const sg_sheet_move *move, double height)
{
  double a = (double)p->x, b = (double)p->y;
  double x0 = at->x + (a * way->x + b * way->y) / 1000;
  double y0 = at->y + (a * way->y - b * way->x) / 1000;
  double x = x0 * move->cos - y0 * move->sin + move->x + move->left;
  double y = x0 * move->sin + y0 * move->cos + move->y + move->bottom;

  return (sg_sheet_point){llround(x * 1000), llround((height - y) * 1000)};
}

bool
sg_door_laid_letters(sg_call *call, const sg_pen_glyph_list *glyphs,
                     double start, double scale, const sg_paper_point *at,
                     const sg_paper_point *way, const sg_sheet_move *move,
                     double height, sg_list_sheet_point_list *out)
{
  if (!sg_door_letter_lines(call, glyphs, start, 0, scale, out)) {
    return false;
  }
  for (size_t i = 0; i < out->n; i++) {
    for (size_t k = 0; k < out->at[i].n; k++) {
      sg_sheet_point *p = &out->at[i].at[k];
      *p = laid_point(p, at, way, move, height);
    }
  }
  return true;
}
