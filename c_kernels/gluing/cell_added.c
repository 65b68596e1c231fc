/* cell_added.c -- see cell_added.h. */
#include "cell_added.h"

#include "join/winding.h"
#include "number/vector.h"
#include "rows/disjoint.h"
#include "rows/key_table.h"
#include "solid/coincident_faces.h"
#include "solid/solid_border.h"
#include "solid/whole_contacts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { OF_CELLS = 1, OF_SOLID = 2 };

typedef struct adding {
  sg_solid *both;
  size_t near;
  bool *shared;          /* [near] a face of the solid lies on it */
  bool *turned;          /* [near] the other way round */
  uint8_t *border;       /* [triangles] */
  uint8_t *whose;        /* [vertices] OF_CELLS, OF_SOLID */
  uint32_t *part;        /* [vertices] of what is shared, disjoint sets */
  uint32_t *face;        /* [faces] of the solid alone, disjoint sets */
  sg_key_table of_cells; /* edges */
  sg_key_table edges;    /* of the solid: an index of `edge` */
  struct edge {
    uint32_t v[2], face[2];
    unsigned pages; /* of the solid */
  } * edge;
  size_t n;
} adding;

static bool
is_of_solid(const adding *a, size_t f)
{
  return f >= a->near || a->shared[f];
}

/* ---- edges -------------------------------------------------------------- */

static void
edge_key(const uint32_t v[3], int k, uint32_t key[2])
{
  uint32_t from = v[k], to = v[(k + 1) % 3];

  key[0] = from < to ? from : to;
  key[1] = from ^ to ^ key[0];
}

/* A page of the solid at an edge. False: no memory. */
static bool
add_page(adding *a, const uint32_t key[2], uint32_t f)
{
  uint32_t *at = sg_key_table_put(&a->edges, key);

  if (at && *at == SG_NO_KEY) {
    *at = (uint32_t)a->n;
    a->edge[a->n++] = (struct edge){{key[0], key[1]}, {f, f}, 0};
  }
  if (at) {
    struct edge *edge = &a->edge[*at];

    edge->face[edge->pages < 2 ? edge->pages : 1] = f;
    edge->pages++;
  }
  return at != NULL;
}

/* Whether a face has one loop: that is so if its triangles are two fewer than
 * its edges. */
static bool
take_face(adding *a, size_t f, sg_border *scratch, bool *simple)
{
  const sg_solid_face *face = &a->both->face[f];
  uint32_t edges;
  bool good = sg_border_find(scratch, a->both, f, a->border, &edges);

  *simple = good && edges == face->n + 2;
  for (uint32_t t = face->first; good && t < face->first + face->n; t++) {
    const uint32_t *v = a->both->triangle[t];

    for (int k = 0; good && k < 3; k++) {
      uint32_t key[2];

      edge_key(v, k, key);
      a->whose[v[k]] |=
          (f < a->near ? OF_CELLS : 0) | (is_of_solid(a, f) ? OF_SOLID : 0);
      if (a->border[t] >> k & 1) {
        good = (f >= a->near || sg_key_table_add(&a->of_cells, key)) &&
               (!is_of_solid(a, f) || add_page(a, key, (uint32_t)f));
      }
    }
  }
  return good;
}

/* *simple: of the faces of the solid. */
static bool
take_faces(adding *a, bool *simple)
{
  sg_border scratch = {0};
  bool good = true, one;

  *simple = true;
  for (size_t f = 0; good && f < a->both->faces; f++) {
    good = take_face(a, f, &scratch, &one);
    *simple = *simple && (one || !is_of_solid(a, f));
  }
  sg_border_clear(&scratch);
  return good;
}

/* ---- what is shared, and what is left ----------------------------------- */

typedef struct counts {
  long vertices, edges, faces;                      /* of the solid */
  long shared_vertices, shared_edges, shared_faces; /* with the cells */
  long shared_parts, rest_parts;
  bool manifold; /* two pages at each edge */
} counts;

