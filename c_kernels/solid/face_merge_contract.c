/* face_merge_contract.c -- vertices in one place: see face_merge_private.h.
 *
 * Layer: kernel. Putting vertices together opens nothing: a triangle that then
 * has a vertex twice has, of what is left, an edge and its opposite.
 */
#include "face_merge_sheet.h"

#include "rows/disjoint.h"
#include "rows/sort.h"

#include <stdlib.h>

enum {
  ROUNDS = 16, /* at most as often some vertices are left where they were */
  OFTEN = 1 << 12
};

/* Which vertex stands for each, and which have to stand for themselves. */
typedef struct joining {
  const sg_merge *m;
  uint32_t *up;  /* [vertices] */
  bool *blocked; /* [vertices] */
} joining;

static bool
are_near(const sg_merge *m, uint32_t v, uint32_t w)
{
  double square = 0;

  for (int k = 0; k < 3; k++) {
    double d = sg_merge_at(m, v)[k] - sg_merge_at(m, w)[k];
    square += d * d;
  }
  return square <= m->tolerance * m->tolerance;
}

/* Puts two vertices together, if those that stand for them are near too. */
static bool
join(joining *j, uint32_t v, uint32_t w)
{
  uint32_t a = sg_disjoint_root(j->up, v), b = sg_disjoint_root(j->up, w);

  if (a == b || j->blocked[v] || j->blocked[w] || !are_near(j->m, a, b)) {
    return false;
  }
  j->up[a < b ? b : a] = a < b ? a : b;
  return true;
}

/* The vertices that cuts made, ascending, and how far each is along a direction
 * that planes of models are hardly ever perpendicular to. */
static size_t
list_made(const sg_merge *m, sg_measured *out)
{
  static const double direction[3] = {0.5366, 0.6247, 0.5673};
  size_t n = 0;

  for (size_t v = m->solid->plain; v < m->solid->vertices; v++) {
    const double *at = sg_merge_at(m, (uint32_t)v);
    if (m->first[v] < m->first[v + 1]) {
      out[n].of = (uint32_t)v;
      out[n++].value =
          direction[0] * at[0] + direction[1] * at[1] + direction[2] * at[2];
    }
  }
  return n;
}

/* Cuts make some vertices twice, by different planes, where rounding of a
 * turned model has parted what is one place. *any: some were put together. */
static bool
join_made(joining *joins, bool *any)
{
  const sg_merge *m = joins->m;
  size_t made = m->solid->vertices - m->solid->plain;
  sg_measured *list = malloc((made + 1) * sizeof *list);
  size_t n = list ? list_made(m, list) : 0;
  bool memory = list && sg_sort_measured(list, n, NULL) == SG_SORTED;

  for (size_t i = 0; memory && i < n; i++) {
    for (size_t j = i + 1;
         j < n && list[j].value - list[i].value <= 2 * m->tolerance; j++) {
      if (are_near(m, list[i].of, list[j].of) &&
          !sg_merge_wall(m, list[i].of, list[j].of)) {
        *any = join(joins, list[i].of, list[j].of) || *any;
      }
    }
  }
  free(list);
  return memory;
}

/* The vertex that stands for each; *any: not each for itself. False: no
 * memory. */
static bool
join_vertices(joining *j, bool *any)
{
  const sg_merge *m = j->m;

  *any = false;
  for (uint32_t v = 0; v < m->solid->vertices; v++) {
    j->up[v] = v;
  }
  for (size_t i = 0; i < m->briefs; i++) {
    *any = join(j, m->brief[i][0], m->brief[i][1]) || *any;
  }
  return join_made(j, any);
}

/* ---- what meets then ---------------------------------------------------- */

/* Where the corners of a triangle are now; *left: it still has three. Returns
 * whether it is another triangle than it was. */
static bool
is_moved(const joining *j, size_t triangle, uint32_t corner[3], bool *left)
{
  const uint32_t *was = j->m->solid->triangle[triangle];
  bool moved = false;

  for (int k = 0; k < 3; k++) {
    corner[k] = sg_disjoint_root(j->up, was[k]);
    moved = moved || corner[k] != was[k];
  }
  *left = corner[0] != corner[1] && corner[1] != corner[2] &&
          corner[2] != corner[0];
  return moved;
}

