/* hide_search_test.c -- the joins find what asking every triangle and every
 * line finds, and parts are the same for any number of threads.
 */
#include "model.h"
#include "picture/parts.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

static double
uniform(double low, double high)
{
  return low + (high - low) * (rand() / (double)RAND_MAX);
}

/* On a coarse grid half of the time, so that much touches and lies in line. */
static double
coordinate(bool coarse)
{
  return coarse ? rand() % 5 - 2 : uniform(-2, 2);
}

static void
random_triangles(model *m, bool coarse, int n)
{
  model_segment(m, false);
  for (int i = 0; i < n; i++) {
    int32_t v[3];
    for (int k = 0; k < 3; k++) {
      double x = coordinate(coarse), y = coordinate(coarse);
      v[k] = model_vertex(m, x, y, coordinate(coarse));
    }
    model_polygon(m, 3, v);
  }
}

static void
random_boxes(model *m, bool coarse, int n)
{
  for (int i = 0; i < n; i++) {
    double x = coordinate(coarse), y = coordinate(coarse);
    double z = coordinate(coarse);
    model_box(m, x, y, z, 1, coarse ? 1 + rand() % 2 : uniform(0.1, 2), 1);
  }
}

/* Long thin triangles along x, many of them from a few points. */
static void
random_fans(model *m, bool coarse, int n)
{
  double height = coarse ? 0.0625 : 0.03;

  model_segment(m, false);
  for (int i = 0; i < n; i++) {
    int32_t v[3] = {
        model_vertex(m, rand() % 3 - 1, height * (rand() % 2), rand() % 2)};

    for (int k = 1; k < 3; k++) {
      double x = coordinate(coarse) * 3, y = height * coordinate(coarse);
      v[k] = model_vertex(m, x, y, coordinate(coarse));
    }
    model_polygon(m, 3, v);
  }
}

static double
bumps(double x, double y)
{
  return 0.3 * sin(5 * x) * cos(4 * y);
}

static bool
same_hidden(const sg_hidden *a, const sg_hidden *b)
{
  return a->from == b->from && a->to == b->to && a->mask == b->mask;
}

enum { SEGMENTS = 32 };

/* Some segments let some be seen. */
static struct {
  bool is[SEGMENTS][SEGMENTS]; /* the first is seen through the second */
  sg_hide_through pair[SEGMENTS * SEGMENTS];
  sg_hide_throughs all;
} through;

static void
random_throughs(int32_t segments)
{
  through.all = (sg_hide_throughs){through.pair, 0};
  for (int32_t s = 1; s <= segments; s++) {
    for (int32_t s2 = 1; s2 <= segments; s2++) {
      through.is[s][s2] = rand() % 8 == 0;
      if (through.is[s][s2]) {
        through.pair[through.all.n++] = (sg_hide_through){s, s2};
      }
    }
  }
}

/* Whether the masks found for a line are all that hide it. */
static bool
all_masks(const sg_mask_grid *masks, size_t line, sg_seen *seen,
          sg_hiddens *found)
{
  const sg_scene *scene = masks->scene;
  size_t wanted = 0;

  if (!sg_mask_grid_ask(masks, line, &through.all, false, seen, found)) {
    return false;
  }
  for (size_t m = 0; m < scene->masks; m++) {
    sg_hidden part = {.mask = (uint32_t)m};
    bool there = false;
    if (through.is[scene->line[line].s][scene->mask[m].s] ||
        !sg_mask_hides(scene, &scene->mask[m], &scene->line[line], &part)) {
      continue;
    }
    wanted++;
    for (size_t i = 0; i < found->n && !there; i++) {
      there = same_hidden(&found->part[i], &part);
    }
    if (!there) {
      return false;
    }
  }
  return wanted == found->n;
}

/* The union of sorted parts, nearly touching ones made one, in their place. */
static size_t
united(sg_hidden *part, size_t n)
{
  size_t kept = 0;

  for (size_t i = 0; i < n; i++) {
    if (kept > 0 && part[i].from <= part[kept - 1].to + 1e-12) {
      part[kept - 1].to = fmax(part[kept - 1].to, part[i].to);
    } else {
      part[kept++] = part[i];
    }
  }
  return kept;
}

