/* crease_test.c -- creases of meshes that fade: a roof whose ridge bends by so
 * many degrees as the test says at its vertices.
 */
#include "model.h"
#include "picture/crease.h"
#include "tests/memory/refusals.h"

enum { CELLS = 20 };

/* Degrees that the ridge bends at each of its vertices but the last; the height
 * of the roof is made of it. */
static double ridge[CELLS];

/* How long a triangle beside the roof is, 0: there is none. */
static double beside_roof;

/* A roof of two rows of long cells; each has two triangles. */
static sg_scene_model *
model_of_roof(void)
{
  model *m = model_new();
  sg_scene_model *made;

  model_segment(m, false);
  for (int i = 0; i <= CELLS; i++) {
    double half = ridge[i < CELLS ? i : CELLS - 1] / 360.0 * acos(-1.0);
    for (int y = -1; y <= 1; y++) {
      model_vertex(m, 10.0 * i, y, -abs(y) * tan(half));
    }
  }
  for (int32_t a = 1; a + 4 <= m->v; a += a % 3 == 1 ? 1 : 2) {
    model_polygon(m, 3, (int32_t[]){a, a + 3, a + 4});
    model_polygon(m, 3, (int32_t[]){a, a + 4, a + 1});
  }
  if (beside_roof > 0.0) {
    int32_t v[3] = {model_vertex(m, 0, 9, 0),
                    model_vertex(m, beside_roof, 9, 0),
                    model_vertex(m, 0, 10, 0)};
    model_polygon(m, 3, v);
  }
  made = model_scene_model(m, NULL);
  free(m);
  return made;
}

/* Whether a line runs along the ridge, and its step. */
static bool
is_ridge(const sg_scene_model *m, size_t k, int *step)
{
  const double *a = m->dense.at[m->line[k].a], *b = m->dense.at[m->line[k].b];

  *step = (int)((a[0] < b[0] ? a[0] : b[0]) / 10.0);
  return a[1] == 0.0 && b[1] == 0.0;
}

/* What was found: a letter for each step of the ridge. '^' sharp, '-' a crease
 * goes on there, '.' neither, 'x' a speck; elsewhere: *beside counts what goes
 * on. */
static void
found(char text[CELLS + 1], int *beside)
{
  sg_scene_model *m = model_of_roof();
  uint8_t *as;
  bool memory;

  CHECK("done", sg_creases_find(m, NULL, 30.0, NULL, &as, &memory) && memory);
  memset(text, '?', CELLS);
  text[CELLS] = 0;
  *beside = 0;
  for (size_t k = 0; k < m->lines; k++) {
    int step;
    if (is_ridge(m, k, &step)) {
      text[step] = as[k] == SG_CREASE_SPECK ? 'x'
                   : as[k] == SG_CREASE_ON  ? '-'
                   : m->line[k].bend > 30   ? '^'
                                            : '.';
    } else {
      *beside += as[k] == SG_CREASE_ON;
    }
  }
  free(as);
  sg_scene_model_close(m);
}

/* Checks what is found on a ridge that bends so much at its vertices; the last
 * one is as the one before. */
static void
on_ridge(const char *name, const char *expected, const double bends[CELLS])
{
  char text[CELLS + 1];
  int beside;

  memcpy(ridge, bends, sizeof ridge);
  found(text, &beside);
  CHECK(name, strcmp(text, expected) == 0);
  CHECK("nothing beside the ridge goes on", beside == 0);
  if (strcmp(text, expected) != 0) {
    fprintf(stderr, "%s: %s, expected %s\n", name, text, expected);
  }
}

static const double fading[CELLS] = {60, 60, 60, 60, 60, 60, 27, 27, 24, 24,
                                     18, 18, 14, 14, 5,  5,  2,  2,  0,  0};
static const double gap[CELLS] = {60, 60, 60, 60, 40, 28, 20, 14, 10, 7,
                                  7,  10, 14, 20, 28, 40, 60, 60, 60, 60};
static const double wide_gap[CELLS] = {60, 60, 40, 24, 14, 8,  4,  4,  4,  4,
                                       4,  4,  4,  8,  14, 24, 40, 60, 60, 60};
static const double apart[CELLS] = {0,  0,  0, 0, 0, 0, 0, 0, 5, 20,
                                    50, 20, 5, 0, 0, 0, 0, 0, 0, 0};
static const double flat[CELLS] = {29, 29, 29, 29, 29, 29, 29, 29, 29, 29,
                                   29, 29, 29, 29, 29, 29, 29, 29, 29, 29};

static void
test_ridges(void)
{
  on_ridge("down to a third of the angle", "^^^^^^-------.......", fading);
  on_ridge("a gap is closed", "^^^^^---------^^^^^^", gap);
  on_ridge("a wide gap is none", "^^^--........--^^^^^", wide_gap);
  on_ridge("a crease that ends on both sides", ".........^^.........", apart);
  beside_roof = 1990.0;
  on_ridge("as long as a hundredth", ".........^^.........", apart);
  beside_roof = 2010.0;
  on_ridge("a speck", ".........xx.........", apart);
  on_ridge("a crease at a border is none", "^^^^^^-------.......", fading);
  beside_roof = 0.0;
  on_ridge("nothing begins below the angle", "....................", flat);
}

/* With each allocation refused. */
static void
test_refused(void)
{
  sg_scene_model *m;
  uint8_t *as = NULL;
  bool memory = false, done = false;

  memcpy(ridge, fading, sizeof ridge);
  m = model_of_roof();
  for (long n = 0; is_counted() && !done; n++) {
    left = n;
    living = 0;
    counting = true;
    done = sg_creases_find(m, NULL, 30.0, NULL, &as, &memory);
    counting = false;
    left = -1;
    CHECK("done, or no memory", done == memory);
    CHECK("nothing is left of what was refused", done || living == 0);
  }
  free(done ? as : NULL);
  CHECK("an angle that shows all facets",
        sg_creases_find(m, NULL, 0.5, NULL, &as, &memory) && memory && !as);
  sg_scene_model_close(m);
}

int
main(void)
{
  spare_gmp();
  test_ridges();
  test_refused();
  return check_report();
}
