/* known_surface4pl.c -- see known_surface4pl.h */
#include "known_surface4pl.h"

#include "glue.h"

#include <stdlib.h>
#include <string.h>

/* How many results a polygon can have come through. */
enum { MOST_STEPS = 32 };

/* -------------------------------------------------------------- argument */

static bool
push_surface(sg_known *known, const sg_known_surface *surface)
{
  if (known->surfaces == known->surface_room) {
    size_t more = 2 * known->surface_room + 16;
    sg_known_surface *wider = realloc(known->surface, more * sizeof *wider);
    if (!wider) {
      return false;
    }
    known->surface = wider;
    known->surface_room = more;
  }
  known->surface[known->surfaces++] = *surface;
  return true;
}

static bool
push_run(sg_known *known, const sg_known_run *run)
{
  if (known->runs == known->run_room) {
    size_t more = 2 * known->run_room + 16;
    sg_known_run *wider = realloc(known->run, more * sizeof *wider);
    if (!wider) {
      return false;
    }
    known->run = wider;
    known->run_room = more;
  }
  known->run[known->runs++] = *run;
  return true;
}

static int
get_kind_ex(term_t t, sg_known_surface_kind *out)
{
  static const char *const name[] = {[SG_KNOWN_TAPERED] = "tapered",
                                     [SG_KNOWN_SPHERE] = "sphere",
                                     [SG_KNOWN_TORUS] = "torus",
                                     [SG_KNOWN_FREE] = "free"};
  char *text;

  if (!PL_get_atom_chars(t, &text)) {
    return PL_type_error("atom", t);
  }
  for (unsigned k = 0; k < sizeof name / sizeof *name; k++) {
    if (strcmp(text, name[k]) == 0) {
      *out = (sg_known_surface_kind)k;
      return TRUE;
    }
  }
  return PL_domain_error("surface_kind", t);
}

/* A list of 12 numbers: the centre, U, V, W. */
static int
get_frame_ex(term_t t, double out[4][3])
{
  double *number = NULL;
  size_t n = 0;
  int ok = sg_get_doubles_ex(t, &number, &n);

  if (ok && n != 12) {
    ok = PL_domain_error("frame", t);
  }
  for (size_t i = 0; ok && i < n; i++) {
    out[i / 3][i % 3] = number[i];
  }
  free(number);
  return ok;
}

/* known_surface(Kind, Frame, A, B) */
static int
read_surface_ex(term_t t, sg_known *known)
{
  term_t a = PL_new_term_refs(4);
  sg_known_surface_kind kind = SG_KNOWN_FREE;
  double frame[4][3], taper[2];
  sg_known_surface surface;

  for (int i = 0; i < 4; i++) {
    if (!PL_get_arg(i + 1, t, a + i)) {
      return PL_type_error("surface", t);
    }
  }
  if (!get_kind_ex(a, &kind) || !get_frame_ex(a + 1, frame) ||
      !sg_get_finites_ex(a + 2, 2, taper)) {
    return FALSE;
  }
  sg_known_surface_init(&surface, kind, (const double(*)[3])frame, taper[0],
                        taper[1]);
  return push_surface(known, &surface) || sg_no_memory();
}

/* run(First, Last, K), K counted among the surfaces from `base` on. */
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
  return push_run(known, &(sg_known_run){s, x[0], x[1], base + x[2] - 1}) ||
         sg_no_memory();
}

/* known(S, Surfaces, Runs) */
static int
read_segment_ex(term_t t, sg_known *known)
{
  term_t a = PL_new_term_refs(3), item = PL_new_term_ref();
  int32_t s, base = (int32_t)known->surfaces;

  for (int i = 0; i < 3; i++) {
    if (!PL_get_arg(i + 1, t, a + i)) {
      return PL_type_error("known", t);
    }
  }
  if (!sg_get_id_ex(a, &s)) {
    return FALSE;
  }
  if (!push_run(known, &(sg_known_run){s, 0, 0, -1})) { /* it is known */
    return sg_no_memory();
  }
  while (PL_get_list(a + 1, item, a + 1)) {
    if (!read_surface_ex(item, known)) {
      return FALSE;
    }
  }
  while (PL_get_list(a + 2, item, a + 2)) {
    if (!read_run_ex(item, s, base, known)) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(a + 1) && PL_get_nil_ex(a + 2);
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
  free(known->surface);
  free(known->run);
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

static int32_t
surface_of(const sg_known *known, const parts *all, int32_t s, int32_t p)
{
  for (int step = 0; step < MOST_STEPS; step++) {
    const sg_known_run *run = find_run(known, s, p);
    const part *from;
    if (run) {
      return p <= run->last ? run->surface : -1;
    }
    from = find_part(all, s, p);
    if (!from) {
      break;
    }
    s = from->s0;
    p = from->p0;
  }
  return -1;
}

static bool
find_polygons(const sg_known *known, const parts *all, const sg_dense *d,
              const sg_poll *poll, sg_known_surfaces *out)
{
  for (size_t s = 0; s < d->segments; s++) {
    for (size_t p = d->polygon_begin[s]; p < d->polygon_begin[s + 1]; p++) {
      if (p % SG_PAGE_ROWS == 0 && sg_poll_stop(poll)) {
        return false;
      }
      out->of[p] = surface_of(known, all, d->segment[s], d->polygon_id[p]);
    }
  }
  return true;
}

bool
sg_known_surfaces_read(const sg_known *known, const sg_version *version,
                       const sg_dense *dense, const sg_poll *poll,
                       sg_known_surfaces *out, bool *memory)
{
  parts all = {0};
  bool done;

  *out = (sg_known_surfaces){0};
  *memory = true;
  if (known->surfaces == 0) {
    return true;
  }
  out->surface = malloc(known->surfaces * sizeof *out->surface);
  out->of = malloc((dense->polygons + 1) * sizeof *out->of);
  *memory = out->surface && out->of;
  if (*memory) {
    out->n = known->surfaces;
    memcpy(out->surface, known->surface, out->n * sizeof *out->surface);
  }
  done = *memory && read_parts(version, poll, &all, memory) &&
         find_polygons(known, &all, dense, poll, out);
  free(all.part);
  return done;
}
