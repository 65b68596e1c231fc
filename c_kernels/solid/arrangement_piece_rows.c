/* arrangement_piece_rows.c -- sealed arrangements: their components, and solids
 * of those that are chosen.
 */
#include "arrangement_rows.h"
#include "doors/boolean.h"
#include "engine/search.h"

#include <stdlib.h>
#include <string.h>

/* ---- pieces: [S-Arrangement, ...] ---- */

/* Segments ascend. */
static bool
has_pieces(const sg_arrangement_handle *h, int32_t s)
{
  size_t at = sg_find_id(h->s, h->n, s);

  return at != SIZE_MAX && h->wanted[at];
}

static bool
is_sealed(sg_call *call, const sg_arrangement_handle *h)
{
  return h->arrangement
             ? h->version || sg_call_forbidden(call, "select", "arrangement", 1)
             : sg_call_missing(call, "arrangement", 1);
}

bool
sg_pieces_take(sg_call *call, const sg_arrangement_piece_list *list,
               sg_pieces *out)
{
  *out = (sg_pieces){
      .of = sg_call_alloc(call, list->n * sizeof *out->of),
      .from = sg_call_alloc(call, list->n * sizeof(sg_arrangement_handle *))};
  if (!out->of || !out->from) {
    return false;
  }
  for (; out->n < list->n; out->n++) {
    const sg_arrangement_piece *one = &list->at[out->n];

    if (!is_sealed(call, one->arrangement)) {
      return sg_call_at(call, out->n + 1, 2);
    }
    if (!has_pieces(one->arrangement, one->s)) {
      sg_call_missing(call, "pieces", 1);
      return sg_call_at(call, out->n + 1, 0);
    }
    out->of[out->n] =
        (sg_chosen){.a = one->arrangement->arrangement, .s = one->s};
    out->from[out->n] = one->arrangement;
    out->components +=
        sg_arrangement_components(out->of[out->n].a, out->of[out->n].s);
  }
  return true;
}

/* ---- components ---- */

/* Its sides are the arrangement's, which outlives the call. */
static bool
add_component(sg_call *call, const sg_component *c, sg_component_fact_list *out)
{
  return sg_component_fact_list_add(
      call, out,
      (sg_component_fact){.number = out->n,
                          .s = c->s,
                          .p = c->p,
                          .at = {{c->at->p[0], c->at->p[1], c->at->p[2]}},
                          .sides = {(sg_side *)c->side, c->sides, 0},
                          .which = c->unknown  ? SG_COMPONENT_WHICH_UNKNOWN
                                   : c->second ? SG_COMPONENT_WHICH_SECOND
                                               : SG_COMPONENT_WHICH_ONLY});
}

bool
sg_door_arrangement_components(sg_call *call,
                               const sg_arrangement_piece_list *pieces,
                               sg_component_fact_list *components)
{
  sg_pieces p;
  bool good = sg_pieces_take(call, pieces, &p);

  for (size_t i = 0; good && i < p.n; i++) {
    size_t n = sg_arrangement_components(p.of[i].a, p.of[i].s);

    for (size_t k = 0; good && k < n; k++) {
      sg_component c = sg_arrangement_component(p.of[i].a, p.of[i].s, k);

      good = !sg_cancel_every(&call->cancel, components->n) &&
             add_component(call, &c, components);
    }
  }
  return good;
}

bool
sg_door_arrangement_numbers(sg_call *call,
                            const sg_arrangement_piece_list *pieces,
                            sg_integer_list *numbers)
{
  sg_pieces p;
  bool good = sg_pieces_take(call, pieces, &p);

  for (size_t i = 0; good && i < p.n; i++) {
    good = sg_integer_list_add(call, numbers, (int64_t)p.from[i]->number);
  }
  return good;
}

/* ---- choosing ---- */

static bool
take_senses(sg_call *call, const sg_component_sense_list *senses, sg_pieces *p)
{
  int8_t *sense = sg_call_alloc(call, p->components + 1);

  if (!sense) {
    return false;
  }
  memset(sense, 0, p->components);
  for (size_t i = 0; i < senses->n; i++) {
    int64_t c = senses->at[i].component;

    if (c < 0 || (uint64_t)c >= p->components) {
      sg_call_missing(call, "component", 2);
      return sg_call_at(call, i + 1, 1);
    }
    sense[c] = senses->at[i].reversed ? -1 : 1;
  }
  for (size_t i = 0; i < p->n; i++) {
    p->of[i].sense = sense;
    sense += sg_arrangement_components(p->of[i].a, p->of[i].s);
  }
  return true;
}

static bool
choose(sg_call *call, const sg_pieces *p, sg_pool *pool, sg_solid *out)
{
  sg_made_by *made_by = NULL;
  bool good =
      (sg_arrangement_select(p->of, p->n, pool, &call->cancel, out, &made_by) ||
       sg_call_ended(call)) &&
      sg_arrangement_give_origins(call, p, out, made_by);

  free(made_by);
  return good;
}

bool
sg_door_arrangement_select(sg_call *call,
                           const sg_arrangement_piece_list *pieces,
                           const sg_component_sense_list *senses,
                           sg_solid **solid)
{
  sg_pool *pool = sg_call_pool(call);
  sg_pieces p;

  if (!pool || !sg_pieces_take(call, pieces, &p) ||
      !take_senses(call, senses, &p)) {
    return false;
  }
  if (!(*solid = calloc(1, sizeof **solid))) {
    return sg_call_no_memory(call);
  }
  if (!choose(call, &p, pool, *solid)) {
    sg_solid_free(*solid);
    return false;
  }
  return true;
}
