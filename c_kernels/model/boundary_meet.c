/* boundary_meet.c -- where a boundary_mesh goes through itself. */
#include "boundary_mesh.h"
#include "rows/key_table.h"

#include <math.h>
#include <stdlib.h>

/* A mesh as a segment: some arrays stay the mesh's, the others are here. */
typedef struct as_segment {
  sg_dense dense;
  double grain;
  uint32_t begin[4][2];
  int32_t *ids, *places, *to;
} as_segment;

static bool
open_segment(const sg_boundary_mesh *m, as_segment *s)
{
  const sg_mesh_lists *face = &m->mesh.face;

  *s = (as_segment){.ids = malloc((face->count + 1) * sizeof *s->ids),
                    .places = malloc((face->corners + 1) * sizeof *s->places),
                    .to = malloc((face->corners + 1) * sizeof *s->to)};
  if (!s->ids || !s->places || !s->to) {
    return false;
  }
  for (size_t f = 0; f < face->count; f++) {
    for (uint32_t i = face->start[f]; i < face->start[f + 1]; i++) {
      uint32_t next = i + 1 < face->start[f + 1] ? i + 1 : face->start[f];
      s->to[i] = face->corner[next];
      s->places[i] = (int32_t)i;
    }
    s->ids[f] = (int32_t)f + 1;
  }
  s->begin[0][1] = (uint32_t)m->mesh.vertices;
  s->begin[1][1] = (uint32_t)face->corners;
  s->begin[2][1] = (uint32_t)face->count;
  s->begin[3][1] = (uint32_t)m->triangles;
  s->grain = m->mesh.grain;
  s->dense = (sg_dense){.segments = 1,
                        .grain = &s->grain,
                        .vertex_begin = s->begin[0],
                        .edge_begin = s->begin[1],
                        .polygon_begin = s->begin[2],
                        .triangle_begin = s->begin[3],
                        .vertices = m->mesh.vertices,
                        .at = m->mesh.vertex,
                        .edges = face->corners,
                        .from = face->corner,
                        .to = s->to,
                        .polygons = face->count,
                        .polygon_id = s->ids,
                        .list_begin = face->start,
                        .list = s->places,
                        .triangles = m->triangles,
                        .polygon_of = m->face_of,
                        .corner = m->triangle};
  return true;
}

static void
close_segment(as_segment *s)
{
  free(s->ids);
  free(s->places);
  free(s->to);
}

bool
sg_boundary_mesh_meetings(const sg_boundary_mesh *mesh, bool all, sg_pool *pool,
                          const sg_cancel *cancel, sg_self_meetings *out)
{
  as_segment s;
  bool done = open_segment(mesh, &s);

  *out = (sg_self_meetings){0};
  if (done && mesh->mesh.face.count > 0) {
    done = all ? sg_self_cut(&s.dense, 0, 0, pool, cancel, out)
               : sg_self_cut_changed(&s.dense, 0, mesh->changed, false, 0, pool,
                                     cancel, out);
  }
  close_segment(&s);
  return done;
}

/* Marks the vertices of triangles that go through each other, and of edges
 * along which they do. */
static bool
find_coarse(const sg_boundary_mesh *mesh, sg_pool *pool,
            const sg_cancel *cancel, unsigned char *coarse)
{
  sg_self_meetings met;

  if (!sg_boundary_mesh_meetings(mesh, true, pool, cancel, &met)) {
    return false;
  }
  for (size_t v = 0; mesh->crossed && v < mesh->mesh.vertices; v++) {
    coarse[v] = mesh->crossed[v];
  }
  for (size_t i = 0; i < met.n; i++) {
    for (int k = 0; k < 6 && met.item[i].kind != SG_SELF_TOUCHING; k++) {
      coarse[mesh->triangle[met.item[i].t[k / 3]][k % 3]] = 1;
    }
  }
  free(met.item);
  return true;
}

