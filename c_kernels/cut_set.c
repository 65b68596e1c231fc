#include "cut_set.h"

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
  sg_key_table_init(&set->piece_number, 4);
  sg_key_table_init(&set->edge_number, 2);
  sg_key_table_init(&set->late, 2);
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
  free(set->cut);
  free(set->piece);
  free(set->edge);
  free(set->polygon);
  free(set->entering);
  free(set->at);
  free(set->degree);
  free(set->gone);
  sg_cut_set_init(set, set->is_real, set->data);
}

/* Makes room in a growing array; false: no memory. */
static bool
make_room(void **array, size_t n, size_t *room, size_t size)
{
  if (n < *room) {
    return true;
  }
  size_t more = *room ? 2 * *room : 32;
  void *grown = realloc(*array, more * size);

  if (!grown) {
    return false;
  }
  *array = grown;
  *room = more;
  return true;
}

/* ---- real edges ---- */

static bool
edge_is_real(const sg_cut_set *set, const sg_place *place)
{
  const sg_leaf_vertex *vertex = set->model.vertex;

  return set->is_real(set->data, vertex[place->a].s, vertex[place->a].v,
                      vertex[place->b].v);
}

/* The number of a real edge, made if it is new; SG_NO_KEY: no memory. */
static uint32_t
split_edge(sg_cut_set *set, const sg_place *place)
{
  uint32_t *number =
      sg_key_table_put(&set->edge_number, (uint32_t[2]){place->a, place->b});

  if (!number || !make_room((void **)&set->edge, set->edges, &set->edge_room,
                            sizeof *set->edge)) {
    return SG_NO_KEY;
  }
  if (*number == SG_NO_KEY) {
    *number = (uint32_t)set->edges;
    set->edge[set->edges++] = (sg_split_edge){
        *place, sg_place_segment(&set->model, place), 0, 0, NULL};
  }
  return *number;
}

static bool
put_on_edge(sg_cut_set *set, const sg_place *place, uint32_t point)
{
  uint32_t number = split_edge(set, place);
  sg_split_edge *edge = &set->edge[number];

  if (number == SG_NO_KEY ||
      !make_room((void **)&edge->point, edge->n, &edge->room,
                 sizeof *edge->point)) {
    return false;
  }
  edge->point[edge->n++] = point;
  sg_cut_points_on_edge(&set->points, point, place);
  return true;
}

/* ---- entering cuts ---- */

