/* cell_added_rows.c -- one more solid in a glue: only rows near it change. */
#include "cell_added_rows.h"
#include "cell_added.h"
#include "doors/gluing.h"
#include "engine/symbol.h"
#include "rows/append_rows.h"
#include "solid/coincident_faces.h"

#include <stdlib.h>
#include <string.h>

/* ---- the region that it is in ------------------------------------------- */

static size_t
side_of_polygon(const sg_cell_joiner *j, int32_t p)
{
  for (size_t i = 0; i < j->sides.n; i++) {
    if (sg_view_int(&j->sides.view, 1, j->sides.rows.row[i]) == p) {
      return i;
    }
  }
  return SIZE_MAX;
}

static bool
comes_out_of_box(const sg_cell_joiner *j)
{
  for (int k = 0; k < 3; k++) {
    if (j->low[k] + 2 * j->reach < j->least[k] ||
        j->high[k] - 2 * j->reach > j->most[k]) {
      return true;
    }
  }
  return false;
}

/* The region of the glue that the solid is in until now: beside what it shares
 * it is behind a polygon that runs as it does. 0: not known, or several. */
static int32_t
region_round(const sg_cell_joiner *j)
{
  int32_t region = 0;

  for (size_t i = 0; i < j->both.parts; i++) {
    const struct sg_solid_part *part = &j->both.part[i];
    size_t at = side_of_polygon(j, j->both.face[part->face].p);
    int32_t is = at == SIZE_MAX
                     ? 0
                     : sg_view_int(&j->sides.view, part->reversed ? 3 : 2,
                                   j->sides.rows.row[at]);

    if (is == 0 || (region != 0 && region != is)) {
      return 0;
    }
    region = is;
  }
  return region != 0 || !comes_out_of_box(j) ? region : j->before;
}

/* ---- regions ------------------------------------------------------------ */

/* The region that a side has from now on. */
static int32_t
renamed(const sg_cell_joiner *j, int32_t region)
{
  return region == j->before ? j->outside : region;
}

/* Whether the solid is now on a side of polygon p: 2 behind it, 3 before it. */
static int
side_inside(const sg_cell_joiner *j, int32_t p)
{
  for (size_t i = 0; i < j->both.parts; i++) {
    const struct sg_solid_part *part = &j->both.part[i];

    if (j->both.face[part->face].p == p) {
      return part->reversed ? 3 : 2;
    }
  }
  return 0;
}

static bool
write_sides(sg_cell_joiner *j, sg_world *world)
{
  sg_row *gone = sg_call_alloc(j->call, (j->sides.n + 1) * sizeof *gone);
  size_t gones = 0;
  sg_cell_table to;

  if (!gone || !sg_cell_table_open(j, j->sides.n + j->both.faces, 4, 0, &to)) {
    return false;
  }
  for (size_t i = 0; i < j->sides.n; i++) {
    uint32_t row = j->sides.rows.row[i];
    int32_t p = sg_view_int(&j->sides.view, 1, row);
    int32_t now[4] = {j->s, p, sg_view_int(&j->sides.view, 2, row),
                      sg_view_int(&j->sides.view, 3, row)};
    int side = side_inside(j, p);

    if (side != 0 || renamed(j, now[2]) != now[2] ||
        renamed(j, now[3]) != now[3]) {
      now[2] = side == 2 ? j->inside : renamed(j, now[2]);
      now[3] = side == 3 ? j->inside : renamed(j, now[3]);
      gone[gones++] = row;
      sg_cell_table_add(&to, 4, now);
    }
  }
  for (size_t f = j->near; f < j->both.faces; f++) {
    sg_cell_table_add(&to, 4,
                      (int32_t[]){j->s, j->polygon[f], j->inside, j->outside});
  }
  return sg_cell_table_write(j, world, SG_SIDES, gone, gones, &to);
}

/* The row of a region; SG_NO_ROW: there is none. */
static sg_row
region_row(const sg_cell_joiner *j, int32_t region)
{
  for (size_t i = 0; i < j->region.n; i++) {
    if (sg_view_int(&j->region.view, 1, j->region.rows.row[i]) == region) {
      return j->region.rows.row[i];
    }
  }
  return SG_NO_ROW;
}

