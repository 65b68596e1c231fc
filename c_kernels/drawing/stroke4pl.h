/* stroke4pl.h -- looks and strokes as terms.
 *
 * Layer: glue. Shared by stroke4pl.c (parts as terms) and drawn_stroke4pl.c
 * (parts as rows).
 */
#ifndef SG_STROKE4PL_H
#define SG_STROKE4PL_H

#include "glue.h"
#include "stroke.h"

/* A visibility and a role. */
typedef struct sg_look_names {
  atom_t visibility, role;
} sg_look_names;

typedef struct sg_looks {
  sg_look_names *name;  /* [n] */
  sg_stroke_look *look; /* [n] */
  size_t n;
} sg_looks;

/* From [look(Visibility, Role, Rank), ...]. False: an exception. Owner:
 * sg_looks_clear() in any case. */
int sg_get_looks_ex(term_t list, sg_looks *out);
void sg_looks_clear(sg_looks *looks);

/* The place of a look, or looks->n; `last` is tried first. */
size_t sg_looks_find(const sg_looks *looks, sg_look_names name, size_t last);

/* [part(Visibility, Role, S, E, From, To, A, B), ...] behind the n parts there
 * are; *out grows. False: an exception. */
int sg_get_parts_ex(term_t list, const sg_looks *looks, sg_stroke_part **out,
                    size_t *n);

/* The strokes of parts, which are sorted, as a list. */
int sg_unify_strokes_of(term_t list, const sg_looks *looks,
                        sg_stroke_part *part, size_t n);

#endif
