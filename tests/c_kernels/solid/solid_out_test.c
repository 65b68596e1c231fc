/* solid_out_test.c -- rows of solids: borders against a count, cells in their
 * places whatever the number of threads. */
#include "solid/solid_border.h"
#include "solid/solid_out.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint64_t seed = 1;

static uint32_t
draw(uint32_t n)
{
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(seed >> 33) % n;
}

/* ---- solids ------------------------------------------------------------- */

enum { VERTICES = 3000, TRIANGLES = 40000, FACES = 40000 };

static sg_solid_vertex vertex[VERTICES];
static uint32_t triangle[TRIANGLES][3];
static uint8_t auxiliary[TRIANGLES];
static sg_solid_face face[FACES];
static struct sg_solid_part parts[FACES];

/* Faces of random triangles on few vertices, so that half-edges meet, and meet
 * more than once; most faces are one triangle. */
static sg_solid
random_solid(size_t triangles, uint32_t vertices, uint32_t largest)
{
  sg_solid solid = {.vertex = vertex,
                    .vertices = vertices,
                    .plain = vertices,
                    .triangle = triangle,
                    .auxiliary = auxiliary,
                    .face = face};

  for (uint32_t i = 0; i < vertices; i++) {
    vertex[i] = (sg_solid_vertex){{draw(9), draw(9), -0.0}, 7, (int32_t)i + 1};
  }
  while (solid.triangles < triangles) {
    uint32_t n = draw(3) ? 1 : 1 + draw(largest);
    uint32_t few = 3 + draw(vertices - 3), low = draw(vertices - few + 1);
    n = solid.triangles + n > triangles
            ? (uint32_t)(triangles - solid.triangles)
            : n;
    face[solid.faces] = (sg_solid_face){7, (int32_t)solid.faces + 1, draw(2),
                                        (uint32_t)solid.triangles, n};
    solid.faces++;
    for (uint32_t i = 0; i < n; i++) {
      uint32_t a = draw(few), b = (a + 1 + draw(few - 1)) % few, c;
      do {
        c = draw(few);
      } while (c == a || c == b);
      uint32_t *t = triangle[solid.triangles];
      t[0] = low + a, t[1] = low + b, t[2] = low + c;
      auxiliary[solid.triangles++] = (uint8_t)draw(8);
    }
  }
  return solid;
}

/* ---- borders ------------------------------------------------------------ */

/* How many half-edges from a to b of face f have this bit. */
static int
count(const sg_solid *solid, size_t f, const uint8_t *bits, uint32_t a,
      uint32_t b)
{
  int n = 0;

  for (uint32_t t = 0; t < solid->face[f].n; t++) {
    const uint32_t *v = solid->triangle[solid->face[f].first + t];
    for (int k = 0; k < 3; k++) {
      n += v[k] == a && v[(k + 1) % 3] == b &&
           (!bits || bits[solid->face[f].first + t] >> k & 1);
    }
  }
  return n;
}

/* Of the half-edges of an edge those are left that are more in one way. */
static bool
border_is_right(const sg_solid *solid, size_t f, const uint8_t *bits,
                uint32_t edges)
{
  uint32_t n = 0;

  for (uint32_t t = 0; t < solid->face[f].n; t++) {
    const uint32_t *v = solid->triangle[solid->face[f].first + t];
    n += (uint32_t)__builtin_popcount(bits[solid->face[f].first + t]);
    for (int k = 0; k < 3; k++) {
      uint32_t a = v[k], b = v[(k + 1) % 3];
      int there = count(solid, f, NULL, a, b),
          back = count(solid, f, NULL, b, a);
      if (count(solid, f, bits, a, b) != (there > back ? there - back : 0)) {
        return false;
      }
    }
  }
  return n == edges;
}

static void
test_borders(void)
{
  static uint8_t bits[TRIANGLES];
  sg_border scratch = {0};
  bool right = true;
  uint32_t n;

  for (int round = 0; round < 60; round++) {
    sg_solid solid = random_solid(300, 4 + draw(30), 2 + draw(60));
    for (size_t f = 0; f < solid.faces && right; f++) {
      right = sg_border_find(&scratch, &solid, f, bits, &n) &&
              border_is_right(&solid, f, bits, n);
    }
  }
  CHECK("borders of random faces", right);
  sg_border_clear(&scratch);
}

/* ---- cells -------------------------------------------------------------- */

