/* view_rows.c -- the whole-set kernels of the view. */
#include "doors/drawing.h"
#include "picture_points.h"
#include "rows/append_rows.h"
#include "rows/pattern_rows.h"
#include "view.h"

#include <math.h>

/* The columns of screen/5, and what was measured on the way. */
typedef struct screen {
  int32_t *s, *v;
  double *x, *y, *z;
  size_t n;
  sg_range range;
  double reach; /* the largest distance from the origin */
} screen;

static bool
screen_room(sg_call *call, screen *out, size_t n)
{
  *out = (screen){.s = sg_call_alloc(call, n * sizeof(int32_t)),
                  .v = sg_call_alloc(call, n * sizeof(int32_t)),
                  .x = sg_call_alloc(call, n * sizeof(double)),
                  .y = sg_call_alloc(call, n * sizeof(double)),
                  .z = sg_call_alloc(call, n * sizeof(double)),
                  .range = sg_range_empty()};
  return out->s && out->v && out->x && out->y && out->z;
}

static void
screen_add(screen *out, const sg_eye *eye, int32_t s, int32_t v,
           const double at[3])
{
  double p[3];

  sg_eye_point(eye, at, p);
  sg_range_add(&out->range, eye, p[2]);
  out->reach =
      fmax(out->reach, sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]));
  out->s[out->n] = s;
  out->v[out->n] = v;
  out->x[out->n] = p[0];
  out->y[out->n] = p[1];
  out->z[out->n] = p[2];
  out->n++;
}

/* The eye's coordinates of every vertex but those of patterns. */
static bool
read_version(sg_call *call, const sg_version *version, const sg_eye *eye,
             screen *out)
{
  sg_model_view view;

  if (!screen_room(call, out, sg_version_count(version, SG_V))) {
    return false;
  }
  bool good = sg_model_view_make(version, SG_V, &view);

  for (size_t i = 0; good && i < view.shown.pages; i++) {
    const sg_column *c = view.shown.column;
    const uint64_t *live = view.shown.live[i];

    for (unsigned r = sg_live_next(live, 0); r < SG_PAGE_ROWS;
         r = sg_live_next(live, r + 1)) {
      double at[3] = {c[2].page[i].f[r], c[3].page[i].f[r], c[4].page[i].f[r]};
      screen_add(out, eye, c[0].page[i].i[r], c[1].page[i].i[r], at);
    }
    good = !sg_cancelled(&call->cancel);
  }
  sg_model_view_clear(&view);
  return good || sg_call_ended(call);
}

/* The same of the current world. */
static bool
read_screen(sg_call *call, const sg_eye *eye, screen *out)
{
  const sg_version *version = sg_call_version(call);
  bool good = version && read_version(call, version, eye, out);

  sg_call_rest(call); /* it may be written next */
  return good;
}

static void
make_central(screen *out, const sg_eye *eye)
{
  for (size_t i = 0; i < out->n; i++) {
    double p[3] = {out->x[i], out->y[i], out->z[i]};
    sg_central_point(eye, &out->range, p);
    out->x[i] = p[0];
    out->y[i] = p[1];
    out->z[i] = p[2];
  }
}

/* Makes points in one place of the picture one. */
static bool
merge(sg_call *call, screen *rows)
{
  double side = sg_picture_side(rows->x, rows->y, rows->n);
  bool memory;

  return sg_picture_merge(rows->x, rows->y, rows->n, SG_ONE_PLACE * side,
                          &call->cancel, &memory) ||
         sg_call_ended(call);
}

/* The rows have the keys of v/5 and refer to it, so they are right. */
static bool
replace_screen(sg_call *call, const screen *rows)
{
  const void *column[] = {rows->s, rows->v, rows->x, rows->y, rows->z};
  sg_world *world = sg_call_world(call);

  return (sg_world_retract_all(world, SG_SCREEN) || sg_call_no_memory(call)) &&
         (rows->n == 0 ||
          sg_append_columns(call, world, SG_SCREEN, rows->n, column));
}

bool
sg_door_fill_screen(sg_call *call, double theta, double phi, double rho,
                    int kind)
{
  screen rows;
  sg_eye eye;

  sg_eye_init(&eye, theta, phi, rho);
  if (!read_screen(call, &eye, &rows)) {
    return false;
  }
  if (kind == SG_PROJECTION_CENTRAL && rows.n > 0) {
    if (!sg_range_is_visible(&rows.range)) {
      return sg_call_domain(call, "rho", 3);
    }
    make_central(&rows, &eye);
  }
  return merge(call, &rows) && replace_screen(call, &rows);
}

bool
sg_door_view_range(sg_call *call, double theta, double phi, double *nearest,
                   double *farthest, double *reach)
{
  screen rows;
  sg_eye eye;

  sg_eye_init(&eye, theta, phi, 0);
  if (!read_screen(call, &eye, &rows)) {
    return false;
  }
  *nearest = rows.range.nearest;
  *farthest = rows.range.farthest;
  *reach = rows.reach;
  return rows.n > 0;
}

bool
sg_door_view_depth(sg_call *call, double theta, double phi, double rho,
                   int kind, double *depth)
{
  screen rows = {.n = 0};
  sg_eye eye;

  sg_eye_init(&eye, theta, phi, rho);
  if (kind == SG_PROJECTION_CENTRAL && !read_screen(call, &eye, &rows)) {
    return false;
  }
  *depth = rows.n > 0 ? sg_central_depth(&rows.range) : 1;
  return true;
}

bool
sg_door_sine_cosine(sg_call *call, double degrees, double *sine, double *cosine)
{
  (void)call;
  sg_sine_cosine(degrees, sine, cosine);
  return true;
}
