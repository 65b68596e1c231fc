/* cut_piece.c -- the pieces of a cut set after it is sealed: the polygons they
 * enter, late splits, crossings, joints. See cut_set.h.
 */
#include "cut_private.h"

#include "engine/search.h"
#include "rows/sort.h"

#include <stdlib.h>

/* ---- polygons ---- */

bool
sg_cut_set_add_polygon(sg_cut_set *set, int32_t s, int32_t p)
{
  if (!sg_list_grow(&set->polygon, set->polygons, &set->polygon_room,
                    sizeof *set->polygon)) {
    return false;
  }
  set->polygon[set->polygons++] = (sg_cut_polygon){s, p, 0, 0};
  return true;
}

SG_ORDER(compare_polygons, sg_cut_polygon, SG_BY(s) SG_BY(p));

sg_cut_polygon *
sg_cut_set_polygon(const sg_cut_set *set, int32_t s, int32_t p)
{
  sg_cut_polygon key = {s, p, 0, 0};

  return set->polygons == 0 ? NULL
                            : bsearch(&key, set->polygon, set->polygons,
                                      sizeof key, compare_polygons);
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
 * there is room) files it. False: stopped. */
static bool
file_pieces(sg_cut_set *set, const sg_cancel *cancel)
{
  for (uint32_t i = 0; i < set->pieces; i++) {
    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    for (int k = 0; k < 2; k++) {
      if (set->piece[i].edge[k] == SG_NO_KEY) {
        sg_cut_polygon *polygon =
            sg_cut_set_polygon(set, set->piece[i].s[k], set->piece[i].p[k]);

        if (set->entering) {
          set->entering[polygon->first + polygon->n] = i;
        }
        polygon->n++;
      }
    }
  }
  return true;
}

