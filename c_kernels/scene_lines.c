/* scene_lines.c -- the lines of a model: one for the directed edges between two
 * vertices, with the polygons that use it (scene_model.h).
 */
#include "bounds.h"
#include "edge_pairs.h"
#include "scene_private.h"

#include <stdlib.h>

/* Of more faces at an edge not all pairs are compared. */
enum { MOST_FACES = 64 };

#define NO_LINE UINT32_MAX

/* Edges in groups with the same ends. What is known of a group stands at the
 * place where it begins. */
typedef struct joined {
  sg_edge_pairs pairs;
  uint8_t *mark;     /* [edges] by group: what the cuts say */
  uint32_t *number;  /* [edges] by group: its line */
  uint32_t *line_of; /* [edges] */
} joined;

enum { CUT = 1, COPY = 2 };

static void
joined_clear(joined *j)
{
  sg_edge_pairs_clear(&j->pairs);
  free(j->mark);
  free(j->number);
  free(j->line_of);
}

static bool
joined_init(joined *j, sg_scene_builder *b)
{
  const sg_dense *d = &b->model->dense;

  *j = (joined){.mark = calloc(d->edges + 1, 1),
                .number = malloc((d->edges + 1) * sizeof *j->number),
                .line_of = malloc((d->edges + 1) * sizeof *j->line_of)};
  return j->mark && j->number && j->line_of &&
         sg_edge_pairs_make(d->edges, d->from, d->to, d->vertices, b->poll,
                            &j->pairs, &b->stopped);
}

/* The first real edge of a group, NO_LINE: there is none. */
static uint32_t
first_real(const sg_dense *d, const sg_edge_pairs *pairs,
           const sg_edge_group *group)
{
  uint32_t first = NO_LINE;

  for (size_t i = group->begin; i < group->end; i++) {
    uint32_t e = sg_edge_group_edge(pairs, i);
    if (e < first && d->real[e]) {
      first = e;
    }
  }
  return first;
}

static bool
find_group(const joined *j, int32_t a, int32_t b, sg_edge_group *group)
{
  return a >= 0 && b >= 0 &&
         sg_edge_group_find(&j->pairs, (uint32_t)a, (uint32_t)b, group);
}

static void
mark_cuts(sg_scene_builder *b, joined *j)
{
  const sg_dense *d = &b->model->dense;
  sg_edge_group own, other;

  for (size_t i = 0; i < b->cuts && !sg_scene_stop(b, i); i++) {
    const sg_scene_cut *c = &b->cut[i];
    if (find_group(j, c->a, c->b, &own)) {
      j->mark[own.begin] |= CUT;
      if (find_group(j, c->a2, c->b2, &other) && other.begin != own.begin &&
          first_real(d, &j->pairs, &other) != NO_LINE) {
        j->mark[own.begin] |= COPY;
      }
    }
  }
}

/* line_of[e] for the first real edge of each line: where its group begins; for
 * all others NO_LINE. Returns how many lines there are. */
static size_t
find_lines(sg_scene_builder *b, joined *j)
{
  const sg_dense *d = &b->model->dense;
  sg_edge_group group = {0};
  size_t lines = 0, groups = 0;

  for (size_t e = 0; e < d->edges; e++) {
    j->line_of[e] = j->number[e] = NO_LINE;
  }
  while (sg_edge_group_next(&j->pairs, &group) && !sg_scene_stop(b, groups++)) {
    uint32_t e = first_real(d, &j->pairs, &group);
    if (e != NO_LINE && group.low != group.high &&
        !(j->mark[group.begin] & COPY)) {
      j->line_of[e] = (uint32_t)group.begin;
      lines++;
    }
  }
  return lines;
}

