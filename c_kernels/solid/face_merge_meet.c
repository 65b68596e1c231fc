/* face_merge_meet.c -- new triangles that meet others: see
 * face_merge_private.h.
 *
 * Layer: kernel. Where vertices vanish a face lies a little beside where it
 * was, up to the tolerance; a sheet that was nearer than that is then gone
 * through, or lies in the same place. Whether triangles meet is exact, on the
 * doubles; whether they fold is not. Asked are the new triangles alone, beside
 * what is near them: a mesh in which little changes costs a look at each
 * triangle.
 *
 * Faces with very many triangles whose boxes lie over each other (a round one
 * with more than about a thousand corners) are not asked about: that would
 * take time by the square of them.
 */
#include "face_merge_sheet.h"

#include "engine/search.h"

#include <math.h>
#include <stdlib.h>

enum {
  OFTEN = 1 << 12, /* faces between questions */
  DEPTH = 64,      /* boxes of triangles of a face over each other, on average;
                      or: */
  PAIRS = 1 << 17  /* of boxes over each other, in a face */
};

/* What is round the triangles of a group, and the sum over each of them. */
typedef struct extent {
  double low[3], high[3], sum;
} extent;

/* Adds the old triangles of a face, or those of them that are near. */
static bool
add_face(sg_sheet *sheet, uint32_t face, bool all)
{
  const sg_solid *solid = sheet->m->solid;
  const sg_solid_face *row = &solid->face[face];
  uint32_t label = sg_half_label(sheet->m, 3 * row->first);

  for (uint32_t t = row->first; t < row->first + row->n; t++) {
    if ((all || sg_sheet_is_near(sheet, solid->triangle[t])) &&
        !sg_sheet_add(sheet, solid->triangle[t], label)) {
      return false;
    }
  }
  return true;
}

/* Adds the triangles of a group: what it had before, or has now. */
static bool
add_group(sg_sheet *sheet, const sg_group *group, bool before)
{
  const sg_merge *m = sheet->m;
  uint32_t label = (uint32_t)(m->solid->faces + (size_t)(group - m->group));

  for (uint32_t i = 0; before && i < group->n; i++) {
    if (!add_face(sheet, m->member[group->first + i], true)) {
      return false;
    }
  }
  for (size_t t = 0; !before && t < group->triangles; t++) {
    if (!sg_sheet_add(sheet, group->triangle[t], label)) {
      return false;
    }
  }
  return true;
}

static sg_merge_end
add_others(sg_sheet *sheet, const bool *asked)
{
  const sg_merge *m = sheet->m;

  for (uint32_t f = 0; f < m->solid->faces; f++) {
    if (f % OFTEN == 0 && sg_cancelled(m->options->cancel)) {
      return SG_MERGE_STOPPED;
    }
    if ((m->group_of[f] == SG_NOTHING || !asked[m->group_of[f]]) &&
        !add_face(sheet, f, false)) {
      return SG_MERGE_NO_MEMORY;
    }
  }
  return SG_MERGE_DONE;
}

/* The labels of faces and groups that meet, one of them a group that is asked
 * about; and of those that fold, if that is not null. */
static sg_merge_end
find_pairs(const sg_merge *m, const bool *asked, bool before, sg_key_pairs *out,
           sg_folds *folds)
{
  sg_sheet sheet = {.m = m};
  bool memory = true;
  sg_merge_end end = SG_MERGE_NO_MEMORY;

  for (size_t i = 0; memory && i < m->groups; i++) {
    memory = !asked[i] || add_group(&sheet, &m->group[i], before);
  }
  if (memory && sg_sheet_mark(&sheet)) {
    end = add_others(&sheet, asked);
  }
  if (end == SG_MERGE_DONE && folds) {
    end = sg_sheet_folds(&sheet, folds);
  }
  if (end == SG_MERGE_DONE) {
    end = sg_sheet_meet(&sheet, out);
  }
  sg_sheet_clear(&sheet);
  return end;
}

/* ---- which groups ------------------------------------------------------- */

/* The product of the two largest sides of a box. */
static double
box_area(const double low[3], const double high[3])
{
  double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];

  return fmax(x * y, fmax(y * z, z * x));
}

static void
add_extent(const sg_merge *m, const uint32_t corner[3], extent *e)
{
  double low[3], high[3];

  for (int k = 0; k < 3; k++) {
    low[k] = INFINITY;
    high[k] = -INFINITY;
    for (int i = 0; i < 3; i++) {
      double x = sg_merge_at(m, corner[i])[k];
      low[k] = fmin(low[k], x);
      high[k] = fmax(high[k], x);
    }
    e->low[k] = fmin(e->low[k], low[k]);
    e->high[k] = fmax(e->high[k], high[k]);
  }
  e->sum += box_area(low, high);
}

