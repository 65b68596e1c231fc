/* resolve.c -- making things touch: the contacts. See resolve.h; what follows
 * from them is in resolve_point.c. */
#include "resolve.h"

#include "number/vector.h"

#include <stdlib.h>
#include <string.h>

void
sg_resolve_init(sg_resolve *r, double reach, sg_is_real_side *is_real,
                void *data, const sg_cancel *cancel)
{
  *r = (sg_resolve){.reach = reach,
                    .here = reach,
                    .explained = reach,
                    .cancel = cancel,
                    .is_real = is_real,
                    .data = data};
  sg_key_table_init(&r->segment, 1);
  sg_key_table_init(&r->known, 3);
  sg_key_table_init(&r->node_number, 6);
  sg_key_table_init(&r->seen, 4);
  sg_key_table_init(&r->place_number, 2);
}

void
sg_resolve_clear(sg_resolve *r)
{
  sg_key_table_clear(&r->segment);
  sg_key_table_clear(&r->known);
  sg_key_table_clear(&r->node_number);
  sg_key_table_clear(&r->seen);
  sg_key_table_clear(&r->place_number);
  free(r->group.item);
  free(r->inexact.item);
  free(r->contacts.item);
  free(r->contact.item);
  free(r->node.item);
  free(r->touch.item);
  free(r->near.item);
  free(r->join.item);
  free(r->edge.item);
  free(r->sided);
  free(r->point.item);
  free(r->place.item);
  free(r->split.item);
  free(r->seam.item);
}

/* ---- connected segments ---- */

static uint32_t
segment_root(const sg_resolve *r, uint32_t i)
{
  while (r->group.item[i] != i) {
    i = r->group.item[i];
  }
  return i;
}

/* The number of segment s, SG_NO_KEY: no memory. */
static uint32_t
segment_number(sg_resolve *r, int32_t s)
{
  uint32_t key = (uint32_t)s;
  uint32_t *number = sg_key_table_put(&r->segment, &key);

  if (number && *number == SG_NO_KEY) {
    uint32_t fresh = (uint32_t)r->group.n;
    if (!SG_PUSH(r->group, fresh) || !SG_PUSH(r->inexact, false)) {
      return SG_NO_KEY;
    }
    *number = fresh;
  }
  return number ? *number : SG_NO_KEY;
}

/* Two segments touch. False: no memory. */
static bool
group(sg_resolve *r, int32_t s, int32_t other, bool inexact)
{
  uint32_t i = segment_number(r, s), j = segment_number(r, other);

  if (i == SG_NO_KEY || j == SG_NO_KEY) {
    return false;
  }
  i = segment_root(r, i);
  j = segment_root(r, j);
  r->group.item[i < j ? j : i] = i < j ? i : j;
  r->inexact.item[i < j ? i : j] |= inexact || r->inexact.item[i < j ? j : i];
  return true;
}

bool
sg_resolve_touch_exactly(sg_resolve *r, int32_t s, int32_t other)
{
  return group(r, s, other, false);
}

/* Two segments are known to be in one group that is to be resolved: what else
 * they have in common changes nothing of that. */
static bool
are_inexact(const sg_resolve *r, int32_t s, int32_t other)
{
  uint32_t key[2] = {(uint32_t)s, (uint32_t)other};
  uint32_t i = sg_key_table_get(&r->segment, &key[0]);
  uint32_t j = sg_key_table_get(&r->segment, &key[1]);

  return i != SG_NO_KEY && j != SG_NO_KEY &&
         segment_root(r, i) == segment_root(r, j) &&
         r->inexact.item[segment_root(r, i)];
}

bool
sg_resolve_see(sg_resolve *r, const sg_resolve_leaf *a,
               const sg_resolve_leaf *b)
{
  sg_contact contact[SG_CONTACT_MAX];
  bool known = are_inexact(r, a->s, b->s), inexact = false;
  int n = known ? sg_contacts_near(a->at, b->at, r->here, contact)
                : sg_contacts(a->at, b->at, r->here, contact);

  if (!SG_PUSH(r->contacts, (uint8_t)n)) {
    return false;
  }
  for (int i = 0; i < n; i++) {
    inexact = inexact || !contact[i].exact;
    if (!SG_PUSH(r->contact, contact[i])) {
      return false;
    }
  }
  return n == 0 || known || group(r, a->s, b->s, inexact);
}

