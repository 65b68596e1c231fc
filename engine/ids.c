/* ids.c -- entries on leaves, leaves in a directory. */
#include "ids.h"
#include "search.h"

#include <stdlib.h>
#include <string.h>

enum { LEAF_ENTRIES = 32 };

typedef struct leaf {
  uint32_t holders;
  uint32_t count;
  sg_ids_entry of[LEAF_ENTRIES]; /* [count], by segment */
} leaf;

struct sg_ids {
  uint32_t holders;
  size_t count, room;
  leaf *leaf[]; /* [count], by their first segments; none is empty */
};

sg_ids *
sg_ids_hold(sg_ids *ids)
{
  if (ids) {
    ids->holders++;
  }
  return ids;
}

static void
leaf_drop(leaf *l)
{
  if (--l->holders == 0) {
    free(l);
  }
}

void
sg_ids_drop(sg_ids *ids)
{
  if (!ids || --ids->holders > 0) {
    return;
  }
  for (size_t i = 0; i < ids->count; i++) {
    leaf_drop(ids->leaf[i]);
  }
  free(ids);
}

/* ---- finding ----------------------------------------------------------- */

/* The last leaf that begins with s or before; 0 if none does. */
static size_t
leaf_of(const sg_ids *ids, int32_t s)
{
  size_t next;

  SG_SEARCH(next, 1, ids->count, ids->leaf[next]->of[0].s <= s);
  return next - 1;
}

/* The first entry that is not before s. */
static uint32_t
place_of(const leaf *l, int32_t s)
{
  size_t at;

  SG_SEARCH(at, 0, l->count, l->of[at].s < s);
  return (uint32_t)at;
}

static bool
is_at(const leaf *l, uint32_t place, int32_t s)
{
  return place < l->count && l->of[place].s == s;
}

const sg_ids_entry *
sg_ids_find(const sg_ids *ids, int32_t s)
{
  const leaf *l = ids ? ids->leaf[leaf_of(ids, s)] : NULL;
  uint32_t place = l ? place_of(l, s) : 0;

  return l && is_at(l, place, s) ? &l->of[place] : NULL;
}

/* ---- owning ------------------------------------------------------------ */

static leaf *
leaf_own(leaf **l)
{
  leaf *old = *l, *owned;

  if (old->holders == 1) {
    return old;
  }
  if (!(owned = malloc(sizeof *owned))) {
    return NULL;
  }
  *owned = *old;
  owned->holders = 1;
  leaf_drop(old);
  *l = owned;
  return owned;
}

/* A directory of its own with room for one leaf more. Null: no memory. */
static sg_ids *
directory_own(sg_ids **ids)
{
  sg_ids *old = *ids, *owned;
  size_t count = old ? old->count : 0;
  size_t room = count + count / 4 + 1;

  if (old && old->holders == 1 && count < old->room) {
    return old;
  }
  if (!(owned = malloc(sizeof *owned + room * sizeof owned->leaf[0]))) {
    return NULL;
  }
  *owned = (sg_ids){.holders = 1, .count = count, .room = room};
  for (size_t i = 0; i < count; i++) {
    owned->leaf[i] = old->leaf[i];
    owned->leaf[i]->holders++;
  }
  sg_ids_drop(old);
  return *ids = owned;
}

/* ---- new entries ------------------------------------------------------- */

/* An empty leaf at `place` of a directory that has room. */
static leaf *
leaf_insert(sg_ids *ids, size_t place)
{
  leaf *fresh = malloc(sizeof *fresh);

  if (fresh) {
    fresh->holders = 1;
    fresh->count = 0;
    memmove(&ids->leaf[place + 1], &ids->leaf[place],
            (ids->count - place) * sizeof ids->leaf[0]);
    ids->leaf[place] = fresh;
    ids->count++;
  }
  return fresh;
}

/* Entries from `from` on of leaf i, which is full and owned, go to a new leaf
 * behind it. */
static bool
split(sg_ids *ids, size_t i, uint32_t from)
{
  leaf *l = ids->leaf[i], *fresh = leaf_insert(ids, i + 1);

  if (fresh) {
    fresh->count = l->count - from;
    memcpy(fresh->of, &l->of[from], fresh->count * sizeof l->of[0]);
    l->count = from;
  }
  return fresh != NULL;
}

