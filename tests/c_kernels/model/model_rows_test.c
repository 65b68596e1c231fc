/* model_rows_test.c -- files from memory into a world and back, through the
 * functions of the doors.
 *
 * covers: dense_rows, mesh_rows, shape_rows
 */
#include "doors/file.h"
#include "doors/world.h"
#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include "engine/symbol.h"

#include <string.h>

enum { ROOM = 1 << 16 };

static sg_call call;

/* A stream in memory. `chunk`: of a reader, what it gives at once; of a writer,
 * how much it takes before it fails. */
typedef struct memory {
  char at[ROOM];
  size_t n, done, chunk;
} memory;

static size_t
read_memory(void *data, char *to, size_t n)
{
  memory *m = data;
  size_t left = m->n - m->done;

  if (m->chunk == SIZE_MAX) {
    return SIZE_MAX;
  }
  n = n < left ? n : left;
  n = n < m->chunk ? n : m->chunk;
  memcpy(to, m->at + m->done, n);
  m->done += n;
  return n;
}

static bool
write_memory(void *data, const char *bytes, size_t n)
{
  memory *m = data;

  if (m->n + n > m->chunk) {
    return false;
  }
  memcpy(m->at + m->n, bytes, n);
  m->n += n;
  return true;
}

static memory source, sink;
static const sg_input in = {read_memory, &source};
static const sg_output out = {write_memory, &sink};

static void
set_source(const char *text)
{
  source = (memory){.n = strlen(text), .chunk = 7};
  memcpy(source.at, text, source.n);
}

/* Refused for this reason; the call goes on. */
static bool
refused(sg_refused how)
{
  bool is = call.refusal.how == how;

  call.refusal = (sg_refusal){0};
  return is;
}

static size_t
rows_of(sg_world *world, sg_relation relation)
{
  const sg_version *version = sg_world_version(world);
  size_t n = sg_version_count(version, relation);

  sg_version_drop(version);
  return n;
}

#define TETRAHEDRON                                                            \
  "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 "  \
  "3\n"

static void
adds_a_mesh(sg_world *world)
{
  sg_mesh_added result;

  set_source(TETRAHEDRON);
  CHECK_DOOR("add", sg_door_mesh_add(&call, &in, SG_MESH_UNKNOWN, SG_WELD_AUTO,
                                     true, 2, &result));
  CHECK("is loaded", result.is == SG_MESH_ADDED_LOADED &&
                         result.loaded.parts.n == 1 &&
                         result.loaded.parts.at[0].s == 2);
  CHECK("a solid", result.loaded.parts.at[0].kind == SG_MESH_KIND_SOLID &&
                       !*result.loaded.parts.at[0].name);
  CHECK("rows", rows_of(world, SG_V) == 8 + 4 && rows_of(world, SG_P) == 6 + 4);
  set_source(TETRAHEDRON);
  CHECK("in its place", !sg_door_mesh_add(&call, &in, SG_MESH_OFF, SG_WELD_AUTO,
                                          true, 2, &result));
  CHECK("there are rows", refused(SG_REFUSED_PERMISSION));
  set_source("OFF\n3 1 0\n0 0 0\nx 0 0\n0 1 0\n3 0 1 2\n");
  CHECK_DOOR("bad", sg_door_mesh_add(&call, &in, SG_MESH_OFF, SG_WELD_AUTO,
                                     true, 3, &result));
  CHECK("is told", result.is == SG_MESH_ADDED_FAULT && result.fault.line == 4 &&
                       result.fault.code == SG_MESH_BAD_NUMBER);
  source.chunk = SIZE_MAX;
  CHECK("broken", !sg_door_mesh_add(&call, &in, SG_MESH_OFF, SG_WELD_AUTO, true,
                                    3, &result));
  CHECK("the host knows", call.stopped && refused(SG_REFUSED_NOTHING));
  call.stopped = false;
}

/* A square with a hole, of this list, as segment s. */
static bool
write_square(int32_t s, int32_t *list, size_t n)
{
  sg_xyz at[8];
  sg_int_list chain = {list, n, 0};

  for (int i = 0; i < 8; i++) {
    at[i] = (sg_xyz){{i % 2, i / 2 % 2, i / 4}};
  }
  return sg_door_shape_write(&call, s, &(sg_point_list){at, 8, 0},
                             &(sg_list_int_list){&chain, 1, 0}, true);
}

