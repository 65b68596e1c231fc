/* development_write_rows.c -- a development as rows. */
#include "development_rows.h"

#include "doors/pattern.h"
#include "rows/append_rows.h"

#include "engine/symbol.h"

/* ---- what is written ---------------------------------------------------- */

enum { V, E, P, PLANE, T, PIECE, JOINT, FROM_V, FROM_P, RELATIONS };

static const sg_relation written[RELATIONS] = {
    SG_V, SG_E, SG_P, SG_PLANE, SG_T, SG_PIECE, SG_JOINT, SG_FROM_V, SG_FROM_P};

typedef struct writer {
  const sg_development *d;
  const sg_layout *layout;
  int32_t to;     /* the pattern */
  uint32_t *side; /* [sides] in the order of their edges */
  uint32_t *bent; /* [faces of polygons that are not flat] */
} writer;

static int32_t
vertex_id(const writer *w, uint32_t corner)
{
  return (int32_t)w->layout->vertex[corner] + 1;
}

/* The symbol of the joint's kind. */
static int32_t
kind_of(const writer *w, size_t j)
{
  const sg_joint *joint = &w->d->joints.joint[j];
  const uint32_t *face_of = w->d->faces.face_of;

  if (joint->line) {
    return SG_SYMBOL_LINE;
  }
  if (!sg_joint_is_fold((sg_joint_state)w->d->flattening.state[j])) {
    return SG_SYMBOL_SEAM;
  }
  for (int k = 0; k < 2; k++) { /* of a polygon that is not flat */
    if (w->d->faces.side[joint->side[k]].edge >= w->d->dense.edges) {
      return SG_SYMBOL_FOLD;
    }
  }
  return w->d->faces.polygon[face_of[joint->side[0]]] ==
                 w->d->faces.polygon[face_of[joint->side[1]]]
             ? SG_SYMBOL_LINE
             : SG_SYMBOL_FOLD;
}

/* ---- rows --------------------------------------------------------------- */

typedef void write_row(const writer *w, size_t i, const sg_blank *c, size_t at);

static void
write_v(const writer *w, size_t i, const sg_blank *c, size_t at)
{
  c[1].i[at] = (int32_t)i + 1;
  c[2].f[at] = w->layout->at[i][0];
  c[3].f[at] = w->layout->at[i][1];
  c[4].f[at] = 0;
}

static void
write_e(const writer *w, size_t i, const sg_blank *c, size_t at)
{
  uint32_t side = w->side[i];
  const sg_flat_side *of = &w->d->faces.side[side];

  c[1].i[at] = sg_development_edge(w->d, side);
  c[2].i[at] = vertex_id(w, of->from);
  c[3].i[at] = vertex_id(w, of->to);
  c[4].i[at] = of->edge >= w->d->dense.edges ? 1 : w->d->dense.real[of->edge];
}

static void
write_p(const writer *w, size_t i, const sg_blank *c, size_t at)
{
  const sg_flat_faces *f = &w->d->faces;
  int32_t *list = c[2].list[at];

  c[1].i[at] = sg_development_polygon(w->d, (uint32_t)i);
  list[0] = (int32_t)(f->side_begin[i + 1] - f->side_begin[i]);
  for (uint32_t k = f->side_begin[i]; k < f->side_begin[i + 1]; k++) {
    list[1 + k - f->side_begin[i]] = sg_development_edge(w->d, k);
  }
}

static void
write_plane(const writer *w, size_t i, const sg_blank *c, size_t at)
{
  c[1].i[at] = sg_development_polygon(w->d, (uint32_t)i);
  c[2].f[at] = 0;
  c[3].f[at] = 0;
  c[4].f[at] = 1;
  c[5].f[at] = 0;
}

static void
write_t(const writer *w, size_t i, const sg_blank *c, size_t at)
{
  const sg_flat_faces *f = &w->d->faces;

  c[1].i[at] = sg_development_polygon(w->d, f->triangle_face[i]);
  c[2].i[at] = w->d->dense.triangle_id[f->triangle_place[i]];
  for (int k = 0; k < 3; k++) {
    c[3 + k].i[at] = vertex_id(w, f->triangle[i][k]);
  }
}

static void
write_piece(const writer *w, size_t i, const sg_blank *c, size_t at)
{
  c[1].i[at] = sg_development_polygon(w->d, (uint32_t)i);
  c[2].i[at] = (int32_t)w->layout->piece[i] + 1;
}

static void
write_joint(const writer *w, size_t i, const sg_blank *c, size_t at)
{
  const sg_joint *j = &w->d->joints.joint[i];

  c[1].i[at] = (int32_t)i + 1;
  c[2].i[at] = sg_development_edge(w->d, j->side[0]);
  c[3].i[at] = sg_development_edge(w->d, j->side[1]);
  c[4].i[at] = kind_of(w, i);
  c[5].f[at] = j->angle + 0.0;
}

