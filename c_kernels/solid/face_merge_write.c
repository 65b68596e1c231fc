/* face_merge_write.c -- the solid anew: see face_merge_private.h.
 *
 * Layer: kernel. In place: a face is written where the last of its parts stood,
 * so nothing is written over that is still to be read; what parts are to keep
 * is set aside first.
 */
#include "engine/search.h"
#include "face_merge_private.h"

#include <stdlib.h>
#include <string.h>

typedef struct sg_solid_part part;

typedef struct writer {
  sg_merge *m;
  sg_solid *solid;
  size_t triangles, faces; /* written */
  uint32_t (*kept)[3];     /* [kepts]: what was set aside */
  uint8_t *kept_auxiliary;
  size_t kepts, taken;
  uint32_t *number; /* [vertices]: new ones, or SG_NOTHING */
  part *part;       /* [parts]: new ones */
  size_t parts;
} writer;

static sg_group *
group_at(const sg_merge *m, uint32_t face)
{
  uint32_t number = m->group_of ? m->group_of[face] : SG_NOTHING;
  sg_group *group = number == SG_NOTHING ? NULL : &m->group[number];

  return group && group->state != SG_AS_IT_WAS ? group : NULL;
}

static uint32_t
last_member(const sg_merge *m, const sg_group *group)
{
  return m->member[group->first + group->n - 1];
}

/* ---- parts -------------------------------------------------------------- */

SG_ORDER(compare_parts, part, SG_BY(s) SG_BY(p) SG_BY(reversed));

/* The old parts of a face, by search. */
static size_t
first_part(const sg_solid *solid, uint32_t face)
{
  size_t at;

  SG_SEARCH(at, 0, solid->parts, solid->part[at].face < face);
  return at;
}

/* What face `old` came from becomes what the face at hand came from. */
static void
add_parts(writer *w, uint32_t old)
{
  const sg_solid *solid = w->solid;

  for (size_t i = first_part(solid, old);
       i < solid->parts && solid->part[i].face == old; i++) {
    w->part[w->parts] = solid->part[i];
    w->part[w->parts++].face = (uint32_t)w->faces;
  }
}

/* Sorts the parts from `from` on and leaves out the face's own name and what is
 * there twice. */
static void
settle_parts(writer *w, size_t from, const sg_solid_face *face)
{
  part own = {0, face->s, face->p, face->reversed};
  size_t n = from, sorted = from + 1;

  while (sorted < w->parts &&
         compare_parts(&w->part[sorted - 1], &w->part[sorted]) <= 0) {
    sorted++;
  }
  if (sorted < w->parts) {
    qsort(w->part + from, w->parts - from, sizeof *w->part, compare_parts);
  }
  for (size_t i = from; i < w->parts; i++) {
    if (compare_parts(&w->part[i], &own) != 0 &&
        (n == from || compare_parts(&w->part[n - 1], &w->part[i]) != 0)) {
      w->part[n++] = w->part[i];
    }
  }
  w->parts = n;
}

/* The parts of all faces there will be, while the old faces are there. */
static void
list_parts(writer *w)
{
  const sg_merge *m = w->m;

  for (uint32_t f = 0; f < m->solid->faces; f++) {
    const sg_group *group = group_at(m, f);
    size_t from = w->parts;
    if (!group) {
      add_parts(w, f);
    } else if (f != last_member(m, group)) {
      continue;
    } else {
      for (uint32_t i = group->first; i < group->first + group->n; i++) {
        const sg_solid_face *face = &m->solid->face[m->member[i]];
        w->part[w->parts++] =
            (part){(uint32_t)w->faces, face->s, face->p, face->reversed};
        add_parts(w, m->member[i]);
      }
      settle_parts(w, from, &m->solid->face[group->largest]);
    }
    w->faces++;
  }
  w->faces = 0;
}

/* ---- faces -------------------------------------------------------------- */

static void
keep(writer *w, uint32_t f)
{
  const sg_solid_face *face = &w->solid->face[f];

  memcpy(w->kept + w->kepts, w->solid->triangle + face->first,
         face->n * sizeof *w->kept);
  memcpy(w->kept_auxiliary + w->kepts, w->solid->auxiliary + face->first,
         face->n);
  w->kepts += face->n;
}

/* Sets aside what groups are called, and the triangles of those that keep
 * theirs, in the order in which they will be written. */
static void
set_aside(writer *w)
{
  const sg_merge *m = w->m;

  for (uint32_t f = 0; f < w->solid->faces; f++) {
    sg_group *group = group_at(m, f);
    if (!group || f != last_member(m, group)) {
      continue;
    }
    group->name = w->solid->face[group->largest];
    for (uint32_t i = 0; !group->triangle && i < group->n; i++) {
      uint32_t member = m->member[group->first + i];
      group->triangles += w->solid->face[member].n;
      keep(w, member);
    }
  }
}