static void
shapes(sg_world *world)
{
  int32_t list[] = {1, 2, 4, 3, 1, -5, 7, 8, 6, 5};
  size_t v = rows_of(world, SG_V), e = rows_of(world, SG_E),
         p = rows_of(world, SG_P);

  CHECK_DOOR("a shape", write_square(30, list, 10));
  CHECK("its rows", rows_of(world, SG_V) == v + 8 &&
                        rows_of(world, SG_E) == e + 8 &&
                        rows_of(world, SG_P) == p + 1);
  CHECK("again", !write_square(30, list, 10) && refused(SG_REFUSED_PERMISSION));
  CHECK("open", !write_square(31, list, 9) && !write_square(31, list, 7));
  CHECK_DOOR("closes itself", write_square(31, list, 4));
  list[0] = 9;
  CHECK("no vertex", !write_square(32, list, 4));
  list[0] = list[1];
  CHECK("twice there", !write_square(32, list, 4));
  CHECK("nothing was added", rows_of(world, SG_P) == p + 2);
  CHECK("no refusal", refused(SG_REFUSED_NOTHING));
}

/* A name that is no UTF-8 is taken for Latin-1. */
static void
names(void)
{
  sg_mesh_added result;

  set_source("v 0 0 0\nv 1 0 0\nv 0 1 0\no \xc3\xa4\nf 1 2 3\no \xe4\n"
             "f 1 3 2\n");
  CHECK_DOOR("names", sg_door_mesh_add(&call, &in, SG_MESH_OBJ, SG_WELD_AUTO,
                                       false, 10, &result));
  CHECK("two parts", result.is == SG_MESH_ADDED_LOADED &&
                         result.loaded.parts.n == 2 &&
                         result.loaded.parts.at[1].s == 11);
  for (size_t i = 0; i < result.loaded.parts.n; i++) {
    CHECK("one name", !strcmp(result.loaded.parts.at[i].name, "\xc3\xa4"));
    CHECK("a surface", result.loaded.parts.at[i].kind == SG_MESH_KIND_SURFACE);
  }
}

static void
writes_a_mesh(void)
{
  int32_t ids[] = {1, 2};
  const char *texts[] = {"a", ""};
  const sg_int_list both = {ids, 2, 2}, none = {0};
  const sg_name_list named = {texts, 2, 2}, few = {texts, 1, 1}, nobody = {0};
  sg_mesh_written result;

  sink = (memory){.chunk = ROOM};
  CHECK_DOOR("write", sg_door_mesh_write(&call, &out, SG_MESH_OBJ, &both,
                                         &named, &result));
  CHECK("ok", result.is == SG_MESH_WRITTEN_OK && strstr(sink.at, "o a\n"));
  CHECK("a name for each",
        !sg_door_mesh_write(&call, &out, SG_MESH_OBJ, &both, &few, &result));
  CHECK("is refused", refused(SG_REFUSED_DOMAIN));
  sink = (memory){.chunk = 4};
  CHECK("full",
        !sg_door_mesh_write(&call, &out, SG_MESH_OBJ, &both, &named, &result));
  CHECK("the host knows", refused(SG_REFUSED_NOTHING));
  sink = (memory){.chunk = ROOM};
  CHECK_DOOR("no segments", sg_door_mesh_write(&call, &out, SG_MESH_OFF, &none,
                                               &nobody, &result));
  CHECK("are none", strstr(sink.at, "\n0 0 0\n") != NULL);
}

static void
boundaries(sg_world *world)
{
  int32_t ids[] = {1};
  const char *texts[] = {"cube"};
  const sg_int_list cube = {ids, 1, 1};
  const sg_name_list name = {texts, 1, 1};
  const sg_id_pair_list made = {0};
  sg_boundary_counts n = {0};
  sg_boundary_meeting_list meetings = {0};
  sg_boundaries *b = NULL, *coarser = NULL;
  sg_mesh_written result;
  size_t before = rows_of(world, SG_V);

  CHECK_DOOR("open",
             sg_door_boundary_open(&call, &cube, &made, true, 0,
                                   SG_BOUNDARY_FORM_TRIANGLES, false, &b));
  CHECK_DOOR("counts", sg_door_boundary_counts(&call, b, &n));
  CHECK("of a cube",
        n.faces == 12 && n.open == 0 && n.crossing == 0 && n.stuck == 0);
  CHECK_DOOR("meetings", sg_door_boundary_meetings(&call, b, true, &meetings));
  CHECK("there are none", meetings.n == 0);
  CHECK_DOOR("coarsen", sg_door_boundary_coarsen(&call, b, 0.5, &coarser));
  CHECK_DOOR("add", sg_door_boundary_add(&call, b, 20));
  CHECK("its rows", rows_of(world, SG_V) == before + 8);
  sink = (memory){.chunk = ROOM};
  CHECK_DOOR("write", sg_door_boundary_write(&call, b, &out, SG_MESH_STL, &name,
                                             &result));
  CHECK("ok", result.is == SG_MESH_WRITTEN_OK &&
                  strncmp(sink.at, "solid cube", 10) == 0);
  sg_boundaries_free(b);
  sg_boundaries_free(coarser);
}

