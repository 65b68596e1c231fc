/* coincident_faces.c -- see coincident_faces.h. */
#include "coincident_faces.h"

#include "engine/search.h"
#include "polygon/plane.h"
#include "rows/edge_print.h"
#include "rows/key_table.h"
#include "rows/sort.h"
#include "solid_border.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct sg_solid_part part;

enum { ASKED = 4096 /* faces between questions */ };

/* An edge of a border, as it runs. */
typedef struct border_edge {
  uint32_t low, high;
  bool back; /* from high to low */
} border_edge;

typedef struct print {
  uint64_t value;
  uint32_t face;
} print;

typedef struct finder {
  const sg_solid *solid;
  double tolerance;
  uint8_t *border; /* [triangles] */
  print *print;    /* [faces] */
  uint32_t *first; /* [faces]: the face that it lies on, itself mostly */
  bool *turned;    /* [faces]: the other way round than that */
  border_edge *edge[2];
} finder;

/* ---- vertices ----------------------------------------------------------- */

/* Places have no -0.0. */
static bool
weld(sg_solid *solid, const sg_cancel *cancel)
{
  uint32_t *first = malloc((solid->vertices + 1) * sizeof *first);
  sg_key_table at;
  bool good;

  sg_key_table_init(&at, 6);
  good = first && sg_key_table_reserve(&at, solid->vertices);
  for (uint32_t v = 0; good && v < solid->vertices; v++) {
    uint32_t key[6];

    memcpy(key, solid->vertex[v].at, sizeof key);
    uint32_t *same = sg_key_table_put(&at, key);

    good = same && !(v % ASKED == ASKED - 1 && sg_cancelled(cancel));
    if (good) {
      first[v] = *same = *same == SG_NO_KEY ? v : *same;
    }
  }
  for (size_t t = 0; good && t < solid->triangles; t++) {
    for (int k = 0; k < 3; k++) {
      solid->triangle[t][k] = first[solid->triangle[t][k]];
    }
  }
  sg_key_table_clear(&at);
  free(first);
  return good;
}

/* ---- prints ------------------------------------------------------------- */

static uint64_t
print_of(const finder *f, size_t number)
{
  const sg_solid_face *face = &f->solid->face[number];
  uint64_t sum = 0;

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    const uint32_t *v = f->solid->triangle[t];

    for (int k = 0; k < 3; k++) {
      if (f->border[t] >> k & 1) {
        uint64_t low = v[k] < v[(k + 1) % 3] ? v[k] : v[(k + 1) % 3];
        uint64_t high = v[k] ^ v[(k + 1) % 3] ^ (uint32_t)low;

        sum += sg_spread_bits(low << 32 | high);
      }
    }
  }
  return sum;
}

SG_ORDER(by_print, print, SG_BY(value) SG_BY(face));

static bool
make_prints(finder *f, const sg_cancel *cancel)
{
  const sg_solid *solid = f->solid;
  sg_border scratch = {0};
  uint32_t edges;
  bool good = true;

  for (size_t i = 0; good && i < solid->faces; i++) {
    good = sg_border_find(&scratch, solid, i, f->border, &edges) &&
           !(i % ASKED == ASKED - 1 && sg_cancelled(cancel));
    if (good) {
      f->print[i] = (print){print_of(f, i), (uint32_t)i};
      f->first[i] = (uint32_t)i;
    }
  }
  sg_border_clear(&scratch);
  return good && sg_sort(f->print, solid->faces, sizeof *f->print, by_print,
                         cancel) == SG_SORTED;
}

/* ---- whether two are the same ------------------------------------------- */

SG_ORDER(by_ends, border_edge, SG_BY(low) SG_BY(high) SG_BY(back));

/* Its edges, sorted; `inner`: of all its triangles. Returns how many. */
static size_t
list_edges(const finder *f, uint32_t number, int which, bool inner)
{
  const sg_solid_face *face = &f->solid->face[number];

  size_t n = 0;

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    const uint32_t *v = f->solid->triangle[t];

    for (int k = 0; k < 3; k++) {
      uint32_t a = v[k], b = v[(k + 1) % 3];
      border_edge one = {a < b ? a : b, a < b ? b : a, a > b && !inner};

      if (inner || f->border[t] >> k & 1) {
        f->edge[which][n++] = one;
      }
    }
  }
  qsort(f->edge[which], n, sizeof(border_edge), by_ends);
  return n;
}

/* 1: the same edges, run the same way; -1: the other way; 0: others. */
static int
compare_edges(const finder *f, size_t n)
{
  const border_edge *a = f->edge[0], *b = f->edge[1];
  bool turned = n > 0 && a[0].back != b[0].back;

  for (size_t i = 0; i < n; i++) {
    if (a[i].low != b[i].low || a[i].high != b[i].high ||
        (a[i].back != b[i].back) != turned) {
      return 0;
    }
  }
  return turned ? -1 : 1;
}

static bool
is_flat(const finder *f, uint32_t number)
{
  const sg_solid *solid = f->solid;
  const sg_solid_face *face = &solid->face[number];
  sg_newell sum;
  sg_plane plane;

  sg_newell_init(&sum);
  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int k = 0; k < 3; k++) {
      if (f->border[t] >> k & 1) {
        sg_newell_edge(&sum, solid->vertex[solid->triangle[t][k]].at,
                       solid->vertex[solid->triangle[t][(k + 1) % 3]].at);
      }
    }
  }
  if (!sg_newell_plane(&sum, &plane)) {
    return true;
  }
  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int k = 0; k < 3; k++) {
      const double *at = solid->vertex[solid->triangle[t][k]].at;

      if (!(fabs(sg_plane_distance(&plane, at)) <= f->tolerance)) {
        return false;
      }
    }
  }
  return true;
}

