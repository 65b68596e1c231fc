/* face_merge_grow.c -- which faces become one: see face_merge_private.h.
 *
 * Layer: kernel. Faces that might be one are connected in patches. Mostly one
 * plane fits all of a patch; else groups grow in it, the largest face first.
 */
#include "face_merge_private.h"

#include "engine/list.h"
#include "engine/search.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  GAP = 16,   /* tolerances by which what is next to a group must bend off */
  ROUNDS = 8, /* at most as often a growing group looks for a better plane */
  OFTEN = 64, /* patches between questions */
  BLOCK = 1 << 11 /* faces a task */
};

/* Of faces. Those of a smooth surface become one only where they are flat up
 * to rounding. */
enum { UNSEEN, SEEN, SMOOTH, PLACED };

typedef struct growth {
  sg_merge *m;
  uint32_t *first;    /* [faces + 2]: of a face in `other` */
  uint32_t *other;    /* [2 * weaks] */
  sg_face_size *size; /* [faces], of those that have neighbours */
  uint8_t *state;     /* [faces] */
  uint32_t *mark;     /* [faces]: the last attempt that had the face */
  uint32_t attempt;
  uint32_t *patch; /* [n]: of the faces that are connected */
  size_t n;
} growth;

typedef struct seed {
  double area, centre[3];
  uint32_t face;
} seed;

/* ---- groups ------------------------------------------------------------- */

static sg_group *
add_group(sg_merge *m, uint32_t first, uint32_t n)
{
  if (!sg_list_grow(&m->group, m->groups, &m->room, sizeof *m->group)) {
    return NULL;
  }
  sg_group *group = &m->group[m->groups];
  *group = (sg_group){.first = first, .n = n, .largest = m->member[first]};
  for (uint32_t i = first; i < first + n; i++) {
    m->group_of[m->member[i]] = (uint32_t)m->groups;
  }
  m->groups++;
  return group;
}

/* Makes room for n members more. */
static bool
reserve(sg_merge *m, size_t n)
{
  return sg_list_need(&m->member, m->members + n, &m->member_room,
                      sizeof *m->member);
}

sg_group *
sg_merge_alone(sg_merge *m, uint32_t face)
{
  sg_face_size size;

  if (!reserve(m, 1)) {
    return NULL;
  }
  m->member[m->members] = face;
  sg_group *group = add_group(m, (uint32_t)m->members, 1);
  if (group) {
    m->members++;
    sg_merge_size(m, face, &size);
    if (m->solid->face[face].n < 2 || sg_merge_is_thin(m, &size) ||
        !sg_merge_fit(m, &face, 1, &group->plane)) {
      group->state = SG_AS_IT_WAS;
    }
  }
  return group;
}

/* ---- one patch ---------------------------------------------------------- */

static bool
looks_as(const growth *g, const sg_plane *plane, uint32_t face)
{
  const sg_face_size *size = &g->size[face];

  return sg_merge_is_thin(g->m, size) || size->vector[0] * plane->n[0] +
                                                 size->vector[1] * plane->n[1] +
                                                 size->vector[2] * plane->n[2] >
                                             0;
}

/* All faces from `from` on are one group, if there are several. */
static bool
place(growth *g, size_t from, const sg_plane *plane)
{
  sg_merge *m = g->m;
  uint32_t n = (uint32_t)(m->members - from);
  sg_group *group;

  for (size_t i = from; i < m->members; i++) {
    g->state[m->member[i]] = PLACED;
  }
  if (n < 2) {
    m->members = from;
    return true;
  }
  group = add_group(m, (uint32_t)from, n);
  if (!group) {
    return false;
  }
  group->plane = *plane;
  for (size_t i = from; i < m->members; i++) {
    uint32_t face = m->member[i];
    double more = g->size[face].area - g->size[group->largest].area;
    if (more > 0 || (more == 0 && face < group->largest)) {
      group->largest = face;
    }
    group->thin = group->thin || sg_merge_is_thin(m, &g->size[face]);
  }
  return true;
}

