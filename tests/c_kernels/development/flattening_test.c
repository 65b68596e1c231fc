/* flattening_test.c -- faces, joints, islands and where they lie in the end, of
 * small solids.
 *
 * covers: double_double, disjoint, flat_face, island_overlap, joint
 */
#include "flat_model.h"
#include "laid_valid.h"

#include "development/seam_moats.h"

static const double origin[3] = {0, 0, 0}, unit[3] = {1, 1, 1},
                    two[3] = {2, 2, 1};

static void
check_cube(void)
{
  model *m = new_model();
  unfolded u;

  add_box(m, origin, unit);
  unfold(m, SG_ORDER_LONGEST, &u);
  sg_measures of = measured(&u);
  sg_seam_bound least = bound(&u);
  CHECK("a cube has six faces and twelve joints",
        u.faces.faces == 6 && u.joints.n == 12);
  CHECK("its joints are convex and square", near(u.joints.joint[5].angle, 90));
  CHECK("it is one piece", u.layout.pieces == 1);
  CHECK("its seam is seven edges, which is the least",
        near(of.seam, 7) && near(least.bound, 7) && least.by == SG_BOUND_TREE);
  CHECK("a net has fourteen vertices", u.layout.vertices == 14);
  CHECK("nothing overlaps", overlaps(&u) == 0);
  sg_bent_vertices corners = {8, NULL, (bool[8]){false}};
  corners.bent = (double[8]){0};
  for (int k = 0; k < 8; k++) {
    corners.bent[k] = acos(0.0);
  }
  double width;
  bool stopped;
  CHECK("moats round its corners meet when they are half an edge wide",
        sg_moats_grow(&corners, &u.joints, true, NULL, &width, &stopped) &&
            near(width, 4));
  corners.bent[0] = 0;
  corners.bent[1] *= 2;
  CHECK("one that is flat needs none",
        sg_moats_grow(&corners, &u.joints, true, NULL, &width, &stopped) &&
            near(width, 3.5));
  CHECK("sides are as long as edges", stretch(m, &u) < 1e-14);
  forget(&u);
  free(m);
}

/* A pyramid on a square base with a vertex in the middle of it, and one in the
 * middle of a side: these two are flat, and no seam has to reach them. */
static void
check_flat_vertices(void)
{
  model *m = new_model();
  unfolded u;
  const double slope = sqrt(1.5);

  for (int k = 0; k < 4; k++) {
    add_vertex(m, k == 1 || k == 2, k > 1, 0);
  }
  int32_t top = add_vertex(m, 0.5, 0.5, 1), middle = add_vertex(m, .5, .5, 0);
  for (int k = 0; k < 4; k++) {
    int32_t a = k, b = (k + 1) % 4;
    add_polygon(m, 3, (int32_t[3]){a, b, top});
    add_polygon(m, 3, (int32_t[3]){b, a, middle});
  }
  unfold(m, SG_ORDER_LONGEST, &u);
  sg_measures of = measured(&u);
  sg_seam_bound least = bound(&u);
  CHECK("the tree goes to what is flat, too",
        near(least.tree, 4 * sqrt(.5) + slope));
  CHECK("which no seam has to",
        near(of.seam, 3 + slope) || near(of.seam, 4 * slope));
  CHECK("moats prove half of it", least.by == SG_BOUND_MOATS &&
                                      least.bound >= 0.5 * of.seam &&
                                      least.bound <= of.seam);
  forget(&u);
  free(m);
}

/* Two boxes that have an edge in common: each face goes on to one of its own
 * box. */
static void
check_touching(void)
{
  model *m = new_model();
  unfolded u;
  size_t apart = 0;

  add_box(m, origin, unit);
  add_box(m, unit, two);
  m->at[8][2] = m->at[9][2] = m->at[10][2] = m->at[11][2] = 0;
  /* vertices 3 and 7 are 8 and 12: one edge for both */
  for (size_t e = 0; e < m->dense.edges; e++) {
    int32_t *end[2] = {&m->from[e], &m->to[e]};
    for (int k = 0; k < 2; k++) {
      *end[k] = *end[k] == 8 ? 3 : *end[k] == 12 ? 7 : *end[k];
    }
  }
  for (size_t t = 0; t < m->dense.triangles; t++) {
    for (int k = 0; k < 3; k++) {
      int32_t *v = &m->corner[t][k];
      *v = *v == 8 ? 3 : *v == 12 ? 7 : *v;
    }
  }
  unfold(m, SG_ORDER_LONGEST, &u);
  for (size_t j = 0; j < u.joints.n; j++) {
    const sg_joint *of = &u.joints.joint[j];
    apart +=
        u.faces.face_of[of->side[0]] / 6 != u.faces.face_of[of->side[1]] / 6;
  }
  CHECK("every side has a partner", u.joints.n == 24);
  CHECK("boxes that touch in an edge stay apart", apart == 0);
  CHECK("they are two pieces", u.layout.pieces == 2);
  CHECK("nothing overlaps", overlaps(&u) == 0);
  forget(&u);
  free(m);
}

