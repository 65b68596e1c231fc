/* face_merge_vertex.c -- which vertices may vanish: see face_merge_private.h.
 *
 * Layer: kernel. Exact: it looks at numbers of vertices and labels alone.
 */
#include "face_merge_private.h"

#include <string.h>

enum {
  BLOCK = 1 << 12, /* vertices a task */
  MOST = 16        /* border half-edges at a vertex that may vanish */
};

/* What there is round a vertex. */
typedef struct around {
  uint32_t label[3]; /* different ones; the third stands for all others */
  unsigned labels;
  bool regular; /* all half-edges have twins */
  uint32_t adjacent[2];
  unsigned adjacents;
  unsigned borders;
  struct {
    uint32_t label;
    bool second;  /* to or from adjacent[1] */
    bool leaving; /* from the vertex */
  } border[MOST];
} around;

static void
note_label(around *a, uint32_t label)
{
  for (unsigned i = 0; i < a->labels; i++) {
    if (a->label[i] == label) {
      return;
    }
  }
  if (a->labels < 3) {
    a->label[a->labels++] = label;
  }
}

/* False: there are too many edges for a vertex that vanishes. */
static bool
note_border(around *a, uint32_t label, uint32_t other, bool leaving)
{
  unsigned i = 0;

  while (i < a->adjacents && a->adjacent[i] != other) {
    i++;
  }
  if (i == 2 || a->borders == MOST) {
    return false;
  }
  if (i == a->adjacents) {
    a->adjacent[a->adjacents++] = other;
  }
  a->border[a->borders].label = label;
  a->border[a->borders].second = i == 1;
  a->border[a->borders++].leaving = leaving;
  return true;
}

/* As many half-edges of a label come from either neighbour as go on to the
 * other. */
static bool
goes_through(const around *a, uint32_t label)
{
  int balance[2] = {0, 0};
  bool any = false;

  for (unsigned i = 0; i < a->borders; i++) {
    if (a->border[i].label == label) {
      bool way = a->border[i].second == a->border[i].leaving;
      balance[way] += a->border[i].leaving ? 1 : -1;
      any = true;
    }
  }
  return any && balance[0] == 0 && balance[1] == 0;
}

static void
look_round(const sg_merge *m, uint32_t v, around *a)
{
  a->regular = true;
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    uint32_t out = m->leaving[i].half, in = sg_half_next(sg_half_next(out));
    note_label(a, sg_half_label(m, out));
    if (!m->regular) {
      a->regular =
          a->regular && m->twin[out] != SG_NOTHING && m->twin[in] != SG_NOTHING;
    } else if (a->labels > 2) {
      return; /* that is enough to keep it */
    }
  }
}

static bool
borders_found(const sg_merge *m, uint32_t v, around *a)
{
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    uint32_t out = m->leaving[i].half, in = sg_half_next(sg_half_next(out));
    uint32_t label = sg_half_label(m, out);
    if ((sg_half_is_border(m, out) &&
         !note_border(a, label, sg_half_end(m, out), true)) ||
        (sg_half_is_border(m, in) &&
         !note_border(a, label, sg_half_start(m, in), false))) {
      return false;
    }
  }
  return true;
}

static uint8_t
fate_of(const sg_merge *m, uint32_t v, uint32_t adjacent[2])
{
  around a = {0};

  look_round(m, v, &a);
  if (a.labels == 0 || (a.labels > 2 && a.regular) ||
      !borders_found(m, v, &a)) {
    return SG_KEPT;
  }
  if (a.borders == 0) {
    return a.labels == 1 ? SG_INNER : SG_KEPT;
  }
  if (a.adjacents != 2 || a.adjacent[0] == v || a.adjacent[1] == v) {
    return SG_KEPT;
  }
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    if (!goes_through(&a, sg_half_label(m, m->leaving[i].half))) {
      return SG_KEPT;
    }
  }
  adjacent[0] = a.adjacent[0];
  adjacent[1] = a.adjacent[1];
  return SG_STRAIGHT;
}

