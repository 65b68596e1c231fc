/* chain4pl.c -- chains of line/9, and of the pieces of a cut set.
 *
 * Layer: glue. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut4pl.h"

#include "chain.h"
#include "glue.h"

#include "engine/install.h"

#include <stdlib.h>
#include <string.h>

static functor_t functor_chain4, functor_chain5, functor_point4, functor_minus2;
static atom_t atom_open, atom_closed, atom_point;

static bool
put_kind(term_t t, const sg_chain *chain)
{
  return PL_put_atom(t, chain->point    ? atom_point
                        : chain->closed ? atom_closed
                                        : atom_open);
}

/* ---- the lines of a world ---- */

/* What is needed of a row of line/9. */
typedef struct line_row {
  int32_t s[2], l;
  sg_chain_vertex a, b;
} line_row;

static int
compare_rows(const void *x, const void *y)
{
  const line_row *p = x, *q = y;

  for (int k = 0; k < 2; k++) {
    if (p->s[k] != q->s[k]) {
      return p->s[k] < q->s[k] ? -1 : 1;
    }
  }
  return (p->l > q->l) - (p->l < q->l);
}

/* All rows, by segments and number; null: an exception. free() it. */
static line_row *
read_rows_ex(const sg_version *version, size_t *n)
{
  size_t room = sg_version_count(version, SG_LINE);
  line_row *row = malloc((room + 1) * sizeof *row);
  sg_view view;

  *n = 0;
  if (!row || !sg_version_view(version, SG_LINE, &view)) {
    free(row);
    sg_no_memory();
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

/* chain(S1, S2, Kind, Lines) */
static int
put_row_chain(term_t t, const line_row *row, const sg_chains *chains,
              const sg_chain *chain)
{
  const int32_t *step = &chains->step[chain->first];
  const line_row *first = &row[abs(step[0]) - 1];
  term_t arg = PL_new_term_refs(4), head = PL_new_term_ref();

  PL_put_nil(arg + 3);
  for (size_t i = chain->n; i > 0; i--) {
    int32_t l = row[abs(step[i - 1]) - 1].l;

    if (!PL_put_integer(head, step[i - 1] > 0 ? l : -l) ||
        !PL_cons_list(arg + 3, head, arg + 3)) {
      return FALSE;
    }
  }
  return PL_put_integer(arg, first->s[0]) &&
         PL_put_integer(arg + 1, first->s[1]) && put_kind(arg + 2, chain) &&
         PL_cons_functor_v(t, functor_chain4, arg);
}

static int
unify_row_chains(term_t list, const line_row *row, const sg_chains *chains)
{
  term_t all = PL_new_term_ref(), chain = PL_new_term_ref();

  PL_put_nil(all);
  for (size_t i = chains->n; i > 0; i--) {
    if (!put_row_chain(chain, row, chains, &chains->item[i - 1]) ||
        !PL_cons_list(all, chain, all)) {
      return FALSE;
    }
  }
  return PL_unify(list, all);
}

static foreign_t
line_chains(term_t list)
{
  sg_world *world = sg_current_world_ex();
  sg_chains chains;
  size_t n;

  if (!world) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  line_row *row = read_rows_ex(version, &n);

  sg_version_drop(version);
  if (!row) {
    return FALSE;
  }
  sg_chain_line *line = lines_of_rows(row, n);
  int good = (line && sg_chains_make(line, n, &chains)) || sg_no_memory();

  if (good) {
    good = unify_row_chains(list, row, &chains);
    sg_chains_clear(&chains);
  }
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

/* point(X, Y, Z, Origin) */
static int
put_point(term_t t, const sg_cut_points *points, uint32_t number)
{
  const double *p = points->point[number].at.p;
  term_t arg = PL_new_term_refs(4);

  for (int k = 0; k < 3; k++) {
    if (!PL_put_float(arg + k, p[k] + 0.0)) {
      return FALSE;
    }
  }
  int good = sg_unify_origin(arg + 3, points, number) &&
             PL_cons_functor_v(t, functor_point4, arg);

  PL_reset_term_refs(arg);
  return good;
}

/* chain(S1, S2, Kind, Points, Polygons): one P1-P2 less than points; of a
 * point alone one of each. */
static int
put_piece_chain(term_t t, const piece_graph *g, const sg_chains *chains,
                const sg_chain *chain)
{
  const int32_t *step = &chains->step[chain->first];
  const int32_t *s = g->piece[abs(step[0]) - 1]->s;
  term_t arg = PL_new_term_refs(5), head = PL_new_term_ref();
  term_t p = PL_new_term_refs(2);

  PL_put_nil(arg + 4);
  PL_put_nil(arg + 3);
  if (!chain->point &&
      (!put_point(head, g->points, step_start(g, -step[chain->n - 1])) ||
       !PL_cons_list(arg + 3, head, arg + 3))) {
    return FALSE;
  }
  for (size_t i = chain->n; i > 0; i--) {
    const sg_cut_piece *k = g->piece[abs(step[i - 1]) - 1];

    if (!put_point(head, g->points, step_start(g, step[i - 1])) ||
        !PL_cons_list(arg + 3, head, arg + 3) || !PL_put_integer(p, k->p[0]) ||
        !PL_put_integer(p + 1, k->p[1]) ||
        !PL_cons_functor_v(head, functor_minus2, p) ||
        !PL_cons_list(arg + 4, head, arg + 4)) {
      return FALSE;
    }
  }
  return PL_put_integer(arg, s[0]) && PL_put_integer(arg + 1, s[1]) &&
         put_kind(arg + 2, chain) && PL_cons_functor_v(t, functor_chain5, arg);
}

static int
unify_piece_chains(term_t list, const piece_graph *g, const sg_chains *chains)
{
  term_t all = PL_new_term_ref(), chain = PL_new_term_ref();

  PL_put_nil(all);
  for (size_t i = chains->n; i > 0; i--) {
    if (!put_piece_chain(chain, g, chains, &chains->item[i - 1]) ||
        !PL_cons_list(all, chain, all)) {
      return FALSE;
    }
  }
  return PL_unify(list, all);
}

static foreign_t
cut_chains(term_t set, term_t list)
{
  sg_cut_handle *handle;
  piece_graph g;
  sg_chains chains;

  if (!sg_get_cut_set_ex(set, &handle)) {
    return FALSE;
  }
  int good =
      (graph_init(&g, &handle->set) && sg_chains_make(g.line, g.n, &chains)) ||
      sg_no_memory();

  if (good) {
    good = unify_piece_chains(list, &g, &chains);
    sg_chains_clear(&chains);
  }
  graph_clear(&g);
  return good;
}

static const PL_extension predicates[] = {
    {"line_chains", 1, line_chains, 0},
    {"cut_chains", 2, cut_chains, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_chain(void)
{
  functor_chain4 = PL_new_functor(PL_new_atom("chain"), 4);
  functor_chain5 = PL_new_functor(PL_new_atom("chain"), 5);
  functor_point4 = PL_new_functor(PL_new_atom("point"), 4);
  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  atom_open = PL_new_atom("open");
  atom_closed = PL_new_atom("closed");
  atom_point = PL_new_atom("point");
  PL_register_extensions_in_module("sg_kernel_penetration", predicates);
}
