/* boundary_flat.c -- faces without area go (boundary.h).
 *
 * The edges of a face whose vertices are all on one line, divided at all these
 * vertices, cancel each other: going there and back. So the face can go if what
 * is on the other side of each of its edges is divided in the same way. Faces
 * go one by one, and what is on the other side may be another one without area;
 * no face becomes one, for it stays where it is.
 *
 * A face that rounding has turned over is so thin that its vertices pass for
 * points on a line. They need not be: for any order of the vertices the edges,
 * divided, cancel.
 */
#include "boundary.h"
#include "engine/list.h"
#include "engine/search.h"
#include "number/exact.h"
#include "rows/key_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NOTHING SG_NO_KEY

/* An edge between vertices of flat faces, or one that takes the place of such:
 * in a list of those with the same ends, and of those that are new in a face.
 */
typedef struct record {
  int32_t from, to;
  uint32_t face;
  uint32_t place; /* in boundary->edge, or NOTHING: it is new */
  uint32_t next_like, next_new;
  bool gone;
} record;

typedef struct cleaner {
  sg_boundary *b;
  unsigned char *flat; /* [faces] */
  uint32_t *flat_face; /* [flat_faces] in an order of their own */
  size_t flat_faces;
  unsigned char *known; /* [vertices] of a flat face */
  uint32_t *fresh;      /* [faces] the first new edge of each */
  unsigned char *gone;  /* [edges] */
  sg_key_table like;    /* from, to -> the first record */
  record *item;
  size_t n, room;
  int32_t (*at_hand)[2]; /* the edges of the face at work */
  size_t hand_room;
  struct along *line; /* its vertices along the line */
  size_t line_room;
} cleaner;

/* ---- which are flat ------------------------------------------------------ */

static bool
on_one_line(const double a[3], const double b[3], const double c[3])
{
  for (int k = 0; k < 3; k++) {
    int x = (k + 1) % 3, y = (k + 2) % 3;
    if (sg_orient2d((double[2]){a[x], a[y]}, (double[2]){b[x], b[y]},
                    (double[2]){c[x], c[y]}) != 0) {
      return false;
    }
  }
  return true;
}

static bool
is_flat(const sg_boundary *b, size_t face)
{
  const int32_t *first = b->edge[b->begin[face]];

  for (uint32_t i = b->begin[face] + 1; i < b->begin[face + 1]; i++) {
    for (int k = 1; k >= 0; k--) {
      int32_t v = b->edge[i][k];
      if (v != first[0] && v != first[1] &&
          !on_one_line(b->at[first[0]], b->at[first[1]], b->at[v])) {
        return false;
      }
    }
  }
  return true;
}

static void
find_flat(cleaner *c, bool turned)
{
  const sg_boundary *b = c->b;

  for (size_t f = 0; f < b->faces; f++) {
    c->flat[f] = b->turned[f] == SG_NO_AREA ||
                 (turned && b->turned[f] == SG_TURNED) || is_flat(b, f);
    if (c->flat[f]) {
      c->flat_face[c->flat_faces++] = (uint32_t)f;
    }
    for (uint32_t i = b->begin[f]; c->flat[f] && i < b->begin[f + 1]; i++) {
      c->known[b->edge[i][0]] = c->known[b->edge[i][1]] = 1;
    }
  }
}

/* By the edges, which must be in order: the numbers of faces mean nothing. */
static int
compare_faces(const sg_boundary *b, uint32_t f, uint32_t g)
{
  uint32_t n = b->begin[f + 1] - b->begin[f], m = b->begin[g + 1] - b->begin[g];
  const int32_t *x = b->edge[b->begin[f]], *y = b->edge[b->begin[g]];

  for (uint32_t i = 0; i < 2 * n && i < 2 * m; i++) {
    if (x[i] != y[i]) {
      return x[i] < y[i] ? -1 : 1;
    }
  }
  return (n > m) - (n < m);
}

static int
compare_flat(const void *x, const void *y, void *boundary)
{
  return compare_faces(boundary, *(const uint32_t *)x, *(const uint32_t *)y);
}

/* ---- the edges at work ----------------------------------------------------
 */

static bool
add_record(cleaner *c, uint32_t face, int32_t from, int32_t to, uint32_t place)
{
  if (!sg_list_grow(&c->item, c->n, &c->room, sizeof *c->item)) {
    return false;
  }
  uint32_t key[2] = {(uint32_t)from, (uint32_t)to};
  uint32_t *first = sg_key_table_put(&c->like, key);
  if (!first) {
    return false;
  }
  c->item[c->n] = (record){from, to, face, place, *first, NOTHING, false};
  *first = (uint32_t)c->n;
  if (place == NOTHING) {
    c->item[c->n].next_new = c->fresh[face];
    c->fresh[face] = (uint32_t)c->n;
  }
  c->n++;
  return true;
}

