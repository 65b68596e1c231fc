/* pages.c -- see pages.h. */
#include "pages.h"

#include "engine/search.h"
#include "number/exact.h"

#include <stdlib.h>

enum { FEW = 8 };

/* An edge, and the page that the others are counted from: along this axis it
 * is seen to lie on this side; 0: it has no area. */
typedef struct hinge {
  const double *u, *w, *first;
  int axis, side;
} hinge;

static int
turn(int axis, const double a[3], const double b[3], const double c[3])
{
  int x = (axis + 1) % 3, y = (axis + 2) % 3;

  return sg_orient2d((double[2]){a[x], a[y]}, (double[2]){b[x], b[y]},
                     (double[2]){c[x], c[y]});
}

static void
see_first(hinge *h)
{
  for (h->axis = 0; h->axis < 3; h->axis++) {
    h->side = turn(h->axis, h->u, h->w, h->first);
    if (h->side != 0) {
      return;
    }
  }
}

/* Of a point in the plane of the first page: on its side of the edge? */
static bool
is_beside_first(const hinge *h, const double p[3])
{
  return h->side == 0 || h->side == turn(h->axis, h->u, h->w, p);
}

/* 0 at the first page, 1 up to opposite of it, 2 there, 3 behind. */
static int
quarter(const hinge *h, const double p[3])
{
  int side = sg_orient3d(h->u, h->w, h->first, p);

  return side > 0 ? 1 : side < 0 ? 3 : is_beside_first(h, p) ? 0 : 2;
}

static int
compare_angles(const hinge *h, const sg_page_at_edge *a,
               const sg_page_at_edge *b)
{
  return a->quarter != b->quarter ? a->quarter - b->quarter
         : a->quarter == 1 || a->quarter == 3
             ? -sg_orient3d(h->u, h->w, a->beside, b->beside)
             : 0;
}

static int
compare(const void *x, const void *y, void *data)
{
  const sg_page_at_edge *a = x, *b = y;
  int order = compare_angles(data, a, b);

  return order ? order : (a->rank > b->rank) - (a->rank < b->rank);
}

bool
sg_pages_order(const double u[3], const double w[3], sg_page_at_edge *page,
               size_t n)
{
  double first[3] = {page[0].beside[0], page[0].beside[1], page[0].beside[2]};
  hinge h = {.u = u, .w = w, .first = first};
  bool alternating = true;

  see_first(&h);
  page[0].quarter = 0;
  for (size_t i = 1; i < n; i++) {
    page[i].quarter = quarter(&h, page[i].beside);
  }
  if (n > FEW) {
    qsort_r(page, n, sizeof *page, compare, &h);
  } else {
    SG_SORT_FEW(sg_page_at_edge, page, n, compare(x, y, &h) > 0);
  }
  for (size_t i = 0; i < n; i++) {
    alternating &= page[i].forward != page[(i + 1) % n].forward;
    page[i].on_last = i > 0 && compare_angles(&h, &page[i - 1], &page[i]) == 0;
  }
  return alternating;
}
