/* scene_lines.c -- the lines of a model: one for the directed edges between two
 * vertices, with the polygons that use it (scene_model.h).
 */
#include "engine/list.h"
#include "number/bounds.h"
#include "rows/disjoint.h"
#include "rows/edge_pairs.h"
#include "scene_private.h"

#include <stdlib.h>

/* Of more faces at an edge not all pairs are compared. */
enum { MOST_FACES = 64 };

#define NO_LINE UINT32_MAX

/* Edges in groups with the same ends. What is known of a group stands at the
 * place where it begins. */
typedef struct joined {
  sg_edge_pairs pairs;
  uint32_t *set;     /* [edges] by group: one nearer to the first copy of it */
  bool *cut;         /* [edges] by group: it is a penetration line */
  uint32_t *first;   /* [edges] by first copy: the first real edge of all */
  uint32_t *line_of; /* [edges] */
  uint32_t *copy_of; /* [edges] for copies that are left out; null: no cut, so
                        there are none */
} joined;

static void
joined_clear(joined *j)
{
  sg_edge_pairs_clear(&j->pairs);
  free(j->set);
  free(j->cut);
  free(j->first);
  free(j->line_of);
  free(j->copy_of);
}

static bool
joined_init(joined *j, sg_scene_builder *b)
{
  const sg_dense *d = &b->model->dense;
  *j = (joined){
      .set = sg_list_room(d->edges, sizeof(uint32_t)),
      .cut = calloc(d->edges + 1, sizeof(bool)),
      .first = sg_list_room(d->edges, sizeof(uint32_t)),
      .line_of = sg_list_room(d->edges, sizeof(uint32_t)),
      .copy_of = b->cuts > 0 ? sg_list_room(d->edges, sizeof(uint32_t)) : NULL};
  for (size_t i = 0; j->set && i < d->edges; i++) {
    j->set[i] = (uint32_t)i;
  }
  return j->set && j->cut && j->first && j->line_of &&
         (j->copy_of || b->cuts == 0) &&
         sg_edge_pairs_make(d->edges, d->from, d->to, d->vertices, b->cancel,
                            &j->pairs, &b->stopped);
}

/* -------------------------------------------------------------- copies */

static bool
find_group(const joined *j, int32_t a, int32_t b, sg_edge_group *group)
{
  return a >= 0 && b >= 0 &&
         sg_edge_group_find(&j->pairs, (uint32_t)a, (uint32_t)b, group);
}

/* What the cuts say: which edges are penetration lines, which of them and which
 * vertices are the same. False: no memory. */
