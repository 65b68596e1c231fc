/* shading_segment_rows.c -- a leaf from the rows of a segment: its triangles.
 */
#include "shading_segment_rows.h"

#include "rows/by_segment.h"

#include <stdlib.h>
#include <string.h>

typedef struct reading {
  sg_call *call;
  sg_shading *scene;
  const double *map; /* [12], three rows; null: it stays where it is */
  sg_view v, t;
  sg_segment_rows vs, ts;
  sg_id_rows at;    /* of vertices */
  uint32_t *corner; /* [at.places]; UINT32_MAX: not yet */
} reading;

static bool
open_corners(reading *r)
{
  size_t n = r->at.places;

  r->corner = sg_call_alloc(r->call, (n + 1) * sizeof *r->corner);
  for (size_t i = 0; r->corner && i < n; i++) {
    r->corner[i] = UINT32_MAX;
  }
  return r->corner;
}

static bool
open_reading(reading *r, int32_t s)
{
  const sg_version *version = sg_call_version(r->call);
  const sg_cancel *cancel = &r->call->cancel;

  return version &&
         ((sg_version_view(version, SG_V, &r->v) &&
           sg_version_view(version, SG_T, &r->t) &&
           sg_segment_rows_find(&r->v, &s, 1, cancel, &r->vs) &&
           sg_segment_rows_find(&r->t, &s, 1, cancel, &r->ts) &&
           sg_id_rows_make(&r->v, r->vs.row, r->vs.begin[1], &r->at)) ||
          sg_call_ended(r->call)) &&
         open_corners(r);
}

static void
close_reading(reading *r)
{
  sg_id_rows_clear(&r->at);
  sg_segment_rows_clear(&r->vs);
  sg_segment_rows_clear(&r->ts);
  sg_view_clear(&r->v);
  sg_view_clear(&r->t);
}

static void
point(const reading *r, size_t place, double out[3])
{
  uint32_t row = r->at.row[place];
  double p[3];

  sg_view_point(&r->v, row, p);
  for (unsigned k = 0; k < 3; k++) {
    const double *m = r->map + 4 * (size_t)k;
    out[k] = r->map ? m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3] : p[k];
  }
}

static sg_shading_end
add_triangle(reading *r, uint32_t row)
{
  sg_shading_end end = SG_SHADING_GOOD;
  const size_t three = 3;
  uint32_t corner[3];

  for (unsigned k = 0; k < 3 && end == SG_SHADING_GOOD; k++) {
    size_t place = sg_id_rows_place(&r->at, sg_view_int(&r->t, 3 + k, row));
    double p[3];

    if (r->corner[place] == UINT32_MAX) {
      point(r, place, p);
      end = sg_shading_add_corner(r->scene, p, &r->corner[place]);
    }
    corner[k] = r->corner[place];
  }
  return end != SG_SHADING_GOOD
             ? end
             : sg_shading_add_polygon(r->scene, sg_view_int(&r->t, 1, row),
                                      corner, &three, 1);
}

sg_shading_end
sg_shading_read_segment(sg_call *call, sg_shading *scene, int32_t s,
                        const double *map)
{
  reading r = {.call = call, .scene = scene, .map = map};
  sg_shading_end end =
      open_reading(&r, s) ? SG_SHADING_GOOD : SG_SHADING_STOPPED;

  for (size_t i = 0; end == SG_SHADING_GOOD && i < r.ts.begin[1]; i++) {
    end = sg_cancel_every(&call->cancel, i) ? SG_SHADING_STOPPED
                                            : add_triangle(&r, r.ts.row[i]);
  }
  close_reading(&r);
  return end;
}
