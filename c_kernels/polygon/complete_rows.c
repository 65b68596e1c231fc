/* complete_rows.c -- the rows that a completion writes: see complete_private.h.
 */
#include "complete_private.h"

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

void *
sg_complete_grown(void *column, size_t room, size_t size, bool *done)
{
  void *more = realloc(column, room * size);

  if (!more) {
    *done = false;
    return column;
  }
  return more;
}

bool
sg_complete_add_plane(sg_plane_rows *rows, int32_t s, int32_t p,
                      const sg_plane *plane)
{
  if (rows->n == rows->room) {
    size_t room = rows->room ? rows->room * 2 : 256;
    bool done = true;
    rows->s = sg_complete_grown(rows->s, room, sizeof *rows->s, &done);
    rows->p = sg_complete_grown(rows->p, room, sizeof *rows->p, &done);
    for (int k = 0; k < 4; k++) {
      rows->c[k] =
          sg_complete_grown(rows->c[k], room, sizeof *rows->c[k], &done);
    }
    if (!done) {
      return false;
    }
    rows->room = room;
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
  if (rows->n == rows->room) {
    size_t room = rows->room ? rows->room * 2 : 256;
    bool done = true;
    rows->s = sg_complete_grown(rows->s, room, sizeof *rows->s, &done);
    rows->p = sg_complete_grown(rows->p, room, sizeof *rows->p, &done);
    rows->t = sg_complete_grown(rows->t, room, sizeof *rows->t, &done);
    for (int k = 0; k < 3; k++) {
      rows->v[k] =
          sg_complete_grown(rows->v[k], room, sizeof *rows->v[k], &done);
    }
    if (!done) {
      return false;
    }
    rows->room = room;
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
  if (out->faults == out->fault_room) {
    size_t room = out->fault_room ? out->fault_room * 2 : 16;
    bool done = true;
    out->fault = sg_complete_grown(out->fault, room, sizeof *out->fault, &done);
    if (!done) {
      return false;
    }
    out->fault_room = room;
  }
  out->fault[out->faults++] = *fault;
  return true;
}
