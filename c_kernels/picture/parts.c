/* parts.c -- see parts.h
 *
 * Two passes. The first finds, for each drawn line by itself, its hidden
 * intervals. The second takes away what another line draws already: see
 * yields(). Both go by blocks of lines, with all threads of the thread pool.
 */
#include "parts.h"

#include "engine/list.h"
#include "engine/search.h"
#include "number/bounds.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { ASK_EVERY = 4096 };

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
  if (!sg_list_grow(&set->at, set->n, &set->room, sizeof *set->at)) {
    return false;
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

/* -------------------------------------------------------------- blocks */

enum { BLOCK = 256 }; /* lines that are one task */

/* What was found of some of the drawn lines, one after another. */
typedef struct block {
  intervals hidden; /* before anything is taken away */
  sg_drawn_part *part;
  size_t parts, room;
} block;

/* What one task needs for itself, and leaves to the next one. */
typedef struct worker {
  struct worker *next;
  sg_seen seen;
  sg_hiddens masks;
  sg_overlaps overlaps;
  intervals mine, other;
} worker;

/* The hidden intervals of a line in those of its block. */
typedef struct span {
  uint32_t from, to;
} span;

typedef struct work {
  const sg_mask_grid *masks;
  const sg_scene *scene;
  const sg_hide_throughs *through;
  sg_line_grid grid;
  uint32_t *line; /* [lines] the drawn ones, ascending */
  size_t lines, blocks;
  sg_role *role;   /* [lines] */
  uint32_t *drawn; /* [scene->lines] its place in line, or UINT32_MAX */
  span *span;      /* [lines] */
  block *block;    /* [blocks] */
  pthread_mutex_t lock;
  worker *idle; /* under the lock */
  atomic_bool no_memory;
} work;

static void
worker_close(worker *of)
{
  sg_seen_clear(&of->seen);
  sg_hiddens_clear(&of->masks);
  free(of->overlaps.part);
  free(of->mine.at);
  free(of->other.at);
  free(of);
}

/* A worker for this task; null: no memory. */
static worker *
worker_take(work *w)
{
  size_t masks = w->scene->masks, things = masks > w->lines ? masks : w->lines;
  worker *of;

  pthread_mutex_lock(&w->lock);
  of = w->idle;
  if (of) {
    w->idle = of->next;
  }
  pthread_mutex_unlock(&w->lock);
  if (!of && (of = calloc(1, sizeof *of)) && !sg_seen_init(&of->seen, things)) {
    free(of);
    of = NULL;
  }
  return of;
}

static void
worker_return(work *w, worker *of)
{
  pthread_mutex_lock(&w->lock);
  of->next = w->idle;
  w->idle = of;
  pthread_mutex_unlock(&w->lock);
}

/* Does one step for every line of a block. */
typedef bool line_step(work *w, worker *of, block *b, size_t k);

static void
each_line(work *w, size_t task, line_step *step)
{
  worker *of = worker_take(w);
  size_t end = (task + 1) * BLOCK;

  for (size_t k = task * BLOCK; of && k < w->lines && k < end; k++) {
    if (!step(w, of, &w->block[task], k)) {
      atomic_store(&w->no_memory, true);
    }
    if (k % 32 == 0 && sg_pool_stopping()) {
      break;
    }
  }
  if (of) {
    worker_return(w, of);
  } else {
    atomic_store(&w->no_memory, true);
  }
}

/* ---------------------------------------------------------- first pass */

static double
least_of(const work *w, size_t k)
{
  return SG_SHORTEST / w->grid.stretch[w->grid.place[k]].length;
}

/* Puts a fold among the sorted parts. */
static bool
insert_fold(sg_hiddens *parts, const sg_scene_fold *fold)
{
  size_t i = parts->n;

  if (!sg_list_grow(&parts->part, parts->n, &parts->room,
                    sizeof *parts->part)) {
    return false;
  }
  for (; i > 0 && parts->part[i - 1].from > fold->from; i--) {
    parts->part[i] = parts->part[i - 1];
  }
  parts->part[i] = (sg_hidden){.from = fold->from, .to = fold->to};
  parts->n++;
  return true;
}

static bool
hides(const work *w, const sg_scene_line *line, const sg_scene_fold *fold)
{
  return !sg_hide_sees_through(w->through, line->s, fold->s);
}

/* Whether all of a line is hidden at once: step 2, or it lies on a surface that
 * hides all of it. */
static bool
is_hidden(const work *w, const sg_scene_line *line, sg_scene_folds on)
{
  for (size_t i = 0; i < on.n; i++) {
    if (on.at[i].from <= 0.0 && on.at[i].to >= 1.0 &&
        hides(w, line, &on.at[i])) {
      return true;
    }
  }
  return sg_look_is_back(&line->look) &&
         !sg_hide_sees_through(w->through, line->s, line->s);
}

static bool
insert_folds(const work *w, const sg_scene_line *line, sg_scene_folds on,
             sg_hiddens *parts)
{
  for (size_t i = 0; i < on.n; i++) {
    if (hides(w, line, &on.at[i]) && !insert_fold(parts, &on.at[i])) {
      return false;
    }
  }
  return true;
}

static bool
find_hidden(work *w, worker *of, block *b, size_t k)
{
  const sg_scene_line *line = &w->scene->line[w->line[k]];
  sg_scene_folds on = sg_scene_folds_of(w->scene, w->line[k]);
  bool good;

  w->span[k].from = (uint32_t)b->hidden.n;
  if (is_hidden(w, line, on)) {
    good = push(&b->hidden, 0.0, 1.0);
  } else {
    good = sg_mask_grid_ask(w->masks, w->line[k], w->through, true, &of->seen,
                            &of->masks) &&
           insert_folds(w, line, on, &of->masks) &&
           push_union(&b->hidden, of->masks.part, of->masks.n, least_of(w, k));
  }
  w->span[k].to = (uint32_t)b->hidden.n;
  return good;
}

static void
find_hidden_of_block(void *data, size_t task)
{
  each_line(data, task, find_hidden);
}

/* --------------------------------------------------------- second pass */

static const interval *
hidden_of(const work *w, size_t k, size_t *n)
{
  *n = w->span[k].to - w->span[k].from;
  return w->block[k / BLOCK].hidden.at + w->span[k].from;
}

/* Only outlines do. */
static bool
substitute_outline(const work *w, size_t k)
{
  return w->role[k] == SG_OUTLINE &&
         w->scene->line[w->line[k]].look.substitute_outline;
}

/* Substitute outlines come after all other lines. */
static bool
before(const work *w, size_t j, size_t k)
{
  if (substitute_outline(w, j) != substitute_outline(w, k)) {
    return substitute_outline(w, k);
  }
  return w->role[j] != w->role[k] ? w->role[j] < w->role[k] : j < k;
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
yields(const work *w, worker *of, size_t k, bool hidden)
{
  for (size_t i = 0; i < of->overlaps.n; i++) {
    const sg_overlap *o = &of->overlaps.part[i];
    size_t j = w->drawn[o->line], n;
    const interval *set = hidden_of(w, j, &n);
    if (!hidden && !before(w, j, k)) {
      continue;
    }
    of->other.n = 0;
    if (!push_gaps(&of->other, set, n) ||
        !subtract_mapped(&of->mine, of->other.at, of->other.n, o) ||
        (hidden && before(w, j, k) && !subtract_mapped(&of->mine, set, n, o))) {
      return false;
    }
  }
  return true;
}

/* A part is drawn only if it is longer than this. A substitute outline that
 * other lines interrupt is drawn only in gaps longer than what counts as near;
 * one that is shorter as a whole is always drawn. */
static double
least_drawn(const work *w, size_t k)
{
  double least = least_of(w, k);

  return substitute_outline(w, k)
             ? sg_smaller(least / SG_SHORTEST * w->scene->near, SG_WHOLE)
             : least;
}

static bool
push_parts(const work *w, worker *of, block *b, size_t k, bool hidden)
{
  double least = least_drawn(w, k);

  for (size_t i = 0; i < of->mine.n; i++) {
    interval x = of->mine.at[i];
    if (x.to - x.from <= least) {
      continue;
    }
    if (!sg_list_grow(&b->part, b->parts, &b->room, sizeof *b->part)) {
      return false;
    }
    b->part[b->parts++] =
        (sg_drawn_part){w->line[k], x.from, x.to, hidden, w->role[k]};
  }
  return true;
}

SG_ORDER(part_compare, sg_drawn_part, SG_BY(from));

static bool
draw_line(work *w, worker *of, block *b, size_t k)
{
  size_t n, start = b->parts;
  const interval *set = hidden_of(w, k, &n);
  bool ok;

  of->mine.n = 0;
  ok = sg_line_grid_ask(&w->grid, k, &of->seen, &of->overlaps) &&
       push_gaps(&of->mine, set, n) && yields(w, of, k, false) &&
       push_parts(w, of, b, k, false);
  of->mine.n = 0;
  for (size_t i = 0; ok && !substitute_outline(w, k) && i < n; i++) {
    ok = push(&of->mine, set[i].from, set[i].to);
  }
  ok = ok && yields(w, of, k, true) && push_parts(w, of, b, k, true);
  if (ok && b->parts - start > 1) {
    qsort(b->part + start, b->parts - start, sizeof *b->part, part_compare);
  }
  return ok;
}

static void
draw_block(void *data, size_t task)
{
  each_line(data, task, draw_line);
}

/* -------------------------------------------------------------- drawing */

/* The lines that are drawn, with their roles. False: stopped, or no memory. */
static bool
choose_lines(work *w, const sg_drawing *drawing, const sg_cancel *cancel,
             bool *memory)
{
  const sg_scene *scene = w->scene;

  w->line = malloc((scene->lines + 1) * sizeof *w->line);
  w->role = malloc((scene->lines + 1) * sizeof *w->role);
  w->drawn = malloc((scene->lines + 1) * sizeof *w->drawn);
  *memory = w->line && w->role && w->drawn;
  for (size_t k = 0; *memory && k < scene->lines; k++) {
    const sg_scene_line *line = &scene->line[k];
    sg_role role = sg_look_role(&line->look, drawing->crease);

    w->drawn[k] = UINT32_MAX;
    if (sg_role_drawn(role, drawing->which) &&
        sg_line_length(scene, line) > SG_SHORTEST) {
      w->drawn[k] = (uint32_t)w->lines;
      w->role[w->lines] = role;
      w->line[w->lines++] = (uint32_t)k;
    }
    if (k % ASK_EVERY == 0 && sg_cancelled(cancel)) {
      return false;
    }
  }
  return *memory;
}

/* The places for what will be found, and the grid of the lines. */
static bool
work_init(work *w, const sg_drawing *drawing, const sg_cancel *cancel,
          bool *memory)
{
  if (!choose_lines(w, drawing, cancel, memory)) {
    return false;
  }
  w->blocks = (w->lines + BLOCK - 1) / BLOCK;
  w->span = malloc((w->lines + 1) * sizeof *w->span);
  w->block = calloc(w->blocks + 1, sizeof *w->block);
  *memory = w->span && w->block;
  return *memory && sg_line_grid_init(&w->grid, w->scene, w->line, w->lines,
                                      cancel, memory);
}

static void
work_clear(work *w)
{
  for (size_t i = 0; w->block && i < w->blocks; i++) {
    free(w->block[i].hidden.at);
    free(w->block[i].part);
  }
  while (w->idle) {
    worker *next = w->idle->next;
    worker_close(w->idle);
    w->idle = next;
  }
  free(w->block);
  free(w->span);
  free(w->line);
  free(w->role);
  free(w->drawn);
  sg_line_grid_clear(&w->grid);
  pthread_mutex_destroy(&w->lock);
}

/* The parts of all blocks, in order; null: no memory. */
static sg_drawn_part *
gather_parts(const work *w, size_t *n)
{
  sg_drawn_part *all;

  *n = 0;
  for (size_t i = 0; i < w->blocks; i++) {
    *n += w->block[i].parts;
  }
  all = malloc((*n + 1) * sizeof *all);
  for (size_t i = 0, at = 0; all && i < w->blocks; i++) {
    if (w->block[i].parts > 0) {
      memcpy(all + at, w->block[i].part, w->block[i].parts * sizeof *all);
      at += w->block[i].parts;
    }
  }
  return all;
}

bool
sg_parts_of(const sg_mask_grid *masks, const sg_drawing *drawing, sg_pool *pool,
            const sg_cancel *cancel, sg_drawn_part **out, size_t *n,
            bool *memory)
{
  work w = {
      .masks = masks, .scene = masks->scene, .through = &drawing->through};
  bool done;

  *out = NULL;
  pthread_mutex_init(&w.lock, NULL);
  done = work_init(&w, drawing, cancel, memory) &&
         sg_pool_run(pool, w.blocks, find_hidden_of_block, &w, cancel) &&
         !w.no_memory && sg_pool_run(pool, w.blocks, draw_block, &w, cancel);
  *memory = *memory && !w.no_memory;
  if (done && *memory) {
    *out = gather_parts(&w, n);
    *memory = *out != NULL;
  }
  work_clear(&w);
  return *out != NULL;
}
