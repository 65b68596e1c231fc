/* arrangement_part.c -- connected components: see arrangement.h.
 *
 * Layer: kernel. A vertex that is on no other leaf is on one side of each of
 * them, and so is everything that has it. Beside that, cells are connected
 * over edges that are no lines.
 */
#include "arrangement_private.h"
#include "engine/list.h"
#include "engine/search.h"

#include <stdlib.h>
#include <string.h>

enum {
  ASKED = 1 << 14, /* rows between questions */
  PAGES = 16       /* of a task */
};

/* ---- which rows are there ---- */

SG_ORDER(compare_cells, sg_cell, SG_BY(leaf) SG_BY(p) SG_BY(first));

/* The polygons that are cut, for each leaf. */
static bool
list_cut(sg_arrangement *a)
{
  int32_t *p = malloc((a->cells + 1) * sizeof *p);
  bool good = p != NULL;

  if (a->cells > 0) {
    qsort(a->cell, a->cells, sizeof *a->cell, compare_cells);
  }
  for (size_t i = 0, c = 0; i < a->leaves.n && good; i++) {
    size_t n = 0;

    a->leaf[i].first_cell = c;
    for (; c < a->cells && a->cell[c].leaf == i; c++) {
      p[n++] = a->cell[c].p;
    }
    a->leaf[i].cells = n;
    good = sg_id_set_make(&a->leaf[i].cut, p, n);
  }
  free(p);
  return good;
}

/* The rows of the wanted leaves. */
static bool
find_rows(sg_arrangement *a, const sg_cancel *cancel)
{
  int32_t *s = malloc((a->leaves.n + 1) * sizeof *s);
  size_t n = 0;

  for (size_t i = 0; s && i < a->leaves.n; i++) {
    if (a->leaf[i].wanted) {
      s[n++] = a->leaf[i].s;
    }
  }
  bool good =
      s && sg_segment_rows_find(&a->leaves.views->t, s, n, cancel, &a->rows);

  free(s);
  for (size_t i = 0, k = 0; i < a->leaves.n && good; i++) {
    sg_arranged *leaf = &a->leaf[i];

    if (!leaf->wanted) {
      continue;
    }
    leaf->row = a->rows.row + a->rows.begin[k];
    leaf->rows = a->rows.begin[k + 1] - a->rows.begin[k];
    leaf->component = malloc((leaf->rows + 1) * sizeof *leaf->component);
    good = leaf->component != NULL;
    k++;
  }
  return good;
}

/* ---- auxiliary edges ---- */

static bool
note_auxiliary(sg_arrangement *a, const sg_view *e, size_t page, unsigned r)
{
  uint32_t leaf = sg_arrangement_leaf(a, e->column[0].page[page].i[r]);
  int32_t v1 = e->column[2].page[page].i[r];
  int32_t v2 = e->column[3].page[page].i[r];
  uint32_t key[3] = {leaf, (uint32_t)v1, (uint32_t)v2};

  if (leaf == SG_NO_KEY || !a->leaf[leaf].wanted ||
      sg_arrangement_is_line(a, leaf, v1, v2)) {
    return true;
  }
  return sg_key_table_add(&a->auxiliary, key);
}

/* Whether a page has an auxiliary edge; a full one is looked at as a whole. */
static bool
has_auxiliary(const uint64_t *live, const int32_t *et)
{
  uint64_t all = UINT64_MAX;
  unsigned found = 0;

  for (unsigned w = 0; w < SG_LIVE_WORDS; w++) {
    all &= live[w];
  }
  if (all != UINT64_MAX) {
    return true;
  }
  for (unsigned i = 0; i < SG_PAGE_ROWS; i++) {
    found |= et[i] == 0;
  }
  return found != 0;
}

typedef struct auxiliary_pages {
  const sg_view *e;
  bool *has; /* [pages] */
} auxiliary_pages;

/* A task is a few pages. */
static void
look_for_auxiliary(void *data, size_t task)
{
  const auxiliary_pages *pages = data;
  const sg_view *e = pages->e;

  for (size_t i = task * PAGES; i < (task + 1) * PAGES && i < e->pages; i++) {
    pages->has[i] = has_auxiliary(e->live[i], e->column[4].page[i].i);
  }
}

static bool
note_auxiliary_of(sg_arrangement *a, const sg_view *e, size_t page)
{
  const int32_t *et = e->column[4].page[page].i;

  for (unsigned r = sg_live_next(e->live[page], 0); r < SG_PAGE_ROWS;
       r = sg_live_next(e->live[page], r + 1)) {
    if (et[r] == 0 && !note_auxiliary(a, e, page, r)) {
      return false;
    }
  }
  return true;
}

