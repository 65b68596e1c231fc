/* drawing_rows_test.c -- a cube from its vertices to ink, through the functions
 * of the doors, without Prolog.
 *
 * covers: points_text_rows, raster_rows, stroke_rows
 */
#include "doors/drawing.h"
#include "picture/parts.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include "engine/symbol.h"

#include <string.h>

/* drawn/7 of a cube: nine edges are visible. */
static bool
draw_cube(void)
{
  const sg_chosen_segments all = {.is = SG_CHOSEN_SEGMENTS_ALL};
  const sg_drawn_outlines edges = {.is = SG_DRAWN_OUTLINES_EDGES};
  const sg_scene_lines all_lines = {.is = SG_SCENE_LINES_EVERY};
  const sg_known_model nothing = {.is = SG_KNOWN_MODEL_SEGMENTS};
  const sg_hide_through_list none = {0};
  sg_scene_index *scene = NULL;
  bool good = add_cube(call.world, 1) &&
              sg_door_fill_screen(&call, 30, 60, 9, SG_PROJECTION_PARALLEL) &&
              sg_door_scene_open(&call, &all, 1, 1e-9, &edges, &all_lines,
                                 &nothing, &scene) &&
              sg_door_fill_drawn(&call, scene, SG_LINES_ALL, 30, &none);

  sg_scene_index_close(scene);
  return good;
}

/* Every role, visible and hidden. */
static sg_ranked_look_list
looks(void)
{
  static sg_ranked_look look[2 * SG_ROLES];

  for (int i = 0; i < 2 * SG_ROLES; i++) {
    const char *name = sg_role_name((sg_role)(i / 2));
    look[i] = (sg_ranked_look){i % 2 ? SG_SYMBOL_HIDDEN : SG_SYMBOL_VISIBLE,
                               sg_symbol_intern(name, strlen(name)), i};
  }
  return (sg_ranked_look_list){look, 2 * SG_ROLES, 0};
}

/* How many edges the strokes of drawn/7 run along; SIZE_MAX: refused. */
static size_t
edges_drawn(const sg_ranked_look_list *look, double scale, int32_t removed)
{
  const sg_drawing_place place = {scale, 0, 0, 0, 0};
  const sg_sheet_part_list none = {0};
  sg_sheet_stroke_list strokes = {0};
  sg_chain_run_list runs = {0};
  sg_chains *chains = NULL;
  size_t n = 0, next = 1;

  if (!sg_door_drawn_strokes(&call, &place, removed, look, &none, &chains,
                             &runs)) {
    return SIZE_MAX;
  }
  for (size_t i = 0; i < runs.n; i++) {
    CHECK("runs follow each other", runs.at[i].from == next);
    CHECK_DOOR("strokes of a run",
               sg_door_chain_strokes(&call, chains, runs.at[i].from,
                                     runs.at[i].to, &strokes));
    next = runs.at[i].to + 1;
  }
  for (size_t i = 0; i < strokes.n; i++) {
    n += strokes.at[i].edges.n;
  }
  CHECK("no more",
        !sg_door_chain_strokes(&call, chains, next, next, &strokes) &&
            is_domain("chain", 2));
  sg_chains_close(chains);
  return n;
}

static void
drawn(void)
{
  const sg_ranked_look_list look = looks(), none = {0};
  sg_paper_box box;

  CHECK("nothing is drawn", !sg_door_drawn_box(&call, &box));
  sg_call_rest(&call);
  CHECK("a cube", draw_cube());
  sg_call_rest(&call);
  CHECK_DOOR("its box", sg_door_drawn_box(&call, &box));
  CHECK("is round it", box.x2 - box.x1 > 1 && box.x2 - box.x1 < 1.5 &&
                           box.y2 - box.y1 > 1 && box.y2 - box.y1 < 1.8);
  CHECK("its edges", edges_drawn(&look, 100, -1) == 12);
  CHECK("but the hidden", edges_drawn(&look, 100, SG_SYMBOL_HIDDEN) == 9);
  CHECK("without looks", edges_drawn(&none, 100, -1) == SIZE_MAX &&
                             call.refusal.how == SG_REFUSED_REPRESENTATION);
  call.refusal.how = SG_REFUSED_NOTHING;
  CHECK("too large", edges_drawn(&look, 1e17, -1) == SIZE_MAX &&
                         call.refusal.how == SG_REFUSED_REPRESENTATION);
  call.refusal.how = SG_REFUSED_NOTHING;
}

