/* self_face.c -- flat polygons of many triangles: see self_join.h. */
#include "self_join_private.h"

#include "cut.h"
#include "engine/search.h"
#include "number/exact.h"
#include "rows/sort.h"

#include <stdlib.h>
#include <string.h>

enum { MANY = 32 }; /* triangles of a polygon that is taken as one thing */

typedef struct of_polygon {
  int32_t p;
  uint32_t i;
} of_polygon;

SG_ORDER(by_polygon, of_polygon, SG_BY(p) SG_BY(i));

/* Those that are of polygons of many triangles, by polygon. Most meshes have
 * none. False: no memory, or stopped. */
static bool
find_many(const sg_self_joiner *j, const sg_cancel *cancel, of_polygon **out,
          size_t *n)
{
  size_t mask = 63, most = 0;
  sg_fan_triangle t;

  while (mask < j->of->n) {
    mask = 2 * mask + 1;
  }
  unsigned char *count = calloc(mask + 1, 1);

  *n = 0;
  *out = NULL;
  bool good = count != NULL;

  for (uint32_t i = 0; good && i < j->of->n; i++) {
    good = !sg_cancel_every(cancel, i);
    j->of->read(j->of->data, i, &t);
    unsigned char *here = &count[(uint32_t)t.polygon & mask];
    *here = (unsigned char)(*here < MANY ? *here + 1 : MANY);
    most += *here == MANY;
  }
  if (good && most > 0) {
    *out = malloc((j->of->n + 1) * sizeof **out);
    good = *out != NULL;
  }
  for (uint32_t i = 0; *out && good && i < j->of->n; i++) {
    good = !sg_cancel_every(cancel, i);
    j->of->read(j->of->data, i, &t);
    if (count[(uint32_t)t.polygon & mask] == MANY) {
      (*out)[(*n)++] = (of_polygon){t.polygon, i};
    }
  }
  free(count);
  return good &&
         sg_sort(*out, *n, sizeof **out, by_polygon, cancel) == SG_SORTED;
}

static int
turn_of(int axis, const double t[3][3])
{
  int x = (axis + 1) % 3, y = (axis + 2) % 3;

  return sg_orient2d((double[2]){t[0][x], t[0][y]},
                     (double[2]){t[1][x], t[1][y]},
                     (double[2]){t[2][x], t[2][y]});
}

/* Whether all triangles lie in one plane and look one way, exactly; also false
 * if *stopped. */
static bool
is_face(const sg_self_joiner *j, const of_polygon *item, size_t n,
        const sg_cancel *cancel, bool *stopped, sg_self_face *out)
{
  sg_fan_triangle t;

  j->of->read(j->of->data, item[0].i, &t);
  memcpy(out->at, t.at, sizeof out->at);
  out->axis = sg_cut_axis((const double(*)[3])t.at);
  if (out->axis < 0) {
    return false;
  }
  out->turn = turn_of(out->axis, (const double(*)[3])t.at);
  out->box = sg_box_none();
  for (size_t i = 0; i < n; i++) {
    sg_box box = sg_self_box_of(j, item[i].i);

    if (sg_cancel_every(cancel, i)) {
      *stopped = true;
      return false;
    }
    sg_box_join(&out->box, &box);
    j->of->read(j->of->data, item[i].i, &t);
    for (int k = 0; k < 3; k++) {
      if (sg_orient3d(out->at[0], out->at[1], out->at[2], t.at[k]) != 0) {
        return false;
      }
    }
    if (turn_of(out->axis, (const double(*)[3])t.at) != out->turn) {
      return false;
    }
  }
  return true;
}

static void
border_key(uint32_t f, uint32_t v, uint32_t w, uint32_t key[3])
{
  key[0] = f;
  key[1] = v < w ? v : w;
  key[2] = v < w ? w : v;
}

/* A triangle of face f. False: no memory. */
static bool
add_to_face(sg_self_joiner *j, uint32_t f, uint32_t i)
{
  sg_fan_triangle t;

  j->face_of[i] = f;
  j->in_face[j->face[f].first + j->face[f].n++] = i;
  j->of->read(j->of->data, i, &t);
  for (int k = 0; k < 3; k++) {
    uint32_t key[3] = {f, t.name[k]}, *count;

    if (!sg_key_table_add(&j->corner, key)) {
      return false;
    }
    border_key(f, t.name[k], t.name[(k + 1) % 3], key);
    if (!(count = sg_key_table_put(&j->border, key))) {
      return false;
    }
    *count = *count == SG_NO_KEY ? 1 : *count + 1;
  }
  return true;
}

/* False: no memory, or stopped. */
static bool
take_faces(sg_self_joiner *j, const of_polygon *item, size_t n,
           const sg_cancel *cancel)
{
  uint32_t used = 0;
  bool stopped = false;

  j->face = malloc((n / MANY + 1) * sizeof *j->face);
  j->face_of = malloc((j->of->n + 1) * sizeof *j->face_of);
  j->in_face = malloc((n + 1) * sizeof *j->in_face);
  j->single = malloc((j->of->n + 1) * sizeof *j->single);
  if (!j->face || !j->face_of || !j->in_face || !j->single) {
    return false;
  }
  memset(j->face_of, 0xff, j->of->n * sizeof *j->face_of);
  for (size_t i = 0, end; i < n; i = end) {
    sg_self_face *to = &j->face[j->faces];

    for (end = i; end < n && item[end].p == item[i].p; end++) {
    }
    *to = (sg_self_face){.p = item[i].p, .first = used};
    if (end - i < MANY ||
        !is_face(j, item + i, end - i, cancel, &stopped, to)) {
      if (stopped) {
        return false;
      }
      continue;
    }
    for (size_t k = i; k < end; k++) {
      if (sg_cancel_every(cancel, k) ||
          !add_to_face(j, (uint32_t)j->faces, item[k].i)) {
        return false;
      }
    }
    used += to->n;
    j->faces++;
  }
  for (uint32_t i = 0; i < j->of->n; i++) {
    if (j->face_of[i] == SG_NO_KEY) {
      j->single[j->singles++] = i;
    }
  }
  return true;
}

bool
sg_self_find_faces(sg_self_joiner *j, const sg_cancel *cancel)
{
  of_polygon *item;
  size_t n;

  if (j->of->reach > 0) {
    return true;
  }
  bool good = find_many(j, cancel, &item, &n) &&
              (n == 0 || take_faces(j, item, n, cancel));

  free(item);
  return good;
}

void
sg_self_clear_faces(sg_self_joiner *j)
{
  free(j->face);
  free(j->face_of);
  free(j->in_face);
  free(j->single);
  sg_key_table_clear(&j->corner);
  sg_key_table_clear(&j->border);
}

bool
sg_self_misses(const sg_self_joiner *j, uint32_t f, const sg_fan_triangle *t)
{
  const sg_self_face *of = &j->face[f];
  int shared[3], n = 0, sides = 0;

  for (int k = 0; k < 3; k++) {
    if (sg_key_table_get(&j->corner, (uint32_t[2]){f, t->name[k]}) !=
        SG_NO_KEY) {
      shared[n++] = k;
    } else {
      sides += sg_orient3d(of->at[0], of->at[1], of->at[2], t->at[k]);
    }
  }
  if (n == 3 || (sides != 3 - n && sides != n - 3)) {
    return false;
  }
  uint32_t key[3];

  if (n == 2) {
    border_key(f, t->name[shared[0]], t->name[shared[1]], key);
  }
  return n < 2 || sg_key_table_get(&j->border, key) == 1;
}
