/* drawn_stroke4pl.c -- the edges of drawn/7 as strokes on a sheet, without a
 * term for each part (documented in kernel/drawing.pl).
 *
 * Layer: glue. The fused kernel of sheet.pl, sheet_strokes_by_rule/4.
 */
#include "stroke4pl.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <math.h>
#include <stdlib.h>

/* A row of drawn/7 that is an edge. */
typedef struct drawn {
  int32_t s, e, visibility, role; /* the last two are symbols */
  double from, to;
  double a[2], b[2]; /* in the picture */
} drawn;

typedef int use_drawn_ex(void *data, const drawn *row);

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
static int
each_row_ex(const sg_version *version, use_drawn_ex *use, void *data)
{
  sg_view view;
  int good = TRUE;

  if (!sg_version_view(version, SG_DRAWN, &view)) {
    return sg_no_memory();
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

      good = row.e < 0 || !place_drawn(version, &row) || use(data, &row);
    }
    good = good && !sg_poll_stop(&sg_prolog_poll);
  }
  sg_view_clear(&view);
  return good;
}

static int
each_drawn_ex(use_drawn_ex *use, void *data)
{
  sg_world *world = sg_current_world_ex();
  const sg_version *version = world ? sg_world_version(world) : NULL;
  int good = version && sg_index_ready(version, SG_E, 0x03, &sg_prolog_poll) &&
             sg_index_ready(version, SG_SCREEN, 0x03, &sg_prolog_poll) &&
             each_row_ex(version, use, data);

  if (version) {
    sg_version_drop(version);
  }
  return good;
}

/* ---- the box ---- */

typedef struct box {
  bool any;
  double low[2], high[2];
} box;

static int
box_add(void *data, const drawn *row)
{
  box *b = data;

  for (int k = 0; k < 2; k++) {
    double low = fmin(row->a[k], row->b[k]), high = fmax(row->a[k], row->b[k]);

    b->low[k] = b->any ? fmin(b->low[k], low) : low;
    b->high[k] = b->any ? fmax(b->high[k], high) : high;
  }
  b->any = true;
  return TRUE;
}

/* drawn_box(-Box) is semidet. */
static foreign_t
drawn_box(term_t out)
{
  box b = {0};

  return each_drawn_ex(box_add, &b) && b.any &&
         PL_unify_term(out, PL_FUNCTOR_CHARS, "b", 4, PL_FLOAT, b.low[0],
                       PL_FLOAT, b.low[1], PL_FLOAT, b.high[0], PL_FLOAT,
                       b.high[1]);
}

/* ---- the strokes ---- */

/* Parts under way. place: Scale, X, Y, Left, Top. */
typedef struct parts {
  double place[5];
  int32_t removed; /* a visibility; -1: none */
  sg_looks looks;
  sg_stroke_part *part;
  size_t n, room, last;
} parts;

static bool
on_sheet(const parts *p, const double at[2], int64_t out[2])
{
  static const double far = 0x1p52;
  double x = round((at[0] - p->place[1]) * p->place[0] + p->place[3]);
  double y = round((p->place[2] - at[1]) * p->place[0] + p->place[4]);

  if (!(fabs(x) < far && fabs(y) < far)) {
    return false;
  }
  out[0] = (int64_t)x;
  out[1] = (int64_t)y;
  return true;
}

static int
room_ex(parts *p)
{
  if (p->n == p->room) {
    size_t room = 2 * p->room + 1024;
    sg_stroke_part *grown = realloc(p->part, room * sizeof *grown);

    if (!grown) {
      return sg_no_memory();
    }
    p->part = grown;
    p->room = room;
  }
  return TRUE;
}

static int
part_add(void *data, const drawn *row)
{
  parts *p = data;
  sg_look_names name = {sg_symbol_atom(row->visibility),
                        sg_symbol_atom(row->role)};
  sg_stroke_part part = {
      .s = row->s, .e = row->e, .from = row->from, .to = row->to};

  if (row->visibility == p->removed) {
    return TRUE;
  }
  p->last = sg_looks_find(&p->looks, name, p->last);
  if (p->last == p->looks.n) {
    return PL_representation_error("look");
  }
  part.look = (uint32_t)p->last;
  if (!on_sheet(p, row->a, part.a) || !on_sheet(p, row->b, part.b)) {
    return PL_representation_error("sheet_coordinate");
  }
  if (!room_ex(p)) {
    return FALSE;
  }
  p->part[p->n++] = part;
  return TRUE;
}

/* place(Scale, X, Y, Left, Top) */
static int
get_place_ex(term_t t, parts *out)
{
  term_t arg = PL_new_term_ref();

  if (!PL_is_functor(t, PL_new_functor(PL_new_atom("place"), 5))) {
    return PL_type_error("place", t);
  }
  for (int k = 0; k < 5; k++) {
    if (!PL_get_arg(k + 1, t, arg) || !sg_get_finite_ex(arg, &out->place[k])) {
      return FALSE;
    }
  }
  return TRUE;
}

/* drawn_strokes(+Place, +Removed, +Looks, +Others, -Strokes) is det. */
static foreign_t
drawn_strokes(term_t place, term_t removed, term_t looks, term_t others,
              term_t strokes)
{
  parts p = {0};
  atom_t name;
  int good = get_place_ex(place, &p) && PL_get_atom_ex(removed, &name) &&
             sg_get_looks_ex(looks, &p.looks);

  if (good) {
    p.removed = sg_atom_symbol(name);
    good = each_drawn_ex(part_add, &p) &&
           sg_get_parts_ex(others, &p.looks, &p.part, &p.n) &&
           sg_unify_strokes_of(strokes, &p.looks, p.part, p.n);
  }
  free(p.part);
  sg_looks_clear(&p.looks);
  return good;
}

void
sg_install_drawn_stroke(void)
{
  static const PL_extension doors[] = {
      {"drawn_box", 1, (pl_function_t)drawn_box, 0},
      {"drawn_strokes", 5, (pl_function_t)drawn_strokes, 0},
      {NULL, 0, NULL, 0}};

  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
