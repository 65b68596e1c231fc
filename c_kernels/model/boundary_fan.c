/* boundary_fan.c -- which faces belong together round edges and vertices of a
 * boundary_mesh, and copies of these (boundary_mesh.h).
 *
 * A corner is a directed edge of a face together with the vertex it starts
 * from. Edges are mates in pairs of opposite ones; corners at a vertex that
 * are connected by mates are a fan. Exchanging the mates of two pairs at an
 * edge parts a fan that has both pairs into two, so one can go on doing that
 * until no edge has two pairs between the same two fans.
 */
#include "boundary_private.h"

#include "engine/list.h"
#include "join/pages.h"
#include "number/exact.h"
#include "rows/disjoint.h"
#include "rows/edge_pairs.h"

#include <stdlib.h>
#include <string.h>

#define NO_MATE UINT32_MAX

/* Edges between the same two vertices, those one way and their mates. */
typedef struct crowd {
  uint32_t first, n; /* in the list of edges of the crowds */
} crowd;

typedef struct fans {
  sg_boundary_mesh *out;
  size_t corners;
  const int32_t *from; /* [corners] as the mesh has them */
  int32_t *to;         /* [corners] */
  uint32_t *next;      /* [corners] in the face */
  uint32_t *mate;      /* [corners] or NO_MATE */
  uint32_t *fan;       /* [corners] union-find */
  uint32_t *face;      /* [corners] */
  uint32_t *triangles; /* [faces + 1] where those of a face begin */
  crowd *crowd;
  size_t crowds, crowd_room;
  uint32_t *edge; /* of the crowds: edges from the lower vertex */
  size_t edges, edge_room;
  sg_page_at_edge *page;
  size_t page_room;
} fans;

/* ---- corners ---------------------------------------------------------------
 */

static void
link_corners(fans *x)
{
  const sg_mesh_lists *face = &x->out->mesh.face;

  for (size_t f = 0; f < face->count; f++) {
    uint32_t begin = face->start[f], end = face->start[f + 1];
    for (uint32_t i = begin; i < end; i++) {
      x->next[i] = i + 1 < end ? i + 1 : begin;
      x->to[i] = face->corner[x->next[i]];
      x->mate[i] = NO_MATE;
      x->face[i] = (uint32_t)f;
    }
  }
  for (size_t f = 0, t = 0; f <= face->count; f++) {
    while (t < x->out->triangles && (size_t)x->out->face_of[t] < f) {
      t++;
    }
    x->triangles[f] = (uint32_t)t;
  }
}

/* A point of the face beside its edge: of the triangle that has the edge, or
 * any other corner. */
static const double *
point_beside(const fans *x, uint32_t edge)
{
  uint32_t f = x->face[edge], other = x->next[x->next[edge]];

  for (uint32_t t = x->triangles[f]; t < x->triangles[f + 1]; t++) {
    const int32_t *v = x->out->triangle[t];
    for (int k = 0; k < 3; k++) {
      if (v[k] == x->from[edge] && v[(k + 1) % 3] == x->to[edge]) {
        return x->out->mesh.vertex[v[(k + 2) % 3]];
      }
    }
  }
  return x->out->mesh.vertex[x->from[other]];
}

/* ---- mates ------------------------------------------------------------------
 */

static void
make_mates(fans *x, uint32_t a, uint32_t b)
{
  x->mate[a] = b;
  x->mate[b] = a;
}

/* Pages in order: each forward one with the next, that bounds the same matter;
 * where sheets cross, in the order they come. */
static void
match_pages(fans *x, const sg_page_at_edge *page, size_t n, bool alternating)
{
  size_t b = 0;

  for (size_t f = 0; f < n; f++) {
    if (!page[f].forward) {
      continue;
    }
    if (alternating) {
      b = (f + 1) % n;
    } else {
      while (page[b].forward) {
        b++;
      }
    }
    make_mates(x, page[f].edge, page[b].edge);
    b++;
  }
}

static bool
keep_crowd(fans *x, const sg_page_at_edge *page, size_t n)
{
  if (!sg_list_grow(&x->crowd, x->crowds, &x->crowd_room, sizeof *x->crowd) ||
      !sg_list_need(&x->edge, x->edges + n, &x->edge_room, sizeof *x->edge)) {
    return false;
  }
  x->crowd[x->crowds++] = (crowd){(uint32_t)x->edges, (uint32_t)(n / 2)};
  for (size_t i = 0; i < n; i++) {
    if (page[i].forward) {
      x->edge[x->edges++] = page[i].edge;
    }
  }
  return true;
}

