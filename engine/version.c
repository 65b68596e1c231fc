/* version.c -- maps: which rows of a table one version shows. */
#include "search.h"
#include "table.h"

#include <stdlib.h>
#include <string.h>

const sg_live *
sg_map_live(const sg_map *map, size_t page)
{
  size_t c = page / SG_CHUNK_PAGES;

  if (!map || c >= map->chunks || !map->chunk[c]) {
    return NULL;
  }
  return map->chunk[c]->live[page % SG_CHUNK_PAGES];
}

bool
sg_map_shows(const sg_map *map, sg_row row)
{
  const sg_live *live = sg_map_live(map, row / SG_PAGE_ROWS);

  return live && (live->word[row % SG_PAGE_ROWS / 64] >> row % 64 & 1);
}

sg_map *
sg_map_hold(sg_map *map)
{
  if (map) {
    map->holders++;
  }
  return map;
}

static void
live_drop(sg_live *live)
{
  if (live && --live->holders == 0) {
    free(live);
  }
}

static void
chunk_drop(sg_chunk *chunk)
{
  if (!chunk || --chunk->holders > 0) {
    return;
  }
  for (size_t i = 0; i < SG_CHUNK_PAGES; i++) {
    live_drop(chunk->live[i]);
  }
  free(chunk);
}

void
sg_map_drop(sg_map *map)
{
  if (!map || --map->holders > 0) {
    return;
  }
  for (size_t i = 0; i < map->chunks; i++) {
    chunk_drop(map->chunk[i]);
  }
  sg_ids_drop(map->ids);
  free(map->chunk);
  free(map);
}

static sg_map *
map_copy(const sg_map *map)
{
  sg_map *copy = malloc(sizeof(*copy));

  if (!copy) {
    return NULL;
  }
  *copy = *map;
  copy->holders = 1;
  copy->chunk = malloc((map->chunks + 1) * sizeof(sg_chunk *));
  if (!copy->chunk) {
    free(copy);
    return NULL;
  }
  for (size_t i = 0; i < map->chunks; i++) {
    copy->chunk[i] = map->chunk[i];
    if (copy->chunk[i]) {
      copy->chunk[i]->holders++;
    }
  }
  sg_ids_hold(copy->ids);
  return copy;
}

sg_map *
sg_map_own(sg_map **map)
{
  sg_map *old = *map;
  sg_map *owned;

  if (old && old->holders == 1) {
    return old;
  }
  owned = old ? map_copy(old) : calloc(1, sizeof(*owned));
  if (!owned) {
    return NULL;
  }
  owned->holders = 1;
  sg_map_drop(old);
  return *map = owned;
}

static bool
map_reach(sg_map *map, size_t chunk)
{
  sg_chunk **more;
  size_t room = 1;

  if (chunk < map->chunks) {
    return true;
  }
  while (room <= chunk) {
    room *= 2;
  }
  if (!(more = realloc(map->chunk, (room + 1) * sizeof(sg_chunk *)))) {
    return false;
  }
  for (size_t i = map->chunks; i < room; i++) {
    more[i] = NULL;
  }
  map->chunk = more;
  map->chunks = room;
  return true;
}

static sg_chunk *
chunk_own(sg_chunk **chunk)
{
  sg_chunk *old = *chunk;
  sg_chunk *owned;

  if (old && old->holders == 1) {
    return old;
  }
  if (!(owned = calloc(1, sizeof(*owned)))) {
    return NULL;
  }
  if (old) {
    *owned = *old;
    for (size_t i = 0; i < SG_CHUNK_PAGES; i++) {
      if (owned->live[i]) {
        owned->live[i]->holders++;
      }
    }
    chunk_drop(old);
  }
  owned->holders = 1;
  return *chunk = owned;
}

sg_live *
sg_map_own_live(sg_map *map, sg_page *page, size_t number)
{
  sg_chunk *chunk;
  sg_live **live;
  sg_live *owned;

  if (!map_reach(map, number / SG_CHUNK_PAGES) ||
      !(chunk = chunk_own(&map->chunk[number / SG_CHUNK_PAGES]))) {
    return NULL;
  }
  live = &chunk->live[number % SG_CHUNK_PAGES];
  if (*live && (*live)->holders == 1) {
    return *live;
  }
  if (!(owned = calloc(1, sizeof(*owned)))) {
    return NULL;
  }
  if (*live) {
    memcpy(owned->word, (*live)->word, sizeof(owned->word));
    live_drop(*live);
  }
  owned->holders = 1;
  owned->page = page;
  return *live = owned;
}

void
sg_map_empty_page(sg_map *map, size_t number)
{
  sg_live **live =
      &map->chunk[number / SG_CHUNK_PAGES]->live[number % SG_CHUNK_PAGES];

  live_drop(*live);
  *live = NULL;
}

