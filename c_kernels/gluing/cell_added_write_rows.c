/* cell_added_write_rows.c -- what is new of a solid beside cells: see
 * cell_added_rows.h.
 */
#include "cell_added_rows.h"
#include "doors/gluing.h"
#include "engine/search.h"
#include "polygon/plane.h"
#include "rows/sort.h"
#include "solid/solid_border.h"

#include <stdlib.h>
#include <string.h>

/* ---- writing ------------------------------------------------------------ */

bool
sg_cell_table_open(sg_cell_joiner *j, size_t n, int columns, unsigned floats,
                   sg_cell_table *out)
{
  *out = (sg_cell_table){0};
  for (int k = 0; k < columns; k++) {
    if (floats >> k & 1) {
      out->column[k] = out->f[k] = sg_call_alloc(j->call, (n + 1) * 8);
    } else {
      out->column[k] = out->i[k] = sg_call_alloc(j->call, (n + 1) * 4);
    }
    if (!out->column[k]) {
      return false;
    }
  }
  return true;
}

void
sg_cell_table_add(sg_cell_table *to, int n, const int32_t *value)
{
  for (int k = 0; k < n; k++) {
    to->i[k][to->n] = value[k];
  }
  to->n++;
}

bool
sg_cell_table_write(sg_cell_joiner *j, sg_world *world, sg_relation relation,
                    const sg_row *gone, size_t gones, const sg_cell_table *from)
{
  return sg_world_exchange(world, relation, gone, gones, from->n,
                           from->column) ||
         sg_call_no_memory(j->call);
}

/* The number of face f of the solid in the glue: the one it had, or a new one.
 * 0: it had none, or another face has it. */
static int32_t
number_of_face(const sg_cell_joiner *j, size_t f, uint8_t *taken)
{
  int32_t p = j->both.face[f].p;

  if (!j->rest_only) {
    return j->last_p + (int32_t)(f - j->near) + 1;
  }
  size_t at = sg_first_id(j->was, j->was_n, sizeof *j->was, p);

  int32_t is = at < j->was_n && j->was[at].a == p ? j->was[at].b : 0;

  return taken[is]++ ? 0 : is;
}

/* False: no memory, or a face has no number. */
static bool
number_faces(sg_cell_joiner *j)
{
  const sg_solid *both = &j->both;
  size_t numbers = 1;

  for (size_t i = 0; i < j->was_n; i++) {
    size_t b = (size_t)j->was[i].b + 1;

    numbers = b > numbers ? b : numbers;
  }
  uint8_t *taken = sg_call_alloc(j->call, numbers);

  j->polygon = sg_call_alloc(j->call, (both->faces + 1) * sizeof *j->polygon);
  if (!taken || !j->polygon) {
    return false;
  }
  memset(taken, 0, numbers);
  taken[0] = 1;
  for (size_t f = 0; f < both->faces; f++) {
    j->polygon[f] = f < j->near ? both->face[f].p : number_of_face(j, f, taken);
    if (j->polygon[f] == 0) {
      return false;
    }
  }
  return true;
}

/* Numbers what is new, vertices in the order of the solid. */
static bool
number_all(sg_cell_joiner *j)
{
  const sg_solid *both = &j->both;
  sg_border scratch = {0};
  uint32_t edges;
  bool good;

  j->border = sg_call_alloc(j->call, both->triangles + 1);
  j->id = sg_call_alloc(j->call, (both->vertices + 1) * sizeof *j->id);
  if (!(good = j->border && j->id && number_faces(j))) {
    return false;
  }
  memset(j->id, 0, (both->vertices + 1) * sizeof *j->id);
  for (size_t f = 0; good && f < both->faces; f++) {
    const sg_solid_face *face = &both->face[f];

    for (uint32_t t = face->first; f >= j->near && t < face->first + face->n;
         t++) {
      for (int c = 0; c < 3; c++) {
        j->id[both->triangle[t][c]] = 1;
      }
    }
    good = sg_border_find(&scratch, both, f, j->border, &edges);
  }
  sg_border_clear(&scratch);
  for (size_t v = 0, n = 0; v < both->vertices; v++) {
    j->id[v] = v < j->known ? both->vertex[v].v
               : j->id[v]   ? j->last_v + (int32_t)++n
                            : 0;
  }
  return good || sg_call_no_memory(j->call);
}

