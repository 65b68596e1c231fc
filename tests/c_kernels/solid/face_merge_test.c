/* face_merge_test.c -- faces that become one, counted beside an independent
 * model.
 */
#include "merged.h"
#include "tests/check.h"

/* ---- shapes by name ----------------------------------------------------- */

static const struct {
  const char *name;
  int box[2][6];
  size_t faces, vertices, edges;
} pairs[] = {
    {"a cube", {{0, 0, 0, 1, 1, 1}}, 6, 8, 12},
    {"an L of two boxes", {{0, 0, 0, 3, 1, 1}, {0, 0, 1, 1, 1, 3}}, 8, 12, 18},
    {"boxes that share a part of a face",
     {{0, 0, 0, 2, 2, 2}, {2, 0, 1, 4, 2, 3}},
     10,
     16,
     24},
    {"a box in the middle of a face",
     {{0, 0, 0, 3, 3, 1}, {1, 1, 1, 2, 2, 2}},
     11,
     16,
     24},
    {"cubes that touch in an edge",
     {{0, 0, 0, 2, 2, 2}, {2, 2, 0, 4, 4, 2}},
     12,
     14,
     23},
    {"cubes that touch in a part of an edge",
     {{0, 0, 0, 2, 2, 3}, {2, 2, 1, 4, 4, 2}},
     12,
     16,
     25},
    {"cubes that touch in a vertex",
     {{0, 0, 0, 2, 2, 2}, {2, 2, 2, 4, 4, 4}},
     12,
     15,
     24},
    {"one box of two", {{0, 0, 0, 2, 2, 2}, {0, 0, 2, 2, 2, 4}}, 6, 8, 12},
};

static cube_lump
pair_lump(size_t i)
{
  cube_lump lump = {0};

  for (int k = 0; k < 2; k++) {
    const int *b = pairs[i].box[k];
    fill_box(&lump, b[0], b[1], b[2], b[3], b[4], b[5]);
  }
  return lump;
}

static void
test_pairs(void)
{
  for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
    cube_lump lump = pair_lump(i);
    for (grouping how = EACH_TRIANGLE; how <= BY_CHANCE; how++) {
      sg_solid solid = lump_solid(&lump, how);
      CHECK(pairs[i].name, merged_is(&solid, TOLERANCE, pairs[i].faces,
                                     pairs[i].vertices, pairs[i].edges));
      sg_solid_clear(&solid);
    }
  }
}

/* Turned, and shaken by up to `most` tolerances. */
static void
test_turned(const char *name, double far, double most)
{
  unsigned bad = 0;

  for (int round = 0; round < 1000; round++) {
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
      cube_lump lump = pair_lump(i);
      sg_solid solid = lump_solid(&lump, BY_CHANCE);
      place_at_random(&solid, far);
      shake(&solid, most * TOLERANCE);
      bad += !merged_is(&solid, TOLERANCE, pairs[i].faces, pairs[i].vertices,
                        pairs[i].edges);
      sg_solid_clear(&solid);
    }
  }
  CHECK(name, bad == 0);
}

/* Moves what the first box does not have by up to the tolerance. */
static void
move_second(sg_solid *solid, const int first[6])
{
  double by[3];

  for (int k = 0; k < 3; k++) {
    by[k] = random_in(-1, 1) * TOLERANCE;
  }
  for (size_t v = 0; v < solid->vertices; v++) {
    double *at = solid->vertex[v].at;
    bool shared = true;
    for (int k = 0; k < 3; k++) {
      shared = shared && at[k] >= first[k] && at[k] <= first[k + 3];
    }
    for (int k = 0; k < 3 && !shared; k++) {
      at[k] += by[k];
    }
  }
}

static void
test_contacts_off(void)
{
  unsigned bad = 0;

  for (int round = 0; round < 1000; round++) {
    for (size_t i = 1; i < 4; i++) {
      cube_lump lump = pair_lump(i);
      sg_solid solid = lump_solid(&lump, BY_CHANCE);
      move_second(&solid, pairs[i].box[0]);
      place_at_random(&solid, 1);
      bad += !merged_is(&solid, TOLERANCE, pairs[i].faces, pairs[i].vertices,
                        pairs[i].edges);
      sg_solid_clear(&solid);
    }
  }
  CHECK("contacts off by up to the tolerance", bad == 0);
}

