/* solid_region_test.c -- the region of some leaves in the rows of a solid, and
 * what goes in where its faces were.
 *
 * The solid is a bar of six unit cubes along x, a face for each square; those
 * of cube i come from leaf i, 1 to 6. So leaves that are next to each other
 * have four vertices in common.
 */
#include "solid_world.h"
#include "tests/check.h"

/* ---- the bar ------------------------------------------------------------ */

static int32_t
leaf_of(const sg_solid *solid, const sg_solid_face *face)
{
  double x = 0; /* six times that of the middle of the face */

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int k = 0; k < 3; k++) {
      x += solid->vertex[solid->triangle[t][k]].at[0];
    }
  }
  return 1 + (int32_t)fmin(x / 6, LENGTH - 1);
}

static sg_solid
bar(void)
{
  cube_lump lump = {0};

  fill_box(&lump, 0, 0, 0, LENGTH, 1, 1);
  sg_solid solid = lump_solid(&lump, EACH_SQUARE);
  for (size_t f = 0; f < solid.faces; f++) {
    solid.face[f].s = leaf_of(&solid, &solid.face[f]);
  }
  return solid;
}

/* The faces from leaves first to last, on all vertices. */
static sg_solid
part_of(const sg_solid *solid, int32_t first, int32_t last)
{
  sg_solid part = {0};

  for (size_t v = 0; v < solid->vertices; v++) {
    const sg_solid_vertex *from = &solid->vertex[v];
    add_vertex(&part, from->at[0], from->at[1], from->at[2]);
    part.vertex[v] = *from;
  }
  for (size_t f = 0; f < solid->faces; f++) {
    const sg_solid_face *face = &solid->face[f];
    if (face->s >= first && face->s <= last) {
      add_face(&part, face->s, face->p);
      for (uint32_t t = face->first; t < face->first + face->n; t++) {
        const uint32_t *v = solid->triangle[t];
        add_triangle(&part, v[0], v[1], v[2]);
      }
    }
  }
  return part;
}

/* The vertex at a corner of a cube. */
static uint32_t
corner(const sg_solid *solid, double x, double y, double z)
{
  uint32_t v = 0;

  while (memcmp(solid->vertex[v].at, (double[3]){x, y, z}, sizeof(double[3]))) {
    v++;
  }
  return v;
}

/* Another vertex than it was, somewhere else. */
static void
move(sg_solid *solid, uint32_t v, double x, double y, double z)
{
  solid->vertex[v] = (sg_solid_vertex){{x, y, z}, 3, 1000 + (int32_t)v};
}

/* Those where cubes 3 and 4 meet, along x. */
static void
move_middle(sg_solid *solid, double x)
{
  for (size_t v = 0; v < solid->vertices; v++) {
    const double *at = solid->vertex[v].at;
    if (at[0] == 3) {
      move(solid, (uint32_t)v, x, at[1], at[2]);
    }
  }
}

/* A triangle of its own for each of a face's, round a new vertex. */
static void
divide(sg_solid *solid, size_t f)
{
  uint32_t v = add_vertex(solid, 2.5, 0.5 + (double)f, 9);
  uint32_t t = solid->face[f].first, old[3];

  memcpy(old, solid->triangle[t], sizeof old);
  solid->triangle[t][2] = v;
  for (int k = 1; k < 3; k++) {
    add_face(solid, 3, 100);
    add_triangle(solid, old[k], old[(k + 1) % 3], v);
  }
}

/* ---- what is read ------------------------------------------------------- */

static size_t
count_held(const sg_old_ids *ids)
{
  size_t n = 0;

  for (int32_t id = 1; id <= ids->most; id++) {
    n += sg_old_is_held(ids, id);
  }
  return n;
}

static bool
leaves_are(const sg_solid_old *old, const int32_t *leaf, size_t n)
{
  return old->region.leaves == n &&
         memcmp(old->region.leaf, leaf, n * sizeof *leaf) == 0;
}

static bool
box_is(const sg_solid_old *old, double x0, double x1)
{
  const sg_box *box = &old->region.box;

  return box->lo[0] == x0 && box->hi[0] == x1 && box->lo[1] == 0 &&
         box->hi[2] == 1 && old->region.whole.lo[0] == 0 &&
         old->region.whole.hi[0] == LENGTH;
}

