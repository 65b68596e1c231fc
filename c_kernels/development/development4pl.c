/* development4pl.c -- faces being joined flat (documented in
 * kernel/pattern.pl).
 *
 * Layer: glue.
 */
#include "development4pl.h"

#include "glue.h"
#include "measure.h"
#include "rows/dense4pl.h"

#include "engine/install.h"

#include <SWI-Stream.h>
#include <stdlib.h>
#include <string.h>

static atom_t state_atom[SG_JOINT_CLOSED + 1];

/* ---- the handle --------------------------------------------------------- */

static void
clear(sg_development *d)
{
  sg_layout_clear(&d->layout);
  sg_flattening_clear(&d->flattening);
  sg_joints_clear(&d->joints);
  sg_flat_faces_clear(&d->faces);
  sg_dense_clear(&d->dense);
  d->s = 0;
}

static int
release_handle(atom_t atom)
{
  sg_development *d = PL_blob_data(atom, NULL, NULL);

  if (d->s != 0) {
    clear(d);
  }
  free(d);
  return TRUE;
}

static int
write_handle(IOSTREAM *out, atom_t atom, int flags)
{
  const sg_development *d = PL_blob_data(atom, NULL, NULL);

  (void)flags;
  Sfprintf(out, d->s ? "<sg_flattening>(%d)" : "<sg_flattening>(closed)", d->s);
  return TRUE;
}

static PL_blob_t development_blob = {.magic = PL_BLOB_MAGIC,
                                     .flags = PL_BLOB_UNIQUE | PL_BLOB_NOCOPY,
                                     .name = "sg_flattening",
                                     .release = release_handle,
                                     .write = write_handle};

int
sg_get_development_ex(term_t t, sg_development **out)
{
  PL_blob_t *type;
  void *data;

  if (!PL_get_blob(t, &data, NULL, &type) || type != &development_blob) {
    return PL_is_variable(t) ? PL_instantiation_error(t)
                             : PL_type_error("flattening", t);
  }
  *out = data;
  return (*out)->s != 0 || PL_existence_error("flattening", t);
}

