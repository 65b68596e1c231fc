/* chain_rows.c -- chains of line/9, and of the pieces of a cut set.
 *
 * Layer: rows. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut_rows.h"

#include "chain.h"
#include "doors/penetration.h"
#include "engine/search.h"

#include <stdlib.h>
#include <string.h>

static int
kind_of(const sg_chain *chain)
{
  return chain->point    ? SG_CHAIN_KIND_POINT
         : chain->closed ? SG_CHAIN_KIND_CLOSED
                         : SG_CHAIN_KIND_OPEN;
}

/* ---- the lines of a world ---- */

/* What is needed of a row of line/9. */
typedef struct line_row {
  int32_t s[2], l;
  sg_chain_vertex a, b;
} line_row;

SG_ORDER(compare_rows, line_row, SG_BY(s[0]) SG_BY(s[1]) SG_BY(l));

/* All rows, by segments and number; null: an exception. free() it. */
static line_row *
read_rows(sg_call *call, const sg_version *version, size_t *n)
{
  size_t room = sg_version_count(version, SG_LINE);
  line_row *row = malloc((room + 1) * sizeof *row);
  sg_view view;

  *n = 0;
  if (!row || !sg_version_view(version, SG_LINE, &view)) {
    free(row);
    sg_call_no_memory(call);
    return NULL;
  }
  for (size_t page = 0; page < view.pages; page++) {
    const uint64_t *live = view.live[page];

    for (unsigned i = sg_live_next(live, 0); i < SG_PAGE_ROWS && *n < room;
         i = sg_live_next(live, i + 1)) {
      const sg_column *c = view.column;

      row[(*n)++] = (line_row){
          {c[1].page[page].i[i], c[5].page[page].i[i]},
          c[0].page[page].i[i],
          {{(uint32_t)c[3].page[page].i[i], (uint32_t)c[7].page[page].i[i]}},
          {{(uint32_t)c[4].page[page].i[i], (uint32_t)c[8].page[page].i[i]}},
      };
    }
  }
  sg_view_clear(&view);
  qsort(row, *n, sizeof *row, compare_rows);
  return row;
}

/* The rows as lines of a graph, a group for each pair of segments. */
static sg_chain_line *
lines_of_rows(const line_row *row, size_t n)
{
  sg_chain_line *line = malloc((n + 1) * sizeof *line);
  uint32_t group = 0;

  for (size_t i = 0; line && i < n; i++) {
    group += i > 0 && memcmp(row[i].s, row[i - 1].s, sizeof row[i].s) != 0;
    line[i] = (sg_chain_line){group, row[i].a, row[i].b};
  }
  return line;
}

static bool
add_row_chain(sg_call *call, const line_row *row, const sg_chains *chains,
              const sg_chain *chain, sg_line_chain_list *out)
{
  const int32_t *step = &chains->step[chain->first];
  const int32_t *s = row[abs(step[0]) - 1].s;
  sg_line_chain one = {.s1 = s[0], .s2 = s[1], .kind = kind_of(chain)};

  for (size_t i = 0; i < chain->n; i++) {
    int32_t l = row[abs(step[i]) - 1].l;

    if (!sg_int_list_add(call, &one.lines, step[i] > 0 ? l : -l)) {
      return false;
    }
  }
  return sg_line_chain_list_add(call, out, one);
}

bool
sg_door_line_chains(sg_call *call, sg_line_chain_list *out)
{
  const sg_version *version = sg_call_version(call);
  size_t n = 0;
  line_row *row = version ? read_rows(call, version, &n) : NULL;

  if (!row) {
    return false;
  }
  sg_chain_line *line = lines_of_rows(row, n);
  sg_chains chains = {0};
  bool good =
      (line && sg_chains_make(line, n, &chains)) || sg_call_no_memory(call);

  for (size_t i = 0; good && i < chains.n; i++) {
    good = add_row_chain(call, row, &chains, &chains.item[i], out);
  }
  sg_chains_clear(&chains);
  free(line);
  free(row);
  return good;
}

/* ---- the pieces of a cut set ---- */

/* The live pieces by segments and number, contacts after them, as pieces from
 * a point to itself; and the graph of them. */
typedef struct piece_graph {
  const sg_cut_points *points;
  sg_cut_piece *contact;
  const sg_cut_piece **piece; /* [n] */
  sg_chain_line *line;        /* [n] */
  size_t n;
} piece_graph;