static bool
note_crossing(sg_boundary_mesh *out, const sg_edge_group *group)
{
  if (!out->crossed) {
    out->crossed = calloc(out->mesh.vertices + 1, 1);
  }
  if (out->crossed) {
    out->crossed[group->low] = out->crossed[group->high] = 1;
    out->crossing++;
  }
  return out->crossed != NULL;
}

/* A group of edges with as many one way as the other, four or more. */
static bool
add_crowd(fans *x, const sg_edge_pairs *pairs, const sg_edge_group *group)
{
  const double *u = x->out->mesh.vertex[group->low];
  const double *w = x->out->mesh.vertex[group->high];
  size_t n = group->end - group->begin;

  if (!sg_list_need(&x->page, n, &x->page_room, sizeof *x->page)) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    uint32_t edge = sg_edge_group_edge(pairs, group->begin + i);
    x->page[i].edge = edge;
    x->page[i].rank = edge;
    x->page[i].forward = (uint32_t)x->from[edge] == group->low;
    memcpy(x->page[i].beside, point_beside(x, edge), 3 * sizeof(double));
  }
  bool alternating = sg_pages_order(u, w, x->page, n);
  x->out->touching += alternating;
  if (!alternating && !note_crossing(x->out, group)) {
    return false;
  }
  match_pages(x, x->page, n, alternating);
  return keep_crowd(x, x->page, n);
}

static bool
add_group(fans *x, const sg_edge_pairs *pairs, const sg_edge_group *group)
{
  size_t n = group->end - group->begin, back = n - group->forward;

  if (group->forward != back) {
    x->out->open++;
    return true;
  }
  if (n == 2) {
    make_mates(x, sg_edge_group_edge(pairs, group->begin),
               sg_edge_group_edge(pairs, group->begin + 1));
    return true;
  }
  return add_crowd(x, pairs, group);
}

static sg_boundary_end
find_mates(fans *x, const sg_cancel *cancel)
{
  sg_edge_pairs pairs;
  sg_edge_group group = {0};
  bool stopped, done;

  done = sg_edge_pairs_make(x->corners, x->from, x->to, x->out->mesh.vertices,
                            cancel, &pairs, &stopped);
  while (done && sg_edge_group_next(&pairs, &group)) {
    done = add_group(x, &pairs, &group);
  }
  sg_edge_pairs_clear(&pairs);
  return done      ? SG_BOUNDARY_DONE
         : stopped ? SG_BOUNDARY_STOPPED
                   : SG_BOUNDARY_NO_MEMORY;
}

/* ---- fans
 * -------------------------------------------------------------------- */

/* A fan is named by its first corner. */
static void
find_fans(fans *x)
{
  for (uint32_t i = 0; i < x->corners; i++) {
    x->fan[i] = i;
  }
  for (uint32_t i = 0; i < x->corners; i++) {
    if (x->mate[i] != NO_MATE && x->mate[i] > i) {
      sg_disjoint_join(x->fan, i, x->next[x->mate[i]]);
      sg_disjoint_join(x->fan, x->next[i], x->mate[i]);
    }
  }
}

/* Two pairs, by their edges one way, between the same two fans. */
static bool
run_together(fans *x, uint32_t a, uint32_t b)
{
  return sg_disjoint_root(x->fan, a) == sg_disjoint_root(x->fan, b) &&
         sg_disjoint_root(x->fan, x->next[a]) ==
             sg_disjoint_root(x->fan, x->next[b]);
}

/* Exchanges mates of pairs that run together, of each fan once, since it is
 * another one then. True if there were any. */
static bool
part_fans(fans *x, unsigned char *parted)
{
  bool any = false;

  memset(parted, 0, x->corners);
  for (size_t c = 0; c < x->crowds; c++) {
    for (uint32_t i = 1; i < x->crowd[c].n; i++) {
      for (uint32_t k = 0; k < i; k++) {
        uint32_t a = x->edge[x->crowd[c].first + i];
        uint32_t b = x->edge[x->crowd[c].first + k];
        uint32_t start = sg_disjoint_root(x->fan, a),
                 end = sg_disjoint_root(x->fan, x->next[a]);
        if (run_together(x, a, b) && !parted[start] && !parted[end]) {
          uint32_t mate = x->mate[a];
          make_mates(x, a, x->mate[b]);
          make_mates(x, b, mate);
          parted[start] = parted[end] = 1;
          any = true;
        }
      }
    }
  }
  return any;
}

static bool
find_manifold_fans(fans *x)
{
  unsigned char *parted = malloc(x->corners + 1);

  if (!parted) {
    return false;
  }
  do {
    find_fans(x);
  } while (x->crowds > 0 && part_fans(x, parted));
  free(parted);
  return true;
}

/* ---- copies
 * -------------------------------------------------------------------- */