static void
write_face(writer *w, const sg_solid_face *name, const uint32_t (*triangle)[3],
           const uint8_t *auxiliary, uint32_t n)
{
  sg_solid *solid = w->solid;
  sg_solid_face face = *name;

  face.first = (uint32_t)w->triangles;
  face.n = n;
  memmove(solid->triangle + w->triangles, triangle,
          n * sizeof *solid->triangle);
  memmove(solid->auxiliary + w->triangles, auxiliary, n);
  solid->face[w->faces++] = face;
  w->triangles += n;
}

static void
write_group(writer *w, const sg_group *group)
{
  uint32_t n = (uint32_t)group->triangles;

  if (group->triangle) {
    write_face(w, &group->name, (const uint32_t(*)[3])group->triangle,
               group->auxiliary, n);
  } else {
    write_face(w, &group->name, (const uint32_t(*)[3])(w->kept + w->taken),
               w->kept_auxiliary + w->taken, n);
    w->taken += n;
  }
}

static void
write_faces(writer *w)
{
  sg_solid *solid = w->solid;

  for (uint32_t f = 0; f < solid->faces; f++) {
    const sg_group *group = group_at(w->m, f);
    const sg_solid_face face = solid->face[f];
    if (!group) {
      write_face(w, &face, (const uint32_t(*)[3])(solid->triangle + face.first),
                 solid->auxiliary + face.first, face.n);
    } else if (f == last_member(w->m, group)) {
      write_group(w, group);
    }
  }
  solid->faces = w->faces;
  solid->triangles = w->triangles;
}

/* ---- vertices ----------------------------------------------------------- */

static bool
is_gone(const sg_merge *m, size_t v)
{
  return m->first[v] == m->first[v + 1] ||
         (m->fate && (m->fate[v] == SG_INNER || m->fate[v] == SG_DROPPED));
}

/* Numbers what is left, in its order; false: all of it is. */
static bool
number_vertices(writer *w)
{
  uint32_t n = 0;

  for (size_t v = 0; v < w->solid->vertices; v++) {
    w->number[v] = is_gone(w->m, v) ? SG_NOTHING : n++;
  }
  return n < w->solid->vertices;
}

/* Moves the vertices that are left, and what the made ones are called. */
static void
move_vertices(writer *w)
{
  sg_solid *solid = w->solid;
  size_t plain = 0, n = 0;

  for (size_t v = 0; v < solid->plain; v++) {
    plain += w->number[v] != SG_NOTHING;
  }
  for (size_t v = 0; v < solid->vertices; v++) {
    if (w->number[v] == SG_NOTHING) {
      continue;
    }
    solid->vertex[n] = solid->vertex[v];
    if (v >= solid->plain && solid->origin) {
      solid->origin[n - plain] = solid->origin[v - solid->plain];
    }
    n++;
  }
  solid->plain = plain;
  solid->vertices = n;
}

static void
number_corners(const writer *w)
{
  for (size_t t = 0; t < w->solid->triangles; t++) {
    for (int k = 0; k < 3; k++) {
      uint32_t *corner = &w->solid->triangle[t][k];
      *corner = w->number[*corner];
    }
  }
}

/* ---- all of it ---------------------------------------------------------- */

/* Whether the solid will have parts. */
static bool
has_parts(const sg_merge *m)
{
  bool any = m->solid->parts > 0;

  for (size_t i = 0; !any && i < m->groups; i++) {
    any = m->group[i].n > 1 && m->group[i].state != SG_AS_IT_WAS;
  }
  return any;
}

static bool
make_room(writer *w)
{
  const sg_merge *m = w->m;
  size_t kept = 0;

  for (size_t i = 0; i < m->members; i++) {
    const sg_group *group = group_at(m, m->member[i]);
    kept += group && !group->triangle ? m->solid->face[m->member[i]].n : 0;
  }
  w->kept = malloc((kept + 1) * sizeof *w->kept);
  w->kept_auxiliary = malloc(kept + 1);
  w->number = malloc((m->solid->vertices + 1) * sizeof *w->number);
  w->part = malloc((m->solid->parts + m->members + 1) * sizeof *w->part);
  return w->kept && w->kept_auxiliary && w->number && w->part;
}

static void
write_all(writer *w)
{
  sg_solid *solid = w->solid;

  if (has_parts(w->m)) {
    list_parts(w);
  }
  set_aside(w);
  write_faces(w);
  free(solid->part);
  solid->part = w->part;
  solid->parts = w->parts;
  w->part = NULL;
  if (number_vertices(w)) {
    move_vertices(w);
    number_corners(w);
  }
}

sg_merge_end
sg_merge_write(sg_merge *m, sg_solid *solid)
{
  writer w = {.m = m, .solid = solid};
  bool room = make_room(&w);

  if (room) {
    write_all(&w);
  }
  free(w.kept);
  free(w.kept_auxiliary);
  free(w.number);
  free(w.part);
  return room ? SG_MERGE_DONE : SG_MERGE_NO_MEMORY;
}