static bool
enter_cuts(sg_scene_builder *b, joined *j)
{
  sg_scene_model *m = b->model;
  sg_edge_group own, other;

  m->same = malloc((m->dense.vertices + 1) * sizeof *m->same);
  for (size_t i = 0; m->same && i < m->dense.vertices; i++) {
    m->same[i] = (uint32_t)i;
  }
  for (size_t i = 0; m->same && i < b->cuts && !sg_scene_stop(b, i); i++) {
    const sg_scene_cut *c = &b->cut[i];
    bool found = find_group(j, c->a, c->b, &own);
    if (found) {
      j->cut[own.begin] = true;
    }
    if (c->a >= 0 && c->b >= 0 && c->a2 >= 0 && c->b2 >= 0) {
      sg_disjoint_join(m->same, (uint32_t)c->a, (uint32_t)c->a2);
      sg_disjoint_join(m->same, (uint32_t)c->b, (uint32_t)c->b2);
      if (found && find_group(j, c->a2, c->b2, &other)) {
        sg_disjoint_join(j->set, (uint32_t)own.begin, (uint32_t)other.begin);
      }
    }
  }
  for (size_t i = 0; m->same && i < m->dense.vertices; i++) {
    m->same[i] = sg_disjoint_root(m->same, (uint32_t)i);
  }
  return m->same != NULL;
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

/* The first real edge of each line: of all its copies. Returns how many lines
 * there are. */
static size_t
find_lines(sg_scene_builder *b, joined *j)
{
  const sg_dense *d = &b->model->dense;
  sg_edge_group group = {0};
  size_t lines = 0, groups = 0;

  for (size_t e = 0; e < d->edges; e++) {
    j->first[e] = NO_LINE;
  }
  while (sg_edge_group_next(&j->pairs, &group) && !sg_scene_stop(b, groups++)) {
    uint32_t e = first_real(d, &j->pairs, &group);
    uint32_t set = sg_disjoint_root(j->set, (uint32_t)group.begin);
    if (e != NO_LINE && group.low != group.high) {
      lines += j->first[set] == NO_LINE;
      j->first[set] = e < j->first[set] ? e : j->first[set];
    }
    j->cut[set] |= j->cut[group.begin];
  }
  return lines;
}

/* line_of[e] becomes the set of the line whose first real edge e is, NO_LINE
 * for all other edges. */
static void
mark_first(const sg_dense *d, joined *j)
{
  for (size_t e = 0; e < d->edges; e++) {
    j->line_of[e] = NO_LINE;
  }
  for (size_t set = 0; set < d->edges; set++) {
    if (j->first[set] != NO_LINE) {
      j->line_of[j->first[set]] = (uint32_t)set;
    }
  }
}

/* The lines, in the order of their edges; first[] becomes their numbers. */
static void
enter_lines(sg_scene_builder *b, joined *j)
{
  sg_scene_model *m = b->model;
  const sg_dense *d = &m->dense;
  size_t s = 0;

  mark_first(d, j);
  for (size_t e = 0; e < d->edges && !sg_scene_stop(b, e); e++) {
    uint32_t set = j->line_of[e];
    while (e >= d->edge_begin[s + 1]) {
      s++;
    }
    if (set != NO_LINE) {
      j->first[set] = (uint32_t)m->lines;
      m->line[m->lines] = (sg_model_line){.s = d->segment[s],
                                          .e = d->edge_id[e],
                                          .a = (uint32_t)d->from[e],
                                          .b = (uint32_t)d->to[e],
                                          .cut = j->cut[set]};
      m->lines++;
    }
  }
}

/* line_of for the edges of a line, copy_of for those of its copies. */
static void
number_edges(const sg_scene_builder *b, joined *j)
{
  const sg_scene_model *m = b->model;
  sg_edge_group group = {0};

  while (sg_edge_group_next(&j->pairs, &group)) {
    uint32_t line = j->first[sg_disjoint_root(j->set, (uint32_t)group.begin)];
    bool own = line != NO_LINE &&
               (m->line[line].a == group.low || m->line[line].b == group.low);
    own =
        own && (m->line[line].a == group.high || m->line[line].b == group.high);
    for (size_t i = group.begin; i < group.end; i++) {
      uint32_t e = sg_edge_group_edge(&j->pairs, i);
      j->line_of[e] = own ? line : NO_LINE;
      if (j->copy_of) {
        j->copy_of[e] = own ? NO_LINE : line;
      }
    }
  }
}

/* ---------------------------------------------------------------- uses */

/* The uses of lines by polygons: counted, then entered (a counting sort).
 * line_of: of each edge. */
static bool
make_uses(sg_scene_builder *b, const uint32_t *line_of, uint32_t **use_begin,
          sg_scene_use **use)
{
  sg_scene_model *m = b->model;
  const sg_dense *d = &m->dense;
  uint32_t *begin = calloc(m->lines + 2, sizeof *begin);

  *use_begin = begin;
  *use = sg_list_room(d->list_begin[d->polygons], sizeof **use);
  if (!begin || !*use) {
    return false;
  }
  for (size_t i = 0; i < d->list_begin[d->polygons]; i++) {
    uint32_t line = line_of[d->list[i]];
    if (line != NO_LINE) {
      begin[line + 2]++;
    }
  }
  for (size_t k = 2; k < m->lines + 2; k++) {
    begin[k] += begin[k - 1];
  }
  for (size_t p = 0; p < d->polygons && !sg_scene_stop(b, p); p++) {
    for (uint32_t i = d->list_begin[p]; i < d->list_begin[p + 1]; i++) {
      uint32_t line = line_of[d->list[i]];
      if (line != NO_LINE) {
        bool along = d->from[d->list[i]] == (int32_t)m->line[line].a;
        (*use)[begin[line + 1]++] = (sg_scene_use){(int32_t)p, along ? 1 : -1};
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

/* The same of the surfaces that the faces stand for; facets: what these bend.
 */
static sg_bend
surface_bend(const sg_scene_builder *b, const sg_model_line *line,
             const sg_scene_use *x, const sg_scene_use *y, double facets)
{
  const sg_scene_model *m = b->model;
  const double *n = b->normal[y->polygon];
  double way = -x->along * y->along,
         turned[3] = {n[0] * way, n[1] * way, n[2] * way};
  const sg_facets_meeting meeting = {
      .dense = &m->dense,
      .polygon = {x->polygon, y->polygon},
      .normal = {b->normal[x->polygon], turned},
      .ends = {m->dense.at[line->a], m->dense.at[line->b]},
      .bend = facets};

  return sg_known_surfaces_bend(&m->surfaces, &meeting);
}

static void
make_bend(sg_scene_builder *b, size_t k)
{
  sg_scene_model *m = b->model;
  const sg_scene_use *use = m->use + m->use_begin[k];
  unsigned n = m->use_begin[k + 1] - m->use_begin[k];
  sg_model_line *line = &m->line[k];

  line->faces = n;
  for (unsigned i = 1; i < n; i++) {
    for (unsigned h = 0; h < i && h < MOST_FACES; h++) {
      double bend = bend_between(b, &use[i], &use[h]);
      if (m->facet_bend) {
        m->facet_bend[k] = sg_larger(m->facet_bend[k], bend);
        sg_bend known = surface_bend(b, line, &use[i], &use[h], bend);
        bend = known.degrees;
        line->edge |= known.edge;
        b->tangent[k] = known.tangent && n == 2;
      }
      line->bend = sg_larger(line->bend, bend);
    }
  }
}

/* False: no memory, or stopped. */
static bool
make_bends(sg_scene_builder *b)
{
  sg_scene_model *m = b->model;

  b->tangent = calloc(m->lines + 1, sizeof *b->tangent);
  if (!b->tangent) {
    return false;
  }
  if (m->surfaces.of) {
    m->facet_bend = calloc(m->lines + 1, sizeof *m->facet_bend);
    if (!m->facet_bend) {
      return false;
    }
  }
  for (size_t k = 0; k < m->lines && !sg_scene_stop(b, k); k++) {
    make_bend(b, k);
  }
  return !b->stopped;
}

/* ---------------------------------------------------------------- cuts */

/* What meets along a piece of a penetration line. */
typedef enum parties {
  UNKNOWN,  /* a segment and one that is not in the model */
  OPERANDS, /* those of one Boolean: the line is an edge of its result */
  COPIES    /* two segments, or two places of one */
} parties;

static parties
parties_of(const sg_scene_cut *c)
{
  if (c->a2 < 0 || c->b2 < 0) {
    return UNKNOWN;
  }
  return c->a == c->a2 && c->b == c->b2 ? OPERANDS : COPIES;
}

/* The line of a piece, NO_LINE: it has none. */
static uint32_t
line_of_cut(const joined *j, const sg_scene_cut *c)
{
  sg_edge_group group;

  return find_group(j, c->a, c->b, &group)
             ? j->first[sg_disjoint_root(j->set, (uint32_t)group.begin)]
             : NO_LINE;
}

/* Where operands are tangent their surfaces go on in each other: there is no
 * line. False: no memory. */
static bool
leave_out_tangent(sg_scene_builder *b, const joined *j)
{
  sg_scene_model *m = b->model;
  uint8_t *met = calloc(m->lines + 1, 1);

  for (size_t i = 0; met && i < b->cuts && !sg_scene_stop(b, i); i++) {
    uint32_t line = line_of_cut(j, &b->cut[i]);
    uint8_t here = (uint8_t)parties_of(&b->cut[i]);
    if (line != NO_LINE && here > met[line]) {
      met[line] = here;
    }
  }
  for (size_t k = 0; met && k < m->lines; k++) {
    m->line[k].cut &= met[k] != OPERANDS || !b->tangent[k];
  }
  free(met);
  return met != NULL;
}

/* False: no memory. */
static bool
keep_cuts(sg_scene_builder *b, const joined *j)
{
  sg_scene_model *m = b->model;

  m->cut = malloc((b->cuts + 1) * sizeof *m->cut);
  for (size_t i = 0; m->cut && i < b->cuts && !sg_scene_stop(b, i); i++) {
    const sg_scene_cut *c = &b->cut[i];
    uint32_t line = line_of_cut(j, c);
    if (c->a >= 0 && c->b >= 0 && c->a != c->b &&
        (line == NO_LINE || m->line[line].cut)) {
      m->cut[m->cuts][0] = (uint32_t)c->a;
      m->cut[m->cuts++][1] = (uint32_t)c->b;
    }
  }
  return m->cut != NULL;
}

bool
sg_scene_make_lines(sg_scene_builder *b)
{
  sg_scene_model *m = b->model;
  joined j;
  bool done = joined_init(&j, b);

  if (done && (done = enter_cuts(b, &j))) {
    m->line = sg_list_room(find_lines(b, &j), sizeof *m->line);
    done = m->line != NULL;
  }
  if (done) {
    enter_lines(b, &j);
    done = !b->stopped;
  }
  if (done) {
    number_edges(b, &j);
    done = make_uses(b, j.line_of, &m->use_begin, &m->use) &&
           (!j.copy_of || make_uses(b, j.copy_of, &m->copy_begin, &m->copy));
  }
  if (done) {
    done = sg_scene_find_bent(b) && make_bends(b) && leave_out_tangent(b, &j) &&
           keep_cuts(b, &j) && sg_scene_find_solids(b, &j.pairs);
  }
  joined_clear(&j);
  return done;
}
