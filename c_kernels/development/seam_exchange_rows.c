/* seam_exchange_rows.c -- folds exchanged for a shorter seam, and how short it
 * can be.
 */
#include "development_rows.h"

#include "doors/pattern.h"
#include "seam_bound.h"
#include "seam_exchange.h"

#include <stdlib.h>
#include <string.h>

/* The places of joints, which are numbered from 1; null: refused. */
static uint32_t *
places_of(sg_call *call, const sg_development *d, const sg_int_list *joints,
          int argument)
{
  uint32_t *place = sg_call_alloc(call, joints->n * sizeof *place);

  for (size_t i = 0; place && i < joints->n; i++) {
    if ((size_t)joints->at[i] > d->joints.n) {
      sg_call_missing(call, "joint", argument);
      return NULL;
    }
    place[i] = (uint32_t)joints->at[i] - 1;
  }
  return place;
}

/* Which joints are in a list; null: refused. */
static bool *
find_kept(sg_call *call, const sg_development *d, const sg_int_list *joints)
{
  uint32_t *place = places_of(call, d, joints, 3);
  bool *kept = place ? sg_call_alloc(call, d->joints.n + 1) : NULL;

  if (kept) {
    memset(kept, 0, d->joints.n + 1);
  }
  for (size_t i = 0; kept && i < joints->n; i++) {
    kept[place[i]] = true;
  }
  return kept;
}

bool
sg_door_exchange_seams(sg_call *call, sg_development *d, size_t order,
                       const sg_int_list *kept, int objective, size_t effort,
                       size_t *exchanges)
{
  sg_exchange_input in = {.flattening = &d->flattening,
                          .kept = find_kept(call, d, kept),
                          .pieces = objective == SG_EXCHANGE_OBJECTIVE_PIECES,
                          .effort = effort};
  sg_exchange_end end;
  bool stopped;

  if (!in.kept) {
    return false;
  }
  uint32_t *joint =
      sg_joint_order(&d->flattening, (unsigned)order, &call->cancel, &stopped);

  in.order = joint;
  bool good = joint && sg_seam_exchange(&in, &call->cancel, &end, &stopped);

  free(joint);
  *exchanges = good ? end.exchanges : 0;
  return good || sg_call_ended(call);
}

bool
sg_door_join_folds(sg_call *call, sg_development *d, const sg_int_list *joints)
{
  uint32_t *place = places_of(call, d, joints, 2);
  bool stopped;

  if (!place) {
    return false;
  }
  d->laid = false;
  return sg_flattening_join_folds(&d->flattening, place, joints->n,
                                  &call->cancel, &stopped) ||
         sg_call_ended(call);
}

bool
sg_door_seam_length(sg_call *call, sg_development *d, double *length)
{
  (void)call;
  *length = sg_seam_length(&d->flattening);
  return true;
}

bool
sg_door_flattening_bound(sg_call *call, sg_development *d, sg_seam_bound *out)
{
  bool stopped;

  return sg_seam_bound_find(&d->flattening, &call->cancel, out, &stopped) ||
         sg_call_ended(call);
}

static bool
find_face(sg_call *call, const sg_development *d, int32_t p, int argument,
          uint32_t *out)
{
  for (*out = 0; *out < d->faces.faces; ++*out) {
    if (sg_development_polygon(d, *out) == p) {
      return true;
    }
  }
  return sg_call_missing(call, "polygon", argument);
}

bool
sg_door_fold_path(sg_call *call, sg_development *d, int32_t p, int32_t q,
                  sg_int_list *joints)
{
  uint32_t from, to;

  return find_face(call, d, p, 2, &from) && find_face(call, d, q, 3, &to) &&
         sg_development_path(call, d, from, to, joints);
}