bool
sg_arrangement_find_auxiliary(sg_arrangement *a, sg_pool *pool,
                              const sg_cancel *cancel)
{
  const sg_view *e = &a->leaves.views->e;
  auxiliary_pages pages = {e, calloc(e->pages + 1, sizeof *pages.has)};
  bool good = pages.has && sg_pool_run(pool, (e->pages + PAGES - 1) / PAGES,
                                       look_for_auxiliary, &pages, cancel);

  for (size_t i = 0; i < e->pages && good; i++) {
    good =
        !pages.has[i] || (note_auxiliary_of(a, e, i) && !sg_cancelled(cancel));
  }
  free(pages.has);
  return good;
}

/* ---- polygons that are not cut ---- */

static bool
keep_cut_row(sg_arrangement *a, uint32_t leaf, int32_t p, uint32_t row)
{
  if (!sg_list_grow(&a->cut_row, a->cut_rows, &a->cut_row_room,
                    sizeof *a->cut_row)) {
    return false;
  }
  a->cut_row[a->cut_rows++] = (sg_cut_row_of){leaf, p, row};
  return true;
}

/* Joins `node` (SG_NO_KEY: none yet) with what has the key. False: no memory.
 */
static bool
join_by_key(sg_arrangement *a, sg_key_table *of_polygon, const uint32_t key[4],
            uint32_t *node)
{
  uint32_t *other = sg_key_table_put(of_polygon, key);

  if (!other) {
    return false;
  }
  if (*other == SG_NO_KEY) {
    *node = *node == SG_NO_KEY ? sg_arrangement_new_node(a) : *node;
    *other = *node;
  } else if (*node == SG_NO_KEY) {
    *node = *other;
  } else {
    sg_arrangement_hang(a, *node, *other);
  }
  return *node != SG_NO_KEY;
}

/* The node of a triangle with a touched vertex: that of its polygon, or where
 * edges of more than two triangles may run through that, of what is on its side
 * of them. */
static uint32_t
polygon_node(sg_arrangement *a, sg_key_table *of_polygon, uint32_t leaf,
             int32_t p, const int32_t v[3])
{
  uint32_t key[4] = {leaf, (uint32_t)p, 0, 0}, node = SG_NO_KEY;

  if (a->leaves.nonmanifold[leaf]->edges == 0) {
    return join_by_key(a, of_polygon, key, &node) ? node : SG_NO_KEY;
  }
  for (int c = 0; c < 3; c++) {
    int32_t v1 = v[c], v2 = v[(c + 1) % 3];

    key[2] = (uint32_t)(v1 < v2 ? v1 : v2);
    key[3] = (uint32_t)(v1 < v2 ? v2 : v1);
    if (!sg_arrangement_is_line(a, leaf, v1, v2) &&
        !join_by_key(a, of_polygon, key, &node)) {
      return SG_NO_KEY;
    }
  }
  return node != SG_NO_KEY ? node : sg_arrangement_new_node(a);
}

/* Hangs a triangle's free vertices together, and if it has another one, what is
 * left of its polygon. Its node goes to *out; false: no memory. */
static bool
hang_triangle(sg_arrangement *a, sg_key_table *of_polygon, uint32_t leaf,
              uint32_t row, uint32_t *out)
{
  uint32_t first = SG_NO_KEY;
  int32_t v[3], p = sg_arranged_polygon(a, row);
  int vertices = 0;

  sg_arranged_corners(a, row, v);
  for (int c = 0; c < 3; c++) {
    uint32_t node = sg_arrangement_node(&a->leaf[leaf], v[c]);

    if (node == SG_NO_KEY || a->touched[node]) {
      continue;
    }
    vertices++;
    if (first == SG_NO_KEY) {
      first = node;
    } else if (a->parent[first] != a->parent[node]) {
      sg_arrangement_hang(a, first, node);
    }
  }
  if (vertices < 3) {
    uint32_t node = polygon_node(a, of_polygon, leaf, p, v);

    if (node == SG_NO_KEY) {
      return false;
    }
    if (first == SG_NO_KEY) {
      first = node;
    } else {
      sg_arrangement_hang(a, first, node);
    }
  }
  *out = first;
  return true;
}

/* Hangs free vertices of triangles that have no others together, leaf by leaf:
 * nodes of one leaf never meet those of another, so leaves are tasks. What is
 * left is LATE. leaf->component is a node at first. */
static const uint32_t LATE = SG_NO_KEY - 1;

/* The nodes of a triangle; false: not all of its vertices are free. */
static bool
free_nodes(const sg_arrangement *a, const sg_arranged *leaf, uint32_t row,
           uint32_t node[3])
{
  int32_t v[3];

  sg_arranged_corners(a, row, v);
  for (int c = 0; c < 3; c++) {
    node[c] = sg_arrangement_node(leaf, v[c]);
    if (node[c] == SG_NO_KEY || a->touched[node[c]]) {
      return false;
    }
  }
  return true;
}

