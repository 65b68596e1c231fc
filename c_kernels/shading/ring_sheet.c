/* ring_sheet.c -- what of a torus goes on from one line of sight to another.
 * Between two places where their number changes roots go on as they are; there
 * two neighbours of four meet, and the other two go on as the first and the
 * last one.
 */
#include "shading_private.h"

#include <math.h>
#include <string.h>

enum { HALVINGS = 24 };

void
sg_ring_sheets_change(sg_ring_sheets *sheets, const double c[5], int count)
{
  sg_ring_sheets was = *sheets;

  if (count == was.count) {
    return;
  }
  sheets->count = count;
  for (int i = 0; i < 2 && was.count == 4 && count == 2; i++) {
    sheets->of[i] =
        was.of[sg_quartic_before(c, sg_ring_root(i, 2)) - SG_ROOT_NEAR_IN];
  }
  for (int i = 0; i < count && count > was.count; i++) {
    sheets->of[i] = ++sheets->last;
  }
  for (int i = 0; i < 2 && was.count == 2 && count == 4; i++) {
    sheets->of[sg_quartic_before(c, sg_ring_root(i, 2)) - SG_ROOT_NEAR_IN] =
        was.of[i];
  }
}

/* The quartic so far from p to q, 0 to 1; its unit in dots. */
static double
quartic_between(const sg_shading_torus *torus, const double p[2],
                const double q[2], double part, double c[5])
{
  double x = p[0] + part * (q[0] - p[0]), y = p[1] + part * (q[1] - p[1]);
  sg_ring_line line = sg_ring_line_of(torus, y);

  sg_ring_quartic(&line, (x - line.x) / line.size, c);
  return line.size;
}

static double
gap(const double c[5], int32_t p, int32_t q)
{
  return fabs(sg_quartic_place(c, (sg_quartic_root)p) -
              sg_quartic_place(c, (sg_quartic_root)q));
}

double
sg_ring_gap(const sg_shading *s, uint32_t surface, int32_t root_p,
            const double p[2], int32_t root_q, const double q[2])
{
  const sg_shading_torus *torus = &s->torus.item[s->surface.item[surface].of];
  bool four = sg_quartic_of_four(root_p);
  double c[5], low = 0.0, high = 1.0;

  if (root_p == root_q) {
    return 0.0;
  }
  if (four == sg_quartic_of_four(root_q)) {
    double size = quartic_between(torus, p, q, 0.5, c);
    return size * gap(c, root_p, root_q);
  }
  for (int i = 0; i < HALVINGS; i++) {
    double middle = (low + high) / 2;
    (void)quartic_between(torus, p, q, middle, c);
    *((sg_quartic_discriminant(c) < 0) == !four ? &low : &high) = middle;
  }
  double size = quartic_between(torus, p, q, four ? low : high, c);
  int32_t of_four = four ? root_p : root_q, other = four ? root_q : root_p;
  sg_quartic_root before = sg_quartic_before(c, (sg_quartic_root)other);
  return (int32_t)before == of_four ? 0.0 : size * gap(c, of_four, before);
}

bool
sg_shading_sees_same(const sg_shading *s, const sg_span *span,
                     const double own[2], const double at[2])
{
  const sg_shading_surface *surface = &s->surface.item[span->surface];
  bool four = sg_quartic_of_four(span->sense);
  double c[5];

  if (surface->kind != SG_IS_RING) {
    return true;
  }
  (void)quartic_between(&s->torus.item[surface->of], own, at, 1.0, c);
  if ((sg_quartic_discriminant(c) < 0) == !four) {
    return true;
  }
  int count = sg_quartic_count(c);
  bool first = sg_quartic_enters(span->sense);
  return count != (four ? 2 : 4) ||
         sg_ring_gap(s, span->surface, span->sense, own,
                     sg_ring_root(first ? 0 : count - 1, count), at) == 0;
}