static void
test_read(void)
{
  static world w;
  sg_solid solid = bar();
  sg_solid_old old;

  write_world(&solid, &w);
  CHECK("read", read_region(&w, (int32_t[]){3, 4}, 2, &old) == SG_OLD_READ &&
                    leaves_are(&old, (int32_t[]){3, 4}, 2));
  CHECK("its rows", sg_old_count(&old, SG_OLD_P) == 8 &&
                        sg_old_count(&old, SG_OLD_PLANE) == 8 &&
                        sg_old_count(&old, SG_OLD_FROM_P) == 8 &&
                        sg_old_count(&old, SG_OLD_T) == 16 &&
                        sg_old_count(&old, SG_OLD_E) == 32 &&
                        sg_old_count(&old, SG_OLD_V) == 12 &&
                        sg_old_count(&old, SG_OLD_FROM_V) == 12);
  CHECK("ids of the others are held", /* two of three sides, and 8 corners */
        count_held(&old.polygon) == 18 && count_held(&old.triangle) == 36 &&
            count_held(&old.edge) == 72 && count_held(&old.vertex) == 24);
  CHECK("the other vertices", old.region.rows == 16 && box_is(&old, 0, 6));
  sg_solid_old_clear(&old);
  CHECK("the end of the bar",
        read_region(&w, (int32_t[]){5, 6, 77}, 3, &old) == SG_OLD_READ &&
            leaves_are(&old, (int32_t[]){5, 6, 77}, 3) && box_is(&old, 0, 4));
  sg_solid_old_clear(&old);
  sg_solid_clear(&solid);
}

/* Faces of cubes 3 and 4, and 4 and 5, were merged: who asks for 3 gets all. */
static void
test_closure(void)
{
  static world w;
  sg_solid solid = bar();
  sg_solid_old old;

  solid.part = malloc(2 * sizeof *solid.part);
  for (uint32_t f = 0; f < solid.faces; f++) {
    int32_t s = solid.face[f].s;
    bool last = f + 1 == solid.faces || solid.face[f + 1].s != s;
    if (last && s == 5 && solid.parts < 2) {
      solid.part[solid.parts++] = (struct sg_solid_part){f, 4, 90, false};
    } else if (s == 3 && solid.parts == 0) {
      solid.part[solid.parts++] = (struct sg_solid_part){f, 4, 91, false};
    }
  }
  CHECK("two parts", solid.parts == 2);
  write_world(&solid, &w);
  CHECK("leaves of merged faces",
        read_region(&w, (int32_t[]){3}, 1, &old) == SG_OLD_READ &&
            leaves_are(&old, (int32_t[]){3, 4, 5}, 3) &&
            sg_old_count(&old, SG_OLD_P) == 12 &&
            sg_old_count(&old, SG_OLD_FROM_P) == 14);
  sg_solid_old_clear(&old);
  CHECK("others alone",
        read_region(&w, (int32_t[]){2}, 1, &old) == SG_OLD_READ &&
            leaves_are(&old, (int32_t[]){2}, 1));
  sg_solid_old_clear(&old);
  sg_solid_clear(&solid);
}

/* A row that all solids have is missing, of the region or beyond it. */
static void
test_missing(void)
{
  static const int relation[] = {SG_OLD_PLANE, SG_OLD_FROM_P, SG_OLD_FROM_V};
  static world w;
  sg_solid solid = bar();
  sg_solid_old old;

  for (size_t k = 0; k < sizeof relation / sizeof *relation; k++) {
    bool unfit = true;
    write_world(&solid, &w);
    size_t n = w.of[relation[k]].n;
    for (size_t i = 0; i < n; i++) {
      write_world(&solid, &w);
      drop_row(&w, relation[k], i);
      unfit = read_region(&w, (int32_t[]){3}, 1, &old) == SG_OLD_UNFIT && unfit;
      sg_solid_old_clear(&old);
    }
    CHECK("something is missing", unfit && n > 20);
  }
  sg_solid_clear(&solid);
}

/* ---- what goes in ------------------------------------------------------- */

/* New faces for the region of cubes 3 and 4. */
typedef struct change {
  world *w;
  sg_solid_old old;
  sg_solid_rows rows;
  sg_solid_over over;
  bool fits;
} change;

static void
open_change(change *c, world *w, const sg_solid *part)
{
  c->w = w;
  CHECK("opened",
        read_region(w, (int32_t[]){3, 4}, 2, &c->old) == SG_OLD_READ &&
            sg_solid_rows_make(part, NULL, NULL, &c->rows) &&
            sg_solid_over_match(&c->rows, &c->old, NULL, &c->over));
  c->fits = sg_solid_over_fits(&c->rows, &c->old, &c->over, NULL);
}