/* 1: face `b` lies on face `a`; -1: turned round; 0: it does not. */
static int
way_of(const finder *f, uint32_t a, uint32_t b)
{
  size_t n = list_edges(f, a, 0, false), m = list_edges(f, b, 1, false);
  int way = n == m ? compare_edges(f, n) : 0;

  if (way != 0 && !(is_flat(f, a) && is_flat(f, b))) {
    n = list_edges(f, a, 0, true);
    m = list_edges(f, b, 1, true);
    way = n == m && compare_edges(f, n) != 0 ? way : 0;
  }
  return way;
}

/* Those of one print. */
static void
settle_run(const finder *f, const print *run, size_t n)
{
  for (size_t i = 1; i < n; i++) {
    uint32_t face = run[i].face;
    int way = 0;

    for (size_t k = 0; k < i && way == 0; k++) {
      if (f->first[run[k].face] == run[k].face) {
        way = way_of(f, run[k].face, face);
      }
      if (way != 0) {
        f->first[face] = run[k].face;
        f->turned[face] = way < 0;
      }
    }
  }
}

/* For the edges of the largest face. */
static bool
make_room(finder *f)
{
  size_t most = 0;

  for (size_t i = 0; i < f->solid->faces; i++) {
    size_t n = f->solid->face[i].n;

    most = n > most ? n : most;
  }
  for (int k = 0; k < 2; k++) {
    f->edge[k] = malloc((3 * most + 1) * sizeof(border_edge));
  }
  return f->edge[0] && f->edge[1];
}

static bool
find(finder *f, const sg_cancel *cancel)
{
  size_t n = f->solid->faces;
  bool good = make_room(f) && make_prints(f, cancel);

  for (size_t i = 0, end; good && i < n; i = end) {
    for (end = i + 1; end < n && f->print[end].value == f->print[i].value;
         end++) {
    }
    settle_run(f, f->print + i, end - i);
  }
  return good;
}

/* ---- leaving them out --------------------------------------------------- */

SG_ORDER(by_face, part, SG_BY(face) SG_BY(s) SG_BY(p) SG_BY(reversed));

/* Parts of all that go, then those that were there; as faces were numbered. */
static size_t
list_parts(const finder *f, part *out)
{
  const sg_solid *solid = f->solid;
  size_t n = 0;

  for (uint32_t i = 0; i < solid->faces; i++) {
    const sg_solid_face *face = &solid->face[i];

    if (f->first[i] != i) {
      out[n++] =
          (part){f->first[i], face->s, face->p, face->reversed != f->turned[i]};
    }
  }
  for (size_t i = 0; i < solid->parts; i++) {
    part one = solid->part[i];

    one.reversed = one.reversed != f->turned[one.face];
    one.face = f->first[one.face];
    out[n++] = one;
  }
  return n;
}

static void
leave_out(const finder *f, sg_solid *solid, part *parts, size_t n)
{
  size_t faces = 0, triangles = 0, at = 0;

  qsort(parts, n, sizeof *parts, by_face);
  for (uint32_t i = 0; i < solid->faces; i++) {
    sg_solid_face face = solid->face[i];

    if (f->first[i] != i) {
      continue;
    }
    for (; at < n && parts[at].face == i; at++) {
      parts[at].face = (uint32_t)faces;
    }
    memmove(solid->triangle[triangles], solid->triangle[face.first],
            face.n * sizeof *solid->triangle);
    memmove(solid->auxiliary + triangles, solid->auxiliary + face.first,
            face.n);
    face.first = (uint32_t)triangles;
    triangles += face.n;
    solid->face[faces++] = face;
  }
  solid->faces = faces;
  solid->triangles = triangles;
  free(solid->part);
  solid->part = parts;
  solid->parts = n;
}

/* ---- together ----------------------------------------------------------- */

static double
least_tolerance(const sg_solid *solid)
{
  double largest = 0;

  for (size_t v = 0; v < solid->vertices; v++) {
    for (int k = 0; k < 3; k++) {
      largest = fmax(largest, fabs(solid->vertex[v].at[k]));
    }
  }
  return 8 * DBL_EPSILON * largest;
}

static void
clear(finder *f)
{
  free(f->border);
  free(f->print);
  free(f->first);
  free(f->turned);
  free(f->edge[0]);
  free(f->edge[1]);
}

bool
sg_coincident_faces(sg_solid *solid, double tolerance, const sg_cancel *cancel,
                    size_t *doubles)
{
  size_t faces = solid->faces;
  finder f = {.solid = solid,
              .tolerance = fmax(tolerance, least_tolerance(solid)),
              .border = malloc(solid->triangles + 1),
              .print = malloc((faces + 1) * sizeof *f.print),
              .first = malloc((faces + 1) * sizeof *f.first),
              .turned = calloc(faces + 1, sizeof *f.turned)};
  part *parts = malloc((faces + solid->parts + 1) * sizeof *parts);
  bool good = f.border && f.print && f.first && f.turned && parts &&
              weld(solid, cancel) && find(&f, cancel);

  if (good) {
    leave_out(&f, solid, parts, list_parts(&f, parts));
    *doubles = faces - solid->faces;
  } else {
    free(parts);
  }
  clear(&f);
  return good;
}
