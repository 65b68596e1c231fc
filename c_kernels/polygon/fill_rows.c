/* fill_rows.c -- planes and triangles of whole segments. */
#include "complete.h"
#include "doors/world.h"
#include "engine/search.h"
#include "rows/append_rows.h"
#include "rows/grain_rows.h"
#include "rows/key_table.h"
#include "rows/live_rows.h"

#include <string.h>

/* ---- rows ---- */

/* t counts from 0 in each segment: from its next fresh id instead. */
static bool
number_triangles(sg_call *call, sg_world *world, sg_triangle_rows *rows)
{
  sg_key_table first;
  bool good = true;

  sg_key_table_init(&first, 1);
  for (size_t i = 0; good && i < rows->n; i++) {
    int32_t s = rows->s[i];
    uint32_t *id = sg_key_table_put(&first, (const uint32_t[]){(uint32_t)s});

    good = id || sg_call_no_memory(call);
    if (good && *id == SG_NO_KEY) {
      *id = (uint32_t)sg_call_fresh(call, world, SG_T, s);
      good = *id != 0;
    }
    if (good) {
      rows->t[i] += (int32_t)*id;
    }
  }
  sg_key_table_clear(&first);
  return good;
}

static bool
add_rows(sg_call *call, sg_world *world, sg_completion *found)
{
  sg_plane_rows *p = &found->planes;
  sg_triangle_rows *t = &found->triangles;
  const void *const plane[] = {p->s, p->p, p->c[0], p->c[1], p->c[2], p->c[3]};
  const void *const triangle[] = {t->s, t->p, t->t, t->v[0], t->v[1], t->v[2]};

  return sg_append_columns(call, world, SG_PLANE, p->n, plane) &&
         number_triangles(call, world, t) &&
         sg_append_columns(call, world, SG_T, t->n, triangle);
}

/* ---- faults ---- */

static sg_fault_what
what_of(const sg_polygon_fault *f)
{
  sg_fault_what what = {.is = SG_FAULT_WHAT_NO_AREA};

  switch (f->kind) {
  case SG_FAULT_OPEN:
    what.is = SG_FAULT_WHAT_NOT_CLOSED;
    what.not_closed.v = f->a;
    break;
  case SG_FAULT_EDGE:
    what.is = SG_FAULT_WHAT_NOT_SIMPLE;
    what.not_simple.v1 = f->a;
    what.not_simple.v2 = f->b;
    break;
  case SG_FAULT_BENT:
    what.is = SG_FAULT_WHAT_NOT_FLAT;
    what.not_flat.distance = f->size;
    break;
  case SG_FAULT_TANGLED:
    what.is = SG_FAULT_WHAT_TANGLED;
    break;
  case SG_FAULT_FOLDED:
    what.is = SG_FAULT_WHAT_FOLDED;
    break;
  case SG_FAULT_NO_AREA:
    break;
  }
  return what;
}

static bool
list_faults(sg_call *call, const sg_completion *found, sg_fault_fact_list *out)
{
  for (size_t i = 0; i < found->faults; i++) {
    const sg_polygon_fault *f = &found->fault[i];

    if (!sg_fault_fact_list_add(call, out,
                                (sg_fault_fact){f->s, f->p, what_of(f)})) {
      return false;
    }
  }
  return true;
}

/* ---- the door ---- */

static const sg_relation READ[5] = {SG_V, SG_E, SG_P, SG_PLANE, SG_T};

/* All that there is. */
static bool
see_all(void *of, sg_flatness *out)
{
  sg_call *call = of;
  const sg_version *version = sg_call_version(call);
  sg_view view = {0};
  double grain = 0;
  bool good = version && sg_grain_of_all(version, &grain) &&
              sg_version_view(version, SG_V, &view);

  sg_flatness_init(out, grain);
  for (size_t i = 0; good && i < view.pages; i++) {
    sg_flatness_page(out, &view, i);
    good = !sg_cancelled(&call->cancel);
  }
  sg_view_clear(&view);
  return good;
}

