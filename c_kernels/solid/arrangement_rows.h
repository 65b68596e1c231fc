/* arrangement_rows.h -- arrangements of segments: what a handle of
 * arrangement_open/5 owns, and lists of them.
 *
 * Layer: rows. An arrangement looks into its cut set, and keeps it from being
 * closed, until it is sealed.
 */
#ifndef SG_ARRANGEMENT_ROWS_H
#define SG_ARRANGEMENT_ROWS_H

#include "penetration/cut_rows.h"

#include "arrangement.h"

typedef struct sg_arrangement_handle {
  sg_arrangement *arrangement; /* null: closed */
  uint64_t number;             /* its own, of all there ever were */
  atomic_uint holders;         /* arrangement_hold/1 less arrangement_drop/1 */
  sg_cut_handle *set;          /* kept until it is sealed, then null */
  bool sealing;                /* that was begun: no more is filled in */
  const sg_version *version;   /* then: held, shows the rows of the leaves */
  sg_world *world;             /* then: kept */
  sg_leaf_views views;         /* of that */
  int32_t *s;                  /* [n]: the leaves */
  bool *wanted;                /* [n] */
  bool *surface;               /* [n] */
  sg_kept_tree **tree;      /* [n], held; once sealed those wanted, or null */
  const sg_leaf_tree **own; /* [n]: the same, as the kernel wants them */
  const sg_nonmanifold **nonmanifold; /* [n]: theirs */
  sg_weight *weight;                  /* [weights] */
  size_t n;
  uint32_t *origin_at; /* [points of the set]: the place in origin[] of what
                          made it; SG_NO_KEY: of no vertex of pieces */
  uint32_t *origin;    /* coded terms (term.h), one after another */
} sg_arrangement_handle;

/* Null: nothing. */
void sg_arrangement_handle_free(sg_arrangement_handle *h);

/* The leaves of a list [S-Arrangement, ...]. Components are counted through. */
typedef struct sg_pieces {
  sg_chosen *of;                /* [n]; sense: null, or a part of sense[] */
  sg_arrangement_handle **from; /* [n] */
  size_t n, components;
} sg_pieces;

struct sg_arrangement_piece_list;

/* Of such a list, the first argument; good as long as the call. */
bool sg_pieces_take(sg_call *call, const struct sg_arrangement_piece_list *list,
                    sg_pieces *out);

/* What made the vertices of the pieces, as in origin/3: h->origin_at and
 * h->origin, of an arrangement that was just sealed. */
bool sg_arrangement_make_origins(sg_call *call, sg_arrangement_handle *h);
/* The solid's own copies of those of its made vertices; made_by as of
 * sg_arrangement_select(). */
bool sg_arrangement_give_origins(sg_call *call, const sg_pieces *p,
                                 sg_solid *solid, const sg_made_by *made_by);

#endif
