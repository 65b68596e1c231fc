#include "leaf_tree.h"

#include <math.h>
#include <stdlib.h>

enum {
  SMALL = 1 << 15, /* a tree of fewer leaves is one task, and so is less
                    * than so many rows in all */
  ASKED = 1 << 16, /* vertices between questions */
  POINTS = 1 << 14 /* places of a task */
};

typedef struct forest {
  const sg_leaf_views *views;
  sg_segment_rows vertices, triangles, edges;
  size_t *edge_place; /* which rows of `edges`; only of curves */
  sg_leaf_tree **tree;
  size_t n;
  const sg_cancel *cancel;
} forest;

/* Points by place, each task a block of places. */
typedef struct placing {
  const sg_leaf_tree *tree;
  const sg_view *v;
  const double *from;
  double (*out)[3];
} placing;

static void
place_points(void *data, size_t block)
{
  const placing *p = data;
  const sg_id_rows *table = &p->tree->vertex;
  size_t end = (block + 1) * POINTS;

  for (size_t i = block * POINTS; i < end && i < table->places; i++) {
    if (table->row[i] == SG_NO_ID_ROW) {
      p->out[i][0] = p->out[i][1] = p->out[i][2] = NAN;
      continue;
    }
    sg_view_point(p->v, table->row[i], p->out[i]);
    for (int k = 0; k < 3; k++) {
      p->out[i][k] -= p->from[k];
    }
  }
}

static size_t
point_blocks(const sg_leaf_tree *tree)
{
  return (tree->vertex.places + POINTS - 1) / POINTS;
}

double (*sg_leaf_points(const sg_leaf_tree *tree, const sg_leaf_views *views,
                        const double from[3], sg_pool *pool,
                        const sg_cancel *cancel))[3]
{
  placing p = {tree, &views->v, from,
               malloc((tree->vertex.places + 1) * sizeof *p.out)};

  if (p.out &&
      !sg_pool_run(pool, point_blocks(tree), place_points, &p, cancel)) {
    free(p.out);
    p.out = NULL;
  }
  return p.out;
}

/* ---- boxes ---- */

typedef struct leaves {
  const forest *forest;
  const sg_leaf_tree *tree;
  const uint32_t *row;
  sg_bvh_frame frame;
  sg_box32 *point; /* by place: the box of a vertex, let out */
} leaves;

/* The box of no vertex is empty. */
static void
let_points_out(void *data, size_t block)
{
  const leaves *l = data;
  const sg_id_rows *table = &l->tree->vertex;
  size_t end = (block + 1) * POINTS;

  for (size_t i = block * POINTS; i < end && i < table->places; i++) {
    sg_box box = sg_box_none();
    double p[3];

    if (table->row[i] != SG_NO_ID_ROW) {
      sg_view_point(&l->forest->views->v, table->row[i], p);
      sg_box_add(&box, p);
    }
    l->point[i] = sg_box_let_out(&l->frame, &box);
  }
}

static void
join_point(sg_box32 *box, const sg_box32 *point)
{
  for (int c = 0; c < 3; c++) {
    box->lo[c] = point->lo[c] < box->lo[c] ? point->lo[c] : box->lo[c];
    box->hi[c] = point->hi[c] > box->hi[c] ? point->hi[c] : box->hi[c];
  }
}

/* The vertices of a leaf are there: the store sees to it. One that is not
 * would leave the box where the others are. */
static void
leaf_boxes(const void *data, size_t begin, size_t end, sg_box32 *out)
{
  static const sg_box32 none = {{INFINITY, INFINITY, INFINITY},
                                {-INFINITY, -INFINITY, -INFINITY}};
  const leaves *l = data;
  const sg_leaf_views *views = l->forest->views;
  const sg_view *view = l->tree->curve ? &views->e : &views->t;
  unsigned first = l->tree->curve ? 2 : 3, n = l->tree->curve ? 2 : 3;

  for (size_t i = begin; i < end; i++) {
    sg_box32 box = none;

    for (unsigned k = 0; k < n; k++) {
      size_t slot = sg_id_rows_slot(&l->tree->vertex,
                                    sg_view_int(view, first + k, l->row[i]));
      if (slot != SG_NO_ID_PLACE) {
        join_point(&box, &l->point[slot]);
      }
    }
    out[i - begin] = box;
  }
}

/* ---- one tree ---- */

