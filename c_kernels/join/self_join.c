/* self_join.c -- see self_join.h. */
#include "self_join_private.h"

#include "engine/list.h"
#include "engine/search.h"
#include "node_box.h"
#include "spine.h"

#include <stdlib.h>
#include <string.h>

enum { FEW = 8 }; /* no more than this part of all is joined with all */

/* ---- boxes ---- */

sg_box
sg_self_box_of(const sg_self_joiner *j, uint32_t i)
{
  sg_fan_triangle t;
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
  const sg_self_joiner *j = data;

  for (size_t i = begin; i < end; i++) {
    out[i - begin] =
        sg_self_box_of(j, j->filling ? j->filling[i] : (uint32_t)i);
  }
}

/* Needles that run askew overlap in boxes along x, y and z wherever they are.
 * False: stopped. */
static bool
find_run(sg_self_joiner *j, const sg_cancel *cancel)
{
  for (uint32_t i = 0; i < j->of->n; i++) {
    sg_fan_triangle t;

    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    j->of->read(j->of->data, i, &t);
    sg_run_add(&j->run, (const double(*)[3])t.at);
  }
  sg_run_end(&j->run);
  return true;
}

/* The tree over a list of triangles: those of the same stars together. */
static sg_bvh *
grow(sg_self_joiner *j, const uint32_t *list, size_t n, sg_pool *pool,
     const sg_cancel *cancel)
{
  sg_box all = sg_box_none();

  for (size_t i = 0; i < n; i++) {
    sg_box box = sg_self_box_of(j, list ? list[i] : (uint32_t)i);
    sg_box_join(&all, &box);
    if (sg_cancel_every(cancel, i)) {
      return NULL;
    }
  }
  j->filling = list;
  return sg_bvh_grow_grouped(n, fill_boxes, j, list, j->star, &all, pool,
                             cancel);
}

/* ---- pairs ---- */

uint32_t
sg_self_triangle_at(const sg_self_joiner *j, const sg_bvh *tree, uint32_t place)
{
  return tree == j->of->tree ? place : tree->item[place];
}

static bool
is_changed(const sg_self_joiner *j, uint32_t i)
{
  return !j->of->changed || j->of->changed[i];
}

/* Of triangles of one tree, or of those that are changed and all: each two come
 * once, and one of them is changed. */
static bool
is_asked(const sg_self_joiner *j, const sg_bvh_pair *pair, uint32_t i,
         uint32_t k)
{
  return pair->a == pair->b ? is_changed(j, i) || is_changed(j, k)
                            : i != k && (i < k || !is_changed(j, k));
}

static bool
are_equal(const sg_fan_triangle *a, const sg_fan_triangle *b)
{
  int same = 0;

  for (int i = 0; i < 9; i++) {
    same += a->name[i / 3] == b->name[i % 3];
  }
  return same >= 3;
}

static bool
ask(const sg_self_joiner *j, uint32_t i, uint32_t k)
{
  sg_fan_triangle a, b;

  if (j->star && (j->star[i] & j->star[k])) {
    return false;
  }
  j->of->read(j->of->data, i < k ? i : k, &a);
  j->of->read(j->of->data, i < k ? k : i, &b);
  return !(j->of->but_equal && are_equal(&a, &b)) &&
         j->of->wants(j->of->data, &a, &b);
}

static bool
wants_pair(void *data, const sg_bvh_hit *hit)
{
  const sg_self_joiner *j = data;
  const sg_bvh_pair *pair = &j->pair[hit->pair];
  uint32_t i = sg_self_triangle_at(j, pair->a, hit->a);
  uint32_t k = sg_self_triangle_at(j, pair->b, hit->b);

  return is_asked(j, pair, i, k) && ask(j, i, k);
}

/* A triangle that may meet a face; of two faces the later one asks. */
static bool
wants_face(void *data, const sg_bvh_hit *hit)
{
  const sg_self_joiner *j = data;
  const sg_bvh_pair *pair = &j->pair[hit->pair];
  uint32_t f = pair->a->item[hit->a],
           i = sg_self_triangle_at(j, pair->b, hit->b);
  sg_fan_triangle t;

  if (j->face_of[i] != SG_NO_KEY && j->face_of[i] >= f) {
    return false;
  }
  j->of->read(j->of->data, i, &t);
  return !sg_self_misses(j, f, &t);
}

/* One that does, with the triangles of the face. */
static bool
wants_of_face(void *data, const sg_bvh_hit *hit)
{
  const sg_self_joiner *j = data;
  const sg_bvh_pair *pair = &j->pair[hit->pair];
  uint32_t i = sg_self_triangle_at(j, pair->a, hit->a);
  uint32_t k = sg_self_triangle_at(j, pair->b, hit->b);
  sg_fan_triangle t;

  if (!is_changed(j, i) && !is_changed(j, k)) {
    return false;
  }
  j->of->read(j->of->data, k, &t);
  return (j->face_of[i] == SG_NO_KEY ||
          !sg_self_misses(j, j->face_of[i], &t)) &&
         ask(j, i, k);
}

