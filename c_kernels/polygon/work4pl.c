/* work4pl.c -- the scratch relation of one polygon, as predicates: handles,
 * filling, changes. work_join4pl.c has the relations over it.
 *
 * Layer: glue. Doors in rules/kernel/work.pl. Vertices are named by their ids.
 */
#include "engine/install.h"
#include "engine/world4pl.h"

#include "work4pl.h"

#include "glue.h"
#include "plane.h"

#include <SWI-Stream.h>

#include <stdlib.h>

/* ---- handles ------------------------------------------------------------ */

/* What a handle points at. */
typedef struct holder {
  sg_work *work; /* null: closed */
} holder;

static int
release_handle(atom_t atom)
{
  holder *h = PL_blob_data(atom, NULL, NULL);

  sg_work_close(h->work);
  free(h);
  return TRUE;
}

static int
write_handle(IOSTREAM *out, atom_t atom, int flags)
{
  (void)flags;
  Sfprintf(out, "<sg_work>(%p)", PL_blob_data(atom, NULL, NULL));
  return TRUE;
}

static PL_blob_t work_blob = {
    .magic = PL_BLOB_MAGIC,
    .flags = PL_BLOB_UNIQUE | PL_BLOB_NOCOPY,
    .name = "sg_work",
    .release = release_handle,
    .write = write_handle,
};

int
sg_unify_work(term_t t, sg_work *work)
{
  holder *h = malloc(sizeof *h);

  if (!h) {
    sg_work_close(work);
    return sg_no_memory();
  }
  h->work = work;
  return PL_unify_blob(t, h, sizeof *h, &work_blob);
}

static int
get_holder_ex(term_t t, holder **out)
{
  void *data;
  PL_blob_t *type;

  if (PL_get_blob(t, &data, NULL, &type) && type == &work_blob) {
    *out = data;
    return TRUE;
  }
  return PL_is_variable(t) ? PL_instantiation_error(t)
                           : PL_type_error("work", t);
}

int
sg_get_work_ex(term_t t, sg_work **out)
{
  holder *h;

  if (!get_holder_ex(t, &h)) {
    return FALSE;
  }
  *out = h->work;
  return h->work != NULL || PL_existence_error("work", t);
}

/* work_close(+Work) is det. */
static foreign_t
work_close(term_t work)
{
  holder *h;

  if (!get_holder_ex(work, &h)) {
    return FALSE;
  }
  sg_work_close(h->work);
  h->work = NULL;
  return TRUE;
}

/* ---- filling ------------------------------------------------------------ */

/* A polygon as its rows. */
typedef struct polygon {
  const sg_version *version;
  int32_t s;
  const int32_t *edge; /* its length first */
} polygon;

static void
position(const polygon *p, int32_t v, double out[3])
{
  const sg_value key[SG_MAX_COLUMNS] = {{.i = p->s}, {.i = v}};
  sg_row row = sg_version_find(p->version, SG_V, key);

  for (unsigned k = 0; k < 3; k++) {
    out[k] = sg_version_value(p->version, SG_V, row, 2 + k).f;
  }
}

static void
edge_ends(const polygon *p, int32_t e, int32_t end[3]) /* and Et */
{
  const sg_value key[SG_MAX_COLUMNS] = {{.i = p->s}, {.i = e}};
  sg_row row = sg_version_find(p->version, SG_E, key);

  end[0] = sg_version_value(p->version, SG_E, row, 2).i;
  end[1] = sg_version_value(p->version, SG_E, row, 3).i;
  end[2] = sg_version_value(p->version, SG_E, row, 4).i;
}

static void
polygon_normal(const polygon *p, double out[3])
{
  sg_newell sum;
  sg_plane plane = {{0, 0, 1}, 0}; /* without an area: any will do */

  sg_newell_init(&sum);
  for (int32_t i = 1; i <= p->edge[0]; i++) {
    int32_t end[3];
    double a[3], b[3];
    edge_ends(p, p->edge[i], end);
    position(p, end[0], a);
    position(p, end[1], b);
    sg_newell_edge(&sum, a, b);
  }
  sg_newell_plane(&sum, &plane);
  for (int k = 0; k < 3; k++) {
    out[k] = plane.n[k];
  }
}

/* SG_WORK_NONE: no memory. */
static int32_t
enter(sg_work *work, const polygon *p, int32_t v)
{
  double at[3];
  sg_point point;

  position(p, v, at);
  sg_point_set(&point, at);
  return sg_work_vertex(work, v, &point);
}

static bool
fill(sg_work *work, const polygon *p)
{
  for (int32_t i = 1; i <= p->edge[0]; i++) {
    int32_t end[3];
    edge_ends(p, p->edge[i], end);
    int32_t a = enter(work, p, end[0]), b = enter(work, p, end[1]);
    if (a < 0 || b < 0 ||
        (a != b && !sg_work_add(work, a, b, end[2], p->edge[i]))) {
      return false;
    }
  }
  return true;
}

static int
find_polygon_ex(const sg_version *version, term_t s, term_t p, polygon *out)
{
  int32_t id[2];

  if (!sg_get_id_ex(s, &id[0]) || !sg_get_id_ex(p, &id[1])) {
    return FALSE;
  }
  const sg_value key[SG_MAX_COLUMNS] = {{.i = id[0]}, {.i = id[1]}};
  sg_row row = sg_version_find(version, SG_P, key);
  if (row == SG_NO_ROW) {
    return PL_existence_error("polygon", p);
  }
  *out =
      (polygon){version, id[0], sg_version_value(version, SG_P, row, 2).list};
  return TRUE;
}

