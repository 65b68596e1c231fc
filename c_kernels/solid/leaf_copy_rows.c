/* leaf_copy_rows.c -- operands that are an earlier one once more.
 *
 * Layer: rows. Two are equal if their rows are, but for the ids: exact. What a
 * look at all vertices shows to be different is not compared.
 */
#include "doors/boolean.h"
#include "engine/search.h"
#include "rows/dense_rows.h"
#include "rows/edge_print.h"
#include "rows/live_rows.h"
#include "rows/sort.h"

#include <stdlib.h>
#include <string.h>

typedef struct leaf {
  int32_t s, kind;
  uint64_t print; /* of its vertices, in any order; 0: it has none */
  bool cut;       /* its rows are not what it was */
} leaf;

/* Rows are read of the leaves alone. */
typedef struct leaves {
  leaf *leaf; /* [n] ascending; once sorted, by print */
  size_t n;
  size_t last;     /* the place of the leaf of the row before */
  unsigned column; /* of the segment */
} leaves;

/* What a segment that was cut, or ran along a cut, has a row in. */
static const struct {
  sg_relation relation;
  unsigned column;
} cut_rows[] = {{SG_LEAF_V, 0}, {SG_LEAF_E, 0}, {SG_LEAF_P, 0},
                {SG_LEAF_T, 0}, {SG_LINE, 1},   {SG_LINE, 5}};

SG_ORDER(by_print, leaf, SG_BY(print) SG_BY(kind) SG_BY(cut) SG_BY(s));

SG_ORDER(by_copy, sg_id_pair, SG_BY(a));

/* The leaf that a row is of; null: of another segment. */
static leaf *
leaf_of(leaves *of, const sg_live_row *row)
{
  int32_t s = sg_row_int(row, of->column);

  if (of->leaf[of->last].s != s) {
    size_t at = sg_first_id(of->leaf, of->n, sizeof *of->leaf, s);

    if (at == of->n || of->leaf[at].s != s) {
      return NULL;
    }
    of->last = at;
  }
  return &of->leaf[of->last];
}

static void
see_segment(void *reader, const sg_live_row *row)
{
  leaf *of = leaf_of(reader, row);

  if (of) {
    of->kind = sg_row_int(row, 1);
  }
}

static void
see_cut(void *reader, const sg_live_row *row)
{
  leaf *of = leaf_of(reader, row);

  if (of) {
    of->cut = true;
  }
}

static void
see_vertex(void *reader, const sg_live_row *row)
{
  leaf *of = leaf_of(reader, row);
  uint64_t print = 0;

  for (unsigned k = 0; of && k < 3; k++) {
    double x = sg_row_number(row, k + 2);
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    print = sg_spread_bits(print ^ bits);
  }
  if (of) {
    of->print += print;
  }
}

/* False: see call.h. */
static bool
look(sg_call *call, leaves *of)
{
  bool good = sg_each_row(call, SG_SEGMENT, see_segment, of) &&
              sg_each_row(call, SG_V, see_vertex, of);

  for (size_t i = 0; good && i < sizeof cut_rows / sizeof *cut_rows; i++) {
    of->column = cut_rows[i].column;
    good = sg_each_row(call, cut_rows[i].relation, see_cut, of);
  }
  return good;
}

/* ---- equal ones ---- */

/* Things of two segments in a sg_dense: n of each, from these places. */
typedef struct range {
  size_t a, b, n;
} range;

static bool
as_many(const uint32_t *begin, size_t a, size_t b, range *out)
{
  *out = (range){begin[a], begin[b], begin[a + 1] - begin[a]};
  return begin[b + 1] - begin[b] == out->n;
}

/* Whether places of things that begin at to->a and at to->b are the same. */
static bool
same_places(const int32_t *a, const int32_t *b, size_t n, const range *to)
{
  size_t i = 0;

  while (i < n && (size_t)a[i] - to->a == (size_t)b[i] - to->b) {
    i++;
  }
  return i == n;
}

