/* face_merge_fill.c -- new triangles for faces that lose vertices: see
 * face_merge_private.h.
 *
 * Layer: kernel. What the scratch relation decides is exact, on the doubles
 * seen along the main axis of the face. Whatever comes out is used only if its
 * border is, edge for edge, the one that the other faces know.
 */
#include "engine/search.h"
#include "face_merge_hold.h"

#include "engine/list.h"
#include "polygon/delaunay.h"

#include <stdlib.h>
#include <string.h>

enum {
  AT_ONCE = 16, /* groups a task, if there are many */
  OFTEN = 64    /* faces between questions */
};

/* An edge of the polygon. */
typedef struct side {
  uint32_t from, to;
  bool auxiliary, used;
} side;

/* What is needed for a group, one after the other. */
typedef struct filler {
  const sg_merge *m;
  sg_group *group;
  sg_work *work;
  sg_triangles triangles; /* of handles */
  side *side;             /* [sides]: by from and to */
  size_t sides, room;
  sg_holds holds;
  uint32_t *inside; /* [insides]: kept vertices in the middle */
  size_t insides, inside_room;
  uint32_t (*chord)[3]; /* [chords]: low, high, way */
  bool no_memory;
} filler;

typedef struct filling {
  sg_merge *m;
  uint32_t *wanted; /* [n]: groups */
  size_t n, at_once;
  bool *no_memory; /* [tasks] */
} filling;

/* ---- the polygon -------------------------------------------------------- */

/* That of the half-edges of the group at hand. */
static uint32_t
label_of(const filler *f)
{
  return (uint32_t)(f->m->solid->faces + (size_t)(f->group - f->m->group));
}

/* The border half-edge of the group from v to w. */
static uint32_t
border_between(const sg_merge *m, uint32_t label, uint32_t v, uint32_t w)
{
  for (uint32_t i = m->first[v]; i < m->first[v + 1]; i++) {
    uint32_t half = m->leaving[i].half;
    if (m->leaving[i].to == w && sg_half_label(m, half) == label &&
        sg_half_is_border(m, half)) {
      return half;
    }
  }
  return SG_NOTHING;
}

/* Adds the edge that begins with a half-edge and goes on over vertices that
 * vanish; it is real if any part of it is. */
static bool
add_side(filler *f, uint32_t half)
{
  const sg_merge *m = f->m;
  uint32_t from = sg_half_start(m, half), to = sg_half_end(m, half);
  uint32_t before = from;
  bool auxiliary = sg_half_is_auxiliary(m, half);

  while (m->fate[to] == SG_DROPPED) {
    uint32_t next =
        m->adjacent[to][0] == before ? m->adjacent[to][1] : m->adjacent[to][0];
    half = border_between(m, label_of(f), to, next);
    if (half == SG_NOTHING) {
      return false;
    }
    auxiliary = auxiliary && sg_half_is_auxiliary(m, half);
    before = to;
    to = next;
  }
  if (!sg_list_grow(&f->side, f->sides, &f->room, sizeof *f->side)) {
    f->no_memory = true;
    return false;
  }
  f->side[f->sides++] = (side){from, to, auxiliary, false};
  return from != to;
}

SG_ORDER(compare_sides, side, SG_BY(from) SG_BY(to));

static side *
find_side(const filler *f, uint32_t from, uint32_t to)
{
  side key = {from, to, false, false};

  return f->sides ? bsearch(&key, f->side, f->sides, sizeof key, compare_sides)
                  : NULL;
}

/* Calls `see` for all half-edges of the group until it says false. */
static bool
each_half(filler *f, bool (*see)(filler *f, uint32_t half))
{
  const sg_merge *m = f->m;

  for (uint32_t i = 0; i < f->group->n; i++) {
    const sg_solid_face *face = &m->solid->face[m->member[f->group->first + i]];
    if (i % OFTEN == 0 && sg_pool_stopping()) {
      return false;
    }
    for (uint32_t half = 3 * face->first; half < 3 * (face->first + face->n);
         half++) {
      if (!see(f, half)) {
        return false;
      }
    }
  }
  return true;
}