/* Adds what a join found, by triangles. False: no memory. */
static bool
take(sg_self_joiner *j, const sg_bvh_hits *found, const sg_bvh_pair *pair)
{
  size_t room = j->hits.n;

  if (!sg_list_need(&j->hits.hit, j->hits.n + found->n, &room,
                    sizeof *j->hits.hit)) {
    return false;
  }
  for (size_t i = 0; i < found->n; i++) {
    const sg_bvh_pair *of = &pair[found->hit[i].pair];
    uint32_t a = sg_self_triangle_at(j, of->a, found->hit[i].a);
    uint32_t b = sg_self_triangle_at(j, of->b, found->hit[i].b);

    j->hits.hit[j->hits.n++] = (sg_bvh_hit){0, a < b ? a : b, a < b ? b : a};
  }
  return true;
}

static bool
join(sg_self_joiner *j, const sg_bvh_pair *pair, size_t n, sg_bvh_wants *wants,
     sg_pool *pool, const sg_cancel *cancel)
{
  sg_bvh_hits found;

  j->pair = pair;
  bool good = sg_bvh_join_wanted(pair, n, j->of->reach, wants, j, pool, cancel,
                                 &found) &&
              take(j, &found, pair);

  free(found.hit);
  return good;
}

/* ---- which trees ---- */

/* A tree at hand. */
typedef struct rooted {
  const sg_self_joiner *j;
  const sg_bvh *tree;
  sg_self_stars stars;  /* empty: none */
  sg_fans *fans;        /* null: none */
  sg_spines *spines;    /* the same */
  sg_node_boxes *boxes; /* the same */
} rooted;

/* An sg_fan_read. */
static void
read_place(const void *data, size_t place, sg_fan_triangle *out)
{
  const rooted *r = data;
  const sg_self_joining *of = r->j->of;

  of->read(of->data, sg_self_triangle_at(r->j, r->tree, (uint32_t)place), out);
  out->polygon = of->in_polygons ? -1 : out->polygon;
}

/* An sg_bvh_apart. */
static bool
are_apart(const void *data, unsigned level, size_t a, size_t b)
{
  const rooted *r = data;
  const atomic_bool *done = r->j->of->done;

  return (r->j->star && sg_self_stars_apart(r->j, &r->stars, level, a, b)) ||
         (done && atomic_load_explicit(done, memory_order_relaxed)) ||
         (r->fans && sg_fans_apart(r->fans, level, a, b)) ||
         (r->spines && sg_spines_apart(r->spines, level, a, b)) ||
         (r->boxes && sg_node_boxes_apart(r->boxes, level, a, b));
}

/* All triangles of a tree with all. */
static bool
join_itself(sg_self_joiner *j, const sg_bvh *tree, sg_pool *pool,
            const sg_cancel *cancel)
{
  rooted r = {.j = j, .tree = tree};
  sg_bvh_hits found = {0};

  j->only = (sg_bvh_pair){tree, tree};
  j->pair = &j->only;
  bool good =
      sg_self_stars_open(j, tree, cancel, &r.stars) &&
      sg_fans_open(tree, read_place, &r, j->of->by_place, cancel, &r.fans) &&
      (j->of->reach > 0 || sg_spines_open(tree, read_place, &r, j->of->by_place,
                                          cancel, &r.spines)) &&
      sg_node_boxes_open(tree, j->of->reach, read_place, &r, cancel,
                         &r.boxes) &&
      sg_bvh_join_itself(tree, j->of->reach, wants_pair, j,
                         j->star || r.fans || r.spines || r.boxes ? are_apart
                                                                  : NULL,
                         &r, pool, cancel, &found) &&
      take(j, &found, j->pair);

  sg_self_stars_close(&r.stars);
  sg_fans_close(r.fans);
  sg_spines_close(r.spines);
  sg_node_boxes_close(r.boxes);
  free(found.hit);
  return good;
}

/* All pairs of a list, one of which is changed. */
static bool
join_list(sg_self_joiner *j, const uint32_t *list, size_t n, const sg_bvh *tree,
          sg_pool *pool, const sg_cancel *cancel)
{
  uint32_t *some = NULL;
  size_t found = 0;

  if (!(some = malloc((n + 1) * sizeof *some))) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    uint32_t t = list ? list[i] : (uint32_t)i;

    some[found] = t;
    found += is_changed(j, t);
  }
  sg_bvh *of = found > n / FEW ? NULL : grow(j, some, found, pool, cancel);
  bool good = found > n / FEW ? join_itself(j, tree, pool, cancel)
                              : of && join(j, &(sg_bvh_pair){of, tree}, 1,
                                           wants_pair, pool, cancel);

  sg_bvh_close(of);
  free(some);
  return good;
}

