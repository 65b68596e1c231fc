/* operand.c -- see operand.h. */
#include "operand.h"

#include "rows/edge_print.h"

#include "number/exact.h"
#include "rows/edge_pairs.h"
#include "rows/sort.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  EDGE_PAGES = 16, /* of e/5 in a task */
  FACE_PAGES = 2   /* of t/6 in a task */
};

/* Whether a page (null: there is none) may have rows of a segment: a loop that
 * takes many at once. */
static bool
is_in_page(const int32_t *s, int32_t wanted)
{
  unsigned found = 0;

  if (!s) {
    return false;
  }
  for (unsigned i = 0; i < SG_PAGE_ROWS; i++) {
    found |= s[i] == wanted;
  }
  return found != 0;
}

/* Whether all rows of a page live and are of one segment. */
static bool
is_whole_page(const int32_t *s, const uint64_t *live, int32_t wanted)
{
  uint64_t all = UINT64_MAX;
  int32_t differ = 0;

  for (unsigned w = 0; w < SG_LIVE_WORDS; w++) {
    all &= live[w];
  }
  for (unsigned i = 0; i < SG_PAGE_ROWS && all == UINT64_MAX; i++) {
    differ |= s[i] ^ wanted;
  }
  return all == UINT64_MAX && differ == 0;
}

/* ---- balance: a fingerprint ---------------------------------------------- */

/* What one task has found. */
typedef struct edge_sum {
  uint64_t sum;
  size_t n;
} edge_sum;

typedef struct balance {
  const sg_view *e;
  int32_t s;
  edge_sum *sum; /* [tasks] */
} balance;

/* The edges of a page. */
static void
sum_page(const balance *b, size_t page, edge_sum *sum)
{
  const sg_view *e = b->e;
  const int32_t *s = e->column[0].page[page].i;
  const int32_t *from = e->column[2].page[page].i;
  const int32_t *to = e->column[3].page[page].i;
  const uint64_t *live = e->live[page];

  if (!is_in_page(s, b->s)) {
    return;
  }
  if (is_whole_page(s, live, b->s)) {
    for (unsigned r = 0; r < SG_PAGE_ROWS; r++) {
      sum->sum += sg_edge_print((uint32_t)from[r], (uint32_t)to[r]);
    }
    sum->n += SG_PAGE_ROWS;
    return;
  }
  for (unsigned r = sg_live_next(live, 0); r < SG_PAGE_ROWS;
       r = sg_live_next(live, r + 1)) {
    if (s[r] == b->s) {
      sum->sum += sg_edge_print((uint32_t)from[r], (uint32_t)to[r]);
      sum->n++;
    }
  }
}

static void
sum_edges(void *data, size_t task)
{
  balance *b = data;
  edge_sum sum = {0};
  size_t end = (task + 1) * EDGE_PAGES;

  for (size_t i = task * EDGE_PAGES; i < end && i < b->e->pages; i++) {
    sum_page(b, i, &sum);
  }
  b->sum[task] = sum;
}

static bool
see_edges(const sg_view *e, int32_t s, sg_pool *pool, const sg_cancel *cancel,
          sg_operand *out)
{
  size_t tasks = (e->pages + EDGE_PAGES - 1) / EDGE_PAGES;
  balance b = {e, s, calloc(tasks + 1, sizeof *b.sum)};
  uint64_t sum = 0;
  bool done = b.sum && sg_pool_run(pool, tasks, sum_edges, &b, cancel);

  for (size_t i = 0; i < tasks && done; i++) {
    sum += b.sum[i].sum;
    out->half_edges += b.sum[i].n;
  }
  out->balanced = sum == 0;
  free(b.sum);
  return done;
}

/* ---- triangles, seen from the middle ------------------------------------- */

typedef struct triangle_sum {
  double volume, error; /* six times */
  bool outward;
  int hits; /* triangles before the ray; below zero: not plain */
} triangle_sum;

typedef struct faces {
  const sg_leaf_tree *tree;
  const sg_leaf_views *views;
  double (*point)[3]; /* by place, from the middle */
  triangle_sum *sum;  /* [tasks] */
} faces;

/* Along no axis and no diagonal. */
static const double ray[3] = {0.61803398874, 0.28319530717, 0.73315};

