/* mesh_rows.c -- the rows of a part of a mesh: see mesh_rows.h. */
#include "mesh_rows.h"

/* The segment, and ids that go on from the page's first row. */
static void
number_rows(int32_t s, const sg_sheet_page *page)
{
  for (size_t i = 0; i < page->n; i++) {
    page->column[0].i[i] = s;
    page->column[1].i[i] = (int32_t)(page->from + i) + 1;
  }
}

void
sg_mesh_rows_vertices(const sg_mesh *mesh, const sg_mesh_part *part, int32_t s,
                      const sg_sheet_page *page)
{
  number_rows(s, page);
  for (size_t i = 0; i < page->n; i++) {
    const double *p = mesh->vertex[part->vertex[page->from + i]];
    for (int k = 0; k < 3; k++) {
      page->column[2 + k].f[i] = p[k] + 0.0; /* no -0.0 */
    }
  }
}

void
sg_mesh_rows_edges(const sg_mesh_part *part, int32_t s,
                   const sg_sheet_page *page)
{
  number_rows(s, page);
  for (size_t i = 0; i < page->n; i++) {
    page->column[2].i[i] = part->from[page->from + i] + 1;
    page->column[3].i[i] = part->to[page->from + i] + 1;
    page->column[4].i[i] = 1;
  }
}

void
sg_mesh_rows_lengths(const sg_mesh_part *part, const sg_sheet_page *page,
                     int32_t *length)
{
  const uint32_t *start = part->start + page->from;

  for (size_t i = 0; i < page->n; i++) {
    length[i] = (int32_t)(start[i + 1] - start[i]);
  }
}

void
sg_mesh_rows_polygons(const sg_mesh_part *part, int32_t s,
                      const sg_sheet_page *page)
{
  number_rows(s, page);
  for (size_t i = 0; i < page->n; i++) {
    const uint32_t *start = part->start + page->from + i;
    int32_t *list = page->column[2].list[i];
    list[0] = (int32_t)(start[1] - start[0]);
    for (int32_t k = 1; k <= list[0]; k++) {
      list[k] = (int32_t)start[0] + k;
    }
  }
}
