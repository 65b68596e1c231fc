/* outline4pl.c -- loops_are_sound/1 (documented in rules/kernel/work.pl).
 *
 * Layer: glue: converts, checks, raises; computes nothing.
 */
#include "glue.h"
#include "outline.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <stdlib.h>

typedef struct reading {
  double (*at)[2];
  size_t *begin;
  size_t points, point_room, loops, loop_room;
  functor_t pair;
} reading;

static int
make_room(void **array, size_t n, size_t *room, size_t size)
{
  if (n < *room) {
    return TRUE;
  }
  size_t more = 2 * *room + 64;
  void *grown = realloc(*array, more * size);

  if (!grown) {
    return sg_no_memory();
  }
  *array = grown;
  *room = more;
  return TRUE;
}

static int
get_point_ex(reading *r, term_t t, term_t arg)
{
  void *at = r->at;

  if (!PL_is_functor(t, r->pair)) {
    return PL_type_error("pair", t);
  }
  if (!make_room(&at, r->points, &r->point_room, sizeof *r->at)) {
    return FALSE;
  }
  r->at = at;
  double *out = r->at[r->points++];

  return PL_get_arg(1, t, arg) && sg_get_finite_ex(arg, &out[0]) &&
         PL_get_arg(2, t, arg) && sg_get_finite_ex(arg, &out[1]);
}

static int
get_loop_ex(reading *r, term_t loop)
{
  term_t tail = PL_copy_term_ref(loop), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();
  size_t first = r->points;
  void *begin = r->begin;

  if (!make_room(&begin, r->loops + 1, &r->loop_room, sizeof *r->begin)) {
    return FALSE;
  }
  r->begin = begin;
  while (PL_get_list_ex(tail, head, tail)) {
    if (!get_point_ex(r, head, arg)) {
      return FALSE;
    }
  }
  r->begin[r->loops++] = first;
  r->begin[r->loops] = r->points;
  return PL_get_nil_ex(tail) &&
         (r->points >= first + 3 || PL_domain_error("loop", loop));
}

static int
get_loops_ex(reading *r, term_t list)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  while (PL_get_list_ex(tail, head, tail)) {
    fid_t frame = PL_open_foreign_frame();
    int good = frame && get_loop_ex(r, head);

    if (frame) {
      PL_close_foreign_frame(frame);
    }
    if (!good) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(tail) &&
         (r->loops > 0 || PL_domain_error("loops", list));
}

/* loops_are_sound(+Loops) is semidet. */
static foreign_t
loops_are_sound(term_t list)
{
  reading r = {.pair = PL_new_functor(PL_new_atom("-"), 2)};
  bool sound = false;
  int good = get_loops_ex(&r, list);

  if (good && !sg_flat_loops_are_sound(
                  &(sg_flat_loops){r.loops, (const double(*)[2])r.at, r.begin},
                  &sg_prolog_poll, &sound)) {
    good = PL_exception(0) ? FALSE : sg_no_memory();
  }
  free(r.at);
  free(r.begin);
  return good && sound;
}

static const PL_extension predicates[] = {
    {"loops_are_sound", 1, loops_are_sound, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_outline(void)
{
  PL_register_extensions_in_module("sg_kernel_work", predicates);
}
