/* self_join.c -- see self_join.h. */
#include "self_join.h"

#include "cut.h"
#include "fan.h"
#include "number/exact.h"
#include "oriented_box.h"
#include "rows/key_table.h"

#include <stdlib.h>
#include <string.h>

enum { MANY = 32 }; /* triangles of a polygon that is taken as one thing */

/* A flat polygon of many triangles. */
typedef struct face {
  int32_t p;
  uint32_t first, n; /* in joiner.in_face */
  double at[3][3];   /* of a triangle with an area */
  int axis, turn;    /* how that is seen */
  sg_box box;
} face;

typedef struct joiner {
  const sg_self_joining *of;
  sg_run run;
  sg_bvh *tree;            /* of all, if that of the caller will not do */
  const uint32_t *filling; /* the list whose boxes are asked for; null: all */
  face *face;              /* [faces] */
  size_t faces;
  uint32_t *face_of; /* [n]; SG_NO_KEY: of none; null: there are no faces */
  uint32_t *in_face; /* triangles, face by face */
  uint32_t *single;  /* the others */
  size_t singles;
  sg_key_table corner;     /* face, vertex */
  sg_key_table border;     /* face, two vertices -> how many triangles */
  const sg_bvh_pair *pair; /* of the join under way */
  sg_bvh_hits hits;
} joiner;

/* ---- boxes ---- */

static sg_box
box_of(const joiner *j, uint32_t i)
{
  sg_self_triangle t;
  sg_box box = sg_box_none();

  j->of->read(j->of->data, i, &t);
  for (int k = 0; k < 3; k++) {
    double at[3];

    sg_run_turn(&j->run, t.at[k], at);
    sg_box_add(&box, at);
  }
  return box;
}

static void
fill_boxes(const void *data, size_t begin, size_t end, sg_box *out)
{
  const joiner *j = data;

  for (size_t i = begin; i < end; i++) {
    out[i - begin] = box_of(j, j->filling ? j->filling[i] : (uint32_t)i);
  }
}

/* Needles that run askew overlap in boxes along x, y and z wherever they are.
 */
static void
find_run(joiner *j)
{
  for (uint32_t i = 0; i < j->of->n; i++) {
    sg_self_triangle t;

    j->of->read(j->of->data, i, &t);
    sg_run_add(&j->run, (const double(*)[3])t.at);
  }
  sg_run_end(&j->run);
}

/* The tree over a list of triangles. */
static sg_bvh *
grow(joiner *j, const uint32_t *list, size_t n, sg_crew *crew,
     const sg_poll *poll)
{
  sg_box all = sg_box_none();

  for (size_t i = 0; i < n; i++) {
    sg_box box = box_of(j, list ? list[i] : (uint32_t)i);
    sg_box_join(&all, &box);
  }
  j->filling = list;
  return sg_bvh_grow(n, fill_boxes, j, list, &all, crew, poll);
}

/* ---- faces ---- */

typedef struct of_polygon {
  int32_t p;
  uint32_t i;
} of_polygon;

static int
by_polygon(const void *x, const void *y)
{
  const of_polygon *a = x, *b = y;

  return a->p != b->p ? (a->p > b->p) - (a->p < b->p)
                      : (a->i > b->i) - (a->i < b->i);
}

/* Those that are of polygons of many triangles, by polygon. Most meshes have
 * none: first all are counted in a few places. False: no memory. */
static bool
find_many(const joiner *j, of_polygon **out, size_t *n)
{
  enum { PLACES = 1 << 14 };
  uint32_t *count = calloc(PLACES, sizeof *count);
  sg_self_triangle t;
  size_t most = 0;

  *n = 0;
  *out = NULL;
  for (uint32_t i = 0; count && i < j->of->n; i++) {
    j->of->read(j->of->data, i, &t);
    most += ++count[(uint32_t)t.p % PLACES] == MANY;
  }
  if (count && most > 0) {
    *out = malloc((j->of->n + 1) * sizeof **out);
  }
  for (uint32_t i = 0; *out && i < j->of->n; i++) {
    j->of->read(j->of->data, i, &t);
    if (count[(uint32_t)t.p % PLACES] >= MANY) {
      (*out)[(*n)++] = (of_polygon){t.p, i};
    }
  }
  bool good = count && (most == 0 || *out);

  free(count);
  if (*n > 0) {
    qsort(*out, *n, sizeof **out, by_polygon);
  }
  return good;
}

