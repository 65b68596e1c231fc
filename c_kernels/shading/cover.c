/* cover.c -- see cover.h. */
#include "cover.h"

#include "face_edge.h"
#include "number/vector.h"
#include "srgb.h"

#include <math.h>
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
                      .light = malloc(n * sizeof *out->light),
                      .line = calloc(n + 1, sizeof *out->line)};
  if (!out->sum || !out->seen || !out->light || !out->line) {
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
  free(cover->line);
  *cover = (sg_dot_row){0};
}

/* ---- sums ---- */

/* Light, and how much of a place has it. */
typedef struct lit {
  uint32_t light[3], part;
} lit;

static void
add_part(uint32_t sum[4], const lit *of, uint32_t wide)
{
  for (int c = 0; c < 3; c++) {
    sum[c] += of->light[c] * wide;
  }
  sum[3] += of->part * wide;
}

/* One light from x1 to x2, in 1/256 dot. */
static void
add_flat(sg_dot_row *cover, const lit *of, int32_t x1, int32_t x2)
{
  int32_t first = x1 / DOT, last = x2 / DOT;
  const uint32_t whole[4] = {of->light[0] * DOT, of->light[1] * DOT,
                             of->light[2] * DOT, of->part * DOT};

  if (first == last) {
    add_part(cover->sum[first], of, (uint32_t)(x2 - x1));
    return;
  }
  if (x1 % DOT != 0) {
    add_part(cover->sum[first], of, (uint32_t)(DOT - x1 % DOT));
    first++;
  }
  for (int32_t x = first; x < last; x++) {
    for (int c = 0; c < 4; c++) {
      cover->sum[x][c] += whole[c];
    }
  }
  if (x2 % DOT != 0) {
    add_part(cover->sum[last], of, (uint32_t)(x2 % DOT));
  }
}

/* Whether x is in a stripe, in 1/256 dot; in *left how far it is to the other.
 */
static bool
in_stripe(const sg_stripes *stripes, int32_t x, int64_t y, int32_t *left)
{
  int32_t step = stripes->step, wide = step / 4;
  int32_t at = (int32_t)((x + stripes->way * y) % step);

  at += at < 0 ? step : 0;
  *left = (at < wide ? wide : step) - at;
  return at < wide;
}

/* In a stripe there is a quarter of the light. */
static void
darken(uint32_t light[3])
{
  for (int c = 0; c < 3; c++) {
    light[c] /= 4;
  }
}

/* Light and dark in turn; y in 1/256 dot. */
static void
add_striped(sg_dot_row *cover, const lit *of, const sg_stripes *stripes,
            int32_t x1, int32_t x2, int64_t y)
{
  lit dark = *of;

  darken(dark.light);
  while (x1 < x2) {
    int32_t left;
    bool is_dark = in_stripe(stripes, x1, y, &left);
    int32_t to = x1 + left < x2 ? x1 + left : x2;

    add_flat(cover, is_dark ? &dark : of, x1, to);
    x1 = to;
  }
}

/* How much of each light comes to a point that looks along `normal`. Facets are
 * in front of what they stand for, or behind it: the point is let out. */
static void
parts_of_lights(const sg_shaded *in, sg_shading_work *work,
                const sg_tones *tones, const double seen[3],
                const double normal[3], bool facets, uint32_t *part)
{
  double p[3];

  sg_shading_place(in->scene, seen, p);
  for (unsigned i = 0; i < in->shadows && i < tones->ways; i++) {
    const sg_shadow *shadow = &in->shadow[i];
    double out = (facets ? 0.5 : 1.0 / 32) / sg_shadow_scale(shadow), at[3];
    sg_shading_work *light = sg_shading_work_of_light(work, i, shadow->scene);

    part[i] = SG_OPAQUE;
    for (int k = 0; k < 3; k++) {
      at[k] = p[k] + out * normal[k];
    }
    if (light && sg_dot(tones->way[i].to, normal) > 0) {
      (void)sg_shadow_part(shadow, light, at, &part[i]);
    }
  }
}

static void
light_at(const sg_shaded *in, sg_shading_work *work, const sg_face_look *look,
         const sg_span *span, double x, double y, uint32_t light[3])
{
  double depth, normal[3];
  uint32_t part[SG_TONE_WAYS] = {0};
  bool shadows = in->shadows > 0;

  sg_shading_point(in->scene, span, x, y, &depth, normal);
  if (shadows) {
    parts_of_lights(in, work, &look->tones, (double[3]){x, y, depth}, normal,
                    sg_shading_is_faceted(in->scene, span), part);
  }
  sg_ramp_at(&look->ramp, sg_tone(&look->tones, normal, shadows ? part : NULL),
             light);
  if (look->shine.ways > 0) {
    uint32_t more = sg_shine_at(&look->shine, normal, shadows ? part : NULL);
    for (int c = 0; c < 3; c++) {
      uint32_t all = light[c] + more;
      light[c] = all < SG_LIGHT_MOST ? all : SG_LIGHT_MOST;
    }
  }
}

