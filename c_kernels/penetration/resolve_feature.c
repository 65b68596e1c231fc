/* resolve_feature.c -- see resolve_feature.h. The points that move are boxes of
 * a tree, each with what is near it, and are joined with the segments that they
 * are near, and in each with its triangles. */
#include "resolve_feature.h"

#include "engine/search.h"
#include "join/bvh_join.h"
#include "number/vector.h"
#include "rows/disjoint.h"

#include <stdlib.h>
#include <string.h>

/* A move is tight if it is more than 1 / TIGHT of a feature. What is looked at
 * is no farther than that, nor than a few SIDES of the triangles that touch, so
 * it is not many triangles; no more than MANY in any case. */
enum { TIGHT = 100, SIDES = 4, MANY = 96, BLOCK = 1 << 16 };

/* ---- how far points move ---- */

/* How far each point is from what becomes that point. */
static double *
find_moves(const sg_resolve *r)
{
  double *move = calloc(r->point.n + 1, sizeof *move);

  for (size_t i = 0; move && i < r->node.n; i++) {
    const sg_resolve_node *node = &r->node.item[i];
    double *to = &move[node->point];
    if (node->v != 0) {
      *to = fmax(*to, sg_distance(node->at, r->point.item[node->point].at));
    }
  }
  for (size_t i = 0; move && i < r->touch.n; i++) {
    const sg_resolve_touch *touch = &r->touch.item[i];
    double *to = &move[r->node.item[touch->node].point];
    *to = fmax(*to, touch->apart);
  }
  return move;
}

