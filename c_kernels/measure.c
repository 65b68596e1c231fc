/* measure.c -- see measure.h. */
#include "measure.h"

#include "sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Angles that sum to a whole turn but for this are flat; radians. */
#define FLAT 1e-9

enum { POLL_EVERY = 16384 };

/* Asked for every i; true: the poll says stop. */
static bool
stops(size_t i, const sg_poll *poll, bool *stopped)
{
  *stopped = *stopped || (i % POLL_EVERY == 0 && sg_poll_stop(poll));
  return *stopped;
}

/* ---- seams -------------------------------------------------------------- */

static bool
is_seam(const sg_flattening *fl, size_t j)
{
  return !fl->joints->joint[j].line &&
         !sg_joint_is_fold((sg_joint_state)fl->state[j]);
}

static int32_t
end_of(const sg_flattening *fl, uint32_t j, int end)
{
  return fl->joints->joint[j].vertex[end];
}

/* Seams by their ends: those at vertex v are seam[begin[v]] .. */
typedef struct welds {
  uint32_t *begin, *seam; /* [vertices + 2], [2 * joints] */
  bool *done;             /* [joints] */
} welds;

static bool
find_welds(const sg_flattening *fl, const sg_poll *poll, welds *w,
           bool *stopped)
{
  size_t n = fl->joints->n, vertices = fl->dense->vertices;

  *w = (welds){calloc(vertices + 2, sizeof *w->begin),
               malloc((2 * n + 1) * sizeof *w->seam),
               calloc(n + 1, sizeof *w->done)};
  if (!w->begin || !w->seam || !w->done) {
    return false;
  }
  for (int pass = 0; pass < 2; pass++) {
    for (uint32_t j = 0; j < n && !stops(j, poll, stopped); j++) {
      for (int end = 0; is_seam(fl, j) && end < 2; end++) {
        int32_t v = end_of(fl, j, end);
        if (pass == 0) {
          w->begin[v + 2]++;
        } else {
          w->seam[w->begin[v + 1]++] = j;
        }
      }
    }
    for (size_t v = 0; pass == 0 && v < vertices; v++) {
      w->begin[v + 2] += w->begin[v + 1];
    }
  }
  return !*stopped;
}

static uint32_t
seams_at(const welds *w, int32_t v)
{
  return w->begin[v + 1] - w->begin[v];
}

/* From vertex v along seam j, and on while two seams meet. */
static double
follow(const sg_flattening *fl, welds *w, uint32_t j, int32_t v)
{
  double length = 0;

  for (;;) {
    w->done[j] = true;
    length += fl->joints->joint[j].length;
    v = end_of(fl, j, 0) == v ? end_of(fl, j, 1) : end_of(fl, j, 0);
    if (seams_at(w, v) != 2) {
      return length;
    }
    const uint32_t *two = &w->seam[w->begin[v]];
    uint32_t next = two[0] == j ? two[1] : two[0];
    if (w->done[next]) {
      return length;
    }
    j = next;
  }
}

static bool
measure_seams(const sg_flattening *fl, welds *w, const sg_poll *poll,
              sg_measures *out, bool *stopped)
{
  for (uint32_t j = 0; j < fl->joints->n; j++) {
    out->seam += is_seam(fl, j) ? fl->joints->joint[j].length : 0;
  }
  for (int rings = 0; rings < 2; rings++) { /* at last those without an end */
    for (uint32_t j = 0; j < fl->joints->n && !stops(j, poll, stopped); j++) {
      for (int end = 0; end < 2 && is_seam(fl, j); end++) {
        int32_t v = end_of(fl, j, end);
        if (!w->done[j] && (rings || seams_at(w, v) != 2)) {
          out->longest = fmax(out->longest, follow(fl, w, j, v));
        }
      }
    }
  }
  return !*stopped;
}

/* ---- the tree ----------------------------------------------------------- */

static uint32_t
find(uint32_t *class, uint32_t v)
{
  while (class[v] != v) {
    class[v] = class[class[v]];
    v = class[v];
  }
  return v;
}

