/* census_rows.c -- the census of the current world. */
#include "census.h"
#include "doors/world.h"
#include "engine/search.h"
#include "rows/census_kept_rows.h"
#include "rows/dense_rows.h"
#include "rows/live_rows.h"

#include <math.h>

#include <stdlib.h>
#include <string.h>

typedef struct planes {
  const sg_dense *dense;
  double (*of)[4]; /* [polygons] */
} planes;

static void
read_plane(void *reader, const sg_live_row *row)
{
  const planes *all = reader;
  int32_t p =
      sg_dense_polygon(all->dense, sg_row_int(row, 0), sg_row_int(row, 1));

  for (unsigned k = 0; p >= 0 && k < 4; k++) {
    all->of[p][k] = sg_row_number(row, 2 + k);
  }
}

static bool
read_planes(sg_call *call, planes *all)
{
  all->of = sg_call_alloc(call, (all->dense->polygons + 1) * sizeof *all->of);
  for (size_t p = 0; all->of && p < all->dense->polygons; p++) {
    all->of[p][0] = NAN;
  }
  return all->of && sg_each_row(call, SG_PLANE, read_plane, all);
}

static bool
list_defects(sg_call *call, const sg_census *c, sg_found_defect_list *found)
{
  bool good = true;

  for (size_t i = 0; good && i < c->defects; i++) {
    const sg_defect *d = &c->defect[i];

    good = sg_found_defect_list_add(
        call, found,
        (sg_found_defect){(int)d->kind, d->segment, d->a, (int32_t)i});
  }
  return good;
}

static void
clear_census(void *census)
{
  sg_census_clear(census);
  free(census);
}

static bool
make_census(sg_call *call, sg_kept_defects *kept, sg_found_defect_list *found)
{
  sg_census *out = calloc(1, sizeof *out);
  sg_dense dense;
  planes all = {&dense, NULL};
  bool stopped;

  if (!out) {
    return sg_call_no_memory(call);
  }
  kept->more = out;
  kept->clear = clear_census;
  bool good = sg_dense_read(call, NULL, 0, &dense) && read_planes(call, &all);

  good = good && (sg_census_make(&dense, (const double(*)[4])all.of,
                                 &call->cancel, out, &stopped) ||
                  sg_call_ended(call));
  sg_dense_clear(&dense);
  return good && list_defects(call, out, found);
}

static const sg_census *
census_of(const sg_kept_defects *kept)
{
  return kept->more;
}

static sg_kept_defects *
hold_census(sg_call *call)
{
  return sg_kept_defects_hold(call, SG_DEFECTS_OF_CENSUS, make_census);
}

/* ---- parts ---- */

static bool
count_defects(sg_call *call, const sg_part *p, sg_defect_count_list *out)
{
  for (int k = 0; k < SG_DEFECTS; k++) {
    const sg_defect_count count = {(sg_defect_kind)k, p->defects[k]};

    if (count.n > 0 && !sg_defect_count_list_add(call, out, count)) {
      return false;
    }
  }
  return true;
}

static bool
make_part(sg_call *call, const sg_census *census, const sg_part *p,
          sg_census_part *out)
{
  sg_census_part part = {.segment = p->segment,
                         .counts = *p,
                         .box = *p,
                         .area = p->area,
                         .volume = p->volume,
                         .length = p->length};
  size_t bytes = p->shells * sizeof *part.shells.at;
  sg_shell *shell = sg_call_alloc(call, bytes);

  if (!shell || !count_defects(call, p, &part.defects)) {
    return false;
  }
  if (p->shells > 0) {
    memcpy(shell, &census->shell[p->first_shell], bytes);
  }
  part.shells = (sg_census_shell_list){shell, p->shells, p->shells};
  *out = part;
  return true;
}

/* Those of segment s, all of them if it is null: parts from .. to - 1. */
static void
parts_of(const sg_census *c, const int32_t *s, size_t *from, size_t *to)
{
  size_t at;

  *from = 0;
  *to = c->parts;
  if (s) {
    SG_SEARCH(at, 0, c->parts, c->part[at].segment < *s);
    *from = at;
    *to = at + (at < c->parts && c->part[at].segment == *s);
  }
}

bool
sg_door_census(sg_call *call, sg_census_part_list *out)
{
  sg_kept_defects *kept = hold_census(call);
  bool good = kept != NULL;

  for (size_t i = 0; good && i < census_of(kept)->parts; i++) {
    sg_census_part part;

    good = make_part(call, census_of(kept), &census_of(kept)->part[i], &part) &&
           sg_census_part_list_add(call, out, part);
  }
  sg_kept_defects_drop(kept);
  return good;
}

bool
sg_door_census_part(sg_call *call, const int32_t *s, sg_census_part_rows *rows)
{
  sg_kept_defects *kept = hold_census(call);
  bool good = kept != NULL;
  size_t from = 0, to = 0;

  if (good) {
    parts_of(census_of(kept), s, &from, &to);
  }
  for (size_t i = from; good && i < to; i++) {
    const sg_part *p = &census_of(kept)->part[i];
    sg_census_part_row row = {.s = p->segment};

    good = make_part(call, census_of(kept), p, &row.part) &&
           sg_census_part_rows_add(call, rows, row);
  }
  sg_kept_defects_drop(kept);
  return good;
}

/* Those of a part, or the one that has polygon p as its lowest. */
static bool
add_shells(sg_call *call, const sg_census *c, const sg_part *of,
           const int32_t *p, sg_census_shell_rows *rows)
{
  size_t at = of->first_shell, end = of->first_shell + of->shells;
  bool good = true;

  if (p) {
    SG_SEARCH(at, of->first_shell, end, c->shell[at].polygon < *p);
  }
  for (; good && at < end && (!p || c->shell[at].polygon == *p); at++) {
    const sg_shell *shell = &c->shell[at];

    good = sg_census_shell_rows_add(
        call, rows,
        (sg_census_shell_row){of->segment, shell->polygon, of->shells, *shell});
  }
  return good;
}

bool
sg_door_census_shell(sg_call *call, const int32_t *s, const int32_t *p,
                     sg_census_shell_rows *rows)
{
  sg_kept_defects *kept = hold_census(call);
  bool good = kept != NULL;
  size_t from = 0, to = 0;

  if (good) {
    parts_of(census_of(kept), s, &from, &to);
  }
  for (size_t i = from; good && i < to; i++) {
    good =
        add_shells(call, census_of(kept), &census_of(kept)->part[i], p, rows);
  }
  sg_kept_defects_drop(kept);
  return good;
}

/* ---- defects ---- */

bool
sg_door_census_defect(sg_call *call, const sg_defect_kind *kind,
                      const int32_t *s, const int32_t *a,
                      sg_census_defect_rows *rows)
{
  sg_kept_defects *kept = hold_census(call);
  int of = kind ? (int)*kind : 0;
  sg_count_list places = {0};
  bool good =
      kept && sg_kept_defects_ask(call, kept, kind ? &of : NULL, s, a, &places);

  for (size_t i = 0; good && i < places.n; i++) {
    const sg_defect *d = &census_of(kept)->defect[kept->found[places.at[i]].b];
    const sg_census_defect_row row = {d->kind, d->segment, d->a, d->b};

    good = sg_census_defect_rows_add(call, rows, row);
  }
  sg_kept_defects_drop(kept);
  return good;
}