static int
turn_of(int axis, const double t[3][3])
{
  int x = (axis + 1) % 3, y = (axis + 2) % 3;

  return sg_orient2d((double[2]){t[0][x], t[0][y]},
                     (double[2]){t[1][x], t[1][y]},
                     (double[2]){t[2][x], t[2][y]});
}

/* Whether all triangles lie in one plane and look one way, exactly. */
static bool
is_face(const joiner *j, const of_polygon *item, size_t n, face *out)
{
  sg_self_triangle t;

  j->of->read(j->of->data, item[0].i, &t);
  memcpy(out->at, t.at, sizeof out->at);
  out->axis = sg_cut_axis((const double(*)[3])t.at);
  if (out->axis < 0) {
    return false;
  }
  out->turn = turn_of(out->axis, (const double(*)[3])t.at);
  out->box = sg_box_none();
  for (size_t i = 0; i < n; i++) {
    sg_box box = box_of(j, item[i].i);

    sg_box_join(&out->box, &box);
    j->of->read(j->of->data, item[i].i, &t);
    for (int k = 0; k < 3; k++) {
      if (sg_orient3d(out->at[0], out->at[1], out->at[2], t.at[k]) != 0) {
        return false;
      }
    }
    if (turn_of(out->axis, (const double(*)[3])t.at) != out->turn) {
      return false;
    }
  }
  return true;
}

static void
border_key(uint32_t f, uint32_t v, uint32_t w, uint32_t key[3])
{
  key[0] = f;
  key[1] = v < w ? v : w;
  key[2] = v < w ? w : v;
}

/* A triangle of face f. False: no memory. */
static bool
add_to_face(joiner *j, uint32_t f, uint32_t i)
{
  sg_self_triangle t;

  j->face_of[i] = f;
  j->in_face[j->face[f].first + j->face[f].n++] = i;
  j->of->read(j->of->data, i, &t);
  for (int k = 0; k < 3; k++) {
    uint32_t key[3] = {f, t.v[k]}, *count;

    if (!sg_key_table_add(&j->corner, key)) {
      return false;
    }
    border_key(f, t.v[k], t.v[(k + 1) % 3], key);
    if (!(count = sg_key_table_put(&j->border, key))) {
      return false;
    }
    *count = *count == SG_NO_KEY ? 1 : *count + 1;
  }
  return true;
}

static bool
take_faces(joiner *j, const of_polygon *item, size_t n)
{
  uint32_t used = 0;

  j->face = malloc((n / MANY + 1) * sizeof *j->face);
  j->face_of = malloc((j->of->n + 1) * sizeof *j->face_of);
  j->in_face = malloc((n + 1) * sizeof *j->in_face);
  j->single = malloc((j->of->n + 1) * sizeof *j->single);
  if (!j->face || !j->face_of || !j->in_face || !j->single) {
    return false;
  }
  memset(j->face_of, 0xff, j->of->n * sizeof *j->face_of);
  for (size_t i = 0, end; i < n; i = end) {
    face *to = &j->face[j->faces];

    for (end = i; end < n && item[end].p == item[i].p; end++) {
    }
    *to = (face){.p = item[i].p, .first = used};
    if (end - i < MANY || !is_face(j, item + i, end - i, to)) {
      continue;
    }
    for (size_t k = i; k < end; k++) {
      if (!add_to_face(j, (uint32_t)j->faces, item[k].i)) {
        return false;
      }
    }
    used += to->n;
    j->faces++;
  }
  for (uint32_t i = 0; i < j->of->n; i++) {
    if (j->face_of[i] == SG_NO_KEY) {
      j->single[j->singles++] = i;
    }
  }
  return true;
}

/* What is within reach of a face must be asked for one by one. */
static bool
find_faces(joiner *j)
{
  of_polygon *item;
  size_t n;

  if (j->of->reach > 0) {
    return true;
  }
  bool good = find_many(j, &item, &n) && (n == 0 || take_faces(j, item, n));

  free(item);
  return good;
}