static int
compare_pieces(const void *x, const void *y)
{
  const sg_cut_piece *p = *(const sg_cut_piece *const *)x;
  const sg_cut_piece *q = *(const sg_cut_piece *const *)y;

  for (int k = 0; k < 2; k++) {
    if (p->s[k] != q->s[k]) {
      return p->s[k] < q->s[k] ? -1 : 1;
    }
  }
  if ((p->a == p->b) != (q->a == q->b)) {
    return p->a == p->b ? 1 : -1;
  }
  return (p > q) - (p < q);
}

static void
graph_clear(piece_graph *g)
{
  free(g->contact);
  free(g->piece);
  free(g->line);
}

static bool
graph_init(piece_graph *g, const sg_cut_set *set)
{
  size_t room = set->pieces + set->contacts + 1;
  uint32_t group = 0;

  *g = (piece_graph){
      &set->points, malloc((set->contacts + 1) * sizeof *g->contact),
      malloc(room * sizeof *g->piece), malloc(room * sizeof *g->line), 0};
  if (!g->contact || !g->piece || !g->line) {
    return false;
  }
  for (size_t i = 0; i < set->pieces; i++) {
    if (set->piece[i].live) {
      g->piece[g->n++] = &set->piece[i];
    }
  }
  for (size_t i = 0; i < set->contacts; i++) {
    const sg_cut_contact *k = &set->contact[i];

    g->contact[i] = (sg_cut_piece){.s = {k->s[0], k->s[1]},
                                   .p = {k->p[0], k->p[1]},
                                   .a = k->point,
                                   .b = k->point};
    g->piece[g->n++] = &g->contact[i];
  }
  qsort(g->piece, g->n, sizeof *g->piece, compare_pieces);
  for (size_t i = 0; i < g->n; i++) {
    const sg_cut_piece *k = g->piece[i];

    group += i > 0 && memcmp(k->s, g->piece[i - 1]->s, sizeof k->s) != 0;
    g->line[i] = (sg_chain_line){group, {{k->a, 0}}, {{k->b, 0}}};
  }
  return true;
}

/* The point in which a step starts. */
static uint32_t
step_start(const piece_graph *g, int32_t step)
{
  const sg_cut_piece *k = g->piece[abs(step) - 1];

  return step > 0 ? k->a : k->b;
}

static bool
add_point(sg_call *call, const sg_cut_points *points, uint32_t point,
          sg_chain_point_list *out)
{
  const double *at = points->point[point].at.p;
  const sg_chain_point one = {at[0], at[1], at[2],
                              sg_cut_origin(call, points, point)};

  return one.origin && sg_chain_point_list_add(call, out, one);
}

/* One P1-P2 less than points; of a point alone one of each. */
static bool
add_piece_chain(sg_call *call, const piece_graph *g, const sg_chains *chains,
                const sg_chain *chain, sg_piece_chain_list *out)
{
  const int32_t *step = &chains->step[chain->first];
  const int32_t *s = g->piece[abs(step[0]) - 1]->s;
  sg_piece_chain one = {.s1 = s[0], .s2 = s[1], .kind = kind_of(chain)};

  for (size_t i = 0; i < chain->n; i++) {
    const int32_t *p = g->piece[abs(step[i]) - 1]->p;

    if (!add_point(call, g->points, step_start(g, step[i]), &one.points) ||
        !sg_id_pair_list_add(call, &one.polygons, (sg_id_pair){p[0], p[1]})) {
      return false;
    }
  }
  return (chain->point ||
          add_point(call, g->points, step_start(g, -step[chain->n - 1]),
                    &one.points)) &&
         sg_piece_chain_list_add(call, out, one);
}

bool
sg_door_cut_chains(sg_call *call, sg_cut_handle *handle,
                   sg_piece_chain_list *out)
{
  piece_graph g;
  sg_chains chains = {0};
  bool good =
      (graph_init(&g, &handle->set) && sg_chains_make(g.line, g.n, &chains)) ||
      sg_call_no_memory(call);

  for (size_t i = 0; good && i < chains.n; i++) {
    good = add_piece_chain(call, &g, &chains, &chains.item[i], out);
  }
  sg_chains_clear(&chains);
  graph_clear(&g);
  return good;
}
