/* covers4pl.c -- what lies on a line of a scene, in front or behind (documented
 * in kernel/drawing.pl).
 *
 * Layer: glue.
 */
#include "scene4pl.h"

#include "glue.h"

#include "engine/install.h"

static functor_t FUNCTOR_covers6;

/* covers(S, T, From, To, Behind1, Behind2): the last two as
 * the difference of Zs times the depth of the scene. */
static int
unify_cover(term_t t, const sg_scene_mask *mask, const sg_cover *cover,
            double scale)
{
  return PL_unify_term(t, PL_FUNCTOR, FUNCTOR_covers6, PL_INT, (int)mask->s,
                       PL_INT, (int)mask->t, PL_FLOAT, cover->from, PL_FLOAT,
                       cover->to, PL_FLOAT, cover->behind[0] * scale + 0.0,
                       PL_FLOAT, cover->behind[1] * scale + 0.0);
}

/* line_covers(+Scene, +S, +E, -Covers) is det: one pass over the masks. */
static foreign_t
line_covers(term_t scene_term, term_t s, term_t e, term_t covers)
{
  term_t list = PL_copy_term_ref(covers), head = PL_new_term_ref();
  const sg_mask_grid *masks = NULL;
  sg_cover cover;
  size_t at;

  if (!sg_get_mask_grid_ex(scene_term, &masks) ||
      !sg_get_scene_line_ex(masks->scene, s, e, &at)) {
    return FALSE;
  }
  const sg_scene *scene = masks->scene;

  for (size_t m = 0; m < scene->masks; m++) {
    const sg_scene_mask *mask = &scene->mask[m];

    if (sg_mask_covers(scene, mask, &scene->line[at], &cover) &&
        (!PL_unify_list(list, head, list) ||
         !unify_cover(head, mask, &cover, scene->scale))) {
      return FALSE;
    }
  }
  return PL_unify_nil(list);
}

void
sg_install_covers(void)
{
  static const PL_extension doors[] = {
      {"line_covers", 4, (pl_function_t)line_covers, 0}, {NULL, 0, NULL, 0}};

  FUNCTOR_covers6 = PL_new_functor(PL_new_atom("covers"), 6);
  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
