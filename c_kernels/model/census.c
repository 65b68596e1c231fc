/* census.c -- half-edges, shells and fans (census.h). */
#include "census_private.h"
#include "engine/list.h"
#include "rows/disjoint.h"

#include <stdlib.h>
#include <string.h>

bool
sg_census_note(sg_counting *c, sg_defect_kind kind, int32_t a, int32_t b)
{
  sg_census *out = c->out;

  if (!sg_list_grow(&out->defect, out->defects, &out->defect_room,
                    sizeof *out->defect)) {
    return false;
  }
  c->part->defects[kind]++;
  out->defect[out->defects++] = (sg_defect){kind, c->part->segment, a, b};
  return true;
}

/* Polygons and their loops ------------------------------------------------ */

static bool
own_edges(sg_counting *c, size_t p)
{
  const sg_dense *d = c->d;

  for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    int32_t e = d->list[k];
    if (c->owner[e] >= 0 && !sg_census_note(c, SG_DEFECT_SHARED, d->edge_id[e],
                                            d->polygon_id[c->owner[e]])) {
      return false;
    }
    c->owner[e] = (int32_t)p;
  }
  return true;
}

static bool
join_loops(sg_counting *c, size_t p)
{
  const sg_dense *d = c->d;
  const int32_t *list = d->list + d->list_begin[p];
  size_t n = d->list_begin[p + 1] - d->list_begin[p];

  for (size_t k = 0; k < n; k++) {
    c->from[k] = d->from[list[k]];
    c->to[k] = d->to[list[k]];
  }
  if (!sg_loops_make(&c->loops, n, c->from, c->to)) {
    return false;
  }
  for (size_t k = 0; k < n; k++) {
    c->next[list[k]] = c->loops.next[k] < 0 ? -1 : list[c->loops.next[k]];
  }
  c->loops_of[p] = (int32_t)c->loops.loops;
  return !c->loops.open || sg_census_note(c, SG_DEFECT_OPEN, d->polygon_id[p],
                                          (int32_t)c->loops.open);
}

/* Groups of half-edges ---------------------------------------------------- */

/* One undirected edge of polygons; `edge` are its half-edges, places. Bodies
 * that touch along it leave their shells closed. */
static bool
note_group(sg_counting *c, const int32_t *edge, size_t n, size_t forward)
{
  const int32_t *id = c->d->edge_id;

  c->part->edges++;
  for (size_t i = 1; i < n; i++) {
    sg_disjoint_join(c->shell_of, (uint32_t)c->owner[edge[0]],
                     (uint32_t)c->owner[edge[i]]);
  }
  if (n == 2 && forward == 1) {
    c->opposite[edge[0]] = edge[1];
    c->opposite[edge[1]] = edge[0];
    return true;
  }
  if (2 * forward == n) {
    return sg_census_note(c, SG_DEFECT_CROWDED, id[edge[0]], (int32_t)n);
  }
  for (size_t i = 0; i < n; i++) {
    c->bad[c->owner[edge[i]]] = true;
  }
  return n == 1 ? sg_census_note(c, SG_DEFECT_BORDER, id[edge[0]], 0)
         : n == 2
             ? sg_census_note(c, SG_DEFECT_TURNED, id[edge[0]], id[edge[1]])
             : sg_census_note(c, SG_DEFECT_NONMANIFOLD, id[edge[0]],
                              (int32_t)n);
}

/* The half-edges of this segment that polygons own; *n of them. */
static int32_t *
owned_edges(sg_counting *c, size_t *n)
{
  const sg_dense *d = c->d;
  size_t begin = d->edge_begin[c->s], end = d->edge_begin[c->s + 1];
  int32_t *edge = malloc((end - begin + 1) * sizeof *edge);

  *n = 0;
  for (size_t e = begin; edge && e < end; e++) {
    if (c->owner[e] >= 0) {
      edge[(*n)++] = (int32_t)e;
    }
  }
  c->part->half_edges = *n;
  c->part->curve_edges = end - begin - *n;
  return edge;
}

