/* turn4pl.c -- the whole world turned by quarter turns and moved (documented in
 * kernel/drawing.pl).
 *
 * Layer: glue. The fused kernel of view.pl, turned_by_rule/2.
 */
#include "rows/append4pl.h"

#include "glue.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <math.h>
#include <stdlib.h>

enum { COLUMNS = 6 }; /* S, the id, X, Y, Z, D */

/* Axis k of what is turned is axis from[k] of what was, times sign[k]. */
typedef struct turn {
  int from[3];
  double sign[3];
  double origin[3]; /* comes to the origin */
} turn;

/* The columns of one relation. */
typedef struct table {
  int32_t *id[2];
  double *x[COLUMNS - 2];
  size_t n;
} table;

static void
table_clear(table *t)
{
  free(t->id[0]);
  free(t->id[1]);
  for (int k = 0; k < COLUMNS - 2; k++) {
    free(t->x[k]);
  }
}

static bool
table_room(table *t, size_t n)
{
  bool good = true;

  for (int k = 0; k < 2; k++) {
    t->id[k] = malloc((n + 1) * sizeof *t->id[k]);
    good = good && t->id[k];
  }
  for (int k = 0; k < COLUMNS - 2; k++) {
    t->x[k] = malloc((n + 1) * sizeof *t->x[k]);
    good = good && t->x[k];
  }
  return good;
}

/* A point goes less the origin. */
static void
turn_point(const turn *how, const double at[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    int from = how->from[k];
    out[k] = how->sign[k] * (at[from] - how->origin[from]) + 0.0;
  }
}

/* A normal only turns; its plane then passes the origin elsewhere. */
static void
turn_plane(const turn *how, const double at[3], double d, double out[4])
{
  out[3] = d;
  for (int k = 0; k < 3; k++) {
    out[k] = how->sign[k] * at[how->from[k]] + 0.0;
    out[3] += at[k] * how->origin[k];
  }
}

/* Whether column c of the relation takes x. */
static bool
may_be(sg_relation relation, unsigned c, double x)
{
  double most = sg_relation_table[relation].most[c];

  return isfinite(x) && (most == 0 || fabs(x) <= most);
}

/* False: a coordinate is larger than any that the relation takes. */
static bool
add_row(table *t, const turn *how, const sg_view *view, sg_relation relation,
        size_t page, unsigned r)
{
  unsigned columns = sg_relation_table[relation].arity;
  const sg_column *c = view->column;
  double at[3] = {c[2].page[page].f[r], c[3].page[page].f[r],
                  c[4].page[page].f[r]};
  double out[4] = {0};

  if (columns == COLUMNS) {
    turn_plane(how, at, c[5].page[page].f[r], out);
  } else {
    turn_point(how, at, out);
  }
  t->id[0][t->n] = c[0].page[page].i[r];
  t->id[1][t->n] = c[1].page[page].i[r];
  for (unsigned k = 2; k < columns; k++) {
    t->x[k - 2][t->n] = out[k - 2];
    if (!may_be(relation, k, out[k - 2])) {
      return false;
    }
  }
  t->n++;
  return true;
}

static int
read_ex(sg_world *world, sg_relation relation, const turn *how, table *t)
{
  const sg_version *version = sg_world_version(world);
  sg_view view = {0};
  bool memory = version && table_room(t, sg_version_count(version, relation)) &&
                sg_version_view(version, relation, &view);
  bool stopped = false, fits = true;

  for (size_t i = 0; memory && i < view.pages && !stopped && fits; i++) {
    for (unsigned r = sg_live_next(view.live[i], 0); r < SG_PAGE_ROWS && fits;
         r = sg_live_next(view.live[i], r + 1)) {
      fits = add_row(t, how, &view, relation, i, r);
    }
    stopped = sg_poll_stop(&sg_prolog_poll);
  }
  sg_view_clear(&view);
  sg_version_drop(version);
  return !memory ? sg_no_memory()
         : !fits ? PL_representation_error("coordinate")
                 : !stopped;
}

/* The rows have the keys of those they replace. */
static int
replace_ex(sg_world *world, sg_relation relation, const table *t)
{
  const void *column[] = {t->id[0], t->id[1], t->x[0],
                          t->x[1],  t->x[2],  t->x[3]};

  return (sg_world_retract_all_again(world, relation) || sg_no_memory()) &&
         (t->n == 0 || sg_append_columns_ex(world, relation, t->n, column));
}

static int
turn_ex(sg_world *world, sg_relation relation, const turn *how)
{
  table t = {0};
  int done =
      read_ex(world, relation, how, &t) && replace_ex(world, relation, &t);

  table_clear(&t);
  return done;
}

/* [I,J,K]: 1, 2, 3 in any order and with any sign. */
static int
get_axes_ex(term_t list, turn *out)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  int seen = 0;

  for (int k = 0; k < 3; k++) {
    int axis;

    if (!PL_get_list_ex(tail, head, tail) || !PL_get_integer_ex(head, &axis)) {
      return FALSE;
    }
    if (axis < -3 || axis > 3 || axis == 0) {
      return PL_domain_error("axis", head);
    }
    out->from[k] = abs(axis) - 1;
    out->sign[k] = axis < 0 ? -1 : 1;
    seen |= 1 << out->from[k];
  }
  return PL_get_nil_ex(tail) && (seen == 7 || PL_domain_error("axes", list));
}

static int
get_origin_ex(term_t list, turn *out)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (int k = 0; k < 3; k++) {
    if (!PL_get_list_ex(tail, head, tail) ||
        !sg_get_finite_ex(head, &out->origin[k])) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(tail);
}

/* turn_points(+Axes, +Origin) is det. */
static foreign_t
turn_points(term_t axes, term_t origin)
{
  sg_world *world = sg_current_world_ex();
  turn how = {0};

  return world && get_axes_ex(axes, &how) && get_origin_ex(origin, &how) &&
         turn_ex(world, SG_V, &how) && turn_ex(world, SG_LEAF_V, &how) &&
         turn_ex(world, SG_PLANE, &how);
}

void
sg_install_turn(void)
{
  static const PL_extension doors[] = {
      {"turn_points", 2, (pl_function_t)turn_points, 0}, {NULL, 0, NULL, 0}};

  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