bool
sg_resolve_is_needed(const sg_resolve *r)
{
  for (size_t i = 0; i < r->inexact.n; i++) {
    if (r->inexact.item[i]) {
      return true;
    }
  }
  return false;
}

static bool
is_wanted(const sg_resolve *r, int32_t s)
{
  uint32_t key = (uint32_t)s;
  uint32_t number = sg_key_table_get(&r->segment, &key);

  return number != SG_NO_KEY && r->inexact.item[segment_root(r, number)];
}

/* ---- what a contact's features are ---- */

/* A feature by ids: vertex v[0]; edge v[0] < v[1]; or the polygon of the
 * leaf. */
typedef struct place {
  enum { AT_VERTEX, AT_EDGE, AT_FACE } kind;
  int32_t v[2];
  int corner[2]; /* of the leaf, as v */
} place;

/* Side i of the leaf. 1: a real edge, 0: a chord, -1: no memory. */
static int
side_of(sg_resolve *r, const sg_resolve_leaf *leaf, int i, place *out)
{
  int a = i, b = (i + 1) % 3;

  if (leaf->v[a] > leaf->v[b]) {
    a = b;
    b = i;
  }
  *out = (place){AT_EDGE, {leaf->v[a], leaf->v[b]}, {a, b}};
  uint32_t *known = sg_key_table_put(
      &r->known, (uint32_t[3]){(uint32_t)leaf->s, (uint32_t)out->v[0],
                               (uint32_t)out->v[1]});

  if (!known) {
    return -1;
  }
  if (*known == SG_NO_KEY) {
    int real = r->is_real(r->data, leaf->triangle, i);
    if (real < 0 ||
        (real &&
         !SG_PUSH(r->edge, (sg_resolve_split){.s = leaf->s,
                                              .v = {out->v[0], out->v[1]}}))) {
      return -1;
    }
    *known = (uint32_t)real;
  }
  return (int)*known;
}

/* A chord is part of the face. False: no memory. */
static bool
place_of(sg_resolve *r, const sg_resolve_leaf *leaf, sg_feature f, place *out)
{
  *out = (place){.kind = AT_FACE};
  if (f <= SG_CORNER_2) {
    *out = (place){AT_VERTEX, {leaf->v[f], 0}, {(int)f, 0}};
  } else if (f <= SG_EDGE_2) {
    int real = side_of(r, leaf, (int)(f - SG_EDGE_0), out);
    if (real <= 0) {
      *out = (place){.kind = AT_FACE};
    }
    return real >= 0;
  }
  return true;
}

/* ---- keeping them ---- */

/* The node of this key, made if it is new; SG_NO_KEY: no memory. */
static uint32_t
node_of(sg_resolve *r, const sg_resolve_node *node)
{
  uint32_t key[6] = {(uint32_t)node->s, (uint32_t)node->v, 0, 0, 0, 0};

  if (node->v == 0) {
    memcpy(key, node->line, sizeof key);
  }
  uint32_t *number = sg_key_table_put(&r->node_number, key);

  if (number && *number == SG_NO_KEY) {
    uint32_t fresh = (uint32_t)r->node.n;
    if (!SG_PUSH(r->node, *node)) {
      return SG_NO_KEY;
    }
    r->node.item[fresh].root = r->node.item[fresh].next = fresh;
    r->node.item[fresh].side = r->side;
    *number = fresh;
  }
  if (number) {
    sg_resolve_node *known = &r->node.item[*number];
    known->side = fmin(known->side, r->side);
    known->reach = fmax(known->reach, r->here);
    known->rounding = fmax(known->rounding, r->rounding);
  }
  return number ? *number : SG_NO_KEY;
}

static uint32_t
vertex_node(sg_resolve *r, const sg_resolve_leaf *leaf, int corner)
{
  sg_resolve_node node = {.s = leaf->s, .v = leaf->v[corner]};

  memcpy(node.at, leaf->at[corner], sizeof node.at);
  return node_of(r, &node);
}

