/* boundary_mesh.h -- a boundary as a mesh in an order of its own, and what is
 * wrong with it.
 *
 * Layer: kernel. The mesh depends on where things are alone: vertices ascend by
 * x, y, z, each face begins with its lowest vertex, and faces ascend by their
 * vertices.
 *
 * Where bodies touch in a point or an edge, formats with numbered vertices get
 * copies: one of a vertex for each fan of faces round it. Of four or more faces
 * at an edge those go together that have matter between them, so that the
 * copies bound the parts of the solid; but where such a part would use both
 * copies of an edge with the same two vertices, those that have none between
 * them. After that every edge has two faces.
 */
#ifndef SG_BOUNDARY_MESH_H
#define SG_BOUNDARY_MESH_H

#include "boundary.h"
#include "join/self_cut.h"
#include "mesh.h"
#include "thread_pool.h"

typedef struct sg_form {
  bool triangles; /* no face has more than three corners */
  bool flat;      /* those that have are flat to the last digit */
  bool copies;    /* see above; else such vertices stay one */
} sg_form;

/* One segment of a mesh, as it will be written. */
typedef struct sg_boundary_mesh {
  sg_mesh mesh;           /* of one unnamed segment; owned */
  int32_t (*triangle)[3]; /* [triangles] of its faces, in their order */
  int32_t *face_of;       /* [triangles] */
  unsigned char *changed; /* [triangles] as in a boundary */
  size_t triangles;
  size_t open;     /* edges with more faces on one side than on the other */
  size_t crossing; /* edges with four or more faces where sheets cross, as the
                      order round the edge tells. Exact */
  unsigned char *crossed; /* [mesh.vertices] an end of such an edge; null: there
                             is none */
  size_t touching;        /* the others with four or more */
  size_t copies;          /* vertices added */
  size_t stuck;           /* faces that no triangles were found for */
  size_t cancelled; /* faces that lay on each other, back to back, and went */
} sg_boundary_mesh;

/* A face that is one loop, passing each of its vertices once, stays a polygon
 * unless form says otherwise; others become triangles, chosen by geometry
 * alone. Faces on each other, back to back, cancel. Where a vertex of a face
 * that is divided lies on one of its edges, this edge is divided in all its
 * faces. Clears the boundary. Returns: DONE, NO_MEMORY or STOPPED. Owner:
 * sg_boundary_mesh_clear() in any case. */
sg_boundary_end sg_boundary_mesh_make(sg_boundary *boundary,
                                      const sg_form *form,
                                      const sg_cancel *cancel,
                                      sg_boundary_mesh *out);
/* The triangles of a mesh without copies as a boundary again, if some of them
 * have no area that doubles can tell (else *any is false, and *out empty): for
 * sg_boundary_drop_flat(). False: no memory. Owner: sg_boundary_clear(). */
bool sg_boundary_of_mesh(const sg_boundary_mesh *mesh, sg_boundary *out,
                         bool *any);
void sg_boundary_mesh_clear(sg_boundary_mesh *mesh);

/* Where it goes through itself: meetings of its triangles with those that are
 * changed, or of all, exactly. False: no memory, or stopped. See self_cut.h. */
bool sg_boundary_mesh_meetings(const sg_boundary_mesh *mesh, bool all,
                               sg_pool *pool, const sg_cancel *cancel,
                               sg_self_meetings *out);

/* The mesh with the vertices of those triangles that go through each other, by
 * any distance, on the grid of `rounding`, and those no farther from them than
 * a cell of it; then in the same form. */
sg_boundary_end sg_boundary_mesh_coarsen(const sg_boundary_mesh *mesh,
                                         const sg_rounding *rounding,
                                         const sg_form *form, sg_pool *pool,
                                         const sg_cancel *cancel,
                                         sg_boundary_mesh *out);

#endif
