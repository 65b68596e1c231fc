/* census_faces.c -- areas, volumes, flatness, doubles (census.h). */
#include "census_private.h"

#include "engine/search.h"
#include "number/vector.h"
#include "polygon/flatness.h"
#include "polygon/plane.h"
#include "rows/edge_print.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Adds a triangle, seen from `o`, to its polygon. */
static void
add_triangle(sg_counting *c, size_t t, const double o[3])
{
  const sg_dense *d = c->d;
  size_t p = (size_t)d->polygon_of[t];
  double a[3], u[3], v[3], n[3];

  for (int k = 0; k < 3; k++) {
    double first = d->at[d->corner[t][0]][k];
    a[k] = first - o[k];
    u[k] = d->at[d->corner[t][1]][k] - first;
    v[k] = d->at[d->corner[t][2]][k] - first;
  }
  sg_cross(u, v, n);
  c->triangles[p]++;
  c->area[p] += sg_any_length(n) / 2;
  c->volume[p] += a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
  for (int k = 0; k < 3; k++) {
    c->sides[p] += sg_edge_print((uint32_t)d->corner[t][k],
                                 (uint32_t)d->corner[t][(k + 1) % 3]);
  }
}

typedef struct measures {
  sg_newell sum;
  double off;             /* the farthest that a vertex is off its plane */
  double longest, around; /* edge, sum of the edges */
  uint64_t sides;
} measures;

/* False: polygon p has no plane. */
static bool
measure(const sg_counting *c, size_t p, measures *m)
{
  const sg_dense *d = c->d;
  sg_plane plane;

  *m = (measures){.off = 0};
  sg_newell_init(&m->sum);
  for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    const double *a = d->at[d->from[d->list[k]]];
    const double *b = d->at[d->to[d->list[k]]];
    double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
    double edge = sqrt(x * x + y * y + z * z);
    sg_newell_edge(&m->sum, a, b);
    m->longest = fmax(m->longest, edge);
    m->around += edge;
    m->sides += sg_edge_print((uint32_t)d->from[d->list[k]],
                              (uint32_t)d->to[d->list[k]]);
  }
  if (!sg_newell_plane(&m->sum, &plane)) {
    return false;
  }
  size_t n = d->list_begin[p + 1] - d->list_begin[p];
  for (size_t k = d->list_begin[p]; n > 3 && k < d->list_begin[p + 1]; k++) {
    const double *at = d->at[d->from[d->list[k]]];
    m->off = fmax(m->off, fabs(sg_plane_distance(&plane, at)));
  }
  return true;
}

/* Without triangles: those of a flat face, from its area vector. */
static void
add_face(sg_counting *c, size_t p, const sg_newell *sum, const double o[3])
{
  const double *n = sum->doubled;

  c->area[p] = sg_newell_area(sum);
  for (int k = 0; k < 3; k++) {
    c->volume[p] += (sum->origin[k] - o[k]) * n[k];
  }
}

/* Triangles fill a flat polygon once if they end where it ends and none is
 * turned over, so that they have its area. */
static bool
triangles_fill(const sg_counting *c, size_t p, const measures *m)
{
  double corners = (double)(c->d->list_begin[p + 1] - c->d->list_begin[p]);
  double enough = c->part->tolerance * m->around * corners;

  return c->sides[p] == m->sides &&
         (m->off > c->part->tolerance ||
          c->area[p] <= sg_newell_area(&m->sum) + enough);
}

/* Is what the model has for the plane of polygon p its plane? */
static bool
has_own_plane(const sg_counting *c, size_t p, const measures *m)
{
  const sg_dense *d = c->d;
  const double *own = c->plane[p], *n = m->sum.doubled;
  double enough = 16 * c->part->tolerance + m->off;

  if (isnan(own[0])) {
    return true;
  }
  for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    const double *at = d->at[d->from[d->list[k]]];
    double off = own[0] * at[0] + own[1] * at[1] + own[2] * at[2] + own[3];
    if (!(fabs(off) <= enough)) {
      return false;
    }
  }
  return own[0] * n[0] + own[1] * n[1] + own[2] * n[2] > 0 &&
         fabs(sg_any_length(own) - 1) < 1e-6;
}

/* Twice the sum of the areas between a corner of polygon p and its edges: not 0
 * if its own area is because it crosses or overlaps itself. */
static double
fan_of(const sg_counting *c, size_t p)
{
  const sg_dense *d = c->d;
  double fan = 0;

  for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    const double *corner = d->at[d->from[d->list[d->list_begin[p]]]];
    sg_newell one;
    sg_newell_triangle(&one, corner, d->at[d->from[d->list[k]]],
                       d->at[d->to[d->list[k]]]);
    fan += 2 * sg_newell_area(&one);
  }
  return fan;
}

