/* face_merge_fold.c -- triangles that lie back on each other: see
 * face_merge_sheet.h.
 *
 * Layer: kernel. Inexact: within twice the tolerance.
 */
#include "face_merge_sheet.h"

#include "engine/list.h"
#include "engine/search.h"
#include "number/vector.h"
#include "rows/sort.h"

#include <stdlib.h>

/* An edge of a triangle, without its direction. */
typedef struct side {
  uint32_t low, high, third;
  uint32_t triangle; /* of the sheet */
} side;

SG_ORDER(compare_folds, sg_fold,
         SG_BY(key.low) SG_BY(key.high) SG_BY(edge.low) SG_BY(edge.high));

SG_ORDER(compare_sides, side, SG_BY(low) SG_BY(high) SG_BY(triangle));

static side
side_of(const sg_sheet *sheet, size_t t, int k)
{
  const int32_t *corner = sheet->corner[t];
  uint32_t v = (uint32_t)corner[k], w = (uint32_t)corner[(k + 1) % 3];

  return (side){v < w ? v : w, v < w ? w : v, (uint32_t)corner[(k + 2) % 3],
                (uint32_t)t};
}

/* From the edge u-w to the third corner, at right angles to the edge. */
static void
away(const double u[3], const double w[3], const double third[3], double out[3])
{
  double along[3];

  sg_minus(w, u, along);
  sg_minus(third, u, out);
  double part = sg_dot(out, along) / sg_dot(along, along);
  for (int k = 0; k < 3; k++) {
    out[k] -= part * along[k];
  }
}

/* The sides of a wall have moved by the tolerance at most, each its way. */
static bool
are_folded(const sg_merge *m, const side *one, const side *other)
{
  const double *u = sg_merge_at(m, one->low), *w = sg_merge_at(m, one->high);
  double near = 2 * m->tolerance, x[3], y[3], across[3];

  if (one->third == other->third) {
    return true;
  }
  away(u, w, sg_merge_at(m, one->third), x);
  away(u, w, sg_merge_at(m, other->third), y);
  sg_cross(x, y, across);
  double far = sg_length(x), wide = sg_length(y);

  return sg_dot(x, y) > 0 && far > near && wide > near &&
         sg_length(across) <= near * fmax(far, wide);
}

static bool
note_folds(const sg_sheet *sheet, const side *item, size_t n, sg_folds *out)
{
  sg_key_pair edge = {item->low, item->high};
  bool memory = true;

  for (size_t i = 0; i < n && item[i].triangle < sheet->asked; i++) {
    uint32_t a = sheet->key[item[i].triangle];
    for (size_t k = i + 1; memory && k < n; k++) {
      uint32_t b = sheet->key[item[k].triangle];
      if (a != b && are_folded(sheet->m, &item[i], &item[k])) {
        sg_key_pair key = {a < b ? a : b, a < b ? b : a};
        memory = SG_PUSH(*out, (sg_fold){key, edge});
      }
    }
  }
  return memory;
}

sg_merge_end
sg_sheet_folds(const sg_sheet *sheet, sg_folds *out)
{
  side *item = malloc((3 * sheet->n + 1) * sizeof *item);
  size_t n = 3 * sheet->n, end;
  bool memory = item;

  *out = (sg_folds){0};
  for (size_t i = 0; memory && i < n; i++) {
    item[i] = side_of(sheet, i / 3, (int)(i % 3));
  }
  sg_sort_end sorted = memory ? sg_sort(item, n, sizeof *item, compare_sides,
                                        sheet->m->options->cancel)
                              : SG_SORT_NO_MEMORY;
  for (size_t i = 0; sorted == SG_SORTED && memory && i < n; i = end) {
    for (end = i + 1; end < n && item[end].low == item[i].low &&
                      item[end].high == item[i].high;
         end++) {
    }
    memory = note_folds(sheet, &item[i], end - i, out);
  }
  free(item);
  if (out->n) {
    qsort(out->item, out->n, sizeof *out->item, compare_folds);
  }
  if (sorted == SG_SORT_STOPPED) {
    return SG_MERGE_STOPPED;
  }
  return sorted == SG_SORTED && memory ? SG_MERGE_DONE : SG_MERGE_NO_MEMORY;
}
