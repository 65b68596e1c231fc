/* drawn_rows.c -- the drawn parts of a scene as rows. */
#include "parts.h"
#include "scene_rows.h"

#include "engine/search.h"
#include "engine/symbol.h"

#include <stdlib.h>
#include <string.h>

/* From so many lines on it takes longer to draw them than to start threads. */
enum { MANY_LINES = 8192, ASK_PAGES = 16 };

/* The rows of one page of drawn/7. */
static void
write_page(const sg_sheet_page *page, const sg_scene *scene,
           const sg_drawn_part *part, const int32_t role[SG_ROLES])
{
  const sg_blank *to = page->column;

  for (size_t i = 0; i < page->n; i++) {
    const sg_drawn_part *p = &part[page->from + i];
    to[0].i[i] = (int32_t)(page->from + i) + 1;
    to[1].i[i] = scene->line[p->line].s;
    to[2].i[i] = scene->line[p->line].e;
    to[3].f[i] = p->from + 0.0;
    to[4].f[i] = p->to + 0.0;
    to[5].i[i] = p->hidden ? SG_SYMBOL_HIDDEN : SG_SYMBOL_VISIBLE;
    to[6].i[i] = role[p->role];
  }
}

static bool
append_drawn(sg_call *call, const sg_scene *scene, const sg_drawn_part *part,
             size_t n)
{
  int32_t role[SG_ROLES];
  bool good = true;
  sg_append a;

  for (unsigned k = 0; k < SG_ROLES; k++) {
    const char *name = sg_role_name((sg_role)k);
    if ((role[k] = sg_symbol_intern(name, strlen(name))) < 0) {
      return sg_call_no_memory(call);
    }
  }
  if (!sg_append_open(&a, call->world, SG_DRAWN, n)) {
    return sg_call_no_memory(call);
  }
  for (size_t k = 0; k < a.sheet.pages && good; k++) {
    write_page(&a.sheet.page[k], scene, part, role);
    good = k % ASK_PAGES != ASK_PAGES - 1 || !sg_cancelled(&call->cancel);
  }
  good = good && (sg_append_commit(&a) || sg_call_no_memory(call));
  sg_append_close(&a);
  return good;
}

SG_ORDER(compare_pairs, sg_hide_through, SG_BY(s) SG_BY(s2));

/* The pairs in order. */
static bool
sort_through(sg_call *call, const sg_hide_through_list *list,
             sg_hide_throughs *out)
{
  sg_hide_through *pair = sg_call_alloc(call, list->n * sizeof *pair);

  for (size_t i = 0; pair && i < list->n; i++) {
    pair[i] = list->at[i];
  }
  if (list->n > 1 && pair) {
    qsort(pair, list->n, sizeof *pair, compare_pairs);
  }
  *out = (sg_hide_throughs){pair, list->n};
  return pair != NULL;
}

bool
sg_door_fill_drawn(sg_call *call, sg_scene_index *index, sg_which which,
                   double crease, const sg_hide_through_list *through)
{
  const sg_scene *scene = index->scene;
  sg_drawing drawing = {.which = which, .crease = crease};
  sg_world *world = sg_call_world(call);
  sg_drawn_part *part = NULL;
  bool memory;
  size_t n;

  if (!world || !sort_through(call, through, &drawing.through)) {
    return false;
  }
  sg_pool *pool = scene->lines < MANY_LINES ? NULL : sg_call_pool(call);

  if (!sg_parts_of(&index->masks, &drawing, pool, &call->cancel, &part, &n,
                   &memory)) {
    return sg_call_ended(call);
  }
  return sg_call_adopt(call, part) &&
         (sg_world_retract_all(world, SG_DRAWN) || sg_call_no_memory(call)) &&
         (n == 0 || append_drawn(call, scene, part, n));
}
