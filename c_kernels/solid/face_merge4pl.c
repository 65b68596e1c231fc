/* face_merge4pl.c -- faces of a solid that become one.
 *
 * Layer: glue. The doors are documented in rules/kernel/boolean.pl.
 */
#include "solid4pl.h"
#include "solid_region4pl.h"

#include "face_merge.h"
#include "glue.h"
#include "polygon/flatness.h"
#include "rows/grain_rows.h"

#include "engine/install.h"

#include <math.h>
#include <stdlib.h>

static atom_t atom_separate, atom_together;
static functor_t functor_part3, functor_minus2, functor_origins1,
    functor_apart1, functor_by_size1, functor_region1, functor_own1;

static int
failed(sg_merge_end end)
{
  return end == SG_MERGE_NO_MEMORY ? sg_no_memory() : FALSE;
}

static int
get_tolerance_ex(term_t t, double *out)
{
  return sg_get_finite_ex(t, out) &&
         (*out >= 0 || PL_domain_error("not_less_than_zero", t));
}

/* part(S, P, Sense). */
static int
get_side_ex(term_t t, sg_merge_side *out)
{
  term_t arg = PL_new_term_ref();
  int32_t sense;

  if (!PL_is_functor(t, functor_part3)) {
    return PL_type_error("part", t);
  }
  if (!PL_get_arg(1, t, arg) || !sg_get_id_ex(arg, &out->s) ||
      !PL_get_arg(2, t, arg) || !sg_get_id_ex(arg, &out->p) ||
      !PL_get_arg(3, t, arg) || !sg_get_int32_ex(arg, &sense)) {
    return FALSE;
  }
  out->reversed = sense == -1;
  return sense == 1 || sense == -1 || PL_domain_error("sense", arg);
}

static int
get_pair_ex(term_t t, sg_merge_pair *out)
{
  term_t arg = PL_new_term_ref();

  if (!PL_is_functor(t, functor_minus2)) {
    return PL_type_error("pair", t);
  }
  if (!PL_get_arg(1, t, arg) || !get_side_ex(arg, &out->one) ||
      !PL_get_arg(2, t, arg) || !get_side_ex(arg, &out->other)) {
    return FALSE;
  }
  sg_merge_pair_order(out);
  return TRUE;
}

/* A list of pairs, sorted, into a fresh array. */
static int
get_pairs_ex(term_t list, sg_merge_pair **out, size_t *n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  size_t length;

  if (PL_skip_list(list, 0, &length) != PL_LIST) {
    return PL_type_error("list", list);
  }
  free(*out);
  *out = malloc((length + 1) * sizeof **out);
  *n = 0;
  if (!*out) {
    return sg_no_memory();
  }
  while (PL_get_list_ex(tail, head, tail)) {
    if (!get_pair_ex(head, &(*out)[*n])) {
      return FALSE;
    }
    ++*n;
  }
  qsort(*out, *n, sizeof **out, sg_merge_pair_compare);
  return PL_get_nil_ex(tail);
}

static int
get_origins_ex(term_t t, bool *separate)
{
  atom_t atom;

  if (!PL_get_atom_ex(t, &atom)) {
    return FALSE;
  }
  *separate = atom == atom_separate;
  return *separate || atom == atom_together || PL_domain_error("origins", t);
}

/* Of an open region. */
static int
get_merge_region_ex(term_t t, sg_merge_region *out)
{
  sg_region_handle *h;

  if (!sg_get_region_ex(t, &h)) {
    return FALSE;
  }
  const sg_old_region *region = &h->old.region;

  *out = (sg_merge_region){region->leaf, region->leaves, region->box,
                           region->whole};
  return TRUE;
}

static int
get_flag_ex(term_t t, bool *out)
{
  int flag = 0;
  int good = PL_get_bool_ex(t, &flag);

  *out = flag;
  return good;
}

/* Those that are ours; others are somebody else's. */
static int
get_options_ex(term_t list, sg_merge_options *out, sg_merge_pair **apart,
               sg_merge_region *region)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();

  while (PL_get_list_ex(tail, head, tail)) {
    if ((PL_is_functor(head, functor_origins1) &&
         (!PL_get_arg(1, head, arg) || !get_origins_ex(arg, &out->separate))) ||
        (PL_is_functor(head, functor_apart1) &&
         (!PL_get_arg(1, head, arg) ||
          !get_pairs_ex(arg, apart, &out->aparts))) ||
        (PL_is_functor(head, functor_by_size1) &&
         (!PL_get_arg(1, head, arg) || !get_flag_ex(arg, &out->by_size))) ||
        (PL_is_functor(head, functor_region1) &&
         (!PL_get_arg(1, head, arg) || !get_merge_region_ex(arg, region)))) {
      return FALSE;
    }
    out->region = region->s ? region : NULL;
  }
  out->apart = *apart;
  return PL_get_nil_ex(tail);
}

/* ---- what sources explain ---- */

typedef struct sources {
  const sg_solid *solid;
  double tolerance; /* by the rule; 0: it was given */
  bool known;       /* the other two are */
  double coarsest, rounding;
} sources;