/* How far along the edge of the leaf `at` is. */
static void
set_along(sg_resolve_touch *touch, const sg_resolve_leaf *leaf,
          const place *edge, const double at[3])
{
  const double *a = leaf->at[edge->corner[0]], *b = leaf->at[edge->corner[1]];
  double square = 0;

  for (int k = 0; k < 3; k++) {
    touch->step[k] = b[k] - a[k];
    square += touch->step[k] * touch->step[k];
  }
  for (int k = 0; k < 3; k++) {
    touch->step[k] /= square;
    touch->along += (at[k] - a[k]) * touch->step[k];
  }
}

/* Notes how far a node is from what it is to touch. */
static void
note_gap(sg_resolve *r, uint32_t node, double apart)
{
  double *gap = &r->node.item[node].gap;

  if (apart > r->explained && apart > *gap) {
    *gap = apart;
  }
}

/* Notes that a node is on the edge or face `where` of the leaf. */
static bool
add_touch(sg_resolve *r, uint32_t node, const sg_resolve_leaf *leaf,
          const place *where, double apart)
{
  bool face = where->kind == AT_FACE;
  uint32_t key[4] = {node, (uint32_t)leaf->s,
                     (uint32_t)(face ? 0 : where->v[0]),
                     (uint32_t)(face ? leaf->p : where->v[1])};
  uint32_t *seen = sg_key_table_put(&r->seen, key);

  note_gap(r, node, apart);
  if (!seen || *seen != SG_NO_KEY) {
    return seen != NULL;
  }
  *seen = 0;
  sg_resolve_touch touch = {
      .node = node, .s = leaf->s, .p = face ? leaf->p : 0, .apart = apart};
  if (!face) {
    touch.v[0] = where->v[0];
    touch.v[1] = where->v[1];
    set_along(&touch, leaf, where, r->node.item[node].at);
  }
  return SG_PUSH(r->touch, touch);
}

/* Notes that a node is at the polygons of both leaves. */
static bool
add_near(sg_resolve *r, uint32_t node, const sg_resolve_leaf *leaf[2])
{
  return SG_PUSH(r->near, (sg_resolve_near){node, leaf[0]->s, leaf[0]->p}) &&
         SG_PUSH(r->near, (sg_resolve_near){node, leaf[1]->s, leaf[1]->p});
}

static bool
add_join(sg_resolve *r, uint32_t a, uint32_t b, double apart)
{
  note_gap(r, a, apart);
  note_gap(r, b, apart);
  return SG_PUSH(r->join, (struct sg_resolve_join){a, b, apart});
}

/* Two vertices. */
static bool
keep_join(sg_resolve *r, const sg_resolve_leaf *leaf[2], const place where[2],
          double apart)
{
  uint32_t a = vertex_node(r, leaf[0], where[0].corner[0]);
  uint32_t b =
      a == SG_NO_KEY ? SG_NO_KEY : vertex_node(r, leaf[1], where[1].corner[0]);

  return b != SG_NO_KEY && add_near(r, a, leaf) && add_near(r, b, leaf) &&
         add_join(r, a, b, apart);
}

/* Two edges. */
static bool
keep_crossing(sg_resolve *r, const sg_resolve_leaf *leaf[2],
              const place where[2], const sg_contact *contact)
{
  int first = leaf[0]->s < leaf[1]->s ? 0 : 1;
  sg_resolve_node node = {0};

  for (int k = 0; k < 2; k++) {
    int from = k == 0 ? first : !first;
    node.leaf[k] = leaf[from]->triangle;
    node.line[k][0] = leaf[from]->s;
    node.line[k][1] = where[from].v[0];
    node.line[k][2] = where[from].v[1];
  }
  memcpy(node.at, contact->at, sizeof node.at);
  uint32_t number = node_of(r, &node);

  return number != SG_NO_KEY &&
         add_touch(r, number, leaf[0], &where[0], contact->distance) &&
         add_touch(r, number, leaf[1], &where[1], contact->distance) &&
         add_near(r, number, leaf);
}

/* A vertex of leaf k and an edge or face of the other. */
static bool
keep_touch(sg_resolve *r, const sg_resolve_leaf *leaf[2], const place where[2],
           int k, double apart)
{
  uint32_t node = vertex_node(r, leaf[k], where[k].corner[0]);

  return node != SG_NO_KEY && add_touch(r, node, leaf[!k], &where[!k], apart) &&
         add_near(r, node, leaf);
}

