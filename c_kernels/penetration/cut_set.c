#include "cut_private.h"

#include <stdlib.h>
#include <string.h>

void
sg_cut_set_init(sg_cut_set *set, sg_is_real *is_real, void *data)
{
  memset(set, 0, sizeof *set);
  set->is_real = is_real;
  set->data = data;
  sg_cut_model_init(&set->model);
  sg_cut_points_init(&set->points, &set->model);
  sg_key_table_init(&set->piece_number, SG_KEY_WORDS);
  sg_key_table_init(&set->edge_number, 2);
  sg_key_table_init(&set->late, 2);
  sg_key_table_init(&set->at_place, 6);
  sg_key_table_init(&set->side_of, 2);
  sg_key_table_init(&set->inside, 3);
}

void
sg_cut_set_clear(sg_cut_set *set)
{
  for (size_t i = 0; i < set->edges; i++) {
    free(set->edge[i].point);
  }
  sg_cut_points_clear(&set->points);
  sg_cut_model_clear(&set->model);
  sg_key_table_clear(&set->piece_number);
  sg_key_table_clear(&set->edge_number);
  sg_key_table_clear(&set->late);
  sg_key_table_clear(&set->at_place);
  sg_key_table_clear(&set->side_of);
  sg_key_table_clear(&set->inside);
  free(set->flat_touch);
  free(set->place_of);
  free(set->next_side);
  free(set->cut);
  free(set->contact);
  free(set->piece);
  free(set->edge);
  free(set->polygon);
  free(set->entering);
  free(set->at);
  free(set->degree);
  free(set->gone);
  sg_cut_set_init(set, set->is_real, set->data);
}

/* ---- real edges ---- */

/* Whether a feature of a triangle is a real edge: 1 or 0; -1: no memory. */
static int
is_real_edge(const sg_cut_set *set, uint32_t triangle, int f)
{
  return f < SG_EDGE_0 || f > SG_EDGE_2
             ? 0
             : set->is_real(set->data, triangle, f - SG_EDGE_0);
}

/* The number of a real edge, made if it is new; SG_NO_KEY: no memory. */
static uint32_t
split_edge(sg_cut_set *set, const sg_place *place)
{
  uint32_t *number =
      sg_key_table_put(&set->edge_number, (uint32_t[2]){place->a, place->b});

  if (!number || !sg_list_grow(&set->edge, set->edges, &set->edge_room,
                               sizeof *set->edge)) {
    return SG_NO_KEY;
  }
  if (*number == SG_NO_KEY) {
    *number = (uint32_t)set->edges;
    set->edge[set->edges++] = (sg_split_edge){
        *place, sg_place_segment(&set->model, place), false, 0, 0, NULL};
  }
  return *number;
}

static bool
put_on_edge(sg_cut_set *set, const sg_place *place, uint32_t point)
{
  uint32_t number = split_edge(set, place);
  sg_split_edge *edge = &set->edge[number];

  if (number == SG_NO_KEY ||
      !sg_list_grow(&edge->point, edge->n, &edge->room, sizeof *edge->point)) {
    return false;
  }
  edge->point[edge->n++] = point;
  sg_cut_points_on_edge(&set->points, point, place);
  return true;
}

/* ---- entering cuts ---- */

uint32_t
sg_cut_end_point(sg_cut_set *set, const uint32_t t[2], const sg_cut_end *end)
{
  sg_made made = {2,
                  {sg_place_of(&set->model, t[0], (int)end->f[0]),
                   sg_place_of(&set->model, t[1], (int)end->f[1])}};
  uint32_t point = sg_cut_points_find(&set->points, &made);

  for (int k = 0; point != SG_NO_KEY && k < 2; k++) {
    int real = is_real_edge(set, t[k], (int)end->f[k]);

    if (real < 0 || (real && !put_on_edge(set, &made.place[k], point))) {
      return SG_NO_KEY;
    }
  }
  return point;
}