static bool
note_groups(sg_counting *c, const sg_edge_pairs *pairs, const int32_t *edge)
{
  sg_edge_group group = {0};
  int32_t *places = NULL;
  size_t room = 0;

  while (sg_edge_group_next(pairs, &group)) {
    size_t n = group.end - group.begin;
    if (sg_census_stops(c, group.low) ||
        !sg_list_need(&places, n, &room, sizeof *places)) {
      break;
    }
    for (size_t i = 0; i < n; i++) {
      places[i] = edge[sg_edge_group_edge(pairs, group.begin + i)];
    }
    if (!note_group(c, places, n, group.forward)) {
      break;
    }
  }
  free(places);
  return group.end == pairs->n;
}

static bool
pair_edges(sg_counting *c)
{
  const sg_dense *d = c->d;
  int32_t base = (int32_t)d->vertex_begin[c->s];
  size_t vertices = d->vertex_begin[c->s + 1] - (size_t)base, n;
  int32_t *edge = owned_edges(c, &n);
  int32_t *from = malloc((n + 1) * sizeof *from);
  int32_t *to = malloc((n + 1) * sizeof *to);
  sg_edge_pairs pairs = {0};
  bool done = edge && from && to;

  for (size_t i = 0; done && i < n; i++) {
    from[i] = d->from[edge[i]] - base;
    to[i] = d->to[edge[i]] - base;
    done = !sg_census_stops(c, i);
  }
  done = done &&
         sg_edge_pairs_make(n, from, to, vertices, c->cancel, &pairs,
                            &c->stopped) &&
         note_groups(c, &pairs, edge);
  sg_edge_pairs_clear(&pairs);
  free(edge);
  free(from);
  free(to);
  return done;
}

/* Fans --------------------------------------------------------------------- */

/* The half-edge that leaves the vertex where e enters, next round it. */
static int32_t
turn(const sg_counting *c, int32_t e)
{
  return c->opposite[e] < 0 ? -1 : c->next[c->opposite[e]];
}

/* Marks the fan of half-edge e, that leaves a vertex, and counts it. A marked
 * half-edge has -2 less its owner. */
static void
walk_fan(sg_counting *c, int32_t e)
{
  c->fans[c->d->from[e]]++;
  while (e >= 0 && c->owner[e] >= 0) {
    c->owner[e] = -2 - c->owner[e];
    e = turn(c, e);
  }
}

/* Fans begin at half-edges that no turn leads to; what is left goes round. */
static bool
count_fans(sg_counting *c)
{
  const sg_dense *d = c->d;
  size_t begin = d->edge_begin[c->s], end = d->edge_begin[c->s + 1];
  unsigned char *led = calloc(end - begin + 1, 1);

  if (!led) {
    return false;
  }
  for (size_t e = begin; e < end; e++) {
    int32_t f = c->owner[e] < 0 ? -1 : turn(c, (int32_t)e);
    if (f >= 0) {
      led[(size_t)f - begin] = 1;
    }
    if (sg_census_stops(c, e)) {
      break;
    }
  }
  for (int round = 0; round < 2; round++) {
    for (size_t e = begin; e < end && !sg_census_stops(c, e); e++) {
      if (c->owner[e] >= 0 && (round || !led[e - begin])) {
        walk_fan(c, (int32_t)e);
      }
    }
  }
  for (size_t e = begin; e < end; e++) {
    c->owner[e] = c->owner[e] < -1 ? -2 - c->owner[e] : c->owner[e];
  }
  free(led);
  return !c->stopped;
}

/* Shells ------------------------------------------------------------------- */

/* A face without triangles counts 2 less its loops; with T triangles and D
 * half-edges (D - T) / 2, which is the same, and right for seams as well. */
static int64_t
face_euler(const sg_counting *c, size_t p)
{
  const sg_dense *d = c->d;
  int64_t edges = (int64_t)(d->list_begin[p + 1] - d->list_begin[p]);
  int64_t t = c->triangles[p];

  return t && (edges - t) % 2 == 0 ? (edges - t) / 2 : 2 - c->loops_of[p];
}