/* Boxes of any size, each a piece, and a square that is larger than most of
 * their faces, but not than all of one. */
static void
check_pieces(uint32_t seed)
{
  model *m = new_model();
  unfolded u;

  for (int k = 0; k < 7; k++) {
    double low[3] = {4.0 * k, 0, 0}, high[3] = {4.0 * k, 0, 0};
    for (int c = 0; c < 3; c++) {
      high[c] += (1 + check_below(&seed, 24)) / 8.0;
    }
    add_box(m, low, high);
  }
  add_vertex(m, -9, 0, 0);
  add_vertex(m, -7, 0, 0);
  add_vertex(m, -7, 2, 0);
  add_vertex(m, -9, 2, 0);
  int32_t last = (int32_t)m->dense.vertices;
  add_polygon(m, 4, (int32_t[4]){last - 4, last - 3, last - 2, last - 1});
  unfold(m, SG_ORDER_LONGEST, &u);
  CHECK("each is a piece", u.layout.pieces == 8);
  check_laid(&u);
  forget(&u);
  free(m);
}

/* The piece of a face that is asked for is the first, its longest side goes up
 * from the origin; the others stand beside it. */
static void
check_root(uint32_t face)
{
  model *m = new_model();
  unfolded u;
  bool stopped;

  add_box(m, origin, two);
  add_box(m, (double[3]){5, 0, 0}, (double[3]){6, 1, 3});
  unfold(m, SG_ORDER_LONGEST, &u);
  sg_layout_clear(&u.layout);
  const sg_lay_input in = {&u.flattening, 1e-9, face};
  CHECK("laid out", sg_lay(&in, NULL, &u.layout, &stopped));
  CHECK("its piece is the first", u.layout.pieces == 2 &&
                                      u.layout.root[0] == face &&
                                      u.layout.piece[face] == 0);
  const sg_flat_side *side = &u.faces.side[u.faces.longest[face]];
  const double *from = u.layout.at[u.layout.vertex[side->from]];
  const double *to = u.layout.at[u.layout.vertex[side->to]];
  CHECK("its longest side goes up from the origin",
        from[0] == 0 && from[1] == 0 && near(to[0], 0) &&
            near(to[1], face < 6   ? 2
                        : face < 8 ? 1
                                   : 3));
  CHECK("the other one stands beside it, or above",
        near(u.layout.box[1].low[1], u.layout.box[0].low[1])
            ? u.layout.box[1].low[0] > u.layout.box[0].high[0]
            : u.layout.box[1].low[1] > u.layout.box[0].high[1]);
  CHECK("nothing overlaps", overlaps(&u) == 0);
  forget(&u);
  free(m);
}

static void
check_torus(unsigned order)
{
  model *m = new_model();
  unfolded u;

  add_torus(m, 18, 0.4);
  unfold(m, order, &u);
  CHECK("nothing of a torus overlaps", overlaps(&u) == 0);
  check_laid(&u);
  CHECK("its sides are as long as edges", stretch(m, &u) < 1e-13);
  CHECK("joints were refused", u.flattening.refused > 0);
  sg_measures of = measured(&u);
  sg_seam_bound least = bound(&u);
  CHECK("a bound is proven, but not the tree",
        least.by != SG_BOUND_TREE && least.bound > 0.4 * least.tree);
  CHECK("no seam is less", of.seam >= least.bound);
  forget(&u);
  free(m);
}

/* A saddle of eight triangles round a vertex, whose angles sum to more than a
 * whole turn by about 19.3 times the square of its height. */