static const struct {
  int columns;
  const char *type;
} shape[7] = {{5, "iifff"},  {5, "iiiii"}, {3, "iil"},  {6, "iiffff"},
              {6, "iiiiii"}, {4, "iiii"},  {5, "iiiii"}};

/* Sheets with room, beginning somewhere on a page. */
typedef struct room {
  sg_sheet sheet;
  char *memory[SG_MAX_COLUMNS];
} room;

static size_t
size_of(char type)
{
  return type == 'i' ? sizeof(int32_t) : sizeof(double);
}

static void
room_open(room *r, int k, size_t n, unsigned place)
{
  *r = (room){.sheet = {.rows = 0, .place = place}};
  r->sheet.page = calloc(n / SG_PAGE_ROWS + 3, sizeof *r->sheet.page);
  for (int c = 0; c < shape[k].columns; c++) {
    r->memory[c] = calloc(n + 1, size_of(shape[k].type[c]));
  }
  while (r->sheet.rows < n) {
    sg_sheet_page *page = &r->sheet.page[r->sheet.pages++];
    size_t left = SG_PAGE_ROWS - (place + r->sheet.rows) % SG_PAGE_ROWS;
    page->from = r->sheet.rows;
    page->n = n - page->from < left ? n - page->from : left;
    for (int c = 0; c < shape[k].columns; c++) {
      page->column[c].i =
          (int32_t *)(void *)(r->memory[c] +
                              page->from * size_of(shape[k].type[c]));
    }
    r->sheet.rows += page->n;
  }
}

static void
room_close(room *r)
{
  for (int c = 0; c < SG_MAX_COLUMNS; c++) {
    free(r->memory[c]);
  }
  free(r->sheet.page);
}

typedef struct result {
  sg_solid_rows rows;
  room room[7]; /* v, e, p, plane, t, from_v, from_p */
  int32_t *lists;
  size_t planes, sources;
} result;

static int32_t
int_of(const room *r, int c, size_t i)
{
  return ((const int32_t *)(const void *)r->memory[c])[i];
}

static double
float_of(const room *r, int c, size_t i)
{
  return ((const double *)(const void *)r->memory[c])[i];
}

static bool
write_cells(result *r, sg_pool *pool, const sg_cancel *cancel)
{
  const sg_solid_sheets sheets = {&r->room[0].sheet, &r->room[1].sheet,
                                  &r->room[2].sheet, &r->room[3].sheet,
                                  &r->room[4].sheet, &r->room[5].sheet,
                                  &r->room[6].sheet};

  return sg_solid_rows_write(&r->rows, 9, pool, cancel, &sheets, &r->planes,
                             &r->sources);
}

static bool
make_result(const sg_solid *solid, unsigned threads, unsigned place,
            result *out)
{
  sg_pool *pool = sg_pool_open(threads);
  bool good = sg_solid_rows_make(solid, pool, NULL, &out->rows);
  size_t edges = out->rows.edge[solid->faces];
  const size_t n[7] = {out->rows.vertices,
                       edges,
                       solid->faces,
                       solid->faces,
                       solid->triangles,
                       out->rows.plain,
                       solid->faces + solid->parts};

  for (int k = 0; k < 7; k++) {
    room_open(&out->room[k], k, n[k], place);
  }
  out->lists = calloc(edges + solid->faces + 1, sizeof *out->lists);
  for (size_t f = 0; f < solid->faces; f++) {
    int32_t *list = out->lists + out->rows.edge[f] + f;
    list[0] = (int32_t)(out->rows.edge[f + 1] - out->rows.edge[f]);
    memcpy(out->room[2].memory[2] + f * sizeof list, &list, sizeof list);
  }
  good = good && write_cells(out, pool, NULL);
  sg_pool_close(pool);
  return good;
}

static void
drop_result(result *r)
{
  for (int k = 0; k < 7; k++) {
    room_close(&r->room[k]);
  }
  free(r->lists);
  sg_solid_rows_clear(&r->rows);
}

static bool
is_same(const result *a, const result *b)
{
  bool same = a->planes == b->planes && a->sources == b->sources;

  for (int k = 0; k < 7; k++) {
    for (int c = 0; c < shape[k].columns; c++) {
      same =
          same && (shape[k].type[c] == 'l' ||
                   !memcmp(a->room[k].memory[c], b->room[k].memory[c],
                           a->room[k].sheet.rows * size_of(shape[k].type[c])));
    }
  }
  return same;
}

