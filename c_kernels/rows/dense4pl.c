/* dense4pl.c -- segments of the current world as flat arrays: see dense4pl.h.
 */
#include "dense4pl.h"

#include "glue.h"
#include "grain4pl.h"
#include "pattern4pl.h"

#include "engine/world4pl.h"

/* The views of what a sg_dense is made from. */
enum { VIEWS = 4 };

static const sg_relation seen[VIEWS] = {SG_V, SG_E, SG_P, SG_T};

static bool
make_dense(const sg_version *version, const int32_t *wanted, size_t n,
           sg_dense *out, bool *stopped)
{
  sg_model_view view[VIEWS] = {{.parted = false}};
  bool good = true;

  for (int k = 0; k < VIEWS && good; k++) {
    good = wanted ? sg_version_view(version, seen[k], &view[k].whole)
                  : sg_model_view_make(version, seen[k], &view[k]);
    view[k].shown = wanted ? view[k].whole : view[k].shown;
  }
  if (good) {
    const sg_dense_views views = {view[0].shown, view[1].shown, view[2].shown,
                                  view[3].shown};
    good = sg_dense_make(&views, wanted, n, &sg_prolog_poll, out, stopped);
    for (size_t s = 0; good && s < out->segments; s++) {
      out->grain[s] = sg_grain_of(version, out->segment[s]);
    }
  }
  for (int k = 0; k < VIEWS; k++) {
    sg_model_view_clear(&view[k]);
  }
  return good;
}

int
sg_get_dense_ex(const int32_t *wanted, size_t n, sg_dense *out)
{
  sg_world *world = sg_current_world_ex();
  const sg_version *version = world ? sg_world_version(world) : NULL;
  bool stopped = false;

  *out = (sg_dense){0};
  if (!version) {
    return world ? sg_no_memory() : FALSE;
  }
  bool made = make_dense(version, wanted, n, out, &stopped);

  sg_version_drop(version);
  return made || (stopped ? FALSE : sg_no_memory());
}
