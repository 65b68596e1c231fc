/* image_rows.c -- scenes in dots. */
#include "doors/image.h"

#include "raster_rows.h"
#include "shaded_rows.h"
#include "shading/buffer.h"
#include "shading/dot_part.h"
#include "shading/face_look_rows.h"
#include "shading/srgb.h"

#include <stdlib.h>
#include <string.h>

/* The arguments that are refused. */
enum { IMAGE = 1, LINES = 2, LOOKS = 3, LEAVES = 4 };

/* ---- looks ---- */

static bool
read_ways(sg_call *call, const sg_tone_way_list *ways, sg_tone_way *way,
          unsigned *n)
{
  if (ways->n > SG_TONE_WAYS) {
    return sg_call_domain(call, "shading_ways", LOOKS);
  }
  *n = (unsigned)ways->n;
  for (size_t i = 0; i < ways->n; i++) {
    way[i] = ways->at[i];
  }
  return true;
}

static bool
read_table(sg_call *call, const sg_number_list *axes,
           const sg_number_list *tones, sg_tones *out)
{
  float *table = sg_call_alloc(call, tones->n * sizeof *table);

  if (axes->n != 9 || tones->n != (size_t)SG_TONE_SIDE * SG_TONE_SIDE) {
    return sg_call_domain(call, "shading_table", LOOKS);
  }
  memcpy(out->axis, axes->at, sizeof out->axis);
  for (size_t i = 0; table && i < tones->n; i++) {
    table[i] = (float)tones->at[i];
  }
  out->table = table;
  return table != NULL;
}

/* Evenly from the first light to the second. */
static void
fill_ramp(sg_ramp *out)
{
  uint16_t first[3], second[3];

  memcpy(first, out->light[0], sizeof first);
  memcpy(second, out->light[1], sizeof second);
  for (uint32_t i = 0; i <= SG_RAMP; i++) {
    for (int c = 0; c < 3; c++) {
      out->light[i][c] =
          (uint16_t)((first[c] * (SG_RAMP - i) + second[c] * i + SG_RAMP / 2) /
                     SG_RAMP);
    }
  }
}

static bool
read_ramp(sg_call *call, const sg_ramp_light_list *list, sg_ramp *out)
{
  if (list->n != SG_RAMP + 1 && list->n != 2) {
    return sg_call_domain(call, "shading_ramp", LOOKS);
  }
  for (size_t i = 0; i < list->n; i++) {
    const int32_t part[3] = {list->at[i].red, list->at[i].green,
                             list->at[i].blue};
    for (int c = 0; c < 3; c++) {
      if (part[c] < 0 || part[c] > SG_LIGHT_MOST) {
        return sg_call_domain_of(call, "light", part[c]);
      }
      out->light[i][c] = (uint16_t)part[c];
    }
  }
  if (list->n == 2) {
    fill_ramp(out);
  }
  memcpy(out->light[SG_RAMP + 1], out->light[SG_RAMP], sizeof out->light[0]);
  return true;
}

static bool
read_tones(sg_call *call, const sg_shading_tones *tones, sg_tones *out)
{
  if (tones->is == SG_SHADING_TONES_TABLE) {
    return read_table(call, &tones->table.axes, &tones->table.tones, out);
  }
  out->constant = tones->sum.constant;
  return read_ways(call, &tones->sum.ways, out->way, &out->ways);
}

static bool
read_look(sg_call *call, const sg_shading_look *fact, sg_face_look *out)
{
  const sg_stripes *stripes = &fact->stripes;

  memset(out, 0, sizeof *out);
  out->shine.power = (unsigned)fact->shine.power;
  out->stripes = *stripes;
  if (fact->shine.power < 1 || fact->shine.power > SG_SHINE_MOST) {
    return sg_call_domain(call, "shading_shine", LOOKS);
  }
  if ((stripes->step != 0 && stripes->step < 4) ||
      (stripes->way != 1 && stripes->way != -1)) {
    return sg_call_domain(call, "shading_stripes", LOOKS);
  }
  return read_tones(call, &fact->tones, &out->tones) &&
         read_ways(call, &fact->shine.ways, out->shine.way, &out->shine.ways) &&
         read_ramp(call, &fact->ramp, &out->ramp);
}

