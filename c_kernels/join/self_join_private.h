/* self_join_private.h -- what the files of self_join.h share.
 *
 * Layer: kernel.
 */
#ifndef SG_SELF_JOIN_PRIVATE_H
#define SG_SELF_JOIN_PRIVATE_H

#include "self_join.h"

#include "oriented_box.h"
#include "rows/key_table.h"

/* A flat polygon of many triangles. */
typedef struct sg_self_face {
  int32_t p;
  uint32_t first, n; /* in in_face[] of the joiner */
  double at[3][3];   /* of a triangle with an area */
  int axis, turn;    /* how that is seen */
  sg_box box;
} sg_self_face;

enum { SG_SELF_HUBS = 8 };

typedef struct sg_self_joiner {
  const sg_self_joining *of;
  sg_run run;
  sg_bvh *tree;            /* of all, if that of the caller will not do */
  const uint32_t *filling; /* the list whose boxes are asked for; null: all */
  sg_self_face *face;      /* [faces] */
  size_t faces;
  uint32_t *face_of; /* [n]; SG_NO_KEY: of none; null: there are no faces */
  uint32_t *in_face; /* triangles, face by face */
  uint32_t *single;  /* the others */
  size_t singles;
  sg_key_table corner; /* face, vertex */
  sg_key_table border; /* face, two vertices -> how many triangles */
  unsigned char *star; /* [n] bits: settled at these hubs; null: no hub */
  double hub[SG_SELF_HUBS][3];
  const sg_bvh_pair *pair; /* of the join under way */
  sg_bvh_pair only;        /* where it has one */
  sg_bvh_hits hits;
} sg_self_joiner;

/* The triangle at a place of a tree. */
uint32_t sg_self_triangle_at(const sg_self_joiner *j, const sg_bvh *tree,
                             uint32_t place);

/* The box of triangle i, along the run. */
sg_box sg_self_box_of(const sg_self_joiner *j, uint32_t i);

/* Parts triangles into faces and single ones (self_face.c). What is within
 * reach of a face must be asked for one by one: then there are none. False: no
 * memory, or stopped. */
bool sg_self_find_faces(sg_self_joiner *j, const sg_cancel *cancel);
void sg_self_clear_faces(sg_self_joiner *j);

/* Whether a triangle has nothing in common with face f but a corner, or an edge
 * that is an edge of the face. Exact. */
bool sg_self_misses(const sg_self_joiner *j, uint32_t f,
                    const sg_fan_triangle *t);

/* Sets star, if it is worth it: triangles with a bit in common are not asked
 * about (self_star.c). False: no memory, or stopped. */
bool sg_self_find_stars(sg_self_joiner *j, const sg_cancel *cancel);

/* The bits that all triangles below a node have, and where their other corners
 * are if they have two; if there are hubs. */
typedef struct sg_self_stars {
  const sg_bvh *tree;
  unsigned char *level[SG_BVH_LEVELS]; /* from 1 on */
  sg_box *rest[SG_BVH_LEVELS];         /* the same */
} sg_self_stars;

/* False: no memory, or stopped. Owner: sg_self_stars_close() in any case. */
bool sg_self_stars_open(const sg_self_joiner *j, const sg_bvh *tree,
                        const sg_cancel *cancel, sg_self_stars *out);
void sg_self_stars_close(sg_self_stars *stars);

/* Whether nothing below box a of a level (1 or more) has more in common with
 * what is below box b than is theirs by name. */
bool sg_self_stars_apart(const sg_self_joiner *j, const sg_self_stars *stars,
                         unsigned level, size_t a, size_t b);

#endif
