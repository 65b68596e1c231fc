/* cut4pl.h -- the cut set behind a Prolog handle.
 *
 * Layer: glue. Shared by cut4pl.c (finding cuts), seam4pl.c (putting them into
 * polygons) and split4pl.c (where they cross there).
 */
#ifndef SG_CUT4PL_H
#define SG_CUT4PL_H

#include "engine/world4pl.h"

#include "cut_enter.h"
#include "cut_set.h"
#include "join/tree4pl.h"
#include "polygon/work.h"

/* Rows of a relation by id, made when one is asked for the first time. */
typedef struct sg_cut_rows_by_id {
  sg_id_rows *of; /* [segments], or null */
  bool failed;    /* there was no memory for it */
} sg_cut_rows_by_id;

enum { SG_CUT_TABLES = 3 }; /* of e/5, p/3 and plane/6 */

/* One penetration under way. The model, and all real edges, are those of the
 * version at which it was opened. */
typedef struct sg_cut_handle {
  sg_cut_set set;
  sg_world *world;           /* kept */
  const sg_version *version; /* held */
  int32_t (*pair)[2];        /* segments to be cut by each other */
  size_t pairs;
  int32_t *segment;    /* those of the pairs, ascending */
  sg_kept_tree **tree; /* [segments], held */
  size_t segments;
  uint8_t *sharing;                    /* [segments]: sg_cut_shares_edges() */
  sg_leaf_views views;                 /* of the version */
  uint32_t (*candidate)[2];            /* triangles, and then curve edges */
  size_t candidates, curve_candidates; /* the second: where those begin */
  bool joined;                         /* the candidates are there */
  uint8_t *quiet; /* [curve_candidates] cut_twin.h; null: not asked for yet */
  bool without_quiet; /* those are left out: cut_without_twins/1 */
  double *own;  /* [segments] what its source explains; null: not asked yet */
  bool by_own;  /* each reaches no farther than that */
  double reach; /* how near they are, at most */
  sg_key_table next_name; /* segment -> next id of v/5 */
  sg_key_table line_of;   /* segment, two points -> line */
  uint8_t *real; /* [real_room]: the real edges of triangles that were asked */
  size_t real_room;
  sg_key_table edge_type;  /* segment, polygon, two vertices -> Et */
  sg_key_table edges_read; /* segment, polygon: edges are in edge_type */
  sg_key_table bent;       /* segment, polygon -> 1: it is not flat */
  double flat_within;      /* in what polygons have no folds */
  bool flat_known;         /* of all vertices, too */
  sg_cut_rows_by_id by_id[SG_CUT_TABLES];
  bool grouped;     /* its polygons are listed, its points have names */
  atomic_bool shut; /* for Prolog: cut_set_close/1 was called */
  atomic_uint
      openers; /* glue that looks into it, and Prolog until it is shut */
  atomic_uint holders; /* the same glue, and Prolog's atom */
} sg_cut_handle;

/* The open cut set that t names: type_error, existence_error. */
int sg_get_cut_set_ex(term_t t, sg_cut_handle **out);

/* The row (s, id) of e/5, p/3 or plane/6, SG_NO_ROW: there is none
 * (cut_ids4pl.c). */
sg_row sg_cut_row_of(sg_cut_handle *handle, sg_relation relation, int32_t s,
                     int32_t id);
void sg_cut_rows_clear(sg_cut_handle *handle);

/* Whether polygons of segment s may have edges in common, in the version: those
 * that are written share none unless these do. */
bool sg_cut_shares_edges(sg_cut_handle *handle, int32_t s);

/* Notes the polygons of all split edges, or of those that are late: each has a
 * triangle beside the edge, which is in the model, since the point is in it.
 * False: no memory. */
bool sg_cut_add_beside(sg_cut_handle *handle, bool late);

/* A set that is kept is neither closed nor freed before it is let go, by
 * whatever thread. Once a keep. */
void sg_cut_set_keep(sg_cut_handle *handle);
void sg_cut_set_let_go(sg_cut_handle *handle);

/* Opening (cut_open4pl.c): reads the pairs and takes the trees; clearing also
 * after a failure. The join is made once, when candidates are asked for. */
int sg_cut_open_ex(sg_cut_handle *handle, term_t pairs);
void sg_cut_open_clear(sg_cut_handle *handle);
int sg_cut_join_ex(sg_cut_handle *handle);
/* Finds which candidates are quiet, when they are there. False: an exception.
 */
int sg_cut_quiet_ex(sg_cut_handle *handle);
/* Where segment s is among those of the set; it is one of them. */
size_t sg_cut_place_of(const sg_cut_handle *handle, int32_t s);

/* The name of a point in segment s, made if it has none; 0: an exception
 * (seam4pl.c). */
int32_t sg_cut_name_ex(sg_cut_handle *handle, uint32_t point, int32_t s);

/* The handle in `work`, of segment s, of a point of the set, which gets a name
 * there if it has none (cut_enter4pl.c). SG_WORK_NONE: an exception. */
int32_t sg_cut_enter_point_ex(sg_cut_handle *handle, sg_work *work,
                              uint32_t point, int32_t s);

/* The outline of polygon p, behind those in *out (cut_enter4pl.c);
 * existence_error(polygon, P). */
int sg_cut_outline_ex(sg_cut_handle *handle, int32_t s, int32_t p,
                      term_t p_term, sg_outlines *out);

/* The name that a point has in polygon p of segment s: of several the one that
 * is a vertex of it, else the smallest. 0: none (seam4pl.c). */
int32_t sg_cut_name_in(sg_cut_handle *handle, uint32_t point, int32_t s,
                       int32_t p);

/* What made a point that has a place or more, as in origin/3
 * (cut_origin4pl.c). */
void sg_cut_build_origin(sg_term_builder *b, const sg_cut_points *points,
                         uint32_t point);
int sg_unify_origin(term_t t, const sg_cut_points *points, uint32_t point);

/* The first line between vertices v1 and v2 of segment s, after cut_lines/2;
 * SG_NO_KEY: none. */
uint32_t sg_cut_line_of(const sg_cut_handle *handle, int32_t s, int32_t v1,
                        int32_t v2);

/* Whether edge 0..2 of a leaf triangle of the set of this handle is an edge of
 * its polygon, of real type: 1, 0, or -1: no memory (cut_real4pl.c). */
int sg_cut_is_real(void *handle, uint32_t triangle, int edge);

/* The same, or a fold: an sg_is_real for this set (cut_fold4pl.c). */
int sg_cut_is_real_or_fold(void *handle, uint32_t triangle, int edge);

/* Whether polygon p of segment s is not flat: 1, 0, or -1: no memory. */
int sg_cut_is_bent(sg_cut_handle *handle, int32_t s, int32_t p);

/* Adds the folds of a polygon that is not flat to the last outline, which is
 * its own. False: an exception. */
int sg_cut_add_folds_ex(sg_cut_handle *handle, int32_t s, int32_t p,
                        sg_outlines *out);

#endif
