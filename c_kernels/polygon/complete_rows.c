/* complete_rows.c -- the rows that a completion writes: see complete_private.h.
 */
#include "complete_private.h"
#include "engine/list.h"

#include <stdlib.h>

void
sg_completion_clear(sg_completion *out)
{
  free(out->planes.s);
  free(out->planes.p);
  for (int k = 0; k < 4; k++) {
    free(out->planes.c[k]);
  }
  free(out->triangles.s);
  free(out->triangles.p);
  free(out->triangles.t);
  for (int k = 0; k < 3; k++) {
    free(out->triangles.v[k]);
  }
  free(out->fault);
  *out = (sg_completion){0};
}

/* One more in an array whose room is that of others, too. */
static bool
widen(void *item, size_t n, size_t room, size_t size)
{
  return sg_list_grow(item, n, &room, size);
}

bool
sg_complete_add_plane(sg_plane_rows *rows, int32_t s, int32_t p,
                      const sg_plane *plane)
{
  bool good = widen(&rows->s, rows->n, rows->room, sizeof *rows->s);

  for (int k = 0; k < 4; k++) {
    good = good && widen(&rows->c[k], rows->n, rows->room, sizeof *rows->c[k]);
  }
  if (!good || !sg_list_grow(&rows->p, rows->n, &rows->room, sizeof *rows->p)) {
    return false;
  }
  rows->s[rows->n] = s;
  rows->p[rows->n] = p;
  for (int k = 0; k < 3; k++) {
    rows->c[k][rows->n] = plane->n[k];
  }
  rows->c[3][rows->n++] = plane->d;
  return true;
}

/* The next number of segment s; counts[s] are those given out. */
static bool
next_number(sg_key_table *counts, int32_t s, int32_t *out)
{
  uint32_t *count = sg_key_table_put(counts, (const uint32_t[]){(uint32_t)s});

  if (!count) {
    return false;
  }
  *count = *count == SG_NO_KEY ? 1 : *count + 1;
  *out = (int32_t)*count - 1;
  return true;
}

bool
sg_complete_add_triangle(sg_triangle_rows *rows, sg_key_table *counts,
                         int32_t s, int32_t p, const int32_t v[3])
{
  bool good = widen(&rows->s, rows->n, rows->room, sizeof *rows->s) &&
              widen(&rows->p, rows->n, rows->room, sizeof *rows->p);

  for (int k = 0; k < 3; k++) {
    good = good && widen(&rows->v[k], rows->n, rows->room, sizeof *rows->v[k]);
  }
  if (!good || !sg_list_grow(&rows->t, rows->n, &rows->room, sizeof *rows->t)) {
    return false;
  }
  if (!next_number(counts, s, &rows->t[rows->n])) {
    return false;
  }
  rows->s[rows->n] = s;
  rows->p[rows->n] = p;
  for (int k = 0; k < 3; k++) {
    rows->v[k][rows->n] = v[k];
  }
  rows->n++;
  return true;
}

bool
sg_complete_add_fault(sg_completion *out, const sg_polygon_fault *fault)
{
  if (!sg_list_grow(&out->fault, out->faults, &out->fault_room,
                    sizeof *out->fault)) {
    return false;
  }
  out->fault[out->faults++] = *fault;
  return true;
}
