/* mesh_weld.c -- joins vertices of equal coordinates, by a hash table of
 * vertex numbers (open addressing, at most half full). */
#include "mesh_private.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST_SIZE = 1024, ASK_EVERY = 65536 };

typedef struct sg_weld_table {
  int32_t *slot; /* [size], a vertex number or -1 */
  size_t size;   /* a power of two */
  size_t used;
} sg_weld_table;

static uint64_t
mix(uint64_t h)
{
  h ^= h >> 32;
  h *= 0xd6e8feb86659fd93u;
  return h ^ h >> 29;
}

/* Coordinates are never -0.0, so equal ones have equal bits. */
static uint64_t
hash_point(const double p[3])
{
  uint64_t bits[3];

  memcpy(bits, p, sizeof bits);
  return mix(mix(mix(bits[0]) + bits[1]) + bits[2]);
}

/* Where `p` is, or should be. */
static int32_t *
find_slot(const sg_weld_table *table, double (*vertex)[3], const double p[3])
{
  size_t i = hash_point(p) & (table->size - 1);

  while (table->slot[i] >= 0 &&
         memcmp(vertex[table->slot[i]], p, 3 * sizeof *p) != 0) {
    i = (i + 1) & (table->size - 1);
  }
  return &table->slot[i];
}

static bool
resize(sg_weld_table *table, double (*vertex)[3], size_t size)
{
  int32_t *old = table->slot;
  size_t old_size = old ? table->size : 0;

  table->slot = malloc(size * sizeof *table->slot);
  if (!table->slot) {
    table->slot = old;
    return false;
  }
  memset(table->slot, -1, size * sizeof *table->slot);
  table->size = size;
  for (size_t i = 0; i < old_size; i++) {
    if (old[i] >= 0) {
      *find_slot(table, vertex, vertex[old[i]]) = old[i];
    }
  }
  free(old);
  return true;
}

/* Moves the first of each kind of vertex to the front; number[i] = where
 * vertex i went. */
static bool
join(sg_mesh *mesh, sg_weld_table *table, int32_t *number,
     const sg_cancel *cancel, bool *stopped)
{
  double(*vertex)[3] = mesh->vertex;

  for (size_t i = 0; i < mesh->vertices; i++) {
    if (i % ASK_EVERY == 0 && (*stopped = sg_cancelled(cancel))) {
      return false;
    }
    if (2 * table->used >= table->size &&
        !resize(table, vertex, 2 * table->size)) {
      return false;
    }
    int32_t *slot = find_slot(table, vertex, vertex[i]);
    if (*slot < 0) {
      *slot = (int32_t)table->used;
      memmove(vertex[table->used++], vertex[i], sizeof *vertex);
    }
    number[i] = *slot;
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
  sg_weld_table table = {0};
  int32_t *number = malloc(mesh->vertices * sizeof *number + 1);
  bool done = number && resize(&table, mesh->vertex, FIRST_SIZE) &&
              join(mesh, &table, number, cancel, stopped);

  if (done) {
    renumber(&mesh->face, number);
    renumber(&mesh->curve, number);
    mesh->welded = mesh->vertices - table.used;
    mesh->vertices = table.used;
  }
  free(table.slot);
  free(number);
  return done;
}
