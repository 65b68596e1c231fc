/* solid_seams.c -- see solid_seams.h. */
#include "solid_seams.h"

#include "engine/list.h"
#include "engine/search.h"
#include "rows/key_table.h"

#include <stdlib.h>

enum { ASKED = 4096, /* faces between questions */ SEVERAL = 0x7ffffffe };

/* ---- seams -------------------------------------------------------------- */

static void
edge_key(const uint32_t v[3], int k, uint32_t key[2])
{
  uint32_t a = v[k], b = v[(k + 1) % 3];

  key[0] = a < b ? a : b;
  key[1] = a < b ? b : a;
}

/* Which face has an edge; SEVERAL. */
static bool
note_edges(const sg_solid *solid, uint32_t f, sg_key_table *edges)
{
  const sg_solid_face *face = &solid->face[f];

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int k = 0; k < 3; k++) {
      uint32_t key[2];

      edge_key(solid->triangle[t], k, key);
      uint32_t *of = sg_key_table_put(edges, key);

      if (!of) {
        return false;
      }
      *of = *of == SG_NO_KEY || *of == f ? f : SEVERAL;
    }
  }
  return true;
}

/* The chords of a face that others have; *edges: of the face. */
static void
open_chords(const sg_solid_rows *rows, uint32_t f, const sg_key_table *table,
            uint32_t *edges)
{
  const sg_solid *solid = rows->solid;
  const sg_solid_face *face = &solid->face[f];

  *edges = 0;
  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int k = 0; k < 3; k++) {
      uint32_t key[2];

      edge_key(solid->triangle[t], k, key);
      if (sg_key_table_get(table, key) == SEVERAL) {
        rows->border[t] |= (uint8_t)(1 << k);
      }
    }
    *edges += (uint32_t)__builtin_popcount(rows->border[t]);
  }
}

bool
sg_solid_rows_seams(sg_solid_rows *rows, const sg_cancel *cancel)
{
  const sg_solid *solid = rows->solid;
  sg_key_table table;
  uint64_t sum = 0;
  bool good;

  sg_key_table_init(&table, 2);
  good = sg_key_table_reserve(&table, solid->triangles * 3 / 2);
  for (uint32_t f = 0; good && f < solid->faces; f++) {
    good = note_edges(solid, f, &table) &&
           !(f % ASKED == ASKED - 1 && sg_cancelled(cancel));
  }
  for (uint32_t f = 0; good && f < solid->faces; f++) {
    uint32_t edges;

    open_chords(rows, f, &table, &edges);
    sum += edges;
    rows->edge[f + 1] = (uint32_t)sum;
    good = sum < INT32_MAX && !(f % ASKED == ASKED - 1 && sg_cancelled(cancel));
  }
  sg_key_table_clear(&table);
  return good;
}

/* ---- points ------------------------------------------------------------- */

typedef struct pointer {
  const sg_solid_rows *rows;
  uint32_t *seen; /* [vertices]: face + 1 that has an edge there, or was told */
  sg_face_point *list;
  size_t n, room;
} pointer;

static void
mark_border(const pointer *p, uint32_t f)
{
  const sg_solid *solid = p->rows->solid;
  const sg_solid_face *face = &solid->face[f];

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int k = 0; k < 3; k++) {
      if (p->rows->border[t] >> k & 1) {
        p->seen[solid->triangle[t][k]] = f + 1;
        p->seen[solid->triangle[t][(k + 1) % 3]] = f + 1;
      }
    }
  }
}

SG_ORDER(by_vertex, sg_face_point, SG_BY(v));

static bool
add_points(pointer *p, uint32_t f)
{
  const sg_solid *solid = p->rows->solid;
  const sg_solid_face *face = &solid->face[f];
  size_t from = p->n;

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int k = 0; k < 3; k++) {
      uint32_t v = solid->triangle[t][k];

      if (p->seen[v] == f + 1) {
        continue;
      }
      if (!sg_list_grow(&p->list, p->n, &p->room, sizeof *p->list)) {
        return false;
      }
      p->seen[v] = f + 1;
      p->list[p->n++] = (sg_face_point){p->rows->id[v], f};
    }
  }
  if (p->n > from + 1) {
    qsort(p->list + from, p->n - from, sizeof *p->list, by_vertex);
  }
  return true;
}

bool
sg_solid_rows_points(const sg_solid_rows *rows, const sg_cancel *cancel,
                     sg_face_point **out, size_t *n)
{
  const sg_solid *solid = rows->solid;
  pointer p = {.rows = rows,
               .seen = calloc(solid->vertices + 1, sizeof *p.seen)};
  bool good = p.seen != NULL;

  for (uint32_t f = 0; good && f < solid->faces; f++) {
    mark_border(&p, f);
    good =
        add_points(&p, f) && !(f % ASKED == ASKED - 1 && sg_cancelled(cancel));
  }
  free(p.seen);
  if (!good) {
    free(p.list);
    return false;
  }
  *out = p.list;
  *n = p.n;
  return true;
}