/* Along which real edges a cut runs. False: no memory. */
static bool
find_carriers(sg_cut_set *set, const sg_cut *cut, sg_cut_piece *piece)
{
  for (int k = 0; k < 2; k++) {
    int f = SG_EDGE_0 + sg_cut_along(cut, k);
    int real = is_real_edge(set, piece->triangle[k], f);

    piece->edge[k] = SG_NO_KEY;
    if (real > 0) {
      sg_place place = sg_place_of(&set->model, piece->triangle[k], f);
      piece->edge[k] = split_edge(set, &place);
    }
    if (real < 0 || (real && piece->edge[k] == SG_NO_KEY)) {
      return false;
    }
  }
  return true;
}

static void
swap_sides(sg_cut_piece *piece)
{
  sg_cut_piece was = *piece;

  for (int k = 0; k < 2; k++) {
    piece->s[k] = was.s[!k];
    piece->p[k] = was.p[!k];
    piece->edge[k] = was.edge[!k];
    piece->triangle[k] = was.triangle[!k];
  }
}

/* Of a segment with itself: an edge first, the smaller one; else the smaller
 * polygon. */
static void
order_sides(sg_cut_piece *piece)
{
  const uint32_t *edge = piece->edge;

  if (piece->s[0] == piece->s[1] &&
      (edge[0] == edge[1] ? piece->p[1] < piece->p[0] : edge[1] < edge[0])) {
    swap_sides(piece);
  }
}

/* Keeps one cut of positive length: 1; 0: inside faces in a common plane, which
 * is no line; -1: no memory. */
static int
keep_cut(sg_cut_set *set, const uint32_t t[2], const sg_cut *cut, bool coplanar)
{
  const sg_leaf_triangle *leaf = set->model.triangle;
  sg_cut_piece piece = {{leaf[t[0]].s, leaf[t[1]].s},
                        {leaf[t[0]].p, leaf[t[1]].p},
                        {SG_NO_KEY, SG_NO_KEY},
                        {t[0], t[1]},
                        SG_NO_KEY,
                        SG_NO_KEY,
                        true};

  int inside = coplanar ? sg_cut_along_inside(set, t, cut) : 0;

  if (inside != 0) {
    return inside > 0 && sg_cut_note_inside(set, t, cut) ? 0 : -1;
  }
  if (!find_carriers(set, cut, &piece)) {
    return -1;
  }
  piece.a = sg_cut_end_point(set, t, &cut->end[0]);
  piece.b = sg_cut_end_point(set, t, &cut->end[1]);
  if (piece.a == SG_NO_KEY || piece.b == SG_NO_KEY ||
      !sg_list_grow(&set->cut, set->cuts, &set->cut_room, sizeof *set->cut)) {
    return -1;
  }
  if (piece.a == piece.b) {
    return 0;
  }
  order_sides(&piece);
  set->cut[set->cuts++] = piece;
  return 1;
}

/* Whether an end of a cut of two triangles is a corner that they share. */
static bool
is_shared_corner(const sg_cut_model *model, const uint32_t t[2],
                 const sg_cut_end *end)
{
  const uint32_t *v = model->triangle[t[0]].v, *w = model->triangle[t[1]].v;

  return end->f[0] <= SG_CORNER_2 && end->f[1] <= SG_CORNER_2 &&
         v[end->f[0]] == w[end->f[1]];
}

/* A corner or an edge that two triangles of one segment share is no cut. */
static bool
is_shared(const sg_cut_model *model, const uint32_t t[2], const sg_cut *cut)
{
  return model->triangle[t[0]].s == model->triangle[t[1]].s &&
         is_shared_corner(model, t, &cut->end[0]) &&
         is_shared_corner(model, t, &cut->end[1]);
}

/* 0, or -1: no memory. */
static int
keep_point(sg_cut_set *set, const uint32_t t[2], const sg_cut_end *end,
           bool coplanar)
{
  if (coplanar || sg_cut_is_flat_pair(set, t)) {
    return sg_cut_put_off(set, t, end) ? 0 : -1;
  }
  return sg_cut_touch(set, t, end);
}

