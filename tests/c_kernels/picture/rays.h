/* rays.h -- whether rays from the eye, cast in the model in long doubles, agree
 * with a picture.
 */
#ifndef SG_TEST_RAYS_H
#define SG_TEST_RAYS_H

#include "picture.h"

/* What a ray from the eye to a point of a line says. */
typedef enum verdict { CLEAR, BLOCKED, UNSURE } verdict;

typedef struct eye {
  long double at[3], forward[3];
  double rho;
  bool central;
} eye;

static inline eye
eye_of(double theta, double phi, double rho, bool is_central)
{
  long double d = acosl(-1.0L) / 180;
  eye e = {.rho = rho, .central = is_central};
  long double back[3] = {sinl(phi * d) * cosl(theta * d),
                         sinl(phi * d) * sinl(theta * d), cosl(phi * d)};

  for (int k = 0; k < 3; k++) {
    e.at[k] = back[k] * rho;
    e.forward[k] = -back[k];
  }
  return e;
}

static inline long double
det(const long double a[3], const long double b[3], const long double c[3])
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) -
         a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Does the ray from point p towards the eye meet the triangle? */
static inline verdict
ray_meets(const eye *e, const long double p[3], const model_corner *a,
          const model_corner *b, const model_corner *c)
{
  const long double close = 1e-6L;
  long double u[3], w[3], r[3], q[3], d, x, y, t;

  for (int k = 0; k < 3; k++) {
    u[k] = b->model[k] - a->model[k];
    w[k] = c->model[k] - a->model[k];
    r[k] = e->central ? p[k] - e->at[k] : e->forward[k];
    q[k] = p[k] - a->model[k];
  }
  d = det(u, w, r);
  if (fabsl(d) < 1e-9L) {
    return UNSURE; /* edge-on: only if it is near, which nobody asks here */
  }
  x = det(q, w, r) / d;
  y = det(u, q, r) / d;
  t = det(u, w, q) / d; /* > 0: between the eye and p */
  if (x < -close || y < -close || x + y > 1 + close || t < -close) {
    return CLEAR;
  }
  return x > close && y > close && x + y < 1 - close && t > close ? BLOCKED
                                                                  : UNSURE;
}

static inline const model_corner *
vertex_of(const model *m, int32_t s, int32_t v)
{
  for (size_t i = 0; i < m->vertices; i++) {
    if (m->vertex[i].s == s && m->vertex[i].v == v) {
      return &m->vertex[i];
    }
  }
  return NULL;
}

/* True if the line runs between two corners of the triangle. */
static inline bool
is_side(const model *m, const model_triangle *t, const sg_scene_line *line)
{
  int ends = 0;

  for (int k = 0; k < 3; k++) {
    ends += m->vertex[line->a].v == t->v[k];
    ends += m->vertex[line->b].v == t->v[k];
  }
  return t->s == line->s && ends == 2;
}

static inline verdict
cast(const model *m, const eye *e, const sg_scene_line *line,
     const long double p[3])
{
  verdict all = CLEAR;

  for (size_t i = 0; i < m->triangles && all != BLOCKED; i++) {
    const model_triangle *t = &m->triangle[i];
    verdict one = CLEAR;
    if (!is_side(m, t, line)) {
      one = ray_meets(e, p, vertex_of(m, t->s, t->v[0]),
                      vertex_of(m, t->s, t->v[1]), vertex_of(m, t->s, t->v[2]));
    }
    all = one == CLEAR ? all : one;
  }
  return all;
}

/* The model point of a line that is at t in the picture. */
static inline void
point_at(const model *m, const eye *e, const sg_scene_line *line, double t,
         long double out[3])
{
  const model_corner *a = &m->vertex[line->a], *b = &m->vertex[line->b];
  long double za = 0, zb = 0, u = t;

  for (int k = 0; k < 3 && e->central; k++) {
    za += (a->model[k] - e->at[k]) * e->forward[k];
    zb += (b->model[k] - e->at[k]) * e->forward[k];
  }
  if (e->central) {
    u = t * za / ((1 - t) * zb + t * za);
  }
  for (int k = 0; k < 3; k++) {
    out[k] = a->model[k] + u * (b->model[k] - a->model[k]);
  }
}

/* How many samples of the parts the rays call wrong; *sure: how many they
 * could judge. */
static inline size_t
wrong_samples(const model *m, const picture *p, const eye *e, size_t *sure)
{
  size_t wrong = 0;

  for (size_t i = 0; i < p->parts; i++) {
    const sg_drawn_part *part = &p->part[i];
    for (int k = 0; k < 3; k++) {
      double at = part->from + (part->to - part->from) * (0.12 + 0.38 * k);
      long double point[3];
      verdict v;
      point_at(m, e, &p->scene->line[part->line], at, point);
      v = cast(m, e, &p->scene->line[part->line], point);
      *sure += v != UNSURE;
      wrong += v == (part->hidden ? CLEAR : BLOCKED);
    }
  }
  return wrong;
}

#endif
