/* owner_rows.c -- which one of faces that lie in one another is seen: what a
 * rule is asked, and what it answers; and which roots do not hide others. */
#include "doors/shading.h"

#include "shading_scene.h"

#include <stdlib.h>

bool
sg_door_shading_ask_owners(sg_call *call, sg_shading *scene)
{
  return sg_shading_ask_owners(scene) || sg_call_no_memory(call);
}

bool
sg_door_shading_let_through(sg_call *call, sg_shading *scene,
                            const sg_shading_pair_list *pairs)
{
  bool good = true;

  for (size_t i = 0; good && i < pairs->n; i++) {
    good =
        sg_shading_let_through(scene, pairs->at[i].front, pairs->at[i].behind);
  }
  return good || sg_call_no_memory(call);
}

static bool
add_group(sg_call *call, const sg_met_group *group, sg_shading_group_list *out)
{
  sg_shading_group fact = {.root = group->root, .begins = group->begins};
  bool good = true;

  for (size_t i = 0; i < group->n && good; i++) {
    good = sg_shading_met_list_add(call, &fact.faces, group->face[i]);
  }
  return good && sg_shading_group_list_add(call, out, fact);
}

bool
sg_door_shading_groups(sg_call *call, sg_shading *scene,
                       sg_shading_group_list *out)
{
  sg_owners *owners = sg_shading_owners(scene);
  size_t n = owners ? sg_owners_asked(owners) : 0, room = 0;
  sg_met_face *face = NULL;
  bool good = true;

  for (size_t i = 0; i < n && good; i++) {
    sg_met_group group;
    good = (sg_owners_group(owners, i, &face, &room, &group) ||
            sg_call_no_memory(call)) &&
           add_group(call, &group, out);
  }
  free(face);
  return good;
}

bool
sg_door_shading_owners(sg_call *call, sg_shading *scene,
                       const sg_count_list *answers)
{
  sg_owners *owners = sg_shading_owners(scene);

  return (owners && sg_owners_answer(owners, answers->at, answers->n)) ||
         sg_call_domain(call, "shading_owners", 2);
}