/* One plane for all of the patch. */
static bool
is_whole(const growth *g, sg_plane *plane)
{
  if (!sg_merge_fit(g->m, g->patch, g->n, plane)) {
    return false;
  }
  for (size_t i = 0; i < g->n; i++) {
    if (!looks_as(g, plane, g->patch[i])) {
      return false;
    }
  }
  return true;
}

/* Whether `other`, next to the group, bends off so little that both may be
 * parts of one smooth surface. */
static bool
goes_on(const growth *g, const sg_plane *plane, uint32_t face, uint32_t other)
{
  const sg_merge *m = g->m;
  sg_face_size size;

  if (g->mark[other] == g->attempt ||
      !sg_merge_is_near(m, plane, other, GAP * m->tolerance) ||
      !sg_merge_may_join(m, face, other)) {
    return false;
  }
  sg_merge_size(m, other, &size);
  return !sg_merge_is_thin(m, &size) && size.vector[0] * plane->n[0] +
                                                size.vector[1] * plane->n[1] +
                                                size.vector[2] * plane->n[2] >
                                            0;
}

/* Whether the surface ends or bends clearly all round the members from `from`
 * on. Else they are a part of something curved that is finer than the
 * tolerance, and where they end would be chance. */
static bool
stands_out(growth *g, size_t from, const sg_plane *plane)
{
  const sg_merge *m = g->m;

  g->attempt++;
  for (size_t i = from; i < m->members; i++) {
    g->mark[m->member[i]] = g->attempt;
  }
  for (size_t i = from; i < m->members; i++) {
    const sg_solid_face *face = &m->solid->face[m->member[i]];
    for (uint32_t half = 3 * face->first; half < 3 * (face->first + face->n);
         half++) {
      uint32_t twin = m->twin[half];
      if (twin != SG_NOTHING &&
          goes_on(g, plane, m->member[i], m->face_of[twin / 3])) {
        return false;
      }
    }
  }
  return true;
}

/* Takes the neighbours of member i that lie in the plane and are in no group,
 * nor in more than `most` of a state. */
static void
take_neighbours(growth *g, size_t i, const sg_plane *plane, uint8_t most)
{
  sg_merge *m = g->m;
  uint32_t face = m->member[i];

  for (uint32_t k = g->first[face]; k < g->first[face + 1]; k++) {
    uint32_t other = g->other[k];
    if (g->state[other] <= most &&
        sg_merge_is_near(m, plane, other, m->tolerance) &&
        looks_as(g, plane, other)) {
      g->state[other] = PLACED;
      m->member[m->members++] = other;
    }
  }
}

/* Adds a seed and what grows from it to the members. What is found in the plane
 * of the seed gives a better plane: small faces know theirs badly. False: the
 * seed has no plane, and there is nothing. */
static bool
gather(growth *g, uint32_t face, uint8_t most, sg_plane *plane)
{
  sg_merge *m = g->m;
  size_t from = m->members, before = 0;
  sg_plane better;

  if (!sg_merge_fit(m, &face, 1, plane)) {
    return false;
  }
  m->member[m->members++] = face;
  g->state[face] = PLACED;
  for (int round = 0; round < ROUNDS && before != m->members; round++) {
    before = m->members;
    for (size_t i = from; i < m->members; i++) {
      take_neighbours(g, i, plane, most);
    }
    if (m->members == from + 1 ||
        !sg_merge_fit(m, m->member + from, m->members - from, &better)) {
      break;
    }
    *plane = better;
  }
  return true;
}

/* The group of a seed: all in one plane within the tolerance; or, if that is a
 * part of a smooth surface, all that are flat up to rounding. */
