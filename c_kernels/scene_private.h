/* scene_private.h -- what scene.c and scene_lines.c share while they build.
 *
 * Layer: kernel. Building goes in the order of the struct: places, faces,
 * lines, looks, masks. Everything that is looked up is a sorted array.
 */
#ifndef SG_SCENE_PRIVATE_H
#define SG_SCENE_PRIVATE_H

#include "keys.h"
#include "scene.h"
#include "sort.h"

/* A polygon: the sum of its triangles' normals, in the model and the picture.
 */
typedef struct sg_scene_face {
  int32_t s, p;
  double model[3], screen[3];
  int facing; /* 1 towards the eye, -1 away, 0 edge-on */
} sg_scene_face;

/* The two ends of a directed edge, smaller place first. */
typedef struct sg_scene_pair {
  uint32_t low, high;
  uint32_t edge; /* place in input->edge */
} sg_scene_pair;

typedef struct sg_scene_builder {
  sg_scene_input *in;
  const sg_poll *poll;
  sg_scene *scene;
  sg_keys segments, vertices, edges, faces;
  sg_scene_face *face;
  sg_scene_pair *pair;
  size_t pairs;
  uint32_t *line_of; /* [in->edges], or UINT32_MAX */
  uint32_t *use_at;  /* [lines + 2]: first use of each line */
  uint32_t *user;    /* [in->uses]: places in in->use, line by line */
  bool stopped;
} sg_scene_builder;

enum { SG_SCENE_POLL = 4096 };

/* True from the moment when the poll says stop; asked at every i. */
static inline bool
sg_scene_stop(sg_scene_builder *b, size_t i)
{
  return i % SG_SCENE_POLL == 0 && (b->stopped |= sg_poll_stop(b->poll));
}

/* Sorts, unless stopped; false: no memory. */
static inline bool
sg_scene_sort(sg_scene_builder *b, void *base, size_t n, size_t size,
              sg_sort_compare *compare)
{
  sg_sort_end end =
      b->stopped ? SG_SORTED : sg_sort(base, n, size, compare, b->poll);

  b->stopped |= end == SG_SORT_STOPPED;
  return end != SG_SORT_NO_MEMORY;
}

/* Both: false means no memory. */
bool sg_scene_make_lines(sg_scene_builder *b);
bool sg_scene_make_looks(sg_scene_builder *b);

#endif