static void
test_frame(void)
{
  cube_lump lump = {0};
  sg_solid solid;
  size_t corners = 0;

  fill_box(&lump, 0, 0, 0, 5, 5, 1);
  for (int x = 1; x < 4; x++) {
    for (int y = 1; y < 4; y++) {
      lump.cell[x][y][0] = false;
    }
  }
  solid = lump_solid(&lump, EACH_SQUARE);
  CHECK("a frame", merged_is(&solid, TOLERANCE, 10, 16, 24));
  for (size_t f = 0; f < solid.faces; f++) {
    corners += solid.face[f].n == 8; /* 8 + 2 - 2 */
  }
  CHECK("the two with a hole have the least triangles", corners == 2);
  CHECK("the others too", solid.triangles == 16 + 8 * 2);
  sg_solid_clear(&solid);
}

/* ---- lumps at random ---------------------------------------------------- */

static cube_lump
random_lump(void)
{
  cube_lump lump = {0};
  int side = 2 + pick(3), chance = 1 + pick(6);

  if (pick(2)) {
    for (int boxes = 1 + pick(5); boxes > 0; boxes--) {
      int x = pick(side), y = pick(side), z = pick(side);
      fill_box(&lump, x, y, z, x + 1 + pick(side), y + 1 + pick(side),
               z + 1 + pick(side));
    }
    return lump;
  }
  for (int i = 0; i < side * side * side; i++) {
    lump.cell[i / side / side][i / side % side][i % side] = pick(7) < chance;
  }
  lump.cell[0][0][0] = true;
  return lump;
}

static void
test_lumps(int rounds, bool turned, double most)
{
  unsigned bad = 0;

  for (int round = 0; round < rounds; round++) {
    cube_lump lump = random_lump();
    feature_counts want = lump_counts(&lump);
    sg_solid solid = lump_solid(&lump, (grouping)pick(3));
    if (turned) {
      place_at_random(&solid, 10);
    }
    shake(&solid, most * TOLERANCE);
    if (!merged_is(&solid, TOLERANCE, want.faces, want.vertices, want.edges)) {
      bad++;
      fprintf(stderr, "round %d: %zu faces, %zu vertices, %zu edges wanted\n",
              round, want.faces, want.vertices, want.edges);
    }
    sg_solid_clear(&solid);
  }
  CHECK("lumps have the faces, vertices and edges counted", bad == 0);
}

/* With features as small as the tolerance nothing is promised but this. */
static void
test_coarse(void)
{
  unsigned open = 0, failed = 0;

  for (int round = 0; round < 3000; round++) {
    cube_lump lump = random_lump();
    sg_solid solid = lump_solid(&lump, (grouping)pick(3));
    place_at_random(&solid, 10);
    shake(&solid, random_in(0, 0.6));
    failed += merge(&solid, random_in(0, 1)) != SG_MERGE_DONE;
    open += !is_closed(&solid);
    sg_solid_clear(&solid);
  }
  CHECK("coarse tolerances do not fail", failed == 0);
  CHECK("coarse tolerances open nothing", open == 0);
}

/* ---- what may be said ---------------------------------------------------- */

/* Two boxes side by side, of segments 1 and 2: flush all round. */
static sg_solid
two_segments(void)
{
  cube_lump lump = {0};

  fill_box(&lump, 0, 0, 0, 2, 1, 1);
  sg_solid solid = lump_solid(&lump, EACH_SQUARE);
  for (size_t f = 0; f < solid.faces; f++) {
    const uint32_t *c = solid.triangle[solid.face[f].first];
    double x = 0;
    for (int k = 0; k < 3; k++) {
      x += solid.vertex[c[k]].at[0] / 3;
    }
    solid.face[f].s = x > 1 ? 2 : 1;
    solid.face[f].reversed = x > 1;
  }
  return solid;
}

