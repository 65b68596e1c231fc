/* work_join_rows.c -- the scratch relation of one polygon: its edges, what
 * meets a segment, third vertices, triangles.
 */
#include "work_rows.h"

#include "delaunay.h"
#include "doors/work.h"
#include "triangulate.h"

#include <stdlib.h>

/* ---- edges -------------------------------------------------------------- */

static sg_work_edge_row
row_of(const sg_work *work, int32_t e)
{
  const sg_work_edge *edge = sg_work_get(work, e);

  return (sg_work_edge_row){.e = e,
                            .v1 = sg_work_id(work, edge->start),
                            .v2 = sg_work_id(work, edge->end),
                            .et = edge->et,
                            .label = edge->label};
}

/* The next edge that may fit; v1, v2: handles, SG_WORK_NONE: any. */
static int32_t
step(const sg_work *work, int32_t v1, int32_t v2, int32_t e)
{
  return v1 != SG_WORK_NONE   ? sg_work_leaving(work, v1, e)
         : v2 != SG_WORK_NONE ? sg_work_entering(work, v2, e)
                              : sg_work_next(work, e);
}

bool
sg_door_work_edge(sg_call *call, sg_work *work, const int32_t *e,
                  const int32_t *v1, const int32_t *v2, sg_work_edge_rows *rows)
{
  int32_t start = v1 ? sg_work_find(work, *v1) : SG_WORK_NONE;
  int32_t end = v2 ? sg_work_find(work, *v2) : SG_WORK_NONE;

  if (e) {
    return sg_work_get(work, *e) &&
           sg_work_edge_rows_add(call, rows, row_of(work, *e));
  }
  if ((v1 && start == SG_WORK_NONE) || (v2 && end == SG_WORK_NONE)) {
    return false;
  }
  for (int32_t i = v1 && v2 ? sg_work_pair(work, start, end)
                            : step(work, start, end, 0);
       i; i = step(work, start, end, i)) {
    if ((!v2 || sg_work_get(work, i)->end == end) &&
        !sg_work_edge_rows_add(call, rows, row_of(work, i))) {
      return false;
    }
  }
  return true;
}

bool
sg_door_work_oldest(sg_call *call, sg_work *work, int32_t *e, int32_t *v1,
                    int32_t *v2)
{
  (void)call;
  if (!(*e = sg_work_next(work, 0))) {
    return false;
  }
  sg_work_edge_row row = row_of(work, *e);

  *v1 = row.v1;
  *v2 = row.v2;
  return true;
}

/* ---- the joins ---------------------------------------------------------- */

static bool
add_inside(sg_call *call, unsigned inside, sg_meeting_end_list *out)
{
  for (int i = 0; inside >> i != 0; i++) {
    if (inside >> i & 1 && !sg_meeting_end_list_add(call, out, i)) {
      return false;
    }
  }
  return true;
}

bool
sg_door_work_meeting(sg_call *call, sg_work *work, int32_t v1, int32_t v2,
                     sg_work_meeting_rows *rows)
{
  sg_meetings met = {0};
  int32_t v[2];

  if (!sg_work_known_ends(call, work, v1, v2, 3, v)) {
    return false;
  }
  bool good =
      sg_work_meeting(work, v[0], v[1], &met) || sg_call_no_memory(call);

  for (size_t i = 0; good && i < met.n; i++) {
    sg_work_meeting_row row = {.e = met.item[i].edge, .how = met.item[i].how};

    good = add_inside(call, met.item[i].inside, &row.inside) &&
           sg_work_meeting_rows_add(call, rows, row);
  }
  sg_meetings_clear(&met);
  return good;
}

bool
sg_door_work_candidate(sg_call *call, sg_work *work, int32_t v1, int32_t v2,
                       size_t n, int32_t *v3)
{
  int32_t v[2], found;
  sg_candidates walk;

  if (!sg_work_known(call, work, v1, &v[0]) ||
      !sg_work_known(call, work, v2, &v[1])) {
    return false;
  }
  sg_candidates_open(&walk, work, v[0], v[1]);
  do {
    found = sg_candidates_next(&walk);
  } while (found != SG_WORK_NONE && n-- > 0);
  sg_candidates_close(&walk);
  if (found == SG_WORK_NONE) {
    return walk.no_memory ? sg_call_no_memory(call) : false;
  }
  *v3 = sg_work_id(work, found);
  return true;
}

/* ---- the fused kernels -------------------------------------------------- */

/* Triangles of handles, which are freed with the call, as those of ids. */
static bool
give_triangles(sg_call *call, const sg_work *work, const sg_triangles *found,
               sg_corners_list *out)
{
  for (size_t i = 0; i < 3 * found->n; i++) {
    int32_t *v = &found->item[i / 3].v[i % 3];

    *v = sg_work_id(work, *v);
  }
  *out = (sg_corners_list){found->item, found->n, 0};
  return sg_call_adopt(call, found->item);
}

bool
sg_door_work_triangulate(sg_call *call, sg_work *work,
                         sg_corners_list *triangles)
{
  sg_triangles found = {0};
  int32_t edge;
  sg_outcome end = sg_work_triangulate(work, &found, &edge, &call->cancel);

  if (end == SG_DONE || end == SG_STUCK) { /* the edges that are left tell */
    return give_triangles(call, work, &found, triangles);
  }
  free(found.item);
  return sg_call_ended(call);
}

static bool
get_edges(sg_call *call, const sg_work *work, const sg_id_pair_list *edges,
          int32_t (*out)[2])
{
  for (size_t i = 0; i < edges->n; i++) {
    if (!sg_work_known(call, work, edges->at[i].a, &out[i][0]) ||
        !sg_work_known(call, work, edges->at[i].b, &out[i][1])) {
      return false;
    }
  }
  return true;
}

static bool
get_triangles(sg_call *call, const sg_work *work,
              const sg_corners_list *triangles, sg_triangles *out)
{
  for (; out->n < triangles->n; out->n++) {
    for (int k = 0; k < 3; k++) {
      if (!sg_work_known(call, work, triangles->at[out->n].v[k],
                         &out->item[out->n].v[k])) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_door_work_thicken(sg_call *call, sg_work *work, const sg_id_pair_list *edges,
                     const sg_corners_list *triangles0,
                     sg_corners_list *triangles)
{
  int32_t(*edge)[2] = sg_call_alloc(call, edges->n * sizeof *edge);
  sg_triangles all = {.item = malloc((triangles0->n + 1) * sizeof *all.item)};

  if (!all.item) {
    return sg_call_no_memory(call);
  }
  if (edge && get_edges(call, work, edges, edge) &&
      get_triangles(call, work, triangles0, &all) &&
      (sg_triangles_thicken(work, (const int32_t(*)[2])edge, edges->n, 0, &all,
                            &call->cancel) == SG_DONE ||
       sg_call_ended(call))) {
    return give_triangles(call, work, &all, triangles);
  }
  free(all.item);
  return false;
}