/* Two parts of one edge, and a hidden one of another. */
static void
chains(void)
{
  const sg_ranked_look_list look = looks();
  int32_t role = look.at[0].role;
  sg_sheet_part part[] = {
      {SG_SYMBOL_VISIBLE, role, 1, 1, 0, 0.5, {0, 0}, {50, 0}},
      {SG_SYMBOL_VISIBLE, role, 1, 1, 0.5, 1, {50, 0}, {100, 0}},
      {SG_SYMBOL_HIDDEN, role, 1, 2, 0, 1, {100, 0}, {100, 70}}};
  sg_looking_part looking[] = {{SG_SYMBOL_VISIBLE, role},
                               {SG_SYMBOL_VISIBLE, role},
                               {SG_SYMBOL_HIDDEN, role},
                               {SG_SYMBOL_VISIBLE, role}};
  const sg_sheet_part_list parts = {part, 3, 0};
  sg_look_name_list names = {0};
  sg_sheet_stroke_list strokes = {0}, none = {0};
  sg_bytes octets = {0};

  CHECK_DOOR("looks",
             sg_door_stroke_looks(&call, &(sg_looking_part_list){looking, 4, 0},
                                  &names));
  CHECK("each once",
        names.n == 2 && names.at[1].visibility == SG_SYMBOL_HIDDEN);
  CHECK_DOOR("chains", sg_door_stroke_chains(&call, &parts, &look, &strokes));
  CHECK("of one look each", strokes.n == 2);
  CHECK("no look", !sg_door_stroke_chains(
                       &call, &parts, &(sg_ranked_look_list){0}, &strokes) &&
                       is_domain("look", 1));
  CHECK_DOOR("of nothing none",
             sg_door_stroke_chains(&call, &(sg_sheet_part_list){0},
                                   &(sg_ranked_look_list){0}, &none) &&
                 none.n == 0);
  CHECK_DOOR("octets", sg_door_stroke_octets(&call, &look, &strokes, &octets));
  CHECK("words of two strokes of one edge",
        octets.n == sizeof(int32_t) * 2 * (5 + 1 + 4));
  CHECK("edges, points", octets.at[12] == 1 && octets.at[16] == 2);
  CHECK("octets of no look",
        !sg_door_stroke_octets(&call, &(sg_ranked_look_list){0}, &strokes,
                               &octets) &&
            is_domain("look", 1));
  strokes.at[0].points.at[0].x = INT64_C(1) << 31;
  CHECK("no word holds it",
        !sg_door_stroke_octets(&call, &look, &strokes, &octets));
  call.refusal.how = SG_REFUSED_NOTHING;
  part[0].a.x = INT64_C(1) << 53;
  CHECK("far away", !sg_door_stroke_chains(&call, &parts, &look, &strokes) &&
                        is_domain("sheet_coordinate", 0));
}

static void
travels(void)
{
  const sg_sheet_point start = {0, 0};
  sg_sheet_point far[] = {{100, 0}, {60, 0}}, near[] = {{10, 0}, {50, 0}};
  sg_travelled_strokes stroke[] = {
      {.is = SG_TRAVELLED_STROKES_STROKE, .stroke = {{far, 2, 0}}},
      {.is = SG_TRAVELLED_STROKES_STROKE, .stroke = {{near, 2, 0}}}};
  sg_travelled_strokes_list strokes = {stroke, 2, 0};
  sg_travel *travel = NULL;
  sg_int_list order = {0};
  double way, unsorted;
  size_t n;

  CHECK_DOOR("travel",
             sg_door_travel_open(&call, &start, SG_TRAVEL_SHORT, &strokes,
                                 &travel, &n, &way, &unsorted));
  CHECK_DOOR("the near one, then the other backwards",
             sg_door_travel_numbers(&call, travel, 1, n, &order) &&
                 order.n == 2 && order.at[0] == 2 && order.at[1] == -1);
  CHECK("how far", way == 10 + 10 && unsorted == 100 + 50);
  CHECK("no more", !sg_door_travel_numbers(&call, travel, 2, 3, &order) &&
                       is_domain("place", 2));
  sg_travel_close(travel);
  stroke[0].stroke.points.n = 0;
  CHECK("a stroke of nothing",
        !sg_door_travel_open(&call, &start, SG_TRAVEL_KEPT, &strokes, &travel,
                             &n, &way, &unsorted) &&
            is_domain("stroke", 3));
}

static void
crossings(void)
{
  sg_sheet_point along[] = {{0, 0}, {1000, 0}},
                 up[] = {{400, -500}, {400, 500}};
  sg_travelled_stroke stroke[] = {{{along, 2, 0}}, {{up, 2, 0}}};
  sg_travelled_stroke_list strokes = {stroke, 2, 0};
  sg_stroke_mark_list marks = {0};

  CHECK_DOOR("crossings", sg_door_stroke_crossings(&call, &strokes, &marks));
  CHECK("one of each", marks.n == 2 && marks.at[0].stroke == 1 &&
                           marks.at[0].way == 400 && marks.at[1].stroke == 2 &&
                           marks.at[1].way == 500);
  along[0].x = INT64_C(1) << 53;
  CHECK("too far away", !sg_door_stroke_crossings(&call, &strokes, &marks) &&
                            is_domain("sheet_coordinate", 0));
}

static bool
is_text(const sg_sheet_point *point, size_t n, const char *wanted)
{
  sg_sheet_point at[3];
  sg_bytes text = {0};

  memcpy(at, point, n * sizeof *at);
  return sg_door_points_text(&call, &(sg_sheet_point_list){at, n, n}, &text) &&
         text.n == strlen(wanted) && memcmp(text.at, wanted, text.n) == 0;
}