static void
check_saddle(double height, size_t pieces)
{
  model *m = new_model();
  unfolded u;
  int32_t rim[8];

  add_vertex(m, 0, 0, 0);
  for (int i = 0; i < 8; i++) {
    double at = acos(-1.0) / 4 * i;
    rim[i] = add_vertex(m, cos(at), sin(at), i % 2 ? height : -height);
  }
  for (int i = 0; i < 8; i++) {
    add_polygon(m, 3, (int32_t[3]){0, rim[i], rim[(i + 1) % 8]});
  }
  unfold(m, SG_ORDER_LONGEST, &u);
  CHECK("what overlaps by more than a thousand-millionth comes off",
        u.layout.pieces == pieces);
  forget(&u);
  free(m);
}

/* Two triangles at an edge: is the joint between them flat? */
static bool
is_flat_joint(const double third[3])
{
  model *m = new_model();
  unfolded u;

  add_vertex(m, 0, 0, 0);
  add_vertex(m, 1, 0, 0);
  add_vertex(m, 0.5, 1, 0);
  add_vertex(m, third[0], third[1], third[2]);
  add_polygon(m, 3, (int32_t[3]){0, 1, 2});
  add_polygon(m, 3, (int32_t[3]){1, 0, 3});
  unfold(m, SG_ORDER_LONGEST, &u);
  bool flat = u.joints.n == 1 && u.joints.joint[0].flat;
  forget(&u);
  free(m);
  return flat;
}

static void
check_flat(void)
{
  CHECK("beside it", is_flat_joint((double[3]){0.5, -1, 0}));
  CHECK("not in its plane", !is_flat_joint((double[3]){0.5, -1, 1e-8}));
  CHECK("folded back onto it", !is_flat_joint((double[3]){0.5, 0.9, 0}));
  CHECK("a sliver, whatever its own plane",
        is_flat_joint((double[3]){0.5, -1e-7, 5e-10}));
}

/* Two leaves, each of two triangles that lie on each other, at one edge: each
 * is paired with itself. */
static void
check_leaves(void)
{
  model *m = new_model();
  unfolded u;
  size_t apart = 0;

  add_vertex(m, 0, 0, 0);
  add_vertex(m, 0, 0, 1);
  add_vertex(m, 1, 0, 0.5);
  add_vertex(m, -1, 0, 0.5);
  for (int32_t third = 2; third < 4; third++) {
    add_polygon(m, 3, (int32_t[3]){0, 1, third});
    add_polygon(m, 3, (int32_t[3]){1, 0, third});
  }
  unfold(m, SG_ORDER_LONGEST, &u);
  for (size_t j = 0; j < u.joints.n; j++) {
    const uint32_t *face = u.joints.joint[j].face;
    apart += face[0] / 2 != face[1] / 2;
  }
  CHECK("leaves are paired with themselves", u.joints.n == 6 && apart == 0);
  forget(&u);
  free(m);
}

/* How many sides have a number that no other has. */
static size_t
own_sides(const sg_flat_faces *f)
{
  size_t own = 0;

  for (uint32_t k = 0; k < f->sides; k++) {
    own += f->side_of[f->side[k].edge] == k;
  }
  return own;
}

/* A square that is folded along its diagonal: not flat, in two triangles. */
static void
check_bent(void)
{
  model *m = new_model();
  unfolded u;

  add_vertex(m, 0, 0, 0);
  add_vertex(m, 1, 0, 0);
  add_vertex(m, 1, 1, 0.5);
  add_vertex(m, 0, 1, 0);
  add_polygon(m, 4, (int32_t[4]){0, 1, 2, 3});
  unfold(m, SG_ORDER_LONGEST, &u);
  CHECK("a polygon that is not flat is its triangles",
        u.faces.bents == 1 && u.faces.faces == 2 && u.faces.chords == 2);
  CHECK("which are connected", u.layout.pieces == 1 && u.joints.n == 1);
  forget(&u);
  memcpy(m->corner[1], m->corner[0], sizeof m->corner[1]);
  unfold(m, SG_ORDER_LONGEST, &u);
  CHECK("two triangles along the same edges have sides of their own",
        u.faces.sides == 6 && u.faces.chords == 4 && own_sides(&u.faces) == 6);
  forget(&u);
  free(m);
}

