/* leaf_tree_test.c -- rows of segments, rows by id, and the trees of a small
 * world made by hand: rows of several segments mixed, some dead, ids with
 * gaps. */
#include "tests/check.h"

#include "join/leaf_tree.h"

#include <stdlib.h>
#include <string.h>

enum { PAGES = 12, ROWS = PAGES * SG_PAGE_ROWS, SEGMENTS = 5 };

static uint32_t
draw(uint32_t n)
{
  static uint64_t state = 21;

  state = state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(state >> 33) % n;
}

/* A relation as the store shows it. */
typedef struct relation {
  uint64_t live[PAGES][SG_LIVE_WORDS];
  int32_t i[SG_MAX_COLUMNS][ROWS];
  double f[SG_MAX_COLUMNS][ROWS];
  const uint64_t *live_at[PAGES];
  sg_cells cells[SG_MAX_COLUMNS][PAGES];
  sg_view view;
} relation;

/* Columns from `floats` on are doubles. */
static relation *
relation_new(unsigned floats)
{
  relation *r = calloc(1, sizeof *r);

  r->view.pages = PAGES;
  r->view.live = r->live_at;
  for (size_t p = 0; p < PAGES; p++) {
    r->live_at[p] = r->live[p];
    for (unsigned c = 0; c < SG_MAX_COLUMNS; c++) {
      if (c < floats) {
        r->cells[c][p].i = r->i[c] + p * SG_PAGE_ROWS;
      } else {
        r->cells[c][p].f = r->f[c] + p * SG_PAGE_ROWS;
      }
      r->view.column[c].page = r->cells[c];
    }
  }
  return r;
}

static bool
lives(const relation *r, uint32_t row)
{
  return r->live[row / SG_PAGE_ROWS][row % SG_PAGE_ROWS / 64] >> row % 64 & 1;
}

static void
make_live(relation *r, uint32_t row)
{
  r->live[row / SG_PAGE_ROWS][row % SG_PAGE_ROWS / 64] |= UINT64_C(1)
                                                          << row % 64;
}

typedef struct world {
  relation *v, *e, *t;
  sg_leaf_views views;
} world;

/* Which segment a row is in: long runs, then row by row. */
static int32_t
segment_of(uint32_t row)
{
  return 2 * (int32_t)(row < ROWS / 2 ? row / 5000 : row % 7) % 9 + 1;
}

/* Triangles between vertices of their segment; segment 9 has edges only, and
 * its ids are far apart. */
static world
make_world(void)
{
  world w = {.v = relation_new(2), .e = relation_new(9), .t = relation_new(9)};
  uint32_t last[10][3] = {{0}};
  int32_t next[10] = {0};

  for (uint32_t row = 0; row < ROWS; row++) {
    int32_t s = segment_of(row);

    next[s] += 1 + (int32_t)draw(2);
    int32_t id = s == 9 ? 1000 * (int32_t)row + 7 : next[s];

    if (draw(50) == 0) {
      continue;
    }
    w.v->i[0][row] = w.e->i[0][row] = w.t->i[0][row] = s;
    w.v->i[1][row] = w.e->i[1][row] = id;
    w.t->i[1][row] = w.t->i[2][row] = id;
    make_live(w.v, row);
    for (int c = 0; c < 3; c++) {
      w.v->f[2 + c][row] = draw(1000) / 8.0;
      w.t->i[3 + c][row] = (int32_t)last[s][c];
    }
    w.e->i[2][row] = (int32_t)last[s][0];
    w.e->i[3][row] = id;
    if (last[s][2]) {
      make_live(s == 9 ? w.e : w.t, row);
    }
    last[s][2] = last[s][1];
    last[s][1] = last[s][0];
    last[s][0] = (uint32_t)id;
  }
  w.views = (sg_leaf_views){w.v->view, w.e->view, w.t->view};
  return w;
}

static void
free_world(world *w)
{
  free(w->v);
  free(w->e);
  free(w->t);
}

static const int32_t wanted[SEGMENTS] = {1, 3, 6, 7, 9}; /* 6 is not there */

static bool
rows_are_right(const relation *r)
{
  sg_segment_rows rows;
  bool good = sg_segment_rows_find(&r->view, wanted, SEGMENTS, NULL, &rows);

  for (size_t i = 0; i < SEGMENTS && good; i++) {
    size_t k = rows.begin[i];

    for (uint32_t row = 0; row < ROWS && good; row++) {
      if (lives(r, row) && r->i[0][row] == wanted[i]) {
        good = k < rows.begin[i + 1] && rows.row[k++] == row;
      }
    }
    good = good && k == rows.begin[i + 1];
  }
  sg_segment_rows_clear(&rows);
  return good;
}

