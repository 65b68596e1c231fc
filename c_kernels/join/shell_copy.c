/* shell_copy.c -- see shell_copy.h. */
#include "shell_copy.h"

#include "engine/search.h"
#include "rows/disjoint.h"
#include "rows/edge_print.h"
#include "rows/key_table.h"
#include "rows/places.h"
#include "rows/sort.h"

#include <stdlib.h>
#include <string.h>

/* A half-edge, `last` is a KIND; or a triangle, its lowest corner first. */
typedef struct part {
  uint32_t first, second, last;
} part;

enum { KINDS = 2 }; /* of edges: auxiliary, real */

/* A polygon in the order of shells. */
typedef struct member {
  uint32_t shell, polygon; /* the shell by its first vertex */
  uint64_t print;          /* the same for equal ones; rarely for others */
} member;

/* A shell: a run of members. */
typedef struct shell {
  uint64_t print;
  uint32_t first; /* polygon */
  size_t begin, n;
} shell;

/* Numbers of vertices, edges, polygons and triangles begin at the segment's
 * first ones. */
typedef struct copier {
  const sg_dense *d;
  uint32_t v0, e0, p0, t0;
  size_t vertices, edges, polygons, triangles;
  uint32_t *place; /* [vertices] */
  uint32_t *root;  /* [vertices] of their shell; null: polygons are asked */
  uint32_t *begin; /* [polygons + 1] in part[] */
  part *part;      /* by polygon, sorted */
  member *member;  /* [polygons] by shell, by print, by polygon */
  shell *shell;    /* [shells] by print, by first polygon */
  size_t shells;
  bool *whole; /* [vertices] of a shell's first: all its edges are used; or
                  null, as root */
} copier;

static void
copier_init(copier *c, const sg_dense *d, size_t s)
{
  *c = (copier){.d = d,
                .v0 = d->vertex_begin[s],
                .e0 = d->edge_begin[s],
                .p0 = d->polygon_begin[s],
                .t0 = d->triangle_begin[s]};
  c->vertices = d->vertex_begin[s + 1] - c->v0;
  c->edges = d->edge_begin[s + 1] - c->e0;
  c->polygons = d->polygon_begin[s + 1] - c->p0;
  c->triangles = d->triangle_begin[s + 1] - c->t0;
}

static void
copier_clear(copier *c)
{
  free(c->place);
  free(c->root);
  free(c->begin);
  free(c->part);
  free(c->member);
  free(c->shell);
  free(c->whole);
}

static uint32_t
start_of(const copier *c, int32_t e)
{
  return (uint32_t)c->d->from[e] - c->v0;
}

static uint32_t
end_of(const copier *c, int32_t e)
{
  return (uint32_t)c->d->to[e] - c->v0;
}

static uint32_t
corner_of(const copier *c, size_t t, int k)
{
  return (uint32_t)c->d->corner[c->t0 + t][k] - c->v0;
}

static uint32_t
polygon_of(const copier *c, size_t t)
{
  return (uint32_t)c->d->polygon_of[c->t0 + t] - c->p0;
}

/* The edges of polygon p: list[*begin .. end - 1]. */
static uint32_t
edges_of(const copier *c, size_t p, uint32_t *begin)
{
  *begin = c->d->list_begin[c->p0 + p];
  return c->d->list_begin[c->p0 + p + 1];
}

/* ---- what is connected ---- */

