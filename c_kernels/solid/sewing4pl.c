/* sewing4pl.c -- shells of a segment that touch exactly, in its rows
 * (documented in kernel/boolean.pl).
 *
 * Layer: glue.
 */
#include "glue.h"
#include "rows/append4pl.h"
#include "rows/dense4pl.h"
#include "sewing.h"

#include "engine/install.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_INTS = 6 }; /* columns of integers: those of t/6 */

/* A segment at hand. */
typedef struct sewn {
  sg_world *world;
  const sg_version *version;
  int32_t s;
  sg_dense dense;
  sg_sewing sewing;
  bool *kept; /* [edges]: they do not fall out with their polygons */
} sewn;

/* Rows that go, and those that come instead. */
typedef struct exchange {
  sg_row *gone;
  size_t gones, n;
  int32_t *column[MOST_INTS]; /* [n] */
} exchange;

/* ---- what becomes of a row ---- */

static int
compare_ids(const void *x, const void *y)
{
  int32_t a = *(const int32_t *)x, b = *(const int32_t *)y;

  return (a > b) - (a < b);
}

static size_t
place_of(const int32_t *ids, size_t n, int32_t id)
{
  const int32_t *at = bsearch(&id, ids, n, sizeof id, compare_ids);

  return (size_t)(at - ids);
}

/* The id of the vertex that vertex v becomes. */
static int32_t
vertex_of(const sewn *s, int32_t v)
{
  const sg_dense *d = &s->dense;

  return d->vertex_id[s->sewing.vertex[place_of(d->vertex_id, d->vertices, v)]];
}

static bool
falls_out(const sewn *s, int32_t p)
{
  const sg_dense *d = &s->dense;

  return s->sewing.weight[place_of(d->polygon_id, d->polygons, p)] == 0;
}

/* Whether a row goes, and *comes: as `row` then. Column 1 of all but t/6 is the
 * id. */
static bool
changes(const sewn *s, sg_relation relation, int32_t row[MOST_INTS],
        bool *comes)
{
  unsigned first = relation == SG_T ? 3 : 2, end = relation == SG_T ? 6 : 4;
  bool moved = false;

  *comes = relation == SG_E
               ? s->kept[place_of(s->dense.edge_id, s->dense.edges, row[1])]
               : !falls_out(s, row[1]);
  if (!*comes) {
    return true;
  }
  for (unsigned c = first; (relation == SG_E || relation == SG_T) && c < end;
       c++) {
    int32_t v = vertex_of(s, row[c]);

    moved = moved || v != row[c];
    row[c] = v;
  }
  *comes = moved;
  return moved;
}

/* ---- rows ---- */

static unsigned
ints_of(sg_relation relation)
{
  return relation == SG_T ? 6 : relation == SG_E ? 5 : 2;
}

static int
fill_ex(const sewn *s, sg_relation relation, const sg_segment_rows *rows,
        exchange *out)
{
  size_t most = rows->begin[1] + 1;
  unsigned ints = ints_of(relation);

  out->gone = malloc(most * sizeof *out->gone);
  for (unsigned c = 0; c < ints; c++) {
    if (!(out->column[c] = malloc(most * sizeof(int32_t))) || !out->gone) {
      return sg_no_memory();
    }
  }
  for (size_t i = 0; i < rows->begin[1]; i++) {
    int32_t row[MOST_INTS];
    bool comes;

    for (unsigned c = 0; c < ints; c++) {
      row[c] = sg_version_value(s->version, relation, rows->row[i], c).i;
    }
    if (!changes(s, relation, row, &comes)) {
      continue;
    }
    out->gone[out->gones++] = rows->row[i];
    for (unsigned c = 0; comes && c < ints; c++) {
      out->column[c][out->n] = row[c];
    }
    out->n += comes;
  }
  return TRUE;
}

/* The rows of a relation of integers that come, or one from which some go. */
static int
exchange_ex(const sewn *s, sg_relation relation)
{
  sg_segment_rows rows;
  exchange x = {0};
  int good = sg_rows_of_segment_ex(s->version, relation, s->s, &rows) &&
             fill_ex(s, relation, &rows, &x) &&
             (sg_world_exchange(s->world, relation, x.gone, x.gones, x.n,
                                (const void *const *)x.column) ||
              sg_no_memory());

  sg_segment_rows_clear(&rows);
  free(x.gone);
  for (int c = 0; c < MOST_INTS; c++) {
    free(x.column[c]);
  }
  return good;
}

/* The edges of polygons that fall out are not kept, or of those that stay are.
 */
static void
keep_edges(sewn *s, bool kept)
{
  const sg_dense *d = &s->dense;

  for (size_t p = 0; p < d->polygons; p++) {
    for (uint32_t i = d->list_begin[p];
         (s->sewing.weight[p] != 0) == kept && i < d->list_begin[p + 1]; i++) {
      s->kept[d->list[i]] = kept;
    }
  }
}

static int
find_kept_edges_ex(sewn *s)
{
  if (!(s->kept = malloc(s->dense.edges + 1))) {
    return sg_no_memory();
  }
  memset(s->kept, true, s->dense.edges);
  keep_edges(s, false);
  keep_edges(s, true);
  return TRUE;
}

/* What refers to others goes before these. */
static int
write_ex(sewn *s)
{
  static const sg_relation changed[] = {SG_T, SG_PLANE, SG_P, SG_E};
  int good = find_kept_edges_ex(s) && sg_claim_ex(s->world);

  if (!good) {
    return FALSE;
  }
  for (size_t i = 0; i < sizeof changed / sizeof *changed && good; i++) {
    good = exchange_ex(s, changed[i]);
  }
  sg_world_release(s->world);
  return good;
}

/* ---- doors ---- */

/* [P-Weight, ...] of those that do not count once. */
static int
unify_weights(const sewn *s, term_t list)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t p = 0; p < s->dense.polygons; p++) {
    int weight = s->sewing.weight[p];

    if (weight != 0 && weight != 1 &&
        (!PL_unify_list(tail, head, tail) ||
         !PL_unify_term(head, PL_FUNCTOR_CHARS, "-", 2, PL_INT,
                        (int)s->dense.polygon_id[p], PL_INT, weight))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* segment_sewn(+S, -Weights) is semidet. */
static foreign_t
segment_sewn(term_t t, term_t weights)
{
  sewn s = {.world = sg_current_world_ex()};

  if (!s.world || !sg_get_id_ex(t, &s.s)) {
    return FALSE;
  }
  s.version = sg_world_version(s.world);
  int good = sg_get_dense_ex(&s.s, 1, &s.dense) &&
             (sg_sewing_find(&s.dense, &sg_prolog_poll, &s.sewing) ||
              (PL_exception(0) ? FALSE : sg_no_memory()));
  good = good && s.sewing.any && write_ex(&s) && unify_weights(&s, weights);

  sg_sewing_clear(&s.sewing);
  sg_dense_clear(&s.dense);
  sg_version_drop(s.version);
  free(s.kept);
  return good;
}

static const PL_extension predicates[] = {
    {"segment_sewn", 2, segment_sewn, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_sewing(void)
{
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