static void
count_edges(adding *a, counts *n)
{
  for (size_t i = 0; i < a->n; i++) {
    const struct edge *edge = &a->edge[i];
    bool shared = sg_key_table_get(&a->of_cells, edge->v) != SG_NO_KEY;

    n->edges++;
    n->shared_edges += shared;
    n->manifold = n->manifold && edge->pages == 2;
    if (shared) {
      sg_disjoint_join(a->part, edge->v[0], edge->v[1]);
    } else {
      sg_disjoint_join(a->face, edge->face[0], edge->face[1]);
    }
  }
}

static counts
count(adding *a)
{
  counts n = {.manifold = true};

  for (uint32_t v = 0; v < a->both->vertices; v++) {
    a->part[v] = v;
  }
  for (uint32_t f = 0; f < a->both->faces; f++) {
    a->face[f] = f;
  }
  count_edges(a, &n);
  for (uint32_t v = 0; v < a->both->vertices; v++) {
    bool shared = a->whose[v] == (OF_CELLS | OF_SOLID);

    n.vertices += (a->whose[v] & OF_SOLID) != 0;
    n.shared_vertices += shared;
    n.shared_parts += shared && a->part[v] == v;
  }
  for (uint32_t f = 0; f < a->both->faces; f++) {
    n.faces += is_of_solid(a, f);
    n.shared_faces += f < a->near && a->shared[f];
    n.rest_parts += f >= a->near && a->face[f] == f;
  }
  return n;
}

/* ---- inside ------------------------------------------------------------- */

/* A corner of triangle t of the solid, as it runs there. */
static const double *
corner(const adding *a, size_t f, uint32_t t, int k)
{
  bool turned = f < a->near && a->turned[f];

  return a->both->vertex[a->both->triangle[t][turned ? 2 - k : k]].at;
}

/* Its volume is plainly positive. */
static bool
is_outside_out(const adding *a)
{
  const double *o = NULL;
  double sum = 0, size = 0;

  for (size_t f = 0; f < a->both->faces; f++) {
    const sg_solid_face *face = &a->both->face[f];

    for (uint32_t t = face->first;
         is_of_solid(a, f) && t < face->first + face->n; t++) {
      double r[3][3], n[3];

      o = o ? o : corner(a, f, t, 0);
      for (int k = 0; k < 3; k++) {
        sg_minus(corner(a, f, t, k), o, r[k]);
      }
      sg_cross(r[1], r[2], n);
      sum += sg_dot(r[0], n);
      size += sqrt(sg_dot(r[0], r[0]) * sg_dot(n, n));
    }
  }
  return sum > 0x1p-20 * size;
}

/* How often the solid goes round a vertex that is not on it. */
static int
turns_round(const adding *a, uint32_t v)
{
  sg_point p, at[3];
  int turns = 0;

  sg_point_set(&p, a->both->vertex[v].at);
  for (size_t f = 0; f < a->both->faces; f++) {
    const sg_solid_face *face = &a->both->face[f];

    for (uint32_t t = face->first;
         is_of_solid(a, f) && t < face->first + face->n; t++) {
      for (int k = 0; k < 3; k++) {
        sg_point_set(&at[k], corner(a, f, t, k));
      }
      turns += sg_winding_of(&at[0], &at[1], &at[2], &p);
      for (int k = 0; k < 3; k++) {
        sg_point_clear(&at[k]);
      }
    }
  }
  sg_point_clear(&p);
  return turns;
}

static void
find_box(const adding *a, double low[3], double high[3])
{
  for (int k = 0; k < 3; k++) {
    low[k] = INFINITY;
    high[k] = -INFINITY;
  }
  for (size_t v = 0; v < a->both->vertices; v++) {
    for (int k = 0; (a->whose[v] & OF_SOLID) && k < 3; k++) {
      low[k] = fmin(low[k], a->both->vertex[v].at[k]);
      high[k] = fmax(high[k], a->both->vertex[v].at[k]);
    }
  }
}