static void
test_options(void)
{
  sg_solid solid = two_segments();
  sg_merge_options options = {.tolerance = TOLERANCE};
  sg_merge_pair *pair;
  size_t n;

  CHECK("pairs",
        sg_face_merge_pairs(&solid, &options, &pair, &n) == SG_MERGE_DONE &&
            n == 4 && pair[0].one.s == 1 && pair[0].other.s == 2 &&
            pair[0].other.reversed);
  options.apart = pair + 1;
  options.aparts = 2;
  sg_merge_counts counts;
  CHECK("pairs that stay apart",
        sg_face_merge(&solid, &options, &counts) == SG_MERGE_DONE &&
            counts.faces_before == 10 && counts.faces_after == 8 &&
            counts.refused == 0 && is_closed(&solid));
  CHECK("what they came from", solid.parts == 2 && solid.part[0].s == 2 &&
                                   solid.part[0].reversed &&
                                   solid.face[solid.part[0].face].s == 1);
  free(pair);
  sg_solid_clear(&solid);
  solid = two_segments();
  options = (sg_merge_options){.tolerance = TOLERANCE, .separate = true};
  CHECK("segments that stay apart",
        sg_face_merge(&solid, &options, NULL) == SG_MERGE_DONE &&
            solid.faces == 10 && solid.vertices == 12);
  sg_solid_clear(&solid);
}

/* Vertices made by cuts keep their names. */
static void
test_names(void)
{
  cube_lump lump = pair_lump(1);
  sg_solid solid = lump_solid(&lump, EACH_TRIANGLE);
  size_t made = solid.vertices - 5;
  double at[5000][3];
  bool right = true;

  solid.plain = 5;
  solid.origin = malloc(made * sizeof *solid.origin);
  solid.origin_words = malloc(made * sizeof *solid.origin_words);
  if (!solid.origin || !solid.origin_words) {
    abort();
  }
  for (size_t i = 0; i < made; i++) {
    solid.origin_words[i] = (uint32_t)i + 5;
    solid.origin[i] = &solid.origin_words[i];
  }
  for (size_t v = 0; v < solid.vertices; v++) {
    memcpy(at[v], solid.vertex[v].at, sizeof at[v]);
  }
  add_vertex(&solid, 9, 9, 9); /* in no triangle */
  solid.vertices--;
  solid.plain = 5;
  merge(&solid, TOLERANCE);
  CHECK("some vertices vanished", has(&solid, 8, 12, 18) && solid.plain < 6);
  for (size_t v = solid.plain; v < solid.vertices; v++) {
    uint32_t was = *solid.origin[v - solid.plain];
    right = right && memcmp(at[was], solid.vertex[v].at, sizeof *at) == 0;
  }
  CHECK("the others have their names", right);
  sg_solid_clear(&solid);
}

static void
test_threads(void)
{
  unsigned different = 0;

  for (int round = 0; round < 60; round++) {
    cube_lump lump = random_lump();
    sg_solid solid = lump_solid(&lump, BY_CHANCE);
    place_at_random(&solid, 10);
    sg_solid other = copy_of(&solid);
    sg_merge_options options = {.tolerance = TOLERANCE,
                                .pool = sg_pool_open(2 + (unsigned)round % 3)};
    merge(&solid, TOLERANCE);
    sg_face_merge(&other, &options, NULL);
    different += !same_solid(&solid, &other);
    sg_pool_close(options.pool);
    sg_solid_clear(&solid);
    sg_solid_clear(&other);
  }
  CHECK("any number of threads gives the same", different == 0);
}

static bool
ask(void *data)
{
  return --*(int *)data < 0;
}

static void
test_stopped(void)
{
  unsigned changed = 0, stopped = 0;

  for (int after = 0; after < 60; after++) {
    cube_lump lump = pair_lump(1);
    sg_solid solid = lump_solid(&lump, EACH_TRIANGLE);
    sg_solid before = copy_of(&solid);
    int left = after;
    sg_cancel cancel = {ask, &left};
    sg_merge_options options = {.tolerance = TOLERANCE, .cancel = &cancel};
    if (sg_face_merge(&solid, &options, NULL) == SG_MERGE_STOPPED) {
      stopped++;
      changed += !same_solid(&solid, &before);
    }
    sg_solid_clear(&solid);
    sg_solid_clear(&before);
  }
  CHECK("stopped in between", stopped > 5);
  CHECK("stopped: as it was", changed == 0);
}

int
main(void)
{
  test_pairs();
  test_turned("turned pairs", 10, 0);
  test_turned("turned pairs with places off by half a tolerance", 1, 0.5);
  test_contacts_off();
  test_frame();
  test_lumps(5000, false, 0);
  test_lumps(5000, true, 0);
  test_lumps(1000, true, 0.4);
  test_coarse();
  test_options();
  test_names();
  test_threads();
  test_stopped();
  return check_report();
}
