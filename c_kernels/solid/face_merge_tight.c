/* face_merge_tight.c -- how far merging moves what operands have, beside what
 * is there: see face_merge_private.h.
 *
 * Layer: kernel. Inexact. What cuts have made is of no size of its own, so only
 * vertices of operands are looked at, and the edges that end there; of what
 * cuts made, the walls of operands that they are cut from.
 */
#include "face_merge_private.h"

#include "engine/list.h"
#include "number/vector.h"

#include <stdlib.h>

static sg_merge_source
source_of(const sg_merge *m, int32_t s)
{
  const sg_merge_options *options = m->options;

  return options->source ? options->source(options->data, s)
                         : (sg_merge_source){0};
}

static void
note(sg_merge *m, const sg_moved *one)
{
  if (!(one->move * SG_TIGHT > one->feature)) {
    return;
  }
  sg_merge_source source = source_of(m, one->s);
  if (one->move <= source.rounding) {
    return;
  }
  sg_merge_tight *out = one->move <= source.explained ? &m->rounded : &m->tight;
  out->n++;
  if (out->n == 1 || one->move * out->feature > out->move * one->feature) {
    out->vertex = m->solid->vertex[one->v];
    out->vertex.s = one->s;
    out->move = one->move;
    out->feature = one->feature;
    out->wall = one->wall;
  }
}

static double
between(const sg_merge *m, uint32_t v, uint32_t w)
{
  double d[3];

  sg_minus(sg_merge_at(m, v), sg_merge_at(m, w), d);
  return sg_length(d);
}

/* Both are vertices of one operand. */
static bool
are_given(const sg_merge *m, uint32_t v, uint32_t w)
{
  const sg_solid *solid = m->solid;

  return v < solid->plain && w < solid->plain &&
         solid->vertex[v].s == solid->vertex[w].s;
}

/* ---- walls ---- */

/* The face of a half-edge in the list of those that leave. */
static uint32_t
face_at(const sg_merge *m, uint32_t place)
{
  return m->face_of[m->leaving[place].half / 3];
}

bool
sg_merge_has_face(const sg_merge *m, uint32_t v, uint32_t face)
{
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    if (face_at(m, i) == face) {
      return true;
    }
  }
  return false;
}

bool
sg_merge_normal(const sg_merge *m, const sg_merge_faces *of, uint32_t triangle,
                double out[3])
{
  const uint32_t *corner = of->triangle[triangle];
  double u[3], w[3], x[3];

  sg_minus(sg_merge_at(m, corner[1]), sg_merge_at(m, corner[0]), u);
  sg_minus(sg_merge_at(m, corner[2]), sg_merge_at(m, corner[0]), w);
  sg_minus(w, u, x);
  sg_cross(u, w, out);
  double longest = fmax(sg_length(u), fmax(sg_length(w), sg_length(x)));

  return sg_length(out) > m->tolerance * longest;
}

static bool
normal_at(const sg_merge *m, uint32_t place, double out[3])
{
  const sg_merge_faces of = {m->solid->triangle, m->solid->face};

  return sg_merge_normal(m, &of, m->leaving[place].half / 3, out);
}

#define COSINE_APART 0.866 /* of 30 degrees */

bool
sg_merge_look_apart(const double n[3], const double k[3])
{
  return sg_dot(n, k) < -COSINE_APART * sg_length(n) * sg_length(k);
}

bool
sg_merge_wall(const sg_merge *m, uint32_t v, uint32_t w)
{
  const sg_solid_face *face = m->solid->face;
  double way[3], n[3], k[3];

  sg_minus(sg_merge_at(m, w), sg_merge_at(m, v), way);
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    const sg_solid_face *one = &face[face_at(m, i)];
    if (sg_merge_has_face(m, w, face_at(m, i)) || !normal_at(m, i, n)) {
      continue;
    }
    double least = source_of(m, one->s).rounding;
    for (uint32_t j = m->first[w]; j < m->first[w + 1]; j++) {
      const sg_solid_face *other = &face[face_at(m, j)];
      if (other->s == one->s && other->reversed == one->reversed &&
          !sg_merge_has_face(m, v, face_at(m, j)) && normal_at(m, j, k) &&
          sg_merge_look_apart(n, k) &&
          fabs(sg_dot(n, way)) > least * sg_length(n) &&
          fabs(sg_dot(k, way)) > least * sg_length(k)) {
        return true;
      }
    }
  }
  return false;
}

/* ---- what moves ---- */

typedef SG_LIST_OF(sg_moved) moves;