/* Whether a triangle has nothing in common with a face but a corner, or an edge
 * that is an edge of the face. Exact. */
static bool
misses(const joiner *j, uint32_t f, const sg_self_triangle *t)
{
  const face *of = &j->face[f];
  int shared[3], n = 0, sides = 0;

  for (int k = 0; k < 3; k++) {
    if (sg_key_table_get(&j->corner, (uint32_t[2]){f, t->v[k]}) != SG_NO_KEY) {
      shared[n++] = k;
    } else {
      sides += sg_orient3d(of->at[0], of->at[1], of->at[2], t->at[k]);
    }
  }
  if (n == 3 || (sides != 3 - n && sides != n - 3)) {
    return false;
  }
  uint32_t key[3];

  if (n == 2) {
    border_key(f, t->v[shared[0]], t->v[shared[1]], key);
  }
  return n < 2 || sg_key_table_get(&j->border, key) == 1;
}

/* ---- pairs ---- */

/* The triangle at a place of a tree. */
static uint32_t
triangle_at(const joiner *j, const sg_bvh *tree, uint32_t place)
{
  return tree == j->of->tree ? place : tree->item[place];
}

static bool
is_changed(const joiner *j, uint32_t i)
{
  return j->of->changed && j->of->changed[i];
}

/* Of triangles that are both in the first tree. */
static bool
is_second(const joiner *j, const sg_bvh_pair *pair, uint32_t i, uint32_t k)
{
  return i == k ||
         (pair->a != pair->b && i > k && is_changed(j, i) && is_changed(j, k));
}

static bool
ask(const joiner *j, uint32_t i, uint32_t k)
{
  sg_self_triangle a, b;

  j->of->read(j->of->data, i < k ? i : k, &a);
  j->of->read(j->of->data, i < k ? k : i, &b);
  return j->of->wants(j->of->data, &a, &b);
}

static bool
wants_pair(void *data, const sg_bvh_hit *hit)
{
  const joiner *j = data;
  const sg_bvh_pair *pair = &j->pair[hit->pair];
  uint32_t i = triangle_at(j, pair->a, hit->a);
  uint32_t k = triangle_at(j, pair->b, hit->b);

  return !is_second(j, pair, i, k) && ask(j, i, k);
}

/* A triangle that may meet a face; of two faces the later one asks. */
static bool
wants_face(void *data, const sg_bvh_hit *hit)
{
  const joiner *j = data;
  const sg_bvh_pair *pair = &j->pair[hit->pair];
  uint32_t f = pair->a->item[hit->a], i = triangle_at(j, pair->b, hit->b);
  sg_self_triangle t;

  if (j->face_of[i] != SG_NO_KEY && j->face_of[i] >= f) {
    return false;
  }
  j->of->read(j->of->data, i, &t);
  return !misses(j, f, &t);
}

/* One that does, with the triangles of the face. */
static bool
wants_of_face(void *data, const sg_bvh_hit *hit)
{
  const joiner *j = data;
  const sg_bvh_pair *pair = &j->pair[hit->pair];
  uint32_t i = triangle_at(j, pair->a, hit->a);
  uint32_t k = triangle_at(j, pair->b, hit->b);
  sg_self_triangle t;

  if (j->of->changed && !is_changed(j, i) && !is_changed(j, k)) {
    return false;
  }
  j->of->read(j->of->data, k, &t);
  return (j->face_of[i] == SG_NO_KEY || !misses(j, j->face_of[i], &t)) &&
         ask(j, i, k);
}

/* Adds what a join found, by triangles. False: no memory. */
static bool
take(joiner *j, const sg_bvh_hits *found, const sg_bvh_pair *pair)
{
  sg_bvh_hit *more =
      realloc(j->hits.hit, (j->hits.n + found->n + 1) * sizeof *more);

  if (!more) {
    return false;
  }
  j->hits.hit = more;
  for (size_t i = 0; i < found->n; i++) {
    const sg_bvh_pair *of = &pair[found->hit[i].pair];
    uint32_t a = triangle_at(j, of->a, found->hit[i].a);
    uint32_t b = triangle_at(j, of->b, found->hit[i].b);

    more[j->hits.n++] = (sg_bvh_hit){0, a < b ? a : b, a < b ? b : a};
  }
  return true;
}

