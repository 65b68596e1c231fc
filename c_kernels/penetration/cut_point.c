#include "cut_point.h"

#include "engine/list.h"
#include "join/cut.h"

#include <stdlib.h>
#include <string.h>

enum { FEW = 8 }; /* seats of a point that are looked through */

void
sg_cut_points_init(sg_cut_points *points, const sg_cut_model *model)
{
  memset(points, 0, sizeof *points);
  points->model = model;
  sg_key_table_init(&points->of_made, 6);
  sg_key_table_init(&points->of_place, 6);
  sg_key_table_init(&points->of_name, 2);
  sg_key_table_init(&points->of_seat, 4);
  sg_key_table_init(&points->least, 2);
  sg_key_table_init(&points->by_itself, 1);
}

void
sg_cut_points_clear(sg_cut_points *points)
{
  for (size_t i = 0; i < points->n; i++) {
    sg_point_clear(&points->point[i].at);
  }
  free(points->point);
  free(points->seat);
  free(points->of_vertex);
  sg_key_table_clear(&points->of_made);
  sg_key_table_clear(&points->of_place);
  sg_key_table_clear(&points->of_name);
  sg_key_table_clear(&points->of_seat);
  sg_key_table_clear(&points->least);
  sg_key_table_clear(&points->by_itself);
  sg_cut_points_init(points, points->model);
}

bool
sg_cut_points_set_by_itself(sg_cut_points *points, int32_t s)
{
  uint32_t key = (uint32_t)s;
  uint32_t *known = sg_key_table_put(&points->by_itself, &key);

  if (known) {
    *known = 1;
  }
  return known != NULL;
}

bool
sg_cut_points_is_by_itself(const sg_cut_points *points, int32_t s)
{
  uint32_t key = (uint32_t)s;

  return points->by_itself.n > 0 &&
         sg_key_table_get(&points->by_itself, &key) != SG_NO_KEY;
}

int32_t
sg_place_segment(const sg_cut_model *model, const sg_place *place)
{
  return place->kind == SG_ON_FACE ? model->triangle[place->a].s
                                   : model->vertex[place->a].s;
}

sg_place
sg_place_of(const sg_cut_model *model, uint32_t triangle, int f)
{
  const uint32_t *v = model->triangle[triangle].v;

  if (f <= SG_CORNER_2) {
    return (sg_place){SG_AT_VERTEX, v[f], 0};
  }
  if (f == SG_FACE) {
    return (sg_place){SG_ON_FACE, triangle, 0};
  }
  uint32_t a = v[f - SG_EDGE_0], b = v[(f - SG_EDGE_0 + 1) % 3];

  return (sg_place){SG_ON_EDGE, a < b ? a : b, a < b ? b : a};
}

static bool
same_place(const sg_place *p, const sg_place *q)
{
  return p->kind == q->kind && p->a == q->a && p->b == q->b;
}

/* ---- seats and names ---- */

static bool
make_seat_room(sg_cut_points *points)
{
  return sg_list_grow(&points->seat, points->seats, &points->seat_room,
                      sizeof *points->seat);
}

static void
seat_key(uint32_t point, const sg_place *place, uint32_t key[4])
{
  key[0] = point;
  key[1] = (uint32_t)place->kind;
  key[2] = place->a;
  key[3] = place->b;
}

static bool
list_seat(sg_cut_points *points, uint32_t point, uint32_t i)
{
  const sg_seat *seat = &points->seat[i];
  uint32_t key[4], *number, *least;

  seat_key(point, &seat->place, key);
  number = sg_key_table_put(&points->of_seat, key);
  if (!number) {
    return false;
  }
  *number = i;
  if (seat->v == 0) {
    return true;
  }
  least =
      sg_key_table_put(&points->least, (uint32_t[2]){point, (uint32_t)seat->s});
  if (!least) {
    return false;
  }
  *least = *least < (uint32_t)seat->v ? *least : (uint32_t)seat->v;
  return true;
}

/* Puts the seats of a point in the tables: all that it has, when there are too
 * many to look through, and then each new one, which is the first. */
static bool
list_seats(sg_cut_points *points, uint32_t point)
{
  const sg_cut_point *of = &points->point[point];
  uint32_t n = of->seats < FEW ? 0 : of->seats == FEW ? FEW : 1, i = of->seat;

  for (; n > 0; n--) {
    if (!list_seat(points, point, i)) {
      return false;
    }
    i = points->seat[i].next;
  }
  return true;
}

/* A vertex is in one place, and so is a point: it is the only one there. */
static bool
note_vertex(sg_cut_points *points, uint32_t vertex, uint32_t point)
{
  if (!sg_list_need_zeroed(&points->of_vertex, vertex + (size_t)1,
                           &points->vertex_room, sizeof *points->of_vertex)) {
    return false;
  }
  points->of_vertex[vertex] = point + 1;
  return true;
}