static void
written(void)
{
  const sg_sheet_point few[] = {{0, -1}, {-12340, 1005}, {100, 99000}};
  const sg_sheet_point far[] = {{INT64_MIN, INT64_MAX}, {INT64_MIN, INT64_MIN}};

  CHECK_DOOR("no points", is_text(few, 0, ""));
  CHECK_DOOR("thousandths", is_text(few, 3, "0,-0.001 -12.34,1.005 0.1,99"));
  CHECK_DOOR("the longest",
             is_text(far, 2,
                     "-9223372036854775.808,9223372036854775.807 "
                     "-9223372036854775.808,-9223372036854775.808"));
}

typedef struct page {
  char text[64];
  size_t n;
} page;

static bool
write_page(void *data, const char *text, size_t n)
{
  page *p = data;

  if (n > sizeof p->text) {
    return false;
  }
  memcpy(p->text, text, p->n = n);
  return true;
}

static bool
is_written(const sg_sheet_point *point, size_t n, const char *wanted)
{
  sg_sheet_point at[4];
  page p = {"", 0};
  const sg_output out = {write_page, &p};

  memcpy(at, point, n * sizeof *at);
  return sg_door_points_written(&call, &out, "<\"",
                                &(sg_sheet_point_list){at, n, n}, "\"/>") &&
         p.n == strlen(wanted) && memcmp(p.text, wanted, p.n) == 0;
}

static void
streamed(void)
{
  const sg_sheet_point few[] = {{0, -1}, {-12340, 1005}};
  const sg_sheet_point far[] = {{INT64_MIN, INT64_MAX}, {INT64_MIN, INT64_MIN}};
  int64_t number[] = {0, -1, 12340};
  sg_bytes text = {0};

  CHECK_DOOR("nothing between", is_written(few, 0, "<\"\"/>"));
  CHECK_DOOR("points between",
             is_written(few, 2, "<\"0,-0.001 -12.34,1.005\"/>"));
  CHECK("the stream refuses", !is_written(far, 2, ""));
  CHECK_DOOR("numbers",
             sg_door_thousandths_text(&call, &(sg_integer_list){number, 3, 3},
                                      &text) &&
                 text.n == 14 && memcmp(text.at, "0 -0.001 12.34", 14) == 0);
  CHECK_DOOR("no numbers",
             sg_door_thousandths_text(&call, &(sg_integer_list){number, 0, 0},
                                      &text) &&
                 text.n == 0);
}

static bool
is_png(const sg_bytes *bytes)
{
  return bytes->n > 8 && memcmp(bytes->at, "\x89PNG\r\n\x1a\n", 8) == 0;
}

static void
dots(void)
{
  sg_dot_point line[] = {{1, 1}, {5, 1}};
  sg_dot_stroke stroke = {7, 1, {0}, {line, 2, 0}};
  const sg_dot_stroke_list strokes = {&stroke, 1, 0};
  sg_rgb colour[8] = {{255, 255, 255}};
  sg_bytes raster = {0}, file = {0};
  size_t inked = 0;

  CHECK_DOOR("dots", sg_door_raster_dots(&call, 8, 4, &strokes, &raster));
  for (size_t i = 0; i < raster.n; i++) {
    inked += raster.at[i] == 7;
  }
  CHECK("of ink", raster.n == 32 && inked == 5 && raster.at[8 + 3] == 7);
  CHECK_DOOR("file", sg_door_raster_png(&call, 8, 4, &raster,
                                        &(sg_rgb_list){colour, 8, 0}, &file) &&
                         is_png(&file));
  CHECK("ink 7 has no colour",
        !sg_door_raster_png(&call, 8, 4, &raster, &(sg_rgb_list){colour, 7, 0},
                            &file) &&
            is_domain("palette", 4));
  CHECK("no width", !sg_door_raster_dots(&call, 0, 4, &strokes, &raster) &&
                        is_domain("raster_size", 1));
}

static void
smooth(void)
{
  const sg_rgb paper = {255, 255, 255}, odd = {256, 0, 0};
  sg_paper_point point[] = {{1, 1}, {6, 2}};
  sg_canvas_line_fact line = {{0, 0, 0}, 1, true, {point, 2, 0}};
  const sg_canvas_line_fact_list lines = {&line, 1, 0};
  sg_bytes file = {0};

  CHECK_DOOR("canvas",
             sg_door_canvas_png(&call, 8, 4, 1, &paper, &lines, &file) &&
                 is_png(&file));
  CHECK("no colour", !sg_door_canvas_png(&call, 8, 4, 1, &odd, &lines, &file) &&
                         is_domain("byte", 0));
  line.width = 0;
  CHECK("no pen", !sg_door_canvas_png(&call, 8, 4, 1, &paper, &lines, &file) &&
                      is_domain("pen_width", 5));
}

int
main(void)
{
  sg_world *world = sg_world_open();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  drawn();
  chains();
  travels();
  crossings();
  written();
  streamed();
  dots();
  smooth();
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