/* What is see-through, if anything is. */
static bool
read_looks(sg_call *call, const sg_shading_look_list *list,
           const sg_list_count_list *leaves, sg_shaded *out,
           sg_opacities *opacities)
{
  sg_face_look *look = sg_call_alloc(call, (list->n + 1) * sizeof *look);
  uint32_t *opacity = sg_call_alloc(call, (list->n + 1) * sizeof *opacity);
  bool clear = false;

  for (size_t i = 0; look && opacity && i < list->n; i++) {
    if (!read_look(call, &list->at[i], &look[i]) ||
        !sg_opacity_read(call, list->at[i].opacity, LOOKS, &opacity[i])) {
      return false;
    }
    clear = clear || opacity[i] < SG_OPAQUE;
  }
  if (!look || !opacity ||
      !sg_face_numbers_read(call, leaves, list->n, LEAVES,
                            &out->looks.numbers)) {
    return false;
  }
  out->looks.look = look;
  *opacities = (sg_opacities){opacity, out->looks.numbers};
  out->opacities = clear ? opacities : NULL;
  return true;
}

/* ---- pictures ---- */

static bool
read_background(sg_call *call, const sg_image_background *fact, sg_shaded *in)
{
  sg_colour colour = {0, 0, 0};

  in->clear = fact->is == SG_IMAGE_BACKGROUND_NONE;
  if (!in->clear && !sg_rgb_colour(call, &fact->rgb, colour)) {
    return false;
  }
  for (int c = 0; c < 3; c++) {
    in->background[c] = sg_srgb_light(colour[c]);
  }
  return true;
}

static void
close_shadow(void *shadow)
{
  sg_shadow_close(shadow);
}

bool
sg_shaded_ended(sg_call *call, sg_shading_end end)
{
  return end == SG_SHADING_GOOD ||
         (end == SG_SHADING_NO_MEMORY ? sg_call_no_memory(call)
                                      : sg_call_ended(call));
}

/* A scene of a light is of a parallel picture: its fourth row says so. */
static bool
read_shadows(sg_call *call, const sg_shading_list *scenes, sg_shaded *in)
{
  sg_shadow *shadow = sg_call_alloc(call, (scenes->n + 1) * sizeof *shadow);

  if (scenes->n > SG_TONE_WAYS) {
    return sg_call_domain(call, "shading_ways", LINES);
  }
  for (size_t i = 0; shadow && i < scenes->n; i++) {
    const double *last = sg_shading_frame_of(scenes->at[i])->matrix[3];
    if (last[0] != 0 || last[1] != 0 || last[2] != 0 || last[3] != 1) {
      return sg_call_domain(call, "scene_of_light", LINES);
    }
    if (!sg_shaded_ended(
            call, sg_shadow_open(scenes->at[i], &call->cancel, &shadow[i])) ||
        !sg_call_hold(call, &shadow[i], close_shadow)) {
      return false;
    }
  }
  in->shadow = shadow;
  in->shadows = (unsigned)scenes->n;
  return shadow != NULL;
}

bool
sg_shaded_read(sg_call *call, const sg_image_how *how,
               const sg_shading_look_list *looks,
               const sg_list_count_list *leaves, sg_shaded *in,
               sg_opacities *opacities)
{
  in->middles = how->lines == 0;
  size_t lines = in->middles ? 1 : how->lines;

  if (!(lines <= SG_COVER_LINES && (lines & (lines - 1)) == 0)) {
    return sg_call_domain(call, "shading_lines", LINES);
  }
  in->lines = (unsigned)lines;
  in->edges = how->edges > 0;
  return read_background(call, &how->background, in) &&
         read_looks(call, looks, leaves, in, opacities) &&
         read_shadows(call, &how->shadows, in);
}