static bool
grow_from(growth *g, uint32_t face)
{
  sg_merge *m = g->m;
  size_t from = m->members;
  double tolerance = m->tolerance;
  sg_plane plane;

  if (g->state[face] == SEEN) {
    if (!gather(g, face, SEEN, &plane)) {
      return true;
    }
    if (m->members == from + 1 || stands_out(g, from, &plane)) {
      return place(g, from, &plane);
    }
    for (size_t i = from; i < m->members; i++) {
      g->state[m->member[i]] = SMOOTH;
    }
    m->members = from;
  }
  m->tolerance = m->rounding;
  bool any = gather(g, face, SMOOTH, &plane);
  m->tolerance = tolerance;
  return !any || place(g, from, &plane);
}

/* The largest first; equal ones by where they are. */
SG_ORDER(compare_seeds, seed,
         SG_BY_MOST(area) SG_BY(centre[0]) SG_BY(centre[1]) SG_BY(centre[2])
             SG_BY(face));

static sg_merge_end
grow_all(growth *g, seed *seeds, size_t n)
{
  switch (
      sg_sort(seeds, n, sizeof *seeds, compare_seeds, g->m->options->cancel)) {
  case SG_SORT_STOPPED:
    return SG_MERGE_STOPPED;
  case SG_SORT_NO_MEMORY:
    return SG_MERGE_NO_MEMORY;
  case SG_SORTED:
    break;
  }
  for (size_t i = 0; i < n; i++) {
    if (i % OFTEN == 0 && sg_cancelled(g->m->options->cancel)) {
      return SG_MERGE_STOPPED;
    }
    if (g->state[seeds[i].face] != PLACED && !grow_from(g, seeds[i].face)) {
      return SG_MERGE_NO_MEMORY;
    }
  }
  return SG_MERGE_DONE;
}

/* Those of the patch that may be seeds. */
static sg_merge_end
divide(growth *g)
{
  seed *seeds = malloc(g->n * sizeof *seeds);
  size_t n = 0;

  if (!seeds) {
    return SG_MERGE_NO_MEMORY;
  }
  for (size_t i = 0; i < g->n; i++) {
    uint32_t face = g->patch[i];
    const sg_face_size *size = &g->size[face];
    if (!sg_merge_is_thin(g->m, size)) {
      seeds[n++] = (seed){size->area,
                          {size->centre[0], size->centre[1], size->centre[2]},
                          face};
    }
  }
  sg_merge_end end = n ? grow_all(g, seeds, n) : SG_MERGE_DONE;
  free(seeds);
  return end;
}

static bool
has_seed(const growth *g)
{
  for (size_t i = 0; i < g->n; i++) {
    if (!sg_merge_is_thin(g->m, &g->size[g->patch[i]])) {
      return true;
    }
  }
  return false;
}

static sg_merge_end
do_patch(growth *g)
{
  sg_merge *m = g->m;
  size_t from = m->members;
  sg_plane plane;

  if (!has_seed(g)) {
    return SG_MERGE_DONE;
  }
  if (!reserve(m, g->n)) {
    return SG_MERGE_NO_MEMORY;
  }
  if (!is_whole(g, &plane)) {
    return divide(g);
  }
  memcpy(m->member + from, g->patch, g->n * sizeof *g->patch);
  m->members += g->n;
  if (stands_out(g, from, &plane)) {
    return place(g, from, &plane) ? SG_MERGE_DONE : SG_MERGE_NO_MEMORY;
  }
  m->members = from;
  return divide(g);
}

/* ---- all patches -------------------------------------------------------- */

static void
list_neighbours(growth *g)
{
  const sg_merge *m = g->m;

  for (size_t i = 0; i < m->weaks; i++) {
    g->first[m->weak[i][0] + 2]++;
    g->first[m->weak[i][1] + 2]++;
  }
  for (size_t f = 0; f < m->solid->faces; f++) {
    g->first[f + 2] += g->first[f + 1];
  }
  for (size_t i = 0; i < m->weaks; i++) {
    uint32_t a = m->weak[i][0], b = m->weak[i][1];
    g->other[g->first[a + 1]++] = b;
    g->other[g->first[b + 1]++] = a;
  }
}

