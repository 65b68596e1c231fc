/* solid_take.c -- segments as a solid: see solid_take.h. */
#include "solid_take.h"

#include "engine/search.h"
#include "rows/by_segment.h"
#include "rows/key_table.h"
#include "rows/sort.h"

#include <stdlib.h>

enum { ASKED = 1 << 16 }; /* triangles between questions */

typedef struct take {
  const sg_solid_input *in;
  const int32_t *segment;
  size_t n;
  const sg_cancel *cancel;
  sg_segment_rows v, e, t;
  sg_id_rows number;      /* of one segment: vertex id -> number in the solid */
  sg_key_table auxiliary; /* two vertices -> 1, 0: also real */
  sg_solid *out;
} take;

static size_t
all_rows(const sg_segment_rows *rows, size_t segments)
{
  return rows->begin[segments];
}

static bool
make_room(const take *k)
{
  size_t vertices = all_rows(&k->v, k->n), triangles = all_rows(&k->t, k->n);
  sg_solid *out = k->out;

  out->vertex = malloc((vertices + 1) * sizeof *out->vertex);
  out->triangle = malloc((triangles + 1) * sizeof *out->triangle);
  out->auxiliary = calloc(triangles + 1, sizeof *out->auxiliary);
  out->face = malloc((triangles + 1) * sizeof *out->face);
  return out->vertex && out->triangle && out->auxiliary && out->face;
}

/* ---- one segment ---- */

/* Its vertices by id; from here on the table has their numbers for rows. */
static bool
take_vertices(take *k, size_t i)
{
  const uint32_t *row = k->v.row + k->v.begin[i];
  sg_solid *out = k->out;

  if (!sg_id_rows_make(k->in->v, row, k->v.begin[i + 1] - k->v.begin[i],
                       &k->number)) {
    return false;
  }
  for (size_t place = 0; place < k->number.places; place++) {
    uint32_t r = k->number.row[place];
    if (r == SG_NO_ID_ROW) {
      continue;
    }
    sg_solid_vertex *to = &out->vertex[out->vertices];
    *to =
        (sg_solid_vertex){.s = k->segment[i], .v = sg_view_int(k->in->v, 1, r)};
    sg_view_point(k->in->v, r, to->at);
    k->number.row[place] = (uint32_t)out->vertices++;
  }
  return true;
}

static void
edge_key(const take *k, uint32_t row, uint32_t key[2])
{
  key[0] = sg_id_rows_find(&k->number, sg_view_int(k->in->e, 2, row));
  key[1] = sg_id_rows_find(&k->number, sg_view_int(k->in->e, 3, row));
}

/* Notes the auxiliary edges, then that some of them are real too. */
static bool
take_edges(take *k, size_t i)
{
  uint32_t key[2], *is;

  for (size_t r = k->e.begin[i]; r < k->e.begin[i + 1]; r++) {
    if (sg_view_int(k->in->e, 4, k->e.row[r]) == 0) {
      edge_key(k, k->e.row[r], key);
      if (!(is = sg_key_table_put(&k->auxiliary, key))) {
        return false;
      }
      *is = 1;
    }
  }
  for (size_t r = k->e.begin[i]; k->auxiliary.n && r < k->e.begin[i + 1]; r++) {
    if (sg_view_int(k->in->e, 4, k->e.row[r]) != 0) {
      edge_key(k, k->e.row[r], key);
      if ((is = sg_key_table_find(&k->auxiliary, key))) {
        *is = 0;
      }
    }
  }
  return true;
}

static uint8_t
auxiliary_edges(const take *k, const uint32_t v[3])
{
  uint8_t bits = 0;

  for (int c = 0; k->auxiliary.n > 0 && c < 3; c++) {
    uint32_t key[2] = {v[c], v[(c + 1) % 3]};
    if (sg_key_table_get(&k->auxiliary, key) == 1) {
      bits |= (uint8_t)(1 << c);
    }
  }
  return bits;
}

static void
take_triangle(take *k, int32_t s, uint32_t row)
{
  int32_t p = sg_view_int(k->in->t, 1, row);
  sg_solid *out = k->out;
  sg_solid_face *last = out->faces ? &out->face[out->faces - 1] : NULL;
  uint32_t *v = out->triangle[out->triangles];

  for (unsigned c = 0; c < 3; c++) {
    v[c] = sg_id_rows_find(&k->number, sg_view_int(k->in->t, 3 + c, row));
  }
  out->auxiliary[out->triangles] = auxiliary_edges(k, v);
  if (!last || last->s != s || last->p != p) {
    last = &out->face[out->faces++];
    *last = (sg_solid_face){.s = s, .p = p, .first = (uint32_t)out->triangles};
  }
  last->n++;
  out->triangles++;
}

typedef struct polygon_row {
  int32_t p;
  uint32_t row;
} polygon_row;

SG_ORDER(compare_polygons, polygon_row, SG_BY(p));

/* Its triangles by polygon, in each in the order of the rows. */
static bool
take_triangles(take *k, size_t i)
{
  size_t n = k->t.begin[i + 1] - k->t.begin[i];
  polygon_row *by = malloc((n + 1) * sizeof *by);
  bool good = by != NULL;

  for (size_t r = 0; r < n && good; r++) {
    uint32_t row = k->t.row[k->t.begin[i] + r];
    by[r] = (polygon_row){sg_view_int(k->in->t, 1, row), row};
  }
  good = good &&
         sg_sort(by, n, sizeof *by, compare_polygons, k->cancel) == SG_SORTED;
  for (size_t r = 0; r < n && good; r++) {
    take_triangle(k, k->segment[i], by[r].row);
    good = r % ASKED != ASKED - 1 || !sg_cancelled(k->cancel);
  }
  free(by);
  return good;
}

/* ---- all segments ---- */

static bool
take_segment(take *k, size_t i)
{
  sg_key_table_init(&k->auxiliary, 2);
  bool good = take_vertices(k, i) && take_edges(k, i) && take_triangles(k, i);

  sg_key_table_clear(&k->auxiliary);
  sg_id_rows_clear(&k->number);
  return good;
}

static bool
find_rows(take *k)
{
  return sg_segment_rows_find(k->in->v, k->segment, k->n, k->cancel, &k->v) &&
         sg_segment_rows_find(k->in->e, k->segment, k->n, k->cancel, &k->e) &&
         sg_segment_rows_find(k->in->t, k->segment, k->n, k->cancel, &k->t);
}

bool
sg_solid_take(const sg_solid_input *in, const int32_t *segment, size_t n,
              const sg_cancel *cancel, sg_solid *out)
{
  take k = {.in = in, .segment = segment, .n = n, .cancel = cancel, .out = out};

  *out = (sg_solid){0};
  bool good = find_rows(&k) && make_room(&k);

  for (size_t i = 0; i < n && good; i++) {
    good = take_segment(&k, i);
  }
  out->plain = out->vertices;
  sg_segment_rows_clear(&k.v);
  sg_segment_rows_clear(&k.e);
  sg_segment_rows_clear(&k.t);
  return good;
}