/* The rows to be cut of segment i: of t/6, or of e/5 for a curve. */
static size_t
leaf_rows(const forest *f, size_t i, const uint32_t **row)
{
  const sg_segment_rows *from = f->tree[i]->curve ? &f->edges : &f->triangles;
  size_t k = f->tree[i]->curve ? f->edge_place[i] : i;

  *row = from->row + from->begin[k];
  return from->begin[k + 1] - from->begin[k];
}

/* The box round n rows of v/5. When the thread pool is stopping it is of no
 * use, and nothing comes of it. */
static sg_box
box_round(const sg_view *v, const uint32_t *row, size_t n)
{
  sg_box box = sg_box_none();

  for (size_t k = 0; k < n; k++) {
    double p[3];
    if (k % ASKED == ASKED - 1 && sg_pool_stopping()) {
      break;
    }
    sg_view_point(v, row[k], p);
    sg_box_add(&box, p);
  }
  return box;
}

/* The table of vertices and the box round them. False: no memory. */
static bool
take_vertices(const forest *f, size_t i)
{
  const sg_segment_rows *from = &f->vertices;
  const uint32_t *row = from->row + from->begin[i];
  size_t n = from->begin[i + 1] - from->begin[i];
  sg_leaf_tree *tree = f->tree[i];

  tree->box = box_round(&f->views->v, row, n);
  return sg_id_rows_make(&f->views->v, row, n, &tree->vertex);
}

/* Makes tree i except its vertices. What is left null tells of a failure. */
static void
grow_one(const forest *f, size_t i, sg_pool *pool, const sg_cancel *cancel)
{
  sg_leaf_tree *tree = f->tree[i];
  leaves l = {.forest = f, .tree = tree};
  size_t n = leaf_rows(f, i, &l.row);

  tree->begin = n > 0 ? l.row[0] : 0;
  tree->end = n > 0 ? l.row[n - 1] + 1 : 0;
  l.frame = sg_bvh_frame_of(&tree->box);
  l.point = malloc((tree->vertex.places + 1) * sizeof *l.point);
  if (l.point &&
      sg_pool_run(pool, point_blocks(tree), let_points_out, &l, cancel)) {
    tree->boxes =
        sg_bvh_grow_let_out(n, leaf_boxes, &l, l.row, &tree->box, pool, cancel);
  }
  free(l.point);
}

/* ---- all ---- */

static void
vertices_task(void *data, size_t i)
{
  forest *f = data;

  if (!take_vertices(f, i)) {
    sg_id_rows_clear(&f->tree[i]->vertex);
    f->tree[i]->s = 0; /* no memory */
  }
}

static void
small_task(void *data, size_t i)
{
  const forest *f = data;
  const uint32_t *row;

  if (leaf_rows(f, i, &row) < SMALL) {
    grow_one(f, i, NULL, NULL);
  }
}

/* Trees that are still without boxes, one after another by the whole thread
 * pool. */
static bool
grow_large(const forest *f, sg_pool *pool)
{
  bool good = true;

  for (size_t i = 0; i < f->n && good; i++) {
    const uint32_t *row;

    if (!f->tree[i]->boxes && leaf_rows(f, i, &row) >= SMALL) {
      grow_one(f, i, pool, f->cancel);
    }
    good = f->tree[i]->boxes != NULL;
  }
  return good;
}

/* The edges of segments without triangles. */
static bool
find_edges(forest *f, const int32_t *wanted)
{
  int32_t *curve = malloc((f->n + 1) * sizeof *curve);
  size_t curves = 0;

  f->edge_place = malloc((f->n + 1) * sizeof *f->edge_place);
  if (!curve || !f->edge_place) {
    free(curve);
    return false;
  }
  for (size_t i = 0; i < f->n; i++) {
    f->tree[i]->curve = f->triangles.begin[i] == f->triangles.begin[i + 1];
    if (f->tree[i]->curve) {
      f->edge_place[i] = curves;
      curve[curves++] = wanted[i];
    }
  }
  bool good = curves == 0 || sg_segment_rows_find(&f->views->e, curve, curves,
                                                  f->cancel, &f->edges);

  free(curve);
  return good;
}

/* The rows of n segments. */
static size_t
rows_of(const sg_segment_rows *rows, size_t n)
{
  return rows->begin[n] - rows->begin[0];
}

