/* scene_rows_test.c -- a cube seen, drawn and asked for what hides it, through
 * the functions of the doors, without Prolog.
 *
 * covers: dense, known_surface_rows, live_rows
 */
#include "doors/drawing.h"
#include "doors/pattern.h"
#include "picture/parts.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include "engine/symbol.h"

#include <math.h>
#include <string.h>

enum { CUBE = 1, OTHER = 2 };

static sg_call call;
static const sg_chosen_segments all = {.is = SG_CHOSEN_SEGMENTS_ALL};
static const sg_drawn_outlines edges = {.is = SG_DRAWN_OUTLINES_EDGES};
static const sg_scene_lines all_lines = {.is = SG_SCENE_LINES_EVERY};
static const sg_known_model kept = {.is = SG_KNOWN_MODEL_KEPT};
static const sg_known_model nothing = {.is = SG_KNOWN_MODEL_SEGMENTS};

static size_t
rows_in(sg_relation relation)
{
  const sg_version *version = sg_world_version(call.world);
  size_t n = sg_version_count(version, relation);

  sg_version_drop(version);
  return n;
}

/* A call of its own: the world as it is now. */
static void
call_again(const sg_cancel *host)
{
  sg_world *world = call.world;

  sg_call_close(&call);
  sg_call_open(&call, host, NULL);
  call.world = world;
}

static sg_scene_index *
opened(const sg_known_model *known)
{
  sg_scene_index *scene = NULL;

  call_again(NULL);
  return sg_door_scene_open(&call, &all, 1, 1e-9, &edges, &all_lines, known,
                            &scene)
             ? scene
             : NULL;
}

static bool
is_refused(sg_refused how, int argument, int64_t number)
{
  const sg_refusal *r = &call.refusal;
  bool is = r->how == how && r->argument == argument && r->number == number;

  call.refusal = (sg_refusal){.how = SG_REFUSED_NOTHING};
  return is;
}

static void
lines(sg_scene_index *scene)
{
  const int32_t one = 1, none = 99;
  sg_scene_edge_rows every = {0}, first = {0}, other = {0};
  double near = 0;

  CHECK_DOOR("edges", sg_door_scene_edge(&call, scene, NULL, NULL, &every));
  CHECK("of a cube", every.n == 12);
  CHECK_DOOR("the first", sg_door_scene_edge(&call, scene, &one, &one, &first));
  CHECK("is a right angle",
        first.n == 1 && first.at[0].e == 1 && first.at[0].look.bend > 89.9 &&
            first.at[0].look.bend < 90.1 && first.at[0].look.faces == 2);
  CHECK_DOOR("of no segment",
             sg_door_scene_edge(&call, scene, &none, NULL, &other));
  CHECK("none", other.n == 0);
  CHECK("not there", !sg_door_scene_edge(&call, scene, &one, &none, &other) &&
                         is_refused(SG_REFUSED_NOTHING, 0, 0));
  CHECK_DOOR("near", sg_door_scene_near(&call, scene, &near) && near > 0);
}

/* Word k of a mesh: a float. */
static float
float_at(const sg_bytes *octets, size_t k)
{
  uint32_t word = 0;
  float out;

  for (int i = 0; i < 4; i++) {
    word |= (uint32_t)octets->at[4 * k + (size_t)i] << 8 * i;
  }
  memcpy(&out, &word, sizeof out);
  return out;
}

/* Seen from its middle, the corners of a cube are as far from there as its
 * faces. Its edges bend by 90 degrees. */
static void
mesh(sg_scene_index *scene)
{
  sg_xyz middle;
  sg_mesh_counts counts, blunt;
  sg_bytes octets, other;
  bool near = true;

  CHECK_DOOR("a mesh",
             sg_door_scene_mesh(&call, scene, 30, &middle, &counts, &octets));
  CHECK("of a cube", counts.vertices == 8 && counts.triangles == 12 &&
                         counts.lines == 12 && counts.sharp == 12 &&
                         octets.n == 4 * (3 * 8 + 3 * 12 + 2 * 12));
  for (size_t k = 1; k < 24; k++) {
    near = near && fabsf(float_at(&octets, k)) == fabsf(float_at(&octets, 0));
  }
  CHECK("from its middle", near && float_at(&octets, 0) != 0);
  for (size_t k = 24; k < octets.n / 4; k++) {
    near = near && octets.at[4 * k] < 8 && octets.at[4 * k + 1] == 0;
  }
  CHECK("of its vertices", near);
  CHECK_DOOR("all blunt",
             sg_door_scene_mesh(&call, scene, 100, &middle, &blunt, &other) &&
                 blunt.sharp == 0 && blunt.lines == 12 && other.n == octets.n &&
                 memcmp(other.at, octets.at, octets.n) == 0);
}

