/* crease.c -- see crease.h */
#include "crease.h"

#include "number/bounds.h"
#include "number/vector.h"
#include "rows/disjoint.h"
#include "smooth.h"

#include <math.h>
#include <stdlib.h>

/* A crease goes on while it bends by this part of the angle, */
#define GOES_ON (1.0 / 3.0)
/* and by so much more than any other edge there that is no crease, */
#define CLEARLY 1.5
/* and turns by no more than 60 degrees. */
#define STRAIGHT 0.5

/* So many edges that bend less may lead to another line. */
enum { CLOSES = 4 };

/* A part of the model's longest side. */
#define SPECK (1.0 / 100.0)

#define NO_LINE UINT32_MAX

typedef struct finder {
  const sg_scene_model *model;
  const bool *faceted;
  double crease;
  uint32_t *begin; /* [vertices + 1]: the lines at each vertex */
  uint32_t *at;
  uint32_t *drawn; /* [vertices]: how many lines that end there are drawn */
  uint8_t *as;     /* [lines] */
} finder;

static double
bend_of(const finder *f, uint32_t k)
{
  return sg_scene_bend(f->model, f->faceted, k);
}

static bool
is_sharp(const finder *f, uint32_t k)
{
  return bend_of(f, k) > f->crease + SG_SMOOTH_OVER;
}

/* Of what the line is, not of how it bends: a border, an edge by the terms, a
 * penetration line. */
static bool
is_line(const finder *f, uint32_t k)
{
  const sg_model_line *line = &f->model->line[k];

  return line->faces < 2 || line->edge || line->cut;
}

static uint32_t
end_of(const finder *f, uint32_t k, bool last)
{
  const sg_model_line *line = &f->model->line[k];

  return f->model->same[last ? line->b : line->a];
}

static uint32_t
other_end(const finder *f, uint32_t k, uint32_t v)
{
  uint32_t a = end_of(f, k, false);

  return a == v ? end_of(f, k, true) : a;
}

/* The lines at each vertex, in their order. */
static void
enter_lines(finder *f)
{
  const sg_scene_model *m = f->model;
  size_t vertices = m->dense.vertices;

  for (uint32_t k = 0; k < m->lines; k++) {
    f->begin[end_of(f, k, false) + 2]++;
    f->begin[end_of(f, k, true) + 2]++;
  }
  for (size_t v = 2; v < vertices + 2; v++) {
    f->begin[v] += f->begin[v - 1];
  }
  for (uint32_t k = 0; k < m->lines; k++) {
    f->at[f->begin[end_of(f, k, false) + 1]++] = k;
    f->at[f->begin[end_of(f, k, true) + 1]++] = k;
  }
}

static void
count_drawn(finder *f, uint32_t k)
{
  f->drawn[end_of(f, k, false)]++;
  f->drawn[end_of(f, k, true)]++;
}

/* --------------------------------------------------------------- going on */

/* From v along line k. */
static void
way_along(const finder *f, uint32_t v, uint32_t k, double out[3])
{
  const double *from = f->model->dense.at[v];
  const double *to = f->model->dense.at[other_end(f, k, v)];

  for (int i = 0; i < 3; i++) {
    out[i] = to[i] - from[i];
  }
}

/* Whether a crease may go on along k: it is not drawn, and has two faces. */
static bool
may_go_on(const finder *f, uint32_t k)
{
  const sg_scene_model *m = f->model;
  const sg_scene_use *use = m->use + m->use_begin[k];

  return !is_line(f, k) && f->as[k] == SG_CREASE_BENT && !is_sharp(f, k) &&
         m->use_begin[k + 1] - m->use_begin[k] == 2 &&
         use[0].along != use[1].along;
}

/* A crease comes to v along line `from`. The line that bends most and goes on
 * straightest, of those that bend by more than `least`; *rest: what the other
 * ones bend at most. */
static uint32_t
best_next(const finder *f, uint32_t v, uint32_t from, double least,
          double *rest)
{
  uint32_t best = NO_LINE;
  double back[3], most = 0.0, bend = 0.0;

  way_along(f, v, from, back);
  *rest = 0.0;
  for (uint32_t i = f->begin[v]; i < f->begin[v + 1]; i++) {
    uint32_t k = f->at[i];
    double way[3], straight, score;
    if (!may_go_on(f, k)) {
      continue;
    }
    way_along(f, v, k, way);
    straight = -sg_dot(back, way) / (sg_length(back) * sg_length(way));
    score = straight > STRAIGHT ? straight * bend_of(f, k) : 0.0;
    if (score > most && bend_of(f, k) > least) {
      *rest = sg_larger(*rest, bend);
      most = score;
      bend = bend_of(f, k);
      best = k;
    } else {
      *rest = sg_larger(*rest, bend_of(f, k));
    }
  }
  return best;
}

static void
draw_on(finder *f, uint32_t k)
{
  f->as[k] = SG_CREASE_ON;
  count_drawn(f, k);
}

/* From v, where a crease that came along k fades: over edges that bend less, if
 * they lead to another line. */
static void
close_gap(finder *f, uint32_t v, uint32_t k)
{
  uint32_t path[CLOSES];
  double rest;

  for (size_t n = 0; n < CLOSES; n++) {
    k = best_next(f, v, k, SG_FACET_BEND, &rest);
    if (k == NO_LINE) {
      return;
    }
    path[n] = k;
    v = other_end(f, k, v);
    if (f->drawn[v] > 0) {
      for (size_t i = 0; i <= n; i++) {
        draw_on(f, path[i]);
      }
      return;
    }
  }
}