bool
sg_door_image_shade(sg_call *call, sg_shading *scene, const sg_image_how *how,
                    const sg_shading_look_list *looks,
                    const sg_list_count_list *leaves, sg_image **out)
{
  const sg_shading_frame *frame = sg_shading_frame_of(scene);
  sg_shaded in = {.scene = scene};
  sg_opacities opacities;
  sg_pool *pool = sg_call_pool(call);

  return pool && sg_raster_size(call, frame->width, frame->height) &&
         sg_shaded_read(call, how, looks, leaves, &in, &opacities) &&
         sg_shaded_ended(call, sg_shade(&in, pool, &call->cancel, out));
}

bool
sg_door_image_scanned(sg_call *call, sg_scan *scan, sg_shading *scene,
                      const sg_image_how *how,
                      const sg_shading_look_list *looks,
                      const sg_list_count_list *leaves, sg_image **out)
{
  const sg_shading_frame *frame = sg_shading_frame_of(scene);
  sg_shaded in = {.scene = scene, .scan = scan};
  sg_opacities opacities;
  sg_pool *pool = sg_call_pool(call);

  if (!pool || !sg_raster_size(call, frame->width, frame->height) ||
      !sg_shaded_read(call, how, looks, leaves, &in, &opacities)) {
    return false;
  }
  return sg_scan_is_of(scan, scene, in.lines)
             ? sg_shaded_ended(call, sg_shade(&in, pool, &call->cancel, out))
             : sg_call_domain(call, "shading_scan", 1);
}

bool
sg_door_image_again(sg_call *call, sg_image *old, const sg_count_list *bands,
                    size_t from, size_t to, sg_shading *scene,
                    const sg_image_how *how, const sg_shading_look_list *looks,
                    const sg_list_count_list *leaves, sg_image **out)
{
  const sg_shading_frame *frame = sg_shading_frame_of(scene);
  sg_shaded in = {.scene = scene};
  sg_opacities opacities;
  sg_pool *pool = sg_call_pool(call);

  if (!pool || !sg_shaded_read(call, how, looks, leaves, &in, &opacities)) {
    return false;
  }
  if (old->width != frame->width || old->height != frame->height ||
      old->bytes != (in.clear ? 4 : 3)) {
    return sg_call_domain(call, "image_of_scene", IMAGE);
  }
  for (size_t i = 0; i < bands->n; i++) {
    if (bands->at[i] >= (size_t)(old->height - 1) / SG_IMAGE_BAND + 1) {
      return sg_call_domain(call, "image_band", 2);
    }
  }
  if (!(from < to && to <= (size_t)old->width)) {
    return sg_call_domain(call, "image_column", 4);
  }
  in.from = (int32_t)from;
  in.to = (int32_t)to;
  return sg_shaded_ended(call, sg_shade_again(&in, old, bands->at, bands->n,
                                              pool, &call->cancel, out));
}

bool
sg_door_image_strokes(sg_call *call, sg_shading *scene, double tone,
                      const sg_shading_look_list *looks,
                      const sg_list_count_list *leaves, double spacing,
                      double step, sg_image_stroke_list *out)
{
  sg_shaded in = {.scene = scene};
  sg_opacities opacities;
  sg_tone_strokes strokes = {0};

  if (!(tone >= 0 && tone <= 1)) {
    return sg_call_domain(call, "tone", 2);
  }
  if (!(spacing > 0 && step > 0)) {
    return sg_call_domain(call, "spacing", spacing > 0 ? 6 : 5);
  }
  if (!read_looks(call, looks, leaves, &in, &opacities)) {
    return false;
  }
  bool good = sg_shaded_ended(
      call, sg_tone_strokes_of(scene, &in.looks, spacing,
                               (uint32_t)(tone * SG_TONE_MOST + 0.5), step,
                               &call->cancel, &strokes));
  for (size_t i = 0; good && i < strokes.n; i++) {
    good = sg_image_stroke_list_add(call, out, strokes.item[i]);
  }
  free(strokes.item);
  return good;
}