/* The three edges at the corner behind are hidden, each of them whole. */
static void
joins(sg_scene_index *scene)
{
  const int32_t other = OTHER;
  sg_scene_edge_rows every = {0};
  size_t hidden = 0, covered = 0, lying = 0, of_other = 0;

  sg_door_scene_edge(&call, scene, NULL, NULL, &every);
  for (size_t i = 0; i < every.n; i++) {
    int32_t e = every.at[i].e;
    sg_occluder_rows by = {0}, by_other = {0};
    sg_overlap_rows on = {0};
    sg_line_cover_list covers = {0};
    CHECK_DOOR(
        "asked",
        sg_door_occluder(&call, scene, CUBE, e, NULL, NULL, &by) &&
            sg_door_occluder(&call, scene, CUBE, e, &other, NULL, &by_other) &&
            sg_door_overlap(&call, scene, CUBE, e, NULL, NULL, &on) &&
            sg_door_line_covers(&call, scene, CUBE, e, &covers));
    hidden += by.n > 0;
    of_other += by_other.n;
    covered += covers.n > 0;
    lying += on.n;
  }
  CHECK("hidden", hidden == 3);
  CHECK("by no other", of_other == 0);
  CHECK("covered", covered >= hidden);
  CHECK("none lies on another", lying == 0);
  CHECK("not drawn", !sg_door_occluder(&call, scene, CUBE, 99, NULL, NULL,
                                       &(sg_occluder_rows){0}) &&
                         is_refused(SG_REFUSED_EXISTENCE, 3, 0));
}

static size_t
hidden_parts(void)
{
  const sg_version *version = sg_world_version(call.world);
  size_t n = 0;
  sg_view view;

  if (sg_version_view(version, SG_DRAWN, &view)) {
    for (size_t page = 0; page < view.pages; page++) {
      for (unsigned i = sg_live_next(view.live[page], 0); i < SG_PAGE_ROWS;
           i = sg_live_next(view.live[page], i + 1)) {
        n += view.column[5].page[page].i[i] == SG_SYMBOL_HIDDEN;
      }
    }
    sg_view_clear(&view);
  }
  sg_version_drop(version);
  return n;
}

static void
drawn(sg_scene_index *scene)
{
  sg_hide_through pair[] = {{OTHER, CUBE}, {CUBE, OTHER}, {CUBE, CUBE}};
  const sg_hide_through_list none = {0}, glass = {pair, 3, 3};

  CHECK_DOOR("draw", sg_door_fill_drawn(&call, scene, SG_LINES_ALL, 30, &none));
  CHECK("each line", rows_in(SG_DRAWN) == 12 && hidden_parts() == 3);
  CHECK_DOOR("glass",
             sg_door_fill_drawn(&call, scene, SG_LINES_ALL, 30, &glass));
  CHECK("hides nothing", rows_in(SG_DRAWN) == 12 && hidden_parts() == 0);
  CHECK_DOOR("no cuts",
             sg_door_fill_drawn(&call, scene, SG_LINES_CUT, 30, &none));
  CHECK("are drawn", rows_in(SG_DRAWN) == 0);
}

static bool
outlined(double crease)
{
  const sg_smoothness smooth = {.crease = crease};

  call_again(NULL);
  return sg_door_fill_contour(&call, &all, 30, 60, 9, SG_PROJECTION_PARALLEL,
                              &smooth, &nothing);
}

static void
outlines(void)
{
  sg_scene_index *scene = NULL;
  const sg_drawn_outlines smooth = {.is = SG_DRAWN_OUTLINES_SMOOTH,
                                    .smooth = {.crease = 120}};

  CHECK_DOOR("of a cube", outlined(30));
  CHECK("there is none", rows_in(SG_CONTOUR) == 0);
  CHECK_DOOR("of a ball", outlined(120));
  CHECK("there is one", rows_in(SG_CONTOUR) > 3);
  call_again(NULL);
  CHECK_DOOR("seen", sg_door_scene_open(&call, &all, 1, 1e-9, &smooth,
                                        &all_lines, &kept, &scene));
  sg_scene_edge_rows every = {0};

  sg_door_scene_edge(&call, scene, NULL, NULL, &every);
  CHECK("its pieces are lines", every.n > 12 && every.at[0].e < 0);
  sg_scene_index_close(scene);
}