static bool
is_known(const cleaner *c, const int32_t edge[2])
{
  return c->known[edge[0]] && c->known[edge[1]];
}

static bool
add_known_edges(cleaner *c)
{
  sg_boundary *b = c->b;

  for (size_t f = 0; f < b->faces; f++) {
    uint32_t begin = b->begin[f], end = b->begin[f + 1], i = begin;

    c->fresh[f] = NOTHING;
    while (i < end && !is_known(c, b->edge[i])) {
      i++;
    }
    if (i < end) {
      sg_edges_cancel(b->edge + begin, end - begin); /* for their order */
    }
    for (i = begin; i < end; i++) {
      if (is_known(c, b->edge[i]) &&
          !add_record(c, (uint32_t)f, b->edge[i][0], b->edge[i][1], i)) {
        return false;
      }
    }
  }
  return true;
}

static void
take_away(cleaner *c, record *r)
{
  r->gone = true;
  if (r->place != NOTHING) {
    c->gone[r->place] = 1;
  }
}

static bool
is_gone(const cleaner *c, const record *r)
{
  return r->gone || (r->place != NOTHING && c->gone[r->place]);
}

/* An edge from -> to of a face other than this; of several that of the first
 * face. Null: there is none. */
static record *
opposite(cleaner *c, uint32_t face, int32_t from, int32_t to)
{
  uint32_t key[2] = {(uint32_t)from, (uint32_t)to};
  record *found = NULL;

  for (uint32_t i = sg_key_table_get(&c->like, key); i != NOTHING;
       i = c->item[i].next_like) {
    record *r = &c->item[i];
    if (!is_gone(c, r) && r->face != face &&
        (!found || compare_faces(c->b, r->face, found->face) < 0)) {
      found = r;
    }
  }
  return found;
}

static bool
put_in_hand(cleaner *c, size_t *n, int32_t from, int32_t to)
{
  if (!sg_list_grow(&c->at_hand, *n, &c->hand_room, sizeof *c->at_hand)) {
    return false;
  }
  c->at_hand[*n][0] = from;
  c->at_hand[(*n)++][1] = to;
  return true;
}

/* The edges that a face has now. False: no memory. */
static bool
take_in_hand(cleaner *c, size_t face, size_t *n)
{
  const sg_boundary *b = c->b;

  *n = 0;
  for (uint32_t i = b->begin[face]; i < b->begin[face + 1]; i++) {
    if (!c->gone[i] && !put_in_hand(c, n, b->edge[i][0], b->edge[i][1])) {
      return false;
    }
  }
  for (uint32_t i = c->fresh[face]; i != NOTHING; i = c->item[i].next_new) {
    if (!c->item[i].gone &&
        !put_in_hand(c, n, c->item[i].from, c->item[i].to)) {
      return false;
    }
  }
  if (*n > 0) {
    *n = sg_edges_cancel(c->at_hand, *n);
  }
  return true;
}

/* ---- one flat face --------------------------------------------------------
 */

/* A vertex of the face at work, and how far along it is. */
typedef struct along {
  double at;
  int32_t v;
} along;

SG_ORDER(compare_along, along, SG_BY(at) SG_BY(v));

/* The vertices farthest apart, about: the farthest one from the first, and the
 * farthest one from that. */
static void
find_direction(const cleaner *c, size_t n, double out[3])
{
  const double(*at)[3] = (const double(*)[3])c->b->at;
  int32_t end[2] = {c->at_hand[0][0], c->at_hand[0][0]};

  for (int round = 0; round < 2; round++) {
    const double *o = at[end[0]];
    double most = -1;
    for (size_t i = 0; i < n; i++) {
      const double *p = at[c->at_hand[i][0]];
      double u[3] = {p[0] - o[0], p[1] - o[1], p[2] - o[2]};
      double size = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
      if (size > most) {
        most = size;
        end[1] = c->at_hand[i][0];
        memcpy(out, u, sizeof u);
      }
    }
    end[0] = end[1];
  }
}

static bool
line_room(cleaner *c, size_t n)
{
  return sg_list_need(&c->line, n, &c->line_room, sizeof *c->line);
}

/* Its vertices in their order along the line. If they are on one exactly, that
 * is the order of their numbers: the order by coordinates is that along any
 * line. */
static bool
order_line(cleaner *c, bool exact, size_t n, size_t *count)
{
  double direction[3] = {0};

  *count = 0;
  if (!line_room(c, 2 * n)) {
    return false;
  }
  if (!exact && n > 0) {
    find_direction(c, n, direction);
  }
  for (size_t i = 0; i < 2 * n; i++) {
    int32_t v = c->at_hand[i / 2][i % 2];
    const double *p = c->b->at[v];
    c->line[i] = (along){
        p[0] * direction[0] + p[1] * direction[1] + p[2] * direction[2], v};
  }
  if (n > 0) {
    qsort(c->line, 2 * n, sizeof *c->line, compare_along);
  }
  for (size_t i = 0; i < 2 * n; i++) {
    if (i == 0 || c->line[i].v != c->line[i - 1].v) {
      c->line[(*count)++] = c->line[i];
    }
  }
  return true;
}

