/* cut_rows.h -- a penetration under way, as rows: the cut set behind a handle.
 *
 * Layer: rows. Shared by cut_rows.c (finding cuts), seam_rows.c (putting them
 * into polygons) and split_rows.c (where they cross there).
 */
#ifndef SG_CUT_ROWS_H
#define SG_CUT_ROWS_H

#include "call.h"
#include "cut_enter.h"
#include "cut_set.h"
#include "join/tree_rows.h"
#include "polygon/work.h"

#include "engine/term.h"

/* Rows of a relation by id, made when one is asked for the first time. */
typedef struct sg_cut_rows_by_id {
  sg_id_rows *of; /* [segments], or null */
  bool failed;    /* there was no memory for it */
} sg_cut_rows_by_id;

enum { SG_CUT_TABLES = 3 }; /* of e/5, p/3 and plane/6 */

/* Of a segment, model units: see polygon/flatness.h. */
typedef struct sg_cut_own {
  double touch, rounding, explained;
} sg_cut_own;

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
  uint8_t *apart; /* [curve_candidates] that have nothing in common, nor near */
  bool twins;     /* some have the same corners: else none are quiet */
  bool joined;    /* the candidates are there */
  bool few; /* of many sheets that touch some are enough: cut_few_sheets/1 */
  uint8_t
      *quiet; /* [curve_candidates] cut_coincident.h; null: not asked for yet */
  bool without_quiet;     /* those are left out: cut_without_coincident/1 */
  sg_cut_own *own;        /* [segments]; null: not asked yet */
  bool by_own;            /* each reaches no farther than that */
  double reach;           /* how near they are, at most */
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
  bool grouped; /* its polygons are listed, its points have names */
  struct sg_segment_polygon *queue; /* [queued]: cut_queue/2 */
  size_t queued, entered;           /* the second: of them, so far */
  atomic_uint holders;              /* the handle is one */
} sg_cut_handle;

/* The row (s, id) of e/5, p/3 or plane/6, SG_NO_ROW: there is none
 * (cut_ids_rows.c). */
sg_row sg_cut_row_of(sg_cut_handle *handle, sg_relation relation, int32_t s,
                     int32_t id);
void sg_cut_rows_clear(sg_cut_handle *handle);

/* Whether polygons of segment s may have edges in common, in the version: those
 * that are written share none unless these do. */
bool sg_cut_shares_edges(sg_cut_handle *handle, int32_t s);

/* Notes the polygons of all split edges, or of those that are late: each has a
 * triangle beside the edge, which is in the model, since the point is in it.
 * False: no memory, or stopped. */
bool sg_cut_add_beside(sg_cut_handle *handle, bool late,
                       const sg_cancel *cancel);

/* A set that is kept lasts until it is let go, by whatever thread, also when
 * its handle is closed. Once a keep. */
void sg_cut_set_keep(sg_cut_handle *handle);
void sg_cut_set_let_go(sg_cut_handle *handle);

struct sg_id_pair_list;

/* Opening (cut_open_rows.c): takes the pairs and the trees; clearing also after
 * a failure. The join is made once, when candidates are asked for. */
bool sg_cut_open(sg_call *call, sg_cut_handle *handle,
                 const struct sg_id_pair_list *pairs);
void sg_cut_open_clear(sg_cut_handle *handle);
bool sg_cut_join(sg_call *call, sg_cut_handle *handle);
/* Finds which candidates are quiet, when they are there. */
bool sg_cut_quiet(sg_call *call, sg_cut_handle *handle);
/* Where segment s is among those of the set, SIZE_MAX: it is not. */
size_t sg_cut_place_of(const sg_cut_handle *handle, int32_t s);

/* The name of a point in segment s, made if it has none; 0: refused
 * (seam_rows.c). */
int32_t sg_cut_name(sg_call *call, sg_cut_handle *handle, uint32_t point,
                    int32_t s);

/* The handle in `work`, of segment s, of a point of the set, which gets a name
 * there if it has none (cut_enter_rows.c). SG_WORK_NONE: refused. */
int32_t sg_cut_enter_point(sg_call *call, sg_cut_handle *handle, sg_work *work,
                           uint32_t point, int32_t s);

/* The outline of polygon p, behind those in *out (cut_enter_rows.c);
 * existence_error(polygon, p). */
bool sg_cut_outline(sg_call *call, sg_cut_handle *handle, int32_t s, int32_t p,
                    sg_outlines *out);

/* The name that a point has in polygon p of segment s: of several the one that
 * is a vertex of it, else the smallest. 0: none (seam_rows.c). */
int32_t sg_cut_name_in(sg_cut_handle *handle, uint32_t point, int32_t s,
                       int32_t p);

/* What made a point that has a place or more, as in origin/3
 * (cut_origin_rows.c). */
void sg_cut_build_origin(sg_term_builder *b, const sg_cut_points *points,
                         uint32_t point);
/* The same as a term that lasts as long as the call. Null: refused. */
const uint32_t *sg_cut_origin(sg_call *call, const sg_cut_points *points,
                              uint32_t point);

/* The first line between vertices v1 and v2 of segment s, after cut_lines/2;
 * SG_NO_KEY: none. */
uint32_t sg_cut_line_of(const sg_cut_handle *handle, int32_t s, int32_t v1,
                        int32_t v2);

/* Whether edge 0..2 of a leaf triangle of the set of this handle is an edge of
 * its polygon, of real type: 1, 0, or -1: no memory (cut_real_rows.c). */
int sg_cut_is_real(void *handle, uint32_t triangle, int edge);

/* The same, or a fold: an sg_is_real for this set (cut_fold_rows.c). */
int sg_cut_is_real_or_fold(void *handle, uint32_t triangle, int edge);

/* Adds the folds of a polygon that is not flat to the last outline, which is
 * its own. */
bool sg_cut_add_folds(sg_call *call, sg_cut_handle *handle, int32_t s,
                      int32_t p, sg_outlines *out);

#endif
