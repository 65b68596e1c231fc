/* line_cells.c -- see line_cells.h */
#include "line_cells.h"

#include "hide_search_private.h"
#include "number/bounds.h"

#include <float.h>
#include <string.h>

static sg_grid_box
box_of_lines(const sg_scene *scene)
{
  sg_grid_box box = {{DBL_MAX, DBL_MAX}, {-DBL_MAX, -DBL_MAX}};

  for (size_t i = 0; i < scene->lines; i++) {
    const double *a = scene->at[scene->line[i].a];
    const double *b = scene->at[scene->line[i].b];
    for (int k = 0; k < 2; k++) {
      box.low[k] = sg_smaller(box.low[k], sg_smaller(a[k], b[k]));
      box.high[k] = sg_larger(box.high[k], sg_larger(a[k], b[k]));
    }
  }
  return scene->lines > 0 ? box : (sg_grid_box){{0, 0}, {0, 0}};
}

static void
enter_line(sg_line_cells *cells, const double a[3], const double b[3])
{
  sg_grid_shape shape;

  sg_line_shape(a, b, &shape);
  sg_grid_rows rows = sg_grid_rows_of(&cells->grid, &shape);

  for (unsigned y = rows.y0; y < rows.y1; y++) {
    sg_grid_columns columns = sg_grid_row(&cells->grid, &shape, rows, y);
    for (unsigned x = columns.x0; x < columns.x1; x++) {
      cells->has[y][x] = 1;
    }
  }
}

void
sg_line_cells_init(sg_line_cells *cells, const sg_scene *scene)
{
  sg_grid_box box = box_of_lines(scene);

  cells->grid =
      sg_grid_empty(&box, SG_LINE_CELLS_A_SIDE, SG_REACH * scene->close);
  memset(cells->has, 0, sizeof cells->has);
  for (size_t i = 0; i < scene->lines; i++) {
    enter_line(cells, scene->at[scene->line[i].a], scene->at[scene->line[i].b]);
  }
}

bool
sg_line_cells_near(const sg_line_cells *cells, const sg_grid_box *box)
{
  sg_grid_rows rows = sg_grid_rows_of_box(&cells->grid, box);

  for (unsigned y = rows.y0; y < rows.y1; y++) {
    if (memchr(&cells->has[y][rows.x0], 1, rows.x1 - rows.x0)) {
      return true;
    }
  }
  return false;
}