/* The cell of the grid that a place is in, moved by dx, dy, dz cells. */
static void
cell_key(const double at[3], double grid, const int move[3],
         uint32_t key[SG_KEY_WORDS])
{
  for (int k = 0; k < 3; k++) {
    uint64_t i = (uint64_t)((int64_t)nearbyint(at[k] / grid) + move[k]);
    key[2 * k] = (uint32_t)i;
    key[2 * k + 1] = (uint32_t)(i >> 32);
  }
}

/* Puts the cell of a place and the 26 around it into cells. */
static bool
put_cells(sg_key_table *cells, const double at[3], double grid)
{
  for (int i = 0; i < 27; i++) {
    uint32_t key[SG_KEY_WORDS], *number;

    cell_key(at, grid, (int[3]){i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1}, key);
    if (!(number = sg_key_table_put(cells, key))) {
      return false;
    }
    *number = 0;
  }
  return true;
}

/* Marks also what is in the same cell of the grid as a marked vertex, or in one
 * next to it: between places on the grid and places near them that are not,
 * faces would be thinner than the grid again. */
static bool
spread_coarse(const sg_boundary_mesh *mesh, double grid, unsigned char *coarse)
{
  const double(*at)[3] = (const double(*)[3])mesh->mesh.vertex;
  size_t n = mesh->mesh.vertices;
  sg_key_table cells;
  bool done = true;

  sg_key_table_init(&cells, SG_KEY_WORDS);
  for (size_t v = 0; v < n && done; v++) {
    done = !coarse[v] || put_cells(&cells, at[v], grid);
  }
  for (size_t v = 0; v < n && done && cells.n > 0; v++) {
    uint32_t key[SG_KEY_WORDS];

    cell_key(at[v], grid, (int[3]){0, 0, 0}, key);
    coarse[v] = sg_key_table_get(&cells, key) != SG_NO_KEY;
  }
  sg_key_table_clear(&cells);
  return done;
}

static sg_boundary_end
coarsen(const sg_boundary_source *source, const sg_rounding *rounding,
        const sg_form *form, bool turned, const sg_cancel *cancel,
        sg_boundary_mesh *out)
{
  sg_boundary boundary;
  sg_boundary_end end = sg_boundary_make(source, rounding, cancel, &boundary);

  if (end == SG_BOUNDARY_DONE) {
    end = sg_boundary_drop_flat(&boundary, turned)
              ? sg_boundary_mesh_make(&boundary, form, cancel, out)
              : SG_BOUNDARY_NO_MEMORY;
  }
  sg_boundary_clear(&boundary);
  return end;
}

/* Faces that were turned over go, unless that leaves some that cannot be
 * divided. */
sg_boundary_end
sg_boundary_mesh_coarsen(const sg_boundary_mesh *mesh,
                         const sg_rounding *rounding, const sg_form *form,
                         sg_pool *pool, const sg_cancel *cancel,
                         sg_boundary_mesh *out)
{
  unsigned char *coarse = calloc(mesh->mesh.vertices + 1, 1);
  as_segment s = {.ids = NULL};
  sg_boundary_end end = SG_BOUNDARY_NO_MEMORY;

  *out = (sg_boundary_mesh){0};
  if (mesh->mesh.face.count == 0) {
    free(coarse);
    return SG_BOUNDARY_DONE;
  }
  if (coarse && open_segment(mesh, &s) &&
      find_coarse(mesh, pool, cancel, coarse) &&
      (rounding->grid == 0 || spread_coarse(mesh, rounding->grid, coarse))) {
    sg_boundary_source source = {.dense = &s.dense, .coarse = coarse};
    end = coarsen(&source, rounding, form, true, cancel, out);
    if (end == SG_BOUNDARY_DONE && (out->stuck > 0 || out->open > 0)) {
      sg_boundary_mesh_clear(out);
      end = coarsen(&source, rounding, form, false, cancel, out);
    }
  }
  close_segment(&s);
  free(coarse);
  return end;
}
