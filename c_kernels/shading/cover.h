/* cover.h -- a row of dots: how far each is covered, and by which light.
 *
 * Layer: kernel. A dot is crossed by `lines` scan lines. Each span counts as
 * wide as it is, in 1/256 dot, so a dot has whole sums, and no rounding but
 * that of the light, of which a see-through face has a part. Flat faces have
 * one light; of others it is that of the normal in the middle of a dot, once
 * for all its lines.
 */
#ifndef SG_COVER_H
#define SG_COVER_H

#include "scan.h"
#include "shading_scene.h"
#include "shadow.h"
#include "tone.h"

#define SG_COVER_LINES 16 /* most lines of a dot */

/* Stripes across the picture, darker than the face: where x + way * y, in 1/256
 * dot, is less than a quarter of `step` after a multiple of it. */
typedef struct sg_stripes {
  int32_t step; /* 0: none; else at least 4 */
  int32_t way;  /* 1 or -1 */
} sg_stripes;

typedef struct sg_face_look {
  sg_tones tones;
  sg_ramp ramp;
  sg_shine shine;
  sg_stripes stripes;
} sg_face_look;

typedef struct sg_looks {
  const sg_face_look *look;
  sg_face_numbers numbers; /* of looks */
} sg_looks;

/* What a picture is made from; all borrowed. */
typedef struct sg_shaded {
  const sg_shading *scene;
  unsigned lines; /* 1, 2, 4, 8 or 16 */
  sg_looks looks;
  const sg_opacities *opacities; /* null: all is opaque */
  uint16_t background[3];        /* light */
  bool clear;                    /* no background: dots have an alpha */
  const sg_shadow *shadow; /* [shadows]: of the lights of all looks in their
                              order; the picture is lit by no others then */
  unsigned shadows;        /* 0: there are none */
  bool middles;            /* with one line: what is in the middle of a dot
                              has all of it */
  bool edges;              /* a line where other faces begin */
  const sg_scan *scan;     /* null, or spans of this scene, lines, opacities */
  int32_t from, to;        /* dots of a row that are wanted; to 0: all */
} sg_shaded;

/* Sums of a row of dots. */
typedef struct sg_dot_row {
  int32_t width;
  uint32_t (*sum)[4]; /* [width]: light * 1/256 dots; 1/256 dots * SG_OPAQUE */
  uint64_t *seen;     /* [width]: which face `light` is of; 0: none */
  uint32_t (*light)[3];
  uint32_t *line; /* [width]: 1/256 dots of lines of `edges` */
} sg_dot_row;

/* False: no memory. Owner: sg_cover_close(). */
bool sg_cover_open(sg_dot_row *out, int32_t width);
void sg_cover_close(sg_dot_row *cover);

/* The sums of the row y of dots, right for those that are wanted. `spans` is
 * room. False: no memory. */
bool sg_cover_row(sg_dot_row *cover, const sg_shaded *in, sg_shading_work *work,
                  sg_spans *spans, int32_t y);

/* The light that a span sends at x, y, in dots. `work` is of its scene. */
void sg_cover_light(const sg_shaded *in, sg_shading_work *work,
                    const sg_span *span, double x, double y, uint32_t light[3]);

/* The bytes of those that are wanted, 3 a dot, or 4 if it is `clear`: red,
 * green, blue, alpha. `out` is that of the whole row, `byte` as of
 * sg_srgb_bytes(). */
void sg_cover_bytes(const sg_dot_row *cover, const sg_shaded *in,
                    const uint8_t *byte, uint8_t *out);

#endif
