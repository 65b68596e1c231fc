/* face_look_rows.c -- see face_look_rows.h. */
#include "face_look_rows.h"

bool
sg_face_numbers_read(sg_call *call, const sg_list_count_list *leaves,
                     size_t looks, int argument, sg_face_numbers *out)
{
  size_t n = 0;

  for (size_t i = 0; i < leaves->n; i++) {
    n += leaves->at[i].n;
  }
  uint32_t *first = sg_call_alloc(call, (leaves->n + 2) * sizeof *first);
  uint32_t *of = sg_call_alloc(call, (n + 1) * sizeof *of);
  uint32_t at = 0;

  if (!first || !of) {
    return false;
  }
  first[0] = 0; /* there is no leaf 0 */
  for (size_t i = 0; i < leaves->n; i++) {
    first[i + 1] = at;
    for (size_t j = 0; j < leaves->at[i].n; j++) {
      if (leaves->at[i].at[j] >= looks) {
        return sg_call_domain(call, "shading_look", argument);
      }
      of[at++] = (uint32_t)leaves->at[i].at[j];
    }
  }
  first[leaves->n + 1] = at;
  *out = (sg_face_numbers){first, of};
  return true;
}

bool
sg_opacity_read(sg_call *call, double fact, int argument, uint32_t *out)
{
  if (!(fact >= 0 && fact <= 1)) {
    return sg_call_domain(call, "opacity", argument);
  }
  *out = (uint32_t)(fact * SG_OPAQUE + 0.5);
  return true;
}

bool
sg_opacities_read(sg_call *call, const sg_number_list *looks,
                  const sg_list_count_list *leaves, sg_opacities *out,
                  bool *clear)
{
  uint32_t *opacity = sg_call_alloc(call, (looks->n + 1) * sizeof *opacity);

  *clear = false;
  for (size_t i = 0; opacity && i < looks->n; i++) {
    if (!sg_opacity_read(call, looks->at[i], 3, &opacity[i])) {
      return false;
    }
    *clear = *clear || opacity[i] < SG_OPAQUE;
  }
  out->opacity = opacity;
  return opacity &&
         sg_face_numbers_read(call, leaves, looks->n, 4, &out->numbers);
}
