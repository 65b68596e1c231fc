/* operand_border4pl.c -- where the boundary of a result turns from one operand
 * to another (documented in kernel.pl).
 *
 * Layer: glue.
 */
#include "glue.h"
#include "mesh4pl.h"
#include "operand_border.h"
#include "segment_rows.h"

#include "../engine/install.h"
#include "../engine/world4pl.h"

#include <stdlib.h>

static int32_t
cell(const sg_view *view, uint32_t row, int column)
{
  return view->column[column].page[row / SG_PAGE_ROWS].i[row % SG_PAGE_ROWS];
}

/* The place of a polygon; SIZE_MAX: there is none. */
static size_t
place_of(const sg_dense *d, int32_t p)
{
  size_t low = 0, high = d->polygons;

  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (d->polygon_id[middle] < p) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < d->polygons && d->polygon_id[low] == p ? low : SIZE_MAX;
}

/* From the n rows of from_p/5 of the segment: begin[polygons + 2], of which the
 * last is free, and operand[n]. */
static void
fill_operands(const sg_dense *d, const sg_view *view, const uint32_t *row,
              size_t n, uint32_t *begin, int32_t *operand)
{
  uint32_t *end = begin + 1;

  for (size_t i = 0; i < n; i++) {
    size_t p = place_of(d, cell(view, row[i], 1));
    end[p == SIZE_MAX ? 0 : p + 1] += p != SIZE_MAX;
  }
  for (size_t p = 0; p < d->polygons; p++) {
    end[p + 1] += end[p];
  }
  for (size_t i = 0; i < n; i++) {
    size_t p = place_of(d, cell(view, row[i], 1));
    if (p != SIZE_MAX) {
      operand[end[p]++] = cell(view, row[i], 2);
    }
  }
}

static int
find_ex(const sg_dense *d, const sg_view *view, const uint32_t *row, size_t n,
        sg_operand_borders *out)
{
  uint32_t *begin = calloc(d->polygons + 2, sizeof *begin);
  int32_t *operand = malloc((n + 1) * sizeof *operand);
  bool stopped = false, done = false;

  if (begin && operand) {
    fill_operands(d, view, row, n, begin, operand);
    done = sg_operand_borders_find(d, &(sg_operands_of){begin, operand},
                                   &sg_prolog_poll, out, &stopped);
  }
  free(begin);
  free(operand);
  return done || (stopped ? FALSE : sg_no_memory());
}

static int
read_ex(int32_t s, sg_operand_borders *out)
{
  sg_world *world = sg_current_world_ex();
  const sg_version *version = world ? sg_world_version(world) : NULL;
  sg_view view = {0};
  sg_segment_rows rows = {0};
  sg_dense dense = {0};
  int done = FALSE;

  if (!version) {
    return FALSE;
  }
  if (!sg_version_view(version, SG_FROM_P, &view)) {
    done = sg_no_memory();
  } else if (!sg_segment_rows_find(&view, &s, 1, &sg_prolog_poll, &rows)) {
    done = PL_exception(0) ? FALSE : sg_no_memory();
  } else {
    done = sg_get_dense_ex(&s, 1, &dense) &&
           find_ex(&dense, &view, rows.row, rows.begin[1], out);
    sg_dense_clear(&dense);
  }
  sg_segment_rows_clear(&rows);
  sg_view_clear(&view);
  sg_version_drop(version);
  return done;
}

/* operand_borders(+S, -Borders) is det. */
static foreign_t
operand_borders(term_t segment, term_t borders)
{
  term_t tail = PL_copy_term_ref(borders), head = PL_new_term_ref();
  sg_operand_borders found = {0};
  int32_t s;

  if (!sg_get_id_ex(segment, &s) || !read_ex(s, &found)) {
    return FALSE;
  }
  int done = TRUE;

  for (size_t i = 0; done && i < found.n; i++) {
    const sg_operand_border *b = &found.item[i];
    done = PL_unify_list(tail, head, tail) &&
           PL_unify_term(head, PL_FUNCTOR_CHARS, "border", 4, PL_INT,
                         b->polygon[0], PL_INT, b->low, PL_INT, b->high, PL_INT,
                         b->polygon[1]);
  }
  free(found.item);
  return done && PL_unify_nil(tail);
}

void
sg_install_operand_border(void)
{
  static const PL_extension doors[] = {
      {"operand_borders", 2, (pl_function_t)operand_borders, 0},
      {NULL, 0, NULL, 0}};

  PL_register_extensions_in_module("sg_kernel", doors);
}
