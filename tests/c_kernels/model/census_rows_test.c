/* census_rows_test.c -- cubes counted, measured and found defective, through
 * the functions of the doors, without Prolog.
 *
 * covers: border_rows, census, census_kept_rows
 */
#include "doors/world.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <math.h>
#include <string.h>

static sg_call call;

static void
counts(void)
{
  sg_census_part_list parts = {0};
  const sg_census_part *p;

  CHECK_DOOR("census", sg_door_census(&call, &parts) && parts.n == 2);
  p = &parts.at[0];
  CHECK("a cube", p->segment == 1 && p->counts.vertices == 8 &&
                      p->counts.edges == 12 && p->counts.polygons == 6 &&
                      p->counts.triangles == 12);
  CHECK("its size", p->area == 6 && p->volume == 1 && p->length == 0 &&
                        p->box.low[2] == 0 && p->box.high[2] == 1);
  CHECK("its shell", p->shells.n == 1 && p->shells.at[0].euler == 2 &&
                         p->shells.at[0].closed);
  CHECK("nothing is wrong", p->defects.n == 0);
  p = &parts.at[1];
  CHECK("two cubes in one place", p->shells.n == 2 && p->volume == 2);
  CHECK("is wrong", p->defects.n > 0);
}

static bool
ask_all(sg_census_defect_rows *rows)
{
  *rows = (sg_census_defect_rows){0};
  return sg_door_census_defect(&call, NULL, NULL, NULL, rows);
}

static void
defects(void)
{
  sg_census_defect_rows rows;
  size_t twins = 0;

  CHECK_DOOR("defects", ask_all(&rows));
  for (size_t i = 0; i < rows.n; i++) {
    CHECK("of the second segment", rows.at[i].s == 2);
    twins += rows.at[i].kind == SG_DEFECT_TWIN;
  }
  CHECK("eight vertices twice", twins == 8);
}

static bool
same_row(const sg_census_defect_row *a, const sg_census_defect_row *b)
{
  return a->kind == b->kind && a->s == b->s && a->a == b->a && a->b == b->b;
}

/* Whether what is asked for is what is told of all, in that order. `given`: a
 * bit for each of kind, segment and A. */
static bool
is_asked_right(const sg_census_defect_rows *all, sg_census_defect_row of,
               int given)
{
  sg_census_defect_rows some = {0};
  size_t n = 0;
  bool good = sg_door_census_defect(&call, given & 1 ? &of.kind : NULL,
                                    given & 2 ? &of.s : NULL,
                                    given & 4 ? &of.a : NULL, &some);

  for (size_t i = 0; i < all->n; i++) {
    const sg_census_defect_row *d = &all->at[i];

    if ((!(given & 1) || d->kind == of.kind) &&
        (!(given & 2) || d->s == of.s) && (!(given & 4) || d->a == of.a)) {
      good = good && n < some.n && same_row(d, &some.at[n++]);
    }
  }
  return good && n == some.n;
}

/* Vertices that nothing uses: two of segment 1, one of segment 2. */
static bool
add_unused(void)
{
  const int32_t s[] = {1, 1, 2}, v[] = {901, 902, 901};
  const double x[] = {7, 8, 9};

  return sg_world_add_many(call.world, SG_V, 3, (const void *[]){s, v, x, x, x},
                           NULL) == SG_OK;
}

static void
one_by_one(void)
{
  sg_census_defect_rows all;
  bool good = true;

  sg_world_begin(call.world);
  CHECK("vertices", add_unused());
  CHECK("they are there", sg_world_commit(call.world) == SG_OK);
  sg_call_rest(&call);
  CHECK_DOOR("all", ask_all(&all) && all.n == 11);
  for (size_t i = 0; i < all.n; i++) {
    for (int given = 0; given < 8; given++) {
      sg_census_defect_row none = all.at[i];

      none.a = 1000;
      good = good && is_asked_right(&all, all.at[i], given) &&
             is_asked_right(&all, none, given);
    }
  }
  CHECK("some are those of all", good);
  CHECK("without them", sg_world_undo(call.world) == SG_OK);
  sg_call_rest(&call);
}