static bool
same_polygons(const sg_dense *d, const range *p, const range *e)
{
  const uint32_t *a = d->list_begin + p->a, *b = d->list_begin + p->b;
  size_t i = 0;

  while (i < p->n && a[i + 1] - a[i] == b[i + 1] - b[i]) {
    i++;
  }
  return i == p->n && same_places(d->list + *a, d->list + *b, a[p->n] - *a, e);
}

/* Whether two segments (places) are equal. */
static bool
are_equal(const sg_dense *d, size_t a, size_t b)
{
  range v, e, p, t;

  return d->grain[a] == d->grain[b] && as_many(d->vertex_begin, a, b, &v) &&
         as_many(d->edge_begin, a, b, &e) &&
         as_many(d->polygon_begin, a, b, &p) &&
         as_many(d->triangle_begin, a, b, &t) &&
         memcmp(d->at + v.a, d->at + v.b, v.n * sizeof *d->at) == 0 &&
         memcmp(d->real + e.a, d->real + e.b, e.n) == 0 &&
         same_places(d->from + e.a, d->from + e.b, e.n, &v) &&
         same_places(d->to + e.a, d->to + e.b, e.n, &v) &&
         same_polygons(d, &p, &e) &&
         same_places(d->polygon_of + t.a, d->polygon_of + t.b, t.n, &p) &&
         same_places(d->corner[t.a], d->corner[t.b], 3 * t.n, &v);
}

/* The end of those that may be equal to leaf i. */
static size_t
end_of_run(const leaves *of, size_t i)
{
  const leaf *first = &of->leaf[i];
  bool whole = first->print != 0 && !first->cut;

  for (i++; whole && i < of->n && of->leaf[i].print == first->print &&
            of->leaf[i].kind == first->kind && !of->leaf[i].cut;
       i++) {
  }
  return i;
}

static bool
read_alike(sg_call *call, const leaves *of, sg_dense *out)
{
  int32_t *s = sg_call_alloc(call, (of->n + 1) * sizeof *s);
  size_t n = 0;

  for (size_t i = 0, end; s && i < of->n; i = end) {
    end = end_of_run(of, i);
    for (size_t k = i; k < end && end - i > 1; k++) {
      s[n++] = of->leaf[k].s;
    }
  }
  return s && (n == 0 || sg_dense_read(call, s, sg_sort_ids(s, n), out));
}

/* But the first `most` of equal ones. */
static bool
add_copies(sg_call *call, const leaves *of, const sg_dense *d, size_t most,
           sg_id_pair_list *copies)
{
  bool good = true;

  for (size_t i = 0, end; good && i < of->n; i = end) {
    int32_t first = of->leaf[i].s;
    size_t at = sg_find_id(d->segment, d->segments, first), equal = 1;

    end = end_of_run(of, i);
    for (size_t k = i + 1; good && k < end; k++) {
      int32_t s = of->leaf[k].s;

      if (are_equal(d, at, sg_find_id(d->segment, d->segments, s)) &&
          ++equal > most) {
        good = sg_id_pair_list_add(call, copies, (sg_id_pair){s, first});
      }
    }
  }
  return good;
}

bool
sg_door_leaf_copies(sg_call *call, const sg_int_list *ss, size_t most,
                    sg_id_pair_list *copies)
{
  leaves of = {.leaf = sg_call_alloc(call, (ss->n + 1) * sizeof *of.leaf),
               .n = ss->n};
  sg_dense dense = {0};

  for (size_t i = 0; of.leaf && i < ss->n; i++) {
    of.leaf[i] = (leaf){.s = ss->at[i]};
  }
  if (!of.leaf || ss->n < 2) {
    return of.leaf != NULL;
  }
  if (!look(call, &of)) {
    return false;
  }
  qsort(of.leaf, of.n, sizeof *of.leaf, by_print);
  bool good = read_alike(call, &of, &dense) &&
              add_copies(call, &of, &dense, most, copies);

  if (good && copies->n > 0) {
    qsort(copies->at, copies->n, sizeof *copies->at, by_copy);
  }
  sg_dense_clear(&dense);
  return good;
}
