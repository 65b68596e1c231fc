/* region_content.c -- see region_content.h. */
#include "region_content.h"

#include "engine/list.h"

#include <stdlib.h>
#include <string.h>

enum { ASKED = 1 << 14 };

#define UNKNOWN SIZE_MAX

typedef struct spreading {
  const sg_content_faces *f;
  size_t regions;
  size_t *around; /* [regions + 1] where its faces are in `face` */
  uint32_t *face; /* [2 * faces] */
  size_t *at;     /* [regions] where its list is in `item`; UNKNOWN: not yet */
  size_t *count;  /* [regions] */
  uint32_t *next; /* [regions] those that are known, in turn */
  SG_LIST_OF(int32_t) item;
} spreading;

/* Both sides of each face, but of those with one region there. */
static void
list_around(spreading *s)
{
  const uint32_t *side = s->f->side;

  for (size_t i = 0; i < 2 * s->f->faces; i++) {
    s->around[side[i] + 1] += side[i] != side[i ^ 1];
  }
  for (size_t r = 0; r < s->regions; r++) {
    s->around[r + 1] += s->around[r];
  }
  s->around[s->regions + 1] = s->around[s->regions];
  for (size_t i = 2 * s->f->faces; i-- > 0;) {
    if (side[i] != side[i ^ 1]) {
      s->face[--s->around[side[i] + 1]] = (uint32_t)(i / 2);
    }
  }
}

/* Lists what is beyond a face of region `from`: what that has, but of the
 * solids of the face only what it has not. */
static bool
cross(spreading *s, uint32_t from, size_t face)
{
  const int32_t *solid = s->f->solid;
  size_t a = s->at[from], a_end = a + s->count[from];
  size_t b = s->f->begin[face], b_end = s->f->begin[face + 1];

  if (!sg_list_need(&s->item.item, s->item.n + (a_end - a) + (b_end - b) + 1,
                    &s->item.room, sizeof *s->item.item)) {
    return false;
  }
  int32_t *item = s->item.item;

  while (a < a_end || b < b_end) {
    bool twice = b + 1 < b_end && solid[b] == solid[b + 1];

    if (twice) {
      b += 2;
    } else if (b == b_end || (a < a_end && item[a] < solid[b])) {
      item[s->item.n++] = item[a++];
    } else if (a == a_end || solid[b] < item[a]) {
      item[s->item.n++] = solid[b++];
    } else {
      a++;
      b++;
    }
  }
  return true;
}

/* Region r is beyond a face of region `from`. */
static bool
reach(spreading *s, uint32_t from, uint32_t r, size_t face)
{
  s->at[r] = s->item.n;
  bool good = cross(s, from, face);

  s->count[r] = s->item.n - s->at[r];
  return good;
}

/* Counts the faces that it is wrong to cross: beyond is something else. */
static bool
count_wrong(spreading *s, size_t *wrong)
{
  size_t n = s->item.n;
  bool good = true;

  *wrong = 0;
  for (size_t f = 0; good && f < s->f->faces; f++) {
    uint32_t a = s->f->side[2 * f], b = s->f->side[2 * f + 1];

    if (s->at[a] != UNKNOWN && s->at[b] != UNKNOWN) {
      good = cross(s, a, f);
      *wrong += good && (s->item.n - n != s->count[b] ||
                         memcmp(s->item.item + n, s->item.item + s->at[b],
                                s->count[b] * sizeof(int32_t)) != 0);
      s->item.n = n;
    }
  }
  return good;
}

static bool
spread(spreading *s, uint32_t outside, const sg_cancel *cancel)
{
  size_t known = 0;

  s->at[outside] = 0;
  s->next[known++] = outside;
  for (size_t i = 0; i < known; i++) {
    uint32_t r = s->next[i];

    for (size_t k = s->around[r + 1]; k < s->around[r + 2]; k++) {
      const uint32_t *side = s->f->side + 2 * (size_t)s->face[k];
      uint32_t other = side[side[0] == r];

      if (s->at[other] == UNKNOWN) {
        s->next[known++] = other;
        if (!reach(s, r, other, s->face[k])) {
          return false;
        }
      }
    }
    if (i % ASKED == ASKED - 1 && sg_cancelled(cancel)) {
      return false;
    }
  }
  return true;
}

static bool
put_in_order(const spreading *s, sg_region_content *out)
{
  size_t n = 0;

  out->begin = malloc((s->regions + 1) * sizeof *out->begin);
  out->solid = malloc((s->item.n + 1) * sizeof *out->solid);
  if (!out->begin || !out->solid) {
    return false;
  }
  for (size_t r = 0; r < s->regions; r++) {
    out->begin[r] = n;
    if (s->count[r] > 0) {
      memcpy(out->solid + n, s->item.item + s->at[r],
             s->count[r] * sizeof *out->solid);
      n += s->count[r];
    }
  }
  out->begin[s->regions] = n;
  return true;
}

bool
sg_region_content_make(const sg_content_faces *faces, size_t regions,
                       uint32_t outside, const sg_cancel *cancel,
                       sg_region_content *out, size_t *wrong)
{
  /* around: one more, as list_around() counts down to where they begin. */
  spreading s = {.f = faces,
                 .regions = regions,
                 .around = calloc(regions + 2, sizeof *s.around),
                 .face = malloc((2 * faces->faces + 1) * sizeof *s.face),
                 .at = malloc((regions + 1) * sizeof *s.at),
                 .count = calloc(regions + 1, sizeof *s.count),
                 .next = malloc((regions + 1) * sizeof *s.next)};
  bool good = s.around && s.face && s.at && s.count && s.next;

  *out = (sg_region_content){0};
  if (good) {
    for (size_t r = 0; r < regions; r++) {
      s.at[r] = UNKNOWN;
    }
    list_around(&s);
    good = spread(&s, outside, cancel) && put_in_order(&s, out) &&
           count_wrong(&s, wrong);
  }
  free(s.around);
  free(s.face);
  free(s.at);
  free(s.count);
  free(s.next);
  free(s.item.item);
  return good;
}

void
sg_region_content_clear(sg_region_content *content)
{
  free(content->begin);
  free(content->solid);
  *content = (sg_region_content){0};
}