/* False: no memory. */
static bool
join_polygons(copier *c)
{
  const int32_t *list = c->d->list;
  uint32_t begin;

  c->root = malloc((c->vertices + 1) * sizeof *c->root);
  if (!c->root) {
    return false;
  }
  for (uint32_t v = 0; v < c->vertices; v++) {
    c->root[v] = v;
  }
  for (size_t e = 0; e < c->edges; e++) {
    int32_t of = (int32_t)(c->e0 + e);

    sg_disjoint_join(c->root, start_of(c, of), end_of(c, of));
  }
  for (size_t p = 0; p < c->polygons; p++) {
    for (uint32_t end = edges_of(c, p, &begin), i = begin; i < end; i++) {
      sg_disjoint_join(c->root, start_of(c, list[i]), start_of(c, list[begin]));
    }
  }
  for (size_t t = 0; t < c->triangles; t++) {
    for (int k = 1; k < 3; k++) {
      sg_disjoint_join(c->root, corner_of(c, t, 0), corner_of(c, t, k));
    }
  }
  for (uint32_t v = 0; v < c->vertices; v++) {
    c->root[v] = sg_disjoint_root(c->root, v);
  }
  return true;
}

/* Edges of no polygon make their shells unlike others. False: no memory. */
static bool
find_whole(copier *c)
{
  const int32_t *list = c->d->list;
  bool *used = calloc(c->edges + 1, sizeof *used);
  uint32_t begin;

  c->whole = malloc(c->vertices + 1);
  if (!used || !c->whole) {
    free(used);
    return false;
  }
  memset(c->whole, true, c->vertices);
  for (size_t p = 0; p < c->polygons; p++) {
    for (uint32_t end = edges_of(c, p, &begin), i = begin; i < end; i++) {
      used[(uint32_t)list[i] - c->e0] = true;
    }
  }
  for (size_t e = 0; e < c->edges; e++) {
    if (!used[e]) {
      c->whole[c->root[start_of(c, (int32_t)(c->e0 + e))]] = false;
    }
  }
  free(used);
  return true;
}

/* ---- parts of polygons ---- */

static part
edge_part(const copier *c, int32_t e)
{
  return (part){c->place[start_of(c, e)], c->place[end_of(c, e)],
                UINT32_MAX - c->d->real[e] % KINDS};
}

static part
triangle_part(const copier *c, size_t t)
{
  uint32_t v[3];

  for (int k = 0; k < 3; k++) {
    v[k] = c->place[corner_of(c, t, k)];
  }
  int k = v[1] < v[0] ? 1 : 0;

  k = v[2] < v[k] ? 2 : k;
  return (part){v[k], v[(k + 1) % 3], v[(k + 2) % 3]};
}

SG_ORDER(compare_parts, part, SG_BY(first) SG_BY(second) SG_BY(last));

/* Counts, then files: by polygon. False: no memory. */
static bool
file_parts(copier *c)
{
  uint32_t first,
      all = c->d->list_begin[c->p0 + c->polygons] - c->d->list_begin[c->p0];

  c->begin = calloc(c->polygons + 2, sizeof *c->begin);
  c->part = malloc((all + c->triangles + 1) * sizeof *c->part);
  if (!c->begin || !c->part) {
    return false;
  }
  for (size_t t = 0; t < c->triangles; t++) {
    c->begin[polygon_of(c, t) + 2]++;
  }
  for (size_t p = 0; p < c->polygons; p++) {
    uint32_t end = edges_of(c, p, &first);

    c->begin[p + 2] += c->begin[p + 1] + end - first;
  }
  for (size_t p = 0; p < c->polygons; p++) {
    for (uint32_t end = edges_of(c, p, &first), i = first; i < end; i++) {
      c->part[c->begin[p + 1]++] = edge_part(c, c->d->list[i]);
    }
  }
  for (size_t t = 0; t < c->triangles; t++) {
    c->part[c->begin[polygon_of(c, t) + 1]++] = triangle_part(c, t);
  }
  for (size_t p = 0; p < c->polygons; p++) {
    size_t n = c->begin[p + 1] - c->begin[p];

    if (n > 0) {
      qsort(c->part + c->begin[p], n, sizeof *c->part, compare_parts);
    }
  }
  return true;
}

static uint64_t
print_of(const copier *c, size_t p)
{
  uint64_t print = c->begin[p + 1] - c->begin[p];

  for (uint32_t i = c->begin[p]; i < c->begin[p + 1]; i++) {
    const part *one = &c->part[i];

    print = sg_spread_bits(print ^ ((uint64_t)one->first << 32 | one->second));
    print = sg_spread_bits(print ^ one->last);
  }
  return print;
}

