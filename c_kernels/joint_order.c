/* joint_order.c -- orders of joints, and ways along them: see flattening.h. */
#include "flattening.h"

#include "sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Added to what is measured in steps, so that flat joints come first. */
#define FIRST 0x1p52

double
sg_joint_step(const sg_flattening *fl)
{
  int exponent;

  frexp(fl->sheet, &exponent);
  return ldexp(1, exponent - 32);
}

void
sg_joint_middle(const sg_flattening *fl, uint32_t j, double out[3])
{
  const double *a = fl->dense->at[fl->joints->joint[j].vertex[0]];
  const double *b = fl->dense->at[fl->joints->joint[j].vertex[1]];

  for (int k = 0; k < 3; k++) {
    out[k] = (a[k] + b[k]) / 2;
  }
}

/* From 0 to 1, by chance but always the same. */
static double
chance(uint64_t number)
{
  number = (number ^ (number >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  number = (number ^ (number >> 27)) * UINT64_C(0x94d049bb133111eb);
  return (double)((number ^ (number >> 31)) >> 11) * 0x1p-53;
}

/* How much a joint should be tried soon, in steps. */
static double
merit(const sg_flattening *fl, uint32_t j, unsigned order, double step)
{
  const sg_joint *joint = &fl->joints->joint[j];

  if (order == SG_ORDER_FLATTEST) {
    return round((180 - fabs(joint->angle)) * 0x1p24);
  }
  if (order == SG_ORDER_STEEPEST) {
    double rise =
        fl->dense->at[joint->vertex[1]][2] - fl->dense->at[joint->vertex[0]][2];
    return joint->length > 0 ? round(fabs(rise) / joint->length * 0x1p32) : 0;
  }
  double stretch = order >= SG_ORDER_SHUFFLED
                       ? 1 + chance((uint64_t)order << 32 | j) / 10
                       : 1;

  return round(joint->length * stretch / step);
}

/* ---- equal ones --------------------------------------------------------- */

typedef struct tied {
  double middle[3]; /* steps */
  uint32_t joint;
} tied;

static int
compare_tied(const void *a, const void *b)
{
  const tied *x = a, *y = b;

  for (int k = 2; k >= 0; k--) {
    if (x->middle[k] != y->middle[k]) {
      return x->middle[k] > y->middle[k] ? -1 : 1;
    }
  }
  return (x->joint > y->joint) - (x->joint < y->joint);
}

static void
sort_tied(const sg_flattening *fl, sg_measured *item, size_t n, tied *room,
          double step)
{
  for (size_t i = 0; i < n; i++) {
    room[i].joint = item[i].of;
    sg_joint_middle(fl, item[i].of, room[i].middle);
    for (int k = 0; k < 3; k++) {
      room[i].middle[k] = round(room[i].middle[k] / step);
    }
  }
  qsort(room, n, sizeof *room, compare_tied);
  for (size_t i = 0; i < n; i++) {
    item[i].of = room[i].joint;
  }
}

static bool
sort_items(const sg_flattening *fl, sg_measured *item, size_t n)
{
  double step = sg_joint_step(fl);
  tied *room = malloc((n + 1) * sizeof *room);

  if (!room || !sg_sort_measured(item, n)) {
    free(room);
    return false;
  }
  for (size_t i = 0, end; i < n; i = end) {
    for (end = i + 1; end < n && item[end].value == item[i].value; end++) {
    }
    if (end > i + 1) {
      sort_tied(fl, item + i, end - i, room, step);
    }
  }
  free(room);
  return true;
}

uint32_t *
sg_joint_order(const sg_flattening *fl, unsigned order)
{
  size_t n = fl->joints->n;
  double step = sg_joint_step(fl);
  sg_measured *item = malloc((n + 1) * sizeof *item);
  uint32_t *out = malloc((n + 1) * sizeof *out);

  for (uint32_t j = 0; item && j < n; j++) {
    item[j] = (sg_measured){-merit(fl, j, order, step) -
                                (fl->joints->joint[j].flat ? FIRST : 0),
                            j};
  }
  if (!item || !out || !sort_items(fl, item, n)) {
    free(item);
    free(out);
    return NULL;
  }
  for (size_t i = 0; i < n; i++) {
    out[i] = item[i].of;
  }
  free(item);
  return out;
}

/* ---- ways --------------------------------------------------------------- */

/* A walk over what is joined: by which side each face was reached. */
typedef struct walk {
  uint32_t *by, *queue; /* [faces] */
} walk;

/* Until `to` is reached. */
static void
spread(const sg_flattening *fl, walk *w, uint32_t from, uint32_t to)
{
  const sg_flat_faces *f = fl->faces;
  size_t n = 0, next = 0;

  w->queue[n++] = from;
  w->by[from] = SG_NO_JOINT - 1;
  while (next < n && w->by[to] == SG_NO_JOINT) {
    uint32_t face = w->queue[next++];
    for (uint32_t k = f->side_begin[face]; k < f->side_begin[face + 1]; k++) {
      uint32_t j = fl->joints->of_side[k];
      if (j != SG_NO_JOINT && fl->state[j] == SG_JOINT_JOINED) {
        const sg_joint *joint = &fl->joints->joint[j];
        uint32_t other = joint->side[joint->side[0] == k];
        if (w->by[f->face_of[other]] == SG_NO_JOINT) {
          w->by[f->face_of[other]] = k;
          w->queue[n++] = f->face_of[other];
        }
      }
    }
  }
}

uint32_t *
sg_flattening_path(const sg_flattening *fl, uint32_t j, size_t *n)
{
  const sg_flat_faces *f = fl->faces;
  const sg_joint *joint = &fl->joints->joint[j];
  uint32_t from = f->face_of[joint->side[1]], to = f->face_of[joint->side[0]];
  walk w = {malloc((f->faces + 1) * sizeof *w.by),
            malloc((f->faces + 1) * sizeof *w.queue)};
  uint32_t *path = malloc((f->faces + 1) * sizeof *path);

  *n = 0;
  if (w.by && w.queue && path) {
    memset(w.by, 0xff, (f->faces + 1) * sizeof *w.by);
    spread(fl, &w, from, to);
    for (uint32_t face = to; w.by[to] != SG_NO_JOINT && face != from;
         face = f->face_of[w.by[face]]) {
      path[(*n)++] = fl->joints->of_side[w.by[face]];
    }
  } else {
    free(path);
    path = NULL;
  }
  free(w.by);
  free(w.queue);
  return path;
}
