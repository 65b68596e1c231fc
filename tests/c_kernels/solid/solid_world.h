/* solid_world.h -- the rows of a solid on pages, as a store has them, for
 * tests.
 */
#ifndef SOLID_WORLD_H
#define SOLID_WORLD_H

#include "solid/solid_over.h"
#include "solid_shape.h"
#include "tests/check.h"

enum { S = 9, LENGTH = 6 };

/* Columns: integers, floats, lists or terms. */
static const char *const type[SG_OLD_RELATIONS] = {
    [SG_OLD_V] = "iifff",      [SG_OLD_E] = "iiiii",   [SG_OLD_P] = "iil",
    [SG_OLD_PLANE] = "iiffff", [SG_OLD_T] = "iiiiii",  [SG_OLD_FROM_V] = "iiii",
    [SG_OLD_FROM_P] = "iiiii", [SG_OLD_ORIGIN] = "ill"};

/* The rows of one relation, on one page. */
typedef struct table {
  size_t n;
  double cell[SG_MAX_COLUMNS][SG_PAGE_ROWS]; /* of any type */
  uint64_t live[SG_LIVE_WORDS];
  const uint64_t *page_live;
  sg_cells page[SG_MAX_COLUMNS];
  sg_view view;
} table;

typedef struct world {
  table of[SG_OLD_RELATIONS];
  int32_t list[2 * SG_PAGE_ROWS];
  uint32_t item[SG_PAGE_ROWS][2];
} world;

static int32_t *
ints(table *t, int column)
{
  return (void *)t->cell[column];
}

static void
open_table(world *w, int relation, size_t n)
{
  table *t = &w->of[relation];

  memset(t->live, 0, sizeof t->live);
  for (size_t i = 0; i < n; i++) {
    t->live[i / 64] |= (uint64_t)1 << (i % 64);
  }
  t->n = n;
  t->page_live = t->live;
  t->view = (sg_view){.pages = 1, .live = &t->page_live};
  for (int c = 0; type[relation][c]; c++) {
    t->page[c].f = t->cell[c];
    t->view.column[c].page = &t->page[c];
  }
}

static void
drop_row(world *w, int relation, size_t i)
{
  w->of[relation].live[i / 64] &= ~((uint64_t)1 << (i % 64));
}

/* The lists of p, with their lengths. */
static void
open_lists(world *w, const sg_solid_rows *rows)
{
  int32_t **list = (void *)w->of[SG_OLD_P].cell[2];

  for (size_t f = 0; f < rows->solid->faces; f++) {
    list[f] = w->list + f + rows->edge[f];
    list[f][0] = (int32_t)(rows->edge[f + 1] - rows->edge[f]);
  }
}

static void
write_origins(world *w, const sg_solid_rows *rows)
{
  table *t = &w->of[SG_OLD_ORIGIN];
  const uint32_t **item = (void *)t->cell[1], **origin = (void *)t->cell[2];

  for (size_t i = rows->plain; i < rows->vertices; i++) {
    size_t at = i - rows->plain;
    w->item[at][1] = (uint32_t)i + 1;
    ints(t, 0)[at] = S;
    item[at] = w->item[at];
    origin[at] = rows->solid->origin[rows->vertex[i] - rows->solid->plain];
  }
}

static int32_t
item_vertex(const uint32_t *item)
{
  return (int32_t)item[1];
}

/* The rows that the solid becomes in segment S. */
static void
write_world(const sg_solid *solid, world *w)
{
  sg_solid_rows rows;
  sg_sheet sheet[SG_OLD_RELATIONS];
  sg_sheet_page page[SG_OLD_RELATIONS];
  bool good = sg_solid_rows_make(solid, NULL, NULL, &rows);
  const size_t n[SG_OLD_RELATIONS] = {rows.vertices,
                                      rows.edge[solid->faces],
                                      solid->faces,
                                      solid->faces,
                                      solid->triangles,
                                      rows.plain,
                                      solid->faces + solid->parts,
                                      rows.vertices - rows.plain};

  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    open_table(w, k, n[k]);
    page[k] = (sg_sheet_page){.n = n[k]};
    sheet[k] = (sg_sheet){.rows = n[k], .pages = 1, .page = &page[k]};
    for (int c = 0; type[k][c]; c++) {
      page[k].column[c].f = w->of[k].cell[c];
    }
  }
  open_lists(w, &rows);
  write_origins(w, &rows);
  good = good && sg_solid_rows_write(
                     &rows, S, NULL, NULL,
                     &(sg_solid_sheets){&sheet[SG_OLD_V], &sheet[SG_OLD_E],
                                        &sheet[SG_OLD_P], &sheet[SG_OLD_PLANE],
                                        &sheet[SG_OLD_T], &sheet[SG_OLD_FROM_V],
                                        &sheet[SG_OLD_FROM_P]},
                     &w->of[SG_OLD_PLANE].n, &w->of[SG_OLD_FROM_P].n);
  for (size_t i = w->of[SG_OLD_FROM_P].n; i < n[SG_OLD_FROM_P]; i++) {
    drop_row(w, SG_OLD_FROM_P, i);
  }
  CHECK("rows", good && w->of[SG_OLD_PLANE].n == solid->faces);
  sg_solid_rows_clear(&rows);
}

static sg_old_end
read_region(const world *w, const int32_t *leaf, size_t n, sg_solid_old *old)
{
  const sg_view *view[SG_OLD_RELATIONS];

  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    view[k] = &w->of[k].view;
  }
  return sg_solid_old_read_region(view, S, leaf, n, item_vertex, NULL, old);
}

#endif
