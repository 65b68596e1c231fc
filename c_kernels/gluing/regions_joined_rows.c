/* regions_joined_rows.c -- the regions of a glue when an operand goes: where
 * a polygon goes with it, the regions on its two sides become one.
 *
 * No arithmetic is needed. The numbers are those that regions.h would give.
 */
#include "cell_added_rows.h"
#include "doors/gluing.h"
#include "engine/search.h"
#include "engine/symbol.h"
#include "rows/disjoint.h"
#include "rows/sort.h"

#include <stdlib.h>
#include <string.h>

typedef struct leaver {
  sg_call *call;
  int32_t s, n; /* the glue, the operand that goes */
  const sg_int_list *gone;
  uint8_t *is_gone; /* [last of gone + 1] */
  sg_cells_part sides, region, from_r;
  int32_t last;      /* region, the outside until now */
  uint32_t *set;     /* [last + 1] regions, disjoint sets */
  int32_t *by[2];    /* [last + 1] of a root: the last polygon it is behind, or
                      * before; 0: none */
  int32_t *role;     /* [last + 1] of a root */
  int32_t *number;   /* [last + 1] from now on */
  uint64_t *content; /* [from_r.n] region << 32 | operand, ascending */
  size_t contents;
  size_t regions; /* from now on */
} leaver;

/* ---- reading ------------------------------------------------------------ */

static bool
is_gone(const leaver *l, int32_t p)
{
  return l->gone->n > 0 && p <= l->gone->at[l->gone->n - 1] && l->is_gone[p];
}

static uint32_t
root_of(const leaver *l, int32_t region)
{
  return sg_disjoint_root(l->set, (uint32_t)region);
}

static bool
make_room(leaver *l)
{
  size_t n = (size_t)l->last + 1;

  l->set = sg_call_alloc(l->call, n * sizeof *l->set);
  l->by[0] = sg_call_alloc(l->call, n * sizeof(int32_t));
  l->by[1] = sg_call_alloc(l->call, n * sizeof(int32_t));
  l->role = sg_call_alloc(l->call, n * sizeof *l->role);
  l->number = sg_call_alloc(l->call, n * sizeof *l->number);
  l->content = sg_call_alloc(l->call, (l->from_r.n + 1) * sizeof *l->content);
  size_t last = l->gone->n > 0 ? (size_t)l->gone->at[l->gone->n - 1] : 0;

  if (!(l->is_gone = sg_call_alloc(l->call, last + 1))) {
    return false;
  }
  memset(l->is_gone, 0, last + 1);
  for (size_t i = 0; i < l->gone->n; i++) {
    l->is_gone[l->gone->at[i]] = 1;
  }
  if (!l->set || !l->by[0] || !l->by[1] || !l->role || !l->number ||
      !l->content) {
    return false;
  }
  for (uint32_t r = 0; r < n; r++) {
    l->set[r] = r;
  }
  memset(l->by[0], 0, n * sizeof(int32_t));
  memset(l->by[1], 0, n * sizeof(int32_t));
  memset(l->role, 0, n * sizeof *l->role);
  return true;
}

static bool
read_rows(leaver *l, const sg_version *version)
{
  if (!sg_cells_part_read(l->call, version, SG_SIDES, l->s, &l->sides) ||
      !sg_cells_part_read(l->call, version, SG_REGION, l->s, &l->region) ||
      !sg_cells_part_read(l->call, version, SG_FROM_R, l->s, &l->from_r)) {
    return false;
  }
  for (size_t i = 0; i < l->region.n; i++) {
    int32_t r = sg_view_int(&l->region.view, 1, l->region.rows.row[i]);

    l->last = r > l->last ? r : l->last;
  }
  return make_room(l);
}

static bool
read_content(leaver *l)
{
  for (size_t i = 0; i < l->from_r.n; i++) {
    uint32_t row = l->from_r.rows.row[i];
    int32_t operand = sg_view_int(&l->from_r.view, 2, row);

    if (operand != l->n) {
      l->content[l->contents++] =
          (uint64_t)(uint32_t)sg_view_int(&l->from_r.view, 1, row) << 32 |
          (uint32_t)operand;
    }
  }
  return sg_sort(l->content, l->contents, sizeof *l->content, sg_compare_keys,
                 &l->call->cancel) == SG_SORTED ||
         sg_call_ended(l->call);
}

/* ---- what becomes one --------------------------------------------------- */