/* A sliver without area between two halves of a square. */
static void
check_no_area(void)
{
  model *m = new_model();
  unfolded u;

  add_vertex(m, 0, 0, 0);
  add_vertex(m, 1, 0, 0);
  add_vertex(m, 1, 1, 0);
  add_vertex(m, 0, 1, 0);
  add_vertex(m, 0.5, 0.5, 0);
  add_polygon(m, 3, (int32_t[3]){0, 1, 2});
  add_polygon(m, 3, (int32_t[3]){0, 2, 4});
  add_polygon(m, 3, (int32_t[3]){0, 4, 3});
  add_polygon(m, 3, (int32_t[3]){4, 2, 3});
  unfold(m, SG_ORDER_LONGEST, &u);
  CHECK("a face without area is no gap",
        u.layout.pieces == 1 && near(measured(&u).seam, 0));
  CHECK("nothing overlaps it", overlaps(&u) == 0);
  CHECK("nothing is stretched", stretch(m, &u) < 1e-15);
  forget(&u);
  free(m);
}

/* An edge without length holds nothing, and stops nothing. */
static void
check_no_length(void)
{
  model *m = new_model();
  unfolded u;

  add_vertex(m, 0, 0, 0);
  add_vertex(m, 1, 0, 0);
  add_vertex(m, 1, 1, 0);
  add_vertex(m, 1, 1, 0);
  add_vertex(m, 2, 2, 1);
  add_vertex(m, 3, 1, 1);
  add_polygon(m, 4, (int32_t[4]){0, 1, 2, 3});
  add_polygon(m, 4, (int32_t[4]){3, 2, 5, 4});
  unfold(m, SG_ORDER_LONGEST, &u);
  CHECK("faces are not joined at a point",
        u.layout.pieces == 2 && u.flattening.state[0] == SG_JOINT_SHORT);
  CHECK("what is laid has places",
        isfinite(u.layout.at[0][0]) && isfinite(u.layout.at[0][1]));
  forget(&u);
  free(m);
}

/* Two faces on either side of an edge of some length, the second one bent up by
 * some height: the state of their joint. */
static sg_joint_state
hung_on(double length, double height)
{
  model *m = new_model();
  unfolded u;
  sg_joint_state state;

  add_vertex(m, 0, 0, 0);
  add_vertex(m, 1, -1, 0);
  add_vertex(m, 1, 1, 0);
  add_vertex(m, 0, length, 0);
  add_vertex(m, -1, 0, height);
  add_polygon(m, 4, (int32_t[4]){0, 1, 2, 3});
  add_polygon(m, 3, (int32_t[3]){0, 3, 4});
  unfold(m, SG_ORDER_LONGEST, &u);
  state = (sg_joint_state)u.flattening.state[0];
  forget(&u);
  free(m);
  return state;
}

/* A fold holds what is up to 2048 times as long. */
static void
check_short(void)
{
  CHECK("what is not too long hangs",
        hung_on(1.0 / 2000, 0) == SG_JOINT_JOINED);
  CHECK("nor bent", hung_on(1.0 / 1000, 1) == SG_JOINT_JOINED);
  CHECK("what is too long falls off", hung_on(1.0 / 2100, 1) == SG_JOINT_SHORT);
  CHECK("what is flat stays", hung_on(1.0 / 4000, 0) == SG_JOINT_JOINED);
}

/* Two triangles on each side of an edge, of which two list the same edge. */
static void
check_edge_in_two_faces(void)
{
  model *m = new_model();
  unfolded u = {.layout = {0}};
  bool stopped;

  for (int k = 0; k < 6; k++) {
    add_vertex(m, k == 1, k == 2 || k == 3, k > 3 ? k - 4.5 : 0);
  }
  for (int k = 0; k < 4; k++) {
    add_polygon(m, 3, (int32_t[3]){k % 2, !(k % 2), k + 2});
  }
  m->list[2 * 3] = m->list[0];
  CHECK("faces",
        sg_flat_faces_make(&m->dense, NULL, 1e-9, NULL, &u.faces, &stopped));
  CHECK("joints",
        sg_joints_make(&u.faces, &m->dense, 1e-9, NULL, &u.joints, &stopped));
  CHECK("each side has a number of its own", own_sides(&u.faces) == 12);
  CHECK("the second side along an edge is a chord",
        u.faces.chords == 1 && u.faces.side[6].edge == m->dense.edges);
  CHECK("both pairs are joints", u.joints.n == 2);
  forget(&u);
  free(m);
}

static bool
stop(void *data)
{
  return --*(int *)data < 0;
}