/* Whether polygon p crosses or overlaps itself: it has a plane, and no triangle
 * was found; or no plane, though it is no line. */
static bool
is_crossed(const sg_counting *c, size_t p, bool has_plane, const measures *m)
{
  return !c->triangles[p] &&
         (has_plane ? c->plane && !isnan(c->plane[p][0])
                    : fan_of(c, p) > c->part->tolerance * m->around);
}

/* What is kept of polygon p beside its corners, against these. */
static bool
note_derived(sg_counting *c, size_t p, const measures *m)
{
  int32_t id = c->d->polygon_id[p];

  return (!c->plane || has_own_plane(c, p, m) ||
          sg_census_note(c, SG_DEFECT_PLANE, id, 0)) &&
         (!c->triangles[p] || triangles_fill(c, p, m) ||
          sg_census_note(c, SG_DEFECT_TRIANGLES, id, 0));
}

bool
sg_census_faces(sg_counting *c)
{
  const sg_dense *d = c->d;
  double o[3], tolerance = c->part->tolerance;
  measures m;

  for (int k = 0; k < 3; k++) {
    o[k] = c->part->low[k] / 2 + c->part->high[k] / 2;
  }
  for (size_t t = d->triangle_begin[c->s]; t < d->triangle_begin[c->s + 1];
       t++) {
    if (sg_census_stops(c, t)) {
      return false;
    }
    add_triangle(c, t, o);
  }
  for (size_t p = d->polygon_begin[c->s]; p < d->polygon_begin[c->s + 1]; p++) {
    int32_t id = d->polygon_id[p];
    if (sg_census_stops(c, p)) {
      return false;
    }
    bool has_plane = measure(c, p, &m);
    if (!c->triangles[p] && has_plane) {
      add_face(c, p, &m.sum, o);
    }
    if (is_crossed(c, p, has_plane, &m)) {
      if (!sg_census_note(c, SG_DEFECT_CROSSED, id, 0)) {
        return false;
      }
    } else if (!has_plane ||
               sg_newell_area(&m.sum) * 2 <= tolerance * m.longest) {
      if (!sg_census_note(c, SG_DEFECT_FLAT, id, 0)) {
        return false;
      }
    } else if (!note_derived(c, p, &m) ||
               (m.off > tolerance &&
                !sg_census_note(c, SG_DEFECT_BENT, id, 0))) {
      return false;
    }
  }
  return true;
}

/* Doubles ------------------------------------------------------------------ */

typedef struct hashed {
  uint64_t hash;
  int32_t place;
} hashed;

SG_ORDER(compare_hashed, hashed, SG_BY(hash) SG_BY(place));

/* Those whose hashes have one upper half, mostly few, by all of it. */
static sg_sort_end
sort_alike(hashed *item, size_t n, const sg_cancel *cancel)
{
  sg_sort_end how = SG_SORTED;

  for (size_t i = 0, end; how == SG_SORTED && i < n; i = end) {
    for (end = i + 1; end < n && item[end].hash >> 32 == item[i].hash >> 32;
         end++) {
    }
    how = sg_sort(item + i, end - i, sizeof *item, compare_hashed, cancel);
  }
  return how;
}

/* In the order of compare_hashed(); their places ascend. */
static bool
sort_hashed(sg_counting *c, hashed *item, size_t n)
{
  uint64_t *key = malloc((n + 1) * sizeof *key);
  hashed *was = malloc((n + 1) * sizeof *was);
  bool good = key && was;

  for (size_t i = 0; good && i < n; i++) {
    key[i] = (item[i].hash & UINT64_C(0xffffffff00000000)) | i;
    was[i] = item[i];
  }
  good = good && sg_sort_upper(key, n);
  for (size_t i = 0; good && i < n; i++) {
    item[i] = was[(uint32_t)key[i]];
  }
  free(key);
  free(was);
  sg_sort_end end = good ? sort_alike(item, n, c->cancel) : SG_SORT_NO_MEMORY;

  c->stopped = c->stopped || end == SG_SORT_STOPPED || sg_cancelled(c->cancel);
  return end == SG_SORTED && !c->stopped;
}

/* Is each of the vertices of polygon p one of q, and as many? */
static bool
same_vertices(sg_counting *c, size_t p, size_t q)
{
  const sg_dense *d = c->d;
  size_t n = d->list_begin[p + 1] - d->list_begin[p];

  if (n != d->list_begin[q + 1] - d->list_begin[q]) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    bool found = false;
    for (size_t k = 0; k < n && !found; k++) {
      found = d->from[d->list[d->list_begin[p] + i]] ==
              d->from[d->list[d->list_begin[q] + k]];
    }
    if (!found) {
      return false;
    }
  }
  return true;
}

