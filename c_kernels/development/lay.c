/* lay.c -- see lay.h. */
#include "lay.h"

#include "engine/search.h"
#include "number/double_double.h"
#include "polygon/flat_fit.h"
#include "rows/disjoint.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct place {
  sg_dd x, y;
} place;

/* ---- laying out --------------------------------------------------------- */

/* Corners that are connected by folds are one *spot*. Spots are numbered as
 * they are laid, so those of a piece lie together in memory. */
typedef struct layer {
  const sg_flattening *fl;
  const sg_flat_faces *faces;
  const sg_dense *dense;
  sg_layout *out;
  uint32_t *spot; /* [corners] */
  size_t spots;
  place *at;         /* [spots] from the root of the piece */
  uint32_t *class;   /* [spots] a spot that is the same vertex, or itself */
  uint32_t *number;  /* [spots] the vertex of a class, at its lowest spot */
  uint32_t *of_spot; /* [spots] the vertex that lies here, or NO_VERTEX: at
                        another spot of its class */
  uint32_t *begin;   /* [pieces + 1] their first spots */
  uint32_t *stack; /* [faces] that are laid, but not those that hang on them */
  double touch;
} layer;

#define NO_VERTEX UINT32_MAX

static place *
new_spot(layer *l, uint32_t corner)
{
  l->spot[corner] = (uint32_t)l->spots;
  l->class[l->spots] = (uint32_t)l->spots;
  return &l->at[l->spots++];
}

static const double *
corner_at(const layer *l, uint32_t corner)
{
  return l->dense->at[l->faces->vertex[corner]];
}

/* A face, of which the side from corner a to b is laid. */
typedef struct hanging {
  uint32_t a, b;
  sg_dd_vector side;   /* from a to b in the solid */
  sg_dd_vector normal; /* of the face, a unit vector to twice the digits */
  sg_dd square;        /* of the side */
  place at, up;        /* a in the pattern, and b from there */
} hanging;

static hanging
hang(const layer *l, uint32_t face, uint32_t a, uint32_t b)
{
  static const double zero[3] = {0, 0, 0};
  const place *la = &l->at[l->spot[a]], *lb = &l->at[l->spot[b]];
  hanging out = {.a = a, .b = b, .at = *la};

  out.side = sg_dd_difference(corner_at(l, a), corner_at(l, b));
  out.square = sg_dd_dot(&out.side, &out.side);
  out.up = (place){sg_dd_minus(lb->x, la->x), sg_dd_minus(lb->y, la->y)};
  out.normal = sg_dd_difference(zero, l->faces->normal[face]);
  sg_dd scale = sg_dd_unit_scale(sg_dd_dot(&out.normal, &out.normal));
  for (int k = 0; k < 3; k++) {
    out.normal.k[k] = sg_dd_times(out.normal.k[k], scale);
  }
  return out;
}

/* What c - a is of b - a in the solid, as a complex number u + iv, it is in the
 * pattern. All of it has twice the digits: what hangs on a short side would
 * show what that lost. */
static void
lay_corner(layer *l, const hanging *on, uint32_t c)
{
  place *out = new_spot(l, c);
  sg_dd_vector way = sg_dd_difference(corner_at(l, on->a), corner_at(l, c));
  sg_dd_vector area = sg_dd_cross(&on->side, &way);

  *out = on->at;
  if (on->square.hi > 0) {
    sg_dd u = sg_dd_quotient(sg_dd_dot(&on->side, &way), on->square);
    sg_dd v = sg_dd_quotient(sg_dd_dot(&on->normal, &area), on->square);
    out->x = sg_dd_plus(out->x, sg_dd_minus(sg_dd_times(u, on->up.x),
                                            sg_dd_times(v, on->up.y)));
    out->y = sg_dd_plus(
        out->y, sg_dd_plus(sg_dd_times(u, on->up.y), sg_dd_times(v, on->up.x)));
  }
}

static void
lay_others(layer *l, uint32_t face, uint32_t a, uint32_t b)
{
  const sg_flat_faces *f = l->faces;
  hanging on = hang(l, face, a, b);

  for (uint32_t c = f->corner_begin[face]; c < f->corner_begin[face + 1]; c++) {
    if (c != a && c != b) {
      lay_corner(l, &on, c);
    }
  }
}

