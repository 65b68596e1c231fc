/* operand_border4pl.c -- where the boundary of a result turns from one operand
 * to another (documented in kernel/boolean.pl).
 *
 * Layer: glue.
 */
#include "glue.h"
#include "operand_border.h"
#include "rows/by_segment.h"
#include "rows/dense4pl.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <stdlib.h>

static int32_t
cell(const sg_view *view, uint32_t row, int column)
{
  return view->column[column].page[row / SG_PAGE_ROWS].i[row % SG_PAGE_ROWS];
}

/* The place of polygon p of segment s (a place); SIZE_MAX: there is none. */
static size_t
place_of(const sg_dense *d, size_t s, int32_t p)
{
  size_t low = d->polygon_begin[s], end = d->polygon_begin[s + 1], high = end;

  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (d->polygon_id[middle] < p) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < end && d->polygon_id[low] == p ? low : SIZE_MAX;
}

/* The rows of from_p/5 of n segments. */
typedef struct from_rows {
  const sg_view *view;
  const int32_t *s; /* [n] ascending */
  size_t n;
  const sg_segment_rows *rows;
} from_rows;

typedef void use_row(void *data, size_t polygon, int32_t operand);

/* Each row whose polygon is there. */
static void
each_row(const sg_dense *d, const from_rows *from, use_row *use, void *data)
{
  size_t place = 0;

  for (size_t k = 0; k < from->n; k++) {
    while (place < d->segments && d->segment[place] < from->s[k]) {
      place++;
    }
    for (size_t i = from->rows->begin[k];
         place < d->segments && d->segment[place] == from->s[k] &&
         i < from->rows->begin[k + 1];
         i++) {
      size_t p = place_of(d, place, cell(from->view, from->rows->row[i], 1));
      if (p != SIZE_MAX) {
        use(data, p, cell(from->view, from->rows->row[i], 2));
      }
    }
  }
}

static void
count_row(void *data, size_t polygon, int32_t operand)
{
  uint32_t *end = data;

  (void)operand;
  end[polygon + 1]++;
}

typedef struct filling {
  uint32_t *end; /* [polygons] */
  int32_t *operand;
} filling;

static void
fill_row(void *data, size_t polygon, int32_t operand)
{
  filling *f = data;

  f->operand[f->end[polygon]++] = operand;
}

/* begin[polygons + 2], of which the last is free, and operand[rows]. */
static void
fill_operands(const sg_dense *d, const from_rows *from, uint32_t *begin,
              int32_t *operand)
{
  uint32_t *end = begin + 1;

  each_row(d, from, count_row, end);
  for (size_t p = 0; p < d->polygons; p++) {
    end[p + 1] += end[p];
  }
  each_row(d, from, fill_row, &(filling){end, operand});
}

static int
find_ex(const sg_dense *d, const from_rows *from, sg_operand_borders *out)
{
  size_t n = from->rows->begin[from->n];
  uint32_t *begin = calloc(d->polygons + 2, sizeof *begin);
  int32_t *operand = malloc((n + 1) * sizeof *operand);
  bool stopped = false, done = false;

  if (begin && operand) {
    fill_operands(d, from, begin, operand);
    done = sg_operand_borders_find(d, &(sg_operands_of){begin, operand},
                                   &sg_prolog_poll, out, &stopped);
  }
  free(begin);
  free(operand);
  return done || (stopped ? FALSE : sg_no_memory());
}

/* Of n segments, ascending. */
static int
read_ex(const int32_t *s, size_t n, sg_operand_borders *out)
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
  } else if (!sg_segment_rows_find(&view, s, n, &sg_prolog_poll, &rows)) {
    done = PL_exception(0) ? FALSE : sg_no_memory();
  } else {
    done = sg_get_dense_ex(s, n, &dense) &&
           find_ex(&dense, &(from_rows){&view, s, n, &rows}, out);
    sg_dense_clear(&dense);
  }
  sg_segment_rows_clear(&rows);
  sg_view_clear(&view);
  sg_version_drop(version);
  return done;
}

/* operand_borders(+Ss, -Borders) is det. */
static foreign_t
operand_borders(term_t segments, term_t borders)
{
  term_t tail = PL_copy_term_ref(borders), head = PL_new_term_ref();
  sg_operand_borders found = {0};
  int32_t *s = NULL;
  size_t n = 0;
  int done = sg_get_id_set_ex(segments, &s, &n) && read_ex(s, n, &found);

  for (size_t i = 0; done && i < found.n; i++) {
    const sg_operand_border *b = &found.item[i];
    done = PL_unify_list(tail, head, tail) &&
           PL_unify_term(head, PL_FUNCTOR_CHARS, "border", 5, PL_INT, b->s,
                         PL_INT, b->polygon[0], PL_INT, b->low, PL_INT, b->high,
                         PL_INT, b->polygon[1]);
  }
  free(s);
  free(found.item);
  return done && PL_unify_nil(tail);
}

void
sg_install_operand_border(void)
{
  static const PL_extension doors[] = {
      {"operand_borders", 2, (pl_function_t)operand_borders, 0},
      {NULL, 0, NULL, 0}};

  PL_register_extensions_in_module("sg_kernel_boolean", doors);
}