/* The point of one end; notes the real edges it splits. */
static uint32_t
end_point(sg_cut_set *set, const uint32_t t[2], const sg_cut_end *end)
{
  sg_made made = {2,
                  {sg_place_of(&set->model, t[0], (int)end->f[0]),
                   sg_place_of(&set->model, t[1], (int)end->f[1])}};
  uint32_t point = sg_cut_points_find(&set->points, &made);

  for (int k = 0; point != SG_NO_KEY && k < 2; k++) {
    const sg_place *place = &made.place[k];

    if (place->kind == SG_ON_EDGE && edge_is_real(set, place) &&
        !put_on_edge(set, place, point)) {
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
    int along = sg_cut_along(cut, k);
    sg_place place;

    piece->edge[k] = SG_NO_KEY;
    if (along < 0) {
      continue;
    }
    place = sg_place_of(&set->model, piece->triangle[k], SG_EDGE_0 + along);
    if (edge_is_real(set, &place)) {
      piece->edge[k] = split_edge(set, &place);
      if (piece->edge[k] == SG_NO_KEY) {
        return false;
      }
    }
  }
  return true;
}

/* Keeps one cut of positive length: 1; 0: a chord in a common plane, which is
 * no line; -1: no memory. */
static int
keep_cut(sg_cut_set *set, const uint32_t t[2], const sg_cut *cut,
         bool coplanar)
{
  const sg_leaf_triangle *leaf = set->model.triangle;
  sg_cut_piece piece = {{leaf[t[0]].s, leaf[t[1]].s},
                        {leaf[t[0]].p, leaf[t[1]].p},
                        {SG_NO_KEY, SG_NO_KEY},
                        {t[0], t[1]},
                        SG_NO_KEY,
                        SG_NO_KEY,
                        true};

  if (!find_carriers(set, cut, &piece)) {
    return -1;
  }
  if (coplanar && piece.edge[0] == SG_NO_KEY && piece.edge[1] == SG_NO_KEY) {
    return 0;
  }
  piece.a = end_point(set, t, &cut->end[0]);
  piece.b = end_point(set, t, &cut->end[1]);
  if (piece.a == SG_NO_KEY || piece.b == SG_NO_KEY ||
      !make_room((void **)&set->cut, set->cuts, &set->cut_room,
                 sizeof *set->cut)) {
    return -1;
  }
  if (piece.a == piece.b) {
    return 0;
  }
  set->cut[set->cuts++] = piece;
  return 1;
}

int
sg_cut_set_enter(sg_cut_set *set, uint32_t t1, uint32_t t2)
{
  double a[3][3], b[3][3];
  sg_cut cut[SG_CUT_MAX];
  int n, kept = 0;

  sg_cut_model_corners(&set->model, t1, a);
  sg_cut_model_corners(&set->model, t2, b);
  sg_cut_kind kind = sg_cut_triangles((const double(*)[3])a,
                                      (const double(*)[3])b, cut, &n);

  for (int i = 0; i < n; i++) {
    if (!sg_cut_is_point(&cut[i])) {
      int one = keep_cut(set, (uint32_t[2]){t1, t2}, &cut[i],
                         kind == SG_CUT_COPLANAR);
      if (one < 0) {
        return -1;
      }
      kept += one;
    }
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
 * an end of the edge, or only a chord is met. -1: no memory. */
static int
keep_curve_point(sg_cut_set *set, const sg_leaf_edge *edge, uint32_t t,
                 const sg_cut_end *end, bool coplanar)
{
  sg_made made = {
      2, {curve_place(edge), sg_place_of(&set->model, t, (int)end->f[1])}};

  if (end->f[0] != SG_EDGE_0) {
    return 0;
  }
  if (coplanar && made.place[1].kind == SG_ON_EDGE &&
      !edge_is_real(set, &made.place[1])) {
    return 0;
  }
  uint32_t point = sg_cut_points_find(&set->points, &made);

  return point != SG_NO_KEY && put_on_edge(set, &made.place[0], point) ? 1
                                                                       : -1;
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

  qsort_r(point, n, sizeof *point, compare_along, &d);
  for (size_t i = 0; i < n; i++) {
    if (kept == 0 || point[i] != point[kept - 1]) {
      point[kept++] = point[i];
    }
  }
  return kept;
}

static void
order_edges(sg_cut_set *set)
{
  for (size_t i = 0; i < set->edges; i++) {
    sg_split_edge *edge = &set->edge[i];
    sg_point from, to;

    sg_point_set(&from, set->model.vertex[edge->place.a].at);
    sg_point_set(&to, set->model.vertex[edge->place.b].at);
    edge->n = order_points(&set->points, &from, &to, edge->point, edge->n);
  }
}

/* Adds a piece, or finds the same one: pieces of one pair of segments between
 * the same points are one. Along an edge the smaller polygon counts. */
static bool
add_piece(sg_cut_set *set, const sg_cut_piece *piece)
{
  uint32_t low = piece->a < piece->b ? piece->a : piece->b;
  uint32_t high = piece->a < piece->b ? piece->b : piece->a;
  uint32_t key[4] = {(uint32_t)piece->s[0], (uint32_t)piece->s[1], low, high};
  uint32_t *number = sg_key_table_put(&set->piece_number, key);

  if (!number || !make_room((void **)&set->piece, set->pieces,
                            &set->piece_room, sizeof *set->piece)) {
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
  return sg_cut_points_name(&set->points, point, start->s) == start->v
             ? 0
             : edge->n + 1;
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
    if (!make_room((void **)list, *n, room, sizeof **list)) {
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
    good = piece.a == piece.b || add_piece(set, &piece);
    piece.a = piece.b;
  }
  free(list);
  return good;
}

bool
sg_cut_set_seal(sg_cut_set *set)
{
  order_edges(set);
  for (size_t i = 0; i < set->cuts; i++) {
    if (!add_divided(set, &set->cut[i])) {
      return false;
    }
  }
  return true;
}

/* ---- polygons ---- */

bool
sg_cut_set_add_polygon(sg_cut_set *set, int32_t s, int32_t p)
{
  if (!make_room((void **)&set->polygon, set->polygons, &set->polygon_room,
                 sizeof *set->polygon)) {
    return false;
  }
  set->polygon[set->polygons++] = (sg_cut_polygon){s, p, 0, 0};
  return true;
}

static int
compare_polygons(const void *x, const void *y)
{
  const sg_cut_polygon *a = x, *b = y;
  int by_s = (a->s > b->s) - (a->s < b->s);

  return by_s ? by_s : (a->p > b->p) - (a->p < b->p);
}

static sg_cut_polygon *
find_polygon(const sg_cut_set *set, int32_t s, int32_t p)
{
  sg_cut_polygon key = {s, p, 0, 0};

  return bsearch(&key, set->polygon, set->polygons, sizeof key,
                 compare_polygons);
}

static void
drop_repeated(sg_cut_set *set)
{
  size_t kept = 0;

  for (size_t i = 0; i < set->polygons; i++) {
    if (kept == 0 ||
        compare_polygons(&set->polygon[i], &set->polygon[kept - 1]) != 0) {
      set->polygon[kept++] = set->polygon[i];
    }
  }
  set->polygons = kept;
}

/* Calls for each piece and side that enters a polygon: counts it, or (when
 * there is room) files it. */
static void
file_pieces(sg_cut_set *set)
{
  for (uint32_t i = 0; i < set->pieces; i++) {
    for (int k = 0; k < 2; k++) {
      if (set->piece[i].edge[k] == SG_NO_KEY) {
        sg_cut_polygon *polygon =
            find_polygon(set, set->piece[i].s[k], set->piece[i].p[k]);

        if (set->entering) {
          set->entering[polygon->first + polygon->n] = i;
        }
        polygon->n++;
      }
    }
  }
}

bool
sg_cut_set_group(sg_cut_set *set)
{
  size_t total = 0;

  for (size_t i = 0; i < set->pieces; i++) {
    for (int k = 0; k < 2; k++) {
      if (set->piece[i].edge[k] == SG_NO_KEY &&
          !sg_cut_set_add_polygon(set, set->piece[i].s[k],
                                  set->piece[i].p[k])) {
        return false;
      }
    }
  }
  if (set->polygons == 0) {
    return true;
  }
  qsort(set->polygon, set->polygons, sizeof *set->polygon, compare_polygons);
  drop_repeated(set);
  file_pieces(set); /* counts */
  for (size_t i = 0; i < set->polygons; i++) {
    set->polygon[i].first = total;
    total += set->polygon[i].n;
    set->polygon[i].n = 0;
  }
  set->entering = malloc((total + 1) * sizeof *set->entering);
  if (!set->entering) {
    return false;
  }
  file_pieces(set);
  return true;
}

/* ---- late splits ---- */

static void
pair_key(uint32_t a, uint32_t b, uint32_t key[2])
{
  key[0] = a < b ? a : b;
  key[1] = a < b ? b : a;
}

uint32_t
sg_cut_set_between(const sg_cut_set *set, uint32_t a, uint32_t b)
{
  uint32_t key[2];

  pair_key(a, b, key);
  return sg_key_table_get(&set->late, key);
}

bool
sg_cut_set_split(sg_cut_set *set, uint32_t a, uint32_t b, uint32_t x)
{
  const sg_cut_point *point = set->points.point;
  uint32_t key[2], *known;

  while (x != a && x != b) {
    pair_key(a, b, key);
    known = sg_key_table_put(&set->late, key);
    if (!known) {
      return false;
    }
    if (*known == SG_NO_KEY) {
      *known = x;
    }
    if (*known == x) {
      return true;
    }
    int side = sg_point_along(&point[a].at, &point[b].at, &point[x].at,
                              &point[*known].at);
    *(side < 0 ? &b : &a) = *known;
  }
  return true;
}

/* Replaces piece i by its two parts if a point was noted inside it; the
 * second part goes to the end of the list and is looked at in its turn. */
static bool
divide_piece(sg_cut_set *set, size_t i)
{
  sg_cut_piece piece = set->piece[i];
  uint32_t x = sg_cut_set_between(set, piece.a, piece.b);

  if (x == SG_NO_KEY) {
    return true;
  }
  sg_cut_piece first = piece, second = piece;

  first.b = x;
  second.a = x;
  set->piece[i].live = false;
  return add_piece(set, &first) && add_piece(set, &second);
}

bool
sg_cut_set_agree(sg_cut_set *set)
{
  for (size_t i = 0; i < set->pieces; i++) {
    if (set->piece[i].live && !divide_piece(set, i)) {
      return false;
    }
  }
  return true;
}

/* The places that carry a piece: an edge where it runs along one (that alone
 * gives its line), else both triangles. */
static int
carriers(const sg_cut_set *set, const sg_cut_piece *k, sg_place out[2])
{
  for (int i = 0; i < 2; i++) {
    if (k->edge[i] != SG_NO_KEY) {
      out[0] = set->edge[k->edge[i]].place;
      return 1;
    }
  }
  out[0] = (sg_place){SG_ON_FACE, k->triangle[0], 0};
  out[1] = (sg_place){SG_ON_FACE, k->triangle[1], 0};
  return 2;
}

static bool
is_new_place(const sg_made *made, const sg_place *place)
{
  for (int i = 0; i < made->n; i++) {
    if (made->place[i].kind == place->kind &&
        made->place[i].a == place->a && made->place[i].b == place->b) {
      return false;
    }
  }
  return true;
}

sg_made
sg_cut_set_crossing(const sg_cut_set *set, const sg_cut_piece *k,
                    const sg_cut_piece *l)
{
  sg_place place[4];
  int n = carriers(set, k, place);
  sg_made made = {0};

  n += carriers(set, l, place + n);
  /* Edges first: an edge and any face that is left say it all. */
  for (int pass = 0; pass < 2; pass++) {
    for (int i = 0; i < n && made.n < 3; i++) {
      if ((place[i].kind == SG_ON_FACE) == (pass == 1) &&
          is_new_place(&made, &place[i])) {
        made.place[made.n++] = place[i];
      }
    }
  }
  if (made.n > 0 && made.place[0].kind == SG_ON_EDGE) {
    made.n = made.n < 2 ? made.n : 2;
  }
  return made;
}

/* ---- joints ---- */

bool
sg_cut_set_link(sg_cut_set *set)
{
  size_t n = set->points.n;

  set->at = malloc((n + 1) * sizeof *set->at);
  set->degree = calloc(n + 1, sizeof *set->degree);
  set->gone = calloc(n + 1, sizeof *set->gone);
  set->linked = n;
  if (!set->at || !set->degree || !set->gone) {
    return false;
  }
  for (uint32_t i = 0; i < set->pieces; i++) {
    uint32_t end[2] = {set->piece[i].a, set->piece[i].b};

    for (int k = 0; set->piece[i].live && k < 2; k++) {
      if (set->degree[end[k]] < 2) {
        set->at[end[k]][set->degree[end[k]]] = i;
      }
      set->degree[end[k]]++;
    }
  }
  return true;
}

static bool
same_carriers(const sg_cut_piece *k, const sg_cut_piece *l)
{
  for (int i = 0; i < 2; i++) {
    if (k->s[i] != l->s[i] || k->edge[i] != l->edge[i] ||
        (k->edge[i] == SG_NO_KEY && k->p[i] != l->p[i])) {
      return false;
    }
  }
  return true;
}

/* True if the point is no vertex, and on no real edge but those that carry
 * the piece. */
static bool
is_free(const sg_cut_set *set, uint32_t point, const sg_cut_piece *piece)
{
  for (uint32_t i = set->points.point[point].seat; i != SG_NO_KEY;
       i = set->points.seat[i].next) {
    const sg_seat *seat = &set->points.seat[i];

    if (seat->place.kind == SG_AT_VERTEX) {
      return false;
    }
    if (seat->edge) {
      bool carries = false;
      for (int k = 0; k < 2; k++) {
        const sg_place *place = piece->edge[k] == SG_NO_KEY
                                    ? NULL
                                    : &set->edge[piece->edge[k]].place;
        carries = carries || (place && place->a == seat->place.a &&
                              place->b == seat->place.b);
      }
      if (!carries) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_cut_set_joint(const sg_cut_set *set, uint32_t point, uint32_t *k,
                 uint32_t *l)
{
  if (point >= set->linked || set->degree[point] != 2 || set->gone[point]) {
    return false;
  }
  *k = set->at[point][0];
  *l = set->at[point][1];
  return same_carriers(&set->piece[*k], &set->piece[*l]) &&
         is_free(set, point, &set->piece[*k]);
}

void
sg_cut_set_join(sg_cut_set *set, uint32_t point)
{
  sg_cut_piece *k = &set->piece[set->at[point][0]];
  sg_cut_piece *l = &set->piece[set->at[point][1]];
  uint32_t far = l->a == point ? l->b : l->a;

  *(k->a == point ? &k->a : &k->b) = far;
  l->live = false;
  for (int i = 0; i < 2; i++) {
    if (set->at[far][i] == set->at[point][1]) {
      set->at[far][i] = set->at[point][0];
    }
  }
  set->gone[point] = true;
  set->degree[point] = 0;
}

uint32_t
sg_cut_set_find(const sg_cut_set *set, int32_t s1, int32_t s2, uint32_t a,
                uint32_t b)
{
  uint32_t ends[2];

  pair_key(a, b, ends);
  return sg_key_table_get(&set->piece_number,
                          (uint32_t[4]){(uint32_t)s1, (uint32_t)s2, ends[0],
                                        ends[1]});
}
