/* contact_feature_rows.h -- the origin of a point that a cut made, with names
 * that leaves have.
 *
 * Layer: rows. See contact_places.h.
 */
#ifndef SG_CONTACT_FEATURE_ROWS_H
#define SG_CONTACT_FEATURE_ROWS_H

#include "call.h"

struct sg_leaf_contacts_list;

/* *renamed: what stands for `origin`, which names a vertex that leaves had in
 * pieces alone, or that was moved; as sg_call_term(). Null: it names none. The
 * leaves have their rows in `version`. False: refused. */
bool sg_contact_renamed(sg_call *call, const sg_version *version,
                        const struct sg_leaf_contacts_list *leaves,
                        const uint32_t *origin, const uint32_t **renamed);

#endif
