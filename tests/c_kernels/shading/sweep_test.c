/* sweep_test.c -- what is in front of all else is seen at once, and of what is
 * crowded that which is hidden is left out: the spans are those of the same
 * scene without something that is nowhere, of which each place is looked at.
 * Meshes of random triangles, closed and open, with corners on a lattice:
 * flush, doubled, edge-on, crossing; one, or two of them united, or with a
 * ball.
 *
 * Of walls behind one another, of which each is seen beside those before it,
 * four times as many are looked at about four times as often.
 *
 * covers: sweep, hidden_slice
 */
#include "shading/shading_private.h"

#include "tests/check.h"

#include <stdlib.h>

enum { SIDE = 48, FEW = 40, MANY = 400, SCENES = 156, WALLS = 500 };

typedef struct soup {
  int n; /* of every fourth scene many */
  double corner[MANY][3][3];
} soup;

static uint32_t seed = 19;

static double
lattice(bool fine)
{
  return fine ? check_below(&seed, 4800) / 100.0 : 6.0 * check_below(&seed, 9);
}

/* Every other triangle is the one before, turned round: a closed leaf of no
 * thickness; or with one corner elsewhere. */
static soup
some_soup(bool many)
{
  soup out = {.n = many ? MANY : FEW};

  for (int t = 0; t < out.n; t++) {
    bool fine = check_below(&seed, 2) == 0;
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        out.corner[t][i][k] =
            t % 2 == 1 && i != 1 ? out.corner[t - 1][2 - i][k] : lattice(fine);
      }
    }
  }
  return out;
}

static bool
add_soup(sg_shading *s, const soup *from)
{
  const size_t three = 3;
  bool good = true;

  for (int32_t t = 0; t < from->n; t++) {
    uint32_t corner[3];
    for (int i = 0; i < 3; i++) {
      good = good && sg_shading_add_corner(s, from->corner[t][i], &corner[i]) ==
                         SG_SHADING_GOOD;
    }
    good = good && sg_shading_add_polygon(s, t + 1, corner, &three, 1) ==
                       SG_SHADING_GOOD;
  }
  return good;
}

static bool
add_ball(sg_shading *s, const double at[3])
{
  sg_shading_piece piece = {
      .sphere = true, .low_face = -1, .high_face = -1, .high = 1, .face = 1};

  for (int k = 0; k < 3; k++) {
    piece.frame[0][k] = at[k];
    piece.frame[k + 1][k] = 9;
  }
  return sg_shading_add_piece(s, &piece) == SG_SHADING_GOOD;
}

/* Leaves 1 .. n united; `without`: without leaf n + 1, which has no faces. */
static sg_shading *
scene_of(const soup all[2], int kind, bool without)
{
  const sg_shading_frame frame = {
      .matrix = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
      .width = SIDE,
      .height = SIDE,
      .tolerance = 1e-9};
  sg_shading *s = sg_shading_open(&frame);
  uint32_t n = kind == 0 ? 1 : 2;
  bool good = s && sg_shading_add_leaf(s, 1) == 0 && add_soup(s, &all[0]);

  if (kind > 0) {
    good =
        good && sg_shading_add_leaf(s, 2) == 1 &&
        (kind == 1 ? add_soup(s, &all[1]) : add_ball(s, all[1].corner[0][0]));
  }
  good = good && sg_shading_add_leaf(s, (int32_t)n + 1) == n &&
         sg_shading_add_root(s, 1);
  size_t top = without ? sg_shading_add_node(s, 0, SG_DIFFERENCE, 0) : 0;
  size_t at = sg_shading_add_node(s, top, SG_UNION, 0);
  for (uint32_t i = 0; i < n; i++) {
    good = good && sg_shading_add_node(s, at, SG_LEAF, i) != SIZE_MAX;
  }
  if (without) {
    good = good && sg_shading_add_node(s, top, SG_LEAF, n) != SIZE_MAX;
  }
  CHECK("a scene", good && sg_shading_seal(s, NULL) == SG_SHADING_GOOD);
  return s;
}

static bool
same_spans(const sg_spans *a, const sg_spans *b)
{
  bool same = a->n == b->n;

  for (size_t i = 0; same && i < a->n; i++) {
    const sg_span *p = &a->span[i], *q = &b->span[i];
    same = p->x1 == q->x1 && p->x2 == q->x2 && p->leaf == q->leaf &&
           p->face == q->face && p->surface == q->surface &&
           p->sense == q->sense;
  }
  return same;
}

/* How often slices are looked at on a line through n walls askew, each a leaf
 * and shifted to the right of the one before it. */
static size_t
looked(uint32_t n)
{
  const sg_shading_frame frame = {
      .matrix = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
      .width = 1024,
      .height = 2,
      .tolerance = 1e-9};
  const size_t three = 3;
  sg_shading *s = sg_shading_open(&frame);
  sg_spans spans = {0};
  bool good = s != NULL;

  for (uint32_t i = 0; i < n; i++) {
    double x = 500.0 * i / n, z = 1000.0 * i / n;
    const double at[3][3] = {{x, -9, z}, {x + 500, 1, z + 400}, {x, 9, z}};
    uint32_t corner[3];
    good = good && sg_shading_add_leaf(s, (int32_t)i + 1) == i;
    for (int k = 0; k < 3; k++) {
      good = good &&
             sg_shading_add_corner(s, at[k], &corner[k]) == SG_SHADING_GOOD;
    }
    good = good &&
           sg_shading_add_polygon(s, 1, corner, &three, 1) == SG_SHADING_GOOD;
  }
  good = good && sg_shading_add_root(s, 1);
  size_t top = sg_shading_add_node(s, 0, SG_UNION, 0);
  for (uint32_t i = 0; i < n; i++) {
    good = good && sg_shading_add_node(s, top, SG_LEAF, i) != SIZE_MAX;
  }
  CHECK("walls", good && sg_shading_seal(s, NULL) == SG_SHADING_GOOD);
  sg_shading_work *work = sg_shading_work_open(s, NULL);
  CHECK("their line", sg_shading_line(s, work, 1, &spans));
  CHECK("each is seen", spans.n == n);
  size_t often = work->looked + work->searched;
  sg_shading_work_close(work);
  sg_shading_close(s);
  free(spans.span);
  return often;
}

int
main(void)
{
  sg_spans spans[2] = {{0}, {0}};
  size_t seen = 0, other = 0;

  for (int i = 0; i < SCENES; i++) {
    const soup all[2] = {some_soup(i % 12 == 9 || i % 12 == 11),
                         some_soup(i % 12 == 10)};
    sg_shading *s[2];
    sg_shading_work *work[2];

    for (int k = 0; k < 2; k++) {
      s[k] = scene_of(all, i % 3, k == 1);
      work[k] = sg_shading_work_open(s[k], NULL);
    }
    for (int k = 0; k < 4 * SIDE; k++) {
      double y = (k + 0.5) / 4;
      for (int j = 0; j < 2; j++) {
        CHECK("a line", sg_shading_line(s[j], work[j], y, &spans[j]));
      }
      seen += spans[0].n;
      other += same_spans(&spans[0], &spans[1]) ? 0U : 1U;
    }
    for (int k = 0; k < 2; k++) {
      sg_shading_work_close(work[k]);
      sg_shading_close(s[k]);
    }
  }
  printf("%zu spans, %zu lines that differ\n", seen, other);
  CHECK("many are seen", seen > 100000);
  CHECK("the same", other == 0);
  CHECK("growth", looked(4 * WALLS) < 6 * looked(WALLS));
  free(spans[0].span);
  free(spans[1].span);
  return check_report();
}
