/* near_joint_rows.c -- joints that are nearly straight vanish from the polygons
 * that their pieces entered.
 *
 * Layer: rows. The door is documented in rules/kernel/penetration.pl; its rule
 * is tests/oracle/near_joints.pl.
 */
#include "cut_rows.h"

#include "doors/penetration.h"
#include "rows/key_table.h"

/* A vertex of a polygon in which a joint is. */
typedef struct bend {
  sg_work *work;
  int32_t v;
} bend;

/* The oldest edge into the vertex and the oldest one out of it that do not go
 * there and back: their ends. False: there are none. */
static bool
find_ends(const bend *at, int32_t end[2])
{
  for (int32_t e = 0; (e = sg_work_entering(at->work, at->v, e));) {
    end[0] = sg_work_get(at->work, e)->start;
    for (int32_t f = 0; (f = sg_work_leaving(at->work, at->v, f));) {
      end[1] = sg_work_get(at->work, f)->end;
      if (end[1] != end[0]) {
        return true;
      }
    }
  }
  return false;
}

/* Whether the edge that would replace those through the vertex meets no other.
 * -1: no memory. */
static int
is_free(const bend *at)
{
  int32_t end[2];
  int meets = find_ends(at, end)
                  ? sg_work_meeting_but(at->work, end[0], end[1], at->v)
                  : 1;

  return meets < 0 ? -1 : !meets;
}

/* The oldest edge out of the vertex that does not go to `start`, 0: none. */
static int32_t
goes_on(const bend *at, int32_t start)
{
  int32_t f = 0;

  while ((f = sg_work_leaving(at->work, at->v, f)) &&
         sg_work_get(at->work, f)->end == start) {
  }
  return f;
}

/* The edges through the vertex become one, in each direction that is there.
 * False: no memory. */
static bool
merge_at(const bend *at)
{
  int32_t e, f;

  while ((e = sg_work_entering(at->work, at->v, 0)) &&
         (f = goes_on(at, sg_work_get(at->work, e)->start))) {
    sg_work_edge edge = *sg_work_get(at->work, e);
    int32_t end = sg_work_get(at->work, f)->end;

    sg_work_delete(at->work, e);
    sg_work_delete(at->work, f);
    if (!sg_work_add(at->work, edge.start, end, edge.et, edge.label)) {
      return false;
    }
  }
  return true;
}

typedef struct merging {
  sg_cut_handle *handle;
  const sg_entered_polygon_list *works;
  sg_key_table number; /* segment, polygon -> of works */
} merging;

/* Where the joint is in polygon k of its piece. False: not there. */
static bool
find_bend(const merging *m, uint32_t point, const sg_cut_piece *piece, int k,
          bend *out)
{
  uint32_t key[2] = {(uint32_t)piece->s[k], (uint32_t)piece->p[k]};
  uint32_t number = sg_key_table_get(&m->number, key);
  int32_t name = sg_cut_points_name(&m->handle->set.points, point, piece->s[k]);

  if (number == SG_NO_KEY || name == 0) {
    return false;
  }
  out->work = m->works->at[number].work;
  out->v = sg_work_find(out->work, name);
  return out->v != SG_WORK_NONE;
}

static bool
merge(sg_call *call, merging *m, const sg_piece_joint *joint)
{
  uint32_t point = (uint32_t)joint->point, pieces[2];
  bend at[2];
  int fits = 1;

  for (int k = 0; k < 2 && fits > 0; k++) {
    fits = find_bend(m, point, &joint->piece1, k, &at[k]) ? is_free(&at[k]) : 0;
  }
  if (fits <= 0) {
    return fits == 0 || sg_call_no_memory(call);
  }
  if (!sg_cut_set_joint(&m->handle->set, point, &pieces[0], &pieces[1])) {
    return sg_call_domain(call, "joint", 2);
  }
  sg_cut_set_join(&m->handle->set, point);
  return (merge_at(&at[0]) && merge_at(&at[1])) || sg_call_no_memory(call);
}

static bool
number_works(sg_call *call, merging *m)
{
  for (size_t i = 0; i < m->works->n; i++) {
    const sg_entered *one = &m->works->at[i];
    uint32_t *number = sg_key_table_put(
        &m->number, (uint32_t[2]){(uint32_t)one->s, (uint32_t)one->p});

    if (!number) {
      return sg_call_no_memory(call);
    }
    *number = (uint32_t)i;
  }
  return true;
}

bool
sg_door_cut_merge_near(sg_call *call, sg_cut_handle *handle,
                       const sg_piece_joint_list *joints,
                       const sg_entered_polygon_list *works)
{
  merging m = {.handle = handle, .works = works};

  sg_key_table_init(&m.number, 2);
  bool good = number_works(call, &m);

  for (size_t i = 0; good && i < joints->n; i++) {
    const sg_piece_joint *joint = &joints->at[i];

    good = !sg_cancel_every(&call->cancel, i) &&
           (joint->point < handle->set.points.n ||
            sg_call_missing(call, "cut_point", 2)) &&
           merge(call, &m, joint);
  }
  sg_key_table_clear(&m.number);
  return good;
}