/* Whether some that are enough hide what all of them do. `all` are changed. */
static bool
enough_masks(const sg_mask_grid *masks, size_t line, sg_seen *seen,
             sg_hiddens *all, size_t *less)
{
  sg_hiddens some = {0};
  bool good = sg_mask_grid_ask(masks, line, &through.all, true, seen, &some) &&
              some.n <= all->n;

  *less += all->n - (good ? some.n : 0);
  size_t n = united(all->part, all->n), k = united(some.part, some.n);

  good = good && n == k;
  for (size_t i = 0; i < n && good; i++) {
    good = all->part[i].from == some.part[i].from &&
           all->part[i].to == some.part[i].to;
  }
  sg_hiddens_clear(&some);
  return good;
}

/* Whether the lines found for a line are all that overlap it. */
static bool
all_overlaps(const sg_line_grid *lines, size_t line, sg_seen *seen,
             sg_overlaps *found)
{
  const sg_scene *scene = lines->scene;
  size_t i = 0;

  if (!sg_line_grid_ask(lines, line, seen, found)) {
    return false;
  }
  for (size_t k = 0; k < scene->lines; k++) {
    sg_overlap part;
    if (k == line ||
        !sg_lines_overlap(scene, &scene->line[line], &scene->line[k], &part)) {
      continue;
    }
    if (i == found->n || found->part[i].line != k ||
        found->part[i].from != part.from || found->part[i].to != part.to) {
      return false;
    }
    i++;
  }
  return i == found->n;
}

static size_t left_out; /* masks that need not be asked */
static size_t tipped;   /* classes of long lines */
static size_t sorted; /* cells whose masks were sorted by how near they come */

static size_t
sorted_cells(const sg_mask_grid *masks)
{
  size_t n = 0;

  for (size_t c = 0; c < (size_t)masks->grid.nx * masks->grid.ny; c++) {
    n += masks->near[c] != NULL;
  }
  return n;
}

/* Every line of a scene is asked; *answers grows by what was found. */
static bool
finds_all(const sg_scene *scene, size_t *answers)
{
  uint32_t *every = malloc((scene->lines + 1) * sizeof *every);
  sg_seen seen_masks, seen_lines;
  sg_hiddens hiddens = {0};
  sg_overlaps overlaps = {0};
  sg_mask_grid masks;
  sg_line_grid lines;
  bool memory, good = true;

  for (size_t k = 0; k < scene->lines; k++) {
    every[k] = (uint32_t)k;
  }
  if (!sg_seen_init(&seen_masks, scene->masks) ||
      !sg_seen_init(&seen_lines, scene->lines) ||
      !sg_mask_grid_init(&masks, scene, NULL, &memory) ||
      !sg_line_grid_init(&lines, scene, every, scene->lines, NULL, &memory)) {
    abort();
  }
  for (size_t k = 0; k < scene->lines && good; k++) {
    good = all_masks(&masks, k, &seen_masks, &hiddens) &&
           all_overlaps(&lines, k, &seen_lines, &overlaps);
    *answers += hiddens.n + overlaps.n;
    good = good && enough_masks(&masks, k, &seen_masks, &hiddens, &left_out);
  }
  sorted += sorted_cells(&masks);
  for (size_t c = 0; c < SG_LINE_CLASSES; c++) {
    tipped += lines.tip[c].start != NULL;
  }
  sg_mask_grid_clear(&masks);
  sg_line_grid_clear(&lines);
  sg_seen_clear(&seen_masks);
  sg_seen_clear(&seen_lines);
  sg_hiddens_clear(&hiddens);
  free(overlaps.part);
  free(every);
  return good;
}

/* Some lines stand in, so that what is near them counts too. */
static void
let_stand_in(sg_scene *scene)
{
  for (size_t k = 0; k < scene->lines; k++) {
    scene->line[k].look.substitute_outline = rand() % 4 == 0;
  }
}

/* Long things that lie one way, across the axes of the picture. */
static void
shear(model *m)
{
  for (size_t i = 0; i < m->vertices; i++) {
    double *at = m->vertex[i].model;
    at[0] += 4 * at[1];
    at[2] += 3 * at[1];
  }
}