static bool
of_one_polygon(const sg_leaf_triangle *a, const sg_leaf_triangle *b)
{
  return a->s == b->s && a->p == b->p;
}

int
sg_cut_set_enter(sg_cut_set *set, uint32_t t1, uint32_t t2)
{
  const sg_leaf_triangle *leaf = set->model.triangle;
  const uint32_t t[2] = {t1, t2};
  double a[3][3], b[3][3];
  sg_cut cut[SG_CUT_MAX];
  int n, kept = 0;

  if (of_one_polygon(&leaf[t1], &leaf[t2])) {
    return 0;
  }
  sg_cut_model_corners(&set->model, t1, a);
  sg_cut_model_corners(&set->model, t2, b);
  sg_cut_kind kind =
      sg_cut_triangles((const double(*)[3])a, (const double(*)[3])b, cut, &n);

  for (int i = 0; i < n; i++) {
    bool coplanar = kind == SG_CUT_COPLANAR;
    int one = is_shared(&set->model, t, &cut[i]) ? 0
              : sg_cut_is_point(&cut[i])
                  ? keep_point(set, t, &cut[i].end[0], coplanar)
                  : keep_cut(set, t, &cut[i], coplanar);

    if (one < 0) {
      return -1;
    }
    kept += one;
  }
  return kept;
}

static sg_place
curve_place(const sg_leaf_edge *edge)
{
  uint32_t a = edge->v[0], b = edge->v[1];

  return (sg_place){SG_ON_EDGE, a < b ? a : b, a < b ? b : a};
}

/* Notes the point of a curve edge at this end of its cut: 1, or 0 where it is
 * an end of the edge, or inside a face it runs in. -1: no memory. */
static int
keep_curve_point(sg_cut_set *set, const sg_leaf_edge *edge, uint32_t t,
                 const sg_cut_end *end, bool coplanar)
{
  sg_made made = {
      2, {curve_place(edge), sg_place_of(&set->model, t, (int)end->f[1])}};

  if (end->f[0] != SG_EDGE_0) {
    return 0;
  }
  if (coplanar && made.place[1].kind == SG_ON_EDGE) {
    int32_t face;
    int inside = sg_cut_is_inside(set, t, (int)end->f[1] - SG_EDGE_0, &face);

    if (inside != 0) {
      return inside > 0 ? 0 : -1;
    }
  }
  uint32_t point = sg_cut_points_find(&set->points, &made);

  return point != SG_NO_KEY && put_on_edge(set, &made.place[0], point) ? 1 : -1;
}

int
sg_cut_set_enter_curve(sg_cut_set *set, uint32_t e, uint32_t t)
{
  const sg_leaf_edge *edge = &set->model.edge[e];
  double b[3][3];
  sg_cut cut;

  sg_cut_model_corners(&set->model, t, b);
  sg_cut_kind kind = sg_cut_segment(set->model.vertex[edge->v[0]].at,
                                    set->model.vertex[edge->v[1]].at,
                                    (const double(*)[3])b, &cut);

  if (kind == SG_CUT_NONE) {
    return 0;
  }
  bool coplanar = kind == SG_CUT_COPLANAR;
  int first = keep_curve_point(set, edge, t, &cut.end[0], coplanar);
  int second = sg_cut_is_point(&cut)
                   ? 0
                   : keep_curve_point(set, edge, t, &cut.end[1], coplanar);

  return first < 0 || second < 0 ? -1 : first + second;
}

/* ---- sealing: points in order, pieces ---- */

typedef struct direction {
  const sg_cut_points *points;
  const sg_point *from, *to;
} direction;

static int
compare_along(const void *p, const void *q, void *data)
{
  const direction *d = data;
  uint32_t i = *(const uint32_t *)p, j = *(const uint32_t *)q;
  int sign = i == j ? 0
                    : sg_point_along(d->from, d->to, &d->points->point[i].at,
                                     &d->points->point[j].at);

  return sign != 0 ? sign : (i > j) - (i < j);
}

/* Sorts n points along from -> to and drops repeated ones; returns how many
 * are left. */
