/* known_surface4pl.c -- see known_surface4pl.h */
#include "known_surface4pl.h"

#include "glue.h"
#include "rows/key_table.h"

#include <stdlib.h>
#include <string.h>

/* How many results a polygon can have come through. */
enum { MOST_STEPS = 32 };

/* -------------------------------------------------------------- argument */

/* Items, n of them, with room for one more; null: no memory. */
static void *
with_room(void *items, size_t n, size_t *room, size_t size)
{
  size_t more = 2 * n + 16;
  void *wider;

  if (n < *room) {
    return items;
  }
  wider = realloc(items, more * size);
  if (wider) {
    *room = more;
  }
  return wider;
}

static bool
push_surface(sg_known_surfaces *all, size_t *room,
             const sg_known_surface *surface)
{
  sg_known_surface *wider =
      with_room(all->surface, all->n, room, sizeof *wider);

  if (wider) {
    all->surface = wider;
    all->surface[all->n++] = *surface;
  }
  return wider != NULL;
}

static bool
push_run(sg_known *known, const sg_known_run *run)
{
  sg_known_run *wider =
      with_room(known->run, known->runs, &known->run_room, sizeof *wider);

  if (wider) {
    known->run = wider;
    known->run[known->runs++] = *run;
  }
  return wider != NULL;
}

static bool
push_map(sg_known *known, const sg_known_map *map)
{
  sg_known_map *wider =
      with_room(known->map, known->maps, &known->map_room, sizeof *wider);

  if (wider) {
    known->map = wider;
    known->map[known->maps++] = *map;
  }
  return wider != NULL;
}

const char *const sg_known_kind_name[] = {
    [SG_KNOWN_TAPERED] = "tapered", [SG_KNOWN_TURNED] = "turned",
    [SG_KNOWN_SPHERE] = "sphere",   [SG_KNOWN_TORUS] = "torus",
    [SG_KNOWN_BEZIER] = "bezier",   [SG_KNOWN_FREE] = "free"};

static int
get_kind_ex(term_t t, sg_known_surface_kind *out)
{
  char *text;

  if (!PL_get_atom_chars(t, &text)) {
    return PL_type_error("atom", t);
  }
  for (unsigned k = 0; k <= SG_KNOWN_FREE; k++) {
    if (strcmp(text, sg_known_kind_name[k]) == 0) {
      *out = (sg_known_surface_kind)k;
      return TRUE;
    }
  }
  return PL_domain_error("surface_kind", t);
}

/* A list of so many numbers: a frame, or the rows of a map. */
static int
get_numbers_ex(term_t t, size_t count, double *out)
{
  double *number = NULL;
  size_t n = 0;
  int ok = sg_get_doubles_ex(t, &number, &n);

  if (ok && n != count) {
    ok = PL_domain_error(count == 12 ? "twelve_numbers" : "48_numbers", t);
  }
  for (size_t i = 0; ok && i < n; i++) {
    out[i] = number[i];
  }
  free(number);
  return ok;
}

/* surface(Kind, Frame, A, B) */
static int
read_surface_ex(term_t t, sg_known *known)
{
  term_t a = PL_new_term_refs(4);
  sg_known_surface_kind kind = SG_KNOWN_FREE;
  double frame[16][3], taper[2];
  sg_known_surface surface;

  for (int i = 0; i < 4; i++) {
    if (!PL_get_arg(i + 1, t, a + i)) {
      return PL_type_error("surface", t);
    }
  }
  if (!get_kind_ex(a, &kind) ||
      !get_numbers_ex(a + 1, 3 * (size_t)sg_known_surface_rows(kind),
                      &frame[0][0]) ||
      !sg_get_finites_ex(a + 2, 2, taper)) {
    return FALSE;
  }
  sg_known_surface_init(&surface, kind, (const double(*)[3])frame, taper[0],
                        taper[1]);
  return push_surface(&known->surfaces, &known->surface_room, &surface) ||
         sg_no_memory();
}

/* run(First, Last, K), K > 0 counted among the surfaces from `base` on. */
static int
read_run_ex(term_t t, int32_t s, int32_t base, sg_known *known)
{
  term_t a = PL_new_term_refs(3);
  int32_t x[3];

  for (int i = 0; i < 3; i++) {
    if (!PL_get_arg(i + 1, t, a + i) || !sg_get_int32_ex(a + i, &x[i])) {
      return PL_exception(0) ? FALSE : PL_type_error("run", t);
    }
  }
  sg_known_run run = {s, x[0], x[1], SG_NOT_KNOWN, x[2]};
  if (x[2] > 0) {
    if ((size_t)x[2] > known->surfaces.n - (size_t)base) {
      return PL_domain_error("surface_number", a + 2);
    }
    run.surface = base + x[2] - 1;
  }
  return push_run(known, &run) || sg_no_memory();
}