static bool
join(joiner *j, const sg_bvh_pair *pair, size_t n, sg_bvh_wants *wants,
     sg_crew *crew, const sg_poll *poll)
{
  sg_bvh_hits found;

  j->pair = pair;
  bool good =
      sg_bvh_join_wanted(pair, n, j->of->reach, wants, j, crew, poll, &found) &&
      take(j, &found, pair);

  free(found.hit);
  return good;
}

/* ---- which trees ---- */

/* A tree at hand. */
typedef struct rooted {
  const joiner *j;
  const sg_bvh *tree;
} rooted;

/* An sg_fan_read. */
static void
read_place(const void *data, size_t place, sg_fan_triangle *out)
{
  const rooted *r = data;
  const sg_self_joining *of = r->j->of;
  sg_self_triangle t;

  of->read(of->data, triangle_at(r->j, r->tree, (uint32_t)place), &t);
  memcpy(out->at, t.at, sizeof out->at);
  memcpy(out->name, t.v, sizeof out->name);
  out->polygon = of->in_polygons ? -1 : t.p;
}

/* All triangles of a tree with all. */
static bool
join_itself(joiner *j, const sg_bvh *tree, sg_crew *crew, const sg_poll *poll)
{
  const rooted r = {j, tree};
  const sg_bvh_pair pair = {tree, tree};
  sg_bvh_hits found = {0};
  sg_fans *fans;

  j->pair = &pair;
  bool good = sg_fans_open(tree, read_place, &r, j->of->by_place, &fans) &&
              sg_bvh_join_itself(tree, j->of->reach, wants_pair, j,
                                 fans ? sg_fans_apart : NULL, fans, crew, poll,
                                 &found) &&
              take(j, &found, &pair);

  sg_fans_close(fans);
  free(found.hit);
  return good;
}

/* All pairs of a list, one of which is changed. */
static bool
join_list(joiner *j, const uint32_t *list, size_t n, const sg_bvh *tree,
          sg_crew *crew, const sg_poll *poll)
{
  uint32_t *some = NULL;
  size_t found = 0;

  if (!j->of->changed) {
    return join_itself(j, tree, crew, poll);
  }
  if (!(some = malloc((n + 1) * sizeof *some))) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    uint32_t t = list ? list[i] : (uint32_t)i;

    some[found] = t;
    found += is_changed(j, t);
  }
  sg_bvh *of = grow(j, some, found, crew, poll);
  bool good =
      of && join(j, &(sg_bvh_pair){of, tree}, 1, wants_pair, crew, poll);

  sg_bvh_close(of);
  free(some);
  return good;
}

static bool
join_singles(joiner *j, sg_crew *crew, const sg_poll *poll)
{
  sg_bvh *tree = grow(j, j->single, j->singles, crew, poll);
  bool good = tree && join_list(j, j->single, j->singles, tree, crew, poll);

  sg_bvh_close(tree);
  return good;
}

static int
by_pair(const void *x, const void *y)
{
  const sg_bvh_hit *a = x, *b = y;

  return a->a != b->a ? (a->a > b->a) - (a->a < b->a)
                      : (a->b > b->b) - (a->b < b->b);
}

/* The faces (a) and the triangles (b) that may meet them, in order. */
static bool
meet_faces(joiner *j, const sg_bvh *tree, sg_crew *crew, const sg_poll *poll,
           sg_bvh_hits *out)
{
  sg_box *box = malloc((j->faces + 1) * sizeof *box);

  *out = (sg_bvh_hits){0};
  for (size_t f = 0; box && f < j->faces; f++) {
    box[f] = j->face[f].box;
  }
  sg_bvh *faces = box ? sg_bvh_open(box, j->faces, poll) : NULL;
  const sg_bvh_pair pair = {faces, tree};

  j->pair = &pair;
  bool good =
      faces && sg_bvh_join_wanted(&pair, 1, 0, wants_face, j, crew, poll, out);

  for (size_t i = 0; i < out->n; i++) {
    sg_bvh_hit *hit = &out->hit[i];
    *hit = (sg_bvh_hit){0, faces->item[hit->a], triangle_at(j, tree, hit->b)};
  }
  if (out->n > 0) {
    qsort(out->hit, out->n, sizeof *out->hit, by_pair);
  }
  sg_bvh_close(faces);
  free(box);
  return good;
}