static bool
add_parts(sg_call *call, const sg_dot_parts *parts, double all,
          sg_image_part_list *out)
{
  for (size_t i = 0; i < parts->n; i++) {
    const sg_dot_part *p = &parts->item[i];
    sg_image_part part = {.x = (size_t)p->x,
                          .root = p->root,
                          .leaf = p->leaf,
                          .face = p->face,
                          .share = p->share / all,
                          .light = {(int32_t)p->light[0], (int32_t)p->light[1],
                                    (int32_t)p->light[2]}};

    if (!sg_image_part_list_add(call, out, part)) {
      return false;
    }
  }
  return true;
}

bool
sg_door_image_parts(sg_call *call, sg_shading *scene, const sg_image_how *how,
                    const sg_shading_look_list *looks,
                    const sg_list_count_list *leaves, size_t y,
                    sg_image_part_list *out)
{
  sg_shaded in = {.scene = scene};
  sg_opacities opacities;
  sg_dot_parts parts = {0};
  sg_spans spans = {0};

  if (!sg_shaded_read(call, how, looks, leaves, &in, &opacities)) {
    return false;
  }
  if (in.middles) {
    return sg_call_domain(call, "shading_lines", LINES);
  }
  if (y >= (size_t)sg_shading_frame_of(scene)->height) {
    return sg_call_domain(call, "image_dot", 5);
  }
  sg_shading_work *work = sg_shading_work_open(scene, in.opacities);
  bool good =
      (work && sg_dot_parts_of(&in, work, &spans, (int32_t)y, &parts)) ||
      sg_call_no_memory(call);

  good = good && add_parts(call, &parts, 256.0 * in.lines * SG_OPAQUE, out);
  free(parts.item);
  free(spans.span);
  if (work) {
    sg_shading_work_close(work);
  }
  return good;
}

bool
sg_door_image_normals(sg_call *call, sg_vector_list *out)
{
  for (unsigned i = 0; i < SG_TONE_SIDE; i++) {
    for (unsigned j = 0; j < SG_TONE_SIDE; j++) {
      sg_xyz normal;

      sg_tone_normal(i, j, normal.at);
      if (!sg_vector_list_add(call, out, normal)) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_door_image_extent(sg_call *call, sg_shading *scene, sg_shading_extent *out)
{
  sg_pool *pool = sg_call_pool(call);

  return pool &&
         sg_shaded_ended(
             call, sg_shading_extent_of(scene, pool, &call->cancel, out)) &&
         out->x1 < out->x2;
}

bool
sg_door_srgb_light(sg_call *call, size_t byte, size_t *light)
{
  if (byte > UINT8_MAX) {
    return sg_call_domain(call, "byte", 1);
  }
  *light = sg_srgb_light((uint8_t)byte);
  return true;
}

bool
sg_door_light_srgb(sg_call *call, size_t light, size_t *byte)
{
  if (light > SG_LIGHT_MOST) {
    return sg_call_domain(call, "light", 1);
  }
  *byte = sg_srgb_byte((uint32_t)light);
  return true;
}

bool
sg_door_image_size(sg_call *call, sg_image *image, size_t *width,
                   size_t *height)
{
  (void)call;
  *width = (size_t)image->width;
  *height = (size_t)image->height;
  return true;
}

bool
sg_door_image_dot(sg_call *call, sg_image *image, size_t x, size_t y,
                  sg_count_list *out)
{
  if (x >= (size_t)image->width || y >= (size_t)image->height) {
    return sg_call_domain(call, "image_dot", x >= (size_t)image->width ? 2 : 3);
  }
  const uint8_t *dot =
      image->dot + (y * (size_t)image->width + x) * image->bytes;
  for (unsigned c = 0; c < image->bytes; c++) {
    if (!sg_count_list_add(call, out, dot[c])) {
      return false;
    }
  }
  return true;
}
