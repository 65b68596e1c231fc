/* seam_moats.c -- see seam_moats.h. */
#include "seam_moats.h"
#include "engine/list.h"

#include <math.h>
#include <stdlib.h>

enum { ASK_EVERY = 4096 };

/* When the moats at the ends of a joint meet, as known when it was written. */
typedef struct meeting {
  double time;
  uint32_t joint;
} meeting;

/* Sets of vertices and their moats. All grow at the same speed from time 0. */
typedef struct moats {
  const sg_bent_vertices *of;
  const sg_joints *joints;
  uint32_t *above; /* [vertices] towards the first of its set */
  double *wider;   /* [vertices] than that of the vertex above; of a first one:
                      how wide it was at `since` */
  double *since;   /* [vertices] of first ones, as are these: a time */
  double *bent;
  bool *free;           /* reaches a border */
  bool *grows;          /* is unbalanced */
  uint32_t *next;       /* [vertices] of the same set, in a ring */
  uint32_t *begin, *at; /* [vertices + 2], [2 * joints] joints at a vertex */
  meeting *heap;
  size_t n, room;
  double width;
} moats;

/* ---- sets --------------------------------------------------------------- */

bool
sg_bends_balance(double sum)
{
  const double turns = 4 * acos(-1.0);

  return fabs(sum - turns * round(sum / turns)) <= SG_BENT_LEAST;
}

/* The first vertex of a set, and how much wider the moat of v is. */
static uint32_t
first_of(moats *m, uint32_t v, double *wider)
{
  *wider = 0;
  while (m->above[v] != v) {
    uint32_t up = m->above[v];
    if (m->above[up] != up) {
      m->wider[v] += m->wider[up];
      m->above[v] = m->above[up];
    }
    *wider += m->wider[v];
    v = m->above[v];
  }
  return v;
}

/* How wide the moat is that ends at vertex v. */
static double
width_at(moats *m, uint32_t v, double time)
{
  double wider;
  uint32_t first = first_of(m, v, &wider);

  return wider + m->wider[first] +
         (m->grows[first] ? time - m->since[first] : 0);
}

/* Writes down what has grown since. */
static void
settle(moats *m, uint32_t first, double time)
{
  double more = m->grows[first] ? time - m->since[first] : 0;

  m->wider[first] += more;
  m->width += more;
  m->since[first] = time;
}

static void
unite(moats *m, uint32_t a, uint32_t b, double time)
{
  uint32_t next = m->next[a];

  settle(m, a, time);
  settle(m, b, time);
  m->above[b] = a;
  m->wider[b] -= m->wider[a];
  m->bent[a] += m->bent[b];
  m->free[a] |= m->free[b];
  m->grows[a] = !m->free[a] && !sg_bends_balance(m->bent[a]);
  m->next[a] = m->next[b];
  m->next[b] = next;
}

/* ---- meetings ----------------------------------------------------------- */

static bool
is_before(const meeting *a, const meeting *b)
{
  return a->time < b->time || (a->time == b->time && a->joint < b->joint);
}

static bool
push(moats *m, meeting new)
{
  size_t i = m->n++;

  if (!sg_list_need(&m->heap, m->n, &m->room, sizeof *m->heap)) {
    return false;
  }
  for (; i > 0 && is_before(&new, &m->heap[(i - 1) / 2]); i = (i - 1) / 2) {
    m->heap[i] = m->heap[(i - 1) / 2];
  }
  m->heap[i] = new;
  return true;
}

static meeting
pop(moats *m)
{
  meeting top = m->heap[0], last = m->heap[--m->n];
  size_t i = 0;

  for (size_t k; (k = 2 * i + 1) < m->n; i = k) {
    k += k + 1 < m->n && is_before(&m->heap[k + 1], &m->heap[k]);
    if (!is_before(&m->heap[k], &last)) {
      break;
    }
    m->heap[i] = m->heap[k];
  }
  m->heap[i] = last;
  return top;
}

/* The sets at the ends of a joint, how far apart their moats are, and how fast
 * they come together. False: it is one set. */
static bool
look_at(moats *m, uint32_t j, double time, uint32_t set[2], double *gap,
        int *speed)
{
  *gap = m->joints->joint[j].length;
  *speed = 0;
  for (int k = 0; k < 2; k++) {
    uint32_t v = (uint32_t)m->joints->joint[j].vertex[k];
    double wider;
    set[k] = first_of(m, v, &wider);
    *gap -= width_at(m, v, time);
    *speed += m->grows[set[k]];
  }
  return set[0] != set[1];
}

static bool
expect(moats *m, uint32_t j, double time)
{
  uint32_t set[2];
  double gap;
  int speed;

  return !look_at(m, j, time, set, &gap, &speed) || speed == 0 ||
         push(m, (meeting){time + fmax(gap, 0) / speed, j});
}

