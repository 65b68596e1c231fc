/* shading_rows.c -- scenes from terms, and their lines. */
#include "doors/shading.h"

#include "face_look_rows.h"
#include "shading_private.h"
#include "shading_segment_rows.h"
#include "solid/expression_node_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Dots: wider pictures have no 1/256 in an int32_t. */
#define WIDEST 4194304

static bool
ended(sg_call *call, sg_shading_end end, int32_t number)
{
  switch (end) {
  case SG_SHADING_GOOD:
    return true;
  case SG_SHADING_BEHIND_EYE:
    return sg_call_geometry(call, "leaf_behind_eye", &number, 1);
  case SG_SHADING_NO_MEMORY:
    return sg_call_no_memory(call);
  case SG_SHADING_STOPPED:
    break;
  }
  return sg_call_ended(call);
}

/* ---- leaves ---- */

/* Corners by their places in a list of points; SG_NO_CORNER: not yet. */
typedef struct corners {
  const sg_point_list *points;
  uint32_t *corner; /* [points] */
} corners;

static bool
read_corner(sg_call *call, sg_shading *scene, int32_t number, corners *all,
            size_t at, uint32_t *out)
{
  if (at > all->points->n) {
    return sg_call_domain(call, "shading_point", 2);
  }
  uint32_t *corner = &all->corner[at - 1];
  bool good =
      *corner != SG_NO_CORNER ||
      ended(call,
            sg_shading_add_corner(scene, all->points->at[at - 1].at, corner),
            number);
  *out = *corner;
  return good;
}

/* The corners of a polygon, loop after loop. */
static bool
read_polygon(sg_call *call, sg_shading *scene, int32_t number, corners *all,
             const sg_shading_polygon_fact *fact)
{
  size_t loops = fact->loops.n, n = 0, k = 0;
  size_t *count = sg_call_alloc(call, (loops + 1) * sizeof *count);

  for (size_t i = 0; count && i < loops; i++) {
    n += count[i] = fact->loops.at[i].n;
  }
  uint32_t *p = count ? sg_call_alloc(call, (n + 1) * sizeof *p) : NULL;
  for (size_t i = 0; p && i < loops; i++) {
    for (size_t j = 0; j < count[i]; j++) {
      if (!read_corner(call, scene, number, all,
                       (size_t)fact->loops.at[i].at[j], &p[k++])) {
        return false;
      }
    }
  }
  return p &&
         ended(call, sg_shading_add_polygon(scene, fact->face, p, count, loops),
               number);
}

/* Polygons, and the surfaces that they stand for. */
static bool
read_flat(sg_call *call, sg_shading *scene, const sg_shading_leaf_fact *fact)
{
  const sg_smooth_surface_list *surfaces = &fact->flat.surfaces;
  const sg_point_list *points = &fact->flat.points;
  uint32_t *known = sg_call_alloc(call, (surfaces->n + 1) * sizeof *known);
  corners all = {points,
                 sg_call_alloc(call, (points->n + 1) * sizeof *all.corner)};
  bool good = known && all.corner;

  for (size_t i = 0; good && i < points->n; i++) {
    all.corner[i] = SG_NO_CORNER;
  }

  for (size_t i = 0; good && i < surfaces->n; i++) {
    const sg_smooth_surface *said = &surfaces->at[i];
    size_t rows = (size_t)sg_known_surface_rows(said->kind);

    if (said->frame.n != 3 * rows) {
      return sg_call_domain(call, "shading_surface", 2);
    }
    known[i + 1] = sg_shading_add_known(scene, said->kind,
                                        (const double(*)[3])said->frame.at,
                                        said->a, said->b);
    good = known[i + 1] > 0 || sg_call_no_memory(call);
  }
  for (size_t i = 0; good && i < fact->flat.polygons.n; i++) {
    const sg_shading_polygon_fact *polygon = &fact->flat.polygons.at[i];

    if (polygon->surface > surfaces->n) {
      return sg_call_domain(call, "shading_surface", 2);
    }
    known[0] = 0;
    sg_shading_stand_for(scene, known[polygon->surface]);
    good = read_polygon(call, scene, fact->flat.number, &all, polygon);
  }
  sg_shading_stand_for(scene, 0);
  return good;
}

