/* hide_near_test.c -- what hides, nearest first, in a scene and in each cell of
 * its grid, for all numbers of triangles that face the eye, and of those that
 * are turned away, and so are no masks.
 */
#include "model.h"
#include "picture/hide_search_private.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>

static uint32_t seed = 5;

static double
number(double from, double to)
{
  return from + (to - from) * check_below(&seed, 4096) / 4096.0;
}

/* A pyramid on or below a triangle: three sides face the eye, or it alone.
 * Depths come again and again. */
static void
add_pyramid(model *m, bool up)
{
  double x = number(-9, 9), y = number(-9, 9), z = check_below(&seed, 40) / 8.0;
  int32_t a = model_vertex(m, x, y, z), b = model_vertex(m, x + 2, y, z);
  int32_t c = model_vertex(m, x, y + 2, z);
  int32_t top = model_vertex(m, x + 0.5, y + 0.5, z + (up ? 1 : -1));
  int32_t p = up ? b : a, q = up ? a : b;

  model_polygon(m, 3, (int32_t[]){p, q, c});
  model_polygon(m, 3, (int32_t[]){q, p, top});
  model_polygon(m, 3, (int32_t[]){c, q, top});
  model_polygon(m, 3, (int32_t[]){p, c, top});
}

/* So many of both, mixed. */
static model *
pyramids(int down, int up)
{
  model *m = model_new();

  model_segment(m, true);
  while (down + up > 0) {
    bool next = check_below(&seed, down + up) < up;
    add_pyramid(m, next);
    up -= next;
    down -= !next;
  }
  model_project(m, 270, 0, 9, false);
  return m;
}

/* Each front once, nearest first, those of one depth in their own order. */
static bool
masks_in_order(const sg_scene *scene, int n)
{
  bool good = scene->masks == (size_t)n;

  for (size_t i = 1; good && i < scene->masks; i++) {
    const sg_scene_mask *a = &scene->mask[i - 1], *b = &scene->mask[i];
    good =
        a->low[2] < b->low[2] ||
        (fabs(a->low[2] - b->low[2]) < 1e-6 &&
         ((float)a->low[2] != (float)b->low[2] || a->triangle < b->triangle));
  }
  return good;
}

static int
compare_items(const void *a, const void *b)
{
  const uint32_t *x = a, *y = b;

  return (*x > *y) - (*x < *y);
}

/* The nearest corner of a mask, counted from a plane. */
static double
nearest_corner(const sg_mask_grid *masks, uint32_t m,
               const sg_near_plane *plane)
{
  const sg_scene *scene = masks->scene;
  double least = INFINITY;

  for (int k = 0; k < 3; k++) {
    const double *at = scene->at[scene->mask[m].v[k]];
    sg_grid_shape shape = {1, {{at[0], at[1]}}};

    sg_turn_shape(masks->way, &shape);
    least = fmin(least, at[2] - sg_plane_depth(plane, shape.at[0]));
  }
  return least;
}

/* Whether a mask, if it is one, is among sorted ones. */
static bool
is_among(uint32_t m, const uint32_t *item, size_t n)
{
  return m == SG_NO_MASK ||
         bsearch(&m, item, n, sizeof *item, compare_items) != NULL;
}

/* Nearest first, none nearer than its corners; what is behind the one that
 * covers the cell comes last, in any order. */
static bool
depths_in_order(const sg_mask_grid *masks, const sg_mask_near *near)
{
  uint64_t last = near->front > 0 ? near->order[near->front - 1] >> 32 : 0;
  bool good = near->front <= near->n &&
              (near->cover != SG_NO_MASK || near->front == near->n);

  for (size_t i = 0; good && i < near->n; i++) {
    uint64_t depth = near->order[i] >> 32;
    uint32_t m = (uint32_t)near->order[i];

    good = m < masks->scene->masks &&
           (i == 0 || i >= near->front || near->order[i - 1] >> 32 <= depth) &&
           (i < near->front || depth >= last) &&
           depth >= sg_depth_order(sg_float_below(
                        nearest_corner(masks, m, &near->plane) - 1e-9));
  }
  return good;
}

/* A cell has the masks that its grid says. */
static bool
cell_in_order(const sg_mask_grid *masks, size_t cell)
{
  const sg_grid *grid = &masks->grid;
  const uint32_t *item = grid->item + grid->start[cell];
  size_t n = grid->start[cell + 1] - grid->start[cell];
  const sg_mask_near *near = sg_mask_grid_near(masks, cell);
  uint32_t *found = calloc(n + 1, sizeof *found);
  uint32_t *wanted = calloc(n + 1, sizeof *wanted);
  bool good = near && near->n == n && depths_in_order(masks, near);

  for (size_t i = 0; good && i < n; i++) {
    found[i] = (uint32_t)near->order[i];
    wanted[i] = item[i];
  }
  qsort(found, n, sizeof *found, compare_items);
  qsort(wanted, n, sizeof *wanted, compare_items);
  good = good && memcmp(found, wanted, n * sizeof *found) == 0 &&
         is_among(near->cover, wanted, n);
  for (int k = 0; good && k < SG_SEEN_PLACES; k++) {
    good = is_among(near->seen[k], wanted, n);
  }
  free(found);
  free(wanted);
  return good;
}

static void
ordered(int down, int up)
{
  model *m = pyramids(down, up);
  sg_scene_model *seen;
  sg_scene *scene = model_scene(m, NULL, &seen);
  sg_mask_grid masks;
  bool memory, good = true;

  CHECK("a scene", scene && masks_in_order(scene, down + 3 * up));
  CHECK("a grid", sg_mask_grid_init(&masks, scene, NULL, &memory));
  for (size_t cell = 0; good && cell < (size_t)masks.grid.nx * masks.grid.ny;
       cell++) {
    good = cell_in_order(&masks, cell) && cell_in_order(&masks, cell);
  }
  CHECK("cells in order", good);
  sg_mask_grid_clear(&masks);
  sg_scene_close(scene);
  sg_scene_model_close(seen);
  free(m);
}

/* The float below is that of the C library. */
static void
floats_below(void)
{
  const double some[] = {0.0,       -0.0,     1.0,       -1.0,     0.1,
                         -0.1,      1e-46,    -1e-46,    1e-45,    -1e-45,
                         1e-40,     -1e-40,   3e38,      -3e38,    1.0 / 3,
                         -1.0 / 3,  16777217, -16777217, 1 + 1e-9, 1 - 1e-9,
                         -1 + 1e-9, -1 - 1e-9};

  for (size_t i = 0; i < sizeof some / sizeof *some; i++) {
    float below = sg_float_below(some[i]), next = nextafterf(below, INFINITY);
    CHECK("float below", (double)below <= some[i] && (double)next > some[i]);
  }
  CHECK("none below infinity", sg_float_below(-INFINITY) == -INFINITY);
}

int
main(void)
{
  floats_below();
  static const int size[] = {0, 1, 2, 3, 7, 30, 300, 2000};
  enum { SIZES = sizeof size / sizeof *size };

  for (int i = 0; i < SIZES; i++) {
    for (int j = 0; j < SIZES; j++) {
      ordered(size[i], size[j]);
    }
  }
  return check_report();
}
