/* raster4pl.c -- raster_dots/4 and raster_png/5 (documented in
 * kernel/drawing.pl).
 *
 * Layer: glue: converts, checks, raises; computes nothing. A raster passes
 * through Prolog as a string with one code a dot, so nothing needs closing.
 */
#include "raster4pl.h"
#include "engine/install.h"
#include "engine/world4pl.h"

#include <stdlib.h>
#include <string.h>

static functor_t FUNCTOR_stroke4, FUNCTOR_minus2, FUNCTOR_rgb3;

/* A growing array of points. */
typedef struct points {
  int32_t (*at)[2];
  size_t n, room;
} points;

static int
get_coordinate_ex(int i, term_t pair, int32_t *out)
{
  term_t t = PL_new_term_ref();

  if (!PL_get_arg(i, pair, t) || !sg_get_int32_ex(t, out)) {
    return FALSE;
  }
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
    int32_t(*at)[2] = realloc(out->at, room * sizeof *at);

    if (!at) {
      return sg_no_memory();
    }
    out->at = at;
    out->room = room;
  }
  return get_coordinate_ex(1, t, &out->at[out->n][0]) &&
         get_coordinate_ex(2, t, &out->at[out->n++][1]);
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
  return PL_get_nil_ex(tail);
}

/* Reads ink, width and pattern; the caller frees *run. */
static int
get_pen_ex(term_t stroke, sg_pen *out, int32_t **run)
{
  term_t t = PL_new_term_ref();
  int32_t ink;

  if (!PL_get_arg(1, stroke, t) || !sg_get_int32_ex(t, &ink)) {
    return FALSE;
  }
  if (ink < 0 || ink > UINT8_MAX) {
    return PL_domain_error("ink", t);
  }
  out->ink = (uint8_t)ink;
  if (!PL_get_arg(2, stroke, t) || !sg_get_int32_ex(t, &out->width) ||
      !PL_get_arg(3, stroke, t) || !sg_get_ids_ex(t, run, &out->runs)) {
    return FALSE;
  }
  out->run = *run;
  return sg_pen_is_valid(out) || PL_domain_error("pen", stroke);
}

static int
draw_stroke_ex(sg_raster *raster, term_t stroke, points *room)
{
  term_t list = PL_new_term_ref();
  int32_t *run = NULL;
  sg_pen pen;
  int ok;

  if (!PL_is_functor(stroke, FUNCTOR_stroke4)) {
    return PL_type_error("stroke", stroke);
  }
  ok = get_pen_ex(stroke, &pen, &run) && PL_get_arg(4, stroke, list) &&
       get_points_ex(list, room) &&
       sg_raster_chain(raster, &pen, room->n, (const int32_t(*)[2])room->at,
                       &sg_prolog_poll);
  free(run);
  return ok;
}

static int
draw_strokes_ex(sg_raster *raster, term_t list)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  points room = {NULL, 0, 0};
  int ok = TRUE;

  while (ok && PL_get_list_ex(tail, head, tail)) {
    fid_t frame = PL_open_foreign_frame();

    ok = frame && draw_stroke_ex(raster, head, &room);
    if (frame) {
      PL_close_foreign_frame(frame);
    }
  }
  free(room.at);
  return ok && PL_get_nil_ex(tail);
}

static int
get_size_ex(term_t width, term_t height, sg_raster *out)
{
  if (!sg_get_int32_ex(width, &out->width) ||
      !sg_get_int32_ex(height, &out->height)) {
    return FALSE;
  }
  return sg_raster_size_is_valid(out->width, out->height) ||
         sg_raster_size_error(width, height);
}

int
sg_raster_size_error(term_t width, term_t height)
{
  term_t size = PL_new_term_ref();

  return PL_cons_functor(size, FUNCTOR_minus2, width, height) &&
         PL_domain_error("raster_size", size);
}