/* The leaf, owned, in which a new entry of s will stand; there is room. */
static leaf *
leaf_for(sg_ids *ids, int32_t s)
{
  size_t i = ids->count > 0 ? leaf_of(ids, s) : 0;
  leaf *l;

  if (ids->count == 0) {
    return leaf_insert(ids, 0);
  }
  if (!(l = leaf_own(&ids->leaf[i])) || l->count < LEAF_ENTRIES) {
    return l;
  }
  if (i + 1 == ids->count && s > l->of[LEAF_ENTRIES - 1].s) {
    return leaf_insert(ids, i + 1); /* ascending segments fill their leaves */
  }
  if (!split(ids, i, LEAF_ENTRIES / 2)) {
    return NULL;
  }
  return ids->leaf[s < ids->leaf[i + 1]->of[0].s ? i : i + 1];
}

/* A directory never stays without a leaf. */
static sg_ids_entry *
insert(sg_ids **ids, int32_t s)
{
  sg_ids *owned = directory_own(ids);
  leaf *l = owned ? leaf_for(owned, s) : NULL;
  uint32_t place;

  if (!l) {
    if (owned && owned->count == 0) {
      sg_ids_drop(owned);
      *ids = NULL;
    }
    return NULL;
  }
  place = place_of(l, s);
  memmove(&l->of[place + 1], &l->of[place],
          (l->count - place) * sizeof l->of[0]);
  l->of[place] = (sg_ids_entry){.s = s};
  l->count++;
  return &l->of[place];
}

sg_ids_entry *
sg_ids_reach(sg_ids **ids, int32_t s)
{
  sg_ids *owned;
  leaf *l;

  if (!sg_ids_find(*ids, s)) {
    return insert(ids, s);
  }
  if ((*ids)->holders > 1 && !directory_own(ids)) {
    return NULL;
  }
  owned = *ids;
  l = leaf_own(&owned->leaf[leaf_of(owned, s)]);
  return l ? &l->of[place_of(l, s)] : NULL;
}

/* ---- all of them ------------------------------------------------------- */

bool
sg_ids_narrow(const sg_ids *ids, const int32_t *s, size_t n, sg_ids **out)
{
  *out = NULL;
  for (size_t i = 0; i < n; i++) {
    const sg_ids_entry *entry = sg_ids_find(ids, s[i]);
    sg_ids_entry *copy = entry ? sg_ids_reach(out, s[i]) : NULL;
    if (entry && !copy) {
      sg_ids_drop(*out);
      *out = NULL;
      return false;
    }
    if (copy) {
      *copy = *entry;
    }
  }
  return true;
}

bool
sg_ids_stamp_all(sg_ids **ids, uint64_t stamp)
{
  sg_ids *owned = *ids ? directory_own(ids) : NULL;

  for (size_t i = 0; owned && i < owned->count; i++) {
    leaf *l = leaf_own(&owned->leaf[i]);
    for (uint32_t k = 0; l && k < l->count; k++) {
      l->of[k].stamp = stamp;
    }
    if (!l) {
      return false;
    }
  }
  return owned || !*ids;
}

uint64_t
sg_ids_last_stamp(const sg_ids *ids)
{
  uint64_t last = 0;

  for (size_t i = 0; ids && i < ids->count; i++) {
    for (uint32_t k = 0; k < ids->leaf[i]->count; k++) {
      uint64_t stamp = ids->leaf[i]->of[k].stamp;
      last = stamp > last ? stamp : last;
    }
  }
  return last;
}

double
sg_ids_share(const sg_ids *ids)
{
  double bytes = 0;

  if (!ids) {
    return 0;
  }
  for (size_t i = 0; i < ids->count; i++) {
    bytes += (double)sizeof(leaf) / ids->leaf[i]->holders;
  }
  return (bytes + (double)sizeof *ids +
          (double)(ids->room * sizeof ids->leaf[0])) /
         ids->holders;
}

bool
sg_ids_is_valid(const sg_ids *ids)
{
  int64_t before = INT64_MIN;

  if (ids && (ids->count == 0 || ids->count > ids->room)) {
    return false;
  }
  for (size_t i = 0; ids && i < ids->count; i++) {
    const leaf *l = ids->leaf[i];
    if (l->count == 0 || l->count > LEAF_ENTRIES) {
      return false;
    }
    for (uint32_t k = 0; k < l->count; k++) {
      if (l->of[k].s <= before) {
        return false;
      }
      before = l->of[k].s;
    }
  }
  return true;
}
