/* drawn4pl.c -- the drawn parts of a scene as rows (documented in
 * kernel/drawing.pl).
 *
 * Layer: glue.
 */
#include "scene4pl.h"

#include "glue.h"
#include "parts.h"

#include "engine/install.h"
#include "engine/symbol.h"

#include <stdlib.h>
#include <string.h>

/* From so many lines on it takes longer to draw them than to start threads. */
enum { MANY_LINES = 8192, POLL_PAGES = 16 };

static atom_t ATOM_all, ATOM_feature, ATOM_penetration;

static int
get_which_ex(term_t t, sg_which *out)
{
  atom_t name;

  if (!PL_get_atom_ex(t, &name)) {
    return FALSE;
  }
  *out = name == ATOM_all       ? SG_LINES_ALL
         : name == ATOM_feature ? SG_LINES_FEATURE
                                : SG_LINES_CUT;
  return *out != SG_LINES_CUT || name == ATOM_penetration ||
         PL_domain_error("lines", t);
}

/* The rows of one page of drawn/7. */
static void
write_page(const sg_sheet_page *page, const sg_scene *scene,
           const sg_part *part, const int32_t role[SG_ROLES])
{
  const sg_blank *to = page->column;

  for (size_t i = 0; i < page->n; i++) {
    const sg_part *p = &part[page->from + i];
    to[0].i[i] = (int32_t)(page->from + i) + 1;
    to[1].i[i] = scene->line[p->line].s;
    to[2].i[i] = scene->line[p->line].e;
    to[3].f[i] = p->from + 0.0;
    to[4].f[i] = p->to + 0.0;
    to[5].i[i] = p->hidden ? SG_SYMBOL_HIDDEN : SG_SYMBOL_VISIBLE;
    to[6].i[i] = role[p->role];
  }
}

static int
append_drawn_ex(sg_world *world, const sg_scene *scene, const sg_part *part,
                size_t n)
{
  int32_t role[SG_ROLES];
  sg_append a;
  int good = TRUE;

  for (unsigned k = 0; k < SG_ROLES; k++) {
    const char *name = sg_role_name((sg_role)k);
    if ((role[k] = sg_symbol_intern(name, strlen(name))) < 0) {
      return sg_no_memory();
    }
  }
  if (!sg_append_open(&a, world, SG_DRAWN, n)) {
    return sg_no_memory();
  }
  for (size_t k = 0; k < a.sheet.pages && good; k++) {
    write_page(&a.sheet.page[k], scene, part, role);
    good = k % POLL_PAGES != POLL_PAGES - 1 || PL_handle_signals() >= 0;
  }
  good = good && (sg_append_commit(&a) || sg_no_memory());
  sg_append_close(&a);
  return good;
}

static int
replace_drawn_ex(const sg_scene *scene, const sg_part *part, size_t n)
{
  sg_world *world = sg_current_world_ex();

  if (!world) {
    return FALSE;
  }
  return (sg_world_retract_all(world, SG_DRAWN) || sg_no_memory()) &&
         (n == 0 || append_drawn_ex(world, scene, part, n));
}

/* Draws a scene. Null: an exception is pending. */
static sg_part *
parts_ex(const sg_mask_grid *masks, const sg_drawing *drawing, size_t *n)
{
  /* no crew is the caller alone */
  sg_crew *crew = masks->scene->lines < MANY_LINES ? NULL : sg_crew_open(0);
  sg_part *part = NULL;
  bool memory = true;

  if (!sg_parts_of(masks, drawing, crew, &sg_prolog_poll, &part, n, &memory) &&
      !memory) {
    sg_no_memory();
  }
  sg_crew_close(crew);
  return part;
}

/* fill_drawn(+Scene, +Which, +Crease, +Through) is det. */
static foreign_t
fill_drawn(term_t scene, term_t which_lines, term_t crease, term_t through)
{
  const sg_mask_grid *masks = NULL;
  sg_hide_through *pair;
  sg_drawing drawing;
  sg_part *part;
  size_t n;
  int ok;

  if (!sg_get_mask_grid_ex(scene, &masks) ||
      !get_which_ex(which_lines, &drawing.which) ||
      !sg_get_finite_ex(crease, &drawing.crease) ||
      !sg_get_through_ex(through, &pair, &drawing.through.n)) {
    return FALSE;
  }
  drawing.through.pair = pair;
  part = parts_ex(masks, &drawing, &n);
  free(pair);
  ok = part && replace_drawn_ex(masks->scene, part, n);
  free(part);
  return ok;
}

void
sg_install_drawn(void)
{
  static const PL_extension doors[] = {
      {"fill_drawn", 4, (pl_function_t)fill_drawn, 0}, {NULL, 0, NULL, 0}};

  ATOM_all = PL_new_atom("all");
  ATOM_feature = PL_new_atom("feature");
  ATOM_penetration = PL_new_atom("penetration");
  PL_register_extensions_in_module("sg_kernel_drawing", doors);
}
