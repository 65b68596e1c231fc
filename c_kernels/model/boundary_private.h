/* boundary_private.h -- the steps of a boundary_mesh, in files of their own.
 *
 * Layer: kernel.
 */
#ifndef SG_BOUNDARY_PRIVATE_H
#define SG_BOUNDARY_PRIVATE_H

#include "boundary_mesh.h"
#include "polygon/loops.h"
#include "polygon/triangulate.h"

/* Vertex v is inside the edge between low and high; `at` is private. */
typedef struct sg_edge_split {
  int32_t low, high, v;
  double at;
} sg_edge_split;

typedef struct sg_edge_splits {
  sg_edge_split *item; /* [n]; free(item) */
  size_t n, room;
} sg_edge_splits;

/* A boundary_mesh under way. */
typedef struct sg_boundary_maker {
  sg_boundary *b;
  const sg_form *form;
  const sg_cancel *cancel;
  sg_boundary_mesh *out;
  sg_boundary_end end;    /* what went wrong */
  sg_mesh_lists loop;     /* the faces as they come */
  unsigned char *changed; /* [loop.count] */
  size_t changed_room;
  uint32_t *order;        /* [loop.count] */
  uint32_t *begin;        /* [vertices + 1] in order, by the first vertex */
  unsigned char *dropped; /* [loop.count] */
  int32_t *number;        /* [vertices] in the mesh, or -1 */
  int32_t *from, *to;     /* edges of the face at work */
  size_t room;
  uint32_t *seen; /* [vertices] a stamp */
  uint32_t stamp;
  sg_edge_splits splits; /* edges of faces with a vertex of the face inside */
  double reach;          /* the tolerance, or -1: not needed yet */
  sg_loops loops;
  sg_work *work;
  sg_triangles found;
} sg_boundary_maker;

/* False always: m->end says NO_MEMORY. */
bool sg_boundary_no_memory(sg_boundary_maker *m);
/* Room for n edges in m->from and m->to. */
bool sg_boundary_room(sg_boundary_maker *m, size_t n);

/* Gives the triangles of the n edges at work, in loop order if `ring`, to
 * `take`: of a face of m->b, or (reader) as a reader will divide one of
 * m->out->mesh. A face that none are found for is counted. False: `take` said
 * so, or m->end says why. */
typedef bool sg_boundary_take(sg_boundary_maker *m, const int32_t v[3]);
bool sg_boundary_each_triangle(sg_boundary_maker *m, bool reader, size_t n,
                               bool ring, sg_boundary_take *take);

/* Notes that v is inside the edge from -> to. False: no memory. */
bool sg_boundary_note_split(sg_edge_splits *splits, int32_t from, int32_t to,
                            int32_t v);
/* Divides all edges between these vertices, in every face: as many one way as
 * the other. Sorts the splits. False: no memory. */
bool sg_boundary_split(sg_boundary *boundary, sg_edge_splits *splits);

/* Fills m->loop with the faces of m->b. */
bool sg_boundary_add_faces(sg_boundary_maker *m);

/* Counts open, touching and crossing edges of a mesh whose faces and triangles
 * are there; makes copies if asked to. */
sg_boundary_end sg_boundary_mesh_pair(sg_boundary_mesh *mesh, bool copies,
                                      const sg_cancel *cancel);

#endif