static bool
see_border(filler *f, uint32_t half)
{
  return !sg_half_is_border(f->m, half) ||
         f->m->fate[sg_half_start(f->m, half)] == SG_DROPPED ||
         add_side(f, half);
}

/* An edge that came together with its opposite has nothing between them. */
static bool
sides_are_apart(const filler *f)
{
  for (size_t i = 0; i < f->sides; i++) {
    const side *s = &f->side[i];
    if (i > 0 && compare_sides(s - 1, s) == 0) {
      return false;
    }
    if (find_side(f, s->to, s->from)) {
      uint32_t half = border_between(f->m, label_of(f), s->from, s->to);
      if (half == SG_NOTHING || f->m->twin[half] != SG_NOTHING) {
        return false;
      }
    }
  }
  return true;
}

/* ---- vertices in the middle --------------------------------------------- */

static side *
first_side_of(const filler *f, uint32_t from)
{
  size_t at;

  SG_SEARCH(at, 0, f->sides, f->side[at].from < from);
  return at < f->sides && f->side[at].from == from ? &f->side[at] : NULL;
}

static bool
see_inside(filler *f, uint32_t half)
{
  uint32_t v = sg_half_start(f->m, half);

  if (f->m->fate[v] != SG_KEPT || first_side_of(f, v)) {
    return true;
  }
  if (!sg_list_grow(&f->inside, f->insides, &f->inside_room,
                    sizeof *f->inside)) {
    f->no_memory = true;
    return false;
  }
  f->inside[f->insides++] = v;
  return true;
}

static bool
find_inside(filler *f)
{
  size_t n = 0;

  f->insides = 0;
  if (!each_half(f, see_inside)) {
    return false;
  }
  if (f->insides) {
    qsort(f->inside, f->insides, sizeof *f->inside, sg_compare_numbers);
  }
  for (size_t i = 0; i < f->insides; i++) {
    if (n == 0 || f->inside[n - 1] != f->inside[i]) {
      f->inside[n++] = f->inside[i];
    }
  }
  f->insides = n;
  return true;
}

/* ---- triangles ---------------------------------------------------------- */

static bool
stopping(void *data)
{
  (void)data;
  return sg_pool_stopping();
}

static int32_t
enter(filler *f, uint32_t v)
{
  sg_point point;

  sg_point_set(&point, sg_merge_at(f->m, v));
  int32_t handle = sg_work_vertex(f->work, (int32_t)v + 1, &point);
  f->no_memory = f->no_memory || handle == SG_WORK_NONE;
  return handle;
}

static bool
enter_sides(filler *f)
{
  for (size_t i = 0; i < f->sides; i++) {
    int32_t a = enter(f, f->side[i].from), b = enter(f, f->side[i].to);
    if (f->no_memory || !sg_work_add(f->work, a, b, 1, 0)) {
      f->no_memory = true;
      return false;
    }
  }
  for (size_t i = 0; i < f->holds.n; i++) {
    int32_t a = enter(f, f->holds.pair[i][0]);
    int32_t b = enter(f, f->holds.pair[i][1]);
    if (f->no_memory || !sg_work_add(f->work, a, b, 1, 0)) {
      f->no_memory = true;
      return false;
    }
  }
  return true;
}

static bool
insert_inside(filler *f)
{
  for (size_t i = 0; i < f->insides; i++) {
    if (sg_holds_reach(&f->holds, f->inside[i])) {
      continue;
    }
    int32_t v = enter(f, f->inside[i]);
    if (f->no_memory || !sg_triangles_insert(f->work, &f->triangles, v)) {
      f->no_memory = true;
      return false;
    }
  }
  return true;
}

/* A border edge with the polygon on both sides stays, and so does what lies
 * along others. */