/* The determinant of three rows and the most that rounding can have changed
 * it, the rows themselves being differences of doubles. */
static double
determinant(const double a[3], const double b[3], const double c[3],
            double *error)
{
  double sum = 0, size = 0;

  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;
    double p = b[i] * c[j], q = b[j] * c[i];

    sum += a[k] * (p - q);
    size += fabs(a[k]) * (fabs(p) + fabs(q));
  }
  *error = 16 * DBL_EPSILON * size + DBL_MIN;
  return sum;
}

/* Whether a triangle is on one side of one of two planes through the ray: then
 * it is not before it. The planes' normals are at right angles to the ray
 * exactly. */
static bool
is_beside(const double d[3], const double at[3][3])
{
  for (int k = 0; k < 2; k++) {
    int above = 0, below = 0;

    for (int i = 0; i < 3; i++) {
      double p = d[k + 1] * at[i][k], q = d[k] * at[i][k + 1];
      double error = 8 * DBL_EPSILON * (fabs(p) + fabs(q)) + DBL_MIN;

      above += p - q > error;
      below += q - p > error;
    }
    if (above == 3 || below == 3) {
      return true;
    }
  }
  return false;
}

/* Whether the ray leaves through a triangle that looks outward: 1, 0, or -1:
 * not plain. */
static int
is_hit(const double d[3], const double at[3][3])
{
  bool plain = true;

  if (is_beside(d, at)) {
    return 0;
  }
  for (int i = 0; i < 3; i++) {
    double error, side = determinant(d, at[i], at[(i + 1) % 3], &error);

    if (side < -error) {
      return 0;
    }
    plain = plain && side > error;
  }
  return plain ? 1 : -1;
}

static void
see_triangle(const faces *f, uint32_t row, triangle_sum *sum)
{
  double at[3][3] = {0}, error;

  for (unsigned i = 0; i < 3; i++) {
    size_t place = sg_id_rows_place(&f->tree->vertex,
                                    sg_view_int(&f->views->t, 3 + i, row));

    if (place != SG_NO_ID_PLACE) {
      memcpy(at[i], f->point[place], sizeof at[i]);
    }
  }
  double six = determinant(at[0], at[1], at[2], &error);

  sum->volume += six;
  sum->error += error + DBL_EPSILON * fabs(sum->volume);
  sum->outward = sum->outward && six > error;
  if (sum->outward && sum->hits >= 0) {
    int hit = is_hit(ray, (const double(*)[3])at);

    sum->hits = hit < 0 ? -1 : sum->hits + hit;
  }
}

/* The triangles of some pages, in the order of rows. */
static void
see_pages(void *data, size_t task)
{
  faces *f = data;
  const sg_view *t = &f->views->t;
  triangle_sum sum = {.outward = true};
  size_t first = f->tree->begin / SG_PAGE_ROWS + task * FACE_PAGES;

  for (size_t i = first; i < first + FACE_PAGES && i < t->pages; i++) {
    const int32_t *s = t->column[0].page[i].i;

    for (unsigned r = is_in_page(s, f->tree->s) ? sg_live_next(t->live[i], 0)
                                                : SG_PAGE_ROWS;
         r < SG_PAGE_ROWS; r = sg_live_next(t->live[i], r + 1)) {
      if (s[r] == f->tree->s) {
        see_triangle(f, (uint32_t)(i * SG_PAGE_ROWS + r), &sum);
      }
    }
  }
  f->sum[task] = sum;
}

/* One triangle before the ray, and all look outward: one before any ray. */
static bool
is_star(const faces *f, size_t tasks)
{
  int hits = 0;

  for (size_t i = 0; i < tasks; i++) {
    if (!f->sum[i].outward || f->sum[i].hits < 0) {
      return false;
    }
    hits += f->sum[i].hits;
  }
  return hits == 1;
}

