/* canvas4pl.c -- canvas_png/6 (documented in kernel/drawing.pl).
 *
 * Layer: glue: converts, checks, raises; computes nothing.
 */
#include "engine/install.h"
#include "engine/world4pl.h"
#include "raster4pl.h"

#include <stdlib.h>

static functor_t FUNCTOR_line4, FUNCTOR_minus2;

/* A growing array of points, in dots; `scale` dots are a unit. */
typedef struct points {
  double (*at)[2];
  size_t n, room;
  double scale;
} points;

static int
get_coordinate_ex(int i, term_t pair, double scale, double *out)
{
  term_t t = PL_new_term_ref();

  if (!PL_get_arg(i, pair, t) || !PL_get_float_ex(t, out)) {
    return FALSE;
  }
  *out *= scale;
  return (*out >= -SG_RASTER_FAR && *out <= SG_RASTER_FAR) ||
         PL_domain_error("raster_coordinate", t);
}

static int
add_point_ex(term_t t, points *out)
{
  if (!PL_is_functor(t, FUNCTOR_minus2)) {
    return PL_type_error("pair", t);
  }
  if (out->n == out->room) {
    size_t room = out->room ? 2 * out->room : 64;
    double(*at)[2] = realloc(out->at, room * sizeof *at);

    if (!at) {
      return sg_no_memory();
    }
    out->at = at;
    out->room = room;
  }
  return get_coordinate_ex(1, t, out->scale, &out->at[out->n][0]) &&
         get_coordinate_ex(2, t, out->scale, &out->at[out->n++][1]);
}

/* Reads a list of X-Y into *out, which keeps its memory. */
static int
get_points_ex(term_t list, points *out)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  out->n = 0;
  while (PL_get_list_ex(tail, head, tail)) {
    fid_t frame = PL_open_foreign_frame();
    int ok = frame && add_point_ex(head, out);

    if (frame) {
      PL_close_foreign_frame(frame);
    }
    if (!ok) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(tail) &&
         (out->n > 0 || PL_domain_error("line_of_points", list));
}

static int
get_brush_ex(term_t line, double scale, sg_brush *out)
{
  term_t t = PL_new_term_ref();
  int round;

  if (!PL_get_arg(1, line, t) || !sg_get_colour_ex(t, out->colour) ||
      !PL_get_arg(2, line, t) || !PL_get_float_ex(t, &out->width)) {
    return FALSE;
  }
  out->width *= scale;
  if (!(out->width > 0 && out->width <= SG_RASTER_SIDE)) {
    return PL_domain_error("pen_width", t);
  }
  if (!PL_get_arg(3, line, t) || !PL_get_bool_ex(t, &round)) {
    return FALSE;
  }
  out->round = round != 0;
  return TRUE;
}

static int
draw_line_ex(sg_canvas *canvas, term_t line, points *room)
{
  term_t list = PL_new_term_ref();
  sg_brush brush;

  if (!PL_is_functor(line, FUNCTOR_line4)) {
    return PL_type_error("line", line);
  }
  return get_brush_ex(line, room->scale, &brush) && PL_get_arg(4, line, list) &&
         get_points_ex(list, room) &&
         sg_canvas_line(canvas, &brush, room->n, (const double(*)[2])room->at,
                        &sg_prolog_poll);
}

static int
draw_lines_ex(sg_canvas *canvas, term_t list, double scale)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  points room = {NULL, 0, 0, scale};
  int ok = TRUE;

  while (ok && PL_get_list_ex(tail, head, tail)) {
    fid_t frame = PL_open_foreign_frame();

    ok = frame && draw_line_ex(canvas, head, &room);
    if (frame) {
      PL_close_foreign_frame(frame);
    }
  }
  free(room.at);
  return ok && PL_get_nil_ex(tail);
}

/* Raises what `status` means; TRUE for SG_PNG_OK. */
static int
write_canvas_ex(const sg_canvas *canvas, double scale, term_t bytes)
{
  uint8_t *file;
  size_t n;
  sg_png_status status = sg_png_write_canvas(
      canvas, (uint32_t)(scale * 1e6 + 0.5), &sg_prolog_poll, &file, &n);

  if (status == SG_PNG_NO_MEMORY) {
    return sg_no_memory();
  }
  if (status != SG_PNG_OK) {
    return FALSE;
  }

  int ok = sg_unify_bytes(bytes, file, n);

  free(file);
  return ok;
}

/* canvas_png(+Width, +Height, +Scale, +Paper, +Lines, -Bytes) is det. */
static foreign_t
canvas_png(term_t width, term_t height, term_t scale, term_t paper,
           term_t lines, term_t bytes)
{
  int32_t w, h;
  double dots;
  sg_colour blank;
  sg_canvas canvas;

  if (!sg_get_int32_ex(width, &w) || !sg_get_int32_ex(height, &h) ||
      !PL_get_float_ex(scale, &dots) || !sg_get_colour_ex(paper, blank)) {
    return FALSE;
  }
  if (!sg_raster_size_is_valid(w, h)) {
    return sg_raster_size_error(width, height);
  }
  if (!(dots > 0 && dots <= 1000)) {
    return PL_domain_error("scale", scale);
  }
  if (!sg_canvas_open(&canvas, w, h, blank)) {
    return sg_no_memory();
  }

  int ok = draw_lines_ex(&canvas, lines, dots) &&
           write_canvas_ex(&canvas, dots, bytes);

  sg_canvas_clear(&canvas);
  return ok;
}

void
sg_install_canvas(void)
{
  static const PL_extension doors[] = {
      {"canvas_png", 6, canvas_png, 0},
      {NULL, 0, NULL, 0},
  };

  FUNCTOR_line4 = PL_new_functor(PL_new_atom("line"), 4);
  FUNCTOR_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