/* The root's longest side goes up from the origin; of a face whose edges are
 * all auxiliary, which has none, what leads from its first corner to the next.
 */
static void
lay_root(layer *l, uint32_t face)
{
  const sg_flat_faces *f = l->faces;
  bool has_side = f->side_begin[face] < f->side_begin[face + 1];
  uint32_t first = f->corner_begin[face], end = f->corner_begin[face + 1];

  if (first == end) {
    return;
  }
  uint32_t a = has_side ? f->side[f->longest[face]].from : first;
  uint32_t b = has_side          ? f->side[f->longest[face]].to
               : first + 1 < end ? first + 1
                                 : first;
  sg_dd_vector side = sg_dd_difference(corner_at(l, a), corner_at(l, b));

  *new_spot(l, a) = (place){{0, 0}, {0, 0}};
  if (b != a) {
    *new_spot(l, b) = (place){{0, 0}, sg_dd_root(sg_dd_dot(&side, &side))};
  }
  lay_others(l, face, a, b);
}

/* The face that hangs on another one, by these sides. */
static void
lay_child(layer *l, uint32_t parent_side, uint32_t side)
{
  const sg_flat_side *on = &l->faces->side[parent_side];
  const sg_flat_side *own = &l->faces->side[side];

  l->spot[own->from] = l->spot[on->to];
  l->spot[own->to] = l->spot[on->from];
  lay_others(l, l->faces->face_of[side], own->from, own->to);
}

static uint32_t
partner(const sg_joint *j, uint32_t side)
{
  return j->side[j->side[0] == side];
}

/* Lays what hangs on a face. The new top of the stack. */
static size_t
lay_children(layer *l, uint32_t face, uint32_t piece, size_t top)
{
  const sg_flat_faces *f = l->faces;

  for (uint32_t k = f->side_begin[face]; k < f->side_begin[face + 1]; k++) {
    uint32_t j = l->fl->joints->of_side[k];
    if (j != SG_NO_JOINT && l->fl->state[j] == SG_JOINT_JOINED) {
      uint32_t side = partner(&l->fl->joints->joint[j], k);
      uint32_t other = f->face_of[side];
      if (l->out->piece[other] == SG_NO_FACE) {
        lay_child(l, k, side);
        l->out->piece[other] = piece;
        l->stack[top++] = other;
      }
    }
  }
  return top;
}

static bool
lay_piece(layer *l, uint32_t root, uint32_t piece, const sg_cancel *cancel,
          bool *stopped)
{
  size_t top = 0, n = 0;

  lay_root(l, root);
  l->out->piece[root] = piece;
  l->stack[top++] = root;
  while (top > 0 && !*stopped) {
    top = lay_children(l, l->stack[top - 1], piece, top - 1);
    *stopped = sg_cancel_every(cancel, ++n);
  }
  return !*stopped;
}

/* ---- pieces ------------------------------------------------------------- */

typedef struct ranked {
  double area;
  uint32_t root;
} ranked;

/* Areas are rounded to steps, so that equal ones are equal. */
SG_ORDER(compare_ranked, ranked, SG_BY_MOST(area) SG_BY(root));

/* A face of another island than those before it is a piece of its own. */
static ranked *
piece_of(const sg_flattening *fl, uint32_t face, uint32_t *number, ranked *rank,
         size_t *pieces)
{
  uint32_t island = fl->island_of[face];

  if (number[island] == SG_NO_FACE) {
    number[island] = (uint32_t)*pieces;
    rank[(*pieces)++] = (ranked){0, face};
  }
  return &rank[number[island]];
}

/* The largest face of each island, and the islands by area; `number` ([faces])
 * is all SG_NO_FACE before and after. Null: no memory, or stopped. */