/* Of n segments, null: of all. */
static bool
find_missing(sg_call *call, const int32_t *segment, size_t n, size_t contacts,
             sg_completion *found)
{
  const sg_version *version = sg_call_version(call);
  sg_pool *pool = sg_call_pool(call);
  sg_view view[5] = {{0}};
  bool stopped, good = version && pool;

  *found = (sg_completion){0};
  for (int i = 0; good && i < 5; i++) {
    good = sg_version_view(version, READ[i], &view[i]);
  }
  good =
      good && sg_complete(&(sg_completion_input){&view[0], &view[1], &view[2],
                                                 &view[3], &view[4], segment, n,
                                                 contacts, see_all, call, pool},
                          found, &stopped, &call->cancel);
  for (int i = 0; i < 5; i++) {
    sg_view_clear(&view[i]);
  }
  return good || sg_call_ended(call);
}

bool
sg_door_fill_triangles(sg_call *call, const sg_segments_asked *ss,
                       size_t contacts, sg_fault_fact_list *faults)
{
  bool all = ss->is == SG_SEGMENTS_ASKED_ALL;
  sg_completion found;

  if (!all && ss->these.n == 0) {
    return true;
  }
  /* What is missing stays so until it is added. */
  sg_world *world = sg_call_claim(call);

  if (!world) {
    return false;
  }
  bool good = find_missing(call, all ? NULL : ss->these.at,
                           all ? 0 : ss->these.n, contacts, &found) &&
              add_rows(call, world, &found) &&
              list_faults(call, &found, faults);

  sg_completion_clear(&found);
  sg_world_release(world);
  return good;
}

/* ---- segments that nobody has completed ---- */

/* Segments that are asked for, ascending, and which of them were seen. */
typedef struct seen {
  const sg_int_list *ss;
  bool *there; /* [ss->n] */
  size_t left; /* not seen yet */
} seen;

static void
see_segment(seen *all, int32_t s)
{
  size_t at = sg_find_id(all->ss->at, all->ss->n, s);

  if (at != SIZE_MAX && !all->there[at]) {
    all->there[at] = true;
    all->left--;
  }
}

/* Rows of a segment mostly stand together: many pages have those of one. */
static void
see_page(seen *all, const sg_view *view, size_t page)
{
  const uint64_t *live = view->live[page];
  const int32_t *s = view->column[0].page[page].i;
  bool one = view->span && view->span[page][0] == view->span[page][1];
  int32_t last = 0;

  for (unsigned i = sg_live_next(live, 0); i < SG_PAGE_ROWS && all->left > 0;
       i = one ? SG_PAGE_ROWS : sg_live_next(live, i + 1)) {
    if (s[i] != last) {
      see_segment(all, last = s[i]);
    }
  }
}

/* Those that have rows of a relation (has), or that have none, are left. */
static bool
leave(sg_call *call, const sg_version *version, sg_relation relation, bool has,
      sg_int_list *ss)
{
  seen all = {ss, sg_call_alloc(call, ss->n), ss->n};
  bool stopped = false;
  size_t n = 0;
  sg_view view;

  if (!all.there) {
    return false;
  }
  if (!sg_version_view(version, relation, &view)) {
    return sg_call_no_memory(call);
  }
  memset(all.there, 0, ss->n);
  for (size_t page = 0; page < view.pages && all.left > 0 && !stopped; page++) {
    see_page(&all, &view, page);
    stopped = sg_cancelled(&call->cancel);
  }
  sg_view_clear(&view);
  for (size_t i = 0; i < ss->n; i++) {
    if (all.there[i] == has) {
      ss->at[n++] = ss->at[i];
    }
  }
  ss->n = n;
  return !stopped;
}

static void
list_segment(void *reader, const sg_live_row *row)
{
  sg_int_list *ss = reader;

  ss->at[ss->n++] = sg_row_int(row, 0);
}

bool
sg_door_untriangulated_segments(sg_call *call, sg_int_list *ss)
{
  const sg_version *version = sg_call_version(call);
  size_t most = version ? sg_version_count(version, SG_SEGMENT) : 0;

  if (!version || !(ss->at = sg_call_alloc(call, most * sizeof *ss->at)) ||
      !sg_each_row(call, SG_SEGMENT, list_segment, ss)) {
    return false;
  }
  ss->n = sg_sort_ids(ss->at, ss->n);
  return leave(call, version, SG_T, false, ss) &&
         leave(call, version, SG_P, true, ss);
}