/* Every polygon has the border of its face, ids are dense, lists fit. */
static bool
rows_are_right(const sg_solid *solid, const result *r)
{
  int32_t e = 0;
  bool right = true;

  for (size_t f = 0; f < solid->faces && right; f++) {
    const int32_t *list = r->lists + r->rows.edge[f] + f;
    right = int_of(&r->room[2], 1, f) == (int32_t)f + 1;
    for (int32_t i = 1; i <= list[0] && right; i++) {
      right = list[i] == ++e && int_of(&r->room[1], 1, (size_t)e - 1) == e;
    }
  }
  for (size_t i = 0; i < r->rows.vertices && right; i++) {
    const sg_solid_vertex *v = &solid->vertex[r->rows.vertex[i]];
    right = int_of(&r->room[0], 1, i) == (int32_t)i + 1 &&
            float_of(&r->room[0], 2, i) == v->at[0] &&
            !signbit(float_of(&r->room[0], 4, i)) &&
            int_of(&r->room[5], 3, i) == v->v;
  }
  for (size_t f = 0, t = 0; f < solid->faces; f++) {
    for (uint32_t i = 0; i < solid->face[f].n && right; i++, t++) {
      const uint32_t *v = solid->triangle[solid->face[f].first + i];
      right = int_of(&r->room[4], 1, t) == (int32_t)f + 1 &&
              int_of(&r->room[4], 2, t) == (int32_t)t + 1 &&
              int_of(&r->room[4], 5, t) == r->rows.id[v[2]];
    }
  }
  for (size_t i = 0; i + 1 < r->planes && right; i++) {
    right = int_of(&r->room[3], 1, i) > 0 &&
            int_of(&r->room[3], 1, i) < int_of(&r->room[3], 1, i + 1);
  }
  return right && e == (int32_t)r->rows.edge[solid->faces];
}

static void
test_rows(void)
{
  static const unsigned threads[3] = {1, 2, 5};
  sg_solid solid = random_solid(TRIANGLES, VERTICES, 4);
  result first, other;

  CHECK("made", make_result(&solid, 1, 17, &first));
  CHECK("right", rows_are_right(&solid, &first));
  CHECK("a source a face", first.sources == solid.faces);
  for (int k = 0; k < 3; k++) {
    CHECK("made again",
          make_result(&solid, threads[k], 17 + (unsigned)k, &other));
    CHECK("the same with other threads, elsewhere", is_same(&first, &other));
    drop_result(&other);
  }
  drop_result(&first);
}

/* Merged faces: each source once, in order, that of the face among them. */
static void
test_parts(void)
{
  sg_solid solid = random_solid(60, 10, 4);
  result r;

  face[1] = (sg_solid_face){5, 50, true, face[1].first, face[1].n};
  parts[0] = (struct sg_solid_part){1, 6, 3, true};
  parts[1] = (struct sg_solid_part){1, 5, 60, false};
  parts[2] = (struct sg_solid_part){1, 6, 3, true};
  parts[3] = (struct sg_solid_part){1, 5, 50, true};
  solid.part = parts;
  solid.parts = 4;
  CHECK("made", make_result(&solid, 1, 0, &r));
  CHECK("two more sources", r.sources == solid.faces + 2);
  CHECK("in order",
        int_of(&r.room[6], 1, 0) == 1 && int_of(&r.room[6], 1, 1) == 2 &&
            int_of(&r.room[6], 3, 1) == 50 && int_of(&r.room[6], 4, 1) == -1 &&
            int_of(&r.room[6], 3, 2) == 60 && int_of(&r.room[6], 4, 2) == 1 &&
            int_of(&r.room[6], 2, 3) == 6 && int_of(&r.room[6], 1, 4) == 3);
  drop_result(&r);
}

static bool
stop(void *asked)
{
  return ++*(int *)asked > 1;
}

static void
test_stopped(void)
{
  sg_solid solid = random_solid(TRIANGLES, VERTICES, 4);
  sg_solid_rows rows;
  int asked = 0;
  sg_cancel cancel = {stop, &asked};
  result r;

  CHECK("stopped", !sg_solid_rows_make(&solid, NULL, &cancel, &rows));
  CHECK("asked", asked > 1);
  sg_solid_rows_clear(&rows);
  asked = 0;
  CHECK("made", make_result(&solid, 1, 0, &r));
  CHECK("stopped when writing", !write_cells(&r, NULL, &cancel) && asked > 1);
  drop_result(&r);
}

int
main(void)
{
  test_borders();
  test_rows();
  test_parts();
  test_stopped();
  return check_report();
}
