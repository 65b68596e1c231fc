/* development_rows.c -- faces being joined flat. */
#include "development_rows.h"

#include "doors/pattern.h"
#include "measure.h"
#include "rows/dense_rows.h"
#include "rows/sort.h"

#include <stdlib.h>

/* ---- the object --------------------------------------------------------- */

void
sg_development_free(sg_development *d)
{
  if (d) {
    sg_layout_clear(&d->layout);
    sg_flattening_clear(&d->flattening);
    sg_joints_clear(&d->joints);
    sg_flat_faces_clear(&d->faces);
    sg_dense_clear(&d->dense);
    free(d);
  }
}

/* ---- ids ---------------------------------------------------------------- */

int32_t
sg_development_polygon(const sg_development *d, uint32_t face)
{
  const sg_flat_faces *f = &d->faces;
  uint32_t polygon = f->polygon[face];

  return f->bent[polygon] ? d->dense.polygon_id[d->dense.polygons - 1] + 1 +
                                (int32_t)f->bent_before[face]
                          : d->dense.polygon_id[polygon];
}

int32_t
sg_development_edge(const sg_development *d, uint32_t side)
{
  uint32_t edge = d->faces.side[side].edge;
  size_t edges = d->dense.edges;

  return edge < edges ? d->dense.edge_id[edge]
                      : (edges ? d->dense.edge_id[edges - 1] : 0) + 1 +
                            (int32_t)(edge - edges);
}

/* ---- opening ------------------------------------------------------------ */

/* Which polygons are to be left out; *out null: none. */
static bool
find_removed(sg_call *call, const sg_int_list *list, const sg_dense *d,
             bool **out)
{
  *out = NULL;
  if (list->n == 0) {
    return true;
  }
  if (!(*out = sg_call_alloc(call, d->polygons + 1))) {
    return false;
  }
  for (size_t p = 0; p < d->polygons; p++) {
    if (sg_cancel_every(&call->cancel, p)) {
      return false;
    }
    (*out)[p] = sg_find_id(list->at, list->n, d->polygon_id[p]) != SIZE_MAX;
  }
  return true;
}

/* The numbers of faces and chords that are new: they go on from the largest. */
static bool
are_numbers_left(sg_call *call, const sg_development *d)
{
  const sg_dense *of = &d->dense;
  int64_t polygon = of->polygons ? of->polygon_id[of->polygons - 1] : 0;
  int64_t edge = of->edges ? of->edge_id[of->edges - 1] : 0;

  return (polygon + (int64_t)d->faces.bent_faces <= INT32_MAX &&
          edge + (int64_t)d->faces.chords <= INT32_MAX) ||
         sg_call_cannot_hold(call, "int32");
}

static bool
make(sg_call *call, sg_development *d, const sg_int_list *removed_ids)
{
  bool stopped, *removed;

  if (!sg_dense_read(call, &d->s, 1, &d->dense) ||
      !find_removed(call, removed_ids, &d->dense, &removed)) {
    return false;
  }
  return (sg_flat_faces_make(&d->dense, removed, d->tolerance, &call->cancel,
                             &d->faces, &stopped) &&
          sg_joints_make(&d->faces, &d->dense, d->tolerance, &call->cancel,
                         &d->joints, &stopped) &&
          sg_flattening_make(&d->dense, &d->faces, &d->joints, &call->cancel,
                             &d->flattening, &stopped))
             ? are_numbers_left(call, d)
             : sg_call_ended(call);
}

bool
sg_door_flattening_open(sg_call *call, int32_t s, double tolerance,
                        const sg_int_list *removed, sg_development **out)
{
  sg_development *d = calloc(1, sizeof *d);

  if (!d) {
    return sg_call_no_memory(call);
  }
  d->s = s;
  d->tolerance = tolerance;
  if (!make(call, d, removed)) {
    sg_development_free(d);
    return false;
  }
  *out = d;
  return true;
}

/* ---- joints ------------------------------------------------------------- */

bool
sg_development_joint(sg_call *call, const sg_development *d, int32_t j,
                     int argument, uint32_t *out)
{
  *out = (uint32_t)j - 1;
  return (size_t)j <= d->joints.n || sg_call_missing(call, "joint", argument);
}

/* Joints as they are numbered, from 1. */
static bool
joints_of(sg_call *call, const uint32_t *joint, size_t n, sg_int_list *out)
{
  for (size_t i = 0; i < n; i++) {
    if (sg_cancel_every(&call->cancel, i) ||
        !sg_int_list_add(call, out, (int32_t)joint[i] + 1)) {
      return false;
    }
  }
  return true;
}

/* ---- joining ------------------------------------------------------------ */

bool
sg_door_forbid_joint(sg_call *call, sg_development *d, int32_t number)
{
  uint32_t j;

  if (!sg_development_joint(call, d, number, 2, &j)) {
    return false;
  }
  if (d->flattening.state[j] == SG_JOINT_JOINED) {
    return sg_call_forbidden(call, "forbid", "joint", 2);
  }
  d->flattening.state[j] = SG_JOINT_FORBIDDEN;
  return true;
}

