/* face_merge_near.c -- what lies across from a face beside which a vertex
 * moves: see face_merge_private.h.
 *
 * Layer: kernel. Inexact. From a point of each face at the vertex, near it, two
 * rays run along the normal, as far as the move still counts; another face of
 * the operand that looks the other way is the other side of a wall, or of a
 * slot.
 */
#include "face_merge_private.h"

#include "engine/list.h"
#include "engine/search.h"
#include "join/bvh_join.h"
#include "number/vector.h"

#include <stdlib.h>

enum {
  OFTEN = 1 << 12, /* triangles between questions */
  BESIDE = 16      /* a ray begins so many moves from the vertex, or */
};

#define INSIDE 0.125  /* of the way to the middle of the opposite side */
#define SAME   0.9999 /* the cosine of 0.8 degrees */

typedef struct ray {
  uint32_t moved, face;
  double from[3], way[3]; /* to its end */
  double normal[3];       /* of the face, 1 long */
  double length, move;    /* of the vertex along it */
} ray;

typedef struct casting {
  const sg_merge *m;
  const sg_merge_faces *of;
  sg_moved *moved;
  SG_LIST_OF(ray) rays;
  SG_LIST_OF(uint32_t) near; /* triangles */
} casting;

/* The boxes of rays and of triangles that are near. */
typedef struct joining {
  const casting *x;
  const sg_bvh *rays, *triangles;
} joining;

/* ---- the rays ---- */

/* The way that a face looks by the plane of its polygon, or by a triangle. */
static bool
normal_of(const casting *x, uint32_t triangle, double out[3])
{
  const sg_merge_options *options = x->m->options;
  const sg_solid_face *face = &x->of->face[x->m->face_of[triangle]];

  if (!options->normal ||
      !options->normal(options->data, face->s, face->p, out)) {
    return sg_merge_normal(x->m, x->of, triangle, out);
  }
  for (int k = 0; k < 3 && face->reversed; k++) {
    out[k] = -out[k];
  }
  return true;
}

/* Near a corner of a triangle, inside it. */
static void
find_start(const casting *x, uint32_t half, double move, double out[3])
{
  const uint32_t *corner = x->of->triangle[half / 3];
  const double *v = sg_merge_at(x->m, corner[half % 3]);
  const double *a = sg_merge_at(x->m, corner[(half + 1) % 3]);
  const double *b = sg_merge_at(x->m, corner[(half + 2) % 3]);
  double way[3];

  for (int k = 0; k < 3; k++) {
    way[k] = (a[k] + b[k]) / 2 - v[k];
  }
  double part = fmin(INSIDE, BESIDE * move / sg_length(way));

  for (int k = 0; k < 3; k++) {
    out[k] = v[k] + part * way[k];
  }
}

/* Whether one of the last rays, from `first` on, runs almost the same way. */
static bool
is_there(const casting *x, size_t first, const ray *one)
{
  for (size_t i = first; i < x->rays.n; i++) {
    if (sg_dot(x->rays.item[i].normal, one->normal) > SAME) {
      return true;
    }
  }
  return false;
}

/* Both ways from the face of a half-edge, unless from `first` on one runs so.
 * False: no memory. */
static bool
add_rays(casting *x, uint32_t moved, uint32_t half, size_t first)
{
  ray one = {.moved = moved, .face = x->m->face_of[half / 3]};
  double size;

  if (!normal_of(x, half / 3, one.normal) ||
      (size = sg_length(one.normal)) <= 0) {
    return true;
  }
  for (int k = 0; k < 3; k++) {
    one.normal[k] /= size;
  }
  one.move = fabs(sg_dot(one.normal, x->moved[moved].way));
  one.length = SG_TIGHT * one.move;
  if (!(one.move > x->moved[moved].least) || is_there(x, first, &one)) {
    return true;
  }
  find_start(x, half, one.move, one.from);
  for (int sign = -1; sign <= 1; sign += 2) {
    for (int k = 0; k < 3; k++) {
      one.way[k] = sign * one.length * one.normal[k];
    }
    if (!SG_PUSH(x->rays, one)) {
      return false;
    }
  }
  return true;
}

static bool
add_vertex(casting *x, uint32_t moved)
{
  const sg_merge *m = x->m;
  uint32_t v = x->moved[moved].v;
  size_t first = x->rays.n;
  bool good = true;

  for (uint32_t i = m->first[v]; good && i < m->first[v + 1]; i++) {
    good = add_rays(x, moved, m->leaving[i].half, first);
  }
  return good;
}

/* ---- what they hit ---- */

static sg_box
box_of_ray(const ray *r)
{
  sg_box box = sg_box_none();
  double end[3];

  for (int k = 0; k < 3; k++) {
    end[k] = r->from[k] + r->way[k];
  }
  sg_box_add(&box, r->from);
  sg_box_add(&box, end);
  return box;
}

static sg_box
box_of_triangle(const casting *x, uint32_t triangle)
{
  sg_box box = sg_box_none();

  for (int k = 0; k < 3; k++) {
    sg_box_add(&box, sg_merge_at(x->m, x->of->triangle[triangle][k]));
  }
  return box;
}