static int
stop_ex(bool stopped)
{
  return stopped ? FALSE : sg_no_memory();
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

static int
compare_ids(const void *a, const void *b)
{
  int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;

  return (x > y) - (x < y);
}

/* Which polygons are to be left out; null: none. */
static int
get_removed_ex(term_t list, const sg_dense *d, bool **out)
{
  int32_t *id;
  size_t n;

  *out = NULL;
  if (!sg_get_id_set_ex(list, &id, &n)) {
    return FALSE;
  }
  if (n > 0 && !(*out = calloc(d->polygons + 1, sizeof **out))) {
    free(id);
    return sg_no_memory();
  }
  bool stopped = false;

  for (size_t p = 0; n > 0 && p < d->polygons && !stopped; p++) {
    stopped = sg_poll_every(&sg_prolog_poll, p);
    (*out)[p] = bsearch(&d->polygon_id[p], id, n, sizeof *id, compare_ids);
  }
  free(id);
  if (stopped) {
    free(*out);
    *out = NULL;
  }
  return !stopped;
}

/* The numbers of faces and chords that are new: they go on from the largest. */
static int
are_numbers_left_ex(const sg_development *d)
{
  const sg_dense *of = &d->dense;
  int64_t polygon = of->polygons ? of->polygon_id[of->polygons - 1] : 0;
  int64_t edge = of->edges ? of->edge_id[of->edges - 1] : 0;

  return (polygon + (int64_t)d->faces.bent_faces <= INT32_MAX &&
          edge + (int64_t)d->faces.chords <= INT32_MAX) ||
         PL_representation_error("int32");
}

static int
make_ex(sg_development *d, term_t removed_list)
{
  bool stopped = false, *removed = NULL;

  if (!sg_get_dense_ex(&d->s, 1, &d->dense) ||
      !get_removed_ex(removed_list, &d->dense, &removed)) {
    return FALSE;
  }
  bool good = sg_flat_faces_make(&d->dense, removed, d->tolerance,
                                 &sg_prolog_poll, &d->faces, &stopped) &&
              sg_joints_make(&d->faces, &d->dense, d->tolerance,
                             &sg_prolog_poll, &d->joints, &stopped) &&
              sg_flattening_make(&d->dense, &d->faces, &d->joints,
                                 &sg_prolog_poll, &d->flattening, &stopped);
  free(removed);
  return good ? are_numbers_left_ex(d) : stop_ex(stopped);
}

/* flattening_open(+S, +Tolerance, +Removed, -Flattening) is det. */
static foreign_t
flattening_open(term_t s, term_t tolerance, term_t removed, term_t handle)
{
  sg_development *d = calloc(1, sizeof *d);

  if (!d) {
    return sg_no_memory();
  }
  if (!sg_get_id_ex(s, &d->s) || !sg_get_finite_ex(tolerance, &d->tolerance) ||
      !make_ex(d, removed)) {
    clear(d);
    free(d);
    return FALSE;
  }
  return PL_unify_blob(handle, d, sizeof *d, &development_blob);
}

/* flattening_close(+Flattening) is det. */
static foreign_t
flattening_close(term_t handle)
{
  sg_development *d;

  if (!sg_get_development_ex(handle, &d)) {
    return FALSE;
  }
  clear(d);
  return TRUE;
}

/* ---- joints ------------------------------------------------------------- */

int
sg_get_joint_ex(term_t t, const sg_development *d, uint32_t *out)
{
  int32_t j;

  if (!sg_get_id_ex(t, &j)) {
    return FALSE;
  }
  *out = (uint32_t)j - 1;
  return (size_t)j <= d->joints.n || PL_existence_error("joint", t);
}

atom_t
sg_joint_state_atom(sg_joint_state state)
{
  return state_atom[state];
}

/* ---- joining ------------------------------------------------------------ */

/* forbid_joint(+Flattening, +J) is det. */
static foreign_t
forbid_joint(term_t handle, term_t number)
{
  sg_development *d;
  uint32_t j;

  if (!sg_get_development_ex(handle, &d) || !sg_get_joint_ex(number, d, &j)) {
    return FALSE;
  }
  if (d->flattening.state[j] == SG_JOINT_JOINED) {
    return PL_permission_error("forbid", "joint", number);
  }
  d->flattening.state[j] = SG_JOINT_FORBIDDEN;
  return TRUE;
}

static int
unify_result(term_t t, const sg_development *d, sg_joint_state state)
{
  const uint32_t *face = d->flattening.overlap;

  return state != SG_JOINT_OVERLAP
             ? PL_unify_atom(t, state_atom[state])
             : PL_unify_term(t, PL_FUNCTOR_CHARS, "overlap", 2, PL_INT,
                             (int)sg_development_polygon(d, face[0]), PL_INT,
                             (int)sg_development_polygon(d, face[1]));
}

/* join_faces(+Flattening, +J, -Result) is det. */
static foreign_t
join_faces(term_t handle, term_t number, term_t result)
{
  sg_development *d;
  uint32_t j;
  sg_joint_state state;
  bool stopped;

  if (!sg_get_development_ex(handle, &d) || !sg_get_joint_ex(number, d, &j)) {
    return FALSE;
  }
  if (!sg_flattening_join(&d->flattening, j, &sg_prolog_poll, &state,
                          &stopped)) {
    return stop_ex(stopped);
  }
  return unify_result(result, d, state);
}

/* The order that t names: its number. Null: an exception. */
static uint32_t *
get_order_ex(term_t t, const sg_development *d)
{
  int32_t number;
  uint32_t *order;
  bool stopped = false;

  if (!sg_get_int32_ex(t, &number)) {
    return NULL;
  }
  if (number < 0) {
    PL_domain_error("not_less_than_zero", t);
    return NULL;
  }
  order = sg_joint_order(&d->flattening, (unsigned)number, &sg_prolog_poll,
                         &stopped);
  if (!order) {
    stop_ex(stopped);
  }
  return order;
}

static int
unify_joints(term_t list, const uint32_t *joint, size_t n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < n; i++) {
    if (sg_poll_every(&sg_prolog_poll, i) || !PL_unify_list(tail, head, tail) ||
        !PL_unify_int64(head, (int64_t)joint[i] + 1)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* joint_order(+Flattening, +Order, -Joints) is det. */
static foreign_t
joint_order(term_t handle, term_t number, term_t list)
{
  sg_development *d;
  uint32_t *order;

  if (!sg_get_development_ex(handle, &d) ||
      !(order = get_order_ex(number, d))) {
    return FALSE;
  }
  int good = unify_joints(list, order, d->joints.n);
  free(order);
  return good;
}

/* The first n joints of an order that has joint `end` there. */
static int
join_ex(sg_development *d, term_t number, uint32_t end)
{
  uint32_t *order = get_order_ex(number, d);
  bool stopped = false;
  size_t n = 0;

  if (!order) {
    return FALSE;
  }
  while (n < d->joints.n && order[n] != end && !stopped) {
    stopped = sg_poll_every(&sg_prolog_poll, ++n);
  }
  bool good = !stopped && sg_flattening_join_all(&d->flattening, order, n,
                                                 &sg_prolog_poll, &stopped);
  free(order);
  return good || stop_ex(stopped);
}

/* join_all(+Flattening, +Order) is det. */
static foreign_t
join_all(term_t handle, term_t number)
{
  sg_development *d;

  return sg_get_development_ex(handle, &d) && join_ex(d, number, SG_NO_JOINT);
}

/* join_before(+Flattening, +Order, +J) is det. */
static foreign_t
join_before(term_t handle, term_t number, term_t joint)
{
  sg_development *d;
  uint32_t j;

  return sg_get_development_ex(handle, &d) && sg_get_joint_ex(joint, d, &j) &&
         join_ex(d, number, j);
}

/* joint_path(+Flattening, +J, -Joints) is det. */
static foreign_t
joint_path(term_t handle, term_t number, term_t list)
{
  sg_development *d;
  uint32_t j, *path;
  size_t n;
  bool stopped;

  if (!sg_get_development_ex(handle, &d) || !sg_get_joint_ex(number, d, &j)) {
    return FALSE;
  }
  const uint32_t *face = d->joints.joint[j].face;

  path = sg_flattening_path(&d->flattening, face[1], face[0], &sg_prolog_poll,
                            &n, &stopped);
  if (!path) {
    return stop_ex(stopped);
  }
  int good = unify_joints(list, path, n);
  free(path);
  return good;
}

/* ---- laying out --------------------------------------------------------- */

/* The first face of polygon P; 0: no root. */
static int
get_root_ex(term_t t, const sg_development *d, uint32_t *out)
{
  int32_t p;

  *out = SG_NO_FACE;
  if (!sg_get_int32_ex(t, &p)) {
    return FALSE;
  }
  for (uint32_t face = 0; face < d->faces.faces && p != 0; face++) {
    if (sg_poll_every(&sg_prolog_poll, face)) {
      return FALSE;
    }
    if (d->dense.polygon_id[d->faces.polygon[face]] == p) {
      *out = face;
      return TRUE;
    }
  }
  return p == 0 || PL_existence_error("polygon", t);
}

/* flattening_lay(+Flattening, +Root) is det. */
static foreign_t
flattening_lay(term_t handle, term_t root)
{
  sg_development *d;
  sg_lay_input in = {0};
  bool stopped = false;

  if (!sg_get_development_ex(handle, &d) || !get_root_ex(root, d, &in.root)) {
    return FALSE;
  }
  in.flattening = &d->flattening;
  in.touch = SG_LAY_TOUCH * d->flattening.size;
  sg_layout_clear(&d->layout);
  d->laid = sg_lay(&in, &sg_prolog_poll, &d->layout, &stopped);
  return d->laid || stop_ex(stopped);
}

int
sg_development_is_laid_ex(const sg_development *d, term_t handle)
{
  return d->laid || PL_permission_error("lay", "flattening", handle);
}

/* flattening_measures(+Flattening, -Measures) is det. */
static foreign_t
flattening_measures(term_t handle, term_t out)
{
  sg_development *d;
  sg_measures m;
  bool stopped;

  if (!sg_get_development_ex(handle, &d) ||
      !sg_development_is_laid_ex(d, handle)) {
    return FALSE;
  }
  if (!sg_measure(&d->flattening, &d->layout, &sg_prolog_poll, &m, &stopped)) {
    return stop_ex(stopped);
  }
  return PL_unify_term(
      out, PL_FUNCTOR_CHARS, "measures", 7, PL_FLOAT, m.seam + 0.0, PL_INT64,
      (int64_t)d->layout.pieces, PL_FLOAT, m.longest + 0.0, PL_FLOAT,
      m.area + 0.0, PL_FLOAT, m.sheet + 0.0, PL_INT64,
      (int64_t)d->flattening.tests, PL_INT64, (int64_t)d->flattening.refused);
}

/* flattening_restart(+Flattening) is det. */
static foreign_t
flattening_restart(term_t handle)
{
  sg_development *d;

  if (!sg_get_development_ex(handle, &d)) {
    return FALSE;
  }
  d->laid = false;
  return sg_flattening_restart(&d->flattening, &sg_prolog_poll);
}

void
sg_install_development(void)
{
  static const char *const name[] = {"open",    "joined",    "same_piece",
                                     "overlap", "forbidden", "short",
                                     "closed"};
  static const PL_extension doors[] = {
      {"flattening_open", 4, (pl_function_t)flattening_open, 0},
      {"flattening_close", 1, (pl_function_t)flattening_close, 0},
      {"flattening_restart", 1, (pl_function_t)flattening_restart, 0},
      {"flattening_lay", 2, (pl_function_t)flattening_lay, 0},
      {"flattening_measures", 2, (pl_function_t)flattening_measures, 0},
      {"forbid_joint", 2, (pl_function_t)forbid_joint, 0},
      {"join_faces", 3, (pl_function_t)join_faces, 0},
      {"joint_order", 3, (pl_function_t)joint_order, 0},
      {"joint_path", 3, (pl_function_t)joint_path, 0},
      {"join_all", 2, (pl_function_t)join_all, 0},
      {"join_before", 3, (pl_function_t)join_before, 0},
      {NULL, 0, NULL, 0}};

  for (int k = 0; k <= SG_JOINT_CLOSED; k++) {
    state_atom[k] = PL_new_atom(name[k]);
  }
  PL_register_extensions_in_module("sg_kernel_pattern", doors);
}
