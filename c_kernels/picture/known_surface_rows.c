/* known_surface_rows.c -- see known_surface_rows.h */
#include "known_surface_rows.h"
#include "engine/list.h"
#include "engine/search.h"
#include "rows/key_table.h"
#include "rows/live_rows.h"

#include <stdlib.h>

/* How many results a polygon can have come through. */
enum { MOST_STEPS = 32 };

/* ---- where polygons came from ---- */

/* A row of from_p/5: a polygon of a result has a part of that of an operand. */
typedef struct part {
  int32_t s, p, s0, p0;
  size_t row;
} part;

typedef struct parts {
  part *part; /* [n] by s, p and row */
  size_t n;
} parts;

SG_ORDER(compare_parts, part, SG_BY(s) SG_BY(p) SG_BY(row));

static void
sort_parts(parts *all)
{
  for (size_t i = 1; i < all->n; i++) {
    if (compare_parts(&all->part[i - 1], &all->part[i]) > 0) {
      qsort(all->part, all->n, sizeof *all->part, compare_parts);
      return;
    }
  }
}

static void
read_part(void *reader, const sg_live_row *r)
{
  parts *all = reader;

  all->part[all->n] = (part){sg_row_int(r, 0), sg_row_int(r, 1),
                             sg_row_int(r, 2), sg_row_int(r, 3), all->n};
  all->n++;
}

static bool
read_parts(sg_call *call, parts *out)
{
  const sg_version *version = sg_call_version(call);
  size_t n = version ? sg_version_count(version, SG_FROM_P) : 0;

  out->part = version ? sg_call_alloc(call, n * sizeof *out->part) : NULL;
  if (!out->part || !sg_each_row(call, SG_FROM_P, read_part, out)) {
    return false;
  }
  sort_parts(out);
  return true;
}

/* The first part of polygon p of segment s; null: none. */
static const part *
find_part(const parts *all, int32_t s, int32_t p)
{
  const part key = {.s = s, .p = p};
  size_t at;

  SG_SEARCH(at, 0, all->n, compare_parts(&all->part[at], &key) < 0);
  return at < all->n && all->part[at].s == s && all->part[at].p == p
             ? &all->part[at]
             : NULL;
}

/* ---- what is known of segments ---- */

/* Polygons followed to their surfaces. */
typedef struct following {
  const sg_known_segment_list *known;
  int32_t *base; /* [known->n] the place of the first surface of each */
  parts parts;
  sg_known_surfaces *out; /* those of `known`, then those that were moved */
  size_t room;
  sg_key_table moved; /* the place of a map and a surface: the surface moved */
  sg_key_table faces; /* what names a face: how many were named before */
} following;

static bool
push_surface(following *f, const sg_known_surface *surface)
{
  sg_known_surfaces *all = f->out;

  if (!sg_list_grow(&all->surface, all->n, &f->room, sizeof *all->surface)) {
    return false;
  }
  all->surface[all->n++] = *surface;
  return true;
}

static bool
add_surface(sg_call *call, following *f, const sg_smooth_surface *said)
{
  size_t numbers = 3 * (size_t)sg_known_surface_rows(said->kind);
  sg_known_surface surface;

  if (said->frame.n != numbers) {
    return sg_call_domain_of(call,
                             numbers == 12 ? "twelve_numbers" : "48_numbers",
                             (int64_t)said->frame.n);
  }
  sg_known_surface_init(&surface, said->kind,
                        (const double(*)[3])said->frame.at, said->a, said->b);
  return push_surface(f, &surface) || sg_call_no_memory(call);
}

/* known(S, Surfaces, Runs) or moved(S, Map); s is where either has it. */
static bool
add_segment(sg_call *call, following *f, const sg_known_segment *said)
{
  if (said->is == SG_KNOWN_SEGMENT_MOVED) {
    return said->moved.map.n == 12 ||
           sg_call_domain_of(call, "twelve_numbers",
                             (int64_t)said->moved.map.n);
  }
  for (size_t i = 0; i < said->known.surfaces.n; i++) {
    if (!add_surface(call, f, &said->known.surfaces.at[i])) {
      return false;
    }
  }
  for (size_t i = 0; i < said->known.runs.n; i++) {
    int32_t k = said->known.runs.at[i].number;
    if (k > 0 && (size_t)k > said->known.surfaces.n) {
      return sg_call_domain_of(call, "surface_number", k);
    }
  }
  return true;
}

static bool
add_segments(sg_call *call, following *f)
{
  bool good = true;

  f->base = sg_call_alloc(call, f->known->n * sizeof *f->base);
  for (size_t i = 0; f->base && good && i < f->known->n; i++) {
    f->base[i] = (int32_t)f->out->n;
    good = add_segment(call, f, &f->known->at[i]);
  }
  return f->base && good;
}

static int
compare_segment(const void *key, const void *item)
{
  const sg_known_segment *said = item;
  int32_t s = *(const int32_t *)key;
  int32_t of =
      said->is == SG_KNOWN_SEGMENT_KNOWN ? said->known.s : said->moved.s;

  return (s > of) - (s < of);
}

/* What is said of segment s; null: nothing. */
static const sg_known_segment *
find_segment(const following *f, int32_t s)
{
  return bsearch(&s, f->known->at, f->known->n, sizeof *f->known->at,
                 compare_segment);
}

