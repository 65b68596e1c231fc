/* round_extent_rows.c -- how far the polygons on smooth surfaces reach along
 * their axes and about them. */
#include "doors/drawing.h"
#include "known_surface_rows.h"
#include "rows/dense_rows.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Vertices about an axis are noted by degree. What stands for a surface turns
 * by less than WIDEST from vertex to vertex (stands_for/2, known_surface.pl).
 */
enum { DEGREES = 360, WIDEST = 90, WIDEST_TAPERED = 45 };

typedef struct extent {
  size_t segment; /* the place it is being measured in, from 1 */
  double low, high;
  bool at[DEGREES];
} extent;

typedef struct measuring {
  const sg_dense *dense;
  const sg_known_surfaces *surfaces;
  extent *extent; /* [surfaces->n] */
} measuring;

static bool
has_axis(const sg_known_surface *surface)
{
  return sg_known_surface_is_tapered(surface) ||
         surface->kind == SG_KNOWN_SPHERE || surface->kind == SG_KNOWN_TORUS;
}

static void
widen(extent *x, const sg_known_surface *surface, const double p[3])
{
  double at[3];

  sg_known_surface_place(surface, p, at);
  x->low = fmin(x->low, at[2]);
  x->high = fmax(x->high, at[2]);
  if (at[0] != 0.0 || at[1] != 0.0) {
    double turns = atan2(at[1], at[0]) / (2.0 * M_PI);
    int degree = (int)lround((turns - floor(turns)) * DEGREES);
    x->at[degree % DEGREES] = true;
  }
}

/* The widest stretch without a vertex: it ends at *end, and is so wide. */
static int
widest_gap(const extent *x, int *end)
{
  int widest = 0, last = -1;

  *end = 0;
  for (int i = 0; i < 2 * DEGREES; i++) {
    if (x->at[i % DEGREES]) {
      if (last >= 0 && i - last > widest) {
        widest = i - last;
        *end = i % DEGREES;
      }
      last = i;
    }
  }
  return last < 0 ? DEGREES : widest;
}

static bool
add_extent(sg_call *call, const sg_known_surface *surface, int32_t s,
           const extent *x, sg_round_extent_list *out)
{
  int begin, gap = widest_gap(x, &begin);
  bool whole =
      gap <= (sg_known_surface_is_tapered(surface) ? WIDEST_TAPERED : WIDEST);
  const sg_smooth_surface said = {surface->kind,
                                  {(double *)surface->frame[0], 12, 0},
                                  surface->a,
                                  surface->b};

  return sg_round_extent_list_add(
      call, out,
      (sg_round_extent){s, said, x->low, x->high, begin,
                        whole ? DEGREES : DEGREES - gap});
}

static void
widen_by_polygon(const measuring *m, size_t s, size_t p)
{
  const sg_dense *d = m->dense;
  int32_t of = m->surfaces->of[p];
  extent *x = &m->extent[of];

  if (x->segment != s + 1) {
    *x = (extent){.segment = s + 1, .low = INFINITY, .high = -INFINITY};
  }
  for (size_t i = d->list_begin[p]; i < d->list_begin[p + 1]; i++) {
    widen(x, &m->surfaces->surface[of], d->at[d->from[d->list[i]]]);
  }
}

/* A surface is told of with the first of its polygons in a segment. */
static bool
measure_segment(sg_call *call, const measuring *m, size_t s,
                sg_round_extent_list *out)
{
  const sg_dense *d = m->dense;
  const sg_known_surfaces *all = m->surfaces;
  size_t begin = d->polygon_begin[s], end = d->polygon_begin[s + 1];

  for (size_t p = begin; p < end; p++) {
    if (all->of[p] >= 0 && has_axis(&all->surface[all->of[p]])) {
      widen_by_polygon(m, s, p);
    }
  }
  for (size_t p = begin; p < end; p++) {
    int32_t of = all->of[p];
    if (of >= 0 && m->extent[of].segment == s + 1) {
      if (!add_extent(call, &all->surface[of], d->segment[s], &m->extent[of],
                      out)) {
        return false;
      }
      m->extent[of].segment = 0;
    }
  }
  return !sg_cancelled(&call->cancel);
}

bool
sg_door_round_extents(sg_call *call, const sg_known_segment_list *known,
                      const sg_int_list *ss, sg_round_extent_list *extents)
{
  sg_known_surfaces surfaces = {0};
  sg_dense dense = {0};
  measuring m = {&dense, &surfaces, NULL};
  bool good = sg_dense_read_these(call, ss, &dense) &&
              sg_known_surfaces_read(call, known, &dense, &surfaces);

  good = sg_known_surfaces_adopt(call, &surfaces) && good;
  if (good && surfaces.of) {
    m.extent = sg_call_alloc(call, surfaces.n * sizeof *m.extent);
    good = m.extent != NULL;
    if (good) {
      memset(m.extent, 0, surfaces.n * sizeof *m.extent);
    }
    for (size_t s = 0; good && s < dense.segments; s++) {
      good = measure_segment(call, &m, s, extents);
    }
  }
  sg_dense_clear(&dense);
  return good;
}