static void
close_change(change *c)
{
  sg_solid_over_clear(&c->over);
  sg_solid_rows_clear(&c->rows);
  sg_solid_old_clear(&c->old);
}

static size_t
count_gone(const change *c, int relation)
{
  size_t n = 0;

  for (size_t i = 0; i < sg_old_count(&c->old, relation); i++) {
    n += c->over.gone[relation][i];
  }
  return n;
}

/* Whether new faces for cubes 3 and 4 fit in the bar. */
static bool
fits(const sg_solid *solid, const sg_solid *part)
{
  static world w;
  change c;

  write_world(solid, &w);
  open_change(&c, &w, part);
  close_change(&c);
  return c.fits;
}

static void
test_same(void)
{
  static world w;
  sg_solid solid = bar(), part = part_of(&solid, 3, 4);
  change c;

  write_world(&solid, &w);
  open_change(&c, &w, &part);
  CHECK("the same faces fit, and stay",
        c.fits && c.over.faces_stay == 8 && count_gone(&c, SG_OLD_P) == 0 &&
            count_gone(&c, SG_OLD_V) == 0 && count_gone(&c, SG_OLD_T) == 0);
  close_change(&c);
  sg_solid_clear(&part);
  sg_solid_clear(&solid);
}

static void
test_bounds(void)
{
  sg_solid solid = bar(), part = part_of(&solid, 3, 4);

  move_middle(&part, 3.25);
  CHECK("other faces with the same bounds", fits(&solid, &part));
  move(&part, corner(&part, 2, 0, 0), 2.25, 0, 0);
  CHECK("a corner of the bounds is elsewhere", !fits(&solid, &part));
  sg_solid_clear(&part);
  part = part_of(&solid, 3, 4);
  part.vertex[corner(&part, 2, 0, 0)].v = 1000;
  CHECK("or is another vertex", !fits(&solid, &part));
  sg_solid_clear(&part);
  part = part_of(&solid, 3, 4);
  part.faces--;
  part.triangles -= 2;
  CHECK("a face is missing", !fits(&solid, &part));
  sg_solid_clear(&part);
  part = part_of(&solid, 3, 5);
  CHECK("faces of others", !fits(&solid, &part));
  sg_solid_clear(&part);
  sg_solid_clear(&solid);
}

/* A vertex inside the new faces is where one is that they know nothing of. */
static void
test_places(void)
{
  sg_solid solid = bar(), part = part_of(&solid, 3, 4);

  move_middle(&part, 3.25);
  uint32_t v = corner(&part, 3.25, 0, 0);
  move(&part, v, 6, 1, 1);
  CHECK("where another vertex is", !fits(&solid, &part));
  move(&part, v, -0.0, -0.0, 1);
  CHECK("with other signs of 0", !fits(&solid, &part));
  move(&part, v, 6, 1, 0.5);
  CHECK("beside it", fits(&solid, &part));
  move(&part, v, 2, 1, 1);
  CHECK("where one of the bounds is", !fits(&solid, &part));
  move(&part, v, 2, 1, 0.5);
  CHECK("beside that", fits(&solid, &part));
  move(&part, v, 3, 0, 0);
  CHECK("where one was that goes", fits(&solid, &part));
  sg_solid_clear(&part);
  sg_solid_clear(&solid);
}

/* ---- what stays --------------------------------------------------------- */

/* The place of the row of v for a vertex of the region. */
static uint32_t
place_at(const sg_solid_old *old, double x, double y, double z)
{
  uint32_t i = 0;

  while (sg_old_float(old, SG_OLD_V, 2, i) != x ||
         sg_old_float(old, SG_OLD_V, 3, i) != y ||
         sg_old_float(old, SG_OLD_V, 4, i) != z) {
    i++;
  }
  return i;
}

/* A triangle that comes from leaf 6 touches the bar in a vertex between cubes 3
 * and 4: the vertex, and its name, stay when the cubes have it no more. */
