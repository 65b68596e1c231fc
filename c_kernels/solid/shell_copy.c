/* shell_copy.c -- see shell_copy.h. */
#include "shell_copy.h"

#include "rows/disjoint.h"
#include "rows/edge_print.h"
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

typedef struct copier {
  const sg_dense *d;
  uint32_t *place; /* [vertices] */
  uint32_t *root;  /* [vertices] of their shell */
  uint32_t *begin; /* [polygons + 1] in part[] */
  part *part;      /* by polygon, sorted */
  member *member;  /* [polygons] by shell, by print, by polygon */
  shell *shell;    /* [shells] by print, by first polygon */
  size_t shells;
} copier;

/* ---- what hangs together ---- */

static void
join_polygons(copier *c)
{
  const sg_dense *d = c->d;

  for (size_t v = 0; v < d->vertices; v++) {
    c->root[v] = (uint32_t)v;
  }
  for (size_t e = 0; e < d->edges; e++) {
    sg_disjoint_join(c->root, (uint32_t)d->from[e], (uint32_t)d->to[e]);
  }
  for (size_t p = 0; p < d->polygons; p++) {
    for (uint32_t i = d->list_begin[p]; i < d->list_begin[p + 1]; i++) {
      sg_disjoint_join(c->root, (uint32_t)d->from[d->list[i]],
                       (uint32_t)d->from[d->list[d->list_begin[p]]]);
    }
  }
  for (size_t t = 0; t < d->triangles; t++) {
    for (int k = 1; k < 3; k++) {
      sg_disjoint_join(c->root, (uint32_t)d->corner[t][0],
                       (uint32_t)d->corner[t][k]);
    }
  }
  for (size_t v = 0; v < d->vertices; v++) {
    c->root[v] = sg_disjoint_root(c->root, (uint32_t)v);
  }
}

/* ---- parts of polygons ---- */

static part
edge_part(const copier *c, int32_t e)
{
  return (part){c->place[c->d->from[e]], c->place[c->d->to[e]],
                UINT32_MAX - c->d->real[e] % KINDS};
}

static part
triangle_part(const copier *c, size_t t)
{
  const int32_t *corner = c->d->corner[t];
  uint32_t v[3] = {c->place[corner[0]], c->place[corner[1]],
                   c->place[corner[2]]};
  int k = v[1] < v[0] ? 1 : 0;

  k = v[2] < v[k] ? 2 : k;
  return (part){v[k], v[(k + 1) % 3], v[(k + 2) % 3]};
}

static int
compare_parts(const void *x, const void *y)
{
  const part *a = x, *b = y;

  return a->first != b->first ? (a->first > b->first) - (a->first < b->first)
         : a->second != b->second
             ? (a->second > b->second) - (a->second < b->second)
             : (a->last > b->last) - (a->last < b->last);
}

