/* census4pl.c -- the census of the current world (documented in
 * kernel/world.pl).
 *
 * Layer: glue.
 */
#include "census.h"
#include "glue.h"
#include "rows/dense4pl.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <stdlib.h>
#include <string.h>

static atom_t defect_atom[SG_DEFECTS];

static int
get_census_ex(sg_census *out)
{
  sg_dense dense;
  bool stopped = false;
  int done = sg_get_dense_ex(NULL, 0, &dense);

  *out = (sg_census){0};
  if (done && !sg_census_make(&dense, &sg_prolog_poll, out, &stopped)) {
    done = stopped ? FALSE : sg_no_memory();
  }
  sg_dense_clear(&dense);
  return done;
}

static int
unify_shell(term_t t, const sg_shell *s)
{
  return PL_unify_term(
      t, PL_FUNCTOR_CHARS, "shell", 10, PL_INT, (int)s->polygon, PL_INT64,
      (int64_t)s->vertices, PL_INT64, (int64_t)s->edges, PL_INT64,
      (int64_t)s->polygons, PL_INT64, s->euler, PL_BOOL, (int)s->closed,
      PL_BOOL, (int)s->pinched, PL_FLOAT, s->area + 0.0, PL_FLOAT,
      s->volume + 0.0, PL_INT64, (int64_t)s->depth);
}

/* [Name-Count, ...] of the kinds that there are. */
static int
unify_counts(term_t t, const sg_part *part)
{
  term_t tail = PL_copy_term_ref(t), head = PL_new_term_ref();

  for (int k = 0; k < SG_DEFECTS; k++) {
    if (part->defects[k] &&
        (!PL_unify_list(tail, head, tail) ||
         !PL_unify_term(head, PL_FUNCTOR_CHARS, "-", 2, PL_ATOM, defect_atom[k],
                        PL_INT64, (int64_t)part->defects[k]))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static int
unify_part(term_t t, const sg_census *census, const sg_part *p)
{
  term_t shells = PL_new_term_ref(), counts = PL_new_term_ref();
  term_t tail = PL_copy_term_ref(shells), head = PL_new_term_ref();

  for (size_t i = 0; i < p->shells; i++) {
    if (!PL_unify_list(tail, head, tail) ||
        !unify_shell(head, &census->shell[p->first_shell + i])) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail) && unify_counts(counts, p) &&
         PL_unify_term(
             t, PL_FUNCTOR_CHARS, "part", 8, PL_INT, (int)p->segment,
             PL_FUNCTOR_CHARS, "counts", 6, PL_INT64, (int64_t)p->vertices,
             PL_INT64, (int64_t)p->half_edges, PL_INT64, (int64_t)p->edges,
             PL_INT64, (int64_t)p->polygons, PL_INT64, (int64_t)p->triangles,
             PL_INT64, (int64_t)p->curve_edges, PL_FUNCTOR_CHARS, "box", 6,
             PL_FLOAT, p->low[0], PL_FLOAT, p->low[1], PL_FLOAT, p->low[2],
             PL_FLOAT, p->high[0], PL_FLOAT, p->high[1], PL_FLOAT, p->high[2],
             PL_FLOAT, p->area + 0.0, PL_FLOAT, p->volume + 0.0, PL_FLOAT,
             p->length + 0.0, PL_TERM, shells, PL_TERM, counts);
}

/* census(-Parts) is det. */
static foreign_t
census(term_t parts)
{
  sg_census c;
  term_t tail = PL_copy_term_ref(parts), head = PL_new_term_ref();
  int done = get_census_ex(&c);

  for (size_t i = 0; done && i < c.parts; i++) {
    done = PL_unify_list(tail, head, tail) && unify_part(head, &c, &c.part[i]);
  }
  done = done && PL_unify_nil(tail);
  sg_census_clear(&c);
  return done;
}

/* census_defect(?Kind, ?S, ?A, ?B) is nondet. */
typedef struct walk {
  sg_census census;
  size_t at;
  atom_t kind; /* 0: any */
  int segment; /* 0: any */
} walk;

static bool
find_next(walk *w)
{
  for (; w->at < w->census.defects; w->at++) {
    const sg_defect *d = &w->census.defect[w->at];
    if ((!w->kind || w->kind == defect_atom[d->kind]) &&
        (!w->segment || w->segment == d->segment)) {
      return true;
    }
  }
  return false;
}

static void
close_walk(walk *w)
{
  sg_census_clear(&w->census);
  free(w);
}

static foreign_t
census_defect(term_t kind, term_t s, term_t a, term_t b, control_t handle)
{
  walk *w = NULL;

  switch (PL_foreign_control(handle)) {
  case PL_FIRST_CALL:
    if (!(w = calloc(1, sizeof *w))) {
      return sg_no_memory();
    }
    if (!get_census_ex(&w->census)) {
      close_walk(w);
      return FALSE;
    }
    if (!PL_get_atom(kind, &w->kind)) {
      w->kind = 0;
    }
    if (!PL_get_integer(s, &w->segment)) {
      w->segment = 0;
    }
    break;
  case PL_REDO:
    w = PL_foreign_context_address(handle);
    break;
  case PL_PRUNED:
    close_walk(PL_foreign_context_address(handle));
    return TRUE;
  default:
    return FALSE;
  }
  fid_t frame = PL_open_foreign_frame();
  while (frame && find_next(w)) {
    const sg_defect *d = &w->census.defect[w->at++];
    if (PL_unify_atom(kind, defect_atom[d->kind]) &&
        PL_unify_integer(s, d->segment) && PL_unify_integer(a, d->a) &&
        PL_unify_integer(b, d->b)) {
      PL_close_foreign_frame(frame);
      if (find_next(w)) {
        PL_retry_address(w);
      }
      close_walk(w);
      return TRUE;
    }
    PL_rewind_foreign_frame(frame);
  }
  PL_close_foreign_frame(frame);
  close_walk(w);
  return FALSE;
}

static const PL_extension predicates[] = {
    {"census", 1, census, 0},
    {"census_defect", 4, census_defect, PL_FA_NONDETERMINISTIC},
    {NULL, 0, NULL, 0},
};

void
sg_install_census(void)
{
  for (int k = 0; k < SG_DEFECTS; k++) {
    defect_atom[k] = PL_new_atom(sg_defect_name[k]);
  }
  PL_register_extensions_in_module("sg_kernel_world", predicates);
}
