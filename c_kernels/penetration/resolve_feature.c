/* resolve_feature.c -- see resolve_feature.h. The points of a segment are boxes
 * of a tree, each with what is near it, and are joined with the segment's. */
#include "resolve_feature.h"

#include "join/bvh_join.h"
#include "number/vector.h"
#include "rows/disjoint.h"

#include <stdlib.h>
#include <string.h>

/* A move is tight if it is more than 1 / TIGHT of a feature. What is looked at
 * is no farther than that, nor than a few SIDES of the triangles that touch, so
 * it is not many triangles; no more than MANY in any case. */
enum { TIGHT = 100, SIDES = 4, MANY = 96, BLOCK = 1 << 16 };

/* What a step of turning and moving rounds, beside the coordinates: it is never
 * tight. */
#define ROUNDING 0x1p-48

/* ---- how far points move ---- */

static double
distance(const double a[3], const double b[3])
{
  double d[3];

  sg_minus(a, b, d);
  return sg_length(d);
}

/* How far each point is from what becomes that point. */
static double *
find_moves(const sg_resolve *r)
{
  double *move = calloc(r->point.n + 1, sizeof *move);

  for (size_t i = 0; move && i < r->node.n; i++) {
    const sg_resolve_node *node = &r->node.item[i];
    double *to = &move[node->point];
    if (node->v != 0) {
      *to = fmax(*to, distance(node->at, r->point.item[node->point].at));
    }
  }
  for (size_t i = 0; move && i < r->touch.n; i++) {
    const sg_resolve_touch *touch = &r->touch.item[i];
    double *to = &move[r->node.item[touch->node].point];
    *to = fmax(*to, touch->apart);
  }
  return move;
}

/* How far round each point is looked. */
static double *
find_reaches(const sg_resolve *r, const double *move)
{
  double *reach = calloc(r->point.n + 1, sizeof *reach);

  for (size_t i = 0; reach && i < r->point.n; i++) {
    reach[i] = TIGHT * move[i];
  }
  for (size_t i = 0; reach && i < r->node.n; i++) {
    const sg_resolve_node *node = &r->node.item[i];
    reach[node->point] = fmin(reach[node->point], SIDES * node->side);
  }
  return reach;
}

/* ---- a point and what is near it ---- */

typedef struct triangle {
  sg_leaf leaf;
  double at[3][3];
  double apart; /* from the point */
} triangle;

typedef struct near {
  const double *point;
  double reach;
  double within; /* what is nearer is made to touch */
  bool itself;   /* in the segment, too */
  size_t n;
  triangle item[MANY];
  uint32_t sheet[MANY]; /* disjoint sets */
} near;

static double
to_edge(const double a[3], const double b[3], const double p[3])
{
  double along[3], from[3], at[3];

  sg_minus(b, a, along);
  sg_minus(p, a, from);
  double square = sg_dot(along, along);
  double t = square > 0 ? fmin(fmax(sg_dot(along, from) / square, 0), 1) : 0;

  for (int k = 0; k < 3; k++) {
    at[k] = a[k] + t * along[k];
  }
  return distance(p, at);
}

static double
to_triangle(double (*at)[3], const double p[3])
{
  double u[3], w[3], normal[3], from[3];
  double apart = fmin(to_edge(at[0], at[1], p),
                      fmin(to_edge(at[1], at[2], p), to_edge(at[2], at[0], p)));

  sg_minus(at[1], at[0], u);
  sg_minus(at[2], at[0], w);
  sg_cross(u, w, normal);
  double area = sg_length(normal);

  for (int i = 0; i < 3; i++) {
    double inward[3];
    sg_minus(at[(i + 1) % 3], at[i], u);
    sg_minus(p, at[i], from);
    sg_cross(normal, u, inward);
    if (!(sg_dot(inward, from) > 0)) {
      return apart;
    }
  }
  return area > 0 ? fmin(apart, fabs(sg_dot(normal, from)) / area) : apart;
}

/* Adds the leaf in this row if it is near. */
static void
add(near *all, const sg_leaf_tree *tree, const sg_leaf_views *views,
    uint32_t row)
{
  triangle *t = &all->item[all->n];

  t->leaf = sg_leaf_at(tree, views, row);
  for (int k = 0; k < 3; k++) {
    if (!sg_leaf_vertex_at(tree, views, t->leaf.v[k], t->at[k])) {
      return;
    }
  }
  t->apart = to_triangle(t->at, all->point);
  all->n += t->apart <= all->reach;
}

