/* joint_order.c -- orders of joints, and ways along folds: see flattening.h. */
#include "flattening.h"

#include "engine/search.h"
#include "rows/sort.h"

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

enum {
  MANY = 4096,  /* equal ones: to be sorted so that it can be stopped */
  ASKED = 16384 /* sorted from one cancel to the next */
};

typedef struct tied {
  double middle[3]; /* steps */
  uint32_t joint;
} tied;

SG_ORDER(compare_tied, tied,
         SG_BY_MOST(middle[2]) SG_BY_MOST(middle[1]) SG_BY_MOST(middle[0])
             SG_BY(joint));

/* An order under way. */
typedef struct sorter {
  const sg_flattening *fl;
  const sg_cancel *cancel;
  sg_measured *item;   /* [joints] */
  double (*middle)[3]; /* [joints] steps; joints in turn, as memory likes it */
  tied *room;          /* [joints] */
} sorter;

static sg_sort_end
sort_tied(const sorter *s, sg_measured *item, size_t n)
{
  sg_sort_end end = SG_SORTED;

  for (size_t i = 0; i < n; i++) {
    s->room[i].joint = item[i].of;
    memcpy(s->room[i].middle, s->middle[item[i].of], sizeof *s->middle);
  }
  if (n < MANY) {
    qsort(s->room, n, sizeof *s->room, compare_tied);
  } else {
    end = sg_sort(s->room, n, sizeof *s->room, compare_tied, s->cancel);
  }
  for (size_t i = 0; i < n; i++) {
    item[i].of = s->room[i].joint;
  }
  return end;
}

static sg_sort_end
sort_items(const sorter *s)
{
  size_t n = s->fl->joints->n, asked = 0;
  sg_sort_end sorted = sg_sort_measured(s->item, n, s->cancel);

  for (size_t i = 0, end; sorted == SG_SORTED && i < n; i = end) {
    for (end = i + 1; end < n && s->item[end].value == s->item[i].value;
         end++) {
    }
    if (end > i + 1) {
      sorted = sort_tied(s, s->item + i, end - i);
    }
    if (end - asked >= ASKED && sg_cancelled(s->cancel)) {
      return SG_SORT_STOPPED;
    }
    asked = end - asked >= ASKED ? end : asked;
  }
  return sorted;
}

/* What joints are sorted by. False: stopped by the cancellation. */
static bool
measure_joints(const sorter *s, unsigned order)
{
  double step = sg_joint_step(s->fl);

  for (uint32_t j = 0; j < s->fl->joints->n; j++) {
    if (sg_cancel_every(s->cancel, j)) {
      return false;
    }
    s->item[j] = (sg_measured){-merit(s->fl, j, order, step) -
                                   (s->fl->joints->joint[j].flat ? FIRST : 0),
                               j};
    sg_joint_middle(s->fl, j, s->middle[j]);
    for (int k = 0; k < 3; k++) {
      s->middle[j][k] = round(s->middle[j][k] / step);
    }
  }
  return true;
}

uint32_t *
sg_joint_order(const sg_flattening *fl, unsigned order, const sg_cancel *cancel,
               bool *stopped)
{
  size_t n = fl->joints->n + 1;
  sorter s = {.fl = fl,
              .cancel = cancel,
              .item = malloc(n * sizeof *s.item),
              .middle = malloc(n * sizeof *s.middle),
              .room = malloc(n * sizeof *s.room)};
  uint32_t *out = malloc(n * sizeof *out);
  sg_sort_end end = SG_SORT_NO_MEMORY;

  if (s.item && s.middle && s.room && out) {
    end = measure_joints(&s, order) ? sort_items(&s) : SG_SORT_STOPPED;
  }
  for (size_t i = 0; end == SG_SORTED && i < fl->joints->n; i++) {
    out[i] = s.item[i].of;
  }
  if (end != SG_SORTED) {
    free(out);
    out = NULL;
  }
  *stopped = end == SG_SORT_STOPPED;
  free(s.item);
  free(s.middle);
  free(s.room);
  return out;
}

/* ---- ways --------------------------------------------------------------- */

/* A walk over what is joined: by which side each face was reached. */
typedef struct walk {
  uint32_t *by, *queue; /* [faces] */
} walk;

/* Until `to` is reached. False: stopped by the cancellation. */
static bool
spread(const sg_flattening *fl, walk *w, uint32_t from, uint32_t to,
       const sg_cancel *cancel)
{
  const sg_flat_faces *f = fl->faces;
  size_t n = 0, next = 0;

  w->queue[n++] = from;
  w->by[from] = SG_NO_JOINT - 1;
  while (next < n && w->by[to] == SG_NO_JOINT) {
    if (sg_cancel_every(cancel, next)) {
      return false;
    }
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
  return true;
}

uint32_t *
sg_flattening_path(const sg_flattening *fl, uint32_t from, uint32_t to,
                   const sg_cancel *cancel, size_t *n, bool *stopped)
{
  const sg_flat_faces *f = fl->faces;
  walk w = {malloc((f->faces + 1) * sizeof *w.by),
            malloc((f->faces + 1) * sizeof *w.queue)};
  uint32_t *path = malloc((f->faces + 1) * sizeof *path);

  *n = 0;
  *stopped = false;
  if (w.by && w.queue && path) {
    memset(w.by, 0xff, (f->faces + 1) * sizeof *w.by);
    *stopped = !spread(fl, &w, from, to, cancel);
    for (uint32_t face = to; w.by[to] != SG_NO_JOINT && face != from;
         face = f->face_of[w.by[face]]) {
      path[(*n)++] = fl->joints->of_side[w.by[face]];
    }
  }
  if (!w.by || !w.queue || *stopped) {
    free(path);
    path = NULL;
  }
  free(w.by);
  free(w.queue);
  return path;
}

bool
sg_flattening_join_folds(sg_flattening *fl, const uint32_t *joint, size_t n,
                         const sg_cancel *cancel, bool *stopped)
{
  *stopped = !sg_flattening_restart(fl, cancel);
  for (size_t i = 0; i < n && !*stopped; i++) {
    const uint32_t *face = fl->joints->joint[joint[i]].face;
    *stopped = sg_cancel_every(cancel, i);
    fl->tried = true;
    if (fl->island_of[face[0]] != fl->island_of[face[1]]) {
      if (!sg_flattening_rejoin(fl, joint[i])) {
        return false;
      }
      fl->state[joint[i]] = SG_JOINT_JOINED;
    }
  }
  return !*stopped;
}
