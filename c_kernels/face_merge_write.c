/* face_merge_write.c -- the solid anew: see face_merge_private.h.
 *
 * Layer: kernel.
 */
#include "face_merge_private.h"

#include <stdlib.h>
#include <string.h>

/* The solid that is being written; everything in it fits. */
typedef struct writer {
  const sg_merge *m;
  sg_solid *out;
  uint32_t *number; /* [vertices]: new ones, SG_NOTHING: in no triangle */
  const struct sg_solid_part *part; /* the old ones, by face */
  size_t parts, next;               /* the first of the face at hand */
} writer;

typedef struct sg_solid_part part;

static const sg_group *
group_at(const sg_merge *m, uint32_t face)
{
  uint32_t number = m->group_of[m->label[face]];
  const sg_group *group = number == SG_NOTHING ? NULL : &m->group[number];

  return group && group->state != SG_AS_IT_WAS ? group : NULL;
}

/* ---- parts -------------------------------------------------------------- */

static int
compare_parts(const void *a, const void *b)
{
  const part *x = a, *y = b;

  if (x->s != y->s) {
    return (x->s > y->s) - (x->s < y->s);
  }
  return x->p != y->p ? (x->p > y->p) - (x->p < y->p)
                      : x->reversed - y->reversed;
}

/* The old parts of a face, by search. */
static size_t
first_part(const sg_solid *solid, uint32_t face)
{
  size_t low = 0, high = solid->parts;

  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (solid->part[middle].face < face) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

static void
add_part(writer *w, int32_t s, int32_t p, bool reversed)
{
  w->out->part[w->out->parts++] =
      (part){(uint32_t)w->out->faces - 1, s, p, reversed};
}

/* What face `old` came from becomes what the last face written came from. */
static void
add_parts(writer *w, uint32_t old)
{
  const sg_solid *solid = w->m->solid;

  for (size_t i = first_part(solid, old);
       i < solid->parts && solid->part[i].face == old; i++) {
    add_part(w, solid->part[i].s, solid->part[i].p, solid->part[i].reversed);
  }
}

/* Sorts the parts from `from` on and leaves out the face's own name and what is
 * there twice. */
static void
settle_parts(writer *w, size_t from)
{
  sg_solid *out = w->out;
  const sg_solid_face *face = &out->face[out->faces - 1];
  part own = {0, face->s, face->p, face->reversed};
  size_t n = from;

  qsort(out->part + from, out->parts - from, sizeof *out->part, compare_parts);
  for (size_t i = from; i < out->parts; i++) {
    if (compare_parts(&out->part[i], &own) != 0 &&
        (n == from || compare_parts(&out->part[n - 1], &out->part[i]) != 0)) {
      out->part[n++] = out->part[i];
    }
  }
  out->parts = n;
}

/* ---- faces -------------------------------------------------------------- */

static void
copy_triangles(writer *w, const sg_solid_face *face)
{
  const sg_solid *solid = w->m->solid;
  sg_solid *out = w->out;

  memcpy(out->triangle + out->triangles, solid->triangle + face->first,
         face->n * sizeof *out->triangle);
  memcpy(out->auxiliary + out->triangles, solid->auxiliary + face->first,
         face->n);
  out->triangles += face->n;
}

/* A face as it was. */
static void
write_face(writer *w, uint32_t f)
{
  const sg_solid_face *face = &w->m->solid->face[f];
  uint32_t first = (uint32_t)w->out->triangles;

  copy_triangles(w, face);
  w->out->face[w->out->faces++] =
      (sg_solid_face){face->s, face->p, face->reversed, first, face->n};
  if (w->m->solid->parts) {
    add_parts(w, f);
  }
}

static void
write_group(writer *w, const sg_group *group)
{
  const sg_merge *m = w->m;
  sg_solid *out = w->out;
  const sg_solid_face *largest = &m->solid->face[group->largest];
  uint32_t first = (uint32_t)out->triangles;
  size_t parts = out->parts;

  if (group->triangle) {
    memcpy(out->triangle + first, group->triangle,
           group->triangles * sizeof *out->triangle);
    memcpy(out->auxiliary + first, group->auxiliary, group->triangles);
    out->triangles += group->triangles;
  }
  out->face[out->faces++] =
      (sg_solid_face){largest->s, largest->p, largest->reversed, first, 0};
  for (uint32_t i = group->first; i < group->first + group->n; i++) {
    uint32_t f = m->member[i];
    const sg_solid_face *face = &m->solid->face[f];
    if (!group->triangle) {
      copy_triangles(w, face);
    }
    add_part(w, face->s, face->p, face->reversed);
    add_parts(w, f);
  }
  settle_parts(w, parts);
  out->face[out->faces - 1].n = (uint32_t)(out->triangles - first);
}

static void
write_faces(writer *w)
{
  const sg_merge *m = w->m;

  for (uint32_t f = 0; f < m->solid->faces; f++) {
    const sg_group *group = group_at(m, f);
    if (!group) {
      write_face(w, f);
    } else if (group->label == f) {
      write_group(w, group);
    }
  }
}

/* ---- vertices ----------------------------------------------------------- */

/* Copies the vertices that are in triangles, in their order, and what the made
 * ones are called. */
static void
write_vertices(writer *w)
{
  const sg_solid *solid = w->m->solid;
  sg_solid *out = w->out;
  const uint32_t *corner = (const uint32_t *)out->triangle;

  memset(w->number, 0xff, solid->vertices * sizeof *w->number);
  for (size_t i = 0; i < 3 * out->triangles; i++) {
    w->number[corner[i]] = 0;
  }
  for (size_t v = 0; v < solid->vertices; v++) {
    out->plain = v == solid->plain ? out->vertices : out->plain;
    if (w->number[v] != SG_NOTHING) {
      w->number[v] = (uint32_t)out->vertices;
      out->vertex[out->vertices++] = solid->vertex[v];
    }
  }
  out->plain = solid->plain == solid->vertices ? out->vertices : out->plain;
  for (size_t t = 0; t < out->triangles; t++) {
    for (int k = 0; k < 3; k++) {
      out->triangle[t][k] = w->number[out->triangle[t][k]];
    }
  }
}

/* Hands the names of made vertices over; those of others are freed. */
static void
hand_over_names(const writer *w)
{
  const sg_solid *solid = w->m->solid;
  uint32_t **origin = w->out->origin;

  for (size_t v = solid->plain; solid->origin && v < solid->vertices; v++) {
    uint32_t **name = &solid->origin[v - solid->plain];
    if (w->number[v] == SG_NOTHING) {
      free(*name);
    } else {
      origin[w->number[v] - w->out->plain] = *name;
    }
    *name = NULL;
  }
}

static bool
make_room(const sg_merge *m, sg_solid *out)
{
  const sg_solid *solid = m->solid;
  size_t triangles = solid->triangles;

  for (size_t i = 0; i < m->groups; i++) {
    triangles += m->group[i].triangles;
  }
  out->vertex = malloc((solid->vertices + 1) * sizeof *out->vertex);
  out->origin = calloc(solid->vertices - solid->plain + 1, sizeof *out->origin);
  out->triangle = malloc((triangles + 1) * sizeof *out->triangle);
  out->auxiliary = malloc(triangles + 1);
  out->face = malloc((solid->faces + 1) * sizeof *out->face);
  out->part = malloc((solid->parts + m->members + 1) * sizeof *out->part);
  return out->vertex && out->origin && out->triangle && out->auxiliary &&
         out->face && out->part;
}

sg_merge_end
sg_merge_write(const sg_merge *m, sg_solid *out)
{
  writer w = {.m = m, .out = out};

  *out = (sg_solid){0};
  w.number = malloc((m->solid->vertices + 1) * sizeof *w.number);
  bool written = w.number && make_room(m, out);
  if (written) {
    write_faces(&w);
    write_vertices(&w);
    hand_over_names(&w);
  } else {
    out->plain = out->vertices = 0;
    sg_solid_clear(out);
  }
  free(w.number);
  return written ? SG_MERGE_DONE : SG_MERGE_NO_MEMORY;
}