/* Two triangles of one sheet have a corner, or the polygon, in common. */
static bool
is_next_to(const sg_leaf *a, const sg_leaf *b)
{
  for (int i = 0; i < 9; i++) {
    if (a->v[i / 3] == b->v[i % 3]) {
      return true;
    }
  }
  return a->p == b->p;
}

/* Whether side i of triangle t is inside its polygon: another triangle of that
 * has both its ends. */
static bool
is_chord(const near *all, size_t t, int i)
{
  const sg_leaf *of = &all->item[t].leaf;
  int32_t a = of->v[i], b = of->v[(i + 1) % 3];

  for (size_t k = 0; k < all->n; k++) {
    const sg_leaf *other = &all->item[k].leaf;
    bool has[2] = {false, false};
    for (int j = 0; j < 3; j++) {
      has[0] = has[0] || other->v[j] == a;
      has[1] = has[1] || other->v[j] == b;
    }
    if (k != t && other->p == of->p && has[0] && has[1]) {
      return true;
    }
  }
  return false;
}

static double
shortest_edge(const near *all, double feature)
{
  for (size_t t = 0; t < all->n; t++) {
    double(*at)[3] = (double(*)[3])all->item[t].at;
    for (int i = 0; i < 3; i++) {
      double length = distance(at[i], at[(i + 1) % 3]);
      if (length < feature && length > 0 &&
          to_edge(at[i], at[(i + 1) % 3], all->point) <= all->reach &&
          !is_chord(all, t, i)) {
        feature = length;
      }
    }
  }
  return feature;
}

/* The distance to the nearest sheet but the one that is nearest. Of a segment
 * that is made to touch in itself, what is made to touch is none. */
static double
nearest_sheet(near *all, double feature)
{
  size_t home = 0;

  for (uint32_t i = 0; i < all->n; i++) {
    all->sheet[i] = i;
    home = all->item[i].apart < all->item[home].apart ? i : home;
    for (uint32_t k = 0; k < i; k++) {
      if (is_next_to(&all->item[i].leaf, &all->item[k].leaf)) {
        sg_disjoint_join(all->sheet, i, k);
      }
    }
  }
  for (uint32_t i = 0; i < all->n; i++) {
    if (sg_disjoint_root(all->sheet, i) !=
            sg_disjoint_root(all->sheet, (uint32_t)home) &&
        !(all->itself && all->item[i].apart <= all->within)) {
      feature = fmin(feature, all->item[i].apart);
    }
  }
  return feature;
}

/* ---- all points of a segment ---- */

typedef struct measuring {
  const sg_resolve *r;
  const sg_leaf_views *views;
  const double *move, *reach; /* [points] */
  sg_crew *crew;
  const sg_poll *poll;
  unsigned char *counted; /* [points] it is tight somewhere */
  sg_resolve_moves *out;
} measuring;

static int
by_point(const void *a, const void *b)
{
  const sg_bvh_hit *x = a, *y = b;

  return x->a != y->a ? (x->a < y->a ? -1 : 1) : (x->b > y->b) - (x->b < y->b);
}

static void
note_feature(const measuring *m, uint32_t point, int32_t s, double feature)
{
  sg_resolve_moves *out = m->out;
  double move = m->move[point], largest = 0;

  for (int k = 0; k < 3; k++) {
    largest = fmax(largest, fabs(m->r->point.item[point].at[k]));
  }
  if (!(move * TIGHT > feature) || move <= largest * ROUNDING) {
    return;
  }
  out->tight += !m->counted[point];
  m->counted[point] = 1;
  if (out->feature == 0 || move * out->feature > out->move * feature) {
    out->tight_point = point;
    out->tight_segment = s;
    out->move = move;
    out->feature = feature;
  }
}