static bool
read_piece(sg_call *call, sg_shading *scene, int32_t number,
           const sg_shading_piece_fact *fact)
{
  sg_shading_piece piece = {.sphere = fact->kind == SG_KNOWN_SPHERE,
                            .k = fact->k,
                            .low = fact->low,
                            .high = fact->high,
                            .low_face = fact->low_face,
                            .high_face = fact->high_face,
                            .face = fact->face};

  if (fact->frame.n != 12 ||
      (!piece.sphere && fact->kind != SG_KNOWN_TAPERED)) {
    return sg_call_domain(call, "shading_piece", 2);
  }
  memcpy(piece.frame, fact->frame.at, sizeof piece.frame);
  return ended(call, sg_shading_add_piece(scene, &piece), number);
}

static bool
read_ring(sg_call *call, sg_shading *scene, const sg_shading_leaf_fact *fact)
{
  sg_shading_ring ring = {.k = fact->ring.k, .face = fact->ring.face};

  if (fact->ring.frame.n != 12 || !(ring.k > 0 && ring.k < 1)) {
    return sg_call_domain(call, "shading_ring", 2);
  }
  memcpy(ring.frame, fact->ring.frame.at, sizeof ring.frame);
  return ended(call, sg_shading_add_ring(scene, &ring), fact->ring.number);
}

static bool
read_net(sg_call *call, sg_shading *scene, const sg_shading_leaf_fact *fact)
{
  const sg_shading_patch_fact_list *facts = &fact->net.patches;
  sg_shading_patch *patch = sg_call_alloc(call, (facts->n + 1) * sizeof *patch);

  for (size_t i = 0; patch && i < facts->n; i++) {
    if (facts->at[i].control.n != 48) {
      return sg_call_domain(call, "shading_patch", 2);
    }
    patch[i].face = facts->at[i].face;
    memcpy(patch[i].control, facts->at[i].control.at, sizeof patch[i].control);
  }
  return patch && ended(call, sg_shading_add_net(scene, patch, facts->n),
                        fact->net.number);
}

static int32_t
number_of(const sg_shading_leaf_fact *fact)
{
  switch (fact->is) {
  case SG_SHADING_LEAF_FACT_FLAT:
    return fact->flat.number;
  case SG_SHADING_LEAF_FACT_ROUND:
    return fact->round.number;
  case SG_SHADING_LEAF_FACT_RING:
    return fact->ring.number;
  case SG_SHADING_LEAF_FACT_NET:
    return fact->net.number;
  case SG_SHADING_LEAF_FACT_ROWS:
    return fact->rows.number;
  }
  return 0;
}

static bool
read_faces(sg_call *call, sg_shading *scene, const sg_shading_leaf_fact *fact)
{
  int32_t number = number_of(fact);
  bool good = true;

  switch (fact->is) {
  case SG_SHADING_LEAF_FACT_FLAT:
    return read_flat(call, scene, fact);
  case SG_SHADING_LEAF_FACT_ROUND:
    for (size_t i = 0; good && i < fact->round.pieces.n; i++) {
      good = read_piece(call, scene, number, &fact->round.pieces.at[i]);
    }
    return good;
  case SG_SHADING_LEAF_FACT_RING:
    return read_ring(call, scene, fact);
  case SG_SHADING_LEAF_FACT_NET:
    return read_net(call, scene, fact);
  case SG_SHADING_LEAF_FACT_ROWS:
    return fact->rows.map.n == 12
               ? ended(call,
                       sg_shading_read_segment(call, scene, fact->rows.s,
                                               fact->rows.map.at),
                       number)
               : sg_call_domain(call, "shading_map", 2);
  }
  return false;
}

static bool
read_leaf(sg_call *call, sg_shading *scene, const sg_shading_leaf_fact *fact)
{
  return (sg_shading_add_leaf(scene, number_of(fact)) != UINT32_MAX ||
          sg_call_no_memory(call)) &&
         read_faces(call, scene, fact) &&
         (!sg_cancelled(&call->cancel) || sg_call_ended(call));
}

/* ---- roots ---- */

static size_t
add_node(void *to, size_t parent, sg_operation operation, int32_t of)
{
  return sg_shading_add_node(to, parent, operation,
                             operation == SG_LEAF ? (uint32_t)(of - 1) : 0);
}

