/* solid_over_region.c -- whether new faces fit among others: see solid_over.h.
 */
#include "solid_over.h"

#include "rows/edge_print.h"
#include "rows/key_table.h"

/* ---- edges -------------------------------------------------------------- */

/* The id of a vertex of the solid, or one that no vertex has. */
static uint32_t
id_of(const sg_solid_old *old, const sg_solid_over *over, uint32_t v)
{
  uint32_t at = over->vertex[v];

  return at == SG_NO_PLACE ? (uint32_t)old->vertex.most + 1 + v
                           : (uint32_t)sg_old_int(old, SG_OLD_V, 1, at);
}

static uint64_t
print_of(uint32_t a, uint32_t b, uint32_t c)
{
  return sg_edge_print(a, b) + sg_edge_print(b, c) + sg_edge_print(c, a);
}

/* The edges of all old triangles are in balance except those that bound them,
 * and so are those of the new ones. */
static bool
same_bounds(const sg_solid *solid, const sg_solid_old *old,
            const sg_solid_over *over, const sg_cancel *cancel)
{
  uint64_t was = 0, is = 0;

  for (uint32_t i = 0; i < sg_old_count(old, SG_OLD_T); i++) {
    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    was += print_of((uint32_t)sg_old_int(old, SG_OLD_T, 3, i),
                    (uint32_t)sg_old_int(old, SG_OLD_T, 4, i),
                    (uint32_t)sg_old_int(old, SG_OLD_T, 5, i));
  }
  for (size_t i = 0; i < solid->triangles; i++) {
    const uint32_t *v = solid->triangle[i];
    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    is += print_of(id_of(old, over, v[0]), id_of(old, over, v[1]),
                   id_of(old, over, v[2]));
  }
  return was == is;
}

/* ---- vertices ----------------------------------------------------------- */

/* The places of new vertices. False: no memory. */
static bool
list_new(const sg_solid_rows *rows, const sg_solid_over *over,
         sg_key_table *table, sg_box *box)
{
  for (size_t i = 0; i < rows->vertices; i++) {
    uint32_t v = rows->vertex[i], key[6];
    const double *at = rows->solid->vertex[v].at;

    if (over->vertex[v] == SG_NO_PLACE) {
      sg_place_key(at, key);
      sg_box_add(box, at);
      if (!sg_key_table_add(table, key)) {
        return false;
      }
    }
  }
  return true;
}

static bool
is_in_box(const sg_box *box, const double at[3])
{
  bool in = true;

  for (int k = 0; k < 3; k++) {
    in = in && at[k] >= box->lo[k] && at[k] <= box->hi[k];
  }
  return in;
}

static bool
is_elsewhere(const double at[3], const sg_key_table *table, const sg_box *box)
{
  uint32_t key[6];

  if (!is_in_box(box, at)) {
    return true;
  }
  sg_place_key(at, key);
  return sg_key_table_get(table, key) == SG_NO_KEY;
}

/* No vertex of the segment beyond the region is in one of these places. */
static bool
others_are_elsewhere(const sg_solid_old *old, const sg_key_table *table,
                     const sg_box *box, const sg_cancel *cancel)
{
  const sg_view *view = old->view[SG_OLD_V];

  for (size_t i = 0; table->n > 0 && i < old->region.rows; i++) {
    uint32_t row = old->region.row[i];
    double at[3];

    for (unsigned k = 0; k < 3; k++) {
      at[k] =
          view->column[2 + k].page[row / SG_PAGE_ROWS].f[row % SG_PAGE_ROWS];
    }
    if (!is_elsewhere(at, table, box) || sg_cancel_every(cancel, i)) {
      return false;
    }
  }
  return true;
}

/* Nor is one of the region that other faces have, and no new face: of another
 * name, say. One that a new face has is not new, so it is none of these. */
static bool
shared_are_elsewhere(const sg_solid_old *old, const sg_key_table *table,
                     const sg_box *box, const sg_cancel *cancel)
{
  for (uint32_t i = 0; table->n > 0 && i < sg_old_count(old, SG_OLD_V); i++) {
    int32_t id = sg_old_int(old, SG_OLD_V, 1, i);
    double at[3];

    for (unsigned k = 0; k < 3; k++) {
      at[k] = sg_old_float(old, SG_OLD_V, 2 + k, i);
    }
    if ((sg_old_is_held(&old->vertex, id) && !is_elsewhere(at, table, box)) ||
        sg_cancel_every(cancel, i)) {
      return false;
    }
  }
  return true;
}

bool
sg_solid_over_fits(const sg_solid_rows *rows, const sg_solid_old *old,
                   const sg_solid_over *over, const sg_cancel *cancel)
{
  sg_key_table table;
  sg_box box = sg_box_none();

  sg_key_table_init(&table, 6);
  bool fits = same_bounds(rows->solid, old, over, cancel) &&
              list_new(rows, over, &table, &box) &&
              others_are_elsewhere(old, &table, &box, cancel) &&
              shared_are_elsewhere(old, &table, &box, cancel);

  sg_key_table_clear(&table);
  return fits;
}
