/* turn_rows.c -- the whole world turned by quarter turns and moved: the fused
 * kernel of view.pl, turned_by_rule/2.
 */
#include "doors/drawing.h"
#include "rows/append_rows.h"

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

static bool
table_room(sg_call *call, table *t, size_t n)
{
  bool good = true;

  for (int k = 0; k < 2; k++) {
    t->id[k] = sg_call_alloc(call, n * sizeof *t->id[k]);
    good = good && t->id[k];
  }
  for (int k = 0; k < COLUMNS - 2; k++) {
    t->x[k] = sg_call_alloc(call, n * sizeof *t->x[k]);
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

static bool
read_rows(sg_call *call, const sg_version *version, sg_relation relation,
          const turn *how, table *t)
{
  sg_view view;
  bool good = true;

  if (!table_room(call, t, sg_version_count(version, relation))) {
    return false;
  }
  if (!sg_version_view(version, relation, &view)) {
    return sg_call_no_memory(call);
  }
  for (size_t i = 0; good && i < view.pages; i++) {
    for (unsigned r = sg_live_next(view.live[i], 0); good && r < SG_PAGE_ROWS;
         r = sg_live_next(view.live[i], r + 1)) {
      good = add_row(t, how, &view, relation, i, r) ||
             sg_call_cannot_hold(call, "coordinate");
    }
    good = good && !sg_cancelled(&call->cancel);
  }
  sg_view_clear(&view);
  return good;
}

static bool
turn_rows(sg_call *call, sg_world *world, sg_relation relation, const turn *how)
{
  const sg_version *version = sg_call_version(call);
  table t = {.n = 0};
  bool good = version && read_rows(call, version, relation, how, &t);
  const void *column[] = {t.id[0], t.id[1], t.x[0], t.x[1], t.x[2], t.x[3]};

  sg_call_rest(call);
  /* The rows have the keys of those they replace. */
  return good &&
         (sg_world_retract_all_again(world, relation) ||
          sg_call_no_memory(call)) &&
         (t.n == 0 || sg_append_columns(call, world, relation, t.n, column));
}

/* 1, 2, 3 in any order and with any sign. */
static bool
get_axes(sg_call *call, const sg_int_list *axes, turn *out)
{
  int seen = 0;

  for (size_t k = 0; axes->n == 3 && k < 3; k++) {
    int32_t axis = axes->at[k];

    if (axis < -3 || axis > 3 || axis == 0) {
      return sg_call_domain_of(call, "axis", axis);
    }
    out->from[k] = abs(axis) - 1;
    out->sign[k] = axis < 0 ? -1 : 1;
    seen |= 1 << out->from[k];
  }
  return seen == 7 || sg_call_domain(call, "axes", 1);
}

bool
sg_door_turn_points(sg_call *call, const sg_int_list *axes,
                    const sg_number_list *origin)
{
  sg_world *world = sg_call_world(call);
  turn how = {.sign = {1}};

  if (!world || !get_axes(call, axes, &how)) {
    return false;
  }
  if (origin->n != 3) {
    return sg_call_domain(call, "origin", 2);
  }
  for (int k = 0; k < 3; k++) {
    how.origin[k] = origin->at[k];
  }
  return turn_rows(call, world, SG_V, &how) &&
         turn_rows(call, world, SG_LEAF_V, &how) &&
         turn_rows(call, world, SG_PLANE, &how);
}