bool
sg_door_join_faces(sg_call *call, sg_development *d, int32_t number,
                   sg_join_result *result)
{
  uint32_t j;
  sg_joint_state state;
  bool stopped;

  if (!sg_development_joint(call, d, number, 2, &j)) {
    return false;
  }
  if (!sg_flattening_join(&d->flattening, j, &call->cancel, &state, &stopped)) {
    return sg_call_ended(call);
  }
  result->is = (unsigned)state;
  if (state == SG_JOINT_OVERLAP) {
    const uint32_t *face = d->flattening.overlap;

    result->overlap.polygon1 = sg_development_polygon(d, face[0]);
    result->overlap.polygon2 = sg_development_polygon(d, face[1]);
  }
  return true;
}

/* The order of this number, free() it. Null: refused. */
static uint32_t *
make_order(sg_call *call, const sg_development *d, size_t number)
{
  bool stopped;
  uint32_t *order =
      sg_joint_order(&d->flattening, (unsigned)number, &call->cancel, &stopped);

  if (!order) {
    sg_call_ended(call);
  }
  return order;
}

bool
sg_door_joint_order(sg_call *call, sg_development *d, size_t number,
                    sg_int_list *joints)
{
  uint32_t *order = make_order(call, d, number);
  bool good = order && joints_of(call, order, d->joints.n, joints);

  free(order);
  return good;
}

/* The first joints of an order, up to joint `end`. */
static bool
join(sg_call *call, sg_development *d, size_t number, uint32_t end)
{
  uint32_t *order = make_order(call, d, number);
  bool stopped;
  size_t n = 0;

  if (!order) {
    return false;
  }
  while (n < d->joints.n && order[n] != end &&
         !sg_cancel_every(&call->cancel, n + 1)) {
    n++;
  }
  bool good = !call->stopped && sg_flattening_join_all(&d->flattening, order, n,
                                                       &call->cancel, &stopped);
  free(order);
  return good || sg_call_ended(call);
}

bool
sg_door_join_all(sg_call *call, sg_development *d, size_t order)
{
  return join(call, d, order, SG_NO_JOINT);
}

bool
sg_door_join_before(sg_call *call, sg_development *d, size_t order,
                    int32_t number)
{
  uint32_t j;

  return sg_development_joint(call, d, number, 3, &j) &&
         join(call, d, order, j);
}

bool
sg_door_joint_path(sg_call *call, sg_development *d, int32_t number,
                   sg_int_list *joints)
{
  uint32_t j;

  if (!sg_development_joint(call, d, number, 2, &j)) {
    return false;
  }
  const uint32_t *face = d->joints.joint[j].face;

  return sg_development_path(call, d, face[1], face[0], joints);
}

bool
sg_development_path(sg_call *call, sg_development *d, uint32_t from,
                    uint32_t to, sg_int_list *joints)
{
  size_t n;
  bool stopped;
  uint32_t *path =
      sg_flattening_path(&d->flattening, from, to, &call->cancel, &n, &stopped);
  bool good = path ? joints_of(call, path, n, joints) : sg_call_ended(call);

  free(path);
  return good;
}

/* ---- laying out --------------------------------------------------------- */

/* The first face of polygon p; 0: no root. */
static bool
find_root(sg_call *call, const sg_development *d, int32_t p, uint32_t *out)
{
  *out = SG_NO_FACE;
  for (uint32_t face = 0; face < d->faces.faces && p != 0; face++) {
    if (sg_cancel_every(&call->cancel, face)) {
      return false;
    }
    if (d->dense.polygon_id[d->faces.polygon[face]] == p) {
      *out = face;
      return true;
    }
  }
  return p == 0 || sg_call_missing(call, "polygon", 2);
}

bool
sg_door_flattening_lay(sg_call *call, sg_development *d, int32_t root)
{
  sg_lay_input in = {0};
  bool stopped;

  if (!find_root(call, d, root, &in.root)) {
    return false;
  }
  in.flattening = &d->flattening;
  in.touch = SG_LAY_TOUCH * d->flattening.size;
  sg_layout_clear(&d->layout);
  d->laid = sg_lay(&in, &call->cancel, &d->layout, &stopped);
  return d->laid || sg_call_ended(call);
}

bool
sg_development_is_laid(sg_call *call, const sg_development *d)
{
  return d->laid || sg_call_forbidden(call, "lay", "flattening", 1);
}

bool
sg_door_flattening_measures(sg_call *call, sg_development *d,
                            sg_flat_measures *out)
{
  sg_measures m;
  bool stopped;

  if (!sg_development_is_laid(call, d)) {
    return false;
  }
  if (!sg_measure(&d->flattening, &d->layout, &call->cancel, &m, &stopped)) {
    return sg_call_ended(call);
  }
  *out = (sg_flat_measures){.seam = m.seam,
                            .pieces = d->layout.pieces,
                            .longest = m.longest,
                            .area = m.area,
                            .sheet = m.sheet,
                            .tests = d->flattening.tests,
                            .refused = d->flattening.refused};
  return true;
}

bool
sg_door_flattening_restart(sg_call *call, sg_development *d)
{
  d->laid = false;
  return sg_flattening_restart(&d->flattening, &call->cancel);
}
