/* face_merge_region_test.c -- faces of some leaves, merged together with what
 * is round them alone, are those of the larger solid.
 */
#include "merged.h"
#include "tests/check.h"

/* ---- layers ------------------------------------------------------------- */

enum { TOP = 2, MIDDLE = 1, BOTTOM = 3 }; /* leaves: what is above 4, 2, 0 */

static int32_t
leaf_of(const sg_solid *solid, const sg_solid_face *face)
{
  double z = 0, n = 0;

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int k = 0; k < 3; k++, n++) {
      z += solid->vertex[solid->triangle[t][k]].at[2];
    }
  }
  return z > 4 * n ? TOP : z > 2 * n ? MIDDLE : BOTTOM;
}

static void
name_leaves(sg_solid *solid)
{
  for (size_t f = 0; f < solid->faces; f++) {
    solid->face[f].s = leaf_of(solid, &solid->face[f]);
  }
}

/* A block of four layers, and something on it, smaller or not. */
static cube_lump
layers(void)
{
  cube_lump lump = {0};
  int side = pick(3) ? 1 : 0;

  fill_box(&lump, 0, 0, 0, SIDE - 1, SIDE - 1, 4);
  for (int boxes = 1 + pick(3); boxes > 0; boxes--) {
    int x = side + pick(3), y = side + pick(3);
    fill_box(&lump, x, y, 4, x + 1 + pick(3), y + 1 + pick(3), 5 + pick(3));
  }
  return lump;
}

/* The faces that are not of the bottom: it is open there. */
static sg_solid
without_bottom(const sg_solid *solid)
{
  sg_solid part = copy_of(solid);

  part.faces = part.triangles = 0;
  for (size_t f = 0; f < solid->faces; f++) {
    sg_solid_face face = solid->face[f];
    if (face.s != BOTTOM) {
      memcpy(part.triangle[part.triangles], solid->triangle[face.first],
             face.n * sizeof *part.triangle);
      memcpy(part.auxiliary + part.triangles, solid->auxiliary + face.first,
             face.n);
      face.first = (uint32_t)part.triangles;
      part.triangles += face.n;
      part.face[part.faces++] = face;
    }
  }
  return part;
}

/* Round the vertices of the faces that are not of the top. */
static sg_box
others_box(const sg_solid *solid)
{
  sg_box box = sg_box_none();

  for (size_t f = 0; f < solid->faces; f++) {
    const sg_solid_face *face = &solid->face[f];
    for (uint32_t t = face->first; t < face->first + face->n; t++) {
      for (int k = 0; k < 3 && face->s != TOP; k++) {
        sg_box_add(&box, solid->vertex[solid->triangle[t][k]].at);
      }
    }
  }
  return box;
}

/* Some pair of faces that might be one is of the top and of others. */
static bool
top_hangs_on(const sg_solid *solid)
{
  sg_merge_options options = {.tolerance = TOLERANCE};
  sg_merge_pair *pair = NULL;
  bool any = false;
  size_t n = 0;

  if (sg_face_merge_pairs(solid, &options, &pair, &n) != SG_MERGE_DONE) {
    abort();
  }
  for (size_t i = 0; i < n; i++) {
    any = any || (pair[i].one.s == TOP) != (pair[i].other.s == TOP);
  }
  free(pair);
  return any;
}

/* ---- the same faces ----------------------------------------------------- */

static bool
same_triangles(const sg_solid *a, const sg_solid_face *f, const sg_solid *b,
               const sg_solid_face *g)
{
  bool same = f->s == g->s && f->p == g->p && f->n == g->n;

  for (uint32_t t = 0; same && t < f->n; t++) {
    same = a->auxiliary[f->first + t] == b->auxiliary[g->first + t];
    for (int k = 0; same && k < 3; k++) {
      const double *x = a->vertex[a->triangle[f->first + t][k]].at;
      const double *y = b->vertex[b->triangle[g->first + t][k]].at;
      same = memcmp(x, y, 3 * sizeof *x) == 0;
    }
  }
  return same;
}

/* What face f, that is face g of another solid, was made from. */
static bool
same_parts(const sg_solid *a, uint32_t f, const sg_solid *b, uint32_t g)
{
  size_t i = 0, j = 0;

  while (i < a->parts && a->part[i].face < f) {
    i++;
  }
  while (j < b->parts && b->part[j].face < g) {
    j++;
  }
  for (; i < a->parts && a->part[i].face == f; i++, j++) {
    if (j == b->parts || b->part[j].face != g || a->part[i].s != b->part[j].s ||
        a->part[i].p != b->part[j].p) {
      return false;
    }
  }
  return j == b->parts || b->part[j].face != g;
}

