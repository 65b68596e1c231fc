/* lay.c -- see lay.h. */
#include "lay.h"

#include "flat_fit.h"
#include "twofold.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POLL_EVERY = 16384 };

/* ---- numbers of twice the digits, without bounds ------------------------ */

typedef struct twin {
  double hi, lo;
} twin;

static twin
plus(twin a, twin b)
{
  twin out;
  double s, t;

  sg_two_sum(a.hi, b.hi, &s, &t);
  sg_two_sum(s, t + (a.lo + b.lo), &out.hi, &out.lo);
  return out;
}

static twin
minus(twin a, twin b)
{
  return plus(a, (twin){-b.hi, -b.lo});
}

static twin
times(twin a, twin b)
{
  twin out;
  double h, l;

  sg_two_product(a.hi, b.hi, &h, &l);
  sg_two_sum(h, l + (a.hi * b.lo + a.lo * b.hi), &out.hi, &out.lo);
  return out;
}

typedef struct place {
  twin x, y;
} place;

/* ---- laying out --------------------------------------------------------- */

typedef struct layer {
  const sg_flattening *fl;
  const sg_flat_faces *faces;
  const sg_dense *dense;
  sg_layout *out;
  place *at;       /* [corners] from the root of the piece */
  uint32_t *class; /* [corners] a corner that is the same vertex, or itself */
  uint32_t *order; /* [faces] piece by piece, from the root of each */
  uint32_t *stack; /* [faces] that are laid, but not those that hang on them */
  double touch;
} layer;

static uint32_t
find(uint32_t *class, uint32_t c)
{
  while (class[c] != c) {
    class[c] = class[class[c]];
    c = class[c];
  }
  return c;
}

static void
unite(uint32_t *class, uint32_t a, uint32_t b)
{
  a = find(class, a);
  b = find(class, b);
  class[a > b ? a : b] = a < b ? a : b;
}

/* The root as it is in its own frame, whose x, along its longest side, goes up;
 * the start of that side is the origin. */
static void
lay_root(layer *l, uint32_t face)
{
  const sg_flat_faces *f = l->faces;
  const double *from = f->side_begin[face] < f->side_begin[face + 1]
                           ? f->at[f->side[f->longest[face]].from]
                           : f->at[f->corner_begin[face]];

  for (uint32_t c = f->corner_begin[face]; c < f->corner_begin[face + 1]; c++) {
    l->at[c].x = (twin){-(f->at[c][1] - from[1]), 0};
    l->at[c].y = (twin){f->at[c][0] - from[0], 0};
  }
}

/* A corner c of a face whose side from a to b is laid: what c - a is of b - a
 * in the solid, as a complex number, it is in the pattern. */
static void
lay_corner(layer *l, const double normal[3], uint32_t a, uint32_t b, uint32_t c)
{
  const double *pa = l->dense->at[l->faces->vertex[a]];
  const double *pb = l->dense->at[l->faces->vertex[b]];
  const double *pc = l->dense->at[l->faces->vertex[c]];
  double e[3], w[3], square = 0, along = 0, across;

  for (int k = 0; k < 3; k++) {
    e[k] = pb[k] - pa[k];
    w[k] = pc[k] - pa[k];
    square += e[k] * e[k];
    along += e[k] * w[k];
  }
  across = normal[0] * (e[1] * w[2] - e[2] * w[1]) +
           normal[1] * (e[2] * w[0] - e[0] * w[2]) +
           normal[2] * (e[0] * w[1] - e[1] * w[0]);
  if (square > 0) {
    twin u = {along / square, 0}, v = {across / square, 0};
    twin x = minus(l->at[b].x, l->at[a].x), y = minus(l->at[b].y, l->at[a].y);
    l->at[c].x = plus(l->at[a].x, minus(times(u, x), times(v, y)));
    l->at[c].y = plus(l->at[a].y, plus(times(u, y), times(v, x)));
  } else {
    l->at[c] = l->at[a];
  }
}