/* Everything that an unfolding takes, until it is stopped. */
static bool
unfold_until(const model *m, unfolded *u, const sg_cancel *cancel,
             bool *stopped)
{
  sg_measures of;
  bool good =
      sg_flat_faces_make(&m->dense, NULL, 1e-9, cancel, &u->faces, stopped) &&
      sg_joints_make(&u->faces, &m->dense, 1e-9, cancel, &u->joints, stopped) &&
      sg_flattening_make(&m->dense, &u->faces, &u->joints, cancel,
                         &u->flattening, stopped);
  uint32_t *js =
      good ? sg_joint_order(&u->flattening, SG_ORDER_LONGEST, cancel, stopped)
           : NULL;

  good = js && sg_flattening_join_all(&u->flattening, js, u->joints.n, cancel,
                                      stopped);
  free(js);
  const sg_lay_input in = {&u->flattening, 1e-9, SG_NO_FACE};

  return good && sg_lay(&in, cancel, &u->layout, stopped) &&
         sg_measure(&u->flattening, &u->layout, cancel, &of, stopped);
}

/* Stopped at any cancel it ends, and says so; a new start is a new start. */
static void
check_stopping(void)
{
  model *m = new_model();
  unsigned wrong = 0, times = 0;
  bool done = false;

  add_torus(m, 18, 0.4);
  for (int k = 0; !done && k < 10000; k++) {
    unfolded u = {.layout = {0}};
    int asks = k;
    const sg_cancel cancel = {stop, &asks};
    bool stopped = false;

    done = unfold_until(m, &u, &cancel, &stopped);
    wrong += done == stopped;
    times += stopped;
    forget(&u);
  }
  CHECK("it is stopped in many places", times > 20);
  CHECK("each time it says so, and in the end it is done", wrong == 0 && done);
  free(m);
}

/* A strip up and down, joined from both ends: the last joint moves
 * half of it, and is stopped there. */
static void
check_stopped_merge(void)
{
  enum { SQUARES = 12000 };
  model *m = new_model();
  unfolded u = {.layout = {0}};
  int asks = 0;
  const sg_cancel cancel = {stop, &asks};
  sg_joint_state state;
  bool stopped = false, apart = true;
  static int32_t v[2 * SQUARES + 2];

  _Static_assert(4 * SQUARES < ROOM, "a model has room");
  for (int i = 0; i <= SQUARES; i++) {
    v[2 * i] = add_vertex(m, i, 0, i % 2);
    v[2 * i + 1] = add_vertex(m, i, 8, i % 2);
  }
  for (int i = 0; i < SQUARES; i++) {
    add_polygon(
        m, 4, (int32_t[4]){v[2 * i], v[2 * i + 2], v[2 * i + 3], v[2 * i + 1]});
  }
  CHECK("faces",
        sg_flat_faces_make(&m->dense, NULL, 1e-9, NULL, &u.faces, &stopped));
  CHECK("joints",
        sg_joints_make(&u.faces, &m->dense, 1e-9, NULL, &u.joints, &stopped));
  CHECK("islands", sg_flattening_make(&m->dense, &u.faces, &u.joints, NULL,
                                      &u.flattening, &stopped));
  for (uint32_t j = 0; j < u.joints.n; j++) {
    CHECK("joined",
          j == SQUARES / 2 ||
              sg_flattening_join(&u.flattening, j, NULL, &state, &stopped));
  }
  u.flattening.moves = 0;
  u.flattening.state[1] = SG_JOINT_FORBIDDEN;
  CHECK("the last one is stopped",
        !sg_flattening_join(&u.flattening, SQUARES / 2, &cancel, &state,
                            &stopped) &&
            stopped);
  for (uint32_t face = 0; face < u.faces.faces; face++) {
    apart = apart && u.flattening.island_of[face] == face;
  }
  CHECK("then every face is an island again",
        apart && u.flattening.state[0] == SG_JOINT_OPEN);
  CHECK("and what is forbidden stays so",
        u.flattening.state[1] == SG_JOINT_FORBIDDEN);
  forget(&u);
  free(m);
}

int
main(void)
{
  check_cube();
  check_flat_vertices();
  check_touching();
  for (uint32_t seed = 0; seed < 40; seed++) {
    check_pieces(seed);
  }
  for (uint32_t face = 0; face < 12; face++) {
    check_root(face);
  }
  for (unsigned order = 0; order < 5; order++) {
    check_torus(order);
  }
  check_saddle(7e-5, 2);
  check_saddle(7e-6, 1);
  check_flat();
  check_leaves();
  check_bent();
  check_no_area();
  check_no_length();
  check_short();
  check_edge_in_two_faces();
  check_stopping();
  check_stopped_merge();
  return check_report();
}