static bool
is_fixed(void *data, int32_t a, int32_t b)
{
  const filler *f = data;
  uint32_t v = (uint32_t)sg_work_id(f->work, a) - 1;
  uint32_t w = (uint32_t)sg_work_id(f->work, b) - 1;

  return find_side(f, v, w) || sg_holds_have(&f->holds, v, w);
}

/* Vertices that are straight up to rounding make slivers, and two faces might
 * have one in the same place: so the angles are made as wide as they can be. */
static bool
triangulated(filler *f)
{
  const sg_cancel cancel = {stopping, NULL};
  int32_t edge;

  if (!f->work) {
    f->work = sg_work_open(f->group->plane.n);
    f->no_memory = !f->work;
  } else {
    sg_work_clear(f->work, f->group->plane.n);
  }
  f->triangles.n = 0;
  if (f->no_memory || !enter_sides(f)) {
    return false;
  }
  sg_outcome outcome =
      sg_work_triangulate(f->work, &f->triangles, &edge, &cancel);
  bool done = outcome == SG_DONE && f->triangles.n > 0 && insert_inside(f);
  if (done) {
    outcome =
        sg_triangles_delaunay(f->work, &f->triangles, is_fixed, f, &cancel);
  }
  f->no_memory = f->no_memory || outcome == SG_NO_SPACE;
  return done && outcome == SG_DONE;
}

/* Copies the triangles out; *sides is how many of their edges are the
 * polygon's, the others are in f->chord. */
static bool
take_triangles(filler *f, size_t *sides, size_t *chords)
{
  sg_group *group = f->group;

  for (size_t t = 0; t < group->triangles; t++) {
    uint32_t *corner = group->triangle[t];
    for (int k = 0; k < 3; k++) {
      corner[k] = (uint32_t)sg_work_id(f->work, f->triangles.item[t].v[k]) - 1;
    }
    group->auxiliary[t] = 0;
    for (int k = 0; k < 3; k++) {
      uint32_t a = corner[k], b = corner[(k + 1) % 3];
      side *edge = find_side(f, a, b);
      if (!edge) {
        uint32_t *chord = f->chord[(*chords)++];
        chord[0] = a < b ? a : b;
        chord[1] = a < b ? b : a;
        chord[2] = a < b;
      } else if (edge->used) {
        return false;
      } else {
        edge->used = true;
        ++*sides;
        group->auxiliary[t] |= (uint8_t)(edge->auxiliary << k);
      }
    }
  }
  return true;
}

static int
compare_chords(const void *a, const void *b)
{
  return memcmp(a, b, 3 * sizeof(uint32_t));
}

/* Each chord there and back, once. */
static bool
chords_pair(const filler *f, size_t chords)
{
  qsort(f->chord, chords, sizeof *f->chord, compare_chords);
  for (size_t i = 0; i < chords; i += 2) {
    const uint32_t *a = f->chord[i], *b = a + 3;
    if (i + 1 == chords || a[0] != b[0] || a[1] != b[1] || a[2] == b[2] ||
        (i > 0 && a[0] == f->chord[i - 1][0] && a[1] == f->chord[i - 1][1])) {
      return false;
    }
  }
  return true;
}

/* The triangles have the polygon's border, and all vertices inside. */
static bool
fits_in(filler *f)
{
  size_t sides = 0, chords = 0, n = f->triangles.n;
  sg_group *group = f->group;

  group->triangle = malloc(n * sizeof *group->triangle);
  group->auxiliary = malloc(n);
  f->chord = malloc(3 * n * sizeof *f->chord);
  group->triangles = n;
  f->no_memory = !group->triangle || !group->auxiliary || !f->chord;
  bool fits = !f->no_memory && take_triangles(f, &sides, &chords) &&
              sides == f->sides && chords_pair(f, chords);
  free(f->chord);
  f->chord = NULL;
  for (size_t i = 0; fits && i < f->insides; i++) {
    bool found = false;
    for (size_t t = 0; !found && t < n; t++) {
      const uint32_t *corner = group->triangle[t];
      found = corner[0] == f->inside[i] || corner[1] == f->inside[i] ||
              corner[2] == f->inside[i];
    }
    fits = found;
  }
  return fits;
}

