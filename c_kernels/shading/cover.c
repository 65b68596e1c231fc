/* cover.c -- see cover.h. */
#include "cover.h"

#include "srgb.h"

#include <stdlib.h>
#include <string.h>

enum { DOT = 256, HALF = DOT / 2 }; /* parts of a dot */

bool
sg_cover_open(sg_dot_row *out, int32_t width)
{
  size_t n = (size_t)width;

  *out = (sg_dot_row){.width = width,
                      .sum = malloc(n * sizeof *out->sum),
                      .seen = malloc(n * sizeof *out->seen),
                      .light = malloc(n * sizeof *out->light)};
  if (!out->sum || !out->seen || !out->light) {
    sg_cover_close(out);
    return false;
  }
  return true;
}

void
sg_cover_close(sg_dot_row *cover)
{
  free(cover->sum);
  free(cover->seen);
  free(cover->light);
  *cover = (sg_dot_row){0};
}

static uint32_t
look_of(const sg_looks *looks, const sg_span *span)
{
  uint32_t first = looks->first[span->leaf];
  uint32_t at = first + (uint32_t)span->face;

  return looks->of[at < looks->first[span->leaf + 1] ? at : first];
}

/* ---- sums ---- */

static void
add_part(uint32_t sum[4], const uint32_t light[3], uint32_t part)
{
  for (int c = 0; c < 3; c++) {
    sum[c] += light[c] * part;
  }
  sum[3] += part;
}

/* One light from x1 to x2, in 1/256 dot. */
static void
add_flat(sg_dot_row *cover, const uint32_t light[3], int32_t x1, int32_t x2)
{
  int32_t first = x1 / DOT, last = x2 / DOT;
  const uint32_t whole[4] = {light[0] * DOT, light[1] * DOT, light[2] * DOT,
                             DOT};

  if (first == last) {
    add_part(cover->sum[first], light, (uint32_t)(x2 - x1));
    return;
  }
  if (x1 % DOT != 0) {
    add_part(cover->sum[first], light, (uint32_t)(DOT - x1 % DOT));
    first++;
  }
  for (int32_t x = first; x < last; x++) {
    for (int c = 0; c < 4; c++) {
      cover->sum[x][c] += whole[c];
    }
  }
  if (x2 % DOT != 0) {
    add_part(cover->sum[last], light, (uint32_t)(x2 % DOT));
  }
}

static void
light_at(const sg_shaded *in, const sg_face_look *look, const sg_span *span,
         double x, double y, uint32_t light[3])
{
  double depth, normal[3];

  sg_shading_point(in->scene, span, x, y, &depth, normal);
  sg_ramp_at(&look->ramp, sg_tone(&look->tones, normal), light);
}

/* Dot after dot; in the middle of a dot, or, if the span does not go so far, at
 * its end. */
static void
add_bent(sg_dot_row *cover, const sg_shaded *in, const sg_span *span,
         uint32_t number, double y)
{
  const sg_face_look *look = &in->looks.look[number];
  uint64_t key = ((uint64_t)number << 34) + ((uint64_t)span->surface << 2) +
                 (uint64_t)(span->sense + 2);

  for (int32_t x1 = span->x1; x1 < span->x2;) {
    int32_t dot = x1 / DOT, centre = dot * DOT + HALF;
    int32_t end = (dot + 1) * DOT;

    end = end < span->x2 ? end : span->x2;
    if (cover->seen[dot] != key) {
      int32_t x = centre < span->x1   ? span->x1
                  : centre > span->x2 ? span->x2
                                      : centre;
      light_at(in, look, span, x / (double)DOT, y, cover->light[dot]);
      cover->seen[dot] = key;
    }
    add_part(cover->sum[dot], cover->light[dot], (uint32_t)(end - x1));
    x1 = end;
  }
}

bool
sg_cover_row(sg_dot_row *cover, const sg_shaded *in, sg_shading_work *work,
             sg_spans *spans, int32_t y)
{
  memset(cover->sum, 0, (size_t)cover->width * sizeof *cover->sum);
  memset(cover->seen, 0, (size_t)cover->width * sizeof *cover->seen);
  for (unsigned k = 0; k < in->lines; k++) {
    if (!sg_shading_line(in->scene, work, y + (k + 0.5) / in->lines, spans)) {
      return false;
    }
    for (size_t i = 0; i < spans->n; i++) {
      const sg_span *span = &spans->span[i];
      uint32_t look = look_of(&in->looks, span), light[3];

      if (sg_shading_is_flat(in->scene, span)) {
        light_at(in, &in->looks.look[look], span, 0, y, light);
        add_flat(cover, light, span->x1, span->x2);
      } else {
        add_bent(cover, in, span, look, y + 0.5);
      }
    }
  }
  return true;
}

/* ---- bytes ---- */

/* The background shows where nothing covers it. */
static void
solid_dot(const uint32_t sum[4], const sg_shaded *in, unsigned shift,
          const uint8_t *byte, uint8_t out[3])
{
  uint32_t all = (uint32_t)1 << shift, rest = all - sum[3];

  for (int c = 0; c < 3; c++) {
    out[c] = byte[(sum[c] + rest * in->background[c] + all / 2) >> shift];
  }
}

static void
clear_dot(const uint32_t sum[4], unsigned shift, const uint8_t *byte,
          uint8_t out[4])
{
  uint32_t part = sum[3];

  for (int c = 0; c < 3; c++) {
    out[c] = part > 0 ? byte[(sum[c] + part / 2) / part] : 0;
  }
  out[3] = (uint8_t)((part * UINT8_MAX + (1U << shift) / 2) >> shift);
}

void
sg_cover_bytes(const sg_dot_row *cover, const sg_shaded *in,
               const uint8_t *byte, uint8_t *out)
{
  size_t bytes = in->clear ? 4 : 3;
  unsigned shift = 8; /* of all that a dot has */

  for (unsigned k = in->lines; k > 1; k /= 2) {
    shift++;
  }
  for (int32_t x = 0; x < cover->width; x++, out += bytes) {
    const uint32_t *sum = cover->sum[x];

    if (x > 0 && memcmp(sum, cover->sum[x - 1], sizeof *cover->sum) == 0) {
      memcpy(out, out - bytes, bytes);
    } else if (in->clear) {
      clear_dot(sum, shift, byte, out);
    } else {
      solid_dot(sum, in, shift, byte, out);
    }
  }
}
