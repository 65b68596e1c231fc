/* face_merge_hold.c -- see face_merge_hold.h. */
#include "face_merge_hold.h"
#include "engine/list.h"
#include "engine/search.h"

#include <stdlib.h>

/* A face of another label has a border from v to w. */
static bool
other_between(const sg_merge *m, uint32_t label, uint32_t v, uint32_t w)
{
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    uint32_t half = m->leaving[i].half;
    if (m->leaving[i].to == w && sg_half_label(m, half) != label &&
        sg_half_is_border(m, half)) {
      return true;
    }
  }
  return false;
}

/* Its opposite is seen too, so it comes both ways. */
static bool
is_wanted(const sg_merge *m, uint32_t half)
{
  uint32_t v = sg_half_start(m, half), w = sg_half_end(m, half);
  uint32_t label = sg_half_label(m, half);

  return m->fate[v] == SG_KEPT && m->fate[w] == SG_KEPT &&
         !sg_half_is_border(m, half) &&
         (other_between(m, label, v, w) || other_between(m, label, w, v));
}

static bool
add(sg_holds *holds, uint32_t from, uint32_t to)
{
  if (!sg_list_grow(&holds->pair, holds->n, &holds->room,
                    sizeof *holds->pair)) {
    return false;
  }
  holds->pair[holds->n][0] = from;
  holds->pair[holds->n++][1] = to;
  return true;
}

SG_ORDER(compare, uint32_t, SG_BY_AT(0) SG_BY_AT(1));

bool
sg_holds_find(const sg_merge *m, const sg_group *group, sg_holds *out)
{
  out->n = 0;
  for (uint32_t i = group->first; i < group->first + group->n; i++) {
    const sg_solid_face *face = &m->solid->face[m->member[i]];
    for (uint32_t half = 3 * face->first; half < 3 * (face->first + face->n);
         half++) {
      if (is_wanted(m, half) &&
          !add(out, sg_half_start(m, half), sg_half_end(m, half))) {
        return false;
      }
    }
  }
  if (out->n) {
    qsort(out->pair, out->n, sizeof *out->pair, compare);
  }
  return true;
}

/* The place of the first pair that is not before (from, to). */
static size_t
place_of(const sg_holds *holds, uint32_t from, uint32_t to)
{
  const uint32_t key[2] = {from, to};
  size_t at;

  SG_SEARCH(at, 0, holds->n, compare(holds->pair[at], key) < 0);
  return at;
}

bool
sg_holds_have(const sg_holds *holds, uint32_t from, uint32_t to)
{
  size_t i = place_of(holds, from, to);

  return i < holds->n && holds->pair[i][0] == from && holds->pair[i][1] == to;
}

bool
sg_holds_reach(const sg_holds *holds, uint32_t v)
{
  size_t i = place_of(holds, v, 0);

  return i < holds->n && holds->pair[i][0] == v;
}
