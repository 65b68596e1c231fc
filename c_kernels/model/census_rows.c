/* census_rows.c -- the census of the current world. */
#include "census.h"
#include "doors/world.h"
#include "rows/dense_rows.h"
#include "rows/live_rows.h"

#include <math.h>

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

/* sg_census_clear() in any case. */
static bool
make_census(sg_call *call, sg_census *out)
{
  sg_dense dense;
  planes all = {&dense, NULL};
  bool stopped;
  bool good = sg_dense_read(call, NULL, 0, &dense) && read_planes(call, &all);

  *out = (sg_census){0};
  good = good && (sg_census_make(&dense, (const double(*)[4])all.of,
                                 &call->cancel, out, &stopped) ||
                  sg_call_ended(call));
  sg_dense_clear(&dense);
  return good;
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
add_part(sg_call *call, const sg_census *census, const sg_part *p,
         sg_census_part_list *out)
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
  return sg_census_part_list_add(call, out, part);
}

bool
sg_door_census(sg_call *call, sg_census_part_list *out)
{
  sg_census c;
  bool good = make_census(call, &c);

  for (size_t i = 0; good && i < c.parts; i++) {
    good = add_part(call, &c, &c.part[i], out);
  }
  sg_census_clear(&c);
  return good;
}

/* ---- defects ---- */

bool
sg_door_census_defect(sg_call *call, sg_census_defect_rows *rows)
{
  sg_census c;
  bool good = make_census(call, &c);

  for (size_t i = 0; good && i < c.defects; i++) {
    const sg_defect *d = &c.defect[i];
    const sg_census_defect_row row = {d->kind, d->segment, d->a, d->b};

    good = sg_census_defect_rows_add(call, rows, row);
  }
  sg_census_clear(&c);
  return good;
}