/* The point of two vertices, if both are known to be in it; SG_NO_KEY. */
static uint32_t
point_of_vertices(const sg_cut_points *points, const sg_made *made)
{
  uint32_t point[2];

  for (int i = 0; i < 2; i++) {
    const sg_place *place = &made->place[i];
    if (made->n != 2 || place->kind != SG_AT_VERTEX ||
        place->a >= points->vertex_room) {
      return SG_NO_KEY;
    }
    point[i] = points->of_vertex[place->a];
  }
  return point[0] != 0 && point[0] == point[1] ? point[0] - 1 : SG_NO_KEY;
}

static bool
take_seat(sg_cut_points *points, uint32_t point, int32_t s, sg_place place,
          int32_t v)
{
  if (!make_seat_room(points)) {
    return false;
  }
  points->seat[points->seats] =
      (sg_seat){s, v, false, place, points->point[point].seat};
  points->point[point].seat = (uint32_t)points->seats++;
  points->point[point].seats++;
  if (place.kind == SG_AT_VERTEX && !note_vertex(points, place.a, point)) {
    return false;
  }
  if (v != 0) {
    uint32_t key[2] = {(uint32_t)s, (uint32_t)v};
    uint32_t *number = sg_key_table_put(&points->of_name, key);

    if (!number) {
      return false;
    }
    *number = point;
  }
  return list_seats(points, point);
}

/* The point's seat for exactly this place; null: it has none. */
static sg_seat *
seat_at(const sg_cut_points *points, uint32_t point, const sg_place *place)
{
  uint32_t key[4], number;

  if (points->point[point].seats >= FEW) {
    seat_key(point, place, key);
    number = sg_key_table_get(&points->of_seat, key);
    return number == SG_NO_KEY ? NULL : &points->seat[number];
  }
  for (uint32_t i = points->point[point].seat; i != SG_NO_KEY;
       i = points->seat[i].next) {
    if (same_place(&points->seat[i].place, place)) {
      return &points->seat[i];
    }
  }
  return NULL;
}

static bool
seat_all(sg_cut_points *points, uint32_t point, const sg_made *made)
{
  for (int i = 0; i < made->n; i++) {
    const sg_place *place = &made->place[i];
    int32_t s = sg_place_segment(points->model, place);
    int32_t v =
        place->kind == SG_AT_VERTEX ? points->model->vertex[place->a].v : 0;

    if (!seat_at(points, point, place) &&
        !take_seat(points, point, s, *place, v)) {
      return false;
    }
  }
  return true;
}

int32_t
sg_cut_points_name(const sg_cut_points *points, uint32_t point, int32_t s)
{
  int32_t least = 0;

  if (points->point[point].seats >= FEW) {
    uint32_t known =
        sg_key_table_get(&points->least, (uint32_t[2]){point, (uint32_t)s});

    return known == SG_NO_KEY ? 0 : (int32_t)known;
  }
  for (uint32_t i = points->point[point].seat; i != SG_NO_KEY;
       i = points->seat[i].next) {
    const sg_seat *seat = &points->seat[i];

    if (seat->s == s && seat->v > 0 && (least == 0 || seat->v < least)) {
      least = seat->v;
    }
  }
  return least;
}

int32_t
sg_cut_points_good_name(const sg_cut_points *points, uint32_t point, int32_t s,
                        sg_is_good_name *is_good, const void *data)
{
  int32_t first = sg_cut_points_name(points, point, s), good = 0;

  if (first == 0 || is_good(data, first)) {
    return first;
  }
  for (uint32_t i = points->point[point].seat; i != SG_NO_KEY;
       i = points->seat[i].next) {
    const sg_seat *seat = &points->seat[i];

    if (seat->s == s && seat->v > first && (good == 0 || seat->v < good) &&
        is_good(data, seat->v)) {
      good = seat->v;
    }
  }
  return good != 0 ? good : first;
}

bool
sg_cut_points_set_name(sg_cut_points *points, uint32_t point, int32_t s,
                       int32_t v)
{
  return take_seat(points, point, s, (sg_place){SG_ON_FACE, SG_NO_KEY, 0}, v);
}

uint32_t
sg_cut_points_named(const sg_cut_points *points, int32_t s, int32_t v)
{
  uint32_t key[2] = {(uint32_t)s, (uint32_t)v};

  return sg_key_table_get(&points->of_name, key);
}

void
sg_cut_points_on_edge(sg_cut_points *points, uint32_t point,
                      const sg_place *place)
{
  sg_seat *seat = seat_at(points, point, place);

  if (seat) {
    seat->edge = true;
  }
}

/* ---- where a point is ---- */

typedef struct plane {
  sg_point p[3];
} plane;

static const double *
position(const sg_cut_model *model, uint32_t vertex)
{
  return model->vertex[vertex].at;
}

static plane
plane_of(const sg_cut_model *model, uint32_t triangle)
{
  plane out;

  for (int i = 0; i < 3; i++) {
    sg_point_set(&out.p[i], position(model, model->triangle[triangle].v[i]));
  }
  return out;
}

