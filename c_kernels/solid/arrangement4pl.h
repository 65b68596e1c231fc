/* arrangement4pl.h -- arrangements behind a Prolog handle, and lists of them.
 *
 * Layer: glue. Include it before SWI-Prolog.h.
 */
#ifndef SG_ARRANGEMENT4PL_H
#define SG_ARRANGEMENT4PL_H

#include "penetration/cut4pl.h"

#include "arrangement.h"

typedef struct sg_arrangement_handle {
  sg_arrangement *arrangement; /* null: closed */
  uint64_t number;             /* its own, of all there ever were */
  atomic_uint holders;         /* arrangement_hold/1 less arrangement_drop/1 */
  sg_cut_handle *set;          /* kept until it is sealed, then null */
  bool sealing;                /* that was begun: no more is filled in */
  sg_world *world;             /* then: kept */
  const sg_version *version;   /* then: held, shows the rows of the leaves */
  sg_leaf_views views;         /* of that */
  int32_t *s;                  /* [n]: the leaves */
  bool *wanted;                /* [n] */
  bool *surface;               /* [n] */
  sg_kept_tree **tree;      /* [n], held; once sealed those wanted, or null */
  const sg_leaf_tree **own; /* [n]: the same, as the kernel wants them */
  const sg_knots **knots;   /* [n]: theirs */
  sg_weight *weight;        /* [weights], until it is sealed */
  size_t weights;
  size_t n;
  uint32_t *origin_at; /* [points of the set]: the place in origin[] of what
                          made it; SG_NO_KEY: of no vertex of pieces */
  uint32_t *origin;    /* coded terms (term.h), one after another */
} sg_arrangement_handle;

/* The open arrangement that t names: type_error, existence_error. */
int sg_get_arrangement_ex(term_t t, sg_arrangement_handle **out);
/* The same, once it is sealed; permission_error(select, arrangement, t). */
int sg_get_sealed_ex(term_t t, sg_arrangement_handle **out);
/* The same, while it may be filled; permission_error(fill, arrangement, t). */
int sg_get_unsealed_ex(term_t t, sg_arrangement_handle **out);

/* The leaves of a list [S-Arrangement, ...]. Components are counted through. */
typedef struct sg_pieces {
  sg_chosen *of;                /* [n]; sense: null, or a part of sense[] */
  sg_arrangement_handle **from; /* [n] */
  size_t n, components;
  int8_t *sense; /* [components], or null */
} sg_pieces;

/* Reads such a list; clear it also after a failure. */
int sg_get_pieces_ex(term_t list, sg_pieces *out);
void sg_pieces_clear(sg_pieces *p);

/* What made the vertices of the pieces, as in origin/3: h->origin_at and
 * h->origin, of an arrangement that was just sealed. */
int sg_make_origins_ex(sg_arrangement_handle *h);
/* After that: lets go of the cut set, of the trees of leaves that are not
 * wanted, and of all rows but those of the others. Pieces are kept for long. */
int sg_shed_arrangement_ex(sg_arrangement_handle *h);
/* The solid's own copies of those of its made vertices; made_by as of
 * sg_arrangement_select(). */
int sg_give_origins_ex(const sg_pieces *p, sg_solid *solid,
                       const sg_made_by *made_by);

#endif
