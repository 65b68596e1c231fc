/* solid_border.c -- half-edges that end a face: see solid_border.h. */
#include "solid_border.h"

#include "thread_pool.h"

#include <stdlib.h>
#include <string.h>

enum {
  FEW = 8,      /* triangles, of which every pair of half-edges is looked at */
  ASKED = 4096, /* triangles between questions */
  /* What a slot holds: 0, nothing; or */
  LEFT = 1, /* a half-edge was here, and is paired */
  HALF = 2  /* this + the half-edge */
};

void
sg_border_clear(sg_border *border)
{
  free(border->slot);
  *border = (sg_border){0};
}

/* A half-edge of a face is a number: 3 * triangle of the face + corner. */
typedef struct face {
  const uint32_t (*triangle)[3];
  uint8_t *out;
  uint32_t n;
  uint32_t *slot; /* of many triangles: [mask + 1] */
  size_t mask;
} face;

static void
ends_of(const face *f, uint32_t half, uint32_t end[2])
{
  const uint32_t *v = f->triangle[half / 3];

  end[0] = v[half % 3];
  end[1] = v[(half % 3 + 1) % 3];
}

static void
pair_up(const face *f, uint32_t one, uint32_t other)
{
  f->out[one / 3] &= (uint8_t) ~(1 << one % 3);
  f->out[other / 3] &= (uint8_t) ~(1 << other % 3);
}

static bool
is_open(const face *f, uint32_t half)
{
  return f->out[half / 3] >> half % 3 & 1;
}

static void
pair_few(const face *f)
{
  for (uint32_t i = 3; i < 3 * f->n; i++) {
    uint32_t a[2], b[2];
    ends_of(f, i, a);
    for (uint32_t k = 0; k < i; k++) {
      ends_of(f, k, b);
      if (a[0] == b[1] && a[1] == b[0] && is_open(f, k)) {
        pair_up(f, i, k);
        break;
      }
    }
  }
}

/* Slots for its half-edges, all free. */
static bool
make_room(sg_border *border, face *f)
{
  size_t room = 64;

  while (room < 6 * (size_t)f->n) {
    room *= 2;
  }
  if (room > border->room) {
    free(border->slot);
    border->slot = malloc(room * sizeof *border->slot);
    border->room = border->slot ? room : 0;
  }
  f->slot = border->slot;
  f->mask = room - 1;
  if (f->slot) {
    memset(f->slot, 0, room * sizeof *f->slot);
  }
  return f->slot != NULL;
}

/* The same for both directions of an edge. */
static size_t
place_of(const uint32_t end[2])
{
  uint64_t low = end[0] < end[1] ? end[0] : end[1];
  uint64_t high = end[0] < end[1] ? end[1] : end[0];
  uint64_t h = (high << 32 | low) * UINT64_C(0x9e3779b97f4a7c15);

  return (size_t)(h ^ h >> 29);
}

/* Pairs a half-edge with an open opposite one, or puts it where that one will
 * look for it. */
static void
enter(const face *f, uint32_t half)
{
  uint32_t a[2], b[2];
  size_t at;

  ends_of(f, half, a);
  for (at = place_of(a) & f->mask; f->slot[at]; at = (at + 1) & f->mask) {
    if (f->slot[at] == LEFT) {
      continue;
    }
    ends_of(f, f->slot[at] - HALF, b);
    if (a[0] == b[1] && a[1] == b[0]) {
      pair_up(f, half, f->slot[at] - HALF);
      f->slot[at] = LEFT;
      return;
    }
  }
  f->slot[at] = half + HALF;
}

static bool
pair_many(sg_border *border, face *f)
{
  if (!make_room(border, f)) {
    return false;
  }
  for (uint32_t t = 0; t < f->n; t++) {
    for (uint32_t k = 0; k < 3; k++) {
      enter(f, 3 * t + k);
    }
    if (t % ASKED == ASKED - 1 && sg_pool_stopping()) {
      return false;
    }
  }
  return true;
}

bool
sg_border_find(sg_border *border, const sg_solid *solid, size_t number,
               uint8_t *out, uint32_t *edges)
{
  const sg_solid_face *of = &solid->face[number];
  face f = {.triangle = (const uint32_t(*)[3])(solid->triangle + of->first),
            .out = out + of->first,
            .n = of->n};

  memset(f.out, 7, f.n);
  if (f.n == 1) {
    *edges = 3;
    return true;
  }
  if (f.n <= FEW) {
    pair_few(&f);
  } else if (!pair_many(border, &f)) {
    return false;
  }
  *edges = 0;
  for (uint32_t t = 0; t < f.n; t++) {
    *edges += (uint32_t)__builtin_popcount(f.out[t]);
  }
  return true;
}