static ranked *
rank_pieces(const sg_lay_input *in, uint32_t *number, size_t *pieces,
            const sg_cancel *cancel, bool *stopped)
{
  const sg_flattening *fl = in->flattening;
  const double *area = fl->faces->area;
  size_t faces = fl->faces->faces;
  ranked *rank = malloc((faces + 1) * sizeof *rank);
  double step = fl->sheet * fl->sheet * 0x1p-36;

  *pieces = 0;
  for (uint32_t face = 0; rank && face < faces && !*stopped; face++) {
    *stopped = sg_cancel_every(cancel, face);
    ranked *piece = piece_of(fl, face, number, rank, pieces);
    piece->area += area[face];
    piece->root = area[face] > area[piece->root] ? face : piece->root;
  }
  for (size_t k = 0; rank && step > 0 && k < *pieces; k++) {
    rank[k].area = round(rank[k].area / step);
  }
  if (rank && !*stopped && in->root != SG_NO_FACE) {
    rank[number[fl->island_of[in->root]]] = (ranked){INFINITY, in->root};
  }
  memset(number, 0xff, faces * sizeof *number);
  sg_sort_end end =
      rank ? sg_sort(rank, *pieces, sizeof *rank, compare_ranked, cancel)
           : SG_SORT_NO_MEMORY;

  *stopped = *stopped || end == SG_SORT_STOPPED;
  if (end != SG_SORTED || *stopped) {
    free(rank);
    rank = NULL;
  }
  return rank;
}

static bool
lay_pieces(layer *l, const sg_lay_input *in, const sg_cancel *cancel,
           bool *stopped)
{
  size_t *pieces = &l->out->pieces;
  ranked *rank = rank_pieces(in, l->out->piece, pieces, cancel, stopped);
  bool good = rank != NULL;

  l->out->root = malloc((*pieces + 1) * sizeof *l->out->root);
  l->out->box = malloc((*pieces + 1) * sizeof *l->out->box);
  l->begin = malloc((*pieces + 1) * sizeof *l->begin);
  good = good && l->out->root && l->out->box && l->begin;
  for (uint32_t k = 0; good && k < *pieces; k++) {
    l->out->root[k] = rank[k].root;
    l->begin[k] = (uint32_t)l->spots;
    good = lay_piece(l, rank[k].root, k, cancel, stopped);
  }
  if (good) {
    l->begin[*pieces] = (uint32_t)l->spots;
  }
  free(rank);
  return good;
}

/* ---- joints that close -------------------------------------------------- */

static bool
is_near(const layer *l, uint32_t a, uint32_t b)
{
  const place *p = &l->at[l->spot[a]], *q = &l->at[l->spot[b]];

  return hypot(p->x.hi - q->x.hi, p->y.hi - q->y.hi) <= l->touch;
}

static bool
close_joints(layer *l, unsigned char *state, const sg_cancel *cancel)
{
  for (size_t k = 0; k < l->fl->joints->n; k++) {
    if (sg_cancel_every(cancel, k)) {
      return false;
    }
    const sg_joint *j = &l->fl->joints->joint[k];
    const uint32_t *a = j->corner[0], *b = j->corner[1];
    if (state[k] == SG_JOINT_SAME && !j->line && is_near(l, a[0], b[1]) &&
        is_near(l, a[1], b[0])) {
      state[k] = SG_JOINT_CLOSED;
      sg_disjoint_join(l->class, l->spot[a[0]], l->spot[b[1]]);
      sg_disjoint_join(l->class, l->spot[a[1]], l->spot[b[0]]);
    }
  }
  return true;
}

/* ---- turning ------------------------------------------------------------ */

/* Room for the points of the largest piece, twice. */
typedef struct turner {
  double (*point)[2], (*room)[2];
} turner;

static sg_flat_fit
fit_piece(const layer *l, uint32_t piece, const turner *t,
          const sg_cancel *cancel, bool *stopped)
{
  size_t points = 0;

  for (uint32_t s = l->begin[piece]; s < l->begin[piece + 1]; s++) {
    if (l->of_spot[s] != NO_VERTEX) {
      t->point[points][0] = l->at[s].x.hi;
      t->point[points++][1] = l->at[s].y.hi;
    }
  }
  return sg_flat_fit_find(t->point, points, t->room, cancel, stopped);
}