static bool
same_polygons(const copier *c, uint32_t p, uint32_t q)
{
  uint32_t n = c->begin[p + 1] - c->begin[p];

  return n == c->begin[q + 1] - c->begin[q] &&
         memcmp(c->part + c->begin[p], c->part + c->begin[q],
                n * sizeof *c->part) == 0;
}

/* ---- shells ---- */

SG_ORDER(by_shell, member, SG_BY(shell) SG_BY(print) SG_BY(polygon));

SG_ORDER(by_print, shell, SG_BY(print) SG_BY(first));

/* The shell of a polygon; each is one of its own if none were looked for. */
static uint32_t
shell_of(const copier *c, uint32_t p)
{
  uint32_t begin, end = edges_of(c, p, &begin);

  return end == begin ? UINT32_MAX
         : c->root    ? c->root[start_of(c, c->d->list[begin])]
                      : p;
}

static bool
find_members(copier *c, const sg_cancel *cancel)
{
  c->member = malloc((c->polygons + 1) * sizeof *c->member);
  for (uint32_t p = 0; c->member && p < c->polygons; p++) {
    c->member[p] = (member){shell_of(c, p), p, print_of(c, p)};
  }
  return c->member && sg_sort(c->member, c->polygons, sizeof *c->member,
                              by_shell, cancel) == SG_SORTED;
}

static bool
find_shells(copier *c, const sg_cancel *cancel)
{
  size_t n = c->polygons;

  c->shell = malloc((n + 1) * sizeof *c->shell);
  for (size_t i = 0, end; c->shell && i < n; i = end) {
    shell one = {.print = 0, .first = UINT32_MAX, .begin = i};

    for (end = i; end < n && c->member[end].shell == c->member[i].shell;
         end++) {
      uint32_t p = c->member[end].polygon;

      one.print = sg_spread_bits(one.print ^ c->member[end].print);
      one.first = p < one.first ? p : one.first;
    }
    one.n = end - i;
    c->shell[c->shells++] = one;
  }
  return c->shell && sg_sort(c->shell, c->shells, sizeof *c->shell, by_print,
                             cancel) == SG_SORTED;
}

/* Whether b, which comes later, is equal to a, its polygons too later ones. */
static bool
same_shells(const copier *c, const shell *a, const shell *b)
{
  bool same = a->n == b->n;

  for (size_t i = 0; same && i < a->n; i++) {
    uint32_t p = c->member[a->begin + i].polygon;
    uint32_t q = c->member[b->begin + i].polygon;

    same = p < q && same_polygons(c, p, q);
  }
  return same;
}

static bool
is_whole(const copier *c, const shell *of)
{
  uint32_t root = c->member[of->begin].shell;

  return root != UINT32_MAX && (!c->whole || c->whole[root]);
}

/* ---- copies ---- */

static void
set_shell(const copier *c, const shell *of, uint32_t kind, uint32_t copy,
          uint32_t copies, sg_shell_copies *out)
{
  for (size_t i = of->begin; i < of->begin + of->n; i++) {
    uint32_t p = c->member[i].polygon;

    out->kind[p] = kind;
    out->copy[p] = copy;
    out->copies[p] = copies;
  }
}

/* Those of one print: they are equal to the first one, each later than the one
 * before, or alone. */
static void
set_run(const copier *c, const shell *run, size_t n, sg_shell_copies *out)
{
  const shell *last = &run[0];
  uint32_t copies = 1;
  bool whole = is_whole(c, &run[0]);

  for (int turn = 0; turn < 2; turn++) {
    uint32_t copy = 1;

    last = &run[0];
    for (size_t i = 1; i < n; i++) {
      bool same =
          whole && is_whole(c, &run[i]) && same_shells(c, last, &run[i]);

      if (turn == 1) {
        set_shell(c, &run[i], same ? run[0].first : run[i].first,
                  same ? copy : 0, same ? copies : 1, out);
      }
      copy += same;
      last = same ? &run[i] : last;
    }
    copies = copy;
  }
  set_shell(c, &run[0], run[0].first, 0, copies, out);
  out->any = out->any || copies > 1;
}

