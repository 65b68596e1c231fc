/* census_depth.c -- how many other shells of a segment go round each of its
 * shells (census.h).
 *
 * Asked at the middle of a triangle of the shell that is on no other shell, if
 * there is one among the few that are tried: exact there. Shells that go
 * through each other have no depth; theirs is that of the point. A walk over
 * the points (join/tour.h) knows which shells go round where it is; one that
 * is open goes round nothing. Points of several shells in one place, as of
 * equal ones, are one stop.
 */
#include "census_private.h"
#include "join/tour.h"
#include "rows/places.h"

#include <stdlib.h>
#include <string.h>

enum { TRIED = 3 };

#define NONE UINT32_MAX

typedef struct depths {
  const sg_counting *c;
  size_t first, shells; /* shell i of the segment is first + i */
  size_t begin, triangles;
  uint32_t *tried; /* [shells][TRIED] triangles, from 0; the same if few */
  sg_point *at;    /* [shells * TRIED] */
  uint32_t *stop;  /* [stops]: the first point there */
  uint32_t *next;  /* [shells * TRIED]: the next in the same place, NONE */
  size_t stops;
  uint32_t *of;    /* [shells * TRIED]: a shell that the stop is on, NONE */
  bool *several;   /* [shells * TRIED]: the stop is on others, too */
  bool *on;        /* [shells * TRIED]: on another shell */
  uint32_t *depth; /* [shells * TRIED] */
  int *turns;      /* [shells] round where the walk is */
  uint32_t round;  /* of how many shells that is not 0 */
} depths;

static const sg_shell *
shell_at(const depths *d, size_t i)
{
  return &d->c->out->shell[d->first + i];
}

static size_t
shell_of(const depths *d, size_t t)
{
  const sg_counting *c = d->c;
  int32_t p = c->d->polygon_of[d->begin + t];

  return c->shell_of[p] - d->first;
}

/* The first, a middle and the last triangle of each shell. */
static void
choose(depths *d)
{
  const sg_dense *dense = d->c->d;
  size_t *count = calloc(d->shells + 1, sizeof *count);

  for (size_t t = 0; t < d->triangles && count; t++) {
    size_t i = shell_of(d, t), k = count[i]++;
    uint32_t *tried = &d->tried[i * TRIED];

    tried[2] = (uint32_t)t;
    tried[1] = (k & (k + 1)) == 0 ? (uint32_t)t : tried[1];
    tried[0] = k == 0 ? (uint32_t)t : tried[0];
  }
  for (size_t i = 0; i < d->shells * TRIED; i++) {
    const int32_t *v = dense->corner[d->begin + d->tried[i]];
    double at[3];

    for (int k = 0; k < 3; k++) {
      at[k] = dense->at[v[0]][k] / 3 + dense->at[v[1]][k] / 3 +
              dense->at[v[2]][k] / 3;
    }
    sg_point_set(&d->at[i], at);
  }
  free(count);
}

static void
corners(const void *data, uint32_t t, double out[3][3])
{
  const depths *d = data;
  const sg_dense *dense = d->c->d;

  for (int k = 0; k < 3; k++) {
    memcpy(out[k], dense->at[dense->corner[d->begin + t][k]], sizeof out[k]);
  }
}

static void
pass(void *data, uint32_t t, int turns)
{
  depths *d = data;
  size_t shell = shell_of(d, t);

  if (shell_at(d, shell)->closed) {
    d->round -= d->turns[shell] != 0;
    d->turns[shell] += turns;
    d->round += d->turns[shell] != 0;
  }
}

static void
lies_on(void *data, size_t i, uint32_t t)
{
  depths *d = data;
  uint32_t point = d->stop[i], shell = (uint32_t)shell_of(d, t);

  if (d->of[point] == NONE) {
    d->of[point] = shell;
  }
  d->several[point] = d->several[point] || d->of[point] != shell;
}

static void
arrive(void *data, size_t i)
{
  depths *d = data;
  uint32_t first = d->stop[i];

  for (uint32_t k = first; k != NONE; k = d->next[k]) {
    uint32_t shell = k / TRIED;

    d->on[k] =
        d->several[first] || (d->of[first] != NONE && d->of[first] != shell);
    d->depth[k] = d->round - (d->turns[shell] != 0);
  }
}

