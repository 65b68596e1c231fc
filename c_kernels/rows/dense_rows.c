/* dense_rows.c -- see dense_rows.h. */
#include "dense_rows.h"

#include "grain_rows.h"
#include "pattern_rows.h"

/* The views of what a sg_dense is made from. */
enum { VIEWS = 4 };

static const sg_relation seen[VIEWS] = {SG_V, SG_E, SG_P, SG_T};

static bool
make_dense(sg_call *call, const sg_version *version, const int32_t *wanted,
           size_t n, sg_dense *out, bool *stopped)
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
    good = sg_dense_make(&views, wanted, n, &call->cancel, out, stopped);
    for (size_t s = 0; good && s < out->segments; s++) {
      out->grain[s] = sg_grain_of(version, out->segment[s]);
    }
  }
  for (int k = 0; k < VIEWS; k++) {
    sg_model_view_clear(&view[k]);
  }
  return good;
}

bool
sg_dense_read(sg_call *call, const int32_t *wanted, size_t n, sg_dense *out)
{
  const sg_version *version = sg_call_version(call);
  bool stopped;

  *out = (sg_dense){0};
  return version && (make_dense(call, version, wanted, n, out, &stopped) ||
                     sg_call_ended(call));
}

bool
sg_dense_read_these(sg_call *call, const sg_int_list *wanted, sg_dense *out)
{
  static const int32_t none;

  return sg_dense_read(call, wanted->n > 0 ? wanted->at : &none, wanted->n,
                       out);
}
