/* face_merge_mesh.c -- half-edges, their twins, and neighbours that might be
 * one face: see face_merge_private.h.
 *
 * Layer: kernel. Everything a million triangles need that stay as they are; so
 * it goes by the places of vertices, each thread at its own.
 */
#include "engine/search.h"
#include "face_merge_private.h"

#include "engine/list.h"
#include "join/bvh.h"
#include "number/vector.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  RANGES = 8,      /* of vertices at most: each goes over all triangles */
  BLOCK = 1 << 12, /* vertices, or faces, a task */
  LONG = 24,       /* lists longer than this are sorted */
  SIZE = 13 /* the tolerance is at most 2^-SIZE of the size, if by_size */
};

typedef struct edge_list {
  uint32_t (*pair)[2];
  size_t n, room;
} edge_list;

/* What a task has found. */
typedef struct finds {
  edge_list weak;  /* faces */
  edge_list brief; /* vertices */
  size_t twins;    /* pairs */
  bool no_memory;
} finds;

typedef struct pairing {
  sg_merge *m;
  finds *found; /* [blocks] */
} pairing;

/* ---- lists of half-edges ------------------------------------------------ */

static uint32_t
range_from(const sg_merge *m, size_t range)
{
  return (uint32_t)(m->solid->vertices * range / m->ranges);
}

static void
count_leaving(void *data, size_t range)
{
  const sg_merge *m = data;
  uint32_t low = range_from(m, range), width = range_from(m, range + 1) - low;
  const uint32_t *corner = (const uint32_t *)m->solid->triangle;

  for (size_t i = 0; i < 3 * m->solid->triangles; i++) {
    if (corner[i] - low < width) {
      m->first[corner[i] + 2]++;
    }
  }
}

static void
list_leaving(void *data, size_t range)
{
  const sg_merge *m = data;
  uint32_t low = range_from(m, range), width = range_from(m, range + 1) - low;

  for (size_t t = 0; t < m->solid->triangles; t++) {
    const uint32_t *corner = m->solid->triangle[t];
    for (uint32_t k = 0; k < 3; k++) {
      if (corner[k] - low < width) {
        m->leaving[m->first[corner[k] + 1]++] =
            (sg_leaving){corner[k == 2 ? 0 : k + 1], 3 * (uint32_t)t + k};
      }
    }
  }
}

/* By end, then by number. */
SG_ORDER(compare_leaving, sg_leaving, SG_BY(to) SG_BY(half));

static void
sort_long(void *data, size_t block)
{
  const sg_merge *m = data;
  size_t to = (block + 1) * BLOCK;

  for (size_t v = block * BLOCK; v < to && v < m->solid->vertices; v++) {
    size_t n = m->first[v + 1] - m->first[v];
    if (n > LONG && !sg_pool_stopping()) {
      qsort(m->leaving + m->first[v], n, sizeof *m->leaving, compare_leaving);
    }
  }
}

/* How many half-edges go from -> to; *half: one of them. */
static unsigned
count_between(const sg_merge *m, uint32_t from, uint32_t to, uint32_t *half)
{
  const sg_leaving *list = m->leaving + m->first[from];
  size_t n = m->first[from + 1] - m->first[from], low;
  unsigned count = 0;

  if (n > LONG) {
    SG_SEARCH(low, 0, n, list[low].to < to);
    for (; low < n && list[low].to == to; low++) {
      *half = list[low].half;
      count++;
    }
    return count;
  }
  for (size_t i = 0; i < n; i++) {
    if (list[i].to == to) {
      *half = list[i].half;
      count++;
    }
  }
  return count;
}

/* ---- neighbours --------------------------------------------------------- */

/* The third corner of the triangle of a half-edge between these two. */
static uint32_t
third_corner(const sg_merge *m, const uint32_t end[2], uint32_t half)
{
  const uint32_t *v = m->solid->triangle[half / 3];

  return v[0] ^ v[1] ^ v[2] ^ end[0] ^ end[1];
}

/* Whether the four corners of two triangles may lie between two planes that are
 * two tolerances apart. Then the parts of u, v and w along the planes' normal
 * are not longer than that, so the volume that they span is no larger than this
 * times the three areas; no normal is asked, which slivers do not have. Areas
 * are no larger than the products of their sides, which mostly tell enough. */