/* Counts, then files: by polygon. */
static bool
file_parts(copier *c)
{
  const sg_dense *d = c->d;

  c->begin = calloc(d->polygons + 2, sizeof *c->begin);
  c->part =
      malloc((d->list_begin[d->polygons] + d->triangles + 1) * sizeof *c->part);
  if (!c->begin || !c->part) {
    return false;
  }
  for (size_t t = 0; t < d->triangles; t++) {
    c->begin[d->polygon_of[t] + 2]++;
  }
  for (size_t p = 0; p < d->polygons; p++) {
    c->begin[p + 2] +=
        c->begin[p + 1] + d->list_begin[p + 1] - d->list_begin[p];
  }
  for (size_t p = 0; p < d->polygons; p++) {
    for (uint32_t i = d->list_begin[p]; i < d->list_begin[p + 1]; i++) {
      c->part[c->begin[p + 1]++] = edge_part(c, d->list[i]);
    }
  }
  for (size_t t = 0; t < d->triangles; t++) {
    c->part[c->begin[d->polygon_of[t] + 1]++] = triangle_part(c, t);
  }
  for (size_t p = 0; p < d->polygons; p++) {
    if (c->begin[p + 1] > c->begin[p]) {
      qsort(c->part + c->begin[p], c->begin[p + 1] - c->begin[p],
            sizeof *c->part, compare_parts);
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

static int
by_shell(const void *x, const void *y)
{
  const member *a = x, *b = y;

  return a->shell != b->shell ? (a->shell > b->shell) - (a->shell < b->shell)
         : a->print != b->print
             ? (a->print > b->print) - (a->print < b->print)
             : (a->polygon > b->polygon) - (a->polygon < b->polygon);
}

static int
by_print(const void *x, const void *y)
{
  const shell *a = x, *b = y;

  return a->print != b->print ? (a->print > b->print) - (a->print < b->print)
                              : (a->first > b->first) - (a->first < b->first);
}

static bool
find_members(copier *c, const sg_cancel *cancel)
{
  const sg_dense *d = c->d;
  size_t n = 0;

  c->member = malloc((d->polygons + 1) * sizeof *c->member);
  for (uint32_t p = 0; c->member && p < d->polygons; p++) {
    uint32_t i = d->list_begin[p];
    uint32_t v = i < d->list_begin[p + 1] ? (uint32_t)d->from[d->list[i]] : 0;

    c->member[n++] = (member){c->root[v], p, print_of(c, p)};
  }
  return c->member && sg_sort(c->member, n, sizeof *c->member, by_shell,
                              cancel) == SG_SORTED;
}

static bool
find_shells(copier *c, const sg_cancel *cancel)
{
  size_t n = c->d->polygons;

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

static bool
same_shells(const copier *c, const shell *a, const shell *b)
{
  bool same = a->n == b->n;

  for (size_t i = 0; same && i < a->n; i++) {
    same = same_polygons(c, c->member[a->begin + i].polygon,
                         c->member[b->begin + i].polygon);
  }
  return same;
}

/* ---- copies ---- */

/* Edges of no polygon make their shells unlike others: whole[v] of the shell's
 * first vertex becomes false. */
static void
find_whole(const copier *c, bool *used, bool *whole)
{
  const sg_dense *d = c->d;

  for (uint32_t i = 0; i < d->list_begin[d->polygons]; i++) {
    used[d->list[i]] = true;
  }
  memset(whole, true, d->vertices);
  for (size_t e = 0; e < d->edges; e++) {
    if (!used[e]) {
      whole[c->root[d->from[e]]] = false;
    }
  }
}

/* Those of one print: a shell goes if the `most` before it are equal to it.
 * lost[v] is of the shell's first vertex. */
static void
drop_copies(copier *c, size_t from, size_t end, size_t most, const bool *whole,
            bool *lost)
{
  size_t equal = 0;

  for (size_t i = from; i < end; i++) {
    bool same = i > from && same_shells(c, &c->shell[from], &c->shell[i]);
    uint32_t root = c->member[c->shell[i].begin].shell;

    equal += same || i == from;
    lost[root] = same && equal > most && whole[root];
  }
}

static bool
find_copies(copier *c, size_t most, sg_shell_copies *out)
{
  const sg_dense *d = c->d;
  bool *used = calloc(d->edges + 1, sizeof *used);
  bool *whole = calloc(d->vertices + 1, sizeof *whole);
  bool *lost = calloc(d->vertices + 1, sizeof *lost);
  bool good = used && whole && lost;

  out->gone = calloc(d->vertices + 1, sizeof *out->gone);
  good = good && out->gone;
  if (good) {
    find_whole(c, used, whole);
  }
  for (size_t i = 0, end; good && i < c->shells; i = end) {
    for (end = i + 1;
         end < c->shells && c->shell[end].print == c->shell[i].print; end++) {
    }
    drop_copies(c, i, end, most, whole, lost);
  }
  for (size_t v = 0; good && v < d->vertices; v++) {
    out->gone[v] = lost[c->root[v]];
    out->any = out->any || out->gone[v];
  }
  free(used);
  free(whole);
  free(lost);
  return good;
}

static bool
any_twice(const copier *c)
{
  for (size_t v = 0; v < c->d->vertices; v++) {
    if (c->place[v] != v) {
      return true;
    }
  }
  return false;
}

bool
sg_shell_copies_find(const sg_dense *dense, size_t most,
                     const sg_cancel *cancel, sg_shell_copies *out)
{
  copier c = {.d = dense};

  *out = (sg_shell_copies){0};
  c.place =
      sg_places_of((const double(*)[3])dense->at, dense->vertices, cancel);
  c.root = malloc((dense->vertices + 1) * sizeof *c.root);
  bool good = c.place && c.root;

  if (good && any_twice(&c)) {
    join_polygons(&c);
    good = file_parts(&c) && find_members(&c, cancel) &&
           find_shells(&c, cancel) && find_copies(&c, most, out);
  }
  free(c.place);
  free(c.root);
  free(c.begin);
  free(c.part);
  free(c.member);
  free(c.shell);
  return good;
}

void
sg_shell_copies_clear(sg_shell_copies *copies)
{
  free(copies->gone);
  *copies = (sg_shell_copies){0};
}
