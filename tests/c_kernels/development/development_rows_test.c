/* development_rows_test.c -- a cube laid flat through the functions of the
 * doors, without Prolog.
 */
#include "development/development_rows.h"
#include "doors/pattern.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <math.h>
#include <string.h>

enum { CUBE = 1, PATTERN = 2 };

static sg_call call;

static size_t
rows_in(const sg_world *world, sg_relation relation)
{
  const sg_version *version = sg_world_version((sg_world *)world);
  size_t n = sg_version_count(version, relation);

  sg_version_drop(version);
  return n;
}

static sg_development *
opened(const sg_int_list *removed)
{
  sg_development *d = NULL;

  return sg_door_flattening_open(&call, CUBE, 1e-9, removed, &d) ? d : NULL;
}

static void
counts(sg_development *d)
{
  size_t faces, joints;
  double step;
  sg_int_list borders = {0};

  CHECK_DOOR("counts",
             sg_door_flattening_counts(&call, d, &faces, &joints, &step));
  CHECK("faces and joints", faces == 6 && joints == 12);
  CHECK_DOOR("borders", sg_door_flattening_borders(&call, d, &borders));
  CHECK("a cube has none", borders.n == 0);
}

static void
joins(sg_development *d)
{
  sg_joint_fact joint;
  sg_join_result result;
  sg_int_list order = {0}, path = {0};
  int32_t j = 0;

  CHECK_DOOR("order", sg_door_joint_order(&call, d, 0, &order));
  CHECK("each joint once", order.n == 12 && order.at[0] >= 1);
  CHECK_DOOR("a joint",
             sg_door_flattening_joint(&call, d, order.at[0], &joint));
  CHECK("a right angle", fabs(joint.angle - 90) < 1e-9);
  CHECK("not joined yet", joint.state == SG_JOINT_OPEN);
  CHECK_DOOR("edge", sg_door_edge_joint(&call, d, joint.edge2, &j));
  CHECK("its joint", j == order.at[0]);
  CHECK_DOOR("join", sg_door_join_faces(&call, d, j, &result));
  CHECK("joined", result.is == SG_JOIN_RESULT_JOINED);
  CHECK_DOOR("path", sg_door_joint_path(&call, d, j, &path));
  CHECK("over itself", path.n == 1 && path.at[0] == j);
  CHECK("joint 13", !sg_door_flattening_joint(&call, d, 13, &joint));
  CHECK("is missing",
        call.refusal.how == SG_REFUSED_EXISTENCE && call.refusal.argument == 2);
  call.refusal.how = SG_REFUSED_NOTHING;
}

static void
writes(sg_world *world, sg_development *d)
{
  sg_flat_measures m;

  CHECK("not laid", !sg_door_flattening_write(&call, d, PATTERN));
  CHECK("refused", call.refusal.how == SG_REFUSED_PERMISSION &&
                       !strcmp(call.refusal.action, "lay"));
  call.refusal.how = SG_REFUSED_NOTHING;
  CHECK_DOOR("join all", sg_door_join_all(&call, d, 0));
  CHECK("no polygon 9", !sg_door_flattening_lay(&call, d, 9));
  call.refusal.how = SG_REFUSED_NOTHING;
  CHECK_DOOR("lay", sg_door_flattening_lay(&call, d, 1));
  CHECK_DOOR("measures", sg_door_flattening_measures(&call, d, &m));
  CHECK("of a cube",
        m.pieces == 1 && fabs(m.area - 6) < 1e-12 && fabs(m.seam - 7) < 1e-12);
  CHECK_DOOR("write", sg_door_flattening_write(&call, d, PATTERN));
  CHECK("vertices", rows_in(world, SG_V) == 8 + 14);
  CHECK("pieces", rows_in(world, SG_PIECE) == 6);
  CHECK("joints", rows_in(world, SG_JOINT) == 12);
  CHECK("twice", !sg_door_flattening_write(&call, d, PATTERN));
  CHECK("is refused", call.refusal.how == SG_REFUSED_PERMISSION &&
                          call.refusal.number == PATTERN);
  call.refusal.how = SG_REFUSED_NOTHING;
}

