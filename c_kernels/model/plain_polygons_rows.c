/* plain_polygons_rows.c -- polygons of a model file: lists of edges, or of
 * vertices, as rules/polygon/polygon_list.pl says.
 *
 * Layer: rows.
 */
#include "plain_facts_rows.h"
#include "vertex_list.h"

#include "engine/search.h"
#include "rows/by_segment.h"
#include "rows/sort.h"

#include <stdlib.h>
#include <string.h>

/* Edges that are made, as columns of e/5. */
typedef struct new_edges {
  size_t n, room;
  int32_t *column[5];
} new_edges;

typedef struct polygons {
  sg_call *call;
  sg_world *world;
  const sg_version *version;
  const sg_plain_rows *rows;
  sg_list_edge *scratch; /* of one polygon, [longest + 1] */
  int32_t *half;         /* the same */
  new_edges made;
  int32_t *next; /* [segments]: the next edge of a list of vertices, 0: it has
                    edges of its own */
  sg_int_list segment;
} polygons;

/* ---- one polygon -------------------------------------------------------- */

/* Sorts the edges. */
static bool
is_sound(sg_list_edge *e, size_t n, int32_t *half)
{
  int32_t what[2];

  return sg_border_find_fault(e, n, half, what) == SG_BORDER_GOOD;
}

static bool
take_edges(const polygons *p, int32_t s, const int32_t *list, sg_list_edge *out)
{
  for (int32_t i = 0; i < list[0]; i++) {
    sg_row row = sg_version_find(
        p->version, SG_E,
        (sg_value[SG_MAX_COLUMNS]){{.i = s}, {.i = list[1 + i]}});

    if (row == SG_NO_ROW) {
      return false;
    }
    out[i].from = sg_version_value(p->version, SG_E, row, 2).i;
    out[i].to = sg_version_value(p->version, SG_E, row, 3).i;
  }
  return true;
}

/* ---- edges -------------------------------------------------------------- */

static bool
make_room(polygons *p, size_t more)
{
  new_edges *e = &p->made;

  if (e->n + more > e->room) {
    e->room = 2 * e->room + more + 1024;
    for (int c = 0; c < 5; c++) {
      e->column[c] = sg_call_realloc(p->call, e->column[c],
                                     e->room * sizeof *e->column[c]);
      if (!e->column[c]) {
        return false;
      }
    }
  }
  return true;
}

/* The list of edges that were made. */
static const int32_t *
make_edges(polygons *p, int32_t s, int32_t *next, size_t n)
{
  int32_t *list = sg_call_alloc(p->call, (n + 1) * sizeof *list);
  new_edges *made = &p->made;

  if (!list || !make_room(p, n)) {
    return NULL;
  }
  list[0] = (int32_t)n;
  for (size_t i = 0; i < n; i++) {
    const int32_t row[5] = {s, *next, p->scratch[i].from, p->scratch[i].to, 1};

    for (int c = 0; c < 5; c++) {
      made->column[c][made->n] = row[c];
    }
    made->n++;
    list[i + 1] = (*next)++;
  }
  return list;
}

/* Of all segments with polygons: the first edge to be made, if it has none. */
static bool
find_segments(polygons *p)
{
  for (size_t i = 0; i < p->rows->n; i++) {
    int32_t s = p->rows->column[0].i[i];

    if ((p->segment.n == 0 || p->segment.at[p->segment.n - 1] != s) &&
        !sg_int_list_add(p->call, &p->segment, s)) {
      return false;
    }
  }
  p->segment.n = sg_sort_ids(p->segment.at, p->segment.n);
  p->next = sg_call_alloc(p->call, (p->segment.n + 1) * sizeof *p->next);
  for (size_t i = 0; p->next && i < p->segment.n; i++) {
    p->next[i] = !sg_world_has_of(p->world, SG_E, p->segment.at[i]);
  }
  return p->next != NULL;
}

static bool
ready(polygons *p, size_t i, const int32_t **list)
{
  int32_t s = p->rows->column[0].i[i];
  size_t n = (size_t)list[0][0], edges = n;
  int32_t *next = &p->next[sg_find_id(p->segment.at, p->segment.n, s)];

  if (*next == 0) {
    return take_edges(p, s, *list, p->scratch) &&
           is_sound(p->scratch, n, p->half);
  }
  if (!sg_vertex_list_edges(*list + 1, n, p->scratch, &edges)) {
    return false;
  }
  *list = make_edges(p, s, next, edges);
  return *list && is_sound(p->scratch, edges, p->half);
}

bool
sg_plain_polygons_ready(sg_call *call, sg_world *world,
                        const sg_plain_facts *facts, const int32_t **list)
{
  polygons p = {.call = call,
                .world = world,
                .version = sg_call_version(call),
                .rows = &facts->of[SG_P]};
  size_t longest = 0;
  sg_fault fault;

  for (size_t i = 0; i < p.rows->n; i++) {
    longest = (size_t)list[i][0] > longest ? (size_t)list[i][0] : longest;
  }
  p.scratch = sg_call_alloc(call, (longest + 1) * sizeof *p.scratch);
  p.half = sg_call_alloc(call, (longest + 1) * sizeof *p.half);
  bool good = p.version && p.scratch && p.half && find_segments(&p);

  for (size_t i = 0; good && i < p.rows->n; i++) {
    good = !sg_cancel_every(&call->cancel, i) && ready(&p, i, &list[i]);
  }
  return good &&
         (p.made.n == 0 || sg_world_add_many(world, SG_E, p.made.n,
                                             (const void *const *)p.made.column,
                                             &fault) == SG_OK);
}