/* A direction as unit numbers of twice the digits. */
static void
make_unit(double x, double y, place *out)
{
  sg_dd scale =
      sg_dd_unit_scale(sg_dd_plus(sg_dd_times(sg_dd_of(x), sg_dd_of(x)),
                                  sg_dd_times(sg_dd_of(y), sg_dd_of(y))));

  out->x = sg_dd_times(sg_dd_of(x), scale);
  out->y = sg_dd_times(sg_dd_of(y), scale);
}

static void
turn_piece(layer *l, uint32_t piece, sg_flat_fit to, const sg_cancel *cancel,
           bool *stopped)
{
  sg_flat_box *box = &l->out->box[piece];
  place d;

  make_unit(to.x, to.y, &d);
  *box = (sg_flat_box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (uint32_t s = l->begin[piece]; s < l->begin[piece + 1] && !*stopped;
       s++) {
    place p = l->at[s];
    *stopped = sg_cancel_every(cancel, s);
    l->at[s].x = sg_dd_plus(sg_dd_times(p.x, d.x), sg_dd_times(p.y, d.y));
    l->at[s].y = sg_dd_minus(sg_dd_times(p.y, d.x), sg_dd_times(p.x, d.y));
    const double at[2] = {l->at[s].x.hi, l->at[s].y.hi};
    for (int k = 0; k < 2; k++) {
      box->low[k] = at[k] < box->low[k] ? at[k] : box->low[k];
      box->high[k] = at[k] > box->high[k] ? at[k] : box->high[k];
    }
  }
}

/* Piece by piece; one with the root that was asked for stays as it is. */
static bool
turn_pieces(layer *l, uint32_t root, const sg_cancel *cancel, bool *stopped)
{
  turner t = {malloc((l->spots + 1) * sizeof *t.point),
              malloc((l->spots + 2) * sizeof *t.room)};
  bool good = t.point && t.room;

  for (uint32_t k = 0; good && k < l->out->pieces; k++) {
    bool still = root != SG_NO_FACE && k == 0;
    sg_flat_fit to =
        still ? (sg_flat_fit){1, 0} : fit_piece(l, k, &t, cancel, stopped);
    turn_piece(l, k, to, cancel, stopped);
    good = !*stopped;
  }
  free(t.point);
  free(t.room);
  return good;
}

/* ---- side by side ------------------------------------------------------- */

/* Where the box of each piece begins, in rows of about a square sheet. */
static void
arrange(sg_layout *out, bool still, double (*to)[2])
{
  double area = 0, widest = 0, x = 0, y = 0, high = 0, gap = 0;

  for (size_t k = 0; k < out->pieces; k++) {
    double w = out->box[k].high[0] - out->box[k].low[0];
    double h = out->box[k].high[1] - out->box[k].low[1];
    area += w * h;
    widest = fmax(widest, w);
    gap = fmax(gap, fmin(w, h) / 16);
  }
  widest = fmax(widest, 1.25 * sqrt(area));
  for (size_t k = 0; k < out->pieces; k++) {
    double w = out->box[k].high[0] - out->box[k].low[0];
    if (x > 0 && x + w > widest) {
      x = 0;
      y += high + gap;
      high = 0;
    }
    to[k][0] = x;
    to[k][1] = y;
    x += w + gap;
    high = fmax(high, out->box[k].high[1] - out->box[k].low[1]);
  }
  for (size_t k = 0; k < out->pieces; k++) {
    for (int c = 0; c < 2; c++) { /* a root's stays at the origin */
      to[k][c] += (still ? out->box[0].low[c] : 0) - out->box[k].low[c];
    }
  }
}

/* ---- vertices ----------------------------------------------------------- */

/* In the order of their first corners; a vertex lies where that does. */
static bool
number_vertices(layer *l, const sg_cancel *cancel, bool *stopped)
{
  size_t corners = l->faces->corners;
  sg_layout *out = l->out;

  out->vertex = malloc((corners + 1) * sizeof *out->vertex);
  out->first = malloc((l->spots + 1) * sizeof *out->first);
  out->at = malloc((l->spots + 1) * sizeof *out->at);
  if (!out->vertex || !out->first || !out->at) {
    return false;
  }
  memset(l->number, 0xff, l->spots * sizeof *l->number);
  memset(l->of_spot, 0xff, l->spots * sizeof *l->of_spot);
  for (uint32_t c = 0; c < corners && !*stopped; c++) {
    uint32_t *number = &l->number[sg_disjoint_root(l->class, l->spot[c])];
    if (*number == NO_VERTEX) {
      out->first[out->vertices] = c;
      *number = l->of_spot[l->spot[c]] = (uint32_t)out->vertices++;
    }
    out->vertex[c] = *number;
    *stopped = sg_cancel_every(cancel, c);
  }
  return !*stopped;
}

static void
shift_piece(layer *l, uint32_t piece, const double to[2],
            const sg_cancel *cancel, bool *stopped)
{
  sg_layout *out = l->out;
  const sg_dd x = sg_dd_of(to[0]), y = sg_dd_of(to[1]);

  for (uint32_t s = l->begin[piece]; s < l->begin[piece + 1] && !*stopped;
       s++) {
    *stopped = sg_cancel_every(cancel, s);
    if (l->of_spot[s] != NO_VERTEX) {
      out->at[l->of_spot[s]][0] = sg_dd_plus(l->at[s].x, x).hi + 0.0;
      out->at[l->of_spot[s]][1] = sg_dd_plus(l->at[s].y, y).hi + 0.0;
    }
  }
  for (int c = 0; c < 2; c++) {
    out->box[piece].low[c] += to[c];
    out->box[piece].high[c] += to[c];
  }
}

/* Where the vertices lie in rows of pieces. */
static bool
place_vertices(layer *l, bool still, const sg_cancel *cancel, bool *stopped)
{
  double(*to)[2] = malloc((l->out->pieces + 1) * sizeof *to);
  bool good = to != NULL;

  if (good) {
    arrange(l->out, still, to);
  }
  for (uint32_t k = 0; good && k < l->out->pieces; k++) {
    shift_piece(l, k, to[k], cancel, stopped);
    good = !*stopped;
  }
  free(to);
  return good;
}

/* ---- all ---------------------------------------------------------------- */

static bool
make_layer(layer *l, const sg_lay_input *in, sg_layout *out)
{
  const sg_flat_faces *f = in->flattening->faces;
  size_t corners = f->corners + 1, faces = f->faces + 1;

  *l = (layer){.fl = in->flattening,
               .faces = f,
               .dense = in->flattening->dense,
               .out = out,
               .spot = malloc(corners * sizeof *l->spot),
               .at = malloc(corners * sizeof *l->at),
               .class = malloc(corners * sizeof *l->class),
               .number = malloc(corners * sizeof *l->number),
               .of_spot = malloc(corners * sizeof *l->of_spot),
               .stack = malloc(faces * sizeof *l->stack),
               .touch = in->touch};
  *out = (sg_layout){.piece = malloc(faces * sizeof *out->piece)};
  if (out->piece) {
    memset(out->piece, 0xff, faces * sizeof *out->piece);
  }
  return l->spot && l->at && l->class && l->number && l->of_spot && l->stack &&
         out->piece;
}

static void
clear_layer(layer *l)
{
  free(l->spot);
  free(l->at);
  free(l->class);
  free(l->number);
  free(l->of_spot);
  free(l->begin);
  free(l->stack);
}

bool
sg_lay(const sg_lay_input *in, const sg_cancel *cancel, sg_layout *out,
       bool *stopped)
{
  layer l;
  bool good = make_layer(&l, in, out);

  *stopped = false;
  good = good && lay_pieces(&l, in, cancel, stopped);
  if (good) {
    *stopped = !close_joints(&l, in->flattening->state, cancel);
    good = !*stopped;
  }
  good = good && number_vertices(&l, cancel, stopped) &&
         turn_pieces(&l, in->root, cancel, stopped) &&
         place_vertices(&l, in->root != SG_NO_FACE, cancel, stopped);
  clear_layer(&l);
  return good;
}

void
sg_layout_clear(sg_layout *layout)
{
  free(layout->piece);
  free(layout->root);
  free(layout->vertex);
  free(layout->first);
  free(layout->at);
  free(layout->box);
  *layout = (sg_layout){0};
}
