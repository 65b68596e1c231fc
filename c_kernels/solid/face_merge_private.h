/* face_merge_private.h -- what the files of face_merge.h share.
 *
 * Layer: kernel. A half-edge is 3 t + k: that of triangle t from corner k to
 * the next. The way is: half-edges and their twins (face_merge_mesh.c), edges
 * without length (face_merge_contract.c), groups of faces (face_merge_grow.c),
 * which vertices vanish (face_merge_vertex.c, face_merge_run.c), new triangles
 * (face_merge_fill.c, face_merge_hold.c), what they meet (face_merge_meet.c,
 * face_merge_sheet.c, face_merge_fold.c), how far that moves things
 * (face_merge_tight.c, face_merge_near.c), the solid anew
 * (face_merge_write.c).
 */
#ifndef SG_FACE_MERGE_PRIVATE_H
#define SG_FACE_MERGE_PRIVATE_H

#include "face_merge.h"
#include "polygon/plane.h"

#define SG_NOTHING UINT32_MAX

/* A half-edge, in the list of those that leave its start. */
typedef struct sg_leaving {
  uint32_t to, half;
} sg_leaving;

/* What becomes of a vertex. */
enum {
  SG_KEPT,
  SG_INNER,    /* only triangles of one group round it */
  SG_STRAIGHT, /* two edges end there: perhaps it goes */
  SG_DROPPED,  /* such a one that goes */
  SG_ASKED     /* to be decided: some face round it may lose vertices */
};

/* How much of a group may change. */
typedef enum sg_group_state {
  SG_FREE,
  SG_BORDER_STAYS, /* its border keeps all vertices */
  SG_AS_IT_WAS
} sg_group_state;

/* Faces that become one, or one face that loses vertices. */
typedef struct sg_group {
  uint32_t first, n; /* in merge->member: its faces, ascending */
  uint32_t largest;  /* face */
  sg_solid_face name;
  sg_plane plane;
  sg_group_state state;
  bool thin;   /* some of its faces are not wider than the tolerance */
  bool losing; /* vertices: it wants new triangles */
  bool failed; /* it got none */
  uint32_t (*triangle)[3];
  uint8_t *auxiliary;
  size_t triangles;
} sg_group;

typedef struct sg_merge {
  const sg_solid *solid;
  const sg_merge_options *options;
  double tolerance;
  double rounding;     /* what places may be off by rounding alone */
  double others;       /* of a region: the tolerance that its others had */
  size_t ranges;       /* of vertices, each for a thread */
  uint32_t *face_of;   /* [triangles] */
  uint32_t *first;     /* [vertices + 2]: of a vertex in `leaving` */
  sg_leaving *leaving; /* [3 * triangles] */
  uint32_t *twin;      /* [3 * triangles]: SG_NOTHING where, except chords of
                          faces, there is not just one half-edge each way */
  bool regular;        /* all have twins */
  uint32_t (*weak)[2]; /* [weaks]: neighbours that might be one face */
  size_t weaks;
  uint32_t (*brief)[2]; /* [briefs]: edges no longer than the tolerance */
  size_t briefs;
  uint32_t *group_of; /* [faces]: or SG_NOTHING */
  uint32_t *member;   /* [members]: the faces of groups */
  size_t members, member_room;
  sg_group *group; /* [groups] */
  size_t groups, room;
  uint8_t *fate;           /* [vertices]: SG_KEPT ... */
  uint32_t (*adjacent)[2]; /* [vertices]: the neighbours of a straight one */
  sg_merge_tight rounded, tight; /* as sg_merge_counts has them */
} sg_merge;

static inline uint32_t
sg_half_start(const sg_merge *m, uint32_t half)
{
  return m->solid->triangle[half / 3][half % 3];
}

static inline uint32_t
sg_half_next(uint32_t half)
{
  return half % 3 == 2 ? half - 2 : half + 1;
}

static inline uint32_t
sg_half_end(const sg_merge *m, uint32_t half)
{
  return sg_half_start(m, sg_half_next(half));
}

/* A number for the group of the half-edge's face, or for the face itself. */
static inline uint32_t
sg_half_label(const sg_merge *m, uint32_t half)
{
  uint32_t face = m->face_of[half / 3], group = m->group_of[face];

  return group == SG_NOTHING || m->group[group].state == SG_AS_IT_WAS
             ? face
             : (uint32_t)m->solid->faces + group;
}

/* The half-edge is an edge of its group's polygon. */
static inline bool
sg_half_is_border(const sg_merge *m, uint32_t half)
{
  uint32_t twin = m->twin[half];

  return twin == SG_NOTHING || sg_half_label(m, twin) != sg_half_label(m, half);
}

static inline bool
sg_half_is_auxiliary(const sg_merge *m, uint32_t half)
{
  return (m->solid->auxiliary[half / 3] >> (half % 3)) & 1;
}

static inline const double *
sg_merge_at(const sg_merge *m, uint32_t vertex)
{
  return m->solid->vertex[vertex].at;
}

/* ---- face_merge_mesh.c ---- */

/* face_of, first, leaving, twin, weak and brief. */
sg_merge_end sg_merge_mesh(sg_merge *m);
/* Whether what made two faces lets them be one. */
bool sg_merge_may_join(const sg_merge *m, uint32_t f, uint32_t g);
void sg_merge_mesh_clear(sg_merge *m);

