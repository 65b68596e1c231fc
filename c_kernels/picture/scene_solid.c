/* scene_solid.c -- which segments are solid, so that nobody can see the back of
 * a face (scene_model.h).
 *
 * Seen from the back of a face towards the eye one is inside. One stays inside
 * until one comes out through the front of another face, if no part of the
 * surface is inside out: every edge has one face on either side, so the surface
 * is made of closed shells; each shell goes round a volume, not the other way;
 * and none goes through itself (then it would have been cut there). Shells may
 * go through one another. A cavity is inside out; its solid is not taken for
 * one here, which only costs time.
 */
#include "rows/disjoint.h"
#include "scene_private.h"

#include <stdlib.h>

#define NO_POLYGON UINT32_MAX

typedef struct shells {
  const sg_dense *dense;
  bool *solid;     /* [segments] */
  uint32_t *user;  /* [edges] the polygon that has it, NO_POLYGON: none */
  bool *twice;     /* [edges] several have it */
  uint32_t *shell; /* [polygons] another polygon of the shell: a tree */
  double *volume;  /* [polygons] by root: six times what the shell goes round */
  const double **apex; /* [polygons] by root: one of its corners */
} shells;

static bool
shells_init(shells *s, sg_scene_model *m)
{
  const sg_dense *d = &m->dense;

  *s = (shells){.dense = d,
                .solid = m->solid,
                .user = malloc((d->edges + 1) * sizeof *s->user),
                .twice = calloc(d->edges + 1, sizeof *s->twice),
                .shell = malloc((d->polygons + 1) * sizeof *s->shell),
                .volume = calloc(d->polygons + 1, sizeof *s->volume),
                .apex = calloc(d->polygons + 1, sizeof *s->apex)};
  return s->user && s->twice && s->shell && s->volume && s->apex;
}

static void
shells_clear(shells *s)
{
  free(s->user);
  free(s->twice);
  free(s->shell);
  free(s->volume);
  free(s->apex);
}

static void
find_users(shells *s)
{
  const sg_dense *d = s->dense;

  for (size_t e = 0; e < d->edges; e++) {
    s->user[e] = NO_POLYGON;
  }
  for (size_t p = 0; p < d->polygons; p++) {
    s->shell[p] = (uint32_t)p;
    for (uint32_t i = d->list_begin[p]; i < d->list_begin[p + 1]; i++) {
      int32_t e = d->list[i];
      s->twice[e] = s->user[e] != NO_POLYGON;
      s->user[e] = (uint32_t)p;
    }
  }
}

/* The only polygon that has one of the edges from .. to - 1 of the pairs;
 * NO_POLYGON: none has; *several: more than one has. */
static uint32_t
only_user(const shells *s, const sg_edge_pairs *pairs, size_t from, size_t to,
          bool *several)
{
  uint32_t only = NO_POLYGON;

  for (size_t i = from; i < to; i++) {
    uint32_t e = sg_edge_group_edge(pairs, i);
    if (s->user[e] != NO_POLYGON) {
      *several |= s->twice[e] || only != NO_POLYGON;
      only = s->user[e];
    }
  }
  return only;
}

/* Joins the faces on either side of each edge; a segment with an edge that has
 * not just one on either side is none. */
static void
join_faces(sg_scene_builder *b, shells *s, const sg_edge_pairs *pairs)
{
  const sg_dense *d = s->dense;
  sg_edge_group group = {0};
  size_t segment = 0, groups = 0;

  while (sg_edge_group_next(pairs, &group) && !sg_scene_stop(b, groups++)) {
    bool several = false;
    size_t middle = group.begin + group.forward;
    uint32_t p = only_user(s, pairs, group.begin, middle, &several);
    uint32_t q = only_user(s, pairs, middle, group.end, &several);

    while (group.low >= d->vertex_begin[segment + 1]) {
      segment++;
    }
    if (several || (p == NO_POLYGON) != (q == NO_POLYGON)) {
      s->solid[segment] = false;
    } else if (p != NO_POLYGON) {
      sg_disjoint_join(s->shell, p, q);
    }
  }
}

/* A segment that goes through itself, or touches itself along a line, has
 * penetration lines of its own. */
static void
find_own_cuts(sg_scene_builder *b, shells *s)
{
  const sg_dense *d = s->dense;

  for (size_t i = 0; i < b->cuts && !sg_scene_stop(b, i); i++) {
    const sg_scene_cut *c = &b->cut[i];
    if (c->a >= 0 && c->a2 >= 0 && c->a != c->b &&
        (c->a != c->a2 || c->b != c->b2)) {
      size_t own = sg_dense_segment_of(d, d->vertex_begin, (uint32_t)c->a);
      if (own == sg_dense_segment_of(d, d->vertex_begin, (uint32_t)c->a2)) {
        s->solid[own] = false;
      }
    }
  }
}

static double
volume_below(const double apex[3], const double a[3], const double c[3],
             const double d[3])
{
  double n[3], u[3] = {a[0] - apex[0], a[1] - apex[1], a[2] - apex[2]};

  sg_cross_at(a, c, d, n);
  return sg_dot(u, n);
}

static void
find_volumes(sg_scene_builder *b, shells *s)
{
  const sg_dense *d = s->dense;
  size_t segment = 0;

  for (size_t i = 0; i < d->triangles && !sg_scene_stop(b, i); i++) {
    const int32_t *v = d->corner[i];
    uint32_t root = sg_disjoint_root(s->shell, (uint32_t)d->polygon_of[i]);
    if (!s->apex[root]) {
      s->apex[root] = d->at[v[0]];
    }
    s->volume[root] +=
        volume_below(s->apex[root], d->at[v[0]], d->at[v[1]], d->at[v[2]]);
  }
  for (size_t p = 0; p < d->polygons; p++) {
    while (p >= d->polygon_begin[segment + 1]) {
      segment++;
    }
    if (s->apex[p] && s->volume[p] <= 0.0) {
      s->solid[segment] = false;
    }
  }
}

bool
sg_scene_find_solids(sg_scene_builder *b, const sg_edge_pairs *pairs)
{
  shells s;
  bool done = shells_init(&s, b->model);

  if (done) {
    find_users(&s);
    join_faces(b, &s, pairs);
    find_own_cuts(b, &s);
    find_volumes(b, &s);
  }
  shells_clear(&s);
  return done;
}