/* Where the operands begin that region r is inside. */
static size_t
content_of(const leaver *l, uint32_t r)
{
  size_t at;

  SG_SEARCH(at, 0, l->contents, l->content[at] >> 32 < r);
  return at;
}

/* Whether two regions are inside the same operands, but for the one that goes.
 */
static bool
same_content(const leaver *l, uint32_t a, uint32_t b)
{
  size_t i = content_of(l, a), k = content_of(l, b);

  for (;; i++, k++) {
    bool more = i < l->contents && l->content[i] >> 32 == a;

    if (more != (k < l->contents && l->content[k] >> 32 == b)) {
      return false;
    }
    if (!more) {
      return true;
    }
    if ((uint32_t)l->content[i] != (uint32_t)l->content[k]) {
      return false;
    }
  }
}

/* False: what becomes one is inside different operands, or a slit. */
static bool
find_roles(leaver *l)
{
  for (size_t i = 0; i < l->region.n; i++) {
    uint32_t row = l->region.rows.row[i];
    int32_t r = sg_view_int(&l->region.view, 1, row);
    int32_t was = sg_view_int(&l->region.view, 2, row);
    uint32_t root = root_of(l, r);
    size_t at = content_of(l, root);
    bool inside = at < l->contents && l->content[at] >> 32 == root;

    if (was == SG_SYMBOL_SLIT || !same_content(l, root, (uint32_t)r)) {
      return false;
    }
    l->role[root] =
        was == SG_SYMBOL_OUTSIDE || l->role[root] == SG_SYMBOL_OUTSIDE
            ? SG_SYMBOL_OUTSIDE
        : inside ? SG_SYMBOL_CELL
                 : SG_SYMBOL_VOID;
  }
  return true;
}

static void
join_regions(leaver *l)
{
  for (size_t i = 0; i < l->sides.n; i++) {
    uint32_t row = l->sides.rows.row[i];

    if (is_gone(l, sg_view_int(&l->sides.view, 1, row))) {
      sg_disjoint_join(l->set, (uint32_t)sg_view_int(&l->sides.view, 2, row),
                       (uint32_t)sg_view_int(&l->sides.view, 3, row));
    }
  }
  for (size_t i = 0; i < l->sides.n; i++) {
    uint32_t row = l->sides.rows.row[i];
    int32_t p = sg_view_int(&l->sides.view, 1, row);

    for (unsigned k = 0; k < 2 && !is_gone(l, p); k++) {
      int32_t *by =
          &l->by[k][root_of(l, sg_view_int(&l->sides.view, 2 + k, row))];

      *by = p > *by ? p : *by;
    }
  }
}

/* The bounded ones by the last polygon that each is behind, or else before;
 * the outside last. */
static bool
number_regions(leaver *l)
{
  uint64_t *key = sg_call_alloc(l->call, ((size_t)l->last + 1) * sizeof *key);
  uint32_t outside = 0;
  size_t n = 0;

  if (!key) {
    return false;
  }
  for (uint32_t r = 1; r <= (uint32_t)l->last; r++) {
    if (l->set[r] == r && l->role[r] == SG_SYMBOL_OUTSIDE) {
      outside = r;
    } else if (l->set[r] == r) {
      bool behind = l->by[0][r] > 0;
      uint32_t p = (uint32_t)l->by[behind ? 0 : 1][r];

      if (p == 0) {
        return false; /* nothing bounds it */
      }
      key[n++] = (uint64_t)(2 * (p - 1) + !behind) << 32 | r;
    }
  }
  if (sg_sort(key, n, sizeof *key, sg_compare_keys, &l->call->cancel) !=
      SG_SORTED) {
    return sg_call_ended(l->call);
  }
  for (size_t i = 0; i < n; i++) {
    l->number[(uint32_t)key[i]] = (int32_t)i + 1;
  }
  l->number[outside] = (int32_t)n + 1;
  l->regions = n + 1;
  for (int32_t r = 1; r <= l->last; r++) {
    l->number[r] = l->number[root_of(l, r)];
  }
  return outside != 0;
}

/* ---- writing ------------------------------------------------------------ */

/* Rows of one relation that are exchanged. */
typedef struct exchange {
  sg_relation relation;
  sg_row *gone;
  size_t gones;
  int32_t *column[4];
  size_t n;
} exchange;