/* A span, and how far it goes on to both sides as the same sheet. */
typedef struct sheet_span {
  const sg_span *span;
  int32_t x1, x2;
} sheet_span;

static sheet_span
sheet_of(const sg_spans *spans, size_t i)
{
  const sg_span *all = spans->span;
  size_t first = i, last = i;

  while (all[i].sheet > 0 && first > 0 &&
         sg_span_goes_on(&all[first - 1], &all[first])) {
    first--;
  }
  while (all[i].sheet > 0 && last + 1 < spans->n &&
         sg_span_goes_on(&all[last], &all[last + 1])) {
    last++;
  }
  return (sheet_span){&all[i], all[first].x1, all[last].x2};
}

/* What a span has of a light. */
static lit
part_of(const sg_span *span, const uint32_t light[3])
{
  lit out = {.part = span->part};

  for (int c = 0; c < 3; c++) {
    out.light[c] = (uint32_t)((uint64_t)light[c] * span->part / SG_OPAQUE);
  }
  return out;
}

/* What changes from line to line is looked at on each, never twice above the
 * same place of a dot. In 1/256 dot. */
static int32_t
place_in_dot(const sg_shaded *in, double line)
{
  unsigned k = (unsigned)((line - floor(line)) * in->lines);
  unsigned step = in->lines > 2 ? in->lines / 2 + 1 : 1;

  return (int32_t)((k * step + in->lines / 2) % in->lines * DOT / in->lines +
                   HALF / in->lines);
}

/* Dot after dot, with shadows. */
static void
add_shaded(sg_dot_row *cover, const sg_shaded *in, sg_shading_work *work,
           const sg_span *span, uint32_t number, double line)
{
  int32_t place = place_in_dot(in, line);

  for (int32_t x1 = span->x1; x1 < span->x2;) {
    int32_t dot = x1 / DOT, end = (dot + 1) * DOT, x = dot * DOT + place;
    uint32_t light[3];

    end = end < span->x2 ? end : span->x2;
    x = x < span->x1 ? span->x1 : x > span->x2 ? span->x2 : x;
    light_at(in, work, &in->looks.look[number], span, x / (double)DOT, line,
             light);
    lit own = part_of(span, light);
    add_part(cover->sum[dot], &own, (uint32_t)(end - x1));
    x1 = end;
  }
}

/* The place in or about a dot whose light it has, from the middle of what there
 * is of it on a line, in 1/256 dot: the middle of the dot or, if the sheet ends
 * before, its end; but if another sheet of a torus is seen there, `own`. */
static void
place_of_light(const sg_shaded *in, const sheet_span *sheet,
               const double own[2], double at[2])
{
  double centre = floor(own[0]) + 0.5;
  double x1 = sheet->x1 / (double)DOT, x2 = sheet->x2 / (double)DOT;

  at[0] = centre < x1 ? x1 : centre > x2 ? x2 : centre;
  at[1] = floor(own[1]) + 0.5;
  if (!sg_shading_sees_same(in->scene, sheet->span, own, at)) {
    memcpy(at, own, 2 * sizeof *at);
  }
}

static void
add_bent(sg_dot_row *cover, const sg_shaded *in, const sheet_span *sheet,
         uint32_t number, double line)
{
  const sg_span *span = sheet->span;
  const sg_face_look *look = &in->looks.look[number];
  uint64_t key = ((uint64_t)number << 36) + ((uint64_t)span->surface << 4) +
                 (uint64_t)(span->sense + 2);

  for (int32_t x1 = span->x1; x1 < span->x2;) {
    int32_t dot = x1 / DOT, end = (dot + 1) * DOT;

    end = end < span->x2 ? end : span->x2;
    if (cover->seen[dot] != key) {
      double at[2];
      place_of_light(in, sheet, (double[]){(x1 + end) / (2.0 * DOT), line}, at);
      light_at(in, NULL, look, span, at[0], at[1], cover->light[dot]);
      cover->seen[dot] = key;
    }
    lit own = part_of(span, cover->light[dot]);
    add_part(cover->sum[dot], &own, (uint32_t)(end - x1));
    x1 = end;
  }
}

static void
add_span(sg_dot_row *cover, const sg_shaded *in, sg_shading_work *work,
         const sheet_span *sheet, double line)
{
  const sg_span *span = sheet->span;
  uint32_t number = sg_face_number(&in->looks.numbers, span->leaf, span->face);
  const sg_face_look *look = &in->looks.look[number];
  uint32_t light[3];

  if (in->shadows > 0 && look->stripes.step == 0) {
    add_shaded(cover, in, work, span, number, line);
    return;
  }
  if (!sg_shading_is_flat(in->scene, span)) {
    add_bent(cover, in, sheet, number, line);
    return;
  }
  light_at(in, work, look, span, span->x1 / (double)DOT, line, light);
  lit own = part_of(span, light);
  if (look->stripes.step > 0) {
    add_striped(cover, &own, &look->stripes, span->x1, span->x2,
                (int64_t)(line * DOT));
  } else {
    add_flat(cover, &own, span->x1, span->x2);
  }
}

