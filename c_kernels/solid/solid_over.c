/* solid_over.c -- what of the old rows stays: see solid_over.h. */
#include "solid_over.h"

#include "engine/list.h"
#include "engine/search.h"
#include "rows/key_table.h"

#include <stdlib.h>
#include <string.h>

typedef struct matching {
  const sg_solid_rows *rows;
  const sg_solid *solid;
  const sg_solid_old *old;
  sg_solid_over *out;
  const sg_cancel *cancel;
  sg_key_table was;  /* segment, vertex -> place of an old vertex */
  sg_key_table made; /* three doubles -> place of one that a cut made */
  uint32_t *first;   /* [old vertices]: an old face whose first triangle begins
                        there */
  uint32_t *next;    /* [old faces]: another one */
  int32_t (*new_source)[3], (*old_source)[3]; /* scratch */
  size_t new_room, old_room;
  size_t part; /* of the solid: the first that is not of an earlier face */
} matching;

/* ---- vertices ----------------------------------------------------------- */

static void
old_at(const sg_solid_old *old, uint32_t i, double at[3])
{
  for (unsigned k = 0; k < 3; k++) {
    at[k] = sg_old_float(old, SG_OLD_V, 2 + k, i);
  }
}

/* Where the old vertex is known; null: no memory. */
static uint32_t *
known_as(matching *m, uint32_t i)
{
  uint32_t from = m->old->from[i], key[6];
  double at[3];

  if (from != SG_NO_PLACE) {
    key[0] = (uint32_t)sg_old_int(m->old, SG_OLD_FROM_V, 2, from);
    key[1] = (uint32_t)sg_old_int(m->old, SG_OLD_FROM_V, 3, from);
    return sg_key_table_put(&m->was, key);
  }
  old_at(m->old, i, at);
  sg_place_key(at, key);
  return sg_key_table_put(&m->made, key);
}

/* Of two that have the same name the first is known. False: no memory, or
 * stopped. */
static bool
know_vertices(matching *m)
{
  size_t plain = sg_old_count(m->old, SG_OLD_FROM_V);

  if (!sg_key_table_reserve(&m->was, plain) ||
      !sg_key_table_reserve(&m->made, sg_old_count(m->old, SG_OLD_V) - plain)) {
    return false;
  }
  for (uint32_t i = 0; i < sg_old_count(m->old, SG_OLD_V); i++) {
    uint32_t *known = sg_cancel_every(m->cancel, i) ? NULL : known_as(m, i);
    if (!known) {
      return false;
    }
    if (*known == SG_NO_KEY) {
      *known = i;
    }
  }
  return true;
}

/* The origin of a vertex of the solid, or null. */
static const uint32_t *
origin_of(const sg_solid *solid, uint32_t v)
{
  return v >= solid->plain && solid->origin ? solid->origin[v - solid->plain]
                                            : NULL;
}

static bool
same_terms(const uint32_t *a, const uint32_t *b)
{
  return a && b ? a[0] == b[0] && memcmp(a + 1, b + 1, a[0]) == 0 : a == b;
}

/* The old vertex is that of the solid. */
static bool
is_same_vertex(const matching *m, uint32_t i, uint32_t v)
{
  uint32_t origin = m->old->origin[i], key[2][6];
  double at[3];

  old_at(m->old, i, at);
  sg_place_key(at, key[0]);
  sg_place_key(m->solid->vertex[v].at, key[1]);
  return memcmp(key[0], key[1], sizeof key[0]) == 0 &&
         same_terms(origin == SG_NO_PLACE
                        ? NULL
                        : (const uint32_t *)sg_old_list(m->old, SG_OLD_ORIGIN,
                                                        2, origin),
                    origin_of(m->solid, v));
}

/* Each name is of one vertex of the solid, so no old one is taken twice. */
static void
match_vertex(matching *m, uint32_t v)
{
  const sg_solid_vertex *vertex = &m->solid->vertex[v];
  uint32_t key[6], i;

  if (v < m->solid->plain) {
    key[0] = (uint32_t)vertex->s;
    key[1] = (uint32_t)vertex->v;
    i = sg_key_table_get(&m->was, key);
  } else {
    sg_place_key(vertex->at, key);
    i = sg_key_table_get(&m->made, key);
  }
  if (i != SG_NO_KEY && m->out->gone[SG_OLD_V][i] && is_same_vertex(m, i, v)) {
    m->out->vertex[v] = i;
    m->out->gone[SG_OLD_V][i] = 0;
  }
}

/* ---- faces -------------------------------------------------------------- */

/* The old vertex that corner k of an old triangle is. */
static uint32_t
old_corner(const sg_solid_old *old, uint32_t triangle, unsigned k)
{
  return sg_old_place(&old->vertex, sg_old_int(old, SG_OLD_T, 3 + k, triangle));
}