static bool
exchange_open(leaver *l, sg_relation relation, size_t n, exchange *out)
{
  *out = (exchange){.relation = relation,
                    .gone = sg_call_alloc(l->call, (n + 1) * sizeof(sg_row))};
  for (int k = 0; k < 4; k++) {
    out->column[k] = sg_call_alloc(l->call, (n + 1) * sizeof(int32_t));
    if (!out->column[k]) {
      return false;
    }
  }
  return out->gone != NULL;
}

static void
exchange_add(exchange *to, const int32_t value[4])
{
  for (int k = 0; k < 4; k++) {
    to->column[k][to->n] = value[k];
  }
  to->n++;
}

static bool
exchange_done(leaver *l, sg_world *world, const exchange *all)
{
  const void *column[4] = {all->column[0], all->column[1], all->column[2],
                           all->column[3]};

  return sg_world_exchange(world, all->relation, all->gone, all->gones, all->n,
                           column) ||
         sg_call_no_memory(l->call);
}

static bool
write_sides(leaver *l, sg_world *world)
{
  exchange all;

  if (!exchange_open(l, SG_SIDES, l->sides.n, &all)) {
    return false;
  }
  for (size_t i = 0; i < l->sides.n; i++) {
    uint32_t row = l->sides.rows.row[i];
    int32_t p = sg_view_int(&l->sides.view, 1, row);
    int32_t was[2] = {sg_view_int(&l->sides.view, 2, row),
                      sg_view_int(&l->sides.view, 3, row)};
    int32_t now[2] = {l->number[was[0]], l->number[was[1]]};
    bool goes = is_gone(l, p);

    if (goes || now[0] != was[0] || now[1] != was[1]) {
      all.gone[all.gones++] = row;
      if (!goes) {
        exchange_add(&all, (int32_t[]){l->s, p, now[0], now[1]});
      }
    }
  }
  return exchange_done(l, world, &all);
}

static bool
write_region(leaver *l, sg_world *world)
{
  int32_t *role = sg_call_alloc(l->call, (l->regions + 1) * sizeof *role);
  exchange all;

  if (!role || !exchange_open(l, SG_REGION, l->region.n, &all)) {
    return false;
  }
  for (uint32_t r = 1; r <= (uint32_t)l->last; r++) {
    if (l->set[r] == r) {
      role[l->number[r]] = l->role[r];
    }
  }
  for (size_t i = 0; i < l->region.n; i++) {
    uint32_t row = l->region.rows.row[i];
    int32_t r = sg_view_int(&l->region.view, 1, row);
    bool stays = (size_t)r <= l->regions;

    if (!stays || sg_view_int(&l->region.view, 2, row) != role[r]) {
      all.gone[all.gones++] = row;
      if (stays) {
        exchange_add(&all, (int32_t[]){l->s, r, role[r], 0});
      }
    }
  }
  return exchange_done(l, world, &all);
}

static bool
write_content(leaver *l, sg_world *world)
{
  exchange all;

  if (!exchange_open(l, SG_FROM_R, l->from_r.n, &all)) {
    return false;
  }
  for (size_t i = 0; i < l->from_r.n; i++) {
    uint32_t row = l->from_r.rows.row[i];
    int32_t r = sg_view_int(&l->from_r.view, 1, row), now = l->number[r];
    int32_t operand = sg_view_int(&l->from_r.view, 2, row);
    bool stays = operand != l->n && l->set[r] == (uint32_t)r;

    if (!stays || now != r) {
      all.gone[all.gones++] = row;
      if (stays) {
        exchange_add(&all, (int32_t[]){l->s, now, operand,
                                       sg_view_int(&l->from_r.view, 3, row)});
      }
    }
  }
  return exchange_done(l, world, &all);
}

static bool
write_all(leaver *l)
{
  sg_world *world = sg_call_claim(l->call);
  bool good = world && write_sides(l, world) && write_region(l, world) &&
              write_content(l, world);

  if (world) {
    sg_world_release(world);
  }
  return good;
}

bool
sg_door_regions_joined(sg_call *call, int32_t s, int32_t n,
                       const sg_int_list *polygons)
{
  leaver l = {.call = call, .s = s, .n = n, .gone = polygons};
  const sg_version *version = sg_call_version(call);
  bool good = version && read_rows(&l, version) && read_content(&l);

  if (good) {
    join_regions(&l);
  }
  good = good && find_roles(&l) && number_regions(&l) && write_all(&l);
  sg_cells_part_clear(&l.sides);
  sg_cells_part_clear(&l.region);
  sg_cells_part_clear(&l.from_r);
  return good;
}