static void
parts_and_shells(void)
{
  const int32_t s[3] = {1, 2, 3}, seven = 7;
  sg_census_part_rows part = {0}, parts = {0}, none = {0};
  sg_census_shell_rows shells = {0}, one = {0};

  CHECK_DOOR("all parts", sg_door_census_part(&call, NULL, &parts) &&
                              parts.n == 2 && parts.at[1].s == 2);
  CHECK_DOOR("one part", sg_door_census_part(&call, &s[1], &part) &&
                             part.n == 1 && part.at[0].part.volume == 2);
  CHECK_DOOR("no part",
             sg_door_census_part(&call, &s[2], &none) && none.n == 0);
  CHECK_DOOR("all shells", sg_door_census_shell(&call, NULL, NULL, &shells) &&
                               shells.n == 3 && shells.at[0].shells == 1 &&
                               shells.at[2].shells == 2);
  CHECK_DOOR("one shell", sg_door_census_shell(&call, &s[1], &seven, &one) &&
                              one.n == 1 && one.at[0].p == 7 &&
                              one.at[0].shell.volume == 1);
}

/* What is kept is not told of other rows, and told again after undo. */
static void
changed(void)
{
  sg_census_defect_rows before, moved, after;

  CHECK_DOOR("before", ask_all(&before));
  sg_world_begin(call.world);
  CHECK("another", add_cube_again(call.world, 1, 1));
  CHECK("it ends", sg_world_commit(call.world) == SG_OK);
  sg_call_rest(&call);
  CHECK_DOOR("there are more",
             ask_all(&moved) && moved.n > before.n && moved.at[0].s == 1);
  CHECK("undone", sg_world_undo(call.world) == SG_OK);
  sg_call_rest(&call);
  CHECK_DOOR("as before", ask_all(&after) && after.n == before.n);
}

/* Behind the last edge of the last polygon there is nothing to read. */
static void
without_edges(void)
{
  const int32_t s = 3, p = 1, none[1] = {0};
  const int32_t *list = none;
  sg_census_defect_rows all;

  sg_world_begin(call.world);
  CHECK("a polygon without edges",
        sg_world_add_many(call.world, SG_P, 1, (const void *[]){&s, &p, &list},
                          NULL) == SG_OK);
  sg_call_rest(&call);
  CHECK_DOOR("is flat", ask_all(&all) && all.n > 0 &&
                            all.at[all.n - 1].s == s &&
                            all.at[all.n - 1].kind == SG_DEFECT_FLAT);
  CHECK("it goes", sg_world_rollback(call.world) == SG_OK);
  sg_call_rest(&call);
}

static bool
stop(void *data)
{
  (void)data;
  return true;
}

/* A triangle alone has borders, a cube has none. */
static void
borders(void)
{
  const int32_t s[3] = {3, 3, 3}, id[3] = {1, 2, 3}, next[3] = {2, 3, 1};
  const int32_t real[3] = {1, 1, 1}, edges[4] = {3, 1, 2, 3};
  const int32_t *list = edges;
  const double x[3] = {0, 1, 0}, y[3] = {0, 0, 1}, z[3] = {0, 0, 0};
  sg_int_list of[2] = {{0}};

  sg_world_begin(call.world);
  CHECK("a triangle",
        sg_world_add_many(call.world, SG_V, 3, (const void *[]){s, id, x, y, z},
                          NULL) == SG_OK &&
            sg_world_add_many(call.world, SG_E, 3,
                              (const void *[]){s, id, id, next, real},
                              NULL) == SG_OK &&
            sg_world_add_many(call.world, SG_P, 1,
                              (const void *[]){s, id, &list}, NULL) == SG_OK);
  sg_call_rest(&call);
  CHECK_DOOR("its borders", sg_door_segment_borders(&call, 3, &of[0]) &&
                                of[0].n == 3 &&
                                memcmp(of[0].at, id, sizeof id) == 0);
  CHECK_DOOR("of a cube none",
             sg_door_segment_borders(&call, 1, &of[1]) && of[1].n == 0);
  CHECK("it goes", sg_world_rollback(call.world) == SG_OK);
  sg_call_rest(&call);
}

int
main(void)
{
  static const sg_cancel now = {stop, NULL};
  sg_world *world = sg_world_open();

  sg_call_open(&call, &now, NULL);
  call.world = world;
  CHECK("cubes", add_cube(world, 1) && add_cube(world, 2) &&
                     add_cube_again(world, 2, 1));
  CHECK("stopped", !sg_door_census(&call, &(sg_census_part_list){0}) &&
                       call.refusal.how == SG_REFUSED_NOTHING);
  sg_call_close(&call);
  sg_call_open(&call, NULL, NULL);
  call.world = world;
  counts();
  borders();
  defects();
  one_by_one();
  parts_and_shells();
  changed();
  without_edges();
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