static bool
open_shells(sg_counting *c)
{
  const sg_dense *d = c->d;
  sg_census *out = c->out;

  c->part->first_shell = out->shells;
  for (size_t p = d->polygon_begin[c->s]; p < d->polygon_begin[c->s + 1]; p++) {
    c->shell_of[p] = sg_disjoint_root(c->shell_of, (uint32_t)p);
  }
  for (size_t p = d->polygon_begin[c->s]; p < d->polygon_begin[c->s + 1]; p++) {
    uint32_t r = c->shell_of[p];
    /* The root comes first: it is the lowest. */
    uint32_t shell = r == p ? (uint32_t)out->shells++ : c->shell_of[r];
    if (r == p) {
      out->shell[shell] = (sg_shell){.segment = c->part->segment,
                                     .polygon = d->polygon_id[p],
                                     .closed = true};
    }
    c->shell_of[p] = shell;
    sg_shell *s = &out->shell[shell];
    s->polygons++;
    s->euler += face_euler(c, p);
    s->area += c->area[p];
    s->volume += c->volume[p];
    s->closed = s->closed && !c->bad[p];
    if (sg_census_stops(c, p)) {
      return false;
    }
  }
  c->part->shells = out->shells - c->part->first_shell;
  return true;
}

/* Vertices of a shell count once; a pair of half-edges is one edge, as is any
 * group: it is counted at its lowest half-edge that has no opposite before. */
static bool
count_shell_edges(sg_counting *c)
{
  const sg_dense *d = c->d;

  for (size_t e = d->edge_begin[c->s]; e < d->edge_begin[c->s + 1]; e++) {
    if (c->owner[e] >= 0 &&
        (c->opposite[e] < 0 || c->opposite[e] > (int32_t)e)) {
      c->out->shell[c->shell_of[c->owner[e]]].edges++;
    }
    if (sg_census_stops(c, e)) {
      return false;
    }
  }
  return true;
}

/* Polygons by shell, so that one stamp a vertex is enough. */
static bool
count_shell_vertices(sg_counting *c)
{
  const sg_dense *d = c->d;
  size_t first = c->part->first_shell, n = c->part->shells;
  size_t begin = d->polygon_begin[c->s], end = d->polygon_begin[c->s + 1];
  uint32_t *at = calloc(n + 2, sizeof *at);
  uint32_t *order = malloc((end - begin + 1) * sizeof *order);

  for (size_t p = begin; at && order && p < end; p++) {
    at[c->shell_of[p] - first + 1]++;
  }
  for (size_t i = 0; at && order && i < n; i++) {
    at[i + 1] += at[i];
  }
  for (size_t p = begin; at && order && p < end; p++) {
    order[at[c->shell_of[p] - first]++] = (uint32_t)p;
  }
  for (size_t i = 0; at && order && i < end - begin && !sg_census_stops(c, i);
       i++) {
    size_t p = order[i];
    sg_shell *shell = &c->out->shell[c->shell_of[p]];
    uint32_t stamp = c->shell_of[p] + 1;
    for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
      int32_t v = d->from[d->list[k]];
      if (c->seen[v] != stamp) {
        c->seen[v] = stamp;
        shell->vertices++;
        shell->pinched = shell->pinched || c->fans[v] > 1;
      }
    }
  }
  bool done = at && order && !c->stopped;
  free(at);
  free(order);
  return done;
}

static bool
count_shells(sg_counting *c)
{
  if (!open_shells(c) || !count_shell_edges(c) || !count_shell_vertices(c)) {
    return false;
  }
  for (size_t i = c->part->first_shell; i < c->out->shells; i++) {
    sg_shell *shell = &c->out->shell[i];
    shell->euler += (int64_t)shell->vertices - (int64_t)shell->edges;
    shell->volume /= 6;
    c->part->area += shell->area;
    c->part->volume += shell->volume;
  }
  return true;
}

/* Whole -------------------------------------------------------------------- */

