/* self4pl.c -- where segments go through themselves (documented in
 * kernel/boolean.pl).
 *
 * Layer: glue.
 */
#include "glue.h"
#include "rows/dense4pl.h"
#include "self_cut.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <stdlib.h>

static atom_t kind_atom[SG_SELF_KINDS];

static int
unify_meeting(term_t t, const sg_self_meeting *m)
{
  return PL_unify_term(t, PL_FUNCTOR_CHARS, "meeting", 6, PL_ATOM,
                       kind_atom[m->kind], PL_INT, (int)m->p[0], PL_INT,
                       (int)m->p[1], PL_FLOAT, m->at[0] + 0.0, PL_FLOAT,
                       m->at[1] + 0.0, PL_FLOAT, m->at[2] + 0.0);
}

/* [Name-Count, ...] of the kinds that there are. */
static int
unify_counts(term_t t, const size_t count[SG_SELF_KINDS])
{
  term_t tail = PL_copy_term_ref(t), head = PL_new_term_ref();

  for (int k = 0; k < SG_SELF_KINDS; k++) {
    if (count[k] > 0 &&
        (!PL_unify_list(tail, head, tail) ||
         !PL_unify_term(head, PL_FUNCTOR_CHARS, "-", 2, PL_ATOM, kind_atom[k],
                        PL_INT64, (int64_t)count[k]))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* self(S, Counts, Meetings): of each kind the first `most`. */
static int
unify_segment(term_t t, int32_t s, const sg_self_meetings *found, int64_t most)
{
  size_t count[SG_SELF_KINDS] = {0};
  term_t counts = PL_new_term_ref(), list = PL_new_term_ref();
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < found->n; i++) {
    if ((int64_t)count[found->item[i].kind]++ < most &&
        (!PL_unify_list(tail, head, tail) ||
         !unify_meeting(head, &found->item[i]))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail) && unify_counts(counts, count) &&
         PL_unify_term(t, PL_FUNCTOR_CHARS, "self", 3, PL_INT, (int)s, PL_TERM,
                       counts, PL_TERM, list);
}

static int
unify_segments(term_t segments, const sg_dense *dense, sg_crew *crew,
               int64_t most)
{
  term_t tail = PL_copy_term_ref(segments), head = PL_new_term_ref();

  for (size_t s = 0; s < dense->segments; s++) {
    sg_self_meetings found;

    if (!sg_self_cut(dense, s, sg_self_tolerance(dense, s), crew,
                     &sg_prolog_poll, &found)) {
      return PL_exception(0) ? FALSE : sg_no_memory();
    }
    sg_self_by_polygon(&found);
    int done = PL_unify_list(tail, head, tail) &&
               unify_segment(head, dense->segment[s], &found, most);

    free(found.item);
    if (!done) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* self_meetings(+Most, -Segments) is det. */
static foreign_t
self_meetings(term_t most, term_t segments)
{
  int64_t limit;
  sg_dense dense;
  sg_crew *crew;

  if (!PL_get_int64_ex(most, &limit)) {
    return FALSE;
  }
  if (!(crew = sg_crew_open(0))) {
    return sg_no_memory();
  }
  int done = sg_get_dense_ex(NULL, 0, &dense) &&
             unify_segments(segments, &dense, crew, limit);

  sg_dense_clear(&dense);
  sg_crew_close(crew);
  return done;
}

static const PL_extension predicates[] = {
    {"self_meetings", 2, self_meetings, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_self(void)
{
  for (int k = 0; k < SG_SELF_KINDS; k++) {
    kind_atom[k] = PL_new_atom(sg_self_name[k]);
  }
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
