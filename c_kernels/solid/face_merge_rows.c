/* face_merge_rows.c -- faces of a solid that become one. */
#include "doors/boolean.h"
#include "face_merge.h"
#include "polygon/flatness.h"
#include "rows/grain_rows.h"
#include "solid_region_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- what sources explain ---- */

typedef struct sources {
  const sg_version *version;
  const sg_solid *solid;
  double tolerance; /* by the rule; 0: it was given */
  bool known;       /* the other two are */
  double coarsest, rounding;
} sources;

static void
see_sources(sources *x)
{
  const sg_solid *solid = x->solid;
  sg_flatness all;

  sg_flatness_init(&all, 0);
  for (size_t v = 0; v < solid->vertices; v++) {
    sg_flatness_see(&all, solid->vertex[v].at);
  }
  x->rounding = sg_flatness_rounding(&all);
  for (size_t f = 0; f < solid->faces; f++) {
    if (f == 0 || solid->face[f].s != solid->face[f - 1].s) {
      x->coarsest =
          fmax(x->coarsest, sg_grain_of(x->version, solid->face[f].s));
    }
  }
  x->known = true;
}

/* Of sg_merge_options. The tolerance by the rule is that of the coarsest
 * segment, if that was rounded. */
static sg_merge_source
source_of(void *data, int32_t s)
{
  sources *x = data;
  sg_flatness own;

  if (!x->known) {
    see_sources(x);
  }
  sg_flatness_init(&own, sg_grain_of(x->version, s));
  double by_rule = own.grain > 0 && own.grain >= x->coarsest ? x->tolerance : 0;

  return (sg_merge_source){
      .rounding = x->rounding,
      .explained =
          fmax(x->rounding, fmax(by_rule, sg_flatness_explained(&own)))};
}

/* Of sg_merge_options. */
static bool
normal_of(void *data, int32_t s, int32_t p, double out[3])
{
  const sources *x = data;
  sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].i = p};
  sg_row row = sg_version_find(x->version, SG_PLANE, key);

  for (unsigned k = 0; k < 3 && row != SG_NO_ROW; k++) {
    out[k] = sg_version_value(x->version, SG_PLANE, row, k + 2).f;
  }
  return row != SG_NO_ROW;
}

/* ---- options ---- */

/* *own: the tolerance if it is own(Number). */
static bool
take_tolerance(sg_call *call, const sg_merge_tolerance *given,
               sg_merge_options *out, double *own)
{
  bool by_rule = given->is == SG_MERGE_TOLERANCE_OWN;

  out->tolerance = by_rule ? given->own.number : given->given;
  *own = by_rule ? out->tolerance : 0;
  return out->tolerance >= 0 || sg_call_domain(call, "not_less_than_zero", 2);
}

static bool
take_apart(sg_call *call, const sg_merge_pair_list *pairs,
           sg_merge_options *out)
{
  sg_merge_pair *pair = sg_call_alloc(call, pairs->n * sizeof *pair);

  for (size_t i = 0; pair && i < pairs->n; i++) {
    pair[i] = pairs->at[i];
    sg_merge_pair_order(&pair[i]);
  }
  if (pair && pairs->n > 0) {
    qsort(pair, pairs->n, sizeof *pair, sg_merge_pair_compare);
  }
  out->apart = pair;
  out->aparts = pairs->n;
  return pair != NULL;
}

static bool
take_option(sg_call *call, const sg_merge_option *option, sg_merge_options *out,
            sg_merge_region *region)
{
  switch (option->is) {
  case SG_MERGE_OPTION_ORIGINS:
    out->separate = option->origins.which == SG_ORIGINS_SEPARATE;
    break;
  case SG_MERGE_OPTION_CELLS:
    out->cells = option->cells.is;
    break;
  case SG_MERGE_OPTION_BY_SIZE:
    out->by_size = option->by_size.is;
    break;
  case SG_MERGE_OPTION_REGION: {
    const sg_old_region *of = &option->region.of->old.region;

    *region = (sg_merge_region){of->leaf, of->leaves, of->box, of->whole};
    out->region = region;
    break;
  }
  case SG_MERGE_OPTION_APART:
    return take_apart(call, &option->apart.pairs, out);
  }
  return true;
}

static bool
refuse(sg_call *call, sg_merge_end end)
{
  return end == SG_MERGE_NO_MEMORY && sg_call_no_memory(call);
}

/* What is tight before what the sources explain. */
static void
give_move(const sg_merge_counts *counts, sg_merge_move *out)
{
  bool is_tight = counts->tight.n > 0;
  const sg_merge_tight *worst = is_tight ? &counts->tight : &counts->rounded;
  const double *at = worst->vertex.at;

  if (worst->n == 0) {
    out->is = SG_MERGE_MOVE_NONE;
    return;
  }
  out->is = SG_MERGE_MOVE_MOVE;
  out->move.how = is_tight ? SG_MOVE_HOW_TIGHT : SG_MOVE_HOW_MOVED;
  out->move.s = worst->vertex.s;
  out->move.at = (sg_space_point){at[0], at[1], at[2]};
  out->move.move = worst->move;
  if (worst->wall) {
    out->move.beside.is = SG_MERGE_BESIDE_WALL;
    out->move.beside.wall.thickness = worst->feature;
  } else {
    out->move.beside.is = SG_MERGE_BESIDE_EDGE;
    out->move.beside.edge.length = worst->feature;
  }
  out->move.n = worst->n;
}

/* ---- the doors ---- */

bool
sg_door_solid_merge(sg_call *call, sg_solid *solid,
                    const sg_merge_tolerance *tolerance,
                    const sg_merge_option_list *options, sg_merge_move *out)
{
  sources of = {.version = sg_call_version(call), .solid = solid};
  sg_merge_counts counts = {0};
  sg_merge_region region;
  sg_merge_options all = {.cancel = &call->cancel,
                          .source = source_of,
                          .normal = normal_of,
                          .data = &of,
                          .pool = sg_call_pool(call)};

  if (!of.version || !all.pool ||
      !take_tolerance(call, tolerance, &all, &of.tolerance)) {
    return false;
  }
  for (size_t i = 0; i < options->n; i++) {
    if (!take_option(call, &options->at[i], &all, &region)) {
      return false;
    }
  }
  sg_merge_end end = sg_face_merge(solid, &all, &counts);

  if (end != SG_MERGE_DONE) {
    return refuse(call, end);
  }
  give_move(&counts, out);
  return true;
}

bool
sg_door_solid_neighbours(sg_call *call, sg_solid *solid,
                         const sg_merge_tolerance *tolerance,
                         sg_merge_pair_list *pairs)
{
  sg_merge_options options = {.cancel = &call->cancel};
  double own;

  if (!take_tolerance(call, tolerance, &options, &own)) {
    return false;
  }
  sg_merge_end end =
      sg_face_merge_pairs(solid, &options, &pairs->at, &pairs->n);

  return end == SG_MERGE_DONE ? sg_call_adopt(call, pairs->at)
                              : refuse(call, end);
}
