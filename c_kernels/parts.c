/* parts.c -- see parts.h
 *
 * Two passes. The first finds, for each drawn line by itself, its hidden
 * intervals. The second takes away what another line draws already: see
 * yields().
 */
#include "parts.h"

#include "bounds.h"
#include "smooth.h"

#include <math.h>
#include <stdlib.h>

/* Degrees: what counts as flat. */
#define FLAT 0.01

enum { POLL_EVERY = 256 };

/* ---------------------------------------------------------------- roles */

sg_role
sg_look_role(const sg_look *look, double crease)
{
  if (look->cut) {
    return SG_PENETRATION;
  }
  if (look->faces < 2) {
    return look->faces ? SG_BORDER : SG_CURVE;
  }
  if ((look->left == 0) != (look->right == 0) && !look->inside) {
    return SG_OUTLINE;
  }
  return look->bend > crease + SG_SMOOTH_OVER ? SG_CREASE
         : look->bend > FLAT                  ? SG_SMOOTH
                                              : SG_MESH;
}

const char *
sg_role_name(sg_role role)
{
  static const char *const name[SG_ROLES] = {[SG_PENETRATION] = "penetration",
                                             [SG_OUTLINE] = "outline",
                                             [SG_CREASE] = "crease",
                                             [SG_BORDER] = "border",
                                             [SG_CURVE] = "curve",
                                             [SG_SECTION] = "section",
                                             [SG_SMOOTH] = "smooth",
                                             [SG_MESH] = "mesh"};

  return name[role];
}

bool
sg_role_drawn(sg_role role, sg_which which)
{
  return which == SG_LINES_ALL || role == SG_PENETRATION ||
         (which == SG_LINES_FEATURE && role != SG_SMOOTH && role != SG_MESH);
}

/* ------------------------------------------------------------ intervals */

typedef struct interval {
  double from, to;
} interval;

typedef struct intervals {
  interval *at;
  size_t n, room;
} intervals;

static bool
push(intervals *set, double from, double to)
{
  if (set->n == set->room) {
    size_t more = set->room ? 2 * set->room : 32;
    interval *wider = realloc(set->at, more * sizeof *wider);
    if (!wider) {
      return false;
    }
    set->at = wider;
    set->room = more;
  }
  set->at[set->n++] = (interval){from, to};
  return true;
}

/* The union of sorted parts, appended to `out`: gaps up to `least` close, then
 * what is not longer than `least` goes. */
static bool
push_union(intervals *out, const sg_hidden *part, size_t n, double least)
{
  for (size_t i = 0; i < n;) {
    double from = part[i].from <= least ? 0.0 : part[i].from;
    double to = part[i].to;
    for (i++; i < n && part[i].from - to <= least; i++) {
      to = sg_larger(to, part[i].to);
    }
    if (1.0 - to <= least) {
      to = 1.0;
    }
    if (to - from > least && !push(out, from, to)) {
      return false;
    }
  }
  return true;
}

/* The gaps of a sorted set in 0 to 1, appended to `out`. */
static bool
push_gaps(intervals *out, const interval *set, size_t n)
{
  double at = 0.0;

  for (size_t i = 0; i < n; i++) {
    if (set[i].from > at && !push(out, at, set[i].from)) {
      return false;
    }
    at = set[i].to;
  }
  return at >= 1.0 || push(out, at, 1.0);
}

/* Takes from-to away from every interval of a sorted set. */
static bool
subtract(intervals *set, double from, double to)
{
  size_t n = set->n, kept = 0;

  for (size_t i = 0; i < n; i++) {
    interval x = set->at[i];
    if (x.from < from && x.to > to) { /* in two: the second goes behind */
      if (!push(set, to, x.to)) {
        return false;
      }
      set->at[kept++] = (interval){x.from, from};
    } else if (x.to <= from || x.from >= to) {
      set->at[kept++] = x;
    } else if (x.from < from) {
      set->at[kept++] = (interval){x.from, from};
    } else if (x.to > to) {
      set->at[kept++] = (interval){to, x.to};
    }
  }
  for (size_t i = n; i < set->n; i++) {
    set->at[kept++] = set->at[i];
  }
  set->n = kept;
  return true;
}

