/* cut_fold_rows.c -- cut sets: polygons that are not flat, and their folds.
 *
 * Layer: rows. The door is documented in rules/kernel/penetration.pl. Such a
 * polygon is used as its triangles, so the chords between these are *folds*: a
 * line is divided where it crosses one, and the polygon is triangulated along
 * it again. A fold is an edge pair of the polygon while that is cut, of type 0
 * and label 0, and no row of e/5.
 */
#include "cut_rows.h"

#include "doors/penetration.h"

#include "engine/list.h"
#include "engine/search.h"
#include "polygon/flatness.h"
#include "polygon/plane.h"
#include "rows/grain_rows.h"
#include "rows/pattern_rows.h"

#include <math.h>
#include <stdlib.h>

/* A polygon was flat before its vertices were moved to touch something: what
 * this makes of it is no fold. In tolerances. */
#define MOVED 4.0

/* ---- flat or not ---- */

static void
see_tolerance(sg_cut_handle *handle, double tolerance)
{
  handle->flat_within = fmax(handle->flat_within, MOVED * tolerance);
}

/* The tolerance of the model, all rows of v/5. False: no memory. */
static bool
see_all_vertices(sg_cut_handle *handle)
{
  sg_flatness flatness;
  sg_model_view view;
  double grain;
  bool good = sg_model_view_make(handle->version, SG_V, &view) &&
              sg_grain_of_all(handle->version, &grain);

  sg_flatness_init(&flatness, good ? grain : 0);
  for (size_t i = 0; good && i < view.shown.pages; i++) {
    sg_flatness_page(&flatness, &view.shown, i);
  }
  sg_model_view_clear(&view);
  if (good) {
    see_tolerance(handle, sg_flatness_flat(&flatness));
    handle->flat_known = true;
  }
  return good;
}

/* Where vertex v is, or was before it was moved. False: there is none. */
static bool
read_place(const sg_cut_handle *handle, int32_t s, int32_t v, double out[3])
{
  sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].i = v};
  sg_relation from = SG_LEAF_V;
  sg_row row = sg_version_find(handle->version, from, key);

  if (row == SG_NO_ROW) {
    from = SG_V;
    row = sg_version_find(handle->version, from, key);
  }
  for (unsigned k = 0; k < 3 && row != SG_NO_ROW; k++) {
    out[k] = sg_version_value(handle->version, from, row, k + 2).f;
  }
  return row != SG_NO_ROW;
}

static bool
read_plane(sg_cut_handle *handle, int32_t s, int32_t p, sg_plane *out)
{
  sg_row row = sg_cut_row_of(handle, SG_PLANE, s, p);

  for (unsigned k = 0; k < 3 && row != SG_NO_ROW; k++) {
    out->n[k] = sg_version_value(handle->version, SG_PLANE, row, k + 2).f;
  }
  if (row != SG_NO_ROW) {
    out->d = sg_version_value(handle->version, SG_PLANE, row, 5).f;
  }
  return row != SG_NO_ROW;
}

/* How far a polygon goes off its plane, and how large its box is. */
static void
measure(sg_cut_handle *handle, int32_t s, const sg_plane *plane,
        const int32_t *list, double *off, double *size)
{
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, at[3];

  *off = *size = 0.0;
  for (int32_t i = 1; i <= list[0]; i++) {
    sg_row edge = sg_cut_row_of(handle, SG_E, s, list[i]);

    if (edge == SG_NO_ROW ||
        !read_place(handle, s,
                    sg_version_value(handle->version, SG_E, edge, 2).i, at)) {
      continue;
    }
    *off = fmax(*off, fabs(sg_plane_distance(plane, at)));
    for (int k = 0; k < 3; k++) {
      low[k] = fmin(low[k], at[k]);
      high[k] = fmax(high[k], at[k]);
      *size = fmax(*size, high[k] - low[k]);
    }
  }
}

/* 1: polygon p of segment s is not flat; 0: it is; -1: no memory. The tolerance
 * of the model, which is at least 2^-33 of the polygon, is asked for last. */