/* How far doubles are rounded at each point: so far a move is none. */
static double *
find_rounding(const sg_resolve *r)
{
  double *rounding = calloc(r->point.n + 1, sizeof *rounding);

  for (size_t i = 0; rounding && i < r->node.n; i++) {
    const sg_resolve_node *node = &r->node.item[i];
    rounding[node->point] = fmax(rounding[node->point], node->rounding);
  }
  return rounding;
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
to_triangle(double (*at)[3], const double p[3])
{
  double u[3], w[3], normal[3], from[3];
  double apart = fmin(
      sg_to_segment(at[0], at[1], p),
      fmin(sg_to_segment(at[1], at[2], p), sg_to_segment(at[2], at[0], p)));

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
      double length = sg_distance(at[i], at[(i + 1) % 3]);
      if (length < feature && length > 0 &&
          sg_to_segment(at[i], at[(i + 1) % 3], all->point) <= all->reach &&
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

/* The distance to a segment that has nothing there. */
static double
nearest(const near *all)
{
  double feature = INFINITY;

  for (size_t i = 0; i < all->n; i++) {
    feature = fmin(feature, all->item[i].apart);
  }
  return feature;
}

/* ---- all points of a segment ---- */

/* A point that moves, and a segment that it is of, or near. */
typedef struct at {
  int32_t s;
  uint32_t point;
  bool of;
} at;

typedef struct measuring {
  const sg_resolve *r;
  const sg_resolve_trees *trees;
  const sg_leaf_views *views;
  const double *move, *rounding, *reach; /* [points] */
  sg_pool *pool;
  const sg_cancel *cancel;
  unsigned char *counted; /* [points] it is tight somewhere */
  sg_resolve_moves *out;
} measuring;

SG_ORDER(by_point, sg_bvh_hit, SG_BY(a) SG_BY(b));

static bool
is_moved(const measuring *m, uint32_t point)
{
  return m->move[point] > m->rounding[point];
}

static void
note_feature(const measuring *m, uint32_t point, int32_t s, double move,
             double feature)
{
  sg_resolve_moves *out = m->out;

  if (!(move * TIGHT > feature)) {
    return;
  }
  out->tight += !m->counted[point];
  m->counted[point] = 1;
  double more = move * out->feature - out->move * feature;
  if (out->feature == 0 || more > 0 || (more == 0 && move > out->move)) {
    out->tight_point = point;
    out->tight_segment = s;
    out->move = move;
    out->feature = feature;
  }
}

/* Goes over the hits, which are sorted by points. */
static bool
each_point(const measuring *m, const sg_leaf_tree *tree, bool itself,
           const sg_bvh *points, const at *place, const sg_bvh_hits *hits)
{
  near *all = malloc(sizeof *all);

  for (size_t i = 0; all && i < hits->n;) {
    uint32_t a = hits->hit[i].a, point = place[points->item[a]].point;
    bool of = place[points->item[a]].of;

    all->point = m->r->point.item[point].at;
    all->within = m->r->reach;
    all->reach = m->reach[point];
    all->itself = itself;
    all->n = 0; /* its items are written before they are read */
    for (; i < hits->n && hits->hit[i].a == a; i++) {
      if (all->n < MANY) {
        add(all, tree, m->views, tree->boxes->item[hits->hit[i].b]);
      }
    }
    double feature =
        of ? nearest_sheet(all, shortest_edge(all, INFINITY)) : nearest(all);
    if (feature < INFINITY) {
      note_feature(m, point, tree->s, m->move[point], fmax(feature, 1e-300));
    }
  }
  free(all);
  return all != NULL;
}

/* The boxes of n points, each with what is near it. Null: no memory, or the
 * cancel said stop. */
static sg_bvh *
open_points(const measuring *m, const at *place, size_t n)
{
  sg_box *box = malloc((n + 1) * sizeof *box);

  for (size_t i = 0; box && i < n; i++) {
    const double *p = m->r->point.item[place[i].point].at;
    for (int k = 0; k < 3; k++) {
      box[i].lo[k] = p[k] - m->reach[place[i].point];
      box[i].hi[k] = p[k] + m->reach[place[i].point];
    }
  }
  sg_bvh *points = box ? sg_bvh_open(box, n, m->cancel) : NULL;
  free(box);
  return points;
}

/* Some points of a segment, or near it. */
static bool
measure_some(const measuring *m, const sg_leaf_tree *tree, bool itself,
             const at *place, size_t n)
{
  sg_bvh_hits hits = {0};
  sg_bvh *points = open_points(m, place, n);
  sg_bvh_pair pair = {points, tree->boxes};
  bool done = points && sg_bvh_join(&pair, 1, 0, m->pool, m->cancel, &hits);

  if (done && hits.n > 0) {
    qsort(hits.hit, hits.n, sizeof *hits.hit, by_point);
    done = each_point(m, tree, itself, points, place, &hits);
  }
  free(hits.hit);
  sg_bvh_close(points);
  return done;
}

/* ---- which points, and of what ---- */

/* By segments and points, one that is of the segment first. */
static int
by_segment(const void *a, const void *b)
{
  const at *x = a, *y = b;

  return x->s != y->s           ? (x->s < y->s ? -1 : 1)
         : x->point != y->point ? (x->point < y->point ? -1 : 1)
                                : y->of - x->of;
}

/* The points whose moves may be tight, of no segment yet. Null: no memory. */
static at *
find_moved(const measuring *m, size_t *n)
{
  at *found = malloc((m->r->point.n + 1) * sizeof *found);

  *n = 0;
  for (uint32_t i = 0; found && i < m->r->point.n; i++) {
    if (is_moved(m, i)) {
      found[(*n)++] = (at){0, i, false};
    }
  }
  return found;
}

/* The boxes of all segments; of one without triangles any will do. */
static sg_bvh *
open_segments(const measuring *m)
{
  const sg_resolve_trees *trees = m->trees;
  sg_box *box = malloc((trees->n + 1) * sizeof *box);

  for (size_t i = 0; box && i < trees->n; i++) {
    bool itself;
    const sg_leaf_tree *tree = trees->tree(trees->data, trees->s[i], &itself);
    box[i] = tree->boxes ? tree->box : (sg_box){0};
  }
  sg_bvh *open = box ? sg_bvh_open(box, trees->n, m->cancel) : NULL;
  free(box);
  return open;
}

/* Joins the points that move with the segments that they may be near. */
static bool
join_segments(const measuring *m, const at *moved, size_t n, sg_bvh_hits *hits)
{
  sg_bvh *points = open_points(m, moved, n);
  sg_bvh *segments = points ? open_segments(m) : NULL;
  sg_bvh_pair pair = {points, segments};
  bool done = segments && sg_bvh_join(&pair, 1, 0, m->pool, m->cancel, hits);

  for (size_t i = 0; done && i < hits->n; i++) {
    hits->hit[i].a = points->item[hits->hit[i].a];
    hits->hit[i].b = segments->item[hits->hit[i].b];
  }
  sg_bvh_close(points);
  sg_bvh_close(segments);
  return done;
}
/* The points that move, by segments that they are of or may be near, each once.
 * Null: no memory, or the cancellation said stop. */
static at *
find_places(const measuring *m, size_t *n)
{
  const sg_resolve *r = m->r;
  sg_bvh_hits hits = {0};
  size_t moves, all = 0;
  at *moved = find_moved(m, &moves), *found = NULL;

  if (moved && (moves == 0 || join_segments(m, moved, moves, &hits))) {
    found = malloc((hits.n + r->place.n + 1) * sizeof *found);
  }
  for (size_t i = 0; found && i < hits.n; i++) {
    found[all++] =
        (at){m->trees->s[hits.hit[i].b], moved[hits.hit[i].a].point, false};
  }
  for (size_t i = 0; found && i < r->place.n; i++) {
    uint32_t point = r->place.item[i].point;
    if (is_moved(m, point)) {
      found[all++] = (at){r->place.item[i].s, point, true};
    }
  }
  if (found && all > 0) {
    qsort(found, all, sizeof *found, by_segment);
  }
  *n = 0;
  for (size_t i = 0; found && i < all; i++) {
    if (*n == 0 || found[*n - 1].s != found[i].s ||
        found[*n - 1].point != found[i].point) {
      found[(*n)++] = found[i];
    }
  }
  free(moved);
  free(hits.hit);
  return found;
}

/* Gaps that were closed though their sources tell the two apart. */
static void
measure_gaps(const measuring *m)
{
  for (size_t i = 0; i < m->r->node.n; i++) {
    const sg_resolve_node *node = &m->r->node.item[i];
    if (node->gap > 0) {
      note_feature(m, node->point, node->s, node->gap, node->gap);
    }
  }
}

static bool
measure_segments(const measuring *m)
{
  size_t n = 0;
  at *place = find_places(m, &n);
  bool done = place;

  for (size_t i = 0, k = 0; done && i < n; i += k) {
    bool itself;
    const sg_leaf_tree *tree =
        m->trees->tree(m->trees->data, place[i].s, &itself);
    for (k = 1; k < BLOCK && i + k < n && place[i + k].s == place[i].s; k++) {
    }
    done = !tree || tree->curve || !tree->boxes ||
           measure_some(m, tree, itself, place + i, k);
    done = done && !sg_cancelled(m->cancel);
  }
  free(place);
  return done;
}

bool
sg_resolve_measure(const sg_resolve *r, const sg_resolve_trees *trees,
                   const sg_leaf_views *views, sg_pool *pool,
                   const sg_cancel *cancel, sg_resolve_moves *out)
{
  double *move = find_moves(r), *reach = move ? find_reaches(r, move) : NULL;
  double *rounding = find_rounding(r);
  unsigned char *counted = calloc(r->point.n + 1, 1);
  measuring m = {.r = r,
                 .trees = trees,
                 .views = views,
                 .move = move,
                 .rounding = rounding,
                 .reach = reach,
                 .pool = pool,
                 .cancel = cancel,
                 .counted = counted,
                 .out = out};
  bool done = reach && rounding && counted;

  *out = (sg_resolve_moves){0};
  for (uint32_t i = 0; done && i < r->point.n; i++) {
    if (is_moved(&m, i) && move[i] > out->farthest) {
      out->farthest = move[i];
      out->point = i;
    }
  }
  done = done && measure_segments(&m);
  if (done) {
    measure_gaps(&m);
  }
  free(move);
  free(rounding);
  free(reach);
  free(counted);
  return done;
}
