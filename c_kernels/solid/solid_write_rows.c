/* solid_write_rows.c -- a solid as rows of a segment. */
#include "doors/boolean.h"
#include "rows/append_rows.h"
#include "solid_out.h"
#include "solid_seams.h"

#include "engine/symbol.h"
#include "engine/term.h"

#include <stdlib.h>
#include <string.h>

/* What the kernel writes in place; origin/3 follows. */
enum { V, E, P, PLANE, T, FROM_V, FROM_P, RELATIONS };

static const sg_relation written[RELATIONS] = {
    SG_V, SG_E, SG_P, SG_PLANE, SG_T, SG_FROM_V, SG_FROM_P};

/* ---- room --------------------------------------------------------------- */

static bool
open_all(sg_call *call, sg_world *world, const sg_solid_rows *rows,
         sg_append append[RELATIONS])
{
  const sg_solid *solid = rows->solid;
  const size_t n[RELATIONS] = {[V] = rows->vertices,
                               [E] = rows->edge[solid->faces],
                               [P] = solid->faces,
                               [PLANE] = solid->faces,
                               [T] = solid->triangles,
                               [FROM_V] = rows->plain,
                               [FROM_P] = solid->faces + solid->parts};

  for (int k = 0; k < RELATIONS; k++) {
    if (!sg_append_open(&append[k], world, written[k], n[k])) {
      while (k-- > 0) {
        sg_append_close(&append[k]);
      }
      return sg_call_no_memory(call);
    }
  }
  return true;
}

static bool
make_lists(sg_call *call, const sg_solid_rows *rows, sg_append *p)
{
  int32_t length[SG_PAGE_ROWS];

  for (size_t k = 0; k < p->sheet.pages; k++) {
    const sg_sheet_page *page = &p->sheet.page[k];
    const uint32_t *edge = rows->edge + page->from;
    for (size_t i = 0; i < page->n; i++) {
      length[i] = (int32_t)(edge[i + 1] - edge[i]);
    }
    if (!sg_append_lists(p, k, 2, length)) {
      return sg_call_no_memory(call);
    }
    if (sg_cancelled(&call->cancel)) {
      return false;
    }
  }
  return true;
}

/* ---- origins ------------------------------------------------------------ */

enum { ITEM_WORDS = 8 };

/* The rows of a page: origin(S, v(V), Origin). */
typedef struct origins {
  size_t n;
  uint32_t word[SG_PAGE_ROWS][ITEM_WORDS];
  const uint32_t *item[SG_PAGE_ROWS], *origin[SG_PAGE_ROWS];
} origins;

static void
add_origin(origins *o, int32_t v, const uint32_t *origin)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_unary(&b, SG_SYMBOL_V, v);
  const uint32_t *item = sg_term_words(&b); /* short: it cannot fail */

  memcpy(o->word[o->n], item, sg_term_length(item) * sizeof *item);
  o->item[o->n] = o->word[o->n];
  o->origin[o->n++] = origin;
  sg_term_close(&b);
}

static const uint32_t *
origin_of(const sg_solid_rows *rows, size_t i)
{
  const sg_solid *solid = rows->solid;

  return solid->origin ? solid->origin[rows->vertex[i] - solid->plain] : NULL;
}

/* Page k of the sheet gets the origins of vertices *i and on. */
static bool
fill_origins(sg_call *call, const sg_solid_rows *rows, int32_t s, sg_append *a,
             size_t k, origins *o, size_t *i)
{
  const sg_sheet_page *page = &a->sheet.page[k];

  for (o->n = 0; o->n < page->n; (*i)++) {
    const uint32_t *origin = origin_of(rows, *i);

    if (origin) {
      page->column[0].i[o->n] = s;
      add_origin(o, (int32_t)*i + 1, origin);
    }
  }
  return sg_append_terms(a, k, 1, o->item) &&
                 sg_append_terms(a, k, 2, o->origin)
             ? !sg_cancelled(&call->cancel)
             : sg_call_no_memory(call);
}

/* Somebody may have said where a vertex came from that was not there. */
static bool
no_origins(sg_call *call, sg_world *world, int32_t s)
{
  const sg_version *version = sg_world_version(world);
  sg_segment_rows rows = {0};
  bool none = sg_rows_of_segment(call, version, SG_ORIGIN, s, &rows);
  size_t n = none ? rows.begin[1] : 0;

  for (size_t i = 0; none && i < n; i++) {
    const uint32_t *item =
        sg_version_value(version, SG_ORIGIN, rows.row[i], 1).term;

    none = sg_term_vertex(item) == 0 ||
           sg_call_status(call, SG_EXISTS, SG_ORIGIN, NULL);
  }
  sg_segment_rows_clear(&rows);
  sg_version_drop(version);
  return none;
}