static bool
read_root(sg_call *call, sg_shading *scene, size_t leaves,
          const sg_shading_root_fact *fact)
{
  const sg_expression_reader reader = {.argument = 3,
                                       .leaf = "shading_leaf",
                                       .leaves = (int32_t)leaves,
                                       .add = add_node,
                                       .to = scene};

  return (sg_shading_add_root(scene, fact->s) || sg_call_no_memory(call)) &&
         sg_expression_read(call, &reader, &fact->nodes);
}

/* ---- scenes ---- */

static bool
read_leaves(sg_call *call, const sg_shading_frame_fact *fact, bool box,
            const sg_shading_leaf_fact_list *leaves, sg_shading **scene)
{
  sg_shading_frame frame = {.box = box,
                            .width = fact->width,
                            .height = fact->height,
                            .tolerance = fact->tolerance};

  if (fact->matrix.n != 16 || fact->width > WIDEST || fact->height > WIDEST ||
      !(fact->tolerance >= 0)) {
    return sg_call_domain(call, "shading_frame", 1);
  }
  memcpy(frame.matrix, fact->matrix.at, sizeof frame.matrix);
  *scene = sg_shading_open(&frame);
  if (!*scene) {
    return sg_call_no_memory(call);
  }
  for (size_t i = 0; i < leaves->n; i++) {
    if (!read_leaf(call, *scene, &leaves->at[i])) {
      return false;
    }
  }
  return true;
}

bool
sg_door_shading_open(sg_call *call, const sg_shading_frame_fact *frame,
                     const sg_shading_leaf_fact_list *leaves,
                     const sg_shading_root_fact_list *roots, sg_shading **out)
{
  sg_shading *scene = NULL;
  bool good = read_leaves(call, frame, false, leaves, &scene);

  for (size_t i = 0; good && i < roots->n; i++) {
    good = read_root(call, scene, leaves->n, &roots->at[i]);
  }
  good = good && ended(call, sg_shading_seal(scene, &call->cancel), 0);
  if (!good) {
    sg_shading_close(scene);
    return false;
  }
  *out = scene;
  return true;
}

bool
sg_door_shading_box(sg_call *call, const sg_shading_frame_fact *frame,
                    const sg_shading_leaf_fact_list *leaves,
                    sg_shading_box_fact *box)
{
  sg_shading *scene = NULL;
  double low[3], high[3];
  bool good = read_leaves(call, frame, true, leaves, &scene) &&
              sg_shading_box(scene, low, high);

  sg_shading_close(scene);
  if (good) {
    *box = (sg_shading_box_fact){.x1 = low[0],
                                 .y1 = low[1],
                                 .z1 = low[2],
                                 .x2 = high[0],
                                 .y2 = high[1],
                                 .z2 = high[2]};
  }
  return good;
}

/* ---- lines ---- */

static void
close_work(void *work)
{
  sg_shading_work_close(work);
}

/* Null: refused. */
static sg_shading_work *
open_work(sg_call *call, const sg_shading *scene, double y,
          const sg_opacities *opacities)
{
  if (!(y >= 0 && y < sg_shading_frame_of(scene)->height)) {
    sg_call_domain(call, "scan_line", 2);
    return NULL;
  }
  sg_shading_work *work = sg_shading_work_open(scene, opacities);
  if (!work) {
    sg_call_no_memory(call);
    return NULL;
  }
  return sg_call_hold(call, work, close_work) ? work : NULL;
}

bool
sg_door_shading_spans(sg_call *call, sg_shading *scene, double y,
                      sg_shading_span_list *out)
{
  sg_shading_work *work = open_work(call, scene, y, NULL);
  sg_spans spans = {0};
  bool good = work && (sg_shading_line(scene, work, y, &spans) ||
                       sg_call_no_memory(call));

  if (good) {
    sg_spans_join(&spans);
  }
  for (size_t i = 0; good && i < spans.n; i++) {
    good = sg_shading_span_list_add(call, out, spans.span[i]);
  }
  free(spans.span);
  return good;
}

/* ---- layers ---- */

