/* shading_rows_test.c -- a scene through the functions of the doors, without
 * Prolog: a cube of rows, a ball, a ring; and what is refused.
 *
 * covers: shading_segment_rows, expression_node_rows, face_look_rows,
 * owner_rows
 */
#include "doors/shading.h"

#include "shading/scan.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <math.h>
#include <string.h>

/* From above, 10 dots to a unit, the origin at (50, 50). */
static double above[16] = {10, 0, 0,   50, 0, -10, 0, 50,
                           0,  0, -10, 0,  0, 0,   0, 1};
static double here[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
static double round_frame[12] = {3, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

static const sg_shading_frame_fact frame = {
    .matrix = {above, 16, 0}, .width = 100, .height = 100, .tolerance = 1e-9};

static sg_shading_leaf_fact
rows_leaf(int32_t number, size_t numbers)
{
  sg_shading_leaf_fact leaf = {.is = SG_SHADING_LEAF_FACT_ROWS};

  leaf.rows.number = number;
  leaf.rows.s = 1;
  leaf.rows.map = (sg_number_list){here, numbers, 0};
  return leaf;
}

static sg_shading_leaf_fact
ring_leaf(int32_t number, double k)
{
  sg_shading_leaf_fact leaf = {.is = SG_SHADING_LEAF_FACT_RING};

  leaf.ring.number = number;
  leaf.ring.frame = (sg_number_list){round_frame, 12, 0};
  leaf.ring.k = k;
  leaf.ring.face = 1;
  return leaf;
}

/* A scene of the leaves under one union; null: refused. */
static sg_shading *
open_scene(sg_shading_leaf_fact *leaf, size_t n, int32_t last)
{
  sg_expression_node_fact node[4] = {{SG_UNION, (int32_t)n}};
  sg_shading *scene = NULL;

  for (size_t i = 0; i < n; i++) {
    node[1 + i] = (sg_expression_node_fact){SG_LEAF, (int32_t)i + 1};
  }
  node[n].of = last;
  sg_shading_root_fact root = {.s = 7, .nodes = {node, n + 1, 0}};
  return sg_door_shading_open(&call, &frame,
                              &(sg_shading_leaf_fact_list){leaf, n, 0},
                              &(sg_shading_root_fact_list){&root, 1, 0}, &scene)
             ? scene
             : NULL;
}

static void
located(sg_shading *scene)
{
  size_t width = 0, height = 0;
  sg_xyz place = {{0, 0, 0}};

  CHECK_DOOR("a place of the model",
             sg_door_shading_place(&call, scene, 55, 45, -10, &place) &&
                 fabs(place.at[0] - 0.5) < 1e-12 &&
                 fabs(place.at[1] - 0.5) < 1e-12 &&
                 fabs(place.at[2] - 1) < 1e-12);
  CHECK_DOOR("a size", sg_door_shading_size(&call, scene, &width, &height) &&
                           width == 100 && height == 100);
}

static void
seen(void)
{
  sg_shading_leaf_fact leaf[2] = {rows_leaf(1, 12), ring_leaf(2, 0.25)};
  sg_shading *scene = NULL;
  sg_shading_span_list spans = {0};
  sg_shading_slice_list slices = {0};
  sg_shading_box_fact box = {0};
  sg_span span;
  sg_xyz normal;
  double depth;

  CHECK_DOOR("a scene opens", (scene = open_scene(leaf, 2, 2)) != NULL);
  CHECK_DOOR("spans", sg_door_shading_spans(&call, scene, 45, &spans));
  CHECK("of the cube, and twice of the ring",
        spans.n == 3 && spans.at[0].x1 == 50 * 256 &&
            spans.at[0].x2 == 60 * 256 && spans.at[0].root == 7 &&
            spans.at[0].face == 2 && spans.at[1].leaf == 2);
  CHECK("as far as circles go",
        spans.n == 3 && spans.at[1].x1 == 17547 && spans.at[1].x2 == 19049 &&
            spans.at[2].x1 == 21911 && spans.at[2].x2 == 23413);
  CHECK_DOOR("slices", sg_door_shading_slices(&call, scene, 45, &slices) &&
                           slices.n >= 6);
  CHECK_DOOR("a point", sg_door_shading_point(&call, scene, 55, 45, &span,
                                              &depth, &normal) &&
                            span.leaf == 1 && depth == -10 &&
                            normal.at[2] == 1);
  CHECK("none",
        !sg_door_shading_point(&call, scene, 5, 45, &span, &depth, &normal) &&
            call.refusal.how == SG_REFUSED_NOTHING);
  CHECK_DOOR("a box", sg_door_shading_box(
                          &call, &frame,
                          &(sg_shading_leaf_fact_list){leaf, 1, 0}, &box) &&
                          box.x1 == 50 && box.y1 == 40 && box.x2 == 60 &&
                          box.y2 == 50 && box.z1 == -10 && box.z2 == 0);
  located(scene);
  sg_shading_close(scene);
}

/* A cube below another one is seen through it, if that one may not hide it. */
static void
seen_through(void)
{
  static double below[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -2};
  sg_shading_leaf_fact leaf[2] = {rows_leaf(1, 12), rows_leaf(2, 12)};
  sg_expression_node_fact node[2] = {{SG_LEAF, 1}, {SG_LEAF, 2}};
  sg_shading_root_fact root[2] = {{.s = 7, .nodes = {&node[0], 1, 0}},
                                  {.s = 8, .nodes = {&node[1], 1, 0}}};
  sg_shading_pair pair[2] = {{.front = 8, .behind = 7},
                             {.front = 7, .behind = 8}};
  sg_shading_span_list before = {0}, same = {0}, after = {0};
  sg_shading *scene = NULL;

  leaf[1].rows.map.at = below;
  CHECK_DOOR("two roots",
             sg_door_shading_open(
                 &call, &frame, &(sg_shading_leaf_fact_list){leaf, 2, 0},
                 &(sg_shading_root_fact_list){root, 2, 0}, &scene));
  CHECK_DOOR("the upper one is seen",
             sg_door_shading_spans(&call, scene, 45, &before) &&
                 before.n == 1 && before.at[0].root == 7);
  CHECK_DOOR("also if the lower one may not hide it",
             sg_door_shading_let_through(
                 &call, scene, &(sg_shading_pair_list){&pair[0], 1, 0}) &&
                 sg_door_shading_spans(&call, scene, 45, &same) &&
                 same.n == 1 && same.at[0].root == 7);
  CHECK_DOOR("the lower one is",
             sg_door_shading_let_through(
                 &call, scene, &(sg_shading_pair_list){&pair[1], 1, 0}) &&
                 sg_door_shading_spans(&call, scene, 45, &after) &&
                 after.n == 1 && after.at[0].root == 8 &&
                 after.at[0].x1 == before.at[0].x1 &&
                 after.at[0].x2 == before.at[0].x2);
  sg_shading_close(scene);
}

/* The cube of glass on one line: its front, half as much of its back. */
static void
layers(void)
{
  sg_shading_leaf_fact leaf = rows_leaf(1, 12);
  sg_shading *scene = NULL;
  double half[] = {0.5};
  size_t place = 0;
  sg_count_list own = {&place, 1, 0};
  const sg_number_list looks = {half, 1, 0};
  const sg_list_count_list leaves = {&own, 1, 0};
  sg_shading_layer_list out = {0};

  CHECK_DOOR("a scene opens", (scene = open_scene(&leaf, 1, 1)) != NULL);
  CHECK("two layers",
        scene &&
            sg_door_shading_layers(&call, scene, 45, &looks, &leaves, &out) &&
            out.n == 2 && out.at[0].part == 0.5 && out.at[1].part == 0.25 &&
            out.at[0].face == 2 && out.at[1].face != 2 &&
            out.at[0].x1 == 50 * 256 && out.at[1].x2 == 60 * 256);
  half[0] = -1;
  CHECK("less than clear",
        !sg_door_shading_layers(&call, scene, 45, &looks, &leaves, &out) &&
            is_domain("opacity", 3));
  half[0] = 1;
  place = 1;
  CHECK("no such look",
        !sg_door_shading_layers(&call, scene, 45, &looks, &leaves, &out) &&
            is_domain("shading_look", 4));
  sg_shading_close(scene);
}

/* PFM: the cube's dots, from a stream that counts. */
static bool
count_bytes(void *data, const char *bytes, size_t n)
{
  (void)bytes;
  *(size_t *)data += n;
  return true;
}

static void
buffers(void)
{
  sg_shading_leaf_fact leaf = rows_leaf(1, 12);
  sg_shading *scene = NULL;
  double up[] = {0, 0, 1, 0};
  size_t depths = 0, normals = 0;
  const sg_output to_depths = {count_bytes, &depths};
  const sg_output to_normals = {count_bytes, &normals};

  CHECK_DOOR("a scene opens", (scene = open_scene(&leaf, 1, 1)) != NULL);
  CHECK("depths",
        scene &&
            sg_door_shading_depth_pfm(&call, scene, &(sg_number_list){up, 4, 0},
                                      &to_depths) &&
            depths == strlen("Pf\n100 100\n-1.0\n") + 40000);
  CHECK("normals", scene &&
                       sg_door_shading_normal_pfm(&call, scene, &to_normals) &&
                       normals == strlen("PF\n100 100\n-1.0\n") + 120000);
  CHECK("three numbers are no plane",
        scene &&
            !sg_door_shading_depth_pfm(
                &call, scene, &(sg_number_list){up, 3, 0}, &to_depths) &&
            is_domain("plane", 2));
  sg_shading_close(scene);
}

static size_t
span_rows(void)
{
  const sg_version *version = sg_world_version(call.world);
  size_t n = 0;
  sg_view view;

  if (sg_version_view(version, SG_SPAN, &view)) {
    for (size_t page = 0; page < view.pages; page++) {
      for (unsigned i = sg_live_next(view.live[page], 0); i < SG_PAGE_ROWS;
           i = sg_live_next(view.live[page], i + 1)) {
        n += view.column[4].page[page].i[i] == 7 &&
             view.column[5].page[page].i[i] == 9;
      }
    }
    sg_view_clear(&view);
  }
  sg_version_drop(version);
  return n;
}

/* Spans as rows of span/7; they are replaced. */
static void
scans(void)
{
  sg_shading_leaf_fact leaf = rows_leaf(1, 12);
  sg_shading *scene = NULL;
  double opaque[] = {1};
  size_t zero[] = {0};
  sg_count_list places = {zero, 1, 0};
  const sg_number_list looks = {opaque, 1, 0};
  const sg_list_count_list leaves = {&places, 1, 0};
  int32_t segment[] = {9};
  sg_scan *scan = NULL;
  size_t n = 0;

  CHECK_DOOR("a scene opens", (scene = open_scene(&leaf, 1, 1)) != NULL);
  CHECK_DOOR("scanned", scene && sg_door_shading_scan(&call, scene, 2, &looks,
                                                      &leaves, &scan));
  for (size_t i = 0; i < scan->n; i++) {
    n += scan->line[i].n;
  }
  for (int k = 0; k < 2; k++) {
    CHECK("rows", n == 20 && sg_door_fill_spans(&call, scan,
                                                &(sg_int_list){segment, 1, 0}));
    CHECK("as many", span_rows() == n);
  }
  CHECK("a leaf of no segment",
        !sg_door_fill_spans(&call, scan, &(sg_int_list){segment, 0, 0}) &&
            is_domain("shading_segments", 2));
  sg_scan_close(scan);
  scan = NULL;
  CHECK("three lines",
        !sg_door_shading_scan(&call, scene, 3, &looks, &leaves, &scan) &&
            is_domain("shading_lines", 2));
  sg_shading_close(scene);
}

static int32_t
leaf_in_front(sg_shading *scene)
{
  sg_shading_span_list spans = {0};

  return sg_door_shading_spans(&call, scene, 45, &spans) && spans.n == 1
             ? spans.at[0].leaf
             : 0;
}

/* The cube twice, in itself. */
static void
owners(void)
{
  sg_shading_leaf_fact leaf[] = {rows_leaf(1, 12), rows_leaf(2, 12)};
  sg_shading *scene = NULL;
  sg_shading_group_list groups = {0}, none = {0};
  size_t second[] = {1, 2};

  CHECK_DOOR("a scene opens", (scene = open_scene(leaf, 2, 2)) != NULL);
  CHECK("the first", leaf_in_front(scene) == 1);
  CHECK_DOOR("nothing is noted",
             sg_door_shading_groups(&call, scene, &groups) && groups.n == 0);
  CHECK("nothing is asked",
        !sg_door_shading_owners(&call, scene, &(sg_count_list){second, 1, 0}) &&
            is_domain("shading_owners", 2));
  CHECK_DOOR("to be noted", sg_door_shading_ask_owners(&call, scene));
  CHECK("the first, as long as there is no answer", leaf_in_front(scene) == 1);
  CHECK_DOOR("a group", sg_door_shading_groups(&call, scene, &groups) &&
                            groups.n == 1 && groups.at[0].root == 7 &&
                            groups.at[0].begins && groups.at[0].faces.n == 2 &&
                            groups.at[0].faces.at[0].leaf == 1 &&
                            groups.at[0].faces.at[1].leaf == 2 &&
                            groups.at[0].faces.at[1].face == 2);
  CHECK("two answers",
        !sg_door_shading_owners(&call, scene, &(sg_count_list){second, 2, 0}) &&
            is_domain("shading_owners", 2));
  CHECK("a third face", !sg_door_shading_owners(
                            &call, scene, &(sg_count_list){second + 1, 1, 0}) &&
                            is_domain("shading_owners", 2));
  CHECK_DOOR("an answer", sg_door_shading_owners(
                              &call, scene, &(sg_count_list){second, 1, 0}));
  CHECK("the second", leaf_in_front(scene) == 2);
  CHECK_DOOR("it is not asked again",
             sg_door_shading_groups(&call, scene, &none) && none.n == 0);
  sg_shading_close(scene);
}

static void
refused(void)
{
  sg_shading_leaf_fact rows = rows_leaf(1, 12), bad = rows_leaf(1, 9);
  sg_shading_leaf_fact fat = ring_leaf(1, 1.0);
  sg_shading *scene = NULL;
  sg_shading_span_list spans = {0};

  CHECK_DOOR("a scene opens", (scene = open_scene(&rows, 1, 1)) != NULL);
  CHECK("a map of nine numbers",
        !open_scene(&bad, 1, 1) && is_domain("shading_map", 2));
  CHECK("a ring without a hole",
        !open_scene(&fat, 1, 1) && is_domain("shading_ring", 2));
  CHECK("no such leaf",
        !open_scene(&rows, 1, 2) && is_domain("shading_leaf", 3));
  CHECK("below the picture",
        !sg_door_shading_spans(&call, scene, 100, &spans) &&
            is_domain("scan_line", 2));
  sg_shading_close(scene);
}

int
main(void)
{
  sg_world *world = sg_world_open();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("a cube", add_cube(world, 1));
  seen();
  seen_through();
  layers();
  buffers();
  scans();
  owners();
  refused();
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