static bool
keep(sg_resolve *r, const sg_resolve_leaf *leaf[2], const sg_contact *contact)
{
  place where[2];

  for (int k = 0; k < 2; k++) {
    if (!place_of(r, leaf[k], contact->f[k], &where[k])) {
      return false;
    }
  }
  bool vertex[2] = {where[0].kind == AT_VERTEX, where[1].kind == AT_VERTEX};

  if (vertex[0] && vertex[1]) {
    return keep_join(r, leaf, where, contact->distance);
  }
  if (vertex[0] || vertex[1]) {
    return keep_touch(r, leaf, where, vertex[0] ? 0 : 1, contact->distance);
  }
  return where[0].kind != AT_EDGE || where[1].kind != AT_EDGE ||
         keep_crossing(r, leaf, where, contact);
}

static double
shortest_side(const sg_resolve_leaf *leaf)
{
  double shortest = INFINITY;

  for (int i = 0; i < 3; i++) {
    double side[3];
    sg_minus(leaf->at[(i + 1) % 3], leaf->at[i], side);
    shortest = fmin(shortest, sg_length(side));
  }
  return shortest;
}

/* All real edges of a leaf are in r->edge: see spans. False: no memory. */
static bool
know_sides(sg_resolve *r, const sg_resolve_leaf *leaf)
{
  place side;

  if (!sg_list_need_zeroed(&r->sided, leaf->triangle + (size_t)1, &r->side_room,
                           sizeof *r->sided)) {
    return false;
  }
  for (int i = 0; i < 3 && !r->sided[leaf->triangle]; i++) {
    if (side_of(r, leaf, i, &side) < 0) {
      return false;
    }
  }
  r->sided[leaf->triangle] = 1;
  return true;
}

/* Keeps n contacts of a pair. */
static bool
keep_all(sg_resolve *r, const sg_resolve_leaf *a, const sg_resolve_leaf *b,
         const sg_contact *contact, int n)
{
  const sg_resolve_leaf *leaf[2] = {a, b};

  r->side = n > 0 ? fmin(shortest_side(a), shortest_side(b)) : 0;
  for (int i = 0; i < n; i++) {
    if (!keep(r, leaf, &contact[i])) {
      return false;
    }
  }
  return n == 0 || (know_sides(r, a) && know_sides(r, b));
}

bool
sg_resolve_pair(sg_resolve *r, const sg_resolve_leaf *a,
                const sg_resolve_leaf *b)
{
  sg_contact contact[SG_CONTACT_MAX];
  int n =
      is_wanted(r, a->s) ? sg_contacts_near(a->at, b->at, r->here, contact) : 0;

  return keep_all(r, a, b, contact, n);
}

bool
sg_resolve_seen_pair(sg_resolve *r, const sg_resolve_leaf *a,
                     const sg_resolve_leaf *b)
{
  int n = r->contacts.item[r->pairs_kept++];
  const sg_contact *contact = r->contact.item + r->contacts_kept;

  r->contacts_kept += (size_t)n;
  return keep_all(r, a, b, contact, is_wanted(r, a->s) ? n : 0);
}

bool
sg_resolve_crossing(sg_resolve *r, uint32_t i, const sg_resolve_leaf *leaf)
{
  const sg_resolve_node *node = &r->node.item[i];
  sg_contact contact;
  place where;

  if (leaf->s == node->line[0][0] || leaf->s == node->line[1][0] ||
      !is_wanted(r, leaf->s) ||
      !sg_contact_point(node->at, leaf->at, r->here, &contact)) {
    return true;
  }
  r->side = shortest_side(leaf);
  if (!place_of(r, leaf, contact.f[1], &where) ||
      !SG_PUSH(r->near, (sg_resolve_near){i, leaf->s, leaf->p})) {
    return false;
  }
  if (where.kind != AT_VERTEX) {
    return add_touch(r, i, leaf, &where, contact.distance);
  }
  uint32_t vertex = vertex_node(r, leaf, where.corner[0]);

  return vertex != SG_NO_KEY && add_join(r, i, vertex, contact.distance);
}