static bool
is_flat(const sg_merge *m, const uint32_t end[2], uint32_t half, uint32_t twin)
{
  const double *a = sg_merge_at(m, end[0]), *b = sg_merge_at(m, end[1]);
  const double *c = sg_merge_at(m, third_corner(m, end, half));
  const double *d = sg_merge_at(m, third_corner(m, end, twin));
  double u[3], v[3], w[3], uv[3], vw[3], uw[3];
  /* (x + y + z)^2 <= 3 (x^2 + y^2 + z^2); twice of it for rounding */
  double factor = 24 * m->tolerance * m->tolerance;

  for (int k = 0; k < 3; k++) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    w[k] = d[k] - a[k];
  }
  sg_cross(u, v, uv);
  double volume = sg_dot(uv, w), uu = sg_dot(u, u), vv = sg_dot(v, v),
         ww = sg_dot(w, w);
  if (volume * volume > factor * (uu * vv + vv * ww + uu * ww)) {
    return false;
  }
  sg_cross(v, w, vw);
  sg_cross(u, w, uw);
  return volume * volume <=
         factor * (sg_dot(uv, uv) + sg_dot(vw, vw) + sg_dot(uw, uw));
}

/* The parts of a face. */
static size_t
parts_of(const sg_solid *solid, uint32_t face, size_t *end)
{
  size_t at;

  SG_SEARCH(at, 0, solid->parts, solid->part[at].face < face);
  for (*end = at; *end < solid->parts && solid->part[*end].face == face;
       ++*end) {
  }
  return at;
}

/* Whether all segments that face f came from are among those of g. */
static bool
has_sources_of(const sg_solid *solid, uint32_t f, uint32_t g)
{
  size_t end, last, first = parts_of(solid, g, &last);
  bool all = true;

  for (size_t i = parts_of(solid, f, &end); all && i <= end; i++) {
    int32_t s = i < end ? solid->part[i].s : solid->face[f].s;

    all = s == solid->face[g].s;
    for (size_t k = first; !all && k < last; k++) {
      all = s == solid->part[k].s;
    }
  }
  return all;
}

static bool
have_same_sources(const sg_solid *solid, uint32_t f, uint32_t g)
{
  return solid->parts == 0
             ? solid->face[f].s == solid->face[g].s
             : has_sources_of(solid, f, g) && has_sources_of(solid, g, f);
}

bool
sg_merge_may_join(const sg_merge *m, uint32_t f, uint32_t g)
{
  const sg_solid_face *a = &m->solid->face[f], *b = &m->solid->face[g];
  const sg_merge_options *options = m->options;
  sg_merge_pair pair = {{a->s, a->p, a->reversed}, {b->s, b->p, b->reversed}};

  if (options->separate && !have_same_sources(m->solid, f, g)) {
    return false;
  }
  if (options->aparts == 0) {
    return true;
  }
  sg_merge_pair_order(&pair);
  return !bsearch(&pair, options->apart, options->aparts, sizeof pair,
                  sg_merge_pair_compare);
}

static void
note(finds *found, edge_list *list, uint32_t a, uint32_t b)
{
  if (!sg_list_grow(&list->pair, list->n, &list->room, sizeof *list->pair)) {
    found->no_memory = true;
    return;
  }
  list->pair[list->n][0] = a;
  list->pair[list->n++][1] = b;
}

static bool
is_brief(const sg_merge *m, uint32_t v, uint32_t w)
{
  const double *a = sg_merge_at(m, v), *b = sg_merge_at(m, w);
  double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};

  return sg_dot(d, d) <= m->tolerance * m->tolerance;
}

/* Half-edges between vertices end[0] and end[1]. */
static void
make_twins(const sg_merge *m, finds *found, const uint32_t end[2],
           uint32_t half, uint32_t twin)
{
  m->twin[half] = twin;
  m->twin[twin] = half;
  found->twins++;
  if (!is_flat(m, end, half, twin)) {
    return; /* most of a smooth mesh: their faces need not be looked up */
  }
  uint32_t f = m->face_of[half / 3], g = m->face_of[twin / 3];
  if (f != g && sg_merge_may_join(m, f, g)) {
    note(found, &found->weak, f, g);
  }
}

/* A half-edge a -> b that has no twin yet, of a face if that is not
 * SG_NOTHING; *more: there are others. */
