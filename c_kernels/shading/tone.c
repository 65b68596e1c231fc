/* tone.c -- see tone.h. */
#include "tone.h"

#include "number/vector.h"

#include <math.h>

static uint32_t
kept(double tone)
{
  return tone >= 1   ? SG_TONE_MOST
         : tone >= 0 ? (uint32_t)(tone * SG_TONE_MOST + 0.5)
                     : 0;
}

void
sg_tone_normal(unsigned i, unsigned j, double out[3])
{
  double u = 2.0 * i / (SG_TONE_SIDE - 1) - 1;
  double v = 2.0 * j / (SG_TONE_SIDE - 1) - 1;
  double x = (u + v) / 2, y = (u - v) / 2, z = 1 - fabs(x) - fabs(y);
  double length = sqrt(x * x + y * y + z * z);

  out[0] = x / length;
  out[1] = y / length;
  out[2] = z / length;
}

/* Where the table has a coordinate of -1 .. 1: the entry before it, and how far
 * behind that it is. */
static unsigned
entry(double u, double *part)
{
  double at = (u + 1) / 2 * (SG_TONE_SIDE - 1);
  unsigned i = at <= 0                  ? 0
               : at >= SG_TONE_SIDE - 1 ? SG_TONE_SIDE - 2
                                        : (unsigned)at;

  i = i > SG_TONE_SIDE - 2 ? SG_TONE_SIDE - 2 : i;
  *part = at - i;
  return i;
}

/* What looks away from the eye, as a normal may where rays spread, counts as
 * seen edge-on. */
static uint32_t
tone_of_table(const sg_tones *tones, const double normal[3])
{
  double x = sg_dot(tones->axis[0], normal), y = sg_dot(tones->axis[1], normal);
  double z = fmax(sg_dot(tones->axis[2], normal), 0.0);
  double sum = fabs(x) + fabs(y) + z, p, q;

  if (!(sum > 0)) {
    return 0;
  }
  unsigned i = entry((x + y) / sum, &p), j = entry((x - y) / sum, &q);
  const float *t = &tones->table[i * SG_TONE_SIDE + j];

  return kept((t[0] * (1 - q) + t[1] * q) * (1 - p) +
              (t[SG_TONE_SIDE] * (1 - q) + t[SG_TONE_SIDE + 1] * q) * p);
}

static double
come(const uint32_t *part, unsigned i)
{
  return part ? part[i] / (double)SG_TONE_MOST : 1.0;
}

uint32_t
sg_tone(const sg_tones *tones, const double normal[3], const uint32_t *part)
{
  double tone = tones->constant;

  if (tones->table) {
    return tone_of_table(tones, normal);
  }
  for (unsigned i = 0; i < tones->ways; i++) {
    const sg_tone_way *way = &tones->way[i];
    double one = way->factor * sg_dot(way->to, normal) * come(part, i);
    tone += one > way->least ? one : way->least;
  }
  return kept(tone);
}

static double
power_of(double base, unsigned power)
{
  double out = 1.0;

  for (; power > 0; power /= 2, base *= base) {
    out *= power % 2 == 1 ? base : 1.0;
  }
  return out;
}

uint32_t
sg_shine_at(const sg_shine *shine, const double normal[3], const uint32_t *part)
{
  double sum = 0.0;

  for (unsigned i = 0; i < shine->ways; i++) {
    double along = sg_dot(shine->way[i].to, normal);
    if (along > 0) {
      sum +=
          shine->way[i].factor * power_of(along, shine->power) * come(part, i);
    }
  }
  return kept(sum);
}
