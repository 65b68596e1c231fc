/* known_facets4pl.c -- whose facets the polygons of results are (documented in
 * kernel/pattern.pl).
 *
 * Layer: glue.
 */
#include "glue.h"
#include "known_surface4pl.h"
#include "rows/dense4pl.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <stdlib.h>

/* The surfaces of a segment in the order in which its polygons have them, and
 * the faces that several of its polygons are of. */
typedef struct numbering {
  const sg_known_surfaces *surfaces;
  int32_t *number;    /* [surfaces->n] from 1; 0 between segments: not yet */
  uint32_t *polygons; /* [faces] how many of the segment are of it */
  int32_t *face;      /* [faces] as number */
  size_t faces;       /* of all polygons */
  int32_t n, shared;  /* how many are numbered */
} numbering;

static int
put_surface(term_t t, const sg_known_surface *surface)
{
  term_t frame = PL_new_term_ref(), number = PL_new_term_ref();

  PL_put_nil(frame);
  for (int i = 3 * sg_known_surface_rows(surface->kind) - 1; i >= 0; i--) {
    if (!PL_put_float(number, surface->frame[i / 3][i % 3] + 0.0) ||
        !PL_cons_list(frame, number, frame)) {
      return FALSE;
    }
  }
  return PL_unify_term(t, PL_FUNCTOR_CHARS, "surface", 4, PL_CHARS,
                       sg_known_kind_name[surface->kind], PL_TERM, frame,
                       PL_FLOAT, surface->a, PL_FLOAT, surface->b);
}

/* Adds the surface of a place to the list if it is new there. */
static int
number_surface_ex(numbering *f, int32_t place, term_t tail)
{
  term_t item = PL_new_term_ref();

  if (f->number[place] > 0) {
    return TRUE;
  }
  f->number[place] = ++f->n;
  return PL_unify_list(tail, item, tail) &&
         put_surface(item, &f->surfaces->surface[place]);
}

/* The place of a face in polygons[] and face[]. */
static size_t
face_place(int32_t of)
{
  return (size_t)(SG_NOT_KNOWN - 1 - of);
}

/* The third argument of the run of polygon p: the number of its surface; minus
 * that of a face that several polygons are of; 0: a face of its own, or nothing
 * known. */
static int
number_polygon_ex(numbering *f, size_t p, term_t surfaces, int32_t *out)
{
  int32_t of = f->surfaces->of[p];

  *out = 0;
  if (of >= 0) {
    int done = number_surface_ex(f, of, surfaces);
    *out = f->number[of];
    return done;
  }
  if (of < SG_NOT_KNOWN && f->polygons[face_place(of)] > 1) {
    int32_t *number = &f->face[face_place(of)];
    if (*number == 0) {
      *number = ++f->shared;
    }
    *out = -*number;
  }
  return TRUE;
}

/* Polygons from place p on that one run says all of: where they end. */
static size_t
run_end(const numbering *f, size_t p, size_t end)
{
  const int32_t *of = f->surfaces->of;
  int32_t first = of[p];
  bool own = first < SG_NOT_KNOWN && f->polygons[face_place(first)] == 1;

  for (p++; p < end; p++) {
    if (own ? of[p] >= SG_NOT_KNOWN || f->polygons[face_place(of[p])] > 1
            : of[p] != first) {
      break;
    }
  }
  return p;
}

static void
count_faces(numbering *f, size_t begin, size_t end)
{
  for (size_t p = begin; p < end; p++) {
    if (f->surfaces->of[p] < SG_NOT_KNOWN) {
      f->polygons[face_place(f->surfaces->of[p])]++;
    }
  }
}

static void
forget(numbering *f, size_t begin, size_t end)
{
  for (size_t p = begin; p < end; p++) {
    int32_t of = f->surfaces->of[p];
    if (of >= 0) {
      f->number[of] = 0;
    } else if (of < SG_NOT_KNOWN) {
      f->polygons[face_place(of)] = 0;
      f->face[face_place(of)] = 0;
    }
  }
  f->n = f->shared = 0;
}