static bool
grow_all(forest *f, const int32_t *wanted, sg_pool *pool)
{
  for (size_t i = 0; i < f->n; i++) {
    if (!(f->tree[i] = calloc(1, sizeof *f->tree[i]))) {
      return false;
    }
    f->tree[i]->s = wanted[i];
  }
  if (!sg_segment_rows_find(&f->views->v, wanted, f->n, f->cancel,
                            &f->vertices) ||
      !sg_segment_rows_find(&f->views->t, wanted, f->n, f->cancel,
                            &f->triangles) ||
      !find_edges(f, wanted)) {
    return false;
  }
  if (rows_of(&f->vertices, f->n) + rows_of(&f->triangles, f->n) < SMALL) {
    pool = NULL;
  }
  if (!sg_pool_run(pool, f->n, vertices_task, f, f->cancel)) {
    return false;
  }
  for (size_t i = 0; i < f->n; i++) {
    if (f->tree[i]->s == 0) {
      return false;
    }
  }
  return sg_pool_run(pool, f->n, small_task, f, f->cancel) &&
         grow_large(f, pool);
}

bool
sg_leaf_trees_grow(const sg_leaf_views *views, const int32_t *wanted, size_t n,
                   sg_pool *pool, const sg_cancel *cancel, sg_leaf_tree **out)
{
  forest f = {.views = views, .tree = out, .n = n, .cancel = cancel};
  bool good;

  for (size_t i = 0; i < n; i++) {
    out[i] = NULL;
  }
  good = n == 0 || grow_all(&f, wanted, pool);
  for (size_t i = 0; i < n && !good; i++) {
    sg_leaf_tree_close(out[i]);
    out[i] = NULL;
  }
  sg_segment_rows_clear(&f.vertices);
  sg_segment_rows_clear(&f.triangles);
  sg_segment_rows_clear(&f.edges);
  free(f.edge_place);
  return good;
}

void
sg_leaf_tree_close(sg_leaf_tree *tree)
{
  if (tree) {
    sg_id_rows_clear(&tree->vertex);
    sg_bvh_close(tree->boxes);
    free(tree);
  }
}

size_t
sg_leaf_tree_bytes(const sg_leaf_tree *tree)
{
  return sizeof *tree + sg_id_rows_bytes(&tree->vertex) +
         sg_bvh_bytes(tree->boxes);
}

/* ---- boxes alone ---- */

typedef struct box_job {
  const sg_view *vertices;
  sg_segment_rows rows;
  sg_box *box; /* one of the two is null */
  sg_oriented_box *oriented;
} box_job;

/* The vertices of one segment. */
typedef struct own_rows {
  const sg_view *vertices;
  const uint32_t *row;
} own_rows;

static void
own_point(const void *data, size_t i, double out[3])
{
  const own_rows *of = data;

  sg_view_point(of->vertices, of->row[i], out);
}

static void
box_task(void *data, size_t i)
{
  box_job *job = data;
  const sg_segment_rows *rows = &job->rows;
  own_rows of = {job->vertices, rows->row + rows->begin[i]};
  size_t n = rows->begin[i + 1] - rows->begin[i];

  if (job->box) {
    job->box[i] = box_round(job->vertices, of.row, n);
  } else if (n > 0) {
    sg_oriented_box_make(n, own_point, &of, &job->oriented[i]);
  }
}

static bool
find_boxes(box_job *job, const int32_t *wanted, size_t n, sg_pool *pool,
           const sg_cancel *cancel)
{
  bool good =
      sg_segment_rows_find(job->vertices, wanted, n, cancel, &job->rows);

  good = good && sg_pool_run(rows_of(&job->rows, n) < SMALL ? NULL : pool, n,
                             box_task, job, cancel);
  sg_segment_rows_clear(&job->rows);
  return good;
}

bool
sg_leaf_boxes(const sg_view *vertices, const int32_t *wanted, size_t n,
              sg_pool *pool, const sg_cancel *cancel, sg_box *out)
{
  return find_boxes(&(box_job){.vertices = vertices, .box = out}, wanted, n,
                    pool, cancel);
}

bool
sg_leaf_oriented_boxes(const sg_view *vertices, const int32_t *wanted, size_t n,
                       sg_pool *pool, const sg_cancel *cancel,
                       sg_oriented_box *out)
{
  return find_boxes(&(box_job){.vertices = vertices, .oriented = out}, wanted,
                    n, pool, cancel);
}
