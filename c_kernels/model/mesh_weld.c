/* mesh_weld.c -- joins vertices of equal coordinates, by a hash table of
 * their coordinates. */
#include "mesh_private.h"
#include "rows/key_table.h"

#include <stdlib.h>
#include <string.h>

enum { ASK_EVERY = 65536, AHEAD = 8 };

/* Moves the first of each kind of vertex to the front;
 * number[i] = where vertex i went. Coordinates are never -0.0, so equal ones
 * have equal bits. */
static bool
join(sg_mesh *mesh, sg_key_table *table, int32_t *number,
     const sg_cancel *cancel, bool *stopped)
{
  double(*vertex)[3] = mesh->vertex;

  for (size_t i = 0; i < mesh->vertices; i++) {
    uint32_t key[6], *place;

    if (i % ASK_EVERY == 0 && (*stopped = sg_cancelled(cancel))) {
      return false;
    }
    if (i + AHEAD < mesh->vertices) {
      memcpy(key, vertex[i + AHEAD], sizeof key);
      sg_key_table_fetch(table, key);
    }
    memcpy(key, vertex[i], sizeof key);
    if (!(place = sg_key_table_put(table, key))) {
      return false;
    }
    if (*place == SG_NO_KEY) {
      *place = (uint32_t)table->n - 1;
      memmove(vertex[*place], vertex[i], sizeof *vertex);
    }
    number[i] = (int32_t)*place;
  }
  return true;
}

static void
renumber(sg_mesh_lists *lists, const int32_t *number)
{
  for (size_t i = 0; i < lists->corners; i++) {
    lists->corner[i] = number[lists->corner[i]];
  }
}

bool
sg_mesh_weld_vertices(sg_mesh *mesh, const sg_cancel *cancel, bool *stopped)
{
  sg_key_table table;
  int32_t *number = malloc(mesh->vertices * sizeof *number + 1);
  bool done;

  sg_key_table_init(&table, 6);
  done = number && join(mesh, &table, number, cancel, stopped);
  if (done) {
    renumber(&mesh->face, number);
    renumber(&mesh->curve, number);
    mesh->welded = mesh->vertices - table.n;
    mesh->vertices = table.n;
  }
  sg_key_table_clear(&table);
  free(number);
  return done;
}
