/* face_merge.c -- coplanar neighbours become one face: see face_merge.h. */
#include "face_merge_private.h"
#include "rows/sort.h"

#include <stdlib.h>
#include <string.h>

static void
clear(sg_merge *m)
{
  for (size_t i = 0; i < m->groups; i++) {
    free(m->group[i].triangle);
    free(m->group[i].auxiliary);
  }
  sg_merge_mesh_clear(m);
  free(m->group_of);
  free(m->member);
  free(m->group);
  free(m->fate);
  free(m->adjacent);
}

/* ---- which pairs -------------------------------------------------------- */

static int
compare_sides(const sg_merge_side *x, const sg_merge_side *y)
{
  if (x->s != y->s) {
    return (x->s > y->s) - (x->s < y->s);
  }
  return x->p != y->p ? (x->p > y->p) - (x->p < y->p)
                      : x->reversed - y->reversed;
}

int
sg_merge_pair_compare(const void *a, const void *b)
{
  const sg_merge_pair *x = a, *y = b;
  int order = compare_sides(&x->one, &y->one);

  return order ? order : compare_sides(&x->other, &y->other);
}

void
sg_merge_pair_order(sg_merge_pair *pair)
{
  if (compare_sides(&pair->one, &pair->other) > 0) {
    sg_merge_side kept = pair->one;
    pair->one = pair->other;
    pair->other = kept;
  }
}

static sg_merge_side
side_of(const sg_merge *m, uint32_t face)
{
  const sg_solid_face *f = &m->solid->face[face];

  return (sg_merge_side){f->s, f->p, f->reversed};
}

/* The sides of the weak edges, those of one side left out. */
static bool
list_pairs(const sg_merge *m, sg_merge_pair **out, size_t *n)
{
  sg_merge_pair *list = malloc((m->weaks + 1) * sizeof *list);
  size_t all = 0;

  *n = 0;
  *out = list;
  for (size_t i = 0; list && i < m->weaks; i++) {
    list[all] =
        (sg_merge_pair){side_of(m, m->weak[i][0]), side_of(m, m->weak[i][1])};
    sg_merge_pair_order(&list[all]);
    all += compare_sides(&list[all].one, &list[all].other) != 0;
  }
  if (all) {
    qsort(list, all, sizeof *list, sg_merge_pair_compare);
  }
  for (size_t i = 0; i < all; i++) {
    if (*n == 0 || sg_merge_pair_compare(&list[*n - 1], &list[i]) != 0) {
      list[(*n)++] = list[i];
    }
  }
  return list;
}

sg_merge_end
sg_face_merge_pairs(const sg_solid *solid, const sg_merge_options *options,
                    sg_merge_pair **out, size_t *n)
{
  sg_merge m = {.solid = solid, .options = options};
  sg_merge_end end = sg_merge_mesh(&m);

  if (end == SG_MERGE_DONE && !list_pairs(&m, out, n)) {
    end = SG_MERGE_NO_MEMORY;
  }
  clear(&m);
  return end;
}

/* ---- what has to be done ------------------------------------------------ */

/* Every face is one triangle: then it cannot lose a vertex. */
static bool
only_triangles(const sg_solid *solid)
{
  return solid->faces == solid->triangles;
}

static bool
all_used(const sg_merge *m)
{
  for (size_t v = 0; v < m->solid->vertices; v++) {
    if (m->first[v] == m->first[v + 1]) {
      return false;
    }
  }
  return true;
}

/* Vertices and triangles, until all faces can be had. */
static sg_merge_end
settle(sg_merge *m)
{
  bool again = true;
  sg_merge_end end = SG_MERGE_DONE;

  m->fate = malloc(m->solid->vertices + 1);
  m->adjacent = malloc((m->solid->vertices + 1) * sizeof *m->adjacent);
  if (!m->fate || !m->adjacent) {
    return SG_MERGE_NO_MEMORY;
  }
  while (again && end == SG_MERGE_DONE) {
    end = sg_merge_vertices(m);
    if (end == SG_MERGE_DONE) {
      end = sg_merge_fill(m, &again);
    }
  }
  return end;
}

/* True if something is other than it was. */
static bool
is_changed(const sg_merge *m)
{
  for (size_t i = 0; i < m->groups; i++) {
    const sg_group *group = &m->group[i];
    if (group->state != SG_AS_IT_WAS && (group->n > 1 || group->triangle)) {
      return true;
    }
  }
  return !all_used(m);
}