/* The last run that begins at or before polygon p; null: there is none. */
static const sg_surface_run *
find_run(const sg_surface_run_list *runs, int32_t p)
{
  size_t at;

  SG_SEARCH(at, 0, runs->n, runs->at[at].first <= p);
  return at > 0 ? &runs->at[at - 1] : NULL;
}

/* ---- polygons ---- */

/* In the key of a face that was moved, beside the place of the map. */
#define MOVED_FACE UINT32_C(0x80000000)

/* The face of this name: less than SG_NOT_KNOWN. False: no memory. */
static bool
name_face(following *f, uint32_t where, int32_t name, int32_t *out)
{
  uint32_t n = (uint32_t)f->faces.n, key[2] = {where, (uint32_t)name};
  uint32_t *face = sg_key_table_put(&f->faces, key);

  if (face && *face == SG_NO_KEY) {
    *face = n;
  }
  *out = face ? SG_NOT_KNOWN - 1 - (int32_t)*face : SG_NOT_KNOWN;
  return face != NULL;
}

/* The place of a surface, or a face, becomes that of the same moved. False: no
 * memory. */
static bool
move_surface(following *f, const sg_known_segment *map, int32_t *place)
{
  uint32_t at = (uint32_t)(map - f->known->at);
  uint32_t key[2] = {at, (uint32_t)*place}, *moved;
  sg_known_surface surface;

  if (*place < 0) {
    return name_face(f, at | MOVED_FACE, *place, place);
  }
  moved = sg_key_table_put(&f->moved, key);
  if (!moved) {
    return false;
  }
  if (*moved == SG_NO_KEY) {
    *moved = (uint32_t)f->out->n;
    sg_known_surface_move(&f->out->surface[*place],
                          (const double(*)[4])map->moved.map.at, &surface);
    if (!push_surface(f, &surface)) {
      return false;
    }
  }
  *place = (int32_t)*moved;
  return true;
}

/* What polygon p of a segment is by what is known of that. False: no memory. */
static bool
find_in_runs(following *f, const sg_known_segment *said, int32_t p,
             int32_t *out)
{
  const sg_surface_run *run = find_run(&said->known.runs, p);

  if (!run || p > run->last) {
    return true;
  }
  if (run->number > 0) {
    *out = f->base[said - f->known->at] + run->number - 1;
    return true;
  }
  return name_face(f, (uint32_t)said->known.s,
                   run->number < 0 ? run->number : p, out);
}

/* Whose facet polygon p of segment s is, or its face. False: no memory. */
static bool
find_surface(following *f, int32_t s, int32_t p, int32_t *out)
{
  const sg_known_segment *through[MOST_STEPS];
  size_t maps = 0;

  *out = SG_NOT_KNOWN;
  for (int step = 0; step < MOST_STEPS; step++) {
    const sg_known_segment *said = find_segment(f, s);
    const part *from;
    if (said && said->is == SG_KNOWN_SEGMENT_KNOWN) {
      if (!find_in_runs(f, said, p, out)) {
        return false;
      }
      break;
    }
    from = find_part(&f->parts, s, p);
    if (!from) {
      break;
    }
    if (said) {
      through[maps++] = said;
    }
    s = from->s0;
    p = from->p0;
  }
  while (*out != SG_NOT_KNOWN && maps > 0) {
    if (!move_surface(f, through[--maps], out)) {
      return false;
    }
  }
  return true;
}

static bool
find_polygons(sg_call *call, following *f, const sg_dense *d)
{
  for (size_t s = 0; s < d->segments; s++) {
    for (size_t p = d->polygon_begin[s]; p < d->polygon_begin[s + 1]; p++) {
      if (p % SG_PAGE_ROWS == 0 && sg_cancelled(&call->cancel)) {
        return false;
      }
      if (!find_surface(f, d->segment[s], d->polygon_id[p], &f->out->of[p])) {
        return sg_call_no_memory(call);
      }
    }
  }
  return true;
}

static bool
is_anything_known(const sg_known_segment_list *known)
{
  for (size_t i = 0; i < known->n; i++) {
    if (known->at[i].is == SG_KNOWN_SEGMENT_KNOWN) {
      return true;
    }
  }
  return false;
}

bool
sg_known_surfaces_read(sg_call *call, const sg_known_segment_list *known,
                       const sg_dense *dense, sg_known_surfaces *out)
{
  following f = {.known = known, .out = out};

  *out = (sg_known_surfaces){0};
  if (!is_anything_known(known)) {
    return true;
  }
  out->of = malloc((dense->polygons + 1) * sizeof *out->of);
  sg_key_table_init(&f.moved, 2);
  sg_key_table_init(&f.faces, 2);
  bool good = (out->of || sg_call_no_memory(call)) && add_segments(call, &f) &&
              read_parts(call, &f.parts) && find_polygons(call, &f, dense);

  sg_key_table_clear(&f.moved);
  sg_key_table_clear(&f.faces);
  return good;
}

bool
sg_known_surfaces_adopt(sg_call *call, sg_known_surfaces *surfaces)
{
  bool kept = sg_call_adopt(call, surfaces->surface);

  return sg_call_adopt(call, surfaces->of) && kept;
}
