/* drawn_stroke_rows.c -- the edges of drawn/7 as strokes on a sheet, without a
 * term for each part or stroke: the fused kernel of sheet.pl,
 * sheet_strokes_by_rule/4.
 */
#include "stroke_rows.h"

#include <math.h>

/* A row of drawn/7 that is an edge. */
typedef struct drawn {
  int32_t s, e, visibility, role; /* the last two are symbols */
  double from, to;
  double a[2], b[2]; /* in the picture */
} drawn;

typedef bool use_drawn(sg_call *call, void *data, const drawn *row);

/* ---- rows ---- */

/* The row that begins with two ids. */
static sg_row
find_row(const sg_version *version, sg_relation relation, int32_t s, int32_t id)
{
  return sg_version_find(version, relation,
                         (sg_value[SG_MAX_COLUMNS]){{.i = s}, {.i = id}});
}

static bool
place_vertex(const sg_version *version, int32_t s, int32_t v, double out[2])
{
  sg_row row = find_row(version, SG_SCREEN, s, v);

  if (row == SG_NO_ROW) {
    return false;
  }
  out[0] = sg_version_value(version, SG_SCREEN, row, 2).f;
  out[1] = sg_version_value(version, SG_SCREEN, row, 3).f;
  return true;
}

/* Exact at both ends. */
static double
between(double at, double a, double b)
{
  return at == 1.0 ? b : a + at * (b - a);
}

/* False: the edge, or a place of its ends, is not there. */
static bool
place_drawn(const sg_version *version, drawn *row)
{
  sg_row edge = find_row(version, SG_E, row->s, row->e);
  double start[2], end[2];

  if (edge == SG_NO_ROW ||
      !place_vertex(version, row->s, sg_version_value(version, SG_E, edge, 2).i,
                    start) ||
      !place_vertex(version, row->s, sg_version_value(version, SG_E, edge, 3).i,
                    end)) {
    return false;
  }
  for (int k = 0; k < 2; k++) {
    row->a[k] = between(row->from, start[k], end[k]);
    row->b[k] = between(row->to, start[k], end[k]);
  }
  return true;
}

/* Calls `use` with each row of drawn/7 that is an edge. */
static bool
each_row(sg_call *call, const sg_version *version, use_drawn *use, void *data)
{
  sg_view view;
  bool good = true;

  if (!sg_version_view(version, SG_DRAWN, &view)) {
    return sg_call_no_memory(call);
  }
  for (size_t i = 0; i < view.pages && good; i++) {
    const sg_column *c = view.column;

    for (unsigned r = sg_live_next(view.live[i], 0); r < SG_PAGE_ROWS && good;
         r = sg_live_next(view.live[i], r + 1)) {
      drawn row = {.s = c[1].page[i].i[r],
                   .e = c[2].page[i].i[r],
                   .from = c[3].page[i].f[r],
                   .to = c[4].page[i].f[r],
                   .visibility = c[5].page[i].i[r],
                   .role = c[6].page[i].i[r]};

      good = row.e < 0 || !place_drawn(version, &row) || use(call, data, &row);
    }
    good = good && !sg_cancelled(&call->cancel);
  }
  sg_view_clear(&view);
  return good;
}

static bool
each_drawn(sg_call *call, use_drawn *use, void *data)
{
  const sg_version *version = sg_call_version(call);

  return version &&
         ((sg_index_ready(version, SG_E, 0x03, &call->cancel) &&
           sg_index_ready(version, SG_SCREEN, 0x03, &call->cancel)) ||
          sg_call_ended(call)) &&
         each_row(call, version, use, data);
}

/* ---- the box ---- */

typedef struct box {
  bool any;
  double low[2], high[2];
} box;

static bool
box_add(sg_call *call, void *data, const drawn *row)
{
  box *b = data;

  (void)call;
  for (int k = 0; k < 2; k++) {
    double low = fmin(row->a[k], row->b[k]), high = fmax(row->a[k], row->b[k]);

    b->low[k] = b->any ? fmin(b->low[k], low) : low;
    b->high[k] = b->any ? fmax(b->high[k], high) : high;
  }
  b->any = true;
  return true;
}

bool
sg_door_drawn_box(sg_call *call, sg_paper_box *out)
{
  box b = {0};
  bool good = each_drawn(call, box_add, &b) && b.any;

  *out = (sg_paper_box){b.low[0], b.low[1], b.high[0], b.high[1]};
  return good;
}

/* ---- the strokes ---- */

/* Parts under way. */
typedef struct parts {
  const sg_drawing_place *place;
  int32_t removed; /* a visibility */
  const sg_ranked_look_list *looks;
  sg_stroke_parts part;
  size_t last;
} parts;

static bool
on_sheet(const parts *p, const double at[2], int32_t out[2])
{
  static const double far = 0x1p31;
  double x = round((at[0] - p->place->x) * p->place->scale + p->place->left);
  double y = round((p->place->y - at[1]) * p->place->scale + p->place->top);

  if (!(fabs(x) < far && fabs(y) < far)) {
    return false;
  }
  out[0] = (int32_t)x;
  out[1] = (int32_t)y;
  return true;
}

static bool
part_add(sg_call *call, void *data, const drawn *row)
{
  parts *p = data;
  sg_stroke_part part = {
      .s = row->s, .e = row->e, .from = row->from, .to = row->to};

  if (row->visibility == p->removed) {
    return true;
  }
  p->last = sg_looks_find(p->looks, row->visibility, row->role, p->last);
  if (p->last == p->looks->n) {
    return sg_call_cannot_hold(call, "look");
  }
  part.look = (uint32_t)p->last;
  if (!on_sheet(p, row->a, part.a) || !on_sheet(p, row->b, part.b)) {
    return sg_call_cannot_hold(call, "sheet_coordinate");
  }
  return sg_part_add(call, &p->part, part);
}

/* No more strokes than that go through Prolog at a time. */
enum { RUN = 1000 };

static const sg_stroke_part *
first_part(const sg_chains *chains, size_t k)
{
  const sg_strokes *strokes = &chains->strokes;
  int32_t step = strokes->step[strokes->item[k].first];

  return &strokes->part[(step < 0 ? -step : step) - 1];
}

/* Neighbours that look alike, of one segment. */
static bool
add_runs(sg_call *call, const sg_chains *chains, sg_chain_run_list *runs)
{
  bool good = true;

  for (size_t i = 0, j; i < chains->strokes.n && good; i = j) {
    const sg_stroke_part *first = first_part(chains, i), *next = first;
    const sg_ranked_look *look = &chains->look[first->look];

    for (j = i + 1; j < chains->strokes.n && j - i < RUN; j++) {
      next = first_part(chains, j);
      if (next->look != first->look || next->s != first->s) {
        break;
      }
    }
    good = sg_chain_run_list_add(
        call, runs,
        (sg_chain_run){look->visibility, look->role, first->s, i + 1, j});
  }
  return good;
}

bool
sg_door_drawn_strokes(sg_call *call, const sg_drawing_place *place,
                      int32_t removed, const sg_ranked_look_list *looks,
                      const sg_sheet_part_list *others, sg_chains **out,
                      sg_chain_run_list *runs)
{
  parts p = {.place = place, .removed = removed, .looks = looks};
  bool good = each_drawn(call, part_add, &p) &&
              sg_parts_add(call, others, 4, looks, &p.part);
  sg_chains *chains = sg_chains_of(call, good, looks, &p.part);

  if (chains && !add_runs(call, chains, runs)) {
    sg_chains_close(chains);
    chains = NULL;
  }
  *out = chains;
  return chains != NULL;
}