static bool
asked(int32_t number, size_t numbers, sg_known_segment_list *facets)
{
  static double frame[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  static int32_t s[1] = {CUBE};
  sg_smooth_surface ball = {SG_KNOWN_SPHERE, {frame, numbers, 0}, 0, 0};
  sg_surface_run run[2] = {{1, 3, number}, {5, 6, -2}};
  sg_known_segment said = {.is = SG_KNOWN_SEGMENT_KNOWN,
                           .known = {CUBE, {&ball, 1, 0}, {run, 2, 0}}};

  return sg_door_known_facets(&call, &(sg_known_segment_list){&said, 1, 0},
                              &(sg_int_list){s, 1, 0}, facets);
}

static void
facets(void)
{
  sg_known_segment_list out = {0};

  CHECK_DOOR("facets", asked(1, 12, &out) && out.n == 1);
  CHECK("of one surface", out.at[0].known.surfaces.n == 1 &&
                              out.at[0].known.surfaces.at[0].frame.n == 12 &&
                              out.at[0].known.surfaces.at[0].frame.at[3] == 1);
  CHECK("and a face", out.at[0].known.runs.n == 2 &&
                          out.at[0].known.runs.at[0].last == 3 &&
                          out.at[0].known.runs.at[1].number == -1);
  CHECK("surface 2",
        !asked(2, 12, &out) && is_refused(SG_REFUSED_DOMAIN, 0, 2));
  CHECK("11 numbers",
        !asked(1, 11, &out) && is_refused(SG_REFUSED_DOMAIN, 0, 11));
}

/* The cube's side from x = 0 and the next: how far they reach on a cylinder
 * about z, whose U is x; its W is 2 long. */
static void
extents(void)
{
  static double frame[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2};
  static int32_t s[1] = {CUBE};
  sg_smooth_surface round = {SG_KNOWN_TAPERED, {frame, 12, 0}, 1, 1};
  sg_surface_run run = {1, 6, 1};
  sg_known_segment said = {.is = SG_KNOWN_SEGMENT_KNOWN,
                           .known = {CUBE, {&round, 1, 0}, {&run, 1, 0}}};
  const sg_known_segment_list known = {&said, 1, 0};
  const sg_int_list these = {s, 1, 0};
  sg_round_extent_list out = {0};

  CHECK_DOOR("extents",
             sg_door_round_extents(&call, &known, &these, &out) && out.n == 1);
  CHECK("along the axis", out.at[0].low == 0 && out.at[0].high == 0.5);
  CHECK("about it: a quarter from U to V",
        out.at[0].begin == 0 && out.at[0].turn == 90);
  frame[0] = frame[1] = 0.5;
  out = (sg_round_extent_list){0};
  CHECK_DOOR("in its middle",
             sg_door_round_extents(&call, &known, &these, &out) && out.n == 1 &&
                 out.at[0].turn == 270);
  round.kind = SG_KNOWN_SPHERE;
  out = (sg_round_extent_list){0};
  CHECK_DOOR("a ball's facets may be wider",
             sg_door_round_extents(&call, &known, &these, &out) &&
                 out.at[0].turn == 360);
  round.kind = SG_KNOWN_FREE;
  out = (sg_round_extent_list){0};
  CHECK_DOOR("what has no axis",
             sg_door_round_extents(&call, &known, &these, &out) && out.n == 0);
}

static bool
stop(void *data)
{
  (void)data;
  return true;
}

int
main(void)
{
  static const sg_cancel now = {stop, NULL};
  sg_scene_index *scene = NULL;

  sg_call_open(&call, NULL, NULL);
  call.world = sg_world_open();
  CHECK("a cube", call.world && add_cube(call.world, CUBE));
  CHECK_DOOR("seen",
             sg_door_fill_screen(&call, 30, 60, 9, SG_PROJECTION_PARALLEL));
  CHECK("nothing is kept",
        !opened(&kept) && is_refused(SG_REFUSED_NOTHING, 0, 0));
  call_again(&now);
  CHECK("stopped", !sg_door_scene_open(&call, &all, 1, 1e-9, &edges, &all_lines,
                                       &nothing, &scene) &&
                       is_refused(SG_REFUSED_NOTHING, 0, 0));
  sg_scene_index_close(opened(&nothing));
  CHECK_DOOR("opens", (scene = opened(&kept)) != NULL);
  CHECK("kept", scene != NULL);
  lines(scene);
  mesh(scene);
  joins(scene);
  drawn(scene);
  outlines();
  facets();
  extents();
  CHECK("another", add_cube(call.world, OTHER));
  CHECK("is not kept", !opened(&kept));
  CHECK_DOOR("a scene stays", sg_door_scene_near(&call, scene, &(double){0}));
  sg_scene_index_close(scene);
  sg_world *world = call.world;

  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