/* Whether a group has new triangles, and their boxes are enough apart. */
static bool
may_be_asked(const sg_merge *m, const sg_group *group)
{
  extent e = {
      {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0};

  if (!group->triangle) {
    return false;
  }
  for (size_t t = 0; t < group->triangles; t++) {
    add_extent(m, group->triangle[t], &e);
  }
  double all = box_area(e.low, e.high);
  return e.sum <= DEPTH * all ||
         (double)group->triangles * e.sum <= PAIRS * all;
}

/* The group of a label, if it has new triangles. */
static sg_group *
changed_group(const sg_merge *m, uint32_t label)
{
  uint32_t faces = (uint32_t)m->solid->faces;

  return label >= faces && m->group[label - faces].triangle
             ? &m->group[label - faces]
             : NULL;
}

/* Of the groups asked about only those in pairs. */
static bool
keep_asking(const sg_merge *m, const sg_key_pairs *pairs, bool *asked)
{
  bool *wanted = calloc(m->groups + 1, sizeof *wanted);

  for (size_t i = 0; wanted && i < 2 * pairs->n; i++) {
    const sg_key_pair *pair = &pairs->item[i / 2];
    const sg_group *group = changed_group(m, i % 2 ? pair->high : pair->low);
    if (group) {
      wanted[group - m->group] = true;
    }
  }
  for (size_t i = 0; wanted && i < m->groups; i++) {
    asked[i] = asked[i] && wanted[i];
  }
  bool memory = wanted;
  free(wanted);
  return memory;
}

static void
note_failure(const sg_merge *m, const sg_key_pair *pair)
{
  for (int i = 0; i < 2; i++) {
    sg_group *group = changed_group(m, i ? pair->high : pair->low);
    if (group) {
      group->failed = true;
    }
  }
}

/* Groups that meet what they did not meet before have failed. */
static void
note_met(const sg_merge *m, const sg_key_pairs *after,
         const sg_key_pairs *before)
{
  for (size_t i = 0; i < after->n; i++) {
    if (!sg_key_pairs_have(before, &after->item[i])) {
      note_failure(m, &after->item[i]);
    }
  }
}

/* ---- two sides in one place --------------------------------------------- */

/* How many edges a polygon of n triangles has: those of one triangle alone.
 * False: no memory. */
static bool
count_edges(const uint32_t (*triangle)[3], size_t n, size_t *edges)
{
  uint64_t *key = malloc((3 * n + 1) * sizeof *key);

  for (size_t i = 0; key && i < 3 * n; i++) {
    uint64_t v = triangle[i / 3][i % 3], w = triangle[i / 3][(i + 1) % 3];
    key[i] = v < w ? v << 32 | w : w << 32 | v;
  }
  if (!key) {
    return false;
  }
  qsort(key, 3 * n, sizeof *key, sg_compare_keys);
  *edges = 0;
  for (size_t i = 0; i < 3 * n; i++) {
    *edges += (i == 0 || key[i] != key[i - 1]) &&
              (i + 1 == 3 * n || key[i] != key[i + 1]);
  }
  free(key);
  return true;
}

/* One of two groups folds with the other face at n edges, and has no more.
 * False: no memory. */
static bool
fold_all_round(const sg_merge *m, const sg_key_pair *pair, size_t n, bool *out)
{
  bool memory = true;

  *out = false;
  for (int i = 0; memory && i < 2; i++) {
    const sg_group *group = changed_group(m, i ? pair->high : pair->low);
    size_t edges = 0;

    memory = !group || count_edges((const uint32_t(*)[3])group->triangle,
                                   group->triangles, &edges);
    *out = *out || (group && edges == n);
  }
  return memory;
}

/* Groups that would be one side of a wall of no thickness have failed. False:
 * no memory. */
static bool
note_folded(const sg_merge *m, const sg_folds *folds)
{
  bool memory = true;

  for (size_t i = 0, end; memory && i < folds->n; i = end) {
    const sg_key_pair *key = &folds->item[i].key;
    for (end = i + 1; end < folds->n && folds->item[end].key.low == key->low &&
                      folds->item[end].key.high == key->high;
         end++) {
    }
    if (end - i > 2) {
      bool folded;
      memory = fold_all_round(m, key, end - i, &folded);
      if (folded) {
        note_failure(m, key);
      }
    }
  }
  return memory;
}

/* ---- all of it ---------------------------------------------------------- */

sg_merge_end
sg_merge_meet(sg_merge *m)
{
  bool *asked = calloc(m->groups + 1, sizeof *asked), any = false;
  sg_key_pairs after = {0}, before = {0};
  sg_folds folds = {0};
  sg_merge_end end = asked ? SG_MERGE_DONE : SG_MERGE_NO_MEMORY;

  for (size_t i = 0; asked && i < m->groups; i++) {
    asked[i] = may_be_asked(m, &m->group[i]);
    any = any || asked[i];
  }
  if (any) {
    end = find_pairs(m, asked, false, &after, &folds);
  }
  if (end == SG_MERGE_DONE && after.n) {
    end = keep_asking(m, &after, asked)
              ? find_pairs(m, asked, true, &before, NULL)
              : SG_MERGE_NO_MEMORY;
  }
  if (end == SG_MERGE_DONE) {
    note_met(m, &after, &before);
    end = note_folded(m, &folds) ? SG_MERGE_DONE : SG_MERGE_NO_MEMORY;
  }
  free(asked);
  free(after.item);
  free(before.item);
  free(folds.item);
  return end;
}