static bool
see_faces(const sg_leaf_tree *tree, const sg_leaf_views *views, sg_pool *pool,
          const sg_cancel *cancel, sg_operand *out)
{
  size_t pages =
      (tree->end - 1) / SG_PAGE_ROWS - tree->begin / SG_PAGE_ROWS + 1;
  size_t tasks = (pages + FACE_PAGES - 1) / FACE_PAGES;
  double middle[3];

  for (int k = 0; k < 3; k++) {
    middle[k] = tree->box.lo[k] / 2 + tree->box.hi[k] / 2;
  }
  faces f = {.tree = tree,
             .views = views,
             .point = sg_leaf_points(tree, views, middle, pool, cancel),
             .sum = calloc(tasks + 1, sizeof *f.sum)};
  bool done =
      f.point && f.sum && sg_pool_run(pool, tasks, see_pages, &f, cancel);

  for (size_t i = 0; i < tasks && done; i++) {
    out->volume += f.sum[i].volume / 6;
    out->error += f.sum[i].error / 6 + DBL_EPSILON * fabs(out->volume);
  }
  out->star = done && out->balanced && is_star(&f, tasks);
  free(f.point);
  free(f.sum);
  return done;
}

bool
sg_operand_see(const sg_leaf_tree *tree, const sg_leaf_views *views,
               sg_pool *pool, const sg_cancel *cancel, sg_operand *out)
{
  *out = (sg_operand){.triangles = tree->curve ? 0 : tree->boxes->n};
  return see_edges(&views->e, tree->s, pool, cancel, out) &&
         (out->triangles == 0 || see_faces(tree, views, pool, cancel, out));
}

/* ---- which edges ----------------------------------------------------------
 */

typedef struct half_edges {
  size_t n;
  int32_t *from, *to; /* [n]: places among the vertices */
  int32_t *vertex;    /* [vertices], ascending */
  size_t vertices;
} half_edges;

/* Reads the edges of one segment by the places of their vertices. */
static bool
read_edges(const sg_view *e, int32_t s, const sg_cancel *cancel, half_edges *h)
{
  sg_segment_rows rows;
  bool done = sg_segment_rows_find(e, &s, 1, cancel, &rows);
  size_t n = done ? rows.begin[1] : 0;

  h->n = n;
  h->from = malloc((n + 1) * sizeof *h->from);
  h->to = malloc((n + 1) * sizeof *h->to);
  h->vertex = malloc((2 * n + 1) * sizeof *h->vertex);
  done = done && h->from && h->to && h->vertex;
  for (size_t i = 0; i < n && done; i++) {
    h->vertex[2 * i] = h->from[i] = sg_view_int(e, 2, rows.row[i]);
    h->vertex[2 * i + 1] = h->to[i] = sg_view_int(e, 3, rows.row[i]);
  }
  h->vertices = done ? sg_sort_ids(h->vertex, 2 * n) : 0;
  for (size_t i = 0; i < n && done; i++) {
    h->from[i] = (int32_t)sg_find_id(h->vertex, h->vertices, h->from[i]);
    h->to[i] = (int32_t)sg_find_id(h->vertex, h->vertices, h->to[i]);
  }
  sg_segment_rows_clear(&rows);
  return done;
}

static void
note_group(const half_edges *h, const sg_edge_group *group, size_t most,
           sg_operand_edges *out)
{
  size_t n = group->end - group->begin, backward = n - group->forward;

  if (n == 1) {
    out->open++;
  } else if (group->forward != backward) {
    out->unbalanced++;
  } else {
    out->crowded += n > 2;
    return;
  }
  if (out->firsts < most) {
    out->first[out->firsts++] =
        (sg_operand_edge){{h->vertex[group->low], h->vertex[group->high]},
                          group->forward,
                          backward};
  }
}

bool
sg_operand_edges_find(const sg_leaf_views *views, int32_t s, size_t most,
                      const sg_cancel *cancel, sg_operand_edges *out)
{
  half_edges h = {0};
  sg_edge_pairs pairs = {0};
  sg_edge_group group = {0};
  bool stopped;

  *out = (sg_operand_edges){.first = malloc((most + 1) * sizeof *out->first)};
  bool done = out->first && read_edges(&views->e, s, cancel, &h) &&
              sg_edge_pairs_make(h.n, h.from, h.to, h.vertices, cancel, &pairs,
                                 &stopped);

  while (done && sg_edge_group_next(&pairs, &group)) {
    note_group(&h, &group, most, out);
  }
  sg_edge_pairs_clear(&pairs);
  free(h.from);
  free(h.to);
  free(h.vertex);
  return done;
}
