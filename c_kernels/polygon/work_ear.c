/* work_ear.c -- is an ear of a simple relation free? See work_private.h.
 *
 * Layer: kernel. A tree of the vertices that can be in one. Exact.
 */
#include "work_private.h"

#include <stdlib.h>

/* Why vertices tell all: in a simple relation an edge that meets the triangle,
 * but begins in none of its corners, cannot leave it again, for two of its
 * sides are edges; so an end of it is in the triangle. In an orderly one, of
 * the vertices in the triangle one farthest from the third side has no edge to
 * farther away, so the inside of the polygon goes more than half round it (or
 * goes half round it and more round another at the same distance): reflex. */

/* Of an orderly relation: v is no corner, a convex or a straight one. It will
 * not be reflex later, when triangles have been taken off. */
static bool
is_convex(const sg_work *work, int32_t v)
{
  int32_t in = work->vertex[v].first_in, out = work->vertex[v].first_out;

  if (!in || !out || work->edge[in].in_younger || work->edge[out].out_younger) {
    return !in && !out;
  }
  return sg_work_turn(work, work->edge[in].edge.start, v,
                      work->edge[out].edge.end) >= 0;
}

bool
sg_work_ends_ready(sg_work *work)
{
  sg_work_grid *ends = &work->ends;

  if (ends->open && ends->expected <= 2 * work->living + SG_WORK_FEW) {
    return true;
  }
  sg_work_grid_segment *segment = sg_work_segments(work);
  sg_work_grid_close(ends);
  sg_work_places_clear(work); /* they are others */
  bool done = segment && sg_work_grid_open(ends, SG_GRID_OF_ENDS, segment,
                                           work->living, sg_work_error(work));
  free(segment);
  for (int32_t v = 0; done && v < work->vertices; v++) {
    if (sg_work_has_edges(work, v)) {
      done = sg_work_grid_add_point(ends, v + 1, work->vertex[v].at);
    }
  }
  return done;
}

/* ---- tips --------------------------------------------------------------- */

void
sg_work_tips_clear(sg_work *work)
{
  sg_work_tree_close(&work->tips);
  work->tipped = 0;
}

sg_work_grid_segment
sg_work_side_of(const sg_work *work, int32_t v)
{
  const sg_work_vertex_row *row = &work->vertex[v];
  int32_t e = row->first_in ? row->first_in : row->first_out;
  const double *p = work->vertex[work->edge[e].edge.start].at;
  const double *q = work->vertex[work->edge[e].edge.end].at;

  return (sg_work_grid_segment){{p[0], p[1]}, {q[0], q[1]}};
}

/* The tree of all vertices that have edges, or of those that are not convex;
 * made anew when most of the edges are gone. False: no memory. */
static bool
tips_ready(sg_work *work)
{
  if (work->tipped > 0 && work->tipped <= 2 * work->living + SG_WORK_FEW) {
    return true;
  }
  size_t n = 0;
  int32_t *number = malloc(((size_t)work->vertices + 1) * sizeof *number);
  sg_work_box *box = malloc(((size_t)work->vertices + 1) * sizeof *box);
  sg_work_grid_segment *segment =
      malloc(((size_t)work->vertices + 1) * sizeof *segment);
  bool good = number && box && segment;

  sg_work_tips_clear(work);
  for (int32_t v = 0; good && v < work->vertices; v++) {
    if (work->orderly ? !is_convex(work, v) : sg_work_has_edges(work, v)) {
      const double *at = work->vertex[v].at;

      box[n] = (sg_work_box){{at[0], at[1]}, {at[0], at[1]}, {0}, {0}};
      segment[n] = sg_work_side_of(work, v);
      number[n++] = v + 1;
    }
  }
  if (!good) {
    free(number);
    free(box);
    free(segment);
    return false;
  }
  work->tipped = work->living;
  return sg_work_tree_open(&work->tips, number, box, segment, n, false);
}

/* v is in the closed triangle. */
static bool
covers(const sg_work *work, const int32_t corner[3], int32_t v)
{
  return sg_work_turn(work, corner[0], corner[1], v) >= 0 &&
         sg_work_turn(work, corner[1], corner[2], v) >= 0 &&
         sg_work_turn(work, corner[2], corner[0], v) >= 0;
}

/* From corner i the direction to v goes into the closed triangle. */
static bool
goes_in(const sg_work *work, const int32_t corner[3], int i, int32_t v)
{
  return v != corner[(i + 1) % 3] && v != corner[(i + 2) % 3] &&
         sg_work_turn(work, corner[i], corner[(i + 1) % 3], v) >= 0 &&
         sg_work_turn(work, corner[(i + 2) % 3], corner[i], v) >= 0;
}

static bool
edge_goes_in(sg_work *work, const int32_t corner[3], int i)
{
  for (int32_t e = 0; (e = sg_work_leaving(work, corner[i], e)) != 0 &&
                      sg_work_step(work, 1);) {
    work->looked++;
    if (goes_in(work, corner, i, work->edge[e].edge.end)) {
      return true;
    }
  }
  for (int32_t e = 0; (e = sg_work_entering(work, corner[i], e)) != 0 &&
                      sg_work_step(work, 1);) {
    work->looked++;
    if (goes_in(work, corner, i, work->edge[e].edge.start)) {
      return true;
    }
  }
  return false;
}

typedef struct occupying {
  const sg_work *work;
  const int32_t *corner;
  sg_work_corners at;
} occupying;

static bool
is_apart(const void *data, const sg_work_box *box)
{
  const occupying *o = data;

  return !sg_work_step(o->work, 1) || sg_work_box_apart(&o->at, box);
}

static bool
is_slab_apart(const void *data, const sg_work_slab *slab)
{
  const occupying *o = data;

  return sg_work_slab_apart(&o->at, slab);
}

static bool
is_in(void *data, int32_t number)
{
  const occupying *o = data;
  const int32_t *corner = o->corner;
  int32_t v = number - 1;

  return sg_work_has_edges(o->work, v) && v != corner[0] && v != corner[1] &&
         v != corner[2] && covers(o->work, corner, v);
}

bool
sg_work_occupied(sg_work *work, const int32_t corner[3], bool *no_memory)
{
  for (int i = 0; i < 3; i++) {
    if (edge_goes_in(work, corner, i)) {
      return true;
    }
  }
  if (!tips_ready(work)) {
    *no_memory = true;
    return true;
  }
  occupying o = {work, corner, sg_work_corners_of(work, corner)};

  return sg_work_tree_go(&(sg_work_tree_walk){.tree = &work->tips,
                                              .skips = is_apart,
                                              .skips_slab = is_slab_apart,
                                              .ends = is_in,
                                              .data = &o}) != 0;
}