static void
flood_free(void *data, size_t number)
{
  sg_arrangement *a = data;
  sg_arranged *leaf = &a->leaf[number];

  for (size_t i = 0; i < leaf->rows; i++) {
    uint32_t row = leaf->row[i], node[3];

    if (i % ASKED == ASKED - 1 && sg_pool_stopping()) {
      return;
    }
    if (sg_id_set_has(&leaf->cut, sg_arranged_polygon(a, row)) ||
        !free_nodes(a, leaf, row, node)) {
      leaf->component[i] = LATE;
      continue;
    }
    leaf->component[i] = node[0];
    for (int c = 1; c < 3; c++) {
      if (a->parent[node[0]] != a->parent[node[c]]) {
        sg_arrangement_hang(a, node[0], node[c]);
      }
    }
  }
}

static bool
flood_late(sg_arrangement *a, uint32_t number, sg_key_table *of_polygon,
           const sg_cancel *cancel)
{
  sg_arranged *leaf = &a->leaf[number];

  for (size_t i = 0; i < leaf->rows; i++) {
    if (i % ASKED == ASKED - 1 && sg_cancelled(cancel)) {
      return false;
    }
    if (leaf->component[i] != LATE) {
      continue;
    }
    uint32_t row = leaf->row[i];
    int32_t p = sg_arranged_polygon(a, row);

    if (sg_id_set_has(&leaf->cut, p)) {
      leaf->component[i] = SG_NO_KEY;
      if (!keep_cut_row(a, number, p, row)) {
        return false;
      }
    } else if (!hang_triangle(a, of_polygon, number, row,
                              &leaf->component[i])) {
      return false;
    }
  }
  return true;
}

/* ---- cells ---- */

static bool
hang_cell(sg_arrangement *a, sg_key_table *over, const sg_cell *cell)
{
  for (size_t i = cell->first; i < cell->first + cell->n; i++) {
    const sg_cell_triangle *t = &a->triangle[i];

    for (int c = 0; c < 3; c++) {
      int32_t v1 = t->v[c], v2 = t->v[(c + 1) % 3];
      uint32_t node = sg_arrangement_node(&a->leaf[cell->leaf], v1);
      uint32_t key[3] = {cell->leaf, (uint32_t)(v1 < v2 ? v1 : v2),
                         (uint32_t)(v1 < v2 ? v2 : v1)};

      if (node != SG_NO_KEY && !a->touched[node]) {
        sg_arrangement_hang(a, cell->node, node);
      }
      /* A chord is inside its cell, even if cells that lie on each other have
       * the same one. */
      if ((t->chord & 1 << c) ||
          sg_arrangement_is_line(a, cell->leaf, v1, v2)) {
        continue;
      }
      uint32_t *other = sg_key_table_put(over, key);

      if (!other) {
        return false;
      }
      if (*other == SG_NO_KEY) {
        *other = cell->node;
      } else {
        sg_arrangement_hang(a, cell->node, *other);
      }
    }
  }
  return true;
}

SG_ORDER(compare_cut_rows, sg_cut_row_of, SG_BY(leaf) SG_BY(p) SG_BY(row));

bool
sg_arrangement_flood(sg_arrangement *a, sg_pool *pool, const sg_cancel *cancel)
{
  sg_key_table of_polygon, over;
  bool good = list_cut(a) && find_rows(a, cancel) &&
              sg_pool_run(pool, a->leaves.n, flood_free, a, cancel);

  sg_key_table_init(&of_polygon, 4);
  sg_key_table_init(&over, 3);
  for (uint32_t i = 0; i < a->leaves.n && good; i++) {
    good = flood_late(a, i, &of_polygon, cancel);
  }
  for (size_t i = 0; i < a->cells && good; i++) {
    good = hang_cell(a, &over, &a->cell[i]);
  }
  if (a->cut_rows > 0) {
    qsort(a->cut_row, a->cut_rows, sizeof *a->cut_row, compare_cut_rows);
  }
  sg_key_table_clear(&of_polygon);
  sg_key_table_clear(&over);
  return good;
}

/* ---- components ---- */

/* Nothing of one leaf is connected with anything of another: leaves are
 * tasks, and their components come one leaf after another. */
typedef struct finding {
  sg_arrangement *a;
  uint32_t *of_root; /* [nodes]: the component of a root, in its leaf */
  struct found {
    sg_part *part; /* [parts] */
    size_t parts, room;
    bool failed;
  } * found; /* [leaves] */
} finding;

static bool
new_part(struct found *to)
{
  if (!sg_list_grow(&to->part, to->parts, &to->room, sizeof *to->part)) {
    return false;
  }
  to->part[to->parts++] = (sg_part){.unknown = true};
  return true;
}