static uint32_t
next_single(const sg_merge *m, uint32_t a, uint32_t b, uint32_t face,
            bool *more)
{
  uint32_t half = SG_NOTHING;

  *more = false;
  for (uint32_t i = m->first[a]; i < m->first[a + 1]; i++) {
    uint32_t h = m->leaving[i].half;
    if (m->leaving[i].to != b || m->twin[h] != SG_NOTHING ||
        (face != SG_NOTHING && m->face_of[h / 3] != face)) {
      continue;
    }
    if (half != SG_NOTHING) {
      *more = true;
      break;
    }
    half = h;
  }
  return half;
}

/* Where there are more than two: those that are opposite in one face are a
 * chord of it, and no edge. Of what remains there may be one each way. */
static void
pair_many(const sg_merge *m, uint32_t v, uint32_t to, finds *found)
{
  uint32_t half, twin;
  bool more, more_twins;

  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    half = m->leaving[i].half;
    if (m->leaving[i].to == to && m->twin[half] == SG_NOTHING) {
      twin = next_single(m, to, v, m->face_of[half / 3], &more);
      if (twin != SG_NOTHING) {
        make_twins(m, found, (const uint32_t[2]){v, to}, half, twin);
      }
    }
  }
  half = next_single(m, v, to, SG_NOTHING, &more);
  twin = next_single(m, to, v, SG_NOTHING, &more_twins);
  if (half != SG_NOTHING && twin != SG_NOTHING && !more && !more_twins) {
    make_twins(m, found, (const uint32_t[2]){v, to}, half, twin);
  }
}

/* Finds the twins of the half-edges between v and later vertices. */
static void
pair_halves(const pairing *mesh, uint32_t v, finds *found)
{
  const sg_merge *m = mesh->m;

  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    uint32_t to = m->leaving[i].to, half = m->leaving[i].half, twin = 0;
    uint32_t other = 0;
    if (to <= v || m->twin[half] != SG_NOTHING) {
      continue;
    }
    if (is_brief(m, v, to)) {
      note(found, &found->brief, v, to);
    }
    unsigned back = count_between(m, to, v, &twin);
    unsigned there = count_between(m, v, to, &other);
    if (back == 1 && there == 1) {
      make_twins(m, found, (const uint32_t[2]){v, to}, half, twin);
    } else if (back > 0 && other == half && !m->options->cells) {
      /* once, at the last of them */
      pair_many(m, v, to, found);
    }
  }
}

static void
pair_block(void *data, size_t block)
{
  const pairing *mesh = data;
  const sg_merge *m = mesh->m;
  size_t to = (block + 1) * BLOCK;

  for (size_t v = block * BLOCK; v < to && v < m->solid->vertices; v++) {
    if (v % 256 == 0 && sg_pool_stopping()) {
      return;
    }
    pair_halves(mesh, (uint32_t)v, &mesh->found[block]);
  }
}

/* ---- all of it ---------------------------------------------------------- */

static bool
run(const sg_merge *m, size_t tasks, sg_pool_task *task, void *data)
{
  return sg_pool_run(m->options->pool, tasks, task, data, m->options->cancel);
}

/* The triangles of a block of faces: whose they are, and no twins yet. */
static void
note_faces(void *data, size_t block)
{
  const sg_merge *m = data;
  size_t to = (block + 1) * BLOCK;

  for (size_t f = block * BLOCK; f < to && f < m->solid->faces; f++) {
    const sg_solid_face *face = &m->solid->face[f];
    for (size_t t = face->first; t < (size_t)face->first + face->n; t++) {
      m->face_of[t] = (uint32_t)f;
      for (int k = 0; k < 3; k++) {
        m->twin[3 * t + (size_t)k] = SG_NOTHING;
      }
    }
  }
}

/* The tolerance of all that is in a box. */
static double
tolerance_in(const sg_merge *m, const sg_box *box, double *rounding)
{
  double largest = 0, size = 0, tolerance = m->options->tolerance;

  for (int k = 0; k < 3 && m->solid->triangles; k++) {
    largest = fmax(largest, fmax(fabs(box->lo[k]), fabs(box->hi[k])));
    size = fmax(size, box->hi[k] - box->lo[k]);
  }
  *rounding = 4 * DBL_EPSILON * largest;
  if (m->options->by_size) {
    tolerance = fmin(tolerance, ldexp(size, -SIZE));
  }
  return fmax(tolerance, *rounding);
}