bool
sg_door_shading_layers(sg_call *call, sg_shading *scene, double y,
                       const sg_number_list *looks,
                       const sg_list_count_list *leaves,
                       sg_shading_layer_list *out)
{
  sg_opacities opacities = {0};
  bool clear;
  sg_shading_work *work =
      sg_opacities_read(call, looks, leaves, &opacities, &clear)
          ? open_work(call, scene, y, &opacities)
          : NULL;
  sg_spans spans = {0};
  bool good = work && (sg_shading_line(scene, work, y, &spans) ||
                       sg_call_no_memory(call));

  if (good) {
    sg_spans_join(&spans);
  }
  for (size_t i = 0; good && i < spans.n; i++) {
    const sg_span *s = &spans.span[i];
    good = sg_shading_layer_list_add(
        call, out,
        (sg_shading_layer){.x1 = s->x1,
                           .x2 = s->x2,
                           .root = s->root,
                           .leaf = s->leaf,
                           .face = s->face,
                           .part = s->part / (double)SG_OPAQUE});
  }
  free(spans.span);
  return good;
}

/* ---- points ---- */

bool
sg_door_shading_point(sg_call *call, sg_shading *scene, double x, double y,
                      sg_span *out, double *depth, sg_xyz *normal)
{
  sg_shading_work *work = open_work(call, scene, y, NULL);
  sg_spans spans = {0};
  bool found = false;

  if (!work) {
    return false;
  }
  if (!sg_shading_line(scene, work, y, &spans)) {
    free(spans.span);
    return sg_call_no_memory(call);
  }
  for (size_t i = 0; !found && i < spans.n; i++) {
    *out = spans.span[i];
    found = out->x1 <= x * 256.0 && x * 256.0 < out->x2;
  }
  free(spans.span);
  if (found) {
    sg_shading_point(scene, out, x, y, depth, normal->at);
  }
  return found;
}

bool
sg_door_shading_place(sg_call *call, sg_shading *scene, double x, double y,
                      double depth, sg_xyz *out)
{
  (void)call;
  sg_shading_place(scene, (const double[3]){x, y, depth}, out->at);
  return true;
}

bool
sg_door_shading_size(sg_call *call, sg_shading *scene, size_t *width,
                     size_t *height)
{
  (void)call;
  *width = (size_t)sg_shading_frame_of(scene)->width;
  *height = (size_t)sg_shading_frame_of(scene)->height;
  return true;
}

static sg_shading_slice
slice_fact(const sg_slice *s)
{
  sg_shading_slice out = {.leaf = (int32_t)s->leaf + 1,
                          .face = s->face,
                          .sense = s->sense,
                          .x1 = s->x1,
                          .x2 = s->x2};

  if (sg_slice_is_ring(s)) {
    out.depth.is = SG_SHADING_DEPTH_RING;
    out.depth.ring.x0 = s->line->x;
    out.depth.ring.z0 = s->line->z;
    out.depth.ring.size = s->line->size;
    out.depth.ring.low = s->e;
    out.depth.ring.high = s->f;
    out.depth.ring.roots = s->arc <= SG_ROOT_LAST ? 2 : 4;
    out.depth.ring.root =
        (size_t)s->arc -
        (s->arc <= SG_ROOT_LAST ? SG_ROOT_FIRST : SG_ROOT_NEAR_IN) + 1;
  } else if (s->arc == 0) {
    out.depth.is = SG_SHADING_DEPTH_LINE;
    out.depth.line.x0 = s->x0;
    out.depth.line.a = s->a;
    out.depth.line.b = s->b;
  } else {
    out.depth.is = SG_SHADING_DEPTH_ARC;
    out.depth.arc.sign = s->arc;
    out.depth.arc.x0 = s->x0;
    out.depth.arc.a = s->a;
    out.depth.arc.b = s->b;
    out.depth.arc.e = s->e;
    out.depth.arc.f = s->f;
    out.depth.arc.g = s->g;
  }
  return out;
}

bool
sg_door_shading_slices(sg_call *call, sg_shading *scene, double y,
                       sg_shading_slice_list *out)
{
  sg_shading_work *work = open_work(call, scene, y, NULL);

  if (!work || !(sg_slices_of_line(work, y) || sg_call_no_memory(call))) {
    return false;
  }
  for (size_t i = 0; i < work->slice.n; i++) {
    const sg_slice *s = &work->slice.item[i];
    sg_shading_slice fact = slice_fact(s);

    for (int k = 0; sg_slice_is_ring(s) && k < 18; k++) {
      if (!sg_number_list_add(call, &fact.depth.ring.forms,
                              s->line->form[k / 6][k % 6])) {
        return false;
      }
    }
    if (!sg_shading_slice_list_add(call, out, fact)) {
      return false;
    }
  }
  return true;
}
