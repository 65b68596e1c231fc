/* operand_border_rows.c -- where the boundary of a result turns from one
 * operand to another.
 */
#include "doors/boolean.h"
#include "engine/search.h"
#include "rows/by_segment.h"
#include "rows/dense_rows.h"

#include <string.h>

/* The place of polygon p of segment s (a place); SIZE_MAX: there is none. */
static size_t
place_of(const sg_dense *d, size_t s, int32_t p)
{
  size_t begin = d->polygon_begin[s];
  size_t at =
      sg_find_id(d->polygon_id + begin, d->polygon_begin[s + 1] - begin, p);

  return at == SIZE_MAX ? at : begin + at;
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
      size_t p =
          place_of(d, place, sg_view_int(from->view, 1, from->rows->row[i]));
      if (p != SIZE_MAX) {
        use(data, p, sg_view_int(from->view, 2, from->rows->row[i]));
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

static bool
find(sg_call *call, const sg_dense *d, const from_rows *from,
     sg_operand_borders *out)
{
  size_t n = from->rows->begin[from->n];
  uint32_t *begin = sg_call_alloc(call, (d->polygons + 2) * sizeof *begin);
  int32_t *operand = sg_call_alloc(call, (n + 1) * sizeof *operand);
  bool stopped = false;

  if (!begin || !operand) {
    return false;
  }
  memset(begin, 0, (d->polygons + 2) * sizeof *begin);
  fill_operands(d, from, begin, operand);
  sg_operands_of operands = {begin, operand};
  return sg_operand_borders_find(d, &operands, &call->cancel, out, &stopped) ||
         sg_call_ended(call);
}

static bool
find_of_version(sg_call *call, const sg_version *version, const sg_int_list *ss,
                sg_operand_borders *out)
{
  sg_view view = {0};
  sg_segment_rows rows = {0};
  sg_dense dense = {0};
  bool good =
      (sg_version_view(version, SG_FROM_P, &view) &&
       sg_segment_rows_find(&view, ss->at, ss->n, &call->cancel, &rows)) ||
      sg_call_ended(call);

  good = good && sg_dense_read(call, ss->at, ss->n, &dense) &&
         find(call, &dense, &(from_rows){&view, ss->at, ss->n, &rows}, out);
  sg_dense_clear(&dense);
  sg_segment_rows_clear(&rows);
  sg_view_clear(&view);
  return good;
}

bool
sg_door_operand_borders(sg_call *call, const sg_int_list *ss,
                        sg_operand_border_list *borders)
{
  const sg_version *version = sg_call_version(call);
  sg_operand_borders found = {0};
  bool good = version && find_of_version(call, version, ss, &found) &&
              sg_call_adopt(call, found.item);

  if (good) {
    *borders = (sg_operand_border_list){found.item, found.n, 0};
  }
  return good;
}