static size_t
order_points(const sg_cut_points *points, const sg_point *from,
             const sg_point *to, uint32_t *point, size_t n)
{
  direction d = {points, from, to};
  size_t kept = 0;

  if (n == 0) {
    return 0;
  }
  qsort_r(point, n, sizeof *point, compare_along, &d);
  for (size_t i = 0; i < n; i++) {
    if (kept == 0 || point[i] != point[kept - 1]) {
      point[kept++] = point[i];
    }
  }
  return kept;
}

static void
order_edge(sg_cut_set *set, sg_split_edge *edge)
{
  sg_point from, to;

  sg_point_set(&from, set->model.vertex[edge->place.a].at);
  sg_point_set(&to, set->model.vertex[edge->place.b].at);
  edge->n = order_points(&set->points, &from, &to, edge->point, edge->n);
}

/* Mostly an edge has few points, each of which may cost exact signs. */
enum { STEPS_ASKED = 256 };

static bool
is_stopped(const sg_cancel *cancel, size_t i)
{
  return i % STEPS_ASKED == 0 && sg_cancelled(cancel);
}

/* False: stopped. */
static bool
order_edges(sg_cut_set *set, const sg_cancel *cancel)
{
  for (size_t i = 0; i < set->edges; i++) {
    if (is_stopped(cancel, i)) {
      return false;
    }
    order_edge(set, &set->edge[i]);
  }
  return true;
}

/* What carries a piece in side k: twice a polygon, or along an edge 1, of a
 * segment that is cut by itself and twice the edge. */
static uint32_t
carrier(const sg_cut_set *set, const sg_cut_piece *piece, int k)
{
  if (piece->edge[k] == SG_NO_KEY) {
    return 2 * (uint32_t)piece->p[k];
  }
  return sg_cut_points_is_by_itself(&set->points, piece->s[k])
             ? 2 * piece->edge[k] + 1
             : 1;
}

/* Pieces of one pair of segments between the same points are one if they run
 * along edges, or through the same polygons: sheets of a segment may lie on
 * each other, or touch in a line. */
static void
piece_key(const sg_cut_set *set, const sg_cut_piece *piece,
          uint32_t key[SG_KEY_WORDS])
{
  for (int k = 0; k < 2; k++) {
    key[k] = (uint32_t)piece->s[k];
    key[2 + k] = carrier(set, piece, k);
  }
  key[4] = piece->a < piece->b ? piece->a : piece->b;
  key[5] = piece->a < piece->b ? piece->b : piece->a;
}

bool
sg_cut_add_piece(sg_cut_set *set, const sg_cut_piece *piece)
{
  uint32_t key[SG_KEY_WORDS];

  piece_key(set, piece, key);
  uint32_t *number = sg_key_table_put(&set->piece_number, key);

  if (!number || !sg_list_grow(&set->piece, set->pieces, &set->piece_room,
                               sizeof *set->piece)) {
    return false;
  }
  if (*number == SG_NO_KEY) {
    *number = (uint32_t)set->pieces;
    set->piece[set->pieces++] = *piece;
    return true;
  }
  sg_cut_piece *known = &set->piece[*number];

  for (int k = 0; k < 2; k++) {
    if (piece->p[k] < known->p[k]) {
      known->p[k] = piece->p[k];
    }
  }
  return true;
}

/* Where a point stands on a split edge: 1 .. n for its points, 0 and n + 1
 * for its ends. */
static size_t
rank_on_edge(const sg_cut_set *set, const sg_split_edge *edge, uint32_t point)
{
  const sg_leaf_vertex *start = &set->model.vertex[edge->place.a];

  for (size_t i = 0; i < edge->n; i++) {
    if (edge->point[i] == point) {
      return i + 1;
    }
  }
  return sg_cut_points_named(&set->points, start->s, start->v) == point
             ? 0
             : edge->n + 1;
}