/* How many of these scenes are answered wrongly. */
static size_t
wrong_scenes(unsigned from, unsigned to, int triangles, int boxes, int fans,
             size_t *answers)
{
  size_t wrong = 0;

  for (unsigned seed = from; seed <= to; seed++) {
    model *m = model_new();
    bool coarse = seed % 2;
    sg_scene_model *seen;
    sg_scene *scene;

    srand(seed);
    random_triangles(m, coarse, triangles);
    random_boxes(m, coarse, boxes);
    random_fans(m, coarse, fans);
    if (seed % 3 == 0) {
      shear(m);
    }
    if (coarse) {
      model_project(m, 90 * (rand() % 4), 90 * (rand() % 3), 9, seed % 4 == 1);
    } else {
      model_project(m, uniform(0, 360), uniform(0, 180), 9, seed % 4 == 0);
    }
    scene = model_scene(m, NULL, &seen);
    let_stand_in(scene);
    random_throughs(m->s);
    if (!finds_all(scene, answers)) {
      fprintf(stderr, "scene %u\n", seed);
      wrong++;
    }
    sg_scene_close(scene);
    sg_scene_model_close(seen);
    free(m);
  }
  return wrong;
}

static void
random_scenes(void)
{
  size_t answers = 0;

  CHECK("joins find all", wrong_scenes(1, 200, 40, 6, 0, &answers) == 0);
  CHECK("and there was something to find", answers > 10000);
  sorted = 0;
  CHECK("also where very many lie behind one another",
        wrong_scenes(201, 212, 500, 20, 0, &answers) == 0);
  CHECK("which are sorted cell by cell", sorted > 100);
  tipped = 0;
  answers = 0;
  CHECK("also of long lines from a few points",
        wrong_scenes(301, 308, 0, 2, 250, &answers) == 0);
  CHECK("which are asked at their ends", tipped > 5 && answers > 10000);
}

/* What the first lines of a scene are told, as one number; 0: there is no
 * memory. */
static uint64_t
told(const sg_scene *scene)
{
  enum { ASKED = 40 };
  size_t n = scene->lines < ASKED ? scene->lines : ASKED;
  uint32_t line[ASKED];
  sg_seen seen_masks = {0}, seen_lines = {0};
  sg_hiddens hiddens = {0};
  sg_overlaps overlaps = {0};
  sg_mask_grid masks = {0};
  sg_line_grid lines = {0};
  uint64_t sum = 1;
  bool memory = true;

  for (size_t k = 0; k < n; k++) {
    line[k] = (uint32_t)(k * (scene->lines / n));
  }
  bool good = sg_seen_init(&seen_masks, scene->masks) &&
              sg_seen_init(&seen_lines, n) &&
              sg_mask_grid_init(&masks, scene, NULL, &memory) &&
              sg_line_grid_init(&lines, scene, line, n, NULL, &memory);

  good = good && memory;
  for (size_t k = 0; k < n && good; k++) {
    for (int enough = 0; enough < 2 && good; enough++) {
      good = sg_mask_grid_ask(&masks, line[k], NULL, enough, &seen_masks,
                              &hiddens);
      sum = sum * 31 + (enough ? 0 : hiddens.n);
      for (size_t i = 0; i < hiddens.n && !enough; i++) {
        sum = sum * 31 + hiddens.part[i].mask;
      }
    }
    good = good && sg_line_grid_ask(&lines, k, &seen_lines, &overlaps);
    for (size_t i = 0; i < overlaps.n; i++) {
      sum = sum * 31 + overlaps.part[i].line;
    }
  }
  if (masks.scene) {
    sg_mask_grid_clear(&masks);
  }
  if (lines.scene) {
    sg_line_grid_clear(&lines);
  }
  sg_seen_clear(&seen_masks);
  sg_seen_clear(&seen_lines);
  sg_hiddens_clear(&hiddens);
  free(overlaps.part);
  return good ? sum | 1 : 0;
}

static bool
is_told(const sg_scene *scene, uint64_t with)
{
  uint64_t sum = told(scene);

  return sum == 0 || sum == with;
}

static void
without_memory(void)
{
  for (int k = 0; k < 2; k++) {
    model *m = model_new();
    sg_scene_model *seen;

    srand(7);
    random_triangles(m, false, k ? 0 : 500);
    random_fans(m, false, k ? 250 : 0);
    model_project(m, 300, 65, 9, false);
    sg_scene *scene = model_scene(m, NULL, &seen);
    uint64_t with = told(scene);

    CHECK("told", with != 0);
    CHECK_REFUSED("told the same", is_told(scene, with));
    sg_scene_close(scene);
    sg_scene_model_close(seen);
    free(m);
  }
}