/* The part of a ray at which it goes through a triangle; false: it does not. */
static bool
goes_through(const casting *x, const ray *r, uint32_t triangle, double *part)
{
  const uint32_t *corner = x->of->triangle[triangle];
  const double *a = sg_merge_at(x->m, corner[0]);
  double u[3], w[3], from[3], p[3], q[3];

  sg_minus(sg_merge_at(x->m, corner[1]), a, u);
  sg_minus(sg_merge_at(x->m, corner[2]), a, w);
  sg_minus(r->from, a, from);
  sg_cross(r->way, w, p);
  sg_cross(from, u, q);
  double whole = sg_dot(u, p);
  double b = sg_dot(from, p) / whole, c = sg_dot(r->way, q) / whole;

  *part = sg_dot(w, q) / whole;
  return whole != 0 && b >= 0 && c >= 0 && b + c <= 1 && *part >= 0 &&
         *part <= 1;
}

/* The other side is of the same segment and no face at the vertex; it looks
 * away from the face where the ray begins. */
static bool
is_across(const casting *x, const ray *r, uint32_t triangle)
{
  uint32_t face = x->m->face_of[triangle];
  const sg_solid_face *one = &x->of->face[r->face];
  const sg_solid_face *other = &x->of->face[face];
  double normal[3];

  return one->s == other->s && one->reversed == other->reversed &&
         !sg_merge_has_face(x->m, x->moved[r->moved].v, face) &&
         normal_of(x, triangle, normal) &&
         sg_merge_look_apart(r->normal, normal);
}

/* Of sg_bvh_join_wanted(). */
static bool
is_wanted(void *data, const sg_bvh_hit *hit)
{
  const joining *j = data;
  const ray *r = &j->x->rays.item[j->rays->item[hit->a]];
  uint32_t triangle = j->x->near.item[j->triangles->item[hit->b]];
  double part;

  return goes_through(j->x, r, triangle, &part) &&
         part * r->length > j->x->moved[r->moved].least &&
         is_across(j->x, r, triangle);
}

static void
see_hit(casting *x, const ray *r, uint32_t triangle)
{
  sg_moved *moved = &x->moved[r->moved];
  double part;

  if (goes_through(x, r, triangle, &part) &&
      r->move * moved->feature > moved->move * part * r->length) {
    moved->move = r->move;
    moved->feature = part * r->length;
    moved->s = x->of->face[r->face].s;
    moved->wall = true;
  }
}

static bool
join(casting *x, const sg_bvh *rays, const sg_bvh *triangles)
{
  sg_bvh_hits hits;
  joining j = {x, rays, triangles};

  if (!sg_bvh_join_wanted(&(sg_bvh_pair){rays, triangles}, 1, 0, is_wanted, &j,
                          x->m->options->pool, NULL, &hits)) {
    return false;
  }
  for (size_t i = 0; i < hits.n; i++) {
    see_hit(x, &x->rays.item[rays->item[hits.hit[i].a]],
            x->near.item[triangles->item[hits.hit[i].b]]);
  }
  free(hits.hit);
  return true;
}

/* The triangles whose boxes the rays' boxes meet. */
static sg_merge_end
find_near(casting *x, const sg_bvh *rays, size_t triangles)
{
  for (size_t t = 0; t < triangles; t++) {
    sg_box box = box_of_triangle(x, (uint32_t)t);

    if (t % OFTEN == 0 && sg_cancelled(x->m->options->cancel)) {
      return SG_MERGE_STOPPED;
    }
    if (sg_bvh_meets(rays, &box) && !SG_PUSH(x->near, (uint32_t)t)) {
      return SG_MERGE_NO_MEMORY;
    }
  }
  return SG_MERGE_DONE;
}

static sg_merge_end
find_hits(casting *x, const sg_bvh *rays, size_t triangles)
{
  sg_merge_end end = find_near(x, rays, triangles);
  sg_box *box = malloc((x->near.n + 1) * sizeof *box);
  sg_bvh *tree = NULL;

  for (size_t i = 0; box && i < x->near.n; i++) {
    box[i] = box_of_triangle(x, x->near.item[i]);
  }
  if (end == SG_MERGE_DONE &&
      (!box || !(tree = sg_bvh_open(box, x->near.n, NULL)) ||
       !join(x, rays, tree))) {
    end = SG_MERGE_NO_MEMORY;
  }
  sg_bvh_close(tree);
  free(box);
  return end;
}

static sg_merge_end
cast(casting *x, size_t triangles)
{
  sg_box *box = malloc((x->rays.n + 1) * sizeof *box);

  for (size_t i = 0; box && i < x->rays.n; i++) {
    box[i] = box_of_ray(&x->rays.item[i]);
  }
  sg_bvh *rays = box ? sg_bvh_open(box, x->rays.n, NULL) : NULL;
  sg_merge_end end = rays ? find_hits(x, rays, triangles) : SG_MERGE_NO_MEMORY;

  sg_bvh_close(rays);
  free(box);
  return end;
}

sg_merge_end
sg_merge_near_sides(const sg_merge *m, const sg_merge_faces *of,
                    size_t triangles, sg_moved *moved, size_t n)
{
  casting x = {.m = m, .of = of, .moved = moved};
  bool good = true;

  for (size_t i = 0; good && i < n; i++) {
    good = add_vertex(&x, (uint32_t)i);
  }
  sg_merge_end end = !good           ? SG_MERGE_NO_MEMORY
                     : x.rays.n == 0 ? SG_MERGE_DONE
                                     : cast(&x, triangles);
  free(x.rays.item);
  free(x.near.item);
  return end;
}