static size_t
place_on_line(const cleaner *c, int32_t v)
{
  size_t i = 0;

  while (c->line[i].v != v) {
    i++;
  }
  return i;
}

/* What is on the other side of an edge of a flat face gets the vertices in
 * between. */
static bool
divide_opposite(cleaner *c, size_t face, const int32_t edge[2])
{
  size_t to = place_on_line(c, edge[0]), at = place_on_line(c, edge[1]);
  record *other = NULL;

  if (at + 1 == to || to + 1 == at ||
      !(other = opposite(c, (uint32_t)face, edge[1], edge[0]))) {
    return true; /* nothing in between, or a border */
  }
  uint32_t in = other->face;
  take_away(c, other);
  while (at != to) {
    size_t next = at < to ? at + 1 : at - 1;
    if (!add_record(c, in, c->line[at].v, c->line[next].v, NOTHING)) {
      return false;
    }
    at = next;
  }
  return true;
}

static bool
drop_face(cleaner *c, size_t face)
{
  const sg_boundary *b = c->b;
  size_t n, count;

  if (!take_in_hand(c, face, &n) ||
      !order_line(c, is_flat(b, face), n, &count)) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    if (!divide_opposite(c, face, c->at_hand[i])) {
      return false;
    }
  }
  for (uint32_t i = b->begin[face]; i < b->begin[face + 1]; i++) {
    c->gone[i] = 1;
  }
  for (uint32_t i = c->fresh[face]; i != NOTHING; i = c->item[i].next_new) {
    c->item[i].gone = true;
  }
  return true;
}

/* ---- together --------------------------------------------------------------
 */

/* The boundary again, of the edges that are left. */
static bool
rebuild(cleaner *c)
{
  sg_boundary *b = c->b;
  size_t faces = 0, room = b->begin[b->faces] + c->n;
  uint32_t *begin = malloc((b->faces + 1) * sizeof *begin), n = 0;
  int32_t(*edge)[2] = malloc((room + 1) * sizeof *edge);

  if (!begin || !edge) {
    free(begin);
    free(edge);
    return false;
  }
  begin[0] = 0;
  for (size_t f = 0; f < b->faces; f++) {
    size_t some = b->begin[f + 1] - b->begin[f];
    if (c->flat[f]) {
      continue;
    }
    if (c->fresh[f] == NOTHING) {
      memcpy(edge + n, b->edge + b->begin[f], some * sizeof *edge);
    } else if (take_in_hand(c, f, &some)) {
      memcpy(edge + n, c->at_hand, some * sizeof *edge);
    } else {
      free(begin);
      free(edge);
      return false;
    }
    n += (uint32_t)some;
    b->changed[faces] = b->changed[f] || c->fresh[f] != NOTHING;
    b->turned[faces] = SG_UPRIGHT;
    begin[++faces] = n;
  }
  free(b->begin);
  free(b->edge);
  b->begin = begin;
  b->edge = edge;
  b->faces = faces;
  return true;
}

static bool
drop_all(cleaner *c)
{
  if (!add_known_edges(c)) {
    return false;
  }
  qsort_r(c->flat_face, c->flat_faces, sizeof *c->flat_face, compare_flat,
          c->b);
  for (size_t i = 0; i < c->flat_faces; i++) {
    if (!drop_face(c, c->flat_face[i])) {
      return false;
    }
  }
  return rebuild(c);
}

bool
sg_boundary_drop_flat(sg_boundary *boundary, bool turned)
{
  cleaner c = {.b = boundary};

  sg_key_table_init(&c.like, 2);
  c.flat = malloc(boundary->faces + 1);
  c.flat_face = malloc((boundary->faces + 1) * sizeof *c.flat_face);
  c.known = calloc(boundary->vertices + 1, 1);
  c.fresh = malloc((boundary->faces + 1) * sizeof *c.fresh);
  c.gone = calloc(boundary->begin[boundary->faces] + 1u, 1);
  bool done = c.flat && c.flat_face && c.known && c.fresh && c.gone;
  if (done) {
    find_flat(&c, turned);
    done = c.flat_faces == 0 || drop_all(&c);
  }
  free(c.flat);
  free(c.flat_face);
  free(c.known);
  free(c.fresh);
  free(c.gone);
  free(c.item);
  free(c.at_hand);
  free(c.line);
  sg_key_table_clear(&c.like);
  return done;
}