/* The lines, in the order of their edges; then line_of for all edges. */
static void
number_lines(sg_scene_builder *b, joined *j)
{
  sg_scene_model *m = b->model;
  const sg_dense *d = &m->dense;
  sg_edge_group group = {0};
  size_t s = 0;

  for (size_t e = 0; e < d->edges && !sg_scene_stop(b, e); e++) {
    uint32_t begin = j->line_of[e];
    while (e >= d->edge_begin[s + 1]) {
      s++;
    }
    if (begin != NO_LINE) {
      j->number[begin] = (uint32_t)m->lines;
      m->line[m->lines++] = (sg_scene_line){.s = d->segment[s],
                                            .e = d->edge_id[e],
                                            .a = (uint32_t)d->from[e],
                                            .b = (uint32_t)d->to[e],
                                            .look.cut = j->mark[begin] & CUT};
    }
  }
  while (sg_edge_group_next(&j->pairs, &group)) {
    for (size_t i = group.begin; i < group.end; i++) {
      j->line_of[sg_edge_group_edge(&j->pairs, i)] = j->number[group.begin];
    }
  }
}

/* ---------------------------------------------------------------- uses */

/* The uses by line: counted, then entered (a counting sort). */
static bool
make_uses(sg_scene_builder *b, const joined *j)
{
  sg_scene_model *m = b->model;
  const sg_dense *d = &m->dense;
  uint32_t *begin = calloc(m->lines + 2, sizeof *begin);

  m->use_begin = begin;
  m->use = malloc((d->list_begin[d->polygons] + 1) * sizeof *m->use);
  if (!begin || !m->use) {
    return false;
  }
  for (size_t i = 0; i < d->list_begin[d->polygons]; i++) {
    uint32_t line = j->line_of[d->list[i]];
    if (line != NO_LINE) {
      begin[line + 2]++;
    }
  }
  for (size_t k = 2; k < m->lines + 2; k++) {
    begin[k] += begin[k - 1];
  }
  for (size_t p = 0; p < d->polygons && !sg_scene_stop(b, p); p++) {
    for (uint32_t i = d->list_begin[p]; i < d->list_begin[p + 1]; i++) {
      uint32_t line = j->line_of[d->list[i]];
      if (line != NO_LINE) {
        bool along = d->from[d->list[i]] == (int32_t)m->line[line].a;
        m->use[begin[line + 1]++] = (sg_scene_use){(int32_t)p, along ? 1 : -1};
      }
    }
  }
  return true;
}

/* Degrees between two faces that use a line: 0 when they lie flat side by
 * side, and when one has no area. */
static double
bend_between(const sg_scene_builder *b, const sg_scene_use *x,
             const sg_scene_use *y)
{
  const double *m = b->normal[x->polygon], *n = b->normal[y->polygon];
  double c[3] = {m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2],
                 m[0] * n[1] - m[1] * n[0]};

  if (sg_dot(m, m) == 0.0 || sg_dot(n, n) == 0.0) {
    return 0.0;
  }
  return atan2(sg_length(c), -sg_dot(m, n) * x->along * y->along) *
             (180.0 / acos(-1.0)) +
         0.0;
}

static void
make_bends(sg_scene_builder *b)
{
  sg_scene_model *m = b->model;

  for (size_t k = 0; k < m->lines && !sg_scene_stop(b, k); k++) {
    const sg_scene_use *use = m->use + m->use_begin[k];
    unsigned n = m->use_begin[k + 1] - m->use_begin[k];
    sg_look *look = &m->line[k].look;

    look->faces = n;
    for (unsigned i = 1; i < n; i++) {
      for (unsigned h = 0; h < i && h < MOST_FACES; h++) {
        look->bend = sg_larger(look->bend, bend_between(b, &use[i], &use[h]));
      }
    }
  }
}

bool
sg_scene_make_lines(sg_scene_builder *b)
{
  sg_scene_model *m = b->model;
  joined j;
  bool done = joined_init(&j, b);

  if (done) {
    mark_cuts(b, &j);
    m->line = malloc((find_lines(b, &j) + 1) * sizeof *m->line);
    done = m->line != NULL;
  }
  if (done) {
    number_lines(b, &j);
    done = make_uses(b, &j);
  }
  if (done) {
    make_bends(b);
  }
  joined_clear(&j);
  return done;
}