/* Goes over the hits, which are sorted by points. */
static bool
each_point(const measuring *m, const sg_leaf_tree *tree, bool itself,
           const sg_bvh *points, const uint32_t *name, const sg_bvh_hits *hits)
{
  near *all = malloc(sizeof *all);

  for (size_t i = 0; all && i < hits->n;) {
    uint32_t at = hits->hit[i].a, point = name[points->item[at]];

    *all = (near){.point = m->r->point.item[point].at,
                  .within = m->r->reach,
                  .reach = m->reach[point],
                  .itself = itself};
    for (; i < hits->n && hits->hit[i].a == at; i++) {
      if (all->n < MANY) {
        add(all, tree, m->views, tree->boxes->item[hits->hit[i].b]);
      }
    }
    double feature = nearest_sheet(all, shortest_edge(all, INFINITY));
    if (feature < INFINITY) {
      note_feature(m, point, tree->s, fmax(feature, 1e-300));
    }
  }
  free(all);
  return all != NULL;
}

/* Some points, `name`, of a segment. */
static bool
measure_some(const measuring *m, const sg_leaf_tree *tree, bool itself,
             const uint32_t *name, size_t n)
{
  sg_box *box = malloc((n + 1) * sizeof *box);
  sg_bvh *points = NULL;
  sg_bvh_hits hits = {0};

  for (size_t i = 0; box && i < n; i++) {
    const double *at = m->r->point.item[name[i]].at;
    for (int k = 0; k < 3; k++) {
      box[i].lo[k] = at[k] - m->reach[name[i]];
      box[i].hi[k] = at[k] + m->reach[name[i]];
    }
  }
  points = box ? sg_bvh_open(box, n, m->poll) : NULL;
  sg_bvh_pair pair = {points, tree->boxes};
  bool done = points && sg_bvh_join(&pair, 1, 0, m->crew, m->poll, &hits);

  if (done && hits.n > 0) {
    qsort(hits.hit, hits.n, sizeof *hits.hit, by_point);
    done = each_point(m, tree, itself, points, name, &hits);
  }
  free(hits.hit);
  sg_bvh_close(points);
  free(box);
  return done;
}

typedef struct at {
  int32_t s;
  uint32_t point;
} at;

static int
by_segment(const void *a, const void *b)
{
  const at *x = a, *y = b;

  return x->s != y->s ? (x->s < y->s ? -1 : 1)
                      : (x->point > y->point) - (x->point < y->point);
}

/* The places of points that move, by segments. Null: no memory. */
static at *
find_places(const sg_resolve *r, const double *move, size_t *n)
{
  at *found = malloc((r->place.n + 1) * sizeof *found);

  *n = 0;
  for (size_t i = 0; found && i < r->place.n; i++) {
    const sg_resolve_place *place = &r->place.item[i];
    if (move[place->point] > 0) {
      found[(*n)++] = (at){place->s, place->point};
    }
  }
  if (found && *n > 0) {
    qsort(found, *n, sizeof *found, by_segment);
  }
  return found;
}

static bool
measure_segments(const measuring *m, sg_resolve_tree_of *tree_of,
                 const void *data)
{
  size_t n;
  at *place = find_places(m->r, m->move, &n);
  uint32_t *name = malloc(BLOCK * sizeof *name);
  bool done = place && name;

  for (size_t i = 0, k = 0; done && i < n; i += k) {
    bool itself;
    const sg_leaf_tree *tree = tree_of(data, place[i].s, &itself);
    for (k = 0; k < BLOCK && i + k < n && place[i + k].s == place[i].s; k++) {
      name[k] = place[i + k].point;
    }
    done = !tree || tree->curve || !tree->boxes ||
           measure_some(m, tree, itself, name, k);
    done = done && !sg_poll_stop(m->poll);
  }
  free(place);
  free(name);
  return done;
}

bool
sg_resolve_measure(const sg_resolve *r, sg_resolve_tree_of *tree_of,
                   const void *data, const sg_leaf_views *views, sg_crew *crew,
                   const sg_poll *poll, sg_resolve_moves *out)
{
  double *move = find_moves(r), *reach = move ? find_reaches(r, move) : NULL;
  unsigned char *counted = calloc(r->point.n + 1, 1);
  measuring m = {r, views, move, reach, crew, poll, counted, out};
  bool done = reach && counted;

  *out = (sg_resolve_moves){0};
  for (uint32_t i = 0; done && i < r->point.n; i++) {
    if (move[i] > out->farthest) {
      out->farthest = move[i];
      out->point = i;
    }
  }
  done = done && measure_segments(&m, tree_of, data);
  free(move);
  free(reach);
  free(counted);
  return done;
}
