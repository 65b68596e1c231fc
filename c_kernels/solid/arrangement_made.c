/* arrangement_made.c -- the vertices that cuts made, by name: see
 * arrangement.h.
 *
 * Layer: kernel. Solids are selected again and again, so what they need of a
 * vertex stands together, and is found by counting.
 */
#include "arrangement_private.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* Widens first .. last by a name, if a cut made it. */
static void
see_name(const sg_arranged *leaf, int32_t v, int32_t *first, int32_t *last)
{
  if (sg_arrangement_node(leaf, v) == SG_NO_KEY) {
    *first = v < *first ? v : *first;
    *last = v > *last ? v : *last;
  }
}

static void
see_cell(const sg_arrangement *a, const sg_arranged *leaf, const sg_cell *cell,
         int32_t *first, int32_t *last)
{
  for (size_t j = cell->first; j < cell->first + cell->n; j++) {
    for (int c = 0; c < 3; c++) {
      see_name(leaf, a->triangle[j].v[c], first, last);
    }
  }
}

/* A leaf's are named one after another. */
static bool
make_room(sg_arranged *leaf, int32_t first, int32_t last)
{
  if (first > last) {
    return true;
  }
  leaf->first_made = first;
  leaf->mades = (size_t)((int64_t)last - first) + 1;
  leaf->made = malloc(leaf->mades * sizeof *leaf->made);
  for (size_t i = 0; leaf->made && i < leaf->mades; i++) {
    leaf->made[i] = (sg_made_vertex){{0, 0, 0}, SG_NO_KEY};
  }
  return leaf->made != NULL;
}

static void
note_vertex(const sg_arrangement *a, sg_arranged *leaf, int32_t v)
{
  const sg_cut_points *points = &a->leaves.set->points;
  sg_made_vertex *made = &leaf->made[v - leaf->first_made];

  if (made->point == SG_NO_KEY) {
    made->point = sg_cut_points_named(points, leaf->s, v);
    memcpy(made->at, points->point[made->point].at.p, sizeof made->at);
  }
}

static void
note_cell(const sg_arrangement *a, sg_arranged *leaf, const sg_cell *cell)
{
  for (size_t j = cell->first; j < cell->first + cell->n; j++) {
    for (int c = 0; c < 3; c++) {
      int32_t v = a->triangle[j].v[c];

      if (sg_arrangement_node(leaf, v) == SG_NO_KEY) {
        note_vertex(a, leaf, v);
      }
    }
  }
}

static bool
find_made(const sg_arrangement *a, sg_arranged *leaf)
{
  size_t end = leaf->first_cell + leaf->cells;
  int32_t first = INT32_MAX, last = INT32_MIN;

  for (size_t i = leaf->first_cell; i < end; i++) {
    see_cell(a, leaf, &a->cell[i], &first, &last);
  }
  if (!make_room(leaf, first, last)) {
    return false;
  }
  for (size_t i = leaf->first_cell; i < end; i++) {
    note_cell(a, leaf, &a->cell[i]);
  }
  return true;
}

typedef struct finding {
  sg_arrangement *a;
  atomic_bool failed;
} finding;

static void
find_made_task(void *data, size_t number)
{
  finding *f = data;
  sg_arranged *leaf = &f->a->leaf[number];

  if (leaf->wanted && !find_made(f->a, leaf)) {
    atomic_store(&f->failed, true);
  }
}

bool
sg_arrangement_find_made(sg_arrangement *a, sg_pool *pool,
                         const sg_cancel *cancel)
{
  finding f = {.a = a};

  return sg_pool_run(pool, a->leaves.n, find_made_task, &f, cancel) &&
         !atomic_load(&f.failed);
}

const sg_made_vertex *
sg_arrangement_made(const sg_arrangement *a, size_t leaf, size_t *n)
{
  *n = a->leaf[leaf].mades;
  return a->leaf[leaf].made;
}