static void
test_touched(bool made)
{
  static const uint32_t origin[2] = {1, 7};
  static world w;
  sg_solid solid = bar();
  uint32_t touched = corner(&solid, 3, 1, 1);

  add_face(&solid, LENGTH, 99);
  add_triangle(&solid, touched, add_vertex(&solid, 3, 5, 5),
               add_vertex(&solid, 4, 5, 5));
  if (made) { /* it is the last, and comes from no leaf */
    solid.plain = touched;
    solid.origin = calloc(solid.vertices - touched, sizeof *solid.origin);
    for (size_t i = 0; i < solid.vertices - touched; i++) {
      solid.origin[i] = origin;
    }
  }
  sg_solid part = part_of(&solid, 3, 4);
  change c;

  move_middle(&part, 3.25);
  write_world(&solid, &w);
  open_change(&c, &w, &part);
  uint32_t i = place_at(&c.old, 3, 1, 1);
  CHECK("it fits", made || c.fits);
  CHECK("what others have stays", !c.over.gone[SG_OLD_V][i]);
  CHECK("and its name", made ? c.old.origin[i] != SG_NO_PLACE &&
                                   !c.over.gone[SG_OLD_ORIGIN][c.old.origin[i]]
                             : c.old.from[i] != SG_NO_PLACE &&
                                   !c.over.gone[SG_OLD_FROM_V][c.old.from[i]]);
  i = place_at(&c.old, 3, 0, 0);
  CHECK("what nobody has goes", c.over.gone[SG_OLD_V][i]);
  close_change(&c);
  sg_solid_clear(&part);
  sg_solid_clear(&solid);
}

/* ---- ids ---------------------------------------------------------------- */

/* The column that names rows. */
static int
id_column(int relation)
{
  return relation == SG_OLD_T ? 2 : 1;
}

/* What stays and what is new have different ids. */
static bool
ids_differ(change *c, int relation)
{
  static bool taken[4 * SG_PAGE_ROWS];
  table *t = &c->w->of[relation];
  const int32_t *id = ints(t, id_column(relation));
  const sg_over_rows *fresh = &c->over.fresh[relation];
  const int32_t *fresh_id = fresh->column[id_column(relation)];
  bool differ = fresh->n > 0;

  memset(taken, 0, sizeof taken);
  for (size_t i = 0; i < t->n; i++) {
    taken[id[i]] = true;
  }
  for (uint32_t i = 0; i < sg_old_count(&c->old, relation); i++) {
    if (c->over.gone[relation][i]) {
      taken[sg_old_int(&c->old, relation, (unsigned)id_column(relation), i)] =
          false;
    }
  }
  for (size_t i = 0; i < fresh->n; i++) {
    differ = differ && fresh_id[i] > 0 && !taken[fresh_id[i]];
    taken[fresh_id[i]] = true;
  }
  return differ;
}

/* More rows than there were. */
static void
test_ids(void)
{
  static const int relation[] = {SG_OLD_V, SG_OLD_E, SG_OLD_P, SG_OLD_T};
  static world w;
  sg_solid solid = bar(), part = part_of(&solid, 3, 4);
  change c;

  move_middle(&part, 3.25);
  for (size_t f = 0; f < 8; f++) {
    divide(&part, f);
  }
  write_world(&solid, &w);
  open_change(&c, &w, &part);
  CHECK("it fits", c.fits);
  CHECK("written",
        sg_solid_over_write(&c.rows, &c.old, S, NULL, NULL, &c.over));
  CHECK("new vertices", c.over.fresh[SG_OLD_V].n == 4 + 8);
  for (size_t k = 0; k < sizeof relation / sizeof *relation; k++) {
    CHECK("an id is of one row", ids_differ(&c, relation[k]));
  }
  close_change(&c);
  sg_solid_clear(&part);
  sg_solid_clear(&solid);
}

static bool
stop(void *asked)
{
  ++*(int *)asked;
  return true;
}

static void
test_stopped(void)
{
  static world w;
  sg_solid solid = bar();
  const sg_view *view[SG_OLD_RELATIONS];
  int asked = 0;
  sg_cancel cancel = {stop, &asked};
  sg_solid_old old;

  write_world(&solid, &w);
  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    view[k] = &w.of[k].view;
  }
  CHECK("stopped",
        sg_solid_old_read_region(view, S, (int32_t[]){3}, 1, item_vertex,
                                 &cancel, &old) == SG_OLD_FAILED &&
            asked > 0);
  sg_solid_old_clear(&old);
  sg_solid_clear(&solid);
}

int
main(void)
{
  test_read();
  test_closure();
  test_missing();
  test_same();
  test_bounds();
  test_places();
  test_touched(false);
  test_touched(true);
  test_ids();
  test_stopped();
  return check_report();
}