static void
count_refused(const sg_merge *m, sg_merge_counts *out)
{
  for (size_t i = 0; i < m->groups; i++) {
    out->refused += m->group[i].n > 1 && m->group[i].state == SG_AS_IT_WAS;
  }
}

/* ---- a region ----------------------------------------------------------- */

static bool
is_of_region(const sg_merge_region *region, const sg_solid_face *face)
{
  return sg_find_id(region->s, region->n, face->s) != SIZE_MAX;
}

/* No face of the region might be one with another face, and what others are one
 * need not be asked again. */
static bool
stands_apart(const sg_merge *m)
{
  const sg_merge_region *region = m->options->region;
  const sg_solid_face *face = m->solid->face;

  if (m->others != m->tolerance) {
    return false;
  }
  for (size_t i = 0; region && i < m->weaks; i++) {
    if (is_of_region(region, &face[m->weak[i][0]]) !=
        is_of_region(region, &face[m->weak[i][1]])) {
      return false;
    }
  }
  return true;
}

/* Leaves the faces of the region, with their triangles and parts. */
static void
leave_region(sg_solid *solid, const sg_merge_region *region)
{
  size_t faces = 0, triangles = 0, parts = 0, part = 0;

  for (uint32_t f = 0; f < solid->faces; f++) {
    sg_solid_face face = solid->face[f];
    bool stays = is_of_region(region, &face);

    for (; part < solid->parts && solid->part[part].face == f; part++) {
      if (stays) {
        solid->part[parts] = solid->part[part];
        solid->part[parts++].face = (uint32_t)faces;
      }
    }
    if (stays) {
      memmove(solid->triangle[triangles], solid->triangle[face.first],
              face.n * sizeof *solid->triangle);
      memmove(solid->auxiliary + triangles, solid->auxiliary + face.first,
              face.n);
      face.first = (uint32_t)triangles;
      triangles += face.n;
      solid->face[faces++] = face;
    }
  }
  solid->faces = faces;
  solid->triangles = triangles;
  solid->parts = parts;
  solid->closed = false;
}

/* ---- all of it ---------------------------------------------------------- */

/* Half-edges, once vertices in one place are one. */
static sg_merge_end
make_mesh(sg_merge *m, sg_solid *solid, sg_contracted *before)
{
  sg_merge_end end = sg_merge_mesh(m);

  if (end == SG_MERGE_DONE &&
      (m->briefs || solid->vertices - solid->plain > 1)) {
    end = sg_merge_contract(m, solid, before);
    if (end == SG_MERGE_DONE && before->triangle) {
      end = sg_merge_note_contracted(m, before);
      sg_merge_mesh_clear(m);
      end = end == SG_MERGE_DONE ? sg_merge_mesh(m) : end;
    }
  }
  return end;
}

static sg_merge_end
merge(sg_merge *m, sg_solid *solid, sg_contracted *before)
{
  sg_merge_end end = make_mesh(m, solid, before);

  if (end == SG_MERGE_DONE && !stands_apart(m)) {
    end = SG_MERGE_APART;
  }
  if (end == SG_MERGE_DONE && (m->weaks || !only_triangles(m->solid))) {
    end = sg_merge_grow(m);
  }
  if (end == SG_MERGE_DONE && (m->groups || !only_triangles(m->solid))) {
    end = settle(m);
  }
  return end;
}

sg_merge_end
sg_face_merge(sg_solid *solid, const sg_merge_options *options,
              sg_merge_counts *counts)
{
  sg_merge m = {.solid = solid, .options = options};
  sg_merge_counts done = {.faces_before = solid->faces,
                          .vertices_before = solid->vertices,
                          .triangles_before = solid->triangles};
  sg_contracted before = {0};
  sg_merge_end end = merge(&m, solid, &before);

  solid->closed = false;
  if (end == SG_MERGE_DONE && is_changed(&m)) {
    end = sg_merge_note_dropped(&m);
    end = end == SG_MERGE_DONE ? sg_merge_write(&m, solid) : end;
  } else if (end == SG_MERGE_DONE) {
    solid->closed = m.regular;
  }
  if (end != SG_MERGE_DONE) {
    sg_merge_restore(solid, &before);
  } else if (options->region) {
    leave_region(solid, options->region);
  }
  sg_merge_forget(&before);
  count_refused(&m, &done);
  done.rounded = m.rounded;
  done.tight = m.tight;
  done.faces_after = solid->faces;
  done.vertices_after = solid->vertices;
  done.triangles_after = solid->triangles;
  if (counts) {
    *counts = done;
  }
  clear(&m);
  return end;
}