/* ---------------------------------------------------------- first pass */

typedef struct drawing {
  sg_hide *hide;
  const sg_scene *scene;
  sg_role *role;    /* [lines], SG_ROLES: not drawn */
  size_t *first;    /* [lines + 1]: its hidden intervals */
  intervals hidden; /* of all lines, before anything is taken away */
  intervals mine, other;
  sg_hiddens masks;
  sg_overlaps overlaps;
  sg_part *part;
  size_t parts, room;
} drawing;

static double
least_of(const drawing *d, size_t k)
{
  return SG_SHORTEST / sg_line_length(d->scene, &d->scene->line[k]);
}

static void
choose(drawing *d, size_t k, sg_which which, double crease)
{
  const sg_scene_line *line = &d->scene->line[k];
  sg_role role = sg_look_role(&line->look, crease);

  d->role[k] =
      sg_role_drawn(role, which) && sg_line_length(d->scene, line) > SG_SHORTEST
          ? role
          : SG_ROLES;
}

/* Among the sorted parts, the one from `from` to the line's end. */
static bool
insert_fold(sg_hiddens *parts, double from)
{
  size_t i = parts->n;

  if (parts->n == parts->room) {
    size_t more = 2 * parts->room + 32;
    sg_hidden *wider = realloc(parts->part, more * sizeof *wider);
    if (!wider) {
      return false;
    }
    parts->part = wider;
    parts->room = more;
  }
  for (; i > 0 && parts->part[i - 1].from > from; i--) {
    parts->part[i] = parts->part[i - 1];
  }
  parts->part[i] = (sg_hidden){.from = from, .to = 1.0};
  parts->n++;
  return true;
}

static bool
find_hidden(drawing *d, size_t k)
{
  const sg_scene_line *line = &d->scene->line[k];
  bool solid = !sg_hide_sees_through(d->hide, line->s, line->s);
  double folded = solid ? line->look.folded : 0.0;

  d->first[k] = d->hidden.n;
  if (d->role[k] == SG_ROLES) {
    return true;
  }
  if (solid && (sg_look_is_back(&line->look) || folded >= 1.0)) {
    return push(&d->hidden, 0.0, 1.0);
  }
  return sg_hide_masks(d->hide, k, true, &d->masks) &&
         (folded == 0.0 || insert_fold(&d->masks, 1.0 - folded)) &&
         push_union(&d->hidden, d->masks.part, d->masks.n, least_of(d, k));
}

/* --------------------------------------------------------- second pass */

static bool
before(const drawing *d, size_t j, size_t k)
{
  return d->role[j] != d->role[k] ? d->role[j] < d->role[k] : j < k;
}

/* Takes the intervals of another line away where it overlaps. */
static bool
subtract_mapped(intervals *mine, const interval *set, size_t n,
                const sg_overlap *o)
{
  double low = sg_smaller(o->from2, o->to2), high = sg_larger(o->from2, o->to2);
  double rate = (o->to - o->from) / (o->to2 - o->from2);

  for (size_t i = 0; i < n; i++) {
    double x = sg_larger(set[i].from, low), y = sg_smaller(set[i].to, high);
    double from = o->from + (x - o->from2) * rate;
    double to = o->from + (y - o->from2) * rate;
    if (x < y && !subtract(mine, sg_smaller(from, to), sg_larger(from, to))) {
      return false;
    }
  }
  return true;
}

/* Line k's intervals (visible or hidden) yield to the other lines there: all
 * to the visible ones of a line before it, hidden ones to every visible one
 * and to hidden ones of a line before it. */
