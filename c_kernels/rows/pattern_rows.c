/* pattern_rows.c -- see pattern_rows.h.
 */
#include "pattern_rows.h"
#include "engine/list.h"

#include "by_segment.h"
#include "sort.h"

#include "engine/symbol.h"

#include <stdlib.h>

/* The numbers of the segments that are patterns, ascending: *out null if there
 * is none. False: no memory. */
static bool
find_patterns(const sg_version *version, int32_t **out, size_t *n)
{
  sg_view view;
  size_t room = 0;
  bool good = sg_version_view(version, SG_SEGMENT, &view);

  *out = NULL;
  *n = 0;
  for (size_t i = 0; good && i < view.pages; i++) {
    const int32_t *kind = view.column[1].page[i].i;
    for (unsigned r = sg_live_next(view.live[i], 0); good && r < SG_PAGE_ROWS;
         r = sg_live_next(view.live[i], r + 1)) {
      if (kind[r] == SG_SYMBOL_PATTERN) {
        good = sg_list_grow(out, *n, &room, sizeof **out);
        if (good) {
          (*out)[(*n)++] = view.column[0].page[i].i[r];
        }
      }
    }
  }
  sg_view_clear(&view);
  *n = sg_sort_ids(*out, *n);
  return good;
}

bool
sg_model_view_make(const sg_version *version, sg_relation relation,
                   sg_model_view *out)
{
  int32_t *pattern;
  size_t n;

  *out = (sg_model_view){.parted = false};
  if (!sg_version_view(version, relation, &out->whole)) {
    return false;
  }
  bool good = find_patterns(version, &pattern, &n);

  out->parted = n > 0;
  if (n > 0) {
    good =
        good && sg_segment_view_without(&out->whole, pattern, n, &out->shown);
  } else {
    out->shown = out->whole;
  }
  free(pattern);
  return good;
}

void
sg_model_view_clear(sg_model_view *view)
{
  if (view->parted) {
    sg_segment_view_clear(&view->shown);
  }
  sg_view_clear(&view->whole);
  *view = (sg_model_view){.parted = false};
}