/* The shortest edge to another vertex of its operand. */
static double
edge_of(const sg_merge *m, uint32_t v)
{
  double edge = INFINITY;

  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    uint32_t w = m->leaving[i].to;
    if (are_given(m, v, w) && !sg_half_is_auxiliary(m, m->leaving[i].half)) {
      edge = fmin(edge, between(m, v, w));
    }
  }
  return edge;
}

/* A vertex moves so: beside an edge there, if it is one of an operand. False:
 * no memory. */
static bool
add_move(moves *all, const sg_merge *m, uint32_t v, const double way[3])
{
  const sg_solid *solid = m->solid;
  bool given = v < solid->plain;
  sg_moved one = {.v = v,
                  .s = given ? solid->vertex[v].s : 0,
                  .way = {way[0], way[1], way[2]},
                  .move = sg_length(way)};

  if (!(one.move > 0)) {
    return true;
  }
  one.least = source_of(m, one.s).rounding;
  one.feature = given ? edge_of(m, v) : INFINITY;
  return !(one.move > one.least) || SG_PUSH(*all, one);
}

/* Beside walls and slots, too; not of cells, whose faces look both ways. */
static sg_merge_end
note_moves(sg_merge *m, const sg_merge_faces *of, size_t triangles, moves *all)
{
  sg_merge_end end = m->options->cells ? SG_MERGE_DONE
                                       : sg_merge_near_sides(m, of, triangles,
                                                             all->item, all->n);

  for (size_t i = 0; end == SG_MERGE_DONE && i < all->n; i++) {
    note(m, &all->item[i]);
  }
  free(all->item);
  return end;
}

/* ---- what is contracted ---- */

/* An edge between vertices of operands, or from one to a cut. */
static void
note_brief(sg_merge *m, const uint32_t *up, uint32_t v, uint32_t w)
{
  const sg_solid *solid = m->solid;

  if ((up[v] != v || up[w] != w) && v < solid->plain &&
      (w >= solid->plain || are_given(m, v, w))) {
    double length = between(m, v, w);
    uint32_t gone = up[v] == v && w < solid->plain ? w : v;
    note(m, &(sg_moved){.v = gone,
                        .s = solid->vertex[gone].s,
                        .move = length,
                        .feature = length});
  }
}

sg_merge_end
sg_merge_note_contracted(sg_merge *m, const sg_contracted *was)
{
  const sg_merge_faces of = {was->triangle, was->face};
  moves all = {0};
  double way[3];
  bool good = true;

  for (size_t i = 0; i < m->briefs; i++) {
    note_brief(m, was->up, m->brief[i][0], m->brief[i][1]);
  }
  for (size_t i = m->solid->plain; good && i < m->solid->vertices; i++) {
    uint32_t v = (uint32_t)i;
    sg_minus(sg_merge_at(m, was->up[v]), sg_merge_at(m, v), way);
    good = add_move(&all, m, v, way);
  }
  sg_merge_end end = note_moves(m, &of, was->triangles, &all);

  return good ? end : SG_MERGE_NO_MEMORY;
}

/* ---- what is left out ---- */

/* The way of a vertex to where its faces will be. One face alone has no other
 * plane than before. A vertex that stays is off it only where a face no wider
 * than the tolerance becomes a part: it may be a wall's end. */
static void
find_way(const sg_merge *m, uint32_t v, double way[3])
{
  bool stays = m->fate[v] != SG_INNER && m->fate[v] != SG_DROPPED;
  double most = 0;

  way[0] = way[1] = way[2] = 0;
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    uint32_t label = m->group_of[m->face_of[m->leaving[i].half / 3]];
    const sg_group *group = label == SG_NOTHING ? NULL : &m->group[label];
    if (group && group->n > 1 && group->state != SG_AS_IT_WAS &&
        (!stays || group->thin)) {
      double off = sg_plane_distance(&group->plane, sg_merge_at(m, v));
      if (fabs(off) > most) {
        most = fabs(off);
        for (int k = 0; k < 3; k++) {
          way[k] = -off * group->plane.n[k];
        }
      }
    }
  }
}

sg_merge_end
sg_merge_note_dropped(sg_merge *m)
{
  const sg_solid *solid = m->solid;
  const sg_merge_faces of = {solid->triangle, solid->face};
  moves all = {0};
  double way[3];
  bool good = true;

  for (uint32_t v = 0; good && m->fate && v < solid->vertices; v++) {
    find_way(m, v, way);
    good = add_move(&all, m, v, way);
  }
  sg_merge_end end = note_moves(m, &of, solid->triangles, &all);

  return good ? end : SG_MERGE_NO_MEMORY;
}
