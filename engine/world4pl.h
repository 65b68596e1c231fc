/* world4pl.h -- the current world, for every *4pl.c file.
 *
 * Layer: glue. All *_ex() functions: null or false means that a Prolog
 * exception is pending. Include it before SWI-Prolog.h.
 */
#ifndef SG_WORLD4PL_H
#define SG_WORLD4PL_H

#include "store.h"
#include "term.h"

#include "cancel.h"

#include <gmp.h>

#include <SWI-Prolog.h>

/* The current world of this thread (borrowed), whole: every row that a row
 * refers to is there. This is how a door comes to a world, so none reads one
 * that an open transaction has left broken: model_error(not_whole(Row,
 * Missing)), whole4pl.c. existence_error: there is none. */
sg_world *sg_current_world_ex(void);
/* The same; null without an exception if there is none. */
sg_world *sg_current_world(void);

/* Waits for the turn to write, asking for signals; release it afterwards. */
int sg_claim_ex(sg_world *world);

/* Raises what `status` means; returns FALSE, or TRUE for SG_OK. `culprit` is
 * the fact or value at fault, or 0. */
int sg_raise_status(sg_status status, sg_relation relation,
                    const sg_fault *fault);

/* sg_world_fresh(); 0: an exception is pending. */
int32_t sg_fresh_ex(sg_world *world, sg_relation relation, int32_t s);

/* The cancel that asks Prolog for signals; after a stop return FALSE from the
 * foreign predicate, the exception is pending. */
extern const sg_cancel sg_prolog_cancel;

/* The relation of this name and arity, SG_NONE: there is none. */
sg_relation sg_relation_named(atom_t name, size_t arity);
/* The same for a term that names one: v, or v/5. */
int sg_get_relation_ex(term_t t, sg_relation *out);

/* Symbols and atoms. The atom is the symbol's for ever. -1: no such symbol. */
atom_t sg_symbol_atom(int32_t symbol);
int32_t sg_atom_symbol(atom_t atom);
/* The same; it is made when there is none. -1: no memory. */
int32_t sg_intern_atom(atom_t atom);

/* A ground term into a builder that is open. False without an exception:
 * not ground, or holds something that has no text (a stream, a dict). */
bool sg_encode_term(term_t t, sg_term_builder *out);
int sg_get_term_ex(term_t t, uint32_t **out); /* free() it */
int sg_put_term(term_t t, const uint32_t *term);

/* Unifies t with a value of this type. */
int sg_unify_value(term_t t, sg_type type, sg_value value);

#endif