static void
do_block(void *data, size_t block)
{
  sg_merge *m = data;
  size_t to = (block + 1) * BLOCK;

  for (size_t v = block * BLOCK; v < to && v < m->solid->vertices; v++) {
    if (v % 256 == 0 && sg_pool_stopping()) {
      return;
    }
    if (m->fate[v] == SG_ASKED) {
      m->fate[v] = fate_of(m, (uint32_t)v, m->adjacent[v]);
    }
  }
}

/* ---- what groups allow -------------------------------------------------- */

static sg_group *
group_at(sg_merge *m, uint32_t half)
{
  uint32_t face = m->face_of[half / 3], group = m->group_of[face];

  return group == SG_NOTHING ? sg_merge_alone(m, face) : &m->group[group];
}

/* 1: all groups round v let it go, 0: some do not, -1: no memory. */
static int
is_let_go(sg_merge *m, uint32_t v)
{
  uint32_t last = SG_NOTHING;
  bool inner = m->fate[v] == SG_INNER; /* then they have one label */
  uint32_t end = inner ? m->first[v] + 1 : m->first[v + 1];
  sg_group_state most = inner ? SG_BORDER_STAYS : SG_FREE;

  for (uint32_t i = m->first[v]; i < end; i++) {
    uint32_t half = m->leaving[i].half, label = sg_half_label(m, half);
    if (label == last) {
      continue;
    }
    const sg_group *group = group_at(m, half);
    if (!group) {
      return -1;
    }
    if (group->state > most) {
      return 0;
    }
    last = label;
  }
  return 1;
}

/* The groups round the vertices that vanish want new triangles. */
static void
note_losses(sg_merge *m)
{
  for (size_t i = 0; i < m->groups; i++) {
    m->group[i].losing = false;
  }
  for (size_t v = 0; v < m->solid->vertices; v++) {
    if (m->fate[v] != SG_INNER && m->fate[v] != SG_DROPPED) {
      continue;
    }
    uint32_t end = m->fate[v] == SG_INNER ? m->first[v] + 1 : m->first[v + 1];
    for (uint32_t i = m->first[v]; i < end; i++) {
      uint32_t face = m->face_of[m->leaving[i].half / 3];
      m->group[m->group_of[face]].losing = true;
    }
  }
}

static sg_merge_end
ask_groups(sg_merge *m)
{
  for (uint32_t v = 0; v < m->solid->vertices; v++) {
    if (v % BLOCK == 0 && sg_cancelled(m->options->cancel)) {
      return SG_MERGE_STOPPED;
    }
    if (m->fate[v] != SG_KEPT) {
      int let_go = is_let_go(m, v);
      if (let_go < 0) {
        return SG_MERGE_NO_MEMORY;
      }
      m->fate[v] = let_go ? m->fate[v] : SG_KEPT;
    }
  }
  return SG_MERGE_DONE;
}

/* Asks about the vertices of faces that are not one triangle, or in a group. */
static void
ask_about(sg_merge *m)
{
  const sg_solid *solid = m->solid;

  memset(m->fate, SG_KEPT, solid->vertices);
  for (size_t f = 0; f < solid->faces; f++) {
    const sg_solid_face *face = &solid->face[f];
    if (face->n == 1 && m->group_of[f] == SG_NOTHING) {
      continue;
    }
    for (uint32_t t = face->first; t < face->first + face->n; t++) {
      for (int k = 0; k < 3; k++) {
        m->fate[solid->triangle[t][k]] = SG_ASKED;
      }
    }
  }
}

sg_merge_end
sg_merge_vertices(sg_merge *m)
{
  size_t blocks = (m->solid->vertices + BLOCK - 1) / BLOCK;

  ask_about(m);
  if (!sg_pool_run(m->options->pool, blocks, do_block, m, m->options->cancel)) {
    return SG_MERGE_STOPPED;
  }
  sg_merge_end end = ask_groups(m);
  if (end == SG_MERGE_DONE) {
    end = sg_merge_runs(m);
  }
  if (end == SG_MERGE_DONE) {
    note_losses(m);
  }
  return end;
}