static void
see_sources(sources *x, const sg_version *version)
{
  const sg_solid *solid = x->solid;
  sg_flatness all;

  sg_flatness_init(&all, 0);
  for (size_t v = 0; v < solid->vertices; v++) {
    sg_flatness_see(&all, solid->vertex[v].at);
  }
  x->rounding = sg_flatness_touch(&all);
  for (size_t f = 0; f < solid->faces; f++) {
    if (f == 0 || solid->face[f].s != solid->face[f - 1].s) {
      x->coarsest = fmax(x->coarsest, sg_grain_of(version, solid->face[f].s));
    }
  }
  x->known = true;
}

/* Of sg_merge_options. The tolerance is that of the coarsest segment. */
static double
explained(void *data, int32_t s)
{
  sources *x = data;
  sg_world *world = sg_current_world_ex();
  sg_flatness own;

  if (!world) {
    return 0;
  }
  const sg_version *version = sg_world_version(world);

  if (!x->known) {
    see_sources(x, version);
  }
  sg_flatness_init(&own, sg_grain_of(version, s));
  sg_version_drop(version);
  return x->tolerance > 0 && own.grain >= x->coarsest
             ? x->tolerance
             : fmax(sg_flatness_touch(&own),
                    x->tolerance > 0 ? x->rounding : 0);
}

/* A number, or own(Number): that of the coarsest segment. */
static int
get_own_tolerance_ex(term_t t, double *out, sources *x)
{
  term_t arg = PL_new_term_ref();

  if (!PL_is_functor(t, functor_own1)) {
    return get_tolerance_ex(t, out);
  }
  if (!PL_get_arg(1, t, arg) || !get_tolerance_ex(arg, out)) {
    return FALSE;
  }
  x->tolerance = *out;
  return TRUE;
}

static int
unify_tight(term_t t, const sg_merge_tight *tight)
{
  const sg_solid_vertex *v = &tight->vertex;

  return tight->n == 0
             ? PL_unify_atom_chars(t, "none")
             : PL_unify_term(t, PL_FUNCTOR_CHARS, "tight", 7, PL_INT, v->s,
                             PL_FLOAT, v->at[0] + 0.0, PL_FLOAT, v->at[1] + 0.0,
                             PL_FLOAT, v->at[2] + 0.0, PL_FLOAT, tight->move,
                             PL_FLOAT, tight->feature, PL_INT64,
                             (int64_t)tight->n);
}

/* solid_merge(+Solid, +Tolerance, +Options, -Tight) is semidet: fails if it is
 * apart. */
static foreign_t
solid_merge(term_t t, term_t tolerance, term_t list, term_t tight)
{
  sg_merge_counts counts = {0};
  sg_merge_options options = {.poll = &sg_prolog_poll};
  sg_merge_pair *apart = NULL;
  sg_merge_region region = {.n = 0};
  sg_merge_end end = SG_MERGE_NO_MEMORY;
  sources of = {0};
  sg_solid *solid;

  if (!sg_get_solid_ex(t, &solid) ||
      !get_own_tolerance_ex(tolerance, &options.tolerance, &of) ||
      !get_options_ex(list, &options, &apart, &region)) {
    free(apart);
    return FALSE;
  }
  of.solid = solid;
  options.explained = explained;
  options.data = &of;
  options.crew = sg_crew_open(0);
  if (options.crew) {
    end = sg_face_merge(solid, &options, &counts);
  }
  sg_crew_close(options.crew);
  free(apart);
  return end == SG_MERGE_DONE ? unify_tight(tight, &counts.tight) : failed(end);
}

static int
unify_pairs(term_t list, const sg_merge_pair *pair, size_t n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < n; i++) {
    const sg_merge_side *a = &pair[i].one, *b = &pair[i].other;
    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR, functor_minus2, PL_FUNCTOR,
                       functor_part3, PL_INT, a->s, PL_INT, a->p, PL_INT,
                       a->reversed ? -1 : 1, PL_FUNCTOR, functor_part3, PL_INT,
                       b->s, PL_INT, b->p, PL_INT, b->reversed ? -1 : 1)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* solid_neighbours(+Solid, +Tolerance, -Pairs) is det. */
static foreign_t
solid_neighbours(term_t t, term_t tolerance, term_t pairs)
{
  sg_merge_options options = {.poll = &sg_prolog_poll};
  sg_merge_pair *pair = NULL;
  sources of = {0};
  sg_solid *solid;
  size_t n = 0;

  if (!sg_get_solid_ex(t, &solid) ||
      !get_own_tolerance_ex(tolerance, &options.tolerance, &of)) {
    return FALSE;
  }
  sg_merge_end end = sg_face_merge_pairs(solid, &options, &pair, &n);
  int good = end == SG_MERGE_DONE ? unify_pairs(pairs, pair, n) : failed(end);
  free(pair);
  return good;
}

static const PL_extension predicates[] = {
    {"solid_merge", 4, solid_merge, 0},
    {"solid_neighbours", 3, solid_neighbours, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_face_merge(void)
{
  atom_separate = PL_new_atom("separate");
  atom_together = PL_new_atom("together");
  functor_part3 = PL_new_functor(PL_new_atom("part"), 3);
  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  functor_origins1 = PL_new_functor(PL_new_atom("origins"), 1);
  functor_own1 = PL_new_functor(PL_new_atom("own"), 1);
  functor_region1 = PL_new_functor(PL_new_atom("region"), 1);
  functor_by_size1 = PL_new_functor(PL_new_atom("by_size"), 1);
  functor_apart1 = PL_new_functor(PL_new_atom("apart"), 1);
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