bool
sg_cut_set_group(sg_cut_set *set, const sg_cancel *cancel)
{
  size_t total = 0;

  free(set->entering);
  set->entering = NULL;
  for (size_t i = 0; i < set->pieces; i++) {
    if (sg_cancel_every(cancel, i)) {
      return false;
    }
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
  if (sg_sort(set->polygon, set->polygons, sizeof *set->polygon,
              compare_polygons, cancel) != SG_SORTED) {
    return false;
  }
  drop_repeated(set);
  if (!file_pieces(set, cancel)) { /* counts */
    return false;
  }
  for (size_t i = 0; i < set->polygons; i++) {
    set->polygon[i].first = total;
    total += set->polygon[i].n;
    set->polygon[i].n = 0;
  }
  set->entering = malloc((total + 1) * sizeof *set->entering);
  return set->entering && file_pieces(set, cancel);
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
  for (int k = 0; k < 2; k++) {
    if (piece.edge[k] != SG_NO_KEY && !sg_cut_put_late(set, piece.edge[k], x)) {
      return false;
    }
  }
  return sg_cut_add_piece(set, &first) && sg_cut_add_piece(set, &second);
}

bool
sg_cut_set_agree(sg_cut_set *set, const sg_cancel *cancel)
{
  for (size_t i = 0; i < set->pieces; i++) {
    if (sg_cancel_every(cancel, i)) {
      return false;
    }
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
are_coplanar(const sg_cut_set *set, uint32_t t, uint32_t u)
{
  double a[3][3], b[3][3];

  if (t == u) {
    return true;
  }
  sg_cut_model_corners(&set->model, t, a);
  sg_cut_model_corners(&set->model, u, b);
  for (int i = 0; i < 3; i++) {
    if (sg_orient3d(a[0], a[1], a[2], b[i]) != 0) {
      return false;
    }
  }
  return true;
}

/* Whether an edge lies in the plane of a triangle. */
static bool
lies_in(const sg_cut_set *set, const sg_place *edge, const sg_place *face)
{
  double t[3][3];

  sg_cut_model_corners(&set->model, face->a, t);
  return sg_orient3d(t[0], t[1], t[2], set->model.vertex[edge->a].at) == 0 &&
         sg_orient3d(t[0], t[1], t[2], set->model.vertex[edge->b].at) == 0;
}

/* Whether `place` leaves fewer points of what the known place has: it is not
 * the same edge or plane, nor a plane through that edge. */
static bool
says_more(const sg_cut_set *set, const sg_place *known, const sg_place *place)
{
  if (place->kind == SG_ON_EDGE) {
    return known->a != place->a || known->b != place->b;
  }
  return known->kind == SG_ON_EDGE ? !lies_in(set, known, place)
                                   : !are_coplanar(set, known->a, place->a);
}

static bool
is_new_place(const sg_cut_set *set, const sg_made *made, const sg_place *place)
{
  for (int i = 0; i < made->n; i++) {
    if (!says_more(set, &made->place[i], place)) {
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
  /* Edges first: an edge and one more place say it all. A merged piece goes
   * through several triangles of a plane; any of them will do. */
  for (int pass = 0; pass < 2; pass++) {
    for (int i = 0; i < n && made.n < 3; i++) {
      if ((place[i].kind == SG_ON_FACE) == (pass == 1) &&
          is_new_place(set, &made, &place[i])) {
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
sg_cut_set_link(sg_cut_set *set, const sg_cancel *cancel)
{
  size_t n = set->points.n;

  free(set->at);
  free(set->degree);
  free(set->gone);
  set->at = malloc((n + 1) * sizeof *set->at);
  set->degree = calloc(n + 1, sizeof *set->degree);
  set->gone = calloc(n + 1, sizeof *set->gone);
  set->linked = n;
  if (!set->at || !set->degree || !set->gone) {
    return false;
  }
  for (uint32_t i = 0; i < set->pieces; i++) {
    uint32_t end[2] = {set->piece[i].a, set->piece[i].b};

    if (sg_cancel_every(cancel, i)) {
      return false;
    }
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

bool
sg_cut_set_is_straight(const sg_cut_set *set, uint32_t k, uint32_t l)
{
  const sg_cut_piece *p = &set->piece[k], *q = &set->piece[l];

  if (p->edge[0] != SG_NO_KEY || p->edge[1] != SG_NO_KEY) {
    return true;
  }
  return are_coplanar(set, p->triangle[0], q->triangle[0]) &&
         are_coplanar(set, p->triangle[1], q->triangle[1]);
}

void
sg_cut_set_join(sg_cut_set *set, uint32_t point)
{
  sg_cut_piece *k = &set->piece[set->at[point][0]];
  sg_cut_piece *l = &set->piece[set->at[point][1]];
  uint32_t far = l->a == point ? l->b : l->a;

  *(k->a == point ? &k->a : &k->b) = far;
  l->live = false;
  for (uint32_t i = 0; i < 2 && i < set->degree[far]; i++) {
    if (set->at[far][i] == set->at[point][1]) {
      set->at[far][i] = set->at[point][0];
    }
  }
  set->gone[point] = true;
  set->degree[point] = 0;
}

static void
forget_gone(const sg_cut_set *set, sg_split_edge *edge)
{
  size_t kept = 0;

  for (size_t i = 0; i < edge->n; i++) {
    if (edge->point[i] >= set->linked || !set->gone[edge->point[i]]) {
      edge->point[kept++] = edge->point[i];
    }
  }
  edge->n = kept;
}

bool
sg_cut_set_settle(sg_cut_set *set, const sg_cancel *cancel)
{
  size_t pieces = set->pieces;

  for (size_t i = 0; i < set->edges; i++) {
    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    forget_gone(set, &set->edge[i]);
  }
  sg_key_table_clear(&set->piece_number);
  set->pieces = 0;
  for (size_t i = 0; i < pieces; i++) {
    sg_cut_piece piece = set->piece[i]; /* its place may be written again */

    if (sg_cancel_every(cancel, i) ||
        (piece.live && !sg_cut_add_piece(set, &piece))) {
      return false;
    }
  }
  return sg_cut_set_link(set, cancel);
}