static void
list_faces(matching *m)
{
  const sg_solid_old *old = m->old;

  for (uint32_t p = (uint32_t)sg_old_count(old, SG_OLD_P); p-- > 0;) {
    const uint32_t *begin = old->triangles.begin + p;
    uint32_t v = begin[0] < begin[1]
                     ? old_corner(old, old->triangles.place[begin[0]], 0)
                     : SG_NO_PLACE;
    if (v != SG_NO_PLACE) {
      m->next[p] = m->first[v];
      m->first[v] = p;
    }
  }
}

static bool
same_triangles(const matching *m, const sg_solid_face *face, uint32_t p)
{
  const sg_solid_old *old = m->old;
  const uint32_t *begin = old->triangles.begin + p;

  if (begin[1] - begin[0] != face->n) {
    return false;
  }
  for (uint32_t i = 0; i < face->n; i++) {
    const uint32_t *v = m->solid->triangle[face->first + i];
    for (unsigned k = 0; k < 3; k++) {
      if (m->out->vertex[v[k]] == SG_NO_PLACE ||
          old_corner(old, old->triangles.place[begin[0] + i], k) !=
              m->out->vertex[v[k]]) {
        return false;
      }
    }
  }
  return true;
}

/* Edge e of the old ones runs from v to w of the solid, and is as auxiliary. */
static bool
is_same_edge(const matching *m, int32_t e, uint32_t v, uint32_t w, bool real)
{
  const sg_solid_old *old = m->old;
  uint32_t i = sg_old_place(&old->edge, e);

  return sg_old_place(&old->vertex, sg_old_int(old, SG_OLD_E, 2, i)) ==
             m->out->vertex[v] &&
         sg_old_place(&old->vertex, sg_old_int(old, SG_OLD_E, 3, i)) ==
             m->out->vertex[w] &&
         sg_old_int(old, SG_OLD_E, 4, i) == real;
}

static bool
same_edges(const matching *m, const sg_solid_face *face, uint32_t p)
{
  const int32_t *list = sg_old_list(m->old, SG_OLD_P, 2, p);
  int32_t n = 0;

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    const uint32_t *v = m->solid->triangle[t];
    for (int k = 0; k < 3; k++) {
      if ((m->rows->border[t] >> k & 1) &&
          (n++ == list[0] ||
           !is_same_edge(m, list[n], v[k], v[(k + 1) % 3],
                         !(m->solid->auxiliary[t] >> k & 1)))) {
        return false;
      }
    }
  }
  return n == list[0];
}

/* ---- what faces come from ----------------------------------------------- */

SG_ORDER(compare_sources, int32_t, SG_BY_AT(0) SG_BY_AT(1) SG_BY_AT(2));

/* Sorts them, each once. */
static size_t
sorted(int32_t (*source)[3], size_t n)
{
  size_t left = n > 0;

  if (n > 1) {
    qsort(source, n, sizeof *source, compare_sources);
  }
  for (size_t i = 1; i < n; i++) {
    if (compare_sources(source[left - 1], source[i]) != 0) {
      memcpy(source[left++], source[i], sizeof *source);
    }
  }
  return left;
}

static void
set_source(int32_t to[3], int32_t s, int32_t p, bool reversed)
{
  to[0] = s;
  to[1] = p;
  to[2] = reversed ? -1 : 1;
}

/* The face and its parts. False: no memory. */
static bool
list_new_sources(matching *m, uint32_t f, size_t *n)
{
  const sg_solid *solid = m->solid;
  const sg_solid_face *face = &solid->face[f];
  size_t end;

  while (m->part < solid->parts && solid->part[m->part].face < f) {
    m->part++;
  }
  for (end = m->part; end < solid->parts && solid->part[end].face == f;) {
    end++;
  }
  *n = 1 + end - m->part;
  if (!sg_list_need(&m->new_source, *n, &m->new_room, sizeof *m->new_source)) {
    return false;
  }
  set_source(m->new_source[0], face->s, face->p, face->reversed);
  for (size_t i = m->part; i < end; i++) {
    set_source(m->new_source[1 + i - m->part], solid->part[i].s,
               solid->part[i].p, solid->part[i].reversed);
  }
  *n = sorted(m->new_source, *n);
  return true;
}

static bool
list_old_sources(matching *m, uint32_t p, size_t *n)
{
  const sg_old_groups *of = &m->old->sources;

  *n = of->begin[p + 1] - of->begin[p];
  if (!sg_list_need(&m->old_source, *n, &m->old_room, sizeof *m->old_source)) {
    return false;
  }
  for (size_t i = 0; i < *n; i++) {
    for (unsigned k = 0; k < 3; k++) {
      m->old_source[i][k] =
          sg_old_int(m->old, SG_OLD_FROM_P, 2 + k, of->place[of->begin[p] + i]);
    }
  }
  *n = sorted(m->old_source, *n);
  return true;
}