/* The face that hangs on another one, by these sides. */
static void
lay_child(layer *l, uint32_t parent_side, uint32_t side)
{
  const sg_flat_faces *f = l->faces;
  const sg_flat_side *on = &f->side[parent_side], *own = &f->side[side];
  uint32_t face = f->face_of[side];

  l->at[own->from] = l->at[on->to];
  l->at[own->to] = l->at[on->from];
  unite(l->class, own->from, on->to);
  unite(l->class, own->to, on->from);
  for (uint32_t c = f->corner_begin[face]; c < f->corner_begin[face + 1]; c++) {
    if (c != own->from && c != own->to) {
      lay_corner(l, f->normal[face], own->from, own->to, c);
    }
  }
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

/* Lays out the piece of a root; the n faces before it are in order. */
static size_t
lay_piece(layer *l, uint32_t root, uint32_t piece, size_t n,
          const sg_poll *poll, bool *stopped)
{
  size_t top = 0;

  lay_root(l, root);
  l->out->piece[root] = piece;
  l->stack[top++] = root;
  while (top > 0 && !*stopped) {
    uint32_t face = l->stack[--top];
    l->order[n++] = face;
    top = lay_children(l, face, piece, top);
    *stopped = n % POLL_EVERY == 0 && sg_poll_stop(poll);
  }
  return n;
}

/* ---- pieces ------------------------------------------------------------- */

typedef struct ranked {
  double area;
  uint32_t root;
} ranked;

/* Areas are rounded to steps, so that equal ones are equal. */
static int
compare_ranked(const void *a, const void *b)
{
  const ranked *x = a, *y = b;

  if (x->area != y->area) {
    return x->area > y->area ? -1 : 1;
  }
  return (x->root > y->root) - (x->root < y->root);
}

/* The largest face of each island, and the islands by area. Null: no memory. */
static ranked *
rank_pieces(const sg_lay_input *in, size_t *pieces)
{
  const sg_flattening *fl = in->flattening;
  const double *area = fl->faces->area;
  ranked *rank = malloc((fl->faces->faces + 1) * sizeof *rank);
  double step = fl->sheet * fl->sheet * 0x1p-36;

  *pieces = 0;
  for (uint32_t i = 0; rank && i < fl->faces->faces; i++) {
    double sum = 0;
    uint32_t root = fl->island[i].head;
    if (root == UINT32_MAX) {
      continue;
    }
    for (uint32_t face = root; face != UINT32_MAX; face = fl->next_face[face]) {
      sum += area[face];
      if (area[face] > area[root] ||
          (face < root && area[face] == area[root])) {
        root = face;
      }
    }
    if (in->root != SG_NO_FACE && fl->island_of[in->root] == i) {
      root = in->root;
      sum = INFINITY;
    }
    rank[(*pieces)++] =
        (ranked){step > 0 && isfinite(sum) ? round(sum / step) : sum, root};
  }
  if (rank) {
    qsort(rank, *pieces, sizeof *rank, compare_ranked);
  }
  return rank;
}

static bool
lay_pieces(layer *l, const sg_lay_input *in, const sg_poll *poll, bool *stopped)
{
  ranked *rank = rank_pieces(in, &l->out->pieces);
  size_t n = 0;
  bool good = rank != NULL;

  l->out->root = malloc((l->out->pieces + 1) * sizeof *l->out->root);
  l->out->box = malloc((l->out->pieces + 1) * sizeof *l->out->box);
  good = good && l->out->root && l->out->box;
  for (uint32_t k = 0; good && k < l->out->pieces; k++) {
    l->out->root[k] = rank[k].root;
    n = lay_piece(l, rank[k].root, k, n, poll, stopped);
    good = !*stopped;
  }
  free(rank);
  return good;
}

/* ---- joints that close -------------------------------------------------- */

static bool
is_near(const layer *l, uint32_t a, uint32_t b)
{
  const place *p = &l->at[a], *q = &l->at[b];

  return hypot(p->x.hi - q->x.hi, p->y.hi - q->y.hi) <= l->touch;
}

static void
close_joints(layer *l, unsigned char *state)
{
  const sg_flat_faces *f = l->faces;

  for (size_t k = 0; k < l->fl->joints->n; k++) {
    const sg_joint *j = &l->fl->joints->joint[k];
    const sg_flat_side *a = &f->side[j->side[0]], *b = &f->side[j->side[1]];
    if (state[k] == SG_JOINT_SAME && !j->line && is_near(l, a->from, b->to) &&
        is_near(l, a->to, b->from)) {
      state[k] = SG_JOINT_CLOSED;
      unite(l->class, a->from, b->to);
      unite(l->class, a->to, b->from);
    }
  }
}

/* ---- turning ------------------------------------------------------------ */

/* Room for the points of the largest piece, twice. */
typedef struct turner {
  double (*point)[2], (*room)[2];
} turner;

static sg_flat_fit
fit_piece(const layer *l, const uint32_t *face, size_t n, const turner *t)
{
  const sg_flat_faces *f = l->faces;
  size_t points = 0;

  for (size_t i = 0; i < n; i++) {
    for (uint32_t c = f->corner_begin[face[i]];
         c < f->corner_begin[face[i] + 1]; c++) {
      if (l->class[c] == c) {
        t->point[points][0] = l->at[c].x.hi;
        t->point[points++][1] = l->at[c].y.hi;
      }
    }
  }
  return sg_flat_fit_find(t->point, points, t->room);
}

/* A direction as unit numbers of twice the digits: one step of Newton's. */
static void
make_unit(double x, double y, place *out)
{
  twin rest = minus((twin){1, 0}, plus(times((twin){x, 0}, (twin){x, 0}),
                                       times((twin){y, 0}, (twin){y, 0})));
  twin scale = plus((twin){1, 0}, times(rest, (twin){0.5, 0}));

  out->x = times((twin){x, 0}, scale);
  out->y = times((twin){y, 0}, scale);
}

static void
turn_corners(layer *l, const uint32_t *face, size_t n, double x, double y,
             sg_flat_box *box)
{
  const sg_flat_faces *f = l->faces;
  place d;

  make_unit(x, y, &d);
  *box = (sg_flat_box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (size_t i = 0; i < n; i++) {
    for (uint32_t c = f->corner_begin[face[i]];
         c < f->corner_begin[face[i] + 1]; c++) {
      place p = l->at[c];
      l->at[c].x = plus(times(p.x, d.x), times(p.y, d.y));
      l->at[c].y = minus(times(p.y, d.x), times(p.x, d.y));
      const double at[2] = {l->at[c].x.hi, l->at[c].y.hi};
      for (int k = 0; k < 2; k++) {
        box->low[k] = fmin(box->low[k], at[k]);
        box->high[k] = fmax(box->high[k], at[k]);
      }
    }
  }
}

/* Piece by piece; one with the root that was
 * asked for stays as it is. */
static bool
turn_pieces(layer *l, uint32_t root, const sg_poll *poll, bool *stopped)
{
  size_t corners = l->faces->corners, n = 0;
  turner t = {malloc((corners + 1) * sizeof *t.point),
              malloc((corners + 2) * sizeof *t.room)};
  bool good = t.point && t.room;

  for (uint32_t k = 0; good && k < l->out->pieces; k++) {
    const uint32_t *face = l->order + n;
    size_t faces = 0;
    while (n + faces < l->faces->faces && l->out->piece[face[faces]] == k) {
      faces++;
    }
    bool still = root != SG_NO_FACE && k == 0;
    sg_flat_fit turned =
        still ? (sg_flat_fit){1, 0} : fit_piece(l, face, faces, &t);
    if (sg_poll_stop(poll)) {
      *stopped = true;
      good = false;
      break;
    }
    turn_corners(l, face, faces, turned.x, turned.y, &l->out->box[k]);
    n += faces;
    if (sg_poll_stop(poll)) {
      *stopped = true;
      good = false;
    }
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

static bool
number_vertices(layer *l, bool still, const sg_poll *poll, bool *stopped)
{
  const sg_flat_faces *f = l->faces;
  sg_layout *out = l->out;
  size_t corners = f->corners;
  double(*to)[2] = malloc((out->pieces + 1) * sizeof *to);

  out->vertex = malloc((corners + 1) * sizeof *out->vertex);
  out->first = malloc((corners + 1) * sizeof *out->first);
  out->at = malloc((corners + 1) * sizeof *out->at);
  if (!to || !out->vertex || !out->first || !out->at) {
    free(to);
    return false;
  }
  arrange(out, still, to);
  for (uint32_t face = 0; face < f->faces && !*stopped; face++) {
    const double *shift = to[out->piece[face]];
    *stopped = face % POLL_EVERY == 0 && sg_poll_stop(poll);
    for (uint32_t c = f->corner_begin[face]; c < f->corner_begin[face + 1];
         c++) {
      uint32_t same = find(l->class, c);
      if (same == c) {
        out->at[out->vertices][0] =
            plus(l->at[c].x, (twin){shift[0], 0}).hi + 0.0;
        out->at[out->vertices][1] =
            plus(l->at[c].y, (twin){shift[1], 0}).hi + 0.0;
        out->first[out->vertices] = c;
        out->vertex[c] = (uint32_t)out->vertices++;
      } else {
        out->vertex[c] = out->vertex[same];
      }
    }
  }
  for (size_t k = 0; k < out->pieces; k++) {
    for (int c = 0; c < 2; c++) {
      out->box[k].low[c] += to[k][c];
      out->box[k].high[c] += to[k][c];
    }
  }
  free(to);
  return !*stopped;
}

bool
sg_lay(const sg_lay_input *in, const sg_poll *poll, sg_layout *out,
       bool *stopped)
{
  const sg_flattening *fl = in->flattening;
  const sg_flat_faces *f = fl->faces;
  layer l = {.fl = fl,
             .faces = f,
             .dense = fl->dense,
             .out = out,
             .at = malloc((f->corners + 1) * sizeof *l.at),
             .class = malloc((f->corners + 1) * sizeof *l.class),
             .order = malloc((f->faces + 1) * sizeof *l.order),
             .stack = malloc((f->faces + 1) * sizeof *l.stack),
             .touch = in->touch};
  bool good;

  *stopped = false;
  *out = (sg_layout){.piece = malloc((f->faces + 1) * sizeof *out->piece)};
  good = l.at && l.class && l.order && l.stack && out->piece;
  if (good) {
    memset(out->piece, 0xff, (f->faces + 1) * sizeof *out->piece);
    for (uint32_t c = 0; c < f->corners; c++) {
      l.class[c] = c;
    }
    good = lay_pieces(&l, in, poll, stopped);
  }
  if (good) {
    close_joints(&l, fl->state);
    *stopped = sg_poll_stop(poll);
    good = !*stopped;
  }
  if (good) {
    good = turn_pieces(&l, in->root, poll, stopped) &&
           number_vertices(&l, in->root != SG_NO_FACE, poll, stopped);
  }
  free(l.at);
  free(l.class);
  free(l.order);
  free(l.stack);
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