/* What comes is looked through as it comes: a fault is found where it is, also
 * in a fact that what is there already has begun. */
static void
copies(void)
{
  static memory begun;
  const sg_input before = {read_memory, &begun};
  sg_text_limits most = {20, 20, 20, 20, 100, 100};
  sg_text_fault_place fault;
  size_t n;

  begun = (memory){.at = "v(1,\n22222222222222", .n = 19, .chunk = 5};
  sink = (memory){.chunk = ROOM};
  set_source("2222222). v(1, 1, 1).");
  CHECK_DOOR("goes on", sg_door_text_copied(&call, SG_TEXT_FACTS, &before, &in,
                                            &out, &most, 1000, &n, &fault));
  CHECK("fault", fault.what == SG_TEXT_DIGITS && fault.line == 2);
  CHECK("copied no further", n == 7 && sink.n == 7);
  begun = (memory){.chunk = 5};
  sink = (memory){.chunk = ROOM};
  set_source("v(1, 1, 1). v(1, 1, 1).");
  CHECK_DOOR("most", sg_door_text_copied(&call, SG_TEXT_FACTS, &before, &in,
                                         &out, &most, 10, &n, &fault));
  CHECK("no more", fault.what == SG_TEXT_GOOD && n == 10 &&
                       !memcmp(sink.at, "v(1, 1, 1)", 10));
  CHECK_DOOR("the rest", sg_door_text_copied(&call, SG_TEXT_FACTS, &before, &in,
                                             &out, &most, 1000, &n, &fault));
  CHECK("to the end",
        n == 13 && !memcmp(sink.at, source.at, 23) && sink.n == 23);
  set_source("[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[");
  CHECK_DOOR("octets", sg_door_text_copied(&call, SG_TEXT_OCTETS, &before, &in,
                                           &out, &most, 1000, &n, &fault));
  CHECK("are any", fault.what == SG_TEXT_GOOD && n == 30);
  sink = (memory){.chunk = 3};
  set_source("v(1, 1, 1).");
  CHECK("full", !sg_door_text_copied(&call, SG_TEXT_FACTS, &before, &in, &out,
                                     &most, 1000, &n, &fault));
  refused(SG_REFUSED_NOTHING);
}

static void
texts(void)
{
  sg_text_limits most = {20, 20, 20, 20, 100, 100};
  sg_text_fault_place fault;
  const uint32_t *term;

  set_source("v(1,\n22222222222222222222222).");
  CHECK_DOOR("digits",
             sg_door_text_fault(&call, SG_TEXT_FACTS, &in, &most, &fault));
  CHECK("where", fault.what == SG_TEXT_DIGITS && fault.line == 2);
  set_source("v(1).");
  CHECK("no fault",
        !sg_door_text_fault(&call, SG_TEXT_FACTS, &in, &most, &fault));
  set_source("cube([1,2.5,inf]); // end");
  CHECK_DOOR("csg", sg_door_csg_nodes(&call, &in, "a.csg", &most, &term));
  CHECK("nodes", term[1] == (1 << 4 | SG_TERM_COMPOUND) &&
                     !strcmp(sg_symbol_text((int32_t)term[2], NULL), "nodes"));
  set_source("cube([1,2.5");
  CHECK_DOOR("no end", sg_door_csg_nodes(&call, &in, "a.csg", &most, &term));
  CHECK("is told",
        term[1] == (3 << 4 | SG_TERM_COMPOUND) &&
            !strcmp(sg_symbol_text((int32_t)term[2], NULL), "fault"));
  most.file = 5;
  set_source("cube([1,2.5,inf]);");
  CHECK_DOOR("long", sg_door_csg_nodes(&call, &in, "a.csg", &most, &term));
  CHECK("is told", !strcmp(sg_symbol_text((int32_t)term[2], NULL), "fault"));
}

int
main(void)
{
  sg_world *world = sg_world_open();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("a world", world && add_cube(world, 1));
  adds_a_mesh(world);
  names();
  shapes(world);
  writes_a_mesh();
  boundaries(world);
  copies();
  texts();
  sg_call_close(&call);
  sg_world_drop(world);
  return check_report();
}
