/* face_merge_tight.c -- how far merging moves what operands have, beside what
 * is there: see face_merge_private.h.
 *
 * Layer: kernel. Inexact. What cuts have made is of no size of its own, so only
 * vertices of operands are looked at, and the edges that end there; of what
 * cuts made, the walls of operands that they are cut from.
 */
#include "face_merge_private.h"

#include "number/vector.h"

enum { TIGHT = 100 }; /* a move that is more than 1 / TIGHT of an edge is */

static sg_merge_source
source_of(const sg_merge *m, int32_t s)
{
  const sg_merge_options *options = m->options;

  return options->source ? options->source(options->data, s)
                         : (sg_merge_source){0};
}

/* What is there is of segment s. */
static void
note(sg_merge *m, uint32_t v, int32_t s, double move, double feature)
{
  if (!(move * TIGHT > feature)) {
    return;
  }
  sg_merge_source source = source_of(m, s);
  if (move <= source.rounding) {
    return;
  }
  sg_merge_tight *out = move <= source.explained ? &m->rounded : &m->tight;
  out->n++;
  if (out->n == 1 || move * out->feature > out->move * feature) {
    out->vertex = m->solid->vertex[v];
    out->vertex.s = s;
    out->move = move;
    out->feature = feature;
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

static bool
has_face(const sg_merge *m, uint32_t v, uint32_t face)
{
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    if (face_at(m, i) == face) {
      return true;
    }
  }
  return false;
}

/* False: the triangle is no wider than the tolerance, so it looks any way. */
static bool
normal_at(const sg_merge *m, const sg_merge_faces *of, uint32_t place,
          double out[3])
{
  const uint32_t *corner = of->triangle[m->leaving[place].half / 3];
  double u[3], w[3], x[3];

  sg_minus(sg_merge_at(m, corner[1]), sg_merge_at(m, corner[0]), u);
  sg_minus(sg_merge_at(m, corner[2]), sg_merge_at(m, corner[0]), w);
  sg_minus(w, u, x);
  sg_cross(u, w, out);
  double longest = fmax(sg_length(u), fmax(sg_length(w), sg_length(x)));

  return sg_length(out) > m->tolerance * longest;
}

#define COSINE_APART 0.866 /* of 30 degrees */

/* Whether they look opposite ways, to within that angle: faces at a blunter
 * edge are no sides of a wall. */
static bool
look_apart(const double n[3], const double k[3])
{
  return sg_dot(n, k) < -COSINE_APART * sg_length(n) * sg_length(k);
}

bool
sg_merge_wall(const sg_merge *m, const sg_merge_faces *of, uint32_t v,
              uint32_t w, sg_merge_sides *out)
{
  double way[3], n[3], k[3];

  sg_minus(sg_merge_at(m, w), sg_merge_at(m, v), way);
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    const sg_solid_face *one = &of->face[face_at(m, i)];
    if (has_face(m, w, face_at(m, i)) || !normal_at(m, of, i, n)) {
      continue;
    }
    for (uint32_t j = m->first[w]; j < m->first[w + 1]; j++) {
      const sg_solid_face *other = &of->face[face_at(m, j)];
      if (other->s == one->s && other->reversed == one->reversed &&
          !has_face(m, v, face_at(m, j)) && normal_at(m, of, j, k) &&
          look_apart(n, k)) {
        double thick = fmin(fabs(sg_dot(n, way)) / sg_length(n),
                            fabs(sg_dot(k, way)) / sg_length(k));
        if (thick > source_of(m, one->s).rounding) {
          *out = (sg_merge_sides){one->s, thick, {n[0], n[1], n[2]}};
          return true;
        }
      }
    }
  }
  return false;
}

/* A vertex that a cut made is `move` from where it was, or goes to another one,
 * if that is not SG_NOTHING: beside the walls there, which that moves in parts
 * only. Not of cells, whose faces look both ways. */
static void
note_made(sg_merge *m, const sg_merge_faces *of, uint32_t v, double move,
          uint32_t to)
{
  sg_merge_sides wall, worst = {0, INFINITY, {0}};
  double way[3], most = 0;

  if (m->options->cells || !(move > source_of(m, 0).rounding)) {
    return;
  }
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    if (!sg_merge_wall(m, of, v, m->leaving[i].to, &wall)) {
      continue;
    }
    double part = move;
    if (to != SG_NOTHING) {
      sg_minus(sg_merge_at(m, to), sg_merge_at(m, v), way);
      part = fabs(sg_dot(wall.normal, way)) / sg_length(wall.normal);
    }
    if (part * worst.thick > most * wall.thick) {
      most = part;
      worst = wall;
    }
  }
  note(m, v, worst.s, most, worst.thick);
}

/* ---- what is contracted ---- */

/* An edge between vertices of operands, from one to a cut, or between cuts that
 * have a wall between them. */
static void
note_brief(sg_merge *m, const sg_merge_faces *of, const uint32_t *up,
           uint32_t v, uint32_t w)
{
  const sg_solid *solid = m->solid;
  sg_merge_sides wall;

  if (up[v] == v && up[w] == w) {
    return;
  }
  if (v < solid->plain && (w >= solid->plain || are_given(m, v, w))) {
    double length = between(m, v, w);
    uint32_t gone = up[v] == v && w < solid->plain ? w : v;
    note(m, gone, solid->vertex[gone].s, length, length);
  } else if (v >= solid->plain && w >= solid->plain &&
             sg_merge_wall(m, of, v, w, &wall)) {
    note(m, v, wall.s, wall.thick, wall.thick);
  }
}

void
sg_merge_note_contracted(sg_merge *m, const sg_contracted *was)
{
  const sg_merge_faces of = {was->triangle, was->face};

  for (size_t i = 0; i < m->briefs; i++) {
    note_brief(m, &of, was->up, m->brief[i][0], m->brief[i][1]);
  }
  for (size_t v = m->solid->plain; v < m->solid->vertices; v++) {
    uint32_t made = (uint32_t)v, root = was->up[v];
    if (root != made) {
      note_made(m, &of, made, between(m, made, root), root);
    }
  }
}

/* ---- what is left out ---- */

/* How far a vertex is from where its faces will be. One face alone has no other
 * plane than before. A vertex that stays is off it only where a face no wider
 * than the tolerance becomes a part: it may be a wall's end. */
static double
move_of(const sg_merge *m, uint32_t v)
{
  bool stays = m->fate[v] != SG_INNER && m->fate[v] != SG_DROPPED;
  double move = 0;

  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    uint32_t group = m->group_of[m->face_of[m->leaving[i].half / 3]];
    if (group != SG_NOTHING && m->group[group].n > 1 &&
        m->group[group].state != SG_AS_IT_WAS &&
        (!stays || m->group[group].thin)) {
      move = fmax(move, fabs(sg_plane_distance(&m->group[group].plane,
                                               sg_merge_at(m, v))));
    }
  }
  return move;
}

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

void
sg_merge_note_dropped(sg_merge *m)
{
  const sg_solid *solid = m->solid;
  const sg_merge_faces of = {solid->triangle, solid->face};

  for (uint32_t v = 0; m->fate && v < solid->vertices; v++) {
    if (v < solid->plain) {
      note(m, v, solid->vertex[v].s, move_of(m, v), edge_of(m, v));
    } else {
      note_made(m, &of, v, move_of(m, v), SG_NOTHING);
    }
  }
}
