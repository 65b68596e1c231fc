/* cut_overlap.c -- chords inside a common part of two faces are no lines.
 *
 * Polygons that resolving laid on each other (resolve.h) have the same
 * triangles there, which need not be coplanar exactly. Two triangles a, b, p
 * and b, a, q of the one, and the same two of the other, cut each other along
 * their chord a-b: the first of the one with the second of the other, and the
 * other way round. Where two polygons go THROUGH each other along a common
 * chord, the corners p and q of one are not those of the other. What is said of
 * chords goes for the edges inside a face, too (cut_face.c).
 */
#include "cut_private.h"

#include "rows/sort.h"

#include <stdlib.h>
#include <string.h>

/* A cut along a chord in both faces, which are named by the smaller polygon of
 * each there. The corners opposite to it, p in the first and q in the second
 * triangle, as vertices of the model. */
typedef struct fold {
  uint32_t low, high; /* points of the chord */
  int32_t s[2], face[2];
  const double *p, *q;
  size_t cut;
} fold;

/* Those of the same chord and the same two faces come together. */
static int
by_faces(const fold *x, const fold *y)
{
  if (x->low != y->low) {
    return x->low < y->low ? -1 : 1;
  }
  if (x->high != y->high) {
    return x->high < y->high ? -1 : 1;
  }
  int by_s = memcmp(x->s, y->s, sizeof x->s);

  return by_s != 0 ? by_s : memcmp(x->face, y->face, sizeof x->face);
}

static int
by_chord(const void *a, const void *b)
{
  const fold *x = a, *y = b;
  int order = by_faces(x, y);

  if (order != 0) {
    return order;
  }
  return (x->cut > y->cut) - (x->cut < y->cut);
}

static bool
same_place(const double a[3], const double b[3])
{
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static bool
is_at(const sg_cut_set *set, const double at[3], uint32_t point)
{
  const sg_point *p = &set->points.point[point].at;

  return !p->exactly && same_place(p->p, at);
}

/* The side of a triangle that a cut is all of; -1: none. */
static int
side_of(const sg_cut_set *set, uint32_t triangle, const sg_cut_piece *cut)
{
  const uint32_t *v = set->model.triangle[triangle].v;

  for (int k = 0; k < 3; k++) {
    const double *a = set->model.vertex[v[k]].at;
    const double *b = set->model.vertex[v[(k + 1) % 3]].at;
    if ((is_at(set, a, cut->a) && is_at(set, b, cut->b)) ||
        (is_at(set, a, cut->b) && is_at(set, b, cut->a))) {
      return k;
    }
  }
  return -1;
}

/* Whether a cut is such a chord: 1, 0, or -1: no memory. */
static int
find_fold(sg_cut_set *set, size_t i, fold *out)
{
  const sg_cut_piece *cut = &set->cut[i];
  const double *corner[2];
  int side[2];

  for (int k = 0; k < 2; k++) {
    side[k] = side_of(set, cut->triangle[k], cut);
    if (side[k] < 0) {
      return 0;
    }
    const uint32_t *v = set->model.triangle[cut->triangle[k]].v;
    corner[k] = set->model.vertex[v[(side[k] + 2) % 3]].at;
  }
  *out = (fold){.low = cut->a < cut->b ? cut->a : cut->b,
                .high = cut->a < cut->b ? cut->b : cut->a,
                .p = corner[0],
                .q = corner[1],
                .s = {cut->s[0], cut->s[1]},
                .cut = i};
  for (int k = 0; k < 2; k++) {
    int inside =
        sg_cut_is_inside(set, cut->triangle[k], side[k], &out->face[k]);
    if (inside <= 0) {
      return inside;
    }
  }
  return 1;
}

enum { CUTS_ASKED = 256 }; /* between questions */

static bool
is_stopped(const sg_cancel *cancel, size_t i)
{
  return i % CUTS_ASKED == 0 && sg_cancelled(cancel);
}

/* False: no memory, or stopped. */
static bool
find_folds(sg_cut_set *set, const sg_cancel *cancel, fold *out, size_t *n)
{
  *n = 0;
  for (size_t i = 0; i < set->cuts; i++) {
    int found = find_fold(set, i, &out[*n]);

    if (found < 0 || is_stopped(cancel, i)) {
      return false;
    }
    *n += (size_t)found;
  }
  return true;
}

bool
sg_cut_drop_folds(sg_cut_set *set, const sg_cancel *cancel)
{
  fold *list = malloc((set->cuts + 1) * sizeof *list);
  size_t n = 0, kept = 0;
  bool good = list && find_folds(set, cancel, list, &n) &&
              sg_sort(list, n, sizeof *list, by_chord, cancel) == SG_SORTED;

  for (size_t i = 0, end; good && i < n; i = end) {
    good = !is_stopped(cancel, i);
    for (end = i + 1; end < n && by_faces(&list[end], &list[i]) == 0; end++) {
    }
    for (size_t k = i; k < end; k++) {
      for (size_t l = i; l < end; l++) {
        if (same_place(list[k].p, list[l].q) &&
            same_place(list[k].q, list[l].p)) {
          set->cut[list[k].cut].live = false;
        }
      }
    }
  }
  free(list);
  if (!good) {
    return false;
  }
  for (size_t i = 0; i < set->cuts; i++) {
    if (set->cut[i].live) {
      set->cut[kept++] = set->cut[i];
    }
  }
  set->cuts = kept;
  return true;
}
