/* work_rows.c -- the scratch relation of one polygon: filling, changes.
 * work_join_rows.c has the relations over it.
 */
#include "work_rows.h"

#include "doors/work.h"
#include "plane.h"

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

bool
sg_door_work_open(sg_call *call, int32_t s, int32_t p, sg_work **out)
{
  const sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.i = p}};
  sg_world *world = sg_call_world(call);
  double normal[3];

  if (!world) {
    return false;
  }
  const sg_version *version = sg_world_version(world);
  sg_row row = sg_version_find(version, SG_P, key);
  sg_work *work = NULL;
  bool good = row != SG_NO_ROW || sg_call_missing(call, "polygon", 2);

  if (good) {
    const polygon rows = {version, s,
                          sg_version_value(version, SG_P, row, 2).list};

    polygon_normal(&rows, normal);
    work = sg_work_open(normal);
    good = (work && fill(work, &rows)) || sg_call_no_memory(call);
  }
  sg_version_drop(version);
  if (!good) {
    sg_work_close(work);
    return false;
  }
  *out = work;
  return true;
}

/* ---- changes ------------------------------------------------------------ */

bool
sg_work_known(sg_call *call, const sg_work *work, int32_t id, int32_t *out)
{
  *out = sg_work_find(work, id);
  return *out != SG_WORK_NONE || sg_call_missing_id(call, "work_vertex", id);
}

bool
sg_work_known_ends(sg_call *call, const sg_work *work, int32_t v1, int32_t v2,
                   int argument, int32_t out[2])
{
  return sg_work_known(call, work, v1, &out[0]) &&
         sg_work_known(call, work, v2, &out[1]) &&
         (out[0] != out[1] || sg_call_domain(call, "another_vertex", argument));
}

static bool
has_edge(sg_call *call, const sg_work *work, int32_t e)
{
  return sg_work_get(work, e) || sg_call_missing(call, "work_edge", 2);
}

bool
sg_door_work_add(sg_call *call, sg_work *work, int32_t v1, int32_t v2,
                 int32_t et, int64_t label, int32_t *e)
{
  int32_t v[2];

  if (!sg_work_known_ends(call, work, v1, v2, 3, v)) {
    return false;
  }
  if (et != 0 && et != 1) {
    return sg_call_domain(call, "edge_type", 4);
  }
  *e = sg_work_add(work, v[0], v[1], et, label);
  return *e || sg_call_no_memory(call);
}

bool
sg_door_work_delete(sg_call *call, sg_work *work, int32_t e)
{
  if (!has_edge(call, work, e)) {
    return false;
  }
  sg_work_delete(work, e);
  return true;
}

bool
sg_door_work_resolve(sg_call *call, sg_work *work, double reach)
{
  return sg_work_resolve_asking(work, reach, &call->cancel) == SG_DONE ||
         sg_call_ended(call);
}

bool
sg_door_work_gap(sg_call *call, sg_work *work, int32_t *v)
{
  int32_t gap = sg_work_unbalanced(work);

  (void)call;
  if (gap == SG_WORK_NONE) {
    return false;
  }
  *v = sg_work_id(work, gap);
  return true;
}