static int
find_bent(sg_cut_handle *handle, int32_t s, int32_t p)
{
  sg_row row = sg_cut_row_of(handle, SG_P, s, p);
  sg_plane plane;
  double off, size;

  if (row == SG_NO_ROW || !read_plane(handle, s, p, &plane)) {
    return 0;
  }
  const int32_t *list = sg_version_value(handle->version, SG_P, row, 2).list;

  if (list[0] <= 3) {
    return 0;
  }
  measure(handle, s, &plane, list, &off, &size);
  if (off <= fmax(ldexp(size, -33), handle->flat_within)) {
    return 0;
  }
  if (!handle->flat_known && !see_all_vertices(handle)) {
    return -1;
  }
  return off > handle->flat_within;
}

/* Whether polygon p of segment s is not flat: 1, 0, or -1: no memory. */
static int
is_bent(sg_cut_handle *handle, int32_t s, int32_t p)
{
  uint32_t key[2] = {(uint32_t)s, (uint32_t)p};
  uint32_t known = sg_key_table_get(&handle->bent, key);

  if (known == SG_NO_KEY) {
    int bent = find_bent(handle, s, p);
    uint32_t *number = bent < 0 ? NULL : sg_key_table_put(&handle->bent, key);

    if (!number) {
      return -1;
    }
    known = *number = (uint32_t)bent;
  }
  return (int)known;
}

/* ---- folds ---- */

/* The directed sides of a polygon's triangles. */
typedef struct sides {
  int32_t (*side)[2]; /* [n] */
  size_t n, room;
} sides;

SG_ORDER(compare_sides, int32_t, SG_BY_AT(0) SG_BY_AT(1));

static bool
has_side(const sides *all, int32_t v1, int32_t v2)
{
  int32_t key[2] = {v1, v2};

  return bsearch(key, all->side, all->n, sizeof *all->side, compare_sides) !=
         NULL;
}

/* False: no memory. */
static bool
push_triangle(sides *all, const int32_t v[3])
{
  if (!sg_list_need(&all->side, all->n + 3, &all->room, sizeof *all->side)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    all->side[all->n][0] = v[k];
    all->side[all->n++][1] = v[(k + 1) % 3];
  }
  return true;
}

/* Sorted. False: no memory. */
static bool
read_sides(const sg_cut_handle *handle, int32_t s, int32_t p, sides *out)
{
  sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].i = p};
  sg_walk walk;
  bool good = sg_walk_open(&walk, handle->version, SG_T, 0x03, key);

  if (!good) {
    return false;
  }
  for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    int32_t v[3];

    for (unsigned k = 0; k < 3; k++) {
      v[k] = sg_version_value(handle->version, SG_T, row, k + 3).i;
    }
    good = push_triangle(out, v);
  }
  sg_walk_close(&walk);
  if (good && out->n > 0) {
    qsort(out->side, out->n, sizeof *out->side, compare_sides);
  }
  return good;
}

bool
sg_cut_add_folds(sg_call *call, sg_cut_handle *handle, int32_t s, int32_t p,
                 sg_outlines *out)
{
  sides all = {0};
  int bent = is_bent(handle, s, p);
  bool good = bent >= 0 && (bent == 0 || read_sides(handle, s, p, &all));

  for (size_t i = 0; good && i < all.n; i++) {
    int32_t v1 = all.side[i][0], v2 = all.side[i][1];

    if (has_side(&all, v2, v1)) { /* no edge of the polygon */
      good = sg_outlines_add_edge(out, &(sg_outline_edge){0, v1, v2, 0});
    }
  }
  free(all.side);
  return good || sg_call_no_memory(call);
}

int
sg_cut_is_real_or_fold(void *data, uint32_t triangle, int edge)
{
  sg_cut_handle *handle = data;
  const sg_leaf_triangle *leaf = &handle->set.model.triangle[triangle];
  int real = sg_cut_is_real(handle, triangle, edge);

  return real != 0 ? real : is_bent(handle, leaf->s, leaf->p);
}

/* ---- doors ---- */

bool
sg_door_cut_flat_within(sg_call *call, sg_cut_handle *handle, double tolerance)
{
  (void)call;
  see_tolerance(handle, tolerance);
  handle->set.flat_within = fmax(handle->set.flat_within, MOVED * tolerance);
  return true;
}

bool
sg_door_cut_of_faces(sg_call *call, sg_cut_handle *handle)
{
  (void)call;
  handle->set.of_faces = true;
  return true;
}
