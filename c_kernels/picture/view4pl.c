/* view4pl.c -- the whole-set kernels of the view (documented in
 * kernel/drawing.pl).
 *
 * Layer: glue.
 */
#include "rows/append4pl.h"
#include "rows/pattern_rows.h"

#include "glue.h"
#include "picture_points.h"
#include "view.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <math.h>
#include <stdlib.h>

static atom_t ATOM_central, ATOM_parallel;

/* The columns of screen/5, and what was measured on the way. */
typedef struct screen {
  int32_t *s, *v;
  double *x, *y, *z;
  size_t n;
  sg_range range;
  double reach; /* the largest distance from the origin */
} screen;

static void
screen_clear(screen *out)
{
  free(out->s);
  free(out->v);
  free(out->x);
  free(out->y);
  free(out->z);
}

static bool
screen_room(screen *out, size_t n)
{
  *out = (screen){.s = malloc((n + 1) * sizeof(int32_t)),
                  .v = malloc((n + 1) * sizeof(int32_t)),
                  .x = malloc((n + 1) * sizeof(double)),
                  .y = malloc((n + 1) * sizeof(double)),
                  .z = malloc((n + 1) * sizeof(double)),
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

/* The eye's coordinates of every vertex but those of patterns. False: stopped,
 * or no memory. */
static bool
screen_read(screen *out, const sg_version *version, const sg_eye *eye,
            bool *memory)
{
  sg_model_view view = {.parted = false};
  bool stopped = false;

  *memory = screen_room(out, sg_version_count(version, SG_V)) &&
            sg_model_view_make(version, SG_V, &view);
  for (size_t i = 0; *memory && i < view.shown.pages && !stopped; i++) {
    const sg_column *c = view.shown.column;
    const uint64_t *live = view.shown.live[i];
    for (unsigned r = sg_live_next(live, 0); r < SG_PAGE_ROWS;
         r = sg_live_next(live, r + 1)) {
      double at[3] = {c[2].page[i].f[r], c[3].page[i].f[r], c[4].page[i].f[r]};
      screen_add(out, eye, c[0].page[i].i[r], c[1].page[i].i[r], at);
    }
    stopped = sg_poll_stop(&sg_prolog_poll);
  }
  sg_model_view_clear(&view);
  return *memory && !stopped;
}

/* The eye's coordinates of the current world; screen_clear() in any case. */
static int
get_screen_ex(sg_world *world, const sg_eye *eye, screen *out)
{
  const sg_version *version = sg_world_version(world);
  bool memory = version != NULL;
  bool done = memory && screen_read(out, version, eye, &memory);

  sg_version_drop(version);
  return memory ? done : sg_no_memory();
}

static int
get_eye_ex(term_t theta, sg_eye *out) /* theta, phi, rho in a row */
{
  double x[3];

  if (!sg_get_finites_ex(theta, 3, x)) {
    return FALSE;
  }
  sg_eye_init(out, x[0], x[1], x[2]);
  return TRUE;
}

static int
get_central_ex(term_t kind, bool *central)
{
  atom_t name;

  if (!PL_get_atom_ex(kind, &name)) {
    return FALSE;
  }
  *central = name == ATOM_central;
  return *central || name == ATOM_parallel ||
         PL_domain_error("projection", kind);
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
static int
merge_ex(screen *rows)
{
  double side = sg_picture_side(rows->x, rows->y, rows->n);
  bool memory;

  return sg_picture_merge(rows->x, rows->y, rows->n, SG_ONE_PLACE * side,
                          &sg_prolog_poll, &memory) ||
         (!memory && sg_no_memory());
}

/* The rows have the keys of v/5 and refer to it, so they are right. */
static int
replace_screen_ex(sg_world *world, const screen *rows)
{
  const void *column[] = {rows->s, rows->v, rows->x, rows->y, rows->z};

  return (sg_world_retract_all(world, SG_SCREEN) || sg_no_memory()) &&
         (rows->n == 0 ||
          sg_append_columns_ex(world, SG_SCREEN, rows->n, column));
}

/* fill_screen(+Theta, +Phi, +Rho, +Kind) is det. */
static foreign_t
fill_screen(term_t a0, int arity, void *context)
{
  sg_world *world = sg_current_world_ex();
  screen rows = {0};
  sg_eye eye;
  bool central;
  int ok;

  (void)arity, (void)context;
  if (!world || !get_eye_ex(a0, &eye) || !get_central_ex(a0 + 3, &central)) {
    return FALSE;
  }
  ok = get_screen_ex(world, &eye, &rows);
  if (ok && central && rows.n > 0) {
    ok = sg_range_is_visible(&rows.range) || PL_domain_error("rho", a0 + 2);
    if (ok) {
      make_central(&rows, &eye);
    }
  }
  ok = ok && merge_ex(&rows) && replace_screen_ex(world, &rows);
  screen_clear(&rows);
  return ok;
}

/* view_range(+Theta, +Phi, -Near, -Far, -Reach) is semidet. */
static foreign_t
view_range(term_t theta, term_t phi, term_t nearest, term_t farthest,
           term_t reach)
{
  sg_world *world = sg_current_world_ex();
  screen rows = {0};
  sg_eye eye;
  double t, p;
  int ok;

  if (!world || !sg_get_finite_ex(theta, &t) || !sg_get_finite_ex(phi, &p)) {
    return FALSE;
  }
  sg_eye_init(&eye, t, p, 0.0);
  ok = get_screen_ex(world, &eye, &rows);
  screen_clear(&rows);
  return ok && rows.n > 0 && sg_unify_double(nearest, rows.range.nearest) &&
         sg_unify_double(farthest, rows.range.farthest) &&
         sg_unify_double(reach, rows.reach);
}

/* view_depth(+Theta, +Phi, +Rho, +Kind, -Depth) is det. */
static foreign_t
view_depth(term_t a0, int arity, void *context)
{
  sg_world *world = sg_current_world_ex();
  screen rows = {0};
  sg_eye eye;
  bool central;
  double depth = 1.0;

  (void)arity, (void)context;
  if (!world || !get_eye_ex(a0, &eye) || !get_central_ex(a0 + 3, &central)) {
    return FALSE;
  }
  if (central) {
    int ok = get_screen_ex(world, &eye, &rows);
    screen_clear(&rows);
    if (!ok) {
      return FALSE;
    }
    depth = rows.n > 0 ? sg_central_depth(&rows.range) : 1.0;
  }
  return sg_unify_double(a0 + 4, depth);
}

/* sine_cosine(+Degrees, -Sine, -Cosine) is det. */
static foreign_t
sine_cosine(term_t degrees, term_t sine, term_t cosine)
{
  double x, s, c;

  if (!sg_get_finite_ex(degrees, &x)) {
    return FALSE;
  }
  sg_sine_cosine(x, &s, &c);
  return sg_unify_double(sine, s) && sg_unify_double(cosine, c);
}

void
sg_install_view(void)
{
  static const PL_extension doors[] = {
      {"fill_screen", 4, (pl_function_t)fill_screen, PL_FA_VARARGS},
      {"view_range", 5, (pl_function_t)view_range, 0},
      {"view_depth", 5, (pl_function_t)view_depth, PL_FA_VARARGS},
      {"sine_cosine", 3, (pl_function_t)sine_cosine, 0},
      {NULL, 0, NULL, 0}};

  ATOM_central = PL_new_atom("central");
  ATOM_parallel = PL_new_atom("parallel");
  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