/* The faces of the top, in order, are all that the other has. */
static bool
top_is(const sg_solid *solid, const sg_solid *top)
{
  uint32_t g = 0;

  for (uint32_t f = 0; f < solid->faces; f++) {
    if (solid->face[f].s == TOP) {
      if (g == top->faces ||
          !same_triangles(solid, &solid->face[f], top, &top->face[g]) ||
          !same_parts(solid, f, top, g)) {
        return false;
      }
      g++;
    }
  }
  return g == top->faces && g > 0;
}

/* ---- merging ------------------------------------------------------------ */

static void
test_layers(int rounds)
{
  static const int32_t top[] = {TOP};
  unsigned bad = 0, apart = 0;

  for (int round = 0; round < rounds; round++) {
    cube_lump lump = layers();
    sg_solid solid = lump_solid(&lump, (grouping)pick(3));
    name_leaves(&solid);
    place_at_random(&solid, 10);
    shake(&solid, 0.4 * TOLERANCE);
    sg_solid part = without_bottom(&solid);
    sg_solid before = copy_of(&part);
    sg_merge_region region = {top, 1, others_box(&solid), others_box(&solid)};
    sg_merge_options options = {.tolerance = TOLERANCE, .region = &region};
    bool hangs = top_hangs_on(&part);
    sg_merge_end end = sg_face_merge(&part, &options, NULL);
    bad += end != (hangs ? SG_MERGE_APART : SG_MERGE_DONE);
    if (end == SG_MERGE_DONE) {
      merge(&solid, TOLERANCE);
      bad += !top_is(&solid, &part) || part.closed;
    } else {
      bad += !same_solid(&part, &before);
      apart++;
    }
    sg_solid_clear(&solid);
    sg_solid_clear(&part);
    sg_solid_clear(&before);
  }
  CHECK("the faces of the top are those of the larger solid", bad == 0);
  CHECK("both happen",
        apart > (unsigned)rounds / 8 && apart < (unsigned)rounds * 7 / 8);
}

/* A bar whose upper side bends by a thousandth. */
static sg_solid
bent_bar(void)
{
  cube_lump lump = {0};

  fill_box(&lump, 0, 0, 0, 2, 1, 1);
  sg_solid solid = lump_solid(&lump, EACH_SQUARE);
  for (size_t v = 0; v < solid.vertices; v++) {
    double *at = solid.vertex[v].at;
    at[2] += at[0] == 1 && at[2] == 1 ? 0x1p-10 : 0;
  }
  return solid;
}

/* Merges a bent bar as a part of something that was, and is, as long as this.
 */
static sg_merge_end
merge_bent(double was, double is, size_t *faces)
{
  static const int32_t all[] = {1};
  sg_merge_region region = {all, 1, sg_box_none(), sg_box_none()};
  sg_merge_options options = {
      .tolerance = 0x1p-8, .by_size = true, .region = &region};
  sg_solid solid = bent_bar();

  for (int k = 0; k < 2; k++) {
    sg_box_add(&region.was, (const double[3]){k * was, 0, 0});
    sg_box_add(&region.box, (const double[3]){k * is, 0, 0});
  }
  sg_merge_end end = sg_face_merge(&solid, &options, NULL);

  *faces = solid.faces;
  sg_solid_clear(&solid);
  return end;
}

/* The tolerance is by the size of all there is, and that of others with it. */
static void
test_size(void)
{
  size_t faces;

  CHECK("a small solid is merged with a small tolerance",
        merge_bent(2, 2, &faces) == SG_MERGE_DONE && faces == 7);
  CHECK("but not as a part of a large one",
        merge_bent(1000, 1000, &faces) == SG_MERGE_DONE && faces == 6);
  CHECK("nor of one that is as good as that",
        merge_bent(1000, 50, &faces) == SG_MERGE_DONE && faces == 6);
  CHECK("others had another tolerance",
        merge_bent(20, 2, &faces) == SG_MERGE_APART && faces == 10);
  CHECK("or a smaller one",
        merge_bent(2, 20, &faces) == SG_MERGE_APART && faces == 10);
}

int
main(void)
{
  test_layers(2000);
  test_size();
  return check_report();
}
