/* tone.h -- how light a surface is, and which light it sends.
 *
 * Layer: kernel. A tone is 0 to SG_TONE_MOST; a look makes light of it, linear,
 * 0 to 65535 (srgb.h), by a ramp. The tone follows from the normal: a sum over
 * lights, or, where a rule decides, a table over all normals to the eye.
 */
#ifndef SG_TONE_H
#define SG_TONE_H

#include <stdbool.h>
#include <stdint.h>

#define SG_TONE_MOST  65536
#define SG_TONE_WAYS  9       /* most lights */
#define SG_TONE_SIDE  128     /* normals along a side of the table */
#define SG_RAMP       1024    /* steps of a ramp */
#define SG_SHINE_MOST 1000000 /* the highest power */

/* `least` or more, and factor * (normal . to). */
typedef struct sg_tone_way {
  double to[3]; /* a unit vector of the model's axes */
  double factor, least;
} sg_tone_way;

/* Without a table: constant + the sum of all ways, kept in 0 .. 1. With one:
 * `axis` are what is right, up and towards the eye in the model, unit vectors;
 * entry (i, j) is that of the normal sg_tone_normal(i, j). */
typedef struct sg_tones {
  double constant;
  unsigned ways;
  sg_tone_way way[SG_TONE_WAYS];
  const float *table; /* [SG_TONE_SIDE][SG_TONE_SIDE], or null; borrowed */
  double axis[3][3];
} sg_tones;

/* The tone of a side that looks along `normal`, a unit vector of the model.
 * `part`, if not null, is how much of each way comes there, of SG_TONE_MOST;
 * a table heeds it not. */
uint32_t sg_tone(const sg_tones *tones, const double normal[3],
                 const uint32_t *part);

/* Light of its own that a side throws back: at a place the sum of factor times
 * (normal . to)^power, where that is above 0; `to` halves the angle between the
 * eye and a light. */
typedef struct sg_shine {
  unsigned power; /* 1 .. SG_SHINE_MOST */
  unsigned ways;
  sg_tone_way way[SG_TONE_WAYS];
} sg_shine;

/* Light, 0 .. SG_TONE_MOST. `part` as above. */
uint32_t sg_shine_at(const sg_shine *shine, const double normal[3],
                     const uint32_t *part);

/* The unit vector (right, up, towards the eye) of an entry of the table: half
 * of an octahedron, flattened. */
void sg_tone_normal(unsigned i, unsigned j, double out[3]);

/* light[k] is that of the tone k / SG_RAMP; the last one is there twice. */
typedef struct sg_ramp {
  uint16_t light[SG_RAMP + 2][3];
} sg_ramp;

/* The light of a tone, between two steps. */
static inline void
sg_ramp_at(const sg_ramp *ramp, uint32_t tone, uint32_t out[3])
{
  uint32_t k = tone / (SG_TONE_MOST / SG_RAMP);
  uint32_t part = tone % (SG_TONE_MOST / SG_RAMP);

  for (int c = 0; c < 3; c++) {
    uint32_t low = ramp->light[k][c], high = ramp->light[k + 1][c];
    out[c] = (low * (SG_TONE_MOST / SG_RAMP - part) + high * part +
              SG_TONE_MOST / SG_RAMP / 2) /
             (SG_TONE_MOST / SG_RAMP);
  }
}

#endif