/* Adds the triangles that were moved, or the others that are near. */
static sg_merge_end
add_triangles(const joining *j, bool moved, sg_sheet *sheet)
{
  const sg_merge *m = j->m;
  uint32_t corner[3];
  bool left;

  for (size_t t = 0; t < m->solid->triangles; t++) {
    if (t % OFTEN == 0 && sg_cancelled(m->options->cancel)) {
      return SG_MERGE_STOPPED;
    }
    if (is_moved(j, t, corner, &left) == moved && left &&
        (moved || sg_sheet_is_near(sheet, corner)) &&
        !sg_sheet_add(sheet, corner, (uint32_t)t)) {
      return SG_MERGE_NO_MEMORY;
    }
  }
  return SG_MERGE_DONE;
}

/* The triangles that meet, one of them moved, and those that fold. */
static sg_merge_end
find_after(const joining *j, sg_key_pairs *out, sg_folds *folds)
{
  sg_sheet sheet = {.m = j->m};
  sg_merge_end end = add_triangles(j, true, &sheet);

  if (end == SG_MERGE_DONE) {
    end = sg_sheet_mark(&sheet) ? add_triangles(j, false, &sheet)
                                : SG_MERGE_NO_MEMORY;
  }
  if (end == SG_MERGE_DONE) {
    end = sg_sheet_folds(&sheet, folds);
  }
  if (end == SG_MERGE_DONE) {
    end = sg_sheet_meet(&sheet, out);
  }
  sg_sheet_clear(&sheet);
  return end;
}

/* Those triangles of `after` that met where they were. */
static sg_merge_end
find_before(const joining *j, const sg_key_pairs *after, sg_key_pairs *out)
{
  sg_sheet sheet = {.m = j->m};
  bool memory = true;

  for (size_t i = 0; memory && i < 2 * after->n; i++) {
    const sg_key_pair *pair = &after->item[i / 2];
    uint32_t t = i % 2 ? pair->high : pair->low;
    memory = sg_sheet_add(&sheet, j->m->solid->triangle[t], t);
  }
  sheet.asked = sheet.n;
  sg_merge_end end = memory ? sg_sheet_meet(&sheet, out) : SG_MERGE_NO_MEMORY;
  sg_sheet_clear(&sheet);
  return end;
}

/* A triangle has come to another place. */
static bool
is_elsewhere(const joining *j, uint32_t t)
{
  const uint32_t *corner = j->m->solid->triangle[t];
  bool is = false;

  for (int k = 0; k < 3; k++) {
    const double *was = sg_merge_at(j->m, corner[k]);
    const double *at = sg_merge_at(j->m, sg_disjoint_root(j->up, corner[k]));
    is = is || at[0] != was[0] || at[1] != was[1] || at[2] != was[2];
  }
  return is;
}

/* Their corners stay where they were. */
static void
block_pair(joining *j, const sg_key_pair *pair)
{
  for (int i = 0; i < 6; i++) {
    uint32_t t = i < 3 ? pair->low : pair->high;
    uint32_t v = j->m->solid->triangle[t][i % 3];
    j->blocked[v] |= sg_disjoint_root(j->up, v) != v;
  }
}

/* Triangles that meet, and did not before, or fold where they are now, get
 * their corners back. *again: there were any. */
static sg_merge_end
block(joining *j, bool *again)
{
  sg_key_pairs after = {0}, before = {0};
  sg_folds folds = {0};
  sg_merge_end end = find_after(j, &after, &folds);

  *again = false;
  if (end == SG_MERGE_DONE && after.n) {
    end = find_before(j, &after, &before);
  }
  for (size_t i = 0; end == SG_MERGE_DONE && i < after.n; i++) {
    if (!sg_key_pairs_have(&before, &after.item[i])) {
      *again = true;
      block_pair(j, &after.item[i]);
    }
  }
  for (size_t i = 0; end == SG_MERGE_DONE && i < folds.n; i++) {
    const sg_key_pair *key = &folds.item[i].key;
    if (is_elsewhere(j, key->low) || is_elsewhere(j, key->high)) {
      *again = true;
      block_pair(j, key);
    }
  }
  free(after.item);
  free(before.item);
  free(folds.item);
  return end;
}