static void
set_depths(const depths *d, sg_shell *shell)
{
  for (size_t i = 0; i < d->shells; i++) {
    size_t k = i * TRIED, end = k + TRIED;

    while (k + 1 < end && d->on[k]) {
      k++;
    }
    shell[d->first + i].depth = d->depth[k];
  }
}

/* A tree of the triangles. */
static sg_bvh *
plant(const depths *d, const sg_cancel *cancel)
{
  sg_box *box = malloc((d->triangles + 1) * sizeof *box);
  sg_bvh *tree = NULL;

  for (uint32_t t = 0; box && t < d->triangles; t++) {
    double at[3][3];

    corners(d, t, at);
    box[t] = sg_box_none();
    for (int k = 0; k < 3; k++) {
      sg_box_add(&box[t], at[k]);
    }
  }
  if (box) {
    tree = sg_bvh_open(box, d->triangles, cancel);
  }
  free(box);
  return tree;
}

/* Which points are in one place. False: no memory, or stopped. */
static bool
find_stops(depths *d, const sg_cancel *cancel)
{
  size_t n = d->shells * TRIED;
  double(*at)[3] = malloc((n + 1) * sizeof *at);
  uint32_t *place = NULL;

  for (size_t i = 0; at && i < n; i++) {
    memcpy(at[i], d->at[i].p, sizeof at[i]);
    d->next[i] = d->of[i] = NONE;
  }
  if (at) {
    place = sg_places_of((const double(*)[3])at, n, cancel);
  }
  for (uint32_t i = 0; place && i < n; i++) {
    if (place[i] == i) {
      d->stop[d->stops++] = i;
    } else {
      d->next[i] = d->next[place[i]];
      d->next[place[i]] = i;
    }
  }
  free(at);
  free(place);
  return place != NULL;
}

static bool
walk(depths *d, const sg_cancel *cancel)
{
  const sg_point **at = malloc((d->stops + 1) * sizeof *at);
  sg_bvh *tree = at ? plant(d, cancel) : NULL;
  sg_tour way = {.tree = tree,
                 .data = d,
                 .corners = corners,
                 .pass = pass,
                 .on = lies_on,
                 .arrive = arrive};

  for (size_t i = 0; at && i < d->stops; i++) {
    at[i] = &d->at[d->stop[i]];
  }
  bool done = tree && sg_tour_over(&way, at, d->stops, cancel);

  free(at);
  sg_bvh_close(tree);
  return done;
}

bool
sg_census_depths(sg_counting *c)
{
  const sg_dense *dense = c->d;
  size_t begin = dense->triangle_begin[c->s];
  depths d = {.c = c,
              .first = c->part->first_shell,
              .shells = c->part->shells,
              .begin = begin,
              .triangles = dense->triangle_begin[c->s + 1] - begin};

  if (d.shells < 2 || d.triangles == 0) {
    return true;
  }
  d.tried = calloc(d.shells * TRIED, sizeof *d.tried);
  d.at = calloc(d.shells * TRIED, sizeof *d.at);
  d.stop = calloc(d.shells * TRIED, sizeof *d.stop);
  d.next = calloc(d.shells * TRIED, sizeof *d.next);
  d.of = calloc(d.shells * TRIED, sizeof *d.of);
  d.several = calloc(d.shells * TRIED, sizeof *d.several);
  d.on = calloc(d.shells * TRIED, sizeof *d.on);
  d.depth = calloc(d.shells * TRIED, sizeof *d.depth);
  d.turns = calloc(d.shells, sizeof *d.turns);
  bool done = d.tried && d.at && d.stop && d.next && d.of && d.several &&
              d.on && d.depth && d.turns;

  if (done) {
    choose(&d);
    done = find_stops(&d, c->cancel) && walk(&d, c->cancel);
  }
  if (done) {
    set_depths(&d, c->out->shell);
  }
  free(d.tried);
  free(d.at);
  free(d.stop);
  free(d.next);
  free(d.of);
  free(d.several);
  free(d.on);
  free(d.depth);
  free(d.turns);
  return done;
}
