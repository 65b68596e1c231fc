/* face_merge_tight.c -- how far merging moves what operands have, beside what
 * is there: see face_merge_private.h.
 *
 * Layer: kernel. Inexact. What cuts have made is of no size of its own, so only
 * vertices of operands are looked at, and the edges that end there; but a wall
 * of an operand may have cuts alone at its ends.
 */
#include "face_merge_private.h"

#include "number/vector.h"

#include <stdlib.h>

enum { TIGHT = 100 }; /* a move that is more than 1 / TIGHT of an edge is */

/* What is there is of segment s. */
static void
note(sg_merge *m, uint32_t v, int32_t s, double move, double feature)
{
  sg_merge_source source = {0};

  if (!(move * TIGHT > feature)) {
    return;
  }
  if (m->options->source) {
    source = m->options->source(m->options->data, s);
  }
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

/* ---- what is contracted ---- */

/* The face of a half-edge in the list of those that leave, before. */
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

static void
normal_at(const sg_merge *m, const sg_contracted *was, uint32_t place,
          double out[3])
{
  const uint32_t *corner = was->triangle[m->leaving[place].half / 3];
  double u[3], w[3];

  sg_minus(sg_merge_at(m, corner[1]), sg_merge_at(m, corner[0]), u);
  sg_minus(sg_merge_at(m, corner[2]), sg_merge_at(m, corner[0]), w);
  sg_cross(u, w, out);
}

/* How thick the wall of a segment is between v and w: it has a face at each of
 * them, not at the other, and these look apart. Planes that cross at a small
 * angle part v and w by more than that. 0: there is none. */
static double
wall_between(const sg_merge *m, const sg_contracted *was, uint32_t v,
             uint32_t w, int32_t *s)
{
  double way[3];

  sg_minus(sg_merge_at(m, w), sg_merge_at(m, v), way);
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    const sg_solid_face *one = &was->face[face_at(m, i)];
    double n[3], k[3];

    if (has_face(m, w, face_at(m, i))) {
      continue;
    }
    normal_at(m, was, i, n);
    for (uint32_t j = m->first[w]; j < m->first[w + 1]; j++) {
      if (was->face[face_at(m, j)].s == one->s &&
          !has_face(m, v, face_at(m, j))) {
        normal_at(m, was, j, k);
        if (sg_dot(n, k) < 0) {
          *s = one->s;
          return fmin(fabs(sg_dot(n, way)) / sg_length(n),
                      fabs(sg_dot(k, way)) / sg_length(k));
        }
      }
    }
  }
  return 0;
}

sg_merge_end
sg_merge_note_contracted(sg_merge *m, const sg_contracted *was)
{
  const sg_solid *solid = m->solid;
  unsigned char *used = calloc(solid->vertices + 1, 1);

  for (size_t t = 0; used && t < solid->triangles; t++) {
    for (int k = 0; k < 3; k++) {
      used[solid->triangle[t][k]] = 1;
    }
  }
  for (size_t i = 0; used && i < m->briefs; i++) {
    uint32_t v = m->brief[i][0], w = m->brief[i][1];
    if (v < solid->plain && (!used[v] || !used[w]) &&
        (w >= solid->plain || are_given(m, v, w))) {
      double length = between(m, v, w);
      uint32_t gone = used[v] && w < solid->plain ? w : v;
      note(m, gone, solid->vertex[gone].s, length, length);
    } else if (v >= solid->plain && w >= solid->plain &&
               !(used[v] && used[w])) {
      int32_t s = 0;
      double thick = wall_between(m, was, v, w, &s);
      note(m, v, s, thick, thick);
    }
  }
  free(used);
  return used ? SG_MERGE_DONE : SG_MERGE_NO_MEMORY;
}

/* How far a vertex is from where its faces will be. One face alone has no other
 * plane than before. */
static double
move_of(const sg_merge *m, uint32_t v)
{
  double move = 0;

  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    uint32_t group = m->group_of[m->face_of[m->leaving[i].half / 3]];
    if (group != SG_NOTHING && m->group[group].n > 1 &&
        m->group[group].state != SG_AS_IT_WAS) {
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
  for (uint32_t v = 0; m->fate && v < m->solid->plain; v++) {
    if (m->fate[v] == SG_INNER || m->fate[v] == SG_DROPPED) {
      note(m, v, m->solid->vertex[v].s, move_of(m, v), edge_of(m, v));
    }
  }
}