static bool
find_copies(copier *c, sg_shell_copies *out)
{
  size_t bytes = (c->polygons + 1) * sizeof(uint32_t);

  out->kind = malloc(bytes);
  out->copy = malloc(bytes);
  out->copies = malloc(bytes);
  if (!out->kind || !out->copy || !out->copies) {
    return false;
  }
  for (size_t i = 0, end; i < c->shells; i = end) {
    for (end = i + 1;
         end < c->shells && c->shell[end].print == c->shell[i].print; end++) {
    }
    set_run(c, &c->shell[i], end - i, out);
  }
  return true;
}

static bool
any_twice(const copier *c)
{
  for (size_t v = 0; v < c->vertices; v++) {
    if (c->place[v] != v) {
      return true;
    }
  }
  return false;
}

/* The first of the half-edges of a polygon by the places of its ends. */
static void
least_edge(const copier *c, size_t p, uint32_t out[2])
{
  uint32_t begin, end = edges_of(c, p, &begin);

  out[0] = out[1] = UINT32_MAX;
  for (uint32_t i = begin; i < end; i++) {
    uint32_t from = c->place[start_of(c, c->d->list[i])];
    uint32_t to = c->place[end_of(c, c->d->list[i])];

    if (from < out[0] || (from == out[0] && to < out[1])) {
      out[0] = from, out[1] = to;
    }
  }
}

/* Equal polygons have equal half-edges, of which most models have none. False:
 * no memory, or stopped. */
static bool
any_equal(const copier *c, const sg_cancel *cancel, bool *any)
{
  sg_key_table seen;
  bool good;

  *any = false;
  sg_key_table_init(&seen, 2);
  good = sg_key_table_reserve(&seen, c->polygons);
  for (size_t p = 0; good && !*any && p < c->polygons; p++) {
    uint32_t key[2];

    least_edge(c, p, key);
    good = !sg_cancel_every(cancel, p) && sg_key_table_add(&seen, key);
    *any = good && seen.n <= p;
  }
  sg_key_table_clear(&seen);
  return good;
}

static bool
find_places(copier *c, const sg_cancel *cancel)
{
  c->place =
      sg_places_of((const double(*)[3])c->d->at + c->v0, c->vertices, cancel);
  return c->place != NULL;
}

static bool
find_equal(copier *c, const sg_cancel *cancel, sg_shell_copies *out)
{
  return file_parts(c) && find_members(c, cancel) && find_shells(c, cancel) &&
         find_copies(c, out);
}

bool
sg_shell_copies_find(const sg_dense *dense, size_t s, const sg_cancel *cancel,
                     sg_shell_copies *out)
{
  copier c;

  *out = (sg_shell_copies){0};
  copier_init(&c, dense, s);
  if (c.polygons == 0) {
    return true;
  }
  bool good = find_places(&c, cancel);

  if (good && any_twice(&c)) {
    good = join_polygons(&c) && find_whole(&c) && find_equal(&c, cancel, out);
  }
  copier_clear(&c);
  return good;
}

bool
sg_polygon_copies_find(const sg_dense *dense, size_t s, const sg_cancel *cancel,
                       sg_shell_copies *out)
{
  copier c;

  *out = (sg_shell_copies){0};
  copier_init(&c, dense, s);
  if (c.polygons == 0) {
    return true;
  }
  bool any, good = find_places(&c, cancel) && any_equal(&c, cancel, &any) &&
                   (!any || find_equal(&c, cancel, out));

  copier_clear(&c);
  return good;
}

void
sg_shell_copies_clear(sg_shell_copies *copies)
{
  free(copies->kind);
  free(copies->copy);
  free(copies->copies);
  *copies = (sg_shell_copies){0};
}