/* The moat of set `slow`, which did not grow, does now, since it is one with
 * `other`: what it meets, it meets sooner. */
static bool
expect_of(moats *m, uint32_t slow, uint32_t other, double time)
{
  for (uint32_t v = m->next[other];; v = m->next[v]) {
    for (uint32_t i = m->begin[v]; i < m->begin[v + 1]; i++) {
      if (!expect(m, m->at[i], time)) {
        return false;
      }
    }
    if (v == slow) {
      return true;
    }
  }
}

/* The moats at a joint meet, if they have not grown slower than was expected. A
 * gap that is too small for the time to go on is none: a short joint may meet
 * late. */
static bool
meet(moats *m, meeting at)
{
  uint32_t set[2];
  double gap;
  int speed;

  if (!look_at(m, at.joint, at.time, set, &gap, &speed) || speed == 0) {
    return true;
  }
  double later = at.time + gap / speed;

  if (gap > 1e-12 * m->joints->joint[at.joint].length && later > at.time) {
    return push(m, (meeting){later, at.joint});
  }
  int slow = speed == 2 ? -1 : m->grows[set[0]];

  unite(m, set[0], set[1], at.time);
  return slow < 0 || !m->grows[set[0]] ||
         expect_of(m, set[slow], set[!slow], at.time);
}

/* ---- growing ------------------------------------------------------------ */

static bool
list_joints(moats *m)
{
  size_t n = m->joints->n, vertices = m->of->vertices;

  m->begin = calloc(vertices + 2, sizeof *m->begin);
  m->at = malloc((2 * n + 1) * sizeof *m->at);
  for (int pass = 0; m->begin && m->at && pass < 2; pass++) {
    for (uint32_t j = 0; j < n; j++) {
      for (int k = 0; k < 2 && !m->joints->joint[j].line; k++) {
        int32_t v = m->joints->joint[j].vertex[k];
        if (pass == 0) {
          m->begin[v + 2]++;
        } else {
          m->at[m->begin[v + 1]++] = j;
        }
      }
    }
    for (size_t v = 0; pass == 0 && v < vertices; v++) {
      m->begin[v + 2] += m->begin[v + 1];
    }
  }
  return m->begin && m->at;
}

static bool
make(moats *m)
{
  size_t n = m->of->vertices + 1;

  m->above = malloc(n * sizeof *m->above);
  m->wider = calloc(n, sizeof *m->wider);
  m->since = calloc(n, sizeof *m->since);
  m->bent = malloc(n * sizeof *m->bent);
  m->free = malloc(n * sizeof *m->free);
  m->grows = malloc(n * sizeof *m->grows);
  m->next = malloc(n * sizeof *m->next);
  if (!m->above || !m->wider || !m->since || !m->bent || !m->free ||
      !m->grows || !m->next || !list_joints(m)) {
    return false;
  }
  for (uint32_t v = 0; v < m->of->vertices; v++) {
    m->above[v] = m->next[v] = v;
    m->bent[v] = m->of->bent[v];
    m->free[v] = m->of->border[v];
    m->grows[v] = !m->free[v] && !sg_bends_balance(m->bent[v]);
  }
  return true;
}

static void
clear(moats *m)
{
  free(m->above);
  free(m->wider);
  free(m->since);
  free(m->bent);
  free(m->free);
  free(m->grows);
  free(m->next);
  free(m->begin);
  free(m->at);
  free(m->heap);
}

static bool
grow(moats *m, const sg_cancel *cancel, bool *stopped)
{
  for (uint32_t j = 0; j < m->joints->n; j++) {
    if (!m->joints->joint[j].line && !expect(m, j, 0)) {
      return false;
    }
  }
  for (size_t i = 1; m->n > 0; i++) {
    *stopped = i % ASK_EVERY == 0 && sg_cancelled(cancel);
    if (*stopped || !meet(m, pop(m))) {
      return false;
    }
  }
  return true;
}

/* Half the shortest edge at each vertex. */
static void
grow_alone(moats *m)
{
  for (uint32_t v = 0; v < m->of->vertices; v++) {
    double least = INFINITY;
    for (uint32_t i = m->begin[v]; i < m->begin[v + 1]; i++) {
      least = fmin(least, m->joints->joint[m->at[i]].length);
    }
    m->width += m->grows[v] && isfinite(least) ? least / 2 : 0;
  }
}

bool
sg_moats_grow(const sg_bent_vertices *of, const sg_joints *joints, bool on,
              const sg_cancel *cancel, double *width, bool *stopped)
{
  moats m = {.of = of, .joints = joints};
  bool good = make(&m);

  *stopped = false;
  if (good && on) {
    good = grow(&m, cancel, stopped);
  } else if (good) {
    grow_alone(&m);
  }
  *width = m.width;
  clear(&m);
  return good;
}