static bool
yields(drawing *d, size_t k, bool hidden)
{
  for (size_t i = 0; i < d->overlaps.n; i++) {
    const sg_overlap *o = &d->overlaps.part[i];
    size_t j = o->line;
    const interval *set = d->hidden.at + d->first[j];
    size_t n = d->first[j + 1] - d->first[j];
    if (d->role[j] == SG_ROLES || !(hidden || before(d, j, k))) {
      continue;
    }
    d->other.n = 0;
    if (!push_gaps(&d->other, set, n) ||
        !subtract_mapped(&d->mine, d->other.at, d->other.n, o) ||
        (hidden && before(d, j, k) && !subtract_mapped(&d->mine, set, n, o))) {
      return false;
    }
  }
  return true;
}

static bool
push_parts(drawing *d, size_t k, bool hidden)
{
  for (size_t i = 0; i < d->mine.n; i++) {
    interval x = d->mine.at[i];
    if (x.to - x.from <= least_of(d, k)) {
      continue;
    }
    if (d->parts == d->room) {
      size_t more = d->room ? 2 * d->room : 256;
      sg_part *wider = realloc(d->part, more * sizeof *wider);
      if (!wider) {
        return false;
      }
      d->part = wider;
      d->room = more;
    }
    d->part[d->parts++] =
        (sg_part){(uint32_t)k, x.from, x.to, hidden, d->role[k]};
  }
  return true;
}

static int
part_compare(const void *a, const void *b)
{
  const sg_part *x = a, *y = b;

  return (x->from > y->from) - (x->from < y->from);
}

static bool
draw_line(drawing *d, size_t k)
{
  const interval *set = d->hidden.at + d->first[k];
  size_t n = d->first[k + 1] - d->first[k];
  size_t start = d->parts;
  bool ok;

  if (d->role[k] == SG_ROLES) {
    return true;
  }
  d->mine.n = 0;
  ok = sg_hide_overlaps(d->hide, k, &d->overlaps) &&
       push_gaps(&d->mine, set, n) && yields(d, k, false) &&
       push_parts(d, k, false);
  d->mine.n = 0;
  for (size_t i = 0; ok && i < n; i++) {
    ok = push(&d->mine, set[i].from, set[i].to);
  }
  ok = ok && yields(d, k, true) && push_parts(d, k, true);
  if (ok && d->parts - start > 1) {
    qsort(d->part + start, d->parts - start, sizeof *d->part, part_compare);
  }
  return ok;
}

/* -------------------------------------------------------------- drawing */

static void
drawing_clear(drawing *d)
{
  free(d->role);
  free(d->first);
  free(d->hidden.at);
  free(d->mine.at);
  free(d->other.at);
  free(d->masks.part);
  free(d->overlaps.part);
}

/* One pass over all lines; false: stopped, or no memory. */
static bool
pass(drawing *d, bool (*step)(drawing *, size_t), const sg_poll *poll,
     bool *memory)
{
  for (size_t k = 0; k < d->scene->lines; k++) {
    if (k % POLL_EVERY == 0 && sg_poll_stop(poll)) {
      return false;
    }
    if (!step(d, k)) {
      *memory = false;
      return false;
    }
  }
  return true;
}

bool
sg_parts_of(sg_hide *hide, sg_which which, double crease, const sg_poll *poll,
            sg_part **out, size_t *n, bool *memory)
{
  size_t lines = hide->scene->lines;
  drawing d = {.hide = hide, .scene = hide->scene};
  bool ok;

  d.role = malloc((lines + 1) * sizeof *d.role);
  d.first = malloc((lines + 1) * sizeof *d.first);
  ok = *memory = d.role && d.first;
  for (size_t k = 0; ok && k < lines; k++) {
    choose(&d, k, which, crease);
  }
  ok = ok && pass(&d, find_hidden, poll, memory);
  if (ok) {
    d.first[lines] = d.hidden.n;
    ok = pass(&d, draw_line, poll, memory);
  }
  drawing_clear(&d);
  if (!ok) {
    free(d.part);
    d.part = NULL;
    d.parts = 0;
  }
  *out = d.part;
  *n = d.parts;
  return ok;
}