/* The trees of a face and of the n triangles of hits that may meet it. */
static bool
grow_pair(joiner *j, const sg_bvh_hit *hit, size_t n, uint32_t *list,
          sg_bvh_pair *out, sg_crew *crew, const sg_poll *poll)
{
  const face *f = &j->face[hit->a];

  for (size_t i = 0; i < n; i++) {
    list[i] = hit[i].b;
  }
  out->a = grow(j, list, n, crew, poll);
  out->b = grow(j, j->in_face + f->first, f->n, crew, poll);
  return out->a && out->b;
}

static bool
join_faces(joiner *j, const sg_bvh *tree, sg_crew *crew, const sg_poll *poll)
{
  sg_bvh_hits met;
  sg_bvh_pair *pair = calloc(j->faces + 1, sizeof *pair);
  bool good = pair && meet_faces(j, tree, crew, poll, &met);
  uint32_t *list = good ? malloc((met.n + 1) * sizeof *list) : NULL;
  size_t pairs = 0;

  good = good && list;
  for (size_t i = 0, end; good && i < met.n; i = end, pairs++) {
    for (end = i; end < met.n && met.hit[end].a == met.hit[i].a; end++) {
    }
    good = grow_pair(j, &met.hit[i], end - i, list, &pair[pairs], crew, poll);
  }
  good = good && join(j, pair, pairs, wants_of_face, crew, poll);
  for (size_t f = 0; pair && f < j->faces; f++) {
    sg_bvh_close((sg_bvh *)pair[f].a);
    sg_bvh_close((sg_bvh *)pair[f].b);
  }
  free(pair);
  free(list);
  free(met.hit);
  return good;
}

/* ---- in order ---- */

/* The join of a tree with itself goes down in both places at once. */
static uint64_t
descent_key(const sg_bvh_hit *hit)
{
  uint64_t key = 0;

  for (int level = 30; level >= 0; level -= 2) {
    key = key << 4 | (hit->a >> level & 3) << 2 | (hit->b >> level & 3);
  }
  return key;
}

static int
by_descent(const void *x, const void *y)
{
  uint64_t a = descent_key(x), b = descent_key(y);

  return (a > b) - (a < b);
}

static void
put_in_order(joiner *j)
{
  if (j->of->tree && j->hits.n > 0 && (j->tree || j->faces > 0)) {
    qsort(j->hits.hit, j->hits.n, sizeof *j->hits.hit,
          j->run.askew ? by_pair : by_descent);
  }
}

static void
clear(joiner *j)
{
  sg_bvh_close(j->tree);
  free(j->face);
  free(j->face_of);
  free(j->in_face);
  free(j->single);
  sg_key_table_clear(&j->corner);
  sg_key_table_clear(&j->border);
}

bool
sg_self_join(const sg_self_joining *joining, sg_crew *crew, const sg_poll *poll,
             sg_bvh_hits *out)
{
  joiner j = {.of = joining};

  sg_key_table_init(&j.corner, 2);
  sg_key_table_init(&j.border, 3);
  find_run(&j);
  bool good = find_faces(&j);

  if (good && (!joining->tree || j.run.askew)) {
    j.tree = grow(&j, NULL, joining->n, crew, poll);
    good = j.tree != NULL;
  }
  const sg_bvh *tree = j.tree ? j.tree : joining->tree;

  good = good &&
         (j.faces > 0
              ? join_singles(&j, crew, poll) && join_faces(&j, tree, crew, poll)
              : join_list(&j, NULL, joining->n, tree, crew, poll));
  put_in_order(&j);
  clear(&j);
  if (!good) {
    free(j.hits.hit);
    j.hits = (sg_bvh_hits){0};
  }
  *out = j.hits;
  return good;
}