static void
forget(sg_group *group)
{
  free(group->triangle);
  free(group->auxiliary);
  group->triangle = NULL;
  group->auxiliary = NULL;
  group->triangles = 0;
}

/* ---- groups ------------------------------------------------------------- */

static bool
polygon_found(filler *f)
{
  f->sides = 0;
  bool found = each_half(f, see_border);
  if (found && f->sides) {
    qsort(f->side, f->sides, sizeof *f->side, compare_sides);
  }
  if (!found || !sides_are_apart(f) || !find_inside(f)) {
    return false;
  }
  f->no_memory = !sg_holds_find(f->m, f->group, &f->holds);
  return !f->no_memory;
}

static void
do_group(filler *f)
{
  forget(f->group);
  f->group->failed = !polygon_found(f) || !triangulated(f) || !fits_in(f);
  if (f->group->failed) {
    forget(f->group);
  }
}

static void
do_groups(void *data, size_t task)
{
  filling *fill = data;
  filler f = {.m = fill->m};
  size_t to = (task + 1) * fill->at_once;

  for (size_t i = task * fill->at_once; i < to && i < fill->n && !f.no_memory;
       i++) {
    f.group = &fill->m->group[fill->wanted[i]];
    do_group(&f);
  }
  fill->no_memory[task] = f.no_memory;
  sg_work_close(f.work);
  free(f.triangles.item);
  free(f.side);
  free(f.holds.pair);
  free(f.inside);
}

/* What has failed may change less; the others are to be done again. */
static bool
give_way(sg_merge *m)
{
  bool any = false;

  for (size_t i = 0; i < m->groups; i++) {
    sg_group *group = &m->group[i];
    if (!group->failed) {
      continue;
    }
    any = true;
    group->failed = false;
    group->state = group->state == SG_FREE ? SG_BORDER_STAYS : SG_AS_IT_WAS;
  }
  return any;
}

static sg_merge_end
fill_all(filling *fill)
{
  sg_merge *m = fill->m;
  fill->at_once = fill->n > AT_ONCE * AT_ONCE ? AT_ONCE : 1;
  size_t tasks = (fill->n + fill->at_once - 1) / fill->at_once;

  if (!sg_pool_run(m->options->pool, tasks, do_groups, fill,
                   m->options->cancel)) {
    return SG_MERGE_STOPPED;
  }
  for (size_t i = 0; i < tasks; i++) {
    if (fill->no_memory[i]) {
      return SG_MERGE_NO_MEMORY;
    }
  }
  return SG_MERGE_DONE;
}

sg_merge_end
sg_merge_fill(sg_merge *m, bool *again)
{
  filling fill = {.m = m};
  sg_merge_end end = SG_MERGE_NO_MEMORY;

  *again = false;
  fill.wanted = malloc((m->groups + 1) * sizeof *fill.wanted);
  fill.no_memory = calloc(m->groups + 1, sizeof *fill.no_memory);
  if (fill.wanted && fill.no_memory) {
    for (size_t i = 0; i < m->groups; i++) {
      sg_group *group = &m->group[i];
      forget(group);
      if (group->state != SG_AS_IT_WAS && (group->losing || group->thin)) {
        fill.wanted[fill.n++] = (uint32_t)i;
      }
    }
    end = fill_all(&fill);
    *again = end == SG_MERGE_DONE && give_way(m);
    if (end == SG_MERGE_DONE && !*again) {
      end = sg_merge_meet(m);
      *again = end == SG_MERGE_DONE && give_way(m);
    }
  }
  free(fill.wanted);
  free(fill.no_memory);
  return end;
}