/* work_open(+S, +P, -Work) is det. */
static foreign_t
work_open(term_t s, term_t p, term_t out)
{
  sg_world *world = sg_current_world_ex();
  sg_work *work = NULL;
  polygon rows = {0};
  double normal[3];

  if (!world) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  int ok = find_polygon_ex(version, s, p, &rows);
  if (ok) {
    polygon_normal(&rows, normal);
    work = sg_work_open(normal);
    ok = (work && fill(work, &rows)) || sg_no_memory();
  }
  sg_version_drop(version);
  if (!ok) {
    sg_work_close(work);
    return FALSE;
  }
  return sg_unify_work(out, work);
}

/* The handle of a vertex named by its id. */
int
sg_get_work_vertex_ex(sg_work *work, term_t t, int32_t *out)
{
  int32_t id;

  if (!sg_get_id_ex(t, &id)) {
    return FALSE;
  }
  *out = sg_work_find(work, id);
  return *out != SG_WORK_NONE || PL_existence_error("work_vertex", t);
}

/* Work and edge: Work, E. */
static int
get_edge_ex(term_t work_term, term_t e, sg_work **work, int32_t *edge)
{
  if (!sg_get_work_ex(work_term, work) || !sg_get_id_ex(e, edge)) {
    return FALSE;
  }
  return sg_work_get(*work, *edge) || PL_existence_error("work_edge", e);
}

/* work_add(+Work, +V1, +V2, +Et, +Label, -E) is det. */
static foreign_t
work_add(term_t a0, int arity, void *context)
{
  sg_work *work;
  int32_t v[2], et;
  int64_t label;

  (void)arity, (void)context;
  if (!sg_get_work_ex(a0, &work) ||
      !sg_get_work_vertex_ex(work, a0 + 1, &v[0]) ||
      !sg_get_work_vertex_ex(work, a0 + 2, &v[1]) ||
      !sg_get_int32_ex(a0 + 3, &et) || !PL_get_int64_ex(a0 + 4, &label)) {
    return FALSE;
  }
  if (v[0] == v[1]) {
    return PL_domain_error("another_vertex", a0 + 2);
  }
  if (et != 0 && et != 1) {
    return PL_domain_error("edge_type", a0 + 3);
  }
  int32_t e = sg_work_add(work, v[0], v[1], et, label);
  return e ? PL_unify_integer(a0 + 5, e) : sg_no_memory();
}

/* work_delete(+Work, +E) is det. */
static foreign_t
work_delete(term_t work_term, term_t e)
{
  sg_work *work;
  int32_t edge;

  if (!get_edge_ex(work_term, e, &work, &edge)) {
    return FALSE;
  }
  sg_work_delete(work, edge);
  return TRUE;
}

/* work_split(+Work, +E, +V, -E1, -E2) is det. */
static foreign_t
work_split(term_t work_term, term_t e, term_t v, term_t e1, term_t e2)
{
  sg_work *work;
  int32_t edge, vertex;

  if (!get_edge_ex(work_term, e, &work, &edge) ||
      !sg_get_work_vertex_ex(work, v, &vertex)) {
    return FALSE;
  }
  int32_t first = sg_work_split(work, edge, vertex);
  if (!first) {
    return sg_no_memory();
  }
  return PL_unify_integer(e1, first) && PL_unify_integer(e2, first + 1);
}

/* work_resolve(+Work, +Reach) is det. */
static foreign_t
work_resolve(term_t work_term, term_t reach_term)
{
  sg_work *work;
  double reach;

  return sg_get_work_ex(work_term, &work) &&
         sg_get_finite_ex(reach_term, &reach) &&
         (sg_work_resolve(work, reach) || sg_no_memory());
}

/* work_gap(+Work, -V) is semidet. */
static foreign_t
work_gap(term_t work_term, term_t v)
{
  sg_work *work;

  if (!sg_get_work_ex(work_term, &work)) {
    return FALSE;
  }
  int32_t gap = sg_work_unbalanced(work);
  return gap != SG_WORK_NONE && PL_unify_integer(v, sg_work_id(work, gap));
}

/* work_turn(+Work, +V1, +V2, +V3, -Turn) is det. */
static foreign_t
work_turn(term_t work_term, term_t v1, term_t v2, term_t v3, term_t turn)
{
  sg_work *work;
  int32_t v[3];

  return sg_get_work_ex(work_term, &work) &&
         sg_get_work_vertex_ex(work, v1, &v[0]) &&
         sg_get_work_vertex_ex(work, v2, &v[1]) &&
         sg_get_work_vertex_ex(work, v3, &v[2]) &&
         PL_unify_integer(turn, sg_work_turn(work, v[0], v[1], v[2]));
}

/* ---- registration ------------------------------------------------------- */

void
sg_install_work(void)
{
  static const PL_extension doors[] = {
      {"work_open", 3, (pl_function_t)work_open, 0},
      {"work_close", 1, (pl_function_t)work_close, 0},
      {"work_add", 6, (pl_function_t)work_add, PL_FA_VARARGS},
      {"work_delete", 2, (pl_function_t)work_delete, 0},
      {"work_split", 5, (pl_function_t)work_split, 0},
      {"work_resolve", 2, (pl_function_t)work_resolve, 0},
      {"work_gap", 2, (pl_function_t)work_gap, 0},
      {"work_turn", 5, (pl_function_t)work_turn, 0},
      {NULL, 0, NULL, 0}};

  PL_register_extensions_in_module("sg_kernel_work", doors);
}
