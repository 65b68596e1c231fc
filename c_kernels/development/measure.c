/* measure.c -- see measure.h. */
#include "measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Asked for every i; true: the cancellation says stop. */
static bool
stops(size_t i, const sg_cancel *cancel, bool *stopped)
{
  *stopped = *stopped || sg_cancel_every(cancel, i);
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
find_welds(const sg_flattening *fl, const sg_cancel *cancel, welds *w,
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
    for (uint32_t j = 0; j < n && !stops(j, cancel, stopped); j++) {
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
measure_seams(const sg_flattening *fl, welds *w, const sg_cancel *cancel,
              sg_measures *out, bool *stopped)
{
  for (uint32_t j = 0; j < fl->joints->n && !stops(j, cancel, stopped); j++) {
    out->seam += is_seam(fl, j) ? fl->joints->joint[j].length : 0;
  }
  for (int rings = 0; rings < 2; rings++) { /* at last those without an end */
    for (uint32_t j = 0; j < fl->joints->n && !stops(j, cancel, stopped); j++) {
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

/* Of the box round all pieces. */
static double
sheet_area(const sg_layout *layout)
{
  double size[2] = {0, 0};

  for (int axis = 0; axis < 2; axis++) {
    double low = INFINITY, high = -INFINITY;
    for (size_t k = 0; k < layout->pieces; k++) {
      low = fmin(low, layout->box[k].low[axis]);
      high = fmax(high, layout->box[k].high[axis]);
    }
    size[axis] = fmax(high - low, 0);
  }
  return size[0] * size[1];
}

bool
sg_measure(const sg_flattening *fl, const sg_layout *layout,
           const sg_cancel *cancel, sg_measures *out, bool *stopped)
{
  welds w = {0};

  *out = (sg_measures){.area = fl->sheet * fl->sheet};
  *stopped = false;
  out->sheet = sheet_area(layout);
  bool good = find_welds(fl, cancel, &w, stopped) &&
              measure_seams(fl, &w, cancel, out, stopped);

  free(w.begin);
  free(w.seam);
  free(w.done);
  return good;
}