/* A crease that ends at v, where it came along k, goes on. */
static void
go_on(finder *f, uint32_t v, uint32_t k)
{
  double rest;

  for (;;) {
    uint32_t next = best_next(f, v, k, GOES_ON * f->crease, &rest);
    if (next == NO_LINE || bend_of(f, next) < CLEARLY * rest) {
      close_gap(f, v, k);
      return;
    }
    k = next;
    v = other_end(f, k, v);
    draw_on(f, k);
    if (f->drawn[v] > 1) {
      return;
    }
  }
}

/* The sharp edge that alone ends at v, if it does. */
static uint32_t
loose_crease(const finder *f, uint32_t v)
{
  if (f->drawn[v] != 1) {
    return NO_LINE;
  }
  for (uint32_t i = f->begin[v]; i < f->begin[v + 1]; i++) {
    uint32_t k = f->at[i];
    if (!is_line(f, k) && is_sharp(f, k)) {
      return k;
    }
  }
  return NO_LINE;
}

static bool
continue_all(finder *f, const sg_cancel *cancel)
{
  for (uint32_t v = 0; v < f->model->dense.vertices; v++) {
    uint32_t k = loose_crease(f, v);
    if (k != NO_LINE) {
      go_on(f, v, k);
    }
    if (v % 4096 == 0 && sg_cancelled(cancel)) {
      return false;
    }
  }
  return true;
}

/* ----------------------------------------------------------------- specks */

static bool
is_crease(const finder *f, uint32_t k)
{
  return !is_line(f, k) && (f->as[k] == SG_CREASE_ON || is_sharp(f, k));
}

static double
length_of(const finder *f, uint32_t k)
{
  double way[3];

  way_along(f, end_of(f, k, false), k, way);
  return sg_length(way);
}

/* What is known of the creases that hang together, at the root of their
 * vertices. */
typedef struct part {
  double length;
  bool loose; /* one ends where no other line is */
  bool bound; /* another line touches them */
} part;

/* The parts; root: of the vertices. */
static void
measure_parts(const finder *f, uint32_t *root, part *parts)
{
  const sg_scene_model *m = f->model;

  for (uint32_t k = 0; k < m->lines; k++) {
    if (is_crease(f, k)) {
      sg_disjoint_join(root, end_of(f, k, false), end_of(f, k, true));
    }
  }
  for (uint32_t k = 0; k < m->lines; k++) {
    uint32_t end[2] = {end_of(f, k, false), end_of(f, k, true)};
    part *p[2] = {&parts[sg_disjoint_root(root, end[0])],
                  &parts[sg_disjoint_root(root, end[1])]};
    if (is_line(f, k)) {
      p[0]->bound = p[1]->bound = true;
    } else if (is_crease(f, k)) {
      p[0]->length += length_of(f, k);
      p[0]->loose |= f->drawn[end[0]] == 1 || f->drawn[end[1]] == 1;
    }
  }
}

/* False: no memory. */
static bool
find_specks(finder *f)
{
  const sg_scene_model *m = f->model;
  uint32_t *root = malloc((m->dense.vertices + 1) * sizeof *root);
  part *parts = calloc(m->dense.vertices + 1, sizeof *parts);
  double most = SPECK * 2.0 * sg_scene_size(m);

  if (root && parts) {
    for (size_t v = 0; v < m->dense.vertices; v++) {
      root[v] = (uint32_t)v;
    }
    measure_parts(f, root, parts);
    for (uint32_t k = 0; k < m->lines; k++) {
      const part *p = &parts[sg_disjoint_root(root, end_of(f, k, false))];
      if (is_crease(f, k) && p->loose && !p->bound && p->length < most) {
        f->as[k] = SG_CREASE_SPECK;
      }
    }
  }
  free(root);
  free(parts);
  return root && parts;
}

/* --------------------------------------------------------------- together */

static bool
make_room(finder *f)
{
  const sg_scene_model *m = f->model;

  f->begin = calloc(m->dense.vertices + 2, sizeof *f->begin);
  f->at = malloc((2 * m->lines + 1) * sizeof *f->at);
  f->drawn = calloc(m->dense.vertices + 1, sizeof *f->drawn);
  f->as = calloc(m->lines + 1, sizeof *f->as);
  return f->begin && f->at && f->drawn && f->as;
}

bool
sg_creases_find(const sg_scene_model *model, const bool *faceted, double crease,
                const sg_cancel *cancel, uint8_t **as, bool *memory)
{
  finder f = {.model = model, .faceted = faceted, .crease = crease};
  bool done = true;

  *as = NULL;
  *memory = true;
  if (crease < SG_FACET_BEND) {
    return true;
  }
  if ((*memory = make_room(&f))) {
    enter_lines(&f);
    for (uint32_t k = 0; k < model->lines; k++) {
      if (is_line(&f, k) || is_sharp(&f, k)) {
        count_drawn(&f, k);
      }
    }
    done = continue_all(&f, cancel) && (*memory = find_specks(&f));
  }
  free(f.begin);
  free(f.at);
  free(f.drawn);
  if (!*memory || !done) {
    free(f.as);
    return false;
  }
  *as = f.as;
  return true;
}