void
sg_cover_light(const sg_shaded *in, sg_shading_work *work, const sg_span *span,
               double x, double y, uint32_t light[3])
{
  const sg_face_look *look =
      &in->looks
           .look[sg_face_number(&in->looks.numbers, span->leaf, span->face)];
  int32_t left;

  light_at(in, work, look, span, x, y, light);
  if (look->stripes.step > 0 && sg_shading_is_flat(in->scene, span) &&
      in_stripe(&look->stripes, (int32_t)(x * DOT), (int64_t)(y * DOT),
                &left)) {
    darken(light);
  }
}

/* Whole dots, those whose middles are in the span. */
static void
add_middles(sg_dot_row *cover, const sg_shaded *in, sg_shading_work *work,
            sg_span span, double line)
{
  int32_t from, to = sg_span_dots(&span, &from);

  span.x1 = from * DOT;
  span.x2 = to * DOT;
  if (from < to) {
    const sheet_span sheet = {&span, span.x1, span.x2};
    add_span(cover, in, work, &sheet, line);
  }
}

static void
add_spans(sg_dot_row *cover, const sg_shaded *in, sg_shading_work *work,
          const sg_spans *spans, double line)
{
  for (size_t i = 0; i < spans->n; i++) {
    const sg_span *span = &spans->span[i];

    if (in->middles) {
      add_middles(cover, in, work, *span, line);
    } else {
      const sheet_span sheet = sheet_of(spans, i);
      add_span(cover, in, work, &sheet, line);
    }
  }
}

static int32_t
wanted_to(const sg_dot_row *cover, const sg_shaded *in)
{
  return in->to > 0 ? in->to : cover->width;
}

bool
sg_cover_row(sg_dot_row *cover, const sg_shaded *in, sg_shading_work *work,
             sg_spans *spans, int32_t y)
{
  const sg_line_part part = {in->from * DOT, wanted_to(cover, in) * DOT, false};

  memset(cover->sum, 0, (size_t)cover->width * sizeof *cover->sum);
  memset(cover->seen, 0, (size_t)cover->width * sizeof *cover->seen);
  for (unsigned k = 0; k < in->lines; k++) {
    double line = y + (k + 0.5) / in->lines;

    sg_spans kept;
    const sg_spans *here = &kept;
    if (in->scan) {
      kept = sg_scan_line(in->scan, (size_t)y * in->lines + k);
    } else if (sg_shading_line_part(in->scene, work, line, &part, spans)) {
      here = spans;
    } else {
      return false;
    }
    add_spans(cover, in, work, here, line);
  }
  return (!in->edges || sg_face_edges(cover, in, work, y)) &&
         !sg_shading_work_failed(work);
}

/* ---- bytes ---- */

/* The background shows where nothing covers it. */
static void
solid_dot(const uint32_t sum[4], const sg_shaded *in, unsigned shift,
          const uint8_t *byte, uint8_t out[3])
{
  uint32_t all = (uint32_t)1 << shift;
  uint64_t rest = (uint64_t)all * SG_OPAQUE - sum[3];

  for (int c = 0; c < 3; c++) {
    uint32_t behind = (uint32_t)(rest * in->background[c] / SG_OPAQUE);
    out[c] = byte[(sum[c] + behind + all / 2) >> shift];
  }
}

static void
clear_dot(const uint32_t sum[4], unsigned shift, const uint8_t *byte,
          uint8_t out[4])
{
  uint64_t part = sum[3], all = (uint64_t)SG_OPAQUE << shift;

  for (int c = 0; c < 3; c++) {
    uint64_t light =
        part > 0 ? ((uint64_t)sum[c] * SG_OPAQUE + part / 2) / part : 0;
    out[c] = byte[light < SG_LIGHT_MOST ? light : SG_LIGHT_MOST];
  }
  out[3] = (uint8_t)((part * UINT8_MAX + all / 2) / all);
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
  int32_t to = wanted_to(cover, in);
  out += (size_t)in->from * bytes;
  for (int32_t x = in->from; x < to; x++, out += bytes) {
    const uint32_t *sum = cover->sum[x];

    if (x > in->from &&
        memcmp(sum, cover->sum[x - 1], sizeof *cover->sum) == 0) {
      memcpy(out, out - bytes, bytes);
    } else if (in->clear) {
      clear_dot(sum, shift, byte, out);
    } else {
      solid_dot(sum, in, shift, byte, out);
    }
  }
}