/* ---- face_merge_contract.c ---- */

/* What a solid was before vertices were put together. */
typedef struct sg_contracted {
  uint32_t (*triangle)[3];
  uint8_t *auxiliary;
  sg_solid_face *face;
  struct sg_solid_part *part;
  size_t triangles, faces, parts;
  uint32_t *up; /* [vertices]: which vertex stands for each */
} sg_contracted;

/* Puts the ends of brief edges together, and vertices made by cuts that are
 * within the tolerance of each other, with no wall between: of each the first
 * vertex stays. Not so where triangles would meet that did not before, or lie
 * back on each other.
 * Triangles, and faces, of which nothing is left go; every half-edge that is
 * left has the opposite that it had. *before is empty if nothing changed, else
 * what sg_merge_restore() needs. */
sg_merge_end sg_merge_contract(const sg_merge *m, sg_solid *solid,
                               sg_contracted *before);
/* Undoes it; or frees what it would need. */
void sg_merge_restore(sg_solid *solid, sg_contracted *before);
void sg_merge_forget(sg_contracted *before);

/* ---- face_merge_plane.c ---- */

typedef struct sg_face_size {
  double vector[3]; /* the area times the normal */
  double area, length;
  double centre[3]; /* the sum of all corners, for an order */
} sg_face_size;

void sg_merge_size(const sg_merge *m, uint32_t face, sg_face_size *out);
bool sg_merge_is_thin(const sg_merge *m, const sg_face_size *size);
/* All vertices of a face are within `most` of the plane. */
bool sg_merge_is_near(const sg_merge *m, const sg_plane *plane, uint32_t face,
                      double most);
/* A plane that all vertices of n faces are within the tolerance of; false: none
 * was found. Its normal looks as the faces do. */
bool sg_merge_fit(const sg_merge *m, const uint32_t *face, size_t n,
                  sg_plane *out);

/* ---- face_merge_grow.c ---- */

/* The groups of two faces and more. */
sg_merge_end sg_merge_grow(sg_merge *m);
/* A group of one face; null: no memory. */
sg_group *sg_merge_alone(sg_merge *m, uint32_t face);

/* ---- face_merge_vertex.c ---- */

/* fate of all vertices, and which groups lose some. */
sg_merge_end sg_merge_vertices(sg_merge *m);

/* ---- face_merge_run.c ---- */

/* SG_STRAIGHT becomes SG_DROPPED or SG_KEPT. */
sg_merge_end sg_merge_runs(sg_merge *m);

/* ---- face_merge_fill.c ---- */

/* New triangles for the groups that lose vertices or are thin in parts. What
 * cannot be is made to stay (state); *again: vertices are to be decided once
 * more. */
sg_merge_end sg_merge_fill(sg_merge *m, bool *again);

/* ---- face_merge_meet.c ---- */

/* Groups whose new triangles go through others, or lie on them, where the old
 * ones did not, have failed. */
sg_merge_end sg_merge_meet(sg_merge *m);

/* ---- face_merge_tight.c ---- */

/* The triangles and faces that half-edges are of. */
typedef struct sg_merge_faces {
  uint32_t (*triangle)[3];
  const sg_solid_face *face;
} sg_merge_faces;

/* Between v and w there is a wall: a segment has a face at each of them, not at
 * the other, and these look apart. Planes that cross at a small angle part v
 * and w by more than its thickness. What is no thicker than doubles are rounded
 * by is none: v and w are on the edge of a blade. */
bool sg_merge_wall(const sg_merge *m, uint32_t v, uint32_t w);
/* The normal of a triangle, of any length. False: it is no wider than the
 * tolerance, so it looks any way. */
bool sg_merge_normal(const sg_merge *m, const sg_merge_faces *of,
                     uint32_t triangle, double out[3]);
/* Whether they look opposite ways, to within 30 degrees: faces at a blunter
 * edge are no sides of a wall. */
bool sg_merge_look_apart(const double n[3], const double k[3]);
/* Whether a face ends at a vertex. */
bool sg_merge_has_face(const sg_merge *m, uint32_t v, uint32_t face);
/* After brief edges were contracted, while they are known. */
sg_merge_end sg_merge_note_contracted(sg_merge *m, const sg_contracted *was);
/* Before the solid is written anew. */
sg_merge_end sg_merge_note_dropped(sg_merge *m);

/* ---- face_merge_near.c ---- */

enum { SG_TIGHT = 100 }; /* a move of more than 1 / SG_TIGHT of something */

/* A vertex that moves, and what it moves beside: `move` towards or away from
 * something of size `feature` of segment s, a wall or an edge. */
typedef struct sg_moved {
  uint32_t v;
  int32_t s;
  bool wall;
  double way[3], least; /* no more than this is no move */
  double move, feature;
} sg_moved;

/* Of each of n vertices: the wall or slot beside which it moves most, if that
 * is more than `move` beside `feature`. */
sg_merge_end sg_merge_near_sides(const sg_merge *m, const sg_merge_faces *of,
                                 size_t triangles, sg_moved *moved, size_t n);

/* ---- face_merge_write.c ---- */

/* In place; without memory nothing is changed. */
sg_merge_end sg_merge_write(sg_merge *m, sg_solid *solid);

#endif