static bool
write_vertices(sg_cell_joiner *j, sg_world *world)
{
  const sg_solid *both = &j->both;
  sg_cell_table v, from;

  if (!sg_cell_table_open(j, both->vertices, 5, 0x1c, &v) ||
      !sg_cell_table_open(j, both->vertices, 4, 0, &from)) {
    return false;
  }
  for (size_t i = j->known; i < both->vertices; i++) {
    const sg_solid_vertex *is = &both->vertex[i];

    if (j->id[i] == 0) {
      continue;
    }
    v.i[0][v.n] = j->s;
    v.i[1][v.n] = j->id[i];
    for (int k = 0; k < 3; k++) {
      v.f[2 + k][v.n] = is->at[k] + 0.0; /* no -0.0 */
    }
    v.n++;
    sg_cell_table_add(&from, 4, (int32_t[]){j->s, j->id[i], is->s, is->v});
  }
  return sg_cell_table_write(j, world, SG_V, NULL, 0, &v) &&
         sg_cell_table_write(j, world, SG_FROM_V, NULL, 0, &from);
}

typedef struct face_tables {
  sg_cell_table e, p, t, plane;
  int32_t **list; /* of p */
} face_tables;

/* The edges of triangle t that end its face. */
static void
add_edges(const sg_cell_joiner *j, uint32_t t, face_tables *to, int32_t *list,
          sg_newell *sum)
{
  const sg_solid *both = &j->both;
  const uint32_t *v = both->triangle[t];

  for (int k = 0; k < 3; k++) {
    uint32_t a = v[k], b = v[(k + 1) % 3];

    if (j->border[t] >> k & 1) {
      int32_t e = j->last_e + (int32_t)to->e.n + 1;

      list[++list[0]] = e;
      sg_cell_table_add(&to->e, 5,
                        (int32_t[]){j->s, e, j->id[a], j->id[b],
                                    !(both->auxiliary[t] >> k & 1)});
      sg_newell_edge(sum, both->vertex[a].at, both->vertex[b].at);
    }
  }
}

static void
add_plane(const sg_cell_joiner *j, int32_t p, const sg_newell *sum,
          sg_cell_table *to)
{
  sg_plane plane;

  if (sg_newell_plane(sum, &plane)) {
    to->i[0][to->n] = j->s;
    to->i[1][to->n] = p;
    for (int k = 0; k < 3; k++) {
      to->f[2 + k][to->n] = plane.n[k];
    }
    to->f[5][to->n++] = plane.d;
  }
}

static bool
add_face(const sg_cell_joiner *j, size_t f, face_tables *to)
{
  const sg_solid *both = &j->both;
  const sg_solid_face *face = &both->face[f];
  int32_t *list = sg_call_alloc(j->call, (3 * face->n + 1) * sizeof *list);
  sg_newell sum;

  if (!list) {
    return false;
  }
  list[0] = 0;
  sg_newell_init(&sum);
  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    const uint32_t *v = both->triangle[t];

    add_edges(j, t, to, list, &sum);
    sg_cell_table_add(&to->t, 6,
                      (int32_t[]){j->s, j->polygon[f],
                                  j->last_t + (int32_t)to->t.n + 1, j->id[v[0]],
                                  j->id[v[1]], j->id[v[2]]});
  }
  if (face->n == 1) {
    const uint32_t *v = both->triangle[face->first];

    sg_newell_init(&sum);
    sg_newell_triangle(&sum, both->vertex[v[0]].at, both->vertex[v[1]].at,
                       both->vertex[v[2]].at);
  }
  to->list[to->p.n] = list;
  sg_cell_table_add(&to->p, 2, (int32_t[]){j->s, j->polygon[f]});
  add_plane(j, j->polygon[f], &sum, &to->plane);
  return true;
}