bool
sg_census_doubles(sg_counting *c)
{
  const sg_dense *d = c->d;
  size_t begin = d->polygon_begin[c->s], n = c->part->polygons;
  hashed *face = malloc((n + 1) * sizeof *face);
  bool done = face != NULL;

  for (size_t i = 0; done && i < n; i++) {
    size_t p = begin + i;
    face[i] = (hashed){0, (int32_t)p};
    for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
      face[i].hash += sg_spread_bits((uint64_t)d->from[d->list[k]]);
    }
    done = !sg_census_stops(c, i);
  }
  done = done && sort_hashed(c, face, n);
  for (size_t i = 1; done && i < n; i++) {
    size_t p = (size_t)face[i - 1].place, q = (size_t)face[i].place;
    if (face[i].hash == face[i - 1].hash && same_vertices(c, p, q)) {
      done = sg_census_note(c, SG_DEFECT_DUPLICATE, d->polygon_id[p],
                            d->polygon_id[q]);
    }
  }
  free(face);
  return done;
}

/* Vertices ----------------------------------------------------------------- */

static bool
note_twins(sg_counting *c, size_t begin, size_t end)
{
  const sg_dense *d = c->d;
  hashed *at = malloc((end - begin + 1) * sizeof *at);
  size_t n = end - begin;
  bool done = at != NULL;

  for (size_t i = 0; done && i < n; i++) {
    uint64_t bits[3];
    memcpy(bits, d->at[begin + i], sizeof bits);
    at[i] = (hashed){
        sg_spread_bits(sg_spread_bits(sg_spread_bits(bits[0]) + bits[1]) +
                       bits[2]),
        (int32_t)(begin + i)};
  }
  done = done && sort_hashed(c, at, n);
  for (size_t i = 1; done && i < n; i++) {
    int32_t v = at[i - 1].place, w = at[i].place;
    if (at[i].hash == at[i - 1].hash &&
        !memcmp(d->at[v], d->at[w], sizeof d->at[v])) {
      done =
          sg_census_note(c, SG_DEFECT_TWIN, d->vertex_id[v], d->vertex_id[w]);
    }
  }
  free(at);
  return done;
}

/* Marks the ends of edges (seen = UINT32_MAX); notes short edges. */
static bool
note_edges(sg_counting *c)
{
  const sg_dense *d = c->d;

  for (size_t e = d->edge_begin[c->s]; e < d->edge_begin[c->s + 1]; e++) {
    const double *a = d->at[d->from[e]], *b = d->at[d->to[e]];
    double length =
        sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) +
             (b[2] - a[2]) * (b[2] - a[2]));
    if (sg_census_stops(c, e)) {
      return false;
    }
    c->seen[d->from[e]] = c->seen[d->to[e]] = UINT32_MAX;
    if (c->owner[e] < 0) {
      c->part->length += length;
    }
    /* Of a pair, once. */
    if (length <= c->part->tolerance &&
        (c->opposite[e] < 0 || c->opposite[e] > (int32_t)e) &&
        !sg_census_note(c, SG_DEFECT_SHORT, d->edge_id[e], 0)) {
      return false;
    }
  }
  return true;
}

static void
measure_box(sg_counting *c, size_t begin, size_t end)
{
  sg_flatness flatness;
  sg_part *part = c->part;

  sg_flatness_init(&flatness, c->d->grain[c->s]);
  for (size_t v = begin; v < end; v++) {
    sg_flatness_see(&flatness, c->d->at[v]);
    for (int k = 0; k < 3; k++) {
      double x = c->d->at[v][k];
      part->low[k] = v == begin ? x : fmin(part->low[k], x);
      part->high[k] = v == begin ? x : fmax(part->high[k], x);
    }
  }
  part->tolerance = begin < end ? sg_flatness_flat(&flatness) : 0;
}

bool
sg_census_vertices(sg_counting *c)
{
  const sg_dense *d = c->d;
  size_t begin = d->vertex_begin[c->s], end = d->vertex_begin[c->s + 1];

  measure_box(c, begin, end);
  if (!note_edges(c) || !note_twins(c, begin, end)) {
    return false;
  }
  for (size_t v = begin; v < end; v++) {
    if ((!c->seen[v] &&
         !sg_census_note(c, SG_DEFECT_UNUSED, d->vertex_id[v], 0)) ||
        (c->fans[v] > 1 &&
         !sg_census_note(c, SG_DEFECT_PINCHED, d->vertex_id[v], c->fans[v]))) {
      return false;
    }
  }
  return true;
}
