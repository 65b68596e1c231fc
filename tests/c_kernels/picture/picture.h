/* picture.h -- pictures of small models for the tests of hidden lines, and what
 * is drawn in them.
 */
#ifndef SG_TEST_PICTURE_H
#define SG_TEST_PICTURE_H

#include "model.h"
#include "picture/parts.h"
#include "tests/check.h"

typedef struct picture {
  sg_scene_model *model;
  sg_scene *scene;
  sg_mask_grid masks;
  sg_drawn_part *part;
  size_t parts;
} picture;

/* only: as of model_scene_of(). */
static inline void
picture_open_of(picture *p, model *m, const sg_lines_drawn *only,
                sg_which which)
{
  bool memory;

  p->scene = model_scene_of(m, only, NULL, &p->model);
  if (!p->scene || !sg_mask_grid_init(&p->masks, p->scene, NULL, &memory) ||
      !sg_parts_of(&p->masks, &(sg_drawing){.which = which, .crease = 30.0},
                   NULL, NULL, &p->part, &p->parts, &memory)) {
    abort();
  }
}

static inline void
picture_open(picture *p, model *m, sg_which which)
{
  picture_open_of(p, m, NULL, which);
}

static inline void
picture_close(picture *p)
{
  free(p->part);
  sg_mask_grid_clear(&p->masks);
  sg_scene_close(p->scene);
  sg_scene_model_close(p->model);
}

/* The total length in model units of the parts that are (not) hidden. */
static inline double
drawn_length(const picture *p, bool hidden)
{
  double sum = 0;

  for (size_t i = 0; i < p->parts; i++) {
    const sg_drawn_part *part = &p->part[i];
    if (part->hidden == hidden) {
      sum += (part->to - part->from) * p->scene->scale *
             sg_line_length(p->scene, &p->scene->line[part->line]);
    }
  }
  return sum;
}

static inline size_t
drawn_count(const picture *p, bool hidden)
{
  size_t n = 0;

  for (size_t i = 0; i < p->parts; i++) {
    n += p->part[i].hidden == hidden;
  }
  return n;
}

static inline size_t
role_count(const picture *p, sg_role role)
{
  size_t n = 0;

  for (size_t i = 0; i < p->parts; i++) {
    n += p->part[i].role == role;
  }
  return n;
}

/* Length and number of visible and hidden parts are as wanted. */
static inline bool
draws(model *m, sg_which which, size_t visible, double visible_length,
      size_t hidden, double hidden_length)
{
  picture p;
  bool as_wanted;

  picture_open(&p, m, which);
  as_wanted = drawn_count(&p, false) == visible &&
              drawn_count(&p, true) == hidden &&
              fabs(drawn_length(&p, false) - visible_length) < 1e-9 &&
              fabs(drawn_length(&p, true) - hidden_length) < 1e-9;
  if (!as_wanted) {
    fprintf(stderr, "drawn: %zu visible %.12g, %zu hidden %.12g\n",
            drawn_count(&p, false), drawn_length(&p, false),
            drawn_count(&p, true), drawn_length(&p, true));
  }
  picture_close(&p);
  return as_wanted;
}

#endif