static void
find_sizes(void *data, size_t block)
{
  const growth *g = data;
  uint32_t to = (uint32_t)(block + 1) * BLOCK;

  for (uint32_t f = to - BLOCK; f < to && f < g->m->solid->faces; f++) {
    if (g->first[f + 1] > g->first[f]) {
      sg_merge_size(g->m, f, &g->size[f]);
    }
  }
}

/* The faces that are connected with this one; false: stopped. */
static bool
find_patch(growth *g, uint32_t face)
{
  g->n = 0;
  g->patch[g->n++] = face;
  g->state[face] = SEEN;
  for (size_t i = 0; i < g->n; i++) {
    uint32_t f = g->patch[i];
    if (i % BLOCK == BLOCK - 1 && sg_cancelled(g->m->options->cancel)) {
      return false;
    }
    for (uint32_t k = g->first[f]; k < g->first[f + 1]; k++) {
      if (g->state[g->other[k]] == UNSEEN) {
        g->state[g->other[k]] = SEEN;
        g->patch[g->n++] = g->other[k];
      }
    }
  }
  return true;
}

static sg_merge_end
do_patches(growth *g)
{
  sg_merge_end end = SG_MERGE_DONE;

  list_neighbours(g);
  if (!sg_pool_run(g->m->options->pool,
                   (g->m->solid->faces + BLOCK - 1) / BLOCK, find_sizes, g,
                   g->m->options->cancel)) {
    return SG_MERGE_STOPPED;
  }
  for (uint32_t f = 0; f < g->m->solid->faces && end == SG_MERGE_DONE; f++) {
    if (f % OFTEN == 0 && sg_cancelled(g->m->options->cancel)) {
      return SG_MERGE_STOPPED;
    }
    if (g->state[f] == UNSEEN && g->first[f + 1] > g->first[f]) {
      end = find_patch(g, f) ? do_patch(g) : SG_MERGE_STOPPED;
    }
  }
  return end;
}

static sg_merge_end
grow(sg_merge *m)
{
  size_t faces = m->solid->faces;
  growth g = {.m = m,
              .first = calloc(faces + 2, sizeof *g.first),
              .other = malloc((2 * m->weaks + 1) * sizeof *g.other),
              .size = malloc((faces + 1) * sizeof *g.size),
              .state = calloc(faces + 1, sizeof *g.state),
              .mark = calloc(faces + 1, sizeof *g.mark),
              .patch = malloc((faces + 1) * sizeof *g.patch)};
  bool memory = g.first && g.other && g.size && g.state && g.mark && g.patch;
  sg_merge_end end = memory ? do_patches(&g) : SG_MERGE_NO_MEMORY;

  free(g.first);
  free(g.other);
  free(g.size);
  free(g.state);
  free(g.mark);
  free(g.patch);
  return end;
}

/* The members of each group in ascending order. */
static bool
order_members(sg_merge *m)
{
  uint32_t *next = malloc((m->groups + 1) * sizeof *next);

  for (size_t i = 0; next && i < m->groups; i++) {
    next[i] = m->group[i].first;
  }
  for (uint32_t f = 0; next && f < m->solid->faces; f++) {
    uint32_t number = m->group_of[f];
    if (number != SG_NOTHING) {
      m->member[next[number]++] = f;
    }
  }
  bool done = next;
  free(next);
  return done;
}

sg_merge_end
sg_merge_grow(sg_merge *m)
{
  size_t faces = m->solid->faces;

  m->group_of = malloc((faces + 1) * sizeof *m->group_of);
  if (!m->group_of) {
    return SG_MERGE_NO_MEMORY;
  }
  memset(m->group_of, 0xff, faces * sizeof *m->group_of);
  sg_merge_end end = m->weaks ? grow(m) : SG_MERGE_DONE;
  return end == SG_MERGE_DONE && m->groups && !order_members(m)
             ? SG_MERGE_NO_MEMORY
             : end;
}
