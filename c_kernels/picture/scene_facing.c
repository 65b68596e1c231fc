/* scene_facing.c -- see scene_facing.h */
#include "scene_facing.h"
#include "engine/search.h"

#include <stdlib.h>

static uint64_t
key_of(const uint32_t *same, uint32_t a, uint32_t b)
{
  uint32_t v = same[a], w = same[b];

  return v < w ? (uint64_t)v << 32 | w : (uint64_t)w << 32 | v;
}

SG_ORDER(compare, sg_keyed_facing, SG_BY(key) SG_BY(facing));

bool
sg_facing_index_init(sg_facing_index *index, const sg_scene_input *in)
{
  size_t n = in->facings;

  *index = (sg_facing_index){.same = in->model->same, .n = n};
  if (n == 0) {
    return true;
  }
  index->item = malloc(n * sizeof *index->item);
  index->has = calloc(in->model->dense.vertices + 1, sizeof *index->has);
  if (!index->item || !index->has) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    const sg_scene_facing *facing = &in->facing[i];
    index->item[i] = (sg_keyed_facing){
        key_of(index->same, facing->v[0], facing->v[1]), facing};
    index->has[index->same[facing->v[0]]] = true;
    index->has[index->same[facing->v[1]]] = true;
  }
  qsort(index->item, n, sizeof *index->item, compare);
  return true;
}

void
sg_facing_index_clear(sg_facing_index *index)
{
  free(index->item);
  free(index->has);
  *index = (sg_facing_index){0};
}

sg_facings
sg_facing_index_find(const sg_facing_index *index, uint32_t a, uint32_t b)
{
  size_t low, end;
  uint64_t key;

  if (index->n == 0 || !index->has[index->same[a]] ||
      !index->has[index->same[b]]) {
    return (sg_facings){0};
  }
  key = key_of(index->same, a, b);
  SG_SEARCH(low, 0, index->n, index->item[low].key < key);
  for (end = low; end < index->n && index->item[end].key == key; end++) {
  }
  return (sg_facings){index->item + low, end - low};
}

size_t
sg_facings_lies(const sg_facings *facings)
{
  size_t sum = 0;

  for (size_t i = 0; i < facings->n; i++) {
    sum += facings->item[i].facing->triangles;
  }
  return sum;
}

sg_scene_fold
sg_facing_fold(const sg_facing_index *index, const sg_scene_facing *facing,
               uint32_t a)
{
  bool forward = index->same[facing->v[0]] == index->same[a];

  return (sg_scene_fold){.s = facing->s,
                         .from = forward ? facing->from : 1.0 - facing->to,
                         .to = forward ? facing->to : 1.0 - facing->from};
}

sg_scene_folds
sg_scene_folds_of(const sg_scene *scene, uint32_t line)
{
  const uint32_t *begin = scene->fold_begin;

  return begin ? (sg_scene_folds){scene->fold + begin[line],
                                  begin[line + 1] - begin[line]}
               : (sg_scene_folds){0};
}
