/* face_merge_sheet.c -- which triangles meet: see face_merge_sheet.h.
 *
 * Layer: kernel. What is near is told by a grid, a look at each triangle; then
 * self_cut.h does the rest.
 */
#include "face_merge_sheet.h"

#include "engine/list.h"
#include "engine/search.h"
#include "join/self_cut.h"
#include "rows/key_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS = 64 }; /* along an axis; the last axis is a word */

/* A bit for each cell that the box of a triangle asked about reaches. */
struct sg_sheet_grid {
  double low[3], high[3], scale[3];
  uint64_t cell[CELLS][CELLS];
};

static bool
make_room(sg_sheet *sheet)
{
  size_t room = sheet->room; /* of both */

  return sg_list_grow(&sheet->corner, sheet->n, &room, sizeof *sheet->corner) &&
         sg_list_grow(&sheet->key, sheet->n, &sheet->room, sizeof *sheet->key);
}

bool
sg_sheet_add(sg_sheet *sheet, const uint32_t corner[3], uint32_t key)
{
  if (!make_room(sheet)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    sheet->corner[sheet->n][k] = (int32_t)corner[k];
  }
  sheet->key[sheet->n++] = key;
  return true;
}

/* ---- what is near ------------------------------------------------------- */

static void
find_box(const sg_merge *m, const uint32_t corner[3], double low[3],
         double high[3])
{
  const double *a = sg_merge_at(m, corner[0]), *b = sg_merge_at(m, corner[1]);
  const double *c = sg_merge_at(m, corner[2]);

  for (int k = 0; k < 3; k++) {
    low[k] = a[k] < b[k] ? a[k] : b[k];
    low[k] = c[k] < low[k] ? c[k] : low[k];
    high[k] = a[k] > b[k] ? a[k] : b[k];
    high[k] = c[k] > high[k] ? c[k] : high[k];
  }
}

static int
cell_of(const sg_sheet_grid *grid, int k, double x)
{
  double cell = (x - grid->low[k]) * grid->scale[k];

  return cell >= CELLS - 1 ? CELLS - 1 : cell > 0 ? (int)cell : 0;
}

/* The cells that the box of a triangle reaches; false: none. */
static bool
find_cells(const sg_sheet *sheet, const uint32_t corner[3], int from[3],
           int to[3], uint64_t *bits)
{
  const sg_sheet_grid *grid = sheet->grid;
  double low[3], high[3];

  find_box(sheet->m, corner, low, high);
  for (int k = 0; k < 3; k++) {
    if (low[k] > grid->high[k] || high[k] < grid->low[k]) {
      return false;
    }
    from[k] = cell_of(grid, k, low[k]);
    to[k] = cell_of(grid, k, high[k]);
  }
  *bits = ~(uint64_t)0 >> (CELLS - 1 - to[2]) & ~(uint64_t)0 << from[2];
  return true;
}

bool
sg_sheet_is_near(const sg_sheet *sheet, const uint32_t corner[3])
{
  int from[3], to[3];
  uint64_t bits;

  if (!find_cells(sheet, corner, from, to, &bits)) {
    return false;
  }
  for (int i = from[0]; i <= to[0]; i++) {
    for (int j = from[1]; j <= to[1]; j++) {
      if (sheet->grid->cell[i][j] & bits) {
        return true;
      }
    }
  }
  return false;
}

static void
size_grid(sg_sheet *sheet)
{
  sg_sheet_grid *grid = sheet->grid;
  double low[3], high[3];

  for (int k = 0; k < 3; k++) {
    grid->low[k] = INFINITY;
    grid->high[k] = -INFINITY;
  }
  for (size_t t = 0; t < sheet->n; t++) {
    find_box(sheet->m, (const uint32_t *)sheet->corner[t], low, high);
    for (int k = 0; k < 3; k++) {
      grid->low[k] = fmin(grid->low[k], low[k]);
      grid->high[k] = fmax(grid->high[k], high[k]);
    }
  }
  for (int k = 0; k < 3; k++) {
    double size = grid->high[k] - grid->low[k];
    grid->scale[k] = size > 0 ? CELLS / size : 0;
  }
}

bool
sg_sheet_mark(sg_sheet *sheet)
{
  int from[3], to[3];
  uint64_t bits;

  sheet->asked = sheet->n;
  sheet->grid = calloc(1, sizeof *sheet->grid);
  if (!sheet->grid) {
    return false;
  }
  size_grid(sheet);
  for (size_t t = 0; t < sheet->n; t++) {
    find_cells(sheet, (const uint32_t *)sheet->corner[t], from, to, &bits);
    for (int i = from[0]; i <= to[0]; i++) {
      for (int j = from[1]; j <= to[1]; j++) {
        sheet->grid->cell[i][j] |= bits;
      }
    }
  }
  return true;
}

/* ---- what meets --------------------------------------------------------- */

/* Numbers the vertices that are used from 0; returns how many there are. Null:
 * no memory. Owner: caller, free(). */