int
sg_unify_bytes(term_t t, const uint8_t *bytes, size_t n)
{
  return PL_unify_chars(t, PL_STRING | REP_ISO_LATIN_1, n, (const char *)bytes);
}

/* raster_dots(+Width, +Height, +Strokes, -Dots) is det. */
static foreign_t
raster_dots(term_t width, term_t height, term_t strokes, term_t dots)
{
  sg_raster raster;
  int ok;

  if (!get_size_ex(width, height, &raster)) {
    return FALSE;
  }
  if (!sg_raster_open(&raster, raster.width, raster.height)) {
    return sg_no_memory();
  }
  ok = draw_strokes_ex(&raster, strokes) &&
       sg_unify_bytes(dots, raster.dot,
                      (size_t)raster.width * (size_t)raster.height);
  sg_raster_clear(&raster);
  return ok;
}

int
sg_get_colour_ex(term_t rgb, sg_colour out)
{
  term_t t = PL_new_term_ref();

  if (!PL_is_functor(rgb, FUNCTOR_rgb3)) {
    return PL_type_error("rgb", rgb);
  }
  for (int i = 0; i < 3; i++) {
    int32_t part;

    if (!PL_get_arg(i + 1, rgb, t) || !sg_get_int32_ex(t, &part)) {
      return FALSE;
    }
    if (part < 0 || part > UINT8_MAX) {
      return PL_domain_error("byte", t);
    }
    out[i] = (uint8_t)part;
  }
  return TRUE;
}

static int
get_palette_ex(term_t list, sg_colour palette[256], size_t *n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (*n = 0; PL_get_list_ex(tail, head, tail); (*n)++) {
    if (*n == 256) {
      return PL_domain_error("palette", list);
    }
    if (!sg_get_colour_ex(head, palette[*n])) {
      return FALSE;
    }
  }
  if (!PL_get_nil_ex(tail)) {
    return FALSE;
  }
  return *n > 0 || PL_domain_error("palette", list);
}

/* Raises what `status` means; TRUE for SG_PNG_OK. */
static int
raise_png_status(sg_png_status status, term_t palette)
{
  switch (status) {
  case SG_PNG_OK:
    return TRUE;
  case SG_PNG_NO_MEMORY:
    return sg_no_memory();
  case SG_PNG_NO_COLOUR:
    return PL_domain_error("palette", palette);
  case SG_PNG_STOPPED:
    return FALSE;
  }
  return FALSE;
}

/* raster_png(+Width, +Height, +Dots, +Palette, -Bytes) is det. */
static foreign_t
raster_png(term_t width, term_t height, term_t dots, term_t palette,
           term_t bytes)
{
  sg_raster raster;
  sg_colour colour[256];
  size_t colours, length, n;
  char *dot;
  uint8_t *file;

  if (!get_size_ex(width, height, &raster) ||
      !get_palette_ex(palette, colour, &colours) ||
      !PL_get_nchars(dots, &length, &dot,
                     CVT_STRING | CVT_EXCEPTION | REP_ISO_LATIN_1)) {
    return FALSE;
  }
  if (length != (size_t)raster.width * (size_t)raster.height) {
    return PL_domain_error("raster_dots", dots);
  }
  raster.dot = (uint8_t *)dot;

  sg_png_status status = sg_png_write(
      &raster, colours, (const sg_colour *)colour, &sg_prolog_poll, &file, &n);

  if (!raise_png_status(status, palette)) {
    return FALSE;
  }

  int ok = sg_unify_bytes(bytes, file, n);

  free(file);
  return ok;
}

void
sg_install_raster(void)
{
  static const PL_extension doors[] = {
      {"raster_dots", 4, raster_dots, 0},
      {"raster_png", 5, raster_png, 0},
      {NULL, 0, NULL, 0},
  };

  FUNCTOR_stroke4 = PL_new_functor(PL_new_atom("stroke"), 4);
  FUNCTOR_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  FUNCTOR_rgb3 = PL_new_functor(PL_new_atom("rgb"), 3);
  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