/* As no vertex of s had an origin, these are all. */
static bool
add_origins(sg_call *call, sg_world *world, const sg_solid_rows *rows,
            int32_t s)
{
  size_t n = 0, next = rows->plain;
  origins *o = sg_call_alloc(call, sizeof *o);
  sg_append a;

  for (size_t i = rows->plain; i < rows->vertices; i++) {
    n += origin_of(rows, i) != NULL;
  }
  if (!o || !sg_append_open(&a, world, SG_ORIGIN, n)) {
    return sg_call_no_memory(call);
  }
  bool good = true;

  for (size_t k = 0; k < a.sheet.pages && good; k++) {
    good = fill_origins(call, rows, s, &a, k, o, &next);
  }
  good = good && (sg_append_commit(&a) || sg_call_no_memory(call));
  sg_append_close(&a);
  return good;
}

/* ---- the door ----------------------------------------------------------- */

static bool
commit_all(sg_call *call, sg_append append[RELATIONS], size_t planes,
           size_t sources)
{
  sg_append_shorten(&append[PLANE], planes);
  sg_append_shorten(&append[FROM_P], sources);
  for (int k = 0; k < RELATIONS; k++) {
    append[k].sheet.ascends = true;
    if (!sg_append_commit(&append[k])) {
      return sg_call_no_memory(call);
    }
  }
  return true;
}

static bool
write_rows(sg_call *call, sg_world *world, const sg_solid_rows *rows, int32_t s,
           sg_pool *pool)
{
  sg_append a[RELATIONS];
  size_t planes, sources;

  if (!open_all(call, world, rows, a)) {
    return false;
  }
  const sg_solid_sheets out = {&a[V].sheet,     &a[E].sheet, &a[P].sheet,
                               &a[PLANE].sheet, &a[T].sheet, &a[FROM_V].sheet,
                               &a[FROM_P].sheet};
  bool good = make_lists(call, rows, &a[P]) &&
              (sg_solid_rows_write(rows, s, pool, &call->cancel, &out, &planes,
                                   &sources) ||
               sg_call_ended(call)) &&
              commit_all(call, a, planes, sources) &&
              add_origins(call, world, rows, s);

  for (int k = 0; k < RELATIONS; k++) {
    sg_append_close(&a[k]);
  }
  return good;
}

/* Faces end where others do; and what lies in the middle of them. */
static bool
make_seams(sg_call *call, sg_solid_rows *rows, sg_point_loop_fact_list *loops)
{
  sg_face_point *point = NULL;
  size_t n = 0;
  bool good = (sg_solid_rows_seams(rows, &call->cancel) &&
               sg_solid_rows_points(rows, &call->cancel, &point, &n)) ||
              sg_call_ended(call);

  for (size_t i = 0; good && i < n; i++) {
    good = sg_point_loop_fact_list_add(
        call, loops, (sg_point_loop_fact){point[i].v, (int32_t)point[i].f + 1});
  }
  free(point);
  return good;
}

/* In a world that is claimed. `loops`: of cells, or null. */
static bool
write_solid(sg_call *call, sg_world *world, const sg_solid *solid, int32_t s,
            sg_point_loop_fact_list *loops)
{
  sg_pool *pool = sg_call_pool(call);
  sg_solid_rows rows;

  if (!pool) {
    return false;
  }
  bool good = sg_solid_rows_make(solid, pool, &call->cancel, &rows) ||
              sg_call_ended(call);

  good = good && (!loops || make_seams(call, &rows, loops)) &&
         write_rows(call, world, &rows, s, pool);
  sg_solid_rows_clear(&rows);
  return good;
}

static bool
write_to(sg_call *call, const sg_solid *solid, int32_t s,
         sg_point_loop_fact_list *loops)
{
  sg_world *world = sg_call_claim(call);

  if (!world) {
    return false;
  }
  bool good = sg_segment_is_empty(call, world, s) &&
              no_origins(call, world, s) &&
              write_solid(call, world, solid, s, loops);

  sg_world_release(world);
  return good;
}

bool
sg_door_solid_write(sg_call *call, sg_solid *solid, int32_t s)
{
  return write_to(call, solid, s, NULL);
}

bool
sg_door_solid_write_cells(sg_call *call, sg_solid *solid, int32_t s,
                          sg_point_loop_fact_list *loops)
{
  return write_to(call, solid, s, loops);
}