/* The component of a piece with this node, new if it has none, gets a point
 * inside the piece if it has none. SG_NO_KEY: no memory. */
static uint32_t
part_of(const finding *f, struct found *to, uint32_t node, const sg_part *piece)
{
  uint32_t *number = &f->of_root[sg_arrangement_root(f->a, node)];

  if (*number == SG_NO_KEY) {
    if (!new_part(to)) {
      return SG_NO_KEY;
    }
    *number = (uint32_t)(to->parts - 1);
  }
  sg_part *part = &to->part[*number];

  if (part->unknown) {
    *part = *piece;
    if (!sg_arrangement_point(f->a, part)) {
      return SG_NO_KEY;
    }
  }
  return *number;
}

/* The component of a piece with this node, if it has a point; else SG_NO_KEY.
 * Mostly that is all there is to find. */
static uint32_t
known_part(const finding *f, const struct found *in, uint32_t node)
{
  uint32_t number = f->of_root[sg_arrangement_root(f->a, node)];

  return number != SG_NO_KEY && !in->part[number].unknown ? number : SG_NO_KEY;
}

static uint32_t
part_of_row(const finding *f, uint32_t number, size_t i, uint32_t node)
{
  sg_part piece = {.leaf = number, .of = i, .row = f->a->leaf[number].row[i]};

  return part_of(f, &f->found[number], node, &piece);
}

/* leaf->component becomes the component of what was its node. */
static bool
find_row_parts(const finding *f, uint32_t number)
{
  sg_arranged *leaf = &f->a->leaf[number];

  for (size_t i = 0; i < leaf->rows; i++) {
    uint32_t node = leaf->component[i], *c = &leaf->component[i];

    if (i % ASKED == ASKED - 1 && sg_pool_stopping()) {
      return false;
    }
    if (node != SG_NO_KEY &&
        (*c = known_part(f, &f->found[number], node)) == SG_NO_KEY &&
        (*c = part_of_row(f, number, i, node)) == SG_NO_KEY) {
      return false;
    }
  }
  return true;
}

static bool
find_cell_parts(const finding *f, uint32_t number)
{
  const sg_arranged *leaf = &f->a->leaf[number];

  for (size_t i = leaf->first_cell; i < leaf->first_cell + leaf->cells; i++) {
    sg_cell *cell = &f->a->cell[i];
    sg_part piece = {.leaf = number, .cut = true, .of = i};

    cell->component = part_of(f, &f->found[number], cell->node, &piece);
    if (cell->component == SG_NO_KEY) {
      return false;
    }
  }
  return true;
}

static void
find_leaf_parts(void *data, size_t number)
{
  const finding *f = data;

  f->found[number].failed = !find_row_parts(f, (uint32_t)number) ||
                            !find_cell_parts(f, (uint32_t)number);
}

/* The components of all leaves, as they are found. False: no memory; or
 * stopped. */
static bool
gather_parts(const finding *f)
{
  sg_arrangement *a = f->a;
  size_t parts = 0;

  for (size_t i = 0; i < a->leaves.n; i++) {
    if (f->found[i].failed) {
      return false;
    }
    a->leaf[i].first_part = parts;
    a->leaf[i].parts = f->found[i].parts;
    parts += f->found[i].parts;
  }
  if (!(a->part = malloc((parts + 1) * sizeof *a->part))) {
    return false;
  }
  for (size_t i = 0; i < a->leaves.n; i++) {
    if (f->found[i].parts > 0) {
      memcpy(a->part + a->parts, f->found[i].part,
             f->found[i].parts * sizeof *a->part);
    }
    a->parts += f->found[i].parts;
    f->found[i].parts = 0; /* its points are the arrangement's now */
  }
  return true;
}

static void
finding_clear(finding *f)
{
  for (size_t i = 0; f->found && i < f->a->leaves.n; i++) {
    for (size_t k = 0; k < f->found[i].parts; k++) {
      sg_point_clear(&f->found[i].part[k].at);
    }
    free(f->found[i].part);
  }
  free(f->found);
  free(f->of_root);
}

bool
sg_arrangement_find_parts(sg_arrangement *a, sg_pool *pool,
                          const sg_cancel *cancel)
{
  finding f = {.a = a,
               .of_root = malloc((a->nodes + 1) * sizeof *f.of_root),
               .found = calloc(a->leaves.n + 1, sizeof *f.found)};
  bool good = f.of_root && f.found;

  if (good) {
    memset(f.of_root, 0xff, (a->nodes + 1) * sizeof *f.of_root);
    good = sg_pool_run(pool, a->leaves.n, find_leaf_parts, &f, cancel) &&
           gather_parts(&f);
  }
  finding_clear(&f);
  return good;
}