/* Of known(S, Surfaces, Runs). */
static int
read_facets_ex(int32_t s, term_t surfaces, term_t runs, sg_known *known)
{
  term_t item = PL_new_term_ref();
  int32_t base = (int32_t)known->surfaces.n;

  if (!push_run(known, &(sg_known_run){.s = s, .first = 0, .last = -1})) {
    return sg_no_memory();
  }
  while (PL_get_list(surfaces, item, surfaces)) {
    if (!read_surface_ex(item, known)) {
      return FALSE;
    }
  }
  while (PL_get_list(runs, item, runs)) {
    if (!read_run_ex(item, s, base, known)) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(surfaces) && PL_get_nil_ex(runs);
}

/* known(S, Surfaces, Runs) or moved(S, Map) */
static int
read_segment_ex(term_t t, sg_known *known)
{
  term_t a = PL_new_term_refs(3);
  sg_known_map map = {0};
  size_t arity = 0;
  atom_t name;

  if (!PL_get_name_arity(t, &name, &arity) || arity < 2 || arity > 3) {
    return PL_type_error("known", t);
  }
  for (int i = 0; i < (int)arity; i++) {
    _PL_get_arg((size_t)i + 1, t, a + i);
  }
  if (!sg_get_id_ex(a, &map.s)) {
    return FALSE;
  }
  if (arity == 3) {
    return read_facets_ex(map.s, a + 1, a + 2, known);
  }
  return get_numbers_ex(a + 1, 12, &map.row[0][0]) &&
         (push_map(known, &map) || sg_no_memory());
}

int
sg_get_known_ex(term_t t, sg_known *out)
{
  term_t list = PL_copy_term_ref(t), item = PL_new_term_ref();
  char *text;

  *out = (sg_known){0};
  if (PL_get_atom_chars(t, &text) && strcmp(text, "kept") == 0) {
    out->kept = true;
    return TRUE;
  }
  while (PL_get_list_ex(list, item, list)) {
    fid_t frame = PL_open_foreign_frame();
    int ok = read_segment_ex(item, out);
    PL_close_foreign_frame(frame);
    if (!ok) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(list);
}

void
sg_known_clear(sg_known *known)
{
  sg_known_surfaces_clear(&known->surfaces);
  free(known->run);
  free(known->map);
  *known = (sg_known){0};
}

/* -------------------------------------------------------------- polygons */

/* A row of from_p/5: a polygon of a result has a part of that of an operand. */
typedef struct part {
  int32_t s, p, s0, p0;
  size_t row;
} part;

typedef struct parts {
  part *part; /* [n] by s, p and row */
  size_t n;
} parts;

static int
compare_parts(const void *a, const void *b)
{
  const part *x = a, *y = b;

  if (x->s != y->s || x->p != y->p) {
    return x->s != y->s ? (x->s > y->s) - (x->s < y->s)
                        : (x->p > y->p) - (x->p < y->p);
  }
  return (x->row > y->row) - (x->row < y->row);
}

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

/* False: stopped, or no memory. */
static bool
read_parts(const sg_version *version, const sg_poll *poll, parts *out,
           bool *memory)
{
  sg_view view;
  bool stopped = false;

  out->part =
      malloc((sg_version_count(version, SG_FROM_P) + 1) * sizeof *out->part);
  *memory = out->part && sg_version_view(version, SG_FROM_P, &view);
  if (!*memory) {
    return false;
  }
  for (size_t page = 0; page < view.pages && !stopped; page++) {
    for (unsigned i = sg_live_next(view.live[page], 0); i < SG_PAGE_ROWS;
         i = sg_live_next(view.live[page], i + 1)) {
      out->part[out->n] =
          (part){view.column[0].page[page].i[i], view.column[1].page[page].i[i],
                 view.column[2].page[page].i[i], view.column[3].page[page].i[i],
                 out->n};
      out->n++;
    }
    stopped = sg_poll_stop(poll);
  }
  sg_view_clear(&view);
  sort_parts(out);
  return !stopped;
}

/* The first part of polygon p of segment s; null: none. */
static const part *
find_part(const parts *all, int32_t s, int32_t p)
{
  const part key = {.s = s, .p = p};
  size_t low = 0, high = all->n;

  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (compare_parts(&all->part[middle], &key) < 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < all->n && all->part[low].s == s && all->part[low].p == p
             ? &all->part[low]
             : NULL;
}

/* The last run of segment s that begins at or before polygon p; null: nothing
 * is said of s. */
static const sg_known_run *
find_run(const sg_known *known, int32_t s, int32_t p)
{
  size_t low = 0, high = known->runs;

  while (low < high) {
    size_t middle = low + (high - low) / 2;
    const sg_known_run *run = &known->run[middle];
    if (run->s < s || (run->s == s && run->first <= p)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low > 0 && known->run[low - 1].s == s ? &known->run[low - 1] : NULL;
}

/* How the segment, a join, was moved as a whole; null: it was not. */
static const sg_known_map *
find_map(const sg_known *known, int32_t s)
{
  size_t low = 0, high = known->maps;

  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (known->map[middle].s < s) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < known->maps && known->map[low].s == s ? &known->map[low] : NULL;
}

/* Polygons followed to their surfaces. */
typedef struct following {
  const sg_known *known;
  const parts *parts;
  sg_known_surfaces *out; /* those of `known`, then those that were moved */
  size_t room;
  sg_key_table moved; /* the place of a map and a surface: the surface moved */
  sg_key_table faces; /* what names a face: how many were named before */
} following;

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
move_surface(following *f, const sg_known_map *map, int32_t *place)
{
  uint32_t at = (uint32_t)(map - f->known->map);
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
                          (const double(*)[4])map->row, &surface);
    if (!push_surface(f->out, &f->room, &surface)) {
      return false;
    }
  }
  *place = (int32_t)*moved;
  return true;
}

/* What polygon p is by a run at or before it. False: no memory. */
static bool
find_in_run(following *f, const sg_known_run *run, int32_t p, int32_t *out)
{
  if (p > run->last) {
    return true;
  }
  *out = run->surface;
  return run->surface >= 0 ||
         name_face(f, (uint32_t)run->s, run->face < 0 ? run->face : p, out);
}

/* Whose facet polygon p of segment s is, or its face. False: no memory. */
static bool
find_surface(following *f, int32_t s, int32_t p, int32_t *out)
{
  const sg_known_map *through[MOST_STEPS];
  size_t maps = 0;

  *out = SG_NOT_KNOWN;
  for (int step = 0; step < MOST_STEPS; step++) {
    const sg_known_run *run = find_run(f->known, s, p);
    const sg_known_map *map = find_map(f->known, s);
    const part *from;
    if (run) {
      if (!find_in_run(f, run, p, out)) {
        return false;
      }
      break;
    }
    from = find_part(f->parts, s, p);
    if (!from) {
      break;
    }
    if (map) {
      through[maps++] = map;
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

/* False: stopped, or no memory. */
static bool
find_polygons(following *f, const sg_dense *d, const sg_poll *poll,
              bool *memory)
{
  for (size_t s = 0; s < d->segments; s++) {
    for (size_t p = d->polygon_begin[s]; p < d->polygon_begin[s + 1]; p++) {
      if (p % SG_PAGE_ROWS == 0 && sg_poll_stop(poll)) {
        return false;
      }
      *memory =
          find_surface(f, d->segment[s], d->polygon_id[p], &f->out->of[p]);
      if (!*memory) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_known_surfaces_read(const sg_known *known, const sg_version *version,
                       const sg_dense *dense, const sg_poll *poll,
                       sg_known_surfaces *out, bool *memory)
{
  size_t n = known->surfaces.n;
  parts all = {0};
  following f = {.known = known, .parts = &all, .out = out, .room = n};
  bool done;

  *out = (sg_known_surfaces){0};
  *memory = true;
  if (known->runs == 0) {
    return true;
  }
  out->surface = malloc((n + 1) * sizeof *out->surface);
  out->of = malloc((dense->polygons + 1) * sizeof *out->of);
  *memory = out->surface && out->of;
  if (*memory && n > 0) {
    out->n = n;
    memcpy(out->surface, known->surfaces.surface, n * sizeof *out->surface);
  }
  sg_key_table_init(&f.moved, 2);
  sg_key_table_init(&f.faces, 2);
  done = *memory && read_parts(version, poll, &all, memory) &&
         find_polygons(&f, dense, poll, memory);
  sg_key_table_clear(&f.moved);
  sg_key_table_clear(&f.faces);
  free(all.part);
  return done;
}
