/* census_depth.c -- how many other shells of a segment go round each of its
 * shells (census.h).
 *
 * Asked at the middle of a triangle of the shell that is on no other shell, if
 * there is one among the few that are tried: exact there. Shells that go
 * through each other have no depth; theirs is that of the point.
 */
#include "census_private.h"
#include "join/bvh_join.h"
#include "join/winding.h"

#include <stdlib.h>
#include <string.h>

enum { TRIED = 3, POLL_EVERY = 4096 };

/* What triangles of one shell count at one point. */
typedef struct turn {
  uint32_t point, shell;
  int count;
} turn;

typedef struct depths {
  const sg_counting *c;
  size_t first, shells; /* shell i of the segment is first + i */
  size_t begin, triangles;
  uint32_t *tried; /* [shells][TRIED] triangles, from 0; the same if few */
  double (*at)[3]; /* [shells * TRIED] */
  sg_box *round;   /* [shells] */
  const sg_bvh *rays, *faces;
  bool *on; /* [shells * TRIED]: on another shell */
  turn *item;
  size_t n, room;
} depths;

static size_t
shell_of(const depths *d, size_t t)
{
  const sg_counting *c = d->c;
  int32_t p = c->d->polygon_of[d->begin + t];

  return c->shell_of[p] - d->first;
}

static void
corners(const depths *d, size_t t, sg_point out[3])
{
  const sg_dense *dense = d->c->d;

  for (int k = 0; k < 3; k++) {
    sg_point_set(&out[k], dense->at[dense->corner[d->begin + t][k]]);
  }
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

    for (int k = 0; k < 3; k++) {
      d->at[i][k] = dense->at[v[0]][k] / 3 + dense->at[v[1]][k] / 3 +
                    dense->at[v[2]][k] / 3;
    }
  }
  free(count);
}

static bool
add_turn(depths *d, uint32_t point, uint32_t shell, int count)
{
  if (d->n == d->room) {
    size_t room = 2 * d->room + 64;
    turn *more = realloc(d->item, room * sizeof *more);

    if (!more) {
      return false;
    }
    d->item = more;
    d->room = room;
  }
  d->item[d->n++] = (turn){point, shell, count};
  return true;
}

/* What triangle t counts at point i. False: no memory. */
static bool
see(depths *d, uint32_t i, uint32_t t)
{
  size_t shell = shell_of(d, t);
  sg_point corner[3], at;

  if (shell == i / TRIED) {
    return true;
  }
  corners(d, t, corner);
  sg_point_set(&at, d->at[i]);
  d->on[i] =
      d->on[i] || sg_is_on_triangle(&corner[0], &corner[1], &corner[2], &at);
  int count = sg_winding_of(&corner[0], &corner[1], &corner[2], &at);

  return count == 0 || add_turn(d, i, (uint32_t)shell, count);
}

/* What is outside of a shell's box it does not go round. */
static bool
may_count(void *data, const sg_bvh_hit *hit)
{
  const depths *d = data;
  size_t i = d->rays->item[hit->a], t = d->faces->item[hit->b];
  size_t shell = shell_of(d, t);
  const sg_dense *dense = d->c->d;
  double corner[3][3];
  sg_box point = sg_box_none();

  sg_box_add(&point, d->at[i]);
  if (shell == i / TRIED || !sg_box_overlap(&point, &d->round[shell], 0)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    memcpy(corner[k], dense->at[dense->corner[d->begin + t][k]],
           sizeof corner[k]);
  }
  return !sg_winding_misses((const double(*)[3])corner, d->at[i]);
}

/* Boxes of the triangles, and of the shells. */
static void
box_triangles(depths *d, sg_box *box)
{
  const sg_dense *dense = d->c->d;

  for (size_t i = 0; i < d->shells; i++) {
    d->round[i] = sg_box_none();
  }
  for (size_t t = 0; t < d->triangles; t++) {
    box[t] = sg_box_none();
    for (int k = 0; k < 3; k++) {
      sg_box_add(&box[t], dense->at[dense->corner[d->begin + t][k]]);
    }
    sg_box_join(&d->round[shell_of(d, t)], &box[t]);
  }
}

/* Trees of the triangles and of the rays of the points, joined. */
static bool
join(depths *d, const sg_poll *poll, sg_bvh **rays, sg_bvh **faces,
     sg_bvh_hits *hits)
{
  size_t points = d->shells * TRIED;
  sg_box *box = malloc((d->triangles + 1) * sizeof *box);
  sg_box *ray = malloc((points + 1) * sizeof *ray);
  bool good = box && ray;

  if (good) {
    box_triangles(d, box);
    *faces = sg_bvh_open(box, d->triangles, poll);
  }
  for (size_t i = 0; i < points && good; i++) {
    ray[i] = sg_box_none();
    sg_box_add(&ray[i], d->at[i]);
  }
  good = good && *faces &&
         sg_winding_shorten(d->round, d->shells, ray, points, poll);
  *rays = good ? sg_bvh_open(ray, points, poll) : NULL;
  free(box);
  free(ray);
  d->rays = *rays;
  d->faces = *faces;
  return *rays && sg_bvh_join_wanted(&(sg_bvh_pair){*rays, *faces}, 1, 0,
                                     may_count, d, NULL, poll, hits);
}

static int
by_point_and_shell(const void *x, const void *y)
{
  const turn *a = x, *b = y;

  return a->point != b->point ? (a->point > b->point) - (a->point < b->point)
                              : (a->shell > b->shell) - (a->shell < b->shell);
}

/* How many shells go round each point. */
static void
count_depths(depths *d, uint32_t *out)
{
  if (d->n > 0) {
    qsort(d->item, d->n, sizeof *d->item, by_point_and_shell);
  }
  for (size_t i = 0, end; i < d->n; i = end) {
    int sum = 0;

    for (end = i;
         end < d->n && by_point_and_shell(&d->item[i], &d->item[end]) == 0;
         end++) {
      sum += d->item[end].count;
    }
    out[d->item[i].point] += sum != 0;
  }
}

static bool
set_depths(depths *d, sg_shell *shell)
{
  uint32_t *depth = calloc(d->shells * TRIED + 1, sizeof *depth);

  if (!depth) {
    return false;
  }
  count_depths(d, depth);
  for (size_t i = 0; i < d->shells; i++) {
    size_t k = i * TRIED, end = k + TRIED;

    while (k + 1 < end && d->on[k]) {
      k++;
    }
    shell[d->first + i].depth = depth[k];
  }
  free(depth);
  return true;
}

static bool
see_all(depths *d, const sg_poll *poll, bool *stopped)
{
  sg_bvh *rays = NULL, *faces = NULL;
  sg_bvh_hits hits = {0};
  bool done = join(d, poll, &rays, &faces, &hits);

  for (size_t i = 0; i < hits.n && done; i++) {
    done = see(d, rays->item[hits.hit[i].a], faces->item[hits.hit[i].b]);
    if (i % POLL_EVERY == POLL_EVERY - 1 && sg_poll_stop(poll)) {
      *stopped = true;
      done = false;
    }
  }
  free(hits.hit);
  sg_bvh_close(rays);
  sg_bvh_close(faces);
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
  d.on = calloc(d.shells * TRIED, sizeof *d.on);
  d.round = malloc(d.shells * sizeof *d.round);
  bool done = d.tried && d.at && d.on && d.round;

  if (done) {
    choose(&d);
    done = see_all(&d, c->poll, &c->stopped) && set_depths(&d, c->out->shell);
  }
  free(d.tried);
  free(d.at);
  free(d.on);
  free(d.round);
  free(d.item);
  return done;
}