static bool
edge_meets_face(const sg_cut_model *model, const sg_place *edge,
                const sg_place *face, sg_point *out)
{
  plane f = plane_of(model, face->a);
  sg_point a, b;

  sg_point_set(&a, position(model, edge->a));
  sg_point_set(&b, position(model, edge->b));
  return sg_point_lpi(out, &a, &b, &f.p[0], &f.p[1], &f.p[2]);
}

static bool
edge_meets_edge(const sg_cut_model *model, const sg_place *e, const sg_place *f,
                sg_point *out)
{
  sg_point a, b, c, d;

  sg_point_set(&a, position(model, e->a));
  sg_point_set(&b, position(model, e->b));
  sg_point_set(&c, position(model, f->a));
  sg_point_set(&d, position(model, f->b));
  for (int axis = 2; axis >= 0; axis--) {
    if (sg_point_ll(out, axis, &a, &b, &c, &d)) {
      return true;
    }
  }
  return false;
}

static bool
faces_meet(const sg_cut_model *model, const sg_made *made, sg_point *out)
{
  plane f[3];
  const sg_point *const p[3][3] = {
      {&f[0].p[0], &f[0].p[1], &f[0].p[2]},
      {&f[1].p[0], &f[1].p[1], &f[1].p[2]},
      {&f[2].p[0], &f[2].p[1], &f[2].p[2]},
  };

  for (int i = 0; i < 3; i++) {
    f[i] = plane_of(model, made->place[i].a);
  }
  return sg_point_tpi(out, p);
}

/* Makes the exact point; false: there is no single one (or no memory). */
static bool
construct(const sg_cut_model *model, const sg_made *made, sg_point *out)
{
  const sg_place *p = &made->place[0], *q = &made->place[1];

  for (int i = 0; i < made->n; i++) {
    if (made->place[i].kind == SG_AT_VERTEX) {
      sg_point_set(out, position(model, made->place[i].a));
      return true;
    }
  }
  if (made->n == 3) {
    return faces_meet(model, made, out);
  }
  if (p->kind == SG_ON_EDGE && q->kind == SG_ON_EDGE) {
    return edge_meets_edge(model, p, q, out);
  }
  if (p->kind == SG_ON_EDGE && q->kind == SG_ON_FACE) {
    return edge_meets_face(model, p, q, out);
  }
  return p->kind == SG_ON_FACE && q->kind == SG_ON_EDGE &&
         edge_meets_face(model, q, p, out);
}

/* ---- one point, however made ---- */

static uint32_t
new_point(sg_cut_points *points, const sg_point *at, const sg_made *made,
          uint32_t *bucket)
{
  if (!sg_list_grow(&points->point, points->n, &points->room,
                    sizeof *points->point)) {
    return SG_NO_KEY;
  }
  uint32_t number = (uint32_t)points->n;
  sg_cut_point *point = &points->point[number];

  sg_point_copy(&point->at, at);
  point->made = *made;
  point->seat = SG_NO_KEY;
  point->seats = 0;
  point->same_place = *bucket;
  *bucket = number;
  points->n++;
  return number;
}

uint32_t
sg_cut_points_at(sg_cut_points *points, const sg_point *at, const sg_made *made)
{
  uint32_t key[6];
  double p[3] = {at->p[0] + 0.0, at->p[1] + 0.0, at->p[2] + 0.0};

  memcpy(key, p, sizeof key);
  uint32_t *bucket = sg_key_table_put(&points->of_place, key);

  if (!bucket) {
    return SG_NO_KEY;
  }
  for (uint32_t i = *bucket; i != SG_NO_KEY; i = points->point[i].same_place) {
    if (sg_point_equal(&points->point[i].at, at)) {
      return seat_all(points, i, made) ? i : SG_NO_KEY;
    }
  }
  uint32_t number = new_point(points, at, made, bucket);

  return number != SG_NO_KEY && seat_all(points, number, made) ? number
                                                               : SG_NO_KEY;
}

uint32_t
sg_cut_points_find(sg_cut_points *points, const sg_made *made)
{
  uint32_t key[6] = {0, SG_NO_KEY, SG_NO_KEY, SG_NO_KEY, SG_NO_KEY, SG_NO_KEY};
  uint32_t there = point_of_vertices(points, made);
  sg_point at;

  if (there != SG_NO_KEY) {
    return there;
  }
  if (made->n <= 2) {
    for (int i = 0; i < made->n; i++) {
      key[0] = 4 * key[0] + 1 + (uint32_t)made->place[i].kind;
      key[2 * i + 1] = made->place[i].a;
      key[2 * i + 2] = made->place[i].b;
    }
    uint32_t known = sg_key_table_get(&points->of_made, key);

    if (known != SG_NO_KEY) {
      return known;
    }
  }
  if (!construct(points->model, made, &at)) {
    return SG_NO_KEY;
  }
  uint32_t number = sg_cut_points_at(points, &at, made);

  sg_point_clear(&at);
  if (number != SG_NO_KEY && made->n <= 2) {
    uint32_t *known = sg_key_table_put(&points->of_made, key);

    if (!known) {
      return SG_NO_KEY;
    }
    *known = number;
  }
  return number;
}
