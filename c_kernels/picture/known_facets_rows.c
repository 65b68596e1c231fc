/* known_facets_rows.c -- whose facets the polygons of results are. */
#include "doors/pattern.h"
#include "known_surface_rows.h"
#include "rows/dense_rows.h"

#include <string.h>

/* The surfaces of a segment in the order in which its polygons have them, and
 * the faces that several of its polygons are of. */
typedef struct numbering {
  sg_known_surfaces *surfaces;
  int32_t *number;    /* [surfaces->n] from 1; 0 between segments: not yet */
  uint32_t *polygons; /* [faces] how many of the segment are of it */
  int32_t *face;      /* [faces] as number */
  size_t faces;       /* of all polygons */
  int32_t n, shared;  /* how many are numbered */
} numbering;

/* Adds the surface of a place to the list if it is new there. */
static bool
number_surface(sg_call *call, numbering *f, int32_t place,
               sg_smooth_surface_list *out)
{
  sg_known_surface *surface = &f->surfaces->surface[place];
  size_t numbers = 3 * (size_t)sg_known_surface_rows(surface->kind);

  if (f->number[place] > 0) {
    return true;
  }
  f->number[place] = ++f->n;
  return sg_smooth_surface_list_add(
      call, out,
      (sg_smooth_surface){surface->kind,
                          {surface->frame[0], numbers, 0},
                          surface->a,
                          surface->b});
}

/* The place of a face in polygons[] and face[]. */
static size_t
face_place(int32_t of)
{
  return (size_t)(SG_NOT_KNOWN - 1 - of);
}

/* The third argument of the run of polygon p: the number of its surface; minus
 * that of a face that several polygons are of; 0: a face of its own. */
static bool
number_polygon(sg_call *call, numbering *f, size_t p,
               sg_smooth_surface_list *surfaces, int32_t *out)
{
  int32_t of = f->surfaces->of[p];

  *out = 0;
  if (of >= 0) {
    bool good = number_surface(call, f, of, surfaces);
    *out = f->number[of];
    return good;
  }
  if (f->polygons[face_place(of)] > 1) {
    int32_t *number = &f->face[face_place(of)];
    if (*number == 0) {
      *number = ++f->shared;
    }
    *out = -*number;
  }
  return true;
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
static bool
add_runs(sg_call *call, numbering *f, const int32_t *id, size_t begin,
         size_t end, sg_known_segment *out)
{
  bool good = true;

  count_faces(f, begin, end);
  for (size_t p = begin, next; good && p < end; p = next) {
    int32_t number;
    next = run_end(f, p, end);
    good = f->surfaces->of[p] == SG_NOT_KNOWN ||
           (number_polygon(call, f, p, &out->known.surfaces, &number) &&
            sg_surface_run_list_add(
                call, &out->known.runs,
                (sg_surface_run){id[p], id[next - 1], number}));
  }
  forget(f, begin, end);
  return good;
}

/* known(S, Surfaces, Runs) of the segments of which something is known. */
static bool
add_segments(sg_call *call, numbering *f, const sg_dense *d,
             sg_known_segment_list *out)
{
  bool good = true;

  for (size_t s = 0; good && s < d->segments; s++) {
    size_t begin = d->polygon_begin[s], end = d->polygon_begin[s + 1];
    sg_known_segment said = {.is = SG_KNOWN_SEGMENT_KNOWN,
                             .known = {.s = d->segment[s]}};
    good =
        add_runs(call, f, d->polygon_id, begin, end, &said) &&
        (said.known.runs.n == 0 || sg_known_segment_list_add(call, out, said));
  }
  return good;
}

static void *
zeros(sg_call *call, size_t bytes)
{
  void *at = sg_call_alloc(call, bytes);

  return at ? memset(at, 0, bytes) : NULL;
}

static bool
numbering_init(sg_call *call, numbering *f, const sg_dense *d)
{
  for (size_t p = 0; p < d->polygons; p++) {
    int32_t of = f->surfaces->of[p];
    if (of < SG_NOT_KNOWN && face_place(of) >= f->faces) {
      f->faces = face_place(of) + 1;
    }
  }
  f->number = zeros(call, f->surfaces->n * sizeof *f->number);
  f->polygons = zeros(call, f->faces * sizeof *f->polygons);
  f->face = zeros(call, f->faces * sizeof *f->face);
  return f->number && f->polygons && f->face;
}

bool
sg_door_known_facets(sg_call *call, const sg_known_segment_list *known,
                     const sg_int_list *ss, sg_known_segment_list *facets)
{
  sg_known_surfaces surfaces = {0};
  numbering f = {.surfaces = &surfaces};
  sg_dense dense = {0};
  bool good = sg_dense_read_these(call, ss, &dense) &&
              sg_known_surfaces_read(call, known, &dense, &surfaces);

  good = sg_known_surfaces_adopt(call, &surfaces) && good &&
         (!surfaces.of || (numbering_init(call, &f, &dense) &&
                           add_segments(call, &f, &dense, facets)));
  sg_dense_clear(&dense);
  return good;
}