static void
write_from_v(const writer *w, size_t i, const sg_blank *c, size_t at)
{
  const sg_flat_faces *f = &w->d->faces;

  c[1].i[at] = (int32_t)i + 1;
  c[2].i[at] = w->d->s;
  c[3].i[at] = w->d->dense.vertex_id[f->vertex[w->layout->first[i]]];
}

static void
write_from_p(const writer *w, size_t i, const sg_blank *c, size_t at)
{
  uint32_t face = w->bent[i];

  c[1].i[at] = sg_development_polygon(w->d, face);
  c[2].i[at] = w->d->s;
  c[3].i[at] = w->d->dense.polygon_id[w->d->faces.polygon[face]];
  c[4].i[at] = 1;
}

static write_row *const write_of[RELATIONS] = {
    write_v,     write_e,     write_p,      write_plane, write_t,
    write_piece, write_joint, write_from_v, write_from_p};

/* ---- writing ------------------------------------------------------------ */

static size_t
rows_of(const writer *w, int relation)
{
  const sg_flat_faces *f = &w->d->faces;
  const size_t n[RELATIONS] = {[V] = w->layout->vertices,
                               [E] = f->sides,
                               [P] = f->faces,
                               [PLANE] = f->faces,
                               [T] = f->triangles,
                               [PIECE] = f->faces,
                               [JOINT] = w->d->joints.n,
                               [FROM_V] = w->layout->vertices,
                               [FROM_P] = f->bent_faces};

  return n[relation];
}

/* Room for the lists of a page of p/3. */
static bool
make_lists(const writer *w, sg_append *a, size_t page)
{
  int32_t length[SG_PAGE_ROWS];
  const uint32_t *begin = w->d->faces.side_begin + a->sheet.page[page].from;

  for (size_t i = 0; i < a->sheet.page[page].n; i++) {
    length[i] = (int32_t)(begin[i + 1] - begin[i]);
  }
  return sg_append_lists(a, page, 2, length);
}

static bool
write_relation(sg_call *call, sg_world *world, const writer *w, int relation)
{
  sg_append a;
  bool good = true;

  if (!sg_append_open(&a, world, written[relation], rows_of(w, relation))) {
    return sg_call_no_memory(call);
  }
  for (size_t k = 0; good && k < a.sheet.pages; k++) {
    const sg_sheet_page *page = &a.sheet.page[k];
    good = relation != P || make_lists(w, &a, k) || sg_call_no_memory(call);
    for (size_t i = 0; good && i < page->n; i++) {
      page->column[0].i[i] = w->to;
      write_of[relation](w, page->from + i, page->column, i);
    }
    good = good && !sg_cancelled(&call->cancel);
  }
  good = good && (sg_append_commit(&a) || sg_call_no_memory(call));
  sg_append_close(&a);
  return good;
}

static bool
sort_sides(sg_call *call, writer *w)
{
  const sg_flat_faces *f = &w->d->faces;
  size_t edges = w->d->dense.edges + f->chords, n = 0, bents = 0;

  w->side = sg_call_alloc(call, f->sides * sizeof *w->side);
  w->bent = sg_call_alloc(call, f->bent_faces * sizeof *w->bent);
  if (!w->side || !w->bent) {
    return false;
  }
  for (size_t e = 0; e < edges; e++) {
    if (sg_cancel_every(&call->cancel, e)) {
      return false;
    }
    if (f->side_of[e] != SG_NO_SIDE_OF) {
      w->side[n++] = f->side_of[e];
    }
  }
  for (uint32_t face = 0; f->bents > 0 && face < f->faces; face++) {
    if (f->bent[f->polygon[face]]) {
      w->bent[bents++] = face;
    }
  }
  return true;
}

static bool
write_all(sg_call *call, sg_world *world, writer *w)
{
  if (!sg_segment_is_empty(call, world, w->to) || !sort_sides(call, w)) {
    return false;
  }
  for (int k = 0; k < RELATIONS; k++) {
    if (!write_relation(call, world, w, k)) {
      return false;
    }
  }
  return true;
}

bool
sg_door_flattening_write(sg_call *call, sg_development *d, int32_t to)
{
  sg_world *world;

  if (!sg_development_is_laid(call, d) || !(world = sg_call_claim(call))) {
    return false;
  }
  writer w = {.d = d, .layout = &d->layout, .to = to};
  bool good = write_all(call, world, &w);

  sg_world_release(world);
  return good;
}