/* One more, or one that is now something. */
static bool
write_region(sg_cell_joiner *j, sg_world *world, bool more)
{
  sg_row gone = region_row(j, j->inside);
  sg_cell_table to;

  if (!sg_cell_table_open(j, 2, 3, 0, &to)) {
    return false;
  }
  sg_cell_table_add(&to, 3, (int32_t[]){j->s, j->inside, SG_SYMBOL_CELL});
  if (more) {
    sg_cell_table_add(&to, 3, (int32_t[]){j->s, j->outside, SG_SYMBOL_OUTSIDE});
  }
  return sg_cell_table_write(j, world, SG_REGION, &gone, gone != SG_NO_ROW,
                             &to);
}

static bool
write_content(sg_cell_joiner *j, sg_world *world)
{
  sg_cell_table to;

  if (!sg_cell_table_open(j, 1, 4, 0, &to)) {
    return false;
  }
  sg_cell_table_add(&to, 4, (int32_t[]){j->s, j->inside, j->of, 1});
  return sg_cell_table_write(j, world, SG_FROM_R, NULL, 0, &to);
}

/* ---- the door ----------------------------------------------------------- */

/* What was round it is the outside, and stays one; or all of it is the solid.
 */
static bool
find_regions(sg_cell_joiner *j, sg_cell_added_how how)
{
  int32_t round = region_round(j);

  j->inside = round;
  j->outside = how == SG_CELL_MORE ? j->before + 1 : j->before;
  return how == SG_CELL_MORE    ? round == j->before
         : how == SG_CELL_FILLS ? round != 0 && round != j->before
                                : false;
}

static bool
write_all(sg_cell_joiner *j, sg_cell_added_how how)
{
  sg_world *world = sg_call_claim(j->call);
  bool good = world && sg_cell_write(j, world) && write_sides(j, world) &&
              write_region(j, world, how == SG_CELL_MORE) &&
              write_content(j, world);

  if (world) {
    sg_world_release(world);
  }
  return good;
}

/* Nothing lies in its regions or faces. */
static bool
lies_nothing(sg_call *call, const sg_version *version, int32_t s)
{
  sg_segment_rows rows;
  bool none = sg_rows_of_segment(call, version, SG_LIES_IN, s, &rows) &&
              rows.begin[1] == 0;

  sg_segment_rows_clear(&rows);
  return none;
}

bool
sg_door_cell_added(sg_call *call, int32_t s, int32_t n, sg_solid *solid,
                   double reach, const sg_int_list *made)
{
  sg_cell_joiner j = {.call = call,
                      .version = sg_call_version(call),
                      .s = s,
                      .of = n,
                      .solid = solid,
                      .reach = reach,
                      .made = made};
  sg_pool *pool = sg_call_pool(call);
  sg_cell_added_how how = SG_CELL_NOT;
  bool good = j.version && pool && solid->plain == solid->vertices &&
              lies_nothing(call, j.version, s) && sg_cell_read(&j);

  good = good &&
         (sg_cell_added(&j.both, j.near, n, reach, pool, &call->cancel, &how) ||
          sg_call_ended(call));
  good = good && find_regions(&j, how) && write_all(&j, how);
  sg_cell_clear(&j);
  return good;
}

static bool
write_rest(sg_cell_joiner *j)
{
  sg_world *world = sg_call_claim(j->call);
  bool good = world && sg_cell_write(j, world);

  if (world) {
    sg_world_release(world);
  }
  return good;
}

bool
sg_door_cell_completed(sg_call *call, int32_t s, int32_t n, sg_solid *solid,
                       double reach, const sg_int_list *made,
                       const sg_id_pair_list *was, size_t *faces)
{
  sg_cell_joiner j = {.call = call,
                      .version = sg_call_version(call),
                      .s = s,
                      .of = n,
                      .solid = solid,
                      .reach = reach,
                      .made = made,
                      .rest_only = true,
                      .was = was->at,
                      .was_n = was->n};
  size_t doubles;
  bool good = j.version && solid->plain == solid->vertices && sg_cell_read(&j);

  good =
      good && (sg_coincident_faces(&j.both, reach, &call->cancel, &doubles) ||
               sg_call_ended(call));
  *faces = j.both.faces - j.near;
  good = good && write_rest(&j);
  sg_cell_clear(&j);
  return good;
}