bool
sg_cut_put_late(sg_cut_set *set, uint32_t number, uint32_t point)
{
  const sg_split_edge *edge = &set->edge[number];
  sg_place place = edge->place;

  for (size_t i = 0; i < edge->n; i++) {
    if (edge->point[i] == point) {
      return true;
    }
  }
  if (!put_on_edge(set, &place, point)) {
    return false;
  }
  order_edge(set, &set->edge[number]);
  set->edge[number].late = true;
  return true;
}

/* Appends the points of an edge strictly between a and b to `list`. */
static bool
points_between(const sg_cut_set *set, uint32_t number, uint32_t a, uint32_t b,
               uint32_t **list, size_t *n, size_t *room)
{
  const sg_split_edge *edge = &set->edge[number];
  size_t i = rank_on_edge(set, edge, a), j = rank_on_edge(set, edge, b);
  size_t low = i < j ? i : j, high = i < j ? j : i;

  for (size_t k = low + 1; k < high; k++) {
    if (!sg_list_grow(list, *n, room, sizeof **list)) {
      return false;
    }
    (*list)[(*n)++] = edge->point[k - 1];
  }
  return true;
}

/* Divides one cut at the points of the edges it runs along. */
static bool
add_divided(sg_cut_set *set, const sg_cut_piece *cut)
{
  uint32_t *list = NULL;
  size_t n = 0, room = 0;
  bool good = true;
  sg_cut_piece piece = *cut;

  for (int k = 0; k < 2 && good; k++) {
    good = cut->edge[k] == SG_NO_KEY ||
           points_between(set, cut->edge[k], cut->a, cut->b, &list, &n, &room);
  }
  if (n > 0) {
    n = order_points(&set->points, &set->points.point[cut->a].at,
                     &set->points.point[cut->b].at, list, n);
  }
  for (size_t i = 0; i <= n && good; i++) {
    piece.b = i < n ? list[i] : cut->b;
    good = piece.a == piece.b || sg_cut_add_piece(set, &piece);
    piece.a = piece.b;
  }
  free(list);
  return good;
}

/* Puts what is on edge `from` strictly between a and b on edge `to` as well.
 * Notes in *changed whether that was new. False: no memory. */
static bool
share_points(sg_cut_set *set, uint32_t from, uint32_t to, uint32_t a,
             uint32_t b, bool *changed)
{
  uint32_t *list = NULL;
  size_t n = 0, room = 0;
  size_t before = set->edge[to].n;
  bool good = points_between(set, from, a, b, &list, &n, &room);

  for (size_t i = 0; i < n && good; i++) {
    sg_place place = set->edge[to].place;
    good = put_on_edge(set, &place, list[i]);
  }
  if (n > 0 && good) {
    order_edge(set, &set->edge[to]);
    *changed = *changed || set->edge[to].n > before;
  }
  free(list);
  return good;
}

/* Where a cut runs along two real edges at once, both have the same points
 * there. A third edge may lie there too, hence until nothing is new. */
static bool
share_edge_points(sg_cut_set *set, const sg_cancel *cancel)
{
  bool changed = true;

  while (changed) {
    changed = false;
    for (size_t i = 0; i < set->cuts; i++) {
      const sg_cut_piece *cut = &set->cut[i];

      if (is_stopped(cancel, i)) {
        return false;
      }
      if (cut->edge[0] != SG_NO_KEY && cut->edge[1] != SG_NO_KEY &&
          !(share_points(set, cut->edge[0], cut->edge[1], cut->a, cut->b,
                         &changed) &&
            share_points(set, cut->edge[1], cut->edge[0], cut->a, cut->b,
                         &changed))) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_cut_set_seal(sg_cut_set *set, const sg_cancel *cancel)
{
  if (!sg_cut_touch_flat(set, cancel) || !sg_cut_drop_folds(set, cancel) ||
      !order_edges(set, cancel) || !share_edge_points(set, cancel)) {
    return false;
  }
  for (size_t i = 0; i < set->cuts; i++) {
    if (is_stopped(cancel, i) || !add_divided(set, &set->cut[i])) {
      return false;
    }
  }
  return sg_cut_settle_contacts(set, cancel);
}