int32_t
sg_map_last_id(const sg_map *map, int32_t s)
{
  const sg_ids_entry *entry = map ? sg_ids_find(map->ids, s) : NULL;

  return entry ? entry->last : 0;
}

bool
sg_map_used_id(sg_map *map, int32_t s, int32_t id)
{
  sg_ids_entry *entry;

  if (sg_map_last_id(map, s) >= id) {
    return true;
  }
  if (!(entry = sg_ids_reach(&map->ids, s))) {
    return false;
  }
  entry->last = id;
  return true;
}

/* ---- the rows of some segments ------------------------------------------ */

/* False: no row of one of the segments is on the page. */
static bool
may_have_any(const sg_page *page, const int32_t *s, size_t n)
{
  size_t place = sg_first_id(s, n, sizeof *s, sg_page_first(page));

  return place < n && s[place] <= sg_page_last(page);
}

/* All rows of a page are of one segment. */
static bool
is_of_one(const int32_t *of)
{
  int32_t differ = 0;

  for (unsigned r = 1; r < SG_PAGE_ROWS; r++) {
    differ |= of[r] ^ of[0];
  }
  return differ == 0;
}

/* The live rows of these segments, as a bitmap; false: none. */
static bool
find_rows(const sg_live *live, const int32_t *s, size_t n, uint64_t *out)
{
  const int32_t *of = live->page->cells[0].i;
  int32_t last = 0; /* the segment of the row before, and whether it is one */
  bool among = false, any = false;

  if (is_of_one(of)) {
    memcpy(out, live->word, sizeof live->word);
    return sg_find_id(s, n, of[0]) != SIZE_MAX;
  }
  memset(out, 0, sizeof live->word);
  for (unsigned r = sg_live_next(live->word, 0); r < SG_PAGE_ROWS;
       r = sg_live_next(live->word, r + 1)) {
    among = of[r] == last ? among : sg_find_id(s, n, of[r]) != SIZE_MAX;
    last = of[r];
    any = any || among;
    out[r / 64] |= (uint64_t)among << r % 64;
  }
  return any;
}

sg_map *
sg_map_narrow(const sg_map *map, const int32_t *s, size_t n)
{
  sg_map *out = calloc(1, sizeof *out);
  uint64_t word[SG_LIVE_WORDS];

  if (!out) {
    return NULL;
  }
  out->holders = 1;
  if (!sg_ids_narrow(map->ids, s, n, &out->ids)) {
    sg_map_drop(out);
    return NULL;
  }
  for (size_t i = 0; i < map->chunks * SG_CHUNK_PAGES; i++) {
    const sg_live *live = sg_map_live(map, i);
    if (!live || !may_have_any(live->page, s, n) ||
        !find_rows(live, s, n, word)) {
      continue;
    }
    sg_live *owned = sg_map_own_live(out, live->page, i);
    if (!owned) {
      sg_map_drop(out);
      return NULL;
    }
    memcpy(owned->word, word, sizeof word);
    for (unsigned w = 0; w < SG_LIVE_WORDS; w++) {
      out->rows += (size_t)__builtin_popcountll(word[w]);
    }
  }
  return out;
}

/* ---- stamps ------------------------------------------------------------ */

uint64_t
sg_map_stamp(const sg_map *map, int32_t s)
{
  const sg_ids_entry *entry = map ? sg_ids_find(map->ids, s) : NULL;

  return entry ? entry->stamp : 0;
}

uint64_t
sg_map_last_stamp(const sg_map *map)
{
  return map ? sg_ids_last_stamp(map->ids) : 0;
}

bool
sg_map_set_stamp(sg_map *map, int32_t s, uint64_t stamp)
{
  sg_ids_entry *entry = sg_ids_reach(&map->ids, s);

  if (entry) {
    entry->stamp = stamp;
  }
  return entry != NULL;
}

bool
sg_map_stamp_all(sg_map *map, uint64_t stamp)
{
  return sg_ids_stamp_all(&map->ids, stamp);
}

/* ---- what it costs ----------------------------------------------------- */

static double
chunk_share(const sg_chunk *chunk)
{
  double bytes = sizeof *chunk;

  for (size_t i = 0; i < SG_CHUNK_PAGES; i++) {
    bytes +=
        chunk->live[i] ? (double)sizeof(sg_live) / chunk->live[i]->holders : 0;
  }
  return bytes / chunk->holders;
}

double
sg_map_share(const sg_map *map)
{
  double bytes = 0;

  if (!map) {
    return 0;
  }
  bytes = (double)(sizeof *map + map->chunks * sizeof(sg_chunk *));
  for (size_t c = 0; c < map->chunks; c++) {
    bytes += map->chunk[c] ? chunk_share(map->chunk[c]) : 0;
  }
  return (bytes + sg_ids_share(map->ids)) / map->holders;
}
