/* occluder_rows.c -- the hidden-line joins of one line of a scene. */
#include "scene_rows.h"

#include <stdlib.h>

/* The place of edge (s, e), which must be one that the scene draws; e is the
 * third argument. */
static bool
find_line(sg_call *call, const sg_scene *scene, int32_t s, int32_t e,
          size_t *out)
{
  *out = sg_scene_find(scene, s, e);
  return *out != SIZE_MAX || sg_call_missing(call, "drawn_edge", 3);
}

/* ---- what hides it ---- */

static bool
add_hidden(sg_call *call, const sg_scene *scene, const sg_hiddens *found,
           const int32_t *s2, const int32_t *t, sg_occluder_rows *rows)
{
  bool good = true;

  for (size_t i = 0; good && i < found->n; i++) {
    const sg_hidden *part = &found->part[i];
    const sg_scene_mask *mask = &scene->mask[part->mask];
    good = (s2 && *s2 != mask->s) || (t && *t != mask->t) ||
           sg_occluder_rows_add(
               call, rows,
               (sg_occluder_row){mask->s, mask->t, part->from, part->to});
  }
  return good;
}

bool
sg_door_occluder(sg_call *call, sg_scene_index *index, int32_t s, int32_t e,
                 const int32_t *s2, const int32_t *t, sg_occluder_rows *rows)
{
  const sg_scene *scene = index->scene;
  sg_hiddens found = {0};
  size_t line;

  if (!find_line(call, scene, s, e, &line)) {
    return false;
  }
  bool good =
      ((index->mask_seen.by || sg_seen_init(&index->mask_seen, scene->masks)) &&
       sg_mask_grid_ask(&index->masks, line, NULL, false, &index->mask_seen,
                        &found)) ||
      sg_call_no_memory(call);

  good = good && add_hidden(call, scene, &found, s2, t, rows);
  sg_hiddens_clear(&found);
  return good;
}

/* ---- what lies on it ---- */

/* The grid of all lines, made when it is asked first. */
static bool
make_lines(sg_call *call, sg_scene_index *index)
{
  size_t n = index->scene->lines;
  bool memory;

  if (index->lines.grid[SG_LINE_CLASSES - 1].item) {
    return true;
  }
  sg_line_grid_clear(&index->lines);
  sg_seen_clear(&index->line_seen);
  free(index->every);
  index->every = malloc((n + 1) * sizeof *index->every);
  if (!index->every || !sg_seen_init(&index->line_seen, n)) {
    return sg_call_no_memory(call);
  }
  for (size_t i = 0; i < n; i++) {
    index->every[i] = (uint32_t)i;
  }
  return sg_line_grid_init(&index->lines, index->scene, index->every, n,
                           &call->cancel, &memory) ||
         sg_call_ended(call);
}

static bool
add_overlaps(sg_call *call, const sg_scene *scene, const sg_overlaps *found,
             const int32_t *s2, const int32_t *e2, sg_overlap_rows *rows)
{
  bool good = true;

  for (size_t i = 0; good && i < found->n; i++) {
    const sg_overlap *part = &found->part[i];
    const sg_scene_line *line = &scene->line[part->line];
    good =
        (s2 && *s2 != line->s) || (e2 && *e2 != line->e) ||
        sg_overlap_rows_add(call, rows,
                            (sg_overlap_row){line->s, line->e, part->from,
                                             part->to, part->from2, part->to2});
  }
  return good;
}

bool
sg_door_overlap(sg_call *call, sg_scene_index *index, int32_t s, int32_t e,
                const int32_t *s2, const int32_t *e2, sg_overlap_rows *rows)
{
  sg_overlaps found = {0};
  size_t line;

  if (!find_line(call, index->scene, s, e, &line) || !make_lines(call, index)) {
    return false;
  }
  bool good = sg_line_grid_ask(&index->lines, line, &index->line_seen, &found)
                  ? add_overlaps(call, index->scene, &found, s2, e2, rows)
                  : sg_call_no_memory(call);

  free(found.part);
  return good;
}

/* ---- what covers it, in front or behind ---- */

bool
sg_door_line_covers(sg_call *call, sg_scene_index *index, int32_t s, int32_t e,
                    sg_line_cover_list *covers)
{
  const sg_scene *scene = index->scene;
  bool good = true;
  sg_cover cover;
  size_t line;

  if (!find_line(call, scene, s, e, &line)) {
    return false;
  }
  for (size_t m = 0; good && m < scene->masks; m++) {
    const sg_scene_mask *mask = &scene->mask[m];
    good = !sg_mask_covers(scene, mask, &scene->line[line], &cover) ||
           sg_line_cover_list_add(
               call, covers,
               (sg_line_cover){mask->s, mask->t, cover.from, cover.to,
                               cover.behind[0] * scene->scale,
                               cover.behind[1] * scene->scale});
  }
  return good;
}