static bool
write_faces(sg_cell_joiner *j, sg_world *world)
{
  const sg_solid *both = &j->both;
  size_t n = both->faces - j->near;
  face_tables to;
  bool good = sg_cell_table_open(j, 3 * both->triangles, 5, 0, &to.e) &&
              sg_cell_table_open(j, n, 2, 0, &to.p) &&
              sg_cell_table_open(j, both->triangles, 6, 0, &to.t) &&
              sg_cell_table_open(j, n, 6, 0x3c, &to.plane);

  to.list = sg_call_alloc(j->call, (n + 1) * sizeof *to.list);
  to.p.column[2] = to.list;
  good = good && to.list;
  for (size_t f = j->near; good && f < both->faces; f++) {
    good = add_face(j, f, &to);
  }
  return good && sg_cell_table_write(j, world, SG_E, NULL, 0, &to.e) &&
         sg_cell_table_write(j, world, SG_P, NULL, 0, &to.p) &&
         sg_cell_table_write(j, world, SG_PLANE, NULL, 0, &to.plane) &&
         sg_cell_table_write(j, world, SG_T, NULL, 0, &to.t);
}

/* ---- sources ------------------------------------------------------------ */

typedef struct sg_solid_part part;

SG_ORDER(compare_parts, part, SG_BY(face) SG_BY(s) SG_BY(p));

/* What face f of the solid became: a polygon, and turned or not. False: it was
 * there already. */
static bool
find_fate(const sg_cell_joiner *j, size_t f, int32_t *polygon, bool *turned)
{
  const sg_solid *both = &j->both;
  int32_t p = j->solid->face[f].p;

  *turned = false;
  for (size_t i = j->near; i < both->faces; i++) {
    if (both->face[i].p == p) {
      *polygon = j->polygon[i];
      return true;
    }
  }
  for (size_t i = 0; i < both->parts; i++) {
    if (both->part[i].p == p) {
      *polygon = j->polygon[both->part[i].face];
      *turned = both->part[i].reversed;
      break;
    }
  }
  return false;
}

static bool
write_sources(sg_cell_joiner *j, sg_world *world)
{
  const sg_solid *solid = j->solid;
  size_t n = solid->faces + solid->parts;
  part *from = sg_call_alloc(j->call, (n + 1) * sizeof *from);
  sg_cell_table to;

  if (!from || !sg_cell_table_open(j, n, 5, 0, &to)) {
    return false;
  }
  for (uint32_t f = 0; f < solid->faces; f++) {
    const sg_solid_face *face = &solid->face[f];

    from[f] = (part){f, face->s, face->p, face->reversed};
  }
  if (solid->parts > 0) {
    memcpy(from + solid->faces, solid->part, solid->parts * sizeof *from);
  }
  qsort(from, n, sizeof *from, compare_parts);
  for (size_t i = 0; i < n; i++) {
    int32_t polygon = 0;
    bool turned;

    if (i == 0 || compare_parts(&from[i], &from[i - 1]) != 0) {
      if (find_fate(j, from[i].face, &polygon, &turned) || !j->rest_only) {
        sg_cell_table_add(&to, 5,
                          (int32_t[]){j->s, polygon, from[i].s, from[i].p,
                                      from[i].reversed != turned ? -1 : 1});
      }
    }
  }
  return sg_cell_table_write(j, world, SG_FROM_P, NULL, 0, &to);
}

bool
sg_cell_write(sg_cell_joiner *j, sg_world *world)
{
  return number_all(j) && write_vertices(j, world) && write_faces(j, world) &&
         write_sources(j, world);
}