static bool
count_segment(sg_counting *c)
{
  const sg_dense *d = c->d;
  sg_part *part = c->part;

  part->segment = d->segment[c->s];
  part->vertices = d->vertex_begin[c->s + 1] - d->vertex_begin[c->s];
  part->polygons = d->polygon_begin[c->s + 1] - d->polygon_begin[c->s];
  part->triangles = d->triangle_begin[c->s + 1] - d->triangle_begin[c->s];
  for (size_t p = d->polygon_begin[c->s]; p < d->polygon_begin[c->s + 1]; p++) {
    if (sg_census_stops(c, p) || !own_edges(c, p) || !join_loops(c, p)) {
      return false;
    }
  }
  return pair_edges(c) && count_fans(c) && sg_census_vertices(c) &&
         sg_census_faces(c) && sg_census_doubles(c) && count_shells(c) &&
         sg_census_depths(c);
}

static bool
open_counting(sg_counting *c)
{
  const sg_dense *d = c->d;
  size_t longest = 0;

  for (size_t p = 0; p < d->polygons; p++) {
    size_t n = d->list_begin[p + 1] - d->list_begin[p];
    longest = n > longest ? n : longest;
  }
  c->owner = malloc((d->edges + 1) * sizeof *c->owner);
  c->next = malloc((d->edges + 1) * sizeof *c->next);
  c->opposite = malloc((d->edges + 1) * sizeof *c->opposite);
  c->shell_of = malloc((d->polygons + 1) * sizeof *c->shell_of);
  c->seen = calloc(d->vertices + 1, sizeof *c->seen);
  c->fans = calloc(d->vertices + 1, sizeof *c->fans);
  c->triangles = calloc(d->polygons + 1, sizeof *c->triangles);
  c->area = calloc(d->polygons + 1, sizeof *c->area);
  c->volume = calloc(d->polygons + 1, sizeof *c->volume);
  c->sides = calloc(d->polygons + 1, sizeof *c->sides);
  c->loops_of = calloc(d->polygons + 1, sizeof *c->loops_of);
  c->bad = calloc(d->polygons + 1, sizeof *c->bad);
  c->from = malloc((longest + 1) * sizeof *c->from);
  c->to = malloc((longest + 1) * sizeof *c->to);
  c->out->part = calloc(d->segments + 1, sizeof *c->out->part);
  c->out->shell = calloc(d->polygons + 1, sizeof *c->out->shell);
  if (!c->owner || !c->next || !c->opposite || !c->shell_of || !c->seen ||
      !c->fans || !c->triangles || !c->area || !c->volume || !c->sides ||
      !c->loops_of || !c->bad || !c->from || !c->to || !c->out->part ||
      !c->out->shell) {
    return false;
  }
  memset(c->owner, -1, d->edges * sizeof *c->owner);
  memset(c->next, -1, d->edges * sizeof *c->next);
  memset(c->opposite, -1, d->edges * sizeof *c->opposite);
  for (size_t p = 0; p < d->polygons; p++) {
    c->shell_of[p] = (uint32_t)p;
  }
  return true;
}

static void
close_counting(sg_counting *c)
{
  void *const owned[] = {c->owner,  c->next,     c->opposite,  c->shell_of,
                         c->seen,   c->fans,     c->triangles, c->area,
                         c->volume, c->loops_of, c->bad,       c->from,
                         c->to,     c->sides};

  for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) {
    free(owned[i]);
  }
  sg_loops_clear(&c->loops);
}

bool
sg_census_make(const sg_dense *dense, const double (*plane)[4],
               const sg_cancel *cancel, sg_census *out, bool *stopped)
{
  sg_counting c = {.d = dense, .plane = plane, .out = out, .cancel = cancel};

  *out = (sg_census){0};
  bool done = open_counting(&c);
  for (; done && c.s < dense->segments; c.s++) {
    c.part = &out->part[out->parts++];
    done = count_segment(&c);
  }
  *stopped = c.stopped;
  close_counting(&c);
  return done;
}

void
sg_census_clear(sg_census *census)
{
  free(census->part);
  free(census->shell);
  free(census->defect);
  *census = (sg_census){0};
}