static bool
join_singles(sg_self_joiner *j, sg_pool *pool, const sg_cancel *cancel)
{
  sg_bvh *tree = grow(j, j->single, j->singles, pool, cancel);
  bool good = tree && join_list(j, j->single, j->singles, tree, pool, cancel);

  sg_bvh_close(tree);
  return good;
}

SG_ORDER(by_pair, sg_bvh_hit, SG_BY(a) SG_BY(b));

/* The faces (a) and the triangles (b) that may meet them, in order. */
static bool
meet_faces(sg_self_joiner *j, const sg_bvh *tree, sg_pool *pool,
           const sg_cancel *cancel, sg_bvh_hits *out)
{
  sg_box *box = malloc((j->faces + 1) * sizeof *box);

  *out = (sg_bvh_hits){0};
  for (size_t f = 0; box && f < j->faces; f++) {
    box[f] = j->face[f].box;
  }
  sg_bvh *faces = box ? sg_bvh_open(box, j->faces, cancel) : NULL;

  j->only = (sg_bvh_pair){faces, tree};
  j->pair = &j->only;
  bool good = faces && sg_bvh_join_wanted(j->pair, 1, 0, wants_face, j, pool,
                                          cancel, out);

  for (size_t i = 0; i < out->n; i++) {
    sg_bvh_hit *hit = &out->hit[i];
    *hit = (sg_bvh_hit){0, faces->item[hit->a],
                        sg_self_triangle_at(j, tree, hit->b)};
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
grow_pair(sg_self_joiner *j, const sg_bvh_hit *hit, size_t n, uint32_t *list,
          sg_bvh_pair *out, sg_pool *pool, const sg_cancel *cancel)
{
  const sg_self_face *f = &j->face[hit->a];

  for (size_t i = 0; i < n; i++) {
    list[i] = hit[i].b;
  }
  out->a = grow(j, list, n, pool, cancel);
  out->b = grow(j, j->in_face + f->first, f->n, pool, cancel);
  return out->a && out->b;
}

/* If faces may meet themselves: looks whether one may, what is changed of its
 * triangles with all. Then all triangles are asked about: there are no faces.
 */
static bool
look_into_faces(sg_self_joiner *j, sg_pool *pool, const sg_cancel *cancel)
{
  bool good = true;

  for (size_t f = 0; good && j->of->in_faces && f < j->faces; f++) {
    const uint32_t *list = j->in_face + j->face[f].first;
    sg_bvh *tree = grow(j, list, j->face[f].n, pool, cancel);

    good = tree && join_list(j, list, j->face[f].n, tree, pool, cancel);
    sg_bvh_close(tree);
    if (j->hits.n > 0) {
      j->faces = j->hits.n = 0;
    }
  }
  return good;
}

static bool
join_faces(sg_self_joiner *j, const sg_bvh *tree, sg_pool *pool,
           const sg_cancel *cancel)
{
  sg_bvh_hits met = {0};
  sg_bvh_pair *pair = calloc(j->faces + 1, sizeof *pair);
  bool good = pair && meet_faces(j, tree, pool, cancel, &met);
  uint32_t *list = good ? malloc((met.n + 1) * sizeof *list) : NULL;
  size_t pairs = 0;

  good = good && list;
  for (size_t i = 0, end; good && i < met.n; i = end, pairs++) {
    for (end = i; end < met.n && met.hit[end].a == met.hit[i].a; end++) {
    }
    good = grow_pair(j, &met.hit[i], end - i, list, &pair[pairs], pool, cancel);
  }
  good = good && join(j, pair, pairs, wants_of_face, pool, cancel);
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
put_in_order(sg_self_joiner *j)
{
  if (j->of->tree && j->hits.n > 0 && (j->tree || j->faces > 0)) {
    qsort(j->hits.hit, j->hits.n, sizeof *j->hits.hit,
          j->run.askew ? by_pair : by_descent);
  }
}

bool
sg_self_join(const sg_self_joining *joining, sg_pool *pool,
             const sg_cancel *cancel, sg_bvh_hits *out)
{
  sg_self_joiner j = {.of = joining};

  sg_key_table_init(&j.corner, 2);
  sg_key_table_init(&j.border, 3);
  bool good = find_run(&j, cancel) && sg_self_find_faces(&j, cancel) &&
              sg_self_find_stars(&j, cancel);

  if (good && (!joining->tree || j.run.askew || j.star)) {
    j.tree = grow(&j, NULL, joining->n, pool, cancel);
    good = j.tree != NULL;
  }
  const sg_bvh *tree = j.tree ? j.tree : joining->tree;

  good = good && look_into_faces(&j, pool, cancel) &&
         (j.faces > 0 ? join_singles(&j, pool, cancel) &&
                            join_faces(&j, tree, pool, cancel)
                      : join_list(&j, NULL, joining->n, tree, pool, cancel));
  put_in_order(&j);
  sg_bvh_close(j.tree);
  free(j.star);
  sg_self_clear_faces(&j);
  if (!good) {
    free(j.hits.hit);
    j.hits = (sg_bvh_hits){0};
  }
  *out = j.hits;
  return good;
}