/* Where the lists of vertices begin; and the tolerance: only vertices that have
 * any count. */
static void
begin_lists(sg_merge *m)
{
  const sg_merge_region *region = m->options->region;
  sg_box box = region ? region->box : sg_box_none();
  double rounding;

  for (uint32_t v = 0; v < m->solid->vertices; v++) {
    if (m->first[v + 2] > 0) {
      sg_box_add(&box, sg_merge_at(m, v));
    }
    m->first[v + 2] += m->first[v + 1];
  }
  m->tolerance = tolerance_in(m, &box, &m->rounding);
  m->others = region ? tolerance_in(m, &region->was, &rounding) : m->tolerance;
}

static bool
lists_made(sg_merge *m, size_t blocks)
{
  if (!run(m, m->ranges, count_leaving, m)) {
    return false;
  }
  begin_lists(m);
  return run(m, m->ranges, list_leaving, m) && run(m, blocks, sort_long, m);
}

/* The lists of all blocks, in their order: the weak ones, or the brief. Null:
 * no memory. */
static uint32_t (*gather(const finds *found, size_t blocks, bool brief,
                         size_t *n))[2]
{
  uint32_t(*all)[2];

  *n = 0;
  for (size_t i = 0; i < blocks; i++) {
    *n += brief ? found[i].brief.n : found[i].weak.n;
  }
  all = malloc((*n + 1) * sizeof *all);
  *n = 0;
  for (size_t i = 0; all && i < blocks; i++) {
    const edge_list *list = brief ? &found[i].brief : &found[i].weak;
    if (list->n) {
      memcpy(all + *n, list->pair, list->n * sizeof *all);
    }
    *n += list->n;
  }
  return all;
}

static sg_merge_end
gather_all(sg_merge *m, const finds *found, size_t blocks)
{
  size_t twins = 0;

  for (size_t i = 0; i < blocks; i++) {
    twins += found[i].twins;
    if (found[i].no_memory) {
      return SG_MERGE_NO_MEMORY;
    }
  }
  m->regular = 2 * twins == 3 * m->solid->triangles;
  m->weak = gather(found, blocks, false, &m->weaks);
  m->brief = gather(found, blocks, true, &m->briefs);
  return m->weak && m->brief ? SG_MERGE_DONE : SG_MERGE_NO_MEMORY;
}

sg_merge_end
sg_merge_mesh(sg_merge *m)
{
  const sg_solid *solid = m->solid;
  size_t blocks = (solid->vertices + BLOCK - 1) / BLOCK;
  size_t halves = 3 * solid->triangles;
  pairing mesh = {m, calloc(blocks + 1, sizeof *mesh.found)};
  sg_merge_end end = SG_MERGE_NO_MEMORY;

  unsigned threads = sg_pool_threads(m->options->pool);

  m->ranges = threads < RANGES ? threads : RANGES;
  m->face_of = malloc((solid->triangles + 1) * sizeof *m->face_of);
  m->first = calloc(solid->vertices + 2, sizeof *m->first);
  m->leaving = malloc((halves + 1) * sizeof *m->leaving);
  m->twin = malloc((halves + 1) * sizeof *m->twin);
  if (mesh.found && m->face_of && m->first && m->leaving && m->twin) {
    end = run(m, (solid->faces + BLOCK - 1) / BLOCK, note_faces, m) &&
                  lists_made(m, blocks) && run(m, blocks, pair_block, &mesh)
              ? gather_all(m, mesh.found, blocks)
              : SG_MERGE_STOPPED;
  }
  for (size_t i = 0; mesh.found && i < blocks; i++) {
    free(mesh.found[i].weak.pair);
    free(mesh.found[i].brief.pair);
  }
  free(mesh.found);
  return end;
}

void
sg_merge_mesh_clear(sg_merge *m)
{
  free(m->face_of);
  free(m->first);
  free(m->leaving);
  free(m->twin);
  free(m->weak);
  free(m->brief);
  m->face_of = m->first = m->twin = NULL;
  m->leaving = NULL;
  m->weak = m->brief = NULL;
  m->weaks = m->briefs = 0;
}