/* Of a cube laid flat as joined by default, whose seams are seven edges. */
static void
exchanges(sg_development *d)
{
  const sg_int_list none = {0};
  sg_int_list path = {0}, folds = {0};
  sg_seam_bound bound;
  size_t helped;
  double before = 0, after = 0;

  CHECK_DOOR("joined", sg_door_flattening_restart(&call, d) &&
                           sg_door_join_all(&call, d, 0));
  CHECK_DOOR("seam", sg_door_seam_length(&call, d, &before) &&
                         fabs(before - 7) < 1e-12);
  CHECK_DOOR("exchange",
             sg_door_exchange_seams(&call, d, 0, &none,
                                    SG_EXCHANGE_OBJECTIVE_SEAM, 1000, &helped));
  CHECK_DOOR("no worse",
             sg_door_seam_length(&call, d, &after) && after <= before);
  CHECK_DOOR("a bound", sg_door_flattening_bound(&call, d, &bound));
  CHECK("is reached by a cube",
        fabs(bound.bound - 7) < 1e-9 && bound.bound <= after + 1e-9);
  CHECK_DOOR("folds between 1 and 6", sg_door_fold_path(&call, d, 1, 6, &path));
  CHECK("there are", path.n > 0 && path.n < 6);
  CHECK("no polygon 9", !sg_door_fold_path(&call, d, 1, 9, &folds) &&
                            call.refusal.how == SG_REFUSED_EXISTENCE &&
                            call.refusal.argument == 3);
  call.refusal.how = SG_REFUSED_NOTHING;
  CHECK_DOOR("these alone", sg_door_join_folds(&call, d, &path));
  CHECK_DOOR("are joined", sg_door_seam_length(&call, d, &after) &&
                               fabs(after - (12 - (double)path.n)) < 1e-12);
}

/* Joint 1 must not be joined; of the rest those before joint 2. */
static void
forbids(sg_development *d)
{
  sg_int_list bent = {0}, invalid = {0}, order = {0};
  sg_join_result result;
  sg_joint_fact joint;
  size_t joined = 0;

  CHECK_DOOR("every face is flat",
             sg_door_flattening_bent(&call, d, &bent) && bent.n == 0);
  CHECK_DOOR("and valid",
             sg_door_flattening_invalid(&call, d, &invalid) && invalid.n == 0);
  CHECK_DOOR("order", sg_door_joint_order(&call, d, 0, &order));
  CHECK_DOOR("forbid", sg_door_forbid_joint(&call, d, order.at[1]));
  CHECK_DOOR("before the third", sg_door_join_before(&call, d, 0, order.at[2]));
  for (int32_t j = 1; j <= 12; j++) {
    CHECK_DOOR("joint", sg_door_flattening_joint(&call, d, j, &joint));
    joined += joint.state == SG_JOINT_JOINED;
  }
  CHECK("is the first alone", joined == 1);
  CHECK_DOOR("not this", sg_door_join_faces(&call, d, order.at[1], &result) &&
                             result.is == SG_JOIN_RESULT_FORBIDDEN);
  CHECK("too late", !sg_door_forbid_joint(&call, d, order.at[0]) &&
                        call.refusal.how == SG_REFUSED_PERMISSION);
  call.refusal.how = SG_REFUSED_NOTHING;
}

int
main(void)
{
  int32_t gone[] = {2, 5};
  const sg_int_list none = {0}, two = {gone, 2, 2};
  sg_world *world = sg_world_open();
  size_t faces, joints;
  double step;

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("a cube", world && add_cube(world, CUBE));
  sg_development *d = NULL;

  CHECK_DOOR("open", (d = opened(&none)) != NULL);
  counts(d);
  joins(d);
  writes(world, d);
  exchanges(d);
  sg_development_free(d);
  d = opened(&none);
  forbids(d);
  sg_development_free(d);
  d = opened(&two);
  CHECK_DOOR("without two",
             sg_door_flattening_counts(&call, d, &faces, &joints, &step));
  CHECK("are four", faces == 4);
  sg_development_free(d);
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