/* The surfaces and runs of polygons begin to end - 1. */
static int
put_facets_ex(numbering *f, const int32_t *id, size_t begin, size_t end,
              term_t surfaces, term_t runs)
{
  term_t item = PL_new_term_ref();
  int done = TRUE;

  count_faces(f, begin, end);
  for (size_t p = begin, next; done && p < end; p = next) {
    int32_t number;
    next = run_end(f, p, end);
    fid_t frame = PL_open_foreign_frame();
    done = f->surfaces->of[p] == SG_NOT_KNOWN ||
           (number_polygon_ex(f, p, surfaces, &number) &&
            PL_unify_list(runs, item, runs) &&
            PL_unify_term(item, PL_FUNCTOR_CHARS, "run", 3, PL_INT, id[p],
                          PL_INT, id[next - 1], PL_INT, number));
    PL_close_foreign_frame(frame);
  }
  forget(f, begin, end);
  return done && PL_unify_nil(surfaces) && PL_unify_nil(runs);
}

/* Whether anything is known of polygons begin to end - 1. */
static bool
is_known(const sg_known_surfaces *surfaces, size_t begin, size_t end)
{
  while (begin < end && surfaces->of[begin] == SG_NOT_KNOWN) {
    begin++;
  }
  return begin < end;
}

/* known(S, Surfaces, Runs) of the segments of which something is known. */
static int
put_known_ex(numbering *f, const sg_dense *d, term_t list)
{
  term_t tail = PL_copy_term_ref(list), item = PL_new_term_ref();
  int done = TRUE;

  for (size_t s = 0; done && f->surfaces->of && s < d->segments; s++) {
    size_t begin = d->polygon_begin[s], end = d->polygon_begin[s + 1];
    if (is_known(f->surfaces, begin, end)) {
      term_t part = PL_new_term_refs(2);
      done = PL_unify_list(tail, item, tail) &&
             PL_unify_term(item, PL_FUNCTOR_CHARS, "known", 3, PL_INT,
                           d->segment[s], PL_TERM, part, PL_TERM, part + 1) &&
             put_facets_ex(f, d->polygon_id, begin, end, part, part + 1);
    }
  }
  return done && PL_unify_nil(tail);
}

/* False: no memory. */
static bool
numbering_init(numbering *f, const sg_dense *d)
{
  for (size_t p = 0; f->surfaces->of && p < d->polygons; p++) {
    int32_t of = f->surfaces->of[p];
    if (of < SG_NOT_KNOWN && face_place(of) >= f->faces) {
      f->faces = face_place(of) + 1;
    }
  }
  f->number = calloc(f->surfaces->n + 1, sizeof *f->number);
  f->polygons = calloc(f->faces + 1, sizeof *f->polygons);
  f->face = calloc(f->faces + 1, sizeof *f->face);
  return f->number && f->polygons && f->face;
}

static void
numbering_clear(numbering *f)
{
  free(f->number);
  free(f->polygons);
  free(f->face);
}

static int
known_facets_ex(const sg_known *known, const sg_dense *dense, term_t list)
{
  sg_world *world = sg_current_world_ex();
  const sg_version *version = world ? sg_world_version(world) : NULL;
  sg_known_surfaces surfaces = {0};
  numbering f = {.surfaces = &surfaces};
  bool memory = true;
  int done = FALSE;

  if (version && sg_known_surfaces_read(known, version, dense, &sg_prolog_poll,
                                        &surfaces, &memory)) {
    memory = numbering_init(&f, dense);
    done = memory && put_known_ex(&f, dense, list);
  }
  sg_version_drop(version);
  sg_known_surfaces_clear(&surfaces);
  numbering_clear(&f);
  return memory ? done : sg_no_memory();
}

/* known_facets(+Known, +Ss, -Facets) is det. */
static foreign_t
known_facets(term_t known, term_t segments, term_t facets)
{
  sg_known all = {0};
  sg_dense dense = {0};
  int32_t *s = NULL;
  size_t n = 0;
  int done = sg_get_known_ex(known, &all) && sg_get_ids_ex(segments, &s, &n) &&
             sg_get_dense_ex(s, n, &dense) &&
             known_facets_ex(&all, &dense, facets);

  sg_known_clear(&all);
  sg_dense_clear(&dense);
  free(s);
  return done;
}

void
sg_install_known_facets(void)
{
  static const PL_extension doors[] = {
      {"known_facets", 3, (pl_function_t)known_facets, 0}, {NULL, 0, NULL, 0}};

  PL_register_extensions_in_module("sg_kernel_pattern", doors);
}