/* False: no memory; *same tells. */
static bool
same_sources(matching *m, uint32_t f, uint32_t p, bool *same)
{
  size_t new_n, old_n;

  if (!list_new_sources(m, f, &new_n) || !list_old_sources(m, p, &old_n)) {
    return false;
  }
  *same = new_n == old_n && memcmp(m->new_source, m->old_source,
                                   new_n * sizeof *m->new_source) == 0;
  return true;
}

/* ---- what stays --------------------------------------------------------- */

/* An old polygon and all that belongs to it stays. */
static void
keep_face(matching *m, uint32_t f, uint32_t p)
{
  const sg_solid_old *old = m->old;
  const int32_t *list = sg_old_list(old, SG_OLD_P, 2, p);
  uint8_t **gone = m->out->gone;

  m->out->face[f] = p;
  m->out->faces_stay++;
  gone[SG_OLD_P][p] = 0;
  gone[SG_OLD_PLANE][old->plane[p]] = 0;
  for (int32_t k = 1; k <= list[0]; k++) {
    gone[SG_OLD_E][sg_old_place(&old->edge, list[k])] = 0;
  }
  for (uint32_t i = old->triangles.begin[p]; i < old->triangles.begin[p + 1];
       i++) {
    gone[SG_OLD_T][old->triangles.place[i]] = 0;
  }
  for (uint32_t i = old->sources.begin[p]; i < old->sources.begin[p + 1]; i++) {
    gone[SG_OLD_FROM_P][old->sources.place[i]] = 0;
  }
}

/* False: no memory. */
static bool
match_face(matching *m, uint32_t f)
{
  const sg_solid_face *face = &m->solid->face[f];
  uint32_t v = m->out->vertex[m->solid->triangle[face->first][0]];
  uint32_t p = v == SG_NO_PLACE ? SG_NO_PLACE : m->first[v];

  for (; p != SG_NO_PLACE; p = m->next[p]) {
    bool same = m->out->gone[SG_OLD_P][p] && m->old->plane[p] != SG_NO_PLACE &&
                same_triangles(m, face, p) && same_edges(m, face, p);
    if (same && !same_sources(m, f, p, &same)) {
      return false;
    }
    if (same) {
      keep_face(m, f, p);
      return true;
    }
  }
  return true;
}

/* What is said of a vertex goes and stays with it; other origins stay. So do
 * vertices that other faces have. */
static void
keep_names(matching *m)
{
  const sg_solid_old *old = m->old;
  uint8_t **gone = m->out->gone;

  memset(gone[SG_OLD_ORIGIN], 0, sg_old_count(old, SG_OLD_ORIGIN));
  for (uint32_t i = 0; i < sg_old_count(old, SG_OLD_V); i++) {
    if (sg_old_is_held(&old->vertex, sg_old_int(old, SG_OLD_V, 1, i))) {
      gone[SG_OLD_V][i] = 0;
    }
    if (old->from[i] != SG_NO_PLACE) {
      gone[SG_OLD_FROM_V][old->from[i]] = gone[SG_OLD_V][i];
    }
    if (old->origin[i] != SG_NO_PLACE) {
      gone[SG_OLD_ORIGIN][old->origin[i]] = gone[SG_OLD_V][i];
    }
  }
}

static bool
open_all(matching *m)
{
  size_t faces = sg_old_count(m->old, SG_OLD_P);

  m->out->vertex = sg_old_new_places(m->solid->vertices);
  m->out->face = sg_old_new_places(m->solid->faces);
  m->first = sg_old_new_places(sg_old_count(m->old, SG_OLD_V));
  m->next = sg_old_new_places(faces);
  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    size_t n = sg_old_count(m->old, k);
    m->out->gone[k] = malloc(n + 1);
    if (!m->out->gone[k]) {
      return false;
    }
    memset(m->out->gone[k], 1, n);
  }
  return m->out->vertex && m->out->face && m->first && m->next;
}

static bool
match_all(matching *m)
{
  bool good = open_all(m) && know_vertices(m);

  for (size_t i = 0; good && i < m->rows->vertices; i++) {
    match_vertex(m, m->rows->vertex[i]);
    good = !sg_cancel_every(m->cancel, i);
  }
  if (good) {
    list_faces(m);
  }
  for (uint32_t f = 0; good && f < m->solid->faces; f++) {
    good = match_face(m, f) && !sg_cancel_every(m->cancel, f);
  }
  if (good) {
    keep_names(m);
  }
  return good;
}

bool
sg_solid_over_match(const sg_solid_rows *rows, const sg_solid_old *old,
                    const sg_cancel *cancel, sg_solid_over *out)
{
  matching m = {.rows = rows,
                .solid = rows->solid,
                .old = old,
                .out = out,
                .cancel = cancel};

  *out = (sg_solid_over){0};
  sg_key_table_init(&m.was, 2);
  sg_key_table_init(&m.made, 6);
  bool good = match_all(&m);

  sg_key_table_clear(&m.was);
  sg_key_table_clear(&m.made);
  free(m.first);
  free(m.next);
  free(m.new_source);
  free(m.old_source);
  return good;
}