/* Puts vertices together so that nothing meets by it. *any: some were. */
static sg_merge_end
settle(joining *j, bool *any)
{
  bool again = true;

  for (int round = 0; again; round++) {
    if (!join_vertices(j, any)) {
      return SG_MERGE_NO_MEMORY;
    }
    if (!*any || round == ROUNDS) {
      *any = false;
      return SG_MERGE_DONE;
    }
    sg_merge_end end = block(j, &again);
    if (end != SG_MERGE_DONE) {
      return end;
    }
  }
  return SG_MERGE_DONE;
}

/* ---- triangles and faces ------------------------------------------------ */

static bool
make_room(const sg_solid *solid, sg_contracted *out)
{
  out->triangle = malloc((solid->triangles + 1) * sizeof *out->triangle);
  out->auxiliary = malloc(solid->triangles + 1);
  out->face = malloc((solid->faces + 1) * sizeof *out->face);
  out->part = malloc((solid->parts + 1) * sizeof *out->part);
  return out->triangle && out->auxiliary && out->face && out->part;
}

/* The triangles of a face that still have three corners. */
static void
write_triangles(const sg_solid *solid, const sg_solid_face *face, uint32_t *up,
                sg_contracted *out)
{
  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    uint32_t *corner = out->triangle[out->triangles];
    for (int k = 0; k < 3; k++) {
      corner[k] = sg_disjoint_root(up, solid->triangle[t][k]);
    }
    if (corner[0] != corner[1] && corner[1] != corner[2] &&
        corner[2] != corner[0]) {
      out->auxiliary[out->triangles++] = solid->auxiliary[t];
    }
  }
}

static void
write_faces(const sg_solid *solid, uint32_t *up, sg_contracted *out)
{
  size_t next = 0;

  for (uint32_t f = 0; f < solid->faces; f++) {
    uint32_t first = (uint32_t)out->triangles, number = (uint32_t)out->faces;
    write_triangles(solid, &solid->face[f], up, out);
    bool left = out->triangles > first;
    if (left) {
      out->face[out->faces] = solid->face[f];
      out->face[out->faces].first = first;
      out->face[out->faces++].n = (uint32_t)out->triangles - first;
    }
    for (; next < solid->parts && solid->part[next].face == f; next++) {
      if (left) {
        out->part[out->parts] = solid->part[next];
        out->part[out->parts++].face = number;
      }
    }
  }
}

/* Exchanges what the solid has for what is in *other. */
static void
exchange(sg_solid *solid, sg_contracted *other)
{
  sg_contracted kept = *other;

  *other = (sg_contracted){solid->triangle, solid->auxiliary, solid->face,
                           solid->part,     solid->triangles, solid->faces,
                           solid->parts,    kept.up};
  solid->triangle = kept.triangle;
  solid->auxiliary = kept.auxiliary;
  solid->face = kept.face;
  solid->part = kept.part;
  solid->triangles = kept.triangles;
  solid->faces = kept.faces;
  solid->parts = kept.parts;
}

sg_merge_end
sg_merge_contract(const sg_merge *m, sg_solid *solid, sg_contracted *before)
{
  joining j = {m, malloc((solid->vertices + 1) * sizeof *j.up),
               calloc(solid->vertices + 1, sizeof *j.blocked)};
  bool any = false;
  sg_merge_end end = j.up && j.blocked ? settle(&j, &any) : SG_MERGE_NO_MEMORY;

  if (end == SG_MERGE_DONE && any) {
    if (make_room(solid, before)) {
      write_faces(solid, j.up, before);
      exchange(solid, before);
      for (uint32_t v = 0; v < solid->vertices; v++) {
        j.up[v] = sg_disjoint_root(j.up, v);
      }
      before->up = j.up;
      j.up = NULL;
    } else {
      sg_merge_forget(before);
      end = SG_MERGE_NO_MEMORY;
    }
  }
  free(j.up);
  free(j.blocked);
  return end;
}

void
sg_merge_restore(sg_solid *solid, sg_contracted *before)
{
  if (before->triangle) {
    exchange(solid, before);
  }
}

void
sg_merge_forget(sg_contracted *before)
{
  free(before->triangle);
  free(before->auxiliary);
  free(before->face);
  free(before->part);
  free(before->up);
  *before = (sg_contracted){0};
}