/* Vertices on the border are one. */
static bool
unite_border(const sg_flattening *fl, uint32_t *class, bool *border,
             const sg_poll *poll, bool *stopped)
{
  const sg_flat_faces *f = fl->faces;
  uint32_t first = UINT32_MAX;

  for (uint32_t k = 0; k < f->sides && !stops(k, poll, stopped); k++) {
    uint32_t e = f->side[k].edge;
    bool real = e >= fl->dense->edges || fl->dense->real[e];
    if (real && fl->joints->of_side[k] == SG_NO_JOINT) {
      const int32_t v[2] = {sg_flat_side_from(f, k), sg_flat_side_to(f, k)};
      for (int end = 0; end < 2; end++) {
        border[v[end]] = true;
        first = first == UINT32_MAX ? (uint32_t)v[end] : first;
        class[find(class, (uint32_t)v[end])] = find(class, first);
      }
    }
  }
  return !*stopped;
}

static bool
measure_tree(const sg_flattening *fl, uint32_t *class, const sg_poll *poll,
             sg_measures *out, bool *stopped)
{
  size_t n = 0;
  sg_measured *item = malloc((fl->joints->n + 1) * sizeof *item);

  for (uint32_t j = 0; item && j < fl->joints->n; j++) {
    if (!fl->joints->joint[j].line) {
      item[n++] = (sg_measured){fl->joints->joint[j].length, j};
    }
  }
  sg_sort_end sorted =
      item ? sg_sort_measured(item, n, poll) : SG_SORT_NO_MEMORY;

  *stopped = sorted == SG_SORT_STOPPED;
  for (size_t i = 0; sorted == SG_SORTED && i < n && !stops(i, poll, stopped);
       i++) {
    uint32_t a = find(class, (uint32_t)end_of(fl, item[i].of, 0));
    uint32_t b = find(class, (uint32_t)end_of(fl, item[i].of, 1));
    if (a != b) {
      class[a] = b;
      out->tree += item[i].value;
    }
  }
  free(item);
  return sorted == SG_SORTED && !*stopped;
}

/* The angle of a triangle at its corner k. */
static double
angle_at(const sg_flat_faces *f, const uint32_t corner[3], int k)
{
  const double *p = f->at[corner[k]];
  const double *q = f->at[corner[(k + 1) % 3]], *r = f->at[corner[(k + 2) % 3]];
  double ux = q[0] - p[0], uy = q[1] - p[1], wx = r[0] - p[0], wy = r[1] - p[1];

  return fabs(atan2(ux * wy - uy * wx, ux * wx + uy * wy));
}

/* Whether every vertex of a face that is not on the border is pointed. */
static bool
all_pointed(const sg_flattening *fl, const bool *border, const sg_poll *poll,
            bool *pointed, bool *stopped)
{
  const sg_flat_faces *f = fl->faces;
  double *sum = calloc(fl->dense->vertices + 1, sizeof *sum);

  *pointed = true;
  for (size_t t = 0; sum && t < f->triangles && !stops(t, poll, stopped); t++) {
    for (int k = 0; k < 3; k++) {
      sum[f->vertex[f->triangle[t][k]]] += angle_at(f, f->triangle[t], k);
    }
  }
  for (size_t v = 0; sum && v < fl->dense->vertices; v++) {
    *pointed &= border[v] || sum[v] < 2 * acos(-1.0) - FLAT;
  }
  free(sum);
  return sum && !*stopped;
}

static bool
find_bound(const sg_flattening *fl, const sg_poll *poll, sg_measures *out,
           bool *stopped)
{
  size_t vertices = fl->dense->vertices;
  uint32_t *class = malloc((vertices + 1) * sizeof *class);
  bool *border = calloc(vertices + 1, sizeof *border);
  bool good = class && border;

  for (uint32_t v = 0; good && v < vertices; v++) {
    class[v] = v;
  }
  good = good && unite_border(fl, class, border, poll, stopped) &&
         measure_tree(fl, class, poll, out, stopped) &&
         all_pointed(fl, border, poll, &out->pointed, stopped);
  free(class);
  free(border);
  return good;
}

bool
sg_measure(const sg_flattening *fl, const sg_layout *layout,
           const sg_poll *poll, sg_measures *out, bool *stopped)
{
  welds w = {0};

  *out = (sg_measures){.area = fl->sheet * fl->sheet};
  *stopped = false;
  for (size_t k = 0; k < layout->pieces; k++) {
    const sg_flat_box *box = &layout->box[k];
    out->boxes += (box->high[0] - box->low[0]) * (box->high[1] - box->low[1]);
  }
  bool good = find_welds(fl, poll, &w, stopped) &&
              measure_seams(fl, &w, poll, out, stopped) &&
              find_bound(fl, poll, out, stopped);

  free(w.begin);
  free(w.seam);
  free(w.done);
  return good;
}