static bool
ids_are_right(const relation *r, int32_t s, bool sparse)
{
  sg_segment_rows rows;
  sg_id_rows table = {0};
  bool good = sg_segment_rows_find(&r->view, &s, 1, NULL, &rows) &&
              sg_id_rows_make(&r->view, rows.row, rows.begin[1], &table) &&
              (table.id != NULL) == sparse;

  for (uint32_t row = 0; row < ROWS && good; row++) {
    if (lives(r, row) && r->i[0][row] == s) {
      good = sg_id_rows_find(&table, r->i[1][row]) == row;
    }
  }
  good = good && sg_id_rows_find(&table, 0) == SG_NO_ID_ROW &&
         sg_id_rows_find(&table, INT32_MAX) == SG_NO_ID_ROW;
  sg_id_rows_clear(&table);
  sg_segment_rows_clear(&rows);
  return good;
}

/* Every leaf once, and its corners where the rows say. */
static bool
tree_is_right(const world *w, const sg_leaf_tree *tree)
{
  const relation *r = tree->curve ? w->e : w->t;
  unsigned char *seen = calloc(ROWS, 1);
  size_t n = 0;
  bool good = tree->curve == (tree->s == 9 || tree->s == 6);

  for (size_t k = 0; k < tree->boxes->n && good; k++) {
    uint32_t row = tree->boxes->item[k];
    sg_leaf leaf = sg_leaf_at(tree, &w->views, row);
    double p[3];

    good = lives(r, row) && r->i[0][row] == tree->s && !seen[row]++ &&
           leaf.id == r->i[tree->curve ? 1 : 2][row] &&
           sg_leaf_vertex_at(tree, &w->views, leaf.v[1], p) &&
           p[0] >= tree->box.lo[0] && p[0] <= tree->box.hi[0];
  }
  for (uint32_t row = 0; row < ROWS; row++) {
    n += lives(r, row) && r->i[0][row] == tree->s;
  }
  free(seen);
  return good && n == tree->boxes->n;
}

static bool
trees_are_right(const world *w)
{
  sg_leaf_tree *tree[SEGMENTS];
  bool good = sg_leaf_trees_grow(&w->views, wanted, SEGMENTS, NULL, NULL, tree);

  for (size_t i = 0; i < SEGMENTS && good; i++) {
    good = tree[i]->s == wanted[i] && tree_is_right(w, tree[i]);
  }
  for (size_t i = 0; i < SEGMENTS; i++) {
    sg_leaf_tree_close(tree[i]);
  }
  return good;
}

static bool
same_trees(const sg_leaf_tree *a, const sg_leaf_tree *b)
{
  size_t n = a->boxes->n;

  return n == b->boxes->n && (n == 0 || memcmp(a->boxes->item, b->boxes->item,
                                               n * sizeof(uint32_t)) == 0);
}

static bool
threads_agree(const world *w)
{
  sg_leaf_tree *first[SEGMENTS], *tree[SEGMENTS];
  bool good =
      sg_leaf_trees_grow(&w->views, wanted, SEGMENTS, NULL, NULL, first);

  for (unsigned threads = 2; threads <= 4; threads += 2) {
    sg_pool *pool = sg_pool_open(threads);

    good = good &&
           sg_leaf_trees_grow(&w->views, wanted, SEGMENTS, pool, NULL, tree);
    for (size_t i = 0; i < SEGMENTS && good; i++) {
      good = same_trees(first[i], tree[i]);
      sg_leaf_tree_close(tree[i]);
    }
    sg_pool_close(pool);
  }
  for (size_t i = 0; i < SEGMENTS; i++) {
    sg_leaf_tree_close(first[i]);
  }
  return good;
}

static bool
ask_stop(void *data)
{
  (void)data;
  return true;
}

static bool
stops(const world *w)
{
  sg_cancel cancel = {ask_stop, NULL};
  sg_leaf_tree *tree[SEGMENTS];

  return !sg_leaf_trees_grow(&w->views, wanted, SEGMENTS, NULL, &cancel,
                             tree) &&
         !tree[0] && !tree[SEGMENTS - 1];
}

int
main(void)
{
  world w = make_world();
  sg_leaf_tree *none[1];

  CHECK("rows of vertices", rows_are_right(w.v));
  CHECK("rows of triangles", rows_are_right(w.t));
  CHECK("ids close together", ids_are_right(w.v, 3, false));
  CHECK("ids far apart", ids_are_right(w.v, 9, true));
  CHECK("trees", trees_are_right(&w));
  CHECK("no segment",
        sg_leaf_trees_grow(&w.views, wanted, 0, NULL, NULL, none));
  CHECK("any number of threads", threads_agree(&w));
  CHECK("a poll stops it", stops(&w));
  free_world(&w);
  return check_report();
}
