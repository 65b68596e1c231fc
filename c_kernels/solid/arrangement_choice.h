/* arrangement_choice.h -- a solid under way, from what is chosen of leaves.
 *
 * Layer: kernel. Between arrangement_select.c and arrangement_uncut.c.
 */
#ifndef SG_ARRANGEMENT_CHOICE_H
#define SG_ARRANGEMENT_CHOICE_H

#include "arrangement_private.h"

enum { SG_CHOICE_ASKED = 1 << 14 }; /* rows between questions */

/* A chosen leaf triangle. */
typedef struct sg_chosen_row {
  int32_t p;
  uint32_t row; /* place among the leaf's rows */
} sg_chosen_row;

/* A vertex, by its node and its name. */
typedef struct sg_chosen_corner {
  uint32_t node;
  int32_t v;
} sg_chosen_corner;

/* A leaf that something is chosen of. Its polygons that are not cut are done
 * as a task of its own. */
typedef struct sg_source {
  const sg_arrangement *a;
  const sg_arranged *leaf;
  uint32_t place;
  const int8_t *sense;        /* of its components */
  uint32_t *number;           /* [places]: of its vertices, in the solid */
  uint32_t *made;             /* [leaf->mades]: of those that cuts made */
  sg_chosen_row *list;        /* [n]: polygon by polygon */
  sg_chosen_corner *fresh;    /* [fresh_n]: untouched vertices of these */
  sg_chosen_corner *touching; /* [touching_n]: the others */
  size_t n, faces, fresh_n, touching_n, touching_room;
  size_t first_vertex, first_triangle, first_face; /* in the solid */
  bool collapsed, failed;
} sg_source;

/* A solid under way. */
typedef struct sg_choice {
  sg_source *from; /* [n] */
  size_t n;
  sg_solid *out;
  sg_key_table at;     /* three doubles -> vertex of the solid */
  sg_made_by *made_by; /* [vertices - plain] */
  size_t vertex_room, triangle_room, face_room, made_room;
} sg_choice;

static inline int
sg_sense_of(const sg_source *from, uint32_t component)
{
  return from->sense[component];
}

static inline bool
sg_is_collapsed(const uint32_t v[3])
{
  return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
}

/* The vertex of the solid for vertex v, which is a leaf's own; SG_NO_KEY: no
 * memory. */
uint32_t sg_choice_plain_vertex(sg_choice *k, const sg_source *from,
                                uint32_t node, int32_t v);

/* Triangle `at` gets these corners, turned over if reversed. */
void sg_choice_set_triangle(sg_solid *out, size_t at, const uint32_t v[3],
                            uint8_t auxiliary, bool reversed);

/* All chosen polygons that are not cut, into an empty solid
 * (arrangement_uncut.c). False: no memory, or stopped. */
bool sg_choice_add_rows(sg_choice *k, sg_pool *pool, const sg_cancel *cancel);

#endif