/* A face that meets the solid in equal features alone is all outside if a
 * vertex is that is not on it. False too: all are. */
static bool
is_outside(const adding *a, size_t f, const double low[3], const double high[3])
{
  const sg_solid_face *face = &a->both->face[f];
  uint32_t lone = SG_NO_KEY;

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int k = 0; k < 3; k++) {
      uint32_t v = a->both->triangle[t][k];
      const double *at = a->both->vertex[v].at;

      for (int i = 0; i < 3; i++) {
        if (at[i] < low[i] || at[i] > high[i]) {
          return true;
        }
      }
      lone = a->whose[v] & OF_SOLID ? lone : v;
    }
  }
  return lone != SG_NO_KEY && turns_round(a, lone) == 0;
}

static bool
nothing_inside(const adding *a)
{
  double low[3], high[3];

  find_box(a, low, high);
  for (size_t f = 0; f < a->near; f++) {
    if (!a->shared[f] && !is_outside(a, f, low, high)) {
      return false;
    }
  }
  return true;
}

/* ---- together ----------------------------------------------------------- */

static bool
make_room(adding *a)
{
  const sg_solid *both = a->both;

  a->border = calloc(both->triangles + 1, sizeof *a->border);
  a->whose = calloc(both->vertices + 1, sizeof *a->whose);
  a->part = malloc((both->vertices + 1) * sizeof *a->part);
  a->face = malloc((both->faces + 1) * sizeof *a->face);
  a->shared = calloc(a->near + 1, sizeof *a->shared);
  a->turned = calloc(a->near + 1, sizeof *a->turned);
  a->edge = malloc((3 * both->triangles + 1) * sizeof *a->edge);
  return a->border && a->whose && a->part && a->face && a->shared &&
         a->turned && a->edge;
}

static void
clear(adding *a)
{
  free(a->border);
  free(a->whose);
  free(a->part);
  free(a->face);
  free(a->shared);
  free(a->turned);
  free(a->edge);
  sg_key_table_clear(&a->of_cells);
  sg_key_table_clear(&a->edges);
}

static sg_cell_added_how
what_it_is(adding *a)
{
  counts n = count(a);
  long left = 1 + n.shared_parts -
              (n.shared_vertices - n.shared_edges + n.shared_faces);

  if (!n.manifold || n.vertices - n.edges + n.faces != 2 ||
      !is_outside_out(a) || !nothing_inside(a)) {
    return SG_CELL_NOT;
  }
  if (n.shared_faces == n.faces) {
    return SG_CELL_FILLS;
  }
  return n.rest_parts == 1 && left == 1 ? SG_CELL_MORE : SG_CELL_NOT;
}

static bool
look(adding *a, sg_cell_added_how *how)
{
  bool simple;

  if (!make_room(a)) {
    return false;
  }
  for (size_t i = 0; i < a->both->parts; i++) {
    a->shared[a->both->part[i].face] = true;
    a->turned[a->both->part[i].face] = a->both->part[i].reversed;
  }
  if (!take_faces(a, &simple)) {
    return false;
  }
  *how = simple ? what_it_is(a) : SG_CELL_NOT;
  return true;
}

bool
sg_cell_added(sg_solid *both, size_t near, int32_t s, double reach,
              sg_pool *pool, const sg_cancel *cancel, sg_cell_added_how *how)
{
  adding a = {.both = both, .near = near};
  size_t doubles;
  bool whole = false, alone = true;

  *how = SG_CELL_NOT;
  if (!sg_coincident_faces(both, reach, cancel, &doubles) ||
      !sg_whole_contacts(both, &s, 1, reach, pool, cancel, &whole)) {
    return false;
  }
  for (size_t i = 0; i < both->parts; i++) {
    alone = alone && both->part[i].s == s && both->part[i].face < near;
  }
  if (!whole || !alone) {
    return true;
  }
  sg_key_table_init(&a.of_cells, 2);
  sg_key_table_init(&a.edges, 2);
  bool good = look(&a, how);

  clear(&a);
  return good;
}