/* The parts of a scene, drawn by a thread pool. */
static sg_drawn_part *
parts_by(const sg_mask_grid *masks, unsigned threads, size_t *n)
{
  sg_drawing drawing = {.which = SG_LINES_ALL, .crease = 30.0};
  sg_pool *pool = threads ? sg_pool_open(threads) : NULL;
  sg_drawn_part *part;
  bool memory;

  if (!sg_parts_of(masks, &drawing, pool, NULL, &part, n, &memory)) {
    abort();
  }
  sg_pool_close(pool);
  return part;
}

static bool
same_parts(const sg_drawn_part *a, const sg_drawn_part *b, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    if (a[i].line != b[i].line || a[i].from != b[i].from ||
        a[i].to != b[i].to || a[i].hidden != b[i].hidden ||
        a[i].role != b[i].role) {
      return false;
    }
  }
  return true;
}

static void
threads(void)
{
  model *m = model_new();
  sg_scene_model *seen;
  sg_scene *scene;
  sg_mask_grid masks;
  sg_drawn_part *alone;
  size_t n, n2;
  bool memory, same = true;

  model_sheet(m, 60, bumps);
  model_project(m, 300, 65, 9, false);
  scene = model_scene(m, NULL, &seen);
  if (!sg_mask_grid_init(&masks, scene, NULL, &memory)) {
    abort();
  }
  alone = parts_by(&masks, 0, &n);
  for (unsigned k = 1; k <= 5; k++) {
    sg_drawn_part *part = parts_by(&masks, k, &n2);
    same = same && n == n2 && same_parts(alone, part, n);
    free(part);
  }
  CHECK("the same parts for any number of threads", same);
  CHECK("many", n > 10000);
  free(alone);
  sg_mask_grid_clear(&masks);
  sg_scene_close(scene);
  sg_scene_model_close(seen);
  free(m);
}

/* Triangles over half of the picture, all in one place. */
static void
large_shape(const void *data, size_t i, sg_grid_shape *out)
{
  (void)data, (void)i;
  *out = (sg_grid_shape){3, {{-1, -1}, {1, -1}, {-1, 1}}};
}

/* So many that as many cells would be entered more than 2^32 times. */
static void
large_items(void)
{
  enum { N = 120000 };
  sg_grid grid;
  bool memory, done = sg_grid_init(&grid, N, large_shape, NULL, NULL, 1e-7,
                                   false, NULL, &memory);
  size_t entries = done ? grid.start[(size_t)grid.nx * grid.ny] : 0;

  CHECK("many large items have wide cells",
        entries >= N && entries <= 128 * (size_t)N && grid.nx > 1);
  CHECK("each is there",
        done && grid.item[0] == 0 && grid.item[N - 1] == N - 1);
  sg_grid_clear(&grid);
}

static void
thin_shape(const void *data, size_t i, sg_grid_shape *out)
{
  double x = (double)(i * 7919 % 100) / 100, y = (double)(i * 104729 % 97) / 97;

  (void)data;
  *out = (sg_grid_shape){3, {{x, y}, {x + 0.3, y + 0.2}, {x - 0.01, y + 0.25}}};
}

static void
thin_box(const void *data, size_t i, sg_grid_box *out)
{
  sg_grid_shape shape;

  thin_shape(data, i, &shape);
  *out = (sg_grid_box){{shape.at[2][0], shape.at[0][1]},
                       {shape.at[1][0], shape.at[2][1]}};
}

/* Boxes that are known make the same grid. */
static void
known_boxes(void)
{
  enum { N = 300 };
  sg_grid from_shape, from_box;
  bool memory;
  bool done = sg_grid_init(&from_shape, N, thin_shape, NULL, NULL, 1e-7, false,
                           NULL, &memory) &&
              sg_grid_init(&from_box, N, thin_shape, thin_box, NULL, 1e-7,
                           false, NULL, &memory);
  size_t cells = done ? (size_t)from_shape.nx * from_shape.ny : 0;

  CHECK("known boxes: cells",
        done && from_box.nx == from_shape.nx && from_box.ny == from_shape.ny &&
            memcmp(from_box.start, from_shape.start,
                   (cells + 1) * sizeof *from_box.start) == 0);
  CHECK("known boxes: items",
        done && memcmp(from_box.item, from_shape.item,
                       from_shape.start[cells] * sizeof *from_box.item) == 0);
  sg_grid_clear(&from_shape);
  sg_grid_clear(&from_box);
}

int
main(void)
{
  known_boxes();
  random_scenes();
  without_memory();
  CHECK("some masks are enough", left_out > 100);
  threads();
  large_items();
  return check_report();
}