static double (*take_vertices(sg_sheet *sheet, size_t *n))[3]
{
  size_t all = sheet->m->solid->vertices;
  uint32_t *number = malloc((all + 1) * sizeof *number);
  double(*at)[3] = malloc((3 * sheet->n + 1) * sizeof *at);

  *n = 0;
  if (!number || !at) {
    free(number);
    free(at);
    return NULL;
  }
  memset(number, 0xff, all * sizeof *number);
  for (size_t i = 0; i < 3 * sheet->n; i++) {
    int32_t *corner = &sheet->corner[i / 3][i % 3];
    uint32_t *to = &number[*corner];
    if (*to == SG_NOTHING) {
      *to = (uint32_t)*n;
      memcpy(at[(*n)++], sg_merge_at(sheet->m, (uint32_t)*corner), sizeof *at);
    }
    *corner = (int32_t)*to;
  }
  free(number);
  return at;
}

SG_ORDER(compare_pairs, sg_key_pair, SG_BY(low) SG_BY(high));

static bool
list_pairs(const sg_sheet *sheet, const sg_self_meetings *met,
           sg_key_pairs *out)
{
  bool memory = true;

  for (size_t i = 0; memory && i < met->n; i++) {
    uint32_t a = sheet->key[met->item[i].t[0]];
    uint32_t b = sheet->key[met->item[i].t[1]];
    if (met->item[i].kind != SG_SELF_TOUCHING) {
      memory = SG_PUSH(*out, (sg_key_pair){a < b ? a : b, a < b ? b : a});
    }
  }
  if (out->n) {
    qsort(out->item, out->n, sizeof *out->item, compare_pairs);
  }
  return memory;
}

/* What tells triangles of several faces apart, as polygons of a segment. */
typedef struct polygons {
  int32_t *of; /* [triangles]: places in: */
  int32_t *id;
  size_t n;
} polygons;

/* A polygon for each key. False: no memory. */
static bool
number_faces(const sg_sheet *sheet, polygons *out)
{
  sg_key_table number;
  bool good = true;

  *out = (polygons){malloc((sheet->n + 1) * sizeof *out->of),
                    malloc((sheet->n + 1) * sizeof *out->id), 0};
  sg_key_table_init(&number, 1);
  for (size_t t = 0; t < sheet->n && good && out->of && out->id; t++) {
    uint32_t *place = sg_key_table_put(&number, &sheet->key[t]);

    if ((good = place) && *place == SG_NO_KEY) {
      *place = (uint32_t)out->n;
      out->id[out->n] = (int32_t)out->n + 1;
      out->n++;
    }
    out->of[t] = good ? (int32_t)*place : 0;
  }
  sg_key_table_clear(&number);
  return good && out->of && out->id;
}

/* As one segment. That faces are polygons only makes flat ones one thing each:
 * all triangles are asked about. */
static sg_merge_end
join(const sg_sheet *sheet, double (*at)[3], size_t vertices, sg_key_pairs *out)
{
  const sg_merge_options *options = sheet->m->options;
  uint32_t vertex_begin[2] = {0, (uint32_t)vertices};
  uint32_t triangle_begin[2] = {0, (uint32_t)sheet->n};
  polygons faces;
  bool numbered = number_faces(sheet, &faces);
  unsigned char *asked = calloc(sheet->n + 1, 1);
  sg_dense dense = {.segments = 1,
                    .vertex_begin = vertex_begin,
                    .triangle_begin = triangle_begin,
                    .vertices = vertices,
                    .at = at,
                    .polygons = faces.n,
                    .polygon_id = faces.id,
                    .triangles = sheet->n,
                    .polygon_of = faces.of,
                    .corner = sheet->corner};
  sg_self_meetings met = {0};
  sg_merge_end end = SG_MERGE_NO_MEMORY;

  if (numbered && asked) {
    memset(asked, 1, sheet->asked);
    if (sg_self_cut_changed(&dense, 0, asked, true, 0, options->pool,
                            options->cancel, &met)) {
      end = list_pairs(sheet, &met, out) ? SG_MERGE_DONE : SG_MERGE_NO_MEMORY;
    } else if (sg_cancelled(options->cancel)) {
      end = SG_MERGE_STOPPED;
    }
  }
  free(met.item);
  free(faces.of);
  free(faces.id);
  free(asked);
  return end;
}

sg_merge_end
sg_sheet_meet(sg_sheet *sheet, sg_key_pairs *out)
{
  size_t vertices;
  double(*at)[3] = take_vertices(sheet, &vertices);

  *out = (sg_key_pairs){0};
  sg_merge_end end = at ? join(sheet, at, vertices, out) : SG_MERGE_NO_MEMORY;
  free(at);
  return end;
}

void
sg_sheet_clear(sg_sheet *sheet)
{
  free(sheet->corner);
  free(sheet->key);
  free(sheet->grid);
  *sheet = (sg_sheet){0};
}

bool
sg_key_pairs_have(const sg_key_pairs *pairs, const sg_key_pair *pair)
{
  return pairs->n &&
         bsearch(pair, pairs->item, pairs->n, sizeof *pair, compare_pairs);
}