/* name[corner] of the first corner of each fan becomes its vertex; returns how
 * many there are. The fans of a vertex come together, by their first corners;
 * count[v] is where those of v begin. */
static size_t
number_fans(fans *x, uint32_t *count, int32_t *name)
{
  size_t vertices = x->out->mesh.vertices;

  for (uint32_t i = 0; i < x->corners; i++) {
    count[x->from[i] + 1] += x->fan[i] == i;
  }
  for (size_t v = 0; v < vertices; v++) {
    count[v + 1] += count[v];
  }
  for (uint32_t i = 0; i < x->corners; i++) {
    if (x->fan[i] == i) {
      name[i] = (int32_t)count[x->from[i]]++;
    }
  }
  return vertices ? count[vertices - 1] : 0;
}

/* The corners of triangles get the names that those of their faces have. */
static void
rename_triangles(fans *x, const int32_t *name)
{
  const sg_mesh_lists *face = &x->out->mesh.face;

  for (size_t t = 0; t < x->out->triangles; t++) {
    int32_t f = x->out->face_of[t];
    for (int k = 0; k < 3; k++) {
      uint32_t i = face->start[f];
      while (x->from[i] != x->out->triangle[t][k]) {
        i++;
      }
      x->out->triangle[t][k] = name[sg_disjoint_root(x->fan, i)];
    }
  }
}

/* Copies of vertices that are crossed are crossed. */
static bool
copy_crossed(fans *x, const int32_t *name, size_t n)
{
  unsigned char *old = x->out->crossed;

  if (!old) {
    return true;
  }
  unsigned char *crossed = calloc(n + 1, 1);
  for (uint32_t i = 0; crossed && i < x->corners; i++) {
    crossed[name[sg_disjoint_root(x->fan, i)]] = old[x->from[i]];
  }
  if (crossed) {
    free(old);
    x->out->crossed = crossed;
  }
  return crossed != NULL;
}

static bool
make_copies(fans *x)
{
  sg_mesh *mesh = &x->out->mesh;
  uint32_t *count = calloc(mesh->vertices + 2, sizeof *count);
  int32_t *name = malloc((x->corners + 1) * sizeof *name);
  size_t n = 0;
  double(*at)[3] = NULL;

  if (count && name) {
    n = number_fans(x, count, name);
    at = malloc((n + 1) * sizeof *at);
  }
  bool done = count && name && at;
  if (done && n > mesh->vertices && (done = copy_crossed(x, name, n))) {
    rename_triangles(x, name);
    for (uint32_t i = 0; i < x->corners; i++) {
      memcpy(at[name[sg_disjoint_root(x->fan, i)]], mesh->vertex[x->from[i]],
             sizeof *at);
    }
    for (uint32_t i = 0; i < x->corners; i++) {
      mesh->face.corner[i] = name[sg_disjoint_root(x->fan, i)];
    }
    x->out->copies = n - mesh->vertices;
    double(*old)[3] = mesh->vertex;
    mesh->vertex = at;
    mesh->vertices = mesh->vertex_room = n;
    at = old;
  }
  free(count);
  free(name);
  free(at);
  return done;
}

/* ---- together
 * -------------------------------------------------------------------- */

static bool
open_fans(fans *x)
{
  size_t n = x->corners + 1;

  x->to = malloc(n * sizeof *x->to);
  x->next = malloc(n * sizeof *x->next);
  x->mate = malloc(n * sizeof *x->mate);
  x->fan = malloc(n * sizeof *x->fan);
  x->face = malloc(n * sizeof *x->face);
  x->triangles = malloc((x->out->mesh.face.count + 1) * sizeof *x->triangles);
  return x->to && x->next && x->mate && x->fan && x->face && x->triangles;
}

static void
close_fans(fans *x)
{
  free(x->to);
  free(x->next);
  free(x->mate);
  free(x->fan);
  free(x->face);
  free(x->triangles);
  free(x->crowd);
  free(x->edge);
  free(x->page);
}

sg_boundary_end
sg_boundary_mesh_pair(sg_boundary_mesh *mesh, bool copies,
                      const sg_cancel *cancel)
{
  fans x = {.out = mesh,
            .corners = mesh->mesh.face.corners,
            .from = mesh->mesh.face.corner};
  sg_boundary_end end = SG_BOUNDARY_NO_MEMORY;

  if (x.corners == 0) {
    return SG_BOUNDARY_DONE;
  }
  if (open_fans(&x)) {
    link_corners(&x);
    end = find_mates(&x, cancel);
    if (end == SG_BOUNDARY_DONE && copies &&
        (!find_manifold_fans(&x) || !make_copies(&x))) {
      end = SG_BOUNDARY_NO_MEMORY;
    }
  }
  close_fans(&x);
  return end;
}
